// SPDX-License-Identifier: Apache-2.0
// Every request for memory of a call is refused in turn: the call says so, and nothing is lost but a universe in the
// middle of a step.
#include "allocations.hpp"
#include "crowd.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace abut_test;
using steady::Crowd;
using steady::RefusedAllocation;

std::uint64_t hash_of(abut_universe* universe) {
  std::uint64_t hash = 0;
  require(abut_universe_hash(universe, &hash));
  return hash;
}

struct Sizes {
  std::size_t parts = 0, geometries = 0;
  std::uint64_t revision_of_geometries = 0, revision_of_poses = 0;
  bool operator==(const Sizes&) const = default;
};
Sizes sizes_of(abut_universe* universe) {
  Sizes sizes;
  require(abut_universe_parts(universe, nullptr, 0, &sizes.parts));
  require(abut_universe_geometries(universe, nullptr, 0, &sizes.geometries));
  abut_revision revision{};
  require(abut_universe_revision(universe, &revision));
  sizes.revision_of_geometries = revision.geometries;
  sizes.revision_of_poses = revision.poses;
  return sizes;
}

abut_universe_options all_events() {
  abut_universe_options options = default_universe_options();
  options.events = ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST | ABUT_EVENTS_CONTACTS;
  return options;
}

using Detection = std::function<abut_status(abut_universe*)>;

// How many requests were refused before one call was granted all of its own.
std::size_t refuse_each(const Detection& detect) {
  for (std::size_t refused = 0;; ++refused) {
    Crowd crowd(all_events(), steady::make_moving_shapes(), 2);
    abut_universe* const universe = crowd.universe();
    abut_status status = ABUT_OK;
    {
      RefusedAllocation refusal(refused);
      status = detect(universe);
    }
    if (status == ABUT_OK) {
      return refused;
    }
    EXPECT_EQ(status, ABUT_OUT_OF_MEMORY);
    EXPECT_EQ(abut_universe_step(crowd.universe(), 0), ABUT_INTERNAL);
    const abut_contact* contacts = nullptr;
    std::size_t count = 0;
    EXPECT_EQ(abut_universe_contacts(crowd.universe(), &contacts, &count), ABUT_INTERNAL);
  }
}

TEST(OutOfMemory, EndsAUniverseInTheMiddleOfAStep) {
  EXPECT_GT(refuse_each([](abut_universe* universe) { return abut_universe_step(universe, 0.1); }), 20U);
}

TEST(OutOfMemory, EndsAUniverseInTheMiddleOfARefresh) {
  EXPECT_GT(refuse_each([](abut_universe* universe) { return abut_universe_refresh(universe); }), 5U);
}

// A change that is refused and then granted leaves what it would have left at once. What it needs is made ready before.
using Call = std::function<abut_status()>;
struct Change {
  const char* name;
  std::function<Call(const Crowd&)> prepare;
};

// A geometry of a shape that the call which edits it has to copy, since `held` is another holder.
struct Shared {
  Shared(const Crowd& crowd, Shape shape) : held(std::move(shape)) {
    const abut_part_id part = crowd.parts().front();
    require(abut_geometry_create(crowd.universe(), part, held, nullptr, &geometry));
  }
  Shape held;
  abut_geometry_id geometry{};
};

