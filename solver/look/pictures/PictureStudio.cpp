#include "PictureStudio.h"

#include "ContactSheet.h"

#include <utility>

namespace bolster {

namespace {

std::size_t colourwayCount(const Design& design)
{
    std::size_t count = 0;
    design.each<Colourway>([&](ElementId, const Colourway&) { ++count; });
    return count;
}

} // namespace

struct PictureStudio::Stage {
    PictureLook look;
    std::optional<CoverMap> map;
    Scene scene;
    PreviewRenderer renderer{scene};
};

std::int64_t sheetPixels(const Design& design, const PreviewOptions& options)
{
    const std::size_t count = colourwayCount(design);
    if (count == 0)
        return 0;
    const auto [columns, rows] = sheetGrid(count);
    const std::int64_t height = options.height + sheetCaption(options.width, options.height);
    return std::int64_t{columns} * options.width * rows * height;
}

PictureStudio::PictureStudio(Subject subject)
    : m_subject(std::move(subject))
{}

PictureStudio::~PictureStudio() = default;

PictureStudio::Stage PictureStudio::staged(const PictureLook& look)
{
    std::optional<CoverMap> map;
    if (look.map)
        map = coverMap(*look.map, *m_subject.surface, m_subject.design, m_subject.files);
    Scene scene = sceneOf(look, map ? &*map : nullptr);
    if (look.frames) {
        if (!m_frames)
            m_frames = framesForPicture(m_subject.design, m_subject.files, m_subject.surface.get());
        scene.frames = *m_frames;
    }
    return {look, std::move(map), std::move(scene)};
}

Scene PictureStudio::sceneOf(const PictureLook& look, const CoverMap* map)
{
    const auto& [surface, design, files, bake, atOnce, legend] = m_subject;
    if (look.refined && !m_cover)
        m_cover = refinedForPicture(surface);
    if (map)
        return sceneWithMap(surface, look.refined ? m_cover : nullptr, *map);
    if (look.refined && !m_sewn)
        m_sewn = withSeams(m_cover, design);
    const CoverMeshPtr cover = look.refined ? m_sewn : nullptr;
    if (look.checker)
        return sceneWithChecker(surface, cover, design, look.colourway);
    return sceneInFabrics(surface, cover, design, look.colourway, look.refined ? bake : atOnce);
}

const PictureStudio::Stage& PictureStudio::stage(const PictureLook& look)
{
    if (!m_stage || m_stage->look != look) {
        m_stage.reset(); // before the next one is made: scenes are large
        m_stage = std::make_unique<Stage>(staged(look));
    }
    return *m_stage;
}

PreviewImage PictureStudio::drawOne(const Stage& stage, const PictureOrder& order, const std::stop_token& stop)
{
    RayCamera view;
    if (const auto* direction = std::get_if<PictureDirection>(&order.from)) {
        const double aspect = static_cast<double>(order.options.width) / order.options.height;
        view = pictureView(stage.scene, {direction->azimuth + order.turn, direction->elevation}, aspect);
    } else {
        view = std::get<RayCamera>(order.from);
        view.azimuth += order.turn;
    }
    return stage.renderer.render(view, order.options, stop);
}

Picture PictureStudio::draw(const PictureOrder& order, const std::stop_token& stop)
{
    if (order.look.sheet)
        return drawSheet(order, stop);
    const Stage& now = stage(order.look);
    Picture picture{drawOne(now, order, stop), now.map, {}};
    if (now.map && m_subject.legend)
        drawLegend(picture.image, m_subject.legend(*now.map), picture.problem);
    return picture;
}

Picture PictureStudio::drawSheet(const PictureOrder& order, const std::stop_token& stop)
{
    PictureOrder one = order;
    one.look.sheet = false;
    std::vector<SheetPicture> pictures;
    const double count = static_cast<double>(colourwayCount(m_subject.design));
    m_subject.design.each<Colourway>([&](ElementId id, const Colourway& colourway) {
        one.look.colourway = id;
        if (order.options.progress)
            one.options.progress = [&, before = static_cast<double>(pictures.size())](double share) {
                order.options.progress((before + share) / count);
            };
        if (!stop.stop_requested())
            pictures.push_back({drawOne(stage(one.look), one, stop), colourway.name});
    });
    if (stop.stop_requested())
        return {};
    Picture sheet;
    sheet.image = contactSheet(pictures, order.options.transparent, sheet.problem);
    return sheet;
}

} // namespace bolster
