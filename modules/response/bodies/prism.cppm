// SPDX-License-Identifier: Apache-2.0
// Boxes and cylinders as prisms: what a hole takes out of a solid whose walls are parallel to its own.
module;

#include <abut/abut.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

export module abut.response:prism;
import :mass;
import :vector;

export namespace abut::response {

// A profile that goes along z, from `low` to `high`, which may be infinite.
struct Prism {
  abut_vec3 centre{};
  Matrix axes{};                 // its columns are x, y and z
  double low = 0, high = 0;      // from the centre
  std::array<double, 2> half{};  // of a rectangle
  double radius = 0;             // of a disc; 0 for a rectangle
};

// All that a box or a cylinder is, solid or hole; none for all other kinds. Parameters are those of its kind.
[[nodiscard]] std::vector<Prism> prisms_of(std::string_view kind, const std::vector<double>& parameters,
                                           const abut_pose& pose);
// The part of a hole that lies within a solid where that is a prism, too: parallel, and with the profile of the hole.
[[nodiscard]] std::optional<Prism> part_within(const Prism& hole, const Prism& solid);
[[nodiscard]] MassProperties mass_of(const Prism& prism);
[[nodiscard]] abut_pose pose_of(const Prism& prism);

}  // namespace abut::response
