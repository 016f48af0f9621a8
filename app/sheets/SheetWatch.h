// Somebody who waits for sheets that are made, and may give them up.
#pragma once

#include <functional>
#include <stop_token>

namespace bolster {

struct SheetWatch {
    std::stop_token stop{};
    /// Called on the thread that makes them with how much is done, 0 to 1.
    std::function<void(double done)> progress{};

    bool stopped() const { return stop.stop_requested(); }
    void say(double done) const
    {
        if (progress)
            progress(done);
    }
};

} // namespace bolster
