// SPDX-License-Identifier: Apache-2.0
#include "pairs.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "digits.hpp"
#include "encounter.hpp"
#include "output_file.hpp"

namespace cli {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text + "  ";
}

// Columns as wide as their widest text; the last one is as wide as it is.
std::string table_of(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const std::vector<std::string>& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  std::string text;
  for (const std::vector<std::string>& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += padded(row[i], widths[i]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

bool answers(abut_shape_kind a, abut_shape_kind b, abut_query query) {
  std::uint32_t supported = 0;
  check(abut_pair_support(a, b, query, &supported), "cannot ask what two kinds answer");
  return supported != 0;
}

std::string kinds_text() {
  const std::size_t count = abut_shape_kind_count();
  std::vector<std::vector<std::string>> rows{{""}};
  for (std::size_t i = 0; i < count; ++i) {
    const abut_shape_kind kind = abut_shape_kind_at(i);
    rows.front().push_back(std::to_string(i + 1));
    std::vector<std::string> row{std::to_string(i + 1) + " " + abut_shape_kind_name(kind)};
    for (std::size_t j = 0; j < count; ++j) {
      row.emplace_back(answers(kind, abut_shape_kind_at(j), ABUT_QUERY_CONTACTS) ? "x" : "-");
    }
    rows.push_back(std::move(row));
  }
  return table_of(rows) +
         "x: they have distances and contacts; -: they never meet. Columns are numbered as rows are.\n"
         "docs/pairs.md tells how each pair is answered.\n";
}

OrderedJson kinds_json() {
  OrderedJson json = OrderedJson::array();
  for (std::size_t i = 0; i < abut_shape_kind_count(); ++i) {
    for (std::size_t j = i; j < abut_shape_kind_count(); ++j) {
      const abut_shape_kind a = abut_shape_kind_at(i), b = abut_shape_kind_at(j);
      json.push_back({{"a", abut_shape_kind_name(a)},
                      {"b", abut_shape_kind_name(b)},
                      {"distance", answers(a, b, ABUT_QUERY_DISTANCE)},
                      {"contacts", answers(a, b, ABUT_QUERY_CONTACTS)}});
    }
  }
  return json;
}

std::string text_of(const std::vector<Encounter>& encounters, std::uint64_t step) {
  std::vector<std::vector<std::string>> rows{{"a", "b", "touch", "contacts", "distance", "what keeps them apart"}};
  std::size_t touching = 0;
  for (const Encounter& its : encounters) {
    touching += its.touches ? 1 : 0;
    rows.push_back({shown(its.a), shown(its.b), its.touches ? "yes" : "no",
                    its.elements > 0 ? std::to_string(its.elements) + " elements" : std::to_string(its.contacts),
                    its.distance ? digits(its.distance->distance) : "none", its.stopped_by});
  }
  return table_of(rows) + std::to_string(encounters.size()) + " pairs of boxes overlap at step " +
         std::to_string(step) + "; " + std::to_string(touching) + " of them touch\n";
}

OrderedJson json_of(const std::vector<Encounter>& encounters) {
  OrderedJson json = OrderedJson::array();
  for (const Encounter& its : encounters) {
    OrderedJson row{{"a", its.a.name},
                    {"kind_a", kind_name(its.a.shape)},
                    {"b", its.b.name},
                    {"kind_b", kind_name(its.b.shape)},
                    {"touch", its.touches},
                    {"contacts", its.contacts},
                    {"element_contacts", its.elements},
                    {"distance", nullptr},
                    {"stopped_by", nullptr}};
    if (its.distance) {
      row["distance"] = its.distance->distance;
    }
    if (!its.touches) {
      row["stopped_by"] = its.stopped_by;
    }
    json.push_back(std::move(row));
  }
  return json;
}

}  // namespace

void list_pairs(const Arguments& arguments) {
  if (arguments.operands.empty()) {
    print(arguments.json ? kinds_json().dump(2) + "\n" : kinds_text());
    return;
  }
  const World world = world_at_last_step(arguments);
  const Encounters encounters(world);
  std::vector<Encounter> all;
  for (const auto& [a, b] : encounters.near()) {
    all.push_back(encounters.between(a, b));
  }
  print(arguments.json ? json_of(all).dump(2) + "\n" : text_of(all, world.scene().steps));
}

}  // namespace cli
