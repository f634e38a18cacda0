// SPDX-License-Identifier: Apache-2.0
#include "writers.hpp"

#include <array>

namespace cli {
namespace {

constexpr std::array<Column, 20> contact_columns{
    {{"step"},     {"part_a"},    {"geometry_a"},      {"part_b"},        {"geometry_b"},
     {"id"},       {"feature_a"}, {"feature_index_a"}, {"feature_b"},     {"feature_index_b"},
     {"child_a"},  {"child_b"},   {"point_a", true},   {"point_b", true}, {"normal", true},
     {"distance"}, {"age"},       {"sensor"},          {"material_a"},    {"material_b"}}};

constexpr std::array<Column, 23> element_columns{
    {{"step"},         {"part_a"},    {"geometry_a"}, {"part_b"},   {"geometry_b"}, {"id"},
     {"kind"},         {"element_a"}, {"element_b"},  {"of_a"},     {"vertex_0"},   {"vertex_1"},
     {"vertex_2"},     {"vertex_3"},  {"weight_0"},   {"weight_1"}, {"weight_2"},   {"weight_3"},
     {"normal", true}, {"distance"},  {"gap"},        {"toi"},      {"age"}}};

constexpr std::array<Column, 11> event_columns{{{"step"},
                                                {"event"},
                                                {"of"},
                                                {"part_a"},
                                                {"geometry_a"},
                                                {"part_b"},
                                                {"geometry_b"},
                                                {"contact_id"},
                                                {"contacts"},
                                                {"sensor"},
                                                {"asleep"}}};

constexpr std::array<Column, 10> state_columns{{{"step"},
                                                {"time"},
                                                {"part"},
                                                {"position", true},
                                                {"orientation_w"},
                                                {"orientation_x"},
                                                {"orientation_y"},
                                                {"orientation_z"},
                                                {"velocity", true},
                                                {"angular_velocity", true}}};

constexpr std::array<Column, 9> motion_columns{{{"step"},
                                                {"time"},
                                                {"kinetic"},
                                                {"potential"},
                                                {"momentum", true},
                                                {"angular_momentum", true},
                                                {"contacts"},
                                                {"deepest"},
                                                {"residual"}}};

double time_after(const World& world, std::uint64_t step) { return static_cast<double>(step) * world.scene().dt; }

template <std::size_t count>
std::string_view name_at(const std::array<std::string_view, count>& names, std::uint32_t index) {
  return index < count ? names[index] : "unknown";
}

constexpr std::array<std::string_view, 4> features{"whole", "vertex", "edge", "face"};
constexpr std::array<std::string_view, 4> stencils{"vertex_face", "edge_edge", "vertex_edge", "vertex_vertex"};
constexpr std::array<std::string_view, 3> events{"begin", "persist", "end"};

}  // namespace

ContactWriter::ContactWriter(const std::string& path, Format format) : table_(path, format, contact_columns) {}

void ContactWriter::add(const World& world, std::uint64_t step) {
  const Names& materials = world.scene().materials;
  for (const abut_contact& contact : contacts_of(world.universe())) {
    table_.whole(step);
    table_.text(world.part_name(contact.geometry_a)).text(world.geometry_name(contact.geometry_a));
    table_.text(world.part_name(contact.geometry_b)).text(world.geometry_name(contact.geometry_b));
    table_.whole(contact.id);
    table_.text(name_at(features, contact.feature_a.kind)).whole(contact.feature_a.index);
    table_.text(name_at(features, contact.feature_b.kind)).whole(contact.feature_b.index);
    table_.whole(contact.child_a).whole(contact.child_b);
    table_.vector(contact.point_a).vector(contact.point_b).vector(contact.normal).real(contact.distance);
    table_.whole(contact.age).flag((contact.flags & ABUT_CONTACT_SENSOR) != 0);
    table_.text(materials.name_of(contact.material_a)).text(materials.name_of(contact.material_b));
    table_.end_row();
  }
}

ElementWriter::ElementWriter(const std::string& path, Format format) : table_(path, format, element_columns) {}

void ElementWriter::add(const World& world, std::uint64_t step) {
  for (const abut_element_contact& contact : world.element_contacts()) {
    const abut_stencil& its = contact.stencil;
    table_.whole(step);
    table_.text(world.part_name(contact.geometry_a)).text(world.geometry_name(contact.geometry_a));
    table_.text(world.part_name(contact.geometry_b)).text(world.geometry_name(contact.geometry_b));
    table_.whole(contact.id).text(name_at(stencils, its.kind));
    table_.whole(its.element_a).whole(its.element_b).whole(its.of_a);
    for (const std::uint32_t vertex : its.vertices) {
      table_.whole(vertex);
    }
    for (const double weight : its.weights) {
      table_.real(weight);
    }
    table_.vector(its.normal).real(its.distance).real(contact.gap).real(its.toi).whole(contact.age);
    table_.end_row();
  }
}

StateWriter::StateWriter(const std::string& path, Format format) : table_(path, format, state_columns) {}

void StateWriter::add(const World& world, std::uint64_t step) {
  for (const std::size_t i : world.dynamics()->bodies()) {
    abut_pose pose{};
    abut_velocity velocity{};
    abut_velocity_source source{};
    check(abut_part_pose(world.universe(), world.part_id(i), &pose), "pose of a body");
    check(abut_part_velocity(world.universe(), world.part_id(i), &velocity, &source), "velocity of a body");
    const abut_quat& turn = pose.orientation;
    table_.whole(step).real(time_after(world, step)).text(world.scene().parts[i].name).vector(pose.position);
    table_.real(turn.w).real(turn.x).real(turn.y).real(turn.z);
    table_.vector(velocity.linear).vector(velocity.angular);
    table_.end_row();
  }
}

MotionWriter::MotionWriter(const std::string& path, Format format) : table_(path, format, motion_columns) {}

void MotionWriter::add(const World& world, std::uint64_t step) {
  const Dynamics& bodies = *world.dynamics();
  const abut_energy energy = bodies.energy();
  table_.whole(step).real(time_after(world, step)).real(energy.kinetic).real(energy.potential);
  table_.vector(energy.linear_momentum).vector(energy.angular_momentum);
  table_.whole(bodies.contact_count()).real(bodies.deepest()).real(bodies.residual());
  table_.end_row();
}

EventWriter::EventWriter(const std::string& path, Format format) : table_(path, format, event_columns) {}

void EventWriter::add(const World& world, std::uint64_t step) {
  for (const abut_event& event : events_of(world.universe())) {
    table_.whole(step).text(name_at(events, event.kind));
    table_.text((event.flags & ABUT_EVENT_ELEMENTS) != 0  ? "element"
                : (event.flags & ABUT_EVENT_CONTACT) != 0 ? "contact"
                                                          : "pair");
    table_.text(world.part_name(event.geometry_a)).text(world.geometry_name(event.geometry_a));
    table_.text(world.part_name(event.geometry_b)).text(world.geometry_name(event.geometry_b));
    table_.whole(event.contact_id).whole(event.contact_count).flag((event.flags & ABUT_EVENT_SENSOR) != 0);
    table_.flag((event.flags & ABUT_EVENT_ASLEEP) != 0);
    table_.end_row();
  }
}

}  // namespace cli
