// SPDX-License-Identifier: Apache-2.0
// Which of two tags geometries have, by their distance from centres.
#include "convert.hpp"
#include "options.hpp"
#include "universe/universe_handle.hpp"

import abut.core;
import abut.math;
import abut.universe;

using namespace abut::capi;

namespace {

abut_status set(abut_universe& its, const abut_focus& focus, std::span<const abut_vec3> centres) {
  const Where where{"focus"};
  abut_status status = check_struct_size(where, focus);
  status = status != ABUT_OK ? status : check_reserved(where, focus.reserved);
  for (std::size_t i = 0; status == ABUT_OK && i < centres.size(); ++i) {
    status = check_position({"centres", i}, "", centres[i]);
  }
  if (status != ABUT_OK) {
    return status;
  }
  its.centres.resize(centres.size());
  std::transform(centres.begin(), centres.end(), its.centres.begin(), to_vec3);
  const abut::Focus wanted{focus.near_tag, focus.far_tag, focus.near_distance, focus.far_distance};
  const auto done = its.universe.set_focus(wanted, its.centres);
  return done ? static_cast<abut_status>(ABUT_OK) : refuse_field(where, done.error());
}

abut_status set_none(abut_universe& its) {
  const auto done = its.universe.set_focus(std::nullopt, {});
  return done ? static_cast<abut_status>(ABUT_OK) : refuse(done.error());
}

}  // namespace

void abut_focus_init(abut_focus* focus, uint32_t struct_size) {
  constexpr abut::Focus standard;
  constexpr abut_focus defaults{sizeof(abut_focus),     standard.near_tag,    standard.far_tag, 0,
                                standard.near_distance, standard.far_distance};
  fill_defaults(defaults, struct_size, focus);
}

abut_status abut_universe_set_focus(abut_universe* universe, const abut_focus* focus, const abut_vec3* centres,
                                    size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_vec3> given;
    const abut_status status = read_span("centres", centres, "count", count, given);
    return status != ABUT_OK ? status : focus == nullptr ? set_none(its) : set(its, *focus, given);
  });
}
