// SPDX-License-Identifier: Apache-2.0
// Whether two features touch whose vertices move on straight lines, by a search of boxes of time and place in whole
// numbers. It shares no code with the library.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace touch_fuzzing {

// Four vertices, three numbers each.
using Vertices = std::array<double, 12>;
struct Query {
  Vertices start, end;
};
enum class Features { vertex_and_face, edges };

// The difference of the points (u, v) of both features at a time t is linear in each of t, u and v. So over a box of
// these it lies in the box around its values at the corners. Boxes that miss the origin are left out, others are
// halved. Coordinates are small whole numbers, and t, u and v are multiples of 2^-26: whole numbers of 64 bits hold
// every value exactly. Then no touch is nearly missed, and a smallest box that still meets the origin has a touch in or
// beside it.
class BoxSearch {
 public:
  static constexpr int digits = 26;
  static constexpr std::int64_t one = std::int64_t{1} << digits;

  BoxSearch(Features features, const Query& query) : features_(features), query_(query) {}

  // Whether they touch at times from `low` to `high`, in multiples of 2^-26. Nothing after `most_boxes`.
  [[nodiscard]] std::optional<bool> touches(std::int64_t low, std::int64_t high, std::uint64_t most_boxes) const {
    if (low >= high) {
      return false;
    }
    std::uint64_t left = most_boxes;
    const bool is_found = search({{{low, high}, {0, one}, {0, one}}}, left);
    return left == 0 ? std::nullopt : std::optional(is_found);
  }

 private:
  struct Range {
    std::int64_t low, high;
  };
  using Box = std::array<Range, 3>;

  [[nodiscard]] std::int64_t difference(int axis, std::int64_t t, std::int64_t u, std::int64_t v) const {
    const auto at = [&](int vertex) {
      const std::size_t place = static_cast<std::size_t>(3 * vertex + axis);
      return (one - t) * static_cast<std::int64_t>(query_.start.at(place)) +
             t * static_cast<std::int64_t>(query_.end.at(place));
    };
    if (features_ == Features::edges) {
      return (one - u) * at(0) + u * at(1) - (one - v) * at(2) - v * at(3);
    }
    return one * at(0) - (one - u - v) * at(1) - u * at(2) - v * at(3);
  }
  [[nodiscard]] bool may_touch(const Box& box) const {
    // Of the square of (u, v) a face is the half with u + v <= 1.
    if (features_ == Features::vertex_and_face && box[1].low + box[2].low > one) {
      return false;
    }
    for (int axis = 0; axis < 3; ++axis) {
      std::int64_t least = std::numeric_limits<std::int64_t>::max(), most = std::numeric_limits<std::int64_t>::min();
      for (const std::int64_t t : {box[0].low, box[0].high}) {
        for (const std::int64_t u : {box[1].low, box[1].high}) {
          for (const std::int64_t v : {box[2].low, box[2].high}) {
            const std::int64_t value = difference(axis, t, u, v);
            least = std::min(least, value);
            most = std::max(most, value);
          }
        }
      }
      if (least > 0 || most < 0) {
        return false;
      }
    }
    return true;
  }
  // Depth first. The longest side is halved.
  [[nodiscard]] bool search(const Box& box, std::uint64_t& left) const {
    if (left == 0 || !may_touch(box)) {
      return false;
    }
    --left;
    const auto* longest = std::max_element(
        box.begin(), box.end(), [](const Range& a, const Range& b) { return a.high - a.low < b.high - b.low; });
    if (longest->high - longest->low <= 1) {
      return true;
    }
    const auto side = static_cast<std::size_t>(longest - box.begin());
    const std::int64_t middle = (longest->low + longest->high) / 2;
    Box first = box, second = box;
    first.at(side).high = middle;
    second.at(side).low = middle;
    return search(first, left) || search(second, left);
  }

  Features features_;
  const Query& query_;
};

}  // namespace touch_fuzzing
