// SPDX-License-Identifier: Apache-2.0
// Convex shapes of the library, curved ones included, each with the same solid for the oracle.
#pragma once

#include <string>
#include <vector>

#include "oracle/solid.hpp"
#include "subject.hpp"

namespace property {

struct SolidSubject {
  Subject subject;  // what the oracle measures is empty for curved ones and many points: the solid takes its place
  oracle::Solid solid;
  bool is_curved = false;  // cylinders, cones and ellipsoids: distances to 1e-9 instead of 1e-12
};

// The parameters of the kind in its order, or x y z of each point of a hull. Throws where the library refuses them.
[[nodiscard]] SolidSubject make_solid(const std::string& kind, const std::string& name,
                                      const std::vector<double>& numbers);

// Of one kind: ordinary, tiny, huge, needles, plates, and flat ones where the kind has them. Empty for a kind that the
// build does not know.
[[nodiscard]] std::vector<SolidSubject> solid_subjects(const std::string& kind);

}  // namespace property
