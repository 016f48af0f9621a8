// Bring the picture behind the pattern to its size and place.
#pragma once

#include "PatternTool.h"
#include "TypedEntry.h"

#include <QCoreApplication>

namespace bolster {

/// Two clicks on the picture and their true distance, typed: the picture gets that scale, the first point stays.
/// Escape goes back one step, then ends the tool.
class BackgroundScaleTool : public PatternTool {
    Q_DECLARE_TR_FUNCTIONS(BackgroundScaleTool)

public:
    using PatternTool::PatternTool;

    void press(const PatternPointer& pointer) override;
    void move(const PatternPointer& pointer) override;
    bool keyPress(const QKeyEvent& event) override;
    bool wants(int key) const override;
    bool escape() override;

    QString prompt() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void paint(QPainter& painter, const ViewColors& colors) const override;

private:
    void apply();
    double distance() const;

    std::vector<Vec2> m_points; ///< layout mm, at most two
    Vec2 m_pointer = Vec2::Zero();
    TypedEntry m_typed;
};

/// Drags the picture. Escape takes the drag back, then ends the tool.
class BackgroundMoveTool : public PatternTool {
    Q_DECLARE_TR_FUNCTIONS(BackgroundMoveTool)

public:
    using PatternTool::PatternTool;

    void press(const PatternPointer& pointer) override;
    void move(const PatternPointer& pointer) override;
    void release(const PatternPointer&) override { m_pressed.reset(); }
    void doubleClick(const PatternPointer&) override { m_context.endTool(); }
    bool keyPress(const QKeyEvent& event) override;
    bool escape() override;

    QString prompt() const override;
    QCursor cursor() const override { return Qt::SizeAllCursor; }
    void paint(QPainter& painter, const ViewColors& colors) const override;

private:
    std::optional<Vec2> m_pressed; ///< layout mm
    Vec2 m_corner = Vec2::Zero();  ///< of the picture at the press
};

} // namespace bolster
