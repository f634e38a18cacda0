// SPDX-License-Identifier: Apache-2.0
// How the pairs of two tags are treated.
export module abut.scene.meetings.policies;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.scene.state.options;

export namespace abut {

// One number for each pair of tags, into a list of policies that are in use; number 0 is the default. A universe
// that sets none has no table.
class PolicyTable {
 public:
  void set(std::uint32_t tag_a, std::uint32_t tag_b, const Policy& policy);
  [[nodiscard]] inline std::uint32_t number_of(std::uint32_t tag_a, std::uint32_t tag_b) const {
    return numbers_.empty() ? 0 : numbers_[tag_a * tag_count + tag_b];
  }
  [[nodiscard]] inline const Policy& at(std::uint32_t number) const [[clang::lifetimebound]] {
    return policies_[number];
  }
  [[nodiscard]] inline const Policy& of(std::uint32_t tag_a, std::uint32_t tag_b) const [[clang::lifetimebound]] {
    return policies_[number_of(tag_a, tag_b)];
  }
  [[nodiscard]] inline std::size_t size() const { return policies_.size(); }
  // A bit for each tag that has Detail::elements with another one or with itself.
  [[nodiscard]] inline std::uint64_t tags_of_elements() const { return tags_of_elements_; }
  // Zero where all policies leave tolerances to the geometries.
  [[nodiscard]] inline Real largest_tolerance() const { return largest_tolerance_; }
  [[nodiscard]] inline std::size_t bytes() const {
    return numbers_.capacity() * sizeof(std::uint32_t) + policies_.capacity() * sizeof(Policy);
  }

  template <class Archive, class Self>
  static void transfer(Archive& archive, Self& self) {
    archive(self.numbers_, self.policies_, self.largest_tolerance_);
    if constexpr (Archive::is_reading) {
      archive.require(self.is_whole(), "a policy is none");
      self.tags_of_elements_ = archive.has_failed() ? 0 : self.find_tags_of_elements();
    }
  }

 private:
  // Whether what was read is what `set` may have made.
  [[nodiscard]] bool is_whole() const;
  [[nodiscard]] std::uint64_t find_tags_of_elements() const;

  std::vector<std::uint32_t> numbers_;  // empty while all pairs of tags have the default
  std::vector<Policy> policies_{Policy{}};
  Real largest_tolerance_ = 0;
  std::uint64_t tags_of_elements_ = 0;
};

// The first number of a policy that is not one that it may have.
[[nodiscard]] Fault check_policy(const Policy& policy);

}  // namespace abut
