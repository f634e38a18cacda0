// SPDX-License-Identifier: Apache-2.0
// Numbers of contacts: the same while the same features touch, and different for different features.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.universe;

namespace {

using abut::FeatureKind;

abut::ShapeHandle shape_of(std::string_view kind, const std::vector<double>& parameters,
                           const std::vector<double>& reals = {}, const std::vector<std::uint32_t>& indices = {}) {
  return abut::ShapeHandle(abut::make_shape(abut::find_kind(kind).value(), parameters, reals, indices).value());
}

abut::Placement placed(const abut::Vec3& position, const abut::Vec3& axis, double angle) {
  const double sine = std::sin(angle / 2);
  return {position, {std::cos(angle / 2), sine * axis.x, sine * axis.y, sine * axis.z}};
}

// A body on a slab whose top is z = 0, moved step by step.
class OnSlab {
 public:
  explicit OnSlab(const abut::ShapeHandle& body) : universe_({.max_contacts = 0}, 1) {
    const abut::Placement below{{0, 0, -1}};
    const auto parts =
        universe_.create_parts(std::vector<abut::PartOptions>{{abut::MotionKind::fixed, below}, {}}).value();
    part_ = parts[1];
    EXPECT_TRUE(universe_.create_geometries(parts, std::vector{shape_of("box", {9, 9, 1}), body}, {}).has_value());
  }
  // Ids of the contacts, in rising order.
  std::vector<std::uint64_t> ids_at(const abut::Placement& placement) {
    EXPECT_TRUE(universe_.set_poses(std::vector{part_}, std::vector{placement}).has_value());
    EXPECT_TRUE(universe_.step(0).has_value());
    std::vector<std::uint64_t> ids;
    for (const abut::Contact& contact : universe_.contacts()) {
      ids.push_back(contact.point.id);
    }
    std::ranges::sort(ids);
    return ids;
  }

 private:
  abut::Universe universe_;
  abut::PartId part_{};
};

// Moves a body for a thousand steps from x = -5 to x = 5 and turns it by a full turn about an axis.
void check_steady(const abut::ShapeHandle& body, double height, const abut::Vec3& axis, double turns,
                  std::size_t contacts) {
  OnSlab scene(body);
  const auto placement = [&](int step) {
    const double t = step / 1000.0;
    return placed({10 * t - 5, 3 * std::sin(7 * t), height}, axis, turns * 2 * std::numbers::pi * t + 0.1);
  };
  const auto first = scene.ids_at(placement(0));
  EXPECT_EQ(first.size(), contacts);
  for (int step = 1; step <= 1000; ++step) {
    ASSERT_EQ(scene.ids_at(placement(step)), first) << "step " << step;
  }
}

TEST(ContactFeatures, KeepTheirNumbersWhileABodySlides) {
  std::vector<double> prism;
  for (int i = 0; i < 7; ++i) {
    for (const double z : {-0.5, 0.5}) {
      prism.insert(prism.end(), {std::cos(i * 0.9), std::sin(i * 0.9), z});
    }
  }
  check_steady(shape_of("box", {1, 0.7, 0.5}), 0.499, {0, 0, 1}, 1, 4);
  check_steady(shape_of("hull", {}, prism), 0.499, {0, 0, 1}, 1, 7);
  check_steady(shape_of("sphere", {0.5}), 0.499, {0, 0, 1}, 1, 1);
  check_steady(shape_of("triangle", {1, 0, 0, -1, 1, 0, -1, -1, 0}), -1e-3, {0, 0, 1}, 1, 3);
}

TEST(ContactFeatures, KeepTheirNumbersWhileABallRolls) {
  check_steady(shape_of("sphere", {0.5}), 0.499, {0.6, 0.8, 0}, 5, 1);
}

// Kinds and indices as meshes and hulls have them: no two pairs of features have one number.
TEST(ContactFeatures, HaveNumbersOfTheirOwn) {
  std::vector<std::uint64_t> ids;
  const auto features = [](std::uint32_t count) {
    std::vector<abut::Feature> all{{FeatureKind::whole, 0}};
    for (std::uint32_t i = 1; i <= count; ++i) {
      for (const FeatureKind kind : {FeatureKind::vertex, FeatureKind::edge, FeatureKind::face}) {
        all.push_back({kind, i});
        all.push_back({kind, 0xffffffffu - i});
        all.push_back({kind, 1000003 * i});
      }
    }
    return all;
  };
  const auto all = features(160);
  for (const abut::Feature& a : all) {
    for (const abut::Feature& b : all) {
      ids.push_back(abut::contact_id(a, b));
    }
  }
  std::ranges::sort(ids);
  ASSERT_GT(ids.size(), 2000000u);
  EXPECT_TRUE(std::ranges::adjacent_find(ids) == ids.end());
}

}  // namespace
