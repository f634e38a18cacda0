// SPDX-License-Identifier: Apache-2.0
// Modules: a kind that is known while compiling, kinds by name, a rule, and questions to a universe.
#include <array>
#include <cstdio>
#include <limits>
#include <span>
#include <string>

import abut;

namespace {

// A kind that is known while compiling has questions of its own.
bool describe_a_box() {
  const std::array<double, 3> half_extents{1.0, 2.0, 3.0};
  const abut::Result<abut::Box> box = abut::Box::make(half_extents, {}, {});
  if (!box) return false;
  const abut::Aabb bounds = box.value().aabb(abut::Pose::identity());
  std::printf("a box up to z = %g\n", bounds.high.z);
  return true;
}

// A kind by its name, as a file would give it.
abut::Result<abut::ShapeHandle> make(const char* name, std::span<const double> parameters) {
  const auto place = abut::find_kind(name);
  if (!place) return abut::Error{abut::Errc::unknown_value, std::string("no kind is called ") + name};
  return abut::make_shape(*place, parameters, {}, {});
}

bool ask_a_universe(const abut::ShapeHandle& cone) {
  abut::Universe universe({.broadphase = abut::BroadphaseKind::tree}, 1);
  std::array<abut::PartOptions, 2> options;
  options[0].motion = abut::MotionKind::fixed;
  options[1].placement.position = {0.0, 0.0, 1.5};
  const std::array<abut::ShapeHandle, 2> shapes{cone, cone};
  const auto parts = universe.create_parts(options);
  if (!parts) return false;
  const auto geometries = universe.create_geometries(parts.value(), shapes, {});
  if (!geometries || !universe.step(0.01)) return false;
  for (const abut::Contact& contact : universe.contacts()) std::printf("contact %g deep\n", -contact.point.distance);

  // A rule keeps them apart; the next step ends their contact with an event.
  const abut::Collidable anything;
  if (!universe.set_rule(anything, anything, abut::Rule::disable) || !universe.step(0.01)) return false;
  std::printf("%zu contacts, %zu event\n", universe.contacts().size(), universe.events().size());

  const auto down = abut::UnitVec3::make({0.0, 0.0, -1.0});
  if (!down) return false;
  const abut::Ray ray{{0.0, 0.0, 9.0}, *down, std::numeric_limits<double>::infinity()};
  abut::QueryFilter filter;
  filter.ignored_geometry = geometries.value()[1];
  const auto hit = abut::cast_ray(universe, ray, filter, abut::RayStart::far_side);
  if (hit) std::printf("a ray meets the lower cone after %g\n", hit->distance);
  return true;
}

}  // namespace

int main() {
  const std::array<double, 2> parameters{0.5, 1.0};
  const auto cone = make("cone", parameters);
  if (!cone) {
    std::puts(cone.error().message.c_str());
    return 1;
  }
  const auto place = abut::find_kind("cone"), box = abut::find_kind("box");
  std::printf("cones meet boxes by: %s\n", std::string(abut::describe_route(*place, *box).reason).c_str());
  return describe_a_box() && ask_a_universe(cone.value()) ? 0 : 1;
}
