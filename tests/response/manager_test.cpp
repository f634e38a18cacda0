// SPDX-License-Identifier: Apache-2.0
// What contacts do, by kind and rule.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "scene.hpp"

namespace {

using namespace response_test;

constexpr abut_response_side any{ABUT_RESPONSE_SIDE_ANY, 0, 0};

void rule(const Scene& scene, const abut_response_side& a, const abut_response_side& b, const char* kind,
          const char* parameters) {
  require(abut_response_add_rule(scene.response(), &a, &b, kind, parameters, nullptr));
}
abut_response_side of_part(abut_part_id part) { return {ABUT_RESPONSE_SIDE_PART, part.slot, part.generation}; }

abut_geometry_id geometry_of(const Scene& scene, abut_part_id part) {
  abut_geometry_id out{};
  std::size_t count = 0;
  require(abut_part_geometries(scene.universe(), part, &out, 1, &count));
  return out;
}

std::span<const abut_response_object> objects_of(const Scene& scene) {
  const abut_response_object* first = nullptr;
  std::size_t count = 0;
  require(abut_response_objects(scene.response(), &first, &count));
  return {first, count};
}

// A block of 2 kg on the ground, pushed sideways by a gravity of 3 m/s^2.
struct Slope {
  Scene scene{[](abut_response_options& its) { its.gravity = {3, 0, -gravity}; }};
  abut_part_id floor = scene.floor();
  abut_part_id part = scene.body(block(0.5, 0.5, 0.1), {{0, 0, 0.1}, no_turn}, 2);

