// SPDX-License-Identifier: Apache-2.0
// What is asked of one pair of many, and what the answer leaves.
export module abut.pairs.pair_job;
import abut.capability;
import abut.core.standard;
import abut.math;

export namespace abut {

inline constexpr std::uint32_t no_memory = 0xffffffff;

// One pair of geometries of a run of pairs with the same two kinds.
struct PairJob {
  std::uint32_t a, b;  // places in the arrays of shapes and poses
  Real margin;
  std::uint32_t memory = no_memory;  // place in the array of memories
};

// What a run of pairs left behind: where the contacts of each job end, and how it went.
struct PairResult {
  std::uint32_t contacts_end;
  Outcome outcome;
};

}  // namespace abut
