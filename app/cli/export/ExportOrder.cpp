#include "ExportOrder.h"

#include "AllowanceFields.h"
#include "NotchFields.h"
#include "Subcommands.h"

namespace bolster::cli {

namespace {

DxfStandard standardOf(const Arguments& arguments)
{
    const std::string word = arguments.path("--standard").toLower().toStdString();
    if (arguments.has("--splines")) {
        if (word == "plain" || word.empty())
            return DxfStandard::Splines;
        throw UsageError("--splines is of the plain DXF: AAMA and ASTM know no curves");
    }
    if (word.empty() || word == "aama")
        return DxfStandard::Aama;
    if (word == "astm")
        return DxfStandard::Astm;
    if (word == "plain")
        return DxfStandard::Plain;
    throw UsageError("--standard is aama, astm or plain, not \"" + word + "\"");
}

PaperSize paperOf(const Arguments& arguments)
{
    if (!arguments.has("--paper"))
        return {};
    if (const auto paper = paperSize(arguments.path("--paper")))
        return *paper;
    throw UsageError("--paper is " + paperNames().join(", ").toStdString() +
                     " or roll:WIDTH (150 to 5000), not \"" + arguments.path("--paper").toStdString() + "\"");
}

CutLayers layersOf(const Arguments& arguments)
{
    if (!arguments.has("--lines"))
        return {};
    std::string unknown;
    if (const auto layers = cutLayers(arguments.path("--lines").toStdString(), unknown))
        return *layers;
    throw UsageError("--lines does not know \"" + unknown +
                     "\": it takes cut, sew, notches, grain, labels, internal, holes");
}

CutOptions cutOptionsOf(const Arguments& arguments)
{
    CutOptions options;
    if (arguments.has("--allowance"))
        options.allowance =
            arguments.number("--allowance", CutAllowance{}.width, allowanceWidth.least, allowanceWidth.most);
    if (arguments.has("--notch-spacing"))
        options.notchSpacing = arguments.number("--notch-spacing", 0, notchSpacing.least, notchSpacing.most);
    options.chord = arguments.number("--chord", options.chord, 0.001, 10);
    options.unfold = arguments.has("--unfold");
    return options;
}

} // namespace

ExportOrder exportOrder(const Arguments& arguments)
{
    return {standardOf(arguments),
            {paperOf(arguments), arguments.has("--landscape"), layersOf(arguments)},
            cutOptionsOf(arguments),
            arguments.has("--lenient")};
}

std::optional<std::set<ElementId>> chosenPieces(const Arguments& arguments, const Design& design)
{
    const std::vector<std::string> names = arguments.values("--piece");
    if (names.empty())
        return std::nullopt;
    std::set<ElementId> chosen;
    for (const std::string& name : names) {
        bool found = false;
        design.each<Patch>([&](ElementId id, const Patch& patch) {
            if (patch.name == name)
                chosen.insert(id), found = true;
        });
        if (!found)
            throw UsageError("there is no piece \"" + name + "\"");
    }
    return chosen;
}

} // namespace bolster::cli
