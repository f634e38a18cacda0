// SPDX-License-Identifier: Apache-2.0
// Random motions: rods and boxes against oracles of their own at many times, and every kind of shape against its own
// distance. No touch may come before the interval, and at its end there must be one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string_view>
#include <vector>

import abut.capability;
import abut.math;
import abut.math.turn;
import abut.motion.impacts.convex_impact;
import abut.pairs.taken_apart.convex_part;
import abut.motion.paths.path;
import abut.motion.time_of_impact;
import abut.pairs.any_shape;
import abut.pairs.registry;

namespace {

using namespace abut;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) { testing::Test::RecordProperty("seed", static_cast<int>(seed)); }
  Real number(Real low, Real high) { return std::uniform_real_distribution<Real>(low, high)(engine_); }
  Vec3 vector(Real size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = vector(1);
      if (norm(v) > 0.1 && norm(v) < 1) {
        return UnitVec3::make(v).value();
      }
    }
  }

 private:
  std::mt19937 engine_;
};

ShapeHandle shape_of(std::string_view kind, const std::vector<Real>& parameters) {
  return make_shape(find_kind(kind).value(), parameters, {}, {}).value();
}

// Two bodies that fly at each other, mostly near enough to touch.
struct Flight {
  Path a, b;
};
Flight random_flight(Random& random, Real away, Real spin) {
  const Vec3 d = random.direction();
  const auto path = [&](const Vec3& place, const Vec3& velocity) {
    const Motion motion{velocity, random.number(0, spin) * random.direction(), random.vector(0.3), random.vector(0.5)};
    return Path::along({rotation_by(random.vector(3)), place}, random.vector(0.1), motion, 1).value();
  };
  Path a = path({0, 0, 0}, random.vector(0.3));
  Path b = path(away * d, -1.3 * away * d + random.vector(1.2));
  return {a, b};
}

Impact impact_of(const AnyShape& a, const AnyShape& b, const Flight& flight) {
  Impact out;
  EXPECT_EQ(time_of_impact({a, flight.a}, {b, flight.b}, {}, out), Outcome::ok);
  return out;
}

// The squared distance of two segments, by their interiors and all ends (Eberly 1999).
Real distance_of_segments(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v) {
  const auto to_segment = [](const Vec3& point, const Vec3& middle, const Vec3& half) {
    const Real s = std::clamp(dot(point - middle, half) / squared_norm(half), -1.0, 1.0);
    return norm(point - (middle + s * half));
  };
  Real least =
      std::min({to_segment(p + u, q, v), to_segment(p - u, q, v), to_segment(q + v, p, u), to_segment(q - v, p, u)});
  const Vec3 w = p - q;
  const Real a = dot(u, u), b = dot(u, v), c = dot(v, v), d = dot(u, w), e = dot(v, w), determinant = a * c - b * b;
  if (determinant > 0) {
    const Real s = (b * e - c * d) / determinant, t = (a * e - b * d) / determinant;
    if (std::fabs(s) <= 1 && std::fabs(t) <= 1) {
      least = std::min(least, norm(w + s * u - t * v));
    }
  }
  return least;
}

// The largest gap along the normals of faces and the products of edges (Gottschalk 1996).
Real gap_of_boxes(const Vec3& half_a, const Pose& a, const Vec3& half_b, const Pose& b) {
  const std::array<Vec3, 3> axes_a{a.rotation.x, a.rotation.y, a.rotation.z};
  const std::array<Vec3, 3> axes_b{b.rotation.x, b.rotation.y, b.rotation.z};
  Real largest = -infinity;
  const auto try_axis = [&](const Vec3& axis) {
    if (norm(axis) < 1e-6) {
      return;
    }
    Real reach = 0;
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      reach += half_a[i] * std::fabs(dot(axes_a[at], axis)) + half_b[i] * std::fabs(dot(axes_b[at], axis));
    }
    largest = std::max(largest, (std::fabs(dot(b.position - a.position, axis)) - reach) / norm(axis));
  };
  for (const Vec3& of_a : axes_a) {
    try_axis(of_a);
    for (const Vec3& of_b : axes_b) {
      try_axis(cross(of_a, of_b));
    }
  }
  std::ranges::for_each(axes_b, try_axis);
  return largest;
}

// gap(time): of an oracle, positive where the two are apart.
template <class Gap>
void judge(const Impact& found, int samples, Real rounding, Gap&& gap, int number) {
  const Real free = found.state == ImpactState::apart ? 1 : found.lower;
  for (int k = 0; k <= samples; ++k) {
    EXPECT_GT(gap(free * k / samples), -rounding) << number;
  }
  if (found.state == ImpactState::touches) {
    EXPECT_LE(gap(found.upper), 1e-11) << number;
    EXPECT_LE(found.contact.upper, 1e-11) << number;
  }
}

