// SPDX-License-Identifier: Apache-2.0
// A picture of linear light, anti-aliased drawing on it, and its way into a PNG file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tools {

/// Linear light; 1 is a white surface in full daylight before tone mapping, or full scale after it.
struct Colour {
  double r;
  double g;
  double b;
};

[[nodiscard]] constexpr Colour operator+(const Colour& a, const Colour& b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
[[nodiscard]] constexpr Colour operator*(const Colour& a, const Colour& b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
[[nodiscard]] constexpr Colour operator*(const Colour& a, double s) { return {a.r * s, a.g * s, a.b * s}; }
[[nodiscard]] constexpr Colour mix(const Colour& a, const Colour& b, double t) { return a * (1.0 - t) + b * t; }

class Image {
 public:
  Image(std::uint32_t width, std::uint32_t height)
      : width_(width), height_(height), pixels_(std::size_t{width} * height) {}

  [[nodiscard]] std::uint32_t width() const { return width_; }
  [[nodiscard]] std::uint32_t height() const { return height_; }
  [[nodiscard]] Colour& at(std::size_t x, std::size_t y) { return pixels_[y * width_ + x]; }
  [[nodiscard]] const Colour& at(std::size_t x, std::size_t y) const { return pixels_[y * width_ + x]; }
  [[nodiscard]] std::vector<Colour>& pixels() { return pixels_; }

  /// Filled circle. Coordinates are pixels from the top left corner; (0.5, 0.5) is the centre of the first pixel.
  void draw_disc(double x, double y, double radius, const Colour& colour, double opacity);

  /// Circle line, `width` wide.
  void draw_ring(double x, double y, double radius, double width, const Colour& colour, double opacity);

  /// Straight line with round ends.
  void draw_line(double x0, double y0, double x1, double y1, double width, const Colour& colour, double opacity);

  /// Filled rectangle with round corners.
  void draw_panel(double x0, double y0, double x1, double y1, double corner, const Colour& colour, double opacity);

 private:
  template <class Distance>
  void cover(double x0, double y0, double x1, double y1, const Colour& colour, double opacity, Distance distance);

  std::uint32_t width_;
  std::uint32_t height_;
  std::vector<Colour> pixels_;
};

/// Compresses scene light into [0, 1].
[[nodiscard]] Colour tone_mapped(const Colour& light);

/// The bytes of a PNG of 8-bit sRGB. Throws Failure.
[[nodiscard]] std::string encode_png(const Image& image);

/// Writes them to a file. Throws Failure.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace tools
