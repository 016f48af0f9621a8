// What a reader of assemblies says comes through as it is, in whatever pieces; what it must not say is refused.
#include "AssemblyStream.h"
#include "AssemblyRecord.h"
#include "AssemblyWriter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bolster {
namespace {

using State = AssemblyStream::State;

TriangleMesh triangle()
{
    TriangleMesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

std::string written(const std::function<void(AssemblyWriter&)>& write)
{
    std::string bytes;
    AssemblyWriter writer([&bytes](std::string_view more) { bytes += more; });
    write(writer);
    return bytes;
}

std::string goodStream()
{
    return written([](AssemblyWriter& writer) {
        writer.facts({25.4, UpAxis::Y});
        const std::uint32_t chair = writer.addPart("Chair", {});
        const std::uint32_t leg = writer.addPart("Leg", chair, 0x102030);
        writer.progress(0.5);
        writer.addMesh(leg, triangle());
        const Vec3 line[] = {{0, 0, 0}, {5, 0, 0}};
        writer.addEdge(leg, Assembly::Edge::Kind::Line, line);
        writer.warn(AssemblyOddity::NoSize, 3, "Arm");
        writer.end(AssemblyVerdict::Read);
    });
}

/// A stream with this record in it, which is a lie, after a part with a triangle.
std::string withRecord(AssemblyRecord kind, const std::string& bytes)
{
    std::string stream =
        written([](AssemblyWriter& writer) { writer.addMesh(writer.addPart("A", {}), triangle()); });
    const AssemblyRecordHead head{static_cast<std::uint32_t>(kind), static_cast<std::uint32_t>(bytes.size())};
    stream.append(reinterpret_cast<const char*>(&head), sizeof head);
    return stream + bytes;
}

template <class... Numbers>
std::string raw(Numbers... numbers)
{
    std::string bytes;
    (bytes.append(reinterpret_cast<const char*>(&numbers), sizeof numbers), ...);
    return bytes;
}

TEST(AssemblyStream, TakesWhatWasWrittenInPiecesOfAnySize)
{
    const std::string bytes = goodStream();
    for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, bytes.size()}) {
        AssemblyStream stream;
        for (std::size_t at = 0; at < bytes.size(); at += piece) {
            ASSERT_EQ(stream.state(), State::Unfinished);
            stream.take(std::string_view(bytes).substr(at, piece));
        }
        ASSERT_EQ(stream.state(), State::Done);
        EXPECT_EQ(stream.verdict(), AssemblyVerdict::Read);
        EXPECT_EQ(stream.progress(), 0.5);
        ASSERT_EQ(stream.warnings().size(), 1u);
        EXPECT_EQ(stream.warnings()[0].count, 3u);
        EXPECT_EQ(stream.warnings()[0].text, "Arm");
        const Assembly assembly = stream.takeAssembly();
        EXPECT_EQ(assembly.said, (FileFacts{25.4, UpAxis::Y}));
        ASSERT_EQ(assembly.parts.size(), 2u);
        EXPECT_EQ(assembly.parts[1].name, "Leg");
        EXPECT_EQ(assembly.parts[1].parent, 0u);
        EXPECT_EQ(assembly.parts[1].color, 0x102030u);
        EXPECT_EQ(assembly.parts[1].points, triangle().points);
        EXPECT_EQ(assembly.parts[1].triangles, triangle().triangles);
        ASSERT_EQ(assembly.edges.size(), 1u);
        EXPECT_EQ(assembly.edges[0].kind, Assembly::Edge::Kind::Line);
    }
}

TEST(AssemblyStream, AFileWithoutAnyUnitSaysNone)
{
    AssemblyStream stream;
    stream.take(written([](AssemblyWriter& writer) {
        writer.facts({});
        writer.addMesh(writer.addPart("A", {}), triangle());
        writer.end(AssemblyVerdict::Read);
    }));
    EXPECT_EQ(stream.takeAssembly().said, FileFacts{});
}

TEST(AssemblyStream, LargeMeshesComeInManyRecords)
{
    constexpr std::uint32_t count = 200'000;
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < count; ++i)
        mesh.points.emplace_back(i, 0, 0);
    for (std::uint32_t i = 2; i < count; ++i)
        mesh.triangles.push_back({i - 2, i - 1, i});
    AssemblyStream stream;
    EXPECT_EQ(stream.take(written([&](AssemblyWriter& writer) {
        writer.addMesh(writer.addPart("A", {}), mesh);
        writer.end(AssemblyVerdict::Read);
    })),
              State::Done);
    const Assembly assembly = stream.takeAssembly();
    EXPECT_EQ(assembly.parts[0].points, mesh.points);
    EXPECT_EQ(assembly.parts[0].triangles, mesh.triangles);
}

