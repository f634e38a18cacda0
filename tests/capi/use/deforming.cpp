// SPDX-License-Identifier: Apache-2.0
// Vertices on straight lines, against public truth, against a search of boxes of time and place, and against itself.
#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>

#include "../../../fuzz/touch/box_search.hpp"
#include "support.hpp"

namespace {

using namespace abut_test;
using touch_fuzzing::BoxSearch;
using touch_fuzzing::Features;
using touch_fuzzing::Query;

abut_first_touch ask(Features features, const Query& query, double separation = 0, double tolerance = 1e-9) {
  abut_first_touch out{};
  const auto call = features == Features::edges ? abut_edges_touch_edges : abut_vertices_touch_faces;
  require(call(query.start.data(), query.end.data(), 1, separation, tolerance, &out));
  return out;
}

// Whether they touch within a span of time; no search takes as many boxes.
bool do_touch(const BoxSearch& search, std::int64_t low = 0, std::int64_t high = BoxSearch::one) {
  return search.touches(low, high, std::numeric_limits<std::uint64_t>::max()).value();
}

// Whole numbers in [-most, most], from few of which all kinds of degenerate motion arise by chance.
Query random_query(std::mt19937& random, int most) {
  Query query{};
  const auto draw = [&] { return double(int(random() % unsigned(2 * most + 1)) - most); };
  for (double& value : query.start) value = draw();
  for (double& value : query.end) value = draw();
  // Some vertices stay, some move as others do.
  for (std::size_t vertex = 0; vertex < 4; ++vertex) {
    const auto choice = random() % 6;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t at = 3 * vertex + axis;
      if (choice == 0) query.end.at(at) = query.start.at(at);
      if (choice == 1) query.end.at(at) = query.start.at(at) + query.end.at(axis) - query.start.at(axis);
      if (choice == 2 && axis == 2) query.start.at(at) = query.end.at(at) = 0;
    }
  }
  return query;
}

void expect_as_search(Features features, int most, int count, unsigned seed) {
  std::mt19937 random(seed);
  int touches = 0, grazing = 0;
  for (int i = 0; i < count; ++i) {
    const Query query = random_query(random, most);
    const BoxSearch search(features, query);
    const bool is_expected = do_touch(search);
    const abut_first_touch found = ask(features, query);
    ASSERT_EQ(found.touches != 0, is_expected) << "query " << i << " of seed " << seed << ", up to " << most;
    if (!is_expected) continue;
    ++touches;
    EXPECT_LE(found.lower, found.upper);
    EXPECT_LE(found.upper - found.lower, 1e-9);
    // A smallest box may have its touch beside it: far beside where features graze each other, which few do.
    constexpr std::int64_t margin = 64, wide_margin = BoxSearch::one / 1024;
    const auto low = std::int64_t(found.lower * BoxSearch::one), high = std::int64_t(found.upper * BoxSearch::one) + 1;
    EXPECT_FALSE(do_touch(search, 0, low - wide_margin)) << "query " << i << " of seed " << seed << ", up to " << most;
    grazing += do_touch(search, 0, low - margin) ? 1 : 0;
    EXPECT_TRUE(do_touch(search, std::max<std::int64_t>(low - 1, 0), std::min(high, BoxSearch::one))) << "query " << i;
  }
  EXPECT_LE(grazing, count / 50);
  EXPECT_GT(touches, count / 20);
  EXPECT_LT(touches, count - count / 20);
}

TEST(VerticesTouchFaces, AsASearchTells) {
  for (const int most : {1, 2, 5}) expect_as_search(Features::vertex_and_face, most, 200, 41);
}
TEST(EdgesTouchEdges, AsASearchTells) {
  for (const int most : {1, 2, 5}) expect_as_search(Features::edges, most, 200, 42);
}

std::vector<std::pair<Query, bool>> public_truth(const char* name, std::size_t count) {
  std::ifstream file(std::string(ABUT_TEST_DATA) + "/ccd/" + name, std::ios::binary);
  const auto next = [&] {
    std::array<char, sizeof(double)> bytes{};
    file.read(bytes.data(), bytes.size());
    return std::bit_cast<double>(bytes);
  };
  std::vector<std::pair<Query, bool>> out(count);
  for (auto& [query, touches] : out) {
    for (double& value : query.start) value = next();
    for (double& value : query.end) value = next();
    touches = next() == 1;
  }
  EXPECT_TRUE(file.good() && file.peek() == std::ifstream::traits_type::eof()) << name;
  return out;
}

TEST(VerticesTouchFaces, AsThePublicTruthTells) {
  int wrong = 0;
  for (const auto& [query, touches] : public_truth("ccd_vertex_face.bin", 250)) {
    wrong += (ask(Features::vertex_and_face, query).touches != 0) == touches ? 0 : 1;
  }
  EXPECT_EQ(wrong, 0);
}
TEST(EdgesTouchEdges, AsThePublicTruthTells) {
  int wrong = 0;
  for (const auto& [query, touches] : public_truth("ccd_edge_edge.bin", 74)) {
    wrong += (ask(Features::edges, query).touches != 0) == touches ? 0 : 1;
  }
  EXPECT_EQ(wrong, 0);
}

