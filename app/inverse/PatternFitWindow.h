// Changes the pattern after a goal: asks, shows what would change, and takes as much of it as is wanted.
#pragma once

#include "Document.h"
#include "FitOrderPanel.h"
#include "Gesture.h"
#include "LatestJob.h"
#include "PatternFitJob.h"

#include <QDialog>
#include <QTimer>

#include <memory>
#include <optional>

class QLabel;
class QPushButton;
class QSlider;
class QTreeWidget;

namespace bolster {

class ColumnScroll;
class DesignSession;
class NumberBox;
class PatternView;
class RunRow;
class Selection;

/// How changes were asked for, and what was found: it is there again when the window is.
struct FitMemory {
    FitWishes wishes;
    Design start;
    FitWanted wanted;
    FitOrderPanel::Goals sought;
    std::optional<FitFound> found;
    QString lead;
    std::optional<FitFigures> whole;
    std::optional<Design> taken;
    std::optional<FitFigures> takenFigures;
};

class PatternFitWindow : public QDialog {
    Q_OBJECT

public:
    /// In which one sees and paints.
    struct Views {
        PatternView& pattern;
        AreaRow::Parts cover;
    };
    /// Begins as `remembered` says, which says then how it was when it was closed.
    PatternFitWindow(DesignSession& session, Selection& selection, const Views& views,
                     std::shared_ptr<FitMemory> remembered, QWidget* parent = nullptr);
    ~PatternFitWindow() override;

    /// Whether changes were found that can be taken.
    bool hasFound() const { return m_found && !m_aside; }

private:
    void build();
    void fitScreen();
    QWidget* buildOutcome();
    QLayout* buildShare();
    void find();
    void stop();
    void setRunning(bool running);
    void showProgress(double share, const FitRound& round);
    void take(FitFound found);
    void show(FitFound found, const QString& lead, const std::optional<FitFigures>& whole);
    void say(const std::optional<FitFigures>& now);
    QStringList figures(const std::optional<FitFigures>& now) const;
    QStringList notes(const FitFigures& now) const;
    QString missText(MissedGoal::Kind kind) const;
    QString formName() const;
    QString overText(bool few) const;
    Message verb() const;
    bool showsAll() const;
    QString lead() const;
    void measure();
    void endMeasuring();
    void takePart(const PartFound& found);
    void forget(const QString& why);
    void putAside(const QString& why);
    void showNothing(const QString& why);
    void fillPatches();
    void showShare(int percent);
    void sayMoves();
    Design changedDesign() const;
    Design designWith(const Eigen::VectorXd& values) const;
    void preview();
    void previewEnded();
    void commit();
    QString takenText() const;
    void documentChanged();
    void comeBack();
    void recall();

    DesignSession& m_session;
    Document& m_document;
    PatternView& m_pattern;

    FitOrderPanel* m_order;
    ColumnScroll* m_scroll = nullptr;
    std::shared_ptr<FitMemory> m_remembered;
    RunRow* m_run = nullptr;
    QPushButton* m_take = nullptr;
    QLabel *m_said = nullptr, *m_notes = nullptr;
    QWidget* m_outcome = nullptr;
    QTreeWidget* m_patches = nullptr;
    QSlider* m_share = nullptr;
    NumberBox* m_percent = nullptr; ///< the same
    QLabel* m_arrowsSaid = nullptr;

    Design m_start;     ///< of what is sought or was found
    FitWanted m_wanted; ///< of the present or last run
    FitOrderPanel::Goals m_sought;
    FitFound m_reached; ///< the best of the present run, until it ends
    std::optional<FitFound> m_found;
    QString m_lead;                             ///< to the figures of all that was found
    std::optional<FitFigures> m_whole, m_shown; ///< of all of it, and of what is shown
    bool m_aside = false;                       ///< what was found: it is kept for when the design is m_start again
    int m_shareBefore = 0;                      ///< %, when what was shown was taken back
    std::optional<Design> m_taken;              ///< what the design has become, until something else is sought
    std::optional<FitFigures> m_takenFigures;
    std::optional<Gesture> m_gesture;     ///< while changes are shown
    QTimer m_slider;                      ///< since something else is shown
    int m_part = 0;                       ///< number of what is shown
    LatestJob<FitWanted, FitFound> m_job; ///< last: they use the others
    LatestJob<PartWanted, PartFound> m_measuring;
};

} // namespace bolster
