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
      jobs_.push_back({one.a, one.b, fcl_transform(one.pose_a), fcl_transform(one.pose_b)});
    }
    distance_.enable_nearest_points = true;
    distance_.enable_signed_distance = query == Query::depth;
    contacts_.enable_contact = true;
    // The first triangles that it meets, not the deepest ones.
    contacts_.num_max_contacts = cell.solids_a.front().kind == Kind::mesh ? 64 : 4;
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
    FclTransform pose_a, pose_b;
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
  std::vector<std::unique_ptr<FclGeometry>> a_, b_;
  std::vector<Job> jobs_;
  fcl::DistanceRequest<double> distance_;
  fcl::CollisionRequest<double> contacts_;
};

}  // namespace

// It has no height fields, and its casts are not asked.
std::unique_ptr<Contender> make_fcl(Query query, const Cell& cell) {
  return cell.solids_a.front().kind == Kind::height_field || query == Query::cast ? nullptr
                                                                                  : std::make_unique<Fcl>(query, cell);
}

}  // namespace bench
