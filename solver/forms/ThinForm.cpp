#include "ThinForm.h"

#include "Form.h"
#include "FormTree.h"
#include "WeldedForm.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Constrained_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace bolster {

namespace {

namespace Sms = CGAL::Surface_mesh_simplification;
using Coarse = CGAL::Simple_cartesian<double>; // fast: nothing here asks on which side something lies
using Mesh = CGAL::Surface_mesh<Coarse::Point_3>;
using ThinEdge = Mesh::Edge_index;
using ThinFace = Mesh::Face_index;
using HeldMap = Mesh::Property_map<ThinEdge, bool>;

constexpr double sharp = 30;          // degrees: what bends by more is seen
constexpr double nearlyThere = 1.2;   // times as many triangles as are wanted
constexpr std::size_t asked = 20'000; // points whose distance is measured

struct Stopped {};

/// As long as an edge is. CGAL asks all the time: it leaves there when it shall stop.
struct LengthUnlessStopped {
    const std::stop_token* stop;

    template <class Profile, class Place>
    auto operator()(const Profile& edge, const Place& place) const
    {
        if (stop->stop_requested())
            throw Stopped();
        return Sms::Edge_length_cost<Mesh>()(edge, place);
    }
};

struct FewEnough {
    std::size_t edges;

    template <class Cost, class Profile>
    bool operator()(const Cost&, const Profile&, std::size_t, std::size_t left) const
    {
        return left < edges;
    }
};

Vec3 fromPoint(const Coarse::Point_3& p)
{
    return {p.x(), p.y(), p.z()};
}

class Thinning {
public:
    /// Throws when stopped.
    Thinning(const WeldedForm& form, const std::set<std::pair<int, int>>& rows, const std::stop_token& stop)
        : m_stop(stop)
    {
        m_part = m_mesh.add_property_map<ThinFace, int>("f:part", 0).first;
        m_held = m_mesh.add_property_map<ThinEdge, bool>("e:held", false).first;
        for (const Vec3& p : form.points)
            m_mesh.add_vertex({p.x(), p.y(), p.z()});
        const auto vertex = [](int k) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(k)); };
        for (std::size_t t = 0; t < form.triangles.size(); ++t) {
            if (stop.stop_requested())
                throw Stopped();
            const auto& [a, b, c] = form.triangles[t];
            const ThinFace face = m_mesh.add_face(vertex(a), vertex(b), vertex(c));
            if (face != Mesh::null_face()) // else an edge has three faces there yet
                m_part[face] = form.part[t];
        }
        for (const ThinEdge e : m_mesh.edges()) {
            const int a = static_cast<int>(m_mesh.vertex(e, 0).idx()),
                      b = static_cast<int>(m_mesh.vertex(e, 1).idx());
            m_held[e] = isOutline(e) || rows.contains({std::min(a, b), std::max(a, b)});
        }
    }

    std::size_t count() const { return m_mesh.number_of_faces(); }

    /// Throws when stopped.
    void thin(std::size_t triangles, bool keepBends)
    {
        std::vector<ThinEdge> bends;
        if (keepBends)
            for (const ThinEdge e : m_mesh.edges())
                if (!m_held[e] && bendAt(e) > sharp)
                    bends.push_back(e);
        for (const ThinEdge e : bends)
            m_held[e] = true;
        const Sms::Constrained_placement<Sms::Midpoint_placement<Mesh>, HeldMap> place(m_held);
        Sms::edge_collapse(m_mesh, FewEnough{triangles + triangles / 2},
                           CGAL::parameters::edge_is_constrained_map(m_held)
                               .get_cost(LengthUnlessStopped{&m_stop})
                               .get_placement(place)
                               .filter(Sms::Bounded_normal_change_filter<>()));
        for (const ThinEdge e : bends)
            if (!m_mesh.is_removed(e))
                m_held[e] = false;
    }

    /// Throws when stopped.
    TriangleMesh result(const std::vector<std::string>& names)
    {
        m_mesh.collect_garbage();
        TriangleMesh mesh;
        for (const auto v : m_mesh.vertices())
            mesh.points.push_back(fromPoint(m_mesh.point(v)));
        for (std::size_t part = 0; part < names.size(); ++part) {
            const auto first = static_cast<std::uint32_t>(mesh.triangles.size());
            for (const ThinFace f : m_mesh.faces()) {
                if (m_stop.stop_requested())
                    throw Stopped();
                if (m_part[f] != static_cast<int>(part))
                    continue;
                auto& corners = mesh.triangles.emplace_back();
                std::size_t k = 0;
                for (const auto v : m_mesh.vertices_around_face(m_mesh.halfedge(f)))
                    corners[k++] = static_cast<std::uint32_t>(v.idx());
            }
            if (mesh.triangles.size() > first)
                mesh.parts.push_back(
                    {names[part], first, static_cast<std::uint32_t>(mesh.triangles.size()) - first});
        }
        return mesh;
    }

    /// The farthest of some of these points from the triangles that are left, mm. Throws when stopped.
    double off(const std::vector<Vec3>& points) const
    {
        std::vector<FormTree::Triangle> triangles;
        for (const ThinFace f : m_mesh.faces()) {
            if (m_stop.stop_requested())
                throw Stopped();
            std::size_t k = 0;
            auto& corners = triangles.emplace_back();
            for (const auto v : m_mesh.vertices_around_face(m_mesh.halfedge(f)))
                corners[k++] = fromPoint(m_mesh.point(v));
        }
        const FormTree tree(std::move(triangles), m_stop);
        double most = 0;
        for (std::size_t k = 0; k < points.size(); k += std::max<std::size_t>(1, points.size() / asked)) {
            if (m_stop.stop_requested())
                throw Stopped();
            most = std::max(most, (tree.nearestTo(points[k]).at - points[k]).norm());
        }
        return most;
    }

