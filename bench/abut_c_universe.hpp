// SPDX-License-Identifier: Apache-2.0
// Universes of the C interface of abut, and bodies in them.
#pragma once
#include <abut/abut.h>

#include <memory>

#include "abut_c_shapes.hpp"

namespace bench {

struct DestroyUniverse {
  void operator()(abut_universe* universe) const { abut_universe_destroy(universe); }
};
using AbutCUniverse = std::unique_ptr<abut_universe, DestroyUniverse>;

[[nodiscard]] inline AbutCUniverse abut_c_universe(const abut_universe_options& options) {
  abut_universe* universe = nullptr;
  expect_ok(abut_universe_create(&options, &universe));
  return AbutCUniverse(universe);
}

struct AbutCBody {
  abut_part_id part;
  abut_geometry_id geometry;
};

// A part with one geometry.
inline AbutCBody add_abut_c_body(const AbutCUniverse& universe, const AbutCShape& shape, const abut_pose& pose,
                                 abut_motion motion) {
  abut_part_options options;
  abut_part_options_init(&options, sizeof options);
  options.motion = motion;
  options.pose = pose;
  AbutCBody body{};
  expect_ok(abut_part_create(universe.get(), &options, &body.part));
  expect_ok(abut_geometry_create(universe.get(), body.part, shape.get(), nullptr, &body.geometry));
  return body;
}

}  // namespace bench
