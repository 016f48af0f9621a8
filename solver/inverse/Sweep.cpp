#include "Sweep.h"

#include "CoverMove.h"
#include "CoverTeam.h"
#include "SurfaceMeasures.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <random>
#include <utility>

namespace bolster {

namespace {

constexpr int blockOfVertices = 256;
// Of solved pieces, to tell how sure they are.
constexpr std::size_t fewestToTell = 16;
constexpr double fewToTell = 20;
constexpr int halvings = 8;
constexpr int linearBatches = 8;

/// Nearly Student's quantile for 95 %, two-sided.
double studentOf(double degrees)
{
    return 2 + 2.5 / degrees;
}

float percentile95(std::vector<float>& sizes)
{
    if (sizes.empty())
        return 0;
    // Of fewer than 20 it is the largest.
    const auto place = static_cast<std::ptrdiff_t>((sizes.size() * 95 + 99) / 100) - 1;
    std::ranges::nth_element(sizes, sizes.begin() + place);
    return sizes[static_cast<std::size_t>(place)];
}

/// Of the values' sizes.
void summarise(SweepSample& sample)
{
    std::vector<float> sizes;
    double squares = 0;
    for (const float value : sample.outside) {
        sizes.push_back(std::abs(value));
        squares += static_cast<double>(value) * value;
    }
    if (sizes.empty())
        return;
    sample.p95 = percentile95(sizes);
    sample.rms = std::sqrt(squares / static_cast<double>(sizes.size()));
    sample.most = *std::ranges::max_element(sizes);
}

/// How many spreads of each tolerance: upwards and downwards, as the columns of Sweep::linear.
Eigen::VectorXf spreadsOf(const Tolerances& tolerances, std::uint64_t number)
{
    const Eigen::VectorXd values = sampleOf(tolerances, number);
    Eigen::VectorXf spreads(2 * values.size());
    for (Eigen::Index k = 0; k < values.size(); ++k) {
        const double spread = values[k] / tolerances.all[static_cast<std::size_t>(k)].spread;
        spreads[2 * k] = static_cast<float>(std::max(spread, 0.0));
        spreads[2 * k + 1] = static_cast<float>(std::max(-spread, 0.0));
    }
    return spreads;
}

struct SolvedPiece {
    const SweepSample* solved;
    const SweepSample* linear;
};

std::vector<float> corrected(std::vector<float> linearP95, const std::vector<SolvedPiece>& pieces)
{
    std::vector<const SweepSample*> solved, linear;
    for (const SolvedPiece& piece : pieces) {
        solved.push_back(piece.solved);
        linear.push_back(piece.linear);
    }
    const std::vector<float> above = solvedP95(solved), below = solvedP95(linear);
    for (std::size_t v = 0; v < above.size(); ++v)
        linearP95[v] = std::max(0.0F, linearP95[v] + above[v] - below[v]);
    return linearP95;
}

/// In the same order with every standard library, as std::shuffle is not.
void shuffle(std::vector<SolvedPiece>& pieces, std::mt19937& dice)
{
    for (std::size_t k = pieces.size() - 1; k > 0; --k)
        std::swap(pieces[k], pieces[dice() % (k + 1)]);
}

} // namespace

struct Sweep::Team {
    explicit Team(CoverTeam team)
        : covers(std::move(team))
    {}

    CoverTeam covers;

    /// Per vertex of the nominal cover.
    std::vector<float> outside(const WarmCover& cover, const SurfaceMesh& nominal) const
    {
        const Eigen::Matrix3Xd positions = cover.state().positions;
        const Eigen::Matrix3Xd& home = cover.home().positions;
        const std::vector<std::uint32_t>& unknown = nominal.topology->unknown;
        std::vector<float> values(unknown.size());
        for (std::size_t v = 0; v < unknown.size(); ++v)
            values[v] = alongNormal(nominal, v, positions.col(unknown[v]) - home.col(unknown[v]));
        return values;
    }

