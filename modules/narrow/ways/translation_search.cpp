// SPDX-License-Identifier: Apache-2.0
module abut.narrow.ways.translation_search;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.ways.least_translation;

namespace abut {

void SurfaceExit::stop(const SurfaceTouch& touch) {
  length = touch.length;
  is_stopped = true;
  touches.clear();
  backs.clear();
  touches.push_back(touch);
}

bool SurfaceExit::note(const SurfaceTouch& found, Real tie) {
  if (found.length < length - tie) {
    return false;
  }
  if (found.length > length + tie) {
    touches.clear();
    backs.clear();
  }
  bool is_known = false;
  for (SurfaceTouch& touch : touches.span()) {
    if (dot(touch.normal, found.normal) > same_normal) {
      // Of equal ones the greater normal counts, so that their order has no say.
      const auto key = [](const SurfaceTouch& t) { return std::tuple(t.length, t.normal.x, t.normal.y, t.normal.z); };
      touch = key(found) > key(touch) ? found : touch;
      is_known = true;
    }
  }
  if (!is_known && touches.size() < 8) {
    touches.push_back(found);
  }
  length = std::max(length, found.length);
  return true;
}

void SurfaceExit::settle(Real tie, Real last) {
  const auto all_touches = touches;
  touches.clear();
  for (const SurfaceTouch& touch : all_touches.span()) {
    touches.push_back_if(touch, touch.length >= length - tie);
  }
  std::ranges::sort(touches.span(), [](const SurfaceTouch& a, const SurfaceTouch& b) {
    const auto key = [](const SurfaceTouch& t) { return std::tuple(-t.length, t.normal.x, t.normal.y, t.normal.z); };
    return key(a) < key(b);
  });
  const auto all_backs = backs;
  backs.clear();
  for (const Back& back : all_backs.span()) {
    backs.push_back_if(back, back.length >= length - last);
  }
}

namespace {

constexpr Real end_share = 1e-12;  // of a length: where a search no longer gains
// Cosines between directions: no step, and one that was searched before.
constexpr Real same_step = 1 - 1e-14, known_direction = 1 - 1e-10;

class [[gsl::Pointer]] Search {
 public:
  Search(Obstacles& obstacles, const TranslationSearch& search) : obstacles_(obstacles), search_(search) {
    best_.least = search.least;
  }

  [[nodiscard]] const SeparatingTranslation& find() [[clang::lifetimebound]] {
    most_ = search_.first;
    improve(search_.deepest_way, infinity);
    most_ = search_.most;
    if (!is_settled()) {
      raise_least();
    }
    if (!is_settled()) {
      try_starts();
    }
    for (int i = 0; i < search_.most_polishes && best_.length < infinity && !is_settled(); ++i) {
      const Real before = best_.length;
      improve(best_.direction, 1.5);
      if (!(best_.length < before * (1 - end_share))) {
        break;
      }
    }
    // Where fronts stand in all short ways, a long one is right. Where no way ends in front of all, what is jammed
    // between fronts is told the shortest way that ends behind one.
    most_ = infinity;
    for (const bool allows_back : {false, true}) {
      if (!(best_.length < infinity) && (allows_back || search_.most < infinity)) {
        allows_back_ = allows_back;
        improve(search_.deepest_way, infinity);
        try_starts();
      }
    }
    if (!is_settled()) {
      raise_least();
    }
    return best_;
  }

 private:
  static constexpr std::size_t most_starts = 48;
  using Starts = SmallVector<TranslationStart, most_starts>;

  void raise_least() {
    if (best_.length < infinity) {
      best_.least = std::max(best_.least, obstacles_.least_by(best_));
    }
  }
  [[nodiscard]] bool is_settled() const { return best_.length <= best_.least * (1 + end_share) + search_.tolerance; }