// The same motion in another order of vertices, the other way round in time, larger, and further away: numbers of few
// digits stay exact.
Query reordered(const Query& query, const std::array<std::size_t, 4>& order) {
  Query out{};
  for (std::size_t i = 0; i < 12; ++i) {
    out.start.at(i) = query.start.at(3 * order.at(i / 3) + i % 3);
    out.end.at(i) = query.end.at(3 * order.at(i / 3) + i % 3);
  }
  return out;
}
Query changed(const Query& query, double factor, double shift) {
  Query out = query;
  for (double& value : out.start) value = factor * value + shift;
  for (double& value : out.end) value = factor * value + shift;
  return out;
}

void expect_same(const abut_first_touch& a, const abut_first_touch& b, int query) {
  ASSERT_EQ(a.touches, b.touches) << query;
  EXPECT_LE(a.lower, b.upper) << query;
  EXPECT_LE(b.lower, a.upper) << query;
}

void expect_symmetry(Features features, const std::vector<std::array<std::size_t, 4>>& orders) {
  std::mt19937 random(43);
  for (int i = 0; i < 2000; ++i) {
    const Query query = random_query(random, 1 + i % 7);
    const abut_first_touch found = ask(features, query);
    for (const auto& order : orders) expect_same(ask(features, reordered(query, order)), found, i);
    for (const double factor : {0x1p-200, 0x1p90}) expect_same(ask(features, changed(query, factor, 0)), found, i);
    expect_same(ask(features, changed(query, 1, 0x1p49)), found, i);
    EXPECT_EQ(ask(features, {query.end, query.start}).touches, found.touches) << i;
  }
}
TEST(VerticesTouchFaces, InAnyOrderSizeAndPlace) {
  expect_symmetry(Features::vertex_and_face, {{0, 2, 3, 1}, {0, 2, 1, 3}});
}
TEST(EdgesTouchEdges, InAnyOrderSizeAndPlace) { expect_symmetry(Features::edges, {{2, 3, 0, 1}, {1, 0, 2, 3}}); }

// A vertex that moves along -Z toward the place (x, y) of a face which stays.
Query falling(double x, double y, double from, double to) {
  return {{x, y, from, 0, 0, 0, 1, 0, 0, 0, 1, 0}, {x, y, to, 0, 0, 0, 1, 0, 0, 0, 1, 0}};
}

TEST(VerticesTouchFaces, AtTheTimeOfTheClosedForm) {
  for (const double from : {0.0, 1.0, 3.0, 1e9}) {
    const abut_first_touch found = ask(Features::vertex_and_face, falling(0.25, 0.25, from, -1));
    ASSERT_EQ(found.touches, 1U) << from;
    EXPECT_LE(found.lower, from / (from + 1));
    EXPECT_GE(found.upper, from / (from + 1));
    EXPECT_LE(found.upper - found.lower, 1e-11) << from;
  }
}

// By one digit beside an edge, and on it.
TEST(VerticesTouchFaces, NotBesideAnEdgeByOneDigit) {
  EXPECT_EQ(ask(Features::vertex_and_face, falling(0.5, 0.5, 1, -1)).touches, 1U);
  EXPECT_EQ(ask(Features::vertex_and_face, falling(0.5, std::nextafter(0.5, 1), 1, -1)).touches, 0U);
  EXPECT_EQ(ask(Features::vertex_and_face, falling(1e-300, 0, 1, -1)).touches, 1U);
  EXPECT_EQ(ask(Features::vertex_and_face, falling(-1e-300, 0, 1, -1)).touches, 0U);
  EXPECT_EQ(ask(Features::vertex_and_face, falling(0.25, 0.25, 1, 0)).lower, 1.0) << "a touch at the end";
  EXPECT_EQ(ask(Features::vertex_and_face, falling(0.25, 0.25, 1, 1e-300)).touches, 0U);
}

TEST(VerticesTouchFaces, ComeWithinASeparation) {
  constexpr double separation = 0.125, tolerance = 1e-6;
  const auto touch = [&](const Query& query) { return ask(Features::vertex_and_face, query, separation, tolerance); };
  const abut_first_touch over = touch(falling(0.25, 0.25, 1, -1));
  ASSERT_EQ(over.touches, 1U);
  EXPECT_LE(over.lower, 0.4375);
  EXPECT_NEAR(over.upper, 0.4375, tolerance);
  // Past an edge at a distance of x.
  EXPECT_EQ(touch(falling(-separation - 2 * tolerance, 0.5, 1, -1)).touches, 0U);
  EXPECT_EQ(touch(falling(-separation + 2 * tolerance, 0.5, 1, -1)).touches, 1U);
  // Along the face, a little beyond the separation and a little within.
  Query slide = falling(-3, 0.25, separation * 1.001, separation * 1.001);
  slide.end[0] = 3;
  EXPECT_EQ(touch(slide).touches, 0U);
  slide.start[2] = slide.end[2] = separation * 0.999;
  EXPECT_EQ(touch(slide).touches, 1U);
  EXPECT_EQ(touch(falling(0.25, 0.25, 0.1, 5)).upper, 0.0) << "near from the start";
}

TEST(EdgesTouchEdges, ComeWithinASeparation) {
  // A bar along X that stays, one along Y that falls on it.
  const Query query{{-1, 0, 0, 1, 0, 0, 0, -1, 1, 0, 1, 1}, {-1, 0, 0, 1, 0, 0, 0, -1, -1, 0, 1, -1}};
  const abut_first_touch found = ask(Features::edges, query, 0.25, 1e-6);
  ASSERT_EQ(found.touches, 1U);
  EXPECT_LE(found.lower, 0.375);
  EXPECT_NEAR(found.upper, 0.375, 1e-6);
  EXPECT_EQ(ask(Features::edges, query).lower, 0.5);
}

}  // namespace
