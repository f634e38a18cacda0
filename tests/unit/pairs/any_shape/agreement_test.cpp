// SPDX-License-Identifier: Apache-2.0
// The signed distance of two shapes and their deepest contact are two roads to one number. Kinds of solids agree to
// rounding. Surfaces are sheets to a distance, and let through what comes from behind as contacts do: there a contact
// may be absent or another one, but none is nearer than the distance while the shapes are apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

import abut.capability;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.registry;

namespace {

using abut::AnyShape;
using abut::ShapeHandle;
using abut::Outcome;
using abut::Pose;
using abut::Vec3;

constexpr double infinity = std::numeric_limits<double>::infinity();

template <std::size_t... places>
std::vector<std::vector<ShapeHandle>> samples_of_kinds(std::index_sequence<places...>) {
  std::vector<std::vector<ShapeHandle>> out;
  const auto add = [&](auto&& shapes) {
    out.emplace_back();
    for (auto& shape : shapes) {
      out.back().emplace_back(std::move(shape));
    }
  };
  (add(abut::Shapes::At<places>::samples()), ...);
  return out;
}

bool is_surface(std::string_view kind) { return kind == "mesh" || kind == "height_field"; }
bool is_field(std::string_view kind) { return kind == "distance_field"; }

double size_of(const AnyShape& shape) {
  const abut::Aabb box = aabb_of(shape, Pose::identity());
  return box.is_bounded() ? norm(box.high - box.low) : 2;
}

class Agreement : public testing::Test {
 protected:
  static constexpr std::uint64_t seed = 11;
  static constexpr double margin_share = 0.02, tolerance_share = 1e-7;
  // The search of a nearest point of a field may end at another one that is a little further away.
  static constexpr int most_nearer = 2;
  static constexpr double nearer_share = 2e-4;

  struct Asked {
    abut::Distance distance;
    double deepest = infinity;  // of the contacts
    double size = 0, margin = 0;

    [[nodiscard]] double tolerance() const { return tolerance_share * size; }
  };

  // Calls visit(asked) for random poses of two kinds.
  template <class Visitor>
  void ask(std::size_t kind, std::size_t other, Visitor&& visit) {
    constexpr std::size_t most_samples = 3;
    constexpr int poses = 40;
    for (std::size_t i = 0; i < std::min(most_samples, kinds_[kind].size()); ++i) {
      for (std::size_t j = 0; j < std::min(most_samples, kinds_[other].size()); ++j) {
        for (int k = 0; k < poses; ++k) {
          ask_once(kinds_[kind][i], kinds_[other][j], visit);
        }
      }
    }
  }

  static constexpr std::size_t count = abut::shape_kind_count;

 private:
  [[nodiscard]] Pose pose(double scale) {
    const abut::Quat turn{normal_(random_), normal_(random_), normal_(random_), normal_(random_)};
    return {abut::Rotation::from(turn), scale * Vec3{normal_(random_), normal_(random_), normal_(random_)}};
  }
  template <class Visitor>
  void ask_once(const AnyShape& a, const AnyShape& b, Visitor& visit) {
    Asked asked;
    asked.size = size_of(a) + size_of(b);
    asked.margin = margin_share * asked.size;
    const Pose of_a = pose(0.1 * asked.size), of_b = pose(0.15 * asked.size);
    abut::QuerySettings settings;
    settings.margin = asked.margin;
    abut::Manifold contacts;
    if (pair_distance(a, b, of_a, of_b, settings, asked.distance) != Outcome::ok ||
        pair_contacts(a, b, of_a, of_b, settings, contacts) != Outcome::ok) {
      return;
    }
    for (const abut::ContactPoint& contact : contacts) {
      asked.deepest = std::min(asked.deepest, contact.distance);
    }
    visit(asked);
  }

  std::vector<std::vector<ShapeHandle>> kinds_ = samples_of_kinds(std::make_index_sequence<count>());
  std::mt19937_64 random_{seed};
  std::normal_distribution<double> normal_;
};

TEST_F(Agreement, OfSolidsIsToRounding) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i; j < count; ++j) {
      const std::string_view a = abut::kind_name(i), b = abut::kind_name(j);
      if (is_surface(a) || is_surface(b) || a.ends_with("_hole") || b.ends_with("_hole")) {
        continue;
      }
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::string(a) + " and " + std::string(b));
      int nearer = 0;
      ask(i, j, [&](const Asked& asked) {
        const double distance = asked.distance.distance;
        if (asked.deepest == infinity) {
          EXPECT_GE(distance, asked.margin - asked.tolerance()) << "a contact is missing";
          return;
        }
        const bool may_be_nearer = is_field(b) && distance > 0;
        nearer += may_be_nearer && asked.deepest < distance - asked.tolerance() ? 1 : 0;
        EXPECT_LE(asked.deepest, distance + asked.tolerance());
        EXPECT_GE(asked.deepest, distance - (may_be_nearer ? nearer_share * asked.size : asked.tolerance()));
      });
      EXPECT_LE(nearer, most_nearer);
    }
  }
}

TEST_F(Agreement, OfSurfacesThatAreApartIsOneSided) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i; j < count; ++j) {
      const std::string_view a = abut::kind_name(i), b = abut::kind_name(j);
      if (!is_surface(a) && !is_surface(b)) {
        continue;
      }
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::string(a) + " and " + std::string(b));
      int nearer = 0;
      ask(i, j, [&](const Asked& asked) {
        const double distance = asked.distance.distance;
        if (distance > asked.tolerance()) {
          nearer += asked.deepest < distance - asked.tolerance() ? 1 : 0;
          EXPECT_GE(asked.deepest,
                    distance - (is_field(a) || is_field(b) ? nearer_share * asked.size : asked.tolerance()));
        }
      });
      EXPECT_LE(nearer, is_field(a) || is_field(b) ? most_nearer : 0);
    }
  }
}

}  // namespace
