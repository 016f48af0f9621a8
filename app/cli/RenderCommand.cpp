#include "DesignHash.h"
#include "FabricBaking.h"
#include "Interrupt.h"
#include "Output.h"
#include "OutputFiles.h"
#include "PictureSeries.h"
#include "Project.h"
#include "RenderOrder.h"
#include "Solving.h"
#include "Subcommands.h"
#include "WholeFile.h"

#include <QFileInfo>

#include <cmath>
#include <numbers>
#include <utility>

namespace bolster::cli {

const char* const renderHelp = R"(Usage: bolster render DESIGN --image FILE [options]

Sews and stretches the pattern of a design (JSON or a project) and draws the cover
at rest as it will look: in its fabrics, with soft light and shadow. The same
picture on every run and number of threads.

Options:
  --image FILE       .png (8 bits), .tif (16 bits) or .exr (linear light)
  --size WxH         pixels (default 1280x960, at most 64 million)
  --view VIEW        three-quarter (default), front, back, left, right, top, or
                     azimuth,elevation in degrees from the front: 30,20, or
                     the name of a view that was saved in the window
  --samples N        rays per pixel, a square number (default 16, at most 256)
  --fabric NAME      in the fabrics of this colourway
  --map MAP          instead of fabrics: strain, along, across, shear, curvature,
                     thickness, deviation, checker
  --turntable N      N pictures around the cover: FILE-001.png, FILE-002.png ...
  --sheet            all colourways in one picture, with their names
  --no-frame         the cover alone, without its frames and foam
  --transparent      no background; the shadow is kept
  --threads N        use N threads (default 0: as many as the machine has)

Instead of --image, for many pictures:
  --all DIR          every colourway from every view, into a folder of its own; pictures
                     that are there already are not drawn again
  --views A,B,...    from these (default all six words above), separated by commas
  --format WORD      png (default), tif or exr
  --part I/N         only every Nth picture, from the Ith (0 to N-1) on
  --slurm            lets jobs of Slurm draw them, and waits
  --jobs N           jobs of an array (4)
  --sbatch WORDS     more options for sbatch, with blanks between them

Exit code:
  0  done
  1  other failures: a picture cannot be written, not enough memory, interrupted
  2  the design is bad (see "bolster check"), or wrong usage
  3  not converged; the pictures are written nevertheless
)";

namespace {

std::string figure(const CoverMap& map, float value)
{
    const char* const unit = !map.allowed.empty() ? " %" : map.kind == CoverMap::Kind::Curvature ? " 1/m" : " mm";
    return numberText(static_cast<double>(value), 3) + unit;
}

PictureLegend legendOf(const CoverMap& map)
{
    const char* const title = map.kind == CoverMap::Kind::Strain      ? "Largest strain"
                              : map.kind == CoverMap::Kind::Along     ? "Strain along the grain"
                              : map.kind == CoverMap::Kind::Across    ? "Strain across the grain"
                              : map.kind == CoverMap::Kind::Shear     ? "Shear"
                              : map.kind == CoverMap::Kind::Curvature ? "Mean curvature"
                              : map.kind == CoverMap::Kind::Thickness ? "Distance to the frame"
                                                                      : "Deviation from the scan";
    const bool both = map.scale.kind == MapScale::Kind::Diverging;
    const char* const over = map.allowed.empty() ? "" : "over the fabric's limit";
    return {map.scale, title, figure(map, both ? -map.scale.limit : 0), "0", figure(map, map.scale.limit), over};
}

/// Everything that the pictures of one run have in common.
class Pictures {
public:
    Pictures(const RenderOrder& order, const OpenedDesign& opened, SurfaceMeshPtr surface, std::stop_token stop)
        : m_order(order)
        , m_opened(opened)
        , m_surface(surface)
        , m_stop(stop)
        , m_bake(order.design, opened.design, order.picture.options.threads, std::move(stop))
        , m_studio({std::move(surface), opened.design, opened.files,
                    [this](ElementId id, const Fabric& fabric) { return m_bake(id, fabric); }, nullptr, legendOf})
    {}

