// SPDX-License-Identifier: Apache-2.0
// FCL: trees of two meshes that are fitted to their vertices, and its test of two elements on straight lines for the
// pairs of a sweep.
#include <fcl/fcl.h>
#include <fcl/narrowphase/detail/traversal/collision/intersect.h>

#include "deforming_boxes.hpp"

namespace bench {
namespace {

using Vector = Eigen::Vector3d;
using Model = fcl::BVHModel<fcl::OBBRSSd>;

Vector fcl_vector(const Point& p) { return {p[0], p[1], p[2]}; }

std::vector<Vector> starts_of(const Deforming& mesh) {
  std::vector<Vector> list;
  for (const Point& p : mesh.start) {
    list.push_back(fcl_vector(p));
  }
  return list;
}

std::unique_ptr<Model> model_of(const Deforming& mesh) {
  auto model = std::make_unique<Model>();
  std::vector<fcl::Triangle> triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.emplace_back(a, b, c);
  }
  model->beginModel();
  model->addSubModel(starts_of(mesh), triangles);
  model->endModel();
  return model;
}

void fit(Model& model, const Deforming& mesh) {
  model.beginReplaceModel();
  model.replaceSubModel(starts_of(mesh));
  model.endReplaceModel(true, true);
}

class OfMeshes final : public DeformingWay {
 public:
  OfMeshes(Asked asked, const DeformingCase& first, bool is_kept) : asked_(asked), is_kept_(is_kept) { make(first); }

  void answer(const DeformingCase& step, Found& found) override {
    if (is_kept_) {
      fit(*a_, step.a);
      fit(*b_, step.b);
    } else {
      make(step);
    }
    const fcl::Transform3d here = fcl::Transform3d::Identity();
    if (asked_ == Asked::overlap) {
      fcl::CollisionResultd result;
      fcl::collide(a_.get(), here, b_.get(), here, fcl::CollisionRequestd(1, false), result);
      found.is_yes = result.isCollision();
      found.has_pairs = false;
    } else {
      fcl::DistanceResultd result;
      fcl::distance(a_.get(), here, b_.get(), here, fcl::DistanceRequestd(false), result);
      found.distances = {result.min_distance};
    }
  }

 private:
  void make(const DeformingCase& step) {
    a_ = model_of(step.a);
    b_ = model_of(step.b);
  }

  Asked asked_;
  bool is_kept_;
  std::unique_ptr<Model> a_, b_;
};

class OfPairs final : public DeformingWay {
 public:
  void answer(const DeformingCase& step, Found& found) override {
    found.pairs.clear();
    const AllElements a(step.a, true), b(step.is_of_one() ? step.a : step.b, true);
    const Deforming& mesh_b = step.is_of_one() ? step.a : step.b;
    for_each_sides(step, a, b, [&](const Sides& sides) {
      sweep(sides, 0, [&](std::uint32_t i, std::uint32_t j) {
        const auto &of_a = sides.a.vertices[i], &of_b = sides.b.vertices[j];
        double time = 0;
        bool is_touch = false;
        if (sides.kind == PairKind::vertex_face) {
          is_touch = vertex_and_face(step.a, of_a[0], mesh_b, of_b, time);
        } else if (sides.kind == PairKind::face_vertex) {
          is_touch = vertex_and_face(mesh_b, of_b[0], step.a, of_a, time);
        } else {
          is_touch = edges(step.a, of_a, mesh_b, of_b, time);
        }
        if (is_touch) {
          found.pairs.push_back({sides.kind, i, j, time});
        }
      });
    });
  }

 private:
  using Three = std::array<std::uint32_t, 3>;
  using Test = fcl::detail::Intersect<double>;

  static bool vertex_and_face(const Deforming& of_vertex, std::uint32_t vertex, const Deforming& of_face,
                              const Three& face, double& time) {
    const auto start = [&](std::size_t i) { return fcl_vector(of_face.start[face[i]]); };
    const auto end = [&](std::size_t i) { return fcl_vector(of_face.end[face[i]]); };
    Vector point;
    return Test::intersect_VF(start(0), start(1), start(2), fcl_vector(of_vertex.start[vertex]), end(0), end(1), end(2),
                              fcl_vector(of_vertex.end[vertex]), &time, &point);
  }
  static bool edges(const Deforming& mesh_a, const Three& a, const Deforming& mesh_b, const Three& b, double& time) {
    Vector point;
    return Test::intersect_EE(fcl_vector(mesh_a.start[a[0]]), fcl_vector(mesh_a.start[a[1]]),
                              fcl_vector(mesh_b.start[b[0]]), fcl_vector(mesh_b.start[b[1]]),
                              fcl_vector(mesh_a.end[a[0]]), fcl_vector(mesh_a.end[a[1]]), fcl_vector(mesh_b.end[b[0]]),
                              fcl_vector(mesh_b.end[b[1]]), &time, &point);
  }
};

}  // namespace

std::vector<NamedWay> fcl_ways(Asked asked, const DeformingCase& first) {
  std::vector<NamedWay> ways;
  if (asked == Asked::impact) {
    ways.push_back({"fcl", std::make_unique<OfPairs>()});
  }
  if (!first.is_of_one() && (asked == Asked::overlap || asked == Asked::distance)) {
    ways.push_back({"fcl", std::make_unique<OfMeshes>(asked, first, true)});
    ways.push_back({"fcl new meshes", std::make_unique<OfMeshes>(asked, first, false)});
  }
  return ways;
}

}  // namespace bench
