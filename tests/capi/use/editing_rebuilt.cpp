// SPDX-License-Identifier: Apache-2.0
// A universe whose shapes are edited against one that is made anew with the shapes that come of it: the answers are the
// same bits.
#include <cstring>
#include <random>

#include "support.hpp"

namespace {

using namespace abut_test;

constexpr std::uint32_t columns = 12, rows = 9, layers = 7;
constexpr std::size_t particle_count = 40;

// A geometry as the test knows it, without asking the library.
struct Model {
  std::string kind;
  std::vector<double> parameters, reals;
  abut_pose pose{};
  abut_motion motion{};
  abut_parking parking = ABUT_PARKING_NONE;

  Shape make() const { return make_of_kind(kind.c_str(), parameters, reals); }
};

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : random_(seed) {}
  std::uint32_t below(std::size_t count) { return static_cast<std::uint32_t>(random_() % count); }
  double between(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }
  abut_vec3 point(double from, double to) { return {between(from, to), between(from, to), between(from, to)}; }
  abut_quat turn() {
    const double x = between(-1, 1), y = between(-1, 1), z = between(-1, 1), w = between(0.1, 1);
    const double length = std::sqrt(w * w + x * x + y * y + z * z);
    return {w / length, x / length, y / length, z / length};
  }

 private:
  std::mt19937_64 random_;
};

std::vector<Model> make_models(Numbers& random) {
  std::vector<Model> models;
  std::vector<double> heights;
  for (std::uint32_t i = 0; i < columns * rows; ++i) heights.push_back(random.between(-0.2, 0.2));
  const abut_pose tilted{{-3, -2, 0}, random.turn()};
  models.push_back({"height_field", {columns, rows, 0.5, 0.5}, heights, at(-3, -2, 0), ABUT_MOTION_STATIC});
  models.push_back({"height_field", {columns, rows, 0.7, 0.3}, heights, tilted, ABUT_MOTION_STATIC});
  // A wavy slab, and one that is a container from below and smooth.
  for (const double is_inside_out : {0.0, 1.0}) {
    std::vector<double> values;
    for (std::uint32_t k = 0; k < layers; ++k) {
      for (std::uint32_t i = 0; i < columns * rows; ++i) values.push_back(0.4 * (k - 3.0) + random.between(-0.2, 0.2));
    }
    const std::vector<double> parameters{
        columns, rows, layers, 0.5, 0.5, 0.4, -3, -2, is_inside_out > 0 ? -0.6 : -1.4, is_inside_out, is_inside_out};
    models.push_back({"distance_field", parameters, values, at(0, 0, 0), ABUT_MOTION_STATIC});
  }
  const auto place = [&] {
    const abut_vec3 position = random.point(-2.5, 2.5);
    return abut_pose{{position.x, position.y, 0.2 * position.z}, random.turn()};
  };
  for (int set = 0; set < 2; ++set) {
    std::vector<double> balls;
    for (std::size_t i = 0; i < particle_count; ++i) {
      for (int axis = 0; axis < 3; ++axis) balls.push_back(random.between(-0.8, 0.8));
      if (set == 1) balls.push_back(random.between(0.02, 0.1));
    }
    models.push_back({"particles", {set == 0 ? 0.08 : 0.0}, balls, place(), ABUT_MOTION_DYNAMIC});
  }
  for (int i = 0; i < 8; ++i) {
    models.push_back({"box",
                      {random.between(0.1, 0.5), random.between(0.1, 0.5), random.between(0.1, 0.5)},
                      {},
                      place(),
                      ABUT_MOTION_DYNAMIC});
    models.push_back({"sphere", {random.between(0.1, 0.5)}, {}, place(), ABUT_MOTION_DYNAMIC});
    models.push_back(
        {"cylinder", {random.between(0.1, 0.5), random.between(0.1, 0.5)}, {}, place(), ABUT_MOTION_DYNAMIC});
  }
  return models;
}

abut_universe_options all_contacts(abut_broadphase broadphase, abut_tolerance_mode mode) {
  abut_universe_options options = default_universe_options();
  options.broadphase = broadphase;
  options.tolerance_mode = mode;
  options.max_contacts = 0;
  return options;
}

struct World {
  World(const abut_universe_options& options, const std::vector<Model>& models) : universe(&options) {
    for (const Model& model : models) {
      abut_geometry_options its = default_geometry_options();
      its.parking = model.parking;
      its.tolerance = options.tolerance_mode == ABUT_TOLERANCE_MARGIN ? 0.02 : 0;
      parts.push_back(universe.add_part(model.pose, model.motion));
      geometries.push_back(universe.add_geometry(parts.back(), model.make(), its));
    }
  }
  Universe universe;
  std::vector<abut_part_id> parts;
  std::vector<abut_geometry_id> geometries;
};

