// SPDX-License-Identifier: Apache-2.0
#include "manifold.hpp"

#include <algorithm>
#include <cmath>

namespace property {

Manifold contacts_of(const Subject& a, const abut_pose& pose_a, const Subject& b, const abut_pose& pose_b,
                     double margin, std::uint32_t max_contacts) {
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.margin = margin;
  options.max_contacts = max_contacts;
  Manifold manifold;
  std::size_t count = 0;
  manifold.status = abut_pair_contacts(a.shape.get(), &pose_a, b.shape.get(), &pose_b, &options, nullptr, 0, &count);
  if (manifold.status != ABUT_OK) return manifold;
  manifold.contacts.resize(count);
  std::size_t again = 0;
  manifold.status = abut_pair_contacts(a.shape.get(), &pose_a, b.shape.get(), &pose_b, &options,
                                       manifold.contacts.data(), count, &again);
  if (again != count) manifold.status = ABUT_INTERNAL;
  return manifold;
}

namespace {

double turn(const Flat& a, const Flat& b, const Flat& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double polygon_area(const std::vector<Flat>& polygon) {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) twice += turn(polygon[0], polygon[i - 1], polygon[i]);
  return twice / 2;
}

// One chain of the convex hull of sorted points.
void extend_chain(std::vector<Flat>& chain, std::size_t start, const Flat& p) {
  while (chain.size() >= start + 2 && turn(chain[chain.size() - 2], chain.back(), p) <= 0) chain.pop_back();
  chain.push_back(p);
}

}  // namespace

std::vector<Flat> flattened(std::span<const abut_contact> contacts) {
  if (contacts.empty()) return {};
  const oracle::Vec normal = vec_of(contacts.front().normal);
  const oracle::Vec u = oracle::perpendicular(normal);
  const oracle::Vec v = oracle::cross(normal, u);
  const oracle::Vec origin = vec_of(contacts.front().point_a);
  std::vector<Flat> points;
  for (const abut_contact& contact : contacts) {
    const oracle::Vec p = vec_of(contact.point_a) - origin;
    points.push_back({static_cast<double>(oracle::dot(p, u)), static_cast<double>(oracle::dot(p, v))});
  }
  return points;
}

double hull_area(std::vector<Flat> points) {
  if (points.size() < 3) return 0;
  std::sort(points.begin(), points.end());
  std::vector<Flat> chain;
  for (const Flat& p : points) extend_chain(chain, 0, p);
  const std::size_t lower = chain.size() - 1;
  for (auto p = points.rbegin(); p != points.rend(); ++p) extend_chain(chain, lower, *p);
  return polygon_area(chain);
}

namespace {

void choose(const std::vector<Flat>& points, std::size_t next, std::size_t left, std::vector<Flat>& chosen,
            double& best) {
  if (left == 0 || next == points.size()) {
    best = std::max(best, hull_area(chosen));
    return;
  }
  choose(points, next + 1, left, chosen, best);
  chosen.push_back(points[next]);
  choose(points, next + 1, left - 1, chosen, best);
  chosen.pop_back();
}

}  // namespace

double largest_area(const std::vector<Flat>& points, std::size_t count) {
  if (points.empty() || count == 0) return 0;
  std::vector<Flat> chosen{points.front()};
  double best = 0;
  choose(points, 1, count - 1, chosen, best);
  return best;
}

namespace {

std::vector<Flat> cut(const std::vector<Flat>& polygon, const Flat& from, const Flat& to) {
  std::vector<Flat> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Flat& p = polygon[i];
    const Flat& q = polygon[(i + 1) % polygon.size()];
    const double side_p = turn(from, to, p);
    const double side_q = turn(from, to, q);
    if (side_p >= 0) kept.push_back(p);
    if ((side_p > 0 && side_q < 0) || (side_p < 0 && side_q > 0)) {
      const double place = side_p / (side_p - side_q);
      kept.push_back({p[0] + place * (q[0] - p[0]), p[1] + place * (q[1] - p[1])});
    }
  }
  return kept;
}

}  // namespace

std::vector<Flat> overlap(const std::vector<Flat>& polygon, const std::vector<Flat>& window) {
  std::vector<Flat> rest = polygon;
  for (std::size_t i = 0; i < window.size(); ++i) rest = cut(rest, window[i], window[(i + 1) % window.size()]);
  return rest;
}

abut_contact swapped(const abut_contact& contact) {
  abut_contact result = contact;
  std::swap(result.point_a, result.point_b);
  std::swap(result.feature_a, result.feature_b);
  std::swap(result.geometry_a, result.geometry_b);
  result.normal = {-contact.normal.x, -contact.normal.y, -contact.normal.z};
  return result;
}

}  // namespace property
