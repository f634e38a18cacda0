// SPDX-License-Identifier: Apache-2.0
// Large meshes: contacts of two, depth of two solid ones, a plane, trees that are made and fitted, height fields of any
// size, and memory. FCL gives all contacts of all triangles; of abut's, those stay that hold a patch.
#include <abut/abut.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "abut_c_universe.hpp"
#include "mesh_files.hpp"
#include "meshes_fcl.hpp"
#include "ratios.hpp"

namespace bench {
namespace {

[[nodiscard]] std::string data_file(const std::string& name) { return std::string(ABUT_DATA_DIR "/") + name; }

[[nodiscard]] AbutCShape solid_or_sheet(const TriangleMesh& mesh, abut_sides sides) {
  abut_mesh_options options;
  abut_mesh_options_init(&options, sizeof options);
  options.sides = sides;
  abut_shape* shape = nullptr;
  expect_ok(abut_mesh_create(mesh.xyz.data(), mesh.xyz.size() / 3, mesh.triangles.data(), mesh.triangles.size() / 3,
                             &options, &shape));
  return AbutCShape(shape);
}

void prepare(const AbutCShape& shape, std::uint32_t threads) { expect_ok(abut_shape_prepare(shape.get(), threads)); }

// A gentle relief of squares, two triangles each.
[[nodiscard]] double height_at(double x, double y) { return std::sin(0.9 * x) * std::cos(0.7 * y); }
[[nodiscard]] TriangleMesh relief(std::uint32_t squares, double spacing) {
  TriangleMesh mesh;
  for (std::uint32_t j = 0; j <= squares; ++j) {
    for (std::uint32_t i = 0; i <= squares; ++i) {
      const double x = spacing * (i - 0.5 * squares), y = spacing * (j - 0.5 * squares);
      mesh.xyz.insert(mesh.xyz.end(), {x, y, height_at(x, y)});
      if (i < squares && j < squares) {
        const std::uint32_t a = j * (squares + 1) + i, c = a + squares + 1;
        mesh.triangles.insert(mesh.triangles.end(), {a, a + 1, c + 1, a, c + 1, c});
      }
    }
  }
  return mesh;
}

[[nodiscard]] double size_of(const TriangleMesh& mesh) {
  const auto [low, high] = std::ranges::minmax(mesh.xyz);
  return high - low;
}

// With the middle of its box at the origin.
[[nodiscard]] TriangleMesh centred(TriangleMesh mesh, double scale) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = axis; i < mesh.xyz.size(); i += 3) {
      low = std::min(low, mesh.xyz[i]);
      high = std::max(high, mesh.xyz[i]);
    }
    for (std::size_t i = axis; i < mesh.xyz.size(); i += 3) {
      mesh.xyz[i] = scale * (mesh.xyz[i] - 0.5 * (low + high));
    }
  }
  return mesh;
}

// Two shapes in places where they overlap by a share of the size: b is turned, moved along a way until it touches a,
// and then on.
struct Meeting {
  const abut_shape *a, *b;
  std::vector<Placement> places;  // of b

  Meeting(const abut_shape* first, const abut_shape* second, double size, bool from_above, double deep)
      : a(first), b(second) {
    for (int i = 0; i < 8; ++i) {
      const double turn = 0.3 + std::numbers::pi * i / 4, around = 0.2 + 0.785 * i;
      const Quaternion q{std::cos(turn / 2), 0.6 * std::sin(turn / 2), 0, 0.8 * std::sin(turn / 2)};
      const Point way = from_above ? Point{0, 0, -1} : Point{std::cos(around), std::sin(around), 0};
      const double far = 3;
      const Point aside = from_above ? Point{4 * size * std::cos(around), 4 * size * std::sin(around), 0} : Point{};
      const auto at = [&](double along) {
        return Placement{{aside[0] + along * way[0], aside[1] + along * way[1], aside[2] + along * way[2]}, q};
      };
      const abut_pose still{{0, 0, 0}, {1, 0, 0, 0}}, start = abut_c_pose(at(-far * size));
      const double distance = 2 * far * size;
      const abut_vec3 none{0, 0, 0}, displacement{distance * way[0], distance * way[1], distance * way[2]};
      abut_cast_hit hit{};
      std::uint32_t is_found = 0;
      expect_ok(abut_pair_cast(a, &still, &none, b, &start, &displacement, nullptr, &hit, &is_found));
      if (is_found == 0) {
        throw std::runtime_error("a mesh misses the other one");
      }
      places.push_back(at(hit.fraction * distance - far * size + deep * size));
    }
  }
};

