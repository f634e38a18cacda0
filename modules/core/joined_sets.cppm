// SPDX-License-Identifier: Apache-2.0
// Sets of numbers that are joined two by two. The least number of a set stands for it.
export module abut.core.joined_sets;
import abut.core.standard;

export namespace abut {

class JoinedSets {
 public:
  explicit JoinedSets(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0u); }

  [[nodiscard]] std::uint32_t of(std::uint32_t number) {
    while (parents_[number] != number) {
      parents_[number] = parents_[parents_[number]];
      number = parents_[number];
    }
    return number;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t of_a = of(a), of_b = of(b);
    parents_[std::max(of_a, of_b)] = std::min(of_a, of_b);
  }

 private:
  std::vector<std::uint32_t> parents_;
};

}  // namespace abut
