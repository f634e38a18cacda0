// SPDX-License-Identifier: Apache-2.0
// A sampled solid against a convex shape. The gap is the least value of the field in the shape. In overlap the depth is
// that of the deepest point, which a move has to make up for at least.
export module abut.narrow.field.field_contacts;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.field.field_descent;

export namespace abut {

[[nodiscard]] inline bool fields_support(Algorithm algorithm) { return takes_closed_forms(algorithm); }

// How far b has to move at most to be parted from the solid: along a normal or an axis of the field, past its box. No
// move is known to part anything from a container.
template <SampledSolid F, class LowestOf>
[[nodiscard]] Real most_depth(const F& field, const Vec3& normal, LowestOf&& lowest_of) {
  if (field.is_inside_out()) {
    return infinity;
  }
  const Aabb& box = field.solid_box();
  const auto move_along = [&](const Vec3& direction) {
    const Vec3 highest{direction.x > 0 ? box.high.x : box.low.x, direction.y > 0 ? box.high.y : box.low.y,
                       direction.z > 0 ? box.high.z : box.low.z};
    return dot(highest, direction) - lowest_of(direction);
  };
  Real least = move_along(normal);
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    least = std::min({least, move_along(axis), move_along(-axis)});
  }
  return std::max(least, Real{0});
}

// A point that touches, as a distance. `radius`: of b around it. `least_core`: see LeastValue.
template <SampledSolid F, class Touch, class LowestOf>
[[nodiscard]] Distance distance_of_touch(const F& field, const Touch& touch, Real radius, Real least_core,
                                         LowestOf&& lowest_of) {
  Distance out{};
  out.normal = touch.normal;
  out.distance = touch.distance - radius;
  out.point_b = touch.point - radius * touch.normal;
  out.point_a = touch.point - touch.distance * touch.normal;
  out.algorithm = Algorithm::field;
  const Real least = least_core > 0 ? least_core - radius : -infinity;
  out.lower =
      least >= 0 ? std::min(least, out.distance) : std::min(out.distance, -most_depth(field, touch.normal, lowest_of));
  if (out.distance >= 0 || touch.is_of_nothing()) {
    out.lower = std::min(std::max(out.lower, least), out.distance);
    out.upper = touch.is_proven ? out.distance : infinity;
  } else {
    const Real value = field.value_at(out.point_b).value;
    out.upper = std::max(out.distance, value < 0 ? -field.least_way(value) : 0);
  }
  return out;
}

// The nearest points of b and the surface, from points that are close: in turn the nearest point of either.
template <SampledSolid F, Convex B>
[[nodiscard]] auto settled_touch(const CoreInField<F, B>& core, const F& field, const Pose& ab, const Vec3& start) {
  constexpr int most_rounds = 16;
  constexpr Real end_share = 1e-6;  // of a cell
  auto best = core.touch(start);
  for (int i = 0; i < most_rounds && best.is_proven && best.distance > 0; ++i) {
    const Vec3 on_surface = core.nearest_on_surface(best.point, best.point - best.distance * best.normal);
    const Vec3 point = ab * core.nearest(ab.undo(on_surface)), between = point - on_surface;
    const Real length = norm(between);
    if (!(length > 0 && length < best.distance - end_share * field.finest())) {
      break;
    }
    best = {point, (1 / length) * between, length, true};
  }
  return best;
}

// The point of the core of b that decides the distance, and how it was found.
template <SampledSolid F, Convex B>
[[nodiscard]] auto deepest_touch(const CoreInField<F, B>& core, const F& field, const B& b, const Pose& ab) {
  const LeastValue least = least_value(field, b, ab);
  return std::pair(settled_touch(core, field, ab, least.point.point), least);
}

