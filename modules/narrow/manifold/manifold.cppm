// SPDX-License-Identifier: Apache-2.0
// What happens to manifolds after they were found.
export module abut.narrow.manifold;
export import abut.narrow.manifold.cap;
export import abut.narrow.manifold.reduce;
export import abut.narrow.manifold.reduce_children;
