// SPDX-License-Identifier: Apache-2.0
// What a universe should hold and find, by plain vectors and integers. Knows
// nothing of the library but its records.
#pragma once

#include <abut/abut.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace universe_calls {

// What went wrong, in words.
struct Finding : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[noreturn]] void fail(const std::string& what);
inline void require(bool holds, const std::string& what) {
  if (!holds) {
    fail(what);
  }
}

inline constexpr std::size_t universe_count = 3;
using PartIds = std::array<abut_part_id, universe_count>;
using GeometryIds = std::array<abut_geometry_id, universe_count>;

using Triple = std::array<int, 3>;
// Rows are world axes. Each has one entry that is not zero.
using Turn = std::array<Triple, 3>;

// A pose whose numbers are exact in floating point: whole positions, and the
// twelve rotations whose quaternions have components 0, 1/2 and 1. Other poses
// are beyond the model.
struct Placed {
  abut_pose pose{{0, 0, 0}, {1, 0, 0, 0}};
  bool is_exact = true;
  Triple position{};
  Turn turn{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};
Placed placed_at(const Triple& position, std::size_t turn);
// Off the grid by fractions, and turned by any angle.
Placed loosely_placed(const Triple& position, double fraction, double angle);

struct Shape {
  abut_shape* shape = nullptr;
  bool is_box = false;
  Triple half{};
};

struct Part {
  PartIds ids{};
  bool is_alive = true;
  abut_motion motion = ABUT_MOTION_DYNAMIC;
  Placed placed;
  std::uint64_t user_data = 0;
  std::vector<std::size_t> geometries;
  bool may_sleep = false;
  std::optional<abut_velocity> velocity;         // as given last
  std::array<bool, universe_count> is_asleep{};  // in the last detection
  std::array<abut_pose, universe_count> rest{};  // where it fell asleep
};

struct Geometry {
  GeometryIds ids{};
  bool is_alive = true;
  std::size_t part = 0;
  Shape shape;
  Placed local;
  abut_geometry_options options{};  // as set last
  bool is_moved = true;             // since the last detection
  bool is_reshaped = false;
  bool is_resized = false;   // its shape is no longer that of the list
  bool is_switched = false;  // by the focus, in this detection
};

struct Rule {
  abut_collidable a, b;  // as in the first universe
  abut_rule rule;
};

// Whole centres; distances whose squares are those of no exact box.
struct Focus {
  abut_focus focus{};
  std::vector<Triple> centres;
};

enum class Answer { no, yes, maybe };

// A pair whose boxes were near and that was admitted in the last detection.
// `low` and `high` are places in World::geometries.
struct Pair {
  std::size_t low = 0, high = 0;
  bool is_touching = false;
  bool is_new = true;         // not examined yet
  bool is_stale = true;       // what it has is not of the present poses
  std::uint32_t waiting = 0;  // detections in a row that covered it and may have kept what is stale
  std::vector<abut_contact> contacts;
};
using Slots = std::pair<std::uint32_t, std::uint32_t>;

// What a filter does, as a function of two geometries alone.
struct FilterRule {
  std::uint32_t modulus = 0;  // 0: there is no filter
  std::uint32_t parks = 0;    // 0: it parks nothing
  bool keeps(std::uint64_t data_a, std::uint64_t data_b) const {
    return modulus == 0 || (data_a + data_b) % modulus != 0;
  }
  std::optional<abut_parking> parking_of(std::uint64_t data_a, std::uint64_t data_b) const;
};

enum class Coverage { changed, everything, pairs, region };
struct Scope {
  Coverage coverage = Coverage::changed;
  std::vector<Slots> pairs;
  std::array<Triple, 2> region{};
};

struct World {
  abut_tolerance_mode mode = ABUT_TOLERANCE_DEAD_BAND;
  std::uint32_t max_contacts = 4;
  abut_event_bits events = ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST;

  std::vector<Part> parts;           // also those that are gone
  std::vector<Geometry> geometries;  // likewise
  std::vector<Rule> rules;
  FilterRule filter;
  std::map<std::pair<std::uint32_t, std::uint32_t>, abut_policy> policies;  // the lower tag first
  std::optional<Focus> focus;
  bool are_islands_followed = false;
  std::map<Slots, Pair> pairs;

  // Places of those that live, by slot.
  std::vector<std::size_t> living_parts() const;
  std::vector<std::size_t> living_geometries() const;
  std::size_t parked_count() const;
  const abut_policy& policy_of(const Geometry& a, const Geometry& b) const;

  // What of parts, motions, parking, exclusion, layers and rules keeps two apart.
  abut_apart_reasons reasons_apart(const Geometry& a, const Geometry& b) const;
  // Who meets whom, without and with the last of the filters.
  bool may_meet(const Geometry& a, const Geometry& b) const;
  bool is_admitted_before_filter(const Geometry& a, const Geometry& b) const;
  bool is_admitted(const Geometry& a, const Geometry& b) const;

  // Whether boxes overlap as far as a pair reaches, whether a detection now
  // finds a touch, and whether a scope covers a pair.
  Answer is_near(const Geometry& a, const Geometry& b) const;
  Answer touches(const Geometry& a, const Geometry& b) const;
  Answer is_covered(const Geometry& a, const Geometry& b, const Scope& scope) const;

  // Whether the focus looks at a geometry in a detection, and the tag that it gets then, where the model knows its box.
  bool is_focused(const Geometry& geometry) const;
  std::optional<std::uint32_t> focused_tag(const Geometry& geometry) const;

  void forget_geometry(std::size_t geometry);
  void forget_part(std::size_t part);
  void set_rule(const Rule& rule);
};

// The box of a geometry in the world, where the model knows it.
struct Box {
  Triple centre, half;
};
std::optional<Box> box_of(const World& world, const Geometry& geometry);
abut_policy default_policy();

}  // namespace universe_calls
