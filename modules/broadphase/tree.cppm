// SPDX-License-Identifier: Apache-2.0
// Pairs of boxes from trees that follow their motion.
export module abut.broadphase.tree;
import abut.broadphase.kept.followed_boxes;
import abut.trees.boxes.box_tree;

export namespace abut {

// For boxes of any size anywhere. A call costs O(m log n + pairs) for m boxes that have left their larger ones.
class Tree : public FollowedBoxes<BoxTree> {};

}  // namespace abut
