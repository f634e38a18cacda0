// SPDX-License-Identifier: Apache-2.0
// The elevation grid as a height field. World frame: metres, x to the east, y to the north, z up; the origin lies in
// the middle of the grid at sea level. Heights are exaggerated.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "owned.hpp"

namespace demo {

/// A rectangle of samples, X fastest.
struct Samples {
  std::uint32_t column;
  std::uint32_t row;
  std::uint32_t columns;
  std::uint32_t rows;
  std::vector<double> heights;
};

class Terrain {
 public:
  /// Heights are multiplied by this, as on relief maps: over 30 km of width the true relief of 840 m looks flat.
  static constexpr double exaggeration = 1.5;

  /// Reads a 16-bit big-endian PGM whose rows run from north to south. Throws Failure.
  [[nodiscard]] static Terrain load(const std::filesystem::path& path);

  [[nodiscard]] ShapeOwner make_shape() const;

  /// Places the shape, whose own origin is its south-west corner.
  [[nodiscard]] abut_pose pose() const;

  /// Height of the surface at (x, y), on the two triangles of the cell; outside, of the nearest border.
  [[nodiscard]] double height(double x, double y) const;

  /// Unit normal at (x, y), smoothed over the neighbouring cells.
  [[nodiscard]] Vec3 normal(double x, double y) const;

  /// Digs a bowl around (x, y), `depth` deep in the middle. Answers with the samples around it, as they are then.
  [[nodiscard]] Samples dig(double x, double y, double depth);

  /// What was dug so far, in cubic metres, heights as they are exaggerated.
  [[nodiscard]] double excavated() const { return excavated_; }

  [[nodiscard]] std::uint32_t columns() const { return columns_; }
  [[nodiscard]] std::uint32_t rows() const { return rows_; }
  [[nodiscard]] double half_width() const { return 0.5 * spacing_x * (columns_ - 1); }
  [[nodiscard]] double half_depth() const { return 0.5 * spacing_y * (rows_ - 1); }
  [[nodiscard]] double lowest() const { return lowest_; }
  [[nodiscard]] double highest() const { return highest_; }

 private:
  // 3 arc seconds at the latitude of the grid.
  static constexpr double spacing_x = 74.4;
  static constexpr double spacing_y = 92.6;

  struct Cell {
    std::size_t i;
    std::size_t j;
    double u;  // position in the cell, in [0, 1]
    double v;
  };

  Terrain(std::uint32_t columns, std::uint32_t rows, std::vector<double> heights);
  [[nodiscard]] Cell cell(double x, double y) const;
  [[nodiscard]] double sample(std::size_t i, std::size_t j) const { return heights_[j * columns_ + i]; }
  [[nodiscard]] Vec3 slope_at_sample(std::size_t i, std::size_t j) const;

  std::uint32_t columns_;
  std::uint32_t rows_;
  std::vector<double> heights_;  // from south to north
  double lowest_;
  double highest_;
  double excavated_ = 0.0;
};

}  // namespace demo
