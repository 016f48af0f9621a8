#include "StartHint.h"

#include "Document.h"
#include "Icons.h"
#include "Samples.h"
#include "ViewColors.h"

#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace bolster {

StartHint::StartHint(Document& document, QWidget* over)
    : QWidget(over)
    , m_document(document)
    , m_over(over)
{
    build();
    over->installEventFilter(this);
    connect(&document, &Document::changed, this, &StartHint::place);
    connect(&document, &Document::historyChanged, this, &StartHint::place);
    place();
}

void StartHint::build()
{
    auto* title = new QLabel(tr("Nothing here yet"), this);
    QFont font = title->font();
    font.setPointSizeF(font.pointSizeF() * 1.6);
    font.setWeight(QFont::DemiBold);
    title->setFont(font);
    auto* text = new QLabel(tr("Drop a design here, open one, or look at a sample:"), this);
    text->setWordWrap(true);
    auto* open = new QPushButton(icon(QStringLiteral("open")), tr("Open \u2026"), this);
    connect(open, &QPushButton::clicked, this, &StartHint::openWanted);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 24, 24, 24);
    layout->setSpacing(8);
    layout->addStretch();
    layout->addWidget(title);
    layout->addWidget(text);
    layout->addSpacing(6);
    const QString muted = mixed(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.55).name();
    for (const Sample& sample : samples()) {
        auto* link = new QLabel(QStringLiteral("<a href=\"%1\" style=\"text-decoration: none\">%2</a>"
                                               "<br><span style=\"color: %3\">%4</span>")
                                    .arg(sample.path.toHtmlEscaped(), sample.title.toHtmlEscaped(), muted,
                                         sample.description.toHtmlEscaped()),
                                this);
        link->setWordWrap(true);
        connect(link, &QLabel::linkActivated, this, &StartHint::sampleWanted);
        layout->addWidget(link);
    }
    layout->addSpacing(6);
    layout->addWidget(open, 0, Qt::AlignLeft);
    layout->addStretch();
}

void StartHint::setDrawing(bool drawing)
{
    m_drawing = drawing;
    place();
}

void StartHint::place()
{
    bool begun = false;
    m_document.design().each<Patch>([&](ElementId, const Patch&) { begun = true; });
    m_document.design().each<Frame>([&](ElementId, const Frame&) { begun = true; });
    setVisible(!begun && !m_drawing);
    const QSize room = m_over->size();
    const QSize size(std::min(room.width(), 420), std::min(room.height(), sizeHint().height()));
    setGeometry(QRect(QPoint((room.width() - size.width()) / 2, (room.height() - size.height()) / 2), size));
}

bool StartHint::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        place();
    return QWidget::eventFilter(watched, event);
}

} // namespace bolster
