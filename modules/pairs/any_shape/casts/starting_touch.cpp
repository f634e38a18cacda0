// SPDX-License-Identifier: Apache-2.0
module abut.pairs.any_shape.casts.starting_touch;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.pairs.any_shape;
import abut.pairs.registry;

namespace abut {
namespace {

// Whether a shape has curved surfaces, or children that may have.
bool may_be_curved(const AnyShape& shape) {
  static constexpr auto kinds = []<class... S>(const std::variant<S...>*) {
    return std::array<bool, sizeof...(S)>{(Curved<S> || Assembly<S>)...};
  }(static_cast<const AnyShape::Variant*>(nullptr));
  return kinds[shape.index()];
}

Real size_of(const AnyShape& shape) {
  const Aabb box = aabb_of(shape, Pose::identity());
  return box.is_bounded() ? largest_magnitude(box.high - box.low) : infinity;
}

}  // namespace

Outcome find_starting_touch(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                            const StartSettings& settings, const SpeedAlong& speed_along, StartingTouch& out) {
  QuerySettings wide = settings.query;
  wide.margin += settings.tolerance;
  Manifold contacts;
  if (const Outcome outcome = pair_contacts(a, b, pose_a, pose_b, wide, contacts);
      outcome != Outcome::ok || contacts.empty()) {
    return outcome;
  }
  // Searches on curved shapes are off by this share of the size, and normals by its square root.
  constexpr Real error_of_curves = 1.4e-10, cosine_of_curves = 1e-4;
  const bool are_curved = may_be_curved(a) || may_be_curved(b);
  const Real error = settings.query.error_bound > 0 ? settings.query.error_bound : error_of_curves;
  const Real rounding = std::max(settings.rounding, are_curved ? error * std::min(size_of(a), size_of(b)) : 0);
  const ContactPoint& deepest = *std::ranges::min_element(contacts, {}, &ContactPoint::distance);
  const ContactPoint& steepest = *std::ranges::min_element(contacts, {}, speed_along);
  const bool is_deep = deepest.distance < settings.query.margin - rounding || settings.is_still;
  const bool approaches = speed_along(steepest) < -(are_curved ? cosine_of_curves : noise_of(1));
  out = {is_deep || !approaches ? deepest : steepest, is_deep || approaches};
  return Outcome::ok;
}

}  // namespace abut
