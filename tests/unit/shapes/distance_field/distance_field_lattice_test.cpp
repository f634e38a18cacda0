// SPDX-License-Identifier: Apache-2.0
// Distance fields that a lattice bends. They are judged by maps written out here: forward alone, so that a place is
// compared with the point at rest that came there.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "../field_grid.hpp"
#include "../surface_checks.hpp"

import abut.capability;
import abut.math;
import abut.shapes.distance_field;

namespace {

using abut::DistanceField;
using abut::Vec3;
using test::even;
using test::from_ball;
using test::from_torus;
using test::Grid;
using test::uneven;

// Points of a lattice over a grid around the origin, and places between them.
struct Lattice {
  std::array<std::uint32_t, 3> counts;
  Vec3 half;
  std::vector<Vec3> points{};

  Lattice(const Grid& grid, std::array<std::uint32_t, 3> along)
      : counts(along),
        half{0.5 * (grid.counts[0] - 1) * grid.spacing[0], 0.5 * (grid.counts[1] - 1) * grid.spacing[1],
             0.5 * (grid.counts[2] - 1) * grid.spacing[2]} {}
  template <class Move>
  Lattice& moved(Move&& move) {
    points.clear();
    for (std::uint32_t k = 0; k < counts[2]; ++k) {
      for (std::uint32_t j = 0; j < counts[1]; ++j) {
        for (std::uint32_t i = 0; i < counts[0]; ++i) {
          const auto along = [](std::uint32_t at, std::uint32_t count, double by) {
            return count > 1 ? (2.0 * at / (count - 1) - 1) * by : 0;
          };
          points.push_back(
              move(Vec3{along(i, counts[0], half.x), along(j, counts[1], half.y), along(k, counts[2], half.z)}));
        }
      }
    }
    return *this;
  }
  // Of a point at rest in the grid: a mean of eight points.
  [[nodiscard]] Vec3 place_of(const Vec3& p) const {
    const std::array<double, 3> at{(p.x / half.x + 1) * 0.5 * (counts[0] - 1),
                                   (p.y / half.y + 1) * 0.5 * (counts[1] - 1),
                                   (p.z / half.z + 1) * 0.5 * (counts[2] - 1)};
    std::array<std::uint32_t, 3> cell{};
    std::array<double, 3> share{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cell.at(axis) = std::min(static_cast<std::uint32_t>(at.at(axis)), counts.at(axis) - 2);
      share.at(axis) = at.at(axis) - cell.at(axis);
    }
    Vec3 out{0, 0, 0};
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
      const std::uint32_t i = corner & 1U, j = corner >> 1 & 1U, k = corner >> 2;
      const double weight =
          (i != 0 ? share[0] : 1 - share[0]) * (j != 0 ? share[1] : 1 - share[1]) * (k != 0 ? share[2] : 1 - share[2]);
      out += weight * points.at(((cell[2] + k) * counts[1] + cell[1] + j) * counts[0] + cell[0] + i);
    }
    return out;
  }
  [[nodiscard]] std::vector<double> xyz() const {
    std::vector<double> out;
    for (const Vec3& p : points) {
      out.insert(out.end(), {p.x, p.y, p.z});
    }
    return out;
  }
};

void set(DistanceField& field, const Lattice& lattice) {
  const std::vector<double> xyz = lattice.xyz();
  const abut::LatticeEdit edit{lattice.counts[0], lattice.counts[1], lattice.counts[2], xyz};
  const abut::Fault fault = field.check(edit);
  ASSERT_FALSE(fault.has_value()) << fault->message;
  field.own();
  static_cast<void>(field.apply(edit));
}
std::string refusal(const DistanceField& field, const Lattice& lattice) {
  const std::vector<double> xyz = lattice.xyz();
  const abut::Fault fault =
      field.check(abut::LatticeEdit{lattice.counts[0], lattice.counts[1], lattice.counts[2], xyz});
  return fault ? fault->message : std::string("none");
}
Vec3 unmoved(const Vec3& p) { return p; }
// Turned about Z, the more the higher, bent to the side, and moved away.
Vec3 twisted(const Vec3& p) {
  const double angle = 0.5 * p.z, c = std::cos(angle), s = std::sin(angle);
  return {c * p.x - s * p.y + 0.15 * p.z * p.z + 0.3, s * p.x + c * p.y - 0.2, 1.2 * p.z + 0.1 * p.x};
}
// Turned by 140 degrees about Z, and stretched.
Vec3 affine(const Vec3& p) {
  const double c = std::cos(2.4), s = std::sin(2.4);
  return {1.5 * (c * p.x - s * p.y) + 1, 1.5 * (s * p.x + c * p.y) - 2, 0.8 * p.z + 0.5};
}

