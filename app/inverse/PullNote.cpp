#include "PullNote.h"

#include "Document.h"
#include "Pulls.h"

#include <algorithm>

namespace bolster {

namespace {

/// With these scans pulling at the cover again, as far as they are still there.
Design withPulls(const Design& design, const std::vector<ElementId>& scans)
{
    Design result = design;
    for (const ElementId id : scans)
        if (const auto* scan = design.find<Scan>(id); scan && !scan->enabled) {
            Scan pulling = *scan;
            pulling.enabled = true;
            result = result.with({{}, {{id, design.element(id), makeElement(std::move(pulling))}}});
        }
    return result;
}

} // namespace

PullNote::PullNote(Document& document, QWidget* parent)
    : QLabel(parent)
    , m_document(document)
{
    setObjectName(QStringLiteral("pull-note"));
    setWordWrap(true);
    setAlignment(Qt::AlignLeft | Qt::AlignTop);
    setTextFormat(Qt::RichText);
    setTextInteractionFlags(Qt::TextBrowserInteraction);
    connect(this, &QLabel::linkActivated, this, &PullNote::switchOver);
    connect(&m_document, &Document::changed, this, &PullNote::refresh);
    refresh();
}

void PullNote::refresh()
{
    const Design& design = m_document.committed();
    const bool pulls = hasPulls(design);
    if (pulls) {
        m_pulling.clear();
        design.each<Scan>([&](ElementId id, const Scan& scan) {
            if (scan.enabled)
                m_pulling.push_back(id);
        });
    }
    const QString words =
        pulls ? tr("The cover in the 3D view is pulled to a scan; here it counts as the pattern alone makes it.")
              : tr("No scan pulls at the cover any more (a step in the history).");
    const QString link = pulls ? tr("Switch the pull off") : tr("Pull again");
    const bool canSwitch =
        std::ranges::any_of(m_pulling, [&](ElementId id) { return design.find<Scan>(id) != nullptr; });
    if (isVisible())
        setMinimumHeight(height()); // what is below does not jump
    setText(canSwitch ? words + QStringLiteral(" <a href=\"pull\">%1</a>").arg(link) : words);
    setVisible(!m_pulling.empty());
}

void PullNote::switchOver()
{
    const Design& design = m_document.committed();
    if (hasPulls(design))
        m_document.commit(editBetween(design, withoutPulls(design),
                                      {QT_TRANSLATE_NOOP("Message", "Let no scan pull at the cover"), {}}));
    else
        m_document.commit(editBetween(design, withPulls(design, m_pulling),
                                      {QT_TRANSLATE_NOOP("Message", "Let the scan pull at the cover again"), {}}));
}

} // namespace bolster
