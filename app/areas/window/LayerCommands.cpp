#include "LayerCommands.h"

#include "Commands.h"
#include "CoverView.h"
#include "PatternView.h"
#include "SolverLink.h"

namespace bolster {

LayerCommands::LayerCommands(Commands& commands, PatternView& pattern, CoverView& coverView, SolverLink& solver)
    : m_commands(commands)
    , m_pattern(pattern)
    , m_coverView(coverView)
    , m_solver(solver)
{
    commands.add(MenuPlace{"view.layers", tr("La&yers"), "view/2"});
    add();
    addOfScans();
    apply();
}

void LayerCommands::add()
{
    const auto show = [this](bool) { apply(); };
    m_commands.add({{.id = "layer.mesh",
                     .formerly = "triangulation",
                     .text = tr("&Triangulation"),
                     .icon = "mesh",
                     .keys = {Qt::Key_M},
                     .places = {"view.layers/1"},
                     .bar = 501,
                     .on = false,
                     .toggled = show},
                    {.id = "layer.checker",
                     .formerly = "checker",
                     .text = tr("Chec&ker"),
                     .icon = "checker",
                     .keys = {Qt::Key_C},
                     .places = {"view.layers/1"},
                     .bar = 502,
                     .on = false,
                     .toggled = show},
                    {.id = "layer.frames",
                     .formerly = "frame",
                     .text = tr("&Frame"),
                     .icon = "frame",
                     .keys = {Qt::Key_R},
                     .places = {"view.layers/1"},
                     .bar = 506,
                     .on = true,
                     .toggled = show},
                    {.id = "layer.points",
                     .formerly = "control-points",
                     .text = tr("Control po&ints"),
                     .icon = "points",
                     .places = {"view.layers/1"},
                     .bar = 504,
                     .on = true,
                     .toggled = show},
                    {.id = "layer.seams",
                     .formerly = "seams-and-fixations",
                     .text = tr("Sea&ms and fixations"),
                     .icon = "seams",
                     .keys = {Qt::Key_S},
                     .places = {"view.layers/1"},
                     .bar = 503,
                     .on = true,
                     .toggled = show},
                    {.id = "layer.curves",
                     .formerly = "fixation-curves",
                     .text = tr("Fixation c&urves"),
                     .icon = "curves",
                     .places = {"view.layers/1"},
                     .bar = 505,
                     .on = true,
                     .toggled = show},
                    {.id = "layer.handles",
                     .formerly = "handle-curves",
                     .text = tr("&Handle curves"),
                     .icon = "handle-curve",
                     .places = {"view.layers/1"},
                     .on = true,
                     .toggled = show},
                    {.id = "layer.fancy-seams",
                     .formerly = "fancy-seams",
                     .text = tr("Fanc&y seams"),
                     .icon = "fancy-seam",
                     .places = {"view.layers/1"},
                     .on = true,
                     .toggled = show},
                    {.id = "layer.cutting",
                     .text = tr("Cut lines, notches and la&bels"),
                     .icon = "notch",
                     .keys = {Qt::SHIFT | Qt::Key_C},
                     .places = {"view.layers/1"},
                     .bar = 508,
                     .on = false,
                     .toggled = show},
                    {.id = "layer.measurements",
                     .text = tr("M&easurements"),
                     .icon = "measure",
                     .places = {"view.layers/1"},
                     .on = true,
                     .toggled = show},
                    {.id = "layer.labels",
                     .formerly = "labels",
                     .text = tr("&Labels"),
                     .icon = "labels",
                     .places = {"view.layers/1"},
                     .on = true,
                     .toggled = show},
                    {.id = "layer.scans",
                     .formerly = "scans",
                     .text = tr("Sca&ns"),
                     .icon = "scan",
                     .keys = {Qt::Key_A},
                     .places = {"view.layers/1"},
                     .bar = 507,
                     .on = true,
                     .toggled = show},
                    {.id = "layer.ground",
                     .formerly = "ground",
                     .text = tr("Gr&ound"),
                     .places = {"view.layers/1"},
                     .on = true,
                     .toggled = show},
                    {.id = "layer.field",
                     .formerly = "cushioning",
                     .text = tr("Cushionin&g"),
                     .icon = "cushion",
                     .keys = {Qt::Key_U},
                     .places = {"view.layers/1"},
                     .on = false,
                     .toggled = show},
                    {.id = "layer.twins",
                     .formerly = "mirror-image-of-the-selection",
                     .text = tr("Mirror image of the &selection"),
                     .icon = "twin",
                     .places = {"view.layers/2"},
                     .on = true,
                     .toggled = show},
                    {.id = "layer.symmetry",
                     .formerly = "symmetry-axis-and-plane",
                     .text = tr("Symmetry &axis and plane"),
                     .places = {"view.layers/2"},
                     .on = true,
                     .toggled = show}});
}

void LayerCommands::addOfScans()
{
    const auto show = [this](bool) { apply(); };
    m_commands.add({{.id = "layer.scan-pairs",
                     .formerly = "pairs-of-cover-and-scan",
                     .text = tr("Pairs of co&ver and scan"),
                     .places = {"view.layers/3"},
                     .on = false,
                     .toggled = show},
                    {.id = "layer.scan-colors",
                     .formerly = "own-colours-of-scans",
                     .text = tr("Own &colours of scans"),
                     .places = {"view.layers/3"},
                     .on = true,
                     .visible = [this] { return m_coverView.shown().hasScanColors(); },
                     .toggled = show},
                    {.id = "layer.grid",
                     .formerly = "grid",
                     .text = tr("&Grid"),
                     .icon = "grid",
                     .keys = {Qt::Key_G},
                     .places = {"view.grid/1"},
                     .bar = 509,
                     .on = true,
                     .toggled = show}});
}

bool LayerCommands::on(const char* id)
{
    return m_commands[id]->isChecked();
}

void LayerCommands::apply()
{
    PatternLayers layers;
    layers.grid = on("layer.grid");
    layers.mesh = on("layer.mesh");
    layers.seams = on("layer.seams");
    layers.points = on("layer.points");
    layers.labels = on("layer.labels");
    layers.cutting = on("layer.cutting");
    layers.measurements = on("layer.measurements");
    layers.handles = on("layer.handles");
    layers.fancySeams = on("layer.fancy-seams");
    layers.twins = on("layer.twins");
    layers.symmetry = on("layer.symmetry");
    m_pattern.shown().setLayers(layers);

    m_coverView.setMeasurementsShown(on("layer.measurements"));
    using Layer = CoverView::Layer;
    for (const auto& [layer, id] :
         {std::pair(Layer::Checker, "layer.checker"), std::pair(Layer::MeshEdges, "layer.mesh"),
          std::pair(Layer::Seams, "layer.seams"), std::pair(Layer::Frames, "layer.frames"),
          std::pair(Layer::FixationCurves, "layer.curves"), std::pair(Layer::HandleCurves, "layer.handles"),
          std::pair(Layer::FancySeams, "layer.fancy-seams"), std::pair(Layer::Scans, "layer.scans"),
          std::pair(Layer::ScanPairs, "layer.scan-pairs"), std::pair(Layer::ScanColors, "layer.scan-colors"),
          std::pair(Layer::Twins, "layer.twins"), std::pair(Layer::Symmetry, "layer.symmetry"),
          std::pair(Layer::Ground, "layer.ground")})
        m_coverView.visibility().setLayerVisible(layer, on(id));
    if (on("layer.field") != m_coverView.visibility().layerVisible(Layer::Field)) {
        m_coverView.visibility().setLayerVisible(Layer::Field, on("layer.field"));
        m_solver.setFieldShown(on("layer.field"));
    }
}

} // namespace bolster
