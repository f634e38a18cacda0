// SPDX-License-Identifier: Apache-2.0
// Surfaces that are terrain: planes against them, height fields against each other, and grids of cells.
#include <cmath>
#include <limits>
#include <random>

#include "support.hpp"

namespace {

using namespace abut_test;

constexpr abut_pose upside_down{{0, 0, 0}, {0, 1, 0, 0}};

std::vector<double> hills(std::uint32_t samples, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> height(-0.5, 0.5);
  std::vector<double> heights(std::size_t{samples} * samples);
  std::generate(heights.begin(), heights.end(), [&] { return height(random); });
  return heights;
}

struct Triangles {
  std::vector<double> xyz;
  std::vector<std::uint32_t> indices;
};

Triangles triangles_of(const abut_shape* shape) {
  Triangles out;
  std::size_t vertices = 0, triangles = 0;
  require(abut_shape_triangles(shape, nullptr, 0, &vertices, nullptr, 0, &triangles));
  out.xyz.resize(vertices * 3);
  out.indices.resize(triangles * 3);
  require(abut_shape_triangles(shape, out.xyz.data(), vertices, &vertices, out.indices.data(), triangles, &triangles));
  return out;
}

TEST(Plane, MeetsTheLowestSampleOfAHeightField) {
  const std::vector<double> heights = hills(30, 31);
  const Shape field = make_of_kind("height_field", {30, 30, 0.5, 0.25, 0}, heights),
              plane = make_plane({0, 0.6, 0.8}, 0.125);
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < heights.size(); ++k) {
    lowest = std::min(lowest, 0.6 * (0.25 * static_cast<double>(k / 30) + 2) + 0.8 * (heights[k] + 3) - 0.125);
  }
  EXPECT_NEAR(distance_of(plane, identity, field, at(1, 2, 3)), lowest, 1e-12);
  EXPECT_NEAR(distance_of(field, at(1, 2, 3), plane, identity), lowest, 1e-12);
  EXPECT_TRUE(contacts_of(plane, identity, field, at(1, 2, 3)).empty());
  const std::vector<abut_contact> sunk =
      contacts_of(plane, identity, field, {{1, 2 - 0.6 * lowest - 0.006, 3 - 0.8 * lowest - 0.008}, {1, 0, 0, 0}});
  ASSERT_FALSE(sunk.empty());
  EXPECT_NEAR(sunk.front().distance, -0.01, 1e-12);
}

// All triangles of a flat field are equally low.
TEST(Plane, MeetsFlatFieldsInEverySample) {
  const Shape field = make_of_kind("height_field", {5, 5, 1, 1, 0}, std::vector(25, 0.0)),
              plane = make_plane({0, 0, 1}, 0);
  EXPECT_EQ(distance_of(plane, identity, field, at(0, 0, 2)), 2);
  EXPECT_EQ(contacts_of(plane, identity, field, at(0, 0, -0.25)).size(), 32U * 3U);
}

TEST(HeightField, MeetsAnotherThatIsTurnedOver) {
  const std::vector<double> ground = hills(12, 32), lid = hills(9, 33);
  const Shape a = make_of_kind("height_field", {12, 12, 1, 1, 0}, ground),
              b = make_of_kind("height_field", {9, 9, 1, 1, 2}, lid);
  abut_pose over = upside_down;
  over.position = {1.25, 10.5, 2.5};
  const Triangles of_b = triangles_of(b);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < of_b.indices.size(); k += 3) {
    std::vector<double> corners;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto vertex = of_b.xyz.begin() + 3 * static_cast<std::ptrdiff_t>(of_b.indices[k + corner]);
      corners.insert(corners.end(), vertex, vertex + 3);
    }
    least = std::min(least, distance_of(a, identity, make_of_kind("triangle", corners, {}), over));
  }
  EXPECT_GT(least, 0);
  EXPECT_NEAR(distance_of(a, identity, b, over), least, 1e-9);
  EXPECT_TRUE(contacts_of(a, identity, b, over).empty());
  over.position.z -= least + 0.4;
  const std::vector<abut_contact> contacts = contacts_of(a, identity, b, over);
  ASSERT_FALSE(contacts.empty());
  for (const abut_contact& contact : contacts) EXPECT_GT(contact.normal.z, 0);
}

