// SPDX-License-Identifier: Apache-2.0
// Universes: a life of one, batches, rules and filters, and what a detection leaves.
#include <abut/abut.hpp>
#include <gtest/gtest.h>

#include <memory_resource>
#include <stdexcept>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace {

// A box on the ground that a ball overlaps by a quarter.
struct Room {
  explicit Room(const abut::UniverseOptions& options = {}) : universe(options) {
    floor = universe.create_part(abut::PartOptions().with_motion(ABUT_MOTION_STATIC).with_user_data(5));
    body = universe.create_part(abut::PartOptions().with_pose(abut::pose({0, 0, 1.75})));
    box = universe.create_geometry(floor, abut::Shape::box(1, 1, 1));
    ball = universe.create_geometry(body, abut::Shape::sphere(1), abut::GeometryOptions().with_layers(2).with_tag(3));
  }

  abut::Universe universe;
  abut::PartId floor{}, body{};
  abut::GeometryId box{}, ball{};
};

TEST(Universe, FindsContactsInAStep) {
  Room room;
  room.universe.step(0.01);
  const abut::Span<const abut::Contact> contacts = room.universe.contacts();
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].distance, -0.25);
  EXPECT_EQ(contacts[0].geometry_a, room.box);
  EXPECT_EQ(room.universe.events().size(), 1U);
  EXPECT_EQ(room.universe.stats().contacts, 1U);
  EXPECT_NE(room.universe.hash(), 0U);
  EXPECT_NE(room.universe.explain().find("sphere"), std::string::npos);
  EXPECT_EQ(room.universe.explain_json().front(), '{');
  EXPECT_EQ(room.universe.explain_json().back(), '\n');
}

TEST(Universe, MovesAndEnds) {
  Room room;
  abut::Universe moved = std::move(room.universe);
  EXPECT_FALSE(room.universe);
  EXPECT_THROW(room.universe.step(0), abut::Error);
  moved.step(0);
  moved = abut::Universe(abut::UniverseOptions().with_max_contacts(2).with_broadphase(ABUT_BROADPHASE_BRUTE));
  EXPECT_TRUE(moved.parts().empty());
  EXPECT_THROW(static_cast<void>(moved.pose(room.body)), abut::Error);
  const abut::Universe adopted = abut::Universe::adopt(moved.release());
  EXPECT_TRUE(adopted.geometries().empty());
}

TEST(Universe, RefusesOptionsByTheirName) {
  try {
    const abut::Universe universe(abut::UniverseOptions().with_threads(5000));
    ADD_FAILURE();
  } catch (const abut::Error& error) {
    EXPECT_NE(std::string(error.what()).find("options.threads is 5000"), std::string::npos) << error.what();
  }
}

