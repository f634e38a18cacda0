// SPDX-License-Identifier: Apache-2.0
// Elements of meshes that deform: motion, rest shapes, two meshes, threads and numbers.
#include <cstring>

#include "elements_oracle.hpp"

namespace {

using namespace abut_test;

bool have_same_bits(const std::vector<abut_stencil>& a, const std::vector<abut_stencil>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(abut_stencil)) == 0);
}

TEST(ElementsCount, IsThatOfTheMesh) {
  std::mt19937 random(1);
  Surface mesh = folded_surface(5, 0.01, random);
  mesh.triangles.insert(mesh.triangles.end(), {0, 24, 24, 1, 1, 1});
  const ElementsOf elements(mesh);
  abut_element_counts counts;
  require(abut_elements_count(elements, &counts));
  EXPECT_EQ(counts.vertices, 25U);
  EXPECT_EQ(counts.triangles, 34U);
  EXPECT_EQ(counts.faces, 32U);
  const auto wanted = mesh.edges();
  EXPECT_EQ(counts.edges, wanted.size());
  std::vector<std::array<std::uint32_t, 2>> edges(wanted.size());
  std::size_t count = 0;
  require(abut_elements_edges(elements, edges.data()->data(), 3, &count));
  EXPECT_EQ(count, wanted.size());
  EXPECT_EQ(edges.at(3)[1], 0U) << "past the capacity";
  require(abut_elements_edges(elements, edges.data()->data(), edges.size(), &count));
  EXPECT_EQ(edges, wanted);
}

// Candidates are pairs whose boxes overlap; none is left out, and none has a vertex in common.
TEST(ElementsCandidates, HoldWhatIsNear) {
  std::mt19937 random(2);
  const Surface mesh = folded_surface(9, 0.03, random);
  const ElementsOf elements(mesh);
  const auto pairs = all_of<abut_element_pair>(abut_elements_candidates, elements, nullptr, elements_options(0.08));
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> all;
  const auto edges = mesh.edges();
  for (const abut_element_pair& pair : pairs) {
    EXPECT_TRUE(all.insert({pair.kind, std::min(pair.a, pair.b), std::max(pair.a, pair.b)}).second ||
                pair.kind == ABUT_ELEMENT_PAIR_VERTEX_FACE);
    if (pair.kind == ABUT_ELEMENT_PAIR_EDGE_EDGE) {
      EXPECT_FALSE(have_common(edges.at(pair.a), edges.at(pair.b)));
    } else {
      ASSERT_EQ(pair.kind, abut_element_pair_kind{ABUT_ELEMENT_PAIR_VERTEX_FACE});
      EXPECT_FALSE(have_common(std::array{pair.a}, mesh.face(pair.b)));
    }
  }
  std::set<std::pair<std::uint32_t, std::uint32_t>> of_vertices, of_edges;
  for (const abut_element_pair& pair : pairs) {
    (pair.kind == ABUT_ELEMENT_PAIR_EDGE_EDGE ? of_edges : of_vertices).insert({pair.a, pair.b});
  }
  for (std::uint32_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
      if (have_common(std::array{vertex}, mesh.face(face))) continue;
      if (closest_on_face(mesh.vertex(vertex), mesh, face).distance <= 0.08L) {
        EXPECT_TRUE(of_vertices.count({vertex, face}) == 1) << vertex << " " << face;
      }
    }
  }
  auto options = elements_options(0.08);
  options.kinds = 1U << ABUT_STENCIL_EDGE_EDGE;
  EXPECT_EQ(all_of<abut_element_pair>(abut_elements_candidates, elements, elements, options).size(), of_edges.size());
  EXPECT_EQ(of_edges.size() + of_vertices.size(), pairs.size());
}

