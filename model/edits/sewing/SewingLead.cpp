#include "SewingLead.h"

namespace bolster::edits {

namespace {

/// Stretches that have changed; false when the mirror has no such place.
bool followStretches(const Lead<Seam>& lead, bool swapped, const SewnMirror& mirror, Seam& seam)
{
    for (Stretch Seam::*side : {&Seam::a, &Seam::b}) {
        if (lead.before.*side == lead.now.*side)
            continue;
        const auto image = mirror.of(lead.now.*side);
        if (!image)
            return false;
        Stretch Seam::*other = (side == &Seam::a) == swapped ? &Seam::b : &Seam::a;
        if (!mirror.same(seam.*other, image->stretch))
            seam.*other = image->stretch;
    }
    return true;
}

} // namespace

std::optional<Seam> followed(const Lead<Seam>& lead, bool swapped, const SewnMirror& mirror, Seam seam)
{
    if (!followStretches(lead, swapped, mirror, seam))
        return std::nullopt;
    if (lead.before.reversed != lead.now.reversed)
        seam.reversed = !seam.reversed;
    if (lead.before.match != lead.now.match)
        seam.match = lead.now.match;
    if (lead.before.continuity != lead.now.continuity)
        seam.continuity = lead.now.continuity;
    if (!(lead.before.trim == lead.now.trim))
        seam.trim = lead.now.trim;
    if (lead.before.ease != lead.now.ease)
        seam.ease = swapped ? -lead.now.ease : lead.now.ease;
    if (lead.before.zip != lead.now.zip)
        seam.zip = lead.now.zip;
    return seam;
}

std::optional<FixationSeam> followed(const Lead<FixationSeam>& lead, bool, const SewnMirror& mirror,
                                     FixationSeam fixation)
{
    const auto image = mirror.of(lead.now);
    if (!image)
        return std::nullopt;
    if (!(lead.before.stretch == lead.now.stretch) && !mirror.same(fixation.stretch, image->stretch))
        fixation.stretch = image->stretch;
    if (lead.before.curve != lead.now.curve || lead.before.curveRange != lead.now.curveRange ||
        lead.before.reversed != lead.now.reversed) {
        fixation.curve = image->curve;
        fixation.curveRange = image->curveRange;
        fixation.reversed = image->reversed;
    }
    if (lead.before.match != lead.now.match)
        fixation.match = lead.now.match;
    if (!(lead.before.orientation == lead.now.orientation))
        fixation.orientation = image->orientation;
    if (!(lead.before.trim == lead.now.trim))
        fixation.trim = lead.now.trim;
    return fixation;
}

bool alike(const Lead<Seam>& lead, bool swapped, const SewnMirror& mirror, const Seam& other)
{
    const auto image = mirror.of(lead.now);
    return image && mirror.same(swapped ? image->b : image->a, other.a) &&
           mirror.same(swapped ? image->a : image->b, other.b) && image->match == other.match &&
           image->continuity == other.continuity && image->trim == other.trim;
}

bool alike(const Lead<FixationSeam>& lead, bool, const SewnMirror& mirror, const FixationSeam& other)
{
    const auto image = mirror.of(lead.now);
    return image && *image == other;
}

} // namespace bolster::edits
