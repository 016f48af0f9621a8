#include "CadFiles.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <cmath>

namespace bolster::test {
namespace {

gp_Trsf moved(double x, double y, double z)
{
    gp_Trsf place;
    place.SetTranslation(gp_Vec(x, y, z));
    return place;
}

TDF_Label named(const TDF_Label& label, const char* name)
{
    TDataStd_Name::Set(label, name);
    return label;
}

void fill(const Handle(TDocStd_Document) & document)
{
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const Handle(XCAFDoc_ColorTool) colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
    const TDF_Label seat = named(shapes->AddShape(BRepPrimAPI_MakeBox(500, 400, 50).Shape(), false), "Seat");
    colors->SetColor(seat, Quantity_Color(1, 0, 0, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    const TDF_Label leg = named(shapes->AddShape(BRepPrimAPI_MakeCylinder(20, 400).Shape(), false), "Leg");
    const TDF_Label rail = named(shapes->AddShape(BRepPrimAPI_MakeBox(500, 20, 300).Shape(), false), "Rail");
    const TDF_Label back = named(shapes->NewShape(), "Back");
    gp_Trsf turned;
    turned.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), std::acos(0.0));
    shapes->AddComponent(back, rail, TopLoc_Location(turned));
    const TDF_Label chair = named(shapes->NewShape(), "Chair");
    shapes->AddComponent(chair, seat, TopLoc_Location(moved(0, 0, 400)));
    shapes->AddComponent(chair, leg, TopLoc_Location(moved(50, 0, 0)));
    shapes->AddComponent(chair, leg, TopLoc_Location(moved(450, 0, 0)));
    shapes->AddComponent(chair, back, TopLoc_Location());
    shapes->UpdateAssemblies();
}

} // namespace

void writeStepChair(const std::string& path, const char* unit)
{
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPCAFControl_Controller::Init();
    Interface_Static::SetCVal("write.step.unit", unit); // the writer looks at it when it is made
    STEPCAFControl_Writer writer;
    const Handle(TDocStd_Document) document = new TDocStd_Document("MDTV-XCAF");
    fill(document);
    writer.Transfer(document, STEPControl_AsIs);
    writer.Write(path.c_str());
}

void writeIgesBox(const std::string& path, const char* unit)
{
    Message::DefaultMessenger()->ChangePrinters().Clear();
    IGESControl_Controller::Init();
    IGESControl_Writer writer(unit, 0);
    writer.AddShape(BRepPrimAPI_MakeBox(100, 200, 300).Shape());
    writer.ComputeModel();
    writer.Write(path.c_str());
}

} // namespace bolster::test
