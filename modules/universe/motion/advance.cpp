// SPDX-License-Identifier: Apache-2.0
// As far as nothing touches on the way.
module abut.universe;
import abut.broadphase;
import abut.capability;
import abut.core.memory.spare_blocks;
import abut.core.standard;
import abut.core;
import abut.detect.continuous;
import abut.detect.pairs.jobs;
import abut.detect.paths;
import abut.detect.continuous.touches;
import abut.math;
import abut.math.turn;
import abut.motion.time_of_impact;
import abut.pairs.any_shape;
import abut.scene.meetings;
import abut.scene.state.places;
import abut.scene.meetings.policies;

namespace abut {
namespace {

constexpr StepImpact no_impact{.geometry_a = {}, .geometry_b = {}, .lower = 1, .upper = 1};

// What touches at the start does so on its way once it has parted.
std::optional<Impact> first_touch_on_way(const PathPair& pair) {
  Impact impact;
  if (find_touch(pair, 0, impact) != Outcome::ok || impact.state == ImpactState::apart) {
    return std::nullopt;
  }
  return impact.state == ImpactState::starts_together ? find_touch_after(pair, 0) : impact;
}

}  // namespace

// The filter is asked, as in a detection.
StepImpact Universe::first_impact(Real dt) {
  const Paths its_paths = paths(dt);
  StepImpact first = no_impact;
  for (const auto& [low, high] : sweeps_.pairs()) {
    const PlaceInfo &a = places_.infos[low], &b = places_.infos[high];
    const Policy& policy = meetings_.policies.of(a.tag, b.tag);
    const bool holds_up = (a.sweeping == Sweeping::impacts || b.sweeping == Sweeping::impacts) && !a.is_sensor &&
                          !b.is_sensor && policy.detail != Detail::box;
    if (!holds_up || !meetings_.admits(places_, low, high)) {
      continue;
    }
    const Path path_low = its_paths.of(low), path_high = its_paths.of(high);
    const Real touching = std::max<Real>(margin_of(options_.tolerance_mode, policy, a, b), 0);
    const auto impact =
        first_touch_on_way({{*places_.shapes[low], path_low}, {*places_.shapes[high], path_high}, touching});
    if (impact && impact->lower < first.lower) {
      first = {.geometry_a = places_.id_at(low),
               .geometry_b = places_.id_at(high),
               .lower = impact->lower,
               .upper = impact->upper,
               .is_undecided = impact->state == ImpactState::undecided};
    }
  }
  return first;
}

// Of vertices that are lent, where element contacts are first touches.
void Universe::hold_at_elements(Real dt, StepImpact& first) {
  const Paths its_paths = paths(dt);
  const auto end_of = [&](std::uint32_t place) {
    return its_paths.begins_at_pose(place) ? its_paths.of(place).at(1) : places_.worlds[place];
  };
  const auto holds_up = [&](std::uint32_t low, std::uint32_t high) {
    return !places_.infos[low].is_sensor && !places_.infos[high].is_sensor && meetings_.admits(places_, low, high);
  };
  const auto touch = elements_.first_touch(workers_, box_frame(), meetings_.policies, space_, changes_.fresh, lent_,
                                           places_, end_of, holds_up);
  if (touch && touch->toi < first.lower) {
    first = {.geometry_a = places_.id_at(touch->low),
             .geometry_b = places_.id_at(touch->high),
             .lower = touch->toi,
             .upper = touch->toi};
  }
}

std::vector<GeometryId> Universe::geometries_that_lead() const {
  std::vector<GeometryId> leading;
  lent_.visit([&](std::uint32_t place, std::span<const Vec3>) {
    if (places_.infos[place].sweeping == Sweeping::impacts) {
      leading.push_back(places_.id_at(place));
    }
  });
  return leading;
}

// To a share of the way to the vertices that are lent.
void Universe::move_vertices(Real share) {
  const std::vector<GeometryId> leading = geometries_that_lead();
  for (std::size_t i = 0; share < 1 && i < leading.size(); ++i) {
    const std::uint32_t place = leading[i].slot - 1;
    const std::span<const Vec3> present = held_triangles(shape_at(place)).vertices;
    const std::span<Vec3> next = lent_.lend(place, present);
    for (std::size_t vertex = 0; vertex < next.size(); ++vertex) {
      next[vertex] = present[vertex] + share * (next[vertex] - present[vertex]);
    }
  }
  exchange_all(leading);
}

void Universe::move_along(Real dt, Real time) {
  std::vector<PartId> moving;
  std::vector<Placement> placements;
  parts_.for_each([&](PartId id, const Part& part) {
    const Motion motion = velocities_.motion_within(dt, id.slot);
    if (motion == Motion{}) {
      return;
    }
    const Placement* const before = velocities_.start_of(id.slot);
    const Pose start = (before != nullptr ? *before : part.placement).pose();
    if (const auto path = Path::along(start, {0, 0, 0}, motion, 1)) {
      const Pose pose = path.value().at(time);
      moving.push_back(id);
      placements.push_back({pose.position, quaternion_of(pose.rotation)});
    }
  });
  static_cast<void>(set_poses(moving, placements));
}

Result<StepImpact> Universe::advance_to_first_impact(Real dt) {
  Fault fault = check_time(dt);
  fault = fault ? fault : velocities_.check_motions(dt);
  if (fault) {
    return *fault;
  }
  const SpareBlocks::Use use(spare_, workers_.threads());
  refresh();
  if (dt == 0) {
    return no_impact;
  }
  velocities_.update(dt, [&](PartId part) { return parts_.at(part).placement; });
  sweep(dt);
  begin_detection();
  StepImpact first;
  try {
    first = first_impact(dt);
    if (!lent_.is_empty()) {
      hold_at_elements(dt, first);
    }
  } catch (...) {
    end_detection();
    throw;
  }
  end_detection();
  apply_deferred_parking();
  move_vertices(first.lower);
  move_along(dt, first.lower);
  return first;
}

}  // namespace abut
