// SPDX-License-Identifier: Apache-2.0
// What a step did and why, for people and for programs.
export module abut.report.plan;
import abut.core.standard;
import abut.scene.rest.focus;
import abut.scene.state.options;

export namespace abut {

struct [[gsl::Pointer]] Plan {
  struct [[gsl::Pointer]] Stage {
    std::string_view name;
    double microseconds;
    std::string what;
  };
  struct [[gsl::Pointer]] KindPair {
    std::string_view kind_a, kind_b;
    std::uint64_t candidates, examined, touching, contacts;
    std::string_view algorithm, reason;
    std::optional<double> microseconds = std::nullopt;  // of a pair that was examined
  };
  struct LeftOut {
    std::string name, why;
  };

  struct FocusCounts {
    Focus focus;
    std::uint64_t centres, near, far;
  };
  // A library that stands on the universe, and how many of its objects do.
  struct Extension {
    std::string name;
    std::uint64_t count;
  };
  struct IslandCounts {
    std::uint64_t islands, parts, largest;
  };
  struct VelocityCounts {
    std::uint64_t given, measured;
  };
  // Geometries whose path through a step is looked at, pairs that were examined on it, and impacts.
  struct PathCounts {
    std::uint64_t fast, speculative, pairs, impacts;
  };
  // Pairs that a detector of the caller was asked about, and those that it answered.
  struct BackendCounts {
    std::uint64_t asked, answered;
  };

  StepStats stats;
  std::string_view broadphase, broadphase_reason;
  bool is_margin;
  std::uint32_t max_contacts, threads;
  std::uint64_t rules, policies;
  std::vector<Stage> stages;
  std::vector<KindPair> kinds;
  std::vector<LeftOut> left_out;
  std::optional<BackendCounts> backend = std::nullopt;
  std::optional<FocusCounts> focus = std::nullopt;
  std::optional<IslandCounts> islands = std::nullopt;
  std::optional<VelocityCounts> velocities = std::nullopt;
  std::optional<PathCounts> paths = std::nullopt;
  std::vector<Extension> extensions = {};
};

// A number with its noun: "1 geometry", "2 geometries".
[[nodiscard]] std::string count_of(std::uint64_t count, std::string_view noun);

[[nodiscard]] std::string to_text(const Plan& plan);
[[nodiscard]] std::string to_json(const Plan& plan);

}  // namespace abut
