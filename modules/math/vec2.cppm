// SPDX-License-Identifier: Apache-2.0
// Vectors of a plane.
export module abut.math.vec2;
import abut.core.standard;
import abut.math.vec3;

export namespace abut {

struct Vec2 {
  Real x, y;
};
[[nodiscard]] inline Vec2 operator+(const Vec2& a, const Vec2& b) { return {a.x + b.x, a.y + b.y}; }
[[nodiscard]] inline Vec2 operator-(const Vec2& a, const Vec2& b) { return {a.x - b.x, a.y - b.y}; }
[[nodiscard]] inline Vec2 operator*(Real a, const Vec2& b) { return {a * b.x, a * b.y}; }
[[nodiscard]] inline Real dot(const Vec2& a, const Vec2& b) { return a.x * b.x + a.y * b.y; }
// Positive where b lies to the left of a.
[[nodiscard]] inline Real cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }
// The point at a share t of the way from a to b.
[[nodiscard]] inline Vec2 mix(const Vec2& a, const Vec2& b, Real t) { return a + t * (b - a); }

}  // namespace abut
