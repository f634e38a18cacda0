// SPDX-License-Identifier: Apache-2.0
// Meshes that follow particles: bad input, ends, and bytes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "scene.hpp"

namespace {

using namespace response_test;

struct Soft {
  Scene scene;
  std::vector<double> corners{0, 0, 5, 1, 0, 5, 0, 1, 5, 0, 0, 6};
  std::vector<std::uint32_t> numbers{0, 1, 2, 3, 0, 1, 2, 3, 3, 2, 1, 0};
  std::vector<double> weights{0.25, 0.25, 0.25, 0.25, 0.5, 0.5, 0, 0, 1, 0, 0, 0};
  abut_part_id part{};
  abut_geometry_id carrier{}, skin{};

  Soft() {
    const Shape points =
        shape_from([&](abut_shape** out) { return abut_particles_create(corners.data(), 4, 0.1, out); });
    part = scene.place(points, {{0, 0, 0}, no_turn}, ABUT_MOTION_DYNAMIC);
    std::size_t found = 0;
    require(abut_part_geometries(scene.universe(), part, &carrier, 1, &found));
    skin = scene.attach(part, triangle(), {{0, 0, 0}, no_turn});
    add();
  }
  static Shape triangle() {
    constexpr std::array xyz{0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0};
    constexpr std::array<std::uint32_t, 3> face{0, 1, 2};
    return shape_from([&](abut_shape** out) { return abut_mesh_create(xyz.data(), 3, face.data(), 1, nullptr, out); });
  }
  void add() const {
    const std::vector<double> masses(4, 1);
    require(abut_response_add_particles(scene.response(), carrier, masses.data(), corners.data(), nullptr, 4));
  }
  [[nodiscard]] abut_status map(abut_geometry_id mesh, abut_geometry_id on, std::size_t count = 3) const {
    return abut_response_map_vertices(scene.response(), mesh, on, numbers.data(), weights.data(), count);
  }
  [[nodiscard]] double height_of_skin() const {
    const double* xyz = nullptr;
    std::size_t count = 0;
    require(abut_geometry_vertices(scene.universe(), skin, &xyz, &count));
    return xyz[2];
  }
  [[nodiscard]] std::uint64_t hash() const {
    std::uint64_t out = 0;
    require(abut_response_hash(scene.response(), &out));
    return out;
  }
};

TEST(SurfaceInput, IsRefusedWithTheNameOfWhatIsWrong) {
  Soft its;
  const abut_geometry_id other = its.scene.attach(its.part, block(1, 1, 1), {{0, 0, 0}, no_turn});
  const std::uint64_t before = its.hash();
  const double height = its.height_of_skin();
  const auto expect = [&](abut_status status, abut_status expected, const std::string& words) {
    EXPECT_EQ(status, expected) << words;
    EXPECT_NE(std::string(abut_last_error_message()).find(words), std::string::npos) << abut_last_error_message();
    EXPECT_EQ(its.hash(), before) << words;
    EXPECT_EQ(its.height_of_skin(), height) << words;
  };
  expect(its.map(its.skin, its.skin), ABUT_STALE_ID, "carrier.slot");
  expect(its.map({its.skin.slot, its.skin.generation + 1}, its.carrier), ABUT_STALE_ID, "surface");
  expect(its.map(other, its.carrier), ABUT_UNSUPPORTED, "surface.slot");
  expect(its.map(its.skin, its.carrier, 0), ABUT_OUT_OF_RANGE, "count");
  expect(abut_response_map_vertices(its.scene.response(), its.skin, its.carrier, nullptr, its.weights.data(), 3),
         ABUT_NULL_ARGUMENT, "numbers");
  expect(abut_response_map_vertices(its.scene.response(), its.skin, its.carrier, its.numbers.data(), nullptr, 3),
         ABUT_NULL_ARGUMENT, "weights");
  its.numbers[6] = 4;
  expect(its.map(its.skin, its.carrier), ABUT_INDEX_OUT_OF_RANGE, "numbers[6] is 4");
  its.numbers[6] = 2;
  its.weights[5] = 0.4;
  expect(its.map(its.skin, its.carrier), ABUT_OUT_OF_RANGE, "weights[4] is 0.5");
  its.weights[5] = std::nan("");
  expect(its.map(its.skin, its.carrier), ABUT_NOT_FINITE, "weights[5]");
  its.weights[5] = 2000;
  expect(its.map(its.skin, its.carrier), ABUT_OUT_OF_RANGE, "weights[5] is 2000");
  its.weights[5] = 0.5;
  // More vertices than the mesh has.
  its.numbers.insert(its.numbers.end(), {0, 1, 2, 3});
  its.weights.insert(its.weights.end(), {1, 0, 0, 0});
  expect(its.map(its.skin, its.carrier, 4), ABUT_INDEX_OUT_OF_RANGE, "");
  // A mesh of a body, and one whose vertices are bodies.
  const abut_part_id body = its.scene.body(ball(1), {{9, 0, 0}, no_turn}, 1);
  const abut_geometry_id held = its.scene.attach(body, Soft::triangle(), {{0, 0, 0}, no_turn});
  EXPECT_EQ(its.map(held, its.carrier), ABUT_INVALID_ARGUMENT);
  const std::vector<double> masses(3, 1);
  require(abut_response_add_particles(its.scene.response(), its.skin, masses.data(), its.corners.data(), nullptr, 3));
  EXPECT_EQ(its.map(its.skin, its.carrier), ABUT_INVALID_ARGUMENT);
  EXPECT_NE(std::string(abut_last_error_message()).find("surface.slot"), std::string::npos);
}

TEST(SurfaceInput, FollowsUntilItsEnd) {
  enum class End { mesh, carrier, particles, following };
  for (const End end : {End::mesh, End::carrier, End::particles, End::following}) {
    Soft its;
    require(its.map(its.skin, its.carrier));
    EXPECT_EQ(its.height_of_skin(), 5.25);
    its.scene.step(0.1);
    const double fallen = its.height_of_skin();
    EXPECT_NEAR(fallen, 5.25 - 0.5 * gravity * 0.01, 1e-12);
    switch (end) {
      case End::mesh: require(abut_geometry_destroy(its.scene.universe(), its.skin)); break;
      case End::carrier: require(abut_geometry_destroy(its.scene.universe(), its.carrier)); break;
      case End::particles: its.add(); break;
      case End::following: require(abut_response_remove_particles(its.scene.response(), its.skin)); break;
    }
    its.scene.step(0.1, 2);
    if (end != End::mesh) EXPECT_EQ(its.height_of_skin(), fallen);
    EXPECT_EQ(abut_response_remove_particles(its.scene.response(), its.skin), ABUT_STALE_ID);
  }
}

// Weights that are a little off 1 are those of the mean.
TEST(SurfaceInput, DividesWeightsByTheirSum) {
  Soft its;
  for (double& weight : its.weights) weight *= 1 + 5e-7;
  require(its.map(its.skin, its.carrier));
  EXPECT_NEAR(its.height_of_skin(), 5.25, 1e-15);
}

TEST(SurfaceInput, IsKeptInBytes) {
  Soft its;
  require(its.map(its.skin, its.carrier));
  its.scene.step(0.01, 3);
  std::size_t size = 0;
  require(abut_response_save(its.scene.response(), nullptr, 0, &size));
  std::vector<unsigned char> bytes(size);
  require(abut_response_save(its.scene.response(), bytes.data(), size, &size));
  abut_response* loaded = nullptr;
  require(abut_response_load(its.scene.universe(), bytes.data(), size, &loaded));
  std::uint64_t hash = 0;
  require(abut_response_hash(loaded, &hash));
  EXPECT_EQ(hash, its.hash());
  const double before = its.height_of_skin();
  require(abut_response_step(loaded, 0.1));
  EXPECT_LT(its.height_of_skin(), before - 0.04);
  abut_response_destroy(loaded);
}

}  // namespace
