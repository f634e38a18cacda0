// SPDX-License-Identifier: Apache-2.0
// Contact response: bodies that push each other.
export module abut.response;
export import :cone;
export import :problem;
