// SPDX-License-Identifier: Apache-2.0
// Elements of meshes that deform, without a universe.
#include "convert.hpp"
#include "guard.hpp"
#include "options.hpp"
#include "shapes/shape_handle.hpp"
#include "deforming/stencil.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.proximity.body;
import abut.proximity.closest;
import abut.proximity.search.cones;
import abut.proximity.crossings;
import abut.proximity.first_touches;
import abut.proximity.search;
import abut.proximity.stencil;
import abut.trees.elements.element_pairs;
import abut.triangles.elements;

using namespace abut::capi;

// Answers of a search stay until the next one, so that their memory is used again.
struct abut_elements {
  explicit abut_elements(abut::Triangles surface)
      : body(std::move(surface.vertices), std::move(surface.indices), abut::Workers(1)) {}

  abut::ElementBody body;
  abut::ElementSearch candidates;
  abut::ClosestFeatures closest;
  abut::FirstTouches first_touches;
  abut::Crossings crossings;
  std::vector<abut::Stencil> stencils;
  std::vector<abut::Crossing> found_crossings;
  std::vector<std::vector<abut_element_pair>> found_pairs;  // by task
};

namespace {

constexpr abut_elements_options default_elements_options{
    sizeof(abut_elements_options), ABUT_CLOSEST_FEATURES, 0, 0, 0, 0, 0, 1e-9, 0, 0, 0.5};

using abut::ClosestMethod;
using abut::StencilKind;

static_assert(static_cast<abut_closest_method>(ClosestMethod::closest) == ABUT_CLOSEST_FEATURES);
static_assert(static_cast<abut_closest_method>(ClosestMethod::faces) == ABUT_CLOSEST_OF_FACES);
static_assert(static_cast<abut_closest_method>(ClosestMethod::all) == ABUT_CLOSEST_ALL);
static_assert(static_cast<abut_closest_method>(ClosestMethod::nearest) == ABUT_CLOSEST_OF_VERTICES);
static_assert(static_cast<abut_closest_method>(ClosestMethod::local_minima) == ABUT_CLOSEST_LOCAL_MINIMA);
static_assert(static_cast<abut_stencil_kind>(StencilKind::vertex_face) == ABUT_STENCIL_VERTEX_FACE);
static_assert(static_cast<abut_stencil_kind>(StencilKind::edge_edge) == ABUT_STENCIL_EDGE_EDGE);
static_assert(static_cast<abut_stencil_kind>(StencilKind::vertex_edge) == ABUT_STENCIL_VERTEX_EDGE);
static_assert(static_cast<abut_stencil_kind>(StencilKind::vertex_vertex) == ABUT_STENCIL_VERTEX_VERTEX);

// Sixth powers of coordinates neither overflow nor lose digits.
constexpr double largest_vertex = 1e50;

constexpr std::uint32_t kinds_of_candidates = bit(StencilKind::vertex_face) | bit(StencilKind::edge_edge);
constexpr std::uint32_t all_kinds =
    kinds_of_candidates | bit(StencilKind::vertex_edge) | bit(StencilKind::vertex_vertex);

abut_status check_vertices(std::string_view name, std::span<const double> numbers) {
  if (const abut_status status = to_status(abut::check_all_finite(name, numbers)); status != ABUT_OK) {
    return status;
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (std::fabs(numbers[i]) > largest_vertex) {
      return refuse(abut::error_about(abut::Errc::out_of_range, std::string(name) + "[" + std::to_string(i) + "]",
                                      numbers[i], "at most 1e50 in magnitude"));
    }
  }
  return ABUT_OK;
}

abut_status create(const abut_shape* shape, abut_elements** out) {
  std::optional<abut::Triangles> surface = abut::triangles_of(shape_of(shape));
  if (!surface) {
    return refuse(ABUT_UNSUPPORTED, "shape is a " + std::string(abut::kind_name(abut::kind_of(shape_of(shape)))) +
                                        ", which has no surface of triangles");
  }
  for (std::size_t i = 0; i < surface->vertices.size(); ++i) {
    if (abut::largest_magnitude(surface->vertices[i]) > largest_vertex) {
      return refuse(abut::error_about(abut::Errc::out_of_range, "vertex " + std::to_string(i) + " of shape",
                                      abut::largest_magnitude(surface->vertices[i]), "at most 1e50 in magnitude"));
    }
  }
  *out = std::make_unique<abut_elements>(std::move(*surface)).release();
  return ABUT_OK;
}

struct Search {
  abut::ClosestOptions closest;
  abut::FirstTouchOptions first_touches;
  std::uint32_t threads;
};

abut_status check_share(std::string_view name, double value) {
  if (const abut_status status = to_status(abut::check_not_negative(name, value)); status != ABUT_OK) {
    return status;
  }
  return value > 1 ? refuse(abut::error_about(abut::Errc::out_of_range, name, value, "at most 1"))
                   : static_cast<abut_status>(ABUT_OK);
}

abut_status read_options(const abut_elements_options* given, Search& out) {
  if (given != nullptr) {
    abut_status status = check_struct_size({"options"}, *given);
    status = status != ABUT_OK ? status : check_value({"options"}, ".method", given->method, ABUT_CLOSEST_LOCAL_MINIMA);
    status = status != ABUT_OK ? status : check_bits({"options"}, ".kinds", given->kinds, all_kinds);
    status = status != ABUT_OK ? status : check_bits({"options"}, ".flags", given->flags, ABUT_ELEMENTS_FRONTS_ONLY);
    status = status != ABUT_OK ? status : check_threads(given->threads);
    status = status != ABUT_OK ? status : check_reserved({"options"}, given->reserved);
    status = status != ABUT_OK ? status : to_status(abut::check_not_negative("options.reach", given->reach));
    status = status != ABUT_OK ? status : to_status(abut::check_positive("options.tolerance", given->tolerance));
    status =
        status != ABUT_OK ? status : to_status(abut::check_not_negative("options.rest_distance", given->rest_distance));
    status = status != ABUT_OK ? status : check_share("options.cone_angle", given->cone_angle);
    status = status != ABUT_OK ? status : check_share("options.cone_factor", given->cone_factor);
    if (status != ABUT_OK) {
      return status;
    }
  }
  const abut_elements_options& its = given == nullptr ? default_elements_options : *given;
  out.closest = {static_cast<ClosestMethod>(its.method),
                 its.kinds,
                 its.reach,
                 its.rest_distance,
                 {its.cone_angle, its.cone_factor, (its.flags & ABUT_ELEMENTS_FRONTS_ONLY) != 0}};
  out.first_touches = {its.kinds, {its.reach, its.tolerance}, its.rest_distance};
  out.threads = its.threads;
  return ABUT_OK;
}

// Options that have no sense for pairs of a vertex and a face, or of two edges.
abut_status check_kinds_of_pairs(std::uint32_t kinds) {
  if ((kinds & ~kinds_of_candidates) != 0) {
    return refuse(abut::error_about(abut::Errc::invalid_argument, "options.kinds", std::uint64_t{kinds},
                                    "made of vertices with faces (1) and edges (2) here"));
  }
  return ABUT_OK;
}

// Checks what all searches take. `search(options, b, places)` then answers how many there are.
template <class Place, class Body>
abut_status answer(abut_elements* a, abut_elements* b, const abut_elements_options* options, std::string_view name,
                   Place* places, std::size_t capacity, std::size_t* count, const Body& body) {
  return guard([&] {
    Search search;
    std::span<Place> out;
    abut_status status = check_none_null<2>({{{"a", a}, {"count", count}}});
    status = status != ABUT_OK ? status : read_options(options, search);
    status = status != ABUT_OK ? status : read_span(name, places, "capacity", capacity, out);
    if (status != ABUT_OK) {
      return status;
    }
    abut_elements& other = b == nullptr ? *a : *b;
    return body(*a, other, search, out);
  });
}

void find_candidates(abut_elements& a, const abut_elements& b, const Search& search, const abut::Workers& workers) {
  const std::uint32_t kinds = search.closest.kinds == 0 ? kinds_of_candidates : search.closest.kinds;
  a.found_pairs.resize(std::max(a.found_pairs.size(), a.candidates.tasks()));
  for (std::vector<abut_element_pair>& found : a.found_pairs) {
    found.clear();
  }
  a.candidates.for_each_candidates(a.body, b.body, workers, [&](std::size_t task, const abut::Candidates& its) {
    std::vector<abut_element_pair>& found = a.found_pairs[task];
    if ((kinds & bit(StencilKind::vertex_face)) != 0) {
      for (const auto& [vertex, face] : its.vertices_and_faces.list()) {
        found.push_back({ABUT_ELEMENT_PAIR_VERTEX_FACE, vertex, face});
      }
      for (const auto& [vertex, face] : its.faces_and_vertices.list()) {
        found.push_back({ABUT_ELEMENT_PAIR_FACE_VERTEX, face, vertex});
      }
    }
    if ((kinds & bit(StencilKind::edge_edge)) != 0) {
      for (const auto& [first, second] : its.edges.list()) {
        const bool are_turned = &a == &b && second < first;
        found.push_back({ABUT_ELEMENT_PAIR_EDGE_EDGE, are_turned ? second : first, are_turned ? first : second});
      }
    }
  });
}

// As many as fit, in the order of tasks. Answers how many there are.
std::size_t write_candidates(const abut_elements& elements, std::span<abut_element_pair> out) {
  std::size_t count = 0;
  for (const std::vector<abut_element_pair>& found : elements.found_pairs) {
    if (count < out.size()) {
      std::copy_n(found.begin(), std::min(found.size(), out.size() - count), out.subspan(count).begin());
    }
    count += found.size();
  }
  return count;
}

}  // namespace

