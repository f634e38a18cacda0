// SPDX-License-Identifier: Apache-2.0
#include "nearest.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

#include "node.hpp"

namespace cli {
namespace {

bool is_same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

// How many letters are put in, left out, replaced or swapped with the next one: optimal string alignment.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    last[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = is_same_letter(a[i - 1], b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      if (i > 1 && j > 1 && is_same_letter(a[i - 1], b[j - 2]) && is_same_letter(a[i - 2], b[j - 1])) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before = last;
    last = row;
  }
  return last[b.size()];
}

}  // namespace

std::string listing(std::span<const std::string> names) {
  constexpr std::size_t most = 24;
  std::string text;
  for (const std::string& name : names.first(std::min(names.size(), most))) {
    text += (text.empty() ? "" : ", ") + printable(name);
  }
  return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more" : text;
}

std::optional<std::string> nearest(std::string_view word, std::span<const std::string> names) {
  constexpr std::size_t longest = 64;  // longer words are nobody's slip of a finger, and cost time
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  std::optional<std::string> found;
  for (const std::string& name : names) {
    if (std::max(word.size(), name.size()) > longest) {
      continue;
    }
    // A name that begins with the whole word is what a copy of a part, or a word cut short, is called.
    const bool begins = word.size() > 1 && name.starts_with(word);
    const std::size_t distance = begins ? 1 : edits(word, name);
    if (distance < least) {
      least = distance;
      found = name;
    }
  }
  return found;
}

std::string suggestion(std::string_view word, std::span<const std::string> names) {
  const std::optional<std::string> found = nearest(word, names);
  return found ? "; did you mean '" + printable(*found) + "'?" : "";
}

std::string what_there_is(std::string_view of_what, std::string_view word, std::span<const std::string> names) {
  const std::string what(of_what);
  return names.empty() ? "; there is no " + what : "; there are: " + listing(names) + suggestion(word, names);
}

}  // namespace cli
