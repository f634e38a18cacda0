// SPDX-License-Identifier: Apache-2.0
#include "motion.hpp"

#include <algorithm>

namespace demo {
namespace {

constexpr double gravity = 9.81;       // m / s^2
constexpr double drag = 0.8;           // 1 / s: the final speed is gravity * slope / drag
constexpr double sinking = 0.07;       // of the radius
constexpr double first_spacing = 1.1;  // of the sum of two radii

// The slopes in view: spurs between a plateau and the valley of the Jacksboro fault.
constexpr double area_x = 950.0;
constexpr double area_y = -750.0;
constexpr double area_half_side = 2150.0;  // for 2,000 bodies; others get the same room each

struct Ground {
  Vec3 point;
  Vec3 normal;
};

// The plane under a disc on the ground, by its centre and four points of its rim.
Ground ground_under(const Terrain& terrain, double x, double y, double radius) {
  const double east = terrain.height(x + radius, y);
  const double west = terrain.height(x - radius, y);
  const double north = terrain.height(x, y + radius);
  const double south = terrain.height(x, y - radius);
  const double mean = 0.25 * (east + west + north + south);
  const double z = 0.5 * (mean + terrain.height(x, y));
  return {{x, y, z}, normalised({west - east, south - north, 2.0 * radius})};
}

bool is_free(const std::vector<Slider>& placed, const Slider& candidate) {
  return std::none_of(placed.begin(), placed.end(), [&](const Slider& other) {
    const double dx = other.x - candidate.x;
    const double dy = other.y - candidate.y;
    const double apart = first_spacing * (other.radius + candidate.radius);
    return dx * dx + dy * dy < apart * apart;
  });
}

}  // namespace

std::vector<Slider> lay_out(const Catalogue& catalogue, const Terrain& terrain, std::size_t count, Random& random) {
  const double half = area_half_side * std::sqrt(static_cast<double>(count) / 2000.0);
  const double west = std::max(area_x - half, -0.9 * terrain.half_width());
  const double east = std::min(area_x + half, 0.9 * terrain.half_width());
  const double south = std::max(area_y - half, -0.9 * terrain.half_depth());
  const double north = std::min(area_y + half, 0.9 * terrain.half_depth());
  std::vector<Slider> placed;
  placed.reserve(count);
  while (placed.size() < count) {
    const std::size_t design = catalogue.choose(random);
    Slider slider{design,          catalogue.design(design).radius, 0.0, 0.0, 0.0, 0.0,
                  {1.0, 0.0, 0.0}, random.uniform(-0.01, 0.01)};
    const Vec3 d = random.direction();
    if (d.x * d.x + d.y * d.y > 0.01) {
      slider.heading = normalised({d.x, d.y, 0.0});
    }
    // Where the ground is full, the last try stands.
    constexpr int tries = 40;
    for (int i = 0; i < tries; ++i) {
      slider.x = random.uniform(west, east);
      slider.y = random.uniform(south, north);
      if (is_free(placed, slider)) {
        break;
      }
    }
    placed.push_back(slider);
  }
  return placed;
}

void advance(Slider& slider, const Terrain& terrain) {
  const Vec3 normal = ground_under(terrain, slider.x, slider.y, 2.0 * slider.radius).normal;
  // On an incline with the unit normal n, gravity accelerates along the horizontal by g * n.z * (n.x, n.y).
  slider.velocity_x += step_seconds * (gravity * normal.z * normal.x - drag * slider.velocity_x);
  slider.velocity_y += step_seconds * (gravity * normal.z * normal.y - drag * slider.velocity_y);
  slider.x = std::clamp(slider.x + step_seconds * slider.velocity_x, -0.95 * terrain.half_width(),
                        0.95 * terrain.half_width());
  slider.y = std::clamp(slider.y + step_seconds * slider.velocity_y, -0.95 * terrain.half_depth(),
                        0.95 * terrain.half_depth());
  // A rotation by 2 * atan(t) has the cosine (1 - t^2) / (1 + t^2) and the sine 2 t / (1 + t^2).
  const double t = slider.spin;
  const double scale = 1.0 / (1.0 + t * t);
  const double cosine = (1.0 - t * t) * scale;
  const double sine = 2.0 * t * scale;
  const Vec3 h = slider.heading;
  slider.heading = normalised({cosine * h.x - sine * h.y, sine * h.x + cosine * h.y, 0.0});
}

abut_pose pose_of(const Slider& slider, const Terrain& terrain) {
  const Ground ground = ground_under(terrain, slider.x, slider.y, slider.radius);
  const Vec3 up = ground.normal;
  const Vec3 forward = normalised(slider.heading - up * dot(slider.heading, up));
  return {ground.point - up * (sinking * slider.radius), from_axes(forward, cross(up, forward), up)};
}

}  // namespace demo
