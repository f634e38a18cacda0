// SPDX-License-Identifier: Apache-2.0
#include <fcl/fcl.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "fcl_shapes.hpp"
#include "overlaps.hpp"

namespace bench {
namespace {

class FclOverlaps final : public OverlapFinder {
 public:
  explicit FclOverlaps(const Overlaps& overlaps) : group_(overlaps.group) {
    for (const Solid& solid : overlaps.solids) {
      shapes_.push_back(fcl_geometry(solid));
    }
    for (const Overlap& pair : overlaps.all) {
      jobs_.push_back({pair.a, pair.b, fcl_transform(pair.pose_a), fcl_transform(pair.pose_b)});
    }
  }

  void answer(std::vector<char>& out) override {
    out.assign(jobs_.size() / group_, 0);
    const fcl::CollisionRequest<double> any_contact(1, false);
    for (std::size_t group = 0; group < out.size(); ++group) {
      for (std::size_t i = group * group_; i < (group + 1) * group_ && out[group] == 0; ++i) {
        const Job& job = jobs_[i];
        fcl::CollisionResult<double> result;
        fcl::collide(shapes_[job.a].get(), job.pose_a, shapes_[job.b].get(), job.pose_b, any_contact, result);
        out[group] = result.isCollision() ? 1 : 0;
      }
    }
  }

 private:
  struct Job {
    std::size_t a, b;
    FclTransform pose_a, pose_b;
  };

  std::size_t group_;
  std::vector<std::unique_ptr<FclGeometry>> shapes_;
  std::vector<Job> jobs_;
};

}  // namespace

std::unique_ptr<OverlapFinder> make_fcl_overlaps(const Overlaps& overlaps) {
  return std::make_unique<FclOverlaps>(overlaps);
}

}  // namespace bench
