// SPDX-License-Identifier: Apache-2.0
// The deepest point of a core in coarse fields, whose gradients jump between cells. A random walk that only knows
// values finds nothing deeper. The same walk finds nothing nearer on the surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.field.field_core;
import abut.narrow.field.field_descent;
import abut.shapes.box;
import abut.shapes.cylinder;
import abut.shapes.distance_field;
import abut.shapes.ellipsoid;

namespace {

using abut::CoreInField;
using abut::DistanceField;
using abut::Pose;
using abut::Real;
using abut::Vec3;

constexpr Real longest_cell = 0.5;
// A descent ends with steps of 1e-5 of a cell.
constexpr Real end_of_descent = 1e-5 * longest_cell;

// The union of a few balls, of 5 to 9 samples along each axis.
DistanceField coarse_field(test::Random& random) {
  const auto count = [&] { return std::floor(random.uniform(5, 10)); };
  const auto spacing = [&] { return random.uniform(0.5, 1) * longest_cell; };
  const Vec3 counts{count(), count(), count()}, cells{spacing(), spacing(), spacing()};
  const Vec3 low = -0.5 * Vec3{(counts.x - 1) * cells.x, (counts.y - 1) * cells.y, (counts.z - 1) * cells.z};
  std::vector<Vec3> centres;
  for (int i = 0; i < 3; ++i) {
    centres.push_back(random.point(0.6));
  }
  const Real radius = random.uniform(0.6, 0.9);
  std::vector<double> values;
  for (Real k = 0; k < counts.z; ++k) {
    for (Real j = 0; j < counts.y; ++j) {
      for (Real i = 0; i < counts.x; ++i) {
        const Vec3 at = low + Vec3{i * cells.x, j * cells.y, k * cells.z};
        Real least = abut::infinity;
        for (const Vec3& centre : centres) {
          least = std::min(least, norm(at - centre) - radius);
        }
        values.push_back(least);
      }
    }
  }
  return test::made<DistanceField>({counts.x, counts.y, counts.z, cells.x, cells.y, cells.z, low.x, low.y, low.z, 0, 0},
                                   values);
}

// A point of the surface, by Newton's method along the gradient; nothing where that does not get there.
std::optional<Vec3> on_surface(const DistanceField& field, Vec3 point) {
  constexpr int most_steps = 60;
  for (int i = 0; i < most_steps; ++i) {
    const abut::FieldValue found = field.value_at(point);
    if (std::fabs(found.value) <= 1e-8) {
      return point;
    }
    point += (-found.value / std::fmax(squared_norm(found.gradient), 0.25)) * found.gradient;
  }
  return std::nullopt;
}

// The least value that a walk finds: from the best of many points in steps that become shorter where none leads down.
// onto(point) is the place of a point where points may be.
template <class ValueAt, class Onto>
Real least_of_walk(std::vector<Vec3> starts, Real first_step, const ValueAt& value_at, const Onto& onto,
                   test::Random& random) {
  const auto value_there = [&](const Vec3& point) { return value_at(onto(point)); };
  std::ranges::sort(starts, {}, value_there);
  constexpr std::size_t walks = 3;
  Real least = abut::infinity;
  for (std::size_t walk = 0; walk < walks; ++walk) {
    Vec3 best = onto(starts[walk]);
    Real value = value_at(best);
    int failures = 0;
    for (Real step = first_step; step > 1e-9;) {
      const Vec3 point = onto(best + random.point(step));
      if (const Real there = value_at(point); there < value) {
        best = point;
        value = there;
        failures = 0;
        step *= 1.2;
      } else if (++failures > 40) {
        failures = 0;
        step *= 0.5;
      }
    }
    least = std::min(least, value);
  }
  return least;
}

template <class B, class Onto>
void expect_deepest(const B& b, Real reach, const Onto& onto, std::uint64_t seed) {
  test::Random random(seed);
  for (int scene = 0; scene < 60; ++scene) {
    const DistanceField field = coarse_field(random);
    const Pose pose{random.rotation(), random.point(0.8)};
    std::vector<Vec3> starts;
    for (int i = 0; i < 400; ++i) {
      starts.push_back(random.point(reach));
    }
    const Real walked = least_of_walk(
        starts, 0.6 * longest_cell, [&](const Vec3& point) { return field.value_at(pose * point).value; }, onto,
        random);
    const abut::LeastValue found = least_value(field, b, pose);
    EXPECT_LE(found.point.field.value, walked + end_of_descent) << "seed " << seed << " scene " << scene;
    EXPECT_LE(norm(onto(found.point.point) - found.point.point), 1e-9) << "seed " << seed << " scene " << scene;
  }
}

TEST(FieldDescent, NoPointOfABoxIsDeeper) {
  const Vec3 half{0.7, 0.5, 0.3};
  const auto onto = [&](const Vec3& p) {
    return Vec3{std::clamp(p.x, -half.x, half.x), std::clamp(p.y, -half.y, half.y), std::clamp(p.z, -half.z, half.z)};
  };
  expect_deepest(test::made<abut::Box>({half.x, half.y, half.z}), 0.7, onto, 1);
}

TEST(FieldDescent, NoPointOfACylinderIsDeeper) {
  const Real radius = 0.6, half = 0.4;
  const auto onto = [&](const Vec3& p) {
    const Real across = std::hypot(p.x, p.y), share = across > radius ? radius / across : 1;
    return Vec3{share * p.x, share * p.y, std::clamp(p.z, -half, half)};
  };
  expect_deepest(test::made<abut::Cylinder>({radius, half}), 0.6, onto, 2);
}

// Toward the middle of the ellipsoid: that is not the nearest of its points, but one of them.
TEST(FieldDescent, NoPointOfAnEllipsoidIsDeeper) {
  const Vec3 radii{0.8, 0.5, 0.3};
  const auto onto = [&](const Vec3& p) {
    const Real by = norm(Vec3{p.x / radii.x, p.y / radii.y, p.z / radii.z});
    return by > 1 ? (1 / by) * p : p;
  };
  expect_deepest(test::made<abut::Ellipsoid>({radii.x, radii.y, radii.z}), 0.8, onto, 3);
}

// From the surface below a point it slides to the nearest point. A walk on the surface from there gets no nearer. Where
// cells meet in a sharp corner, the slide may end a little early.
TEST(FieldDescent, NoPointOfTheSurfaceNearbyIsNearer) {
  const abut::Box box = test::made<abut::Box>({1, 1, 1});
  test::Random random(4);
  constexpr int most_early = 2;
  constexpr Real most_left = 2e-3 * longest_cell;
  int judged = 0, early = 0;
  for (int scene = 0; scene < 200; ++scene) {
    const DistanceField field = coarse_field(random);
    const CoreInField<DistanceField, abut::Box> core(field, box, Pose::identity());
    const Vec3 point = random.point(0.9);
    const std::optional<Vec3> start = on_surface(field, point);
    if (!start) {
      continue;
    }
    ++judged;
    const Vec3 found = core.nearest_on_surface(point, *start);
    EXPECT_NEAR(field.value_at(found).value, 0, 1e-5 * longest_cell) << scene;
    const auto onto = [&](const Vec3& p) { return on_surface(field, p).value_or(found); };
    // Longer steps would leap to another part of the surface.
    const Real walked = least_of_walk(
        {found, found, found}, 0.01 * longest_cell, [&](const Vec3& p) { return norm(p - point); }, onto, random);
    early += norm(found - point) > walked + end_of_descent ? 1 : 0;
    EXPECT_LE(norm(found - point), walked + most_left) << scene;
  }
  EXPECT_GT(judged, 150);
  EXPECT_LE(early, most_early);
}

}  // namespace