TEST(AssemblyStream, RefusalsBringNothingButTheirReason)
{
    AssemblyStream stream;
    stream.take(written([](AssemblyWriter& writer) {
        writer.addMesh(writer.addPart("A", {}), triangle());
        writer.end(AssemblyVerdict::FileMissing, "legs.bin");
    }));
    EXPECT_EQ(stream.state(), State::Done);
    EXPECT_EQ(stream.verdict(), AssemblyVerdict::FileMissing);
    EXPECT_EQ(stream.text(), "legs.bin");
    EXPECT_TRUE(stream.takeAssembly().parts.empty());
}

TEST(AssemblyStream, LiesAreRefused)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::string lies[] = {
        "bolster",
        withRecord(AssemblyRecord::Triangles, raw(0u, 0u, 1u, 3u)), // there are three points
        withRecord(AssemblyRecord::Triangles, raw(1u, 0u, 1u, 2u)), // there is one part
        withRecord(AssemblyRecord::Triangles, raw(0u, 0u, 1u)),
        withRecord(AssemblyRecord::Points, raw(7u, 0.0, 0.0, 0.0)),
        withRecord(AssemblyRecord::Points, raw(0u, 0.0, nan, 0.0)),
        withRecord(AssemblyRecord::Points, raw(0u, 0.0, 1e8, 0.0)),
        withRecord(AssemblyRecord::Points, raw(0u, 0.0)),
        withRecord(AssemblyRecord::Part, raw(2u, noColor)), // a part that does not come before it
        withRecord(AssemblyRecord::Part, raw(0u, 0x1000000u)),
        withRecord(AssemblyRecord::Part, raw(0u, noColor) + std::string(longestPartName + 1, 'x')),
        withRecord(AssemblyRecord::Facts, raw(-1.0, 0u)),
        withRecord(AssemblyRecord::Facts, raw(nan, 0u)),
        withRecord(AssemblyRecord::Facts, raw(1.0, 9u)),
        withRecord(AssemblyRecord::Edge, raw(0u, 0u, 0.0, 0.0, 0.0)), // one point is no edge
        withRecord(AssemblyRecord::Edge, raw(0u, 77u, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0)),
        withRecord(AssemblyRecord::Warning, raw(99u, 1.0)),
        withRecord(AssemblyRecord::Warning, raw(0u, nan)),
        withRecord(AssemblyRecord::Progress, raw(2.0)),
        withRecord(AssemblyRecord::End, raw(77u)),
        withRecord(static_cast<AssemblyRecord>(50), ""),
        written([](AssemblyWriter& writer) { writer.end(AssemblyVerdict::Read); }), // of what?
    };
    for (const std::string& lie : lies) {
        AssemblyStream stream;
        EXPECT_EQ(stream.take(lie), State::Broken) << (&lie - lies);
        EXPECT_TRUE(stream.takeAssembly().parts.empty());
    }
}

/// Whoever promises a record of 4 GB gets no room for it.
TEST(AssemblyStream, RecordsAreSmall)
{
    std::string bytes = goodStream().substr(0, 4);
    const AssemblyRecordHead head{0, 0xFFFFFFFF};
    bytes.append(reinterpret_cast<const char*>(&head), sizeof head);
    AssemblyStream stream;
    EXPECT_EQ(stream.take(bytes), State::Broken);
}

TEST(AssemblyStream, TooMuchIsRefusedWhereItIsWritten)
{
    const auto refusal = [](const std::function<void(AssemblyWriter&)>& write) {
        try {
            written(write);
        } catch (const AssemblyRefused& refused) {
            return refused.verdict;
        }
        return AssemblyVerdict::Read;
    };
    EXPECT_EQ(refusal([](AssemblyWriter& writer) {
                  for (std::size_t i = 0; i <= mostAssemblyParts; ++i)
                      writer.addPart("", {});
              }),
              AssemblyVerdict::TooManyParts);
    TriangleMesh large = triangle();
    large.triangles.resize(mostAssemblyTriangles / 4 + 1, {0, 1, 2});
    EXPECT_EQ(refusal([&](AssemblyWriter& writer) {
                  AssemblyWriter silent([](std::string_view) {});
                  for (int i = 0; i < 4; ++i)
                      silent.addMesh(silent.addPart("", {}), large);
                  writer.end(AssemblyVerdict::Read);
              }),
              AssemblyVerdict::TooLarge);
}

} // namespace
} // namespace bolster
