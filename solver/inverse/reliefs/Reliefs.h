// Where the cloth is strained over its limit: changes of the pattern that would relieve it, ranked.
#pragma once

#include "CoverStrains.h"
#include "SolveInput.h"
#include "SolveReport.h"
#include "SurfaceMesh.h"

#include <functional>
#include <stop_token>

namespace bolster {

struct ReliefOrder {
    std::optional<double> limit; ///< %, instead of the fabrics' limits; cloth that is pressed together counts, too
    double most = 6;             ///< mm by which edges may move at most
    int solved = 5;              ///< of how many covers are solved, each at another place
    double edgeLength = 0;       ///< of the triangles of predictions, mm; 0: the design's
    int threads = 0;             ///< 0: as many as the machine has; results do not depend on it
};

/// How much less there is over the limit, as a share of what is now.
struct ReliefGain {
    double energy = 0; ///< mean square of what is over the limit
    double area = 0;   ///< where something is over the limit
};

/// On the outline of a patch, mm.
struct ReliefPlace {
    ElementId patch{};
    Vec2 at = Vec2::Zero();
};

struct Relief {
    enum class Kind { Ease, LetOut, MoveSeam, Corner, Dart, Continuity };

    Kind kind = Kind::LetOut;
    ElementId element{};    ///< seam, fixation seam or patch
    ReliefPlace place = {}; ///< where it is: of an edge its middle
    Message text;           ///< what it does, as an order
    Edit edit;
    double predicted = 0;                  ///< gain of energy
    std::optional<ReliefGain> solved = {}; ///< on the design's triangles; nothing: not solved, or no cover at rest
    double sewn = 0;           ///< mm: seam that there is more of, or how far the sides of seams become unequal
    double moved = 0;          ///< mm: how far outlines change at most
    double shape = 0;          ///< mm, rms over the vertices: how far the cover of a solved one moves
    SurfaceMeshPtr cover = {}; ///< of a solved one; null when it does not come to rest
    std::vector<SolveReport::ScanFit> scans = {}; ///< how far that one lies from each scan of the design
};

struct ReliefList {
    Message problem;                         ///< why there is no cover; empty when there is one
    OverLimit now;                           ///< on the design's triangles
    SurfaceMeshPtr cover;                    ///< as it is now
    std::vector<SolveReport::ScanFit> scans; ///< how far it lies from each scan of the design
    std::vector<Relief> reliefs;             ///< the solved ones first, then by what is predicted
};

/// How far a cover lies from a scan now, and with a relief; mm, rms.
struct ScanChange {
    std::string name;
    double before = 0, after = 0;
};
/// Of the scans that show something of both covers.
std::vector<ScanChange> scanChanges(const ReliefList& list, const Relief& relief);

/// "ease", "let-out", "move-seam", "corner", "dart", "continuity"
const char* wordOf(Relief::Kind kind);

/// How much is done, 0 to 1; and when one more is solved what is known by then, in no order yet.
using ReliefNews = std::function<void(double share, const ReliefList* known)>;

/// What gains nothing by prediction is left out. Predicted is from differences of covers at rest, strain by strain
/// to the second order, at the best amount within the bound; of darts and continuity, which have no amount, from a
/// cover. Deterministic. When stopped it is not complete.
ReliefList proposeReliefs(const SolveInput& input, const ReliefOrder& order, const ReliefNews& news = {},
                          const std::stop_token& stop = {});

/// Solves the cover with that relief, from the start that depends on the design alone.
void solveRelief(const SolveInput& input, const std::optional<double>& limit, const OverLimit& now, int threads,
                 Relief& relief, const std::stop_token& stop = {});

} // namespace bolster
