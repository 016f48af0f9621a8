#include "HelpDialogs.h"

#include "Commands.h"
#include "Icons.h"
#include "MouseStyle.h"
#include "Units.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLocale>
#include <QScrollArea>
#include <QVBoxLayout>

namespace bolster {

namespace {

class HelpDialogs {
    Q_DECLARE_TR_FUNCTIONS(HelpDialogs)
};

using Rows = QList<std::pair<QString, QString>>;

QString headingText(const QString& text)
{
    return QStringLiteral("<h3 style='margin-bottom:4px'>%1</h3>").arg(text.toHtmlEscaped());
}

QString table(const Rows& rows)
{
    QString html = QStringLiteral("<table cellspacing='0' cellpadding='3'>");
    for (const auto& [name, value] : rows)
        html += QStringLiteral("<tr><td>%1</td><td width='24'></td><td><b>%2</b></td></tr>")
                    .arg(name.toHtmlEscaped(), value.toHtmlEscaped());
    return html + QStringLiteral("</table>");
}

/// Scrolls when it is long; closes with Escape.
void showText(QWidget* parent, const QString& title, const QString& html, const QSize& size)
{
    auto* dialog = new QDialog(parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    auto* label = new QLabel(html, dialog);
    label->setTextFormat(Qt::RichText);
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    label->setContentsMargins(16, 6, 16, 12);
    label->setTextInteractionFlags(Qt::TextBrowserInteraction);
    label->setOpenExternalLinks(true);
    auto* scroll = new QScrollArea(dialog);
    scroll->setWidget(label);
    scroll->setWidgetResizable(true);
    scroll->setAccessibleName(dialog->windowTitle());
    scroll->setFrameShape(QFrame::NoFrame);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(scroll, 1);
    layout->addWidget(buttons);
    dialog->resize(size);
    dialog->show();
}

Rows mouseInPattern()
{
    return {
        {HelpDialogs::tr("Select"), HelpDialogs::tr("click; Shift+click adds; drag a box")},
        {HelpDialogs::tr("Move control points or patches"),
         HelpDialogs::tr("drag; Shift keeps to one axis; Esc takes it back")},
        {HelpDialogs::tr("Select an edge"),
         HelpDialogs::tr("click the outline; drag it then to move it; L types its length")},
        {HelpDialogs::tr("Commands for what lies there"), HelpDialogs::tr("right button")},
        {HelpDialogs::tr("A number instead of a drag"),
         HelpDialogs::tr("type it while dragging: 50, 30, 20, for sizes 300 x 200 or 120 %; Enter lets go")},
        {HelpDialogs::tr("Turn patches"), HelpDialogs::tr("drag the round handle; Shift in steps of 15\u00b0")},
        {HelpDialogs::tr("Move the ends of a seam or fixation"),
         HelpDialogs::tr("select it and drag the round handles at its ends")},
        {HelpDialogs::tr("Add a control point"), HelpDialogs::tr("double click on an outline or curve")},
        {HelpDialogs::tr("Draw a handle curve or a fancy seam"),
         HelpDialogs::tr("click points; Enter or double click ends; click the first one to close; B: straight or "
                         "smooth")},
        {HelpDialogs::tr("Sew"), HelpDialogs::tr("click two edges; drag or Shift+click takes a part of one; "
                                                 "Ctrl+click several in a row, Enter sews them; F: flip")},
        {HelpDialogs::tr("Attach to the selected fixation curve"),
         HelpDialogs::tr("click edges; Shift+click collects several; Esc ends")},
        {HelpDialogs::tr("Stitch or pipe a seam or an edge"),
         HelpDialogs::tr("click it; stitches and piping are in the properties")},
        {HelpDialogs::tr("Draw an outline"),
         HelpDialogs::tr(
             "click corners, drag smooth points, or type 500, 500<30 or 120, 40; Enter or a click on the "
             "first point closes")},
        {HelpDialogs::tr("Not snapped"), HelpDialogs::tr("hold Ctrl or Alt")},
        {HelpDialogs::tr("Select in a loop"), HelpDialogs::tr("Alt and drag")},
        {HelpDialogs::tr("Move by %1, by %2").arg(lengthText(nudgeLength(false)), lengthText(nudgeLength(true))),
         HelpDialogs::tr("arrow keys, Shift+arrow keys")},
        {HelpDialogs::tr("Next patch or control point, previous one"), HelpDialogs::tr("Tab, Shift+Tab")},
        {HelpDialogs::tr("Pan"),
         HelpDialogs::tr("%1, or Space and drag").arg(allMouseTexts(MouseView::Pattern, ViewMove::Pan))},
        {HelpDialogs::tr("Zoom"), allMouseTexts(MouseView::Pattern, ViewMove::Zoom)}};
}

Rows mouseInCover()
{
    return {{HelpDialogs::tr("Turn"),
             HelpDialogs::tr("%1, or drag beside the cover").arg(allMouseTexts(MouseView::Cover, ViewMove::Turn))},
            {HelpDialogs::tr("Pan"), allMouseTexts(MouseView::Cover, ViewMove::Pan)},
            {HelpDialogs::tr("Commands for what lies there"), HelpDialogs::tr("right button, without a drag")},
            {HelpDialogs::tr("Zoom"), allMouseTexts(MouseView::Cover, ViewMove::Zoom)},
            {HelpDialogs::tr("Move control points of curves"),
             HelpDialogs::tr(
                 "drag; those on a frame stay on it: Ctrl lifts them off, S lets go; X, Y, Z keep to an axis")},
            {HelpDialogs::tr("Draw a fixation curve"),
             HelpDialogs::tr("click points on a frame; Enter or double click ends; click the first one to close")}};
}

} // namespace

void showAbout(QWidget* parent)
{
    const QString html =
        QStringLiteral("<h2>Bolster %1</h2>").arg(QCoreApplication::applicationVersion()) +
        QStringLiteral("<p>%1</p><p>%2</p><p>%3</p>")
            .arg(HelpDialogs::tr(
                     "A workbench for people who design upholstered furniture and car seats: a sewing pattern, its "
                     "seams and its fixation on the frame become the cover, live."),
                 HelpDialogs::tr(
                     "The surface is computed after the published method of sewing patterns on static constraints; "
                     "docs/solver.md names the paper and what is different."),
                 HelpDialogs::tr(
                     "Free software under the GNU General Public License, version 3 or later. It comes without any "
                     "warranty. Built with Qt, Eigen, CGAL, SuiteSparse, Embree and OpenImageIO."));
    showText(parent, HelpDialogs::tr("About Bolster"), html, {460, 340});
}

void showShortcuts(QWidget* parent, const Commands& commands)
{
    Rows keys;
    for (const QAction* action : commands.all()) {
        if (action->shortcut().isEmpty())
            continue;
        QString name = action->iconText(); // "Undo", not what it would undo now
        keys.append({name.remove(u'&').remove(QStringLiteral(" \u2026")),
                     action->shortcut().toString(QKeySequence::NativeText)});
    }
    const QString html = headingText(HelpDialogs::tr("In the pattern")) + table(mouseInPattern()) +
                         headingText(HelpDialogs::tr("In the 3D view")) + table(mouseInCover()) +
                         headingText(HelpDialogs::tr("Keys")) + table(keys);
    showText(parent, HelpDialogs::tr("Keys and mouse"), html, {560, 620});
}

void showFigures(QWidget* parent, const SolveReport& report)
{
    const QLocale locale;
    const auto count = [&](auto n) { return locale.toString(static_cast<qlonglong>(n)); };
    const auto time = [](double ms) { return HelpDialogs::tr("%1 ms").arg(decimalText(ms, 1, false)); };
    const Rows mesh{{HelpDialogs::tr("Patches, seams"),
                     HelpDialogs::tr("%1, %2").arg(count(report.patches), count(report.seams))},
                    {HelpDialogs::tr("Vertices after sewing"), count(report.vertices)},
                    {HelpDialogs::tr("Triangles"), count(report.triangles)},
                    {HelpDialogs::tr("Vertices held by fixations"), count(report.constraints.fixed)},
                    {HelpDialogs::tr("Sewn pairs"), count(report.constraints.sewn)}};
    const Rows quality{
        {HelpDialogs::tr("Largest gap at seams"), lengthText(report.seamGap.max, 4)},
        {HelpDialogs::tr("Largest distance from fixations"), lengthText(report.fixationError.max, 4)},
        {HelpDialogs::tr("Curves to fixed outlines between vertices"), lengthText(report.fixationDeviation, 2)},
        {HelpDialogs::tr("Strain: root mean square, 99 %, largest"),
         HelpDialogs::tr("%1, %2, %3")
             .arg(percentText(report.strain.rms), percentText(report.strain.p99), percentText(report.strain.max))},
        {HelpDialogs::tr("Area of the cover, of the pattern"),
         HelpDialogs::tr("%1, %2").arg(areaText(report.area, 3), areaText(report.restArea, 3))},
        {HelpDialogs::tr("Turned triangles"), count(report.flippedTriangles)}};
    const Rows times{
        {HelpDialogs::tr("Iterations"), count(report.iterations)},
        {HelpDialogs::tr("Triangulation"), time(report.time.triangulate)},
        {HelpDialogs::tr("Assembly and factorisation"), time(report.time.assemble + report.time.factor)},
        {HelpDialogs::tr("One iteration"), time(report.time.perIteration)}};
    const QString html = headingText(HelpDialogs::tr("Mesh")) + table(mesh) +
                         headingText(HelpDialogs::tr("Surface")) + table(quality) +
                         headingText(HelpDialogs::tr("Computation")) + table(times);
    showText(parent, HelpDialogs::tr("Figures of the surface"), html, {520, 560});
}

} // namespace bolster