TEST(HeightField, LyingOverAnotherMeetsItsBackOnly) {
  const std::vector<double> heights = hills(12, 34);
  const Shape a = make_of_kind("height_field", {12, 12, 1, 1, 0}, heights);
  EXPECT_TRUE(contacts_of(a, identity, a, at(0, 0, 0.5)).empty());
}

// Neither moves: nothing is asked.
TEST(Terrain, OfStaticPartsIsNoPair) {
  Universe universe;
  universe.add(make_plane({0, 0, 1}, 0), identity, ABUT_MOTION_STATIC);
  universe.add(make_of_kind("height_field", {3, 3, 1, 1, 0}, std::vector(9, -1.0)), identity, ABUT_MOTION_STATIC);
  EXPECT_TRUE(universe.step().empty());
  EXPECT_EQ(universe.stats().candidate_pairs, 0U);
  EXPECT_EQ(universe.stats().examined_pairs, 0U);
}

TEST(HeightField, LetsWhatStandsOnAHoleFall) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Universe universe;
  const abut_geometry_id ground =
      universe.add(make_of_kind("height_field", {7, 7, 1, 1, 1}, std::vector(49, 0.0)), identity, ABUT_MOTION_STATIC);
  universe.add(make_sphere(0.5), at(3, 3, 0.49));
  EXPECT_EQ(universe.step().size(), 1U);
  ASSERT_TRUE(succeeded(abut_geometry_set_heights(universe, ground, 3, 3, 1, 1, &nan)));
  EXPECT_TRUE(universe.step().empty());
  const double flat = 0;
  ASSERT_TRUE(succeeded(abut_geometry_set_heights(universe, ground, 3, 3, 1, 1, &flat)));
  EXPECT_EQ(universe.step().size(), 1U);
}

// A saved universe has the same holes.
TEST(HeightField, KeepsItsHolesInASavedUniverse) {
  std::vector<double> heights(49, 0.0);
  heights[24] = std::numeric_limits<double>::quiet_NaN();
  Universe universe;
  universe.add(make_of_kind("height_field", {7, 7, 1, 1, 2}, heights), identity, ABUT_MOTION_STATIC);
  universe.add(make_sphere(0.3), at(3, 3, 0.1));
  universe.add(make_sphere(0.3), at(1, 1, 0.1));
  EXPECT_EQ(universe.step().size(), 1U);
  std::size_t size = 0;
  ASSERT_TRUE(succeeded(abut_universe_save(universe, nullptr, 0, &size)));
  std::vector<unsigned char> bytes(size);
  ASSERT_TRUE(succeeded(abut_universe_save(universe, bytes.data(), bytes.size(), &size)));
  abut_universe* loaded = nullptr;
  ASSERT_TRUE(succeeded(abut_universe_load(bytes.data(), bytes.size(), &loaded)));
  ASSERT_TRUE(succeeded(abut_universe_step(loaded, 0)));
  abut_step_stats stats;
  abut_step_stats_init(&stats, sizeof stats);
  ASSERT_TRUE(succeeded(abut_universe_stats(loaded, &stats)));
  EXPECT_EQ(stats.contacts, 1U);
  abut_universe_destroy(loaded);
}

// Before any is left out: which ones hold a patch depends on the numbers of triangles that tie.
std::vector<abut_contact> all_contacts_of(const Shape& surface, const Shape& other, const abut_pose& pose) {
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.max_contacts = 0;
  std::vector<abut_contact> contacts(256);
  std::size_t count = 0;
  require(abut_pair_contacts(surface, &identity, other, &pose, &options, contacts.data(), contacts.size(), &count));
  contacts.resize(count);
  return contacts;
}

