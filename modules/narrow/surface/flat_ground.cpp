// SPDX-License-Identifier: Apache-2.0
module abut.narrow.surface.flat_ground;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.surface.flat_patch;

namespace abut {

void FlatGround::name(std::span<ContactPoint> contacts) const {
  for (ContactPoint& contact : contacts) {
    contact.id = contact_id_of_part(contact.id, no_index);
    contact.feature_a = {FeatureKind::face, triangle_};
  }
}

namespace {

// Ground that is thinner than this share of the size of a shape counts as flat. Rounding to float makes it thicker: by
// half a unit in the last place of each coordinate, in three directions.
constexpr Real thickness_share = 1e-6, rounding_of_floats = 0x1p-22, most_thickness_share = 4e-6;
Real most_thickness(Real size, Real coordinate) {
  return std::min(thickness_share * size + rounding_of_floats * coordinate, most_thickness_share * size);
}

// A triangle with an area whose box overlaps a box.
std::optional<Triangle> triangle_within(const TriangleSource& surface, const Aabb& box, const Vec3& near) {
  const Triangle first = surface.part_near(near);
  if (first.has_area() && first.box().overlaps(box)) [[likely]] {
    return first;
  }
  std::optional<Triangle> found;
  const auto look = [&found](const FourTriangles& triangles, std::uint64_t some) {
    for (; some != 0 && !found; some &= some - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(some));
      const Triangle triangle(triangles[lane], std::span(triangles.numbers)[lane], false);
      found = triangle.has_area() ? std::optional(triangle) : std::nullopt;
    }
    return !found;
  };
  surface.visit(box, look);
  return found;
}

// Whether a neighbour across an edge that meets a box leaves the plane of a triangle. Most ground that is not flat is
// told by one triangle.
bool bends_at(const TriangleSource& surface, const Triangle& triangle, const Aabb& box, Real thickness) {
  const Aabb its = triangle.box();
  const Vec3 size = its.high - its.low, &n = triangle.normal();
  const Real height = thickness + 8 * FlatPatch::lean * (size.x + size.y + size.z);
  constexpr std::array<unsigned, 3> edges{0b011, 0b110, 0b101};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &from = triangle.corner(static_cast<std::uint32_t>(i)),
               &to = triangle.corner(static_cast<std::uint32_t>((i + 1) % 3));
    if (box.overlaps({minimum(from, to), maximum(from, to)}) &&
        !(surface.is_crest(triangle.index(), edges[i], n, height) &&
          surface.is_crest(triangle.index(), edges[i], -n, height))) {
      return true;
    }
  }
  return false;
}

// How far a shape reaches behind the front of a slab, and before its back.
struct Depths {
  Real front, back;
  [[nodiscard]] Real least(bool is_in_front) const { return is_in_front ? front : back; }
};
Depths depths_in(const GroundSlab& slab, const Extremes& extremes, Real radius) {
  return {slab.high - dot(slab.normal, extremes.lowest) + radius,
          dot(slab.normal, extremes.highest) + radius - slab.low};
}

// A point of the middle of a slab, in a shape that overlaps it, or below one that is apart.
Vec3 point_in(const GroundSlab& slab, const Extremes& extremes) {
  const Real middle = 0.5 * (slab.low + slab.high), low = dot(slab.normal, extremes.lowest),
             high = dot(slab.normal, extremes.highest);
  const Real share = high > low ? std::clamp((middle - low) / (high - low), Real{0}, Real{1}) : 0;
  const Vec3 inside = extremes.lowest + share * (extremes.highest - extremes.lowest);
  return inside + (middle - dot(slab.normal, inside)) * slab.normal;
}

// Of a solid: whether it fills one side of flat ground that parts two points.
bool fills_below(const TriangleSource& surface, const Vec3& below, const Vec3& above) {
  return surface.contains(below) && !surface.contains(above);
}

}  // namespace

std::optional<FlatGround> flat_ground(const TriangleSource& surface, const GroundBody& body, Real margin,
                                      Real most_gap) {
  const StoppingSides sides = surface.sides();
  const Real coordinate = largest_magnitude(body.centre) + 2 * body.size, noise = noise_of(coordinate),
             thickness = most_thickness(body.size, coordinate);
  const Aabb near = body.box.inflated(margin + noise);
  const std::optional<Triangle> seed = triangle_within(surface, near, body.centre);
  if (!seed || bends_at(surface, *seed, near, thickness + noise)) {
    return std::nullopt;
  }
  // If both sides are as near, the front counts.
  const auto is_in_front = [&](const Depths& depths) {
    return sides != StoppingSides::both || depths.front <= depths.back + tie_share * body.size;
  };
  const Real level = dot(seed->normal(), seed->corners()[0]);
  const GroundSlab plane{seed->normal(), level, level};
  const Extremes of_plane = body.along(plane.normal);
  const Depths in_plane = depths_in(plane, of_plane, body.radius);
  const Real depth_in_plane = in_plane.least(is_in_front(in_plane));
  // A front does not hold a core that has passed it.
  if (-depth_in_plane > most_gap || (sides == StoppingSides::front && !(in_plane.back - body.radius > noise))) {
    return std::nullopt;
  }
  // Grown in steps, so that the rounding of the plane has no say in which triangles are looked at. A point at the
  // origin has no size and no rounding.
  const Real step = std::max(body.size / 1024, 64 * noise);
  const Real reach = std::max(std::fabs(depth_in_plane), margin);
  const Real grown = step > 0 ? step * (1 + std::ceil(reach / step)) : reach;
  const VisitFours visit = [&surface](const Aabb& box, const TakeFour& take) { surface.visit(box, take); };
  [[clang::uninitialized]] FlatPatch patch(
      visit, {*seed, body.box.inflated(grown), thickness, noise, sides != StoppingSides::both});
  const std::optional<GroundSlab> slab = patch.slab();
  if (!slab) {
    return std::nullopt;
  }
  const Extremes extremes = slab->normal == plane.normal ? of_plane : body.along(slab->normal);
  const Depths depths = depths_in(*slab, extremes, body.radius);
  const bool front = is_in_front(depths);
  if (!(std::fabs(depths.least(front)) <= grown)) {
    return std::nullopt;
  }
  const Vec3 &n = slab->normal, point = point_in(*slab, extremes);
  const std::optional<std::uint32_t> triangle = patch.triangle_at(point, std::max(step / 64, 8 * noise));
  if (!triangle ||
      (sides == StoppingSides::solid && !fills_below(surface, point - 0.5 * step * n, point + 0.5 * step * n))) {
    return std::nullopt;
  }
  return FlatGround(front ? n : -n, front ? slab->high : -slab->low, slab->high - slab->low, noise, *triangle);
}

}  // namespace abut
