// SPDX-License-Identifier: Apache-2.0
// Through the C interface: elements that are kept from step to step, elements and meshes that are made anew. Pairs that
// a sweep finds are decided one by one.
#include <abut/abut.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "deforming_boxes.hpp"

namespace bench {
namespace {

void require(abut_status status) {
  if (status != ABUT_OK) {
    throw std::runtime_error(abut_last_error_message());
  }
}

struct ReleaseShape {
  void operator()(abut_shape* shape) const { abut_shape_release(shape); }
};
struct DestroyElements {
  void operator()(abut_elements* elements) const { abut_elements_destroy(elements); }
};
using Shape = std::unique_ptr<abut_shape, ReleaseShape>;
using Kept = std::unique_ptr<abut_elements, DestroyElements>;

Shape shape_of(const Deforming& mesh) {
  abut_shape* shape = nullptr;
  require(abut_mesh_create(mesh.start.front().data(), mesh.start.size(), mesh.triangles.front().data(),
                           mesh.triangles.size(), nullptr, &shape));
  return Shape(shape);
}

Kept elements_of(const Deforming& mesh) {
  abut_elements* elements = nullptr;
  require(abut_elements_create(shape_of(mesh).get(), &elements));
  return Kept(elements);
}

// A search by count-then-fill; the array keeps its size from step to step.
template <class Value>
class Search {
 public:
  template <class Ask>
  std::span<const Value> found(Ask ask, abut_elements* a, abut_elements* b, const abut_elements_options& options) {
    std::size_t count = 0;
    require(ask(a, b, &options, values_.data(), values_.size(), &count));
    if (count > values_.size()) {
      values_.resize(count + count / 4);
      require(ask(a, b, &options, values_.data(), values_.size(), &count));
    }
    return std::span(values_).first(count);
  }

 private:
  std::vector<Value> values_;
};

struct Settings {
  abut_closest_method method = ABUT_CLOSEST_FEATURES;
  bool is_kept = true;
};

class OfElements final : public DeformingWay {
 public:
  OfElements(Asked asked, const DeformingCase& first, Settings settings) : asked_(asked), settings_(settings) {
    make(first);
    abut_elements_options_init(&options_, sizeof options_);
    options_.method = settings.method;
    options_.threads = 1;
    reach_ = first.reach;
  }

  void answer(const DeformingCase& step, Found& found) override {
    if (!settings_.is_kept) {
      make(step);
    }
    set(a_.get(), step.a);
    if (b_) {
      set(b_.get(), step.b);
    }
    found.pairs.clear();
    options_.reach = step.reach;
    switch (asked_) {
      case Asked::candidates: candidates(found); break;
      case Asked::closest: closest(step, found); break;
      case Asked::impact: impacts(found); break;
      case Asked::overlap: crossings(found); break;
      case Asked::distance: distance(found); break;
    }
  }

 private:
  void make(const DeformingCase& step) {
    a_ = elements_of(step.a);
    b_ = step.is_of_one() ? nullptr : elements_of(step.b);
  }
  void set(abut_elements* elements, const Deforming& mesh) const {
    const bool is_moving = asked_ == Asked::candidates || asked_ == Asked::impact;
    require(abut_elements_set_vertices(elements, mesh.start.front().data(),
                                       is_moving ? mesh.end.front().data() : nullptr, mesh.start.size()));
  }

  void candidates(Found& found) {
    for (const abut_element_pair& pair : pairs_.found(abut_elements_candidates, a_.get(), b_.get(), options_)) {
      const bool is_turned = pair.kind == ABUT_ELEMENT_PAIR_EDGE_EDGE && !b_ && pair.a > pair.b;
      const PairKind kind = pair.kind == ABUT_ELEMENT_PAIR_EDGE_EDGE     ? PairKind::edge_edge
                            : pair.kind == ABUT_ELEMENT_PAIR_VERTEX_FACE ? PairKind::vertex_face
                                                                         : PairKind::face_vertex;
      found.pairs.push_back({kind, is_turned ? pair.b : pair.a, is_turned ? pair.a : pair.b});
    }
  }

  void closest(const DeformingCase& step, Found& found) {
    const std::size_t of_a = step.a.start.size();
    found.distances.assign(of_a + step.b.start.size(), std::numeric_limits<double>::infinity());
    const auto keep = [&found](std::size_t vertex, double distance) {
      found.distances[vertex] = std::min(found.distances[vertex], distance);
    };
    for (const abut_stencil& each : stencils_.found(abut_elements_closest, a_.get(), b_.get(), options_)) {
      if (each.kind == ABUT_STENCIL_EDGE_EDGE) {
        continue;
      }
      const bool is_of_two_vertices = each.kind == ABUT_STENCIL_VERTEX_VERTEX;
      if (each.of_a == 1) {
        keep(each.vertices[0], each.distance);
      }
      if (each.of_a != 1 || is_of_two_vertices) {
        keep((b_ ? of_a : 0) + each.vertices[each.of_a], each.distance);
      }
    }
  }

  void impacts(Found& found) {
    options_.reach = 0;
    for (const abut_stencil& each : stencils_.found(abut_elements_first_touches, a_.get(), b_.get(), options_)) {
      if (each.kind == ABUT_STENCIL_EDGE_EDGE) {
        const bool is_turned = !b_ && each.element_a > each.element_b;
        found.pairs.push_back({PairKind::edge_edge, is_turned ? each.element_b : each.element_a,
                               is_turned ? each.element_a : each.element_b, each.toi});
      } else {
        found.pairs.push_back(
            {each.of_a == 1 ? PairKind::vertex_face : PairKind::face_vertex, each.element_a, each.element_b, each.toi});
      }
    }
  }

