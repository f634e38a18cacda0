// SPDX-License-Identifier: Apache-2.0
// FCL in double precision with its default solver, libccd.
#include <fcl/fcl.h>

#include <memory>
#include <vector>

#include "fcl_shapes.hpp"
#include "pairs.hpp"

namespace bench {
namespace {

class Fcl final : public Contender {
 public:
  Fcl(Query query, const Cell& cell) : query_(query) {
    for (const Solid& solid : cell.solids_a) {
      a_.push_back(fcl_geometry(solid));
    }
    for (const Solid& solid : cell.solids_b) {
      b_.push_back(fcl_geometry(solid));
    }
    for (const Case& one : cell.cases) {
      Placement end = one.pose_b;
      for (std::size_t i = 0; i < 3; ++i) {
        end.position.at(i) += one.motion.at(i);
      }
      end.orientation = product(turn_by(one.turn), end.orientation);
      jobs_.push_back({one.a, one.b, fcl_transform(one.pose_a), fcl_transform(one.pose_b), fcl_transform(end)});
    }
    distance_.enable_nearest_points = true;
    distance_.enable_signed_distance = query == Query::depth;
    contacts_.enable_contact = query == Query::contacts;
    // The first triangles that it meets, not the deepest ones.
    contacts_.num_max_contacts = cell.solids_a.front().kind == Kind::mesh ? 64 : 4;
  }

  void answer(std::span<Answer> answers) override {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      // It throws where its distance search gets stuck.
      try {
        answers[i] = query_ == Query::contacts  ? contacts(jobs_[i])
                     : query_ == Query::overlap ? overlap(jobs_[i])
                     : query_ == Query::impact  ? impact(jobs_[i])
                                                : distance(jobs_[i]);
      } catch (const std::exception&) {
        answers[i] = {};
      }
    }
  }

 private:
  struct Job {
    std::size_t a, b;
    FclTransform pose_a, pose_b, end_b;
  };

  [[nodiscard]] Answer distance(const Job& job) const {
    fcl::DistanceResult<double> result;
    fcl::distance(a_[job.a].get(), job.pose_a, b_[job.b].get(), job.pose_b, distance_, result);
    return {result.min_distance, 1};
  }
  [[nodiscard]] Answer overlap(const Job& job) const {
    fcl::CollisionResult<double> result;
    fcl::collide(a_[job.a].get(), job.pose_a, b_[job.b].get(), job.pose_b, contacts_, result);
    return {result.isCollision() ? -1.0 : 1.0, 1};
  }
  [[nodiscard]] Answer impact(const Job& job) const {
    fcl::ContinuousCollisionRequest<double> request(100, 1e-6, fcl::CCDM_LINEAR, fcl::GST_LIBCCD,
                                                    fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
    fcl::ContinuousCollisionResult<double> result;
    fcl::continuousCollide(a_[job.a].get(), job.pose_a, job.pose_a, b_[job.b].get(), job.pose_b, job.end_b, request,
                           result);
    return {result.is_collide ? result.time_of_contact : 1, 1};
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
  std::vector<std::unique_ptr<FclGeometry>> a_, b_;
  std::vector<Job> jobs_;
  fcl::DistanceRequest<double> distance_;
  fcl::CollisionRequest<double> contacts_;
};

}  // namespace

// It has neither rays nor these kinds, no inside of a mesh, and its casts are not asked.
std::unique_ptr<Contender> make_fcl(Query query, const Cell& cell) {
  const Kind kind = cell.solids_a.front().kind;
  const bool is_absent = kind == Kind::height_field || kind == Kind::distance_field || kind == Kind::particles ||
                         kind == Kind::composite || query == Query::ray || query == Query::cast;
  const bool is_of_inside = kind == Kind::solid_mesh && query != Query::distance;
  const bool is_depth_of_surface = kind == Kind::mesh && query == Query::depth;
  const bool is_of_half_space = kind == Kind::plane && query != Query::contacts && query != Query::overlap;
  const bool is_impact_of_mesh = !is_bounded_and_convex(kind) && query == Query::impact;
  return is_absent || is_of_inside || is_depth_of_surface || is_impact_of_mesh || is_of_half_space
             ? nullptr
             : std::make_unique<Fcl>(query, cell);
}

}  // namespace bench