std::vector<Change> edits() {
  return {
      {"geometry_set_shape",
       [](const Crowd& crowd) -> Call {
         const auto shared = std::make_shared<Shared>(crowd, make_box(1, 1, 1));
         const auto ball = std::make_shared<Shape>(make_sphere(0.8));
         return [&crowd, shared, ball] { return abut_geometry_set_shape(crowd.universe(), shared->geometry, *ball); };
       }},
      {"geometry_set_parameters",
       [](const Crowd& crowd) -> Call {
         const auto shared = std::make_shared<Shared>(crowd, make_box(1, 1, 1));
         return [&crowd, shared, sizes = std::array<double, 3>{0.5, 2, 1}] {
           return abut_geometry_set_parameters(crowd.universe(), shared->geometry, sizes.data(), sizes.size());
         };
       }},
      {"geometries_set_parameters",
       [](const Crowd& crowd) -> Call {
         const auto one = std::make_shared<Shared>(crowd, make_box(1, 1, 1));
         const auto other = std::make_shared<Shared>(crowd, make_box(1, 1, 1));
         one->held = Shape();
         return [&crowd, one, other, sizes = std::array<double, 6>{0.5, 2, 1, 2, 1, 0.5}] {
           const std::array ids{one->geometry, other->geometry};
           return abut_geometries_set_parameters(crowd.universe(), ids.data(), sizes.data(), 3, 2);
         };
       }},
      {"geometry_set_heights",
       [](const Crowd& crowd) -> Call {
         const auto shared = std::make_shared<Shared>(crowd, make_terrain(8, 0.5));
         return [&crowd, shared, heights = std::array<double, 4>{0.5, 1, 1, 0.5}] {
           return abut_geometry_set_heights(crowd.universe(), shared->geometry, 2, 3, 2, 2, heights.data());
         };
       }},
      {"geometry_set_particles",
       [](const Crowd& crowd) -> Call {
         const auto shared = std::make_shared<Shared>(crowd, make_of_kind("particles", {0.5}, {0, 0, 0, 1, 0, 0}));
         return [&crowd, shared, xyz = std::array<double, 3>{0, 1, 0}] {
           return abut_geometry_set_particles(crowd.universe(), shared->geometry, 1, xyz.data(), nullptr, 1);
         };
       }},
      {"geometry_set_vertices",
       [](const Crowd& crowd) -> Call {
         const auto shared = std::make_shared<Shared>(crowd, make_square_mesh(1));
         return [&crowd, shared, xyz = std::array<double, 3>{-1, -1, 1}] {
           return abut_geometry_set_vertices(crowd.universe(), shared->geometry, 0, xyz.data(), 1);
         };
       }},
      {"geometry_remove_triangles",
       [](const Crowd& crowd) -> Call {
         const auto shared = std::make_shared<Shared>(crowd, make_square_mesh(1));
         return [&crowd, shared, first = std::uint32_t{0}] {
           return abut_geometry_remove_triangles(crowd.universe(), shared->geometry, &first, 1);
         };
       }},
      {"geometry_set_mesh",
       [](const Crowd& crowd) -> Call {
         const auto shared = std::make_shared<Shared>(crowd, make_square_mesh(1));
         return [&crowd, shared, xyz = std::array<double, 9>{0, 0, 0, 1, 0, 0, 0, 1, 0},
                 triangle = std::array<std::uint32_t, 3>{0, 1, 2}] {
           return abut_geometry_set_mesh(crowd.universe(), shared->geometry, xyz.data(), 3, triangle.data(), 1);
         };
       }},
  };
}

