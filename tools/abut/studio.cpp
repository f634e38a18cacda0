// SPDX-License-Identifier: Apache-2.0
#include "studio.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cli {
namespace {

constexpr Colour sunlight{2.3, 2.2, 2.05};
constexpr Colour skylight{0.80, 0.88, 1.0};

constexpr std::array<Colour, 16> colours{{{0.62, 0.055, 0.04},
                                          {0.78, 0.30, 0.03},
                                          {0.02, 0.34, 0.34},
                                          {0.36, 0.38, 0.40},
                                          {0.24, 0.10, 0.42},
                                          {0.62, 0.60, 0.54},
                                          {0.24, 0.30, 0.12},
                                          {0.72, 0.25, 0.36},
                                          {0.10, 0.42, 0.12},
                                          {0.55, 0.45, 0.05},
                                          {0.05, 0.17, 0.50},
                                          {0.30, 0.12, 0.06},
                                          {0.50, 0.05, 0.30},
                                          {0.03, 0.22, 0.15},
                                          {0.45, 0.22, 0.45},
                                          {0.12, 0.12, 0.15}}};

// 1, 2 or 5 times a power of ten, not above a length.
double round_length(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  return power * (most >= 5.0 * power ? 5.0 : most >= 2.0 * power ? 2.0 : 1.0);
}

// How much of a pixel a line covers that lies at every multiple of the step.
double line_at(double coordinate, double step, double footprint) {
  const double off = std::abs(coordinate / step - std::round(coordinate / step)) * step;
  const double fade = std::clamp(step / (6.0 * footprint) - 0.5, 0.0, 1.0);
  return fade * std::clamp(1.3 - off / footprint, 0.0, 1.0);
}

}  // namespace

Colour colour_of(abut_shape_kind kind) {
  std::size_t index = 0;
  while (index + 1 < abut_shape_kind_count() && abut_shape_kind_at(index) != kind) {
    ++index;
  }
  return colours.at(index % colours.size());
}

Studio::Studio(const World& world, const View& view) : world_(&world), view_(view) {
  const Vec3 back = normalised(view.eye - view.target);
  const Vec3 right = normalised(cross(view.up, back));
  sun_ = normalised(view.up * 0.9 - right * 0.55 + cross(right, view.up) * 0.5);
}

Reach Studio::reach() const { return {5e-4 * view_.radius, 0.5 * view_.radius, 1e4 * view_.radius}; }

Vec3 Studio::normal(const abut_ray& ray, const abut_pick& pick) const {
  return dot(pick.normal, ray.direction) > 0.0 ? pick.normal * -1.0 : pick.normal;
}

bool Studio::lets_through(const abut_pick& /*from*/, const abut_pick& /*hit*/) const { return false; }

Colour Studio::background(const Vec3& direction) const {
  const double t = std::clamp(0.5 + 0.9 * dot(direction, view_.up), 0.0, 1.0);
  return mix(Colour{0.55, 0.60, 0.66}, Colour{0.16, 0.25, 0.40}, t);
}

Colour Studio::surface(const abut_pick& pick, double footprint) const {
  const Geometry& geometry = world_->scene().geometries[world_->number_of(pick.geometry)];
  const abut_shape_kind kind = abut_shape_kind_of(geometry.shape);
  const bool is_still = world_->scene().parts[geometry.part].motion == ABUT_MOTION_STATIC;
  const Colour own = is_still ? mix(colour_of(kind), {0.34, 0.35, 0.36}, 0.4) : colour_of(kind);
  if (kind != abut_shape_kind_by_name("plane")) {
    return own;
  }
  const double step = round_length(0.5 * view_.radius);
  const Vec3 axis = std::abs(pick.normal.x) < 0.7 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
  const Vec3 along = normalised(axis - pick.normal * dot(axis, pick.normal));
  const double line = std::max(line_at(dot(pick.point, along), step, footprint),
                               line_at(dot(pick.point, cross(pick.normal, along)), step, footprint));
  return own * (1.0 - 0.45 * line);
}

Colour Studio::shade(const abut_ray& ray, const abut_pick& pick, const Light& light, double pixel) const {
  const Vec3 view = normalised(ray.direction);
  if (pick.geometry.slot == 0) {
    return background(view);
  }
  const Vec3 towards = normal(ray, pick);
  const double sun = light.sun * std::max(0.0, dot(towards, sun_));
  const double dome = light.sky * (0.65 + 0.35 * dot(towards, view_.up));
  const double slant = std::max(0.05, -dot(view, towards));
  const Colour albedo = surface(pick, pixel * pick.distance / slant);
  const Vec3 half = normalised(sun_ - view);
  const double shine = std::pow(std::max(0.0, dot(towards, half)), 40.0);
  const Colour lit =
      albedo * (sunlight * (0.55 * sun) + skylight * (0.36 * dome)) + sunlight * (0.06 * light.sun * shine);
  const double air = std::exp(-pick.distance / (20.0 * length(view_.eye - view_.target)));
  return mix(background(view), lit, air);
}

}  // namespace cli