// Boxes in single precision are exact for whole multiples of 2^-14. Then candidates are those whose boxes overlap.
struct Box {
  Wide3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  template <class Vertices>
  Box(const Vertices& vertices, const Surface& start, const std::vector<double>& end, Wide reach) {
    for (const std::uint32_t vertex : vertices) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const Wide at : {start.vertex(vertex).at(axis), Wide(end.at(3 * vertex + axis))}) {
          low.at(axis) = std::min(low.at(axis), at - reach);
          high.at(axis) = std::max(high.at(axis), at + reach);
        }
      }
    }
  }
  bool overlaps(const Box& other) const {
    bool all = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      all = all && low.at(axis) <= other.high.at(axis) && other.low.at(axis) <= high.at(axis);
    }
    return all;
  }
};
using Pairs = std::set<std::array<std::uint32_t, 3>>;  // kind, of a, of b
Pairs overlaps_of_all(const Surface& a, const std::vector<double>& end_a, const Surface& b,
                      const std::vector<double>& end_b, Wide half) {
  Pairs out;
  const bool is_one = &a == &b;
  for (const bool is_of_b : {false, true}) {
    const Surface &own = is_of_b ? b : a, &other = is_of_b ? a : b;
    for (std::uint32_t vertex = 0; vertex < own.vertex_count() && !(is_one && is_of_b); ++vertex) {
      const Box around(std::array{vertex}, own, is_of_b ? end_b : end_a, half);
      for (std::uint32_t face = 0; face < other.face_count(); ++face) {
        if (is_one && have_common(std::array{vertex}, other.face(face))) continue;
        if (!around.overlaps({other.face(face), other, is_of_b ? end_a : end_b, half})) continue;
        if (is_of_b) out.insert({ABUT_ELEMENT_PAIR_FACE_VERTEX, face, vertex});
        if (!is_of_b) out.insert({ABUT_ELEMENT_PAIR_VERTEX_FACE, vertex, face});
      }
    }
  }
  const auto edges_a = a.edges(), edges_b = b.edges();
  for (std::uint32_t i = 0; i < edges_a.size(); ++i) {
    for (std::uint32_t j = is_one ? i + 1 : 0; j < edges_b.size(); ++j) {
      if (is_one && have_common(edges_a[i], edges_b[j])) continue;
      if (Box(edges_a[i], a, end_a, half).overlaps({edges_b[j], b, end_b, half})) {
        out.insert({ABUT_ELEMENT_PAIR_EDGE_EDGE, i, j});
      }
    }
  }
  return out;
}
TEST(ElementsCandidates, AreThoseWhoseBoxesOverlap) {
  for (const unsigned seed : {1U, 2U}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    std::array<Surface, 2> meshes{folded_surface(9, 0.02, random), folded_surface(8, 0.02, random)};
    std::array<std::vector<double>, 2> ends;
    for (std::size_t which = 0; which < 2; ++which) {
      ends.at(which) = moved(meshes.at(which), 0.05, random);
      for (std::vector<double>* places : {&meshes.at(which).xyz, &ends.at(which)}) {
        for (double& value : *places) value = std::round(value * 0x1p14) * 0x1p-14;
      }
    }
    const ElementsOf a(meshes[0]), b(meshes[1]);
    require(abut_elements_set_vertices(a, meshes[0].xyz.data(), ends[0].data(), meshes[0].vertex_count()));
    require(abut_elements_set_vertices(b, meshes[1].xyz.data(), ends[1].data(), meshes[1].vertex_count()));
    for (const double wanted_reach : {0.0, 0.0625}) {
      for (const bool is_one : {true, false}) {
        Pairs got;
        for (const abut_element_pair& pair :
             all_of<abut_element_pair>(abut_elements_candidates, a, is_one ? nullptr : static_cast<abut_elements*>(b),
                                       elements_options(wanted_reach))) {
          EXPECT_TRUE(got.insert({pair.kind, pair.a, pair.b}).second) << "told twice";
        }
        const std::size_t other = is_one ? 0 : 1;
        const Pairs wanted = overlaps_of_all(meshes[0], ends[0], is_one ? meshes[0] : meshes.at(other),
                                             is_one ? ends[0] : ends.at(other), 0.5L * wanted_reach);
        EXPECT_EQ(got, wanted) << wanted_reach << (is_one ? " of one" : " of two");
      }
    }
  }
}

