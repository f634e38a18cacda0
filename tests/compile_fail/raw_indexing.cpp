// SPDX-License-Identifier: Apache-2.0
// An index into a pointer, which nothing can check.
// expect: unsafe buffer access
import abut;

double second(const double* values);
double second(const double* values) { return values[1]; }