std::vector<Change> changes_of_parts_and_geometries() {
  return {
      {"part_create",
       [](const Crowd& crowd) -> Call {
         return [&crowd] {
           abut_part_id part;
           return abut_part_create(crowd.universe(), nullptr, &part);
         };
       }},
      {"parts_destroy",
       [](const Crowd& crowd) -> Call {
         return [&crowd] { return abut_parts_destroy(crowd.universe(), crowd.parts().data(), 3); };
       }},
      {"parts_set_poses",
       [](const Crowd& crowd) -> Call {
         return [&crowd, poses = std::vector<abut_pose>(4, at(0.3, 0.4, 0.5))] {
           return abut_parts_set_poses(crowd.universe(), crowd.parts().data(), poses.data(), poses.size());
         };
       }},
      {"geometries_create",
       [](const Crowd& crowd) -> Call {
         const auto ball = std::make_shared<Shape>(make_sphere(0.8));
         return [&crowd, ball, shapes = std::vector<const abut_shape*>(5, *ball)] {
           std::array<abut_geometry_id, 5> out;
           return abut_geometries_create(crowd.universe(), crowd.parts().data(), shapes.data(), nullptr, shapes.size(),
                                         out.data());
         };
       }},
      {"rule_set",
       [](const Crowd& crowd) -> Call {
         return [&crowd] {
           const abut_part_id part = crowd.parts().front();
           const abut_collidable a{ABUT_COLLIDABLE_PART, part.slot, part.generation}, any{ABUT_COLLIDABLE_ANY, 0, 0};
           return abut_rule_set(crowd.universe(), &a, &any, ABUT_RULE_DISABLE);
         };
       }},
      {"policy_set",
       [](const Crowd& crowd) -> Call {
         return [&crowd] {
           abut_policy policy = default_policy();
           policy.detail = ABUT_DETAIL_POINT;
           return abut_policy_set(crowd.universe(), 0, 0, &policy);
         };
       }},
      {"part_set_sleep",
       [](const Crowd& crowd) -> Call {
         return [&crowd] {
           const abut_sleep sleep = default_sleep();
           return abut_part_set_sleep(crowd.universe(), crowd.parts().front(), &sleep);
         };
       }},
      {"universe_set_focus",
       [](const Crowd& crowd) -> Call {
         return [&crowd] {
           const abut_focus focus = make_focus(0, 1, 0, 0);
           const abut_vec3 centre{0, 0, 0};
           return abut_universe_set_focus(crowd.universe(), &focus, &centre, 1);
         };
       }},
      {"geometries_park",
       [](const Crowd& crowd) -> Call {
         std::vector<abut_geometry_id> geometries(4);
         std::size_t count = 0;
         require(abut_universe_geometries(crowd.universe(), nullptr, 0, &count));
         geometries.resize(count);
         require(abut_universe_geometries(crowd.universe(), geometries.data(), geometries.size(), &count));
         return [&crowd, geometries] {
           return abut_geometries_park(crowd.universe(), geometries.data(), 4, ABUT_PARKING_LONG_TERM);
         };
       }},
      {"parts_set_motions",
       [](const Crowd& crowd) -> Call {
         using Motions = std::array<abut_motion, 3>;
         return [&crowd, motions = Motions{ABUT_MOTION_STATIC, ABUT_MOTION_ANIMATED, ABUT_MOTION_STATIC}] {
           return abut_parts_set_motions(crowd.universe(), crowd.parts().data(), motions.data(), motions.size());
         };
       }},
      {"geometries_unpark",
       [](const Crowd& crowd) -> Call {
         std::vector<abut_geometry_id> geometries(4);
         std::size_t count = 0;
         static_cast<void>(abut_universe_geometries(crowd.universe(), geometries.data(), geometries.size(), &count));
         require(abut_geometries_park(crowd.universe(), geometries.data(), 4, ABUT_PARKING_LONG_TERM));
         return [&crowd, geometries] {
           return abut_geometries_park(crowd.universe(), geometries.data(), 4, ABUT_PARKING_NONE);
         };
       }},
  };
}

std::vector<Change> changes() {
  std::vector<Change> all = changes_of_parts_and_geometries();
  for (Change& edit : edits()) {
    all.push_back(std::move(edit));
  }
  return all;
}

class RefusedChange : public testing::TestWithParam<std::size_t> {};

TEST_P(RefusedChange, ChangesNothing) {
  const Change change = changes().at(GetParam());
  SCOPED_TRACE(change.name);
  Crowd granted(all_events(), steady::make_moving_shapes(), 2);
  granted.step();
  require(change.prepare(granted)());
  granted.step();
  Crowd refused(all_events(), steady::make_moving_shapes(), 2);
  refused.step();
  const Call call = change.prepare(refused);
  const Sizes before = sizes_of(refused.universe());
  std::size_t refusals = 0;
  for (abut_status status = ABUT_OUT_OF_MEMORY; status != ABUT_OK; ++refusals) {
    {
      RefusedAllocation refusal(refusals);
      status = call();
    }
    if (status != ABUT_OK) {
      ASSERT_EQ(status, ABUT_OUT_OF_MEMORY);
      EXPECT_EQ(sizes_of(refused.universe()), before);
    }
  }
  refused.step();
  EXPECT_EQ(hash_of(refused.universe()), hash_of(granted.universe()));
}

INSTANTIATE_TEST_SUITE_P(Every, RefusedChange, testing::Range(std::size_t{0}, changes().size()),
                         [](const auto& each) { return std::string(changes().at(each.param).name); });

// A large surface.
struct Buffers {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
};
Buffers make_large_buffers() {
  constexpr std::uint32_t side = 120;
  Buffers out;
  for (std::uint32_t j = 0; j < side; ++j) {
    for (std::uint32_t i = 0; i < side; ++i) {
      out.xyz.insert(out.xyz.end(), {0.1 * i, 0.1 * j, i % 3 == 0 ? 0.1 : 0.0});
      if (i + 1 < side && j + 1 < side) {
        const std::uint32_t a = j * side + i;
        out.triangles.insert(out.triangles.end(), {a, a + 1, a + side, a + 1, a + side + 1, a + side});
      }
    }
  }
  return out;
}

