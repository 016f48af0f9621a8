// What a fit of the pattern is asked for: goals, what may change, what stays.
#pragma once

#include "AreaRow.h"
#include "FormChoice.h"
#include "PatternFit.h"

#include <QWidget>

#include <functional>

class QCheckBox;
class QComboBox;
class QVBoxLayout;

namespace bolster {

class DesignSession;
class Document;
class NumberBox;
class Selection;

/// What a panel was filled in with, to be filled in again.
struct FitWishes {
    std::vector<bool> ticks;     ///< of all boxes, in their order; none: nothing is remembered
    std::vector<double> numbers; ///< of all fields
    FormChoice::Chosen form;
    std::vector<AreaSpot> spots;
};

class FitOrderPanel : public QWidget {
    Q_OBJECT

public:
    /// Which are ticked.
    struct Goals {
        bool lies = false, strained = false, smooth = false, along = false, sized = false;
    };
    FitOrderPanel(DesignSession& session, Selection& selection, const AreaRow::Parts& cover,
                  QWidget* parent = nullptr);

    Goals goals() const;
    /// That the cover shall lie on; empty when that is no goal.
    FitForm form() const;
    /// Without a target.
    FitOrder order() const;
    /// What is missing; empty when nothing is. May ask for the file of the form, and go on with `then`.
    QString missing(const FitOrder& order, const std::function<void()>& then) const;

    FitWishes wishes() const;
    void fillIn(const FitWishes& wishes);

private:
    QWidget* buildGoals();
    void addSelectedGoals(QVBoxLayout& rows, QWidget& box);
    QWidget* buildFreedoms();
    QWidget* buildLocks();
    void addSelectedGoals(FitGoals& goals) const;

    DesignSession& m_session;
    Document& m_document;
    Selection& m_selection;
    AreaRow* m_area; ///< goals of form and strain count there

    QCheckBox* m_lies = nullptr;
    FormChoice* m_form = nullptr;
    QCheckBox* m_strained = nullptr;
    NumberBox* m_limit = nullptr;
    QCheckBox *m_smooth = nullptr, *m_along = nullptr, *m_sized = nullptr;
    QComboBox* m_curve = nullptr;
    NumberBox* m_size = nullptr;
    QCheckBox *m_outlines = nullptr, *m_seams = nullptr, *m_ease = nullptr, *m_foam = nullptr,
              *m_fixations = nullptr, *m_pressure = nullptr, *m_stretch = nullptr;
    QCheckBox* m_selectedOnly = nullptr;
    QCheckBox *m_lengths = nullptr, *m_straight = nullptr, *m_corners = nullptr;
    NumberBox* m_most = nullptr;
};

} // namespace bolster
