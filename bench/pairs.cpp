// SPDX-License-Identifier: Apache-2.0
// Pairs of shapes: abut beside Bullet, FCL, ODE and libccd on the same placed pairs, one thread, no caches
// kept from call to call.
#include "pairs.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "agreement.hpp"
#include "random_pairs.hpp"
#include "ratios.hpp"

namespace bench {
namespace {

constexpr std::size_t case_count = 512;
constexpr std::size_t solid_count = 8;
// Cases nearer to touching than this are left out: the libraries may disagree on which side they lie.
constexpr double least_gap = 0.01;
// A library that is far off in more than this part of a cell answers another question there.
constexpr double most_unlike = 0.05;
constexpr std::array kinds{Kind::sphere, Kind::capsule,   Kind::box,    Kind::cylinder,
                           Kind::cone,   Kind::ellipsoid, Kind::hull32, Kind::hull200};

// The first one is what the others are compared with.
constexpr std::array makers{Maker{"abut", make_abut},
                            Maker{"abut-c", make_abut_c},
                            Maker{"abut-c-warm", make_abut_c_warm},
                            Maker{"bullet", make_bullet},
                            Maker{"fcl", make_fcl},
                            Maker{"ode", make_ode},
                            Maker{"libccd-gjk", make_libccd_gjk},
                            Maker{"libccd-mpr", make_libccd_mpr},
                            Maker{"abut-ccd-gjk", make_abut_ccd_gjk},
                            Maker{"abut-ccd-mpr", make_abut_ccd_mpr}};

std::string full_name(Query query, const std::string& scene, const Maker& maker) {
  return std::string(query_name(query)) + "/" + scene + "/" + std::string(maker.name);
}

struct Scene {
  std::string name;
  std::vector<Solid> solids_a, solids_b;
  std::vector<Case> separated, overlapping, mixed;

  [[nodiscard]] Cell cell(Query query) const {
    return {solids_a, solids_b, query == Query::depth ? overlapping : query == Query::contacts ? mixed : separated};
  }
};

std::string scene_name(Kind a, Kind b) { return std::string(kind_name(a)) + "-" + std::string(kind_name(b)); }

Scene make_scene(Kind kind_a, Kind kind_b) {
  // A seed of its own for each pair, so that a scene does not depend on which others are made.
  Random random(1 + 16 * static_cast<std::uint64_t>(kind_a) + static_cast<std::uint64_t>(kind_b));
  Scene scene{scene_name(kind_a, kind_b),
              random_solids(kind_a, solid_count, random),
              random_solids(kind_b, solid_count, random),
              {},
              {},
              {}};
  while (std::min(scene.separated.size(), scene.overlapping.size()) < case_count) {
    std::vector<Case> tried;
    while (tried.size() < case_count) {
      tried.push_back(random_case(scene.solids_a, scene.solids_b, random));
    }
    std::vector<Answer> answers(case_count);
    make_abut(Query::depth, {scene.solids_a, scene.solids_b, tried})->answer(answers);
    for (std::size_t i = 0; i < case_count; ++i) {
      if (answers[i].distance > least_gap && scene.separated.size() < case_count) {
        scene.separated.push_back(tried[i]);
      } else if (answers[i].distance < -least_gap && scene.overlapping.size() < case_count) {
        scene.overlapping.push_back(tried[i]);
      }
    }
  }
  Random moves(7 + 16 * static_cast<std::uint64_t>(kind_a) + static_cast<std::uint64_t>(kind_b));
  for (Case& one : scene.separated) {
    give_motion(one, bounding_radius(scene.solids_a[one.a]) + bounding_radius(scene.solids_b[one.b]), moves);
  }
  // As many of one as of the other, in no order.
  for (std::size_t i = 0; i < case_count / 2; ++i) {
    scene.mixed.push_back(scene.separated[i]);
    scene.mixed.push_back(scene.overlapping[i]);
  }
  for (std::size_t i = case_count - 1; i > 0; --i) {
    std::swap(scene.mixed[i], scene.mixed[random.below(i + 1)]);
  }
  return scene;
}

class Suite {
 public:
  void add(Query query, const Scene& scene) {
    const Cell cell = scene.cell(query);
    std::vector<Answer> expected;
    for (const Maker& maker : makers) {
      const std::string name = full_name(query, scene.name, maker);
      if (!is_selected(name)) {
        continue;
      }
      std::unique_ptr<Contender> made = maker.make(query, cell);
      if (!made) {
        continue;
      }
      Contender& contender = *contenders_.emplace_back(std::move(made));
      std::vector<Answer> answers(cell.cases.size());
      contender.answer(answers);
      if (expected.empty()) {
        expected = answers;
      }
      if (agreements_.compare(query, maker.name, scene.name, 1, expected, answers) > most_unlike) {
        unlike_.insert(name);
      }
      if (query == Query::contacts) {
        for (const Answer& answer : answers) {
          points_[scene.name][std::string(maker.name)] += answer.points;
        }
      }
      benchmark::RegisterBenchmark(name.c_str(), [&contender, count = cell.cases.size()](benchmark::State& state) {
        std::vector<Answer> timed(count);
        for ([[maybe_unused]] auto _ : state) {
          contender.answer(timed);
          benchmark::DoNotOptimize(timed.data());
          benchmark::ClobberMemory();
        }
      });
    }
  }

