// SPDX-License-Identifier: Apache-2.0
// The kernels of all pairs of the shapes of a registry, which fill the rows of its table. Knows no shape by name.
//
// Closed forms are inlined into each cell of the table. Loading a whole vector right after writing its fields stalls
// the processor, so values between the parts of such a query stay in registers. Searches take much longer: they are
// compiled once for each pair of cores, and their rare branches once for all.
export module abut.pairs.rows.dispatch;
import abut.core.standard;
import abut.core;
import abut.narrow.cast.box_cast;
import abut.narrow.cast.cast_parts;
import abut.narrow.cast.cast_search;
import abut.narrow.cast.parts_in_order;
export import abut.pairs.rows.by_route;
import abut.math;
import abut.narrow.convex.placed_pair;
import abut.narrow.convex;
import abut.narrow.walls.half_space;
import abut.narrow.points.lane_contact;
import abut.narrow.warm.convex_memory;
import abut.narrow.warm.pair_memory;
import abut.pairs.rows.from_hint;
import abut.pairs.rows.search_names;
export import abut.pairs.table;
import abut.capability;

export namespace abut {

// Once for each pair of cores.
template <class A, class B>
[[nodiscard]] [[gnu::noinline]] Outcome distance_of_cores(const A& a, const B& b, const Pose& ab,
                                                          const QuerySettings& settings, Distance& out) {
  return distance_by_route(a, b, ab, settings, out);
}

// Where closed forms have no answer, or the route is another one: in the frame of the first shape.
template <class Any, class A, class B>
[[nodiscard]] Outcome distance_in_frame(const Any& a, const Any& b, const Pose& ab, const QuerySettings& settings,
                                        Distance& out) {
  const auto& core_a = core_of(std::get<A>(a));
  const auto& core_b = core_of(std::get<B>(b));
  if constexpr (route<A, B>() == Route::convex) {
    return convex_distance_by_search(core_a, core_b, ab, settings, out);
  } else {
    return distance_of_cores(core_a, core_b, ab, settings, out);
  }
}

template <class Any>
using DistanceInFrame = Outcome (*)(const Any& a, const Any& b, const Pose& ab, const QuerySettings& settings,
                                    Distance& out);

// From a kernel that answers in the frame of the first shape to the world. Out of line: a function that only takes
// closed forms is entered at less cost. Not duplicated: the compiler would make a copy for each kernel.
template <class Any>
[[nodiscard]] [[gnu::noinline, clang::noduplicate]] Outcome placed_distance(DistanceInFrame<Any> kernel, const Any& a,
                                                                            const Any& b, const Pose& pose_a,
                                                                            const Pose& pose_b, bool swapped,
                                                                            const QuerySettings& settings,
                                                                            Distance& out) {
  const Pose ab = relative(pose_a, pose_b);
  [[clang::uninitialized]] Distance found;
  const Outcome outcome = kernel(a, b, ab, settings, found);
  if (outcome == Outcome::ok) [[likely]] {
    move_by(found, pose_a, swapped);
    out = found;
  }
  return outcome;
}

template <class Any, class A, class B>
[[nodiscard]] Outcome distance_kernel(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                                      const QuerySettings& settings, Distance& out) {
  if constexpr (route<A, B>() == Route::convex && have_closed_form<CoreOf<A>, CoreOf<B>>) {
    if (distance_of_placed(core_of(std::get<A>(a)), core_of(std::get<B>(b)), pose_a, pose_b, swapped, settings, out))
        [[likely]] {
      return Outcome::ok;
    }
  }
  return placed_distance<Any>(distance_in_frame<Any, A, B>, a, b, pose_a, pose_b, swapped, settings, out);
}

template <class A, class B>
[[nodiscard]] consteval bool gains_from_memory() {
  if constexpr (route<A, B>() == Route::convex) {
    return is_remembered<CoreOf<A>, CoreOf<B>>;
  } else {
    return false;
  }
}

// Once for each pair of cores.
template <class A, class B>
[[nodiscard]] [[gnu::noinline]] Outcome contacts_and_memory(const A& a, const B& b, const Pose& ab,
                                                            const QuerySettings& settings, PairMemory& memory,
                                                            Manifold& out) {
  return convex_contacts(a, b, ab, settings, memory, out);
}

template <class Any, class A, class B>
[[nodiscard]] Outcome contacts_in_frame(const Any& a, const Any& b, const Pose& ab, const QuerySettings& settings,
                                        [[maybe_unused]] PairMemory* memory, Manifold& out) {
  const auto& core_a = core_of(std::get<A>(a));
  const auto& core_b = core_of(std::get<B>(b));
  if constexpr (gains_from_memory<A, B>()) {
    return memory != nullptr ? contacts_and_memory(core_a, core_b, ab, settings, *memory, out)
                             : convex_contacts(core_a, core_b, ab, settings, out);
  } else {
    return contacts_by_route(core_a, core_b, ab, settings, out);
  }
}

// Where closed forms have been tried.
template <class Any, class A, class B>
[[nodiscard]] Outcome contacts_by_search(const Any& a, const Any& b, const Pose& ab, const QuerySettings& settings,
                                         PairMemory*, Manifold& out) {
  return convex_contacts_by_search(core_of(std::get<A>(a)), core_of(std::get<B>(b)), ab, settings, out);
}

template <class Any>
using ContactsInFrame = decltype(PairKernels<Any>::contacts_in_frame);

// As with distances.
template <class Any>
[[nodiscard]] [[gnu::noinline, clang::noduplicate]] Outcome placed_contacts(ContactsInFrame<Any> kernel, const Any& a,
                                                                            const Any& b, const Pose& pose_a,
                                                                            const Pose& pose_b, bool swapped,
                                                                            const QuerySettings& settings,
                                                                            Manifold& out) {
  const std::size_t first = out.size();
  const Outcome outcome = kernel(a, b, relative(pose_a, pose_b), settings, nullptr, out);
  place_contacts(std::span(out).subspan(first), pose_a, {swapped, a.index() == b.index()});
  return outcome;
}

template <class Any, class A, class B>
[[nodiscard]] Outcome contacts_kernel(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                                      const QuerySettings& settings, Manifold& out) {
  [[maybe_unused]] const auto& core_a = core_of(std::get<A>(a));
  [[maybe_unused]] const auto& core_b = core_of(std::get<B>(b));
  if constexpr (route<A, B>() == Route::half_space) {
    const auto append = [&](const LaneContact& contact) {
      append_contact(with_sides(contact, swapped != is_flipped<A, B>()), out);
    };
    if constexpr (is_flipped<A, B>()) {
      return half_space_contacts(core_b, core_a, pose_b, pose_a, settings, append);
    } else {
      return half_space_contacts(core_a, core_b, pose_a, pose_b, settings, append);
    }
  } else if constexpr (route<A, B>() == Route::convex && have_closed_contacts<CoreOf<A>, CoreOf<B>>) {
    const auto append = [&](const LaneContact& contact) {
      LaneContact given = with_sides(contact, swapped);
      if constexpr (std::is_same_v<A, B>) {
        given.id = contact_id(given.feature_a, given.feature_b);
      }
      append_contact(given, out);
    };
    if (contacts_of_placed(core_a, core_b, pose_a, pose_b, settings, append)) [[likely]] {
      return Outcome::ok;
    }
    return placed_contacts<Any>(contacts_by_search<Any, A, B>, a, b, pose_a, pose_b, swapped, settings, out);
  } else {
    return placed_contacts<Any>(contacts_in_frame<Any, A, B>, a, b, pose_a, pose_b, swapped, settings, out);
  }
}

template <class Any, class A, class B>
void cast_parts_kernel(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                       const CastNames& names, CastSearch& search) {
  if constexpr (are_boxes<A, B>) {
    cast_boxes(search, std::get<A>(a), std::get<B>(b), relative(pose_a, pose_b), search.motion_in(pose_a, swapped),
               pose_a, swapped, names);
  } else if constexpr (Surface<A> && Surface<B>) {
    cast_surfaces(search, std::get<A>(a), std::get<B>(b), relative(pose_a, pose_b), search.motion_in(pose_a, swapped),
                  pose_a, swapped, names);
  } else if constexpr (has_parts<A>) {
    cast_parts(search, std::get<A>(a), core_of(std::get<B>(b)), relative(pose_a, pose_b),
               search.motion_in(pose_a, swapped), pose_a, swapped, names);
  } else {
    cast_parts(search, std::get<B>(b), core_of(std::get<A>(a)), relative(pose_b, pose_a),
               search.motion_in(pose_b, !swapped), pose_b, !swapped, names);
  }
}

template <class Any, class A, class B>
[[nodiscard]] consteval auto cast_parts_of() -> decltype(PairKernels<Any>::cast_parts) {
  constexpr bool have_parts = has_parts<A> || has_parts<B>, have_others = Convex<A> || Convex<B>;
  constexpr bool are_parts = have_parts && (have_others || (has_parts<A> && has_parts<B>));
  if constexpr (route<A, B>() != Route::unsupported && (are_parts || are_boxes<A, B>)) {
    return cast_parts_kernel<Any, A, B>;
  } else {
    return nullptr;
  }
}

template <class A, class B>
[[nodiscard]] std::string_view name_searches_kernel() {
  constexpr std::string_view name = name_algorithm<CoreOf<A>, CoreOf<B>>();
  return name;
}

// Pairs of which a side holds shapes of any kind: only who knows the whole table can answer those, so their
// kernels are handed in.
template <class Any, class A, class B>
[[nodiscard]] consteval PairKernels<Any> make_kernels(const PairKernels<Any>& by_children) {
  if constexpr (route<A, B>() == Route::children) {
    return by_children;
  } else {
    return {route<A, B>(),
            is_flipped<A, B>(),
            distance_kernel<Any, A, B>,
            contacts_kernel<Any, A, B>,
            contacts_in_frame<Any, A, B>,
            gains_from_memory<A, B>(),
            cast_parts_of<Any, A, B>(),
            name_searches_kernel<A, B>,
            distance_from_hint_of<Any, A, B>()};
  }
}

// The cells (Row, Row), (Row, Row + 1), ... of the table; those below the diagonal stay empty, since a
// pair is always looked up in the order of the registry.
template <class Shapes, std::size_t Row>
[[nodiscard]] consteval std::array<PairKernels<typename Shapes::Any>, Shapes::count> make_row(
    const PairKernels<typename Shapes::Any>& by_children) {
  using Any = typename Shapes::Any;
  std::array<PairKernels<Any>, Shapes::count> row{};
  [&]<std::size_t... Offsets>(std::index_sequence<Offsets...>) {
    ((row[Row + Offsets] =
          make_kernels<Any, typename Shapes::template At<Row>, typename Shapes::template At<Row + Offsets>>(
              by_children)),
     ...);
  }(std::make_index_sequence<Shapes::count - Row>{});
  return row;
}

}  // namespace abut