TEST(Parts, AreCreatedMovedAndDestroyedInBatches) {
  abut::Universe universe;
  const std::vector<abut::PartOptions> options(30, abut::PartOptions().with_user_data(9));
  const std::vector<abut::PartId> parts = universe.create_parts(options);
  const std::vector<abut::Shape> shapes(30, abut::Shape::sphere(0.5));
  const std::vector<abut::GeometryOptions> labelled(30, abut::GeometryOptions().with_label(4));
  const std::vector<abut::GeometryId> geometries = universe.create_geometries(parts, shapes, labelled);
  EXPECT_EQ(universe.create_geometries(parts, shapes).size(), 30U);
  EXPECT_EQ(universe.parts(), parts);
  EXPECT_EQ(universe.geometries().size(), 60U);
  EXPECT_EQ(universe.geometries(parts[7])[0], geometries[7]);
  EXPECT_EQ(universe.user_data(parts[29]), 9U);
  EXPECT_EQ(universe.describe(geometries[29]).label, 4U);

  std::vector<abut::Pose> poses;
  for (int i = 0; i < 30; ++i) poses.push_back(abut::pose({2.0 * i, 0, 0}));
  universe.set_poses(parts, poses);
  EXPECT_EQ(universe.poses(parts)[29].position.x, 58);
  universe.refresh();
  EXPECT_EQ(universe.poses(geometries)[28].position.x, 56);
  std::vector<abut::Pose> out(30);
  universe.poses(parts, out);
  EXPECT_EQ(out[1].position.x, 2);
  universe.poses(geometries, out);
  EXPECT_THROW(universe.set_poses(parts, {abut::pose()}), abut::Error);
  EXPECT_THROW(universe.create_geometries(parts, {abut::Shape::point()}), abut::Error);

  universe.set_motions({parts[0], parts[1]}, {ABUT_MOTION_STATIC, ABUT_MOTION_ANIMATED});
  EXPECT_EQ(universe.motion(parts[1]), ABUT_MOTION_ANIMATED);
  universe.set_motion(parts[1], ABUT_MOTION_DYNAMIC);
  universe.set_pose(parts[1], abut::pose({0, 0, 7}));
  EXPECT_EQ(universe.pose(parts[1]).position.z, 7);
  universe.destroy(geometries[0]);
  universe.destroy({geometries[1], geometries[2]});
  universe.destroy(parts[0]);
  universe.destroy(abut::Span<const abut::PartId>(parts).size() > 2 ? std::vector<abut::PartId>{parts[1], parts[2]}
                                                                    : parts);
  EXPECT_EQ(universe.parts().size(), 27U);
  EXPECT_THROW(static_cast<void>(universe.pose(parts[2])), abut::Error);
}

TEST(Log, HearsWhatIsRefused) {
  std::string heard;
  abut::set_log(
      [](void* context, abut_log_level, const char* message) { *static_cast<std::string*>(context) = message; },
      &heard);
  EXPECT_THROW(static_cast<void>(abut::Shape::sphere(-1)), abut::Error);
  abut::set_log(nullptr);
  EXPECT_NE(heard.find("radius is -1"), std::string::npos) << heard;
}

TEST(Memory, ComesFromTheHost) {
  static int given, taken;
  given = taken = 0;
  const auto give = [](void*, std::size_t size, std::size_t alignment) {
    return ++given, std::pmr::new_delete_resource()->allocate(size, alignment);
  };
  const auto take = [](void*, void* memory, std::size_t size, std::size_t alignment) {
    ++taken, std::pmr::new_delete_resource()->deallocate(memory, size, alignment);
  };
  abut::set_allocator(give, take);
  {
    const abut::Shape ball = abut::Shape::sphere(1);
    EXPECT_GT(abut::memory_in_use().bytes, 0U);
    EXPECT_EQ(abut::memory_in_use().blocks, static_cast<std::uint64_t>(given - taken));
    EXPECT_THROW(abut::set_allocator(nullptr, nullptr), abut::Error);
    abut::release_memory(abut::allocate_memory(100), 100);
  }
  EXPECT_GT(given, 1);
  EXPECT_EQ(given, taken);
  abut::set_allocator(nullptr, nullptr);
}

TEST(Parts, KeepValuesOfTheCaller) {
  Room room;
  room.universe.set_user_data(room.body, 7);
  EXPECT_EQ(room.universe.user_data(room.body), 7U);
  room.universe.set_user_data({room.body, room.floor}, {8, 9});
  EXPECT_EQ(room.universe.user_data(room.floor), 9U);
  const std::vector<abut::GeometryId> geometries = room.universe.geometries();
  room.universe.set_user_data(geometries[0], 10);
  EXPECT_EQ(room.universe.describe(geometries[0]).user_data, 10U);
  room.universe.set_user_data(geometries, std::vector<std::uint64_t>(geometries.size(), 11));
  EXPECT_EQ(room.universe.describe(geometries[1]).user_data, 11U);
  EXPECT_THROW(room.universe.set_user_data(geometries, {1}), abut::Error);
}

