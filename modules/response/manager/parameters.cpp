// SPDX-License-Identifier: Apache-2.0
// Parameters of rules as text.
module;

#include <abut/response.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

module abut.response;

namespace abut::response {

namespace {

struct [[gsl::Pointer]] Name {
  std::string_view name;
  double least, most;
  void (*set)(Terms&, double);
};

constexpr double largest = 1e30, least_stiffness = 1e-30, largest_coefficient = 1e6, least_epsilon = 1e-8;

constexpr std::array names{
    Name{"mu", 0, largest_coefficient,
         [](Terms& its, double x) { its.material.friction_primary = its.material.friction_secondary = x; }},
    Name{"mu1", 0, largest_coefficient, [](Terms& its, double x) { its.material.friction_primary = x; }},
    Name{"mu2", 0, largest_coefficient, [](Terms& its, double x) { its.material.friction_secondary = x; }},
    Name{"static", 0, largest_coefficient, [](Terms& its, double x) { its.material.static_scale = x; }},
    Name{"k", least_stiffness, largest, [](Terms& its, double x) { its.material.compliance = 1 / x; }},
    Name{"compliance", 0, largest, [](Terms& its, double x) { its.material.compliance = x; }},
    Name{"d", 0, largest, [](Terms& its, double x) { its.material.damping = x; }},
    Name{"e", 0, largest_coefficient, [](Terms& its, double x) { its.material.restitution = x; }},
    Name{"threshold", 0, largest, [](Terms& its, double x) { its.material.restitution_threshold = x; }},
    Name{"adhesion", 0, largest, [](Terms& its, double x) { its.material.adhesive_force = x; }},
    Name{"break", 0, largest, [](Terms& its, double x) { its.break_force = x; }},
    Name{"epsilon", least_epsilon, 1, [](Terms& its, double x) { its.epsilon = x; }},
};

}  // namespace

std::string text_of(double value) {
  std::array<char, 32> digits{};
  const auto written = std::to_chars(std::to_address(digits.begin()), std::to_address(digits.end()), value);
  return {digits.data(), written.ptr};
}

std::optional<Refusal> Parameters::read(std::string_view text) {
  std::vector<std::pair<std::size_t, double>> given;
  while (!text.empty()) {
    const std::string_view one = text.substr(0, text.find('&'));
    text.remove_prefix(std::min(one.size() + 1, text.size()));
    const std::size_t middle = one.find('=');
    const std::string_view name = one.substr(0, middle);
    const auto known = std::ranges::find(names, name, &Name::name);
    const auto refuse = [&](abut_status status, const std::string& why) {
      return Refusal{status, "parameters has \"" + std::string(one) + "\"; " + why};
    };
    if (known == names.end()) return refuse(ABUT_INVALID_ARGUMENT, "there is no such parameter");
    if (middle == std::string_view::npos) return refuse(ABUT_INVALID_ARGUMENT, "a parameter has a value behind =");
    const std::string_view digits = one.substr(middle + 1);
    double value = 0;
    const auto [end, error] = std::from_chars(std::to_address(digits.begin()), std::to_address(digits.end()), value);
    if (error != std::errc{} || end != std::to_address(digits.end()))
      return refuse(ABUT_INVALID_ARGUMENT, "that is no number");
    if (!std::isfinite(value)) return refuse(ABUT_NOT_FINITE, "it must be finite");
    if (!(value >= known->least && value <= known->most)) {
      return refuse(ABUT_OUT_OF_RANGE, "it must lie between " + text_of(known->least) + " and " + text_of(known->most));
    }
    given.emplace_back(static_cast<std::size_t>(known - names.begin()), value);
  }
  given_ = std::move(given);
  return std::nullopt;
}

void Parameters::apply(Terms& terms) const {
  for (const auto& [place, value] : given_) names.at(place).set(terms, value);
}

bool Parameters::has(std::string_view name) const {
  return std::ranges::any_of(given_, [&](const auto& its) { return names.at(its.first).name == name; });
}

std::string Parameters::text() const {
  std::string out;
  for (const auto& [place, value] : given_) {
    if (!out.empty()) out += '&';
    out += std::string(names.at(place).name) + "=" + text_of(value);
  }
  return out;
}

}  // namespace abut::response
