// SPDX-License-Identifier: Apache-2.0
// Shapes that are made of many parts, beside convex solids: surfaces, solid meshes, fields, particles and composites.
// Their answer is the least over their parts, by the oracle of the tests, or a closed form on flat ground.
#pragma once
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "accuracy_judge.hpp"
#include "accuracy_scenes.hpp"

namespace bench {

inline constexpr std::array kinds_of_parts{Kind::plane,          Kind::mesh,      Kind::height_field, Kind::solid_mesh,
                                           Kind::distance_field, Kind::particles, Kind::composite};

class PartsJudge {
 public:
  // `normal`: of ground that is flat, through the origin; null where there is none.
  PartsJudge(const Solid& whole, const std::optional<oracle::Vec>& normal);

  // Nothing where that of a part is not known. Without overlaps a bound of shapes apart, as least_distance.
  [[nodiscard]] std::optional<oracle::Quad> distance(const oracle::Pose& at_whole, Judge& b, const oracle::Pose& at_b,
                                                     double reach_b, bool with_overlaps);
  [[nodiscard]] oracle::Quad cast(const oracle::Pose& at_whole, const Judge& b, const oracle::Pose& at_b,
                                  const Point& motion, double reach_b) const;

 private:
  // A part and a ball around it, in the frame of the whole.
  struct Part {
    Judge judge;
    oracle::Vec place;
    Point centre;
    double reach;
  };

  [[nodiscard]] static oracle::Pose pose_of(const Part& part, const oracle::Pose& at_whole);

  std::optional<oracle::Vec> normal_;
  std::vector<Part> parts_;
};

class PartScenes {
 public:
  // `a` is one of kinds_of_parts. Nothing where no truth is known.
  [[nodiscard]] std::optional<JudgedCell> make(Query query, Kind a, Kind b, std::size_t count);

 private:
  struct Wholes {
    std::vector<Solid> solids;
    std::vector<PartsJudge> judges;
  };
  struct Bodies {
    std::vector<Solid> solids;
    std::vector<Judge> judges;
  };

  Wholes& wholes(Kind kind, bool is_flat);
  Bodies& bodies(Kind kind);

  std::map<std::pair<Kind, bool>, Wholes> wholes_;
  std::map<Kind, Bodies> bodies_;
};

}  // namespace bench
