// SPDX-License-Identifier: Apache-2.0
#include "response_file.hpp"

#include <fstream>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

namespace bench {

void write_table(const std::filesystem::path& path, const std::vector<Measured>& all) {
  std::ofstream file(path);
  file.precision(6);
  file << "trial,engine,effort,milliseconds_a_step,error,error_is\n";
  for (const Measured& row : all) {
    file << row.trial << ',' << row.engine << ',' << row.effort << ',' << row.milliseconds << ',' << row.error << ",\""
         << row.error_name << "\"\n";
  }
  if (!file) throw std::runtime_error("cannot write " + path.string());
}

void write_json(const std::filesystem::path& path, const std::vector<Measured>& all) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Measured& row : all) {
    nlohmann::ordered_json course = nlohmann::ordered_json::array();
    for (const auto& [time, error] : row.course) course.push_back({time, error});
    rows.push_back({{"trial", row.trial},
                    {"error_is", row.error_name},
                    {"contender", row.engine},
                    {"effort", row.effort},
                    {"milliseconds", row.milliseconds},
                    {"error", row.error},
                    {"course", std::move(course)}});
  }
  std::ofstream file(path);
  file << nlohmann::ordered_json{{"rows", std::move(rows)}}.dump() << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace bench