void expect_touches(const Surface& a, const Surface& b, bool is_one, double separation, std::mt19937& random) {
  const std::vector<double> end_a = moved(a, 0.05, random), end_b = is_one ? end_a : moved(b, 0.05, random);
  const Surface& other = is_one ? a : b;
  const ElementsOf of_a(a), of_b(other);
  require(abut_elements_set_vertices(of_a, a.xyz.data(), end_a.data(), a.vertex_count()));
  require(abut_elements_set_vertices(of_b, other.xyz.data(), end_b.data(), other.vertex_count()));
  const auto stencils =
      touches_of(of_a, is_one ? nullptr : static_cast<abut_elements*>(of_b), elements_options(separation));
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>> got;
  for (const abut_stencil& its : stencils) {
    EXPECT_TRUE(got.insert({its.kind, its.of_a, its.element_a, its.element_b}).second) << "told twice";
    // The points meet at that time.
    Wide3 way{}, rate{};
    for (std::size_t i = 0; i < 4; ++i) {
      const bool is_of_a = i < its.of_a;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t place = 3 * its.vertices[i] + axis;
        const Wide start = (is_of_a ? a : other).xyz.at(place), end = (is_of_a ? end_a : end_b).at(place);
        way.at(axis) += its.weights[i] * (start + its.toi * (end - start));
        rate.at(axis) += its.weights[i] * (end - start);
      }
    }
    EXPECT_NEAR(double(length(way)), separation, 1e-8);
    const Wide3 normal{its.normal.x, its.normal.y, its.normal.z};
    EXPECT_NEAR(double(length(normal)), 1, 1e-14);
    EXPECT_LE(double(product(rate, normal)), 1e-12) << "they come together";
    EXPECT_NEAR(its.distance, separation, 1e-8);
  }
  EXPECT_EQ(got, touches_by_all_pairs(a, end_a, other, end_b, separation));
  EXPECT_GT(got.size(), 5U);
}

TEST(ElementsFirstTouches, AreThoseOfAllPairs) {
  for (const unsigned seed : {1U, 2U}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const Surface a = folded_surface(8, 0.01, random);
    Surface b = folded_surface(7, 0.01, random);
    for (std::size_t i = 0; i < b.xyz.size(); i += 3) b.xyz[i] += 0.03;
    expect_touches(a, a, true, 0, random);
    expect_touches(a, b, false, 0, random);
  }
}

// What is near from the start touches at once: then the distance is less than the separation.
TEST(ElementsFirstTouches, ComeWithinASeparation) {
  Surface ground{{-1, -1, 0, 2, -1, 0, -1, 2, 0}, {0, 1, 2}}, tip{{0, 0, 1, 0.2, 0, 2, 0, 0.2, 2}, {0, 1, 2}};
  const ElementsOf a(tip), b(ground);
  std::vector<double> end = tip.xyz;
  for (std::size_t i = 2; i < end.size(); i += 3) end[i] -= 1.5;
  require(abut_elements_set_vertices(a, tip.xyz.data(), end.data(), 3));
  const auto found = touches_of(a, b, elements_options(0.25));
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].kind, abut_stencil_kind{ABUT_STENCIL_VERTEX_FACE});
  EXPECT_EQ(found[0].of_a, 1U);
  EXPECT_NEAR(found[0].toi, 0.5, 1e-8);
  EXPECT_NEAR(found[0].distance, 0.25, 1e-8);
  EXPECT_NEAR(found[0].normal.z, -1, 1e-12);
  // The other way round the same, with the sides swapped.
  const auto swapped = touches_of(b, a, elements_options(0.25));
  ASSERT_EQ(swapped.size(), found.size());
  EXPECT_EQ(swapped[0].of_a, 3U);
  EXPECT_NEAR(swapped[0].normal.z, 1, 1e-12);
  EXPECT_EQ(swapped[0].toi, found[0].toi);
  // With a separation of 0, and no more than one vertex.
  const auto exact = touches_of(a, b, elements_options(0));
  ASSERT_EQ(exact.size(), 1U);
  EXPECT_NEAR(exact[0].toi, 2.0 / 3, 1e-9);
  EXPECT_EQ(exact[0].distance, 0);
  EXPECT_NEAR(exact[0].normal.z, -1, 1e-12);
}

// A flat sheet has neighbours nearer than the reach. In folds, layers meet, and neighbours still do not.
TEST(ElementsClosest, RestDistanceLeavesNeighboursOut) {
  constexpr std::uint32_t side = 11;
  Surface flat;
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      flat.xyz.insert(flat.xyz.end(), {0.1 * i, 0.1 * j, 0});
      if (i + 1 < side && j + 1 < side) {
        const std::uint32_t a = i * side + j, b = a + side;
        flat.triangles.insert(flat.triangles.end(), {a, b, b + 1, a, b + 1, a + 1});
      }
    }
  }
  const ElementsOf elements(flat);
  auto options = elements_options(0.15);
  EXPECT_GT(closest_of(elements, nullptr, options).size(), 100U) << "neighbours";
  options.rest_distance = 0.16;
  EXPECT_EQ(closest_of(elements, nullptr, options).size(), 0U);
  // Folded in half around the middle.
  std::vector<double> folded = flat.xyz;
  for (std::size_t vertex = 0; vertex < flat.vertex_count(); ++vertex) {
    if (folded[3 * vertex] > 0.55) {
      folded[3 * vertex] = 1 - folded[3 * vertex];
      folded[3 * vertex + 2] = 0.05;
    }
  }
  require(abut_elements_set_vertices(elements, folded.data(), nullptr, flat.vertex_count()));
  const auto layers = closest_of(elements, nullptr, options);
  EXPECT_GT(layers.size(), 20U);
  for (const abut_stencil& its : layers) {
    const double first = folded[3 * its.vertices[0] + 2], second = folded[3 * its.vertices[3] + 2];
    EXPECT_NE(first, second) << "of one layer";
  }
}

