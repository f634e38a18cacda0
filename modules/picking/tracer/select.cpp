// SPDX-License-Identifier: Apache-2.0
// Which geometries a rectangle of a picture touches or holds.
module;

#include <abut/picking.h>

#include "picking/embree.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

module abut.picking;
import :box_table;
import :camera;
import :entry;
import :region;
import :source;
import :tracer;
import :vector;

namespace abut::picking {

namespace {

// The planes of a region as solids, each made when a box first crosses its plane.
class [[gsl::Pointer]] Sides {
 public:
  // With `outside` each solid is what its plane leaves out, else what it keeps.
  Sides(const Source& source, std::span<const HalfSpace> planes, bool outside)
      : source_(&source), planes_(planes), outside_(outside), solids_(planes.size()) {}

  [[nodiscard]] abut_status find(std::size_t plane, const PickableShape*& out) {
    std::unique_ptr<PickableShape>& solid = solids_[plane];
    if (!solid) {
      const HalfSpace& side = planes_[plane];
      const double sign = outside_ ? 1 : -1;
      const abut_status status = source_->half_space(scale(side.normal, sign), sign * side.offset, solid);
      if (status != ABUT_OK) return status;
    }
    out = solid.get();
    return ABUT_OK;
  }

 private:
  std::unique_ptr<const Source, Borrowed> source_;
  std::span<const HalfSpace> planes_;
  bool outside_;
  std::vector<std::unique_ptr<PickableShape>> solids_;
};

// Geometries by slot.
class Found {
 public:
  explicit Found(std::size_t slots) : words_(slots / 64 + 1) {}
  void add(std::uint32_t slot) { words_[slot / 64] |= std::uint64_t{1} << slot % 64; }
  template <class Visit>
  void visit(const Visit& visit) const {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      for (std::uint64_t left = words_[i]; left != 0; left &= left - 1)
        visit(static_cast<std::uint32_t>(64 * i) + static_cast<std::uint32_t>(std::countr_zero(left)));
    }
  }

 private:
  std::vector<std::uint64_t> words_;
};

// What lies in a box, with a little room around it.
void add_sides(const abut_aabb& box, std::vector<HalfSpace>& planes) {
  const double room = 0x1p-8 * diagonal_of(box) + 0x1p-40 * reach_of(box, {0, 0, 0});
  planes.insert(planes.end(), {{{1, 0, 0}, box.minimum.x - room},
                               {{0, 1, 0}, box.minimum.y - room},
                               {{0, 0, 1}, box.minimum.z - room},
                               {{-1, 0, 0}, -box.maximum.x - room},
                               {{0, -1, 0}, -box.maximum.y - room},
                               {{0, 0, -1}, -box.maximum.z - room}});
}

// From near to far, both of which are planes.
[[nodiscard]] std::vector<abut_ray> rays_of_corners(View view, const Rectangle& its) {
  view.has_planes = true;
  return {ray_through(view, its.x0, its.y0), ray_through(view, its.x0, its.y1), ray_through(view, its.x1, its.y0),
          ray_through(view, its.x1, its.y1)};
}

}  // namespace

