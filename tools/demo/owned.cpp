#include "owned.hpp"

#include <algorithm>

namespace demo {

std::vector<abut_contact> contacts_of(const abut_universe* universe) {
  const abut_contact* borrowed = nullptr;
  std::size_t count = 0;
  check(abut_universe_contacts(universe, &borrowed, &count), "cannot read the contacts");
  std::vector<abut_contact> contacts(count);
  std::copy_n(borrowed, count, contacts.begin());
  return contacts;
}

std::string plan_of(const abut_universe* universe) {
  std::size_t needed = 0;
  check(abut_universe_explain(universe, nullptr, 0, &needed), "cannot ask for the plan");
  std::string text(needed, '\0');
  check(abut_universe_explain(universe, text.data(), text.size(), &needed), "cannot read the plan");
  text.resize(needed > 0 ? needed - 1 : 0);
  return text;
}

}  // namespace demo
