// From two types of shapes to an algorithm, at compile time, and the table of all pairs. Knows no
// shape by name.
module;
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <variant>
#include <vector>
export module abut.dispatch;
import abut.core;
import abut.math;
import abut.narrowphase.convex;
import abut.narrowphase.half_space;
import abut.narrowphase.parts;
import abut.shape;

export namespace abut {

// A hand-written pair specialises this in modules/pairs; only the generated registry imports those.
template <class A, class B>
struct Intersector;

template <class A, class B>
concept HandWritten = requires(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Distance& distance,
                               Manifold& manifold) {
  { Intersector<A, B>::distance(a, b, ab, settings, distance) } -> std::same_as<Outcome>;
  { Intersector<A, B>::contacts(a, b, ab, settings, manifold) } -> std::same_as<Outcome>;
};

// How a pair is answered, in the order in which the ways are tried.
enum class Route : std::uint8_t {
  unsupported,
  hand_written,
  half_space,
  half_space_of_parts,
  convex,
  parts,
  parts_of_both,
  none,
};

// The route of a pair in this order of operands; none when the other order may have one.
template <class A, class B>
[[nodiscard]] consteval Route route_one_way() {
  if constexpr (Terrain<A> && Terrain<B>) {
    return Route::unsupported;
  } else if constexpr (HandWritten<A, B>) {
    return Route::hand_written;
  } else if constexpr (HalfSpace<A> && Convex<B>) {
    return Route::half_space;
  } else if constexpr (HalfSpace<A> && Composite<B>) {
    return Route::half_space_of_parts;
  } else if constexpr (Convex<A> && Convex<B>) {
    return Route::convex;
  } else if constexpr (Composite<A> && Convex<B>) {
    return Route::parts;
  } else if constexpr (Composite<A> && Composite<B>) {
    return Route::parts_of_both;
  } else {
    return Route::none;
  }
}

template <class A, class B>
[[nodiscard]] consteval bool is_flipped() {
  return route_one_way<A, B>() == Route::none || (!HandWritten<A, B> && HandWritten<B, A>);
}

template <class A, class B>
[[nodiscard]] consteval Route route() {
  constexpr Route found = is_flipped<A, B>() ? route_one_way<B, A>() : route_one_way<A, B>();
  static_assert(found != Route::none, "this pair of shapes has no hand-written pair and no capability in common");
  return found;
}

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
  } else if constexpr (way == Route::hand_written) {
    return Intersector<A, B>::distance(a, b, ab, settings, out);
  } else if constexpr (way == Route::half_space) {
    return half_space_distance(a, b, ab, settings, out);
  } else if constexpr (way == Route::half_space_of_parts) {
    return half_space_parts_distance(a, b, ab, settings, out);
  } else if constexpr (way == Route::convex) {
    return convex_distance(a, b, ab, settings, out);
  } else if constexpr (way == Route::parts) {
    return parts_distance(a, b, ab, settings, out);
  } else {
    return composites_distance(a, b, ab, settings, out);
  }
}

template <class A, class B>
[[nodiscard]] Outcome contacts_by_route(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Manifold& out) {
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
  } else if constexpr (way == Route::hand_written) {
    return Intersector<A, B>::contacts(a, b, ab, settings, out);
  } else if constexpr (way == Route::half_space) {
    return half_space_contacts(a, b, ab, settings, out);
  } else if constexpr (way == Route::half_space_of_parts) {
    return half_space_parts_contacts(a, b, ab, settings, out);
  } else if constexpr (way == Route::convex) {
    return convex_contacts(a, b, ab, settings, out);
  } else if constexpr (way == Route::parts) {
    return parts_contacts(a, b, ab, settings, out);
  } else {
    return composites_contacts(a, b, ab, settings, out);
  }
}

template <class S, std::uint32_t Kind>
struct Entry {
  using shape = S;
  static constexpr std::uint32_t kind = Kind;
};

