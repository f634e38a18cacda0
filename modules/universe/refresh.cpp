// Poses to boxes, and boxes to the broad phase, for what moved or is new.
module abut.universe;
import abut.broadphase;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.universe.pairs;

namespace abut {
namespace {

// Fewer parts are placed faster than a thread is called.
constexpr std::size_t least_of_task = 256;

AnyBroadPhase make_broadphase(BroadphaseKind kind) {
  switch (kind) {
    case BroadphaseKind::tree: return Tree();
    case BroadphaseKind::sweep_and_prune: return SweepAndPrune();
    case BroadphaseKind::hash_grid: return Grid();
    case BroadphaseKind::automatic:
    case BroadphaseKind::brute: break;
  }
  return Brute();
}

}  // namespace

// How far a box goes beyond its shape: the two boxes of a pair reach as far together as its policy does.
Real Universe::reach_at(std::uint32_t place) const {
  const Real reach = std::max(infos_[place].tolerance, 0.5 * policies_.largest_tolerance());
  return options_.tolerance_mode == ToleranceMode::margin ? reach : 0;
}

// The world pose and the box of a place whose part has this pose.
void Universe::place(std::uint32_t at, const Pose& part) {
  PlaceInfo& info = infos_[at];
  worlds_[at] = info.is_at_part ? part : part * geometries_.at(id_at(at)).local_pose;
  const Aabb box = aabb_of(*shapes_[at], worlds_[at]);
  boxes_[at] = compact(box.inflated(reach_at(at)), options_.origin);
  info.is_box_stale = false;
}

// What lies on moved parts. A part is in one task, and with it its geometries.
void Universe::gather_moved(std::span<const PartId> parts, ChangeTask& task) {
  task.queue.clear();
  task.fresh.clear();
  for (const PartId id : parts) {
    if (!parts_.contains(id)) {
      continue;
    }
    Part& part = parts_.at(id);
    part.is_moved = false;
    const Pose pose = part.placement.pose();
    for (const GeometryId geometry : part.geometries) {
      const std::uint32_t at = geometry.slot - 1;
      infos_[at].is_box_stale = true;
      infos_[at].patch = no_patch;
      if (presence_[at] != Presence::shown) {
        continue;
      }
      place(at, pose);
      task.queue.push_back(at);
      if ((happened_[at] & happened_to_box) == 0) {
        note(at, happened_to_box);
        task.fresh.push_back(at);
      }
    }
  }
}

// What has changed and is not in the queue yet.
void Universe::queue_changed() {
  const std::size_t moved = queue_.size();
  for (const std::uint32_t at : queue_) {
    infos_[at].is_queued = true;
  }
  for (const GeometryId id : changed_geometries_) {
    if (!geometries_.contains(id)) {
      continue;
    }
    Geometry& geometry = geometries_.at(id);
    geometry.is_changed = false;
    const std::uint32_t at = id.slot - 1;
    if (geometry.options.parking == Parking::none && !std::exchange(infos_[at].is_queued, true)) {
      queue_.push_back(at);
    }
  }
  const std::span<const std::uint32_t> changed = std::span(queue_).subspan(moved);
  const Cuts cuts = workers_.cut(changed.size(), least_of_task);
  workers_.for_each(cuts.tasks(), [&](std::size_t task) {
    for (const std::uint32_t at : cuts.of(changed, task)) {
      if (infos_[at].is_box_stale) {
        place(at, parts_.at(geometries_.at(id_at(at)).part).placement.pose());
      }
    }
  });
  for (const std::uint32_t at : changed) {
    if ((happened_[at] & happened_to_box) == 0) {
      note(at, happened_to_box);
      fresh_.push_back(at);
    }
  }
  for (const std::uint32_t at : queue_) {
    infos_[at].is_queued = false;
  }
}

void Universe::gather_changes() {
  queue_.clear();
  const std::span<const PartId> parts(moved_parts_);
  const Cuts cuts = workers_.cut(parts.size(), least_of_task);
  change_tasks_.resize(std::max(change_tasks_.size(), cuts.tasks()));
  workers_.for_each(cuts.tasks(), [&](std::size_t task) { gather_moved(cuts.of(parts, task), change_tasks_[task]); });
  for (const ChangeTask& task : std::span(change_tasks_).first(cuts.tasks())) {
    queue_.insert(queue_.end(), task.queue.begin(), task.queue.end());
    fresh_.insert(fresh_.end(), task.fresh.begin(), task.fresh.end());
  }
  moved_parts_.clear();
  if (!changed_geometries_.empty()) {
    queue_changed();
    changed_geometries_.clear();
  }
}

// Makes another broad phase when the scene asks for it, with what the present one holds.
void Universe::choose_broadphase() {
  BroadphaseKind wanted = options_.broadphase;
  broadphase_reason_ = "as asked for";
  if (options_.broadphase == BroadphaseKind::automatic) {
    const auto is_joining = [&](std::uint32_t at) { return presence_[at] == Presence::absent; };
    const auto joining = static_cast<std::size_t>(std::ranges::count_if(queue_, is_joining));
    const auto present = std::visit([](const auto& its) { return its.size(); }, broadphase_) + joining;
    const BroadphaseChoice choice =
        abut::choose_broadphase({.present = present, .moving = moving_count_ + joining}, broadphase_kind_);
    wanted = choice.kind;
    broadphase_reason_ = text_of(choice.reason);
  }
  if (std::exchange(broadphase_kind_, wanted) == wanted) {
    return;
  }
  broadphase_ = make_broadphase(wanted);
  is_broadphase_changed_ = true;
  moving_count_ = 0;
  geometries_.for_each([&](GeometryId id, const Geometry&) {
    const std::uint32_t at = id.slot - 1;
    if (presence_[at] != Presence::absent) {
      join_broadphase(at);
      if (presence_[at] == Presence::hidden) {
        std::visit([&](auto& its) { its.hide(at); }, broadphase_);
      }
    }
  });
}

void Universe::join_broadphase(std::uint32_t at) {
  const bool is_moving = parts_.at(geometries_.at(id_at(at)).part).motion == MotionKind::dynamic;
  infos_[at].is_moving = is_moving;
  moving_count_ += is_moving ? 1 : 0;
  const Mobility mobility = is_moving ? Mobility::moving : Mobility::still;
  std::visit([&](auto& its) { its.insert(at, boxes_[at], mobility, infos_[at].part); }, broadphase_);
}

void Universe::update_broadphase() {
  for (const std::uint32_t at : rejoining_) {
    leave_broadphase(at);
  }
  rejoining_.clear();
  if (queue_.empty() && !is_broadphase_changed_) {
    return;
  }
  choose_broadphase();
  updates_.clear();
  for (const std::uint32_t at : queue_) {
    const Presence before = std::exchange(presence_[at], Presence::shown);
    if (before == Presence::shown) {
      updates_.push_back(at);
    } else if (before == Presence::hidden) {
      std::visit([&](auto& its) { its.show(at, boxes_[at]); }, broadphase_);
    } else {
      join_broadphase(at);
    }
  }
  std::visit([&](auto& its) { its.update_all(workers_, updates_, boxes_); }, broadphase_);
  is_broadphase_changed_ = true;
}

void Universe::refresh() {
  is_torn_ = true;
  gather_changes();
  update_broadphase();
  is_torn_ = false;
}

}  // namespace abut
