// SPDX-License-Identifier: Apache-2.0
#include "touch.hpp"

#include <abut/abut.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "box_search.hpp"

namespace touch_fuzzing {
namespace {

struct Input {
  Features features;
  bool is_whole;  // all coordinates are small whole numbers
  Query query;
};

double coordinate_of(std::uint64_t bits) {
  constexpr double most = 0x1p20, least = 0x1p-200;
  const double value = std::bit_cast<double>(bits);
  // Products of four factors stay normal numbers or zero, so that doubling and halving is exact.
  return std::isfinite(value) && std::fabs(value) >= least ? std::clamp(value, -most, most) : 0;
}

Input input_of(std::span<const std::uint8_t> bytes) {
  std::size_t next = 0;
  const auto take = [&] { return next < bytes.size() ? bytes[next++] : std::uint8_t{0}; };
  const std::uint8_t flags = take();
  Input input{(flags & 1U) != 0 ? Features::edges : Features::vertex_and_face, (flags & 2U) != 0, {}};
  const auto coordinate = [&] {
    if (input.is_whole) {
      return static_cast<double>(take() % 9) - 4;
    }
    std::uint64_t bits = 0;
    for (unsigned byte = 0; byte < 8; ++byte) {
      bits |= std::uint64_t{take()} << (8 * byte);
    }
    return coordinate_of(bits);
  };
  std::ranges::generate(input.query.start, coordinate);
  std::ranges::generate(input.query.end, coordinate);
  return input;
}

struct Answer {
  abut_first_touch touch;
  bool is_ok;
};
Answer ask(Features features, const Query& query, double separation = 0) {
  constexpr double tolerance = 1e-9;
  Answer out{};
  const auto call = features == Features::edges ? abut_edges_touch_edges : abut_vertices_touch_faces;
  out.is_ok = call(query.start.data(), query.end.data(), 1, separation, tolerance, &out.touch) == ABUT_OK;
  return out;
}

Query reordered(const Query& query, const std::array<std::size_t, 4>& order) {
  Query out{};
  for (std::size_t i = 0; i < out.start.size(); ++i) {
    const std::size_t from = 3 * order.at(i / 3) + i % 3;
    out.start.at(i) = query.start.at(from);
    out.end.at(i) = query.end.at(from);
  }
  return out;
}
Query turned(const Query& query) {
  Query out{};
  for (std::size_t i = 0; i < out.start.size(); ++i) {
    const std::size_t from = 3 * (i / 3) + (i + 1) % 3;
    out.start.at(i) = -query.start.at(from);
    out.end.at(i) = -query.end.at(from);
  }
  return out;
}
Query scaled(const Query& query, double by) {
  Query out = query;
  std::ranges::for_each(out.start, [&](double& value) { value *= by; });
  std::ranges::for_each(out.end, [&](double& value) { value *= by; });
  return out;
}

// The same touch at the same time.
bool agree(const abut_first_touch& a, const abut_first_touch& b) {
  return a.touches == b.touches && (a.touches == 0 || (a.lower <= b.upper && b.lower <= a.upper));
}

std::string finding_of_whole(const Input& input, const abut_first_touch& found) {
  constexpr std::uint64_t most_boxes = 200'000;
  const BoxSearch search(input.features, input.query);
  const auto expected = search.touches(0, BoxSearch::one, most_boxes);
  if (expected && *expected != (found.touches != 0)) {
    return *expected ? "the search of boxes finds a touch" : "the search of boxes finds no touch";
  }
  if (found.touches == 0) {
    return {};
  }
  // A smallest box may have its touch beside it: far beside where features graze each other.
  constexpr std::int64_t margin = BoxSearch::one / 256;
  const auto low = static_cast<std::int64_t>(found.lower * static_cast<double>(BoxSearch::one));
  const auto high = static_cast<std::int64_t>(found.upper * static_cast<double>(BoxSearch::one)) + 1;
  if (search.touches(0, low - margin, most_boxes).value_or(false)) {
    return "the search of boxes finds an earlier touch";
  }
  const std::int64_t begin = std::max<std::int64_t>(low - 1, 0), end = std::min(high, BoxSearch::one);
  return search.touches(begin, end, most_boxes).value_or(true) ? std::string{} : "nothing touches at that time";
}

}  // namespace

std::string finding_of(std::span<const std::uint8_t> bytes) {
  const Input input = input_of(bytes);
  const auto [found, is_ok] = ask(input.features, input.query);
  if (!is_ok) {
    return std::string("refused: ") + abut_last_error_message();
  }
  if (found.touches != 0 && !(0 <= found.lower && found.lower <= found.upper && found.upper <= 1)) {
    return "the interval is none of the motion";
  }
  // Whole times of exact arithmetic, rounded outward.
  if (found.touches != 0 && found.upper - found.lower > 1e-9) {
    return "the interval is wider than 1e-9";
  }
  const auto differs = [&](const Query& other) { return !agree(found, ask(input.features, other).touch); };
  const bool are_edges = input.features == Features::edges;
  if (differs(reordered(input.query,
                        are_edges ? std::array<std::size_t, 4>{1, 0, 2, 3} : std::array<std::size_t, 4>{0, 2, 3, 1})) ||
      differs(reordered(input.query,
                        are_edges ? std::array<std::size_t, 4>{2, 3, 0, 1} : std::array<std::size_t, 4>{0, 1, 3, 2}))) {
    return "another order of the vertices has another answer";
  }
  if (differs(turned(input.query))) {
    return "other axes have another answer";
  }
  if (differs(scaled(input.query, 4)) || differs(scaled(input.query, 0.5))) {
    return "another unit of length has another answer";
  }
  const abut_first_touch backward = ask(input.features, {input.query.end, input.query.start}).touch;
  if (backward.touches != found.touches) {
    return "backward in time there is another answer";
  }
  if (found.touches != 0 && 1 - backward.lower + 0x1p-52 < found.lower) {
    return "backward in time the last touch comes before the first one";
  }
  // What comes as near as a separation does so no later than it touches.
  const abut_first_touch near = ask(input.features, input.query, 0.125).touch;
  if (found.touches != 0 && (near.touches == 0 || near.lower > found.upper)) {
    return "a touch is no approach";
  }
  return input.is_whole ? finding_of_whole(input, found) : std::string{};
}

}  // namespace touch_fuzzing
