// Convex shapes are cast as they are; meshes, height fields, particles and composites part by part in the order in which
// the boxes are met, since the normal of the nearest part says nothing of the others; what holes leave of solids in
// strides.
module abut.any_shape.shape_cast;
import abut.any_shape;
import abut.continuous.linear_cast;
import abut.continuous.parts_in_order;
import abut.core;
import abut.core.standard;
import abut.math;
import abut.narrowphase.convex;
import abut.registry;
import abut.shape;

namespace abut {
namespace {

// Bound of the coordinates of a shape in its own frame; nothing is added by shapes without bounds.
Real coordinates_of(const Aabb& box) {
  return box.is_bounded() ? std::max(largest_magnitude(box.low), largest_magnitude(box.high)) : 0;
}
Real size_of(const Aabb& a, const Aabb& b, const Pose& ab) {
  return coordinates_of(a) + coordinates_of(b) + largest_magnitude(ab.position);
}

// The furthest that a convex shape reaches in a direction of length one.
template <Convex S>
Real reach(const S& shape, const Pose& pose, const Vec3& direction) {
  return dot(placed_support(shape, place(shape, pose), direction).point, direction) + shape.radius();
}

LinearMotion turned(const LinearMotion& motion, const Rotation& into) {
  return {UnitVec3::from_unit_unchecked(into.undo(motion.direction)), motion.length};
}
[[maybe_unused]] LinearMotion seen_from_b(const LinearMotion& motion, const Pose& ab) {
  const LinearMotion along = turned(motion, ab.rotation);
  return {-along.direction, along.length};
}
Pose moved(const Pose& pose, const LinearMotion& motion, Real way) {
  return {pose.rotation, pose.position + way * motion.direction.vec()};
}

// What of the two shapes is being cast.
struct Names {
  Feature feature_a{FeatureKind::whole, 0}, feature_b{FeatureKind::whole, 0};
  std::uint32_t child_a = 0, child_b = 0;
};

// Whether a touch is on a side that stops. Of one-sided triangles in which a shape starts, the contacts have told
// already whether it came from the front. `outward`: the normal, from the part.
template <class Part>
bool stops(const Part& part, const FirstTouch& touch, const Vec3& outward) {
  if constexpr (requires { part.is_one_sided(); }) {
    // Rounding must not open edges of triangles that stand upright.
    return !part.is_one_sided() || (touch.travelled > 0 && dot(part.normal(), outward) > -64 * epsilon);
  } else {
    return true;
  }
}

// Everything is in the frame of the first shape, where the second one moves.
class ShapeCast {
 public:
  ShapeCast(const QuerySettings& settings, const LinearMotion& motion, Real size)
      : settings_(settings), direction_(motion.direction), limit_(motion.length), size_(size) {}

  // The pose of b is that before the motion.
  void cast(const AnyShape& a, const Pose& pose_a, const AnyShape& b, const Pose& pose_b, const Names& names);

  [[nodiscard]] const std::optional<FirstTouch>& best() const [[clang::lifetimebound]] { return best_; }
  [[nodiscard]] const Names& names() const [[clang::lifetimebound]] { return names_; }
  // Some children may have no answer, as two terrains; no answer at all is one of the whole.
  [[nodiscard]] Outcome outcome() const { return any_ok_ ? Outcome::ok : last_.value_or(Outcome::ok); }

 private:
  void note(Outcome outcome) {
    any_ok_ = any_ok_ || outcome == Outcome::ok;
    last_ = outcome;
  }
  // A touch in the frame that is placed by `frame` at the start: of b where the sides are swapped, which moves.
  void keep(FirstTouch touch, const Pose& frame, bool swapped, const Names& names) {
    if (best_ && !(touch.travelled < best_->travelled)) {
      return;
    }
    move_by(touch.contact, swapped ? moved(frame, {direction_, limit_}, touch.travelled) : frame, swapped);
    best_ = touch;
    names_ = names;
    limit_ = std::min(limit_, touch.travelled);
  }

  template <Assembly A>
  void cast_children(const A& a, const Pose& pose_a, const AnyShape& b, const Pose& pose_b, bool swapped, const Names& names);
  template <class A, class B>
  void cast_whole(const A& a, const B& b, const AnyShape& any_a, const AnyShape& any_b, const Pose& pose_a, const Pose& ab,
                  const LinearMotion& motion, const Names& names);
  void cast_in_strides(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& ab, const LinearMotion& motion,
                       const Names& names);
  template <Convex A, Convex B>
  void cast_part(const A& part, const B& b, const Pose& ab, const LinearMotion& motion, const Pose& frame, bool swapped,
                 const Names& names);
  template <HasParts A, class B>
  void cast_parts(const A& a, const B& b, const Pose& ab, const LinearMotion& motion, const Pose& frame, bool swapped,
                  const Names& names);

  [[nodiscard]] Real slack() const { return std::max(settings_.margin, Real{0}) + 2 * touching_after(size_, limit_); }

