// SPDX-License-Identifier: Apache-2.0
module abut.narrow.polytope.epa;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.cores.difference;
import abut.narrow.cores.direction_cover;
import abut.narrow.cores.simplex;
import abut.narrow.polytope.depth_descent;
import abut.narrow.polytope.depth_minimum;
import abut.narrow.polytope.points_under;
import abut.narrow.polytope;

namespace abut {
namespace {

constexpr std::size_t minimum_limit = 16;
constexpr Real same_minimum = 1 - 1e-9;  // cosine between normals of one minimum
// After so many vertices Newton's method also starts where the depth is larger by up to this factor. A polytope alone
// proves nothing where many directions are as good.
constexpr std::uint32_t patience = 30;
constexpr Real near_least = 1.25;
// Slivers prove nothing about depths below this share of the size.
constexpr Real sliver_share = 3e-8;
constexpr std::size_t descent_limit = 16;
constexpr Real same_start = 0.97;      // cosine between directions of which one is tried
constexpr Real gain_share = 1.0 / 16;  // of the error: a depth that is less by this much is less

// One search for the least depth. The polytope bounds it from below, and each direction bounds it from above.
class [[gsl::Pointer]] DepthSearch {
 public:
  inline DepthSearch(const Difference& cores, Real error) : cores_(cores), error_(error), noise_(cores.noise()) {}

  [[nodiscard]] EpaResult run(const Simplex& start) {
    [[clang::uninitialized]] Polytope polytope;
    if (const FlatDifference flat = grow(polytope, start); flat.is_flat) {
      return answer_across(flat.normal);
    }
    return is_at_minimum() ? answer_at_minimum() : answer_under(polytope);
  }
  [[nodiscard]] std::optional<LeastOverlap> run_below(Real most) {
    result_.upper = most;
    [[clang::uninitialized]] Polytope polytope;
    LeastOverlap found{};
    if (const FlatDifference flat = grow(polytope, around()); flat.is_flat) {
      const EpaResult across = answer_across(flat.normal);
      found = {across.depth, across.normal};
    } else if (is_at_minimum()) {
      found = {minima_[best_].depth, minima_[best_].normal};
    } else {
      found = {result_.upper, result_.normal};
    }
    return found.depth < most ? std::optional(found) : std::nullopt;
  }

 private:
  // Support points all around, which mostly hold the origin.
  [[nodiscard]] Simplex around() const {
    Simplex simplex;
    for (const Vec3& direction : {Vec3{1, 1, 1}, Vec3{1, -1, -1}, Vec3{-1, 1, -1}, Vec3{-1, -1, 1}}) {
      simplex.push(cores_.vertex_toward(direction));
    }
    return simplex;
  }
  // Grows a polytope until its least face without a proof lies on the boundary, or it is full.
  [[nodiscard]] FlatDifference grow(Polytope& polytope, const Simplex& start) {
    if (cores_.is_curved) {
      cores_.add_balls(noise_, proven_);
    }
    polytope.reset();
    const FlatDifference flat = polytope.start(start, noise_, cores_);
    if (flat.is_flat) {
      return flat;
    }
    while (result_.iterations < Polytope::vertex_limit && push_out(polytope)) {
    }
    const bool is_sliver = result_.upper > noise_ && result_.upper < sliver_share * cores_.size;
    if (cores_.is_curved && (is_open() || is_sliver)) [[unlikely]] {
      descend_from_faces(polytope);
    }
    return flat;
  }
  [[nodiscard]] inline bool is_open() const { return result_.upper - result_.lower > error_; }
  [[nodiscard]] inline Real least_minimum() const { return minima_.empty() ? infinity : minima_[best_].upper; }
  [[nodiscard]] inline bool is_at_minimum() const { return least_minimum() <= result_.upper + error_; }
  inline void set_upper(Real upper, const Vec3& normal) {
    result_.upper = upper;
    result_.normal = normal;
    proven_.set_depth(upper);
  }

