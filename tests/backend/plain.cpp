// SPDX-License-Identifier: Apache-2.0
#include "detector.hpp"
#include "support.hpp"

namespace backend {
namespace {

void find(void* /*context*/, abut_universe* universe, const abut_backend_pair* pairs, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (const auto contacts = contacts_of(pairs[i])) answer(universe, i, *contacts);
  }
}

}  // namespace

std::optional<std::vector<abut_backend_contact>> contacts_of(const abut_backend_pair& pair) {
  auto options = abut_test::filled_by(abut_query_options_init);
  options.margin = pair.margin;
  options.max_contacts = 0;
  std::size_t count = 0;
  const auto ask = [&](abut_contact* out, std::size_t capacity) {
    return abut_pair_contacts(pair.shape_a, &pair.pose_a, pair.shape_b, &pair.pose_b, &options, out, capacity, &count);
  };
  if (ask(nullptr, 0) != ABUT_OK) return std::nullopt;
  std::vector<abut_contact> found(count);
  if (ask(found.data(), found.size()) != ABUT_OK) return std::nullopt;
  std::vector<abut_backend_contact> contacts;
  for (const abut_contact& its : found) {
    contacts.push_back(
        {its.point_a, its.point_b, its.normal, its.feature_a, its.feature_b, its.child_a, its.child_b, its.id});
  }
  return contacts;
}

void answer(abut_universe* universe, std::size_t pair, const std::vector<abut_backend_contact>& contacts) {
  abut_test::require(abut_backend_answer(universe, pair, contacts.data(), contacts.size()));
}

Detector plain() { return {"plain", nullptr, find, nullptr, 1e-9}; }

}  // namespace backend
