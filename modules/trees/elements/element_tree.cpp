// SPDX-License-Identifier: Apache-2.0
module abut.trees.elements.element_tree;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.triangles.elements;
import abut.trees.boxes.bvh;
import abut.trees.volumes.eight_boxes;

namespace abut {
namespace {

using Row = EightBoxes::Floats;
using Rows = std::array<Row, EightBoxes::width>;

constexpr std::size_t vertices_of_task = 8192, leaves_of_task = 512;

[[nodiscard]] [[gnu::always_inline]] inline Row no_row() { return Row(no_sides[0]); }
[[nodiscard]] [[gnu::always_inline]] inline Row merged(Row a, Row b) { return a < b ? a : b; }
// The block of the next lane, of which so many are in use.
template <class Block>
[[nodiscard]] Block& block_of(std::vector<Block>& blocks, std::size_t used) {
  if (used % EightBoxes::width == 0) {
    if constexpr (std::same_as<Block, EightBoxes>) {
      blocks.push_back(EightBoxes::empty());
    } else {
      blocks.push_back(Block());
    }
  }
  return blocks.back();
}
template <std::size_t count>
void add(std::vector<ElementBlock<count>>& blocks, std::size_t& used, std::uint32_t number,
         std::span<const std::uint32_t, count> corners) {
  ElementBlock<count>& block = block_of(blocks, used);
  const std::size_t lane = used++ % EightBoxes::width;
  block.boxes.numbers[lane] = number;
  for (std::size_t i = 0; i < count; ++i) {
    block.corners[i][lane] = corners[i];
  }
}

[[nodiscard]] inline BoxSides sides_of(Row row) { return {row[0], row[1], row[2], row[3], row[4], row[5]}; }

// The first six columns of eight boxes as sides, by turning blocks of one, two and four numbers.
[[gnu::always_inline]] inline void store(const Rows& rows, EightBoxes& out) {
  Rows ones, twos;
  for (std::size_t i = 0; i < 8; i += 2) {
    ones[i] = __builtin_shufflevector(rows[i], rows[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    ones[i + 1] = __builtin_shufflevector(rows[i], rows[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (std::size_t i = 0; i < 8; i += 4) {
    for (std::size_t j = i; j < i + 2; ++j) {
      twos[j] = __builtin_shufflevector(ones[j], ones[j + 2], 0, 1, 8, 9, 4, 5, 12, 13);
      twos[j + 2] = __builtin_shufflevector(ones[j], ones[j + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const Row low = __builtin_shufflevector(twos[i], twos[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    const Row high = __builtin_shufflevector(twos[i], twos[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    out.sides[i] = std::bit_cast<EightBoxes::Side>(low);
    if (i < 2) {
      out.sides[i + 4] = std::bit_cast<EightBoxes::Side>(high);
    }
  }
}

// Numbers of single precision that are not above values - base, and no lower than need be where the difference is
// exact.
[[nodiscard]] [[gnu::always_inline]] inline SingleLanes below(Lanes values, Lanes base) {
  const Lanes difference = values - base, of_base = difference - values;
  const Lanes error = (values - (difference - of_base)) - (base + of_base);
  const Lanes lower = difference - (epsilon * absolute(difference) + std::numeric_limits<Real>::denorm_min());
  return round_down(error < 0 ? lower : difference);
}

}  // namespace

Vec3 origin_for(const Aabb& box) {
  if (!box.is_bounded()) {
    return {0, 0, 0};
  }
  const Real extent = largest_magnitude(box.high - box.low);
  const auto snapped = [&](Real middle) {
    if (!(extent > 0) || !std::isfinite(extent)) {
      return Real{0};
    }
    const int exponent = std::ilogb(extent) + 1;
    const Real multiple = std::ldexp(std::floor(std::ldexp(middle, -exponent) + 0.5), exponent);
    return std::isfinite(multiple) ? multiple : Real{0};
  };
  const Vec3 middle = box.centre();
  return {snapped(middle.x), snapped(middle.y), snapped(middle.z)};
}

// A node whose children are triangles becomes a leaf. Returns the number of the child that the node becomes; one has
// been made for the root.
std::uint32_t ElementTree::take_form(const Bvh& form, std::uint32_t node, std::vector<LeafTriangles>& leaves) {
  EightBoxes its = EightBoxes::empty();
  form.visit_children(node, [&](const EightBoxes& children) { its = children; });
  const bool is_leaf = std::ranges::all_of(
      its.numbers, [](std::uint32_t number) { return EightBoxes::is_item(number) || number == EightBoxes::nobody; });
  if (is_leaf) {
    leaves.push_back(its.numbers);
    return static_cast<std::uint32_t>(leaves.size() - 1) | EightBoxes::item_bit;
  }
  const std::uint32_t made = node == 0 ? 0 : static_cast<std::uint32_t>(nodes_.size());
  if (node != 0) {
    nodes_.push_back(EightBoxes::empty());
  }
  for (std::size_t lane = 0; lane < EightBoxes::width; ++lane) {
    if (its.numbers[lane] != EightBoxes::nobody) {
      const std::uint32_t child = take_form(form, its.numbers[lane], leaves);
      nodes_[made].numbers[lane] = child;
    }
  }
  return made;
}

void ElementTree::add_leaf(const ElementTable& table, std::span<const std::uint32_t> triangles,
                           const LeafTriangles& its) {
  leaves_.push_back(end_of_blocks());
  std::size_t vertices = 0, edges = 0, faces = 0;  // so far
  for (const std::uint32_t number : its) {
    if (number == EightBoxes::nobody) {
      continue;
    }
    const std::uint32_t triangle = EightBoxes::item_of(number);
    const auto corners = triangles.subspan(3 * std::size_t{triangle}).first<3>();
    for (std::size_t i = 0; i < 3; ++i) {
      if (table.owns_corner(triangle, i)) {
        block_of(vertices_, vertices).numbers[vertices % EightBoxes::width] = corners[i];
        ++vertices;
      }
      if (table.owns_edge(triangle, i)) {
        const std::uint32_t edge = table.edges_of(triangle)[i];
        add(edges_, edges, edge, std::span<const std::uint32_t, 2>(table.edges()[edge]));
      }
    }
    if (table.is_face(triangle)) {
      add(faces_, faces, triangle, corners);
    }
  }
}

ElementTree::ElementTree(const ElementTable& table, std::span<const std::uint32_t> triangles,
                         std::span<const Vec3> vertices, const Workers& workers)
    : boxes_(vertices.size()) {
  Aabb around = Aabb::empty();
  for (const Vec3& vertex : vertices) {
    around.include(vertex);
  }
  origin_ = origin_for(around);
  const auto box_of = [&](std::uint32_t triangle) {
    Aabb box = Aabb::empty();
    const auto corners = triangles.subspan(3 * std::size_t{triangle}).first<3>();
    if (corners[0] != corners[1] || corners[1] != corners[2]) {
      for (const std::uint32_t corner : corners) {
        box.include(vertices[corner]);
      }
    }
    return box;
  };
  std::vector<LeafTriangles> leaves;
  nodes_.push_back(EightBoxes::empty());
  if (const std::uint32_t child = take_form(Bvh(around, table.triangle_count(), box_of, workers), 0, leaves);
      EightBoxes::is_item(child)) {
    nodes_[0].numbers[0] = child;
  }
  leaves_.reserve(leaves.size() + 1);
  for (const LeafTriangles& its : leaves) {
    add_leaf(table, triangles, its);
  }
  leaves_.push_back(end_of_blocks());
  vertices_.shrink_to_fit();
  edges_.shrink_to_fit();
  faces_.shrink_to_fit();
}

ElementTree::Leaf ElementTree::end_of_blocks() const {
  return {static_cast<std::uint32_t>(vertices_.size()), static_cast<std::uint32_t>(edges_.size()),
          static_cast<std::uint32_t>(faces_.size()), no_sides};
}

void ElementTree::fit(std::span<const Vec3> start, std::span<const Vec3> end, Real reach, const Workers& workers) {
  // Rounded up, so that boxes are not smaller.
  const auto base_along = [&](Real at) {
    const Real base = reach + at;
    return base - reach == at && base - at == reach ? base : base + epsilon * std::fabs(base);
  };
  const Lanes base_of_low{base_along(origin_.x), base_along(origin_.y), base_along(origin_.z), 0};
  const Lanes base_of_high{base_along(-origin_.x), base_along(-origin_.y), base_along(-origin_.z), 0};
  const Cuts of_vertices = workers.cut(boxes_.size(), vertices_of_task);
  workers.for_each(of_vertices.tasks(), [&](std::size_t task) {
    for (std::size_t i = of_vertices.begin(task); i < of_vertices.end(task); ++i) {
      const Lanes first = lanes_of(start[i]), last = lanes_of(end[i]);
      const SingleLanes low = below(minimum(first, last), base_of_low);
      const SingleLanes high = below(-maximum(first, last), base_of_high);
      boxes_[i] = Row{low[0], low[1], low[2], high[0], high[1], high[2], 0, 0};
    }
  });
  const Cuts of_leaves = workers.cut(leaf_count(), leaves_of_task);
  workers.for_each(of_leaves.tasks(), [&](std::size_t task) {
    for (std::size_t i = of_leaves.begin(task); i < of_leaves.end(task); ++i) {
      fit_leaf(leaves_[i], leaves_[i + 1]);
    }
  });
  fit_nodes();
}

void ElementTree::fit_leaf(Leaf& leaf, const Leaf& next) {
  Row around = no_row();
  const auto fit_block = [&](EightBoxes& boxes, const auto& box_of_lane) {
    Rows rows;
    for (std::size_t lane = 0; lane < EightBoxes::width; ++lane) {
      rows[lane] = boxes.numbers[lane] == EightBoxes::nobody ? no_row() : box_of_lane(lane);
      around = merged(around, rows[lane]);
    }
    store(rows, boxes);
  };
  for (std::size_t i = leaf.vertices; i < next.vertices; ++i) {
    EightBoxes& block = vertices_[i];
    fit_block(block, [&](std::size_t lane) { return boxes_[block.numbers[lane]]; });
  }
  for (std::size_t i = leaf.edges; i < next.edges; ++i) {
    ElementBlock<2>& block = edges_[i];
    fit_block(block.boxes,
              [&](std::size_t lane) { return merged(boxes_[block.corners[0][lane]], boxes_[block.corners[1][lane]]); });
  }
  for (std::size_t i = leaf.faces; i < next.faces; ++i) {
    ElementBlock<3>& block = faces_[i];
    fit_block(block.boxes, [&](std::size_t lane) {
      return merged(merged(boxes_[block.corners[0][lane]], boxes_[block.corners[1][lane]]),
                    boxes_[block.corners[2][lane]]);
    });
  }
  leaf.around = sides_of(around);
}

void ElementTree::fit_nodes() {
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    EightBoxes& node = nodes_[i];
    for (std::size_t lane = 0; lane < EightBoxes::width; ++lane) {
      const std::uint32_t child = node.numbers[lane];
      if (child != EightBoxes::nobody) {
        node.set_sides(lane, EightBoxes::is_item(child) ? leaves_[EightBoxes::item_of(child)].around
                                                        : nodes_[child].sides_around());
      }
    }
  }
}

std::size_t ElementTree::bytes() const {
  return nodes_.capacity() * sizeof(EightBoxes) + leaves_.capacity() * sizeof(Leaf) +
         vertices_.capacity() * sizeof(EightBoxes) + edges_.capacity() * sizeof(ElementBlock<2>) +
         faces_.capacity() * sizeof(ElementBlock<3>) + boxes_.capacity() * sizeof(Row);
}

}  // namespace abut
