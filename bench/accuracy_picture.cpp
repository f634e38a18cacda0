// SPDX-License-Identifier: Apache-2.0
#include "accuracy_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "accuracy_tables.hpp"
#include "statistics.hpp"
#include "svg.hpp"

namespace bench {
namespace {

// Powers of ten at the ends of the axes. What lies beyond, as an error of zero does, stands at the rim.
constexpr int first_time = 1, last_time = 6, first_error = -17, last_error = 1;
constexpr double panel_width = 330, panel_height = 300;
constexpr double left = 80, top = 64, gap_x = 46, gap_y = 60, legend_width = 190;
constexpr std::size_t columns = 3;
// More failures than this part of the cases, and a mark is hollow.
constexpr double most_failures = 0.01;

enum class Form : std::uint8_t { circle, square, triangle, pentagon };

struct Mark {
  Form form;
  double radius;
  std::string_view colour;
};

// In the order of the entrants. Rings of abut's bounds grow with the bound: where they coincide, all are seen.
constexpr std::array marks{
    Mark{Form::circle, 3, "#08306b"},   Mark{Form::circle, 11, "#c6dbef"},    Mark{Form::circle, 9.5, "#9ecae1"},
    Mark{Form::circle, 8, "#6baed6"},   Mark{Form::circle, 6.5, "#4292c6"},   Mark{Form::circle, 5, "#2171b5"},
    Mark{Form::square, 6, "#238b45"},   Mark{Form::square, 6, "#74c476"},     Mark{Form::square, 6, "#b8860b"},
    Mark{Form::square, 6, "#7b4fa3"},   Mark{Form::square, 6, "#c994c7"},     Mark{Form::triangle, 7, "#d62728"},
    Mark{Form::triangle, 7, "#ff7f0e"}, Mark{Form::pentagon, 6.5, "#7b4fa3"}, Mark{Form::pentagon, 6.5, "#c994c7"}};

void draw(Svg& svg, const Mark& mark, double x, double y, bool is_hollow) {
  const std::string_view fill = is_hollow ? "none" : mark.colour;
  const Stroke stroke{is_hollow ? mark.colour : "#404040", is_hollow ? 2 : 0.6};
  switch (mark.form) {
    case Form::circle: return svg.circle(x, y, mark.radius, fill, stroke);
    case Form::square: return svg.polygon(x, y, mark.radius, 4, fill, stroke);
    case Form::triangle: return svg.polygon(x, y, mark.radius, 3, fill, stroke);
    case Form::pentagon: return svg.polygon(x, y, mark.radius, 5, fill, stroke);
  }
}

// Where a value stands on a logarithmic axis, from 0 to 1.
double share(double value, int first, int last) {
  const double power = value > 0 ? std::log10(value) : first;
  return std::clamp((power - first) / (last - first), 0.0, 1.0);
}

std::string time_label(int power) {
  constexpr std::array<std::string_view, 7> labels{"1 ns", "10 ns", "100 ns", "1 µs", "10 µs", "100 µs", "1 ms"};
  return std::string(labels.at(static_cast<std::size_t>(power)));
}

struct Panel {
  double x, y;

  [[nodiscard]] double across(double nanoseconds) const {
    return x + panel_width * share(nanoseconds, first_time, last_time);
  }
  [[nodiscard]] double up(double error) const { return y + panel_height * (1 - share(error, first_error, last_error)); }
};

void draw_axes(Svg& svg, const Panel& panel, Condition condition) {
  constexpr Stroke grid{"#e4e4e4", 1};
  svg.text(panel.x + panel_width / 2, panel.y - 10, condition_title(condition), 13, Anchor::middle, true);
  for (int power = first_time; power <= last_time; ++power) {
    const double x = panel.across(std::pow(10, power));
    svg.line(x, panel.y, x, panel.y + panel_height, grid);
    svg.text(x, panel.y + panel_height + 16, time_label(power), 10, Anchor::middle);
  }
  for (int power = first_error + 1; power <= last_error; power += 2) {
    const double y = panel.up(std::pow(10, power));
    svg.line(panel.x, y, panel.x + panel_width, y, grid);
    if (panel.x < left + 1) {
      svg.text(panel.x - 8, y + 4, power == 0 ? "1" : "1e" + std::to_string(power), 10, Anchor::end);
    }
  }
  svg.rectangle(panel.x, panel.y, panel_width, panel_height, "none", {"#808080", 1});
}

bool fails_often(const Row& row) {
  return static_cast<double>(row.failed.total()) > most_failures * static_cast<double>(row.cases);
}

void draw_marks(Svg& svg, const Panel& panel, std::span<const Row> rows, Query query, Condition condition) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    order.push_back(i);
  }
  // Large ones first, so that they do not hide others.
  std::ranges::sort(order, std::greater(), [](std::size_t i) { return std::pair(marks.at(i).radius, i); });
  for (const std::size_t i : order) {
    const std::vector<Row> of_pairs = selected(rows, query, condition, i);
    if (of_pairs.empty()) {
      continue;
    }
    const Row row = together(of_pairs);
    const double error = row.errors.empty() ? HUGE_VAL : percentile(row.errors, 99);
    draw(svg, marks.at(i), panel.across(row.nanoseconds), panel.up(error), fails_often(row));
  }
}

void draw_legend(Svg& svg, double x, double y, std::span<const Row> rows, Query query) {
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const auto is_here = [&](const Row& row) { return row.entrant == i && row.query == query; };
    if (std::ranges::none_of(rows, is_here)) {
      continue;
    }
    draw(svg, marks.at(i), x, y - 4, false);
    svg.text(x + 20, y, entrants()[i].name, 12, Anchor::start);
    y += 25;
  }
  y += 10;
  draw(svg, {Form::triangle, 7, "#404040"}, x, y - 4, true);
  svg.text(x + 20, y, "hollow: more than", 12, Anchor::start);
  svg.text(x + 20, y + 16, "1 % of the answers", 12, Anchor::start);
  svg.text(x + 20, y + 32, "failed", 12, Anchor::start);
}

}  // namespace

void write_picture(const std::filesystem::path& path, std::span<const Row> rows, Query query) {
  constexpr std::size_t lines = (all_conditions.size() + columns - 1) / columns;
  constexpr double right = left + columns * (panel_width + gap_x);
  constexpr double bottom = top + lines * (panel_height + gap_y);
  Svg svg(right + legend_width, bottom + 10);
  const std::string_view title =
      query == Query::distance ? "Distance of separated pairs" : "Depth of overlapping pairs";
  svg.text(left, 26, title, 18, Anchor::start, true);
  for (std::size_t i = 0; i < all_conditions.size(); ++i) {
    const Panel panel{left + static_cast<double>(i % columns) * (panel_width + gap_x),
                      top + static_cast<double>(i / columns) * (panel_height + gap_y)};
    draw_axes(svg, panel, all_conditions.at(i));
    draw_marks(svg, panel, rows, query, all_conditions.at(i));
  }
  svg.text(left + (right - gap_x - left) / 2, bottom - 16, "time of a query, median over the pairs of shapes", 13,
           Anchor::middle);
  svg.upright_text(24, (top + bottom - gap_y) / 2, "error by the sum of the diameters, 99th percentile", 13);
  draw_legend(svg, right + 6, top + 12, rows, query);
  svg.write(path);
}

}  // namespace bench
