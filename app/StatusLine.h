// The status bar: what to do next, where the pointer is, and how the surface is doing.
#pragma once

#include "SolverThread.h"

#include <QStatusBar>
#include <QTimer>

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
    void setCoordinates(const QString& text);
    void setSolver(const SolverStatus& status, bool paused);
    void setProblems(int errors, int warnings);
    /// What draws the 3D view, when that is worth a word; "" for none.
    void setRendererNote(const QString& note);

    QString solverText() const;

signals:
    void problemsWanted();

private:
    void showPrompt();

    ElidedLabel* m_promptLabel;
    QToolButton* m_why;
    QLabel* m_coordinates;
    QLabel* m_note;
    QToolButton* m_problems;
    StateDot* m_dot;
    ElidedLabel* m_solver;
    QString m_prompt;
    QString m_flash;
    QString m_reasons; ///< of the flash
    QTimer m_flashTime;
};

} // namespace bolster
