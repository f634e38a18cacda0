// SPDX-License-Identifier: Apache-2.0
// Bad input of bodies and steps: a status, and a message with name and value. Nothing changes.
#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>

#include "scene.hpp"

namespace {

using namespace response_test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

void expect_refused(abut_status status, abut_status expected, std::initializer_list<std::string_view> words) {
  const std::string message = abut_last_error_message();
  EXPECT_STREQ(abut_status_name(status), abut_status_name(expected)) << message;
  for (const std::string_view word : words) {
    EXPECT_NE(message.find(word), std::string::npos) << message << " has no " << word;
  }
}

TEST(BodyInput, RefusesNullPointers) {
  Scene scene;
  const abut_part_id part = scene.body(ball(1), {{0, 0, 0}, no_turn}, 1);
  const Shape shape = ball(1);
  abut_response* response = nullptr;
  abut_mass_properties mass{};
  abut_energy energy{};
  const abut_vec3 force{};
  const abut_response_contact* contacts = nullptr;
  const abut_response_island* islands = nullptr;
  std::size_t count = 0;
  const auto refused = [](abut_status status, std::string_view name) {
    expect_refused(status, ABUT_NULL_ARGUMENT, {name, "null"});
  };
  refused(abut_response_create(nullptr, nullptr, &response), "universe");
  refused(abut_response_create(scene.universe(), nullptr, nullptr), "out");
  refused(abut_response_set_options(nullptr, nullptr), "response");
  refused(abut_response_set_options(scene.response(), nullptr), "options");
  refused(abut_response_add_bodies(nullptr, &part, 1, nullptr), "response");
  refused(abut_response_add_bodies(scene.response(), nullptr, 1, nullptr), "parts");
  refused(abut_response_remove_body(nullptr, part), "response");
  refused(abut_response_body(nullptr, part, &mass), "response");
  refused(abut_response_body(scene.response(), part, nullptr), "out");
  refused(abut_response_apply_force(nullptr, part, &force, nullptr), "response");
  refused(abut_response_apply_force(scene.response(), part, nullptr, nullptr), "force");
  refused(abut_response_apply_torque(nullptr, part, &force), "response");
  refused(abut_response_apply_torque(scene.response(), part, nullptr), "torque");
  refused(abut_response_set_contact_callback(nullptr, nullptr, nullptr), "response");
  refused(abut_response_step(nullptr, 1), "response");
  refused(abut_response_contacts(nullptr, &contacts, &count), "response");
  refused(abut_response_contacts(scene.response(), nullptr, &count), "contacts");
  refused(abut_response_contacts(scene.response(), &contacts, nullptr), "count");
  refused(abut_response_islands(nullptr, &islands, &count), "response");
  refused(abut_response_islands(scene.response(), nullptr, &count), "islands");
  refused(abut_response_islands(scene.response(), &islands, nullptr), "count");
  refused(abut_response_energy(nullptr, &energy), "response");
  refused(abut_response_energy(scene.response(), nullptr), "out");
  refused(abut_shape_mass_properties(nullptr, 1, &mass), "shape");
  refused(abut_shape_mass_properties(shape.get(), 1, nullptr), "out");
  abut_response_destroy(nullptr);
  abut_response_options_init(nullptr, sizeof(abut_response_options));
  abut_body_options_init(nullptr, sizeof(abut_body_options));
}

TEST(BodyInput, RefusesOptionsByNameAndValue) {
  const Scene scene;
  const auto refused = [&](const std::function<void(abut_response_options&)>& spoil, abut_status status,
                           std::initializer_list<std::string_view> words) {
    abut_response_options options;
    abut_response_options_init(&options, sizeof options);
    spoil(options);
    expect_refused(abut_response_set_options(scene.response(), &options), status, words);
    abut_response* response = nullptr;
    expect_refused(abut_response_create(scene.universe(), &options, &response), status, words);
    EXPECT_EQ(response, nullptr);
  };
  using Options = abut_response_options;
  refused([](Options& its) { its.struct_size = 3; }, ABUT_WRONG_STRUCT_SIZE, {"options.struct_size", "3"});
  refused([](Options& its) { its.most_rounds = 0; }, ABUT_OUT_OF_RANGE, {"options.most_rounds", "0"});
  refused([](Options& its) { its.solver = 2; }, ABUT_UNKNOWN_VALUE, {"options.solver", "2"});
  refused([](Options& its) { its.threads = 0; }, ABUT_OUT_OF_RANGE, {"options.threads", "0"});
  refused([](Options& its) { its.threads = 257; }, ABUT_OUT_OF_RANGE, {"options.threads", "257"});
  refused([](Options& its) { its.flags = 2; }, ABUT_UNKNOWN_VALUE, {"options.flags", "2"});
  refused([](Options& its) { its.reserved = 2; }, ABUT_INVALID_ARGUMENT, {"options.reserved", "2"});
  refused([](Options& its) { its.gravity.y = nan; }, ABUT_NOT_FINITE, {"options.gravity.y"});
  refused([](Options& its) { its.gravity.z = -1e31; }, ABUT_OUT_OF_RANGE, {"options.gravity.z"});
  refused([](Options& its) { its.tolerance = -1; }, ABUT_OUT_OF_RANGE, {"options.tolerance", "-1"});
  refused([](Options& its) { its.slop = infinity; }, ABUT_NOT_FINITE, {"options.slop"});
  refused([](Options& its) { its.slop = -2; }, ABUT_OUT_OF_RANGE, {"options.slop", "-2"});
}

TEST(BodyInput, RefusesMassesByNameAndValue) {
  Scene scene;
  const abut_part_id part = scene.place(ball(1), {{0, 0, 0}, no_turn}, ABUT_MOTION_DYNAMIC);
  const auto refused = [&](const std::function<void(abut_body_options&)>& spoil, abut_status status,
                           std::initializer_list<std::string_view> words) {
    abut_body_options options;
    abut_body_options_init(&options, sizeof options);
    options.mass = {.mass = 1, .centre = {}, .inertia = {1, 0, 0, 0, 1, 0, 0, 0, 1}};
    spoil(options);
    expect_refused(abut_response_add_bodies(scene.response(), &part, 1, &options), status, words);
    abut_mass_properties mass{};
    EXPECT_EQ(abut_response_body(scene.response(), part, &mass), ABUT_STALE_ID);
  };
  using Options = abut_body_options;
  refused([](Options& its) { its.struct_size = 9; }, ABUT_WRONG_STRUCT_SIZE, {"options.struct_size", "9"});
  refused([](Options& its) { its.integrator = 5; }, ABUT_UNKNOWN_VALUE, {"options.integrator", "5"});
  refused([](Options& its) { its.mass.mass = -1; }, ABUT_OUT_OF_RANGE, {"options.mass.mass", "-1"});
  refused([](Options& its) { its.mass.mass = nan; }, ABUT_NOT_FINITE, {"options.mass.mass"});
  refused([](Options& its) { its.mass.centre.x = infinity; }, ABUT_NOT_FINITE, {"options.mass.centre.x"});
  refused([](Options& its) { its.mass.inertia[1] = 0.5; }, ABUT_INVALID_ARGUMENT, {"options.mass.inertia[1]", "0.5"});
  refused([](Options& its) { its.mass.inertia[8] = 0; }, ABUT_OUT_OF_RANGE, {"options.mass.inertia[8]", "positive"});
  const auto by_density = [](double density) {
    return [density](Options& its) {
      its.mass.mass = 0;
      its.density = density;
    };
  };
  refused(by_density(0), ABUT_OUT_OF_RANGE, {"options.density", "0"});
  refused(by_density(nan), ABUT_NOT_FINITE, {"options.density"});
}

// All of a batch, or none.
TEST(BodyInput, RefusesPartsThatAreNoBodies) {
  Scene scene;
  const Shape shape = ball(1);
  const abut_part_id good = scene.place(shape, {{0, 0, 0}, no_turn}, ABUT_MOTION_DYNAMIC);
  const abut_part_id still = scene.place(shape, {{5, 0, 0}, no_turn}, ABUT_MOTION_STATIC);
  const abut_part_id flat = scene.place(ground(), {{9, 0, 0}, no_turn}, ABUT_MOTION_DYNAMIC);
  abut_part_id empty{};
  require(abut_part_create(scene.universe(), nullptr, &empty));
  const auto refused = [&](abut_part_id bad, abut_status status, std::initializer_list<std::string_view> words) {
    const abut_part_id parts[] = {good, bad};
    expect_refused(abut_response_add_bodies(scene.response(), parts, 2, nullptr), status, words);
    abut_mass_properties mass{};
    EXPECT_EQ(abut_response_body(scene.response(), good, &mass), ABUT_STALE_ID);
  };
  refused({}, ABUT_STALE_ID, {});
  refused(still, ABUT_INVALID_ARGUMENT, {"motion", "dynamic"});
  refused(flat, ABUT_UNSUPPORTED, {"plane"});
  refused(empty, ABUT_EMPTY, {"part.slot", "geometries"});
  abut_mass_properties mass{};
  const abut_vec3 force{1, 0, 0};
  expect_refused(abut_response_body(scene.response(), good, &mass), ABUT_STALE_ID, {"part.slot", "no body"});
  expect_refused(abut_response_remove_body(scene.response(), good), ABUT_STALE_ID, {"part.slot", "no body"});
  expect_refused(abut_response_apply_force(scene.response(), good, &force, nullptr), ABUT_STALE_ID, {"no body"});
  expect_refused(abut_response_apply_torque(scene.response(), good, &force), ABUT_STALE_ID, {"no body"});
}

TEST(BodyInput, RefusesForcesAndTimesByNameAndValue) {
  Scene scene;
  const abut_part_id part = scene.body(ball(1), {{0, 0, 0}, no_turn}, 1);
  const abut_vec3 bad{0, nan, 0}, huge{0, 0, 1e31}, good{0, 0, 1};
  expect_refused(abut_response_apply_force(scene.response(), part, &bad, nullptr), ABUT_NOT_FINITE, {"force.y"});
  expect_refused(abut_response_apply_force(scene.response(), part, &huge, nullptr), ABUT_OUT_OF_RANGE, {"force.z"});
  expect_refused(abut_response_apply_force(scene.response(), part, &good, &bad), ABUT_NOT_FINITE, {"at.y"});
  expect_refused(abut_response_apply_torque(scene.response(), part, &huge), ABUT_OUT_OF_RANGE, {"torque.z", "e+30"});
  expect_refused(abut_response_step(scene.response(), 0), ABUT_OUT_OF_RANGE, {"dt", "0"});
  expect_refused(abut_response_step(scene.response(), -1), ABUT_OUT_OF_RANGE, {"dt", "-1"});
  expect_refused(abut_response_step(scene.response(), nan), ABUT_NOT_FINITE, {"dt"});
  const Shape shape = ball(1);
  abut_mass_properties mass{};
  expect_refused(abut_shape_mass_properties(shape.get(), 0, &mass), ABUT_OUT_OF_RANGE, {"density", "0"});
  scene.step(1);
  EXPECT_NEAR(scene.pose(part).position.z, -0.5 * gravity, 1e-12);
}

// What a material or a callback says of a contact; nothing moves.
TEST(BodyInput, RefusesNumbersOfContactsByNameAndValue) {
  Scene scene;
  scene.floor();
  const abut_part_id part = scene.body(ball(1), {{0, 0, 1}, no_turn}, 1);
  struct Spoiled {
    double abut_contact_material::* number;
    double value;
  };
  const auto refused = [&](Spoiled spoiled, abut_status status, std::initializer_list<std::string_view> words) {
    const abut_contact_callback edit = [](void* context, const abut_contact*,
                                          abut_contact_material* material) -> std::uint32_t {
      const Spoiled& its = *static_cast<const Spoiled*>(context);
      material->*its.number = its.value;
      return 1;
    };
    require(abut_response_set_contact_callback(scene.response(), edit, &spoiled));
    expect_refused(abut_response_step(scene.response(), 1e-2), status, words);
    EXPECT_EQ(scene.pose(part).position.z, 1);
  };
  using Row = abut_contact_material;
  refused({&Row::friction_primary, -1}, ABUT_OUT_OF_RANGE, {"friction_primary", "-1"});
  refused({&Row::friction_secondary, nan}, ABUT_NOT_FINITE, {"friction_secondary"});
  refused({&Row::static_scale, 2e6}, ABUT_OUT_OF_RANGE, {"static_scale", "2000000"});
  refused({&Row::compliance, infinity}, ABUT_NOT_FINITE, {"compliance"});
  refused({&Row::damping, 2e30}, ABUT_OUT_OF_RANGE, {"damping"});
  refused({&Row::restitution, -3}, ABUT_OUT_OF_RANGE, {"restitution", "-3"});
  refused({&Row::restitution_threshold, nan}, ABUT_NOT_FINITE, {"restitution_threshold"});
  require(abut_response_set_contact_callback(scene.response(), nullptr, nullptr));
  scene.material([](Row& row) { row.friction_primary = 1e7; });
  expect_refused(abut_response_step(scene.response(), 1e-2), ABUT_OUT_OF_RANGE, {"friction_primary", "10000000"});
  scene.material([](Row&) {});
  scene.step(1e-2);
}

// A filter runs while the universe steps.
TEST(BodyInput, RefusesChangesFromACallback) {
  Scene scene;
  scene.floor();
  scene.body(ball(1), {{0, 0, 1}, no_turn}, 1);
  struct Tried {
    abut_response* response;
    abut_status step = ABUT_OK, change = ABUT_OK;
  } tried{scene.response()};
  const abut_filter filter = [](void* context, const abut_universe*, abut_geometry_id,
                                abut_geometry_id) -> std::uint32_t {
    Tried& its = *static_cast<Tried*>(context);
    its.step = abut_response_step(its.response, 1);
    its.change = abut_response_add_bodies(its.response, nullptr, 0, nullptr);
    abut_response_destroy(its.response);
    return 1;
  };
  require(abut_universe_set_filter(scene.universe(), filter, &tried));
  scene.step(1e-2);
  EXPECT_EQ(tried.step, ABUT_BUSY);
  EXPECT_EQ(tried.change, ABUT_BUSY);
  scene.step(1e-2);
}

}  // namespace
