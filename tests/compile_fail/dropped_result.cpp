// SPDX-License-Identifier: Apache-2.0
// A failure that nobody looks at.
// expect: ignoring return value of .*declared with 'nodiscard'
import abut;

abut::Result<int> checked(int value);
abut::Result<int> checked(int value) { return value; }

void drop();
void drop() { checked(1); }