  void crossings(Found& found) {
    for (const abut_crossing& each : crossings_.found(abut_elements_crossings, a_.get(), b_.get(), options_)) {
      const ElementPair pair = each.edge_is_of_b != 0 ? ElementPair{PairKind::face_edge, each.face, each.edge}
                                                      : ElementPair{PairKind::edge_face, each.edge, each.face};
      // An edge that lies in a face passes it at two places.
      if (found.pairs.empty() || found.pairs.back().key() != pair.key()) {
        found.pairs.push_back(pair);
      }
    }
    found.is_yes = !found.pairs.empty();
  }

  // As far as the last answer, and farther where nothing is there.
  void distance(Found& found) {
    for (options_.reach = reach_;; options_.reach *= 2) {
      double least = std::numeric_limits<double>::infinity();
      for (const abut_stencil& each : stencils_.found(abut_elements_closest, a_.get(), b_.get(), options_)) {
        least = std::min(least, each.distance);
      }
      if (std::isfinite(least)) {
        found.distances = {least};
        reach_ = 1.1 * least;
        return;
      }
    }
  }

  Asked asked_;
  Settings settings_;
  Kept a_, b_;
  abut_elements_options options_{};
  double reach_ = 0;
  Search<abut_element_pair> pairs_;
  Search<abut_stencil> stencils_;
  Search<abut_crossing> crossings_;
};

// The questions to two shapes, with two meshes that are made anew.
class OfShapes final : public DeformingWay {
 public:
  explicit OfShapes(Asked asked) : asked_(asked) {}

  void answer(const DeformingCase& step, Found& found) override {
    const Shape a = shape_of(step.a), b = shape_of(step.b);
    const abut_pose here{{0, 0, 0}, {1, 0, 0, 0}};
    if (asked_ == Asked::overlap) {
      std::uint32_t is_yes = 0;
      require(abut_pair_overlaps(a.get(), &here, b.get(), &here, nullptr, &is_yes));
      found.is_yes = is_yes != 0;
      found.has_pairs = false;
    } else {
      abut_distance distance;
      require(abut_pair_distance(a.get(), &here, b.get(), &here, nullptr, &distance));
      found.distances = {distance.distance};
    }
  }

 private:
  Asked asked_;
};

// First touches of the pairs that a sweep finds, in batches.
class OfPairs final : public DeformingWay {
 public:
  void answer(const DeformingCase& step, Found& found) override {
    found.pairs.clear();
    const AllElements a(step.a, true), b(step.is_of_one() ? step.a : step.b, true);
    const Deforming& mesh_b = step.is_of_one() ? step.a : step.b;
    for_each_sides(step, a, b, [&](const Sides& sides) {
      pairs_.clear();
      starts_.clear();
      ends_.clear();
      sweep(sides, 0, [&](std::uint32_t i, std::uint32_t j) {
        pairs_.push_back({sides.kind, i, j});
        const auto &of_a = sides.a.vertices[i], &of_b = sides.b.vertices[j];
        if (sides.kind == PairKind::edge_edge) {
          add(step.a, {of_a.data(), 2});
          add(mesh_b, {of_b.data(), 2});
        } else if (sides.kind == PairKind::vertex_face) {
          add(step.a, {of_a.data(), 1});
          add(mesh_b, of_b);
        } else {
          add(mesh_b, {of_b.data(), 1});
          add(step.a, of_a);
        }
      });
      touches_.resize(pairs_.size());
      const auto ask = sides.kind == PairKind::edge_edge ? abut_edges_touch_edges : abut_vertices_touch_faces;
      require(ask(starts_.data(), ends_.data(), pairs_.size(), 0, 0, touches_.data()));
      for (std::size_t i = 0; i < pairs_.size(); ++i) {
        if (touches_[i].touches != 0) {
          pairs_[i].value = touches_[i].lower;
          found.pairs.push_back(pairs_[i]);
        }
      }
    });
  }

 private:
  void add(const Deforming& mesh, std::span<const std::uint32_t> vertices) {
    for (const std::uint32_t vertex : vertices) {
      starts_.insert(starts_.end(), mesh.start[vertex].begin(), mesh.start[vertex].end());
      ends_.insert(ends_.end(), mesh.end[vertex].begin(), mesh.end[vertex].end());
    }
  }

  std::vector<ElementPair> pairs_;
  std::vector<double> starts_, ends_;
  std::vector<abut_first_touch> touches_;
};

}  // namespace

std::vector<NamedWay> abut_ways(Asked asked, const DeformingCase& first) {
  std::vector<NamedWay> ways;
  const auto add = [&](std::string name, Settings settings) {
    ways.push_back({std::move(name), std::make_unique<OfElements>(asked, first, settings)});
  };
  add("abut", {});
  if (asked == Asked::closest) {
    add("abut closest_all", {ABUT_CLOSEST_ALL, true});
    add("abut closest_of_vertices", {ABUT_CLOSEST_OF_VERTICES, true});
  }
  if (asked == Asked::impact) {
    ways.push_back({"abut of pairs", std::make_unique<OfPairs>()});
  }
  add("abut new elements", {ABUT_CLOSEST_FEATURES, false});
  if (!first.is_of_one() && (asked == Asked::overlap || asked == Asked::distance)) {
    ways.push_back({"abut new meshes", std::make_unique<OfShapes>(asked)});
  }
  return ways;
}

}  // namespace bench