  double speed_after(int steps) {
    scene.step(1e-2, steps);
    return scene.velocity(part).linear.x;
  }
};

TEST(Manager, GivesEachKindItsLaw) {
  struct Row {
    const char* kind;
    const char* parameters;
    double speed, height;  // after a second
  };
  // Sliding friction takes mu g off the push; a spring without friction sinks in by m g / k, of
  // four contacts by a fourth.
  for (const Row& row :
       {Row{"friction", "mu=1", 0, 0.1}, Row{"friction", "mu=0.1", 3 - 0.981, 0.1},
        Row{"friction", "mu=1&k=1e5&d=1e3", 0, 0.1 - 2 * gravity / 4e5},
        Row{"penalty", "mu=1&k=1e5&d=1e3", 3, 0.1 - 2 * gravity / 4e5}, Row{"augmented", "mu=1&epsilon=0.1", 0, 0.1},
        Row{"slide", "mu=1", 0, 0.1}, Row{"slide", "mu=0.1", 3 - 0.981, 0.1}, Row{"stick", "", 0, 0.1},
        Row{"none", "mu=1", 3, 0.1 - gravity / 2}}) {
    Slope slope;
    rule(slope.scene, any, any, row.kind, row.parameters);
    EXPECT_NEAR(slope.speed_after(100), row.speed, 1e-4) << row.kind << " " << row.parameters;
    EXPECT_NEAR(slope.scene.pose(slope.part).position.z, row.height, 2e-5) << row.kind << " " << row.parameters;
  }
}

TEST(Manager, TakesTheFirstRuleThatFits) {
  Slope slope;
  abut_geometry_options options;
  abut_geometry_options_init(&options, sizeof options);
  options.tolerance = 1e-3;
  options.label = 7;
  options.tag = 5;
  options.material = 3;
  const abut_geometry_id ground_of = geometry_of(slope.scene, slope.floor);
  require(abut_geometry_set_options(slope.scene.universe(), ground_of, &options));
  const abut_geometry_id block_of = geometry_of(slope.scene, slope.part);
  rule(slope.scene, {ABUT_RESPONSE_SIDE_LABEL, 8, 0}, any, "none", "");
  rule(slope.scene, {ABUT_RESPONSE_SIDE_TAG, 8, 0}, any, "none", "");
  rule(slope.scene, {ABUT_RESPONSE_SIDE_MATERIAL, 8, 0}, any, "none", "");
  rule(slope.scene, of_part(slope.floor), of_part(slope.floor), "none", "");
  const auto text = [&] {
    std::array<char, 256> out{};
    std::size_t needed = 0;
    require(abut_response_rule_between(slope.scene.response(), block_of, ground_of, out.data(), out.size(), &needed));
    EXPECT_EQ(std::string(out.data()).size() + 1, needed);
    return std::string(out.data());
  };
  EXPECT_EQ(text(), "no rule: friction, mu1 0, mu2 0, static 1, compliance 0, d 0, e 0, threshold 0.001, adhesion 0");
  EXPECT_NEAR(slope.speed_after(1), 0.03, 1e-9);
  // Each of these fits, and the first one counts.
  rule(slope.scene, any, {ABUT_RESPONSE_SIDE_MATERIAL, 3, 0}, "friction", "mu=0.5");
  EXPECT_EQ(text().substr(0, 25), "rule 4: friction, mu1 0.5");
  EXPECT_NEAR(slope.speed_after(2), 0, 1e-9);
  rule(slope.scene, {ABUT_RESPONSE_SIDE_LABEL, 7, 0}, any, "none", "");
  EXPECT_NEAR(slope.speed_after(1), 0, 1e-9);
  require(abut_response_clear_rules(slope.scene.response()));
  for (const abut_response_side& side :
       {abut_response_side{ABUT_RESPONSE_SIDE_LABEL, 7, 0}, abut_response_side{ABUT_RESPONSE_SIDE_TAG, 5, 0},
        of_part(slope.part), abut_response_side{ABUT_RESPONSE_SIDE_GEOMETRY, block_of.slot, block_of.generation}}) {
    rule(slope.scene, any, side, "none", "");
    EXPECT_EQ(text().substr(0, 12), "rule 0: none") << side.kind;
    require(abut_response_clear_rules(slope.scene.response()));
  }
  rule(slope.scene, any, any, "none", "");
  require(abut_response_set_geometry_kind(slope.scene.response(), block_of, "friction", "mu=2"));
  EXPECT_EQ(text().substr(0, 27), "geometry " + std::to_string(block_of.slot) + ": friction, mu1 2");
  require(abut_response_set_geometry_kind(slope.scene.response(), block_of, nullptr, nullptr));
  EXPECT_EQ(text().substr(0, 12), "rule 0: none");
}

TEST(Manager, ReadsParametersAtAnyTime) {
  Slope slope;
  abut_response* const its = slope.scene.response();
  require(abut_response_set_variable(its, "rough", "0.9"));
  std::uint32_t number = 9;
  require(abut_response_add_rule(its, nullptr, nullptr, "friction", "mu=$rough$", &number));
  EXPECT_EQ(number, 0U);
  EXPECT_NEAR(slope.speed_after(10), 0, 1e-9);
  require(abut_response_set_rule_parameters(its, 0, "mu=0"));
  EXPECT_NEAR(slope.speed_after(10), 0.3, 1e-9);
  EXPECT_EQ(abut_response_set_rule_parameters(its, 1, "mu=0"), ABUT_INDEX_OUT_OF_RANGE);
}

TEST(Manager, RefusesWhatItCannotRead) {
  const Scene scene;
  struct Row {
    const char* kind;
    const char* parameters;
    abut_status status;
    const char* named;
  };
  for (const Row& row : {Row{"glue", "", ABUT_INVALID_ARGUMENT, "kind is \"glue\""},
                         Row{"friction", "my=1", ABUT_INVALID_ARGUMENT, "\"my=1\""},
                         Row{"friction", "mu", ABUT_INVALID_ARGUMENT, "\"mu\""},
                         Row{"friction", "mu=", ABUT_INVALID_ARGUMENT, "\"mu=\""},
                         Row{"friction", "mu=1x", ABUT_INVALID_ARGUMENT, "\"mu=1x\""},
                         Row{"friction", "mu=0.5&k=0", ABUT_OUT_OF_RANGE, "\"k=0\""},
                         Row{"friction", "mu=-1", ABUT_OUT_OF_RANGE, "between 0 and 1e+06"},
                         Row{"friction", "mu=inf", ABUT_NOT_FINITE, "\"mu=inf\""},
                         Row{"friction", "mu=nan", ABUT_NOT_FINITE, "\"mu=nan\""},
                         Row{"friction", "mu=$none$", ABUT_INVALID_ARGUMENT, "\"none\""},
                         Row{"friction", "mu=$none", ABUT_INVALID_ARGUMENT, "ends with $"}}) {
    EXPECT_EQ(abut_response_add_rule(scene.response(), &any, &any, row.kind, row.parameters, nullptr), row.status);
    EXPECT_NE(std::string(abut_last_error_message()).find(row.named), std::string::npos) << abut_last_error_message();
  }
  const abut_response_side unknown{6, 0, 0};
  EXPECT_EQ(abut_response_add_rule(scene.response(), &unknown, &any, "none", "", nullptr), ABUT_UNKNOWN_VALUE);
  EXPECT_EQ(abut_response_add_rule(scene.response(), &any, &any, nullptr, "", nullptr), ABUT_NULL_ARGUMENT);
  EXPECT_EQ(abut_response_set_geometry_kind(scene.response(), {9, 9}, "none", ""), ABUT_STALE_ID);
  // None of them has left a rule behind.
  EXPECT_EQ(abut_response_set_rule_parameters(scene.response(), 0, ""), ABUT_INDEX_OUT_OF_RANGE);
}

// Appears with its contacts, stays, and is told once when it has gone.
TEST(Manager, TellsObjectsFromTheirFirstContactToTheLast) {
  Scene scene;
  const abut_part_id ground = scene.floor();
  const abut_part_id part = scene.body(ball(0.5), {{0, 0, 0.5}, no_turn}, 2);
  std::vector<abut_response_object> told;
  require(abut_response_set_listener(
      scene.response(),
      [](void* context, const abut_response_object* object) {
        static_cast<std::vector<abut_response_object>*>(context)->push_back(*object);
      },
      &told));
  scene.step(1e-2, 3);
  ASSERT_EQ(told.size(), 3U);
  const std::array events{ABUT_RESPONSE_EVENT_BEGIN, ABUT_RESPONSE_EVENT_PERSIST, ABUT_RESPONSE_EVENT_PERSIST};
  for (std::uint32_t i = 0; i < told.size(); ++i) {
    EXPECT_EQ(told[i].event, abut_response_event{events[i]});
    EXPECT_EQ(told[i].age, i);
    EXPECT_EQ(told[i].contact_count, 1U);
    const double sign = told[i].geometry_a.slot == geometry_of(scene, ground).slot ? 1 : -1;
    EXPECT_NEAR(sign * told[i].force.z, 2 * gravity, 1e-6);
    EXPECT_NEAR(sign * told[i].impulse.z, 2e-2 * gravity, 1e-8);
  }
  const abut_pose away{{0, 0, 9}, no_turn};
  require(abut_part_set_pose(scene.universe(), part, &away));
  told.clear();
  scene.step(1e-2, 2);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].event, abut_response_event{ABUT_RESPONSE_EVENT_END});
  EXPECT_EQ(told[0].age, 3U);
  EXPECT_EQ(told[0].contact_count, 0U);
  EXPECT_TRUE(objects_of(scene).empty());
}

