// Rules, which say who meets whom, and policies, which say how.
#pragma once

#include "part_reader.hpp"

namespace cli {

void read_rules(const std::optional<Node>& node, const PartRanges& ranges, Scene& scene);

void read_policies(const std::optional<Node>& node, Scene& scene);

}  // namespace cli
