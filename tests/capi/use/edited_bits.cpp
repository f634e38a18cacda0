// SPDX-License-Identifier: Apache-2.0
// What is found with an edited mesh does not depend on the form that its tree has: one that was loaded has another one.
#include <array>
#include <cmath>
#include <random>

#include "../../unit/damaged_meshes.hpp"
#include "../archive_support.hpp"

namespace {

using namespace abut_test;

void expect_same_bits(abut_universe* universe) {
  const Owned other = loaded(saved(universe));
  const auto hash_of = [](abut_universe* its) {
    std::uint64_t hash = 0;
    require(abut_universe_detect_all(its));
    require(abut_universe_hash(its, &hash));
    return hash;
  };
  EXPECT_EQ(hash_of(universe), hash_of(other.get()));
}

TEST(EditedMesh, GivesTheBitsThatALoadedOneGives) {
  const std::vector<double> xyz{0,
                                0,
                                -0.079681469389098744,
                                0.29999999999999999,
                                0,
                                -0.10016663852337457,
                                0.59999999999999998,
                                0,
                                0.0011640015212882604,
                                0.89999999999999991,
                                0,
                                0.057990517751481174,
                                0,
                                0.29999999999999999,
                                0.13279958929536609,
                                0.29999999999999999,
                                0.29999999999999999,
                                -0.022913502114381534,
                                0.59999999999999998,
                                0.29999999999999999,
                                -0.016832150046223127,
                                0.89999999999999991,
                                0.29999999999999999,
                                0.094239146234445376,
                                0,
                                0.59999999999999998,
                                -0.14581100711172032,
                                0.29999999999999999,
                                0.59999999999999998,
                                -0.01775711524846732,
                                0.59999999999999998,
                                0.59999999999999998,
                                0.084756476374497014,
                                0.89999999999999991,
                                0.59999999999999998,
                                -0.067983850367526757,
                                0,
                                0.89999999999999991,
                                0.076789702514635932,
                                0.29999999999999999,
                                0.89999999999999991,
                                -0.018526223980423029,
                                0.59999999999999998,
                                0.89999999999999991,
                                -0.12663271158896636,
                                0.89999999999999991,
                                0.89999999999999991,
                                -0.031072047074599304};
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t first : {0U, 1U, 2U, 4U, 5U, 6U, 8U, 9U, 10U}) {
    triangles.insert(triangles.end(), {first, first + 1, first + 4, first + 1, first + 5, first + 4});
  }
  Universe universe;
  const abut_geometry_id mesh = universe.add(make_of_kind("mesh", {0}, xyz, triangles), identity, ABUT_MOTION_STATIC);
  universe.add(make_box(0.13788284222408215, 0.47894836807582297, 0.40579352904526318),
               {{0.82193529277216759, 0.52153527288593293, 0.27200539576916904},
                {-0.62418272255314367, 0.27639380116673529, -0.23684707286734985, 0.69130735539043464}});
  universe.step();
  const std::array<double, 12> first{0.84031454751398871,   0.39487029699429876, 0.18973106294439818,
                                     -0.011247526957070805, 0.67260545604136368, -0.061511506060549087,
                                     0.32801922711887255,   0.66095929745802928, -0.080035597902726269,
                                     0.63311267070246413,   0.53473358206110699, 0.14595423618596734};
  const std::array<double, 3> second{0.023695701937204203, 0.80928009130193279, 0.1565188431103717};
  const std::array<double, 6> third{0.34931300710458901, 0.86433280133548906, 0.025774907020849558,
                                    0.57276533579728806, 0.95215479268598646, -0.12893204532589608};
  require(abut_geometry_set_vertices(universe, mesh, 7, first.data(), 4));
  require(abut_geometry_set_vertices(universe, mesh, 12, second.data(), 1));
  require(abut_geometry_set_vertices(universe, mesh, 13, third.data(), 2));
  expect_same_bits(universe);
}

// Convex bodies and closed meshes in a ring that is edited.
TEST(EditedSolid, GivesTheBitsThatALoadedOneGives) {
  constexpr std::uint32_t seed = 41;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937_64 random(seed);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const test::Surface small = test::torus(0.4, 0.15, 8, 6);
  for (int scene = 0; scene < 60; ++scene) {
    SCOPED_TRACE(testing::Message() << "scene " << scene);
    test::Surface ring = test::torus(0.6, 0.25, 10, 6);
    Universe universe;
    const abut_geometry_id mesh =
        universe.add(make_of_kind("mesh", {2}, ring.xyz, ring.triangles), identity, ABUT_MOTION_STATIC);
    for (int body = 0; body < 2; ++body) {
      const double w = number(-1, 1), x = number(-1, 1), y = number(-1, 1), z = number(-1, 1);
      const double length = std::hypot(std::hypot(w, x), std::hypot(y, z));
      const abut_pose pose{{number(-0.6, 0.6), number(-0.6, 0.6), number(-0.2, 0.4)},
                           {w / length, x / length, y / length, z / length}};
      const std::uint64_t kind = random() % 4;
      const double size = number(0.1, 0.5), other = number(0.1, 0.5);
      universe.add(kind == 0   ? make_of_kind("cylinder", {size, other})
                   : kind == 1 ? make_of_kind("cone", {size, other})
                   : kind == 2 ? make_box(size, other, number(0.1, 0.5))
                               : make_of_kind("mesh", {2}, small.xyz, small.triangles),
                   pose);
    }
    universe.step();
    for (std::uint64_t edit = random() % 4 + 1; edit > 0; --edit) {
      const std::size_t first = random() % (ring.xyz.size() / 3 - 4), count = random() % 4 + 1;
      for (std::size_t i = 3 * first; i < 3 * (first + count); ++i) ring.xyz[i] += number(-0.2, 0.2);
      require(abut_geometry_set_vertices(universe, mesh, first, &ring.xyz[3 * first], count));
      if (random() % 3 == 0) universe.step();
    }
    expect_same_bits(universe);
  }
}

}  // namespace
