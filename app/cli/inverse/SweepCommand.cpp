#include "DesignJson.h"
#include "DistinctFiles.h"
#include "FitTargetFiles.h"
#include "Interrupt.h"
#include "JobShare.h"
#include "Output.h"
#include "ProgressLine.h"
#include "Slurm.h"
#include "Solving.h"
#include "Subcommands.h"
#include "SweepFiles.h"
#include "VertexAreas.h"
#include "WholeFile.h"

#include <QFile>
#include <QFileInfo>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace bolster::cli {

const char* const sweepHelp = R"(Usage: bolster sweep DESIGN --spec FILE --samples N --out DIR [options]

Draws tolerances of making at random and says where the cover varies, which
tolerance matters, and how many pieces are out of limits. First as if covers
were linear, then by solving N of them.

Options:
  --spec FILE.json      what varies and by how much, and the limits (see the manual)
  --samples N           covers to solve; 0: only the linear figures
  --out DIR             a folder of its own; a sweep that was ended goes on there, as
                        does one with more samples or other limits
  --linear N            samples of the linear figures (10000)
  --threads N           use N threads (0: as many as the machine has)
  --part I/N            solves only every Nth portion of samples, from the Ith (0 to
                        N-1) on, and writes no figures: for several machines
  --slurm               lets jobs of Slurm solve them, waits, and writes the figures
  --jobs N              jobs of an array (4)
  --sbatch WORDS        more options for sbatch, with blanks between them

Files: report.json, samples.csv, p95.ply (what 95 % of the samples do not exceed, mm,
at each vertex), parts/.

Exit code:
  0  done
  1  a file cannot be written, no cover, or interrupted
  2  the design or FILE cannot be used, or wrong usage
)";

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array sweepRules = {
    OptionRule{"--spec", true},   OptionRule{"--samples", true}, OptionRule{"--out", true},
    OptionRule{"--linear", true}, OptionRule{"--threads", true}, OptionRule{"--part", true},
    OptionRule{"--slurm", false}, OptionRule{"--jobs", true},    OptionRule{"--sbatch", true}};

/// Solves what is missing of a share. Returns what went wrong.
std::string solveMissing(Sweep& sweep, const SweepFolder& folder, const JobShare& share,
                         const std::stop_token& stop)
{
    ProgressLine line("looking for what is there");
    const std::size_t vertices = sweep.nominal()->positions.size();
    for (int part = share.which; part < folder.parts(); part += share.of) {
        if (stop.stop_requested())
            return "interrupted";
        if (folder.has(part, vertices))
            continue;
        line.say("part " + std::to_string(part + 1) + " of " + std::to_string(folder.parts()));
        const std::vector<SweepSample> samples = sweep.solve(folder.firstOf(part), folder.countOf(part), stop);
        if (stop.stop_requested())
            return "interrupted";
        if (const Message problem = folder.write(part, samples); !problem.empty())
            return problem.english();
    }
    return {};
}

struct MapFigures {
    double rms = 0, p95 = 0, most = 0;
};

MapFigures figuresOf(std::vector<float> map)
{
    MapFigures figures;
    if (map.empty())
        return figures;
    figures.rms = rmsOf(map);
    std::ranges::sort(map);
    figures.p95 = map[static_cast<std::size_t>(0.95 * static_cast<double>(map.size() - 1))];
    figures.most = map.back();
    return figures;
}

Json asJson(const MapFigures& figures)
{
    return {{"rms_mm", figures.rms}, {"p95_mm", figures.p95}, {"max_mm", figures.most}};
}

/// What 95 % of the pieces do not exceed at each vertex, mm. Where nothing is solved the last one is empty.
struct Maps {
    std::vector<float> linear, corrected, solved;
};

