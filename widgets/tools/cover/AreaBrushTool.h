// Paints a part of the cover, with a round brush.
#pragma once

#include "CoverTool.h"

#include <QCoreApplication>

#include <functional>

namespace bolster {

/// A drag paints, with Shift or Ctrl it takes away; plus and minus change the brush. Esc ends.
class AreaBrushTool : public CoverTool {
    Q_DECLARE_TR_FUNCTIONS(AreaBrushTool)

public:
    struct Stamp {
        Vec3 middle = Vec3::Zero(); ///< on the cover, mm
        double radius = 0;          ///< mm
        bool erases = false;
        bool paints = true; ///< else the brush alone has changed
    };
    using Take = std::function<void(const Stamp&)>;
    static constexpr double leastRadius = 5, mostRadius = 500; ///< mm

    AreaBrushTool(CoverToolContext& context, double radius, Take take);

    void press(const CoverPointer& pointer) override;
    bool move(const CoverPointer& pointer) override;
    void release(const CoverPointer& pointer) override;
    void doubleClick(const CoverPointer& pointer) override { press(pointer); }
    bool keyPress(const QKeyEvent& event) override;
    bool wants(int key) const override;
    bool escape() override;
    void leave() override;

    QString prompt() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    std::vector<SceneLine> guides() const override;

private:
    void hover(QPointF pixel);
    void stamp(Qt::KeyboardModifiers modifiers);

    double m_radius;
    Take m_take;
    bool m_painting = false;
    std::optional<CoverFoot> m_under; ///< the pointer
    std::optional<Vec3> m_stampedAt;  ///< last, in this stroke
    QPointF m_strokeAt;               ///< the pointer, where this stroke has come to
};

} // namespace bolster