template <SampledSolid F, Convex B>
[[nodiscard]] Outcome field_distance(const F& field, const B& b, const Pose& ab, const QuerySettings& settings,
                                     Distance& out) {
  if (!fields_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  const CoreInField<F, B> core(field, b, ab);
  const auto [touch, least] = deepest_touch(core, field, b, ab);
  const auto lowest_of = [&](const Vec3& direction) {
    return dot(ab * b.support(ab.rotation.undo(-direction)).point, direction) - b.radius();
  };
  out = distance_of_touch(field, touch, b.radius(), least.lower, lowest_of);
  out.iterations = least.boxes;
  return Outcome::ok;
}

// One point of the core of b that touches.
template <class Touch>
[[nodiscard]] ContactPoint contact_of_touch(const Touch& touch, Real radius, const Feature& feature) {
  const Feature of_field{FeatureKind::whole, 0};
  return {touch.point - touch.distance * touch.normal,
          touch.point - radius * touch.normal,
          touch.normal,
          touch.distance - radius,
          of_field,
          feature,
          contact_id(of_field, feature)};
}

// Near the middle of a solid the way to the surface may be longer than the value tells. No contact is deeper than the
// one that decides the distance.
inline void bound_depths(Real deepest, std::size_t first, Manifold& out) {
  for (ContactPoint& contact : std::span(out).subspan(first)) {
    if (contact.distance < deepest && deepest < 0) {
      contact.point_a += (contact.distance - deepest) * contact.normal;
      contact.distance = deepest;
    }
  }
}

// The point that decides the distance is among the contacts, but where others are as deep within `tie`. `near`:
// contacts whose points of the core are so near to each other are the same. `radius`: of b around it.
inline void settle_deepest(const ContactPoint& deepest, Real radius, Real tie, Real near, std::size_t first,
                           Manifold& out) {
  bound_depths(deepest.distance, first, out);
  const auto of_core = [&](const ContactPoint& contact) { return contact.point_b + radius * contact.normal; };
  for (ContactPoint& contact : std::span(out).subspan(first)) {
    if (contact.distance <= deepest.distance + tie) {
      return;
    }
    if (squared_norm(of_core(contact) - of_core(deepest)) <= near * near) {
      const Feature feature = contact.feature_b;
      const std::uint64_t id = contact.id;
      contact = deepest;
      contact.feature_b = feature;
      contact.id = id;
      return;
    }
  }
  out.push_back(deepest);
}

// At each deepest point, and at the corners of the face of b that looks into the solid there.
template <SampledSolid F, Convex B>
[[nodiscard]] Outcome field_contacts(const F& field, const B& b, const Pose& ab, const QuerySettings& settings,
                                     Manifold& out) {
  if (!fields_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  const Real limit = settings.margin + b.radius();
  const Aabb reach = field.solid_box().inflated(std::max(settings.margin, Real{0}));
  if (!field.is_inside_out() && !b.aabb(ab).overlaps(reach)) {
    return Outcome::ok;
  }
  const CoreInField<F, B> core(field, b, ab);
  const auto [touch, least] = deepest_touch(core, field, b, ab);
  if (touch.distance > limit || touch.is_of_nothing()) {
    return Outcome::ok;
  }
  std::vector<FieldPoint> deepest;
  find_deepest(field, b, ab, limit, deepest);
  const std::size_t first = out.size();
  constexpr Real same_share = 1e-3, same_depth = 1e-6;  // of a cell
  const Real tie = same_depth * field.finest() + noise_of(b.extent() + largest_magnitude(ab.position));
  for (const FieldPoint& at : deepest) {
    const Face face = b.supporting_face(-at.field.gradient);
    Real least_of_face = infinity;
    for (const FaceVertex& vertex : face.vertices.span()) {
      const FieldPoint corner = core.at(vertex.point);
      least_of_face = std::min(least_of_face, corner.field.value);
      const Feature feature{FeatureKind::vertex, vertex.vertex};
      const auto is_there = [&](const ContactPoint& other) { return other.feature_b == feature; };
      if (corner.field.value <= limit && std::ranges::none_of(std::span(out).subspan(first), is_there)) {
        out.push_back(contact_of_touch(core.touch(vertex.point), b.radius(), feature));
      }
    }
    if (at.field.value < least_of_face - tie) {
      out.push_back(contact_of_touch(core.touch(at.point), b.radius(), feature_of(face)));
    }
  }
  const Face face = b.supporting_face(-least.point.field.gradient);
  settle_deepest(contact_of_touch(touch, b.radius(), feature_of(face)), b.radius(), tie, same_share * field.finest(),
                 first, out);
  const auto is_beyond = [&](const ContactPoint& contact) { return !(contact.distance <= settings.margin); };
  out.resize(first + static_cast<std::size_t>(
                         std::remove_if(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(), is_beyond) -
                         (out.begin() + static_cast<std::ptrdiff_t>(first))),
             ContactPoint{});
  number_apart(std::span(out).subspan(first));
  return Outcome::ok;
}

}  // namespace abut