void abut_elements_options_init(abut_elements_options* options, uint32_t struct_size) {
  fill_defaults(default_elements_options, struct_size, options);
}

abut_status abut_elements_create(const abut_shape* shape, abut_elements** out) {
  return guard([&] {
    const abut_status status = check_none_null<2>({{{"shape", shape}, {"out", out}}});
    return status != ABUT_OK ? status : create(shape, out);
  });
}

void abut_elements_destroy(abut_elements* elements) { const std::unique_ptr<const abut_elements> last(elements); }

abut_status abut_elements_count(const abut_elements* elements, abut_element_counts* out) {
  return guard([&] {
    const abut_status status = check_none_null<2>({{{"elements", elements}, {"out", out}}});
    if (status == ABUT_OK) {
      const abut::ElementTable& table = elements->body.table();
      *out = {elements->body.rest().size(), table.edges().size(), table.triangle_count(), table.face_count()};
    }
    return status;
  });
}

abut_status abut_elements_edges(const abut_elements* elements, uint32_t* vertices, size_t capacity, size_t* count) {
  return guard([&] {
    std::span<std::uint32_t> out;
    abut_status status = check_none_null<2>({{{"elements", elements}, {"count", count}}});
    status = status != ABUT_OK ? status : read_span<2>("vertices", vertices, "capacity", capacity, out);
    if (status == ABUT_OK) {
      const std::span<const abut::EdgeEnds> edges = elements->body.table().edges();
      for (std::size_t i = 0; i < std::min(edges.size(), capacity); ++i) {
        out[2 * i] = edges[i][0];
        out[2 * i + 1] = edges[i][1];
      }
      *count = edges.size();
    }
    return status;
  });
}

