// SPDX-License-Identifier: Apache-2.0
// A response in words and as JSON: both from one list of facts.
module;

#include <abut/response.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

module abut.response;

namespace abut::response {

namespace {

using Fact = std::pair<std::string, std::string>;  // a name, and a number or a text in quotes
using Facts = std::vector<Fact>;

[[nodiscard]] std::string quoted(std::string_view text) {
  constexpr unsigned char first_printed = 0x20;
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    // A control character of a name has no place in either.
    out += static_cast<unsigned char>(c) < first_printed ? ' ' : c;
  }
  return out + '"';
}

[[nodiscard]] Facts facts_of(const abut_response_island& its, std::size_t number) {
  constexpr std::array integrators{"static", "euler", "rk4", "midpoint", "implicit"};
  const abut_residuals& residuals = its.residuals;
  return {{"island", std::to_string(number)},
          {"bodies", std::to_string(its.body_count)},
          {"contacts", std::to_string(its.contact_count)},
          {"integrator", quoted(integrators.at(its.integrator))},
          {"rounds", std::to_string(residuals.rounds)},
          {"newton_steps", std::to_string(residuals.newton_steps)},
          {"contact_residual", text_of(residuals.contact)},
          {"motion_residual", text_of(residuals.motion)},
          {"speed", text_of(residuals.speed)},
          {"converged", residuals.is_converged != 0 ? "true" : "false"}};
}

[[nodiscard]] std::string words_of(const Facts& facts) {
  std::string out;
  for (const auto& [name, value] : facts) {
    std::string plain = value;
    std::erase(plain, '"');
    out += (out.empty() ? "" : ", ") + name + " " + plain;
  }
  return out + "\n";
}
[[nodiscard]] std::string json_of(const Facts& facts) {
  std::string out;
  for (const auto& [name, value] : facts) out += (out.empty() ? "" : ",") + quoted(name) + ":" + value;
  return "{" + out + "}";
}

}  // namespace

namespace {

struct Chapter {
  std::string name;
  std::vector<Facts> rows;
};

[[nodiscard]] std::string side_of(const abut_response_side& side) {
  constexpr std::array kinds{"any", "geometry", "part", "label", "tag", "material"};
  const std::string kind = kinds.at(side.kind);
  return side.kind == ABUT_RESPONSE_SIDE_ANY ? kind : kind + " " + std::to_string(side.slot);
}

[[nodiscard]] std::vector<Chapter> chapters_of(const abut_response_options& options, std::size_t bodies,
                                               std::size_t grains, const Rules& rules, const std::vector<Link>& links,
                                               const std::vector<abut_response_island>& islands) {
  std::vector<Chapter> out;
  out.push_back({"step",
                 {{{"solver", quoted(options.solver == ABUT_SOLVER_SWEEPS ? "sweeps" : "newton")},
                   {"tolerance", text_of(options.tolerance)},
                   {"most_rounds", std::to_string(options.most_rounds)},
                   {"slop", text_of(options.slop)},
                   {"impacts", (options.flags & ABUT_RESPONSE_IMPACTS) != 0 ? "true" : "false"},
                   {"threads", std::to_string(options.threads)},
                   {"bodies", std::to_string(bodies)},
                   {"particles", std::to_string(grains)}}}});
  Chapter& ruled = out.emplace_back(Chapter{"rules", {}});
  for (std::size_t i = 0; i < rules.rules().size(); ++i) {
    const Rules::Rule& rule = rules.rules()[i];
    ruled.rows.push_back({{"rule", std::to_string(i)},
                          {"a", quoted(side_of(rule.a))},
                          {"b", quoted(side_of(rule.b))},
                          {"kind", quoted(rules.kinds()[rule.kind].name)},
                          {"parameters", quoted(rule.parameters.text())}});
  }
  Chapter& linked = out.emplace_back(Chapter{"links", {}});
  for (const Link& link : links) {
    linked.rows.push_back({{"link", std::to_string(link.number)},
                           {"a", std::to_string(link.a.part.slot)},
                           {"b", std::to_string(link.b.part.slot)},
                           {"bond", link.is_bond() ? "true" : "false"},
                           {"force", text_of(length(link.force))}});
  }
  Chapter& solved = out.emplace_back(Chapter{"islands", {}});
  for (std::size_t i = 0; i < islands.size(); ++i) solved.rows.push_back(facts_of(islands[i], i));
  return out;
}

[[nodiscard]] std::size_t count_of(const std::vector<Grains>& all) {
  std::size_t count = 0;
  for (const Grains& grains : all) count += grains.masses.size();
  return count;
}

}  // namespace

std::string Simulation::explain() const {
  std::string out;
  for (const Chapter& chapter : chapters_of(options_, bodies_.size(), count_of(grains_), rules_, links_, islands_)) {
    for (const Facts& row : chapter.rows) out += words_of(row);
  }
  return out;
}

std::string Simulation::explain_json() const {
  std::string out = "{";
  for (const Chapter& chapter : chapters_of(options_, bodies_.size(), count_of(grains_), rules_, links_, islands_)) {
    out += (out.size() > 1 ? "," : "") + quoted(chapter.name) + ":[";
    for (std::size_t i = 0; i < chapter.rows.size(); ++i) out += (i > 0 ? "," : "") + json_of(chapter.rows[i]);
    out += "]";
  }
  return out + "}";
}

}  // namespace abut::response