    /// False when something could not be drawn or written; it has been said then.
    bool drawAll();
    bool drawAll(const std::vector<PictureSeries::Piece>& pieces);

private:
    bool draw(const PictureOrder& order, const QString& path, const std::string& viewName);
    bool write(const PreviewImage& image, const QString& path, const std::string& viewName) const;
    void printMap(const CoverMap& map);

    const RenderOrder& m_order;
    const OpenedDesign& m_opened;
    SurfaceMeshPtr m_surface;
    std::stop_token m_stop;
    FabricBaking m_bake;
    PictureStudio m_studio;
    bool m_mapPrinted = false;
};

/// The id of the colourway of this name; noElement for "" and for names that there are none of.
ElementId colourwayNamed(const Design& design, const std::string& name)
{
    ElementId found = noElement;
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
    if (!order.colourway.empty() && colourwayNamed(design, order.colourway) == noElement)
        return "the design has no colourway \"" + order.colourway + "\"; " +
               (names.empty() ? std::string("it has none") : "there are " + names);
    bool scan = false;
    design.each<Scan>([&](ElementId, const Scan&) { scan = true; });
    if (order.picture.look.map == CoverMap::Kind::Deviation && !scan)
        return "--map deviation needs a scan, and the design has none";
    if (!order.picture.look.sheet)
        return {};
    if (names.empty())
        return "the design has no colourways to put on a sheet";
    if (sheetPixels(design, order.picture.options) > mostPicturePixels)
        return "the sheet of all colourways would have more than " + std::to_string(mostPicturePixels / 1'000'000) +
               " million pixels; choose a smaller --size";
    return {};
}

bool Pictures::draw(const PictureOrder& order, const QString& path, const std::string& viewName)
{
    const Picture picture = m_studio.draw(order, m_stop);
    if (!picture.problem.empty())
        printError("warning: " + picture.problem);
    if (picture.map && !std::exchange(m_mapPrinted, true))
        printMap(*picture.map);
    return write(picture.image, path, viewName);
}

bool Pictures::drawAll()
{
    PictureOrder order = m_order.picture;
    order.look.colourway = m_order.colourway.empty() ? m_opened.design.settings().colourway
                                                     : colourwayNamed(m_opened.design, m_order.colourway);
    if (m_order.turntable == 0)
        return draw(order, m_order.image, m_order.viewName);
    for (int picture = 0; picture < m_order.turntable; ++picture) {
        order.turn = 2 * std::numbers::pi * picture / m_order.turntable;
        if (!draw(order, QString::fromStdString(numberedPath(m_order.image.toStdString(), picture + 1)),
                  m_order.viewName))
            return false;
    }
    return true;
}

bool Pictures::drawAll(const std::vector<PictureSeries::Piece>& pieces)
{
    return std::ranges::all_of(pieces, [this](const PictureSeries::Piece& piece) {
        if (PictureSeries::isThere(piece)) // meanwhile, by another run
            return true;
        PictureOrder order = m_order.picture;
        order.look.colourway = piece.colourway;
        order.from = piece.view->from;
        return draw(order, piece.path, piece.view->name);
    });
}

bool Pictures::write(const PreviewImage& image, const QString& path, const std::string& viewName) const
{
    if (image.empty()) {
        printError("error: \"" + path.toStdString() + "\" was not drawn: interrupted");
        return false;
    }
    const PictureNotes notes{QFileInfo(m_order.design).fileName().toStdString(),
                             hexText(hashOf(m_opened.design)).substr(0, 12), viewName};
    const EncodedPicture encoded = encodePicture(image, m_order.format, notes);
    const Message problem = encoded.problem.empty() ? replaceWholeFile(path, encoded.bytes) : encoded.problem;
    if (problem.empty())
        printResult("wrote " + path.toStdString());
    else
        printError("error: " + problem.english());
    return problem.empty();
}

/// What the colours mean, and where to look.
void Pictures::printMap(const CoverMap& map)
{
    const bool both = map.scale.kind == MapScale::Kind::Diverging;
    printResult("colours from " + figure(map, both ? -map.scale.limit : 0) + " to " + figure(map, map.scale.limit));
    for (const CoverSpot& spot : worstSpots(map, *m_surface, map.allowed.empty() ? 0 : 5, 60)) {
        std::string line = figure(map, spot.value) + " in ";
        for (const SurfaceTopology::PatchRange& range : m_surface->topology->patches)
            if (spot.vertex >= range.firstVertex && spot.vertex < range.firstVertex + range.vertexCount)
                line += elementLabel(range.patch, *m_opened.design.element(range.patch));
        const Vec2& at = m_surface->topology->pattern[spot.vertex];
        line += " at " + numberText(at.x(), 4) + ", " + numberText(at.y(), 4) + " mm";
        if (std::abs(spot.value) > map.allowedAt(spot.vertex))
            line += ": over the fabric's limit of " + figure(map, map.allowedAt(spot.vertex));
        printResult(line);
    }
}

/// Solves the cover, and lets `pictures` draw it.
template <class Draw>
int drawSolved(const RenderOrder& order, const OpenedDesign& opened, Interrupt& interrupt, Draw draw)
{
    SolveOptions options;
    options.threads = order.picture.options.threads;
    const SolveResult result = solveOpened(opened, options, interrupt.token());
    printFindings(result);
    if (!result.surface)
        return result.status == SolveResult::Status::Failed && !result.errors.empty() ? badInput : otherFailure;
    interrupt.beginWriting();
    Pictures pictures(order, opened, result.surface, interrupt.token());
    if (!draw(pictures))
        return otherFailure;
    return result.status == SolveResult::Status::NotConverged ? notConverged : done;
}

int renderSeries(const RenderOrder& order, const OpenedDesign& opened, Interrupt& interrupt)
{
    const PictureSeries series(order, opened.design, opened.files);
    const auto fail = [](const std::string& problem) {
        printError("error: " + problem);
        return otherFailure;
    };
    if (const std::string problem = order.series->slurm ? whyNoSlurm() : ""; !problem.empty())
        return fail(problem);
    if (const Message problem = series.open(); !problem.empty())
        return fail(problem.english());
    if (order.series->slurm) {
        const std::string problem = runOnSlurm(
            *order.series->slurm, [&] { return series.missing({}).empty(); },
            [](const std::string& line) { printResult(line); }, interrupt.token());
        return problem.empty() ? done : fail(problem);
    }
    const std::vector<PictureSeries::Piece> missing = series.missing(order.series->share);
    if (missing.empty()) {
        printResult("all pictures are there");
        return done;
    }
    return drawSolved(order, opened, interrupt, [&](Pictures& pictures) { return pictures.drawAll(missing); });
}

} // namespace

int render(std::span<const std::string> words)
{
    const RenderOrder order = RenderOrder::from(words);
    Interrupt interrupt;
    const OpenedDesign opened = openedShown(order.design);
    if (QFileInfo::exists(order.image) && QFileInfo(order.image) == QFileInfo(order.design))
        throw UsageError("--image would overwrite the design");
    if (const std::string problem = opened.readable ? orderProblem(order, opened.design) : ""; !problem.empty())
        throw UsageError(problem);
    if (const std::string why = order.series ? "" : whyNotWritten(order.image); !why.empty()) {
        printError("error: --image: \"" + order.image.toStdString() + "\" " +
                   why); // before it is drawn for a minute
        return otherFailure;
    }
    if (order.series)
        return printErrors(opened.problems) ? badInput : renderSeries(order, opened, interrupt);
    return drawSolved(order, opened, interrupt, [](Pictures& pictures) { return pictures.drawAll(); });
}

} // namespace bolster::cli
