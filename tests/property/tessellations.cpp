// SPDX-License-Identifier: Apache-2.0
#include "tessellations.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace property {

namespace {

using Vec = std::array<double, 3>;

Vec vec(const abut_vec3& v) { return {v.x, v.y, v.z}; }
Vec minus(const Vec& u, const Vec& v) { return {u[0] - v[0], u[1] - v[1], u[2] - v[2]}; }
Vec plus(const Vec& u, double t, const Vec& v) { return {u[0] + t * v[0], u[1] + t * v[1], u[2] + t * v[2]}; }
Vec cross(const Vec& u, const Vec& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
double times(const Vec& u, const Vec& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
double length(const Vec& u) { return std::sqrt(times(u, u)); }
Vec unit(const Vec& u) {
  const double l = length(u);
  return l > 0 ? Vec{u[0] / l, u[1] / l, u[2] / l} : u;
}

double to_segment(const Vec& p, const Vec& a, const Vec& b) {
  const Vec along = minus(b, a), from = minus(p, a);
  const double square = times(along, along);
  return length(plus(from, square > 0 ? -std::clamp(times(from, along) / square, 0.0, 1.0) : 0.0, along));
}

double to_triangle(const Vec& p, const std::array<Vec, 3>& corners, const Vec& normal) {
  bool is_over = true;
  for (std::size_t i = 0; i < 3; ++i) {
    is_over = is_over && times(normal, cross(minus(corners[(i + 1) % 3], corners[i]), minus(p, corners[i]))) >= 0;
  }
  if (is_over) return std::abs(times(normal, minus(p, corners[0])));
  return std::min({to_segment(p, corners[0], corners[1]), to_segment(p, corners[1], corners[2]),
                   to_segment(p, corners[2], corners[0])});
}

using Height = std::function<double(double, double)>;

// A rectangle of cells over which a height is sampled, two triangles a cell.
void add_grid(Piece& piece, double x0, double x1, double y0, double y1, std::uint32_t columns, std::uint32_t rows,
              const Height& height) {
  const auto first = static_cast<std::uint32_t>(piece.vertices.size());
  for (std::uint32_t j = 0; j <= rows; ++j) {
    for (std::uint32_t i = 0; i <= columns; ++i) {
      const double x = x0 + (x1 - x0) * i / columns, y = y0 + (y1 - y0) * j / rows;
      piece.vertices.push_back({x, y, height(x, y)});
      if (i == columns || j == rows) continue;
      const std::uint32_t a = first + j * (columns + 1) + i, c = a + columns + 2;
      piece.triangles.push_back({a, a + 1, c});
      piece.triangles.push_back({a, c, c - 1});
    }
  }
}

Piece grid(double x0, double x1, double y0, double y1, std::uint32_t columns, std::uint32_t rows,
           const Height& height) {
  Piece piece;
  add_grid(piece, x0, x1, y0, y1, columns, rows, height);
  return piece;
}

Piece whole(const Height& height) { return grid(-2.5, 2.5, -2.5, 2.5, 14, 14, height); }

// Noise that depends on the place alone, so that pieces agree where they meet.
double noise_at(double x, double y, double amplitude) {
  std::mt19937_64 random(static_cast<std::uint64_t>(std::llround(1e6 * x)) * 1000003U +
                         static_cast<std::uint64_t>(std::llround(1e6 * y)));
  return amplitude * (static_cast<double>(random() >> 11) * 0x1p-52 - 1);
}

Piece torus(double major, double minor, std::uint32_t around, std::uint32_t across) {
  Piece piece;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double ring = major + minor * std::cos(v);
      piece.vertices.push_back({ring * std::cos(u), ring * std::sin(u), minor * std::sin(v)});
      const std::uint32_t right = (i + 1) % around, up = (j + 1) % across;
      const std::uint32_t a = i * across + j, b = right * across + j, c = right * across + up, d = i * across + up;
      piece.triangles.push_back({a, b, c});
      piece.triangles.push_back({a, c, d});
    }
  }
  return piece;
}

// Two halves of 2.5 by 5, as two pieces or one without shared vertices; the right one has its own number of rows.
Tessellation halves(const std::string& name, const Height& height, bool is_one_piece, double gap,
                    std::uint32_t rows_right) {
  Tessellation surface{name, {}, gap, 0, 1.2};
  const Height right = [=](double x, double y) { return height(x - gap, y); };
  Piece left_piece = grid(-2.5, 0, -2.5, 2.5, 7, 14, height);
  if (is_one_piece) {
    add_grid(left_piece, gap, 2.5 + gap, -2.5, 2.5, 7, rows_right, right);
    surface.pieces = {left_piece};
  } else {
    surface.pieces = {left_piece, grid(gap, 2.5 + gap, -2.5, 2.5, 7, rows_right, right)};
  }
  return surface;
}

}  // namespace

