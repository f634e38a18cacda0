// SPDX-License-Identifier: Apache-2.0
// Everything of abut that a C++ program uses.
export module abut;
export import abut.core;
export import abut.math;
export import abut.capability;
export import abut.pairs.registry;
export import abut.pairs.any_shape;
export import abut.narrow.manifold;
export import abut.queries;
export import abut.universe;
