// SPDX-License-Identifier: Apache-2.0
// Distance fields with tri-quadratic values. They are judged by B-splines written out in double numbers, by closed
// forms, and by what is found in small steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "field_grid.hpp"
#include "surface_checks.hpp"

import abut.capability;
import abut.math;
import abut.shapes.distance_field;

namespace {

using abut::DistanceField;
using abut::Vec3;
using test::even;
using test::fine;
using test::from_ball;
using test::from_box;
using test::from_torus;
using test::Grid;
using test::uneven;

// 1 in the middle of its support, three wide: the quadratic B-spline.
double spline(double x) {
  const double away = std::fabs(x);
  return away < 0.5 ? 0.75 - away * away : away < 1.5 ? 0.5 * (1.5 - away) * (1.5 - away) : 0;
}
// The linear B-spline, of which its slope is made.
double hat(double x) { return std::fmax(0.0, 1 - std::fabs(x)); }
double spline_slope(double x) { return hat(x + 0.5) - hat(x - 0.5); }

// Samples that go on beyond the grid in straight lines.
class Oracle {
 public:
  Oracle(const Grid& grid, const std::vector<double>& values) : grid_(grid) {
    for (const double value : values) {
      values_.push_back(static_cast<double>(static_cast<float>(value)));
    }
  }
  [[nodiscard]] abut::FieldValue at(const Vec3& p) const {
    abut::FieldValue out{};
    const std::array<double, 3> place{in_cells(p.x, 0), in_cells(p.y, 1), in_cells(p.z, 2)};
    const auto first = [&](std::size_t axis) { return static_cast<int>(std::floor(place.at(axis))) - 2; };
    for (int k = first(2); k < first(2) + 6; ++k) {
      for (int j = first(1); j < first(1) + 6; ++j) {
        for (int i = first(0); i < first(0) + 6; ++i) {
          const double x = place[0] - i, y = place[1] - j, z = place[2] - k, c = sample(i, j, k);
          out.value += c * spline(x) * spline(y) * spline(z);
          out.gradient += c * Vec3{spline_slope(x) * spline(y) * spline(z) / grid_.spacing[0],
                                   spline(x) * spline_slope(y) * spline(z) / grid_.spacing[1],
                                   spline(x) * spline(y) * spline_slope(z) / grid_.spacing[2]};
        }
      }
    }
    return out;
  }

