// The tool of the pattern view, and what it may see of that.
#pragma once

#include "CoverPlaces.h"
#include "PatternTools.h"
#include "ToolHost.h"

#include <QCoreApplication>

class QContextMenuEvent;

namespace bolster {

class DrawingAids;
class PatternNavigation;
class ShownPattern;

class PatternToolHost : public ToolHostOf<PatternToolKind, PatternTool, PatternToolContext> {
    Q_DECLARE_TR_FUNCTIONS(PatternToolHost)

public:
    /// All must outlive it.
    PatternToolHost(Document& document, Selection& selection, const ShownPattern& shown,
                    const PatternNavigation& navigation, DrawingAids& aids, QWidget& view);

    /// Of the tool; while something is dragged that would break something, what that is.
    QString prompt() const override;
    /// The pointer moves: what lies under it is looked up once. The point of a patch there.
    std::optional<CoverPoint> move(const PatternPointer& pointer);
    /// The right button: the context menu that follows is about what lies there.
    void selectForMenu(QPointF pixel);
    void menu(const QContextMenuEvent& event);
    PatternHit hit(QPointF pixel) const override;

private:
    const PatternScene& scene() const override;
    const PatternTransform& transform() const override;
    bool pointsShown(ElementId id) const override;
    const SnapSettings& snapSettings() const override;
    bool lasso() const override;
    const BackgroundPicture& background() const override;
    void setBackground(const BackgroundPicture& picture) override;
    SurfaceMeshPtr surface() const override;
    const CutPattern* cut() const override;
    bool rightButtonSelects() const;

    const ShownPattern& m_shown;
    const PatternNavigation& m_navigation;
    DrawingAids& m_aids;
    bool m_moving = false;
    mutable std::optional<std::pair<QPointF, PatternHit>> m_hit; ///< while m_moving
};

} // namespace bolster
