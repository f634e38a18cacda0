// SPDX-License-Identifier: Apache-2.0
// Features whose vertices move on straight lines: when they first touch. Twelve numbers are four vertices.
#ifndef ABUT_CPP_DEFORMING_HPP
#define ABUT_CPP_DEFORMING_HPP

#include <abut/abut.h>
#include <abut/cpp/answer.hpp>
#include <abut/cpp/values.hpp>

#include <cstddef>
#include <vector>

namespace abut {

// How near counts as a touch: separation 0 is exact, and the tolerance is read only above that.
struct TouchOptions {
  double separation = 0;
  double tolerance = 1e-9;
};

inline namespace ABUT_ANSWERS {
namespace detail {

template <class Ask>
[[nodiscard]] Answer<std::vector<FirstTouch>> first_touches(Span<const double> start, Span<const double> end,
                                                            const TouchOptions& options, Ask&& ask) {
  std::vector<FirstTouch> out(start.size() / 12);
  const abut_status sizes = first_failure(expect_as_many("start", start.size(), "whole queries", 12 * out.size()),
                                          expect_as_many("end", end.size(), "start", start.size()));
  return answer(sizes != ABUT_OK ? sizes
                                 : ask(start.data(), end.data(), out.size(), options.separation, options.tolerance,
                                       out.data()),
                out);
}

}  // namespace detail

// A vertex and the three corners of a face for each query, at time 0 and at time 1.
[[nodiscard]] inline Answer<std::vector<FirstTouch>> vertices_touch_faces(Span<const double> start,
                                                                          Span<const double> end,
                                                                          const TouchOptions& options = {}) {
  return detail::first_touches(start, end, options, abut_vertices_touch_faces);
}

// The two ends of one edge and those of the other for each query.
[[nodiscard]] inline Answer<std::vector<FirstTouch>> edges_touch_edges(Span<const double> start,
                                                                       Span<const double> end,
                                                                       const TouchOptions& options = {}) {
  return detail::first_touches(start, end, options, abut_edges_touch_edges);
}

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif
