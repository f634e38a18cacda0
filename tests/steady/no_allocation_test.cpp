// SPDX-License-Identifier: Apache-2.0
// A step asks for no memory once its lists have grown to what the scene needs.
#include "allocations.hpp"
#include "crowd.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <random>
#include <tuple>

namespace {

using namespace abut_test;
using steady::AllocationCounter;
using steady::Allocations;
using steady::Crowd;

// Whoever counts nothing finds nothing.
TEST(AllocationCounter, SeesEveryWayToAsk) {
  const auto count = [](auto&& ask) {
    AllocationCounter counter;
    ask();
    return counter.stop().calls;
  };
  // Compilers leave out what nobody can see.
  void* volatile seen = nullptr;
  const auto keep = [&](void* block) {
    seen = block;
    return seen;
  };
  std::unique_ptr<int> one;
  std::vector<double> many;
  EXPECT_EQ(count([&] { one = std::make_unique<int>(1); }), 1U);
  EXPECT_EQ(count([&] { many.resize(1000); }), 1U);
  EXPECT_EQ(count([&] { std::free(keep(std::malloc(10))); }), 1U);
  EXPECT_EQ(count([&] { std::free(keep(std::calloc(10, 2))); }), 1U);
  EXPECT_EQ(count([&] { std::free(keep(std::realloc(keep(std::malloc(10)), 10000))); }), 2U);
  EXPECT_EQ(count([&] { std::free(keep(std::aligned_alloc(64, 640))); }), 1U);
  EXPECT_EQ(count([] {}), 0U);
  // The library itself, in a call that has to.
  Universe universe;
  EXPECT_GT(count([&] { universe.add_part(identity); }), 0U);
}

abut_universe_options options_with(abut_broadphase broadphase, std::uint32_t threads) {
  abut_universe_options options = default_universe_options();
  options.broadphase = broadphase;
  options.threads = threads;
  options.events = ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST | ABUT_EVENTS_CONTACTS;
  return options;
}

// After `warm` periods, what is asked for in three more.
Allocations count_frames(Crowd& crowd, std::size_t warm, const std::function<void(std::size_t)>& frame) {
  for (std::size_t i = 0; i < warm * Crowd::period; ++i) {
    frame(i);
  }
  EXPECT_GT(crowd.stats().contacts, crowd.parts().size()) << "a crowd that does not touch shows nothing";
  AllocationCounter counter;
  for (std::size_t i = 0; i < 3 * Crowd::period; ++i) {
    frame(i);
  }
  return counter.stop();
}

class SteadyStep : public testing::TestWithParam<std::tuple<abut_broadphase, std::uint32_t>> {
 protected:
  abut_universe_options options() const { return options_with(std::get<0>(GetParam()), std::get<1>(GetParam())); }
};

TEST_P(SteadyStep, AllocatesNothingWhereNothingMoves) {
  Crowd crowd(options(), steady::make_moving_shapes(), 6);
  const Allocations found = count_frames(crowd, 1, [&](std::size_t) { crowd.step(); });
  EXPECT_EQ(found.calls, 0U) << found.first_places;
}

TEST_P(SteadyStep, AllocatesNothingWhereBodiesMove) {
  Crowd crowd(options(), steady::make_moving_shapes(), 6);
  const Allocations found = count_frames(crowd, 4, [&](std::size_t frame) {
    crowd.move(frame);
    crowd.step();
  });
  EXPECT_EQ(found.calls, 0U) << found.first_places;
}

TEST_P(SteadyStep, AllocatesNothingWhateverTheKinds) {
  Crowd crowd(options(), steady::make_shapes_of_all_kinds(), 3);
  const Allocations found = count_frames(crowd, 2, [&](std::size_t frame) {
    crowd.move(frame);
    crowd.step();
  });
  EXPECT_EQ(found.calls, 0U) << found.first_places;
}

// Islands, velocities by poses, and a set of particles that meets itself.
TEST_P(SteadyStep, AllocatesNothingForWhatIsSwitchedOn) {
  Crowd crowd(options(), steady::make_moving_shapes(), 6);
  abut_geometry_options meets_itself = default_geometry_options();
  meets_itself.flags = ABUT_GEOMETRY_SELF_PAIRS;
  const Shape balls = make_of_kind("particles", {0.3}, {0, 0, 0, 0.5, 0, 0, 0.5, 0.5, 0});
  abut_geometry_id created{};
  require(abut_geometry_create(crowd.universe(), crowd.parts().front(), balls, &meets_itself, &created));
  require(abut_universe_follow_islands(crowd.universe(), 1));
  require(abut_parts_measure_velocities(crowd.universe(), crowd.parts().data(), crowd.parts().size()));
  const Allocations found = count_frames(crowd, 4, [&](std::size_t frame) {
    crowd.move(frame);
    require(abut_universe_step(crowd.universe(), 0.01));
    const abut_island* islands = nullptr;
    std::size_t count = 0;
    require(abut_universe_islands(crowd.universe(), &islands, &count));
  });
  EXPECT_EQ(found.calls, 0U) << found.first_places;
}

TEST_P(SteadyStep, AllocatesNothingForPartialDetections) {
  Crowd crowd(options(), steady::make_moving_shapes(), 4);
  const abut_vec3 middle = crowd.middle();
  const abut_aabb region{{0, 0, 0}, middle};
  const Allocations found = count_frames(crowd, 4, [&](std::size_t frame) {
    crowd.move(frame);
    require(abut_universe_detect_region(crowd.universe(), &region));
    require(abut_universe_detect_changed(crowd.universe()));
    require(abut_universe_detect_all(crowd.universe()));
  });
  EXPECT_EQ(found.calls, 0U) << found.first_places;
}

TEST_P(SteadyStep, AllocatesNothingToTellWhatItFound) {
  Crowd crowd(options(), steady::make_moving_shapes(), 4);
  std::uint64_t sum = 0;
  const Allocations found = count_frames(crowd, 4, [&](std::size_t frame) {
    crowd.move(frame);
    crowd.step();
    const abut_contact* contacts = nullptr;
    const abut_event* events = nullptr;
    std::size_t contact_count = 0, event_count = 0;
    std::uint64_t hash = 0;
    require(abut_universe_contacts(crowd.universe(), &contacts, &contact_count));
    require(abut_universe_events(crowd.universe(), &events, &event_count));
    require(abut_universe_hash(crowd.universe(), &hash));
    sum += contact_count + event_count + hash % 2;
  });
  EXPECT_GT(sum, 0U);
  EXPECT_EQ(found.calls, 0U) << found.first_places;
}

// Bodies that are fast have paths, and those that speculate contacts ahead of a touch.
TEST_P(SteadyStep, AllocatesNothingForBodiesThatAreFast) {
  for (const abut_geometry_flags flags : {ABUT_GEOMETRY_FAST, ABUT_GEOMETRY_SPECULATIVE}) {
    Crowd crowd(options(), steady::make_moving_shapes(), 4, flags);
    require(abut_parts_measure_velocities(crowd.universe(), crowd.parts().data(), crowd.parts().size()));
    const Allocations found = count_frames(crowd, 8, [&](std::size_t frame) {
      crowd.move(frame);
      require(abut_universe_step(crowd.universe(), 0.01));
    });
    EXPECT_EQ(found.calls, 0U) << flags << found.first_places;
  }
}

// Where a body touches two surfaces, or two boxes that are welded, their contacts are compared.
TEST_P(SteadyStep, AllocatesNothingAtSeams) {
  constexpr std::size_t bodies = 40;
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t j = 0; j < 7; ++j) {
    for (std::uint32_t i = 0; i < 7; ++i) {
      xyz.insert(xyz.end(), {static_cast<double>(i), static_cast<double>(j), 0.0});
      const std::uint32_t first = 7 * j + i;
      if (i < 6 && j < 6) {
        triangles.insert(triangles.end(), {first, first + 1, first + 8, first, first + 8, first + 7});
      }
    }
  }
  abut_shape* grid = nullptr;
  require(abut_uv_grid_create(xyz.data(), xyz.size() / 3, triangles.data(), triangles.size() / 3, nullptr, &grid));
  struct Floor {
    Shape shape;
    abut_pose place = identity;
    double least_x = -0.04;  // of bodies; further left a box meets the wall of the second one
  };
  std::vector<Floor> floors;
  floors.push_back({make_of_kind("mesh", {1}, xyz, triangles)});
  floors.push_back({Shape(grid)});
  floors.push_back({make_of_kind("height_field", {7, 7, 1, 1}, std::vector<double>(49, 0.0))});
  floors.push_back({make_box(3, 3, 3), at(3, 3, -3), -0.0495});
  for (const Floor& floor : floors) {
    abut_universe_options chosen = options();
    chosen.flags |= ABUT_UNIVERSE_WELDS;
    Universe universe(&chosen);
    abut_pose beside = floor.place;
    beside.position.x -= 6;
    universe.add(floor.shape, beside, ABUT_MOTION_STATIC);
    universe.add(floor.shape, floor.place, ABUT_MOTION_STATIC);
    const Shape box = make_box(0.05, 0.05, 0.05);
    std::vector<abut_part_id> parts;
    for (std::size_t body = 0; body < bodies; ++body) {
      parts.push_back(universe.add_part(identity));
      universe.add_geometry(parts.back(), box);
    }
    const auto step = [&](std::size_t number) {
      for (std::size_t body = 0; body < bodies; ++body) {
        universe.move(parts[body], at(0.01 * static_cast<double>((body + number) % 8) + floor.least_x,
                                      0.4 + 0.12 * static_cast<double>(body), 0.049));
      }
      require(abut_universe_step(universe, 0));
    };
    for (std::size_t i = 0; i < 16; ++i) step(i);
    EXPECT_EQ(universe.stats().touching_pairs, 2 * bodies);
    AllocationCounter counter;
    for (std::size_t i = 0; i < 16; ++i) step(i);
    const Allocations found = counter.stop();
    EXPECT_EQ(found.calls, 0U) << found.first_places;
  }
}

