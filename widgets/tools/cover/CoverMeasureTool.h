// Measures distances on the cover.
#pragma once

#include "CoverTool.h"
#include "PatchPoint.h"

#include <QCoreApplication>

namespace bolster {

/// Two clicks measure the straight way between two points of the cover; a third click begins anew. Enter keeps the
/// measure in the design. Escape gives it up, then the tool.
class CoverMeasureTool : public CoverTool {
    Q_DECLARE_TR_FUNCTIONS(CoverMeasureTool)

public:
    using CoverTool::CoverTool;

    void press(const CoverPointer& pointer) override;
    bool move(const CoverPointer& pointer) override;
    void release(const CoverPointer& pointer) override;
    bool keyPress(const QKeyEvent& event) override;
    bool wants(int key) const override;
    ToolKeys keys() const override;
    bool escape() override;
    void leave() override;

    QString prompt() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    std::optional<SceneNote> note() const override;
    std::vector<SceneLine> guides() const override;

private:
    void find(QPointF pixel);
    std::optional<PatchPoint> end() const;
    std::optional<double> length() const;

    std::optional<PatchPoint> m_first;
    std::optional<PatchPoint> m_second;
    std::optional<PatchPoint> m_next; ///< under the pointer
    QPointF m_pointer;                ///< pixels
    std::optional<QPointF> m_pressed; ///< the left button
};

} // namespace bolster
