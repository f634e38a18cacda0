// SPDX-License-Identifier: Apache-2.0
// Meshes that deform, and their closest features in more digits, by trying all pairs.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <tuple>
#include <vector>

#include "support.hpp"

namespace abut_test {

using Wide = long double;
using Wide3 = std::array<Wide, 3>;

struct Surface {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;

  std::size_t vertex_count() const { return xyz.size() / 3; }
  std::size_t face_count() const { return triangles.size() / 3; }
  Wide3 vertex(std::uint32_t i) const { return {xyz.at(3 * i), xyz.at(3 * i + 1), xyz.at(3 * i + 2)}; }
  std::array<std::uint32_t, 3> face(std::uint32_t i) const {
    return {triangles.at(3 * i), triangles.at(3 * i + 1), triangles.at(3 * i + 2)};
  }
  bool is_face(std::uint32_t i) const {
    const auto [a, b, c] = face(i);
    return a != b && b != c && c != a;
  }
  // Sorted, the lower end first.
  std::vector<std::array<std::uint32_t, 2>> edges() const {
    std::set<std::array<std::uint32_t, 2>> all;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      const std::uint32_t a = triangles.at(i), b = triangles.at(i - i % 3 + (i + 1) % 3);
      if (a != b) all.insert({std::min(a, b), std::max(a, b)});
    }
    return {all.begin(), all.end()};
  }
};

// side * side vertices in folds, each moved at random.
inline Surface folded_surface(std::uint32_t side, double noise, std::mt19937& random) {
  Surface out;
  std::uniform_real_distribution<double> share(-noise, noise);
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      const double along = 4.0 * i / (side - 1), fold = std::floor(along), rest = along - fold;
      const double height = std::fmod(fold, 2) < 1 ? rest : 1 - rest;
      for (const double value : {0.06 * along, double(j) / (side - 1), height})
        out.xyz.push_back(value + share(random));
      if (i + 1 < side && j + 1 < side) {
        const std::uint32_t a = i * side + j, b = a + side;
        out.triangles.insert(out.triangles.end(), {a, b, b + 1, a, b + 1, a + 1});
      }
    }
  }
  return out;
}

