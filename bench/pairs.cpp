// Pairs of shapes: abut beside Bullet, FCL and libccd on the same placed pairs, one thread, no caches
// kept from call to call.
#include "pairs.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ratios.hpp"

namespace bench {
namespace {

constexpr std::size_t case_count = 512;
constexpr std::size_t solid_count = 8;

struct Maker {
  std::string_view name;
  std::unique_ptr<Contender> (*make)(Query query, const Cell& cell);
};
constexpr std::array makers{Maker{"abut", make_abut}, Maker{"bullet", make_bullet}, Maker{"fcl", make_fcl}};

// Cases of a pair of kinds, their solids, and what abut says of them.
struct Scene {
  std::vector<Solid> solids_a, solids_b;
  std::vector<Case> cases;
  [[nodiscard]] Cell cell() const { return {solids_a, solids_b, cases}; }
};

std::vector<Solid> make_solids(Kind kind, Random& random) {
  std::vector<Solid> solids;
  for (std::size_t i = 0; i < solid_count; ++i) {
    solids.push_back(random_solid(kind, random));
    if (is_hull(kind)) {
      find_surface(solids.back());
    }
  }
  return solids;
}

// Cases that overlap or are separated by more than a hundredth of their size. A plane lies at the
// origin in its own frame, so that its partner is placed above it.
Scene make_scene(Kind kind_a, Kind kind_b, bool overlap, std::uint64_t seed) {
  Random random(seed);
  Scene scene{make_solids(kind_a, random), make_solids(kind_b, random), {}};
  while (scene.cases.size() < case_count) {
    Scene tried{scene.solids_a, scene.solids_b, {}};
    for (std::size_t i = 0; i < case_count; ++i) {
      Case one{random.below(solid_count), random.below(solid_count), {}, {}};
      const Point centre{random.uniform(-10, 10), random.uniform(-10, 10), random.uniform(-10, 10)};
      const Point direction = random.direction();
      const double reach = bounding_radius(tried.solids_a[one.a]) + bounding_radius(tried.solids_b[one.b]);
      const double apart = random.uniform(0, 1.5) * reach;
      one.pose_a = {centre, random.orientation()};
      one.pose_b = {{centre[0] + apart * direction[0], centre[1] + apart * direction[1], centre[2] + apart * direction[2]},
                    random.orientation()};
      tried.cases.push_back(one);
    }
    std::vector<Answer> answers(case_count);
    make_abut(Query::depth, tried.cell())->answer(answers);
    for (std::size_t i = 0; i < case_count && scene.cases.size() < case_count; ++i) {
      if (overlap ? answers[i].distance < -0.01 : answers[i].distance > 0.01) {
        scene.cases.push_back(tried.cases[i]);
      }
    }
  }
  return scene;
}

class Suite {
 public:
  void add(Query query, std::string_view query_name, Kind kind_a, Kind kind_b, const Scene& scene) {
    const std::string name =
        std::string(query_name) + "/" + std::string(kind_name(kind_a)) + "-" + std::string(kind_name(kind_b));
    std::vector<Answer> expected;
    for (const Maker& maker : makers) {
      auto contender = std::shared_ptr<Contender>(maker.make(query, scene.cell()));
      if (!contender) {
        continue;
      }
      std::vector<Answer> answers(scene.cases.size());
      contender->answer(answers);
      if (expected.empty()) {
        expected = answers;
      } else {
        print_agreement(name, maker.name, expected, answers);
      }
      for (const Answer& answer : answers) {
        hash_ = (hash_ ^ std::bit_cast<std::uint64_t>(answer.distance)) * 0x100000001b3;
      }
      benchmark::RegisterBenchmark((name + "/" + std::string(maker.name)).c_str(),
                                   [contender, count = scene.cases.size()](benchmark::State& state) {
                                     std::vector<Answer> timed(count);
                                     for ([[maybe_unused]] auto _ : state) {
                                       contender->answer(timed);
                                       benchmark::DoNotOptimize(timed.data());
                                       benchmark::ClobberMemory();
                                     }
                                   });
    }
  }

  void print_hash() const { std::printf("hash of all answers: %016llx\n", static_cast<unsigned long long>(hash_)); }

 private:
  static void print_agreement(const std::string& cell, std::string_view peer, std::span<const Answer> ours,
                              std::span<const Answer> theirs) {
    double worst = 0;
    std::size_t lost = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      if (theirs[i].points == 0 && ours[i].points > 0) {
        ++lost;
      } else {
        worst = std::max(worst, std::fabs(theirs[i].distance - ours[i].distance));
      }
    }
    std::printf("%-28s %-12s differs from abut by up to %.1e, no answer in %zu of %zu\n", cell.c_str(),
                std::string(peer).c_str(), worst, lost, ours.size());
  }

  std::uint64_t hash_ = 0xcbf29ce484222325;
};

int run(int argument_count, char** arguments) {
  Suite suite;
  std::uint64_t seed = 1;
  const std::array<std::pair<Kind, Kind>, 4> pairs{
      {{Kind::box, Kind::box}, {Kind::capsule, Kind::box}, {Kind::hull32, Kind::hull32}, {Kind::hull200, Kind::hull200}}};
  for (const auto& [a, b] : pairs) {
    const Scene separated = make_scene(a, b, false, ++seed);
    suite.add(Query::distance, "distance", a, b, separated);
  }
  suite.print_hash();
  return run_and_compare(argument_count, arguments, {"abut", {"bullet", "fcl"}, {}, static_cast<double>(case_count), "ns", 1e-9});
}

}  // namespace
}  // namespace bench

int main(int argument_count, char** arguments) {
  try {
    return bench::run(argument_count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
