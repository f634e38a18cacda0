// SPDX-License-Identifier: Apache-2.0
// Vertices on straight lines under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

using Ask = abut_status (*)(const double*, const double*, std::size_t, double, double, abut_first_touch*);

struct Room {
  std::array<double, 24> start{}, end{};
  OutArray<abut_first_touch> out{2};
};

void refuse_null(Ask ask) {
  Room room;
  EXPECT_TRUE(refused(ask(nullptr, room.end.data(), 2, 0, 0, room.out.data()), ABUT_NULL_ARGUMENT, {"start", "null"}));
  EXPECT_TRUE(refused(ask(room.start.data(), nullptr, 2, 0, 0, room.out.data()), ABUT_NULL_ARGUMENT, {"end", "null"}));
  EXPECT_TRUE(refused(ask(room.start.data(), room.end.data(), 2, 0, 0, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(succeeded(ask(nullptr, nullptr, 0, 0, 0, nullptr)));
  EXPECT_TRUE(room.out.is_untouched());
}

void refuse_non_finite(Ask ask) {
  for (const BadNumber& bad : non_finite_numbers) {
    Room room;
    room.start[23] = bad.value;
    const auto call = [&](double separation, double tolerance) {
      return ask(room.start.data(), room.end.data(), 2, separation, tolerance, room.out.data());
    };
    EXPECT_TRUE(refused(call(0, 0), ABUT_NOT_FINITE, {"start[23]", bad.word}));
    room.start[23] = 0;
    room.end[7] = bad.value;
    EXPECT_TRUE(refused(call(0, 0), ABUT_NOT_FINITE, {"end[7]", bad.word}));
    room.end[7] = 0;
    EXPECT_TRUE(refused(call(bad.value, 1), ABUT_NOT_FINITE, {"separation", bad.word}));
    EXPECT_TRUE(refused(call(1, bad.value), ABUT_NOT_FINITE, {"tolerance", bad.word}));
    EXPECT_TRUE(refused(call(-1, 1), ABUT_OUT_OF_RANGE, {"separation", "-1"}));
    EXPECT_TRUE(refused(call(1, 0), ABUT_OUT_OF_RANGE, {"tolerance", "0"}));
    EXPECT_TRUE(room.out.is_untouched());
  }
}

void refuse_overflow(Ask ask) {
  Room room;
  expect_overflow_refused(12 * sizeof(double), "count", [&](std::size_t count) {
    return ask(room.start.data(), room.end.data(), count, 0, 0, room.out.data());
  });
  EXPECT_TRUE(room.out.is_untouched());
}

TEST(VerticesTouchFaces, RefusesNull) { refuse_null(abut_vertices_touch_faces); }
TEST(VerticesTouchFaces, RefusesNonFinite) { refuse_non_finite(abut_vertices_touch_faces); }
TEST(VerticesTouchFaces, RefusesOverflow) { refuse_overflow(abut_vertices_touch_faces); }
TEST(EdgesTouchEdges, RefusesNull) { refuse_null(abut_edges_touch_edges); }
TEST(EdgesTouchEdges, RefusesNonFinite) { refuse_non_finite(abut_edges_touch_edges); }
TEST(EdgesTouchEdges, RefusesOverflow) { refuse_overflow(abut_edges_touch_edges); }

}  // namespace