abut_status abut_elements_set_vertices(abut_elements* elements, const double* start, const double* end,
                                       size_t vertex_count) {
  return guard([&] {
    std::span<const double> starts, ends;
    abut_status status = check_not_null("elements", elements);
    status = status != ABUT_OK ? status : read_span<3>("start", start, "vertex_count", vertex_count, starts);
    status =
        status != ABUT_OK || end == nullptr ? status : read_span<3>("end", end, "vertex_count", vertex_count, ends);
    if (status == ABUT_OK && vertex_count != elements->body.rest().size()) {
      return refuse(abut::error_about(abut::Errc::invalid_argument, "vertex_count", std::uint64_t{vertex_count},
                                      std::to_string(elements->body.rest().size()) + ", as the shape has"));
    }
    status = status != ABUT_OK ? status : check_vertices("start", starts);
    status = status != ABUT_OK ? status : check_vertices("end", ends);
    if (status == ABUT_OK) {
      elements->body.move(starts, ends);
    }
    return status;
  });
}

abut_status abut_elements_candidates(abut_elements* a, abut_elements* b, const abut_elements_options* options,
                                     abut_element_pair* pairs, size_t capacity, size_t* count) {
  return answer(a, b, options, "pairs", pairs, capacity, count,
                [&](abut_elements& its, abut_elements& other, const Search& search, std::span<abut_element_pair> out) {
                  const abut_status status = check_kinds_of_pairs(search.closest.kinds);
                  if (status == ABUT_OK) {
                    const abut::Workers workers(search.threads);
                    its.candidates.begin(its.body, other.body, search.closest.reach, workers);
                    find_candidates(its, other, search, workers);
                    *count = write_candidates(its, out);
                  }
                  return status;
                });
}

