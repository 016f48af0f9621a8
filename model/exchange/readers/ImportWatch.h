// Somebody who waits for a file to be read: sees how far it is, and may stop it.
#pragma once

#include <functional>
#include <stop_token>
#include <string>

namespace bolster {

/// Whoever watches has asked to stop. Thrown by readers of files; importFile() and its like catch it.
struct ImportStopped {};

struct ImportWatch {
    std::stop_token stop{};
    /// Called on the reading thread with how much is done, 0 to 1, every few milliseconds.
    std::function<void(double done)> progress{};
    /// Called with what is odd of a file that is read nevertheless; in the sentence %1 stands for the file and %2,
    /// if it is there, for the figure.
    std::function<void(const char* sentence, const std::string& figure)> warn{};

    /// Throws ImportStopped.
    void checkStop() const
    {
        if (stop.stop_requested())
            throw ImportStopped();
    }
    void check(double done) const
    {
        checkStop();
        if (progress)
            progress(done);
    }
};

} // namespace bolster
