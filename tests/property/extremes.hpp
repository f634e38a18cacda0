// SPDX-License-Identifier: Apache-2.0
// Extremes that collision code has to stand, each as a list of placed pairs of convex shapes.
#pragma once

#include <functional>
#include <optional>

#include "scenes.hpp"
#include "solids.hpp"

namespace property {

// `truth` is the signed distance where the way the pair was made tells it exactly.
using Visit = std::function<void(const SolidSubject& a, const SolidSubject& b, const Placement& placement,
                                 std::optional<double> truth)>;

void visit_size_ratio(double ratio, Random& random, const Visit& visit);
void visit_needles(Random& random, const Visit& visit);  // 1e6 times as long as wide
void visit_plates(Random& random, const Visit& visit);   // 1e6 times as wide as thick; each other and needles
void visit_far(double distance, Random& random, const Visit& visit);
void visit_parallel_faces(double angle, Random& random, const Visit& visit);
void visit_coincident(Random& random, const Visit& visit);
void visit_concentric(Random& random, const Visit& visit);
void visit_contained(Random& random, const Visit& visit);
void visit_zero_size(Random& random, const Visit& visit);

// Touching exactly: coordinates and turns are such that nothing is rounded.
void visit_touching_vertices(Random& random, const Visit& visit);
void visit_touching_edges(Random& random, const Visit& visit);
void visit_touching_faces(Random& random, const Visit& visit);

void visit_flat_hulls(Random& random, const Visit& visit);  // points, segments, polygons
void visit_sliver_hulls(Random& random, const Visit& visit);
void visit_repeating_hulls(Random& random, const Visit& visit);  // duplicate and near-duplicate vertices
void visit_large_hulls(Random& random, const Visit& visit);      // of 10,000 points

// All kinds that are convex and bounded, in a plain size.
[[nodiscard]] std::vector<SolidSubject> plain_solids();

}  // namespace property