 private:
  [[nodiscard]] double in_cells(double at, std::size_t axis) const {
    return at / grid_.spacing.at(axis) + 0.5 * (grid_.counts.at(axis) - 1);
  }
  [[nodiscard]] double sample(int i, int j, int k) const {
    const auto extended = [&](int at, std::size_t axis, auto&& sample_at) {
      const int last = static_cast<int>(grid_.counts.at(axis)) - 1;
      return at < 0      ? sample_at(0) + at * (sample_at(1) - sample_at(0))
             : at > last ? sample_at(last) + (at - last) * (sample_at(last) - sample_at(last - 1))
                         : sample_at(at);
    };
    return extended(k, 2, [&](int z) {
      return extended(j, 1, [&](int y) {
        return extended(i, 0, [&](int x) {
          const double at = (z * grid_.counts[1] + y) * grid_.counts[0] + x;
          return values_.at(static_cast<std::size_t>(at));
        });
      });
    });
  }
  Grid grid_;
  std::vector<double> values_;
};

// Of more than one block along each axis, with all kinds of slopes and signs.
const Grid rough{{19, 12, 10}, {0.1, 0.15, 0.2}};
std::vector<double> rough_values(std::uint64_t seed, double low) {
  test::Random random(seed);
  const auto is_on_border = [](const Vec3& p) {
    return std::fabs(p.x) > 0.89 || std::fabs(p.y) > 0.82 || std::fabs(p.z) > 0.89;
  };
  // No sample is deeper than it is far from the border.
  return rough.values([&](const Vec3& p) { return random.uniform(is_on_border(p) ? 0 : low, 0.3); });
}
DistanceField rough_field(std::uint64_t seed, double low, bool is_smooth = true) {
  return test::made<DistanceField>(rough.parameters(false, is_smooth), rough_values(seed, low));
}
Vec3 in_grid(test::Random& random, const Grid& grid) {
  const auto along = [&](std::size_t axis) {
    const double half = 0.5 * (grid.counts.at(axis) - 1) * grid.spacing.at(axis);
    return random.uniform(-half, half);
  };
  return {along(0), along(1), along(2)};
}

TEST(SmoothDistanceField, ValuesAreThoseOfSplines) {
  test::Random random(3);
  const DistanceField field = rough_field(1, -0.09);
  const Oracle oracle(rough, rough_values(1, -0.09));
  for (int i = 0; i < 4000; ++i) {
    const Vec3 p = in_grid(random, rough);
    const abut::FieldValue found = field.value_at(p), truth = oracle.at(p);
    ASSERT_NEAR(found.value, truth.value, 1e-14) << p.x << " " << p.y << " " << p.z;
    ASSERT_NEAR(norm(found.gradient - truth.gradient), 0, 1e-12) << p.x << " " << p.y << " " << p.z;
  }
}

// Two samples along an axis leave room for nothing but a straight line.
TEST(SmoothDistanceField, TwoSamplesMakeALine) {
  const std::vector<double> values{0, 1, 0.5, 3, 0.25, 1.5, 4, 0.125};
  const DistanceField smooth = test::made<DistanceField>({2, 2, 2, 0.5, 2, 4, 10, 20, 30, 0, 1}, values),
                      linear = test::made<DistanceField>({2, 2, 2, 0.5, 2, 4, 10, 20, 30, 0}, values);
  test::Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p{random.uniform(10, 10.5), random.uniform(20, 22), random.uniform(30, 34)};
    EXPECT_NEAR(smooth.value_at(p).value, linear.value_at(p).value, 1e-14);
    EXPECT_NEAR(norm(smooth.value_at(p).gradient - linear.value_at(p).gradient), 0, 1e-12);
  }
}

TEST(SmoothDistanceField, WhatIsLinearStaysAsItIs) {
  const auto plane = [](const Vec3& p) { return 16 + 1.5 * p.x - 0.5 * p.y + 1.25 * p.z; };
  const Grid grid{{17, 9, 26}, {0.25, 0.5, 0.125}};  // all numbers are exact
  const DistanceField field = grid.field(plane, false, true);
  test::Random random(7);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = in_grid(random, grid);
    EXPECT_NEAR(field.value_at(p).value, plane(p), 1e-13);
    EXPECT_NEAR(norm(field.value_at(p).gradient - Vec3{1.5, -0.5, 1.25}), 0, 1e-12);
  }
  // The steepest gradient is known, rounded up.
  EXPECT_GE(-field.least_within(0, 1), norm(Vec3{1.5, -0.5, 1.25}));
  EXPECT_LE(-field.least_within(0, 1), 1.00001 * norm(Vec3{1.5, -0.5, 1.25}));
}

// Between cells, between blocks, and where the nearest sample is another one.
TEST(SmoothDistanceField, GradientsAreContinuous) {
  const DistanceField smooth = rough_field(2, -0.09), linear = rough_field(2, -0.09, false);
  test::Random random(11);
  double jump = 0, jump_of_linear = 0;
  for (int i = 0; i < 3000; ++i) {
    Vec3 p = in_grid(random, rough);
    const int halves = static_cast<int>(random.uniform(1, 36));
    p.x = (0.5 * halves - 9) * rough.spacing[0];
    const Vec3 step{1e-10, 0, 0};
    const auto between = [&](const DistanceField& field) {
      return norm(field.value_at(p + step).gradient - field.value_at(p - step).gradient);
    };
    jump = std::fmax(jump, between(smooth));
    jump_of_linear = std::fmax(jump_of_linear, between(linear));
  }
  EXPECT_LT(jump, 1e-6);
  EXPECT_GT(jump_of_linear, 0.1);
}

