// SPDX-License-Identifier: Apache-2.0
// Detectors of the caller in place of the narrow phase.
#include "options.hpp"
#include "universe/universe_handle.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.universe;

using namespace abut::capi;

namespace {

abut_backend_pair from_pair(const abut_universe& its, const abut::BackendPair& pair) {
  const auto world = [&](abut::GeometryId id) { return from_placement(its.universe.world_pose(id).value()); };
  return {from_geometry(pair.a),
          from_geometry(pair.b),
          its.shapes[pair.a.slot - 1].get(),
          its.shapes[pair.b.slot - 1].get(),
          world(pair.a),
          world(pair.b),
          pair.margin};
}

// The memory of the pairs stays from step to step. The handle outlives the universe that is in it.
abut::Backend to_backend(abut_universe& its, abut_backend_accepts accepts, abut_backend_find find, void* context) {
  if (find == nullptr) {
    return {};
  }
  abut::Backend backend;
  if (accepts != nullptr) {
    backend.accepts = [=](std::size_t a, std::size_t b) {
      return accepts(context, abut::kind_number(a), abut::kind_number(b)) != 0;
    };
  }
  backend.find = [=, handle = &its] {
    const std::span<const abut::BackendPair> pairs = handle->universe.backend_pairs();
    std::vector<abut_backend_pair>& asked = handle->backend_pairs;
    asked.resize(pairs.size());
    std::transform(pairs.begin(), pairs.end(), asked.begin(),
                   [&](const abut::BackendPair& pair) { return from_pair(*handle, pair); });
    find(context, handle, asked.data(), asked.size());
  };
  return backend;
}

abut_status check_answer(const Where& where, const abut_backend_contact& contact) {
  for (const auto& [field, v] : {std::pair{".point_a", contact.point_a}, std::pair{".point_b", contact.point_b},
                                 std::pair{".normal", contact.normal}}) {
    if (const abut_status status = check_position(where, field, v); status != ABUT_OK) {
      return status;
    }
  }
  const abut::Vec3 normal = to_vec3(contact.normal);
  // A length off 1 by at most 1e-3.
  if (const double square = abut::dot(normal, normal); !(std::fabs(square - 1) <= 2.001e-3)) {
    return refuse(ABUT_NOT_UNIT, where.with(".normal") + " has length " + abut::to_text(std::sqrt(square)) +
                                     "; it must be 1 within 1e-3");
  }
  const abut_status status = check_value(where, ".feature_a.kind", contact.feature_a.kind, ABUT_FEATURE_PARTICLE);
  return status != ABUT_OK ? status
                           : check_value(where, ".feature_b.kind", contact.feature_b.kind, ABUT_FEATURE_PARTICLE);
}

abut::Feature to_feature(const abut_feature& feature) {
  return {static_cast<abut::FeatureKind>(feature.kind), feature.index};
}

// A normal of length one within rounding stays as it is.
abut::ContactPoint to_contact(const abut_backend_contact& contact) {
  abut::Vec3 normal = to_vec3(contact.normal);
  const double square = abut::dot(normal, normal);
  normal = std::fabs(square - 1) <= 4 * abut::epsilon ? normal : normal * (1 / std::sqrt(square));
  const abut::Vec3 a = to_vec3(contact.point_a), b = to_vec3(contact.point_b);
  return {.point_a = a,
          .point_b = b,
          .normal = normal,
          .distance = abut::dot(b - a, normal),
          .feature_a = to_feature(contact.feature_a),
          .feature_b = to_feature(contact.feature_b),
          .id = contact.id,
          .child_a = contact.child_a,
          .child_b = contact.child_b};
}

abut_status answer(abut_universe& its, std::size_t pair, std::span<const abut_backend_contact> given) {
  std::vector<abut::ContactPoint>& contacts = its.backend_contacts;
  contacts.clear();
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (const abut_status status = check_answer({"contacts", i}, given[i]); status != ABUT_OK) {
      return status;
    }
    contacts.push_back(to_contact(given[i]));
  }
  return its.universe.is_asking_backend()
             ? to_status(its.universe.answer_pair(pair, contacts))
             : refuse(ABUT_BUSY, "the universe does not ask a back end now; only abut_backend_find may answer");
}

}  // namespace

abut_status abut_backend_set(abut_universe* universe, abut_backend_accepts accepts, abut_backend_find find,
                             void* context) {
  return guard(universe, [&](abut_universe& its) {
    its.universe.set_backend(to_backend(its, accepts, find, context));
    return abut_status{ABUT_OK};
  });
}

abut_status abut_backend_answer(abut_universe* universe, size_t pair, const abut_backend_contact* contacts,
                                size_t count) {
  return guard_callable_in_step(universe, [&](abut_universe& its) {
    std::span<const abut_backend_contact> given;
    const abut_status status = read_span("contacts", contacts, "count", count, given);
    return status != ABUT_OK ? status : answer(its, pair, given);
  });
}
