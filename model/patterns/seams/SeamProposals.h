// Which edges of a pattern seem to belong together.
#pragma once

#include "Design.h"

#include <stop_token>

namespace bolster {

/// Two free edges, each from one corner to the next, or to where something else begins.
struct SeamProposal {
    Stretch a;
    Stretch b;
    bool reversed = true;
    double lengthA = 0; ///< mm
    double lengthB = 0;
    double certainty = 0; ///< 0 to 1: how much better it fits than anything else that either edge could be sewn to
    bool dart = false;    ///< they are the legs of one
};

/// The most certain first; no edge is in two of them. Edges that are sewn or fixed already are left alone, and tell
/// where their neighbours belong. What speaks for a pair: lengths, corners that close when all of their edges are
/// sewn, notches at the same places, words like "left" in the names, bends that follow each other. A strip that
/// runs past several edges of a piece is divided where their corners come, and an edge that fits nothing as a whole
/// at its notches, where what lies between them does. Two edges that lead into a wedge of one piece and are mirror
/// images of each other are the legs of a dart, whatever else they would fit. Where hundreds of edges are of one
/// length each is compared with some of them only, those of neighbouring patches first. Nothing when asked to stop.
std::vector<SeamProposal> proposeSeams(const Design& design, const std::stop_token& stop = {});

/// All of these seams as one edit; those of darts are smooth.
Edit sewProposals(const Design& design, const std::vector<SeamProposal>& proposals);

} // namespace bolster
