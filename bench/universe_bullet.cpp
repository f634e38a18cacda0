// SPDX-License-Identifier: Apache-2.0
#include <btBulletCollisionCommon.h>

#include <memory>
#include <vector>

#include "bullet_shapes.hpp"
#include "universe.hpp"

namespace bench {
namespace {

btDefaultCollisionConstructionInfo large_pools() {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = 1 << 17;
  info.m_defaultMaxCollisionAlgorithmPoolSize = 1 << 17;
  return info;
}

class BulletWorld final : public Detector {
 public:
  BulletWorld(const World& world, double margin) {
    for (const Solid& solid : world.solids) {
      shapes_.push_back(bullet_shape(solid, margin));
    }
    shapes_.push_back(bullet_shape(world.ground, margin));
    for (const auto& frame : world.frames) {
      std::vector<btTransform>& transforms = frames_.emplace_back();
      for (const Placement& placement : frame) {
        transforms.push_back(bullet_transform(placement));
      }
    }
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
      btCollisionObject& body = *objects_.emplace_back(std::make_unique<btCollisionObject>());
      body.setCollisionShape(shapes_[world.bodies[i]].get());
      body.setWorldTransform(frames_.front()[i]);
      world_.addCollisionObject(&body);
    }
    btCollisionObject& ground = *objects_.emplace_back(std::make_unique<btCollisionObject>());
    ground.setCollisionShape(shapes_.back().get());
    ground.setWorldTransform(bullet_transform(world.ground_at));
    ground.setCollisionFlags(ground.getCollisionFlags() | btCollisionObject::CF_STATIC_OBJECT);
    world_.addCollisionObject(&ground, btBroadphaseProxy::StaticFilter,
                              btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter);
  }
  ~BulletWorld() override {
    for (const auto& object : objects_) {
      world_.removeCollisionObject(object.get());
    }
  }

  void place(std::size_t frame) override {
    const std::vector<btTransform>& transforms = frames_[frame];
    for (std::size_t i = 0; i < transforms.size(); ++i) {
      objects_[i]->setWorldTransform(transforms[i]);
    }
  }
  void detect() override { world_.performDiscreteCollisionDetection(); }

  [[nodiscard]] Counts counts() const override {
    Counts counts;
    counts.pairs = static_cast<std::size_t>(broadphase_.getOverlappingPairCache()->getNumOverlappingPairs());
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
      counts.touching += manifold.getNumContacts() > 0 ? 1 : 0;
      counts.points += static_cast<std::size_t>(manifold.getNumContacts());
      for (int p = 0; p < manifold.getNumContacts(); ++p) {
        counts.overlapping += manifold.getContactPoint(p).getDistance() < 0 ? 1 : 0;
      }
    }
    return counts;
  }

 private:
  btDefaultCollisionConfiguration configuration_{large_pools()};
  mutable btCollisionDispatcher dispatcher_{&configuration_};
  mutable btDbvtBroadphase broadphase_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
  std::vector<std::vector<btTransform>> frames_;
};

}  // namespace

std::unique_ptr<Detector> make_bullet_world(const World& world, double margin) {
  return std::make_unique<BulletWorld>(world, margin);
}

}  // namespace bench
