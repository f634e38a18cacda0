// SPDX-License-Identifier: Apache-2.0
// A place in a scene document: a value and the way to it. Everything that reads a value refuses it in one form:
// where it stands, what it is, what was expected.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "common/vector.hpp"
#include "failures.hpp"

namespace cli {

using Json = nlohmann::json;

/// Names and what they stand for.
struct Choice {
  std::string_view name;
  std::uint32_t value;
};

class Node;
using NamedNodes = std::vector<std::pair<std::string, Node>>;

/// Borrows from the document, which must live longer.
class Node {
 public:
  Node(const Json& value, std::string path) : value_(&value), path_(std::move(path)) {}

  [[nodiscard]] const Json& json() const { return *value_; }
  [[nodiscard]] const std::string& path() const { return path_; }

  /// Throws BadInput: path, value, expectation.
  [[noreturn]] void refuse(const std::string& expected) const;

  /// Refuses the value with the last message of the library, unless the status blames something else.
  void check(abut_status status) const;

  [[nodiscard]] bool is_text() const;
  [[nodiscard]] bool is_list() const;
  [[nodiscard]] bool is_object() const;
  /// Of a list or an object.
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] bool has(const std::string& field) const;

  [[nodiscard]] double number() const;
  [[nodiscard]] double positive() const;
  [[nodiscard]] double not_negative() const;
  [[nodiscard]] std::uint64_t whole(std::uint64_t low, std::uint64_t high) const;
  [[nodiscard]] std::uint32_t whole32(std::uint32_t low, std::uint32_t high = UINT32_MAX) const;
  [[nodiscard]] bool flag() const;
  [[nodiscard]] const std::string& text() const;
  /// A text that can name a part or a geometry: not empty, without brackets, slashes and control characters.
  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] abut_vec3 vector() const;
  /// A vector that is not zero.
  [[nodiscard]] abut_vec3 direction() const;
  [[nodiscard]] std::uint32_t choice(std::span<const Choice> choices) const;

  /// The elements of a list.
  [[nodiscard]] std::vector<Node> list(std::string_view of_what) const;
  /// The fields of an object that may have any names.
  [[nodiscard]] NamedNodes entries(std::string_view of_what) const;
  [[nodiscard]] Node field(const std::string& name) const;

 private:
  const Json* value_;
  std::string path_;
};

/// The fields of an object with a fixed set of names. Those that nobody asked for are refused by `done`; a field
/// "comment" is allowed everywhere.
class Fields {
 public:
  explicit Fields(const Node& node);

  [[nodiscard]] const Node& node() const { return node_; }
  [[nodiscard]] std::optional<Node> find(const std::string& name);
  [[nodiscard]] Node need(const std::string& name);
  void done() const;

 private:
  Node node_;
  std::set<std::string> asked_{"comment"};
};

/// A text from outside with '?' in place of what is not a printable ASCII character.
[[nodiscard]] std::string printable(std::string text);

/// Names of choices, for people: "a, b or c".
[[nodiscard]] std::string listed(std::span<const Choice> choices);

}  // namespace cli
