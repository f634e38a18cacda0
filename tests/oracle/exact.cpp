// SPDX-License-Identifier: Apache-2.0
#include "exact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace oracle {

namespace {

// A number as a sum of doubles that do not overlap, the smallest first.
class Exact {
 public:
  explicit Exact(Quad value) {
    // 113 bits are three doubles at most.
    for (int i = 0; i < 3; ++i) {
      const double part = static_cast<double>(value);
      add(part);
      value -= quad(part);
    }
  }

  friend Exact operator+(Exact a, const Exact& b) {
    for (const double part : b.parts_) a.add(part);
    return a;
  }
  friend Exact operator-(Exact a, const Exact& b) {
    for (const double part : b.parts_) a.add(-part);
    return a;
  }
  friend Exact operator*(const Exact& a, const Exact& b) {
    Exact product(0);
    for (const double x : a.parts_) {
      for (const double y : b.parts_) {
        const double rough = x * y;
        product.add(std::fma(x, y, -rough));
        product.add(rough);
      }
    }
    return product;
  }

  [[nodiscard]] int sign() const { return parts_.empty() ? 0 : parts_.back() > 0 ? 1 : -1; }

 private:
  void add(double next) {
    std::vector<double> sum;
    for (const double part : parts_) {
      const double rough = next + part, of_part = rough - next;
      const double lost = (next - (rough - of_part)) + (part - of_part);
      if (lost != 0) sum.push_back(lost);
      next = rough;
    }
    if (next != 0) sum.push_back(next);
    parts_ = sum;
  }

  std::vector<double> parts_;
};

int sign_of(Quad value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

// What rounding in 113 bits may add to a sum of products, as a part of their magnitudes: the true factor is below
// 2e-33.
constexpr Quad blur = quad(1e-32);

struct Flat {
  Quad x, y;
};

int side_of_line(const Flat& a, const Flat& b, const Flat& p) {
  const Quad left = (a.x - p.x) * (b.y - p.y), right = (a.y - p.y) * (b.x - p.x);
  const Quad area = left - right;
  if (absolute(area) > blur * (absolute(left) + absolute(right))) return sign_of(area);
  const Exact x(p.x), y(p.y);
  return ((Exact(a.x) - x) * (Exact(b.y) - y) - (Exact(a.y) - y) * (Exact(b.x) - x)).sign();
}

// Without one coordinate.
Flat flattened(const Vec& v, int axis) {
  return axis == 0 ? Flat{v.y, v.z} : axis == 1 ? Flat{v.z, v.x} : Flat{v.x, v.y};
}

bool is_within_box(const Flat& p, const Flat& a, const Flat& b) {
  return p.x >= smaller(a.x, b.x) && p.x <= larger(a.x, b.x) && p.y >= smaller(a.y, b.y) && p.y <= larger(a.y, b.y);
}

bool meet_in_plane(const Flat& a, const Flat& b, const Flat& c, const Flat& d) {
  const int a_side = side_of_line(c, d, a), b_side = side_of_line(c, d, b);
  const int c_side = side_of_line(a, b, c), d_side = side_of_line(a, b, d);
  if (a_side * b_side < 0 && c_side * d_side < 0) return true;
  return (a_side == 0 && is_within_box(a, c, d)) || (b_side == 0 && is_within_box(b, c, d)) ||
         (c_side == 0 && is_within_box(c, a, b)) || (d_side == 0 && is_within_box(d, a, b));
}

// A coordinate without which the triangle still has an area, or -1.
int flattening_axis(const Triple& t) {
  for (const int axis : {0, 1, 2}) {
    if (side_of_line(flattened(t[0], axis), flattened(t[1], axis), flattened(t[2], axis)) != 0) return axis;
  }
  return -1;
}

bool meets_in_plane(const Vec& from, const Vec& to, const Triple& triangle) {
  const int axis = flattening_axis(triangle);
  const Flat p = flattened(from, axis), q = flattened(to, axis);
  const std::array<Flat, 3> t{flattened(triangle[0], axis), flattened(triangle[1], axis), flattened(triangle[2], axis)};
  bool is_left = true, is_right = true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (meet_in_plane(p, q, t[i], t[(i + 1) % 3])) return true;
    const int side = side_of_line(t[i], t[(i + 1) % 3], p);
    is_left = is_left && side >= 0;
    is_right = is_right && side <= 0;
  }
  return is_left || is_right;
}

}  // namespace