// Two convex solids apart have one pair of closest features, which has the distance of the solids.
TEST(ElementsClosest, LocalMinimaOfConvexSolidsAreOne) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(testing::Message() << "seed 5, round " << round);
    std::array<Surface, 2> solids;
    std::array<Shape, 2> hulls;
    for (std::size_t which = 0; which < 2; ++which) {
      std::vector<double> points;
      for (int i = 0; i < 24; ++i) {
        const Wide3 way{share(random), share(random), share(random)};
        for (std::size_t axis = 0; axis < 3; ++axis)
          points.push_back(double(way.at(axis) / length(way)) + (which == 1 && axis == 0 ? 2.2 : 0.1 * double(axis)));
      }
      hulls.at(which) = make_of_kind("hull", {}, points);
      std::size_t vertices = 0, triangles = 0;
      require(abut_shape_triangles(hulls.at(which), nullptr, 0, &vertices, nullptr, 0, &triangles));
      solids.at(which).xyz.resize(3 * vertices);
      solids.at(which).triangles.resize(3 * triangles);
      require(abut_shape_triangles(hulls.at(which), solids.at(which).xyz.data(), vertices, &vertices,
                                   solids.at(which).triangles.data(), triangles, &triangles));
    }
    const abut_pose here{{0, 0, 0}, {1, 0, 0, 0}};
    const double distance = distance_of(hulls[0], here, hulls[1], here);
    const ElementsOf a(solids[0]), b(solids[1]);
    auto options = elements_options(10, ABUT_CLOSEST_LOCAL_MINIMA);
    options.cone_factor = 0;
    options.flags = ABUT_ELEMENTS_FRONTS_ONLY;
    const auto found = closest_of(a, b, options);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].distance, distance, 1e-12);
    EXPECT_GE(closest_of(a, b, elements_options(10, ABUT_CLOSEST_FEATURES)).size(), 2U);
  }
}

// A small box over a large one: its four corners, and no edges.
TEST(ElementsClosest, LocalMinimaOfFlatOnFlatAreVertices) {
  const Shape large = make_box(2, 2, 0.5), small = make_box(0.3, 0.4, 0.25);
  const ElementsOf a(large), b(small);
  std::size_t vertices = 0, triangles = 0;
  require(abut_shape_triangles(small, nullptr, 0, &vertices, nullptr, 0, &triangles));
  std::vector<double> xyz(3 * vertices);
  std::vector<std::uint32_t> indices(3 * triangles);
  require(abut_shape_triangles(small, xyz.data(), vertices, &vertices, indices.data(), triangles, &triangles));
  for (std::size_t i = 0; i < xyz.size(); i += 3) {
    xyz[i] += 0.11;
    xyz[i + 1] += 0.07;
    xyz[i + 2] += 0.5 + 0.25 + 0.125;
  }
  require(abut_elements_set_vertices(b, xyz.data(), nullptr, vertices));
  auto options = elements_options(0.2, ABUT_CLOSEST_LOCAL_MINIMA);
  options.flags = ABUT_ELEMENTS_FRONTS_ONLY;
  const auto found = closest_of(a, b, options);
  EXPECT_EQ(found.size(), 4U);
  for (const abut_stencil& its : found) {
    EXPECT_NE(its.kind, abut_stencil_kind{ABUT_STENCIL_EDGE_EDGE});
    EXPECT_EQ(its.distance, 0.125);
    EXPECT_EQ(its.normal.z, 1);
  }
}

