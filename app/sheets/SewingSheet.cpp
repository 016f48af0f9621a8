#include "SewingSheet.h"

#include "CutTable.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr QSize drawingSize(170, 150); // of the drawing of a piece at most, 1/96 inch
constexpr int drawingDots = 4;         // of it for each of these
constexpr double mostOfThePage = 0.4;  // that the pictures of the cover take

QString number(double value, int decimals)
{
    const double step = std::pow(10, -decimals);
    return QLocale().toString(std::abs(value) < step / 2 ? 0.0 : value, 'f', decimals); // never "-0"
}

QString withSign(double value)
{
    const QString text = number(value, 1);
    return value >= 0.05 ? QStringLiteral("+") + text : text;
}

QString cell(const QString& text, const char* align = "left")
{
    return QStringLiteral("<td align=\"%1\" valign=\"middle\">%2</td>").arg(QLatin1String(align), text);
}

QString heads(const QStringList& words)
{
    QString row = QStringLiteral("<thead><tr bgcolor=\"#e8e8e8\">");
    for (const QString& word : words)
        row += QStringLiteral("<th align=\"left\">%1</th>").arg(word.toHtmlEscaped());
    return row + QStringLiteral("</tr></thead>");
}

void addTable(HtmlPages& pages, const QString& heading, const QStringList& header, const QStringList& rows)
{
    pages.addTable(QStringLiteral("<h3>%1</h3>").arg(heading.toHtmlEscaped()),
                   QStringLiteral("<table width=\"100%\" cellspacing=\"0\" cellpadding=\"3\" border=\"0.5\" "
                                  "style=\"border-collapse:collapse; border-color:#b0b0b0\">") +
                       heads(header),
                   rows, QStringLiteral("</table>"));
}

QString rowOf(const QStringList& cells)
{
    return QStringLiteral("<tr>") + cells.join(QString()) + QStringLiteral("</tr>");
}

QString pictureTag(int picture, const QSize& size)
{
    return QStringLiteral("<img src=\"picture:%1\" width=\"%2\" height=\"%3\"/>")
        .arg(picture)
        .arg(size.width())
        .arg(size.height());
}

QString numbersOf(const std::vector<NumberedSide>& sides)
{
    QStringList numbers;
    for (const NumberedSide& side : sides)
        if (const QString number = QString::number(side.number); !numbers.contains(number))
            numbers << number;
    return numbers.join(QStringLiteral(", "));
}

} // namespace

SewingSheet::SewingSheet(const Design& design, const SewingPlan& plan, std::vector<QImage> pictures, QString date)
    : m_design(design)
    , m_plan(plan)
    , m_pictures(std::move(pictures))
    , m_date(std::move(date))
{}

QByteArray SewingSheet::pdf(const PaperSize& paper, const SheetWatch& watch) const
{
    return pages(paper, watch).pdf();
}

std::vector<QImage> SewingSheet::pictures(const PaperSize& paper, int width, int most, int& all,
                                          const SheetWatch& watch) const
{
    const HtmlPages pages = this->pages(paper, watch);
    all = pages.count();
    return pages.pictures(width, most);
}

HtmlPages SewingSheet::pages(const PaperSize& paper, const SheetWatch& watch) const
{
    HtmlPages pages(paper, title(), watch);
    QString head = QStringLiteral("<h2>%1</h2>").arg(title().toHtmlEscaped());
    if (!m_date.isEmpty())
        head += QStringLiteral("<p>%1</p>").arg(m_date.toHtmlEscaped());
    pages.add(head);
    addPictures(pages);
    addNeeds(pages);
    addPieces(pages);
    addSeams(pages);
    return pages;
}

QString SewingSheet::title() const
{
    QString name = QString::fromStdString(m_plan.pattern.style);
    if (!m_plan.pattern.version.empty())
        name += QStringLiteral(" ") + QString::fromStdString(m_plan.pattern.version);
    return name.isEmpty() ? tr("Sewing sheet") : tr("Sewing sheet: %1").arg(name);
}

void SewingSheet::addPictures(HtmlPages& pages) const
{
    if (m_pictures.empty())
        return;
    QString row = QStringLiteral("<table width=\"100%\" cellspacing=\"4\"><tr>");
    const double width = pages.width() / static_cast<double>(m_pictures.size()) - 12;
    for (const QImage& picture : m_pictures) {
        const QSizeF size =
            QSizeF(picture.size()).scaled(width, mostOfThePage * pages.height(), Qt::KeepAspectRatio);
        row += cell(pictureTag(pages.addPicture([picture] { return picture; }), size.toSize()));
    }
    pages.add(row + QStringLiteral("</tr></table>"));
}

void SewingSheet::addPieces(HtmlPages& pages) const
{
    const std::map<ElementId, std::vector<NumberedSide>> sides = numberedSides();
    static const std::vector<NumberedSide> none;
    QStringList rows;
    for (const CutPiece& piece : m_plan.pattern.pieces) {
        const Box2 box = turnedBox(piece, uprightAngle(piece)); // as it is drawn
        const Vec2 size = box.isEmpty() ? Vec2(0, 0) : Vec2(box.sizes());
        const QString count =
            piece.pair ? tr("%1 and %1 mirrored").arg(piece.quantity) : QString::number(piece.quantity);
        const auto sewn = sides.find(piece.patch);
        const std::vector<NumberedSide>& seams = sewn == sides.end() ? none : sewn->second;
        const QSize pixels = seamDrawingSize(piece, drawingSize * drawingDots);
        const int drawing = pages.addPicture([&piece, seams, pixels] { return seamDrawing(piece, seams, pixels); });
        rows += rowOf({cell(pictureTag(drawing, pixels / drawingDots), "center"), cell(nameAndNotes(piece)),
                       cell(count), cell(QString::fromStdString(piece.fabricName).toHtmlEscaped()),
                       cell(tr("%1 \u00d7 %2 mm").arg(number(size.x(), 0), number(size.y(), 0)), "right"),
                       cell(tr("%1 m\u00b2").arg(number(std::abs(areaOf(piece.cut)) / 1e6, 3)), "right"),
                       cell(numbersOf(seams))});
    }
    addTable(pages, tr("Pieces, with the numbers of their seams"),
             {QString(), tr("Piece"), tr("Quantity"), tr("Fabric"), tr("Width \u00d7 height as cut"),
              tr("Area as cut"), tr("Seams")},
             rows);
}

