// SPDX-License-Identifier: Apache-2.0
// The algorithms of a pair by name, as a scene and as answers call them.
#pragma once

#include <array>

#include "node.hpp"

namespace cli {

inline constexpr std::array<Choice, 6> algorithms{{{"auto", ABUT_ALGORITHM_AUTO},
                                                   {"analytic", ABUT_ALGORITHM_ANALYTIC},
                                                   {"sat", ABUT_ALGORITHM_SAT},
                                                   {"gjk_epa", ABUT_ALGORITHM_GJK_EPA},
                                                   {"libccd_gjk", ABUT_ALGORITHM_LIBCCD_GJK},
                                                   {"libccd_mpr", ABUT_ALGORITHM_LIBCCD_MPR}}};

// Those that answers tell and nobody asks for.
inline constexpr std::array<Choice, 6> stages{{{"flat ground", ABUT_ALGORITHM_FLAT_GROUND},
                                               {"separating translation", ABUT_ALGORITHM_SEPARATING_TRANSLATION},
                                               {"solid", ABUT_ALGORITHM_SOLID},
                                               {"field", ABUT_ALGORITHM_FIELD},
                                               {"hole", ABUT_ALGORITHM_HOLE},
                                               {"rims", ABUT_ALGORITHM_RIMS}}};

[[nodiscard]] inline std::string algorithm_name(abut_algorithm algorithm) {
  return std::string(algorithm < algorithms.size() ? algorithms[algorithm].name
                                                   : stages.at(algorithm - algorithms.size()).name);
}

}  // namespace cli
