// SPDX-License-Identifier: Apache-2.0
// A signed distance proved by what it comes with, where no oracle knows it beforehand.
//
// Apart: the points are as far from each other as the distance says. A slab of that width across the normal parts the
// shapes. No distance is less than the slab, none is more than that of two points: both together prove it.
// Overlapping: the shapes part when one moves by the depth along the normal, and no direction that a search finds takes
// less. Only the search can miss something; it never rejects a right answer.
#pragma once

#include <optional>

#include "distance_checks.hpp"
#include "solids.hpp"

namespace property {

struct Certified {
  abut_distance result;
  double error;  // of the distance, as far as the certificate tells
  Case base;
};

// Reports what does not hold in the row of that name, or in one of the kinds and the scene where it is empty. Absent
// where the library gave no answer or no finite one.
[[nodiscard]] std::optional<Certified> certified(const SolidSubject& a, const SolidSubject& b,
                                                 const Placement& placement, const std::string& row);

// The same, kept in the record.
void check_certificate(const SolidSubject& a, const SolidSubject& b, const Placement& placement);

// Keeps the error of an answer in the record, as a part of the size of the case.
void keep(const Certified& answer);

}  // namespace property
