// SPDX-License-Identifier: Apache-2.0
// Fast geometries: what they touch on their way through a step.
#include <cmath>
#include <numbers>
#include <random>

#include "moving.hpp"

namespace {

using namespace abut_test;

struct Numbers {
  std::mt19937_64 engine;

  explicit Numbers(std::uint64_t seed) : engine(seed) {}
  double between(double low, double high) { return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53; }
  abut_vec3 vector(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }
};

// A box flies at a wall whose face lies at x = 0, and on to the other side.
struct Shot {
  double thickness, way, angle, spin;
  double half() const { return 0.02 * thickness; }
  double outer() const { return std::sqrt(3.0) * half(); }
  double along() const { return way * std::cos(angle); }
  double gap() const { return 0.5 * along(); }
  Moving moving() const {
    return {at(-(outer() + gap()), 0, 0),
            {{along(), way * std::sin(angle), 0}, {0.6 * spin, 0, 0.8 * spin}},
            {{0, 0, 0}, {0, 0, 0}}};
  }
};

template <class Visit>
void for_each_shot(Visit&& visit) {
  for (const double thickness : {1e-3, 1e-2, 0.1, 1.0}) {
    for (const double speed : {1.0, 10.0, 1e3, 1e4}) {
      for (const double angle : {0.0, 0.4, 1.2, 1.5}) {
        for (const double spin : {0.0, 1.0, 6.0, 40.0}) visit(Shot{thickness, speed * thickness, angle, spin});
      }
    }
  }
}

TEST(Fast, PassesThroughNoWall) {
  ABUT_NEEDS_MOTION();
  for_each_shot([](const Shot& shot) {
    SCOPED_TRACE(testing::Message() << "thickness " << shot.thickness << ", way " << shot.way << ", angle "
                                    << shot.angle << ", spin " << shot.spin);
    Universe universe;
    const Shape wall = make_box(shot.thickness / 2, 1e5, 1e5);
    const Shape bullet = make_box(shot.half(), shot.half(), shot.half());
    universe.add(wall, at(shot.thickness / 2, 0, 0), ABUT_MOTION_STATIC);
    add_moving(universe, bullet, shot.moving(), ABUT_GEOMETRY_FAST);
    require(abut_universe_step(universe, 1));
    const auto impacts = impacts_of(universe);
    ASSERT_GE(impacts.size(), 1U);
    EXPECT_TRUE(impacts.size() == 1 || shot.spin > 0) << "only what spins touches again";
    // The ball around the box touches first, the ball within it last.
    const double earliest = shot.gap() / shot.along();
    const double latest = (shot.gap() + shot.outer() - shot.half()) / shot.along();
    EXPECT_GE(impacts[0].upper, earliest - 1e-9);
    EXPECT_LE(impacts[0].lower, latest + 1e-9);
    EXPECT_EQ(impacts[0].is_undecided, 0U);
    const auto contacts = universe.contacts();
    ASSERT_EQ(impacts[0].first_contact, 0U);
    ASSERT_GE(impacts[0].contact_count, 1U);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const abut_contact& contact = contacts[i];
      EXPECT_TRUE(succeeded(abut_contact_validate(&contact)));
      EXPECT_EQ(contact.flags, std::uint32_t{ABUT_CONTACT_SPECULATIVE});
      if (i >= impacts[0].contact_count) continue;
      EXPECT_EQ(contact.toi, impacts[0].lower);
      EXPECT_NEAR(contact.normal.x, -1, 1e-6) << "from the wall to the bullet";
      EXPECT_NEAR(contact.point_a.x, 0, 1e-4 * shot.thickness);
    }
  });
}

TEST(Fast, WallsLetOthersThrough) {
  std::size_t through = 0, shots = 0;
  for_each_shot([&](const Shot& shot) {
    if (shot.along() < 4 * shot.thickness) return;
    ++shots;
    Universe universe;
    const Shape wall = make_box(shot.thickness / 2, 1e5, 1e5);
    const Shape bullet = make_box(shot.half(), shot.half(), shot.half());
    universe.add(wall, at(shot.thickness / 2, 0, 0), ABUT_MOTION_STATIC);
    const Moving moving = shot.moving();
    const abut_part_id part = add_moving(universe, bullet, moving, 0);
    require(abut_universe_step(universe, 1));
    const std::size_t before = universe.contacts().size();
    universe.move(part, moving.at(1));
    require(abut_universe_step(universe, 1));
    through += before + universe.contacts().size() == 0 ? 1 : 0;
  });
  EXPECT_EQ(through, shots);
  EXPECT_GT(shots, 100U);
}