// Two bodies of any two kinds: a crowd may leave some pair out.
TEST(SteadyPair, AllocatesNothingWhateverItsKinds) {
  std::vector<Shape> shapes = steady::make_shapes_of_all_kinds();
  shapes.push_back(make_terrain(5, 1));
  shapes.push_back(make_of_kind("height_field", {3, 3, 1, 1, 0, 1}, std::vector<double>(9, 0)));
  shapes.push_back(make_plane({0, 0, 1}, 0));
  std::size_t touching = 0;
  for (const Shape& shape : shapes) {
    for (const Shape& other : shapes) {
      Universe universe;
      universe.add(shape, identity);
      const abut_part_id part = universe.add_part(at(0.9, 0.1, 0.2));
      universe.add_geometry(part, other);
      const auto frame = [&](std::size_t i) {
        universe.move(part, at(0.8 + 0.02 * static_cast<double>(i % 4), 0.1, 0.1));
        require(abut_universe_step(universe, 0));
      };
      for (std::size_t i = 0; i < 8; ++i) frame(i);
      AllocationCounter counter;
      for (std::size_t i = 0; i < 8; ++i) frame(i);
      const Allocations found = counter.stop();
      EXPECT_EQ(found.calls, 0U) << found.first_places;
      touching += universe.stats().touching_pairs;
    }
  }
  EXPECT_GT(2 * touching, shapes.size() * shapes.size()) << "pairs that do not touch show little";
}

