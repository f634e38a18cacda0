// SPDX-License-Identifier: Apache-2.0
// Who meets whom, as far as it is not an option of a geometry: rules, and the filter of the caller.
#include "options.hpp"
#include "universe/universe_handle.hpp"

import abut.core;
import abut.universe;

using namespace abut::capi;

static_assert(static_cast<abut_collidable_kind>(abut::CollidableKind::geometry) == ABUT_COLLIDABLE_GEOMETRY);
static_assert(static_cast<abut_collidable_kind>(abut::CollidableKind::part) == ABUT_COLLIDABLE_PART);
static_assert(static_cast<abut_collidable_kind>(abut::CollidableKind::label) == ABUT_COLLIDABLE_LABEL);
static_assert(static_cast<abut_collidable_kind>(abut::CollidableKind::any) == ABUT_COLLIDABLE_ANY);
static_assert(static_cast<abut_apart_reasons>(abut::apart_by_part) == ABUT_APART_PART);
static_assert(static_cast<abut_apart_reasons>(abut::apart_by_motion) == ABUT_APART_MOTION);
static_assert(static_cast<abut_apart_reasons>(abut::apart_by_parking) == ABUT_APART_PARKING);
static_assert(static_cast<abut_apart_reasons>(abut::apart_by_exclusion) == ABUT_APART_EXCLUSION);
static_assert(static_cast<abut_apart_reasons>(abut::apart_by_layers) == ABUT_APART_LAYERS);
static_assert(static_cast<abut_apart_reasons>(abut::apart_by_rule) == ABUT_APART_RULE);
static_assert(static_cast<abut_apart_reasons>(abut::apart_by_filter) == ABUT_APART_FILTER);
static_assert(static_cast<abut_apart_reasons>(abut::apart_by_kinds) == ABUT_APART_KINDS);
static_assert(static_cast<abut_apart_reasons>(abut::apart_by_boxes) == ABUT_APART_BOXES);
static_assert(static_cast<abut_apart_reasons>(abut::apart_by_policy) == ABUT_APART_POLICY);
static_assert(static_cast<abut_apart_reasons>(abut::apart_by_detection) == ABUT_APART_DETECTION);
static_assert(static_cast<abut_rule>(abut::Rule::none) == ABUT_RULE_NONE);
static_assert(static_cast<abut_rule>(abut::Rule::enable) == ABUT_RULE_ENABLE);
static_assert(static_cast<abut_rule>(abut::Rule::disable) == ABUT_RULE_DISABLE);

namespace {

abut_status check_zero(const Where& where, std::string_view field, std::uint32_t value) {
  if (value != 0) {
    return refuse(
        error_about(abut::Errc::invalid_argument, where.with(field), std::uint64_t{value}, "zero for this kind"));
  }
  return ABUT_OK;
}

// What its kind does not use must be zero, so that equal collidables are equal bit by bit.
abut_status check_collidable(const Where& where, const abut::Universe& universe, const abut_collidable& given) {
  const abut_geometry_id geometry{given.slot, given.generation};
  const abut_part_id part{given.slot, given.generation};
  switch (given.kind) {
    case ABUT_COLLIDABLE_GEOMETRY:
      return exists(universe, geometry) ? static_cast<abut_status>(ABUT_OK) : refuse_stale(where, geometry);
    case ABUT_COLLIDABLE_PART:
      return exists(universe, part) ? static_cast<abut_status>(ABUT_OK) : refuse_stale(where, part);
    case ABUT_COLLIDABLE_LABEL: return check_zero(where, ".generation", given.generation);
    case ABUT_COLLIDABLE_ANY: {
      const abut_status status = check_zero(where, ".slot", given.slot);
      return status != ABUT_OK ? status : check_zero(where, ".generation", given.generation);
    }
    default: return check_value(where, ".kind", given.kind, ABUT_COLLIDABLE_ANY);
  }
}

abut::Collidable to_collidable(const abut_collidable& given) {
  return {static_cast<abut::CollidableKind>(given.kind), given.slot, given.generation};
}

abut_status set_rule(abut_universe& its, const abut_collidable& a, const abut_collidable& b, abut_rule rule) {
  abut_status status = check_collidable({"a"}, its.universe, a);
  status = status != ABUT_OK ? status : check_collidable({"b"}, its.universe, b);
  status = status != ABUT_OK ? status : check_value({"rule"}, "", rule, ABUT_RULE_DISABLE);
  if (status != ABUT_OK) {
    return status;
  }
  const auto done = its.universe.set_rule(to_collidable(a), to_collidable(b), static_cast<abut::Rule>(rule));
  return done ? static_cast<abut_status>(ABUT_OK) : refuse(done.error());
}

abut_collidable from_collidable(const abut::Collidable& its) {
  return {static_cast<abut_collidable_kind>(its.kind), its.slot, its.generation};
}

// Two geometries that a question is about.
abut_status check_both(const abut::Universe& universe, const abut_geometry_id& a, const abut_geometry_id& b) {
  if (!exists(universe, a)) {
    return refuse_stale({"geometry_a"}, a);
  }
  return exists(universe, b) ? static_cast<abut_status>(ABUT_OK) : refuse_stale({"geometry_b"}, b);
}

// Sets a filter of either form; `ask` knows how it is called. The handle outlives the universe that is in it.
template <class Filter, class Ask>
abut_status set_filter(abut_universe* universe, Filter filter, Ask ask) {
  return guard(universe, [&](abut_universe& its) {
    if (filter == nullptr) {
      its.universe.set_filter(nullptr);
    } else {
      its.universe.set_filter([ask, handle = &std::as_const(its)](abut::GeometryId a, abut::GeometryId b) {
        return ask(handle, from_geometry(a), from_geometry(b)) != 0;
      });
    }
    return abut_status{ABUT_OK};
  });
}

}  // namespace