// A mesh of which some vertices move to and fro.
class MovingMesh {
 public:
  MovingMesh(const TriangleMesh& mesh, std::size_t every) : universe_(quiet_universe()) {
    const AbutCShape shape = solid_or_sheet(mesh, ABUT_SIDES_BOTH);
    prepare(shape, 0);
    abut_part_id part{};
    expect_ok(abut_part_create(universe_.get(), nullptr, &part));
    expect_ok(abut_geometry_create(universe_.get(), part, shape.get(), nullptr, &geometry_));
    // The order of a shuffle by a step that has no divisor in common with the count.
    const std::size_t count = mesh.xyz.size() / 3, moved = count / every;
    for (std::size_t i = 0; i < moved; ++i) {
      const std::size_t at = (i * 7919 * every) % count;
      vertices_.push_back(static_cast<std::uint32_t>(at));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        xyz_.push_back(mesh.xyz[3 * at + axis]);
      }
    }
  }
  void move() {
    up_ = -up_;
    for (std::size_t i = 2; i < xyz_.size(); i += 3) {
      xyz_[i] += up_;
    }
    expect_ok(
        abut_geometry_set_vertices_at(universe_.get(), geometry_, vertices_.data(), xyz_.data(), vertices_.size()));
  }

 private:
  [[nodiscard]] static AbutCUniverse quiet_universe() {
    abut_universe_options options;
    abut_universe_options_init(&options, sizeof options);
    options.events = 0;
    return abut_c_universe(options);
  }

  AbutCUniverse universe_;
  abut_geometry_id geometry_{};
  std::vector<std::uint32_t> vertices_;
  std::vector<double> xyz_;
  double up_ = 0.01;
};

// What the benchmarks use while they run.
class Kept {
 public:
  template <class Owner>
  auto* keep(Owner made) {
    auto& all = std::get<std::vector<Owner>>(all_);
    all.push_back(std::move(made));
    return all.back().get();
  }
  template <class T, class... Arguments>
  T* make(const Arguments&... arguments) {
    return keep(std::make_unique<T>(arguments...));
  }
  const abut_shape* mesh(const TriangleMesh& mesh, abut_sides sides) {
    AbutCShape shape = solid_or_sheet(mesh, sides);
    prepare(shape, 0);
    return keep(std::move(shape));
  }

 private:
  template <class T>
  using Some = std::vector<std::unique_ptr<T>>;
  std::tuple<std::vector<AbutCShape>, Some<TriangleMesh>, Some<FclMesh>, Some<Meeting>, Some<MovingMesh>> all_;
};

const abut_pose origin{{0, 0, 0}, {1, 0, 0, 0}};

[[nodiscard]] std::size_t contact_count(const abut_shape* a, const abut_shape* b, const abut_pose& pose) {
  std::array<abut_contact, 4096> contacts;
  std::size_t count = 0;
  expect_ok(abut_pair_contacts(a, &origin, b, &pose, nullptr, contacts.data(), contacts.size(), &count));
  return count;
}

template <class Work>
void add(const std::string& name, const Work& work) {
  benchmark::RegisterBenchmark(name.c_str(), [work](benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) {
      work();
    }
  })->UseRealTime();
}

// A pair after the other; the time is that of all eight places.
void add_contacts(const std::string& cell, const Meeting* meeting, const FclMesh* fcl_a, const FclMesh* fcl_b) {
  std::size_t ours = 0, theirs = 0;
  for (const Placement& place : meeting->places) {
    ours += contact_count(meeting->a, meeting->b, abut_c_pose(place));
    theirs += fcl_a->contacts({{0, 0, 0}, {1, 0, 0, 0}}, *fcl_b, place);
  }
  std::printf("%s, eight places: %zu contacts of abut, %zu of FCL\n", cell.c_str(), ours, theirs);
  add(cell + "/abut", [meeting] {
    for (const Placement& place : meeting->places) {
      benchmark::DoNotOptimize(contact_count(meeting->a, meeting->b, abut_c_pose(place)));
    }
  });
  add(cell + "/fcl", [meeting, fcl_a, fcl_b] {
    for (const Placement& place : meeting->places) {
      benchmark::DoNotOptimize(fcl_a->contacts({{0, 0, 0}, {1, 0, 0, 0}}, *fcl_b, place));
    }
  });
}

