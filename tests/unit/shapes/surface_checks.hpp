// SPDX-License-Identifier: Apache-2.0
// What every shape promises about its surface, judged by functions that know nothing of its code.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../made.hpp"
#include "../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;

namespace test {

inline abut::Vec3 axis_vector(int axis, double length) {
  return {axis == 0 ? length : 0, axis == 1 ? length : 0, axis == 2 ? length : 0};
}
inline abut::UnitVec3 towards(Random& random) { return abut::UnitVec3::from_unit_unchecked(random.rotation().x); }

// Refused with a code and a sentence that begins like this.
template <class S>
void expect_refused(const std::vector<double>& parameters, const std::vector<double>& reals,
                    const std::vector<std::uint32_t>& indices, abut::Errc code, std::string_view beginning) {
  const auto result = S::make(parameters, reals, indices);
  ASSERT_FALSE(result.has_value()) << beginning;
  EXPECT_EQ(result.error().code, code) << beginning;
  EXPECT_EQ(result.error().message.substr(0, beginning.size()), beginning);
}

// `reach`: how far a placed shape extends from the origin in a direction of the world.
using Reach = std::function<double(const abut::Pose&, const abut::Vec3&)>;

template <class S>
void expect_tight_boxes(const S& shape, const Reach& reach, double size, std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < 200; ++i) {
    const abut::Pose pose{random.rotation(), random.point(10)};
    const abut::Aabb box = shape.aabb(pose);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(box.high[axis], reach(pose, axis_vector(axis, 1)), 1e-14 * (10 + size));
      EXPECT_NEAR(box.low[axis], -reach(pose, axis_vector(axis, -1)), 1e-14 * (10 + size));
    }
  }
}

inline double furthest(const std::vector<abut::Vec3>& points, const abut::Vec3& direction) {
  double most = -abut::infinity;
  for (const abut::Vec3& p : points) {
    most = std::fmax(most, dot(p, direction));
  }
  return most;
}

// A support point of a core with these vertices is the furthest of them, and one of them.
template <class S>
void expect_support(const S& shape, const std::vector<abut::Vec3>& core, double size, std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < 1000; ++i) {
    // Directions need not have length one.
    const abut::Vec3 direction = random.uniform(0.01, 100) * towards(random).vec();
    const double slack = 1e-15 * size * std::sqrt(dot(direction, direction));
    const abut::SupportPoint local = shape.support(direction);
    EXPECT_NEAR(dot(local.point, direction), furthest(core, direction), slack);
    double off = abut::infinity;
    for (const abut::Vec3& p : core) {
      off = std::fmin(off, largest_magnitude(p - local.point));
    }
    EXPECT_EQ(off, 0);
    const abut::Pose pose{random.rotation(), random.point(10)};
    const abut::SupportPoint there = placed_support(shape, place(shape, pose), direction);
    EXPECT_NEAR(dot(there.point - pose.position, direction), furthest(core, pose.rotation.undo(direction)),
                16 * slack + 4e-15 * 10 * std::sqrt(dot(direction, direction)));
  }
}

// A supporting face is plane, counter-clockwise and outward, bounds the core, and holds a support point.
template <class S>
void expect_faces(const S& shape, const std::vector<abut::Vec3>& core, double size, std::uint64_t seed) {
  Random random(seed);
  std::map<std::uint32_t, std::set<std::uint32_t>> edges;
  std::map<std::uint32_t, abut::Vec3> normals;
  for (int i = 0; i < 1000; ++i) {
    const abut::Vec3 direction = towards(random);
    const abut::Face face = shape.supporting_face(direction);
    const std::size_t count = face.vertices.size();
    ASSERT_GE(count, 3u);
    EXPECT_NEAR(dot(face.normal, face.normal), 1, 4e-15);
    EXPECT_GT(dot(face.normal, direction), 0);
    const auto known = normals.try_emplace(face.index, face.normal).first;
    EXPECT_EQ(largest_magnitude(known->second - face.normal), 0) << "one index, two faces";
    const double offset = dot(face.normal, face.vertices[0].point);
    EXPECT_LE(furthest(core, face.normal), offset + 1e-13 * size);
    double top = -abut::infinity;
    for (std::size_t k = 0; k < count; ++k) {
      const abut::FaceVertex &a = face.vertices[k], &b = face.vertices[(k + 1) % count],
                             &c = face.vertices[(k + 2) % count];
      EXPECT_NEAR(dot(face.normal, a.point), offset, 1e-13 * size);
      EXPECT_GE(dot(face.normal, cross(b.point - a.point, c.point - b.point)), 0);
      EXPECT_NE(a.vertex, b.vertex);
      edges[a.edge].insert({a.vertex, b.vertex});
      top = std::fmax(top, dot(a.point, direction));
    }
    EXPECT_NEAR(top, furthest(core, direction), 1e-13 * size);
  }
  for (const auto& [edge, ends] : edges) {
    EXPECT_EQ(ends.size(), 2u) << "edge " << edge << " has one pair of ends";
  }
}

