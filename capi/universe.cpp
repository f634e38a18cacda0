// Universes as a whole.
#include "universe_handle.hpp"
#include "options.hpp"

import abut.core;
import abut.universe;

using namespace abut::capi;

static_assert(static_cast<abut_broadphase>(abut::Broadphase::automatic) == ABUT_BROADPHASE_AUTO);
static_assert(static_cast<abut_broadphase>(abut::Broadphase::brute) == ABUT_BROADPHASE_BRUTE);
static_assert(static_cast<abut_broadphase>(abut::Broadphase::tree) == ABUT_BROADPHASE_TREE);
static_assert(static_cast<abut_tolerance_mode>(abut::ToleranceMode::dead_band) == ABUT_TOLERANCE_DEAD_BAND);
static_assert(static_cast<abut_tolerance_mode>(abut::ToleranceMode::margin) == ABUT_TOLERANCE_MARGIN);

namespace {

// Tells the ids of one universe from those of the others.
constinit std::atomic<std::uint32_t> next_number{1};

constexpr abut_universe_options default_options{
    sizeof(abut_universe_options), ABUT_BROADPHASE_AUTO, ABUT_TOLERANCE_DEAD_BAND, 4, {0, 0, 0}};

abut_status check_options(const abut_universe_options& options) {
  const Where where{"options"};
  abut_status status = check_struct_size(where, options);
  status = status != ABUT_OK ? status : check_value(where, ".broadphase", options.broadphase, ABUT_BROADPHASE_TREE);
  status = status != ABUT_OK ? status : check_value(where, ".tolerance_mode", options.tolerance_mode, ABUT_TOLERANCE_MARGIN);
  return status != ABUT_OK ? status : check_position(where, ".origin", options.origin);
}

abut_status create(const abut_universe_options& options, abut_universe** out) {
  if (const abut_status status = check_options(options); status != ABUT_OK) {
    return status;
  }
  abut::UniverseOptions wanted;
  wanted.broadphase = static_cast<abut::Broadphase>(options.broadphase);
  wanted.tolerance_mode = static_cast<abut::ToleranceMode>(options.tolerance_mode);
  wanted.max_contacts = options.max_contacts;
  wanted.origin = to_vec3(options.origin);
  *out = std::make_unique<abut_universe>(wanted, next_number.fetch_add(1, std::memory_order_relaxed)).release();
  return ABUT_OK;
}

// Writes a list by count-then-fill.
template <class CId, class Id, class Convert>
abut_status write_ids(const std::vector<Id>& found, std::span<CId> out, std::size_t* count, Convert&& convert) {
  fill(std::span<const Id>(found), out, convert);
  *count = found.size();
  return ABUT_OK;
}

abut_status write_text(const std::string& found, std::span<char> out, std::size_t* needed) {
  if (!out.empty()) {
    const std::size_t length = std::min(found.size(), out.size() - 1);
    std::copy_n(found.begin(), length, out.begin());
    out[length] = '\0';
  }
  *needed = found.size() + 1;
  return ABUT_OK;
}

}  // namespace

void abut_universe_options_init(abut_universe_options* options, uint32_t struct_size) {
  fill_defaults(default_options, struct_size, options);
}

abut_status abut_universe_create(const abut_universe_options* options, abut_universe** out) {
  return guard([&] {
    const abut_status status = check_not_null("out", out);
    return status != ABUT_OK ? status : create(options == nullptr ? default_options : *options, out);
  });
}

void abut_universe_destroy(abut_universe* universe) { const std::unique_ptr<abut_universe> last(universe); }

abut_status abut_universe_parts(const abut_universe* universe, abut_part_id* parts, size_t capacity, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<abut_part_id> out;
    abut_status status = check_not_null("count", count);
    status = status != ABUT_OK ? status : read_span("parts", parts, "capacity", capacity, out);
    return status != ABUT_OK ? status : write_ids(its.universe.parts(), out, count, from_part);
  });
}

abut_status abut_universe_geometries(const abut_universe* universe, abut_geometry_id* geometries, size_t capacity, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<abut_geometry_id> out;
    abut_status status = check_not_null("count", count);
    status = status != ABUT_OK ? status : read_span("geometries", geometries, "capacity", capacity, out);
    return status != ABUT_OK ? status : write_ids(its.universe.geometries(), out, count, from_geometry);
  });
}

abut_status abut_universe_revision(const abut_universe* universe, abut_revision* out) {
  return guard(universe, [&](const abut_universe& its) {
    if (const abut_status status = check_not_null("out", out); status != ABUT_OK) {
      return status;
    }
    const abut::Revision revision = its.universe.revision();
    *out = {revision.geometries, revision.poses};
    return abut_status{ABUT_OK};
  });
}

abut_status abut_universe_explain(const abut_universe* universe, char* text, size_t capacity, size_t* needed) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<char> out;
    abut_status status = check_not_null("needed", needed);
    status = status != ABUT_OK ? status : read_span("text", text, "capacity", capacity, out);
    return status != ABUT_OK ? status : write_text(its.universe.explain(), out, needed);
  });
}
