#include "ByteReader.h"
#include "MeshBuilder.h"
#include "MeshReaders.h"
#include "PlyHeader.h"

namespace bolster {
namespace {

/// The numbers behind the header, whichever way they are written.
class PlyBody {
public:
    PlyBody(PlyHeader::Format format, std::string_view bytes, TextScanner& header)
        : m_isText(format == PlyHeader::Format::Text)
        , m_text(header)
        , m_binary(bytes, format == PlyHeader::Format::BigEndian, m_isText ? 0 : header.offsetOfNextLine())
    {}

    MeshPlace place() const { return m_isText ? m_text.place() : m_binary.place(); }

    /// Refuses when so many rows cannot be in the rest of the file.
    void require(std::uint64_t rows, std::uint64_t binaryBytesPerRow, std::uint64_t wordsPerRow) const
    {
        const std::uint64_t left = m_isText ? m_text.bytesLeft() + 1 : m_binary.bytesLeft();
        const std::uint64_t perRow = m_isText ? 2 * wordsPerRow : binaryBytesPerRow;
        if (perRow > 0 && rows > left / perRow)
            refuseMesh(place(), QT_TRANSLATE_NOOP("Message", "%1: the file promises more than it holds"));
    }

    /// Every type fits into a double.
    double number(PlyType type) { return m_isText ? m_text.number(m_text.wordOnAnyLine()) : binaryNumber(type); }

    std::int64_t integer(PlyType type)
    {
        return m_isText ? m_text.integer(m_text.wordOnAnyLine()) : static_cast<std::int64_t>(binaryNumber(type));
    }

    std::uint64_t listSize(const PlyProperty& property)
    {
        const std::int64_t size = integer(*property.countType);
        if (size < 0)
            refuseMesh(place(), QT_TRANSLATE_NOOP("Message", "%1: a count is negative"));
        require(static_cast<std::uint64_t>(size), byteSize(property.type), 1);
        return static_cast<std::uint64_t>(size);
    }

    void skip(const PlyProperty& property)
    {
        const std::uint64_t size = property.countType ? listSize(property) : 1;
        for (std::uint64_t i = 0; i < size; ++i)
            number(property.type);
    }

private:
    double binaryNumber(PlyType type)
    {
        switch (type) {
        case PlyType::Int8:
            return m_binary.read<std::int8_t>();
        case PlyType::Uint8:
            return m_binary.read<std::uint8_t>();
        case PlyType::Int16:
            return m_binary.read<std::int16_t>();
        case PlyType::Uint16:
            return m_binary.read<std::uint16_t>();
        case PlyType::Int32:
            return m_binary.read<std::int32_t>();
        case PlyType::Uint32:
            return m_binary.read<std::uint32_t>();
        case PlyType::Float32:
            return static_cast<double>(m_binary.read<float>());
        case PlyType::Float64:
            break;
        }
        return m_binary.read<double>();
    }

    bool m_isText;
    TextScanner& m_text;
    ByteReader m_binary;
};

void requireRows(const PlyBody& body, const PlyElement& element)
{
    std::uint64_t bytes = 0;
    for (const PlyProperty& property : element.properties)
        bytes += byteSize(property.countType.value_or(property.type));
    body.require(element.count, bytes, element.properties.size());
}

void readVertices(PlyBody& body, const PlyElement& element, MeshBuilder& mesh)
{
    constexpr std::array<std::string_view, 3> axes = {"x", "y", "z"};
    std::vector<int> axisOf(element.properties.size(), -1);
    for (int axis = 0; axis < 3; ++axis) {
        const auto property = element.find(axes[static_cast<std::size_t>(axis)]);
        if (!property || element.properties[*property].countType)
            refuseMesh({}, QT_TRANSLATE_NOOP("Message", "%1: the points have no coordinate \"%2\""),
                       {std::string(axes[static_cast<std::size_t>(axis)])});
        axisOf[*property] = axis;
    }
    mesh.reservePoints(element.count, body.place());
    for (std::uint64_t i = 0; i < element.count; ++i) {
        const MeshPlace place = body.place();
        Vec3 point;
        for (std::size_t k = 0; k < axisOf.size(); ++k) {
            if (axisOf[k] >= 0)
                point[axisOf[k]] = body.number(element.properties[k].type);
            else
                body.skip(element.properties[k]);
        }
        mesh.addPoint(point, place);
    }
}

void readFaces(PlyBody& body, const PlyElement& element, MeshBuilder& mesh)
{
    const auto indices = element.find("vertex_indices", "vertex_index");
    if (!indices || !element.properties[*indices].countType || !isInteger(element.properties[*indices].type))
        refuseMesh({}, QT_TRANSLATE_NOOP("Message", "%1: the faces have no list \"%2\""), {"vertex_indices"});
    std::vector<std::int64_t> corners;
    for (std::uint64_t i = 0; i < element.count; ++i) {
        const MeshPlace place = body.place();
        for (std::size_t k = 0; k < element.properties.size(); ++k) {
            const PlyProperty& property = element.properties[k];
            if (k != *indices) {
                body.skip(property);
                continue;
            }
            corners.resize(body.listSize(property));
            for (std::int64_t& corner : corners)
                corner = body.integer(property.type);
        }
        mesh.addFace(corners, place);
    }
}

} // namespace

TriangleMesh readPly(std::string_view bytes)
{
    TextScanner text(bytes);
    const PlyHeader header = readPlyHeader(text);
    const PlyElement* faces = header.find("face");
    if (!faces || faces->count == 0)
        refuseMesh({}, QT_TRANSLATE_NOOP("Message", "%1 holds points only; a frame needs faces between them"));

    PlyBody body(header.format, bytes, text);
    MeshBuilder mesh;
    for (const PlyElement& element : header.elements) {
        requireRows(body, element);
        if (element.properties.empty())
            continue;
        if (element.name == "vertex") {
            readVertices(body, element, mesh);
        } else if (element.name == "face") {
            readFaces(body, element, mesh);
        } else {
            for (std::uint64_t i = 0; i < element.count; ++i)
                for (const PlyProperty& property : element.properties)
                    body.skip(property);
        }
    }
    return mesh.finish();
}

} // namespace bolster