// Edges through faces by signs of volumes of whole numbers.
using Whole3 = std::array<std::int64_t, 3>;
__extension__ using Int128 = __int128;
int side_of(const Whole3& a, const Whole3& b, const Whole3& c, const Whole3& d) {
  std::array<std::array<Int128, 3>, 3> m{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    m[0].at(axis) = b.at(axis) - a.at(axis);
    m[1].at(axis) = c.at(axis) - a.at(axis);
    m[2].at(axis) = d.at(axis) - a.at(axis);
  }
  const Int128 volume = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                        m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                        m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return volume > 0 ? 1 : volume < 0 ? -1 : 0;
}
TEST(ElementsCrossings, AreThoseOfAllPairs) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    std::array<Surface, 2> meshes{folded_surface(8, 0.05, random), folded_surface(9, 0.05, random)};
    std::array<std::vector<Whole3>, 2> wholes;
    for (std::size_t which = 0; which < 2; ++which) {
      for (double& value : meshes.at(which).xyz) value = std::round(value * 0x1p24) * 0x1p-24;
      for (std::size_t i = 0; i < meshes.at(which).xyz.size(); i += 3) {
        Whole3 place{};
        for (std::size_t axis = 0; axis < 3; ++axis)
          place.at(axis) = std::int64_t(meshes.at(which).xyz.at(i + axis) * 0x1p24);
        wholes.at(which).push_back(place);
      }
    }
    const ElementsOf a(meshes[0]), b(meshes[1]);
    for (const bool is_one : {true, false}) {
      std::set<std::array<std::uint32_t, 3>> got, wanted;
      for (const abut_crossing& its : all_of<abut_crossing>(
               abut_elements_crossings, a, is_one ? nullptr : static_cast<abut_elements*>(b), elements_options(0))) {
        EXPECT_TRUE(got.insert({its.edge_is_of_b, its.edge, its.face}).second);
        EXPECT_EQ(its.reserved, 0U);
        const Surface& own = meshes.at(its.edge_is_of_b);
        const auto ends = own.edges().at(its.edge);
        const Wide3 place = along(own.vertex(ends[0]), own.vertex(ends[1]) - own.vertex(ends[0]), its.share);
        EXPECT_NEAR(double(length(place - Wide3{its.point.x, its.point.y, its.point.z})), 0, 1e-14);
        EXPECT_NEAR(double(closest_on_face(place, meshes.at(is_one ? 0 : 1 - its.edge_is_of_b), its.face).distance), 0,
                    1e-8);
      }
      for (const std::uint32_t edge_is_of_b : {0U, 1U}) {
        if (is_one && edge_is_of_b == 1) continue;
        const std::size_t own = edge_is_of_b, other = is_one ? 0 : 1 - edge_is_of_b;
        const auto edges = meshes.at(own).edges();
        for (std::uint32_t edge = 0; edge < edges.size(); ++edge) {
          for (std::uint32_t face = 0; face < meshes.at(other).face_count(); ++face) {
            const auto corners = meshes.at(other).face(face);
            if (is_one && have_common(edges[edge], corners)) continue;
            const Whole3 &p = wholes.at(own).at(edges[edge][0]), &q = wholes.at(own).at(edges[edge][1]);
            const Whole3 &x = wholes.at(other).at(corners[0]), &y = wholes.at(other).at(corners[1]),
                         &z = wholes.at(other).at(corners[2]);
            const int before = side_of(x, y, z, p), behind = side_of(x, y, z, q);
            if (before * behind >= 0) continue;
            const int first = side_of(p, q, x, y), second = side_of(p, q, y, z), third = side_of(p, q, z, x);
            if (first == second && second == third) wanted.insert({edge_is_of_b, edge, face});
          }
        }
      }
      EXPECT_EQ(got, wanted);
      EXPECT_GT(wanted.size(), 3U);
    }
  }
}

TEST(ElementsClosest, ThreadsChangeNoBit) {
  std::mt19937 random(6);
  const Surface mesh = folded_surface(60, 0.004, random);
  const std::vector<double> end = moved(mesh, 0.01, random);
  const ElementsOf elements(mesh);
  require(abut_elements_set_vertices(elements, mesh.xyz.data(), end.data(), mesh.vertex_count()));
  for (const abut_closest_method method : {ABUT_CLOSEST_FEATURES, ABUT_CLOSEST_OF_FACES, ABUT_CLOSEST_LOCAL_MINIMA}) {
    auto options = elements_options(0.02, method);
    options.threads = 1;
    const auto one = closest_of(elements, nullptr, options);
    const auto touches = touches_of(elements, nullptr, options);
    EXPECT_FALSE(one.empty());
    for (const std::uint32_t threads : {2U, 7U}) {
      options.threads = threads_of_build(threads);
      EXPECT_TRUE(have_same_bits(closest_of(elements, nullptr, options), one));
      EXPECT_TRUE(have_same_bits(touches_of(elements, nullptr, options), touches));
    }
  }
}

