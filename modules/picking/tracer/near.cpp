// SPDX-License-Identifier: Apache-2.0
// What lies under a point of a picture, or nearest to it when nothing lies there.
module;

#include <abut/picking.h>

#include "picking/embree.hpp"

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
import :entry;
import :outline;
import :source;
import :surface;
import :tracer;
import :vector;

namespace abut::picking {

namespace {

// Tries the outline first, then places ever further inside.
template <class First>
[[nodiscard]] bool try_candidate(const First& first, const Candidate& candidate, abut_pick& out) {
  for (const double t : {0.0, 1e-6, 1e-4, 1e-2, 0.1}) {
    out = first(between(candidate.nearest, candidate.inside, t));
    if (out.geometry.slot != 0) return true;
  }
  return false;
}

// The hit nearest to the middle on the way from a hit in the picture to it, by bisection.
template <class First>
[[nodiscard]] abut_pick followed_inwards(const First& first, Offset hit, abut_pick pick) {
  Offset miss{0, 0};
  for (int step = 0; step < 20; ++step) {
    const Offset middle = between(miss, hit, 0.5);
    const abut_pick found = first(middle);
    if (found.geometry.slot == 0) {
      miss = middle;
    } else {
      hit = middle;
      pick = found;
    }
  }
  return pick;
}

// Rings of rays at half a pixel, or coarser when the radius is large.
template <class First>
void search_rings(const First& first, double radius, abut_pick& out) {
  constexpr double rings = 64;
  const double gap = std::max(0.5, radius / rings);
  for (double r = std::min(gap, radius); r <= radius && r > 0; r += gap) {
    const auto count = static_cast<int>(std::ceil(2 * std::numbers::pi * r / gap));
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      const Offset offset{r * std::cos(angle), r * std::sin(angle)};
      const abut_pick pick = first(offset);
      if (pick.geometry.slot == 0) continue;
      out = followed_inwards(first, offset, pick);
      return;
    }
  }
}

// Looks at all triangles of a geometry.
[[nodiscard]] abut_status look_at_triangles(const Sight& sight, const Entry& entry, const PickableShape& shape,
                                            Candidate& best) {
  TriangleList list;
  if (const abut_status status = shape.triangles(list); status != ABUT_OK) return status;
  std::vector<abut_vec3> seen;
  seen.reserve(list.xyz.size() / 3);
  for (std::size_t i = 0; i + 2 < list.xyz.size(); i += 3) {
    seen.push_back(sight.seen(to_world(entry.frame, {list.xyz[i], list.xyz[i + 1], list.xyz[i + 2]})));
  }
  for (std::size_t i = 0; i + 2 < list.indices.size(); i += 3) {
    look_at_triangle(sight, {seen[list.indices[i]], seen[list.indices[i + 1]], seen[list.indices[i + 2]]}, best);
  }
  return ABUT_OK;
}

// The pick of a point or segment.
[[nodiscard]] abut_pick pick_of_thin(const Entry& entry, double half_height, double distance, const abut_vec3& point) {
  const abut_feature feature{half_height == 0 ? ABUT_FEATURE_VERTEX : ABUT_FEATURE_EDGE, 0};
  return {entry.id, feature, 0, 0, distance, point, {0, 0, 0}};
}

}  // namespace

abut_status Tracer::pick_pixel(const Aim& aim, const abut_query_filter* filter, abut_pick& out) const {
  if (aim.radius > 0 && thin_count_ != 0 && pick_thin(aim, filter, out)) return ABUT_OK;
  trace(ray_through(aim.view, aim.x, aim.y), filter, out);
  return out.geometry.slot == 0 && aim.radius > 0 ? pick_near(aim, filter, out) : ABUT_OK;
}

// Points and segments have no area that a ray could meet. False when none shows within the radius.
bool Tracer::pick_thin(const Aim& aim, const abut_query_filter* filter, abut_pick& out) const {
  const Sight sight{aim};
  struct Thin {
    double size;
    std::uint32_t entry;
    abut_vec3 point;
  };
  std::vector<Thin> found;
  for (std::uint32_t i = 0; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    if (entry.id.slot == 0 || !shapes_[entry.shape].is_thin() || !admits(filter, entry)) continue;
    const double half = shapes_[entry.shape].rounded->half_height;
    const ThinCandidate nearest = look_at_edge(sight, sight.seen(to_world(entry.frame, {0, 0, -half})),
                                               sight.seen(to_world(entry.frame, {0, 0, half})));
    const abut_vec3 point = sight.in_world(nearest.seen);
    if (nearest.size <= aim.radius && is_kept(point)) found.push_back({nearest.size, i, point});
  }
  std::ranges::sort(found, [&](const Thin& a, const Thin& b) {
    return a.size != b.size ? a.size < b.size : entries_[a.entry].id.slot < entries_[b.entry].id.slot;
  });
  for (const Thin& thin : found) {
    const Entry& entry = entries_[thin.entry];
    const std::optional<abut_ray> line = sight_line(aim.view, thin.point);
    if (!line) continue;
    trace(*line, filter, out);
    if (out.geometry.slot != 0) continue;
    out = pick_of_thin(entry, shapes_[entry.shape].rounded->half_height, line->max_distance / (1 - hiding), thin.point);
    return true;
  }
  return false;
}

// Outlines of triangles, spheres and capsules are found in closed form, so that thin things are not
// missed. What has none of these is looked for by rays in rings.
abut_status Tracer::pick_near(const Aim& aim, const abut_query_filter* filter, abut_pick& out) const {
  const Sight sight{aim};
  const auto first = [&](const Offset& offset) {
    abut_pick pick = nothing();
    const bool is_finite = std::isfinite(aim.x + offset.x) && std::isfinite(aim.y + offset.y);
    if (is_finite) trace(sight.ray_at(offset), filter, pick);
    return pick;
  };
  std::vector<Candidate> candidates;
  bool has_others = false;
  for (const Entry& entry : entries_) {
    if (entry.id.slot == 0 || !admits(filter, entry)) continue;
    const ShapeRecord& shape = shapes_[entry.shape];
    if (entry.role == Role::apart) has_others = true;
    if (entry.role == Role::apart || shape.is_thin() || !sight.may_show(entry.box)) continue;
    Candidate best;
    if (shape.triangle_count != 0) {
      if (const abut_status status = look_at_triangles(sight, entry, *shape.access, best); status != ABUT_OK)
        return status;
    } else if (shape.rounded) {
      look_at_rounded(sight, entry.frame, *shape.rounded, best);
    } else {
      has_others = true;
    }
    if (best.size <= aim.radius) candidates.push_back(best);
  }
  std::ranges::sort(candidates, {}, &Candidate::size);
  double found_at = aim.radius;
  for (const Candidate& candidate : candidates) {
    if (try_candidate(first, candidate, out)) {
      found_at = candidate.size;
      break;
    }
  }
  if (has_others || (out.geometry.slot == 0 && !candidates.empty())) search_rings(first, found_at, out);
  return ABUT_OK;
}

}  // namespace abut::picking