TEST(Fast, MeetsWhateverIsOnItsWay) {
  ABUT_NEEDS_MOTION();
  const Shape ball = make_sphere(0.1), sheet = make_square_mesh(5), plate = make_box(5, 5, 0.01);
  const Moving down{at(1, 0.5, 20), {{0, 0, -1000}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}};
  const abut_sleep sleep = default_sleep();
  for (const bool is_first : {true, false}) {
    for (const char* const other : {"static", "animated", "asleep", "sensor", "fast", "coming", "mesh", "parked"}) {
      SCOPED_TRACE(testing::Message() << other << ", " << is_first);
      const std::string_view what(other);
      Universe universe;
      if (is_first) add_moving(universe, ball, down, ABUT_GEOMETRY_FAST);
      const abut_motion motion = what == "static"     ? ABUT_MOTION_STATIC
                                 : what == "animated" ? ABUT_MOTION_ANIMATED
                                                      : ABUT_MOTION_DYNAMIC;
      const abut_part_id part = universe.add_part(identity, motion);
      const abut_geometry_id plate_id = universe.add_geometry(part, what == "mesh" ? sheet : plate,
                                                              with_flags(what == "sensor" ? ABUT_GEOMETRY_SENSOR
                                                                         : what == "fast" ? ABUT_GEOMETRY_FAST
                                                                                          : 0));
      if (what == "coming") {
        const abut_velocity up{{0, 0, 1000}, {0, 0, 0}};
        require(abut_part_set_velocity(universe, part, &up));
      }
      if (what == "asleep") {
        require(abut_part_set_sleep(universe, part, &sleep));
        for (int step = 0; step < 20; ++step) require(abut_universe_step(universe, 0.001));
        std::uint32_t is_asleep = 0;
        require(abut_part_is_asleep(universe, part, &is_asleep));
        ASSERT_EQ(is_asleep, 1U);
      }
      if (!is_first) add_moving(universe, ball, down, ABUT_GEOMETRY_FAST);
      if (what == "parked") {
        universe.park(plate_id, ABUT_PARKING_SHORT_TERM);
        require(abut_universe_step(universe, 0.1));
        EXPECT_TRUE(impacts_of(universe).empty()) << "it is not there";
        universe.park(plate_id, ABUT_PARKING_NONE);
      }
      require(abut_universe_step(universe, 0.1));
      const auto impacts = impacts_of(universe);
      ASSERT_EQ(impacts.size(), 1U);
      const double way = what == "mesh" ? 19.9 : 19.89;
      EXPECT_NEAR(impacts[0].lower, (what == "coming" ? way / 2 : way) / 100, 1e-9);
      ASSERT_EQ(universe.contacts().size(), 1U);
      const abut_contact contact = universe.contacts()[0];
      EXPECT_EQ(contact.flags, (what == "sensor" ? ABUT_CONTACT_SENSOR : 0U) | ABUT_CONTACT_SPECULATIVE);
      EXPECT_NEAR(contact.distance, way, 1e-6) << "where the bodies are at the start";
    }
  }
}

TEST(Fast, FallsOnAPlaneWhenTheClosedFormSays) {
  ABUT_NEEDS_MOTION();
  const Shape ball = make_sphere(0.5), plane = make_plane({0, 0, 1}, 0);
  for (const double speed : {-30.0, -1.0, 0.0, 3.0}) {
    Universe universe;
    universe.add(plane, identity, ABUT_MOTION_STATIC);
    const double height = 4, gravity = 9.81, dt = 2;
    add_moving(universe, ball, {at(0, 0, height + 0.5), {{1, 2, speed}, {0, 3, 0}}, {{0, 0, -gravity}, {0, 0, 0}}},
               ABUT_GEOMETRY_FAST);
    require(abut_universe_step(universe, dt));
    const auto impacts = impacts_of(universe);
    ASSERT_EQ(impacts.size(), 1U);
    const double exact = (speed + std::sqrt(speed * speed + 2 * gravity * height)) / gravity / dt;
    EXPECT_LE(impacts[0].lower, exact + 1e-12);
    EXPECT_GE(impacts[0].upper, exact - 1e-12);
    EXPECT_NEAR(impacts[0].upper - impacts[0].lower, 0, 1e-6);
  }
}