// As far as shapes.md says: at samples, and against the true distance.
TEST(SmoothDistanceField, DistancesAreOffByPartsOfACell) {
  test::Random random(13);
  for (const Grid& grid : {even, uneven}) {
    const double diagonal = std::hypot(grid.spacing[0], grid.spacing[1], grid.spacing[2]);
    const double sides = grid.spacing[0] + grid.spacing[1] + grid.spacing[2];
    const auto expect = [&](auto&& value_of) {
      const DistanceField field = grid.field(value_of, false, true);
      for (int i = 0; i < 4000; ++i) {
        const Vec3 p = in_grid(random, grid);
        EXPECT_NEAR(field.value_at(p).value, value_of(p), 0.5 * diagonal);
        Vec3 at_sample{};
        for (int axis = 0; axis < 3; ++axis) {
          const auto place = static_cast<std::size_t>(axis);
          const double last = grid.counts.at(place) - 1, index = std::floor(random.uniform(0, last + 1));
          (axis == 0   ? at_sample.x
           : axis == 1 ? at_sample.y
                       : at_sample.z) = (index - 0.5 * last) * grid.spacing.at(place);
        }
        EXPECT_NEAR(field.value_at(at_sample).value, value_of(at_sample), 0.25 * sides + 1e-6);
      }
    };
    expect(from_ball);
    expect(from_box);
    expect(from_torus);
  }
  // A ball is h^2 / (4 r) too small: half of the Laplacian 2 / r, times the spread of a quarter.
  const DistanceField ball = even.field(from_ball, false, true);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = 0.8 * test::towards(random);
    EXPECT_NEAR(ball.value_at(p).value, 0.06 * 0.06 / (4 * 0.8), 2e-5);
  }
}

// What a search concludes from one value holds for all points around.
TEST(SmoothDistanceField, BoundsHoldForAllPointsAround) {
  test::Random random(17);
  for (const DistanceField& field : {rough_field(3, -0.09), uneven.field(from_box, false, true)}) {
    const abut::Aabb box = field.solid_box();
    for (int i = 0; i < 20000; ++i) {
      const Vec3 p = random.point(1.3), q = p + random.uniform(0, 1) * random.point(0.4);
      const double value = field.value_at(p).value, other = field.value_at(q).value;
      ASSERT_GE(other, field.least_within(value, norm(p - q)) - 1e-12);
      if ((value < 0) != (other < 0)) {
        ASSERT_LE(field.least_way(value), norm(p - q) + 1e-12);
      }
      if (value <= 0) {
        ASSERT_TRUE(box.overlaps({p, p})) << p.x << " " << p.y << " " << p.z;
      }
    }
  }
}

TEST(SmoothDistanceField, TheBoxHoldsTheSolidWithinACellAndAHalf) {
  const abut::Aabb box = uneven.field(from_box, false, true).aabb(abut::Pose::identity());
  for (int axis = 0; axis < 3; ++axis) {
    const double half = axis == 0 ? 0.7 : axis == 1 ? 0.5 : 0.6, cell = uneven.spacing[static_cast<std::size_t>(axis)];
    EXPECT_GE(box.high[axis], half - 0.5 * cell);
    EXPECT_LE(box.high[axis], half + 1.5 * cell + 1e-12);
    EXPECT_LE(box.low[axis], -half + 0.5 * cell);
    EXPECT_GE(box.low[axis], -half - 1.5 * cell - 1e-12);
  }
}

