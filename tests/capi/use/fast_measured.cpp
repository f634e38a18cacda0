// SPDX-License-Identifier: Apache-2.0
// Fast geometries whose paths are measured: from the pose of the step before to the present one.
#include <cmath>
#include <random>

#include "moving.hpp"

namespace {

using namespace abut_test;

struct Measured {
  abut_part_id part;
  abut_pose end;
};
Measured add_measured(Universe& universe, const abut_shape* shape, const Moving& moving, abut_geometry_flags flags) {
  const abut_part_id part = universe.add_part(moving.start);
  universe.add_geometry(part, shape, with_flags(flags));
  require(abut_part_measure_velocity(universe, part));
  return {part, moving.at(1)};
}

TEST(FastMeasured, MeetsWhatOnlyATurnLeadsTo) {
  ABUT_NEEDS_MOTION();
  constexpr double begin = 0.3, turn = 2.5, thickness = 0.02, radius = 0.05, away = 0.9;
  const Shape rod = make_box(1, thickness, thickness), ball = make_sphere(radius);
  Universe universe;
  universe.add(ball, at(0, away, 0), ABUT_MOTION_STATIC);
  const Moving moving{{{0, 0, 0}, turned_by({0, 0, begin})}, {{0, 0, 0}, {0, 0, turn}}, {{0, 0, 0}, {0, 0, 0}}};
  const Measured swing = add_measured(universe, rod, moving, ABUT_GEOMETRY_FAST);
  universe.move(swing.part, swing.end);
  require(abut_universe_step(universe, 1));
  const auto impacts = impacts_of(universe);
  ASSERT_EQ(impacts.size(), 1U);
  const double exact = (std::acos((thickness + radius) / away) - begin) / turn;
  EXPECT_NEAR(impacts[0].lower, exact, 1e-9);
  EXPECT_NEAR(impacts[0].upper, exact, 1e-9);
}

// Plates, rods and balls that move and turn, and some that stay: many touch at the start, on the way, or both.
struct Crowd {
  std::vector<Moving> movings;
  std::vector<Shape> shapes;

  explicit Crowd(std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    const auto between = [&](double size) { return size * (static_cast<double>(engine() >> 11) * 0x1p-52 - 1); };
    const auto vector = [&](double size) { return abut_vec3{between(size), between(size), between(size)}; };
    for (std::size_t i = 0; i < 30; ++i) {
      const bool stays = i % 5 == 4, is_quick = i % 2 == 0;
      const double speed = stays ? 0 : is_quick ? 3 : 0.5;
      const abut_vec3 start = vector(1.2), orientation = vector(2), velocity = vector(speed), spin = vector(speed / 2);
      movings.push_back({{start, turned_by(orientation)}, {velocity, spin}, {{0, 0, 0}, {0, 0, 0}}});
      shapes.push_back(i % 3 == 0 ? make_box(0.4, 0.1, 0.02) : i % 3 == 1 ? make_capsule(0.05, 0.4) : make_sphere(0.2));
    }
  }
  static abut_geometry_flags flags(std::size_t i) { return i % 3 == 0 ? ABUT_GEOMETRY_FAST : 0; }
};

// A path says the same, whether it was given or measured.
TEST(FastMeasured, MeetsWhatItMeetsWithAVelocityThatIsGiven) {
  ABUT_NEEDS_MOTION();
  std::size_t touches = 0, at_start = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Crowd crowd(seed);
    Universe given, measured;
    std::vector<Measured> ends;
    for (std::size_t i = 0; i < crowd.movings.size(); ++i) {
      add_moving(given, crowd.shapes[i], crowd.movings[i], Crowd::flags(i));
      ends.push_back(add_measured(measured, crowd.shapes[i], crowd.movings[i], Crowd::flags(i)));
    }
    for (const Measured& its : ends) measured.move(its.part, its.end);
    require(abut_universe_step(given, 1));
    require(abut_universe_step(measured, 1));

    const auto wanted = impacts_of(given), found = impacts_of(measured);
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(found[i].geometry_a.slot, wanted[i].geometry_a.slot);
      EXPECT_EQ(found[i].geometry_b.slot, wanted[i].geometry_b.slot);
      EXPECT_NEAR(found[i].lower, wanted[i].lower, 1e-9);
      EXPECT_EQ(found[i].contact_count, wanted[i].contact_count);
    }
    touches += wanted.size();

    // Pairs without a fast geometry have the contacts of present poses, which differ.
    const auto with_fast = [&](const abut_universe* universe) {
      auto contacts = copy_of(abut_universe_contacts, universe);
      std::erase_if(contacts, [](const abut_contact& contact) {
        return Crowd::flags(contact.geometry_a.slot - 1) == 0 && Crowd::flags(contact.geometry_b.slot - 1) == 0;
      });
      return contacts;
    };
    const auto contacts_wanted = with_fast(given), contacts = with_fast(measured);
    ASSERT_EQ(contacts.size(), contacts_wanted.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      EXPECT_EQ(contacts[i].geometry_a.slot, contacts_wanted[i].geometry_a.slot);
      EXPECT_EQ(contacts[i].geometry_b.slot, contacts_wanted[i].geometry_b.slot);
      EXPECT_NEAR(contacts[i].toi, contacts_wanted[i].toi, 1e-9);
      EXPECT_NEAR(contacts[i].distance, contacts_wanted[i].distance, 1e-8);
      at_start += contacts[i].toi == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(touches, 100U);
  EXPECT_GT(at_start, 100U);
}

}  // namespace
