// SPDX-License-Identifier: Apache-2.0
// Shapes of geometries change in place, parts get velocities, islands are followed.
#include <algorithm>
#include <array>
#include <iterator>
#include <set>

#include "play.hpp"

namespace universe_calls {
namespace {

bool is_same(const abut_velocity& a, const abut_velocity& b) {
  const auto numbers = [](const abut_velocity& velocity) {
    const auto& [linear, angular] = velocity;
    return std::array{linear.x, linear.y, linear.z, angular.x, angular.y, angular.z};
  };
  return numbers(a) == numbers(b);
}

abut_status set_one_sample(abut_universe* universe, abut_geometry_id id, std::size_t kind) {
  constexpr std::array<double, 9> numbers{0.5, 0.25, 0.125, 1};
  constexpr std::array<std::uint32_t, 3> triangle{0, 1, 2};
  switch (kind) {
    case 0: return abut_geometry_set_heights(universe, id, 0, 0, 1, 1, numbers.data());
    case 1: return abut_geometry_set_particles(universe, id, 0, numbers.data(), nullptr, 1);
    case 2: return abut_geometry_set_vertices(universe, id, 0, numbers.data(), 1);
    case 3: return abut_geometry_set_vertices_at(universe, id, triangle.data(), numbers.data(), 1);
    case 4: return abut_geometry_remove_triangles(universe, id, triangle.data(), 1);
    default: return abut_geometry_set_mesh(universe, id, numbers.data(), 3, triangle.data(), 1);
  }
}

}  // namespace

// Boxes get other half extents; all other shapes of sequences keep theirs.
void Play::set_parameters(const Call& call) {
  for (const std::size_t place : picked(world_.living_geometries(), call, 1)) {
    Geometry& geometry = world_.geometries[place];
    if (!geometry.shape.is_box) {
      continue;
    }
    const Triple half{call.number(2, 1, 3), call.number(3, 1, 3), call.number(4, 1, 3)};
    const std::array<double, 3> parameters{static_cast<double>(half[0]), static_cast<double>(half[1]),
                                           static_cast<double>(half[2])};
    on_each("abut_geometry_set_parameters", [&](std::size_t u, abut_universe* its) {
      return call.has(5, 0)
                 ? abut_geometry_set_parameters(its, geometry.ids.at(u), parameters.data(), parameters.size())
                 : abut_geometries_set_parameters(its, &geometry.ids.at(u), parameters.data(), parameters.size(), 1);
    });
    geometry.shape.half = half;
    geometry.is_moved = geometry.is_resized = true;
    compare_geometry(place);
  }
}

// No shape of a sequence has heights, particles or triangles.
void Play::set_samples(const Call& call) {
  for (const std::size_t place : picked(world_.living_geometries(), call, 1)) {
    const GeometryIds& ids = world_.geometries[place].ids;
    for (std::size_t u = 0; u < universe_count; ++u) {
      const abut_status status = set_one_sample(universes_.at(u), ids.at(u), call.pick(2, 6));
      require(status == ABUT_UNSUPPORTED, std::string("samples of another shape: ") + abut_status_name(status));
    }
    compare_geometry(place);
  }
}

void Play::set_velocity(const Call& call) {
  const std::vector<std::size_t> parts = picked(world_.living_parts(), call, 1 + call.pick(2, 3));
  const abut_velocity velocity{{0.25 * call.number(4, -8, 8), 0.5 * call.number(5, -8, 8), 0},
                               {0, 0, 0.125 * call.number(6, -8, 8)}};
  const std::vector<abut_velocity> velocities(parts.size(), velocity);
  const std::size_t kind = call.pick(3, 4);
  on_each("abut_parts_set_velocities or abut_parts_measure_velocities", [&](std::size_t u, abut_universe* its) {
    std::vector<abut_part_id> ids;
    for (const std::size_t part : parts) {
      ids.push_back(world_.parts[part].ids.at(u));
    }
    if (kind == 0) {
      return abut_parts_measure_velocities(its, ids.data(), ids.size());
    }
    return abut_parts_set_velocities(its, ids.data(), kind == 1 ? nullptr : velocities.data(), ids.size());
  });
  for (const std::size_t part : parts) {
    world_.parts[part].velocity = kind > 1 ? std::optional(velocity) : std::nullopt;
  }
  compare_velocities();
}

// Those that were given stay, whatever else happens.
void Play::compare_velocities() const {
  for (const std::size_t place : world_.living_parts()) {
    const Part& part = world_.parts[place];
    for (std::size_t u = 0; part.velocity && u < universe_count; ++u) {
      abut_velocity found{};
      abut_velocity_source source = ABUT_VELOCITY_NONE;
      require(abut_part_velocity(universes_.at(u), part.ids.at(u), &found, &source) == ABUT_OK,
              "the velocity of a part that lives cannot be read");
      require(source == ABUT_VELOCITY_GIVEN && is_same(found, *part.velocity), "a part has another velocity");
    }
  }
}

void Play::follow_islands(const Call& call) {
  const std::uint32_t are_followed = call.has(2, 0) || call.has(2, 1) ? 1 : 0;
  on_each("abut_universe_follow_islands",
          [&](std::size_t, abut_universe* its) { return abut_universe_follow_islands(its, are_followed); });
  world_.are_islands_followed = are_followed != 0;
}

// Islands have their parts one after the other, and each part is in one of them at most.
void Play::judge_islands() const {
  for (std::size_t u = 0; u < universe_count; ++u) {
    const abut_island* islands = nullptr;
    const abut_part_id* parts = nullptr;
    std::size_t count = 0, part_count = 0;
    const abut_status status = abut_universe_islands(universes_.at(u), &islands, &count);
    if (!world_.are_islands_followed) {
      require(status == ABUT_UNSUPPORTED, "islands are told that nobody follows");
      continue;
    }
    require(status == ABUT_OK && abut_universe_island_parts(universes_.at(u), &parts, &part_count) == ABUT_OK,
            "islands that are followed cannot be read");
    std::vector<abut_part_id> all;
    std::copy_n(parts, part_count, std::back_inserter(all));
    std::set<std::uint32_t> slots;
    for (const abut_part_id& part : all) {
      require(slots.insert(part.slot).second, "a part is in two islands");
    }
  }
}

}  // namespace universe_calls
