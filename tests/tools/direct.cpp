// SPDX-License-Identifier: Apache-2.0
// The scene stack.json built by calls of the C interface; prints each contact as a row of numbers, for comparison with
// what the command line program writes.
#include <array>
#include <cstdint>
#include <cstdio>
#include <iterator>

#include "abut/abut.h"

namespace {

bool add(abut_universe* universe, abut_motion motion, double height, const abut_shape* shape) {
  abut_part_options options;
  abut_part_options_init(&options, sizeof options);
  options.motion = motion;
  options.pose.position.z = height;
  abut_part_id part;
  abut_geometry_id geometry;
  return abut_part_create(universe, &options, &part) == ABUT_OK &&
         abut_geometry_create(universe, part, shape, nullptr, &geometry) == ABUT_OK;
}

void print(const abut_vec3& v) { std::printf(" %.17g %.17g %.17g", v.x, v.y, v.z); }

// Ids, features and all numbers of one contact.
void print(const abut_contact& contact) {
  std::printf("%llu %u %u", static_cast<unsigned long long>(contact.id), contact.feature_a.index,
              contact.feature_b.index);
  print(contact.point_a);
  print(contact.point_b);
  print(contact.normal);
  std::printf(" %.17g %u\n", contact.distance, contact.age);
}

}  // namespace

int main() {
  const abut_vec3 up{0.0, 0.0, 1.0};
  abut_shape* ground = nullptr;
  abut_shape* crate = nullptr;
  abut_universe* universe = nullptr;
  bool good = abut_plane_create(&up, 0.0, &ground) == ABUT_OK && abut_box_create(0.5, 0.5, 0.5, &crate) == ABUT_OK &&
              abut_universe_create(nullptr, &universe) == ABUT_OK && add(universe, ABUT_MOTION_STATIC, 0.0, ground);
  for (const double step : std::array<double, 3>{0.0, 1.0, 2.0}) {
    good = good && add(universe, ABUT_MOTION_DYNAMIC, 0.4999 + 0.9999 * step, crate);
  }
  // Twice, as for --steps 2.
  for (int step = 0; good && step < 2; ++step) {
    good = abut_universe_step(universe, 0.01) == ABUT_OK;
    std::size_t count = 0;
    const abut_contact* contacts = nullptr;
    good = good && abut_universe_contacts(universe, &contacts, &count) == ABUT_OK;
    for (std::size_t i = 0; good && i < count; ++i) {
      print(*std::next(contacts, static_cast<std::ptrdiff_t>(i)));
    }
  }
  std::uint64_t hash = 0;
  good = good && abut_universe_hash(universe, &hash) == ABUT_OK;
  std::printf("%016llx\n", static_cast<unsigned long long>(hash));
  abut_universe_destroy(universe);
  abut_shape_release(crate);
  abut_shape_release(ground);
  return good ? 0 : 1;
}
