// SPDX-License-Identifier: Apache-2.0
// Compiles: the right way to do what the other files do wrong.
#include <array>
#include <span>

import abut;

namespace compile_fail {

abut::Result<int> checked(int value);
abut::Result<int> checked(int value) { return value; }

int handled_result();
int handled_result() {
  const auto result = checked(1);
  return result.has_value() ? result.value() : 0;
}

double checked_indexing(std::span<const double> values);
double checked_indexing(std::span<const double> values) { return values[1]; }

int view_of_lasting();
int view_of_lasting() {
  const abut::Frozen<int> frozen(1);
  const int& view = *frozen;
  return view;
}

struct Part;
bool one_kind_of_id(abut::Id<Part> a, abut::Id<Part> b);
bool one_kind_of_id(abut::Id<Part> a, abut::Id<Part> b) { return a == b; }

abut::Vec3 along(const abut::UnitVec3& direction);
abut::Vec3 along(const abut::UnitVec3& direction) { return 2.0 * direction.vec(); }

abut::Vec3 checked_direction();
abut::Vec3 checked_direction() {
  const auto direction = abut::UnitVec3::make({0, 0, 3});
  return direction ? along(*direction) : abut::Vec3{0, 0, 0};
}

}  // namespace compile_fail
