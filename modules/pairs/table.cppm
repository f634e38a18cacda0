// What the table of all pairs of the shapes of a registry holds. Knows no shape by name, and no kernel: those who ask
// the table are not compiled again where a kernel changes.
export module abut.pairs.table;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.cast.cast_search;
export import abut.narrow.warm.pair_memory;
export import abut.pairs.routes;
import abut.capability;

export namespace abut {

template <class S, std::uint32_t Kind>
struct Entry {
  using shape = S;
  static constexpr std::uint32_t kind = Kind;
};

// `AnyOf` is derived from Variant: it has to have a name before the list of shapes is complete, since one of
// them holds others of any kind.
template <class AnyOf, class... Entries>
struct Registry {
  static constexpr std::size_t count = sizeof...(Entries);
  using Any = AnyOf;
  using Variant = std::variant<typename Entries::shape...>;
  template <std::size_t Index>
  using At = std::variant_alternative_t<Index, Variant>;
  static constexpr std::array<std::uint32_t, count> kinds{Entries::kind...};
  template <class S>
  [[nodiscard]] static consteval std::uint32_t kind_of() {
    return ((std::is_same_v<S, typename Entries::shape> ? Entries::kind : 0) + ...);
  }
  static_assert((Shape<typename Entries::shape> && ...), "a registered class does not model the concept Shape");
};

// One pair of geometries of a run of pairs with the same two kinds.
struct PairJob {
  std::uint32_t a, b;  // places in the arrays of shapes and poses
  Real margin;
  std::uint32_t memory = no_memory;  // place in the array of memories
};

// What a run of pairs left behind: where the contacts of each job end, and how it went.
struct PairResult {
  std::uint32_t contacts_end;
  Outcome outcome;
};

// The kernels of a pair of kinds. Single pairs are asked about in the world, with the sides swapped on
// demand, so that what lies between the poses and the answer stays in registers. The batch is one loop
// over one pair of types, entered by one call, and answers in the frames of the first shapes: much of that
// is dropped before it is moved. Kinds that gain nothing from a memory leave it as it is.
template <class Any>
struct PairKernels {
  Route route;
  bool flipped;
  Outcome (*distance)(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                      const QuerySettings& settings, Distance& out);
  Outcome (*contacts)(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                      const QuerySettings& settings, Manifold& out);
  // The same with what is known of the pair in this order, which changes no bit of the answer.
  Outcome (*contacts_with_memory)(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                                  const QuerySettings& settings, PairMemory& memory, Manifold& out);
  void (*contacts_of_run)(std::span<const Frozen<Any>> shapes, std::span<const Pose> poses,
                          std::span<const PairJob> jobs, const QuerySettings& settings, std::span<PairMemory> memories,
                          Manifold& out, std::span<PairResult> results);
  bool gains_from_memory = false;
  // Casts b against a part by part, the poses being those before the motion; with the sides swapped it is a that moves.
  // Null where neither is made of parts.
  void (*cast_parts)(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                     const CastNames& names, CastSearch& search) = nullptr;
  // Which searches find the distance of the two, in words.
  std::string_view (*searches)() = nullptr;
};

}  // namespace abut
