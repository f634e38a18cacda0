// SPDX-License-Identifier: Apache-2.0
// ODE in double precision: contacts, yes or no, and rays. It has no query for distances.
#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "ode_shapes.hpp"
#include "pairs.hpp"

namespace bench {
namespace {

class Ode final : public Contender {
 public:
  Ode(Query query, const Cell& cell)
      : query_(query),
        most_contacts_(query != Query::contacts                 ? 1
                       : is_surface(cell.solids_a.front().kind) ? 64
                                                                : 4),
        convexes_a_(ode_convexes(cell.solids_a)),
        convexes_b_(ode_convexes(cell.solids_b)) {
    for (const Case& one : cell.cases) {
      const double length = std::hypot(one.motion[0], one.motion[1], one.motion[2]);
      jobs_.push_back(
          {ode_geom(cell.solids_a[one.a], convexes_a_[one.a], one.pose_a),
           query == Query::ray ? ode_ray(one, length) : ode_geom(cell.solids_b[one.b], convexes_b_[one.b], one.pose_b),
           length});
    }
  }

  void answer(std::span<Answer> answers) override {
    std::array<dContactGeom, 64> contacts;
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const int count =
          dCollide(jobs_[i].a.get(), jobs_[i].b.get(), most_contacts_, contacts.data(), sizeof(dContactGeom));
      if (query_ == Query::overlap) {
        answers[i] = {count > 0 ? -1.0 : 1.0, 1};
        continue;
      }
      if (query_ == Query::ray) {
        answers[i] = {count > 0 ? contacts.front().depth / jobs_[i].length : 1, 1};
        continue;
      }
      Answer found;
      for (const dContactGeom& contact : std::span(contacts).first(static_cast<std::size_t>(count))) {
        found.distance = std::min(found.distance, -contact.depth);
        found.points += contact.depth > 0 ? 1 : 0;
      }
      answers[i] = found;
    }
  }

 private:
  struct Job {
    OdeGeom a, b;
    double length;  // of a ray
  };

  static OdeGeom ode_ray(const Case& one, double length) {
    OdeGeom ray(dCreateRay(nullptr, length));
    const Point &p = one.pose_b.position, &d = one.motion;
    dGeomRaySet(ray.get(), p[0], p[1], p[2], d[0], d[1], d[2]);
    dGeomRaySetClosestHit(ray.get(), 1);
    return ray;
  }

  Query query_;
  int most_contacts_;
  std::vector<OdeConvex> convexes_a_, convexes_b_;
  std::vector<Job> jobs_;
};

bool is_known(Kind kind) {
  return is_surface(kind) || kind == Kind::plane ||
         (is_bounded_and_convex(kind) && kind != Kind::cone && kind != Kind::ellipsoid && kind != Kind::triangle);
}

}  // namespace

std::unique_ptr<Contender> make_ode(Query query, const Cell& cell) {
  const bool is_asked = query == Query::contacts || query == Query::overlap || query == Query::ray;
  if (!is_asked || !is_known(cell.solids_a.front().kind) || !is_known(cell.solids_b.front().kind)) {
    return nullptr;
  }
  // It has no collider for these two.
  if (cell.solids_a.front().kind == Kind::mesh && is_hull(cell.solids_b.front().kind)) {
    return nullptr;
  }
  return start_ode() ? std::make_unique<Ode>(query, cell) : nullptr;
}

}  // namespace bench
