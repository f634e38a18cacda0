// SPDX-License-Identifier: Apache-2.0
// Inputs on which libraries failed, read from tests/data/known_failures.jsonl and tests/data/found.jsonl.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "body.hpp"
#include "quad.hpp"
#include "solid.hpp"

namespace oracle {

// A shape of a row, in its local frame; what has an axis lies along Z.
struct FailureShape {
  std::string type;                // "box", "sphere", "capsule", "cylinder", "cone", "ellipsoid", "disc", "convex",
                                   // "triangle", "mesh"
  std::vector<double> parameters;  // half extents; radius; radius and half length; radii
  Soup soup;                       // the points of a "convex" or a "triangle", the points and triangles of a "mesh"
};

struct FailurePose {
  std::array<double, 3> position{};
  std::array<double, 4> wxyz{1, 0, 0, 0};
  std::array<double, 4> axis_wxyz{1, 0, 0, 0};  // applied to the shape first: turns local Z to its axis
};

// A ray against the first shape, and how far along it all crossings are.
struct FailureRay {
  Point origin{};
  Point direction{};
  std::vector<double> hits;
};

// Points whose convex hull is asked for.
struct FailureHull {
  std::vector<Point> points;
  std::size_t vertices = 0;
  std::optional<double> volume;
};

// Four vertices that go straight from start to end: a vertex and a face, or two edges.
struct FailureMotion {
  bool is_vertex_face = false;
  std::array<Point, 4> start{};
  std::array<Point, 4> end{};
};

// The first shape moves along a straight way without turning. What its source does not tell is absent.
struct FailureCast {
  Point displacement{};
  bool touches = false;
  std::optional<double> fraction;  // of the displacement; 0 where the shapes overlap at the start
};

// A row of the file. What it does not ask for is absent.
struct KnownFailure {
  std::string id;
  std::string query;
  std::optional<FailureShape> a;
  std::optional<FailureShape> b;
  FailurePose pose_a;
  FailurePose pose_b;
  std::optional<Quad> distance;  // signed, of the poses as they are; references to 22 digits
  std::optional<FailureCast> cast;
  bool asks_contacts = false;
  std::size_t contacts = 0;  // that the source expects at least; 0 where it does not say
  std::optional<FailureRay> ray;
  std::optional<FailureHull> hull;
  std::optional<FailureMotion> motion;
};

// All rows, in the order of the file.
[[nodiscard]] std::vector<KnownFailure> read_known_failures(const std::string& path);

// The shape as a convex solid; absent for a mesh.
[[nodiscard]] std::optional<Solid> solid_of(const FailureShape& shape);

// The pose of the shape in the world, with its axis turned.
[[nodiscard]] Pose pose_of(const FailurePose& pose);

}  // namespace oracle
