// Inputs on which other libraries failed, read from tests/data/known_failures.jsonl.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "body.hpp"
#include "quad.hpp"

namespace oracle {

// A shape of a row, with what a caller of a library needs to make the same one.
struct FailureShape {
  std::string type;                // "box", "sphere", "capsule", "convex" or "triangle"
  std::vector<double> parameters;  // half extents; radius; radius and half length
  Body body;                       // the same in the local frame; capsules along Z
};

struct FailurePose {
  std::array<double, 3> position{};
  std::array<double, 4> wxyz{1, 0, 0, 0};
  std::array<double, 4> axis_wxyz{1, 0, 0, 0};  // applied to the shape first: turns local Z to its axis
};

struct KnownFailure {
  std::string id;
  std::string query;
  FailureShape a;
  FailureShape b;
  FailurePose pose_a;
  FailurePose pose_b;
  Quad reference = 0;  // to 22 digits
};

// Rows that have a signed distance and whose shapes are all known here, in the order of the file.
[[nodiscard]] std::vector<KnownFailure> read_known_failures(const std::string& path);

// The pose of the shape in the world, with its axis turned.
[[nodiscard]] Pose pose_of(const FailurePose& pose);

}  // namespace oracle