TEST(Fast, GoesFromThePoseBeforeToThePresentOneWhereItIsMeasured) {
  ABUT_NEEDS_MOTION();
  Universe universe;
  const Shape ball = make_sphere(0.1), wall = make_box(0.001, 9, 9);
  universe.add(wall, identity, ABUT_MOTION_STATIC);
  const abut_part_id part = universe.add_part(at(-3, 0, 0));
  universe.add_geometry(part, ball, with_flags(ABUT_GEOMETRY_FAST));
  require(abut_part_measure_velocity(universe, part));
  universe.move(part, at(1, 0, 0));
  require(abut_universe_step(universe, 0.5));
  auto impacts = impacts_of(universe);
  ASSERT_EQ(impacts.size(), 1U);
  EXPECT_NEAR(impacts[0].lower, (3 - 0.101) / 4, 1e-9);
  const abut_contact contact = universe.contacts().at(0);
  EXPECT_NEAR(contact.distance, 3 - 0.101, 1e-9);
  require(abut_universe_step(universe, 0.5));
  EXPECT_TRUE(impacts_of(universe).empty()) << "it stands on the other side";
  EXPECT_TRUE(universe.contacts().empty());
  universe.move(part, at(-1, 0, 0));
  require(abut_universe_step(universe, 0));
  EXPECT_TRUE(universe.contacts().empty()) << "without time there is no way";
  require(abut_universe_step(universe, 0.1));
  EXPECT_EQ(impacts_of(universe).size(), 1U);
}

TEST(Fast, HasTheContactsOfTheStartWhereItTouchesThere) {
  ABUT_NEEDS_MOTION();
  const Shape box = make_box(0.5, 0.5, 0.5);
  std::array<std::vector<abut_contact>, 2> found;
  for (const std::size_t is_fast : {0U, 1U}) {
    Universe universe;
    universe.add(make_box(5, 5, 0.5), at(0, 0, -0.5), ABUT_MOTION_STATIC);
    add_moving(universe, box, {at(0.1, 0.2, 0.4999), {{3, 0, -800}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}},
               is_fast == 1 ? ABUT_GEOMETRY_FAST : 0);
    require(abut_universe_step(universe, 0.1));
    EXPECT_TRUE(impacts_of(universe).empty());
    found.at(is_fast) = universe.contacts();
  }
  ASSERT_EQ(found[0].size(), 4U);
  ASSERT_EQ(found[1].size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(found[0][i].id, found[1][i].id);
    EXPECT_EQ(found[0][i].distance, found[1][i].distance);
    EXPECT_EQ(found[1][i].toi, 0);
    EXPECT_EQ(found[1][i].flags, 0U);
  }
}

TEST(Fast, KeepsContactsEventsAndValuesOfYours) {
  ABUT_NEEDS_MOTION();
  abut_universe_options options = default_universe_options();
  options.events = ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST;
  Universe universe(&options);
  universe.add(make_box(5, 5, 0.5), at(0, 0, -0.5), ABUT_MOTION_STATIC);
  const Moving falling{at(0, 0, 3), {{0, 0, -100}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}};
  const abut_part_id part = add_moving(universe, make_box(0.5, 0.5, 0.5), falling, ABUT_GEOMETRY_FAST);
  require(abut_universe_step(universe, 0.01));
  EXPECT_EQ(letters_of(universe.events()), "");
  require(abut_universe_step(universe, 0.1));
  ASSERT_EQ(universe.contacts().size(), 4U) << "a face on a face";
  EXPECT_EQ(letters_of(universe.events()), "b");
  require(abut_contacts_set_user_data(universe, std::array<std::uint64_t, 4>{1, 2, 3, 4}.data(), 4));
  const auto flying = universe.contacts();
  const abut_velocity none{{0, 0, 0}, {0, 0, 0}};
  require(abut_part_set_velocity(universe, part, &none));
  universe.move(part, at(0, 0, 0.4999));
  require(abut_universe_step(universe, 0.1));
  EXPECT_EQ(letters_of(universe.events()), "p");
  const auto lying = universe.contacts();
  ASSERT_EQ(lying.size(), 4U);
  for (const abut_contact& contact : lying) {
    EXPECT_EQ(contact.age, 1U);
    const auto before =
        std::find_if(flying.begin(), flying.end(), [&](const auto& its) { return its.id == contact.id; });
    ASSERT_NE(before, flying.end()) << "the same features touch";
    EXPECT_EQ(contact.user_data, before->user_data);
    EXPECT_EQ(contact.toi, 0);
  }
  universe.move(part, at(0, 0, 3));
  require(abut_universe_step(universe, 0.1));
  EXPECT_EQ(letters_of(universe.events()), "e");
}

