// SPDX-License-Identifier: Apache-2.0
// Back to an earlier state: what a caller sets again is all that contacts depend on. PL-03 of the specification.
#include <cmath>
#include <functional>

#include "support.hpp"

namespace {

using namespace abut_test;

constexpr int bodies = 60;
constexpr double first_place = 0, second_place = 1;

abut_pose pose_of(int body, double place) {
  const double turn = 0.3 * body + 0.9 * place;
  return {{2 * std::sin(1.3 * body + place), 2 * std::sin(2.1 * body + 0.3 * place),
           0.8 * std::cos(1.7 * body - 0.2 * place)},
          {std::cos(turn), 0, 0.6 * std::sin(turn), 0.8 * std::sin(turn)}};
}

// All points are kept: of many equally good ones a reduced manifold prefers those of the step before.
abut_universe_options all_points() {
  abut_universe_options options = default_universe_options();
  options.max_contacts = 0;
  return options;
}

class Rollback : public testing::Test {
 protected:
  Rollback() {
    universe.add(shapes.at(6), at(0, 0, -1), ABUT_MOTION_STATIC);
    for (int i = 0; i < bodies; ++i) {
      parts.push_back(universe.add_part(pose_of(i, first_place)));
      geometries.push_back(universe.add_geometry(parts.back(), shape_of(i)));
    }
  }

  const abut_shape* shape_of(int body) const {
    return shapes.at(kinds.at(static_cast<std::size_t>(body) % kinds.size()));
  }
  void move_all(double place) {
    for (int i = 0; i < bodies; ++i) universe.move(parts.at(static_cast<std::size_t>(i)), pose_of(i, place));
  }
  void park_some(abut_parking parking) {
    for (std::size_t i = 0; i < geometries.size(); i += 4) universe.park(geometries.at(i), parking);
  }
  void reshape_some(bool is_back) {
    for (int i = 1; i < bodies; i += 3) {
      const abut_shape* shape = shape_of(is_back ? i : i + 1);
      ASSERT_TRUE(succeeded(abut_geometry_set_shape(universe, geometries.at(static_cast<std::size_t>(i)), shape)));
    }
  }

  using Bits = std::vector<std::array<unsigned char, sizeof(abut_contact)>>;
  // Ages and values are of the history, which goes on.
  Bits found() {
    Bits bits;
    for (abut_contact contact : universe.step()) {
      contact.age = 0;
      contact.user_data = 0;
      bits.push_back(std::bit_cast<std::array<unsigned char, sizeof contact>>(contact));
    }
    return bits;
  }
  // There and back, also with several steps in between, and always the same bits.
  void expect_the_same_after(const std::function<void()>& away, const std::function<void()>& back) {
    const Bits before = found();
    EXPECT_GT(before.size(), 200U);
    for (int round = 1; round <= 3; ++round) {
      away();
      for (int i = 0; i < round; ++i) EXPECT_FALSE(found() == before) << "something has to change";
      back();
      EXPECT_TRUE(found() == before) << "round " << round;
    }
  }

  static constexpr std::array<std::size_t, 4> kinds{0, 1, 2, 4};
  const abut_universe_options options = all_points();
  const std::vector<Shape> shapes = make_one_of_each_kind();
  Universe universe{&options};
  std::vector<abut_part_id> parts;
  std::vector<abut_geometry_id> geometries;
};

TEST_F(Rollback, OfPosesBringsContactsBack) {
  expect_the_same_after([&] { move_all(second_place); }, [&] { move_all(first_place); });
}

TEST_F(Rollback, OfParkingBringsContactsBack) {
  for (const abut_parking parking : {ABUT_PARKING_SHORT_TERM, ABUT_PARKING_LONG_TERM}) {
    expect_the_same_after([&] { park_some(parking); }, [&] { park_some(ABUT_PARKING_NONE); });
  }
}

TEST_F(Rollback, OfShapesBringsContactsBack) {
  expect_the_same_after([&] { reshape_some(false); }, [&] { reshape_some(true); });
}

TEST_F(Rollback, OfEverythingBringsContactsBack) {
  const auto away = [&] {
    park_some(ABUT_PARKING_LONG_TERM);
    move_all(second_place);
    reshape_some(false);
  };
  const auto back = [&] {
    reshape_some(true);
    move_all(first_place);
    park_some(ABUT_PARKING_NONE);
  };
  expect_the_same_after(away, back);
}

}  // namespace
