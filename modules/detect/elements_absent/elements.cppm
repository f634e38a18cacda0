// SPDX-License-Identifier: Apache-2.0
// Builds without the feature `deforming`: no pair asks for elements, since the C interface asks first.
export module abut.detect.elements;
import abut.broadphase;
import abut.core.standard;
import abut.core.workers;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.detect.pairs.refresh;
import abut.math;
import abut.scene.state.lent_vertices;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.meetings.policies;
import abut.scene.state.space;

export namespace abut {

inline constexpr bool finds_elements = false;

[[nodiscard]] inline bool has_elements(std::size_t /*kind*/) { return false; }

class ElementStage {
 public:
  [[nodiscard]] bool follow(const BoxFrame& /*frame*/, const PolicyTable& /*policies*/, const Space& /*space*/,
                            std::span<const std::uint32_t> /*fresh*/, const LentVertices& /*lent*/, bool /*has_time*/,
                            Places& /*places*/) {
    return false;
  }
  struct FirstTouch {
    std::uint32_t low, high;
    Real toi;
  };
  template <class EndOf, class HoldsUp>
  [[nodiscard]] std::optional<FirstTouch> first_touch(const Workers& /*workers*/, const BoxFrame& /*frame*/,
                                                      const PolicyTable& /*policies*/, const Space& /*space*/,
                                                      std::span<const std::uint32_t> /*fresh*/,
                                                      const LentVertices& /*lent*/, const Places& /*places*/,
                                                      const EndOf& /*end_of*/, const HoldsUp& /*holds_up*/) {
    return std::nullopt;
  }
  [[nodiscard]] std::span<const ProxyPair> with(std::span<const ProxyPair> near) { return near; }
  void run(const Workers& /*workers*/, const PolicyTable& /*policies*/, Places& /*places*/,
           std::span<const Pair> /*pairs*/, JobList& /*jobs*/) {}
  [[nodiscard]] std::span<const ContactHistory> histories_of(const Pair& /*pair*/) const { return {}; }
  [[nodiscard]] std::size_t first_of(const Pair& /*pair*/) const { return 0; }
  [[nodiscard]] std::span<const ContactHistory> histories_before_of(const Pair& /*pair*/, bool /*is_lost*/) const {
    return {};
  }
  [[nodiscard]] std::size_t contact_count() const { return 0; }
  [[nodiscard]] std::uint64_t hash_after(std::uint64_t hash) const { return hash; }
  // A universe that another build has saved may have some.
  template <class Archive, class Self>
  static void transfer(Archive& archive, Self& self) {
    std::uint64_t bodies = 0, contacts = 0;
    archive(self.had_time_, bodies, contacts);
    if constexpr (Archive::is_reading) {
      archive.require(bodies == 0 && contacts == 0, "element contacts are there");
    }
  }
  [[nodiscard]] bool restore(const Places& /*places*/, const PolicyTable& policies) const {
    return policies.tags_of_elements() == 0;
  }
  [[nodiscard]] std::size_t bytes() const { return 0; }

 private:
  bool had_time_ = false;
};

}  // namespace abut
