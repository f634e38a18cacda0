// SPDX-License-Identifier: Apache-2.0
// Error against run time: signed distances of abut, Bullet, FCL and libccd beside the float128 oracle of the tests,
// under conditions from ordinary to extreme.
#include <array>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "accuracy_file.hpp"
#include "accuracy_parts.hpp"
#include "accuracy_rows.hpp"
#include "accuracy_scenes.hpp"
#include "accuracy_tables.hpp"
#include "agreement.hpp"
#include "flags.hpp"

namespace bench {
namespace {

constexpr std::array kinds{Kind::sphere, Kind::capsule,   Kind::box,    Kind::cylinder,
                           Kind::cone,   Kind::ellipsoid, Kind::hull32, Kind::hull200};

// Bodies that stand on shapes of many parts.
constexpr std::array bodies{Kind::sphere, Kind::capsule, Kind::box, Kind::cylinder, Kind::hull32};
constexpr std::array all_queries{Query::distance, Query::depth, Query::contacts, Query::overlap,
                                 Query::cast,     Query::ray,   Query::impact};

constexpr const char* usage = R"(usage: abut_bench_accuracy [--out FOLDER] [--cases N] [--repetitions N] [--only TEXT]

Prints tables of time and error, and writes accuracy.csv.
  --out FOLDER      where accuracy.csv goes (out/accuracy)
  --cases N         placed pairs for each pair of kinds, question and condition (32)
  --repetitions N   of each timing (5)
  --only TEXT       only what has this in its name, such as depth/ordinary/box-hull32
  --without TEXT    not what has this in its name
  --json FILE       also writes all rows there, each with the pair that was worst
)";

struct Flags {
  std::filesystem::path out = "out/accuracy";
  std::size_t cases = 32, repetitions = 5;
  std::string only, without;
  std::filesystem::path json;
};

Flags flags_from(const std::vector<std::string>& words) {
  Flags flags;
  for (const auto& [name, value] : flags_of(words, usage)) {
    if (name == "--out" && !value.empty()) {
      flags.out = value;
    } else if (name == "--cases") {
      flags.cases = count_of(name, value);
    } else if (name == "--repetitions") {
      flags.repetitions = count_of(name, value);
    } else if (name == "--only") {
      flags.only = value;
    } else if (name == "--without" && !value.empty()) {
      flags.without = value;
    } else if (name == "--json" && !value.empty()) {
      flags.json = value;
    } else {
      refuse(name, usage);
    }
  }
  return flags;
}

struct Written {
  std::vector<Row> rows;
  RowFile file;
};

void ask(const Flags& flags, Query query, Condition condition, const std::string& pair, const JudgedCell& cell,
         Written& written) {
  for (Row& row : measured(query, cell, flags.repetitions, all_entrants())) {
    row.condition = condition;
    row.pair = pair;
    written.file.add({{"condition", condition_name(condition)}, {"pair", pair}}, row, cell);
    written.rows.push_back(std::move(row));
  }
}

bool is_asked(const Flags& flags, Query query, Condition condition, const std::string& pair) {
  const std::string name = std::string(query_name(query)) + "/" + std::string(condition_name(condition)) + "/" + pair;
  const bool is_left_out = !flags.without.empty() && name.find(flags.without) != std::string::npos;
  return name.find(flags.only) != std::string::npos && !is_left_out;
}

std::string pair_name(Query query, Kind a, Kind b) {
  const std::string first(kind_name(a));
  return query == Query::ray ? first : first + "-" + std::string(kind_name(b));
}

void add_rows(const Flags& flags, Query query, Condition condition, AccuracyScenes& scenes, Written& written) {
  for (std::size_t b = 0; b < kinds.size(); ++b) {
    const std::size_t first = query == Query::ray ? b : 0;
    for (std::size_t a = first; a <= b; ++a) {
      const Kind kind_b = query == Query::ray ? Kind::point : kinds[b];
      const std::string pair = pair_name(query, kinds[a], kind_b);
      if (!is_asked(flags, query, condition, pair)) {
        continue;
      }
      // The deepest contact of a pair is as deep as the pair.
      const Query judged = query == Query::contacts ? Query::depth : query;
      if (const auto cell = scenes.make(judged, condition, kinds[a], kind_b, flags.cases)) {
        ask(flags, query, condition, pair, *cell, written);
      }
    }
  }
}

void add_rows_of_parts(const Flags& flags, Query query, PartScenes& scenes, Written& written) {
  for (const Kind a : kinds_of_parts) {
    constexpr std::array points{Kind::point};
    for (const Kind b : query == Query::ray ? std::span<const Kind>(points) : bodies) {
      const std::string pair = pair_name(query, a, b);
      if (!is_asked(flags, query, Condition::ordinary, pair)) {
        continue;
      }
      if (const auto cell = scenes.make(query, a, b, flags.cases)) {
        ask(flags, query, Condition::ordinary, pair, *cell, written);
      }
    }
  }
}

void run(const Flags& flags) {
  std::filesystem::create_directories(flags.out);
  AccuracyScenes scenes;
  Written written;
  PartScenes of_parts;
  for (const Query query : all_queries) {
    for (const Condition condition : all_conditions) {
      std::fprintf(stderr, "%s, %s\n", std::string(query_name(query)).c_str(),
                   std::string(condition_title(condition)).c_str());
      add_rows(flags, query, condition, scenes, written);
    }
    std::fprintf(stderr, "%s, shapes of many parts\n", std::string(query_name(query)).c_str());
    add_rows_of_parts(flags, query, of_parts, written);
  }
  const std::vector<Row>& rows = written.rows;
  if (rows.empty()) {
    throw std::runtime_error("--only is '" + flags.only + "'; nothing that is asked has it in its name");
  }
  print_tables(rows);
  print_prices(rows);
  write_rows(flags.out / "accuracy.csv", rows);
  if (!flags.json.empty()) {
    written.file.write(flags.json, {{"cases", flags.cases}, {"repetitions", flags.repetitions}});
  }
}

}  // namespace
}  // namespace bench

int main(int count, char** words) {
  return bench::main_of(count, words, bench::usage,
                        [](const std::vector<std::string>& given) { bench::run(bench::flags_from(given)); });
}
