// SPDX-License-Identifier: Apache-2.0
#include "deforming_truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "oracle/closest.hpp"
#include "oracle/exact.hpp"
#include "oracle/quad.hpp"

namespace bench {
namespace {

using oracle::quad;
using oracle::Quad;
using oracle::Vec;

Vec vec(const Point& p) { return {quad(p[0]), quad(p[1]), quad(p[2])}; }

// A vertex, an edge or a face, from start to end.
struct Feature {
  std::vector<std::uint32_t> vertices;
  std::vector<Point> starts, ends;
  Point low{}, high{};

  Feature(const Deforming& mesh, std::span<const std::uint32_t> its, bool is_moving)
      : vertices(its.begin(), its.end()) {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (const std::uint32_t vertex : its) {
      starts.push_back(mesh.start[vertex]);
      ends.push_back(is_moving ? mesh.end[vertex] : mesh.start[vertex]);
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min({low[i], starts.back()[i], ends.back()[i]});
        high[i] = std::max({high[i], starts.back()[i], ends.back()[i]});
      }
    }
  }
  [[nodiscard]] Vec at(std::size_t corner, Quad time) const {
    return vec(starts[corner]) * (1 - time) + vec(ends[corner]) * time;
  }
};

using Features = std::vector<Feature>;

Features vertices_of(const Deforming& mesh, bool is_moving) {
  Features list;
  for (std::uint32_t i = 0; i < mesh.start.size(); ++i) {
    list.emplace_back(mesh, std::span(&i, 1), is_moving);
  }
  return list;
}
Features edges_of(const Deforming& mesh, bool is_moving) {
  Features list;
  for (const auto& edge : mesh.edges) {
    list.emplace_back(mesh, edge, is_moving);
  }
  return list;
}
Features faces_of(const Deforming& mesh, bool is_moving) {
  Features list;
  for (const auto& face : mesh.triangles) {
    list.emplace_back(mesh, face, is_moving);
  }
  return list;
}

// Along one axis at least their boxes are further apart than that. Doubles decide what is not close.
bool is_beyond(const Feature& a, const Feature& b, double reach) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double apart = std::max(a.low[i] - b.high[i], b.low[i] - a.high[i]);
    if (apart > 1.001 * reach + 1e-12) {
      return true;
    }
    if (apart > 0.999 * reach - 1e-12) {
      const Quad one = quad(a.low[i]) - quad(b.high[i]), other = quad(b.low[i]) - quad(a.high[i]);
      if (oracle::larger(one, other) > quad(reach)) {
        return true;
      }
    }
  }
  return false;
}

bool have_common(const Feature& a, const Feature& b) {
  return std::ranges::any_of(a.vertices, [&b](std::uint32_t vertex) { return std::ranges::count(b.vertices, vertex); });
}

// Each two of both lists that are a pair, and whose boxes come within reach.
template <class Use>
void for_each_pair(const Features& a, const Features& b, bool is_one_list, bool is_one_mesh, double reach,
                   const Use& use) {
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    for (std::uint32_t j = is_one_list ? i + 1 : 0; j < b.size(); ++j) {
      if (!is_beyond(a[i], b[j], reach) && !(is_one_mesh && have_common(a[i], b[j]))) {
        use(i, j);
      }
    }
  }
}

Quad square_to_face(const Feature& vertex, const Feature& face, Quad time) {
  const Vec p = vertex.at(0, time), a = face.at(0, time), b = face.at(1, time), c = face.at(2, time);
  if (const std::optional<Vec> foot = oracle::foot_in_triangle(p, a, b, c)) {
    return oracle::pair_of(p, *foot).squared;
  }
  return oracle::smaller(oracle::closest_of_segments(p, p, a, b).squared,
                         oracle::smaller(oracle::closest_of_segments(p, p, b, c).squared,
                                         oracle::closest_of_segments(p, p, c, a).squared));
}

Quad square_of_edges(const Feature& a, const Feature& b, Quad time) {
  return oracle::closest_of_segments(a.at(0, time), a.at(1, time), b.at(0, time), b.at(1, time)).squared;
}

Quad determinant(const Vec& a, const Vec& b, const Vec& c) { return oracle::dot(oracle::cross(a, b), c); }

// A cubic of the time: the volume that four moving points span.
struct Cubic {
  std::array<Quad, 4> c{};

  [[nodiscard]] Quad at(Quad t) const { return ((c[3] * t + c[2]) * t + c[1]) * t + c[0]; }