TEST(Universe, IsSavedAndLoaded) {
  Room room;
  room.universe.step(0.01);
  const std::vector<std::uint8_t> bytes = room.universe.save();
  abut::Universe loaded = abut::Universe::load(bytes);
  EXPECT_EQ(loaded.parts(), room.universe.parts());
  EXPECT_EQ(loaded.pose(room.body).position.z, room.universe.pose(room.body).position.z);
  EXPECT_EQ(loaded.save(), bytes);
  EXPECT_THROW(static_cast<void>(abut::Universe::load({bytes.data(), bytes.size() - 1})), abut::Error);
}

TEST(Parts, HaveVelocitiesAndSleep) {
  Room room;
  room.universe.set_velocity(room.body, abut::Velocity{{1, 2, 3}, {0, 0, 0}});
  const auto [velocity, source] = room.universe.velocity(room.body);
  EXPECT_EQ(velocity.linear.y, 2);
  EXPECT_EQ(source, ABUT_VELOCITY_GIVEN);
  room.universe.set_velocity(room.body, std::nullopt);
  EXPECT_EQ(room.universe.velocity(room.body).source, ABUT_VELOCITY_NONE);
  room.universe.set_velocities({room.body}, {abut::Velocity{{4, 0, 0}, {}}});
  EXPECT_EQ(room.universe.velocities({room.body, room.floor})[0].linear.x, 4);
  room.universe.measure_velocities({room.body});
  room.universe.measure_velocity(room.floor);
  EXPECT_EQ(room.universe.velocity(room.floor).source, ABUT_VELOCITY_FROM_POSES);

  room.universe.set_sleep(room.body, abut::Sleep().with_steps(1));
  for (int i = 0; i < 9; ++i) room.universe.step(0.01);
  EXPECT_TRUE(room.universe.is_asleep(room.body));
  room.universe.wake(room.body);
  room.universe.wake(std::vector<abut::PartId>{room.body});
  room.universe.step(0.01);
  ASSERT_EQ(room.universe.sleep_changes().size(), 1U);
  EXPECT_EQ(room.universe.sleep_changes()[0].part, room.body);
  room.universe.set_sleep({room.body}, {abut::Sleep().with_steps(2)});
  room.universe.set_sleep({room.body}, abut::Span<const abut_sleep>());
  room.universe.set_sleep(room.body, std::nullopt);
}

