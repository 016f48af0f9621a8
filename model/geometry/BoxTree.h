// Triangles in a tree of boxes: what TriangleRays and TriangleTree have in common.
#pragma once

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

namespace bolster {

/// The triangles are kept by who uses it, best in order(). Corners that are not finite count for nothing.
template <class Scalar>
class BoxTree {
public:
    using Point = Eigen::Matrix<Scalar, 3, 1>;
    using Triangle = std::array<Point, 3>;
    using Box = Eigen::AlignedBox<Scalar, 3>;

    /// In the order of a walk that visits parents first: a node's first child is the one behind it, the second the
    /// `next` of that one.
    struct Node {
        Box box;
        std::uint32_t first = 0; ///< of its triangles, by their places in order()
        std::uint32_t count = 0; ///< of those
        std::uint32_t next = 0;  ///< the node behind all that belong to this one

        bool isLeaf() const { return count <= mostInLeaf; }
    };

    /// Of these triangles, by their numbers; `cornersOf` gives the Triangle of a number. When stopped it means
    /// nothing.
    template <class Corners>
    void build(const std::vector<std::uint32_t>& triangles, const Corners& cornersOf,
               const std::stop_token& stop = {});
    /// The same tree around moved corners; here `cornersOf` goes by places in order().
    template <class Corners>
    void fit(const Corners& cornersOf);

    const std::vector<Node>& nodes() const { return m_nodes; }
    /// The numbers of the triangles as they stand in the tree.
    const std::vector<std::uint32_t>& order() const { return m_order; }

    /// Visits the triangles of all leaves that are less far than `reach`, which a visit may lower; near ones first.
    /// `distance` of a box is to be infinite where nothing is wanted of it. `visit` takes a place in order(), and
    /// ends the walk when it returns true.
    template <class Distance, class Visit>
    void walk(const Distance& distance, const Scalar& reach, const Visit& visit) const;

private:
    static constexpr std::uint32_t mostInLeaf = 3;

    struct Item {
        Box box;
        Point corners = Point::Zero(); ///< their sum
        std::uint32_t triangle = 0;
    };

    static Box boxOf(const Triangle& corners);
    void split(std::vector<Item>& items, std::uint32_t first, std::uint32_t count, const std::stop_token& stop);

    std::vector<Node> m_nodes;
    std::vector<std::uint32_t> m_order;
};

template <class Scalar>
typename BoxTree<Scalar>::Box BoxTree<Scalar>::boxOf(const Triangle& corners)
{
    Box box;
    for (const Point& corner : corners)
        if (corner.allFinite())
            box.extend(corner);
    return box;
}

template <class Scalar>
template <class Corners>
void BoxTree<Scalar>::build(const std::vector<std::uint32_t>& triangles, const Corners& cornersOf,
                            const std::stop_token& stop)
{
    std::vector<Item> items;
    items.reserve(triangles.size());
    for (const std::uint32_t triangle : triangles) {
        const Triangle corners = cornersOf(triangle);
        Item item{boxOf(corners), Point::Zero(), triangle};
        for (const Point& corner : corners)
            if (corner.allFinite())
                item.corners += corner;
        items.push_back(item);
    }
    m_nodes.clear();
    m_nodes.reserve(triangles.size());
    if (!items.empty())
        split(items, 0, static_cast<std::uint32_t>(items.size()), stop);
    if (stop.stop_requested())
        m_nodes.clear(); // no half of one
    m_order.clear();
    m_order.reserve(items.size());
    for (const Item& item : items)
        m_order.push_back(item.triangle);
}

/// Halves along the longest side of the box.
template <class Scalar>
void BoxTree<Scalar>::split(std::vector<Item>& items, std::uint32_t first, std::uint32_t count,
                            const std::stop_token& stop)
{
    if (stop.stop_requested())
        return;
    const std::size_t self = m_nodes.size();
    Node node{{}, first, count, 0};
    const auto begin = items.begin() + first;
    std::for_each(begin, begin + count, [&](const Item& item) { node.box.extend(item.box); });
    m_nodes.push_back(node);
    if (!node.isLeaf()) {
        Eigen::Index axis = 0;
        node.box.sizes().maxCoeff(&axis);
        const std::uint32_t half = count / 2;
        std::nth_element(begin, begin + half, begin + count,
                         [axis](const Item& a, const Item& b) { return a.corners[axis] < b.corners[axis]; });
        split(items, first, half, stop);
        split(items, first + half, count - half, stop);
    }
    m_nodes[self].next = static_cast<std::uint32_t>(m_nodes.size());
}

template <class Scalar>
template <class Corners>
void BoxTree<Scalar>::fit(const Corners& cornersOf)
{
    for (std::size_t i = m_nodes.size(); i-- > 0;) { // children come after their parent
        Node& node = m_nodes[i];
        node.box.setEmpty();
        if (node.isLeaf()) {
            for (std::uint32_t at = node.first; at < node.first + node.count; ++at)
                node.box.extend(boxOf(cornersOf(at)));
        } else {
            node.box.extend(m_nodes[i + 1].box);
            node.box.extend(m_nodes[m_nodes[i + 1].next].box);
        }
    }
}

template <class Scalar>
template <class Distance, class Visit>
void BoxTree<Scalar>::walk(const Distance& distance, const Scalar& reach, const Visit& visit) const
{
    struct Waiting {
        std::uint32_t node;
        Scalar distance;
    };
    if (m_nodes.empty())
        return;
    std::array<Waiting, 64> waiting; // each level has one at most, and halves the triangles
    std::size_t count = 0;
    waiting[count++] = {0, distance(m_nodes[0].box)};
    while (count > 0) {
        const Waiting now = waiting[--count];
        if (!(now.distance < reach))
            continue;
        const Node& node = m_nodes[now.node];
        if (node.isLeaf()) {
            for (std::uint32_t at = node.first; at < node.first + node.count; ++at)
                if (visit(at))
                    return;
            continue;
        }
        const std::uint32_t left = now.node + 1, right = m_nodes[left].next;
        Waiting near{left, distance(m_nodes[left].box)}, far{right, distance(m_nodes[right].box)};
        if (far.distance <= near.distance)
            std::swap(near, far);
        waiting[count++] = far;
        waiting[count++] = near;
    }
}

} // namespace bolster
