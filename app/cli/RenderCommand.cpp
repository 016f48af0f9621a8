#include "Commands.h"
#include "ContactSheet.h"
#include "DesignHash.h"
#include "FabricBaking.h"
#include "Interrupt.h"
#include "Output.h"
#include "PictureScene.h"
#include "Project.h"
#include "RenderOrder.h"
#include "Solving.h"
#include "WholeFile.h"

#include <QFileInfo>
#include <QTemporaryDir>

#include <cmath>
#include <limits>
#include <numbers>

namespace bolster::cli {

const char* const renderHelp = R"(Usage: bolster render DESIGN --image FILE [options]

Sews and stretches the pattern of a design (JSON or a project) and draws the cover
at rest as it will look: in its fabrics, with soft light and shadow. The same
picture on every run and number of threads.

Options:
  --image FILE       .png (8 bits), .tif (16 bits) or .exr (linear light)
  --size WxH         pixels (default 1280x960, at most 64 million)
  --view VIEW        three-quarter (default), front, back, left, right, top, or
                     azimuth,elevation in degrees from the front: 30,20
  --samples N        rays per pixel, a square number (default 16, at most 256)
  --fabric NAME      in the fabrics of this colourway
  --map MAP          instead of fabrics: strain, along, across, shear, curvature,
                     thickness, checker
  --turntable N      N pictures around the cover: FILE-001.png, FILE-002.png ...
  --sheet            all colourways in one picture, with their names
  --transparent      no background; the shadow is kept
  --threads N        use N threads (default 0: as many as the machine has)

Exit code:
  0  done
  1  other failures: a picture cannot be written, not enough memory, interrupted
  2  the design is bad (see "bolster check"), or wrong usage
  3  not converged; the pictures are written nevertheless
)";

namespace {

/// Everything that the pictures of one run have in common.
class Studio {
public:
    Studio(const RenderOrder& order, const OpenedDesign& opened, SurfaceMeshPtr surface, std::stop_token stop)
        : m_order(order)
        , m_opened(opened)
        , m_surface(std::move(surface))
        , m_cover(refinedForPicture(m_surface))
        , m_stop(stop)
        , m_bake(order.design, opened.design, order.options.threads, std::move(stop))
    {}

    /// False when something could not be drawn or written; it has been said then.
    bool drawAll();

private:
    PreviewScene scene(ElementId colourway);
    PreviewImage draw(const PreviewRenderer& renderer, const PreviewScene& scene, double turn) const;
    PreviewImage drawSheet();
    bool drawTurntable();
    bool write(const PreviewImage& image, const QString& path) const;
    QString turntablePath(int picture) const;
    void printMap(const CoverMap& map) const;

