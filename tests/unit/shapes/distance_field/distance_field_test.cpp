// SPDX-License-Identifier: Apache-2.0
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

#include "../field_grid.hpp"
#include "../surface_checks.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.shapes.distance_field;

namespace {

using abut::DistanceField;
using abut::Errc;
using abut::Vec3;

using test::even;
using test::fine;
using test::from_ball;
using test::from_box;
using test::from_torus;
using test::Grid;
using test::uneven;

TEST(DistanceField, BadInputIsRefusedByName) {
  const std::vector<double> eight(8, 1.0);
  const auto refuse = [&](std::size_t at, double value, Errc code, const char* message) {
    std::vector<double> parameters{2, 2, 2, 1, 1, 1, 0, 0, 0, 0};
    parameters[at] = value;
    test::expect_refused<DistanceField>(parameters, eight, {}, code, message);
  };
  refuse(0, 0, Errc::empty, "columns is 0;");
  refuse(0, 1, Errc::out_of_range, "columns is 1;");
  refuse(1, 65536, Errc::out_of_range, "rows is 65536;");
  refuse(2, 2.5, Errc::out_of_range, "layers is 2.5;");
  refuse(3, 0, Errc::out_of_range, "spacing_x is 0;");
  refuse(4, -1, Errc::out_of_range, "spacing_y is -1;");
  refuse(5, 1e-31, Errc::out_of_range, "spacing_z is 1e-31;");
  refuse(5, 1e70, Errc::out_of_range, "spacing_z is 1e+70;");
  refuse(6, std::numeric_limits<double>::quiet_NaN(), Errc::not_finite, "origin_x is nan;");
  refuse(9, 2, Errc::unknown_value, "is_inside_out is 2;");
  test::expect_refused<DistanceField>({2, 2, 2, 1, 1, 1, 0, 0, 0, 0, 2}, eight, {}, Errc::unknown_value,
                                      "interpolation is 2;");
  const std::vector<double> good{2, 2, 2, 1, 1, 1, 0, 0, 0, 0};
  test::expect_refused<DistanceField>({2, 2, 2}, eight, {}, Errc::invalid_argument, "parameter_count is 3;");
  test::expect_refused<DistanceField>(good, {}, {}, Errc::empty, "values is empty;");
  test::expect_refused<DistanceField>(good, {1, 1}, {}, Errc::invalid_argument, "real_count is 2;");
  test::expect_refused<DistanceField>({65535, 65535, 65535, 1, 1, 1, 0, 0, 0, 0}, eight, {}, Errc::size_overflow,
                                      "a distance field has at most 2^32 - 2 samples");
  std::vector<double> bad = eight;
  bad[5] = std::numeric_limits<double>::quiet_NaN();
  test::expect_refused<DistanceField>(good, bad, {}, Errc::not_finite, "values[5] is nan;");
  bad[5] = 1e39;
  test::expect_refused<DistanceField>(good, bad, {}, Errc::out_of_range, "values[5] is 1e+39;");
  test::expect_refused<DistanceField>(good, eight, {1}, Errc::invalid_argument, "real_count is 8;");
  const std::vector<double> sparse(8 + 729, 1.0);
  test::expect_refused<DistanceField>(good, sparse, {1}, Errc::index_out_of_range, "indices[0] is 1;");
}

// Of points within three cells of the surface: at most half a cell off, and at most five degrees.
template <class ValueOf>
void expect_close(const Grid& grid, ValueOf&& value_of, bool is_smooth) {
  const DistanceField field = grid.field(value_of);
  test::Random random(5);
  int near = 0, steep = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = random.point(1.2);
    const double truth = value_of(p);
    if (std::fabs(truth) > 3 * grid.finest()) {
      continue;
    }
    ++near;
    const abut::FieldValue found = field.value_at(p);
    EXPECT_NEAR(found.value, truth, 0.5 * grid.coarsest());
    // The true slope, by differences.
    const double step = 1e-6;
    const Vec3 slope{value_of(p + Vec3{step, 0, 0}) - value_of(p - Vec3{step, 0, 0}),
                     value_of(p + Vec3{0, step, 0}) - value_of(p - Vec3{0, step, 0}),
                     value_of(p + Vec3{0, 0, step}) - value_of(p - Vec3{0, 0, step})};
    const double cosine = dot(slope, found.gradient) / (norm(slope) * norm(found.gradient));
    steep += cosine < std::cos(5 * std::numbers::pi / 180) ? 1 : 0;
    // The way to the surface is no shorter than said.
    EXPECT_LE(field.least_way(found.value), std::fabs(truth) + 0.5 * grid.coarsest());
  }
  EXPECT_GT(near, 1000);
  // Edges of a box turn the slope within a cell.
  EXPECT_LE(steep, is_smooth ? 0 : near / 4);
}

