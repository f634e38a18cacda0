// SPDX-License-Identifier: Apache-2.0
// Vertices that a universe lends to be written: what an advance does, and until when they are lent.
#include "element_contacts.hpp"

namespace {

using namespace abut_test;

struct Lent {
  double* xyz = nullptr;
  std::size_t count = 0;

  std::vector<double> all() const { return {xyz, xyz + 3 * count}; }
  void write(const std::vector<double>& from) const { std::copy(from.begin(), from.end(), xyz); }
};
Lent next_of(abut_universe* universe, abut_geometry_id geometry) {
  Lent lent;
  require(abut_geometry_next_vertices(universe, geometry, &lent.xyz, &lent.count));
  return lent;
}
std::vector<double> vertices_of(const abut_universe* universe, abut_geometry_id geometry) {
  const double* xyz = nullptr;
  std::size_t count = 0;
  require(abut_geometry_vertices(universe, geometry, &xyz, &count));
  return {xyz, xyz + 3 * count};
}

// A sheet that moves among balls and boxes, beside another one, and meets itself.
struct World {
  explicit World(const std::vector<double>& settings = {0}) {
    std::mt19937 random(1);
    sheet = folded_surface(12, 0.01, random);
    abut_geometry_options options = default_geometry_options();
    options.flags = ABUT_GEOMETRY_SELF_PAIRS;
    mesh = universe.add_geometry(universe.add_part(identity, ABUT_MOTION_ANIMATED),
                                 make_of_kind("mesh", settings, sheet.xyz, sheet.triangles), options);
    for (int i = 0; i < 4; ++i) {
      universe.add(make_sphere(0.1), at(0.06 * i, 0.25 * i, 0.5));
      universe.add(make_box(0.1, 0.05, 0.1), at(0.06 * i, 1 - 0.25 * i, 0.3));
    }
    universe.add(shape_of(sheet), at(0.02, 0.01, 0));
  }
  std::uint64_t step() {
    require(abut_universe_step(universe, 0.01));
    return universe.hash();
  }
  void set(std::size_t first, std::size_t end, const std::vector<double>& xyz) {
    require(abut_geometry_set_vertices(universe, mesh, first, xyz.data() + 3 * first, end - first));
  }

