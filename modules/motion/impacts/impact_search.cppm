// SPDX-License-Identifier: Apache-2.0
// The search for the first of all touches of parts, as far as it has come.
export module abut.motion.impacts.impact_search;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.motion.impacts.best_impact;
import abut.motion.impacts.convex_impact;
import abut.motion.paths.path;
import abut.motion.time_of_impact;
import abut.motion.impacts.whole_impact;
import abut.pairs.shape_handle;

export namespace abut {

// A shape on a body, and which child it is of the whole.
struct [[gsl::Pointer]] Subject {
  const AnyShape& shape;
  Carrier on;
  std::uint32_t child;
  Aabb box;  // in the frame of the body
};

inline void turn_over(Impact& impact) {
  std::swap(impact.contact.point_a, impact.contact.point_b);
  impact.contact.normal = -impact.contact.normal;
  std::swap(impact.child_a, impact.child_b);
}

struct Search {
  ImpactSettings settings;
  Real begin;
  BestImpact best;
  Outcome outcome = Outcome::ok;  // of all two parts; ok where any could be asked
  bool has_answer = false;
  bool is_turned_over = false;  // whether what is a now was b in the question

  void add(Outcome asked, Impact impact, std::uint32_t child_a, std::uint32_t child_b) {
    outcome = has_answer ? Outcome::ok : asked;
    if (asked != Outcome::ok) {
      return;
    }
    has_answer = true;
    impact.child_a = child_a;
    impact.child_b = child_b;
    if (is_turned_over) {
      turn_over(impact);
    }
    best.add(impact);
  }
  [[nodiscard]] TimeSpan span() const { return {begin, best.end()}; }
  [[nodiscard]] Real slack() const { return settings.margin + settings.tolerance + noise_of(settings.size); }
};

// Two convex parts, of which each is a child of a shape.
void meet_parts(const MovingPair& pair, const TimeSpan& span, std::uint32_t child_a, std::uint32_t child_b,
                Search& search);

}  // namespace abut
