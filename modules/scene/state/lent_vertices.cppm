// SPDX-License-Identifier: Apache-2.0
// Second vertices of meshes that deform, which the caller writes: where the present ones move to.
export module abut.scene.state.lent_vertices;
import abut.core.standard;
import abut.math;

export namespace abut {

// By place of the geometry. The memory of a place stays until it is forgotten, so that it is lent again and again.
class LentVertices {
 public:
  // Lends as many as there are present. They are those that were lent and written last, or of which `take_back` has
  // left others, and the present ones at first.
  [[nodiscard]] std::span<Vec3> lend(std::uint32_t place, std::span<const Vec3> present) [[clang::lifetimebound]] {
    Lent& its = lent_[place];
    if (its.vertices.empty()) {
      its.vertices.assign(present.begin(), present.end());
    }
    its.is_out = true;
    return its.vertices;
  }
  // Of a place whose vertices are lent, else none.
  [[nodiscard]] std::span<const Vec3> of(std::uint32_t place) const [[clang::lifetimebound]] {
    const auto found = lent_.find(place);
    return found == lent_.end() || !found->second.is_out ? std::span<const Vec3>() : found->second.vertices;
  }
  // Those of a place whose vertices are lent, for an exchange; they are lent no longer.
  [[nodiscard]] std::vector<Vec3>& take_back(std::uint32_t place) [[clang::lifetimebound]] {
    Lent& its = lent_.at(place);
    its.is_out = false;
    return its.vertices;
  }
  // Of a geometry that has gone, or that has got others.
  void forget(std::uint32_t place) { lent_.erase(place); }

  [[nodiscard]] bool is_empty() const { return lent_.empty(); }
  // Calls visit(place, vertices) for all that are lent, in order.
  template <class Visitor>
  void visit(Visitor&& visit) const {
    for (const auto& [place, its] : lent_) {
      if (its.is_out) {
        visit(place, std::span<const Vec3>(its.vertices));
      }
    }
  }
  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = 0;
    for (const auto& [place, its] : lent_) {
      sum += sizeof(Lents::value_type) + its.vertices.capacity() * sizeof(Vec3);
    }
    return sum;
  }

 private:
  struct Lent {
    bool is_out = false;
    std::vector<Vec3> vertices;
  };
  using Lents = std::map<std::uint32_t, Lent>;
  Lents lent_;
};

}  // namespace abut
