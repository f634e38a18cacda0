// SPDX-License-Identifier: Apache-2.0
// Boxes on a floor that may fall asleep.
#pragma once

#include <iterator>
#include <limits>

#include "support.hpp"

namespace abut_test {

inline constexpr double dt = 0.01;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

class Room {
 public:
  explicit Room(std::uint32_t threads = 1) : universe_options(make_options(threads)), universe(&universe_options) {
    floor = universe.add_part(identity, ABUT_MOTION_STATIC);
    universe.add_geometry(floor, plane);
  }

  static abut_universe_options make_options(std::uint32_t threads) {
    abut_universe_options options = default_universe_options();
    options.threads = threads_of_build(threads);
    return options;
  }

  // A box of side 1 that may sleep.
  abut_part_id add_box(const abut_pose& pose, abut_motion motion = ABUT_MOTION_DYNAMIC) {
    const abut_part_id part = universe.add_part(pose, motion);
    boxes.push_back(universe.add_geometry(part, box));
    set_sleep(part, default_sleep());
    return part;
  }
  std::vector<abut_part_id> add_stack(std::size_t count, double x = 0) {
    std::vector<abut_part_id> stack;
    for (std::size_t i = 0; i < count; ++i) {
      stack.push_back(add_box(at(x, 0, 0.49 + 0.99 * double(i))));
    }
    return stack;
  }
  void set_sleep(abut_part_id part, const abut_sleep& sleep) { require(abut_part_set_sleep(universe, part, &sleep)); }

  void step(int count = 1) {
    for (int i = 0; i < count; ++i) {
      require(abut_universe_step(universe, dt));
    }
  }
  bool is_asleep(abut_part_id part) const {
    std::uint32_t out = 7;
    require(abut_part_is_asleep(universe, part, &out));
    EXPECT_LE(out, 1U);
    return out == 1;
  }
  std::vector<abut_sleep_change> changes() const { return copy_of(abut_universe_sleep_changes, universe); }
  // The slots of those that fell asleep, or of those that woke.
  std::vector<std::uint32_t> changed(bool to_sleep) const {
    std::vector<std::uint32_t> slots;
    for (const abut_sleep_change& change : changes()) {
      EXPECT_EQ(change.reserved, 0U);
      EXPECT_EQ(is_asleep(change.part), change.is_asleep == 1);
      if ((change.is_asleep == 1) == to_sleep) slots.push_back(change.part.slot);
    }
    return slots;
  }
  std::uint64_t asleep() const { return universe.stats().asleep; }

  Shape plane = make_plane({0, 0, 1}, 0), box = make_box(0.5, 0.5, 0.5), ball = make_sphere(0.5);
  abut_universe_options universe_options;
  Universe universe;
  abut_part_id floor{};
  std::vector<abut_geometry_id> boxes;
};

inline std::vector<std::uint32_t> slots_of(const std::vector<abut_part_id>& parts) {
  std::vector<std::uint32_t> slots;
  for (const abut_part_id part : parts) slots.push_back(part.slot);
  return slots;
}

inline constexpr int until_asleep =
    12;  // two steps until speeds and accelerations are known, with the third the first of ten calm ones

}  // namespace abut_test
