// SPDX-License-Identifier: Apache-2.0
// What a scene does not use is not there: shown by memory, loaded libraries and results, not by what the plan says of
// itself.
#include "allocations.hpp"
#include "support.hpp"

#include <nlohmann/json.hpp>

#include <set>
#include <utility>

#include <dlfcn.h>
#include <link.h>

namespace {

using namespace abut_test;

// What is held beyond the last step that the universe does not count as its own: what steps make in shapes.
class Balance {
 public:
  explicit Balance(Universe& universe) : universe_(universe), own_(own()), all_(steady::live_bytes()) {}
  std::int64_t after_step() {
    universe_.step();
    const auto grown = [](std::size_t after, std::size_t before) {
      return static_cast<std::int64_t>(after) - static_cast<std::int64_t>(before);
    };
    return grown(steady::live_bytes(), all_) - grown(own(), own_);
  }

 private:
  std::size_t own() const { return universe_.stats().bytes; }

  Universe& universe_;
  std::size_t own_, all_;
};

// A wavy sheet of 2 * side * side triangles.
Shape make_sheet(std::uint32_t side) {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i <= side; ++i) {
    for (std::uint32_t j = 0; j <= side; ++j) {
      xyz.insert(xyz.end(), {0.1 * i, 0.1 * j, 0.02 * ((i + 2 * j) % 3)});
    }
  }
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      const std::uint32_t a = i * (side + 1) + j, b = a + side + 1;
      triangles.insert(triangles.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
  }
  abut_shape* shape = nullptr;
  require(abut_mesh_create(xyz.data(), xyz.size() / 3, triangles.data(), triangles.size() / 3, nullptr, &shape));
  return Shape(shape);
}

// Blocks of malloc are larger than what is asked for, and handles of the C interface have lists of their own.
constexpr std::int64_t slack = 65536;

TEST(Plan, BuildsNoTreeWithoutNeed) {
  constexpr std::uint32_t side = 100;
  const Shape ball = make_sphere(1), box = make_box(1, 1, 1), hull = make_octahedron(1), sheet = make_sheet(side);
  Universe universe;
  universe.step();
  Balance without(universe);
  for (int i = 0; i < 30; ++i) {
    universe.add(i % 3 == 0 ? ball : i % 3 == 1 ? box : hull, at(1.5 * i, 0, 0));
  }
  EXPECT_LT(std::abs(without.after_step()), slack) << "a scene without meshes";
  EXPECT_GT(universe.stats().touching_pairs, 20U);
  Balance alone(universe);
  universe.add(sheet, at(0, 0, 50), ABUT_MOTION_STATIC);
  EXPECT_LT(std::abs(alone.after_step()), slack) << "a mesh that nothing comes near";
  Balance touched(universe);
  universe.add(ball, at(5, 5, 50));
  // A node holds a box of six numbers at least, and a tree as many nodes as leaves, of some triangles each.
  EXPECT_GT(touched.after_step(), std::int64_t{2} * side * side * 16)
      << "a mesh that a ball touches: the tree is there";
  Balance again(universe);
  universe.add(ball, at(7, 5, 50));
  EXPECT_LT(std::abs(again.after_step()), slack) << "once";
}

// Nothing looks between two poses: what jumps over a wall has not met it, however long the step was.
TEST(Plan, RunsNoContinuousPassWithoutFastParts) {
  Universe universe, other;
  const Shape ball = make_sphere(0.1), wall = make_box(0.01, 5, 5);
  const auto jump = [&](Universe& its, double dt) {
    const abut_part_id part = its.add_part(at(-1, 0, 0));
    its.add_geometry(part, ball);
    its.add(wall, identity, ABUT_MOTION_STATIC);
    require(abut_universe_step(its, dt));
    its.move(part, at(1, 0, 0));
    require(abut_universe_step(its, dt));
    const abut_step_stats stats = its.stats();
    EXPECT_EQ(stats.candidate_pairs + stats.examined_pairs + stats.contacts + stats.events, 0U);
    its.move(part, at(0.05, 0, 0));
    require(abut_universe_step(its, dt));
    EXPECT_EQ(its.stats().contacts, 1U) << "the wall is there";
  };
  jump(universe, 1000);
  jump(other, 0);
  EXPECT_EQ(universe.hash(), other.hash());
}

