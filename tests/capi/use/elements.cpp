// SPDX-License-Identifier: Apache-2.0
// Elements of meshes that deform, against all pairs in more digits.
#include "elements_oracle.hpp"

namespace {

using namespace abut_test;

// Weights, normal and distance say the same, and it is the distance of the two features.
void expect_consistent(const abut_stencil& its, const Surface& a, const Surface& b) {
  Wide3 way{};
  Wide of_a = 0, of_b = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool is_of_a = i < its.of_a;
    const Wide3 place = (is_of_a ? a : b).vertex(its.vertices[i]);
    way = along(way, place, its.weights[i]);
    (is_of_a ? of_a : of_b) += its.weights[i];
    EXPECT_TRUE(is_of_a ? its.weights[i] <= 0 : its.weights[i] >= 0);
    if (i >= vertex_count_of(its.kind)) EXPECT_EQ(its.weights[i], 0);
  }
  EXPECT_NEAR(double(of_a), -1, 1e-14);
  EXPECT_NEAR(double(of_b), 1, 1e-14);
  EXPECT_NEAR(double(length(way)), its.distance, 1e-14);
  const Wide3 normal{its.normal.x, its.normal.y, its.normal.z};
  EXPECT_NEAR(double(length(normal)), 1, 1e-14);
  EXPECT_NEAR(double(length(way - along({}, normal, its.distance))), 0, 1e-13);
  EXPECT_EQ(its.toi, 0);
}

std::vector<abut_stencil> of_vertices(const std::vector<abut_stencil>& all) {
  std::vector<abut_stencil> out;
  std::copy_if(all.begin(), all.end(), std::back_inserter(out),
               [](const auto& its) { return its.kind != ABUT_STENCIL_EDGE_EDGE; });
  return out;
}
std::vector<abut_stencil> of_edges(const std::vector<abut_stencil>& all) {
  std::vector<abut_stencil> out;
  std::copy_if(all.begin(), all.end(), std::back_inserter(out),
               [](const auto& its) { return its.kind == ABUT_STENCIL_EDGE_EDGE; });
  return out;
}

// A mesh with itself or with another one.
struct Case {
  Surface a, b;
  bool is_one;
  const Surface& other() const { return is_one ? a : b; }
};
std::vector<Case> cases(unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Case> out;
  out.push_back({folded_surface(9, 0.03, random), {}, true});
  out.push_back({folded_surface(14, 0.01, random), {}, true});
  Surface a = folded_surface(8, 0.03, random), b = folded_surface(10, 0.03, random);
  for (std::size_t i = 0; i < b.xyz.size(); i += 3) b.xyz[i] += 0.05;
  out.push_back({a, b, false});
  // A strand and a removed triangle.
  Surface strands = folded_surface(6, 0.03, random);
  strands.triangles.insert(strands.triangles.end(), {0, 35, 35, 1, 1, 1});
  out.push_back({folded_surface(6, 0.02, random), strands, false});
  return out;
}
constexpr double reach = 0.08;

void for_each_case(abut_closest_method method,
                   void (*check)(const Case&, const std::vector<abut_stencil>&, const std::vector<NearVertex>&)) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", method " << method);
    for (const Case& each : cases(seed)) {
      const ElementsOf a(each.a), b(each.other());
      const auto stencils =
          closest_of(a, each.is_one ? nullptr : static_cast<abut_elements*>(b), elements_options(reach, method));
      EXPECT_FALSE(stencils.empty());
      for (const abut_stencil& its : stencils) expect_consistent(its, each.a, each.other());
      check(each, stencils, near_vertices(each.a, each.other(), reach));
    }
  }
}

TEST(ElementsClosest, AllAreThoseOfAllPairs) {
  for_each_case(ABUT_CLOSEST_ALL, [](const Case& each, const auto& stencils, const auto& near) {
    Told wanted;
    for (const NearVertex& its : near) wanted[its.features] = double(its.distance);
    expect_same(told(of_vertices(stencils)), wanted);
    expect_same(told(of_edges(stencils)), near_edges(each.a, each.other(), reach));
  });
}

using NearestOfVertex = std::map<std::pair<bool, std::uint32_t>, Wide>;
NearestOfVertex nearest_of(const std::vector<NearVertex>& near) {
  NearestOfVertex out;
  for (const NearVertex& its : near) {
    const auto [place, is_new] = out.emplace(std::pair(its.is_of_b, its.vertex), its.distance);
    if (!is_new) place->second = std::min(place->second, its.distance);
  }
  return out;
}
NearestOfVertex nearest_of(const std::vector<abut_stencil>& stencils) {
  NearestOfVertex out;
  for (const abut_stencil& its : stencils) {
    const Features features = features_of(its);
    // Of two vertices each is near the other one; the list says whose turn it is by its order alone.
    const bool is_of_b = features.first.size() > 1;
    const std::uint32_t vertex = is_of_b ? features.second[0] : features.first[0];
    const auto [place, is_new] = out.emplace(std::pair(is_of_b, vertex), its.distance);
    if (!is_new) place->second = std::min<Wide>(place->second, its.distance);
  }
  return out;
}

