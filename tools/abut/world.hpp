// SPDX-License-Identifier: Apache-2.0
// A universe built from a scene, its motion, and the names of what is in it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/owners.hpp"
#include "dynamics.hpp"
#include "scene.hpp"

namespace cli {

class World {
 public:
  /// Builds the universe. Throws BadInput when the library refuses something of the scene.
  explicit World(Scene scene);

  /// Places the parts as they are at step `number`, from 1, which is at the time (number - 1) * dt, and detects. Where
  /// the scene has a response, bodies then move by dt.
  void step(std::uint64_t number);

  [[nodiscard]] const abut_universe* universe() const { return universe_.get(); }
  [[nodiscard]] abut_universe* universe() { return universe_.get(); }
  [[nodiscard]] const Scene& scene() const { return scene_; }

  /// In the world, of the geometry of that number in the scene.
  [[nodiscard]] abut_pose pose_of(std::size_t geometry) const;
  /// The shape of the geometry of that number at the last step. It stays until the next one.
  [[nodiscard]] const abut_shape* shape_of(std::size_t geometry) const;
  /// The tag of the geometry of that number, which a focus may have switched.
  [[nodiscard]] std::uint32_t tag_of(std::size_t geometry) const;
  /// The geometry of that number, and whatever a rule of the scene names, in the universe.
  [[nodiscard]] abut_geometry_id id_of(std::size_t geometry) const { return geometries_.at(geometry); }
  [[nodiscard]] abut_collidable collidable(const Collidable& what) const;
  /// Why the last step did not examine two geometries, by their numbers; 0 where it did.
  [[nodiscard]] abut_apart_reasons why_apart(std::size_t a, std::size_t b) const;
  /// The number in the scene of a geometry of the universe.
  [[nodiscard]] std::size_t number_of(abut_geometry_id id) const { return geometry_of_slot_[id.slot]; }
  /// Element contacts of the last step. None, and nothing is asked, where no policy has the detail of elements: builds
  /// without the feature deforming refuse such policies, and the question.
  [[nodiscard]] std::vector<abut_element_contact> element_contacts() const;
  [[nodiscard]] const std::string& part_name(abut_geometry_id id) const;
  /// Of scenes with a response, else null.
  [[nodiscard]] const Dynamics* dynamics() const { return dynamics_ ? &*dynamics_ : nullptr; }
  /// Of the part of that number.
  [[nodiscard]] abut_part_id part_id(std::size_t part) const { return parts_.at(part); }
  [[nodiscard]] const std::string& geometry_name(abut_geometry_id id) const;

 private:
  void create_parts();
  void create_geometries();
  void set_rules();
  void set_policies();
  void set_focus();
  void set_materials();
  void make_bodies();

  Scene scene_;
  UniverseOwner universe_;
  std::optional<Dynamics> dynamics_;  // ends before the universe does
  std::vector<abut_part_id> parts_;
  std::vector<abut_geometry_id> geometries_;
  std::vector<std::size_t> geometry_of_slot_;
  std::vector<std::size_t> scripted_;   // indices of parts
  std::vector<std::size_t> deforming_;  // indices of geometries
  // Present shapes of those that deform, as far as they were asked for. While they are held, an edit would copy them.
  mutable std::map<std::size_t, ShapeOwner> present_;
};

}  // namespace cli
