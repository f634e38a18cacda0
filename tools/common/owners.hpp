// SPDX-License-Identifier: Apache-2.0
// Owners of the objects of the C interface, and the one way in which tools fail.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "abut/abut.h"

namespace tools {

/// Ends a tool with one sentence for the user.
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws a Failure that says what was attempted when a call did not succeed.
inline void check(abut_status status, const char* what) {
  if (status != ABUT_OK) {
    throw Failure(std::string(what) + ": " + abut_status_name(status) + " (" + abut_last_error_message() + ")");
  }
}

struct ReleaseShape {
  void operator()(abut_shape* shape) const { abut_shape_release(shape); }
};
struct DestroyUniverse {
  void operator()(abut_universe* universe) const { abut_universe_destroy(universe); }
};

using ShapeOwner = std::unique_ptr<abut_shape, ReleaseShape>;
using UniverseOwner = std::unique_ptr<abut_universe, DestroyUniverse>;

/// A copy of the contacts of the last step.
[[nodiscard]] std::vector<abut_contact> contacts_of(const abut_universe* universe);

/// A copy of the element contacts of the last step: of pairs by the detail of elements.
[[nodiscard]] std::vector<abut_element_contact> element_contacts_of(const abut_universe* universe);

/// A copy of the events of the last step.
[[nodiscard]] std::vector<abut_event> events_of(const abut_universe* universe);

/// Counts and times of the last step.
[[nodiscard]] abut_step_stats stats_of(const abut_universe* universe);

/// The plan of a universe in words.
[[nodiscard]] std::string plan_of(const abut_universe* universe);

/// The plan of a universe as JSON.
[[nodiscard]] std::string json_plan_of(const abut_universe* universe);

}  // namespace tools
