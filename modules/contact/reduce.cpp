module;
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
module abut.contact.reduce;
import abut.math;
import abut.shape;

namespace abut {
namespace {

// SPEC VX-08b: contacts whose normals differ by less than 11.5 degrees hold like one patch.
constexpr Real same_patch_cosine = 0.98;

bool comes_before(const ContactPoint& a, const ContactPoint& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
}

Vec3 middle(const ContactPoint& contact) { return 0.5 * (contact.point_a + contact.point_b); }

// Twice the signed area of a triangle seen against the normal.
Real area(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) { return dot(normal, cross(b - a, c - a)); }

// Moves the best of contacts[from ...] by a score to the front; ties go to the smaller id.
template <class Score>
Real bring_best(std::span<ContactPoint> contacts, std::size_t from, Score&& score) {
  std::size_t best = from;
  Real best_score = -infinity;
  for (std::size_t i = from; i < contacts.size(); ++i) {
    const Real value = score(middle(contacts[i]));
    if (value > best_score || (value == best_score && contacts[i].id < contacts[best].id)) {
      best = i;
      best_score = value;
    }
  }
  std::swap(contacts[from], contacts[best]);
  return best_score;
}

// Twice the area of the quadrilateral of four points in any order: half of the largest cross product of
// two of its lines.
Real quadrilateral(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& normal) {
  const auto turn = [&](const Vec3& p, const Vec3& q) { return std::fabs(dot(normal, cross(p, q))); };
  return std::max({turn(c - a, d - b), turn(b - a, d - c), turn(d - a, c - b)});
}

// Up to this many points all triples beside the deepest are tried: at most 120.
constexpr std::size_t few_points = 11;

// Brings the three points to the front that span the largest area with the deepest, which is first.
void bring_best_three(std::span<ContactPoint> patch) {
  const Vec3 normal = patch[0].normal;
  std::array<Vec3, few_points> points{};
  for (std::size_t i = 0; i < patch.size(); ++i) {
    points[i] = middle(patch[i]);
  }
  std::array<std::size_t, 3> best{1, 2, 3};
  Real best_area = -1;
  for (std::size_t i = 1; i < patch.size(); ++i) {
    for (std::size_t j = i + 1; j < patch.size(); ++j) {
      for (std::size_t k = j + 1; k < patch.size(); ++k) {
        const Real size = quadrilateral(points[0], points[i], points[j], points[k], normal);
        if (size > best_area) {
          best_area = size;
          best = {i, j, k};
        }
      }
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    std::swap(patch[i + 1], patch[best[i]]);  // best rises, so that no chosen point is moved away
  }
}

// The deepest, the one furthest from it, then the ones that add most area on either side of the
// widest line, then on any side of the polygon so far.
std::size_t reduce_patch(std::span<ContactPoint> patch, std::size_t most) {
  if (patch.size() <= most) {
    return patch.size();
  }
  if (most == 4 && patch.size() <= few_points) {
    bring_best_three(patch);
    return 4;
  }
  const Vec3 normal = patch[0].normal;
  const Vec3 first = middle(patch[0]);
  if (most == 1) {
    return 1;
  }
  bring_best(patch, 1, [&](const Vec3& p) { return squared_norm(p - first); });
  const Vec3 second = middle(patch[1]);
  if (most == 2) {
    return 2;
  }
  bring_best(patch, 2, [&](const Vec3& p) { return std::fabs(area(first, second, p, normal)); });
  // A polygon in counter-clockwise order; each further point goes where it adds the most area.
  std::array<Vec3, 64> polygon{first, second, middle(patch[2])};
  if (area(polygon[0], polygon[1], polygon[2], normal) < 0) {
    std::swap(polygon[1], polygon[2]);
  }
  std::size_t kept = 3;
  while (kept < std::min(most, polygon.size())) {
    const auto added = [&](const Vec3& p) {
      std::pair<Real, std::size_t> best{-infinity, 0};
      for (std::size_t i = 0; i < kept; ++i) {
        const Real gain = area(polygon[(i + 1) % kept], polygon[i], p, normal);
        if (gain > best.first) {
          best = {gain, i};
        }
      }
      return best;
    };
    if (!(bring_best(patch, kept, [&](const Vec3& p) { return added(p).first; }) > 0)) {
      break;
    }
    const Vec3 point = middle(patch[kept]);
    const std::size_t after = added(point).second + 1;
    const std::span<Vec3> corners = std::span(polygon).first(kept + 1);
    std::move_backward(corners.begin() + static_cast<std::ptrdiff_t>(after), corners.end() - 1, corners.end());
    corners[after] = point;
    ++kept;
  }
  return kept;
}

}  // namespace

std::size_t reduce(std::span<ContactPoint> contacts, std::size_t most) {
  std::sort(contacts.begin(), contacts.end(), comes_before);
  if (most == 0 || contacts.size() <= most) {
    return contacts.size();
  }
  std::size_t kept = 0;
  std::span<ContactPoint> rest = contacts;
  while (!rest.empty()) {
    std::iter_swap(rest.begin(), std::min_element(rest.begin(), rest.end(), comes_before));
    const Vec3 normal = rest[0].normal;
    const auto end = std::partition(rest.begin(), rest.end(), [&](const ContactPoint& contact) {
      return dot(contact.normal, normal) >= same_patch_cosine;
    });
    const auto count = static_cast<std::size_t>(end - rest.begin());
    std::iter_swap(rest.begin(), std::min_element(rest.begin(), end, comes_before));
    const std::size_t kept_of_patch = reduce_patch(rest.first(count), most);
    for (std::size_t i = 0; i < kept_of_patch; ++i) {
      contacts[kept++] = rest[i];
    }
    rest = rest.subspan(count);
  }
  std::sort(contacts.begin(), contacts.begin() + static_cast<std::ptrdiff_t>(kept), comes_before);
  return kept;
}

}  // namespace abut