std::string plyOf(const SurfaceMesh& surface, const Maps& maps)
{
    std::string text = "ply\nformat ascii 1.0\ncomment mm, z up; what 95 % of the samples do not exceed, in mm\n";
    text += "element vertex " + std::to_string(surface.positions.size()) +
            "\nproperty float x\nproperty float y\nproperty float z\nproperty float linear_p95\n";
    text += maps.solved.empty() ? "" : "property float corrected_p95\nproperty float p95\n";
    text += "element face " + std::to_string(surface.topology->triangles.size()) +
            "\nproperty list uchar int vertex_indices\nend_header\n";
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        for (int axis = 0; axis < 3; ++axis)
            text += numberText(surface.positions[v][axis], 7) + " ";
        text += numberText(maps.linear[v], 4);
        if (!maps.solved.empty())
            text.append(" ")
                .append(numberText(maps.corrected[v], 4))
                .append(" ")
                .append(numberText(maps.solved[v], 4));
        text += "\n";
    }
    for (const auto& t : surface.topology->triangles)
        text.append("3 ")
            .append(std::to_string(t[0]))
            .append(" ")
            .append(std::to_string(t[1]))
            .append(" ")
            .append(std::to_string(t[2]))
            .append("\n");
    return text;
}

bool isOut(const SweepSample& sample, const SweepSpec& spec)
{
    return (spec.limitDistance && sample.p95 > *spec.limitDistance) ||
           (spec.limitStrain && sample.strain > *spec.limitStrain);
}

/// In the folder of a sweep, in which nobody has laid links for it.
Message replaceOwnFile(const QString& path, const std::string& text)
{
    if (QFileInfo(path).isSymLink())
        QFile::remove(path);
    return replaceWholeFile(path, text);
}

class Figures {
public:
    Figures(Sweep& sweep, const SweepSpec& spec, int linearSamples, const std::stop_token& stop)
        : m_sweep(sweep)
        , m_spec(spec)
        , m_count(linearSamples)
        , m_stop(stop)
    {
        ProgressLine line("derivatives");
        m_linear = sweep.linear(
            [&](double share) { line.say("derivatives, " + numberText(std::floor(100 * share), 3) + " %"); }, stop);
        line.say("linear samples");
        m_linearP95 = linearP95(m_linear, spec.tolerances, linearSamples, stop);
        m_maps.linear = m_linearP95.map;
    }

    /// Returns what went wrong.
    std::string write(const SweepFolder& folder, int samples)
    {
        const std::size_t vertices = m_sweep.nominal()->positions.size();
        std::vector<SweepSample> solved;
        for (int part = 0; part < folder.parts(); ++part)
            for (SweepSample& sample : folder.read(part, vertices))
                solved.push_back(std::move(sample));
        std::vector<const SweepSample*> resting;
        for (const SweepSample& sample : solved)
            if (!sample.outside.empty())
                resting.push_back(&sample);
        m_maps.solved = solvedP95(resting);
        CorrectedP95 corrected = correctedP95(m_linearP95, m_linear, m_spec.tolerances, resting);
        m_maps.corrected = std::move(corrected.map);
        m_rmsError = corrected.rmsError;
        if (std::ssize(solved) != samples)
            return "samples are missing";
        if (m_sweep.unknown().size() == m_spec.tolerances.all.size() && resting.empty())
            return "with none of these tolerances a cover is found: make them smaller";
        for (const auto& [name, text] :
             {std::pair("report.json", report(solved, resting).dump(1) + "\n"),
              std::pair("samples.csv", csvOf(solved)), std::pair("p95.ply", plyOf(*m_sweep.nominal(), m_maps))})
            if (const Message problem = replaceOwnFile(folder.file(name), text); !problem.empty())
                return problem.english();
        if (!solved.empty() && resting.empty())
            return "not one of the samples has a cover at rest: make the tolerances smaller";
        return {};
    }

private:
    Json report(const std::vector<SweepSample>& solved, const std::vector<const SweepSample*>& resting)
    {
        const MapFigures linear = figuresOf(m_maps.linear), found = figuresOf(m_maps.solved),
                         corrected = figuresOf(m_maps.corrected);
        const bool knowsLinear = m_sweep.unknown().size() < m_spec.tolerances.all.size();
        Json report{{"linear", {{"samples", m_count}, {"p95", knowsLinear ? asJson(linear) : Json()}}}};
        if (knowsLinear)
            printResult("what 95 % of the samples do not exceed, place by place, as if covers were linear: " +
                        numberText(linear.rms, 3) + " mm (rms over the cover), " + numberText(linear.most, 3) +
                        " mm where it is most");
        Json unknown = Json::array();
        for (const std::size_t k : m_sweep.unknown())
            unknown.push_back(m_spec.tolerances.all[k].name);
        if (!unknown.empty()) {
            printError("warning: with " + counted(std::ssize(unknown), "tolerance") +
                       " no cover is found, such as " + unknown.front().get<std::string>() +
                       ": the linear figures leave them out. Make them smaller");
            report["linear"]["without_cover"] = std::move(unknown);
        }
        if (!solved.empty()) {
            const auto out = std::ranges::count_if(solved, [&](const SweepSample& s) { return isOut(s, m_spec); });
            const auto known = [&](const MapFigures& figures) {
                return resting.empty() ? Json() : asJson(figures);
            };
            report["corrected"] = {{"samples", resting.size()}, {"p95", known(corrected)}};
            if (m_rmsError)
                report["corrected"]["p95"]["rms_error_mm"] = *m_rmsError;
            report["solved"] = {{"samples", solved.size()},
                                {"without_cover", solved.size() - resting.size()},
                                {"out_of_limits", out},
                                {"p95", known(found)}};
            if (!resting.empty())
                report["solved"]["out_of_limits_of_many"] =
                    shareOfMany(static_cast<int>(out), static_cast<int>(resting.size()));
            if (resting.size() < solved.size())
                printError("warning: " + std::to_string(solved.size() - resting.size()) +
                           " samples have no cover at rest");
            if (!resting.empty())
                printSolved(resting.size(), out, found, corrected);
        }
        report["influence"] = knowsLinear ? influence() : Json::array();
        return report;
    }