void resize(World& world, std::size_t at, Model& model, Numbers& random) {
  for (double& parameter : model.parameters) parameter = random.between(0.1, 0.6);
  require(abut_geometry_set_parameters(world.universe, world.geometries[at], model.parameters.data(),
                                       model.parameters.size()));
}

void change_heights(World& world, std::size_t at, Model& model, Numbers& random) {
  const std::uint32_t column = random.below(columns + 1), row = random.below(rows + 1);
  const std::uint32_t wide = random.below(std::min(columns - column, 3U) + 1),
                      high = random.below(std::min(rows - row, 3U) + 1);
  const double depth = random.below(8) == 0 ? 0.5 : 0.15;
  std::vector<double> heights;
  for (std::uint32_t j = row; j < row + high; ++j) {
    for (std::uint32_t i = column; i < column + wide; ++i) {
      heights.push_back(random.between(-depth, depth));
      model.reals.at(j * columns + i) = heights.back();
    }
  }
  require(abut_geometry_set_heights(world.universe, world.geometries[at], column, row, wide, high, heights.data()));
}

void change_values(World& world, std::size_t at, Model& model, Numbers& random) {
  const std::array<std::uint32_t, 3> all{columns, rows, layers};
  std::array<std::uint32_t, 3> first{}, count{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    first.at(axis) = random.below(all.at(axis) + 1);
    count.at(axis) = random.below(std::min(all.at(axis) - first.at(axis), 3U) + 1);
  }
  std::vector<double> values;
  for (std::uint32_t k = first[2]; k < first[2] + count[2]; ++k) {
    for (std::uint32_t j = first[1]; j < first[1] + count[1]; ++j) {
      for (std::uint32_t i = first[0]; i < first[0] + count[0]; ++i) {
        values.push_back(0.4 * (k - 3.0) + random.between(-0.15, 0.15));
        model.reals.at((k * rows + j) * columns + i) = values.back();
      }
    }
  }
  require(abut_geometry_set_field_values(world.universe, world.geometries[at], first[0], first[1], first[2], count[0],
                                         count[1], count[2], values.data()));
}

// Corners of the grid move a little, or the lattice is taken away.
void bend(World& world, std::size_t at, Model& model, Numbers& random) {
  const std::array<std::uint32_t, 3> all{columns, rows, layers};
  const std::uint32_t along = random.below(3) == 0 ? 0 : 2;
  std::vector<double> xyz;
  for (std::uint32_t corner = 0; corner < along * 4; ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double size = (corner >> axis & 1U) != 0 ? (all.at(axis) - 1) * model.parameters.at(3 + axis) : 0;
      xyz.push_back(model.parameters.at(6 + axis) + size + random.between(-0.1, 0.1));
    }
  }
  require(abut_geometry_set_field_lattice(world.universe, world.geometries[at], along, along, along, xyz.data()));
  model.parameters.resize(11);
  model.parameters.resize(14, along);
  model.reals.resize(std::size_t{columns} * rows * layers);
  model.reals.insert(model.reals.end(), xyz.begin(), xyz.end());
}

void move_particles(World& world, std::size_t at, Model& model, Numbers& random) {
  const bool has_radii = model.parameters[0] == 0;
  const bool changes_radii = has_radii && random.below(2) == 0;
  const std::size_t first = random.below(particle_count + 1),
                    count = random.below(std::min<std::size_t>(particle_count - first, 6) + 1);
  std::vector<double> xyz, radii;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t its = (has_radii ? 4 : 3) * (first + i);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      xyz.push_back(model.reals.at(its + axis) = random.between(-0.8, 0.8));
    }
    if (changes_radii) radii.push_back(model.reals.at(its + 3) = random.between(0.02, 0.12));
  }
  require(abut_geometry_set_particles(world.universe, world.geometries[at], first, xyz.data(),
                                      changes_radii ? radii.data() : nullptr, count));
}

