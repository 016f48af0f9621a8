// Cuts away what a rectangle in the 3D view covers, or keeps only that.
#pragma once

#include "CoverTool.h"

#include <QCoreApplication>

namespace bolster {

/// One drag, seen through to the far side of the scan; Escape or a click without a drag ends without a cut.
class ScanCutTool : public CoverTool {
    Q_DECLARE_TR_FUNCTIONS(ScanCutTool)

public:
    ScanCutTool(CoverToolContext& context, ElementId scan, bool keep);

    void press(const CoverPointer& pointer) override;
    bool move(const CoverPointer& pointer) override;
    void release(const CoverPointer& pointer) override;
    bool escape() override;

    QString prompt() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    std::vector<SceneLine> guides() const override;

private:
    /// Of the rectangle, around it.
    std::array<Vec2, 4> corners() const;
    void cut();

    ElementId m_scan;
    bool m_keep;
    std::optional<QPointF> m_from;
    QPointF m_to;
};

} // namespace bolster