// The same triangles, found by a tree or by a grid.
TEST(UvGrid, AnswersAsTheMeshOfTheSameTriangles) {
  const Shape field = make_of_kind("height_field", {20, 20, 0.5, 0.5, 2}, hills(20, 35));
  const auto [xyz, indices] = triangles_of(field);
  const Shape mesh = make_of_kind("mesh", {1}, xyz, indices),
              grid = make_of_kind("uv_grid", {1, 0, 1, 0, 0}, xyz, indices);
  const std::array shapes{make_sphere(0.4),       make_box(0.5, 0.3, 0.2),
                          make_capsule(0.2, 0.4), make_plane({0, 0, 1}, -0.25),
                          make_octahedron(0.5),   make_of_kind("particles", {0.1}, {0, 0, 0, 0.3, 0, 0})};
  std::mt19937 random(36);
  std::uniform_real_distribution<double> place(0.5, 9);
  int touching = 0;
  for (int i = 0; i < 120; ++i) {
    const Shape& other = shapes.at(static_cast<std::size_t>(i) % shapes.size());
    const abut_pose pose = at(place(random), place(random), 0.1 * place(random) - 0.1);
    EXPECT_NEAR(distance_of(grid, identity, other, pose), distance_of(mesh, identity, other, pose), 1e-9);
    // Of triangles that are equally near, either may name the contact.
    const std::vector<abut_contact> of_mesh = all_contacts_of(mesh, other, pose),
                                    of_grid = all_contacts_of(grid, other, pose);
    touching += of_mesh.empty() ? 0 : 1;
    ASSERT_EQ(of_grid.size(), of_mesh.size()) << i;
    for (std::size_t k = 0; k < of_mesh.size(); ++k) {
      EXPECT_NEAR(of_grid[k].distance, of_mesh[k].distance, 1e-12) << i;
    }
  }
  EXPECT_GT(touching, 30);
}

// A mesh in all that it answers, and a kind by its name and numbers: also after changes, and in a saved universe.
TEST(UvGrid, StaysOfItsKind) {
  const abut_shape_kind kind = abut_shape_kind_by_name("uv_grid"), mesh = abut_shape_kind_by_name("mesh");
  const auto expect_grid = [&](const abut_shape* shape) {
    EXPECT_EQ(abut_shape_kind_of(shape), kind);
    std::array<double, 5> parameters{};
    std::size_t count = 0;
    require(abut_shape_parameters(shape, parameters.data(), parameters.size(), &count));
    EXPECT_EQ(count, 5U);
    EXPECT_EQ(parameters, (std::array<double, 5>{1, 1, 0, 3, 0}));
  };
  Universe universe;
  const abut_geometry_id ground = universe.add(
      make_of_kind("uv_grid", {1, 1, 0, 3, 0}, {0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0}, {0, 1, 2, 0, 2, 3}), identity);
  expect_grid(universe.describe(ground).shape);
  EXPECT_EQ(universe.describe(ground).kind, kind);
  constexpr std::array<double, 3> raised{4, 4, 0.5};
  require(abut_geometry_set_vertices(universe, ground, 2, raised.data(), 1));
  constexpr double height = 1;
  EXPECT_EQ(abut_geometry_set_heights(universe, ground, 0, 0, 1, 1, &height), ABUT_UNSUPPORTED);
  EXPECT_NE(std::string(abut_last_error_message()).find("geometry is a uv_grid, which has no"), std::string::npos);
  expect_grid(universe.describe(ground).shape);
  std::size_t size = 0;
  require(abut_universe_save(universe, nullptr, 0, &size));
  std::vector<unsigned char> bytes(size);
  require(abut_universe_save(universe, bytes.data(), bytes.size(), &size));
  abut_universe* loaded = nullptr;
  require(abut_universe_load(bytes.data(), bytes.size(), &loaded));
  abut_geometry_info info;
  abut_geometry_info_init(&info, sizeof info);
  require(abut_geometry_describe(loaded, ground, &info));
  EXPECT_EQ(info.kind, kind);
  expect_grid(info.shape);
  constexpr std::array<double, 3> aside{4.5, 4, 0.5};
  EXPECT_EQ(abut_geometry_set_vertices(loaded, ground, 2, aside.data(), 1), ABUT_OUT_OF_RANGE);
  abut_universe_destroy(loaded);
  for (std::size_t i = 0; i < abut_shape_kind_count(); ++i) {
    std::uint32_t as_grid = 2, as_mesh = 2;
    require(abut_pair_support(kind, abut_shape_kind_at(i), ABUT_QUERY_DISTANCE, &as_grid));
    require(abut_pair_support(mesh, abut_shape_kind_at(i), ABUT_QUERY_DISTANCE, &as_mesh));
    EXPECT_EQ(as_grid, as_mesh) << abut_shape_kind_name(abut_shape_kind_at(i));
  }
}

}  // namespace
