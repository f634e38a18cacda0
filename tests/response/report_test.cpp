// SPDX-License-Identifier: Apache-2.0
// What a response tells of itself, and its bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "scene.hpp"

namespace {

using namespace response_test;

std::vector<abut_response_finding> findings_of(const Scene& scene) {
  std::size_t count = 0;
  require(abut_response_validate(scene.response(), nullptr, 0, &count));
  std::vector<abut_response_finding> out(count);
  require(abut_response_validate(scene.response(), out.data(), count, &count));
  return out;
}
std::vector<abut_response_finding_code> codes_of(const Scene& scene) {
  std::vector<abut_response_finding_code> out;
  for (const abut_response_finding& its : findings_of(scene)) out.push_back(its.code);
  return out;
}
using Codes = std::vector<abut_response_finding_code>;

void rule(const Scene& scene, const abut_response_side* a, const char* kind, const char* parameters) {
  require(abut_response_add_rule(scene.response(), a, nullptr, kind, parameters, nullptr));
}

TEST(Findings, AreNoneOfAGoodScene) {
  Scene scene;
  scene.floor();
  scene.body(ball(0.5), {{0, 0, 0.5}, no_turn}, 1);
  const abut_response_side label{ABUT_RESPONSE_SIDE_LABEL, 0, 0};
  rule(scene, &label, "friction", "mu=0.5&k=1e4&d=3");
  rule(scene, nullptr, "penalty", "k=1e4");
  EXPECT_EQ(codes_of(scene), Codes{});
}

TEST(Findings, NameWhatIsOddAboutBodies) {
  Scene scene([](abut_response_options& its) {
    its.flags = ABUT_RESPONSE_IMPACTS;
    its.solver = ABUT_SOLVER_SWEEPS;
  });
  const abut_part_id still = scene.body(ball(0.5), {{0, 0, 5}, no_turn}, 1);
  require(abut_part_set_motion(scene.universe(), still, ABUT_MOTION_STATIC));
  const abut_part_id other = scene.body(ball(0.5), {{5, 0, 5}, no_turn}, 1e4);
  std::size_t count = 0;
  abut_geometry_id geometry{};
  require(abut_part_geometries(scene.universe(), other, &geometry, 1, &count));
  abut_geometry_options options;
  abut_geometry_options_init(&options, sizeof options);
  options.flags = ABUT_GEOMETRY_SPECULATIVE;
  require(abut_geometry_set_options(scene.universe(), geometry, &options));
  EXPECT_EQ(codes_of(scene), (Codes{ABUT_RESPONSE_FINDING_NO_TOLERANCE, ABUT_RESPONSE_FINDING_NOT_DYNAMIC,
                                    ABUT_RESPONSE_FINDING_NOT_FAST, ABUT_RESPONSE_FINDING_NOT_FAST,
                                    ABUT_RESPONSE_FINDING_SPECULATIVE, ABUT_RESPONSE_FINDING_SLOW_SWEEPS}));
  const std::vector<abut_response_finding> all = findings_of(scene);
  EXPECT_EQ(all[0].geometry.slot, geometry.slot);
  EXPECT_EQ(all[1].part.slot, still.slot);
  EXPECT_NE(std::string(all[1].message).find("part " + std::to_string(still.slot)), std::string::npos);
}

TEST(Findings, NameAPartThatSleepsWithAVelocity) {
  Scene scene;
  scene.floor();
  const abut_part_id part = scene.body(block(0.5, 0.5, 0.5), {{0, 0, 0.5}, no_turn}, 1);
  abut_sleep sleep;
  abut_sleep_init(&sleep, sizeof sleep);
  require(abut_part_set_sleep(scene.universe(), part, &sleep));
  scene.step(1e-2, 60);
  const abut_velocity velocity{{1, 0, 0}, {}};
  require(abut_part_set_velocity(scene.universe(), part, &velocity));
  EXPECT_EQ(codes_of(scene), Codes{ABUT_RESPONSE_FINDING_ASLEEP});
}

TEST(Findings, NameAUniverseInDeadBand) {
  abut_universe* universe = nullptr;
  require(abut_universe_create(nullptr, &universe));
  abut_response* response = nullptr;
  require(abut_response_create(universe, nullptr, &response));
  abut_response_finding found{};
  std::size_t count = 0;
  require(abut_response_validate(response, &found, 1, &count));
  EXPECT_EQ(count, 1U);
  EXPECT_EQ(found.code, abut_response_finding_code{ABUT_RESPONSE_FINDING_DEAD_BAND});
  abut_response_destroy(response);
  abut_universe_destroy(universe);
}

TEST(Findings, NameWhatIsOddAboutRules) {
  Scene scene;
  const abut_part_id part = scene.place(ball(0.5), {{0, 0, 0}, no_turn}, ABUT_MOTION_DYNAMIC);
  const abut_response_side gone{ABUT_RESPONSE_SIDE_PART, part.slot, part.generation};
  rule(scene, &gone, "penalty", "mu=1");
  require(abut_part_destroy(scene.universe(), part));
  rule(scene, &gone, "friction", "e=0.5&epsilon=0.1");
  rule(scene, nullptr, "friction", "d=1");
  rule(scene, nullptr, "none", "");
  EXPECT_EQ(codes_of(scene),
            (Codes{ABUT_RESPONSE_FINDING_NO_IMPACTS, ABUT_RESPONSE_FINDING_NO_STIFFNESS, ABUT_RESPONSE_FINDING_UNUSED,
                   ABUT_RESPONSE_FINDING_UNUSED, ABUT_RESPONSE_FINDING_UNUSED, ABUT_RESPONSE_FINDING_UNREACHABLE,
                   ABUT_RESPONSE_FINDING_GONE, ABUT_RESPONSE_FINDING_GONE}));
  EXPECT_EQ(findings_of(scene)[5].rule, 3U);
}

template <class Tell>
std::string text_from(const Scene& scene, Tell tell) {
  std::size_t needed = 0;
  require(tell(scene.response(), nullptr, 0, &needed));
  std::string out(needed, ' ');
  require(tell(scene.response(), out.data(), out.size(), &needed));
  out.pop_back();
  return out;
}

TEST(Explain, TellsOptionsRulesAndIslands) {
  Scene scene;
  scene.floor();
  scene.body(ball(0.5), {{0, 0, 0.5}, no_turn}, 1);
  const abut_response_side label{ABUT_RESPONSE_SIDE_LABEL, 7, 0};
  rule(scene, &label, "slide", "mu=0.5");
  scene.step(1e-2);
  const std::string words = text_from(scene, abut_response_explain),
                    json = text_from(scene, abut_response_explain_json);
  for (const char* const part :
       {"solver newton", "most_rounds 100", "rule 0, a label 7, b any, kind slide, parameters mu=0.5",
        "island 0, bodies 1, contacts 1, integrator implicit", "converged true"})
    EXPECT_NE(words.find(part), std::string::npos) << part << "\n" << words;
  for (const char* const part : {"{\"step\":[{\"solver\":\"newton\",", "\"rules\":[{\"rule\":0,\"a\":\"label 7\"",
                                 "\"links\":[]", "\"islands\":[{\"island\":0,\"bodies\":1", "\"converged\":true}]}"})
    EXPECT_NE(json.find(part), std::string::npos) << part << "\n" << json;
  std::array<char, 8> few{};
  std::size_t needed = 0;
  require(abut_response_explain(scene.response(), few.data(), few.size(), &needed));
  EXPECT_EQ(std::string(few.data()), words.substr(0, 7));
  EXPECT_EQ(needed, words.size() + 1);
}

std::uint32_t as_it_is(void*, const abut_contact*, const abut_vec3*, double, abut_contact_law*) { return 1; }

// Everything that bytes hold: bodies of all sorts, links, bonds, rules and impulses.
struct Rich {
  Scene scene;
  abut_geometry_id grains{};