    /// `count` of them rest.
    void printSolved(std::size_t count, std::ptrdiff_t out, const MapFigures& found,
                     const MapFigures& corrected) const
    {
        constexpr std::size_t few = 20; // the worst one is what 95 % do not exceed
        const std::string pieces = counted(static_cast<std::ptrdiff_t>(count), "solved piece");
        printResult((count < few ? "the worst of " : "by ") + pieces + " alone: " + numberText(found.rms, 3) +
                    " mm, " + numberText(found.most, 3) + " mm");
        printResult("by the linear ones, corrected by what the solved ones have more than the same in linear: " +
                    numberText(corrected.rms, 3) +
                    (m_rmsError ? " +-" + numberText(*m_rmsError, 2) : std::string()) + " mm, " +
                    numberText(corrected.most, 3) + " mm");
        if (m_spec.limitDistance || m_spec.limitStrain) {
            const auto [least, most] = shareOfMany(static_cast<int>(out), static_cast<int>(count));
            printResult(std::to_string(out) + " of " + pieces + " are out of limits; of many, " +
                        numberText(std::round(100 * least), 3) + " to " + numberText(std::round(100 * most), 3) +
                        " %");
        }
    }

    Json influence()
    {
        const std::vector<Tolerance>& all = m_spec.tolerances.all;
        const std::vector<double> shares = influences(
            m_linear, m_spec.tolerances, vertexAreas(*m_sweep.nominal()->topology, m_sweep.nominal()->positions));
        std::vector<std::size_t> order(all.size());
        std::iota(order.begin(), order.end(), 0);
        std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t k) { return shares[k]; });
        Json list = Json::array();
        for (std::size_t place = 0; place < order.size(); ++place) {
            const std::size_t k = order[place];
            list.push_back(
                {{"name", all[k].name},
                 {"share", shares[k]},
                 {"most_mm", m_linear.middleCols<2>(static_cast<Eigen::Index>(2 * k)).cwiseAbs().maxCoeff()}});
            if (place < 3)
                printResult(numberText(100 * shares[k], 3) + " % of the variance: " + all[k].name);
        }
        return list;
    }

    std::string csvOf(const std::vector<SweepSample>& solved) const
    {
        std::string text = "sample,rms_mm,p95_mm,max_mm,strain_p99,out\n";
        for (const SweepSample& sample : solved) {
            text += std::to_string(sample.number);
            for (const double value : {sample.rms, sample.p95, sample.most, sample.strain})
                text.append(",").append(sample.outside.empty() ? std::string() : numberText(value, 6));
            text += isOut(sample, m_spec) ? ",1\n" : ",0\n";
        }
        return text;
    }

    Sweep& m_sweep;
    const SweepSpec& m_spec;
    int m_count;
    std::stop_token m_stop;
    Eigen::MatrixXf m_linear;
    LinearP95 m_linearP95;
    Maps m_maps;
    std::optional<double> m_rmsError; ///< mm
};