TEST(Geometries, Change) {
  Room room;
  room.universe.set_options(room.ball, room.universe.options_of(room.ball).with_tolerance(0.5));
  EXPECT_EQ(room.universe.describe(room.ball).tolerance, 0.5);
  EXPECT_EQ(room.universe.describe(room.ball).layers, 2U);
  EXPECT_EQ(room.universe.describe(room.ball).tag, 3U);
  room.universe.set_options({room.ball, room.box},
                            std::vector<abut::GeometryOptions>(2, abut::GeometryOptions().with_label(8)));
  EXPECT_EQ(room.universe.describe(room.box).label, 8U);
  room.universe.set_options(room.box, {});
  EXPECT_EQ(room.universe.describe(room.box).label, 0U);
  room.universe.set_parameters(room.ball, {2.0});
  EXPECT_EQ(room.universe.shape(room.ball).parameters(), std::vector<double>{2});
  room.universe.set_shape(room.box, abut::Shape::sphere(1));
  room.universe.set_parameters({room.ball, room.box}, {3.0, 4.0});
  EXPECT_EQ(room.universe.shape(room.box).parameters(), std::vector<double>{4});
  EXPECT_THROW(room.universe.set_parameters({room.ball, room.box}, {3.0, 4.0, 5.0}), abut::Error);

  room.universe.set_shapes({room.ball, room.box}, {abut::Shape::height_field(2, 2, 1, 1, {0, 0, 0, 0}),
                                                   abut::Shape::particles({{0, 0, 0}, {1, 0, 0}}, 0.5)});
  room.universe.set_heights(room.ball, 1, 1, 1, 1, {6});
  EXPECT_EQ(room.universe.shape(room.ball).aabb(abut::pose()).maximum.z, 6);
  EXPECT_THROW(room.universe.set_heights(room.ball, 1, 1, 1, 1, {6, 7}), abut::Error);
  room.universe.set_particles(room.box, 1, {{9, 0, 0}});
  EXPECT_EQ(room.universe.shape(room.box).aabb(abut::pose()).maximum.x, 9.5);
  room.universe.set_shape(room.ball,
                          abut::Shape::mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{{0, 1, 2}}, {{0, 2, 3}}}));
  room.universe.set_vertices(room.ball, 3, {{0, 1, 7}});
  EXPECT_EQ(room.universe.shape(room.ball).aabb(abut::pose()).maximum.z, 7);
  room.universe.set_vertices(room.ball, {0, 3}, {{0, 0, 5}, {0, 1, 0}});
  EXPECT_EQ(room.universe.shape(room.ball).aabb(abut::pose()).maximum.z, 5);
  EXPECT_THROW(room.universe.set_vertices(room.ball, {0, 3}, {{0, 0, 5}}), abut::Error);
  room.universe.remove_triangles(room.ball, {1});
  EXPECT_EQ(room.universe.shape(room.ball).aabb(abut::pose()).maximum.z, 5);
  room.universe.set_mesh(room.ball, {{0, 0, 0}, {1, 0, 0}, {1, 1, 4}}, {{{0, 1, 2}}});
  EXPECT_EQ(room.universe.shape(room.ball).aabb(abut::pose()).maximum.z, 4);
  room.universe.park(room.ball, ABUT_PARKING_LONG_TERM);
  room.universe.park({room.box}, ABUT_PARKING_SHORT_TERM);
  EXPECT_EQ(room.universe.describe(room.ball).parking, ABUT_PARKING_LONG_TERM);
  EXPECT_EQ(room.universe.revision().geometries, *room.universe.counters().geometries);
  EXPECT_TRUE(room.universe.changes(room.universe.revision())->empty());
  EXPECT_FALSE(room.universe.changes(abut::Revision{})->empty());
}

TEST(Rules, DecideWhoMeetsWhom) {
  Room room;
  room.universe.set_rule(abut::anything(), abut::anything(), ABUT_RULE_DISABLE);
  room.universe.step(0);
  EXPECT_TRUE(room.universe.contacts().empty());
  room.universe.set_rule(abut::collidable(room.ball), abut::all_with_label(0), ABUT_RULE_ENABLE);
  room.universe.step(0);
  EXPECT_EQ(room.universe.contacts().size(), 1U);
  const abut::Contact contact = room.universe.contacts()[0];
  EXPECT_EQ(room.universe.why_apart(contact.geometry_a, contact.geometry_b), 0U);
  EXPECT_EQ(room.universe.rule_between(contact.geometry_a, contact.geometry_b).rule, ABUT_RULE_ENABLE);
  room.universe.clear_rules();
  room.universe.set_rule(abut::collidable(room.body), abut::collidable(room.floor), ABUT_RULE_DISABLE);
  room.universe.step(0);
  EXPECT_TRUE(room.universe.contacts().empty());
  EXPECT_EQ(room.universe.why_apart(contact.geometry_a, contact.geometry_b), abut_apart_reasons{ABUT_APART_RULE});
  EXPECT_EQ(room.universe.rule_between(contact.geometry_a, contact.geometry_b).a.kind,
            abut_collidable_kind{ABUT_COLLIDABLE_PART});
}

TEST(Filter, DecidesAboutPairs) {
  Room room;
  std::vector<std::pair<abut::GeometryId, abut::GeometryId>> asked;
  bool is_admitted = false;
  room.universe.set_filter([&](abut::GeometryId a, abut::GeometryId b) {
    asked.emplace_back(a, b);
    return is_admitted;
  });
  room.universe.step(0);
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_EQ(asked[0].first, room.box);
  EXPECT_TRUE(room.universe.contacts().empty());

  abut::Universe moved = std::move(room.universe);
  is_admitted = true;
  moved.refilter();
  moved.step(0);
  EXPECT_EQ(moved.contacts().size(), 1U);
  moved.set_filter(nullptr);
  moved.refilter();
  moved.step(0);
  EXPECT_EQ(asked.size(), 2U);
}

