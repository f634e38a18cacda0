// Results of queries on two shapes, seen from elsewhere and from the other side.
export module abut.shape.frames;
import abut.math;
import abut.shape.records;

export namespace abut {

// A distance or a contact, from the frame that is placed by the pose to the one that it is placed in.
// In place: the record is larger than the work on it.
template <class Found>
inline void move_by(Found& found, const Pose& pose) {
  found.point_a = pose * found.point_a;
  found.point_b = pose * found.point_b;
  found.normal = pose.rotation * found.normal;
}

// What was a becomes b, where `swapped`. Without a branch on that: which side comes first is often as good
// as random.
template <class Found>
inline void swap_sides(Found& found, bool swapped = true) {
  const auto exchange = [swapped](auto& a, auto& b) {
    const auto old_a = a, old_b = b;
    a = swapped ? old_b : old_a;
    b = swapped ? old_a : old_b;
  };
  exchange(found.point_a, found.point_b);
  found.normal = (swapped ? -1.0 : 1.0) * found.normal;
  if constexpr (requires { found.feature_a; }) {
    exchange(found.feature_a, found.feature_b);
  }
}

}  // namespace abut
