// SPDX-License-Identifier: Apache-2.0
// Meshes that enclose something: solids that are wound inside out, and hollow ones around other geometries.
#include <algorithm>
#include <cmath>
#include <random>

#include "../../unit/damaged_meshes.hpp"
#include "../support.hpp"

namespace {

using namespace abut_test;
using test::Surface;

abut_mesh_options with_sides(abut_sides sides) {
  abut_mesh_options options;
  abut_mesh_options_init(&options, sizeof options);
  options.sides = sides;
  return options;
}

abut_status create(const Surface& surface, abut_sides sides, Shape& out) {
  const abut_mesh_options options = with_sides(sides);
  abut_shape* made = nullptr;
  const abut_status status = abut_mesh_create(surface.xyz.data(), surface.xyz.size() / 3, surface.triangles.data(),
                                              surface.triangle_count(), &options, &made);
  out = Shape(made);
  return status;
}
Shape make(const Surface& surface, abut_sides sides) {
  Shape out;
  require(create(surface, sides, out));
  return out;
}

double volume_of(const Surface& surface) {
  abut_mesh_report report;
  abut_mesh_report_init(&report, sizeof report);
  require(abut_mesh_describe(surface.xyz.data(), surface.xyz.size() / 3, surface.triangles.data(),
                             surface.triangle_count(), nullptr, &report));
  return report.volume;
}

Surface turned(Surface surface) {
  for (std::size_t i = 0; i < surface.triangles.size(); i += 3)
    std::swap(surface.triangles[i + 1], surface.triangles[i + 2]);
  return surface;
}

// A box with 12 triangles, from `low` to `high`.
Surface box_surface(const abut_vec3& low, const abut_vec3& high) {
  Surface out;
  for (unsigned i = 0; i < 8; ++i) {
    out.xyz.insert(out.xyz.end(),
                   {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z});
  }
  out.triangles = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                   2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  return out;
}

Surface joined(const Surface& a, const Surface& b) {
  Surface out = a;
  out.xyz.insert(out.xyz.end(), b.xyz.begin(), b.xyz.end());
  for (const std::uint32_t vertex : b.triangles)
    out.triangles.push_back(vertex + static_cast<std::uint32_t>(a.xyz.size() / 3));
  return out;
}

TEST(MeshWinding, TheVolumeIsTold) {
  const Surface cube = box_surface({4, 5, 6}, {5, 7, 9});
  EXPECT_NEAR(volume_of(cube), 6, 1e-13);
  EXPECT_NEAR(volume_of(turned(cube)), -6, 1e-13);
  const Surface ring = test::torus(1, 0.4, 200, 200);
  EXPECT_NEAR(volume_of(ring), 2 * std::pow(std::numbers::pi, 2) * 0.16, 2e-3);
  EXPECT_NEAR(volume_of(joined(cube, turned(box_surface({4.25, 5.5, 7}, {4.75, 6.5, 8})))), 5.5, 1e-13) << "a cavity";
  const Surface sheet{{0, 0, 3, 1, 0, 3, 0, 1, 3}, {0, 1, 2}};
  EXPECT_EQ(volume_of(sheet), 0);
}

TEST(MeshWinding, ASolidInsideOutIsRefused) {
  const Surface cube = box_surface({-1, -1, -1}, {1, 1, 1});
  Shape none;
  EXPECT_TRUE(refused(create(turned(cube), ABUT_SIDES_SOLID, none), ABUT_INVALID_ARGUMENT,
                      {"solid", "volume", "-8", "not be negative"}));
  EXPECT_EQ(static_cast<abut_shape*>(none), nullptr);
  expect_kind_refused("mesh", {2}, turned(cube).xyz, turned(cube).triangles, ABUT_INVALID_ARGUMENT, {"volume", "-8"});
  expect_kind_refused("uv_grid", {2, 0, 1, 0, 0}, turned(cube).xyz, turned(cube).triangles, ABUT_INVALID_ARGUMENT,
                      {"volume", "-8"});
  for (const abut_sides sides : {ABUT_SIDES_BOTH, ABUT_SIDES_FRONT}) make(turned(cube), sides);
  make(cube, ABUT_SIDES_SOLID);
}

// Wherever they lie, of any size, with gaps, and with some triangles turned.
TEST(MeshWinding, SolidsAreRefusedExactlyWhereTheyAreInsideOut) {
  const auto seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  for (int round = 0; round < 100; ++round) {
    Surface ring = test::torus(1, in(0.1, 0.6), 12, 8);
    const double size = std::pow(10, in(-6, 6));
    const abut_vec3 place{in(-100, 100), in(-100, 100), in(-100, 100)};
    for (std::size_t i = 0; i < ring.xyz.size(); i += 3) {
      ring.xyz[i] = size * (ring.xyz[i] + place.x);
      ring.xyz[i + 1] = size * (ring.xyz[i + 1] + place.y);
      ring.xyz[i + 2] = size * (ring.xyz[i + 2] + place.z);
    }
    Shape out;
    EXPECT_TRUE(refused(create(turned(ring), ABUT_SIDES_SOLID, out), ABUT_INVALID_ARGUMENT, {"volume"}));
    for (int i = 0; i < 10; ++i) {
      const std::size_t triangle = 3 * (random() % ring.triangle_count());
      std::swap(ring.triangles[triangle], ring.triangles[triangle + 1]);
    }
    ring.triangles.resize(ring.triangles.size() - 3);
    EXPECT_TRUE(succeeded(create(ring, ABUT_SIDES_SOLID, out)));
  }
}

// A sheet encloses nothing, however it is wound, and a bowl as much as where one looks from.
TEST(MeshWinding, OpenSurfacesAreNotRefused) {
  Surface bowl;
  for (std::uint32_t j = 0; j < 9; ++j) {
    for (std::uint32_t i = 0; i < 9; ++i) {
      const double x = i - 4.0, y = j - 4.0;
      bowl.xyz.insert(bowl.xyz.end(), {x, y, 0.1 * (x * x + y * y)});
      const std::uint32_t a = 9 * j + i;
      if (i < 8 && j < 8) bowl.triangles.insert(bowl.triangles.end(), {a, a + 1, a + 10, a, a + 10, a + 9});
    }
  }
  make(bowl, ABUT_SIDES_SOLID);
  make(turned(bowl), ABUT_SIDES_SOLID);
}

std::vector<abut_finding> findings_of(const abut_universe* universe) {
  std::size_t count = 0;
  require(abut_universe_validate(universe, nullptr, 0, &count));
  std::vector<abut_finding> all(count);
  require(abut_universe_validate(universe, all.data(), count, &count));
  return all;
}
std::vector<abut_finding> findings_of(const abut_universe* universe, abut_finding_code code) {
  std::vector<abut_finding> all = findings_of(universe);
  std::erase_if(all, [&](const abut_finding& finding) { return finding.code != code; });
  return all;
}

TEST(MeshWinding, ASolidThatIsTurnedByAnEditIsFound) {
  Universe universe;
  const Surface cube = box_surface({-1, -1, -1}, {1, 1, 1});
  universe.add(make(cube, ABUT_SIDES_SOLID), at(9, 0, 0));
  const abut_geometry_id mirrored = universe.add(make(cube, ABUT_SIDES_SOLID), identity);
  EXPECT_TRUE(findings_of(universe).empty());
  std::vector<double> xyz = cube.xyz;
  for (std::size_t i = 0; i < xyz.size(); i += 3) xyz[i] = -xyz[i];
  require(abut_geometry_set_vertices(universe, mirrored, 0, xyz.data(), 8));
  const std::vector<abut_finding> found = findings_of(universe, ABUT_FINDING_INSIDE_OUT);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].geometry == mirrored);
  EXPECT_EQ(found[0].other.slot, 0U);
  EXPECT_NE(std::string(found[0].message).find("inside out"), std::string::npos);
}

