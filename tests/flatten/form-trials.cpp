// Prisms that are cut along lines at random: over the top, down both walls, close beside an edge, around a corner.
// All their pieces are plane or bent in one direction, so none may be left out and every cover comes to rest on its
// form. Prints each that is otherwise.
#include "Flatten.h"
#include "FormPattern.h"
#include "RestingSolve.h"
#include "TestForms.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numbers>
#include <random>
#include <string>

namespace bolster::test {

namespace {

constexpr std::array kinds{"over the top", "down both walls", "beside an edge", "around a corner"};

class Random {
public:
    explicit Random(unsigned seed)
        : m_engine(seed)
    {}

    double between(double least, double most)
    {
        return least + (most - least) * static_cast<double>(m_engine()) / static_cast<double>(std::mt19937::max());
    }
    unsigned below(unsigned count) { return static_cast<unsigned>(m_engine() % count); }

private:
    std::mt19937 m_engine;
};

struct Prism {
    unsigned corners = 4;
    double radius = 150, height = 60; ///< mm
    unsigned quarterings = 0;

    TriangleMesh mesh() const
    {
        TriangleMesh made = hollowPrism(corners, radius, height);
        for (unsigned k = 0; k < quarterings; ++k)
            made = quartered(made);
        return made;
    }
    Vec3 corner(unsigned k) const
    {
        const double angle = 2 * std::numbers::pi * k / corners;
        return {radius * std::cos(angle), radius * std::sin(angle), height};
    }
    Vec3 outOf(unsigned wall) const
    {
        const double angle = (2 * wall + 1) * std::numbers::pi / corners;
        return {std::cos(angle), std::sin(angle), 0};
    }
    double inner() const { return radius * std::cos(std::numbers::pi / corners); }
};

struct Trial {
    Prism prism;
    FormLine line;
    double edge = 12; ///< of the mesh, mm
    std::string text;
};

Trial trial(unsigned number)
{
    Random random(number + 1);
    Trial made;
    const unsigned kind = number % kinds.size();
    Prism& prism = made.prism;
    prism.corners = 4 + random.below(5);
    prism.radius = random.below(2) ? 150 : 300;
    prism.height = random.below(2) ? 60 : 150;
    prism.quarterings = 2 * random.below(3);
    made.edge = random.below(2) ? 10 : 16;
    made.line.name = "Line";
    const double hovering = random.between(0, 3);
    std::vector<Vec3>& points = made.line.points;
    if (kind == 0 || kind == 1) {
        const double turn = random.between(0, 2 * std::numbers::pi),
                     off = random.between(-0.7, 0.7) * prism.inner();
        const PrismCrossing over = acrossPrism(prism.corners, prism.radius, prism.height, turn, off);
        const Vec3 along = (over.end - over.begin).normalized();
        const double past = kind == 0 ? random.between(0, 8) : hovering;
        const Vec3 up = (kind == 0 ? 0 : hovering) * Vec3::UnitZ();
        points = {over.begin - past * along + up, over.end + past * along + up};
        if (kind == 1) { // straight down, as far as it hovers outside of the walls
            const Vec3 down = random.between(0.3, 1) * prism.height * Vec3::UnitZ();
            points.front() = over.begin + hovering * prism.outOf(over.first) + up;
            points.back() = over.end + hovering * prism.outOf(over.last) + up;
            points.insert(points.begin(), points.front() - down - up);
            points.push_back(points.back() - down - up);
        }
    } else if (kind == 2) {
        const unsigned wall = random.below(prism.corners);
        const Vec3 from = prism.corner(wall), to = prism.corner((wall + 1) % prism.corners);
        const Vec3 along = (to - from).normalized(), in = -prism.outOf(wall);
        const double past = random.between(0, 8);
        const double first = random.between(0.5, 12), last = random.between(0.5, 12);
        points = {from + first * in - past * along, to + last * in + past * along};
    } else {
        const Vec3 middle = prism.corner(random.below(prism.corners));
        const double around = random.between(8, 60), start = random.between(0, 2 * std::numbers::pi);
        for (int k = 0; k < 24; ++k) {
            const double angle = start + k * 2 * std::numbers::pi / 24;
            Vec3 at = middle + around * Vec3(std::cos(angle), std::sin(angle), 0);
            for (unsigned wall = 0; wall < prism.corners; ++wall) // down the walls, where it goes over an edge
                if (const double beyond = at.dot(prism.outOf(wall)) - prism.inner(); beyond > 0)
                    at -= beyond * (prism.outOf(wall) + Vec3::UnitZ());
            points.push_back(at);
        }
        made.line.closed = true;
    }
    std::array<char, 120> text{};
    std::snprintf(text.data(), text.size(), "%s, %u corners, %.0f x %.0f mm, %zu triangles, edges %.0f mm",
                  kinds[kind], prism.corners, prism.radius, prism.height, prism.mesh().triangles.size(), made.edge);
    made.text = text.data();
    return made;
}

/// What is wrong with it; "" when all is well.
std::string outcome(const Trial& trial, bool solve)
{
    const Form form = cutForm(trial.prism.mesh(), {false, 30, {trial.line}});
    if (const std::string problem = problemOf(form); !problem.empty())
        return "refused: " + problem;
    FormPatternOrder order;
    order.edgeLength = trial.edge;
    const FormPattern made = formPattern(form, flatten(form, {}), order);
    if (std::ranges::count(made.patches, noElement) > 0) {
        std::string notes = std::to_string(made.patches.size()) + " pieces";
        for (const Message& note : made.notes)
            notes.append("; ").append(note.english());
        return notes;
    }
    if (!solve)
        return {};
    const SolveResult solved = solveResting(made.design, {});
    if (solved.status != SolveResult::Status::Solved)
        return "no rest: " + solved.reason.english();
    const auto [low, high] =
        std::ranges::minmax(solved.surface->positions, {}, [](const Vec3& at) { return at.z(); });
    constexpr double rounding = 15; // mm: bending rounds edges, and bows what lies between them
    if (low.z() < -rounding || high.z() > trial.prism.height + rounding || high.z() < trial.prism.height - rounding)
        return "beside its form: from " + std::to_string(low.z()) + " to " + std::to_string(high.z()) + " mm";
    return {};
}

int run(int count, int first, bool solve)
{
    std::array<int, kinds.size()> tried{}, failed{};
    for (int k = first; k < first + count; ++k) {
        const Trial each = trial(static_cast<unsigned>(k));
        ++tried[static_cast<unsigned>(k) % kinds.size()];
        if (const std::string what = outcome(each, solve); !what.empty()) {
            ++failed[static_cast<unsigned>(k) % kinds.size()];
            std::printf("%d (%s): %s\n", k, each.text.c_str(), what.c_str());
            std::fflush(stdout);
        }
    }
    std::printf("\n| line | forms | not as they should be |\n|---|---|---|\n");
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
        std::printf("| %s | %d | %d |\n", kinds[kind], tried[kind], failed[kind]);
    return 0;
}

} // namespace

} // namespace bolster::test

int main(int argc, char** argv)
{
    const bool solve = argc < 2 || std::strcmp(argv[1], "--flat") != 0;
    const int skip = solve ? 1 : 2;
    if (argc > skip && std::strcmp(argv[skip], "--help") == 0) {
        std::puts(
            "bolster_form_trials [--flat] [COUNT] [FIRST]: cuts COUNT forms (400), from number FIRST (0) on;\n"
            "--flat: lays them flat, without solving their covers");
        return 0;
    }
    const int count = argc > skip ? std::atoi(argv[skip]) : 400,
              first = argc > skip + 1 ? std::atoi(argv[skip + 1]) : 0;
    return bolster::test::run(count, first, solve);
}
