// SPDX-License-Identifier: Apache-2.0
module abut.pairs.two_shapes.remembered;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.registry;

namespace abut {

Outcome pair_contacts(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                      const QuerySettings& settings, PairMemory& memory, Manifold& out) {
  const bool from_b = starts_from_b(a, b, pose_a, pose_b);
  const AnyShape &first = from_b ? b : a, &second = from_b ? a : b;
  if (memory.is_from_b != from_b) {
    memory = {};
    memory.is_from_b = from_b;
  }
  const Pose &first_pose = from_b ? pose_b : pose_a, &second_pose = from_b ? pose_a : pose_b;
  const auto& kernels = pair_kernels(first.index(), second.index());
  if (!kernels.gains_from_memory) {
    return kernels.contacts(first, second, first_pose, second_pose, from_b, settings, out);
  }
  const std::size_t begin = out.size();
  const Outcome outcome =
      kernels.contacts_in_frame(first, second, relative(first_pose, second_pose), settings, &memory, out);
  place_contacts(std::span(out).subspan(begin), first_pose, {from_b, a.index() == b.index()});
  memory.is_from_b = from_b;
  return outcome;
}

Outcome pair_distance(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                      const QuerySettings& settings, PairHint& hint, Distance& out) {
  const bool from_b = starts_from_b(a, b, pose_a, pose_b);
  const AnyShape &first = from_b ? b : a, &second = from_b ? a : b;
  const PairKernels<AnyShape>& kernels = pair_kernels(first.index(), second.index());
  const Pose &first_pose = from_b ? pose_b : pose_a, &second_pose = from_b ? pose_a : pose_b;
  if (kernels.distance_from_hint == nullptr) {
    return kernels.distance(first, second, first_pose, second_pose, from_b, settings, out);
  }
  if ((hint.is_from_b != 0) != from_b) {
    swap_sides(hint);
  }
  return kernels.distance_from_hint(first, second, first_pose, second_pose, from_b, settings, hint, out);
}

namespace {

// The features of a hint, as a memory that proves nothing and gets no ball: a ball of this call would be lost.
PairMemory memory_of(const PairHint& hint) {
  PairMemory memory{};
  memory.is_from_b = hint.is_from_b != 0;
  memory.features = {unpacked(hint.features[0]), unpacked(hint.features[1])};
  memory.state = PairMemory::State::touching;
  memory.waits = 1;
  return memory;
}

}  // namespace

// The distance tells shapes that are apart sooner than contacts do, but only with a hint.
Outcome pair_contacts(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                      const QuerySettings& settings, PairHint& hint, Manifold& out) {
  const bool are_hinted =
      pair_kernels(std::min(a.index(), b.index()), std::max(a.index(), b.index())).distance_from_hint != nullptr;
  if (are_hinted && settings.algorithm == Algorithm::automatic && hint.has_contacts == 0) {
    [[clang::uninitialized]] Distance gap;
    const Outcome outcome = pair_distance(a, b, pose_a, pose_b, settings, hint, gap);
    if (outcome == Outcome::ok && gap.lower > settings.margin) {
      return Outcome::ok;
    }
  }
  const std::size_t first = out.size();
  PairMemory memory = memory_of(hint);
  const bool is_known = hint.has_contacts != 0;
  const Outcome outcome = is_known ? pair_contacts(a, b, pose_a, pose_b, settings, memory, out)
                                   : pair_contacts(a, b, pose_a, pose_b, settings, out);
  if (outcome != Outcome::ok) {
    return outcome;
  }
  if (is_known) {
    if (memory.is_from_b != (hint.is_from_b != 0)) {
      swap_sides(hint);
    }
    hint.features = {packed(memory.features.a), packed(memory.features.b)};
  }
  hint.has_contacts = out.size() == first ? 0 : 1;
  return outcome;
}

}  // namespace abut
