// SPDX-License-Identifier: Apache-2.0
// What the tests of the C interface share about universes.
#include "support.hpp"

#include <iterator>

namespace abut_test {
namespace {

template <class Value>
void append(std::vector<unsigned char>& bytes, const Value& value) {
  const auto image = std::bit_cast<std::array<unsigned char, sizeof(Value)>>(value);
  bytes.insert(bytes.end(), image.begin(), image.end());
}

abut_part_id next_generation(abut_part_id id) { return {id.slot, id.generation + 1U}; }
abut_geometry_id next_generation(abut_geometry_id id) { return {id.slot, id.generation + 1U}; }

}  // namespace

Universe::Universe(const abut_universe_options* options) { require(abut_universe_create(options, &universe_)); }

abut_part_id Universe::add_part(const abut_pose& pose, abut_motion motion, std::uint64_t user_data) {
  abut_part_options options;
  abut_part_options_init(&options, sizeof options);
  options.pose = pose;
  options.motion = motion;
  options.user_data = user_data;
  abut_part_id part{};
  require(abut_part_create(universe_, &options, &part));
  return part;
}

abut_focus make_focus(std::uint32_t near_tag, std::uint32_t far_tag, double near_distance, double far_distance) {
  abut_focus focus = default_focus();
  focus.near_tag = near_tag;
  focus.far_tag = far_tag;
  focus.near_distance = near_distance;
  focus.far_distance = far_distance;
  return focus;
}

std::string letters_of(const std::vector<abut_event>& events) {
  std::string letters;
  for (const abut_event& event : events) {
    letters += std::string_view("bpe").at(event.kind);
    if ((event.flags & ABUT_EVENT_CONTACT) != 0) letters += 'c';
  }
  return letters;
}

abut_geometry_id Universe::add_geometry(abut_part_id part, const abut_shape* shape, double tolerance) {
  abut_geometry_options options = default_geometry_options();
  options.tolerance = tolerance;
  return add_geometry(part, shape, options);
}

abut_geometry_id Universe::add_geometry(abut_part_id part, const abut_shape* shape,
                                        const abut_geometry_options& options) {
  abut_geometry_id geometry{};
  require(abut_geometry_create(universe_, part, shape, &options, &geometry));
  return geometry;
}

abut_geometry_id Universe::add(const abut_shape* shape, const abut_pose& pose, abut_motion motion, double tolerance) {
  return add_geometry(add_part(pose, motion), shape, tolerance);
}

void Universe::move(abut_part_id part, const abut_pose& pose) { require(abut_part_set_pose(universe_, part, &pose)); }

void Universe::park(abut_geometry_id geometry, abut_parking parking) {
  require(abut_geometry_park(universe_, geometry, parking));
}

abut_geometry_info Universe::describe(abut_geometry_id geometry) const {
  abut_geometry_info info;
  abut_geometry_info_init(&info, sizeof info);
  require(abut_geometry_describe(universe_, geometry, &info));
  return info;
}

abut_step_stats Universe::stats() const {
  abut_step_stats stats;
  abut_step_stats_init(&stats, sizeof stats);
  require(abut_universe_stats(universe_, &stats));
  return stats;
}

std::uint64_t Universe::hash() const {
  std::uint64_t hash = 0;
  require(abut_universe_hash(universe_, &hash));
  return hash;
}

std::vector<abut_event> Universe::events() const { return copy_of(abut_universe_events, universe_); }

std::vector<abut_contact> Universe::contacts() const { return copy_of(abut_universe_contacts, universe_); }

std::vector<abut_contact> Universe::step() {
  require(abut_universe_step(universe_, 0.0));
  return contacts();
}

std::vector<unsigned char> snapshot(const abut_universe* universe) {
  std::vector<unsigned char> bytes;
  std::size_t count = 0;
  require(abut_universe_parts(universe, nullptr, 0, &count));
  std::vector<abut_part_id> parts(count);
  require(abut_universe_parts(universe, parts.data(), parts.size(), &count));
  for (const abut_part_id part : parts) {
    abut_pose pose{};
    std::uint64_t user_data = 0;
    require(abut_part_pose(universe, part, &pose));
    abut_motion motion = 0;
    require(abut_part_user_data(universe, part, &user_data));
    require(abut_part_motion(universe, part, &motion));
    append(bytes, part);
    append(bytes, motion);
    append(bytes, pose);
    append(bytes, user_data);
  }
  require(abut_universe_geometries(universe, nullptr, 0, &count));
  std::vector<abut_geometry_id> geometries(count);
  require(abut_universe_geometries(universe, geometries.data(), geometries.size(), &count));
  for (const abut_geometry_id geometry : geometries) {
    abut_geometry_info info;
    abut_geometry_info_init(&info, sizeof info);
    require(abut_geometry_describe(universe, geometry, &info));
    append(bytes, geometry);
    append(bytes, info);
  }
  abut_revision revision{};
  require(abut_universe_revision(universe, &revision));
  append(bytes, revision);
  abut_step_stats stats;
  abut_step_stats_init(&stats, sizeof stats);
  require(abut_universe_stats(universe, &stats));
  append(bytes, stats);
  const abut_contact* contacts = nullptr;
  require(abut_universe_contacts(universe, &contacts, &count));
  append(bytes, contacts);
  std::for_each_n(contacts, count, [&](const abut_contact& contact) { append(bytes, contact); });
  const abut_event* events = nullptr;
  require(abut_universe_events(universe, &events, &count));
  append(bytes, events);
  std::for_each_n(events, count, [&](const abut_event& event) { append(bytes, event); });
  abut_policy policy = default_policy();
  require(abut_policy_get(universe, 0, 1, &policy));
  append(bytes, policy);
  return bytes;
}

Scene::Scene() {
  geometry = universe.add(ball, at(0.0, 0.0, 0.0));
  second_geometry = universe.add(block, at(1.5, 0.0, 0.0));
  const abut_part_id doomed = universe.add_part(at(9.0, 0.0, 0.0));
  const abut_geometry_id doomed_geometry = universe.add_geometry(doomed, ball);
  for (int i = 0; i < 4; ++i) other.add(ball, at(5.0 * i, 0.0, 0.0));
  require(abut_part_destroy(universe, doomed));

  std::size_t count = 0;
  std::array<abut_part_id, 2> parts{};
  require(abut_universe_parts(universe, parts.data(), parts.size(), &count));
  part = parts[0];
  second_part = parts[1];
  std::array<abut_part_id, 4> foreign_parts{};
  require(abut_universe_parts(other, foreign_parts.data(), foreign_parts.size(), &count));
  std::array<abut_geometry_id, 4> foreign_geometries{};
  require(abut_universe_geometries(other, foreign_geometries.data(), foreign_geometries.size(), &count));

  constexpr std::uint32_t far = 0xFFFFFFFFU;
  stale_parts = {
      {0, 0},    doomed, foreign_parts[0], next_generation(part), {0, part.generation}, {1000, part.generation},
      {far, far}};
  stale_geometries = {{0, 0},
                      doomed_geometry,
                      foreign_geometries[0],
                      next_generation(geometry),
                      {0, geometry.generation},
                      {1000, geometry.generation},
                      {far, far}};
  EXPECT_FALSE(universe.step().empty()) << "the scene must have contacts";
  before_ = snapshot(universe);
}

}  // namespace abut_test