// A convex function that is negative inside, zero on the surface and grows outside by one per unit.
using Outside = std::function<double(const abut::Vec3&)>;

// Where a line crosses a convex solid, by halving intervals; nothing when it misses it or grazes it.
struct Crossing {
  double enter, leave;
};
inline std::optional<Crossing> crossing(const Outside& outside, const abut::Vec3& origin, const abut::Vec3& direction,
                                        double reach, double& least) {
  const auto at = [&](double t) { return outside(origin + t * direction); };
  double low = -reach, high = reach;
  for (int i = 0; i < 160; ++i) {
    const double first = low + (high - low) / 3, second = high - (high - low) / 3;
    if (at(first) < at(second)) {
      high = second;
    } else {
      low = first;
    }
  }
  const double inside = (low + high) / 2;
  least = at(inside);
  if (least > 0) {
    return std::nullopt;
  }
  const auto border = [&](double from, double to) {
    for (int i = 0; i < 80; ++i) {
      const double middle = (from + to) / 2;
      (at(middle) <= 0 ? from : to) = middle;
    }
    return from;
  };
  return Crossing{border(inside, -reach), border(inside, reach)};
}

// Rays from without and within meet the first crossing, with the outward normal there.
template <class S>
void expect_rays(const S& shape, const Outside& outside, double size, std::uint64_t seed) {
  Random random(seed);
  int hits = 0, misses = 0, from_inside = 0;
  for (int i = 0; i < 2000; ++i) {
    const abut::Vec3 origin = random.point(i % 3 == 0 ? size / 2 : 2 * size), target = random.point(size);
    const auto direction = abut::UnitVec3::make(target - origin).value();
    double least = 0;
    const auto expected = crossing(outside, origin, direction, 20 * size, least);
    const auto hit = shape.cast_ray(origin, direction, abut::infinity);
    if (std::fabs(least) < 1e-9 * size) {
      continue;  // grazing: rounding decides
    }
    if (!expected || expected->leave < 0) {
      EXPECT_FALSE(hit.has_value()) << "ray " << i;
      ++misses;
      continue;
    }
    ASSERT_TRUE(hit.has_value()) << "ray " << i;
    ++hits;
    from_inside += expected->enter < 0 ? 1 : 0;
    const double distance = expected->enter >= 0 ? expected->enter : expected->leave;
    ASSERT_NEAR(hit->distance, distance, 1e-9 * size) << "ray " << i;
    const abut::Vec3 point = origin + distance * direction.vec();
    const double step = 1e-6 * size;
    EXPECT_NEAR(dot(hit->normal, hit->normal), 1, 4e-15);
    EXPECT_GT(outside(point + step * hit->normal), 0.999 * step) << "ray " << i;
    EXPECT_TRUE(shape.cast_ray(origin, direction, hit->distance).has_value());
    EXPECT_FALSE(shape.cast_ray(origin, direction, std::nextafter(hit->distance, 0.0)).has_value());
  }
  EXPECT_GT(hits, 300);
  EXPECT_GT(misses, 100);
  EXPECT_GT(from_inside, 30);
}

}  // namespace test
