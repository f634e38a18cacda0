// SPDX-License-Identifier: Apache-2.0
// abut through its C interface: poses with quaternions, checked on every call.
#include <abut/abut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include "abut_c_shapes.hpp"
#include "pairs.hpp"

namespace bench {
namespace {

class AbutC final : public Contender {
 public:
  AbutC(Query query, const Cell& cell, bool is_warm) : query_(query) {
    for (const Solid& solid : cell.solids_a) {
      a_.push_back(abut_c_shape(solid));
    }
    for (const Solid& solid : cell.solids_b) {
      b_.push_back(abut_c_shape(solid));
    }
    for (const Case& one : cell.cases) {
      jobs_.push_back({one.a,
                       one.b,
                       abut_c_pose(one.pose_a),
                       abut_c_pose(one.pose_b),
                       {one.motion[0], one.motion[1], one.motion[2]},
                       {one.turn[0], one.turn[1], one.turn[2]}});
    }
    if (is_warm) {
      memories_.resize(jobs_.size());
    }
  }

  void answer(std::span<Answer> answers) override {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const Job& job = jobs_[i];
      abut_pose pose_b = job.pose_b;
      if (!memories_.empty()) {
        pose_b.position.x += sway[round_ % sway.size()];
        pose_b.position.z -= sway[round_ % sway.size()];
      }
      abut_pair_memory* memory = memories_.empty() ? nullptr : &memories_[i];
      switch (query_) {
        case Query::distance:
        case Query::depth: answers[i] = distance(job, pose_b, memory); break;
        case Query::contacts: answers[i] = contacts(job, pose_b, memory); break;
        case Query::cast: answers[i] = cast(job); break;
        case Query::overlap: answers[i] = overlap(job); break;
        case Query::ray: answers[i] = ray(job); break;
        case Query::impact: answers[i] = impact(job); break;
      }
    }
    ++round_;
  }

 private:
  struct Job {
    std::size_t a, b;
    abut_pose pose_a, pose_b;
    abut_vec3 motion, turn;
  };
  static constexpr std::array sway{0.0, 5e-4, 1e-3, 5e-4};

  [[nodiscard]] Answer distance(const Job& job, const abut_pose& pose_b, abut_pair_memory* memory) const {
    const abut_shape *a = a_[job.a].get(), *b = b_[job.b].get();
    abut_distance out;
    const abut_status status = memory == nullptr
                                   ? abut_pair_distance(a, &job.pose_a, b, &pose_b, nullptr, &out)
                                   : abut_pair_distance_with_memory(a, &job.pose_a, b, &pose_b, nullptr, memory, &out);
    return status == ABUT_OK ? Answer{out.distance, 1} : Answer{};
  }
  [[nodiscard]] Answer cast(const Job& job) const {
    const abut_vec3 rest{0, 0, 0};
    abut_cast_hit hit;
    std::uint32_t found = 0;
    const abut_status status = abut_pair_cast(a_[job.a].get(), &job.pose_a, &rest, b_[job.b].get(), &job.pose_b,
                                              &job.motion, nullptr, &hit, &found);
    return status == ABUT_OK ? Answer{found != 0 ? hit.fraction : 1, 1} : Answer{};
  }
  [[nodiscard]] Answer overlap(const Job& job) const {
    std::uint32_t out = 0;
    const abut_status status =
        abut_pair_overlaps(a_[job.a].get(), &job.pose_a, b_[job.b].get(), &job.pose_b, nullptr, &out);
    return status == ABUT_OK ? Answer{out != 0 ? -1.0 : 1.0, 1} : Answer{};
  }
  [[nodiscard]] Answer ray(const Job& job) const {
    const double length = std::hypot(job.motion.x, job.motion.y, job.motion.z);
    const abut_ray ray{job.pose_b.position, job.motion, length};
    abut_ray_hit hit;
    std::uint32_t found = 0;
    const abut_status status = abut_shape_cast_ray(a_[job.a].get(), &job.pose_a, &ray, &hit, &found);
    return status == ABUT_OK ? Answer{found != 0 ? hit.distance / length : 1, 1} : Answer{};
  }
  [[nodiscard]] Answer impact(const Job& job) const {
    const abut_movement rest{};
    abut_movement way{};
    way.velocity = job.motion;
    way.angular_velocity = job.turn;
    abut_impact out;
    const abut_status status = abut_pair_time_of_impact(a_[job.a].get(), &job.pose_a, &rest, b_[job.b].get(),
                                                        &job.pose_b, &way, 1, nullptr, &out);
    const bool is_answered = status == ABUT_OK && out.state != ABUT_IMPACT_UNDECIDED;
    return is_answered ? Answer{out.upper, 1} : Answer{};
  }
  [[nodiscard]] Answer contacts(const Job& job, const abut_pose& pose_b, abut_pair_memory* memory) const {
    const abut_shape *a = a_[job.a].get(), *b = b_[job.b].get();
    std::array<abut_contact, 64> out;
    std::size_t count = 0;
    Answer found;
    const abut_status status =
        memory == nullptr ? abut_pair_contacts(a, &job.pose_a, b, &pose_b, nullptr, out.data(), out.size(), &count)
                          : abut_pair_contacts_with_memory(a, &job.pose_a, b, &pose_b, nullptr, memory, out.data(),
                                                           out.size(), &count);
    if (status == ABUT_OK) {
      for (const abut_contact& contact : std::span(out).first(std::min(count, out.size()))) {
        found.distance = std::min(found.distance, contact.distance);
        found.points += contact.distance < 0 ? 1 : 0;
      }
    }
    return found;
  }

  Query query_;
  std::vector<AbutCShape> a_, b_;
  std::vector<Job> jobs_;
  std::vector<abut_pair_memory> memories_;  // none, or one for each job
  std::size_t round_ = 0;
};

}  // namespace

std::unique_ptr<Contender> make_abut_c(Query query, const Cell& cell) {
  return std::make_unique<AbutC>(query, cell, false);
}
// Others have no memory of their own.
std::unique_ptr<Contender> make_abut_c_warm(Query query, const Cell& cell) {
  const bool is_remembered = query == Query::distance || query == Query::contacts;
  return is_remembered ? std::make_unique<AbutC>(query, cell, true) : nullptr;
}

}  // namespace bench
