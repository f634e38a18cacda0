// SPDX-License-Identifier: Apache-2.0
// How geometries move through a step. The step is the unit of time.
export module abut.detect.paths;
import abut.core.standard;
import abut.math;
export import abut.motion.paths.path;
import abut.scene;
import abut.scene.state.places;

export namespace abut {

// A part with a measured velocity begins where it was at the end of the step before, and ends at its pose. All others
// begin at their pose.
struct [[gsl::Pointer]] Paths {
  const Scene::Geometries& geometries;
  const VelocityTable& velocities;
  const Places& places;
  Real dt;

  [[nodiscard]] bool is_still(std::uint32_t place) const { return velocities.is_still(places.infos[place].part.slot); }
  [[nodiscard]] bool moves(std::uint32_t place) const { return !is_still(place) && motion_of(place) != Motion{}; }
  [[nodiscard]] bool begins_at_pose(std::uint32_t place) const {
    return velocities.start_of(places.infos[place].part.slot) == nullptr;
  }
  [[nodiscard]] Path of(std::uint32_t place) const {
    if (is_still(place)) {
      return Path::at_rest(places.worlds[place], 1);
    }
    const PlaceInfo& info = places.infos[place];
    const Placement* const before = velocities.start_of(info.part.slot);
    if (info.is_at_part) {
      return path(before != nullptr ? before->pose() : places.worlds[place], {0, 0, 0}, place);
    }
    const Pose& local = geometries.at(places.id_at(place)).local_pose;
    return path(before != nullptr ? before->pose() * local : places.worlds[place], local.undo({0, 0, 0}), place);
  }
  // How far any point of a geometry gets at most from where it is at its pose; `box` holds it there. A chord of a
  // circle is at most twice its radius.
  [[nodiscard]] Real farthest(std::uint32_t place, const Aabb& box) const {
    if (is_still(place)) {
      return 0;
    }
    const Motion motion = motion_of(place);
    const Real angle = way_of(motion.angular_velocity, motion.angular_acceleration);
    const Real way = way_of(motion.velocity, motion.acceleration);
    if (angle == 0) {
      return outward * way;
    }
    const PlaceInfo& info = places.infos[place];
    const Pose& world = places.worlds[place];
    const Vec3 centre =
        info.is_at_part ? world.position : world * geometries.at(places.id_at(place)).local_pose.undo({0, 0, 0});
    const Real radius = norm(maximum(absolute(box.low - centre), absolute(box.high - centre)));
    return outward * (way + std::min(2., angle) * radius);
  }

 private:
  static constexpr Real outward = 1 + 1e-12;

  // At most, within the step. Most have no acceleration, and roots take long.
  [[nodiscard]] static Real way_of(const Vec3& velocity, const Vec3& acceleration) {
    return norm(velocity) + (acceleration == Vec3{0, 0, 0} ? 0 : 0.5 * norm(acceleration));
  }
  [[nodiscard]] Motion motion_of(std::uint32_t place) const {
    return velocities.motion_within(dt, places.infos[place].part.slot);
  }
  // A motion that a path refuses is refused before the step begins.
  [[nodiscard]] Path path(const Pose& start, const Vec3& centre, std::uint32_t place) const {
    const auto found = Path::along(start, centre, motion_of(place), 1);
    return found ? found.value() : Path::at_rest(start, 1);
  }
};

}  // namespace abut
