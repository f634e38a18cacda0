// SPDX-License-Identifier: Apache-2.0
// What the tests of the C interface share: owners of its objects, out-parameters that notice when they are written,
// and assertions on statuses and messages.
#pragma once

#include <abut/abut.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace abut_test {

// Holds when a call answered ABUT_OK and left no message.
testing::AssertionResult succeeded(abut_status status);

// For calls of helpers, without which a test means nothing.
void require(abut_status status);

// As many threads as a test wants; one where the build is without them.
inline std::uint32_t threads_of_build(std::uint32_t wanted) { return abut_has_feature("threads") != 0 ? wanted : 1; }

// Holds when a call failed with exactly this status and a message that contains every word.
testing::AssertionResult refused(abut_status status, abut_status expected,
                                 std::initializer_list<std::string_view> words);

// An out-parameter, filled with a pattern that a failing call must leave alone.
template <class Value>
class Out {
  static_assert(std::is_trivially_copyable_v<Value>);
  using Bytes = std::array<unsigned char, sizeof(Value)>;

 public:
  Out() {
    before_.fill(0xA5);
    value_ = std::bit_cast<Value>(before_);
  }
  explicit Out(const Value& before) : value_(before), before_(std::bit_cast<Bytes>(before)) {}

  Value* address() { return &value_; }
  const Value& value() const { return value_; }
  bool is_untouched() const { return std::bit_cast<Bytes>(value_) == before_; }

 private:
  Value value_;
  Bytes before_{};
};

// The same for an array.
template <class Value>
class OutArray {
 public:
  explicit OutArray(std::size_t size) : values_(size, Out<Value>{}.value()) {}

  Value* data() { return values_.data(); }
  std::size_t size() const { return values_.size(); }
  const Value& operator[](std::size_t index) const { return values_.at(index); }
  bool is_untouched() const { return is_untouched_from(0); }
  bool is_untouched_from(std::size_t first) const {
    for (std::size_t index = first; index < values_.size(); ++index) {
      using Bytes = std::array<unsigned char, sizeof(Value)>;
      if (std::bit_cast<Bytes>(values_.at(index)) != std::bit_cast<Bytes>(Out<Value>{}.value())) return false;
    }
    return true;
  }

 private:
  std::vector<Value> values_;
};

// Owns one reference to a shape.
class Shape {
 public:
  Shape() = default;
  explicit Shape(abut_shape* shape) : shape_(shape) {}
  Shape(Shape&& other) noexcept : shape_(other.shape_) { other.shape_ = nullptr; }
  Shape& operator=(Shape&& other) noexcept {
    std::swap(shape_, other.shape_);
    return *this;
  }
  Shape(const Shape&) = delete;
  Shape& operator=(const Shape&) = delete;
  ~Shape() { abut_shape_release(shape_); }

  // Implicit, so that the tests read like calls of the C interface.
  operator abut_shape*() const { return shape_; }  // NOLINT(google-explicit-constructor)

 private:
  abut_shape* shape_ = nullptr;
};

Shape make_sphere(double radius);
Shape make_box(double half_x, double half_y, double half_z);
Shape make_capsule(double radius, double half_height);
Shape make_plane(abut_vec3 normal, double offset);
Shape make_octahedron(double radius);                       // a hull of six points
Shape make_square_mesh(double half_side);                   // two triangles at z = 0, front up
Shape make_terrain(std::uint32_t samples, double spacing);  // flat at z = 0 but for a bump in the middle
Shape make_of_kind(const char* kind, const std::vector<double>& parameters, const std::vector<double>& reals = {},
                   const std::vector<std::uint32_t>& indices = {});
Shape make_composite(const std::vector<const abut_shape*>& children, const std::vector<abut_pose>& poses);
// All contacts of a pair, not reduced.
std::vector<abut_contact> contacts_of(const abut_shape* a, const abut_pose& pose_a, const abut_shape* b,
                                      const abut_pose& pose_b, double margin = 0);
// The signed distance of a pair, which has to lie within its bounds.
double distance_of(const abut_shape* a, const abut_pose& pose_a, const abut_shape* b, const abut_pose& pose_b);
// That the generic door refuses these numbers and leaves its out-parameter alone.
void expect_kind_refused(const char* kind, const std::vector<double>& parameters, const std::vector<double>& reals,
                         const std::vector<std::uint32_t>& indices, abut_status status,
                         std::initializer_list<std::string_view> words);
// One shape of every kind, all about one unit large, in the order sphere, box, capsule, plane, hull, mesh, height
// field.
std::vector<Shape> make_one_of_each_kind();

