// SPDX-License-Identifier: Apache-2.0
// What a scene keeps of each geometry for those who look at many of them: arrays by place.
export module abut.scene.state.places;
import abut.core.standard;
import abut.math;
import abut.pairs.any_shape;
import abut.scene.state.options;

export namespace abut {

inline constexpr std::uint32_t no_patch = 0xffffffff;

// What has happened to a geometry since the last detection, by its place. All pairs ask for that in every detection, so
// it is one byte, apart from all that only some pairs ask for. A detection clears it for the geometries whose box it
// has refreshed; what happens to a parked one stays until it is back.
//
// - happened_to_box: set by the refresh, of what moved or changed; read by the focus and the selection.
// - happened_to_filters: set by new options and at creation; the selection asks the filters again.
// - happened_to_shape: set by set_shapes; the selection ends contacts and empties the memory.
// - happened_to_surface: set by edit_shapes; the selection empties the memory.
// - happened_to_tag: set by the focus and cleared at the end of that stage; pairs get another policy.
// - happened_on_path: set by the sweeps, of what they look at, and cleared at the end of the detection.
// - happened_on_way: set and cleared by the element stage, of what moves within the step or did so in the one before.
//   It is also set where detections with time and without follow each other.
enum Happened : std::uint8_t {
  happened_to_box = 1,
  happened_to_filters = 2,
  happened_to_shape = 4,
  happened_to_surface = 8,
  happened_to_tag = 16,
  happened_on_path = 32,
  happened_on_way = 64,
};

// What pairs, rules and queries ask about a geometry: one cache line.
struct PlaceInfo {
  std::uint64_t layers = 0, mask = 0, exclusion = 0;
  Real tolerance = 0;
  std::uint32_t generation = 0;
  PartId part;
  std::uint32_t label = 0, material = 0;
  std::uint32_t patch = no_patch;  // where alone it has changed since the last detection, if that is known
  std::uint8_t tag = 0;
  std::uint8_t kind = 0;  // place in the registry
  bool is_sensor : 1 = false;
  bool has_self_pairs : 1 = false;
  bool keeps_side : 1 = false;
  bool is_dynamic = false;  // its part is
  Sweeping sweeping = Sweeping::none;
  bool is_at_part = false;    // its pose is that of its part
  bool is_box_stale = false;  // set by what moves or changes it, cleared by the refresh that computes its box
  bool is_queued = false;     // only while a refresh makes its queue
};
static_assert(sizeof(PlaceInfo) <= 64);

// Where in the world a geometry that has not moved is not as it was, as far as its box reaches.
struct Patch {
  std::uint32_t place;
  Aabb box;
  CompactAabb compact_box;
};

// By slot of the geometry, less one. A place without a geometry has a shape that nobody else holds.
struct Places {
  ShapeHandle vacant;
  std::vector<ShapeHandle> shapes;
  std::vector<Pose> worlds;        // as of the last refresh
  std::vector<CompactAabb> boxes;  // as well; around what may touch
  std::vector<PlaceInfo> infos;
  std::vector<std::uint8_t> happened;  // bits of Happened

  explicit Places(ShapeHandle its_vacant) : vacant(std::move(its_vacant)) {}

  void make_room(std::size_t count) {
    const std::size_t size = std::max(count, shapes.size());
    shapes.resize(size, vacant);
    worlds.resize(size, Pose::identity());
    boxes.resize(size);
    infos.resize(size);
    happened.resize(size);
  }
  void note(std::uint32_t place, Happened what) { happened[place] |= what; }
  [[nodiscard]] bool has_happened(std::uint32_t place, unsigned bits) const { return (happened[place] & bits) != 0; }
  // Of a geometry that is there.
  [[nodiscard]] inline GeometryId id_at(std::uint32_t place) const { return {place + 1, infos[place].generation}; }
  [[nodiscard]] std::size_t bytes() const {
    return shapes.capacity() * sizeof(ShapeHandle) + worlds.capacity() * sizeof(Pose) +
           boxes.capacity() * sizeof(CompactAabb) + infos.capacity() * sizeof(PlaceInfo) + happened.capacity();
  }
};

}  // namespace abut