void edit(World& world, std::vector<Model>& models, Numbers& random) {
  const std::size_t at = random.below(models.size());
  Model& model = models[at];
  const std::uint32_t choice = random.below(12);
  if (choice == 0) {
    model.parking = model.parking == ABUT_PARKING_NONE ? 1 + random.below(2) : 0;
    world.universe.park(world.geometries[at], model.parking);
  } else if (choice < 3) {
    model.pose.position.z += random.between(-0.05, 0.05);
    world.universe.move(world.parts[at], model.pose);
  } else if (model.kind == "height_field") {
    change_heights(world, at, model, random);
  } else if (model.kind == "distance_field" && random.below(4) == 0) {
    bend(world, at, model, random);
  } else if (model.kind == "distance_field") {
    change_values(world, at, model, random);
  } else if (model.kind == "particles") {
    move_particles(world, at, model, random);
  } else {
    resize(world, at, model, random);
  }
}

template <class Record>
bool same_bits(const Record& a, const Record& b) {
  return std::memcmp(&a, &b, sizeof(Record)) == 0;
}

// All of a contact but its history, and generations, which differ from universe to universe.
bool is_same_contact(abut_contact a, abut_contact b) {
  for (abut_contact* const its : {&a, &b}) {
    its->geometry_a.generation = its->geometry_b.generation = 0;
    its->age = 0;
    its->user_data = 0;
  }
  return same_bits(a, b);
}

void expect_same_contacts(const World& edited, const World& made) {
  const std::vector<abut_contact> one = edited.universe.contacts(), other = made.universe.contacts();
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_TRUE(is_same_contact(one[i], other[i]))
        << "contact " << i << " of " << one[i].geometry_a.slot << " and " << one[i].geometry_b.slot;
  }
}

void expect_same_answers(const World& edited, const World& made, Numbers& random) {
  const Shape probe = make_sphere(0.3);
  for (int i = 0; i < 6; ++i) {
    const abut_ray ray{random.point(-3, 3), random.point(-1, 1), 9};
    std::array<abut_query_hit, 2> hits{};
    std::array<std::size_t, 2> counts{};
    std::array<abut_closest, 2> near{};
    std::array<std::uint32_t, 2> found{};
    const abut_pose pose{random.point(-3, 3), no_rotation};
    for (std::size_t k = 0; k < 2; ++k) {
      const World& world = k == 0 ? edited : made;
      require(abut_universe_cast_ray(world.universe, &ray, nullptr, ABUT_HIT_NEAREST, &hits.at(k), 1, &counts.at(k)));
      require(abut_universe_closest(world.universe, probe, &pose, 2, nullptr, &near.at(k), &found.at(k)));
      hits.at(k).geometry.generation = near.at(k).geometry.generation = 0;
    }
    EXPECT_EQ(counts[0], counts[1]);
    EXPECT_EQ(found[0], found[1]);
    EXPECT_TRUE(same_bits(hits[0], hits[1]));
    EXPECT_TRUE(same_bits(near[0], near[1]));
  }
}

class Editing : public testing::TestWithParam<std::tuple<std::uint64_t, abut_broadphase, abut_tolerance_mode>> {};

TEST_P(Editing, AnswersAsAUniverseOfNewShapes) {
  const auto [seed, broadphase, mode] = GetParam();
  Numbers random(seed);
  std::vector<Model> models = make_models(random);
  const abut_universe_options options = all_contacts(broadphase, mode);
  World edited(options, models);
  std::vector<Shape> held;
  std::size_t contacts = 0;
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(round));
    for (std::uint32_t i = 0; i <= random.below(4); ++i) {
      edit(edited, models, random);
      if (random.below(4) == 0) require(abut_universe_refresh(edited.universe));
      if (random.below(4) == 0) {
        abut_shape* shape = nullptr;
        require(abut_geometry_shape(edited.universe, edited.geometries[random.below(models.size())], &shape));
        held.emplace_back(shape);
      }
      if (random.below(3) == 0) held.clear();
    }
    const abut_aabb part_of_it{{-1, -9, -9}, {9, 9, 9}};
    if (random.below(3) == 0) require(abut_universe_detect_region(edited.universe, &part_of_it));
    edited.universe.step();
    World made(options, models);
    made.universe.step();
    contacts += made.universe.contacts().size();
    expect_same_contacts(edited, made);
    expect_same_answers(edited, made, random);
    if (HasFailure()) return;
  }
  EXPECT_GT(contacts, 400U);
}

INSTANTIATE_TEST_SUITE_P(Random, Editing,
                         testing::Combine(testing::Range(std::uint64_t{1}, std::uint64_t{7}),
                                          testing::Values(ABUT_BROADPHASE_TREE, ABUT_BROADPHASE_SWEEP_AND_PRUNE),
                                          testing::Values(ABUT_TOLERANCE_DEAD_BAND, ABUT_TOLERANCE_MARGIN)));

}  // namespace
