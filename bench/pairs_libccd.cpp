// SPDX-License-Identifier: Apache-2.0
// libccd by itself, with support functions of our own: penetration by GJK and EPA, and by MPR.
#include <ccd/ccd.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "pairs.hpp"

namespace bench {
namespace {

struct Rotation {
  Point x, y, z;  // columns
};

struct Body {
  const Solid* solid;
  Rotation rotation;
  Point position;
};

Rotation rotation_of(const std::array<double, 4>& q) {
  const auto& [w, x, y, z] = q;
  return {{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
          {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
          {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}};
}

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point local_support(const Solid& solid, const Point& d) {
  switch (solid.kind) {
    case Kind::sphere:
    case Kind::capsule: {
      const double scale = solid.sizes[0] / std::sqrt(dot(d, d));
      const double up = solid.kind == Kind::capsule ? std::copysign(solid.sizes[1], d[2]) : 0;
      return {scale * d[0], scale * d[1], scale * d[2] + up};
    }
    case Kind::box:
      return {std::copysign(solid.sizes[0], d[0]), std::copysign(solid.sizes[1], d[1]),
              std::copysign(solid.sizes[2], d[2])};
    case Kind::cylinder:
    case Kind::cone: {
      const double around = std::hypot(d[0], d[1]), radius = solid.sizes[0], half = solid.sizes[1];
      // Towards the apex: steeper than the normal of the side.
      if (solid.kind == Kind::cone && 2 * half * d[2] >= radius * around) {
        return {0, 0, half};
      }
      const double scale = around > 0 ? radius / around : 0;
      return {scale * d[0], scale * d[1], solid.kind == Kind::cone ? -half : std::copysign(half, d[2])};
    }
    case Kind::ellipsoid: {
      const Point stretched{solid.sizes[0] * d[0], solid.sizes[1] * d[1], solid.sizes[2] * d[2]};
      const double scale = 1 / std::sqrt(dot(stretched, stretched));
      return {scale * solid.sizes[0] * stretched[0], scale * solid.sizes[1] * stretched[1],
              scale * solid.sizes[2] * stretched[2]};
    }
    case Kind::plane:
    case Kind::mesh:
    case Kind::height_field:
    case Kind::solid_mesh:
    case Kind::distance_field:
    case Kind::particles:
    case Kind::point:
    case Kind::composite: return {};
    case Kind::hull32:
    case Kind::hull200:
    case Kind::hull:
    case Kind::triangle: {
      double top = -std::numeric_limits<double>::infinity();
      Point best{};
      for (const Point& p : solid.points) {
        if (const double value = dot(p, d); value > top) {
          top = value;
          best = p;
        }
      }
      return best;
    }
  }
  return {};
}

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  const Body& body = *static_cast<const Body*>(object);
  const Rotation& r = body.rotation;
  const Point d{ccdVec3X(direction), ccdVec3Y(direction), ccdVec3Z(direction)};
  const Point p = local_support(*body.solid, {dot(r.x, d), dot(r.y, d), dot(r.z, d)});
  ccdVec3Set(out, r.x[0] * p[0] + r.y[0] * p[1] + r.z[0] * p[2] + body.position[0],
             r.x[1] * p[0] + r.y[1] * p[1] + r.z[1] * p[2] + body.position[1],
             r.x[2] * p[0] + r.y[2] * p[1] + r.z[2] * p[2] + body.position[2]);
}

void centre(const void* object, ccd_vec3_t* out) {
  const Point& p = static_cast<const Body*>(object)->position;
  ccdVec3Set(out, p[0], p[1], p[2]);
}

using Intersect = int (*)(const void*, const void*, const ccd_t*);
using Penetration = int (*)(const void*, const void*, const ccd_t*, ccd_real_t*, ccd_vec3_t*, ccd_vec3_t*);

struct Search {
  Intersect intersect;
  Penetration penetration;
};

class Libccd final : public Contender {
 public:
  Libccd(const Search& search, Query query, const Cell& cell)
      : search_(search),
        query_(query),
        solids_a_(cell.solids_a.begin(), cell.solids_a.end()),
        solids_b_(cell.solids_b.begin(), cell.solids_b.end()) {
    for (const Case& one : cell.cases) {
      jobs_.push_back({{&solids_a_[one.a], rotation_of(one.pose_a.orientation), one.pose_a.position},
                       {&solids_b_[one.b], rotation_of(one.pose_b.orientation), one.pose_b.position}});
    }
    CCD_INIT(&settings_);
    settings_.support1 = settings_.support2 = support;
    settings_.center1 = settings_.center2 = centre;
    settings_.max_iterations = 500;
    settings_.epa_tolerance = settings_.mpr_tolerance = 1e-6;
  }

  void answer(std::span<Answer> answers) override {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      if (query_ == Query::overlap) {
        answers[i] = {search_.intersect(&jobs_[i].a, &jobs_[i].b, &settings_) != 0 ? -1.0 : 1.0, 1};
        continue;
      }
      ccd_real_t depth = 0;
      ccd_vec3_t direction{}, position{};
      const bool found = search_.penetration(&jobs_[i].a, &jobs_[i].b, &settings_, &depth, &direction, &position) == 0;
      answers[i] = found ? Answer{-depth, 1} : Answer{};
    }
  }

 private:
  struct Job {
    Body a, b;
  };

  Search search_;
  Query query_;
  std::vector<Solid> solids_a_, solids_b_;
  std::vector<Job> jobs_;
  ccd_t settings_{};
};

std::unique_ptr<Contender> make_libccd(const Search& search, Query query, const Cell& cell) {
  const bool is_asked = query == Query::depth || query == Query::contacts || query == Query::overlap;
  if (!is_asked || !is_bounded_and_convex(cell.solids_a.front().kind) ||
      !is_bounded_and_convex(cell.solids_b.front().kind)) {
    return nullptr;
  }
  return std::make_unique<Libccd>(search, query, cell);
}

}  // namespace

std::unique_ptr<Contender> make_libccd_gjk(Query query, const Cell& cell) {
  return make_libccd({ccdGJKIntersect, ccdGJKPenetration}, query, cell);
}
std::unique_ptr<Contender> make_libccd_mpr(Query query, const Cell& cell) {
  return make_libccd({ccdMPRIntersect, ccdMPRPenetration}, query, cell);
}

}  // namespace bench
