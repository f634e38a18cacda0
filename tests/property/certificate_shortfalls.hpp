// The same list for distances that are judged by their certificates, curved shapes among them.
//
// - "gap between the bounds": of shapes that lie in each other with a common centre or axis many directions are as
//   good, and the polytope cannot prove the least depth, although it finds it.
// - the others are bounds, depths and points of single needles, plates and size ratios of 1e6.
#pragma once

#include <array>

#include "shortfall.hpp"

namespace property {

inline constexpr auto certificate_shortfalls = std::to_array<Shortfall>({
    {"box/cone parallel touching -upper <= overlap along any direction", 1, 1.6e-13},
    {"box/ellipsoid coincident gap between the bounds", 4, 5.4e-05},
    {"capsule/ellipsoid coincident gap between the bounds", 2, 2.1e-06},
    {"capsule/ellipsoid concentric gap between the bounds", 1, 2.4e-09},
    {"capsule/ellipsoid deep gap between the bounds", 1, 0.00067},
    {"cone/cone parallel -upper <= overlap along any direction", 1, 2.6e-13},
    {"cone/cone parallel overlapping gap between the bounds", 2, 6.5e-07},
    {"cone/ellipsoid coincident gap between the bounds", 50, 0.033},
    {"cone/ellipsoid concentric gap between the bounds", 15, 0.032},
    {"cone/ellipsoid deep gap between the bounds", 9, 0.033},
    {"cone/ellipsoid far from the origin -upper <= overlap along any direction", 1, 3.9e-13},
    {"cone/ellipsoid parallel -upper <= overlap along any direction", 2, 1.1e-12},
    {"cone/ellipsoid parallel overlapping gap between the bounds", 4, 6.5e-07},
    {"cone/hull grazing -upper <= overlap along any direction", 1, 2.5e-13},
    {"cone/hull parallel -upper <= overlap along any direction", 1, 2.2e-13},
    {"cylinder/cone concentric gap between the bounds", 1, 0.00024},
    {"cylinder/cylinder grazing -upper <= overlap along any direction", 1, 7e-14},
    {"cylinder/ellipsoid coincident gap between the bounds", 13, 0.00078},
    {"cylinder/ellipsoid concentric gap between the bounds", 4, 0.00094},
    {"cylinder/ellipsoid deep gap between the bounds", 4, 0.00094},
    {"cylinder/ellipsoid shallow -upper <= overlap along any direction", 1, 2.7e-11},
    {"ellipsoid/ellipsoid coincident gap between the bounds", 18, 0.035},
    {"ellipsoid/ellipsoid concentric gap between the bounds", 3, 0.034},
    {"ellipsoid/ellipsoid deep gap between the bounds", 2, 0.034},
    {"ellipsoid/ellipsoid parallel -upper <= overlap along any direction", 1, 2.2e-12},
    {"ellipsoid/hull coincident gap between the bounds", 4, 0.00069},
    {"ellipsoid/hull concentric gap between the bounds", 1, 0.00069},
    {"ellipsoid/hull deep gap between the bounds", 2, 0.034},
    {"segment/cone grazing -upper <= overlap along any direction", 1, 6.4e-14},
    {"segment/cone parallel touching -upper <= overlap along any direction", 1, 2.7e-13},
    {"segment/cylinder parallel -upper <= overlap along any direction", 1, 1e-11},
    {"segment/ellipsoid coincident gap between the bounds", 2, 2.1e-06},
    {"segment/ellipsoid concentric gap between the bounds", 1, 3.6e-09},
    {"segment/ellipsoid parallel -upper <= overlap along any direction", 2, 5e-12},
    {"triangle/box grazing distance <= separation along the normal", 1, 2.6e-12},
    {"triangle/box grazing gap between the bounds", 1, 2.6e-12},
    {"triangle/box parallel distance <= separation along the normal", 1, 1.5e-12},
    {"triangle/box parallel gap between the bounds", 1, 1.5e-12},
    {"triangle/capsule deep -upper <= overlap along any direction", 1, 1.1e-13},
    {"triangle/cone coincident gap between the bounds", 8, 7.5e-05},
    {"triangle/cone concentric gap between the bounds", 4, 2.4e-05},
    {"triangle/cone deep gap between the bounds", 2, 1.9e-05},
    {"triangle/cone parallel -upper <= overlap along any direction", 1, 4.8e-12},
    {"triangle/cone parallel overlapping gap between the bounds", 2, 1.5e-09},
    {"triangle/cone shallow -upper <= overlap along any direction", 1, 2.1e-14},
    {"triangle/cylinder grazing -upper <= overlap along any direction", 1, 9.2e-14},
    {"triangle/ellipsoid coincident gap between the bounds", 2, 0.00062},
    {"triangle/ellipsoid concentric gap between the bounds", 1, 0.00062},
    {"triangle/ellipsoid deep gap between the bounds", 1, 0.00062},
    {"triangle/ellipsoid parallel -upper <= overlap along any direction", 1, 1.4e-12},
    {"triangle/ellipsoid shallow -upper <= overlap along any direction", 1, 8.3e-12},
    {"triangle/sphere concentric -upper <= overlap along any direction", 1, 1.7e-12},
});

}  // namespace property