void expect_same(const DistanceField& a, const DistanceField& b) {
  EXPECT_EQ(a.parameters(), b.parameters());
  EXPECT_EQ(a.buffers().reals, b.buffers().reals);
  EXPECT_EQ(a.buffers().indices, b.buffers().indices);
  EXPECT_EQ(a.solid_box().low, b.solid_box().low);
  EXPECT_EQ(a.solid_box().high, b.solid_box().high);
  EXPECT_EQ(a.triangles().vertices, b.triangles().vertices);
  EXPECT_EQ(a.surface_error(), b.surface_error());
  EXPECT_EQ(a.finest(), b.finest());
  test::Random random(43);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = random.point(2);
    EXPECT_EQ(a.value_at(p).value, b.value_at(p).value);
    EXPECT_EQ(a.value_at(p).gradient, b.value_at(p).gradient);
    EXPECT_EQ(a.least_way(a.value_at(p).value), b.least_way(b.value_at(p).value));
    EXPECT_EQ(a.least_within(0, 1), b.least_within(0, 1));
  }
}

TEST(FieldLattice, PointsAtRestChangeNothing) {
  const DistanceField before = uneven.field(from_torus);
  DistanceField field = before;
  set(field, Lattice(uneven, {4, 3, 5}).moved(twisted));
  EXPECT_NE(field.value_at({0.7, 0, 0}).value, before.value_at({0.7, 0, 0}).value);
  // Points as they come of the first and the last sample.
  Lattice at_rest(uneven, {4, 3, 5});
  set(field, at_rest.moved(unmoved));
  EXPECT_NEAR(field.value_at({0.7, 0, 0}).value, before.value_at({0.7, 0, 0}).value, 1e-12);
  field.own();
  static_cast<void>(field.apply(abut::LatticeEdit{0, 0, 0, {}}));
  expect_same(field, before);
}

// Points at rest are known as such, also where they are rounded otherwise, and the answers are the same bits.
TEST(FieldLattice, TheIdentityGivesTheSameBits) {
  const Grid grid{{17, 13, 21}, {0.125, 0.25, 0.125}};
  const DistanceField before = grid.field(from_ball, false, true);
  DistanceField field = before;
  set(field, Lattice(grid, {3, 4, 5}).moved(unmoved));
  expect_same(field, before);
}

TEST(FieldLattice, ValuesAreThoseOfThePointsAtRest) {
  test::Random random(3);
  for (const bool is_smooth : {false, true}) {
    const DistanceField rest = uneven.field(from_torus, false, is_smooth);
    for (Vec3 (*move)(const Vec3&) : {twisted, affine}) {
      DistanceField field = rest;
      const Lattice lattice = Lattice(uneven, {5, 4, 6}).moved(move);
      set(field, lattice);
      for (int i = 0; i < 3000; ++i) {
        const Vec3 p{random.uniform(-1, 1) * lattice.half.x, random.uniform(-1, 1) * lattice.half.y,
                     random.uniform(-1, 1) * lattice.half.z};
        const Vec3 place = lattice.place_of(p);
        const abut::FieldValue found = field.value_at(place);
        ASSERT_NEAR(found.value, rest.value_at(p).value, 1e-12) << p.x << " " << p.y << " " << p.z;
        // The gradient tells how the value changes, but where it jumps.
        const Vec3 step = 1e-7 * random.point(1);
        const double change = field.value_at(place + step).value - field.value_at(place - step).value;
        if (is_smooth && std::fabs(change - 2 * dot(found.gradient, step)) > 1e-10) {
          const Vec3 before = field.value_at(place - step).gradient, after = field.value_at(place + step).gradient;
          EXPECT_GT(norm(before - after), 1e-5);  // a face of a cell of the lattice lies between
        }
      }
    }
  }
}

