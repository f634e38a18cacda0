// SPDX-License-Identifier: Apache-2.0
// Builds without the feature `motion`: no geometry asks for a path, since the C interface asks first.
export module abut.detect.continuous;
import abut.broadphase;
import abut.core.standard;
import abut.core.workers;
import abut.detect.lists.contacts;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.detect.paths;
import abut.detect.pairs.refresh;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.meetings.policies;
import abut.scene.state.space;

export namespace abut {

inline constexpr bool follows_paths = false;

class Sweeps {
 public:
  [[nodiscard]] bool run(const Workers& /*workers*/, const Paths& /*paths*/, const BoxFrame& /*frame*/,
                         const Space& /*space*/, std::span<const std::uint32_t> /*swept_places*/, Places& /*places*/) {
    return false;
  }
  void clear() {}
  [[nodiscard]] std::span<const ProxyPair> pairs() const { return {}; }
  [[nodiscard]] std::span<const ProxyPair> with(std::span<const ProxyPair> near) { return near; }
  [[nodiscard]] std::span<const std::uint32_t> numbers() const { return {}; }
  [[nodiscard]] std::size_t bytes() const { return 0; }
};

struct [[gsl::Pointer]] PathScene {
  const UniverseOptions& options;
  const PolicyTable& policies;
  const Places& places;
  const Paths& paths;
  const Sweeps& sweeps;
  std::span<const ContactHistory> histories;
};

class ImpactStage {
 public:
  void start(std::span<const std::uint32_t> /*wanted*/, const Paths& /*paths*/, const Places& /*places*/,
             std::span<Pair> /*pairs*/) {}
  void run(const Workers& /*workers*/, const PathScene& /*scene*/, std::span<Pair> /*pairs*/, JobList& /*jobs*/) {}
  void mark(std::span<const Pair> /*pairs*/, ContactList& /*contacts*/) {}
  [[nodiscard]] std::span<const StepImpact> all() const { return {}; }
  void restore(const std::vector<StepImpact>& /*impacts*/) {}
  [[nodiscard]] std::uint64_t examined() const { return 0; }
  [[nodiscard]] std::size_t bytes() const { return 0; }
};

}  // namespace abut
