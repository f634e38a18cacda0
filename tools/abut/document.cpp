// SPDX-License-Identifier: Apache-2.0
#include "document.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>

#include <nlohmann/json.hpp>

namespace cli {
namespace {

// Line and column of the last of so many characters.
std::string place_of(const std::string& text, std::size_t position) {
  const std::string before = text.substr(0, position > 0 ? position - 1 : 0);
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n') == std::string::npos ? 0 : before.rfind('\n') + 1;
  return "line " + std::to_string(lines + 1) + ", column " + std::to_string(before.size() - line_start + 1);
}

// What is left of a message without the number of the exception and its own way to tell the place.
std::string reason_of(const std::string& message) {
  const std::size_t name_end = message.find("] ");
  const std::string bare = name_end == std::string::npos ? message : message.substr(name_end + 2);
  const std::size_t place_end = bare.find(": ");
  return bare.starts_with("parse error") && place_end != std::string::npos ? bare.substr(place_end + 2) : bare;
}

// Builds the document from the events of the parser.
class Builder : public nlohmann::json_sax<Json> {
 public:
  explicit Builder(const std::string& text) : text_(text) {}

  [[nodiscard]] Json take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(std::int64_t value) override { return add(value); }
  bool number_unsigned(std::uint64_t value) override { return add(value); }
  bool number_float(double value, const std::string& /*digits*/) override { return add(value); }
  bool string(std::string& value) override { return add(std::move(value)); }
  bool binary(Json::binary_t& /*value*/) override { return false; }  // JSON has none
  bool start_object(std::size_t /*size*/) override { return open(Json::object()); }
  bool start_array(std::size_t /*size*/) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(std::string& name) override {
    Level& level = levels_.back();
    if (level.value.contains(name)) {
      throw BadInput(path() + " has the name " + Json(name).dump() + " twice; expected each once");
    }
    level.name = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::detail::exception& exception) override {
    throw BadInput(place_of(text_, position) + ": " + printable(reason_of(exception.what())));
  }

 private:
  struct Level {
    Json value;
    std::string name;  // of the field that is being read
  };

  // The way to the object or list that is being read.
  [[nodiscard]] std::string path() const {
    std::string path;
    for (std::size_t i = 0; i + 1 < levels_.size(); ++i) {
      const Level& level = levels_[i];
      path += level.value.is_array() ? "[" + std::to_string(level.value.size()) + "]" : (i > 0 ? "." : "") + level.name;
    }
    return path.empty() ? "the scene" : path;
  }

  bool add(Json value) {
    if (levels_.empty()) {
      root_ = std::move(value);
    } else if (Level& level = levels_.back(); level.value.is_array()) {
      level.value.push_back(std::move(value));
    } else {
      level.value[level.name] = std::move(value);
    }
    return true;
  }

  bool open(Json value) {
    constexpr std::size_t most = 64;
    if (levels_.size() == most) {
      throw BadInput(path() + " is nested too deep; expected at most " + std::to_string(most) + " levels");
    }
    levels_.push_back({std::move(value), ""});
    return true;
  }

  bool close() {
    Json value = std::move(levels_.back().value);
    levels_.pop_back();
    return add(std::move(value));
  }

  const std::string& text_;
  Json root_;
  std::vector<Level> levels_;
};

}  // namespace

std::string shown_name(const std::filesystem::path& path) { return path == "-" ? "the standard input" : path.string(); }

Json read_document(const std::filesystem::path& path) {
  if (path == "-") {
    return read_text({std::istreambuf_iterator<char>(std::cin), {}});
  }
  std::ifstream in(path, std::ios::binary);
  if (!in || std::filesystem::is_directory(path)) {
    throw BadInput("cannot be opened; expected a file with a scene");
  }
  return read_text({std::istreambuf_iterator<char>(in), {}});
}

Json read_text(const std::string& text) {
  Builder builder(text);
  Json::sax_parse(text, &builder);
  return builder.take();
}

}  // namespace cli
