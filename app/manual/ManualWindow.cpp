#include "ManualWindow.h"

#include "Icons.h"
#include "ViewColors.h"

#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollBar>
#include <QShortcut>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace bolster {

namespace {

/// As the links have it: small letters without signs, with - between words.
QString anchorOf(QString heading)
{
    heading = heading.toLower();
    heading.remove(QRegularExpression(QStringLiteral("[^\\p{L}\\p{N} _-]")));
    return heading.replace(u' ', u'-');
}

/// Pictures are no wider than the text.
class Pages : public QTextBrowser {
public:
    explicit Pages(QString folder, QWidget* parent)
        : QTextBrowser(parent)
        , m_folder(std::move(folder))
    {}

    QVariant loadResource(int type, const QUrl& name) override
    {
        if (type != QTextDocument::ImageResource)
            return {};
        QImage image(QDir(m_folder).filePath(name.path()));
        const int most = std::max(200, viewport()->width() - 40);
        return image.width() > most ? image.scaledToWidth(most, Qt::SmoothTransformation) : image;
    }

private:
    QString m_folder;
};

} // namespace

ManualWindow::ManualWindow(QString folder, QWidget* parent)
    : QDialog(parent)
    , m_folder(std::move(folder))
    , m_text(new Pages(m_folder, this))
    , m_back(new QToolButton(this))
    , m_forward(new QToolButton(this))
    , m_find(new QLineEdit(this))
{
    setWindowTitle(tr("Manual"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_text->setOpenLinks(false);
    m_text->setAccessibleName(tr("Manual"));
    connect(m_text, &QTextBrowser::anchorClicked, this, &ManualWindow::follow);
    auto* contents = new QToolButton(this);
    contents->setText(tr("Contents"));
    connect(contents, &QToolButton::clicked, this, [this] { openAt(QStringLiteral("index.md")); });
    m_back->setArrowType(Qt::LeftArrow);
    m_back->setToolTip(tr("Back (Alt+Left)"));
    m_back->setAccessibleName(tr("Back"));
    m_back->setShortcut(Qt::ALT | Qt::Key_Left);
    m_forward->setArrowType(Qt::RightArrow);
    m_forward->setToolTip(tr("Forward (Alt+Right)"));
    m_forward->setAccessibleName(tr("Forward"));
    m_forward->setShortcut(Qt::ALT | Qt::Key_Right);
    connect(m_back, &QToolButton::clicked, this, [this] { go(-1); });
    connect(m_forward, &QToolButton::clicked, this, [this] { go(1); });
    m_find->setPlaceholderText(tr("Find in all pages"));
    m_find->setAccessibleName(m_find->placeholderText());
    m_find->setClearButtonEnabled(true);
    m_find->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    connect(m_find, &QLineEdit::returnPressed, this, &ManualWindow::find);
    auto* focusFind = new QShortcut(QKeySequence::Find, this);
    connect(focusFind, &QShortcut::activated, m_find, [this] {
        m_find->setFocus();
        m_find->selectAll();
    });
    auto* bar = new QHBoxLayout;
    for (QToolButton* button : {m_back, m_forward, contents})
        bar->addWidget(button);
    bar->addStretch(1);
    bar->addWidget(m_find, 2);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(bar);
    if (QLocale().language() != QLocale::English && QLocale().language() != QLocale::C)
        layout->addWidget(new QLabel(tr("The manual is in English."), this));
    layout->addWidget(m_text, 1);
    m_text->setFocus();
    resize(QSize(760, 800).boundedTo(screen()->availableSize() - QSize(40, 80))); // with its frame and title
}

void ManualWindow::standBeside(const QPoint& place)
{
    constexpr int margin = 20;
    const QRect room = screen()->availableGeometry();
    const bool left = place.x() > room.center().x();
    move(left ? room.left() + margin : room.right() - width() - margin, room.top() + 2 * margin);
}

void ManualWindow::openAt(const QString& place)
{
    while (m_places.size() > m_shown + 1)
        m_places.removeLast();
    m_places << place;
    go(1);
}

void ManualWindow::go(int steps)
{
    m_shown = std::clamp(m_shown + steps, 0, static_cast<int>(m_places.size()) - 1);
    m_back->setEnabled(m_shown > 0);
    m_forward->setEnabled(m_shown + 1 < m_places.size());
    show(place());
}

void ManualWindow::show(const QString& place)
{
    const QString page = place.section(u'#', 0, 0);
    QFile file(QDir(m_folder).filePath(page));
    m_text->document()->setMarkdown(file.open(QIODevice::ReadOnly)
                                        ? QString::fromUtf8(file.readAll())
                                        : tr("The manual has no page \"%1\".").arg(page));
    m_text->setExtraSelections({});
    m_text->moveCursor(QTextCursor::Start);
    m_text->verticalScrollBar()->setValue(0);
    if (const QString anchor = place.section(u'#', 1); !anchor.isEmpty()) {
        scrollTo(anchor);
        QTimer::singleShot(0, this, [this, place, anchor] { // when pictures have found their room
            if (this->place() == place)
                scrollTo(anchor);
        });
    }
}

void ManualWindow::scrollTo(const QString& anchor)
{
    for (QTextBlock block = m_text->document()->begin(); block.isValid(); block = block.next())
        if (block.blockFormat().headingLevel() > 0 && anchorOf(block.text()) == anchor) {
            m_text->setTextCursor(QTextCursor(block));
            QTextEdit::ExtraSelection mark; // it may be in the middle of the window, at the end of a page
            mark.cursor = QTextCursor(block);
            mark.format.setBackground(
                mixed(palette().color(QPalette::Base), palette().color(QPalette::Highlight), 0.22));
            mark.format.setProperty(QTextFormat::FullWidthSelection, true);
            m_text->setExtraSelections({mark});
            m_text->verticalScrollBar()->setValue(m_text->verticalScrollBar()->value() +
                                                  m_text->cursorRect().top());
            return;
        }
}

void ManualWindow::follow(const QUrl& link)
{
    if (!link.scheme().isEmpty()) {
        QDesktopServices::openUrl(link);
        return;
    }
    const QString page = link.path().isEmpty() ? place().section(u'#', 0, 0) : link.path();
    openAt(link.fragment().isEmpty() ? page : page + u'#' + link.fragment());
}

/// From where one reads to the end of the page, then in the pages after it, once around.
void ManualWindow::find()
{
    const QString text = m_find->text().trimmed();
    if (text.isEmpty() || m_text->find(text))
        return;
    const QStringList pages = QDir(m_folder).entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name);
    const qsizetype here = pages.indexOf(place().section(u'#', 0, 0));
    for (qsizetype k = 1; k <= pages.size(); ++k) {
        const QString& page = pages[(here + k) % pages.size()];
        QFile file(QDir(m_folder).filePath(page));
        if (!file.open(QIODevice::ReadOnly) ||
            !QString::fromUtf8(file.readAll()).contains(text, Qt::CaseInsensitive))
            continue;
        openAt(page);
        if (m_text->find(text))
            return;
    }
}

} // namespace bolster
