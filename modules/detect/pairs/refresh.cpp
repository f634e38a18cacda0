// SPDX-License-Identifier: Apache-2.0
module abut.detect.pairs.refresh;
import abut.core.standard;
import abut.core.workers;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.scene;
import abut.scene.state.changes;
import abut.scene.state.places;
import abut.scene.state.space;

namespace abut {
namespace {

// Below this many parts a task costs more than it saves.
constexpr std::size_t least_of_task = 256;

// The world pose and the box of a place whose part has this pose.
void place(std::uint32_t at, const Pose& part, const BoxFrame& frame, const Scene::Geometries& geometries,
           Places& places) {
  PlaceInfo& info = places.infos[at];
  Pose& world = places.worlds[at];
  world = info.is_at_part ? part : part * geometries.at(places.id_at(at)).local_pose;
  const Real reach = reach_of(info, frame.mode, frame.largest_tolerance);
  places.boxes[at] = compact(aabb_of(*places.shapes[at], world).inflated(reach), frame.origin);
  info.is_box_stale = false;
}

// Whether it was not fresh before.
bool make_fresh(std::uint32_t at, Places& places) {
  const bool was_fresh = places.has_happened(at, happened_to_box);
  places.note(at, happened_to_box);
  return !was_fresh;
}

}  // namespace

// What has changed and is not in the queue yet.
void Refresh::queue_changed(Scene::Geometries& geometries, const SceneChanges& changes, Places& places) {
  if (changes.changed_geometries.empty()) {
    return;
  }
  for (const std::uint32_t at : queue_) {
    places.infos[at].is_queued = true;
  }
  for (const GeometryId id : changes.changed_geometries) {
    if (!geometries.contains(id)) {
      continue;
    }
    Scene::Geometry& geometry = geometries.at(id);
    geometry.is_changed = false;
    const std::uint32_t at = id.slot - 1;
    if (geometry.options.parking == Parking::none && !std::exchange(places.infos[at].is_queued, true)) {
      queue_.push_back(at);
    }
  }
  for (const std::uint32_t at : queue_) {
    places.infos[at].is_queued = false;
  }
}

// What lies on moved parts. A part is in one task, and with it its geometries.
void Refresh::gather_moved(std::span<const PartId> moved, const BoxFrame& frame, const Space& space,
                           Scene::Parts& parts, const Scene::Geometries& geometries, Places& places, Task& task) {
  task.queue.clear();
  task.fresh.clear();
  for (const PartId id : moved) {
    if (!parts.contains(id)) {
      continue;
    }
    Scene::Part& part = parts.at(id);
    part.is_moved = false;
    const Pose pose = part.placement.pose();
    for (const GeometryId geometry : part.geometries) {
      const std::uint32_t at = geometry.slot - 1;
      places.infos[at].is_box_stale = true;
      places.infos[at].patch = no_patch;
      if (!space.is_shown(at)) {
        continue;
      }
      place(at, pose, frame, geometries, places);
      task.queue.push_back(at);
      if (make_fresh(at, places)) {
        task.fresh.push_back(at);
      }
    }
  }
}

void Refresh::run(const Workers& workers, const BoxFrame& frame, const Space& space, Scene::Parts& parts,
                  Scene::Geometries& geometries, SceneChanges& changes, Places& places) {
  queue_.clear();
  const std::span<const PartId> moved(changes.moved_parts);
  const Cuts cuts = workers.cut(moved.size(), least_of_task);
  tasks_.resize(std::max(tasks_.size(), cuts.tasks()));
  workers.for_each(cuts.tasks(), [&](std::size_t task) {
    gather_moved(cuts.of(moved, task), frame, space, parts, geometries, places, tasks_[task]);
  });
  for (const Task& task : std::span(tasks_).first(cuts.tasks())) {
    queue_.insert(queue_.end(), task.queue.begin(), task.queue.end());
    changes.fresh.insert(changes.fresh.end(), task.fresh.begin(), task.fresh.end());
  }
  changes.moved_parts.clear();
  const std::size_t moved_count = queue_.size();
  queue_changed(geometries, changes, places);
  changes.changed_geometries.clear();
  const std::span<const std::uint32_t> changed = std::span(queue_).subspan(moved_count);
  const Cuts cuts_of_changed = workers.cut(changed.size(), least_of_task);
  workers.for_each(cuts_of_changed.tasks(), [&](std::size_t number) {
    for (const std::uint32_t at : cuts_of_changed.of(changed, number)) {
      if (places.infos[at].is_box_stale) {
        place(at, parts.at(places.infos[at].part).placement.pose(), frame, geometries, places);
      }
    }
  });
  for (const std::uint32_t at : changed) {
    if (make_fresh(at, places)) {
      changes.fresh.push_back(at);
    }
  }
}

std::size_t Refresh::bytes() const {
  std::size_t sum = queue_.capacity() * sizeof(std::uint32_t) + tasks_.capacity() * sizeof(Task);
  for (const Task& task : tasks_) {
    sum += (task.queue.capacity() + task.fresh.capacity()) * sizeof(std::uint32_t);
  }
  return sum;
}

}  // namespace abut