    const RenderOrder& m_order;
    const OpenedDesign& m_opened;
    SurfaceMeshPtr m_surface;
    CoverMeshPtr m_cover;
    std::stop_token m_stop;
    FabricBaking m_bake;
};

/// The id of the colourway of this name; settingsId for "" and for names that there are none of.
ElementId colourwayNamed(const Design& design, const std::string& name)
{
    ElementId found = settingsId;
    design.each<Colourway>([&](ElementId id, const Colourway& colourway) {
        if (!name.empty() && colourway.name == name)
            found = id;
    });
    return found;
}

/// "Black, Cognac"
std::string colourwayNames(const Design& design)
{
    std::string names;
    design.each<Colourway>([&](ElementId, const Colourway& colourway) {
        names.append(names.empty() ? "\"" : ", \"").append(colourway.name).append("\"");
    });
    return names;
}

/// What of the order cannot be done with this design, or "".
std::string orderProblem(const RenderOrder& order, const Design& design)
{
    const std::string names = colourwayNames(design);
    if (!order.colourway.empty() && colourwayNamed(design, order.colourway) == settingsId)
        return "the design has no colourway \"" + order.colourway + "\"; " +
               (names.empty() ? std::string("it has none") : "there are " + names);
    if (!order.sheet)
        return {};
    if (names.empty())
        return "the design has no colourways to put on a sheet";
    std::size_t count = 0;
    design.each<Colourway>([&](ElementId, const Colourway&) { ++count; });
    const auto [columns, rows] = sheetGrid(count);
    const std::int64_t height = order.options.height + sheetCaption(order.options.width, order.options.height);
    if (columns * static_cast<std::int64_t>(order.options.width) * rows * height > mostPixels)
        return "the sheet of " + std::to_string(count) + " colourways would have more than " +
               std::to_string(mostPixels / 1'000'000) + " million pixels; choose a smaller --size";
    return {};
}

PreviewScene Studio::scene(ElementId colourway)
{
    if (m_order.map) {
        const CoverMap map = coverMap(*m_order.map, *m_surface, m_opened.design, m_opened.files);
        printMap(map);
        return sceneWithMap(m_surface, m_cover, map);
    }
    if (m_order.checker)
        return sceneWithChecker(m_surface, m_cover, m_opened.design, colourway);
    return sceneInFabrics(m_surface, m_cover, m_opened.design, colourway,
                          [this](ElementId id, const Fabric& fabric) { return m_bake(id, fabric); });
}

PreviewImage Studio::draw(const PreviewRenderer& renderer, const PreviewScene& scene, double turn) const
{
    PictureDirection from = m_order.direction;
    from.azimuth += turn;
    const double aspect = static_cast<double>(m_order.options.width) / m_order.options.height;
    return renderer.render(pictureView(scene, from, aspect), m_order.options, m_stop);
}

PreviewImage Studio::drawSheet()
{
    std::vector<SheetPicture> pictures;
    m_opened.design.each<Colourway>([&](ElementId id, const Colourway& colourway) {
        const PreviewScene shown = scene(id);
        if (!m_stop.stop_requested())
            pictures.push_back({draw(PreviewRenderer(shown), shown, 0), colourway.name});
    });
    if (m_stop.stop_requested())
        return {};
    std::string problem;
    PreviewImage sheet = contactSheet(pictures, m_order.options.transparent, problem);
    if (!problem.empty())
        printError("warning: " + problem);
    return sheet;
}

/// "chair.png" becomes "chair-001.png".
QString Studio::turntablePath(int picture) const
{
    const QFileInfo info(m_order.image);
    const QString number = QString::number(picture + 1).rightJustified(3, u'0');
    return info.path() + "/" + info.completeBaseName() + "-" + number + "." + info.suffix();
}

bool Studio::drawTurntable()
{
    const PreviewScene shown = scene(colourwayNamed(m_opened.design, m_order.colourway));
    const PreviewRenderer renderer(shown);
    for (int picture = 0; picture < m_order.turntable; ++picture) {
        const double turn = 2 * std::numbers::pi * picture / m_order.turntable;
        if (!write(draw(renderer, shown, turn), turntablePath(picture)))
            return false;
    }
    return true;
}

bool Studio::drawAll()
{
    if (m_order.turntable > 0)
        return drawTurntable();
    if (m_order.sheet)
        return write(drawSheet(), m_order.image);
    const ElementId own = m_opened.design.settings().colourway;
    const PreviewScene shown =
        scene(m_order.colourway.empty() ? own : colourwayNamed(m_opened.design, m_order.colourway));
    return write(draw(PreviewRenderer(shown), shown, 0), m_order.image);
}

/// Written into a temporary folder first, so that half a picture never takes the place of an older one.
bool Studio::write(const PreviewImage& image, const QString& path) const
{
    if (image.empty()) {
        printError("error: \"" + path.toStdString() + "\" was not drawn: interrupted");
        return false;
    }
    const PictureNotes notes{QFileInfo(m_order.design).fileName().toStdString(),
                             hexText(hashOf(m_opened.design)).substr(0, 12), m_order.viewName};
    const QTemporaryDir folder;
    const QString temporary = folder.filePath("picture");
    if (const std::string problem = writePicture(image, m_order.format, temporary.toStdString(), notes);
        !problem.empty()) {
        printError("error: \"" + path.toStdString() + "\" cannot be written: " + problem);
        return false;
    }
    const WholeFile file = readWholeFile(temporary, std::numeric_limits<int>::max());
    const Message problem = file.problem.empty() ? replaceWholeFile(path, file.bytes) : file.problem;
    if (!problem.empty())
        printError("error: " + problem.english());
    else
        printResult("wrote " + path.toStdString());
    return problem.empty();
}

/// What the colours mean, and where to look.
void Studio::printMap(const CoverMap& map) const
{
    const bool strain = !map.allowed.empty();
    const std::string unit = strain ? " %" : map.kind == CoverMap::Kind::Thickness ? " mm" : " 1/m";
    const auto number = [&](float value) { return numberText(static_cast<double>(value), 3) + unit; };
    printResult("colours from " + number(map.scale.kind == MapScale::Kind::Diverging ? -map.scale.limit : 0) +
                " to " + number(map.scale.limit));
    for (const CoverSpot& spot : worstSpots(map, *m_surface, strain ? 5 : 0, 60)) {
        std::string line = number(spot.value) + " in ";
        for (const SurfaceTopology::PatchRange& range : m_surface->topology->patches)
            if (spot.vertex >= range.firstVertex && spot.vertex < range.firstVertex + range.vertexCount)
                line += elementLabel(range.patch, *m_opened.design.element(range.patch));
        const Vec2& at = m_surface->topology->pattern[spot.vertex];
        line += " at " + numberText(at.x(), 4) + ", " + numberText(at.y(), 4) + " mm";
        if (std::abs(spot.value) > map.allowedAt(spot.vertex))
            line += ": over the fabric's limit of " + number(map.allowedAt(spot.vertex));
        printResult(line);
    }
}

} // namespace

int render(std::span<const std::string> words)
{
    const RenderOrder order = RenderOrder::from(words);
    const Interrupt interrupt;
    const OpenedDesign opened = openDesignOrProject(order.design);
    if (QFileInfo::exists(order.image) && QFileInfo(order.image) == QFileInfo(order.design))
        throw UsageError("--image would overwrite the design");
    SolveOptions options;
    options.threads = order.options.threads;
    if (const std::string problem = opened.readable ? orderProblem(order, opened.design) : ""; !problem.empty())
        throw UsageError(problem);
    const SolveResult result = solveOpened(opened, options, interrupt.token());
    printFindings(result);
    if (!result.surface)
        return result.status == SolveResult::Status::Failed && !result.errors.empty() ? badInput : otherFailure;
    if (!Studio(order, opened, result.surface, interrupt.token()).drawAll())
        return otherFailure;
    return result.status == SolveResult::Status::NotConverged ? notConverged : done;
}

} // namespace bolster::cli
