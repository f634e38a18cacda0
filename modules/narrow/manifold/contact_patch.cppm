// SPDX-License-Identifier: Apache-2.0
// Some of the contacts of a pair whose normals agree, the deepest one first. They stay where they are.
export module abut.narrow.manifold.contact_patch;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

[[nodiscard]] inline Vec3 middle(const ContactPoint& contact) { return 0.5 * (contact.point_a + contact.point_b); }

class ContactPatch {
 public:
  // `places`: of the contacts of the patch, in the order of their depths.
  ContactPatch(std::span<const ContactPoint> contacts [[clang::lifetimebound]],
               std::span<const std::uint32_t> places [[clang::lifetimebound]])
      : contacts_(contacts), places_(places) {}

  [[nodiscard]] std::size_t size() const { return places_.size(); }
  [[nodiscard]] const ContactPoint& operator[](std::size_t index) const { return contacts_[places_[index]]; }
  [[nodiscard]] std::uint32_t place(std::size_t index) const { return places_[index]; }
  // Some of its contacts, by their places.
  [[nodiscard]] ContactPatch of(std::span<const std::uint32_t> places) const { return {contacts_, places}; }

  // How far the contacts lie from the deepest one.
  [[nodiscard]] Real extent() const {
    Real square = 0;
    for (const std::uint32_t place : places_) {
      square = std::max(square, squared_norm(middle(contacts_[place]) - middle((*this)[0])));
    }
    return std::sqrt(square);
  }

 private:
  std::span<const ContactPoint> contacts_;
  std::span<const std::uint32_t> places_;
};

// The points of a patch in the plane across its normal.
using Flats = SmallVector<Vec2, 256>;

[[nodiscard]] inline Flats flattened(const ContactPatch& patch) {
  const Tangents tangents = tangents_of(patch[0].normal);
  const Vec3 base = middle(patch[0]);
  [[clang::uninitialized]] Flats points;
  for (std::size_t i = 0; i < patch.size(); ++i) {
    const Vec3 d = middle(patch[i]) - base;
    points.push_back({dot(d, tangents.first), dot(d, tangents.second)});
  }
  return points;
}

}  // namespace abut