  // Along a direction, then along the shortest translation that leaves all planes touched so far. Goes no further along
  // one than the best so far times `most`.
  void improve(Vec3 direction, Real most) {
    constexpr int most_steps = 8;
    constexpr std::size_t most_planes = 7;
    SmallVector<HalfSpaceToLeave, most_planes> planes;
    for (int step = 0; step < most_steps; ++step) {
      const SurfaceExit exit = obstacles_.exit_along(direction, std::min(best_.length * most, most_));
      const bool is_allowed = exit.backs.empty() || allows_back_;
      if (!exit.is_stopped && is_allowed && exit.length < best_.length) {
        best_.length = exit.length;
        best_.direction = direction;
        best_.ends_behind = !exit.backs.empty();
        best_.touches = exit.touches;
        if (is_settled()) {
          return;
        }
      }
      if (exit.touches.empty() || (exit.is_stopped && most > 1.01)) {
        return;
      }
      // A front is left along its plane at best.
      for (const SurfaceExit::Back& back : exit.backs.span()) {
        if (!allows_back_) {
          add_plane({back.normal, 0}, planes);
        }
      }
      constexpr std::size_t most_touches = 3;
      for (const SurfaceTouch& touch : exit.touches.span().first(std::min(most_touches, exit.touches.size()))) {
        add_plane({touch.normal, dot(touch.normal, direction) * touch.length}, planes);
      }
      const auto move = least_translation(planes.span());
      if (!move || !(norm(*move) < best_.length - search_.tolerance)) {
        return;
      }
      const auto next = UnitVec3::make(*move);
      if (!next || dot(*next, direction) > same_step) {
        return;
      }
      direction = *next;
    }
  }

  static void add_start(const Vec3& direction, Real estimate, Starts& starts) {
    for (TranslationStart& known : starts.span()) {
      if (dot(known.direction, direction) > known_direction) {
        known.estimate = std::max(known.estimate, estimate);
        return;
      }
    }
    if (starts.size() < most_starts) {
      starts.push_back({direction, estimate});
    }
  }

  void try_starts() {
    constexpr std::size_t most_of_many = 8;
    Starts starts;
    const bool are_few = add_planes(starts);
    if (!are_few) {
      starts.clear();
      add_mean_normals(starts);
    }
    const Starts before = starts;
    obstacles_.visit_own_directions(
        are_few, before.span(), [&](const Vec3& direction, Real estimate) { add_start(direction, estimate, starts); });
    try_all(starts, are_few ? starts.size() : most_of_many);
    // Where triangles pass through each other, or stand alone, planes tell little.
    if (best_.length > search_.far * best_.least + search_.tolerance && !(search_.trusts_ground && is_ground())) {
      starts.clear();
      add_single_ways(starts);
      try_all(starts, starts.size());
      try_even_directions();
      try_around_best();
    }
  }
  // Whether the shape lies in many triangles that look about the same way: within 45 degrees of the best direction, or
  // all of its opposite.
  [[nodiscard]] bool is_ground() const {
    constexpr Real least_cosine = 0.7;
    constexpr std::size_t few = 8;
    std::size_t count = 0;
    Real least = 1, most = -1;
    obstacles_.visit_planes([&](const OverlappedPlane& plane) {
      const Real cosine = dot(plane.normal, best_.direction);
      least = std::min(least, cosine);
      most = std::max(most, cosine);
      ++count;
    });
    return count > few && (least >= least_cosine || most <= -least_cosine);
  }
  void try_all(Starts& starts, std::size_t most) {
    std::ranges::sort(starts.span(), [](const TranslationStart& a, const TranslationStart& b) {
      const auto key = [](const TranslationStart& s) {
        return std::tuple(s.estimate, s.direction.x, s.direction.y, s.direction.z);
      };
      return key(a) < key(b);
    });
    for (const TranslationStart& start : starts.span().first(std::min(most, starts.size()))) {
      if (is_settled()) {
        return;
      }
      improve(start.direction, search_.of_start);
    }
  }
  // The ways out of single triangles, deeper ones first.
  void add_single_ways(Starts& starts) const {
    constexpr std::size_t most_ways = 16;
    obstacles_.visit_single_ways([&](const Vec3& way, Real gap) {
      if (starts.size() < most_ways) {
        add_start(way, gap, starts);
      }
    });
  }
  // Points of a spiral around the sphere, about evenly spread.
  void try_even_directions() {
    const int count = search_.most_around;
    constexpr Real golden_cosine = -0.7373688780783197, golden_sine = 0.6754902942615238;  // of the golden angle
    Real cosine = 1, sine = 0;
    for (int i = 0; i < count && !is_settled(); ++i) {
      const Real z = 1 - (2 * i + 1) / Real(count), across = std::sqrt(1 - z * z);
      improve({across * cosine, across * sine, z}, 1.5);
      const Real next = golden_cosine * cosine - golden_sine * sine;
      sine = golden_sine * cosine + golden_cosine * sine;
      cosine = next;
    }
  }

