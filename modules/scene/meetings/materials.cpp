// SPDX-License-Identifier: Apache-2.0
module abut.scene.meetings.materials;
import abut.capability;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {

ContactMaterial combined(const ContactMaterial& a, const ContactMaterial& b) {
  const auto mean = [](Real x, Real y) { return std::sqrt(x * y); };
  return {.friction_primary = mean(a.friction_primary, b.friction_primary),
          .friction_secondary = mean(a.friction_secondary, b.friction_secondary),
          .friction_spin = mean(a.friction_spin, b.friction_spin),
          .friction_roll = mean(a.friction_roll, b.friction_roll),
          .static_scale = mean(a.static_scale, b.static_scale),
          .slip = a.slip + b.slip,
          .compliance = a.compliance + b.compliance,
          .damping = std::max(a.damping, b.damping),
          .restitution = std::max(a.restitution, b.restitution),
          .restitution_threshold = std::max(a.restitution_threshold, b.restitution_threshold),
          .adhesive_force = a.adhesive_force + b.adhesive_force};
}

}  // namespace

void MaterialTable::set(std::uint32_t a, std::uint32_t b, const std::optional<ContactMaterial>& row) {
  const Key key{std::min(a, b), std::max(a, b)};
  if (row) {
    rows_.insert_or_assign(key, *row);
  } else {
    rows_.erase(key);
  }
}

std::optional<ContactMaterial> MaterialTable::find(std::uint32_t a, std::uint32_t b) const {
  const auto found = rows_.find(Key{std::min(a, b), std::max(a, b)});
  return found == rows_.end() ? std::nullopt : std::optional(found->second);
}

ContactMaterial MaterialTable::of(std::uint32_t a, std::uint32_t b) const {
  if (const auto row = find(a, b)) {
    return *row;
  }
  return a == b ? ContactMaterial{} : combined(of(a, a), of(b, b));
}

std::size_t MaterialTable::bytes() const {
  // What a node of a std::map holds besides the value.
  constexpr std::size_t node_bytes = 4 * sizeof(std::size_t);
  return rows_.size() * (sizeof(Key) + sizeof(ContactMaterial) + node_bytes);
}

Fault check_material(const ContactMaterial& material) {
  const std::array<std::pair<std::string_view, Real>, 11> values{{
      {"friction_primary", material.friction_primary},
      {"friction_secondary", material.friction_secondary},
      {"friction_spin", material.friction_spin},
      {"friction_roll", material.friction_roll},
      {"static_scale", material.static_scale},
      {"slip", material.slip},
      {"compliance", material.compliance},
      {"damping", material.damping},
      {"restitution", material.restitution},
      {"restitution_threshold", material.restitution_threshold},
      {"adhesive_force", material.adhesive_force},
  }};
  for (const auto& [name, value] : values) {
    if (Fault fault = check_not_negative(name, value)) {
      return fault;
    }
  }
  return std::nullopt;
}

bool MaterialTable::is_whole() const {
  return std::ranges::none_of(rows_, [](const auto& row) { return check_material(row.second).has_value(); });
}

}  // namespace abut
