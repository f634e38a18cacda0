// SPDX-License-Identifier: Apache-2.0
// For contenders that have no tree of elements: boxes around elements from start to end, and pairs that count. The
// truth does not use them.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "deforming_ways.hpp"

namespace bench {

struct Bounds {
  Point low{}, high{};
};

// `with_end`: false where the vertices rest at their start.
[[nodiscard]] inline Bounds bounds_of(const Deforming& mesh, std::span<const std::uint32_t> vertices, bool with_end) {
  Bounds box{mesh.start[vertices[0]], mesh.start[vertices[0]]};
  const auto include = [&box](const Point& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      box.low[i] = std::min(box.low[i], p[i]);
      box.high[i] = std::max(box.high[i], p[i]);
    }
  };
  for (const std::uint32_t vertex : vertices) {
    include(mesh.start[vertex]);
    if (with_end) {
      include(mesh.end[vertex]);
    }
  }
  return box;
}

// The vertices, edges or faces of a mesh.
struct Elements {
  std::vector<std::array<std::uint32_t, 3>> vertices;  // the last one repeated
  std::vector<Bounds> boxes;
};

template <std::size_t count>
[[nodiscard]] Elements elements_of(const Deforming& mesh, std::span<const std::array<std::uint32_t, count>> list,
                                   bool with_end) {
  Elements result;
  for (const auto& its : list) {
    result.vertices.push_back({its[0], its[count > 1 ? 1 : 0], its[count - 1]});
    result.boxes.push_back(bounds_of(mesh, its, with_end));
  }
  return result;
}

struct AllElements {
  Elements vertices, edges, faces;

  AllElements(const Deforming& mesh, bool with_end)
      : edges(elements_of<2>(mesh, mesh.edges, with_end)), faces(elements_of<3>(mesh, mesh.triangles, with_end)) {
    std::vector<std::array<std::uint32_t, 1>> all(mesh.start.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      all[i] = {i};
    }
    vertices = elements_of<1>(mesh, all, with_end);
  }
};

[[nodiscard]] inline bool share_a_vertex(std::span<const std::uint32_t> one, std::span<const std::uint32_t> other) {
  return std::ranges::any_of(one,
                             [other](std::uint32_t vertex) { return std::ranges::find(other, vertex) != other.end(); });
}

// Two lists of elements that are asked against each other.
struct Sides {
  PairKind kind;
  const Elements& a;
  const Elements& b;
  bool is_one_list;  // each pair of it once
  bool is_one_mesh;

  [[nodiscard]] bool counts(std::size_t i, std::size_t j) const {
    return !(is_one_list && i >= j) && !(is_one_mesh && share_a_vertex(a.vertices[i], b.vertices[j]));
  }
};

// Calls `use` with the sides of candidates.
template <class Use>
void for_each_sides(const DeformingCase& step, const AllElements& a, const AllElements& b, const Use& use) {
  const bool is_one = step.is_of_one();
  use(Sides{PairKind::vertex_face, a.vertices, b.faces, false, is_one});
  if (!is_one) {
    use(Sides{PairKind::face_vertex, a.faces, b.vertices, false, false});
  }
  use(Sides{PairKind::edge_edge, a.edges, b.edges, is_one, is_one});
}

[[nodiscard]] inline bool are_near(const Bounds& a, const Bounds& b, double reach) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.low[i] - b.high[i] > reach || b.low[i] - a.high[i] > reach) {
      return false;
    }
  }
  return true;
}

// By a sweep along the first axis: calls `use` with the numbers of each two whose boxes come within reach and that
// count.
template <class Use>
void sweep(const Sides& sides, double reach, const Use& use) {
  const auto order_of = [](const Elements& elements) {
    std::vector<std::uint32_t> order(elements.boxes.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      order[i] = i;
    }
    std::ranges::sort(order, {}, [&elements](std::uint32_t i) { return elements.boxes[i].low[0]; });
    return order;
  };
  const std::vector<std::uint32_t> order_a = order_of(sides.a), order_b = order_of(sides.b);
  const auto look = [&](std::uint32_t i, std::uint32_t j) {
    if (are_near(sides.a.boxes[i], sides.b.boxes[j], reach) && sides.counts(i, j)) {
      use(i, j);
    }
  };
  // Where two boxes overlap along the axis, the one that begins later finds the other.
  std::size_t from_a = 0, from_b = 0;
  while (from_a < order_a.size() && from_b < order_b.size()) {
    const std::uint32_t i = order_a[from_a], j = order_b[from_b];
    const Bounds &box_a = sides.a.boxes[i], &box_b = sides.b.boxes[j];
    if (box_a.low[0] < box_b.low[0]) {
      for (std::size_t k = from_b; k < order_b.size() && sides.b.boxes[order_b[k]].low[0] - box_a.high[0] <= reach;
           ++k) {
        look(i, order_b[k]);
      }
      ++from_a;
    } else {
      for (std::size_t k = from_a; k < order_a.size() && sides.a.boxes[order_a[k]].low[0] - box_b.high[0] <= reach;
           ++k) {
        look(order_a[k], j);
      }
      ++from_b;
    }
  }
}

}  // namespace bench
