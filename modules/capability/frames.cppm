// SPDX-License-Identifier: Apache-2.0
// Results of queries on two shapes, seen from elsewhere and from the other side.
export module abut.capability.frames;
import abut.capability.records;
import abut.core.standard;
import abut.math;

export namespace abut {

// Points and a normal in place of those of a distance or a contact; what was a becomes b, where `swapped`. Which side
// comes first is often as good as random, hence lanes that are chosen by a mask and no branch.
template <class Found>
[[gnu::always_inline]] inline void set_sides(Found& found, Lanes point_a, Lanes point_b, Lanes normal, bool swapped) {
  const LaneNumbers exchange = swapped ? -1 : 0;
  found.point_a = vec3_of(exchange ? point_b : point_a);
  found.point_b = vec3_of(exchange ? point_a : point_b);
  found.normal = vec3_of(exchange ? -normal : normal);
  if constexpr (requires { found.feature_a; }) {
    const Feature feature_a = found.feature_a, feature_b = found.feature_b;
    found.feature_a = swapped ? feature_b : feature_a;
    found.feature_b = swapped ? feature_a : feature_b;
    const std::uint32_t child_a = found.child_a, child_b = found.child_b;
    found.child_a = swapped ? child_b : child_a;
    found.child_b = swapped ? child_a : child_b;
  }
}

// A distance or a contact, from the frame that is placed by the pose to the one that it is placed in.
template <class Found>
[[gnu::always_inline]] inline void move_by(Found& found, const Pose& pose, bool swapped = false) {
  const LaneMatrix columns = LaneMatrix::columns_of(pose.rotation);
  const Lanes position = lanes_of(pose.position);
  set_sides(found, columns.apply(found.point_a, position), columns.apply(found.point_b, position),
            columns * found.normal, swapped);
}
// The same from a frame that is placed without being turned.
template <class Found>
[[gnu::always_inline]] inline void move_by(Found& found, const Vec3& shift, bool swapped = false) {
  const Lanes position = lanes_of(shift);
  set_sides(found, lanes_of(found.point_a) + position, lanes_of(found.point_b) + position, lanes_of(found.normal),
            swapped);
}

}  // namespace abut
