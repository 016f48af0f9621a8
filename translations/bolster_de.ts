<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AreaBrushTool</name>
    <message>
        <source>Drag over the cover to paint the area; with Shift held down to take away. + and − change the brush. Esc ends.</source>
        <translation>Über den Bezug ziehen, um den Bereich zu malen; mit gedrückter Umschalttaste wegnehmen. + und − ändern den Pinsel. Esc beendet.</translation>
    </message>
</context>
<context>
    <name>Ask</name>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>&quot;%1&quot; exists already. Replace it?</source>
        <translation>„%1“ gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>AttachTool</name>
    <message>
        <source>Click an edge of an outline.</source>
        <translation>Klicken Sie auf eine Kante eines Umrisses.</translation>
    </message>
    <message>
        <source>Select a fixation curve first, in the 3D view or in the list.</source>
        <translation>Wählen Sie zuerst eine Fixierkurve, in der 3D-Ansicht oder in der Liste.</translation>
    </message>
    <message>
        <source>Several stretches go with one curve, or one stretch with several curves.</source>
        <translation>Mehrere Abschnitte gehen an eine Kurve oder ein Abschnitt an mehrere Kurven.</translation>
    </message>
    <message>
        <source>The stretches overlap each other, or are attached like this already.</source>
        <translation>Die Abschnitte überschneiden sich oder sind schon so fixiert.</translation>
    </message>
    <message>
        <source>This stretch is attached like this already.</source>
        <translation>Dieser Abschnitt ist schon so fixiert.</translation>
    </message>
    <message>
        <source>Select a fixation curve in the 3D view or in the list, then click an edge of an outline – Esc ends the tool</source>
        <translation>In der 3D-Ansicht oder in der Liste eine Fixierkurve wählen, dann auf eine Kante eines Umrisses klicken – Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>%1 curves</source>
        <translation>%1 Kurven</translation>
    </message>
    <message>
        <source>Click to fix this stretch of %1 to %2 – Shift+click collects several</source>
        <translation>Klicken, um diesen Abschnitt von %1 an %2 zu fixieren – Umschalt+Klick sammelt mehrere</translation>
    </message>
    <message>
        <source>Click the last edge, or Enter attaches %1 stretches to %2 – Backspace takes one back</source>
        <translation>Auf die letzte Kante klicken, oder Eingabe fixiert %1 Abschnitte an %2 – Rücktaste nimmt einen zurück</translation>
    </message>
    <message>
        <source>Click an edge of an outline to fix it to %1 – Enter takes the selected stretch, Esc ends the tool</source>
        <translation>Auf eine Kante eines Umrisses klicken, um sie an %1 zu fixieren – Eingabe nimmt den gewählten Abschnitt, Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>&amp;Attach what is marked</source>
        <translation>Markiertes &amp;befestigen</translation>
    </message>
    <message>
        <source>&amp;Take back the last edge</source>
        <translation>Letzte Kante &amp;zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>&amp;Verwerfen</translation>
    </message>
</context>
<context>
    <name>BackgroundMoveTool</name>
    <message>
        <source>There is no background picture yet.</source>
        <translation>Es gibt noch kein Hintergrundbild.</translation>
    </message>
    <message>
        <source>Drag the picture to its place – Enter or Esc ends the tool</source>
        <translation>Das Bild an seinen Platz ziehen – Enter oder Esc beendet das Werkzeug</translation>
    </message>
</context>
<context>
    <name>BackgroundPicture</name>
    <message>
        <source>%1 cannot be read as a picture: %2</source>
        <translation>%1 lässt sich nicht als Bild lesen: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an ordinary file.</source>
        <translation>„%1“ ist keine gewöhnliche Datei.</translation>
    </message>
</context>
<context>
    <name>BackgroundScaleTool</name>
    <message>
        <source>There is no background picture yet.</source>
        <translation>Es gibt noch kein Hintergrundbild.</translation>
    </message>
    <message>
        <source>Type the true distance of the two points, for example 500 or 20 in.</source>
        <translation>Den wahren Abstand der beiden Punkte eingeben, zum Beispiel 500 oder 20 in.</translation>
    </message>
    <message>
        <source>Click the first of two points of the picture whose distance you know – Esc ends the tool</source>
        <translation>Den ersten von zwei Punkten des Bildes anklicken, deren Abstand bekannt ist – Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>Click the second point</source>
        <translation>Den zweiten Punkt anklicken</translation>
    </message>
    <message>
        <source>Type their true distance, then Enter</source>
        <translation>Ihren wahren Abstand eingeben, dann Enter</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>jetzt %1</translation>
    </message>
</context>
<context>
    <name>BoxShapeTool</name>
    <message>
        <source>&quot;%1&quot; is no size: try 300 x 200</source>
        <translation>„%1“ ist keine Größe: zum Beispiel 300 x 200</translation>
    </message>
    <message>
        <source>Enter makes it as wide and high as typed, for example 300 x 200</source>
        <translation>Enter macht es so breit und hoch wie getippt, zum Beispiel 300 x 200</translation>
    </message>
    <message>
        <source>Drag a rectangle, or click two opposite corners – Esc ends the tool</source>
        <translation>Ein Rechteck aufziehen oder zwei gegenüberliegende Ecken klicken – Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>Drag an ellipse, or click two opposite corners of its box – Esc ends the tool</source>
        <translation>Eine Ellipse aufziehen oder zwei gegenüberliegende Ecken ihres Rahmens klicken – Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>Click the opposite corner, or type width x height – Shift makes both equal, Ctrl does not snap</source>
        <translation>Die gegenüberliegende Ecke klicken oder Breite x Höhe eingeben – Umschalt macht beide gleich, Strg rastet nicht ein</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>There was no room where you clicked: the patch lies beside the others.</source>
        <translation>Wo geklickt wurde, war kein Platz: Das Schnittteil liegt neben den anderen.</translation>
    </message>
    <message>
        <source>The new patch lies on %1: drag it away, or let all be arranged (Pattern &gt; Arrange).</source>
        <translation>Das neue Schnittteil liegt auf %1: Ziehen Sie es weg, oder lassen Sie alle anordnen (Schnitt &gt; Anordnen).</translation>
    </message>
    <message>
        <source>lies on %1</source>
        <translation>liegt auf %1</translation>
    </message>
</context>
<context>
    <name>ColourwayForm</name>
    <message>
        <source>Fabrics</source>
        <translation>Stoffe</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>those of the patches</source>
        <translation>die der Schnittteile</translation>
    </message>
</context>
<context>
    <name>ContextMenus</name>
    <message>
        <source>&amp;Show</source>
        <translation>An&amp;zeigen</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>Ansehen &amp;von</translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Karte</translation>
    </message>
    <message>
        <source>&amp;Continuity</source>
        <translation>Ü&amp;bergang</translation>
    </message>
    <message>
        <source>&amp;Match</source>
        <translation>&amp;Zuordnung</translation>
    </message>
    <message>
        <source>&amp;Arrange</source>
        <translation>A&amp;nordnen</translation>
    </message>
</context>
<context>
    <name>CoverAtRest</name>
    <message>
        <source>As soon as the cover has come to rest …</source>
        <translation>Sobald der Bezug zur Ruhe gekommen ist …</translation>
    </message>
    <message>
        <source>This needs the cover of the present design: let the solver go on first (Pause).</source>
        <translation>Das braucht den Bezug des jetzigen Entwurfs: zuerst die Berechnung weiterlaufen lassen („Anhalten“ ausschalten).</translation>
    </message>
</context>
<context>
    <name>CoverMeasureTool</name>
    <message>
        <source>There is no cover here: click on the cover.</source>
        <translation>Hier ist kein Bezug: klicken Sie auf den Bezug.</translation>
    </message>
    <message>
        <source>&amp;Keep the measurement</source>
        <translation>Maß &amp;behalten</translation>
    </message>
    <message>
        <source>%1 – Enter keeps the measurement, a click begins anew</source>
        <translation>%1 – Eingabe behält das Maß, ein Klick beginnt neu</translation>
    </message>
    <message>
        <source>Click the second point on the cover – Esc gives it up</source>
        <translation>Den zweiten Punkt auf dem Bezug anklicken – Esc gibt es auf</translation>
    </message>
    <message>
        <source>Click two points of the cover or of the pattern to measure – Esc ends the tool</source>
        <translation>Zwei Punkte des Bezugs oder des Schnitts zum Messen anklicken – Esc beendet das Werkzeug</translation>
    </message>
</context>
<context>
    <name>CoverSelectTool</name>
    <message>
        <source>There is a control point already.</source>
        <translation>Hier ist schon ein Kontrollpunkt.</translation>
    </message>
    <message>
        <source>Drag to move the control point – Shift+click selects several, Del removes</source>
        <translation>Ziehen verschiebt den Kontrollpunkt – Umschalt+Klick wählt mehrere aus, Entf entfernt</translation>
    </message>
    <message>
        <source>Click to select the seam</source>
        <translation>Klick wählt die Naht aus</translation>
    </message>
    <message>
        <source>Click to select the patch, drag to turn the view</source>
        <translation>Klick wählt das Schnittteil aus, Ziehen dreht die Ansicht</translation>
    </message>
    <message>
        <source>Click to select the curve, double click to add a control point here</source>
        <translation>Klick wählt die Kurve, Doppelklick fügt hier einen Kontrollpunkt ein</translation>
    </message>
    <message>
        <source>Click to select what stands here, drag to turn the view</source>
        <translation>Klicken wählt, was hier steht, Ziehen dreht die Ansicht</translation>
    </message>
    <message>
        <source>Click to select, drag to turn – %1 pans, %2 zooms</source>
        <translation>Klick wählt aus, Ziehen dreht – Ansicht verschieben: %1, zoomen: %2</translation>
    </message>
    <message>
        <source>Click to select the measurement, Delete removes it</source>
        <translation>Klicken wählt das Maß aus, Entf entfernt es</translation>
    </message>
</context>
<context>
    <name>CushionForm</name>
    <message>
        <source>Cover of %1</source>
        <translation>Bezug von %1</translation>
    </message>
    <message>
        <source>Every cover</source>
        <translation>Jeden Bezug</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Drückt</translation>
    </message>
</context>
<context>
    <name>CutCornerForm</name>
    <message>
        <source>Patch</source>
        <translation>Schnittteil</translation>
    </message>
</context>
<context>
    <name>CutLabelWords</name>
    <message>
        <source>Cut %1</source>
        <translation>%1-mal schneiden</translation>
    </message>
    <message>
        <source>Cut %1 and %1 mirrored</source>
        <translation>%1-mal schneiden, %1-mal gespiegelt</translation>
    </message>
</context>
<context>
    <name>CuttingCommands</name>
    <message>
        <source>Chec&amp;k before cutting</source>
        <translation>Vor dem Zuschneiden &amp;prüfen</translation>
    </message>
</context>
<context>
    <name>DartCommands</name>
    <message>
        <source>Remove da&amp;rt</source>
        <translation>A&amp;bnäher entfernen</translation>
    </message>
    <message>
        <source>The edge goes on as if the selected dart had never been cut</source>
        <translation>Die Kante läuft weiter, als wäre der ausgewählte Abnäher nie geschnitten worden</translation>
    </message>
    <message>
        <source>R&amp;otate dart to …</source>
        <translation>Abnäher ver&amp;legen …</translation>
    </message>
    <message>
        <source>Turns the selected dart shut and opens the pattern where you click, by the same angle</source>
        <translation>Dreht den ausgewählten Abnäher zu und öffnet den Schnitt dort, wo Sie klicken, um denselben Winkel</translation>
    </message>
</context>
<context>
    <name>DartDrag</name>
    <message>
        <source>Near the dotted line both legs become of one length, or type how deep it is – Shift keeps to it, Ctrl lets go, Esc takes it back</source>
        <translation>Nahe der punktierten Linie werden beide Schenkel gleich lang, oder tippen Sie die Tiefe – Umschalt bleibt darauf, Strg löst, Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Drag the dart along the outline, or type how far its middle is from the corner – Esc takes it back</source>
        <translation>Ziehen Sie den Abnäher am Umriss entlang, oder tippen Sie, wie weit seine Mitte von der Ecke ist – Esc nimmt es zurück</translation>
    </message>
</context>
<context>
    <name>DartPicture</name>
    <message>
        <source>Depth %1, legs of one length</source>
        <translation>Tiefe %1, Schenkel gleich lang</translation>
    </message>
    <message>
        <source>Depth %1</source>
        <translation>Tiefe %1</translation>
    </message>
    <message>
        <source>Mouth %1</source>
        <translation>Öffnung %1</translation>
    </message>
</context>
<context>
    <name>DartRotateTool</name>
    <message>
        <source>Select the seam of a dart first – Esc ends the tool</source>
        <translation>Wählen Sie zuerst die Naht eines Abnähers – Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>Click the outline where the dart shall open instead – Ctrl does not snap, Esc ends the tool</source>
        <translation>Klicken Sie auf den Umriss, wo sich der Abnäher stattdessen öffnen soll – Strg rastet nicht ein, Esc beendet das Werkzeug</translation>
    </message>
</context>
<context>
    <name>DartTool</name>
    <message>
        <source>There is no room for a mouth of &quot;%1&quot;.</source>
        <translation>Für eine Öffnung von „%1“ ist kein Platz.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no depth: try 60</source>
        <translation>„%1“ ist keine Tiefe: Versuchen Sie 60</translation>
    </message>
    <message>
        <source>Click the tip inside the patch, or type how deep it lies – on the dotted line both legs are of one length (Shift keeps to it, Ctrl lets go), Esc takes a click back</source>
        <translation>Klicken Sie die Spitze im Schnittteil, oder tippen Sie, wie tief sie liegt – auf der punktierten Linie sind beide Schenkel gleich lang (Umschalt bleibt darauf, Strg löst), Esc nimmt einen Klick zurück</translation>
    </message>
    <message>
        <source>Click where the mouth ends on the same outline, or type how wide it is – Ctrl does not snap, Esc takes the click back</source>
        <translation>Klicken Sie, wo die Öffnung auf demselben Umriss endet, oder tippen Sie, wie weit sie ist – Strg rastet nicht ein, Esc nimmt den Klick zurück</translation>
    </message>
    <message>
        <source>Click an outline where the mouth of the dart begins – Esc ends the tool</source>
        <translation>Klicken Sie auf einen Umriss, wo die Öffnung des Abnähers beginnt – Esc beendet das Werkzeug</translation>
    </message>
</context>
<context>
    <name>DescribedField</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>DesignCuttingSection</name>
    <message>
        <source>Cutting</source>
        <translation>Zuschnitt</translation>
    </message>
    <message>
        <source>Seam allowance of all patches</source>
        <translation>Nahtzugabe aller Teile</translation>
    </message>
    <message>
        <source>Depth of notches</source>
        <translation>Tiefe der Knipse</translation>
    </message>
    <message>
        <source>Width of notches</source>
        <translation>Breite der Knipse</translation>
    </message>
</context>
<context>
    <name>Docks</name>
    <message>
        <source>Pattern</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Cover</source>
        <translation>Bezug</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Nähte</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Stoffe</translation>
    </message>
    <message>
        <source>Worst spots</source>
        <translation>Schlimmste Stellen</translation>
    </message>
    <message>
        <source>Check before cutting</source>
        <translation>Prüfen vor dem Zuschneiden</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Laufende Arbeiten</translation>
    </message>
</context>
<context>
    <name>DrawingCommands</name>
    <message>
        <source>&amp;Grid and snapping</source>
        <translation>&amp;Raster und Einrasten</translation>
    </message>
    <message>
        <source>S&amp;napping</source>
        <translation>Ei&amp;nrasten</translation>
    </message>
    <message>
        <source>&amp;Rulers</source>
        <translation>L&amp;ineale</translation>
    </message>
    <message>
        <source>Gui&amp;des</source>
        <translation>H&amp;ilfslinien</translation>
    </message>
    <message>
        <source>Remove all g&amp;uides</source>
        <translation>Alle Hilfslinien entfern&amp;en</translation>
    </message>
    <message>
        <source>Select with a &amp;loop</source>
        <translation>Mit einer &amp;Schlinge auswählen</translation>
    </message>
    <message>
        <source>&amp;Background picture</source>
        <translation>&amp;Hintergrundbild</translation>
    </message>
    <message>
        <source>&amp;Open picture …</source>
        <translation>Bild ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>An&amp;zeigen</translation>
    </message>
    <message>
        <source>&amp;Scale by two points</source>
        <translation>Mit zwei Punkten &amp;skalieren</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Verschieben</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>Ent&amp;fernen</translation>
    </message>
    <message>
        <source>Opacity %1</source>
        <translation>Deckkraft %1</translation>
    </message>
    <message>
        <source>Open a picture to trace</source>
        <translation>Bild zum Nachzeichnen öffnen</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.webp);;All files (*)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.bmp *.webp);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>DrawingKeys</name>
    <message>
        <source>&amp;Finish</source>
        <translation>&amp;Fertig</translation>
    </message>
    <message>
        <source>&amp;Take back the last point</source>
        <translation>Letzten Punkt &amp;zurücknehmen</translation>
    </message>
    <message>
        <source>Switch between &amp;straight and smooth</source>
        <translation>Zwischen &amp;gerade und glatt wechseln</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>&amp;Verwerfen</translation>
    </message>
</context>
<context>
    <name>DrillHoleForm</name>
    <message>
        <source>Patch</source>
        <translation>Schnittteil</translation>
    </message>
</context>
<context>
    <name>EdgeAllowanceForm</name>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>EditCommands</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Name this &amp;branch …</source>
        <translation>Diesen &amp;Zweig benennen …</translation>
    </message>
    <message>
        <source>Name the way that the history has gone since it forked</source>
        <translation>Gibt dem Weg, den der Verlauf seit der letzten Gabelung genommen hat, einen Namen</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Select &amp;all patches</source>
        <translation>&amp;Alle Schnittteile auswählen</translation>
    </message>
    <message>
        <source>Select n&amp;othing</source>
        <translation>Nichts a&amp;uswählen</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
</context>
<context>
    <name>ElementText</name>
    <message>
        <source>missing element %1</source>
        <translation>fehlendes Element %1</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>Schnittteil</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>Schnittteile</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Nähte</translation>
    </message>
    <message>
        <source>Fixation curve</source>
        <translation>Fixierkurve</translation>
    </message>
    <message>
        <source>Fixation curves</source>
        <translation>Fixierkurven</translation>
    </message>
    <message>
        <source>Fixation</source>
        <translation>Fixierung</translation>
    </message>
    <message>
        <source>Fixations</source>
        <translation>Fixierungen</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Gestell</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Gestelle</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Stoff</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Stoffe</translation>
    </message>
    <message>
        <source>Unusable element</source>
        <translation>Unbrauchbares Element</translation>
    </message>
    <message>
        <source>Unusable elements</source>
        <translation>Unbrauchbare Elemente</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>%1 and %2, ease %3</source>
        <translation>%1 und %2, Mehrweite %3</translation>
    </message>
    <message>
        <source>%1, normal held</source>
        <translation>%1, Normale gehalten</translation>
    </message>
    <message>
        <source>Handle curve</source>
        <translation>Griffkurve</translation>
    </message>
    <message>
        <source>Handle curves</source>
        <translation>Griffkurven</translation>
    </message>
    <message>
        <source>Fancy seam</source>
        <translation>Ziernaht</translation>
    </message>
    <message>
        <source>Fancy seams</source>
        <translation>Ziernähte</translation>
    </message>
    <message>
        <source>Cushion</source>
        <translation>Polsterung</translation>
    </message>
    <message>
        <source>Cushions</source>
        <translation>Polsterungen</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>Schaum</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Scans</translation>
    </message>
    <message>
        <source>%1 patches</source>
        <translation>%1 Schnittteile</translation>
    </message>
    <message>
        <source>%1 seams</source>
        <translation>%1 Nähte</translation>
    </message>
    <message>
        <source>%1 fixation curves</source>
        <translation>%1 Fixierkurven</translation>
    </message>
    <message>
        <source>%1 fixations</source>
        <translation>%1 Fixierungen</translation>
    </message>
    <message>
        <source>%1 handle curves</source>
        <translation>%1 Griffkurven</translation>
    </message>
    <message>
        <source>%1 fancy seams</source>
        <translation>%1 Ziernähte</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 Gestelle</translation>
    </message>
    <message>
        <source>%1 cushions</source>
        <translation>%1 Polsterungen</translation>
    </message>
    <message>
        <source>%1 pieces of foam</source>
        <translation>%1 Schaumteile</translation>
    </message>
    <message>
        <source>%1 scans</source>
        <translation>%1 Scans</translation>
    </message>
    <message>
        <source>%1 fabrics</source>
        <translation>%1 Stoffe</translation>
    </message>
    <message>
        <source>%1 unusable elements</source>
        <translation>%1 unbrauchbare Elemente</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 Elemente</translation>
    </message>
    <message>
        <source>Trimmed edge</source>
        <translation>Verzierte Kante</translation>
    </message>
    <message>
        <source>Trimmed edges</source>
        <translation>Verzierte Kanten</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>Farbvariante</translation>
    </message>
    <message>
        <source>Colourways</source>
        <translation>Farbvarianten</translation>
    </message>
    <message>
        <source>%1 trimmed edges</source>
        <translation>%1 verzierte Kanten</translation>
    </message>
    <message>
        <source>%1 colourways</source>
        <translation>%1 Farbvarianten</translation>
    </message>
    <message>
        <source>Edge of %1</source>
        <translation>Kante von %1</translation>
    </message>
    <message>
        <source>Allowance of an edge</source>
        <translation>Zugabe einer Kante</translation>
    </message>
    <message>
        <source>Allowances of edges</source>
        <translation>Zugaben von Kanten</translation>
    </message>
    <message>
        <source>%1 allowances of edges</source>
        <translation>%1 Zugaben von Kanten</translation>
    </message>
    <message>
        <source>Corner of the cut line</source>
        <translation>Ecke der Schnittlinie</translation>
    </message>
    <message>
        <source>Corners of the cut line</source>
        <translation>Ecken der Schnittlinie</translation>
    </message>
    <message>
        <source>%1 corners of the cut line</source>
        <translation>%1 Ecken der Schnittlinie</translation>
    </message>
    <message>
        <source>Drill hole</source>
        <translation>Bohrloch</translation>
    </message>
    <message>
        <source>Drill holes</source>
        <translation>Bohrlöcher</translation>
    </message>
    <message>
        <source>%1 drill holes</source>
        <translation>%1 Bohrlöcher</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>Knips</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Knipse</translation>
    </message>
    <message>
        <source>%1 notches</source>
        <translation>%1 Knipse</translation>
    </message>
    <message>
        <source>Internal line</source>
        <translation>Innenlinie</translation>
    </message>
    <message>
        <source>Internal lines</source>
        <translation>Innenlinien</translation>
    </message>
    <message>
        <source>%1 internal lines</source>
        <translation>%1 Innenlinien</translation>
    </message>
    <message>
        <source>%1, allowance %2</source>
        <translation>%1, Zugabe %2</translation>
    </message>
    <message>
        <source>Notch of %1</source>
        <translation>Knips von %1</translation>
    </message>
    <message>
        <source>Corner of %1</source>
        <translation>Ecke von %1</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Maße</translation>
    </message>
    <message>
        <source>%1 measurements</source>
        <translation>%1 Maße</translation>
    </message>
</context>
<context>
    <name>ElementsModel</name>
    <message>
        <source>edge %1</source>
        <translation>Kante %1</translation>
    </message>
    <message>
        <source>%1 from the corner</source>
        <translation>%1 von der Ecke</translation>
    </message>
</context>
<context>
    <name>FabricForm</name>
    <message>
        <source>Weft</source>
        <translation>Schuss</translation>
    </message>
    <message>
        <source>Creases</source>
        <translation>Furchen</translation>
    </message>
    <message>
        <source>Depth of the pile</source>
        <translation>Tiefe des Flors</translation>
    </message>
    <message>
        <source>Other squares</source>
        <translation>Übrige Felder</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Squares</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>Grain size</source>
        <translation>Größe der Narbung</translation>
    </message>
    <message>
        <source>Repeat of the weave</source>
        <translation>Rapport des Gewebes</translation>
    </message>
    <message>
        <source>Nap</source>
        <translation>Strich</translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation>Breite des Bildes</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>Verhalten</translation>
    </message>
    <message>
        <source>The fabric on a cushion and on a ball</source>
        <translation>Der Stoff auf einem Kissen und auf einer Kugel</translation>
    </message>
    <message>
        <source>The fabric on a cushion and on a ball, at its real scale</source>
        <translation>Der Stoff auf einem Kissen und auf einer Kugel, in wahrer Größe</translation>
    </message>
    <message>
        <source>Colour of the fabric</source>
        <translation>Farbe des Stoffs</translation>
    </message>
    <message>
        <source>Second colour of the fabric</source>
        <translation>Zweite Farbe des Stoffs</translation>
    </message>
    <message>
        <source>From the first colour</source>
        <translation>Aus der ersten Farbe</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Choose an&amp;other picture …</source>
        <translation>Anderes B&amp;ild wählen …</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Zuschnitt</translation>
    </message>
</context>
<context>
    <name>FabricMenu</name>
    <message>
        <source>&amp;New fabric</source>
        <translation>&amp;Neuer Stoff</translation>
    </message>
    <message>
        <source>Adds leather, weave, velvet or another fabric to the library of the design</source>
        <translation>Fügt der Sammlung des Entwurfs Leder, Gewebe, Samt oder einen anderen Stoff hinzu</translation>
    </message>
    <message>
        <source>From a &amp;picture …</source>
        <translation>Aus einem &amp;Bild …</translation>
    </message>
    <message>
        <source>A fabric that looks like a picture: PNG, JPEG, TIFF or OpenEXR</source>
        <translation>Ein Stoff, der wie ein Bild aussieht: PNG, JPEG, TIFF oder OpenEXR</translation>
    </message>
    <message>
        <source>&amp;Assign to selection</source>
        <translation>Der &amp;Auswahl zuweisen</translation>
    </message>
    <message>
        <source>Gives the selected patches the fabric that is chosen in the library</source>
        <translation>Gibt den ausgewählten Schnittteilen den Stoff, der in der Sammlung gewählt ist</translation>
    </message>
    <message>
        <source>Fabric p&amp;roperties</source>
        <translation>Eigenschaften des &amp;Stoffs</translation>
    </message>
    <message>
        <source>Shows kind, colours, size and limits of the fabric</source>
        <translation>Zeigt Art, Farben, Größe und Grenzen des Stoffs</translation>
    </message>
    <message>
        <source>Picture on the &amp;fabric …</source>
        <translation>Bild auf &amp;dem Stoff …</translation>
    </message>
    <message>
        <source>Lets the fabric look like a picture: PNG, JPEG, TIFF or OpenEXR</source>
        <translation>Lässt den Stoff wie ein Bild aussehen: PNG, JPEG, TIFF oder OpenEXR</translation>
    </message>
    <message>
        <source>D&amp;uplicate fabric</source>
        <translation>Stoff &amp;verdoppeln</translation>
    </message>
    <message>
        <source>Adds a copy of the fabric, to be changed</source>
        <translation>Fügt eine Kopie des Stoffs hinzu, die geändert werden kann</translation>
    </message>
    <message>
        <source>Rename fa&amp;bric …</source>
        <translation>Stoff &amp;umbenennen …</translation>
    </message>
    <message>
        <source>Gives the fabric another name</source>
        <translation>Gibt dem Stoff einen anderen Namen</translation>
    </message>
    <message>
        <source>&amp;Delete fabric …</source>
        <translation>Stoff &amp;löschen …</translation>
    </message>
    <message>
        <source>Removes the fabric; asks what patches get instead</source>
        <translation>Entfernt den Stoff; fragt, was Schnittteile stattdessen bekommen</translation>
    </message>
    <message>
        <source>&amp;Import fabrics …</source>
        <translation>Stoffe &amp;importieren …</translation>
    </message>
    <message>
        <source>Takes over the fabrics of a file, a design or a project</source>
        <translation>Übernimmt die Stoffe einer Datei, eines Entwurfs oder eines Projekts</translation>
    </message>
    <message>
        <source>&amp;Export fabric …</source>
        <translation>Stoff &amp;exportieren …</translation>
    </message>
    <message>
        <source>Writes the fabric to a file, its picture beside it</source>
        <translation>Schreibt den Stoff in eine Datei, sein Bild daneben</translation>
    </message>
    <message>
        <source>Pre&amp;views</source>
        <translation>&amp;Vorschau</translation>
    </message>
    <message>
        <source>On &amp;cushions</source>
        <translation>Auf K&amp;issen</translation>
    </message>
    <message>
        <source>Shows the fabrics of the library on cushions</source>
        <translation>Zeigt die Stoffe der Bibliothek auf Kissen</translation>
    </message>
    <message>
        <source>On &amp;balls</source>
        <translation>Auf &amp;Kugeln</translation>
    </message>
    <message>
        <source>Shows the fabrics of the library on balls</source>
        <translation>Zeigt die Stoffe der Bibliothek auf Kugeln</translation>
    </message>
    <message>
        <source>&amp;Show colourway</source>
        <translation>Farbvariante &amp;zeigen</translation>
    </message>
    <message>
        <source>Chooses which fabrics are seen; the shape stays</source>
        <translation>Wählt, welche Stoffe zu sehen sind; die Form bleibt</translation>
    </message>
    <message>
        <source>New &amp;colourway …</source>
        <translation>Neue &amp;Farbvariante …</translation>
    </message>
    <message>
        <source>Adds a set of fabrics for the patches; it begins as what is shown now</source>
        <translation>Fügt einen Satz von Stoffen für die Schnittteile hinzu; er beginnt mit dem, was jetzt zu sehen ist</translation>
    </message>
    <message>
        <source>Rena&amp;me colourway …</source>
        <translation>Farbvariante u&amp;mbenennen …</translation>
    </message>
    <message>
        <source>Gives the colourway that is shown another name</source>
        <translation>Gibt der gezeigten Farbvariante einen anderen Namen</translation>
    </message>
    <message>
        <source>De&amp;lete colourway</source>
        <translation>Farbvariante lös&amp;chen</translation>
    </message>
    <message>
        <source>Removes the colourway that is shown</source>
        <translation>Entfernt die gezeigte Farbvariante</translation>
    </message>
    <message>
        <source>Compare c&amp;olourways …</source>
        <translation>Farbvarianten ver&amp;gleichen …</translation>
    </message>
    <message>
        <source>Shows two colourways side by side</source>
        <translation>Zeigt zwei Farbvarianten nebeneinander</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>Wie gefertigt</translation>
    </message>
</context>
<context>
    <name>FabricPresets</name>
    <message>
        <source>Leather, cognac</source>
        <translation>Leder, cognac</translation>
    </message>
    <message>
        <source>Leather, black</source>
        <translation>Leder, schwarz</translation>
    </message>
    <message>
        <source>Leather, cream</source>
        <translation>Leder, creme</translation>
    </message>
    <message>
        <source>Smooth leather, dark brown</source>
        <translation>Glattleder, dunkelbraun</translation>
    </message>
    <message>
        <source>Smooth leather, red</source>
        <translation>Glattleder, rot</translation>
    </message>
    <message>
        <source>Weave, grey</source>
        <translation>Gewebe, grau</translation>
    </message>
    <message>
        <source>Weave, blue</source>
        <translation>Gewebe, blau</translation>
    </message>
    <message>
        <source>Weave, sand</source>
        <translation>Gewebe, sand</translation>
    </message>
    <message>
        <source>Velvet, green</source>
        <translation>Samt, grün</translation>
    </message>
    <message>
        <source>Velvet, petrol</source>
        <translation>Samt, petrol</translation>
    </message>
    <message>
        <source>Checker, 20 mm</source>
        <translation>Karo, 20 mm</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Einfarbig</translation>
    </message>
</context>
<context>
    <name>FancySeamForm</name>
    <message>
        <source>Patch</source>
        <translation>Schnittteil</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>It stands out: a welt.</source>
        <translation>Sie steht vor: ein Wulst.</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>Patch</source>
        <translation>Schnittteil</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Stoff</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Stoffe</translation>
    </message>
    <message>
        <source>Press harder</source>
        <translation>Drücken stärker</translation>
    </message>
    <message>
        <source>Press like straight ones</source>
        <translation>Drücken wie gerade</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Gestell</translation>
    </message>
    <message>
        <source>Padded parts</source>
        <translation>Gepolsterte Teile</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Drückt</translation>
    </message>
    <message>
        <source>Smallest detail</source>
        <translation>Kleinste Einzelheit</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>Polster</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Slanted faces</source>
        <translation>Schräge Flächen</translation>
    </message>
    <message>
        <source>Pushes the cover</source>
        <translation>Drückt den Bezug</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Einfarbig</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>Smooth leather</source>
        <translation>Glattleder</translation>
    </message>
    <message>
        <source>Grained leather</source>
        <translation>Genarbtes Leder</translation>
    </message>
    <message>
        <source>Woven</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Velvet</source>
        <translation>Samt</translation>
    </message>
    <message>
        <source>Picture …</source>
        <translation>Bild …</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Second colour</source>
        <translation>Zweite Farbe</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Turned from the grain</source>
        <translation>Zum Fadenlauf gedreht</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>Relief</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Most along the grain</source>
        <translation>Höchstens in Fadenrichtung</translation>
    </message>
    <message>
        <source>Most across</source>
        <translation>Höchstens quer dazu</translation>
    </message>
    <message>
        <source>Most shear</source>
        <translation>Höchste Scherung</translation>
    </message>
    <message>
        <source>Poisson</source>
        <translation>Querkontraktion</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Bending length</source>
        <translation>Biegelänge</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Strain limits</source>
        <translation>Dehnungsgrenzen</translation>
    </message>
    <message>
        <source>Mirror twin</source>
        <translation>Spiegelzwilling</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>On the curve</source>
        <translation>Auf der Kurve</translation>
    </message>
    <message>
        <source>Curve runs backwards</source>
        <translation>Kurve läuft rückwärts</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Curve in space</source>
        <translation>Kurve im Raum</translation>
    </message>
    <message>
        <source>Round – a soft groove</source>
        <translation>Rund – eine weiche Rinne</translation>
    </message>
    <message>
        <source>Sharp – a crease</source>
        <translation>Scharf – ein Falz</translation>
    </message>
    <message>
        <source>Welt – between creases</source>
        <translation>Wulst – zwischen Falzen</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Fadenlauf</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Wrong side out</source>
        <translation>Linke Seite außen</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Holz</translation>
    </message>
    <message>
        <source>Metal</source>
        <translation>Metall</translation>
    </message>
    <message>
        <source>Plastic</source>
        <translation>Kunststoff</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>Schaum</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Keeps the cover outside</source>
        <translation>Hält den Bezug außerhalb</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Hidden parts</source>
        <translation>Ausgeblendete Teile</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Cushion</source>
        <translation>Polsterung</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Herausgeschnitten</translation>
    </message>
    <message>
        <source>Along the normal</source>
        <translation>Entlang der Normalen</translation>
    </message>
    <message>
        <source>To the point itself</source>
        <translation>Zum Punkt selbst</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Fit the cover to it</source>
        <translation>Bezug daran anpassen</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Zug</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>C0 – an edge</source>
        <translation>C0 – mit Kante</translation>
    </message>
    <message>
        <source>C1 – smooth, texture too</source>
        <translation>C1 – glatt, auch das Muster</translation>
    </message>
    <message>
        <source>G1 – rounded</source>
        <translation>G1 – gerundet</translation>
    </message>
    <message>
        <source>First stretch</source>
        <translation>Erster Abschnitt</translation>
    </message>
    <message>
        <source>Second stretch</source>
        <translation>Zweiter Abschnitt</translation>
    </message>
    <message>
        <source>Second side runs backwards</source>
        <translation>Zweite Seite läuft rückwärts</translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>Mesh edges</source>
        <translation>Netzkanten</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>Colourway shown</source>
        <translation>Gezeigte Farbvariante</translation>
    </message>
    <message>
        <source>Begins at</source>
        <translation>Beginnt bei</translation>
    </message>
    <message>
        <source>Ends at</source>
        <translation>Endet bei</translation>
    </message>
    <message>
        <source>By length</source>
        <translation>Nach Länge</translation>
    </message>
    <message>
        <source>By parameter</source>
        <translation>Nach Parameter</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Single row</source>
        <translation>Eine Reihe</translation>
    </message>
    <message>
        <source>Twin rows</source>
        <translation>Zwei Reihen</translation>
    </message>
    <message>
        <source>Stitches</source>
        <translation>Stiche</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>Garn</translation>
    </message>
    <message>
        <source>Stitch length</source>
        <translation>Stichlänge</translation>
    </message>
    <message>
        <source>Distance from the seam</source>
        <translation>Abstand von der Naht</translation>
    </message>
    <message>
        <source>Thread width</source>
        <translation>Garnstärke</translation>
    </message>
    <message>
        <source>Radius (0: none)</source>
        <translation>Radius (0: keiner)</translation>
    </message>
    <message>
        <source>Seam allowance</source>
        <translation>Nahtzugabe</translation>
    </message>
    <message>
        <source>The cover dips into the seam</source>
        <translation>Der Bezug senkt sich in die Naht</translation>
    </message>
    <message>
        <source>Trim</source>
        <translation>Verzierung</translation>
    </message>
    <message>
        <source> mm per unit</source>
        <translation> mm je Einheit</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>The frame that is padded</source>
        <translation>Das Gestell, das gepolstert wird</translation>
    </message>
    <message>
        <source>Which cover the padding presses outwards</source>
        <translation>Welchen Bezug die Polsterung nach außen drückt</translation>
    </message>
    <message>
        <source>How finely the frame is looked at: what is thinner may stay without padding</source>
        <translation>Wie fein das Gestell betrachtet wird: Was dünner ist, bleibt vielleicht ohne Polsterung</translation>
    </message>
    <message>
        <source>How thick the padding around the frame is</source>
        <translation>Wie dick das Gestell gepolstert ist</translation>
    </message>
    <message>
        <source>How hard the padding presses the cover outwards; from about 2 on it gives no more</source>
        <translation>Wie stark die Polsterung den Bezug nach außen drückt; ab etwa 2 wird es nicht mehr</translation>
    </message>
    <message>
        <source>How padding presses that is aslant to width, depth and height: harder fills the cover more</source>
        <translation>Wie Polsterung drückt, die schräg zu Breite, Tiefe und Höhe liegt: stärker füllt den Bezug mehr aus</translation>
    </message>
    <message>
        <source>How thick the padding around this foam is</source>
        <translation>Wie dick dieser Schaumstoff gepolstert ist</translation>
    </message>
    <message>
        <source>How hard this foam presses the cover outwards; from about 2 on it gives no more</source>
        <translation>Wie stark dieser Schaumstoff den Bezug nach außen drückt; ab etwa 2 wird es nicht mehr</translation>
    </message>
    <message>
        <source>Takes this shape out of the cushion instead of adding it</source>
        <translation>Nimmt diese Form aus der Polsterung heraus, statt sie hinzuzufügen</translation>
    </message>
    <message>
        <source>as made</source>
        <translation>wie gefertigt</translation>
    </message>
    <message>
        <source>Stitching</source>
        <translation>Steppung</translation>
    </message>
    <message>
        <source>Thread colour</source>
        <translation>Garnfarbe</translation>
    </message>
    <message>
        <source>Stitch distance</source>
        <translation>Abstand der Stiche</translation>
    </message>
    <message>
        <source>Piping radius</source>
        <translation>Radius des Keders</translation>
    </message>
    <message>
        <source>Piping fabric</source>
        <translation>Stoff des Keders</translation>
    </message>
    <message>
        <source>Valley</source>
        <translation>Mulde</translation>
    </message>
    <message>
        <source>Mitred – to a point</source>
        <translation>Auf Gehrung – spitz</translation>
    </message>
    <message>
        <source>Square – cut off</source>
        <translation>Gerade abgeschnitten</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>Abgerundet</translation>
    </message>
    <message>
        <source>Folded – lies under the piece</source>
        <translation>Umgelegt – liegt unter dem Teil</translation>
    </message>
    <message>
        <source>Stepped</source>
        <translation>Gestuft</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Zugabe</translation>
    </message>
    <message>
        <source>From the sewing line to the line where the fabric is cut.</source>
        <translation>Von der Nahtlinie bis zu der Linie, an der der Stoff geschnitten wird.</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Corners of the cut line</source>
        <translation>Ecken der Schnittlinie</translation>
    </message>
    <message>
        <source>as the design&apos;s</source>
        <translation>wie im Entwurf</translation>
    </message>
    <message>
        <source>Lies at</source>
        <translation>Liegt bei</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Schlitz</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Castle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>Knips</translation>
    </message>
    <message>
        <source>Depth of notches</source>
        <translation>Tiefe der Knipse</translation>
    </message>
    <message>
        <source>Width of notches</source>
        <translation>Breite der Knipse</translation>
    </message>
    <message>
        <source>Notches along seams every</source>
        <translation>Knipse entlang von Nähten alle</translation>
    </message>
    <message>
        <source>Notches at ends of seams</source>
        <translation>Knipse an Enden von Nähten</translation>
    </message>
    <message>
        <source>Notches that tell halves apart</source>
        <translation>Knipse, die Hälften unterscheiden</translation>
    </message>
    <message>
        <source>Two side by side</source>
        <translation>Zwei nebeneinander</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Zuschnitt</translation>
    </message>
    <message>
        <source>Label at</source>
        <translation>Beschriftung bei</translation>
    </message>
    <message>
        <source>Label turned by</source>
        <translation>Beschriftung gedreht um</translation>
    </message>
    <message>
        <source>Two ways – either end up</source>
        <translation>Beide Richtungen – jedes Ende oben</translation>
    </message>
    <message>
        <source>One way – one end up</source>
        <translation>Eine Richtung – ein Ende oben</translation>
    </message>
    <message>
        <source>Any direction</source>
        <translation>Jede Richtung</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Stückzahl</translation>
    </message>
    <message>
        <source>Mirrored pair</source>
        <translation>Gespiegeltes Paar</translation>
    </message>
    <message>
        <source>Nap</source>
        <translation>Strichrichtung</translation>
    </message>
    <message>
        <source>Grain may be off by</source>
        <translation>Fadenlauf darf abweichen um</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>where it finds room</source>
        <translation>wo Platz ist</translation>
    </message>
    <message>
        <source>Usable width</source>
        <translation>Nutzbare Breite</translation>
    </message>
    <message>
        <source>Shrinks along</source>
        <translation>Schrumpft längs</translation>
    </message>
    <message>
        <source>Pieces are cut so much larger along the grain that they have their size when the fabric has shrunk.</source>
        <translation>Teile werden längs zum Fadenlauf um so viel größer geschnitten, dass sie ihr Maß haben, wenn der Stoff geschrumpft ist.</translation>
    </message>
    <message>
        <source>Shrinks across</source>
        <translation>Schrumpft quer</translation>
    </message>
    <message>
        <source>10 mm</source>
        <translation>10 mm</translation>
    </message>
    <message>
        <source>Automatic notches</source>
        <translation>Automatische Knipse</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Artikel</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Gezeichnet</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Geschnitten</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Weggelassen</translation>
    </message>
    <message>
        <source>On the cutting table</source>
        <translation>Auf dem Zuschneidetisch</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Hilfslinie</translation>
    </message>
    <message>
        <source>Top stitching</source>
        <translation>Steppnaht</translation>
    </message>
    <message>
        <source>Tie-down strip</source>
        <translation>Abspannstreifen</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Falz</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>Zweck</translation>
    </message>
    <message>
        <source>Ease wanted</source>
        <translation>Gewünschte Mehrweite</translation>
    </message>
    <message>
        <source>How much longer the second side shall be than the first one: it is gathered when it is sewn.</source>
        <translation>Um wie viel länger die zweite Seite als die erste sein soll: sie wird beim Nähen eingehalten.</translation>
    </message>
    <message>
        <source>Bulge of the allowance</source>
        <translation>Wulst der Nahtzugabe</translation>
    </message>
    <message>
        <source>With a zip</source>
        <translation>Mit Reißverschluss</translation>
    </message>
    <message>
        <source>A zip joins the two sides; the sewing sheet tells its length.</source>
        <translation>Ein Reißverschluss verbindet die beiden Seiten; der Nähplan nennt seine Länge.</translation>
    </message>
    <message>
        <source>Step in sewing</source>
        <translation>Schritt beim Nähen</translation>
    </message>
    <message>
        <source>Seams with a number are sewn first, smaller ones before larger ones. 0: as the program proposes it.</source>
        <translation>Nähte mit einer Zahl werden zuerst genäht, kleinere Zahlen vor größeren. 0: wie das Programm es vorschlägt.</translation>
    </message>
    <message>
        <source>How near a point of the scan must be to pull at the cover. What the scan has not seen stays as the pattern makes it.</source>
        <translation>Wie nah ein Punkt des Scans sein muss, um am Bezug zu ziehen. Was der Scan nicht gesehen hat, bleibt, wie der Schnitt es macht.</translation>
    </message>
    <message>
        <source>How firmly the scan pulls at the cover, against the pattern: more follows finer detail, and more of the noise.</source>
        <translation>Wie stark der Scan gegen den Schnitt am Bezug zieht: Mehr folgt feineren Einzelheiten und mehr vom Rauschen.</translation>
    </message>
    <message>
        <source>The cover is pulled to the scan. Without that it is only measured. Align the scan first.</source>
        <translation>Der Bezug wird zum Scan gezogen. Ohne das wird nur gemessen. Richten Sie den Scan zuerst aus.</translation>
    </message>
    <message>
        <source>To its surface: the cover may slide along it. To its points: it may not, which suits scans with few points.</source>
        <translation>Zur Oberfläche: Der Bezug darf an ihr entlang gleiten. Zu den Punkten: Er darf es nicht; das passt zu Scans mit wenigen Punkten.</translation>
    </message>
    <message>
        <source>For whoever works on the design: it changes neither the cover nor what is cut</source>
        <translation>Für alle, die am Entwurf arbeiten: ändert weder den Bezug noch was geschnitten wird</translation>
    </message>
    <message>
        <source>Line on the label</source>
        <translation>Zeile auf dem Etikett</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>A filling that presses from inside. 0.05 to 0.3 fills a cushion; at 1 most fabrics are stretched too far.</source>
        <translation>Eine Füllung, die von innen drückt. 0,05 bis 0,3 füllt ein Kissen; bei 1 werden die meisten Stoffe zu weit gedehnt.</translation>
    </message>
    <message>
        <source>How long the edges of the triangles are: shorter ones show smaller folds, and take longer.</source>
        <translation>Wie lang die Kanten der Dreiecke sind: Kürzere zeigen kleinere Falten und brauchen mehr Zeit.</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt verwendet</translation>
    </message>
    <message>
        <source>&amp;Unsaved work</source>
        <translation>Nicht &amp;gespeicherte Arbeit</translation>
    </message>
    <message>
        <source>Sa&amp;mples</source>
        <translation>Beis&amp;piele</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Save a &amp;copy</source>
        <translation>&amp;Kopie speichern</translation>
    </message>
    <message>
        <source>With &amp;everything …</source>
        <translation>Mit &amp;allem …</translation>
    </message>
    <message>
        <source>Without &amp;history …</source>
        <translation>Ohne &amp;Verlauf …</translation>
    </message>
    <message>
        <source>Without history and &amp;scans …</source>
        <translation>Ohne Verlauf und &amp;Scans …</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>Auf &amp;Gespeichertes zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Import frame …</source>
        <translation>Gestell &amp;importieren …</translation>
    </message>
    <message>
        <source>Impor&amp;t scan …</source>
        <translation>Scan imp&amp;ortieren …</translation>
    </message>
    <message>
        <source>&amp;Export surface …</source>
        <translation>Oberfläche &amp;exportieren …</translation>
    </message>
    <message>
        <source>Export &amp;picture …</source>
        <translation>&amp;Bild exportieren …</translation>
    </message>
    <message>
        <source>Ren&amp;der picture …</source>
        <translation>Bild be&amp;rechnen …</translation>
    </message>
    <message>
        <source>E&amp;xport pattern …</source>
        <translation>Schnitt e&amp;xportieren …</translation>
    </message>
    <message>
        <source>Import pattern (DX&amp;F, SVG) …</source>
        <translation>Schnitt importieren (DX&amp;F, SVG) …</translation>
    </message>
    <message>
        <source>Export cover (&amp;HTML, glTF, STL) …</source>
        <translation>Bezug exportieren (&amp;HTML, glTF, STL) …</translation>
    </message>
    <message>
        <source>Export foam &amp;body …</source>
        <translation>S&amp;chaumkörper exportieren …</translation>
    </message>
    <message>
        <source>Print view …</source>
        <translation>Ansicht drucken …</translation>
    </message>
</context>
<context>
    <name>FileFormats</name>
    <message>
        <source>Page for the customer</source>
        <translation>Seite für den Kunden</translation>
    </message>
    <message>
        <source>USDZ, for phones</source>
        <translation>USDZ, für Telefone</translation>
    </message>
    <message>
        <source>OBJ with materials</source>
        <translation>OBJ mit Materialien</translation>
    </message>
    <message>
        <source>STL, with a thickness</source>
        <translation>STL, mit einer Dicke</translation>
    </message>
    <message>
        <source>3MF, with a thickness</source>
        <translation>3MF, mit einer Dicke</translation>
    </message>
    <message>
        <source>STEP, curves alone</source>
        <translation>STEP, nur Kurven</translation>
    </message>
    <message>
        <source>STEP, of flat faces</source>
        <translation>STEP, aus ebenen Flächen</translation>
    </message>
</context>
<context>
    <name>FixationCurveForm</name>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
</context>
<context>
    <name>FixationDrawTool</name>
    <message>
        <source>A curve needs two points, a closed one three.</source>
        <translation>Eine Kurve braucht zwei Punkte, eine geschlossene drei.</translation>
    </message>
    <message>
        <source>Fixation %1</source>
        <translation>Fixierung %1</translation>
    </message>
    <message>
        <source>Click to close the curve</source>
        <translation>Klick schließt die Kurve</translation>
    </message>
    <message>
        <source>There is neither a frame nor the cover here: click on one, or type x, y, z.</source>
        <translation>Hier ist weder ein Gestell noch der Bezug: eines davon anklicken oder x, y, z tippen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no place: try 250, -100, 40</source>
        <translation>„%1“ ist kein Ort: zum Beispiel 250, -100, 40</translation>
    </message>
    <message>
        <source>Enter sets the point: x, y, z – without z it is as high as the last one</source>
        <translation>Eingabe setzt den Punkt: x, y, z – ohne z liegt er so hoch wie der letzte</translation>
    </message>
    <message>
        <source>Click on a frame to begin a fixation curve, or type x, y, z – drag turns the view, Esc ends the tool</source>
        <translation>Auf ein Gestell klicken, um eine Fixierkurve zu beginnen, oder x, y, z tippen – Ziehen dreht die Ansicht, Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>Click or type the next point, Enter ends, C closes – B makes it straight, Backspace takes a point back</source>
        <translation>Nächsten Punkt klicken oder tippen, Eingabe beendet, C schließt – B macht gerade, Rücktaste nimmt einen Punkt zurück</translation>
    </message>
    <message>
        <source>Click or type the next point, Enter ends, C closes – straight from point to point, whatever lies between: B makes it smooth along the surface, Backspace takes a point back</source>
        <translation>Nächsten Punkt klicken oder tippen, Eingabe beendet, C schließt – gerade von Punkt zu Punkt, was auch dazwischen liegt: B macht glatt an der Oberfläche entlang, Rücktaste nimmt einen Punkt zurück</translation>
    </message>
    <message>
        <source>&amp;Close the curve</source>
        <translation>Kurve &amp;schließen</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
</context>
<context>
    <name>FixationSeamForm</name>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>On the curve</source>
        <translation>Auf der Kurve</translation>
    </message>
</context>
<context>
    <name>FixationsLeft</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>They stay where they are. Drag their points onto the frame, or undo the change.</source>
        <translation>Sie bleiben, wo sie sind. Ziehen Sie ihre Punkte auf das Gestell, oder nehmen Sie die Änderung zurück.</translation>
    </message>
    <message numerus="yes">
        <source>%n fixation curve(s) no longer lie on the frame.</source>
        <translation>
            <numerusform>%n Fixierkurve liegt nicht mehr auf dem Gestell.</numerusform>
            <numerusform>%n Fixierkurven liegen nicht mehr auf dem Gestell.</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1”: its edge is up to %2 away</source>
        <translation>„%1“: Die Kante ist bis zu %2 entfernt</translation>
    </message>
    <message>
        <source>“%1”: up to %2</source>
        <translation>„%1“: bis zu %2</translation>
    </message>
    <message>
        <source>“%1”: more than %2</source>
        <translation>„%1“: mehr als %2</translation>
    </message>
</context>
<context>
    <name>FixingCommands</name>
    <message>
        <source>&amp;Create fixation curve</source>
        <translation>Fixierkurve an&amp;legen</translation>
    </message>
    <message>
        <source>Select two points of an outline first: what lies between them is fixed.</source>
        <translation>Wählen Sie zuerst zwei Punkte eines Umrisses: Was dazwischen liegt, wird fixiert.</translation>
    </message>
    <message>
        <source>Fixation %1</source>
        <translation>Fixierung %1</translation>
    </message>
    <message>
        <source>There is no surface of this patch yet on which the curve could lie.</source>
        <translation>Dieses Schnittteil hat noch keine Oberfläche, auf der die Kurve liegen könnte.</translation>
    </message>
</context>
<context>
    <name>FoamForm</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
</context>
<context>
    <name>FormPatternReport</name>
    <message numerus="yes">
        <source>(and %n more)</source>
        <translation>
            <numerusform>(und %n weitere)</numerusform>
            <numerusform>(und %n weitere)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n Teil</numerusform>
            <numerusform>%n Teile</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seams, whose sides are equally long</source>
        <translation>
            <numerusform>%n Naht, deren Seiten gleich lang sind</numerusform>
            <numerusform>%n Nähte, deren Seiten gleich lang sind</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seams, whose sides differ by %1 at most</source>
        <translation>
            <numerusform>%n Naht, deren Seiten sich um höchstens %1 unterscheiden</numerusform>
            <numerusform>%n Nähte, deren Seiten sich um höchstens %1 unterscheiden</numerusform>
        </translation>
    </message>
    <message>
        <source>Its cover at rest lies up to %1 beside the form, where nothing holds it: tick &quot;Keeps the cover outside&quot; at the frame, or hold it by a fixation.</source>
        <translation>Ihr Bezug liegt in Ruhe bis zu %1 neben der Form, wo ihn nichts hält: setzen Sie beim Gestell ein Häkchen bei „Hält den Bezug außerhalb“, oder halten Sie ihn mit einer Fixierung.</translation>
    </message>
    <message>
        <source>Its cover at rest lies up to %1 beside the form, where nothing holds it: hold it by a fixation, or give its pieces pressure.</source>
        <translation>Ihr Bezug liegt in Ruhe bis zu %1 neben der Form, wo ihn nichts hält: halten Sie ihn mit einer Fixierung, oder geben Sie seinen Teilen Druck.</translation>
    </message>
    <message>
        <source>Its cover is being solved …</source>
        <translation>Ihr Bezug wird berechnet …</translation>
    </message>
    <message>
        <source>Its cover does not come to rest.</source>
        <translation>Ihr Bezug kommt nicht zur Ruhe.</translation>
    </message>
    <message>
        <source>Its cover at rest is strained no more than the fabric may be.</source>
        <translation>Ihr Bezug in Ruhe ist nicht stärker gedehnt, als der Stoff es sein darf.</translation>
    </message>
    <message>
        <source>What counts is its cover at rest: %1</source>
        <translation>Was zählt, ist ihr Bezug in Ruhe: %1</translation>
    </message>
    <message>
        <source>Laid on the form by itself no piece is strained so much. Narrow tips and steps of a line do that, or mesh edges that are long for them.</source>
        <translation>Für sich auf die Form gelegt ist kein Teil so stark gedehnt. Das tun schmale Spitzen und Stufen einer Linie, oder Netzkanten, die für sie lang sind.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more are left out, too</source>
        <translation>
            <numerusform>und %n weiteres wird ebenfalls weggelassen</numerusform>
            <numerusform>und %n weitere werden ebenfalls weggelassen</numerusform>
        </translation>
    </message>
    <message>
        <source>Laid on the form by itself most strained: %1, %2 (rms), %3 within 99 % of its area, %4 where it is most</source>
        <translation>Für sich auf die Form gelegt am stärksten gedehnt: %1, %2 (quadratisches Mittel), %3 auf 99 % der Fläche, %4 an der stärksten Stelle</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces are strained by more than the fabric may be in more than a hundredth of their area (yellow): divide them, or cut them in there.</source>
        <translation>
            <numerusform>%n Teil ist auf mehr als einem Hundertstel seiner Fläche stärker gedehnt, als es der Stoff sein darf (gelb): Trennen Sie es oder schneiden Sie es dort ein.</numerusform>
            <numerusform>%n Teile sind auf mehr als einem Hundertstel ihrer Fläche stärker gedehnt, als es der Stoff sein darf (gelb): Trennen Sie sie oder schneiden Sie sie dort ein.</numerusform>
        </translation>
    </message>
    <message>
        <source>Its cover will have about %1 vertices, and is not solved here: with mesh edges of %2 it is.</source>
        <translation>Ihr Bezug wird etwa %1 Netzpunkte haben und wird hier nicht gerechnet: mit Netzkanten von %2 wird er es.</translation>
    </message>
    <message>
        <source>So that the cover does not sink into the frame, tick &quot;Keeps the cover outside&quot; at the frame.</source>
        <translation>Damit der Bezug nicht in das Gestell sinkt, setzen Sie beim Gestell ein Häkchen bei „Hält den Bezug außerhalb“.</translation>
    </message>
    <message>
        <source>With shorter mesh edges smaller pieces are divided, too.</source>
        <translation>Mit kürzeren Netzkanten werden auch kleinere Teile geteilt.</translation>
    </message>
    <message>
        <source>Tick &quot;where it would not lie flat&quot;: that finds where to divide them.</source>
        <translation>Setzen Sie ein Häkchen bei „wo sie nicht flach läge“: das findet, wo sie zu teilen sind.</translation>
    </message>
    <message>
        <source>The form is taken as %1 large. If that is wrong, import the file as a frame.</source>
        <translation>Die Form wird als %1 groß genommen. Wenn das falsch ist, importieren Sie die Datei als Gestell.</translation>
    </message>
</context>
<context>
    <name>FrameEdgeCommands</name>
    <message>
        <source>Fixation curve along an &amp;edge</source>
        <translation>Fixierkurve an einer &amp;Kante</translation>
    </message>
    <message>
        <source>Click an edge of a frame: of STEP and IGES the edges of its faces, exactly; of others where their triangles bend</source>
        <translation>Auf eine Kante eines Gestells klicken: bei STEP und IGES die Kanten der Flächen, genau; bei anderen dort, wo sich die Dreiecke knicken</translation>
    </message>
    <message>
        <source>Looking for the edges of the frames …</source>
        <translation>Die Kanten der Gestelle werden gesucht …</translation>
    </message>
    <message>
        <source>The frames have no edges: they are smooth everywhere, or are not read yet.</source>
        <translation>Die Gestelle haben keine Kanten: Sie sind überall glatt oder noch nicht gelesen.</translation>
    </message>
</context>
<context>
    <name>FrameEdgeTool</name>
    <message>
        <source>Fixation %1</source>
        <translation>Fixierung %1</translation>
    </message>
    <message>
        <source>Click an edge of a frame to make a fixation curve of it – drag turns the view, Esc ends the tool</source>
        <translation>Auf eine Kante eines Gestells klicken, um eine Fixierkurve daraus zu machen – Ziehen dreht die Ansicht, Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>Click to make a fixation curve of this edge – Ctrl takes it alone, without those in which it goes on smoothly</source>
        <translation>Klicken, um aus dieser Kante eine Fixierkurve zu machen – Strg nimmt sie allein, ohne die, in denen sie glatt weitergeht</translation>
    </message>
    <message>
        <source>There is no edge of a frame here. A curve of your own: Frame &gt; Draw fixation curve.</source>
        <translation>Hier ist keine Kante eines Gestells. Eine eigene Kurve: Gestell &gt; Fixierkurve zeichnen.</translation>
    </message>
</context>
<context>
    <name>FrameForm</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Choose an&amp;other file …</source>
        <translation>Andere Datei wäh&amp;len …</translation>
    </message>
    <message>
        <source>Colour of the frame</source>
        <translation>Farbe des Gestells</translation>
    </message>
</context>
<context>
    <name>FrameParts</name>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Piece %1: %2</source>
        <translation>Stück %1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n piece(s)</source>
        <translation>
            <numerusform>%1: %n Stück</numerusform>
            <numerusform>%1: %n Stücke</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>Show a&amp;ll parts</source>
        <translation>A&amp;lle Teile zeigen</translation>
    </message>
    <message>
        <source>Parts without a mark are left out: they are not drawn, and neither drawing along the frame nor cushioning nor contact knows them.</source>
        <translation>Teile ohne Haken werden weggelassen: Sie werden nicht gezeichnet, und weder das Zeichnen am Gestell noch Polsterung oder Kontakt berücksichtigen sie.</translation>
    </message>
    <message>
        <source>%1: not in this frame</source>
        <translation>%1: nicht in diesem Gestell</translation>
    </message>
    <message>
        <source>Padded parts</source>
        <translation>Gepolsterte Teile</translation>
    </message>
    <message>
        <source>Without a mark, those parts are padded that the cover is fixed to.</source>
        <translation>Ohne Haken werden die Teile gepolstert, an denen der Bezug befestigt ist.</translation>
    </message>
    <message>
        <source>This frame is large: the smallest detail can be %1 here.</source>
        <translation>Dieses Gestell ist groß: Die kleinste Einzelheit kann hier %1 sein.</translation>
    </message>
</context>
<context>
    <name>HandleCurveForm</name>
    <message>
        <source>Patch</source>
        <translation>Schnittteil</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>Im Schnitt</translation>
    </message>
    <message>
        <source>In space</source>
        <translation>Im Raum</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
</context>
<context>
    <name>HelpCommands</name>
    <message>
        <source>&amp;Find a command …</source>
        <translation>&amp;Befehl suchen …</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse …</source>
        <translation>&amp;Tasten und Maus …</translation>
    </message>
    <message>
        <source>&amp;Edit shortcuts …</source>
        <translation>Tastenkürzel &amp;bearbeiten …</translation>
    </message>
    <message>
        <source>&amp;About Bolster</source>
        <translation>Ü&amp;ber Bolster</translation>
    </message>
</context>
<context>
    <name>HelpDialogs</name>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>click; Shift+click adds; drag a box</source>
        <translation>Klick; Umschalt+Klick fügt hinzu; Rahmen aufziehen</translation>
    </message>
    <message>
        <source>Move control points or patches</source>
        <translation>Kontrollpunkte oder Schnittteile verschieben</translation>
    </message>
    <message>
        <source>drag; Shift keeps to one axis; Esc takes it back</source>
        <translation>ziehen; Umschalt hält eine Achse; Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Turn patches</source>
        <translation>Schnittteile drehen</translation>
    </message>
    <message>
        <source>drag the round handle; Shift in steps of 15°</source>
        <translation>am runden Griff ziehen; Umschalt in Schritten von 15°</translation>
    </message>
    <message>
        <source>Add a control point</source>
        <translation>Kontrollpunkt einfügen</translation>
    </message>
    <message>
        <source>arrow keys, Shift+arrow keys</source>
        <translation>Pfeiltasten, Umschalt+Pfeiltasten</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Ansicht verschieben</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Ansicht drehen</translation>
    </message>
    <message>
        <source>A workbench for people who design upholstered furniture and car seats: a sewing pattern, its seams and its fixation on the frame become the cover, live.</source>
        <translation>Eine Werkbank für alle, die Polstermöbel und Autositze entwerfen: aus dem Schnitt, seinen Nähten und der Fixierung am Gestell wird der Bezug, live.</translation>
    </message>
    <message>
        <source>The surface is computed after the published method of sewing patterns on static constraints; docs/solver.md names the paper and what is different.</source>
        <translation>Die Oberfläche wird nach dem veröffentlichten Verfahren berechnet; docs/solver.md nennt den Aufsatz und was hier anders ist.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. It comes without any warranty. Built with Qt, Eigen, CGAL, SuiteSparse, Embree and OpenImageIO.</source>
        <translation>Freie Software unter der GNU General Public License, Version 3 oder neuer. Ohne jede Gewährleistung. Gebaut mit Qt, Eigen, CGAL, SuiteSparse, Embree und OpenImageIO.</translation>
    </message>
    <message>
        <source>About Bolster</source>
        <translation>Über Bolster</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>Im Schnitt</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>In der 3D-Ansicht</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Patches, seams</source>
        <translation>Schnittteile, Nähte</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Vertices after sewing</source>
        <translation>Netzpunkte nach dem Nähen</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Vertices held by fixations</source>
        <translation>Fixierte Netzpunkte</translation>
    </message>
    <message>
        <source>Sewn pairs</source>
        <translation>Vernähte Paare</translation>
    </message>
    <message>
        <source>Largest gap at seams</source>
        <translation>Größte Lücke an Nähten</translation>
    </message>
    <message>
        <source>Largest distance from fixations</source>
        <translation>Größter Abstand von Fixierungen</translation>
    </message>
    <message>
        <source>Curves to fixed outlines between vertices</source>
        <translation>Kurven zu fixierten Umrissen zwischen Netzpunkten</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>Area of the cover, of the pattern</source>
        <translation>Fläche des Bezugs, des Schnitts</translation>
    </message>
    <message>
        <source>Turned triangles</source>
        <translation>Umgeklappte Dreiecke</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Triangulation</source>
        <translation>Triangulierung</translation>
    </message>
    <message>
        <source>Assembly and factorisation</source>
        <translation>Aufstellen und Faktorisieren</translation>
    </message>
    <message>
        <source>One iteration</source>
        <translation>Ein Schritt</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Computation</source>
        <translation>Berechnung</translation>
    </message>
    <message>
        <source>Figures of the surface</source>
        <translation>Zahlen zur Oberfläche</translation>
    </message>
    <message>
        <source>Strain: root mean square, 99 %, largest</source>
        <translation>Dehnung: quadratisches Mittel, 99 %, größte</translation>
    </message>
    <message>
        <source>double click on an outline or curve</source>
        <translation>Doppelklick auf einen Umriss oder eine Kurve</translation>
    </message>
    <message>
        <source>Draw a handle curve or a fancy seam</source>
        <translation>Griffkurve oder Ziernaht zeichnen</translation>
    </message>
    <message>
        <source>click points; Enter or double click ends; click the first one to close; B: straight or smooth</source>
        <translation>Punkte anklicken; Eingabe oder Doppelklick beendet; Klick auf den ersten schließt; B: gerade oder rund</translation>
    </message>
    <message>
        <source>Move control points of curves</source>
        <translation>Kontrollpunkte von Kurven verschieben</translation>
    </message>
    <message>
        <source>Sew</source>
        <translation>Nähen</translation>
    </message>
    <message>
        <source>click two edges; drag or Shift+click takes a part of one; Ctrl+click several in a row, Enter sews them; F: flip</source>
        <translation>zwei Kanten anklicken; Ziehen oder Umschalt+Klick nimmt einen Teil; Strg+Klick mehrere in einer Reihe, Eingabe näht sie; F: umkehren</translation>
    </message>
    <message>
        <source>Attach to the selected fixation curve</source>
        <translation>An die gewählte Fixierkurve befestigen</translation>
    </message>
    <message>
        <source>Draw an outline</source>
        <translation>Umriss zeichnen</translation>
    </message>
    <message>
        <source>click corners, drag smooth points, or type 500, 500&lt;30 or 120, 40; Enter or a click on the first point closes</source>
        <translation>Ecken klicken, glatte Punkte ziehen oder 500, 500&lt;30 oder 120, 40 tippen; Enter oder ein Klick auf den ersten Punkt schließt</translation>
    </message>
    <message>
        <source>Not snapped</source>
        <translation>Ohne Einrasten</translation>
    </message>
    <message>
        <source>hold Ctrl or Alt</source>
        <translation>Strg oder Alt halten</translation>
    </message>
    <message>
        <source>Select in a loop</source>
        <translation>In einer Schlinge auswählen</translation>
    </message>
    <message>
        <source>Alt and drag</source>
        <translation>Alt und ziehen</translation>
    </message>
    <message>
        <source>Next patch or control point, previous one</source>
        <translation>Nächstes Schnittteil oder nächster Kontrollpunkt, voriges</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Umschalt+Tab</translation>
    </message>
    <message>
        <source>drag; those on a frame stay on it: Ctrl lifts them off, S lets go; X, Y, Z keep to an axis</source>
        <translation>ziehen; solche auf einem Gestell bleiben darauf: Strg hebt sie ab, S löst sie; X, Y, Z halten eine Achse ein</translation>
    </message>
    <message>
        <source>Draw a fixation curve</source>
        <translation>Fixierkurve zeichnen</translation>
    </message>
    <message>
        <source>click points on a frame; Enter or double click ends; click the first one to close</source>
        <translation>Punkte auf einem Gestell klicken; Eingabe oder Doppelklick beendet; auf den ersten klicken schließt</translation>
    </message>
    <message>
        <source>Move the ends of a seam or fixation</source>
        <translation>Enden einer Naht oder Fixierung verschieben</translation>
    </message>
    <message>
        <source>select it and drag the round handles at its ends</source>
        <translation>auswählen und die runden Griffe an ihren Enden ziehen</translation>
    </message>
    <message>
        <source>Stitch or pipe a seam or an edge</source>
        <translation>Naht oder Kante absteppen oder mit Keder versehen</translation>
    </message>
    <message>
        <source>click it; stitches and piping are in the properties</source>
        <translation>anklicken; Stiche und Keder stehen bei den Eigenschaften</translation>
    </message>
    <message>
        <source>Select an edge</source>
        <translation>Kante auswählen</translation>
    </message>
    <message>
        <source>click the outline; drag it then to move it; L types its length</source>
        <translation>auf den Umriss klicken; danach verschiebt Ziehen sie; mit L die Länge eintippen</translation>
    </message>
    <message>
        <source>Commands for what lies there</source>
        <translation>Befehle für das, was dort liegt</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>rechte Taste</translation>
    </message>
    <message>
        <source>A number instead of a drag</source>
        <translation>Eine Zahl eingeben, statt zu ziehen</translation>
    </message>
    <message>
        <source>type it while dragging: 50, 30, 20, for sizes 300 x 200 or 120 %; Enter lets go</source>
        <translation>beim Ziehen tippen: 50 oder 30, 20, für Größen 300 x 200 oder 120 %; Eingabe lässt los</translation>
    </message>
    <message>
        <source>click edges; Shift+click collects several; Esc ends</source>
        <translation>auf Kanten klicken; Umschalt+Klick sammelt mehrere; Esc beendet</translation>
    </message>
    <message>
        <source>right button, without a drag</source>
        <translation>rechte Taste, ohne zu ziehen</translation>
    </message>
    <message>
        <source>Move by %1, by %2</source>
        <translation>Um %1, um %2 verschieben</translation>
    </message>
    <message>
        <source>%1, or Space and drag</source>
        <translation>%1 oder Leertaste und ziehen</translation>
    </message>
    <message>
        <source>%1, or drag beside the cover</source>
        <translation>%1 oder neben dem Bezug ziehen</translation>
    </message>
</context>
<context>
    <name>Insert</name>
    <message>
        <source>Padding</source>
        <translation>Polster</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>Schaum</translation>
    </message>
    <message>
        <source>This frame is large: its smallest detail is set to %1; the usual %2 would need too much memory.</source>
        <translation>Dieses Gestell ist groß: Die kleinste Einzelheit ist auf %1 gesetzt; die üblichen %2 würden zu viel Speicher brauchen.</translation>
    </message>
</context>
<context>
    <name>InsertCommands</name>
    <message>
        <source>&amp;Cushion</source>
        <translation>&amp;Polsterung</translation>
    </message>
    <message>
        <source>&amp;Box of foam</source>
        <translation>&amp;Quader aus Schaum</translation>
    </message>
    <message>
        <source>C&amp;ylinder of foam</source>
        <translation>&amp;Zylinder aus Schaum</translation>
    </message>
    <message>
        <source>&amp;Sphere of foam</source>
        <translation>&amp;Kugel aus Schaum</translation>
    </message>
    <message>
        <source>Foam belongs to a cushion: insert one first.</source>
        <translation>Schaum gehört zu einer Polsterung: fügen Sie zuerst eine ein.</translation>
    </message>
    <message>
        <source>Cushioning needs a frame: import one first.</source>
        <translation>Eine Polsterung braucht ein Gestell: importieren Sie zuerst eines.</translation>
    </message>
</context>
<context>
    <name>InspectorForms</name>
    <message numerus="yes">
        <source>%n elements</source>
        <translation>
            <numerusform>%n Element</numerusform>
            <numerusform>%n Elemente</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>InternalLineForm</name>
    <message>
        <source>Patch</source>
        <translation>Schnittteil</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
</context>
<context>
    <name>InverseCommands</name>
    <message>
        <source>From a form …</source>
        <translation>Aus einer Form …</translation>
    </message>
    <message>
        <source>Cuts a frame, a mesh or the cover into pieces, lays them flat and makes the pattern of them</source>
        <translation>Zerlegt ein Gestell, ein Netz oder den Bezug in Teile, legt sie flach und macht daraus den Schnitt</translation>
    </message>
    <message>
        <source>F&amp;it to a goal …</source>
        <translation>An ein &amp;Ziel anpassen …</translation>
    </message>
    <message>
        <source>Changes the pattern until the cover lies on a scan, or is strained less</source>
        <translation>Ändert den Schnitt, bis der Bezug auf einem Scan liegt oder weniger gedehnt ist</translation>
    </message>
    <message>
        <source>Relieve strain …</source>
        <translation>Dehnung abbauen …</translation>
    </message>
    <message>
        <source>Proposes changes of the pattern where cloth is strained too much, with what each gains</source>
        <translation>Schlägt Änderungen am Schnitt vor, wo der Stoff zu stark gedehnt ist, und sagt, was jede bringt</translation>
    </message>
    <message>
        <source>Why is it so? …</source>
        <translation>Woran liegt es? …</translation>
    </message>
    <message>
        <source>Which cause explains best how far the scan of a built piece lies from the cover</source>
        <translation>Welche Ursache am besten erklärt, wie weit der Scan eines gebauten Stücks vom Bezug abweicht</translation>
    </message>
    <message>
        <source>Tolerances …</source>
        <translation>Toleranzen …</translation>
    </message>
    <message>
        <source>Where the cover varies from piece to piece, and which tolerance of making matters</source>
        <translation>Wo der Bezug von Stück zu Stück schwankt, und auf welche Toleranz der Fertigung es ankommt</translation>
    </message>
</context>
<context>
    <name>KeptMeasure</name>
    <message>
        <source>Measurement %1</source>
        <translation>Maß %1</translation>
    </message>
</context>
<context>
    <name>KeyPresets</name>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>CLO, Marvelous Designer</source>
        <translation>CLO, Marvelous Designer</translation>
    </message>
</context>
<context>
    <name>LabelDrag</name>
    <message>
        <source>Drag the label to where it can be read – Shift keeps to one axis, Ctrl does not snap, Esc takes it back</source>
        <translation>Ziehen Sie die Beschriftung dorthin, wo man sie lesen kann – Umschalt bleibt auf einer Achse, Strg rastet nicht ein, Esc nimmt es zurück</translation>
    </message>
</context>
<context>
    <name>LayerCommands</name>
    <message>
        <source>La&amp;yers</source>
        <translation>&amp;Ebenen</translation>
    </message>
    <message>
        <source>&amp;Triangulation</source>
        <translation>&amp;Triangulierung</translation>
    </message>
    <message>
        <source>Chec&amp;ker</source>
        <translation>Karo&amp;muster</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>&amp;Gestell</translation>
    </message>
    <message>
        <source>Control po&amp;ints</source>
        <translation>&amp;Kontrollpunkte</translation>
    </message>
    <message>
        <source>Sea&amp;ms and fixations</source>
        <translation>&amp;Nähte und Fixierungen</translation>
    </message>
    <message>
        <source>Fixation c&amp;urves</source>
        <translation>&amp;Fixierkurven</translation>
    </message>
    <message>
        <source>&amp;Handle curves</source>
        <translation>&amp;Griffkurven</translation>
    </message>
    <message>
        <source>Fanc&amp;y seams</source>
        <translation>Zie&amp;rnähte</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Beschriftungen</translation>
    </message>
    <message>
        <source>Sca&amp;ns</source>
        <translation>S&amp;cans</translation>
    </message>
    <message>
        <source>Gr&amp;ound</source>
        <translation>B&amp;oden</translation>
    </message>
    <message>
        <source>Cushionin&amp;g</source>
        <translation>Po&amp;lsterung</translation>
    </message>
    <message>
        <source>Mirror image of the &amp;selection</source>
        <translation>S&amp;piegelbild der Auswahl</translation>
    </message>
    <message>
        <source>Symmetry &amp;axis and plane</source>
        <translation>S&amp;ymmetrieachse und -ebene</translation>
    </message>
    <message>
        <source>Pairs of co&amp;ver and scan</source>
        <translation>Paare von &amp;Bezug und Scan</translation>
    </message>
    <message>
        <source>Own &amp;colours of scans</source>
        <translation>Eigene &amp;Farben der Scans</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Raster</translation>
    </message>
    <message>
        <source>Cut lines, notches and la&amp;bels</source>
        <translation>Schnittlinien, Knipse und &amp;Beschriftungen</translation>
    </message>
    <message>
        <source>M&amp;easurements</source>
        <translation>Ma&amp;ße</translation>
    </message>
</context>
<context>
    <name>MainMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Pattern</source>
        <translation>&amp;Schnitt</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>&amp;Oberfläche</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Sea&amp;m</source>
        <translation>Na&amp;ht</translation>
    </message>
    <message>
        <source>F&amp;rame</source>
        <translation>&amp;Gestell</translation>
    </message>
    <message>
        <source>F&amp;abric</source>
        <translation>S&amp;toff</translation>
    </message>
    <message>
        <source>S&amp;can</source>
        <translation>S&amp;can</translation>
    </message>
</context>
<context>
    <name>ManualCommands</name>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>The page about what you are at</source>
        <translation>Die Seite zu dem, was Sie gerade tun</translation>
    </message>
    <message>
        <source>The manual is not installed.</source>
        <translation>Das Handbuch ist nicht installiert.</translation>
    </message>
    <message>
        <source>It is a folder &quot;manual&quot; with the program&apos;s other files.</source>
        <translation>Es ist ein Ordner „manual“ bei den übrigen Dateien des Programms.</translation>
    </message>
</context>
<context>
    <name>MapCommands</name>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Karte</translation>
    </message>
    <message>
        <source>&amp;Largest strain</source>
        <translation>&amp;Größte Dehnung</translation>
    </message>
    <message>
        <source>Strain al&amp;ong the grain</source>
        <translation>Dehnung &amp;längs des Fadenlaufs</translation>
    </message>
    <message>
        <source>Strain a&amp;cross the grain</source>
        <translation>Dehnung &amp;quer zum Fadenlauf</translation>
    </message>
    <message>
        <source>&amp;Shear</source>
        <translation>&amp;Scherung</translation>
    </message>
    <message>
        <source>&amp;Mean curvature</source>
        <translation>&amp;Mittlere Krümmung</translation>
    </message>
    <message>
        <source>Distance to the &amp;frame</source>
        <translation>Abstand zum G&amp;estell</translation>
    </message>
    <message>
        <source>&amp;Deviation from the scan</source>
        <translation>A&amp;bweichung vom Scan</translation>
    </message>
    <message>
        <source>&amp;Worst spots</source>
        <translation>&amp;Schlimmste Stellen</translation>
    </message>
    <message>
        <source>Show worst spots as a l&amp;ist</source>
        <translation>Schlimmste Stellen als L&amp;iste zeigen</translation>
    </message>
    <message>
        <source>Show this place in both windows</source>
        <translation>Diese Stelle in beiden Fenstern zeigen</translation>
    </message>
    <message>
        <source>Choose a map of strain first</source>
        <translation>Zuerst eine Karte der Dehnung wählen</translation>
    </message>
</context>
<context>
    <name>MarkDrag</name>
    <message>
        <source>Drag it to where it belongs – Esc takes it back</source>
        <translation>Dorthin ziehen, wo es hingehört – Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Allowance of %1 – or type it; Ctrl for any width, Esc takes it back</source>
        <translation>Zugabe %1 – oder tippen Sie sie; Strg für jede Breite, Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Drag it to where it belongs, or type its place: 120, 40 – Esc takes it back</source>
        <translation>Dorthin ziehen, wo es hingehört, oder die Stelle tippen: 120; 40 – Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Drag it along the outline, or type how far it is from the corner – Esc takes it back</source>
        <translation>Am Umriss entlang ziehen, oder tippen, wie weit es von der Ecke ist – Esc nimmt es zurück</translation>
    </message>
</context>
<context>
    <name>MeasureTool</name>
    <message>
        <source>dx %1, dy %2</source>
        <translation>dx %1, dy %2</translation>
    </message>
    <message>
        <source>This edge is %1 long – click for a point to measure from</source>
        <translation>Diese Kante ist %1 lang – klicken, um von einem Punkt aus zu messen</translation>
    </message>
    <message>
        <source>Edge: %1</source>
        <translation>Kante: %1</translation>
    </message>
    <message>
        <source>Only a measurement between two points of patches can be kept.</source>
        <translation>Behalten lässt sich nur ein Maß zwischen zwei Punkten von Schnittteilen.</translation>
    </message>
    <message>
        <source>&amp;Keep the measurement</source>
        <translation>Maß &amp;behalten</translation>
    </message>
    <message>
        <source>%1 – Enter keeps the measurement, a click begins anew</source>
        <translation>%1 – Eingabe behält das Maß, ein Klick beginnt neu</translation>
    </message>
    <message>
        <source>Click two points of the pattern or of the cover to measure, or point at an outline – Esc ends the tool</source>
        <translation>Zwei Punkte des Schnitts oder des Bezugs zum Messen anklicken oder auf einen Umriss zeigen – Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>%1 – a click begins anew</source>
        <translation>%1 – ein Klick beginnt neu</translation>
    </message>
</context>
<context>
    <name>MeasurementForm</name>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>Im Schnitt</translation>
    </message>
    <message>
        <source>two patches</source>
        <translation>zwei Schnittteile</translation>
    </message>
    <message>
        <source>On the cover</source>
        <translation>Auf dem Bezug</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>noch nicht</translation>
    </message>
</context>
<context>
    <name>Message</name>
    <message>
        <source>the degree must be 1, 2 or 3, not %1</source>
        <translation>der Grad muss 1, 2 oder 3 sein, nicht %1</translation>
    </message>
    <message>
        <source>a closed curve needs at least %1 points, not %2</source>
        <translation>eine geschlossene Kurve braucht mindestens %1 Punkte, nicht %2</translation>
    </message>
    <message>
        <source>an open curve of this degree needs at least %1 points, not %2</source>
        <translation>eine offene Kurve dieses Grades braucht mindestens %1 Punkte, nicht %2</translation>
    </message>
    <message>
        <source>point %1 is no number or beyond 1e7 mm</source>
        <translation>Punkt %1 ist keine Zahl oder liegt jenseits von 1e7 mm</translation>
    </message>
    <message>
        <source>corners belong to closed curves of degree 3 only</source>
        <translation>Ecken gibt es nur bei geschlossenen Kurven vom Grad 3</translation>
    </message>
    <message>
        <source>the list of corners is empty; leave it out</source>
        <translation>die Liste der Ecken ist leer; lassen Sie sie weg</translation>
    </message>
    <message>
        <source>corner %1 does not exist; the points are numbered 0 to %2</source>
        <translation>Ecke %1 gibt es nicht; die Punkte haben die Nummern 0 bis %2</translation>
    </message>
    <message>
        <source>the corners must increase, but %1 follows %2</source>
        <translation>die Ecken müssen aufsteigen, aber %1 folgt auf %2</translation>
    </message>
    <message>
        <source>there must be at least two points between the corners %1 and %2 (a straight edge: at its thirds)</source>
        <translation>zwischen den Ecken %1 und %2 müssen mindestens zwei Punkte liegen (bei einer geraden Kante auf ihren Dritteln)</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text goes on after the design&apos;s last bracket; remove what follows</source>
        <translation>Zeile %1, Spalte %2: nach der letzten Klammer des Entwurfs geht der Text weiter; entfernen Sie, was folgt</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text ends in the middle of the design; the file is incomplete</source>
        <translation>Zeile %1, Spalte %2: der Text endet mitten im Entwurf; die Datei ist unvollständig</translation>
    </message>
    <message>
        <source>Line %1, column %2: brackets are nested more than 64 deep; no design needs that</source>
        <translation>Zeile %1, Spalte %2: die Klammern sind mehr als 64-fach verschachtelt; das braucht kein Entwurf</translation>
    </message>
    <message>
        <source>Line %1, column %2: a value is expected here: a number, a text in quotes, true, false or a bracket (NaN and Infinity are no numbers)</source>
        <translation>Zeile %1, Spalte %2: hier wird ein Wert erwartet: eine Zahl, ein Text in Anführungszeichen, true, false oder eine Klammer (NaN und Infinity sind keine Zahlen)</translation>
    </message>
    <message>
        <source>Line %1, column %2: a comma or &quot;]&quot; is missing here</source>
        <translation>Zeile %1, Spalte %2: hier fehlt ein Komma oder „]“</translation>
    </message>
    <message>
        <source>Line %1, column %2: a key in quotes is expected here</source>
        <translation>Zeile %1, Spalte %2: hier wird ein Schlüssel in Anführungszeichen erwartet</translation>
    </message>
    <message>
        <source>Line %1, column %2: a colon is missing after the key</source>
        <translation>Zeile %1, Spalte %2: nach dem Schlüssel fehlt ein Doppelpunkt</translation>
    </message>
    <message>
        <source>Line %1, column %2: a comma or &quot;}&quot; is missing here</source>
        <translation>Zeile %1, Spalte %2: hier fehlt ein Komma oder „}“</translation>
    </message>
    <message>
        <source>Line %1, column %2: a text in quotes must end on its line; a quote is missing</source>
        <translation>Zeile %1, Spalte %2: ein Text in Anführungszeichen muss auf seiner Zeile enden; ein Anführungszeichen fehlt</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is no valid escape; write a backslash as &quot;\\&quot;</source>
        <translation>Zeile %1, Spalte %2: das ist keine gültige Escape-Folge; schreiben Sie einen umgekehrten Schrägstrich als „\\“</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is not UTF-8; save the file in that encoding</source>
        <translation>Zeile %1, Spalte %2: das ist kein UTF-8; speichern Sie die Datei in dieser Kodierung</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text ends inside quotes; the file is incomplete</source>
        <translation>Zeile %1, Spalte %2: der Text endet zwischen Anführungszeichen; die Datei ist unvollständig</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is no number; write it like 12.5, -3 or 1e-3</source>
        <translation>Zeile %1, Spalte %2: das ist keine Zahl; schreiben Sie sie wie 12.5, -3 oder 1e-3</translation>
    </message>
    <message>
        <source>the text is larger than %1 MB; that is no design</source>
        <translation>der Text ist größer als %1 MB; das ist kein Entwurf</translation>
    </message>
    <message>
        <source>knot %1 occurs more often than %2 times, the degree; remove the surplus ones</source>
        <translation>der Knoten %1 kommt mehr als %2-mal vor (das ist der Grad); entfernen Sie die überzähligen</translation>
    </message>
    <message>
        <source>the knots of an open curve must begin with %1 equal ones and end with %1 equal, larger ones</source>
        <translation>die Knoten einer offenen Kurve müssen mit %1 gleichen beginnen und mit %1 gleichen, größeren enden</translation>
    </message>
    <message>
        <source>%1 points of degree %2 need %3 knots, not %4</source>
        <translation>%1 Punkte vom Grad %2 brauchen %3 Knoten, nicht %4</translation>
    </message>
    <message>
        <source>a knot is no number or beyond 1e7</source>
        <translation>ein Knoten ist keine Zahl oder liegt jenseits von 1e7</translation>
    </message>
    <message>
        <source>the knots must not decrease</source>
        <translation>die Knoten dürfen nicht abnehmen</translation>
    </message>
    <message>
        <source>the last knot must be larger than the first</source>
        <translation>der letzte Knoten muss größer sein als der erste</translation>
    </message>
    <message>
        <source>two knots near %1 are almost equal; make them equal</source>
        <translation>zwei Knoten bei %1 sind beinahe gleich; machen Sie sie gleich</translation>
    </message>
    <message>
        <source>there is not enough memory for this design</source>
        <translation>für diesen Entwurf reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>%1: the file promises more than it holds</source>
        <translation>%1: die Datei verspricht mehr, als sie enthält</translation>
    </message>
    <message>
        <source>%1: the mesh is too large, the limit is %2 points and as many triangles</source>
        <translation>%1: das Netz ist zu groß; die Grenze sind %2 Punkte und ebenso viele Dreiecke</translation>
    </message>
    <message>
        <source>%1: the point is not finite, or beyond 10,000,000</source>
        <translation>%1: der Punkt ist nicht endlich oder liegt jenseits von 10 000 000</translation>
    </message>
    <message>
        <source>%1: a face refers to point %2, but there are %3 points</source>
        <translation>%1: eine Fläche nennt den Punkt %2, aber es gibt %3 Punkte</translation>
    </message>
    <message>
        <source>%1: the mesh has too many groups, the limit is %2</source>
        <translation>%1: das Netz hat zu viele Gruppen; die Grenze ist %2</translation>
    </message>
    <message>
        <source>%1 holds no mesh</source>
        <translation>%1 enthält kein Netz</translation>
    </message>
    <message>
        <source>%1 holds points only; a frame needs faces between them</source>
        <translation>%1 enthält nur Punkte; ein Gestell braucht Flächen dazwischen</translation>
    </message>
    <message>
        <source>%1: points are counted from 1, not from 0</source>
        <translation>%1: die Punkte werden ab 1 gezählt, nicht ab 0</translation>
    </message>
    <message>
        <source>%1: the file ends too early</source>
        <translation>%1: die Datei endet zu früh</translation>
    </message>
    <message>
        <source>%1: the file does not begin with OFF</source>
        <translation>%1: die Datei beginnt nicht mit OFF</translation>
    </message>
    <message>
        <source>%1: binary OFF is not read; save it as text</source>
        <translation>%1: binäres OFF wird nicht gelesen; speichern Sie es als Text</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PLY number type</source>
        <translation>%1: „%2“ ist kein Zahlentyp von PLY</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PLY format</source>
        <translation>%1: „%2“ ist kein PLY-Format</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; cannot count a list</source>
        <translation>%1: „%2“ kann keine Liste zählen</translation>
    </message>
    <message>
        <source>%1: the file does not begin with &quot;ply&quot;</source>
        <translation>%1: die Datei beginnt nicht mit „ply“</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not expected in a PLY header</source>
        <translation>%1: „%2“ wird im Kopf einer PLY-Datei nicht erwartet</translation>
    </message>
    <message>
        <source>%1: a count is negative</source>
        <translation>%1: eine Anzahl ist negativ</translation>
    </message>
    <message>
        <source>%1: the points have no coordinate &quot;%2&quot;</source>
        <translation>%1: die Punkte haben keine Koordinate „%2“</translation>
    </message>
    <message>
        <source>%1: the faces have no list &quot;%2&quot;</source>
        <translation>%1: die Flächen haben keine Liste „%2“</translation>
    </message>
    <message>
        <source>%1: a number is missing</source>
        <translation>%1: eine Zahl fehlt</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a number</source>
        <translation>%1: „%2“ ist keine Zahl</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a whole number</source>
        <translation>%1: „%2“ ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>unsaved work cannot be protected: &quot;%1&quot; cannot be written</source>
        <translation>ungespeicherte Arbeit kann nicht gesichert werden: „%1“ lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot;</source>
        <translation>es gibt keine Datei „%1“</translation>
    </message>
    <message>
        <source>you are not allowed to read &quot;%1&quot;</source>
        <translation>Sie dürfen „%1“ nicht lesen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a folder, not a file</source>
        <translation>„%1“ ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an ordinary file</source>
        <translation>„%1“ ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read (%2)</source>
        <translation>„%1“ lässt sich nicht lesen (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: the disk is full; make room or choose another folder</source>
        <translation>„%1“ lässt sich nicht schreiben: der Datenträger ist voll; schaffen Sie Platz oder wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: you are not allowed to write into &quot;%2&quot;; choose another folder</source>
        <translation>„%1“ lässt sich nicht schreiben: in „%2“ dürfen Sie nicht schreiben; wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: there is no folder &quot;%2&quot;</source>
        <translation>„%1“ lässt sich nicht schreiben: den Ordner „%2“ gibt es nicht</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is a folder</source>
        <translation>„%1“ lässt sich nicht schreiben: es ist ein Ordner</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written (%2)</source>
        <translation>„%1“ lässt sich nicht schreiben (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too large: %2 MB, and at most %3 MB are read</source>
        <translation>„%1“ ist zu groß: %2 MB; gelesen werden höchstens %3 MB</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is write-protected</source>
        <translation>„%1“ lässt sich nicht schreiben: es ist schreibgeschützt</translation>
    </message>
    <message>
        <source>The equations of the cover could not be solved: a patch is degenerate or its numbers are too large.</source>
        <translation>Die Gleichungen des Bezugs ließen sich nicht lösen: ein Schnittteil ist entartet, oder seine Zahlen sind zu groß.</translation>
    </message>
    <message>
        <source>this seam and its neighbours carry their ends round in a circle without ever meeting. Let the seams of this circle end at common points.</source>
        <translation>diese Naht und ihre Nachbarn reichen ihre Enden im Kreis weiter, ohne je zusammenzutreffen. Lassen Sie die Nähte dieses Kreises an gemeinsamen Punkten enden.</translation>
    </message>
    <message>
        <source>the corners of the two stretches lie too close together to be matched. Move them apart or choose a smaller edge length.</source>
        <translation>die Ecken der beiden Abschnitte liegen zu dicht beieinander, um einander zugeordnet zu werden. Rücken Sie sie auseinander oder wählen Sie eine kleinere Kantenlänge.</translation>
    </message>
    <message>
        <source>%1 and %2 hold the same point of the cover in two places, %3 mm apart. Let both curves meet there, or end one stretch earlier.</source>
        <translation>%1 und %2 halten denselben Punkt des Bezugs an zwei Stellen, %3 mm voneinander entfernt. Lassen Sie beide Kurven dort zusammentreffen oder einen Abschnitt früher enden.</translation>
    </message>
    <message>
        <source>the patch is too narrow somewhere for edges of %1 mm. Choose a smaller edge length.</source>
        <translation>das Schnittteil ist irgendwo zu schmal für Kanten von %1 mm. Wählen Sie eine kleinere Kantenlänge.</translation>
    </message>
    <message>
        <source>The design cannot be solved: %2</source>
        <translation>Der Entwurf lässt sich nicht berechnen: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>There is no patch to solve. Add a patch to the pattern.</source>
        <translation>Es gibt kein Schnittteil zu berechnen. Fügen Sie dem Schnitt eines hinzu.</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by an estimated %2 mm. Allow more iterations.</source>
        <translation>Nach %1 Schritten bewegt sich die Oberfläche noch um schätzungsweise %2 mm. Erlauben Sie mehr Schritte.</translation>
    </message>
    <message>
        <source>Remove %1 points</source>
        <translation>%1 Punkte entfernen</translation>
    </message>
    <message>
        <source>Move %1 points</source>
        <translation>%1 Punkte verschieben</translation>
    </message>
    <message>
        <source>another element has the number %1 already; give this one a number of its own</source>
        <translation>ein anderes Element hat schon die Nummer %1; geben Sie diesem eine eigene</translation>
    </message>
    <message>
        <source>this is no Bolster design; it must say &quot;format&quot;: &quot;bolster-design&quot;</source>
        <translation>das ist kein Bolster-Entwurf; darin muss &quot;format&quot;: &quot;bolster-design&quot; stehen</translation>
    </message>
    <message>
        <source>the design was made by a newer Bolster (version %1 of the format, this program knows %2); update the program</source>
        <translation>der Entwurf stammt von einem neueren Bolster (Version %1 des Formats, dieses Programm kennt %2); aktualisieren Sie das Programm</translation>
    </message>
    <message>
        <source>must be %1</source>
        <translation>muss %1 sein</translation>
    </message>
    <message>
        <source>must be &quot;mm&quot;; convert the design to millimetres</source>
        <translation>muss &quot;mm&quot; sein; rechnen Sie den Entwurf in Millimeter um</translation>
    </message>
    <message>
        <source>must be a list of elements in square brackets</source>
        <translation>muss eine Liste von Elementen in eckigen Klammern sein</translation>
    </message>
    <message>
        <source>must be a list of points in square brackets</source>
        <translation>muss eine Liste von Punkten in eckigen Klammern sein</translation>
    </message>
    <message>
        <source>must be a list of numbers in square brackets</source>
        <translation>muss eine Liste von Zahlen in eckigen Klammern sein</translation>
    </message>
    <message>
        <source>the list is empty; leave it out</source>
        <translation>die Liste ist leer; lassen Sie sie weg</translation>
    </message>
    <message>
        <source>must be a curve in braces, with degree, closed and points</source>
        <translation>muss eine Kurve in geschweiften Klammern sein, mit degree, closed und points</translation>
    </message>
    <message>
        <source>a curve has either corners or knots; remove one of them</source>
        <translation>eine Kurve hat entweder corners oder knots; entfernen Sie eines davon</translation>
    </message>
    <message>
        <source>an outline must be closed; write true</source>
        <translation>ein Umriss muss geschlossen sein; schreiben Sie true</translation>
    </message>
    <message>
        <source>must be a stretch in braces, with patch, from and to</source>
        <translation>muss ein Abschnitt in geschweiften Klammern sein, mit patch, from und to</translation>
    </message>
    <message>
        <source>must be a quaternion [w, x, y, z] of length 1, not of length %1</source>
        <translation>muss ein Quaternion [w, x, y, z] der Länge 1 sein, nicht der Länge %1</translation>
    </message>
    <message>
        <source>must be an object in braces</source>
        <translation>muss ein Objekt in geschweiften Klammern sein</translation>
    </message>
    <message>
        <source>an element must be an object in braces</source>
        <translation>ein Element muss ein Objekt in geschweiften Klammern sein</translation>
    </message>
    <message>
        <source>must be true or false, without quotes</source>
        <translation>muss true oder false sein, ohne Anführungszeichen</translation>
    </message>
    <message>
        <source>must be a text in quotes</source>
        <translation>muss ein Text in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>and %1 more problems of this element</source>
        <translation>und %1 weitere Probleme dieses Elements</translation>
    </message>
    <message>
        <source>must be a number, without quotes</source>
        <translation>muss eine Zahl sein, ohne Anführungszeichen</translation>
    </message>
    <message>
        <source>must be a whole number from %1 to %2</source>
        <translation>muss eine ganze Zahl von %1 bis %2 sein</translation>
    </message>
    <message>
        <source>must be a list of %1 numbers in square brackets</source>
        <translation>muss eine Liste von %1 Zahlen in eckigen Klammern sein</translation>
    </message>
    <message>
        <source>this key occurs twice; remove one of them</source>
        <translation>dieser Schlüssel kommt zweimal vor; entfernen Sie einen davon</translation>
    </message>
    <message>
        <source>this key is missing; add it</source>
        <translation>dieser Schlüssel fehlt; fügen Sie ihn hinzu</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>muss eines von %1 sein</translation>
    </message>
    <message>
        <source>this key is unknown; check its spelling or remove it</source>
        <translation>dieser Schlüssel ist unbekannt; prüfen Sie die Schreibweise oder entfernen Sie ihn</translation>
    </message>
    <message>
        <source>Move a point of %1</source>
        <translation>Punkt von %1 verschieben</translation>
    </message>
    <message>
        <source>Move %2 points of %1</source>
        <translation>%2 Punkte von %1 verschieben</translation>
    </message>
    <message>
        <source>Insert a point into %1</source>
        <translation>Punkt in %1 einfügen</translation>
    </message>
    <message>
        <source>Remove a point of %1</source>
        <translation>Punkt von %1 entfernen</translation>
    </message>
    <message>
        <source>Change the settings</source>
        <translation>Einstellungen ändern</translation>
    </message>
    <message>
        <source>Add fabric %1</source>
        <translation>Stoff %1 hinzufügen</translation>
    </message>
    <message>
        <source>Add patch %1</source>
        <translation>Schnittteil %1 hinzufügen</translation>
    </message>
    <message>
        <source>Add a seam</source>
        <translation>Naht hinzufügen</translation>
    </message>
    <message>
        <source>Add fixation curve %1</source>
        <translation>Fixierkurve %1 hinzufügen</translation>
    </message>
    <message>
        <source>Add a fixation seam</source>
        <translation>Fixierung hinzufügen</translation>
    </message>
    <message>
        <source>Add frame %1</source>
        <translation>Gestell %1 hinzufügen</translation>
    </message>
    <message>
        <source>Add an unreadable element</source>
        <translation>Unlesbares Element hinzufügen</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>%1 in %2 umbenennen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Remove %1 elements</source>
        <translation>%1 Elemente entfernen</translation>
    </message>
    <message>
        <source>Move %1 patches</source>
        <translation>%1 Schnittteile verschieben</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Turn %1 patches</source>
        <translation>%1 Schnittteile drehen</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>There is not enough memory for this surface. Choose a larger edge length.</source>
        <translation>Für diese Oberfläche reicht der Speicher nicht. Wählen Sie eine größere Kantenlänge.</translation>
    </message>
    <message>
        <source>The solver failed: %1. The last good surface is kept.</source>
        <translation>Die Berechnung ist gescheitert: %1. Die letzte gute Oberfläche bleibt stehen.</translation>
    </message>
    <message>
        <source>Change the colour of %1</source>
        <translation>Farbe von %1 ändern</translation>
    </message>
    <message>
        <source>Change the stiffness of %1</source>
        <translation>Steifigkeit von %1 ändern</translation>
    </message>
    <message>
        <source>Change the Poisson parameter of %1</source>
        <translation>Querkontraktion von %1 ändern</translation>
    </message>
    <message>
        <source>Change the bending length of %1</source>
        <translation>Biegelänge von %1 ändern</translation>
    </message>
    <message>
        <source>Change the fabric of %1</source>
        <translation>Stoff von %1 ändern</translation>
    </message>
    <message>
        <source>Change the grain of %1</source>
        <translation>Fadenlauf von %1 ändern</translation>
    </message>
    <message>
        <source>Change the pressure of %1</source>
        <translation>Druck von %1 ändern</translation>
    </message>
    <message>
        <source>Change the right side of %1</source>
        <translation>Rechte Seite von %1 ändern</translation>
    </message>
    <message>
        <source>Move %1 in the layout</source>
        <translation>%1 im Layout verschieben</translation>
    </message>
    <message>
        <source>Turn %1 in the layout</source>
        <translation>%1 im Layout drehen</translation>
    </message>
    <message>
        <source>Change the continuity of %1</source>
        <translation>Übergang von %1 ändern</translation>
    </message>
    <message>
        <source>Change how %1 is matched</source>
        <translation>Zuordnung von %1 ändern</translation>
    </message>
    <message>
        <source>Reverse %1</source>
        <translation>%1 umkehren</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>%1 skalieren</translation>
    </message>
    <message>
        <source>The surface still moves after %1 iterations.</source>
        <translation>Nach %1 Schritten bewegt sich die Oberfläche noch.</translation>
    </message>
    <message>
        <source>this is no name of a file</source>
        <translation>das ist kein Dateiname</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be relative to the design&apos;s folder and use &quot;/&quot; between folders</source>
        <translation>„%1“ muss vom Ordner des Entwurfs ausgehen und „/“ zwischen Ordnern verwenden</translation>
    </message>
    <message>
        <source>left out because of its errors</source>
        <translation>weggelassen wegen seiner Fehler</translation>
    </message>
    <message>
        <source>left out because it needs %1, which is not there</source>
        <translation>weggelassen, weil es %1 braucht, und das fehlt</translation>
    </message>
    <message>
        <source>an edge length of %1 mm is used instead</source>
        <translation>stattdessen wird eine Kantenlänge von %1 mm verwendet</translation>
    </message>
    <message>
        <source>the file is not a design</source>
        <translation>die Datei ist kein Entwurf</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written</source>
        <translation>„%1“ lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be copied to &quot;%2&quot;: %3</source>
        <translation>„%1“ ließ sich nicht nach „%2“ kopieren: %3</translation>
    </message>
    <message>
        <source>the folder &quot;%1&quot; could not be made</source>
        <translation>der Ordner „%1“ ließ sich nicht anlegen</translation>
    </message>
    <message>
        <source>the patch is free in space: nothing fixes it to the frame; add a fixation</source>
        <translation>das Schnittteil ist frei im Raum: nichts hält es am Gestell; fügen Sie eine Fixierung hinzu</translation>
    </message>
    <message>
        <source>this patch and the %1 sewn to it are free in space: nothing fixes them to the frame; add a fixation</source>
        <translation>dieses Schnittteil und die %1 daran genähten sind frei im Raum: nichts hält sie am Gestell; fügen Sie eine Fixierung hinzu</translation>
    </message>
    <message>
        <source>is %1, but must lie between %2 and %3</source>
        <translation>ist %1, muss aber zwischen %2 und %3 liegen</translation>
    </message>
    <message>
        <source>there is no element %1; name a %2</source>
        <translation>es gibt kein Element %1; nennen Sie eines der Art %2</translation>
    </message>
    <message>
        <source>element %1 cannot be read; repair it or name another %2</source>
        <translation>Element %1 ist nicht lesbar; reparieren Sie es oder nennen Sie ein anderes der Art %2</translation>
    </message>
    <message>
        <source>%1 is no %2; name another element</source>
        <translation>%1 ist nicht von der Art %2; nennen Sie ein anderes Element</translation>
    </message>
    <message>
        <source>%1 mm would make more than 5 million triangles; take at least %2 mm for these patches</source>
        <translation>%1 mm ergäben mehr als 5 Millionen Dreiecke; nehmen Sie für diese Schnittteile mindestens %2 mm</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no colour; write it like #7a4a2b</source>
        <translation>„%1“ ist keine Farbe; schreiben Sie sie wie #7a4a2b</translation>
    </message>
    <message>
        <source>the mesh cannot resolve folds as small as a bending length of %1 mm makes them: with edges of %2 mm it acts like %3 mm; take an edge length of at most %4 mm, or a longer bending length</source>
        <translation>das Netz kann so kleine Falten nicht auflösen, wie eine Biegelänge von %1 mm sie wirft: bei Kanten von %2 mm wirkt sie wie %3 mm; nehmen Sie eine Kantenlänge von höchstens %4 mm oder eine größere Biegelänge</translation>
    </message>
    <message>
        <source>an outline must be a closed curve</source>
        <translation>ein Umriss muss eine geschlossene Kurve sein</translation>
    </message>
    <message>
        <source>the outline needs at least three points in different places</source>
        <translation>der Umriss braucht mindestens drei Punkte an verschiedenen Stellen</translation>
    </message>
    <message>
        <source>all points of the outline lie on one line, it encloses no area; move one of them</source>
        <translation>alle Punkte des Umrisses liegen auf einer Geraden, er umschließt keine Fläche; verschieben Sie einen davon</translation>
    </message>
    <message>
        <source>the outline crosses or touches itself near %1; move its points apart there</source>
        <translation>der Umriss kreuzt oder berührt sich selbst bei %1; rücken Sie seine Punkte dort auseinander</translation>
    </message>
    <message>
        <source>the outline encloses no area</source>
        <translation>der Umriss umschließt keine Fläche</translation>
    </message>
    <message>
        <source>%1 is the end of the curve; write %2, its start</source>
        <translation>%1 ist das Ende der Kurve; schreiben Sie %2, ihren Anfang</translation>
    </message>
    <message>
        <source>is %1, but must be larger than the start of the stretch, %2</source>
        <translation>ist %1, muss aber größer sein als der Anfang des Abschnitts, %2</translation>
    </message>
    <message>
        <source>the stretch from %1 to %2 is empty or longer than the curve</source>
        <translation>der Abschnitt von %1 bis %2 ist leer oder länger als die Kurve</translation>
    </message>
    <message>
        <source>the stretch from %1 to %2 has no length; the outline&apos;s points coincide there</source>
        <translation>der Abschnitt von %1 bis %2 hat keine Länge; die Punkte des Umrisses fallen dort zusammen</translation>
    </message>
    <message>
        <source>the seam would sew a stretch of &quot;%1&quot; to itself: %2 to %3 and %4 to %5 overlap; choose two separate stretches</source>
        <translation>die Naht würde einen Abschnitt von „%1“ an sich selbst nähen: %2 bis %3 und %4 bis %5 überschneiden sich; wählen Sie zwei getrennte Abschnitte</translation>
    </message>
    <message>
        <source>the seam joins the right side of &quot;%1&quot; to the wrong side of &quot;%2&quot;; turn &quot;reversed&quot; round, or one patch wrong side out</source>
        <translation>die Naht verbindet die rechte Seite von „%1“ mit der linken Seite von „%2“; kehren Sie „reversed“ um oder wenden Sie eines der Schnittteile auf links</translation>
    </message>
    <message>
        <source>the sides of the seam are %1 mm (&quot;%2&quot;) and %3 mm (&quot;%4&quot;) long: %5 % ease, more than 5 % puckers; make them equal or check the ends of the stretches</source>
        <translation>die Seiten der Naht sind %1 mm („%2“) und %3 mm („%4“) lang: %5 % Mehrweite, über 5 % kräuselt es sich; gleichen Sie sie an oder prüfen Sie die Enden der Abschnitte</translation>
    </message>
    <message>
        <source>the curve has no length; move its points apart</source>
        <translation>die Kurve hat keine Länge; rücken Sie ihre Punkte auseinander</translation>
    </message>
    <message>
        <source>the curve from %1 to %2 has no length</source>
        <translation>die Kurve hat von %1 bis %2 keine Länge</translation>
    </message>
    <message>
        <source>is %1, but must be positive: millimetres per unit of the file</source>
        <translation>ist %1, muss aber positiv sein: Millimeter je Einheit der Datei</translation>
    </message>
    <message>
        <source>a design has at most %1 elements</source>
        <translation>ein Entwurf hat höchstens %1 Elemente</translation>
    </message>
    <message>
        <source>a curve has at most %1 points</source>
        <translation>eine Kurve hat höchstens %1 Punkte</translation>
    </message>
    <message>
        <source>the usual values of a fabric are used instead</source>
        <translation>stattdessen werden die üblichen Werte eines Stoffs verwendet</translation>
    </message>
    <message>
        <source>Remove %1 and what is sewn to it</source>
        <translation>%1 und das daran Genähte entfernen</translation>
    </message>
    <message>
        <source>Remove %1 and %2 seams and fixations</source>
        <translation>%1 mit %2 Nähten und Fixierungen entfernen</translation>
    </message>
    <message>
        <source>is %1, but must be a positive length of at most %2; 12 mm is usual</source>
        <translation>ist %1, muss aber eine positive Länge von höchstens %2 sein; üblich sind 12 mm</translation>
    </message>
    <message>
        <source>no mesh can resolve folds as small as a bending length of %1 mm makes them: with edges of %2 mm it acts like %3 mm; take a longer bending length</source>
        <translation>so kleine Falten, wie eine Biegelänge von %1 mm sie macht, löst kein Netz auf: mit Kanten von %2 mm wirkt sie wie %3 mm; nehmen Sie eine größere Biegelänge</translation>
    </message>
    <message>
        <source>it sews what %1 sews already; remove one of them</source>
        <translation>sie näht, was %1 schon näht; entfernen Sie eine von beiden</translation>
    </message>
    <message>
        <source>it sews the same stretches as %1, but the other way round: each would be folded onto itself; remove one of the two</source>
        <translation>sie näht dieselben Strecken wie %1, aber andersherum: jede würde auf sich selbst gefaltet; entfernen Sie eine von beiden</translation>
    </message>
    <message>
        <source>&quot;%1&quot; goes up with &quot;..&quot;; write the way from the design&apos;s folder without it, or copy the file there</source>
        <translation>„%1“ führt mit „..“ nach oben; schreiben Sie den Weg vom Ordner des Entwurfs ohne das, oder kopieren Sie die Datei dorthin</translation>
    </message>
    <message>
        <source>the number %1 is too large or too small; stay within %2</source>
        <translation>die Zahl %1 ist zu groß oder zu klein; bleiben Sie innerhalb von %2</translation>
    </message>
    <message>
        <source>the text is UTF-16; save it as UTF-8</source>
        <translation>der Text ist in UTF-16; speichern Sie ihn als UTF-8</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by %2 mm in each: it does not come to rest. Lower the pressure, or make curves as long as the outlines they hold.</source>
        <translation>Nach %1 Iterationen bewegt sich die Fläche noch in jeder um %2 mm: Sie kommt nicht zur Ruhe. Verringern Sie den Druck, oder machen Sie die Kurven so lang wie die Umrisse, die sie halten.</translation>
    </message>
    <message>
        <source>%1 of %2 triangles of the cover lie upside down. Look for cloth pressed into too little room, or a bending length that is long for its patch.</source>
        <translation>%1 von %2 Dreiecken des Bezugs liegen verkehrt herum. Suchen Sie nach Stoff, der zu wenig Platz hat, oder nach einer Biegelänge, die für ihr Teil zu groß ist.</translation>
    </message>
    <message>
        <source>there is either a normal or a tangent; remove one of them</source>
        <translation>es gibt entweder eine Normale oder eine Tangente; entfernen Sie eine davon</translation>
    </message>
    <message>
        <source>there are %1 directions, but at most %2 are possible</source>
        <translation>es sind %1 Richtungen, aber höchstens %2 sind möglich</translation>
    </message>
    <message>
        <source>a direction must be three numbers that are not all 0</source>
        <translation>eine Richtung muss aus drei Zahlen bestehen, die nicht alle 0 sind</translation>
    </message>
    <message>
        <source>direction %1 is opposite to the one before, so that it is not known on which way to turn; add one between them</source>
        <translation>Richtung %1 ist der vorigen entgegengesetzt, sodass unklar ist, wie herum gedreht wird; fügen Sie eine dazwischen ein</translation>
    </message>
    <message>
        <source>there is no curve; name one, or leave out curve_from and curve_to</source>
        <translation>es gibt keine Kurve; nennen Sie eine, oder lassen Sie curve_from und curve_to weg</translation>
    </message>
    <message>
        <source>Change the normal held by %1</source>
        <translation>Von %1 gehaltene Normale ändern</translation>
    </message>
    <message>
        <source>must be a text in quotation marks</source>
        <translation>muss ein Text in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>the curve in the patch and its target must both be open or both be closed</source>
        <translation>die Kurve im Schnittteil und ihr Ziel müssen beide offen oder beide geschlossen sein</translation>
    </message>
    <message>
        <source>Add handle curve %1</source>
        <translation>Griffkurve %1 hinzufügen</translation>
    </message>
    <message>
        <source>Add fancy seam %1</source>
        <translation>Ziernaht %1 hinzufügen</translation>
    </message>
    <message>
        <source>Add cushion %1</source>
        <translation>Polsterung %1 hinzufügen</translation>
    </message>
    <message>
        <source>Add foam %1</source>
        <translation>Schaum %1 hinzufügen</translation>
    </message>
    <message>
        <source>a width of %1 mm is too narrow for edges of %2 mm; make it at least %3 mm wide, or choose a smaller edge length</source>
        <translation>eine Breite von %1 mm ist für Kanten von %2 mm zu schmal; mindestens %3 mm wählen oder die Kantenlänge verringern</translation>
    </message>
    <message>
        <source>it lies outside its patch; move its points inside the outline</source>
        <translation>sie liegt außerhalb ihres Schnittteils; ihre Punkte in den Umriss verschieben</translation>
    </message>
    <message>
        <source>it leaves the patch and comes back; keep it inside, or end it at the outline</source>
        <translation>sie verlässt das Schnittteil und kehrt zurück; sie darin halten oder am Umriss enden lassen</translation>
    </message>
    <message>
        <source>it runs too flat into the outline near %1; let it meet the outline more steeply, or end it before</source>
        <translation>sie läuft bei %1 zu flach in den Umriss; sie steiler auf ihn treffen oder vorher enden lassen</translation>
    </message>
    <message>
        <source>it bends too sharply for a width of %1 mm near %2; make it narrower, or bend it less there</source>
        <translation>sie biegt sich bei %2 für eine Breite von %1 mm zu scharf; sie schmaler machen oder dort weniger biegen</translation>
    </message>
    <message>
        <source>a cushion takes at most %1 bodies of foam; this one is left out</source>
        <translation>eine Polsterung nimmt höchstens %1 Schaumkörper auf; dieser wird ausgelassen</translation>
    </message>
    <message>
        <source>the frame has no part &quot;%1&quot;; it has %2</source>
        <translation>das Gestell hat keinen Teil „%1“; es hat %2</translation>
    </message>
    <message>
        <source>it is only %1 mm long; draw it at least %2 mm long, or choose a smaller edge length</source>
        <translation>sie ist nur %1 mm lang; mindestens %2 mm lang zeichnen oder die Kantenlänge verringern</translation>
    </message>
    <message>
        <source>it reaches beyond its patch near %1; move its points inside the outline</source>
        <translation>sie ragt bei %1 über ihr Schnittteil hinaus; ihre Punkte in den Umriss verschieben</translation>
    </message>
    <message>
        <source>it comes closer than %1 mm to the outline near %2; keep away from it, or choose a smaller edge length</source>
        <translation>sie kommt dem Umriss bei %2 näher als %1 mm; Abstand halten oder die Kantenlänge verringern</translation>
    </message>
    <message>
        <source>it crosses %1, or comes closer to it than %2 mm, near %3; move them apart, or choose a smaller edge length</source>
        <translation>sie kreuzt %1 oder kommt bei %3 näher als %2 mm daran; beide auseinanderrücken oder die Kantenlänge verringern</translation>
    </message>
    <message>
        <source>it crosses itself, or comes closer to itself than %1 mm, near %2; move its points apart, or choose a smaller edge length</source>
        <translation>sie kreuzt sich oder kommt sich bei %2 näher als %1 mm; ihre Punkte auseinanderrücken oder die Kantenlänge verringern</translation>
    </message>
    <message>
        <source>the patch cannot be triangulated along it with edges of %1 mm. Choose a smaller edge length.</source>
        <translation>das Schnittteil lässt sich mit Kanten von %1 mm nicht entlang dieser Kurve vernetzen. Die Kantenlänge verringern.</translation>
    </message>
    <message>
        <source>Change the frame of %1</source>
        <translation>Das Gestell von %1 ändern</translation>
    </message>
    <message>
        <source>Change what %1 pushes</source>
        <translation>Ändern, was %1 drückt</translation>
    </message>
    <message>
        <source>Switch %1</source>
        <translation>%1 ein- oder ausschalten</translation>
    </message>
    <message>
        <source>Change the parts of %1</source>
        <translation>Die Teile von %1 ändern</translation>
    </message>
    <message>
        <source>Change the padding of %1</source>
        <translation>Das Polster von %1 ändern</translation>
    </message>
    <message>
        <source>Change the strength of %1</source>
        <translation>Die Stärke von %1 ändern</translation>
    </message>
    <message>
        <source>Change the distance of %1</source>
        <translation>Den Abstand von %1 ändern</translation>
    </message>
    <message>
        <source>Change the voxels of %1</source>
        <translation>Die Voxel von %1 ändern</translation>
    </message>
    <message>
        <source>Change the cushion of %1</source>
        <translation>Die Polsterung von %1 ändern</translation>
    </message>
    <message>
        <source>Change the shape of %1</source>
        <translation>Die Form von %1 ändern</translation>
    </message>
    <message>
        <source>Change the size of %1</source>
        <translation>Die Größe von %1 ändern</translation>
    </message>
    <message>
        <source>Add or cut %1</source>
        <translation>%1 hinzufügen oder ausschneiden</translation>
    </message>
    <message>
        <source>Change the contact of %1</source>
        <translation>Den Kontakt von %1 ändern</translation>
    </message>
    <message>
        <source>Change the gap of %1</source>
        <translation>Den Abstand von %1 ändern</translation>
    </message>
    <message>
        <source>Change the width of %1</source>
        <translation>Breite von %1 ändern</translation>
    </message>
    <message>
        <source>Change the depth of %1</source>
        <translation>Tiefe von %1 ändern</translation>
    </message>
    <message>
        <source>Change the profile of %1</source>
        <translation>Profil von %1 ändern</translation>
    </message>
    <message>
        <source>Move points of %1 curves</source>
        <translation>Punkte von %1 Kurven verschieben</translation>
    </message>
    <message>
        <source>Rename a file</source>
        <translation>Eine Datei umbenennen</translation>
    </message>
    <message>
        <source>Change the file of %1</source>
        <translation>Die Datei von %1 ändern</translation>
    </message>
    <message>
        <source>the file is missing</source>
        <translation>die Datei fehlt</translation>
    </message>
    <message>
        <source>it is a file that this design refers to; choose another name</source>
        <translation>es ist eine Datei, auf die dieser Entwurf verweist; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>There is no cover to place the scan on.</source>
        <translation>Es gibt keinen Bezug, an dem der Scan ausgerichtet werden könnte.</translation>
    </message>
    <message>
        <source>must be a list of at most %1 planes, [x, y, z, distance] each</source>
        <translation>muss eine Liste von höchstens %1 Ebenen sein, je [x, y, z, Abstand]</translation>
    </message>
    <message>
        <source>must be a list of at most %1 cuts in braces</source>
        <translation>muss eine Liste von höchstens %1 Schnitten in geschweiften Klammern sein</translation>
    </message>
    <message>
        <source>must be a cut in braces, with planes</source>
        <translation>muss ein Schnitt in geschweiften Klammern sein, mit planes</translation>
    </message>
    <message>
        <source>the first three numbers are the plane&apos;s normal; not all of them may be 0</source>
        <translation>die ersten drei Zahlen sind die Normale der Ebene; sie dürfen nicht alle 0 sein</translation>
    </message>
    <message>
        <source>no file is named; write the name of a file beside the design</source>
        <translation>es ist keine Datei genannt; schreiben Sie den Namen einer Datei neben dem Entwurf</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no file in the design&apos;s folder; copy the file into that folder and name it here</source>
        <translation>„%1“ ist keine Datei im Ordner des Entwurfs; kopieren Sie die Datei in diesen Ordner und nennen Sie sie hier</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot; in the design&apos;s folder; copy the file there or choose another one</source>
        <translation>im Ordner des Entwurfs gibt es keine Datei „%1“; kopieren Sie die Datei dorthin oder wählen Sie eine andere</translation>
    </message>
    <message>
        <source>with this scale and position the points reach beyond 10,000,000 mm</source>
        <translation>mit diesem Maßstab und dieser Lage reichen die Punkte über 10.000.000 mm hinaus</translation>
    </message>
    <message>
        <source>Add scan %1</source>
        <translation>Scan %1 hinzufügen</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>%1 beschneiden</translation>
    </message>
    <message>
        <source>Show all of %1</source>
        <translation>%1 ganz zeigen</translation>
    </message>
    <message>
        <source>Cut the floor off %1</source>
        <translation>Den Boden von %1 abschneiden</translation>
    </message>
    <message>
        <source>%1 holds no points</source>
        <translation>%1 enthält keine Punkte</translation>
    </message>
    <message>
        <source>%1: the scan is too large, the limit is %2 points</source>
        <translation>%1: der Scan ist zu groß, die Grenze liegt bei %2 Punkten</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not expected in a PCD header</source>
        <translation>%1: „%2“ wird in einem PCD-Kopf nicht erwartet</translation>
    </message>
    <message>
        <source>%1: the compressed points are damaged</source>
        <translation>%1: die komprimierten Punkte sind beschädigt</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PCD format</source>
        <translation>%1: „%2“ ist kein PCD-Format</translation>
    </message>
    <message>
        <source>the cuts leave nothing of the scan; remove one of them</source>
        <translation>die Schnitte lassen vom Scan nichts übrig; entfernen Sie einen davon</translation>
    </message>
    <message>
        <source>Change the threshold of %1</source>
        <translation>Die Schwelle von %1 ändern</translation>
    </message>
    <message>
        <source>Change how %1 pulls</source>
        <translation>Ändern, wie %1 zieht</translation>
    </message>
    <message>
        <source>Release points of twins</source>
        <translation>Punkte von Zwillingen lösen</translation>
    </message>
    <message>
        <source>Re-link points of twins</source>
        <translation>Punkte von Zwillingen wieder koppeln</translation>
    </message>
    <message>
        <source>Make the design symmetric</source>
        <translation>Entwurf symmetrisch machen</translation>
    </message>
    <message>
        <source>These two cannot be twins.</source>
        <translation>Diese beiden können keine Zwillinge sein.</translation>
    </message>
    <message>
        <source>Make corners</source>
        <translation>Ecken machen</translation>
    </message>
    <message>
        <source>Make curves smooth</source>
        <translation>Kurven glatt machen</translation>
    </message>
    <message>
        <source>element %1 cannot be its twin: that must be another %2 which is nobody else&apos;s; until then it has none</source>
        <translation>Element %1 kann nicht sein Zwilling sein: Das muss ein anderes Element der Art %2 sein, das zu keinem anderen gehört; bis dahin hat es keinen</translation>
    </message>
    <message>
        <source>there is no point %1</source>
        <translation>es gibt keinen Punkt %1</translation>
    </message>
    <message>
        <source>its points and knots are not those of %1; the next edit of one of them makes it the mirror image</source>
        <translation>seine Punkte und Knoten sind nicht die von %1; die nächste Änderung eines der beiden macht es zum Spiegelbild</translation>
    </message>
    <message>
        <source>%1 of its points are no mirror images of those of %2; release them, or move them</source>
        <translation>%1 seiner Punkte sind keine Spiegelbilder derer von %2; diese lösen oder bewegen</translation>
    </message>
    <message>
        <source>the plane needs a normal that is not 0, and numbers within 1e7; x = 0 is used instead</source>
        <translation>die Ebene braucht eine Normale, die nicht 0 ist, und Zahlen bis 1e7; stattdessen gilt x = 0</translation>
    </message>
    <message>
        <source>the axis needs a direction that is not 0, and numbers within 1e7; x = 0 is used instead</source>
        <translation>die Achse braucht eine Richtung, die nicht 0 ist, und Zahlen bis 1e7; stattdessen gilt x = 0</translation>
    </message>
    <message>
        <source>The clipboard holds no parts of a design.</source>
        <translation>Die Zwischenablage enthält keine Teile eines Entwurfs.</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>%1 einfügen</translation>
    </message>
    <message>
        <source>Paste %1 pieces</source>
        <translation>%1 Teile einfügen</translation>
    </message>
    <message>
        <source>The clipboard holds no patches and no fixation curves.</source>
        <translation>Die Zwischenablage enthält weder Schnittteile noch Fixierkurven.</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 duplizieren</translation>
    </message>
    <message>
        <source>Duplicate %1 pieces</source>
        <translation>%1 Teile duplizieren</translation>
    </message>
    <message>
        <source>Make a corner in %1</source>
        <translation>In %1 eine Ecke machen</translation>
    </message>
    <message>
        <source>Make %1 smooth</source>
        <translation>%1 glatt machen</translation>
    </message>
    <message>
        <source>Straighten a stretch of %1</source>
        <translation>Einen Abschnitt von %1 gerade machen</translation>
    </message>
    <message>
        <source>Attach %1 to %2</source>
        <translation>%1 an %2 fixieren</translation>
    </message>
    <message>
        <source>There is no such stretch of an outline.</source>
        <translation>Einen solchen Umrissabschnitt gibt es nicht.</translation>
    </message>
    <message>
        <source>The stretch has no length.</source>
        <translation>Der Abschnitt hat keine Länge.</translation>
    </message>
    <message>
        <source>A part of this stretch is fixed to %1 already: remove that fixation or choose another stretch.</source>
        <translation>Ein Teil dieses Abschnitts ist schon an %1 fixiert: Entfernen Sie diese Fixierung oder wählen Sie einen anderen Abschnitt.</translation>
    </message>
    <message>
        <source>Create fixation curve %1</source>
        <translation>Fixierkurve %1 anlegen</translation>
    </message>
    <message>
        <source>Attach %1 stretches to %2</source>
        <translation>%1 Abschnitte an %2 fixieren</translation>
    </message>
    <message>
        <source>Attach %1 to %2 curves</source>
        <translation>%1 an %2 Kurven fixieren</translation>
    </message>
    <message>
        <source>Align %1 patches</source>
        <translation>%1 Schnittteile ausrichten</translation>
    </message>
    <message>
        <source>Distribute %1 patches</source>
        <translation>%1 Schnittteile verteilen</translation>
    </message>
    <message>
        <source>Arrange %1 patches</source>
        <translation>%1 Schnittteile anordnen</translation>
    </message>
    <message>
        <source>Make %1 and %2 twins</source>
        <translation>%1 und %2 zu Zwillingen machen</translation>
    </message>
    <message>
        <source>They are no mirror images: they differ by %1 mm. Twins must be alike; make a mirror twin of one of them instead.</source>
        <translation>Sie sind keine Spiegelbilder: Sie weichen um %1 mm voneinander ab. Zwillinge müssen sich gleichen; stattdessen einen Spiegelzwilling von einem der beiden anlegen.</translation>
    </message>
    <message>
        <source>Make a mirror twin of %1</source>
        <translation>Spiegelzwilling von %1 anlegen</translation>
    </message>
    <message>
        <source>Make %1 mirror twins</source>
        <translation>%1 Spiegelzwillinge anlegen</translation>
    </message>
    <message>
        <source>A patch of the seam is missing or invalid: repair it first.</source>
        <translation>Ein Schnittteil der Naht fehlt oder ist ungültig: zuerst reparieren.</translation>
    </message>
    <message>
        <source>The seam joins %1 to itself: there is nothing to merge.</source>
        <translation>Die Naht verbindet %1 mit sich selbst: Es gibt nichts zu vereinen.</translation>
    </message>
    <message>
        <source>The seam takes up a whole outline: nothing would be left.</source>
        <translation>Die Naht nimmt einen ganzen Umriss ein: Es bliebe nichts übrig.</translation>
    </message>
    <message>
        <source>The seam joins the right side of %1 to the wrong side of %2: one patch cannot be both.</source>
        <translation>Die Naht verbindet die rechte Seite von %1 mit der linken von %2: Ein Schnittteil kann nicht beides sein.</translation>
    </message>
    <message>
        <source>The sides of the seam differ by %1 % in length, more than 5 %.</source>
        <translation>Die Seiten der Naht sind um %1 % verschieden lang, mehr als 5 %.</translation>
    </message>
    <message>
        <source>Select the seam along which to merge.</source>
        <translation>Die Naht auswählen, an der vereint werden soll.</translation>
    </message>
    <message>
        <source>Merged, %1 and %2 would overlap or cross: the seam stays.</source>
        <translation>Vereint würden sich %1 und %2 überlappen oder kreuzen: Die Naht bleibt.</translation>
    </message>
    <message>
        <source>Merge %1 and %2</source>
        <translation>%1 und %2 vereinen</translation>
    </message>
    <message>
        <source>Scale %1 patches</source>
        <translation>%1 Schnittteile skalieren</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>%1 spiegeln</translation>
    </message>
    <message>
        <source>Mirror %1 patches</source>
        <translation>%1 Schnittteile spiegeln</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>%1 teilen</translation>
    </message>
    <message>
        <source>The line must cross the outline of %1 exactly twice, not %2 times.</source>
        <translation>Die Linie muss den Umriss von %1 genau zweimal kreuzen, nicht %2-mal.</translation>
    </message>
    <message>
        <source>Draw a line over a patch to split it.</source>
        <translation>Zum Teilen eine Linie über ein Schnittteil zeichnen.</translation>
    </message>
    <message>
        <source>The outline of %1 is invalid: repair it first.</source>
        <translation>Der Umriss von %1 ist ungültig: zuerst reparieren.</translation>
    </message>
    <message>
        <source>The line must run inside %1.</source>
        <translation>Die Linie muss innerhalb von %1 verlaufen.</translation>
    </message>
    <message>
        <source>A piece of %1 would cross itself or be too narrow: draw another line.</source>
        <translation>Ein Stück von %1 würde sich selbst kreuzen oder zu schmal: eine andere Linie zeichnen.</translation>
    </message>
    <message>
        <source>Sew %1 to %2</source>
        <translation>%1 an %2 nähen</translation>
    </message>
    <message>
        <source>Sew %1 to %2 stretches in a row</source>
        <translation>%1 an %2 Abschnitte in einer Reihe nähen</translation>
    </message>
    <message>
        <source>Flip %1</source>
        <translation>%1 umkehren</translation>
    </message>
    <message>
        <source>Flip %1 seams</source>
        <translation>%1 Nähte umkehren</translation>
    </message>
    <message>
        <source>Swap the sides of %1</source>
        <translation>Seiten von %1 tauschen</translation>
    </message>
    <message>
        <source>Swap the sides of %1 seams</source>
        <translation>Seiten von %1 Nähten tauschen</translation>
    </message>
    <message>
        <source>Change the continuity of %1 seams</source>
        <translation>Übergang von %1 Nähten ändern</translation>
    </message>
    <message>
        <source>Change how %1 seams are matched</source>
        <translation>Zuordnung von %1 Nähten ändern</translation>
    </message>
    <message>
        <source>This stretch has no length: choose two different points.</source>
        <translation>Dieser Abschnitt hat keine Länge: Wähle zwei verschiedene Punkte.</translation>
    </message>
    <message>
        <source>Move an end of %1</source>
        <translation>Ein Ende von %1 verschieben</translation>
    </message>
    <message>
        <source>%1 is already sewn to %2 here: remove that seam first, or take a free stretch.</source>
        <translation>%1 ist hier schon an %2 genäht: Entferne erst diese Naht, oder nimm einen freien Abschnitt.</translation>
    </message>
    <message>
        <source>A stretch cannot be sewn to itself: choose two that have no part in common.</source>
        <translation>Ein Abschnitt kann nicht an sich selbst genäht werden: Wähle zwei, die sich nicht überlappen.</translation>
    </message>
    <message>
        <source>Unlink %1 and %2</source>
        <translation>%1 und %2 trennen</translation>
    </message>
    <message>
        <source>Unlink %1 pairs of twins</source>
        <translation>%1 Zwillingspaare trennen</translation>
    </message>
    <message>
        <source>Release a point of %1</source>
        <translation>Einen Punkt von %1 lösen</translation>
    </message>
    <message>
        <source>Release %2 points of %1</source>
        <translation>%2 Punkte von %1 lösen</translation>
    </message>
    <message>
        <source>Re-link a point of %1</source>
        <translation>Einen Punkt von %1 wieder koppeln</translation>
    </message>
    <message>
        <source>Re-link %2 points of %1</source>
        <translation>%2 Punkte von %1 wieder koppeln</translation>
    </message>
    <message>
        <source>Change the curve of %1</source>
        <translation>Kurve von %1 ändern</translation>
    </message>
    <message>
        <source>The outline of %1 would cross or touch itself.</source>
        <translation>Der Umriss von %1 würde sich selbst kreuzen oder berühren.</translation>
    </message>
    <message>
        <source>The outline of %1 would enclose nothing.</source>
        <translation>Der Umriss von %1 würde nichts einschließen.</translation>
    </message>
    <message>
        <source>%1 would not lie inside %2 any more.</source>
        <translation>%1 läge nicht mehr innerhalb von %2.</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that is fixed to %2.</source>
        <translation>Der Abschnitt würde sich mit einem anderen von %1 überschneiden, der an %2 fixiert ist.</translation>
    </message>
    <message>
        <source>The stretch would overlap the seam of %1 and %2.</source>
        <translation>Der Abschnitt würde sich mit der Naht von %1 und %2 überschneiden.</translation>
    </message>
    <message>
        <source>The two sides of the seam would overlap.</source>
        <translation>Die beiden Seiten der Naht würden sich überschneiden.</translation>
    </message>
    <message>
        <source>Change the length of a stretch of %1</source>
        <translation>Länge eines Abschnitts von %1 ändern</translation>
    </message>
    <message>
        <source>Move an end of a fixation of %1</source>
        <translation>Ein Ende einer Fixierung von %1 verschieben</translation>
    </message>
    <message>
        <source>Re-link a seam to its mirror image</source>
        <translation>Naht wieder mit ihrem Spiegelbild verknüpfen</translation>
    </message>
    <message>
        <source>Release a seam from its mirror image</source>
        <translation>Naht von ihrem Spiegelbild lösen</translation>
    </message>
    <message>
        <source>another element had the same number; give this one a number of its own</source>
        <translation>ein anderes Element hatte dieselbe Nummer; gib diesem eine eigene</translation>
    </message>
    <message>
        <source>Take %1 elements from another version</source>
        <translation>%1 Elemente aus einer anderen Fassung übernehmen</translation>
    </message>
    <message>
        <source>Take %1 from another version</source>
        <translation>%1 aus einer anderen Fassung übernehmen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is not an ordinary file</source>
        <translation>„%1“ lässt sich nicht schreiben: es ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>a file that the design uses cannot be read (%1)</source>
        <translation>eine Datei, die der Entwurf benutzt, lässt sich nicht lesen (%1)</translation>
    </message>
    <message>
        <source>a file of the project cannot be written out (%1)</source>
        <translation>eine Datei des Projekts lässt sich nicht herausschreiben (%1)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be opened or made</source>
        <translation>„%1“ lässt sich nicht öffnen oder anlegen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is in use by another program</source>
        <translation>„%1“ wird von einem anderen Programm benutzt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged (%2)</source>
        <translation>„%1“ ist beschädigt (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read or written (%2)</source>
        <translation>„%1“ lässt sich nicht lesen oder schreiben (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is closed</source>
        <translation>„%1“ ist geschlossen</translation>
    </message>
    <message>
        <source>%1 cannot be stored: it holds a number that is none, or text in an unknown encoding</source>
        <translation>%1 lässt sich nicht speichern: eine Zahl darin ist keine, oder ein Text hat eine unbekannte Kodierung</translation>
    </message>
    <message>
        <source>there is a file &quot;%1&quot; already</source>
        <translation>es gibt schon eine Datei „%1“</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no Bolster project</source>
        <translation>„%1“ ist kein Bolster-Projekt</translation>
    </message>
    <message>
        <source>there is not enough memory for this project</source>
        <translation>der Speicher reicht für dieses Projekt nicht aus</translation>
    </message>
    <message>
        <source>an edit of the project cannot be read any more</source>
        <translation>eine Bearbeitung des Projekts lässt sich nicht mehr lesen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name for a file of a project</source>
        <translation>„%1“ ist kein Name für eine Datei eines Projekts</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was made by a newer Bolster (version %2 of the format, this program knows %3); update the program</source>
        <translation>„%1“ stammt von einem neueren Bolster (Version %2 des Formats, dieses Programm kennt %3); aktualisiere das Programm</translation>
    </message>
    <message>
        <source>&quot;%1&quot; says that it has version %2 of the format, which never was</source>
        <translation>„%1“ gibt an, Version %2 des Formats zu haben, die es nie gab</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the journal of a running program, or of one that crashed, not a project file</source>
        <translation>„%1“ ist das Journal eines laufenden oder abgestürzten Programms, keine Projektdatei</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: it is %2 bytes long and should have %3</source>
        <translation>„%1“ ist beschädigt: Die Datei hat %2 Bytes und sollte %3 haben</translation>
    </message>
    <message>
        <source>a temporary folder cannot be made (%1)</source>
        <translation>ein temporärer Ordner lässt sich nicht anlegen (%1)</translation>
    </message>
    <message>
        <source>a temporary file cannot be made (%1)</source>
        <translation>eine temporäre Datei lässt sich nicht anlegen (%1)</translation>
    </message>
    <message>
        <source>nothing in &quot;%1&quot; can be saved</source>
        <translation>aus „%1“ lässt sich nichts retten</translation>
    </message>
    <message>
        <source>%1 versions were saved</source>
        <translation>%1 Versionen wurden gerettet</translation>
    </message>
    <message>
        <source>lost: versions %1 to %2</source>
        <translation>verloren: Versionen %1 bis %2</translation>
    </message>
    <message>
        <source>Saved version</source>
        <translation>Gerettete Version</translation>
    </message>
    <message>
        <source>version %1 was saved without the edits before it</source>
        <translation>Version %1 wurde ohne die Bearbeitungen davor gerettet</translation>
    </message>
    <message>
        <source>lost: the names of %1 versions</source>
        <translation>verloren: die Namen von %1 Versionen</translation>
    </message>
    <message>
        <source>lost: the file &quot;%1&quot;</source>
        <translation>verloren: die Datei „%1“</translation>
    </message>
    <message>
        <source>the tables of &quot;%1&quot; are not those of a Bolster project</source>
        <translation>die Tabellen von „%1“ sind nicht die eines Bolster-Projekts</translation>
    </message>
    <message>
        <source>a checksum is incomplete</source>
        <translation>eine Prüfsumme ist unvollständig</translation>
    </message>
    <message>
        <source>another window has it</source>
        <translation>ein anderes Fenster hat es</translation>
    </message>
    <message>
        <source>must be a list of pairs in braces, with patch and fabric</source>
        <translation>muss eine Liste von Paaren in geschweiften Klammern sein, mit patch und fabric</translation>
    </message>
    <message>
        <source>must be a pair in braces, with patch and fabric</source>
        <translation>muss ein Paar in geschweiften Klammern sein, mit patch und fabric</translation>
    </message>
    <message>
        <source>there is no colourway %1; the patches show their own fabrics</source>
        <translation>es gibt keine Farbvariante %1; die Schnittteile zeigen ihre eigenen Stoffe</translation>
    </message>
    <message>
        <source>%1 has a fabric in this colourway already; remove one of the two</source>
        <translation>%1 hat in dieser Farbvariante schon einen Stoff; einen der beiden entfernen</translation>
    </message>
    <message>
        <source>what it says of missing patches and fabrics is left out</source>
        <translation>was sie über fehlende Schnittteile und Stoffe sagt, wird ausgelassen</translation>
    </message>
    <message>
        <source>Make %1 of %2</source>
        <translation>%1 aus %2 machen</translation>
    </message>
    <message>
        <source>Make %1 patches of %2</source>
        <translation>%1 Schnittteile aus %2 machen</translation>
    </message>
    <message>
        <source>Add colourway %1</source>
        <translation>Farbvariante %1 hinzufügen</translation>
    </message>
    <message>
        <source>Change what %1 shows</source>
        <translation>Ändern, was %1 zeigt</translation>
    </message>
    <message>
        <source>Change what %1 patches show</source>
        <translation>Ändern, was %1 Schnittteile zeigen</translation>
    </message>
    <message>
        <source>Show no colourway</source>
        <translation>Keine Farbvariante zeigen</translation>
    </message>
    <message>
        <source>Show colourway %1</source>
        <translation>Farbvariante %1 zeigen</translation>
    </message>
    <message>
        <source>A stretch of %1 that is sewn, fixed or trimmed would have no length.</source>
        <translation>Ein vernähter, fixierter oder verzierter Abschnitt von %1 hätte keine Länge.</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that has a trim.</source>
        <translation>Der Abschnitt würde sich mit einem anderen von %1 überschneiden, der verziert ist.</translation>
    </message>
    <message>
        <source>Add a trim</source>
        <translation>Verzierung hinzufügen</translation>
    </message>
    <message>
        <source>Move an end of a trim of %1</source>
        <translation>Ein Ende einer Verzierung von %1 verschieben</translation>
    </message>
    <message>
        <source>Change the trim of %1 seams</source>
        <translation>Verzierung von %1 Nähten ändern</translation>
    </message>
    <message>
        <source>Change the trim of %1</source>
        <translation>Verzierung von %1 ändern</translation>
    </message>
    <message>
        <source>A part of this stretch of %1 has a trim already: change that one, or choose another stretch.</source>
        <translation>Ein Teil dieses Abschnitts von %1 ist schon verziert: diese Verzierung ändern oder einen anderen Abschnitt wählen.</translation>
    </message>
    <message>
        <source>Trim the edge of %1</source>
        <translation>Kante von %1 verzieren</translation>
    </message>
    <message>
        <source>%1: the file cannot be read any further; it has changed, or its disk is gone</source>
        <translation>%1: die Datei lässt sich nicht weiter lesen; sie hat sich geändert, oder ihr Datenträger ist fort</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a picture that can be read; PNG, JPEG, TIFF and OpenEXR can</source>
        <translation>„%1“ ist kein Bild, das gelesen werden kann; PNG, JPEG, TIFF und OpenEXR können es</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 by %3 pixels, and at most 64 million are read; make the picture smaller in a picture editor</source>
        <translation>„%1“ hat %2 mal %3 Pixel, und höchstens 64 Millionen werden gelesen; das Bild in einem Bildprogramm verkleinern</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a kind of picture whose colours cannot be read; save it as PNG in a picture editor</source>
        <translation>„%1“ ist eine Art von Bild, deren Farben nicht gelesen werden können; in einem Bildprogramm als PNG speichern</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged or incomplete; copy it again from where it came from, or save it again in a picture editor</source>
        <translation>„%1“ ist beschädigt oder unvollständig; noch einmal von seinem Ursprung kopieren oder in einem Bildprogramm neu speichern</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which reads pictures for Bolster, cannot be started; install Bolster again</source>
        <translation>das Programm „%1“, das für Bolster Bilder liest, kann nicht gestartet werden; Bolster neu installieren</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes too long to read; save it as PNG in a picture editor</source>
        <translation>das Lesen von „%1“ dauert zu lange; in einem Bildprogramm als PNG speichern</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be decoded: it is damaged or incomplete, or needs too much memory; save it again as PNG in a picture editor</source>
        <translation>„%1“ kann nicht entschlüsselt werden: es ist beschädigt oder unvollständig oder braucht zu viel Speicher; in einem Bildprogramm neu als PNG speichern</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this picture</source>
        <translation>%1: für dieses Bild ist nicht genug Speicher da</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this file</source>
        <translation>%1: für diese Datei ist nicht genug Speicher da</translation>
    </message>
    <message>
        <source>%1: the line is too long</source>
        <translation>%1: die Zeile ist zu lang</translation>
    </message>
    <message>
        <source>both have a file &quot;%1&quot;, and they are different: save under another name</source>
        <translation>beide haben eine Datei „%1“, und sie sind verschieden: unter einem anderen Namen speichern</translation>
    </message>
    <message>
        <source>there is another project in the file now</source>
        <translation>in der Datei ist jetzt ein anderes Projekt</translation>
    </message>
    <message>
        <source>the last edits are not on the disk yet</source>
        <translation>die letzten Schritte sind noch nicht auf dem Datenträger</translation>
    </message>
    <message>
        <source>Change the stitching of %1</source>
        <translation>Stiche von %1 ändern</translation>
    </message>
    <message>
        <source>Change the piping of %1</source>
        <translation>Keder von %1 ändern</translation>
    </message>
    <message>
        <source>Change the seam allowance of %1</source>
        <translation>Nahtzugabe von %1 ändern</translation>
    </message>
    <message>
        <source>Change the valley of %1</source>
        <translation>Mulde von %1 ändern</translation>
    </message>
    <message>
        <source>there is no fabric in &quot;%1&quot;</source>
        <translation>in „%1“ ist kein Stoff</translation>
    </message>
    <message>
        <source>the design uses &quot;%1&quot; itself; choose another name</source>
        <translation>der Entwurf verwendet „%1“ selbst; bitte einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>there is not enough memory to show this fabric</source>
        <translation>der Speicher reicht nicht, um diesen Stoff zu zeigen</translation>
    </message>
    <message>
        <source>Replace fabric %1 by %2</source>
        <translation>Stoff %1 durch %2 ersetzen</translation>
    </message>
    <message>
        <source>Change the limits of %1</source>
        <translation>Grenzen von %1 ändern</translation>
    </message>
    <message>
        <source>Change the look of %1</source>
        <translation>Aussehen von %1 ändern</translation>
    </message>
    <message>
        <source>Change the second colour of %1</source>
        <translation>Zweite Farbe von %1 ändern</translation>
    </message>
    <message>
        <source>Change the kind of %1</source>
        <translation>Art von %1 ändern</translation>
    </message>
    <message>
        <source>there is no place for the files of this project</source>
        <translation>für die Dateien dieses Projekts gibt es keinen Ort</translation>
    </message>
    <message>
        <source>A side of this seam does not end at corners: its length cannot be changed alone.</source>
        <translation>Eine Seite dieser Naht endet nicht an Ecken: Ihre Länge lässt sich nicht für sich ändern.</translation>
    </message>
    <message>
        <source>These edges cannot have this length: they hang together.</source>
        <translation>Diese Kanten können diese Länge nicht haben: Sie hängen zusammen.</translation>
    </message>
    <message>
        <source>Change the length of an edge of %1</source>
        <translation>Länge einer Kante von %1 ändern</translation>
    </message>
    <message>
        <source>Change the length of %1 edges</source>
        <translation>Länge von %1 Kanten ändern</translation>
    </message>
    <message>
        <source>Make %1 edges equally long</source>
        <translation>%1 Kanten gleich lang machen</translation>
    </message>
    <message>
        <source>Make the sides of a seam equally long</source>
        <translation>Seiten einer Naht gleich lang machen</translation>
    </message>
    <message>
        <source>Make the sides of %1 seams equally long</source>
        <translation>Seiten von %1 Nähten gleich lang machen</translation>
    </message>
    <message>
        <source>There is a &quot;%1&quot; already: this one is called &quot;%2&quot;.</source>
        <translation>„%1“ gibt es schon: Dieses hier heißt „%2“.</translation>
    </message>
    <message>
        <source>Change the size of %1 patches</source>
        <translation>Größe von %1 Schnittteilen ändern</translation>
    </message>
    <message>
        <source>%1: the rows hold more than the header of the file says; what is too much in each was left out</source>
        <translation>%1: die Zeilen enthalten mehr, als der Kopf der Datei angibt; was in jeder zu viel ist, wurde weggelassen</translation>
    </message>
    <message>
        <source>this changes more at once than can be stored: at most %1 MB, and %2 keys; do it in parts</source>
        <translation>das ändert auf einmal mehr, als gespeichert werden kann: höchstens %1 MB und %2 Schlüssel; gehen Sie in Teilen vor</translation>
    </message>
    <message>
        <source>&quot;%1&quot; unpacks to more than any project; it was not made by Bolster, or is damaged</source>
        <translation>„%1“ ist entpackt größer als jedes Projekt; die Datei stammt nicht von Bolster oder ist beschädigt</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which recovers projects for Bolster, cannot be started; install Bolster again</source>
        <translation>das Programm „%1“, das für Bolster Projekte rettet, kann nicht gestartet werden; Bolster neu installieren</translation>
    </message>
    <message>
        <source>nothing in &quot;%1&quot; can be saved: it is damaged in a way that takes too much time or memory</source>
        <translation>aus „%1“ lässt sich nichts retten: die Datei ist so beschädigt, dass es zu viel Zeit oder Speicher braucht</translation>
    </message>
    <message>
        <source>lost: the table &quot;%1&quot;, which is missing or has other columns than it should</source>
        <translation>verloren: die Tabelle „%1“; sie fehlt oder hat andere Spalten, als sie sollte</translation>
    </message>
    <message>
        <source>lost: %1 more such gaps</source>
        <translation>verloren: %1 weitere solche Lücken</translation>
    </message>
    <message>
        <source>what comes after version %1 takes too long to recover</source>
        <translation>was nach Version %1 kommt, zu retten dauert zu lange</translation>
    </message>
    <message>
        <source>the edit of version %1 does not lead to the design that was kept with it</source>
        <translation>die Bearbeitung von Version %1 führt nicht zu dem Entwurf, der damit aufgehoben wurde</translation>
    </message>
    <message>
        <source>it pushes nothing: no part of the frame lies under the cover</source>
        <translation>sie drückt nichts: kein Teil des Gestells liegt unter dem Bezug</translation>
    </message>
    <message>
        <source>contact looks at the frame in steps of %1 mm; something of these parts is thinner, so that the cover may pass through: %2; make it thicker</source>
        <translation>der Kontakt tastet das Gestell in Schritten von %1 mm ab; an diesen Teilen ist etwas dünner, sodass der Bezug hindurchgehen kann: %2; machen Sie es dicker</translation>
    </message>
    <message>
        <source>contact does nothing: in steps of %1 mm it finds no inside of the frame, which is thinner than that, or so open that it has none; close the frame, or make it thicker</source>
        <translation>der Kontakt bewirkt nichts: in Schritten von %1 mm findet er kein Inneres des Gestells; es ist dünner oder so offen, dass es keines hat; schließen Sie das Gestell, oder machen Sie es dicker</translation>
    </message>
    <message>
        <source>%1 lies in folds: there is more cloth than room for it</source>
        <translation>%1 liegt in Falten: es ist mehr Stoff da, als Platz hat</translation>
    </message>
    <message>
        <source>%1 floats free: nothing holds it, and it is sewn to nothing that is held</source>
        <translation>%1 schwebt frei: nichts hält es, und es ist an nichts genäht, das gehalten wird</translation>
    </message>
    <message>
        <source>%1 holds the cloth %2 mm off the frame</source>
        <translation>%1 hält den Stoff %2 mm vom Gestell entfernt</translation>
    </message>
    <message>
        <source>The seam of %1 and %2 has %3 % ease: it puckers above %4 %</source>
        <translation>Die Naht von %1 und %2 hat %3 % Mehrweite: über %4 % kräuselt sie sich</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations.</source>
        <translation>Die Oberfläche ist nach %1 Schritten davongelaufen.</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations: %2 holds it %3 mm from everything else. Bring that curve nearer.</source>
        <translation>Die Oberfläche ist nach %1 Schritten davongelaufen: %2 hält sie %3 mm von allem anderen entfernt. Rücken Sie diese Kurve näher heran.</translation>
    </message>
    <message>
        <source>The equations of the cover could not be solved: %1 is degenerate or its numbers are too large. Check its outline and its fabric.</source>
        <translation>Die Gleichungen des Bezugs ließen sich nicht lösen: %1 ist entartet, oder die Zahlen darin sind zu groß. Prüfen Sie Umriss und Stoff.</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations: the pressure of %2 (%3) is too high for its fabric. Lower it.</source>
        <translation>Die Oberfläche ist nach %1 Schritten davongelaufen: Der Druck von %2 (%3) ist für den Stoff zu hoch. Verringern Sie ihn.</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations, most likely because of %2. Check the size of that patch, its pressure and its fabric.</source>
        <translation>Die Oberfläche ist nach %1 Schritten davongelaufen, höchstwahrscheinlich wegen %2. Prüfen Sie Größe, Druck und Stoff dieses Schnittteils.</translation>
    </message>
    <message>
        <source>Change the material of %1</source>
        <translation>Material von %1 ändern</translation>
    </message>
    <message>
        <source>Show a part of %1</source>
        <translation>Einen Teil von %1 zeigen</translation>
    </message>
    <message>
        <source>Hide a part of %1</source>
        <translation>Einen Teil von %1 ausblenden</translation>
    </message>
    <message>
        <source>Show all parts of %1</source>
        <translation>Alle Teile von %1 zeigen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a link to &quot;%2&quot; now</source>
        <translation>„%1“ ist jetzt eine Verknüpfung auf „%2“</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was changed by another program</source>
        <translation>„%1“ wurde von einem anderen Programm geändert</translation>
    </message>
    <message>
        <source>somebody else has changed &quot;%1&quot; since it was opened here</source>
        <translation>jemand anders hat „%1“ geändert, seit es hier geöffnet wurde</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is another project now</source>
        <translation>„%1“ ist jetzt ein anderes Projekt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be renamed (%2)</source>
        <translation>„%1“ kann nicht umbenannt werden (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: the content number %2 cannot be read</source>
        <translation>„%1“ ist beschädigt: Der Inhalt Nummer %2 kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: a row holds something of another kind than it should</source>
        <translation>„%1“ ist beschädigt: In einer Zeile steht etwas von anderer Art, als es sollte</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: row %2 of the table &quot;%3&quot; contradicts others</source>
        <translation>„%1“ ist beschädigt: Zeile %2 der Tabelle „%3“ widerspricht anderen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: parts of the file are not what was written</source>
        <translation>„%1“ ist beschädigt: Teile der Datei sind nicht, was geschrieben wurde</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: rows are missing, or there are some too many</source>
        <translation>„%1“ ist beschädigt: Zeilen fehlen, oder es gibt zu viele</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: the edits up to number %2 do not lead to the design that was stored with them</source>
        <translation>„%1“ ist beschädigt: Die Bearbeitungen bis Nummer %2 führen nicht zu dem Entwurf, der mit ihnen gespeichert wurde</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: row %2 of the table &quot;%3&quot; is not what was written</source>
        <translation>„%1“ ist beschädigt: Zeile %2 der Tabelle „%3“ ist nicht, was geschrieben wurde</translation>
    </message>
    <message>
        <source>there is no picture to write</source>
        <translation>es gibt kein Bild zum Schreiben</translation>
    </message>
    <message>
        <source>%1: a face has %2 corners, and at most %3 are read; have it split into triangles by the program that has made the file</source>
        <translation>%1: eine Fläche hat %2 Ecken, und höchstens %3 werden gelesen; das Programm, aus dem die Datei kommt, soll sie in Dreiecke teilen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: no file can be made in &quot;%2&quot;; choose another folder</source>
        <translation>„%1“ lässt sich nicht schreiben: in „%2“ kann keine Datei angelegt werden; wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>at most %1 cushions push; this one and those after it are left out</source>
        <translation>höchstens %1 Polsterungen drücken; diese und die nach ihr bleiben weg</translation>
    </message>
    <message>
        <source>the picture cannot be encoded (%1)</source>
        <translation>das Bild kann nicht kodiert werden (%1)</translation>
    </message>
    <message>
        <source>a smallest detail of %1 mm is too fine for a frame as large as this (%2 million cubes of it, and %3 are the limit), so the cushion is left out; take at least %4 mm</source>
        <translation>eine kleinste Einzelheit von %1 mm ist zu fein für ein so großes Gestell (%2 Millionen Würfel davon, erlaubt sind %3), deshalb wird die Polsterung ausgelassen. Nehmen Sie mindestens %4 mm</translation>
    </message>
    <message>
        <source>something of these parts of the frame is thinner than the smallest detail of the padding, %1 mm, so that it may have gaps there: %2; take a smaller detail</source>
        <translation>an diesen Teilen des Gestells ist etwas dünner als die kleinste Einzelheit der Polsterung, %1 mm, sodass sie dort Lücken haben kann: %2; nehmen Sie eine kleinere</translation>
    </message>
    <message>
        <source>it pushes nothing: with a smallest detail of %1 mm there is no inside of the frame, which is thinner than that, or so open that it has none; take a smaller detail, or close the frame</source>
        <translation>sie drückt nichts: Bei einer kleinsten Einzelheit von %1 mm hat das Gestell kein Inneres; es ist dünner oder so offen, dass es keines hat; nehmen Sie eine kleinere, oder schließen Sie das Gestell</translation>
    </message>
    <message>
        <source>Change the slanted faces of %1</source>
        <translation>Die schrägen Flächen von %1 ändern</translation>
    </message>
    <message>
        <source>Change the smallest detail of %1</source>
        <translation>Die kleinste Einzelheit von %1 ändern</translation>
    </message>
    <message>
        <source>the log of &quot;%1&quot; is damaged: the last edits cannot be read</source>
        <translation>das Protokoll von „%1“ ist beschädigt: die letzten Bearbeitungen lassen sich nicht lesen</translation>
    </message>
    <message>
        <source>the kind %1 is unknown; there are %2 and %3</source>
        <translation>die Art %1 ist unbekannt; es gibt %2 und %3</translation>
    </message>
    <message>
        <source>its label finds no room: make the words shorter, or put it elsewhere</source>
        <translation>seine Beschriftung findet keinen Platz: Worte kürzen oder an eine andere Stelle setzen</translation>
    </message>
    <message>
        <source>its cut lines meet here: make the allowance smaller</source>
        <translation>seine Schnittlinien treffen hier zusammen: Zugabe verkleinern</translation>
    </message>
    <message>
        <source>a notch of %1 mm reaches the sewing line, which is %2 mm away: make it shallower, or the allowance wider</source>
        <translation>ein Knips von %1 mm reicht bis zur Nahtlinie, die %2 mm entfernt ist: flacher machen oder die Zugabe verbreitern</translation>
    </message>
    <message>
        <source>nothing is sewn where it is, so it has no partner</source>
        <translation>wo er ist, wird nichts genäht, also hat er kein Gegenstück</translation>
    </message>
    <message>
        <source>it has no partner on the other side of its seam: another notch is too near there</source>
        <translation>er hat kein Gegenstück auf der anderen Seite der Naht: dort ist ein anderer Knips zu nah</translation>
    </message>
    <message>
        <source>it is %1 mm wide across the grain, but &quot;%2&quot; only %3 mm: split it, or turn its grain</source>
        <translation>es ist quer zum Fadenlauf %1 mm breit, „%2“ aber nur %3 mm: teilen oder den Fadenlauf drehen</translation>
    </message>
    <message>
        <source>an inner corner of %1 degrees is too sharp for its seam allowances: make them smaller there, or the corner wider</source>
        <translation>eine innere Ecke von %1 Grad ist zu spitz für ihre Nahtzugaben: dort verkleinern oder die Ecke öffnen</translation>
    </message>
    <message>
        <source>There is no such place on an outline.</source>
        <translation>Eine solche Stelle auf einem Umriss gibt es nicht.</translation>
    </message>
    <message>
        <source>A part of this stretch of %1 has a seam allowance of its own already: change that one, or choose another stretch.</source>
        <translation>Ein Teil dieses Abschnitts von %1 hat schon eine eigene Nahtzugabe: diese ändern oder einen anderen Abschnitt wählen.</translation>
    </message>
    <message>
        <source>There is a notch of %1 at this place already.</source>
        <translation>An dieser Stelle von %1 ist schon ein Knips.</translation>
    </message>
    <message>
        <source>This corner of %1 has a join of its own already.</source>
        <translation>Diese Ecke von %1 hat schon eine eigene Form.</translation>
    </message>
    <message>
        <source>Change the seam allowance of %1 patches</source>
        <translation>Nahtzugabe von %1 Teilen ändern</translation>
    </message>
    <message>
        <source>Change the seam allowance of an edge of %1</source>
        <translation>Nahtzugabe einer Kante von %1 ändern</translation>
    </message>
    <message>
        <source>Change a corner of the cut line of %1</source>
        <translation>Ecke der Schnittlinie von %1 ändern</translation>
    </message>
    <message>
        <source>Add a notch to %1</source>
        <translation>Knips an %1 setzen</translation>
    </message>
    <message>
        <source>Move a notch</source>
        <translation>Knips verschieben</translation>
    </message>
    <message>
        <source>Move the join of a corner</source>
        <translation>Form einer Ecke verschieben</translation>
    </message>
    <message>
        <source>A drill hole must lie inside its patch.</source>
        <translation>Ein Bohrloch muss in seinem Teil liegen.</translation>
    </message>
    <message>
        <source>Move %1 drill holes</source>
        <translation>%1 Bohrlöcher verschieben</translation>
    </message>
    <message>
        <source>Move the label of %1</source>
        <translation>Beschriftung von %1 verschieben</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that has its own seam allowance.</source>
        <translation>Der Abschnitt würde einen anderen von %1 mit eigener Nahtzugabe überlappen.</translation>
    </message>
    <message>
        <source>Give an edge its own seam allowance</source>
        <translation>Einer Kante eine eigene Nahtzugabe geben</translation>
    </message>
    <message>
        <source>Change a corner of the cut line</source>
        <translation>Ecke der Schnittlinie ändern</translation>
    </message>
    <message>
        <source>Add drill hole %1</source>
        <translation>Bohrloch %1 hinzufügen</translation>
    </message>
    <message>
        <source>Change the diameter of %1</source>
        <translation>Durchmesser von %1 ändern</translation>
    </message>
    <message>
        <source>Change the notches of %1</source>
        <translation>Knipse von %1 ändern</translation>
    </message>
    <message>
        <source>Change the automatic notches</source>
        <translation>Automatische Knipse ändern</translation>
    </message>
    <message>
        <source>Add a notch</source>
        <translation>Knips hinzufügen</translation>
    </message>
    <message>
        <source>Change how %1 is cut</source>
        <translation>Zuschnitt von %1 ändern</translation>
    </message>
    <message>
        <source>Change how the pattern is cut</source>
        <translation>Zuschnitt des Schnitts ändern</translation>
    </message>
    <message>
        <source>Add internal line %1</source>
        <translation>Innenlinie %1 hinzufügen</translation>
    </message>
    <message>
        <source>Change the purpose of %1</source>
        <translation>Zweck von %1 ändern</translation>
    </message>
    <message>
        <source>Change the ease of %1</source>
        <translation>Mehrweite von %1 ändern</translation>
    </message>
    <message>
        <source>is %1, but must be a whole number; %2 are cut</source>
        <translation>ist %1, muss aber eine ganze Zahl sein; %2 werden geschnitten</translation>
    </message>
    <message>
        <source>%1 is an allowance of a part of this stretch already; remove one of the two, or make their stretches meet</source>
        <translation>%1 ist schon eine Zugabe eines Teils dieses Abschnitts; eine der beiden entfernen, oder die Abschnitte aneinanderstoßen lassen</translation>
    </message>
    <message>
        <source>the hole lies outside of &quot;%1&quot;; move it inside</source>
        <translation>das Loch liegt außerhalb von „%1“; nach innen verschieben</translation>
    </message>
    <message>
        <source>its sides are %1 mm and %2 mm long: true the seam, or say in its properties how much ease is wanted</source>
        <translation>ihre Seiten sind %1 mm und %2 mm lang: Seiten angleichen, oder in den Eigenschaften sagen, wie viel Mehrweite gewünscht ist</translation>
    </message>
    <message>
        <source>its sides are %1 mm and %2 mm long, but the second one shall be longer by %3 mm: true the seam, or change the ease in its properties</source>
        <translation>ihre Seiten sind %1 mm und %2 mm lang, die zweite soll aber um %3 mm länger sein: Seiten angleichen, oder die Mehrweite in den Eigenschaften ändern</translation>
    </message>
    <message>
        <source>The mouth of a dart must be at least 1 mm wide.</source>
        <translation>Die Öffnung eines Abnähers muss mindestens 1 mm breit sein.</translation>
    </message>
    <message>
        <source>The tip of a dart must lie inside its patch, at least 5 mm from its mouth.</source>
        <translation>Die Spitze eines Abnähers muss in seinem Teil liegen, mindestens 5 mm von der Öffnung entfernt.</translation>
    </message>
    <message>
        <source>The legs of the dart would cross the outline of %1: put its tip elsewhere.</source>
        <translation>Die Schenkel des Abnähers würden den Umriss von %1 kreuzen: Spitze an eine andere Stelle setzen.</translation>
    </message>
    <message>
        <source>Add a dart to %1</source>
        <translation>Abnäher in %1 setzen</translation>
    </message>
    <message>
        <source>Select the seam of a dart.</source>
        <translation>Die Naht eines Abnähers auswählen.</translation>
    </message>
    <message>
        <source>Without this dart the outline of %1 would cross itself.</source>
        <translation>Ohne diesen Abnäher würde der Umriss von %1 sich kreuzen.</translation>
    </message>
    <message>
        <source>Move a dart of %1</source>
        <translation>Abnäher von %1 verschieben</translation>
    </message>
    <message>
        <source>there is no piece in it</source>
        <translation>es ist kein Teil darin</translation>
    </message>
    <message>
        <source>Import a pattern of %1 pieces</source>
        <translation>Schnitt aus %1 Teilen importieren</translation>
    </message>
    <message>
        <source>%1 is left out: its outline crosses itself or encloses nothing</source>
        <translation>%1 ist weggelassen: Sein Umriss kreuzt sich selbst oder umschließt nichts</translation>
    </message>
    <message>
        <source>%1: %2 notches or lines belong to nothing and are left out</source>
        <translation>%1: %2 Knipse oder Linien gehören zu nichts und sind weggelassen</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 points)</source>
        <translation>%1: Darin ist mehr gezeichnet, als ein Schnitt haben kann (über %2 Punkte)</translation>
    </message>
    <message>
        <source>%1: the file is larger than a pattern can be (%2 MB)</source>
        <translation>%1: Die Datei ist größer, als ein Schnitt sein kann (%2 MB)</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a group code of DXF</source>
        <translation>%1: „%2“ ist kein Gruppencode von DXF</translation>
    </message>
    <message>
        <source>%1: the file ends in the middle of something</source>
        <translation>%1: Die Datei hört mittendrin auf</translation>
    </message>
    <message>
        <source>%1 is not a DXF file: it has no sections</source>
        <translation>%1 ist keine DXF-Datei: Sie hat keine Abschnitte</translation>
    </message>
    <message>
        <source>%1 is not an SVG file</source>
        <translation>%1 ist keine SVG-Datei</translation>
    </message>
    <message>
        <source>%1: this is not well-formed XML (%2)</source>
        <translation>%1: Das ist kein wohlgeformtes XML (%2)</translation>
    </message>
    <message>
        <source>Sew %1 proposed seams</source>
        <translation>%1 vorgeschlagene Nähte nähen</translation>
    </message>
    <message>
        <source>Remove a dart of %1</source>
        <translation>Einen Abnäher von %1 entfernen</translation>
    </message>
    <message>
        <source>Move the tip of a dart of %1</source>
        <translation>Die Spitze eines Abnähers von %1 verschieben</translation>
    </message>
    <message>
        <source>Opened there, the outline of %1 would cross itself.</source>
        <translation>Dort geöffnet, würde der Umriss von %1 sich selbst kreuzen.</translation>
    </message>
    <message>
        <source>The legs of the dart must be of one length to be rotated: drag its tip onto the dotted line.</source>
        <translation>Zum Verlegen müssen die Schenkel des Abnähers gleich lang sein: Ziehen Sie seine Spitze auf die punktierte Linie.</translation>
    </message>
    <message>
        <source>A dart is rotated to a place at least 5 mm from its mouth.</source>
        <translation>Ein Abnäher wird an eine Stelle verlegt, die mindestens 5 mm von seiner Öffnung entfernt ist.</translation>
    </message>
    <message>
        <source>The line from the tip of the dart to there would leave %1.</source>
        <translation>Die Linie von der Spitze des Abnähers dorthin würde %1 verlassen.</translation>
    </message>
    <message>
        <source>%1 lies across the line from the tip of the dart to there: move it, or rotate the dart elsewhere.</source>
        <translation>%1 liegt quer über der Linie von der Spitze des Abnähers dorthin: Verschieben Sie das, oder verlegen Sie den Abnäher anderswohin.</translation>
    </message>
    <message>
        <source>Rotate a dart of %1</source>
        <translation>Einen Abnäher von %1 verlegen</translation>
    </message>
    <message>
        <source>Smooth outlines across ends of seams</source>
        <translation>Umrisse über Nahtenden glätten</translation>
    </message>
    <message>
        <source>This seam ends in no corners: there is nothing to smooth.</source>
        <translation>Diese Naht endet in keinen Ecken: Es gibt nichts zu glätten.</translation>
    </message>
    <message>
        <source>The outlines meet at more than 60° there: that is a corner, and stays one.</source>
        <translation>Die Umrisse treffen sich dort um mehr als 60° geknickt: Das ist eine Ecke und bleibt eine.</translation>
    </message>
    <message>
        <source>Sew earlier</source>
        <translation>Früher nähen</translation>
    </message>
    <message>
        <source>Sew later</source>
        <translation>Später nähen</translation>
    </message>
    <message>
        <source>Sew in the proposed order</source>
        <translation>In der vorgeschlagenen Folge nähen</translation>
    </message>
    <message>
        <source>Change the zip of %1</source>
        <translation>Reißverschluss von %1 ändern</translation>
    </message>
    <message>
        <source>Change when %1 is sewn</source>
        <translation>Ändern, wann %1 genäht wird</translation>
    </message>
    <message>
        <source>its sides have allowances of %1 mm and %2 mm: make them alike, or mind it when they are laid together</source>
        <translation>ihre Seiten haben Zugaben von %1 mm und %2 mm: gleichen Sie sie an, oder achten Sie darauf, wenn sie aufeinander gelegt werden</translation>
    </message>
    <message>
        <source>This edge of %1 is not as long as that.</source>
        <translation>Diese Kante von %1 ist nicht so lang.</translation>
    </message>
    <message>
        <source>the pattern is so large that the edge length of its triangles becomes %1 mm; is the unit right?</source>
        <translation>der Schnitt ist so groß, dass die Kantenlänge seiner Dreiecke %1 mm wird; stimmt die Einheit?</translation>
    </message>
    <message>
        <source>%1 is left out: it is %2 m large, the most is %3 m; is the unit right?</source>
        <translation>%1 ist weggelassen: Es ist %2 m groß, möglich sind %3 m; stimmt die Einheit?</translation>
    </message>
    <message>
        <source>%1 is left out: its outline has fewer than three points</source>
        <translation>%1 ist weggelassen: Sein Umriss hat weniger als drei Punkte</translation>
    </message>
    <message>
        <source>%1 is left out: of the %2 points of its outline no curve with at most %3 can be made</source>
        <translation>%1 ist weggelassen: Aus den %2 Punkten seines Umrisses lässt sich keine Kurve mit höchstens %3 machen</translation>
    </message>
    <message>
        <source>%1: its outline has more than %2 points and is simplified, by %3 mm at most</source>
        <translation>%1: Sein Umriss hat mehr als %2 Punkte und wird vereinfacht, um höchstens %3 mm</translation>
    </message>
    <message>
        <source>%1: its quantity &quot;%2&quot; is no number of pieces; it is cut once until somebody says how often</source>
        <translation>%1: Seine Anzahl „%2“ ist keine Stückzahl; es wird einmal zugeschnitten, bis jemand sagt, wie oft</translation>
    </message>
    <message>
        <source>%1: its quantity %2 is more than possible and becomes %3</source>
        <translation>%1: Seine Anzahl %2 ist mehr als möglich und wird %3</translation>
    </message>
    <message>
        <source>%1: %2 drill holes are narrower than %3 mm or wider than %4 mm and become as wide as possible</source>
        <translation>%1: %2 Bohrlöcher sind enger als %3 mm oder weiter als %4 mm und werden so weit wie möglich</translation>
    </message>
    <message>
        <source>%1 is left out: it would be a patch with mistakes</source>
        <translation>%1 ist weggelassen: Es wäre ein Teil mit Fehlern</translation>
    </message>
    <message>
        <source>%1: the file ends in the middle of its section %2, so it is not whole; get it once more</source>
        <translation>%1: Die Datei endet mitten in ihrem Abschnitt %2, ist also nicht ganz; holen Sie sie noch einmal</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 groups)</source>
        <translation>%1: Darin ist mehr gezeichnet, als ein Schnitt haben kann (über %2 Gruppen)</translation>
    </message>
    <message>
        <source>%1: %2 is larger than any pattern (%3)</source>
        <translation>%1: %2 ist größer als jeder Schnitt (%3)</translation>
    </message>
    <message>
        <source>the mark at the end of the file (EOF) is missing: look whether everything is there</source>
        <translation>die Marke am Ende der Datei (EOF) fehlt: Sehen Sie nach, ob alles da ist</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is inserted more often than a pattern needs (over %3 times)</source>
        <translation>%1: „%2“ wird öfter eingefügt, als ein Schnitt es braucht (über %3-mal)</translation>
    </message>
    <message>
        <source>%1: an element has more than %2 attributes</source>
        <translation>%1: Ein Element hat mehr als %2 Attribute</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 elements)</source>
        <translation>%1: Darin ist mehr gezeichnet, als ein Schnitt haben kann (über %2 Elemente)</translation>
    </message>
    <message>
        <source>%1: elements lie in each other more than %2 times</source>
        <translation>%1: Elemente liegen mehr als %2-mal ineinander</translation>
    </message>
    <message>
        <source>&quot;%1&quot; would be replaced, which is needed; choose another name</source>
        <translation>„%1“ würde ersetzt, wird aber gebraucht; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>there is no cover yet: nothing is sewn or solved</source>
        <translation>es gibt noch keinen Bezug: nichts ist genäht oder berechnet</translation>
    </message>
    <message>
        <source>there is not enough memory for this file</source>
        <translation>für diese Datei reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>the cover cannot be made a file (%1)</source>
        <translation>aus dem Bezug lässt sich keine Datei machen (%1)</translation>
    </message>
    <message>
        <source>the cover is %1 mm thick and has %2 cm³</source>
        <translation>der Bezug ist %1 mm dick und hat %2 cm³</translation>
    </message>
    <message>
        <source>there is no room for foam between the frame and the cover</source>
        <translation>zwischen Gestell und Bezug ist kein Platz für Schaum</translation>
    </message>
    <message>
        <source>the foam has %1 l and weighs %2 kg at %3 kg/m³</source>
        <translation>der Schaum hat %1 l und wiegt %2 kg bei %3 kg/m³</translation>
    </message>
    <message>
        <source>there are neither fixation curves nor seams</source>
        <translation>es gibt weder Fixierkurven noch Nähte</translation>
    </message>
    <message>
        <source>The three places lie on a line: choose some that do not.</source>
        <translation>Die drei Stellen liegen auf einer Linie: wählen Sie andere.</translation>
    </message>
    <message>
        <source>The places are not as far from each other on the scan as where they belong: check the scale of the scan, and which is which.</source>
        <translation>Die Stellen sind auf dem Scan anders voneinander entfernt als dort, wohin sie gehören: prüfen Sie den Maßstab des Scans, und welche welche ist.</translation>
    </message>
    <message>
        <source>The scan could not be aligned: there are not enough of its points where it would stand. Click other places, or bring back what is cut away of it.</source>
        <translation>Der Scan konnte nicht ausgerichtet werden: dort, wo er stünde, sind zu wenige seiner Punkte. Klicken Sie andere Stellen an, oder holen Sie zurück, was von ihm weggeschnitten ist.</translation>
    </message>
    <message>
        <source>%1: the numbers of &quot;%2&quot; are not described as they must be: &quot;%3&quot;</source>
        <translation>%1: die Zahlen von „%2“ sind nicht so beschrieben, wie es sein muss: „%3“</translation>
    </message>
    <message>
        <source>%1: the file is damaged: something is said to be at byte %2, where nothing can be; copy it again, or export the scan anew</source>
        <translation>%1: die Datei ist beschädigt: etwas soll bei Byte %2 sein, wo nichts sein kann; kopieren Sie sie noch einmal, oder exportieren Sie den Scan neu</translation>
    </message>
    <message>
        <source>%1: the file is damaged: a checksum is wrong; copy it again, or export the scan anew</source>
        <translation>%1: die Datei ist beschädigt: eine Prüfsumme ist falsch; kopieren Sie sie noch einmal, oder exportieren Sie den Scan neu</translation>
    </message>
    <message>
        <source>%1 is not an E57 file</source>
        <translation>%1 ist keine E57-Datei</translation>
    </message>
    <message>
        <source>%1: E57 of version %2 cannot be read, or its pages have another size than 1024; export the scan as E57 1.0</source>
        <translation>%1: E57 der Version %2 ist nicht lesbar, oder die Seiten haben eine andere Größe als 1024; exportieren Sie den Scan als E57 1.0</translation>
    </message>
    <message>
        <source>%1: the pose of a scan is no rotation and translation</source>
        <translation>%1: die Lage eines Scans ist keine Drehung und Verschiebung</translation>
    </message>
    <message>
        <source>%1: two scans are said to be at one place of the file; export them anew</source>
        <translation>%1: zwei Scans sollen an derselben Stelle der Datei sein; exportieren Sie sie neu</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; of the points is missing or no number of things</source>
        <translation>%1: „%2“ der Punkte fehlt oder ist keine Anzahl</translation>
    </message>
    <message>
        <source>%1: the file is damaged: a packet of points is not as it must be; export the scan anew</source>
        <translation>%1: die Datei ist beschädigt: ein Paket von Punkten ist nicht so, wie es sein muss; exportieren Sie den Scan neu</translation>
    </message>
    <message>
        <source>%1: the points are packed by &quot;%2&quot;, which cannot be read; export the scan without an extension</source>
        <translation>%1: die Punkte sind mit „%2“ gepackt, das nicht lesbar ist; exportieren Sie den Scan ohne Erweiterung</translation>
    </message>
    <message>
        <source>%1: more is described in it than a scan can have</source>
        <translation>%1: es ist mehr darin beschrieben, als ein Scan haben kann</translation>
    </message>
    <message>
        <source>%1: numbers that belong to one point lie too far from each other; export the scan anew</source>
        <translation>%1: Zahlen, die zu einem Punkt gehören, liegen zu weit auseinander; exportieren Sie den Scan neu</translation>
    </message>
    <message>
        <source>%1: a document type is not expected here</source>
        <translation>%1: ein Dokumenttyp wird hier nicht erwartet</translation>
    </message>
    <message>
        <source>%1 is not a LAS file</source>
        <translation>%1 ist keine LAS-Datei</translation>
    </message>
    <message>
        <source>%1 is compressed (LAZ), which cannot be read: save it as LAS, for example with laszip or CloudCompare, or as E57</source>
        <translation>%1 ist komprimiert (LAZ) und so nicht lesbar: speichern Sie sie als LAS, zum Beispiel mit laszip oder CloudCompare, oder als E57</translation>
    </message>
    <message>
        <source>%1: points of format %2 with %3 bytes cannot be read; save them as LAS 1.2 or 1.4</source>
        <translation>%1: Punkte im Format %2 mit %3 Bytes sind nicht lesbar; speichern Sie sie als LAS 1.2 oder 1.4</translation>
    </message>
    <message>
        <source>%1: its scale and offset make no points</source>
        <translation>%1: Maßstab und Versatz ergeben keine Punkte</translation>
    </message>
    <message>
        <source>%1: the points are said to begin within the header</source>
        <translation>%1: die Punkte sollen schon im Kopf beginnen</translation>
    </message>
    <message>
        <source>The second side ends inside an edge, so the first one was changed.</source>
        <translation>Die zweite Seite endet innerhalb einer Kante, also wurde die erste geändert.</translation>
    </message>
    <message>
        <source>it has no triangle with an area</source>
        <translation>es hat kein Dreieck mit einer Fläche</translation>
    </message>
    <message>
        <source>%1 is left out: laid flat it would lie over itself. Divide it, or cut it in where it bulges most</source>
        <translation>%1 ist weggelassen: Flach gelegt läge es über sich selbst. Teilen Sie es, oder schneiden Sie es dort ein, wo es sich am meisten wölbt</translation>
    </message>
    <message>
        <source>the stretch does not lie on its outline any more. Sew or fix it anew.</source>
        <translation>der Abschnitt liegt nicht mehr auf seinem Umriss. Nähen oder befestigen Sie ihn neu.</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which reads such files for Bolster, cannot be started; install Bolster again</source>
        <translation>das Programm „%1“, das für Bolster solche Dateien liest, lässt sich nicht starten; Bolster neu installieren</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes too long to read; export fewer parts of it, or triangles (OBJ, STL) instead</source>
        <translation>„%1“ zu lesen dauert zu lange; weniger Teile davon exportieren, oder stattdessen Dreiecke (OBJ, STL)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be read: it is damaged, or needs too much memory; export it again, or fewer parts of it, from the program that it comes from</source>
        <translation>„%1“ ließ sich nicht lesen: Die Datei ist beschädigt oder braucht zu viel Speicher; sie oder weniger Teile davon mit dem Programm, aus dem sie stammt, neu exportieren</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds no faces, and a frame needs some; export bodies or surfaces, not lines and points alone</source>
        <translation>„%1“ enthält keine Flächen, und ein Gestell braucht welche; Körper oder Flächen exportieren, nicht nur Linien und Punkte</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than %2 triangles; export fewer parts of it, or coarser</source>
        <translation>„%1“ hat mehr als %2 Dreiecke; weniger Teile davon exportieren, oder gröber</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than %2 parts; export those that the cover touches</source>
        <translation>„%1“ hat mehr als %2 Teile; die exportieren, die der Bezug berührt</translation>
    </message>
    <message>
        <source>%1: the part &quot;%2&quot; reaches beyond 10,000,000; export it without that part, or near the origin</source>
        <translation>%1: Das Teil „%2“ reicht über 10.000.000 hinaus; ohne dieses Teil exportieren, oder nahe am Ursprung</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs the file &quot;%2&quot; in its own folder; copy it there, or export as GLB, which is one file</source>
        <translation>„%1“ braucht die Datei „%2“ im selben Ordner; sie dorthin kopieren, oder als GLB exportieren, das ist eine einzige Datei</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged or incomplete, or not what its ending says; export it again from the program that it comes from</source>
        <translation>„%1“ ist beschädigt oder unvollständig, oder nicht das, was die Endung sagt; mit dem Programm, aus dem die Datei stammt, neu exportieren</translation>
    </message>
    <message>
        <source>%1: %2 triangles are left out: their corners are no numbers</source>
        <translation>%1: %2 Dreiecke sind weggelassen: Ihre Ecken sind keine Zahlen</translation>
    </message>
    <message>
        <source>%1: parts are left out that are scaled to nothing: %2, the first is &quot;%3&quot;</source>
        <translation>%1: Teile sind weggelassen, die auf nichts verkleinert sind: %2, das erste ist „%3“</translation>
    </message>
    <message>
        <source>%1: %2 faces could not be made triangles of, and leave holes</source>
        <translation>%1: %2 Flächen ließen sich nicht in Dreiecke zerlegen und hinterlassen Löcher</translation>
    </message>
    <message>
        <source>%1: %2 parts are left out that lie too deep in the tree</source>
        <translation>%1: %2 Teile sind weggelassen, die zu tief im Baum liegen</translation>
    </message>
    <message>
        <source>%1: the parts in the file &quot;%2&quot; are not read; export all in one file</source>
        <translation>%1: Die Teile in der Datei „%2“ werden nicht gelesen; alles in eine Datei exportieren</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no file that frames are written to; OBJ, PLY and STL are</source>
        <translation>„%1“ ist keine Datei, in die Gestelle geschrieben werden; OBJ, PLY und STL sind es</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a scan that can be read; these can: %2</source>
        <translation>„%1“ ist kein Scan, der sich lesen lässt; lesbar sind: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a frame that can be read; these can: %2</source>
        <translation>„%1“ ist kein Gestell, das sich lesen lässt; lesbar sind: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a pattern that can be read; these can: %2</source>
        <translation>„%1“ ist kein Schnitt, der sich lesen lässt; lesbar sind: %2</translation>
    </message>
    <message>
        <source>nothing is left of the parts that are wanted</source>
        <translation>von den gewünschten Teilen bleibt nichts übrig</translation>
    </message>
    <message>
        <source>nothing is sewn where %1 of its notches are, so they have no partners</source>
        <translation>wo %1 seiner Knipse sind, ist nichts genäht, also haben sie keine Gegenstücke</translation>
    </message>
    <message>
        <source>notches at edges without an allowance cut into the piece: there are %1; give these edges an allowance</source>
        <translation>Knipse an Kanten ohne Nahtzugabe schneiden in das Teil, es sind %1: geben Sie diesen Kanten eine Nahtzugabe</translation>
    </message>
    <message>
        <source>There is a dart already: put this one beside it, or remove that one first.</source>
        <translation>Dort ist schon ein Abnäher: legen Sie diesen daneben, oder entfernen Sie erst jenen.</translation>
    </message>
    <message>
        <source>%1 is left out: with its holes, notches and lines the design would have more than %2 elements</source>
        <translation>%1 wird weggelassen: mit seinen Löchern, Knipsen und Linien hätte der Entwurf mehr als %2 Elemente</translation>
    </message>
    <message>
        <source>%1: its nap &quot;%2&quot; is neither one way, two ways nor any; it is taken for two ways</source>
        <translation>%1: der Strich „%2“ heißt weder eine Richtung noch zwei Richtungen noch beliebig; angenommen werden zwei Richtungen</translation>
    </message>
    <message>
        <source>%1 is drawn larger by what its fabric shrinks (%2), and taken as it is drawn: a shrinkage of the fabric here would come on top</source>
        <translation>%1 ist um den Einlauf des Stoffes (%2) größer gezeichnet und wird so genommen: ein Einlauf des Stoffes hier käme noch dazu</translation>
    </message>
    <message>
        <source>the viewBox &quot;%1&quot; is no four numbers and is left out: check the size of the pieces</source>
        <translation>die viewBox „%1“ besteht nicht aus vier Zahlen und wird übergangen: prüfen Sie die Größe der Teile</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs the file &quot;%2&quot; beside it, and the frame of a design is one file; import it again, or export it as GLB</source>
        <translation>„%1“ braucht die Datei „%2“ daneben, und das Gestell eines Entwurfs ist eine einzige Datei; importieren Sie es noch einmal, oder exportieren Sie es als GLB</translation>
    </message>
    <message>
        <source>99 % of its surface is within %1 mm</source>
        <translation>99 % seiner Oberfläche liegen innerhalb von %1 mm</translation>
    </message>
    <message>
        <source>it reaches beyond its piece: end it at the edge</source>
        <translation>sie reicht über ihr Schnittteil hinaus: am Rand enden lassen</translation>
    </message>
    <message>
        <source>the hole breaks through the edge of its piece: move it inwards, or make it smaller</source>
        <translation>das Loch durchbricht den Rand seines Schnittteils: nach innen rücken oder verkleinern</translation>
    </message>
    <message>
        <source>only %1 mm are left of the piece at the tip of a dart: make it shorter</source>
        <translation>an der Spitze eines Abnähers bleiben vom Schnittteil nur %1 mm: den Abnäher kürzen</translation>
    </message>
    <message>
        <source>%1 of its notches have no partners on the other sides of their seams: others are too near there. Ask for fewer</source>
        <translation>%1 seiner Knipse haben auf der anderen Seite ihrer Nähte keinen Partner: dort liegen andere zu nahe. Weniger verlangen</translation>
    </message>
    <message>
        <source>%1 has %2 sewing lines beside each other; the largest is taken, the others are left out</source>
        <translation>%1 hat %2 Nahtlinien nebeneinander; die größte wird genommen, die anderen werden weggelassen</translation>
    </message>
    <message>
        <source>%1: its cut line lies %2 mm outside of its sewing line, which is wider than an allowance may be; it becomes %3 mm there</source>
        <translation>%1: die Schnittlinie liegt %2 mm außerhalb der Nahtlinie, mehr als eine Nahtzugabe haben darf; dort wird sie %3 mm</translation>
    </message>
    <message>
        <source>The cover is pulled to the scan where it lies now: switch &quot;Fit the cover to it&quot; off, place it, and switch that on again.</source>
        <translation>Der Bezug wird zum Scan gezogen, wo dieser jetzt liegt: Schalten Sie „Bezug daran anpassen“ aus, legen Sie den Scan auf den Bezug, und schalten Sie es wieder ein.</translation>
    </message>
    <message>
        <source>Place on the cover to %2 mm rms: %1 (%3 % of its points matched)</source>
        <translation>Auf den Bezug legen, %2 mm quadr. Mittel: %1 (%3 % seiner Punkte zugeordnet)</translation>
    </message>
    <message>
        <source>The scan could not be placed: it is too far from the cover. Align it by three places, or cut away what does not belong to it.</source>
        <translation>Der Scan konnte nicht auf den Bezug gelegt werden: Er ist zu weit von ihm entfernt. Richten Sie ihn an drei Stellen aus, oder schneiden Sie weg, was nicht dazugehört.</translation>
    </message>
    <message>
        <source>Align to %2 mm rms: %1 (%3 % of its points matched)</source>
        <translation>Ausrichten, %2 mm quadr. Mittel: %1 (%3 % seiner Punkte zugeordnet)</translation>
    </message>
    <message>
        <source>Import the pattern of %1</source>
        <translation>Schnitt von %1 importieren</translation>
    </message>
    <message>
        <source>%1: a gap of %2 mm in its outline is closed by a straight line</source>
        <translation>%1: Eine Lücke von %2 mm in seinem Umriss ist mit einer Geraden geschlossen</translation>
    </message>
    <message>
        <source>%1: its cut line is drawn anew from its allowances, and differs from that of the file by up to %2 mm</source>
        <translation>%1: Seine Schnittlinie wird aus den Nahtzugaben neu gezeichnet und weicht um bis zu %2 mm von der in der Datei ab</translation>
    </message>
    <message>
        <source>the size &quot;%1&quot; of the page is in no unit that is known and is left out: check the size of the pieces</source>
        <translation>die Größe „%1“ der Seite hat keine bekannte Einheit und wird nicht beachtet: Prüfen Sie die Größe der Schnittteile</translation>
    </message>
    <message>
        <source>Sew a proposed seam</source>
        <translation>Eine vorgeschlagene Naht nähen</translation>
    </message>
    <message>
        <source>it is in %1 pieces</source>
        <translation>er besteht aus %1 Stücken</translation>
    </message>
    <message>
        <source>one piece of less than 1 cm³ is left out</source>
        <translation>ein Stück unter 1 cm³ ist weggelassen</translation>
    </message>
    <message>
        <source>%1 pieces of less than 1 cm³ are left out</source>
        <translation>%1 Stücke unter 1 cm³ sind weggelassen</translation>
    </message>
    <message>
        <source>Change whether the cover fits %1</source>
        <translation>Ändern, ob der Bezug an %1 angepasst wird</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs too much memory: it has too many parts, or places them too often; export those that the cover touches</source>
        <translation>„%1“ braucht zu viel Speicher: Sie hat zu viele Teile oder setzt sie zu oft; exportieren Sie die, die der Bezug berührt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has decimal commas; export it with decimal points</source>
        <translation>„%1“ hat Dezimalkommas; exportieren Sie sie mit Dezimalpunkten</translation>
    </message>
    <message>
        <source>%1: triangles are left out that name points which are not in the file</source>
        <translation>%1: Dreiecke sind weggelassen, die Punkte nennen, die nicht in der Datei stehen</translation>
    </message>
    <message>
        <source>%1: %2 triangles are left out: they name points that are not in the file</source>
        <translation>%1: %2 Dreiecke fehlen hier: Sie nennen Punkte, die nicht in der Datei stehen</translation>
    </message>
    <message>
        <source>%1: none of its %2 points has a place</source>
        <translation>%1: Keiner der %2 Punkte hat einen Ort</translation>
    </message>
    <message>
        <source>%1: %2 points are left out: they have no place, as where a scanner saw nothing</source>
        <translation>%1: %2 Punkte sind weggelassen: Sie haben keinen Ort, wie dort, wo ein Scanner nichts gesehen hat</translation>
    </message>
    <message>
        <source>%1 is text in UTF-16, which is not read; save it as UTF-8</source>
        <translation>%1 ist Text in UTF-16, der nicht gelesen wird; speichern Sie ihn als UTF-8</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; has a decimal comma; export with decimal points</source>
        <translation>%1: „%2“ hat ein Dezimalkomma; exportieren Sie mit Dezimalpunkten</translation>
    </message>
    <message>
        <source>Make the pattern of a form</source>
        <translation>Den Schnitt einer Form machen</translation>
    </message>
    <message>
        <source>Fit the pattern to a goal</source>
        <translation>Den Schnitt an ein Ziel anpassen</translation>
    </message>
    <message>
        <source>it has %1 triangles, and cannot be made simpler</source>
        <translation>Sie hat %1 Dreiecke und lässt sich nicht vereinfachen</translation>
    </message>
    <message>
        <source>The form has %1 triangles; %2 stand for it, which are up to %3 mm off</source>
        <translation>Die Form hat %1 Dreiecke; %2 stehen für sie, die bis zu %3 mm daneben liegen</translation>
    </message>
    <message>
        <source>%1 ends inside a piece, at %2: it is cut in there like a dart. The next line or border is %3 mm away; draw it on to there to divide the piece</source>
        <translation>%1 endet in einem Teil, bei %2: Dort wird wie bei einem Abnäher eingeschnitten. Bis zur nächsten Linie oder zum Rand sind es %3 mm; führen Sie sie bis dorthin, um das Teil zu trennen</translation>
    </message>
    <message>
        <source>No place of the cover is near the form: put it where the cover is, in millimetres.</source>
        <translation>Keine Stelle des Bezugs ist in der Nähe der Form: Bringen Sie sie dorthin, wo der Bezug ist, in Millimetern.</translation>
    </message>
    <message>
        <source>Nothing that may change does anything to the cover.</source>
        <translation>Nichts von dem, was sich ändern darf, wirkt auf den Bezug.</translation>
    </message>
    <message>
        <source>A step would have turned the outline of %1 over itself; a smaller one was taken</source>
        <translation>Ein Schritt hätte den Umriss von %1 über sich selbst gelegt; es wurde ein kleinerer gemacht</translation>
    </message>
    <message>
        <source>Nothing may change.</source>
        <translation>Nichts darf sich ändern.</translation>
    </message>
    <message>
        <source>The cover does not come to rest.</source>
        <translation>Der Bezug kommt nicht zur Ruhe.</translation>
    </message>
    <message>
        <source>Make %1 longer by %3 mm where it is sewn to %2</source>
        <translation>%1 um %3 mm verlängern, wo es an %2 genäht ist</translation>
    </message>
    <message>
        <source>Make %1 shorter by %3 mm where it is sewn to %2</source>
        <translation>%1 um %3 mm verkürzen, wo es an %2 genäht ist</translation>
    </message>
    <message>
        <source>Move the seam of %1 and %2 by %3 mm into %2</source>
        <translation>Naht von %1 und %2 um %3 mm in %2 hinein versetzen</translation>
    </message>
    <message>
        <source>Move the seam of %1 and %2 by %3 mm into %1</source>
        <translation>Naht von %1 und %2 um %3 mm in %1 hinein versetzen</translation>
    </message>
    <message>
        <source>Let out the corner of %1 at %2 by %3 mm</source>
        <translation>Ecke von %1 bei %2 um %3 mm auslassen</translation>
    </message>
    <message>
        <source>Take in the corner of %1 at %2 by %3 mm</source>
        <translation>Ecke von %1 bei %2 um %3 mm zurücknehmen</translation>
    </message>
    <message>
        <source>Cut a dart into %1 at %2, %3 mm wide and %4 mm deep</source>
        <translation>Abnäher in %1 bei %2 schneiden, %3 mm breit und %4 mm tief</translation>
    </message>
    <message>
        <source>Make the seam of %1 and %2 smooth</source>
        <translation>Naht von %1 und %2 glatt machen</translation>
    </message>
    <message>
        <source>Let the seam of %1 and %2 be sharp</source>
        <translation>Naht von %1 und %2 scharf lassen</translation>
    </message>
    <message>
        <source>it is no file of preferences: it breaks off or has a mistake at character %1; choose one that Bolster has exported</source>
        <translation>das ist keine Datei mit Einstellungen: Sie bricht ab oder hat bei Zeichen %1 einen Fehler; wählen Sie eine, die Bolster exportiert hat</translation>
    </message>
    <message>
        <source>it is no file of preferences; choose one that Bolster has exported</source>
        <translation>das ist keine Datei mit Einstellungen; wählen Sie eine, die Bolster exportiert hat</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be what it is there; remove that line from the file, or export it again</source>
        <translation>„%1“ hat dort einen Wert, der nicht möglich ist; entfernen Sie diese Zeile aus der Datei, oder exportieren Sie die Datei neu</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, where a portable Bolster keeps settings and work, cannot be written; copy its folder to where you may write</source>
        <translation>„%1“, wo ein portables Bolster Einstellungen und Arbeit ablegt, lässt sich nicht schreiben; kopieren Sie den Ordner von Bolster dorthin, wo Sie schreiben dürfen</translation>
    </message>
    <message>
        <source>the disk with &quot;%1&quot; is full; make room on it, and change a setting once more: all of them are kept then</source>
        <translation>der Datenträger mit „%1“ ist voll; schaffen Sie Platz und ändern Sie noch eine Einstellung: dann werden alle aufbewahrt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be written; give yourself the right to write there and in its folder, and change a setting once more: all of them are kept then</source>
        <translation>„%1“ konnte nicht geschrieben werden; geben Sie sich dort und in seinem Ordner Schreibrecht und ändern Sie noch eine Einstellung: dann werden alle aufbewahrt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands there twice; remove one of its lines from the file, or export it again</source>
        <translation>„%1“ steht dort zweimal; entfernen Sie eine der Zeilen aus der Datei oder exportieren Sie sie neu</translation>
    </message>
    <message>
        <source>Change the note of %1</source>
        <translation>Notiz von %1 ändern</translation>
    </message>
    <message>
        <source>Add measurement %1</source>
        <translation>Maß %1 hinzufügen</translation>
    </message>
    <message>
        <source>it does not lie in &quot;%1&quot; any more; measure anew</source>
        <translation>es liegt nicht mehr in „%1“; messen Sie neu</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; holds other files: choose one of its own.</source>
        <translation>Der Ordner „%1“ enthält andere Dateien: wählen Sie einen eigenen.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; holds the work of another design or of other options: choose another folder.</source>
        <translation>Der Ordner „%1“ enthält die Arbeit eines anderen Entwurfs oder anderer Optionen: wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be made (%2).</source>
        <translation>Der Ordner „%1“ kann nicht angelegt werden (%2).</translation>
    </message>
    <message>
        <source>Remove %1 and what needs it (%2 elements)</source>
        <translation>%1 und alles, was es braucht, entfernen (%2 Elemente)</translation>
    </message>
    <message>
        <source>one version was saved</source>
        <translation>Eine Version wurde gerettet</translation>
    </message>
    <message>
        <source>%1: none of its triangles has an area</source>
        <translation>%1: Keines der Dreiecke hat eine Fläche</translation>
    </message>
    <message>
        <source>Where a piece would have had a hole or been a ring it is cut and sewn again, number of cuts: %1</source>
        <translation>Wo ein Stück ein Loch hätte oder ein Ring wäre, ist es aufgeschnitten und wieder genäht, Anzahl der Schnitte: %1</translation>
    </message>
    <message>
        <source>%1 is stretched by %2 % along the grain, its fabric allows %3 %</source>
        <translation>%1 ist längs des Fadenlaufs um %2 % gedehnt, der Stoff verträgt %3 %</translation>
    </message>
    <message>
        <source>%1 is stretched by %2 % across the grain, its fabric allows %3 %</source>
        <translation>%1 ist quer zum Fadenlauf um %2 % gedehnt, der Stoff verträgt %3 %</translation>
    </message>
    <message>
        <source>%1 is sheared by %2 %, its fabric allows %3 %</source>
        <translation>%1 ist um %2 % geschert, der Stoff verträgt %3 %</translation>
    </message>
    <message>
        <source>The form has one side only, as a twisted band: it is left open where its outside meets its inside</source>
        <translation>Die Form hat nur eine Seite, wie ein verdrehtes Band: Wo ihre Außenseite auf die Innenseite trifft, bleibt sie offen</translation>
    </message>
    <message>
        <source>Parts of %1 that are shorter than a mesh edge have gone with the cut.</source>
        <translation>Teile von %1, die kürzer als eine Netzkante sind, sind mit dem Schnitt weggefallen.</translation>
    </message>
    <message>
        <source>the usual value is used instead</source>
        <translation>stattdessen gilt der übliche Wert</translation>
    </message>
    <message>
        <source>it is the project that is open here; choose another name</source>
        <translation>es ist das Projekt, das hier offen ist; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>the file is empty; nothing was written to it, or it was lost</source>
        <translation>die Datei ist leer; es wurde nichts hineingeschrieben, oder es ging verloren</translation>
    </message>
    <message>
        <source>it is open in another window; choose another name</source>
        <translation>sie ist in einem anderen Fenster geöffnet; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>the disk of &quot;%1&quot; is full, where work is protected from crashes; make room, and open it again</source>
        <translation>der Datenträger von „%1“ ist voll, wo Arbeit vor Abstürzen geschützt wird; schaffen Sie Platz, und öffnen Sie sie noch einmal</translation>
    </message>
    <message>
        <source>The form is %1 mm large: with edges of %2 mm its cover has more triangles than can be solved. See whether the unit is right; else make the mesh edges at least %3 mm long</source>
        <translation>Die Form ist %1 mm groß: mit Kanten von %2 mm hat ihr Bezug mehr Dreiecke, als sich lösen lassen. Prüfen Sie, ob die Einheit stimmt; sonst machen Sie die Netzkanten mindestens %3 mm lang</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already; choose another name</source>
        <translation>„%1“ gibt es schon; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>%1 is strained by %2 % when it lies on the form, more than any fabric bears. Divide it, or cut it in where it bulges most</source>
        <translation>%1 wird um %2 % gedehnt, wenn es auf der Form liegt, mehr als jeder Stoff verträgt. Teilen Sie es, oder schneiden Sie es ein, wo es sich am stärksten wölbt</translation>
    </message>
    <message>
        <source>Let no scan pull at the cover</source>
        <translation>Keinen Scan am Bezug ziehen lassen</translation>
    </message>
    <message>
        <source>%1 bends too sharply at %2: it is not cut along it</source>
        <translation>%1 biegt sich bei %2 zu scharf: Dort wird nicht geschnitten</translation>
    </message>
    <message>
        <source>The form goes through itself at %2: it is not cut along %1</source>
        <translation>Die Form geht bei %2 durch sich selbst: Entlang %1 wird nicht geschnitten</translation>
    </message>
    <message>
        <source>What is closed all around has no border to be held at: its cover is fixed along its seams. Delete the fixations of those that are to be free</source>
        <translation>Was ringsum geschlossen ist, hat keinen Rand zum Festhalten: Sein Bezug ist entlang seiner Nähte befestigt. Löschen Sie die Befestigungen derer, die frei sein sollen</translation>
    </message>
    <message>
        <source>No vertex of the area is near the form: make the area larger than the mesh edges, or put the form where the cover is.</source>
        <translation>Kein Eckpunkt des Bereichs ist nahe bei der Form: Machen Sie den Bereich größer als die Netzkanten, oder bringen Sie die Form dorthin, wo der Bezug ist.</translation>
    </message>
    <message>
        <source>%1 is left out: it is too narrow to be sewn. Join it to what lies beside it</source>
        <translation>%1 ist weggelassen: Es ist zu schmal zum Nähen. Verbinden Sie es mit dem, was daneben liegt</translation>
    </message>
    <message>
        <source>Make the pattern of a form again</source>
        <translation>Den Schnitt einer Form noch einmal machen</translation>
    </message>
    <message>
        <source>Make the pattern of %1 again</source>
        <translation>Den Schnitt von %1 noch einmal machen</translation>
    </message>
    <message>
        <source>Make the pattern of %1</source>
        <translation>Den Schnitt von %1 machen</translation>
    </message>
    <message>
        <source>Fit the pattern to %1, %2 mm from it</source>
        <translation>Den Schnitt an %1 anpassen, %2 mm davon entfernt</translation>
    </message>
    <message>
        <source>Fit the pattern to %1</source>
        <translation>Den Schnitt an %1 anpassen</translation>
    </message>
    <message>
        <source>Fit the pattern to a limit of strain, %1 % of the cover over it</source>
        <translation>Den Schnitt an eine Grenze der Dehnung anpassen, %1 % des Bezugs darüber</translation>
    </message>
    <message>
        <source>Let the scan pull at the cover again</source>
        <translation>Den Scan wieder am Bezug ziehen lassen</translation>
    </message>
    <message>
        <source>%1 runs along %2, at %3: it is cut there once</source>
        <translation>%1 verläuft bei %3 entlang von %2: Dort wird einmal geschnitten</translation>
    </message>
    <message>
        <source>%1 runs along the border of the form, or where it is cut anyway, at %2: there is nothing to cut</source>
        <translation>%1 verläuft bei %2 am Rand der Form oder dort, wo sie ohnehin geschnitten wird: Da ist nichts zu schneiden</translation>
    </message>
    <message>
        <source>%1 is too short or too long, at %2: it is not cut along it</source>
        <translation>%1 ist zu kurz oder zu lang, bei %2: Dort wird nicht geschnitten</translation>
    </message>
    <message>
        <source>%1 is %2 mm away from the form, at %3: it is not cut along it</source>
        <translation>%1 liegt %2 mm von der Form entfernt, bei %3: Dort wird nicht geschnitten</translation>
    </message>
    <message>
        <source>lines cannot be cut into it: it has edges where more than two faces meet, or sheets that touch in a point, at %1</source>
        <translation>In sie können keine Linien geschnitten werden: Sie hat bei %1 Kanten, an denen sich mehr als zwei Flächen treffen, oder Flächen, die sich in einem Punkt berühren</translation>
    </message>
    <message>
        <source>%1 cannot be cut into it, at %2: the form goes through itself there</source>
        <translation>%1 kann bei %2 nicht in sie geschnitten werden: Die Form geht dort durch sich selbst</translation>
    </message>
    <message>
        <source>Small for the triangles of the cover, whose edges are %1 mm long: %2. Their shape will be coarse; with mesh edges of %3 mm it is not</source>
        <translation>Klein für die Dreiecke des Bezugs mit %1 mm langen Kanten: %2. Ihre Form wird grob; mit Netzkanten von %3 mm wird sie es nicht</translation>
    </message>
    <message>
        <source>Too small for the triangles of the cover, whose edges are %1 mm long: %2. Join them to what lies beside them, or leave them out</source>
        <translation>Zu klein für die Dreiecke des Bezugs mit %1 mm langen Kanten: %2. Verbinden Sie sie mit dem, was daneben liegt, oder lassen Sie sie weg</translation>
    </message>
    <message>
        <source>After %1 iterations it cannot be told yet where the surface comes to rest. Allow more iterations.</source>
        <translation>Nach %1 Schritten lässt sich noch nicht sagen, wo die Oberfläche zur Ruhe kommt. Erlauben Sie mehr Schritte.</translation>
    </message>
    <message>
        <source>Wider across the grain than the fabric, of which %1 mm can be used: %2. Divide them, or turn their grain</source>
        <translation>Quer zum Fadenlauf breiter als der Stoff, von dem %1 mm nutzbar sind: %2. Teilen Sie sie oder drehen Sie ihren Fadenlauf</translation>
    </message>
    <message>
        <source>%1 ends inside a piece, at %2: it is cut in there like a dart. There is no other line or border; lead it around to where it began to divide the piece</source>
        <translation>%1 endet in einem Teil, bei %2: Dort wird wie bei einem Abnäher eingeschnitten. Eine andere Linie oder einen Rand gibt es nicht; führen Sie sie herum bis zu ihrem Anfang, um das Teil zu trennen</translation>
    </message>
    <message>
        <source>A line is not cut in at %1: the sides of the cut would lie over each other when it is laid flat. Draw it elsewhere, or on to a border</source>
        <translation>Eine Linie wird bei %1 nicht eingeschnitten: Die Seiten des Schnitts lägen flach übereinander. Zeichnen Sie sie anderswo oder weiter bis zu einem Rand</translation>
    </message>
    <message>
        <source>A line is not cut in at %1: the piece was divided another way. Draw it on to a border</source>
        <translation>Eine Linie wird bei %1 nicht eingeschnitten: das Teil wurde anders geteilt. Ziehen Sie sie bis an einen Rand</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no design, but what one is made of: import it</source>
        <translation>„%1“ ist kein Entwurf, sondern etwas, woraus einer gemacht wird: Importieren Sie es</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by %2 mm in each: it does not come to rest. Make curves as long as the outlines they hold, or try other mesh edges.</source>
        <translation>Nach %1 Iterationen bewegt sich die Fläche noch in jeder um %2 mm: Sie kommt nicht zur Ruhe. Machen Sie die Kurven so lang wie die Umrisse, die sie halten, oder versuchen Sie andere Netzkanten.</translation>
    </message>
    <message>
        <source>%1, with what is sewn to it, is held only at a border of %2 mm: fix it along other curves, too, or close that hole of the form</source>
        <translation>%1 mit allem, was daran genäht ist, hält nur ein Rand von %2&#xa0;mm: fixieren Sie es auch entlang anderer Kurven, oder schließen Sie dieses Loch der Form</translation>
    </message>
    <message>
        <source>%1 is left out: it is closed all around and cannot be laid flat. Cut it along lines</source>
        <translation>%1 ist weggelassen: Es ist ringsum geschlossen und lässt sich nicht flach legen. Schneiden Sie es entlang von Linien auf</translation>
    </message>
    <message>
        <source>%1 is left out: it has a handle, like a cup, and cannot be laid flat. Cut it along lines</source>
        <translation>%1 ist weggelassen: Es hat einen Henkel wie eine Tasse und lässt sich nicht flach legen. Schneiden Sie es entlang von Linien auf</translation>
    </message>
    <message>
        <source>Let out %1 by %3 mm where it is sewn to %2</source>
        <translation>%1 um %3&#xa0;mm auslassen, wo es an %2 genäht ist</translation>
    </message>
    <message>
        <source>Take in %1 by %3 mm where it is sewn to %2</source>
        <translation>%1 um %3&#xa0;mm zurücknehmen, wo es an %2 genäht ist</translation>
    </message>
    <message>
        <source>Let out %1 by %3 mm where the curve %2 holds it</source>
        <translation>%1 um %3&#xa0;mm auslassen, wo die Kurve %2 es hält</translation>
    </message>
    <message>
        <source>Take in %1 by %3 mm where the curve %2 holds it</source>
        <translation>%1 um %3&#xa0;mm zurücknehmen, wo die Kurve %2 es hält</translation>
    </message>
    <message>
        <source>What would not lie flat, or be strained by more than the fabric may be, is divided, which makes so many pieces more: %1</source>
        <translation>Was nicht flach läge oder stärker gedehnt würde, als der Stoff darf, ist geteilt. Es sind so viele Teile mehr: %1</translation>
    </message>
    <message>
        <source>%1 is not divided: more than %2 pieces would be needed until it lies flat. It is rough, as scans are: smooth it, or fit a cover to it and take that</source>
        <translation>%1 wird nicht geteilt: Es wären mehr als %2 Teile nötig, bis es flach liegt. Es ist rau, wie Scans es sind: Glätten Sie es, oder passen Sie ihm einen Bezug an und nehmen Sie diesen</translation>
    </message>
    <message>
        <source>%1 is left out: it has more than %2 holes. Close them, or cut it along lines</source>
        <translation>%1 ist weggelassen: Es hat mehr als %2 Löcher. Schließen Sie sie, oder schneiden Sie es entlang von Linien auf</translation>
    </message>
    <message>
        <source>Too narrow for the triangles of the cover, whose edges are %1 mm long, so that it cannot be solved: %2. Make the mesh edges shorter, or join them to what lies beside them</source>
        <translation>Zu schmal für die Dreiecke des Bezugs mit %1 mm langen Kanten, sodass er nicht gerechnet werden kann: %2. Machen Sie die Netzkanten kürzer, oder verbinden Sie sie mit dem, was daneben liegt</translation>
    </message>
    <message>
        <source>Lead open seam lines on</source>
        <translation>Offene Nahtlinien weiterführen</translation>
    </message>
    <message>
        <source>Lead %1 on</source>
        <translation>%1 weiterführen</translation>
    </message>
    <message>
        <source>Bodies of the form go through each other, as at %1: what of one lies inside of another one is covered, too, and pushed out. Unite them before, or leave one out. Number of such pairs: %2</source>
        <translation>Körper der Form gehen durcheinander hindurch, etwa bei %1: Was von einem in einem anderen liegt, wird auch bezogen und hinausgedrückt. Vereinigen Sie sie vorher, oder lassen Sie einen weg. Anzahl solcher Paare: %2</translation>
    </message>
    <message>
        <source>Faces of the form that lie where another one lies, and are left out: %1</source>
        <translation>Flächen der Form, die liegen, wo schon eine andere liegt, und weggelassen werden: %1</translation>
    </message>
    <message>
        <source>Faces of the form that were turned round: %1</source>
        <translation>Umgedrehte Flächen der Form: %1</translation>
    </message>
    <message>
        <source>Edges of the form that belong to more than two faces, so that they are borders and nothing is sewn there: %1</source>
        <translation>Kanten der Form, die zu mehr als zwei Flächen gehören, sodass sie Ränder sind und dort nichts genäht wird: %1</translation>
    </message>
</context>
<context>
    <name>MouseStyle</name>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>middle button</source>
        <translation>mittlere Taste</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>rechte Taste</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>two fingers</source>
        <translation>zwei Finger</translation>
    </message>
    <message>
        <source>pinch or Ctrl+wheel</source>
        <translation>Spreizen oder Strg+Mausrad</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>CAD (like SolidWorks)</source>
        <translation>CAD (wie SolidWorks)</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>CLO, Marvelous Designer</source>
        <translation>CLO, Marvelous Designer</translation>
    </message>
    <message>
        <source>Touchpad</source>
        <translation>Touchpad</translation>
    </message>
</context>
<context>
    <name>NotchForm</name>
    <message>
        <source>Patch</source>
        <translation>Schnittteil</translation>
    </message>
    <message>
        <source>From the corner</source>
        <translation>Von der Ecke</translation>
    </message>
    <message>
        <source>Along the outline from the nearer corner, on the same side of it.</source>
        <translation>Am Umriss entlang von der näheren Ecke aus, auf derselben Seite.</translation>
    </message>
</context>
<context>
    <name>OrientationFields</name>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Normal held</source>
        <translation>Normale gehalten</translation>
    </message>
    <message>
        <source>Tangent plane held</source>
        <translation>Tangentialebene gehalten</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>%1 directions, interpolated along the curve; the first is shown.</source>
        <translation>%1 Richtungen, entlang der Kurve interpoliert; gezeigt wird die erste.</translation>
    </message>
</context>
<context>
    <name>OutlineTool</name>
    <message>
        <source>This cannot be a patch: %1</source>
        <translation>Das kann kein Schnittteil werden: %1</translation>
    </message>
    <message>
        <source>The outline would cross itself here – Backspace takes a point back</source>
        <translation>Der Umriss würde sich hier selbst kreuzen – die Rücktaste nimmt einen Punkt zurück</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no length: try 500, 500&lt;30 or 120, 40</source>
        <translation>„%1“ ist keine Länge: zum Beispiel 500, 500&lt;30 oder 120, 40</translation>
    </message>
    <message>
        <source>Click to set the first corner, press and drag for a smooth point – Esc ends the tool</source>
        <translation>Klicken setzt die erste Ecke, drücken und ziehen einen glatten Punkt – Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>Click to close the outline</source>
        <translation>Klicken schließt den Umriss</translation>
    </message>
    <message>
        <source>Enter sets the point: 500 goes that far, 500&lt;30 at an angle, 120, 40 to the right and up</source>
        <translation>Enter setzt den Punkt: 500 geht so weit, 500&lt;30 unter einem Winkel, 120, 40 nach rechts und nach oben</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, or type a length – Ctrl does not snap</source>
        <translation>Klicken für eine Ecke, ziehen für einen glatten Punkt oder eine Länge eingeben – Strg rastet nicht ein</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, type a length – Enter or a click on the first point closes, Backspace takes a point back</source>
        <translation>Klicken für eine Ecke, ziehen für einen glatten Punkt, Länge eingeben – Enter oder ein Klick auf den ersten Punkt schließt, die Rücktaste nimmt einen Punkt zurück</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>OutlineTrimForm</name>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>PatchDrawingTool</name>
    <message>
        <source>Patch %1</source>
        <translation>Schnittteil %1</translation>
    </message>
    <message>
        <source>An outline needs at least three points in different places.</source>
        <translation>Ein Umriss braucht mindestens drei Punkte an verschiedenen Stellen.</translation>
    </message>
    <message>
        <source>This cannot be a patch: %1</source>
        <translation>Das kann kein Schnittteil werden: %1</translation>
    </message>
</context>
<context>
    <name>PatchForm</name>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Width and height as it lies in the pattern view.</source>
        <translation>Breite und Höhe, wie es in der Schnittansicht liegt.</translation>
    </message>
</context>
<context>
    <name>PatternDrawTool</name>
    <message>
        <source>Begin inside a patch.</source>
        <translation>In einem Schnittteil beginnen.</translation>
    </message>
    <message>
        <source>Fancy seam %1</source>
        <translation>Ziernaht %1</translation>
    </message>
    <message>
        <source>Handle %1</source>
        <translation>Griff %1</translation>
    </message>
    <message>
        <source>A curve needs two points, a closed one three.</source>
        <translation>Eine Kurve braucht zwei Punkte, eine geschlossene drei.</translation>
    </message>
    <message>
        <source>There is no surface in this patch yet on which the handle could lie.</source>
        <translation>In diesem Schnittteil gibt es noch keine Fläche, auf der die Griffkurve liegen könnte.</translation>
    </message>
    <message>
        <source>Click inside a patch to begin a handle curve – Esc ends the tool</source>
        <translation>In ein Schnittteil klicken, um eine Griffkurve zu beginnen – Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>Click inside a patch or on its outline to begin a fancy seam – Esc ends the tool</source>
        <translation>In ein Schnittteil oder auf seinen Umriss klicken, um eine Ziernaht zu beginnen – Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>Click to close the curve</source>
        <translation>Klick schließt die Kurve</translation>
    </message>
    <message>
        <source>Click for the next point, double click or Enter ends – B makes it straight, Backspace takes a point back</source>
        <translation>Klick setzt den nächsten Punkt, Doppelklick oder Eingabe beendet – B macht sie gerade, Rücktaste nimmt einen Punkt zurück</translation>
    </message>
    <message>
        <source>Click for the next point, double click or Enter ends – B makes it smooth, Backspace takes a point back</source>
        <translation>Klick setzt den nächsten Punkt, Doppelklick oder Eingabe beendet – B macht sie rund, Rücktaste nimmt einen Punkt zurück</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Linie %1</translation>
    </message>
    <message>
        <source>Click inside a patch or on its outline to begin a line for the cutter – Esc ends the tool</source>
        <translation>In ein Teil oder auf seinen Umriss klicken, um eine Linie für den Zuschnitt zu beginnen – Esc beendet das Werkzeug</translation>
    </message>
</context>
<context>
    <name>PatternPdf</name>
    <message>
        <source>1 inch</source>
        <translation>1 Zoll</translation>
    </message>
    <message>
        <source>Print at 100 %</source>
        <translation>Mit 100 % drucken</translation>
    </message>
    <message>
        <source>%1 – print at 100 %</source>
        <translation>%1 – mit 100 % drucken</translation>
    </message>
    <message>
        <source>Overview of %1 x %2 sheets</source>
        <translation>Übersicht über %1 x %2 Blätter</translation>
    </message>
    <message>
        <source>%1: sheet %2</source>
        <translation>%1: Blatt %2</translation>
    </message>
    <message>
        <source>%1: sheets %2 to %3</source>
        <translation>%1: Blätter %2 bis %3</translation>
    </message>
    <message>
        <source>100 mm: to measure, no part of the pattern</source>
        <translation>100 mm: zum Nachmessen, kein Schnittteil</translation>
    </message>
    <message>
        <source>Sheet %1 (row %2 of %3, column %4 of %5)</source>
        <translation>Blatt %1 (Zeile %2 von %3, Spalte %4 von %5)</translation>
    </message>
</context>
<context>
    <name>PatternSelectTool</name>
    <message>
        <source>There is a control point already.</source>
        <translation>Hier ist schon ein Kontrollpunkt.</translation>
    </message>
    <message>
        <source>Drag to turn the selected patches in the layout</source>
        <translation>Ziehen dreht die ausgewählten Schnittteile im Layout</translation>
    </message>
    <message>
        <source>Drag to move the control point – Shift+click selects several, Del removes</source>
        <translation>Ziehen verschiebt den Kontrollpunkt – Umschalt+Klick wählt mehrere aus, Entf entfernt</translation>
    </message>
    <message>
        <source>Click to select the patch, drag to move it in the layout</source>
        <translation>Klick wählt das Schnittteil aus, Ziehen verschiebt es im Layout</translation>
    </message>
    <message>
        <source>Click to select the curve, drag to move it, double click to add a control point here</source>
        <translation>Klick wählt die Kurve, Ziehen verschiebt sie, Doppelklick fügt hier einen Kontrollpunkt ein</translation>
    </message>
    <message>
        <source>Drag to scale the selected patches – Shift keeps the proportions</source>
        <translation>Ziehen skaliert die ausgewählten Schnittteile – Umschalt behält das Seitenverhältnis</translation>
    </message>
    <message>
        <source>Drag to move this end of the stretch along the outline</source>
        <translation>Ziehen, um dieses Ende des Abschnitts am Umriss entlang zu verschieben</translation>
    </message>
    <message>
        <source>Drag to move the edge, double click to add a control point here – its length is in the properties</source>
        <translation>Ziehen verschiebt die Kante, Doppelklick fügt hier einen Kontrollpunkt ein – ihre Länge steht bei den Eigenschaften</translation>
    </message>
    <message>
        <source>Click to select the edge, double click to add a control point here, drag to move the patch</source>
        <translation>Klick wählt die Kante aus, Doppelklick fügt hier einen Kontrollpunkt ein, Ziehen verschiebt das Schnittteil</translation>
    </message>
    <message>
        <source>Click to select the seam and the edge, double click to add a control point here</source>
        <translation>Klick wählt Naht und Kante aus, Doppelklick fügt hier einen Kontrollpunkt ein</translation>
    </message>
    <message>
        <source>Click to select it, drag to move it, Delete removes it</source>
        <translation>Klicken wählt es aus, ziehen verschiebt es, Entf entfernt es</translation>
    </message>
    <message>
        <source>Drag the tip of the dart</source>
        <translation>Ziehen Sie die Spitze des Abnähers</translation>
    </message>
    <message>
        <source>Drag the dart along the outline</source>
        <translation>Ziehen Sie den Abnäher am Umriss entlang</translation>
    </message>
    <message>
        <source>Drag the label to where it can be read, click to select the patch</source>
        <translation>Ziehen Sie die Beschriftung dorthin, wo man sie lesen kann; ein Klick wählt das Schnittteil aus</translation>
    </message>
    <message>
        <source>Click to select, drag a box to select several – %1 or Space pans, %2 zooms</source>
        <translation>Klick wählt aus, ein aufgezogener Rahmen wählt mehrere aus – Ansicht verschieben: %1 oder Leertaste, zoomen: %2</translation>
    </message>
    <message>
        <source>Click to select the measurement, Delete removes it</source>
        <translation>Klicken wählt das Maß aus, Entf entfernt es</translation>
    </message>
</context>
<context>
    <name>PatternSplitTool</name>
    <message>
        <source>Click beside a patch or on its outline to begin the cut – Esc ends the tool</source>
        <translation>Neben ein Schnittteil oder auf seinen Umriss klicken, um den Schnitt zu beginnen – Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>Double click or Enter splits the patch – click to bend the cut, Backspace takes a point back</source>
        <translation>Doppelklick oder Eingabe teilt das Schnittteil – Klicken knickt den Schnitt, Rücktaste nimmt einen Punkt zurück</translation>
    </message>
    <message>
        <source>Click on the other side of the patch – Shift keeps the cut straight, Backspace takes a point back</source>
        <translation>Auf die andere Seite des Schnittteils klicken – Umschalt hält den Schnitt gerade, Rücktaste nimmt einen Punkt zurück</translation>
    </message>
</context>
<context>
    <name>PatternTool</name>
    <message>
        <source>Moved by %1, %2 – Shift keeps to one axis, Esc takes it back</source>
        <translation>Um %1, %2 verschoben – Umschalt hält eine Achse, Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Turned by %1 – Shift turns in steps of 15°, Esc takes it back</source>
        <translation>Um %1 gedreht – Umschalt dreht in Schritten von 15°, Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Release to select what lies in the box – Shift adds, Esc takes it back</source>
        <translation>Loslassen wählt aus, was im Rahmen liegt – Umschalt fügt hinzu, Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Release to select what lies in the loop – Shift adds, Esc takes it back</source>
        <translation>Loslassen wählt aus, was in der Schlinge liegt – Umschalt fügt hinzu, Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Enter moves it so far: 50, or 30, 20</source>
        <translation>Eingabe verschiebt um so viel: 50 oder 30, 20</translation>
    </message>
    <message>
        <source>Enter turns it by this angle, counter-clockwise: 45</source>
        <translation>Eingabe dreht um diesen Winkel, gegen den Uhrzeigersinn: 45</translation>
    </message>
    <message>
        <source>Enter makes it this size: 300 x 200, 300 (wide, in proportion), or 120 %</source>
        <translation>Eingabe macht es so groß: 300 x 200, 300 (Breite, Höhe im Verhältnis) oder 120 %</translation>
    </message>
    <message>
        <source>Scaled to %1 × %2 – or type the size; Shift keeps the proportions, Esc takes it back</source>
        <translation>Auf %1 × %2 skaliert – oder die Größe tippen; Umschalt behält das Seitenverhältnis, Esc nimmt es zurück</translation>
    </message>
</context>
<context>
    <name>PatternToolHost</name>
    <message>
        <source>%1 Let go here, and it goes back to where it was.</source>
        <translation>%1 Wird hier losgelassen, kehrt alles dorthin zurück, wo es war.</translation>
    </message>
</context>
<context>
    <name>PieceCuttingSection</name>
    <message>
        <source>Cutting</source>
        <translation>Zuschnitt</translation>
    </message>
    <message>
        <source>Own seam allowance</source>
        <translation>Eigene Nahtzugabe</translation>
    </message>
    <message>
        <source>Label where it finds room</source>
        <translation>Beschriftung, wo sie Platz findet</translation>
    </message>
</context>
<context>
    <name>PlacementGizmo</name>
    <message>
        <source>Turned by %1° – Ctrl snaps to 15°, Escape cancels</source>
        <translation>Um %1° gedreht – Strg rastet bei 15° ein, Escape bricht ab</translation>
    </message>
    <message>
        <source>Drag to move it along this axis</source>
        <translation>Ziehen verschiebt entlang dieser Achse</translation>
    </message>
    <message>
        <source>Drag to turn it about this axis</source>
        <translation>Ziehen dreht um diese Achse</translation>
    </message>
    <message>
        <source>Drag to move it parallel to the picture</source>
        <translation>Ziehen verschiebt parallel zum Bild</translation>
    </message>
    <message>
        <source>Moved by x %1, y %2, z %3 – Ctrl snaps to %4, Escape cancels</source>
        <translation>Um x %1, y %2, z %3 verschoben – Strg rastet bei %4 ein, Escape bricht ab</translation>
    </message>
</context>
<context>
    <name>PreferenceCommands</name>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>Units, language, theme, mouse, keys and more</source>
        <translation>Einheiten, Sprache, Farbschema, Maus, Tasten und mehr</translation>
    </message>
    <message>
        <source>The preferences could not be stored: they hold only until Bolster is closed.</source>
        <translation>Die Einstellungen konnten nicht gespeichert werden: sie gelten nur, bis Bolster geschlossen wird.</translation>
    </message>
</context>
<context>
    <name>Preferences</name>
    <message>
        <source>Millimetres (314 mm)</source>
        <translation>Millimeter (314 mm)</translation>
    </message>
    <message>
        <source>Centimetres (31.4 cm)</source>
        <translation>Zentimeter (31,4 cm)</translation>
    </message>
    <message>
        <source>Inches (12 3/8″)</source>
        <translation>Zoll (12 3/8″)</translation>
    </message>
    <message>
        <source>Up to 1/8</source>
        <translation>Bis 1/8</translation>
    </message>
    <message>
        <source>Up to 1/16</source>
        <translation>Bis 1/16</translation>
    </message>
    <message>
        <source>Up to 1/32</source>
        <translation>Bis 1/32</translation>
    </message>
    <message>
        <source>Up to 1/64</source>
        <translation>Bis 1/64</translation>
    </message>
    <message>
        <source>Decimals (12.375)</source>
        <translation>Dezimalen (12,375)</translation>
    </message>
    <message>
        <source>Of the language</source>
        <translation>Wie in der Sprache</translation>
    </message>
    <message>
        <source>Comma (1,5)</source>
        <translation>Komma (1,5)</translation>
    </message>
    <message>
        <source>Point (1.5)</source>
        <translation>Punkt (1.5)</translation>
    </message>
    <message>
        <source>Of the system</source>
        <translation>Sprache des Systems</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Voll</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Verringert</translation>
    </message>
    <message>
        <source>Plain, as it comes</source>
        <translation>Einfarbig, ohne Vorgabe</translation>
    </message>
    <message>
        <source>Units and numbers</source>
        <translation>Einheiten und Zahlen</translation>
    </message>
    <message>
        <source>Language and looks</source>
        <translation>Sprache und Aussehen</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Tastatur</translation>
    </message>
    <message>
        <source>Pattern view</source>
        <translation>Schnittansicht</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Nicht gespeicherte Arbeit</translation>
    </message>
    <message>
        <source>New designs</source>
        <translation>Neue Entwürfe</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>Längen in</translation>
    </message>
    <message>
        <source>unit measure metric imperial millimetre centimetre inch</source>
        <translation>einheit maß metrisch imperial millimeter zentimeter zoll inch</translation>
    </message>
    <message>
        <source>How lengths are shown. Whatever it is, you may type others: 3 in, 2.5 cm, 1&apos; 2 3/8&quot;. Designs keep millimetres, and so do printed sheets and files.</source>
        <translation>Wie Längen angezeigt werden. Eingeben können Sie trotzdem auch andere: „3 in“, „2,5 cm“, „1&apos; 2 3/8&quot;“. Entwürfe bleiben in Millimetern, gedruckte Blätter und Dateien auch.</translation>
    </message>
    <message>
        <source>Parts of an inch</source>
        <translation>Teile eines Zolls</translation>
    </message>
    <message>
        <source>fraction imperial 1/16 decimals</source>
        <translation>bruch brüche zoll imperial 1/16 dezimalen nachkommastellen</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>Dezimalzeichen</translation>
    </message>
    <message>
        <source>comma point dot separator numbers</source>
        <translation>komma punkt trennzeichen dezimaltrennzeichen zahlen</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>translation words english german deutsch</source>
        <translation>übersetzung wörter englisch deutsch english language</translation>
    </message>
    <message>
        <source>Bolster speaks it when it is started the next time.</source>
        <translation>Bolster spricht sie ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>colours dark light contrast night appearance accessibility</source>
        <translation>farben design theme dunkel hell kontrast nacht dunkelmodus darstellung barrierefreiheit</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Size of the letters</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source>font text large small zoom scale accessibility</source>
        <translation>schrift text groß klein zoom skalierung barrierefreiheit</translation>
    </message>
    <message>
        <source>Move the views as in</source>
        <translation>Ansichten bewegen wie in</translation>
    </message>
    <message>
        <source>navigation rotate turn pan zoom buttons trackpad orbit preset</source>
        <translation>navigation drehen verschieben zoomen tasten trackpad touchpad orbit vorgabe</translation>
    </message>
    <message>
        <source>Zoom the other way round</source>
        <translation>Andersherum zoomen</translation>
    </message>
    <message>
        <source>invert wheel scroll reverse direction</source>
        <translation>umkehren invertieren mausrad scrollen richtung</translation>
    </message>
    <message>
        <source>Keys as in</source>
        <translation>Tasten wie in</translation>
    </message>
    <message>
        <source>shortcuts hotkeys preset</source>
        <translation>tastenkürzel tastenkombination shortcuts hotkeys vorgabe</translation>
    </message>
    <message>
        <source>Some commands get the keys that you know from there. Keys that you have chosen yourself stay.</source>
        <translation>Einige Befehle bekommen die Tasten, die Sie von dort kennen. Tasten, die Sie selbst gewählt haben, bleiben.</translation>
    </message>
    <message>
        <source>Snap to points, edges, guides and the grid</source>
        <translation>An Punkten, Kanten, Hilfslinien und am Raster einrasten</translation>
    </message>
    <message>
        <source>magnet catch align</source>
        <translation>magnet fangen fang ausrichten einrasten</translation>
    </message>
    <message>
        <source>Ctrl or Alt lets go while you drag.</source>
        <translation>Strg oder Alt beim Ziehen setzt es aus.</translation>
    </message>
    <message>
        <source>Show rulers</source>
        <translation>Lineale zeigen</translation>
    </message>
    <message>
        <source>scale measure</source>
        <translation>maßstab messen skala</translation>
    </message>
    <message>
        <source>Show guides</source>
        <translation>Hilfslinien zeigen</translation>
    </message>
    <message>
        <source>lines help</source>
        <translation>linien hilfe führungslinien</translation>
    </message>
    <message>
        <source>Quality of the picture</source>
        <translation>Bildqualität</translation>
    </message>
    <message>
        <source>performance slow fast remote desktop graphics opengl</source>
        <translation>leistung langsam schnell fernzugriff remote desktop grafik opengl</translation>
    </message>
    <message>
        <source>Reduced: fewer pixels and triangles, no soft shadows. For slow machines and for screens that are far away. Pictures that you export stay fine.</source>
        <translation>Verringert: weniger Pixel und Dreiecke, keine weichen Schatten. Für langsame Rechner und für entfernte Bildschirme. Exportierte Bilder bleiben fein.</translation>
    </message>
    <message>
        <source>Go to other views at once, without a flight</source>
        <translation>Sofort zu anderen Ansichten wechseln, ohne Flug</translation>
    </message>
    <message>
        <source>reduced motion animation camera accessibility remote</source>
        <translation>bewegung verringern animation kamera barrierefreiheit fernzugriff</translation>
    </message>
    <message>
        <source> days</source>
        <translation> Tage</translation>
    </message>
    <message>
        <source>Keep work that was thrown away for</source>
        <translation>Verworfene Arbeit aufheben für</translation>
    </message>
    <message>
        <source>autosave backup recovery crash journal bin unsaved delete</source>
        <translation>automatisch speichern sicherung wiederherstellung absturz journal papierkorb ungespeichert löschen</translation>
    </message>
    <message>
        <source>Every step is on the disk as soon as it is done, so there is no interval to set. Unsaved work stays until you open it again or throw it away; after that it lies in the bin for at least 30 days.</source>
        <translation>Jeder Schritt liegt auf dem Datenträger, sobald er getan ist; ein Intervall ist nicht einzustellen. Nicht gespeicherte Arbeit bleibt, bis Sie sie wieder öffnen oder verwerfen; danach liegt sie mindestens 30 Tage im Papierkorb.</translation>
    </message>
    <message>
        <source>Fabric of new patches</source>
        <translation>Stoff neuer Schnittteile</translation>
    </message>
    <message>
        <source>default material leather weave colour</source>
        <translation>vorgabe standard material leder gewebe farbe</translation>
    </message>
    <message>
        <source>A new design begins with it, and patches are made of a design&apos;s first fabric.</source>
        <translation>Ein neuer Entwurf beginnt mit ihm, und Schnittteile entstehen aus dem ersten Stoff eines Entwurfs.</translation>
    </message>
    <message>
        <source>Seam allowance</source>
        <translation>Nahtzugabe</translation>
    </message>
    <message>
        <source>default cutting margin hem width</source>
        <translation>vorgabe standard zuschnitt rand saum breite</translation>
    </message>
    <message>
        <source>New designs begin with it; in a design it is changed in its properties.</source>
        <translation>Neue Entwürfe beginnen mit ihr; in einem Entwurf wird sie in seinen Eigenschaften geändert.</translation>
    </message>
    <message>
        <source>Folder of your fabrics</source>
        <translation>Ordner Ihrer Stoffe</translation>
    </message>
    <message>
        <source>library directory path import export picture swatch</source>
        <translation>bibliothek verzeichnis pfad import export bild muster</translation>
    </message>
    <message>
        <source>Where fabrics and their pictures are looked for first. Without one it is the folder of the design.</source>
        <translation>Wo Stoffe und ihre Bilder zuerst gesucht werden. Ohne Angabe ist es der Ordner des Entwurfs.</translation>
    </message>
    <message>
        <source>Lengths are kept as they are, and shown to the nearest part; what is shorter than one has decimals.</source>
        <translation>Längen bleiben, wie sie sind, und werden auf den nächsten Teil genau gezeigt; was kürzer als einer ist, hat Dezimalen.</translation>
    </message>
</context>
<context>
    <name>SavedViewCommands</name>
    <message>
        <source>&amp;Save view …</source>
        <translation>Ansicht &amp;speichern …</translation>
    </message>
    <message>
        <source>&amp;Delete view</source>
        <translation>Ansicht &amp;löschen</translation>
    </message>
    <message>
        <source>View %1 deleted</source>
        <translation>Ansicht %1 gelöscht</translation>
    </message>
    <message>
        <source>Save view</source>
        <translation>Ansicht speichern</translation>
    </message>
    <message>
        <source>Name of the view; one of the same name is replaced:</source>
        <translation>Name der Ansicht; eine mit demselben Namen wird ersetzt:</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>View %1 saved: View &gt; Saved views</source>
        <translation>Ansicht %1 gespeichert: Ansicht &gt; Gespeicherte Ansichten</translation>
    </message>
</context>
<context>
    <name>ScanAlignTool</name>
    <message>
        <source>There is no point of the scan here: click on one.</source>
        <translation>Hier ist kein Punkt des Scans: klicken Sie auf einen.</translation>
    </message>
    <message>
        <source>There is neither a frame nor the cover here: click where that place of the scan belongs.</source>
        <translation>Hier ist weder ein Gestell noch der Bezug: klicken Sie dorthin, wohin die Stelle des Scans gehört.</translation>
    </message>
    <message>
        <source>Take the last place &amp;back</source>
        <translation>Letzte Stelle &amp;zurücknehmen</translation>
    </message>
    <message>
        <source>Click on the frame or the cover where place %1 of the scan belongs – Backspace takes it back</source>
        <translation>Klicken Sie auf Gestell oder Bezug, wohin Stelle %1 des Scans gehört – die Rücktaste nimmt sie zurück</translation>
    </message>
    <message>
        <source>Click on a place of the scan that can be told from others, such as a corner – drag turns the view, Esc ends the tool</source>
        <translation>Klicken Sie auf eine Stelle des Scans, die man von anderen unterscheiden kann, etwa eine Ecke – Ziehen dreht die Ansicht, Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>Click on place %1 of 3 of the scan, far from the others – Backspace takes one back</source>
        <translation>Klicken Sie auf Stelle %1 von 3 des Scans, weit von den anderen – die Rücktaste nimmt eine zurück</translation>
    </message>
    <message>
        <source>%1: where it belongs</source>
        <translation>%1: wohin sie gehört</translation>
    </message>
    <message>
        <source>%1: on the scan</source>
        <translation>%1: auf dem Scan</translation>
    </message>
    <message>
        <source>The scan is no longer there – Esc ends the tool</source>
        <translation>Der Scan ist nicht mehr da – Esc beendet das Werkzeug</translation>
    </message>
</context>
<context>
    <name>ScanCommands</name>
    <message>
        <source>&amp;Place on the cover</source>
        <translation>&amp;Am Bezug ausrichten</translation>
    </message>
    <message>
        <source>Moves and turns the scan so that it lies on the cover as well as it can</source>
        <translation>Verschiebt und dreht den Scan so, dass er möglichst gut am Bezug liegt</translation>
    </message>
    <message>
        <source>&amp;Cut away …</source>
        <translation>&amp;Wegschneiden …</translation>
    </message>
    <message>
        <source>Drag a rectangle in the 3D view over what is to be cut away of the scan</source>
        <translation>In der 3D-Ansicht ein Rechteck über das aufziehen, was vom Scan weggeschnitten werden soll</translation>
    </message>
    <message>
        <source>&amp;Keep only …</source>
        <translation>&amp;Nur behalten …</translation>
    </message>
    <message>
        <source>Drag a rectangle in the 3D view around what is to be kept of the scan</source>
        <translation>In der 3D-Ansicht ein Rechteck um das aufziehen, was vom Scan bleiben soll</translation>
    </message>
    <message>
        <source>Keep &amp;around the cover</source>
        <translation>&amp;Umgebung des Bezugs behalten</translation>
    </message>
    <message>
        <source>Cuts away what is farther from the cover than the threshold</source>
        <translation>Schneidet weg, was weiter vom Bezug entfernt ist als die Schwelle</translation>
    </message>
    <message>
        <source>&amp;Remove all cuts</source>
        <translation>Alle Schnitte &amp;entfernen</translation>
    </message>
    <message>
        <source>Brings back all that was cut away of the scan</source>
        <translation>Holt alles zurück, was vom Scan weggeschnitten wurde</translation>
    </message>
    <message>
        <source>Choose another &amp;file …</source>
        <translation>Andere &amp;Datei wählen …</translation>
    </message>
    <message>
        <source>Reads the scan from another file</source>
        <translation>Liest den Scan aus einer anderen Datei</translation>
    </message>
    <message>
        <source>Select the scan that is meant.</source>
        <translation>Wählen Sie den Scan aus, der gemeint ist.</translation>
    </message>
    <message>
        <source>Placing the scan on the cover …</source>
        <translation>Der Scan wird am Bezug ausgerichtet …</translation>
    </message>
    <message>
        <source>Placing the scan on the cover: step %1</source>
        <translation>Der Scan wird am Bezug ausgerichtet: Schritt %1</translation>
    </message>
    <message>
        <source>A&amp;lign …</source>
        <translation>An drei Stellen ausr&amp;ichten …</translation>
    </message>
    <message>
        <source>Click three places of the scan and where each belongs; the rest is found</source>
        <translation>Drei Stellen des Scans anklicken und wohin jede gehört; den Rest findet das Programm</translation>
    </message>
    <message>
        <source>Aligning the scan …</source>
        <translation>Der Scan wird ausgerichtet …</translation>
    </message>
    <message>
        <source>Aligning the scan: step %1</source>
        <translation>Der Scan wird ausgerichtet: Schritt %1</translation>
    </message>
</context>
<context>
    <name>ScanCutTool</name>
    <message>
        <source>Drag a rectangle around what is to be kept of the scan. Esc ends.</source>
        <translation>Ziehen Sie ein Rechteck um das, was vom Scan bleiben soll. Esc beendet.</translation>
    </message>
    <message>
        <source>Drag a rectangle over what is to be cut away of the scan. Esc ends.</source>
        <translation>Ziehen Sie ein Rechteck über das, was vom Scan wegfallen soll. Esc beendet.</translation>
    </message>
</context>
<context>
    <name>ScanForm</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Place on &amp;the cover</source>
        <translation>Am Be&amp;zug ausrichten</translation>
    </message>
    <message>
        <source>Choose an&amp;other file …</source>
        <translation>Andere Datei wäh&amp;len …</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>%1 of %2 points, one every %3</source>
        <translation>%1 von %2 Punkten, einer alle %3</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>%1 rms</source>
        <translation>%1 quadr. Mittel</translation>
    </message>
    <message>
        <source>Median, 95 %</source>
        <translation>Median, 95 %</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größte</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Floor at</source>
        <translation>Boden bei</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Cut awa&amp;y …</source>
        <translation>&amp;Wegschneiden …</translation>
    </message>
    <message>
        <source>&amp;Keep only …</source>
        <translation>&amp;Nur behalten …</translation>
    </message>
    <message>
        <source>Keep aroun&amp;d the cover</source>
        <translation>&amp;Umgebung des Bezugs behalten</translation>
    </message>
    <message>
        <source>Remove a&amp;ll cuts</source>
        <translation>Alle Schnitte en&amp;tfernen</translation>
    </message>
    <message>
        <source>Ali&amp;gn …</source>
        <translation>An drei Stellen ausr&amp;ichten …</translation>
    </message>
    <message>
        <source>Between the cover and the scan, where they are nearer than the threshold.</source>
        <translation>Zwischen Bezug und Scan, wo sie näher beieinander liegen als die Schwelle.</translation>
    </message>
    <message>
        <source>Half of what is measured, and 95 % of it, is no farther from the scan than that.</source>
        <translation>Die Hälfte dessen, was gemessen wurde, und 95 % davon sind nicht weiter vom Scan entfernt.</translation>
    </message>
    <message>
        <source>How much of the cover has points of the scan near it.</source>
        <translation>Wie viel vom Bezug Punkte des Scans in der Nähe hat.</translation>
    </message>
    <message>
        <source>Of the scan, without what is cut away.</source>
        <translation>Des Scans, ohne das, was weggeschnitten ist.</translation>
    </message>
</context>
<context>
    <name>SeamForm</name>
    <message>
        <source>First side</source>
        <translation>Erste Seite</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Second side</source>
        <translation>Zweite Seite</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Mehrweite</translation>
    </message>
</context>
<context>
    <name>SectionHandle</name>
    <message>
        <source>Section at %1 – Ctrl turns it by 15°, Escape puts it back</source>
        <translation>Schnittebene bei %1 – Strg dreht sie um 15°, Escape setzt sie zurück</translation>
    </message>
    <message>
        <source>Drag to move the section, with Ctrl to turn it</source>
        <translation>Ziehen verschiebt die Schnittebene, mit Strg wird sie gedreht</translation>
    </message>
</context>
<context>
    <name>SelectedEdgesForm</name>
    <message>
        <source>Edge length</source>
        <translation>Länge der Kante</translation>
    </message>
    <message>
        <source>Edge lengths</source>
        <translation>Längen der Kanten</translation>
    </message>
    <message>
        <source>%1 edges. Of &quot;Make equally long&quot; the first one stays: %2 of %3.</source>
        <translation>%1 Kanten. Bei „Gleich lang machen“ bleibt die erste, wie sie ist: %2 an %3.</translation>
    </message>
    <message>
        <source>Edge of</source>
        <translation>Kante von</translation>
    </message>
</context>
<context>
    <name>SelectedPointsForm</name>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Layout x, y</source>
        <translation>Lage x, y</translation>
    </message>
    <message>
        <source>Length between</source>
        <translation>Länge dazwischen</translation>
    </message>
    <message>
        <source>Space x, y, z</source>
        <translation>Raum x, y, z</translation>
    </message>
</context>
<context>
    <name>SelectionEdits</name>
    <message>
        <source>Not removed: the curve needs these points.</source>
        <translation>Nicht entfernt: die Kurve braucht diese Punkte.</translation>
    </message>
    <message>
        <source>Not removed: other elements need this fabric.</source>
        <translation>Nicht entfernt: andere Elemente brauchen diesen Stoff.</translation>
    </message>
    <message>
        <source>An edge cannot be removed: its points can, or with Esc the whole patch.</source>
        <translation>Eine Kante lässt sich nicht entfernen: ihre Punkte schon, oder nach Esc das ganze Schnittteil.</translation>
    </message>
</context>
<context>
    <name>SettingsForm</name>
    <message>
        <source>Patches</source>
        <translation>Schnittteile</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Nähte</translation>
    </message>
    <message>
        <source>Select something to see its properties.</source>
        <translation>Wählen Sie etwas aus, um seine Eigenschaften zu sehen.</translation>
    </message>
    <message>
        <source>Symmetric design</source>
        <translation>Symmetrischer Entwurf</translation>
    </message>
    <message>
        <source>Plane through</source>
        <translation>Ebene durch</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Axis through</source>
        <translation>Achse durch</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>%1, %2 in all</source>
        <translation>%1, zusammen %2</translation>
    </message>
    <message>
        <source>A point of the plane in which the cover is mirrored</source>
        <translation>Ein Punkt der Ebene, an der der Bezug gespiegelt wird</translation>
    </message>
    <message>
        <source>The direction straight out of that plane</source>
        <translation>Die Richtung senkrecht aus dieser Ebene heraus</translation>
    </message>
    <message>
        <source>A point of the line of the pattern at which patches are mirrored</source>
        <translation>Ein Punkt der Linie im Schnitt, an der Schnittteile gespiegelt werden</translation>
    </message>
    <message>
        <source>The direction of that line</source>
        <translation>Die Richtung dieser Linie</translation>
    </message>
    <message>
        <source>Twins are mirror images of each other. With this mark you say where the mirror stands; without it, it stands in the middle, between left and right.</source>
        <translation>Zwillinge sind Spiegelbilder voneinander. Mit diesem Häkchen bestimmen Sie, wo der Spiegel steht; ohne es steht er in der Mitte zwischen links und rechts.</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Netzpunkte</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>How many points the cover has at this edge length: solving takes time and memory for each.</source>
        <translation>So viele Punkte hat der Bezug bei dieser Kantenlänge: Jeder kostet beim Lösen Zeit und Speicher.</translation>
    </message>
</context>
<context>
    <name>SewPicture</name>
    <message>
        <source>Ease %1, %2</source>
        <translation>Mehrweite %1, %2</translation>
    </message>
</context>
<context>
    <name>SewTool</name>
    <message>
        <source>Click on the outline of a patch.</source>
        <translation>Klicke auf den Umriss eines Schnittteils.</translation>
    </message>
    <message>
        <source>Choose the other side first.</source>
        <translation>Wähle erst die andere Seite.</translation>
    </message>
    <message>
        <source>Release where the stretch ends</source>
        <translation>Loslassen, wo der Abschnitt endet</translation>
    </message>
    <message>
        <source>Click where the stretch ends – Esc goes back</source>
        <translation>Klicken, wo der Abschnitt endet – Esc geht zurück</translation>
    </message>
    <message>
        <source>Click to sew it the other way round (F)</source>
        <translation>Klicken, um andersherum zu nähen (F)</translation>
    </message>
    <message>
        <source>Click the edge to sew – drag along the outline, or Shift+click twice, for a part of it; Esc ends the tool</source>
        <translation>Klicke auf die Kante, die genäht wird – am Umriss entlangziehen oder zweimal Umschalt+Klick nimmt einen Teil; Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>Click the edges of the row one after the other, Enter sews – F flips, Backspace takes one back</source>
        <translation>Klicke die Kanten der Reihe nacheinander an, Eingabe näht – F kehrt um, Rücktaste nimmt eine zurück</translation>
    </message>
    <message>
        <source>Click the edge it is sewn to – F flips, Ctrl+click or M for several in a row, Backspace goes back</source>
        <translation>Klicke auf die Kante, an die sie genäht wird – F kehrt um, Strg+Klick oder M für mehrere in einer Reihe, Rücktaste geht zurück</translation>
    </message>
    <message>
        <source>Ctrl+click the next edge of the row, click the last one – Enter sews, F flips, Backspace takes one back</source>
        <translation>Strg+Klick auf die nächste Kante der Reihe, Klick auf die letzte – Eingabe näht, F kehrt um, Rücktaste nimmt eine zurück</translation>
    </message>
    <message>
        <source>&amp;Sew what is marked</source>
        <translation>Markiertes &amp;nähen</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>&amp;Umkehren</translation>
    </message>
    <message>
        <source>Take &amp;one edge</source>
        <translation>&amp;Eine Kante nehmen</translation>
    </message>
    <message>
        <source>Take se&amp;veral edges in a row</source>
        <translation>&amp;Mehrere Kanten in Folge nehmen</translation>
    </message>
    <message>
        <source>&amp;Take back the last edge</source>
        <translation>Letzte Kante &amp;zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>&amp;Verwerfen</translation>
    </message>
</context>
<context>
    <name>SewingSheet</name>
    <message>
        <source>Sewing sheet</source>
        <translation>Nähplan</translation>
    </message>
    <message>
        <source>Sewing sheet: %1</source>
        <translation>Nähplan: %1</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Seams in the order of sewing</source>
        <translation>Nähte in der Reihenfolge des Nähens</translation>
    </message>
    <message>
        <source>%1 and %1 mirrored</source>
        <translation>%1 und %1 gespiegelt</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Stoff</translation>
    </message>
    <message>
        <source>Area as cut</source>
        <translation>Zuschnittfläche</translation>
    </message>
    <message>
        <source>top stitched on both sides</source>
        <translation>beidseitig abgesteppt</translation>
    </message>
    <message>
        <source>top stitched</source>
        <translation>abgesteppt</translation>
    </message>
    <message>
        <source>%1 mm long, %2 mm from the seam</source>
        <translation>Stiche %1 mm lang, %2 mm neben der Naht</translation>
    </message>
    <message>
        <source>piping, %1 mm thick</source>
        <translation>Keder, %1 mm dick</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>einfach</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>%1, with itself</source>
        <translation>%1, mit sich selbst</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 an %2</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>Lengths, mm</source>
        <translation>Längen, mm</translation>
    </message>
    <message>
        <source>Allowance, mm</source>
        <translation>Zugabe, mm</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Knipse</translation>
    </message>
    <message>
        <source>Stitch</source>
        <translation>Stich</translation>
    </message>
    <message>
        <source>%1 m², without what lies between the pieces</source>
        <translation>%1 m², ohne das, was zwischen den Teilen liegt</translation>
    </message>
    <message>
        <source>Sewing thread</source>
        <translation>Nähgarn</translation>
    </message>
    <message>
        <source>Top thread &lt;span style=&quot;background-color:%1&quot;&gt;&amp;nbsp;&amp;nbsp;&amp;nbsp;&amp;nbsp;&lt;/span&gt; %1</source>
        <translation>Ziergarn &lt;span style=&quot;background-color:%1&quot;&gt;&amp;nbsp;&amp;nbsp;&amp;nbsp;&amp;nbsp;&lt;/span&gt; %1</translation>
    </message>
    <message>
        <source>%1 m, at %2 m for each metre of a row</source>
        <translation>%1 m, mit %2 m für jeden Meter einer Reihe</translation>
    </message>
    <message>
        <source>Piping</source>
        <translation>Keder</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>Wie viel</translation>
    </message>
    <message>
        <source>zip</source>
        <translation>Reißverschluss</translation>
    </message>
    <message>
        <source>Zip</source>
        <translation>Reißverschluss</translation>
    </message>
    <message>
        <source>Pieces, with the numbers of their seams</source>
        <translation>Teile, mit den Nummern ihrer Nähte</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Nähte</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Width × height as cut</source>
        <translation>Breite × Höhe im Zuschnitt</translation>
    </message>
    <message>
        <source>Ease, %</source>
        <translation>Mehrweite, %</translation>
    </message>
    <message>
        <source>nap one way: all pieces point up</source>
        <translation>Strich in einer Richtung: alle Teile zeigen nach oben</translation>
    </message>
</context>
<context>
    <name>SnapHints</name>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Midpoint</source>
        <translation>Mittelpunkt</translation>
    </message>
    <message>
        <source>On an outline</source>
        <translation>Auf einem Umriss</translation>
    </message>
    <message>
        <source>Aligned</source>
        <translation>Ausgerichtet</translation>
    </message>
    <message>
        <source>Direction %1</source>
        <translation>Richtung %1</translation>
    </message>
    <message>
        <source>Perpendicular</source>
        <translation>Rechtwinklig</translation>
    </message>
    <message>
        <source>As long: %1</source>
        <translation>Gleich lang: %1</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Hilfslinie</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
</context>
<context>
    <name>StartCommands</name>
    <message>
        <source>Start pa&amp;ge</source>
        <translation>St&amp;artseite</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Neues Fens&amp;ter</translation>
    </message>
    <message>
        <source>No other window could be opened.</source>
        <translation>Es konnte kein weiteres Fenster geöffnet werden.</translation>
    </message>
    <message>
        <source>The system did not start the program again. Close some programs, and try once more.</source>
        <translation>Das System hat das Programm nicht noch einmal gestartet. Schließen Sie einige Programme, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>&amp;Report a problem …</source>
        <translation>&amp;Problem melden …</translation>
    </message>
    <message>
        <source>What&apos;s &amp;new</source>
        <translation>Was ist &amp;neu?</translation>
    </message>
    <message>
        <source>This is Bolster %1. What is new is under Help &gt; What&apos;s new.</source>
        <translation>Das ist Bolster %1. Was neu ist, steht unter Hilfe &gt; Was ist neu?</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>The frame is in the 3D view. Draw the curves on it where the cloth is fixed, or the first patch.</source>
        <translation>Das Gestell ist in der 3D-Ansicht. Zeichnen Sie darauf die Kurven, an denen der Stoff fixiert wird, oder das erste Schnittteil.</translation>
    </message>
    <message>
        <source>Draw a &amp;fixation curve</source>
        <translation>&amp;Fixierkurve zeichnen</translation>
    </message>
    <message>
        <source>Draw a &amp;rectangle</source>
        <translation>&amp;Rechteck zeichnen</translation>
    </message>
    <message>
        <source>Pattern of a form …</source>
        <translation>Schnitt aus einer Form …</translation>
    </message>
</context>
<context>
    <name>StretchEndDrag</name>
    <message>
        <source>%1 long – Ctrl lets go of what is near, Esc takes it back</source>
        <translation>%1 lang – Strg löst das Einrasten, Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>%1 long, the other side %2: ease %3, %4 – Ctrl lets go of what is near, Esc takes it back</source>
        <translation>%1 lang, die andere Seite %2: Mehrweite %3, %4 – Strg löst das Einrasten, Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>End of another stretch</source>
        <translation>Ende eines anderen Abschnitts</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>As long as the other side</source>
        <translation>So lang wie die andere Seite</translation>
    </message>
</context>
<context>
    <name>SurfaceCommands</name>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>&amp;Figures …</source>
        <translation>&amp;Zahlen …</translation>
    </message>
</context>
<context>
    <name>SweepWindow</name>
    <message>
        <source>&amp;Cut</source>
        <translation>&amp;Zuschnitt</translation>
    </message>
    <message>
        <source>Each piece is cut so much larger or smaller all around</source>
        <translation>Jedes Schnittteil ist rundum um so viel größer oder kleiner zugeschnitten</translation>
    </message>
    <message>
        <source>Cut of %1</source>
        <translation>Zuschnitt von %1</translation>
    </message>
    <message>
        <source>S&amp;eams</source>
        <translation>&amp;Nähte</translation>
    </message>
    <message>
        <source>Each seam is sewn so much farther inside or outside, on both sides</source>
        <translation>Jede Naht ist um so viel weiter innen oder außen genäht, auf beiden Seiten</translation>
    </message>
    <message>
        <source>Seam %1</source>
        <translation>Naht %1</translation>
    </message>
    <message>
        <source>&amp;Foam</source>
        <translation>&amp;Schaum</translation>
    </message>
    <message>
        <source>Each cushion and foam is so much thicker or thinner</source>
        <translation>Jede Polsterung und jeder Schaum ist um so viel dicker oder dünner</translation>
    </message>
    <message>
        <source>Thickness of %1</source>
        <translation>Dicke von %1</translation>
    </message>
    <message>
        <source>Fi&amp;xations</source>
        <translation>&amp;Fixierungen</translation>
    </message>
    <message>
        <source>Each fixation curve lies so much elsewhere, along each axis</source>
        <translation>Jede Fixierkurve liegt um so viel anderswo, entlang jeder Achse</translation>
    </message>
    <message>
        <source>Place of %1</source>
        <translation>Lage von %1</translation>
    </message>
    <message>
        <source>S&amp;tiffness</source>
        <translation>S&amp;teifigkeit</translation>
    </message>
    <message>
        <source>Each fabric is so much stiffer or softer</source>
        <translation>Jeder Stoff ist um so viel steifer oder weicher</translation>
    </message>
    <message>
        <source>Stiffness of %1</source>
        <translation>Steifigkeit von %1</translation>
    </message>
    <message>
        <source>Sh&amp;rinkage</source>
        <translation>&amp;Einlauf</translation>
    </message>
    <message>
        <source>Each piece shrinks or stretches by so much</source>
        <translation>Jedes Schnittteil läuft um so viel ein oder dehnt sich</translation>
    </message>
    <message>
        <source>Shrinkage of %1</source>
        <translation>Einlauf von %1</translation>
    </message>
</context>
<context>
    <name>Templates</name>
    <message>
        <source>Cushion</source>
        <translation>Kissen</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Polsterrolle</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>Sitzbank</translation>
    </message>
    <message>
        <source>Dining chair</source>
        <translation>Esszimmerstuhl</translation>
    </message>
    <message>
        <source>Wing chair</source>
        <translation>Ohrensessel</translation>
    </message>
    <message>
        <source>Car seat</source>
        <translation>Autositz</translation>
    </message>
    <message>
        <source>Headrest</source>
        <translation>Kopfstütze</translation>
    </message>
</context>
<context>
    <name>ToolCommands</name>
    <message>
        <source>&amp;Select and move</source>
        <translation>&amp;Auswählen und verschieben</translation>
    </message>
    <message>
        <source>Draw &amp;outline</source>
        <translation>&amp;Umriss zeichnen</translation>
    </message>
    <message>
        <source>Draw &amp;rectangle</source>
        <translation>&amp;Rechteck zeichnen</translation>
    </message>
    <message>
        <source>Draw &amp;ellipse</source>
        <translation>&amp;Ellipse zeichnen</translation>
    </message>
    <message>
        <source>S&amp;plit patch</source>
        <translation>Schnittteil &amp;teilen</translation>
    </message>
    <message>
        <source>Draw &amp;handle curve</source>
        <translation>&amp;Griffkurve zeichnen</translation>
    </message>
    <message>
        <source>Draw &amp;fancy seam</source>
        <translation>&amp;Ziernaht zeichnen</translation>
    </message>
    <message>
        <source>Se&amp;w</source>
        <translation>&amp;Nähen</translation>
    </message>
    <message>
        <source>&amp;Attach to fixation curve</source>
        <translation>&amp;An Fixierkurve befestigen</translation>
    </message>
    <message>
        <source>Stitch or pipe a seam</source>
        <translation>Naht absteppen oder mit Keder versehen</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>&amp;Draw fixation curve</source>
        <translation>&amp;Fixierkurve zeichnen</translation>
    </message>
    <message>
        <source>Draw &amp;internal line</source>
        <translation>&amp;Innenlinie zeichnen</translation>
    </message>
    <message>
        <source>Allowance of an ed&amp;ge</source>
        <translation>Zu&amp;gabe einer Kante</translation>
    </message>
    <message>
        <source>&amp;Corner of the cut line</source>
        <translation>E&amp;cke der Schnittlinie</translation>
    </message>
    <message>
        <source>Place &amp;notches</source>
        <translation>K&amp;nipse setzen</translation>
    </message>
    <message>
        <source>Place &amp;drill holes</source>
        <translation>Bohrlöcher s&amp;etzen</translation>
    </message>
    <message>
        <source>&amp;Cutting</source>
        <translation>&amp;Zuschnitt</translation>
    </message>
    <message>
        <source>Draw &amp;dart</source>
        <translation>Ab&amp;näher zeichnen</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>&amp;Tour</source>
        <translation>R&amp;undgang</translation>
    </message>
    <message>
        <source>The coloured curves on the frame are where the cloth is tied down. Click one of them, then drag one of its points: the cover follows.</source>
        <translation>An den farbigen Kurven auf dem Gestell ist der Stoff abgespannt. Klicken Sie eine davon an, und ziehen Sie dann an einem ihrer Punkte: Der Bezug folgt.</translation>
    </message>
    <message>
        <source>The cover follows while you drag, and comes to rest when you let go.</source>
        <translation>Der Bezug folgt beim Ziehen und kommt zur Ruhe, wenn Sie loslassen.</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Ctrl+Z, or this button, takes back whatever was done, as far as you like. Nothing is lost by it: the history keeps what was undone, too.</source>
        <translation>Strg+Z oder diese Schaltfläche nimmt alles zurück, was getan wurde, so weit Sie wollen. Verloren geht dabei nichts: Der Verlauf behält auch, was rückgängig gemacht wurde.</translation>
    </message>
    <message>
        <source>It is as it was. Undone steps are still in the history.</source>
        <translation>Es ist, wie es war. Rückgängig gemachte Schritte stehen noch im Verlauf.</translation>
    </message>
    <message>
        <source>Choose a seam</source>
        <translation>Eine Naht auswählen</translation>
    </message>
    <message>
        <source>Seams join two edges of the pattern. Click one, in the pattern or on the cover: both of its edges light up, and the cover shows where it is.</source>
        <translation>Nähte verbinden zwei Kanten des Schnitts. Klicken Sie eine an, im Schnitt oder auf dem Bezug: Ihre beiden Kanten leuchten auf, und der Bezug zeigt, wo sie ist.</translation>
    </message>
    <message>
        <source>Its properties are at the right now.</source>
        <translation>Ihre Eigenschaften stehen jetzt rechts.</translation>
    </message>
    <message>
        <source>Change how it is sewn</source>
        <translation>Ändern, wie sie genäht wird</translation>
    </message>
    <message>
        <source>With the seam selected, choose another continuity in its properties, or another stitching: an edge, a rounded seam or a smooth one.</source>
        <translation>Wählen Sie bei ausgewählter Naht in ihren Eigenschaften einen anderen Übergang oder eine andere Steppung: mit Kante, gerundet oder glatt.</translation>
    </message>
    <message>
        <source>The cover shows the seam as it will be sewn.</source>
        <translation>Der Bezug zeigt die Naht, wie sie genäht wird.</translation>
    </message>
    <message>
        <source>Look at the strain</source>
        <translation>Die Dehnung ansehen</translation>
    </message>
    <message>
        <source>View &gt; Map colours the cover by what the cloth has to bear. Choose Largest strain to see where it is stretched most.</source>
        <translation>Ansicht &gt; Karte färbt den Bezug danach, was der Stoff aushalten muss. Wählen Sie „Größte Dehnung“, um zu sehen, wo er am stärksten gedehnt ist.</translation>
    </message>
    <message>
        <source>The legend says how much, and the pointer reads it at any place.</source>
        <translation>Die Legende sagt, wie viel es ist, und der Zeiger liest es an jeder Stelle ab.</translation>
    </message>
    <message>
        <source>Change the pattern</source>
        <translation>Den Schnitt ändern</translation>
    </message>
    <message>
        <source>Drag a point of an outline, or cut a dart (Pattern &gt; Draw dart): what you change in the flat is sewn at once.</source>
        <translation>Ziehen Sie an einem Punkt eines Umrisses, oder schneiden Sie einen Abnäher (Schnitt &gt; Abnäher zeichnen): Was Sie im Flachen ändern, wird sofort genäht.</translation>
    </message>
    <message>
        <source>Seams keep their places on an outline that changes.</source>
        <translation>Nähte behalten ihre Plätze auf einem Umriss, der sich ändert.</translation>
    </message>
    <message>
        <source>Take it with you</source>
        <translation>Mitnehmen</translation>
    </message>
    <message>
        <source>File &gt; Export pattern writes DXF, PDF or SVG with seam allowances and notches; Export cover writes the cover for others.</source>
        <translation>Datei &gt; Schnitt exportieren schreibt DXF, PDF oder SVG mit Nahtzugaben und Knipsen; Bezug exportieren schreibt den Bezug für andere.</translation>
    </message>
    <message>
        <source>The file is written.</source>
        <translation>Die Datei ist geschrieben.</translation>
    </message>
    <message>
        <source>That was the tour</source>
        <translation>Das war der Rundgang</translation>
    </message>
    <message>
        <source>You have seen how pattern, seams and frame make the cover. Begin with a design of your own: File &gt; Start page has templates. What each key does is under Help &gt; Keys and mouse.</source>
        <translation>Sie haben gesehen, wie aus Schnitt, Nähten und Gestell der Bezug wird. Beginnen Sie mit einem eigenen Entwurf: Datei &gt; Startseite hat Vorlagen. Was welche Taste tut, steht unter Hilfe &gt; Tasten und Maus.</translation>
    </message>
    <message>
        <source>Drag a fixation curve</source>
        <translation>Eine Fixierkurve ziehen</translation>
    </message>
</context>
<context>
    <name>TrimSection</name>
    <message>
        <source>Stitching</source>
        <translation>Steppung</translation>
    </message>
    <message>
        <source>Colour of the thread</source>
        <translation>Farbe des Fadens</translation>
    </message>
    <message>
        <source>Piping</source>
        <translation>Keder</translation>
    </message>
    <message>
        <source>As the patch</source>
        <translation>Wie das Schnittteil</translation>
    </message>
</context>
<context>
    <name>TwinCommands</name>
    <message>
        <source>Make &amp;mirror twin</source>
        <translation>&amp;Spiegelzwilling anlegen</translation>
    </message>
    <message>
        <source>Link as t&amp;wins</source>
        <translation>Als &amp;Zwillinge koppeln</translation>
    </message>
    <message>
        <source>&amp;Unlink twins</source>
        <translation>Z&amp;willinge trennen</translation>
    </message>
    <message>
        <source>R&amp;elease points from the twin</source>
        <translation>Punkte vom Zwilling &amp;lösen</translation>
    </message>
    <message>
        <source>Re-l&amp;ink points to the twin</source>
        <translation>Punkte wieder an den Zwilling &amp;koppeln</translation>
    </message>
    <message>
        <source>S&amp;ymmetry …</source>
        <translation>S&amp;ymmetrie …</translation>
    </message>
    <message>
        <source>%1, mirrored</source>
        <translation>%1, gespiegelt</translation>
    </message>
    <message>
        <source>Select patches or curves that have no twin yet.</source>
        <translation>Schnittteile oder Kurven auswählen, die noch keinen Zwilling haben.</translation>
    </message>
    <message>
        <source>Nothing that is selected has a twin.</source>
        <translation>Nichts von dem, was ausgewählt ist, hat einen Zwilling.</translation>
    </message>
    <message>
        <source>Select points of a twin, or a seam on it, that still follow.</source>
        <translation>Punkte eines Zwillings oder eine Naht daran auswählen, die noch folgen.</translation>
    </message>
    <message>
        <source>No point that is selected has been released.</source>
        <translation>Kein ausgewählter Punkt ist gelöst.</translation>
    </message>
</context>
<context>
    <name>TwinForm</name>
    <message>
        <source>Mirror image</source>
        <translation>Spiegelbild</translation>
    </message>
    <message>
        <source>released</source>
        <translation>gelöst</translation>
    </message>
    <message>
        <source>itself</source>
        <translation>sie selbst</translation>
    </message>
    <message>
        <source>Re-lin&amp;k to its mirror image</source>
        <translation>Wieder mit dem Spiegelbild ver&amp;knüpfen</translation>
    </message>
    <message>
        <source>Re&amp;lease from its mirror image</source>
        <translation>&amp;Vom Spiegelbild lösen</translation>
    </message>
    <message>
        <source>Twin of</source>
        <translation>Zwilling von</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>Ausnahmen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message numerus="yes">
        <source>%n released points</source>
        <translation>
            <numerusform>%n gelöster Punkt</numerusform>
            <numerusform>%n gelöste Punkte</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Unlink from its twin</source>
        <translation>Vom Zwilling t&amp;rennen</translation>
    </message>
    <message>
        <source>Re-link all poi&amp;nts</source>
        <translation>Alle &amp;Punkte wieder koppeln</translation>
    </message>
</context>
<context>
    <name>Units</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>%1 ft</source>
        <translation>%1 ft</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 ft²</source>
        <translation>%1 ft²</translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
</context>
<context>
    <name>UnusableForm</name>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>It keeps its text and is saved as it is.</source>
        <translation>Es behält seinen Text und wird unverändert gespeichert.</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>Show &amp;all</source>
        <translation>&amp;Alles zeigen</translation>
    </message>
    <message>
        <source>Show &amp;selection</source>
        <translation>Aus&amp;wahl zeigen</translation>
    </message>
    <message>
        <source>Look at the &amp;cover from</source>
        <translation>&amp;Bezug ansehen von</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>Three-&amp;quarter</source>
        <translation>&amp;Dreiviertelansicht</translation>
    </message>
    <message>
        <source>Sa&amp;ved views</source>
        <translation>Gespeicherte Ansich&amp;ten</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspektive</translation>
    </message>
    <message>
        <source>Sec&amp;tion</source>
        <translation>Schni&amp;ttebene</translation>
    </message>
    <message>
        <source>Lin&amp;k the views</source>
        <translation>Ansichten verknü&amp;pfen</translation>
    </message>
    <message>
        <source>Show the pointer&apos;s place in the other view, too</source>
        <translation>Die Stelle unter dem Zeiger auch in der anderen Ansicht zeigen</translation>
    </message>
    <message>
        <source>&amp;Hide selected</source>
        <translation>Gewähltes &amp;ausblenden</translation>
    </message>
    <message>
        <source>&amp;Isolate selected</source>
        <translation>Nur Gewähltes &amp;zeigen</translation>
    </message>
    <message>
        <source>Sho&amp;w hidden again</source>
        <translation>Versteckte &amp;wieder zeigen</translation>
    </message>
    <message>
        <source>Th&amp;eme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;Opacity</source>
        <translation>Dec&amp;kkraft</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Frames and foam</source>
        <translation>Gestelle und Schaum</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Scans</translation>
    </message>
    <message>
        <source>Opacity of frames and scans</source>
        <translation>Deckkraft von Gestellen und Scans</translation>
    </message>
    <message>
        <source>Select patches, curves, frames, foam or scans to hide them.</source>
        <translation>Wählen Sie Schnittteile, Kurven, Gestelle, Schaum oder Scans, um sie auszublenden.</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>Hoher &amp;Kontrast</translation>
    </message>
</context>
<context>
    <name>ViewPrint</name>
    <message>
        <source>Print the view</source>
        <translation>Ansicht drucken</translation>
    </message>
    <message>
        <source>The view could not be printed.</source>
        <translation>Die Ansicht konnte nicht gedruckt werden.</translation>
    </message>
    <message>
        <source>The printer takes nothing at the moment. Look whether it is on and has paper, or print to a file.</source>
        <translation>Der Drucker nimmt im Moment nichts an. Sehen Sie nach, ob er eingeschaltet ist und Papier hat, oder drucken Sie in eine Datei.</translation>
    </message>
</context>
<context>
    <name>WhatsNew</name>
    <message>
        <source>What&apos;s new</source>
        <translation>Was ist neu?</translation>
    </message>
</context>
<context>
    <name>WindowCommands</name>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>&amp;Nächster Teil des Fensters</translation>
    </message>
    <message>
        <source>Pre&amp;vious part of the window</source>
        <translation>&amp;Voriger Teil des Fensters</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
</context>
<context>
    <name>bolster::AreaRow</name>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Onl&amp;y in a painted area</source>
        <translation>N&amp;ur in einem gemalten Bereich</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>The form and the limit of strain count only there</source>
        <translation>Form und Grenze der Dehnung zählen nur dort</translation>
    </message>
    <message>
        <source>Drag over the cover in the 3D view; with Shift held down it takes away</source>
        <translation>In der 3D-Ansicht über den Bezug ziehen; mit gedrückter Umschalttaste nimmt es weg</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Radius des Pinsels</translation>
    </message>
    <message>
        <source>Painted area</source>
        <translation>Gemalter Bereich</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
</context>
<context>
    <name>bolster::Banner</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>bolster::CanvasChoice</name>
    <message>
        <source>Drawn in software</source>
        <translation>In Software gezeichnet</translation>
    </message>
</context>
<context>
    <name>bolster::CauseWindow</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Why is it so?</source>
        <translation>Woran liegt es?</translation>
    </message>
    <message>
        <source>The scan of the piece</source>
        <translation>Der Scan des Stücks</translation>
    </message>
    <message>
        <source>The scan of a sound piece</source>
        <translation>Der Scan eines guten Stücks</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>Of a piece that is as it should be: where that lies elsewhere than the cover no cause is looked for</source>
        <translation>Von einem Stück, das so ist, wie es sein soll: Wo dieses vom Bezug abweicht, wird keine Ursache gesucht</translation>
    </message>
    <message>
        <source>Scan of the &amp;piece</source>
        <translation>Scan des &amp;Stücks</translation>
    </message>
    <message>
        <source>Scan of a so&amp;und piece</source>
        <translation>Scan eines &amp;guten Stücks</translation>
    </message>
    <message>
        <source>Look for the &amp;cause</source>
        <translation>&amp;Ursache suchen</translation>
    </message>
    <message>
        <source>Looking for a cause …</source>
        <translation>Eine Ursache wird gesucht …</translation>
    </message>
    <message>
        <source>Says which one cause explains best how far a built piece lies from the cover: foam, a seam&apos;s allowance, a stretched piece, a fixation off its place, a slipped notch.</source>
        <translation>Sagt, welche einzelne Ursache am besten erklärt, wie weit ein gebautes Stück vom Bezug abweicht: Schaum, Zugabe einer Naht, ein gedehntes Teil, eine Fixierung nicht an ihrem Platz, ein verrutschter Knips.</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Ursache</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>Explains</source>
        <translation>Erklärt</translation>
    </message>
    <message>
        <source>Probability</source>
        <translation>Wahrscheinlichkeit</translation>
    </message>
    <message>
        <source>Causes</source>
        <translation>Ursachen</translation>
    </message>
    <message>
        <source>Choose the scan of the piece that was built.</source>
        <translation>Wählen Sie den Scan des gebauten Stücks.</translation>
    </message>
    <message>
        <source>Covers with each cause are solved …</source>
        <translation>Bezüge mit jeder Ursache werden berechnet …</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>The scan shows nothing of the cover: does it lie where the design is?</source>
        <translation>Der Scan zeigt nichts vom Bezug: Liegt er dort, wo der Entwurf ist?</translation>
    </message>
    <message>
        <source>The scan shows %1 of the cover and lies %2 (rms) from it. All causes together leave %3.</source>
        <translation>Der Scan zeigt %1 des Bezugs und ist %2 von ihm entfernt (quadratisches Mittel). Alle Ursachen zusammen lassen %3 übrig.</translation>
    </message>
    <message>
        <source>No single cause explains that better than noise does.</source>
        <translation>Keine einzelne Ursache erklärt das besser als Rauschen.</translation>
    </message>
    <message>
        <source>Most of the deviation has no cause of these kinds, so the first need not be the right one: give the scan of a sound piece, too.</source>
        <translation>Der größte Teil der Abweichung hat keine Ursache dieser Arten, die erste muss also nicht die richtige sein: Geben Sie auch den Scan eines guten Stücks an.</translation>
    </message>
    <message numerus="yes">
        <source>and %n others</source>
        <translation>
            <numerusform>und %n weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>The scan does not tell it apart from: %1</source>
        <translation>Der Scan unterscheidet sie nicht von: %1</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: look again.</source>
        <translation>Der Entwurf hat sich inzwischen geändert: Suchen Sie neu.</translation>
    </message>
    <message>
        <source>Stopped. The list is that of the search before.</source>
        <translation>Angehalten. Die Liste ist die der Suche davor.</translation>
    </message>
    <message>
        <source>The scan lies on the cover: there is nothing to explain.</source>
        <translation>Der Scan liegt auf dem Bezug: es gibt nichts zu erklären.</translation>
    </message>
    <message>
        <source>Even the likeliest cause explains only %1 of it: there may be several, or others than these.</source>
        <translation>Auch die wahrscheinlichste Ursache erklärt nur %1 davon: es können mehrere sein oder andere als diese.</translation>
    </message>
    <message>
        <source>Foam is thicker or thinner</source>
        <translation>Schaum ist dicker oder dünner</translation>
    </message>
    <message>
        <source>Foam is harder or softer</source>
        <translation>Schaum ist härter oder weicher</translation>
    </message>
    <message>
        <source>Allowance of a seam</source>
        <translation>Zugabe einer Naht</translation>
    </message>
    <message>
        <source>Piece is larger or smaller</source>
        <translation>Schnittteil ist größer oder kleiner</translation>
    </message>
    <message>
        <source>Fixation lies elsewhere</source>
        <translation>Fixierung liegt anderswo</translation>
    </message>
    <message>
        <source>Seam is sewn shifted</source>
        <translation>Naht ist versetzt genäht</translation>
    </message>
    <message>
        <source>%1 thicker</source>
        <translation>%1 dicker</translation>
    </message>
    <message>
        <source>%1 thinner</source>
        <translation>%1 dünner</translation>
    </message>
    <message>
        <source>%1 harder</source>
        <translation>%1 härter</translation>
    </message>
    <message>
        <source>%1 softer</source>
        <translation>%1 weicher</translation>
    </message>
    <message>
        <source>%1 farther out</source>
        <translation>%1 weiter außen</translation>
    </message>
    <message>
        <source>%1 farther in</source>
        <translation>%1 weiter innen</translation>
    </message>
    <message>
        <source>%1 larger</source>
        <translation>%1 größer</translation>
    </message>
    <message>
        <source>%1 smaller</source>
        <translation>%1 kleiner</translation>
    </message>
    <message>
        <source>%1 counter-clockwise</source>
        <translation>%1 gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>%1 clockwise</source>
        <translation>%1 im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Farther out: the allowance was taken narrower, on both sides</source>
        <translation>Weiter außen: Die Zugabe wurde auf beiden Seiten schmaler genommen</translation>
    </message>
    <message>
        <source>Along the edge of %1, as it lies in the pattern</source>
        <translation>Entlang der Kante von %1, wie es im Schnitt liegt</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>The scan shows %1 of the cover. Its points lie %2 (rms) from the cover, of which all causes together leave %3. From the cover to the nearest point, as a fit measures, it is %4.</source>
        <translation>Der Scan zeigt %1 des Bezugs. Seine Punkte sind %2 vom Bezug entfernt (quadratisches Mittel), wovon alle Ursachen zusammen %3 übrig lassen. Vom Bezug zum nächsten Punkt, wie das Anpassen misst, sind es %4.</translation>
    </message>
    <message>
        <source>That is far more than such a cause usually is: there may be several, or others than these.</source>
        <translation>Das ist weit mehr, als eine solche Ursache gewöhnlich ausmacht: Es können mehrere sein oder andere als diese.</translation>
    </message>
    <message>
        <source>What the likeliest cause leaves is more than noise: something else may be wrong, too, and its amount may be off by more than is said.</source>
        <translation>Was die wahrscheinlichste Ursache übrig lässt, ist mehr als Rauschen: Vielleicht stimmt noch etwas anderes nicht, und ihr Maß kann weiter daneben liegen als angegeben.</translation>
    </message>
    <message numerus="yes">
        <source>%n more causes explain some of it, less likely than these.</source>
        <translation>
            <numerusform>%n weitere Ursache erklärt etwas davon, weniger wahrscheinlich als diese.</numerusform>
            <numerusform>%n weitere Ursachen erklären etwas davon, weniger wahrscheinlich als diese.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::ColourwayWindow</name>
    <message>
        <source>Compare colourways</source>
        <translation>Farbvarianten vergleichen</translation>
    </message>
    <message>
        <source>The colourway that is shown below</source>
        <translation>Die Farbvariante, die unten zu sehen ist</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>Wie gefertigt</translation>
    </message>
</context>
<context>
    <name>bolster::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>There is no such command.</source>
        <translation>Einen solchen Befehl gibt es nicht.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
</context>
<context>
    <name>bolster::CompareWindow</name>
    <message>
        <source>&amp;Take from there</source>
        <translation>Von dort ü&amp;bernehmen</translation>
    </message>
    <message>
        <source>Compare versions</source>
        <translation>Fassungen vergleichen</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>Was sich unterscheidet</translation>
    </message>
    <message>
        <source>There</source>
        <translation>Dort</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Makes the chosen elements as they are in the other version: one step in the history</source>
        <translation>Macht die gewählten Elemente so, wie sie in der anderen Fassung sind: ein Schritt im Verlauf</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>only now</source>
        <translation>nur jetzt</translation>
    </message>
    <message>
        <source>only there</source>
        <translation>nur dort</translation>
    </message>
    <message>
        <source>Nothing differs</source>
        <translation>Nichts unterscheidet sich</translation>
    </message>
    <message>
        <source>&amp;Move both together</source>
        <translation>Beide &amp;zusammen bewegen</translation>
    </message>
    <message>
        <source>Turning, moving or zooming one version does the same to the other</source>
        <translation>Drehen, Verschieben und Zoomen der einen Version wirkt auch auf die andere</translation>
    </message>
</context>
<context>
    <name>bolster::ContextMenus</name>
    <message>
        <source>Leave this &amp;piece out</source>
        <translation>Dieses &amp;Stück weglassen</translation>
    </message>
    <message>
        <source>Hides this piece of the frame from the view, drawing, cushioning and contact; the frame&apos;s properties bring it back</source>
        <translation>Blendet dieses Stück des Gestells aus: für die Ansicht, beim Zeichnen, Polstern und Anliegen; in den Eigenschaften des Gestells kommt es zurück</translation>
    </message>
</context>
<context>
    <name>bolster::CoverSelectTool</name>
    <message>
        <source>Kept to an axis; the same key frees it</source>
        <translation>An eine Achse gebunden; dieselbe Taste löst sie</translation>
    </message>
    <message>
        <source>Lifted off the frame along its normal; let go of Ctrl to slide on it</source>
        <translation>Entlang der Normalen vom Gestell abgehoben; Strg loslassen, um darauf zu gleiten</translation>
    </message>
    <message>
        <source>On the frame: Ctrl lifts off, S lets go of it, X, Y, Z or Shift keep to an axis</source>
        <translation>Auf dem Gestell: Strg hebt ab, S löst davon, X, Y, Z oder Umschalt halten eine Achse ein</translation>
    </message>
    <message>
        <source>X, Y, Z or Shift keep to an axis, S keeps to the frame, Ctrl lifts off, Escape cancels</source>
        <translation>X, Y, Z oder Umschalt halten eine Achse ein, S bleibt am Gestell, Strg hebt ab, Esc bricht ab</translation>
    </message>
    <message>
        <source>Moved by x %1, y %2, z %3</source>
        <translation>Um x %1, y %2, z %3 verschoben</translation>
    </message>
</context>
<context>
    <name>bolster::CutFindingsList</name>
    <message>
        <source>What to look at before cutting</source>
        <translation>Was vor dem Zuschnitt anzusehen ist</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>bolster::CuttingPanel</name>
    <message>
        <source>A double click shows where it is.</source>
        <translation>Ein Doppelklick zeigt, wo es ist.</translation>
    </message>
    <message>
        <source>Nothing to mend: the pattern can be cut.</source>
        <translation>Nichts zu verbessern: Der Schnitt kann zugeschnitten werden.</translation>
    </message>
    <message>
        <source>Looking the pattern over …</source>
        <translation>Der Schnitt wird durchgesehen …</translation>
    </message>
    <message>
        <source>There is no pattern yet.</source>
        <translation>Es gibt noch keinen Schnitt.</translation>
    </message>
</context>
<context>
    <name>bolster::DesignSession</name>
    <message>
        <source>New design</source>
        <translation>Neuer Entwurf</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Stoff</translation>
    </message>
    <message>
        <source>Restored design</source>
        <translation>Wiederhergestellter Entwurf</translation>
    </message>
    <message>
        <source> (other)</source>
        <translation> (anderes)</translation>
    </message>
    <message>
        <source> (other %1)</source>
        <translation> (anderes %1)</translation>
    </message>
</context>
<context>
    <name>bolster::DockTitle</name>
    <message>
        <source>Take out of the window, or put back</source>
        <translation>Aus dem Fenster lösen oder zurücksetzen</translation>
    </message>
    <message>
        <source>Close; the Window menu brings it back</source>
        <translation>Schließen; das Menü „Fenster“ holt es zurück</translation>
    </message>
</context>
<context>
    <name>bolster::DropFlow</name>
    <message>
        <source>&quot;%1&quot; cannot be opened.</source>
        <translation>„%1“ lässt sich nicht öffnen.</translation>
    </message>
    <message>
        <source>The system did not start the program again for another window. Open it from here instead.</source>
        <translation>Das System hat das Programm nicht noch einmal für ein weiteres Fenster gestartet. Öffnen Sie es stattdessen von hier aus.</translation>
    </message>
    <message>
        <source>It is a folder. Drop the files that are in it.</source>
        <translation>Das ist ein Ordner. Ziehen Sie die Dateien hierher, die darin liegen.</translation>
    </message>
    <message>
        <source>It is not on this computer, or not any more. Save it to a folder first.</source>
        <translation>Es ist nicht auf diesem Rechner, oder nicht mehr. Speichern Sie es zuerst in einem Ordner.</translation>
    </message>
    <message>
        <source>Bolster opens projects and designs (%1), frames (%2), scans (%3), patterns (%4) and pictures of fabrics (%5). Save it in one of these formats with the program it comes from.</source>
        <translation>Bolster öffnet Projekte und Entwürfe (%1), Gestelle (%2), Scans (%3), Schnitte (%4) und Bilder von Stoffen (%5). Speichern Sie es mit dem Programm, aus dem es stammt, in einem dieser Formate.</translation>
    </message>
</context>
<context>
    <name>bolster::ElementsModel</name>
    <message>
        <source>Hidden in the 3D view</source>
        <translation>In der 3D-Ansicht ausgeblendet</translation>
    </message>
</context>
<context>
    <name>bolster::ElementsView</name>
    <message>
        <source>Find an element</source>
        <translation>Element suchen</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>By its name, or by a word of its note</source>
        <translation>Nach dem Namen oder einem Wort der Notiz</translation>
    </message>
</context>
<context>
    <name>bolster::ExportFlow</name>
    <message>
        <source>Export pattern</source>
        <translation>Schnitt exportieren</translation>
    </message>
    <message>
        <source>-sewing</source>
        <translation>-naehplan</translation>
    </message>
    <message>
        <source>-pattern</source>
        <translation>-Schnitt</translation>
    </message>
    <message>
        <source>%1 (*.%2)</source>
        <translation>%1 (*.%2)</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>%1 wird geschrieben …</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Exportiert nach %1</translation>
    </message>
    <message>
        <source>The pattern could not be exported.</source>
        <translation>Der Schnitt konnte nicht exportiert werden.</translation>
    </message>
    <message>
        <source>Export cover</source>
        <translation>Bezug exportieren</translation>
    </message>
    <message>
        <source>-cover</source>
        <translation>-Bezug</translation>
    </message>
    <message>
        <source>Export foam</source>
        <translation>Schaumkörper exportieren</translation>
    </message>
    <message>
        <source>-foam</source>
        <translation>-Schaum</translation>
    </message>
    <message>
        <source>Exporting %1 …</source>
        <translation>%1 wird exportiert …</translation>
    </message>
    <message>
        <source>The cover could not be exported.</source>
        <translation>Der Bezug konnte nicht exportiert werden.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is written.</source>
        <translation>„%1“ ist geschrieben.</translation>
    </message>
    <message>
        <source>Export surface</source>
        <translation>Oberfläche exportieren</translation>
    </message>
    <message>
        <source>The surface could not be exported.</source>
        <translation>Die Oberfläche ließ sich nicht exportieren.</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>The picture could not be exported.</source>
        <translation>Das Bild ließ sich nicht exportieren.</translation>
    </message>
    <message>
        <source>-surface</source>
        <translation>-Fläche</translation>
    </message>
</context>
<context>
    <name>bolster::ExportPatternDialog</name>
    <message>
        <source>Export pattern</source>
        <translation>Schnitt exportieren</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>&amp;Export …</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>PDF – to print and put together</source>
        <translation>PDF – zum Drucken und Zusammensetzen</translation>
    </message>
    <message>
        <source>DXF AAMA – for cutters</source>
        <translation>DXF AAMA – für Cutter</translation>
    </message>
    <message>
        <source>DXF ASTM – for cutters</source>
        <translation>DXF ASTM – für Cutter</translation>
    </message>
    <message>
        <source>DXF, plain lines</source>
        <translation>DXF, einfache Linien</translation>
    </message>
    <message>
        <source>SVG – 1:1</source>
        <translation>SVG – 1:1</translation>
    </message>
    <message>
        <source>HPGL – for plotters</source>
        <translation>HPGL – für Plotter</translation>
    </message>
    <message>
        <source>Roll, %1 mm wide</source>
        <translation>Rolle, %1 mm breit</translation>
    </message>
    <message>
        <source>&amp;Landscape</source>
        <translation>&amp;Querformat</translation>
    </message>
    <message>
        <source>Mirrored pairs as &amp;two pieces</source>
        <translation>Gespiegelte Paare als z&amp;wei Teile</translation>
    </message>
    <message>
        <source>The design says it; it is changed in its properties.</source>
        <translation>Der Entwurf sagt es; es wird in seinen Eigenschaften geändert.</translation>
    </message>
    <message>
        <source>Of patches and edges that have none of their own.</source>
        <translation>Von Teilen und Kanten ohne eigene.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>&amp;Paper</source>
        <translation>&amp;Papier</translation>
    </message>
    <message>
        <source>Seam &amp;allowance</source>
        <translation>Naht&amp;zugabe</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Sewing li&amp;nes</source>
        <translation>&amp;Nahtlinien</translation>
    </message>
    <message>
        <source>Notc&amp;hes</source>
        <translation>&amp;Knipse</translation>
    </message>
    <message>
        <source>&amp;Grain lines</source>
        <translation>Fa&amp;denläufe</translation>
    </message>
    <message>
        <source>La&amp;bels</source>
        <translation>&amp;Beschriftungen</translation>
    </message>
    <message>
        <source>&amp;Internal lines</source>
        <translation>Innen&amp;linien</translation>
    </message>
    <message>
        <source>&amp;Drill holes</source>
        <translation>Bohrlö&amp;cher</translation>
    </message>
    <message numerus="yes">
        <source>%n pages</source>
        <translation>
            <numerusform>%n Seite</numerusform>
            <numerusform>%n Seiten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n patches are left out: their outlines cross themselves</source>
        <translation>
            <numerusform>%n Teil wird weggelassen: sein Umriss kreuzt sich</numerusform>
            <numerusform>%n Teile werden weggelassen: ihre Umrisse kreuzen sich</numerusform>
        </translation>
    </message>
    <message>
        <source>C&amp;ut lines</source>
        <translation>Schnittl&amp;inien</translation>
    </message>
    <message>
        <source>Sewing sheet (PDF)</source>
        <translation>Nähplan (PDF)</translation>
    </message>
    <message>
        <source>DXF, plain curves (R2000)</source>
        <translation>DXF, einfache Kurven (R2000)</translation>
    </message>
    <message>
        <source>too many sheets: is its unit right?</source>
        <translation>zu viele Blätter: stimmt die Einheit?</translation>
    </message>
    <message>
        <source>the first %1 are shown</source>
        <translation>die ersten %1 sind zu sehen</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>Es gibt nichts zu schneiden.</translation>
    </message>
    <message>
        <source>A double click leaves this window and shows where it is; the whole list is in the panel &quot;Check before cutting&quot;.</source>
        <translation>Ein Doppelklick verlässt dieses Fenster und zeigt, wo es ist; die ganze Liste steht im Bereich „Prüfen vor dem Zuschneiden“.</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces on %1</source>
        <translation>
            <numerusform>%n Teil auf %1</numerusform>
            <numerusform>%n Teile auf %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FabricCommands</name>
    <message>
        <source>Rename fabric</source>
        <translation>Stoff umbenennen</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
    <message>
        <source>Delete fabric</source>
        <translation>Stoff löschen</translation>
    </message>
    <message numerus="yes">
        <source>%n patches have &quot;%1&quot;. What shall they get instead?</source>
        <translation>
            <numerusform>%n Schnittteil hat „%1“. Was soll es stattdessen bekommen?</numerusform>
            <numerusform>%n Schnittteile haben „%1“. Was sollen sie stattdessen bekommen?</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the patches that shall get the fabric, then choose it in the library.</source>
        <translation>Wählen Sie die Schnittteile, die den Stoff bekommen sollen, dann den Stoff in der Sammlung.</translation>
    </message>
    <message>
        <source>New colourway</source>
        <translation>Neue Farbvariante</translation>
    </message>
    <message>
        <source>Name of the colourway; it begins as what is shown now:</source>
        <translation>Name der Farbvariante; sie beginnt mit dem, was jetzt zu sehen ist:</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>Farbvariante</translation>
    </message>
    <message>
        <source>Rename colourway</source>
        <translation>Farbvariante umbenennen</translation>
    </message>
    <message>
        <source>Picture of a fabric</source>
        <translation>Bild eines Stoffs</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>The picture could not be read.</source>
        <translation>Das Bild konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The picture could not be taken into the design.</source>
        <translation>Das Bild konnte nicht in den Entwurf übernommen werden.</translation>
    </message>
    <message>
        <source>Import fabrics</source>
        <translation>Stoffe importieren</translation>
    </message>
    <message>
        <source>Fabrics, designs and projects (*.json *.bolster)</source>
        <translation>Stoffe, Entwürfe und Projekte (*.json *.bolster)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be read.</source>
        <translation>„%1“ konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Nothing was imported.</source>
        <translation>Es wurde nichts importiert.</translation>
    </message>
    <message numerus="yes">
        <source>%n fabrics imported from %1</source>
        <translation>
            <numerusform>%n Stoff aus %1 importiert</numerusform>
            <numerusform>%n Stoffe aus %1 importiert</numerusform>
        </translation>
    </message>
    <message>
        <source>Export fabric</source>
        <translation>Stoff exportieren</translation>
    </message>
    <message>
        <source>Fabrics (*.json)</source>
        <translation>Stoffe (*.json)</translation>
    </message>
    <message>
        <source>The fabric could not be exported.</source>
        <translation>Der Stoff konnte nicht exportiert werden.</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Nach %1 exportiert</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not deleted.</source>
        <translation>„%1“ wird nicht gelöscht.</translation>
    </message>
    <message>
        <source>It is the only fabric, and patches are made of it. Add another one first.</source>
        <translation>Es ist der einzige Stoff, und Schnittteile bestehen daraus. Bitte zuerst einen anderen hinzufügen.</translation>
    </message>
</context>
<context>
    <name>bolster::FabricPanel</name>
    <message>
        <source>Colourways</source>
        <translation>Farbvarianten</translation>
    </message>
    <message>
        <source>A click shows the cover in this colourway</source>
        <translation>Ein Klick zeigt den Bezug in dieser Farbvariante</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Stoffe</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>Farbvariante</translation>
    </message>
    <message>
        <source>New …</source>
        <translation>Neu …</translation>
    </message>
    <message>
        <source>Rename …</source>
        <translation>Umbenennen …</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Fabrics: drag them onto patches</source>
        <translation>Stoffe: auf Schnittteile ziehen</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Zuweisen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Delete …</source>
        <translation>Löschen …</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>Wie gefertigt</translation>
    </message>
    <message>
        <source>No patch has it.</source>
        <translation>Kein Schnittteil hat ihn.</translation>
    </message>
    <message numerus="yes">
        <source>%n patches have it.</source>
        <translation>
            <numerusform>%n Schnittteil hat ihn.</numerusform>
            <numerusform>%n Schnittteile haben ihn.</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag it onto a patch; a double click shows its properties.</source>
        <translation>Auf ein Schnittteil ziehen; ein Doppelklick zeigt seine Eigenschaften.</translation>
    </message>
    <message>
        <source>Adds this fabric to the library of the design</source>
        <translation>Fügt der Sammlung des Entwurfs diesen Stoff hinzu</translation>
    </message>
</context>
<context>
    <name>bolster::FieldText</name>
    <message>
        <source>usual</source>
        <translation>wie üblich</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>turned by %1</source>
        <translation>um %1 gedreht</translation>
    </message>
    <message>
        <source>%1, from %2 to %3</source>
        <translation>%1, von %2 bis %3</translation>
    </message>
    <message numerus="yes">
        <source>%n points, %1</source>
        <translation>
            <numerusform>%n Punkt, %1</numerusform>
            <numerusform>%n Punkte, %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FileChoice</name>
    <message>
        <source>A file …</source>
        <translation>Eine Datei …</translation>
    </message>
</context>
<context>
    <name>bolster::FileImportDialog</name>
    <message>
        <source> mm per unit</source>
        <translation> mm je Einheit</translation>
    </message>
    <message>
        <source>Import scan</source>
        <translation>Scan importieren</translation>
    </message>
    <message>
        <source>Import frame</source>
        <translation>Gestell importieren</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Another factor</source>
        <translation>Anderer Faktor</translation>
    </message>
    <message>
        <source>z points up</source>
        <translation>z zeigt nach oben</translation>
    </message>
    <message>
        <source>y points up</source>
        <translation>y zeigt nach oben</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 Punkte</translation>
    </message>
    <message>
        <source>Width, depth, height</source>
        <translation>Breite, Tiefe, Höhe</translation>
    </message>
    <message>
        <source>That is unusual for a piece of furniture: check the unit.</source>
        <translation>Das ist ungewöhnlich für ein Möbelstück: prüfen Sie die Einheit.</translation>
    </message>
    <message>
        <source>&amp;Keep scale, position and rotation</source>
        <translation>&amp;Maßstab, Lage und Drehung behalten</translation>
    </message>
    <message>
        <source>&amp;Place it on the floor, in the middle</source>
        <translation>In die Mitte auf den &amp;Boden stellen</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>&amp;Einheit der Datei</translation>
    </message>
    <message>
        <source>&amp;Factor</source>
        <translation>&amp;Faktor</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>A&amp;chsen</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importieren</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>It would be %1 large. Import it like that?</source>
        <translation>Es wäre %1 groß. So importieren?</translation>
    </message>
    <message>
        <source>Another unit or factor makes it as large as it is meant.</source>
        <translation>Mit einer anderen Einheit oder einem anderen Faktor wird es so groß wie gemeint.</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>x points up</source>
        <translation>x zeigt nach oben</translation>
    </message>
    <message>
        <source>The file says its unit and its axes.</source>
        <translation>Einheit und Achsen stehen in der Datei.</translation>
    </message>
    <message numerus="yes">
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points, %Ln triangles</source>
        <translation>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 Punkte, %Ln Dreieck</numerusform>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 Punkte, %Ln Dreiecke</numerusform>
        </translation>
    </message>
    <message>
        <source>The file says its unit; the axes are guessed.</source>
        <translation>Die Datei nennt ihre Einheit; die Achsen sind geraten.</translation>
    </message>
    <message>
        <source>The file says its axes; the unit is guessed.</source>
        <translation>Die Datei nennt ihre Achsen; die Einheit ist geraten.</translation>
    </message>
    <message>
        <source>Unit and axes are guessed: look at the picture and the size.</source>
        <translation>Einheit und Achsen sind geraten: Sehen Sie auf Bild und Größe.</translation>
    </message>
    <message>
        <source>&amp;Keep position and rotation</source>
        <translation>Lage und Drehung &amp;behalten</translation>
    </message>
    <message>
        <source>The file has %1 points. That is more than are needed to fit a cover, so they were thinned out to one every %2.</source>
        <translation>Die Datei hat %1 Punkte. Das sind mehr, als zum Anpassen eines Bezugs nötig sind; sie wurden deshalb auf einen je %2 ausgedünnt.</translation>
    </message>
    <message>
        <source>It was %1 large and becomes %2: check the unit.</source>
        <translation>Es war %1 groß und wird %2: Prüfen Sie die Einheit.</translation>
    </message>
    <message>
        <source>The unit is guessed: look at the size.</source>
        <translation>Die Einheit ist geraten: Sehen Sie auf die Größe.</translation>
    </message>
    <message>
        <source>The axes are guessed: look at the picture.</source>
        <translation>Die Achsen sind geraten: Sehen Sie auf das Bild.</translation>
    </message>
</context>
<context>
    <name>bolster::FileTalk</name>
    <message>
        <source>&quot;%1&quot; is not replaced.</source>
        <translation>„%1“ wird nicht ersetzt.</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 wird gelesen …</translation>
    </message>
</context>
<context>
    <name>bolster::FitOrderPanel</name>
    <message>
        <source>Goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>The cover &amp;lies on</source>
        <translation>Der Bezug &amp;liegt auf</translation>
    </message>
    <message>
        <source>The form that the cover shall lie on</source>
        <translation>Die Form, auf der der Bezug liegen soll</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>&amp;Strain is at most</source>
        <translation>Die &amp;Dehnung ist höchstens</translation>
    </message>
    <message>
        <source>Along the grain, across it, and in shear; the cover stays where it is</source>
        <translation>Längs und quer zum Fadenlauf und als Scherung; der Bezug bleibt, wo er ist</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Limit of strain</source>
        <translation>Dehnungsgrenze</translation>
    </message>
    <message>
        <source>&amp;No folds in selected patches</source>
        <translation>&amp;Keine Falten in ausgewählten Schnittteilen</translation>
    </message>
    <message>
        <source>No cloth of them is pressed together; none selected: all</source>
        <translation>Ihr Stoff ist nirgends gestaucht; keine ausgewählt: alle</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>The selected seam r&amp;uns along</source>
        <translation>Die ausgewählte Naht läuft &amp;entlang</translation>
    </message>
    <message>
        <source>A curve drawn on the frame or the form; it need hold nothing</source>
        <translation>Eine Kurve auf dem Gestell oder der Form; sie muss nichts halten</translation>
    </message>
    <message>
        <source>Share of the area</source>
        <translation>Anteil der Fläche</translation>
    </message>
    <message>
        <source>Area of selected patches &amp;becomes</source>
        <translation>Ausgewählte Schnittteile &amp;behalten von ihrer Fläche</translation>
    </message>
    <message>
        <source>Less than 100 %: they become smaller</source>
        <translation>Weniger als 100 %: Sie werden kleiner</translation>
    </message>
    <message>
        <source>What may change</source>
        <translation>Was sich ändern darf</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>&amp;Umrisse</translation>
    </message>
    <message>
        <source>Control points of the patches</source>
        <translation>Kontrollpunkte der Schnittteile</translation>
    </message>
    <message>
        <source>Ends of seams</source>
        <translation>Nahtenden</translation>
    </message>
    <message>
        <source>Where seams and fixations end on smooth edges</source>
        <translation>Wo Nähte und Befestigungen auf glatten Kanten enden</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Mehrweite</translation>
    </message>
    <message>
        <source>Sides of seams may come to differ in length; that is then the ease wanted</source>
        <translation>Die Seiten von Nähten dürfen verschieden lang werden; das ist dann die gewünschte Mehrweite</translation>
    </message>
    <message>
        <source>Fo&amp;am</source>
        <translation>Sch&amp;aum</translation>
    </message>
    <message>
        <source>How thick cushions and foam are, by whole voxels</source>
        <translation>Wie dick Polster und Schaum sind, in ganzen Voxeln</translation>
    </message>
    <message>
        <source>F&amp;ixations</source>
        <translation>F&amp;ixierungen</translation>
    </message>
    <message>
        <source>Where fixation curves lie: on their frames, or in space where there is none</source>
        <translation>Wo Fixierkurven liegen: auf ihren Gestellen, oder im Raum, wo keines ist</translation>
    </message>
    <message>
        <source>&amp;Pressure</source>
        <translation>&amp;Druck</translation>
    </message>
    <message>
        <source>The pressure under each patch</source>
        <translation>Der Druck unter jedem Schnittteil</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Dehnbarkeit</translation>
    </message>
    <message>
        <source>Stiffness of the fabrics, and how much they contract across a pull</source>
        <translation>Steifigkeit der Stoffe, und wie sehr sie sich quer zum Zug zusammenziehen</translation>
    </message>
    <message>
        <source>Of sele&amp;cted patches only</source>
        <translation>Nur der ausgewä&amp;hlten Schnittteile</translation>
    </message>
    <message>
        <source>What stays</source>
        <translation>Was bleibt</translation>
    </message>
    <message>
        <source>L&amp;engths of seams</source>
        <translation>L&amp;ängen der Nähte</translation>
    </message>
    <message>
        <source>The sides of a seam keep their difference; if it is far from the seam&apos;s ease, it comes nearer to it</source>
        <translation>Die Seiten einer Naht behalten ihren Unterschied; ist er weit von der Mehrweite der Naht entfernt, so nähert er sich ihr</translation>
    </message>
    <message>
        <source>St&amp;raight edges</source>
        <translation>&amp;Gerade Kanten</translation>
    </message>
    <message>
        <source>An&amp;gles of corners</source>
        <translation>&amp;Winkel der Ecken</translation>
    </message>
    <message>
        <source>No point &amp;moves farther than</source>
        <translation>Kein Punkt wandert &amp;weiter als</translation>
    </message>
    <message>
        <source>Choose the scan or the file that the cover shall lie on.</source>
        <translation>Wählen Sie den Scan oder die Datei, auf denen der Bezug liegen soll.</translation>
    </message>
    <message>
        <source>Select the seam that shall run along the curve.</source>
        <translation>Wählen Sie die Naht aus, die entlang der Kurve laufen soll.</translation>
    </message>
    <message>
        <source>Paint the area in the 3D view, or untick it.</source>
        <translation>Malen Sie den Bereich in der 3D-Ansicht, oder nehmen Sie das Häkchen weg.</translation>
    </message>
    <message>
        <source>Select the patches that shall become larger or smaller.</source>
        <translation>Wählen Sie die Schnittteile aus, die größer oder kleiner werden sollen.</translation>
    </message>
    <message>
        <source>Choose a goal.</source>
        <translation>Wählen Sie ein Ziel.</translation>
    </message>
    <message>
        <source>Edges that look straight stay so: those that bow by less than %1 in %2</source>
        <translation>Kanten, die gerade aussehen, bleiben es: solche, die sich auf %2 um weniger als %1 wölben</translation>
    </message>
</context>
<context>
    <name>bolster::FlatPiecesView</name>
    <message>
        <source>Pieces laid flat</source>
        <translation>Flach gelegte Teile</translation>
    </message>
    <message>
        <source>Strain: %1</source>
        <translation>Dehnung: %1</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 und mehr</translation>
    </message>
    <message>
        <source>%1: strain %2 (rms)</source>
        <translation>%1: Dehnung %2 (Effektivwert)</translation>
    </message>
</context>
<context>
    <name>bolster::FormChoice</name>
    <message>
        <source>Meshes and scans (%1);;All files (*)</source>
        <translation>Netze und Scans (%1);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>bolster::FormPatternWindow</name>
    <message>
        <source>&amp;Make the pattern</source>
        <translation>Schnitt &amp;machen</translation>
    </message>
    <message>
        <source>Laying it flat …</source>
        <translation>Wird flach gelegt …</translation>
    </message>
    <message>
        <source>&amp;Make it without what is left out</source>
        <translation>Ohne das Weggelassene &amp;machen</translation>
    </message>
    <message>
        <source>Laying a form flat …</source>
        <translation>Eine Form wird abgewickelt …</translation>
    </message>
    <message>
        <source>What came of it</source>
        <translation>Was daraus wurde</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>Choose a file with a form above, or import a frame first.</source>
        <translation>Wählen Sie oben eine Datei mit einer Form, oder importieren Sie zuerst ein Gestell.</translation>
    </message>
    <message>
        <source>It is laid flat again when you let go.</source>
        <translation>Sie wird wieder flach gelegt, wenn Sie loslassen.</translation>
    </message>
    <message numerus="yes">
        <source>Dividing it, %n pieces so far …</source>
        <translation>
            <numerusform>Wird geteilt, bisher %n Teil …</numerusform>
            <numerusform>Wird geteilt, bisher %n Teile …</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Lay it flat</source>
        <translation>&amp;Flach legen</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>Es wurde angehalten.</translation>
    </message>
    <message>
        <source>It was stopped. These are the pieces from before.</source>
        <translation>Es wurde angehalten. Das sind die Teile von zuvor.</translation>
    </message>
    <message>
        <source>From a form</source>
        <translation>Aus einer Form</translation>
    </message>
</context>
<context>
    <name>bolster::FormWishesPanel</name>
    <message>
        <source>The form to be covered</source>
        <translation>Die Form, die bezogen werden soll</translation>
    </message>
    <message>
        <source>Meshes and CAD files (%1);;All files (*)</source>
        <translation>Netze und CAD-Dateien (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Where the grain line runs on the form</source>
        <translation>Wohin der Fadenlauf auf der Form zeigt</translation>
    </message>
    <message>
        <source>upwards</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>to the back</source>
        <translation>nach hinten</translation>
    </message>
    <message>
        <source>sideways</source>
        <translation>zur Seite</translation>
    </message>
    <message>
        <source>&amp;Form</source>
        <translation>&amp;Form</translation>
    </message>
    <message>
        <source>Fa&amp;bric</source>
        <translation>&amp;Stoff</translation>
    </message>
    <message>
        <source>&amp;Grain runs</source>
        <translation>Faden&amp;lauf</translation>
    </message>
    <message>
        <source>It is cut</source>
        <translation>Geschnitten wird</translation>
    </message>
    <message>
        <source>and along the ticked lines:</source>
        <translation>und entlang der angehakten Linien:</translation>
    </message>
    <message>
        <source>where its &amp;parts meet</source>
        <translation>wo ihre &amp;Gruppen aneinanderstoßen</translation>
    </message>
    <message>
        <source>at the edges of its &amp;CAD faces</source>
        <translation>an den Kanten ihrer &amp;CAD-Flächen</translation>
    </message>
    <message>
        <source>Each face as the CAD program has it, also where two go on smoothly in each other</source>
        <translation>Jede Fläche so, wie das CAD-Programm sie hat, auch wo zwei glatt ineinander übergehen</translation>
    </message>
    <message>
        <source>where it &amp;bends by more than</source>
        <translation>wo sie sich stärker &amp;biegt als</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>where it would &amp;not lie flat</source>
        <translation>wo sie &amp;nicht flach läge</translation>
    </message>
    <message>
        <source>Pieces that would lie over themselves, or be strained by more than the fabric may be, are divided where they bend most or are narrow; an armchair takes some seconds</source>
        <translation>Teile, die über sich selbst lägen oder stärker gedehnt würden, als der Stoff darf, werden geteilt, wo sie sich am meisten biegen oder schmal sind; ein Sessel braucht einige Sekunden</translation>
    </message>
    <message>
        <source>Keep its cover &amp;outside of the frame</source>
        <translation>Ihren Bezug &amp;außerhalb des Gestells halten</translation>
    </message>
    <message>
        <source>Making the pattern ticks &quot;Keeps the cover outside&quot; at the frame. A cover that is held along its seams alone may sink into the frame or turn inside out.</source>
        <translation>Beim Erstellen des Schnitts wird beim Gestell „Hält den Bezug außerhalb“ angehakt. Ein Bezug, der nur an seinen Nähten gehalten ist, kann in das Gestell sinken oder sich nach innen stülpen.</translation>
    </message>
    <message>
        <source>Patches that this form became before go, with their seams and the curves that hold nothing else. One Undo brings them back.</source>
        <translation>Was aus dieser Form zuvor wurde, geht, mit seinen Nähten und den Kurven, die nichts anderes halten. Einmal Rückgängig bringt es zurück.</translation>
    </message>
    <message>
        <source>The cover as it is</source>
        <translation>Der Bezug, wie er ist</translation>
    </message>
    <message>
        <source>Choose a form</source>
        <translation>Form wählen</translation>
    </message>
    <message>
        <source>New fabric</source>
        <translation>Neuer Stoff</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Stoff</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Replace the %n patches of these names</source>
        <translation>
            <numerusform>Das %n Schnittteil dieses Namens e&amp;rsetzen</numerusform>
            <numerusform>Die %n Schnittteile dieser Namen e&amp;rsetzen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>(%n curves that hold them will hold nothing)</source>
        <translation>
            <numerusform>(%n Kurve, die sie hält, hält dann nichts mehr)</numerusform>
            <numerusform>(%n Kurven, die sie halten, halten dann nichts mehr)</numerusform>
        </translation>
    </message>
    <message>
        <source>They end inside a piece (marked in the 3D view) and do not divide it: each goes on to the border or line that is nearest, along the way shown there</source>
        <translation>Sie enden in einem Teil (in der 3D-Ansicht markiert) und teilen es nicht: Jede geht auf dem Weg, der dort zu sehen ist, zum nächsten Rand oder zur nächsten Linie weiter</translation>
    </message>
    <message numerus="yes">
        <source>Lead %n open ends &amp;on</source>
        <translation>
            <numerusform>%n offenes Ende weiter&amp;führen</numerusform>
            <numerusform>%n offene Enden weiter&amp;führen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FoundPiecesView</name>
    <message>
        <source>Pieces in the file</source>
        <translation>Teile in der Datei</translation>
    </message>
    <message>
        <source>There is no piece in it.</source>
        <translation>Es ist kein Teil darin.</translation>
    </message>
    <message>
        <source>Reading …</source>
        <translation>Wird gelesen …</translation>
    </message>
</context>
<context>
    <name>bolster::GlCanvas</name>
    <message>
        <source>No OpenGL: drawn in software</source>
        <translation>Kein OpenGL: in Software gezeichnet</translation>
    </message>
    <message>
        <source>OpenGL is older than 3.3: drawn in software</source>
        <translation>OpenGL ist älter als 3.3: in Software gezeichnet</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryModel</name>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryPanel</name>
    <message>
        <source>Find a change or a version</source>
        <translation>Änderung oder Version suchen</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryView</name>
    <message>
        <source>&amp;Go to this version</source>
        <translation>&amp;Zu dieser Version</translation>
    </message>
    <message>
        <source>&amp;Name this version …</source>
        <translation>Diese Version &amp;benennen …</translation>
    </message>
    <message>
        <source>&amp;Remove its name</source>
        <translation>Namen &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Compare with now …</source>
        <translation>Mit jetzt &amp;vergleichen …</translation>
    </message>
    <message>
        <source>Name of this branch</source>
        <translation>Name dieses Zweigs</translation>
    </message>
    <message>
        <source>Name of this version</source>
        <translation>Name dieser Version</translation>
    </message>
    <message>
        <source>Name this &amp;branch …</source>
        <translation>Diesen &amp;Zweig benennen …</translation>
    </message>
</context>
<context>
    <name>bolster::ImportFlow</name>
    <message>
        <source>Frames (%1)</source>
        <translation>Gestelle (%1)</translation>
    </message>
    <message>
        <source>Scans (%1)</source>
        <translation>Scans (%1)</translation>
    </message>
    <message>
        <source>Import frame</source>
        <translation>Gestell importieren</translation>
    </message>
    <message>
        <source>Import scan</source>
        <translation>Scan importieren</translation>
    </message>
    <message>
        <source>Import pattern</source>
        <translation>Schnitt importieren</translation>
    </message>
    <message>
        <source>Patterns (%1)</source>
        <translation>Schnitte (%1)</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>Eine andere Datei wählen</translation>
    </message>
    <message>
        <source>The pattern is imported. What is otherwise than in the file:</source>
        <translation>Der Schnitt ist importiert. Was anders ist als in der Datei:</translation>
    </message>
    <message>
        <source>Simplifying %1 …</source>
        <translation>%1 wird vereinfacht …</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>%1 wird geschrieben …</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be imported.</source>
        <translation>„%1“ ließ sich nicht importieren.</translation>
    </message>
</context>
<context>
    <name>bolster::ImportPatternDialog</name>
    <message>
        <source>Import pattern</source>
        <translation>Schnitt importieren</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importieren</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Sewing lines, with allowances</source>
        <translation>Nahtlinien, mit Zugaben</translation>
    </message>
    <message>
        <source>Cut lines, without allowance</source>
        <translation>Schnittlinien, ohne Zugabe</translation>
    </message>
    <message>
        <source>What the outlines of patches become where the file has both lines.</source>
        <translation>Was zum Umriss der Schnittteile wird, wo die Datei beide Linien hat.</translation>
    </message>
    <message>
        <source>Outlines whose ends are no farther apart are closed by a straight line.</source>
        <translation>Umrisse, deren Enden nicht weiter auseinander liegen, werden durch eine gerade Linie geschlossen.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>&amp;Einheit der Datei</translation>
    </message>
    <message>
        <source>Largest piece</source>
        <translation>Größtes Teil</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>&amp;Umrisse</translation>
    </message>
    <message>
        <source>&amp;Close gaps up to</source>
        <translation>&amp;Lücken schließen bis</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>, %n pairs</source>
        <translation>
            <numerusform>, %n Paar</numerusform>
            <numerusform>, %n Paare</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n times</source>
        <translation>
            <numerusform>, %n-mal</numerusform>
            <numerusform>, %n-mal</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines lay twice on themselves and are taken once.</source>
        <translation>
            <numerusform>%n Linie lag doppelt und wird einmal genommen.</numerusform>
            <numerusform>%n Linien lagen doppelt und werden einmal genommen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not read: %1</source>
        <translation>Nicht gelesen: %1</translation>
    </message>
    <message>
        <source>The file does not say its unit for certain: look at the measures.</source>
        <translation>Die Datei sagt ihre Einheit nicht sicher: Sehen Sie sich die Maße an.</translation>
    </message>
    <message>
        <source>Pixels (1/96 inch)</source>
        <translation>Pixel (1/96 Zoll)</translation>
    </message>
    <message>
        <source>Points (1/72 inch)</source>
        <translation>Punkte (1/72 Zoll)</translation>
    </message>
    <message>
        <source>In no piece and left out, by layer: %1</source>
        <translation>In keinem Teil und weggelassen, nach Ebenen: %1</translation>
    </message>
    <message>
        <source>Marks of grading, stripes or nothing that is known, left out by layer: %1</source>
        <translation>Zeichen für Gradierung, Streifen oder nichts Bekanntes, weggelassen nach Ebenen: %1</translation>
    </message>
    <message>
        <source>%1 has %2 pieces; at most %3 can be imported at once: the first ones are chosen.</source>
        <translation>%1 hat %2 Teile; höchstens %3 können auf einmal importiert werden: die ersten sind gewählt.</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message numerus="yes">
        <source>%n outlines are open: their ends are up to %1 apart. Close gaps up to that, if they are outlines.</source>
        <translation>
            <numerusform>%n Umriss ist offen: Seine Enden liegen bis zu %1 auseinander. Schließen Sie Lücken bis dahin, wenn es ein Umriss ist.</numerusform>
            <numerusform>%n Umrisse sind offen: Ihre Enden liegen bis zu %1 auseinander. Schließen Sie Lücken bis dahin, wenn es Umrisse sind.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::JobsPanel</name>
    <message>
        <source>Nothing is being worked at.</source>
        <translation>Es wird an nichts gearbeitet.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Laufende Arbeiten</translation>
    </message>
</context>
<context>
    <name>bolster::LeftWork</name>
    <message>
        <source>New design</source>
        <translation>Neuer Entwurf</translation>
    </message>
    <message numerus="yes">
        <source>%n more designs are under File &gt; Unsaved work.</source>
        <translation>
            <numerusform>%n weiterer Entwurf liegt unter Datei &gt; Nicht gespeicherte Arbeit.</numerusform>
            <numerusform>%n weitere Entwürfe liegen unter Datei &gt; Nicht gespeicherte Arbeit.</numerusform>
        </translation>
    </message>
    <message>
        <source>Restoring the work on &quot;%1&quot; …</source>
        <translation>Die Arbeit an „%1“ wird wiederhergestellt …</translation>
    </message>
    <message>
        <source>The work stays under File &gt; Unsaved work</source>
        <translation>Die Arbeit bleibt unter Datei &gt; Nicht gespeicherte Arbeit</translation>
    </message>
    <message>
        <source>The unsaved work on &quot;%1&quot; could not be restored.</source>
        <translation>Die nicht gespeicherte Arbeit an „%1“ konnte nicht wiederhergestellt werden.</translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved edits restored.</source>
        <translation>
            <numerusform>%n nicht gespeicherter Schritt wiederhergestellt.</numerusform>
            <numerusform>%n nicht gespeicherte Schritte wiederhergestellt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved edits are in the history, undone or on other branches.</source>
        <translation>
            <numerusform>%n nicht gespeicherter Schritt liegt im Verlauf, rückgängig gemacht oder auf einem anderen Zweig.</numerusform>
            <numerusform>%n nicht gespeicherte Schritte liegen im Verlauf, rückgängig gemacht oder auf anderen Zweigen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Unsaved names of versions or branches restored.</source>
        <translation>Nicht gespeicherte Namen von Versionen oder Zweigen wiederhergestellt.</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>Go &amp;back to saved</source>
        <translation>Z&amp;um Gespeicherten zurück</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, %2, damaged</source>
        <translation>%1, %2, beschädigt</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
</context>
<context>
    <name>bolster::MainWindow</name>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>%1[*] – Bolster</source>
        <translation>%1[*] – Bolster</translation>
    </message>
    <message>
        <source>%1 It is back where it was.</source>
        <translation>%1 Es ist wieder, wo es war.</translation>
    </message>
    <message>
        <source>More commands</source>
        <translation>Weitere Befehle</translation>
    </message>
    <message>
        <source>The cover sprang by %1.</source>
        <translation>Der Bezug ist um %1 gesprungen.</translation>
    </message>
    <message>
        <source>Folded cloth can lie in several ways, and where a drag leaves it depends on the way of the pointer. What you see now follows from the design alone: whoever opens it sees the same, and so do exports and pictures. If you want the other shape, tell the design: hold the cloth there with a handle, or make the piece smaller until it needs no folds.</source>
        <translation>Stoff in Falten kann auf mehrere Arten liegen, und wie das Ziehen ihn zurücklässt, hängt vom Weg des Zeigers ab. Was jetzt zu sehen ist, folgt allein aus dem Entwurf: Wer ihn öffnet, sieht dasselbe, und Exporte und Bilder zeigen es auch. Soll es die andere Form sein, muss der Entwurf das sagen: den Stoff dort mit einer Griffkurve halten oder das Schnittteil verkleinern, bis es keine Falten mehr braucht.</translation>
    </message>
    <message>
        <source>%1[*] (read-only) – Bolster</source>
        <translation>%1[*] (schreibgeschützt) – Bolster</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces are in the pattern. Seam &gt; Propose seams finds what belongs together.</source>
        <translation>
            <numerusform>%n Teil ist im Schnitt. Naht &gt; Nähte vorschlagen findet, was zusammengehört.</numerusform>
            <numerusform>%n Teile sind im Schnitt. Naht &gt; Nähte vorschlagen findet, was zusammengehört.</numerusform>
        </translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>Bolster is still working at something.</source>
        <translation>Bolster arbeitet noch an etwas.</translation>
    </message>
    <message>
        <source>What is closed now is not finished; files that are being written stay as they were.</source>
        <translation>Was jetzt geschlossen wird, wird nicht fertig; Dateien, die gerade geschrieben werden, bleiben, wie sie waren.</translation>
    </message>
    <message>
        <source>&amp;Stop it and close</source>
        <translation>&amp;Anhalten und schließen</translation>
    </message>
    <message>
        <source>x %1   y %2</source>
        <translation>x %1   y %2</translation>
    </message>
    <message>
        <source>x %1   y %2   z %3</source>
        <translation>x %1   y %2   z %3</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>This change has taken away as well: %1</source>
        <translation>Mit dieser Änderung ist auch entfallen: %1</translation>
    </message>
</context>
<context>
    <name>bolster::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>Zurück (Alt+Links)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation>Vor (Alt+Rechts)</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Find in all pages</source>
        <translation>In allen Seiten suchen</translation>
    </message>
    <message>
        <source>The manual has no page &quot;%1&quot;.</source>
        <translation>Das Handbuch hat keine Seite „%1“.</translation>
    </message>
    <message>
        <source>The manual is in English.</source>
        <translation>Das Handbuch ist auf Englisch.</translation>
    </message>
</context>
<context>
    <name>bolster::MapLegend</name>
    <message>
        <source>over the fabric&apos;s limit</source>
        <translation>über der Grenze des Stoffs</translation>
    </message>
</context>
<context>
    <name>bolster::MapLink</name>
    <message>
        <source>Largest strain</source>
        <translation>Größte Dehnung</translation>
    </message>
    <message>
        <source>Strain along the grain</source>
        <translation>Dehnung längs des Fadenlaufs</translation>
    </message>
    <message>
        <source>Strain across the grain</source>
        <translation>Dehnung quer zum Fadenlauf</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Scherung</translation>
    </message>
    <message>
        <source>Mean curvature</source>
        <translation>Mittlere Krümmung</translation>
    </message>
    <message>
        <source>Distance to the frame</source>
        <translation>Abstand zum Gestell</translation>
    </message>
    <message>
        <source>hollow</source>
        <translation>hohl</translation>
    </message>
    <message>
        <source>bulging</source>
        <translation>gewölbt</translation>
    </message>
    <message>
        <source>pressed</source>
        <translation>gestaucht</translation>
    </message>
    <message>
        <source>stretched</source>
        <translation>gedehnt</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>%1, over the limit of %2</source>
        <translation>%1, über der Grenze von %2</translation>
    </message>
    <message>
        <source>Here: %1</source>
        <translation>Hier: %1</translation>
    </message>
    <message>
        <source>over the fabric&apos;s limit</source>
        <translation>über der Grenze des Stoffs</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>Deviation from the scan</source>
        <translation>Abweichung vom Scan</translation>
    </message>
</context>
<context>
    <name>bolster::MarkTool</name>
    <message>
        <source>Hole %1</source>
        <translation>Loch %1</translation>
    </message>
    <message>
        <source>Click to select it, drag to move it – its properties say what it is like</source>
        <translation>Klicken wählt es aus, ziehen verschiebt es – seine Eigenschaften sagen, wie es ist</translation>
    </message>
    <message>
        <source>Click a corner of an outline to choose how its cut lines are joined – Esc ends the tool</source>
        <translation>Eine Ecke eines Umrisses anklicken, um die Form der Schnittlinie zu wählen – Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no distance from the corner on this edge.</source>
        <translation>„%1“ ist auf dieser Kante kein Abstand von der Ecke.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no place: try 120, 40</source>
        <translation>„%1“ ist keine Stelle: Versuchen Sie 120; 40</translation>
    </message>
    <message>
        <source>Click an outline to place a notch, or type how far it is from the corner; on a seam the other side gets one, too – Esc ends the tool</source>
        <translation>Klick auf einen Umriss setzt einen Knips, oder tippen Sie, wie weit er von der Ecke ist; auf einer Naht bekommt auch die andere Seite einen – Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>Click inside a patch to place a drill hole, or type where: 120, 40 – Esc ends the tool</source>
        <translation>Klick in ein Schnittteil setzt ein Bohrloch, oder tippen Sie, wo: 120; 40 – Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no width of an allowance: try 12</source>
        <translation>„%1“ ist keine Breite einer Zugabe: zum Beispiel 12</translation>
    </message>
    <message>
        <source>Drag its handle, or type its width – its properties say what it is like</source>
        <translation>Am Griff ziehen oder die Breite eintippen – die Eigenschaften sagen, wie sie ist</translation>
    </message>
    <message>
        <source>Click an edge to give it a seam allowance of its own, or type its width; drag its handle – Esc ends the tool</source>
        <translation>Eine Kante anklicken, um ihr eine eigene Nahtzugabe zu geben, oder die Breite eintippen; am Griff ziehen – Esc beendet das Werkzeug</translation>
    </message>
    <message>
        <source>Point at an outline, then type how far the notch is from the corner</source>
        <translation>Auf einen Umriss zeigen, dann eintippen, wie weit der Knips von der Ecke entfernt ist</translation>
    </message>
    <message>
        <source>Point into a patch, then type where the drill hole lies: 120, 40</source>
        <translation>In ein Schnittteil zeigen, dann eintippen, wo das Bohrloch liegt: 120, 40</translation>
    </message>
    <message>
        <source>Point at an edge, then type how wide its allowance is</source>
        <translation>Auf eine Kante zeigen, dann eintippen, wie breit ihre Nahtzugabe ist</translation>
    </message>
</context>
<context>
    <name>bolster::NextStep</name>
    <message>
        <source>Next: %1 for the other side.</source>
        <translation>Als Nächstes: %1 für die andere Seite.</translation>
    </message>
    <message>
        <source>draw a second patch</source>
        <translation>ein zweites Schnittteil zeichnen</translation>
    </message>
    <message>
        <source>Next: %1 – click an edge, then the edge it is sewn to.</source>
        <translation>Als Nächstes: %1 – eine Kante anklicken, dann die Kante, an die sie genäht wird.</translation>
    </message>
    <message>
        <source>sew the patches</source>
        <translation>die Schnittteile nähen</translation>
    </message>
    <message>
        <source>Next: %1 and give them a pressure in the properties.</source>
        <translation>Als Nächstes: %1 und ihnen in den Eigenschaften einen Druck geben.</translation>
    </message>
    <message>
        <source>select all patches</source>
        <translation>alle Schnittteile auswählen</translation>
    </message>
    <message>
        <source>Next: %1 – click points on it, Enter ends – to which the cover is attached.</source>
        <translation>Als Nächstes: %1 – Punkte darauf anklicken, Eingabe beendet –, an der der Bezug befestigt wird.</translation>
    </message>
    <message>
        <source>draw a fixation curve on the frame</source>
        <translation>auf dem Gestell eine Fixierkurve zeichnen</translation>
    </message>
    <message>
        <source>Next: select a fixation curve and %1 to it.</source>
        <translation>Als Nächstes: eine Fixierkurve auswählen und %1.</translation>
    </message>
    <message>
        <source>attach an edge</source>
        <translation>eine Kante daran befestigen</translation>
    </message>
</context>
<context>
    <name>bolster::NumberBox</name>
    <message>
        <source>varies</source>
        <translation>verschieden</translation>
    </message>
    <message>
        <source>Not taken: a number is needed</source>
        <translation>Nicht übernommen: Es wird eine Zahl gebraucht</translation>
    </message>
    <message>
        <source>Not taken: &quot;%1&quot; is not a length</source>
        <translation>Nicht übernommen: „%1“ ist keine Länge</translation>
    </message>
    <message>
        <source>Not taken: &quot;%1&quot; is not a number</source>
        <translation>Nicht übernommen: „%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>Not taken: %1 is too little, at least %2</source>
        <translation>Nicht übernommen: %1 ist zu wenig, mindestens %2</translation>
    </message>
    <message>
        <source>Not taken: %1 is too much, at most %2</source>
        <translation>Nicht übernommen: %1 ist zu viel, höchstens %2</translation>
    </message>
</context>
<context>
    <name>bolster::OpenFlow</name>
    <message>
        <source>Projects and designs (%1)</source>
        <translation>Projekte und Entwürfe (%1)</translation>
    </message>
    <message>
        <source>This is the version where you were last; the one in the file is under File &gt; Revert to saved</source>
        <translation>Das ist die Version, an der zuletzt gearbeitet wurde; zu der in der Datei führt Datei &gt; Auf Gespeichertes zurücksetzen</translation>
    </message>
    <message>
        <source>Open project or design</source>
        <translation>Projekt oder Entwurf öffnen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open in another window.</source>
        <translation>„%1“ ist in einem anderen Fenster geöffnet.</translation>
    </message>
    <message>
        <source>It can be opened here to look at; what is changed is saved under another name.</source>
        <translation>Hier kann es zum Ansehen geöffnet werden; Änderungen werden unter einem anderen Namen gespeichert.</translation>
    </message>
    <message numerus="yes">
        <source>%n elements cannot be used as they are; everything else works.</source>
        <translation>
            <numerusform>%n Element ist so nicht brauchbar; alles andere geht.</numerusform>
            <numerusform>%n Elemente sind so nicht brauchbar; alles andere geht.</numerusform>
        </translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>Liste &amp;leeren</translation>
    </message>
    <message>
        <source>The samples are not installed</source>
        <translation>Die Beispiele sind nicht installiert</translation>
    </message>
</context>
<context>
    <name>bolster::PagesView</name>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
</context>
<context>
    <name>bolster::PartsTree</name>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
</context>
<context>
    <name>bolster::PatternCommands</name>
    <message>
        <source>This stretch is straight already.</source>
        <translation>Dieser Abschnitt ist schon gerade.</translation>
    </message>
    <message>
        <source>They are equally long already.</source>
        <translation>Sie sind schon gleich lang.</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>A&amp;usschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Dupl&amp;icate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>A&amp;nordnen</translation>
    </message>
    <message>
        <source>Turn 90° to the &amp;left</source>
        <translation>Um 90° nach &amp;links drehen</translation>
    </message>
    <message>
        <source>Turn 90° to the &amp;right</source>
        <translation>Um 90° nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>Mirror hori&amp;zontally</source>
        <translation>&amp;Waagrecht spiegeln</translation>
    </message>
    <message>
        <source>Mirror &amp;vertically</source>
        <translation>&amp;Senkrecht spiegeln</translation>
    </message>
    <message>
        <source>Al&amp;ign</source>
        <translation>Aus&amp;richten</translation>
    </message>
    <message>
        <source>&amp;Left edges</source>
        <translation>&amp;Linke Kanten</translation>
    </message>
    <message>
        <source>Centres in a &amp;column</source>
        <translation>&amp;Mitten untereinander</translation>
    </message>
    <message>
        <source>&amp;Right edges</source>
        <translation>&amp;Rechte Kanten</translation>
    </message>
    <message>
        <source>&amp;Top edges</source>
        <translation>&amp;Obere Kanten</translation>
    </message>
    <message>
        <source>Centres in a ro&amp;w</source>
        <translation>M&amp;itten nebeneinander</translation>
    </message>
    <message>
        <source>&amp;Bottom edges</source>
        <translation>&amp;Untere Kanten</translation>
    </message>
    <message>
        <source>&amp;Distribute</source>
        <translation>&amp;Verteilen</translation>
    </message>
    <message>
        <source>&amp;Horizontally</source>
        <translation>&amp;Waagrecht</translation>
    </message>
    <message>
        <source>&amp;Vertically</source>
        <translation>&amp;Senkrecht</translation>
    </message>
    <message>
        <source>Arrange &amp;automatically</source>
        <translation>&amp;Automatisch anordnen</translation>
    </message>
    <message>
        <source>Poin&amp;ts and edges</source>
        <translation>Pun&amp;kte und Kanten</translation>
    </message>
    <message>
        <source>Make &amp;corner</source>
        <translation>&amp;Ecke machen</translation>
    </message>
    <message>
        <source>Make s&amp;mooth</source>
        <translation>&amp;Glatt machen</translation>
    </message>
    <message>
        <source>Strai&amp;ghten</source>
        <translation>Ge&amp;rade machen</translation>
    </message>
    <message>
        <source>Edge &amp;length …</source>
        <translation>&amp;Länge der Kante …</translation>
    </message>
    <message>
        <source>Type the length of the selected edge</source>
        <translation>Die Länge der gewählten Kante eingeben</translation>
    </message>
    <message>
        <source>Make e&amp;qually long</source>
        <translation>Gleich lang &amp;machen</translation>
    </message>
    <message>
        <source>Makes the selected edges as long as the first one, or the second side of a seam as long as its first</source>
        <translation>Macht die gewählten Kanten so lang wie die erste, oder die zweite Seite einer Naht so lang wie ihre erste</translation>
    </message>
    <message>
        <source>Mirror twi&amp;ns</source>
        <translation>Spiegel&amp;zwillinge</translation>
    </message>
    <message>
        <source>Merge a&amp;long seam</source>
        <translation>Entlang der Naht ver&amp;einen</translation>
    </message>
    <message>
        <source>Smooth &amp;across seam ends</source>
        <translation>Über Nahtenden gl&amp;ätten</translation>
    </message>
    <message>
        <source>Outlines go on without a kink from one patch to the other where the selected seams end, when both sides lie together</source>
        <translation>Wo die ausgewählten Nähte enden, gehen die Umrisse ohne Knick von einem Schnittteil ins andere über, wenn beide Seiten beieinanderliegen</translation>
    </message>
    <message>
        <source>They go on without a kink already.</source>
        <translation>Sie gehen schon ohne Knick ineinander über.</translation>
    </message>
</context>
<context>
    <name>bolster::PatternFitWindow</name>
    <message>
        <source>&amp;Take the changes</source>
        <translation>Änderungen &amp;übernehmen</translation>
    </message>
    <message>
        <source>Changes of</source>
        <translation>Änderungen von</translation>
    </message>
    <message>
        <source>Moves by</source>
        <translation>Wandert um</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>What is ticked is changed</source>
        <translation>Was angehakt ist, wird geändert</translation>
    </message>
    <message>
        <source>&amp;How much of it</source>
        <translation>Wie &amp;viel davon</translation>
    </message>
    <message>
        <source>Solving the cover …</source>
        <translation>Der Bezug wird berechnet …</translation>
    </message>
    <message>
        <source>Stopped; nothing has changed.</source>
        <translation>Angehalten; nichts hat sich geändert.</translation>
    </message>
    <message>
        <source>&amp;Find changes</source>
        <translation>Änderungen &amp;suchen</translation>
    </message>
    <message>
        <source>The cover moves by %1 (rms).</source>
        <translation>Der Bezug wandert um %1 (quadratisches Mittel).</translation>
    </message>
    <message>
        <source>On the way a fold came or went: look at the cover before you take it.</source>
        <translation>Unterwegs ist eine Falte entstanden oder verschwunden: Sehen Sie sich den Bezug an, bevor Sie übernehmen.</translation>
    </message>
    <message numerus="yes">
        <source>%n of the numbers that may change do nothing here.</source>
        <translation>
            <numerusform>%n der Zahlen, die sich ändern dürfen, bewirkt hier nichts.</numerusform>
            <numerusform>%n der Zahlen, die sich ändern dürfen, bewirken hier nichts.</numerusform>
        </translation>
    </message>
    <message>
        <source>Arrows in the pattern: %1 times as long as the way</source>
        <translation>Pfeile im Schnitt: %1-mal so lang wie der Weg</translation>
    </message>
    <message>
        <source>Arrows in the pattern: where its outlines go</source>
        <translation>Pfeile im Schnitt: wohin seine Umrisse wandern</translation>
    </message>
    <message>
        <source>Taken. Undo takes it back.</source>
        <translation>Übernommen. Rückgängig nimmt es zurück.</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: find the changes again.</source>
        <translation>Der Entwurf hat sich inzwischen geändert: Suchen Sie die Änderungen neu.</translation>
    </message>
    <message>
        <source>With all of the changes:</source>
        <translation>Mit allen Änderungen:</translation>
    </message>
    <message>
        <source>Fitting the pattern …</source>
        <translation>Der Schnitt wird angepasst …</translation>
    </message>
    <message>
        <source>Changing the pattern …</source>
        <translation>Der Schnitt wird geändert …</translation>
    </message>
    <message>
        <source>Pressed together: %1 before, %2 now</source>
        <translation>Gestaucht: %1 vorher, %2 jetzt</translation>
    </message>
    <message>
        <source>From the curve: %1 before, %2 now (rms)</source>
        <translation>Von der Kurve entfernt: %1 vorher, %2 jetzt (quadratisches Mittel)</translation>
    </message>
    <message>
        <source>Off the area that is wanted: %1 before, %2 now</source>
        <translation>Neben der gewünschten Fläche: %1 vorher, %2 jetzt</translation>
    </message>
    <message>
        <source>Nothing is over the limits: there is nothing to do.</source>
        <translation>Nichts liegt über den Grenzen: Es gibt nichts zu tun.</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit (before: %2), on few triangles at first</source>
        <translation>%1 des Bezugs liegen über der Grenze (vorher: %2), zuerst auf wenigen Dreiecken</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit (before: %2)</source>
        <translation>%1 des Bezugs liegen über der Grenze (vorher: %2)</translation>
    </message>
    <message>
        <source>With what is shown of the changes the cover cannot be solved.</source>
        <translation>Mit dem, was von den Änderungen gezeigt wird, kann der Bezug nicht berechnet werden.</translation>
    </message>
    <message>
        <source>With what is shown of the changes:</source>
        <translation>Mit dem, was von den Änderungen gezeigt wird:</translation>
    </message>
    <message>
        <source>Nothing of the changes is shown now: move the slider to see them.</source>
        <translation>Von den Änderungen wird jetzt nichts gezeigt: Bewegen Sie den Schieber, um sie zu sehen.</translation>
    </message>
    <message>
        <source>Sides of seams differ by up to %1 more than is wanted: change their neighbours, too, or let the ease change.</source>
        <translation>Seiten von Nähten sind um bis zu %1 stärker verschieden als gewünscht: ändern Sie auch die Nachbarn, oder lassen Sie die Mehrweite zu.</translation>
    </message>
    <message>
        <source>Strained over the limit: %1 of the painted area before, %2 now</source>
        <translation>Über die Grenze gedehnt: vorher %1 der gemalten Fläche, jetzt %2</translation>
    </message>
    <message>
        <source>Strained over the limit: %1 of the cover before, %2 now</source>
        <translation>Über die Grenze gedehnt: vorher %1 des Bezugs, jetzt %2</translation>
    </message>
    <message>
        <source>That is hardly nearer, and strains the cloth more: let something else change, or less of it.</source>
        <translation>Das ist kaum näher und dehnt den Stoff stärker: lassen Sie anderes sich ändern, oder weniger davon.</translation>
    </message>
    <message>
        <source>Stopped. What was found until then makes it no better: nothing has changed.</source>
        <translation>Angehalten. Was bis dahin gefunden wurde, macht es nicht besser: Nichts hat sich geändert.</translation>
    </message>
    <message>
        <source>Stopped. With all of the changes that were found until then, measured anew on all triangles:</source>
        <translation>Angehalten. Mit allen Änderungen, die bis dahin gefunden waren, auf allen Dreiecken neu gemessen:</translation>
    </message>
    <message>
        <source>Sides of seams off their ease: up to %1 before, %2 now</source>
        <translation>Nahtseiten neben ihrer Mehrweite: bis zu %1 vorher, %2 jetzt</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Over the fabrics&apos; limits: %1 of the cover before, %2 now</source>
        <translation>Über den Grenzen der Stoffe: vorher %1 des Bezugs, jetzt %2</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: find the changes again, or undo that.</source>
        <translation>Der Entwurf hat sich inzwischen geändert: Suchen Sie die Änderungen neu, oder machen Sie das rückgängig.</translation>
    </message>
    <message>
        <source>Taken back. Move the slider to see the changes again.</source>
        <translation>Zurückgenommen. Bewegen Sie den Schieber, um die Änderungen wieder zu sehen.</translation>
    </message>
    <message>
        <source>That is hardly nearer to the limit: let something else change, or more of it.</source>
        <translation>Das ist der Grenze kaum näher: Lassen Sie etwas anderes oder mehr davon sich ändern.</translation>
    </message>
    <message>
        <source>%1 from %3 (rms; before: %2), on few triangles at first</source>
        <translation>%1 von %3 (RMS; vorher: %2), zunächst auf wenigen Dreiecken</translation>
    </message>
    <message>
        <source>%1 from %3 (rms; before: %2)</source>
        <translation>%1 von %3 (RMS; vorher: %2)</translation>
    </message>
    <message>
        <source>From %5: %1 before, %2 now (rms); %3 before, %4 now (95 %)</source>
        <translation>Von %5 entfernt: %1 vorher, %2 jetzt (quadratisches Mittel); %3 vorher, %4 jetzt (95 %)</translation>
    </message>
    <message>
        <source>That is hardly nearer to %1: let something else change, or more of it.</source>
        <translation>Das ist %1 kaum näher: Lassen Sie etwas anderes oder mehr davon sich ändern.</translation>
    </message>
    <message>
        <source>Hardly less is pressed together: let something else change, or more of it.</source>
        <translation>Kaum weniger ist gestaucht: Lassen Sie etwas anderes oder mehr davon sich ändern.</translation>
    </message>
    <message>
        <source>That is hardly nearer to the curve: let something else change, or more of it.</source>
        <translation>Das ist der Kurve kaum näher: Lassen Sie etwas anderes oder mehr davon sich ändern.</translation>
    </message>
    <message>
        <source>That is hardly nearer to the area that is wanted: let something else change, or more of it.</source>
        <translation>Das ist der gewünschten Fläche kaum näher: Lassen Sie etwas anderes oder mehr davon sich ändern.</translation>
    </message>
    <message>
        <source>Changes the pattern until the cover is as it is wished: tick one goal or several, and what may change.</source>
        <translation>Ändert den Schnitt, bis der Bezug ist, wie er sein soll: Wählen Sie ein Ziel oder mehrere und was sich ändern darf.</translation>
    </message>
    <message>
        <source>%1 of the painted area is over the limit (before: %2), on few triangles at first</source>
        <translation>%1 der gemalten Fläche liegen über der Grenze (vorher: %2), zuerst auf wenigen Dreiecken</translation>
    </message>
    <message>
        <source>%1 of the painted area is over the limit (before: %2)</source>
        <translation>%1 der gemalten Fläche liegen über der Grenze (vorher: %2)</translation>
    </message>
    <message>
        <source>No change makes it better on all triangles: let something else change, or points move farther.</source>
        <translation>Keine Änderung macht es auf allen Dreiecken besser: Lassen Sie etwas anderes sich ändern oder Punkte weiter wandern.</translation>
    </message>
    <message>
        <source>More of the cloth is strained over its limits: make these a goal, too, or let points move less.</source>
        <translation>Mehr vom Stoff ist über seine Grenzen gedehnt: Machen Sie diese auch zum Ziel oder lassen Sie Punkte weniger wandern.</translation>
    </message>
    <message>
        <source>What is wished</source>
        <translation>Was gewünscht ist</translation>
    </message>
    <message>
        <source>Fit to a goal</source>
        <translation>An ein Ziel anpassen</translation>
    </message>
</context>
<context>
    <name>bolster::PatternRuler</name>
    <message>
        <source>Drag down for a level guide. Marks move upright guides; drag them off to remove them.</source>
        <translation>Nach unten ziehen für eine waagrechte Hilfslinie. Marken verschieben senkrechte Hilfslinien; hinausgezogen verschwinden sie.</translation>
    </message>
    <message>
        <source>Drag to the right for an upright guide. Marks move level guides; drag them off to remove them.</source>
        <translation>Nach rechts ziehen für eine senkrechte Hilfslinie. Marken verschieben waagrechte Hilfslinien; hinausgezogen verschwinden sie.</translation>
    </message>
</context>
<context>
    <name>bolster::PreferencesWindow</name>
    <message>
        <source>Preferences (*.json)</source>
        <translation>Einstellungen (*.json)</translation>
    </message>
    <message>
        <source>No setting has these words.</source>
        <translation>Keine Einstellung hat diese Wörter.</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Find a setting</source>
        <translation>Einstellung suchen</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>&amp;Edit single shortcuts …</source>
        <translation>Einzelne &amp;Tastenkürzel bearbeiten …</translation>
    </message>
    <message>
        <source>Back to &amp;defaults</source>
        <translation>Auf &amp;Vorgaben zurücksetzen</translation>
    </message>
    <message>
        <source>All settings of this page</source>
        <translation>Alle Einstellungen dieser Seite</translation>
    </message>
    <message>
        <source>E&amp;xport …</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>&amp;Import …</source>
        <translation>&amp;Importieren …</translation>
    </message>
    <message>
        <source>Export preferences</source>
        <translation>Einstellungen exportieren</translation>
    </message>
    <message>
        <source>Bolster preferences.json</source>
        <translation>Bolster-Einstellungen.json</translation>
    </message>
    <message>
        <source>Import preferences</source>
        <translation>Einstellungen importieren</translation>
    </message>
    <message>
        <source>The preferences could not be exported.</source>
        <translation>Die Einstellungen konnten nicht exportiert werden.</translation>
    </message>
    <message>
        <source>Nothing was imported from &quot;%1&quot;; all settings are as they were.</source>
        <translation>Aus „%1“ wurde nichts importiert; alle Einstellungen sind, wie sie waren.</translation>
    </message>
    <message>
        <source>The preferences were imported.</source>
        <translation>Die Einstellungen wurden importiert.</translation>
    </message>
    <message numerus="yes">
        <source>This version of Bolster does not know %n of them: %1</source>
        <translation>
            <numerusform>Diese Version von Bolster kennt %n davon nicht: %1</numerusform>
            <numerusform>Diese Version von Bolster kennt %n davon nicht: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Ansicht drehen</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Ansicht verschieben</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>In der 3D-Ansicht</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>Im Schnitt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no folder on this machine: the folder of your fabrics stays what it was.</source>
        <translation>„%1“ ist auf diesem Rechner kein Ordner: der Ordner Ihrer Stoffe bleibt, wie er war.</translation>
    </message>
    <message>
        <source>&amp;Restart now</source>
        <translation>Jetzt &amp;neu starten</translation>
    </message>
    <message>
        <source>Closes Bolster, and asks about unsaved work as always; then it starts again with the same project</source>
        <translation>Schließt Bolster und fragt wie immer nach nicht gespeicherter Arbeit; dann startet es neu mit demselben Projekt</translation>
    </message>
</context>
<context>
    <name>bolster::ProblemsView</name>
    <message>
        <source>F1: what it means, and what to do</source>
        <translation>F1: was das bedeutet und was zu tun ist</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Nothing to worry about.</source>
        <translation>Nichts, worum man sich sorgen müsste.</translation>
    </message>
    <message>
        <source>All elements can be used.</source>
        <translation>Alle Elemente sind brauchbar.</translation>
    </message>
</context>
<context>
    <name>bolster::PullNote</name>
    <message>
        <source>The cover in the 3D view is pulled to a scan; here it counts as the pattern alone makes it.</source>
        <translation>Der Bezug in der 3D-Ansicht wird zu einem Scan gezogen; hier zählt er so, wie ihn der Schnitt allein macht.</translation>
    </message>
    <message>
        <source>No scan pulls at the cover any more (a step in the history).</source>
        <translation>Kein Scan zieht mehr am Bezug (ein Schritt im Verlauf).</translation>
    </message>
    <message>
        <source>Switch the pull off</source>
        <translation>Zug ausschalten</translation>
    </message>
    <message>
        <source>Pull again</source>
        <translation>Wieder ziehen</translation>
    </message>
</context>
<context>
    <name>bolster::ReliefWindow</name>
    <message>
        <source>Relieve strain</source>
        <translation>Dehnung abbauen</translation>
    </message>
    <message>
        <source>&amp;Look for changes</source>
        <translation>Änderungen &amp;suchen</translation>
    </message>
    <message>
        <source>Looking for what relieves strain …</source>
        <translation>Es wird gesucht, was Dehnung abbaut …</translation>
    </message>
    <message>
        <source>Where cloth is strained or pressed together more than it may be, changes of the pattern are tried, and the best are solved.</source>
        <translation>Wo Stoff stärker gedehnt oder gestaucht ist, als er darf, werden Änderungen am Schnitt versucht und die besten berechnet.</translation>
    </message>
    <message>
        <source>Proposed changes</source>
        <translation>Vorgeschlagene Änderungen</translation>
    </message>
    <message>
        <source>Strain is at &amp;most</source>
        <translation>Die &amp;Dehnung ist höchstens</translation>
    </message>
    <message>
        <source>Else the limits of the fabrics count</source>
        <translation>Sonst gelten die Grenzen der Stoffe</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Limit of strain</source>
        <translation>Dehnungsgrenze</translation>
    </message>
    <message>
        <source>Edges move &amp;by at most</source>
        <translation>&amp;Kanten wandern höchstens um</translation>
    </message>
    <message>
        <source>Trying changes …</source>
        <translation>Änderungen werden versucht …</translation>
    </message>
    <message>
        <source>Stopped; nothing has changed.</source>
        <translation>Angehalten; nichts hat sich geändert.</translation>
    </message>
    <message>
        <source>Nothing is strained over the limit.</source>
        <translation>Nichts ist über die Grenze gedehnt.</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit. No change relieves it.</source>
        <translation>%1 des Bezugs liegen über der Grenze. Keine Änderung baut das ab.</translation>
    </message>
    <message>
        <source>Each is solved by itself; &quot;Make it&quot; is one step that Undo takes back.</source>
        <translation>Jede ist für sich berechnet; „Anwenden“ ist ein Schritt, den Rückgängig zurücknimmt.</translation>
    </message>
    <message>
        <source>As it is now</source>
        <translation>Wie es jetzt ist</translation>
    </message>
    <message>
        <source>Sewn: %1 more</source>
        <translation>Genäht: %1 mehr</translation>
    </message>
    <message>
        <source>Sides of seams differ by %1 more</source>
        <translation>Nahtseiten sind um %1 ungleicher</translation>
    </message>
    <message>
        <source>Outlines change by %1</source>
        <translation>Umrisse ändern sich um %1</translation>
    </message>
    <message>
        <source>Show where</source>
        <translation>Stelle zeigen</translation>
    </message>
    <message>
        <source>Make it</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Make it: %1</source>
        <translation>Anwenden: %1</translation>
    </message>
    <message>
        <source>Made. Undo takes it back; look again to see what helps now.</source>
        <translation>Angewendet. Rückgängig nimmt es zurück; suchen Sie neu, um zu sehen, was jetzt hilft.</translation>
    </message>
    <message>
        <source>Stopped. These are solved:</source>
        <translation>Angehalten. Diese sind berechnet:</translation>
    </message>
    <message>
        <source>The best changes are being solved …</source>
        <translation>Die besten Änderungen werden berechnet …</translation>
    </message>
    <message>
        <source>Hardly anything is over the limit: there is little to gain. &quot;Make it&quot; is one step that Undo takes back.</source>
        <translation>Kaum etwas liegt über der Grenze: Es ist wenig zu gewinnen. „Anwenden“ ist ein Schritt, den Rückgängig zurücknimmt.</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit, by %2 (rms of all of it).</source>
        <translation>%1 des Bezugs liegen über der Grenze, um %2 (quadratisches Mittel über den ganzen Bezug).</translation>
    </message>
    <message>
        <source>Over the limit: %1 of the cover, then %2</source>
        <translation>Über der Grenze: %1 des Bezugs, dann %2</translation>
    </message>
    <message>
        <source>Strain over it (rms): %1, then %2</source>
        <translation>Dehnung darüber (quadratisches Mittel): %1, dann %2</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: look again, or undo that.</source>
        <translation>Der Entwurf hat sich inzwischen geändert: Suchen Sie neu, oder machen Sie das rückgängig.</translation>
    </message>
    <message>
        <source>The cover moves by %1 (rms).</source>
        <translation>Der Bezug wandert um %1 (quadratisches Mittel).</translation>
    </message>
    <message>
        <source>From %1 (rms): %2, then %3</source>
        <translation>Von %1 entfernt (quadratisches Mittel): %2, dann %3</translation>
    </message>
</context>
<context>
    <name>bolster::RenderDialog</name>
    <message>
        <source>Render</source>
        <translation>Bild berechnen</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>As in the window</source>
        <translation>Wie im Fenster</translation>
    </message>
    <message>
        <source>Three-quarter</source>
        <translation>Schräg von vorn</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Am besten</translation>
    </message>
    <message>
        <source>How often each pixel is looked at</source>
        <translation>Wie oft jedes Pixel betrachtet wird</translation>
    </message>
    <message>
        <source>Transparent &amp;background</source>
        <translation>Durchsichtiger &amp;Hintergrund</translation>
    </message>
    <message>
        <source>The shadow on the ground is kept</source>
        <translation>Der Schatten auf dem Boden bleibt</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Größe:</translation>
    </message>
    <message>
        <source>&amp;View:</source>
        <translation>&amp;Ansicht:</translation>
    </message>
    <message>
        <source>Sho&amp;w:</source>
        <translation>Ge&amp;zeigt:</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>&amp;Qualität:</translation>
    </message>
    <message>
        <source>Drawing …</source>
        <translation>Wird gezeichnet …</translation>
    </message>
    <message>
        <source>&amp;Render …</source>
        <translation>&amp;Berechnen …</translation>
    </message>
    <message>
        <source>The fabrics as in the window</source>
        <translation>Die Stoffe wie im Fenster</translation>
    </message>
    <message>
        <source>Colourway %1</source>
        <translation>Farbvariante %1</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>At most %1 million pixels are drawn; choose a smaller size.</source>
        <translation>Höchstens %1 Millionen Pixel werden gezeichnet; eine kleinere Größe wählen.</translation>
    </message>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation>Das Bild kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>Render to</source>
        <translation>Bild speichern unter</translation>
    </message>
    <message>
        <source>PNG, 8 bits (*.png);;TIFF, 16 bits (*.tif *.tiff);;OpenEXR, linear light (*.exr)</source>
        <translation>PNG, 8 Bit (*.png);;TIFF, 16 Bit (*.tif *.tiff);;OpenEXR, lineares Licht (*.exr)</translation>
    </message>
    <message>
        <source>The name must end in .png, .tif or .exr.</source>
        <translation>Der Name muss auf .png, .tif oder .exr enden.</translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>Abgebrochen; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>one picture</source>
        <translation>ein Bild</translation>
    </message>
    <message>
        <source> pictures</source>
        <translation> Bilder</translation>
    </message>
    <message>
        <source>So many pictures from all around, with numbers in their names</source>
        <translation>So viele Bilder rundherum, mit Nummern in ihren Namen</translation>
    </message>
    <message>
        <source>&amp;Around the cover:</source>
        <translation>Um den Bezug &amp;herum:</translation>
    </message>
    <message>
        <source>All colourways on a sheet</source>
        <translation>Alle Farbvarianten auf einem Blatt</translation>
    </message>
    <message>
        <source>Map: %1</source>
        <translation>Karte: %1</translation>
    </message>
    <message>
        <source>&amp;Frame and foam</source>
        <translation>Gestell und &amp;Schaum</translation>
    </message>
    <message>
        <source>In the materials that their properties say</source>
        <translation>In den Materialien, die in ihren Eigenschaften stehen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abb&amp;rechen</translation>
    </message>
    <message>
        <source>The picture is written: %1</source>
        <translation>Das Bild ist geschrieben: %1</translation>
    </message>
    <message>
        <source>Open its folder</source>
        <translation>Seinen Ordner öffnen</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>What was made</source>
        <translation>Was entstanden ist</translation>
    </message>
    <message>
        <source>Drawing %1 …</source>
        <translation>%1 wird gezeichnet …</translation>
    </message>
</context>
<context>
    <name>bolster::ReportDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>Problem melden</translation>
    </message>
    <message>
        <source>What did you do, what happened, and what should have happened?</source>
        <translation>Was haben Sie getan, was ist passiert, und was hätte passieren sollen?</translation>
    </message>
    <message>
        <source>&amp;What happened:</source>
        <translation>&amp;Was passiert ist:</translation>
    </message>
    <message>
        <source>&amp;Add the design (&quot;%1&quot;), without its frames, scans and pictures</source>
        <translation>Den &amp;Entwurf („%1“) beifügen, ohne Gestelle, Scans und Bilder</translation>
    </message>
    <message>
        <source>What the &amp;report says besides:</source>
        <translation>Was der &amp;Bericht sonst enthält:</translation>
    </message>
    <message>
        <source>Write the report …</source>
        <translation>Bericht schreiben …</translation>
    </message>
    <message>
        <source>This writes a file that you can give to those who can help. Bolster sends nothing.</source>
        <translation>Das schreibt eine Datei, die Sie denen geben können, die helfen können. Bolster sendet nichts.</translation>
    </message>
    <message>
        <source>not known yet</source>
        <translation>noch nicht bekannt</translation>
    </message>
    <message>
        <source>Messages of this run:</source>
        <translation>Meldungen seit dem Start:</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(keine)</translation>
    </message>
    <message>
        <source>The last crash:</source>
        <translation>Der letzte Absturz:</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Bericht schreiben</translation>
    </message>
    <message>
        <source>ZIP (*.zip)</source>
        <translation>ZIP (*.zip)</translation>
    </message>
    <message>
        <source>The report is written: %1</source>
        <translation>Der Bericht ist geschrieben: %1</translation>
    </message>
    <message>
        <source>The report could not be written: %1</source>
        <translation>Der Bericht konnte nicht geschrieben werden: %1</translation>
    </message>
</context>
<context>
    <name>bolster::Rescue</name>
    <message>
        <source>%1 (recovered)</source>
        <translation>%1 (gerettet)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be opened.</source>
        <translation>„%1“ ließ sich nicht öffnen.</translation>
    </message>
    <message>
        <source>What can be read goes into a new project beside it. This file stays as it is.</source>
        <translation>Was lesbar ist, kommt in ein neues Projekt daneben. Diese Datei bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>&amp;Recover what can be read</source>
        <translation>&amp;Retten, was lesbar ist</translation>
    </message>
    <message>
        <source>Recovering &quot;%1&quot; …</source>
        <translation>„%1“ wird gerettet …</translation>
    </message>
    <message>
        <source>Nothing could be recovered.</source>
        <translation>Es konnte nichts gerettet werden.</translation>
    </message>
    <message>
        <source>What could be read is in &quot;%1&quot; now.</source>
        <translation>Was lesbar war, ist jetzt in „%1“.</translation>
    </message>
    <message>
        <source>The unsaved work on &quot;%1&quot; is damaged.</source>
        <translation>Die nicht gespeicherte Arbeit an „%1“ ist beschädigt.</translation>
    </message>
    <message numerus="yes">
        <source>What can be read goes into a new project. What you do not want any more is deleted %n days after it was put into the bin.</source>
        <translation>
            <numerusform>Was lesbar ist, kommt in ein neues Projekt. Was Sie nicht mehr wollen, wird nach %n Tag im Papierkorb gelöscht.</numerusform>
            <numerusform>Was lesbar ist, kommt in ein neues Projekt. Was Sie nicht mehr wollen, wird nach %n Tagen im Papierkorb gelöscht.</numerusform>
        </translation>
    </message>
    <message>
        <source>Put it into the &amp;bin</source>
        <translation>In den &amp;Papierkorb</translation>
    </message>
    <message>
        <source>The damaged work is kept under File &gt; Unsaved work</source>
        <translation>Die beschädigte Arbeit bleibt unter Datei &gt; Nicht gespeicherte Arbeit</translation>
    </message>
    <message>
        <source>What could be read of it is in &quot;%1&quot; now.</source>
        <translation>Was davon lesbar war, ist jetzt in „%1“.</translation>
    </message>
    <message>
        <source>Nothing of it could be read.</source>
        <translation>Davon war nichts lesbar.</translation>
    </message>
    <message>
        <source>Nothing that was saved is concerned. The damaged work is kept under File &gt; Unsaved work.</source>
        <translation>Was gespeichert war, ist nicht betroffen. Die beschädigte Arbeit bleibt unter Datei &gt; Nicht gespeicherte Arbeit.</translation>
    </message>
    <message>
        <source>Open what was &amp;recovered</source>
        <translation>&amp;Gerettetes öffnen</translation>
    </message>
    <message>
        <source>Looking for what can be read in &quot;%1&quot; …</source>
        <translation>Es wird gesucht, was in „%1“ lesbar ist …</translation>
    </message>
</context>
<context>
    <name>bolster::RunRow</name>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
</context>
<context>
    <name>bolster::SaveFlow</name>
    <message>
        <source>Project with its history (*.bolster);;Design as text (*.json)</source>
        <translation>Projekt mit seinem Verlauf (*.bolster);;Entwurf als Text (*.json)</translation>
    </message>
    <message numerus="yes">
        <source>%n edits</source>
        <translation>
            <numerusform>%n Schritt</numerusform>
            <numerusform>%n Schritte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edits that were undone or are on other branches</source>
        <translation>
            <numerusform>%n rückgängig gemachter oder auf einem anderen Zweig liegender Schritt</numerusform>
            <numerusform>%n rückgängig gemachte oder auf anderen Zweigen liegende Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>names of versions or branches</source>
        <translation>Namen von Versionen oder Zweigen</translation>
    </message>
    <message>
        <source>The file holds another version of the design than the one you see.</source>
        <translation>Die Datei enthält eine andere Version des Entwurfs als die, die zu sehen ist.</translation>
    </message>
    <message>
        <source>Not saved yet: %1.</source>
        <translation>Noch nicht gespeichert: %1.</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>Kopie speichern</translation>
    </message>
    <message>
        <source>-copy</source>
        <translation>-Kopie</translation>
    </message>
    <message>
        <source>Project (*.%1)</source>
        <translation>Projekt (*.%1)</translation>
    </message>
    <message>
        <source>Save the changes in &quot;%1&quot;?</source>
        <translation>Änderungen in „%1“ speichern?</translation>
    </message>
    <message>
        <source>A design as text cannot hold that, a project can.</source>
        <translation>Ein Entwurf als Text kann das nicht aufnehmen, ein Projekt schon.</translation>
    </message>
    <message>
        <source>Work that is kept for later, with all its steps, is under File &gt; Unsaved work.</source>
        <translation>Was für später aufgehoben wird, liegt mit allen Schritten unter Datei &gt; Nicht gespeicherte Arbeit.</translation>
    </message>
    <message>
        <source>Save as &amp;project …</source>
        <translation>Als &amp;Projekt speichern …</translation>
    </message>
    <message>
        <source>&amp;Keep for later</source>
        <translation>Für später auf&amp;heben</translation>
    </message>
    <message>
        <source>The work cannot be kept.</source>
        <translation>Die Arbeit lässt sich nicht aufheben.</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Saved a copy as %1</source>
        <translation>Kopie gespeichert als %1</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
    <message>
        <source>%1: the design alone, without its history</source>
        <translation>%1: nur der Entwurf, ohne seinen Verlauf</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the file any more that was opened or saved here.</source>
        <translation>„%1“ ist nicht mehr die Datei, die hier geöffnet oder gespeichert wurde.</translation>
    </message>
    <message>
        <source>Save your design under another name, or let what is there now have another name beside it. If that is a damaged project, File &gt; Open recovers what can be read of it.</source>
        <translation>Speichern Sie Ihren Entwurf unter einem anderen Namen, oder geben Sie dem, was jetzt dort liegt, einen anderen Namen daneben. Ist das ein beschädigtes Projekt, so rettet Datei &gt; Öffnen, was davon lesbar ist.</translation>
    </message>
    <message>
        <source>&amp;Keep the other file beside it, and save</source>
        <translation>Die andere Datei daneben auf&amp;heben und speichern</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be saved.</source>
        <translation>„%1“ ließ sich nicht speichern.</translation>
    </message>
    <message>
        <source>What was in the place of &quot;%1&quot; is in &quot;%2&quot; now.</source>
        <translation>Was an der Stelle von „%1“ lag, liegt jetzt in „%2“.</translation>
    </message>
    <message>
        <source>Somebody else has changed &quot;%1&quot; since it was opened here.</source>
        <translation>Jemand anders hat „%1“ geändert, seit die Datei hier geöffnet wurde.</translation>
    </message>
    <message>
        <source>Their changes can become a branch of the history here, then both are saved. Your design stays as it is, and you can go to theirs.</source>
        <translation>Die anderen Änderungen können hier ein Zweig des Verlaufs werden, dann wird beides gespeichert. Der eigene Entwurf bleibt, wie er ist, und der andere ist erreichbar.</translation>
    </message>
    <message>
        <source>&amp;Take their changes in as a branch</source>
        <translation>Änderungen als Zweig &amp;übernehmen</translation>
    </message>
    <message>
        <source>From the file, %1</source>
        <translation>Aus der Datei, %1</translation>
    </message>
    <message>
        <source>Their changes could not be taken in.</source>
        <translation>Die anderen Änderungen konnten nicht übernommen werden.</translation>
    </message>
    <message>
        <source>The changes of somebody else are a branch of the history now.</source>
        <translation>Die Änderungen von jemand anderem sind jetzt ein Zweig des Verlaufs.</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>Go &amp;there</source>
        <translation>&amp;Dorthin gehen</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>&amp;Erneut versuchen</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Nothing protects what you do since %1 against a crash: Bolster cannot write to the folder &quot;%2&quot;. Make room there, or save the design.</source>
        <translation>Was Sie seit %1 tun, ist nicht gegen einen Absturz geschützt: Bolster kann nicht in den Ordner „%2“ schreiben. Schaffen Sie dort Platz, oder speichern Sie den Entwurf.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
</context>
<context>
    <name>bolster::ScanLink</name>
    <message>
        <source>Deviation from %1</source>
        <translation>Abweichung von %1</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außen</translation>
    </message>
</context>
<context>
    <name>bolster::SeamLineList</name>
    <message>
        <source>Seam lines</source>
        <translation>Nahtlinien</translation>
    </message>
    <message>
        <source>Fixation curves of the design. Draw seam lines on a frame with the tool for fixation curves: what is drawn meanwhile is cut at once</source>
        <translation>Fixierkurven des Entwurfs. Zeichnen Sie Nahtlinien mit dem Werkzeug für Fixierkurven auf ein Gestell: Was inzwischen gezeichnet wird, wird sofort geschnitten</translation>
    </message>
    <message numerus="yes">
        <source>%n lines that hold a cover</source>
        <translation>
            <numerusform>%n Linie, die einen Bezug hält</numerusform>
            <numerusform>%n Linien, die einen Bezug halten</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::SeamProposalsWindow</name>
    <message>
        <source>Proposed seams</source>
        <translation>Vorgeschlagene Nähte</translation>
    </message>
    <message>
        <source>Edge of</source>
        <translation>Kante von</translation>
    </message>
    <message>
        <source>to edge of</source>
        <translation>an Kante von</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Select rows to see their edges in the pattern; Enter or a double click sews them.</source>
        <translation>Wählen Sie Zeilen, um ihre Kanten im Schnitt zu sehen; die Eingabetaste oder ein Doppelklick näht sie.</translation>
    </message>
    <message>
        <source>&amp;Sew selected</source>
        <translation>Ausgewählte &amp;nähen</translation>
    </message>
    <message>
        <source>Sew &amp;all</source>
        <translation>&amp;Alle nähen</translation>
    </message>
    <message>
        <source>Looking for edges that belong together …</source>
        <translation>Sucht Kanten, die zusammengehören …</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>There are no free edges that seem to belong together.</source>
        <translation>Es gibt keine freien Kanten, die zusammenzugehören scheinen.</translation>
    </message>
    <message>
        <source>Sew &amp;likely ones</source>
        <translation>&amp;Wahrscheinliche nähen</translation>
    </message>
    <message>
        <source>Those of 50 % and more. What is sewn tells where its neighbours belong.</source>
        <translation>Die mit 50 % und mehr. Was genäht ist, sagt, wohin die Nachbarn gehören.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>Found by their lengths, corners that would close, names and directions; the most certain first. Look at each in the pattern before you sew it.</source>
        <translation>Nach Längen, nach Ecken, die sich schließen würden, nach Namen und Richtungen; die sichersten zuerst. Sehen Sie sich jede im Schnitt an, bevor Sie sie nähen.</translation>
    </message>
</context>
<context>
    <name>bolster::SeamsModel</name>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>More than 5 % ease puckers.</source>
        <translation>Mehr als 5 % Mehrweite wirft Falten.</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Mehrweite</translation>
    </message>
    <message>
        <source>Ease %</source>
        <translation>Mehrw. %</translation>
    </message>
    <message>
        <source>Joins</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>Length 1</source>
        <translation>Länge 1</translation>
    </message>
    <message>
        <source>Length 2</source>
        <translation>Länge 2</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <source>The letter on both stretches in the pattern</source>
        <translation>Der Buchstabe an beiden Abschnitten im Schnitt</translation>
    </message>
    <message>
        <source>The patches and their edges</source>
        <translation>Die Schnittteile und ihre Kanten</translation>
    </message>
    <message>
        <source>C0: an edge, C1: smooth with the texture, G1: rounded</source>
        <translation>C0: eine Kante, C1: glatt samt Muster, G1: gerundet</translation>
    </message>
    <message>
        <source>Of the first side</source>
        <translation>Der ersten Seite</translation>
    </message>
    <message>
        <source>Of the second side</source>
        <translation>Der zweiten Seite</translation>
    </message>
    <message>
        <source>What is sewn together: equal parts of the length, or of the curve&apos;s parameter</source>
        <translation>Was zusammengenäht wird: gleiche Teile der Länge oder des Kurvenparameters</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>The place in the order of sewing; Seam &gt; Sew earlier and Sew later change it</source>
        <translation>Der Platz in der Nähfolge; Naht &gt; Früher nähen und Später nähen ändern ihn</translation>
    </message>
    <message>
        <source>How much longer the second side is than the first one</source>
        <translation>Wie viel länger die zweite Seite ist als die erste</translation>
    </message>
    <message>
        <source>The ease over the shorter side; more than 5 % puckers</source>
        <translation>Die Mehrweite durch die kürzere Seite; mehr als 5 % kräuseln</translation>
    </message>
</context>
<context>
    <name>bolster::SeamsView</name>
    <message>
        <source>No seams yet. Choose the sewing tool (W), then click the two edges that belong together.</source>
        <translation>Noch keine Nähte. Wähle das Nähwerkzeug (W) und klicke dann die zwei Kanten an, die zusammengehören.</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Nähte</translation>
    </message>
</context>
<context>
    <name>bolster::SectionPanel</name>
    <message>
        <source>Section</source>
        <translation>Schnittebene</translation>
    </message>
    <message>
        <source>Cut across the x axis</source>
        <translation>Quer zur x-Achse schneiden</translation>
    </message>
    <message>
        <source>Cut across the y axis</source>
        <translation>Quer zur y-Achse schneiden</translation>
    </message>
    <message>
        <source>Cut across the z axis</source>
        <translation>Quer zur z-Achse schneiden</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Cut parallel to the picture, as it is seen now</source>
        <translation>Parallel zum Bild schneiden, wie es jetzt zu sehen ist</translation>
    </message>
    <message>
        <source>Moves the plane</source>
        <translation>Verschiebt die Ebene</translation>
    </message>
    <message>
        <source>Show the other half</source>
        <translation>Die andere Hälfte zeigen</translation>
    </message>
    <message>
        <source>Close the section</source>
        <translation>Schnittebene schließen</translation>
    </message>
    <message>
        <source>Place of the section</source>
        <translation>Lage der Schnittebene</translation>
    </message>
</context>
<context>
    <name>bolster::SewingCommands</name>
    <message>
        <source>Propos&amp;e seams …</source>
        <translation>Nähte vo&amp;rschlagen …</translation>
    </message>
    <message>
        <source>Show seam li&amp;st</source>
        <translation>Naht&amp;liste zeigen</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>&amp;Umkehren</translation>
    </message>
    <message>
        <source>Swap si&amp;des</source>
        <translation>Seiten &amp;tauschen</translation>
    </message>
    <message>
        <source>C&amp;0 – an edge</source>
        <translation>C&amp;0 – eine Kante</translation>
    </message>
    <message>
        <source>C&amp;1 – smooth, texture too</source>
        <translation>C&amp;1 – glatt, auch das Muster</translation>
    </message>
    <message>
        <source>&amp;G1 – rounded</source>
        <translation>&amp;G1 – gerundet</translation>
    </message>
    <message>
        <source>Match by &amp;length</source>
        <translation>Zuordnung nach &amp;Länge</translation>
    </message>
    <message>
        <source>Match by &amp;parameter</source>
        <translation>Zuordnung nach &amp;Parameter</translation>
    </message>
    <message>
        <source>Sew earl&amp;ier</source>
        <translation>&amp;Früher nähen</translation>
    </message>
    <message>
        <source>Sew l&amp;ater</source>
        <translation>Sp&amp;äter nähen</translation>
    </message>
    <message>
        <source>Sewi&amp;ng order as proposed</source>
        <translation>Nähf&amp;olge wie vorgeschlagen</translation>
    </message>
</context>
<context>
    <name>bolster::SheetPreview</name>
    <message>
        <source>What will be on the sheets</source>
        <translation>Was auf den Blättern sein wird</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>Es gibt nichts zu schneiden.</translation>
    </message>
    <message>
        <source>Laying out …</source>
        <translation>Wird ausgelegt …</translation>
    </message>
</context>
<context>
    <name>bolster::ShortcutsDialog</name>
    <message>
        <source>&amp;No keys</source>
        <translation>&amp;Keine Tasten</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Take them over</source>
        <translation>Ü&amp;bernehmen</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Find a command or a key</source>
        <translation>Befehl oder Taste suchen</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>&amp;Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Click into the field and press the keys.</source>
        <translation>Ins Feld klicken und die Tasten drücken.</translation>
    </message>
    <message>
        <source>Choose a command to change its keys.</source>
        <translation>Einen Befehl wählen, um seine Tasten zu ändern.</translation>
    </message>
    <message>
        <source>%1 is needed by the views and fields themselves.</source>
        <translation>%1 brauchen die Ansichten und Felder selbst.</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 gehört zu „%2“.</translation>
    </message>
    <message>
        <source>%1 it is.</source>
        <translation>%1 ist vergeben.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
</context>
<context>
    <name>bolster::ShownPattern</name>
    <message>
        <source>Edge: %1</source>
        <translation>Kante: %1</translation>
    </message>
</context>
<context>
    <name>bolster::SimplifyChoice</name>
    <message>
        <source>&amp;Simplify to about</source>
        <translation>&amp;Vereinfachen auf etwa</translation>
    </message>
    <message>
        <source> triangles</source>
        <translation> Dreiecke</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Writes the parts that are wanted into an OBJ file of the design&apos;s own; the file that was chosen stays as it is</source>
        <translation>Schreibt die gewünschten Teile in eine eigene OBJ-Datei des Entwurfs; die gewählte Datei bleibt, wie sie ist</translation>
    </message>
</context>
<context>
    <name>bolster::SpotsPanel</name>
    <message>
        <source>Worst spots</source>
        <translation>Schlimmste Stellen</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>Schnittteil</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Negative where the fabric is pressed together</source>
        <translation>Negativ, wo der Stoff gestaucht ist</translation>
    </message>
    <message>
        <source>What the fabric there may suffer. The spots are sorted by how much of it they take</source>
        <translation>Was der Stoff dort aushalten darf. Die Stellen sind danach geordnet, wie viel davon sie brauchen</translation>
    </message>
    <message>
        <source>As soon as there is a cover, its worst spots will be listed here.</source>
        <translation>Sobald es einen Bezug gibt, stehen seine schlimmsten Stellen hier.</translation>
    </message>
    <message>
        <source>A map of strain or shear shows what the fabric suffers. Its worst spots will be listed here.</source>
        <translation>Eine Karte der Dehnung oder Scherung zeigt, was der Stoff aushalten muss. Ihre schlimmsten Stellen stehen dann hier.</translation>
    </message>
    <message>
        <source>Nothing is over the limit of its fabric.</source>
        <translation>Nichts liegt über der Grenze seines Stoffs.</translation>
    </message>
    <message>
        <source>Over the limit of the fabric: %1 of %2</source>
        <translation>Über der Grenze des Stoffs: %1 von %2</translation>
    </message>
    <message>
        <source>over the limit of %1</source>
        <translation>über der Grenze von %1</translation>
    </message>
    <message>
        <source>Show the &amp;largest strain</source>
        <translation>&amp;Größte Dehnung zeigen</translation>
    </message>
</context>
<context>
    <name>bolster::StartHint</name>
    <message>
        <source>A new cover</source>
        <translation>Ein neuer Bezug</translation>
    </message>
    <message>
        <source>Draw the first patch, import a frame, or open a design:</source>
        <translation>Das erste Schnittteil zeichnen, ein Gestell importieren oder einen Entwurf öffnen:</translation>
    </message>
    <message>
        <source>Or look at a sample:</source>
        <translation>Oder ein Beispiel ansehen:</translation>
    </message>
    <message>
        <source>%1 more are under File &gt; Samples</source>
        <translation>%1 weitere unter Datei &gt; Beispiele</translation>
    </message>
    <message>
        <source>Go on with:</source>
        <translation>Weiterarbeiten an:</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>Rectan&amp;gle</source>
        <translation>&amp;Rechteck</translation>
    </message>
    <message>
        <source>Ou&amp;tline</source>
        <translation>&amp;Umriss</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>Öff&amp;nen …</translation>
    </message>
    <message>
        <source>&amp;Import frame …</source>
        <translation>Gestell &amp;importieren …</translation>
    </message>
</context>
<context>
    <name>bolster::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>Welcome to Bolster</source>
        <translation>Willkommen bei Bolster</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>Rundgang beginnen</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Back to the design</source>
        <translation>Zurück zum Entwurf</translation>
    </message>
    <message>
        <source>What do you have?</source>
        <translation>Was haben Sie?</translation>
    </message>
    <message>
        <source>A frame</source>
        <translation>Ein Gestell</translation>
    </message>
    <message>
        <source>The cover is fixed on it: %1</source>
        <translation>Der Bezug wird daran fixiert: %1</translation>
    </message>
    <message>
        <source>A pattern</source>
        <translation>Einen Schnitt</translation>
    </message>
    <message>
        <source>Its pieces become the cover: %1</source>
        <translation>Aus seinen Teilen wird der Bezug: %1</translation>
    </message>
    <message>
        <source>A scan</source>
        <translation>Einen Scan</translation>
    </message>
    <message>
        <source>The cover is fitted to it: %1</source>
        <translation>Der Bezug wird daran angepasst: %1</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>Draw a rectangle, the first patch</source>
        <translation>Ein Rechteck zeichnen, das erste Schnittteil</translation>
    </message>
    <message>
        <source>Go on with</source>
        <translation>Weiterarbeiten an</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>Take it out of this list; the file stays</source>
        <translation>Aus dieser Liste nehmen; die Datei bleibt</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Nicht gespeicherte Arbeit</translation>
    </message>
    <message>
        <source>Kept for later, last edit %1</source>
        <translation>Für später aufgehoben, letzter Schritt %1</translation>
    </message>
    <message>
        <source>Left by a crash, last edit %1</source>
        <translation>Von einem Absturz übrig, letzter Schritt %1</translation>
    </message>
    <message>
        <source>Begin with a template</source>
        <translation>Mit einer Vorlage beginnen</translation>
    </message>
    <message>
        <source>Look at a sample</source>
        <translation>Ein Beispiel ansehen</translation>
    </message>
    <message>
        <source>It is not there now</source>
        <translation>Es ist jetzt nicht da</translation>
    </message>
</context>
<context>
    <name>bolster::StatusLine</name>
    <message>
        <source>Nothing to sew yet</source>
        <translation>Noch nichts zu nähen</translation>
    </message>
    <message>
        <source>Preparing …</source>
        <translation>Vorbereitung …</translation>
    </message>
    <message>
        <source>Moving, %1/s</source>
        <translation>In Bewegung, %1/s</translation>
    </message>
    <message>
        <source>Solved – %1 iterations</source>
        <translation>Gelöst – %1 Schritte</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message numerus="yes">
        <source>%n problems</source>
        <translation>
            <numerusform>%n Problem</numerusform>
            <numerusform>%n Probleme</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n Warnung</numerusform>
            <numerusform>%n Warnungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Solved in part</source>
        <translation>Zum Teil gelöst</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Warum?</translation>
    </message>
    <message>
        <source>Following the drag</source>
        <translation>Folgt dem Ziehen</translation>
    </message>
    <message>
        <source>Solved, with warnings</source>
        <translation>Gelöst, mit Warnungen</translation>
    </message>
    <message>
        <source>Show (%1)</source>
        <translation>Zeigen (%1)</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>The cloth went on moving until the computation was ended. What usually causes that:
• A piece that nothing holds: fix one of its edges, or sew it on.
• A seam whose two sides differ much in length: make them more alike.
• A very long or very narrow piece: divide it, or make it wider.
• High pressure: lower it in the properties of the patch.
What you see is where the cloth was at the end.</source>
        <translation>Der Stoff hat sich bis zum Ende der Berechnung bewegt. Das liegt meist an einem davon:
• Ein Teil, das nichts hält: Befestigen Sie eine Kante, oder nähen Sie es an.
• Eine Naht, deren Seiten sehr verschieden lang sind: Gleichen Sie sie an.
• Ein sehr langes oder sehr schmales Teil: Teilen Sie es, oder machen Sie es breiter.
• Hoher Druck: Senken Sie ihn in den Eigenschaften des Schnittteils.
Sie sehen den Stoff, wie er am Ende lag.</translation>
    </message>
    <message>
        <source>Drawing and checking …</source>
        <translation>Zeichnet und prüft …</translation>
    </message>
    <message>
        <source>Preparing: on fewer triangles …</source>
        <translation>Vorbereitung: auf weniger Dreiecken …</translation>
    </message>
    <message>
        <source>Preparing: forces and equations …</source>
        <translation>Vorbereitung: Kräfte und Gleichungen …</translation>
    </message>
    <message>
        <source>&amp;What does it mean?</source>
        <translation>&amp;Was bedeutet das?</translation>
    </message>
    <message>
        <source>A preview, not checked yet</source>
        <translation>Eine Vorschau, noch nicht geprüft</translation>
    </message>
</context>
<context>
    <name>bolster::SweepWindow</name>
    <message>
        <source>Tolerances</source>
        <translation>Toleranzen</translation>
    </message>
    <message>
        <source>&amp;Draw pieces</source>
        <translation>Stücke z&amp;iehen</translation>
    </message>
    <message>
        <source>Solving pieces within tolerances …</source>
        <translation>Stücke innerhalb der Toleranzen werden berechnet …</translation>
    </message>
    <message>
        <source>Pieces are drawn at random within their tolerances: where does the cover vary, which tolerance matters, how many pieces are out of the limit?</source>
        <translation>Stücke werden zufällig innerhalb ihrer Toleranzen gezogen: Wo schwankt der Bezug, auf welche Toleranz kommt es an, wie viele Stücke liegen außerhalb der Grenze?</translation>
    </message>
    <message>
        <source>&amp;Show on the cover what 95 % of the pieces do not exceed</source>
        <translation>Auf dem &amp;Bezug zeigen, was 95 % der Stücke nicht überschreiten</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Moves by at most</source>
        <translation>Wandert höchstens um</translation>
    </message>
    <message>
        <source>Tolerances by their influence</source>
        <translation>Toleranzen nach ihrem Einfluss</translation>
    </message>
    <message>
        <source>Tolerances (±); 0: none</source>
        <translation>Toleranzen (±); 0: keine</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>Every size within is as likely</source>
        <translation>Jedes Maß darin ist gleich wahrscheinlich</translation>
    </message>
    <message>
        <source>Normal: the tolerance is three standard deviations</source>
        <translation>Normalverteilt: Die Toleranz ist drei Standardabweichungen</translation>
    </message>
    <message>
        <source>Before them ten thousand are drawn as if covers were linear, which takes seconds</source>
        <translation>Davor werden zehntausend gezogen, als wären Bezüge linear; das dauert Sekunden</translation>
    </message>
    <message>
        <source>Dr&amp;awn</source>
        <translation>Gez&amp;ogen</translation>
    </message>
    <message>
        <source>S&amp;olved</source>
        <translation>Be&amp;rechnet</translation>
    </message>
    <message>
        <source>Nothing varies: give a tolerance above 0 of something that the design has.</source>
        <translation>Nichts schwankt: Geben Sie eine Toleranz über 0 für etwas an, das der Entwurf hat.</translation>
    </message>
    <message>
        <source>Covers with each tolerance are solved …</source>
        <translation>Bezüge mit jeder Toleranz werden berechnet …</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>That is as if covers were linear; pieces are being solved …</source>
        <translation>Das gilt, als wären Bezüge linear; Stücke werden gerade berechnet …</translation>
    </message>
    <message>
        <source>That is as if covers were linear.</source>
        <translation>Das gilt, als wären Bezüge linear.</translation>
    </message>
    <message numerus="yes">
        <source>By %n solved pieces.</source>
        <translation>
            <numerusform>Nach %n berechnetem Stück.</numerusform>
            <numerusform>Nach %n berechneten Stücken.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces have no cover at rest.</source>
        <translation>
            <numerusform>%n Stück hat keinen ruhenden Bezug.</numerusform>
            <numerusform>%n Stücke haben keinen ruhenden Bezug.</numerusform>
        </translation>
    </message>
    <message>
        <source>What 95 % of the pieces do not exceed</source>
        <translation>Was 95 % der Stücke nicht überschreiten</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: draw the pieces again.</source>
        <translation>Der Entwurf hat sich inzwischen geändert: Ziehen Sie die Stücke neu.</translation>
    </message>
    <message numerus="yes">
        <source>By %n solved pieces so far; more are being solved …</source>
        <translation>
            <numerusform>Nach bisher %n berechnetem Stück; weitere werden berechnet …</numerusform>
            <numerusform>Nach bisher %n berechneten Stücken; weitere werden berechnet …</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With %n tolerances no cover is found, as with: %1. They are left out of this: make them smaller.</source>
        <translation>
            <numerusform>Mit %n Toleranz findet sich kein Bezug, nämlich: %1. Sie ist hier nicht dabei: machen Sie sie kleiner.</numerusform>
            <numerusform>Mit %n Toleranzen findet sich kein Bezug, so mit: %1. Sie sind hier nicht dabei: machen Sie sie kleiner.</numerusform>
        </translation>
    </message>
    <message>
        <source>A piece is out of it when more than 5 % of its cover lie farther from where they should be</source>
        <translation>Ein Stück liegt außerhalb, wenn mehr als 5 % seines Bezugs weiter als das von ihrem Platz abweichen</translation>
    </message>
    <message>
        <source>95 % of the pieces do not exceed, place by place, %1 (rms over the cover), %2 where it is most.</source>
        <translation>Was 95 % der Stücke Stelle für Stelle nicht überschreiten: %1 (quadratisches Mittel über den Bezug), %2 an der stärksten Stelle.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>How much of the variance of the whole cover comes of it</source>
        <translation>Wie viel von der Varianz des ganzen Bezugs daher kommt</translation>
    </message>
    <message>
        <source>± is what many more of them may change.</source>
        <translation>± ist, was viel mehr von ihnen noch ändern können.</translation>
    </message>
    <message>
        <source>Out of the limit: about %1 of the pieces.</source>
        <translation>Außerhalb der Grenze: etwa %1 der Stücke.</translation>
    </message>
    <message>
        <source>Out of the limit: %1 of %2 pieces (of many: %3 to %4).</source>
        <translation>Außerhalb der Grenze: %1 von %2 Stücken (von vielen: %3 bis %4).</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>These are too few to say how sure that is.</source>
        <translation>Das sind zu wenige, um zu sagen, wie sicher das ist.</translation>
    </message>
    <message>
        <source>&amp;Limit for 95 % of a cover</source>
        <translation>&amp;Grenze für 95 % eines Bezugs</translation>
    </message>
    <message>
        <source>This is of what was set before: draw pieces for what is set now.</source>
        <translation>Das gilt für das, was vorher eingestellt war: Ziehen Sie Stücke für das, was jetzt eingestellt ist.</translation>
    </message>
</context>
<context>
    <name>bolster::ToolHost</name>
    <message>
        <source>This could not be done, and nothing was changed: %1</source>
        <translation>Das ging nicht, und nichts wurde verändert: %1</translation>
    </message>
</context>
<context>
    <name>bolster::TourPanel</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>Rundgang verlassen</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Help &gt; Tour goes on from here</source>
        <translation>Hilfe &gt; Rundgang macht hier weiter</translation>
    </message>
    <message>
        <source>Tour, %1 of %2</source>
        <translation>Rundgang, %1 von %2</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Beenden</translation>
    </message>
</context>
<context>
    <name>bolster::TrimTool</name>
    <message>
        <source>Click a seam or an edge of an outline.</source>
        <translation>Eine Naht oder die Kante eines Umrisses anklicken.</translation>
    </message>
    <message>
        <source>Click to stitch this seam; stitches and piping are in the properties</source>
        <translation>Klick steppt diese Naht ab; Stiche und Keder stehen bei den Eigenschaften</translation>
    </message>
    <message>
        <source>Click to stitch this edge; stitches and piping are in the properties</source>
        <translation>Klick steppt diese Kante ab; Stiche und Keder stehen bei den Eigenschaften</translation>
    </message>
    <message>
        <source>Click a seam or an edge of an outline to stitch it – Esc ends the tool</source>
        <translation>Eine Naht oder Kante anklicken, um sie abzusteppen – Esc beendet das Werkzeug</translation>
    </message>
</context>
<context>
    <name>bolster::VersionPane</name>
    <message>
        <source>Computing the cover …</source>
        <translation>Der Bezug wird berechnet …</translation>
    </message>
    <message>
        <source>Pattern of %1</source>
        <translation>Schnitt von %1</translation>
    </message>
    <message>
        <source>Cover of %1</source>
        <translation>Bezug von %1</translation>
    </message>
</context>
<context>
    <name>bolster::ViewCube</name>
    <message>
        <source>FRONT</source>
        <translation>VORN</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>HINTEN</translation>
    </message>
    <message>
        <source>LEFT</source>
        <translation>LINKS</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <translation>RECHTS</translation>
    </message>
    <message>
        <source>TOP</source>
        <translation>OBEN</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <translation>UNTEN</translation>
    </message>
    <message>
        <source>Click a face, an edge or a corner to look from there; drag to turn</source>
        <translation>Klick auf eine Fläche, Kante oder Ecke blickt von dort; Ziehen dreht</translation>
    </message>
</context>
</TS>
