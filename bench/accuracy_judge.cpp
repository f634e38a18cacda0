// SPDX-License-Identifier: Apache-2.0
#include "accuracy_judge.hpp"

#include <stdexcept>

#include "oracle/nearest.hpp"

namespace bench {
namespace {

// Of the size: the interval of the oracle may be this wide.
constexpr double enough = 1e-18;

std::optional<oracle::Body> body_of(const Solid& solid) {
  const Point& s = solid.sizes;
  switch (solid.kind) {
    case Kind::sphere: return oracle::make_sphere(s[0]);
    case Kind::point: return oracle::make_sphere(0);
    case Kind::capsule: return oracle::make_capsule(s[0], s[1]);
    case Kind::box: return oracle::make_box(s[0], s[1], s[2]);
    case Kind::hull32:
    case Kind::hull200:
    case Kind::hull:
    case Kind::triangle: return oracle::make_hull(solid.points);
    case Kind::cylinder:
    case Kind::cone:
    case Kind::ellipsoid: return std::nullopt;
    case Kind::plane:
    case Kind::mesh:
    case Kind::height_field:
    case Kind::solid_mesh:
    case Kind::distance_field:
    case Kind::particles:
    case Kind::composite: break;
  }
  throw std::runtime_error("a shape without a judge: " + std::string(kind_name(solid.kind)));
}

oracle::Vec vec_of(const Point& p) { return {oracle::quad(p[0]), oracle::quad(p[1]), oracle::quad(p[2])}; }

// Turned by a vector, its axis times its angle, in the world. Sine and cosine are series, of a few radians at most.
oracle::Pose turned(const oracle::Pose& pose, const oracle::Vec& turn) {
  const oracle::Quad half = oracle::length(turn) / 2;
  oracle::Quad cosine = 0, part = 0, term = 1;  // part: sine of the half over the half
  for (int i = 0; i < 60; ++i) {
    (i % 2 == 0 ? cosine : part) += term;
    term *= i % 2 == 0 ? oracle::Quad{1} / (i + 1) : -half * half / (i + 1);
  }
  const oracle::Vec s = turn * (part / 2);
  const auto& [w, x, y, z] = pose.orientation;
  oracle::Pose result = pose;
  result.orientation = {cosine * w - s.x * x - s.y * y - s.z * z, cosine * x + s.x * w + s.y * z - s.z * y,
                        cosine * y - s.x * z + s.y * w + s.z * x, cosine * z + s.x * y - s.y * x + s.z * w};
  return result;
}

oracle::Solid solid_of(const Solid& solid, const std::optional<oracle::Body>& body) {
  const Point& s = solid.sizes;
  if (solid.kind == Kind::box) {
    return oracle::solid_of(oracle::Box{s});
  }
  if (solid.kind == Kind::cone) {
    return oracle::solid_of(oracle::Cone{s[0], s[1]});
  }
  if (solid.kind == Kind::ellipsoid) {
    return oracle::solid_of(oracle::Ellipsoid{s});
  }
  return body ? oracle::solid_of(*body) : oracle::solid_of(oracle::Cylinder{s[0], s[1]});
}

}  // namespace

Judge::Judge(const Solid& solid) : body_(body_of(solid)), solid_(solid_of(solid, body_)) {}

const std::optional<oracle::Measured>& Judge::features() {
  if (!features_ && body_) {
    features_ = oracle::measured(*body_);
  }
  return features_;
}

oracle::Pose oracle_pose(const Placement& placement) {
  return oracle::Pose::from(placement.position, placement.orientation);
}

std::optional<oracle::Quad> true_distance(Judge& a, const oracle::Pose& at_a, Judge& b, const oracle::Pose& at_b,
                                          bool with_overlaps) {
  const oracle::Nearest nearest = oracle::nearest(a.solid(), at_a, b.solid(), at_b);
  const oracle::Quad width = nearest.upper - nearest.lower;
  if (nearest.is_known && width <= oracle::quad(enough) * oracle::quad(a.solid().size + b.solid().size)) {
    return nearest.lower + width / 2;
  }
  const bool is_of_use = nearest.is_known || with_overlaps;
  if (!is_of_use || !a.features() || !b.features()) {
    return std::nullopt;
  }
  return oracle::signed_distance(*a.features(), at_a, *b.features(), at_b).distance;
}

std::optional<oracle::Quad> least_distance(const Judge& a, const oracle::Pose& at_a, const Judge& b,
                                           const oracle::Pose& at_b) {
  const oracle::Nearest nearest = oracle::nearest(a.solid(), at_a, b.solid(), at_b);
  return nearest.is_known ? std::optional(nearest.lower) : std::nullopt;
}

oracle::Quad true_cast(const Judge& a, const oracle::Pose& at_a, const Judge& b, oracle::Pose at_b,
                       const Point& motion) {
  constexpr int most_steps = 200;
  const oracle::Vec way = vec_of(motion), start = at_b.position;
  const oracle::Quad least = oracle::quad(enough) * oracle::quad(a.solid().size + b.solid().size);
  oracle::Quad share = 0;
  for (int i = 0; i < most_steps && share < 1; ++i) {
    at_b.position = start + way * share;
    const oracle::Nearest found = oracle::nearest(a.solid(), at_a, b.solid(), at_b);
    const oracle::Quad closing = -oracle::dot(found.normal, way);
    const bool is_there = !found.is_known || found.lower <= least;
    if (is_there) {
      return share;
    }
    if (closing <= 0) {
      return 1;
    }
    share += found.lower / closing;
  }
  return oracle::smaller(share, 1);
}

std::optional<oracle::Quad> true_impact(const DistanceAt& distance_at, const oracle::Pose& from, const Point& motion,
                                        const Point& turn, double reach) {
  constexpr int most_steps = 400;
  const oracle::Vec way = vec_of(motion), around = vec_of(turn);
  const oracle::Quad most_speed = oracle::length(way) + oracle::length(around) * oracle::quad(reach);
  const oracle::Quad near = oracle::quad(1e-3 * reach), there = oracle::quad(enough * reach);
  const auto distance = [&](oracle::Quad share) {
    oracle::Pose at = turned(from, around * share);
    at.position = from.position + way * share;
    return distance_at(at);
  };
  oracle::Quad share = 0;
  std::optional<oracle::Quad> now = distance(0);
  for (int i = 0; i < most_steps; ++i) {
    if (!now || *now <= there) {
      return share;
    }
    const oracle::Quad safe = share + *now / most_speed;
    if (safe >= 1) {
      return 1;
    }
    const std::optional<oracle::Quad> next = distance(safe);
    // Close to the touch the distance is nearly straight: most of the way to where the line through both ends.
    if (next && *next > there && *next < near && *next < *now) {
      const oracle::Quad ahead = safe + oracle::quad(0.95) * *next * (safe - share) / (*now - *next);
      const std::optional<oracle::Quad> found = distance(ahead);
      if (found && *found >= 0 && *found < *next) {
        share = ahead;
        now = found;
        continue;
      }
    }
    share = safe;
    now = next;
  }
  return std::nullopt;
}

}  // namespace bench
