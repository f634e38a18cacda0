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
  AbutC(Query query, const Cell& cell) : query_(query) {
    for (const Solid& solid : cell.solids_a) {
      a_.push_back(abut_c_shape(solid));
    }
    for (const Solid& solid : cell.solids_b) {
      b_.push_back(abut_c_shape(solid));
    }
    for (const Case& one : cell.cases) {
      jobs_.push_back({one.a, one.b, abut_c_pose(one.pose_a), abut_c_pose(one.pose_b)});
    }
  }

  void answer(std::span<Answer> answers) override {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      answers[i] = query_ == Query::contacts ? contacts(jobs_[i]) : distance(jobs_[i]);
    }
  }

 private:
  struct Job {
    std::size_t a, b;
    abut_pose pose_a, pose_b;
  };

  [[nodiscard]] Answer distance(const Job& job) const {
    abut_distance out;
    if (abut_pair_distance(a_[job.a].get(), &job.pose_a, b_[job.b].get(), &job.pose_b, nullptr, &out) != ABUT_OK) {
      return {};
    }
    return {out.distance, 1};
  }
  [[nodiscard]] Answer contacts(const Job& job) const {
    std::array<abut_contact, 4> out;
    std::size_t count = 0;
    Answer found;
    if (abut_pair_contacts(a_[job.a].get(), &job.pose_a, b_[job.b].get(), &job.pose_b, nullptr, out.data(), out.size(),
                           &count) == ABUT_OK) {
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
};

}  // namespace

std::unique_ptr<Contender> make_abut_c(Query query, const Cell& cell) { return std::make_unique<AbutC>(query, cell); }

}  // namespace bench
