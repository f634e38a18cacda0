// SPDX-License-Identifier: Apache-2.0
// Contacts of two convex shapes with what is remembered of the pair. Where the memory proves the answer no search is
// made; else the search is the same as without, and the memory keeps what it found.
export module abut.narrow.warm.convex_memory;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.convex;
import abut.narrow.points.clip;
export import abut.narrow.warm.pair_memory;
import abut.capability;
import abut.narrow.warm.proof;

export namespace abut {

// Pairs whose search takes so long that what is known of them before is worth a look. Closed forms are not.
template <class A, class B>
inline constexpr bool is_remembered = !have_closed_form<A, B>;

// The answer of a search, with what it leaves for the next time.
template <Convex A, Convex B>
[[nodiscard]] [[gnu::noinline]] Outcome convex_contacts_and_memory(const A& a, const B& b, const Pose& ab,
                                                                   const QuerySettings& settings, PairMemory& memory,
                                                                   Manifold& out) {
  const Real size = core_size(a, b, ab), error = error_of(a, b, size, settings);
  const Real radii = a.radius() + b.radius(), limit = settings.margin + radii;
  if (memory.state == PairMemory::State::apart && find_apart(a, b, ab, size, error, limit, memory)) {
    return Outcome::ok;
  }
  const CoreSeparation core = separate_for_contacts(a, b, ab, settings);
  if (core.beyond) {
    (void)find_apart(a, b, ab, size, error, limit, memory);
    return Outcome::ok;
  }
  if constexpr (are_featured<A, B>) {
    if (core.overlap) {
      keep_overlap(a, b, ab, settings, size, error, core, memory);
    }
  }
  if (core.distance - radii <= settings.margin) {
    contacts_under(a, b, ab, core, settings.margin, true, out);
  }
  return Outcome::ok;
}

// With what is known of the pair from before, which makes the answer no other one.
template <Convex A, Convex B>
[[nodiscard]] inline Outcome convex_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                             PairMemory& memory, Manifold& out) {
  if constexpr (!is_remembered<A, B>) {
    return convex_contacts(a, b, ab, settings, out);
  } else {
    if (settings.algorithm != Algorithm::automatic) {
      return convex_contacts(a, b, ab, settings, out);
    }
    const Real size = core_size(a, b, ab), error = error_of(a, b, size, settings);
    if (memory.state == PairMemory::State::apart) {
      if (is_still_apart(a, b, ab, size, error, settings.margin + (a.radius() + b.radius()), memory)) {
        return Outcome::ok;
      }
    } else if (memory.state >= PairMemory::State::touching) {
      if constexpr (are_featured<A, B>) {
        CoreSeparation core{};
        if (have_features(a, b, memory.features, noise_of(size)) &&
            overlap_along(a, b, ab, size, error, memory.features, core)) {
          [[clang::uninitialized]] const Face face_a = supporting_face(a, core.normal, core.features.a);
          [[clang::uninitialized]] const Face face_b = placed_face(b, ab, -core.normal, core.features.b);
          if (is_still_least(a, b, ab, size, error, core, face_a, face_b, memory)) {
            if (core.distance - (a.radius() + b.radius()) <= settings.margin) {
              contacts_between(a, b, ab, face_a, face_b, core, settings.margin, true, out);
            }
            return Outcome::ok;
          }
        }
      }
    }
    return convex_contacts_and_memory(a, b, ab, settings, memory, out);
  }
}

}  // namespace abut
