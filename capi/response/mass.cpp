// SPDX-License-Identifier: Apache-2.0
// Mass of shapes and of parts, seen through abut.h.
#include "extension_arguments.hpp"
#include "response/holes.hpp"
#include "response/source.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

import abut.response;

namespace abut::capi {

namespace {

using response::MassProperties;

constexpr double least_part_left = 1e-6;

[[nodiscard]] abut_status refuse_shape(std::string_view kind, const char* why) noexcept {
  std::array<char, 160> message{};
  static_cast<void>(std::snprintf(message.data(), message.size(), "shape is a %.*s; %s", static_cast<int>(kind.size()),
                                  kind.data(), why));
  return refuse(ABUT_UNSUPPORTED, message.data());
}

// Shapes of one formula. Their parameters are what they are made of.
[[nodiscard]] std::optional<MassProperties> by_formula(std::string_view kind, const std::vector<double>& its) {
  if (kind == "sphere") return response::ellipsoid_mass({its.at(0), its.at(0), its.at(0)});
  if (kind == "box") return response::box_mass({its.at(0), its.at(1), its.at(2)});
  if (kind == "capsule") return response::capsule_mass(its.at(0), its.at(1));
  if (kind == "cylinder") return response::cylinder_mass(its.at(0), its.at(1));
  if (kind == "cone") return response::cone_mass(its.at(0), its.at(1));
  if (kind == "ellipsoid") return response::ellipsoid_mass({its.at(0), its.at(1), its.at(2)});
  return std::nullopt;
}

[[nodiscard]] abut_status by_triangles(const abut_shape* shape, std::string_view kind, MassProperties& out) {
  std::size_t vertices = 0, triangles = 0;
  if (abut_shape_triangles(shape, nullptr, 0, &vertices, nullptr, 0, &triangles) != ABUT_OK)
    return refuse_shape(kind, "its mass must be given");
  std::vector<double> xyz(3 * vertices);
  std::vector<std::uint32_t> indices(3 * triangles);
  const abut_status status =
      abut_shape_triangles(shape, xyz.data(), vertices, &vertices, indices.data(), triangles, &triangles);
  if (status != ABUT_OK) return status;
  const std::optional<MassProperties> enclosed = response::enclosed_mass(xyz, indices);
  if (!enclosed) return refuse_shape(kind, "its triangles must enclose a volume, with the outside in front");
  out = *enclosed;
  return ABUT_OK;
}

// Solids count one by one, also where they overlap.
[[nodiscard]] abut_status by_children(const abut_shape* shape, MassProperties& out) {
  std::vector<CompositePart> parts;
  abut_status status = parts_of_composite(shape, parts);
  std::vector<MassProperties> masses;
  double solid = 0;
  for (const CompositePart& part : parts) {
    if (status != ABUT_OK) return status;
    if (part.info.is_hole != 0) continue;
    MassProperties mass;
    status = mass_of_shape(part.shape.get(), mass);
    if (status != ABUT_OK) {
      const std::string said = abut_last_error_message();
      return refuse(status, ("child " + std::to_string(part.number) + " of a composite: " + said).c_str());
    }
    solid += mass.mass;
    masses.push_back(response::placed(mass, part.info.pose));
  }
  if (status == ABUT_OK) status = missing_of_holes(parts, masses);
  if (status != ABUT_OK) return status;
  out = response::combined(masses);
  // What holes leave must be more than what rounding does.
  if (!(out.mass > least_part_left * solid)) return refuse_shape("composite", "its holes leave nothing of it");
  return ABUT_OK;
}

}  // namespace

abut_status mass_of_shape(const abut_shape* shape, MassProperties& out) {
  const char* const name = abut_shape_kind_name(abut_shape_kind_of(shape));
  const std::string_view kind = name == nullptr ? "" : name;
  if (kind == "composite") return by_children(shape, out);
  std::size_t count = 0;
  abut_status status = abut_shape_parameters(shape, nullptr, 0, &count);
  if (status != ABUT_OK) return status;
  std::vector<double> parameters(count);
  status = abut_shape_parameters(shape, parameters.data(), count, &count);
  if (status != ABUT_OK) return status;
  const std::optional<MassProperties> known = by_formula(kind, parameters);
  if (!known) return by_triangles(shape, kind, out);
  if (!(known->mass > 0)) return refuse_shape(kind, "it is flat, so its mass must be given");
  out = *known;
  return ABUT_OK;
}

abut_status mass_of_part(const abut_universe* universe, abut_part_id part, double density, MassProperties& out) {
  std::size_t count = 0;
  abut_status status = abut_part_geometries(universe, part, nullptr, 0, &count);
  if (status != ABUT_OK) return status;
  std::vector<abut_geometry_id> geometries(count);
  status = abut_part_geometries(universe, part, geometries.data(), count, &count);
  if (status != ABUT_OK) return status;
  std::vector<MassProperties> masses;
  for (const abut_geometry_id geometry : geometries) {
    abut_geometry_info info;
    abut_geometry_info_init(&info, sizeof info);
    status = abut_geometry_describe(universe, geometry, &info);
    if (status != ABUT_OK) return status;
    if ((info.flags & ABUT_GEOMETRY_SENSOR) != 0) continue;
    MassProperties mass;
    status = mass_of_shape(info.shape, mass);
    if (status != ABUT_OK) return status;
    masses.push_back(response::placed(response::scaled(mass, density), info.local));
  }
  if (masses.empty()) {
    return refuse(ABUT_EMPTY, "part.slot", part.slot, "it has no geometries, so options.mass must be given");
  }
  out = response::combined(masses);
  return ABUT_OK;
}

}  // namespace abut::capi
