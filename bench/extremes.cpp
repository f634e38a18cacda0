// SPDX-License-Identifier: Apache-2.0
// Worst error and failures of abut and its peers where pairs are hard, place by place of a map. The judge is the
// float128 oracle of the tests.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "accuracy_file.hpp"
#include "accuracy_rows.hpp"
#include "extremes_scenes.hpp"
#include "flags.hpp"

namespace bench {
namespace {

constexpr const char* usage = R"(usage: abut_bench_extremes --json FILE [--cases N] [--every N] [--only TEXT]

Writes the worst errors and the failures of each place of each map.
  --cases N     placed pairs for each place (8)
  --every N     every Nth place of each axis, from its easy end on (1)
  --only TEXT   only maps with this in their name, such as parallel
)";

struct Settings {
  std::size_t cases = 8, every = 1;
  std::string only;
};

using Make = std::function<std::optional<JudgedCell>(Query query)>;

constexpr std::array kinds{TwoKinds{Kind::box, Kind::box},        TwoKinds{Kind::capsule, Kind::box},
                           TwoKinds{Kind::hull32, Kind::hull32},  TwoKinds{Kind::cylinder, Kind::box},
                           TwoKinds{Kind::capsule, Kind::hull32}, TwoKinds{Kind::capsule, Kind::capsule}};
constexpr std::array bodies{Kind::sphere, Kind::box, Kind::capsule, Kind::hull32};
constexpr std::array<std::string_view, 9> asked{"abut",       "abut gjk_epa", "bullet", "fcl", "libccd_gjk",
                                                "libccd_mpr", "box3d",        "jolt",   "coal"};
constexpr std::array<std::string_view, 7> asked_on_floors{"abut", "bullet", "fcl", "ode", "box3d", "jolt", "coal"};

class Maps {
 public:
  explicit Maps(const Settings& settings) : settings_(settings) {}

  void run() {
    proportions();
    along("distance from the origin", 0, 12,
          [](Query query, TwoKinds two, double x, std::size_t count) { return far_away(query, two, x, count); });
    along("angle from parallel", 0, -16,
          [](Query query, TwoKinds two, double x, std::size_t count) { return nearly_parallel(query, two, x, count); });
    along("gap or depth", -1, -16,
          [](Query query, TwoKinds two, double x, std::size_t count) { return nearly_touching(query, two, x, count); });
    floors();
  }

  void write(const std::filesystem::path& path) const {
    file_.write(path, {{"cases", settings_.cases}, {"every", settings_.every}});
  }

 private:
  [[nodiscard]] bool is_asked(std::string_view map) const {
    const bool is = map.find(settings_.only) != std::string_view::npos;
    if (is) {
      std::fprintf(stderr, "%s\n", std::string(map).c_str());
    }
    return is;
  }

  void place(const RowFile::Json& labels, const Make& make) {
    for (const Query query : {Query::distance, Query::depth}) {
      if (const std::optional<JudgedCell> cell = make(query)) {
        for (const Row& row : measured(query, *cell, 1, entrants_of(asked))) {
          file_.add(labels, row, *cell);
        }
      }
    }
  }

  [[nodiscard]] std::vector<double> powers(int from, int to) const {
    std::vector<double> list;
    const int step = (from < to ? 1 : -1) * static_cast<int>(settings_.every);
    for (int i = from; from < to ? i <= to : i >= to; i += step) {
      list.push_back(std::pow(10, i));
    }
    return list;
  }

  void proportions() {
    constexpr std::string_view name = "size ratio and aspect";
    if (!is_asked(name)) {
      return;
    }
    for (const double aspect : powers(0, 9)) {
      for (const double ratio : powers(0, 12)) {
        place({{"map", name}, {"x", ratio}, {"y", aspect}}, [&](Query query) {
          return out_of_proportion(query, {Kind::box, Kind::box}, ratio, aspect, settings_.cases);
        });
      }
    }
  }

  void along(std::string_view name, int from, int to,
             const std::function<std::optional<JudgedCell>(Query, TwoKinds, double, std::size_t)>& make) {
    if (!is_asked(name)) {
      return;
    }
    for (const TwoKinds two : kinds) {
      for (const double x : powers(from, to)) {
        place({{"map", name}, {"x", x}, {"y", two.name()}},
              [&](Query query) { return make(query, two, x, settings_.cases); });
      }
    }
  }

  void floors() {
    constexpr std::string_view name = "triangles of a flat floor";
    if (!is_asked(name)) {
      return;
    }
    const std::size_t most = settings_.every > 1 ? 20'000 : 1'000'000;
    for (std::size_t triangles = 1; triangles <= most;
         triangles = triangles == 1 ? 2 : triangles * 4 * settings_.every) {
      for (const Kind kind : bodies) {
        const JudgedCell cell = on_a_floor(kind, triangles, settings_.cases);
        for (const Row& row : measured(Query::contacts, cell, 1, entrants_of(asked_on_floors))) {
          file_.add({{"map", name}, {"x", cell.solids_a.front().triangles.size()}, {"y", kind_name(kind)}}, row, cell);
        }
      }
    }
  }

  Settings settings_;
  RowFile file_;
};

void run(const std::vector<std::string>& words) {
  Settings settings;
  std::filesystem::path json;
  for (const auto& [name, value] : flags_of(words, usage)) {
    if (name == "--json") {
      json = value;
    } else if (name == "--cases") {
      settings.cases = count_of(name, value);
    } else if (name == "--every") {
      settings.every = count_of(name, value);
    } else if (name == "--only") {
      settings.only = value;
    } else {
      refuse(name, usage);
    }
  }
  if (json.empty()) {
    throw std::runtime_error(std::string("--json is missing\n") + usage);
  }
  Maps maps(settings);
  maps.run();
  maps.write(json);
}

}  // namespace
}  // namespace bench

int main(int count, char** words) { return bench::main_of(count, words, bench::usage, bench::run); }
