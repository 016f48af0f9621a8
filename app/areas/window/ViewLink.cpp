#include "ViewLink.h"

#include "CoverView.h"
#include "PatternView.h"
#include "Selection.h"

#include <QAction>

namespace bolster {

ViewLink::ViewLink(Selection& selection, Selection& coverSelection, PatternView& pattern, CoverView& coverView,
                   const QAction& linked)
    : m_linked(linked)
{
    follow(selection, coverSelection);
    follow(coverSelection, selection);
    connect(&coverView, &CoverView::coverPointed, this, [this, &pattern](const std::optional<CoverPoint>& point) {
        pattern.showPlace(m_linked.isChecked() ? point : std::nullopt);
    });
    connect(&pattern, &PatternView::patchPointed, this, [this, &coverView](const std::optional<CoverPoint>& point) {
        coverView.showPlace(m_linked.isChecked() ? point : std::nullopt);
    });
    connect(&coverView, &CoverView::coverClicked, this, [this, &pattern](const CoverPoint& point) {
        if (m_linked.isChecked())
            pattern.reveal(point);
    });
    connect(&pattern, &PatternView::patchClicked, this, [this, &coverView](const CoverPoint& point) {
        if (m_linked.isChecked())
            coverView.reveal(point);
    });
}

void ViewLink::follow(Selection& from, Selection& to)
{
    connect(&from, &Selection::changed, this,
            [&from, &to] { to.set(from.elements(), from.points(), from.edges()); });
    connect(&from, &Selection::hoverChanged, this, [this, &from, &to] {
        if (m_linked.isChecked())
            to.hover(from.hovered());
    });
}

} // namespace bolster
