#include "SweepFiles.h"

#include "Arguments.h"
#include "NumberField.h"
#include "WholeFile.h"

#include <QFile>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <string_view>
#include <vector>

namespace bolster::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view magic = "Bolster sweep 1\n";
constexpr std::int64_t largestSpec = 1 << 20;

[[noreturn]] void refuse(const std::string& where, const std::string& what)
{
    throw UsageError("--spec: " + where + ": " + what);
}

double positive(const Json& value, const std::string& where)
{
    constexpr double least = 1e-4; // below that derivatives are noise
    const double number = value.is_number() ? value.get<double>() : -1;
    if (!(number >= least && number < 1e6))
        refuse(where, "a number above 0 (at least 0.0001) and below 1000000 is expected");
    return number;
}

void addField(const Json& entry, const std::string& where, const Design& design, Tolerances& tolerances)
{
    if (!entry.is_object() || !entry.contains("element") || !entry["element"].is_number_unsigned() ||
        !entry.contains("field") || !entry["field"].is_string() || !entry.contains("by"))
        refuse(where, "an object with \"element\", \"field\" and \"by\" is expected");
    for (const auto& [key, value] : entry.items())
        if (key != "element" && key != "field" && key != "by")
            refuse(where + "." + key, "unknown; element, field and by are known");
    const auto wanted = entry["element"].get<std::uint64_t>();
    constexpr auto mostId = static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());
    const auto id = wanted <= mostId ? static_cast<ElementId>(wanted) : noElement;
    const std::string field = entry["field"];
    const ElementPtr element = design.element(id);
    if (!element)
        refuse(where, "the design has no element " + std::to_string(wanted));
    if (!numberAt(*element, field))
        refuse(where, "element " + std::to_string(number(id)) + " has no number \"" + field + "\"");
    Freedom freedom{.kind = Freedom::Kind::Number, .element = id, .field = field};
    std::string name = field + " of element " + std::to_string(number(id));
    if (std::ranges::find(tolerances.all, name, &Tolerance::name) != tolerances.all.end())
        refuse(where, "the " + name + " stands there twice");
    tolerances.all.push_back({{std::move(freedom)}, positive(entry["by"], where + ".by"), std::move(name)});
}

void addTolerances(const Json& asked, const Design& design, Tolerances& tolerances)
{
    using Maker = std::vector<Tolerance> (*)(const Design&, double);
    const std::array<std::pair<const char*, Maker>, 6> makers{std::pair("cut_mm", &cutTolerances),
                                                              std::pair("seam_mm", &seamTolerances),
                                                              std::pair("foam_mm", &foamTolerances),
                                                              std::pair("fixation_mm", &fixationTolerances),
                                                              std::pair("stiffness_percent", &stiffnessTolerances),
                                                              std::pair("size_percent", &sizeTolerances)};
    for (const auto& [key, value] : asked.items()) {
        const std::string where = "tolerances." + key;
        if (key == "fields") {
            if (!value.is_array())
                refuse(where, "a list is expected");
            for (std::size_t k = 0; k < value.size(); ++k)
                addField(value[k], where + "[" + std::to_string(k) + "]", design, tolerances);
            continue;
        }
        const auto maker = std::ranges::find(makers, key, [](const auto& m) { return std::string(m.first); });
        if (maker == makers.end())
            refuse(where, "unknown; cut_mm, seam_mm, foam_mm, fixation_mm, stiffness_percent, size_percent and "
                          "fields are known");
        for (Tolerance& tolerance : maker->second(design, positive(value, where)))
            tolerances.all.push_back(std::move(tolerance));
    }
}

template <class T>
void put(std::string& bytes, const T& value)
{
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
T take(const char*& at)
{
    T value;
    std::memcpy(&value, at, sizeof value);
    at += sizeof value;
    return value;
}

constexpr std::size_t sampleHead = sizeof(std::uint64_t) + 4 * sizeof(double) + sizeof(std::uint8_t);
constexpr qsizetype hashSize = 20;

} // namespace

