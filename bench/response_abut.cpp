// SPDX-License-Identifier: Apache-2.0
#include <abut/response.hpp>

#include <memory>
#include <vector>

#include "response.hpp"

namespace bench {
namespace {

abut::Vec3 vector_of(const Vector3& v) { return {v[0], v[1], v[2]}; }
Vector3 array_of(const abut::Vec3& v) { return {v.x, v.y, v.z}; }

class AbutMover final : public Mover {
 public:
  AbutMover(const MovingWorld& world, const Effort& effort)
      : universe_(abut::UniverseOptions().with_tolerance_mode(ABUT_TOLERANCE_MARGIN)),
        response_(universe_, options_of(world, effort)) {
    const bool bounces = world.restitution > 0;
    abut::GeometryOptions touching = abut::GeometryOptions().with_tolerance(bounces ? 1e-9 : world.reach);
    if (bounces) touching = touching.with_flags(ABUT_GEOMETRY_FAST);
    const abut::PartId ground = universe_.create_part(abut::PartOptions().with_motion(ABUT_MOTION_STATIC));
    universe_.create_geometry(ground, abut::Shape::plane({0, 0, 1}, 0), touching.with_material(1));
    for (const MovingBody& body : world.bodies) {
      const abut::Shape shape =
          body.is_box ? abut::Shape::box(body.side, body.side, body.half) : abut::Shape::sphere(body.half);
      const abut::PartId part =
          universe_.create_part(abut::PartOptions().with_pose(abut::pose(vector_of(body.position))));
      universe_.create_geometry(part, shape, touching.with_material(body.is_box ? 2 : 3));
      const abut::BodyOptions heavy =
          abut::BodyOptions().with_density(body.mass / abut::mass_properties(shape, 1).mass);
      response_.add_body(part, effort.by_midpoint ? heavy.with_integrator(ABUT_INTEGRATOR_MIDPOINT) : heavy);
      universe_.set_velocity(part, abut::Velocity{vector_of(body.velocity), {0, 0, 0}});
      parts_.push_back(part);
    }
    const auto rub = [&](std::uint32_t a, std::uint32_t b, double friction) {
      universe_.set_material_pair(a, b,
                                  abut::ContactMaterial()
                                      .with_friction(friction, friction)
                                      .with_restitution(world.restitution)
                                      .with_compliance(world.stiffness > 0 ? 1 / world.stiffness : 0));
    };
    rub(1, 2, world.ground_friction);
    rub(1, 3, world.friction);
    rub(2, 3, world.friction);
    rub(2, 2, world.friction);
    rub(3, 3, world.friction);
  }

  void push(std::size_t body, const Vector3& force) override { response_.apply_force(parts_[body], vector_of(force)); }
  void step(double dt) override { response_.step(dt); }
  [[nodiscard]] Vector3 position(std::size_t body) const override {
    return array_of(abut::Pose(universe_.pose(parts_[body])).position);
  }
  [[nodiscard]] Vector3 velocity(std::size_t body) const override {
    return array_of(universe_.velocity(parts_[body]).velocity.linear);
  }

 private:
  static abut::ResponseOptions options_of(const MovingWorld& world, const Effort& effort) {
    abut::ResponseOptions out = abut::ResponseOptions()
                                    .with_gravity({0, 0, -world.gravity})
                                    .with_slop(1e-7)
                                    .with_most_rounds(static_cast<std::uint32_t>(effort.iterations));
    out = effort.tolerance > 0 ? out.with_tolerance(effort.tolerance) : out.with_solver(ABUT_SOLVER_SWEEPS);
    return world.restitution > 0 ? out.with_flags(ABUT_RESPONSE_IMPACTS) : out;
  }

  abut::Universe universe_;
  abut::Response response_;
  std::vector<abut::PartId> parts_;
};

}  // namespace

std::unique_ptr<Mover> make_abut_mover(const MovingWorld& world, const Effort& effort) {
  return std::make_unique<AbutMover>(world, effort);
}

}  // namespace bench
