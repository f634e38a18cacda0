// SPDX-License-Identifier: Apache-2.0
// A shape that accepts edits, as plain numbers beside the library's own.
#pragma once

#include <abut/abut.h>

#include <memory>
#include <utility>

#include "record.hpp"

namespace edit_fuzzing {

struct Release {
  void operator()(abut_shape* shape) const { abut_shape_release(shape); }
};
using Shape = std::unique_ptr<abut_shape, Release>;

[[nodiscard]] Shape made(const char* kind, const std::vector<double>& parameters, const std::vector<double>& reals,
                         const std::vector<std::uint32_t>& indices);

using Point = std::array<double, 3>;
using Triangle = std::array<Point, 3>;
struct Ball {
  Point centre;
  double radius;
};

class Subject {
 public:
  Subject() = default;
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;
  virtual ~Subject() = default;

  // Changes the shape of the geometry, and the numbers here only where the call says that it went well.
  virtual abut_status change(abut_universe* universe, abut_geometry_id geometry, const Record& record) = 0;
  [[nodiscard]] virtual Shape made_anew() const = 0;
  // What it is made of, where an oracle knows what to do with that.
  [[nodiscard]] virtual std::vector<Triangle> triangles() const { return {}; }
  [[nodiscard]] virtual std::vector<Ball> balls() const { return {}; }
  // Where such triangles fold, how deep a ball is depends on their order, which edits do not keep.
  [[nodiscard]] virtual bool stops_from_the_front_only() const { return false; }
};

[[nodiscard]] std::unique_ptr<Subject> subject_of(const Record& first);

}  // namespace edit_fuzzing
