// SPDX-License-Identifier: Apache-2.0
#include "node.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include <nlohmann/json.hpp>

#include "nearest.hpp"

namespace cli {
namespace {

// A value on one line, cut to what a message can hold.
std::string shown(const Json& value) {
  constexpr std::size_t most = 60;
  std::string text = value.dump(-1, ' ', true);  // ASCII, so that it can be cut anywhere
  if (text.size() > most) {
    text = text.substr(0, most - 3) + "...";
  }
  return text;
}

bool is_word(const std::string& name) {
  const auto belongs = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  return !name.empty() && std::all_of(name.begin(), name.end(), belongs);
}

}  // namespace

void Node::refuse(const std::string& expected) const {
  const std::string where = path_.empty() ? "the scene" : path_;
  throw BadInput(where + " is " + shown(*value_) + "; expected " + expected);
}

void Node::check(abut_status status) const {
  if (status != ABUT_OK && blames_input(status)) {
    throw BadInput(path_ + " is " + shown(*value_) + "; the library says: " + abut_last_error_message());
  }
  tools::check(status, path_.c_str());
}

bool Node::is_text() const { return value_->is_string(); }
bool Node::is_list() const { return value_->is_array(); }
bool Node::is_object() const { return value_->is_object(); }
std::size_t Node::size() const { return value_->size(); }
bool Node::has(const std::string& field) const { return value_->contains(field); }

double Node::number() const {
  if (!value_->is_number()) {
    refuse("a number");
  }
  return value_->get<double>();
}

double Node::positive() const {
  const double value = value_->is_number() ? number() : 0.0;
  if (value <= 0.0) {
    refuse("a number above 0");
  }
  return value;
}

double Node::not_negative() const {
  const double value = value_->is_number() ? number() : -1.0;
  if (value < 0.0) {
    refuse("a number that is not negative");
  }
  return value;
}

std::uint64_t Node::whole(std::uint64_t low, std::uint64_t high) const {
  // The parser reads whole numbers that are not negative as unsigned ones.
  if (!value_->is_number_unsigned() || value_->get<std::uint64_t>() < low || value_->get<std::uint64_t>() > high) {
    refuse("a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  }
  return value_->get<std::uint64_t>();
}

std::uint32_t Node::whole32(std::uint32_t low, std::uint32_t high) const {
  return static_cast<std::uint32_t>(whole(low, high));
}

bool Node::flag() const {
  if (!value_->is_boolean()) {
    refuse("true or false");
  }
  return value_->get<bool>();
}

const std::string& Node::text() const {
  if (!value_->is_string()) {
    refuse("a text");
  }
  return value_->get_ref<const std::string&>();
}

const std::string& Node::name() const {
  const auto is_bad = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '[' || c == ']' || c == '/'; };
  if (!is_text() || text().empty() || std::any_of(text().begin(), text().end(), is_bad)) {
    refuse("a name: a text without [, ] and /");
  }
  return text();
}

abut_vec3 Node::vector() const {
  const auto is_number = [](const Json& element) { return element.is_number(); };
  if (!is_list() || value_->size() != 3 || !std::all_of(value_->begin(), value_->end(), is_number)) {
    refuse("three numbers, [x, y, z]");
  }
  return {value_->at(0).get<double>(), value_->at(1).get<double>(), value_->at(2).get<double>()};
}

abut_vec3 Node::direction() const {
  const abut_vec3 value = vector();
  if (const double size = length(value); !(size > 0.0) || !std::isfinite(size)) {
    refuse("a direction: three numbers whose length is neither 0 nor beyond what a number can hold");
  }
  return value;
}

std::uint32_t Node::choice(std::span<const Choice> choices) const {
  if (is_text()) {
    const auto found = std::find_if(choices.begin(), choices.end(), [&](const Choice& c) { return c.name == text(); });
    if (found != choices.end()) {
      return found->value;
    }
  }
  std::vector<std::string> names;
  for (const Choice& choice : choices) {
    names.emplace_back(choice.name);
  }
  refuse(listed(choices) + (is_text() ? suggestion(text(), names) : ""));
}

std::vector<Node> Node::list(std::string_view of_what) const {
  if (!is_list()) {
    refuse("a list of " + std::string(of_what));
  }
  std::vector<Node> nodes;
  nodes.reserve(value_->size());
  for (const Json& element : *value_) {
    nodes.emplace_back(element, path_ + "[" + std::to_string(nodes.size()) + "]");
  }
  return nodes;
}

NamedNodes Node::entries(std::string_view of_what) const {
  if (!is_object()) {
    refuse("an object: " + std::string(of_what));
  }
  NamedNodes nodes;
  for (const auto& [name, element] : value_->items()) {
    if (name != "comment") {
      nodes.emplace_back(name, field(name));
    }
  }
  return nodes;
}

Node Node::field(const std::string& name) const {
  std::string path = is_word(name) ? path_ + (path_.empty() ? "" : ".") + name : path_ + "[" + Json(name).dump() + "]";
  return {value_->at(name), std::move(path)};
}

Fields::Fields(const Node& node) : node_(node) {
  if (!node.is_object()) {
    node.refuse("an object, {...}");
  }
}

std::optional<Node> Fields::find(const std::string& name) {
  asked_.insert(name);
  if (!node_.json().contains(name)) {
    return std::nullopt;
  }
  return node_.field(name);
}

Node Fields::need(const std::string& name) {
  std::optional<Node> node = find(name);
  if (!node) {
    std::vector<std::string> others;
    for (const auto& [other, value] : node_.json().items()) {
      if (!asked_.contains(other)) {
        others.push_back(other);
      }
    }
    const std::optional<std::string> misspelt = nearest(name, others);
    node_.refuse("a field \"" + name + "\" in it" +
                 (misspelt ? "; is '" + printable(*misspelt) + "' meant to be it?" : ""));
  }
  return *node;
}

void Fields::done() const {
  for (const auto& [name, value] : node_.json().items()) {
    if (!asked_.contains(name)) {
      const std::vector<std::string> known(asked_.begin(), asked_.end());
      node_.field(name).refuse("no field of this name" + what_there_is("field", name, known));
    }
  }
}

std::string printable(std::string text) {
  std::replace_if(text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

std::string listed(std::span<const Choice> choices) {
  std::string text;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const bool last = i + 1 == choices.size();
    text += (i == 0 ? "\"" : last ? " or \"" : ", \"") + std::string(choices[i].name) + "\"";
  }
  return text;
}

}  // namespace cli