// Names of what the loader has mapped into this process.
std::vector<std::string> loaded_libraries() {
  std::vector<std::string> names;
  dl_iterate_phdr(
      [](dl_phdr_info* object, std::size_t, void* out) {
        static_cast<std::vector<std::string>*>(out)->emplace_back(object->dlpi_name);
        return 0;
      },
      &names);
  return names;
}
bool is_loaded(std::string_view word) {
  const auto names = loaded_libraries();
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return name.find(word) != std::string::npos; });
}

TEST(Plan, LoadsNoEmbreeWithoutPicking) {
  const Scene scene;
  const abut_ray ray{{-5, 0, 0}, {1, 0, 0}, 20};
  abut_query_hit hit;
  std::size_t count = 0;
  ASSERT_TRUE(succeeded(abut_universe_cast_ray(scene.universe, &ray, nullptr, ABUT_HIT_NEAREST, &hit, 1, &count)));
  EXPECT_EQ(count, 1U);
  EXPECT_TRUE(is_loaded("libabut.so"));
  EXPECT_FALSE(is_loaded("libabut_picking"));
  EXPECT_FALSE(is_loaded("embree"));
  EXPECT_FALSE(is_loaded("libabut_response"));
#ifdef ABUT_PICKING_LIBRARY
  void* picking = dlopen(ABUT_PICKING_LIBRARY, RTLD_NOW);
  ASSERT_NE(picking, nullptr) << dlerror();
  EXPECT_TRUE(is_loaded("libabut_picking"));
  EXPECT_TRUE(is_loaded("embree")) << "what the library of picking brings is seen here";
  dlclose(picking);
#endif
}

std::set<std::pair<std::string, std::string>> cells_of(const Universe& universe, std::uint64_t& examined) {
  std::size_t needed = 0;
  require(abut_universe_explain_json(universe, nullptr, 0, &needed));
  std::string text(needed, ' ');
  require(abut_universe_explain_json(universe, text.data(), text.size(), &needed));
  text.pop_back();
  const nlohmann::json plan = nlohmann::json::parse(text);
  std::set<std::pair<std::string, std::string>> cells;
  for (const auto& cell : plan["pairs_of_kinds"]) {
    EXPECT_TRUE(cells.emplace(cell["a"], cell["b"]).second) << "each cell once";
    examined += cell["examined"].get<std::uint64_t>();
  }
  return cells;
}

TEST(Plan, TouchesTheCellsOfTheKindsThatMeet) {
  using Cells = std::set<std::pair<std::string, std::string>>;
  const auto shapes = make_one_of_each_kind();
  Universe universe;
  std::uint64_t examined = 0;
  universe.step();
  EXPECT_EQ(cells_of(universe, examined), Cells{});
  universe.add(shapes.at(0), identity);
  universe.add(shapes.at(1), at(1, 0, 0));
  universe.step();
  EXPECT_EQ(cells_of(universe, examined), (Cells{{"sphere", "box"}}));
  universe.add(shapes.at(0), at(0, 1, 0));
  universe.add(shapes.at(1), at(1, 1, 0));
  // There, but met by nobody. A half-space has no bounds, so it is near everyone.
  for (const std::size_t kind : {2U, 4U, 5U, 6U}) {
    universe.add(shapes.at(kind), at(0, 0, -100.0 * static_cast<double>(kind)), ABUT_MOTION_STATIC);
  }
  universe.step();
  examined = 0;
  EXPECT_EQ(cells_of(universe, examined), (Cells{{"sphere", "sphere"}, {"sphere", "box"}, {"box", "box"}}));
  EXPECT_EQ(examined, universe.stats().examined_pairs) << "no pair of another cell was looked at";
  EXPECT_EQ(examined, 5U) << "all pairs of four but the one that is known";
}

}  // namespace
