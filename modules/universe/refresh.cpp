// Poses to boxes, and boxes to the broad phase, for what moved or is new.
module abut.universe;
import abut.any_shape;
import abut.broadphase;
import abut.core;
import abut.core.standard;
import abut.math;
import abut.universe.pairs;

namespace abut {
namespace {

// Places that a thread takes at once.
constexpr std::size_t block_size = 256;

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

// The world pose and the box of a place.
void Universe::place(std::uint32_t at) {
  const Geometry& geometry = geometries_.at(id_at(at));
  worlds_[at] = parts_.at(geometry.part).pose * geometry.local_pose;
  Aabb box = aabb_of(*shapes_[at], worlds_[at]);
  if (options_.tolerance_mode == ToleranceMode::margin) {
    // The two boxes of a pair reach as far together as its policy does.
    box = box.inflated(std::max(infos_[at].tolerance, 0.5 * policies_.largest_tolerance()));
  }
  boxes_[at] = compact(box, options_.origin);
  infos_[at].is_box_stale = false;
}

void Universe::gather_changes() {
  queue_.clear();
  const auto queue = [&](std::uint32_t at) {
    if (!infos_[at].is_queued) {
      infos_[at].is_queued = true;
      queue_.push_back(at);
    }
  };
  for (const PartId id : moved_parts_) {
    if (!parts_.contains(id)) {
      continue;
    }
    Part& part = parts_.at(id);
    part.is_moved = false;
    for (const GeometryId geometry : part.geometries) {
      const std::uint32_t at = geometry.slot - 1;
      infos_[at].is_box_stale = true;
      if (presence_[at] == Presence::shown) {
        queue(at);
      }
    }
  }
  moved_parts_.clear();
  for (const GeometryId id : changed_geometries_) {
    if (geometries_.contains(id)) {
      Geometry& geometry = geometries_.at(id);
      geometry.is_changed = false;
      if (geometry.options.parking == Parking::none) {
        queue(id.slot - 1);
      }
    }
  }
  changed_geometries_.clear();

  const std::size_t blocks = (queue_.size() + block_size - 1) / block_size;
  workers_.for_each(blocks, [&](std::size_t block) {
    const std::size_t begin = block * block_size;
    for (const std::uint32_t at : std::span(queue_).subspan(begin, std::min(block_size, queue_.size() - begin))) {
      if (infos_[at].is_box_stale) {
        place(at);
      }
    }
  });
  for (const std::uint32_t at : queue_) {
    infos_[at].is_queued = false;
    if (!infos_[at].is_fresh) {
      infos_[at].is_fresh = true;
      fresh_.push_back(at);
    }
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
