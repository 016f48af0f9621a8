// Where a cover varies when tolerances of making do, and which of them matters.
#pragma once

#include "Document.h"
#include "LatestJob.h"
#include "Selection.h"
#include "SweepJob.h"

#include <QDialog>

#include <optional>

class QCheckBox;
class QComboBox;
class QLabel;
class QTreeWidget;

namespace bolster {

class DesignSession;
class MapLink;
class NumberBox;
class RunRow;

class SweepWindow : public QDialog {
    Q_OBJECT

public:
    SweepWindow(DesignSession& session, Selection& selection, MapLink& maps, QWidget* parent = nullptr);
    ~SweepWindow() override;

    /// What is known of the design as it is.
    const std::optional<SweepFound>& found() const { return m_found; }

private:
    void build();
    QWidget* buildTolerances();
    QWidget* buildPieces();
    void addTolerances();
    QString figuresText() const;
    QString outText() const;
    void find();
    void stop();
    void take(SweepFound found);
    void say(const QString& lead = {});
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

    std::vector<NumberBox*> m_spreads; ///< one for each kind of tolerances
    QComboBox* m_drawn = nullptr;
    NumberBox *m_limit = nullptr, *m_samples = nullptr;
    RunRow* m_run = nullptr;
    QLabel* m_said = nullptr;
    QCheckBox* m_shown = nullptr;
    QTreeWidget* m_list = nullptr;

    Design m_start;                ///< of what is sought or was found
    Tolerances m_tolerances;       ///< that were asked for
    std::vector<double> m_asked;   ///< the numbers that they follow from
    double m_limitAsked = 0;       ///< mm
    std::vector<QString> m_titles; ///< of each of them
    std::optional<SweepFound> m_found;
    LatestJob<SweepWanted, SweepFound> m_job; ///< last: it uses the others
};

} // namespace bolster
