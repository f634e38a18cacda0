// SPDX-License-Identifier: Apache-2.0
// What a detection knows of paths through a step.
export module abut.detect.continuous;
import abut.core.standard;
export import abut.detect.continuous.impacts;
export import abut.detect.continuous.sweeps;

export namespace abut {

// Whether this build follows paths.
inline constexpr bool follows_paths = true;

}  // namespace abut
