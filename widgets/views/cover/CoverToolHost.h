// The tool of the 3D view, and what it may see of that.
#pragma once

#include "AreaBrushTool.h"
#include "CoverTools.h"
#include "FrameEdgeTool.h"
#include "ScanAlignTool.h"
#include "ToolHost.h"

class QMouseEvent;

namespace bolster {

class CoverMeasures;
class PointerNote;
class SectionHandle;
class ShownScene;

class CoverToolHost : public ToolHostOf<CoverToolKind, CoverTool, CoverToolContext> {
public:
    /// All must outlive it.
    CoverToolHost(Document& document, Selection& selection, ShownScene& shown, const Camera& camera,
                  const SectionHandle& section, const CoverMeasures& measures, QWidget& view);

    /// The next drag cuts away, or keeps, a part of the scan.
    void startScanCut(ElementId scan, bool keep);
    /// The next clicks say where three places of the scan belong.
    void startScanAlign(ElementId scan, ScanAlignTool::Done done, std::vector<ScanMark> marks);
    /// Clicks make fixation curves of these.
    void startFrameEdges(OfferedEdgesPtr edges);
    /// Drags over the cover paint.
    void startAreaBrush(double radius, AreaBrushTool::Take take);
    /// Of the tool, or of the section's handle when the pointer is on it.
    QString prompt() const override;
    QCursor cursor() const;
    void refresh() override;
    /// A key that is the tool's now, whatever the menus say. Other keys end a gesture by keys.
    bool takesShortcut(const QKeyEvent& event);
    /// Selects what lies there, and asks for its menu.
    void rightClick(const QMouseEvent& event);
    /// The menu key.
    void menuKey();
    CoverHit hit(QPointF pixel) const override;

private:
    const Camera& toolCamera() const override { return m_camera; }
    const ViewColors& colors() const override;
    CoverHit ground(QPointF pixel) const override;
    CoverHit solid(QPointF pixel) const override;
    std::optional<Vec3> scanPoint(ElementId scan, QPointF pixel) const override;
    std::optional<CoverFoot> nearest(const Vec3& point, CoverHit::Kind on) const override;
    std::optional<Vec3> onCover(const PatchPoint& point) const override;
    std::optional<PatchPoint> inPattern(const CoverHit& solid) const override;
    const std::vector<std::vector<Vec3>>& catching() const override;
    Vec3 middleOf(ElementId id) const override;

    ShownScene& m_shown;
    const Camera& m_camera;
    const SectionHandle& m_section;
    const CoverMeasures& m_measures;
    PointerNote* m_note; ///< the view's
    std::optional<std::pair<ElementId, int>> m_hoveredPoint;
    bool m_guided = false; ///< the tool's guides are among the lines
};

} // namespace bolster
