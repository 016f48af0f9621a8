#include "StartPage.h"

#include "CardFlow.h"
#include "FileFormats.h"
#include "LeftWork.h"
#include "RecentFiles.h"
#include "StartCard.h"
#include "StartPictures.h"
#include "Templates.h"
#include "Translated.h"

#include <QBoxLayout>
#include <QDir>
#include <QDockWidget>
#include <QEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QMainWindow>
#include <QPushButton>

#include <utility>

namespace bolster {

namespace {

constexpr int widestPage = 74; // of the height of a line
constexpr int cardGap = 12;    // pixels
constexpr qsizetype mostRecentCards = 10;
constexpr qsizetype mostLeftCards = 10;

/// Of a list of formats, as many as fit in the words of a card.
QString formatsText(FileUse use)
{
    return QString::fromStdString(namesOf(use));
}

} // namespace

StartPage::StartPage(QMainWindow& window, const QList<QWidget*>& over)
    : QScrollArea(&window)
    , m_window(window)
    , m_over(over)
    , m_pictures(new StartPictures(this))
    , m_templates(templatesFolder())
{
    setObjectName(QStringLiteral("start-page"));
    setAccessibleName(tr("Start page"));
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::StrongFocus);
    paintLikeTheViews();
    hide();
    connect(m_pictures, &StartPictures::found, this, &StartPage::showPicture);
    for (QWidget* widget : over)
        widget->installEventFilter(this);
    window.installEventFilter(this);
}

/// Nothing of what lies below shines through, nor gets the keyboard by F6.
void StartPage::paintLikeTheViews()
{
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    viewport()->setBackgroundRole(QPalette::Base);
    viewport()->setAutoFillBackground(true);
}

void StartPage::open(bool back)
{
    m_back = back;
    fill();
    m_open = true;
    place();
    QScrollArea::show();
    raise();
    focusFirst();
    emit toggled(true);
}

void StartPage::focusFirst()
{
    if (auto* first = widget()->findChild<StartCard*>())
        first->setFocus(Qt::TabFocusReason); // it is to be seen where one is
}

void StartPage::close()
{
    if (!std::exchange(m_open, false))
        return;
    m_cards.clear();
    emit toggled(false); // while it is known who has the keyboard
    hide();
}

void StartPage::setLeft(const QList<WorkJournal::Left>& all)
{
    const bool others = !(m_left.isEmpty() && all.isEmpty());
    m_left = all;
    if (m_open && others)
        fill();
}

/// Anew each time: recent files and left work are others.
void StartPage::fill()
{
    const QWidget* keyboard = m_window.focusWidget();
    const bool hasKeyboard = keyboard && isAncestorOf(keyboard);
    m_cards.clear();
    m_wanted.clear();
    auto* content = new QWidget;
    content->setBackgroundRole(QPalette::Base);
    auto* middle = new QWidget(content);
    middle->setMaximumWidth(widestPage * fontMetrics().height());
    auto* outer = new QHBoxLayout(content);
    outer->setContentsMargins(24, 20, 24, 24);
    outer->addStretch(1);
    outer->addWidget(middle, 1000); // as wide as it may be
    outer->addStretch(1);
    auto* page = new QVBoxLayout(middle);
    page->setContentsMargins(0, 0, 0, 0);
    page->setSpacing(8);
    addHead(*page);
    addLeft(*page);
    addRecent(*page);
    addBeginnings(*page);
    addTemplates(*page);
    addSamples(*page);
    page->addStretch();
    if (QWidget* before = takeWidget())
        before->deleteLater(); // a card of it may have asked for this
    setWidget(content);
    if (m_open && hasKeyboard)
        focusFirst();
    m_pictures->read(m_wanted);
}

