#include "OpenEnds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

constexpr double apart = 4; // mm, between places that are looked at

/// The line whose place is nearest; null without lines.
const LineToCut* lineAt(const Vec3& at, const std::vector<LineToCut>& lines)
{
    const auto away = [&](const LineToCut& line) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec3& place : line.places)
            nearest = std::min(nearest, (place - at).norm());
        return nearest;
    };
    const auto found = std::ranges::min_element(lines, {}, away);
    return found != lines.end() ? &*found : nullptr;
}

/// In which direction a line ends there; zero where it is too short to say.
Vec3 directionAt(const Vec3& at, const LineToCut& line)
{
    constexpr double near = 8, far = 25; // mm
    Vec3 behind = Vec3::Zero();
    int count = 0;
    for (const Vec3& place : line.places)
        if (const double away = (place - at).norm(); away > near && away < far) {
            behind += place;
            ++count;
        }
    return count > 0 ? Vec3((at - behind / count).normalized()) : Vec3::Zero();
}

/// The place nearest to where a line ends: of where the form is cut anyway, and of the other lines. What lies
/// beside counts as if it were twice as far away as what lies ahead, what lies behind three times.
std::optional<Vec3> nearestTo(const Vec3& at, const LineToCut* own, const UncutForm& form,
                              const std::vector<LineToCut>& lines)
{
    const Vec3 ahead = own ? directionAt(at, *own) : Vec3::Zero();
    std::optional<Vec3> nearest;
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](const Vec3& place) {
        const double far = (place - at).norm(), counts = 2 * far - ahead.dot(place - at);
        if (counts < least) {
            least = counts;
            nearest = place;
        }
    };
    form.eachEdgeCutAnyway([&](const Vec3& a, const Vec3& b) {
        const int steps = std::max(1, static_cast<int>((b - a).norm() / apart));
        look(nearestOnSegment<3>(at, a, b));
        for (int k = 0; k <= steps; ++k)
            look(a + double(k) / steps * (b - a));
    });
    for (const LineToCut& line : lines)
        if (&line != own && line.isCut)
            for (const Vec3& place : line.places)
                look(form.nearest(place));
    return nearest;
}

Message meaningOf(const OpenEnd& end)
{
    const std::string at = placeText(end.way.front());
    if (end.way.size() == 1)
        return {QT_TRANSLATE_NOOP("Message",
                                  "%1 ends inside a piece, at %2: it is cut in there like a dart. There is no "
                                  "other line or border; lead it around to where it began to divide the piece"),
                {end.line, at}};
    return {QT_TRANSLATE_NOOP("Message", "%1 ends inside a piece, at %2: it is cut in there like a dart. The next "
                                         "line or border is %3 mm away; draw it on to there to divide the piece"),
            {end.line, at, numberText((end.way.back() - end.way.front()).norm(), 2)}};
}

} // namespace

OpenEnd openEndAt(const Vec3& at, const UncutForm& form, const std::vector<LineToCut>& lines)
{
    const LineToCut* own = lineAt(at, lines);
    OpenEnd end{own ? own->line.name : std::string(), {at}, {}};
    if (const std::optional<Vec3> to = nearestTo(at, own, form, lines)) {
        const int steps = std::max(1, static_cast<int>(std::ceil((*to - at).norm() / apart)));
        for (int k = 1; k < steps; ++k)
            end.way.push_back(form.nearest(at + double(k) / steps * (*to - at)));
        end.way.push_back(*to);
    }
    end.note = meaningOf(end);
    return end;
}

} // namespace bolster
