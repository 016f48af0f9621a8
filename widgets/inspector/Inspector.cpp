#include "Inspector.h"

#include "Document.h"
#include "ProblemSet.h"
#include "Selection.h"
#include "Units.h"

#include <QApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScrollBar>

namespace bolster {

Inspector::Inspector(Document& document, Selection& selection, ProblemSet& problems, QWidget* parent)
    : QScrollArea(parent)
    , m_forms(document, selection, problems,
              {[this](ElementId id) { emit fileWanted(id); },
               [this](ElementId id, ScanWish wish) { emit scanWish(id, wish); },
               [this](ElementId id, const std::vector<int>& pieces) { emit framePiecesPointedAt(id, pieces); }})
{
    setWidgetResizable(true);
    setFrameShape(NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(&selection, &Selection::changed, this, &Inspector::rebuild);
    connect(&document, &Document::changed, this, &Inspector::refresh);
    connect(&problems, &ProblemSet::changed, this, &Inspector::refresh);
    // What a form was made of (lists of fabrics, of parts) changes only with edits, not while something is dragged.
    connect(&document, &Document::historyChanged, this, [this] {
        const bool typing = isAncestorOf(QApplication::focusWidget());
        if (typing && m_forms.basis() == m_basis)
            return;
        rebuild();
        if (typing)
            m_form->focusFirst();
    });
    connect(&NumberStyles::instance(), &NumberStyles::changed, this, &Inspector::rebuild); // labels have units, too
    rebuild();
}

/// The form goes before what its fields call.
Inspector::~Inspector()
{
    delete takeWidget();
}

void Inspector::focusFirst()
{
    m_form->focusFirst();
}

void Inspector::setScanFigures(std::map<ElementId, ScanFigures> figures)
{
    m_forms.sources().scanFigures = std::move(figures);
    refresh();
}

void Inspector::setFabricPictures(std::map<ElementId, FabricPictures> pictures)
{
    m_forms.sources().fabricPictures = std::move(pictures);
    refresh();
}

void Inspector::setCoverLengths(const std::map<ElementId, double>& lengths)
{
    if (std::exchange(m_forms.sources().coverLengths, lengths) != lengths)
        refresh();
}

/// A frame's file says which parts it has.
void Inspector::setFiles(DesignFiles files)
{
    const bool others = files.meshes != m_forms.sources().files.meshes;
    m_forms.sources().files = std::move(files);
    if (others)
        rebuild();
    else
        refresh();
}

void Inspector::rebuild()
{
    m_form = m_forms.make().release();
    m_basis = m_forms.basis();
    // The form that is replaced may be the sender of what led here.
    if (QWidget* old = takeWidget())
        old->deleteLater();
    setWidget(m_form);
    setMinimumWidth(m_form->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
}

void Inspector::refresh()
{
    if (isVisible())
        m_form->refresh();
}

void Inspector::showEvent(QShowEvent* event)
{
    m_form->refresh();
    QScrollArea::showEvent(event);
}

/// Fields have taken what was typed when Enter comes here, and leave Escape to us.
void Inspector::keyPressEvent(QKeyEvent* event)
{
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (!enter && event->key() != Qt::Key_Escape) {
        QScrollArea::keyPressEvent(event);
        return;
    }
    if (!enter) {
        for (QLineEdit* edit : m_form->findChildren<QLineEdit*>())
            edit->setModified(false);
        m_form->refresh();
    }
    emit typed();
}

void Inspector::changeEvent(QEvent* event)
{
    QScrollArea::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) // icons and notes have colours of their own
        QMetaObject::invokeMethod(this, &Inspector::rebuild, Qt::QueuedConnection);
}

} // namespace bolster
