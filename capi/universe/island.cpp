// SPDX-License-Identifier: Apache-2.0
// Islands: dynamic parts that touch each other.
#include "universe/universe_handle.hpp"

import abut.core;
import abut.universe;

using namespace abut::capi;

namespace {

abut_island from_island(const abut::Island& island) { return {island.id, island.first, island.count}; }

// As far as they are found at all.
abut_status check_followed(const abut_universe& its) {
  if (!its.universe.follows_islands()) {
    return refuse(ABUT_UNSUPPORTED, "islands are not found; abut_universe_follow_islands asks for them");
  }
  return ABUT_OK;
}

abut_status lend(const abut_universe& its, const abut_island** islands, std::size_t* count) {
  if (const abut_status status = check_followed(its); status != ABUT_OK) {
    return status;
  }
  const std::span<const abut_island> lent = its.islands.get(its.universe.islands().islands(), from_island);
  *islands = lent.data();
  *count = lent.size();
  return ABUT_OK;
}

abut_status lend_parts(const abut_universe& its, const abut_part_id** parts, std::size_t* count) {
  if (const abut_status status = check_followed(its); status != ABUT_OK) {
    return status;
  }
  const std::span<const abut_part_id> lent = its.island_parts.get(its.universe.islands().parts(), from_part);
  *parts = lent.data();
  *count = lent.size();
  return ABUT_OK;
}

abut_status island_of(const abut_universe& its, const abut_part_id& part, abut_island* out) {
  if (const abut_status status = check_followed(its); status != ABUT_OK) {
    return status;
  }
  if (!exists(its.universe, part)) {
    return refuse_stale({"part"}, part);
  }
  const std::optional<abut::Island> found = its.universe.islands().of(to_part(part));
  *out = found ? from_island(*found) : abut_island{};
  return ABUT_OK;
}

}  // namespace

abut_status abut_universe_follow_islands(abut_universe* universe, uint32_t are_followed) {
  return guard(universe, [&](abut_universe& its) {
    if (are_followed > 1) {
      return refuse(error_about(abut::Errc::unknown_value, "are_followed", std::uint64_t{are_followed}, "0 or 1"));
    }
    its.universe.follow_islands(are_followed == 1);
    its.islands.forget();
    its.island_parts.forget();
    return abut_status{ABUT_OK};
  });
}

abut_status abut_universe_islands(const abut_universe* universe, const abut_island** islands, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_none_null<2>({{{"islands", islands}, {"count", count}}});
    return status != ABUT_OK ? status : lend(its, islands, count);
  });
}

abut_status abut_universe_island_parts(const abut_universe* universe, const abut_part_id** parts, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_none_null<2>({{{"parts", parts}, {"count", count}}});
    return status != ABUT_OK ? status : lend_parts(its, parts, count);
  });
}

abut_status abut_part_island(const abut_universe* universe, abut_part_id part, abut_island* out) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_not_null("out", out);
    return status != ABUT_OK ? status : island_of(its, part, out);
  });
}
