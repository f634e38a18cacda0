// SPDX-License-Identifier: Apache-2.0
#include "closest.hpp"

namespace oracle {

ClosestPair pair_of(const Vec& a, const Vec& b) {
  const Vec between = b - a;
  return {a, b, dot(between, between)};
}

namespace {

Vec nearest_on_segment(const Vec& point, const Vec& first, const Vec& second) {
  const Vec along = second - first;
  const Quad squared = dot(along, along);
  if (!(squared > 0)) return first;
  const Quad place = dot(point - first, along) / squared;
  if (place <= 0) return first;
  if (place >= 1) return second;
  return first + along * place;
}

void keep_closer(ClosestPair& best, const ClosestPair& other) {
  if (other.squared < best.squared) best = other;
}

}  // namespace

ClosestPair closest_of_segments(const Vec& a0, const Vec& a1, const Vec& b0, const Vec& b1) {
  ClosestPair best = pair_of(a0, nearest_on_segment(a0, b0, b1));
  keep_closer(best, pair_of(a1, nearest_on_segment(a1, b0, b1)));
  keep_closer(best, pair_of(nearest_on_segment(b0, a0, a1), b0));
  keep_closer(best, pair_of(nearest_on_segment(b1, a0, a1), b1));
  const Vec along_a = a1 - a0;
  const Vec along_b = b1 - b0;
  const Vec normal = cross(along_a, along_b);
  const Quad squared = dot(normal, normal);
  if (squared > 0) {
    const Quad place = dot(cross(b0 - a0, along_b), normal) / squared;
    if (place > 0 && place < 1) {
      const Vec on_a = a0 + along_a * place;
      const Vec on_b = nearest_on_segment(on_a, b0, b1);
      keep_closer(best, pair_of(nearest_on_segment(on_b, a0, a1), on_b));
    }
  }
  return best;
}

std::optional<Vec> foot_in_triangle(const Vec& point, const Vec& a, const Vec& b, const Vec& c) {
  const Vec normal = cross(b - a, c - a);
  const Quad squared = dot(normal, normal);
  if (!(squared > 0)) return std::nullopt;
  const Vec foot = point - normal * (dot(normal, point - a) / squared);
  const Quad rim = quad(-1e-28) * squared;
  if (dot(cross(b - a, foot - a), normal) < rim) return std::nullopt;
  if (dot(cross(c - b, foot - b), normal) < rim) return std::nullopt;
  if (dot(cross(a - c, foot - c), normal) < rim) return std::nullopt;
  return foot;
}

}  // namespace oracle