// Two vertices are told once, from either side.
void expect_nearest(const Case& each, const std::vector<abut_stencil>& stencils, const std::vector<NearVertex>& near) {
  const NearestOfVertex got = nearest_of(of_vertices(stencils));
  for (const auto& [vertex, distance] : nearest_of(near)) {
    const auto found = got.find(vertex);
    const bool is_told = found != got.end() && std::fabs(double(found->second - distance)) < 1e-13;
    const bool is_told_as_pair =
        std::any_of(stencils.begin(), stencils.end(), [&, which = vertex, least = distance](const abut_stencil& its) {
          return its.kind == ABUT_STENCIL_VERTEX_VERTEX && std::fabs(its.distance - double(least)) < 1e-13 &&
                 (its.vertices[which.first ? 1 : 0] == which.second ||
                  (each.is_one && its.vertices[1] == which.second));
        });
    EXPECT_TRUE(is_told || is_told_as_pair) << "vertex " << vertex.second << " has lost its nearest feature";
  }
}
TEST(ElementsClosest, FeaturesLoseNoNearest) { for_each_case(ABUT_CLOSEST_FEATURES, expect_nearest); }
TEST(ElementsClosest, OfVerticesLosesNoNearest) { for_each_case(ABUT_CLOSEST_OF_VERTICES, expect_nearest); }

TEST(ElementsClosest, OfVerticesHasOneOfEach) {
  for_each_case(ABUT_CLOSEST_OF_VERTICES, [](const Case&, const auto& stencils, const auto& near) {
    // Two vertices that are nearest to each other are told once.
    EXPECT_LE(stencils.size(), nearest_of(near).size());
    EXPECT_TRUE(of_edges(stencils).empty());
  });
}

// A feature is told where the vertex is in its Voronoi region: no face around it has a point that is nearer.
TEST(ElementsClosest, FeaturesAreThoseOfAllFacesAroundThem) {
  for_each_case(ABUT_CLOSEST_FEATURES, [](const Case& each, const auto& stencils, const auto& near) {
    const Told got = told(of_vertices(stencils));
    Told wanted;
    for (const NearVertex& its : near) {
      const Surface& other = its.is_of_b ? each.a : each.other();
      const Wide3 place = (its.is_of_b ? each.other() : each.a).vertex(its.vertex);
      bool is_least = true;
      for (std::uint32_t face = 0; face < other.face_count(); ++face) {
        const auto corners = other.face(face);
        const bool is_around = std::all_of(its.feature.begin(), its.feature.end(),
                                           [&](auto vertex) { return have_common(std::array{vertex}, corners); });
        if (!other.is_face(face) || !is_around || (each.is_one && have_common(std::array{its.vertex}, corners)))
          continue;
        is_least = is_least && closest_on_face(place, other, face).distance > its.distance - 1e-15L;
      }
      if (is_least) wanted[its.features] = double(its.distance);
    }
    expect_same(got, wanted);
    expect_same(told(of_edges(stencils)), near_edges(each.a, each.other(), reach));
  });
}

// The least of fifteen pairs of features for each two faces.
TEST(ElementsClosest, OfFacesAreTheLeastOfFifteen) {
  for_each_case(ABUT_CLOSEST_OF_FACES, [](const Case& each, const auto& stencils, const auto&) {
    const Surface &a = each.a, &b = each.other();
    const Told got = told(stencils);
    Told wanted;
    for (std::uint32_t i = 0; i < a.face_count(); ++i) {
      for (std::uint32_t j = each.is_one ? i + 1 : 0; j < b.face_count(); ++j) {
        const auto of_a = a.face(i), of_b = b.face(j);
        if (!a.is_face(i) || !b.is_face(j) || (each.is_one && have_common(of_a, of_b))) continue;
        Told of_pair;
        for (std::size_t k = 0; k < 3; ++k) {
          const ClosestFeature of_b_face = closest_on_face(a.vertex(of_a.at(k)), b, j),
                               of_a_face = closest_on_face(b.vertex(of_b.at(k)), a, i);
          const auto add = [&](Features features, Wide distance) {
            const bool are_turned = each.is_one && features.first.size() == 1 && features.second.size() == 1 &&
                                    features.second < features.first;
            if (are_turned) std::swap(features.first, features.second);
            of_pair[features] = double(distance);
          };
          add({{of_a.at(k)}, of_b_face.vertices}, of_b_face.distance);
          add(each.is_one ? Features{{of_b.at(k)}, of_a_face.vertices} : Features{of_a_face.vertices, {of_b.at(k)}},
              of_a_face.distance);
          for (std::size_t l = 0; l < 3; ++l) {
            std::array<std::uint32_t, 2> first{of_a.at(k), of_a.at((k + 1) % 3)},
                second{of_b.at(l), of_b.at((l + 1) % 3)};
            std::sort(first.begin(), first.end());
            std::sort(second.begin(), second.end());
            if (each.is_one && second < first) std::swap(first, second);
            if (const auto inside = distance_inside_edges(a, first, b, second)) {
              of_pair[{{first.begin(), first.end()}, {second.begin(), second.end()}}] = double(*inside);
            }
          }
        }
        double least = INFINITY;
        for (const auto& [features, distance] : of_pair) least = std::min(least, distance);
        if (least > reach) continue;
        for (const auto& [features, distance] : of_pair) {
          if (distance <= least * (1 + 1e-12)) wanted[features] = distance;
        }
      }
    }
    expect_same(got, wanted);
  });
}

}  // namespace
