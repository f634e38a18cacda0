// SPDX-License-Identifier: Apache-2.0
// Coal in double precision, with its default solvers: GJK and EPA of its own.
#include <coal/BVH/BVH_model.h>
#include <coal/collision.h>
#include <coal/contact_patch.h>
#include <coal/distance.h>
#include <coal/shape/convex.h>
#include <coal/shape/geometric_shapes.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <vector>

#include "pairs.hpp"

namespace bench {
namespace {

using Geometry = coal::CollisionGeometry;

coal::Transform3s coal_transform(const Placement& placement) {
  const auto& [w, x, y, z] = placement.orientation;
  const Point& p = placement.position;
  return {Eigen::Quaterniond(w, x, y, z).toRotationMatrix(), coal::Vec3s(p[0], p[1], p[2])};
}

std::vector<coal::Vec3s> vertices_of(const Solid& solid) {
  std::vector<coal::Vec3s> vertices;
  for (const Point& p : solid.points) {
    vertices.emplace_back(p[0], p[1], p[2]);
  }
  return vertices;
}

std::vector<coal::Triangle> triangles_of(const Solid& solid) {
  std::vector<coal::Triangle> triangles;
  for (const auto& [a, b, c] : solid.triangles) {
    triangles.emplace_back(static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c));
  }
  return triangles;
}

std::unique_ptr<Geometry> mesh_of(const Solid& solid) {
  auto mesh = std::make_unique<coal::BVHModel<coal::OBBRSS>>();
  mesh->beginModel();
  mesh->addSubModel(vertices_of(solid), triangles_of(solid));
  mesh->endModel();
  return mesh;
}

std::unique_ptr<Geometry> hull_of(const Solid& solid) {
  auto vertices = std::make_shared<std::vector<coal::Vec3s>>(vertices_of(solid));
  auto triangles = std::make_shared<std::vector<coal::Triangle>>(triangles_of(solid));
  return std::make_unique<coal::Convex<coal::Triangle>>(vertices, static_cast<unsigned>(vertices->size()), triangles,
                                                        static_cast<unsigned>(triangles->size()));
}

std::unique_ptr<Geometry> geometry_of(const Solid& solid) {
  const Point& s = solid.sizes;
  switch (solid.kind) {
    case Kind::sphere: return std::make_unique<coal::Sphere>(s[0]);
    case Kind::box: return std::make_unique<coal::Box>(2 * s[0], 2 * s[1], 2 * s[2]);
    case Kind::capsule: return std::make_unique<coal::Capsule>(s[0], 2 * s[1]);
    case Kind::cylinder: return std::make_unique<coal::Cylinder>(s[0], 2 * s[1]);
    case Kind::cone: return std::make_unique<coal::Cone>(s[0], 2 * s[1]);
    case Kind::ellipsoid: return std::make_unique<coal::Ellipsoid>(s[0], s[1], s[2]);
    case Kind::plane: return std::make_unique<coal::Halfspace>(0, 0, 1, 0);
    case Kind::hull32:
    case Kind::hull200:
    case Kind::hull: return hull_of(solid);
    case Kind::mesh:
    case Kind::solid_mesh: return mesh_of(solid);
    default: return nullptr;
  }
}

class Coal final : public Contender {
 public:
  Coal(Query query, const Cell& cell) : query_(query), is_mesh_(is_mesh(cell.solids_a.front().kind)) {
    for (const Solid& solid : cell.solids_a) {
      a_.push_back(ready(solid));
    }
    for (const Solid& solid : cell.solids_b) {
      b_.push_back(ready(solid));
    }
    for (const Case& one : cell.cases) {
      jobs_.push_back({one.a, one.b, coal_transform(one.pose_a), coal_transform(one.pose_b)});
    }
    // The first triangles that it finds, not the deepest ones.
    contacts_ = coal::CollisionRequest(query == Query::overlap ? coal::NO_REQUEST : coal::CONTACT, is_mesh_ ? 64 : 4);
  }

  void answer(std::span<Answer> answers) override {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      // It throws where a search of it gets stuck.
      try {
        answers[i] = query_ == Query::contacts  ? contacts(jobs_[i])
                     : query_ == Query::overlap ? overlap(jobs_[i])
                                                : distance(jobs_[i]);
      } catch (const std::exception&) {
        answers[i] = {};
      }
    }
  }

 private:
  struct Job {
    std::size_t a, b;
    coal::Transform3s pose_a, pose_b;
  };

  static std::unique_ptr<Geometry> ready(const Solid& solid) {
    auto geometry = geometry_of(solid);
    geometry->computeLocalAABB();
    return geometry;
  }

  // Signed: deep pairs answer their depth to the same question.
  [[nodiscard]] Answer distance(const Job& job) {
    coal::DistanceResult result;
    coal::distance(a_[job.a].get(), job.pose_a, b_[job.b].get(), job.pose_b, distances_, result);
    return {result.min_distance, 1};
  }
  [[nodiscard]] Answer overlap(const Job& job) {
    coal::CollisionResult result;
    coal::collide(a_[job.a].get(), job.pose_a, b_[job.b].get(), job.pose_b, contacts_, result);
    return {result.isCollision() ? -1.0 : 1.0, 1};
  }
  // Of convex shapes the points of its contact patch.
  [[nodiscard]] Answer contacts(const Job& job) {
    coal::CollisionResult result;
    coal::collide(a_[job.a].get(), job.pose_a, b_[job.b].get(), job.pose_b, contacts_, result);
    Answer found;
    for (std::size_t i = 0; i < result.numContacts(); ++i) {
      found.distance = std::min(found.distance, result.getContact(i).penetration_depth);
      ++found.points;
    }
    if (!is_mesh_ && found.points > 0) {
      coal::ContactPatchResult patches(patch_);
      coal::computeContactPatch(a_[job.a].get(), job.pose_a, b_[job.b].get(), job.pose_b, result, patch_, patches);
      std::size_t points = 0;
      for (std::size_t i = 0; i < patches.numContactPatches(); ++i) {
        points += patches.getContactPatch(i).size();
      }
      found.points = std::max(found.points, static_cast<std::uint32_t>(points));
    }
    return found;
  }

  Query query_;
  bool is_mesh_;
  std::vector<std::unique_ptr<Geometry>> a_, b_;
  std::vector<Job> jobs_;
  coal::DistanceRequest distances_{true, true};
  coal::CollisionRequest contacts_;
  coal::ContactPatchRequest patch_;
};

bool is_known(Kind kind) {
  return is_bounded_and_convex(kind) ? kind != Kind::triangle && kind != Kind::point
                                     : kind == Kind::plane || is_mesh(kind);
}

}  // namespace

// It has no rays, casts or times of impact, and no inside of a mesh.
std::unique_ptr<Contender> make_coal(Query query, const Cell& cell) {
  const Kind a = cell.solids_a.front().kind, b = cell.solids_b.front().kind;
  const bool is_asked =
      query == Query::distance || query == Query::depth || query == Query::contacts || query == Query::overlap;
  const bool is_of_inside = a == Kind::solid_mesh && query != Query::distance;
  const bool is_depth_of_surface = a == Kind::mesh && query == Query::depth;
  if (!is_asked || !is_known(a) || !is_known(b) || is_of_inside || is_depth_of_surface) {
    return nullptr;
  }
  return std::make_unique<Coal>(query, cell);
}

}  // namespace bench
