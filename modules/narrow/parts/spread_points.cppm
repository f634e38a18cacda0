// SPDX-License-Identifier: Apache-2.0
// Few of many points that touch a plane or a wall.
export module abut.narrow.parts.spread_points;
import abut.core.standard;
import abut.math;

export namespace abut {

// Of points that lie close together: the lowest one, and of those below a limit the furthest along four directions.
class SpreadPoints {
 public:
  struct Kept {
    std::uint32_t index;
    Real height;
  };
  explicit SpreadPoints(const Vec3& normal) : tangents_(tangents_of(normal)) {}

  void add(std::uint32_t index, const Vec3& point, Real height) {
    const Real first = dot(tangents_.first, point), second = dot(tangents_.second, point);
    const std::array<Real, 5> along{-height, first, -first, second, -second};
    for (std::size_t i = 0; i < along.size(); ++i) {
      if (along[i] > most_[i]) {
        most_[i] = along[i];
        kept_[i] = {index, height};
      }
    }
    is_empty_ = false;
  }
  template <class Visitor>
  void visit(Visitor&& visit) const {
    for (std::size_t i = 0; i < kept_.size() && !is_empty_; ++i) {
      const auto is_same = [&](const Kept& other) { return other.index == kept_[i].index; };
      if (std::ranges::none_of(std::span(kept_).first(i), is_same)) {
        visit(kept_[i]);
      }
    }
  }

 private:
  Tangents tangents_;
  std::array<Real, 5> most_{-infinity, -infinity, -infinity, -infinity, -infinity};
  std::array<Kept, 5> kept_{};
  bool is_empty_ = true;
};

}  // namespace abut
