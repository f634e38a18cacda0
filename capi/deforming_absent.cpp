// SPDX-License-Identifier: Apache-2.0
// Builds without the feature `deforming`.
#include "elements_options.hpp"
#include "guard.hpp"

using namespace abut::capi;

namespace {

abut_status refuse_deforming() {
  return guard([] { return refuse(ABUT_UNSUPPORTED, "this build of abut is without the feature \"deforming\""); });
}

}  // namespace

abut_status abut_vertices_touch_faces(const double* /*start*/, const double* /*end*/, size_t /*count*/,
                                      double /*separation*/, double /*tolerance*/, abut_first_touch* /*out*/) {
  return refuse_deforming();
}

abut_status abut_edges_touch_edges(const double* /*start*/, const double* /*end*/, size_t /*count*/,
                                   double /*separation*/, double /*tolerance*/, abut_first_touch* /*out*/) {
  return refuse_deforming();
}

void abut_elements_options_init(abut_elements_options* options, uint32_t struct_size) {
  fill_defaults(default_elements_options, struct_size, options);
}

abut_status abut_elements_create(const abut_shape* /*shape*/, abut_elements** /*out*/) { return refuse_deforming(); }

void abut_elements_destroy(abut_elements* /*elements*/) {}

abut_status abut_elements_count(const abut_elements* /*elements*/, abut_element_counts* /*out*/) {
  return refuse_deforming();
}

abut_status abut_elements_edges(const abut_elements* /*elements*/, uint32_t* /*vertices*/, size_t /*capacity*/,
                                size_t* /*count*/) {
  return refuse_deforming();
}

abut_status abut_elements_set_vertices(abut_elements* /*elements*/, const double* /*start*/, const double* /*end*/,
                                       size_t /*vertex_count*/) {
  return refuse_deforming();
}

abut_status abut_elements_candidates(abut_elements* /*a*/, abut_elements* /*b*/,
                                     const abut_elements_options* /*options*/, abut_element_pair* /*pairs*/,
                                     size_t /*capacity*/, size_t* /*count*/) {
  return refuse_deforming();
}

abut_status abut_elements_closest(abut_elements* /*a*/, abut_elements* /*b*/, const abut_elements_options* /*options*/,
                                  abut_stencil* /*stencils*/, size_t /*capacity*/, size_t* /*count*/) {
  return refuse_deforming();
}

abut_status abut_elements_first_touches(abut_elements* /*a*/, abut_elements* /*b*/,
                                        const abut_elements_options* /*options*/, abut_stencil* /*stencils*/,
                                        size_t /*capacity*/, size_t* /*count*/) {
  return refuse_deforming();
}

abut_status abut_elements_crossings(abut_elements* /*a*/, abut_elements* /*b*/,
                                    const abut_elements_options* /*options*/, abut_crossing* /*crossings*/,
                                    size_t /*capacity*/, size_t* /*count*/) {
  return refuse_deforming();
}

abut_status abut_universe_element_contacts(const abut_universe* /*universe*/, const abut_element_contact** /*contacts*/,
                                           size_t* /*count*/) {
  return refuse_deforming();
}
