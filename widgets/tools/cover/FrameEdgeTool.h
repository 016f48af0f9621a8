// Makes fixation curves of the edges of frames.
#pragma once

#include "CoverTool.h"
#include "FrameEdges.h"

#include <QCoreApplication>

#include <memory>

namespace bolster {

/// What can be clicked, mm.
struct OfferedEdges {
    std::vector<FrameEdge> single;
    std::vector<FrameEdge> joined; ///< the same, smooth rows of them as one
};
using OfferedEdgesPtr = std::shared_ptr<const OfferedEdges>;

/// A click on an edge makes a fixation curve of it and of all in which it goes on smoothly, with Ctrl of it alone.
/// The tool stays for the next one; Escape ends it. A drag turns the view.
class FrameEdgeTool : public CoverTool {
    Q_DECLARE_TR_FUNCTIONS(FrameEdgeTool)

public:
    FrameEdgeTool(CoverToolContext& context, OfferedEdgesPtr edges);

    void press(const CoverPointer& pointer) override;
    bool move(const CoverPointer& pointer) override;
    void release(const CoverPointer& pointer) override;
    bool wants(int key) const override;
    bool escape() override;
    void leave() override;

    QString prompt() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    std::vector<SceneLine> guides() const override;

private:
    struct Edges {
        const std::vector<FrameEdge>& edges;
        std::vector<std::pair<Vec3, double>> spheres; ///< middle and radius around each, mm
    };

    static Edges withSpheres(const std::vector<FrameEdge>& edges);
    const FrameEdge* edgeAt(const CoverPointer& pointer) const;
    std::optional<double> depthAt(const FrameEdge& edge, const Vec2& pixel) const;
    bool isHidden(const Vec3& point) const;
    void fix(const FrameEdge& edge);

    OfferedEdgesPtr m_offered;
    Edges m_single, m_joined;
    const FrameEdge* m_hovered = nullptr;
    std::optional<QPointF> m_pressed;
};

} // namespace bolster
