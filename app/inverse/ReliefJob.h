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
    ReliefList list;
    QImage now;                   ///< in the colours of its strain
    std::vector<QImage> pictures; ///< of the solved reliefs, in the same colours
};

ReliefFound findReliefs(const ReliefWanted& wanted, const std::function<void(double)>& progress,
                        const std::stop_token& stop);

} // namespace bolster
