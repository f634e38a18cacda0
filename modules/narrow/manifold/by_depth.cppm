// SPDX-License-Identifier: Apache-2.0
// What a reduction looks at of contacts, in the order of depth. Contacts are large: they move once it is known which of
// them stay.
export module abut.narrow.manifold.by_depth;
import abut.capability;
import abut.core.small_vector;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.manifold.depth_order;

export namespace abut {

// Some ids, each at the first free place of a table from where its bits lead. Less than half of the places are taken.
class Ids {
 public:
  inline explicit Ids(std::span<const std::uint64_t> ids) : is_empty_(ids.empty()) {
    if (is_empty_) {
      return;
    }
    int bits = 3;
    while ((std::size_t{1} << bits) < 2 * ids.size() + 1) {
      ++bits;
    }
    shift_ = 64 - bits;
    for (std::size_t i = 0; i < std::size_t{1} << bits; ++i) {
      places_.push_back({0, false});
    }
    for (const std::uint64_t id : ids) {
      places_[place_of(id)] = {id, true};
    }
  }
  [[nodiscard]] inline bool hold(std::uint64_t id) const { return !is_empty_ && places_[place_of(id)].is_taken; }

 private:
  struct Place {
    std::uint64_t id;
    bool is_taken;
  };
  // Where an id is, or may be put.
  [[nodiscard]] inline std::size_t place_of(std::uint64_t id) const {
    std::size_t place = (id * 0x9e3779b97f4a7c15) >> shift_;
    while (places_[place].is_taken && places_[place].id != id) {
      place = (place + 1) % places_.size();
    }
    return place;
  }

  SmallVector<Place, 256> places_;
  int shift_ = 0;
  bool is_empty_;
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
    for (const std::uint32_t number : numbers_.span()) {
      const ContactPoint& contact = contacts[number];
      if (rows_.size() % 4 == 0) {
        normals_.push_back(Columns::all(contact.normal));
      }
      normals_[rows_.size() / 4].put(rows_.size() % 4, contact.normal);
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
