// Text and tables on sheets of paper, page by page: no row is cut in two, and no heading stands alone.
#pragma once

#include "PaperSize.h"

#include <QByteArray>
#include <QImage>
#include <QString>
#include <QStringList>

#include <vector>

namespace bolster {

class HtmlPages {
public:
    /// `upright`: the paper, whose length and width may be those of a roll.
    /// On a roll as on A4.
    HtmlPages(const PaperSize& paper, QString title);

    /// Of what can be printed on, in pixels of html (1/96 inch).
    double width() const { return m_width; }
    double height() const { return m_height; }
    /// To be referred to as "picture:0", "picture:1" ...
    int addPicture(QImage picture);
    /// What belongs together: it stays on one page.
    void add(const QString& html);
    /// A heading, and a table with a row at least below it; its head is repeated on each page.
    void addTable(const QString& heading, const QString& begin, const QStringList& rows, const QString& end);

    /// With page numbers. Needs a QGuiApplication.
    QByteArray pdf() const;

private:
    double heightOf(const QString& html) const;
    void newPage();

    PaperSize m_paper;
    QString m_title;
    double m_width = 0;
    double m_height = 0;
    std::vector<QImage> m_pictures;
    QStringList m_pages{QString()};
};

} // namespace bolster
