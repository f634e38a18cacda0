// SPDX-License-Identifier: Apache-2.0
// Rules, which say who meets whom, policies, which say how, and the focus, which says where with more care.
#pragma once

#include "part_reader.hpp"

namespace cli {

void read_rules(const std::optional<Node>& node, const PartRanges& ranges, Scene& scene);

void read_policies(const std::optional<Node>& node, Scene& scene);

void read_focus(const std::optional<Node>& node, Scene& scene);

}  // namespace cli
