// SPDX-License-Identifier: Apache-2.0
// A reference into something that is gone when the statement ends.
// expect: temporary bound to local reference .* will be destroyed
import abut;

int dangle();
int dangle() {
  const int& view = *abut::Frozen<int>(1);
  return view;
}