// Wherever the sign changes along a short way, a point of the surface is as near as said. Small bumps count.
TEST(SmoothDistanceField, NoSurfaceIsFarFromItsPoints) {
  for (const double low : {-0.05, -0.3, -1.0}) {
    const DistanceField field = rough_field(4, low);
    const abut::SurfacePoints& surface = field.surface();
    test::Random random(19);
    int changes = 0;
    for (int i = 0; i < 60000; ++i) {
      Vec3 a = in_grid(random, rough), b = a + random.point(0.05);
      if ((field.value_at(a).value < 0) == (field.value_at(b).value < 0)) {
        continue;
      }
      ++changes;
      for (int step = 0; step < 40; ++step) {
        const Vec3 middle = 0.5 * (a + b);
        ((field.value_at(middle).value < 0) == (field.value_at(a).value < 0) ? a : b) = middle;
      }
      double nearest = abut::infinity;
      for (const Vec3& point : surface.points) {
        nearest = std::fmin(nearest, norm(point - a));
      }
      for (const Vec3& point : surface.doubtful) {
        nearest = std::fmin(nearest, norm(point - a));
      }
      ASSERT_LE(nearest, field.surface_error()) << a.x << " " << a.y << " " << a.z;
    }
    EXPECT_GT(changes, 20) << low;
    for (const Vec3& point : surface.points) {
      EXPECT_NEAR(field.value_at(point).value, 0, 1e-9);
    }
  }
}

TEST(SmoothDistanceField, RaysMeetTheFirstChangeOfSign) {
  test::Random random(23);
  const DistanceField field = rough_field(5, -0.3);
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 origin = random.point(1.2);
    const auto direction = abut::UnitVec3::make(random.point(0.6) - origin).value();
    const double step = 1e-4;
    double first = abut::infinity, before = field.value_at(origin).value;
    for (double way = step; way < 3 && first == abut::infinity; way += step) {
      const double value = field.value_at(origin + way * direction.vec()).value;
      first = (value < 0) != (before < 0) ? way : first;
      before = value;
    }
    const auto hit = field.cast_ray(origin, direction, abut::infinity);
    // Small steps may miss what is passed within one.
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
  EXPECT_GT(hits, 100);
}

TEST(SmoothDistanceField, RaysMeetTheBallWhereItIs) {
  const DistanceField field = uneven.field(from_ball, false, true);
  test::Random random(29);
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 origin = random.point(2);
    const auto direction = abut::UnitVec3::make(random.point(1) - origin).value();
    const double along = dot(origin, direction), square = along * along - dot(origin, origin) + 0.64;
    if (std::fabs(square) < 0.1 || std::fabs(from_ball(origin)) < 0.02) {
      continue;  // grazes, or begins on the surface
    }
    const double root = square > 0 ? std::sqrt(square) : -1;
    const double truth = -along - root >= 0 ? -along - root : -along + root;
    const auto hit = field.cast_ray(origin, direction, abut::infinity);
    ASSERT_EQ(hit.has_value(), square > 0 && truth >= 0) << "ray " << i;
    if (hit) {
      ++hits;
      EXPECT_NEAR(hit->distance, truth, 0.005);
      const Vec3 place = origin + hit->distance * direction;
      EXPECT_GT(dot(hit->normal, place), 0.9999 * norm(place));
    }
  }
  EXPECT_GT(hits, 600);
}

TEST(SmoothDistanceField, TrianglesCloseTheSurface) {
  const double pi = std::numbers::pi;
  const std::array<std::pair<double (*)(const Vec3&), double>, 3> solids{
      {{from_ball, 4 * pi / 3 * 0.512}, {from_torus, 2 * pi * pi * 0.7 * 0.09}, {from_box, 8 * 0.7 * 0.5 * 0.6}}};
  for (const auto& [value_of, volume] : solids) {
    const DistanceField field = uneven.field(value_of, false, true);
    const abut::Triangles surface = field.triangles();
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    double six_volumes = 0;
    for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
      const std::array<std::uint32_t, 3> t{surface.indices[i], surface.indices[i + 1], surface.indices[i + 2]};
      for (std::size_t k = 0; k < 3; ++k) {
        ++sides[{t.at(k), t.at((k + 1) % 3)}];
        --sides[{t.at((k + 1) % 3), t.at(k)}];
      }
      six_volumes += dot(surface.vertices[t[0]], cross(surface.vertices[t[1]], surface.vertices[t[2]]));
    }
    for (const auto& [edge, count] : sides) {
      EXPECT_EQ(count, 0) << "edge " << edge.first << " " << edge.second;
    }
    EXPECT_NEAR(six_volumes / 6, volume, 0.03 * volume);
  }
}

