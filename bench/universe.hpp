// SPDX-License-Identifier: Apache-2.0
// Many moving bodies and what touches what, asked to one library.
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "scene.hpp"

namespace bench {

// Bodies that all move a little from frame to frame. The ground does not.
struct World {
  std::vector<Solid> solids;
  std::vector<std::size_t> bodies;             // the solid of each body
  std::vector<std::vector<Placement>> frames;  // a placement of each body
  Solid ground;
  Placement ground_at;
  std::size_t fast_share = 0;  // one in so many bodies is fast; none where this is 0
};

struct Touch {
  std::size_t a, b;  // bodies; the number of bodies for the ground
  Point normal;      // from a to b
  double distance;
};

struct Counts {
  std::size_t pairs = 0;        // of boxes, handed to the narrow phase
  std::size_t touching = 0;     // pairs with a contact
  std::size_t points = 0;       // contacts that are reported
  std::size_t overlapping = 0;  // contacts with a distance below 0
};

class Detector {
 public:
  Detector() = default;
  Detector(const Detector&) = delete;
  Detector& operator=(const Detector&) = delete;
  virtual ~Detector() = default;

  virtual void place(std::size_t frame) = 0;
  virtual void detect() = 0;
  [[nodiscard]] virtual Counts counts() const = 0;
};

// Gives a hull its vertices and its surface, which FCL and ODE want from outside.
void give_surface(Solid& solid);

// With Bullet's own margins when `margin` is negative.
[[gnu::visibility("default")]] std::unique_ptr<Detector> make_bullet_world(const World& world, double margin);
[[gnu::visibility("default")]] std::unique_ptr<Detector> make_fcl_world(const World& world);
// Null where ODE is not installed.
[[gnu::visibility("default")]] std::unique_ptr<Detector> make_ode_world(const World& world);
std::unique_ptr<Detector> make_abut_world(const World& world, unsigned threads);
// On one thread. Steps have a time, and `follows` tells whether they follow the paths of what is fast.
std::unique_ptr<Detector> make_abut_world_of_fast(const World& world, bool follows);

// All overlaps of bodies at placements, by abut.
std::vector<Touch> touches(const World& world, std::span<const Placement> placements);

}  // namespace bench