abut_status abut_elements_closest(abut_elements* a, abut_elements* b, const abut_elements_options* options,
                                  abut_stencil* stencils, size_t capacity, size_t* count) {
  return answer(a, b, options, "stencils", stencils, capacity, count,
                [&](abut_elements& its, abut_elements& other, const Search& search, std::span<abut_stencil> out) {
                  its.closest.find(its.body, other.body, search.closest, abut::Workers(search.threads), its.stencils);
                  fill(std::span<const abut::Stencil>(its.stencils), out, from_stencil);
                  *count = its.stencils.size();
                  return abut_status{ABUT_OK};
                });
}

abut_status abut_elements_first_touches(abut_elements* a, abut_elements* b, const abut_elements_options* options,
                                        abut_stencil* stencils, size_t capacity, size_t* count) {
  return answer(a, b, options, "stencils", stencils, capacity, count,
                [&](abut_elements& its, abut_elements& other, const Search& search, std::span<abut_stencil> out) {
                  const abut_status status = check_kinds_of_pairs(search.closest.kinds);
                  if (status == ABUT_OK) {
                    its.first_touches.find(its.body, other.body, search.first_touches, abut::Workers(search.threads),
                                           its.stencils);
                    fill(std::span<const abut::Stencil>(its.stencils), out, from_stencil);
                    *count = its.stencils.size();
                  }
                  return status;
                });
}

abut_status abut_elements_crossings(abut_elements* a, abut_elements* b, const abut_elements_options* options,
                                    abut_crossing* crossings, size_t capacity, size_t* count) {
  return answer(a, b, options, "crossings", crossings, capacity, count,
                [&](abut_elements& its, abut_elements& other, const Search& search, std::span<abut_crossing> out) {
                  its.crossings.find(its.body, other.body, abut::Workers(search.threads), its.found_crossings);
                  fill(std::span<const abut::Crossing>(its.found_crossings), out, [](const abut::Crossing& crossing) {
                    return abut_crossing{crossing.edge,
                                         crossing.face,
                                         crossing.is_edge_of_b ? 1U : 0U,
                                         0,
                                         crossing.share,
                                         from_vec3(crossing.point)};
                  });
                  *count = its.found_crossings.size();
                  return abut_status{ABUT_OK};
                });
}
