// SPDX-License-Identifier: Apache-2.0
// The universe of the demo: terrain and bodies, a bunny on which a cloth falls, and what belongs to what.
#pragma once

#include <filesystem>
#include <vector>

#include "bodies.hpp"
#include "cloth.hpp"
#include "motion.hpp"
#include "owned.hpp"
#include "terrain.hpp"

namespace demo {

/// Which body a geometry is a piece of.
struct Owner {
  Kind kind = Kind::terrain;
  std::uint32_t body = 0;   // 0 is the terrain, bodies count from one
  std::uint32_t piece = 0;  // within the body
};

class Scene {
 public:
  Scene(const std::filesystem::path& data, std::size_t bodies, std::uint64_t seed, std::uint32_t threads);

  /// Digs, moves every body by one step of the prescribed motion and places it.
  void move();

  /// Simulates the cloth for one step.
  void move_cloth();

  /// Detects the contacts of the present poses.
  void detect();

  [[nodiscard]] Owner owner(abut_geometry_id geometry) const { return owners_.at(geometry.slot); }
  [[nodiscard]] abut_universe* universe() const { return universe_.get(); }
  [[nodiscard]] const Terrain& terrain() const { return terrain_; }
  [[nodiscard]] const Cloth& cloth() const { return cloth_; }
  [[nodiscard]] std::size_t body_count() const { return parts_.size(); }
  /// Pieces of bodies.
  [[nodiscard]] std::size_t geometry_count() const { return geometry_count_; }
  [[nodiscard]] std::size_t shape_count() const { return catalogue_.shape_count() + 3; }

 private:
  Scene(const std::filesystem::path& data, const Triangles& bunny, std::size_t bodies, std::uint64_t seed,
        std::uint32_t threads);
  void add_terrain();
  abut_geometry_id add_still(const Triangles& triangles, Kind kind);
  void excavate();
  void add_body(const Slider& slider);
  abut_geometry_id add_geometry(abut_part_id part, const abut_shape* shape, const abut_pose& pose, const Owner& owner);

  Terrain terrain_;
  Catalogue catalogue_;
  Triangles statue_;
  Cloth cloth_;
  UniverseOwner universe_;
  std::vector<Slider> sliders_;
  std::vector<abut_part_id> parts_;
  std::vector<abut_pose> poses_;
  std::vector<Owner> owners_;  // by slot of the geometry
  std::size_t geometry_count_ = 0;
  abut_geometry_id ground_{};
  abut_geometry_id sheet_{};
  std::uint32_t steps_ = 0;  // that were moved
};

}  // namespace demo
