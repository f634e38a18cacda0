// SPDX-License-Identifier: Apache-2.0
// Rays through abut_picking beside Embree's own calls: the same mesh, the same rays, one thread.
//
// The raw rows use Embree as its manual shows it: one triangle geometry, default flags, rays prepared
// in Embree's layout before the clock starts. The abut rows start from abut_ray, check it, and end in
// abut_pick with the hit computed again in double.
#include <abut/picking.h>

#include "mesh_files.hpp"
#include "ratios.hpp"
#include "raw_embree.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using abut_bench::Mesh;
using bench::read_obj;
using bench::read_terrain;
using abut_bench::Packing;
using abut_bench::RawScene;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t picture_width = 640;
constexpr std::uint32_t picture_height = 480;
constexpr std::size_t ray_count = std::size_t{picture_width} * picture_height;

void check(abut_status status) {
  if (status == ABUT_OK) return;
  std::fprintf(stderr, "%s: %s\n", abut_status_name(status), abut_last_error_message());
  std::exit(1);
}

struct Rays {
  std::vector<abut_ray> rays;
  bool are_neighbours;
};

// The rays of a picture of the whole mesh, row by row.
abut_camera camera_on(const Mesh& mesh) {
  const auto [low, high] = abut_bench::bounds_of(mesh);
  const abut_vec3 target{0.5 * (low.x + high.x), 0.5 * (low.y + high.y), 0.5 * (low.z + high.z)};
  const double size = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const abut_vec3 eye{target.x - 0.4 * size, target.y - 0.55 * size, target.z + 0.25 * size};
  const abut_vec3 up{0, 0, 1};
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  camera.width = picture_width;
  camera.height = picture_height;
  check(abut_camera_look_at(&camera, &eye, &target, &up));
  return camera;
}

Rays camera_rays(const abut_camera& camera) {
  Rays out{{}, true};
  for (std::uint32_t y = 0; y < camera.height; ++y) {
    for (std::uint32_t x = 0; x < camera.width; ++x) {
      abut_ray ray;
      check(abut_camera_ray(&camera, x + 0.5, y + 0.5, &ray));
      out.rays.push_back(ray);
    }
  }
  return out;
}

Rays random_rays(const Mesh& mesh) {
  const auto [low, high] = abut_bench::bounds_of(mesh);
  std::mt19937_64 random(7);
  const auto between = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11U) * 0x1p-53; };
  const auto point = [&] { return abut_vec3{between(low.x, high.x), between(low.y, high.y), between(low.z, high.z)}; };
  Rays out{{}, false};
  for (std::size_t i = 0; i < ray_count; ++i) {
    const abut_vec3 from = point();
    const abut_vec3 to = point();
    const abut_vec3 along{to.x - from.x, to.y - from.y, to.z - from.z};
    const double length = std::sqrt(along.x * along.x + along.y * along.y + along.z * along.z);
    out.rays.push_back({from, {along.x / length, along.y / length, along.z / length}, infinity});
  }
  return out;
}

struct Delete {
  void operator()(abut_universe* universe) const { abut_universe_destroy(universe); }
  void operator()(abut_picker* picker) const { abut_picker_destroy(picker); }
  void operator()(abut_shape* shape) const { abut_shape_release(shape); }
};

// A universe that holds one mesh.
struct World {
  std::unique_ptr<abut_universe, Delete> universe;
  std::unique_ptr<abut_picker, Delete> picker;

  explicit World(const Mesh& mesh) {
    abut_universe* made_universe = nullptr;
    check(abut_universe_create(nullptr, &made_universe));
    universe.reset(made_universe);
    abut_shape* made_shape = nullptr;
    check(abut_mesh_create(mesh.xyz.data(), mesh.xyz.size() / 3, mesh.triangles.data(), mesh.triangles.size() / 3,
                           nullptr, &made_shape));
    const std::unique_ptr<abut_shape, Delete> shape(made_shape);
    abut_part_id part{};
    abut_geometry_id geometry{};
    check(abut_part_create(universe.get(), nullptr, &part));
    check(abut_geometry_create(universe.get(), part, shape.get(), nullptr, &geometry));
    abut_picker* made_picker = nullptr;
    check(abut_picker_create(universe.get(), &made_picker));
    picker.reset(made_picker);
    check(abut_picker_update(picker.get()));
  }
};

void finish(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(ray_count));
}

void raw(benchmark::State& state, const RawScene& scene, const Rays& rays, std::size_t width, bool coherent) {
  Packing packing(rays.rays, width);
  for (auto _ : state) {
    scene.trace(packing, coherent);
    benchmark::ClobberMemory();
  }
  finish(state);
}

