#include "ReportJson.h"

#include <nlohmann/json.hpp>

#include <set>

namespace bolster::cli {
namespace {

using Json = nlohmann::ordered_json;

const char* statusWord(SolveResult::Status status)
{
    switch (status) {
    case SolveResult::Status::Solved:
        return "solved";
    case SolveResult::Status::NotConverged:
        return "not_converged";
    case SolveResult::Status::Failed:
    case SolveResult::Status::Cancelled:
        break;
    }
    return "failed";
}

Json json(const Problems& problems)
{
    std::set<ElementId> unnumbered; // in the file; inside the program they have numbers
    for (const Problem& problem : problems)
        if (problem.field == "id")
            unnumbered.insert(problem.element);
    Json list = Json::array();
    for (const Problem& problem : problems)
        list.push_back({{"element", unnumbered.contains(problem.element) ? Json() : Json(number(problem.element))},
                        {"label", problem.label},
                        {"field", problem.field},
                        {"message", problem.message.english()}});
    return list;
}

Json json(const SolveReport::MaxMean& value)
{
    return {{"max", value.max}, {"mean", value.mean}};
}

Json json(const std::vector<SolveReport::OfElement>& values, const char* key)
{
    Json list = Json::array();
    for (const SolveReport::OfElement& value : values)
        list.push_back({{"element", number(value.element)}, {key, value.value}});
    return list;
}

Json json(const std::vector<SolveReport::Cushion>& cushions)
{
    Json list = Json::array();
    for (const SolveReport::Cushion& cushion : cushions)
        list.push_back({{"element", number(cushion.element)},
                        {"voxels", cushion.voxels},
                        {"vertices", cushion.vertices},
                        {"push_mm", json(cushion.push)}});
    return list;
}

Json json(const std::vector<SolveReport::ScanFit>& scans)
{
    Json list = Json::array();
    for (const SolveReport::ScanFit& scan : scans) {
        const bool met = scan.figures.coverage > 0; // else there is nothing that these could be figures of
        const auto figure = [met](double value) { return met ? Json(value) : Json(); };
        list.push_back({{"element", number(scan.scan)},
                        {"name", scan.name},
                        {"points", scan.figures.points},
                        {"deviation_mm",
                         {{"rms", figure(scan.figures.rms)},
                          {"median", figure(scan.figures.median)},
                          {"p95", figure(scan.figures.p95)},
                          {"max", figure(scan.figures.max)}}},
                        {"coverage", scan.figures.coverage}});
    }
    return list;
}

} // namespace

std::string reportJson(const SolveResult& result)
{
    const SolveReport& report = result.report;
    const Json root = {
        {"status", statusWord(result.status)},
        {"reason", result.reason.english()},
        {"warnings", json(result.warnings)},
        {"left_out", json(result.leftOut)},
        {"vertices", report.vertices},
        {"triangles", report.triangles},
        {"patches", report.patches},
        {"seams", report.seams},
        {"constraints",
         {{"fixed", report.constraints.fixed},
          {"sewn", report.constraints.sewn},
          {"orientation", report.constraints.orientation},
          {"ghost", report.constraints.ghost}}},
        {"iterations", report.iterations},
        {"movement", report.movement},
        {"seam_gap_mm", json(report.seamGap)},
        {"fixation_error_mm", json(report.fixationError)},
        {"fixation_deviation_mm", {{"max", report.fixationDeviation}}},
        {"handles", json(report.handles, "error_mm")},
        {"fancy_seams", json(report.fancySeams, "depth_mm")},
        {"strain", {{"max", report.strain.max}, {"p99", report.strain.p99}, {"rms", report.strain.rms}}},
        {"area_mm2", report.area},
        {"rest_area_mm2", report.restArea},
        {"flipped_triangles", report.flippedTriangles},
        {"cushions", json(report.cushions)},
        {"scans", json(report.scans)},
        {"time_ms",
         {{"triangulate", report.time.triangulate},
          {"assemble", report.time.assemble},
          {"factor", report.time.factor},
          {"iterate", report.time.iterate},
          {"per_iteration", report.time.perIteration},
          {"total", report.time.total}}},
    };
    return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace bolster::cli
