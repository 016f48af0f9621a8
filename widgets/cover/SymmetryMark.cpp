#include "SymmetryMark.h"

namespace bolster {

namespace {

constexpr int dashes = 24;

} // namespace

void addSymmetryPlane(const Symmetry& symmetry, ViewScene& scene)
{
    if (scene.box.isEmpty())
        return;
    const Symmetry usual;
    const Symmetry& used = symmetry.planeUsable() ? symmetry : usual;
    const Vec3 normal = used.planeNormal.normalized();
    const std::vector<Vec3> frame = planeFrame(scene.box, normal, normal.dot(used.planePoint));
    QColor color = scene.colors.accent;
    color.setAlphaF(0.7F);
    SceneLine border{{}, color, 1.4F, 0.3F};
    for (const Vec3& p : frame)
        border.points.push_back(p.cast<float>());
    scene.lines.push_back(std::move(border));
    const Vec3 from = (frame[0] + frame[1]) / 2, way = (frame[2] + frame[3]) / 2 - from;
    for (int i = 0; i < dashes; ++i) {
        const double length = i % 2 == 0 ? 0.75 : 0.2; // a long one, a short one
        const Vec3 a = from + way * i / dashes, b = a + way * length / dashes;
        scene.lines.push_back({{a.cast<float>(), b.cast<float>()}, color, 1.2F, 0.25F});
    }
}

} // namespace bolster
