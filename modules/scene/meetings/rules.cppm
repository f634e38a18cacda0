// SPDX-License-Identifier: Apache-2.0
// Which pairs are examined, by rules of the caller.
export module abut.scene.meetings.rules;
import abut.core.standard;
import abut.scene.state.options;

export namespace abut {

// What rules can speak of on one side of a pair.
struct RuleSide {
  GeometryId geometry;
  PartId part;
  std::uint32_t label;
};

// A rule says of two collidables whether they meet. Of those that fit a pair the most specific one counts: first by
// its more specific side, then by the other one; a geometry is more specific than a part, that more than a label, and
// that more than anything. Of two that are equally specific the one that disables wins. Without any, pairs meet.
class Rules {
 public:
  // Rule::none takes a rule away. O(log rules).
  void set(const Collidable& a, const Collidable& b, Rule rule);
  inline void clear() {
    rules_.clear();
    counts_ = {};
  }
  // Takes away what speaks of a geometry or a part that is destroyed.
  void forget(const Collidable& gone);

  [[nodiscard]] inline bool is_empty() const { return rules_.empty(); }
  [[nodiscard]] inline std::size_t size() const { return rules_.size(); }
  [[nodiscard]] inline std::size_t bytes() const { return rules_.size() * (sizeof(Key) + sizeof(Rule) + node_bytes); }
  // Whether nothing meets anything: any with any is disabled, and nothing more specific is enabled. O(rules).
  [[nodiscard]] bool disable_all() const;
  // The rule that counts. O(log rules) for each combination of kinds that has any rule.
  [[nodiscard]] RuleVerdict verdict(const RuleSide& a, const RuleSide& b) const;
  [[nodiscard]] inline bool allows(const RuleSide& a, const RuleSide& b) const {
    return is_empty() || verdict(a, b).rule != Rule::disable;
  }

  template <class Archive, class Self>
  static void transfer(Archive& archive, Self& self) {
    archive(self.rules_);
    if constexpr (Archive::is_reading) {
      archive.require(self.restore(), "a rule is none");
    }
  }

 private:
  // What follows from the rules that were read, and whether each of them is one.
  [[nodiscard]] bool restore();
  struct Key {
    std::array<std::uint32_t, 3> first, second;  // kind, slot, generation; first is not greater

    friend constexpr auto operator<=>(const Key&, const Key&) = default;
  };
  // What a node of a std::map holds besides the value.
  static constexpr std::size_t node_bytes = 4 * sizeof(std::size_t);
  static constexpr std::size_t kind_count = 4;

  [[nodiscard]] static Key key_of(const Collidable& a, const Collidable& b);
  [[nodiscard]] std::optional<Rule> find(const Collidable& a, const Collidable& b) const;

  std::map<Key, Rule> rules_;
  std::array<std::array<std::size_t, kind_count>, kind_count> counts_{};  // rules by the two kinds, the lower one first
};

}  // namespace abut
