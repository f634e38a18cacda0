// SPDX-License-Identifier: Apache-2.0
// From boxes to pairs of boxes that overlap.
export module abut.broadphase;
export import abut.broadphase.automatic;
export import abut.broadphase.brute;
export import abut.broadphase.hash_grid;
export import abut.broadphase.interface;
export import abut.broadphase.proxy;
export import abut.broadphase.sweep_and_prune;
export import abut.broadphase.tree;