TEST(DistanceField, IsCloseToTheBallBoxAndTorus) {
  for (const Grid& grid : {even, uneven}) {
    expect_close(grid, from_ball, true);
    expect_close(grid, from_box, false);
  }
  // A tube of fourteen cells.
  expect_close(fine, from_torus, true);
}

// Tri-linear values between eight samples, written out.
TEST(DistanceField, ValuesBetweenSamplesAreTriLinear) {
  const std::vector<double> values{1, 2, 0.5, 3, -0.25, 1.5, 4, 0.125};
  const DistanceField field = test::made<DistanceField>({2, 2, 2, 0.5, 2, 4, 10, 20, 30, 0}, [&] {
    std::vector<double> limited = values;
    limited[4] = 0;  // on the border
    return limited;
  }());
  const DistanceField deep = test::made<DistanceField>({2, 2, 2, 0.5, 2, 4, 10, 20, 30, 0}, values);
  test::Random random(3);
  for (int i = 0; i < 100; ++i) {
    const double x = random.uniform(0, 1), y = random.uniform(0, 1), z = random.uniform(0, 1);
    double value = 0, dx = 0, dy = 0, dz = 0;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const bool i1 = (corner & 1) != 0, j1 = (corner & 2) != 0, k1 = (corner & 4) != 0;
      const double v = corner == 4 ? 0 : values[corner], wx = i1 ? x : 1 - x, wy = j1 ? y : 1 - y, wz = k1 ? z : 1 - z;
      value += v * wx * wy * wz;
      dx += (i1 ? v : -v) * wy * wz / 0.5;
      dy += (j1 ? v : -v) * wx * wz / 2;
      dz += (k1 ? v : -v) * wx * wy / 4;
    }
    const abut::FieldValue found = field.value_at({10 + 0.5 * x, 20 + 2 * y, 30 + 4 * z});
    EXPECT_NEAR(found.value, value, 1e-12);
    EXPECT_NEAR(found.gradient.x, dx, 1e-11);
    EXPECT_NEAR(found.gradient.y, dy, 1e-11);
    EXPECT_NEAR(found.gradient.z, dz, 1e-11);
    // What is deeper than the border is far away counts as on it.
    EXPECT_EQ(deep.value_at({10 + 0.5 * x, 20 + 2 * y, 30 + 4 * z}).value, found.value);
  }
}

// The true distance of a ball in the grid is never less, and the gradient is that of the value.
TEST(DistanceField, ValuesOutsideOfTheGridAreLowerBounds) {
  const DistanceField field = even.field(from_ball);
  test::Random random(7);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random.point(5);
    if (std::fabs(p.x) < 1.25 && std::fabs(p.y) < 1.3 && std::fabs(p.z) < 1.35) {
      continue;
    }
    const abut::FieldValue found = field.value_at(p);
    EXPECT_LE(found.value, from_ball(p) + 1e-3);
    EXPECT_GE(found.value, 0.6 * from_ball(p));
    const double step = 1e-5;
    const auto slope = [&](const Vec3& axis) {
      return (field.value_at(p + step * axis).value - field.value_at(p - step * axis).value) / (2 * step);
    };
    EXPECT_NEAR(found.gradient.x, slope({1, 0, 0}), 0.06);
    EXPECT_NEAR(found.gradient.y, slope({0, 1, 0}), 0.06);
    EXPECT_NEAR(found.gradient.z, slope({0, 0, 1}), 0.06);
  }
}

TEST(DistanceField, InsideOutTurnsTheSignsOver) {
  const DistanceField solid = uneven.field(from_torus), container = uneven.field(from_torus, true);
  test::Random random(11);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = random.point(2);
    EXPECT_EQ(container.value_at(p).value, -solid.value_at(p).value);
    EXPECT_EQ(container.value_at(p).gradient, -solid.value_at(p).gradient);
    EXPECT_EQ(container.least_way(-solid.value_at(p).value), solid.least_way(solid.value_at(p).value));
  }
  EXPECT_FALSE(container.aabb(abut::Pose::identity()).is_bounded());
  EXPECT_EQ(container.solid_box().low, solid.solid_box().low);
}

