// SPDX-License-Identifier: Apache-2.0
// A room that lives: balls fall on terrain, a sensor counts who passes, a ray looks for the ground. Without modules.
#include <abut/abut.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <vector>

namespace {

// What geometries are; queries and masks speak of it.
constexpr std::uint64_t ground = 1, bodies = 2, gates = 4;

abut::Shape hills() {
  std::vector<double> heights;
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 20; ++column) heights.push_back(0.3 * std::sin(column) * std::cos(row));
  }
  return abut::Shape::height_field(20, 20, 1.0, 1.0, heights);
}

struct Room {
  Room() {
    const abut::PartId world = universe.create_part(abut::PartOptions().with_motion(ABUT_MOTION_STATIC));
    universe.create_geometry(world, hills(), abut::GeometryOptions().with_layers(ground));
    gate = universe.create_geometry(world, abut::Shape::box(10, 10, 0.1),
                                    abut::GeometryOptions()
                                        .with_flags(ABUT_GEOMETRY_SENSOR)
                                        .with_layers(gates)
                                        .with_pose(abut::pose({9.5, 9.5, 3})));
    const std::vector<abut::PartOptions> options(balls.size());
    parts = universe.create_parts(options);
    const std::vector<abut::Shape> shapes(balls.size(), abut::Shape::sphere(0.4));
    const std::vector<abut::GeometryOptions> is_body(balls.size(), abut::GeometryOptions().with_layers(bodies));
    universe.create_geometries(parts, shapes, is_body);
    for (std::size_t i = 0; i < balls.size(); ++i) balls[i] = abut::pose({2.0 + 3.0 * static_cast<double>(i), 9.5, 4});
  }

  // Balls fall until they touch the ground.
  void fall(double dt) {
    for (abut::Pose& ball : balls) ball.position.z -= 2 * dt;
    universe.set_poses(parts, balls);
    universe.step(dt);
    for (const abut::Contact& contact : universe.contacts()) {
      if (contact.flags & ABUT_CONTACT_SENSOR) continue;
      for (std::size_t i = 0; i < parts.size(); ++i) {
        if (universe.describe(contact.geometry_b).part == parts[i]) balls[i].position.z -= contact.distance;
      }
    }
    for (const abut::Event& event : universe.events()) {
      if (event.kind == ABUT_EVENT_BEGIN && event.geometry_a == gate) ++passed;
    }
  }

  abut::Universe universe;
  abut::GeometryId gate{};
  std::vector<abut::Pose> balls = std::vector<abut::Pose>(5);
  std::vector<abut::PartId> parts;
  int passed = 0;
};

}  // namespace

int main() try {
  Room room;
  for (int i = 0; i < 240; ++i) room.fall(0.01);
  const abut::Ray down{{5, 9.5, 10}, {0, 0, -1}, std::numeric_limits<double>::infinity()};
  const auto hit = room.universe.cast_ray(down, abut::QueryFilter().with_mask(ground));
  std::printf("passed the gate: %d\n", room.passed);
  std::printf("ground under the middle: %s\n", hit ? "yes" : "no");
  std::printf("bodies in the column: %zu\n", room.universe
                                                 .overlaps(abut::Shape::box(0.5, 0.5, 10), abut::pose({5, 9.5, 0}), 0,
                                                           abut::QueryFilter().with_mask(bodies))
                                                 .size());
} catch (const abut::Error& error) {
  std::fprintf(stderr, "%s: %s\n", error.name(), error.what());
  return 1;
}
