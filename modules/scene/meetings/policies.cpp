// SPDX-License-Identifier: Apache-2.0
module abut.scene.meetings.policies;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.scene.state.options;

namespace abut {

// The list holds each policy once and drops those that nobody uses, so that it never outgrows the pairs of tags.
void PolicyTable::set(std::uint32_t tag_a, std::uint32_t tag_b, const Policy& policy) {
  if (numbers_.empty()) {
    numbers_.resize(std::size_t{tag_count} * tag_count);
  }
  const std::vector<Policy> before = policies_;
  const auto assigned = [&](std::size_t cell) -> const Policy& {
    const bool is_set = cell == tag_a * tag_count + tag_b || cell == tag_b * tag_count + tag_a;
    return is_set ? policy : before[numbers_[cell]];
  };
  policies_.assign(1, Policy{});
  for (std::size_t cell = 0; cell < numbers_.size(); ++cell) {
    const Policy wanted = assigned(cell);
    const auto found = std::ranges::find(policies_, wanted);
    const auto number = static_cast<std::uint32_t>(found - policies_.begin());
    if (found == policies_.end()) {
      policies_.push_back(wanted);
    }
    numbers_[cell] = number;
  }
  largest_tolerance_ = 0;
  for (const Policy& its : policies_) {
    largest_tolerance_ = std::max(largest_tolerance_, its.tolerance);
  }
  tags_of_elements_ = find_tags_of_elements();
}

std::uint64_t PolicyTable::find_tags_of_elements() const {
  std::uint64_t tags = 0;
  for (std::size_t cell = 0; cell < numbers_.size(); ++cell) {
    if (policies_[numbers_[cell]].detail == Detail::elements) {
      tags |= std::uint64_t{1} << cell / tag_count;
    }
  }
  return tags;
}

namespace {

Fault check_share(std::string_view name, Real value) {
  Fault fault = check_not_negative(name, value);
  return fault || value <= 1 ? fault : error_about(Errc::out_of_range, name, value, "at most 1");
}

}  // namespace

Fault check_policy(const Policy& policy) {
  if (policy.period == 0) {
    return error_about(Errc::out_of_range, "period", std::uint64_t{0}, "at least 1");
  }
  if (Fault fault = check_finite("tolerance", policy.tolerance)) {
    return fault;
  }
  const ElementRule& its = policy.elements;
  Fault fault = check_not_negative("error_bound", policy.error_bound);
  fault = fault ? fault : check_not_negative("time_budget", policy.time_budget);
  fault = fault ? fault : check_not_negative("contact_distance", its.contact_distance);
  fault = fault ? fault : check_not_negative("rest_distance", its.rest_distance);
  fault = fault ? fault : check_share("cone_angle", its.cone_angle);
  return fault ? fault : check_share("cone_factor", its.cone_factor);
}

bool PolicyTable::is_whole() const {
  constexpr std::size_t most = std::size_t{tag_count} * tag_count;
  const auto is_policy = [](const Policy& its) {
    constexpr std::uint32_t last_method = 4, all_kinds = 15;
    return its.algorithm <= Algorithm::libccd_mpr && its.detail <= Detail::elements &&
           its.elements.method <= last_method && its.elements.kinds <= all_kinds && !check_policy(its);
  };
  const bool has_numbers = numbers_.empty() || numbers_.size() == std::size_t{tag_count} * tag_count;
  return has_numbers && !policies_.empty() && policies_.size() <= most && std::ranges::all_of(policies_, is_policy) &&
         std::ranges::all_of(numbers_, [&](std::uint32_t number) { return number < policies_.size(); }) &&
         largest_tolerance_ >= 0 && largest_tolerance_ <= largest_coordinate;
}

}  // namespace abut
