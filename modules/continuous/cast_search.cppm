// The first touch of a shape that is cast, found so far, and the casts that can be told from the types of two shapes: of
// convex ones and of those that are made of convex parts. Those go part by part in the order in which the boxes are met, since
// the normal of the nearest part says nothing of the others.
export module abut.continuous.cast_search;
import abut.continuous.linear_cast;
import abut.continuous.parts_in_order;
import abut.core.standard;
import abut.math;
import abut.narrowphase.convex;
import abut.shape;

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
  // Later touches are of no interest.
  [[nodiscard]] Real limit() const { return limit_; }
  // What is left of the motion, in the frame that is placed by `frame`; the other shape moves where the sides are swapped.
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

  // How a cast went, and its touch in the frame that is placed by `frame` at the start: of b where the sides are swapped, which
  // moves.
  void add(Outcome outcome, const std::optional<FirstTouch>& touch, const Pose& frame, bool swapped, const CastNames& names) {
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

  // a is made of parts and placed by `frame`; b, which is so too or convex, moves in it from ab on.
  template <HasParts A, class B>
  void cast_parts(const A& a, const B& b, const Pose& ab, const LinearMotion& motion, const Pose& frame, bool swapped,
                  const CastNames& names);

 private:
  template <Convex A, Convex B>
  void cast_part(const A& part, const B& b, const Pose& ab, const LinearMotion& motion, const Pose& frame, bool swapped,
                 const CastNames& names);

  QuerySettings settings_;
  UnitVec3 direction_;
  Real limit_;
  Real size_;
  std::optional<FirstTouch> best_;
  CastNames names_;
  bool any_ok_ = false;
  std::optional<Outcome> last_;
};

[[nodiscard]] inline LinearMotion seen_from_b(const LinearMotion& motion, const Pose& ab) {
  return {UnitVec3::from_unit_unchecked(ab.rotation.undo(-motion.direction)), motion.length};
}

// Whether a touch is on a side that stops. Of one-sided triangles in which a shape starts, the contacts have told
// already whether it came from the front. `outward`: the normal, from the part.
template <class Part>
[[nodiscard]] bool stops(const Part& part, const FirstTouch& touch, const Vec3& outward) {
  if constexpr (requires { part.is_one_sided(); }) {
    // Rounding must not open edges of triangles that stand upright.
    return !part.is_one_sided() || (touch.travelled > 0 && dot(part.normal(), outward) > -64 * epsilon);
  } else {
    return true;
  }
}

template <Convex A, Convex B>
void CastSearch::cast_part(const A& part, const B& b, const Pose& ab, const LinearMotion& motion, const Pose& frame, bool swapped,
                           const CastNames& names) {
  std::optional<FirstTouch> touch;
  const Outcome outcome = first_touch(
      {motion.direction, limit_}, size_, settings_.margin,
      [&](Real way, Distance& out) { return convex_distance(part, b, moved(ab, motion, way), settings_, out); },
      [&](const Vec3& normal) { return -reach(b, ab, -normal) - reach(part, Pose::identity(), normal); }, touch);
  if (touch && !(stops(part, *touch, touch->contact.normal) && stops(b, *touch, ab.rotation.undo(-touch->contact.normal)))) {
    touch.reset();
  }
  add(outcome, touch, frame, swapped, names);
}

template <HasParts A, class B>
void CastSearch::cast_parts(const A& a, const B& b, const Pose& ab, const LinearMotion& motion, const Pose& frame, bool swapped,
                            const CastNames& names) {
  visit_in_order(a, b.aabb(ab), motion, slack(), limit_, [&](const auto& met) {
    CastNames of_part = names;
    Feature& feature = swapped ? of_part.feature_b : of_part.feature_a;
    std::uint32_t& child = swapped ? of_part.child_b : of_part.child_a;
    if constexpr (Surface<A>) {
      feature = {FeatureKind::face, met.index};
    } else {
      child = met.index;
    }
    const Pose at{frame.rotation, frame * met.place};
    const Pose from_part{ab.rotation, ab.position - met.place};
    if constexpr (Convex<B>) {
      cast_part(met.part, b, from_part, motion, at, swapped, of_part);
    } else {
      cast_parts(b, met.part, from_part.inverse(), seen_from_b(motion, ab), at * from_part, !swapped, of_part);
    }
  });
}

}  // namespace abut