  Surface sheet;
  Universe universe;
  abut_geometry_id mesh{};
};

// As all vertices by their numbers, and as those of a few ranges, which the tree follows one by one.
TEST(NextVertices, AnAdvanceDoesWhatSettingAllDoes) {
  for (const std::vector<double>& settings : {std::vector<double>{0}, {0, 2}, {0, 3}}) {
    std::mt19937 random(2);
    std::array<World, 3> worlds{World(settings), World(settings), World(settings)};
    Surface& sheet = worlds[0].sheet;
    const std::size_t count = sheet.vertex_count();
    std::set<std::uint64_t> hashes;
    for (int frame = 0; frame < 12; ++frame) {
      sheet.xyz = moved(sheet, frame == 6 ? 0.3 : 0.02, random);
      next_of(worlds[0].universe, worlds[0].mesh).write(sheet.xyz);
      require(abut_geometry_advance(worlds[0].universe, worlds[0].mesh));
      worlds[1].set(0, count, sheet.xyz);
      for (std::size_t i = 0; i < 4; ++i) worlds[2].set(i * count / 4, (i + 1) * count / 4, sheet.xyz);
      if (frame == 3) {
        const std::array<std::uint32_t, 3> gone{7, 8, 90};
        for (World& world : worlds)
          require(abut_geometry_remove_triangles(world.universe, world.mesh, gone.data(), gone.size()));
      }
      const std::uint64_t hash = worlds[0].step();
      EXPECT_EQ(worlds[1].step(), hash) << frame;
      EXPECT_EQ(worlds[2].step(), hash) << frame;
      EXPECT_GT(worlds[0].universe.contacts().size(), 20U);
      hashes.insert(hash);
    }
    EXPECT_EQ(hashes.size(), 12U);
  }
}

// A solid whose faces are turned inside out and back: what is inside follows.
TEST(NextVertices, AnAdvanceIsFollowedByTheInside) {
  Surface cube;
  for (int i = 0; i < 8; ++i) cube.xyz.insert(cube.xyz.end(), {double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  cube.triangles = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                    2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  Universe universe;
  const abut_geometry_id solid = universe.add(make_of_kind("mesh", {2}, cube.xyz, cube.triangles), identity);
  universe.add(make_sphere(0.01), at(0.5, 0.5, 0.5));
  EXPECT_EQ(universe.step().size(), 1U);
  for (int round = 0; round < 3; ++round) {
    const Lent lent = next_of(universe, solid);
    for (std::size_t i = 0; i < lent.count; ++i) lent.xyz[3 * i] = cube.xyz.at(3 * i) + (round % 2 == 0 ? 9 : 0);
    for (std::size_t i = 0; i < 3 * lent.count; ++i)
      if (i % 3 != 0) lent.xyz[i] = cube.xyz.at(i);
    require(abut_geometry_advance(universe, solid));
    EXPECT_EQ(universe.step().size(), round % 2 == 0 ? 0U : 1U);
  }
}

TEST(NextVertices, AreExchangedWithThePresentOnes) {
  World world;
  const std::vector<double> first = world.sheet.xyz;
  std::vector<double> second = first;
  for (double& number : second) number += 0.25;
  const Lent lent = next_of(world.universe, world.mesh);
  EXPECT_EQ(lent.all(), first) << "the present ones at first";
  lent.write(second);
  EXPECT_EQ(vertices_of(world.universe, world.mesh), first) << "nothing moves before the advance";
  world.step();
  EXPECT_EQ(next_of(world.universe, world.mesh).xyz, lent.xyz) << "the same memory again, also after a step";
  EXPECT_EQ(lent.all(), second);
  require(abut_geometry_advance(world.universe, world.mesh));
  EXPECT_EQ(vertices_of(world.universe, world.mesh), second);
  EXPECT_EQ(next_of(world.universe, world.mesh).all(), first) << "those that were";
  require(abut_geometry_advance(world.universe, world.mesh));
  EXPECT_EQ(vertices_of(world.universe, world.mesh), first);
}

// Other holders of a shape see nothing of it.
TEST(NextVertices, AreOfOneGeometryAlone) {
  Universe universe;
  std::mt19937 random(3);
  const Surface sheet = folded_surface(5, 0.01, random);
  const Shape shape = shape_of(sheet);
  const abut_geometry_id a = universe.add(shape, identity), b = universe.add(shape, identity);
  std::vector<double> moved_a = sheet.xyz, moved_b = sheet.xyz;
  for (double& number : moved_a) number += 1;
  for (double& number : moved_b) number -= 1;
  const Lent of_a = next_of(universe, a), of_b = next_of(universe, b);
  EXPECT_NE(of_a.xyz, of_b.xyz);
  of_a.write(moved_a);
  of_b.write(moved_b);
  abut_shape* held = nullptr;
  require(abut_geometry_shape(universe, b, &held));
  const std::array<abut_geometry_id, 2> both{b, a};
  require(abut_geometries_advance(universe, both.data(), both.size()));
  EXPECT_EQ(vertices_of(universe, a), moved_a);
  EXPECT_EQ(vertices_of(universe, b), moved_b);
  abut_aabb box{};
  for (const abut_shape* its : {static_cast<const abut_shape*>(shape), static_cast<const abut_shape*>(held)}) {
    require(abut_shape_aabb(its, &identity, &box));
    EXPECT_LT(std::fabs(box.minimum.y), 0.02);
  }
  abut_shape_release(held);
  require(abut_geometries_advance(universe, nullptr, 0));
}

// Edits of the present vertices leave those that are lent as they are.
TEST(NextVertices, AreLentUntilTheShapeIsAnother) {
  World world;
  Lent lent = next_of(world.universe, world.mesh);
  std::vector<double> written = world.sheet.xyz;
  for (double& number : written) number += 0.5;
  lent.write(written);
  world.set(0, world.sheet.vertex_count(), world.sheet.xyz);
  const std::uint32_t gone = 3;
  require(abut_geometry_remove_triangles(world.universe, world.mesh, &gone, 1));
  world.universe.park(world.mesh, ABUT_PARKING_SHORT_TERM);
  world.step();
  world.universe.park(world.mesh, ABUT_PARKING_NONE);
  EXPECT_EQ(lent.all(), written);
  EXPECT_EQ(next_of(world.universe, world.mesh).xyz, lent.xyz);

  const auto expect_none = [&] {
    EXPECT_TRUE(refused(abut_geometry_advance(world.universe, world.mesh), ABUT_INVALID_ARGUMENT,
                        {"geometry", "lent no vertices"}));
  };
  require(abut_geometry_set_mesh(world.universe, world.mesh, ground.xyz.data(), 3, ground.triangles.data(), 1));
  expect_none();
  EXPECT_EQ(next_of(world.universe, world.mesh).all(), ground.xyz);
  require(abut_geometry_set_shape(world.universe, world.mesh, shape_of(tip_at(0, 0, 1))));
  expect_none();
  EXPECT_EQ(next_of(world.universe, world.mesh).all(), tip_at(0, 0, 1).xyz);
  // A geometry that gets the slot has lent nothing.
  require(abut_geometry_destroy(world.universe, world.mesh));
  world.mesh = world.universe.add(shape_of(ground), identity);
  expect_none();
  EXPECT_EQ(next_of(world.universe, world.mesh).all(), ground.xyz);
}

// What an advance wakes, and what it leaves alone.
TEST(NextVertices, AnAdvanceIsAChange) {
  World world;
  world.step();
  world.step();
  EXPECT_EQ(world.universe.stats().examined_pairs, 0U);
  abut_revision before{}, after{};
  require(abut_universe_revision(world.universe, &before));
  next_of(world.universe, world.mesh);
  require(abut_universe_revision(world.universe, &after));
  EXPECT_EQ(after.geometries, before.geometries) << "lending changes nothing";
  require(abut_geometry_advance(world.universe, world.mesh));
  require(abut_universe_revision(world.universe, &after));
  EXPECT_EQ(after.geometries, before.geometries + 1);
  world.step();
  EXPECT_GT(world.universe.stats().examined_pairs, 0U);
}

TEST(NextVertices, AnAdvanceWakesThePart) {
  Universe universe;
  const abut_part_id part = universe.add_part(identity);
  const abut_geometry_id sheet = universe.add_geometry(part, shape_of(ground));
  abut_sleep sleep = default_sleep();
  sleep.steps = 2;
  require(abut_part_set_sleep(universe, part, &sleep));
  const auto is_asleep = [&] {
    std::uint32_t asleep = 0;
    require(abut_part_is_asleep(universe, part, &asleep));
    return asleep != 0;
  };
  const Lent lent = next_of(universe, sheet);
  for (int step = 0; step < 4; ++step) require(abut_universe_step(universe, 0.01));
  EXPECT_TRUE(is_asleep()) << "lending wakes nothing";
  lent.write(shifted(ground, 0, 0, 0.5).xyz);
  require(abut_geometry_advance(universe, sheet));
  require(abut_universe_step(universe, 0.01));
  EXPECT_FALSE(is_asleep());
}

}  // namespace
