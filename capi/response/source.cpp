// SPDX-License-Identifier: Apache-2.0
#include "response/source.hpp"

#include "core/check.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

import abut.response;

namespace abut::capi {

namespace {

// By which the universe tells it.
constexpr const char* extension_name = "response";

// What a universe lends until it changes.
template <class Record>
[[nodiscard]] abut_status copy_lent(const abut_universe* universe,
                                    abut_status (*lend)(const abut_universe*, const Record**, std::size_t*),
                                    std::vector<Record>& out) {
  const Record* first = nullptr;
  std::size_t count = 0;
  const abut_status status = lend(universe, &first, &count);
  if (status != ABUT_OK) return status;
  // SAFETY: the universe lends as many records as it says.
  ABUT_UNSAFE_BEGIN
  const std::span<const Record> lent(first, count);
  ABUT_UNSAFE_END
  out.assign(lent.begin(), lent.end());
  return ABUT_OK;
}

}  // namespace

void DetachResponse::operator()(abut_universe* universe) const noexcept {
  // A universe that has failed keeps the count, and answers nothing about it any more.
  static_cast<void>(abut_universe_detach(universe, extension_name));
}

abut_status attach_response(abut_universe* universe, ResponseAttachment& out) noexcept {
  const abut_status status = abut_universe_attach(universe, extension_name);
  if (status == ABUT_OK) out.reset(universe);
  return status;
}

abut_status ResponseSource::detect(double dt) { return abut_universe_step(universe_.get(), dt); }

abut_status ResponseSource::contacts(std::vector<abut_contact>& out) const {
  return copy_lent(universe_.get(), abut_universe_contacts, out);
}

abut_status ResponseSource::element_contacts(std::vector<abut_element_contact>& out) const {
  out.clear();
  if (abut_has_feature("deforming") == 0) return ABUT_OK;
  return copy_lent(universe_.get(), abut_universe_element_contacts, out);
}

abut_status ResponseSource::contact_distance(abut_geometry_id a, abut_geometry_id b, double& out) const {
  response::GeometryFacts facts_a, facts_b;
  abut_status status = facts(a, facts_a);
  if (status == ABUT_OK) status = facts(b, facts_b);
  abut_policy policy;
  abut_policy_init(&policy, sizeof policy);
  if (status == ABUT_OK) status = abut_policy_get(universe_.get(), facts_a.tag, facts_b.tag, &policy);
  out = policy.contact_distance;
  return status;
}

abut_status ResponseSource::skin(abut_geometry_id geometry, response::Skin& out) const {
  abut_geometry_info info;
  abut_geometry_info_init(&info, sizeof info);
  abut_status status = abut_geometry_describe(universe_.get(), geometry, &info);
  std::size_t vertices = 0, triangles = 0;
  if (status == ABUT_OK) status = abut_shape_triangles(info.shape, nullptr, 0, &vertices, nullptr, 0, &triangles);
  if (status != ABUT_OK) return status;
  out.xyz.resize(3 * vertices);
  out.triangles.resize(3 * triangles);
  status = abut_shape_triangles(info.shape, out.xyz.data(), vertices, &vertices, out.triangles.data(), triangles,
                                &triangles);
  using namespace response;
  const Matrix turn = matrix_of(info.pose.orientation);
  for (std::size_t i = 0; i + 2 < out.xyz.size(); i += 3) {
    const abut_vec3 at = add(info.pose.position, times(turn, {out.xyz[i], out.xyz[i + 1], out.xyz[i + 2]}));
    out.xyz[i] = at.x;
    out.xyz[i + 1] = at.y;
    out.xyz[i + 2] = at.z;
  }
  return status;
}

abut_status ResponseSource::facts(abut_geometry_id geometry, response::GeometryFacts& out) const {
  abut_geometry_info info;
  abut_geometry_info_init(&info, sizeof info);
  const abut_status status = abut_geometry_describe(universe_.get(), geometry, &info);
  if (status == ABUT_OK)
    out = {.geometry = geometry,
           .part = info.part,
           .label = info.label,
           .tag = info.tag,
           .material = info.material,
           .flags = info.flags,
           .tolerance = info.tolerance};
  return status;
}

abut_status ResponseSource::material(std::uint32_t a, std::uint32_t b, abut_contact_material& out) const {
  abut_contact_material_init(&out, sizeof out);
  return abut_material_pair_get(universe_.get(), a, b, &out);
}

// Nothing has failed for the caller, whose last message stays.
bool ResponseSource::has(abut_part_id part) const {
  const std::string message = abut_last_error_message();
  abut_motion motion = 0;
  const bool has_it = abut_part_motion(universe_.get(), part, &motion) == ABUT_OK;
  if (!has_it) abut_set_last_error(ABUT_OK, message.c_str());
  return has_it;
}

bool ResponseSource::has(abut_geometry_id geometry) const {
  const std::string message = abut_last_error_message();
  response::GeometryFacts ignored;
  const bool has_it = facts(geometry, ignored) == ABUT_OK;
  if (!has_it) abut_set_last_error(ABUT_OK, message.c_str());
  return has_it;
}

abut_status ResponseSource::geometries_of(abut_part_id part, std::vector<response::GeometryFacts>& out) const {
  std::size_t count = 0;
  abut_status status = abut_part_geometries(universe_.get(), part, nullptr, 0, &count);
  std::vector<abut_geometry_id> all(count);
  if (status == ABUT_OK) status = abut_part_geometries(universe_.get(), part, all.data(), count, &count);
  out.clear();
  for (const abut_geometry_id geometry : all) {
    if (status == ABUT_OK) status = facts(geometry, out.emplace_back());
  }
  return status;
}

abut_status ResponseSource::is_dynamic(abut_part_id part, bool& out) const {
  abut_motion motion = 0;
  const abut_status status = abut_part_motion(universe_.get(), part, &motion);
  out = motion == ABUT_MOTION_DYNAMIC;
  return status;
}

abut_status ResponseSource::has_margin(bool& out) const {
  std::size_t needed = 0;
  abut_status status = abut_universe_explain_json(universe_.get(), nullptr, 0, &needed);
  std::string plan(needed, ' ');
  if (status == ABUT_OK) status = abut_universe_explain_json(universe_.get(), plan.data(), plan.size(), &needed);
  out = plan.find("\"dead_band\"") == std::string::npos;
  return status;
}

bool ResponseSource::has_vertices(abut_geometry_id geometry) const {
  const std::string message = abut_last_error_message();
  const double* xyz = nullptr;
  std::size_t count = 0;
  const bool has_them = abut_geometry_vertices(universe_.get(), geometry, &xyz, &count) == ABUT_OK;
  if (!has_them) abut_set_last_error(ABUT_OK, message.c_str());
  return has_them;
}

abut_status ResponseSource::move_particles(abut_geometry_id geometry, std::span<const double> xyz) {
  abut_geometry_info info;
  abut_geometry_info_init(&info, sizeof info);
  const abut_status status = abut_geometry_describe(universe_.get(), geometry, &info);
  if (status != ABUT_OK) return status;
  using namespace response;
  const Matrix back = transposed(matrix_of(info.pose.orientation));
  std::vector<double> local;
  local.reserve(xyz.size());
  for (std::size_t i = 0; i + 2 < xyz.size(); i += 3) {
    const abut_vec3 at = times(back, subtract({xyz[i], xyz[i + 1], xyz[i + 2]}, info.pose.position));
    local.insert(local.end(), {at.x, at.y, at.z});
  }
  if (has_vertices(geometry))
    return abut_geometry_set_vertices(universe_.get(), geometry, 0, local.data(), local.size() / 3);
  return abut_geometry_set_particles(universe_.get(), geometry, 0, local.data(), nullptr, local.size() / 3);
}

abut_status ResponseSource::is_awake(abut_part_id part, bool& out) const {
  abut_motion motion = 0;
  std::uint32_t is_asleep = 0;
  abut_status status = abut_part_motion(universe_.get(), part, &motion);
  if (status == ABUT_OK) status = abut_part_is_asleep(universe_.get(), part, &is_asleep);
  out = status == ABUT_OK && motion == ABUT_MOTION_DYNAMIC && is_asleep == 0;
  return status;
}

abut_status ResponseSource::pose(abut_part_id part, abut_pose& out) const {
  return abut_part_pose(universe_.get(), part, &out);
}

abut_status ResponseSource::velocity(abut_part_id part, abut_velocity& out) const {
  return abut_part_velocity(universe_.get(), part, &out, nullptr);
}

abut_status ResponseSource::move(std::span<const abut_part_id> parts, std::span<const abut_pose> poses,
                                 std::span<const abut_velocity> velocities) {
  if (parts.empty()) return ABUT_OK;
  const abut_status status = abut_parts_set_poses(universe_.get(), parts.data(), poses.data(), parts.size());
  if (status != ABUT_OK) return status;
  return abut_parts_set_velocities(universe_.get(), parts.data(), velocities.data(), parts.size());
}

abut_status ResponseSource::advance(std::span<const abut_part_id> parts, std::span<const abut_velocity> velocities,
                                    std::span<const abut_acceleration> accelerations, double time, double& fraction,
                                    bool& is_impact) {
  abut_status status = ABUT_OK;
  if (!parts.empty())
    status = abut_parts_set_velocities(universe_.get(), parts.data(), velocities.data(), parts.size());
  if (!parts.empty() && status == ABUT_OK)
    status = abut_parts_set_accelerations(universe_.get(), parts.data(), accelerations.data(), parts.size());
  if (status != ABUT_OK) return status;
  abut_step_impact impact;
  status = abut_universe_advance_to_first_impact(universe_.get(), time, &impact);
  if (status != ABUT_OK) return status;
  fraction = impact.lower;
  is_impact = impact.geometry_a.slot != 0;
  return ABUT_OK;
}

abut_status ResponseSource::stop_accelerating(std::span<const abut_part_id> parts) {
  if (parts.empty()) return ABUT_OK;
  return abut_parts_set_accelerations(universe_.get(), parts.data(), nullptr, parts.size());
}

}  // namespace abut::capi
