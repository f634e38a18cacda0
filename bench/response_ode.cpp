// SPDX-License-Identifier: Apache-2.0
// ODE in double precision: dWorldQuickStep sweeps, dWorldStep factors.
#include <ode/ode.h>

#include <array>
#include <cstdarg>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "response.hpp"

namespace bench {
namespace {

class OdeMover final : public Mover {
 public:
  OdeMover(const MovingWorld& world, const Effort& effort) : like_(world), iterations_(effort.iterations) {
    dInitODE2(0);
    // It goes on with what it has; the error tells.
    dSetMessageHandler(&OdeMover::be_silent);
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    joints_ = dJointGroupCreate(0);
    dWorldSetGravity(world_, 0, 0, -world.gravity);
    if (iterations_ > 0) dWorldSetQuickStepNumIterations(world_, iterations_);
    dWorldSetContactSurfaceLayer(world_, 0);
    ground_ = dCreatePlane(space_, 0, 0, 1, 0);
    for (const MovingBody& body : world.bodies) {
      const dBodyID its = dBodyCreate(world_);
      dMass mass;
      dGeomID geom = nullptr;
      if (body.is_box) {
        dMassSetBoxTotal(&mass, body.mass, 2 * body.side, 2 * body.side, 2 * body.half);
        geom = dCreateBox(space_, 2 * body.side, 2 * body.side, 2 * body.half);
      } else {
        dMassSetSphereTotal(&mass, body.mass, body.half);
        geom = dCreateSphere(space_, body.half);
      }
      dBodySetMass(its, &mass);
      dGeomSetBody(geom, its);
      dBodySetPosition(its, body.position[0], body.position[1], body.position[2]);
      dBodySetLinearVel(its, body.velocity[0], body.velocity[1], body.velocity[2]);
      bodies_.push_back(its);
      dGeomSetData(geom, &is_box_flag(body.is_box));
    }
  }
  ~OdeMover() override {
    dJointGroupDestroy(joints_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }

  void push(std::size_t body, const Vector3& force) override {
    dBodyAddForce(bodies_[body], force[0], force[1], force[2]);
  }
  void step(double dt) override {
    dt_ = dt;
    dSpaceCollide(space_, this, &OdeMover::examine);
    if (iterations_ > 0) {
      dWorldQuickStep(world_, dt);
    } else {
      dWorldStep(world_, dt);
    }
    dJointGroupEmpty(joints_);
  }
  [[nodiscard]] Vector3 position(std::size_t body) const override { return array_of(dBodyGetPosition(bodies_[body])); }
  [[nodiscard]] Vector3 velocity(std::size_t body) const override { return array_of(dBodyGetLinearVel(bodies_[body])); }

 private:
  static void be_silent(int, const char*, va_list) {}
  static Vector3 array_of(const dReal* v) { return {v[0], v[1], v[2]}; }
  static bool& is_box_flag(bool is_box) {
    static std::array<bool, 2> flags{false, true};
    return flags.at(is_box ? 1 : 0);
  }

  static void examine(void* context, dGeomID a, dGeomID b) {
    OdeMover& its = *static_cast<OdeMover*>(context);
    constexpr int most_contacts = 8;
    std::array<dContact, most_contacts> contacts{};
    const int count = dCollide(a, b, most_contacts, &contacts.front().geom, sizeof(dContact));
    const auto is_box = [](dGeomID geom) {
      const void* const flag = dGeomGetData(geom);
      return flag != nullptr && *static_cast<const bool*>(flag);
    };
    const bool on_ground = a == its.ground_ || b == its.ground_;
    const bool is_slab = on_ground && (is_box(a) || is_box(b)) && its.like_.ground_friction > 0;
    for (dContact& contact : std::span(contacts).first(static_cast<std::size_t>(count))) {
      contact.surface.mode = dContactApprox1;
      contact.surface.mu = is_slab ? its.like_.ground_friction : its.like_.friction;
      if (its.like_.restitution > 0) {
        contact.surface.mode |= dContactBounce;
        contact.surface.bounce = its.like_.restitution;
        contact.surface.bounce_vel = 1e-3;
      }
      if (its.like_.stiffness > 0) {
        // Implicit Euler of a spring without damping.
        contact.surface.mode |= dContactSoftERP | dContactSoftCFM;
        contact.surface.soft_erp = 1;
        contact.surface.soft_cfm = 1 / (its.dt_ * its.like_.stiffness);
      }
      dJointAttach(dJointCreateContact(its.world_, its.joints_, &contact), dGeomGetBody(a), dGeomGetBody(b));
    }
  }

  MovingWorld like_;
  int iterations_;
  double dt_ = 0;
  dWorldID world_ = nullptr;
  dSpaceID space_ = nullptr;
  dJointGroupID joints_ = nullptr;
  dGeomID ground_ = nullptr;
  std::vector<dBodyID> bodies_;
};

}  // namespace

std::unique_ptr<Mover> make_ode_mover(const MovingWorld& world, const Effort& effort) {
  return std::make_unique<OdeMover>(world, effort);
}
bool has_ode() { return true; }

}  // namespace bench
