#include "DirectWrite.h"

#include <mutex>

namespace bolster {

namespace {

std::mutex directWritesMutex;
int directWrites = 0;

} // namespace

DirectWrite::DirectWrite()
{
    const std::scoped_lock lock(directWritesMutex);
    ++directWrites;
}

DirectWrite::~DirectWrite()
{
    const std::scoped_lock lock(directWritesMutex);
    --directWrites;
}

bool DirectWrite::halted()
{
    std::unique_lock lock(directWritesMutex);
    if (directWrites == 0)
        return false;
    lock.release(); // and stays locked
    return true;
}

} // namespace bolster
