// SPDX-License-Identifier: Apache-2.0
// Surfaces: a mesh or a height field against anything, triangle by triangle.
export module abut.narrow.many.surfaces;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.convex;
import abut.narrow.many.half_space;
import abut.narrow.many.nearest_of_parts;
import abut.narrow.many.quick_axes;
import abut.narrow.many.surface_contacts;
import abut.narrow.many.triangle_contacts;
import abut.narrow.many.way_out;

export namespace abut {

[[nodiscard]] inline bool parts_support(Algorithm algorithm) {
  return algorithm == Algorithm::automatic || algorithm == Algorithm::gjk_epa;
}

[[nodiscard]] inline QuerySettings without_margin(const QuerySettings& settings) {
  return {.algorithm = settings.algorithm, .error_bound = settings.error_bound};
}

// Distance of a surface and a convex shape: of the nearest or deepest part, each as a sheet. Starts
// from a part near the shape and shrinks the box that is still of interest with every better one. Whether a part is
// nearer than `best` was; if so, `nearest` is its number.
template <Surface A, Convex B>
bool nearest_part(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Distance& best,
                  std::uint32_t& nearest) {
  const Aabb around = b.aabb(ab);
  const QuickAxes<B> axes(b, ab);
  const auto may_be_nearer = [&](const TriangleCorners& corners) {
    return !axes.are_beyond(corners, best.distance + b.radius());
  };
  bool is_found = false;
  const auto consider = [&](const typename A::Part& part) {
    CoreSeparation core = separate_from_triangle(part, b, ab, settings, best.distance + b.radius());
    if (core.beyond) {
      best.iterations += core.iterations;
    } else {
      if (core.distance - b.radius() < best.distance) {
        find_points(part, b, ab, core);
      }
      if (take_part(rounded(core, 0, b.radius()), best)) {
        nearest = part.index();
        is_found = true;
      }
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
  return is_found;
}

template <Surface A, Convex B>
[[nodiscard]] Outcome parts_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                     Manifold& out);
template <Surface A, Surface B>
[[nodiscard]] Outcome surfaces_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                        Manifold& out);

// A depth may be that of a triangle whose way out belongs to a neighbour. Contacts know better, where there are any.
inline void take_depth_of(const Manifold& contacts, Real noise, Distance& out) {
  if (contacts.empty()) {
    return;
  }
  const ContactPoint& deepest = *std::ranges::min_element(contacts, {}, &ContactPoint::distance);
  if (deepest.distance > out.distance) {
    out.distance = deepest.distance;
    out.lower = deepest.distance - noise;
    out.upper = deepest.distance + noise;
    out.normal = deepest.normal;
    out.point_a = deepest.point_a;
    out.point_b = deepest.point_b;
  }
}

template <Surface A, Convex B>
[[nodiscard]] Outcome parts_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                     Distance& out) {
  if (!parts_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  out = no_distance();
  std::uint32_t nearest = 0;
  nearest_part(a, b, ab, settings, out, nearest);
  const Triangle triangle = a.part(nearest);
  const Real noise = noise_of(core_size(triangle, b, ab));
  if (out.distance < -noise &&
      !leads_out_of_all(a, triangle, out.point_a, out.normal, noise, b.extent() + b.radius())) {
    Manifold contacts;
    static_cast<void>(parts_contacts(a, b, ab, without_margin(settings), contacts));
    take_depth_of(contacts, noise, out);
  }
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
  std::uint32_t of_a = 0, of_b = b.part_near(around.centre()).index();
  nearest_part(a, b.part(of_b), ab, settings, out, of_a);
  Aabb query = out.distance < infinity ? around.inflated(std::max(out.distance, Real{0})) : Aabb::everything();
  b.visit_parts(query, [&](const typename B::Part& part, std::uint32_t index) {
    of_b = nearest_part(a, part, ab, settings, out, of_a) ? index : of_b;
    query = around.inflated(std::max(out.distance, Real{0}));
  });
  const Triangle triangle = a.part(of_a), other = b.part(of_b);
  const Real noise = noise_of(core_size(triangle, other, ab));
  if (out.distance < -noise &&
      !(leads_out_of_all(a, triangle, out.point_a, out.normal, noise, infinity) &&
        leads_out_of_all(b, other, ab.undo(out.point_b), -ab.rotation.undo(out.normal), noise, infinity))) {
    Manifold contacts;
    static_cast<void>(surfaces_contacts(a, b, ab, without_margin(settings), contacts));
    take_depth_of(contacts, noise, out);
  }
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
