// Which kinds of shapes this build has.
#include "border.hpp"

import abut.any_shape;
import abut.registry;

using namespace abut::capi;

size_t abut_shape_kind_count(void) { return abut::shape_kind_count; }

abut_shape_kind abut_shape_kind_at(size_t index) {
  return index < abut::shape_kind_count ? abut::Shapes::kinds[index] : abut_shape_kind{0};
}

abut_shape_kind abut_shape_kind_by_name(const char* name) {
  const auto place = name == nullptr ? std::nullopt : abut::find_kind(std::string_view(name));
  return place ? abut::Shapes::kinds[*place] : abut_shape_kind{0};
}

const char* abut_shape_kind_name(abut_shape_kind kind) {
  const auto place = abut::find_kind(kind);
  return place ? c_string(abut::kind_name(*place)) : nullptr;
}

size_t abut_shape_kind_parameter_count(abut_shape_kind kind) {
  const auto place = abut::find_kind(kind);
  return place ? abut::kind_parameter_count(*place) : 0;
}

const char* abut_shape_kind_parameter_name(abut_shape_kind kind, size_t index) {
  const auto place = abut::find_kind(kind);
  return place && index < abut::kind_parameter_count(*place) ? c_string(abut::kind_parameter_name(*place, index)) : nullptr;
}
