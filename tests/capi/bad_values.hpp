// SPDX-License-Identifier: Apache-2.0
// Values that no entry point may accept, and loops that feed them to one.
#pragma once

#include <limits>

#include "support.hpp"

namespace abut_test {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr std::size_t size_max = std::numeric_limits<std::size_t>::max();

inline abut_query_options default_options() {
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  return options;
}

struct BadNumber {
  double value;
  std::string_view word;  // what a message about it must contain
};
inline constexpr std::array<BadNumber, 3> non_finite_numbers{
    {{not_a_number, "nan"}, {infinity, "inf"}, {-infinity, "-inf"}}};

// Counts of elements of this many bytes that do not fit into memory; each wraps to something small when multiplied.
constexpr std::array<std::size_t, 3> overflowing_counts(std::size_t element_size) {
  return {size_max, size_max / element_size + 1, size_max / 2 + 1};
}

// Vectors with a NaN or an infinity in each place.
struct BadVector {
  abut_vec3 vector;
  std::string_view word;
};
std::vector<BadVector> non_finite_vectors();

struct BadPose {
  abut_pose pose;
  abut_status status;
  std::string_view word;
};
std::vector<BadPose> bad_poses();

// Feeds every bad pose, and no pose at all, to `call`, a callable from const abut_pose* to abut_status.
template <class Call>
void expect_pose_checked(std::string_view argument, Call call) {
  EXPECT_TRUE(refused(call(nullptr), ABUT_NULL_ARGUMENT, {argument, "null"}));
  for (const BadPose& bad : bad_poses()) {
    EXPECT_TRUE(refused(call(&bad.pose), bad.status, {argument, bad.word}));
  }
}

// The same for poses inside an options struct, where null means nothing.
template <class Call>
void expect_pose_field_checked(Call call) {
  for (const BadPose& bad : bad_poses()) EXPECT_TRUE(refused(call(bad.pose), bad.status, {"pose", bad.word}));
}

// Feeds every non-finite number to `call`, a callable from double to abut_status.
template <class Call>
void expect_non_finite_refused(std::string_view argument, Call call) {
  for (const BadNumber& bad : non_finite_numbers) {
    EXPECT_TRUE(refused(call(bad.value), ABUT_NOT_FINITE, {argument, bad.word}));
  }
}

// Feeds counts that do not fit into memory to `call`, a callable from size_t to abut_status.
template <class Call>
void expect_overflow_refused(std::size_t element_size, std::string_view argument, Call call) {
  for (const std::size_t count : overflowing_counts(element_size)) {
    EXPECT_TRUE(refused(call(count), ABUT_SIZE_OVERFLOW, {argument, std::to_string(count)}));
  }
}

// Feeds flags, tags and states that do not exist to `call`, a callable from const abut_geometry_options& to
// abut_status.
template <class Call>
void expect_unknown_geometry_values_refused(Call call) {
  for (const std::uint32_t value : {32U, 35U, 77U, 0x80000000U, 0xFFFFFFFFU}) {
    abut_geometry_options options = default_geometry_options();
    options.flags = value;
    EXPECT_TRUE(refused(call(options), ABUT_UNKNOWN_VALUE, {"options", "flags", std::to_string(value)}));
  }
  for (const std::uint32_t value : {64U, 77U, 0xFFFFFFFFU}) {
    abut_geometry_options options = default_geometry_options();
    options.tag = value;
    EXPECT_TRUE(refused(call(options), ABUT_OUT_OF_RANGE, {"options", "tag", std::to_string(value)}));
  }
  for (const std::uint32_t value : {3U, 77U, 0xFFFFFFFFU}) {
    abut_geometry_options options = default_geometry_options();
    options.parking = value;
    EXPECT_TRUE(refused(call(options), ABUT_UNKNOWN_VALUE, {"options", "parking", std::to_string(value)}));
  }
}

// A struct of a later version of the header: the known fields, and what came after.
template <class Struct>
struct Grown {
  Struct known;
  std::array<unsigned char, 16> tail;
};

// Feeds wrong sizes to `call`, a callable from const Struct* to abut_status that succeeds with `good`.
template <class Struct, class Call>
void expect_struct_size_checked(const Struct& good, Call call) {
  EXPECT_EQ(good.struct_size, sizeof(Struct)) << "the _init function fills in struct_size";
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, sizeof(std::uint32_t) - 1, sizeof(Struct) - 1}) {
    Struct wrong = good;
    wrong.struct_size = static_cast<std::uint32_t>(size);
    EXPECT_TRUE(refused(call(&wrong), ABUT_WRONG_STRUCT_SIZE, {"struct_size", std::to_string(size)}));
  }
  Grown<Struct> later{good, {}};
  for (const std::size_t known_tail : {sizeof(later), std::size_t{0xFFFFFFFFU}}) {
    for (const std::size_t place : {std::size_t{0}, later.tail.size() - 1}) {
      if (known_tail != sizeof(later) && place != 0) continue;
      later.known.struct_size = static_cast<std::uint32_t>(known_tail);
      later.tail = {};
      later.tail.at(place) = 1;
      EXPECT_TRUE(refused(call(&later.known), ABUT_WRONG_STRUCT_SIZE, {"struct_size", std::to_string(known_tail)}));
    }
  }
}

// A caller with a later header is welcome as long as it uses nothing that is unknown here.
template <class Struct, class Call>
void expect_zero_tail_accepted(const Struct& good, Call call) {
  Grown<Struct> later{good, {}};
  later.known.struct_size = sizeof(later);
  EXPECT_TRUE(succeeded(call(&later.known)));
}

}  // namespace abut_test
