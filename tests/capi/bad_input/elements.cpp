// SPDX-License-Identifier: Apache-2.0
// Elements of meshes that deform under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

struct Room {
  Shape square = make_square_mesh(1);
  abut_elements* elements = nullptr;
  std::array<double, 12> start{}, end{};

  Room() { require(abut_elements_create(square, &elements)); }
  Room(const Room&) = delete;
  Room& operator=(const Room&) = delete;
  ~Room() { abut_elements_destroy(elements); }
};
abut_elements_options options_with(double reach) {
  auto options = filled_by(abut_elements_options_init);
  options.reach = reach;
  return options;
}

TEST(ElementsCreate, RefusesNull) {
  const Shape square = make_square_mesh(1);
  Out<abut_elements*> out;
  EXPECT_TRUE(refused(abut_elements_create(nullptr, out.address()), ABUT_NULL_ARGUMENT, {"shape", "null"}));
  EXPECT_TRUE(refused(abut_elements_create(square, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
}
TEST(ElementsCreate, RefusesShapesWithoutTriangles) {
  Out<abut_elements*> out;
  EXPECT_TRUE(refused(abut_elements_create(make_sphere(1), out.address()), ABUT_UNSUPPORTED, {"shape", "sphere"}));
  EXPECT_TRUE(out.is_untouched());
}
TEST(ElementsCreate, RefusesCoordinatesBeyond) {
  const Shape far = make_of_kind("mesh", {0}, {0, 0, 0, 1e60, 0, 0, 0, 1, 0}, {0, 1, 2});
  Out<abut_elements*> out;
  EXPECT_TRUE(refused(abut_elements_create(far, out.address()), ABUT_OUT_OF_RANGE, {"vertex 1", "1e+60"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(ElementsDestroy, TakesNull) { abut_elements_destroy(nullptr); }

TEST(ElementsCount, RefusesNull) {
  const Room room;
  Out<abut_element_counts> out;
  EXPECT_TRUE(refused(abut_elements_count(nullptr, out.address()), ABUT_NULL_ARGUMENT, {"elements", "null"}));
  EXPECT_TRUE(refused(abut_elements_count(room.elements, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(ElementsEdges, RefusesNull) {
  const Room room;
  OutArray<std::uint32_t> out(4);
  Out<std::size_t> count;
  EXPECT_TRUE(refused(abut_elements_edges(nullptr, out.data(), 2, count.address()), ABUT_NULL_ARGUMENT, {"elements"}));
  EXPECT_TRUE(
      refused(abut_elements_edges(room.elements, nullptr, 2, count.address()), ABUT_NULL_ARGUMENT, {"vertices"}));
  EXPECT_TRUE(refused(abut_elements_edges(room.elements, out.data(), 2, nullptr), ABUT_NULL_ARGUMENT, {"count"}));
  EXPECT_TRUE(out.is_untouched() && count.is_untouched());
}
TEST(ElementsEdges, RefusesOverflow) {
  const Room room;
  OutArray<std::uint32_t> out(4);
  Out<std::size_t> count;
  expect_overflow_refused(2 * sizeof(std::uint32_t), "capacity", [&](std::size_t capacity) {
    return abut_elements_edges(room.elements, out.data(), capacity, count.address());
  });
  EXPECT_TRUE(out.is_untouched() && count.is_untouched());
}

TEST(ElementsSetVertices, RefusesNull) {
  const Room room;
  EXPECT_TRUE(
      refused(abut_elements_set_vertices(nullptr, room.start.data(), nullptr, 4), ABUT_NULL_ARGUMENT, {"elements"}));
  EXPECT_TRUE(refused(abut_elements_set_vertices(room.elements, nullptr, nullptr, 4), ABUT_NULL_ARGUMENT, {"start"}));
}
TEST(ElementsSetVertices, RefusesNonFinite) {
  for (const BadNumber& bad : non_finite_numbers) {
    Room room;
    room.start[7] = bad.value;
    EXPECT_TRUE(refused(abut_elements_set_vertices(room.elements, room.start.data(), room.end.data(), 4),
                        ABUT_NOT_FINITE, {"start[7]", bad.word}));
    room.start[7] = 0;
    room.end[11] = bad.value;
    EXPECT_TRUE(refused(abut_elements_set_vertices(room.elements, room.start.data(), room.end.data(), 4),
                        ABUT_NOT_FINITE, {"end[11]", bad.word}));
    // Nothing has moved: all vertices would be in one place.
    std::size_t count = 0;
    const abut_elements_options options = options_with(0);
    require(abut_elements_closest(room.elements, nullptr, &options, nullptr, 0, &count));
    EXPECT_EQ(count, 0U);
  }
}
TEST(ElementsSetVertices, RefusesCoordinatesBeyond) {
  Room room;
  room.end[2] = -1e51;
  EXPECT_TRUE(refused(abut_elements_set_vertices(room.elements, room.start.data(), room.end.data(), 4),
                      ABUT_OUT_OF_RANGE, {"end[2]", "-1e+51", "1e50"}));
}
TEST(ElementsSetVertices, RefusesAnotherCount) {
  const Room room;
  EXPECT_TRUE(refused(abut_elements_set_vertices(room.elements, room.start.data(), nullptr, 3), ABUT_INVALID_ARGUMENT,
                      {"vertex_count", "3", "4"}));
}
TEST(ElementsSetVertices, RefusesOverflow) {
  const Room room;
  expect_overflow_refused(3 * sizeof(double), "vertex_count", [&](std::size_t count) {
    return abut_elements_set_vertices(room.elements, room.start.data(), nullptr, count);
  });
}

template <class Value>
using Search = abut_status (*)(abut_elements*, abut_elements*, const abut_elements_options*, Value*, std::size_t,
                               std::size_t*);

template <class Value>
void refuse_null(Search<Value> search, std::string_view name) {
  const Room room;
  OutArray<Value> out(2);
  Out<std::size_t> count;
  EXPECT_TRUE(refused(search(nullptr, room.elements, nullptr, out.data(), 2, count.address()), ABUT_NULL_ARGUMENT,
                      {"a", "null"}));
  EXPECT_TRUE(refused(search(room.elements, nullptr, nullptr, nullptr, 2, count.address()), ABUT_NULL_ARGUMENT,
                      {name, "null"}));
  EXPECT_TRUE(
      refused(search(room.elements, nullptr, nullptr, out.data(), 2, nullptr), ABUT_NULL_ARGUMENT, {"count", "null"}));
  EXPECT_TRUE(out.is_untouched() && count.is_untouched());
}

template <class Value>
void refuse_struct_size(Search<Value> search) {
  const Room room;
  std::size_t count = 0;
  const auto call = [&](const abut_elements_options* options) {
    return search(room.elements, nullptr, options, nullptr, 0, &count);
  };
  expect_struct_size_checked(options_with(0), call);
  expect_zero_tail_accepted(options_with(0), call);
}

template <class Value>
void refuse_options(Search<Value> search) {
  const Room room;
  OutArray<Value> out(2);
  Out<std::size_t> count;
  const auto refuses = [&](auto field, auto value, abut_status status, std::string_view name, std::string_view word) {
    abut_elements_options options = options_with(0);
    options.*field = value;
    EXPECT_TRUE(refused(search(room.elements, nullptr, &options, out.data(), 2, count.address()), status,
                        {"options", name, word}));
  };
  using O = abut_elements_options;
  refuses(&O::method, 5U, ABUT_UNKNOWN_VALUE, "method", "5");
  refuses(&O::kinds, 16U, ABUT_UNKNOWN_VALUE, "kinds", "16");
  refuses(&O::flags, 2U, ABUT_UNKNOWN_VALUE, "flags", "2");
  refuses(&O::threads, 1025U, ABUT_OUT_OF_RANGE, "threads", "1025");
  refuses(&O::reserved, 1U, ABUT_INVALID_ARGUMENT, "reserved", "1");
  refuses(&O::cone_angle, 1.5, ABUT_OUT_OF_RANGE, "cone_angle", "1.5");
  refuses(&O::cone_factor, 1.5, ABUT_OUT_OF_RANGE, "cone_factor", "1.5");
  refuses(&O::tolerance, 0.0, ABUT_OUT_OF_RANGE, "tolerance", "0");
  const auto refuses_numbers = [&](double O::* field, std::string_view name) {
    refuses(field, -1.0, ABUT_OUT_OF_RANGE, name, "-1");
    for (const BadNumber& bad : non_finite_numbers) refuses(field, bad.value, ABUT_NOT_FINITE, name, bad.word);
  };
  refuses_numbers(&O::reach, "reach");
  refuses_numbers(&O::tolerance, "tolerance");
  refuses_numbers(&O::rest_distance, "rest_distance");
  refuses_numbers(&O::cone_angle, "cone_angle");
  refuses_numbers(&O::cone_factor, "cone_factor");
  EXPECT_TRUE(out.is_untouched() && count.is_untouched());
}

template <class Value>
void refuse_kinds(Search<Value> search) {
  const Room room;
  Out<std::size_t> count;
  abut_elements_options options = options_with(0);
  options.kinds = 1U << ABUT_STENCIL_VERTEX_EDGE;
  EXPECT_TRUE(refused(search(room.elements, nullptr, &options, nullptr, 0, count.address()), ABUT_INVALID_ARGUMENT,
                      {"options.kinds", "4"}));
  EXPECT_TRUE(count.is_untouched());
}

template <class Value>
void refuse_overflow(Search<Value> search) {
  const Room room;
  OutArray<Value> out(2);
  Out<std::size_t> count;
  expect_overflow_refused(sizeof(Value), "capacity", [&](std::size_t capacity) {
    return search(room.elements, nullptr, nullptr, out.data(), capacity, count.address());
  });
  EXPECT_TRUE(out.is_untouched() && count.is_untouched());
}

TEST(ElementsCandidates, RefusesNull) { refuse_null(abut_elements_candidates, "pairs"); }
TEST(ElementsCandidates, RefusesStructSize) { refuse_struct_size(abut_elements_candidates); }
TEST(ElementsCandidates, RefusesOptions) { refuse_options(abut_elements_candidates); }
TEST(ElementsCandidates, RefusesKinds) { refuse_kinds(abut_elements_candidates); }
TEST(ElementsCandidates, RefusesOverflow) { refuse_overflow(abut_elements_candidates); }
TEST(ElementsClosest, RefusesNull) { refuse_null(abut_elements_closest, "stencils"); }
TEST(ElementsClosest, RefusesStructSize) { refuse_struct_size(abut_elements_closest); }
TEST(ElementsClosest, RefusesOptions) { refuse_options(abut_elements_closest); }
TEST(ElementsClosest, RefusesOverflow) { refuse_overflow(abut_elements_closest); }
TEST(ElementsFirstTouches, RefusesNull) { refuse_null(abut_elements_first_touches, "stencils"); }
TEST(ElementsFirstTouches, RefusesStructSize) { refuse_struct_size(abut_elements_first_touches); }
TEST(ElementsFirstTouches, RefusesOptions) { refuse_options(abut_elements_first_touches); }
TEST(ElementsFirstTouches, RefusesKinds) { refuse_kinds(abut_elements_first_touches); }
TEST(ElementsFirstTouches, RefusesOverflow) { refuse_overflow(abut_elements_first_touches); }
TEST(ElementsCrossings, RefusesNull) { refuse_null(abut_elements_crossings, "crossings"); }
TEST(ElementsCrossings, RefusesStructSize) { refuse_struct_size(abut_elements_crossings); }
TEST(ElementsCrossings, RefusesOptions) { refuse_options(abut_elements_crossings); }
TEST(ElementsCrossings, RefusesOverflow) { refuse_overflow(abut_elements_crossings); }
TEST(ElementsOptionsInit, LeavesWrongSizesAlone) {
  Out<abut_elements_options> out;
  abut_elements_options_init(nullptr, sizeof(abut_elements_options));
  abut_elements_options_init(out.address(), 0);
  EXPECT_TRUE(out.is_untouched());
}

}  // namespace
