// SPDX-License-Identifier: Apache-2.0
#include "svg.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <stdexcept>

namespace bench {
namespace {

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", value);
  return text.data();
}

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}
std::string attribute(std::string_view name, double value) { return attribute(name, number(value)); }

std::string painted(std::string_view fill, const Stroke& stroke) {
  return attribute("fill", fill) + attribute("stroke", stroke.colour) + attribute("stroke-width", stroke.width) +
         "/>\n";
}

std::string escaped(std::string_view words) {
  std::string text;
  for (const char c : words) {
    text += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return text;
}

}  // namespace

Svg::Svg(double width, double height) {
  body_ = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", width) + attribute("height", height) +
          attribute("font-family", "sans-serif") + ">\n";
  rectangle(0, 0, width, height, "white", {});
}

void Svg::line(double x0, double y0, double x1, double y1, const Stroke& stroke) {
  body_ += "<line" + attribute("x1", x0) + attribute("y1", y0) + attribute("x2", x1) + attribute("y2", y1) +
           painted("none", stroke);
}

void Svg::rectangle(double x, double y, double width, double height, std::string_view fill, const Stroke& stroke) {
  body_ += "<rect" + attribute("x", x) + attribute("y", y) + attribute("width", width) + attribute("height", height) +
           painted(fill, stroke);
}

void Svg::circle(double x, double y, double radius, std::string_view fill, const Stroke& stroke) {
  body_ += "<circle" + attribute("cx", x) + attribute("cy", y) + attribute("r", radius) + painted(fill, stroke);
}

void Svg::polygon(double x, double y, double radius, int corners, std::string_view fill, const Stroke& stroke) {
  std::string points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    points += number(x + radius * std::sin(angle)) + "," + number(y - radius * std::cos(angle)) + " ";
  }
  body_ += "<polygon" + attribute("points", points) + painted(fill, stroke);
}

void Svg::text(double x, double y, std::string_view words, double size, Anchor anchor, bool is_bold) {
  constexpr std::array<std::string_view, 3> anchors{"start", "middle", "end"};
  body_ += "<text" + attribute("x", x) + attribute("y", y) + attribute("font-size", size) +
           attribute("text-anchor", anchors.at(static_cast<std::size_t>(anchor))) +
           (is_bold ? attribute("font-weight", "bold") : "") + ">" + escaped(words) + "</text>\n";
}

void Svg::upright_text(double x, double y, std::string_view words, double size) {
  body_ += "<text" + attribute("font-size", size) + attribute("text-anchor", "middle") +
           attribute("transform", "translate(" + number(x) + " " + number(y) + ") rotate(-90)") + ">" + escaped(words) +
           "</text>\n";
}

void Svg::write(const std::filesystem::path& path) const {
  std::ofstream file(path);
  file << body_ << "</svg>\n";
  if (!file.flush()) {
    throw std::runtime_error(path.string() + " cannot be written");
  }
}

}  // namespace bench