// An edit that is refused leaves no copy of what is shared behind.
using EditOf = std::function<abut_status(abut_universe*, abut_geometry_id)>;
void expect_shared_until_granted(const Shape& shape, const EditOf& edit) {
  Crowd crowd(all_events(), steady::make_moving_shapes(), 2);
  abut_geometry_id geometry{};
  require(abut_geometry_create(crowd.universe(), crowd.parts().front(), shape, nullptr, &geometry));
  crowd.step();
  const std::size_t before = steady::live_bytes();
  std::size_t refusals = 0;
  for (abut_status status = ABUT_OUT_OF_MEMORY; status != ABUT_OK; ++refusals) {
    {
      RefusedAllocation refusal(refusals);
      status = edit(crowd.universe(), geometry);
    }
    if (status != ABUT_OK) {
      ASSERT_EQ(status, ABUT_OUT_OF_MEMORY);
      EXPECT_LT(steady::live_bytes(), before + 100000) << "after " << refusals << " requests";
    }
  }
  EXPECT_GT(refusals, 5U);
  EXPECT_GT(steady::live_bytes(), before + 500000);  // the copy
}

TEST(OutOfMemory, LeavesSharedShapesShared) {
  const Buffers given = make_large_buffers();
  const std::size_t vertices = given.xyz.size() / 3, triangles = given.triangles.size() / 3;
  abut_shape *mesh = nullptr, *grid = nullptr;
  require(abut_mesh_create(given.xyz.data(), vertices, given.triangles.data(), triangles, nullptr, &mesh));
  require(abut_uv_grid_create(given.xyz.data(), vertices, given.triangles.data(), triangles, nullptr, &grid));
  const Shape held_mesh(mesh), held_grid(grid);
  Buffers more = given;
  more.xyz.insert(more.xyz.end(), {0, 0, 1});
  more.triangles.insert(more.triangles.end(), {0, 1, static_cast<std::uint32_t>(vertices)});
  expect_shared_until_granted(held_mesh, [&](abut_universe* universe, abut_geometry_id geometry) {
    return abut_geometry_set_mesh(universe, geometry, more.xyz.data(), vertices + 1, more.triangles.data(),
                                  triangles + 1);
  });
  const std::array<double, 3> lifted{0, 0, 0.05};
  expect_shared_until_granted(held_grid, [&](abut_universe* universe, abut_geometry_id geometry) {
    return abut_geometry_set_vertices(universe, geometry, 0, lifted.data(), 1);
  });
}

// A query that fails for lack of memory writes nothing.
template <class Answer, class Ask>
void expect_untouched(std::size_t least, const Ask& ask) {
  for (std::size_t refused = 0;; ++refused) {
    OutArray<Answer> out(3);
    abut_status status = ABUT_OK;
    {
      RefusedAllocation refusal(refused);
      status = ask(out.data());
    }
    if (status == ABUT_OK) {
      EXPECT_GE(refused, least) << "requests";
      return;
    }
    ASSERT_EQ(status, ABUT_OUT_OF_MEMORY);
    EXPECT_TRUE(out.is_untouched()) << "after " << refused << " requests";
  }
}

TEST(OutOfMemory, LeavesTheAnswersOfMovementsAlone) {
  if (abut_has_feature("motion") == 0) GTEST_SKIP() << "needs the feature motion";
  const Shape first = make_of_kind("cylinder", {0.5, 0.5}), second = make_of_kind("ellipsoid", {1, 2, 3});
  const abut_pose from = at(-9, 0, 0);
  const abut_movement ahead{{9, 0, 0}, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, still{};
  expect_untouched<abut_impact>(0, [&](abut_impact* out) {
    return abut_pair_time_of_impact(first, &from, &ahead, second, &identity, &still, 1, nullptr, out);
  });
  Universe universe;
  for (int i = 0; i < 3; ++i) universe.add(second, at(0, 10 * i, 0));
  require(abut_universe_refresh(universe));
  const std::array<const abut_shape*, 3> shapes{first, first, first};
  const std::array<abut_pose, 3> poses{at(-9, 0, 0), at(-9, 10, 0), at(-9, 20, 0)};
  const std::array<abut_movement, 3> movements{ahead, ahead, ahead};
  expect_untouched<abut_impact_hit>(3, [&](abut_impact_hit* out) {
    return abut_universe_cast_movements(universe, shapes.data(), poses.data(), movements.data(), 3, 1, nullptr, nullptr,
                                        out);
  });
}

}  // namespace