  // Beside the best direction so far, nearer and nearer to it, until the planes that are touched hold it.
  void try_around_best() {
    constexpr Real first = 0.2, near = 0.02, last = 1e-8, least_gain = 1e-6;
    for (Real aside = first; aside > (is_held() ? near : last) && best_.length < infinity && !is_settled();) {
      const Real before = best_.length;
      const Vec3 direction = best_.direction;
      for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        for (const Real step : {-aside, aside}) {
          improve(UnitVec3::make(direction + step * axis).value_or(UnitVec3::from_unit_unchecked(direction)), 1.5);
        }
      }
      aside = best_.length < before * (1 - least_gain) ? aside : 0.5 * aside;
    }
  }
  // Whether no shorter translation leaves the planes that are touched after the best one.
  [[nodiscard]] bool is_held() const {
    SmallVector<HalfSpaceToLeave, 8> planes;
    for (const SurfaceTouch& touch : best_.touches.span()) {
      planes.push_back({touch.normal, dot(touch.normal, best_.direction) * touch.length});
    }
    const auto move = least_translation(planes.span());
    return move && norm(*move) >= best_.length * (1 - share_slack);
  }

  // The planes of what is overlapped, each with how far it is left. False where there are many.
  [[nodiscard]] bool add_planes(Starts& starts) const {
    constexpr std::size_t most_planes = 16;
    obstacles_.visit_planes([&](const OverlappedPlane& plane) {
      if (starts.size() > most_planes || !(squared_norm(plane.normal) > 0)) {
        return;
      }
      add_start(plane.normal, plane.behind, starts);
      if (!plane.is_one_sided || allows_back_) {
        add_start(-plane.normal, plane.before, starts);
      }
    });
    return starts.size() <= most_planes;
  }

  // Of many: the mean normals in cells of the sphere of directions, weighted by area.
  void add_mean_normals(Starts& starts) const {
    constexpr int cells = 4;  // along each side of a cube
    struct Cell {
      Vec3 sum{0, 0, 0};
      Real weight = 0;
    };
    std::array<Cell, 6 * cells * cells> of_cells{};
    const auto cell_of = [](const Vec3& n) {
      const Vec3 size = absolute(n);
      const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
      const auto along = [&](Real coordinate) {
        return std::min(cells - 1, static_cast<int>((coordinate / size[axis] * 0.5 + 0.5) * cells));
      };
      const int side = 2 * axis + (n[axis] > 0 ? 0 : 1);
      return static_cast<std::size_t>((side * cells + along(n[axis == 0 ? 1 : 0])) * cells +
                                      along(n[axis == 2 ? 1 : 2]));
    };
    const auto take = [&](const OverlappedPlane& plane) {
      if (!(squared_norm(plane.normal) > 0)) {
        return;
      }
      const auto add = [&](const Vec3& n) {
        Cell& cell = of_cells[cell_of(n)];
        cell.sum += plane.area * n;
        cell.weight += plane.area;
      };
      add(plane.normal);
      if (!plane.is_one_sided || allows_back_) {
        add(-plane.normal);
      }
    };
    // What holds one reference is passed on without memory of its own.
    obstacles_.visit_planes([&take](const OverlappedPlane& plane) { take(plane); });
    for (const Cell& cell : of_cells) {
      if (const auto mean = UnitVec3::make(cell.sum); mean && cell.weight > 0) {
        add_start(*mean, -cell.weight, starts);
      }
    }
  }

  Obstacles& obstacles_;
  const TranslationSearch& search_;
  bool allows_back_ = false;
  Real most_ = infinity;  // how far a way is followed
  SeparatingTranslation best_;
};

}  // namespace

SeparatingTranslation find_translation(Obstacles& obstacles, const TranslationSearch& search) {
  return Search(obstacles, search).find();
}

}  // namespace abut
