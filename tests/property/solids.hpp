// Convex shapes of the library, curved ones included, each with the same solid for the oracle.
#pragma once

#include <string>
#include <vector>

#include "oracle/solid.hpp"
#include "subject.hpp"

namespace property {

struct SolidSubject {
  Subject subject;  // what the oracle measures of it is empty: the solid takes its place
  oracle::Solid solid;
  bool is_curved = false;  // cylinders, cones and ellipsoids: distances to 1e-9 instead of 1e-12
};

// Of one kind: ordinary, tiny, huge, needles, plates, and flat ones where the kind has them. Empty for a kind that the
// build does not know.
[[nodiscard]] std::vector<SolidSubject> solid_subjects(const std::string& kind);

}  // namespace property
