// SPDX-License-Identifier: Apache-2.0
module abut.detect.backend;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.detect.pairs.sides;
import abut.math;
import abut.pairs.any_shape;
import abut.scene.state.options;
import abut.scene.state.places;

namespace abut {

void BackendStage::set(Backend backend) {
  std::array<bool, pair_run_count> accepted{};
  for (std::size_t row = 0; backend.find && row < shape_kind_count; ++row) {
    for (std::size_t column = row; column < shape_kind_count; ++column) {
      accepted[run_of(row, column)] = !backend.accepts || backend.accepts(row, column);
    }
  }
  accepted_ = accepted;
  find_ = std::move(backend.find);
  asked_.clear();
  of_job_.clear();
  answered_ = 0;
}

void BackendStage::run(const Places& places, std::span<const Pair> pairs, const SideStage& sides, const JobList& jobs) {
  if (!is_on()) {
    return;
  }
  asked_.clear();
  jobs_.clear();
  points_.clear();
  answered_ = 0;
  of_job_.assign(jobs.jobs().size(), Given{});
  for (const Pair& pair : pairs) {
    const bool is_usual = pair.job != no_job && !pair.is_on_path && !pair.is_by_elements && is_pair_run(pair.run);
    if (is_usual && accepted_[pair.run] && !sides.has(pair.job)) {
      asked_.push_back({places.id_at(pair.low), places.id_at(pair.high), jobs.jobs()[pair.job].margin});
      jobs_.push_back(pair.job);
    }
  }
  if (asked_.empty()) {
    return;
  }
  is_asking_ = true;
  try {
    find_();
  } catch (...) {
    is_asking_ = false;
    throw;
  }
  is_asking_ = false;
}

Fault BackendStage::answer(std::size_t pair, std::span<const ContactPoint> contacts) {
  if (pair >= asked_.size()) {
    return error_about(Errc::index_out_of_range, "pair", static_cast<std::uint64_t>(pair),
                       "below " + std::to_string(asked_.size()));
  }
  Given& given = of_job_[jobs_[pair]];
  if (given.is_given) {
    return error_about(Errc::invalid_argument, "pair", static_cast<std::uint64_t>(pair),
                       "one that has no answer in this call yet");
  }
  const std::size_t first = points_.size();
  points_.insert(points_.end(), contacts.begin(), contacts.end());
  const std::span<ContactPoint> its = std::span(points_).subspan(first);
  for (ContactPoint& contact : its) {
    contact.id = contact.id == 0 ? contact_id(contact.feature_a, contact.feature_b) : contact.id;
  }
  number_apart(its);
  given = {first, contacts.size(), true};
  ++answered_;
  return std::nullopt;
}

std::size_t BackendStage::bytes() const {
  return asked_.capacity() * sizeof(BackendPair) + jobs_.capacity() * sizeof(std::uint32_t) +
         of_job_.capacity() * sizeof(Given) + points_.capacity() * sizeof(ContactPoint);
}

}  // namespace abut
