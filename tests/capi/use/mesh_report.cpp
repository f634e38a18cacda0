// SPDX-License-Identifier: Apache-2.0
// Meshes that are damaged in ways that are counted while it is done; quads and vertices that are merged.
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "../../unit/damaged_meshes.hpp"
#include "../support.hpp"

namespace {

using namespace abut_test;
using test::Surface;

abut_mesh_options merging(double distance) {
  abut_mesh_options options;
  abut_mesh_options_init(&options, sizeof options);
  options.merges_vertices = 1;
  options.merge_distance = distance;
  return options;
}

abut_mesh_report report_of(const Surface& mesh, const abut_mesh_options* options = nullptr) {
  abut_mesh_report out;
  abut_mesh_report_init(&out, sizeof out);
  require(abut_mesh_describe(mesh.xyz.data(), mesh.xyz.size() / 3, mesh.triangles.data(), mesh.triangle_count(),
                             options, &out));
  return out;
}

constexpr std::uint32_t around = 24, across = 18;
constexpr std::size_t whole_count = 2 * around * across;
const Surface whole = test::torus(1, 0.4, around, across);

// Triangles that have no vertex in common, so that each damage is counted by itself.
std::vector<std::size_t> some_apart(std::size_t count, std::mt19937& random) {
  std::vector<std::size_t> all(whole_count), out;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  std::shuffle(all.begin(), all.end(), random);
  std::set<std::uint32_t> taken;
  for (const std::size_t triangle : all) {
    const std::array its{whole.triangles[3 * triangle], whole.triangles[3 * triangle + 1],
                         whole.triangles[3 * triangle + 2]};
    if (out.size() == count || std::ranges::any_of(its, [&](auto vertex) { return taken.count(vertex) > 0; })) continue;
    taken.insert(its.begin(), its.end());
    out.push_back(triangle);
  }
  if (out.size() < count) throw std::runtime_error("too few triangles apart");
  return out;
}

void expect_nothing_unusual(const abut_mesh_report& report) {
  EXPECT_EQ(report.duplicate_vertices, 0U);
  EXPECT_EQ(report.duplicate_triangles, 0U);
  EXPECT_EQ(report.slivers, 0U);
  EXPECT_EQ(report.open_edges, 0U);
  EXPECT_EQ(report.non_manifold_edges, 0U);
  EXPECT_EQ(report.reversed_triangles, 0U);
  EXPECT_EQ(report.twisted_patches, 0U);
  EXPECT_EQ(report.components, 1U);
}

TEST(MeshReport, FindsNothingUnusualInAClosedMesh) {
  const abut_mesh_report report = report_of(whole);
  expect_nothing_unusual(report);
  EXPECT_EQ(report.triangles, whole_count);
  EXPECT_EQ(report.vertices, around * across);
  EXPECT_EQ(report.merged_vertices, 0U);
  EXPECT_EQ(report.merge_error, 0.0);
}

class DamagedMesh : public testing::TestWithParam<std::uint32_t> {
 protected:
  std::mt19937 random{GetParam()};
  std::size_t count = 1 + random() % 30;
  Surface mesh = whole;
};
INSTANTIATE_TEST_SUITE_P(Seeds, DamagedMesh, testing::Range(1U, 9U));

TEST_P(DamagedMesh, ReversedTrianglesAreCounted) {
  std::set<std::size_t> reversed;
  while (reversed.size() < count) reversed.insert(random() % whole_count);
  for (const std::size_t triangle : reversed) std::swap(mesh.triangles[3 * triangle], mesh.triangles[3 * triangle + 1]);
  EXPECT_EQ(report_of(mesh).reversed_triangles, count);
  // All the others reversed as well: as many are left.
  for (std::size_t i = 0; i < whole_count; ++i) std::swap(mesh.triangles[3 * i], mesh.triangles[3 * i + 1]);
  EXPECT_EQ(report_of(mesh).reversed_triangles, count);
}

TEST_P(DamagedMesh, MissingTrianglesLeaveOpenEdges) {
  for (const std::size_t triangle : some_apart(count, random)) {
    mesh.triangles[3 * triangle + 1] = mesh.triangles[3 * triangle + 2] = mesh.triangles[3 * triangle];
  }
  const abut_mesh_report report = report_of(mesh);
  EXPECT_EQ(report.triangles, whole_count - count);
  EXPECT_EQ(report.open_edges, 3 * count);
  EXPECT_EQ(report.non_manifold_edges, 0U);
  EXPECT_EQ(report.components, 1U);
}

TEST_P(DamagedMesh, RepeatedTrianglesAreCounted) {
  for (const std::size_t triangle : some_apart(count, random)) {
    for (const std::size_t corner : {1U, 2U, 0U}) mesh.triangles.push_back(whole.triangles[3 * triangle + corner]);
  }
  const abut_mesh_report report = report_of(mesh);
  EXPECT_EQ(report.duplicate_triangles, count);
  EXPECT_EQ(report.non_manifold_edges, 3 * count);
  EXPECT_EQ(report.open_edges, 0U);
}

TEST_P(DamagedMesh, VerticesInOnePlaceAreCountedAndMerged) {
  for (const std::size_t triangle : some_apart(count, random)) {
    const std::size_t corner = 3 * triangle + random() % 3;
    const auto place = mesh.xyz.begin() + 3 * std::ptrdiff_t{mesh.triangles[corner]};
    const std::array<double, 3> copy{place[0], place[1], place[2]};
    mesh.triangles[corner] = static_cast<std::uint32_t>(mesh.xyz.size() / 3);
    mesh.xyz.insert(mesh.xyz.end(), copy.begin(), copy.end());
  }
  const abut_mesh_report report = report_of(mesh);
  EXPECT_EQ(report.duplicate_vertices, count);
  EXPECT_EQ(report.open_edges, 4 * count);
  const abut_mesh_options options = merging(0);
  const abut_mesh_report merged = report_of(mesh, &options);
  expect_nothing_unusual(merged);
  EXPECT_EQ(merged.merged_vertices, count);
  EXPECT_EQ(merged.vertices, around * across);
  EXPECT_EQ(merged.merge_error, 0.0);
}

TEST_P(DamagedMesh, ASoupBecomesTheMeshThatItWas) {
  constexpr double noise = 1e-4;
  std::uniform_real_distribution<double> off(-noise, noise);
  Surface soup;
  double furthest = 0;
  for (std::size_t corner = 0; corner < whole.triangles.size(); ++corner) {
    soup.triangles.push_back(static_cast<std::uint32_t>(corner));
    for (const double number : whole.corner(corner / 3, corner % 3)) soup.xyz.push_back(number + off(random));
  }
  EXPECT_EQ(report_of(soup).open_edges, 3 * whole_count);
  EXPECT_EQ(report_of(soup).components, whole_count);
  const abut_mesh_options options = merging(8 * noise);
  const abut_mesh_report report = report_of(soup, &options);
  expect_nothing_unusual(report);
  EXPECT_EQ(report.vertices, around * across);
  EXPECT_EQ(report.merged_vertices, 3 * whole_count - around * across);
  // The first corner at each place has stayed.
  std::vector<std::size_t> first(whole.xyz.size() / 3, whole.triangles.size());
  for (std::size_t corner = 0; corner < whole.triangles.size(); ++corner) {
    std::size_t& its = first[whole.triangles[corner]];
    its = std::min(its, corner);
    furthest = std::max(
        furthest, std::hypot(soup.xyz[3 * corner] - soup.xyz[3 * its], soup.xyz[3 * corner + 1] - soup.xyz[3 * its + 1],
                             soup.xyz[3 * corner + 2] - soup.xyz[3 * its + 2]));
  }
  EXPECT_NEAR(report.merge_error, furthest, 1e-15);
}

TEST_P(DamagedMesh, SliversAndComponentsAreCounted) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.xyz.size() / 3);
    const double x = 10 + 2 * double(i), thin = i % 3 == 0 ? 0 : 0.9e-3;
    mesh.xyz.insert(mesh.xyz.end(), {x, 0, 0, x + 1, 0, 0, x + 0.3, thin, 0});
    mesh.triangles.insert(mesh.triangles.end(), {first, first + 1, first + 2});
  }
  const abut_mesh_report report = report_of(mesh);
  EXPECT_EQ(report.slivers, count);
  EXPECT_EQ(report.components, 1 + count);
  EXPECT_EQ(report.open_edges, 3 * count);
}

