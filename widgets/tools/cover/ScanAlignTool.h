// Says where places of a scan belong: on the scan, then on a frame or the cover, three times.
#pragma once

#include "CoverTool.h"

#include <QCoreApplication>

#include <functional>
#include <vector>

namespace bolster {

struct Scan;

/// A place of a scan, and where it belongs.
struct ScanMark {
    Vec3 onScan = Vec3::Zero();   ///< units of its file
    Vec3 onTarget = Vec3::Zero(); ///< mm
    bool onFrame = false;         ///< else on the cover
    ElementId frame = noElement;
};

/// After three pairs `done` is called with them, and the tool ends. Backspace takes back the last place, Escape
/// all, then the tool. A drag turns the view.
class ScanAlignTool : public CoverTool {
    Q_DECLARE_TR_FUNCTIONS(ScanAlignTool)

public:
    using Done = std::function<void(ElementId scan, const std::vector<ScanMark>& marks)>;

    /// `marks`: given before; when all are, the last one is to be given again.
    ScanAlignTool(CoverToolContext& context, ElementId scan, Done done, std::vector<ScanMark> marks = {});

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
    bool onTarget() const { return m_begun.has_value(); }
    std::size_t number() const { return m_marks.size() + 1; }
    void takeScan(QPointF pixel);
    void takeTarget(QPointF pixel);
    void takeBack();
    const Scan* scan() const;
    SceneLine ring(const Vec3& centre, double radius, std::size_t pair) const;

    ElementId m_scan;
    Done m_done;
    std::vector<ScanMark> m_marks;
    std::optional<Vec3> m_begun; ///< on the scan, file units: its other place comes next
    std::optional<Vec3> m_next;  ///< under the pointer, mm
    std::optional<QPointF> m_pressed;
    QPointF m_pointer; ///< pixels
};

} // namespace bolster
