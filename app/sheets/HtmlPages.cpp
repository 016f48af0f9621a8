#include "HtmlPages.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>

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

std::unique_ptr<QTextDocument> documentOf(const QString& html, const std::vector<QImage>& pictures, double width)
{
    auto document = std::make_unique<QTextDocument>();
    document->documentLayout()->setPaintDevice(&measure());
    QFont font(QStringLiteral("sans-serif"));
    font.setPointSizeF(fontPoints);
    document->setDefaultFont(font);
    document->setDocumentMargin(0);
    for (std::size_t i = 0; i < pictures.size(); ++i)
        document->addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("picture:%1").arg(i)), pictures[i]);
    document->setTextWidth(width);
    document->setHtml(html);
    return document;
}

} // namespace

HtmlPages::HtmlPages(const PaperSize& paper, QString title)
    : m_paper(paper.roll ? PaperSize() : paper)
    , m_title(std::move(title))
    , m_width((m_paper.size.width() - 2 * pageMargin) / millimetresPerInch * htmlDots)
    , m_height((m_paper.size.height() - 2 * pageMargin) / millimetresPerInch * htmlDots - footHeight)
{}

int HtmlPages::addPicture(QImage picture)
{
    m_pictures.push_back(std::move(picture));
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
    for (qsizetype page = 0; page < m_pages.size(); ++page) {
        if (page > 0)
            writer.newPage();
        painter.save();
        painter.scale(sheetDots / htmlDots, sheetDots / htmlDots);
        painter.translate(pageMargin / millimetresPerInch * htmlDots, pageMargin / millimetresPerInch * htmlDots);
        documentOf(m_pages[page], m_pictures, m_width)->drawContents(&painter);
        const QString number = QStringLiteral("<p align=\"right\">%1 / %2</p>").arg(page + 1).arg(m_pages.size());
        painter.translate(0, m_height + footHeight / 2);
        documentOf(number, {}, m_width)->drawContents(&painter);
        painter.restore();
    }
    painter.end();
    buffer.close();
    return bytes;
}

} // namespace bolster
