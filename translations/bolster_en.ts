<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>FixationsLeft</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n fixation curve(s) no longer lie on the frame.</source>
        <translation>
            <numerusform>%n fixation curve no longer lies on the frame.</numerusform>
            <numerusform>%n fixation curves no longer lie on the frame.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FormPatternReport</name>
    <message numerus="yes">
        <source>(and %n more)</source>
        <translation>
            <numerusform>(and %n more)</numerusform>
            <numerusform>(and %n more)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n piece</numerusform>
            <numerusform>%n pieces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seams, whose sides are equally long</source>
        <translation>
            <numerusform>%n seam, whose sides are equally long</numerusform>
            <numerusform>%n seams, whose sides are equally long</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seams, whose sides differ by %1 at most</source>
        <translation>
            <numerusform>%n seam, whose sides differ by %1 at most</numerusform>
            <numerusform>%n seams, whose sides differ by %1 at most</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more are left out, too</source>
        <translation>
            <numerusform>and %n more is left out, too</numerusform>
            <numerusform>and %n more are left out, too</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces are strained by more than the fabric may be in more than a hundredth of their area (yellow): divide them, or cut them in there.</source>
        <translation>
            <numerusform>%n piece is strained by more than the fabric may be in more than a hundredth of its area (yellow): divide it, or cut it in there.</numerusform>
            <numerusform>%n pieces are strained by more than the fabric may be in more than a hundredth of their area (yellow): divide them, or cut them in there.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FrameParts</name>
    <message numerus="yes">
        <source>%1: %n piece(s)</source>
        <translation>
            <numerusform>%1: %n piece</numerusform>
            <numerusform>%1: %n pieces</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>InspectorForms</name>
    <message numerus="yes">
        <source>%n elements</source>
        <translation>
            <numerusform>%n element</numerusform>
            <numerusform>%n elements</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TwinForm</name>
    <message numerus="yes">
        <source>%n released points</source>
        <translation>
            <numerusform>%n released point</numerusform>
            <numerusform>%n released points</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::CauseWindow</name>
    <message numerus="yes">
        <source>and %n others</source>
        <translation>
            <numerusform>and %n other</numerusform>
            <numerusform>and %n others</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more causes explain some of it, less likely than these.</source>
        <translation>
            <numerusform>%n more cause explains some of it, less likely than these.</numerusform>
            <numerusform>%n more causes explain some of it, less likely than these.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::ExportPatternDialog</name>
    <message numerus="yes">
        <source>%n pages</source>
        <translation>
            <numerusform>%n page</numerusform>
            <numerusform>%n pages</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n patches are left out: their outlines cross themselves</source>
        <translation>
            <numerusform>%n patch is left out: its outline crosses itself</numerusform>
            <numerusform>%n patches are left out: their outlines cross themselves</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces on %1</source>
        <translation>
            <numerusform>%n piece on %1</numerusform>
            <numerusform>%n pieces on %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FabricCommands</name>
    <message numerus="yes">
        <source>%n patches have &quot;%1&quot;. What shall they get instead?</source>
        <translation>
            <numerusform>%n patch has &quot;%1&quot;. What shall it get instead?</numerusform>
            <numerusform>%n patches have &quot;%1&quot;. What shall they get instead?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n fabrics imported from %1</source>
        <translation>
            <numerusform>%n fabric imported from %1</numerusform>
            <numerusform>%n fabrics imported from %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FabricPanel</name>
    <message numerus="yes">
        <source>%n patches have it.</source>
        <translation>
            <numerusform>%n patch has it.</numerusform>
            <numerusform>%n patches have it.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FieldText</name>
    <message numerus="yes">
        <source>%n points, %1</source>
        <translation>
            <numerusform>%n point, %1</numerusform>
            <numerusform>%n points, %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FileImportDialog</name>
    <message numerus="yes">
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points, %Ln triangles</source>
        <translation>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points, %Ln triangle</numerusform>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points, %Ln triangles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FormPatternWindow</name>
    <message numerus="yes">
        <source>Dividing it, %n pieces so far …</source>
        <translation>
            <numerusform>Dividing it, %n piece so far …</numerusform>
            <numerusform>Dividing it, %n pieces so far …</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FormWishesPanel</name>
    <message numerus="yes">
        <source>&amp;Replace the %n patches of these names</source>
        <translation>
            <numerusform>&amp;Replace the %n patch of this name</numerusform>
            <numerusform>&amp;Replace the %n patches of these names</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>(%n curves that hold them will hold nothing)</source>
        <translation>
            <numerusform>(%n curve that holds them will hold nothing)</numerusform>
            <numerusform>(%n curves that hold them will hold nothing)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Lead %n open ends &amp;on</source>
        <translation>
            <numerusform>Lead %n open end &amp;on</numerusform>
            <numerusform>Lead %n open ends &amp;on</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::ImportPatternDialog</name>
    <message numerus="yes">
        <source>, %n pairs</source>
        <translation>
            <numerusform>, %n pair</numerusform>
            <numerusform>, %n pairs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n times</source>
        <translation>
            <numerusform>, %n time</numerusform>
            <numerusform>, %n times</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines lay twice on themselves and are taken once.</source>
        <translation>
            <numerusform>%n line lay twice on itself and is taken once.</numerusform>
            <numerusform>%n lines lay twice on themselves and are taken once.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n outlines are open: their ends are up to %1 apart. Close gaps up to that, if they are outlines.</source>
        <translation>
            <numerusform>%n outline is open: its ends are %1 apart. Close gaps up to that, if it is an outline.</numerusform>
            <numerusform>%n outlines are open: their ends are up to %1 apart. Close gaps up to that, if they are outlines.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::LeftWork</name>
    <message numerus="yes">
        <source>%n more designs are under File &gt; Unsaved work.</source>
        <translation>
            <numerusform>%n more design is under File &gt; Unsaved work.</numerusform>
            <numerusform>%n more designs are under File &gt; Unsaved work.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved edits restored.</source>
        <translation>
            <numerusform>%n unsaved edit restored.</numerusform>
            <numerusform>%n unsaved edits restored.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved edits are in the history, undone or on other branches.</source>
        <translation>
            <numerusform>%n unsaved edit is in the history, undone or on another branch.</numerusform>
            <numerusform>%n unsaved edits are in the history, undone or on other branches.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::MainWindow</name>
    <message numerus="yes">
        <source>%n pieces are in the pattern. Seam &gt; Propose seams finds what belongs together.</source>
        <translation>
            <numerusform>%n piece is in the pattern. Seam &gt; Propose seams finds what belongs together.</numerusform>
            <numerusform>%n pieces are in the pattern. Seam &gt; Propose seams finds what belongs together.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::OpenFlow</name>
    <message numerus="yes">
        <source>%n elements cannot be used as they are; everything else works.</source>
        <translation>
            <numerusform>%n element cannot be used as it is; everything else works.</numerusform>
            <numerusform>%n elements cannot be used as they are; everything else works.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::PatternFitWindow</name>
    <message numerus="yes">
        <source>%n of the numbers that may change do nothing here.</source>
        <translation>
            <numerusform>%n of the numbers that may change does nothing here.</numerusform>
            <numerusform>%n of the numbers that may change do nothing here.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::PreferencesWindow</name>
    <message numerus="yes">
        <source>This version of Bolster does not know %n of them: %1</source>
        <translation>
            <numerusform>This version of Bolster does not know %n of them: %1</numerusform>
            <numerusform>This version of Bolster does not know %n of them: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::Rescue</name>
    <message numerus="yes">
        <source>What can be read goes into a new project. What you do not want any more is deleted %n days after it was put into the bin.</source>
        <translation>
            <numerusform>What can be read goes into a new project. What you do not want any more is deleted %n day after it was put into the bin.</numerusform>
            <numerusform>What can be read goes into a new project. What you do not want any more is deleted %n days after it was put into the bin.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::SaveFlow</name>
    <message numerus="yes">
        <source>%n edits</source>
        <translation>
            <numerusform>%n edit</numerusform>
            <numerusform>%n edits</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edits that were undone or are on other branches</source>
        <translation>
            <numerusform>%n edit that was undone or is on another branch</numerusform>
            <numerusform>%n edits that were undone or are on other branches</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::SeamLineList</name>
    <message numerus="yes">
        <source>%n lines that hold a cover</source>
        <translation>
            <numerusform>%n line that holds a cover</numerusform>
            <numerusform>%n lines that hold a cover</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::StatusLine</name>
    <message numerus="yes">
        <source>%n problems</source>
        <translation>
            <numerusform>%n problem</numerusform>
            <numerusform>%n problems</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n warning</numerusform>
            <numerusform>%n warnings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::SweepWindow</name>
    <message numerus="yes">
        <source>By %n solved pieces.</source>
        <translation>
            <numerusform>By %n solved piece.</numerusform>
            <numerusform>By %n solved pieces.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces have no cover at rest.</source>
        <translation>
            <numerusform>%n piece has no cover at rest.</numerusform>
            <numerusform>%n pieces have no cover at rest.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>By %n solved pieces so far; more are being solved …</source>
        <translation>
            <numerusform>By %n solved piece so far; more are being solved …</numerusform>
            <numerusform>By %n solved pieces so far; more are being solved …</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With %n tolerances no cover is found, as with: %1. They are left out of this: make them smaller.</source>
        <translation>
            <numerusform>With %n tolerance no cover is found: %1. It is left out of this: make it smaller.</numerusform>
            <numerusform>With %n tolerances no cover is found, as with: %1. They are left out of this: make them smaller.</numerusform>
        </translation>
    </message>
</context>
</TS>