void add_depths(const std::string& cell, const Meeting* meeting) {
  double widest = 0, deepest = 0;
  for (const Placement& place : meeting->places) {
    abut_distance found{};
    const abut_pose pose = abut_c_pose(place);
    expect_ok(abut_pair_distance(meeting->a, &origin, meeting->b, &pose, nullptr, &found));
    widest = std::max(widest, found.upper - found.lower);
    deepest = std::max(deepest, -found.distance);
  }
  std::printf("%s: at most %.3g deep, the interval at most %.3g wide\n", cell.c_str(), deepest, widest);
  add(cell + "/abut", [meeting] {
    for (const Placement& place : meeting->places) {
      abut_distance found{};
      const abut_pose pose = abut_c_pose(place);
      expect_ok(abut_pair_distance(meeting->a, &origin, meeting->b, &pose, nullptr, &found));
      benchmark::DoNotOptimize(found);
    }
  });
}

void add_pairs(Kept& kept) {
  const TriangleMesh dragon = centred(refined(read_ply(data_file("dragon_res4.ply"))), 1);
  if (const std::string cell = "two dragons of 44,408 that touch"; is_selected(cell)) {
    const abut_shape* const shape = kept.mesh(dragon, ABUT_SIDES_BOTH);
    const FclMesh* const fcl = kept.make<FclMesh>(dragon);
    add_contacts(cell, kept.make<Meeting>(shape, shape, size_of(dragon), false, 0.002), fcl, fcl);
  }
  if (const std::string cell = "bunny on terrain"; is_selected(cell)) {
    // As large as a hill, so that both have hundreds of triangles there.
    const TriangleMesh terrain = centred(read_terrain(data_file("jacksboro_dem.pgm")), 1);
    const TriangleMesh bunny = centred(read_obj(data_file("bunny.obj")), 100);
    add_contacts(cell,
                 kept.make<Meeting>(kept.mesh(terrain, ABUT_SIDES_BOTH), kept.mesh(bunny, ABUT_SIDES_BOTH),
                                    size_of(bunny), true, 0.01),
                 kept.make<FclMesh>(terrain), kept.make<FclMesh>(bunny));
  }
  for (const auto& [name, deep] : {std::pair("a hundredth", 0.01), std::pair("a tenth", 0.1)}) {
    if (const std::string cell = std::string("depth of two solid dragons, ") + name; is_selected(cell)) {
      const abut_shape* const shape = kept.mesh(dragon, ABUT_SIDES_SOLID);
      add_depths(cell, kept.make<Meeting>(shape, shape, size_of(dragon), false, deep));
    }
  }
}

void add_plane(Kept& kept) {
  if (const std::string cell = "plane below 1,280,000"; is_selected(cell)) {
    const TriangleMesh mesh = relief(800, 0.1);
    const abut_shape* const shape = kept.mesh(mesh, ABUT_SIDES_BOTH);
    const abut_vec3 up{0, 0, 1};
    abut_shape* made = nullptr;
    expect_ok(abut_plane_create(&up, -1.5, &made));
    const abut_shape* const plane = kept.keep(AbutCShape(made));
    const FclMesh* const fcl = kept.make<FclMesh>(mesh);
    if (contact_count(plane, shape, origin) + fcl->contacts_below(-1.5) != 0) {
      throw std::runtime_error("the plane touches the mesh");
    }
    add(cell + "/abut", [=] { benchmark::DoNotOptimize(contact_count(plane, shape, origin)); });
    add(cell + "/fcl", [=] { benchmark::DoNotOptimize(fcl->contacts_below(-1.5)); });
  }
}

