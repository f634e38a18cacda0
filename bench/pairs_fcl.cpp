// FCL in double precision with its default solver, libccd.
#include <fcl/fcl.h>

#include <memory>
#include <vector>

#include "pairs.hpp"

namespace bench {
namespace {

using Transform = fcl::Transform3<double>;
using Geometry = std::unique_ptr<fcl::CollisionGeometry<double>>;

Transform transform_of(const Placement& placement) {
  const auto& [w, x, y, z] = placement.orientation;
  Transform out = Transform::Identity();
  out.linear() = Eigen::Quaterniond(w, x, y, z).toRotationMatrix();
  out.translation() = Eigen::Vector3d(placement.position[0], placement.position[1], placement.position[2]);
  return out;
}

Geometry geometry_of(const Solid& solid) {
  const Point& s = solid.sizes;
  switch (solid.kind) {
    case Kind::sphere:
      return std::make_unique<fcl::Sphere<double>>(s[0]);
    case Kind::box:
      return std::make_unique<fcl::Box<double>>(2 * s[0], 2 * s[1], 2 * s[2]);
    case Kind::capsule:
      return std::make_unique<fcl::Capsule<double>>(s[0], 2 * s[1]);
    case Kind::cylinder:
      return std::make_unique<fcl::Cylinder<double>>(s[0], 2 * s[1]);
    case Kind::cone:
      return std::make_unique<fcl::Cone<double>>(s[0], 2 * s[1]);
    case Kind::ellipsoid:
      return std::make_unique<fcl::Ellipsoid<double>>(s[0], s[1], s[2]);
    case Kind::plane:
      return std::make_unique<fcl::Halfspace<double>>(0, 0, 1, 0);
    case Kind::hull32:
    case Kind::hull200:
    case Kind::hull:
    case Kind::triangle: {
      auto vertices = std::make_shared<std::vector<Eigen::Vector3d>>();
      for (const Point& p : solid.points) {
        vertices->emplace_back(p[0], p[1], p[2]);
      }
      auto faces = std::make_shared<std::vector<int>>();
      for (const auto& triangle : solid.triangles) {
        faces->insert(faces->end(), {3, triangle[0], triangle[1], triangle[2]});
      }
      // Its triangle has no distances; a hull of two faces, back to back, has.
      if (solid.kind == Kind::triangle) {
        *faces = {3, 0, 1, 2, 3, 0, 2, 1};
      }
      return std::make_unique<fcl::Convex<double>>(vertices, static_cast<int>(faces->size() / 4), faces);
    }
  }
  return nullptr;
}

class Fcl final : public Contender {
 public:
  Fcl(Query query, const Cell& cell) : query_(query) {
    for (const Solid& solid : cell.solids_a) {
      a_.push_back(geometry_of(solid));
    }
    for (const Solid& solid : cell.solids_b) {
      b_.push_back(geometry_of(solid));
    }
    for (const Case& one : cell.cases) {
      jobs_.push_back({one.a, one.b, transform_of(one.pose_a), transform_of(one.pose_b)});
    }
    distance_.enable_nearest_points = true;
    distance_.enable_signed_distance = query == Query::depth;
    contacts_.enable_contact = true;
    contacts_.num_max_contacts = 4;
  }

  void answer(std::span<Answer> answers) override {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      // It throws where its distance search gets stuck.
      try {
        answers[i] = query_ == Query::contacts ? contacts(jobs_[i]) : distance(jobs_[i]);
      } catch (const std::exception&) {
        answers[i] = {};
      }
    }
  }

 private:
  struct Job {
    std::size_t a, b;
    Transform pose_a, pose_b;
  };

  [[nodiscard]] Answer distance(const Job& job) const {
    fcl::DistanceResult<double> result;
    fcl::distance(a_[job.a].get(), job.pose_a, b_[job.b].get(), job.pose_b, distance_, result);
    return {result.min_distance, 1};
  }
  [[nodiscard]] Answer contacts(const Job& job) const {
    fcl::CollisionResult<double> result;
    fcl::collide(a_[job.a].get(), job.pose_a, b_[job.b].get(), job.pose_b, contacts_, result);
    Answer found;
    for (std::size_t p = 0; p < result.numContacts(); ++p) {
      found.distance = std::fmin(found.distance, -result.getContact(p).penetration_depth);
      ++found.points;
    }
    return found;
  }

  Query query_;
  std::vector<Geometry> a_, b_;
  std::vector<Job> jobs_;
  fcl::DistanceRequest<double> distance_;
  fcl::CollisionRequest<double> contacts_;
};

}  // namespace

std::unique_ptr<Contender> make_fcl(Query query, const Cell& cell) {
  return std::make_unique<Fcl>(query, cell);
}

}  // namespace bench