  void print() const {
    std::printf("Answers beside those of abut\n");
    agreements_.print();
    print_points();
  }
  [[nodiscard]] const std::set<std::string>& unlike() const { return unlike_; }

 private:
  // "Contact" is not the same work everywhere: how many points there are for an overlapping pair.
  void print_points() const {
    std::printf("\nContact points per overlapping pair\n%-20s", "");
    for (const Maker& maker : makers) {
      std::printf(" %12s", std::string(maker.name).c_str());
    }
    for (const auto& [cell, points] : points_) {
      std::printf("\n%-20s", cell.c_str());
      for (const Maker& maker : makers) {
        const auto found = points.find(std::string(maker.name));
        std::printf(" %12.2f", found == points.end() ? 0 : static_cast<double>(found->second) / (case_count / 2.0));
      }
    }
    std::printf("\n\n");
  }

  std::vector<std::unique_ptr<Contender>> contenders_;
  Agreements agreements_;
  std::set<std::string> unlike_;
  std::map<std::string, std::map<std::string, std::size_t>> points_;
};

// Whether any query of a pair of kinds is asked for.
bool is_wanted(const std::string& scene_name, std::span<const Query> queries) {
  for (const Query query : queries) {
    for (const Maker& maker : makers) {
      if (is_selected(full_name(query, scene_name, maker))) {
        return true;
      }
    }
  }
  return false;
}

std::vector<Scene> make_scenes(std::span<const std::pair<Kind, Kind>> pairs, std::span<const Query> queries) {
  std::vector<Scene> scenes;
  for (const auto& [a, b] : pairs) {
    if (is_wanted(scene_name(a, b), queries)) {
      scenes.push_back(make_scene(a, b));
    }
  }
  return scenes;
}

int run() {
  std::vector<std::pair<Kind, Kind>> bounded, with_plane, with_surface;
  for (std::size_t b = 0; b < kinds.size(); ++b) {
    for (std::size_t a = 0; a <= b; ++a) {
      bounded.emplace_back(kinds[a], kinds[b]);
    }
    with_plane.emplace_back(Kind::plane, kinds[b]);
  }
  for (const Kind surface : {Kind::mesh, Kind::height_field}) {
    for (const Kind b : {Kind::sphere, Kind::capsule, Kind::box, Kind::cylinder, Kind::hull32}) {
      with_surface.emplace_back(surface, b);
    }
  }
  constexpr std::array all_queries{Query::distance, Query::depth, Query::contacts, Query::cast};
  // Closest points to a half-space are a query that the peers do not have.
  constexpr std::array contacts_only{Query::contacts};
  const std::vector<Scene> scenes = make_scenes(bounded, all_queries);
  const std::vector<Scene> planes = make_scenes(with_plane, contacts_only);
  const std::vector<Scene> surfaces = make_scenes(with_surface, contacts_only);

  Suite suite;
  for (const Query query : all_queries) {
    for (const Scene& scene : scenes) {
      suite.add(query, scene);
    }
  }
  for (const std::vector<Scene>& scenes_of_contacts : {planes, surfaces}) {
    for (const Scene& scene : scenes_of_contacts) {
      suite.add(Query::contacts, scene);
    }
  }
  suite.print();
  return run_and_compare({"abut",
                          {"bullet", "fcl", "ode"},
                          {"libccd-gjk", "libccd-mpr", "abut-c", "abut-c-warm", "abut-ccd-gjk", "abut-ccd-mpr"},
                          static_cast<double>(case_count),
                          "ns",
                          1e-9,
                          suite.unlike()});
}

}  // namespace
}  // namespace bench

int main(int argument_count, char** arguments) { return bench::run_suite(argument_count, arguments, bench::run); }
