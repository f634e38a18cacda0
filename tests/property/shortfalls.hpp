// Where the library falls short of a fact in a known number of cases, row by row: pair of kinds, scene, fact.
// A ratchet: one more case in a row, or a row that is not here, fails the test; when there are fewer, lower the
// number. The size of each offence is not bounded by this list.
//
// - "lie across": flat shapes that coincide or touch along an edge have many closest pairs; the points that are
//   given are at the right distance along the normal, but not across from each other.
// - "mirrored": mostly nearly parallel faces with coinciding edges, where one order keeps a corner that the other
//   one cuts off.
// - between convex shapes, the other facts fail on needles, plates and size ratios of 1e6.
// - of meshes and height fields that another shape has sunk into, some contacts are missing, too shallow, or above
//   the surface; the causes are not settled.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace property {

struct Shortfall {
  std::string_view row;
  std::uint64_t cases;
};

inline constexpr auto shortfalls = std::to_array<Shortfall>({
    {"box/box apart upper - lower within the error bound", 1},
    {"box/box deep upper - lower within the error bound", 1},
    {"box/box far from the origin upper - lower within the error bound", 4},
    {"box/box grazing contact mirrored when swapped", 1},
    {"box/box grazing contact points lie across each other", 1},
    {"box/box grazing points lie across each other", 2},
    {"box/box grazing upper - lower within the error bound", 1},
    {"box/box parallel overlapping contact mirrored when swapped", 24},
    {"box/box parallel overlapping distance after parting", 1},
    {"box/box parallel overlapping points lie across each other", 1},
    {"box/box parallel overlapping upper - lower within the error bound", 6},
    {"box/box parallel separation along the normal falls short of the distance", 4},
    {"box/box parallel touching contact mirrored when swapped", 34},
    {"box/box parallel touching contact points lie across each other", 3},
    {"box/box parallel touching points lie across each other", 5},
    {"box/box parallel upper - lower within the error bound", 10},
    {"box/box shallow contact points lie across each other", 1},
    {"box/box shallow upper - lower within the error bound", 2},
    {"box/box touching contact points lie across each other", 1},
    {"box/box touching points lie across each other", 6},
    {"box/box touching upper - lower within the error bound", 1},
    {"box/capsule coincident contact points lie across each other", 10},
    {"box/capsule coincident points lie across each other", 10},
    {"box/capsule parallel overlapping contact points lie across each other", 3},
    {"box/capsule parallel separation along the normal falls short of the distance", 2},
    {"box/capsule parallel touching contact points lie across each other", 4},
    {"box/capsule parallel upper - lower within the error bound", 2},
    {"box/hull coincident contact points lie across each other", 10},
    {"box/hull coincident points lie across each other", 8},
    {"box/hull concentric contact points lie across each other", 3},
    {"box/hull concentric points lie across each other", 2},
    {"box/hull deep points lie across each other", 1},
    {"box/hull parallel overlapping contact mirrored when swapped", 14},
    {"box/hull parallel overlapping contact points lie across each other", 1},
    {"box/hull parallel overlapping points lie across each other", 2},
    {"box/hull parallel overlapping reduction keeps nine tenths of the area", 1},
    {"box/hull parallel touching contact mirrored when swapped", 15},
    {"box/hull parallel touching contact points lie across each other", 12},
    {"box/hull parallel touching points lie across each other", 12},
    {"box/hull shallow truth <= upper", 1},
    {"box/hull touching contact points lie across each other", 1},
    {"box/hull touching points lie across each other", 1},
    {"capsule/capsule parallel overlapping contact points lie across each other", 2},
    {"capsule/capsule parallel touching contact mirrored when swapped", 3},
    {"capsule/capsule parallel touching contact points lie across each other", 10},
    {"capsule/hull coincident contact points lie across each other", 11},
    {"capsule/hull coincident points lie across each other", 11},
    {"capsule/hull concentric contact points lie across each other", 3},
    {"capsule/hull concentric points lie across each other", 3},
    {"capsule/hull parallel overlapping contact mirrored when swapped", 2},
    {"capsule/hull parallel touching contact mirrored when swapped", 2},
    {"capsule/hull parallel touching contact point above the surface of b", 3},
    {"height_field/box above contact within the margin exists", 2},
    {"height_field/box sunk in contact points lie across each other", 2},
    {"height_field/box sunk in deepest contact is as deep as the shapes", 3},
    {"height_field/capsule above contact within the margin exists", 1},
    {"height_field/capsule sunk in contact within the margin exists", 3},
    {"height_field/hull above contact within the margin exists", 2},
    {"height_field/hull sunk in contact point above the surface of a", 1},
    {"height_field/hull sunk in contact within the margin exists", 8},
    {"height_field/hull sunk in deepest contact is as deep as the shapes", 15},
    {"height_field/sphere sunk in contact within the margin exists", 1},
    {"hull/hull coincident contact mirrored when swapped", 11},
    {"hull/hull coincident contact points lie across each other", 5},
    {"hull/hull coincident points lie across each other", 5},
    {"hull/hull concentric contact mirrored when swapped", 12},
    {"hull/hull concentric contact point above the surface of a", 1},
    {"hull/hull concentric contact points lie across each other", 1},
    {"hull/hull concentric deepest contact is as deep as the shapes", 1},
    {"hull/hull concentric no contact deeper than the shapes", 1},
    {"hull/hull concentric points lie across each other", 1},
    {"hull/hull deep contact mirrored when swapped", 4},
    {"hull/hull deep contact point above the surface of a", 1},
    {"hull/hull deep deepest contact is as deep as the shapes", 1},
    {"hull/hull deep no contact deeper than the shapes", 1},
    {"hull/hull deep point_a is off the surface of a", 1},
    {"hull/hull deep point_b is off the surface of b", 1},
    {"hull/hull far from the origin contact mirrored when swapped", 12},
    {"hull/hull far from the origin contact point above the surface of a", 1},
    {"hull/hull far from the origin deepest contact is as deep as the shapes", 3},
    {"hull/hull far from the origin no contact deeper than the shapes", 3},
    {"hull/hull far from the origin points lie across each other", 2},
    {"hull/hull grazing contact mirrored when swapped", 1},
    {"hull/hull parallel overlapping contact mirrored when swapped", 50},
    {"hull/hull parallel overlapping contact point above the surface of a", 1},
    {"hull/hull parallel overlapping contact points lie across each other", 2},
    {"hull/hull parallel overlapping points lie across each other", 4},
    {"hull/hull parallel touching contact mirrored when swapped", 51},
    {"hull/hull parallel touching contact point above the surface of a", 7},
    {"hull/hull parallel touching contact points lie across each other", 11},
    {"hull/hull parallel touching deepest contact is as deep as the shapes", 3},
    {"hull/hull parallel touching no contact deeper than the shapes", 3},
    {"hull/hull parallel touching points lie across each other", 21},
    {"hull/hull shallow contact mirrored when swapped", 13},
    {"hull/hull shallow contact point above the surface of a", 5},
    {"hull/hull shallow deepest contact is as deep as the shapes", 5},
    {"hull/hull shallow no contact deeper than the shapes", 5},
    {"hull/hull touching contact point above the surface of a", 2},
    {"hull/hull touching contact points lie across each other", 1},
    {"hull/hull touching deepest contact is as deep as the shapes", 2},
    {"hull/hull touching no contact deeper than the shapes", 2},
    {"hull/hull touching points lie across each other", 3},
    {"mesh/box sunk in contact points lie across each other", 26},
    {"mesh/box sunk in deepest contact is as deep as the shapes", 2},
    {"mesh/hull sunk in contact point above the surface of a", 2},
    {"mesh/hull sunk in contact points lie across each other", 3},
    {"mesh/hull sunk in deepest contact is as deep as the shapes", 9},
    {"sphere/box parallel overlapping separation along the normal falls short of the distance", 1},
    {"sphere/box parallel overlapping upper - lower within the error bound", 1},
    {"sphere/hull deep truth <= upper", 1},
});

[[nodiscard]] constexpr std::uint64_t known_shortfall(std::string_view row) {
  for (const Shortfall& shortfall : shortfalls) {
    if (shortfall.row == row) return shortfall.cases;
  }
  return 0;
}

}  // namespace property
