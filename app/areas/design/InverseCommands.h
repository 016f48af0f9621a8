// From what the cover shall be to the pattern.
#pragma once

#include <QCoreApplication>
#include <QList>
#include <QObject>
#include <QPointer>

#include <functional>
#include <memory>
#include <optional>

class QAction;
class QDialog;

namespace bolster {

class Commands;
struct CoverPoint;
class CoverView;
class DesignSession;
struct FitMemory;
struct FormPatternWishes;
class MapLink;
class PatternView;
class Selection;
class SolverLink;
struct CauseMemory;
struct ReliefMemory;
struct SweepWishes;

class InverseCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(InverseCommands)

public:
    struct Parts {
        DesignSession& session;
        Selection& selection;
        SolverLink& solver;
        MapLink& maps;
        PatternView& pattern;
        CoverView& cover;
        QWidget& window;
        std::function<void(const std::optional<CoverPoint>&)> mark; ///< a place in both views, or none
    };
    InverseCommands(Commands& commands, const Parts& parts);
    ~InverseCommands() override;

private:
    void addCommands(Commands& commands);
    QDialog* formWindow();
    /// One of each at a time.
    template <class Make>
    void show(QPointer<QDialog>& dialog, const Make& make);

    Parts m_parts;
    QList<QAction*> m_alsoThere;                     ///< whose keys do in the windows what they do in the main one
    std::shared_ptr<FormPatternWishes> m_formWishes; ///< of the design that is open
    std::shared_ptr<FitMemory> m_fits;               ///< likewise
    std::shared_ptr<SweepWishes> m_sweepWishes;      ///< likewise
    std::shared_ptr<ReliefMemory> m_reliefs;         ///< likewise
    std::shared_ptr<CauseMemory> m_causes;           ///< likewise
    std::unique_ptr<QObject> m_viewOfStep;           ///< of the last pattern that was made of a form
    QPointer<QDialog> m_form, m_fit, m_relief, m_cause, m_sweep;
};

} // namespace bolster
