// SPDX-License-Identifier: Apache-2.0
// Candidates without a tree.
#include "deforming_boxes.hpp"

namespace bench {
namespace {

class Plain : public DeformingWay {
 public:
  explicit Plain(bool has_order) : has_order_(has_order) {}

  void answer(const DeformingCase& step, Found& found) override {
    found.pairs.clear();
    const AllElements a(step.a, true), b(step.is_of_one() ? step.a : step.b, true);
    for_each_sides(step, a, b, [&](const Sides& sides) {
      const auto add = [&](std::uint32_t i, std::uint32_t j) { found.pairs.push_back({sides.kind, i, j}); };
      if (has_order_) {
        sweep(sides, step.reach, add);
      } else {
        all(sides, step.reach, add);
      }
    });
  }

 private:
  template <class Use>
  static void all(const Sides& sides, double reach, const Use& use) {
    const auto count_a = static_cast<std::uint32_t>(sides.a.boxes.size());
    const auto count_b = static_cast<std::uint32_t>(sides.b.boxes.size());
    for (std::uint32_t i = 0; i < count_a; ++i) {
      for (std::uint32_t j = sides.is_one_list ? i + 1 : 0; j < count_b; ++j) {
        if (are_near(sides.a.boxes[i], sides.b.boxes[j], reach) && sides.counts(i, j)) {
          use(i, j);
        }
      }
    }
  }

  bool has_order_;
};

}  // namespace

std::vector<NamedWay> plain_ways(Asked asked) {
  std::vector<NamedWay> ways;
  if (asked == Asked::candidates) {
    ways.push_back({"all pairs", std::make_unique<Plain>(false)});
    ways.push_back({"sweep", std::make_unique<Plain>(true)});
  }
  return ways;
}

}  // namespace bench
