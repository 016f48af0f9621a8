// Reliefs of a cover beside the window, with pictures.
#pragma once

#include "Camera.h"
#include "Reliefs.h"

#include <QImage>
#include <QSize>

namespace bolster {

struct ReliefWanted {
    int number = 0;
    SolveInput input;
    ReliefOrder order;
    Camera camera;     ///< from where the pictures look
    QSize pictureSize; ///< pixels
};

struct ReliefFound {
    int number = 0;
    ReliefList list;              ///< of the solved ones
    QImage now;                   ///< in the colours of its strain
    std::vector<QImage> pictures; ///< of these reliefs, in the same colours
    bool whole = false;           ///< there is nothing more to come
};

/// How much is done, and when one more is solved what is known by then.
using ReliefsSeen = std::function<void(double share, const ReliefFound* known)>;

ReliefFound findReliefs(const ReliefWanted& wanted, const ReliefsSeen& news, const std::stop_token& stop);

} // namespace bolster