abut_status abut_rule_set(abut_universe* universe, const abut_collidable* a, const abut_collidable* b, abut_rule rule) {
  return guard(universe, [&](abut_universe& its) {
    const abut_status status = check_none_null<2>({{{"a", a}, {"b", b}}});
    return status != ABUT_OK ? status : set_rule(its, *a, *b, rule);
  });
}

abut_status abut_rules_clear(abut_universe* universe) {
  return guard(universe, [](abut_universe& its) {
    its.universe.clear_rules();
    return abut_status{ABUT_OK};
  });
}

abut_status abut_rule_between(const abut_universe* universe, abut_geometry_id geometry_a, abut_geometry_id geometry_b,
                              abut_rule* rule, abut_collidable* a, abut_collidable* b) {
  return guard(universe, [&](const abut_universe& its) {
    abut_status status = check_none_null<3>({{{"rule", rule}, {"a", a}, {"b", b}}});
    status = status != ABUT_OK ? status : check_both(its.universe, geometry_a, geometry_b);
    if (status == ABUT_OK) {
      const auto verdict = its.universe.rule_between(to_geometry(geometry_a), to_geometry(geometry_b)).value();
      *rule = static_cast<abut_rule>(verdict.rule);
      *a = from_collidable(verdict.a);
      *b = from_collidable(verdict.b);
    }
    return status;
  });
}

abut_status abut_universe_why_apart(const abut_universe* universe, abut_geometry_id geometry_a,
                                    abut_geometry_id geometry_b, abut_apart_reasons* out) {
  return guard(universe, [&](const abut_universe& its) {
    abut_status status = check_not_null("out", out);
    status = status != ABUT_OK ? status : check_both(its.universe, geometry_a, geometry_b);
    if (status == ABUT_OK) {
      *out = its.universe.why_apart(to_geometry(geometry_a), to_geometry(geometry_b)).value();
    }
    return status;
  });
}

abut_status abut_universe_set_filter(abut_universe* universe, abut_filter filter, void* context) {
  return set_filter(universe, filter, [=](const abut_universe* its, abut_geometry_id a, abut_geometry_id b) {
    return filter(context, its, a, b);
  });
}

abut_status abut_universe_set_pointer_filter(abut_universe* universe, abut_pointer_filter filter, void* context) {
  return set_filter(universe, filter, [=](const abut_universe* its, abut_geometry_id a, abut_geometry_id b) {
    return filter(context, its, &a, &b);
  });
}

abut_status abut_universe_refilter(abut_universe* universe) {
  return guard(universe, [](abut_universe& its) {
    its.universe.refilter();
    return abut_status{ABUT_OK};
  });
}
