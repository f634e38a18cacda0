// SPDX-License-Identifier: Apache-2.0
#include "shade.hpp"

#include <algorithm>
#include <array>

namespace demo {
namespace {

constexpr Colour sunlight{3.0, 2.72, 2.25};
constexpr Colour skylight{0.52, 0.66, 0.92};
constexpr Colour haze{0.40, 0.55, 0.78};
constexpr double haze_distance = 45'000.0;  // metres in which the air swallows 1 - 1/e of the light

struct Stop {
  double at;
  Colour colour;
};

// Elevation tints from the valley to the crest.
constexpr std::array<Stop, 6> tints{{{0.00, {0.050, 0.150, 0.050}},
                                     {0.12, {0.090, 0.200, 0.055}},
                                     {0.30, {0.200, 0.260, 0.080}},
                                     {0.50, {0.330, 0.300, 0.115}},
                                     {0.72, {0.360, 0.235, 0.120}},
                                     {1.00, {0.560, 0.460, 0.360}}}};

Colour tint(double t) {
  for (std::size_t i = 1; i < tints.size(); ++i) {
    if (t <= tints[i].at) {
      return mix(tints[i - 1].colour, tints[i].colour, (t - tints[i - 1].at) / (tints[i].at - tints[i - 1].at));
    }
  }
  return tints.back().colour;
}

double lattice(std::int64_t x, std::int64_t y) {
  const auto key = static_cast<std::uint64_t>(x * 0x1f1f1f1f + y * 0x2545f491);
  return Random(key).uniform(-1.0, 1.0);
}

// Value noise in [-1, 1]; one unit is the distance between the nodes.
double noise(double x, double y) {
  const double floor_x = std::floor(x);
  const double floor_y = std::floor(y);
  const auto i = static_cast<std::int64_t>(floor_x);
  const auto j = static_cast<std::int64_t>(floor_y);
  const auto smooth = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const double u = smooth(x - floor_x);
  const double v = smooth(y - floor_y);
  const double south = lattice(i, j) * (1.0 - u) + lattice(i + 1, j) * u;
  const double north = lattice(i, j + 1) * (1.0 - u) + lattice(i + 1, j + 1) * u;
  return south * (1.0 - v) + north * v;
}

Colour ground(const Terrain& terrain, const Vec3& p, const Vec3& normal, double footprint) {
  const double t = (p.z - terrain.lowest()) / (terrain.highest() - terrain.lowest());
  double mottle = 0.0;
  double weight = 0.10;
  for (const double scale : {310.0, 97.0, 31.0}) {
    // An octave finer than a pixel would only flicker.
    mottle += weight * std::clamp(scale / (4.0 * footprint), 0.0, 1.0) * noise(p.x / scale, p.y / scale);
    weight *= 0.8;
  }
  const double steep = std::clamp((0.93 - normal.z) / 0.16, 0.0, 1.0);
  const Colour base = mix(tint(std::clamp(t + 0.35 * mottle, 0.0, 1.0)), Colour{0.33, 0.27, 0.19}, 0.35 * steep);

  // Contour lines every 50 m, about a pixel wide.
  const double interval = 50.0;
  const double off = std::abs(p.z / interval - std::round(p.z / interval)) * interval;
  const double slope = std::sqrt(std::max(0.0, 1.0 - normal.z * normal.z)) / normal.z;
  const double width = std::max(footprint, 1.5) * std::max(slope, 0.02);
  const double line = std::clamp(1.0 - off / width, 0.0, 1.0) * std::clamp(12.0 / footprint, 0.0, 1.0);
  return base * (1.0 + mottle) * (1.0 - 0.28 * line);
}

Vec3 sun_direction() { return normalised({-0.7, 0.5, 0.42}); }  // low in the north-west, as on maps

// Light from the sky along a unit direction.
Colour sky(const Vec3& direction) {
  const double up = std::clamp(direction.z, 0.0, 1.0);
  const double t = 1.0 - (1.0 - up) * (1.0 - up) * (1.0 - up);
  const Colour blue = mix(haze, Colour{0.09, 0.24, 0.60}, std::min(1.0, 2.2 * t));
  const double towards_sun = std::max(0.0, dot(direction, sun_direction()));
  const double glow = towards_sun * towards_sun * towards_sun * towards_sun;
  return blue + Colour{0.35, 0.27, 0.14} * (0.6 * glow);
}

}  // namespace

Vec3 Hillside::sun() const { return sun_direction(); }

Colour colour_of(Kind kind) {
  switch (kind) {
    case Kind::terrain: return {0.29, 0.31, 0.125};
    case Kind::sphere: return {0.62, 0.055, 0.04};
    case Kind::box: return {0.78, 0.30, 0.03};
    case Kind::capsule: return {0.02, 0.34, 0.34};
    case Kind::hull: return {0.24, 0.10, 0.42};
    case Kind::compound: return {0.05, 0.17, 0.50};
    case Kind::bunny_mesh: return {0.78, 0.75, 0.68};
    case Kind::bunny_hull: return {0.72, 0.25, 0.36};
    case Kind::statue: return {0.42, 0.40, 0.37};
    case Kind::cloth: return {0.62, 0.05, 0.12};
  }
  return {0.0, 0.0, 0.0};
}

// Smooth on the terrain.
Vec3 Hillside::normal(const abut_ray& ray, const abut_pick& pick) const {
  const bool terrain = scene_->owner(pick.geometry).kind == Kind::terrain;
  const Vec3 raw = terrain ? scene_->terrain().normal(pick.point.x, pick.point.y) : pick.normal;
  return !terrain && dot(raw, ray.direction) > 0.0 ? raw * -1.0 : raw;
}

Colour Hillside::shade(const abut_ray& ray, const abut_pick& pick, const Light& light, double pixel) const {
  const Vec3 view = normalised(ray.direction);
  if (pick.geometry.slot == 0) {
    return sky(view);
  }
  const Kind kind = scene_->owner(pick.geometry).kind;
  const Vec3 towards = normal(ray, pick);
  const Colour albedo =
      kind == Kind::terrain ? ground(scene_->terrain(), pick.point, towards, pixel * pick.distance) : colour_of(kind);
  const double sun = light.sun * std::max(0.0, dot(towards, sun_direction()));
  const double dome = light.sky * (0.6 + 0.4 * towards.z);
  Colour result = albedo * (sunlight * (0.52 * sun) + skylight * (0.26 * dome));
  if (kind != Kind::terrain) {
    const Vec3 half = normalised(sun_direction() - view);
    const double shine = std::pow(std::max(0.0, dot(towards, half)), 40.0);
    result = result + sunlight * (0.10 * light.sun * shine);
  }
  const double air = std::exp(-pick.distance / haze_distance);
  return mix(sky({view.x, view.y, 0.0}), result, air * air * (3.0 - 2.0 * air));
}

// The terrain is lit by smooth normals, so the steps between its flat triangles must not show as shadows: it casts none
// on itself nearby.
bool Hillside::lets_through(const abut_pick& from, const abut_pick& hit) const {
  constexpr double nearby = 250.0;
  const auto is_terrain = [&](const abut_pick& pick) { return scene_->owner(pick.geometry).kind == Kind::terrain; };
  return hit.distance < nearby && is_terrain(hit) && is_terrain(from);
}

}  // namespace demo
