// SPDX-License-Identifier: Apache-2.0
// Words, findings and bytes of a response, as response.h has them.
#include <abut/response.h>

#include "core/check.hpp"
#include "extension_arguments.hpp"
#include "response/arguments.hpp"
#include "response/handle.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

import abut.response;

namespace {

using abut::capi::guarded;
using abut::capi::refuse;
using abut::capi::refuse_null;
using abut::response::Simulation;

using Words = std::string (Simulation::*)() const;

[[nodiscard]] abut_status tell(const abut_response* response, Words words, char* text, std::size_t capacity,
                               std::size_t* needed) {
  if (response == nullptr) return refuse_null("response");
  if (needed == nullptr) return refuse_null("needed");
  if (const abut_status status = abut::capi::check_room("text", text, capacity, 1); status != ABUT_OK) return status;
  return guarded([&]() -> abut_status {
    *needed = abut::capi::fill_text((response->simulation.*words)(), text, capacity);
    return ABUT_OK;
  });
}

// Numbers of bytes are checked as those of callers are.
[[nodiscard]] abut_status check_loaded(const Simulation& simulation) {
  abut_status status = abut::capi::check_options(simulation.options());
  for (const abut_part_id part : simulation.parts()) {
    const std::optional<abut::response::MassProperties> mass = simulation.mass_of(part);
    if (!mass) return refuse(ABUT_INVALID_ARGUMENT, "bytes hold bodies out of order");
    if (status != ABUT_OK) return status;
    abut_mass_properties its{.mass = mass->mass, .centre = mass->centre, .inertia = {}};
    std::ranges::copy(mass->inertia, std::span(its.inertia).begin());
    status = abut::capi::check_mass(its, "mass of bytes");
  }
  return status;
}

}  // namespace

abut_status abut_response_validate(const abut_response* response, abut_response_finding* findings, std::size_t capacity,
                                   std::size_t* count) {
  if (response == nullptr) return refuse_null("response");
  if (count == nullptr) return refuse_null("count");
  if (const abut_status status = abut::capi::check_room("findings", findings, capacity, sizeof *findings);
      status != ABUT_OK)
    return status;
  return guarded([&] {
    std::vector<abut_response_finding> found;
    const abut_status status = response->simulation.validate(found);
    if (status != ABUT_OK) return status;
    *count = found.size();
    // SAFETY: the caller answers for `capacity` findings.
    ABUT_UNSAFE_BEGIN
    const std::span<abut_response_finding> out(findings, std::min(capacity, found.size()));
    ABUT_UNSAFE_END
    std::ranges::copy(std::span(found).first(out.size()), out.begin());
    return status;
  });
}

abut_status abut_response_explain(const abut_response* response, char* text, std::size_t capacity,
                                  std::size_t* needed) {
  return tell(response, &Simulation::explain, text, capacity, needed);
}

abut_status abut_response_explain_json(const abut_response* response, char* text, std::size_t capacity,
                                       std::size_t* needed) {
  return tell(response, &Simulation::explain_json, text, capacity, needed);
}

abut_status abut_response_save(const abut_response* response, void* bytes, std::size_t capacity, std::size_t* size) {
  if (response == nullptr) return refuse_null("response");
  if (size == nullptr) return refuse_null("size");
  if (const abut_status status = abut::capi::check_room("bytes", bytes, capacity, 1); status != ABUT_OK) return status;
  return guarded([&]() -> abut_status {
    const std::vector<std::byte> saved = response->simulation.save();
    *size = saved.size();
    if (saved.size() > capacity) return ABUT_OK;
    // SAFETY: the caller answers for `capacity` bytes.
    ABUT_UNSAFE_BEGIN
    const std::span<std::byte> out(static_cast<std::byte*>(bytes), capacity);
    ABUT_UNSAFE_END
    std::ranges::copy(saved, out.begin());
    return ABUT_OK;
  });
}

abut_status abut_response_load(abut_universe* universe, const void* bytes, std::size_t size, abut_response** out) {
  if (bytes == nullptr) return refuse_null("bytes");
  if (out == nullptr) return refuse_null("out");
  if (const abut_status status = abut::capi::check_fits("size", size, 1); status != ABUT_OK) return status;
  abut_response* made = nullptr;
  if (const abut_status status = abut_response_create(universe, nullptr, &made); status != ABUT_OK) return status;
  std::unique_ptr<abut_response> response(made);
  return guarded([&]() -> abut_status {
    // SAFETY: the caller answers for `size` bytes.
    ABUT_UNSAFE_BEGIN
    const std::span<const std::byte> given(static_cast<const std::byte*>(bytes), size);
    ABUT_UNSAFE_END
    if (!response->simulation.load(given))
      return refuse(ABUT_INVALID_ARGUMENT, "bytes are no saved response, or they are damaged");
    if (const abut_status status = check_loaded(response->simulation); status != ABUT_OK) return status;
    *out = response.release();
    return ABUT_OK;
  });
}

abut_status abut_response_hash(const abut_response* response, std::uint64_t* out) {
  if (response == nullptr) return refuse_null("response");
  if (out == nullptr) return refuse_null("out");
  return guarded([&]() -> abut_status {
    *out = abut::response::hash_of(response->simulation.save());
    return ABUT_OK;
  });
}
