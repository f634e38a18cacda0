// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

import abut.triangles.elements;

namespace {

using Indices = std::vector<std::uint32_t>;

struct Owned {
  std::multiset<std::uint32_t> vertices;
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::size_t borders = 0;
};
Owned owned(const abut::ElementTable& table, const Indices& triangles) {
  Owned out;
  for (std::uint32_t triangle = 0; triangle < table.triangle_count(); ++triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (table.owns_corner(triangle, i)) {
        out.vertices.insert(triangles[3 * std::size_t{triangle} + i]);
      }
      if (table.owns_edge(triangle, i)) {
        const abut::EdgeEnds& ends = table.edges()[table.edges_of(triangle)[i]];
        out.edges.insert({ends[0], ends[1]});
        out.borders += table.is_border(triangle, i) ? 1 : 0;
      }
    }
  }
  return out;
}

// Counted from the corners alone.
Owned expected(const Indices& triangles) {
  Owned out;
  std::set<std::uint32_t> vertices;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> faces_of;
  for (std::size_t first = 0; first < triangles.size(); first += 3) {
    const std::set<std::uint32_t> corners(&triangles[first], &triangles[first] + 3);
    if (corners.size() == 1) {
      continue;
    }
    vertices.insert(corners.begin(), corners.end());
    for (const std::uint32_t a : corners) {
      for (const std::uint32_t b : corners) {
        if (a < b) {
          faces_of[{a, b}] += corners.size() == 3 ? 1 : 0;
        }
      }
    }
  }
  out.vertices.insert(vertices.begin(), vertices.end());
  for (const auto& [ends, count] : faces_of) {
    out.edges.insert(ends);
    out.borders += count < 2 ? 1 : 0;
  }
  return out;
}

TEST(ElementTable, EachVertexAndEdgeHasOneOwner) {
  const Indices closed{0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0}, open{0, 1, 2, 1, 3, 2}, fan{0, 1, 2, 0, 1, 3, 1, 0, 4},
      with_strand{0, 1, 2, 2, 3, 3, 3, 3, 4}, with_removed{5, 5, 5, 0, 1, 2, 4, 4, 4}, twice{0, 1, 2, 2, 1, 0};
  for (const Indices& triangles : {closed, open, fan, with_strand, with_removed, twice}) {
    const abut::ElementTable table(6, triangles);
    const Owned got = owned(table, triangles), wanted = expected(triangles);
    EXPECT_EQ(got.vertices, wanted.vertices);
    EXPECT_EQ(got.edges, wanted.edges);
    EXPECT_EQ(table.edges().size(), wanted.edges.size());
    EXPECT_EQ(got.borders, wanted.borders);
  }
}

TEST(ElementTable, TrianglesOfOneEdgeShareItsNumber) {
  const Indices triangles{4, 2, 7, 7, 2, 1, 5, 5, 2, 6, 6, 6};
  const abut::ElementTable table(8, triangles);
  EXPECT_EQ(table.edges_of(0)[1], table.edges_of(1)[0]);
  EXPECT_EQ(table.edges_of(0)[1], table.edge_between(7, 2));
  EXPECT_EQ(table.edges_of(2)[0], abut::ElementTable::none);
  EXPECT_EQ(table.edges_of(2)[1], table.edges_of(2)[2]);
  EXPECT_EQ(table.edge_between(4, 1), abut::ElementTable::none);
  EXPECT_EQ(table.face_count(), 2u);
  EXPECT_FALSE(table.is_face(2));
  EXPECT_FALSE(table.is_face(3));
}

TEST(ElementTable, ListsEdgesAroundVerticesAndCornersAcrossEdges) {
  const Indices triangles{4, 2, 7, 7, 2, 1, 5, 5, 2, 6, 6, 6};
  const abut::ElementTable table(8, triangles);
  std::size_t ends = 0;
  for (std::uint32_t vertex = 0; vertex < 8; ++vertex) {
    for (const std::uint32_t edge : table.edges_around(vertex)) {
      const abut::EdgeEnds& its = table.edges()[edge];
      EXPECT_TRUE(its[0] == vertex || its[1] == vertex);
      ++ends;
    }
  }
  EXPECT_EQ(ends, 2 * table.edges().size());
  EXPECT_EQ(table.edges_around(2).size(), 4u);
  EXPECT_TRUE(table.edges_around(6).empty());
  const auto across = [&](std::uint32_t a, std::uint32_t b) {
    const auto list = table.corners_across(table.edge_between(a, b));
    return std::multiset<std::uint32_t>(list.begin(), list.end());
  };
  EXPECT_EQ(across(2, 7), (std::multiset<std::uint32_t>{1, 4}));
  EXPECT_EQ(across(2, 1), (std::multiset<std::uint32_t>{7}));
  EXPECT_TRUE(across(2, 5).empty());
}

}  // namespace
