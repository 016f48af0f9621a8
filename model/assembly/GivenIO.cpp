#include "GivenIO.h"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace bolster {
namespace {

class GivenStream : public Assimp::IOStream {
public:
    explicit GivenStream(std::string_view bytes)
        : m_bytes(bytes)
    {}

    size_t Read(void* to, size_t size, size_t count) override
    {
        if (size == 0 || count == 0)
            return 0;
        const size_t whole = std::min(count, (m_bytes.size() - m_at) / size);
        std::memcpy(to, m_bytes.data() + m_at, whole * size);
        m_at += whole * size;
        return whole;
    }

    size_t Write(const void*, size_t, size_t) override { return 0; }

    aiReturn Seek(size_t offset, aiOrigin origin) override
    {
        // From the end and from here a file may be told to go backwards: the sum wraps around.
        const size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? m_at : m_bytes.size();
        const size_t at = from + offset;
        if (at > m_bytes.size())
            return aiReturn_FAILURE;
        m_at = at;
        return aiReturn_SUCCESS;
    }

    size_t Tell() const override { return m_at; }
    size_t FileSize() const override { return m_bytes.size(); }
    void Flush() override {}

private:
    std::string_view m_bytes;
    size_t m_at = 0;
};

/// "leg%20frame.bin" is "leg frame.bin".
std::string decoded(std::string_view name)
{
    std::string plain;
    for (std::size_t i = 0; i < name.size(); ++i) {
        int code = 0;
        if (name[i] == '%' && i + 2 < name.size() &&
            std::from_chars(name.data() + i + 1, name.data() + i + 3, code, 16).ptr == name.data() + i + 3) {
            plain += static_cast<char>(code);
            i += 2;
        } else {
            plain += name[i];
        }
    }
    return plain;
}

} // namespace

GivenIO::GivenIO(std::string name, std::string_view main, const SceneOrder& order)
    : m_name(std::move(name))
    , m_main(main)
    , m_order(order)
{}

const std::string_view* GivenIO::find(std::string_view file) const
{
    while (file.starts_with("./"))
        file.remove_prefix(2);
    if (file == m_name)
        return &m_main;
    for (const std::string& name : {std::string(file), decoded(file)})
        if (const auto found = m_order.beside.find(name); found != m_order.beside.end())
            return &found->second;
    return nullptr;
}

bool GivenIO::Exists(const char* file) const
{
    return find(file) != nullptr;
}

Assimp::IOStream* GivenIO::Open(const char* file, const char*)
{
    if (const std::string_view* const bytes = find(file)) {
        if (bytes != &m_main)
            m_beside = decoded(file);
        return new GivenStream(*bytes);
    }
    if (m_missing.empty())
        m_missing = decoded(file);
    return nullptr;
}

void GivenIO::Close(Assimp::IOStream* stream)
{
    delete stream;
}

} // namespace bolster
