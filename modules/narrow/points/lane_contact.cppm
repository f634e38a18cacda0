// SPDX-License-Identifier: Apache-2.0
// A contact on the way from a closed form to its manifold, in vector registers.
//
// A record that is written number by number and read back whole waits for the stores. So does one that is moved or
// mirrored where it lies. Hence a contact is moved and mirrored before it is written, and written once, where it stays.
export module abut.narrow.points.lane_contact;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

struct LaneContact {
  Lanes point_a, point_b, normal;
  Real distance;
  Feature feature_a, feature_b;
  std::uint64_t id;

  inline operator ContactPoint() const {
    return {vec3_of(point_a), vec3_of(point_b), vec3_of(normal), distance, feature_a, feature_b, id};
  }
};

// What was a becomes b, where `swapped`.
[[nodiscard]] [[gnu::always_inline]] inline LaneContact with_sides(const LaneContact& contact, bool swapped) {
  const LaneNumbers exchange = swapped ? -1 : 0;
  return {exchange ? contact.point_b : contact.point_a,
          exchange ? contact.point_a : contact.point_b,
          exchange ? -contact.normal : contact.normal,
          contact.distance,
          swapped ? contact.feature_b : contact.feature_a,
          swapped ? contact.feature_a : contact.feature_b,
          contact.id};
}

// From the frame that is placed by the pose to the one that it is placed in.
[[nodiscard]] [[gnu::always_inline]] inline LaneContact moved_by(const LaneContact& contact, const Pose& pose) {
  const LaneMatrix columns = LaneMatrix::columns_of(pose.rotation);
  const Lanes position = lanes_of(pose.position);
  return {columns.apply(contact.point_a, position),
          columns.apply(contact.point_b, position),
          columns * contact.normal,
          contact.distance,
          contact.feature_a,
          contact.feature_b,
          contact.id};
}

[[nodiscard]] [[gnu::always_inline]] inline LaneContact moved_by(const LaneContact& contact, const Vec3& shift) {
  const Lanes position = lanes_of(shift);
  return {contact.point_a + position, contact.point_b + position, contact.normal, contact.distance,
          contact.feature_a,          contact.feature_b,          contact.id};
}

[[gnu::noinline, gnu::cold]] inline void make_room(Manifold& out) { out.reserve(2 * out.size() + 4); }

[[gnu::always_inline]] inline void append_contact(const LaneContact& contact, Manifold& out) {
  if (out.size() == out.capacity()) [[unlikely]] {
    make_room(out);
  }
  // With the way that allocates left in, what is appended would have to be in memory.
  if (out.size() == out.capacity()) {
    __builtin_unreachable();
  }
  [[clang::always_inline]] out.emplace_back(contact);
}

}  // namespace abut
