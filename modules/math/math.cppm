// SPDX-License-Identifier: Apache-2.0
// Numbers, vectors, poses and boxes. The folder is the only one that knows Eigen.
export module abut.math;
export import abut.math.aabb;
export import abut.math.lane_matrix;
export import abut.math.lanes;
export import abut.math.pose;
export import abut.math.principal_axes;
export import abut.math.vec2;
export import abut.math.vec3;
