// SPDX-License-Identifier: Apache-2.0
// The first impact of many parts, found so far.
export module abut.motion.impacts.best_impact;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.motion.time_of_impact;

export namespace abut {

class BestImpact {
 public:
  explicit BestImpact(Real duration) : end_(duration), duration_(duration) {}

  // Later impacts are of no interest.
  [[nodiscard]] Real end() const { return end_; }
  [[nodiscard]] bool is_at_start() const { return best_ && best_->state == ImpactState::starts_together; }

  void add(const Impact& impact) {
    rounds_ += impact.rounds;
    if (impact.state == ImpactState::undecided) {
      undecided_ = std::min(undecided_, impact.lower);
      are_seen_free_ = are_seen_free_ && impact.is_seen_free;
    } else if (impact.state != ImpactState::apart && !(best_ && best_->upper <= impact.upper)) {
      best_ = impact;
      end_ = std::min(end_, impact.upper);
    }
  }

  // What is undecided before a touch makes its interval wider.
  [[nodiscard]] Impact result() const {
    Impact out = best_.value_or(Impact{});
    if (!best_) {
      out.state = undecided_ < infinity ? ImpactState::undecided : ImpactState::apart;
      out.lower = out.upper = duration_;
      out.is_seen_free = out.state == ImpactState::undecided && are_seen_free_;
    }
    out.lower = std::min(out.lower, undecided_);
    out.rounds = rounds_;
    return out;
  }

 private:
  Real end_, duration_;
  Real undecided_ = infinity;
  bool are_seen_free_ = true;
  std::optional<Impact> best_;
  std::uint32_t rounds_ = 0;
};

}  // namespace abut
