// SPDX-License-Identifier: Apache-2.0
// Plays a sequence of calls on three universes and on the model, and compares
// them.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "call.hpp"
#include "judge.hpp"
#include "universes.hpp"

namespace universe_calls {

struct Counts {
  std::size_t calls = 0, detections = 0, contacts = 0, events = 0, refusals = 0, filtered = 0, switched = 0, sleeps = 0,
              wakes = 0;
};

// Changes what was found before it is judged: for tests of the judge.
using Tamper = std::function<void(Found&)>;

class Play {
 public:
  explicit Play(const Sequence& sequence, Tamper tamper = {});

  // What went wrong, in words; nothing when all is well.
  std::optional<std::string> run();
  const Counts& counts() const { return counts_; }

 private:
  void call(const Call& call);

  // Parts and geometries (edit_parts.cpp, edit_geometries.cpp).
  void create_part(const Call& call);
  void destroy_parts(const Call& call, std::size_t count);
  void place(const Call& call, std::size_t count);
  void set_motion(const Call& call);
  void create_geometries(const Call& call, std::size_t count);
  void destroy_geometries(const Call& call, std::size_t count);
  void set_options(const Call& call);
  void set_shape(const Call& call);
  void park(const Call& call, std::size_t count);

  // Shapes in place, velocities and islands (edit_state.cpp).
  void set_parameters(const Call& call);
  void set_samples(const Call& call);
  void set_velocity(const Call& call);
  void compare_velocities() const;
  void follow_islands(const Call& call);
  void judge_islands() const;

  // Who falls asleep (sleep.cpp).
  void set_sleep(const Call& call);
  void judge_sleep();
  void judge_sleep_of(std::size_t universe);

  // Who meets whom and how (edit_rules.cpp).
  void set_rule(const Call& call);
  void set_filter(const Call& call);
  void set_policy(const Call& call);
  void set_focus(const Call& call);
  abut_collidable collidable_of(const Call& call, std::size_t byte, std::size_t universe) const;

  // Detections (detect.cpp).
  void detect(const Call& call);
  void before_detection();
  void after_detection(const Scope& scope, bool is_partial);
  void follow_focus();
  void settle_filters();
  void judge_reasons() const;
  void compare_with_full(const Found& first, const Found& full) const;
  void compare_state() const;
  void compare_part(std::size_t part) const;
  void compare_geometry(std::size_t geometry) const;
  void mark_contacts(const Call& call);

  // Calls that have to be refused (bad.cpp, bad_values.cpp).
  void bad(const Call& call);
  abut_status bad_id(const Call& call, abut_universe* universe, abut_status& expected);
  abut_status bad_pointer(const Call& call, abut_universe* universe, abut_status& expected);
  abut_status bad_struct(const Call& call, abut_universe* universe, abut_status& expected);
  abut_status bad_number(const Call& call, abut_universe* universe, abut_status& expected);

  // The same call on each universe; each has to answer ABUT_OK.
  template <class Body>
  void on_each(const char* name, Body&& body) {
    for (std::size_t universe = 0; universe < universe_count; ++universe) {
      const abut_status status = body(universe, universes_.at(universe));
      require(status == ABUT_OK,
              std::string(name) + " answered " + abut_status_name(status) + ": " + abut_last_error_message());
    }
  }
  std::vector<std::size_t> picked(const std::vector<std::size_t>& living, const Call& call, std::size_t count) const;

  Sequence sequence_;
  Tamper tamper_;
  Universes universes_;
  World world_;
  Counts counts_;
  bool is_exactly_full_ = true;  // the first universe has done nothing that a
                                 // full detection does not
};

Placed placed_by(const Call& call, std::size_t byte, int reach);

}  // namespace universe_calls
