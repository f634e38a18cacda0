// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <vector>

#include "extremes.hpp"

namespace property {

namespace {

enum class Seat : std::uint8_t { vertex, edge, face };

// A shape and how it sits: what lies lowest, under the origin of its frame, and how deep. Turns are quarters of a turn
// or thirds about a diagonal, whose quaternions and matrices are exact; lengths are sums of few powers of two.
struct Seated {
  SolidSubject solid;
  abut_quat turn;
  double depth;
  Seat seat;
};

constexpr abut_quat upright{1, 0, 0, 0};
constexpr abut_quat over{0, 1, 0, 0};                // half a turn about X
constexpr abut_quat along_x{0.5, 0.5, 0.5, 0.5};     // Z comes to X, X to Y, Y to Z
constexpr abut_quat along_y{0.5, -0.5, -0.5, -0.5};  // Z comes to Y

std::vector<Seated> seated() {
  std::vector<Seated> list;
  const auto add = [&list](const char* kind, const char* name, const std::vector<double>& numbers,
                           const abut_quat& turn, double depth,
                           Seat seat) { list.push_back({make_solid(kind, name, numbers), turn, depth, seat}); };
  add("point", "point", {}, upright, 0, Seat::vertex);
  add("segment", "standing segment", {0.75}, upright, 0.75, Seat::vertex);
  add("triangle", "standing triangle", {0, 0, -0.5, 1, 0.25, 0.5, -0.5, 0.5, 0.75}, upright, 0.5, Seat::vertex);
  add("sphere", "sphere", {0.75}, upright, 0.75, Seat::vertex);
  add("capsule", "standing capsule", {0.25, 0.5}, upright, 0.75, Seat::vertex);
  add("ellipsoid", "ellipsoid", {0.75, 0.5, 0.25}, upright, 0.25, Seat::vertex);
  add("cone", "cone on its apex", {0.5, 0.75}, over, 0.75, Seat::vertex);
  add("hull", "octahedron", {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1}, upright, 1, Seat::vertex);
  add("segment", "lying segment", {0.75}, along_x, 0, Seat::edge);
  add("segment", "segment lying across", {0.75}, along_y, 0, Seat::edge);
  add("triangle", "triangle on an edge", {-0.5, 0, -0.25, 0.5, 0, -0.25, 0, 0.5, 1}, upright, 0.25, Seat::edge);
  add("capsule", "lying capsule", {0.25, 0.5}, along_x, 0.25, Seat::edge);
  add("cylinder", "lying cylinder", {0.5, 0.75}, along_y, 0.5, Seat::edge);
  add("hull", "wedge", {-1, 0, -0.5, 1, 0, -0.5, -1, 1, 0.5, 1, 1, 0.5, -1, -1, 0.5, 1, -1, 0.5}, upright, 0.5,
      Seat::edge);
  add("triangle", "lying triangle", {-1, -1, 0, 1, -1, 0, 0, 1, 0}, upright, 0, Seat::face);
  add("box", "box", {0.75, 0.5, 0.25}, upright, 0.25, Seat::face);
  add("box", "box on its side", {0.75, 0.5, 0.25}, along_x, 0.5, Seat::face);
  add("box", "flat box", {0.75, 0.5, 0}, upright, 0, Seat::face);
  add("cylinder", "standing cylinder", {0.5, 0.75}, upright, 0.75, Seat::face);
  add("cone", "cone on its base", {0.5, 0.75}, upright, 0.75, Seat::face);
  add("hull", "prism", {-1, -1, -0.5, 1, -1, -0.5, 0, 1, -0.5, -1, -1, 0.5, 1, -1, 0.5, 0, 1, 0.5}, upright, 0.5,
      Seat::face);
  return list;
}

// One upside down under the other, as it is and with all of it turned and shifted.
void visit_seats(const Seated& below, const Seated& above, const Visit& visit) {
  const abut_pose pose_below{{0, 0, 0}, composed({{0, 0, 0}, over}, {{0, 0, 0}, below.turn}).orientation};
  const abut_pose pose_above{{0, 0, below.depth + above.depth}, above.turn};
  visit(below.solid, above.solid, {"", pose_below, pose_above}, 0.0);
  const abut_pose motion{{1024, -512.5, 0.25}, along_x};
  visit(below.solid, above.solid, {"", composed(motion, pose_below), composed(motion, pose_above)}, 0.0);
}

// All pairs whose less wide seat is that one.
void visit_touches(Seat narrower, const Visit& visit) {
  const std::vector<Seated> list = seated();
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t j = i; j < list.size(); ++j) {
      if (std::min(list[i].seat, list[j].seat) == narrower) visit_seats(list[i], list[j], visit);
    }
  }
}

// Boxes and cubes as hulls that share only a corner, an edge or a face.
void visit_boxes(const abut_vec3& steps, const Visit& visit) {
  const std::vector<double> corners{-0.5, -0.5, -0.5, 0.5, -0.5, -0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5,
                                    -0.5, -0.5, 0.5,  0.5, -0.5, 0.5,  -0.5, 0.5, 0.5,  0.5, 0.5, 0.5};
  std::vector<SolidSubject> list;
  list.push_back(make_solid("box", "box", {0.5, 0.5, 0.5}));
  list.push_back(make_solid("hull", "cube", corners));
  for (const SolidSubject& a : list) {
    for (const SolidSubject& b : list) {
      visit(a, b, {"", {{0, 0, 0}, upright}, {steps, upright}}, 0.0);
      visit(a, b, {"", {{64, 0.25, -1}, along_x}, {{64 + steps.x, 0.25 + steps.y, steps.z - 1}, along_y}}, 0.0);
    }
  }
}

}  // namespace

void visit_touching_vertices(Random&, const Visit& visit) {
  visit_touches(Seat::vertex, visit);
  visit_boxes({1, -1, 1}, visit);
}

void visit_touching_edges(Random&, const Visit& visit) {
  visit_touches(Seat::edge, visit);
  visit_boxes({0.25, 1, -1}, visit);
}

void visit_touching_faces(Random&, const Visit& visit) {
  visit_touches(Seat::face, visit);
  visit_boxes({0.25, -0.5, 1}, visit);
}

}  // namespace property