  Rich() {
    scene.material([](abut_contact_material& row) { row.friction_primary = row.friction_secondary = 0.5; });
    const abut_part_id floor = scene.floor();
    abut_response* const its = scene.response();
    require(abut_response_add_kind(its, "mine", as_it_is, nullptr));
    const abut_part_id a = scene.body(block(0.5, 0.5, 0.5), {{0, 0, 0.5}, no_turn}, 1, {{0.4, 0, 0}, {}}),
                       b = scene.body(ball(0.5), {{0, 0, 1.5}, no_turn}, 2),
                       c = scene.body(ball(0.5), {{3, 0, 0.5}, no_turn}, 2, {{0, 1, 0}, {}});
    const abut_response_side of_c{ABUT_RESPONSE_SIDE_PART, c.slot, c.generation},
        of_b{ABUT_RESPONSE_SIDE_PART, b.slot, b.generation};
    require(abut_response_set_variable(its, "rough", "0.3"));
    require(abut_response_add_rule(its, &of_c, nullptr, "mine", "mu=$rough$&k=1e5&d=10", nullptr));
    require(abut_response_add_rule(its, &of_b, nullptr, "stick", "break=1e5", nullptr));
    abut_geometry_id ground{};
    std::size_t count = 0;
    require(abut_part_geometries(scene.universe(), floor, &ground, 1, &count));
    require(abut_response_set_geometry_kind(its, ground, "slide", "mu=0.7"));
    require(abut_response_set_geometry_kind(its, ground, nullptr, nullptr));
    abut_link_options link;
    abut_link_options_init(&link, sizeof link);
    link.b = c;
    link.point_a = {3, 0, 2};
    link.point_b = {3, 0, 0.5};
    link.stiffness = 30;
    std::uint64_t number = 0;
    require(abut_response_add_link(its, &link, &number));
    const std::vector<double> places{6, 0, 0.3, 7, 0, 0.1}, masses{1, 2};
    const Shape shape = shape_from([&](abut_shape** out) { return abut_particles_create(places.data(), 2, 0.1, out); });
    const abut_part_id sand = scene.place(shape, {{0, 0, 0}, no_turn}, ABUT_MOTION_DYNAMIC);
    require(abut_part_geometries(scene.universe(), sand, &grains, 1, &count));
    require(abut_response_add_particles(its, grains, masses.data(), places.data(), nullptr, 2));
    const abut_vec3 push{1, 2, 3};
    scene.step(1e-2, 20);
    require(abut_response_apply_force(its, a, &push, nullptr));
  }
};

template <class Handle, class Save>
std::vector<unsigned char> bytes_of(const Handle* handle, Save save) {
  std::size_t size = 0;
  require(save(handle, nullptr, 0, &size));
  std::vector<unsigned char> out(size);
  require(save(handle, out.data(), out.size(), &size));
  return out;
}

TEST(Bytes, GoOnWithTheSameBits) {
  const Rich its;
  const std::vector<unsigned char> bytes = bytes_of(its.scene.response(), abut_response_save),
                                   world = bytes_of(its.scene.universe(), abut_universe_save);
  abut_universe* loaded_universe = nullptr;
  require(abut_universe_load(world.data(), world.size(), &loaded_universe));
  const std::unique_ptr<abut_universe, Delete> universe(loaded_universe);
  abut_response* loaded = nullptr;
  require(abut_response_load(loaded_universe, bytes.data(), bytes.size(), &loaded));
  const std::unique_ptr<abut_response, Delete> response(loaded);
  EXPECT_EQ(bytes_of(loaded, abut_response_save), bytes);
  // Functions do not come with bytes.
  EXPECT_EQ(abut_response_step(loaded, 1e-2), ABUT_INVALID_ARGUMENT);
  EXPECT_NE(std::string(abut_last_error_message()).find("mine"), std::string::npos);
  abut_response_finding found{};
  std::size_t count = 0;
  require(abut_response_validate(loaded, &found, 1, &count));
  EXPECT_EQ(found.code, abut_response_finding_code{ABUT_RESPONSE_FINDING_NO_FUNCTION});
  require(abut_response_add_kind(loaded, "mine", as_it_is, nullptr));
  EXPECT_EQ(abut_response_add_kind(loaded, "mine", as_it_is, nullptr), ABUT_INVALID_ARGUMENT);
  for (int i = 0; i < 30; ++i) {
    require(abut_response_step(its.scene.response(), 1e-2));
    require(abut_response_step(loaded, 1e-2));
    std::uint64_t hash = 0, other = 0;
    require(abut_response_hash(its.scene.response(), &hash));
    require(abut_response_hash(loaded, &other));
    ASSERT_EQ(hash, other) << i;
    require(abut_universe_hash(its.scene.universe(), &hash));
    require(abut_universe_hash(loaded_universe, &other));
    ASSERT_EQ(hash, other) << i;
  }
}

TEST(Bytes, AreRefusedWhereTheyAreDamaged) {
  const Rich its;
  const std::vector<unsigned char> good = bytes_of(its.scene.response(), abut_response_save);
  abut_response* loaded = nullptr;
  for (const std::size_t size : {std::size_t{0}, std::size_t{7}, std::size_t{24}, good.size() - 1})
    EXPECT_EQ(abut_response_load(its.scene.universe(), good.data(), size, &loaded), ABUT_INVALID_ARGUMENT) << size;
  // Those that a checksum vouches for, too: it is found anew for each, by the formula of FNV-1a.
  const unsigned seed = std::random_device()();
  std::printf("seed %u\n", seed);
  std::mt19937 random(seed);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<unsigned char> bytes = good;
    bytes[24 + random() % (bytes.size() - 24)] = static_cast<unsigned char>(random());
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (std::size_t j = 24; j < bytes.size(); ++j) hash = (hash ^ bytes[j]) * 0x100000001B3U;
    const bool is_told = i % 2 == 0;
    for (std::size_t j = 0; is_told && j < sizeof hash; ++j) bytes[16 + j] = static_cast<unsigned char>(hash >> 8 * j);
    const abut_status status = abut_response_load(its.scene.universe(), bytes.data(), bytes.size(), &loaded);
    if (status != ABUT_OK) {
      ++refused;
      continue;
    }
    EXPECT_TRUE(is_told || bytes == good);
    const std::unique_ptr<abut_response, Delete> response(loaded);
    static_cast<void>(abut_response_add_kind(loaded, "mine", as_it_is, nullptr));
    abut_energy energy{};
    EXPECT_EQ(abut_response_energy(loaded, &energy), ABUT_OK);
    static_cast<void>(text_from(its.scene, abut_response_explain_json));
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