  QuerySettings settings_;
  UnitVec3 direction_;
  Real limit_;  // later touches are of no interest
  Real size_;   // of the coordinates of the whole
  std::optional<FirstTouch> best_;
  Names names_;
  bool any_ok_ = false;
  std::optional<Outcome> last_;
};

// Two convex shapes, or one and a half-space, along whose normal everything is as far as the whole.
template <class A, class B>
void ShapeCast::cast_whole(const A& a, const B& b, const AnyShape& any_a, const AnyShape& any_b, const Pose& pose_a,
                           const Pose& ab, const LinearMotion& motion, const Names& names) {
  Real start = 0;
  const auto distance_at = [&](Real way, Distance& out) {
    const Outcome outcome = pair_distance(any_a, any_b, moved(ab, motion, way), settings_, out);
    start = way == 0 ? out.lower : start;
    return outcome;
  };
  const auto gap_along = [&](const Vec3& normal) {
    if constexpr (Convex<A> && Convex<B>) {
      return -reach(b, ab, -normal) - reach(a, Pose::identity(), normal);
    } else {
      return start;
    }
  };
  std::optional<FirstTouch> touch;
  note(first_touch({motion.direction, limit_}, size_, settings_.margin, distance_at, gap_along, touch));
  if (touch) {
    keep(*touch, pose_a, false, names);
  }
}

// Whatever has a distance: what holes leave, and holes by themselves.
void ShapeCast::cast_in_strides(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& ab,
                                const LinearMotion& motion, const Names& names) {
  constexpr Real strides_of_shape = 64, most_strides = 1024;
  const Aabb still = aabb_of(a, Pose::identity()).inflated(slack()), moving = aabb_of(b, ab);
  const bool are_bounded = still.is_bounded() && moving.is_bounded();
  const std::optional<Passage> passage = are_bounded ? passage_of(still, moving, motion) : Passage{0, limit_};
  if (!passage) {
    note(Outcome::ok);
    return;
  }
  const Real extent = std::min(largest_magnitude(still.high - still.low), largest_magnitude(moving.high - moving.low));
  const Real stride =
      std::max(extent < infinity ? extent / strides_of_shape : 0, (passage->leave - passage->enter) / most_strides);
  std::optional<FirstTouch> touch;
  note(first_touch_by_strides(
      *passage, size_, settings_.margin, stride,
      [&](Real way, Distance& out) { return pair_distance(a, b, moved(ab, motion, way), settings_, out); }, touch));
  if (touch) {
    keep(*touch, pose_a, false, names);
  }
}

template <Convex A, Convex B>
void ShapeCast::cast_part(const A& part, const B& b, const Pose& ab, const LinearMotion& motion, const Pose& frame, bool swapped,
                          const Names& names) {
  std::optional<FirstTouch> touch;
  note(first_touch(
      {motion.direction, limit_}, size_, settings_.margin,
      [&](Real way, Distance& out) { return convex_distance(part, b, moved(ab, motion, way), settings_, out); },
      [&](const Vec3& normal) { return -reach(b, ab, -normal) - reach(part, Pose::identity(), normal); }, touch));
  if (touch && stops(part, *touch, touch->contact.normal) && stops(b, *touch, ab.rotation.undo(-touch->contact.normal))) {
    keep(*touch, frame, swapped, names);
  }
}

template <HasParts A, class B>
void ShapeCast::cast_parts(const A& a, const B& b, const Pose& ab, const LinearMotion& motion, const Pose& frame, bool swapped,
                           const Names& names) {
  visit_in_order(a, b.aabb(ab), motion, slack(), limit_, [&](const auto& met) {
    Names of_part = names;
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

// Of solids that no hole cuts.
template <Assembly A>
void ShapeCast::cast_children(const A& a, const Pose& pose_a, const AnyShape& b, const Pose& pose_b, bool swapped,
                              const Names& names) {
  const Pose ab = relative(pose_a, pose_b);
  const LinearMotion motion = turned({swapped ? -direction_ : direction_, limit_}, pose_a.rotation);
  const Aabb moving = aabb_of(b, ab);
  const Real near = slack();
  std::vector<std::pair<Real, std::uint32_t>> met;
  a.visit_children(swept(moving, motion, 0, motion.length).inflated(near), [&](std::uint32_t child) {
    const Aabb still = aabb_of(*a.children()[child].shape, a.children()[child].pose).inflated(near);
    const bool are_bounded = still.is_bounded() && moving.is_bounded();
    if (const auto passage = are_bounded ? passage_of(still, moving, motion) : Passage{0, motion.length}) {
      met.emplace_back(passage->enter, child);
    }
  });
  std::ranges::sort(met);
  for (const auto& [enter, child] : met) {
    if (enter > limit_) {
      return;
    }
    Names of_child = names;
    (swapped ? of_child.child_b : of_child.child_a) = child;
    const AnyShape& shape = *a.children()[child].shape;
    const Pose pose = pose_a * a.children()[child].pose;
    swapped ? cast(b, pose_b, shape, pose, of_child) : cast(shape, pose, b, pose_b, of_child);
  }
}

template <class S>
bool is_cut(const S& shape) {
  if constexpr (Assembly<S>) {
    return !shape.holes().empty();
  } else {
    return false;
  }
}

void ShapeCast::cast(const AnyShape& any_a, const Pose& pose_a, const AnyShape& any_b, const Pose& pose_b, const Names& names) {
  const Pose ab = relative(pose_a, pose_b);
  const LinearMotion motion = turned({direction_, limit_}, pose_a.rotation);
  std::visit(
      [&]<class A, class B>(const A& a, const B& b) {
        if constexpr (Assembly<A> || Assembly<B>) {
          if (is_cut(a) || is_cut(b)) {
            cast_in_strides(any_a, any_b, pose_a, ab, motion, names);
          } else if constexpr (Assembly<A>) {
            cast_children(a, pose_a, any_b, pose_b, false, names);
          } else {
            cast_children(b, pose_b, any_a, pose_a, true, names);
          }
        } else if constexpr (Hole<A> || Hole<B>) {
          cast_in_strides(any_a, any_b, pose_a, ab, motion, names);
        } else if constexpr (HasParts<A> && (Convex<B> || HasParts<B>)) {
          cast_parts(a, b, ab, motion, pose_a, false, names);
        } else if constexpr (Convex<A> && HasParts<B>) {
          cast_parts(b, a, ab.inverse(), seen_from_b(motion, ab), pose_b, true, names);
        } else {
          cast_whole(a, b, any_a, any_b, pose_a, ab, motion, names);
        }
      },
      static_cast<const AnyShape::Variant&>(any_a), static_cast<const AnyShape::Variant&>(any_b));
}

// Shapes whose contacts at the start say more than a distance: which of their parts overlap, and on which side.
bool is_made_of_parts(const AnyShape& shape) {
  return std::visit([]<class S>(const S&) { return HasParts<S> || Assembly<S>; }, static_cast<const AnyShape::Variant&>(shape));
}

// The deepest contact before the motion, in the frame of a.
Outcome touch_at_start(const AnyShape& a, const AnyShape& b, const Pose& ab, const QuerySettings& settings,
                       std::optional<ShapeCastHit>& out) {
  Manifold contacts;
  const Outcome outcome = pair_contacts(a, b, ab, settings, contacts);
  if (outcome == Outcome::ok && !contacts.empty()) {
    const ContactPoint& deepest = *std::ranges::min_element(contacts, {}, &ContactPoint::distance);
    const Distance contact{deepest.distance, deepest.distance, deepest.distance,   deepest.point_a,
                           deepest.point_b,  deepest.normal,   settings.algorithm, 0};
    out = ShapeCastHit{0, contact, deepest.feature_a, deepest.feature_b, deepest.child_a, deepest.child_b};
  }
  return outcome;
}

}  // namespace

Outcome cast_shapes(const AnyShape& a, const Pose& pose_a, const Vec3& displacement_a, const AnyShape& b, const Pose& pose_b,
                    const Vec3& displacement_b, const QuerySettings& settings, Real most, std::optional<ShapeCastHit>& out) {
  if (!is_supported(a.index(), b.index())) {
    return Outcome::unsupported;
  }
  const Pose ab = relative(pose_a, pose_b);
  const Vec3 displacement = pose_a.rotation.undo(displacement_b - displacement_a);
  const Real length = norm(displacement);
  const LinearMotion motion{UnitVec3::make(displacement).value_or(UnitVec3::axis_z()), most * length};
  const Aabb box_a = aabb_of(a, Pose::identity());
  std::optional<ShapeCastHit> hit;
  if ((is_made_of_parts(a) || is_made_of_parts(b)) &&
      box_a.overlaps(aabb_of(b, ab).inflated(std::max(settings.margin, Real{0})))) {
    if (const Outcome outcome = touch_at_start(a, b, ab, settings, hit); outcome != Outcome::ok) {
      return outcome;
    }
  }
  if (!hit) {
    ShapeCast search(settings, motion, size_of(box_a, aabb_of(b, Pose::identity()), ab));
    search.cast(a, Pose::identity(), b, ab, {});
    if (search.outcome() != Outcome::ok || !search.best()) {
      return search.outcome();
    }
    const Names& names = search.names();
    const Real travelled = search.best()->travelled;
    hit = ShapeCastHit{travelled > 0 ? std::min(travelled / length, most) : 0,
                       search.best()->contact,
                       names.feature_a,
                       names.feature_b,
                       names.child_a,
                       names.child_b};
  }
  move_by(hit->contact, {pose_a.rotation, pose_a.position + hit->fraction * displacement_a});
  out = hit;
  return Outcome::ok;
}

}  // namespace abut
