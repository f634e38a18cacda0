// SPDX-License-Identifier: Apache-2.0
// Changes of shapes in use under bad input: each is refused with the word for what is wrong, and leaves the universe as
// it was.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

// A height field of 4 x 3 samples and particles with one radius and with their own, beside the geometries of a scene.
struct Edited : Scene {
  Edited() {
    field = universe.add(make_of_kind("height_field", {4, 3, 1, 1}, std::vector(12, 0.0)), at(20, 0, 0),
                         ABUT_MOTION_STATIC);
    alike = universe.add(make_of_kind("particles", {0.5}, {0, 0, 0, 2, 0, 0}), at(30, 0, 0));
    various = universe.add(make_of_kind("particles", {0}, {0, 0, 0, 1, 2, 0, 0, 1}), at(40, 0, 0));
    universe.step();
    before = snapshot(universe);
  }
  bool is_as_before() const { return snapshot(universe) == before; }

  abut_geometry_id field{}, alike{}, various{};
  std::vector<unsigned char> before;
};

constexpr std::array<double, 1> radius{2.0};
constexpr std::array<double, 12> zeros{};

TEST(GeometrySetParameters, RefusesNullPointers) {
  const Edited scene;
  EXPECT_TRUE(refused(abut_geometry_set_parameters(nullptr, scene.geometry, radius.data(), 1), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
  EXPECT_TRUE(refused(abut_geometry_set_parameters(scene.universe, scene.geometry, nullptr, 1), ABUT_NULL_ARGUMENT,
                      {"parameters", "null"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetParameters, RefusesWhatCreationRefuses) {
  const Edited scene;
  const std::array<double, 3> sizes{1, 1, -2};
  EXPECT_TRUE(refused(abut_geometry_set_parameters(scene.universe, scene.second_geometry, sizes.data(), 3),
                      ABUT_OUT_OF_RANGE, {"half_z", "-2"}));
  EXPECT_TRUE(refused(abut_geometry_set_parameters(scene.universe, scene.second_geometry, sizes.data(), 2),
                      ABUT_INVALID_ARGUMENT, {"parameter_count", "2", "3"}));
  EXPECT_TRUE(refused(abut_geometry_set_parameters(scene.universe, scene.geometry, nullptr, 0), ABUT_INVALID_ARGUMENT,
                      {"parameter_count", "0", "1"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetParameters, RefusesKindsThatAreMadeOfMore) {
  const Edited scene;
  for (const abut_geometry_id geometry : {scene.field, scene.alike}) {
    EXPECT_TRUE(refused(abut_geometry_set_parameters(scene.universe, geometry, radius.data(), 1), ABUT_UNSUPPORTED,
                        {"geometry", geometry == scene.field ? "height_field" : "particles", "parameters"}));
  }
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometriesSetParameters, RefusesNonFiniteNumbersAndSetsNone) {
  const Edited scene;
  const std::array ids{scene.geometry, scene.geometry};
  expect_non_finite_refused("geometries[1]: radius", [&](double bad) {
    const std::array radii{2.0, bad};
    return abut_geometries_set_parameters(scene.universe, ids.data(), radii.data(), 1, 2);
  });
  const std::array mixed{scene.geometry, scene.second_geometry};
  const std::array radii{2.0, 2.0};
  EXPECT_TRUE(refused(abut_geometries_set_parameters(scene.universe, mixed.data(), radii.data(), 1, 2),
                      ABUT_INVALID_ARGUMENT, {"geometries[1]", "parameter_count", "1", "3"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetHeights, RefusesToTakeTheLastTriangle) {
  const Edited scene;
  const std::vector<double> holes(9, std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(refused(abut_geometry_set_heights(scene.universe, scene.field, 0, 0, 3, 3, holes.data()), ABUT_EMPTY,
                      {"heights"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetHeights, RefusesSamplesBeyondTheField) {
  const Edited scene;
  const auto set = [&](std::uint32_t column, std::uint32_t row, std::uint32_t columns, std::uint32_t rows) {
    return abut_geometry_set_heights(scene.universe, scene.field, column, row, columns, rows, zeros.data());
  };
  EXPECT_TRUE(refused(set(5, 0, 0, 1), ABUT_INDEX_OUT_OF_RANGE, {"column is 5", "4"}));
  EXPECT_TRUE(refused(set(0, 4, 1, 0), ABUT_INDEX_OUT_OF_RANGE, {"row is 4", "3"}));
  EXPECT_TRUE(refused(set(3, 0, 2, 1), ABUT_INDEX_OUT_OF_RANGE, {"columns is 2", "1"}));
  EXPECT_TRUE(refused(set(0, 2, 1, 2), ABUT_INDEX_OUT_OF_RANGE, {"rows is 2", "1"}));
  EXPECT_TRUE(refused(set(1, 0, 0xFFFFFFFF, 0), ABUT_INDEX_OUT_OF_RANGE, {"columns is 4294967295", "3"}));
  EXPECT_TRUE(refused(set(0, 0, 0xFFFFFFFF, 0xFFFFFFFF), ABUT_SIZE_OVERFLOW, {"columns * rows", "4294967295"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetHeights, RefusesOtherKinds) {
  const Edited scene;
  EXPECT_TRUE(refused(abut_geometry_set_heights(scene.universe, scene.second_geometry, 0, 0, 1, 1, zeros.data()),
                      ABUT_UNSUPPORTED, {"geometry", "box", "heights"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetParticles, RefusesNegativeRadii) {
  const Edited scene;
  const std::array radii{1.0, -0.5};
  EXPECT_TRUE(refused(abut_geometry_set_particles(scene.universe, scene.various, 0, zeros.data(), radii.data(), 2),
                      ABUT_OUT_OF_RANGE, {"radii[1]", "-0.5"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetParticles, RefusesRadiiOfParticlesThatAreAlike) {
  const Edited scene;
  EXPECT_TRUE(refused(abut_geometry_set_particles(scene.universe, scene.alike, 0, zeros.data(), zeros.data(), 1),
                      ABUT_UNSUPPORTED, {"radii", "in common"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetParticles, RefusesParticlesBeyondTheLast) {
  const Edited scene;
  const auto set = [&](std::size_t first, std::size_t count) {
    return abut_geometry_set_particles(scene.universe, scene.alike, first, zeros.data(), nullptr, count);
  };
  EXPECT_TRUE(refused(set(3, 0), ABUT_INDEX_OUT_OF_RANGE, {"first is 3", "2"}));
  EXPECT_TRUE(refused(set(1, 2), ABUT_INDEX_OUT_OF_RANGE, {"count is 2", "1"}));
  EXPECT_TRUE(refused(set(size_max, 1), ABUT_INDEX_OUT_OF_RANGE, {"first is 18446744073709551615"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetParticles, RefusesOtherKinds) {
  const Edited scene;
  EXPECT_TRUE(refused(abut_geometry_set_particles(scene.universe, scene.field, 0, zeros.data(), nullptr, 1),
                      ABUT_UNSUPPORTED, {"geometry", "height_field", "centres"}));
  EXPECT_TRUE(scene.is_as_before());
}

}  // namespace
