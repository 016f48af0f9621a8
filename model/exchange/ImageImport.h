// Pictures from PNG, JPEG, TIFF and OpenEXR files. Untrusted input: a process of its own decodes them, with limits
// on memory and time, so that whatever a broken or malicious file does to a decoder, it does it there.
#pragma once

#include "ImagePixels.h"
#include "Message.h"

#include <QString>

#include <chrono>
#include <cstdint>
#include <stop_token>

namespace bolster {

struct ImageOutcome {
    ImagePixelsPtr pixels; ///< null when refused or stopped
    Message problem;       ///< why; empty when stopped
};

/// The process that decodes, and how far it may go before it is killed.
struct ImageDecoder {
    QString program = usualProgram();
    std::uint64_t memory = 2'500'000'000; ///< bytes of address space, the decoders' own libraries included
    std::chrono::seconds processor{40};   ///< of processor time
    std::chrono::milliseconds time{60'000};

    /// bolster-image of this installation, or of this build; "" when there is none.
    static QString usualProgram();
};

/// Reads a picture of at most 64 million pixels; one with a side of more than 2048 is scaled down to that. The
/// file's content decides what it is, not its name. Float pixels (OpenEXR) are taken for light and encoded as sRGB;
/// a photograph that is marked as turned is turned. Takes about 0.2 s and more: call it on a thread of its own
/// (inBackground); `stop` ends it within 50 ms.
ImageOutcome importImage(const QString& path, const std::stop_token& stop = {}, const ImageDecoder& decoder = {});

} // namespace bolster
