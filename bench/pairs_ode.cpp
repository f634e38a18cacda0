// SPDX-License-Identifier: Apache-2.0
// ODE in double precision: contacts only, it has no query for distances.
#include <ode/ode.h>

#include <algorithm>
#include <array>
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
  explicit Ode(const Cell& cell)
      : most_contacts_(is_surface(cell.solids_a.front().kind) ? 64 : 4),
        convexes_a_(ode_convexes(cell.solids_a)),
        convexes_b_(ode_convexes(cell.solids_b)) {
    for (const Case& one : cell.cases) {
      jobs_.push_back({ode_geom(cell.solids_a[one.a], convexes_a_[one.a], one.pose_a),
                       ode_geom(cell.solids_b[one.b], convexes_b_[one.b], one.pose_b)});
    }
  }

  void answer(std::span<Answer> answers) override {
    std::array<dContactGeom, 64> contacts;
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const int count =
          dCollide(jobs_[i].a.get(), jobs_[i].b.get(), most_contacts_, contacts.data(), sizeof(dContactGeom));
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
  };

  int most_contacts_;
  std::vector<OdeConvex> convexes_a_, convexes_b_;
  std::vector<Job> jobs_;
};

bool is_known(Kind kind) { return kind != Kind::cone && kind != Kind::ellipsoid && kind != Kind::triangle; }

}  // namespace

std::unique_ptr<Contender> make_ode(Query query, const Cell& cell) {
  if (query != Query::contacts || !is_known(cell.solids_a.front().kind) || !is_known(cell.solids_b.front().kind)) {
    return nullptr;
  }
  return start_ode() ? std::make_unique<Ode>(cell) : nullptr;
}

}  // namespace bench
