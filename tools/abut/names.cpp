// SPDX-License-Identifier: Apache-2.0
#include "names.hpp"

#include <nlohmann/json.hpp>

#include "nearest.hpp"

namespace cli {

void Names::read(const std::optional<Node>& node) {
  if (!node) {
    return;
  }
  for (const auto& [name, value] : node->entries("names of " + what_ + "s, each with a number")) {
    const std::uint32_t number = value.whole32(0, most_);
    numbers_.emplace(name, number);
    names_.emplace(number, name);
  }
}

std::uint32_t Names::number(const Node& node) const {
  if (!node.is_text()) {
    if (!node.json().is_number_unsigned() || node.json().get<std::uint64_t>() > most_) {
      node.refuse("a " + what_ + ": a name, or a whole number from 0 to " + std::to_string(most_));
    }
    return node.whole32(0, most_);
  }
  const auto found = numbers_.find(node.text());
  if (found == numbers_.end()) {
    std::vector<std::string> known;
    for (const auto& [name, number] : numbers_) {
      known.push_back(name);
    }
    node.refuse("the name of a " + what_ + " that the scene declares" +
                (known.empty() ? "; it declares none" : ": " + listing(known) + suggestion(node.text(), known)));
  }
  return found->second;
}

std::uint64_t Names::bits(const Node& node) const {
  if (node.is_text() && node.text() == "all") {
    return UINT64_MAX;
  }
  if (!node.is_list()) {
    node.refuse("a list of " + what_ + "s, by name or number, or \"all\"");
  }
  std::uint64_t bits = 0;
  for (const Node& element : node.list(what_ + "s")) {
    bits |= std::uint64_t{1} << number(element);
  }
  return bits;
}

std::string Names::name_of(std::uint32_t number) const {
  const auto found = names_.find(number);
  return found == names_.end() ? std::to_string(number) : found->second;
}

}  // namespace cli
