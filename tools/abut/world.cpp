// SPDX-License-Identifier: Apache-2.0
#include "world.hpp"

#include <algorithm>

namespace cli {
World::World(Scene scene) : scene_(std::move(scene)) {
  abut_universe* universe = nullptr;
  check_scene(abut_universe_create(&scene_.universe, &universe), "universe");
  universe_.reset(universe);
  if (scene_.follows_islands) {
    check_scene(abut_universe_follow_islands(universe, 1), "universe.islands");
  }
  create_parts();
  create_geometries();
  set_rules();
  set_policies();
  set_focus();
  set_materials();
  if (scene_.response) {
    make_bodies();
  }
}

void World::create_parts() {
  std::vector<abut_part_options> options(scene_.parts.size());
  for (std::size_t i = 0; i < options.size(); ++i) {
    abut_part_options_init(&options[i], sizeof options[i]);
    options[i].motion = scene_.parts[i].motion;
    options[i].pose = scene_.parts[i].pose;
    options[i].user_data = i;
    if (scene_.parts[i].script != Part::no_script) {
      scripted_.push_back(i);
    }
  }
  parts_.resize(options.size());
  check_scene(abut_parts_create(universe_.get(), options.data(), options.size(), parts_.data()), "parts");
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (scene_.parts[i].sleep) {
      check_scene(abut_part_set_sleep(universe_.get(), parts_[i], &*scene_.parts[i].sleep),
                  "sleep of " + scene_.parts[i].name);
    }
    if (scene_.parts[i].velocity) {
      check_scene(abut_part_set_velocity(universe_.get(), parts_[i], &*scene_.parts[i].velocity),
                  "velocity of " + scene_.parts[i].name);
    }
    if (scene_.parts[i].is_measured) {
      check_scene(abut_part_measure_velocity(universe_.get(), parts_[i]), "velocity of " + scene_.parts[i].name);
    }
  }
}

void World::create_geometries() {
  const std::size_t count = scene_.geometries.size();
  std::vector<abut_part_id> parts;
  std::vector<const abut_shape*> shapes;
  std::vector<abut_geometry_options> options;
  for (std::size_t i = 0; i < count; ++i) {
    const Geometry& geometry = scene_.geometries[i];
    parts.push_back(parts_[geometry.part]);
    shapes.push_back(geometry.shape);
    options.push_back(geometry.options);
    options.back().user_data = i;
  }
  geometries_.resize(count);
  check_scene(
      abut_geometries_create(universe_.get(), parts.data(), shapes.data(), options.data(), count, geometries_.data()),
      "geometries");
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t slot = geometries_[i].slot;
    geometry_of_slot_.resize(std::max(geometry_of_slot_.size(), slot + 1));
    geometry_of_slot_[slot] = i;
    if (scene_.geometries[i].sequence != Part::no_script) {
      deforming_.push_back(i);
    }
  }
}

abut_collidable World::collidable(const Collidable& what) const {
  switch (what.kind) {
    case ABUT_COLLIDABLE_GEOMETRY: return {what.kind, geometries_[what.index].slot, geometries_[what.index].generation};
    case ABUT_COLLIDABLE_PART: return {what.kind, parts_[what.index].slot, parts_[what.index].generation};
    default: return {what.kind, static_cast<std::uint32_t>(what.index), 0};
  }
}

void World::set_rules() {
  for (const Rule& rule : scene_.rules) {
    const abut_collidable a = collidable(rule.a);
    const abut_collidable b = collidable(rule.b);
    check_scene(abut_rule_set(universe_.get(), &a, &b, rule.rule), rule.path);
  }
}

void World::set_policies() {
  for (const Policy& policy : scene_.policies) {
    check_scene(abut_policy_set(universe_.get(), policy.tag_a, policy.tag_b, &policy.policy), policy.path);
  }
}