// Where rounding stops the usual search another one takes over: slender triangles beside others a million times as
// large.
TEST(SteadyPair, OfSliversAsksForNothing) {
  constexpr int pairs = 500;
  constexpr double giant = 1 << 20;
  std::mt19937_64 engine(5);
  const auto number = [&] { return static_cast<double>(engine() >> 11) * 0x1p-52 - 1; };
  const auto triangle = [&](double far, double width) {
    std::vector<double> corners;
    for (int i = 0; i < 6; ++i) corners.push_back(i < 3 ? number() : far * number());
    for (int i = 0; i < 3; ++i) corners.push_back(corners[static_cast<std::size_t>(i) + 3] + width * number());
    return make_of_kind("triangle", corners);
  };
  abut_query_options options = filled_by(abut_query_options_init);
  options.algorithm = ABUT_ALGORITHM_GJK_EPA;
  std::uint64_t calls = 0;
  std::uint32_t most_iterations = 0;
  for (int i = 0; i < pairs; ++i) {
    const Shape a = triangle(1, 1), b = triangle(giant, 1e-6);
    abut_distance found;
    AllocationCounter counter;
    require(abut_pair_distance(a, &identity, b, &identity, &options, &found));
    calls += counter.stop().calls;
    most_iterations = std::max(most_iterations, found.iterations);
  }
  EXPECT_EQ(calls, 0U);
  EXPECT_GT(most_iterations, 8U) << "pairs that are easy show little";
}

