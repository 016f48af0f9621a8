// Makes the pattern of a form: which form, where it is cut, and how the pieces lie flat, as long as seam lines are
// drawn on it.
#pragma once

#include "Document.h"
#include "FormPatternJob.h"
#include "LatestJob.h"
#include "SurfaceMesh.h"

#include <QDialog>

#include <map>
#include <memory>
#include <optional>

class QLabel;
class QPushButton;
class QStackedWidget;

namespace bolster {

class DesignSession;
class FlatPiecesView;
class FormWishesPanel;
struct FormPatternWishes;
struct GuestMarks;
class RunningJob;
class ShownScene;
class SolverLink;

class FormPatternWindow : public QDialog {
    Q_OBJECT

public:
    /// `scene`: where lines show how the form is cut. Begins as `remembered` says, which says then how it was when
    /// it was closed.
    FormPatternWindow(DesignSession& session, SolverLink& solver, ShownScene& scene,
                      std::shared_ptr<FormPatternWishes> remembered, QWidget* parent = nullptr);
    ~FormPatternWindow() override;

    /// What was made of the wishes as they are now, whole; null while it is being made, or cannot be.
    const FormMade* made() const { return m_made && !m_made->draft && m_upToDate ? m_made.get() : nullptr; }

signals:
    /// The form of a file lies there (mm), with the lines along which it is cut.
    void fileLaidFlat(const bolster::Box3& where);
    /// These patches were added, and their cover will lie there (mm): they shall be seen.
    void patternMade(const std::vector<bolster::ElementId>& patches, const bolster::Box3& where);

private:
    void build();
    QLayout* buildProgress();
    void formChosen();
    void ask(bool draft);
    void setRunning(bool running);
    void stop();
    void clear();
    void take(FormMade made);
    void say();
    void showOnForm();
    void addOpenEnds(GuestMarks& marks) const;
    void leadLinesOn();
    void tellOfFile();
    void solveCover();
    void make();
    void documentChanged();
    bool takeMesh();
    Message verb(bool again) const;

    DesignSession& m_session;
    Document& m_document;
    SolverLink& m_solver;
    ShownScene& m_scene;
    std::shared_ptr<FormPatternWishes> m_remembered;
    FormWishesPanel* m_wishes = nullptr;
    FlatPiecesView* m_view = nullptr;
    QLabel* m_said = nullptr;
    QPushButton *m_make = nullptr, *m_stop = nullptr;
    QStackedWidget* m_progress = nullptr;
    QWidget *m_idle = nullptr, *m_busy = nullptr, *m_stopped = nullptr; ///< its pages
    Design m_drawn;                                                     ///< of which the lines are
    std::shared_ptr<const TriangleMesh> m_mesh;
    ElementPtr m_meshOf; ///< the frame that it is of; null: of no frame
    std::shared_ptr<const FormMade> m_made;
    std::optional<FormCover> m_cover; ///< of what was made, when it is known
    bool m_solving = false;           ///< it will be
    bool m_solvedOutside = false;     ///< of the frame
    int m_asked = 0;
    std::unique_ptr<RunningJob> m_running; ///< but for drafts
    bool m_drafted = false;                ///< what was asked for last was a draft
    bool m_upToDate = false;
    QString m_shownFile;                   ///< whose form was told to be seen
    LatestJob<FormWanted, FormMade> m_job; ///< last: they use the others
    LatestJob<FormCoverWanted, FormCover> m_coverJob;
};

} // namespace bolster