TEST(Fast, TouchesInOrderOfTime) {
  ABUT_NEEDS_MOTION();
  Universe universe;
  const Shape ball = make_sphere(0.1), sheet = make_box(0.01, 4, 4);
  std::vector<abut_geometry_id> sheets;
  for (const double x : {5.0, 1.0, 4.0, 2.0, 3.0})
    sheets.push_back(universe.add(sheet, at(x, 0, 0), ABUT_MOTION_STATIC));
  add_moving(universe, ball, {identity, {{100, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}}, ABUT_GEOMETRY_FAST);
  require(abut_universe_step(universe, 0.1));
  const auto impacts = impacts_of(universe);
  const auto contacts = universe.contacts();
  ASSERT_EQ(impacts.size(), 5U);
  const std::array<std::size_t, 5> order{1, 3, 4, 2, 0};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(impacts[i].geometry_a, sheets[order.at(i)]);
    EXPECT_NEAR(impacts[i].lower, (static_cast<double>(i + 1) - 0.11) / 10, 1e-9);
    ASSERT_EQ(impacts[i].contact_count, 1U);
    EXPECT_EQ(contacts.at(impacts[i].first_contact).toi, impacts[i].lower);
  }
}

// A scene of boxes and balls that all move, some of them fast.
struct Crowd {
  std::vector<Moving> movings;
  std::vector<Shape> shapes;
  std::vector<bool> is_fast;

  explicit Crowd(std::uint64_t seed, std::size_t count) {
    Numbers numbers(seed);
    for (std::size_t i = 0; i < count; ++i) {
      const bool fast = i % 3 == 0, is_quick = fast || i % 3 == 1;
      Moving moving{{numbers.vector(1.5), turned_by(numbers.vector(2))},
                    {numbers.vector(is_quick ? 6 : 1), numbers.vector(fast ? 6 : 1)},
                    {numbers.vector(is_quick ? 6 : 1), numbers.vector(2)}};
      if (i % 5 == 4) moving.velocity = {{0, 0, 0}, {0, 0, 0}};
      movings.push_back(moving);
      shapes.push_back(i % 2 == 0 ? make_box(0.4, 0.1, 0.02) : make_sphere(0.2));
      is_fast.push_back(fast);
    }
  }
  void put_into(Universe& universe) const {
    for (std::size_t i = 0; i < movings.size(); ++i) {
      add_moving(universe, shapes[i], movings[i], is_fast[i] ? ABUT_GEOMETRY_FAST : 0);
    }
  }
};

TEST(Fast, MissesNothingOfWhatSampledWaysMeet) {
  ABUT_NEEDS_MOTION();
  constexpr std::size_t count = 24;
  std::size_t met = 0;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Crowd crowd(seed, count);
    Universe universe;
    crowd.put_into(universe);
    require(abut_universe_step(universe, 1));
    std::vector<std::vector<double>> found(count, std::vector<double>(count, 2));
    for (const abut_contact& contact : universe.contacts()) {
      found.at(contact.geometry_a.slot - 1).at(contact.geometry_b.slot - 1) = contact.toi;
    }
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = a + 1; b < count; ++b) {
        if (!crowd.is_fast[a] && !crowd.is_fast[b]) continue;
        double first = 3;
        for (int sample = 0; sample <= 64 && first > 2; ++sample) {
          const double t = sample / 64.0;
          const bool overlaps =
              distance_of(crowd.shapes[a], crowd.movings[a].at(t), crowd.shapes[b], crowd.movings[b].at(t)) < -1e-9;
          first = overlaps ? t : first;
        }
        met += first <= 1 ? 1 : 0;
        EXPECT_TRUE(first > 1 || found[a][b] <= first) << a << " meets " << b << " at " << first;
        if (found[a][b] > 0 && found[a][b] < 2) {
          const double t = found[a][b];
          EXPECT_LT(
              std::fabs(distance_of(crowd.shapes[a], crowd.movings[a].at(t), crowd.shapes[b], crowd.movings[b].at(t))),
              1e-6)
              << a << " meets " << b << " at " << t;
        }
      }
    }
  }
  EXPECT_GT(met, 40U);
}

