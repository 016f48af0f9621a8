#include "ViewPrint.h"

#include "Ask.h"
#include "CoverView.h"
#include "MapLegend.h"
#include "Theme.h"
#include "ViewColors.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QLocale>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QPrintDialog>
#include <QPrinter>

#include <memory>

namespace bolster {

namespace {

struct ViewPrint {
    Q_DECLARE_TR_FUNCTIONS(ViewPrint)
};

constexpr double titlePoints = 16;
constexpr double datePoints = 9;
constexpr double legendScreenDpi = 96; // what widgets are made for
constexpr double pageMargin = 15;      // mm
constexpr double gapMm = 4;

QFont sheetFont(double points, bool bold)
{
    QFont font = QGuiApplication::font();
    font.setPointSizeF(points);
    font.setBold(bold);
    return font;
}

/// As on a light screen, whatever the window looks like. Returns its height.
double paintLegend(QPainter& painter, const QRectF& page, const ShownMapPtr& map, double dpi)
{
    if (!map)
        return 0;
    QWidget paper;
    paper.setPalette(lightPalette());
    paper.resize(1000, 1000);
    MapLegend legend(&paper);
    legend.setMap(map);
    const double scale = dpi / legendScreenDpi;
    const QSizeF size = scale * QSizeF(legend.size());
    painter.save();
    painter.translate(page.left(), page.bottom() - size.height());
    painter.scale(scale, scale);
    legend.render(&painter, {}, {}, QWidget::DrawChildren);
    painter.restore();
    return size.height();
}

} // namespace

ViewSheet sheetOf(CoverView& view, const QString& title)
{
    return {view.grabPicture(ViewColors::of(lightPalette())), title, QDateTime::currentDateTime(), view.map()};
}

bool paintSheet(QPagedPaintDevice& paper, const ViewSheet& sheet)
{
    QPainter painter;
    if (!painter.begin(&paper))
        return false;
    const double dpi = paper.logicalDpiX(), gap = gapMm / 25.4 * dpi;
    QRectF room(0, 0, paper.width(), paper.height());
    painter.setPen(Qt::black);
    painter.setFont(sheetFont(titlePoints, true));
    const double titleHeight = QFontMetricsF(painter.font(), &paper).height();
    painter.drawText(QRectF(room.left(), room.top(), room.width(), titleHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetricsF(painter.font(), &paper).elidedText(sheet.title, Qt::ElideMiddle, room.width()));
    room.adjust(0, titleHeight, 0, 0);
    painter.setFont(sheetFont(datePoints, false));
    const double dateHeight = QFontMetricsF(painter.font(), &paper).height();
    painter.drawText(QRectF(room.left(), room.top(), room.width(), dateHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     QLocale().toString(sheet.when, QLocale::LongFormat));
    room.adjust(0, dateHeight + gap, 0, 0);
    const double legend = paintLegend(painter, room, sheet.map, dpi);
    room.adjust(0, 0, 0, legend > 0 ? -legend - gap : 0);
    if (!sheet.picture.isNull()) {
        QRectF place({}, QSizeF(sheet.picture.size()).scaled(room.size(), Qt::KeepAspectRatio));
        place.moveCenter({room.center().x(), room.top() + place.height() / 2});
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(place, sheet.picture);
    }
    return painter.end();
}

void printSheet(QWidget* window, const ViewSheet& sheet)
{
    auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
    printer->setPageSize(QPageSize(QPageSize::A4));
    printer->setPageMargins({pageMargin, pageMargin, pageMargin, pageMargin}, QPageLayout::Millimeter);
    printer->setPageOrientation(sheet.picture.width() > sheet.picture.height() ? QPageLayout::Landscape
                                                                               : QPageLayout::Portrait);
    printer->setDocName(sheet.title);
    auto* dialog = new QPrintDialog(printer.get(), window);
    dialog->setWindowTitle(ViewPrint::tr("Print the view"));
    dialog->setOptions(QAbstractPrintDialog::PrintToFile | QAbstractPrintDialog::PrintShowPageSize);
    QObject::connect(dialog, qOverload<QPrinter*>(&QPrintDialog::accepted), window, [printer, sheet, window] {
        if (!paintSheet(*printer, sheet))
            tell(window, QMessageBox::Warning, ViewPrint::tr("The view could not be printed."),
                 ViewPrint::tr(
                     "The printer takes nothing at the moment. Look whether it is on and has paper, or print "
                     "to a file."));
    });
    QObject::connect(dialog, &QObject::destroyed, [printer] {}); // it uses it to its end
    openDialog(dialog);
}

} // namespace bolster
