#include "DrawField.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double sectionSpacing = 50; // mm
constexpr double arrowSpacing = 25;
constexpr int finest = 120; // cells along the longest side of a section

/// A plane of points across an axis, `step` apart.
class Section {
public:
    Section(const ForceField& field, int axis, double place)
        : m_field(field)
        , m_axis(axis)
    {
        const VoxelGrid& grid = field.grid();
        const int longest = *std::max_element(grid.size.begin(), grid.size.end());
        m_step = grid.edge * std::max(1, (longest + finest - 1) / finest);
        m_origin[axis] = place;
        for (int k = 0; k < 2; ++k) {
            const int side = (axis + 1 + k) % 3;
            m_origin[side] = grid.edge * (grid.low[side] + 0.5);
            m_count[k] = static_cast<int>(grid.edge * (grid.size[side] - 1) / m_step) + 1;
        }
    }

    /// Where the depth passes a quarter of a voxel: marching squares.
    void addContours(std::vector<FieldPicture::Segment>& contours) const
    {
        std::vector<double> levels;
        for (int j = 0; j < m_count[1]; ++j)
            for (int i = 0; i < m_count[0]; ++i)
                levels.push_back(m_field.at(at(i, j), {}).depth - 0.25 * m_field.grid().edge);
        const auto level = [&](int i, int j) { return levels[static_cast<std::size_t>(j) * m_count[0] + i]; };
        for (int j = 0; j + 1 < m_count[1]; ++j)
            for (int i = 0; i + 1 < m_count[0]; ++i) {
                const std::array<Vec2, 4> corners = {Vec2(i, j), Vec2(i + 1, j), Vec2(i + 1, j + 1),
                                                     Vec2(i, j + 1)};
                std::vector<Eigen::Vector3f> crossings;
                for (int k = 0; k < 4; ++k) {
                    const Vec2 &a = corners[k], &b = corners[(k + 1) % 4];
                    const double la = level(int(a.x()), int(a.y())), lb = level(int(b.x()), int(b.y()));
                    if ((la > 0) == (lb > 0))
                        continue;
                    const Vec2 p = a + la / (la - lb) * (b - a);
                    crossings.push_back(at(p.x(), p.y()).cast<float>());
                }
                for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
                    contours.push_back({crossings[k], crossings[k + 1]});
            }
    }

    void addArrows(std::vector<FieldPicture::Segment>& arrows) const
    {
        const double stride = std::max(1.0, std::round(arrowSpacing / m_step));
        for (double j = 0; j < m_count[1]; j += stride)
            for (double i = 0; i < m_count[0]; i += stride) {
                const Vec3 from = at(i, j);
                const ForceField::Push push = m_field.at(from, {});
                if (push.force.norm() > 1)
                    arrows.push_back({from.cast<float>(), (from + 0.5 * push.force).cast<float>()});
            }
    }

private:
    Vec3 at(double i, double j) const
    {
        Vec3 p = m_origin;
        p[(m_axis + 1) % 3] += i * m_step;
        p[(m_axis + 2) % 3] += j * m_step;
        return p;
    }

    const ForceField& m_field;
    int m_axis;
    double m_step = 1;
    Vec3 m_origin = Vec3::Zero();
    std::array<int, 2> m_count{};
};

} // namespace

FieldPicture drawField(const ForceField& field)
{
    FieldPicture picture;
    const VoxelGrid& grid = field.grid();
    for (const int axis : {0, 2}) {
        const double low = grid.edge * grid.low[axis], high = low + grid.edge * grid.size[axis];
        const double middle = 0.5 * (low + high);
        const int around = static_cast<int>((high - low) / 2 / sectionSpacing);
        for (int k = -around; k <= around; ++k)
            Section(field, axis, middle + k * sectionSpacing).addContours(picture.contours);
        if (axis == 0)
            Section(field, axis, middle).addArrows(picture.arrows);
    }
    return picture;
}

} // namespace bolster
