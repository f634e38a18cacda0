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
import abut.narrow.manifold.id_table;

export namespace abut {

// Some ids.
class Ids {
 public:
  inline explicit Ids(std::span<const std::uint64_t> ids) : table_(ids.size()) {
    for (const std::uint64_t id : ids) {
      table_.find_or_add(id, true);
    }
  }
  [[nodiscard]] inline bool hold(std::uint64_t id) const { return table_.has(id); }

 private:
  IdTable<bool> table_;
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
