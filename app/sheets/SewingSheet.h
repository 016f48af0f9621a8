// The sewing sheet on paper: pictures of the cover, pieces, seams in order, what is needed.
#pragma once

#include "HtmlPages.h"
#include "SewingPlan.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QImage>

namespace bolster {

class SewingSheet {
    Q_DECLARE_TR_FUNCTIONS(SewingSheet)

public:
    /// `pictures` of the cover, the largest first; none: the sheet has none. `date`: printed as it is.
    SewingSheet(const Design& design, const SewingPlan& plan, std::vector<QImage> pictures, QString date);

    /// Upright, in the locale's numbers. Needs a QGuiApplication.
    QByteArray pdf(const PaperSize& paper) const;

private:
    QString title() const;
    void addPictures(HtmlPages& pages) const;
    void addNeeds(HtmlPages& pages) const;
    void addPieces(HtmlPages& pages) const;
    void addSeams(HtmlPages& pages) const;
    QString stitchOf(const PlannedSeam& seam) const;

    const Design& m_design;
    const SewingPlan& m_plan;
    std::vector<QImage> m_pictures;
    QString m_date;
};

} // namespace bolster
