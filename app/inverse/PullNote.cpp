#include "PullNote.h"

#include "Document.h"
#include "FitGoals.h"

namespace bolster {

PullNote::PullNote(Document& document, QWidget* parent)
    : QLabel(parent)
    , m_document(document)
{
    setObjectName(QStringLiteral("pull-note"));
    setWordWrap(true);
    setTextFormat(Qt::RichText);
    setTextInteractionFlags(Qt::TextBrowserInteraction);
    connect(this, &QLabel::linkActivated, this, &PullNote::switchOff);
    connect(&m_document, &Document::changed, this, &PullNote::refresh);
    refresh();
}

void PullNote::refresh()
{
    const Design& design = m_document.committed();
    const bool pulls = hasPulls(design);
    m_pulled = m_pulled || pulls;
    setText(
        pulls ? tr("The cover in the 3D view is pulled to a scan; here it counts as the pattern alone makes it.") +
                    QStringLiteral(" <a href=\"off\">%1</a>").arg(tr("Show it without the pull"))
              : tr("No scan pulls at the cover any more. Undo lets it do so again."));
    setVisible(m_pulled); // it keeps its place: what is below does not jump
}

void PullNote::switchOff()
{
    m_document.cancelGesture();
    const Design& design = m_document.committed();
    m_document.commit(editBetween(design, withoutPulls(design),
                                  {QT_TRANSLATE_NOOP("Message", "Let no scan pull at the cover"), {}}));
}

} // namespace bolster
