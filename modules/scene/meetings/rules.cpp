// SPDX-License-Identifier: Apache-2.0
module abut.scene.meetings.rules;
import abut.core.standard;
import abut.scene.state.options;

namespace abut {
namespace {

Collidable of_kind(const RuleSide& side, std::size_t kind) {
  switch (static_cast<CollidableKind>(kind)) {
    case CollidableKind::geometry: return {CollidableKind::geometry, side.geometry.slot, side.geometry.generation};
    case CollidableKind::part: return {CollidableKind::part, side.part.slot, side.part.generation};
    case CollidableKind::label: return {CollidableKind::label, side.label, 0};
    case CollidableKind::any: break;
  }
  return {};
}

}  // namespace

Rules::Key Rules::key_of(const Collidable& a, const Collidable& b) {
  const auto packed = [](const Collidable& c) {
    return std::array{static_cast<std::uint32_t>(c.kind), c.slot, c.generation};
  };
  const auto first = packed(a), second = packed(b);
  return first <= second ? Key{first, second} : Key{second, first};
}

void Rules::set(const Collidable& a, const Collidable& b, Rule rule) {
  const Key key = key_of(a, b);
  std::size_t& count = counts_[key.first[0]][key.second[0]];
  if (rule == Rule::none) {
    count -= rules_.erase(key);
  } else {
    count += rules_.insert_or_assign(key, rule).second ? 1 : 0;
  }
}

bool Rules::restore() {
  counts_ = {};
  return std::ranges::all_of(rules_, [&](const auto& entry) {
    const auto& [key, rule] = entry;
    const bool is_one =
        key.first <= key.second && key.second[0] < kind_count && (rule == Rule::enable || rule == Rule::disable);
    counts_[is_one ? key.first[0] : 0][is_one ? key.second[0] : 0] += 1;
    return is_one;
  });
}

void Rules::forget(const Collidable& gone) {
  const auto name = key_of(gone, gone).first;
  std::erase_if(rules_, [&](const auto& entry) {
    const bool is_about_it = entry.first.first == name || entry.first.second == name;
    counts_[entry.first.first[0]][entry.first.second[0]] -= is_about_it ? 1 : 0;
    return is_about_it;
  });
}

bool Rules::disable_all() const {
  return find({}, {}) == Rule::disable &&
         std::ranges::none_of(rules_, [](const auto& entry) { return entry.second == Rule::enable; });
}

std::optional<Rule> Rules::find(const Collidable& a, const Collidable& b) const {
  const auto found = rules_.find(key_of(a, b));
  return found == rules_.end() ? std::nullopt : std::optional(found->second);
}

RuleVerdict Rules::verdict(const RuleSide& a, const RuleSide& b) const {
  for (std::size_t low = 0; low < kind_count; ++low) {
    for (std::size_t high = low; high < kind_count; ++high) {
      if (counts_[low][high] == 0) {
        continue;
      }
      const RuleVerdict one{find(of_kind(a, low), of_kind(b, high)).value_or(Rule::none), of_kind(a, low),
                            of_kind(b, high)};
      const RuleVerdict other{find(of_kind(a, high), of_kind(b, low)).value_or(Rule::none), of_kind(a, high),
                              of_kind(b, low)};
      if (one.rule != Rule::none || other.rule != Rule::none) {
        return one.rule == Rule::disable || other.rule == Rule::none ? one : other;
      }
    }
  }
  return {};
}

}  // namespace abut
