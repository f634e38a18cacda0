// SPDX-License-Identifier: Apache-2.0
// Names that a scene gives to numbers: layers, exclusions, labels, tags and materials.
#pragma once

#include <map>
#include <string>

#include "node.hpp"

namespace cli {

class Names {
 public:
  /// `what` is singular, for messages; numbers go up to `most`.
  Names(std::string what, std::uint32_t most) : what_(std::move(what)), most_(most) {}

  /// Reads {"name": number, ...}.
  void read(const std::optional<Node>& node);

  /// The number that a name or a number stands for.
  [[nodiscard]] std::uint32_t number(const Node& node) const;

  /// A set of bits from a list of names and numbers below 64, or "all".
  [[nodiscard]] std::uint64_t bits(const Node& node) const;

  /// The first name of a number in alphabetical order, else its digits.
  [[nodiscard]] std::string name_of(std::uint32_t number) const;

 private:
  std::string what_;
  std::uint32_t most_;
  std::map<std::string, std::uint32_t> numbers_;
  std::map<std::uint32_t, std::string> names_;
};

}  // namespace cli
