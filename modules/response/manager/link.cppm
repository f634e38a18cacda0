// SPDX-License-Identifier: Apache-2.0
// What draws points together without a contact: springs, bonds and the mouse.
module;

#include <abut/response.h>

#include <cstdint>

export module abut.response:link;

export namespace abut::response {

// A point of a part, in its frame; of the world where the part is null.
struct Anchor {
  abut_part_id part{};
  abut_vec3 point{};
};

struct Link {
  std::uint64_t number = 0;
  Anchor a, b;
  double stiffness = 0, damping = 0;  // a stiffness of 0 is rigid
  double most_force = 0;              // 0: any
  double break_force = 0;             // 0: never
  abut_vec3 force{};                  // on b, of the last step
  // Of a bond: the contact that made it.
  abut_geometry_id geometry_a{}, geometry_b{};
  std::uint64_t contact = 0;
  std::uint32_t kind = 0;
  abut_vec3 normal{0, 0, 1};

  [[nodiscard]] bool is_bond() const { return geometry_a.slot != 0; }
};

}  // namespace abut::response
