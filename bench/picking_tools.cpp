// SPDX-License-Identifier: Apache-2.0
// What tools ask of a picker: a rectangle over 10^5 geometries beside a test of overlap with each of them, and whether
// rays meet anything beside what they meet first.
#include <abut/picking.h>

#include "mesh_files.hpp"
#include "ratios.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void check(abut_status status) {
  if (status == ABUT_OK) return;
  std::fprintf(stderr, "%s: %s\n", abut_status_name(status), abut_last_error_message());
  std::exit(1);
}

struct Delete {
  void operator()(abut_universe* universe) const { abut_universe_destroy(universe); }
  void operator()(abut_picker* picker) const { abut_picker_destroy(picker); }
  void operator()(abut_shape* shape) const { abut_shape_release(shape); }
};
using Shape = std::unique_ptr<abut_shape, Delete>;

template <class Create>
Shape shape_from(const Create& create) {
  abut_shape* made = nullptr;
  check(create(&made));
  return Shape(made);
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double in(double low, double high) { return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  abut_vec3 point(double reach) { return {in(-reach, reach), in(-reach, reach), in(-reach, reach)}; }

 private:
  std::mt19937_64 engine_;
};

class World {
 public:
  World() {
    abut_universe* universe = nullptr;
    check(abut_universe_create(nullptr, &universe));
    universe_.reset(universe);
    abut_picker* picker = nullptr;
    check(abut_picker_create(universe, &picker));
    picker_.reset(picker);
  }
  void add(const abut_shape* shape, const abut_vec3& position) {
    abut_part_options options;
    abut_part_options_init(&options, sizeof options);
    options.pose.position = position;
    abut_part_id part{};
    abut_geometry_id geometry{};
    check(abut_part_create(universe_.get(), &options, &part));
    check(abut_geometry_create(universe_.get(), part, shape, nullptr, &geometry));
    shapes.push_back(shape);
    poses.push_back(options.pose);
  }
  abut_picker* picker() const { return picker_.get(); }

  std::vector<const abut_shape*> shapes;
  std::vector<abut_pose> poses;

 private:
  std::unique_ptr<abut_universe, Delete> universe_;
  std::unique_ptr<abut_picker, Delete> picker_;
};

// A cloud of 10^5 primitives, 100 metres wide, that fills the picture.
struct Cloud {
  World world;
  std::array<Shape, 3> shapes{shape_from([](abut_shape** out) { return abut_sphere_create(0.4, out); }),
                              shape_from([](abut_shape** out) { return abut_box_create(0.4, 0.3, 0.2, out); }),
                              shape_from([](abut_shape** out) { return abut_capsule_create(0.2, 0.4, out); })};
  abut_camera camera{};
  std::vector<abut_geometry_id> found;

  Cloud() : found(count) {
    Random random(5);
    for (std::size_t i = 0; i < count; ++i) world.add(shapes.at(i % shapes.size()).get(), random.point(50));
    abut_camera_init(&camera, sizeof camera);
    const abut_vec3 eye{-120, 30, 40};
    const abut_vec3 target{0, 0, 0};
    const abut_vec3 up{0, 0, 1};
    check(abut_camera_look_at(&camera, &eye, &target, &up));
    check(abut_picker_update(world.picker()));
  }
  static constexpr std::size_t count = 100000;
};

// A square around the middle of the picture.
struct Square {
  const char* name;
  double half;
};
constexpr std::array<Square, 3> squares{{{"small", 20}, {"middle", 100}, {"large", 400}}};

void select(benchmark::State& state, Cloud& cloud, const Square& square, abut_selection selection) {
  std::size_t count = 0;
  for (auto _ : state) {
    check(abut_picker_select_rectangle(cloud.world.picker(), &cloud.camera, 320 - square.half, 240 - square.half,
                                       320 + square.half, 240 + square.half, selection, nullptr, cloud.found.data(),
                                       cloud.found.size(), &count));
  }
  state.counters["found"] = static_cast<double>(count);
}

// The frustum as a hull against each geometry.
void overlap_each(benchmark::State& state, Cloud& cloud, const Square& square) {
  std::vector<double> corners;
  for (const double x : {320 - square.half, 320 + square.half}) {
    for (const double y : {240 - square.half, 240 + square.half}) {
      abut_ray ray{};
      check(abut_camera_ray(&cloud.camera, x, y, &ray));
      for (const double along : {0.1, 500.0}) {
        corners.insert(corners.end(), {ray.origin.x + along * ray.direction.x, ray.origin.y + along * ray.direction.y,
                                       ray.origin.z + along * ray.direction.z});
      }
    }
  }
  const Shape frustum =
      shape_from([&](abut_shape** out) { return abut_hull_create(corners.data(), corners.size() / 3, out); });
  const std::vector<const abut_shape*> frusta(Cloud::count, frustum.get());
  std::vector<abut_pose> unmoved(Cloud::count);
  for (abut_pose& pose : unmoved) pose.orientation.w = 1;
  std::vector<std::uint32_t> out(Cloud::count);
  for (auto _ : state) {
    check(abut_pairs_overlap(cloud.world.shapes.data(), cloud.world.poses.data(), frusta.data(), unmoved.data(),
                             Cloud::count, nullptr, out.data()));
  }
  state.counters["found"] = static_cast<double>(std::count(out.begin(), out.end(), 1U));
}

// Rays to points above a scene, as of light: half of them end before anything.
std::vector<abut_ray> shadow_rays(const abut_vec3& low, const abut_vec3& high, bool are_neighbours) {
  Random random(6);
  constexpr std::size_t side = 512;
  std::vector<abut_ray> out;
  for (std::size_t i = 0; i < side * side; ++i) {
    const double u = are_neighbours ? static_cast<double>(i % side) / side : random.in(0, 1);
    const double v = are_neighbours ? static_cast<double>(i / side) / side : random.in(0, 1);
    const abut_vec3 from{low.x + u * (high.x - low.x), low.y + v * (high.y - low.y), 0.5 * (low.z + high.z)};
    const abut_vec3 light{high.x + 1, high.y + 2, 2 * high.z - low.z};
    const abut_vec3 to = are_neighbours ? light : abut_vec3{random.in(low.x, high.x), random.in(low.y, high.y), high.z};
    const abut_vec3 along{to.x - from.x, to.y - from.y, to.z - from.z};
    const double length = std::sqrt(along.x * along.x + along.y * along.y + along.z * along.z);
    out.push_back({from, {along.x / length, along.y / length, along.z / length}, are_neighbours ? infinity : length});
  }
  return out;
}

struct Shadows {
  std::string name;
  abut_picker* picker;
  std::vector<abut_ray> rays;
  abut_coherence coherence;
};

void nearest(benchmark::State& state, const Shadows& its) {
  std::vector<abut_pick> out(its.rays.size());
  for (auto _ : state)
    check(abut_picker_cast_rays(its.picker, its.rays.data(), its.rays.size(), its.coherence, nullptr, out.data()));
}

void any(benchmark::State& state, const Shadows& its) {
  std::vector<std::uint32_t> out(its.rays.size());
  for (auto _ : state)
    check(abut_picker_rays_hit(its.picker, its.rays.data(), its.rays.size(), its.coherence, nullptr, out.data()));
  state.counters["hits"] = static_cast<double>(std::count(out.begin(), out.end(), 1U));
}

template <class Function>
void add(const std::string& name, Function function) {
  benchmark::RegisterBenchmark(name.c_str(), function)->Unit(benchmark::kMillisecond);
}

int run() {
  Cloud cloud;
  for (const Square& square : squares) {
    const std::string cell = std::string("rectangle/") + square.name;
    add(cell + "/touching/abut", [&](auto& state) { select(state, cloud, square, ABUT_SELECTION_TOUCHING); });
    add(cell + "/touching/each", [&](auto& state) { overlap_each(state, cloud, square); });
    add(cell + "/inside/abut", [&](auto& state) { select(state, cloud, square, ABUT_SELECTION_INSIDE); });
  }
  World still;
  const bench::TriangleMesh bunny = bench::read_obj(std::string(ABUT_DATA_DIR) + "/bunny.obj");
  const Shape shape = shape_from([&](abut_shape** out) {
    return abut_mesh_create(bunny.xyz.data(), bunny.xyz.size() / 3, bunny.triangles.data(), bunny.triangles.size() / 3,
                            nullptr, out);
  });
  still.add(shape.get(), {0, 0, 0});
  check(abut_picker_update(still.picker()));
  abut_pose unmoved{};
  unmoved.orientation.w = 1;
  abut_aabb box{};
  check(abut_shape_aabb(shape.get(), &unmoved, &box));
  std::vector<Shadows> shadows;
  for (const bool are_neighbours : {false, true}) {
    const abut_coherence coherence = are_neighbours ? ABUT_COHERENCE_NEIGHBOURS : ABUT_COHERENCE_NONE;
    const std::string kind = are_neighbours ? "neighbours" : "unrelated";
    shadows.push_back(
        {"any/bunny/" + kind, still.picker(), shadow_rays(box.minimum, box.maximum, are_neighbours), coherence});
    shadows.push_back({"any/cloud/" + kind, cloud.world.picker(),
                       shadow_rays({-50, -50, -50}, {50, 50, 50}, are_neighbours), coherence});
  }
  for (const Shadows& its : shadows) {
    add(its.name + "/nearest", [&](auto& state) { nearest(state, its); });
    add(its.name + "/abut", [&](auto& state) { any(state, its); });
  }
  return bench::run_and_compare(
      {.ours = "abut", .judged = {"each", "nearest"}, .others = {}, .items = 1, .unit = "ms", .seconds = 1e-3});
}

}  // namespace

int main(int argument_count, char** arguments) { return bench::run_suite(argument_count, arguments, run); }
