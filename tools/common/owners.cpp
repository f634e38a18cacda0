// SPDX-License-Identifier: Apache-2.0
#include "owners.hpp"

#include <algorithm>

namespace tools {
namespace {

template <class Element>
std::vector<Element> copy_of(const Element* borrowed, std::size_t count) {
  std::vector<Element> copy(count);
  std::copy_n(borrowed, count, copy.begin());
  return copy;
}

// Asks for the size of a text, then for the text.
template <class Ask>
std::string text_of(const abut_universe* universe, Ask ask) {
  std::size_t needed = 0;
  check(ask(universe, nullptr, 0, &needed), "cannot ask for the plan");
  std::string text(needed, '\0');
  check(ask(universe, text.data(), text.size(), &needed), "cannot read the plan");
  text.resize(needed > 0 ? needed - 1 : 0);
  return text;
}

}  // namespace

std::vector<abut_contact> contacts_of(const abut_universe* universe) {
  const abut_contact* borrowed = nullptr;
  std::size_t count = 0;
  check(abut_universe_contacts(universe, &borrowed, &count), "cannot read the contacts");
  return copy_of(borrowed, count);
}

std::vector<abut_element_contact> element_contacts_of(const abut_universe* universe) {
  const abut_element_contact* borrowed = nullptr;
  std::size_t count = 0;
  check(abut_universe_element_contacts(universe, &borrowed, &count), "cannot read the element contacts");
  return copy_of(borrowed, count);
}

std::vector<abut_event> events_of(const abut_universe* universe) {
  const abut_event* borrowed = nullptr;
  std::size_t count = 0;
  check(abut_universe_events(universe, &borrowed, &count), "cannot read the events");
  return copy_of(borrowed, count);
}

abut_step_stats stats_of(const abut_universe* universe) {
  abut_step_stats stats;
  abut_step_stats_init(&stats, sizeof stats);
  check(abut_universe_stats(universe, &stats), "cannot read the statistics of a step");
  return stats;
}

std::string plan_of(const abut_universe* universe) { return text_of(universe, abut_universe_explain); }

std::string json_plan_of(const abut_universe* universe) { return text_of(universe, abut_universe_explain_json); }

}  // namespace tools
