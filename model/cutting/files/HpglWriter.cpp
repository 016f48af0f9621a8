#include "HpglWriter.h"

#include "CutTable.h"
#include "CutText.h"

#include <numbers>

namespace bolster {

namespace {

constexpr double stepsPerMm = 40;
constexpr int cuttingPen = 1, drawingPen = 2;

class Plot {
public:
    explicit Plot(const TablePiece& place)
        : m_place(place)
    {}

    void line(const std::vector<Vec2>& points, bool closed)
    {
        if (points.size() < 2)
            return;
        m_text += "PU" + steps(points.front()) + ";PD";
        for (std::size_t i = 1; i < points.size(); ++i)
            m_text.append(i > 1 ? "," : "").append(steps(points[i]));
        if (closed)
            m_text += "," + steps(points.front());
        m_text += ";\n";
    }
    void line(const std::vector<LinePoint>& line, bool closed)
    {
        std::vector<Vec2> points;
        for (const LinePoint& point : line)
            points.push_back(point.at);
        this->line(points, closed);
    }
    void pen(int number) { m_text += "SP" + std::to_string(number) + ";\n"; }
    void dashed(bool on) { m_text += on ? "LT2,2;\n" : "LT;\n"; }
    void circle(const Vec2& at, double radius)
    {
        m_text += "PU" + steps(at) + ";CI" + std::to_string(std::lround(radius * stepsPerMm)) + ";\n";
    }
    void label(const PieceLabel& label)
    {
        const double angle = label.rotation * std::numbers::pi / 180 + m_place.angle;
        m_text += "DI" + decimal(std::cos(angle)) + "," + decimal(std::sin(angle)) + ";SI" +
                  decimal(0.045 * label.height) + "," + decimal(0.06 * label.height) + ";\n"; // cm
        const Eigen::Rotation2Dd turn(label.rotation * std::numbers::pi / 180);
        double down = static_cast<double>(label.lines.size()) / 2 - 0.8;
        for (const std::string& line : label.lines) {
            m_text += "PU" + steps(label.at + turn * Vec2(-label.width / 2, down * label.height)) + ";LB" +
                      ascii(line) + "\x03\n";
            down -= 1;
        }
    }

    std::string result() { return std::move(m_text); }

private:
    std::string steps(const Vec2& point) const
    {
        const Vec2 at = m_place.at(point) * stepsPerMm;
        return std::to_string(std::lround(at.x())) + "," + std::to_string(std::lround(at.y()));
    }

    const TablePiece& m_place;
    std::string m_text;
};

} // namespace

std::string hpglText(const CutPattern& pattern, const CutLayers& layers, double width)
{
    std::string text = "IN;\n";
    for (const TablePiece& place : arranged(pattern, width).pieces) {
        const CutPiece& piece = pattern.pieces[place.piece];
        Plot plot(place);
        plot.pen(drawingPen);
        if (layers.labels)
            plot.label(piece.label);
        if (layers.grain)
            for (const std::vector<Vec2>& line : grainLines(piece.grain))
                plot.line(line, false);
        if (layers.holes)
            for (const CutHole& hole : piece.holes)
                plot.circle(hole.at, hole.diameter / 2);
        plot.dashed(true);
        if (layers.internal)
            for (const PieceLine& line : piece.inner)
                if (!line.cut)
                    plot.line(line.points, line.closed);
        if (layers.sew)
            plot.line(piece.sew, true);
        plot.dashed(false);
        plot.pen(cuttingPen);
        if (layers.internal)
            for (const PieceLine& line : piece.inner)
                if (line.cut)
                    plot.line(line.points, line.closed);
        if (layers.notches)
            for (const CutNotch& notch : piece.notches)
                for (const std::vector<Vec2>& line : notchLines(notch))
                    plot.line(line, false);
        if (layers.cut)
            plot.line(piece.cut, true);
        text += plot.result();
    }
    return text + "PU0,0;SP0;\n";
}

} // namespace bolster