  // Whether Newton's method finds a minimum from a direction that was not known.
  [[nodiscard]] bool finds_minimum_near(const Vec3& direction) {
    const auto found = minimum_near(cores_, direction, error_, noise_);
    const auto is_same = [&](const DepthMinimum& known) {
      return dot(known.normal, found->normal) > same_minimum && known.cosine <= found->cosine;
    };
    // Rounding may lead Newton's method astray: the depth of a minimum is the overlap along its normal.
    if (!found || std::ranges::any_of(minima_.span(), is_same) ||
        cores_.depth_along(found->normal) > found->upper + error_ + noise_) {
      return false;
    }
    best_ = found->upper < least_minimum() ? minima_.size() : best_;
    if (found->upper < result_.upper) {
      set_upper(found->upper, found->normal);
    }
    minima_.push_back(*found);
    proven_.add(found->normal, found->cosine);
    return true;
  }

  [[nodiscard]] static inline DifferenceVertex vertex_of(const DepthMinimum& minimum) {
    return {minimum.depth * minimum.normal, minimum.point_a, no_index, no_index};
  }

  // Pushes the least face out to the support point along its normal. False where that proves the depth or is no help.
  [[nodiscard]] bool push_out(Polytope& polytope) {
    const std::size_t face = least_open_face(polytope);
    if (face == Polytope::none) [[unlikely]] {
      return false;
    }
    ++result_.iterations;
    // Face distances only grow; rounding must not make the bound shrink again.
    const Real distance = polytope.distance(face);
    result_.lower = result_.iterations == 1 ? distance : std::fmax(distance, result_.lower);
    const bool is_covered = !(distance < infinity);
    if (is_covered || (is_at_minimum() && !is_open())) {
      return false;
    }
    const Vec3 normal = polytope.normal(face);
    const DifferenceVertex vertex = cores_.vertex_toward(normal);
    const Real reach = dot(normal, vertex.w);
    const bool is_near = result_.iterations > patience && reach < near_least * result_.upper;
    const bool may_be_least = reach < result_.upper + error_ || is_near;
    // Among equal bounds the normal of the latest face, which lies nearest to the boundary.
    const bool is_least = reach <= result_.upper + noise_;
    if (is_least) {
      set_upper(std::fmin(reach, result_.upper), normal);
    }
    last_face_ = face;
    is_on_surface_ = is_least && reach - distance <= error_;
    if (cores_.is_curved && may_be_least && minima_.size() < minimum_limit && finds_minimum_near(normal)) {
      // The point of the minimum, where the face sees it, is worth more than the support point.
      const DifferenceVertex found = vertex_of(minima_[minima_.size() - 1]);
      const bool is_seen = dot(normal, found.w) > distance + noise_;
      return polytope.expand(face, is_seen ? found : vertex, noise_);
    }
    if (!is_open() || reach - distance <= noise_ || polytope.contains(vertex)) {
      return false;
    }
    return polytope.expand(face, vertex, noise_);
  }

  // A direction v with a depth less than `upper` has upper v beyond a face: within the angle of the cosine distance /
  // upper from its normal. A face needs no vertex where all these directions are proven.
  [[nodiscard]] std::size_t least_open_face(Polytope& polytope) const {
    std::size_t face = polytope.least_face();
    while (result_.upper > 0 && polytope.distance(face) < result_.upper - error_ &&
           proven_.holds(polytope.normal(face), (polytope.distance(face) - noise_) / result_.upper)) {
      polytope.hide(face);
      face = polytope.least_face();
    }
    return face;
  }

