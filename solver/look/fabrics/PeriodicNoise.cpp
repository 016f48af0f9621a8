#include "PeriodicNoise.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

/// PCG in two dimensions (M. Jarzynski and M. Olano, "Hash functions for GPU rendering", 2020).
std::uint32_t hashed(std::uint32_t x, std::uint32_t y, std::uint32_t seed)
{
    x = x * 1664525u + 1013904223u + seed;
    y = y * 1664525u + 1013904223u + 0x9e3779b9u * seed;
    x += y * 1664525u;
    y += x * 1664525u;
    x ^= x >> 16;
    y ^= y >> 16;
    x += y * 1664525u;
    y += x * 1664525u;
    return x ^ (x >> 16) ^ (y << 1);
}

/// Of what an int holds. (std::floor calls a function where nobody may ask for SSE4.1.)
int floored(float x)
{
    const int whole = static_cast<int>(x);
    return whole - static_cast<int>(static_cast<float>(whole) > x);
}

int wrapped(int i, int period)
{
    if (0 <= i && i < period)
        return i; // nearly always, and a division takes longer than all the rest
    const int rest = i % period;
    return rest < 0 ? rest + period : rest;
}

float slope(int x, int y, const Spot& away, std::uint32_t seed)
{
    static constexpr float d = 0.70710678f;
    static constexpr float gradients[8][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {d, d}, {-d, d}, {d, -d}, {-d, -d}};
    const std::uint32_t hash = hashed(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), seed);
    const auto& gradient = gradients[(hash >> 11) & 7];
    return gradient[0] * away.x() + gradient[1] * away.y();
}

float eased(float t)
{
    return t * t * t * (t * (6 * t - 15) + 10);
}

} // namespace

float randomAt(int x, int y, std::uint32_t seed)
{
    return static_cast<float>(hashed(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), seed) >> 8) /
           16777216.f;
}

float noiseAt(const Spot& at, Eigen::Vector2i period, std::uint32_t seed)
{
    period = period.cwiseMax(1);
    const int left = floored(at.x()), below = floored(at.y());
    const int x = wrapped(left, period.x()), y = wrapped(below, period.y());
    const int right = x + 1 == period.x() ? 0 : x + 1, up = y + 1 == period.y() ? 0 : y + 1;
    const Spot t(at.x() - static_cast<float>(left), at.y() - static_cast<float>(below));
    const float a = slope(x, y, t, seed), b = slope(right, y, t - Spot(1, 0), seed);
    const float c = slope(x, up, t - Spot(0, 1), seed), d = slope(right, up, t - Spot(1, 1), seed);
    const float ex = eased(t.x()), ey = eased(t.y());
    return 1.5f * ((1 - ey) * ((1 - ex) * a + ex * b) + ey * ((1 - ex) * c + ex * d));
}

float fractalAt(const Spot& at, Eigen::Vector2i period, int octaves, std::uint32_t seed)
{
    period = period.cwiseMax(1);
    float sum = 0, strength = 1, most = 0;
    for (int i = 0; i < octaves; ++i) {
        sum += strength * noiseAt(at.cwiseProduct(period.cast<float>()), period, seed + 977u * i);
        most += strength;
        strength *= 0.5f;
        period *= 2;
    }
    return sum / most;
}

Cell cellAt(const Spot& at, int period, float jitter, std::uint32_t seed)
{
    period = std::max(1, period);
    const int x0 = floored(at.x()), y0 = floored(at.y());
    float nearest2 = 81, second2 = 81;
    Cell cell;
    for (int y = y0 - 1; y <= y0 + 1; ++y)
        for (int x = x0 - 1; x <= x0 + 1; ++x) {
            const std::uint32_t hash = hashed(static_cast<std::uint32_t>(wrapped(x, period)),
                                              static_cast<std::uint32_t>(wrapped(y, period)), seed);
            const Spot off(static_cast<float>(hash & 0xffff) / 65536.f, static_cast<float>(hash >> 16) / 65536.f);
            const Spot point = Spot(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f) +
                               jitter * (off - Spot(0.5f, 0.5f));
            const float distance2 = (point - at).squaredNorm();
            if (distance2 < nearest2) {
                second2 = nearest2;
                nearest2 = distance2;
                cell.random = static_cast<float>((hash * 2654435761u) >> 8) / 16777216.f;
            } else if (distance2 < second2) {
                second2 = distance2;
            }
        }
    cell.nearest = std::sqrt(nearest2);
    cell.second = std::sqrt(second2);
    return cell;
}

float ramp(float from, float to, float value)
{
    const float t = std::clamp((value - from) / (to - from), 0.f, 1.f);
    return t * t * (3 - 2 * t);
}

} // namespace bolster
