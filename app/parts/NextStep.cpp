#include "NextStep.h"

#include "Document.h"
#include "PatternView.h"

#include <QEvent>

#include <algorithm>

namespace bolster {

namespace {

constexpr int distance = 10; // pixels, from the sides

template <class T, class Test>
bool anyOf(const Design& design, Test test)
{
    bool any = false;
    design.each<T>([&](ElementId, const T& element) { any = any || test(element); });
    return any;
}

template <class T>
bool has(const Design& design)
{
    return anyOf<T>(design, [](const T&) { return true; });
}

} // namespace

FirstStep firstStep(const Design& design)
{
    int patches = 0;
    design.each<Patch>([&](ElementId, const Patch&) { ++patches; });
    const bool fixed = has<FixationSeam>(design), sewn = has<Seam>(design);
    if (patches == 0 || (patches == 1 && fixed))
        return FirstStep::None;
    if (!sewn && !fixed && patches > 1)
        return FirstStep::Sew;
    const bool framed = has<Frame>(design) || has<Foam>(design);
    const FirstStep hold = has<FixationCurve>(design) ? FirstStep::Attach : FirstStep::Fix;
    if (!sewn && !fixed)
        return framed ? hold : FirstStep::Another;
    const bool filled = anyOf<Patch>(design, [](const Patch& patch) { return patch.pressure != 0; });
    if (fixed || filled || has<Cushion>(design))
        return FirstStep::None;
    return framed ? hold : FirstStep::Shape;
}

NextStep::NextStep(Document& document, PatternView& over)
    : QLabel(&over)
    , m_document(document)
    , m_over(over)
{
    setObjectName(QStringLiteral("next-step"));
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Window);
    setFrameShape(QFrame::StyledPanel);
    setMargin(8);
    setTextFormat(Qt::RichText);
    setWordWrap(true);
    setFocusPolicy(Qt::NoFocus);
    setAttribute(Qt::WA_NoMousePropagation); // a press on the link is none on the pattern behind it
    connect(this, &QLabel::linkActivated, this, &NextStep::follow);
    over.installEventFilter(this);
    connect(&document, &Document::historyChanged, this, &NextStep::refresh);
    connect(&over, &PatternView::toolChanged, this, &NextStep::refresh);
    connect(&over, &PatternView::freeRoomChanged, this, &NextStep::place);
    refresh();
}

void NextStep::refresh()
{
    const FirstStep step = firstStep(m_document.design());
    const auto link = [](const QString& name, const QString& text) {
        return QStringLiteral("<a href=\"%1\" style=\"text-decoration: none\">%2</a>").arg(name, text);
    };
    switch (step) {
    case FirstStep::Another:
        setText(tr("Next: %1 for the other side.").arg(link(QStringLiteral("draw"), tr("draw a second patch"))));
        break;
    case FirstStep::Sew:
        setText(tr("Next: %1 \u2013 click an edge, then the edge it is sewn to.")
                    .arg(link(QStringLiteral("sew"), tr("sew the patches"))));
        break;
    case FirstStep::Shape:
        setText(tr("Next: %1 and give them a pressure in the properties.")
                    .arg(link(QStringLiteral("all"), tr("select all patches"))));
        break;
    case FirstStep::Fix:
        setText(tr("Next: %1 \u2013 click points on it, Enter ends \u2013 to which the cover is attached.")
                    .arg(link(QStringLiteral("fix"), tr("draw a fixation curve on the frame"))));
        break;
    case FirstStep::Attach:
        setText(tr("Next: select a fixation curve and %1 to it.")
                    .arg(link(QStringLiteral("attach"), tr("attach an edge"))));
        break;
    case FirstStep::None:
        break;
    }
    setVisible(step != FirstStep::None && m_over.tool() == PatternToolKind::Select);
    place();
}

void NextStep::place()
{
    const QRect room = m_over.freeRoom();
    const int width = std::min(room.width() - 2 * distance, 420);
    resize(width, heightForWidth(width));
    move(room.left() + (room.width() - width) / 2, room.bottom() + 1 - height());
    raise();
}

void NextStep::follow(const QString& link)
{
    if (link == QLatin1String("draw"))
        emit drawWanted();
    else if (link == QLatin1String("sew"))
        emit sewWanted();
    else if (link == QLatin1String("fix"))
        emit fixationWanted();
    else if (link == QLatin1String("attach"))
        emit attachWanted();
    else
        emit selectAllWanted();
}

bool NextStep::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        place();
    return QLabel::eventFilter(watched, event);
}

} // namespace bolster