// A ball becomes an ellipsoid under an affine map, whose points are known.
TEST(FieldLattice, AnAffineLatticeMakesAnEllipsoidOfABall) {
  DistanceField field = even.field(from_ball, false, true);
  set(field, Lattice(even, {2, 3, 2}).moved(affine));
  EXPECT_NEAR(field.least_stretch(), 0.8, 1e-6);
  EXPECT_NEAR(field.most_stretch(), 1.5, 1e-6);
  const abut::Aabb box = field.aabb(abut::Pose::identity());
  EXPECT_LE(box.low.z, 0.5 - 0.8 * 0.8 + 0.03);
  EXPECT_GE(box.high.z, 0.5 + 0.8 * 0.8 - 0.03);
  test::Random random(5);
  std::vector<Vec3> surface;
  for (int i = 0; i < 20000; ++i) {
    surface.push_back(affine(0.8 * test::towards(random)));
  }
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = affine(random.point(2));
    const double value = field.value_at(p).value;
    double nearest = abut::infinity;
    for (const Vec3& other : surface) {
      nearest = std::fmin(nearest, norm(other - p));
    }
    // 0.03: how far the points lie apart, and how much smaller the smooth ball is.
    EXPECT_LE(field.least_way(value), nearest + 0.03);
  }
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    // A ray at rest is one when it is bent.
    const Vec3 from = random.point(2), to = random.point(1);
    const double along = dot(from, to - from) / norm(to - from), square = along * along - dot(from, from) + 0.64;
    if (std::fabs(square) < 0.1 || std::fabs(from_ball(from)) < 0.02) {
      continue;
    }
    const double root = square > 0 ? std::sqrt(square) : -1;
    const double truth = -along - root >= 0 ? -along - root : -along + root;
    const Vec3 origin = affine(from), target = affine(from + (1 / norm(to - from)) * (to - from));
    const auto hit = field.cast_ray(origin, abut::UnitVec3::make(target - origin).value(), abut::infinity);
    ASSERT_EQ(hit.has_value(), square > 0 && truth >= 0) << "ray " << i;
    if (hit) {
      ++hits;
      EXPECT_NEAR(hit->distance / norm(target - origin), truth, 0.01);
    }
  }
  EXPECT_GT(hits, 60);
}

TEST(FieldLattice, BoundsHoldForAllPointsAround) {
  test::Random random(7);
  for (const bool is_inside_out : {false, true}) {
    DistanceField field = uneven.field(from_torus, is_inside_out);
    const Lattice lattice = Lattice(uneven, {4, 4, 4}).moved(twisted);
    set(field, lattice);
    EXPECT_LT(field.least_stretch(), 1);
    EXPECT_GT(field.most_stretch(), 1.1);
    const abut::Aabb box = field.solid_box();
    const abut::SurfacePoints& surface = field.surface();
    int changes = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3 p = Vec3{0.3, -0.2, 0} + random.point(1.6), q = p + random.uniform(0, 1) * random.point(0.4);
      const double value = field.value_at(p).value, other = field.value_at(q).value;
      ASSERT_GE(other, field.least_within(value, norm(p - q)) - 1e-9);
      if ((value < 0) != (other < 0)) {
        ++changes;
        ASSERT_LE(field.least_way(value), norm(p - q) + 1e-9);
      }
      if (is_inside_out ? value > 0 : value < 0) {
        ASSERT_TRUE(box.overlaps({p, p}));
      }
    }
    EXPECT_GT(changes, 100);
    for (const Vec3& point : surface.points) {
      EXPECT_NEAR(field.value_at(point).value, 0, 1e-5);
    }
    for (const abut::SurfacePoints::Run& run : surface.runs) {
      for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
        EXPECT_TRUE(run.box.overlaps({surface.points[i], surface.points[i]}));
      }
    }
  }
}

TEST(FieldLattice, RaysMeetTheFirstChangeOfSign) {
  test::Random random(11);
  DistanceField field = uneven.field(from_torus, false, true);
  set(field, Lattice(uneven, {4, 4, 4}).moved(twisted));
  int hits = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 origin = Vec3{0.3, -0.2, 0} + random.point(1.5);
    const auto direction = abut::UnitVec3::make(Vec3{0.3, -0.2, 0} + random.point(0.8) - origin).value();
    const double step = 1e-3;
    double first = abut::infinity, before = field.value_at(origin).value;
    for (double way = step; way < 5 && first == abut::infinity; way += step) {
      const double value = field.value_at(origin + way * direction.vec()).value;
      first = (value < 0) != (before < 0) ? way : first;
      before = value;
    }
    const auto hit = field.cast_ray(origin, direction, abut::infinity);
    if (first < abut::infinity) {
      ASSERT_TRUE(hit.has_value()) << "ray " << i;
      EXPECT_LE(hit->distance, first + 1e-9) << "ray " << i;
    }
    if (hit) {
      ++hits;
      EXPECT_NEAR(field.value_at(origin + hit->distance * direction.vec()).value, 0, 1e-9) << "ray " << i;
      EXPECT_FALSE(field.cast_ray(origin, direction, 0.999 * hit->distance).has_value()) << "ray " << i;
    }
  }
  EXPECT_GT(hits, 50);
}

