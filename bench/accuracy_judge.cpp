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
    case Kind::height_field: break;
  }
  throw std::runtime_error("a shape without a judge: " + std::string(kind_name(solid.kind)));
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

std::optional<oracle::Quad> true_distance(Judge& a, const Placement& pose_a, Judge& b, const Placement& pose_b,
                                          bool with_overlaps) {
  const oracle::Pose at_a = oracle_pose(pose_a), at_b = oracle_pose(pose_b);
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

oracle::Quad true_cast(const Judge& a, const Placement& pose_a, const Judge& b, const Placement& pose_b,
                       const Point& motion) {
  constexpr int most_steps = 200;
  const oracle::Vec way{oracle::quad(motion[0]), oracle::quad(motion[1]), oracle::quad(motion[2])};
  const oracle::Pose at_a = oracle_pose(pose_a);
  oracle::Pose at_b = oracle_pose(pose_b);
  const oracle::Vec start = at_b.position;
  oracle::Quad share = 0;
  for (int i = 0; i < most_steps && share < 1; ++i) {
    at_b.position = start + way * share;
    const oracle::Nearest found = oracle::nearest(a.solid(), at_a, b.solid(), at_b);
    const oracle::Quad closing = -oracle::dot(found.normal, way);
    const bool is_there = !found.is_known || found.lower <= oracle::quad(enough) * oracle::quad(b.solid().size);
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

}  // namespace bench
