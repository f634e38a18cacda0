// SPDX-License-Identifier: Apache-2.0
// Kinds, rules and objects of response.h.
#include <abut/response.h>

#include "core/check.hpp"
#include "extension_arguments.hpp"
#include "response/arguments.hpp"
#include "response/handle.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

import abut.response;

namespace {

using abut::capi::guarded;
using abut::capi::refuse;
using abut::capi::refuse_null;
using abut::response::Refusal;

constexpr abut_response_side any_side{.kind = ABUT_RESPONSE_SIDE_ANY, .slot = 0, .generation = 0};

[[nodiscard]] abut_status told(const std::optional<Refusal>& refused) noexcept {
  return refused ? refuse(refused->status, refused->message.c_str()) : abut_status{ABUT_OK};
}

[[nodiscard]] std::string_view text_or_none(const char* text) noexcept { return text == nullptr ? "" : text; }

[[nodiscard]] abut_status check_side(const abut_response_side& side, const char* argument) noexcept {
  if (side.kind > ABUT_RESPONSE_SIDE_MATERIAL)
    return refuse(ABUT_UNKNOWN_VALUE, argument, side.kind, "it must be a value of abut_response_side_kind");
  return ABUT_OK;
}

[[nodiscard]] abut::response::CustomLaw law_of(abut_contact_law_callback law, void* context) {
  return [law, context](const abut_contact& contact, const abut_vec3& velocity, double dt, abut_contact_law& out,
                        bool& counts) {
    counts = law(context, &contact, &velocity, dt, &out) != 0;
    return counts ? abut::capi::check_law(out) : abut_status{ABUT_OK};
  };
}

}  // namespace

abut_status abut_response_add_kind(abut_response* response, const char* name, abut_contact_law_callback law,
                                   void* context) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    if (name == nullptr) return refuse_null("name");
    if (law == nullptr) return refuse_null("law");
    return told(its.simulation.rules().add_kind(name, law_of(law, context)));
  });
}

abut_status abut_response_kinds(const abut_response* response, const char** names, std::size_t capacity,
                                std::size_t* count) {
  if (response == nullptr) return refuse_null("response");
  if (count == nullptr) return refuse_null("count");
  if (const abut_status status = abut::capi::check_room("names", names, capacity, sizeof *names); status != ABUT_OK)
    return status;
  const auto& kinds = response->simulation.rules().kinds();
  *count = kinds.size();
  // SAFETY: the caller answers for `capacity` pointers.
  ABUT_UNSAFE_BEGIN
  const std::span<const char*> out(names, std::min(capacity, kinds.size()));
  ABUT_UNSAFE_END
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = kinds[i].name.c_str();
  return ABUT_OK;
}

abut_status abut_response_add_rule(abut_response* response, const abut_response_side* a, const abut_response_side* b,
                                   const char* kind, const char* parameters, std::uint32_t* out) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    if (kind == nullptr) return refuse_null("kind");
    const abut_response_side side_a = a == nullptr ? any_side : *a, side_b = b == nullptr ? any_side : *b;
    abut_status status = check_side(side_a, "a.kind");
    if (status == ABUT_OK) status = check_side(side_b, "b.kind");
    if (status != ABUT_OK) return status;
    std::uint32_t number = 0;
    status = told(its.simulation.rules().add(side_a, side_b, kind, text_or_none(parameters), number));
    if (status == ABUT_OK && out != nullptr) *out = number;
    return status;
  });
}

abut_status abut_response_set_rule_parameters(abut_response* response, std::uint32_t rule, const char* parameters) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    if (rule >= its.simulation.rules().rules().size())
      return refuse(ABUT_INDEX_OUT_OF_RANGE, "rule", rule, "there are not that many rules");
    return told(its.simulation.rules().set_parameters(rule, text_or_none(parameters)));
  });
}

abut_status abut_response_clear_rules(abut_response* response) {
  return guarded(response, [](abut_response& its) -> abut_status {
    its.simulation.rules().clear();
    return ABUT_OK;
  });
}

abut_status abut_response_set_variable(abut_response* response, const char* name, const char* value) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    if (name == nullptr) return refuse_null("name");
    if (value == nullptr) return refuse_null("value");
    its.simulation.rules().set_variable(name, value);
    return ABUT_OK;
  });
}

abut_status abut_response_set_geometry_kind(abut_response* response, abut_geometry_id geometry, const char* kind,
                                            const char* parameters) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    abut_geometry_info info;
    abut_geometry_info_init(&info, sizeof info);
    const abut_status status = abut_geometry_describe(its.universe.get(), geometry, &info);
    if (status != ABUT_OK) return status;
    if (kind != nullptr) return told(its.simulation.rules().set_geometry(geometry, kind, text_or_none(parameters)));
    its.simulation.rules().clear_geometry(geometry);
    return ABUT_OK;
  });
}

abut_status abut_response_rule_between(const abut_response* response, abut_geometry_id a, abut_geometry_id b,
                                       char* text, std::size_t capacity, std::size_t* needed) {
  if (response == nullptr) return refuse_null("response");
  if (needed == nullptr) return refuse_null("needed");
  if (const abut_status status = abut::capi::check_room("text", text, capacity, 1); status != ABUT_OK) return status;
  return guarded([&] {
    for (const auto& [name, geometry] : {std::pair("a", a), std::pair("b", b)}) {
      abut_pose pose;
      if (abut_geometries_poses(response->universe.get(), &geometry, 1, &pose) == ABUT_STALE_ID)
        return abut::capi::refuse_stale(name, geometry);
    }
    std::string whole;
    const abut_status status = response->simulation.explain_pair(a, b, whole);
    if (status == ABUT_OK) *needed = abut::capi::fill_text(whole, text, capacity);
    return status;
  });
}

abut_status abut_response_objects(const abut_response* response, const abut_response_object** objects,
                                  std::size_t* count) {
  if (response == nullptr) return refuse_null("response");
  if (objects == nullptr) return refuse_null("objects");
  if (count == nullptr) return refuse_null("count");
  *objects = response->simulation.objects().data();
  *count = response->simulation.objects().size();
  return ABUT_OK;
}

abut_status abut_response_set_listener(abut_response* response, abut_response_listener listener, void* context) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    its.listener = listener;
    its.listener_context = context;
    return ABUT_OK;
  });
}