// A bar that is bent into an arc: by so many degrees from end to end.
TEST(FieldLattice, ABarBendsByAHundredDegrees) {
  const Grid grid{{41, 11, 11}, {0.1, 0.1, 0.1}};
  const DistanceField bar = grid.field([](const Vec3& p) {
    return std::fmax(std::fabs(p.x) - 1.8, std::fmax(std::fabs(p.y) - 0.2, std::fabs(p.z) - 0.2));
  });
  const auto bent_by = [&](double degrees) {
    const double turn = degrees * 3.14159265358979323846 / 180 / 4, radius = 1 / turn;  // for each unit of four
    return Lattice(grid, {9, 2, 2}).moved([&](const Vec3& p) {
      const double angle = turn * p.x, away = radius - p.y;
      return Vec3{away * std::sin(angle), radius - away * std::cos(angle), p.z};
    });
  };
  DistanceField field = bar;
  set(field, bent_by(100));
  // The middle stays where it is, and the ends come up.
  EXPECT_NEAR(field.value_at({0, 0.1, 0}).value, -0.1, 0.02);
  const double turn = 100 * 3.14159265358979323846 / 180 / 4;
  EXPECT_NEAR(field.value_at({std::sin(1.7 * turn) / turn, (1 - std::cos(1.7 * turn)) / turn, 0}).value, -0.1, 0.02);
  EXPECT_GT(field.value_at({1.7, 0, 0}).value, 0.1);
  EXPECT_NE(refusal(bar, bent_by(200)), "none");
}

// Beyond the grid space goes on, so places far away have values as well, which are no longer than ways.
TEST(FieldLattice, PlacesBeyondTheGridHaveValues) {
  DistanceField field = even.field(from_ball);
  set(field, Lattice(even, {3, 3, 3}).moved(twisted));
  test::Random random(13);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = random.point(30);
    const double value = field.value_at(p).value;
    const double away = norm(p - Vec3{0.3, -0.2, 0});
    if (away > 4) {
      EXPECT_GT(value, 0);
      EXPECT_LE(field.least_way(value), away);
      EXPECT_GE(field.least_way(value), field.least_stretch() / field.most_stretch() * (away - 2));
    }
  }
}

TEST(FieldLattice, WhatFoldsSpaceIsRefused) {
  DistanceField field = even.field(from_ball);
  const DistanceField before = field;
  Lattice lattice(even, {3, 3, 3});
  const std::string folds =
      "xyz bends space too much: edges must not turn by 90 degrees from the average, nor shrink to a fiftieth";
  // Pulled through its neighbour; turned inside out; flat; twisted by half a turn.
  lattice.moved(unmoved).points[13].x += 1.5;
  EXPECT_EQ(refusal(field, lattice), folds);
  EXPECT_EQ(refusal(field, lattice.moved([](const Vec3& p) { return Vec3{-p.x, p.y, p.z}; })), folds);
  EXPECT_EQ(refusal(field, lattice.moved([](const Vec3& p) { return Vec3{p.x, p.y, 0}; })), folds);
  EXPECT_EQ(refusal(field, lattice.moved([](const Vec3& p) {
              const double angle = 1.6 * p.z;
              return Vec3{std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y,
                          p.z};
            })),
            folds);
  lattice.moved(unmoved).points[5].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(field, lattice), "xyz[16] is nan; it must be finite");
  EXPECT_EQ(refusal(field, Lattice(even, {3, 1, 3}).moved(unmoved)),
            "rows is 1; it must be from 2 to 64, or 0 as all of them");
  EXPECT_EQ(refusal(field, Lattice(even, {65, 2, 2}).moved(unmoved)),
            "columns is 65; it must be from 2 to 64, or 0 as all of them");
  expect_same(field, before);
}

TEST(FieldLattice, BuffersMakeTheSameFieldAgain) {
  for (const bool is_smooth : {false, true}) {
    DistanceField field = uneven.field(from_torus, false, is_smooth);
    set(field, Lattice(uneven, {4, 3, 5}).moved(twisted));
    const abut::Buffers buffers = field.buffers();
    expect_same(field, test::made<DistanceField>(field.parameters(), buffers.reals, buffers.indices));
  }
}

// In whatever order values and points come.
TEST(FieldLattice, EditsOfValuesAndPointsGoTogether) {
  std::vector<double> values = uneven.values(from_torus);
  DistanceField field = test::made<DistanceField>(uneven.parameters(), values), other = field;
  const Lattice lattice = Lattice(uneven, {4, 3, 5}).moved(twisted);
  std::vector<double> changed;
  for (std::size_t k = 30; k < 36; ++k) {
    for (std::size_t j = 15; j < 20; ++j) {
      for (std::size_t i = 20; i < 30; ++i) {
        changed.push_back(values[(k * 36 + j) * 51 + i] -= 0.3);
      }
    }
  }
  const abut::FieldEdit edit{20, 15, 30, 10, 5, 6, changed};
  field.own();
  static_cast<void>(field.apply(edit));
  set(field, lattice);
  set(other, Lattice(uneven, {2, 2, 2}).moved(affine));
  set(other, lattice);
  other.own();
  static_cast<void>(other.apply(edit));
  expect_same(field, other);
}

}  // namespace
