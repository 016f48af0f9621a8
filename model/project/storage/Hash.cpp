#include "Hash.h"

#include <QCryptographicHash>

#include <algorithm>

namespace bolster {
namespace {

// Little-endian on every machine.
std::array<std::uint64_t, 4> lanesOf(const Hash& hash)
{
    std::array<std::uint64_t, 4> lanes = {};
    for (std::size_t i = 0; i < hash.size(); ++i)
        lanes[i / 8] |= std::uint64_t{hash[i]} << (8 * (i % 8));
    return lanes;
}

} // namespace

Hash hashOf(std::string_view bytes)
{
    const QByteArray result =
        QCryptographicHash::hash(QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size())),
                                 QCryptographicHash::Blake2b_256);
    Hash hash;
    std::copy(result.begin(), result.end(), hash.begin());
    return hash;
}

std::string hexText(const Hash& hash)
{
    static constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t byte : hash) {
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }
    return text;
}

void HashSum::add(const Hash& hash)
{
    const auto lanes = lanesOf(hash);
    for (std::size_t i = 0; i < lanes.size(); ++i)
        m_lanes[i] += lanes[i];
}

void HashSum::remove(const Hash& hash)
{
    const auto lanes = lanesOf(hash);
    for (std::size_t i = 0; i < lanes.size(); ++i)
        m_lanes[i] -= lanes[i];
}

Hash HashSum::value() const
{
    Hash hash;
    for (std::size_t i = 0; i < hash.size(); ++i)
        hash[i] = static_cast<std::uint8_t>(m_lanes[i / 8] >> (8 * (i % 8)));
    return hash;
}

} // namespace bolster
