// SPDX-License-Identifier: Apache-2.0
// What a solid mesh has inside after its vertices have moved, beside a mesh that is made anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "../../damaged_meshes.hpp"
#include "../surfaces.hpp"

import abut.capability;
import abut.math;
import abut.shapes.mesh;

namespace {

using abut::Mesh;
using abut::Vec3;

// Two tori, one of them with a patch that is wound the wrong way.
test::Surface two_pieces() {
  test::Surface out = test::torus(2, 0.7, 16, 8);
  const test::Surface other = test::torus(1, 0.3, 24, 12);
  const auto first = static_cast<std::uint32_t>(out.xyz.size() / 3);
  for (std::size_t i = 0; i < other.xyz.size(); ++i) {
    out.xyz.push_back(other.xyz[i] + (i % 3 == 2 ? 2 : 0));
  }
  for (std::size_t i = 0; i < other.triangles.size(); i += 3) {
    const bool is_turned = i < 6;
    out.triangles.insert(out.triangles.end(),
                         {first + other.triangles[i], first + other.triangles[i + (is_turned ? 2 : 1)],
                          first + other.triangles[i + (is_turned ? 1 : 2)]});
  }
  return out;
}

Mesh solid(const test::Surface& surface) { return test::made<Mesh>({2}, surface.xyz, surface.triangles); }

void expect_same_inside(const Mesh& moved, const Mesh& anew, std::mt19937& random) {
  std::uniform_real_distribution<double> at(-3.5, 3.5);
  for (int i = 0; i < 100; ++i) {
    const Vec3 point{at(random), at(random), at(random)};
    EXPECT_EQ(moved.contains(point), anew.contains(point)) << point.x << ' ' << point.y << ' ' << point.z;
  }
  for (std::uint32_t triangle = 0; triangle < moved.triangle_count(); ++triangle) {
    EXPECT_EQ(moved.is_turned(triangle), anew.is_turned(triangle)) << triangle;
  }
  EXPECT_TRUE(std::ranges::equal(moved.pieces(), anew.pieces()));
}

TEST(MeshInside, FollowsVerticesThatMove) {
  constexpr std::uint32_t seed = 21;
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(-1, 1);
  for (const bool is_damaged : {false, true}) {
    test::Surface surface = is_damaged ? test::damaged(two_pieces(), 0.03, seed) : two_pieces();
    Mesh mesh = solid(surface);
    std::size_t turned = 0;
    for (int edit = 0; edit < 60; ++edit) {
      EXPECT_EQ(mesh.contains({2, 0, 0}), solid(surface).contains({2, 0, 0})) << "made where it is asked";
      const auto all = static_cast<std::uint32_t>(surface.xyz.size() / 3);
      const std::uint32_t count = 1 + random() % 3, first = random() % (all - count);
      // One in eight edits takes vertices far out, and the next time back.
      const double reach = edit % 8 == 7 ? 20 : 0.1;
      for (std::size_t i = 3 * std::size_t{first}; i < 3 * std::size_t{first + count}; ++i) {
        surface.xyz[i] = std::clamp(surface.xyz[i] + reach * share(random), -4.0, 4.0);
      }
      const abut::VertexEdit change{
          .first = first,
          .vertices = {},
          .xyz = std::span<const double>(surface.xyz).subspan(3 * std::size_t{first}, 3 * std::size_t{count})};
      mesh.own();
      mesh.make_room(change);
      static_cast<void>(mesh.apply(change));
      const Mesh anew = solid(surface);
      expect_same_inside(mesh, anew, random);
      for (std::uint32_t triangle = 0; triangle < anew.triangle_count(); ++triangle) {
        turned += anew.is_turned(triangle) ? 1 : 0;
      }
    }
    EXPECT_GT(turned, 0u) << "none is wound the wrong way";
  }
}

// Turned inside out vertex by vertex.
TEST(MeshInside, FollowsAPieceThatIsTurnedInsideOut) {
  constexpr std::uint32_t seed = 22;
  std::mt19937 random(seed);
  test::Surface surface = test::torus(2, 0.7, 16, 8);
  Mesh mesh = solid(surface);
  for (std::uint32_t vertex = 0; vertex < surface.xyz.size() / 3; ++vertex) {
    static_cast<void>(mesh.contains({2, 0, 0}));
    surface.xyz[3 * std::size_t{vertex}] *= -1;
    const abut::VertexEdit change{.first = vertex,
                                  .vertices = {},
                                  .xyz = std::span<const double>(surface.xyz).subspan(3 * std::size_t{vertex}, 3)};
    mesh.own();
    mesh.make_room(change);
    static_cast<void>(mesh.apply(change));
  }
  expect_same_inside(mesh, solid(surface), random);
}

}  // namespace