template <class... Entries>
struct Registry {
  static constexpr std::size_t count = sizeof...(Entries);
  using Any = std::variant<typename Entries::shape...>;
  template <std::size_t Index>
  using At = std::variant_alternative_t<Index, Any>;
  static constexpr std::array<std::uint32_t, count> kinds{Entries::kind...};
  static_assert((Shape<typename Entries::shape> && ...), "a registered class does not model the concept Shape");
};

// One pair of geometries of a run of pairs with the same two kinds.
struct PairJob {
  std::uint32_t a, b;  // places in the arrays of shapes and poses
  Real margin;
};

// What a run of pairs left behind: where the contacts of each job end, and how it went.
struct PairResult {
  std::uint32_t contacts_end;
  Outcome outcome;
};

// The kernels of a pair of kinds. Single pairs are asked about in the world, with the sides swapped on
// demand, so that what lies between the poses and the answer stays in registers. The batch is one loop
// over one pair of types, entered by one call, and answers in the frames of the first shapes: much of that
// is dropped before it is moved.
template <class Any>
struct PairKernels {
  Route route;
  bool flipped;
  Outcome (*distance)(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                      const QuerySettings& settings, Distance& out);
  Outcome (*contacts)(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                      const QuerySettings& settings, Manifold& out);
  void (*contacts_of_run)(std::span<const Frozen<Any>> shapes, std::span<const Pose> poses, std::span<const PairJob> jobs,
                          const QuerySettings& settings, Manifold& out, std::span<PairResult> results);
};

template <class Any, class A, class B>
[[nodiscard]] Outcome distance_kernel(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                                      const QuerySettings& settings, Distance& out) {
  [[clang::uninitialized]] Distance found;
  const Outcome outcome = distance_by_route(std::get<A>(a), std::get<B>(b), relative(pose_a, pose_b), settings, found);
  if (outcome == Outcome::ok) [[likely]] {
    move_by(found, pose_a, swapped);
    out = found;
  }
  return outcome;
}

template <class Any, class A, class B>
[[nodiscard]] Outcome contacts_kernel(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                                      const QuerySettings& settings, Manifold& out) {
  const std::size_t first = out.size();
  const Outcome outcome = contacts_by_route(std::get<A>(a), std::get<B>(b), relative(pose_a, pose_b), settings, out);
  for (ContactPoint& contact : std::span(out).subspan(first)) {
    move_by(contact, pose_a, swapped);
  }
  return outcome;
}

template <class Any, class A, class B>
void contacts_of_run_kernel(std::span<const Frozen<Any>> shapes, std::span<const Pose> poses, std::span<const PairJob> jobs,
                            const QuerySettings& common, Manifold& out, std::span<PairResult> results) {
  QuerySettings settings = common;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const PairJob& job = jobs[i];
    settings.margin = job.margin;
    const Outcome outcome = contacts_by_route(std::get<A>(*shapes[job.a]), std::get<B>(*shapes[job.b]),
                                              relative(poses[job.a], poses[job.b]), settings, out);
    results[i] = {static_cast<std::uint32_t>(out.size()), outcome};
  }
}

template <class Any, class A, class B>
[[nodiscard]] consteval PairKernels<Any> make_kernels() {
  return {route<A, B>(), is_flipped<A, B>(), distance_kernel<Any, A, B>, contacts_kernel<Any, A, B>,
          contacts_of_run_kernel<Any, A, B>};
}

// The cells (Row, Row), (Row, Row + 1), ... of the table; those below the diagonal stay empty, since a
// pair is always looked up in the order of the registry.
template <class Shapes, std::size_t Row>
[[nodiscard]] consteval std::array<PairKernels<typename Shapes::Any>, Shapes::count> make_row() {
  using Any = typename Shapes::Any;
  std::array<PairKernels<Any>, Shapes::count> row{};
  [&]<std::size_t... Offsets>(std::index_sequence<Offsets...>) {
    ((row[Row + Offsets] = make_kernels<Any, typename Shapes::template At<Row>, typename Shapes::template At<Row + Offsets>>()),
     ...);
  }(std::make_index_sequence<Shapes::count - Row>{});
  return row;
}

}  // namespace abut
