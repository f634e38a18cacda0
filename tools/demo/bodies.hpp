// SPDX-License-Identifier: Apache-2.0
// The kinds of bodies and how each is made of shapes.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "bunny.hpp"
#include "common/random.hpp"
#include "owned.hpp"

namespace demo {

enum class Kind : std::uint8_t { terrain, sphere, box, capsule, hull, compound, bunny_mesh, bunny_hull, statue, cloth };

inline constexpr std::array<std::string_view, 10> kind_names{
    "terrain", "sphere", "box", "capsule", "hull", "compound", "bunny_mesh", "bunny_hull", "statue", "cloth"};

[[nodiscard]] constexpr std::string_view name_of(Kind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

/// One geometry of a body: a shape of the catalogue at a place in the frame of the body.
struct Piece {
  std::size_t shape;
  abut_pose pose;
};

/// A body as it can be laid out any number of times. It rests on the plane z = 0 of its own frame.
struct Design {
  Kind kind;
  std::vector<Piece> pieces;
  double radius;  // of the disc that it covers on the ground, metres
};

/// All shapes and designs. Bodies of one design share their shapes.
class Catalogue {
 public:
  Catalogue(const Triangles& bunny, Random random);

  /// Index of a design by chance: every kind with its own share.
  [[nodiscard]] std::size_t choose(Random& random) const;

  [[nodiscard]] const Design& design(std::size_t index) const { return designs_[index]; }
  [[nodiscard]] const abut_shape* shape(std::size_t index) const { return shapes_[index].get(); }
  [[nodiscard]] std::size_t shape_count() const { return shapes_.size(); }

 private:
  std::size_t keep(abut_shape* shape);
  std::size_t sphere(double radius);
  std::size_t box(double half_x, double half_y, double half_z);
  std::size_t capsule(double radius, double half_height);
  std::size_t hull(const std::vector<Vec3>& points);
  std::size_t mesh(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& indices);

  void add_spheres(Random& random);
  void add_boxes(Random& random);
  void add_capsules(Random& random);
  void add_hulls(Random& random);
  void add_snowmen(Random& random);
  void add_houses(Random& random);
  void add_dumbbells(Random& random);
  void add_crosses(Random& random);
  void add_pyramids(Random& random);
  void add_bunnies(const Triangles& bunny);

  void add(Kind kind, std::vector<Piece> pieces, double radius);

  std::vector<ShapeOwner> shapes_;
  std::vector<Design> designs_;
  std::array<std::vector<std::size_t>, kind_names.size()> designs_of_kind_;
};

}  // namespace demo
