#include "CadDocument.h"

#include <IGESCAFControl_Reader.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_ProgressIndicator.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_ExternFile.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>

#include <array>
#include <istream>
#include <streambuf>

namespace bolster {
namespace {

constexpr double shareOfTransfer = 0.5; // of all that is to be done; then come the triangles

class ByteStream : public std::streambuf {
public:
    explicit ByteStream(std::string_view bytes)
    {
        char* const begin = const_cast<char*>(bytes.data()); // it is only read
        setg(begin, begin, begin + bytes.size());
    }
};

class TransferProgress : public Message_ProgressIndicator {
public:
    explicit TransferProgress(AssemblyWriter& writer)
        : m_writer(writer)
    {}

protected:
    void Show(const Message_ProgressScope&, const Standard_Boolean) override
    {
        m_writer.progress(shareOfTransfer * GetPosition());
    }

private:
    AssemblyWriter& m_writer;
};

/// The library fills up what is missing of a file that ends too soon, and says nothing.
bool stepIsWhole(std::string_view bytes)
{
    constexpr std::size_t ends = 4096;
    const std::string_view head = bytes.substr(0, ends);
    const std::string_view tail = bytes.substr(bytes.size() - std::min(bytes.size(), ends));
    return head.find("ISO-10303-21") != std::string_view::npos &&
           tail.find("END-ISO-10303-21") != std::string_view::npos;
}

/// What stands for a number in it, outside of quotes, is one: of NAN and INF the library makes curves that its
/// mesher divides for ever.
bool stepHasNumbers(std::string_view bytes)
{
    bool quoted = false;
    char before = 0; // the last one that is no space and no sign
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const char c = bytes[i];
        if (c == '\'')
            quoted = !quoted;
        if (quoted || c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '+' || c == '-')
            continue;
        const std::string_view word = bytes.substr(i, 4); // with what ends it: no name such as INFORMATION_RIGHT
        const bool ends = word.size() == 4 && (word[3] == ',' || word[3] == ')' || word[3] == ' ');
        const std::string_view begin = word.substr(0, 3);
        if ((before == '(' || before == ',') && ends &&
            (begin == "NAN" || begin == "nan" || begin == "INF" || begin == "inf"))
            return false;
        before = c;
    }
    return true;
}

std::uint64_t stepFaces(std::string_view bytes)
{
    constexpr std::string_view word = "ADVANCED_FACE";
    std::uint64_t count = 0;
    for (std::size_t at = bytes.find(word); at != std::string_view::npos; at = bytes.find(word, at + word.size()))
        count += at > 0 && (bytes[at - 1] == '=' || bytes[at - 1] == ' ');
    return count;
}

/// The last line, of 80 characters, is that of the terminate section.
bool igesIsWhole(std::string_view bytes)
{
    const std::size_t end = bytes.find_last_not_of(std::string_view("\r\n \t\0\x1a", 6));
    if (end == std::string_view::npos)
        return false;
    const std::size_t start = bytes.find_last_of("\r\n", end);
    const std::string_view line = bytes.substr(start == std::string_view::npos ? 0 : start + 1, 80);
    return line.size() > 72 && line[72] == 'T';
}

/// 0 for what nobody means.
double stepUnit(const TCollection_AsciiString& name)
{
    constexpr std::pair<std::string_view, double> units[] = {{"millimetre", 1}, {"centimetre", 10},
                                                             {"metre", 1000},   {"inch", 25.4},
                                                             {"foot", 304.8},   {"micrometre", 1e-3}};
    TCollection_AsciiString lower = name;
    lower.LowerCase();
    for (const auto& [word, millimetres] : units)
        if (word == std::string_view(lower.ToCString(), static_cast<std::size_t>(lower.Length())))
            return millimetres;
    return 0;
}

/// Of a file with several units nothing but that its lengths come in millimetres.
double commonUnit(const TColStd_SequenceOfAsciiString& names)
{
    double unit = 0;
    for (int i = 1; i <= names.Length(); ++i) {
        const double one = stepUnit(names(i));
        if (one == 0 || (unit != 0 && one != unit))
            return 1;
        unit = one;
    }
    return unit == 0 ? 1 : unit;
}

/// By the flag of the global section.
double igesUnit(int flag)
{
    constexpr std::array<double, 12> units = {
        0,   25.4, 1,      0,    304.8, 1'609'344, // none, inch, mm, named, foot, mile
        1e3, 1e6,  0.0254, 1e-3, 10,    0.0000254};
    const double unit =
        flag > 0 && flag < static_cast<int>(units.size()) ? units[static_cast<std::size_t>(flag)] : 0;
    return unit > 0 ? unit : 1;
}

void readStep(std::string_view bytes, AssemblyWriter& writer, CadDocument& read)
{
    if (!stepIsWhole(bytes) || !stepHasNumbers(bytes))
        throw AssemblyRefused{};
    STEPCAFControl_Reader reader;
    reader.SetLayerMode(false);
    reader.SetPropsMode(false);
    reader.SetGDTMode(false);
    reader.SetMatMode(false);
    reader.SetViewMode(false);
    ByteStream buffer(bytes);
    std::istream stream(&buffer);
    if (reader.ChangeReader().ReadStream("file.stp", stream) != IFSelect_RetDone)
        throw AssemblyRefused{};
    TColStd_SequenceOfAsciiString lengths, angles, solidAngles;
    reader.ChangeReader().FileUnits(lengths, angles, solidAngles);
    read.said.millimetresPerUnit = commonUnit(lengths);
    read.faces = stepFaces(bytes);
    const Handle(TransferProgress) progress = new TransferProgress(writer);
    if (!reader.Transfer(read.document, progress->Start()))
        throw AssemblyRefused{AssemblyVerdict::NoFaces};
    const auto& outside = reader.ExternFiles();
    for (NCollection_DataMap<TCollection_AsciiString, Handle(STEPCAFControl_ExternFile)>::Iterator file(outside);
         file.More(); file.Next())
        read.elsewhere.emplace_back(file.Key().ToCString());
}

void readIges(std::string_view bytes, AssemblyWriter& writer, CadDocument& read)
{
    if (!igesIsWhole(bytes))
        throw AssemblyRefused{};
    IGESCAFControl_Reader reader;
    reader.SetReadVisible(true);
    reader.SetLayerMode(false);
    if (reader.ReadFile("") != IFSelect_RetDone) // no name: the standard input
        throw AssemblyRefused{};
    if (const auto model = Handle(IGESData_IGESModel)::DownCast(reader.Model()); !model.IsNull())
        read.said.millimetresPerUnit = igesUnit(model->GlobalSection().UnitFlag());
    const Handle(TransferProgress) progress = new TransferProgress(writer);
    if (!reader.Transfer(read.document, progress->Start()))
        throw AssemblyRefused{AssemblyVerdict::NoFaces};
}

} // namespace

void prepareCad()
{
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPCAFControl_Controller::Init();
    IGESControl_Controller::Init();
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
}

CadDocument readCadDocument(std::string_view bytes, CadOrder::Kind kind, AssemblyWriter& writer)
{
    CadDocument read;
    read.document = new TDocStd_Document("MDTV-XCAF");
    if (kind == CadOrder::Kind::Step)
        readStep(bytes, writer, read);
    else
        readIges(bytes, writer, read);
    return read;
}

void readCad(std::string_view bytes, const CadOrder& order, AssemblyWriter& writer)
{
    try {
        const CadDocument document = readCadDocument(bytes, order.kind, writer);
        writer.facts(document.said);
        for (const std::string& file : document.elsewhere)
            writer.warn(AssemblyOddity::FileElsewhere, 1, file);
        writeCadParts(document, order, writer);
    } catch (const Standard_Failure&) {
        throw AssemblyRefused{};
    }
}

} // namespace bolster