int side_of_plane(const Vec& a, const Vec& b, const Vec& c, const Vec& point) {
  const Vec u = a - point, v = b - point, w = c - point;
  const Quad xy = v.x * w.y, yx = v.y * w.x, yz = v.y * w.z, zy = v.z * w.y, zx = v.z * w.x, xz = v.x * w.z;
  // Counter-clockwise corners seen from the point lie around it clockwise.
  const Quad volume = -(u.x * (yz - zy) + u.y * (zx - xz) + u.z * (xy - yx));
  const Quad magnitude = absolute(u.x) * (absolute(yz) + absolute(zy)) + absolute(u.y) * (absolute(zx) + absolute(xz)) +
                         absolute(u.z) * (absolute(xy) + absolute(yx));
  if (absolute(volume) > blur * magnitude) return sign_of(volume);
  const auto minus_point = [&](const Vec& corner) {
    return std::array{Exact(corner.x) - Exact(point.x), Exact(corner.y) - Exact(point.y),
                      Exact(corner.z) - Exact(point.z)};
  };
  const auto p = minus_point(a), q = minus_point(b), r = minus_point(c);
  return -(p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]))
              .sign();
}

bool has_area(const Triple& triangle) { return flattening_axis(triangle) >= 0; }

bool meets(const Vec& from, const Vec& to, const Triple& t) {
  const int from_side = side_of_plane(t[0], t[1], t[2], from), to_side = side_of_plane(t[0], t[1], t[2], to);
  if (from_side == 0 && to_side == 0) return meets_in_plane(from, to, t);
  if (from_side * to_side > 0) return false;
  // The line goes through the triangle where it passes all edges on the same side.
  const std::array<int, 3> sides{side_of_plane(from, to, t[0], t[1]), side_of_plane(from, to, t[1], t[2]),
                                 side_of_plane(from, to, t[2], t[0])};
  return std::ranges::all_of(sides, [](int side) { return side >= 0; }) ||
         std::ranges::all_of(sides, [](int side) { return side <= 0; });
}

bool meets(const Triple& one, const Triple& other) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (meets(one[i], one[(i + 1) % 3], other) || meets(other[i], other[(i + 1) % 3], one)) return true;
  }
  return false;
}

namespace {

Quad volume(const Vec& a, const Vec& b, const Vec& c, const Vec& point) { return dot(cross(b - a, c - a), point - a); }

// Behind every face of a hull; false where the hull is flat. After a turn the corners of a face of four are no longer
// in one plane: the corner that is furthest from a face tells where the inside is.
bool is_inside(const Vec& point, const Features& hull) {
  bool has_volume = false;
  for (const auto& [i, j, k] : hull.triangles) {
    const Vec &a = hull.points[i], &b = hull.points[j], &c = hull.points[k];
    Vec furthest = a;
    for (const Vec& p : hull.points) {
      if (absolute(volume(a, b, c, p)) > absolute(volume(a, b, c, furthest))) furthest = p;
    }
    const int inner = side_of_plane(a, b, c, furthest);
    if (inner == 0) continue;
    has_volume = true;
    if (side_of_plane(a, b, c, point) * inner < 0) return false;
  }
  return has_volume;
}

}  // namespace

bool meets(const Triple& triangle, const Features& hull) {
  if (hull.edges.empty()) return meets(hull.points.front(), hull.points.front(), triangle);
  for (const auto& [i, j] : hull.edges) {
    if (meets(hull.points[i], hull.points[j], triangle)) return true;
  }
  for (const auto& [i, j, k] : hull.triangles) {
    const Triple face{hull.points[i], hull.points[j], hull.points[k]};
    if (has_area(face) && meets(triangle, face)) return true;
  }
  return is_inside(triangle[0], hull);
}

}  // namespace oracle