/// What every job does.
SlurmOrder slurmOrder(const Arguments& arguments, const QString& design)
{
    SlurmOrder order = SlurmOrder::from(arguments, "sweep", arguments.path("--out"));
    order.command += design;
    for (const char* option : {"--spec", "--samples", "--out", "--threads"})
        if (arguments.has(option))
            order.command += {option, arguments.path(option)};
    return order;
}

} // namespace

int sweep(std::span<const std::string> words)
{
    const Arguments arguments(words, sweepRules);
    const QString path = arguments.onlyFile("DESIGN");
    if (arguments.path("--spec").isEmpty() || arguments.path("--out").isEmpty() || !arguments.has("--samples"))
        throw UsageError("--spec FILE, --samples N and --out DIR are needed");
    QStringList outputs;
    for (const char* name : {"report.json", "samples.csv", "p95.ply"})
        outputs << arguments.path("--out") + "/" + name;
    expectDistinct({path, arguments.path("--spec")}, outputs);
    const int samples = arguments.integer("--samples", 0, 0, 1'000'000);
    const int linear = arguments.integer("--linear", 10'000, 100, 1'000'000);
    const JobShare share = jobShare(arguments);
    if (const std::string problem = arguments.has("--slurm") ? whyNoSlurm() : ""; !problem.empty()) {
        printError("error: " + problem);
        return otherFailure;
    }
    Interrupt interrupt;
    const OpenedDesign opened = openedShown(path);
    if (printErrors(opened.problems))
        return badInput;
    sayOfPulls(opened.design);
    const SweepSpec spec = readSweepSpec(arguments.path("--spec"), opened.design);
    SweepFolder folder(arguments.path("--out"),
                       writeDesign(opened.design) + meshesAsText(opened.files) + spec.drawn, samples);
    const auto fail = [](const std::string& problem) {
        printError("error: " + problem);
        return otherFailure;
    };
    if (const Message problem = folder.open(); !problem.empty())
        return fail(problem.english());
    Sweep sweep({opened.design, opened.files}, spec.tolerances, arguments.integer("--threads", 0, 0, 1024),
                interrupt.token());
    if (!sweep.nominal())
        return fail(sweep.problem().empty() ? "interrupted" : sweep.problem().english());
    std::optional<Figures> figures;
    if (!arguments.has("--part"))
        figures.emplace(sweep, spec, linear, interrupt.token());
    std::string problem;
    if (arguments.has("--slurm")) {
        const std::size_t vertices = sweep.nominal()->positions.size();
        problem = runOnSlurm(
            slurmOrder(arguments, path),
            [&] {
                for (int part = 0; part < folder.parts(); ++part)
                    if (!folder.has(part, vertices))
                        return false;
                return true;
            },
            [](const std::string& line) { printResult(line); }, interrupt.token());
    } else {
        problem = solveMissing(sweep, folder, share, interrupt.token());
    }
    if (!problem.empty())
        return fail(problem);
    if (!figures) {
        printResult("portions " + std::to_string(share.which) + ", " + std::to_string(share.which + share.of) +
                    " ... of " + counted(folder.parts(), "portion") + " are solved, of " +
                    std::to_string(SweepFolder::samplesOfPart) +
                    " samples each. When all are: the same command without --part writes the figures");
        return done;
    }
    if (interrupt.token().stop_requested())
        return fail("interrupted");
    interrupt.beginWriting();
    problem = figures->write(folder, samples);
    return problem.empty() ? done : fail(problem);
}

} // namespace bolster::cli
