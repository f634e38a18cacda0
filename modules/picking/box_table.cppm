// SPDX-License-Identifier: Apache-2.0
// Boxes of geometries, four at a time: which of them reach into a convex region.
module;

#include <abut/abut.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

export module abut.picking:box_table;
import :region;
import :vector;

namespace abut::picking {

// Bit i is about plane i of a region.
using PlaneBits = std::uint64_t;

// Bounded boxes by the slots of their geometries.
class BoxTable {
 public:
  void set(std::uint32_t slot, const abut_aabb& box);
  void erase(std::uint32_t slot);
  void clear() { groups_.clear(); }

  // Calls visit(slot, crossed) for each box that reaches into all half-spaces, by slot. It lies within those
  // half-spaces whose bits are not set.
  template <class Visit>
  void look(std::span<const HalfSpace> planes, const Visit& visit) const {
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      const Crossed crossed = crossed_by(groups_[i], planes);
      if (crossed.inside == 0) [[likely]]
        continue;
      for (std::uint32_t lane = 0; lane < 4; ++lane) {
        if ((crossed.inside >> lane & 1u) != 0) visit(static_cast<std::uint32_t>(4 * i + lane), crossed.planes[lane]);
      }
    }
  }

 private:
  // The middles of four boxes, and half of their sides. One that is not there has no number as its middle.
  struct Group {
    Four x, y, z, half_x, half_y, half_z;
  };
  struct Crossed {
    unsigned inside;      // bits of boxes
    PlaneBits planes[4];  // of each
  };
  [[nodiscard]] static Crossed crossed_by(const Group& group, std::span<const HalfSpace> planes);

  std::vector<Group> groups_;
};

}  // namespace abut::picking
