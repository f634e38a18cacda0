// SPDX-License-Identifier: Apache-2.0
// Extension libraries of a universe.
#include "universe/universe_handle.hpp"

using namespace abut::capi;

void Extensions::attach(std::string_view name) {
  const std::scoped_lock lock(mutex_);
  ++counts_.try_emplace(std::string(name), 0).first->second;
}

bool Extensions::detach(std::string_view name) {
  const std::scoped_lock lock(mutex_);
  const auto found = counts_.find(name);
  if (found == counts_.end()) {
    return false;
  }
  if (--found->second == 0) {
    counts_.erase(found);
  }
  return true;
}

std::vector<abut::Plan::Extension> Extensions::all() const {
  const std::scoped_lock lock(mutex_);
  std::vector<abut::Plan::Extension> list;
  for (const auto& [name, count] : counts_) {
    list.push_back({name, count});
  }
  return list;
}

namespace {

// Longer names are cut where they are shown, so nobody gets to use one.
constexpr std::size_t longest_name = 63;

bool is_letter_of_name(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
         letter == '_' || letter == '-' || letter == '.';
}

abut_status check_name(const char* name) {
  if (const abut_status status = check_not_null("name", name); status != ABUT_OK) {
    return status;
  }
  const std::string_view text(name);
  if (text.empty() || text.size() > longest_name || !std::ranges::all_of(text, is_letter_of_name)) {
    return refuse(ABUT_INVALID_ARGUMENT, "name is \"" + std::string(text.substr(0, longest_name)) + "\", of length " +
                                             std::to_string(text.size()) + "; it must be 1 to " +
                                             std::to_string(longest_name) + " letters, digits, '_', '-' or '.'");
  }
  return ABUT_OK;
}

}  // namespace

abut_status abut_universe_attach(const abut_universe* universe, const char* name) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_name(name);
    if (status == ABUT_OK) {
      its.extensions.attach(name);
      its.owners.fetch_add(1, std::memory_order_relaxed);
    }
    return status;
  });
}

// Not behind the guard of a universe: one that has failed has to go as well, with its last owner.
abut_status abut_universe_detach(const abut_universe* universe, const char* name) {
  return guard([&] {
    abut_status status = check_not_null("universe", universe);
    status = status != ABUT_OK ? status : check_name(name);
    if (status != ABUT_OK) {
      return status;
    }
    if (!universe->extensions.detach(name)) {
      return refuse(ABUT_UNKNOWN_VALUE, "name is \"" + std::string(name) + "\"; no extension of that name is attached");
    }
    let_go(*universe);
    return abut_status{ABUT_OK};
  });
}
