#include "LocalStep.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

using Matrix32 = Eigen::Matrix<double, 3, 2>;

/// The rotation closest to a map of the plane into space. The plane has two directions only, so the polar factor
/// has a closed form and reflections cannot occur. False when the map is degenerate.
bool closestRotation(const Matrix32& map, Eigen::Matrix3d& rotation)
{
    const Eigen::Vector3d normal = map.col(0).cross(map.col(1));
    const double doubleArea = normal.norm(); // sqrt(det(map^T map))
    Eigen::Matrix2d root = map.transpose() * map;
    root.diagonal().array() += doubleArea; // sqrt(trace + 2 doubleArea) times the square root of map^T map
    const double determinant = root.determinant();
    if (!(determinant > 0) || !(doubleArea > 0))
        return false;
    const double scale = std::sqrt(root.trace());
    Eigen::Matrix2d inverse;
    inverse << root(1, 1), -root(0, 1), -root(1, 0), root(0, 0);
    rotation.leftCols<2>() = map * (inverse * (scale / determinant));
    rotation.col(2) = normal / doubleArea;
    return true;
}

/// The quaternion of a rotation, in the hemisphere of the previous one. K + I = 4 q q^T has the quaternion as its
/// only eigenvector of non-zero value, so one multiplication finds it with the right sign.
Eigen::Vector4d quaternionNear(const Eigen::Matrix3d& r, const Eigen::Vector4d& previous)
{
    const double wx = r(2, 1) - r(1, 2), wy = r(0, 2) - r(2, 0), wz = r(1, 0) - r(0, 1);
    const double xy = r(1, 0) + r(0, 1), xz = r(2, 0) + r(0, 2), yz = r(2, 1) + r(1, 2);
    Eigen::Matrix4d kPlusOne;
    kPlusOne << 1 + r(0, 0) + r(1, 1) + r(2, 2), wx, wy, wz, //
        wx, 1 + r(0, 0) - r(1, 1) - r(2, 2), xy, xz,         //
        wy, xy, 1 - r(0, 0) + r(1, 1) - r(2, 2), yz,         //
        wz, xz, yz, 1 - r(0, 0) - r(1, 1) + r(2, 2);
    const Eigen::Vector4d q = kPlusOne * previous;
    if (const double norm = q.norm(); norm > 1e-6)
        return q / norm;
    // A half turn away from the previous frame: any column that does not vanish.
    Eigen::Index largest = 0;
    kPlusOne.diagonal().maxCoeff(&largest);
    return kPlusOne.col(largest).normalized();
}

/// T = I - nu (tr(eps) I - eps): elastic forces then are eps + nu cof(eps), as in plane stress.
Eigen::Matrix2d preferredStretch(const Matrix32& gradient, const Eigen::Matrix3d& rotation, double poisson)
{
    const Eigen::Matrix2d inPlane = rotation.leftCols<2>().transpose() * gradient;
    const double xx = std::clamp(inPlane(0, 0) - 1, -largestAnsweredStrain, largestAnsweredStrain);
    const double yy = std::clamp(inPlane(1, 1) - 1, -largestAnsweredStrain, largestAnsweredStrain);
    const double xy =
        std::clamp(0.5 * (inPlane(0, 1) + inPlane(1, 0)), -largestAnsweredStrain, largestAnsweredStrain);
    Eigen::Matrix2d stretch;
    stretch << 1 - poisson * yy, poisson * xy, poisson * xy, 1 - poisson * xx;
    return stretch;
}

} // namespace

LocalFit fitVertex(const Matrix32& covariance, const Eigen::Matrix2d& rest, double area,
                   const Eigen::Vector4d& previousFrame, double poisson)
{
    const Eigen::Matrix3d previous = rotationOf(previousFrame);
    const double pull = ringRegularisation * area;
    const Matrix32 regular = covariance + pull * previous.leftCols<2>();
    Eigen::Matrix3d rotation;
    if (!closestRotation(regular, rotation))
        return {previousFrame, Eigen::Matrix2d::Identity()};
    LocalFit fit;
    fit.frame = quaternionNear(rotation, previousFrame);
    const Eigen::Matrix2d regularRest = rest + pull * Eigen::Matrix2d::Identity();
    fit.stretch = preferredStretch(regular * regularRest.inverse(), rotation, poisson);
    return fit;
}

} // namespace bolster
