// Makes the pattern of a form: which form, where it is cut, and how the pieces lie flat, as long as seam lines are
// drawn on it.
#pragma once

#include "Document.h"
#include "FormPatternJob.h"
#include "LatestJob.h"
#include "SurfaceMesh.h"

#include <QDialog>
#include <QVariant>

#include <map>
#include <memory>
#include <optional>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace bolster {

class DesignSession;
class FileChoice;
class FlatPiecesView;
class NumberBox;
class RunningJob;
class SeamLineList;
class ShownScene;
class SolverLink;

/// What the window was filled in with, to be filled in again.
struct FormPatternWishes {
    bool known = false; ///< else what is usual counts
    QVariant form, fabric;
    QString file;
    int grain = 0;
    std::vector<bool> ticks;                      ///< of the ways it is cut
    double angle = 0;                             ///< degrees
    std::map<quint32, Qt::CheckState> lines = {}; ///< by their numbers
};

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
    QWidget* buildWishes();
    QLayout* buildProgress();
    void fillIn(const FormPatternWishes& wishes);
    FormPatternWishes wishes() const;
    std::vector<QCheckBox*> waysToCut() const;
    void fillForms();
    int largestOf(int frames) const;
    void fillFabrics();
    void formChosen();
    void tickLines();
    void ask(bool draft);
    void setRunning(bool running);
    void stop();
    void clear();
    void take(FormMade made);
    void say();
    void showOnForm();
    void tellOfFile();
    void offerOutside();
    void offerToReplace();
    void sayWhatIsFreed();
    void solveCover();
    void make();
    void documentChanged();
    bool isCover() const;
    Fabric fabric() const;
    FormGrain grain() const;
    const Frame* frame() const;
    QString cadFile() const;
    std::shared_ptr<const TriangleMesh> mesh() const;
    ElementId frameId() const;
    ElementPtr frameElement() const;
    ElementPtr frameUnder() const;
    bool takeMesh();
    bool keepsOutside() const;
    Message verb(bool again) const;

    DesignSession& m_session;
    Document& m_document;
    SolverLink& m_solver;
    ShownScene& m_scene;
    std::shared_ptr<FormPatternWishes> m_remembered;
    FileChoice* m_form = nullptr;
    QComboBox *m_fabric = nullptr, *m_grain = nullptr;
    QCheckBox *m_groups = nullptr, *m_faces = nullptr, *m_bends = nullptr, *m_divide = nullptr,
              *m_outside = nullptr, *m_replace = nullptr;
    NumberBox* m_angle = nullptr;
    SeamLineList* m_lines = nullptr;
    FlatPiecesView* m_view = nullptr;
    QLabel *m_said = nullptr, *m_replaceNote = nullptr;
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
    int m_freed = 0;                  ///< curves that hold nothing when patches are replaced
    int m_asked = 0;
    std::unique_ptr<RunningJob> m_running; ///< but for drafts
    bool m_drafted = false;                ///< what was asked for last was a draft
    bool m_upToDate = false;
    QString m_shownFile;                   ///< whose form was told to be seen
    bool m_linesElsewhere = false;         ///< than on the form
    LatestJob<FormWanted, FormMade> m_job; ///< last: they use the others
    LatestJob<FormCoverWanted, FormCover> m_coverJob;
};

} // namespace bolster
