#include "StartHint.h"

#include "Document.h"
#include "Icons.h"
#include "PatternView.h"
#include "RecentFiles.h"
#include "Samples.h"
#include "ViewColors.h"

#include <QBoxLayout>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>

#include <algorithm>

namespace bolster {

namespace {

constexpr qsizetype mostSamples = 7;
constexpr qsizetype mostFiles = 5;
constexpr int widest = 420; // pixels
constexpr int widestName = 220;

} // namespace

StartHint::StartHint(Document& document, PatternView& over)
    : QWidget(&over)
    , m_document(document)
    , m_over(over)
{
    setAttribute(Qt::WA_NoMousePropagation); // a press on a link is none on the pattern behind it
    build();
    over.installEventFilter(this);
    connect(&over, &PatternView::freeRoomChanged, this, &StartHint::place);
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

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 24, 24, 24);
    layout->setSpacing(8);
    layout->addStretch();
    layout->addWidget(title);
    layout->addWidget(begin);
    addBeginning(*layout);
    layout->addStretch();
    fillLists();
}

/// They may be others than at the last time.
void StartHint::fillLists()
{
    auto* outer = static_cast<QVBoxLayout*>(layout());
    if (m_lists) {
        m_lists->hide();
        m_lists->deleteLater(); // a link in it may have asked for this
    }
    m_lists = new QWidget(this);
    auto* lists = new QVBoxLayout(m_lists);
    lists->setContentsMargins(0, 8, 0, 0);
    const QStringList recent = recentFiles::all().mid(0, mostFiles);
    if (!recent.isEmpty())
        addRecent(*lists, recent);
    addSamples(*lists, mostSamples - (recent.size() + 1) / 2);
    outer->insertWidget(outer->count() - 1, m_lists);
    m_lists->show();
    place();
}

QString StartHint::muted() const
{
    return mixed(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.55).name();
}

void StartHint::addRecent(QVBoxLayout& layout, const QStringList& files)
{
    auto* title = new QHBoxLayout;
    title->addWidget(new QLabel(tr("Go on with:"), m_lists));
    title->addStretch();
    auto* clear = new QLabel(QStringLiteral("<a href=\"clear\" style=\"text-decoration: none; color: %1\">%2</a>")
                                 .arg(muted(), tr("Clear this list").toHtmlEscaped()),
                             m_lists);
    clear->setTextFormat(Qt::RichText);
    clear->setObjectName(QStringLiteral("clear-recent"));
    connect(clear, &QLabel::linkActivated, this, [this] {
        recentFiles::clear();
        fillLists();
    });
    title->addWidget(clear);
    layout.addLayout(title);
    for (const QString& file : files) {
        const QString name = fontMetrics().elidedText(QFileInfo(file).fileName(), Qt::ElideMiddle, widestName);
        auto* link =
            new QLabel(QStringLiteral("<a href=\"%1\" style=\"text-decoration: none\">%2</a>&nbsp; "
                                      "<span style=\"color: %3\">%4</span>")
                           .arg(file.toHtmlEscaped(), name.toHtmlEscaped(), muted(),
                                recentFiles::folderText(file, fontMetrics(),
                                                        widest - 56 - fontMetrics().horizontalAdvance(name))
                                    .toHtmlEscaped()),
                       m_lists);
        link->setTextFormat(Qt::RichText);
        link->setToolTip(QDir::toNativeSeparators(file));
        link->setObjectName(QStringLiteral("recent"));
        connect(link, &QLabel::linkActivated, this, &StartHint::fileWanted);
        layout.addWidget(link);
    }
    layout.addSpacing(8);
}

void StartHint::addSamples(QVBoxLayout& layout, qsizetype most)
{
    layout.addWidget(new QLabel(tr("Or look at a sample:"), m_lists));
    const QList<Sample> all = samples();
    for (const Sample& sample : all.first(std::min(all.size(), most))) {
        auto* link = new QLabel(QStringLiteral("<a href=\"%1\" style=\"text-decoration: none\">%2</a>"
                                               "<br><span style=\"color: %3\">%4</span>")
                                    .arg(sample.path.toHtmlEscaped(), sample.title.toHtmlEscaped(), muted(),
                                         sample.description.toHtmlEscaped()),
                                m_lists);
        link->setTextFormat(Qt::RichText);
        link->setWordWrap(true);
        connect(link, &QLabel::linkActivated, this, &StartHint::fileWanted);
        layout.addWidget(link);
    }
    if (all.size() > most) {
        auto* more = new QLabel(tr("%1 more are under File > Samples").arg(all.size() - most), m_lists);
        more->setForegroundRole(QPalette::PlaceholderText);
        layout.addWidget(more);
    }
}

void StartHint::showEvent(QShowEvent* event)
{
    fillLists();
    QWidget::showEvent(event);
}

void StartHint::addBeginning(QBoxLayout& layout)
{
    auto* grid = new QGridLayout;
    const auto add = [&](const QString& name, const QString& text, void (StartHint::*wanted)()) {
        auto* button = new QPushButton(icon(name), text, this);
        button->setAutoDefault(true); // Enter presses it
        connect(button, &QPushButton::clicked, this, wanted);
        grid->addWidget(button, grid->count() / 2,
                        grid->count() % 2); // four in a row are too wide for a narrow view
    };
    add(QStringLiteral("rectangle"), tr("Rectan&gle"), &StartHint::rectangleWanted);
    add(QStringLiteral("outline"), tr("Ou&tline"), &StartHint::outlineWanted);
    add(QStringLiteral("import-frame"), tr("&Import frame \u2026"), &StartHint::frameWanted);
    add(QStringLiteral("open"), tr("&Open \u2026"), &StartHint::openWanted);
    layout.addLayout(grid);
}

void StartHint::setDrawing(bool drawing)
{
    m_drawing = drawing;
    place();
}

void StartHint::setCovered(bool covered)
{
    m_covered = covered;
    place();
}

void StartHint::place()
{
    bool begun = false;
    m_document.design().each<Patch>([&](ElementId, const Patch&) { begun = true; });
    m_document.design().each<Frame>([&](ElementId, const Frame&) { begun = true; });
    const QRect room = m_over.freeRoom();
    const auto fits = [&] {
        return layout()->totalHeightForWidth(std::min(room.width(), widest)) <= room.height();
    };
    m_lists->show();
    m_lists->setVisible(fits());
    setVisible(!begun && !m_drawing && !m_covered && fits());
    const QSize size(std::min(room.width(), widest), std::min(room.height(), sizeHint().height()));
    setGeometry(QStyle::alignedRect(Qt::LeftToRight, Qt::AlignCenter, size, room));
}

bool StartHint::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        place();
    return QWidget::eventFilter(watched, event);
}

} // namespace bolster
