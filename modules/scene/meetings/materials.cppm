// SPDX-License-Identifier: Apache-2.0
// Contact materials: what a solver wants to know of the contacts of two materials.
export module abut.scene.meetings.materials;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

// Plain numbers that abut stores and hands out; it applies none of them.
struct ContactMaterial {
  Real friction_primary = 0, friction_secondary = 0;  // coefficients along the two axes of the contact plane
  Real friction_spin = 0, friction_roll = 0;          // about the normal, and about axes of the contact plane
  Real static_scale = 1;                              // of the coefficients while nothing slides
  Real slip = 0;
  Real compliance = 0, damping = 0;
  Real restitution = 0, restitution_threshold = 0.001;  // below that speed nothing bounces
  Real adhesive_force = 0;

  friend constexpr bool operator==(const ContactMaterial&, const ContactMaterial&) = default;
};

// A symmetric table. A pair without a row of its own is combined from the rows of each material with itself; one that
// has none counts as the default.
// - Geometric mean: frictions, static scales.
// - The greater one: restitution and its threshold, damping.
// - Sum: slips, compliances, adhesive forces.
class MaterialTable {
 public:
  // Nothing takes the row away. O(log rows).
  void set(std::uint32_t a, std::uint32_t b, const std::optional<ContactMaterial>& row);
  [[nodiscard]] ContactMaterial of(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] std::size_t bytes() const;

  template <class Archive, class Self>
  static void transfer(Archive& archive, Self& self) {
    archive(self.rows_);
    if constexpr (Archive::is_reading) {
      archive.require(self.is_whole(), "a contact material is none");
    }
  }

 private:
  [[nodiscard]] bool is_whole() const;

  using Key = std::pair<std::uint32_t, std::uint32_t>;
  [[nodiscard]] std::optional<ContactMaterial> find(std::uint32_t a, std::uint32_t b) const;

  std::map<Key, ContactMaterial> rows_;
};

// The first number of a row that is not finite or negative.
[[nodiscard]] Fault check_material(const ContactMaterial& material);

}  // namespace abut
