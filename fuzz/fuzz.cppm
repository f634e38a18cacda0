// SPDX-License-Identifier: Apache-2.0
// Scenes of two shapes from any bytes, and a judge of what the library answers about them. Knows
// nothing of the fuzzing engine.
module;
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>
export module abut.fuzz;
import abut.capability;
import abut.core;
import abut.math;
import abut.motion.paths.path;
import abut.motion.time_of_impact;
import abut.pairs.any_shape;
import abut.pairs.registry;

export namespace abut::fuzz {

// ---- the record: a fixed layout, little-endian, so that a corpus keeps its meaning ----

inline constexpr std::size_t number_count = 8 + 8 + 4 + 3 + 2;
inline constexpr std::size_t record_size = 2 + 8 * number_count;

// Bits of Record::flags. They shape the kinds that are made from buffers, and the pose.
inline constexpr std::uint8_t flat_a = 1, doubled_a = 2, flat_b = 4, doubled_b = 8, lattice = 16, one_sided = 32,
                              parallel = 64, of_cells = 128;

struct Record {
  std::uint8_t version = 1;
  std::uint8_t flags = 0;
  std::array<Real, 8> a{};
  std::array<Real, 8> b{};
  std::array<Real, 4> rotation{};  // quaternion of b in the frame of a; w, x, y, z
  std::array<Real, 3> position{};
  std::array<Real, 2>
      extra{};  // margin of the contact query; how distance fields are interpolated and bent, 0: neither
};

// Missing bytes are zero, further ones are ignored.
[[nodiscard]] Record read_record(std::span<const std::uint8_t> bytes);
[[nodiscard]] std::array<std::uint8_t, record_size> bytes_of(const Record& record);
// Every number by its place in the layout.
[[nodiscard]] Real number_at(const Record& record, std::size_t index);
void set_number(Record& record, std::size_t index, Real value);
[[nodiscard]] Record random_record(std::uint64_t seed);

// Numbers that depend on the seed alone: SplitMix64.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  [[nodiscard]] std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15;
    return scrambled(state_);
  }
  [[nodiscard]] std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() % count); }
  [[nodiscard]] Real between(Real low, Real high) {
    return low + (high - low) * static_cast<Real>(bits() >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

// ---- the scene: what a record means for a pair of kinds ----

struct ShapeInput {
  std::vector<Real> parameters;
  std::vector<Real> reals;
  std::vector<std::uint32_t> indices;
};

struct Scene {
  ShapeHandle a, b;
  Pose ab;
  Real margin;
  Real size;  // largest magnitude of any length in the scene
};

// Finite, and of a magnitude in which squares neither overflow nor vanish.
[[nodiscard]] Real tamed(Real value);
[[nodiscard]] ShapeInput shape_input(std::size_t place, const std::array<Real, 8>& numbers, bool flat, bool doubled,
                                     std::uint8_t flags);
// Lengths times `scale`. Every record gives a scene; an error is a fault of the library.
[[nodiscard]] Result<Scene> make_scene(std::size_t place_a, std::size_t place_b, const Record& record, Real scale = 1);
[[nodiscard]] Scene swapped(const Scene& scene);

// ---- the oracle ----

// What went wrong, in words; nothing when all is well.
using Verdict = std::optional<std::string>;

[[nodiscard]] Real tolerance(const Scene& scene);
// The gap along a direction between two convex shapes, never more than their distance.
[[nodiscard]] std::optional<Real> gap_along(const Scene& scene, const Vec3& direction);

// How far a convex shape reaches along a unit direction of its own frame.
[[nodiscard]] std::optional<Real> reach_along(const AnyShape& shape, const Vec3& direction);
// How far one shape has to move to be parted from the other, where one is a surface and the other convex: along the
// best of the normals of contacts and of triangles that overlap.
[[nodiscard]] std::optional<Real> depth_bound(const Scene& scene, const Manifold& found);

// How deep a surface of two sides and a convex shape, or two such surfaces, are in each other at least. No less than
// `known`. The normals of contacts save time, and change nothing.
[[nodiscard]] std::optional<Real> least_depth(const Scene& scene, const Manifold& found, Real known);

[[nodiscard]] Verdict judge_distance(const Scene& scene, const Distance& found);
[[nodiscard]] Verdict judge_contacts(const Scene& scene, const Distance& distance, const Manifold& found);
// Our second route must agree. libccd may be wrong; what it says counts when the gap along its own
// normal is larger than the distance, which cannot be.
[[nodiscard]] Verdict judge_other_routes(const Scene& scene, const Distance& found);
// Asks the library everything about the scene of a record and judges the answers.
[[nodiscard]] Verdict judge(std::size_t place_a, std::size_t place_b, const Record& record);

// ---- two shapes that move ----

// How each body moves: velocity, angular velocity, acceleration, angular acceleration and centre, three numbers each.
inline constexpr std::size_t motion_number_count = 2 * 5 * 3;
inline constexpr std::size_t moving_record_size = record_size + 1 + 8 * motion_number_count;

// Bits of MovingRecord::aim. Without any, the numbers alone say how the bodies move.
inline constexpr std::uint8_t meets = 1, rests = 2, turns_not = 4, moves_alike = 8, grazes = 16, speeds_not_up = 32,
                              starts_touching = 64;

// After the bytes of the record of the scene come the aim and the numbers.
struct MovingRecord {
  Record scene;
  std::uint8_t aim = 0;
  std::array<Real, motion_number_count> motion{};
};

[[nodiscard]] MovingRecord read_moving_record(std::span<const std::uint8_t> bytes);
[[nodiscard]] std::array<std::uint8_t, moving_record_size> bytes_of(const MovingRecord& record);
[[nodiscard]] MovingRecord random_moving_record(std::uint64_t seed);

struct MovingScene {
  Scene scene;
  Path path_a, path_b;
};
[[nodiscard]] Result<MovingScene> make_moving_scene(std::size_t place_a, std::size_t place_b,
                                                    const MovingRecord& record);

// Whether an answer about a motion holds at many times.
[[nodiscard]] Verdict judge_impact(const MovingScene& moving, const Impact& found);
// The same for all that is asked: swapped shapes, another frame, and the motion in two halves as well.
[[nodiscard]] Verdict judge_motion(std::size_t place_a, std::size_t place_b, const MovingRecord& record);

// ---- changes that random bits rarely make ----

void mutate(std::size_t place_a, std::size_t place_b, Record& record, std::uint64_t seed);
// Moves b along the normal until the shapes touch.
void snap_to_touching(std::size_t place_a, std::size_t place_b, Record& record);
void mutate(std::size_t place_a, std::size_t place_b, MovingRecord& record, std::uint64_t seed);

}  // namespace abut::fuzz
