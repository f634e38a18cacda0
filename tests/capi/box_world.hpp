// SPDX-License-Identifier: Apache-2.0
// A universe of boxes that never turn, beside a model that knows by itself which of them touch.
#pragma once

#include <compare>
#include <map>
#include <random>
#include <set>

#include "support.hpp"

namespace abut_test {

// Two geometries, of which a has the lower slot.
struct Touch {
  abut_geometry_id a;
  abut_geometry_id b;

  friend bool operator==(const Touch& x, const Touch& y) { return x.a == y.a && x.b == y.b; }
  friend bool operator<(const Touch& x, const Touch& y) {
    const auto key = [](const Touch& t) { return std::array{t.a.slot, t.b.slot, t.a.generation, t.b.generation}; };
    return key(x) < key(y);
  }
};

// The part of an event that the model foretells.
struct Change {
  Touch touch;
  abut_event_kind kind;

  friend bool operator==(const Change&, const Change&) = default;
};

// Worlds with equal seeds are told the same, so that their ids have equal slots.
class BoxWorld {
 public:
  BoxWorld(const abut_universe_options& options, std::uint64_t seed, int boxes);

  Universe& universe() { return universe_; }
  // A few random changes of everything that can change.
  void edit();
  // Edits that only move parts.
  void move_some();

  // Pairs that meet at present by the rules of the universe, in order.
  std::vector<Touch> touching() const;
  // What a detection of everything has to report after the one before, in order. Call it once for each.
  std::vector<Change> foretell();
  double number(double low, double high);
  std::size_t size() const { return boxes_.size(); }
  abut_geometry_id random_geometry();

 private:
  struct Part {
    abut_part_id id{};
    abut_vec3 position{};
    abut_motion motion = ABUT_MOTION_DYNAMIC;
  };
  struct Box {
    abut_geometry_id id{};
    std::uint32_t part = 0;  // slot
    abut_vec3 half{};
    abut_geometry_options options{};
    bool is_reshaped = false;
    bool has_changed_parking = false;
  };

  static std::uint32_t filter(void* context, const abut_universe* universe, abut_geometry_id a, abut_geometry_id b);
  bool is_kept(std::uint32_t slot_a, std::uint32_t slot_b) const { return (slot_a + slot_b) % 5 != banned_; }
  bool meet(const Box& a, const Box& b) const;
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(random_() % count); }
  Box& random_box();
  void add_box();
  void move_part();
  void destroy();
  void park();
  void reshape();
  void change_options();
  void change_motion();
  void change_rule();
  void change_filter();

  std::mt19937_64 random_;
  Universe universe_;
  std::map<std::uint32_t, Part> parts_;  // by slot
  std::map<std::uint32_t, Box> boxes_;   // by slot
  std::array<std::array<abut_rule, 3>, 3> rules_{};
  std::uint32_t banned_ = 7;  // keeps all
  std::vector<Touch> before_;
};

// What a universe has contacts of, in order.
std::set<Touch> touches_of(const std::vector<abut_contact>& contacts);
// Events of pairs as changes.
std::vector<Change> changes_of(const std::vector<abut_event>& events);

}  // namespace abut_test
