#include "BodyTree.h"

#include <algorithm>

namespace bolster {

BodyTree::BodyTree(std::vector<const FrameBody*> bodies, const std::stop_token& stop)
{
    std::erase_if(bodies, [](const FrameBody* body) { return body->tree.box().isEmpty(); });
    m_nodes.reserve(2 * bodies.size());
    if (!bodies.empty())
        build(bodies, stop);
}

void BodyTree::build(std::span<const FrameBody*> bodies, const std::stop_token& stop)
{
    const std::size_t self = m_nodes.size();
    m_nodes.emplace_back();
    for (const FrameBody* body : bodies)
        m_nodes[self].box.extend(body->tree.box());
    if (bodies.size() == 1) {
        m_nodes[self].body = bodies.front();
    } else if (!stop.stop_requested()) {
        int axis = 0;
        m_nodes[self].box.sizes().maxCoeff(&axis);
        const auto place = [axis](const FrameBody* body) { return body->tree.box().center()[axis]; };
        const std::size_t half = bodies.size() / 2;
        std::nth_element(bodies.begin(), bodies.begin() + static_cast<std::ptrdiff_t>(half), bodies.end(),
                         [&](const FrameBody* a, const FrameBody* b) { return place(a) < place(b); });
        build(bodies.first(half), stop);
        build(bodies.subspan(half), stop);
    }
    m_nodes[self].next = static_cast<int>(m_nodes.size());
}

double BodyTree::distance(const Vec3& point, double within) const
{
    double best = within;
    for (std::size_t i = 0; i < m_nodes.size();) {
        const Node& node = m_nodes[i];
        if (node.box.exteriorDistance(point) >= best) {
            i = static_cast<std::size_t>(node.next);
            continue;
        }
        if (node.body)
            best = node.body->tree.distance(point, best);
        ++i;
    }
    return best;
}

bool BodyTree::contains(const Vec3& point) const
{
    constexpr double half = 0.5;
    for (std::size_t i = 0; i < m_nodes.size();) {
        const Node& node = m_nodes[i];
        if (!node.box.contains(point)) {
            i = static_cast<std::size_t>(node.next);
            continue;
        }
        if (node.body && node.body->tree.windingNumber(point) > half)
            return true;
        ++i;
    }
    return false;
}

} // namespace bolster
