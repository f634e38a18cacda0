// SPDX-License-Identifier: Apache-2.0
// Boxes in an Embree scene: which of them a ray may meet. Nothing that it meets is left out.
module;

#include <abut/picking.h>

#include "picking/embree.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

export module abut.picking:box_scene;
import :vector;

namespace abut::picking {

struct FloatBox {
  std::array<float, 3> lower;
  std::array<float, 3> upper;
};

// A box in single precision, relative to a space and widened by all that rounding may do to a ray there.
[[nodiscard]] FloatBox widened_box(const abut_aabb& box, const Space& space);

inline void write_bounds(const FloatBox& box, RTCBounds& out) {
  out.lower_x = box.lower[0];
  out.lower_y = box.lower[1];
  out.lower_z = box.lower[2];
  out.upper_x = box.upper[0];
  out.upper_y = box.upper[1];
  out.upper_z = box.upper[2];
}

// Stays where it was made: Embree has its address.
struct BoxScene {
  Space space;
  std::vector<FloatBox> boxes;
  embree::Geometry geometry;
  embree::Scene scene;

  BoxScene() = default;
  BoxScene(const BoxScene&) = delete;
  BoxScene& operator=(const BoxScene&) = delete;
};

// Null where memory runs out.
[[nodiscard]] std::unique_ptr<BoxScene> make_box_scene(RTCDevice device, const Space& space,
                                                       std::span<const abut_aabb> boxes);

// The boxes on the way of a ray, as numbers. False where memory runs out.
[[nodiscard]] bool boxes_on_ray(const BoxScene& scene, const Entrance& entrance, const abut_vec3& direction,
                                double limit, std::vector<std::uint32_t>& out);

}  // namespace abut::picking
