// SPDX-License-Identifier: Apache-2.0
// Why two geometries are not examined, from what the stages of a detection go by.
module abut.universe;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.any_shape.sides;
import abut.scene.meetings.checks;
import abut.scene.meetings;
import abut.scene.state.places;
import abut.scene.meetings.policies;

namespace abut {

// The pair that is kept of two geometries that are there now; null where none is.
const Pair* Universe::find_pair(std::uint32_t low, std::uint32_t high) const {
  const std::span<const Pair> all = pairs_.all();
  const auto found = std::lower_bound(all.begin(), all.end(), std::pair(low, high), [](const Pair& pair, auto wanted) {
    return std::pair(pair.low, pair.high) < wanted;
  });
  const bool is_found = found != all.end() && found->low == low && found->high == high &&
                        found->generation_low == places_.infos[low].generation &&
                        found->generation_high == places_.infos[high].generation;
  return is_found ? &*found : nullptr;
}

bool Universe::is_parked(std::uint32_t place) const {
  return geometries_.at(places_.id_at(place)).options.parking != Parking::none;
}

// Whether something has happened to a geometry that no detection has seen.
bool Universe::has_changed(std::uint32_t place) const {
  return parts_.at(places_.infos[place].part).is_moved || geometries_.at(places_.id_at(place)).is_changed ||
         places_.infos[place].is_box_stale || places_.happened[place] != 0;
}

// What the filter said when it was asked last, if its answer still counts. Without a filter it is yes.
bool Universe::has_filter_refused(const Pair& pair) const {
  constexpr unsigned asks_again = happened_to_filters | happened_to_shape;
  return !pair.is_admitted && !pair.is_unasked && !meetings_.must_ask_again &&
         !places_.has_happened(pair.low, asks_again) && !places_.has_happened(pair.high, asks_again);
}

namespace {

// Whether a surface would be met if it had both sides.
bool has_triangle_near(const AnyShape& surface, const Pose& pose, const AnyShape& other, const Pose& other_pose,
                       Real margin) {
  std::optional<Triangles> triangles = triangles_of(surface);
  if (sides_of(surface) != SurfaceSides::front || !triangles) {
    return false;
  }
  const Aabb near = aabb_of(other, pose.inverse() * other_pose).inflated(margin);
  const std::vector<std::uint32_t> all = std::exchange(triangles->indices, {});
  for (std::size_t i = 0; i + 2 < all.size(); i += 3) {
    Aabb box = Aabb::empty();
    for (std::size_t k = 0; k < 3; ++k) {
      box.include(triangles->vertices[all[i + k]]);
    }
    if (box.overlaps(near)) {
      triangles->indices.insert(triangles->indices.end(), {all[i], all[i + 1], all[i + 2]});
    }
  }
  const std::optional<ShapeHandle> sheet = make_sheet(*triangles);
  Distance found;
  return sheet && pair_distance(**sheet, other, pose, other_pose, {}, found) == Outcome::ok && found.distance <= margin;
}

}  // namespace

// Of a pair that was examined and has no contact.
bool Universe::is_behind(std::uint32_t low, std::uint32_t high) const {
  const Real margin = places_.infos[low].tolerance + places_.infos[high].tolerance;
  const AnyShape &a = shape_at(low), &b = shape_at(high);
  return has_triangle_near(a, world_at(low), b, world_at(high), margin) ||
         has_triangle_near(b, world_at(high), a, world_at(low), margin);
}

std::uint32_t Universe::why_apart_at(std::uint32_t low, std::uint32_t high) const {
  const PlaceInfo &a = places_.infos[low], &b = places_.infos[high];
  const Pair* const pair = find_pair(low, high);
  const auto bit_if = [](bool is_one, ApartReason bit) { return is_one ? std::uint32_t{bit} : 0; };
  const std::size_t run =
      low == high ? self_run_of(a.kind) : run_of(std::min(a.kind, b.kind), std::max(a.kind, b.kind));
  std::uint32_t reasons = meetings_.reasons(places_, low, high);
  reasons |= bit_if(reasons == 0 && pair != nullptr && has_filter_refused(*pair), apart_by_filter);
  reasons |= bit_if(!jobs_.is_supported(run), apart_by_kinds);
  reasons |= bit_if(meetings_.policies.of(a.tag, b.tag).detail == Detail::box, apart_by_policy);
  if (is_parked(low) || is_parked(high)) {
    return reasons | apart_by_parking;
  }
  // Boxes of paths may overlap where those of poses do not: then there is a pair.
  const bool has_path = pair != nullptr && (a.sweeping != Sweeping::none || b.sweeping != Sweeping::none);
  const bool have_boxes = space_.is_shown(low) && space_.is_shown(high) && !has_path;
  reasons |= bit_if(have_boxes && !places_.boxes[low].overlaps(places_.boxes[high]), apart_by_boxes);
  const bool is_overdue = pair == nullptr ? reasons == 0 : pair->is_admitted && pair->is_stale;
  reasons |=
      bit_if(is_overdue || has_changed(low) || has_changed(high) || meetings_.must_ask_again, apart_by_detection);
  const bool is_examined = reasons == 0 && pair != nullptr && pair->contact_count == 0 && low != high;
  return reasons | bit_if(is_examined && is_behind(low, high), apart_by_side);
}

Result<std::uint32_t> Universe::why_apart(GeometryId a, GeometryId b) const {
  if (!geometries_.contains(a) || !geometries_.contains(b)) {
    return stale(geometries_.contains(a) ? "geometry_b" : "geometry_a");
  }
  return why_apart_at(std::min(a.slot, b.slot) - 1, std::max(a.slot, b.slot) - 1);
}

}  // namespace abut
