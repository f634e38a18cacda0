// The kernels of all pairs of the shapes of a registry, which fill the rows of its table. Knows no shape by name.
export module abut.pairs.rows.dispatch;
import abut.core.standard;
import abut.core;
import abut.narrow.cast.cast_parts;
import abut.narrow.cast.cast_search;
import abut.narrow.cast.parts_in_order;
export import abut.pairs.rows.by_route;
import abut.math;
import abut.narrow.convex.placed_pair;
import abut.narrow.convex;
import abut.narrow.many.half_space;
import abut.narrow.points.lane_contact;
import abut.narrow.warm.convex_memory;
import abut.narrow.warm.pair_memory;
import abut.pairs.rows.search_names;
export import abut.pairs.table;
import abut.capability;

export namespace abut {

// Where closed forms have no answer, or the route is another one. Out of line: a function that only takes closed forms
// is entered at less cost.
template <class A, class B>
[[nodiscard]] [[gnu::noinline]] Outcome distance_in_frame(const A& a, const B& b, const Pose& pose_a,
                                                          const Pose& pose_b, bool swapped,
                                                          const QuerySettings& settings, Distance& out) {
  const Pose ab = relative(pose_a, pose_b);
  [[clang::uninitialized]] Distance found;
  Outcome outcome{};
  if constexpr (route<A, B>() == Route::convex) {
    outcome = convex_distance_by_search(a, b, ab, settings, found);
  } else {
    outcome = distance_by_route(a, b, ab, settings, found);
  }
  if (outcome == Outcome::ok) [[likely]] {
    move_by(found, pose_a, swapped);
    out = found;
  }
  return outcome;
}

template <class Any, class A, class B>
[[nodiscard]] Outcome distance_kernel(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                                      const QuerySettings& settings, Distance& out) {
  const auto& core_a = core_of(std::get<A>(a));
  const auto& core_b = core_of(std::get<B>(b));
  if constexpr (route<A, B>() == Route::convex && ClosedForm<CoreOf<A>, CoreOf<B>>) {
    if (distance_of_placed(core_a, core_b, pose_a, pose_b, swapped, settings, out)) [[likely]] {
      return Outcome::ok;
    }
  }
  return distance_in_frame(core_a, core_b, pose_a, pose_b, swapped, settings, out);
}

// Numbers of contacts tell the features in the order in which the shapes are given.
inline void number_in_order_given(std::span<ContactPoint> contacts) {
  for (ContactPoint& contact : contacts) {
    std::uint64_t found = contact_id(contact.feature_b, contact.feature_a);
    std::uint64_t given = contact_id(contact.feature_a, contact.feature_b);
    for (int repeat = 0; repeat < 2; ++repeat, found = mixed(found), given = mixed(given)) {
      if (contact.id == found) {
        contact.id = given;
        break;
      }
    }
  }
}

// The order in which two shapes are given. Which of two shapes of one kind comes first may change as they move.
struct GivenOrder {
  bool is_swapped, is_of_one_kind;
};

// Contacts from the frame of the first shape to the world.
inline void place_contacts(std::span<ContactPoint> contacts, const Pose& pose_a, const GivenOrder& order) {
  for (ContactPoint& contact : contacts) {
    move_by(contact, pose_a, order.is_swapped);
  }
  if (order.is_of_one_kind && order.is_swapped) {
    number_in_order_given(contacts);
  }
}

template <class A, class B>
[[nodiscard]] [[gnu::noinline]] Outcome contacts_in_frame(const A& a, const B& b, const Pose& pose_a,
                                                          const Pose& pose_b, const GivenOrder& order,
                                                          const QuerySettings& settings, Manifold& out) {
  const std::size_t first = out.size();
  const Pose ab = relative(pose_a, pose_b);
  Outcome outcome{};
  if constexpr (route<A, B>() == Route::convex) {
    outcome = convex_contacts_by_search(a, b, ab, settings, out);
  } else {
    outcome = contacts_by_route(a, b, ab, settings, out);
  }
  place_contacts(std::span(out).subspan(first), pose_a, order);
  return outcome;
}

template <class Any, class A, class B>
[[nodiscard]] Outcome contacts_kernel(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                                      const QuerySettings& settings, Manifold& out) {
  const auto& core_a = core_of(std::get<A>(a));
  const auto& core_b = core_of(std::get<B>(b));
  if constexpr (route<A, B>() == Route::half_space) {
    const auto append = [&](const LaneContact& contact) {
      append_contact(with_sides(contact, swapped != is_flipped<A, B>()), out);
    };
    if constexpr (is_flipped<A, B>()) {
      return half_space_contacts(core_b, core_a, pose_b, pose_a, settings, append);
    } else {
      return half_space_contacts(core_a, core_b, pose_a, pose_b, settings, append);
    }
  } else {
    if constexpr (route<A, B>() == Route::convex && ClosedContacts<CoreOf<A>, CoreOf<B>>) {
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
    }
    return contacts_in_frame(core_a, core_b, pose_a, pose_b, {swapped, std::is_same_v<A, B>}, settings, out);
  }
}

template <class A, class B>
[[nodiscard]] consteval bool gains_from_memory() {
  if constexpr (route<A, B>() == Route::convex) {
    return Remembered<CoreOf<A>, CoreOf<B>>;
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
[[nodiscard]] Outcome contacts_with_memory_kernel(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b,
                                                  bool swapped, const QuerySettings& settings,
                                                  [[maybe_unused]] PairMemory& memory, Manifold& out) {
  if constexpr (gains_from_memory<A, B>()) {
    const std::size_t first = out.size();
    const Outcome outcome = contacts_and_memory(core_of(std::get<A>(a)), core_of(std::get<B>(b)),
                                                relative(pose_a, pose_b), settings, memory, out);
    place_contacts(std::span(out).subspan(first), pose_a, {swapped, std::is_same_v<A, B>});
    return outcome;
  } else {
    return contacts_kernel<Any, A, B>(a, b, pose_a, pose_b, swapped, settings, out);
  }
}

template <class A, class B>
[[nodiscard]] [[gnu::always_inline]] inline Outcome contacts_of_job(const A& a, const B& b, const Pose& ab,
                                                                    const QuerySettings& settings, std::uint32_t place,
                                                                    std::span<PairMemory> memories, Manifold& out) {
  if constexpr (gains_from_memory<A, B>()) {
    if (place != no_memory) {
      return contacts_and_memory(a, b, ab, settings, memories[place], out);
    }
  }
  return contacts_by_route(a, b, ab, settings, out);
}

template <class Any, class A, class B>
void contacts_of_run_kernel(std::span<const Frozen<Any>> shapes, std::span<const Pose> poses,
                            std::span<const PairJob> jobs, const QuerySettings& common, std::span<PairMemory> memories,
                            Manifold& out, std::span<PairResult> results) {
  QuerySettings settings = common;
  // Poses and memories of the pairs of a run lie anywhere.
  constexpr std::size_t ahead = 4;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (i + ahead < jobs.size()) {
      const PairJob& next = jobs[i + ahead];
      __builtin_prefetch(&poses[next.a].rotation);
      __builtin_prefetch(&poses[next.a].position);
      __builtin_prefetch(&poses[next.b].rotation);
      __builtin_prefetch(&poses[next.b].position);
      if constexpr (gains_from_memory<A, B>()) {
        if (next.memory != no_memory) {
          __builtin_prefetch(&memories[next.memory]);
        }
      }
    }
    const PairJob& job = jobs[i];
    settings.margin = job.margin;
    const Outcome outcome = contacts_of_job(core_of(std::get<A>(*shapes[job.a])), core_of(std::get<B>(*shapes[job.b])),
                                            relative(poses[job.a], poses[job.b]), settings, job.memory, memories, out);
    results[i] = {static_cast<std::uint32_t>(out.size()), outcome};
  }
}

template <class Any, class A, class B>
void cast_parts_kernel(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                       const CastNames& names, CastSearch& search) {
  if constexpr (HasParts<A>) {
    cast_parts(search, std::get<A>(a), core_of(std::get<B>(b)), relative(pose_a, pose_b),
               search.motion_in(pose_a, swapped), pose_a, swapped, names);
  } else {
    cast_parts(search, std::get<B>(b), core_of(std::get<A>(a)), relative(pose_b, pose_a),
               search.motion_in(pose_b, !swapped), pose_b, !swapped, names);
  }
}

template <class Any, class A, class B>
[[nodiscard]] consteval auto cast_parts_of() -> decltype(PairKernels<Any>::cast_parts) {
  constexpr bool have_parts = HasParts<A> || HasParts<B>, have_others = Convex<A> || Convex<B>;
  if constexpr (route<A, B>() != Route::unsupported && have_parts && (have_others || (HasParts<A> && HasParts<B>))) {
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
            contacts_with_memory_kernel<Any, A, B>,
            contacts_of_run_kernel<Any, A, B>,
            gains_from_memory<A, B>(),
            cast_parts_of<Any, A, B>(),
            name_searches_kernel<A, B>};
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