TEST(Fast, IsTheSameForAllThreadsAndBroadPhases) {
  ABUT_NEEDS_MOTION();
  const Crowd crowd(7, 60);
  std::vector<std::uint64_t> hashes;
  for (const abut_broadphase broadphase : broadphases) {
    for (const std::uint32_t threads : {1U, threads_of_build(4)}) {
      abut_universe_options options = default_universe_options();
      options.broadphase = broadphase;
      options.threads = threads;
      Universe universe(&options);
      crowd.put_into(universe);
      std::uint64_t sum = 0;
      for (int step = 0; step < 3; ++step) {
        require(abut_universe_step(universe, 0.5));
        sum = sum * 31 + universe.hash();
        for (const abut_step_impact& impact : impacts_of(universe)) {
          sum = sum * 31 + std::bit_cast<std::uint64_t>(impact.lower) + impact.first_contact;
        }
      }
      hashes.push_back(sum);
    }
  }
  EXPECT_EQ(std::count(hashes.begin(), hashes.end(), hashes[0]), static_cast<std::ptrdiff_t>(hashes.size()));
}

TEST(Fast, AsksOnlyThoseNearALongWay) {
  ABUT_NEEDS_MOTION();
  Universe universe;
  const Shape stone = make_sphere(0.3);
  std::vector<std::size_t> near(3);
  constexpr int side = 14;
  for (int i = 0; i < side * side * side; ++i) {
    const abut_vec3 place{1.0 * (i % side), 1.0 * (i / side % side), 1.0 * (i / side / side)};
    universe.add(stone, {place, no_rotation}, ABUT_MOTION_STATIC);
    const double along = (place.x + place.y + place.z) / 3;
    const double away = length(sum(place, {-along, -along, -along}));
    near[0] += away < 1.2 ? 1 : 0;
  }
  const Moving diagonal{at(-0.5, -0.5, -0.5), {{side, side, side}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}};
  add_moving(universe, make_sphere(0.1), diagonal, ABUT_GEOMETRY_FAST);
  require(abut_universe_step(universe, 1));
  const std::uint64_t candidates = universe.stats().candidate_pairs;
  EXPECT_EQ(impacts_of(universe).size(), static_cast<std::size_t>(side));
  EXPECT_LE(candidates, near[0]) << "of " << side * side * side << " that are in the box of the whole way";
  EXPECT_GE(candidates, static_cast<std::uint64_t>(side));
}

TEST(Fast, GoesOnAfterItWasSaved) {
  ABUT_NEEDS_MOTION();
  const Crowd crowd(9, 40);
  Universe universe;
  crowd.put_into(universe);
  require(abut_universe_step(universe, 0.3));
  std::size_t size = 0;
  require(abut_universe_save(universe, nullptr, 0, &size));
  std::vector<unsigned char> bytes(size);
  require(abut_universe_save(universe, bytes.data(), size, &size));
  abut_universe* again = nullptr;
  require(abut_universe_load(bytes.data(), size, &again));
  const auto before = impacts_of(universe), loaded = impacts_of(again);
  ASSERT_FALSE(before.empty());
  ASSERT_EQ(before.size(), loaded.size());
  EXPECT_EQ(before[0].lower, loaded[0].lower);
  EXPECT_EQ(copy_of(abut_universe_contacts, again).at(before[0].first_contact).toi, before[0].lower);
  for (abut_universe* const its : {static_cast<abut_universe*>(universe), again}) require(abut_universe_step(its, 0.3));
  std::uint64_t hash = 0;
  require(abut_universe_hash(again, &hash));
  EXPECT_EQ(hash, universe.hash());
  EXPECT_EQ(impacts_of(again).size(), impacts_of(universe).size());
  abut_universe_destroy(again);
}