TEST(MeshReport, KnowsAStripWithOneSide) {
  Surface strip;
  constexpr std::uint32_t steps = 20;
  for (std::uint32_t i = 0; i < steps; ++i) {
    const double u = 2 * std::numbers::pi * i / steps;
    for (const double side : {-0.3, 0.3}) {
      const double reach = 1 + side * std::cos(u / 2);
      strip.xyz.insert(strip.xyz.end(), {reach * std::cos(u), reach * std::sin(u), side * std::sin(u / 2)});
    }
    const std::uint32_t a = 2 * i, b = a + 1, c = i + 1 < steps ? a + 2 : 1, d = i + 1 < steps ? a + 3 : 0;
    strip.triangles.insert(strip.triangles.end(), {a, c, b, c, d, b});
  }
  const abut_mesh_report report = report_of(strip);
  EXPECT_EQ(report.twisted_patches, 1U);
  EXPECT_EQ(report.reversed_triangles, 0U);
  EXPECT_EQ(report.open_edges, 2 * steps);
}

// Two vertices of one triangle become one: the triangle goes, and its neighbour across that edge.
TEST(MeshMerging, TrianglesThatCollapseAreRemoved) {
  const Surface square{{0, 0, 0, 1, 0, 0, 1, 0.01, 0, 0, 1, 0}, {0, 1, 2, 0, 2, 3}};
  const abut_mesh_options options = merging(0.02);
  const abut_mesh_report report = report_of(square, &options);
  EXPECT_EQ(report.collapsed_triangles, 1U);
  EXPECT_EQ(report.triangles, 1U);
  EXPECT_DOUBLE_EQ(report.merge_error, 0.01);
  abut_shape* mesh = nullptr;
  require(abut_mesh_create(square.xyz.data(), 4, square.triangles.data(), 2, &options, &mesh));
  std::array<double, 12> xyz{};
  std::array<std::uint32_t, 6> triangles{};
  std::size_t vertices = 0, count = 0;
  require(abut_shape_triangles(mesh, xyz.data(), 4, &vertices, triangles.data(), 2, &count));
  abut_shape_release(mesh);
  EXPECT_EQ(vertices, 4U);
  EXPECT_EQ(triangles, (std::array<std::uint32_t, 6>{0, 0, 0, 0, 1, 3}));
}

