// SPDX-License-Identifier: Apache-2.0
// What shapes are: capabilities, records and checks.
export module abut.capability;
export import abut.capability.checks;
export import abut.capability.concepts;
export import abut.capability.core_of;
export import abut.capability.edits;
export import abut.capability.frames;
export import abut.capability.part_ball;
export import abut.capability.part_triangle;
export import abut.capability.placed_support;
export import abut.capability.point_core;
export import abut.capability.records;
export import abut.capability.rim;
export import abut.capability.sampled_solid;
export import abut.capability.segment_core;
export import abut.capability.ties;
export import abut.capability.walls;