SweepSpec readSweepSpec(const QString& path, const Design& design)
{
    const WholeFile file = readWholeFile(path, largestSpec);
    if (!file.problem.empty())
        refuse(path.toStdString(), file.problem.english());
    Json spec;
    std::vector<std::set<std::string>> known; // keys of the objects that are open
    std::string twice;
    const auto lookAtKeys = [&](int, Json::parse_event_t event, const Json& key) {
        if (event == Json::parse_event_t::object_start)
            known.emplace_back();
        else if (event == Json::parse_event_t::object_end)
            known.pop_back();
        else if (event == Json::parse_event_t::key && !known.back().insert(key).second)
            twice = key;
        return true;
    };
    try {
        spec = Json::parse(file.bytes, lookAtKeys);
    } catch (const Json::parse_error& error) {
        const std::string_view before = std::string_view(file.bytes).substr(0, error.byte);
        refuse(path.toStdString(), "is no JSON from line " + std::to_string(1 + std::ranges::count(before, '\n')) +
                                       ", column " + std::to_string(before.size() - (before.rfind('\n') + 1)) +
                                       " on");
    } catch (const Json::exception&) {
        refuse(path.toStdString(), "a number in it is too large");
    }
    if (!twice.empty())
        refuse(twice, "stands there twice");
    if (!spec.is_object() || !spec.contains("tolerances") || !spec["tolerances"].is_object())
        refuse("tolerances", "an object is expected");
    SweepSpec result;
    addTolerances(spec["tolerances"], design, result.tolerances);
    if (result.tolerances.all.empty())
        refuse("tolerances", spec["tolerances"].empty() ? "nothing varies: no tolerance is given"
                                                        : "nothing varies: the design has nothing of that");
    for (const auto& [key, value] : spec.items()) {
        if (key == "distribution") {
            if (value != "uniform" && value != "normal")
                refuse(key, "uniform or normal is expected");
            result.tolerances.normal = value == "normal";
        } else if (key == "seed") {
            if (!value.is_number_unsigned())
                refuse(key, "a whole number is expected");
            result.tolerances.seed = value;
        } else if (key == "limits") {
            if (!value.is_object())
                refuse(key, "an object is expected");
            for (const auto& [limit, most] : value.items()) {
                if (limit == "distance_mm")
                    result.limitDistance = positive(most, "limits." + limit);
                else if (limit == "strain_percent")
                    result.limitStrain = positive(most, "limits." + limit) / 100;
                else
                    refuse("limits." + limit, "unknown; distance_mm and strain_percent are known");
            }
        } else if (key != "tolerances") {
            refuse(key, "unknown; tolerances, distribution, seed and limits are known");
        }
    }
    spec.erase("limits");
    result.drawn = spec.dump();
    return result;
}

SweepFolder::SweepFolder(const QString& path, const std::string& asked, int samples)
    : m_folder(path, asked)
    , m_samples(samples)
{}

Message SweepFolder::open() const
{
    if (Message problem = m_folder.open(); !problem.empty())
        return problem;
    return madeFolder(file("parts"));
}

QString SweepFolder::partFile(int part) const
{
    return file(QString("parts/%1.part").arg(part, 6, 10, QChar('0')));
}

bool SweepFolder::has(int part, std::size_t vertices) const
{
    return !read(part, vertices).empty();
}

Message SweepFolder::write(int part, const std::vector<SweepSample>& samples) const
{
    std::string bytes(magic);
    put(bytes, static_cast<std::uint64_t>(samples.size()));
    for (const SweepSample& sample : samples) {
        put(bytes, sample.number);
        for (const double value : {sample.rms, sample.p95, sample.most, sample.strain})
            put(bytes, value);
        put(bytes, static_cast<std::uint8_t>(sample.outside.empty() ? 0 : 1));
        for (const float value : sample.outside)
            put(bytes, value);
    }
    const QByteArray hash = jobHash(bytes);
    return replaceWholeFile(partFile(part), bytes + hash.toStdString());
}

std::vector<SweepSample> SweepFolder::read(int part, std::size_t vertices) const
{
    const std::size_t most = magic.size() + 8 + samplesOfPart * (sampleHead + 4 * vertices) + hashSize;
    const std::string bytes = readWholeFile(partFile(part), static_cast<std::int64_t>(most)).bytes;
    if (bytes.size() < magic.size() + 8 + hashSize || !bytes.starts_with(magic) ||
        jobHash(bytes.substr(0, bytes.size() - hashSize)).toStdString() != bytes.substr(bytes.size() - hashSize))
        return {};
    const char* at = bytes.data() + magic.size();
    const char* const end = bytes.data() + bytes.size() - hashSize;
    // Of a sweep with more samples it has more.
    const auto count = static_cast<std::size_t>(countOf(part));
    if (take<std::uint64_t>(at) < count)
        return {};
    std::vector<SweepSample> samples(count);
    for (std::size_t k = 0; k < count; ++k) {
        SweepSample& sample = samples[k];
        if (end - at < static_cast<std::ptrdiff_t>(sampleHead))
            return {};
        sample.number = take<std::uint64_t>(at);
        for (double* value : {&sample.rms, &sample.p95, &sample.most, &sample.strain})
            *value = take<double>(at);
        const bool rests = take<std::uint8_t>(at) != 0;
        if (sample.number != firstOf(part) + k || (rests && end - at < static_cast<std::ptrdiff_t>(4 * vertices)))
            return {};
        for (std::size_t v = 0; rests && v < vertices; ++v)
            sample.outside.push_back(take<float>(at));
    }
    return samples;
}

} // namespace bolster::cli
