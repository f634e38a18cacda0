// SPDX-License-Identifier: Apache-2.0
// Contact response: bodies that push each other.
export module abut.response;
export import :cone;
export import :elastic;
export import :grains;
export import :island;
export import :jobs;
export import :link;
export import :mass;
export import :motion;
export import :prism;
export import :problem;
export import :rules;
export import :simulation;
export import :source;
export import :vector;
