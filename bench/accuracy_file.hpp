// SPDX-License-Identifier: Apache-2.0
// Rows of errors as JSON, each with the pair on which it was worst, as a scene of the program abut describes it.
#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "accuracy_rows.hpp"
#include "accuracy_scenes.hpp"

namespace bench {

class RowFile {
 public:
  using Json = nlohmann::ordered_json;

  // `labels`: members of the row beside those that each row has.
  void add(const Json& labels, const Row& row, const JudgedCell& cell);
  // `settings`: members of the document beside shapes, pairs and rows.
  void write(const std::filesystem::path& path, const Json& settings) const;

 private:
  std::size_t number_of_pair(const Row& row, const JudgedCell& cell);
  std::size_t number_of(std::map<std::string, std::size_t>& numbers, Json& list, Json value);

  Json shapes_ = Json::array(), pairs_ = Json::array(), rows_ = Json::array();
  std::map<std::string, std::size_t> shape_numbers_, pair_numbers_;
};

}  // namespace bench
