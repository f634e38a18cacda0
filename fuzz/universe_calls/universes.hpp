// SPDX-License-Identifier: Apache-2.0
// Three universes that get the same calls, and everything that can be seen of
// one.
#pragma once

#include <abut/abut.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "call.hpp"
#include "model.hpp"

namespace universe_calls {

// What a universe lends out after a detection, copied.
struct Found {
  std::vector<abut_contact> contacts;
  std::vector<abut_event> events;
  abut_step_stats stats{};
  std::uint64_t hash = 0;
};
Found found_in(const abut_universe* universe);

// Everything that the functions marked [const] tell, but for texts. Equal
// snapshots are equal bit by bit.
struct Snapshot {
  std::vector<abut_part_id> parts;
  std::vector<abut_geometry_id> geometries;
  std::vector<abut_geometry_info> infos;
  std::vector<abut_pose> poses;
  std::vector<abut_motion> motions;
  std::vector<abut_policy> policies;
  Found found;
  abut_revision revision{};
};
Snapshot snapshot_of(const abut_universe* universe);
bool is_same(const Snapshot& a, const Snapshot& b);
bool is_same(const abut_contact& a, const abut_contact& b);

// What the callback of a universe works with, and what it noticed. It must not
// throw.
struct FilterContext {
  abut_universe* universe = nullptr;
  FilterRule rule;
  std::uint64_t hash_before = 0;  // of the step before
  std::vector<Slots> asked;       // in the step that goes on
  std::string complaint;          // empty: none
};

// Shapes of the sequences: 27 boxes of whole half extents, and some that the
// model knows nothing of. Made once.
const std::vector<Shape>& shapes();

// The first two differ in what must not matter, broad phase and threads; the
// third one finds everything anew each time.
class Universes {
 public:
  explicit Universes(const Call& setup);
  ~Universes();
  Universes(const Universes&) = delete;
  Universes& operator=(const Universes&) = delete;

  abut_universe* at(std::size_t universe) const { return universes_.at(universe); }
  FilterContext& filter(std::size_t universe) { return filters_.at(universe); }
  const abut_universe_options& options() const { return options_; }

 private:
  std::array<abut_universe*, universe_count> universes_{};
  std::array<FilterContext, universe_count> filters_;
  abut_universe_options options_{};  // of the first
};

// The callback; `context` is a FilterContext.
uint32_t filter_pair(void* context, const abut_universe* universe, abut_geometry_id a, abut_geometry_id b);

}  // namespace universe_calls