// A box that crosses no plane lies in the region, and its geometry with it. One that crosses a single plane lies within
// all others, so the geometry touches the region where it touches what that plane keeps. Only where planes meet the
// region itself is needed as a solid.
abut_status Tracer::select(const View& view, const Rectangle& rectangle, bool inside, const abut_query_filter* filter,
                           std::vector<abut_geometry_id>& out) const {
  const std::vector<HalfSpace> planes = region_of(view, rectangle, clip_planes_);
  Sides sides(*source_, planes, inside);
  Found found(entry_of_slot_.size());
  std::vector<std::uint32_t> at_edges;
  abut_status status = ABUT_OK;
  const auto look_at = [&](std::uint32_t index, PlaneBits crossed) {
    const Entry& entry = entries_[index];
    if (status != ABUT_OK || !admits(filter, entry)) return;
    const PickableShape& access = *shapes_[entry.shape].access;
    for (PlaneBits left = crossed; left != 0; left &= left - 1) {
      const PickableShape* side = nullptr;
      status = sides.find(static_cast<std::size_t>(std::countr_zero(left)), side);
      if (status != ABUT_OK || access.overlaps(entry.pose, *side) == inside) return;
    }
    if (inside || std::popcount(crossed) < 2) {
      found.add(entry.id.slot);
    } else {
      at_edges.push_back(index);
    }
  };
  boxes_.look(planes, [&](std::uint32_t slot, PlaneBits crossed) {
    if (crossed == 0 && filter == nullptr) {
      found.add(slot);
    } else {
      look_at(entry_of_slot_[slot], crossed);
    }
  });
  const PlaneBits all = (PlaneBits{1} << planes.size()) - 1;
  for (const std::uint32_t index : apart_) {
    if (is_bounded(entries_[index].box)) {
      look_at(index, all);
    } else if (!inside && admits(filter, entries_[index])) {
      at_edges.push_back(index);
    }
  }
  if (status != ABUT_OK) return status;
  std::vector<std::uint32_t> touching;
  if (status = touching_at_edges(view, rectangle, at_edges, touching); status != ABUT_OK) return status;
  for (const std::uint32_t index : touching) found.add(entries_[index].id.slot);
  std::vector<std::uint32_t> chosen;
  found.visit([&](std::uint32_t slot) { chosen.push_back(entry_of_slot_[slot]); });
  // Entries are large and in any order: most of the time would go by waiting for them.
  constexpr std::size_t ahead = 16;
  out.resize(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (i + ahead < chosen.size()) __builtin_prefetch(&entries_[chosen[i + ahead]].id);
    out[i] = entries_[chosen[i]].id;
  }
  return ABUT_OK;
}

// Those of some geometries that touch the region, of which no more is needed than what lies around their boxes. Shapes
// without bounds may touch it anywhere: they do so at its nearest corners or further along the rays through its
// corners.
abut_status Tracer::touching_at_edges(const View& view, const Rectangle& rectangle,
                                      std::span<const std::uint32_t> entries, std::vector<std::uint32_t>& out) const {
  abut_aabb around = empty_box;
  for (const std::uint32_t index : entries) {
    const abut_aabb& box = entries_[index].box;
    if (!is_bounded(box)) continue;
    extend(around, box.minimum);
    extend(around, box.maximum);
  }
  std::unique_ptr<PickableShape> region;
  if (around.minimum.x <= around.maximum.x) {
    std::vector<HalfSpace> planes = region_of(view, rectangle, clip_planes_);
    add_sides(around, planes);
    const std::vector<double> corners = corners_of(planes, centre_of(around));
    if (!corners.empty()) {
      if (const abut_status status = source_->hull(corners, region); status != ABUT_OK) return status;
    }
  }
  const auto is_unbounded = [&](std::uint32_t index) { return !is_bounded(entries_[index].box); };
  std::vector<abut_ray> rays;
  std::unique_ptr<PickableShape> starts;
  if (std::ranges::any_of(entries, is_unbounded)) {
    rays = rays_of_corners(view, rectangle);
    std::erase_if(rays, [&](abut_ray& ray) {
      double skipped = 0;
      return !trim(ray, skipped);
    });
    std::vector<double> points;
    for (const abut_ray& ray : rays) points.insert(points.end(), {ray.origin.x, ray.origin.y, ray.origin.z});
    const bool is_near = std::ranges::all_of(points, [](double its) { return std::fabs(its) <= farthest_start; });
    if (!points.empty() && is_near) {
      if (const abut_status status = source_->hull(points, starts); status != ABUT_OK) return status;
    }
  }
  for (const std::uint32_t index : entries) {
    const Entry& entry = entries_[index];
    const PickableShape& access = *shapes_[entry.shape].access;
    const auto overlaps = [&](const std::unique_ptr<PickableShape>& solid) {
      return solid && access.overlaps(entry.pose, *solid);
    };
    const auto meets = [&](const abut_ray& ray) { return access.cast(entry.pose, ray).has_value(); };
    if (overlaps(region) || (is_unbounded(index) && (overlaps(starts) || std::ranges::any_of(rays, meets))))
      out.push_back(index);
  }
  return ABUT_OK;
}

}  // namespace abut::picking