  // From its values at the ends of pieces in which it rises or falls.
  [[nodiscard]] std::vector<Quad> zeros() const {
    std::vector<Quad> ends{0};
    const Quad a = 3 * c[3], half = c[2], discriminant = half * half - a * c[1];
    if (discriminant > 0) {
      // Without a difference of numbers that are nearly equal.
      const Quad root = oracle::square_root(discriminant), sum = half > 0 ? -half - root : -half + root;
      std::array<Quad, 2> turns{a != 0 ? sum / a : Quad{-1}, sum != 0 ? c[1] / sum : Quad{-1}};
      std::ranges::sort(turns);
      for (const Quad turn : turns) {
        if (turn > 0 && turn < 1) {
          ends.push_back(turn);
        }
      }
    }
    ends.push_back(1);
    std::vector<Quad> list;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      Quad low = ends[i], high = ends[i + 1];
      const bool rises = at(high) > at(low);
      if ((at(low) > 0) == (at(high) > 0)) {
        continue;
      }
      for (int halving = 0; halving < 110; ++halving) {
        const Quad middle = (low + high) / 2;
        ((at(middle) > 0) == rises ? high : low) = middle;
      }
      list.push_back(high);
    }
    return list;
  }
};

// The volume of p with three others, each relative to p, as a cubic of time.
Cubic volume(const std::array<Vec, 4>& start, const std::array<Vec, 4>& end) {
  std::array<Vec, 3> d, e;
  for (std::size_t i = 0; i < 3; ++i) {
    d[i] = start[i + 1] - start[0];
    e[i] = (end[i + 1] - end[0]) - d[i];
  }
  return {{determinant(d[0], d[1], d[2]),
           determinant(e[0], d[1], d[2]) + determinant(d[0], e[1], d[2]) + determinant(d[0], d[1], e[2]),
           determinant(d[0], e[1], e[2]) + determinant(e[0], d[1], e[2]) + determinant(e[0], e[1], d[2]),
           determinant(e[0], e[1], e[2])}};
}

// At a zero of their volume two features touch or are apart by much more than rounding.
constexpr double touching = 1e-20;

template <class Square>
std::optional<Quad> first_touch(const Feature& a, const Feature& b, const Square& square) {
  std::array<Vec, 4> start, end;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool is_of_a = i < a.vertices.size();
    const Feature& its = is_of_a ? a : b;
    const std::size_t corner = is_of_a ? i : i - a.vertices.size();
    start[i] = vec(its.starts[corner]);
    end[i] = vec(its.ends[corner]);
  }
  for (const Quad time : volume(start, end).zeros()) {
    if (square(a, b, time) <= quad(touching * touching)) {
      return time;
    }
  }
  return std::nullopt;
}

bool passes(const Feature& edge, const Feature& face) {
  return oracle::meets(edge.at(0, 0), edge.at(1, 0), {face.at(0, 0), face.at(1, 0), face.at(2, 0)});
}

class Truth {
 public:
  Truth(Asked asked, const DeformingCase& step)
      : is_one_(step.is_of_one()),
        step_(step),
        vertices_a_(vertices_of(step.a, is_moving(asked))),
        edges_a_(edges_of(step.a, is_moving(asked))),
        faces_a_(faces_of(step.a, is_moving(asked))) {
    if (!is_one_) {
      vertices_b_ = vertices_of(step.b, is_moving(asked));
      edges_b_ = edges_of(step.b, is_moving(asked));
      faces_b_ = faces_of(step.b, is_moving(asked));
    }
    switch (asked) {
      case Asked::candidates: candidates(); break;
      case Asked::closest: closest(); break;
      case Asked::impact: impacts(); break;
      case Asked::overlap: crossings(); break;
      case Asked::distance: distance(); break;
    }
    std::ranges::sort(found_.pairs, {}, &ElementPair::key);
    found_.is_yes = !found_.pairs.empty();
  }
  [[nodiscard]] Found found() && { return std::move(found_); }

 private:
  static bool is_moving(Asked asked) { return asked == Asked::candidates || asked == Asked::impact; }
  [[nodiscard]] const Features& vertices_b() const { return is_one_ ? vertices_a_ : vertices_b_; }
  [[nodiscard]] const Features& edges_b() const { return is_one_ ? edges_a_ : edges_b_; }
  [[nodiscard]] const Features& faces_b() const { return is_one_ ? faces_a_ : faces_b_; }

