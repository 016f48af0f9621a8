#include "CloudBuilder.h"
#include "CloudReaders.h"
#include "E57Table.h"

#include <array>
#include <cmath>
#include <map>
#include <span>

namespace bolster {

namespace {

constexpr std::uint64_t e57HeaderBytes = 48;
constexpr std::uint32_t unknownColor = 0x808080; // of a point among coloured ones

struct E57Header {
    std::uint64_t treeOffset = 0; ///< physical
    std::uint64_t treeLength = 0;
};

E57Header readE57Header(const FileBytes& bytes)
{
    FileWindow window(bytes.quietly());
    const std::string_view header =
        bytes.size() < e57HeaderBytes ? std::string_view() : window.view(0, e57HeaderBytes);
    if (!header.starts_with("ASTM-E57"))
        refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1 is not an E57 file"));
    const auto version = littleEndian<std::uint32_t>(header.substr(8));
    if (version != 1 || littleEndian<std::uint64_t>(header.substr(40)) != E57Pages::pageSize)
        refuseFile({},
                   QT_TRANSLATE_NOOP("Message", "%1: E57 of version %2 cannot be read, or its pages have another "
                                                "size than 1024; export the scan as E57 1.0"),
                   {std::to_string(version)});
    if (littleEndian<std::uint64_t>(header.substr(16)) > bytes.size())
        refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1: the file ends too early"));
    return {littleEndian<std::uint64_t>(header.substr(24)), littleEndian<std::uint64_t>(header.substr(32))};
}

/// From a scan's own axes to those of the file.
struct E57Pose {
    Quat rotation = Quat::Identity();
    Vec3 translation = Vec3::Zero(); // m
};

E57Pose readPose(const E57Node& scan)
{
    E57Pose pose;
    const E57Node* const node = scan.child("pose");
    if (!node)
        return pose;
    if (const E57Node* const rotation = node->child("rotation"))
        pose.rotation = Quat(rotation->number("w").value_or(1), rotation->number("x").value_or(0),
                             rotation->number("y").value_or(0), rotation->number("z").value_or(0));
    if (const E57Node* const translation = node->child("translation"))
        pose.translation = {translation->number("x").value_or(0), translation->number("y").value_or(0),
                            translation->number("z").value_or(0)};
    const double norm = pose.rotation.norm();
    if (!(std::abs(norm - 1) < 0.1) || !pose.translation.allFinite())
        refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1: the pose of a scan is no rotation and translation"));
    pose.rotation.normalize();
    return pose;
}

/// 0 to 255 of a number between two limits.
struct E57Channel {
    std::size_t column = 0;
    double least = 0, span = 255;

    std::uint32_t byte(const std::vector<double>& numbers) const
    {
        const double share = (numbers[column] - least) / span;
        return share > 0 ? static_cast<std::uint32_t>(std::lround(255 * std::min(share, 1.0))) : 0; // NaN, too
    }
};

/// One scan of the file: which columns are what.
class E57Scan {
public:
    E57Scan(E57Pages& ahead, const E57Node& scan, const E57Node& points)
        : m_scan(scan)
        , m_table(ahead, points)
        , m_pose(readPose(scan))
    {
        constexpr std::array<std::string_view, 3> cartesian = {"cartesianX", "cartesianY", "cartesianZ"},
                                                  spherical = {"sphericalRange", "sphericalAzimuth",
                                                               "sphericalElevation"};
        m_isCartesian = wantAll(cartesian);
        m_usable = m_isCartesian || wantAll(spherical);
        if (!m_usable || m_table.recordCount() == 0 || m_table.isConstant()) { // or all points are one
            m_usable = false;
            return;
        }
        m_invalid = wanted(m_isCartesian ? "cartesianInvalidState" : "sphericalInvalidState");
        if (hasAll({"colorRed", "colorGreen", "colorBlue"})) {
            m_channels = {channel("colorRed", "colorLimits"), channel("colorGreen", "colorLimits"),
                          channel("colorBlue", "colorLimits")};
            m_colorInvalid = wanted("isColorInvalid");
        } else if (hasAll({"intensity"})) {
            m_channels = {channel("intensity", "intensityLimits")};
            m_colorInvalid = wanted("isIntensityInvalid");
        }
    }

    bool usable() const { return m_usable; }
    bool colored() const { return m_usable && !m_channels.empty(); }
    const E57Table& table() const { return m_table; }