/// What the cutter has to know beside its name.
QString SewingSheet::nameAndNotes(const CutPiece& piece) const
{
    QStringList words{QString::fromStdString(piece.name).toHtmlEscaped()};
    if (piece.nap == Nap::OneWay)
        words << tr("nap one way: all pieces point up");
    if (const Patch* patch = m_design.find<Patch>(piece.patch); patch && !patch->cutting.note.empty())
        words << QString::fromStdString(patch->cutting.note).toHtmlEscaped();
    return words.join(QStringLiteral("<br/>"));
}

/// By patch, with the numbers that the list of seams has.
std::map<ElementId, std::vector<NumberedSide>> SewingSheet::numberedSides() const
{
    std::map<ElementId, std::vector<NumberedSide>> sides;
    int number = 0;
    for (const PlannedSeam& planned : m_plan.seams) {
        ++number;
        if (const Seam* seam = m_design.find<Seam>(planned.seam))
            for (const Stretch* side : {&seam->a, &seam->b})
                sides[side->patch].push_back({number, side->from, side->to});
    }
    return sides;
}

QString SewingSheet::stitchOf(const PlannedSeam& seam) const
{
    const SeamTrim& trim = seam.trim;
    QStringList words;
    if (seam.zip)
        words << tr("zip");
    if (trim.stitch != SeamTrim::Stitch::None)
        words << (trim.stitch == SeamTrim::Stitch::Twin ? tr("top stitched on both sides") : tr("top stitched"));
    if (trim.stitch != SeamTrim::Stitch::None)
        words << tr("%1 mm long, %2 mm from the seam")
                     .arg(number(trim.stitchLength, 1), number(trim.stitchDistance, 1));
    if (trim.hasPiping())
        words << tr("piping, %1 mm thick").arg(number(2 * trim.pipingRadius, 1));
    return words.isEmpty() ? tr("plain") : words.join(QStringLiteral(", "));
}

void SewingSheet::addSeams(HtmlPages& pages) const
{
    const auto name = [this](ElementId id) {
        const Patch* patch = m_design.find<Patch>(id);
        return patch ? QString::fromStdString(patch->name).toHtmlEscaped() : QString();
    };
    QStringList rows;
    for (const PlannedSeam& seam : m_plan.seams) {
        const QString allowance = std::abs(seam.allowanceA - seam.allowanceB) < 1e-6
                                      ? number(seam.allowanceA, 1)
                                      : tr("%1 and %2").arg(number(seam.allowanceA, 1), number(seam.allowanceB, 1));
        const QString both = seam.patchA == seam.patchB ? tr("%1, with itself").arg(name(seam.patchA))
                                                        : tr("%1 to %2").arg(name(seam.patchA), name(seam.patchB));
        rows += rowOf({cell(QString::number(rows.size() + 1), "right"), cell(both),
                       cell(tr("%1 and %2").arg(number(seam.lengthA, 1), number(seam.lengthB, 1)), "right"),
                       cell(withSign(seam.ease), "right"), cell(allowance, "right"),
                       cell(QString::number(seam.notches), "right"), cell(stitchOf(seam))});
    }
    addTable(
        pages, tr("Seams in the order of sewing"),
        {tr("No."), tr("Seam"), tr("Lengths, mm"), tr("Ease, %"), tr("Allowance, mm"), tr("Notches"), tr("Stitch")},
        rows);
}

void SewingSheet::addNeeds(HtmlPages& pages) const
{
    QStringList rows;
    const auto add = [&rows](const QString& what, const QString& much) {
        rows += rowOf({cell(what), cell(much, "right")});
    };
    for (const FabricNeed& need : m_plan.fabrics)
        add(need.name.empty() ? tr("Fabric") : QString::fromStdString(need.name).toHtmlEscaped(),
            tr("%1 m\u00b2, without what lies between the pieces").arg(number(need.area / 1e6, 2)));
    for (const auto& [colour, length] : m_plan.thread)
        add(colour.empty() ? tr("Sewing thread")
                           : tr("Top thread <span style=\"background-color:%1\">&nbsp;&nbsp;&nbsp;&nbsp;</span> %1")
                                 .arg(QString::fromStdString(colour)),
            tr("%1 m, at %2 m for each metre of a row").arg(number(length / 1000, 1), number(threadPerSeam, 0)));
    if (m_plan.piping > 0)
        add(tr("Piping"), tr("%1 m").arg(number(m_plan.piping / 1000, 2)));
    if (m_plan.zips > 0)
        add(tr("Zip"), tr("%1 m").arg(number(m_plan.zips / 1000, 2)));
    addTable(pages, tr("Materials"), {tr("What"), tr("How much")}, rows);
}

} // namespace bolster
