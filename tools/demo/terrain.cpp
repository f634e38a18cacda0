// SPDX-License-Identifier: Apache-2.0
#include "terrain.hpp"

#include <algorithm>
#include <utility>

#include "common/height_map.hpp"

namespace demo {

Terrain::Terrain(std::uint32_t columns, std::uint32_t rows, std::vector<double> heights)
    : columns_(columns),
      rows_(rows),
      heights_(std::move(heights)),
      lowest_(*std::min_element(heights_.begin(), heights_.end())),
      highest_(*std::max_element(heights_.begin(), heights_.end())) {}

Terrain Terrain::load(const std::filesystem::path& path) {
  HeightMap map = read_height_map(path);
  for (double& height : map.heights) {
    height *= exaggeration;
  }
  return {map.columns, map.rows, std::move(map.heights)};
}

ShapeOwner Terrain::make_shape() const {
  abut_height_field_desc desc;
  abut_height_field_desc_init(&desc, sizeof desc);
  desc.columns = columns_;
  desc.rows = rows_;
  desc.spacing_x = spacing_x;
  desc.spacing_y = spacing_y;
  desc.heights = heights_.data();
  abut_shape* shape = nullptr;
  check(abut_height_field_create(&desc, &shape), "cannot create the height field");
  return ShapeOwner(shape);
}

abut_pose Terrain::pose() const { return {{-half_width(), -half_depth(), 0.0}, no_rotation}; }

Terrain::Cell Terrain::cell(double x, double y) const {
  const double column = std::clamp((x + half_width()) / spacing_x, 0.0, columns_ - 1.0);
  const double row = std::clamp((y + half_depth()) / spacing_y, 0.0, rows_ - 1.0);
  const auto i = std::min(static_cast<std::size_t>(column), std::size_t{columns_} - 2);
  const auto j = std::min(static_cast<std::size_t>(row), std::size_t{rows_} - 2);
  return {i, j, column - static_cast<double>(i), row - static_cast<double>(j)};
}

double Terrain::height(double x, double y) const {
  const auto [i, j, u, v] = cell(x, y);
  const double near = sample(i, j);
  const double far = sample(i + 1, j + 1);
  if (u >= v) {
    const double corner = sample(i + 1, j);
    return near + u * (corner - near) + v * (far - corner);
  }
  const double corner = sample(i, j + 1);
  return near + v * (corner - near) + u * (far - corner);
}

// (dz/dx, dz/dy, 0) by central differences, one-sided at the border.
Vec3 Terrain::slope_at_sample(std::size_t i, std::size_t j) const {
  const std::size_t west = i > 0 ? i - 1 : i;
  const std::size_t east = std::min(i + 1, std::size_t{columns_} - 1);
  const std::size_t south = j > 0 ? j - 1 : j;
  const std::size_t north = std::min(j + 1, std::size_t{rows_} - 1);
  return {(sample(east, j) - sample(west, j)) / (spacing_x * static_cast<double>(east - west)),
          (sample(i, north) - sample(i, south)) / (spacing_y * static_cast<double>(north - south)), 0.0};
}

Vec3 Terrain::normal(double x, double y) const {
  const auto [i, j, u, v] = cell(x, y);
  const Vec3 south = slope_at_sample(i, j) * (1.0 - u) + slope_at_sample(i + 1, j) * u;
  const Vec3 north = slope_at_sample(i, j + 1) * (1.0 - u) + slope_at_sample(i + 1, j + 1) * u;
  const Vec3 slope = south * (1.0 - v) + north * v;
  return normalised({-slope.x, -slope.y, 1.0});
}

Samples Terrain::dig(double x, double y, double depth) {
  constexpr std::size_t reach = 2;  // in cells
  const Cell middle = cell(x, y);
  const std::size_t west = middle.i > reach ? middle.i - reach : 0, south = middle.j > reach ? middle.j - reach : 0;
  const std::size_t east = std::min(middle.i + reach + 1, std::size_t{columns_} - 1);
  const std::size_t north = std::min(middle.j + reach + 1, std::size_t{rows_} - 1);
  Samples out{static_cast<std::uint32_t>(west),
              static_cast<std::uint32_t>(south),
              static_cast<std::uint32_t>(east - west + 1),
              static_cast<std::uint32_t>(north - south + 1),
              {}};
  for (std::size_t j = south; j <= north; ++j) {
    for (std::size_t i = west; i <= east; ++i) {
      const double across = static_cast<double>(i) - static_cast<double>(middle.i) - middle.u;
      const double along = static_cast<double>(j) - static_cast<double>(middle.j) - middle.v;
      const double cut = depth * std::max(0.0, 1.0 - (across * across + along * along) / (reach * reach));
      double& height = heights_[j * columns_ + i];
      height -= cut;
      excavated_ += cut * spacing_x * spacing_y;
      out.heights.push_back(height);
    }
  }
  return out;
}

}  // namespace demo