TEST(Manager, NamesKindsAndAddsThose) {
  const Scene scene;
  const auto law = [](void*, const abut_contact*, const abut_vec3*, double, abut_contact_law*) -> std::uint32_t {
    return 1;
  };
  require(abut_response_add_kind(scene.response(), "mine", law, nullptr));
  EXPECT_EQ(abut_response_add_kind(scene.response(), "mine", law, nullptr), ABUT_INVALID_ARGUMENT);
  EXPECT_EQ(abut_response_add_kind(scene.response(), "", law, nullptr), ABUT_INVALID_ARGUMENT);
  EXPECT_EQ(abut_response_add_kind(scene.response(), "other", nullptr, nullptr), ABUT_NULL_ARGUMENT);
  std::array<const char*, 9> names{};
  std::size_t count = 0;
  require(abut_response_kinds(scene.response(), names.data(), names.size(), &count));
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += std::string(names[i]) + " ";
  EXPECT_EQ(all, "friction penalty augmented stick slide none mine ");
}

// Hertz: f = stiffness depth^1.5, so the depth at rest is (m g / stiffness)^(2/3).
std::uint32_t hertz(void* context, const abut_contact* contact, const abut_vec3*, double dt, abut_contact_law* law) {
  const double stiffness = *static_cast<const double*>(context), depth = std::max(0.0, -contact->distance);
  if (depth == 0) return 0;
  const double force = stiffness * depth * std::sqrt(depth), slope = 1.5 * stiffness * std::sqrt(depth);
  const double damping = 0.2 * slope;
  law->compliance = 1 / (dt * (dt * slope + damping));
  law->offset = -force * dt * law->compliance;
  return 1;
}