TEST(SmoothDistanceField, InsideOutTurnsTheSignsOver) {
  const DistanceField solid = uneven.field(from_torus, false, true), container = uneven.field(from_torus, true, true);
  test::Random random(31);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = random.point(2);
    EXPECT_EQ(container.value_at(p).value, -solid.value_at(p).value);
    EXPECT_EQ(container.value_at(p).gradient, -solid.value_at(p).gradient);
  }
}

void expect_same(const DistanceField& a, const DistanceField& b) {
  EXPECT_EQ(a.parameters(), b.parameters());
  EXPECT_EQ(a.buffers().reals, b.buffers().reals);
  EXPECT_EQ(a.buffers().indices, b.buffers().indices);
  EXPECT_EQ(a.solid_box().low, b.solid_box().low);
  EXPECT_EQ(a.solid_box().high, b.solid_box().high);
  EXPECT_EQ(a.triangles().vertices, b.triangles().vertices);
  EXPECT_EQ(a.triangles().indices, b.triangles().indices);
  test::Random random(37);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = random.point(2);
    EXPECT_EQ(a.value_at(p).value, b.value_at(p).value);
    EXPECT_EQ(a.value_at(p).gradient, b.value_at(p).gradient);
    EXPECT_EQ(a.least_way(a.value_at(p).value), b.least_way(b.value_at(p).value));
    EXPECT_EQ(a.least_within(0, 1), b.least_within(0, 1));
  }
}

TEST(SmoothDistanceField, BuffersMakeTheSameFieldAgain) {
  const DistanceField field = uneven.field(from_torus, false, true);
  const abut::Buffers buffers = field.buffers();
  expect_same(field, test::made<DistanceField>(field.parameters(), buffers.reals, buffers.indices));
}

// Samples at the faces of blocks are in the fringe of others.
TEST(SmoothDistanceField, EditsGiveTheFieldBuiltAnew) {
  test::Random random(41);
  const std::array<std::uint32_t, 3> counts{51, 36, 66};
  std::vector<double> values = uneven.values(from_torus);
  DistanceField field = test::made<DistanceField>(uneven.parameters(false, true), values);
  for (int round = 0; round < 60; ++round) {
    std::array<std::uint32_t, 3> first{}, count{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      first.at(axis) = static_cast<std::uint32_t>(random.uniform(0, counts.at(axis)));
      count.at(axis) =
          static_cast<std::uint32_t>(random.uniform(0, std::min(12.0, 1.0 + counts.at(axis) - first.at(axis))));
    }
    std::vector<double> changed;
    const double by = random.uniform(-0.2, 0.2);
    for (std::uint32_t k = first[2]; k < first[2] + count[2]; ++k) {
      for (std::uint32_t j = first[1]; j < first[1] + count[1]; ++j) {
        for (std::uint32_t i = first[0]; i < first[0] + count[0]; ++i) {
          changed.push_back(values[(k * counts[1] + j) * counts[0] + i] += by);
        }
      }
    }
    const abut::FieldEdit edit{first[0], first[1], first[2], count[0], count[1], count[2], changed};
    ASSERT_FALSE(field.check(edit).has_value());
    field.own();
    static_cast<void>(field.apply(edit));
  }
  expect_same(field, test::made<DistanceField>(uneven.parameters(false, true), values));
}

}  // namespace
