#include "TestForms.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace bolster::test {

TriangleMesh gridMesh(int columns, int rows, const std::function<Vec3(double u, double v)>& place,
                      const std::string& name)
{
    TriangleMesh mesh;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            mesh.points.push_back(place(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (columns + 1) + i); };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    mesh.parts = {{name, 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
    return mesh;
}

TriangleMesh sideBySide(const TriangleMesh& a, const TriangleMesh& b)
{
    TriangleMesh both = a;
    const auto points = static_cast<std::uint32_t>(a.points.size());
    const auto triangles = static_cast<std::uint32_t>(a.triangles.size());
    both.points.insert(both.points.end(), b.points.begin(), b.points.end());
    for (const auto& [i, j, k] : b.triangles)
        both.triangles.push_back({points + i, points + j, points + k});
    for (const TriangleMesh::Part& part : b.parts)
        both.parts.push_back({part.name, triangles + part.firstTriangle, part.triangleCount});
    return both;
}

TriangleMesh halfPipe(double radius, double height, int columns, int rows)
{
    return gridMesh(columns, rows, [=](double u, double v) {
        const double angle = std::numbers::pi * (1 + u);
        return Vec3(radius * std::cos(angle), radius * std::sin(angle), height * v);
    });
}

TriangleMesh ringMesh(double lower, double upper, double height, int columns, int rows)
{
    return gridMesh(columns, rows, [=](double u, double v) {
        const double angle = u < 1 ? 2 * std::numbers::pi * u : 0; // ends where it begins, to the last bit
        const double radius = lower + v * (upper - lower);
        return Vec3(radius * std::cos(angle), radius * std::sin(angle), height * v);
    });
}

TriangleMesh trayMesh(const std::vector<std::string>& plan, double side, double height)
{
    const auto isThere = [&](int x, int y) {
        const int row = static_cast<int>(plan.size()) - 1 - y;
        return row >= 0 && row < std::ssize(plan) && x >= 0 && x < std::ssize(plan[row]) && plan[row][x] != ' ';
    };
    TriangleMesh mesh;
    const auto add = [&](const std::array<Vec3, 4>& square) {
        const auto first = static_cast<std::uint32_t>(mesh.points.size());
        for (const Vec3& corner : square)
            mesh.points.emplace_back(side * corner.x(), side * corner.y(), height * corner.z());
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
    };
    const auto eachSquare = [&](const auto& visit) {
        for (int y = 0; y < std::ssize(plan); ++y)
            for (int x = 0; x < std::ssize(plan[plan.size() - 1 - y]); ++x)
                if (isThere(x, y))
                    visit(x, y);
    };
    eachSquare([&](int x, int y) {
        add({Vec3(x, y, 1), Vec3(x + 1, y, 1), Vec3(x + 1, y + 1, 1), Vec3(x, y + 1, 1)});
    });
    const auto top = static_cast<std::uint32_t>(mesh.triangles.size());
    const auto wall = [&](const Vec3& from, const Vec3& to) {
        add({from, to, to + Vec3::UnitZ(), from + Vec3::UnitZ()});
    };
    eachSquare([&](int x, int y) {
        if (!isThere(x, y - 1))
            wall(Vec3(x, y, 0), Vec3(x + 1, y, 0));
        if (!isThere(x + 1, y))
            wall(Vec3(x + 1, y, 0), Vec3(x + 1, y + 1, 0));
        if (!isThere(x, y + 1))
            wall(Vec3(x + 1, y + 1, 0), Vec3(x, y + 1, 0));
        if (!isThere(x - 1, y))
            wall(Vec3(x, y + 1, 0), Vec3(x, y, 0));
    });
    mesh.parts = {{"Top", 0, top}, {"Side", top, static_cast<std::uint32_t>(mesh.triangles.size()) - top}};
    return mesh;
}

TriangleMesh hollowPrism(unsigned corners, double radius, double height)
{
    TriangleMesh prism;
    for (const double z : {0.0, height})
        for (unsigned k = 0; k < corners; ++k) {
            const double angle = k * 2 * std::numbers::pi / corners;
            prism.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
        }
    for (unsigned k = 0; k < corners; ++k) {
        const unsigned next = (k + 1) % corners;
        prism.triangles.push_back({k, next, corners + next});
        prism.triangles.push_back({k, corners + next, corners + k});
    }
    for (unsigned k = 1; k + 1 < corners; ++k)
        prism.triangles.push_back({corners, corners + k, corners + k + 1});
    prism.parts = {{"Prism", 0, static_cast<std::uint32_t>(prism.triangles.size())}};
    return prism;
}

PrismCrossing acrossPrism(unsigned corners, double radius, double height, double angle, double off)
{
    const Vec3 across(std::cos(angle), std::sin(angle), 0), along(-across.y(), across.x(), 0);
    double begin = -1e9, end = 1e9;
    PrismCrossing made;
    for (unsigned k = 0; k < corners; ++k) {
        const double middle = (2 * k + 1) * std::numbers::pi / corners;
        const Vec3 out(std::cos(middle), std::sin(middle), 0);
        const double slope = out.dot(along);
        if (std::abs(slope) < 1e-9)
            continue;
        const double at = (radius * std::cos(std::numbers::pi / corners) - off * out.dot(across)) / slope;
        if (slope > 0 && at < end) {
            end = at;
            made.last = k;
        } else if (slope < 0 && at > begin) {
            begin = at;
            made.first = k;
        }
    }
    const Vec3 top = off * across + height * Vec3::UnitZ();
    made.begin = top + begin * along;
    made.end = top + end * along;
    return made;
}

TriangleMesh quartered(const TriangleMesh& mesh)
{
    TriangleMesh fine = mesh;
    fine.triangles.clear();
    fine.parts.clear();
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto between = [&](std::uint32_t a, std::uint32_t b) {
        const auto [found, isNew] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(fine.points.size()));
        if (isNew)
            fine.points.emplace_back(0.5 * (mesh.points[a] + mesh.points[b]));
        return found->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::uint32_t ab = between(a, b), bc = between(b, c), ca = between(c, a);
        fine.triangles.insert(fine.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    for (const auto& part : mesh.parts)
        fine.parts.push_back({part.name, 4 * part.firstTriangle, 4 * part.triangleCount});
    return fine;
}

std::string problemOf(const Form& form)
{
    std::string problem = form.problem.english();
    for (const FormPiece& piece : form.pieces)
        problem += piece.refusal.english();
    return problem;
}

} // namespace bolster::test
