#include "FabricLink.h"

#include "Background.h"
#include "DesignSession.h"
#include "FabricPreview.h"
#include "FabricShown.h"
#include "ImageImport.h"

#include <QGuiApplication>
#include <QtMath>

#include <numbers>
#include <utility>

namespace bolster {

namespace {

using Shape = FabricPreviewOptions::Shape;

constexpr double previewSide = 120;  ///< of the picture in the properties
constexpr double previewWidth = 110; ///< mm

QImage drawn(const Fabric& fabric, const FabricMaps& maps, Shape shape, int pixels)
{
    FabricPreviewOptions options;
    options.shape = shape;
    options.pixels = pixels;
    options.width = previewWidth;
    options.rotation = fabric.look.rotation * std::numbers::pi / 180;
    const ImagePixelsPtr picture = fabricPreview(maps, options);
    if (!picture->complete())
        return {};
    return QImage(picture->rgba.data(), picture->width, picture->height, 4 * picture->width,
                  QImage::Format_RGBA8888)
        .copy();
}

} // namespace

FabricLink::FabricLink(DesignSession& session, QObject* parent)
    : QObject(parent)
    , m_session(session)
{
    connect(&session.document(), &Document::changed, this, &FabricLink::designChanged);
    connect(&session, &DesignSession::filesChanged, this, &FabricLink::bakeNext); // a picture may have come
    connect(&session, &DesignSession::opened, this, [this] {
        m_stop.request_stop();
        m_stop = {};
        m_baked.clear();
        emit changed();
        bakeNext();
    });
}

FabricLink::~FabricLink()
{
    m_stop.request_stop();
}

void FabricLink::begin()
{
    if (!std::exchange(m_begun, true))
        bakeNext();
}

void FabricLink::designChanged(const std::set<ElementId>& ids)
{
    const Design& design = m_session.document().design();
    const bool gone =
        std::erase_if(m_baked, [&](const auto& entry) { return !design.find<Fabric>(entry.first); }) > 0;
    const bool touched = std::ranges::any_of(ids, [&](ElementId id) { return design.find<Fabric>(id) != nullptr; });
    if (gone || touched)
        emit changed();
    if (touched)
        bakeNext();
}

QString FabricLink::picturePath(const Fabric& fabric) const
{
    if (fabric.look.kind != FabricLook::Kind::Image)
        return {};
    return m_session.findFile(QString::fromStdString(fabric.look.file));
}

bool FabricLink::stale(ElementId id) const
{
    const Fabric* fabric = m_session.document().design().find<Fabric>(id);
    const auto baked = m_baked.find(id);
    return fabric && (baked == m_baked.end() || !looksAlike(baked->second.fabric, *fabric) ||
                      baked->second.fabric.look.rotation != fabric->look.rotation ||
                      baked->second.path != picturePath(*fabric));
}

std::optional<ElementId> FabricLink::nextStale() const
{
    const Design& design = m_session.document().design();
    std::optional<ElementId> next;
    design.each<Patch>([&](ElementId id, const Patch&) {
        if (const ElementId shown = fabricShown(design, id); !next && stale(shown))
            next = shown;
    });
    design.each<Fabric>([&](ElementId id, const Fabric&) {
        if (!next && stale(id))
            next = id;
    });
    return next;
}

void FabricLink::bakeNext()
{
    if (m_busy || !m_begun)
        return;
    const std::optional<ElementId> id = nextStale();
    if (!id)
        return;
    m_busy = true;
    const Fabric fabric = *m_session.document().design().find<Fabric>(*id);
    const QString path = picturePath(fabric);
    ImagePixelsPtr image; // read already, for another look of it
    for (const auto& [other, baked] : m_baked)
        if (!path.isEmpty() && baked.path == path)
            image = baked.image;
    const int pixels = qCeil(previewSide * qGuiApp->devicePixelRatio()); // of the finest screen
    inBackground<Baked>([fabric, path, image, pixels, cache = m_cache, stop = m_stop.get_token()] {
        return bake(fabric, path, image, *cache, stop, pixels);
    }).then(this, [this, id = *id, stop = m_stop.get_token()](const Baked& baked) {
        m_busy = false;
        if (!stop.stop_requested() && m_session.document().design().find<Fabric>(id)) {
            m_baked[id] = baked;
            emit changed();
        }
        bakeNext();
    });
}

FabricLink::Baked FabricLink::bake(const Fabric& fabric, const QString& path, ImagePixelsPtr image,
                                   FabricCache& cache, const std::stop_token& stop, int pixels)
{
    Baked baked{fabric, path, std::move(image), {}, nullptr, {}, {}};
    if (!path.isEmpty() && !baked.image) {
        ImageOutcome outcome = importImage(path, stop);
        baked.image = std::move(outcome.pixels);
        baked.problem = std::move(outcome.problem);
    }
    try {
        baked.maps = cache.get(fabric, baked.image);
        baked.color = QColor(QString::fromStdString(meanColor(*baked.maps)));
        if (pixels > 0)
            baked.pictures = {drawn(fabric, *baked.maps, Shape::Cushion, pixels),
                              drawn(fabric, *baked.maps, Shape::Ball, pixels)};
    } catch (const std::bad_alloc&) {
        baked.problem = {QT_TRANSLATE_NOOP("Message", "there is not enough memory to show this fabric"), {}};
    }
    return baked;
}

QImage FabricLink::previewOf(const Fabric& fabric, int pixels)
{
    return drawn(fabric, *bakeFabric(fabric, nullptr, {512, 1}), Shape::Cushion, pixels);
}

std::map<ElementId, FabricMapsPtr> FabricLink::maps() const
{
    std::map<ElementId, FabricMapsPtr> maps;
    for (const auto& [id, baked] : m_baked)
        maps[id] = baked.maps;
    return maps;
}

FabricBaker FabricLink::baker() const
{
    std::map<ElementId, QString> paths;
    m_session.document().design().each<Fabric>(
        [&](ElementId id, const Fabric& fabric) { paths[id] = picturePath(fabric); });
    return [paths = std::move(paths), baked = m_baked, cache = m_cache](ElementId id, const Fabric& fabric) {
        const auto found = baked.find(id);
        if (found != baked.end() && looksAlike(found->second.fabric, fabric))
            return found->second.maps;
        const auto path = paths.find(id);
        return bake(fabric, path == paths.end() ? QString() : path->second, nullptr, *cache, {}).maps;
    };
}

FabricBaker FabricLink::bakedByNow() const
{
    return [maps = maps()](ElementId id, const Fabric&) -> FabricMapsPtr {
        const auto found = maps.find(id);
        return found == maps.end() ? nullptr : found->second;
    };
}

std::map<ElementId, QColor> FabricLink::colors() const
{
    std::map<ElementId, QColor> colors;
    for (const auto& [id, baked] : m_baked)
        if (baked.maps && !stale(id))
            colors[id] = baked.color;
    return colors;
}

std::map<ElementId, FabricPictures> FabricLink::pictures() const
{
    std::map<ElementId, FabricPictures> pictures;
    for (const auto& [id, baked] : m_baked)
        pictures[id] = baked.pictures;
    return pictures;
}

bool FabricLink::upToDate() const
{
    return !m_busy && !nextStale();
}

Problems FabricLink::problems() const
{
    Problems problems;
    const Design& design = m_session.document().design();
    for (const auto& [id, baked] : m_baked)
        if (const ElementPtr element = design.element(id); element && !baked.problem.empty())
            problems.push_back({id, elementLabel(id, *element), "look.file", baked.problem, Severity::Warning});
    return problems;
}

} // namespace bolster
