// The bytes of a file for the readers, in memory or a window of it at a time, and how somebody watches and stops
// them.
#pragma once

#include "FileRefused.h"
#include "ImportWatch.h"

#include <functional>
#include <memory>

namespace bolster {

/// Cheap to copy. Throws ImportStopped when reading shall end, FileRefused when the disk gives nothing.
class FileBytes {
public:
    /// As they lie in memory, which must stay.
    FileBytes(std::string_view whole) // NOLINT(google-explicit-constructor): where text is at hand, readers take it
        : m_source(std::make_shared<Source>(Source{whole, {}, {}, whole.size(), 0, whole.size()}))
    {}
    FileBytes(const std::string& whole) // NOLINT(google-explicit-constructor)
        : FileBytes(std::string_view(whole))
    {}
    /// From wherever `read(at, to, count)` gets them; it returns false when it cannot. `window` bytes are read at
    /// once.
    using Read = std::function<bool(std::uint64_t at, char* to, std::size_t count)>;
    FileBytes(Read read, std::uint64_t size, ImportWatch watch = {}, std::size_t window = usualWindow)
        : m_source(std::make_shared<Source>(Source{{}, std::move(read), std::move(watch), size, window, 0}))
    {}

    std::uint64_t size() const { return m_source->size; }
    const ImportWatch& watch() const { return m_source->watch; }
    /// The same ones, for a look ahead: how far it is counts for nothing. It may be stopped.
    FileBytes quietly() const;

private:
    friend class FileWindow;

    static constexpr std::size_t usualWindow = 1 << 20;
    struct Source {
        std::string_view whole;
        Read read;
        ImportWatch watch;
        std::uint64_t size;
        std::size_t window;
        std::uint64_t readSoFar;
    };
    explicit FileBytes(Source source)
        : m_source(std::make_shared<Source>(std::move(source)))
    {}

    std::shared_ptr<Source> m_source;
};

/// A piece of the bytes that moves along.
class FileWindow {
public:
    explicit FileWindow(FileBytes bytes)
        : m_bytes(std::move(bytes))
    {}
    FileWindow(FileWindow&&) = default;
    FileWindow& operator=(FileWindow&&) = default;

    std::uint64_t size() const { return m_bytes.size(); }
    /// From `at` to wherever it ends: at least `least` bytes, or all that there are. What was seen before is gone.
    std::string_view view(std::uint64_t at, std::size_t least);

private:
    FileBytes m_bytes;
    std::vector<char> m_buffer;
};

} // namespace bolster
