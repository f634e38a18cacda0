// SPDX-License-Identifier: Apache-2.0
// The whole step of a cloth through the C interface: candidates, first touches, closest features and crossings, of its
// elements and in steps of a universe.
//
// usage: abut_bench_elements_c FOLDER
//
// FOLDER holds cloth_ball92.ply and cloth_ball93.ply; see cloth_file.hpp. The program fails unless its counts are the
// published ones.
#include <abut/abut.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <limits>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "cloth_file.hpp"

namespace {

void require(abut_status status) {
  if (status != ABUT_OK) {
    throw std::runtime_error(abut_last_error_message());
  }
}

double clock_milliseconds() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
double processor_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// A search into the memory of the caller: the second of two calls is timed, by the processor and by the clock.
template <class Value, class Ask>
std::vector<Value> search(const char* what, Ask ask, abut_elements* elements, const abut_elements_options& options) {
  std::size_t count = 0;
  require(ask(elements, nullptr, &options, nullptr, 0, &count));
  std::vector<Value> out(count);
  const double start = processor_milliseconds(), at = clock_milliseconds();
  require(ask(elements, nullptr, &options, out.data(), out.size(), &count));
  std::printf("%-28s %9zu, %7.1f ms of the processor, %7.1f by the clock on %u threads\n", what, count,
              processor_milliseconds() - start, clock_milliseconds() - at, options.threads);
  return out;
}

bool check(const char* what, std::size_t got, std::size_t published) {
  std::printf("%-28s %9zu, published %9zu%s\n", what, got, published, got == published ? "" : "  DIFFERENT");
  return got == published;
}

struct Counts {
  std::size_t vertices = 0, edges = 0;
};
template <class Value>
Counts counts_of(const std::vector<Value>& all) {
  Counts counts;
  for (const Value& each : all) {
    ++(each.kind == 1 ? counts.edges : counts.vertices);
  }
  return counts;
}

// All vertices of the mesh move, whose tree is there: by a copy, and by an exchange. The least of several times.
void run_moves(const abut_bench::ClothFrame& now, const abut_bench::ClothFrame& next) {
  abut_universe* universe = nullptr;
  require(abut_universe_create(nullptr, &universe));
  abut_shape* mesh = nullptr;
  require(abut_mesh_create(now.xyz.data(), now.xyz.size() / 3, now.triangles.data(), now.triangles.size() / 3, nullptr,
                           &mesh));
  abut_part_id part{};
  require(abut_part_create(universe, nullptr, &part));
  abut_geometry_id cloth{};
  require(abut_geometry_create(universe, part, mesh, nullptr, &cloth));
  abut_shape_release(mesh);
  require(abut_geometry_shape(universe, cloth, &mesh));
  require(abut_shape_prepare(mesh, 1));
  abut_shape_release(mesh);
  double by_copy = std::numeric_limits<double>::infinity(), by_exchange = by_copy;
  for (int run = 0; run < 20; ++run) {
    const std::vector<double>& xyz = run % 2 == 0 ? next.xyz : now.xyz;
    const double start = processor_milliseconds();
    require(abut_geometry_set_vertices(universe, cloth, 0, xyz.data(), xyz.size() / 3));
    by_copy = std::fmin(by_copy, processor_milliseconds() - start);
  }
  for (int run = 0; run < 20; ++run) {
    const std::vector<double>& xyz = run % 2 == 0 ? next.xyz : now.xyz;
    double* lent = nullptr;
    std::size_t count = 0;
    require(abut_geometry_next_vertices(universe, cloth, &lent, &count));
    std::copy(xyz.begin(), xyz.end(), lent);
    const double start = processor_milliseconds();
    require(abut_geometry_advance(universe, cloth));
    by_exchange = std::fmin(by_exchange, processor_milliseconds() - start);
  }
  std::printf("move all and fit the tree    %7.2f ms by a copy, %.2f by an exchange\n", by_copy, by_exchange);
  abut_universe_destroy(universe);
}

// The same step by a universe in which the cloth is fast, and then steps of the cloth at rest.
bool run_in_universe(const abut_bench::ClothFrame& now, const abut_bench::ClothFrame& next, std::uint32_t threads) {
  abut_universe_options options;
  abut_universe_options_init(&options, sizeof options);
  options.tolerance_mode = ABUT_TOLERANCE_MARGIN;
  options.threads = threads;
  abut_universe* universe = nullptr;
  require(abut_universe_create(&options, &universe));
  abut_policy policy;
  abut_policy_init(&policy, sizeof policy);
  policy.detail = ABUT_DETAIL_ELEMENTS;
  require(abut_policy_set(universe, 0, 0, &policy));
  abut_shape* mesh = nullptr;
  require(abut_mesh_create(now.xyz.data(), now.xyz.size() / 3, now.triangles.data(), now.triangles.size() / 3, nullptr,
                           &mesh));
  abut_part_id part{};
  require(abut_part_create(universe, nullptr, &part));
  abut_geometry_options its;
  abut_geometry_options_init(&its, sizeof its);
  its.flags = ABUT_GEOMETRY_SELF_PAIRS | ABUT_GEOMETRY_FAST;
  abut_geometry_id cloth{};
  require(abut_geometry_create(universe, part, mesh, &its, &cloth));
  abut_shape_release(mesh);
  const auto step = [&](const char* what) {
    const double start = processor_milliseconds(), at = clock_milliseconds();
    require(abut_universe_step(universe, 0.01));
    std::printf("%-28s %7.1f ms of the processor, %7.1f by the clock on %u threads\n", what,
                processor_milliseconds() - start, clock_milliseconds() - at, threads);
    const abut_element_contact* contacts = nullptr;
    std::size_t count = 0;
    require(abut_universe_element_contacts(universe, &contacts, &count));
    std::vector<abut_stencil> stencils;
    for (const abut_element_contact& contact : std::span(contacts, count)) {
      stencils.push_back(contact.stencil);
    }
    return counts_of(stencils);
  };
  step("step that makes elements");
  require(abut_geometry_set_vertices(universe, cloth, 0, next.xyz.data(), next.xyz.size() / 3));
  const Counts touches = step("step of the cloth");
  bool is_right = check("vertices that touch faces", touches.vertices, 19032);
  is_right = check("edges that touch", touches.edges, 94822) && is_right;
  step("step that ends its way");
  step("step at rest");
  abut_universe_destroy(universe);
  return is_right;
}

bool run(const std::string& folder) {
  const auto now = abut_bench::read_cloth_frame(folder + "/cloth_ball92.ply");
  const auto next = abut_bench::read_cloth_frame(folder + "/cloth_ball93.ply");
  run_moves(now, next);
  abut_shape* mesh = nullptr;
  abut_elements* elements = nullptr;
  require(abut_mesh_create(now.xyz.data(), now.xyz.size() / 3, now.triangles.data(), now.triangles.size() / 3, nullptr,
                           &mesh));
  const double start = processor_milliseconds();
  require(abut_elements_create(mesh, &elements));
  std::printf("create                       %7.1f ms\n", processor_milliseconds() - start);
  abut_shape_release(mesh);
  require(abut_elements_set_vertices(elements, now.xyz.data(), next.xyz.data(), now.xyz.size() / 3));

  abut_elements_options options;
  abut_elements_options_init(&options, sizeof options);
  bool is_right = true;
  for (const std::uint32_t threads : {1U, 2U}) {
    options.threads = threads;
    options.reach = 0;
    const Counts pairs =
        counts_of(search<abut_element_pair>("candidates", abut_elements_candidates, elements, options));
    is_right = check("vertices and faces", pairs.vertices, 1655541) && is_right;
    is_right = check("pairs of edges", pairs.edges, 5197332) && is_right;
    const auto stencils = search<abut_stencil>("first touches", abut_elements_first_touches, elements, options);
    const Counts touches = counts_of(stencils);
    is_right = check("vertices that touch faces", touches.vertices, 19032) && is_right;
    is_right = check("edges that touch", touches.edges, 94822) && is_right;
    double first = std::numeric_limits<double>::infinity();
    for (const abut_stencil& each : stencils) {
      first = std::fmin(first, each.toi);
    }
    std::printf("earliest touch               %g\n", first);
  }
  std::set<std::pair<std::uint32_t, std::uint32_t>> crossing;
  options.threads = 1;
  for (const abut_crossing& each : search<abut_crossing>("crossings", abut_elements_crossings, elements, options)) {
    crossing.insert({each.edge, each.face});
  }
  std::printf("edges that pass faces        %9zu\n", crossing.size());

  // A thousandth of the size.
  options.reach = 1e-3 * 2;
  require(abut_elements_set_vertices(elements, now.xyz.data(), nullptr, now.xyz.size() / 3));
  for (const abut_closest_method method : {ABUT_CLOSEST_FEATURES, ABUT_CLOSEST_OF_FACES, ABUT_CLOSEST_ALL,
                                           ABUT_CLOSEST_OF_VERTICES, ABUT_CLOSEST_LOCAL_MINIMA}) {
    options.method = method;
    for (const std::uint32_t threads : {1U, 2U}) {
      options.threads = threads;
      search<abut_stencil>(("closest, method " + std::to_string(method)).c_str(), abut_elements_closest, elements,
                           options);
    }
  }
  abut_elements_destroy(elements);
  for (const std::uint32_t threads : {1U, 2U}) {
    is_right = run_in_universe(now, next, threads) && is_right;
  }
  return is_right;
}

}  // namespace

int main(int argc, char** argv) {
  const std::span<char*> arguments(argv, static_cast<std::size_t>(argc));
  if (arguments.size() != 2) {
    std::fprintf(stderr, "usage: abut_bench_elements_c FOLDER\n");
    return 2;
  }
  try {
    return run(arguments[1]) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
