// SPDX-License-Identifier: Apache-2.0
// Two geometries at the last step: whether they touch, and if not, why.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gates.hpp"
#include "near_pairs.hpp"
#include "placed.hpp"

namespace cli {

struct Encounter {
  Placed a, b;
  bool touches = false;
  std::size_t contacts = 0;
  std::size_t elements = 0;                 // element contacts, of pairs with that detail
  std::vector<GateAnswer> answers{};        // of the gates, then of what comes after them
  std::optional<abut_distance> distance{};  // none where the kinds have no algorithm
  std::string stopped_by{};                 // the first that keeps them apart; empty where they touch
};

class Encounters {
 public:
  /// The world must live longer, and take no step meanwhile.
  explicit Encounters(const World& world);

  [[nodiscard]] Encounter between(std::size_t a, std::size_t b) const;

  /// Pairs that come near, in ascending order.
  [[nodiscard]] const std::vector<NumberPair>& near() const { return near_; }

 private:
  [[nodiscard]] GateAnswer answer_of_boxes(std::size_t a, std::size_t b) const;

  const World* world_;
  Gates gates_;
  std::vector<NumberPair> near_;
  std::map<NumberPair, std::size_t> contacts_;
  std::map<NumberPair, std::size_t> elements_;
};

/// Signed distance; none where the kinds have no algorithm.
[[nodiscard]] std::optional<abut_distance> distance_between(const abut_shape* a, const abut_pose& pose_a,
                                                            const abut_shape* b, const abut_pose& pose_b);

}  // namespace cli
