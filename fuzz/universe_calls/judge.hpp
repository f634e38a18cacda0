// SPDX-License-Identifier: Apache-2.0
// Compares what a detection found with what the model says, and takes the model
// one detection further.
#pragma once

#include "model.hpp"
#include "universes.hpp"

namespace universe_calls {

// Throws a Finding.
void judge_detection(World& world, const Scope& scope, const Found& found);

// Of one contact: a unit normal, its distance along it, and where the pair is
// as it was examined, points that lie on their shapes.
void judge_contact(const abut_contact& contact);
void judge_points(const World& world, const Geometry& a, const Geometry& b, const abut_contact& contact);

}  // namespace universe_calls
