// SPDX-License-Identifier: Apache-2.0
// A drawing in SVG, from the top left corner, in pixels.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace bench {

enum class Anchor { start, middle, end };

struct Stroke {
  std::string_view colour = "none";
  double width = 1;
};

class Svg {
 public:
  Svg(double width, double height);

  void line(double x0, double y0, double x1, double y1, const Stroke& stroke);
  void rectangle(double x, double y, double width, double height, std::string_view fill, const Stroke& stroke);
  void circle(double x, double y, double radius, std::string_view fill, const Stroke& stroke);
  // The same size as a circle: with so many corners, the first of them above.
  void polygon(double x, double y, double radius, int corners, std::string_view fill, const Stroke& stroke);
  void text(double x, double y, std::string_view words, double size, Anchor anchor, bool is_bold = false);
  // Upwards, its middle at the place.
  void upright_text(double x, double y, std::string_view words, double size);

  void write(const std::filesystem::path& path) const;

 private:
  std::string body_;
};

}  // namespace bench
