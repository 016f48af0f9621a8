#include "BodyCrossings.h"

#include "FormLines.h"
#include "Geometry.h"
#include "TriangleRays.h"
#include "UnionFind.h"

namespace bolster {

namespace {

constexpr float leastDeep = 1;    // mm
constexpr std::size_t most = 300; // bodies: a heap of triangles is no furniture

struct Body {
    std::vector<int> triangles; ///< of the form
    Box3 box;
    TriangleRays rays; ///< built when they are first asked
    bool isBuilt = false;
};

class Crossings {
public:
    explicit Crossings(const WeldedForm& form)
        : m_form(form)
    {
        UnionFind joined(static_cast<int>(form.points.size()));
        for (const WeldedForm::Corners& corners : form.triangles)
            for (const int corner : corners)
                joined.join(corners[0], corner);
        std::vector<int> bodyOf(form.points.size(), -1);
        for (std::size_t t = 0; t < form.triangles.size(); ++t) {
            int& body = bodyOf[static_cast<std::size_t>(joined.root(form.triangles[t][0]))];
            if (body < 0) {
                body = static_cast<int>(m_bodies.size());
                m_bodies.emplace_back();
            }
            Body& own = m_bodies[static_cast<std::size_t>(body)];
            own.triangles.push_back(static_cast<int>(t));
            for (const int corner : form.triangles[t])
                own.box.extend(form.points[static_cast<std::size_t>(corner)]);
        }
    }

    BodyCrossings find(const std::stop_token& stop)
    {
        BodyCrossings found;
        if (m_bodies.size() < 2 || m_bodies.size() > most)
            return found;
        for (std::size_t a = 0; a < m_bodies.size(); ++a)
            for (std::size_t b = a + 1; b < m_bodies.size() && !stop.stop_requested(); ++b) {
                if (!m_bodies[a].box.intersects(m_bodies[b].box))
                    continue;
                std::optional<Vec3> at = crossing(m_bodies[a], m_bodies[b]);
                if (!at)
                    at = crossing(m_bodies[b], m_bodies[a]);
                if (!at)
                    continue;
                if (found.pairs++ == 0)
                    found.at = *at;
            }
        return found;
    }

private:
    const Vec3& point(int triangle, std::size_t corner) const
    {
        return m_form
            .points[static_cast<std::size_t>(m_form.triangles[static_cast<std::size_t>(triangle)][corner])];
    }

    void build(Body& body) const
    {
        std::vector<TriangleRays::Vec3f> points;
        std::vector<TriangleRays::Triangle> triangles;
        for (const int t : body.triangles) {
            const auto first = static_cast<std::uint32_t>(points.size());
            for (std::size_t k = 0; k < 3; ++k)
                points.push_back(point(t, k).cast<float>());
            triangles.push_back({first, first + 1, first + 2});
        }
        body.rays.build(std::move(points), std::move(triangles));
        body.isBuilt = true;
    }

    /// Whether some place of an edge on that side of where it meets the other body is some way off it: where both
    /// only touch an edge runs along it.
    static bool goesOff(const TriangleRays& body, const TriangleRays::Vec3f& met, const TriangleRays::Vec3f& end)
    {
        constexpr int places = 8;
        for (int k = 1; k <= places; ++k)
            if (!body.nearest(met + static_cast<float>(k) / places * (end - met), leastDeep))
                return true;
        return false;
    }

    /// Where an edge of one goes through a triangle of the other.
    std::optional<Vec3> crossing(const Body& edges, Body& faces) const
    {
        if (!faces.isBuilt)
            build(faces);
        for (const int t : edges.triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 &from = point(t, k), &to = point(t, (k + 1) % 3);
                if (!Box3(from.cwiseMin(to), from.cwiseMax(to)).intersects(faces.box))
                    continue;
                const TriangleRays::Vec3f way = (to - from).cast<float>();
                const auto hit = faces.rays.first(from.cast<float>(), way);
                if (!hit || hit->distance >= 1)
                    continue;
                const TriangleRays::Vec3f met = from.cast<float>() + hit->distance * way;
                if (goesOff(faces.rays, met, from.cast<float>()) && goesOff(faces.rays, met, to.cast<float>()))
                    return met.cast<double>();
            }
        return std::nullopt;
    }

    const WeldedForm& m_form;
    std::vector<Body> m_bodies;
};

} // namespace

Message BodyCrossings::note() const
{
    if (pairs == 0)
        return {};
    return {QT_TRANSLATE_NOOP("Message",
                              "Bodies of the form go through each other, as at %1: what of one lies "
                              "inside of another one is covered, too, and pushed out. Unite them before, "
                              "or leave one out. Number of such pairs: %2"),
            {placeText(at), std::to_string(pairs)}};
}

BodyCrossings bodyCrossings(const WeldedForm& form, const std::stop_token& stop)
{
    return Crossings(form).find(stop);
}

} // namespace bolster
