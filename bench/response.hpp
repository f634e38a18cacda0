// SPDX-License-Identifier: Apache-2.0
// Bodies that engines move, in common words. Double precision everywhere.
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace bench {

using Vector3 = std::array<double, 3>;

struct MovingBody {
  bool is_box = false;
  double half = 0;  // radius, or half of the height of a box
  double side = 0;  // half of the other sides of a box
  double mass = 1;
  Vector3 position{}, velocity{};
};

// Above a ground at height 0.
struct MovingWorld {
  std::vector<MovingBody> bodies;
  double friction = 0;         // of bodies among themselves
  double ground_friction = 0;  // of boxes with the ground; balls have that of bodies
  double restitution = 0;
  double stiffness = 0;  // of contacts, N/m; 0: rigid
  double gravity = 9.81;
  double reach = 1e-3;  // as far ahead as contacts are to be seen, where an engine can
};

// How hard an engine tries.
struct Effort {
  std::string name;
  int iterations = 0;
  double tolerance = 0;
  bool by_midpoint = false;  // abut: how bodies are integrated, else by implicit Euler
};

class [[gnu::visibility("default")]] Mover {
 public:
  Mover() = default;
  Mover(const Mover&) = delete;
  Mover& operator=(const Mover&) = delete;
  Mover(Mover&&) = delete;
  Mover& operator=(Mover&&) = delete;
  virtual ~Mover() = default;

  // In the next step.
  virtual void push(std::size_t body, const Vector3& force) = 0;
  virtual void step(double dt) = 0;
  [[nodiscard]] virtual Vector3 position(std::size_t body) const = 0;
  [[nodiscard]] virtual Vector3 velocity(std::size_t body) const = 0;
};

// Iterations 0: the solver of ODE that factors.
[[gnu::visibility("default")]] std::unique_ptr<Mover> make_ode_mover(const MovingWorld& world, const Effort& effort);
[[gnu::visibility("default")]] bool has_ode();
[[gnu::visibility("default")]] std::unique_ptr<Mover> make_bullet_mover(const MovingWorld& world, const Effort& effort);
// A tolerance of 0: sweeps. With restitution, steps stop at impacts.
std::unique_ptr<Mover> make_abut_mover(const MovingWorld& world, const Effort& effort);

}  // namespace bench