TEST(MeshWinding, AHollowMeshAroundABodyIsFound) {
  const Surface cube = box_surface({-1, -1, -1}, {1, 1, 1}), ring = test::torus(3, 1, 40, 24);
  const Shape ball = make_sphere(0.25);
  for (const bool is_turned : {false, true}) {
    Universe universe;
    const abut_geometry_id mesh = universe.add(make(is_turned ? turned(cube) : cube, ABUT_SIDES_BOTH),
                                               {{20, 0, 0}, {0.8, 0, 0, 0.6}}, ABUT_MOTION_STATIC);
    const abut_geometry_id within = universe.add(ball, at(20.2, 0.1, 0));
    const std::vector<abut_finding> found = findings_of(universe);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].code, abut_finding_code{ABUT_FINDING_HOLLOW});
    EXPECT_TRUE(found[0].geometry == mesh && found[0].other == within);
    EXPECT_NE(std::string(found[0].message).find("hollow"), std::string::npos);
  }
  // A ball in the hole of a ring, one beside it, solids, what is open, and what never meets: nothing to tell.
  Universe universe;
  universe.add(make(ring, ABUT_SIDES_BOTH), identity);
  universe.add(ball, identity);
  universe.add(ball, at(9, 0, 0));
  universe.add(make(cube, ABUT_SIDES_SOLID), at(20, 0, 0));
  universe.add(ball, at(20, 0, 0));
  Surface open = cube;
  open.triangles.resize(30);
  universe.add(make(open, ABUT_SIDES_BOTH), at(30, 0, 0));
  universe.add(ball, at(30, 0, 0));
  universe.add(make(cube, ABUT_SIDES_BOTH), at(40, 0, 0), ABUT_MOTION_STATIC);
  universe.add(ball, at(40, 0, 0), ABUT_MOTION_STATIC);
  EXPECT_TRUE(findings_of(universe).empty()) << findings_of(universe)[0].message;
  // In the tube of the ring.
  universe.add(ball, at(3, 0, 0));
  EXPECT_EQ(findings_of(universe, ABUT_FINDING_HOLLOW).size(), 1U);
}

}  // namespace