// Numbers, order and winding of triangles change no distance.
TEST(ElementsClosest, RenumberingChangesNoDistance) {
  std::mt19937 random(7);
  const Surface mesh = folded_surface(20, 0.01, random);
  std::vector<std::uint32_t> number(mesh.vertex_count());
  for (std::uint32_t i = 0; i < number.size(); ++i) number[i] = i;
  std::shuffle(number.begin(), number.end(), random);
  Surface other{std::vector<double>(mesh.xyz.size()), {}};
  for (std::size_t i = 0; i < number.size(); ++i)
    std::copy_n(mesh.xyz.begin() + long(3 * i), 3, other.xyz.begin() + long(3 * number[i]));
  for (std::uint32_t face = std::uint32_t(mesh.face_count()); face-- > 0;) {
    const auto [a, b, c] = mesh.face(face);
    if (face % 2 == 0) other.triangles.insert(other.triangles.end(), {number[b], number[c], number[a]});
    if (face % 2 == 1) other.triangles.insert(other.triangles.end(), {number[c], number[b], number[a]});
  }
  const ElementsOf first(mesh), second(other);
  for (const abut_closest_method method :
       {ABUT_CLOSEST_FEATURES, ABUT_CLOSEST_OF_FACES, ABUT_CLOSEST_ALL, ABUT_CLOSEST_LOCAL_MINIMA}) {
    const auto told = [&](abut_elements* elements, bool is_renumbered) {
      std::set<std::tuple<std::set<std::uint32_t>, std::uint32_t, double>> out;
      for (const abut_stencil& its : closest_of(elements, nullptr, elements_options(0.05, method))) {
        std::set<std::uint32_t> vertices;
        for (const std::uint32_t vertex : its.vertices) vertices.insert(is_renumbered ? vertex : number[vertex]);
        out.insert({vertices, its.kind, its.distance});
      }
      return out;
    };
    EXPECT_EQ(told(first, false), told(second, true)) << "method " << method;
  }
}

// Frames far away: places are given as they are.
TEST(ElementsClosest, FarAwayIsAsNear) {
  std::mt19937 random(8);
  Surface mesh = folded_surface(9, 0.03, random);
  for (double& value : mesh.xyz) value = std::round(value * 0x1p20) * 0x1p-20;
  const ElementsOf elements(mesh);
  const auto near = closest_of(elements, nullptr, elements_options(0.08));
  std::vector<double> far = mesh.xyz;
  for (double& value : far) value += 0x1p22;
  require(abut_elements_set_vertices(elements, far.data(), nullptr, mesh.vertex_count()));
  const auto there = closest_of(elements, nullptr, elements_options(0.08));
  ASSERT_EQ(near.size(), there.size());
  for (std::size_t i = 0; i < near.size(); ++i) {
    EXPECT_EQ(near[i].element_a, there[i].element_a);
    EXPECT_NEAR(near[i].distance, there[i].distance, 1e-8);
  }
}

// Only features within the reach are told, and what lies on a face has the normal of the face.
TEST(ElementsClosest, TouchingFeaturesHaveANormal) {
  const Surface ground{{-1, -1, 0, 2, -1, 0, -1, 2, 0}, {0, 1, 2}}, tip{{0, 0, 0, 0.2, 0, 1, 0, 0.2, 1}, {0, 1, 2}};
  const ElementsOf a(tip), b(ground);
  const auto found = closest_of(a, b, elements_options(0));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].distance, 0);
  EXPECT_EQ(std::fabs(found[0].normal.z), 1);
}

TEST(ElementsCreate, TakesWhateverHasTriangles) {
  const Shape box = make_box(1, 1, 1), terrain = make_terrain(9, 1), hull = make_octahedron(1);
  for (const Shape* shape : {&box, &terrain, &hull}) {
    const ElementsOf elements(*shape);
    abut_element_counts counts;
    require(abut_elements_count(elements, &counts));
    EXPECT_GT(counts.faces, 7U);
    EXPECT_GT(counts.edges, counts.faces);
  }
}

}  // namespace
