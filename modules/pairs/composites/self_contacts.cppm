// SPDX-License-Identifier: Apache-2.0
// A shape of any kind against itself.
export module abut.pairs.composites.self_contacts;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.pairs.shape_handle;
import abut.pairs.pair_job;

export namespace abut {

// As contacts_of_run of the table of pairs, for jobs of which both sides are the same geometry: in the frame of the
// shape.
void self_contacts_of_run(std::span<const ShapeHandle> shapes, std::span<const PairJob> jobs,
                          const QuerySettings& settings, Manifold& out, std::span<PairResult> results);

}  // namespace abut
