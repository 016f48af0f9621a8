#include "RenderOrder.h"

#include "SavedViews.h"

#include <array>
#include <charconv>

namespace bolster::cli {

namespace {

constexpr std::array renderOptions = {
    OptionRule{"--image", true},     OptionRule{"--size", true},      OptionRule{"--view", true},
    OptionRule{"--samples", true},   OptionRule{"--fabric", true},    OptionRule{"--map", true},
    OptionRule{"--turntable", true}, OptionRule{"--threads", true},   OptionRule{"--transparent", false},
    OptionRule{"--sheet", false},    OptionRule{"--no-frame", false}, OptionRule{"--all", true},
    OptionRule{"--views", true},     OptionRule{"--format", true},    OptionRule{"--part", true},
    OptionRule{"--slurm", false},    OptionRule{"--jobs", true},      OptionRule{"--sbatch", true},
};

/// "1280x960"
std::array<int, 2> parsedSize(const std::string& text)
{
    std::array<int, 2> size{};
    const char* const end = text.data() + text.size();
    const auto [middle, error] = std::from_chars(text.data(), end, size[0]);
    const bool cross = error == std::errc() && middle < end && *middle == 'x';
    if (cross) {
        const auto [stop, wrong] = std::from_chars(middle + 1, end, size[1]);
        if (wrong == std::errc() && stop == end && size[0] > 0 && size[1] > 0)
            return size;
    }
    throw UsageError("--size needs width and height in pixels, like 1280x960, not \"" + text + "\"");
}

void checkSize(const PreviewOptions& options)
{
    constexpr int longest = largestPictureSide;
    const std::int64_t pixels = static_cast<std::int64_t>(options.width) * options.height;
    const std::string size = std::to_string(options.width) + "x" + std::to_string(options.height);
    if (options.width > longest || options.height > longest)
        throw UsageError("--size " + size + " is too large: at most " + std::to_string(longest) + " pixels a side");
    if (pixels > mostPicturePixels)
        throw UsageError("--size " + size + " is too large: " + std::to_string(pixels / 1'000'000) +
                         " million pixels, and at most " + std::to_string(mostPicturePixels / 1'000'000) +
                         " are drawn");
}

/// A word, two angles (of a single one), or the name of a view that was saved in the window.
std::variant<PictureDirection, RayCamera> parsedView(const std::string& name, bool single = true)
{
    if (const auto direction = pictureDirection(name))
        return *direction;
    if (const auto saved = SavedViews::find(QString::fromStdString(name)))
        return RayCamera(*saved);
    const QStringList names = SavedViews::names();
    throw UsageError("unknown view \"" + QString::fromStdString(name).left(60).toStdString() + "\"; there are " +
                     pictureDirections +
                     (names.isEmpty() ? std::string() : ", " + names.join(QStringLiteral(", ")).toStdString()) +
                     (single ? ", or azimuth and elevation in degrees, like 30,20"
                             : "; angles are for a single picture, --view"));
}

void takeMap(const Arguments& arguments, RenderOrder& order)
{
    const std::string map = arguments.path("--map").toStdString();
    PictureLook& look = order.picture.look;
    look.checker = map == "checker";
    look.map = coverMapKind(map);
    if (!map.empty() && !look.checker && !look.map)
        throw UsageError("unknown map \"" + map +
                         "\"; there are strain, along, across, shear, curvature, thickness, deviation and checker");
    if (look.map && !order.colourway.empty())
        throw UsageError("--map " + map + " and --fabric exclude each other: a map covers the fabric");
}

/// What pictures of a series have of their own excludes it.
SeriesOrder parsedSeries(const Arguments& arguments, const QString& design)
{
    for (const char* single : {"--image", "--view", "--fabric", "--turntable", "--sheet"})
        if (arguments.has(single))
            throw UsageError("--all draws every colourway from every view: it does not go with " +
                             std::string(single));
    SeriesOrder series;
    series.folder = arguments.path("--all");
    series.format = arguments.has("--format") ? arguments.path("--format").toStdString() : "png";
    if (!pictureFormat("." + series.format))
        throw UsageError("--format is png, tif or exr, not \"" + series.format + "\"");
    const QString views =
        arguments.has("--views") ? arguments.path("--views") : "three-quarter,front,back,left,right,top";
    for (const QString& name : views.split(',', Qt::SkipEmptyParts))
        series.views.push_back({name.trimmed().toStdString(), parsedView(name.trimmed().toStdString(), false)});
    if (series.views.empty())
        throw UsageError("--views needs at least one view");
    series.share = jobShare(arguments);
    SlurmOrder jobs = SlurmOrder::from(arguments, "render", series.folder);
    jobs.command += design;
    for (const char* option : {"--all", "--views", "--format", "--size", "--samples", "--map", "--threads"})
        if (arguments.has(option)) {
            jobs.command += {option, arguments.path(option)};
            if (std::string_view(option) != "--threads" && std::string_view(option) != "--all")
                series.options += option + (" " + arguments.path(option).toStdString()) + "\n";
        }
    for (const char* option : {"--transparent", "--no-frame"})
        if (arguments.has(option)) {
            jobs.command += option;
            series.options.append(option).append("\n");
        }
    if (arguments.has("--slurm"))
        series.slurm = std::move(jobs);
    return series;
}

void expectNoSeries(const Arguments& arguments)
{
    for (const char* option : {"--views", "--format", "--part", "--slurm", "--jobs", "--sbatch"})
        if (arguments.has(option))
            throw UsageError(std::string(option) + " is for a series of pictures: --all DIR");
}

} // namespace

RenderOrder RenderOrder::from(std::span<const std::string> words)
{
    const Arguments arguments(words, renderOptions);
    RenderOrder order;
    PreviewOptions& options = order.picture.options;
    order.design = arguments.onlyFile("DESIGN");
    if (arguments.has("--all"))
        order.series = parsedSeries(arguments, order.design);
    else
        expectNoSeries(arguments);
    order.image = order.series ? "." + QString::fromStdString(order.series->format) : arguments.path("--image");
    if (order.image.isEmpty())
        throw UsageError("--image is missing: where the picture is to be written");
    const auto format = pictureFormat(order.image.toStdString());
    if (!format)
        throw UsageError("--image must end in .png, .tif or .exr, and \"" + order.image.toStdString() +
                         "\" does not");
    order.format = *format;
    options.light = needsLight(order.format);
    options.samples = arguments.integer("--samples", 16, 1, 256);
    options.threads = arguments.integer("--threads", 0, 0, 1024);
    options.transparent = arguments.has("--transparent");
    if (arguments.has("--size")) {
        const auto [width, height] = parsedSize(arguments.path("--size").toStdString());
        options.width = width;
        options.height = height;
    }
    checkSize(options);
    order.viewName = arguments.has("--view") ? arguments.path("--view").toStdString() : "three-quarter";
    order.picture.from = parsedView(order.viewName);
    order.colourway = arguments.path("--fabric").toStdString();
    takeMap(arguments, order);
    const PictureLook& look = order.picture.look;
    order.picture.look.sheet = arguments.has("--sheet");
    order.picture.look.frames = !arguments.has("--no-frame");
    order.turntable = arguments.integer("--turntable", 0, 1, 999);
    if (look.sheet && (order.turntable > 0 || look.map || look.checker || !order.colourway.empty()))
        throw UsageError(
            "--sheet shows all colourways in one picture: it goes neither with --fabric, nor with --map, "
            "nor with --turntable");
    return order;
}

} // namespace bolster::cli
