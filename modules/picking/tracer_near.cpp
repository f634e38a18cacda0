// What lies nearest to a point of a picture when nothing lies under it.
module;

#include <abut/picking.h>

#include "embree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

module abut.picking;
import :camera;
import :source;
import :surface;
import :tracer;
import :vector;

namespace abut::picking {

namespace {

// A point of the picture relative to the one asked for, in pixels.
struct Offset {
  double x;
  double y;
};

[[nodiscard]] double size_of(const Offset& offset) {
  return std::sqrt(offset.x * offset.x + offset.y * offset.y);
}

// The picture around a point: pixel offsets of what lies in front of the eye.
struct Sight {
  View view;
  double x;
  double y;
  double radius;

  // Right, up and depth of a point of the world.
  [[nodiscard]] abut_vec3 seen(const abut_vec3& p) const {
    const abut_vec3 from_eye = subtract(p, view.eye);
    return {dot(from_eye, view.right), dot(from_eye, view.up), dot(from_eye, view.forward)};
  }
  [[nodiscard]] Offset offset_of(const abut_vec3& seen) const {
    return {view.centre_x + view.focal * seen.x / seen.z - x, view.centre_y - view.focal * seen.y / seen.z - y};
  }
  // A sphere around a box against the cone of the radius around the point.
  [[nodiscard]] bool may_show(const abut_aabb& box) const {
    const double around = 0.5 * diagonal_of(box);
    const abut_vec3 centre = subtract(centre_of(box), view.eye);
    const abut_vec3 axis = normalized(direction_through(view, x, y));
    const double along = dot(centre, axis);
    if (along < -around) return false;
    // Twice the tangent of the radius at the centre of the picture: enough also for an oblique sight.
    const double spread = 2 * radius / view.focal;
    return length(cross(centre, axis)) <= spread * (along + around) + around * (1 + spread);
  }
};

[[nodiscard]] Offset between(const Offset& a, const Offset& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

// Point of a segment nearest to the origin.
[[nodiscard]] Offset nearest_on(const Offset& a, const Offset& b) {
  const Offset along{b.x - a.x, b.y - a.y};
  const double square = along.x * along.x + along.y * along.y;
  const double t = square == 0 ? 0 : std::clamp(-(a.x * along.x + a.y * along.y) / square, 0.0, 1.0);
  return between(a, b, t);
}

// A place to try, and a place further inside, towards which to go when the outline itself is missed.
struct Candidate {
  double size = infinity;
  Offset nearest{};
  Offset inside{};
};

void improve(Candidate& best, const Offset& nearest, const Offset& inside) {
  const double size = size_of(nearest);
  if (size < best.size) best = {size, nearest, inside};
}

// Triangle in view coordinates, cut where it comes too close to the plane of the eye.
void look_at_triangle(const Sight& sight, const std::array<abut_vec3, 3>& seen, Candidate& best) {
  const double deepest = std::max({seen[0].z, seen[1].z, seen[2].z});
  if (deepest <= 0) return;
  const double cut = 1e-6 * deepest;
  std::array<Offset, 4> outline{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const abut_vec3& a = seen[i];
    const abut_vec3& b = seen[(i + 1) % 3];
    if (a.z >= cut) outline[count++] = sight.offset_of(a);
    if ((a.z >= cut) != (b.z >= cut)) {
      const double t = (cut - a.z) / (b.z - a.z);
      const abut_vec3 between_them = add(a, scale(subtract(b, a), t));
      outline[count++] = sight.offset_of({between_them.x, between_them.y, cut});
    }
  }
  if (count == 0) return;
  Offset inside{0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    inside.x += outline[i].x / static_cast<double>(count);
    inside.y += outline[i].y / static_cast<double>(count);
  }
  for (std::size_t i = 0; i < count; ++i) improve(best, nearest_on(outline[i], outline[(i + 1) % count]), inside);
}

// Point of a sphere, in view coordinates, whose picture is nearest: the normal there points against
// the gradient of the distance in the picture.
void look_at_sphere(const Sight& sight, const abut_vec3& centre, double radius, Candidate& best) {
  if (centre.z <= radius) return;
  const double focal = sight.view.focal;
  const double aim_x = (sight.x - sight.view.centre_x) / focal;
  const double aim_y = (sight.view.centre_y - sight.y) / focal;
  abut_vec3 point = centre;
  for (int step = 0; step < 40; ++step) {
    const double px = point.x / point.z - aim_x;
    const double py = point.y / point.z - aim_y;
    const abut_vec3 gradient{px, py, -(px * point.x + py * point.y) / point.z};
    if (largest_component(gradient) == 0) break;
    point = add(centre, scale(normalized(gradient), -radius));
  }
  improve(best, sight.offset_of(point), sight.offset_of(centre));
}

// A capsule is a row of spheres; the distance in the picture along it has one valley.
void look_at_rounded(const Sight& sight, const Frame& frame, const RoundedSegment& rounded, Candidate& best) {
  const auto at = [&](double z) {
    Candidate candidate;
    look_at_sphere(sight, sight.seen(to_world(frame, {0, 0, z})), rounded.radius, candidate);
    return candidate;
  };
  double low = -rounded.half_height;
  double high = rounded.half_height;
  const double golden = 1 / std::numbers::phi;
  for (int step = 0; step < 40 && high > low; ++step) {
    const double width = golden * (high - low);
    if (at(high - width).size <= at(low + width).size) {
      high = low + width;
    } else {
      low = high - width;
    }
  }
  const Candidate found = at(0.5 * (low + high));
  if (found.size < best.size) best = found;
}

[[nodiscard]] abut_ray ray_at(const Sight& sight, const Offset& offset) {
  return ray_through(sight.view, sight.x + offset.x, sight.y + offset.y);
}

// Tries the outline first, then places ever further inside.
[[nodiscard]] bool try_candidate(const Tracer& tracer, const Sight& sight, const Candidate& candidate, abut_pick& out) {
  for (const double t : {0.0, 1e-6, 1e-4, 1e-2, 0.1}) {
    tracer.trace(ray_at(sight, between(candidate.nearest, candidate.inside, t)), out);
    if (out.geometry.slot != 0) return true;
  }
  return false;
}

// Rings of rays at half a pixel, or coarser when the radius is large; the first hit is followed
// inwards by bisection.
void search_rings(const Tracer& tracer, const Sight& sight, double radius, abut_pick& out) {
  constexpr double rings = 64;
  const double gap = std::max(0.5, radius / rings);
  for (double r = std::min(gap, radius); r <= radius && r > 0; r += gap) {
    const auto count = static_cast<int>(std::ceil(2 * std::numbers::pi * r / gap));
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      Offset hit{r * std::cos(angle), r * std::sin(angle)};
      abut_pick pick = nothing();
      tracer.trace(ray_at(sight, hit), pick);
      if (pick.geometry.slot == 0) continue;
      Offset miss{0, 0};
      out = pick;
      for (int step = 0; step < 20; ++step) {
        const Offset middle = between(miss, hit, 0.5);
        tracer.trace(ray_at(sight, middle), pick);
        if (pick.geometry.slot == 0) {
          miss = middle;
        } else {
          hit = middle;
          out = pick;
        }
      }
      return;
    }
  }
}

}  // namespace

// Outlines of triangles, spheres and capsules are found in closed form, so that thin things are not
// missed. What has none of these is looked for by rays in rings.
abut_status Tracer::pick_near(const View& view, double x, double y, double radius, abut_pick& out) const {
  const Sight sight{view, x, y, radius};
  std::vector<Candidate> candidates;
  bool has_others = false;
  for (const Entry& entry : entries_) {
    if (entry.id.slot == 0) continue;
    const ShapeRecord& shape = shapes_[entry.shape];
    if (entry.role == Role::endless) has_others = true;
    if (entry.role == Role::endless || !sight.may_show(entry.box)) continue;
    Candidate best;
    if (shape.triangle_count != 0) {
      TriangleList list;
      if (const abut_status status = shape.access->triangles(list); status != ABUT_OK) return status;
      std::vector<abut_vec3> seen;
      seen.reserve(list.xyz.size() / 3);
      for (std::size_t i = 0; i + 2 < list.xyz.size(); i += 3) {
        seen.push_back(sight.seen(to_world(entry.frame, {list.xyz[i], list.xyz[i + 1], list.xyz[i + 2]})));
      }
      for (std::size_t i = 0; i + 2 < list.indices.size(); i += 3) {
        look_at_triangle(sight, {seen[list.indices[i]], seen[list.indices[i + 1]], seen[list.indices[i + 2]]}, best);
      }
    } else if (const auto rounded = shape.access->rounded()) {
      look_at_rounded(sight, entry.frame, *rounded, best);
    } else {
      has_others = true;
    }
    if (best.size <= radius) candidates.push_back(best);
  }
  std::ranges::sort(candidates, {}, &Candidate::size);
  double found_at = radius;
  for (const Candidate& candidate : candidates) {
    if (try_candidate(*this, sight, candidate, out)) {
      found_at = candidate.size;
      break;
    }
  }
  if (has_others || (out.geometry.slot == 0 && !candidates.empty())) search_rings(*this, sight, found_at, out);
  return ABUT_OK;
}

}  // namespace abut::picking