struct Counts {
  int touches = 0, undecided = 0;
  std::uint32_t most_rounds = 0;
  std::uint64_t rounds = 0;

  void add(const Impact& found) {
    touches += found.state == ImpactState::touches ? 1 : 0;
    undecided += found.state == ImpactState::undecided ? 1 : 0;
    most_rounds = std::max(most_rounds, found.rounds);
    rounds += found.rounds;
  }
};

TEST(RandomImpacts, MissNoneOfTenThousandSpinningRods) {
  Random random(11);
  Counts counts;
  const ShapeHandle rod = shape_of("capsule", {0.05, 1});
  for (int i = 0; i < 10'000; ++i) {
    const Flight flight = random_flight(random, 2.2, 2.5);
    const Impact found = impact_of(rod, rod, flight);
    counts.add(found);
    judge(
        found, 100, 1e-13,
        [&](Real time) {
          const Pose a = flight.a.at(time), b = flight.b.at(time);
          return distance_of_segments(a.position, a.rotation.z, b.position, b.rotation.z) - 0.1;
        },
        i);
  }
  EXPECT_GT(counts.touches, 3000);
  EXPECT_EQ(counts.undecided, 0);
  EXPECT_LT(counts.rounds, 80'000u);
}

TEST(RandomImpacts, HoldForBoxes) {
  Random random(12);
  Counts counts;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 half_a{random.number(0.05, 1), random.number(0.05, 1), random.number(0.05, 1)};
    const Vec3 half_b{random.number(0.05, 1), random.number(0.05, 1), random.number(0.05, 1)};
    const Flight flight = random_flight(random, 3.5, 4);
    const Impact found = impact_of(shape_of("box", {half_a.x, half_a.y, half_a.z}),
                                   shape_of("box", {half_b.x, half_b.y, half_b.z}), flight);
    counts.add(found);
    judge(
        found, 100, 1e-13,
        [&](Real time) { return gap_of_boxes(half_a, flight.a.at(time), half_b, flight.b.at(time)); }, i);
  }
  EXPECT_GT(counts.touches, 1000);
  EXPECT_EQ(counts.undecided, 0);
}

// What a look along one direction proves holds at many times, and it often proves all.
TEST(RandomImpacts, ComeNoSoonerThanALookProves) {
  Random random(16);
  int apart = 0, passing = 0, begun = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 half_a{random.number(0.05, 0.4), random.number(0.05, 0.4), random.number(0.05, 0.4)};
    const Vec3 half_b{random.number(0.05, 0.4), random.number(0.05, 0.4), random.number(0.05, 0.4)};
    const ShapeHandle a = shape_of("box", {half_a.x, half_a.y, half_a.z}),
                      b = shape_of("box", {half_b.x, half_b.y, half_b.z});
    const Flight flight = random_flight(random, 3.5, 1);
    const Real margin = random.number(0, 0.1);
    const ConvexPart part_a = ConvexPart::of(a).value(), part_b = ConvexPart::of(b).value();
    const Pose own = Pose::identity(), end_a = flight.a.at(1), end_b = flight.b.at(1);
    const Real free = free_until({part_a, flight.a, flight.a.reach_of(part_a.aabb(own)), end_a},
                                 {part_b, flight.b, flight.b.reach_of(part_b.aabb(own)), end_b}, margin);
    for (int k = 0; k <= 100; ++k) {
      const Real time = free * k / 100;
      EXPECT_TRUE(free == 0 || gap_of_boxes(half_a, flight.a.at(time), half_b, flight.b.at(time)) > margin - 1e-13)
          << i;
    }
    Impact found;
    ASSERT_EQ(time_of_impact({a, flight.a}, {b, flight.b}, {.margin = margin}, found), Outcome::ok);
    apart += found.state == ImpactState::apart ? 1 : 0;
    passing += free == 1 ? 1 : 0;
    begun += free > 0 ? 1 : 0;
  }
  EXPECT_GT(begun, 1900);
  EXPECT_GT(4 * passing, apart);
}

