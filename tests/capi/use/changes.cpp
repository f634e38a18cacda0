// SPDX-License-Identifier: Apache-2.0
// Which geometries have changed since a revision, against what is told about each of them.
#include <map>
#include <random>
#include <tuple>

#include "support.hpp"

namespace {

using namespace abut_test;

abut_revision revision_of(const abut_universe* universe) {
  abut_revision out{};
  require(abut_universe_revision(universe, &out));
  return out;
}

struct Changes {
  bool is_known = false;
  std::vector<abut_geometry_id> geometries;
};
Changes changes_since(const abut_universe* universe, const abut_revision& since) {
  std::size_t count = 0;
  std::uint32_t is_known = 7;
  require(abut_universe_changes(universe, &since, nullptr, 0, &count, &is_known));
  EXPECT_LE(is_known, 1U);
  Changes out{is_known == 1, std::vector<abut_geometry_id>(count)};
  require(abut_universe_changes(universe, &since, out.geometries.data(), count, &count, &is_known));
  EXPECT_EQ(count, out.geometries.size());
  return out;
}

// All that may change of a geometry but what its shape is like inside.
using Told = std::tuple<std::uint32_t, double, double, const abut_shape*, std::uint64_t, abut_parking>;
std::map<std::uint32_t, Told> told(const Universe& universe) {
  std::size_t count = 0;
  require(abut_universe_geometries(universe, nullptr, 0, &count));
  std::vector<abut_geometry_id> all(count);
  require(abut_universe_geometries(universe, all.data(), count, &count));
  std::map<std::uint32_t, Told> out;
  for (const abut_geometry_id id : all) {
    const abut_geometry_info info = universe.describe(id);
    out[id.slot] = {id.generation, info.pose.position.x, info.pose.position.z, info.shape, info.layers, info.parking};
  }
  return out;
}

TEST(Changes, AreNoneWhereNothingHasChanged) {
  Universe universe;
  const Shape ball = make_sphere(1);
  EXPECT_TRUE(changes_since(universe, {0, 0}).is_known);
  universe.add(ball, identity);
  universe.step();
  const Changes none = changes_since(universe, revision_of(universe));
  EXPECT_TRUE(none.is_known);
  EXPECT_TRUE(none.geometries.empty());
  const Changes all = changes_since(universe, {0, 0});
  ASSERT_EQ(all.geometries.size(), 1U);
}

TEST(Changes, AreAllThatDiffer) {
  const auto seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const auto below = [&](std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  };
  Universe universe;
  const Shape ball = make_sphere(0.5), block = make_box(1, 1, 1);
  std::vector<abut_part_id> parts;
  std::vector<abut_geometry_id> geometries;
  const auto add = [&] {
    parts.push_back(universe.add_part(at(double(below(50)), 0, 0)));
    geometries.push_back(universe.add_geometry(parts.back(), ball));
    geometries.push_back(universe.add_geometry(parts.back(), block));
  };
  for (int i = 0; i < 20; ++i) add();
  const auto edit = [&] {
    const std::size_t at_part = below(parts.size()), at_geometry = 2 * at_part + below(2);
    const abut_geometry_id geometry = geometries[at_geometry];
    abut_geometry_options options = default_geometry_options();
    options.layers = 1 + below(5);
    options.pose.position.z = double(below(5));
    const double radius = 0.5 + double(below(5));
    switch (below(7)) {
      case 0: add(); break;
      case 1: universe.move(parts[at_part], at(double(below(50)), 0, 0)); break;
      case 2: universe.park(geometry, static_cast<abut_parking>(below(3))); break;
      case 3: require(abut_geometry_set_shape(universe, geometry, at_geometry % 2 == 0 ? block : ball)); break;
      case 4: require(abut_geometry_set_options(universe, geometry, &options)); break;
      case 5:
        if (abut_shape_kind_of(universe.describe(geometry).shape) == abut_shape_kind_of(ball))
          require(abut_geometry_set_parameters(universe, geometry, &radius, 1));
        break;
      default:
        if (parts.size() < 5) break;
        require(abut_part_destroy(universe, parts[at_part]));
        parts.erase(parts.begin() + std::ptrdiff_t(at_part));
        geometries.erase(geometries.begin() + std::ptrdiff_t(2 * at_part),
                         geometries.begin() + std::ptrdiff_t(2 * at_part + 2));
    }
  };
  for (int round = 0; round < 300; ++round) {
    const abut_revision since = revision_of(universe);
    const auto before = told(universe);
    for (std::size_t i = below(8); i > 0; --i) edit();
    if (below(3) == 0) universe.step();
    const auto after = told(universe);
    const Changes changes = changes_since(universe, since);
    ASSERT_TRUE(changes.is_known);
    ASSERT_TRUE(std::ranges::is_sorted(changes.geometries, {}, &abut_geometry_id::slot));
    std::map<std::uint32_t, std::uint32_t> changed;
    for (const abut_geometry_id id : changes.geometries) changed[id.slot] = id.generation;
    EXPECT_EQ(changed.size(), changes.geometries.size()) << "each once";
    for (const auto& [slot, its] : after) {
      const bool differs = !before.contains(slot) || before.at(slot) != its;
      EXPECT_TRUE(!differs || changed.contains(slot)) << "slot " << slot;
      if (changed.contains(slot)) EXPECT_EQ(changed.at(slot), std::get<0>(its));
    }
    for (const auto& [slot, its] : before) {
      if (!after.contains(slot)) EXPECT_TRUE(changed.contains(slot) && changed.at(slot) == 0) << "slot " << slot;
    }
  }
}

TEST(Changes, AreUnknownWhereMoreHasChangedThanIsRemembered) {
  Universe universe;
  const Shape ball = make_sphere(0.5);
  const abut_part_id part = universe.add_part(identity);
  universe.add_geometry(part, ball);
  const abut_revision first = revision_of(universe);
  for (int i = 1; i <= 512; ++i) universe.move(part, at(i, 0, 0));
  EXPECT_TRUE(changes_since(universe, first).is_known);
  const abut_revision later = revision_of(universe);
  universe.move(part, at(-1, 0, 0));
  const Changes unknown = changes_since(universe, first);
  EXPECT_FALSE(unknown.is_known);
  EXPECT_TRUE(unknown.geometries.empty());
  EXPECT_TRUE(changes_since(universe, later).is_known);
  EXPECT_EQ(changes_since(universe, later).geometries.size(), 1U);
}

TEST(Changes, OfALoadedUniverseBeginWithIt) {
  Universe universe;
  const Shape ball = make_sphere(0.5);
  const abut_part_id part = universe.add_part(identity);
  universe.add_geometry(part, ball);
  const abut_revision since = revision_of(universe);
  std::size_t size = 0;
  require(abut_universe_save(universe, nullptr, 0, &size));
  std::vector<unsigned char> bytes(size);
  require(abut_universe_save(universe, bytes.data(), size, &size));
  abut_universe* loaded = nullptr;
  require(abut_universe_load(bytes.data(), size, &loaded));
  EXPECT_TRUE(changes_since(loaded, since).is_known);
  EXPECT_TRUE(changes_since(loaded, since).geometries.empty());
  EXPECT_FALSE(changes_since(loaded, {0, 0}).is_known);
  abut_universe_destroy(loaded);
}

}  // namespace
