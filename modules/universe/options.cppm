// The records that a universe takes and gives.
module;
#include <cstdint>
export module abut.universe.options;
import abut.any_shape;
import abut.core;
import abut.math;
import abut.shape;

export namespace abut {

struct PartTag;
struct GeometryTag;
using PartId = Id<PartTag>;
using GeometryId = Id<GeometryTag>;

enum class Broadphase : std::uint32_t { automatic, brute, tree };
enum class ToleranceMode : std::uint32_t { dead_band, margin };
enum class MotionKind : std::uint32_t { dynamic, animated, fixed };

struct UniverseOptions {
  Broadphase broadphase = Broadphase::automatic;
  ToleranceMode tolerance_mode = ToleranceMode::dead_band;
  std::uint32_t max_contacts = 4;  // per patch; 0 keeps all
  Vec3 origin{0, 0, 0};            // of the compact boxes
};

// A position with the quaternion as it was given (normalised), so that poses read back as they were set.
struct Placement {
  Vec3 position{0, 0, 0};
  Quat orientation{1, 0, 0, 0};

  [[nodiscard]] inline Pose pose() const { return {Rotation::from(orientation), position}; }
};

struct PartOptions {
  MotionKind motion = MotionKind::dynamic;
  Placement placement;
  std::uint64_t user_data = 0;
};

struct GeometryOptions {
  Placement local;     // in the frame of the part
  Real tolerance = 0;  // not negative; the tolerance of a pair is the sum
  std::uint64_t user_data = 0;
};

struct GeometryInfo {
  PartId part;
  ShapeHandle shape;
  Placement world;
  Placement local;
  Real tolerance;
  std::uint64_t user_data;
};

struct Revision {
  std::uint64_t geometries = 0;  // grows when one is created or destroyed
  std::uint64_t poses = 0;       // grows when one is set
};

struct Contact {
  GeometryId geometry_a, geometry_b;
  ContactPoint point;           // in the world frame
  std::uint32_t age = 0;        // steps in a row before this one that reported it
  std::uint64_t user_data = 0;  // stays while the contact does
};

struct StepStats {
  std::uint64_t parts = 0, geometries = 0, moved = 0;
  std::uint64_t candidate_pairs = 0, touching_pairs = 0, contacts = 0, unsupported_pairs = 0;
  std::uint64_t bytes = 0;
  double refresh_microseconds = 0, broadphase_microseconds = 0, narrowphase_microseconds = 0, contact_microseconds = 0;
};

}  // namespace abut
