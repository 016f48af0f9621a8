#include "CauseEvidence.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr int signRounds = 4;
constexpr int noiseRounds = 6;
constexpr double leastFreePlaces = 0.25; // of them: so much noise is seen at least

} // namespace

CauseEvidence::CauseEvidence(CauseColumns columns, double places, double leastNoise)
    : m_columns(std::move(columns))
{
    m_noise = std::max(leastNoise, std::sqrt(m_columns.field.squaredNorm() / places));
    const Eigen::Index all = m_columns.up.cols();
    for (int round = 0; round < noiseRounds; ++round) {
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
    return fitOf(first, m_columns.first[cause + 1] - first);
}

/// What one standard deviation does on the side where the numbers are.
Eigen::MatrixXd CauseEvidence::columnsAt(Eigen::Index first, const Eigen::VectorXd& numbers) const
{
    Eigen::MatrixXd columns(m_columns.field.size(), numbers.size());
    for (Eigen::Index k = 0; k < numbers.size(); ++k) {
        const auto up = m_columns.up.col(first + k), down = m_columns.down.col(first + k);
        if (numbers[k] == 0)
            columns.col(k) = (up - down) / 2;
        else
            columns.col(k) = numbers[k] > 0 ? Eigen::VectorXd(up) : Eigen::VectorXd(-down);
    }
    return columns;
}

CauseFit CauseEvidence::fitOf(Eigen::Index first, Eigen::Index count) const
{
    CauseFit fit;
    fit.numbers = Eigen::VectorXd::Zero(count);
    const double precision = 1 / (m_noise * m_noise);
    for (int round = 0; round < signRounds; ++round) {
        const Eigen::MatrixXd columns = columnsAt(first, fit.numbers);
        const Eigen::MatrixXd system =
            precision * columns.transpose() * columns + Eigen::MatrixXd::Identity(count, count);
        const Eigen::VectorXd pull = precision * columns.transpose() * m_columns.field;
        const Eigen::LLT<Eigen::MatrixXd> factor(system);
        fit.numbers = factor.solve(pull);
        fit.covariance = factor.solve(Eigen::MatrixXd::Identity(count, count));
        fit.reached = columns * fit.numbers;
        fit.volume = factor.matrixLLT().diagonal().array().log().sum();
        fit.evidence = pull.dot(fit.numbers) / 2 - fit.volume;
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

double CauseEvidence::likeness(int cause, const Eigen::VectorXd& field) const
{
    const Eigen::Index first = m_columns.first[cause];
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(m_columns.first[cause + 1] - first);
    const Eigen::MatrixXd columns = columnsAt(first, none);
    const double size = field.norm();
    if (!(size > 0) || !(columns.norm() > 0))
        return 0;
    return (columns * columns.colPivHouseholderQr().solve(field)).norm() / size;
}

} // namespace bolster
