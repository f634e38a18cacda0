// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "../../elements/folded_sheet.hpp"

import abut.core;
import abut.math;
import abut.triangles.elements;
import abut.trees.elements.element_pairs;
import abut.trees.elements.element_tree;

namespace {

using abut::Vec3;
using abut_test::FoldedSheet;
using Pairs = std::vector<std::array<std::uint32_t, 2>>;

struct Both {
  Pairs vertices_and_faces, edges;
};

void append(std::span<const abut::ElementPair> from, Pairs& to) { to.insert(to.end(), from.begin(), from.end()); }

Both candidates(const abut::ElementTree& tree, std::size_t least) {
  Both out;
  abut::Candidates found;
  abut::NodePairs pairs;
  pairs.cut(tree, tree, least);
  for (const abut::NodePair& pair : pairs.list()) {
    found.clear();
    abut::append_candidates(tree, tree, pair, found);
    append(found.vertices_and_faces.list(), out.vertices_and_faces);
    append(found.edges.list(), out.edges);
  }
  for (auto& edges : out.edges) {
    std::ranges::sort(edges);
  }
  std::ranges::sort(out.vertices_and_faces);
  std::ranges::sort(out.edges);
  return out;
}

struct Box {
  std::array<double, 3> low, high;
};
Box around(std::span<const std::uint32_t> corners, const std::vector<Vec3>& start, const std::vector<Vec3>& end,
           double reach) {
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    box.low.at(at) = abut::infinity;
    box.high.at(at) = -abut::infinity;
    for (const std::uint32_t corner : corners) {
      box.low.at(at) = std::min({box.low.at(at), start[corner][axis] - reach, end[corner][axis] - reach});
      box.high.at(at) = std::max({box.high.at(at), start[corner][axis] + reach, end[corner][axis] + reach});
    }
  }
  return box;
}
bool overlap(const Box& a, const Box& b) {
  bool all = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    all = all && a.low.at(axis) <= b.high.at(axis) && b.low.at(axis) <= a.high.at(axis);
  }
  return all;
}
bool share(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b) {
  return std::ranges::any_of(a, [&](std::uint32_t vertex) { return std::ranges::find(b, vertex) != b.end(); });
}

// All pairs, one after the other.
Both by_brute_force(const FoldedSheet& sheet, const std::vector<Vec3>& end, const abut::ElementTable& table,
                    double reach) {
  Both out;
  const std::size_t count = sheet.triangles.size() / 3;
  std::vector<bool> is_used(sheet.vertices.size());
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corners = std::span(sheet.triangles).subspan(3 * i, 3);
      is_used[corners[k]] = is_used[corners[k]] || !(corners[0] == corners[1] && corners[1] == corners[2]);
    }
  }
  for (std::uint32_t vertex = 0; vertex < sheet.vertices.size(); ++vertex) {
    const std::array<std::uint32_t, 1> own{vertex};
    for (std::uint32_t face = 0; face < count; ++face) {
      const auto corners = std::span(sheet.triangles).subspan(3 * std::size_t{face}, 3);
      const bool is_face = corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0];
      if (is_used[vertex] && is_face && !share(own, corners) &&
          overlap(around(own, sheet.vertices, end, reach), around(corners, sheet.vertices, end, reach))) {
        out.vertices_and_faces.push_back({vertex, face});
      }
    }
  }
  for (std::uint32_t a = 0; a < table.edges().size(); ++a) {
    for (std::uint32_t b = a + 1; b < table.edges().size(); ++b) {
      if (!share(table.edges()[a], table.edges()[b]) && overlap(around(table.edges()[a], sheet.vertices, end, reach),
                                                                around(table.edges()[b], sheet.vertices, end, reach))) {
        out.edges.push_back({a, b});
      }
    }
  }
  return out;
}

std::vector<Vec3> moved(const std::vector<Vec3>& vertices, const Vec3& by) {
  std::vector<Vec3> out = vertices;
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] += i % 3 == 0 ? by : -by;
  }
  return out;
}

