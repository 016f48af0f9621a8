// Proposes changes of the pattern that relieve its cloth, with pictures, and makes those that are wanted.
#pragma once

#include "CoverPlaces.h"
#include "Document.h"
#include "LatestJob.h"
#include "ReliefJob.h"
#include "Selection.h"

#include <QDialog>

#include <functional>

class QCheckBox;
class QFrame;
class QLabel;
class QVBoxLayout;

namespace bolster {

class CoverView;
class DesignSession;
class NumberBox;
class RunRow;

/// What was found, and how it was asked for: it is there again when the window is.
struct ReliefMemory {
    bool ownLimit = false;
    double limit = 0, most = 0; ///< nothing is remembered when they are zero
    Design start;
    std::optional<ReliefFound> found;
    std::optional<Design> made;
};

class ReliefWindow : public QDialog {
    Q_OBJECT

public:
    /// Marks a place in both views, or none.
    using Mark = std::function<void(const std::optional<CoverPoint>&)>;
    /// Begins as `remembered` says, which says then how it was when it was closed.
    ReliefWindow(DesignSession& session, Selection& selection, CoverView& view, Mark mark,
                 std::shared_ptr<ReliefMemory> remembered, QWidget* parent = nullptr);
    ~ReliefWindow() override;

    /// Of the last search, as long as they are of the design as it is.
    const ReliefList* found() const { return m_found && !m_aside ? &m_found->list : nullptr; }

private:
    void build();
    QWidget* buildOrder();
    void recall();
    void find();
    void stop();
    void take(ReliefFound found);
    void showFound();
    void clearCards();
    void unmark();
    QFrame* addCard(const QImage& picture, const QString& title, const QString& more);
    void addRelief(std::size_t place);
    void make(std::size_t place);
    void putAside(const QString& why);
    void documentChanged();

    DesignSession& m_session;
    Document& m_document;
    Selection& m_selection;
    CoverView& m_view;
    Mark m_mark;
    bool m_marked = false;
    std::shared_ptr<ReliefMemory> m_remembered;

    QCheckBox* m_ownLimit = nullptr;
    NumberBox *m_limit = nullptr, *m_most = nullptr;
    RunRow* m_run = nullptr;
    QLabel* m_said = nullptr;
    QWidget* m_cards = nullptr;
    QVBoxLayout* m_rows = nullptr;

    Design m_start; ///< of what is sought or was found
    std::optional<ReliefFound> m_found;
    std::optional<ReliefFound> m_before;        ///< of the same design, until the search has found something
    bool m_aside = false;                       ///< what was found: it is kept for when the design is m_start again
    std::optional<Design> m_made;               ///< what the design has become by a relief of these
    LatestJob<ReliefWanted, ReliefFound> m_job; ///< last: it uses the others
};

} // namespace bolster