    void addTo(CloudBuilder& cloud, E57Pages& pages, bool withColors)
    {
        m_table.each(pages, [&](const std::vector<double>& numbers, FilePlace place) {
            if (m_invalid && numbers[*m_invalid] != 0)
                return;
            const Vec3 at = m_pose.rotation * point(numbers) + m_pose.translation;
            cloud.addPoint(at, place, withColors ? std::optional(color(numbers)) : std::nullopt);
        });
    }

private:
    bool hasAll(std::span<const std::string_view> names) const
    {
        return std::ranges::all_of(names,
                                   [this](std::string_view name) { return m_table.field(name).has_value(); });
    }
    bool hasAll(std::initializer_list<std::string_view> names) const
    {
        return hasAll(std::span(names.begin(), names.size()));
    }
    bool wantAll(const std::array<std::string_view, 3>& names)
    {
        if (!hasAll(names))
            return false;
        for (std::size_t k = 0; k < 3; ++k)
            m_axes[k] = m_table.want(names[k]);
        return true;
    }
    std::optional<std::size_t> wanted(std::string_view name)
    {
        return m_table.field(name) ? std::optional(m_table.want(name)) : std::nullopt;
    }

    /// By the limits that the scan names, else those of the numbers, else as bytes.
    E57Channel channel(const std::string& name, std::string_view limits)
    {
        E57Channel found{m_table.want(name)};
        std::optional<std::pair<double, double>> range = m_table.field(name)->range;
        const bool bright = name == "intensity";
        if (bright && !range)
            range = {0, 1};
        if (const E57Node* const node = m_scan.child(limits)) {
            const std::optional<double> from = node->number(name + "Minimum"), to = node->number(name + "Maximum");
            if (from && to && *from < *to)
                range = {*from, *to};
        }
        if (range && range->first < range->second) {
            found.least = range->first;
            found.span = range->second - range->first;
        }
        return found;
    }

    Vec3 point(const std::vector<double>& numbers) const
    {
        const double a = numbers[m_axes[0]], b = numbers[m_axes[1]], c = numbers[m_axes[2]];
        if (m_isCartesian)
            return {a, b, c};
        return a * Vec3(std::cos(c) * std::cos(b), std::cos(c) * std::sin(b), std::sin(c));
    }

    std::uint32_t color(const std::vector<double>& numbers) const
    {
        if (m_channels.empty() || (m_colorInvalid && numbers[*m_colorInvalid] != 0))
            return unknownColor;
        if (m_channels.size() == 1)
            return 0x010101 * m_channels[0].byte(numbers);
        return m_channels[0].byte(numbers) << 16 | m_channels[1].byte(numbers) << 8 | m_channels[2].byte(numbers);
    }

    const E57Node& m_scan;
    E57Table m_table;
    E57Pose m_pose;
    bool m_usable = false;
    bool m_isCartesian = false;
    std::array<std::size_t, 3> m_axes{};
    std::optional<std::size_t> m_invalid, m_colorInvalid;
    std::vector<E57Channel> m_channels; // three, or one that is all of them
};

/// Else a small file could be read again and again.
void requireApart(const std::vector<E57Scan>& scans, const E57Pages& pages)
{
    std::map<std::uint64_t, std::uint64_t> sections;
    for (const E57Scan& scan : scans) {
        const auto [begin, end] = scan.table().section();
        const auto next = sections.lower_bound(begin);
        if ((next != sections.end() && next->first < end) ||
            (next != sections.begin() && std::prev(next)->second > begin))
            refuseFile(pages.place(begin),
                       QT_TRANSLATE_NOOP("Message", "%1: two scans are said to be at one place of "
                                                    "the file; export them anew"));
        sections.emplace(begin, end);
    }
}

std::vector<E57Scan> findScans(E57Pages& pages, const E57Node& root)
{
    std::vector<E57Scan> scans;
    const E57Node* const data = root.child("data3D");
    if (!data)
        return scans;
    for (const E57Node& node : data->children) {
        pages.watch().checkStop();
        const E57Node* const points = node.child("points");
        if (!points)
            continue;
        if (E57Scan scan(pages, node, *points); scan.usable())
            scans.push_back(std::move(scan));
    }
    requireApart(scans, pages);
    return scans;
}

} // namespace

PointCloud readE57(const FileBytes& bytes)
{
    const E57Header header = readE57Header(bytes);
    E57Pages ahead(bytes.quietly());
    ahead.content(0, e57HeaderBytes); // its checksum
    const E57Node root = readE57Tree(ahead, header.treeOffset, header.treeLength);
    std::vector<E57Scan> scans = findScans(ahead, root);
    const bool colored = std::ranges::any_of(scans, &E57Scan::colored);
    CloudBuilder cloud(bytes);
    std::uint64_t count = 0;
    for (const E57Scan& scan : scans)
        count += std::min(scan.table().recordCount(), largestCloudCount + 1);
    cloud.reservePoints(count, {});
    E57Pages pages(bytes);
    for (E57Scan& scan : scans)
        scan.addTo(cloud, pages, colored);
    return cloud.finish();
}

} // namespace bolster
