// The bodies of a frame in a tree of boxes: a frame may consist of a million of them.
#pragma once

#include "FrameBodies.h"

#include <span>
#include <stop_token>
#include <vector>

namespace bolster {

/// Refers to the bodies, which must live longer.
class BodyTree {
public:
    /// When stopped, bodies are missing.
    explicit BodyTree(std::vector<const FrameBody*> bodies, const std::stop_token& stop = {});

    /// To the nearest point of a body's surface, mm; `within` if none is nearer than that.
    double distance(const Vec3& point, double within) const;
    /// Whether the point lies inside of one of them: its triangles wind around it more than half a time.
    bool contains(const Vec3& point) const;

private:
    /// In the order of a walk that visits parents first; `next` is where the walk goes on behind the subtree.
    struct Node {
        Box3 box;
        const FrameBody* body = nullptr; ///< of a leaf
        int next = 0;
    };

    void build(std::span<const FrameBody*> bodies, const std::stop_token& stop);

    std::vector<Node> m_nodes;
};

} // namespace bolster
