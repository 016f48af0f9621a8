<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>ElementText</name>
    <message>
        <source>missing element %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fixation curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fixation curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fixation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fixations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unusable element</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unusable elements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2, ease %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Message</name>
    <message>
        <source>the degree must be 1, 2 or 3, not %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a closed curve needs at least %1 points, not %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an open curve of this degree needs at least %1 points, not %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point %1 is no number or beyond 1e7 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>corners belong to closed curves of degree 3 only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the list of corners is empty; leave it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>corner %1 does not exist; the points are numbered 0 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the corners must increase, but %1 follows %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there must be at least two points between the corners %1 and %2 (a straight edge: at its thirds)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: the text goes on after the design&apos;s last bracket; remove what follows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: the text ends in the middle of the design; the file is incomplete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: brackets are nested more than 64 deep; no design needs that</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: a value is expected here: a number, a text in quotes, true, false or a bracket (NaN and Infinity are no numbers)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: a comma or &quot;]&quot; is missing here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: a key in quotes is expected here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: a colon is missing after the key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: a comma or &quot;}&quot; is missing here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: a text in quotes must end on its line; a quote is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: this is no valid escape; write a backslash as &quot;\\&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: this is not UTF-8; save the file in that encoding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: the text ends inside quotes; the file is incomplete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: this is no number; write it like 12.5, -3 or 1e-3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the text is larger than %1 MB; that is no design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>knot %1 occurs more often than %2 times, the degree; remove the surplus ones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the knots of an open curve must begin with %1 equal ones and end with %1 equal, larger ones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 points of degree %2 need %3 knots, not %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a knot is no number or beyond 1e7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the knots must not decrease</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the last knot must be larger than the first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two knots near %1 are almost equal; make them equal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; lies outside the design&apos;s folder; copy the mesh into that folder and name it here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot; in the design&apos;s folder; copy the mesh there or choose another one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with this scale and position the frame reaches beyond 10,000,000 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is not enough memory for this design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the file promises more than it holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the mesh is too large, the limit is %2 points and as many triangles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the point is not finite, or beyond 10,000,000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a face refers to point %2, but there are %3 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the mesh has too many groups, the limit is %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds no mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds points only; a frame needs faces between them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a mesh that can be read; OBJ, PLY, STL and OFF can</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: points are counted from 1, not from 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the file ends too early</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the file does not begin with OFF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: binary OFF is not read; save it as text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PLY number type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PLY format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; cannot count a list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the file does not begin with &quot;ply&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not expected in a PLY header</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a count is negative</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the points have no coordinate &quot;%2&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the faces have no list &quot;%2&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a number is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a whole number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unsaved work cannot be protected: &quot;%1&quot; cannot be written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>you are not allowed to read &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a folder, not a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an ordinary file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: the disk is full; make room or choose another folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: you are not allowed to write into &quot;%2&quot;; choose another folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: there is no folder &quot;%2&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too large: %2 MB, and at most %3 MB are read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is write-protected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The equations of the cover could not be solved: a patch is degenerate or its numbers are too large.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations. Lower the pressure or check the sizes of the patches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this seam and its neighbours carry their ends round in a circle without ever meeting. Let the seams of this circle end at common points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the corners of the two stretches lie too close together to be matched. Move them apart or choose a smaller edge length.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 hold the same point of the cover in two places, %3 mm apart. Let both curves meet there, or end one stretch earlier.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the patch is too narrow somewhere for edges of %1 mm. Choose a smaller edge length.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The design cannot be solved: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no patch to solve. Add a patch to the pattern.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by an estimated %2 mm. Allow more iterations.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move %1 points</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PatternSelectTool</name>
    <message>
        <source>There is a control point already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to turn the selected patches in the layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to move the control point – Shift+click selects several, Del removes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click to add a control point here, drag to move the patch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to select the seam, double click to add a control point here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to select the patch, drag to move it in the layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to select, drag a box to select several – middle button or Space pans, wheel zooms</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PatternTool</name>
    <message>
        <source>Moved by %1, %2 – Shift keeps to one axis, Esc takes it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turned by %1 – Shift turns in steps of 15°, Esc takes it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release to select what lies in the box – Shift adds, Esc takes it back</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SelectionEdits</name>
    <message>
        <source>Not removed: the curve needs these points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not removed: other elements need this fabric.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Units</name>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
