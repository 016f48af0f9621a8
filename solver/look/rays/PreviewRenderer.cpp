#include "PreviewRenderer.h"

#include "CoverHits.h"
#include "FrameHits.h"
#include "Lens.h"
#include "MeshShape.h"
#include "PictureTile.h"
#include "PictureTones.h"
#include "RayScene.h"
#include "StudioLight.h"
#include "TrimHits.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <thread>

namespace bolster {

namespace {

constexpr float silhouette = 0.35f; ///< by how much what is see-through is denser where it turns away from the eye

/// Runs work(0) to work(count - 1) on some threads; stops early when asked to.
template <class Work>
void inParallel(int count, int threads, std::stop_token stop, const Work& work)
{
    if (threads <= 0)
        threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    std::atomic<int> next = 0;
    const auto run = [&] {
        for (int i = next++; i < count && !stop.stop_requested(); i = next++)
            work(i);
    };
    std::vector<std::jthread> helpers;
    for (int i = 1; i < std::min(threads, count); ++i)
        helpers.emplace_back(run);
    run();
}

/// Places that fill the unit square evenly however many are taken: the R2 sequence.
struct Place {
    float u, v;
};
Place evenPlace(int i)
{
    const double u = 0.5 + i * 0.7548776662466927, v = 0.5 + i * 0.5698402909980532;
    return {static_cast<float>(u - std::floor(u)), static_cast<float>(v - std::floor(v))};
}

} // namespace

RayCamera threeQuarterView(const Scene& scene, double aspect)
{
    std::vector<Vec3> points;
    if (scene.surface)
        points = scene.surface->positions;
    else if (!scene.frames.empty())
        points = placedPoints(scene.frames.front());
    return RayCamera::threeQuarter(scene.boundingBox(), aspect, frontAzimuth(points));
}

class PreviewRenderer::Prepared {
public:
    explicit Prepared(const Scene& scene);

    PreviewImage render(const RayCamera& view, const PreviewOptions& options, std::stop_token stop) const;

private:
    struct Job {
        const PreviewOptions& options;
        Lens lens;
        StudioLight light;
        int grid; ///< samples per pixel and direction
    };

    void drawTile(const Job& job, int x, int y, PreviewImage& image) const;
    void drawPixel(const Job& job, int x, int y, PicturePixel& pixel) const;
    void addGhost(const Job& job, const Lens::Ray& ray, float behind, Shade& shade, Vec3f& constant) const;
    void addSample(const Job& job, int x, int y, int sample, PicturePixel& pixel) const;
    void addGround(const Lens::Ray& ray, const Vec3f& behind, ShadedPoint& point, Shade& shade,
                   Vec3f& constant) const;
    ShadedPoint pointAt(const RayHit& hit, const Vec3f& direction, const Footprint& pixel) const;
    Vec3f background(const Job& job, float y) const;