private:
    bool isOutline(ThinEdge e) const
    {
        return m_mesh.is_border(e) ||
               m_part[m_mesh.face(m_mesh.halfedge(e, 0))] != m_part[m_mesh.face(m_mesh.halfedge(e, 1))];
    }

    Vec3 normalOf(Mesh::Halfedge_index h) const
    {
        const Vec3 a = fromPoint(m_mesh.point(m_mesh.source(h))), b = fromPoint(m_mesh.point(m_mesh.target(h)));
        const Vec3 c = fromPoint(m_mesh.point(m_mesh.target(m_mesh.next(h))));
        return (b - a).cross(c - a).normalized();
    }

    /// Degrees.
    double bendAt(ThinEdge e) const
    {
        const double cosine = normalOf(m_mesh.halfedge(e, 0)).dot(normalOf(m_mesh.halfedge(e, 1)));
        return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
    }

    Mesh m_mesh;
    Mesh::Property_map<ThinFace, int> m_part;
    HeldMap m_held;
    const std::stop_token& m_stop;
};

} // namespace

/// Throws when stopped.
static ThinnedForm thin(const TriangleMesh& mesh, const std::vector<std::vector<Vec3>>& rows, std::size_t triangles,
                        const std::stop_token& stop)
{
    ThinnedForm result;
    WeldedForm form = weld(mesh, stop);
    if (stop.stop_requested())
        throw Stopped();
    turnAlike(form, result.notes, stop);
    partSheets(form, stop);
    if (stop.stop_requested())
        throw Stopped();
    Thinning thinning(
        form, rows.empty() ? std::set<std::pair<int, int>>() : edgesAlong(form, rows, FormCuts().onEdges), stop);
    thinning.thin(triangles, true);
    if (static_cast<double>(thinning.count()) > nearlyThere * static_cast<double>(triangles))
        thinning.thin(triangles, false); // rough all over, as scans are
    result.mesh = thinning.result(form.names);
    result.notes.insert(result.notes.begin(),
                        {QT_TRANSLATE_NOOP("Message", "The form has %1 triangles; %2 stand for it, which are up to "
                                                      "%3 mm off"),
                         {std::to_string(mesh.triangles.size()), std::to_string(result.mesh.triangles.size()),
                          numberText(thinning.off(form.points), 2)}});
    return result;
}

std::optional<ThinnedForm> thinForm(const TriangleMesh& mesh, const std::vector<std::vector<Vec3>>& rows,
                                    std::size_t triangles, const std::stop_token& stop)
{
    try {
        return thin(mesh, rows, triangles, stop);
    } catch (const Stopped&) {
        return std::nullopt;
    }
}

} // namespace bolster
