// SPDX-License-Identifier: Apache-2.0
// Pairs of placed solids whose hardness is a number: out of proportion, far away, nearly parallel, nearly touching, and
// on a floor of many triangles.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "accuracy_scenes.hpp"
#include "pairs.hpp"

namespace bench {

struct TwoKinds {
  Kind a = Kind::box, b = Kind::box;

  [[nodiscard]] std::string name() const;
};

// Each has `count` cases, or as many as lay on the side of the question; nothing where the oracle has no answer. Depths
// are judged without curved solids only.

// The second solid is smaller by the ratio, and both are needles or plates of the aspect. A side of the first faces the
// second. Gap and depth are a tenth to a half of the smaller, of depths its least thickness.
[[nodiscard]] std::optional<JudgedCell> out_of_proportion(Query query, TwoKinds kinds, double ratio, double aspect,
                                                          std::size_t count);
// Ordinary pairs that far from the origin.
[[nodiscard]] std::optional<JudgedCell> far_away(Query query, TwoKinds kinds, double distance, std::size_t count);
// Sides opposite to each other but for the angle, a hundredth of the size apart or deep.
[[nodiscard]] std::optional<JudgedCell> nearly_parallel(Query query, TwoKinds kinds, double angle, std::size_t count);
// A gap or a depth of that part of the size.
[[nodiscard]] std::optional<JudgedCell> nearly_touching(Query query, TwoKinds kinds, double part, std::size_t count);

// A solid a hundredth deep in a flat floor of at most so many triangles, for contacts: the depth is a closed form.
[[nodiscard]] JudgedCell on_a_floor(Kind kind, std::size_t triangles, std::size_t count);

}  // namespace bench