TEST(Fast, AdvancesUntilSomethingTouches) {
  ABUT_NEEDS_MOTION();
  std::size_t stopped = 0;
  for (std::uint64_t seed = 20; seed < 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Crowd crowd(seed, 12);
    Universe universe;
    crowd.put_into(universe);
    const double dt = 0.8;
    std::vector<abut_part_id> parts(crowd.movings.size());
    std::size_t count = 0;
    require(abut_universe_parts(universe, parts.data(), parts.size(), &count));
    abut_step_impact first{};
    require(abut_universe_advance_to_first_impact(universe, dt, &first));
    stopped += first.geometry_a.slot != 0 ? 1 : 0;
    EXPECT_EQ(first.lower == 1, first.geometry_a.slot == 0);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      abut_pose pose{};
      require(abut_part_pose(universe, parts[i], &pose));
      const abut_pose expected = crowd.movings[i].at(first.lower * dt);
      EXPECT_LT(length(sum(pose.position, times(-1, expected.position))), 1e-12);
    }
    std::vector<abut_pose> poses(parts.size());
    require(abut_parts_poses(universe, parts.data(), parts.size(), poses.data()));
    for (std::size_t a = 0; a < parts.size(); ++a) {
      for (std::size_t b = a + 1; b < parts.size(); ++b) {
        const auto gap = [&](const abut_pose& one, const abut_pose& other) {
          return distance_of(crowd.shapes[a], one, crowd.shapes[b], other);
        };
        const bool is_fast = crowd.is_fast[a] || crowd.is_fast[b];
        if (is_fast && gap(crowd.movings[a].start, crowd.movings[b].start) > 0) {
          EXPECT_GT(gap(poses[a], poses[b]), -1e-12) << a << " and " << b;
        }
      }
    }
  }
  EXPECT_GE(stopped, 5U);
}

TEST(Fast, SpeculativeContactsReachAsFarAsTheMotion) {
  ABUT_NEEDS_MOTION();
  for (const double speed : {-30.0, -20.1, -19.9, 30.0}) {
    Universe universe;
    universe.add(make_box(5, 5, 0.5), at(0, 0, -0.5), ABUT_MOTION_STATIC);
    const Moving moving{at(0, 0, 2.5), {{0, 0, speed}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}};
    add_moving(universe, make_box(0.5, 0.5, 0.5), moving, ABUT_GEOMETRY_SPECULATIVE);
    require(abut_universe_step(universe, 0.1));
    const auto contacts = universe.contacts();
    ASSERT_EQ(contacts.size(), speed < -20 ? 4U : 0U) << speed;
    for (const abut_contact& contact : contacts) {
      EXPECT_EQ(contact.flags, std::uint32_t{ABUT_CONTACT_SPECULATIVE});
      EXPECT_EQ(contact.toi, 0);
      EXPECT_EQ(contact.distance, 2);
    }
    EXPECT_TRUE(impacts_of(universe).empty());
  }
}

std::string words_of(const abut_universe* universe) {
  std::array<char, 16384> text{};
  std::size_t needed = 0;
  require(abut_universe_explain(universe, text.data(), text.size(), &needed));
  return text.data();
}

TEST(Fast, IsExplained) {
  ABUT_NEEDS_MOTION();
  Universe universe;
  const Shape ball = make_sphere(0.1);
  const abut_geometry_id wall = universe.add(make_box(0.01, 4, 4), at(5, 0, 0), ABUT_MOTION_STATIC);
  require(abut_universe_step(universe, 0.1));
  EXPECT_NE(words_of(universe).find("continuous pass: no geometry is fast or speculative"), std::string::npos);
  const abut_part_id part = universe.add_part(identity);
  const abut_geometry_id fast = universe.add_geometry(part, ball, with_flags(ABUT_GEOMETRY_FAST));
  const abut_velocity velocity{{100, 0, 0}, {0, 0, 0}};
  abut_apart_reasons reasons = 0;
  require(abut_universe_step(universe, 0.1));
  require(abut_universe_why_apart(universe, wall, fast, &reasons));
  EXPECT_EQ(reasons, std::uint32_t{ABUT_APART_BOXES});
  require(abut_part_set_velocity(universe, part, &velocity));
  require(abut_universe_step(universe, 0.1));
  require(abut_universe_why_apart(universe, wall, fast, &reasons));
  EXPECT_EQ(reasons, 0U) << "it was examined on its path";
  EXPECT_EQ(universe.describe(fast).flags, std::uint32_t{ABUT_GEOMETRY_FAST});
  EXPECT_NE(words_of(universe).find("paths: 1 fast geometry, 0 speculative, 1 pair examined, 1 impact"),
            std::string::npos)
      << words_of(universe);
}

}  // namespace
