// Linear Bayes: which of a few sets of columns explains a field best.
#pragma once

#include <Eigen/Core>

#include <stop_token>
#include <vector>

namespace bolster {

/// A field, and what each number does to it: for one standard deviation of it upwards and downwards. Rows are
/// scaled so that the noise of all is alike and their squares count independent places.
struct CauseColumns {
    Eigen::VectorXd field;
    Eigen::MatrixXd up, down;        ///< `down` is near -`up`
    std::vector<Eigen::Index> first; ///< of each cause's columns, and one more: their end

    int causes() const { return static_cast<int>(first.size()) - 1; }
};

struct CauseFit {
    Eigen::VectorXd numbers;    ///< likeliest, in standard deviations beforehand
    Eigen::MatrixXd covariance; ///< of them afterwards
    Eigen::VectorXd reached;    ///< the part of the field that they explain
    double volume = 0;          ///< logarithm: by how much knowing narrows them down, which counts against a cause
    double evidence = 0;        ///< logarithm, against none
};

class CauseEvidence {
public:
    /// `places`: how many independent ones the rows stand for. Takes the noise from what all columns leave.
    /// Who stops it has one whose noise means nothing.
    CauseEvidence(CauseColumns columns, double places, double leastNoise, const std::stop_token& stop = {});

    double noise() const { return m_noise; }
    const CauseColumns& columns() const { return m_columns; }
    /// No number is larger than is plausible.
    CauseFit fit(int cause) const;
    /// Numbers with at most six standard deviations: three times what is expected at most.
    static Eigen::VectorXd plausible(const Eigen::VectorXd& numbers);
    /// Of numbers that are known to reach only so far: with covers, instead of columns.
    double evidence(const CauseFit& fit, const Eigen::VectorXd& numbers, const Eigen::VectorXd& remains) const;
    /// Where the numbers should go when so much remains of the field.
    Eigen::VectorXd step(int cause, const CauseFit& fit, const Eigen::VectorXd& numbers,
                         const Eigen::VectorXd& remains) const;
    /// How much of each field (columns) the columns of a cause can be, 0 to 1: the cosine of the angle between
    /// them.
    Eigen::VectorXd likeness(int cause, const Eigen::MatrixXd& fields) const;

private:
    Eigen::MatrixXd columnsAt(Eigen::Index first, const Eigen::VectorXd& numbers) const;
    void multiply(const std::stop_token& stop);
    CauseFit fitOf(Eigen::Index first, Eigen::Index count) const;

    CauseColumns m_columns;
    Eigen::MatrixXd m_upUp, m_upDown, m_downDown; ///< products of all columns with each other ...
    Eigen::VectorXd m_upField, m_downField;       ///< ... and with the field
    double m_noise = 1;
};

} // namespace bolster