template <class Value>
Value filled_by(void (*init)(Value*, std::uint32_t)) {
  Value value;
  init(&value, sizeof value);
  return value;
}
inline abut_geometry_options default_geometry_options() { return filled_by(abut_geometry_options_init); }
inline abut_universe_options default_universe_options() { return filled_by(abut_universe_options_init); }
inline abut_policy default_policy() { return filled_by(abut_policy_init); }
inline abut_sleep default_sleep() { return filled_by(abut_sleep_init); }
inline abut_focus default_focus() { return filled_by(abut_focus_init); }
inline abut_query_filter default_filter() { return filled_by(abut_query_filter_init); }
abut_focus make_focus(std::uint32_t near_tag, std::uint32_t far_tag, double near_distance, double far_distance);

// A copy of a list that a universe lends out.
template <class Value>
std::vector<Value> copy_of(abut_status (*lend)(const abut_universe*, const Value**, std::size_t*),
                           const abut_universe* universe) {
  const Value* first = nullptr;
  std::size_t count = 0;
  require(lend(universe, &first, &count));
  std::vector<Value> all;
  std::copy_n(first, count, std::back_inserter(all));
  return all;
}

inline constexpr abut_collidable anything{ABUT_COLLIDABLE_ANY, 0, 0};
inline constexpr std::array<abut_broadphase, 5> broadphases{ABUT_BROADPHASE_AUTO, ABUT_BROADPHASE_BRUTE,
                                                            ABUT_BROADPHASE_TREE, ABUT_BROADPHASE_SWEEP_AND_PRUNE,
                                                            ABUT_BROADPHASE_HASH_GRID};

// The kinds of events, each as its first letter, with a following c for those of contacts.
std::string letters_of(const std::vector<abut_event>& events);

// Owns a universe.
class Universe {
 public:
  Universe() : Universe(nullptr) {}
  explicit Universe(const abut_universe_options* options);
  Universe(const Universe&) = delete;
  Universe& operator=(const Universe&) = delete;
  ~Universe() { abut_universe_destroy(universe_); }

  operator abut_universe*() const { return universe_; }  // NOLINT(google-explicit-constructor)

  abut_part_id add_part(const abut_pose& pose, abut_motion motion = ABUT_MOTION_DYNAMIC, std::uint64_t user_data = 0);
  abut_geometry_id add_geometry(abut_part_id part, const abut_shape* shape, double tolerance = 0.0);
  abut_geometry_id add_geometry(abut_part_id part, const abut_shape* shape, const abut_geometry_options& options);
  abut_geometry_id add(const abut_shape* shape, const abut_pose& pose, abut_motion motion = ABUT_MOTION_DYNAMIC,
                       double tolerance = 0.0);
  void move(abut_part_id part, const abut_pose& pose);
  void park(abut_geometry_id geometry, abut_parking parking);
  abut_geometry_info describe(abut_geometry_id geometry) const;
  std::vector<abut_contact> contacts() const;
  std::vector<abut_event> events() const;
  abut_step_stats stats() const;
  std::uint64_t hash() const;
  std::vector<abut_contact> step();  // one step of no length, then its contacts

 private:
  abut_universe* universe_ = nullptr;
};

inline constexpr abut_quat no_rotation{1.0, 0.0, 0.0, 0.0};
inline constexpr abut_pose identity{{0.0, 0.0, 0.0}, no_rotation};
constexpr abut_pose at(double x, double y, double z) { return {{x, y, z}, no_rotation}; }

// Everything that a universe tells about itself, as bytes: parts, geometries, poses, counters, contacts, events,
// statistics.
std::vector<unsigned char> snapshot(const abut_universe* universe);

// A small stepped universe with contacts, and the ids that a caller could get wrong.
class Scene {
 public:
  Scene();

  Universe universe;
  Universe other;  // with the same slots in use
  Shape ball = make_sphere(1.0);
  Shape block = make_box(1.0, 1.0, 1.0);
  abut_part_id part{};
  abut_part_id second_part{};
  abut_geometry_id geometry{};
  abut_geometry_id second_geometry{};
  std::vector<abut_part_id> stale_parts;           // null, destroyed, foreign, never issued
  std::vector<abut_geometry_id> stale_geometries;  // the same kinds

  bool is_unchanged() const { return snapshot(universe) == before_; }

 private:
  std::vector<unsigned char> before_;
};

}  // namespace abut_test

// The ids are plain C structs; the tests compare them often.
inline bool operator==(const abut_part_id& a, const abut_part_id& b) {
  return a.slot == b.slot && a.generation == b.generation;
}
inline bool operator==(const abut_geometry_id& a, const abut_geometry_id& b) {
  return a.slot == b.slot && a.generation == b.generation;
}
