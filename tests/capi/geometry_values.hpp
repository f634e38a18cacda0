// SPDX-License-Identifier: Apache-2.0
// Calls that give each geometry of a list another value, and what all of them have to refuse.
#pragma once

#include "bad_values.hpp"

namespace abut_test {

// A call with both geometries of a scene, ready to be spoiled.
template <class Value>
struct GeometryValues {
  using Call = abut_status (*)(abut_universe*, const abut_geometry_id*, const Value*, std::size_t);

  GeometryValues(Call function, const Scene& scene, const std::array<Value, 2>& good)
      : call(function), universe(scene.universe), geometries{scene.geometry, scene.second_geometry}, values(good) {}
  abut_status set() const { return call(universe, geometries.data(), values.data(), 2); }

  Call call;
  abut_universe* universe;
  std::array<abut_geometry_id, 2> geometries;
  std::array<Value, 2> values;
};

template <class Value>
void refuse_null_pointers(const GeometryValues<Value>& batch, std::string_view name) {
  const auto& [call, universe, geometries, values] = batch;
  EXPECT_TRUE(refused(call(nullptr, geometries.data(), values.data(), 2), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(call(universe, nullptr, values.data(), 2), ABUT_NULL_ARGUMENT, {"geometries", "null"}));
  EXPECT_TRUE(refused(call(universe, geometries.data(), nullptr, 2), ABUT_NULL_ARGUMENT, {name, "null"}));
}

// Counts that overflow with elements of this many bytes.
template <class Value>
void refuse_overflowing_counts(const GeometryValues<Value>& batch, std::size_t element_size) {
  expect_overflow_refused(element_size, "count", [&](std::size_t count) {
    return batch.call(batch.universe, batch.geometries.data(), batch.values.data(), count);
  });
}

template <class Value>
void refuse_stale_geometries(GeometryValues<Value> batch, const Scene& scene) {
  for (const abut_geometry_id stale : scene.stale_geometries) {
    batch.geometries[1] = stale;
    EXPECT_TRUE(refused(batch.set(), ABUT_STALE_ID, {"geometries", "1", std::to_string(stale.slot)}));
  }
}

}  // namespace abut_test