  // Calls `vertex(kind, number of a, number of b, vertex, face)` and `edges(number of a, number of b)`.
  template <class Vertex, class Edges>
  void for_each_near(double reach, const Vertex& vertex, const Edges& edges) const {
    for_each_pair(vertices_a_, faces_b(), false, is_one_, reach, [&](std::uint32_t i, std::uint32_t j) {
      vertex(PairKind::vertex_face, i, j, vertices_a_[i], faces_b()[j]);
    });
    if (!is_one_) {
      for_each_pair(faces_a_, vertices_b_, false, false, reach, [&](std::uint32_t i, std::uint32_t j) {
        vertex(PairKind::face_vertex, i, j, vertices_b_[j], faces_a_[i]);
      });
    }
    for_each_pair(edges_a_, edges_b(), is_one_, is_one_, reach, edges);
  }

  void candidates() {
    for_each_near(
        step_.reach,
        [this](PairKind kind, std::uint32_t i, std::uint32_t j, const Feature&, const Feature&) {
          found_.pairs.push_back({kind, i, j});
        },
        [this](std::uint32_t i, std::uint32_t j) { found_.pairs.push_back({PairKind::edge_edge, i, j}); });
  }

  void impacts() {
    for_each_near(
        0,
        [this](PairKind kind, std::uint32_t i, std::uint32_t j, const Feature& vertex, const Feature& face) {
          if (const auto time = first_touch(vertex, face, square_to_face)) {
            found_.pairs.push_back({kind, i, j, static_cast<double>(*time)});
          }
        },
        [this](std::uint32_t i, std::uint32_t j) {
          if (const auto time = first_touch(edges_a_[i], edges_b()[j], square_of_edges)) {
            found_.pairs.push_back({PairKind::edge_edge, i, j, static_cast<double>(*time)});
          }
        });
  }

  void closest() {
    found_.distances.assign(vertices_a_.size() + vertices_b_.size(), std::numeric_limits<double>::infinity());
    for_each_near(
        step_.reach,
        [this](PairKind kind, std::uint32_t i, std::uint32_t j, const Feature& vertex, const Feature& face) {
          double& its = found_.distances[kind == PairKind::vertex_face ? i : vertices_a_.size() + j];
          const auto length = static_cast<double>(oracle::square_root(square_to_face(vertex, face, 0)));
          its = length <= step_.reach ? std::min(its, length) : its;
        },
        [](std::uint32_t, std::uint32_t) {});
  }

  void crossings() {
    for_each_pair(edges_a_, faces_b(), false, is_one_, 0, [this](std::uint32_t i, std::uint32_t j) {
      if (passes(edges_a_[i], faces_b()[j])) {
        found_.pairs.push_back({PairKind::edge_face, i, j});
      }
    });
    for_each_pair(faces_a_, edges_b_, false, false, 0, [this](std::uint32_t i, std::uint32_t j) {
      if (passes(edges_b_[j], faces_a_[i])) {
        found_.pairs.push_back({PairKind::face_edge, i, j});
      }
    });
  }

  // Boxes that are within the distance of any two vertices hold the nearest two features.
  void distance() {
    Quad least = oracle::pair_of(vertices_a_[0].at(0, 0), vertices_b_[0].at(0, 0)).squared;
    for (const Feature& a : vertices_a_) {
      for (const Feature& b : vertices_b_) {
        const double x = a.low[0] - b.low[0], y = a.low[1] - b.low[1], z = a.low[2] - b.low[2];
        least = oracle::smaller(least, quad(1.001 * (x * x + y * y + z * z)));
      }
    }
    const auto reach = static_cast<double>(oracle::square_root(least));
    const auto keep = [&least](Quad square) { least = oracle::smaller(least, square); };
    for_each_near(
        reach,
        [&](PairKind, std::uint32_t, std::uint32_t, const Feature& vertex, const Feature& face) {
          keep(square_to_face(vertex, face, 0));
        },
        [&](std::uint32_t i, std::uint32_t j) { keep(square_of_edges(edges_a_[i], edges_b()[j], 0)); });
    found_.distances = {static_cast<double>(oracle::square_root(least))};
  }

  bool is_one_;
  const DeformingCase& step_;
  Features vertices_a_, edges_a_, faces_a_, vertices_b_, edges_b_, faces_b_;
  Found found_;
};

}  // namespace

Found deforming_truth(Asked asked, const DeformingCase& step) { return Truth(asked, step).found(); }

}  // namespace bench
