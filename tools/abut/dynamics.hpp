// SPDX-License-Identifier: Apache-2.0
// Bodies of a scene that gravity and contacts move, by the response library, which the first such scene loads.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "abut/response.h"
#include "response_library.hpp"
#include "scene.hpp"

namespace cli {

/// What the scene asks of the library; only scenes with a field "response" have it.
class Dynamics {
 public:
  /// Makes bodies of the parts of those numbers. `parts` are all of the scene, in the universe. Throws BadInput.
  Dynamics(abut_universe* universe, const Scene& scene, std::span<const abut_part_id> parts,
           std::vector<std::size_t> bodies);

  /// Steps the universe as well.
  [[nodiscard]] abut_status step(double dt);

  /// The numbers of the parts that are bodies.
  [[nodiscard]] const std::vector<std::size_t>& bodies() const { return bodies_; }
  [[nodiscard]] abut_energy energy() const;
  /// Of the last step.
  [[nodiscard]] std::size_t contact_count() const;
  /// How deep bodies overlapped at the start of the step; 0 where none did.
  [[nodiscard]] double deepest() const;
  /// A velocity: by how much the worst contact or body of an island missed its law.
  [[nodiscard]] double residual() const;

 private:
  struct Destroy {
    decltype(&abut_response_destroy) destroy;
    void operator()(abut_response* its) const { destroy(its); }
  };
  void add_bodies(const Scene& scene, std::span<const abut_part_id> parts);
  [[nodiscard]] std::span<const abut_response_contact> contacts() const;

  ResponseFunctions library_;
  std::unique_ptr<abut_response, Destroy> response_;
  std::vector<std::size_t> bodies_;
};

}  // namespace cli
