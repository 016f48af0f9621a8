// The status bar: what to do next, where the pointer is, and how the surface is doing.
#pragma once

#include "CoverFindings.h"
#include "SolverThread.h"

#include <QStatusBar>
#include <QTimer>

#include <functional>
#include <optional>

class QLabel;
class QToolButton;

namespace bolster {

class ElidedLabel;
class StateDot;

class StatusLine : public QStatusBar {
    Q_OBJECT

public:
    explicit StatusLine(QWidget* parent = nullptr);

    /// What the present tool expects next.
    void setPrompt(const QString& prompt);
    /// Takes the prompt's place for some seconds.
    void flash(const QString& message) { flashWithReason(message, {}); }
    /// The same with a button beside it that tells `why`.
    void flashWithReason(const QString& message, const QString& why);
    /// The same after what is being said: what came of a command comes first.
    void flashNext(const QString& message, const QString& why);
    /// It is not so any more.
    void forgetReason();
    /// Asked again when lengths are shown in another unit.
    void setCoordinates(const std::function<QString()>& text);
    /// `preview`: of a change that is not made yet; its cover is looked over when it is.
    void setSolver(const SolverStatus& status, bool paused, bool preview = false);
    /// What there is to worry about in the cover, the worst first. `known`: it is that of the cover that is shown.
    void setFindings(const std::vector<CoverFinding>& findings, bool known);
    void setProblems(int errors, int warnings);
    /// What draws the 3D view, when that is worth a word; "" for none.
    void setRendererNote(const QString& note);

    QString solverText() const;
    /// Of the message that the state says: its key, by which the manual knows it; "" when it says none.
    QString solverKey() const;
    enum class Mood {
        Idle,    ///< grey
        Busy,    ///< amber: not there yet
        Good,    ///< green: nothing to worry about
        Worried, ///< orange
        Failed   ///< red
    };
    Mood mood() const;
    static QColor colorOf(Mood mood);

signals:
    void problemsWanted();
    /// The user wants to see where that is.
    void findingWanted(const bolster::CoverFinding& finding);
    /// Of a failure.
    void culpritWanted(bolster::ElementId element);
    /// What the message with this key means.
    void meaningWanted(const QString& key);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addPrompt();
    void addSolver();
    void connectButtons();
    void showPrompt();
    void showState();
    QString stateText() const;
    QString preparing() const;
    bool restless() const;
    bool finds() const;
    bool blames() const;
    void goThere();
    void fillMenu();

    ElidedLabel* m_promptLabel;
    QToolButton* m_why;
    QLabel* m_coordinates;
    std::function<QString()> m_where;
    QLabel* m_note;
    QToolButton* m_problems;
    StateDot* m_dot;
    ElidedLabel* m_solver;
    QToolButton* m_show;   ///< where the finding is
    QToolButton* m_unrest; ///< why the cover finds no rest
    SolverStatus m_status;
    bool m_paused = false;
    bool m_preview = false;
    std::vector<CoverFinding> m_findings;
    bool m_findingsKnown = false;
    QString m_prompt;
    QString m_flash;
    QString m_reasons; ///< of the flash
    QTimer m_flashTime;
    std::optional<std::pair<QString, QString>> m_next; ///< what is flashed then, and why
};

} // namespace bolster
