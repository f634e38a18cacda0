// SPDX-License-Identifier: Apache-2.0
module;

#include <array>
#include <cmath>

module abut.response;

namespace abut::response {

namespace {

enum class Face : unsigned char { inside, apex, side, axis };

// Where the nearest point lies. On the side: its normal component, and the direction of its tangents.
struct Nearest {
  Face face;
  double normal = 0;
  double t = 0, s = 0;
  double length = 0;  // of the given tangents
  double ratio = 0;   // friction times the quotient of the two weights
};

[[nodiscard]] Nearest nearest(const Triple& given, double friction, double tangent, double normal) {
  const auto [t, s, n] = given;
  if (friction <= 0) return {.face = n > 0 ? Face::axis : Face::apex, .normal = n};
  const double length = std::sqrt(t * t + s * s), ratio = friction * tangent / normal;
  if (length <= friction * n) return {.face = Face::inside};
  if (n <= -ratio * length) return {.face = Face::apex};
  return {.face = Face::side,
          .normal = (n + ratio * length) / (1 + friction * ratio),
          .t = t / length,
          .s = s / length,
          .length = length,
          .ratio = ratio};
}

[[nodiscard]] Triple point_of(const Nearest& at, const Triple& given, double friction) {
  switch (at.face) {
    case Face::inside: return given;
    case Face::apex: return {};
    case Face::axis: return {0, 0, at.normal};
    case Face::side: return {friction * at.normal * at.t, friction * at.normal * at.s, at.normal};
  }
  return {};
}

}  // namespace

Triple project(const Triple& given, double friction, double tangent, double normal) {
  return point_of(nearest(given, friction, tangent, normal), given, friction);
}

ConePoint project_with_derivative(const Triple& given, double friction, double tangent, double normal) {
  const Nearest at = nearest(given, friction, tangent, normal);
  ConePoint out{.point = point_of(at, given, friction), .derivative = {}};
  Triple2& d = out.derivative;
  switch (at.face) {
    case Face::inside: d[0][0] = d[1][1] = d[2][2] = 1; break;
    case Face::apex: break;
    case Face::axis: d[2][2] = 1; break;
    case Face::side: {
      const double whole = 1 + friction * at.ratio;
      const double along = friction * at.ratio / whole, across = friction * at.normal / at.length;
      const Triple direction{at.t, at.s, 0};
      for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) {
          const double square = direction[i] * direction[j];
          d[i][j] = along * square + across * ((i == j ? 1 : 0) - square);
        }
        d[i][2] = friction / whole * direction[i];
        d[2][i] = at.ratio / whole * direction[i];
      }
      d[2][2] = 1 / whole;
      break;
    }
  }
  return out;
}

}  // namespace abut::response