  // Where no polytope of this size proves the depth, descents from its faces still find it.
  void descend_from_faces(const Polytope& polytope) {
    [[clang::uninitialized]] std::array<Real, Polytope::face_limit> depths;
    const std::span<Real> left = std::span(depths).first(polytope.face_end());
    for (std::size_t i = 0; i < left.size(); ++i) {
      const bool is_open_face = polytope.distance(i) < result_.upper - error_;
      left[i] = is_open_face ? cores_.depth_along(polytope.normal(i)) : infinity;
    }
    [[clang::uninitialized]] SmallVector<Vec3, descent_limit> starts;
    Vec3 next = result_.normal;
    while (starts.size() < descent_limit) {
      if (std::ranges::none_of(starts.span(), [&](const Vec3& start) { return dot(start, next) > same_start; })) {
        starts.push_back(next);
        take(descend(cores_, next, error_, noise_));
      }
      const auto least = std::ranges::min_element(left);
      if (least == left.end() || !(*least < infinity)) {
        return;
      }
      *least = infinity;
      next = polytope.normal(static_cast<std::size_t>(least - left.begin()));
    }
  }
  void take(const Descent& found) {
    // Of equal depths the one whose points are known.
    const Real gain = gain_share * error_;
    if (found.depth < result_.upper + (found.minimum && !is_at_minimum() ? gain : -gain)) {
      set_upper(found.depth, found.normal);
      if (found.minimum) {
        best_ = minima_.size();
        minima_.push_back(*found.minimum);
      }
    }
  }

  [[nodiscard]] EpaResult answer_at_minimum() const {
    const DepthMinimum& least = minima_[best_];
    EpaResult result = with_lower(least.depth);
    result.depth = least.depth;
    result.upper = least.upper;
    result.normal = least.normal;
    result.point_a = least.point_a;
    result.point_b = least.point_b;
    return result;
  }
  // No cap proves more than its own bound.
  [[nodiscard]] EpaResult with_lower(Real most) const {
    EpaResult result = result_;
    for (const DepthMinimum& minimum : minima_.span()) {
      result.lower = std::fmin(result.lower, minimum.lower);
    }
    result.lower = std::fmin(result.lower, most);
    return result;
  }

  // Without volume the depth is zero across the flat, up to the noise that made it flat.
  [[nodiscard]] EpaResult answer_across(const Vec3& normal) const {
    const DifferenceVertex top = cores_.vertex_toward(normal), bottom = cores_.vertex_toward(-normal);
    const Real above = dot(normal, top.w), below = -dot(normal, bottom.w);
    const bool is_up = above <= below;
    EpaResult result{};
    result.normal = is_up ? normal : -normal;
    result.depth = result.upper = is_up ? above : below;
    result.lower = std::fmin(result.depth, 0);
    result.point_a = is_up ? top.a : bottom.a;
    result.point_b = result.point_a - (is_up ? top.w : bottom.w);
    return cores_.is_curved ? with_points(cores_, error_, result).value_or(result) : result;
  }

  [[nodiscard]] EpaResult answer_under(const Polytope& polytope) const {
    EpaResult result = with_lower(result_.upper);
    result.depth = result.upper;
    Witness witness = polytope.witness(last_face_);
    if (cores_.is_curved && !is_on_surface_) {
      // Both cores surely end along the normal.
      const DifferenceVertex end = cores_.vertex_toward(result.normal);
      witness = {end.a, end.a - end.w};
    }
    // The points share what is left between them and the depth, which is less than the error.
    const Vec3 half = (0.5 * (result.depth + dot(witness.b - witness.a, result.normal))) * result.normal;
    result.point_a = witness.a + half;
    result.point_b = witness.b - half;
    if (!cores_.is_curved) {
      return result;
    }
    if (const auto pointed = with_points(cores_, error_, result)) {
      return *pointed;
    }
    if (norm(result.point_b - result.point_a + result.depth * result.normal) > error_) {
      find_points_under(cores_, error_, result);
    }
    return result;
  }

  const Difference& cores_;
  const Real error_, noise_;
  EpaResult result_{0, 0, infinity, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}, 0};
  SmallVector<DepthMinimum, minimum_limit> minima_;
  DirectionCover proven_;
  std::size_t best_ = 0;  // of the minima, the least one
  std::size_t last_face_ = 0;
  bool is_on_surface_ = false;  // the last face, whose normal is that of the result
};

}  // namespace

EpaResult epa(const Difference& cores, Real error, const Simplex& start) {
  return DepthSearch(cores, error).run(start);
}

std::optional<LeastOverlap> least_overlap_below(Real most, const Difference& cores, Real error) {
  return DepthSearch(cores, error).run_below(most);
}

}  // namespace abut
