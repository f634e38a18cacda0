// SPDX-License-Identifier: Apache-2.0
// FCL in double precision: a dynamic box tree, and contacts of each pair that it finds.
#include <fcl/fcl.h>

#include <cstddef>
#include <exception>
#include <memory>
#include <vector>

#include "fcl_shapes.hpp"
#include "universe.hpp"

namespace bench {
namespace {

using Object = fcl::CollisionObject<double>;
using Manager = fcl::DynamicAABBTreeCollisionManager<double>;

// What the callback of the manager works on.
struct Asked {
  fcl::CollisionRequest<double> request;
  Counts counts;
};

bool examine(Object* a, Object* b, void* context) {
  Asked& asked = *static_cast<Asked*>(context);
  ++asked.counts.pairs;
  // It throws where its search gets stuck.
  try {
    fcl::CollisionResult<double> result;
    fcl::collide(a, b, asked.request, result);
    asked.counts.touching += result.numContacts() > 0 ? 1 : 0;
    asked.counts.points += result.numContacts();
    asked.counts.overlapping += result.numContacts();
  } catch (const std::exception&) {
    return false;
  }
  return false;
}

class FclWorld final : public Detector {
 public:
  explicit FclWorld(const World& world) {
    std::vector<std::shared_ptr<FclGeometry>> shapes;
    for (const Solid& solid : world.solids) {
      shapes.emplace_back(fcl_geometry(solid));
    }
    for (const auto& frame : world.frames) {
      std::vector<FclTransform>& transforms = frames_.emplace_back();
      for (const Placement& placement : frame) {
        transforms.push_back(fcl_transform(placement));
      }
    }
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
      objects_.push_back(std::make_unique<Object>(shapes[world.bodies[i]], frames_.front()[i]));
    }
    ground_ = std::make_unique<Object>(std::shared_ptr<FclGeometry>(fcl_geometry(world.ground)),
                                       fcl_transform(world.ground_at));
    for (const auto& object : objects_) {
      manager_.registerObject(object.get());
    }
    manager_.setup();
    asked_.request.enable_contact = true;
    asked_.request.num_max_contacts = 4;
  }

  void place(std::size_t frame) override {
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      objects_[i]->setTransform(frames_[frame][i]);
      objects_[i]->computeAABB();
    }
  }
  void detect() override {
    asked_.counts = {};
    manager_.update();
    manager_.collide(&asked_, examine);
    manager_.collide(ground_.get(), &asked_, examine);
  }
  [[nodiscard]] Counts counts() const override { return asked_.counts; }

 private:
  std::vector<std::unique_ptr<Object>> objects_;
  std::unique_ptr<Object> ground_;
  std::vector<std::vector<FclTransform>> frames_;
  Manager manager_;
  Asked asked_;
};

}  // namespace

std::unique_ptr<Detector> make_fcl_world(const World& world) { return std::make_unique<FclWorld>(world); }

}  // namespace bench