void add_trees(Kept& kept) {
  if (const std::string cell = "tree of 999,698"; is_selected(cell)) {
    const TriangleMesh* const mesh = kept.make<TriangleMesh>(relief(707, 0.1));
    for (const auto& [contender, threads] : {std::pair("abut", 0u), std::pair("abut-1", 1u)}) {
      add(cell + "/" + contender, [mesh, count = threads] {
        const AbutCShape shape = solid_or_sheet(*mesh, ABUT_SIDES_BOTH);
        prepare(shape, count);
      });
    }
    add(cell + "/fcl", [mesh] { benchmark::DoNotOptimize(FclMesh(*mesh)); });
  }
}

void add_moves(Kept& kept) {
  for (const auto& [name, every] : {std::pair("1 % of the vertices of 999,698 move", std::size_t{100}),
                                    std::pair("all vertices of 999,698 move", std::size_t{1})}) {
    if (is_selected(name)) {
      MovingMesh* const moving = kept.make<MovingMesh>(relief(707, 0.1), every);
      moving->move();
      add(std::string(name) + "/abut", [moving] { moving->move(); });
    }
  }
}

void add_height_fields(Kept& kept) {
  abut_shape* made = nullptr;
  expect_ok(abut_box_create(0.5, 0.4, 0.3, &made));
  const abut_shape* const box = kept.keep(AbutCShape(made));
  for (const std::uint32_t side : {64u, 4096u}) {
    const std::string cell = "box on a height field of " + std::to_string(side) + "^2";
    if (!is_selected(cell)) {
      continue;
    }
    std::vector<double> heights;
    for (std::uint32_t j = 0; j < side; ++j) {
      for (std::uint32_t i = 0; i < side; ++i) {
        heights.push_back(height_at(0.15 * (i - 0.5 * side), 0.15 * (j - 0.5 * side)));
      }
    }
    abut_height_field_desc desc;
    abut_height_field_desc_init(&desc, sizeof desc);
    desc.columns = desc.rows = side;
    desc.spacing_x = desc.spacing_y = 0.15;
    desc.heights = heights.data();
    expect_ok(abut_height_field_create(&desc, &made));
    const abut_shape* const field = kept.keep(AbutCShape(made));
    // The first sample is the origin of the shape: the middle of both fields is the same place of the relief.
    const double middle = 0.15 * 0.5 * side;
    add(cell + "/abut", [=] {
      for (int i = 0; i < 100; ++i) {
        const double x = 0.03 * i - 1.5, y = 0.02 * i - 1;
        const abut_pose pose{{middle + x, middle + y, height_at(x, y) + 0.25},
                             {std::cos(0.1 * i), 0.6 * std::sin(0.1 * i), 0, 0.8 * std::sin(0.1 * i)}};
        benchmark::DoNotOptimize(contact_count(field, box, pose));
      }
    });
  }
}

void print_memory() {
  for (const std::uint32_t squares : {224u, 707u}) {
    const TriangleMesh mesh = relief(squares, 0.1);
    std::uint64_t before = 0, after = 0, blocks = 0;
    expect_ok(abut_memory_in_use(&before, &blocks));
    const AbutCShape shape = solid_or_sheet(mesh, ABUT_SIDES_BOTH);
    prepare(shape, 0);
    expect_ok(abut_memory_in_use(&after, &blocks));
    const auto triangles = static_cast<double>(mesh.triangles.size() / 3);
    const double input = 8.0 * static_cast<double>(mesh.xyz.size()) + 4.0 * static_cast<double>(mesh.triangles.size());
    std::printf("mesh of %.0f triangles: %.1f bytes a triangle beside the %.1f of its input\n", triangles,
                (static_cast<double>(after - before) - input) / triangles, input / triangles);
  }
}

int run() {
  Kept kept;
  add_pairs(kept);
  add_plane(kept);
  add_trees(kept);
  add_moves(kept);
  add_height_fields(kept);
  const int status = run_and_compare({"abut", {"fcl"}, {"abut-1"}, 1, "us", 1e-6});
  if (is_selected("memory")) {
    print_memory();
  }
  return status;
}

}  // namespace
}  // namespace bench

int main(int argument_count, char** arguments) { return bench::run_suite(argument_count, arguments, bench::run); }