TEST(ElementTree, CandidatesAreThoseOfAllPairs) {
  constexpr std::uint32_t seed = 11;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  for (const std::uint32_t side : {2u, 3u, 6u, 17u}) {
    FoldedSheet sheet = abut_test::folded_sheet(side, 0.02, random);
    // A strand, a removed triangle, and an edge of three faces.
    sheet.triangles.insert(sheet.triangles.end(), {0, side * side - 1, side * side - 1, 1, 1, 1, 0, side, side - 1});
    const abut::ElementTable table(sheet.vertices.size(), sheet.triangles);
    abut::ElementTree tree(table, sheet.triangles, sheet.vertices, abut::Workers(1));
    for (const double reach : {0.0, 0.03125}) {
      for (const double way : {0.0, 0.0625}) {
        const std::vector<Vec3> end = moved(sheet.vertices, {way, -way, 2 * way});
        tree.fit(sheet.vertices, end, reach, abut::Workers(1));
        const Both wanted = by_brute_force(sheet, end, table, reach);
        for (const std::size_t least : {1u, 64u, 4096u}) {
          const Both got = candidates(tree, least);
          EXPECT_EQ(got.vertices_and_faces, wanted.vertices_and_faces) << side << " " << reach << " " << way;
          EXPECT_EQ(got.edges, wanted.edges) << side << " " << reach << " " << way;
        }
      }
    }
  }
}

// Far from the origin, boxes of single precision are relative to a point near the vertices.
TEST(ElementTree, CandidatesFarAwayAreThoseOfAllPairs) {
  std::mt19937 random(5);
  FoldedSheet sheet = abut_test::folded_sheet(9, 0.02, random);
  for (Vec3& vertex : sheet.vertices) {
    vertex += Vec3{4194304.25, -8388608, 1048576.5};
  }
  const abut::ElementTable table(sheet.vertices.size(), sheet.triangles);
  abut::ElementTree tree(table, sheet.triangles, sheet.vertices, abut::Workers(1));
  tree.fit(sheet.vertices, sheet.vertices, 0.0625, abut::Workers(1));
  const Both got = candidates(tree, 1), wanted = by_brute_force(sheet, sheet.vertices, table, 0.0625);
  EXPECT_EQ(got.vertices_and_faces, wanted.vertices_and_faces);
  EXPECT_EQ(got.edges, wanted.edges);
}

TEST(ElementTree, RoundingLosesNoCandidate) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> share(-1, 1);
  FoldedSheet sheet = abut_test::folded_sheet(9, 0.02, random);
  for (Vec3& vertex : sheet.vertices) {
    vertex = Vec3{1e5 / 3, 1e-3 / 7, -1e4 / 9} + 1e-4 * Vec3{share(random), share(random), share(random)};
  }
  const abut::ElementTable table(sheet.vertices.size(), sheet.triangles);
  abut::ElementTree tree(table, sheet.triangles, sheet.vertices, abut::Workers(1));
  tree.fit(sheet.vertices, sheet.vertices, 1e-9 / 3, abut::Workers(1));
  const Both got = candidates(tree, 1), wanted = by_brute_force(sheet, sheet.vertices, table, 1e-9 / 3);
  EXPECT_TRUE(std::ranges::includes(got.vertices_and_faces, wanted.vertices_and_faces));
  EXPECT_TRUE(std::ranges::includes(got.edges, wanted.edges));
}

TEST(ElementTree, ThreadsChangeNothing) {
  std::mt19937 random(8);
  const FoldedSheet sheet = abut_test::folded_sheet(40, 0.01, random);
  const abut::ElementTable table(sheet.vertices.size(), sheet.triangles);
  std::vector<Both> found;
  for (const std::uint32_t threads : {1u, 4u}) {
    const abut::Workers workers(threads);
    abut::ElementTree tree(table, sheet.triangles, sheet.vertices, workers);
    tree.fit(sheet.vertices, sheet.vertices, 0.01, workers);
    found.push_back(candidates(tree, 64));
  }
  EXPECT_EQ(found[0].vertices_and_faces, found[1].vertices_and_faces);
  EXPECT_EQ(found[0].edges, found[1].edges);
  EXPECT_FALSE(found[0].edges.empty());
}

TEST(ElementTree, NothingGivesNothing) {
  const abut::ElementTree none;
  EXPECT_TRUE(candidates(none, 64).edges.empty());
  const std::vector<std::uint32_t> removed{0, 0, 0};
  const std::vector<Vec3> vertices{{0, 0, 0}};
  abut::ElementTree tree(abut::ElementTable(1, removed), removed, vertices, abut::Workers(1));
  tree.fit(vertices, vertices, 1, abut::Workers(1));
  EXPECT_TRUE(candidates(tree, 64).vertices_and_faces.empty());
}

}  // namespace
