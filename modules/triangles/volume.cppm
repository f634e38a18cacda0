// SPDX-License-Identifier: Apache-2.0
// The volume that triangles enclose, with a sign.
export module abut.triangles.volume;
import abut.capability;
import abut.core.standard;
import abut.math;

export namespace abut {

// The volume that triangles enclose, positive where they are wound counter-clockwise seen from outside. That of an open
// surface depends on a point, which is the centre of its box; `doubt` is by how much other points of the box change it.
struct EnclosedVolume {
  Real volume = 0;
  Real doubt = 0;
  Aabb box = Aabb::empty();

  // Whether the triangles enclose something, but from inside.
  [[nodiscard]] bool is_inside_out() const;
};
[[nodiscard]] EnclosedVolume enclosed_volume(const Triangles& triangles);

}  // namespace abut
