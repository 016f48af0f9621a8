// Writing to somebody who may never read it.
#pragma once

namespace bolster {

/// Lives while something goes to a pipe or a device. That may take for ever, and leaves nothing that would have to
/// be put away: the program may end in the middle of it.
class DirectWrite {
public:
    DirectWrite();
    ~DirectWrite();
    DirectWrite(const DirectWrite&) = delete;
    DirectWrite& operator=(const DirectWrite&) = delete;

    /// Whether there is one now. Then none begins or ends any more: whoever asks must end the program.
    static bool halted();
};

} // namespace bolster
