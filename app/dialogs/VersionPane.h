// One version of a design, in 2D and 3D, to look at.
#pragma once

#include "Document.h"
#include "FabricMaps.h"
#include "ProblemSet.h"
#include "Selection.h"
#include "SurfaceMesh.h"

#include <QWidget>

#include <map>
#include <memory>

class QLabel;
class QSplitter;

namespace bolster {

class PatternView;
class CoverLink;
class RestingCache;
class SolverLink;
class CoverView;
struct DesignFiles;

/// Pointer and keys move what is shown, but change nothing.
class VersionPane : public QWidget {
    Q_OBJECT

public:
    /// `kept`: what another solver has solved already.
    explicit VersionPane(std::shared_ptr<RestingCache> kept = nullptr, QWidget* parent = nullptr);
    ~VersionPane() override;

    void setVersion(const QString& title, const Design& design, const DesignFiles& files);
    /// Of the same version, more of them.
    void setFiles(const DesignFiles& files);
    /// What its fabrics look like, as far as that is known by now.
    void setFabrics(std::map<ElementId, FabricMapsPtr> fabrics);
    /// It shows the design of that solver: nothing is computed here.
    void follow(SolverLink& solver);
    /// For looking at fabrics: most of the room for the cover, without what holds it; the title is said elsewhere.
    void showForLooks();
    const Design& design() const { return m_document.design(); }
    Selection& selection() { return m_selection; }
    CoverView& coverView() { return *m_coverView; }
    PatternView& pattern() { return *m_pattern; }
    /// All that is shown in 3D, mm; empty when nothing is.
    Box3 box() const;
    /// So that this is seen, too.
    void fitCover(const Box3& with);

signals:
    /// The first one of this version; it is seen whole.
    void coverCame();

protected:
    bool eventFilter(QObject* view, QEvent* event) override;

private:
    void showSurface(const SurfaceMeshPtr& surface);
    void showState();

    Document m_document;
    Selection m_selection;
    ProblemSet m_problems;
    std::unique_ptr<SolverLink> m_solver;
    std::unique_ptr<CoverLink> m_covers;
    SolverLink* m_followed = nullptr;
    QLabel* m_title;
    QLabel* m_computing; ///< over the 3D view: what is seen there is not yet the cover
    QSplitter* m_views;
    PatternView* m_pattern;
    CoverView* m_coverView;
    bool m_fitCover = false;
};

} // namespace bolster
