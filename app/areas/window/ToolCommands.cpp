#include "ToolCommands.h"

#include "Commands.h"
#include "Docks.h"
#include "PatternView.h"

#include <QShortcut>

namespace bolster {

namespace {

bool isOfCutting(PatternToolKind kind)
{
    return kind == PatternToolKind::Notch || kind == PatternToolKind::DrillHole ||
           kind == PatternToolKind::EdgeAllowance || kind == PatternToolKind::CutCorner;
}

} // namespace

ToolCommands::ToolCommands(Commands& commands, PatternView& pattern, CoverView& coverView, const Docks& docks)
    : m_pattern(pattern)
    , m_coverView(coverView)
{
    add(commands);
    addInSurface(commands);
    connectViews(commands);
    // Escape ends it from a list, too: what has the keyboard is easily overlooked.
    for (QDockWidget* list : {docks.elements, docks.history, docks.seams, docks.fabrics, docks.spots})
        connect(new QShortcut(QKeySequence(Qt::Key_Escape), list, nullptr, nullptr, Qt::WidgetWithChildrenShortcut),
                &QShortcut::activated, this, &ToolCommands::end);
}

void ToolCommands::add(Commands& commands)
{
    using Kind = PatternToolKind;
    const struct {
        Kind kind;
        const char* id;
        const char* formerly;
        QString text;
        const char* icon;
        QKeySequence keys;
    } tools[] = {
        {Kind::Select, "tool.select", "select-and-move", tr("&Select and move"), "select", Qt::Key_V},
        {Kind::Outline, "tool.outline", "draw-outline", tr("Draw &outline"), "outline", Qt::Key_O},
        {Kind::Rectangle, "tool.rectangle", "draw-rectangle", tr("Draw &rectangle"), "rectangle",
         Qt::SHIFT | Qt::Key_R},
        {Kind::Ellipse, "tool.ellipse", "draw-ellipse", tr("Draw &ellipse"), "ellipse", Qt::SHIFT | Qt::Key_E},
        {Kind::Split, "tool.split", "split-patch", tr("S&plit patch"), "split", Qt::Key_K},
        {Kind::Dart, "tool.dart", "", tr("Draw &dart"), "dart", Qt::SHIFT | Qt::Key_D},
        {Kind::HandleCurve, "tool.handle-curve", "draw-handle-curve", tr("Draw &handle curve"), "handle-curve",
         Qt::Key_H},
        {Kind::FancySeam, "tool.fancy-seam", "draw-fancy-seam", tr("Draw &fancy seam"), "fancy-seam", Qt::Key_N},
        {Kind::Sew, "tool.sew", "sew", tr("Se&w"), "sew", Qt::Key_W},
        {Kind::Attach, "tool.attach", "attach-to-fixation-curve", tr("&Attach to fixation curve"), "attach",
         Qt::SHIFT | Qt::Key_A},
        {Kind::Trim, "tool.trim", "stitch-or-pipe-a-seam", tr("Stitch or pipe a seam"), "outline-trim",
         Qt::SHIFT | Qt::Key_T},
        {Kind::InternalLine, "cutting.internal-line", "", tr("Draw &internal line"), "internal-line", {}},
        {Kind::EdgeAllowance, "cutting.edge-allowance", "", tr("Allowance of an ed&ge"), "edge-allowance", {}},
        {Kind::CutCorner, "cutting.cut-corner", "", tr("&Corner of the cut line"), "cut-corner", {}},
        {Kind::Notch, "cutting.notch", "", tr("Place &notches"), "notch", Qt::SHIFT | Qt::Key_N},
        {Kind::DrillHole, "cutting.drill-hole", "", tr("Place &drill holes"), "drill-hole", {}},
        {Kind::Measure, "tool.measure", "measure", tr("&Measure"), "measure", Qt::SHIFT | Qt::Key_M},
    };
    commands.add(MenuPlace{"pattern.cutting", tr("&Cutting"), "pattern/2"});
    int bar = 301;
    for (const auto& row : tools) {
        const bool cutting = QByteArrayView(row.id).startsWith("cutting.");
        QList<const char*> places{cutting ? "pattern.cutting/1" : "pattern/1"};
        if (row.kind == Kind::Sew)
            places.append("seam/1");
        commands.add({.id = row.id,
                      .formerly = row.formerly,
                      .text = row.text,
                      .icon = row.icon,
                      .keys = row.keys.isEmpty() ? QList<QKeySequence>() : QList{row.keys},
                      .places = places,
                      .bar = cutting ? 0 : bar++,
                      .checked = [this, kind = row.kind] { return isOn(kind); },
                      .does =
                          [this, &commands, kind = row.kind] {
                              if (isOfCutting(kind)) // what is placed shall be seen
                                  commands["layer.cutting"]->setChecked(true);
                              begin(kind);
                          }});
    }
}

void ToolCommands::addInSurface(Commands& commands)
{
    commands.add({.id = "tool.draw-fixation",
                  .formerly = "draw-fixation-curve",
                  .text = tr("&Draw fixation curve"),
                  .icon = "draw-fixation",
                  .keys = {Qt::SHIFT | Qt::Key_F},
                  .places = {"frame/1"},
                  .bar = 320,
                  .checked = [this] { return isOn(CoverToolKind::DrawFixation); },
                  .does =
                      [this] {
                          const bool on = isOn(CoverToolKind::DrawFixation);
                          m_coverView.setTool(on ? CoverToolKind::Select : CoverToolKind::DrawFixation);
                      }});
}

/// Whoever begins a tool in one view has ended the one in the other; only measuring goes on in both.
void ToolCommands::connectViews(Commands& commands)
{
    connect(&m_pattern, &PatternView::toolChanged, this, [this, &commands](PatternToolKind now) {
        if (now != PatternToolKind::Select || m_coverView.tool() == CoverToolKind::Measure)
            m_coverView.setTool(now == PatternToolKind::Measure ? CoverToolKind::Measure : CoverToolKind::Select);
        commands.update();
    });
    connect(&m_coverView, &CoverView::toolChanged, this, [this, &commands](CoverToolKind now) {
        if (now == CoverToolKind::Measure)
            m_pattern.setTool(PatternToolKind::Measure);
        else if (now != CoverToolKind::Select || m_pattern.tool() == PatternToolKind::Measure)
            m_pattern.setTool(PatternToolKind::Select);
        commands.update();
    });
}

bool ToolCommands::isOn(PatternToolKind kind) const
{
    const bool measures = kind == PatternToolKind::Measure;
    return m_coverView.tool() == (measures ? CoverToolKind::Measure : CoverToolKind::Select) &&
           m_pattern.tool() == kind;
}

/// Or ends it, when it is the present one.
void ToolCommands::begin(PatternToolKind kind)
{
    const bool on = isOn(kind);
    m_coverView.setTool(CoverToolKind::Select);
    m_pattern.setTool(on ? PatternToolKind::Select : kind);
}

void ToolCommands::end()
{
    m_pattern.setTool(PatternToolKind::Select);
    m_coverView.setTool(CoverToolKind::Select);
}

} // namespace bolster
