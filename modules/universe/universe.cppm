// A space in which parts meet: parts with geometries, and steps that find their contacts.
module;
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>
export module abut.universe;
import abut.any_shape;
import abut.broadphase;
import abut.core;
import abut.dispatch;
import abut.math;
import abut.shape;
import abut.universe.pairs;
export import abut.universe.options;

export namespace abut {

class Universe {
 public:
  // `number` tells universes of one process apart: their ids start at different generations.
  Universe(const UniverseOptions& options, std::uint32_t number);

  // Parts. Failures change nothing; batches take effect as a whole or not at all.
  [[nodiscard]] Result<std::vector<PartId>> create_parts(std::span<const PartOptions> options);
  [[nodiscard]] Result<void> destroy_parts(std::span<const PartId> parts);
  [[nodiscard]] Result<void> set_poses(std::span<const PartId> parts, std::span<const Placement> poses);
  [[nodiscard]] Result<Placement> pose(PartId part) const;
  [[nodiscard]] Result<std::uint64_t> user_data(PartId part) const;
  [[nodiscard]] Result<std::vector<GeometryId>> geometries_of(PartId part) const;

  // Geometries. No options means the default ones for each.
  [[nodiscard]] Result<std::vector<GeometryId>> create_geometries(std::span<const PartId> parts, std::span<const ShapeHandle> shapes,
                                                                  std::span<const GeometryOptions> options);
  [[nodiscard]] Result<void> destroy_geometries(std::span<const GeometryId> geometries);
  [[nodiscard]] Result<GeometryInfo> describe(GeometryId geometry) const;
  [[nodiscard]] Result<Placement> world_pose(GeometryId geometry) const;

  [[nodiscard]] std::vector<PartId> parts() const;
  [[nodiscard]] std::vector<GeometryId> geometries() const;
  [[nodiscard]] inline Revision revision() const { return revision_; }

  // Detects over [t, t + dt]; moves nothing. With a tolerance, an overlap has to exceed it, or a
  // separation to be below it, depending on the mode; without one, touching counts.
  [[nodiscard]] Result<void> step(Real dt);
  // Ordered by the slots of the two geometries, of which a has the lower one, then deepest first.
  [[nodiscard]] std::span<const Contact> contacts() const [[clang::lifetimebound]] { return contacts_; }
  // One value per contact of the last step, in their order.
  [[nodiscard]] Result<void> set_contact_user_data(std::span<const std::uint64_t> user_data);
  [[nodiscard]] const StepStats& stats() const [[clang::lifetimebound]] { return stats_; }
  [[nodiscard]] std::string explain() const;

 private:
  struct Part {
    Placement placement;
    Pose pose;
    std::uint64_t user_data;
    MotionKind motion;
    bool is_moved = false;
    bool is_marked = false;  // seen by the check of a batch
    std::vector<GeometryId> geometries;
  };
  struct Geometry {
    PartId part;
    Placement local;
    Pose local_pose;
    std::uint64_t user_data;
    bool is_marked = false;
  };

  void forget_geometry(GeometryId geometry);
  void choose_broadphase();
  template <class Visitor>
  void for_each_moved_geometry(Visitor&& visit) const;
  void refresh();
  void update_broadphase();
  void find_manifolds();
  void collect_contacts();
  [[nodiscard]] Placement world_of(const Geometry& geometry) const;
  [[nodiscard]] std::size_t bytes() const;

  UniverseOptions options_;
  SlotMap<Part, PartTag> parts_;
  SlotMap<Geometry, GeometryTag> geometries_;
  Revision revision_;
  std::size_t list_bytes_ = 0;  // of the lists of geometries of the parts

  // By slot of the geometry, less one: what the stages of a step read and write.
  ShapeHandle vacant_;  // stands where there is no geometry
  std::vector<ShapeHandle> shapes_;
  std::vector<Pose> worlds_;
  std::vector<CompactAabb> boxes_;
  std::vector<Real> tolerances_;
  std::vector<std::uint8_t> kinds_;

  // What changed since the last step.
  std::vector<PartId> moved_parts_;
  std::vector<GeometryId> new_geometries_;
  std::vector<std::uint32_t> fresh_;  // numbers of the boxes that were refreshed

  std::variant<Brute, Tree> broadphase_;
  std::vector<std::uint8_t> in_broadphase_;
  std::vector<ProxyPair> pairs_;
  PairRuns runs_;
  std::vector<PairResult> results_;
  Manifold manifold_;
  std::vector<Contact> contacts_;
  std::vector<Contact> contacts_before_;  // of the step before
  std::vector<std::uint64_t> ids_before_;  // of one pair of it
  std::array<KindTally, PairRuns::run_count> tallies_{};
  StepStats stats_;
};

}  // namespace abut