void single(benchmark::State& state, World& world, const Rays& rays) {
  std::vector<abut_pick> picks(rays.rays.size());
  for (auto _ : state) {
    for (std::size_t i = 0; i < rays.rays.size(); ++i)
      abut_picker_cast_ray(world.picker.get(), &rays.rays[i], nullptr, &picks[i]);
    benchmark::ClobberMemory();
  }
  finish(state);
}

void batch(benchmark::State& state, World& world, const Rays& rays) {
  std::vector<abut_pick> picks(rays.rays.size());
  const abut_coherence coherence = rays.are_neighbours ? ABUT_COHERENCE_NEIGHBOURS : ABUT_COHERENCE_NONE;
  for (auto _ : state) {
    abut_picker_cast_rays(world.picker.get(), rays.rays.data(), rays.rays.size(), coherence, nullptr, picks.data());
    benchmark::ClobberMemory();
  }
  finish(state);
}

void render(benchmark::State& state, World& world, const abut_camera& camera) {
  std::vector<abut_pick> picks(ray_count);
  for (auto _ : state) {
    abut_picker_render(world.picker.get(), &camera, nullptr, picks.data(), picks.size());
    benchmark::ClobberMemory();
  }
  finish(state);
}

struct Subject {
  std::string name;
  Mesh mesh;
  std::unique_ptr<RawScene> scene;
  std::unique_ptr<RawScene> robust_scene;
  std::unique_ptr<World> world;
  abut_camera camera;
  std::map<std::string, Rays> rays;
};

// One by one against rtcIntersect1; batches and pictures against the best of Embree's packets. The robust mode gives
// the same guarantee, no cracks between triangles, and is what the ratio is about; the raw rows are its plain mode.
void register_rows(Subject& subject) {
  for (auto& [kind, rays] : subject.rays) {
    const auto add = [&](const std::string& cell, const std::string& contender, auto function) {
      const std::string name = subject.name + "/" + kind + "/" + cell + "/" + contender;
      benchmark::RegisterBenchmark(name.c_str(), function)->Unit(benchmark::kMillisecond);
    };
    add("single", "raw_1", [&](benchmark::State& state) { raw(state, *subject.scene, rays, 1, false); });
    add("single", "robust_1", [&](benchmark::State& state) { raw(state, *subject.robust_scene, rays, 1, false); });
    add("single", "abut", [&](benchmark::State& state) { single(state, *subject.world, rays); });
    std::vector<std::string> cells{"batch"};
    if (rays.are_neighbours) cells.emplace_back("picture");
    for (const std::string& cell : cells) {
      for (const std::size_t width : {8U, 16U}) {
        for (const bool coherent : {false, true}) {
          const std::string packet = std::to_string(width) + (coherent ? "c" : "");
          add(cell, "raw_" + packet, [&subject, &rays, width, coherent](benchmark::State& state) {
            raw(state, *subject.scene, rays, width, coherent);
          });
          add(cell, "robust_" + packet, [&subject, &rays, width, coherent](benchmark::State& state) {
            raw(state, *subject.robust_scene, rays, width, coherent);
          });
        }
      }
    }
    add("batch", "abut", [&](benchmark::State& state) { batch(state, *subject.world, rays); });
    if (rays.are_neighbours) {
      add("picture", "abut", [&](benchmark::State& state) { render(state, *subject.world, subject.camera); });
    }
  }
}

int run() {
  const std::string data = ABUT_DATA_DIR;
  std::vector<Subject> subjects(2);
  subjects[0].name = "terrain";
  subjects[0].mesh = read_terrain(data + "/jacksboro_dem.pgm");
  subjects[1].name = "bunny";
  subjects[1].mesh = read_obj(data + "/bunny.obj");
  for (Subject& subject : subjects) {
    subject.scene = std::make_unique<RawScene>(subject.mesh, false);
    subject.robust_scene = std::make_unique<RawScene>(subject.mesh, true);
    subject.world = std::make_unique<World>(subject.mesh);
    subject.camera = camera_on(subject.mesh);
    subject.rays.emplace("camera", camera_rays(subject.camera));
    subject.rays.emplace("random", random_rays(subject.mesh));
    register_rows(subject);
  }
  return bench::run_and_compare({.ours = "abut",
                                 .judged = {"robust_1", "robust_8", "robust_8c", "robust_16", "robust_16c"},
                                 .others = {"raw_1", "raw_8", "raw_8c", "raw_16", "raw_16c"},
                                 .items = static_cast<double>(ray_count),
                                 .unit = "ns",
                                 .seconds = 1e-9});
}

}  // namespace

int main(int argument_count, char** arguments) { return bench::run_suite(argument_count, arguments, run); }
