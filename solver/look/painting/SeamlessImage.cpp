#include "SeamlessImage.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <vector>

namespace bolster {

namespace {

using Complex = std::complex<float>;

/// e^(2 pi i k / n) for k = 0 to n - 1.
std::vector<Complex> circle(std::size_t n)
{
    std::vector<Complex> points;
    for (std::size_t k = 0; k < n; ++k)
        points.push_back(
            Complex(std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n))));
    return points;
}

/// Frequencies 0 to n / 2 of real values.
std::vector<Complex> frequencies(std::span<const float> values, const std::vector<Complex>& circle)
{
    const std::size_t n = values.size();
    std::vector<Complex> result(n / 2 + 1);
    for (std::size_t r = 0; r < result.size(); ++r) {
        Complex sum;
        for (std::size_t y = 0, at = 0; y < n; ++y, at = (at + r) % n)
            sum += values[y] * std::conj(circle[at]);
        result[r] = sum / static_cast<float>(n);
    }
    return result;
}

/// How far a wave along the border reaches in, `x` pixels from it: g(x - 1) + g(x + 1) - 2 cosh(mu) g(x) is 1 at
/// x = 0, -1 at the other border x = width - 1 and else 0, over the border, too.
double reach(double mu, double x, double width)
{
    const double middle = (width - 1) / 2;
    if (mu == 0)
        return (x - middle) / width;
    // sinh of large numbers would overflow: both sides are divided by exp(mu middle) / 2.
    const double here = std::exp(-mu * x) - std::exp(-mu * (2 * middle - x));
    const double first = 1 - std::exp(-2 * mu * middle);
    const double beyond = std::exp(mu) - std::exp(-mu * (2 * middle + 1));
    return -here / (first + beyond);
}

/// Pixels of a channel, of which lines run along the border and `across` from it.
struct Lines {
    float* pixels;
    std::size_t across, along;
    std::size_t stepAcross, stepAlong;

    float& at(std::size_t x, std::size_t y) const { return pixels[x * stepAcross + y * stepAlong]; }
};

/// Subtracts the part of s that the jumps between the first and the last line make.
void takeJump(const Lines& lines, const std::vector<float>& jump)
{
    const std::size_t n = lines.along;
    const std::vector<Complex> turns = circle(n);
    const std::vector<Complex> waves = frequencies(jump, turns);
    for (std::size_t x = 0; 2 * x + 1 < lines.across; ++x) {
        std::vector<float> smooth(n, 0);
        for (std::size_t r = 0; r < waves.size(); ++r) {
            const double mu =
                std::acosh(2 - std::cos(2 * std::numbers::pi * static_cast<double>(r) / static_cast<double>(n)));
            const double g = reach(mu, static_cast<double>(x), static_cast<double>(lines.across));
            if (r > 0 && std::abs(g) < 1e-5)
                break; // finer waves reach less far
            const float twice = r == 0 || 2 * r == n ? 1 : 2;
            const Complex wave = twice * static_cast<float>(g) * waves[r];
            for (std::size_t y = 0, at = 0; y < n; ++y, at = at + r < n ? at + r : at + r - n)
                smooth[y] += wave.real() * turns[at].real() - wave.imag() * turns[at].imag();
        }
        for (std::size_t y = 0; y < n; ++y) {
            lines.at(x, y) -= smooth[y];
            lines.at(lines.across - 1 - x, y) += smooth[y];
        }
    }
}

std::vector<float> jumpOf(const Lines& lines)
{
    std::vector<float> jump;
    for (std::size_t y = 0; y < lines.along; ++y)
        jump.push_back(lines.at(lines.across - 1, y) - lines.at(0, y));
    return jump;
}

} // namespace

void makeSeamless(OIIO::ImageBuf& image)
{
    auto* pixels = static_cast<float*>(image.localpixels());
    const auto w = static_cast<std::size_t>(image.spec().width), h = static_cast<std::size_t>(image.spec().height);
    const auto channels = static_cast<std::size_t>(image.nchannels());
    if (!pixels || image.spec().format != OIIO::TypeDesc::FLOAT || w < 2 || h < 2)
        return;
    for (std::size_t c = 0; c < channels; ++c) {
        const Lines columns{pixels + c, w, h, channels, w * channels},
            rows{pixels + c, h, w, w * channels, channels};
        const std::vector<float> sideways = jumpOf(columns), upwards = jumpOf(rows);
        takeJump(columns, sideways);
        takeJump(rows, upwards);
    }
}

} // namespace bolster
