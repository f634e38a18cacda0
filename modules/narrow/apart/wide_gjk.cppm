// SPDX-License-Identifier: Apache-2.0
// GJK with twice the digits, for cores on which rounding stops the usual one: slivers and needles beside bodies that
// are a million times as large, rims and edges that almost touch. Takes some ten times as long, and is compiled once
// for all cores.
export module abut.narrow.apart.wide_gjk;
import abut.core.standard;
import abut.math;
import abut.narrow.apart.gjk;
import abut.narrow.cores.difference;

export namespace abut {

struct WideGjkResult {
  GjkResult gjk;
  Vec3 point_a, point_b;  // closest, of cores that are apart
};

// As gjk, from the direction `toward` on.
[[nodiscard]] WideGjkResult wide_gjk(const Difference& cores, const Vec3& toward, Real error, Real limit,
                                     Real unproven);

}  // namespace abut
