// Results of queries on two shapes, seen from elsewhere and from the other side.
module;
#include <utility>
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

// What was a becomes b.
template <class Found>
inline void swap_sides(Found& found) {
  std::swap(found.point_a, found.point_b);
  found.normal = -found.normal;
  if constexpr (requires { found.feature_a; }) {
    std::swap(found.feature_a, found.feature_b);
  }
}

}  // namespace abut