TEST(DistanceField, TheBoxHoldsTheSolidWithinACell) {
  const abut::Aabb box = uneven.field(from_box).aabb(abut::Pose::identity());
  for (int axis = 0; axis < 3; ++axis) {
    const double half = axis == 0 ? 0.7 : axis == 1 ? 0.5 : 0.6, cell = uneven.spacing[static_cast<std::size_t>(axis)];
    EXPECT_LE(box.low[axis], -half);
    EXPECT_GE(box.low[axis], -half - cell - 1e-12);
    EXPECT_GE(box.high[axis], half);
    EXPECT_LE(box.high[axis], half + cell + 1e-12);
  }
}

TEST(DistanceField, RaysMeetTheBallWhereItIs) {
  const DistanceField field = uneven.field(from_ball);
  test::Random random(13);
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
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
      EXPECT_NEAR(hit->distance, truth, 0.02);
      const Vec3 place = origin + hit->distance * direction;
      EXPECT_NEAR(field.value_at(place).value, 0, 1e-12);
      EXPECT_GT(dot(hit->normal, place), 0.99 * 0.8);
      EXPECT_FALSE(field.cast_ray(origin, direction, 0.999 * hit->distance).has_value());
    }
  }
  EXPECT_GT(hits, 1000);
}

// The first change of sign in very small steps.
TEST(DistanceField, RaysMeetTheFirstChangeOfSign) {
  test::Random random(17);
  const Grid rough{{11, 10, 12}, {0.1, 0.12, 0.09}};
  const DistanceField field = rough.field([&](const Vec3&) { return random.uniform(-0.2, 1); });
  for (int i = 0; i < 300; ++i) {
    const Vec3 origin = random.point(1);
    const auto direction = abut::UnitVec3::make(random.point(0.4) - origin).value();
    const double step = 1e-4;
    double first = abut::infinity, before = field.value_at(origin).value;
    for (double way = step; way < 2.5 && first == abut::infinity; way += step) {
      const double value = field.value_at(origin + way * direction.vec()).value;
      first = (value < 0) != (before < 0) ? way : first;
      before = value;
    }
    const auto hit = field.cast_ray(origin, direction, abut::infinity);
    // Small steps may miss what is passed within one.
    if (first < abut::infinity) {
      ASSERT_TRUE(hit.has_value()) << "ray " << i;
      EXPECT_LE(hit->distance, first + 1e-9);
    }
    if (hit) {
      EXPECT_NEAR(field.value_at(origin + hit->distance * direction.vec()).value, 0, 1e-9);
    }
  }
}

// Closed, turned outward, and on the surface.
template <class ValueOf>
void expect_closed(const Grid& grid, ValueOf&& value_of, bool is_inside_out, double volume) {
  const DistanceField field = grid.field(value_of, is_inside_out);
  const abut::Triangles surface = field.triangles();
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  double six_volumes = 0;
  for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
    const std::array<std::uint32_t, 3> t{surface.indices[i], surface.indices[i + 1], surface.indices[i + 2]};
    for (std::size_t k = 0; k < 3; ++k) {
      ++sides[{t[k], t[(k + 1) % 3]}];
      --sides[{t[(k + 1) % 3], t[k]}];
    }
    six_volumes += dot(surface.vertices[t[0]], cross(surface.vertices[t[1]], surface.vertices[t[2]]));
  }
  for (const auto& [edge, count] : sides) {
    EXPECT_EQ(count, 0) << "edge " << edge.first << " " << edge.second;
  }
  for (const Vec3& vertex : surface.vertices) {
    EXPECT_NEAR(field.value_at(vertex).value, 0, 1e-4 * grid.finest());
  }
  EXPECT_NEAR(six_volumes / 6, is_inside_out ? -volume : volume, 0.02 * volume);
}

