#include "SewingSheet.h"

#include "PieceDrawing.h"

#include <QBuffer>
#include <QLocale>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>

#include <cmath>

namespace bolster {

namespace {

constexpr int sheetDots = 300;       // per inch
constexpr int drawingPixels = 220;   // of the drawing of a piece
constexpr double drawingPoints = 52; // on paper
constexpr double pageWidth = 480;    // points between the margins of an A4

QString number(double value, int decimals)
{
    const double step = std::pow(10, -decimals);
    return QLocale().toString(std::abs(value) < step / 2 ? 0.0 : value, 'f', decimals); // never "-0"
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

QString table(const QStringList& header, const QString& rows)
{
    return QStringLiteral("<table width=\"100%\" cellspacing=\"0\" cellpadding=\"3\" border=\"0.5\" "
                          "style=\"border-collapse:collapse; border-color:#b0b0b0\">") +
           heads(header) + rows + QStringLiteral("</table>");
}

/// Cut line, sewing line, notches and grain, as large as fits.
QImage drawingOf(const CutPiece& piece)
{
    QImage image(drawingPixels, drawingPixels, QImage::Format_RGB32);
    image.fill(Qt::white);
    const Box2 box = piece.box();
    if (box.isEmpty())
        return image;
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const double scale = (drawingPixels - 8) / std::max(1.0, box.sizes().maxCoeff());
    painter.translate(drawingPixels / 2.0, drawingPixels / 2.0);
    painter.scale(scale, -scale);
    painter.translate(-box.center().x(), -box.center().y());
    CutLayers layers;
    layers.labels = false;
    drawPiece(painter, piece, {}, layers, 6 / scale);
    return image;
}

} // namespace

SewingSheet::SewingSheet(const Design& design, const SewingPlan& plan, std::vector<QImage> pictures, QString date)
    : m_design(design)
    , m_plan(plan)
    , m_pictures(std::move(pictures))
    , m_date(std::move(date))
{}

QByteArray SewingSheet::pdf(const PaperSize& paper) const
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(sheetDots);
    writer.setPageSize(QPageSize(paper.size, QPageSize::Millimeter));
    writer.setPageMargins(QMarginsF()); // QTextDocument leaves 20 mm
    writer.setTitle(title());
    QTextDocument document;
    document.setDefaultFont(QFont(QStringLiteral("sans-serif"), 8));
    for (std::size_t i = 0; i < m_pictures.size(); ++i)
        document.addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("cover:%1").arg(i)), m_pictures[i]);
    for (std::size_t i = 0; i < m_plan.pattern.pieces.size(); ++i)
        document.addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("piece:%1").arg(i)),
                             drawingOf(m_plan.pattern.pieces[i]));
    document.setHtml(html());
    document.print(&writer); // page numbers are its own
    buffer.close();
    return bytes;
}

QString SewingSheet::title() const
{
    QString name = QString::fromStdString(m_plan.pattern.style);
    if (!m_plan.pattern.version.empty())
        name += QStringLiteral(" ") + QString::fromStdString(m_plan.pattern.version);
    return name.isEmpty() ? tr("Sewing sheet") : tr("Sewing sheet: %1").arg(name);
}

QString SewingSheet::html() const
{
    QString text = QStringLiteral("<h2>%1</h2>").arg(title().toHtmlEscaped());
    if (!m_date.isEmpty())
        text += QStringLiteral("<p>%1</p>").arg(m_date.toHtmlEscaped());
    text += pictureRow();
    text += QStringLiteral("<h3>%1</h3>").arg(tr("Materials")) + needs();
    text += QStringLiteral("<h3>%1</h3>").arg(tr("Pieces")) + pieceTable();
    text += QStringLiteral("<h3>%1</h3>").arg(tr("Seams in the order of sewing")) + seamTable();
    return text;
}

QString SewingSheet::pictureRow() const
{
    if (m_pictures.empty())
        return {};
    QString row = QStringLiteral("<table width=\"100%\" cellspacing=\"4\"><tr>");
    const double width = pageWidth / static_cast<double>(m_pictures.size()) - 12;
    for (std::size_t i = 0; i < m_pictures.size(); ++i)
        row += QStringLiteral("<td><img src=\"cover:%1\" width=\"%2\"/></td>").arg(i).arg(qRound(width));
    return row + QStringLiteral("</tr></table>");
}

QString SewingSheet::pieceTable() const
{
    QString rows;
    for (std::size_t i = 0; i < m_plan.pattern.pieces.size(); ++i) {
        const CutPiece& piece = m_plan.pattern.pieces[i];
        const Vec2 size = piece.box().isEmpty() ? Vec2(0, 0) : Vec2(piece.box().sizes());
        const QString count =
            piece.pair ? tr("%1 and %1 mirrored").arg(piece.quantity) : QString::number(piece.quantity);
        rows += QStringLiteral("<tr>") +
                cell(QStringLiteral("<img src=\"piece:%1\" width=\"%2\"/>").arg(i).arg(drawingPoints)) +
                cell(QString::fromStdString(piece.name).toHtmlEscaped()) + cell(count) +
                cell(QString::fromStdString(piece.fabricName).toHtmlEscaped()) +
                cell(tr("%1 \u00d7 %2 mm").arg(number(size.x(), 0), number(size.y(), 0)), "right") +
                cell(tr("%1 m\u00b2").arg(number(std::abs(areaOf(piece.cut)) / 1e6, 3)), "right") +
                QStringLiteral("</tr>");
    }
    return table({QString(), tr("Piece"), tr("Quantity"), tr("Fabric"), tr("Size as cut"), tr("Area as cut")},
                 rows);
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

QString SewingSheet::seamTable() const
{
    const auto name = [this](ElementId id) {
        const Patch* patch = m_design.find<Patch>(id);
        return patch ? QString::fromStdString(patch->name).toHtmlEscaped() : QString();
    };
    QString rows;
    int step = 0;
    for (const PlannedSeam& seam : m_plan.seams) {
        const QString allowance = std::abs(seam.allowanceA - seam.allowanceB) < 1e-6
                                      ? number(seam.allowanceA, 1)
                                      : tr("%1 and %2").arg(number(seam.allowanceA, 1), number(seam.allowanceB, 1));
        const QString both = seam.patchA == seam.patchB ? tr("%1, with itself").arg(name(seam.patchA))
                                                        : tr("%1 to %2").arg(name(seam.patchA), name(seam.patchB));
        rows += QStringLiteral("<tr>") + cell(QString::number(++step), "right") + cell(both) +
                cell(tr("%1 and %2").arg(number(seam.lengthA, 0), number(seam.lengthB, 0)), "right") +
                cell(number(seam.ease, 1), "right") + cell(allowance, "right") +
                cell(QString::number(seam.notches), "right") + cell(stitchOf(seam)) + QStringLiteral("</tr>");
    }
    return table(
        {QString(), tr("Seam"), tr("Lengths, mm"), tr("Ease, %"), tr("Allowance, mm"), tr("Notches"), tr("Stitch")},
        rows);
}

QString SewingSheet::needs() const
{
    QString rows;
    const auto add = [&rows](const QString& what, const QString& much) {
        rows += QStringLiteral("<tr>") + cell(what) + cell(much, "right") + QStringLiteral("</tr>");
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
    return table({tr("What"), tr("How much")}, rows);
}

} // namespace bolster