TEST(Backend, AnswersPairs) {
  Room room;
  std::size_t asked = 0;
  const auto ball = abut::shape_kind("sphere");
  const auto find = [&](abut::Span<const abut::BackendPair> pairs) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      EXPECT_EQ(pairs[i].geometry_a, room.box);
      abut::BackendContact contact{};
      contact.point_b.z = -0.125;
      contact.normal.z = 1;
      room.universe.answer_pair(i, {contact});
      ++asked;
    }
  };
  room.universe.set_backend(find, [&](abut::ShapeKind a, abut::ShapeKind b) { return a == ball || b == ball; });
  room.universe.step(0);
  EXPECT_EQ(asked, 1U);
  ASSERT_EQ(room.universe.contacts().size(), 1U);
  EXPECT_EQ(room.universe.contacts()[0].distance, -0.125);
  room.universe.set_backend(nullptr);
  room.universe.step(0);
  EXPECT_EQ(asked, 1U);
  EXPECT_NE(room.universe.contacts()[0].distance, -0.125);
}

// The step has contacts of abut then, and the next one asks again.
TEST(Backend, MayThrow) {
  Room room;
  int calls = 0;
  room.universe.set_backend([&](abut::Span<const abut::BackendPair>) {
    if (++calls == 1) throw std::runtime_error("not yet");
  });
  try {
    room.universe.step(0);
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "not yet");
  }
  EXPECT_EQ(room.universe.contacts().size(), 1U);
  room.universe.step(0);
  EXPECT_EQ(calls, 2);
}

TEST(Filter, IsNotReplacedWhileItRuns) {
  Room room;
  abut::Status status = ABUT_OK;
  int calls = 0;
  room.universe.set_filter([&](abut::GeometryId, abut::GeometryId) {
    try {
      room.universe.set_filter(nullptr);
    } catch (const abut::Error& error) {
      status = error.status();
    }
    ++calls;
    return true;
  });
  room.universe.step(0);
  room.universe.refilter();
  room.universe.step(0);
  EXPECT_EQ(status, ABUT_BUSY);
  EXPECT_EQ(calls, 2);
}

TEST(Filter, MayThrow) {
  Room room;
  bool throws = true;
  int calls = 0;
  room.universe.create_geometry(room.body, abut::Shape::sphere(0.9));
  room.universe.set_filter([&](abut::GeometryId, abut::GeometryId) {
    ++calls;
    if (throws) throw std::runtime_error("not yet");
    return true;
  });
  try {
    room.universe.step(0);
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "not yet");
  }
  EXPECT_EQ(calls, 1);
  EXPECT_TRUE(room.universe.contacts().empty());
  EXPECT_THROW(room.universe.detect_changed(), std::runtime_error);
  throws = false;
  room.universe.step(0);
  EXPECT_EQ(calls, 4);
  EXPECT_EQ(room.universe.contacts().size(), 2U);
}

TEST(Policies, BelongToTags) {
  Room room;
  room.universe.set_policy(0, 3, abut::Policy().with_detail(ABUT_DETAIL_BOX).with_period(7));
  EXPECT_EQ(room.universe.policy(3, 0).period, 7U);
  room.universe.step(0);
  EXPECT_TRUE(room.universe.contacts().empty());
  EXPECT_EQ(room.universe.events().size(), 1U);
  room.universe.set_policy(0, 3, std::nullopt);
  EXPECT_EQ(room.universe.policy(3, 0).period, 1U);

  room.universe.set_focus(abut::Focus().with_near(3, 5).with_far(4, 10), {{100, 0, 0}});
  room.universe.step(0);
  EXPECT_EQ(room.universe.describe(room.ball).tag, 4U);
  room.universe.set_focus(std::nullopt);

  room.universe.set_material_pair(0, 1, abut::ContactMaterial().with_friction(0.5, 0.25).with_slip(2));
  EXPECT_EQ(room.universe.material_pair(1, 0).friction_secondary, 0.25);
  room.universe.set_material_pair(0, 1, std::nullopt);
  EXPECT_EQ(room.universe.material_pair(1, 0).slip, 0);
}