TEST(RandomImpacts, AreTheSameSwappedAndOnAMovingGround) {
  Random random(13);
  const ShapeHandle a = shape_of("box", {1, 0.3, 0.1}), b = shape_of("capsule", {0.2, 0.5});
  for (int i = 0; i < 500; ++i) {
    const Flight flight = random_flight(random, 2.5, 3);
    const Impact found = impact_of(a, b, flight), swapped = impact_of(b, a, {flight.b, flight.a});
    EXPECT_EQ(found.state, swapped.state);
    EXPECT_EQ(found.lower, swapped.lower);
    EXPECT_EQ(found.upper, swapped.upper);
    EXPECT_EQ(found.contact.point_a, swapped.contact.point_b);
    EXPECT_EQ(found.contact.normal, -swapped.contact.normal);
    // A ground that moves fast: only digits are lost.
    const Vec3 shift = random.vector(10), speed = random.vector(10), push = random.vector(10);
    const auto carried = [&](const Path& path) {
      Motion motion = path.motion();
      motion.velocity += speed;
      motion.acceleration += push;
      const Pose start{path.start().rotation, path.start().position + shift};
      const Vec3 centre = path.start().rotation.undo(path.centre_at(0) - path.start().position);
      return Path::along(start, centre, motion, 1).value();
    };
    const Impact moved = impact_of(a, b, {carried(flight.a), carried(flight.b)});
    EXPECT_EQ(found.state, moved.state) << i;
    EXPECT_NEAR(found.upper, moved.upper, 1e-6) << i;
  }
}

// The second half of a motion begins where the first one ends.
TEST(RandomImpacts, AreTheSameInTwoHalves) {
  Random random(14);
  const ShapeHandle a = shape_of("box", {0.8, 0.3, 0.1}), b = shape_of("box", {0.2, 0.5, 0.4});
  int later = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 d = random.direction();
    const Pose start_a{rotation_by(random.vector(3)), {0, 0, 0}}, start_b{rotation_by(random.vector(3)), 3.0 * d};
    const Motion of_a{.angular_velocity = random.vector(2)};
    const Motion of_b{.velocity = -4.0 * d + random.vector(1), .angular_velocity = random.vector(2)};
    const auto part = [](const Pose& start, const Motion& motion, Real duration) {
      return Path::along(start, {0, 0, 0}, motion, duration).value();
    };
    const Flight whole{part(start_a, of_a, 1), part(start_b, of_b, 1)};
    const Flight first{part(start_a, of_a, 0.5), part(start_b, of_b, 0.5)};
    const Flight second{part(whole.a.at(0.5), of_a, 0.5), part(whole.b.at(0.5), of_b, 0.5)};
    const Impact found = impact_of(a, b, whole), early = impact_of(a, b, first);
    if (early.state != ImpactState::apart) {
      EXPECT_NEAR(found.upper, early.upper, 1e-6) << i;
      continue;
    }
    const Impact late = impact_of(a, b, second);
    EXPECT_EQ(late.state, found.state) << i;
    EXPECT_NEAR(found.upper, 0.5 + late.upper, 1e-6) << i;
    ++later;
  }
  EXPECT_GT(later, 100);
}

bool has_one_side(const AnyShape& shape) {
  const std::string_view kind = kind_name(shape.index());
  return kind == "height_field" || (kind == "mesh" && parameters_of(shape)[0] == 1);
}

// A box with a cavity.
ShapeHandle hollow(std::string_view hole, const std::vector<Real>& parameters) {
  const ShapeHandle block(shape_of("box", {0.6, 0.5, 0.45})), cavity(shape_of(hole, parameters));
  return make_composite(std::vector<PlacedShape>{{block, Pose::identity()}, {cavity, Pose::identity()}}).value();
}

// Bodies that fly within cavities up to the wall. Of a body with corners the outermost corner touches.
TEST(RandomImpacts, ReachTheWallsOfCavities) {
  struct Cavity {
    ShapeHandle shape;
    Real (*clearance)(const Vec3& point);
  };
  struct Body {
    ShapeHandle shape;
    std::vector<Vec3> corners;
    Real radius;
  };
  const std::array cavities{
      Cavity{hollow("sphere_hole", {0.35}), [](const Vec3& p) { return 0.35 - norm(p); }},
      Cavity{hollow("cylinder_hole", {0.3, 0.4, 0}),
             [](const Vec3& p) { return std::min(0.3 - std::hypot(p.x, p.y), 0.4 - std::fabs(p.z)); }},
      Cavity{hollow("box_hole", {0.4, 0.3, 0.35, 0}), [](const Vec3& p) {
               return std::min({0.4 - std::fabs(p.x), 0.3 - std::fabs(p.y), 0.35 - std::fabs(p.z)});
             }}};
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back({(i & 1) != 0 ? 0.1 : -0.1, (i & 2) != 0 ? 0.05 : -0.05, (i & 4) != 0 ? 0.07 : -0.07});
  }
  const std::array bodies{Body{shape_of("sphere", {0.1}), {{0, 0, 0}}, 0.1},
                          Body{shape_of("capsule", {0.05, 0.08}), {{0, 0, 0.08}, {0, 0, -0.08}}, 0.05},
                          Body{shape_of("box", {0.1, 0.05, 0.07}), corners, 0}};
  Random random(17);
  Counts counts;
  for (int i = 0; i < 400; ++i) {
    for (const Cavity& cavity : cavities) {
      for (const Body& body : bodies) {
        const auto path = [&](const Vec3& place, Real speed) {
          const Motion motion{random.vector(speed), random.vector(2), random.vector(speed), random.vector(1)};
          return Path::along({rotation_by(random.vector(3)), place}, {0, 0, 0}, motion, 1).value();
        };
        const Flight flight{path({0, 0, 0}, 0.2), path(random.vector(0.1), random.number(0.1, 20))};
        const Impact found = impact_of(cavity.shape, body.shape, flight);
        counts.add(found);
        const auto gap = [&](Real time) {
          Real least = infinity;
          for (const Vec3& corner : body.corners) {
            least = std::min(least, cavity.clearance(flight.a.at(time).undo(flight.b.at(time) * corner)));
          }
          return least - body.radius;
        };
        EXPECT_NE(found.state, ImpactState::starts_together);
        judge(found, 32, 1e-13, gap, i);
        EXPECT_EQ(found.lower, found.upper) << i;
      }
    }
  }
  EXPECT_GT(counts.touches, 1000);
  EXPECT_EQ(counts.undecided, 0);
}

