#include "FileBytes.h"

#include <algorithm>

namespace bolster {

FileBytes FileBytes::quietly() const
{
    Source source = *m_source;
    source.watch.progress = nullptr;
    return FileBytes(std::move(source));
}

std::string_view FileWindow::view(std::uint64_t at, std::size_t least)
{
    auto& source = *m_bytes.m_source;
    const std::uint64_t left = source.size - std::min(at, source.size);
    if (!source.read)
        return source.whole.substr(source.whole.size() - static_cast<std::size_t>(left));
    source.watch.check(static_cast<double>(source.readSoFar) /
                       static_cast<double>(std::max<std::uint64_t>(source.size, 1)));
    const std::uint64_t count = std::min<std::uint64_t>(left, std::max(least, source.window));
    m_buffer.resize(static_cast<std::size_t>(count));
    if (!source.read(at, m_buffer.data(), m_buffer.size()))
        refuseFile({FilePlace::Unit::Byte, at},
                   QT_TRANSLATE_NOOP("Message", "%1: the file cannot be read any further; it has changed, or its "
                                                "disk is gone"));
    source.readSoFar = std::max(source.readSoFar, at + count);
    return {m_buffer.data(), m_buffer.size()};
}

} // namespace bolster
