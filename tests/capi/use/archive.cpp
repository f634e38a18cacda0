// SPDX-License-Identifier: Apache-2.0
// A universe that was saved and loaded goes on as the one that was saved: the same ids, contacts, events and bits,
// whatever is done to both.
#include <cstring>
#include <random>

#include "archive_support.hpp"

namespace {

using namespace abut_test;

std::vector<Shape> all_shapes() {
  std::vector<Shape> shapes = make_one_of_each_kind();
  shapes.push_back(make_of_kind("cylinder", {0.5, 0.7}));
  shapes.push_back(make_of_kind("cone", {0.6, 0.8}));
  shapes.push_back(make_of_kind("ellipsoid", {0.4, 0.6, 0.9}));
  shapes.push_back(make_of_kind("segment", {0.9}));
  shapes.push_back(make_of_kind("triangle", {1, 0, 0, -0.5, 0.8, 0, -0.5, -0.8, 0.3}));
  shapes.push_back(make_of_kind("particles", {0.3}, {0, 0, 0, 0.5, 0.5, 0, -0.5, 0.2, 0.4}));
  shapes.push_back(make_of_kind("particles", {0}, {0, 0, 0, 0.5, 0.5, 0.5, 0.2, 0.1}));
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> cloud(3 * 90);
  for (double& number : cloud) number = 0.5 * normal(random);
  shapes.push_back(make_of_kind("hull", {}, cloud));
  shapes.push_back(make_of_kind("hull", {}, {0, 0, 0, 1, 0.1, 0, 0.2, 1, 0, 0.9, 0.9, 0}));
  shapes.push_back(make_of_kind("hull", {}, {0.3, 0, 0, 1, 0.1, 0}));
  const Shape ball = make_sphere(0.4), block = make_box(0.5, 0.5, 0.5),
              bore = make_of_kind("cylinder_hole", {0.2, 2, 3});
  const Shape inner = make_composite({block, bore}, {identity, at(0.1, 0, 0)});
  shapes.push_back(make_composite({ball, inner, ball}, {at(0, 0, 1), {{0, 0.3, 0}, {0.8, 0.6, 0, 0}}, at(0, 0, -1)}));
  return shapes;
}

// Two universes to which the same is done.
class Twins {
 public:
  Twins(std::uint32_t seed, abut_broadphase broadphase) : random_(seed) {
    abut_universe_options options = default_universe_options();
    options.broadphase = broadphase;
    options.events = ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST | ABUT_EVENTS_CONTACTS;
    options.flags = seed % 2 == 0 ? ABUT_UNIVERSE_LOCAL_POINTS : 0;
    options.tolerance_mode = seed % 3 == 0 ? ABUT_TOLERANCE_MARGIN : ABUT_TOLERANCE_DEAD_BAND;
    abut_universe* made = nullptr;
    require(abut_universe_create(&options, &made));
    universes_.push_back(Owned(made));
    require(abut_universe_follow_islands(made, 1));
    for (int i = 0; i < 40; ++i) add();
  }

  void save_and_load() {
    const std::vector<std::uint8_t> bytes = saved(first());
    universes_.resize(1);
    universes_.push_back(loaded(bytes));
    EXPECT_EQ(saved(universes_[1].get()), bytes) << "what was loaded is saved as it was";
  }

  // The same edits in both.
  void edit() {
    for (int i = 0; i < 12; ++i) edit_once();
  }
  void step() {
    for (const Owned& its : universes_) require(abut_universe_step(its.get(), 0.01));
  }
  void refresh() {
    for (const Owned& its : universes_) require(abut_universe_refresh(its.get()));
  }

  void expect_equal(const std::string& when) const {
    ASSERT_EQ(universes_.size(), 2U);
    const abut_universe *one = universes_[0].get(), *other = universes_[1].get();
    expect_same(copy_of(abut_universe_contacts, one), copy_of(abut_universe_contacts, other), when + ", contacts");
    expect_same(copy_of(abut_universe_events, one), copy_of(abut_universe_events, other), when + ", events");
    expect_same(copy_of(abut_universe_islands, one), copy_of(abut_universe_islands, other), when + ", islands");
    expect_same(copy_of(abut_universe_sleep_changes, one), copy_of(abut_universe_sleep_changes, other),
                when + ", sleep");
    expect_same(ids(one, abut_universe_geometries), ids(other, abut_universe_geometries), when + ", geometries");
    std::uint64_t hash = 0, other_hash = 1;
    require(abut_universe_hash(one, &hash));
    require(abut_universe_hash(other, &other_hash));
    EXPECT_EQ(hash, other_hash) << when;
    for (const abut_part_id part : parts_) {
      abut_velocity a{}, b{};
      require(abut_part_velocity(one, part, &a, nullptr));
      require(abut_part_velocity(other, part, &b, nullptr));
      EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0) << when;
    }
  }

  abut_universe* first() const { return universes_[0].get(); }
  abut_universe* second() const { return universes_[1].get(); }