constexpr std::array<double, 15> corners{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0};
constexpr std::array<std::uint32_t, 8> quads{0, 1, 2, 3, 1, 4, 2, 2};
constexpr std::array<std::uint32_t, 12> halves{0, 1, 2, 0, 2, 3, 1, 4, 2, 1, 1, 1};

std::vector<std::uint32_t> indices_of(const abut_shape* shape) {
  std::size_t vertices = 0, count = 0;
  require(abut_shape_triangles(shape, nullptr, 0, &vertices, nullptr, 0, &count));
  std::vector<std::uint32_t> out(3 * count);
  std::vector<double> xyz(3 * vertices);
  require(abut_shape_triangles(shape, xyz.data(), vertices, &vertices, out.data(), count, &count));
  return out;
}

TEST(Quads, AreSplitFromTheFirstCornerToTheThird) {
  abut_mesh_options options;
  abut_mesh_options_init(&options, sizeof options);
  options.corners = 4;
  abut_uv_grid_options cells;
  abut_uv_grid_options_init(&cells, sizeof cells);
  cells.corners = 4;
  const std::vector<std::uint32_t> expected(halves.begin(), halves.end());
  for (const bool is_grid : {false, true}) {
    abut_shape* shape = nullptr;
    require(is_grid ? abut_uv_grid_create(corners.data(), 5, quads.data(), 2, &cells, &shape)
                    : abut_mesh_create(corners.data(), 5, quads.data(), 2, &options, &shape));
    EXPECT_EQ(indices_of(shape), expected);
    abut_shape_release(shape);
  }
  abut_mesh_report report;
  abut_mesh_report_init(&report, sizeof report);
  require(abut_mesh_describe(corners.data(), 5, quads.data(), 2, &options, &report));
  EXPECT_EQ(report.triangles, 3U);
  EXPECT_EQ(report.open_edges, 5U);
}

}  // namespace
