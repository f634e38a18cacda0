// SPDX-License-Identifier: Apache-2.0
// A cloth that falls on a bunny, by position-based dynamics (Mueller et al. 2007) on element contacts: a reference of
// how stencils are used, not a fast simulation.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "common/random.hpp"
#include "common/triangles.hpp"
#include "owned.hpp"

namespace demo {

/// A surface in the world.
[[nodiscard]] ShapeOwner make_mesh(const Triangles& triangles);

class Cloth {
 public:
  /// The cloth lies level above the bunny, whose vertices are in the world.
  Cloth(const Triangles& bunny, Random random, std::uint32_t threads);

  /// Moves the cloth, a twentieth of a second at a time.
  void advance(double seconds);

  [[nodiscard]] const Triangles& sheet() const { return sheet_; }
  /// Of the last twentieth of a second. The bunny is geometry a, or the cloth is both.
  [[nodiscard]] std::span<const abut_element_contact> contacts() const;
  [[nodiscard]] bool is_on_bunny(const abut_element_contact& contact) const {
    return contact.geometry_a.slot != cloth_.slot;
  }
  [[nodiscard]] Vec3 middle_of(const abut_element_contact& contact) const;

 private:
  // Keeps two vertices as far apart as they are at rest.
  struct Spring {
    std::uint32_t a, b;
    double length;
    double share;  // of the error that an iteration takes away
  };
  // Keeps two features apart: the sum of weights times places along the normal, and what vertices of the bunny add.
  struct Barrier {
    std::array<std::uint32_t, 4> vertices;
    std::array<double, 4> weights;  // of vertices of the cloth, else 0
    Vec3 normal;
    double offset;
    double mobility;
    bool is_on_bunny;
  };

  void add_springs();
  void place(const Triangles& bunny, std::uint32_t threads);
  void fall();
  void find_barriers();
  void solve();
  void rub();
  [[nodiscard]] double distance_at(const Barrier& barrier) const;
  void push(const Barrier& barrier, const Vec3& by);

  Triangles sheet_;
  std::vector<Vec3> bunny_, before_, velocities_;
  std::vector<Spring> springs_;
  std::vector<Barrier> barriers_;
  UniverseOwner universe_;
  abut_geometry_id cloth_{};
};

}  // namespace demo
