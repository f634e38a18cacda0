// SPDX-License-Identifier: Apache-2.0
// The first stage of a detection: from poses to boxes, for what moved, is new or was changed.
export module abut.detect.pairs.refresh;
import abut.core.standard;
import abut.core.workers;
import abut.math;
import abut.scene;
import abut.scene.state.changes;
import abut.scene.state.places;
import abut.scene.state.space;

export namespace abut {

// How boxes lie around shapes.
struct BoxFrame {
  ToleranceMode mode = ToleranceMode::dead_band;
  Real largest_tolerance = 0;  // of all policies
  Vec3 origin{0, 0, 0};        // of compact boxes
};

class Refresh {
 public:
  // Takes the moved parts and the changed geometries out of the changes. Those that are not parked get a world pose and
  // a box, are added to the fresh ones, and form the queue, each once. Places that were moved while they do not show
  // only hear that their box is stale.
  void run(const Workers& workers, const BoxFrame& frame, const Space& space, Scene::Parts& parts,
           Scene::Geometries& geometries, SceneChanges& changes, Places& places);
  [[nodiscard]] std::span<const std::uint32_t> queue() const [[clang::lifetimebound]] { return queue_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  // What one task finds on moved parts.
  struct Task {
    std::vector<std::uint32_t> queue, fresh;
  };
  static void gather_moved(std::span<const PartId> moved, const BoxFrame& frame, const Space& space,
                           Scene::Parts& parts, const Scene::Geometries& geometries, Places& places, Task& task);
  void queue_changed(Scene::Geometries& geometries, const SceneChanges& changes, Places& places);

  std::vector<std::uint32_t> queue_;
  std::vector<Task> tasks_;
};

}  // namespace abut
