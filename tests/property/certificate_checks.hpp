// A signed distance proved by what it comes with, where no oracle knows it beforehand.
//
// Apart: the points are as far from each other as the distance says, and a slab of that width across the normal parts
// the shapes. No distance is less than the slab, none is more than that of two points: both together prove it.
// Overlapping: the shapes part when one moves by the depth along the normal, and no direction that a search finds takes
// less. Only the search can miss something; it never rejects a right answer.
#pragma once

#include "distance_checks.hpp"
#include "solids.hpp"

namespace property {

void check_certificate(const SolidSubject& a, const SolidSubject& b, const Placement& placement);

}  // namespace property
