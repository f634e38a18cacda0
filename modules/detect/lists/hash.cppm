// SPDX-License-Identifier: Apache-2.0
// One number for all that a detection found.
export module abut.detect.lists.hash;
import abut.core.standard;
import abut.scene.state.options;

export namespace abut {

// Every bit of all of it counts, in this order, but for generations, which differ from universe to universe.
[[nodiscard]] std::uint64_t hash_of(std::span<const Contact> contacts, std::span<const LocalPoints> locals,
                                    std::span<const Event> events, std::span<const SleepChange> sleep_changes);

}  // namespace abut
