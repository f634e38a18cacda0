// SPDX-License-Identifier: Apache-2.0
// Detectors as abut_backend_set takes them.
#pragma once

#include <abut/abut.h>

#include <optional>
#include <vector>

namespace backend {

// A table of functions. What they need lies behind `context`, which lives as long as the program.
struct Detector {
  const char* name;
  abut_backend_accepts accepts;
  abut_backend_find find;
  void* context;
  double error;  // of distances and points, in units of the scenes, whose bodies are about one large
};

// abut itself, by its queries of two shapes.
Detector plain();
// The collision half of Bullet, in single precision: spheres, boxes and capsules.
Detector bullet();

// Of features and an id that say nothing.
inline abut_backend_contact contact_of(const abut_vec3& point_a, const abut_vec3& point_b, const abut_vec3& normal) {
  abut_backend_contact contact{};
  contact.point_a = point_a;
  contact.point_b = point_b;
  contact.normal = normal;
  return contact;
}

// For detectors: answers a pair, which has to be possible.
void answer(abut_universe* universe, std::size_t pair, const std::vector<abut_backend_contact>& contacts);

// What abut_pair_contacts finds of a pair; nothing where it fails.
std::optional<std::vector<abut_backend_contact>> contacts_of(const abut_backend_pair& pair);

}  // namespace backend