 private:
  template <class Value>
  static void expect_same(const std::vector<Value>& one, const std::vector<Value>& other, const std::string& when) {
    ASSERT_EQ(one.size(), other.size()) << when;
    EXPECT_TRUE(one.empty() || std::memcmp(one.data(), other.data(), one.size() * sizeof(Value)) == 0) << when;
  }
  static std::vector<abut_geometry_id> ids(const abut_universe* universe, decltype(abut_universe_geometries) list) {
    std::vector<abut_geometry_id> all(200);
    std::size_t count = 0;
    require(list(universe, all.data(), all.size(), &count));
    all.resize(count);
    return all;
  }

  std::uint32_t choose(std::size_t count) { return static_cast<std::uint32_t>(random_() % count); }
  double real(double most) { return std::uniform_real_distribution<double>(-most, most)(random_); }
  abut_pose pose() {
    const double w = real(1), x = real(1), y = real(1), z = 1.1 + real(1);
    const double length = std::sqrt(w * w + x * x + y * y + z * z);
    return {{real(3), real(3), real(2)}, {w / length, x / length, y / length, z / length}};
  }

  template <class Call>
  void both(Call call) {
    for (const Owned& its : universes_) require(call(its.get()));
  }
  // Makes the same in both, under the same id.
  template <class Id, class Call>
  Id create(Call call) {
    std::vector<Id> made(universes_.size());
    for (std::size_t i = 0; i < universes_.size(); ++i) require(call(universes_[i].get(), &made[i]));
    EXPECT_TRUE(made.front() == made.back());
    return made.front();
  }

  void add() {
    abut_part_options part;
    abut_part_options_init(&part, sizeof part);
    part.pose = pose();
    part.motion = choose(5) == 0 ? choose(3) : std::uint32_t{ABUT_MOTION_DYNAMIC};
    part.user_data = random_();
    const auto id =
        create<abut_part_id>([&](abut_universe* its, abut_part_id* out) { return abut_part_create(its, &part, out); });
    parts_.push_back(id);
    const std::uint32_t count = 1 + choose(2);
    for (std::uint32_t i = 0; i < count; ++i) add_geometry(id);
    if (choose(2) == 0) {
      abut_sleep sleep = default_sleep();
      sleep.steps = 2;
      both([&](abut_universe* its) { return abut_part_set_sleep(its, id, &sleep); });
    }
    if (choose(3) == 0) both([&](abut_universe* its) { return abut_part_measure_velocity(its, id); });
  }
  abut_geometry_options options() {
    abut_geometry_options its = default_geometry_options();
    its.pose = pose();
    its.pose.position = {real(0.5), real(0.5), 0};
    its.tolerance = choose(3) == 0 ? 0.01 : 0;
    its.user_data = random_();
    its.layers = 1 + choose(3);
    its.exclusion = choose(6) == 0 ? 2 : 0;
    its.label = choose(3);
    its.tag = choose(3);
    its.material = choose(4);
    its.flags = choose(6) == 0 ? ABUT_GEOMETRY_SENSOR : 0;
    its.parking = choose(8) == 0 ? choose(3) : std::uint32_t{ABUT_PARKING_NONE};
    return its;
  }
  void add_geometry(abut_part_id part) {
    const abut_geometry_options its = options();
    const abut_shape* shape = shapes_[choose(shapes_.size())];
    geometries_.push_back(create<abut_geometry_id>([&](abut_universe* universe, abut_geometry_id* out) {
      return abut_geometry_create(universe, part, shape, &its, out);
    }));
  }

  void edit_once() {
    const std::size_t part = choose(parts_.size()), geometry = choose(geometries_.size());
    const abut_part_id its_part = parts_[part];
    const abut_geometry_id its = geometries_[geometry];
    switch (choose(14)) {
      case 0: add(); break;
      case 1:
        both([&](abut_universe* universe) { return abut_geometry_destroy(universe, its); });
        geometries_.erase(geometries_.begin() + static_cast<std::ptrdiff_t>(geometry));
        break;
      case 2: both([&](abut_universe* universe) { return abut_geometry_park(universe, its, geometry % 3); }); break;
      case 3: {
        const abut_shape* shape = shapes_[choose(shapes_.size())];
        both([&](abut_universe* universe) { return abut_geometry_set_shape(universe, its, shape); });
        break;
      }
      case 4: {
        const abut_geometry_options wanted = options();
        both([&](abut_universe* universe) { return abut_geometry_set_options(universe, its, &wanted); });
        break;
      }
      case 5: {
        const abut_collidable a{ABUT_COLLIDABLE_GEOMETRY, its.slot, its.generation}, b{ABUT_COLLIDABLE_LABEL, 1, 0};
        const abut_rule rule = choose(3);
        both([&](abut_universe* universe) { return abut_rule_set(universe, &a, &b, rule); });
        break;
      }
      case 6: {
        abut_policy policy = default_policy();
        policy.period = 1 + choose(3);
        policy.detail = choose(3);
        const std::uint32_t tag = choose(3);
        both([&](abut_universe* universe) { return abut_policy_set(universe, tag, 1, &policy); });
        break;
      }
      case 7: {
        const abut_motion motion = choose(3);
        both([&](abut_universe* universe) { return abut_part_set_motion(universe, its_part, motion); });
        break;
      }
      case 8: {
        const abut_focus focus = make_focus(1, 2, 2, 3);
        const abut_vec3 centre{real(3), 0, 0};
        both([&](abut_universe* universe) { return abut_universe_set_focus(universe, &focus, &centre, 1); });
        break;
      }
      case 9: {
        const std::vector<abut_contact> contacts = copy_of(abut_universe_contacts, first());
        std::vector<std::uint64_t> values(contacts.size());
        for (std::uint64_t& value : values) value = random_();
        both([&](abut_universe* universe) {
          return abut_contacts_set_user_data(universe, values.data(), values.size());
        });
        break;
      }
      default: {
        const abut_pose wanted = pose();
        both([&](abut_universe* universe) { return abut_part_set_pose(universe, its_part, &wanted); });
      }
    }
  }

