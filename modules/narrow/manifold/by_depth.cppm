// SPDX-License-Identifier: Apache-2.0
// What a reduction looks at of contacts, in the order of depth. Contacts are large: they move once it is known which of
// them stay.
//
// A contact has 112 bytes, of which the normal, the middle and the depth are read again and again, four normals at
// once. In one benchmark a box on a mesh has 81 contacts, of which 19 stay.
export module abut.narrow.manifold.by_depth;
import abut.capability;
import abut.core.memory.small_vector;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.manifold.depth_order;

export namespace abut {

// Values by ids, each at the first free place of a table from where the bits of its id lead.
template <class Value>
class IdTable {
 public:
  // Less than half of the places are taken.
  inline explicit IdTable(std::size_t most_ids) {
    if (most_ids == 0) {
      return;
    }
    bits_ = static_cast<int>(std::bit_width(2 * most_ids));
    for (std::size_t i = 0; i < std::size_t{1} << bits_; ++i) {
      places_.push_back({0, {}, false});
    }
  }
  // The value of an id; one that has none takes the given value.
  inline Value& find_or_add(std::uint64_t id, const Value& value) [[clang::lifetimebound]] {
    Place& place = places_[place_of(id)];
    place = place.is_taken ? place : Place{id, value, true};
    return place.value;
  }
  [[nodiscard]] inline bool has(std::uint64_t id) const { return !places_.empty() && places_[place_of(id)].is_taken; }

 private:
  struct Place {
    std::uint64_t id;
    Value value;
    bool is_taken;
  };
  // Where an id is, or may be put.
  [[nodiscard]] inline std::size_t place_of(std::uint64_t id) const {
    std::size_t place = spread(id, bits_);
    while (places_[place].is_taken && places_[place].id != id) {
      place = (place + 1) % places_.size();
    }
    return place;
  }

  SmallVector<Place, 256> places_;
  int bits_ = 0;  // of a place
};

// Some ids.
class Ids {
 public:
  inline explicit Ids(std::span<const std::uint64_t> ids) : table_(ids.size()) {
    for (const std::uint64_t id : ids) {
      table_.find_or_add(id, 0);
    }
  }
  [[nodiscard]] inline bool hold(std::uint64_t id) const { return table_.has(id); }

 private:
  IdTable<std::uint32_t> table_;
};

// Whether a feature holds the point. None holds the deepest point of a rim that rests on its face.
[[nodiscard]] inline bool is_held(const ContactPoint& contact) {
  const auto is_whole = [](const Feature& feature) { return feature.kind == FeatureKind::whole; };
  const auto is_wide = [](const Feature& feature) {
    return feature.kind == FeatureKind::whole || feature.kind == FeatureKind::face;
  };
  return !((is_whole(contact.feature_a) && is_wide(contact.feature_b)) ||
           (is_wide(contact.feature_a) && is_whole(contact.feature_b)));
}

// Ranks are places in the order of depth.
class ByDepth {
 public:
  inline ByDepth(std::span<const ContactPoint> contacts, const Ids& before) : numbers_(depth_order(contacts)) {
    const std::span<const std::uint32_t> numbers = numbers_.span();
    for (std::size_t first = 0; first < numbers.size(); first += 4) {
      const auto normal = [&](std::size_t i) {
        return lanes_of(contacts[numbers[std::min(first + i, numbers.size() - 1)]].normal);
      };
      normals_.push_back(Columns::of(normal(0), normal(1), normal(2), normal(3)));
    }
    for (const std::uint32_t number : numbers) {
      const ContactPoint& contact = contacts[number];
      rows_.push_back(
          {0.5 * (contact.point_a + contact.point_b), contact.distance, before.hold(contact.id), is_held(contact)});
    }
  }
  [[nodiscard]] inline std::uint32_t size() const { return static_cast<std::uint32_t>(numbers_.size()); }
  [[nodiscard]] inline std::uint32_t number(std::uint32_t rank) const { return numbers_[rank]; }
  [[nodiscard]] inline Real distance(std::uint32_t rank) const { return rows_[rank].distance; }
  [[nodiscard]] inline const Vec3& middle(std::uint32_t rank) const [[clang::lifetimebound]] {
    return rows_[rank].middle;
  }
  [[nodiscard]] inline Vec3 normal(std::uint32_t rank) const { return normals_[rank / 4][rank % 4]; }
  // The normals of four ranks each; the last ones may be there several times.
  [[nodiscard]] inline std::span<const Columns> normals() const [[clang::lifetimebound]] { return normals_.span(); }
  [[nodiscard]] inline bool was_kept(std::uint32_t rank) const { return rows_[rank].was_kept; }
  [[nodiscard]] inline bool is_held_by_features(std::uint32_t rank) const { return rows_[rank].is_held; }
  // How far some contacts lie from the first of them.
  [[nodiscard]] inline Real extent_of(std::span<const std::uint32_t> ranks) const {
    Real square = 0;
    for (const std::uint32_t rank : ranks) {
      square = std::max(square, squared_norm(middle(rank) - middle(ranks[0])));
    }
    return std::sqrt(square);
  }
  // How far all of them lie from the deepest one.
  [[nodiscard]] inline Real extent() const {
    Real square = 0;
    for (const Row& row : rows_.span()) {
      square = std::max(square, squared_norm(row.middle - rows_[0].middle));
    }
    return std::sqrt(square);
  }

 private:
  struct Row {
    Vec3 middle;
    Real distance;
    bool was_kept, is_held;
  };
  Numbers numbers_;
  SmallVector<Columns, few_contacts / 4> normals_;
  SmallVector<Row, few_contacts> rows_;
};

}  // namespace abut
