// SPDX-License-Identifier: Apache-2.0
// How far the answers of libraries are from those that are expected.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "pairs.hpp"

namespace bench {

[[nodiscard]] std::string_view query_name(Query query);

class Agreements {
 public:
  // Differences are measured by the size of the solids. Returns the part of the asked answers that is far off.
  double compare(Query query, std::string_view library, const std::string& cell, double size,
                 std::span<const Answer> expected, std::span<const Answer> answers);
  void print() const;

 private:
  struct Agreement {
    double worst = 0;
    std::string cell = "-";
    std::size_t far_off = 0;
    std::size_t unanswered = 0, asked = 0;
    std::uint64_t hash = 0xcbf29ce484222325;  // of all answers (FNV-1a, eight bytes at a time)
  };

  std::map<std::pair<Query, std::string>, Agreement> agreements_;
};

}  // namespace bench
