// SPDX-License-Identifier: Apache-2.0
// Asks the kernel of the route of two types of shapes. Knows no shape by name.
export module abut.pairs.rows.by_route;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.convex;
import abut.narrow.field.field_contacts;
import abut.narrow.field.field_surfaces;
import abut.narrow.walls.half_space;
import abut.narrow.walls.hole_surfaces;
import abut.narrow.parts.nearest_of_parts;
import abut.narrow.two_surfaces;
import abut.pairs.routes;

export namespace abut {

template <Scattered A, class B>
[[nodiscard]] Outcome scattered_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                         Distance& out);
template <Scattered A, class B>
[[nodiscard]] Outcome scattered_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                         Manifold& out);

template <class A, class B>
[[nodiscard]] [[gnu::always_inline]] inline Outcome distance_by_route(const A& a, const B& b, const Pose& ab,
                                                                      const QuerySettings& settings, Distance& out) {
  constexpr Route way = route<A, B>();
  if constexpr (way == Route::unsupported) {
    return Outcome::unsupported;
  } else if constexpr (is_flipped<A, B>()) {
    const Outcome outcome = distance_by_route(b, a, ab.inverse(), settings, out);
    move_by(out, ab, true);
    return outcome;
  } else if constexpr (way == Route::half_space) {
    return half_space_distance(a, b, ab, settings, out);
  } else if constexpr (way == Route::half_space_of_parts) {
    return half_space_parts_distance(a, b, ab, settings, out);
  } else if constexpr (way == Route::convex) {
    return convex_distance(a, b, ab, settings, out);
  } else if constexpr (way == Route::parts) {
    return parts_distance(a, b, ab, settings, out);
  } else if constexpr (way == Route::scattered) {
    return scattered_distance(a, b, ab, settings, out);
  } else if constexpr (way == Route::hole) {
    return hole_distance(a, b, ab, settings, out);
  } else if constexpr (way == Route::hole_and_parts) {
    return hole_parts_distance(a, b, ab, settings, out);
  } else if constexpr (way == Route::hole_of_samples) {
    return hole_field_distance(a, b, ab, settings, out);
  } else if constexpr (way == Route::sampled) {
    return field_distance(a, b, ab, settings, out);
  } else if constexpr (way == Route::sampled_and_parts) {
    return field_parts_distance(a, b, ab, settings, out);
  } else if constexpr (way == Route::sampled_both) {
    return two_fields_distance(a, b, ab, settings, out);
  } else if constexpr (way == Route::half_space_of_samples) {
    return half_space_field_distance(a, b, ab, settings, out);
  } else {
    return surfaces_distance(a, b, ab, settings, out);
  }
}

template <class A, class B>
[[nodiscard]] [[gnu::noinline]] Outcome contacts_by_route(const A& a, const B& b, const Pose& ab,
                                                          const QuerySettings& settings, Manifold& out) {
  constexpr Route way = route<A, B>();
  if constexpr (way == Route::unsupported) {
    return Outcome::unsupported;
  } else if constexpr (is_flipped<A, B>()) {
    const std::size_t first = out.size();
    const Outcome outcome = contacts_by_route(b, a, ab.inverse(), settings, out);
    for (ContactPoint& contact : std::span(out).subspan(first)) {
      move_by(contact, ab, true);
    }
    return outcome;
  } else if constexpr (way == Route::half_space) {
    return half_space_contacts(a, b, ab, settings, out);
  } else if constexpr (way == Route::half_space_of_parts) {
    return half_space_parts_contacts(a, b, ab, settings, out);
  } else if constexpr (way == Route::convex) {
    return convex_contacts(a, b, ab, settings, out);
  } else if constexpr (way == Route::parts) {
    return parts_contacts(a, b, ab, settings, out);
  } else if constexpr (way == Route::scattered) {
    return scattered_contacts(a, b, ab, settings, out);
  } else if constexpr (way == Route::hole) {
    return hole_contacts(a, b, ab, settings, out);
  } else if constexpr (way == Route::hole_and_parts) {
    return hole_parts_contacts(a, b, ab, settings, out);
  } else if constexpr (way == Route::hole_of_samples) {
    return hole_field_contacts(a, b, ab, settings, out);
  } else if constexpr (way == Route::sampled) {
    return field_contacts(a, b, ab, settings, out);
  } else if constexpr (way == Route::sampled_and_parts) {
    return field_parts_contacts(a, b, ab, settings, out);
  } else if constexpr (way == Route::sampled_both) {
    return two_fields_contacts(a, b, ab, settings, out);
  } else if constexpr (way == Route::half_space_of_samples) {
    return half_space_field_contacts(a, b, ab, settings, out);
  } else {
    return surfaces_contacts(a, b, ab, settings, out);
  }
}

