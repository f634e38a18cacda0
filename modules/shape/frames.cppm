// Results of queries on two shapes, seen from elsewhere and from the other side.
export module abut.shape.frames;
import abut.core.standard;
import abut.math;
import abut.shape.records;

export namespace abut {

// A distance or a contact, from the frame that is placed by the pose to the one that it is placed in; what
// was a becomes b, where `swapped`. Which side comes first is often as good as random, hence lanes that are
// chosen by a mask and no branch.
template <class Found>
[[gnu::always_inline]] inline void move_by(Found& found, const Pose& pose, bool swapped = false) {
  const LaneMatrix columns = LaneMatrix::columns_of(pose.rotation);
  const Lanes position = lanes_of(pose.position);
  const Lanes point_a = columns.apply(found.point_a, position), point_b = columns.apply(found.point_b, position);
  const Lanes normal = columns * found.normal;
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

}  // namespace abut