    /// The same of a cover on triangles of its own. Empty when the two have nothing in common.
    static std::vector<float> outside(const SurfaceMesh& own, const SurfaceMesh& nominal)
    {
        const SurfaceMeshPtr there = moveBetween(own, nominal).from;
        std::vector<float> values(there ? nominal.positions.size() : 0);
        for (std::size_t v = 0; v < values.size(); ++v)
            values[v] = alongNormal(nominal, v, there->positions[v] - nominal.positions[v]);
        return values;
    }

private:
    static float alongNormal(const SurfaceMesh& nominal, std::size_t v, const Vec3& move)
    {
        // A thousandth of a millimetre: what comes after it depends on the processor.
        return std::round(static_cast<float>(nominal.normals[v].cast<double>().dot(move)) * 1000) / 1000;
    }
};

Sweep::Sweep(const SolveInput& input, Tolerances tolerances, int threads, const std::stop_token& stop,
             double edgeLength)
    : m_tolerances(std::move(tolerances))
    , m_design(input.design)
    , m_files(input.files)
    , m_edgeLength(edgeLength)
    , m_team(std::make_unique<Team>(CoverTeam(input, {.edgeLength = edgeLength}, threads, stop)))
{
    if (m_team->covers.problem().empty() && !stop.stop_requested())
        m_nominal = m_team->covers.first().surface();
}

Sweep::~Sweep() = default;

const Message& Sweep::problem() const
{
    return m_team->covers.problem();
}

Eigen::MatrixXf Sweep::linear(const std::function<void(double)>& progress, const std::stop_token& stop)
{
    const int count = static_cast<int>(m_tolerances.all.size());
    Eigen::MatrixXf result = Eigen::MatrixXf::Zero(std::ssize(m_nominal->positions), 2 * count);
    std::atomic<int> done = 0;
    std::mutex mutex; // of the progress, and of what is unknown
    m_unknown.clear();
    m_team->covers.forTasks(count, [&](WarmCover& cover, int k) {
        if (stop.stop_requested())
            return;
        const double spread = m_tolerances.all[static_cast<std::size_t>(k)].spread;
        std::array<std::optional<Eigen::VectorXf>, 2> sides;
        for (const int side : {0, 1}) {
            Eigen::VectorXd values = Eigen::VectorXd::Zero(count);
            values[k] = side == 0 ? spread : -spread;
            if (!cover.follow(sampleDesign(m_design, m_tolerances, values), stop))
                continue;
            const std::vector<float> outside = m_team->outside(cover, *m_nominal);
            sides[side] = Eigen::Map<const Eigen::VectorXf>(outside.data(), result.rows());
        }
        for (const int side :
             {0, 1}) // where there is no cover on one side, that of the other one says what it knows
            if (sides[side] || sides[1 - side])
                result.col(2 * k + side) = sides[side] ? *sides[side] : Eigen::VectorXf(-*sides[1 - side]);
        const std::scoped_lock lock(mutex);
        if (!sides[0] && !sides[1])
            m_unknown.push_back(static_cast<std::size_t>(k));
        if (progress)
            progress(static_cast<double>(++done) / count);
    });
    std::ranges::sort(m_unknown);
    return result;
}

std::vector<SweepSample> Sweep::solve(std::uint64_t first, int count, const std::stop_token& stop)
{
    std::vector<SweepSample> samples(static_cast<std::size_t>(count));
    m_team->covers.forTasks(count, [&](WarmCover& cover, int k) {
        SweepSample& sample = samples[static_cast<std::size_t>(k)];
        sample.number = first + static_cast<std::uint64_t>(k);
        const Design design = sampleDesign(m_design, m_tolerances, sampleOf(m_tolerances, sample.number));
        if (stop.stop_requested())
            return;
        if (cover.follow(design, stop)) {
            sample.outside = m_team->outside(cover, *m_nominal);
            sample.strain = measureSurface(cover.sheet(), cover.state()).strain.p99;
        } else if (!stop.stop_requested()) {
            solveAlone(design, sample, stop);
        }
        summarise(sample);
    });
    return samples;
}

/// Where triangles cannot stay, or no cover is found from the nominal one.
void Sweep::solveAlone(const Design& design, SweepSample& sample, const std::stop_token& stop) const
{
    const WarmCover alone({design, m_files}, {.edgeLength = m_edgeLength}, stop);
    if (!alone.hasHome())
        return;
    sample.outside = Team::outside(*alone.surface(), *m_nominal);
    sample.strain = measureSurface(alone.sheet(), alone.state()).strain.p99;
}

std::vector<SurfaceMeshPtr> Sweep::covers(const std::vector<Eigen::VectorXd>& numbers, const std::stop_token& stop)
{
    std::vector<SurfaceMeshPtr> found(numbers.size());
    m_team->covers.forTasks(static_cast<int>(numbers.size()), [&](WarmCover& cover, int k) {
        const auto which = static_cast<std::size_t>(k);
        if (!stop.stop_requested() && cover.follow(sampleDesign(m_design, m_tolerances, numbers[which]), stop))
            found[which] = cover.surface();
    });
    return found;
}

SweepSample linearSample(const Eigen::MatrixXf& linear, const Tolerances& tolerances, std::uint64_t number)
{
    SweepSample sample;
    sample.number = number;
    const Eigen::VectorXf outside = linear * spreadsOf(tolerances, number);
    sample.outside.assign(outside.begin(), outside.end());
    summarise(sample);
    return sample;
}

LinearP95 linearP95(const Eigen::MatrixXf& linear, const Tolerances& tolerances, int samples,
                    const std::stop_token& stop)
{
    Eigen::MatrixXf spreads(linear.cols(), samples);
    for (int s = 0; s < samples; ++s)
        spreads.col(s) = spreadsOf(tolerances, static_cast<std::uint64_t>(s));
    LinearP95 result{std::vector<float>(static_cast<std::size_t>(linear.rows()), 0), 0};
    WorkerPool pool(0);
    const int blocks = static_cast<int>((linear.rows() + blockOfVertices - 1) / blockOfVertices);
    Eigen::ArrayXXd squares = Eigen::ArrayXXd::Zero(linearBatches, std::max(blocks, 1)); // of P95 of each batch
    pool.forTasks(blocks, [&](int b) {
        if (stop.stop_requested())
            return;
        const Eigen::Index begin = static_cast<Eigen::Index>(b) * blockOfVertices;
        const Eigen::Index rows = std::min<Eigen::Index>(blockOfVertices, linear.rows() - begin);
        const Eigen::MatrixXf outside = (linear.middleRows(begin, rows) * spreads).cwiseAbs();
        std::vector<float> sizes(static_cast<std::size_t>(samples));
        for (Eigen::Index r = 0; r < rows; ++r) {
            for (int s = 0; s < samples; ++s)
                sizes[static_cast<std::size_t>(s)] = outside(r, s);
            for (int batch = 0; batch < linearBatches; ++batch) {
                std::vector<float> some(sizes.begin() + batch * samples / linearBatches,
                                        sizes.begin() + (batch + 1) * samples / linearBatches);
                squares(batch, b) += std::pow(static_cast<double>(percentile95(some)), 2);
            }
            result.map[static_cast<std::size_t>(begin + r)] = percentile95(sizes);
        }
    });
    const Eigen::ArrayXd rms =
        (squares.rowwise().sum() / static_cast<double>(std::max<Eigen::Index>(linear.rows(), 1))).sqrt();
    result.rmsError = studentOf(linearBatches - 1) *
                      std::sqrt((rms - rms.mean()).square().sum() / (linearBatches - 1) / linearBatches);
    return result;
}

std::vector<float> solvedP95(const std::vector<const SweepSample*>& samples)
{
    std::vector<float> result;
    std::size_t vertices = 0;
    for (const SweepSample* sample : samples)
        vertices = std::max(vertices, sample->outside.size());
    std::vector<float> sizes;
    for (std::size_t v = 0; v < vertices; ++v) {
        sizes.clear();
        for (const SweepSample* sample : samples)
            if (sample->outside.size() == vertices)
                sizes.push_back(std::abs(sample->outside[v]));
        result.push_back(percentile95(sizes));
    }
    return result;
}

CorrectedP95 correctedP95(const LinearP95& linearP95, const Eigen::MatrixXf& linear, const Tolerances& tolerances,
                          const std::vector<const SweepSample*>& solved)
{
    std::vector<SolvedPiece> pieces;
    std::vector<SweepSample> reckoned;
    reckoned.reserve(solved.size());
    for (const SweepSample* sample : solved)
        if (sample->outside.size() == linearP95.map.size())
            pieces.push_back({sample, &reckoned.emplace_back(linearSample(linear, tolerances, sample->number))});
    CorrectedP95 result{corrected(linearP95.map, pieces), std::nullopt};
    if (pieces.size() < fewestToTell)
        return result;
    std::mt19937 dice(1); // the same pieces shall say the same
    double squares = 0;
    for (int k = 0; k < halvings; ++k) {
        shuffle(pieces, dice);
        const auto middle = pieces.begin() + std::ssize(pieces) / 2;
        const double apart = rmsOf(corrected(linearP95.map, {pieces.begin(), middle})) -
                             rmsOf(corrected(linearP95.map, {middle, pieces.end()}));
        squares += apart * apart / halvings;
    }
    // Of a difference the variance is that of both halves, which is twice that of all of them where they are many;
    // of few, what 95 % do not exceed hardly becomes surer.
    const auto count = static_cast<double>(pieces.size());
    const double ofAll = squares / (4 - 2 * std::min(1.0, fewToTell / count));
    result.rmsError = std::hypot(studentOf(count / 2 - 1) * std::sqrt(ofAll), linearP95.rmsError);
    return result;
}

std::array<double, 2> shareOfMany(int count, int all)
{
    constexpr double z = 1.96; // of the normal distribution, for 95 %
    const double n = all, share = count / n, middle = (share + z * z / 2 / n) / (1 + z * z / n),
                 half = z / (1 + z * z / n) * std::sqrt(share * (1 - share) / n + z * z / 4 / n / n);
    return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

double rmsOf(const std::vector<float>& map)
{
    double squares = 0;
    for (const float value : map)
        squares += static_cast<double>(value) * value;
    return map.empty() ? 0 : std::sqrt(squares / static_cast<double>(map.size()));
}

std::vector<double> influences(const Eigen::MatrixXf& linear, const Tolerances& tolerances,
                               const std::vector<double>& areasOfVertices)
{
    const Eigen::Map<const Eigen::VectorXd> areas(areasOfVertices.data(), std::ssize(areasOfVertices));
    std::vector<double> shares;
    double all = 0;
    for (std::size_t k = 0; k < tolerances.all.size(); ++k) {
        shares.push_back(areas.dot(
            linear.middleCols<2>(static_cast<Eigen::Index>(2 * k)).cast<double>().cwiseAbs2().rowwise().sum()));
        all += shares.back();
    }
    for (double& share : shares)
        share = all > 0 ? share / all : 0;
    return shares;
}

} // namespace bolster
