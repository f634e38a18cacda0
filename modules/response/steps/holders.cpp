// SPDX-License-Identifier: Apache-2.0
// Mappings: what moves a point of a contact. A point of a part goes with its body, and a particle with itself. A point
// of a mesh goes with the particles that its vertices follow. One list of holders serves velocities and impulses.
module;

#include <abut/response.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

module abut.response;

namespace abut::response {

namespace {

// A particle that is a body holds a part of the point. One that is held is as good as the ground.
void hold(std::size_t first, const Grains& particles, std::uint32_t number, double weight,
          std::vector<Holder>& holders) {
  if (weight == 0 || number >= particles.masses.size() || !(particles.masses[number] > 0)) return;
  const auto body = static_cast<std::uint32_t>(first + number);
  const auto there = std::ranges::find(holders, body, &Holder::body);
  if (there != holders.end()) {
    there->weight += weight;
  } else {
    holders.push_back({.body = body, .weight = weight, .arm = {}});
  }
}

// Weights of the corners of a triangle for a point of it. Of a triangle without area, the nearest corner.
[[nodiscard]] std::array<double, 3> weights_in(const std::array<abut_vec3, 3>& corners, const abut_vec3& point) {
  const abut_vec3 u = subtract(corners[1], corners[0]), v = subtract(corners[2], corners[0]);
  const abut_vec3 way = subtract(point, corners[0]), normal = cross(u, v);
  const double area = dot(normal, normal);
  if (area > 0) {
    const double second = dot(cross(way, v), normal) / area, third = dot(cross(u, way), normal) / area;
    return {1 - second - third, second, third};
  }
  std::array<double, 3> weights{};
  const auto distance = [&](const abut_vec3& corner) { return length(subtract(point, corner)); };
  weights.at(static_cast<std::size_t>(std::ranges::min_element(corners, {}, distance) - corners.begin())) = 1;
  return weights;
}

// Surfaces lie half of a thickness in front of what has touched.
void thicken(abut_contact& record, double thickness) {
  const abut_vec3 half = scale(record.normal, 0.5 * thickness);
  record.point_a = add(record.point_a, half);
  record.point_b = subtract(record.point_b, half);
  record.distance -= thickness;
}

}  // namespace

const Surface* Simulation::surface_of(abut_geometry_id geometry) const {
  const auto found =
      std::ranges::find_if(surfaces_, [&](const Surface& its) { return is_same(its.geometry, geometry); });
  return found == surfaces_.end() ? nullptr : &*found;
}

abut_status Simulation::set_surface(Surface surface) {
  surfaces_.reserve(surfaces_.size() + 1);
  const abut_status status = source_->move_particles(surface.geometry, places_of(surface));
  if (status != ABUT_OK) return status;
  static_cast<void>(remove_surface(surface.geometry));
  surfaces_.push_back(std::move(surface));
  return ABUT_OK;
}

bool Simulation::remove_surface(abut_geometry_id geometry) {
  return std::erase_if(surfaces_, [&](const Surface& its) { return is_same(its.geometry, geometry); }) > 0;
}

void Simulation::remove_surfaces_on(abut_geometry_id carrier) {
  std::erase_if(surfaces_, [&](const Surface& its) { return is_same(its.carrier, carrier); });
}

std::vector<double> Simulation::places_of(const Surface& surface) const {
  const std::vector<double>& particles = particles_of(surface.carrier)->xyz;
  std::vector<double> out;
  out.reserve(3 * surface.nodes.size() / Surface::width);
  for (std::size_t first = 0; first < surface.nodes.size(); first += Surface::width) {
    abut_vec3 place{};
    for (std::size_t i = first; i < first + Surface::width; ++i)
      place = add(place, scale(vector_at(particles, surface.nodes[i]), surface.weights[i]));
    out.insert(out.end(), {place.x, place.y, place.z});
  }
  return out;
}

bool Simulation::follows_particles(abut_geometry_id geometry) const {
  return particles_of(geometry) != nullptr || surface_of(geometry) != nullptr;
}

// A vertex of a mesh by its own particle, or by those that it is the mean of.
void Simulation::hold_vertex(abut_geometry_id geometry, std::uint32_t vertex, double weight,
                             std::vector<Holder>& holders) const {
  const Surface* const surface = surface_of(geometry);
  std::size_t first = bodies_.size();
  for (const Grains& particles : grains_) {
    if (surface == nullptr && is_same(particles.geometry, geometry)) {
      hold(first, particles, vertex, weight, holders);
    } else if (surface != nullptr && is_same(particles.geometry, surface->carrier)) {
      const std::size_t from = Surface::width * std::size_t{vertex};
      for (std::size_t i = from; i < std::min(from + Surface::width, surface->nodes.size()); ++i)
        hold(first, particles, surface->nodes[i], weight * surface->weights[i], holders);
    }
    first += particles.masses.size();
  }
}

abut_status Simulation::hold_side(const GeometryFacts& facts, const Spot& spot, double sign, const Pass& pass,
                                  Sides& out) const {
  if (!follows_particles(facts.geometry)) return hold_part(facts.part, spot.point, sign, pass, out);
  out.has_particles = true;
  for (std::size_t i = 0; i < spot.count; ++i)
    hold_vertex(facts.geometry, spot.vertices.at(i), sign * spot.weights.at(i), out.holders);
  return ABUT_OK;
}

abut_status Simulation::skin_of(abut_geometry_id geometry, Skins& skins, const Skin*& out) const {
  const auto [place, is_new] = skins.try_emplace({geometry.slot, geometry.generation});
  out = &place->second;
  return is_new ? source_->skin(geometry, place->second) : ABUT_OK;
}

// Where a geometry is touched: the particle, or the corners of the triangle.
abut_status Simulation::find_spot(abut_geometry_id geometry, const abut_feature& feature, std::uint32_t child,
                                  const abut_vec3& point, Skins& skins, Spot& out) const {
  out.point = point;
  if (!follows_particles(geometry)) return ABUT_OK;
  out.count = 1;
  out.vertices = {child};
  out.weights = {1};
  if (feature.kind != ABUT_FEATURE_FACE) return ABUT_OK;
  const Skin* skin = nullptr;
  if (const abut_status status = skin_of(geometry, skins, skin); status != ABUT_OK) return status;
  const std::size_t first = 3 * std::size_t{feature.index};
  std::array<abut_vec3, 3> corners{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    out.vertices.at(i) = skin->triangles.at(first + i);
    corners.at(i) = vector_at(skin->xyz, out.vertices.at(i));
  }
  const std::array<double, 3> weights = weights_in(corners, point);
  std::ranges::copy(weights, out.weights.begin());
  out.count = corners.size();
  out.is_bent = true;
  return ABUT_OK;
}

abut_status Simulation::find_meetings(std::vector<Meeting>& out) const {
  Skins skins;
  std::vector<abut_contact> contacts;
  abut_status status = source_->contacts(contacts);
  for (std::size_t i = 0; status == ABUT_OK && i < contacts.size(); ++i) {
    const abut_contact& record = contacts[i];
    if ((record.flags & ABUT_CONTACT_SENSOR) != 0) continue;
    Meeting& its = out.emplace_back();
    its.record = record;
    status = find_spot(record.geometry_a, record.feature_a, record.child_a, record.point_a, skins, its.a);
    if (status == ABUT_OK)
      status = find_spot(record.geometry_b, record.feature_b, record.child_b, record.point_b, skins, its.b);
    double thickness = 0;
    if (status == ABUT_OK && (its.a.is_bent || its.b.is_bent))
      status = source_->contact_distance(record.geometry_a, record.geometry_b, thickness);
    if (thickness > 0) thicken(its.record, thickness);
  }
  std::vector<abut_element_contact> elements;
  if (status == ABUT_OK) status = source_->element_contacts(elements);
  for (std::size_t i = 0; status == ABUT_OK && i < elements.size(); ++i) status = add_meeting(elements[i], skins, out);
  for (Meeting& its : out) {
    // Whoever is bent receives the impulse at the very point that its weights make.
    const abut_vec3& of_bent = its.a.is_bent ? its.a.point : its.b.point;
    its.point = its.a.is_bent == its.b.is_bent ? scale(add(its.a.point, its.b.point), 0.5) : of_bent;
    its.a.point = its.b.point = its.point;
  }
  return status;
}

// A stencil as a contact.
abut_status Simulation::add_meeting(const abut_element_contact& element, Skins& skins,
                                    std::vector<Meeting>& out) const {
  const abut_stencil& stencil = element.stencil;
  GeometryFacts facts_a, facts_b;
  abut_status status = source_->facts(element.geometry_a, facts_a);
  if (status == ABUT_OK) status = source_->facts(element.geometry_b, facts_b);
  const Skin *skin_a = nullptr, *skin_b = nullptr;
  if (status == ABUT_OK) status = skin_of(element.geometry_a, skins, skin_a);
  if (status == ABUT_OK) status = skin_of(element.geometry_b, skins, skin_b);
  if (status != ABUT_OK || ((facts_a.flags | facts_b.flags) & ABUT_GEOMETRY_SENSOR) != 0) return status;
  Meeting& its = out.emplace_back();
  for (std::size_t i = 0; i < Spot::most; ++i) {
    const bool is_of_a = i < stencil.of_a;
    Spot& spot = is_of_a ? its.a : its.b;
    const double weight = is_of_a ? -stencil.weights[i] : stencil.weights[i];
    if (weight == 0) continue;
    spot.point = add(spot.point, scale(vector_at((is_of_a ? skin_a : skin_b)->xyz, stencil.vertices[i]), weight));
    spot.vertices.at(spot.count) = stencil.vertices[i];
    spot.weights.at(spot.count++) = weight;
  }
  abut_contact& record = its.record;
  record.geometry_a = element.geometry_a;
  record.geometry_b = element.geometry_b;
  record.id = element.id;
  record.age = element.age;
  record.point_a = its.a.point;
  record.point_b = its.b.point;
  record.normal = stencil.normal;
  record.tangent = across(stencil.normal);
  record.distance = stencil.distance;
  record.material_a = facts_a.material;
  record.material_b = facts_b.material;
  thicken(record, stencil.distance - element.gap);
  its.a.is_bent = follows_particles(element.geometry_a);
  its.b.is_bent = follows_particles(element.geometry_b);
  return ABUT_OK;
}

}  // namespace abut::response
