#include "CauseEvidence.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr int signRounds = 4;
constexpr double mostDeviations = 6; // standard ones, of a number
constexpr int noiseRounds = 6;
constexpr double leastFreePlaces = 0.25;   // of them: so much noise is seen at least
constexpr Eigen::Index columnsAtOnce = 32; // between two looks at whether it is to stop

/// What one standard deviation does on the side where a number is: so much of the column upwards, and of that
/// downwards.
struct Sides {
    Eigen::VectorXd up, down;

    explicit Sides(const Eigen::VectorXd& numbers)
        : up(numbers.size())
        , down(numbers.size())
    {
        for (Eigen::Index k = 0; k < numbers.size(); ++k) {
            up[k] = numbers[k] > 0 ? 1 : numbers[k] < 0 ? 0 : 0.5;
            down[k] = up[k] - 1;
        }
    }
};

} // namespace

CauseEvidence::CauseEvidence(CauseColumns columns, double places, double leastNoise, const std::stop_token& stop)
    : m_columns(std::move(columns))
{
    multiply(stop);
    m_noise = std::max(leastNoise, std::sqrt(m_columns.field.squaredNorm() / places));
    const Eigen::Index all = m_columns.up.cols();
    for (int round = 0; round < noiseRounds && !stop.stop_requested(); ++round) {
        const CauseFit fit = fitOf(0, all);
        const double known =
            static_cast<double>(all) - fit.covariance.trace(); // as many numbers as the field fixes
        const double free = std::max(places - known, leastFreePlaces * places);
        m_noise = std::max(leastNoise, std::sqrt((m_columns.field - fit.reached).squaredNorm() / free));
    }
}

CauseFit CauseEvidence::fit(int cause) const
{
    const Eigen::Index first = m_columns.first[cause];
    CauseFit fit = fitOf(first, m_columns.first[cause + 1] - first);
    if (const Eigen::VectorXd numbers = plausible(fit.numbers); numbers != fit.numbers) {
        fit.numbers = numbers;
        fit.reached = columnsAt(first, numbers) * numbers;
        fit.evidence = evidence(fit, numbers, m_columns.field - fit.reached);
    }
    return fit;
}

Eigen::VectorXd CauseEvidence::plausible(const Eigen::VectorXd& numbers)
{
    return numbers.cwiseMax(-mostDeviations).cwiseMin(mostDeviations);
}

/// Once: fits differ only in which sides they take, and by the noise.
void CauseEvidence::multiply(const std::stop_token& stop)
{
    const Eigen::MatrixXd &up = m_columns.up, &down = m_columns.down;
    const Eigen::Index all = up.cols();
    for (Eigen::MatrixXd* product : {&m_upUp, &m_upDown, &m_downDown})
        product->setZero(all, all);
    for (Eigen::Index first = 0; first < all && !stop.stop_requested(); first += columnsAtOnce) {
        const Eigen::Index count = std::min(columnsAtOnce, all - first);
        m_upUp.middleCols(first, count).noalias() = up.transpose() * up.middleCols(first, count);
        m_upDown.middleCols(first, count).noalias() = up.transpose() * down.middleCols(first, count);
        m_downDown.middleCols(first, count).noalias() = down.transpose() * down.middleCols(first, count);
    }
    m_upField = up.transpose() * m_columns.field;
    m_downField = down.transpose() * m_columns.field;
}

Eigen::MatrixXd CauseEvidence::columnsAt(Eigen::Index first, const Eigen::VectorXd& numbers) const
{
    const Sides sides(numbers);
    return m_columns.up.middleCols(first, numbers.size()) * sides.up.asDiagonal() +
           m_columns.down.middleCols(first, numbers.size()) * sides.down.asDiagonal();
}

CauseFit CauseEvidence::fitOf(Eigen::Index first, Eigen::Index count) const
{
    CauseFit fit;
    fit.numbers = Eigen::VectorXd::Zero(count);
    const double precision = 1 / (m_noise * m_noise);
    const auto block = [&](const Eigen::MatrixXd& products) { return products.block(first, first, count, count); };
    for (int round = 0; round < signRounds; ++round) {
        const Sides sides(fit.numbers);
        const Eigen::MatrixXd mixed = sides.up.asDiagonal() * block(m_upDown) * sides.down.asDiagonal();
        Eigen::MatrixXd system = sides.up.asDiagonal() * block(m_upUp) * sides.up.asDiagonal();
        system += sides.down.asDiagonal() * block(m_downDown) * sides.down.asDiagonal();
        system += mixed + mixed.transpose();
        system *= precision;
        system.diagonal().array() += 1;
        const Eigen::VectorXd pull = precision * (sides.up.cwiseProduct(m_upField.segment(first, count)) +
                                                  sides.down.cwiseProduct(m_downField.segment(first, count)));
        const Eigen::LLT<Eigen::MatrixXd> factor(system);
        fit.numbers = factor.solve(pull);
        fit.volume = factor.matrixLLT().diagonal().array().log().sum();
        fit.evidence = pull.dot(fit.numbers) / 2 - fit.volume;
        if (round + 1 < signRounds)
            continue;
        fit.covariance = factor.solve(Eigen::MatrixXd::Identity(count, count));
        fit.reached = m_columns.up.middleCols(first, count) * sides.up.cwiseProduct(fit.numbers) +
                      m_columns.down.middleCols(first, count) * sides.down.cwiseProduct(fit.numbers);
    }
    return fit;
}

double CauseEvidence::evidence(const CauseFit& fit, const Eigen::VectorXd& numbers,
                               const Eigen::VectorXd& remains) const
{
    const double explained = m_columns.field.squaredNorm() - remains.squaredNorm();
    return (explained / (m_noise * m_noise) - numbers.squaredNorm()) / 2 - fit.volume;
}

Eigen::VectorXd CauseEvidence::step(int cause, const CauseFit& fit, const Eigen::VectorXd& numbers,
                                    const Eigen::VectorXd& remains) const
{
    const Eigen::MatrixXd columns = columnsAt(m_columns.first[cause], numbers);
    return fit.covariance * (columns.transpose() * remains / (m_noise * m_noise) - numbers);
}

Eigen::VectorXd CauseEvidence::likeness(int cause, const Eigen::MatrixXd& fields) const
{
    const Eigen::Index first = m_columns.first[cause];
    const Eigen::MatrixXd columns = columnsAt(first, Eigen::VectorXd::Zero(m_columns.first[cause + 1] - first));
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(fields.cols());
    if (!(columns.norm() > 0))
        return none;
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor(columns);
    const Eigen::MatrixXd basis = factor.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), factor.rank());
    const Eigen::VectorXd sizes = fields.colwise().norm();
    const Eigen::VectorXd within = (basis.transpose() * fields).colwise().norm();
    return (sizes.array() > 0).select(within.cwiseQuotient(sizes), none);
}

} // namespace bolster
