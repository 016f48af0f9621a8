// Text and tables on sheets of paper, page by page: no row is cut in two, and no heading stands alone.
#pragma once

#include "PaperSize.h"
#include "SheetWatch.h"

#include <QByteArray>
#include <QImage>
#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

class QPainter;

namespace bolster {

class HtmlPages {
public:
    /// `upright`: the paper, whose length and width may be those of a roll.
    /// On a roll as on A4.
    HtmlPages(const PaperSize& paper, QString title, SheetWatch watch = {});

    /// Of what can be printed on, in pixels of html (1/96 inch).
    double width() const { return m_width; }
    double height() const { return m_height; }
    /// To be referred to as "picture:0", "picture:1" ..., with its width and height. It is made when its page is
    /// drawn.
    int addPicture(std::function<QImage()> make);
    /// What belongs together: it stays on one page.
    void add(const QString& html);
    /// A heading, and a table with a row at least below it; its head is repeated on each page.
    void addTable(const QString& heading, const QString& begin, const QStringList& rows, const QString& end);

    int count() const { return static_cast<int>(m_pages.size()); }
    /// With page numbers; nothing when it is stopped. Needs a QGuiApplication.
    QByteArray pdf() const;
    /// The first pages, as they will be, so wide; fewer when it is stopped.
    std::vector<QImage> pictures(int width, int most) const;

private:
    void drawPage(QPainter& painter, qsizetype page) const;
    double heightOf(const QString& html) const;
    void newPage();

    PaperSize m_paper;
    QString m_title;
    SheetWatch m_watch;
    double m_width = 0;
    double m_height = 0;
    std::vector<std::function<QImage()>> m_pictures;
    QStringList m_pages{QString()};
};

} // namespace bolster
