// Changes the pattern after a goal: asks, shows what would change, and takes as much of it as is wanted.
#pragma once

#include "AreaRow.h"
#include "Document.h"
#include "Gesture.h"
#include "LatestJob.h"
#include "PatternFitJob.h"
#include "Selection.h"

#include <QDialog>

#include <memory>
#include <optional>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSlider;
class QTreeWidget;
class QVBoxLayout;

namespace bolster {

class DesignSession;
class FormChoice;
class NumberBox;
class PatternView;
class RunRow;

class PatternFitWindow : public QDialog {
    Q_OBJECT

public:
    /// In which one sees and paints.
    struct Views {
        PatternView& pattern;
        AreaRow::Parts cover;
    };
    PatternFitWindow(DesignSession& session, Selection& selection, const Views& views, QWidget* parent = nullptr);
    ~PatternFitWindow() override;

    /// Whether changes were found that can be taken.
    bool hasFound() const { return m_found.has_value(); }

private:
    void build();
    QWidget* buildGoals();
    void addSelectedGoals(QVBoxLayout& rows, QWidget& box);
    QWidget* buildFreedoms();
    QWidget* buildLocks();
    QWidget* buildOutcome();
    void find();
    void stop();
    void setRunning(bool running);
    FitOrder order() const;
    void addSelectedGoals(FitGoals& goals) const;
    /// What is missing for the goals that are ticked; empty when nothing is.
    QString missingGoal(const FitGoals& goals) const;
    void showProgress(double share, const FitRound& round);
    void take(FitFound found);
    void show(FitFound found, const QString& lead);
    void forget(const QString& why);
    void fillPatches();
    Design changedDesign() const;
    void preview();
    void previewEnded();
    void commit();
    void documentChanged();

    DesignSession& m_session;
    Document& m_document;
    Selection& m_selection;
    PatternView& m_pattern;
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
    RunRow* m_run = nullptr;
    QPushButton* m_take = nullptr;
    QLabel* m_said = nullptr;
    QWidget* m_outcome = nullptr;
    QTreeWidget* m_patches = nullptr;
    QSlider* m_share = nullptr;
    QLabel *m_shareSaid = nullptr, *m_arrowsSaid = nullptr;

    Design m_start;     ///< of what is sought or was found
    FitFound m_reached; ///< the best of the present run, until it ends
    std::optional<FitFound> m_found;
    std::optional<Gesture> m_gesture;     ///< while changes are shown
    LatestJob<FitWanted, FitFound> m_job; ///< last: it uses the others
};

} // namespace bolster
