// SPDX-License-Identifier: Apache-2.0
// When two surfaces that move and turn first touch.
export module abut.motion.impacts.moving_surfaces;
import abut.motion.impacts.impact_search;
import abut.motion.paths.path;

export namespace abut {

// Of two surfaces, within a span. Goes down both trees at once.
void meet_surfaces(const Subject& a, const Subject& b, const TimeSpan& span, Search& search);

}  // namespace abut
