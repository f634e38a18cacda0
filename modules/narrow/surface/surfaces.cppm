// SPDX-License-Identifier: Apache-2.0
// Surfaces: a mesh or a height field against convex shapes, triangle by triangle.
export module abut.narrow.surface.surfaces;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.convex;
import abut.narrow.surface.flat_ground;
export import abut.narrow.walls.half_space_surfaces;
import abut.narrow.parts.nearest_of_parts;
import abut.narrow.triangle.quick_axes;
import abut.narrow.surface.surface_kernels;
import abut.narrow.triangle.triangle_contacts;
import abut.narrow.surface.triangle_source;

export namespace abut {

[[nodiscard]] inline bool parts_support(Algorithm algorithm) {
  return algorithm == Algorithm::automatic || algorithm == Algorithm::gjk_epa;
}

[[nodiscard]] inline QuerySettings without_margin(const QuerySettings& settings) {
  return {.algorithm = settings.algorithm, .error_bound = settings.error_bound};
}

// Takes a part where it is nearer or deeper than the best so far. Whether it was.
template <Convex B>
bool take_nearer(const Triangle& part, const B& b, const Pose& ab, const QuerySettings& settings, Distance& best) {
  CoreSeparation core = separate_from_triangle(part, b, ab, settings, best.distance + b.radius());
  if (core.beyond) {
    best.iterations += core.iterations;
    return false;
  }
  if (core.distance - b.radius() < best.distance) {
    find_points(part, b, ab, core);
  }
  return take_part(rounded(core, 0, b.radius()), best);
}

// Distance of a surface and a convex shape: of the nearest or deepest part, each as a sheet. Starts
// from a part near the shape and shrinks the box that is still of interest with every better one. Whether a part is
// nearer than `best` was; if so, `nearest` is its number.
template <Surface A, Convex B>
bool nearest_part(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Distance& best,
                  std::uint32_t& nearest) {
  const Aabb around = b.aabb(ab);
  const QuickAxes<B> axes(b, ab);
  const InFours may_be_nearer{
      [&](const FourTriangles& triangles) { return axes.near(triangles, best.distance + b.radius()); }};
  bool is_found = false;
  const auto consider = [&](const typename A::Part& part) {
    if (take_nearer(part, b, ab, settings, best)) {
      nearest = part.index();
      is_found = true;
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

template <Convex B>
void contacts_on_surface(const TriangleSource& surface, const B& b, const Pose& ab, const QuerySettings& settings,
                         Manifold& out) {
  if (!flat_contacts(surface, b, ab, settings, out)) {
    surface_contacts(surface, core_of(b), ab, settings, out);
  }
}

template <Surface A, Convex B>
[[nodiscard]] Outcome parts_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                     Manifold& out) {
  if (!parts_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  contacts_on_surface(SourceOf<A>(a), b, ab, settings, out);
  return Outcome::ok;
}

// A triangle by itself may have a way out that leads into a neighbour, or through a front. Contacts know better. What a
// round shape meets from behind has none, and may be deeper.
inline void take_depth_of(const Manifold& contacts, Real noise, Distance& out) {
  if (contacts.empty()) {
    return;
  }
  const ContactPoint& deepest = *std::ranges::min_element(contacts, {}, &ContactPoint::distance);
  if (deepest.distance > out.distance + noise) {
    return;
  }
  out.distance = deepest.distance;
  out.lower = deepest.distance - noise;
  out.upper = deepest.distance + noise;
  out.normal = deepest.normal;
  out.point_a = deepest.point_a;
  out.point_b = deepest.point_b;
}

template <Surface A, Convex B>
[[nodiscard]] Outcome parts_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                     Distance& out) {
  if (!parts_support(settings.algorithm)) {
    return Outcome::unsupported;
  }
  const SourceOf<A> surface(a);
  if (flat_distance(surface, b, ab, settings, out) || surface_depth(surface, core_of(b), ab, settings, out)) {
    return Outcome::ok;
  }
  out = no_distance();
  std::uint32_t nearest = 0;
  nearest_part(a, b, ab, settings, out, nearest);
  const Triangle triangle = a.part(nearest);
  const Real noise = noise_of(core_size(triangle, b, ab));
  // What only touches a front from behind is not pushed through it.
  const bool is_before = Fronts<B>(triangle, b, ab).allows(out.normal) ||
                         dot(triangle.normal(), placed_centre(b, ab) - triangle.corners()[0]) >= 0;
  if (std::fabs(out.distance) <= noise && is_before) {
    Manifold contacts;
    static_cast<void>(parts_contacts(a, b, ab, without_margin(settings), contacts));
    take_depth_of(contacts, noise, out);
  }
  return Outcome::ok;
}

}  // namespace abut
