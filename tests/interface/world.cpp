// SPDX-License-Identifier: Apache-2.0
#include "world.hpp"

#include <bit>
#include <numeric>

namespace abut_test::table {
namespace {

// Two tetrahedra, one of which the other calls of an edit leave alone.
constexpr std::array<double, 24> corners{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 3, 0, 0, 4, 0, 0, 3, 1, 0, 3, 0, 1};
constexpr std::array<std::uint32_t, 24> faces{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3, 4, 6, 5, 4, 5, 7, 4, 7, 6, 5, 6, 7};

template <class Create>
Shape made(Create create) {
  abut_shape* shape = nullptr;
  require(create(&shape));
  return Shape(shape);
}

Shape make_field() {
  abut_distance_field_desc desc = filled_by(abut_distance_field_desc_init);
  std::vector<double> values(27, 1.0);
  values[13] = -1.0;
  desc.columns = desc.rows = desc.layers = 3;
  desc.values = values.data();
  return made([&](abut_shape** out) { return abut_distance_field_create(&desc, out); });
}

std::vector<Shape> make_shapes() {
  std::vector<Shape> shapes;
  shapes.push_back(make_sphere(1.0));
  shapes.push_back(make_box(1.0, 1.0, 1.0));
  shapes.push_back(made([](abut_shape** out) { return abut_hull_create(corners.data(), 4, out); }));
  shapes.push_back(
      made([](abut_shape** out) { return abut_mesh_create(corners.data(), 8, faces.data(), 8, nullptr, out); }));
  shapes.push_back(make_terrain(3, 1.0));
  shapes.push_back(make_field());
  shapes.push_back(made([](abut_shape** out) { return abut_particles_create(corners.data(), 8, 0.1, out); }));
  const std::vector<double> radii(8, 0.1);
  shapes.push_back(
      made([&](abut_shape** out) { return abut_particles_create_with_radii(corners.data(), radii.data(), 8, out); }));
  shapes.push_back(make_composite({shapes[0], shapes[1]}, {identity, at(3, 0, 0)}));
  return shapes;
}

const abut_universe_options& options() {
  static const abut_universe_options options = [] {
    abut_universe_options with_points = default_universe_options();
    with_points.flags = ABUT_UNIVERSE_LOCAL_POINTS;
    return with_points;
  }();
  return options;
}

template <class Object>
std::vector<unsigned char> saved_as(const Object* object,
                                    abut_status (*save)(const Object*, void*, std::size_t, std::size_t*)) {
  std::size_t size = 0;
  require(save(object, nullptr, 0, &size));
  std::vector<unsigned char> bytes(size);
  require(save(object, bytes.data(), size, &size));
  return bytes;
}

template <class Id>
void append_stale(std::vector<std::uint64_t>& stale, Id doomed, Id foreign, Id good) {
  const auto far = ~std::uint32_t{0};
  for (const Id id : {Id{0, 0}, doomed, foreign, Id{good.slot, good.generation + 1}, Id{0, good.generation},
                      Id{1000, good.generation}, Id{far, far}}) {
    stale.push_back(std::bit_cast<std::uint64_t>(id));
  }
}

}  // namespace

std::size_t World::kinds() { return 9; }

World::World() : universe_(&options()), shapes_(make_shapes()) {
  EXPECT_EQ(shapes_.size(), kinds());
  for (std::size_t kind = 0; kind < kinds(); ++kind) {
    for (std::size_t index = 0; index < of_a_kind; ++index) {
      // The first kind touches its neighbours.
      const double apart = kind == 0 ? 1.5 : 10.0;
      const abut_pose pose = at(apart * static_cast<double>(index), 20.0 * static_cast<double>(kind), 0);
      parts_.push_back(universe_.add_part(pose));
      geometries_.push_back(universe_.add_geometry(parts_.back(), shape(kind)));
    }
  }
  for (std::size_t index = 0; index < of_a_kind; ++index) {
    double* xyz = nullptr;
    std::size_t numbers = 0;
    require(abut_geometry_next_vertices(universe_, geometry(3, index), &xyz, &numbers));
  }
  const abut_part_id doomed = universe_.add_part(at(9, -20, 0));
  const abut_geometry_id doomed_geometry = universe_.add_geometry(doomed, shape(0));
  require(abut_part_destroy(universe_, doomed));
  for (std::size_t i = 0; i < parts_.size(); ++i) other_.add(shape(0), at(5.0 * static_cast<double>(i), 0, 0));
  std::size_t count = 0;
  std::vector<abut_part_id> foreign_parts(parts_.size());
  std::vector<abut_geometry_id> foreign_geometries(parts_.size());
  require(abut_universe_parts(other_, foreign_parts.data(), foreign_parts.size(), &count));
  require(abut_universe_geometries(other_, foreign_geometries.data(), foreign_geometries.size(), &count));
  append_stale(stale_parts_, doomed, foreign_parts[0], parts_[0]);
  append_stale(stale_geometries_, doomed_geometry, foreign_geometries[0], geometries_[0]);
  require(abut_universe_attach(universe_, "table"));
  require(abut_universe_follow_islands(universe_, 1));
  EXPECT_FALSE(universe_.step().empty()) << "there must be contacts";
  add_extensions();
  before_ = state();
}

void World::add_extensions() {
  saved_.push_back(saved_as<abut_universe>(universe_, abut_universe_save));
  // As many vertices as arrays have at first.
  const Shape mesh =
      made([](abut_shape** out) { return abut_mesh_create(corners.data(), 4, faces.data(), 4, nullptr, out); });
  static_cast<void>(abut_elements_create(mesh, &elements_));
#ifdef ABUT_TABLE_HAS_PICKING
  require(abut_picker_create(universe_, &picker_));
#endif
#ifdef ABUT_TABLE_HAS_RESPONSE
  require(abut_response_create(universe_, nullptr, &response_));
  require(abut_response_add_bodies(response_, parts_.data(), of_a_kind, nullptr));
  const std::vector<double> masses(8, 1.0);
  require(abut_response_add_particles(response_, geometry(6, 0), masses.data(), corners.data(), nullptr, 8));
  // A mesh whose vertices are bodies, so that another one may follow them.
  std::vector<double> places(corners.begin(), corners.end());
  for (std::size_t i = 0; i < places.size(); i += 3) {
    places[i] += 10;
    places[i + 1] += 60;
  }
  require(abut_response_add_particles(response_, geometry(3, 1), masses.data(), places.data(), nullptr, 8));
  abut_link_options link = filled_by(abut_link_options_init);
  link.b = parts_[0];
  std::uint64_t number = 0;
  require(abut_response_add_link(response_, &link, &number));
  std::uint32_t rule = 0;
  require(abut_response_add_rule(response_, nullptr, nullptr, "friction", nullptr, &rule));
  saved_.push_back(saved_as<abut_response>(response_, abut_response_save));
#endif
}

World::~World() {
#ifdef ABUT_TABLE_HAS_RESPONSE
  abut_response_destroy(response_);
#endif
#ifdef ABUT_TABLE_HAS_PICKING
  abut_picker_destroy(picker_);
#endif
  abut_elements_destroy(elements_);
}

std::vector<unsigned char> World::state() const {
  std::vector<unsigned char> bytes = snapshot(universe_);
  const auto append = [&](const std::vector<unsigned char>& more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
  };
  append(saved_as<abut_universe>(universe_, abut_universe_save));
#ifdef ABUT_TABLE_HAS_RESPONSE
  append(saved_as<abut_response>(response_, abut_response_save));
#endif
  return bytes;
}

const void* World::object(std::string_view type, std::size_t kind) const {
  if (type == "abut_shape") return shape(kind);
  if (type == "abut_elements") return elements_;
#ifdef ABUT_TABLE_HAS_PICKING
  if (type == "abut_picker") return picker_;
#endif
#ifdef ABUT_TABLE_HAS_RESPONSE
  if (type == "abut_response") return response_;
#endif
  EXPECT_EQ(type, "abut_universe") << "the table has handles of a new type";
  return universe_;
}

void release(std::string_view type, void* object) {
  if (type == "abut_shape") abut_shape_release(static_cast<abut_shape*>(object));
  if (type == "abut_universe") abut_universe_destroy(static_cast<abut_universe*>(object));
  if (type == "abut_elements") abut_elements_destroy(static_cast<abut_elements*>(object));
#ifdef ABUT_TABLE_HAS_PICKING
  if (type == "abut_picker") abut_picker_destroy(static_cast<abut_picker*>(object));
#endif
#ifdef ABUT_TABLE_HAS_RESPONSE
  if (type == "abut_response") abut_response_destroy(static_cast<abut_response*>(object));
#endif
}

}  // namespace abut_test::table