TEST(DistanceField, TrianglesCloseTheSurface) {
  const double pi = std::numbers::pi;
  for (const Grid& grid : {even, uneven}) {
    expect_closed(grid, from_ball, false, 4 * pi / 3 * 0.512);
    expect_closed(grid, from_torus, true, 2 * pi * pi * 0.7 * 0.09);
    expect_closed(grid, from_box, false, 8 * 0.7 * 0.5 * 0.6);
  }
}

// A solid that fills the grid is the box of the grid.
TEST(DistanceField, ASolidEndsAtTheBorderOfTheGrid) {
  const Grid grid{{9, 11, 10}, {0.25, 0.2, 0.3}};
  const DistanceField field = grid.field([](const Vec3&) { return -5.0; });
  const abut::Aabb box = field.aabb(abut::Pose::identity());
  EXPECT_NEAR(norm(box.high - Vec3{1, 1, 1.35}), 0, 1e-12);
  EXPECT_NEAR(field.value_at({0.9, 0, 0}).value, -0.1, 1e-6);
  EXPECT_NEAR(field.value_at({1.5, 0, 0}).value, 0.5, 1e-15);
  const auto hit = field.cast_ray({3, 0.1, 0.1}, abut::UnitVec3::make({-1, 0, 0}).value(), abut::infinity);
  ASSERT_TRUE(hit.has_value());
  EXPECT_NEAR(hit->distance, 2, 1e-12);
}

// Answers of two fields that must be the same ones.
void expect_same(const DistanceField& a, const DistanceField& b) {
  EXPECT_EQ(a.parameters(), b.parameters());
  EXPECT_EQ(a.buffers().reals, b.buffers().reals);
  EXPECT_EQ(a.buffers().indices, b.buffers().indices);
  EXPECT_EQ(a.solid_box().low, b.solid_box().low);
  EXPECT_EQ(a.solid_box().high, b.solid_box().high);
  EXPECT_EQ(a.triangles().vertices, b.triangles().vertices);
  EXPECT_EQ(a.triangles().indices, b.triangles().indices);
  test::Random random(19);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = random.point(2);
    EXPECT_EQ(a.value_at(p).value, b.value_at(p).value);
    EXPECT_EQ(a.least_way(a.value_at(p).value), b.least_way(b.value_at(p).value));
    EXPECT_EQ(a.least_within(0, 1), b.least_within(0, 1));
  }
}

TEST(DistanceField, BuffersMakeTheSameFieldAgain) {
  const DistanceField field = uneven.field(from_torus);
  const abut::Buffers buffers = field.buffers();
  expect_same(field, test::made<DistanceField>(field.parameters(), buffers.reals, buffers.indices));
}

TEST(DistanceField, EditsGiveTheFieldBuiltAnew) {
  test::Random random(23);
  std::vector<double> values = uneven.values(from_torus);
  DistanceField field = test::made<DistanceField>(uneven.parameters(), values);
  const DistanceField before = field;
  const std::array<std::uint32_t, 3> counts{51, 36, 66};
  for (int round = 0; round < 40; ++round) {
    std::array<std::uint32_t, 3> first{}, count{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      first[axis] = static_cast<std::uint32_t>(random.uniform(0, counts[axis]));
      count[axis] = static_cast<std::uint32_t>(random.uniform(0, std::min(12.0, 1.0 + counts[axis] - first[axis])));
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
  expect_same(field, test::made<DistanceField>(uneven.parameters(), values));
  expect_same(before, uneven.field(from_torus));
}

TEST(DistanceField, EditsBeyondTheGridAreRefused) {
  const DistanceField field = even.field(from_ball);
  const std::vector<double> one{1}, bad{std::numeric_limits<double>::infinity()};
  const auto message = [&](const abut::FieldEdit& edit) {
    const abut::Fault fault = field.check(edit);
    return fault ? fault->message : std::string("none");
  };
  EXPECT_EQ(message({42, 0, 0, 0, 0, 0, {}}), "column is 42; it must be at most 41");
  EXPECT_EQ(message({0, 40, 0, 1, 4, 1, {}}), "rows is 4; it must be at most 3, as row is 40");
  EXPECT_EQ(message({0, 0, 45, 1, 1, 1, one}), "layers is 1; it must be at most 0, as layer is 45");
  EXPECT_EQ(message({0, 0, 0, 1, 1, 1, bad}), "values[0] is inf; it must be finite");
  EXPECT_EQ(message({0, 0, 0, 1, 1, 1, one}), "none");
}

}  // namespace