// The samples of each kind with those of all others. Its own distance judges: whether the steps are right, not whether
// the distance is. Its lower bound tells no touch: it may know less than the shape.
TEST(RandomImpacts, HoldForAllKinds) {
  Random random(15);
  Counts counts;
  int asked = 0, seen_free = 0;
  const auto meet = [&](const AnyShape& a, const AnyShape& b) {
    const auto radius_of = [](const AnyShape& shape) {
      const Aabb box = aabb_of(shape, Pose::identity());
      return box.is_bounded() ? std::max(norm(box.low), norm(box.high)) : 1;
    };
    const Real size = radius_of(a) + radius_of(b);
    if (size > 10) {
      return;
    }
    const Flight flight = random_flight(random, 1.1 * size, 2);
    Impact found;
    const Outcome outcome = time_of_impact({a, flight.a}, {b, flight.b}, {.tolerance = 1e-4 * size}, found);
    if (outcome == Outcome::unsupported) {
      return;
    }
    ASSERT_EQ(outcome, Outcome::ok);
    ++asked;
    if (found.is_seen_free) {
      ++seen_free;
    } else {
      counts.add(found);
    }
    const auto gap = [&](Real time) {
      Distance distance{};
      EXPECT_EQ(pair_distance(a, b, flight.a.at(time), flight.b.at(time), {}, distance), Outcome::ok);
      return distance;
    };
    if (found.state == ImpactState::starts_together) {
      EXPECT_LE(gap(0).upper, 2e-4 * size) << kind_name(a.index()) << ' ' << kind_name(b.index());
      return;
    }
    if (has_one_side(a) || has_one_side(b)) {
      return;  // lets through what comes from behind
    }
    constexpr int samples = 8;
    for (int k = 0; k < samples; ++k) {
      EXPECT_GT(gap(found.lower * k / samples).upper, -1e-8 * size) << kind_name(a.index()) << kind_name(b.index());
    }
    if (found.state == ImpactState::touches) {
      EXPECT_LE(gap(found.upper).upper, 2e-4 * size) << kind_name(a.index()) << ' ' << kind_name(b.index());
    }
  };
  std::vector<ShapeHandle> kinds, of_forms;
  [&]<std::size_t... Places>(std::index_sequence<Places...>) {
    (
        [&] {
          for (auto& sample : Shapes::At<Places>::samples()) {
            const ShapeHandle shape(std::move(sample));
            (kind_of(shape) == shape->index() ? kinds : of_forms).push_back(shape);
          }
        }(),
        ...);
  }(std::make_index_sequence<Shapes::count>{});
  kinds.insert(kinds.end(), of_forms.begin(), of_forms.end());
  kinds.push_back(hollow("sphere_hole", {0.35}));
  kinds.push_back(hollow("cylinder_hole", {0.3, 0.4, 3}));
  kinds.push_back(hollow("box_hole", {0.4, 0.3, 0.45, 12}));
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    for (std::size_t k = i; k < kinds.size(); ++k) {
      meet(kinds[i], kinds[k]);
    }
  }
  EXPECT_GT(asked, 500);
  EXPECT_GT(counts.touches, asked / 3);
  EXPECT_EQ(counts.undecided, 0);
  EXPECT_LT(20 * seen_free, asked);
}

}  // namespace
