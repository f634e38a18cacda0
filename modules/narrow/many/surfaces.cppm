// SPDX-License-Identifier: Apache-2.0
// Surfaces: a mesh or a height field against anything, triangle by triangle.
export module abut.narrow.many.surfaces;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.convex;
import abut.narrow.many.half_space;
import abut.narrow.many.nearest_of_parts;
import abut.narrow.many.quick_axes;
import abut.narrow.many.surface_contacts;
import abut.narrow.many.triangle_contacts;

export namespace abut {

[[nodiscard]] inline bool parts_support(Algorithm algorithm) {
  return algorithm == Algorithm::automatic || algorithm == Algorithm::gjk_epa;
}

// Distance of a surface and a convex shape: of the nearest or deepest part, each as a sheet. Starts
// from a part near the shape and shrinks the box that is still of interest with every better one.
template <Surface A, Convex B>
void nearest_part(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Distance& best) {
  const Aabb around = b.aabb(ab);
  const QuickAxes<B> axes(b, ab);
  const auto may_be_nearer = [&](const TriangleCorners& corners) {
    return !axes.are_beyond(corners, best.distance + b.radius());
  };
  const auto consider = [&](const typename A::Part& part) {
    CoreSeparation core = separate_from_triangle(part, b, ab, settings, best.distance + b.radius());
    if (core.beyond) {
      best.iterations += core.iterations;
    } else {
      if (core.distance - b.radius() < best.distance) {
        find_points(part, b, ab, core);
      }
      take_part(rounded(core, 0, b.radius()), best);
    }
  };
  const auto start = a.part_near(placed_centre(b, ab));
  consider(start);
  Aabb query = best.distance < infinity ? around.inflated(std::max(best.distance, Real{0})) : Aabb::everything();
  a.visit_parts(query, may_be_nearer, [&](const typename A::Part& part, std::uint32_t index) {
    if (index != start.index()) {
      consider(part);
      query = best.distance < infinity ? around.inflated(std::max(best.distance, Real{0})) : query;
    }
  });
}

template <Surface A, Convex B>
[[nodiscard]] Outcome parts_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                     Distance& out) {
  if (!parts_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  out = no_distance();
  nearest_part(a, b, ab, settings, out);
  return Outcome::ok;
}

template <Surface A, Convex B>
[[nodiscard]] Outcome parts_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                     Manifold& out) {
  if (!parts_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  SurfaceContacts<A, B> contacts(a, b, ab, settings, out);
  Aabb query = b.aabb(ab).inflated(std::max(settings.margin, Real{0}));
  const QuickAxes<B> axes(b, ab);
  a.visit_parts(
      query, [&](const TriangleCorners& corners) { return !axes.are_beyond(corners, settings.margin + b.radius()); },
      [&](const typename A::Part& part, std::uint32_t) { contacts.add(part, b, 0); });
  contacts.finish();
  return Outcome::ok;
}

// Two surfaces: the parts of b one by one, each a convex shape to a.
template <Surface A, Surface B>
[[nodiscard]] Outcome surfaces_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                        Distance& out) {
  if (!parts_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  out = no_distance();
  const Aabb around = a.aabb(ab.inverse());
  nearest_part(a, b.part_near(around.centre()), ab, settings, out);
  Aabb query = out.distance < infinity ? around.inflated(std::max(out.distance, Real{0})) : Aabb::everything();
  b.visit_parts(query, [&](const typename B::Part& part, std::uint32_t) {
    nearest_part(a, part, ab, settings, out);
    query = around.inflated(std::max(out.distance, Real{0}));
  });
  return Outcome::ok;
}

template <Surface A, Surface B>
[[nodiscard]] Outcome surfaces_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                        Manifold& out) {
  if (!parts_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  SurfaceContacts<A, B> contacts(a, b, ab, settings, out);
  Aabb query = a.aabb(ab.inverse()).inflated(std::max(settings.margin, Real{0}));
  b.visit_parts(query, [&](const typename B::Part& part, std::uint32_t index) {
    Aabb box = part.aabb(ab).inflated(std::max(settings.margin, Real{0}));
    const QuickAxes<typename B::Part> axes(part, ab);
    a.visit_parts(
        box, [&](const TriangleCorners& corners) { return !axes.are_beyond(corners, settings.margin); },
        [&](const typename A::Part& other, std::uint32_t) { contacts.add(other, part, index); });
  });
  contacts.finish();
  return Outcome::ok;
}

// A half-space against every part: what lies behind the plane counts.
template <HalfSpace A, Surface B>
[[nodiscard]] Outcome half_space_parts_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                                Distance& out) {
  out = no_distance();
  Aabb everything = Aabb::everything();
  Outcome outcome = Outcome::ok;
  b.visit_parts(everything, [&](const typename B::Part& part, std::uint32_t) {
    Distance distance{};
    outcome = half_space_distance(a, part, ab, settings, distance);
    if (outcome == Outcome::ok) {
      take_part(distance, out);
    }
  });
  return outcome;
}

template <HalfSpace A, Surface B>
[[nodiscard]] Outcome half_space_parts_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                                Manifold& out) {
  Aabb everything = Aabb::everything();
  Outcome outcome = Outcome::ok;
  b.visit_parts(everything, [&](const typename B::Part& part, std::uint32_t index) {
    const std::size_t first = out.size();
    outcome = half_space_contacts(a, part, ab, settings, out);
    for (std::size_t i = first; i < out.size(); ++i) {
      out[i].id = contact_id_of_part(out[i].id, index);
      out[i].feature_b = {FeatureKind::face, index};
    }
  });
  return outcome;
}

}  // namespace abut
