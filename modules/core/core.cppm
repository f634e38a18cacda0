// SPDX-License-Identifier: Apache-2.0
// What every layer stands on.
export module abut.core;
export import abut.core.bug;
export import abut.core.error;
export import abut.core.memory.frozen;
export import abut.core.id;
export import abut.core.memory.lazy;
export import abut.core.result;
export import abut.core.memory.slot_map;
export import abut.core.memory.small_vector;
export import abut.core.workers;