// Whether two shapes overlap, whatever their kinds but distance fields: what only a search for depths can tell is not
// asked here.
TEST(SteadyPair, AsksForNothingToTellWhetherTwoOverlap) {
  std::vector<Shape> shapes = steady::make_moving_shapes();
  shapes.push_back(make_terrain(5, 1));
  shapes.push_back(make_of_kind("height_field", {3, 3, 1, 1, 0, 1}, std::vector<double>(9, 0)));
  shapes.push_back(
      make_of_kind("mesh", {2}, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}));
  std::size_t overlapping = 0, all = 0;
  const auto ask = [&](const Shape& a, const Shape& b, double offset) {
    const abut_pose there = at(offset, 0.1, 0.2);
    std::uint32_t answer = 0;
    require(abut_pair_overlaps(a, &identity, b, &there, nullptr, &answer));
    overlapping += answer;
    ++all;
  };
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      for (const double offset : {0.1, 0.9, 1.7}) ask(a, b, offset);
      AllocationCounter counter;
      for (const double offset : {0.1, 0.9, 1.7}) ask(a, b, offset);
      const Allocations found = counter.stop();
      EXPECT_EQ(found.calls, 0U) << found.first_places;
    }
  }
  EXPECT_GT(overlapping, all / 5);
  EXPECT_LT(overlapping, all);
}

// A query has no memory of its own, since many run at once: its answer is a list that it gives back when it has been
// copied.
TEST(SteadyQuery, GivesBackWhatItAsksFor) {
  Crowd crowd(default_universe_options(), steady::make_moving_shapes(), 4);
  crowd.step();
  const Shape ball = make_sphere(0.8);
  const abut_vec3 middle = crowd.middle();
  const abut_pose pose{middle, no_rotation};
  const abut_ray ray{{-3, middle.y, middle.z}, {1, 0, 0}, 100};
  std::vector<abut_geometry_id> geometries(64);
  const auto ask = [&] {
    abut_query_hit hit;
    abut_closest closest;
    std::uint32_t found = 0;
    std::size_t count = 0;
    require(abut_universe_cast_ray(crowd.universe(), &ray, nullptr, ABUT_HIT_NEAREST, &hit, 1, &count));
    EXPECT_EQ(count, 1U);
    require(abut_universe_closest(crowd.universe(), ball, &pose, 10, nullptr, &closest, &found));
    EXPECT_EQ(found, 1U);
    require(abut_universe_overlaps(crowd.universe(), ball, &pose, nullptr, 0, geometries.data(), geometries.size(),
                                   &count));
    EXPECT_GT(count, 1U);
  };
  ask();
  AllocationCounter counter;
  const std::size_t before = steady::live_bytes();
  for (int i = 0; i < 10; ++i) ask();
  counter.stop();
  EXPECT_EQ(steady::live_bytes(), before);
}

INSTANTIATE_TEST_SUITE_P(Every, SteadyStep, testing::Combine(testing::ValuesIn(broadphases), testing::Values(1U, 2U)));

}  // namespace
