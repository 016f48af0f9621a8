// Changes the pattern after a goal: asks, shows what would change, and takes as much of it as is wanted.
#pragma once

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
class QProgressBar;
class QPushButton;
class QSlider;
class QTreeWidget;
class QVBoxLayout;

namespace bolster {

class DesignSession;
class NumberBox;
class RunningJob;
class PatternView;

class PatternFitWindow : public QDialog {
    Q_OBJECT

public:
    PatternFitWindow(DesignSession& session, Selection& selection, PatternView& pattern, QWidget* parent = nullptr);
    ~PatternFitWindow() override;

    /// Whether changes were found that can be taken.
    bool hasFound() const { return m_found.has_value(); }

private:
    void build();
    QWidget* buildGoals();
    QWidget* buildFreedoms();
    QWidget* buildLocks();
    QWidget* buildOutcome();
    void fillForms();
    void chooseFile();
    void find();
    void stop();
    void setRunning(bool running);
    FitOrder order() const;
    FitForm form() const;
    void showProgress(double share, const FitRound& round);
    void take(FitFound found);
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

    QCheckBox* m_lies = nullptr;
    QComboBox* m_form = nullptr;
    QString m_file;
    QCheckBox* m_strained = nullptr;
    NumberBox* m_limit = nullptr;
    QCheckBox *m_outlines = nullptr, *m_foam = nullptr, *m_fixations = nullptr, *m_pressure = nullptr;
    QCheckBox* m_selectedOnly = nullptr;
    QCheckBox *m_lengths = nullptr, *m_straight = nullptr, *m_corners = nullptr;
    NumberBox* m_most = nullptr;
    QPushButton *m_find = nullptr, *m_take = nullptr;
    QProgressBar* m_progress = nullptr;
    QLabel* m_said = nullptr;
    QWidget* m_outcome = nullptr;
    QTreeWidget* m_patches = nullptr;
    QSlider* m_share = nullptr;
    QLabel *m_shareSaid = nullptr, *m_arrowsSaid = nullptr;

    int m_asked = 0;
    bool m_runs = false;
    std::unique_ptr<RunningJob> m_running;
    Design m_start; ///< of what is sought or was found
    std::optional<FitFound> m_found;
    std::optional<Gesture> m_gesture;     ///< while changes are shown
    LatestJob<FitWanted, FitFound> m_job; ///< last: it uses the others
};

} // namespace bolster