void StartPage::addHead(QVBoxLayout& page)
{
    auto* title = new QLabel(tr("Welcome to Bolster"));
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() * 1.6);
    large.setWeight(QFont::DemiBold);
    title->setFont(large);
    auto* row = new QHBoxLayout;
    row->addWidget(title);
    row->addStretch();
    QPushButton* tour = newLink(tr("Take the tour"), QStringLiteral("start-tour"));
    connect(tour, &QPushButton::clicked, this, &StartPage::tourWanted);
    row->addWidget(tour);
    QPushButton* open = newLink(tr("Open \u2026"), QStringLiteral("start-open"));
    connect(open, &QPushButton::clicked, this, &StartPage::openWanted);
    row->addWidget(open);
    if (m_back) {
        QPushButton* back = newLink(tr("Back to the design"), QStringLiteral("start-back"));
        connect(back, &QPushButton::clicked, this, &StartPage::close);
        row->addWidget(back);
    }
    page.addLayout(row);
}

QHBoxLayout* StartPage::addHeading(QVBoxLayout& page, const QString& text)
{
    auto* heading = new QLabel(text);
    QFont font = heading->font();
    font.setPointSizeF(font.pointSizeF() * 1.15);
    font.setWeight(QFont::DemiBold);
    heading->setFont(font);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(0, fontMetrics().height() / 2, 0, 0);
    row->addWidget(heading);
    row->addStretch();
    page.addLayout(row);
    return row;
}

CardFlow* StartPage::addCards(QVBoxLayout& page)
{
    auto* flow = new CardFlow(cardGap);
    page.addLayout(flow);
    return flow;
}

QPushButton* StartPage::newLink(const QString& text, const QString& name)
{
    auto* link = new QPushButton(text);
    link->setObjectName(name);
    return link;
}

void StartPage::addBeginnings(QVBoxLayout& page)
{
    addHeading(page, tr("What do you have?"));
    CardFlow* flow = addCards(page);
    const auto add = [&](const char* name, const QString& icon, const QString& title, const QString& words,
                         void (StartPage::*wanted)()) {
        auto* card = new StartCard(StartCard::Shape::Action, icon, title, words, this);
        card->setObjectName(QLatin1String(name));
        connect(card, &StartCard::clicked, this, wanted);
        flow->addWidget(card);
    };
    add("begin-frame", QStringLiteral("import-frame"), tr("A frame"),
        tr("The cover is fixed on it: %1").arg(formatsText(FileUse::Frame)), &StartPage::frameWanted);
    add("begin-pattern", QStringLiteral("patch"), tr("A pattern"),
        tr("Its pieces become the cover: %1").arg(formatsText(FileUse::Pattern)), &StartPage::patternWanted);
    add("begin-scan", QStringLiteral("import-scan"), tr("A scan"),
        tr("The cover is fitted to it: %1").arg(formatsText(FileUse::Scan)), &StartPage::scanWanted);
    add("begin-nothing", QStringLiteral("rectangle"), tr("Nothing yet"), tr("Draw a rectangle, the first patch"),
        &StartPage::rectangleWanted);
}

StartCard* StartPage::newPictureCard(const QString& path, const QString& title, const QString& words)
{
    auto* card = new StartCard(StartCard::Shape::Picture, QStringLiteral("patch"), title, words, this);
    m_cards.insert(path, card);
    m_wanted << path;
    return card;
}

void StartPage::addRecent(QVBoxLayout& page)
{
    const QStringList files = recentFiles::remembered().mid(0, mostRecentCards);
    if (files.isEmpty())
        return;
    QHBoxLayout* row = addHeading(page, tr("Go on with"));
    QPushButton* clear = newLink(tr("Clear this list"), QStringLiteral("start-clear"));
    clear->setFlat(true);
    connect(clear, &QPushButton::clicked, this, [this] {
        recentFiles::clear();
        fill();
    });
    row->addWidget(clear);
    CardFlow* flow = addCards(page);
    for (const QString& file : files) {
        StartCard* card = newPictureCard(file, isolated(QFileInfo(file).completeBaseName()),
                                         recentFiles::folderText(file, fontMetrics(), 10 * fontMetrics().height()));
        card->setObjectName(QStringLiteral("recent-card"));
        card->setToolTip(QDir::toNativeSeparators(file));
        card->setRemovable(tr("Take it out of this list; the file stays"));
        connect(card, &StartCard::clicked, this, [this, file] { emit fileWanted(file); });
        connect(card, &StartCard::removeWanted, this, [this, file] { forget(file); });
        flow->addWidget(card);
    }
}

