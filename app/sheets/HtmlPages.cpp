#include "HtmlPages.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>

#include <algorithm>
#include <cmath>
#include <memory>

namespace bolster {

namespace {

constexpr double pageMargin = 15;           // mm
constexpr double millimetresPerInch = 25.4; // mm
constexpr double htmlDots = 96;             // per inch
constexpr int sheetDots = 300;              // per inch
constexpr double footHeight = 24;           // pixels of html
constexpr double fontPoints = 8;

/// Lays out as on a screen of 96 dots per inch, whatever screen there is.
QImage& measure()
{
    static QImage image = [] {
        QImage made(1, 1, QImage::Format_RGB32);
        made.setDotsPerMeterX(qRound(htmlDots / millimetresPerInch * 1000));
        made.setDotsPerMeterY(qRound(htmlDots / millimetresPerInch * 1000));
        return made;
    }();
    return image;
}

using Pictures = std::vector<std::function<QImage()>>;

/// Makes its pictures when they are drawn: laying it out needs only their sizes.
class PictureDocument : public QTextDocument {
public:
    explicit PictureDocument(const Pictures& pictures)
        : m_pictures(pictures)
    {}

protected:
    QVariant loadResource(int type, const QUrl& name) override
    {
        bool isNumber = false;
        const int number = name.path().toInt(&isNumber);
        if (type != ImageResource || !isNumber || number < 0 || number >= static_cast<int>(m_pictures.size()))
            return {}; // nothing else is looked for, on no disk and in no net
        return m_pictures[static_cast<std::size_t>(number)]();
    }

private:
    const Pictures& m_pictures;
};

std::unique_ptr<QTextDocument> documentOf(const QString& html, const Pictures& pictures, double width)
{
    auto document = std::make_unique<PictureDocument>(pictures);
    document->documentLayout()->setPaintDevice(&measure());
    QFont font(QStringLiteral("sans-serif"));
    font.setPointSizeF(fontPoints);
    document->setDefaultFont(font);
    document->setDocumentMargin(0);
    document->setTextWidth(width);
    document->setHtml(html);
    return document;
}

double htmlPixels(double millimetres)
{
    return millimetres / millimetresPerInch * htmlDots;
}

} // namespace

HtmlPages::HtmlPages(const PaperSize& paper, QString title, SheetWatch watch)
    : m_paper(paper.roll ? PaperSize() : paper)
    , m_title(std::move(title))
    , m_watch(std::move(watch))
    , m_width(htmlPixels(m_paper.size.width() - 2 * pageMargin))
    , m_height(htmlPixels(m_paper.size.height() - 2 * pageMargin) - footHeight)
{}

int HtmlPages::addPicture(std::function<QImage()> make)
{
    m_pictures.push_back(std::move(make));
    return static_cast<int>(m_pictures.size()) - 1;
}

double HtmlPages::heightOf(const QString& html) const
{
    return documentOf(html, m_pictures, m_width)->size().height();
}

void HtmlPages::newPage()
{
    if (!m_pages.back().isEmpty())
        m_pages.append(QString());
}

void HtmlPages::add(const QString& html)
{
    if (heightOf(m_pages.back() + html) > m_height)
        newPage();
    m_pages.back() += html;
}

void HtmlPages::addTable(const QString& heading, const QString& begin, const QStringList& rows, const QString& end)
{
    QString title = heading, body;
    for (const QString& row : rows) {
        if (m_watch.stopped())
            return;
        if (heightOf(m_pages.back() + title + begin + body + row + end) > m_height) {
            if (!body.isEmpty())
                m_pages.back() += std::exchange(title, QString()) + begin + std::exchange(body, QString()) + end;
            newPage();
        }
        body += row;
    }
    if (!body.isEmpty())
        m_pages.back() += title + begin + body + end;
}

QByteArray HtmlPages::pdf() const
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(sheetDots);
    writer.setPageSize(QPageSize(m_paper.size, QPageSize::Millimeter));
    writer.setPageMargins(QMarginsF());
    writer.setTitle(m_title);
    QPainter painter(&writer);
    painter.scale(sheetDots / htmlDots, sheetDots / htmlDots);
    for (qsizetype page = 0; page < m_pages.size() && !m_watch.stopped(); ++page) {
        m_watch.say(static_cast<double>(page) / static_cast<double>(m_pages.size()));
        if (page > 0)
            writer.newPage();
        drawPage(painter, page);
    }
    painter.end();
    buffer.close();
    return m_watch.stopped() ? QByteArray() : bytes;
}

void HtmlPages::drawPage(QPainter& painter, qsizetype page) const
{
    painter.save();
    painter.translate(htmlPixels(pageMargin), htmlPixels(pageMargin));
    documentOf(m_pages[page], m_pictures, m_width)->drawContents(&painter);
    const QString number = QStringLiteral("<p align=\"right\">%1 / %2</p>").arg(page + 1).arg(m_pages.size());
    painter.translate(0, m_height + footHeight / 2);
    documentOf(number, m_pictures, m_width)->drawContents(&painter);
    painter.restore();
}

std::vector<QImage> HtmlPages::pictures(int width, int most) const
{
    std::vector<QImage> pages;
    const double scale = width / htmlPixels(m_paper.size.width());
    const int height = qRound(scale * htmlPixels(m_paper.size.height()));
    for (qsizetype page = 0; page < std::min<qsizetype>(most, m_pages.size()) && !m_watch.stopped(); ++page) {
        QImage image(width, height, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.scale(scale, scale);
        drawPage(painter, page);
        painter.end();
        pages.push_back(std::move(image));
    }
    return pages;
}

} // namespace bolster
