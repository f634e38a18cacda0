// SPDX-License-Identifier: Apache-2.0
// Bullet in double precision: its sequential impulses.
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <memory>
#include <vector>

#include "response.hpp"

namespace bench {
namespace {

class BulletMover final : public Mover {
 public:
  BulletMover(const MovingWorld& world, const Effort& effort) {
    world_.setGravity(btVector3(0, 0, -world.gravity));
    world_.getSolverInfo().m_numIterations = effort.iterations;
    world_.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    // Beyond some depth it would push springs apart without velocity.
    if (world.stiffness > 0) world_.getSolverInfo().m_splitImpulse = 0;
    add(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), 0), 0, {}, {}, 1, std::sqrt(world.restitution));
    // Bullet multiplies frictions and restitutions of the two: here the friction of the ground is 1.
    const double box = world.ground_friction > 0 ? world.ground_friction : 1;
    for (const MovingBody& body : world.bodies) {
      std::unique_ptr<btCollisionShape> shape;
      if (body.is_box) {
        shape = std::make_unique<btBoxShape>(btVector3(body.side, body.side, body.half));
      } else {
        shape = std::make_unique<btSphereShape>(body.half);
      }
      const bool among_boxes = world.ground_friction > 0;
      const double ball = among_boxes ? world.friction / box : std::sqrt(world.friction);
      const double same = std::sqrt(world.friction);
      const double friction = body.is_box ? (among_boxes ? box : same) : ball;
      add(std::move(shape), body.mass, body.position, body.velocity, friction, std::sqrt(world.restitution));
    }
    if (!(world.ground_friction > 0)) bodies_.front()->setFriction(std::sqrt(world.friction));
    // Springs in series, half of the give in each.
    for (const auto& body : bodies_)
      if (world.stiffness > 0) body->setContactStiffnessAndDamping(2 * world.stiffness, 0);
  }
  ~BulletMover() override {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  void push(std::size_t body, const Vector3& force) override {
    bodies_[body + 1]->applyCentralForce(btVector3(force[0], force[1], force[2]));
  }
  void step(double dt) override {
    world_.stepSimulation(dt, 0);
    world_.clearForces();
  }
  [[nodiscard]] Vector3 position(std::size_t body) const override {
    return array_of(bodies_[body + 1]->getWorldTransform().getOrigin());
  }
  [[nodiscard]] Vector3 velocity(std::size_t body) const override {
    return array_of(bodies_[body + 1]->getLinearVelocity());
  }

 private:
  static Vector3 array_of(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

  void add(std::unique_ptr<btCollisionShape> shape, double mass, const Vector3& position, const Vector3& velocity,
           double friction, double restitution) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape->calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape.get(), inertia);
    info.m_startWorldTransform.setIdentity();
    info.m_startWorldTransform.setOrigin(btVector3(position[0], position[1], position[2]));
    btRigidBody& body = *bodies_.emplace_back(std::make_unique<btRigidBody>(info));
    body.setLinearVelocity(btVector3(velocity[0], velocity[1], velocity[2]));
    body.setFriction(friction);
    body.setRestitution(restitution);
    body.setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(&body);
    shapes_.push_back(std::move(shape));
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace

std::unique_ptr<Mover> make_bullet_mover(const MovingWorld& world, const Effort& effort) {
  return std::make_unique<BulletMover>(world, effort);
}

}  // namespace bench
