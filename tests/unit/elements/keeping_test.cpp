// SPDX-License-Identifier: Apache-2.0
// A surface has one contact where it is nearest, whatever its triangles are: none is lost, and none occurs again.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "folded_sheet.hpp"

import abut.elements.keeping;
import abut.elements.nearest;
import abut.math;

namespace {

using abut::FaceStencil;
using abut::Vec3;
using abut_test::FoldedSheet;

FaceStencil stencil_of(const FoldedSheet& mesh, std::uint32_t face, const Vec3& point) {
  std::array<std::uint32_t, 3> its{};
  std::array<Vec3, 3> corners{};
  for (std::size_t i = 0; i < 3; ++i) {
    its.at(i) = mesh.triangles[3 * std::size_t{face} + i];
    corners.at(i) = mesh.vertices[its.at(i)];
  }
  return abut::face_stencil(0, face, its, abut::nearest_on_face(point, corners));
}

double size_of(const FoldedSheet& mesh) {
  double size = 0;
  for (const Vec3& vertex : mesh.vertices) {
    size = std::max(size, abut::largest_magnitude(vertex));
  }
  return size;
}

std::vector<FaceStencil> kept(const FoldedSheet& mesh, const Vec3& point) {
  std::vector<FaceStencil> all;
  for (std::uint32_t face = 0; face < mesh.triangles.size() / 3; ++face) {
    all.push_back(stencil_of(mesh, face, point));
  }
  all.resize(abut::keep_closest(all, mesh.triangles, mesh.vertices, 64 * abut::epsilon * size_of(mesh)));
  return all;
}

// The vertices of the features as the first numbering has them, and the distances.
std::set<std::pair<std::vector<std::uint32_t>, double>> features(const std::vector<FaceStencil>& stencils,
                                                                 const std::vector<std::uint32_t>& first_number) {
  std::set<std::pair<std::vector<std::uint32_t>, double>> out;
  for (const FaceStencil& stencil : stencils) {
    std::vector<std::uint32_t> its;
    for (std::size_t i = 0; i < stencil.count; ++i) {
      its.push_back(first_number[stencil.feature.at(i)]);
    }
    std::ranges::sort(its);
    out.insert({its, stencil.square});
  }
  return out;
}

FoldedSheet grid(double bump) {
  FoldedSheet mesh;
  for (std::uint32_t i = 0; i < 14; ++i) {
    for (std::uint32_t j = 0; j < 14; ++j) {
      mesh.vertices.push_back({0.1 * i, 0.1 * j, bump * ((i * 7 + j * 3) % 4)});
      if (i < 13 && j < 13) {
        const std::uint32_t a = 14 * i + j, b = a + 14;
        mesh.triangles.insert(mesh.triangles.end(), {a, b, b + 1, a, b + 1, a + 1});
      }
    }
  }
  return mesh;
}
FoldedSheet tilted_grid() {
  FoldedSheet mesh = grid(0);
  for (Vec3& vertex : mesh.vertices) {
    vertex = vertex.x * Vec3{0.8, -0.36, -0.48} + vertex.y * Vec3{0, 0.8, -0.6};
  }
  return mesh;
}
// A closed surface: the sides of a cube, blown up to a ball with bumps.
FoldedSheet ball(std::mt19937& random) {
  std::uniform_real_distribution<double> radius(0.9, 1.1);
  FoldedSheet mesh;
  constexpr std::uint32_t squares = 5;
  std::vector<std::array<int, 3>> places;
  const auto vertex_at = [&](const std::array<int, 3>& place) {
    const auto found = std::ranges::find(places, place);
    if (found == places.end()) {
      places.push_back(place);
      const Vec3 at{place[0] - 2.5, place[1] - 2.5, place[2] - 2.5};
      mesh.vertices.push_back(radius(random) / abut::norm(at) * at);
    }
    return static_cast<std::uint32_t>(std::ranges::find(places, place) - places.begin());
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, 5}) {
      for (std::uint32_t i = 0; i < squares * squares; ++i) {
        std::array<std::uint32_t, 4> corners{};
        for (std::size_t k = 0; k < 4; ++k) {
          std::array<int, 3> place{};
          place.at(axis) = side;
          place.at((axis + 1) % 3) = static_cast<int>(i % squares + (k == 1 || k == 2 ? 1 : 0));
          place.at((axis + 2) % 3) = static_cast<int>(i / squares + (k > 1 ? 1 : 0));
          corners.at(k) = vertex_at(place);
        }
        mesh.triangles.insert(mesh.triangles.end(),
                              {corners[0], corners[1], corners[2], corners[0], corners[2], corners[3]});
      }
    }
  }
  return mesh;
}

