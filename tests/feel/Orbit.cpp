// How fast the 3D view's painter is while the camera goes round a cover, and what the picture looks like:
//   bolster_orbit DESIGN [options]
// Needs OpenGL, a software one will do: xvfb-run -a bolster_orbit ...
#include "CoverRefiner.h"
#include "DesignFile.h"
#include "FrameSkin.h"
#include "GlPainter.h"
#include "MeshShape.h"
#include "PreparedSheet.h"
#include "RestingSolve.h"
#include "TestFabric.h"

#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QPalette>

#include <algorithm>
#include <cstdio>

namespace {

using namespace bolster;

/// Pressed under the cover.
void addFrames(ViewScene& scene, const Design& design, const DesignFiles& files)
{
    QElapsedTimer clock;
    clock.start();
    const FrameSkins skins(scene.surface.get());
    std::size_t triangles = 0;
    design.each<Frame>([&](ElementId id, const Frame& frame) {
        const auto mesh = files.meshes.find(id);
        if (mesh == files.meshes.end())
            return;
        Scene::FrameLook look{mesh->second};
        look.placement = frame;
        look.skin = skins.skin(*mesh->second, frame);
        triangles += look.skin->corners.size() / 3;
        scene.frames.push_back(look);
    });
    scene.skinned = scene.surface;
    std::printf("frames: %zu triangles, pressed in %.0f ms\n", triangles,
                1e-6 * static_cast<double>(clock.nsecsElapsed()));
}

ViewScene sceneOf(const Design& design, const SurfaceMeshPtr& surface, const QCommandLineParser& options)
{
    ViewScene scene;
    scene.surface = surface;
    if (!options.isSet("coarse"))
        scene.cover = CoverRefiner().refine(surface, 2);
    for (const SurfaceTopology::PatchRange& range : surface->topology->patches) {
        const Fabric* fabric = design.find<Fabric>(range.fabric);
        Scene::PatchLook look{range.patch};
        if (fabric)
            look.color = fabric->color;
        if (options.isSet("fabric"))
            look.maps = test::wovenFabric();
        scene.patches.push_back(look);
    }
    QPalette palette;
    palette.setColor(QPalette::Base, options.isSet("dark") ? QColor(40, 42, 46) : QColor(240, 240, 240));
    palette.setColor(QPalette::Text, options.isSet("dark") ? Qt::white : Qt::black);
    scene.setColors(ViewColors::of(palette));
    scene.checker = options.isSet("checker");
    for (const SurfaceTopology::Chain& chain : surface->topology->seams) {
        SceneLine line;
        const auto run = scene.cover ? scene.cover->topology->along(chain.a) : chain.a;
        for (const std::uint32_t v : run)
            line.points.push_back(scene.cover ? scene.cover->points[v]
                                              : Eigen::Vector3f(surface->positions[v].cast<float>()));
        line.color = QColor(18, 14, 12, 190);
        line.width = 1.3F;
        scene.lines.push_back(std::move(line));
    }
    scene.marks = 1;
    scene.box = surface->boundingBox();
    scene.floor = scene.box.min().z() - 1;
    scene.occlusion = CoverOcclusion::of({surface, {}, static_cast<float>(scene.floor)}, {});
    return scene;
}

void orbit(GlPainter& painter, GlPainter::Request request, const QString& file)
{
    std::vector<double> times;
    request.moving = true;
    for (int frame = 0; frame < 72; ++frame) {
        request.camera.azimuth += 0.0873;
        ++request.version;
        QElapsedTimer clock;
        clock.start();
        const QImage image = painter.paint(request, {}).image;
        if (frame == 40 && !file.isEmpty())
            image.save(file);
        if (frame >= 8) // the painter finds its pace
            times.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed()));
    }
    double sum = 0;
    for (const double time : times)
        sum += time;
    std::ranges::sort(times);
    std::printf("orbit: %.1f pictures a second, p95 %.1f ms\n", 1000 * static_cast<double>(times.size()) / sum,
                times[times.size() * 95 / 100]);
}

void finest(GlPainter& painter, GlPainter::Request request, const QString& file)
{
    request.version += 1000;
    request.finest = std::make_shared<std::promise<QImage>>();
    QElapsedTimer clock;
    clock.start();
    const QImage image = painter.paint(request, {}).image;
    std::printf("finest picture: %.0f ms\n", 1e-6 * static_cast<double>(clock.nsecsElapsed()));
    if (!file.isEmpty() && !image.save(file))
        std::fprintf(stderr, "bolster_orbit: the picture cannot be written\n");
}

} // namespace

int main(int argc, char* argv[])
{
    QGuiApplication application(argc, argv);
    QCommandLineParser options;
    options.addHelpOption();
    options.addPositionalArgument("design", "a design file");
    options.addOptions({{"size", "of the picture, pixels", "WxH", "1280x800"},
                        {"edge", "of the solver's triangles, mm", "length"},
                        {"frames", "with the frames"},
                        {"coarse", "the cover as it is solved"},
                        {"fabric", "with the maps of a woven fabric"},
                        {"checker", "with the checker"},
                        {"dark", "dark theme"},
                        {"azimuth", "from where, degrees from three quarters", "degrees", "0"},
                        {"elevation", "degrees more", "degrees", "0"},
                        {"zoom", "times nearer", "factor", "1"},
                        {"image", "writes the finest picture", "file"},
                        {"moving-image", "writes one while the camera moves", "file"}});
    options.process(application);
    if (options.positionalArguments().size() != 1)
        options.showHelp(2);
    const OpenedDesign opened = openDesign(options.positionalArguments().front());
    SolveInput input{opened.design, opened.files};
    if (options.isSet("edge"))
        input = withEdgeLength(input, options.value("edge").toDouble());
    SolveOptions lenient;
    lenient.lenient = true;
    lenient.tolerance = 1e-5;
    const SolveResult solved = solveResting(input, lenient);
    if (!solved.surface) {
        std::fprintf(stderr, "bolster_orbit: no surface\n");
        return 1;
    }
    GlPainter::Request request;
    request.scene = sceneOf(opened.design, solved.surface, options);
    if (options.isSet("frames"))
        addFrames(request.scene, opened.design, opened.files);
    const QStringList size = options.value("size").split('x');
    request.size = {size.value(0).toInt(), size.value(1).toInt()};
    request.camera.size = {request.size.width(), request.size.height()};
    request.camera.look(Camera::StandardView::ThreeQuarter);
    constexpr double degree = 0.017453292519943295;
    request.camera.azimuth +=
        frontAzimuth(solved.surface->positions) + degree * options.value("azimuth").toDouble();
    request.camera.elevation += degree * options.value("elevation").toDouble();
    request.camera.fit(request.scene.box);
    request.camera.distance /= options.value("zoom").toDouble();
    QOffscreenSurface surface;
    surface.setFormat(glFormat());
    surface.create();
    GlPainter painter(surface);
    std::printf("%zu vertices, %zu shown\n", solved.surface->positions.size(),
                request.scene.cover ? request.scene.cover->points.size() : solved.surface->positions.size());
    finest(painter, request, options.value("image"));
    orbit(painter, request, options.value("moving-image"));
    return 0;
}