  std::mt19937 random_;
  std::vector<Shape> shapes_ = all_shapes();
  std::vector<Owned> universes_;
  std::vector<abut_part_id> parts_;
  std::vector<abut_geometry_id> geometries_;
};

TEST(Archive, GoesOnAsTheUniverseThatWasSaved) {
  std::uint32_t seed = 1;
  for (const abut_broadphase broadphase : broadphases) {
    for (int round = 0; round < 4; ++round, ++seed) {
      Twins twins(seed, broadphase);
      for (int i = 0; i < 3; ++i) {
        twins.edit();
        twins.step();
      }
      if (round % 2 == 1) twins.edit();  // what no step has seen
      if (round == 3) twins.refresh();
      twins.save_and_load();
      twins.expect_equal("seed " + std::to_string(seed) + ", at once");
      for (int i = 0; i < 8; ++i) {
        twins.step();
        twins.expect_equal("seed " + std::to_string(seed) + ", step " + std::to_string(i));
        if (i >= 3) twins.edit();
      }
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(Archive, AnEmptyUniverseIsOne) {
  const Universe universe;
  const Owned again = loaded(saved(universe));
  std::size_t count = 7;
  ASSERT_TRUE(succeeded(abut_universe_parts(again.get(), nullptr, 0, &count)));
  EXPECT_EQ(count, 0U);
}

TEST(Archive, SharedShapesAreShared) {
  Universe universe;
  const Shape ball = make_sphere(1), other = make_sphere(1);
  const abut_geometry_id a = universe.add(ball, identity), b = universe.add(ball, identity),
                         c = universe.add(other, identity);
  const Owned again = loaded(saved(universe));
  std::array<abut_shape*, 3> shapes{};
  for (std::size_t i = 0; const abut_geometry_id id : {a, b, c}) {
    abut_geometry_info info;
    abut_geometry_info_init(&info, sizeof info);
    ASSERT_TRUE(succeeded(abut_geometry_describe(again.get(), id, &info)));
    shapes.at(i++) = info.shape;
  }
  EXPECT_EQ(shapes[0], shapes[1]);
  EXPECT_NE(shapes[0], shapes[2]);
}

// The list of policies drops those that nobody uses, at once; pairs follow in the next step.
TEST(Archive, APolicyMayHaveGoneSinceTheLastStep) {
  Universe universe;
  const Shape ball = make_sphere(1);
  universe.add(ball, identity);
  universe.add(ball, at(1, 0, 0));
  abut_policy policy;
  abut_policy_init(&policy, sizeof policy);
  policy.tolerance = 0.5;
  ASSERT_TRUE(succeeded(abut_policy_set(universe, 0, 0, &policy)));
  EXPECT_EQ(universe.step().size(), 1U);
  ASSERT_TRUE(succeeded(abut_policy_set(universe, 0, 0, nullptr)));
  const Owned again = loaded(saved(universe));
  ASSERT_TRUE(succeeded(abut_universe_step(again.get(), 0)));
  EXPECT_EQ(copy_of(abut_universe_contacts, again.get()).size(), 1U);
}

std::uint32_t no(void*, const abut_universe*, abut_geometry_id, abut_geometry_id) { return 0; }

// Answers of the filter are kept, the filter is not.
TEST(Archive, AFilterHasToBeSetAgain) {
  Universe universe;
  const Shape ball = make_sphere(1);
  universe.add(ball, identity);
  const abut_geometry_id other = universe.add(ball, at(1, 0, 0));
  ASSERT_TRUE(succeeded(abut_universe_set_filter(universe, no, nullptr)));
  EXPECT_TRUE(universe.step().empty());
  const Owned again = loaded(saved(universe));
  ASSERT_TRUE(succeeded(abut_universe_step(again.get(), 0)));
  EXPECT_TRUE(copy_of(abut_universe_contacts, again.get()).empty());
  const abut_geometry_options options = default_geometry_options();
  ASSERT_TRUE(succeeded(abut_geometry_set_options(again.get(), other, &options)));
  ASSERT_TRUE(succeeded(abut_universe_step(again.get(), 0)));
  EXPECT_EQ(copy_of(abut_universe_contacts, again.get()).size(), 1U) << "nobody says no any more";
}

}  // namespace
