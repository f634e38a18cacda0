// SPDX-License-Identifier: Apache-2.0
// Vertices on straight lines.
#include "border.hpp"
#include "guard.hpp"

import abut.capability;
import abut.deforming;
import abut.math;

using namespace abut::capi;

namespace {

constexpr std::size_t numbers_of_query = 12;

// A vertex of a query, from where all vertices are at one time and where they are at another.
abut::MovingPoint vertex_of(std::span<const double> start, std::span<const double> end, std::size_t query,
                            std::size_t index) {
  const std::size_t first = numbers_of_query * query + 3 * index;
  return {{start[first], start[first + 1], start[first + 2]}, {end[first], end[first + 1], end[first + 2]}};
}

abut_status read_motion(const double* start, const double* end, std::size_t count, std::span<const double>& starts,
                        std::span<const double>& ends) {
  if (const abut_status status = read_span<numbers_of_query>("start", start, "count", count, starts);
      status != ABUT_OK) {
    return status;
  }
  if (const abut_status status = read_span<numbers_of_query>("end", end, "count", count, ends); status != ABUT_OK) {
    return status;
  }
  if (const abut_status status = to_status(abut::check_all_finite("start", starts)); status != ABUT_OK) {
    return status;
  }
  return to_status(abut::check_all_finite("end", ends));
}

abut_status read_settings(double separation, double tolerance, abut::TouchSettings& out) {
  if (const abut_status status = to_status(abut::check_not_negative("separation", separation)); status != ABUT_OK) {
    return status;
  }
  if (separation > 0) {
    if (const abut_status status = to_status(abut::check_positive("tolerance", tolerance)); status != ABUT_OK) {
      return status;
    }
  }
  out = {separation, tolerance};
  return ABUT_OK;
}

// `answer` tells the first touch of a query.
template <class Answer>
abut_status answer_all(const double* start, const double* end, std::size_t count, double separation, double tolerance,
                       abut_first_touch* out, const Answer& answer) {
  std::span<const double> starts, ends;
  abut::TouchSettings settings;
  std::span<abut_first_touch> answers;
  abut_status status = read_motion(start, end, count, starts, ends);
  status = status != ABUT_OK ? status : read_settings(separation, tolerance, settings);
  status = status != ABUT_OK ? status : read_span("out", out, "count", count, answers);
  if (status != ABUT_OK) {
    return status;
  }
  for (std::size_t query = 0; query < count; ++query) {
    const auto vertex = [&](std::size_t index) { return vertex_of(starts, ends, query, index); };
    const abut::MovingTouch touch = answer(vertex, settings);
    answers[query] = {touch.touches ? 1u : 0u, 0, touch.lower, touch.upper};
  }
  return ABUT_OK;
}

}  // namespace

abut_status abut_vertices_touch_faces(const double* start, const double* end, size_t count, double separation,
                                      double tolerance, abut_first_touch* out) {
  return guard([&] {
    return answer_all(
        start, end, count, separation, tolerance, out, [](const auto& vertex, const abut::TouchSettings& settings) {
          return abut::first_touch_of_vertex_and_face(vertex(0), {vertex(1), vertex(2), vertex(3)}, settings);
        });
  });
}

abut_status abut_edges_touch_edges(const double* start, const double* end, size_t count, double separation,
                                   double tolerance, abut_first_touch* out) {
  return guard([&] {
    return answer_all(start, end, count, separation, tolerance, out,
                      [](const auto& vertex, const abut::TouchSettings& settings) {
                        return abut::first_touch_of_edges({vertex(0), vertex(1)}, {vertex(2), vertex(3)}, settings);
                      });
  });
}