// Over the inside of a triangle, its edges and its corners.
Vec3 point_over(const FoldedSheet& mesh, int kind, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0, 1);
  const std::size_t first = 3 * (random() % (mesh.triangles.size() / 3));
  const Vec3 a = mesh.vertices[mesh.triangles[first]], b = mesh.vertices[mesh.triangles[first + 1]],
             c = mesh.vertices[mesh.triangles[first + 2]];
  const Vec3 normal = abut::cross(b - a, c - a);
  double of_a = share(random), of_b = (1 - of_a) * share(random);
  if (kind % 4 != 0) {
    of_a = kind % 4 == 1 ? 0.5 : kind % 4 == 2 ? 1 : 0.25;
    of_b = 1 - of_a;
  }
  return of_a * a + of_b * b + (1 - of_a - of_b) * c + (0.02 * (2 * share(random) - 1) / abut::norm(normal)) * normal;
}

bool share_vertex(const FaceStencil& a, const FaceStencil& b) {
  return std::any_of(a.feature.begin(), a.feature.begin() + a.count,
                     [&](std::uint32_t vertex) { return std::ranges::find(b.feature, vertex) != b.feature.end(); });
}

bool touches(const FoldedSheet& mesh, std::uint32_t face, const FaceStencil& other) {
  return std::any_of(other.feature.begin(), other.feature.begin() + other.count, [&](std::uint32_t vertex) {
    const auto corners = std::span(mesh.triangles).subspan(3 * std::size_t{face}, 3);
    return std::ranges::find(corners, vertex) != corners.end();
  });
}

void check(const FoldedSheet& mesh, int points, std::mt19937& random) {
  const double size = size_of(mesh);
  for (int kind = 0; kind < points; ++kind) {
    const Vec3 point = point_over(mesh, kind, random);
    const std::vector<FaceStencil> got = kept(mesh, point);

    // The nearest triangle counts, and so does each that is nearer than all triangles with a vertex of its feature.
    std::vector<FaceStencil> all;
    for (std::uint32_t face = 0; face < mesh.triangles.size() / 3; ++face) {
      all.push_back(stencil_of(mesh, face, point));
    }
    for (const FaceStencil& its : all) {
      ASSERT_LE(got[0].square, its.square);
      const bool is_least = std::ranges::none_of(
          all, [&](const FaceStencil& other) { return touches(mesh, other.face, its) && other.square < its.square; });
      ASSERT_TRUE(!is_least ||
                  std::ranges::any_of(
                      got, [&](const FaceStencil& one) { return one.square == its.square && share_vertex(one, its); }))
          << "point " << kind << ", face " << its.face;
    }
    // No place occurs again.
    for (std::size_t i = 0; i < got.size(); ++i) {
      for (std::size_t j = i + 1; j < got.size(); ++j) {
        ASSERT_FALSE(abut::norm(got[i].point - got[j].point) < 1e-14 * size && share_vertex(got[i], got[j])) << kind;
      }
    }
    std::vector<std::uint32_t> same(mesh.vertices.size()), number;
    std::iota(same.begin(), same.end(), 0u);
    const FoldedSheet other = abut_test::renumbered(mesh, random, number);
    std::vector<std::uint32_t> first_number(number.size());
    for (std::uint32_t i = 0; i < number.size(); ++i) {
      first_number[number[i]] = i;
    }
    ASSERT_EQ(features(kept(other, point), first_number), features(got, same)) << kind;
  }
}

TEST(KeepClosest, LosesNoneAndRepeatsNoneUnderAnyNumbering) {
  constexpr std::uint32_t seed = 7;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  for (const FoldedSheet& mesh :
       {grid(0), grid(0.03), tilted_grid(), ball(random), abut_test::folded_sheet(14, 0.01, random)}) {
    check(mesh, 600, random);
  }
}

// Over the inner corner of a flat grid six faces name this corner, and over the inside of a face one.
TEST(KeepClosest, FlatSurfaceGivesOne) {
  const FoldedSheet flat = grid(0), tilted = tilted_grid();
  std::mt19937 random(9);
  for (const FoldedSheet* mesh : {&flat, &tilted}) {
    for (int kind = 0; kind < 400; ++kind) {
      EXPECT_EQ(kept(*mesh, point_over(*mesh, kind, random)).size(), 1u) << kind;
    }
  }
}

// Both sides of a valley, and both layers of two sheets that touch.
TEST(KeepClosest, ValleyAndLayersGiveTwo) {
  const FoldedSheet valley{{{0, 0, 0}, {1, 0, 0}, {0.5, -1, 1}, {0.5, 1, 1}}, {0, 1, 2, 0, 1, 3}};
  EXPECT_EQ(kept(valley, {0.5, 0, 0.5}).size(), 2u);
  EXPECT_EQ(kept(valley, {0.5, 0, -0.5}).size(), 1u);
  const FoldedSheet layers{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2, 3, 4, 5}};
  EXPECT_EQ(kept(layers, {0.2, 0.2, 0.5}).size(), 2u);
}

}  // namespace
