// SPDX-License-Identifier: Apache-2.0
#include "statistics.hpp"

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace demo {
namespace {

struct Summary {
  double minimum;
  double median;
  double maximum;
  double total;
};

Summary summarise(std::vector<double> values) {
  if (values.empty()) {
    return {0.0, 0.0, 0.0, 0.0};
  }
  std::sort(values.begin(), values.end());
  return {values.front(), values[values.size() / 2], values.back(), std::accumulate(values.begin(), values.end(), 0.0)};
}

template <class Field>
std::vector<double> column(const std::vector<abut_step_stats>& steps, Field field) {
  std::vector<double> values(steps.size());
  std::transform(steps.begin(), steps.end(), values.begin(),
                 [&](const abut_step_stats& stats) { return static_cast<double>(stats.*field); });
  return values;
}

void print_count(const char* name, const std::vector<double>& values) {
  const Summary s = summarise(values);
  std::printf("%-28s %12.0f %12.0f %12.0f %14.0f\n", name, s.minimum, s.median, s.maximum, s.total);
}

void print_time(const char* name, const std::vector<double>& microseconds) {
  const Summary s = summarise(microseconds);
  std::printf("%-28s %12.3f %12.3f %12.3f %14.1f\n", name, 1e-3 * s.minimum, 1e-3 * s.median, 1e-3 * s.maximum,
              1e-3 * s.total);
}

}  // namespace

void Statistics::record(const abut_universe* universe, double motion_microseconds, double step_microseconds) {
  abut_step_stats stats;
  abut_step_stats_init(&stats, sizeof stats);
  check(abut_universe_stats(universe, &stats), "cannot read the statistics of a step");
  steps_.push_back(stats);
  motion_.push_back(motion_microseconds);
  whole_.push_back(step_microseconds);
}

void Statistics::record_cloth(const Cloth& cloth, double microseconds) {
  element_contacts_.push_back(static_cast<double>(cloth.contacts().size()));
  cloth_.push_back(microseconds);
}

void Statistics::print() const {
  std::printf("\n%-28s %12s %12s %12s %14s\n", "counts per step", "min", "median", "max", "all steps");
  print_count("moved geometries", column(steps_, &abut_step_stats::moved));
  print_count("candidate pairs", column(steps_, &abut_step_stats::candidate_pairs));
  print_count("touching pairs", column(steps_, &abut_step_stats::touching_pairs));
  print_count("contacts", column(steps_, &abut_step_stats::contacts));
  print_count("unsupported pairs", column(steps_, &abut_step_stats::unsupported_pairs));
  print_count("element contacts, cloth", element_contacts_);

  std::printf("\n%-28s %12s %12s %12s %14s\n", "milliseconds per step", "min", "median", "max", "all steps");
  print_time("motion (by the demo)", motion_);
  print_time("refresh: poses to boxes", column(steps_, &abut_step_stats::refresh_microseconds));
  print_time("broad phase: boxes to pairs", column(steps_, &abut_step_stats::broadphase_microseconds));
  print_time("narrow phase: to manifolds", column(steps_, &abut_step_stats::narrowphase_microseconds));
  print_time("contacts: reduce and order", column(steps_, &abut_step_stats::contact_microseconds));
  print_time("whole step", whole_);
  print_time("cloth: five steps of its own", cloth_);
}

}  // namespace demo
