// SPDX-License-Identifier: Apache-2.0
// The same list for distances that are judged by their certificates, curved shapes among them.
//
// - "gap between the bounds": shapes with a common centre or axis overlap as deep along many directions. The polytope
//   finds the least depth there, but cannot prove it.
// - the others are bounds, depths and points of single needles, plates and size ratios of 1e6.
#pragma once

#include <array>

#include "shortfall.hpp"

namespace property {

inline constexpr auto certificate_shortfalls = std::to_array<Shortfall>({
    {"box/ellipsoid coincident gap between the bounds", 2, 6.7e-05},
    {"box/ellipsoid concentric gap between the bounds", 1, 6.7e-05},
    {"capsule/ellipsoid deep gap between the bounds", 1, 5.2e-05},
    {"cone/ellipsoid coincident gap between the bounds", 50, 0.0088},
    {"cone/ellipsoid concentric gap between the bounds", 9, 0.0088},
    {"cone/ellipsoid deep gap between the bounds", 8, 0.0069},
    {"cone/ellipsoid parallel overlapping gap between the bounds", 5, 1.6e-07},
    {"cylinder/ellipsoid coincident gap between the bounds", 13, 0.00027},
    {"cylinder/ellipsoid concentric gap between the bounds", 3, 0.00031},
    {"cylinder/ellipsoid deep gap between the bounds", 3, 5.6e-05},
    {"ellipsoid/ellipsoid coincident gap between the bounds", 16, 0.0018},
    {"ellipsoid/ellipsoid concentric gap between the bounds", 3, 0.0012},
    {"ellipsoid/ellipsoid deep gap between the bounds", 2, 0.0031},
    {"ellipsoid/hull coincident gap between the bounds", 2, 0.00019},
    {"ellipsoid/hull concentric gap between the bounds", 1, 0.00019},
    {"ellipsoid/hull deep gap between the bounds", 2, 0.009},
    {"triangle/box grazing distance <= separation along the normal", 1, 2.6e-12},
    {"triangle/box grazing gap between the bounds", 1, 2.6e-12},
    {"triangle/box parallel distance <= separation along the normal", 1, 1.5e-12},
    {"triangle/box parallel gap between the bounds", 1, 1.5e-12},
    {"triangle/capsule deep -upper <= overlap along any direction", 1, 1.1e-13},
    {"triangle/cone coincident gap between the bounds", 8, 1.9e-05},
    {"triangle/cone concentric gap between the bounds", 4, 6e-06},
    {"triangle/cone deep gap between the bounds", 2, 4.7e-07},
    {"triangle/ellipsoid coincident gap between the bounds", 2, 5.6e-05},
    {"triangle/ellipsoid concentric gap between the bounds", 1, 5.6e-05},
    {"triangle/ellipsoid deep gap between the bounds", 1, 5.5e-05},
    {"triangle/sphere concentric -upper <= overlap along any direction", 1, 1.7e-12},
});

}  // namespace property