inline Wide3 operator-(const Wide3& a, const Wide3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Wide3 along(const Wide3& from, const Wide3& way, Wide share) {
  return {from[0] + share * way[0], from[1] + share * way[1], from[2] + share * way[2]};
}
inline Wide product(const Wide3& a, const Wide3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Wide length(const Wide3& a) { return std::sqrt(product(a, a)); }

// The closest feature of a triangle by its vertices, and how far it is.
struct ClosestFeature {
  std::vector<std::uint32_t> vertices;  // sorted
  Wide distance;
};
inline ClosestFeature closest_on_edge(const Wide3& point, const Surface& mesh, std::uint32_t a, std::uint32_t b) {
  const Wide3 start = mesh.vertex(a), way = mesh.vertex(b) - start;
  const Wide share = product(point - start, way) / product(way, way);
  if (share <= 0) return {{a}, length(point - start)};
  if (share >= 1) return {{b}, length(point - mesh.vertex(b))};
  return {{std::min(a, b), std::max(a, b)}, length(point - along(start, way, share))};
}
// The foot on the plane by normal equations; outside of the face it is on an edge.
inline ClosestFeature closest_on_face(const Wide3& point, const Surface& mesh, std::uint32_t face) {
  auto corners = mesh.face(face);
  const Wide3 origin = mesh.vertex(corners[0]), u = mesh.vertex(corners[1]) - origin,
              v = mesh.vertex(corners[2]) - origin, w = point - origin;
  const Wide uu = product(u, u), uv = product(u, v), vv = product(v, v), wu = product(w, u), wv = product(w, v);
  const Wide whole = uu * vv - uv * uv, first = (vv * wu - uv * wv) / whole, second = (uu * wv - uv * wu) / whole;
  if (first > 0 && second > 0 && first + second < 1) {
    std::sort(corners.begin(), corners.end());
    return {{corners.begin(), corners.end()}, length(point - along(along(origin, u, first), v, second))};
  }
  ClosestFeature best{{}, INFINITY};
  for (std::size_t i = 0; i < 3; ++i) {
    const ClosestFeature its = closest_on_edge(point, mesh, corners.at(i), corners.at((i + 1) % 3));
    if (its.distance < best.distance) best = its;
  }
  return best;
}
// Strictly inside both, by the two normal equations; none for parallel edges.
inline std::optional<Wide> distance_inside_edges(const Surface& a, const std::array<std::uint32_t, 2>& of_a,
                                                 const Surface& b, const std::array<std::uint32_t, 2>& of_b) {
  const Wide3 p = a.vertex(of_a[0]), q = b.vertex(of_b[0]), u = a.vertex(of_a[1]) - p, v = b.vertex(of_b[1]) - q,
              w = p - q;
  const Wide uu = product(u, u), uv = product(u, v), vv = product(v, v), uw = product(u, w), vw = product(v, w);
  const Wide whole = uu * vv - uv * uv;
  if (!(whole > 1e-12L * uu * vv)) return std::nullopt;
  const Wide first = (uv * vw - vv * uw) / whole, second = (uu * vw - uv * uw) / whole;
  if (!(first > 0 && first < 1 && second > 0 && second < 1)) return std::nullopt;
  return length(along(p, u, first) - along(q, v, second));
}

template <class A, class B>
bool have_common(const A& a, const B& b) {
  return std::any_of(a.begin(), a.end(), [&](auto x) { return std::find(b.begin(), b.end(), x) != b.end(); });
}

// What a stencil is of: vertices of a, then those of b, each sorted.
using Features = std::pair<std::vector<std::uint32_t>, std::vector<std::uint32_t>>;
using Told = std::map<Features, double>;  // to the distance

inline std::size_t vertex_count_of(abut_stencil_kind kind) {
  return kind == ABUT_STENCIL_VERTEX_VERTEX ? 2 : kind == ABUT_STENCIL_VERTEX_EDGE ? 3 : 4;
}
inline Features features_of(const abut_stencil& its) {
  Features out;
  for (std::size_t i = 0; i < vertex_count_of(its.kind); ++i) {
    (i < its.of_a ? out.first : out.second).push_back(its.vertices[i]);
  }
  std::sort(out.first.begin(), out.first.end());
  std::sort(out.second.begin(), out.second.end());
  return out;
}
inline Told told(const std::vector<abut_stencil>& stencils) {
  Told out;
  for (const abut_stencil& its : stencils) {
    EXPECT_TRUE(out.emplace(features_of(its), its.distance).second) << "told twice";
  }
  return out;
}

// All pairs of a vertex and a face with no vertex in common, of one mesh or of two.
struct NearVertex {
  Features features;
  std::uint32_t vertex;
  bool is_of_b;
  Wide distance;
  std::vector<std::uint32_t> feature;  // that is near it
};
inline std::vector<NearVertex> near_vertices(const Surface& a, const Surface& b, double reach) {
  std::vector<NearVertex> out;
  const bool is_one = &a == &b;
  for (const bool is_of_b : {false, true}) {
    const Surface &own = is_of_b ? b : a, &other = is_of_b ? a : b;
    for (std::uint32_t vertex = 0; vertex < own.vertex_count() && !(is_one && is_of_b); ++vertex) {
      for (std::uint32_t face = 0; face < other.face_count(); ++face) {
        if (!other.is_face(face) || (is_one && have_common(std::array{vertex}, other.face(face)))) continue;
        const ClosestFeature its = closest_on_face(own.vertex(vertex), other, face);
        if (its.distance > reach) continue;
        Features features = is_of_b ? Features{its.vertices, {vertex}} : Features{{vertex}, its.vertices};
        // Two vertices are told once.
        if (is_one && its.vertices.size() == 1 && its.vertices[0] < vertex) std::swap(features.first, features.second);
        out.push_back({features, vertex, is_of_b, its.distance, its.vertices});
      }
    }
  }
  return out;
}
inline Told near_edges(const Surface& a, const Surface& b, double reach) {
  Told out;
  const auto edges_a = a.edges(), edges_b = b.edges();
  for (std::size_t i = 0; i < edges_a.size(); ++i) {
    for (std::size_t j = &a == &b ? i + 1 : 0; j < edges_b.size(); ++j) {
      if (&a == &b && have_common(edges_a[i], edges_b[j])) continue;
      const auto distance = distance_inside_edges(a, edges_a[i], b, edges_b[j]);
      if (!distance || *distance > reach) continue;
      out[{{edges_a[i].begin(), edges_a[i].end()}, {edges_b[j].begin(), edges_b[j].end()}}] = double(*distance);
    }
  }
  return out;
}
inline void expect_same(const Told& got, const Told& wanted) {
  EXPECT_EQ(got.size(), wanted.size());
  for (const auto& [features, distance] : wanted) {
    const auto found = got.find(features);
    if (found == got.end()) {
      ADD_FAILURE() << "left out at " << distance;
      continue;
    }
    EXPECT_NEAR(found->second, distance, 1e-13);
  }
}

inline std::vector<double> moved(const Surface& mesh, double by, std::mt19937& random) {
  std::uniform_real_distribution<double> share(-by, by);
  std::vector<double> out = mesh.xyz;
  for (double& value : out) value += share(random);
  return out;
}
// Kind, how many vertices are of a, and both elements.
using Touches = std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>>;
// All pairs on their ways, one after the other.
inline Touches touches_by_all_pairs(const Surface& a, const std::vector<double>& end_a, const Surface& b,
                                    const std::vector<double>& end_b, double separation) {
  Touches out;
  const bool is_one = &a == &b;
  const auto touch = [&](auto ask, const std::vector<std::pair<bool, std::uint32_t>>& vertices) {
    std::array<double, 12> start{}, end{};
    for (std::size_t i = 0; i < 12; ++i) {
      const auto [is_of_b, vertex] = vertices.at(i / 3);
      start.at(i) = (is_of_b ? b : a).xyz.at(3 * vertex + i % 3);
      end.at(i) = (is_of_b ? end_b : end_a).at(3 * vertex + i % 3);
    }
    abut_first_touch first{};
    require(ask(start.data(), end.data(), 1, separation, 1e-9, &first));
    return first.touches != 0;
  };
  for (const bool is_of_b : {false, true}) {
    const Surface &own = is_of_b ? b : a, &other = is_of_b ? a : b;
    for (std::uint32_t vertex = 0; vertex < own.vertex_count() && !(is_one && is_of_b); ++vertex) {
      for (std::uint32_t face = 0; face < other.face_count(); ++face) {
        const auto corners = other.face(face);
        if (is_one && have_common(std::array{vertex}, corners)) continue;
        if (touch(abut_vertices_touch_faces,
                  {{is_of_b, vertex}, {!is_of_b, corners[0]}, {!is_of_b, corners[1]}, {!is_of_b, corners[2]}})) {
          out.insert({ABUT_STENCIL_VERTEX_FACE, is_of_b ? 3 : 1, is_of_b ? face : vertex, is_of_b ? vertex : face});
        }
      }
    }
  }
  const auto edges_a = a.edges(), edges_b = b.edges();
  for (std::uint32_t i = 0; i < edges_a.size(); ++i) {
    for (std::uint32_t j = is_one ? i + 1 : 0; j < edges_b.size(); ++j) {
      if (is_one && have_common(edges_a[i], edges_b[j])) continue;
      if (touch(abut_edges_touch_edges,
                {{false, edges_a[i][0]}, {false, edges_a[i][1]}, {true, edges_b[j][0]}, {true, edges_b[j][1]}})) {
        out.insert({ABUT_STENCIL_EDGE_EDGE, 2, i, j});
      }
    }
  }
  return out;
}

// Owns elements; the tests read like calls of the C interface.
class ElementsOf {
 public:
  explicit ElementsOf(const abut_shape* shape) { require(abut_elements_create(shape, &elements_)); }
  explicit ElementsOf(const Surface& mesh)
      : ElementsOf(static_cast<const abut_shape*>(make_of_kind("mesh", {0}, mesh.xyz, mesh.triangles))) {}
  ElementsOf(const ElementsOf&) = delete;
  ElementsOf& operator=(const ElementsOf&) = delete;
  ~ElementsOf() { abut_elements_destroy(elements_); }
  operator abut_elements*() const { return elements_; }  // NOLINT(google-explicit-constructor)

 private:
  abut_elements* elements_ = nullptr;
};

inline abut_elements_options elements_options(double reach, abut_closest_method method = ABUT_CLOSEST_FEATURES) {
  auto options = filled_by(abut_elements_options_init);
  options.reach = reach;
  options.method = method;
  return options;
}

template <class Value, class Ask>
std::vector<Value> all_of(Ask ask, abut_elements* a, abut_elements* b, const abut_elements_options& options) {
  std::size_t count = 0;
  require(ask(a, b, &options, nullptr, 0, &count));
  std::vector<Value> out(count);
  require(ask(a, b, &options, out.data(), out.size(), &count));
  EXPECT_EQ(count, out.size());
  return out;
}
inline std::vector<abut_stencil> closest_of(abut_elements* a, abut_elements* b, const abut_elements_options& options) {
  return all_of<abut_stencil>(abut_elements_closest, a, b, options);
}
inline std::vector<abut_stencil> touches_of(abut_elements* a, abut_elements* b, const abut_elements_options& options) {
  return all_of<abut_stencil>(abut_elements_first_touches, a, b, options);
}

}  // namespace abut_test