// Where a shape may be met. A hole alone stands for all that is around its cavity.
template <class B>
[[nodiscard]] Aabb reach_of(const B& b, const Pose& ab) {
  if constexpr (Hole<B>) {
    return Aabb::everything();
  } else {
    return b.aabb(ab);
  }
}

// The nearest or deepest of many solids, one after the other; the box of interest shrinks with every better one. What
// overlaps a surface leaves it together.
template <Scattered A, class B>
Outcome scattered_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Distance& out) {
  const Aabb around = reach_of(b, ab);
  const bool bounded = around.is_bounded();
  Aabb query = around;
  out = no_distance();
  Outcome outcome = Outcome::ok;
  const auto consider = [&](const Vec3& place, std::uint32_t index) {
    Distance found{};
    const Pose from_part{ab.rotation, ab.position - place};
    if (const Outcome one = distance_by_route(core_of(a.part(index)), b, from_part, settings, found);
        one != Outcome::ok) {
      outcome = one;
      return;
    }
    found.point_a += place;
    found.point_b += place;
    if (take_part(found, out) && bounded) {
      query = around.inflated(std::max(out.distance, Real{0}));
    }
  };
  if (bounded) {
    const std::uint32_t first = a.place_near(around.centre());
    consider(a.place(first), first);
  }
  a.visit_places(query, consider);
  if constexpr (Surface<B>) {
    if (outcome == Outcome::ok && out.distance < 0) {
      Distance whole{};
      if (depth_of_particles(a, ab.inverse(), b, -out.distance, settings, whole)) {
        out = whole;
        move_by(out, ab, true);
      }
    }
  }
  return outcome;
}

// Of the contacts from `first` on: the deepest of each direction, and of those the three deepest.
inline void keep_deepest_of_directions(Manifold& contacts, std::size_t first) {
  constexpr Real same_direction = 0.98;
  constexpr std::size_t most = 3;
  std::ranges::sort(std::span(contacts).subspan(first), [](const ContactPoint& a, const ContactPoint& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
  });
  std::size_t kept = first;
  for (std::size_t i = first; i < contacts.size() && kept - first < most; ++i) {
    const auto before = std::span(contacts).subspan(first, kept - first);
    if (std::ranges::none_of(
            before, [&](const ContactPoint& k) { return dot(k.normal, contacts[i].normal) > same_direction; })) {
      contacts[kept] = contacts[i];
      ++kept;
    }
  }
  contacts.resize(kept, ContactPoint{});
}

// Contacts of each solid by itself; against a surface those of at most three directions.
template <Scattered A, class B>
Outcome scattered_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Manifold& out) {
  Aabb query = reach_of(b, ab).inflated(std::max(settings.margin, Real{0}));
  Outcome outcome = Outcome::ok;
  a.visit_places(query, [&](const Vec3& place, std::uint32_t index) {
    const std::size_t first = out.size();
    const Pose from_part{ab.rotation, ab.position - place};
    const Outcome one = contacts_by_route(core_of(a.part(index)), b, from_part, settings, out);
    outcome = one == Outcome::ok ? outcome : one;
    if constexpr (Surface<B>) {
      keep_deepest_of_directions(out, first);
    }
    for (ContactPoint& contact : std::span(out).subspan(first)) {
      contact.point_a += place;
      contact.point_b += place;
      name_particle_a(contact, index);
    }
  });
  return outcome;
}

}  // namespace abut
