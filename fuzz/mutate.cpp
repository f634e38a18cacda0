// SPDX-License-Identifier: Apache-2.0
module;
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
module abut.fuzz;

namespace abut::fuzz {

void snap_to_touching(std::size_t place_a, std::size_t place_b, Record& record) {
  const Result<Scene> scene = make_scene(place_a, place_b, record);
  Distance found{};
  if (!scene || pair_distance(scene.value().a, scene.value().b, scene.value().ab, {}, found) != Outcome::ok) {
    return;
  }
  const Vec3 position = scene.value().ab.position - found.distance * found.normal;
  if (is_finite(position)) {
    record.position = {position.x, position.y, position.z};
  }
}

void mutate(std::size_t place_a, std::size_t place_b, Record& record, std::uint64_t seed) {
  Random random(seed);
  const std::size_t field = random.below(number_count);
  const Real value = number_at(record, field);
  switch (random.below(8)) {
    case 0: set_number(record, field, -value); break;
    case 1: set_number(record, field, std::nextafter(value, random.below(2) == 0 ? infinity : -infinity)); break;
    case 2:
      // The same number of the other shape, or for the pose a number of a shape.
      set_number(record, field, number_at(record, field < 16 ? (field + 8) % 16 : random.below(16)));
      break;
    case 3: set_number(record, field, std::copysign(std::exp2(static_cast<Real>(random.below(41)) - 20), value)); break;
    case 4: set_number(record, field, 0); break;
    case 5: record.flags = static_cast<std::uint8_t>(record.flags ^ (1u << random.below(8))); break;
    default: snap_to_touching(place_a, place_b, record); break;
  }
}

void mutate(std::size_t place_a, std::size_t place_b, MovingRecord& record, std::uint64_t seed) {
  Random random(seed);
  const std::size_t field = random.below(motion_number_count);
  Real& value = record.motion[field];
  switch (random.below(8)) {
    case 0: value = -value; break;
    case 1: value = random.below(2) == 0 ? 0 : random.between(-4, 4); break;
    case 2: value = std::copysign(std::exp2(static_cast<Real>(random.below(26)) - 20), value); break;
    // The same number of the other body.
    case 3: value = record.motion[(field + motion_number_count / 2) % motion_number_count]; break;
    case 4: record.aim = static_cast<std::uint8_t>(record.aim ^ (1u << random.below(8))); break;
    default: mutate(place_a, place_b, record.scene, random.bits()); break;
  }
}

}  // namespace abut::fuzz