std::vector<Tessellation> tessellations() {
  const Height flat = [](double, double) { return 0.0; };
  const Height convex = [](double x, double) { return std::sqrt(16 - x * x) - 4; };
  const Height concave = [](double x, double) { return 4 - std::sqrt(16 - x * x); };
  const Height saddle = [](double x, double y) { return 0.12 * (x * x - y * y); };
  const Height along = [](double x, double) { return 0.2 * x; };
  const auto noisy = [](double amplitude) { return [=](double x, double y) { return noise_at(x, y, amplitude); }; };
  std::vector<Tessellation> list;
  list.push_back({"flat", {whole(flat)}, 0, 0, 1.2});
  for (const double amplitude : {1e-12, 1e-9, 1e-7}) {
    list.push_back(
        {"flat with noise " + std::to_string(amplitude * 1e12) + "e-12", {whole(noisy(amplitude))}, 0, 0, 1.2});
  }
  list.push_back({"convex", {whole(convex)}, 0, 0, 1.2});
  list.push_back({"concave", {whole(concave)}, 0, 0, 1.2});
  list.push_back({"saddle", {whole(saddle)}, 0, 0, 1.2});
  list.push_back({"torus", {torus(3, 1.2, 48, 24)}, 0, 2.4, 3.8});
  list.push_back(halves("crack of no width", flat, true, 0, 14));
  list.push_back(halves("crack of 1e-6", flat, true, 1e-6, 14));
  list.push_back(halves("crack in a bend", convex, true, 0, 14));
  list.push_back(halves("T-junctions", flat, true, 0, 9));
  list.push_back(halves("T-junctions on a slope", along, true, 0, 9));
  list.push_back(halves("seam", flat, false, 0, 14));
  list.push_back(halves("seam of 1e-6", flat, false, 1e-6, 14));
  list.push_back(halves("seam with T-junctions", flat, false, 0, 9));
  list.push_back(halves("seam in a bend", convex, false, 0, 14));
  list.push_back(halves("seam in a saddle", saddle, false, 0, 14));
  return list;
}

Faces::Faces(const Tessellation& surface) {
  double high_x = -1e300, high_y = -1e300;
  low_x_ = low_y_ = 1e300;
  for (const Piece& piece : surface.pieces) {
    for (const auto& triangle : piece.triangles) {
      Face face{};
      for (std::size_t i = 0; i < 3; ++i) {
        face.corners[i] = vec(piece.vertices[triangle[i]]);
        low_x_ = std::min(low_x_, face.corners[i][0]);
        low_y_ = std::min(low_y_, face.corners[i][1]);
        high_x = std::max(high_x, face.corners[i][0]);
        high_y = std::max(high_y, face.corners[i][1]);
      }
      face.normal = unit(cross(minus(face.corners[1], face.corners[0]), minus(face.corners[2], face.corners[0])));
      faces_.push_back(face);
    }
  }
  cell_ = 0.35;
  columns_ = static_cast<std::size_t>((high_x - low_x_) / cell_) + 1;
  rows_ = static_cast<std::size_t>((high_y - low_y_) / cell_) + 1;
  cells_.resize(columns_ * rows_);
  const auto at = [&](double value, double low, std::size_t count) {
    return static_cast<std::size_t>(std::clamp((value - low) / cell_, 0.0, static_cast<double>(count) - 1));
  };
  constexpr double room = 0.01;
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    const auto& c = faces_[f].corners;
    const auto [x0, x1] = std::minmax({c[0][0], c[1][0], c[2][0]});
    const auto [y0, y1] = std::minmax({c[0][1], c[1][1], c[2][1]});
    for (std::size_t j = at(y0 - room, low_y_, rows_); j <= at(y1 + room, low_y_, rows_); ++j) {
      for (std::size_t i = at(x0 - room, low_x_, columns_); i <= at(x1 + room, low_x_, columns_); ++i) {
        cells_[j * columns_ + i].push_back(f);
      }
    }
  }
}

std::vector<Vec> Faces::normals_near(const abut_vec3& point, double reach) const {
  const auto at = [&](double value, double low, std::size_t count) {
    return static_cast<std::size_t>(std::clamp((value - low) / cell_, 0.0, static_cast<double>(count) - 1));
  };
  std::vector<Vec> normals;
  const Vec p = vec(point);
  for (const std::uint32_t f : cells_[at(p[1], low_y_, rows_) * columns_ + at(p[0], low_x_, columns_)]) {
    const Face& face = faces_[f];
    if (to_triangle(p, face.corners, face.normal) > reach) continue;
    const bool is_new = std::none_of(normals.begin(), normals.end(),
                                     [&](const Vec& n) { return length(minus(n, face.normal)) < 1e-12; });
    if (is_new) normals.push_back(face.normal);
  }
  return normals;
}

double Faces::off_cone(const abut_vec3& point, const abut_vec3& normal, double reach) const {
  const std::vector<Vec> normals = normals_near(point, reach);
  const Vec n = vec(normal);
  double least = 2;
  const auto offer = [&](const Vec& direction) {
    const Vec u = unit(direction);
    if (times(u, n) > 0) least = std::min(least, length(cross(u, n)));
  };
  for (std::size_t i = 0; i < normals.size(); ++i) {
    offer(normals[i]);
    for (std::size_t j = 0; j < i; ++j) {
      // Onto the arc between two normals.
      const Vec side = cross(normals[i], normals[j]);
      const double square = times(side, side);
      if (!(square > 1e-24)) continue;
      const Vec on = plus(n, -times(n, side) / square, side);
      if (times(cross(normals[i], on), side) >= 0 && times(cross(on, normals[j]), side) >= 0) offer(on);
      // Within the triangle of three of them.
      for (std::size_t k = 0; k < j; ++k) {
        const double a = times(cross(normals[i], normals[j]), n), b = times(cross(normals[j], normals[k]), n),
                     c = times(cross(normals[k], normals[i]), n);
        if ((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0)) return 0;
      }
    }
  }
  return least;
}

}  // namespace property
