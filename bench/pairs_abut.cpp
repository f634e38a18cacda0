// SPDX-License-Identifier: Apache-2.0
// abut through its modules: poses in the world, the relative pose formed inside the timed part.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "abut_inputs.hpp"
#include "abut_queries.hpp"
#include "pairs.hpp"

import abut;
import abut.pairs.any_shape.casts.shape_cast;

namespace bench {
namespace {

abut::Pose pose_of(const Placement& placement) {
  const auto& [w, x, y, z] = placement.orientation;
  return {abut::Rotation::from({w, x, y, z}), {placement.position[0], placement.position[1], placement.position[2]}};
}

abut::AnyShape composite_of(const Solid& solid) {
  const auto place = abut::find_kind("box");
  std::vector<abut::PlacedShape> children;
  for (const Point& p : solid.points) {
    auto box = abut::make_shape(place.value(), solid.sizes, {}, {});
    children.push_back({std::move(box).value(), pose_of({p, {1, 0, 0, 0}})});
  }
  auto shape = abut::make_composite(children);
  if (!shape) {
    throw std::runtime_error(std::string(shape.error().message));
  }
  return *std::move(shape).value();
}

abut::AnyShape shape_of(const Solid& solid) {
  if (solid.kind == Kind::composite) {
    return composite_of(solid);
  }
  const auto place = abut::find_kind(abut_kind_name(solid));
  if (!place) {
    throw std::runtime_error("this build of abut lacks a shape of the benchmark");
  }
  auto shape = abut::make_shape(*place, abut_parameters(solid), abut_reals(solid), abut_indices(solid));
  if (!shape) {
    throw std::runtime_error(std::string(shape.error().message));
  }
  return *std::move(shape).value();
}

class Abut final : public Contender {
 public:
  Abut(Query query, const Cell& cell, const AbutQuery& asked) : query_(query) {
    settings_.algorithm = static_cast<abut::Algorithm>(asked.algorithm);
    settings_.error_bound = asked.error_bound;
    for (const Solid& solid : cell.solids_a) {
      a_.push_back(shape_of(solid));
    }
    for (const Solid& solid : cell.solids_b) {
      b_.push_back(shape_of(solid));
    }
    for (const Case& one : cell.cases) {
      const auto& [x, y, z] = one.motion;
      jobs_.push_back({one.a, one.b, pose_of(one.pose_a), pose_of(one.pose_b), {x, y, z}});
    }
  }

  void answer(std::span<Answer> answers) override {
    if (query_ == Query::contacts) {
      contacts(answers);
    } else if (query_ == Query::cast) {
      casts(answers);
    } else {
      distances(answers);
    }
  }

  [[nodiscard]] std::vector<Interval> intervals() const {
    std::vector<Interval> list;
    for (const Job& job : jobs_) {
      abut::Distance out;
      const bool is_answered = distance(job, out) == abut::Outcome::ok;
      list.push_back(is_answered ? Interval{out.lower, out.upper} : Interval{1, -1});
    }
    return list;
  }

 private:
  struct Job {
    std::size_t a, b;
    abut::Pose pose_a, pose_b;
    abut::Vec3 motion;
  };

  [[nodiscard]] abut::Outcome distance(const Job& job, abut::Distance& out) const {
    return abut::pair_distance(a_[job.a], b_[job.b], job.pose_a, job.pose_b, settings_, out);
  }

  void distances(std::span<Answer> answers) const {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      abut::Distance out;
      const abut::Outcome outcome = distance(jobs_[i], out);
      answers[i] = {out.distance, outcome == abut::Outcome::ok ? 1u : 0u};
    }
  }

  void casts(std::span<Answer> answers) const {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const Job& job = jobs_[i];
      std::optional<abut::ShapeCastHit> hit;
      const abut::Outcome outcome =
          abut::cast_shapes(a_[job.a], job.pose_a, {0, 0, 0}, b_[job.b], job.pose_b, job.motion, settings_, 1, hit);
      answers[i] = {hit ? hit->fraction : 1, outcome == abut::Outcome::ok ? 1u : 0u};
    }
  }

  void contacts(std::span<Answer> answers) {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const Job& job = jobs_[i];
      manifold_.clear();
      const abut::Outcome outcome =
          abut::pair_contacts(a_[job.a], b_[job.b], job.pose_a, job.pose_b, settings_, manifold_);
      Answer found;
      if (outcome == abut::Outcome::ok) {
        for (const abut::ContactPoint& point : manifold_) {
          if (point.distance < 0) {
            found.distance = std::min(found.distance, point.distance);
            ++found.points;
          }
        }
      }
      answers[i] = found;
    }
  }

  Query query_;
  std::vector<abut::AnyShape> a_, b_;
  std::vector<Job> jobs_;
  abut::QuerySettings settings_;
  abut::Manifold manifold_;
};

}  // namespace

std::unique_ptr<Contender> make_abut(Query query, const Cell& cell, const AbutQuery& asked) {
  // These take neither bounds nor algorithms.
  if (query == Query::overlap || query == Query::ray || query == Query::impact) {
    const bool is_default = asked.algorithm == ABUT_ALGORITHM_AUTO && asked.error_bound == 0;
    return is_default ? make_abut_c(query, cell) : nullptr;
  }
  auto contender = std::make_unique<Abut>(query, cell, asked);
  std::vector<Answer> answers(cell.cases.size());
  contender->answer(answers);
  const bool any = std::ranges::any_of(answers, [](const Answer& answer) { return answer.points > 0; });
  return any ? std::move(contender) : nullptr;
}

std::vector<Interval> abut_intervals(const Cell& cell, const AbutQuery& asked) {
  return Abut(Query::distance, cell, asked).intervals();
}

std::unique_ptr<Contender> make_abut(Query query, const Cell& cell) {
  return std::make_unique<Abut>(query, cell, AbutQuery{});
}
// libccd answers nothing for shapes that are apart, for planes, and in builds without it.
std::unique_ptr<Contender> make_abut_ccd_gjk(Query query, const Cell& cell) {
  return query == Query::cast ? nullptr : make_abut(query, cell, {ABUT_ALGORITHM_LIBCCD_GJK});
}
std::unique_ptr<Contender> make_abut_ccd_mpr(Query query, const Cell& cell) {
  return query == Query::cast ? nullptr : make_abut(query, cell, {ABUT_ALGORITHM_LIBCCD_MPR});
}

void find_surface(Solid& hull) {
  const abut::AnyShape shape = shape_of(hull);
  const auto surface = abut::triangles_of(shape);
  if (!surface) {
    throw std::runtime_error("a hull without a surface");
  }
  hull.points.clear();
  for (const abut::Vec3& p : surface->vertices) {
    hull.points.push_back({p.x, p.y, p.z});
  }
  hull.triangles.clear();
  for (std::size_t i = 0; i + 2 < surface->indices.size(); i += 3) {
    hull.triangles.push_back({static_cast<int>(surface->indices[i]), static_cast<int>(surface->indices[i + 1]),
                              static_cast<int>(surface->indices[i + 2])});
  }
}

}  // namespace bench
