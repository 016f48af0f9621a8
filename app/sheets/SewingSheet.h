// The sewing sheet on paper: pictures of the cover, pieces, seams in order, what is needed.
#pragma once

#include "HtmlPages.h"
#include "SeamDrawing.h"
#include "SewingPlan.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QImage>

#include <map>

namespace bolster {

class SewingSheet {
    Q_DECLARE_TR_FUNCTIONS(SewingSheet)

public:
    /// `pictures` of the cover, the largest first; none: the sheet has none. `date`: printed as it is.
    SewingSheet(const Design& design, const SewingPlan& plan, std::vector<QImage> pictures, QString date);

    /// Upright, in the locale's numbers; nothing when it is stopped. Needs a QGuiApplication.
    QByteArray pdf(const PaperSize& paper, const SheetWatch& watch = {}) const;
    /// Its first pages, so wide, at most so many; `all`: how many there are.
    std::vector<QImage> pictures(const PaperSize& paper, int width, int most, int& all,
                                 const SheetWatch& watch = {}) const;

private:
    HtmlPages pages(const PaperSize& paper, const SheetWatch& watch) const;
    QString title() const;
    void addPictures(HtmlPages& pages) const;
    void addNeeds(HtmlPages& pages) const;
    void addPieces(HtmlPages& pages) const;
    void addSeams(HtmlPages& pages) const;
    std::map<ElementId, std::vector<NumberedSide>> numberedSides() const;
    QString nameAndNotes(const CutPiece& piece) const;
    QString stitchOf(const PlannedSeam& seam) const;

    const Design& m_design;
    const SewingPlan& m_plan;
    std::vector<QImage> m_pictures;
    QString m_date;
};

} // namespace bolster
