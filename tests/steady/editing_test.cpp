// SPDX-License-Identifier: Apache-2.0
// What it costs to change a shape that nobody else holds: no copy.
#include "allocations.hpp"

#include "support.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace {

using namespace abut_test;
using steady::AllocationCounter;
using steady::Allocations;

constexpr std::uint32_t side = 256;

abut_geometry_id add_field(Universe& universe) {
  const std::vector<double> heights(std::size_t{side} * side, 0.0);
  return universe.add(make_of_kind("height_field", {side, side, 1, 1}, heights), identity, ABUT_MOTION_STATIC);
}

// Of a call that edits, after one like it; and how many bytes more are in use than before it.
struct Cost {
  Allocations allocations;
  std::ptrdiff_t bytes;
};
template <class Edit>
Cost cost_of(Universe& universe, Edit&& edit) {
  require(edit());
  universe.step();
  AllocationCounter counter;
  const std::size_t before = steady::live_bytes();
  const abut_status status = edit();
  const std::size_t after = steady::live_bytes();
  const Allocations allocations = counter.stop();
  require(status);
  return {allocations, static_cast<std::ptrdiff_t>(after) - static_cast<std::ptrdiff_t>(before)};
}

TEST(EditOfASoleHolder, KeepsTheSamplesWhereTheyAre) {
  Universe universe;
  const abut_geometry_id field = add_field(universe);
  const std::array heights{1.0, 2.0, 3.0, 4.0};
  const Cost cost =
      cost_of(universe, [&] { return abut_geometry_set_heights(universe, field, 100, 100, 2, 2, heights.data()); });
  EXPECT_LE(cost.allocations.calls, 2U) << "a list and words of the call: " << cost.allocations.first_places;
  EXPECT_EQ(cost.bytes, 0);
}

TEST(EditOfASoleHolder, KeepsPrimitivesWhereTheyAre) {
  Universe universe;
  const abut_geometry_id ball = universe.add(make_sphere(1), identity);
  const double radius = 2;
  const Cost cost = cost_of(universe, [&] { return abut_geometry_set_parameters(universe, ball, &radius, 1); });
  EXPECT_LE(cost.allocations.calls, 2U) << cost.allocations.first_places;
  EXPECT_EQ(cost.bytes, 0);
}

// A tube of 159,200 triangles, bent to a ring; `sides` as in abut_mesh_options.
Shape make_ring(double sides) {
  constexpr std::uint32_t around = 398, across = 200;
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double reach = 2 + 0.7 * std::cos(v);
      xyz.insert(xyz.end(), {reach * std::cos(u), reach * std::sin(u), 0.7 * std::sin(v)});
      const std::uint32_t next_i = (i + 1) % around, next_j = (j + 1) % across;
      const std::uint32_t a = i * across + j, b = next_i * across + j, c = next_i * across + next_j,
                          d = i * across + next_j;
      triangles.insert(triangles.end(), {a, b, c, a, c, d});
    }
  }
  return make_of_kind("mesh", {sides}, xyz, triangles);
}

// What is made of all triangles takes memory as well. So neither the edit nor the next step makes anything of them.
TEST(EditOfASoleHolder, FollowsOneVertexOfASolidMesh) {
  Universe universe;
  const abut_geometry_id ring = universe.add(make_ring(2), identity);
  universe.add(make_sphere(0.1), at(2.75, 0, 0));
  double height = 0;
  const auto edit = [&] {
    height += 1e-3;
    const std::array place{2.7, 0.0, height};
    return abut_geometry_set_vertices(universe, ring, 0, place.data(), 1);
  };
  universe.step();
  require(edit());
  const Cost cost = cost_of(universe, edit);
  EXPECT_LE(cost.allocations.calls, 2U) << cost.allocations.first_places;
  EXPECT_EQ(cost.bytes, 0);
  AllocationCounter counter;
  require(abut_universe_step(universe, 0));
  const Allocations found = counter.stop();
  EXPECT_EQ(found.calls, 0U) << found.first_places;
  EXPECT_EQ(universe.stats().touching_pairs, 1U);
}

TEST(EditOfASharedShape, CopiesItOnce) {
  Universe universe;
  const abut_geometry_id field = add_field(universe);
  abut_shape* taken = nullptr;
  require(abut_geometry_shape(universe, field, &taken));
  const Shape held(taken);
  const double height = 1;
  constexpr std::ptrdiff_t samples = std::ptrdiff_t{side} * side * static_cast<std::ptrdiff_t>(sizeof(double));
  const std::size_t before = steady::live_bytes();
  require(abut_geometry_set_heights(universe, field, 0, 0, 1, 1, &height));
  EXPECT_GE(static_cast<std::ptrdiff_t>(steady::live_bytes()) - static_cast<std::ptrdiff_t>(before), samples);
  const Cost cost = cost_of(universe, [&] { return abut_geometry_set_heights(universe, field, 0, 0, 1, 1, &height); });
  EXPECT_EQ(cost.bytes, 0) << "the copy is held by nobody else";
}

}  // namespace
