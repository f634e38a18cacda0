// SPDX-License-Identifier: Apache-2.0
// What edits of a scene leave for the next refresh and the next detection.
export module abut.scene.state.changes;
import abut.core.standard;
import abut.scene.state.options;
import abut.scene.state.places;

export namespace abut {

// - moved_parts: filled by set_poses, emptied by the refresh.
// - changed_geometries: filled by all other edits, emptied by the refresh.
// - rejoining: filled by set_motions, emptied when the broad phase is up to date.
// - fresh: filled by the refresh with places whose box is new, emptied at the end of a detection.
// - patches: filled by edit_shapes, emptied at the end of a detection.
struct SceneChanges {
  std::vector<PartId> moved_parts;
  std::vector<GeometryId> changed_geometries;
  std::vector<std::uint32_t> rejoining;  // places that leave the broad phase and come back
  std::vector<std::uint32_t> fresh;
  std::vector<Patch> patches;
  bool are_slots_reused = false;  // perhaps; set where a geometry is destroyed, cleared where pairs are merged

  [[nodiscard]] std::size_t bytes() const {
    return moved_parts.capacity() * sizeof(PartId) + changed_geometries.capacity() * sizeof(GeometryId) +
           (rejoining.capacity() + fresh.capacity()) * sizeof(std::uint32_t) + patches.capacity() * sizeof(Patch);
  }
};

}  // namespace abut
