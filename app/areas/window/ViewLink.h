// What is pointed at in one view is shown in the other, too.
#pragma once

#include <QObject>

class QAction;

namespace bolster {

class PatternView;
class Selection;
class CoverView;

/// `linked` says whether; what is selected is the same in both views in any case.
class ViewLink : public QObject {
public:
    ViewLink(Selection& selection, Selection& coverSelection, PatternView& pattern, CoverView& coverView,
             const QAction& linked);

private:
    void follow(Selection& from, Selection& to);

    const QAction& m_linked;
};

} // namespace bolster
