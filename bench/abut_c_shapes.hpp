// Solids and placements as the C interface of abut wants them.
#pragma once
#include <abut/abut.h>

#include <memory>
#include <stdexcept>
#include <vector>

#include "scene.hpp"

namespace bench {

struct ReleaseShape {
  void operator()(abut_shape* shape) const { abut_shape_release(shape); }
};
using AbutCShape = std::unique_ptr<abut_shape, ReleaseShape>;

inline void expect_ok(abut_status status) {
  if (status != ABUT_OK) {
    throw std::runtime_error(abut_last_error_message());
  }
}

[[nodiscard]] inline abut_pose abut_c_pose(const Placement& placement) {
  const auto& [position, q] = placement;
  return {{position[0], position[1], position[2]}, {q[0], q[1], q[2], q[3]}};
}

[[nodiscard]] inline AbutCShape abut_c_shape(const Solid& solid) {
  abut_shape* shape = nullptr;
  const Point& s = solid.sizes;
  constexpr abut_vec3 up{0, 0, 1};
  switch (solid.kind) {
    case Kind::sphere:
      expect_ok(abut_sphere_create(s[0], &shape));
      break;
    case Kind::box:
      expect_ok(abut_box_create(s[0], s[1], s[2], &shape));
      break;
    case Kind::capsule:
      expect_ok(abut_capsule_create(s[0], s[1], &shape));
      break;
    case Kind::plane:
      expect_ok(abut_plane_create(&up, 0, &shape));
      break;
    case Kind::hull32:
    case Kind::hull200: {
      std::vector<double> xyz;
      for (const Point& p : solid.points) {
        xyz.insert(xyz.end(), p.begin(), p.end());
      }
      expect_ok(abut_hull_create(xyz.data(), solid.points.size(), &shape));
      break;
    }
  }
  return AbutCShape(shape);
}

}  // namespace bench