void StartPage::forget(const QString& path)
{
    recentFiles::remove(path);
    fill();
}

void StartPage::addLeft(QVBoxLayout& page)
{
    if (m_left.isEmpty())
        return;
    addHeading(page, tr("Unsaved work"));
    CardFlow* flow = addCards(page);
    for (const WorkJournal::Left& left : std::as_const(m_left).mid(0, mostLeftCards)) {
        const QString when = QLocale().toString(left.when, QLocale::ShortFormat);
        auto* card = new StartCard(StartCard::Shape::Action, QStringLiteral("save"), LeftWork::nameOf(left),
                                   left.kept ? tr("Kept for later, last edit %1").arg(when)
                                             : tr("Left by a crash, last edit %1").arg(when),
                                   this);
        card->setObjectName(QStringLiteral("left-card"));
        card->setToolTip(QDir::toNativeSeparators(left.place.original));
        connect(card, &StartCard::clicked, this, [this, left] { emit leftWanted(left); });
        flow->addWidget(card);
    }
}

void StartPage::addTemplates(QVBoxLayout& page)
{
    const QList<Sample> all = templates(m_templates);
    if (all.isEmpty())
        return;
    addHeading(page, tr("Begin with a template"));
    CardFlow* flow = addCards(page);
    for (const Sample& one : all) {
        StartCard* card = newPictureCard(one.path, one.title, {});
        card->setObjectName(QStringLiteral("template-card"));
        connect(card, &StartCard::clicked, this, [this, path = one.path] { emit templateWanted(path); });
        flow->addWidget(card);
    }
}

void StartPage::addSamples(QVBoxLayout& page)
{
    const QList<Sample> all = samples();
    if (all.isEmpty())
        return;
    addHeading(page, tr("Look at a sample"));
    CardFlow* flow = addCards(page);
    for (const Sample& one : all) {
        StartCard* card = newPictureCard(one.path, one.title, one.description);
        card->setObjectName(QStringLiteral("sample-card"));
        card->setToolTip(one.description);
        connect(card, &StartCard::clicked, this, [this, path = one.path] { emit fileWanted(path); });
        flow->addWidget(card);
    }
}

void StartPage::showPicture(const QString& design, bool there, const QImage& picture)
{
    for (StartCard* card : m_cards.values(design)) {
        card->setPicture(picture);
        if (!there)
            card->setMissing(tr("It is not there now"));
    }
}

/// Over all of the views that are part of the window, but over nothing else that stands between them.
void StartPage::place()
{
    if (!m_open || m_placing)
        return;
    m_placing = true;
    QRect room;
    for (const QWidget* widget : m_over) {
        const auto* dock = qobject_cast<const QDockWidget*>(widget);
        const bool seen = widget->isVisible() && m_window.rect().intersects(widget->geometry()); // not below a tab
        if (seen && !(dock && dock->isFloating()))
            room |= widget->geometry();
    }
    if (room.isEmpty())
        room = m_window.rect().adjusted(0, m_window.height() / 8, 0, -m_window.height() / 16);
    setGeometry(room);
    raise();
    m_placing = false;
}

bool StartPage::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::ParentChange:
        place();
        break;
    default:
        break;
    }
    return QScrollArea::eventFilter(watched, event);
}

void StartPage::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && m_back)
        close();
    else
        QScrollArea::keyPressEvent(event);
}

/// Cards are as large as their font asks for.
void StartPage::changeEvent(QEvent* event)
{
    QScrollArea::changeEvent(event);
    if (event->type() == QEvent::FontChange && m_open)
        QMetaObject::invokeMethod(this, &StartPage::fill, Qt::QueuedConnection);
}

} // namespace bolster