TEST(Detections, LeaveWhatTheyFound) {
  Room room(abut::UniverseOptions().with_flags(ABUT_UNIVERSE_LOCAL_POINTS).with_events(ABUT_EVENTS_CONTACTS));
  room.universe.follow_islands(true);
  room.universe.detect_pairs({room.ball}, {room.box});
  ASSERT_EQ(room.universe.local_points().size(), 1U);
  EXPECT_EQ(room.universe.local_points()[0].a.z, 1);
  ASSERT_EQ(room.universe.islands().size(), 1U);
  EXPECT_EQ(room.universe.island_parts()[0], room.body);
  EXPECT_EQ(room.universe.island(room.body).id, room.universe.islands()[0].id);
  room.universe.set_contact_user_data({77});
  room.universe.detect_all();
  EXPECT_EQ(room.universe.contacts()[0].user_data, 77U);
  room.universe.detect_changed();
  room.universe.detect_region({{-9, -9, -9}, {9, 9, 9}});
  EXPECT_THROW(room.universe.detect_pairs({room.ball}, {}), abut::Error);
  EXPECT_THROW(room.universe.set_contact_user_data({1, 2}), abut::Error);
  EXPECT_TRUE(room.universe.validate().empty());
  room.universe.set_motion(room.body, ABUT_MOTION_STATIC);
  ASSERT_FALSE(room.universe.validate().empty());
  EXPECT_EQ(room.universe.validate()[0].code, ABUT_FINDING_NOTHING_MOVES);
  room.universe.attach("test");
  room.universe.detach("test");
  EXPECT_THROW(room.universe.detach("test"), abut::Error);
}

template <class Object, class = void>
constexpr bool lends_contacts = false;
template <class Object>
constexpr bool lends_contacts<Object, std::void_t<decltype(std::declval<Object>().contacts())>> = true;

TEST(Mistakes, DoNotCompile) {
  using abut::Universe;
  static_assert(!std::is_copy_constructible_v<Universe> && std::is_nothrow_move_constructible_v<Universe>);
  static_assert(lends_contacts<Universe&> && !lends_contacts<Universe>, "of a temporary nothing is borrowed");
  static_assert(std::is_invocable_v<decltype(&Universe::is_asleep), Universe&, abut::PartId>);
  static_assert(!std::is_invocable_v<decltype(&Universe::is_asleep), Universe&, abut::GeometryId>);
  static_assert(std::is_invocable_v<decltype(&Universe::set_motion), Universe&, abut::PartId, abut::Motion>);
  static_assert(!std::is_invocable_v<decltype(&Universe::set_motion), Universe&, abut::PartId, abut::Rule>);
  static_assert(!std::is_convertible_v<std::vector<abut::PartId>, abut::Span<const abut::GeometryId>>);
  static_assert(!std::is_convertible_v<const std::vector<double>&, abut::Span<double>>);
}

TEST(Ids, AreKeysOfTables) {
  Room room;
  std::unordered_map<abut::GeometryId, std::string> names{{room.box, "box"}, {room.ball, "ball"}};
  EXPECT_EQ(names.at(room.ball), "ball");
  EXPECT_TRUE(abut::is_null(abut::PartId{}));
  EXPECT_FALSE(abut::is_null(room.ball));
  EXPECT_TRUE(room.floor < room.body && room.floor != room.body);
}

}  // namespace
