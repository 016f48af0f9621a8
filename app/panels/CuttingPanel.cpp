#include "CuttingPanel.h"

#include "CutLabelWords.h"
#include "Document.h"
#include "Units.h"

#include <QPainter>

namespace bolster {

CuttingPanel::CuttingPanel(const Document& document, QWidget* parent)
    : CutFindingsList(parent)
    , m_document(document)
    , m_job(
          [](const Design& design, const std::stop_token& stop) {
              CutOptions options;
              options.words = cutLabelWords();
              const CutPattern pattern = cutPattern(design, options, stop);
              return Result{design, checkCutting(design, pattern, stop), pattern.pieces.empty()};
          },
          [this](Result result) {
              setFindings(result.design, std::move(result.findings));
              m_known = true;
              m_nothing = result.nothing;
              viewport()->update();
          })
{
    setFrameShape(NoFrame);
    setSpacing(2);
    setToolTip(tr("A double click shows where it is."));
    const auto lookAgain = [this] {
        m_known = false;
        if (isVisible())
            look();
    };
    connect(&document, &Document::changed, this, lookAgain);
    connect(&NumberStyles::instance(), &NumberStyles::changed, this, lookAgain); // findings tell lengths
}

void CuttingPanel::look()
{
    m_job.request(m_document.design());
}

void CuttingPanel::showEvent(QShowEvent* event)
{
    CutFindingsList::showEvent(event);
    if (!m_known)
        look();
}

void CuttingPanel::paintEvent(QPaintEvent* event)
{
    CutFindingsList::paintEvent(event);
    if (count() > 0)
        return;
    QPainter painter(viewport());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(viewport()->rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                     !m_known    ? tr("Looking the pattern over \u2026")
                     : m_nothing ? tr("There is no pattern yet.")
                                 : tr("Nothing to mend: the pattern can be cut."));
}

} // namespace bolster
