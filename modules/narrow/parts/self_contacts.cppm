// SPDX-License-Identifier: Apache-2.0
// A shape against itself: the solids or triangles that it is made of, each pair of them once.
export module abut.narrow.parts.self_contacts;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.convex;

export namespace abut {

// Neighbours of a mesh always touch. Corners are compared by place, as a mesh may have equal vertices.
[[nodiscard]] inline bool have_common_corner(const Triangle& a, const Triangle& b) {
  return std::ranges::any_of(
      a.corners(), [&](const Vec3& corner) { return std::ranges::find(b.corners(), corner) != b.corners().end(); });
}

// Two of many solids. Contacts name their numbers.
template <Scattered A>
[[nodiscard]] Outcome contacts_of_two(const A& a, std::uint32_t low, const Vec3& place, std::uint32_t high,
                                      const Vec3& other_place, const QuerySettings& settings, Manifold& out) {
  const std::size_t first = out.size();
  const Outcome outcome = convex_contacts(core_of(a.part(low)), core_of(a.part(high)),
                                          {Rotation::identity(), other_place - place}, settings, out);
  for (ContactPoint& contact : std::span(out).subspan(first)) {
    contact.point_a += place;
    contact.point_b += place;
    contact.child_b = high;
    contact.feature_b = {FeatureKind::particle, high};
    name_particle_a(contact, low);
  }
  return outcome;
}

template <Scattered A>
[[nodiscard]] Outcome self_contacts(const A& a, const QuerySettings& settings, Manifold& out) {
  Outcome outcome = Outcome::ok;
  a.visit_pairs(std::max(settings.margin, Real{0}),
                [&](std::uint32_t low, const Vec3& place, std::uint32_t high, const Vec3& other_place) {
                  const Outcome one = contacts_of_two(a, low, place, high, other_place, settings, out);
                  outcome = one == Outcome::ok ? outcome : one;
                });
  return outcome;
}

// Two triangles of one surface. Both sides of each count, as either may have been passed through.
[[nodiscard]] inline Outcome contacts_of_two(const Triangle& a, const Triangle& b, const QuerySettings& settings,
                                             Manifold& out) {
  const std::size_t first = out.size();
  const Outcome outcome = convex_contacts(a, b, Pose::identity(), settings, out);
  for (ContactPoint& contact : std::span(out).subspan(first)) {
    contact.feature_a = {FeatureKind::face, a.index()};
    contact.feature_b = {FeatureKind::face, b.index()};
    contact.id = contact_id_of_part(contact_id_of_part(contact.id, a.index()), b.index());
  }
  return outcome;
}

template <Surface A>
[[nodiscard]] Outcome self_contacts(const A& a, const QuerySettings& settings, Manifold& out) {
  Outcome outcome = Outcome::ok;
  Aabb everything = Aabb::everything();
  a.visit_parts(everything, [&](const Triangle& triangle, std::uint32_t index) {
    Aabb near = triangle.box().inflated(std::max(settings.margin, Real{0}));
    a.visit_parts(near, [&](const Triangle& other, std::uint32_t other_index) {
      if (other_index > index && !have_common_corner(triangle, other)) {
        const Outcome one = contacts_of_two(triangle, other, settings, out);
        outcome = one == Outcome::ok ? outcome : one;
      }
    });
  });
  return outcome;
}

}  // namespace abut
