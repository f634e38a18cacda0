// SPDX-License-Identifier: Apache-2.0
// What a pair of a surface and a body keeps of the side from which the body came.
export module abut.narrow.warm.side_memory;
import abut.core.standard;
import abut.math;

export namespace abut {

struct SideOfPart {
  std::uint32_t part;
  bool is_front;  // the body came from there
};

// Of one surface and one body; empty while the two do not touch.
struct SideMemory {
  Vec3 normal{0, 0, 0};           // of the deepest contact, from the surface to the body, in the frame of the surface
  std::vector<SideOfPart> parts;  // the triangles that were touched, in order

  [[nodiscard]] bool is_empty() const { return parts.empty(); }
};

// Of two children of a pair, by their numbers. Particles are children; 0 is the number of a shape without any.
struct SidesOfChildren {
  std::uint32_t child_a, child_b;
  SideMemory memory;
};

}  // namespace abut
