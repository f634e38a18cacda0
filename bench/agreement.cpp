// SPDX-License-Identifier: Apache-2.0
#include "agreement.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>

namespace bench {
namespace {

// Answers that differ by more than this part of the size are counted.
constexpr double far_off = 1e-3;

}  // namespace

std::string_view query_name(Query query) {
  constexpr std::array<std::string_view, 7> names{"distance", "depth", "contacts", "cast", "overlap", "ray", "impact"};
  return names[static_cast<std::size_t>(query)];
}

double Agreements::compare(Query query, std::string_view library, const std::string& cell, double size,
                           std::span<const Answer> expected, std::span<const Answer> answers) {
  std::size_t asked = 0, off = 0;
  Agreement& agreement = agreements_[{query, std::string(library)}];
  for (std::size_t i = 0; i < answers.size(); ++i) {
    agreement.hash = (agreement.hash ^ std::bit_cast<std::uint64_t>(answers[i].distance)) * 0x100000001b3;
    if (expected[i].points == 0 && answers[i].points == 0) {
      continue;
    }
    ++asked;
    const double difference = std::fabs(answers[i].distance - expected[i].distance) / size;
    off += difference <= far_off ? 0 : 1;
    if (answers[i].points == 0) {
      ++agreement.unanswered;
    } else if (!(difference <= agreement.worst)) {
      agreement.worst = difference;
      agreement.cell = cell;
    }
  }
  agreement.asked += asked;
  agreement.far_off += off;
  return asked == 0 ? 0 : static_cast<double>(off) / static_cast<double>(asked);
}

void Agreements::print() const {
  std::printf("%-10s %-12s %8s %10s %8s %11s  %-16s  %s\n", "query", "library", "asked", "no answer", "> 1e-3", "worst",
              "hash", "where");
  for (const auto& [key, found] : agreements_) {
    std::printf("%-10s %-12s %8zu %10zu %8zu %11.1e  %016llx  %s\n", std::string(query_name(key.first)).c_str(),
                key.second.c_str(), found.asked, found.unanswered, found.far_off, found.worst,
                static_cast<unsigned long long>(found.hash), found.cell.c_str());
  }
}

}  // namespace bench
