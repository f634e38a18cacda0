// SPDX-License-Identifier: Apache-2.0
// abut through its C interface: poses with quaternions, checked on every call.
#include <abut/abut.h>

#include <algorithm>
#include <array>
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
                       {one.motion[0], one.motion[1], one.motion[2]}});
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
      answers[i] = query_ == Query::contacts ? contacts(job, pose_b, memory)
                   : query_ == Query::cast   ? cast(job)
                                             : distance(job, pose_b, memory);
    }
    ++round_;
  }

 private:
  struct Job {
    std::size_t a, b;
    abut_pose pose_a, pose_b;
    abut_vec3 motion;
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
// Depths and casts have no memory of their own.
std::unique_ptr<Contender> make_abut_c_warm(Query query, const Cell& cell) {
  return query == Query::depth || query == Query::cast ? nullptr : std::make_unique<AbutC>(query, cell, true);
}

}  // namespace bench
