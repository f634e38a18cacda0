// SPDX-License-Identifier: Apache-2.0
// The first touch of a shape that is cast, found so far. Knows no kernel.
export module abut.narrow.cast.cast_search;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cast.linear_cast;

export namespace abut {

// The furthest that a convex shape reaches in a direction of length one.
template <Convex S>
[[nodiscard]] Real reach(const S& shape, const Pose& pose, const Vec3& direction) {
  return dot(placed_support(shape, place(shape, pose), direction).point, direction) + shape.radius();
}

[[nodiscard]] inline Pose moved(const Pose& pose, const LinearMotion& motion, Real way) {
  return {pose.rotation, pose.position + way * motion.direction.vec()};
}

// What of the two shapes is being cast.
struct CastNames {
  Feature feature_a{FeatureKind::whole, 0}, feature_b{FeatureKind::whole, 0};
  std::uint32_t child_a = 0, child_b = 0;
};

// Everything is in one frame, in which the second shape moves.
class CastSearch {
 public:
  // `size`: of the coordinates of the whole.
  CastSearch(const QuerySettings& settings, const LinearMotion& motion, Real size)
      : settings_(settings), direction_(motion.direction), limit_(motion.length), size_(size) {}

  [[nodiscard]] const QuerySettings& settings() const [[clang::lifetimebound]] { return settings_; }
  [[nodiscard]] Real size() const { return size_; }
  // Later touches are of no interest. A reference, as it shrinks while the parts of a shape are visited.
  [[nodiscard]] const Real& limit() const [[clang::lifetimebound]] { return limit_; }
  // What is left of the motion, in the frame that is placed by `frame`; the other shape moves where the sides are
  // swapped.
  [[nodiscard]] LinearMotion motion_in(const Pose& frame, bool swapped) const {
    const UnitVec3 direction = swapped ? -direction_ : direction_;
    return {UnitVec3::from_unit_unchecked(frame.rotation.undo(direction)), limit_};
  }
  // How far from a box a touch with what it holds may be.
  [[nodiscard]] Real slack() const { return std::max(settings_.margin, Real{0}) + 2 * touching_after(size_, limit_); }

  [[nodiscard]] const std::optional<FirstTouch>& best() const [[clang::lifetimebound]] { return best_; }
  [[nodiscard]] const CastNames& names() const [[clang::lifetimebound]] { return names_; }
  // Some children may have no answer, as two terrains; no answer at all is one of the whole.
  [[nodiscard]] Outcome outcome() const { return any_ok_ ? Outcome::ok : last_.value_or(Outcome::ok); }

  // How a cast went, and its touch in the frame that is placed by `frame` at the start: of b where the sides are
  // swapped, which moves.
  void add(Outcome outcome, const std::optional<FirstTouch>& touch, const Pose& frame, bool swapped,
           const CastNames& names) {
    any_ok_ = any_ok_ || outcome == Outcome::ok;
    last_ = outcome;
    if (!touch || (best_ && !(touch->travelled < best_->travelled))) {
      return;
    }
    best_ = touch;
    move_by(best_->contact, swapped ? moved(frame, {direction_, limit_}, touch->travelled) : frame, swapped);
    names_ = names;
    limit_ = std::min(limit_, touch->travelled);
  }

 private:
  QuerySettings settings_;
  UnitVec3 direction_;
  Real limit_;
  Real size_;
  std::optional<FirstTouch> best_;
  CastNames names_;
  bool any_ok_ = false;
  std::optional<Outcome> last_;
};

}  // namespace abut
