// SPDX-License-Identifier: Apache-2.0
// Pairs of boxes from grids of cells.
export module abut.broadphase.hash_grid;
import abut.broadphase.kept.followed_boxes;
import abut.trees.grids.box_grid;

export namespace abut {

// For many boxes of much the same size. A call costs O(m + pairs) for m boxes that have left their larger ones.
class Grid : public FollowedBoxes<BoxGrid> {};

}  // namespace abut
