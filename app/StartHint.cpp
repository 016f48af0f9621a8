#include "StartHint.h"

#include "Document.h"
#include "Icons.h"
#include "Samples.h"
#include "ViewColors.h"

#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace bolster {

namespace {

constexpr qsizetype mostSamples = 7;

} // namespace

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
    auto* title = new QLabel(tr("A new cover"), this);
    QFont font = title->font();
    font.setPointSizeF(font.pointSizeF() * 1.6);
    font.setWeight(QFont::DemiBold);
    title->setFont(font);
    auto* begin = new QLabel(tr("Draw the first patch, import a frame, or open a design:"), this);
    begin->setWordWrap(true);
    auto* look = new QLabel(tr("Or look at a sample:"), this);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 24, 24, 24);
    layout->setSpacing(8);
    layout->addStretch();
    layout->addWidget(title);
    layout->addWidget(begin);
    addBeginning(*layout);
    layout->addSpacing(8);
    layout->addWidget(look);
    const QString muted = mixed(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.55).name();
    const QList<Sample> all = samples();
    for (const Sample& sample : all.first(std::min<qsizetype>(all.size(), mostSamples))) {
        auto* link = new QLabel(QStringLiteral("<a href=\"%1\" style=\"text-decoration: none\">%2</a>"
                                               "<br><span style=\"color: %3\">%4</span>")
                                    .arg(sample.path.toHtmlEscaped(), sample.title.toHtmlEscaped(), muted,
                                         sample.description.toHtmlEscaped()),
                                this);
        link->setWordWrap(true);
        connect(link, &QLabel::linkActivated, this, &StartHint::sampleWanted);
        layout->addWidget(link);
    }
    if (all.size() > mostSamples) {
        auto* more = new QLabel(tr("%1 more are under File > Samples").arg(all.size() - mostSamples), this);
        more->setForegroundRole(QPalette::PlaceholderText);
        layout->addWidget(more);
    }
    layout->addStretch();
}

void StartHint::addBeginning(QBoxLayout& layout)
{
    auto* row = new QHBoxLayout;
    const auto add = [&](const QString& name, const QString& text, void (StartHint::*wanted)()) {
        auto* button = new QPushButton(icon(name), text, this);
        connect(button, &QPushButton::clicked, this, wanted);
        row->addWidget(button);
    };
    add(QStringLiteral("rectangle"), tr("Rectangle"), &StartHint::rectangleWanted);
    add(QStringLiteral("outline"), tr("Outline"), &StartHint::outlineWanted);
    add(QStringLiteral("import-frame"), tr("Frame \u2026"), &StartHint::frameWanted);
    add(QStringLiteral("open"), tr("Open \u2026"), &StartHint::openWanted);
    row->addStretch();
    layout.addLayout(row);
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