    Box3 m_box;
    Vec3 m_origin;
    CoverHits m_cover;
    TrimHits m_trims;
    std::vector<FrameHits> m_frames; ///< solid ones
    std::vector<FrameHits> m_seeThrough;
    RayScene m_rays;   ///< the cover, its trims, and the solid frames after them
    RayScene m_ghosts; ///< those that are see-through
    bool m_ground;
    float m_floor = 0; ///< height of the ground, shifted
    float m_reach = 1; ///< half the diagonal of the box
    Vec3f m_top, m_bottom;
};

PreviewRenderer::Prepared::Prepared(const Scene& scene)
    : m_box(scene.boundingBox())
    , m_origin(m_box.isEmpty() ? Vec3(0, 0, 0) : Vec3(m_box.center()))
    , m_cover(scene, m_origin)
    , m_trims(scene.trims, scene.fabrics, m_origin)
    , m_ground(scene.ground && !m_box.isEmpty())
    , m_top(lightDisplayedAs(scene.backgroundTop))
    , m_bottom(lightDisplayedAs(scene.backgroundBottom))
{
    if (scene.section)
        for (RayScene* rays : {&m_rays, &m_ghosts})
            rays->cutOpen(scene.section->normal.cast<float>(),
                          static_cast<float>(scene.section->offset - scene.section->normal.dot(m_origin)));
    m_rays.add(m_cover.points(), m_cover.triangles());
    m_rays.add(m_trims.points(), m_trims.triangles());
    for (Scene::FrameLook frame : scene.frames) {
        frame.opacity *= scene.frameOpacity;
        const bool solid = m_cover.triangles().empty() || frame.opacity >= 1;
        std::vector<FrameHits>& frames = solid ? m_frames : m_seeThrough;
        frames.emplace_back(frame, m_origin);
        (solid ? m_rays : m_ghosts).add(frames.back().points(), frames.back().triangles());
    }
    m_rays.commit();
    m_ghosts.commit();
    if (!m_box.isEmpty()) {
        m_reach = std::max(1.f, static_cast<float>(m_box.diagonal().norm() / 2));
        m_floor = static_cast<float>(m_box.min().z() - m_origin.z()) - 1e-3f * m_reach;
    }
}

Vec3f PreviewRenderer::Prepared::background(const Job& job, float y) const
{
    const float t = std::clamp(y / static_cast<float>(job.options.height), 0.f, 1.f);
    return m_top + t * t * (3 - 2 * t) * (m_bottom - m_top);
}

ShadedPoint PreviewRenderer::Prepared::pointAt(const RayHit& hit, const Vec3f& direction,
                                               const Footprint& pixel) const
{
    if (hit.mesh == 0)
        return m_cover.at(hit, direction, pixel);
    if (hit.mesh == 1)
        return m_trims.at(hit, direction, pixel);
    return m_frames[hit.mesh - 2].at(hit, direction);
}

/// The floor has the colour of the background and no border: only shadows show that it is there.
void PreviewRenderer::Prepared::addGround(const Lens::Ray& ray, const Vec3f& behind, ShadedPoint& point,
                                          Shade& shade, Vec3f& constant) const
{
    constant = behind;
    if (!m_ground || ray.direction.z() > -1e-4f)
        return;
    const float distance = (m_floor - ray.origin.z()) / ray.direction.z();
    if (!(distance > 0))
        return;
    point.position = ray.origin + distance * ray.direction;
    point.shadowOrigin = point.position;
    const float away = std::max(0.f, point.position.head<2>().norm() / m_reach - 1.f);
    const float strength = 1.f / (1.f + 3.f * away * away) - 0.08f;
    if (strength <= 0)
        return;
    shade.direct = 0.34f * strength * behind;
    shade.ambient = 0.52f * strength * behind;
    constant = behind - shade.direct - shade.ambient;
}

/// A frame in front of what is there already, at the distance `behind`.
void PreviewRenderer::Prepared::addGhost(const Job& job, const Lens::Ray& ray, float behind, Shade& shade,
                                         Vec3f& constant) const
{
    const std::optional<RayHit> hit = m_ghosts.first(ray.origin, ray.direction);
    if (!hit || hit->distance > behind)
        return;
    const FrameHits& frame = m_seeThrough[hit->mesh];
    const ShadedPoint point = frame.at(*hit, ray.direction);
    const float facing = std::clamp(-point.normal.dot(ray.direction), 0.f, 1.f);
    const float opacity = std::min(1.f, frame.opacity() * (1 + silhouette * (1 - facing) * (1 - facing)));
    const Shade ghost = job.light.shade(point, -ray.direction);
    shade.direct *= 1 - opacity;
    shade.ambient *= 1 - opacity;
    constant = (1 - opacity) * constant + opacity * (ghost.direct + ghost.ambient);
}

void PreviewRenderer::Prepared::addSample(const Job& job, int x, int y, int sample, PicturePixel& pixel) const
{
    const float step = 1.f / static_cast<float>(job.grid);
    const float px = static_cast<float>(x) + step * (static_cast<float>(sample % job.grid) + 0.5f);
    const float py = static_cast<float>(y) + step * (static_cast<float>(sample / job.grid) + 0.5f);
    const Lens::Ray ray = job.lens.through(px, py);

    ShadedPoint point;
    Shade shade;
    Vec3f constant = Vec3f::Zero();
    const std::optional<RayHit> hit = m_rays.first(ray.origin, ray.direction);
    if (hit) {
        const Vec3f position = ray.origin + hit->distance * ray.direction;
        point = pointAt(*hit, ray.direction, job.lens.footprint(position, step));
        shade = job.light.shade(point, -ray.direction);
        pixel.depth = std::min(pixel.depth, job.lens.depth(position));
    } else {
        addGround(ray, job.options.transparent ? Vec3f::Ones() : background(job, py), point, shade, constant);
    }
    const bool ground = !hit && !shade.ambient.isZero();
    if (!hit && job.options.transparent) {
        pixel.through += Vec3f(constant.x(), shade.direct.x(), shade.ambient.x());
        shade = {};
        constant.setZero();
    }
    if (!m_seeThrough.empty() && !job.options.transparent)
        addGhost(job, ray, hit ? hit->distance : std::numeric_limits<float>::infinity(), shade, constant);
    pixel.constant += constant;
    pixel.direct += shade.direct;
    pixel.ambient += shade.ambient;
    if (job.options.quick || !(hit || ground))
        return;

    pixel.position += point.position;
    pixel.normal += point.smooth;
    const int samples = job.grid * job.grid;
    const Place place = evenPlace(orderInBlock(x, y) * samples + sample / 2);
    const Vec3f from = point.shadowOrigin + 2e-4f * m_reach * point.face;
    const bool both = samples == 1;
    if (both || sample % 2 == 0) {
        pixel.skyAsked += 1;
        pixel.skySeen += !m_rays.blocked(from, towardsSky(point.smooth, place.u, place.v), 0.8f * m_reach);
    }
    if (both || sample % 2 == 1) {
        pixel.keyAsked += 1;
        pixel.keySeen += !m_rays.blocked(from, job.light.towardsKey(place.u, place.v), 1e3f * m_reach);
    }
}

void PreviewRenderer::Prepared::drawPixel(const Job& job, int x, int y, PicturePixel& pixel) const
{
    const int samples = job.grid * job.grid;
    for (int sample = 0; sample < samples; ++sample)
        addSample(job, x, y, sample, pixel);
    const float share = 1.f / static_cast<float>(samples);
    pixel.constant *= share;
    pixel.through *= share;
    pixel.direct *= share;
    pixel.ambient *= share;
    const float hits = std::max(1.f, pixel.skyAsked + pixel.keyAsked) / (samples == 1 ? 2.f : 1.f);
    pixel.position /= std::max(1.f, hits);
    if (pixel.normal.squaredNorm() > 0)
        pixel.normal.normalize();
}

void PreviewRenderer::Prepared::drawTile(const Job& job, int x0, int y0, PreviewImage& image) const
{
    PictureTile tile(x0, y0, image.width, image.height);
    for (int y = tile.top(); y < tile.bottom(); ++y)
        for (int x = tile.left(); x < tile.right(); ++x)
            drawPixel(job, x, y, tile.at(x, y));
    for (int y = y0; y < std::min(image.height, y0 + PictureTile::size); ++y)
        for (int x = x0; x < std::min(image.width, x0 + PictureTile::size); ++x) {
            const PicturePixel& pixel = tile.at(x, y);
            const Eigen::Vector4f seen =
                job.options.quick ? tile.unshadowed(x, y) : tile.resolved(x, y, job.lens.pixelSize(pixel.position));
            const std::size_t at =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
            const PixelLight light{seen.head<3>(), job.options.transparent ? 1 - seen.w() : 1};
            std::ranges::copy(displayed(light, x, y), image.rgba.begin() + static_cast<std::ptrdiff_t>(4 * at));
            if (job.options.light)
                std::copy_n(std::array{light.color.x(), light.color.y(), light.color.z(), light.opacity}.begin(), 4,
                            image.light.begin() + static_cast<std::ptrdiff_t>(4 * at));
            if (job.options.depth)
                image.depth[at] = pixel.depth;
        }
}

PreviewImage PreviewRenderer::Prepared::render(const RayCamera& view, const PreviewOptions& options,
                                               std::stop_token stop) const
{
    PreviewImage image;
    if (options.width < 1 || options.height < 1 || options.width > largestPictureSide ||
        options.height > largestPictureSide)
        return image;
    const int grid = std::clamp(static_cast<int>(std::sqrt(options.samples + 0.5)), 1, 16);
    const Job job{options, Lens(view, options.width, options.height, m_origin), StudioLight(view), grid};
    image.width = options.width;
    image.height = options.height;
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    image.rgba.resize(4 * pixels);
    if (options.depth)
        image.depth.resize(pixels);
    if (options.light)
        image.light.resize(4 * pixels);

    const int columns = (image.width + PictureTile::size - 1) / PictureTile::size;
    const int rows = (image.height + PictureTile::size - 1) / PictureTile::size;
    std::mutex reporting;
    int drawn = 0;
    inParallel(columns * rows, options.threads, stop, [&](int tile) {
        drawTile(job, tile % columns * PictureTile::size, tile / columns * PictureTile::size, image);
        if (options.progress) {
            const std::lock_guard lock(reporting);
            options.progress(static_cast<double>(++drawn) / (columns * rows));
        }
    });
    return stop.stop_requested() ? PreviewImage{} : image;
}

PreviewRenderer::PreviewRenderer(const Scene& scene)
    : m_prepared(std::make_unique<Prepared>(scene))
{}

PreviewRenderer::~PreviewRenderer() = default;
PreviewRenderer::PreviewRenderer(PreviewRenderer&&) noexcept = default;
PreviewRenderer& PreviewRenderer::operator=(PreviewRenderer&&) noexcept = default;

PreviewImage PreviewRenderer::render(const RayCamera& view, const PreviewOptions& options,
                                     std::stop_token stop) const
{
    return m_prepared->render(view, options, stop);
}

PreviewImage renderPreview(const Scene& scene, const RayCamera& view, const PreviewOptions& options,
                           std::stop_token stop)
{
    if (stop.stop_requested())
        return {};
    return PreviewRenderer(scene).render(view, options, stop);
}

} // namespace bolster
