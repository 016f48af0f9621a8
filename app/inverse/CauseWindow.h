// Says which cause explains best how far the scan of a built piece lies from its design.
#pragma once

#include "CauseFinder.h"
#include "Document.h"
#include "FitForm.h"
#include "FormChoice.h"
#include "LatestJob.h"
#include "Selection.h"

#include <QDialog>

#include <memory>
#include <optional>
#include <vector>

class QLabel;
class QTreeWidget;

namespace bolster {

class DesignSession;
class RunRow;

struct CauseMemory;

class CauseWindow : public QDialog {
    Q_OBJECT

public:
    /// Begins as `remembered` says, which says then how it was when it was closed.
    CauseWindow(DesignSession& session, Selection& selection, std::shared_ptr<CauseMemory> remembered,
                QWidget* parent = nullptr);
    ~CauseWindow() override;

    struct Found {
        int number = 0;
        Message problem; ///< why there is no answer; empty when there is one
        Design design;   ///< that the piece was compared with
        std::vector<Cause> causes;
        Explanations explained;
        bool sound = false;   ///< with the scan of a sound piece
        double toNearest = 0; ///< mm, rms, from the cover to the scan's nearest points, as fits measure
    };
    /// The last answer, also while another one is looked for or after that was stopped; nothing before the first.
    const std::optional<Found>& found() const { return m_found; }

private:
    struct Wanted {
        int number = 0;
        SolveInput input;
        FitForm scan, sound;
    };

    static Found explain(const Wanted& wanted, const std::function<void(double)>& progress,
                         const std::stop_token& stop);
    void build();
    void find();
    void stop();
    void take(Found found);
    void show(Found found);
    void fill();
    void say();
    void rowChosen();
    void documentChanged();

    DesignSession& m_session;
    Document& m_document;
    Selection& m_selection;
    std::shared_ptr<CauseMemory> m_remembered;

    FormChoice *m_scan = nullptr, *m_sound = nullptr;
    RunRow* m_run = nullptr;
    QLabel *m_said = nullptr, *m_alike = nullptr;
    QTreeWidget* m_list = nullptr;

    Design m_start; ///< of what is sought
    std::optional<Found> m_found;
    std::vector<std::size_t> m_rows; ///< which of those that are ranked; the list has the first of them
    LatestJob<Wanted, Found> m_job;  ///< last: it uses the others
};

/// What was found, and of which scans: it is there again when the window is.
struct CauseMemory {
    FormChoice::Chosen scan, sound;
    std::optional<CauseWindow::Found> found;
};

} // namespace bolster
