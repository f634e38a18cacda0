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
    {"box/cone parallel touching -upper <= overlap along any direction", 1},
    {"box/ellipsoid coincident gap between the bounds", 4},
    {"capsule/ellipsoid coincident gap between the bounds", 2},
    {"capsule/ellipsoid concentric gap between the bounds", 1},
    {"capsule/ellipsoid deep gap between the bounds", 1},
    {"cone/cone parallel -upper <= overlap along any direction", 1},
    {"cone/cone parallel overlapping gap between the bounds", 2},
    {"cone/ellipsoid coincident gap between the bounds", 50},
    {"cone/ellipsoid concentric gap between the bounds", 15},
    {"cone/ellipsoid deep gap between the bounds", 9},
    {"cone/ellipsoid far from the origin -upper <= overlap along any direction", 1},
    {"cone/ellipsoid parallel -upper <= overlap along any direction", 2},
    {"cone/ellipsoid parallel overlapping gap between the bounds", 4},
    {"cone/hull grazing -upper <= overlap along any direction", 1},
    {"cone/hull parallel -upper <= overlap along any direction", 1},
    {"cylinder/cone concentric gap between the bounds", 1},
    {"cylinder/cylinder grazing -upper <= overlap along any direction", 1},
    {"cylinder/ellipsoid coincident gap between the bounds", 13},
    {"cylinder/ellipsoid concentric gap between the bounds", 4},
    {"cylinder/ellipsoid deep gap between the bounds", 4},
    {"cylinder/ellipsoid shallow -upper <= overlap along any direction", 1},
    {"ellipsoid/ellipsoid coincident gap between the bounds", 18},
    {"ellipsoid/ellipsoid concentric gap between the bounds", 3},
    {"ellipsoid/ellipsoid deep gap between the bounds", 2},
    {"ellipsoid/ellipsoid parallel -upper <= overlap along any direction", 1},
    {"ellipsoid/hull coincident gap between the bounds", 4},
    {"ellipsoid/hull concentric gap between the bounds", 1},
    {"ellipsoid/hull deep gap between the bounds", 2},
    {"segment/cone grazing -upper <= overlap along any direction", 1},
    {"segment/cone parallel touching -upper <= overlap along any direction", 1},
    {"segment/cylinder parallel -upper <= overlap along any direction", 1},
    {"segment/ellipsoid coincident gap between the bounds", 2},
    {"segment/ellipsoid concentric gap between the bounds", 1},
    {"segment/ellipsoid parallel -upper <= overlap along any direction", 2},
    {"triangle/box grazing distance <= separation along the normal", 1},
    {"triangle/box grazing gap between the bounds", 1},
    {"triangle/box parallel distance <= separation along the normal", 1},
    {"triangle/box parallel gap between the bounds", 1},
    {"triangle/capsule deep -upper <= overlap along any direction", 1},
    {"triangle/cone coincident gap between the bounds", 8},
    {"triangle/cone concentric gap between the bounds", 4},
    {"triangle/cone deep gap between the bounds", 2},
    {"triangle/cone parallel -upper <= overlap along any direction", 1},
    {"triangle/cone parallel overlapping gap between the bounds", 2},
    {"triangle/cone shallow -upper <= overlap along any direction", 1},
    {"triangle/cylinder grazing -upper <= overlap along any direction", 1},
    {"triangle/ellipsoid coincident gap between the bounds", 2},
    {"triangle/ellipsoid concentric gap between the bounds", 1},
    {"triangle/ellipsoid deep gap between the bounds", 1},
    {"triangle/ellipsoid parallel -upper <= overlap along any direction", 1},
    {"triangle/ellipsoid shallow -upper <= overlap along any direction", 1},
    {"triangle/sphere concentric -upper <= overlap along any direction", 1},
});

}  // namespace property
