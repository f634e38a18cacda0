// SPDX-License-Identifier: Apache-2.0
// What the table of all pairs of the shapes of a registry holds. Knows no shape by name, and no kernel: those who ask
// the table are not compiled again where a kernel changes.
//
// A form is a kind that differs only in its name, its number and its parameters (Form). Its shapes, and so its pairs,
// are those of another kind's class. Indices of forms follow those of classes: kind_of returns the kind of a shape, and
// kind_in_pairs that of its pairs.
export module abut.pairs.table;
import abut.core.standard;
import abut.core;
import abut.math;
export import abut.narrow.apart.pair_hint;
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

// A kind by its name, its number and its parameters, whose shapes are of the class of another kind: F::OfClass. Its
// pairs are those of that kind.
template <class F, std::uint32_t Kind>
struct Form {
  using form = F;
  static constexpr std::uint32_t kind = Kind;
};
template <class... Entries>
struct Forms {};

// `AnyOf` is derived from Variant: it has to have a name before the list of shapes is complete, since one of
// them holds others of any kind.
template <class AnyOf, class ListOfForms, class... Entries>
struct Registry;
template <class AnyOf, class... FormEntries, class... Entries>
struct Registry<AnyOf, Forms<FormEntries...>, Entries...> {
  static constexpr std::size_t count = sizeof...(Entries);
  using Any = AnyOf;
  using Variant = std::variant<typename Entries::shape...>;
  template <std::size_t Index>
  using At = std::variant_alternative_t<Index, Variant>;
  template <class S>
  [[nodiscard]] static consteval std::size_t place_of() {
    const std::array is_class{std::is_same_v<S, typename Entries::shape>...};
    std::size_t place = 0;
    while (!is_class[place]) {
      ++place;
    }
    return place;
  }
  // Places of kinds: those of classes, then those of forms.
  static constexpr std::array<std::uint32_t, count + sizeof...(FormEntries)> kinds{Entries::kind...,
                                                                                   FormEntries::kind...};
  // Calls use.operator()<S>() for the class or the form at each place, and returns what that returns.
  template <class Use>
  [[nodiscard]] static constexpr auto for_each_kind(Use use) {
    return std::array {
      use.template operator()<typename Entries::shape>()...,
      use.template operator()<typename FormEntries::form>()...
    };
  }
  template <class S>
  [[nodiscard]] static consteval std::uint32_t kind_of() {
    return ((std::is_same_v<S, typename Entries::shape> ? Entries::kind : 0) + ...);
  }
  static_assert((Shape<typename Entries::shape> && ...), "a registered class does not model the concept Shape");
};

// The kernels of a pair of kinds. Single pairs are asked about in the world, with the sides swapped on
// demand, so that closed forms stay in registers from the poses to the answer.
template <class Any>
struct PairKernels {
  Route route;
  bool flipped;
  Outcome (*distance)(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                      const QuerySettings& settings, Distance& out);
  Outcome (*contacts)(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                      const QuerySettings& settings, Manifold& out);
  // In the frame of the first shape. `memory`: what is known of the pair in this order, which changes no bit of the
  // answer, or null. Kinds that gain nothing from a memory leave it as it is.
  Outcome (*contacts_in_frame)(const Any& a, const Any& b, const Pose& ab, const QuerySettings& settings,
                               PairMemory* memory, Manifold& out);
  bool gains_from_memory = false;
  // Casts b against a, part by part where either has parts, the poses being those before the motion; with the sides
  // swapped it is a that moves. Null where the distance of the pair is all that a cast needs.
  void (*cast_parts)(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                     const CastNames& names, CastSearch& search) = nullptr;
  // Which searches find the distance of the two, in words.
  std::string_view (*searches)() = nullptr;
  // The distance with what the last query of the two in this order has left. Null where it would gain nothing.
  Outcome (*distance_from_hint)(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b, bool swapped,
                                const QuerySettings& settings, PairHint& hint, Distance& out) = nullptr;
};

// The order in which two shapes were given. Which of two shapes of one kind comes first may change as they move.
struct GivenOrder {
  bool is_swapped, is_of_one_kind;
};

// Numbers of contacts tell the features in the order in which the shapes were given.
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

// Contacts from the frame of the first shape to the world.
inline void place_contacts(std::span<ContactPoint> contacts, const Pose& pose_a, const GivenOrder& order) {
  for (ContactPoint& contact : contacts) {
    move_by(contact, pose_a, order.is_swapped);
  }
  if (order.is_of_one_kind && order.is_swapped) {
    number_in_order_given(contacts);
  }
}

}  // namespace abut