void World::set_focus() {
  if (scene_.focus) {
    const Focus& its = *scene_.focus;
    check_scene(abut_universe_set_focus(universe_.get(), &its.focus, its.centres.data(), its.centres.size()), "focus");
  }
}

void World::set_materials() {
  for (const MaterialPair& pair : scene_.material_pairs) {
    check_scene(abut_material_pair_set(universe_.get(), pair.a, pair.b, &pair.material), pair.path);
  }
}

// Dynamic parts that nothing else moves.
void World::make_bodies() {
  std::vector<std::size_t> bodies;
  for (std::size_t i = 0; i < scene_.parts.size(); ++i) {
    const Part& part = scene_.parts[i];
    if (part.motion == ABUT_MOTION_DYNAMIC && part.script == Part::no_script && !part.is_measured) {
      bodies.push_back(i);
    }
  }
  dynamics_.emplace(universe_.get(), scene_, parts_, std::move(bodies));
}

void World::step(std::uint64_t number) {
  const double time = static_cast<double>(number - 1) * scene_.dt;
  std::vector<abut_part_id> moved;
  std::vector<abut_pose> poses;
  for (const std::size_t i : scripted_) {
    const Part& part = scene_.parts[i];
    moved.push_back(parts_[i]);
    poses.push_back(pose_at(scene_.scripts[part.script], part.pose, time));
  }
  const std::string when = "step " + std::to_string(number);
  check_scene(abut_parts_set_poses(universe_.get(), moved.data(), poses.data(), moved.size()),
              "the scripts at " + when);
  present_.clear();
  for (const std::size_t i : deforming_) {
    const Sequence& sequence = scene_.sequences[scene_.geometries[i].sequence];
    const std::vector<double>& vertices = sequence.at(number);
    check_scene(abut_geometry_set_vertices(universe_.get(), geometries_[i], 0, vertices.data(), vertices.size() / 3),
                sequence.path + " at " + when);
  }
  check_scene(dynamics_ ? dynamics_->step(scene_.dt) : abut_universe_step(universe_.get(), scene_.dt), when);
}

std::vector<abut_element_contact> World::element_contacts() const {
  const auto asks = [](const Policy& its) { return its.policy.detail == ABUT_DETAIL_ELEMENTS; };
  return std::ranges::any_of(scene_.policies, asks) ? element_contacts_of(universe())
                                                    : std::vector<abut_element_contact>{};
}

const std::string& World::geometry_name(abut_geometry_id id) const { return scene_.geometries[number_of(id)].name; }

const abut_shape* World::shape_of(std::size_t geometry) const {
  if (scene_.geometries[geometry].sequence == Part::no_script) {
    return scene_.geometries[geometry].shape;
  }
  const auto [place, is_new] = present_.try_emplace(geometry);
  if (is_new) {
    abut_shape* shape = nullptr;
    check(abut_geometry_shape(universe_.get(), geometries_.at(geometry), &shape), "shape of a geometry");
    place->second.reset(shape);
  }
  return place->second.get();
}

abut_pose World::pose_of(std::size_t geometry) const {
  abut_pose pose{};
  check(abut_geometries_poses(universe_.get(), &geometries_.at(geometry), 1, &pose), "pose of a geometry");
  return pose;
}

abut_apart_reasons World::why_apart(std::size_t a, std::size_t b) const {
  abut_apart_reasons reasons = 0;
  check(abut_universe_why_apart(universe_.get(), id_of(a), id_of(b), &reasons),
        "cannot ask why two geometries do not meet");
  return reasons;
}

std::uint32_t World::tag_of(std::size_t geometry) const {
  abut_geometry_info info;
  abut_geometry_info_init(&info, sizeof info);
  check(abut_geometry_describe(universe_.get(), geometries_.at(geometry), &info), "description of a geometry");
  return info.tag;
}

const std::string& World::part_name(abut_geometry_id id) const {
  return scene_.parts[scene_.geometries[number_of(id)].part].name;
}

}  // namespace cli
