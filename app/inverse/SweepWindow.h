// Where a cover varies when tolerances of making do, and which of them matters.
#pragma once

#include "Document.h"
#include "LatestJob.h"
#include "Selection.h"
#include "SweepJob.h"

#include <QDialog>

#include <memory>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QTreeWidget;

namespace bolster {

class DesignSession;
class MapLink;
class NumberBox;
class RunRow;

/// What was drawn, and of what.
struct DrawnPieces {
    Design start;
    Tolerances tolerances;
    std::vector<double> asked;   ///< the numbers that they follow from
    double limit = 0;            ///< mm
    std::vector<QString> titles; ///< of each of them
    std::optional<SweepFound> found;
};

/// What the window was filled in with, to be filled in again, and what came of it.
struct SweepWishes {
    std::vector<double> asked; ///< nothing is remembered when it is empty
    double samples = 0, limit = 0;
    DrawnPieces drawn;
};

class SweepWindow : public QDialog {
    Q_OBJECT

public:
    /// Begins as `remembered` says, which says then how it was when it was closed.
    SweepWindow(DesignSession& session, Selection& selection, MapLink& maps,
                std::shared_ptr<SweepWishes> remembered, QWidget* parent = nullptr);
    ~SweepWindow() override;

    /// What is known of the design as it is.
    const std::optional<SweepFound>& found() const { return m_pieces.found; }

private:
    void build();
    QWidget* buildTolerances();
    QWidget* buildPieces();
    void fillIn(const SweepWishes& wishes);
    void showAgain(const DrawnPieces& drawn);
    std::vector<double> asked() const;
    void wishesChanged();
    void addTolerances();
    QString figuresText() const;
    QString outText() const;
    void find();
    void stop();
    void take(SweepFound found);
    void say();
    void fill();
    void showMap();
    void mapsChanged();
    void rowChosen();
    void forget(const QString& why);
    void documentChanged();

    DesignSession& m_session;
    Document& m_document;
    Selection& m_selection;
    MapLink& m_maps;
    std::shared_ptr<SweepWishes> m_remembered;

    std::vector<NumberBox*> m_spreads; ///< one for each kind of tolerances
    QComboBox* m_drawn = nullptr;
    NumberBox *m_limit = nullptr, *m_samples = nullptr;
    RunRow* m_run = nullptr;
    QLabel* m_said = nullptr;
    QCheckBox* m_shown = nullptr;
    QTreeWidget* m_list = nullptr;

    DrawnPieces m_pieces;                     ///< or what is being drawn
    QString m_lead;                           ///< a line that comes first
    LatestJob<SweepWanted, SweepFound> m_job; ///< last: it uses the others
};

} // namespace bolster