TEST(Manager, AsksKindsOfTheCaller) {
  Scene scene({}, 0.1);
  scene.floor();
  double stiffness = 1e5;
  require(abut_response_add_kind(scene.response(), "hertz", hertz, &stiffness));
  rule(scene, any, any, "hertz", "");
  const abut_part_id part = scene.body(ball(0.5), {{0, 0, 0.499}, no_turn}, 2);
  scene.step(1e-3, 20000);
  EXPECT_NEAR(0.5 - scene.pose(part).position.z, std::pow(2 * gravity / stiffness, 2.0 / 3), 1e-9);
  stiffness = std::nan("");
  EXPECT_EQ(abut_response_step(scene.response(), 1e-3), ABUT_NOT_FINITE);
}

TEST(Manager, KeepsWhatSticksUntilItIsReleased) {
  Scene scene;
  const abut_part_id ground = scene.floor();
  const abut_part_id part = scene.body(ball(0.5), {{0, 0, 0.5}, no_turn}, 2);
  rule(scene, any, any, "stick", "");
  scene.step(1e-2, 2);
  const abut_geometry_id one = geometry_of(scene, ground), other = geometry_of(scene, part);
  const abut_vec3 lift{0, 0, 10 * gravity};
  for (int i = 0; i < 20; ++i) {
    require(abut_response_apply_force(scene.response(), part, &lift, nullptr));
    scene.step(1e-2);
  }
  EXPECT_NEAR(scene.pose(part).position.z, 0.5, 1e-9);
  ASSERT_EQ(objects_of(scene).size(), 1U);
  EXPECT_EQ(objects_of(scene)[0].bond_count, 1U);
  ASSERT_EQ(scene.contacts().size(), 1U);
  EXPECT_EQ(scene.contacts()[0].state, abut_contact_state{ABUT_CONTACT_STATE_BONDED});
  EXPECT_NEAR(std::fabs(scene.contacts()[0].force.z), 8 * gravity, 1e-6);
  require(abut_response_release(scene.response(), one, other));
  EXPECT_EQ(abut_response_release(scene.response(), one, other), ABUT_STALE_ID);
  require(abut_response_apply_force(scene.response(), part, &lift, nullptr));
  scene.step(1e-2);
  EXPECT_NEAR(scene.velocity(part).linear.z, 4 * gravity * 1e-2, 1e-9);
}

TEST(Manager, BreaksBondsThatBearTooMuch) {
  Scene scene;
  scene.floor();
  const abut_part_id part = scene.body(ball(0.5), {{0, 0, 0.5}, no_turn}, 2);
  rule(scene, any, any, "stick", "break=25");
  scene.step(1e-2, 2);
  for (const double times : {2.2, 2.3}) {
    const abut_vec3 lift{0, 0, times * 2 * gravity};
    require(abut_response_apply_force(scene.response(), part, &lift, nullptr));
    scene.step(1e-2);
    EXPECT_NEAR(scene.velocity(part).linear.z, 0, 1e-9);
    EXPECT_EQ(objects_of(scene).front().bond_count, times * 2 * gravity - 2 * gravity > 25 ? 0U : 1U);
  }
}

// A contact pulls with its adhesive force and no more.
TEST(Manager, HoldsByAdhesion) {
  for (const double force : {19.0, 20.0}) {
    Scene scene([](abut_response_options& its) { its.gravity = {0, 0, gravity}; });
    scene.floor();
    const abut_part_id part = scene.body(ball(0.5), {{0, 0, 0.5}, no_turn}, 2);
    rule(scene, any, any, "friction", ("adhesion=" + std::to_string(force)).c_str());
    scene.step(1e-2);
    EXPECT_NEAR(scene.velocity(part).linear.z, force < 2 * gravity ? (gravity - force / 2) * 1e-2 : 0, 1e-9);
    EXPECT_NEAR(std::fabs(scene.contacts()[0].force.z), std::min(force, 2 * gravity), 1e-6);
  }
}

// A loose solver lets blocks creep; the kind slide takes it back.
TEST(Manager, LetsNothingCreepThatSticks) {
  const auto creep = [](const char* kind) {
    Scene scene([](abut_response_options& its) {
      its.gravity = {3, 0, -gravity};
      its.tolerance = 1e-2;
    });
    scene.floor();
    rule(scene, any, any, kind, "mu=0.5");
    const abut_part_id part = scene.body(block(0.5, 0.5, 0.1), {{0, 0, 0.1}, no_turn}, 2);
    scene.step(1e-2, 20);
    const double start = scene.pose(part).position.x;
    scene.step(1e-2, 500);
    return std::fabs(scene.pose(part).position.x - start);
  };
  EXPECT_LT(creep("slide"), 0.05 * creep("friction"));
}

}  // namespace
