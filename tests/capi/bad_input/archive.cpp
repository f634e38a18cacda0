// SPDX-License-Identifier: Apache-2.0
// Universes as bytes, under bad input: every byte may be another one.
#include <cstring>
#include <random>

#include "archive_support.hpp"
#include "bad_values.hpp"

namespace {

using namespace abut_test;

TEST(UniverseSave, WritesNothingThatDoesNotFit) {
  const Scene scene;
  const std::vector<std::uint8_t> all = saved(scene.universe);
  OutArray<std::uint8_t> bytes(all.size());
  std::size_t size = 0;
  EXPECT_TRUE(succeeded(abut_universe_save(scene.universe, bytes.data(), all.size() - 1, &size)));
  EXPECT_EQ(size, all.size());
  EXPECT_TRUE(bytes.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

std::uint32_t save_in_callback(void*, const abut_universe* universe, abut_geometry_id, abut_geometry_id) {
  std::size_t size = 0;
  EXPECT_TRUE(refused(abut_universe_save(universe, nullptr, 0, &size), ABUT_BUSY, {"step"}));
  return 1;
}

TEST(UniverseSave, IsBusyInACallback) {
  Scene scene;
  ASSERT_TRUE(succeeded(abut_universe_set_filter(scene.universe, save_in_callback, nullptr)));
  EXPECT_FALSE(scene.universe.step().empty());
}

abut_status load(const std::vector<std::uint8_t>& bytes, Out<abut_universe*>& out) {
  return abut_universe_load(bytes.data(), bytes.size(), out.address());
}

TEST(UniverseLoad, RefusesWhatIsCutOff) {
  const Scene scene;
  const std::vector<std::uint8_t> all = saved(scene.universe);
  Out<abut_universe*> out;
  for (std::size_t size = 0; size < all.size(); ++size) {
    const std::vector<std::uint8_t> part(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_TRUE(refused(load(size == 0 ? std::vector<std::uint8_t>(1) : part, out), ABUT_INVALID_ARGUMENT, {"bytes"}));
  }
  std::vector<std::uint8_t> longer = all;
  longer.push_back(0);
  EXPECT_TRUE(refused(load(longer, out), ABUT_INVALID_ARGUMENT, {"bytes", std::to_string(longer.size())}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(UniverseLoad, RefusesAWrongMarkVersionOrChecksum) {
  const Scene scene;
  const std::vector<std::uint8_t> all = saved(scene.universe);
  Out<abut_universe*> out;
  std::vector<std::uint8_t> bytes = all;
  bytes[0] ^= 1;
  EXPECT_TRUE(refused(load(bytes, out), ABUT_INVALID_ARGUMENT, {"begin otherwise"}));
  bytes = all;
  bytes[8] = 99;
  EXPECT_TRUE(refused(load(bytes, out), ABUT_UNSUPPORTED, {"version 99", "version 6"}));
  for (const std::size_t place : {std::size_t{12}, std::size_t{40}, all.size() - 1}) {
    bytes = all;
    bytes[place] ^= 0x10;
    EXPECT_TRUE(refused(load(bytes, out), ABUT_INVALID_ARGUMENT, {"checksum"}));
  }
  EXPECT_TRUE(out.is_untouched());
}

// CRC-32C bit by bit, apart from the library.
void sign(std::vector<std::uint8_t>& bytes) {
  std::uint32_t sum = ~std::uint32_t{0};
  for (std::size_t i = 24; i < bytes.size(); ++i) {
    sum ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 1U) != 0 ? sum >> 1 ^ 0x82f63b78U : sum >> 1;
  }
  sum = ~sum;
  for (std::size_t i = 0; i < 4; ++i) bytes[12 + i] = static_cast<std::uint8_t>(sum >> (8 * i));
}

// A part that lists one geometry twice would destroy it twice.
TEST(UniverseLoad, RefusesAGeometryThatIsListedTwice) {
  Universe universe;
  const Shape ball = make_sphere(1);
  const abut_part_id part = universe.add_part(identity);
  const std::array listed{universe.add_geometry(part, ball), universe.add_geometry(part, ball)};
  universe.step();
  std::vector<std::uint8_t> bytes = saved(universe);
  const auto pattern = std::bit_cast<std::array<std::uint8_t, sizeof listed>>(listed);
  const auto found = std::search(bytes.begin() + 24, bytes.end(), pattern.begin(), pattern.end());
  ASSERT_NE(found, bytes.end()) << "the list of the part";
  sign(bytes);
  const Owned as_it_was = loaded(bytes);
  std::copy_n(found, pattern.size() / 2, found + static_cast<std::ptrdiff_t>(pattern.size() / 2));
  sign(bytes);
  Out<abut_universe*> out;
  EXPECT_TRUE(refused(load(bytes, out), ABUT_INVALID_ARGUMENT, {"bytes", "a geometry that is not its own"}));
  EXPECT_TRUE(out.is_untouched());
}

// With a checksum that fits: each is refused with a sentence, or is a universe that can be used.
void expect_harmless(const std::vector<std::uint8_t>& bytes) {
  abut_universe* made = nullptr;
  const abut_status status = abut_universe_load(bytes.data(), bytes.size(), &made);
  EXPECT_NE(status, abut_status{ABUT_INTERNAL}) << abut_last_error_message();
  if (status != ABUT_OK) {
    EXPECT_STRNE(abut_last_error_message(), "");
    return;
  }
  const Owned universe(made);
  EXPECT_NE(abut_universe_step(made, 0.01), abut_status{ABUT_INTERNAL}) << abut_last_error_message();
  const abut_ray ray{{0, 0, 9}, {0, 0, -1}, 20};
  std::array<abut_query_hit, 4> hits{};
  std::size_t count = 0;
  EXPECT_NE(abut_universe_cast_ray(made, &ray, nullptr, ABUT_HIT_ALL, hits.data(), hits.size(), &count),
            abut_status{ABUT_INTERNAL});
  std::size_t size = 0;
  EXPECT_NE(abut_universe_save(made, nullptr, 0, &size), abut_status{ABUT_INTERNAL});
}

TEST(UniverseLoad, IsHarmlessWhateverTheBytes) {
  Universe universe;
  const Shape bore = make_of_kind("sphere_hole", {0.3}), block = make_box(0.6, 0.6, 0.6);
  std::vector<Shape> shapes = make_one_of_each_kind();
  shapes.push_back(make_composite({block, bore}, {identity, identity}));
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    universe.add(shapes[i], at(0.4 * static_cast<double>(i), 0, 0));
  }
  const abut_part_id sleeper = universe.add_part(identity);
  const abut_sleep sleep = default_sleep();
  require(abut_part_set_sleep(universe, sleeper, &sleep));
  require(abut_part_measure_velocity(universe, sleeper));
  require(abut_universe_follow_islands(universe, 1));
  universe.step();
  universe.move(sleeper, at(1, 1, 1));
  const std::vector<std::uint8_t> all = saved(universe);
  std::mt19937 random(11);
  for (int round = 0; round < 4000; ++round) {
    std::vector<std::uint8_t> bytes = all;
    const std::size_t changes = 1 + random() % 2;
    for (std::size_t i = 0; i < changes; ++i) {
      const std::size_t place = 24 + random() % (bytes.size() - 24);
      constexpr std::array<std::uint8_t, 6> usual{0, 1, 0x7f, 0x80, 0xf0, 0xff};
      bytes[place] = random() % 2 == 0 ? usual.at(random() % usual.size()) : static_cast<std::uint8_t>(random());
    }
    sign(bytes);
    expect_harmless(bytes);
    if (HasFailure()) return;
  }
}

}  // namespace
