// SPDX-License-Identifier: Apache-2.0
// When two shapes that move and turn first touch, with proof.
export module abut.motion.time_of_impact;
import abut.capability;
import abut.core.standard;
import abut.math;
export import abut.motion.paths.path;
import abut.pairs.any_shape;

export namespace abut {

enum class ImpactState : std::uint32_t {
  apart,            // they do not touch within the time
  touches,          // they touch, or come as near as the tolerance
  starts_together,  // they touch where the search starts
  undecided,        // the rounds were not enough: apart before `lower`, nothing is known after it
};

// Times run from the begin of the search to the duration of the paths. Before `lower` the shapes are proven to be
// apart, further than the margin. At `upper` they are no further apart than the margin and the tolerance; of what is
// undecided `upper` is the duration.
struct Impact {
  ImpactState state = ImpactState::apart;
  Real lower = 0, upper = 0;
  std::uint32_t rounds = 0;
  // In the world, at `upper`, of shapes that touch. A depth at the start is one of the whole shapes.
  Distance contact{};
  std::uint32_t child_a = 0, child_b = 0;  // of a composite; else 0
  // Of what is undecided: not proven to be apart, but distances at times that are near each other show no touch.
  bool is_seen_free = false;
};

struct ImpactOptions {
  Real tolerance = 0;                // 0: 1e-12 of the size of the shapes
  Real margin = 0;                   // they touch when they come as near as this
  std::uint32_t most_rounds = 1024;  // of each two parts
  Real begin = 0;                    // the search starts at this time
  bool wants_depth = true;           // else the contact of what overlaps at the start may have no normal
};

// A shape on its way.
struct [[gsl::Pointer]] MovingShape {
  const AnyShape& shape;
  const Path& path;
  Aabb box;  // of the shape in its own frame

  MovingShape(const AnyShape& its [[clang::lifetimebound]], const Path& way [[clang::lifetimebound]])
      : MovingShape(its, way, aabb_of(its, Pose::identity())) {}
  MovingShape(const AnyShape& its [[clang::lifetimebound]], const Path& way [[clang::lifetimebound]], const Aabb& own)
      : shape(its), path(way), box(own) {}
};

// Both paths have one duration, and the search begins before its end. Not ok where the two kinds do not meet.
[[nodiscard]] Outcome time_of_impact(const MovingShape& a, const MovingShape& b, const ImpactOptions& options,
                                     Impact& out);

}  // namespace abut
