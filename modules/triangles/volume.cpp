// SPDX-License-Identifier: Apache-2.0
module abut.triangles.volume;
import abut.capability;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {

// Volumes below this share of the cube around the triangles are rounding.
constexpr Real least_share = 1e-12;

template <class Visitor>
void visit_triangles(const Triangles& triangles, const Vec3& from, Visitor&& visit) {
  for (std::size_t i = 0; i + 2 < triangles.indices.size(); i += 3) {
    visit(triangles.vertices[triangles.indices[i]] - from, triangles.vertices[triangles.indices[i + 1]] - from,
          triangles.vertices[triangles.indices[i + 2]] - from);
  }
}

}  // namespace

bool EnclosedVolume::is_inside_out() const {
  const Real side = largest_magnitude(box.high - box.low);
  return volume + doubt < -least_share * side * side * side;
}

EnclosedVolume enclosed_volume(const Triangles& triangles) {
  EnclosedVolume out;
  visit_triangles(triangles, {0, 0, 0}, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    for (const Vec3& corner : {a, b, c}) {
      out.box.include(corner);
    }
  });
  Vec3 area{0, 0, 0};
  visit_triangles(triangles, out.box.centre(), [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    out.volume += dot(a, cross(b, c)) / 6;
    area = area + 0.5 * cross(b - a, c - a);
  });
  out.doubt = norm(area) * norm(out.box.high - out.box.low) / 6;
  return out;
}

}  // namespace abut
