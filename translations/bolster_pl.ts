<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pl" sourcelanguage="en">
<context>
    <name>AreaBrushTool</name>
    <message>
        <source>Drag over the cover to paint the area; with Shift held down to take away. + and − change the brush. Esc ends.</source>
        <translation>Przeciągnij po pokrowcu, aby pomalować obszar; z wciśniętym Shift – aby odjąć. + i − zmieniają pędzel. Esc kończy.</translation>
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
        <translation>„%1” już istnieje. Zastąpić?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
</context>
<context>
    <name>AttachTool</name>
    <message>
        <source>Click an edge of an outline.</source>
        <translation>Kliknij krawędź konturu.</translation>
    </message>
    <message>
        <source>Select a fixation curve first, in the 3D view or in the list.</source>
        <translation>Najpierw zaznacz krzywą mocowania – w widoku 3D lub na liście.</translation>
    </message>
    <message>
        <source>Several stretches go with one curve, or one stretch with several curves.</source>
        <translation>Kilka odcinków łączy się z jedną krzywą albo jeden odcinek z kilkoma krzywymi.</translation>
    </message>
    <message>
        <source>The stretches overlap each other, or are attached like this already.</source>
        <translation>Odcinki nakładają się na siebie lub są już tak zamocowane.</translation>
    </message>
    <message>
        <source>This stretch is attached like this already.</source>
        <translation>Ten odcinek jest już tak zamocowany.</translation>
    </message>
    <message>
        <source>Select a fixation curve in the 3D view or in the list, then click an edge of an outline – Esc ends the tool</source>
        <translation>Zaznacz krzywą mocowania w widoku 3D lub na liście, potem kliknij krawędź konturu – Esc kończy</translation>
    </message>
    <message>
        <source>%1 curves</source>
        <translation>krzywe: %1</translation>
    </message>
    <message>
        <source>Click to fix this stretch of %1 to %2 – Shift+click collects several</source>
        <translation>Kliknij, aby zamocować ten odcinek (%1) do: %2 – Shift+kliknięcie zbiera kilka</translation>
    </message>
    <message>
        <source>Click the last edge, or Enter attaches %1 stretches to %2 – Backspace takes one back</source>
        <translation>Kliknij ostatnią krawędź lub Enter, aby zamocować odcinki (%1) do: %2 – Backspace cofa ostatni</translation>
    </message>
    <message>
        <source>Click an edge of an outline to fix it to %1 – Enter takes the selected stretch, Esc ends the tool</source>
        <translation>Kliknij krawędź konturu, aby zamocować ją do: %1 – Enter bierze zaznaczony odcinek, Esc kończy</translation>
    </message>
    <message>
        <source>&amp;Attach what is marked</source>
        <translation>&amp;Zamocuj oznaczone</translation>
    </message>
    <message>
        <source>&amp;Take back the last edge</source>
        <translation>&amp;Cofnij ostatnią krawędź</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>&amp;Porzuć</translation>
    </message>
</context>
<context>
    <name>BackgroundMoveTool</name>
    <message>
        <source>There is no background picture yet.</source>
        <translation>Nie ma jeszcze obrazu tła.</translation>
    </message>
    <message>
        <source>Drag the picture to its place – Enter or Esc ends the tool</source>
        <translation>Przeciągnij obraz na miejsce – Enter lub Esc kończy</translation>
    </message>
</context>
<context>
    <name>BackgroundPicture</name>
    <message>
        <source>%1 cannot be read as a picture: %2</source>
        <translation>%1: nie można odczytać jako obrazu: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an ordinary file.</source>
        <translation>„%1” nie jest zwykłym plikiem.</translation>
    </message>
</context>
<context>
    <name>BackgroundScaleTool</name>
    <message>
        <source>There is no background picture yet.</source>
        <translation>Nie ma jeszcze obrazu tła.</translation>
    </message>
    <message>
        <source>Type the true distance of the two points, for example 500 or 20 in.</source>
        <translation>Wpisz rzeczywistą odległość obu punktów, np. 500 albo 20 in.</translation>
    </message>
    <message>
        <source>Click the first of two points of the picture whose distance you know – Esc ends the tool</source>
        <translation>Kliknij pierwszy z dwóch punktów obrazu o znanej odległości – Esc kończy</translation>
    </message>
    <message>
        <source>Click the second point</source>
        <translation>Kliknij drugi punkt</translation>
    </message>
    <message>
        <source>Type their true distance, then Enter</source>
        <translation>Wpisz ich rzeczywistą odległość, potem Enter</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>teraz %1</translation>
    </message>
</context>
<context>
    <name>BoxShapeTool</name>
    <message>
        <source>&quot;%1&quot; is no size: try 300 x 200</source>
        <translation>„%1” to nie rozmiar: spróbuj 300 x 200</translation>
    </message>
    <message>
        <source>Enter makes it as wide and high as typed, for example 300 x 200</source>
        <translation>Enter nadaje wpisaną szerokość i wysokość, np. 300 x 200</translation>
    </message>
    <message>
        <source>Drag a rectangle, or click two opposite corners – Esc ends the tool</source>
        <translation>Przeciągnij prostokąt lub kliknij dwa przeciwległe rogi – Esc kończy</translation>
    </message>
    <message>
        <source>Drag an ellipse, or click two opposite corners of its box – Esc ends the tool</source>
        <translation>Przeciągnij elipsę lub kliknij dwa przeciwległe rogi jej ramki – Esc kończy</translation>
    </message>
    <message>
        <source>Click the opposite corner, or type width x height – Shift makes both equal, Ctrl does not snap</source>
        <translation>Kliknij przeciwległy róg lub wpisz szerokość x wysokość – Shift zrównuje obie, Ctrl wyłącza przyciąganie</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>There was no room where you clicked: the patch lies beside the others.</source>
        <translation>W klikniętym miejscu brakło miejsca: element leży obok innych.</translation>
    </message>
    <message>
        <source>The new patch lies on %1: drag it away, or let all be arranged (Pattern &gt; Arrange).</source>
        <translation>Nowy element leży na: %1. Odciągnij go lub rozmieść wszystkie (Wykrój &gt; Rozmieść).</translation>
    </message>
    <message>
        <source>lies on %1</source>
        <translation>leży na: %1</translation>
    </message>
</context>
<context>
    <name>ColourwayForm</name>
    <message>
        <source>Fabrics</source>
        <translation>Materiały</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>those of the patches</source>
        <translation>materiały elementów</translation>
    </message>
</context>
<context>
    <name>ContextMenus</name>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Pokaż</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>Pa&amp;trz</translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Mapa</translation>
    </message>
    <message>
        <source>&amp;Continuity</source>
        <translation>&amp;Ciągłość</translation>
    </message>
    <message>
        <source>&amp;Match</source>
        <translation>Pa&amp;rowanie</translation>
    </message>
    <message>
        <source>&amp;Arrange</source>
        <translation>Ro&amp;zmieść</translation>
    </message>
</context>
<context>
    <name>CoverAtRest</name>
    <message>
        <source>As soon as the cover has come to rest …</source>
        <translation>Gdy tylko pokrowiec się ustabilizuje…</translation>
    </message>
    <message>
        <source>This needs the cover of the present design: let the solver go on first (Pause).</source>
        <translation>Potrzebny jest pokrowiec obecnego modelu: najpierw wznów obliczenia (Wstrzymaj).</translation>
    </message>
</context>
<context>
    <name>CoverMeasureTool</name>
    <message>
        <source>There is no cover here: click on the cover.</source>
        <translation>Nie ma tu pokrowca: kliknij pokrowiec.</translation>
    </message>
    <message>
        <source>&amp;Keep the measurement</source>
        <translation>Za&amp;chowaj pomiar</translation>
    </message>
    <message>
        <source>%1 – Enter keeps the measurement, a click begins anew</source>
        <translation>%1 – Enter zachowuje pomiar, kliknięcie zaczyna od nowa</translation>
    </message>
    <message>
        <source>Click the second point on the cover – Esc gives it up</source>
        <translation>Kliknij drugi punkt na pokrowcu – Esc rezygnuje</translation>
    </message>
    <message>
        <source>Click two points of the cover or of the pattern to measure – Esc ends the tool</source>
        <translation>Kliknij dwa punkty pokrowca lub wykroju, aby zmierzyć – Esc kończy</translation>
    </message>
</context>
<context>
    <name>CoverSelectTool</name>
    <message>
        <source>There is a control point already.</source>
        <translation>Tu już jest punkt kontrolny.</translation>
    </message>
    <message>
        <source>Drag to move the control point – Shift+click selects several, Del removes</source>
        <translation>Przeciągnij, aby przesunąć punkt kontrolny – Shift+kliknięcie zaznacza kilka, Del usuwa</translation>
    </message>
    <message>
        <source>Click to select the seam</source>
        <translation>Kliknij, aby zaznaczyć szew</translation>
    </message>
    <message>
        <source>Click to select the patch, drag to turn the view</source>
        <translation>Kliknij, aby zaznaczyć element; przeciągnij, aby obrócić widok</translation>
    </message>
    <message>
        <source>Click to select the curve, double click to add a control point here</source>
        <translation>Kliknij, aby zaznaczyć krzywą; dwukrotne kliknięcie dodaje tu punkt kontrolny</translation>
    </message>
    <message>
        <source>Click to select what stands here, drag to turn the view</source>
        <translation>Kliknij, aby zaznaczyć to, co tu jest; przeciągnij, aby obrócić widok</translation>
    </message>
    <message>
        <source>Click to select, drag to turn – %1 pans, %2 zooms</source>
        <translation>Kliknięcie zaznacza, przeciąganie obraca – %1 przesuwa, %2 powiększa</translation>
    </message>
    <message>
        <source>Click to select the measurement, Delete removes it</source>
        <translation>Kliknięcie zaznacza pomiar, Delete go usuwa</translation>
    </message>
</context>
<context>
    <name>CushionForm</name>
    <message>
        <source>Cover of %1</source>
        <translation>Pokrowiec: %1</translation>
    </message>
    <message>
        <source>Every cover</source>
        <translation>Każdy pokrowiec</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Wypycha</translation>
    </message>
</context>
<context>
    <name>CutCornerForm</name>
    <message>
        <source>Patch</source>
        <translation>Element</translation>
    </message>
</context>
<context>
    <name>CutLabelWords</name>
    <message>
        <source>Cut %1</source>
        <translation>Kroić %1×</translation>
    </message>
    <message>
        <source>Cut %1 and %1 mirrored</source>
        <translation>Kroić %1× i %1× lustrzanie</translation>
    </message>
</context>
<context>
    <name>CuttingCommands</name>
    <message>
        <source>Chec&amp;k before cutting</source>
        <translation>S&amp;prawdź przed krojeniem</translation>
    </message>
</context>
<context>
    <name>DartCommands</name>
    <message>
        <source>Remove da&amp;rt</source>
        <translation>Usuń &amp;zaszewkę</translation>
    </message>
    <message>
        <source>The edge goes on as if the selected dart had never been cut</source>
        <translation>Krawędź biegnie tak, jakby zaznaczonej zaszewki nigdy nie było</translation>
    </message>
    <message>
        <source>R&amp;otate dart to …</source>
        <translation>Przeni&amp;eś zaszewkę do…</translation>
    </message>
    <message>
        <source>Turns the selected dart shut and opens the pattern where you click, by the same angle</source>
        <translation>Zamyka zaznaczoną zaszewkę i otwiera wykrój w klikniętym miejscu o ten sam kąt</translation>
    </message>
</context>
<context>
    <name>DartDrag</name>
    <message>
        <source>Near the dotted line both legs become of one length, or type how deep it is – Shift keeps to it, Ctrl lets go, Esc takes it back</source>
        <translation>Przy linii kropkowanej oba ramiona mają równą długość; możesz też wpisać głębokość – Shift trzyma się linii, Ctrl ją puszcza, Esc cofa</translation>
    </message>
    <message>
        <source>Drag the dart along the outline, or type how far its middle is from the corner – Esc takes it back</source>
        <translation>Przeciągnij zaszewkę wzdłuż konturu lub wpisz odległość jej środka od rogu – Esc cofa</translation>
    </message>
</context>
<context>
    <name>DartPicture</name>
    <message>
        <source>Depth %1, legs of one length</source>
        <translation>Głębokość %1, ramiona równe</translation>
    </message>
    <message>
        <source>Depth %1</source>
        <translation>Głębokość %1</translation>
    </message>
    <message>
        <source>Mouth %1</source>
        <translation>Rozwarcie %1</translation>
    </message>
</context>
<context>
    <name>DartRotateTool</name>
    <message>
        <source>Select the seam of a dart first – Esc ends the tool</source>
        <translation>Najpierw zaznacz szew zaszewki – Esc kończy</translation>
    </message>
    <message>
        <source>Click the outline where the dart shall open instead – Ctrl does not snap, Esc ends the tool</source>
        <translation>Kliknij kontur tam, gdzie zaszewka ma się otwierać – Ctrl wyłącza przyciąganie, Esc kończy</translation>
    </message>
</context>
<context>
    <name>DartTool</name>
    <message>
        <source>There is no room for a mouth of &quot;%1&quot;.</source>
        <translation>Brak miejsca na rozwarcie „%1”.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no depth: try 60</source>
        <translation>„%1” to nie głębokość: spróbuj 60</translation>
    </message>
    <message>
        <source>Click the tip inside the patch, or type how deep it lies – on the dotted line both legs are of one length (Shift keeps to it, Ctrl lets go), Esc takes a click back</source>
        <translation>Kliknij wierzchołek wewnątrz elementu lub wpisz jego głębokość – na linii kropkowanej ramiona są równe (Shift trzyma się jej, Ctrl puszcza), Esc cofa kliknięcie</translation>
    </message>
    <message>
        <source>Click where the mouth ends on the same outline, or type how wide it is – Ctrl does not snap, Esc takes the click back</source>
        <translation>Kliknij koniec rozwarcia na tym samym konturze lub wpisz jego szerokość – Ctrl wyłącza przyciąganie, Esc cofa kliknięcie</translation>
    </message>
    <message>
        <source>Click an outline where the mouth of the dart begins – Esc ends the tool</source>
        <translation>Kliknij kontur tam, gdzie zaczyna się rozwarcie zaszewki – Esc kończy</translation>
    </message>
</context>
<context>
    <name>DescribedField</name>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
</context>
<context>
    <name>DesignCuttingSection</name>
    <message>
        <source>Cutting</source>
        <translation>Krojenie</translation>
    </message>
    <message>
        <source>Seam allowance of all patches</source>
        <translation>Naddatek wszystkich elementów</translation>
    </message>
    <message>
        <source>Depth of notches</source>
        <translation>Głębokość nacięć</translation>
    </message>
    <message>
        <source>Width of notches</source>
        <translation>Szerokość nacięć</translation>
    </message>
</context>
<context>
    <name>Docks</name>
    <message>
        <source>Pattern</source>
        <translation>Wykrój</translation>
    </message>
    <message>
        <source>Cover</source>
        <translation>Pokrowiec</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Obiekty</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historia</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Właściwości</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemy</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Szwy</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Materiały</translation>
    </message>
    <message>
        <source>Worst spots</source>
        <translation>Najgorsze miejsca</translation>
    </message>
    <message>
        <source>Check before cutting</source>
        <translation>Kontrola przed krojeniem</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Zadania</translation>
    </message>
</context>
<context>
    <name>DrawingCommands</name>
    <message>
        <source>&amp;Grid and snapping</source>
        <translation>&amp;Siatka i przyciąganie</translation>
    </message>
    <message>
        <source>S&amp;napping</source>
        <translation>P&amp;rzyciąganie</translation>
    </message>
    <message>
        <source>&amp;Rulers</source>
        <translation>&amp;Linijki</translation>
    </message>
    <message>
        <source>Gui&amp;des</source>
        <translation>Pro&amp;wadnice</translation>
    </message>
    <message>
        <source>Remove all g&amp;uides</source>
        <translation>&amp;Usuń wszystkie prowadnice</translation>
    </message>
    <message>
        <source>Select with a &amp;loop</source>
        <translation>Zaznacz &amp;pętlą</translation>
    </message>
    <message>
        <source>&amp;Background picture</source>
        <translation>O&amp;braz tła</translation>
    </message>
    <message>
        <source>&amp;Open picture …</source>
        <translation>&amp;Otwórz obraz…</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>&amp;Pokaż</translation>
    </message>
    <message>
        <source>&amp;Scale by two points</source>
        <translation>&amp;Skaluj według dwóch punktów</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>Przesu&amp;ń</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Usuń</translation>
    </message>
    <message>
        <source>Opacity %1</source>
        <translation>Krycie %1</translation>
    </message>
    <message>
        <source>Open a picture to trace</source>
        <translation>Otwórz obraz do obrysowania</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.webp);;All files (*)</source>
        <translation>Obrazy (*.png *.jpg *.jpeg *.bmp *.webp);;Wszystkie pliki (*)</translation>
    </message>
</context>
<context>
    <name>DrawingKeys</name>
    <message>
        <source>&amp;Finish</source>
        <translation>&amp;Zakończ</translation>
    </message>
    <message>
        <source>&amp;Take back the last point</source>
        <translation>&amp;Cofnij ostatni punkt</translation>
    </message>
    <message>
        <source>Switch between &amp;straight and smooth</source>
        <translation>Prze&amp;łącz: prosta lub gładka</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>&amp;Porzuć</translation>
    </message>
</context>
<context>
    <name>DrillHoleForm</name>
    <message>
        <source>Patch</source>
        <translation>Element</translation>
    </message>
</context>
<context>
    <name>EdgeAllowanceForm</name>
    <message>
        <source>Outline</source>
        <translation>Kontur</translation>
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
        <translation>&amp;Cofnij</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Ponów</translation>
    </message>
    <message>
        <source>Name this &amp;branch …</source>
        <translation>Nazwij tę &amp;gałąź…</translation>
    </message>
    <message>
        <source>Name the way that the history has gone since it forked</source>
        <translation>Nadaje nazwę drodze, którą historia poszła od rozgałęzienia</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Z&amp;mień nazwę</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Usuń</translation>
    </message>
    <message>
        <source>Select &amp;all patches</source>
        <translation>Z&amp;aznacz wszystkie elementy</translation>
    </message>
    <message>
        <source>Select n&amp;othing</source>
        <translation>&amp;Odznacz wszystko</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Cofnij: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Ponów: %1</translation>
    </message>
</context>
<context>
    <name>ElementText</name>
    <message>
        <source>missing element %1</source>
        <translation>brakujący obiekt %1</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>Elementy</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Szew</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Szwy</translation>
    </message>
    <message>
        <source>Fixation curve</source>
        <translation>Krzywa mocowania</translation>
    </message>
    <message>
        <source>Fixation curves</source>
        <translation>Krzywe mocowania</translation>
    </message>
    <message>
        <source>Fixation</source>
        <translation>Mocowanie</translation>
    </message>
    <message>
        <source>Fixations</source>
        <translation>Mocowania</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Stelaż</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Stelaże</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Materiał</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Materiały</translation>
    </message>
    <message>
        <source>Unusable element</source>
        <translation>Obiekt bezużyteczny</translation>
    </message>
    <message>
        <source>Unusable elements</source>
        <translation>Obiekty bezużyteczne</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>%1 and %2, ease %3</source>
        <translation>%1 i %2, wdanie %3</translation>
    </message>
    <message>
        <source>%1, normal held</source>
        <translation>%1, normalna ustalona</translation>
    </message>
    <message>
        <source>Handle curve</source>
        <translation>Krzywa sterująca</translation>
    </message>
    <message>
        <source>Handle curves</source>
        <translation>Krzywe sterujące</translation>
    </message>
    <message>
        <source>Fancy seam</source>
        <translation>Szew ozdobny</translation>
    </message>
    <message>
        <source>Fancy seams</source>
        <translation>Szwy ozdobne</translation>
    </message>
    <message>
        <source>Cushion</source>
        <translation>Wyściółka</translation>
    </message>
    <message>
        <source>Cushions</source>
        <translation>Wyściółki</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>Pianka</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Skan</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Skany</translation>
    </message>
    <message>
        <source>%1 patches</source>
        <translation>elementy: %1</translation>
    </message>
    <message>
        <source>%1 seams</source>
        <translation>szwy: %1</translation>
    </message>
    <message>
        <source>%1 fixation curves</source>
        <translation>krzywe mocowania: %1</translation>
    </message>
    <message>
        <source>%1 fixations</source>
        <translation>mocowania: %1</translation>
    </message>
    <message>
        <source>%1 handle curves</source>
        <translation>krzywe sterujące: %1</translation>
    </message>
    <message>
        <source>%1 fancy seams</source>
        <translation>szwy ozdobne: %1</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>stelaże: %1</translation>
    </message>
    <message>
        <source>%1 cushions</source>
        <translation>wyściółki: %1</translation>
    </message>
    <message>
        <source>%1 pieces of foam</source>
        <translation>bryły pianki: %1</translation>
    </message>
    <message>
        <source>%1 scans</source>
        <translation>skany: %1</translation>
    </message>
    <message>
        <source>%1 fabrics</source>
        <translation>materiały: %1</translation>
    </message>
    <message>
        <source>%1 unusable elements</source>
        <translation>obiekty bezużyteczne: %1</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>obiekty: %1</translation>
    </message>
    <message>
        <source>Trimmed edge</source>
        <translation>Krawędź wykończona</translation>
    </message>
    <message>
        <source>Trimmed edges</source>
        <translation>Krawędzie wykończone</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>Wariant kolorystyczny</translation>
    </message>
    <message>
        <source>Colourways</source>
        <translation>Warianty kolorystyczne</translation>
    </message>
    <message>
        <source>%1 trimmed edges</source>
        <translation>krawędzie wykończone: %1</translation>
    </message>
    <message>
        <source>%1 colourways</source>
        <translation>warianty kolorystyczne: %1</translation>
    </message>
    <message>
        <source>Edge of %1</source>
        <translation>Krawędź: %1</translation>
    </message>
    <message>
        <source>Allowance of an edge</source>
        <translation>Naddatek krawędzi</translation>
    </message>
    <message>
        <source>Allowances of edges</source>
        <translation>Naddatki krawędzi</translation>
    </message>
    <message>
        <source>%1 allowances of edges</source>
        <translation>naddatki krawędzi: %1</translation>
    </message>
    <message>
        <source>Corner of the cut line</source>
        <translation>Róg linii cięcia</translation>
    </message>
    <message>
        <source>Corners of the cut line</source>
        <translation>Rogi linii cięcia</translation>
    </message>
    <message>
        <source>%1 corners of the cut line</source>
        <translation>rogi linii cięcia: %1</translation>
    </message>
    <message>
        <source>Drill hole</source>
        <translation>Nawiert</translation>
    </message>
    <message>
        <source>Drill holes</source>
        <translation>Nawierty</translation>
    </message>
    <message>
        <source>%1 drill holes</source>
        <translation>nawierty: %1</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>Nacięcie</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Nacięcia</translation>
    </message>
    <message>
        <source>%1 notches</source>
        <translation>nacięcia: %1</translation>
    </message>
    <message>
        <source>Internal line</source>
        <translation>Linia wewnętrzna</translation>
    </message>
    <message>
        <source>Internal lines</source>
        <translation>Linie wewnętrzne</translation>
    </message>
    <message>
        <source>%1 internal lines</source>
        <translation>linie wewnętrzne: %1</translation>
    </message>
    <message>
        <source>%1, allowance %2</source>
        <translation>%1, naddatek %2</translation>
    </message>
    <message>
        <source>Notch of %1</source>
        <translation>Nacięcie: %1</translation>
    </message>
    <message>
        <source>Corner of %1</source>
        <translation>Róg: %1</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Pomiar</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Pomiary</translation>
    </message>
    <message>
        <source>%1 measurements</source>
        <translation>pomiary: %1</translation>
    </message>
</context>
<context>
    <name>ElementsModel</name>
    <message>
        <source>edge %1</source>
        <translation>krawędź %1</translation>
    </message>
    <message>
        <source>%1 from the corner</source>
        <translation>%1 od rogu</translation>
    </message>
</context>
<context>
    <name>FabricForm</name>
    <message>
        <source>Weft</source>
        <translation>Wątek</translation>
    </message>
    <message>
        <source>Creases</source>
        <translation>Bruzdy</translation>
    </message>
    <message>
        <source>Depth of the pile</source>
        <translation>Wysokość włosa</translation>
    </message>
    <message>
        <source>Other squares</source>
        <translation>Pozostałe pola</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>Squares</source>
        <translation>Pola</translation>
    </message>
    <message>
        <source>Grain size</source>
        <translation>Wielkość groszku</translation>
    </message>
    <message>
        <source>Repeat of the weave</source>
        <translation>Raport splotu</translation>
    </message>
    <message>
        <source>Nap</source>
        <translation>Włos</translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation>Szerokość obrazu</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>Zachowanie</translation>
    </message>
    <message>
        <source>The fabric on a cushion and on a ball</source>
        <translation>Materiał na poduszce i na kuli</translation>
    </message>
    <message>
        <source>The fabric on a cushion and on a ball, at its real scale</source>
        <translation>Materiał na poduszce i na kuli, w rzeczywistej skali</translation>
    </message>
    <message>
        <source>Colour of the fabric</source>
        <translation>Kolor materiału</translation>
    </message>
    <message>
        <source>Second colour of the fabric</source>
        <translation>Drugi kolor materiału</translation>
    </message>
    <message>
        <source>From the first colour</source>
        <translation>Z pierwszego koloru</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Plik</translation>
    </message>
    <message>
        <source>Choose an&amp;other picture …</source>
        <translation>Wy&amp;bierz inny obraz…</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Krojenie</translation>
    </message>
</context>
<context>
    <name>FabricMenu</name>
    <message>
        <source>&amp;New fabric</source>
        <translation>&amp;Nowy materiał</translation>
    </message>
    <message>
        <source>Adds leather, weave, velvet or another fabric to the library of the design</source>
        <translation>Dodaje do biblioteki modelu skórę, tkaninę, welur lub inny materiał</translation>
    </message>
    <message>
        <source>From a &amp;picture …</source>
        <translation>Z &amp;obrazu…</translation>
    </message>
    <message>
        <source>A fabric that looks like a picture: PNG, JPEG, TIFF or OpenEXR</source>
        <translation>Materiał wyglądający jak obraz: PNG, JPEG, TIFF lub OpenEXR</translation>
    </message>
    <message>
        <source>&amp;Assign to selection</source>
        <translation>&amp;Przypisz do zaznaczenia</translation>
    </message>
    <message>
        <source>Gives the selected patches the fabric that is chosen in the library</source>
        <translation>Nadaje zaznaczonym elementom materiał wybrany w bibliotece</translation>
    </message>
    <message>
        <source>Fabric p&amp;roperties</source>
        <translation>&amp;Właściwości materiału</translation>
    </message>
    <message>
        <source>Shows kind, colours, size and limits of the fabric</source>
        <translation>Pokazuje rodzaj, kolory, rozmiar i granice materiału</translation>
    </message>
    <message>
        <source>Picture on the &amp;fabric …</source>
        <translation>Obraz na &amp;materiale…</translation>
    </message>
    <message>
        <source>Lets the fabric look like a picture: PNG, JPEG, TIFF or OpenEXR</source>
        <translation>Nadaje materiałowi wygląd obrazu: PNG, JPEG, TIFF lub OpenEXR</translation>
    </message>
    <message>
        <source>D&amp;uplicate fabric</source>
        <translation>Powiel ma&amp;teriał</translation>
    </message>
    <message>
        <source>Adds a copy of the fabric, to be changed</source>
        <translation>Dodaje kopię materiału do zmiany</translation>
    </message>
    <message>
        <source>Rename fa&amp;bric …</source>
        <translation>Zmień na&amp;zwę materiału…</translation>
    </message>
    <message>
        <source>Gives the fabric another name</source>
        <translation>Nadaje materiałowi inną nazwę</translation>
    </message>
    <message>
        <source>&amp;Delete fabric …</source>
        <translation>&amp;Usuń materiał…</translation>
    </message>
    <message>
        <source>Removes the fabric; asks what patches get instead</source>
        <translation>Usuwa materiał; pyta, co elementy mają dostać w zamian</translation>
    </message>
    <message>
        <source>&amp;Import fabrics …</source>
        <translation>&amp;Importuj materiały…</translation>
    </message>
    <message>
        <source>Takes over the fabrics of a file, a design or a project</source>
        <translation>Przejmuje materiały z pliku, modelu lub projektu</translation>
    </message>
    <message>
        <source>&amp;Export fabric …</source>
        <translation>&amp;Eksportuj materiał…</translation>
    </message>
    <message>
        <source>Writes the fabric to a file, its picture beside it</source>
        <translation>Zapisuje materiał do pliku, a obok jego obraz</translation>
    </message>
    <message>
        <source>Pre&amp;views</source>
        <translation>Po&amp;dgląd</translation>
    </message>
    <message>
        <source>On &amp;cushions</source>
        <translation>Na &amp;poduszkach</translation>
    </message>
    <message>
        <source>Shows the fabrics of the library on cushions</source>
        <translation>Pokazuje materiały biblioteki na poduszkach</translation>
    </message>
    <message>
        <source>On &amp;balls</source>
        <translation>Na &amp;kulach</translation>
    </message>
    <message>
        <source>Shows the fabrics of the library on balls</source>
        <translation>Pokazuje materiały biblioteki na kulach</translation>
    </message>
    <message>
        <source>&amp;Show colourway</source>
        <translation>Pokaż w&amp;ariant kolorystyczny</translation>
    </message>
    <message>
        <source>Chooses which fabrics are seen; the shape stays</source>
        <translation>Wybiera widoczne materiały; kształt się nie zmienia</translation>
    </message>
    <message>
        <source>New &amp;colourway …</source>
        <translation>Nowy wariant &amp;kolorystyczny…</translation>
    </message>
    <message>
        <source>Adds a set of fabrics for the patches; it begins as what is shown now</source>
        <translation>Dodaje zestaw materiałów dla elementów; zaczyna od tego, co teraz widać</translation>
    </message>
    <message>
        <source>Rena&amp;me colourway …</source>
        <translation>Zmień nazwę wa&amp;riantu…</translation>
    </message>
    <message>
        <source>Gives the colourway that is shown another name</source>
        <translation>Nadaje pokazanemu wariantowi inną nazwę</translation>
    </message>
    <message>
        <source>De&amp;lete colourway</source>
        <translation>U&amp;suń wariant</translation>
    </message>
    <message>
        <source>Removes the colourway that is shown</source>
        <translation>Usuwa pokazany wariant kolorystyczny</translation>
    </message>
    <message>
        <source>Compare c&amp;olourways …</source>
        <translation>Porówna&amp;j warianty…</translation>
    </message>
    <message>
        <source>Shows two colourways side by side</source>
        <translation>Pokazuje dwa warianty kolorystyczne obok siebie</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>Jak wykonano</translation>
    </message>
</context>
<context>
    <name>FabricPresets</name>
    <message>
        <source>Leather, cognac</source>
        <translation>Skóra, koniak</translation>
    </message>
    <message>
        <source>Leather, black</source>
        <translation>Skóra, czarna</translation>
    </message>
    <message>
        <source>Leather, cream</source>
        <translation>Skóra, kremowa</translation>
    </message>
    <message>
        <source>Smooth leather, dark brown</source>
        <translation>Skóra gładka, ciemnobrązowa</translation>
    </message>
    <message>
        <source>Smooth leather, red</source>
        <translation>Skóra gładka, czerwona</translation>
    </message>
    <message>
        <source>Weave, grey</source>
        <translation>Tkanina, szara</translation>
    </message>
    <message>
        <source>Weave, blue</source>
        <translation>Tkanina, niebieska</translation>
    </message>
    <message>
        <source>Weave, sand</source>
        <translation>Tkanina, piaskowa</translation>
    </message>
    <message>
        <source>Velvet, green</source>
        <translation>Welur, zielony</translation>
    </message>
    <message>
        <source>Velvet, petrol</source>
        <translation>Welur, petrol</translation>
    </message>
    <message>
        <source>Checker, 20 mm</source>
        <translation>Szachownica, 20&#xa0;mm</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Gładki</translation>
    </message>
</context>
<context>
    <name>FancySeamForm</name>
    <message>
        <source>Patch</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Długość</translation>
    </message>
    <message>
        <source>It stands out: a welt.</source>
        <translation>Wystaje: to wałek.</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>Patch</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Materiał</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nazwa</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Materiały</translation>
    </message>
    <message>
        <source>Press harder</source>
        <translation>Wypychają mocniej</translation>
    </message>
    <message>
        <source>Press like straight ones</source>
        <translation>Wypychają jak proste</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Stelaż</translation>
    </message>
    <message>
        <source>Padded parts</source>
        <translation>Części wyściełane</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Wypycha</translation>
    </message>
    <message>
        <source>Smallest detail</source>
        <translation>Najmniejszy szczegół</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>Grubość wyściółki</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Siła</translation>
    </message>
    <message>
        <source>Slanted faces</source>
        <translation>Skośne ściany</translation>
    </message>
    <message>
        <source>Pushes the cover</source>
        <translation>Wypycha pokrowiec</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Gładki</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>Szachownica</translation>
    </message>
    <message>
        <source>Smooth leather</source>
        <translation>Skóra gładka</translation>
    </message>
    <message>
        <source>Grained leather</source>
        <translation>Skóra groszkowana</translation>
    </message>
    <message>
        <source>Woven</source>
        <translation>Tkanina</translation>
    </message>
    <message>
        <source>Velvet</source>
        <translation>Welur</translation>
    </message>
    <message>
        <source>Picture …</source>
        <translation>Obraz…</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Rodzaj</translation>
    </message>
    <message>
        <source>Second colour</source>
        <translation>Drugi kolor</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Chropowatość</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>Turned from the grain</source>
        <translation>Obrót względem nitki</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>Relief</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Plik</translation>
    </message>
    <message>
        <source>Most along the grain</source>
        <translation>Maks. wzdłuż nitki</translation>
    </message>
    <message>
        <source>Most across</source>
        <translation>Maks. w poprzek</translation>
    </message>
    <message>
        <source>Most shear</source>
        <translation>Maks. ścinanie</translation>
    </message>
    <message>
        <source>Poisson</source>
        <translation>Wsp. Poissona</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Sztywność</translation>
    </message>
    <message>
        <source>Bending length</source>
        <translation>Długość zginania</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Kolor</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Wygląd</translation>
    </message>
    <message>
        <source>Strain limits</source>
        <translation>Granice odkształceń</translation>
    </message>
    <message>
        <source>Mirror twin</source>
        <translation>Lustrzany bliźniak</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Krzywa</translation>
    </message>
    <message>
        <source>On the curve</source>
        <translation>Na krzywej</translation>
    </message>
    <message>
        <source>Curve runs backwards</source>
        <translation>Krzywa biegnie wstecz</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Kierunek</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Waga</translation>
    </message>
    <message>
        <source>Curve in space</source>
        <translation>Krzywa w przestrzeni</translation>
    </message>
    <message>
        <source>Round – a soft groove</source>
        <translation>Okrągły – miękki rowek</translation>
    </message>
    <message>
        <source>Sharp – a crease</source>
        <translation>Ostry – załamanie</translation>
    </message>
    <message>
        <source>Welt – between creases</source>
        <translation>Wałek – między załamaniami</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Szerokość</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Głębokość</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Położenie</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Obrót</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Kierunek nitki</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Ciśnienie</translation>
    </message>
    <message>
        <source>Wrong side out</source>
        <translation>Lewą stroną na wierzch</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Drewno</translation>
    </message>
    <message>
        <source>Metal</source>
        <translation>Metal</translation>
    </message>
    <message>
        <source>Plastic</source>
        <translation>Tworzywo sztuczne</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>Pianka</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Tworzywo</translation>
    </message>
    <message>
        <source>Keeps the cover outside</source>
        <translation>Nie wpuszcza pokrowca</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Odstęp</translation>
    </message>
    <message>
        <source>Hidden parts</source>
        <translation>Ukryte części</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Blok</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Walec</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kula</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Siatka</translation>
    </message>
    <message>
        <source>Cushion</source>
        <translation>Wyściółka</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Kształt</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Rozmiar</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Wycięte</translation>
    </message>
    <message>
        <source>Along the normal</source>
        <translation>Wzdłuż normalnej</translation>
    </message>
    <message>
        <source>To the point itself</source>
        <translation>Do samego punktu</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Próg</translation>
    </message>
    <message>
        <source>Fit the cover to it</source>
        <translation>Dopasuj pokrowiec</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Ciągnięcie</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Cięcia</translation>
    </message>
    <message>
        <source>C0 – an edge</source>
        <translation>C0 – krawędź</translation>
    </message>
    <message>
        <source>C1 – smooth, texture too</source>
        <translation>C1 – gładko, także wzór</translation>
    </message>
    <message>
        <source>G1 – rounded</source>
        <translation>G1 – zaokrąglenie</translation>
    </message>
    <message>
        <source>First stretch</source>
        <translation>Pierwszy odcinek</translation>
    </message>
    <message>
        <source>Second stretch</source>
        <translation>Drugi odcinek</translation>
    </message>
    <message>
        <source>Second side runs backwards</source>
        <translation>Druga strona wstecz</translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation>Ciągłość</translation>
    </message>
    <message>
        <source>Mesh edges</source>
        <translation>Krawędzie siatki</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symetria</translation>
    </message>
    <message>
        <source>Colourway shown</source>
        <translation>Pokazany wariant</translation>
    </message>
    <message>
        <source>Begins at</source>
        <translation>Początek</translation>
    </message>
    <message>
        <source>Ends at</source>
        <translation>Koniec</translation>
    </message>
    <message>
        <source>By length</source>
        <translation>Według długości</translation>
    </message>
    <message>
        <source>By parameter</source>
        <translation>Według parametru</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Parowanie</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Brak</translation>
    </message>
    <message>
        <source>Single row</source>
        <translation>Jeden rząd</translation>
    </message>
    <message>
        <source>Twin rows</source>
        <translation>Dwa rzędy</translation>
    </message>
    <message>
        <source>Stitches</source>
        <translation>Ściegi</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>Nić</translation>
    </message>
    <message>
        <source>Stitch length</source>
        <translation>Długość ściegu</translation>
    </message>
    <message>
        <source>Distance from the seam</source>
        <translation>Odległość od szwu</translation>
    </message>
    <message>
        <source>Thread width</source>
        <translation>Grubość nici</translation>
    </message>
    <message>
        <source>Radius (0: none)</source>
        <translation>Promień (0: brak)</translation>
    </message>
    <message>
        <source>Seam allowance</source>
        <translation>Naddatek na szew</translation>
    </message>
    <message>
        <source>The cover dips into the seam</source>
        <translation>Pokrowiec zagłębia się w szwie</translation>
    </message>
    <message>
        <source>Trim</source>
        <translation>Wykończenie</translation>
    </message>
    <message>
        <source> mm per unit</source>
        <translation> mm na jednostkę</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>The frame that is padded</source>
        <translation>Wyściełany stelaż</translation>
    </message>
    <message>
        <source>Which cover the padding presses outwards</source>
        <translation>Który pokrowiec wyściółka wypycha na zewnątrz</translation>
    </message>
    <message>
        <source>How finely the frame is looked at: what is thinner may stay without padding</source>
        <translation>Jak dokładnie badany jest stelaż: co jest cieńsze, może pozostać bez wyściółki</translation>
    </message>
    <message>
        <source>How thick the padding around the frame is</source>
        <translation>Grubość wyściółki wokół stelaża</translation>
    </message>
    <message>
        <source>How hard the padding presses the cover outwards; from about 2 on it gives no more</source>
        <translation>Jak mocno wyściółka wypycha pokrowiec; od około 2 więcej już nie daje</translation>
    </message>
    <message>
        <source>How padding presses that is aslant to width, depth and height: harder fills the cover more</source>
        <translation>Jak wypycha wyściółka ukośna do szerokości, głębokości i wysokości: mocniej bardziej wypełnia pokrowiec</translation>
    </message>
    <message>
        <source>How thick the padding around this foam is</source>
        <translation>Grubość wyściółki wokół tej pianki</translation>
    </message>
    <message>
        <source>How hard this foam presses the cover outwards; from about 2 on it gives no more</source>
        <translation>Jak mocno ta pianka wypycha pokrowiec; od około 2 więcej już nie daje</translation>
    </message>
    <message>
        <source>Takes this shape out of the cushion instead of adding it</source>
        <translation>Wycina ten kształt z wyściółki, zamiast go dodawać</translation>
    </message>
    <message>
        <source>as made</source>
        <translation>jak wykonano</translation>
    </message>
    <message>
        <source>Stitching</source>
        <translation>Stebnowanie</translation>
    </message>
    <message>
        <source>Thread colour</source>
        <translation>Kolor nici</translation>
    </message>
    <message>
        <source>Stitch distance</source>
        <translation>Odległość ściegu</translation>
    </message>
    <message>
        <source>Piping radius</source>
        <translation>Promień kedry</translation>
    </message>
    <message>
        <source>Piping fabric</source>
        <translation>Materiał kedry</translation>
    </message>
    <message>
        <source>Valley</source>
        <translation>Zagłębienie</translation>
    </message>
    <message>
        <source>Mitred – to a point</source>
        <translation>Na ucios – do szpica</translation>
    </message>
    <message>
        <source>Square – cut off</source>
        <translation>Prosto – ścięte</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>Zaokrąglone</translation>
    </message>
    <message>
        <source>Folded – lies under the piece</source>
        <translation>Podwinięte – leży pod elementem</translation>
    </message>
    <message>
        <source>Stepped</source>
        <translation>Schodkowe</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Naddatek</translation>
    </message>
    <message>
        <source>From the sewing line to the line where the fabric is cut.</source>
        <translation>Od linii szycia do linii, po której kroi się materiał.</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Rogi</translation>
    </message>
    <message>
        <source>Corners of the cut line</source>
        <translation>Rogi linii cięcia</translation>
    </message>
    <message>
        <source>as the design&apos;s</source>
        <translation>jak w modelu</translation>
    </message>
    <message>
        <source>Lies at</source>
        <translation>Położenie</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Róg</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Średnica</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Kreska</translation>
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
        <translation>Prostokąt</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>Nacięcie</translation>
    </message>
    <message>
        <source>Depth of notches</source>
        <translation>Głębokość nacięć</translation>
    </message>
    <message>
        <source>Width of notches</source>
        <translation>Szerokość nacięć</translation>
    </message>
    <message>
        <source>Notches along seams every</source>
        <translation>Nacięcia wzdłuż szwów co</translation>
    </message>
    <message>
        <source>Notches at ends of seams</source>
        <translation>Nacięcia na końcach szwów</translation>
    </message>
    <message>
        <source>Notches that tell halves apart</source>
        <translation>Nacięcia odróżniające połowy</translation>
    </message>
    <message>
        <source>Two side by side</source>
        <translation>Dwa obok siebie</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Krojenie</translation>
    </message>
    <message>
        <source>Label at</source>
        <translation>Opis w miejscu</translation>
    </message>
    <message>
        <source>Label turned by</source>
        <translation>Obrót opisu</translation>
    </message>
    <message>
        <source>Two ways – either end up</source>
        <translation>Dwa kierunki – dowolny koniec w górę</translation>
    </message>
    <message>
        <source>One way – one end up</source>
        <translation>Jeden kierunek – jednym końcem do góry</translation>
    </message>
    <message>
        <source>Any direction</source>
        <translation>Dowolny kierunek</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Liczba sztuk</translation>
    </message>
    <message>
        <source>Mirrored pair</source>
        <translation>Para lustrzana</translation>
    </message>
    <message>
        <source>Nap</source>
        <translation>Kierunek włosa</translation>
    </message>
    <message>
        <source>Grain may be off by</source>
        <translation>Dopuszczalne odchylenie nitki</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Uwaga</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Opis</translation>
    </message>
    <message>
        <source>where it finds room</source>
        <translation>gdzie jest miejsce</translation>
    </message>
    <message>
        <source>Usable width</source>
        <translation>Szerokość użytkowa</translation>
    </message>
    <message>
        <source>Shrinks along</source>
        <translation>Kurczy się wzdłuż</translation>
    </message>
    <message>
        <source>Pieces are cut so much larger along the grain that they have their size when the fabric has shrunk.</source>
        <translation>Elementy kroi się o tyle większe wzdłuż nitki, by po skurczeniu materiału miały swój wymiar.</translation>
    </message>
    <message>
        <source>Shrinks across</source>
        <translation>Kurczy się w poprzek</translation>
    </message>
    <message>
        <source>10 mm</source>
        <translation>10&#xa0;mm</translation>
    </message>
    <message>
        <source>Automatic notches</source>
        <translation>Nacięcia automatyczne</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Artykuł</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Wersja</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Rysowana</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cięta</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Pominięta</translation>
    </message>
    <message>
        <source>On the cutting table</source>
        <translation>Na stole krojczym</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Prowadnica</translation>
    </message>
    <message>
        <source>Top stitching</source>
        <translation>Stebnowanie</translation>
    </message>
    <message>
        <source>Tie-down strip</source>
        <translation>Pasek naciągowy</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Zagięcie</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>Przeznaczenie</translation>
    </message>
    <message>
        <source>Ease wanted</source>
        <translation>Żądane wdanie</translation>
    </message>
    <message>
        <source>How much longer the second side shall be than the first one: it is gathered when it is sewn.</source>
        <translation>O ile druga strona ma być dłuższa od pierwszej: przy szyciu zostaje wdana.</translation>
    </message>
    <message>
        <source>Bulge of the allowance</source>
        <translation>Zgrubienie naddatku</translation>
    </message>
    <message>
        <source>With a zip</source>
        <translation>Z zamkiem</translation>
    </message>
    <message>
        <source>A zip joins the two sides; the sewing sheet tells its length.</source>
        <translation>Obie strony łączy zamek błyskawiczny; jego długość podaje karta szycia.</translation>
    </message>
    <message>
        <source>Step in sewing</source>
        <translation>Kolejność szycia</translation>
    </message>
    <message>
        <source>Seams with a number are sewn first, smaller ones before larger ones. 0: as the program proposes it.</source>
        <translation>Szwy z numerem szyje się najpierw, mniejsze numery przed większymi. 0: według propozycji programu.</translation>
    </message>
    <message>
        <source>How near a point of the scan must be to pull at the cover. What the scan has not seen stays as the pattern makes it.</source>
        <translation>Jak blisko musi leżeć punkt skanu, by przyciągał pokrowiec. Czego skan nie objął, pozostaje takie, jak wynika z wykroju.</translation>
    </message>
    <message>
        <source>How firmly the scan pulls at the cover, against the pattern: more follows finer detail, and more of the noise.</source>
        <translation>Jak mocno skan przyciąga pokrowiec wbrew wykrojowi: mocniej oddaje drobniejsze szczegóły, ale i więcej szumu.</translation>
    </message>
    <message>
        <source>The cover is pulled to the scan. Without that it is only measured. Align the scan first.</source>
        <translation>Pokrowiec jest przyciągany do skanu. Bez tego odległość jest tylko mierzona. Najpierw wyrównaj skan.</translation>
    </message>
    <message>
        <source>To its surface: the cover may slide along it. To its points: it may not, which suits scans with few points.</source>
        <translation>Do powierzchni: pokrowiec może się po niej ślizgać. Do punktów: nie może, co odpowiada skanom z małą liczbą punktów.</translation>
    </message>
    <message>
        <source>For whoever works on the design: it changes neither the cover nor what is cut</source>
        <translation>Dla pracujących nad projektem: nie zmienia ani pokrowca, ani tego, co się kroi</translation>
    </message>
    <message>
        <source>Line on the label</source>
        <translation>Wiersz na etykiecie</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Od</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Do</translation>
    </message>
    <message>
        <source>A filling that presses from inside. 0.05 to 0.3 fills a cushion; at 1 most fabrics are stretched too far.</source>
        <translation>Wypełnienie, które naciska od środka. 0,05 do 0,3 wypełnia poduszkę; przy 1 większość tkanin jest zbyt rozciągnięta.</translation>
    </message>
    <message>
        <source>How long the edges of the triangles are: shorter ones show smaller folds, and take longer.</source>
        <translation>Jak długie są krawędzie trójkątów: krótsze pokazują drobniejsze fałdy i wymagają więcej czasu.</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nowy</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>&amp;Otwórz…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Zakoń&amp;cz</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Ostatnio o&amp;twarte</translation>
    </message>
    <message>
        <source>&amp;Unsaved work</source>
        <translation>Nie&amp;zapisana praca</translation>
    </message>
    <message>
        <source>Sa&amp;mples</source>
        <translation>Prz&amp;ykłady</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>Zapi&amp;sz</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>Zapisz j&amp;ako…</translation>
    </message>
    <message>
        <source>Save a &amp;copy</source>
        <translation>Zapisz &amp;kopię</translation>
    </message>
    <message>
        <source>With &amp;everything …</source>
        <translation>Ze &amp;wszystkim…</translation>
    </message>
    <message>
        <source>Without &amp;history …</source>
        <translation>Bez &amp;historii…</translation>
    </message>
    <message>
        <source>Without history and &amp;scans …</source>
        <translation>Bez historii i &amp;skanów…</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>P&amp;rzywróć zapisane</translation>
    </message>
    <message>
        <source>&amp;Import frame …</source>
        <translation>&amp;Importuj stelaż…</translation>
    </message>
    <message>
        <source>Impor&amp;t scan …</source>
        <translation>I&amp;mportuj skan…</translation>
    </message>
    <message>
        <source>&amp;Export surface …</source>
        <translation>&amp;Eksportuj powierzchnię…</translation>
    </message>
    <message>
        <source>Export &amp;picture …</source>
        <translation>Eksportuj o&amp;braz…</translation>
    </message>
    <message>
        <source>Ren&amp;der picture …</source>
        <translation>Ren&amp;deruj obraz…</translation>
    </message>
    <message>
        <source>E&amp;xport pattern …</source>
        <translation>Eksportuj &amp;wykrój…</translation>
    </message>
    <message>
        <source>Import pattern (DX&amp;F, SVG) …</source>
        <translation>Importuj wykrój (DX&amp;F, SVG)…</translation>
    </message>
    <message>
        <source>Export cover (&amp;HTML, glTF, STL) …</source>
        <translation>Eksportuj pokrowiec (&amp;HTML, glTF, STL)…</translation>
    </message>
    <message>
        <source>Export foam &amp;body …</source>
        <translation>Eksportuj bryłę &amp;pianki…</translation>
    </message>
    <message>
        <source>Print view …</source>
        <translation>Drukuj widok…</translation>
    </message>
</context>
<context>
    <name>FileFormats</name>
    <message>
        <source>Page for the customer</source>
        <translation>Strona dla klienta</translation>
    </message>
    <message>
        <source>USDZ, for phones</source>
        <translation>USDZ, dla telefonów</translation>
    </message>
    <message>
        <source>OBJ with materials</source>
        <translation>OBJ z materiałami</translation>
    </message>
    <message>
        <source>STL, with a thickness</source>
        <translation>STL, z grubością</translation>
    </message>
    <message>
        <source>3MF, with a thickness</source>
        <translation>3MF, z grubością</translation>
    </message>
    <message>
        <source>STEP, curves alone</source>
        <translation>STEP, same krzywe</translation>
    </message>
    <message>
        <source>STEP, of flat faces</source>
        <translation>STEP, z płaskich ścian</translation>
    </message>
</context>
<context>
    <name>FixationCurveForm</name>
    <message>
        <source>Length</source>
        <translation>Długość</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkty</translation>
    </message>
</context>
<context>
    <name>FixationDrawTool</name>
    <message>
        <source>A curve needs two points, a closed one three.</source>
        <translation>Krzywa wymaga dwóch punktów, zamknięta – trzech.</translation>
    </message>
    <message>
        <source>Fixation %1</source>
        <translation>Mocowanie %1</translation>
    </message>
    <message>
        <source>Click to close the curve</source>
        <translation>Kliknij, aby zamknąć krzywą</translation>
    </message>
    <message>
        <source>There is neither a frame nor the cover here: click on one, or type x, y, z.</source>
        <translation>Nie ma tu stelaża ani pokrowca: kliknij na którymś z nich lub wpisz x, y, z.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no place: try 250, -100, 40</source>
        <translation>„%1” to nie położenie: spróbuj 250, -100, 40</translation>
    </message>
    <message>
        <source>Enter sets the point: x, y, z – without z it is as high as the last one</source>
        <translation>Enter stawia punkt: x, y, z – bez z leży tak wysoko jak ostatni</translation>
    </message>
    <message>
        <source>Click on a frame to begin a fixation curve, or type x, y, z – drag turns the view, Esc ends the tool</source>
        <translation>Kliknij stelaż, aby zacząć krzywą mocowania, lub wpisz x, y, z – przeciąganie obraca widok, Esc kończy</translation>
    </message>
    <message>
        <source>Click or type the next point, Enter ends, C closes – B makes it straight, Backspace takes a point back</source>
        <translation>Kliknij lub wpisz następny punkt, Enter kończy, C zamyka – B prostuje, Backspace cofa punkt</translation>
    </message>
    <message>
        <source>Click or type the next point, Enter ends, C closes – straight from point to point, whatever lies between: B makes it smooth along the surface, Backspace takes a point back</source>
        <translation>Kliknij lub wpisz następny punkt, Enter kończy, C zamyka – prosto od punktu do punktu, cokolwiek jest pomiędzy: B wygładza po powierzchni, Backspace cofa punkt</translation>
    </message>
    <message>
        <source>&amp;Close the curve</source>
        <translation>&amp;Zamknij krzywą</translation>
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
        <translation>Krzywa</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>On the curve</source>
        <translation>Na krzywej</translation>
    </message>
</context>
<context>
    <name>FixationsLeft</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>i jeszcze %n</numerusform>
            <numerusform>i jeszcze %n</numerusform>
            <numerusform>i jeszcze %n</numerusform>
        </translation>
    </message>
    <message>
        <source>They stay where they are. Drag their points onto the frame, or undo the change.</source>
        <translation>Zostają na swoim miejscu. Przeciągnij ich punkty na stelaż albo cofnij zmianę.</translation>
    </message>
    <message numerus="yes">
        <source>%n fixation curve(s) no longer lie on the frame.</source>
        <translation>
            <numerusform>%n krzywa mocowania nie leży już na stelażu.</numerusform>
            <numerusform>%n krzywe mocowania nie leżą już na stelażu.</numerusform>
            <numerusform>%n krzywych mocowania nie leży już na stelażu.</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1”: its edge is up to %2 away</source>
        <translation>„%1”: krawędź oddalona do %2</translation>
    </message>
    <message>
        <source>“%1”: up to %2</source>
        <translation>„%1”: do %2</translation>
    </message>
    <message>
        <source>“%1”: more than %2</source>
        <translation>„%1”: ponad %2</translation>
    </message>
</context>
<context>
    <name>FixingCommands</name>
    <message>
        <source>&amp;Create fixation curve</source>
        <translation>&amp;Utwórz krzywą mocowania</translation>
    </message>
    <message>
        <source>Select two points of an outline first: what lies between them is fixed.</source>
        <translation>Najpierw zaznacz dwa punkty konturu: mocowane jest to, co leży pomiędzy nimi.</translation>
    </message>
    <message>
        <source>Fixation %1</source>
        <translation>Mocowanie %1</translation>
    </message>
    <message>
        <source>There is no surface of this patch yet on which the curve could lie.</source>
        <translation>Ten element nie ma jeszcze powierzchni, na której mogłaby leżeć krzywa.</translation>
    </message>
</context>
<context>
    <name>FoamForm</name>
    <message>
        <source>File</source>
        <translation>Plik</translation>
    </message>
</context>
<context>
    <name>FormPatternReport</name>
    <message numerus="yes">
        <source>(and %n more)</source>
        <translation>
            <numerusform>(i %n więcej)</numerusform>
            <numerusform>(i %n więcej)</numerusform>
            <numerusform>(i %n więcej)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n element</numerusform>
            <numerusform>%n elementy</numerusform>
            <numerusform>%n elementów</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seams, whose sides are equally long</source>
        <translation>
            <numerusform>%n szew, strony są równej długości</numerusform>
            <numerusform>%n szwy, strony są równej długości</numerusform>
            <numerusform>%n szwów, strony są równej długości</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seams, whose sides differ by %1 at most</source>
        <translation>
            <numerusform>%n szew, strony różnią się najwyżej o %1</numerusform>
            <numerusform>%n szwy, strony różnią się najwyżej o %1</numerusform>
            <numerusform>%n szwów, strony różnią się najwyżej o %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Its cover at rest lies up to %1 beside the form, where nothing holds it: tick &quot;Keeps the cover outside&quot; at the frame, or hold it by a fixation.</source>
        <translation>Jego pokrowiec w spoczynku leży do %1 obok formy, tam gdzie nic go nie trzyma: zaznacz przy stelażu „Nie wpuszcza pokrowca” albo przytrzymaj go mocowaniem.</translation>
    </message>
    <message>
        <source>Its cover at rest lies up to %1 beside the form, where nothing holds it: hold it by a fixation, or give its pieces pressure.</source>
        <translation>Jego pokrowiec w spoczynku leży do %1 obok formy, tam gdzie nic go nie trzyma: przytrzymaj go mocowaniem albo nadaj jego elementom ciśnienie.</translation>
    </message>
    <message>
        <source>Its cover is being solved …</source>
        <translation>Obliczany jest jego pokrowiec …</translation>
    </message>
    <message>
        <source>Its cover does not come to rest.</source>
        <translation>Jego pokrowiec nie dochodzi do spoczynku.</translation>
    </message>
    <message>
        <source>Its cover at rest is strained no more than the fabric may be.</source>
        <translation>Jego pokrowiec w spoczynku nie jest bardziej rozciągnięty, niż pozwala tkanina.</translation>
    </message>
    <message>
        <source>What counts is its cover at rest: %1</source>
        <translation>Liczy się jego pokrowiec w spoczynku: %1</translation>
    </message>
    <message>
        <source>Laid on the form by itself no piece is strained so much. Narrow tips and steps of a line do that, or mesh edges that are long for them.</source>
        <translation>Sam położony na formie żaden kawałek nie jest tak odkształcony. Powodują to wąskie czubki i stopnie linii albo krawędzie siatki za długie dla nich.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more are left out, too</source>
        <translation>
            <numerusform>i pominięto jeszcze %n</numerusform>
            <numerusform>i pominięto jeszcze %n</numerusform>
            <numerusform>i pominięto jeszcze %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Laid on the form by itself most strained: %1, %2 (rms), %3 within 99 % of its area, %4 where it is most</source>
        <translation>Sam położony na formie najbardziej odkształcony: %1, %2 (RMS), %3 na 99 % powierzchni, %4 w najgorszym miejscu</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces are strained by more than the fabric may be in more than a hundredth of their area (yellow): divide them, or cut them in there.</source>
        <translation>
            <numerusform>%n element jest na ponad jednej setnej powierzchni odkształcony bardziej, niż pozwala materiał (żółty): podziel go lub tam natnij.</numerusform>
            <numerusform>%n elementy są na ponad jednej setnej powierzchni odkształcone bardziej, niż pozwala materiał (żółte): podziel je lub tam natnij.</numerusform>
            <numerusform>%n elementów jest na ponad jednej setnej powierzchni odkształconych bardziej, niż pozwala materiał (żółte): podziel je lub tam natnij.</numerusform>
        </translation>
    </message>
    <message>
        <source>Its cover will have about %1 vertices, and is not solved here: with mesh edges of %2 it is.</source>
        <translation>Jego pokrowiec będzie mieć około %1 wierzchołków i nie jest tu liczony: z krawędziami siatki %2 będzie.</translation>
    </message>
    <message>
        <source>So that the cover does not sink into the frame, tick &quot;Keeps the cover outside&quot; at the frame.</source>
        <translation>Aby pokrowiec nie zapadał się w stelaż, zaznacz przy stelażu „Nie wpuszcza pokrowca”.</translation>
    </message>
    <message>
        <source>With shorter mesh edges smaller pieces are divided, too.</source>
        <translation>Przy krótszych krawędziach siatki dzielone są też mniejsze elementy.</translation>
    </message>
    <message>
        <source>Tick &quot;where it would not lie flat&quot;: that finds where to divide them.</source>
        <translation>Zaznacz „tam, gdzie nie leżałaby płasko”: to znajdzie, gdzie je podzielić.</translation>
    </message>
    <message>
        <source>The form is taken as %1 large. If that is wrong, import the file as a frame.</source>
        <translation>Przyjęto, że forma ma wymiary %1. Jeśli to błąd, proszę zaimportować plik jako stelaż.</translation>
    </message>
</context>
<context>
    <name>FrameEdgeCommands</name>
    <message>
        <source>Fixation curve along an &amp;edge</source>
        <translation>Krzywa mocowania na kra&amp;wędzi</translation>
    </message>
    <message>
        <source>Click an edge of a frame: of STEP and IGES the edges of its faces, exactly; of others where their triangles bend</source>
        <translation>Kliknij krawędź stelaża: w plikach STEP i IGES dokładne krawędzie ścian, w innych miejsca załamania trójkątów</translation>
    </message>
    <message>
        <source>Looking for the edges of the frames …</source>
        <translation>Wyszukiwanie krawędzi stelaży…</translation>
    </message>
    <message>
        <source>The frames have no edges: they are smooth everywhere, or are not read yet.</source>
        <translation>Stelaże nie mają krawędzi: są wszędzie gładkie lub jeszcze nie wczytane.</translation>
    </message>
</context>
<context>
    <name>FrameEdgeTool</name>
    <message>
        <source>Fixation %1</source>
        <translation>Mocowanie %1</translation>
    </message>
    <message>
        <source>Click an edge of a frame to make a fixation curve of it – drag turns the view, Esc ends the tool</source>
        <translation>Kliknij krawędź stelaża, aby zrobić z niej krzywą mocowania – przeciąganie obraca widok, Esc kończy</translation>
    </message>
    <message>
        <source>Click to make a fixation curve of this edge – Ctrl takes it alone, without those in which it goes on smoothly</source>
        <translation>Kliknij, aby zrobić z tej krawędzi krzywą mocowania – Ctrl bierze ją samą, bez gładkich przedłużeń</translation>
    </message>
    <message>
        <source>There is no edge of a frame here. A curve of your own: Frame &gt; Draw fixation curve.</source>
        <translation>Tu nie ma krawędzi stelaża. Własna krzywa: Stelaż &gt; Rysuj krzywą mocowania.</translation>
    </message>
</context>
<context>
    <name>FrameForm</name>
    <message>
        <source>File</source>
        <translation>Plik</translation>
    </message>
    <message>
        <source>Choose an&amp;other file …</source>
        <translation>Wy&amp;bierz inny plik…</translation>
    </message>
    <message>
        <source>Colour of the frame</source>
        <translation>Kolor stelaża</translation>
    </message>
</context>
<context>
    <name>FrameParts</name>
    <message>
        <source>Mesh</source>
        <translation>Siatka</translation>
    </message>
    <message>
        <source>Piece %1: %2</source>
        <translation>Kawałek %1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n piece(s)</source>
        <translation>
            <numerusform>%1: %n kawałek</numerusform>
            <numerusform>%1: %n kawałki</numerusform>
            <numerusform>%1: %n kawałków</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Części</translation>
    </message>
    <message>
        <source>Show a&amp;ll parts</source>
        <translation>Pokaż &amp;wszystkie części</translation>
    </message>
    <message>
        <source>Parts without a mark are left out: they are not drawn, and neither drawing along the frame nor cushioning nor contact knows them.</source>
        <translation>Części bez znacznika są pomijane: nie są rysowane, nie uwzględnia ich też rysowanie po stelażu, wyściółka ani kontakt.</translation>
    </message>
    <message>
        <source>%1: not in this frame</source>
        <translation>%1: nie ma w tym stelażu</translation>
    </message>
    <message>
        <source>Padded parts</source>
        <translation>Części wyściełane</translation>
    </message>
    <message>
        <source>Without a mark, those parts are padded that the cover is fixed to.</source>
        <translation>Bez znaczników wyściełane są części, do których zamocowany jest pokrowiec.</translation>
    </message>
    <message>
        <source>This frame is large: the smallest detail can be %1 here.</source>
        <translation>Ten stelaż jest duży: najmniejszy szczegół może tu wynosić %1.</translation>
    </message>
</context>
<context>
    <name>HandleCurveForm</name>
    <message>
        <source>Patch</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>W wykroju</translation>
    </message>
    <message>
        <source>In space</source>
        <translation>W przestrzeni</translation>
    </message>
    <message>
        <source>free</source>
        <translation>wolna</translation>
    </message>
</context>
<context>
    <name>HelpCommands</name>
    <message>
        <source>&amp;Find a command …</source>
        <translation>&amp;Znajdź polecenie…</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse …</source>
        <translation>&amp;Klawisze i mysz…</translation>
    </message>
    <message>
        <source>&amp;Edit shortcuts …</source>
        <translation>&amp;Edytuj skróty…</translation>
    </message>
    <message>
        <source>&amp;About Bolster</source>
        <translation>&amp;O programie Bolster</translation>
    </message>
</context>
<context>
    <name>HelpDialogs</name>
    <message>
        <source>Select</source>
        <translation>Zaznacz</translation>
    </message>
    <message>
        <source>click; Shift+click adds; drag a box</source>
        <translation>kliknij; Shift+kliknięcie dodaje; przeciągnij ramkę</translation>
    </message>
    <message>
        <source>Move control points or patches</source>
        <translation>Przesuń punkty kontrolne lub elementy</translation>
    </message>
    <message>
        <source>drag; Shift keeps to one axis; Esc takes it back</source>
        <translation>przeciągnij; Shift trzyma się jednej osi; Esc cofa</translation>
    </message>
    <message>
        <source>Turn patches</source>
        <translation>Obróć elementy</translation>
    </message>
    <message>
        <source>drag the round handle; Shift in steps of 15°</source>
        <translation>przeciągnij okrągły uchwyt; Shift co 15°</translation>
    </message>
    <message>
        <source>Add a control point</source>
        <translation>Dodaj punkt kontrolny</translation>
    </message>
    <message>
        <source>arrow keys, Shift+arrow keys</source>
        <translation>strzałki, Shift+strzałki</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Przesuń widok</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Powiększ</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Obróć widok</translation>
    </message>
    <message>
        <source>A workbench for people who design upholstered furniture and car seats: a sewing pattern, its seams and its fixation on the frame become the cover, live.</source>
        <translation>Warsztat dla projektantów mebli tapicerowanych i foteli samochodowych: z wykroju, jego szwów i mocowania na stelażu na bieżąco powstaje pokrowiec.</translation>
    </message>
    <message>
        <source>The surface is computed after the published method of sewing patterns on static constraints; docs/solver.md names the paper and what is different.</source>
        <translation>Powierzchnia jest obliczana opublikowaną metodą wykrojów ze statycznymi więzami; docs/solver.md podaje artykuł i różnice.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. It comes without any warranty. Built with Qt, Eigen, CGAL, SuiteSparse, Embree and OpenImageIO.</source>
        <translation>Wolne oprogramowanie na licencji GNU General Public License w wersji 3 lub nowszej. Bez żadnej gwarancji. Zbudowane z użyciem Qt, Eigen, CGAL, SuiteSparse, Embree i OpenImageIO.</translation>
    </message>
    <message>
        <source>About Bolster</source>
        <translation>O programie Bolster</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>W wykroju</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>W widoku 3D</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Klawisze</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Klawisze i mysz</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1&#xa0;ms</translation>
    </message>
    <message>
        <source>Patches, seams</source>
        <translation>Elementy, szwy</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Vertices after sewing</source>
        <translation>Wierzchołki po zszyciu</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Trójkąty</translation>
    </message>
    <message>
        <source>Vertices held by fixations</source>
        <translation>Wierzchołki zamocowane</translation>
    </message>
    <message>
        <source>Sewn pairs</source>
        <translation>Zszyte pary</translation>
    </message>
    <message>
        <source>Largest gap at seams</source>
        <translation>Największa szczelina na szwach</translation>
    </message>
    <message>
        <source>Largest distance from fixations</source>
        <translation>Największa odległość od mocowań</translation>
    </message>
    <message>
        <source>Curves to fixed outlines between vertices</source>
        <translation>Od krzywych do zamocowanych konturów między wierzchołkami</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>Area of the cover, of the pattern</source>
        <translation>Pole pokrowca, wykroju</translation>
    </message>
    <message>
        <source>Turned triangles</source>
        <translation>Odwrócone trójkąty</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iteracje</translation>
    </message>
    <message>
        <source>Triangulation</source>
        <translation>Triangulacja</translation>
    </message>
    <message>
        <source>Assembly and factorisation</source>
        <translation>Układanie i faktoryzacja</translation>
    </message>
    <message>
        <source>One iteration</source>
        <translation>Jedna iteracja</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Siatka</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Powierzchnia</translation>
    </message>
    <message>
        <source>Computation</source>
        <translation>Obliczenia</translation>
    </message>
    <message>
        <source>Figures of the surface</source>
        <translation>Dane liczbowe powierzchni</translation>
    </message>
    <message>
        <source>Strain: root mean square, 99 %, largest</source>
        <translation>Odkształcenie: średnia kwadratowa, 99%, największe</translation>
    </message>
    <message>
        <source>double click on an outline or curve</source>
        <translation>dwukrotne kliknięcie konturu lub krzywej</translation>
    </message>
    <message>
        <source>Draw a handle curve or a fancy seam</source>
        <translation>Narysuj krzywą sterującą lub szew ozdobny</translation>
    </message>
    <message>
        <source>click points; Enter or double click ends; click the first one to close; B: straight or smooth</source>
        <translation>klikaj punkty; Enter lub dwukrotne kliknięcie kończy; kliknięcie pierwszego zamyka; B: prosto lub gładko</translation>
    </message>
    <message>
        <source>Move control points of curves</source>
        <translation>Przesuń punkty kontrolne krzywych</translation>
    </message>
    <message>
        <source>Sew</source>
        <translation>Zszyj</translation>
    </message>
    <message>
        <source>click two edges; drag or Shift+click takes a part of one; Ctrl+click several in a row, Enter sews them; F: flip</source>
        <translation>kliknij dwie krawędzie; przeciągnięcie lub Shift+kliknięcie bierze część; Ctrl+kliknięcie kilka w rzędzie, Enter zszywa; F: odwraca</translation>
    </message>
    <message>
        <source>Attach to the selected fixation curve</source>
        <translation>Zamocuj do zaznaczonej krzywej mocowania</translation>
    </message>
    <message>
        <source>Draw an outline</source>
        <translation>Narysuj kontur</translation>
    </message>
    <message>
        <source>click corners, drag smooth points, or type 500, 500&lt;30 or 120, 40; Enter or a click on the first point closes</source>
        <translation>klikaj rogi, przeciągaj gładkie punkty lub wpisz 500, 500&lt;30 albo 120, 40; Enter lub kliknięcie pierwszego punktu zamyka</translation>
    </message>
    <message>
        <source>Not snapped</source>
        <translation>Bez przyciągania</translation>
    </message>
    <message>
        <source>hold Ctrl or Alt</source>
        <translation>przytrzymaj Ctrl lub Alt</translation>
    </message>
    <message>
        <source>Select in a loop</source>
        <translation>Zaznacz pętlą</translation>
    </message>
    <message>
        <source>Alt and drag</source>
        <translation>Alt i przeciąganie</translation>
    </message>
    <message>
        <source>Next patch or control point, previous one</source>
        <translation>Następny element lub punkt kontrolny, poprzedni</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Shift+Tab</translation>
    </message>
    <message>
        <source>drag; those on a frame stay on it: Ctrl lifts them off, S lets go; X, Y, Z keep to an axis</source>
        <translation>przeciągnij; punkty na stelażu na nim zostają: Ctrl je unosi, S puszcza; X, Y, Z trzymają się osi</translation>
    </message>
    <message>
        <source>Draw a fixation curve</source>
        <translation>Narysuj krzywą mocowania</translation>
    </message>
    <message>
        <source>click points on a frame; Enter or double click ends; click the first one to close</source>
        <translation>klikaj punkty na stelażu; Enter lub dwukrotne kliknięcie kończy; kliknięcie pierwszego zamyka</translation>
    </message>
    <message>
        <source>Move the ends of a seam or fixation</source>
        <translation>Przesuń końce szwu lub mocowania</translation>
    </message>
    <message>
        <source>select it and drag the round handles at its ends</source>
        <translation>zaznacz i przeciągnij okrągłe uchwyty na końcach</translation>
    </message>
    <message>
        <source>Stitch or pipe a seam or an edge</source>
        <translation>Stebnuj szew lub krawędź albo dodaj kedrę</translation>
    </message>
    <message>
        <source>click it; stitches and piping are in the properties</source>
        <translation>kliknij; ściegi i kedra są we właściwościach</translation>
    </message>
    <message>
        <source>Select an edge</source>
        <translation>Zaznacz krawędź</translation>
    </message>
    <message>
        <source>click the outline; drag it then to move it; L types its length</source>
        <translation>kliknij kontur; przeciągnij, aby ją przesunąć; L: wpisz długość</translation>
    </message>
    <message>
        <source>Commands for what lies there</source>
        <translation>Polecenia dla tego, co tam leży</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>prawy przycisk</translation>
    </message>
    <message>
        <source>A number instead of a drag</source>
        <translation>Liczba zamiast przeciągania</translation>
    </message>
    <message>
        <source>type it while dragging: 50, 30, 20, for sizes 300 x 200 or 120 %; Enter lets go</source>
        <translation>wpisz podczas przeciągania: 50 albo 30, 20, rozmiary 300 x 200 lub 120 %; Enter puszcza</translation>
    </message>
    <message>
        <source>click edges; Shift+click collects several; Esc ends</source>
        <translation>klikaj krawędzie; Shift+kliknięcie zbiera kilka; Esc kończy</translation>
    </message>
    <message>
        <source>right button, without a drag</source>
        <translation>prawy przycisk, bez przeciągania</translation>
    </message>
    <message>
        <source>Move by %1, by %2</source>
        <translation>Przesuń o %1, o %2</translation>
    </message>
    <message>
        <source>%1, or Space and drag</source>
        <translation>%1 lub spacja i przeciąganie</translation>
    </message>
    <message>
        <source>%1, or drag beside the cover</source>
        <translation>%1 lub przeciąganie obok pokrowca</translation>
    </message>
</context>
<context>
    <name>Insert</name>
    <message>
        <source>Padding</source>
        <translation>Wyściółka</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>Pianka</translation>
    </message>
    <message>
        <source>This frame is large: its smallest detail is set to %1; the usual %2 would need too much memory.</source>
        <translation>Ten stelaż jest duży: jego najmniejszy szczegół ustawiono na %1; zwykłe %2 wymagałoby zbyt dużo pamięci.</translation>
    </message>
</context>
<context>
    <name>InsertCommands</name>
    <message>
        <source>&amp;Cushion</source>
        <translation>&amp;Wyściółka</translation>
    </message>
    <message>
        <source>&amp;Box of foam</source>
        <translation>&amp;Blok z pianki</translation>
    </message>
    <message>
        <source>C&amp;ylinder of foam</source>
        <translation>W&amp;alec z pianki</translation>
    </message>
    <message>
        <source>&amp;Sphere of foam</source>
        <translation>&amp;Kula z pianki</translation>
    </message>
    <message>
        <source>Foam belongs to a cushion: insert one first.</source>
        <translation>Pianka należy do wyściółki: najpierw ją wstaw.</translation>
    </message>
    <message>
        <source>Cushioning needs a frame: import one first.</source>
        <translation>Wyściółka wymaga stelaża: najpierw go zaimportuj.</translation>
    </message>
</context>
<context>
    <name>InspectorForms</name>
    <message numerus="yes">
        <source>%n elements</source>
        <translation>
            <numerusform>%n obiekt</numerusform>
            <numerusform>%n obiekty</numerusform>
            <numerusform>%n obiektów</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>InternalLineForm</name>
    <message>
        <source>Patch</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Długość</translation>
    </message>
</context>
<context>
    <name>InverseCommands</name>
    <message>
        <source>From a form …</source>
        <translation>Z formy…</translation>
    </message>
    <message>
        <source>Cuts a frame, a mesh or the cover into pieces, lays them flat and makes the pattern of them</source>
        <translation>Dzieli stelaż, siatkę lub pokrowiec na kawałki, rozkłada je na płasko i robi z nich wykrój</translation>
    </message>
    <message>
        <source>F&amp;it to a goal …</source>
        <translation>Dopasuj do &amp;celu…</translation>
    </message>
    <message>
        <source>Changes the pattern until the cover lies on a scan, or is strained less</source>
        <translation>Zmienia wykrój, aż pokrowiec legnie na skanie lub będzie mniej odkształcony</translation>
    </message>
    <message>
        <source>Relieve strain …</source>
        <translation>Zmniejsz odkształcenia…</translation>
    </message>
    <message>
        <source>Proposes changes of the pattern where cloth is strained too much, with what each gains</source>
        <translation>Proponuje zmiany wykroju tam, gdzie materiał jest zbyt odkształcony, i podaje zysk każdej z nich</translation>
    </message>
    <message>
        <source>Why is it so? …</source>
        <translation>Dlaczego tak jest?…</translation>
    </message>
    <message>
        <source>Which cause explains best how far the scan of a built piece lies from the cover</source>
        <translation>Która przyczyna najlepiej wyjaśnia odległość skanu wykonanej sztuki od pokrowca</translation>
    </message>
    <message>
        <source>Tolerances …</source>
        <translation>Tolerancje…</translation>
    </message>
    <message>
        <source>Where the cover varies from piece to piece, and which tolerance of making matters</source>
        <translation>Gdzie pokrowiec różni się między sztukami i która tolerancja wykonania ma znaczenie</translation>
    </message>
</context>
<context>
    <name>KeptMeasure</name>
    <message>
        <source>Measurement %1</source>
        <translation>Pomiar %1</translation>
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
        <translation>Przeciągnij opis tam, gdzie da się go odczytać – Shift trzyma się jednej osi, Ctrl wyłącza przyciąganie, Esc cofa</translation>
    </message>
</context>
<context>
    <name>LayerCommands</name>
    <message>
        <source>La&amp;yers</source>
        <translation>&amp;Warstwy</translation>
    </message>
    <message>
        <source>&amp;Triangulation</source>
        <translation>&amp;Triangulacja</translation>
    </message>
    <message>
        <source>Chec&amp;ker</source>
        <translation>Sza&amp;chownica</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>St&amp;elaż</translation>
    </message>
    <message>
        <source>Control po&amp;ints</source>
        <translation>&amp;Punkty kontrolne</translation>
    </message>
    <message>
        <source>Sea&amp;ms and fixations</source>
        <translation>S&amp;zwy i mocowania</translation>
    </message>
    <message>
        <source>Fixation c&amp;urves</source>
        <translation>&amp;Krzywe mocowania</translation>
    </message>
    <message>
        <source>&amp;Handle curves</source>
        <translation>K&amp;rzywe sterujące</translation>
    </message>
    <message>
        <source>Fanc&amp;y seams</source>
        <translation>Szwy &amp;ozdobne</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>Op&amp;isy</translation>
    </message>
    <message>
        <source>Sca&amp;ns</source>
        <translation>&amp;Skany</translation>
    </message>
    <message>
        <source>Gr&amp;ound</source>
        <translation>Po&amp;dłoże</translation>
    </message>
    <message>
        <source>Cushionin&amp;g</source>
        <translation>W&amp;yściółka</translation>
    </message>
    <message>
        <source>Mirror image of the &amp;selection</source>
        <translation>Od&amp;bicie lustrzane zaznaczenia</translation>
    </message>
    <message>
        <source>Symmetry &amp;axis and plane</source>
        <translation>Oś i płaszczyzna sy&amp;metrii</translation>
    </message>
    <message>
        <source>Pairs of co&amp;ver and scan</source>
        <translation>Pary pokro&amp;wiec–skan</translation>
    </message>
    <message>
        <source>Own &amp;colours of scans</source>
        <translation>Własne kolory ska&amp;nów</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>Si&amp;atka</translation>
    </message>
    <message>
        <source>Cut lines, notches and la&amp;bels</source>
        <translation>&amp;Linie cięcia, nacięcia i opisy</translation>
    </message>
    <message>
        <source>M&amp;easurements</source>
        <translation>Pomiar&amp;y</translation>
    </message>
</context>
<context>
    <name>MainMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>Pomo&amp;c</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Plik</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Edycja</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Widok</translation>
    </message>
    <message>
        <source>&amp;Pattern</source>
        <translation>Wy&amp;krój</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>P&amp;owierzchnia</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>Ok&amp;no</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>Ws&amp;taw</translation>
    </message>
    <message>
        <source>Sea&amp;m</source>
        <translation>&amp;Szew</translation>
    </message>
    <message>
        <source>F&amp;rame</source>
        <translation>Ste&amp;laż</translation>
    </message>
    <message>
        <source>F&amp;abric</source>
        <translation>&amp;Materiał</translation>
    </message>
    <message>
        <source>S&amp;can</source>
        <translation>Sk&amp;an</translation>
    </message>
</context>
<context>
    <name>ManualCommands</name>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Podręcznik</translation>
    </message>
    <message>
        <source>The page about what you are at</source>
        <translation>Strona o tym, co teraz robisz</translation>
    </message>
    <message>
        <source>The manual is not installed.</source>
        <translation>Podręcznik nie jest zainstalowany.</translation>
    </message>
    <message>
        <source>It is a folder &quot;manual&quot; with the program&apos;s other files.</source>
        <translation>To folder „manual” obok innych plików programu.</translation>
    </message>
</context>
<context>
    <name>MapCommands</name>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Mapa</translation>
    </message>
    <message>
        <source>&amp;Largest strain</source>
        <translation>&amp;Największe odkształcenie</translation>
    </message>
    <message>
        <source>Strain al&amp;ong the grain</source>
        <translation>Odkształcenie &amp;wzdłuż nitki</translation>
    </message>
    <message>
        <source>Strain a&amp;cross the grain</source>
        <translation>Odkształcenie w &amp;poprzek nitki</translation>
    </message>
    <message>
        <source>&amp;Shear</source>
        <translation>Ś&amp;cinanie</translation>
    </message>
    <message>
        <source>&amp;Mean curvature</source>
        <translation>Średnia &amp;krzywizna</translation>
    </message>
    <message>
        <source>Distance to the &amp;frame</source>
        <translation>Odległość od &amp;stelaża</translation>
    </message>
    <message>
        <source>&amp;Deviation from the scan</source>
        <translation>&amp;Odchyłka od skanu</translation>
    </message>
    <message>
        <source>&amp;Worst spots</source>
        <translation>Najgorsze m&amp;iejsca</translation>
    </message>
    <message>
        <source>Show worst spots as a l&amp;ist</source>
        <translation>Pokaż &amp;listę najgorszych miejsc</translation>
    </message>
    <message>
        <source>Show this place in both windows</source>
        <translation>Pokaż to miejsce w obu oknach</translation>
    </message>
    <message>
        <source>Choose a map of strain first</source>
        <translation>Najpierw wybierz mapę odkształceń</translation>
    </message>
</context>
<context>
    <name>MarkDrag</name>
    <message>
        <source>Drag it to where it belongs – Esc takes it back</source>
        <translation>Przeciągnij na właściwe miejsce – Esc cofa</translation>
    </message>
    <message>
        <source>Allowance of %1 – or type it; Ctrl for any width, Esc takes it back</source>
        <translation>Naddatek %1 – lub wpisz go; Ctrl pozwala na dowolną szerokość, Esc cofa</translation>
    </message>
    <message>
        <source>Drag it to where it belongs, or type its place: 120, 40 – Esc takes it back</source>
        <translation>Przeciągnij na właściwe miejsce lub wpisz położenie: 120, 40 – Esc cofa</translation>
    </message>
    <message>
        <source>Drag it along the outline, or type how far it is from the corner – Esc takes it back</source>
        <translation>Przeciągnij wzdłuż konturu lub wpisz odległość od rogu – Esc cofa</translation>
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
        <translation>Ta krawędź ma długość %1 – kliknij punkt, od którego mierzyć</translation>
    </message>
    <message>
        <source>Edge: %1</source>
        <translation>Krawędź: %1</translation>
    </message>
    <message>
        <source>Only a measurement between two points of patches can be kept.</source>
        <translation>Zachować można tylko pomiar między dwoma punktami elementów.</translation>
    </message>
    <message>
        <source>&amp;Keep the measurement</source>
        <translation>Za&amp;chowaj pomiar</translation>
    </message>
    <message>
        <source>%1 – Enter keeps the measurement, a click begins anew</source>
        <translation>%1 – Enter zachowuje pomiar, kliknięcie zaczyna od nowa</translation>
    </message>
    <message>
        <source>Click two points of the pattern or of the cover to measure, or point at an outline – Esc ends the tool</source>
        <translation>Kliknij dwa punkty wykroju lub pokrowca, aby zmierzyć, albo wskaż obrys – Esc kończy</translation>
    </message>
    <message>
        <source>%1 – a click begins anew</source>
        <translation>%1 – kliknięcie zaczyna od nowa</translation>
    </message>
</context>
<context>
    <name>MeasurementForm</name>
    <message>
        <source>From</source>
        <translation>Od</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Do</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>W wykroju</translation>
    </message>
    <message>
        <source>two patches</source>
        <translation>dwa elementy</translation>
    </message>
    <message>
        <source>On the cover</source>
        <translation>Na pokrowcu</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>jeszcze nie</translation>
    </message>
</context>
<context>
    <name>Message</name>
    <message>
        <source>the degree must be 1, 2 or 3, not %1</source>
        <translation>stopień musi wynosić 1, 2 lub 3, a nie %1</translation>
    </message>
    <message>
        <source>a closed curve needs at least %1 points, not %2</source>
        <translation>krzywa zamknięta wymaga co najmniej tylu punktów: %1, a ma %2</translation>
    </message>
    <message>
        <source>an open curve of this degree needs at least %1 points, not %2</source>
        <translation>krzywa otwarta tego stopnia wymaga co najmniej tylu punktów: %1, a ma %2</translation>
    </message>
    <message>
        <source>point %1 is no number or beyond 1e7 mm</source>
        <translation>punkt %1 nie jest liczbą lub wykracza poza 1e7&#xa0;mm</translation>
    </message>
    <message>
        <source>corners belong to closed curves of degree 3 only</source>
        <translation>rogi mają tylko krzywe zamknięte stopnia 3</translation>
    </message>
    <message>
        <source>the list of corners is empty; leave it out</source>
        <translation>lista rogów jest pusta; pomiń ją</translation>
    </message>
    <message>
        <source>corner %1 does not exist; the points are numbered 0 to %2</source>
        <translation>róg %1 nie istnieje; punkty mają numery od 0 do %2</translation>
    </message>
    <message>
        <source>the corners must increase, but %1 follows %2</source>
        <translation>rogi muszą rosnąć, a %1 następuje po %2</translation>
    </message>
    <message>
        <source>there must be at least two points between the corners %1 and %2 (a straight edge: at its thirds)</source>
        <translation>między rogami %1 i %2 muszą leżeć co najmniej dwa punkty (na prostej krawędzi: w jej trzecich częściach)</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text goes on after the design&apos;s last bracket; remove what follows</source>
        <translation>Wiersz %1, kolumna %2: po ostatnim nawiasie modelu jest dalszy tekst; usuń go</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text ends in the middle of the design; the file is incomplete</source>
        <translation>Wiersz %1, kolumna %2: tekst kończy się w środku modelu; plik jest niekompletny</translation>
    </message>
    <message>
        <source>Line %1, column %2: brackets are nested more than 64 deep; no design needs that</source>
        <translation>Wiersz %1, kolumna %2: nawiasy zagnieżdżone głębiej niż 64-krotnie; żaden model tego nie potrzebuje</translation>
    </message>
    <message>
        <source>Line %1, column %2: a value is expected here: a number, a text in quotes, true, false or a bracket (NaN and Infinity are no numbers)</source>
        <translation>Wiersz %1, kolumna %2: oczekiwano wartości: liczby, tekstu w cudzysłowie, true, false lub nawiasu (NaN i Infinity to nie liczby)</translation>
    </message>
    <message>
        <source>Line %1, column %2: a comma or &quot;]&quot; is missing here</source>
        <translation>Wiersz %1, kolumna %2: brakuje przecinka lub „]”</translation>
    </message>
    <message>
        <source>Line %1, column %2: a key in quotes is expected here</source>
        <translation>Wiersz %1, kolumna %2: oczekiwano klucza w cudzysłowie</translation>
    </message>
    <message>
        <source>Line %1, column %2: a colon is missing after the key</source>
        <translation>Wiersz %1, kolumna %2: po kluczu brakuje dwukropka</translation>
    </message>
    <message>
        <source>Line %1, column %2: a comma or &quot;}&quot; is missing here</source>
        <translation>Wiersz %1, kolumna %2: brakuje przecinka lub „}”</translation>
    </message>
    <message>
        <source>Line %1, column %2: a text in quotes must end on its line; a quote is missing</source>
        <translation>Wiersz %1, kolumna %2: tekst w cudzysłowie musi kończyć się w swoim wierszu; brakuje cudzysłowu</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is no valid escape; write a backslash as &quot;\\&quot;</source>
        <translation>Wiersz %1, kolumna %2: nieprawidłowa sekwencja; ukośnik odwrotny zapisz jako „\\”</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is not UTF-8; save the file in that encoding</source>
        <translation>Wiersz %1, kolumna %2: to nie jest UTF-8; zapisz plik w tym kodowaniu</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text ends inside quotes; the file is incomplete</source>
        <translation>Wiersz %1, kolumna %2: tekst kończy się wewnątrz cudzysłowu; plik jest niekompletny</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is no number; write it like 12.5, -3 or 1e-3</source>
        <translation>Wiersz %1, kolumna %2: to nie jest liczba; zapisz ją jak 12.5, -3 lub 1e-3</translation>
    </message>
    <message>
        <source>the text is larger than %1 MB; that is no design</source>
        <translation>tekst ma ponad %1&#xa0;MB; to nie jest model</translation>
    </message>
    <message>
        <source>knot %1 occurs more often than %2 times, the degree; remove the surplus ones</source>
        <translation>węzeł %1 występuje częściej niż stopień (%2); usuń nadmiarowe</translation>
    </message>
    <message>
        <source>the knots of an open curve must begin with %1 equal ones and end with %1 equal, larger ones</source>
        <translation>węzły krzywej otwartej muszą się zaczynać od równych (%1) i kończyć równymi, większymi (%1)</translation>
    </message>
    <message>
        <source>%1 points of degree %2 need %3 knots, not %4</source>
        <translation>liczba punktów %1 przy stopniu %2 wymaga %3 węzłów, a nie %4</translation>
    </message>
    <message>
        <source>a knot is no number or beyond 1e7</source>
        <translation>węzeł nie jest liczbą lub wykracza poza 1e7</translation>
    </message>
    <message>
        <source>the knots must not decrease</source>
        <translation>węzły nie mogą maleć</translation>
    </message>
    <message>
        <source>the last knot must be larger than the first</source>
        <translation>ostatni węzeł musi być większy od pierwszego</translation>
    </message>
    <message>
        <source>two knots near %1 are almost equal; make them equal</source>
        <translation>dwa węzły w pobliżu %1 są prawie równe; zrównaj je</translation>
    </message>
    <message>
        <source>there is not enough memory for this design</source>
        <translation>za mało pamięci na ten model</translation>
    </message>
    <message>
        <source>%1: the file promises more than it holds</source>
        <translation>%1: plik zapowiada więcej, niż zawiera</translation>
    </message>
    <message>
        <source>%1: the mesh is too large, the limit is %2 points and as many triangles</source>
        <translation>%1: siatka jest za duża; granica punktów to %2, trójkątów tyle samo</translation>
    </message>
    <message>
        <source>%1: the point is not finite, or beyond 10,000,000</source>
        <translation>%1: punkt nie jest skończony lub wykracza poza 10&#xa0;000&#xa0;000</translation>
    </message>
    <message>
        <source>%1: a face refers to point %2, but there are %3 points</source>
        <translation>%1: ściana odwołuje się do punktu %2, a liczba punktów to %3</translation>
    </message>
    <message>
        <source>%1: the mesh has too many groups, the limit is %2</source>
        <translation>%1: siatka ma za dużo grup; granica to %2</translation>
    </message>
    <message>
        <source>%1 holds no mesh</source>
        <translation>%1 nie zawiera siatki</translation>
    </message>
    <message>
        <source>%1 holds points only; a frame needs faces between them</source>
        <translation>%1 zawiera tylko punkty; stelaż wymaga ścian między nimi</translation>
    </message>
    <message>
        <source>%1: points are counted from 1, not from 0</source>
        <translation>%1: punkty liczy się od 1, a nie od 0</translation>
    </message>
    <message>
        <source>%1: the file ends too early</source>
        <translation>%1: plik kończy się za wcześnie</translation>
    </message>
    <message>
        <source>%1: the file does not begin with OFF</source>
        <translation>%1: plik nie zaczyna się od OFF</translation>
    </message>
    <message>
        <source>%1: binary OFF is not read; save it as text</source>
        <translation>%1: binarny OFF nie jest odczytywany; zapisz go jako tekst</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PLY number type</source>
        <translation>%1: „%2” nie jest typem liczbowym PLY</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PLY format</source>
        <translation>%1: „%2” nie jest formatem PLY</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; cannot count a list</source>
        <translation>%1: „%2” nie może liczyć listy</translation>
    </message>
    <message>
        <source>%1: the file does not begin with &quot;ply&quot;</source>
        <translation>%1: plik nie zaczyna się od „ply”</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not expected in a PLY header</source>
        <translation>%1: „%2” jest nieoczekiwane w nagłówku PLY</translation>
    </message>
    <message>
        <source>%1: a count is negative</source>
        <translation>%1: liczność jest ujemna</translation>
    </message>
    <message>
        <source>%1: the points have no coordinate &quot;%2&quot;</source>
        <translation>%1: punkty nie mają współrzędnej „%2”</translation>
    </message>
    <message>
        <source>%1: the faces have no list &quot;%2&quot;</source>
        <translation>%1: ściany nie mają listy „%2”</translation>
    </message>
    <message>
        <source>%1: a number is missing</source>
        <translation>%1: brakuje liczby</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a number</source>
        <translation>%1: „%2” nie jest liczbą</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a whole number</source>
        <translation>%1: „%2” nie jest liczbą całkowitą</translation>
    </message>
    <message>
        <source>unsaved work cannot be protected: &quot;%1&quot; cannot be written</source>
        <translation>niezapisanej pracy nie można zabezpieczyć: nie można zapisać „%1”</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot;</source>
        <translation>nie ma pliku „%1”</translation>
    </message>
    <message>
        <source>you are not allowed to read &quot;%1&quot;</source>
        <translation>brak uprawnień do odczytu „%1”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a folder, not a file</source>
        <translation>„%1” to folder, a nie plik</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an ordinary file</source>
        <translation>„%1” nie jest zwykłym plikiem</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read (%2)</source>
        <translation>nie można odczytać „%1” (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: the disk is full; make room or choose another folder</source>
        <translation>nie można zapisać „%1”: dysk jest pełny; zwolnij miejsce lub wybierz inny folder</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: you are not allowed to write into &quot;%2&quot;; choose another folder</source>
        <translation>nie można zapisać „%1”: brak uprawnień do zapisu w „%2”; wybierz inny folder</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: there is no folder &quot;%2&quot;</source>
        <translation>nie można zapisać „%1”: nie ma folderu „%2”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is a folder</source>
        <translation>nie można zapisać „%1”: to jest folder</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written (%2)</source>
        <translation>nie można zapisać „%1” (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too large: %2 MB, and at most %3 MB are read</source>
        <translation>„%1” jest za duży: ma %2&#xa0;MB, a odczytywane jest najwyżej %3&#xa0;MB</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is write-protected</source>
        <translation>nie można zapisać „%1”: jest chroniony przed zapisem</translation>
    </message>
    <message>
        <source>The equations of the cover could not be solved: a patch is degenerate or its numbers are too large.</source>
        <translation>Nie udało się rozwiązać równań pokrowca: element jest zdegenerowany lub jego liczby są za duże.</translation>
    </message>
    <message>
        <source>this seam and its neighbours carry their ends round in a circle without ever meeting. Let the seams of this circle end at common points.</source>
        <translation>ten szew i sąsiednie przekazują sobie końce w kółko, nigdzie się nie spotykając. Zakończ szwy tego koła we wspólnych punktach.</translation>
    </message>
    <message>
        <source>the corners of the two stretches lie too close together to be matched. Move them apart or choose a smaller edge length.</source>
        <translation>rogi obu odcinków leżą zbyt blisko siebie, by je sparować. Rozsuń je lub wybierz mniejszą długość krawędzi.</translation>
    </message>
    <message>
        <source>%1 and %2 hold the same point of the cover in two places, %3 mm apart. Let both curves meet there, or end one stretch earlier.</source>
        <translation>%1 i %2 trzymają ten sam punkt pokrowca w dwóch miejscach odległych o %3&#xa0;mm. Niech obie krzywe się tam spotkają lub jeden odcinek skończy się wcześniej.</translation>
    </message>
    <message>
        <source>the patch is too narrow somewhere for edges of %1 mm. Choose a smaller edge length.</source>
        <translation>element jest gdzieś za wąski na krawędzie %1&#xa0;mm. Wybierz mniejszą długość krawędzi.</translation>
    </message>
    <message>
        <source>The design cannot be solved: %2</source>
        <translation>Nie można obliczyć modelu: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>There is no patch to solve. Add a patch to the pattern.</source>
        <translation>Nie ma elementu do obliczenia. Dodaj element do wykroju.</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by an estimated %2 mm. Allow more iterations.</source>
        <translation>Po iteracjach w liczbie %1 powierzchnia nadal przesuwa się o około %2&#xa0;mm. Dopuść więcej iteracji.</translation>
    </message>
    <message>
        <source>Remove %1 points</source>
        <translation>Usuń punkty (%1)</translation>
    </message>
    <message>
        <source>Move %1 points</source>
        <translation>Przesuń punkty (%1)</translation>
    </message>
    <message>
        <source>another element has the number %1 already; give this one a number of its own</source>
        <translation>inny obiekt ma już numer %1; nadaj temu własny</translation>
    </message>
    <message>
        <source>this is no Bolster design; it must say &quot;format&quot;: &quot;bolster-design&quot;</source>
        <translation>to nie jest model Bolstera; musi zawierać &quot;format&quot;: &quot;bolster-design&quot;</translation>
    </message>
    <message>
        <source>the design was made by a newer Bolster (version %1 of the format, this program knows %2); update the program</source>
        <translation>model utworzono w nowszej wersji Bolstera (wersja formatu %1, ten program zna %2); zaktualizuj program</translation>
    </message>
    <message>
        <source>must be %1</source>
        <translation>musi być %1</translation>
    </message>
    <message>
        <source>must be &quot;mm&quot;; convert the design to millimetres</source>
        <translation>musi być &quot;mm&quot;; przelicz model na milimetry</translation>
    </message>
    <message>
        <source>must be a list of elements in square brackets</source>
        <translation>musi być listą obiektów w nawiasach kwadratowych</translation>
    </message>
    <message>
        <source>must be a list of points in square brackets</source>
        <translation>musi być listą punktów w nawiasach kwadratowych</translation>
    </message>
    <message>
        <source>must be a list of numbers in square brackets</source>
        <translation>musi być listą liczb w nawiasach kwadratowych</translation>
    </message>
    <message>
        <source>the list is empty; leave it out</source>
        <translation>lista jest pusta; pomiń ją</translation>
    </message>
    <message>
        <source>must be a curve in braces, with degree, closed and points</source>
        <translation>musi być krzywą w nawiasach klamrowych, z degree, closed i points</translation>
    </message>
    <message>
        <source>a curve has either corners or knots; remove one of them</source>
        <translation>krzywa ma albo corners, albo knots; usuń jedno z nich</translation>
    </message>
    <message>
        <source>an outline must be closed; write true</source>
        <translation>kontur musi być zamknięty; napisz true</translation>
    </message>
    <message>
        <source>must be a stretch in braces, with patch, from and to</source>
        <translation>musi być odcinkiem w nawiasach klamrowych, z patch, from i to</translation>
    </message>
    <message>
        <source>must be a quaternion [w, x, y, z] of length 1, not of length %1</source>
        <translation>musi być kwaternionem [w, x, y, z] o długości 1, a nie %1</translation>
    </message>
    <message>
        <source>must be an object in braces</source>
        <translation>musi być obiektem w nawiasach klamrowych</translation>
    </message>
    <message>
        <source>an element must be an object in braces</source>
        <translation>obiekt musi być zapisany w nawiasach klamrowych</translation>
    </message>
    <message>
        <source>must be true or false, without quotes</source>
        <translation>musi być true lub false, bez cudzysłowu</translation>
    </message>
    <message>
        <source>must be a text in quotes</source>
        <translation>musi być tekstem w cudzysłowie</translation>
    </message>
    <message>
        <source>and %1 more problems of this element</source>
        <translation>oraz dalsze problemy tego obiektu (%1)</translation>
    </message>
    <message>
        <source>must be a number, without quotes</source>
        <translation>musi być liczbą, bez cudzysłowu</translation>
    </message>
    <message>
        <source>must be a whole number from %1 to %2</source>
        <translation>musi być liczbą całkowitą od %1 do %2</translation>
    </message>
    <message>
        <source>must be a list of %1 numbers in square brackets</source>
        <translation>musi być listą liczb w nawiasach kwadratowych (liczb: %1)</translation>
    </message>
    <message>
        <source>this key occurs twice; remove one of them</source>
        <translation>ten klucz występuje dwa razy; usuń jeden z nich</translation>
    </message>
    <message>
        <source>this key is missing; add it</source>
        <translation>brakuje tego klucza; dodaj go</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>musi być jednym z: %1</translation>
    </message>
    <message>
        <source>this key is unknown; check its spelling or remove it</source>
        <translation>ten klucz jest nieznany; sprawdź pisownię lub usuń go</translation>
    </message>
    <message>
        <source>Move a point of %1</source>
        <translation>Przesuń punkt: %1</translation>
    </message>
    <message>
        <source>Move %2 points of %1</source>
        <translation>Przesuń punkty (%2): %1</translation>
    </message>
    <message>
        <source>Insert a point into %1</source>
        <translation>Wstaw punkt: %1</translation>
    </message>
    <message>
        <source>Remove a point of %1</source>
        <translation>Usuń punkt: %1</translation>
    </message>
    <message>
        <source>Change the settings</source>
        <translation>Zmień ustawienia</translation>
    </message>
    <message>
        <source>Add fabric %1</source>
        <translation>Dodaj materiał %1</translation>
    </message>
    <message>
        <source>Add patch %1</source>
        <translation>Dodaj element %1</translation>
    </message>
    <message>
        <source>Add a seam</source>
        <translation>Dodaj szew</translation>
    </message>
    <message>
        <source>Add fixation curve %1</source>
        <translation>Dodaj krzywą mocowania %1</translation>
    </message>
    <message>
        <source>Add a fixation seam</source>
        <translation>Dodaj mocowanie</translation>
    </message>
    <message>
        <source>Add frame %1</source>
        <translation>Dodaj stelaż %1</translation>
    </message>
    <message>
        <source>Add an unreadable element</source>
        <translation>Dodaj nieczytelny obiekt</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>Zmień nazwę: %1 na %2</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Usuń: %1</translation>
    </message>
    <message>
        <source>Remove %1 elements</source>
        <translation>Usuń obiekty (%1)</translation>
    </message>
    <message>
        <source>Move %1 patches</source>
        <translation>Przesuń elementy (%1)</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Przesuń: %1</translation>
    </message>
    <message>
        <source>Turn %1 patches</source>
        <translation>Obróć elementy (%1)</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>Obróć: %1</translation>
    </message>
    <message>
        <source>There is not enough memory for this surface. Choose a larger edge length.</source>
        <translation>Za mało pamięci na tę powierzchnię. Wybierz większą długość krawędzi.</translation>
    </message>
    <message>
        <source>The solver failed: %1. The last good surface is kept.</source>
        <translation>Obliczenia nie powiodły się: %1. Zachowano ostatnią dobrą powierzchnię.</translation>
    </message>
    <message>
        <source>Change the colour of %1</source>
        <translation>Zmień kolor: %1</translation>
    </message>
    <message>
        <source>Change the stiffness of %1</source>
        <translation>Zmień sztywność: %1</translation>
    </message>
    <message>
        <source>Change the Poisson parameter of %1</source>
        <translation>Zmień współczynnik Poissona: %1</translation>
    </message>
    <message>
        <source>Change the bending length of %1</source>
        <translation>Zmień długość zginania: %1</translation>
    </message>
    <message>
        <source>Change the fabric of %1</source>
        <translation>Zmień materiał: %1</translation>
    </message>
    <message>
        <source>Change the grain of %1</source>
        <translation>Zmień kierunek nitki: %1</translation>
    </message>
    <message>
        <source>Change the pressure of %1</source>
        <translation>Zmień ciśnienie: %1</translation>
    </message>
    <message>
        <source>Change the right side of %1</source>
        <translation>Zmień prawą stronę: %1</translation>
    </message>
    <message>
        <source>Move %1 in the layout</source>
        <translation>Przesuń w układzie: %1</translation>
    </message>
    <message>
        <source>Turn %1 in the layout</source>
        <translation>Obróć w układzie: %1</translation>
    </message>
    <message>
        <source>Change the continuity of %1</source>
        <translation>Zmień ciągłość: %1</translation>
    </message>
    <message>
        <source>Change how %1 is matched</source>
        <translation>Zmień parowanie: %1</translation>
    </message>
    <message>
        <source>Reverse %1</source>
        <translation>Odwróć bieg: %1</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>Skaluj: %1</translation>
    </message>
    <message>
        <source>The surface still moves after %1 iterations.</source>
        <translation>Po iteracjach w liczbie %1 powierzchnia nadal się porusza.</translation>
    </message>
    <message>
        <source>this is no name of a file</source>
        <translation>to nie jest nazwa pliku</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be relative to the design&apos;s folder and use &quot;/&quot; between folders</source>
        <translation>„%1” musi być ścieżką względem folderu modelu, z „/” między folderami</translation>
    </message>
    <message>
        <source>left out because of its errors</source>
        <translation>pominięto z powodu błędów</translation>
    </message>
    <message>
        <source>left out because it needs %1, which is not there</source>
        <translation>pominięto, bo wymaga %1, którego brak</translation>
    </message>
    <message>
        <source>an edge length of %1 mm is used instead</source>
        <translation>zamiast tego użyto długości krawędzi %1&#xa0;mm</translation>
    </message>
    <message>
        <source>the file is not a design</source>
        <translation>plik nie jest modelem</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written</source>
        <translation>nie można zapisać „%1”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be copied to &quot;%2&quot;: %3</source>
        <translation>nie udało się skopiować „%1” do „%2”: %3</translation>
    </message>
    <message>
        <source>the folder &quot;%1&quot; could not be made</source>
        <translation>nie udało się utworzyć folderu „%1”</translation>
    </message>
    <message>
        <source>the patch is free in space: nothing fixes it to the frame; add a fixation</source>
        <translation>element jest swobodny w przestrzeni: nic nie mocuje go do stelaża; dodaj mocowanie</translation>
    </message>
    <message>
        <source>this patch and the %1 sewn to it are free in space: nothing fixes them to the frame; add a fixation</source>
        <translation>ten element i przyszyte do niego (%1) są swobodne w przestrzeni: nic nie mocuje ich do stelaża; dodaj mocowanie</translation>
    </message>
    <message>
        <source>is %1, but must lie between %2 and %3</source>
        <translation>wynosi %1, a musi leżeć między %2 a %3</translation>
    </message>
    <message>
        <source>there is no element %1; name a %2</source>
        <translation>nie ma obiektu %1; podaj obiekt rodzaju: %2</translation>
    </message>
    <message>
        <source>element %1 cannot be read; repair it or name another %2</source>
        <translation>obiektu %1 nie można odczytać; napraw go lub podaj inny rodzaju: %2</translation>
    </message>
    <message>
        <source>%1 is no %2; name another element</source>
        <translation>%1 nie jest rodzaju: %2; podaj inny obiekt</translation>
    </message>
    <message>
        <source>%1 mm would make more than 5 million triangles; take at least %2 mm for these patches</source>
        <translation>%1&#xa0;mm dałoby ponad 5 milionów trójkątów; dla tych elementów weź co najmniej %2&#xa0;mm</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no colour; write it like #7a4a2b</source>
        <translation>„%1” nie jest kolorem; zapisz go jak #7a4a2b</translation>
    </message>
    <message>
        <source>the mesh cannot resolve folds as small as a bending length of %1 mm makes them: with edges of %2 mm it acts like %3 mm; take an edge length of at most %4 mm, or a longer bending length</source>
        <translation>siatka nie odda tak małych fałd, jakie daje długość zginania %1&#xa0;mm: przy krawędziach %2&#xa0;mm działa ona jak %3&#xa0;mm; weź długość krawędzi najwyżej %4&#xa0;mm lub większą długość zginania</translation>
    </message>
    <message>
        <source>an outline must be a closed curve</source>
        <translation>kontur musi być krzywą zamkniętą</translation>
    </message>
    <message>
        <source>the outline needs at least three points in different places</source>
        <translation>kontur wymaga co najmniej trzech punktów w różnych miejscach</translation>
    </message>
    <message>
        <source>all points of the outline lie on one line, it encloses no area; move one of them</source>
        <translation>wszystkie punkty konturu leżą na jednej prostej, nie obejmuje on pola; przesuń jeden z nich</translation>
    </message>
    <message>
        <source>the outline crosses or touches itself near %1; move its points apart there</source>
        <translation>kontur przecina się lub styka sam ze sobą w pobliżu %1; rozsuń tam jego punkty</translation>
    </message>
    <message>
        <source>the outline encloses no area</source>
        <translation>kontur nie obejmuje pola</translation>
    </message>
    <message>
        <source>%1 is the end of the curve; write %2, its start</source>
        <translation>%1 to koniec krzywej; napisz %2, jej początek</translation>
    </message>
    <message>
        <source>is %1, but must be larger than the start of the stretch, %2</source>
        <translation>wynosi %1, a musi być większe niż początek odcinka, %2</translation>
    </message>
    <message>
        <source>the stretch from %1 to %2 is empty or longer than the curve</source>
        <translation>odcinek od %1 do %2 jest pusty lub dłuższy niż krzywa</translation>
    </message>
    <message>
        <source>the stretch from %1 to %2 has no length; the outline&apos;s points coincide there</source>
        <translation>odcinek od %1 do %2 nie ma długości; punkty konturu się tam pokrywają</translation>
    </message>
    <message>
        <source>the seam would sew a stretch of &quot;%1&quot; to itself: %2 to %3 and %4 to %5 overlap; choose two separate stretches</source>
        <translation>szew przyszywałby odcinek „%1” do samego siebie: %2–%3 i %4–%5 nakładają się; wybierz dwa osobne odcinki</translation>
    </message>
    <message>
        <source>the seam joins the right side of &quot;%1&quot; to the wrong side of &quot;%2&quot;; turn &quot;reversed&quot; round, or one patch wrong side out</source>
        <translation>szew łączy prawą stronę „%1” z lewą stroną „%2”; odwróć „reversed” lub przewróć jeden element na lewą stronę</translation>
    </message>
    <message>
        <source>the sides of the seam are %1 mm (&quot;%2&quot;) and %3 mm (&quot;%4&quot;) long: %5 % ease, more than 5 % puckers; make them equal or check the ends of the stretches</source>
        <translation>strony szwu mają długość %1&#xa0;mm („%2”) i %3&#xa0;mm („%4”): wdanie %5%, powyżej 5% szew się marszczy; zrównaj je lub sprawdź końce odcinków</translation>
    </message>
    <message>
        <source>the curve has no length; move its points apart</source>
        <translation>krzywa nie ma długości; rozsuń jej punkty</translation>
    </message>
    <message>
        <source>the curve from %1 to %2 has no length</source>
        <translation>krzywa od %1 do %2 nie ma długości</translation>
    </message>
    <message>
        <source>is %1, but must be positive: millimetres per unit of the file</source>
        <translation>wynosi %1, a musi być dodatnie: milimetry na jednostkę pliku</translation>
    </message>
    <message>
        <source>a design has at most %1 elements</source>
        <translation>model ma najwyżej %1 obiektów</translation>
    </message>
    <message>
        <source>a curve has at most %1 points</source>
        <translation>krzywa ma najwyżej %1 punktów</translation>
    </message>
    <message>
        <source>the usual values of a fabric are used instead</source>
        <translation>zamiast tego użyto zwykłych wartości materiału</translation>
    </message>
    <message>
        <source>Remove %1 and what is sewn to it</source>
        <translation>Usuń: %1, wraz z tym, co przyszyte</translation>
    </message>
    <message>
        <source>Remove %1 and %2 seams and fixations</source>
        <translation>Usuń: %1, wraz ze szwami i mocowaniami (%2)</translation>
    </message>
    <message>
        <source>is %1, but must be a positive length of at most %2; 12 mm is usual</source>
        <translation>wynosi %1, a musi być dodatnią długością, najwyżej %2; zwykle 12&#xa0;mm</translation>
    </message>
    <message>
        <source>no mesh can resolve folds as small as a bending length of %1 mm makes them: with edges of %2 mm it acts like %3 mm; take a longer bending length</source>
        <translation>żadna siatka nie odda tak małych fałd, jakie daje długość zginania %1&#xa0;mm: przy krawędziach %2&#xa0;mm działa ona jak %3&#xa0;mm; weź większą długość zginania</translation>
    </message>
    <message>
        <source>it sews what %1 sews already; remove one of them</source>
        <translation>zszywa to, co już zszywa %1; usuń jeden z nich</translation>
    </message>
    <message>
        <source>it sews the same stretches as %1, but the other way round: each would be folded onto itself; remove one of the two</source>
        <translation>zszywa te same odcinki co %1, lecz odwrotnie: każdy zostałby złożony sam na siebie; usuń jeden z nich</translation>
    </message>
    <message>
        <source>&quot;%1&quot; goes up with &quot;..&quot;; write the way from the design&apos;s folder without it, or copy the file there</source>
        <translation>„%1” prowadzi w górę przez „..”; podaj ścieżkę od folderu modelu bez tego lub skopiuj tam plik</translation>
    </message>
    <message>
        <source>the number %1 is too large or too small; stay within %2</source>
        <translation>liczba %1 jest za duża lub za mała; zmieść się w %2</translation>
    </message>
    <message>
        <source>the text is UTF-16; save it as UTF-8</source>
        <translation>tekst jest w UTF-16; zapisz go jako UTF-8</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by %2 mm in each: it does not come to rest. Lower the pressure, or make curves as long as the outlines they hold.</source>
        <translation>Po iteracjach w liczbie %1 powierzchnia w każdej nadal przesuwa się o %2&#xa0;mm: nie stabilizuje się. Zmniejsz ciśnienie lub zrób krzywe tak długie jak kontury, które trzymają.</translation>
    </message>
    <message>
        <source>%1 of %2 triangles of the cover lie upside down. Look for cloth pressed into too little room, or a bending length that is long for its patch.</source>
        <translation>Odwrócone trójkąty pokrowca: %1 z %2. Szukaj materiału, który ma za mało miejsca, lub długości zginania za dużej dla elementu.</translation>
    </message>
    <message>
        <source>there is either a normal or a tangent; remove one of them</source>
        <translation>jest albo normalna, albo styczna; usuń jedną z nich</translation>
    </message>
    <message>
        <source>there are %1 directions, but at most %2 are possible</source>
        <translation>kierunków jest %1, a może być najwyżej %2</translation>
    </message>
    <message>
        <source>a direction must be three numbers that are not all 0</source>
        <translation>kierunek musi składać się z trzech liczb, nie samych 0</translation>
    </message>
    <message>
        <source>direction %1 is opposite to the one before, so that it is not known on which way to turn; add one between them</source>
        <translation>kierunek %1 jest przeciwny do poprzedniego, więc nie wiadomo, w którą stronę obracać; dodaj jeden pomiędzy</translation>
    </message>
    <message>
        <source>there is no curve; name one, or leave out curve_from and curve_to</source>
        <translation>nie ma krzywej; podaj ją lub pomiń curve_from i curve_to</translation>
    </message>
    <message>
        <source>Change the normal held by %1</source>
        <translation>Zmień ustaloną normalną: %1</translation>
    </message>
    <message>
        <source>must be a text in quotation marks</source>
        <translation>musi być tekstem w cudzysłowie</translation>
    </message>
    <message>
        <source>the curve in the patch and its target must both be open or both be closed</source>
        <translation>krzywa w elemencie i jej cel muszą być obie otwarte lub obie zamknięte</translation>
    </message>
    <message>
        <source>Add handle curve %1</source>
        <translation>Dodaj krzywą sterującą %1</translation>
    </message>
    <message>
        <source>Add fancy seam %1</source>
        <translation>Dodaj szew ozdobny %1</translation>
    </message>
    <message>
        <source>Add cushion %1</source>
        <translation>Dodaj wyściółkę %1</translation>
    </message>
    <message>
        <source>Add foam %1</source>
        <translation>Dodaj piankę %1</translation>
    </message>
    <message>
        <source>a width of %1 mm is too narrow for edges of %2 mm; make it at least %3 mm wide, or choose a smaller edge length</source>
        <translation>szerokość %1&#xa0;mm jest za mała na krawędzie %2&#xa0;mm; ustaw co najmniej %3&#xa0;mm lub wybierz mniejszą długość krawędzi</translation>
    </message>
    <message>
        <source>it lies outside its patch; move its points inside the outline</source>
        <translation>leży poza swoim elementem; przesuń punkty do wnętrza konturu</translation>
    </message>
    <message>
        <source>it leaves the patch and comes back; keep it inside, or end it at the outline</source>
        <translation>wychodzi z elementu i wraca; zostaw w środku lub zakończ na konturze</translation>
    </message>
    <message>
        <source>it runs too flat into the outline near %1; let it meet the outline more steeply, or end it before</source>
        <translation>dochodzi do konturu zbyt płasko w pobliżu %1; poprowadź bardziej stromo lub zakończ wcześniej</translation>
    </message>
    <message>
        <source>it bends too sharply for a width of %1 mm near %2; make it narrower, or bend it less there</source>
        <translation>zbyt ostro zakręca przy szerokości %1&#xa0;mm w pobliżu %2; zwęź lub zmniejsz tam zagięcie</translation>
    </message>
    <message>
        <source>a cushion takes at most %1 bodies of foam; this one is left out</source>
        <translation>wyściółka przyjmuje najwyżej %1 brył pianki; ta zostaje pominięta</translation>
    </message>
    <message>
        <source>the frame has no part &quot;%1&quot;; it has %2</source>
        <translation>stelaż nie ma części „%1”; ma: %2</translation>
    </message>
    <message>
        <source>it is only %1 mm long; draw it at least %2 mm long, or choose a smaller edge length</source>
        <translation>ma tylko %1&#xa0;mm długości; narysuj co najmniej %2&#xa0;mm lub wybierz mniejszą długość krawędzi</translation>
    </message>
    <message>
        <source>it reaches beyond its patch near %1; move its points inside the outline</source>
        <translation>wystaje poza swój element w pobliżu %1; przesuń punkty do wnętrza konturu</translation>
    </message>
    <message>
        <source>it comes closer than %1 mm to the outline near %2; keep away from it, or choose a smaller edge length</source>
        <translation>zbliża się do konturu na mniej niż %1&#xa0;mm w pobliżu %2; zachowaj odstęp lub wybierz mniejszą długość krawędzi</translation>
    </message>
    <message>
        <source>it crosses %1, or comes closer to it than %2 mm, near %3; move them apart, or choose a smaller edge length</source>
        <translation>przecina %1 lub zbliża się na mniej niż %2&#xa0;mm w pobliżu %3; rozsuń je lub wybierz mniejszą długość krawędzi</translation>
    </message>
    <message>
        <source>it crosses itself, or comes closer to itself than %1 mm, near %2; move its points apart, or choose a smaller edge length</source>
        <translation>przecina się lub zbliża do siebie na mniej niż %1&#xa0;mm w pobliżu %2; rozsuń punkty lub wybierz mniejszą długość krawędzi</translation>
    </message>
    <message>
        <source>the patch cannot be triangulated along it with edges of %1 mm. Choose a smaller edge length.</source>
        <translation>nie da się triangulować elementu wzdłuż tej krzywej przy krawędziach %1&#xa0;mm. Wybierz mniejszą długość krawędzi.</translation>
    </message>
    <message>
        <source>Change the frame of %1</source>
        <translation>Zmień stelaż: %1</translation>
    </message>
    <message>
        <source>Change what %1 pushes</source>
        <translation>Zmień, co wypycha %1</translation>
    </message>
    <message>
        <source>Switch %1</source>
        <translation>Włącz lub wyłącz: %1</translation>
    </message>
    <message>
        <source>Change the parts of %1</source>
        <translation>Zmień części: %1</translation>
    </message>
    <message>
        <source>Change the padding of %1</source>
        <translation>Zmień grubość wyściółki: %1</translation>
    </message>
    <message>
        <source>Change the strength of %1</source>
        <translation>Zmień siłę: %1</translation>
    </message>
    <message>
        <source>Change the distance of %1</source>
        <translation>Zmień odstęp: %1</translation>
    </message>
    <message>
        <source>Change the voxels of %1</source>
        <translation>Zmień woksele: %1</translation>
    </message>
    <message>
        <source>Change the cushion of %1</source>
        <translation>Zmień wyściółkę: %1</translation>
    </message>
    <message>
        <source>Change the shape of %1</source>
        <translation>Zmień kształt: %1</translation>
    </message>
    <message>
        <source>Change the size of %1</source>
        <translation>Zmień rozmiar: %1</translation>
    </message>
    <message>
        <source>Add or cut %1</source>
        <translation>Dodaj lub wytnij: %1</translation>
    </message>
    <message>
        <source>Change the contact of %1</source>
        <translation>Zmień kontakt: %1</translation>
    </message>
    <message>
        <source>Change the gap of %1</source>
        <translation>Zmień odstęp: %1</translation>
    </message>
    <message>
        <source>Change the width of %1</source>
        <translation>Zmień szerokość: %1</translation>
    </message>
    <message>
        <source>Change the depth of %1</source>
        <translation>Zmień głębokość: %1</translation>
    </message>
    <message>
        <source>Change the profile of %1</source>
        <translation>Zmień profil: %1</translation>
    </message>
    <message>
        <source>Move points of %1 curves</source>
        <translation>Przesuń punkty krzywych (%1)</translation>
    </message>
    <message>
        <source>Rename a file</source>
        <translation>Zmień nazwę pliku</translation>
    </message>
    <message>
        <source>Change the file of %1</source>
        <translation>Zmień plik: %1</translation>
    </message>
    <message>
        <source>the file is missing</source>
        <translation>brakuje pliku</translation>
    </message>
    <message>
        <source>it is a file that this design refers to; choose another name</source>
        <translation>to plik, do którego odwołuje się ten model; wybierz inną nazwę</translation>
    </message>
    <message>
        <source>There is no cover to place the scan on.</source>
        <translation>Nie ma pokrowca, na którym można by umieścić skan.</translation>
    </message>
    <message>
        <source>must be a list of at most %1 planes, [x, y, z, distance] each</source>
        <translation>musi być listą najwyżej %1 płaszczyzn, każda [x, y, z, odległość]</translation>
    </message>
    <message>
        <source>must be a list of at most %1 cuts in braces</source>
        <translation>musi być listą najwyżej %1 cięć w nawiasach klamrowych</translation>
    </message>
    <message>
        <source>must be a cut in braces, with planes</source>
        <translation>musi być cięciem w nawiasach klamrowych, z planes</translation>
    </message>
    <message>
        <source>the first three numbers are the plane&apos;s normal; not all of them may be 0</source>
        <translation>pierwsze trzy liczby to normalna płaszczyzny; nie mogą być wszystkie równe 0</translation>
    </message>
    <message>
        <source>no file is named; write the name of a file beside the design</source>
        <translation>nie podano pliku; wpisz nazwę pliku obok modelu</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no file in the design&apos;s folder; copy the file into that folder and name it here</source>
        <translation>„%1” nie jest plikiem w folderze modelu; skopiuj plik do tego folderu i podaj go tutaj</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot; in the design&apos;s folder; copy the file there or choose another one</source>
        <translation>w folderze modelu nie ma pliku „%1”; skopiuj go tam lub wybierz inny</translation>
    </message>
    <message>
        <source>with this scale and position the points reach beyond 10,000,000 mm</source>
        <translation>przy tej skali i położeniu punkty wykraczają poza 10&#xa0;000&#xa0;000&#xa0;mm</translation>
    </message>
    <message>
        <source>Add scan %1</source>
        <translation>Dodaj skan %1</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Przytnij: %1</translation>
    </message>
    <message>
        <source>Show all of %1</source>
        <translation>Pokaż w całości: %1</translation>
    </message>
    <message>
        <source>Cut the floor off %1</source>
        <translation>Odetnij podłogę: %1</translation>
    </message>
    <message>
        <source>%1 holds no points</source>
        <translation>%1 nie zawiera punktów</translation>
    </message>
    <message>
        <source>%1: the scan is too large, the limit is %2 points</source>
        <translation>%1: skan jest za duży, granica punktów to %2</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not expected in a PCD header</source>
        <translation>%1: „%2” jest nieoczekiwane w nagłówku PCD</translation>
    </message>
    <message>
        <source>%1: the compressed points are damaged</source>
        <translation>%1: skompresowane punkty są uszkodzone</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PCD format</source>
        <translation>%1: „%2” nie jest formatem PCD</translation>
    </message>
    <message>
        <source>the cuts leave nothing of the scan; remove one of them</source>
        <translation>cięcia nie zostawiają nic ze skanu; usuń jedno z nich</translation>
    </message>
    <message>
        <source>Change the threshold of %1</source>
        <translation>Zmień próg: %1</translation>
    </message>
    <message>
        <source>Change how %1 pulls</source>
        <translation>Zmień, jak ciągnie %1</translation>
    </message>
    <message>
        <source>Release points of twins</source>
        <translation>Uwolnij punkty bliźniaków</translation>
    </message>
    <message>
        <source>Re-link points of twins</source>
        <translation>Połącz ponownie punkty bliźniaków</translation>
    </message>
    <message>
        <source>Make the design symmetric</source>
        <translation>Uczyń model symetrycznym</translation>
    </message>
    <message>
        <source>These two cannot be twins.</source>
        <translation>Te dwa nie mogą być bliźniakami.</translation>
    </message>
    <message>
        <source>Make corners</source>
        <translation>Utwórz rogi</translation>
    </message>
    <message>
        <source>Make curves smooth</source>
        <translation>Wygładź krzywe</translation>
    </message>
    <message>
        <source>element %1 cannot be its twin: that must be another %2 which is nobody else&apos;s; until then it has none</source>
        <translation>obiekt %1 nie może być jego bliźniakiem: to musi być inny obiekt (%2), niczyj inny; do tego czasu bliźniaka nie ma</translation>
    </message>
    <message>
        <source>there is no point %1</source>
        <translation>nie ma punktu %1</translation>
    </message>
    <message>
        <source>its points and knots are not those of %1; the next edit of one of them makes it the mirror image</source>
        <translation>punkty i węzły różnią się od tych, które ma %1; najbliższa zmiana jednego z nich uczyni go odbiciem lustrzanym</translation>
    </message>
    <message>
        <source>%1 of its points are no mirror images of those of %2; release them, or move them</source>
        <translation>punkty niebędące odbiciem punktów obiektu %2: %1; uwolnij je lub przesuń</translation>
    </message>
    <message>
        <source>the plane needs a normal that is not 0, and numbers within 1e7; x = 0 is used instead</source>
        <translation>płaszczyzna wymaga normalnej różnej od 0 i liczb w zakresie 1e7; zamiast tego użyto x = 0</translation>
    </message>
    <message>
        <source>the axis needs a direction that is not 0, and numbers within 1e7; x = 0 is used instead</source>
        <translation>oś wymaga kierunku różnego od 0 i liczb w zakresie 1e7; zamiast tego użyto x = 0</translation>
    </message>
    <message>
        <source>The clipboard holds no parts of a design.</source>
        <translation>Schowek nie zawiera części modelu.</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Wklej: %1</translation>
    </message>
    <message>
        <source>Paste %1 pieces</source>
        <translation>Wklej (%1)</translation>
    </message>
    <message>
        <source>The clipboard holds no patches and no fixation curves.</source>
        <translation>Schowek nie zawiera elementów ani krzywych mocowania.</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Powiel: %1</translation>
    </message>
    <message>
        <source>Duplicate %1 pieces</source>
        <translation>Powiel (%1)</translation>
    </message>
    <message>
        <source>Make a corner in %1</source>
        <translation>Utwórz róg: %1</translation>
    </message>
    <message>
        <source>Make %1 smooth</source>
        <translation>Wygładź: %1</translation>
    </message>
    <message>
        <source>Straighten a stretch of %1</source>
        <translation>Wyprostuj odcinek: %1</translation>
    </message>
    <message>
        <source>Attach %1 to %2</source>
        <translation>Zamocuj %1 do: %2</translation>
    </message>
    <message>
        <source>There is no such stretch of an outline.</source>
        <translation>Nie ma takiego odcinka konturu.</translation>
    </message>
    <message>
        <source>The stretch has no length.</source>
        <translation>Odcinek nie ma długości.</translation>
    </message>
    <message>
        <source>A part of this stretch is fixed to %1 already: remove that fixation or choose another stretch.</source>
        <translation>Część tego odcinka jest już zamocowana (%1): usuń to mocowanie lub wybierz inny odcinek.</translation>
    </message>
    <message>
        <source>Create fixation curve %1</source>
        <translation>Utwórz krzywą mocowania %1</translation>
    </message>
    <message>
        <source>Attach %1 stretches to %2</source>
        <translation>Zamocuj odcinki (%1) do: %2</translation>
    </message>
    <message>
        <source>Attach %1 to %2 curves</source>
        <translation>Zamocuj %1 do krzywych (%2)</translation>
    </message>
    <message>
        <source>Align %1 patches</source>
        <translation>Wyrównaj elementy (%1)</translation>
    </message>
    <message>
        <source>Distribute %1 patches</source>
        <translation>Rozłóż elementy (%1)</translation>
    </message>
    <message>
        <source>Arrange %1 patches</source>
        <translation>Rozmieść elementy (%1)</translation>
    </message>
    <message>
        <source>Make %1 and %2 twins</source>
        <translation>Połącz jako bliźniaki: %1 i %2</translation>
    </message>
    <message>
        <source>They are no mirror images: they differ by %1 mm. Twins must be alike; make a mirror twin of one of them instead.</source>
        <translation>To nie są odbicia lustrzane: różnią się o %1&#xa0;mm. Bliźniaki muszą być jednakowe; utwórz zamiast tego lustrzanego bliźniaka jednego z nich.</translation>
    </message>
    <message>
        <source>Make a mirror twin of %1</source>
        <translation>Utwórz lustrzanego bliźniaka: %1</translation>
    </message>
    <message>
        <source>Make %1 mirror twins</source>
        <translation>Utwórz lustrzane bliźniaki (%1)</translation>
    </message>
    <message>
        <source>A patch of the seam is missing or invalid: repair it first.</source>
        <translation>Brakuje elementu szwu lub jest on nieprawidłowy: najpierw go napraw.</translation>
    </message>
    <message>
        <source>The seam joins %1 to itself: there is nothing to merge.</source>
        <translation>Szew łączy %1 z samym sobą: nie ma czego scalać.</translation>
    </message>
    <message>
        <source>The seam takes up a whole outline: nothing would be left.</source>
        <translation>Szew zajmuje cały kontur: nic by nie zostało.</translation>
    </message>
    <message>
        <source>The seam joins the right side of %1 to the wrong side of %2: one patch cannot be both.</source>
        <translation>Szew łączy prawą stronę (%1) z lewą (%2): jeden element nie może mieć obu.</translation>
    </message>
    <message>
        <source>The sides of the seam differ by %1 % in length, more than 5 %.</source>
        <translation>Strony szwu różnią się długością o %1%, ponad 5%.</translation>
    </message>
    <message>
        <source>Select the seam along which to merge.</source>
        <translation>Zaznacz szew, wzdłuż którego scalać.</translation>
    </message>
    <message>
        <source>Merged, %1 and %2 would overlap or cross: the seam stays.</source>
        <translation>Po scaleniu %1 i %2 nakładałyby się lub przecinały: szew zostaje.</translation>
    </message>
    <message>
        <source>Merge %1 and %2</source>
        <translation>Scal: %1 i %2</translation>
    </message>
    <message>
        <source>Scale %1 patches</source>
        <translation>Skaluj elementy (%1)</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>Odbij: %1</translation>
    </message>
    <message>
        <source>Mirror %1 patches</source>
        <translation>Odbij elementy (%1)</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>Podziel: %1</translation>
    </message>
    <message>
        <source>The line must cross the outline of %1 exactly twice, not %2 times.</source>
        <translation>Linia musi przeciąć kontur (%1) dokładnie dwa razy, a przecina: %2.</translation>
    </message>
    <message>
        <source>Draw a line over a patch to split it.</source>
        <translation>Narysuj linię w poprzek elementu, aby go podzielić.</translation>
    </message>
    <message>
        <source>The outline of %1 is invalid: repair it first.</source>
        <translation>Kontur jest nieprawidłowy (%1): najpierw go napraw.</translation>
    </message>
    <message>
        <source>The line must run inside %1.</source>
        <translation>Linia musi biec wewnątrz: %1.</translation>
    </message>
    <message>
        <source>A piece of %1 would cross itself or be too narrow: draw another line.</source>
        <translation>Kawałek (%1) przecinałby sam siebie lub byłby za wąski: narysuj inną linię.</translation>
    </message>
    <message>
        <source>Sew %1 to %2</source>
        <translation>Zszyj: %1 z %2</translation>
    </message>
    <message>
        <source>Sew %1 to %2 stretches in a row</source>
        <translation>Zszyj: %1 z odcinkami w rzędzie (%2)</translation>
    </message>
    <message>
        <source>Flip %1</source>
        <translation>Odwróć: %1</translation>
    </message>
    <message>
        <source>Flip %1 seams</source>
        <translation>Odwróć szwy (%1)</translation>
    </message>
    <message>
        <source>Swap the sides of %1</source>
        <translation>Zamień strony: %1</translation>
    </message>
    <message>
        <source>Swap the sides of %1 seams</source>
        <translation>Zamień strony szwów (%1)</translation>
    </message>
    <message>
        <source>Change the continuity of %1 seams</source>
        <translation>Zmień ciągłość szwów (%1)</translation>
    </message>
    <message>
        <source>Change how %1 seams are matched</source>
        <translation>Zmień parowanie szwów (%1)</translation>
    </message>
    <message>
        <source>This stretch has no length: choose two different points.</source>
        <translation>Ten odcinek nie ma długości: wybierz dwa różne punkty.</translation>
    </message>
    <message>
        <source>Move an end of %1</source>
        <translation>Przesuń koniec: %1</translation>
    </message>
    <message>
        <source>%1 is already sewn to %2 here: remove that seam first, or take a free stretch.</source>
        <translation>%1 ma tu już szew z: %2. Najpierw usuń ten szew lub weź wolny odcinek.</translation>
    </message>
    <message>
        <source>A stretch cannot be sewn to itself: choose two that have no part in common.</source>
        <translation>Odcinka nie można przyszyć do niego samego: wybierz dwa bez wspólnej części.</translation>
    </message>
    <message>
        <source>Unlink %1 and %2</source>
        <translation>Rozłącz: %1 i %2</translation>
    </message>
    <message>
        <source>Unlink %1 pairs of twins</source>
        <translation>Rozłącz pary bliźniaków (%1)</translation>
    </message>
    <message>
        <source>Release a point of %1</source>
        <translation>Uwolnij punkt: %1</translation>
    </message>
    <message>
        <source>Release %2 points of %1</source>
        <translation>Uwolnij punkty (%2): %1</translation>
    </message>
    <message>
        <source>Re-link a point of %1</source>
        <translation>Połącz ponownie punkt: %1</translation>
    </message>
    <message>
        <source>Re-link %2 points of %1</source>
        <translation>Połącz ponownie punkty (%2): %1</translation>
    </message>
    <message>
        <source>Change the curve of %1</source>
        <translation>Zmień krzywą: %1</translation>
    </message>
    <message>
        <source>The outline of %1 would cross or touch itself.</source>
        <translation>Kontur (%1) przecinałby się lub stykał sam ze sobą.</translation>
    </message>
    <message>
        <source>The outline of %1 would enclose nothing.</source>
        <translation>Kontur (%1) nic by nie obejmował.</translation>
    </message>
    <message>
        <source>%1 would not lie inside %2 any more.</source>
        <translation>%1 nie leżałby już wewnątrz: %2.</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that is fixed to %2.</source>
        <translation>Odcinek nakładałby się na inny (%1), zamocowany do: %2.</translation>
    </message>
    <message>
        <source>The stretch would overlap the seam of %1 and %2.</source>
        <translation>Odcinek nakładałby się na szew: %1 i %2.</translation>
    </message>
    <message>
        <source>The two sides of the seam would overlap.</source>
        <translation>Obie strony szwu nakładałyby się na siebie.</translation>
    </message>
    <message>
        <source>Change the length of a stretch of %1</source>
        <translation>Zmień długość odcinka: %1</translation>
    </message>
    <message>
        <source>Move an end of a fixation of %1</source>
        <translation>Przesuń koniec mocowania: %1</translation>
    </message>
    <message>
        <source>Re-link a seam to its mirror image</source>
        <translation>Połącz szew ponownie z jego odbiciem</translation>
    </message>
    <message>
        <source>Release a seam from its mirror image</source>
        <translation>Uwolnij szew od jego odbicia</translation>
    </message>
    <message>
        <source>another element had the same number; give this one a number of its own</source>
        <translation>inny obiekt miał ten sam numer; nadaj temu własny</translation>
    </message>
    <message>
        <source>Take %1 elements from another version</source>
        <translation>Przejmij obiekty z innej wersji (%1)</translation>
    </message>
    <message>
        <source>Take %1 from another version</source>
        <translation>Przejmij z innej wersji: %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is not an ordinary file</source>
        <translation>nie można zapisać „%1”: to nie jest zwykły plik</translation>
    </message>
    <message>
        <source>a file that the design uses cannot be read (%1)</source>
        <translation>nie można odczytać pliku używanego przez model (%1)</translation>
    </message>
    <message>
        <source>a file of the project cannot be written out (%1)</source>
        <translation>nie można wypisać pliku projektu (%1)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be opened or made</source>
        <translation>nie można otworzyć ani utworzyć „%1”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is in use by another program</source>
        <translation>„%1” jest używany przez inny program</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged (%2)</source>
        <translation>„%1” jest uszkodzony (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read or written (%2)</source>
        <translation>nie można odczytać lub zapisać „%1” (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is closed</source>
        <translation>„%1” jest zamknięty</translation>
    </message>
    <message>
        <source>%1 cannot be stored: it holds a number that is none, or text in an unknown encoding</source>
        <translation>nie można zapisać: %1 – zawiera liczbę, która nią nie jest, lub tekst w nieznanym kodowaniu</translation>
    </message>
    <message>
        <source>there is a file &quot;%1&quot; already</source>
        <translation>plik „%1” już istnieje</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no Bolster project</source>
        <translation>„%1” nie jest projektem Bolstera</translation>
    </message>
    <message>
        <source>there is not enough memory for this project</source>
        <translation>za mało pamięci na ten projekt</translation>
    </message>
    <message>
        <source>an edit of the project cannot be read any more</source>
        <translation>nie można już odczytać jednej ze zmian projektu</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name for a file of a project</source>
        <translation>„%1” nie nadaje się na nazwę pliku projektu</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was made by a newer Bolster (version %2 of the format, this program knows %3); update the program</source>
        <translation>„%1” utworzono w nowszej wersji Bolstera (wersja formatu %2, ten program zna %3); zaktualizuj program</translation>
    </message>
    <message>
        <source>&quot;%1&quot; says that it has version %2 of the format, which never was</source>
        <translation>„%1” podaje wersję formatu %2, której nigdy nie było</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the journal of a running program, or of one that crashed, not a project file</source>
        <translation>„%1” to dziennik działającego lub przerwanego programu, a nie plik projektu</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: it is %2 bytes long and should have %3</source>
        <translation>„%1” jest uszkodzony: ma %2 bajtów, a powinien mieć %3</translation>
    </message>
    <message>
        <source>a temporary folder cannot be made (%1)</source>
        <translation>nie można utworzyć folderu tymczasowego (%1)</translation>
    </message>
    <message>
        <source>a temporary file cannot be made (%1)</source>
        <translation>nie można utworzyć pliku tymczasowego (%1)</translation>
    </message>
    <message>
        <source>nothing in &quot;%1&quot; can be saved</source>
        <translation>nic z „%1” nie da się uratować</translation>
    </message>
    <message>
        <source>%1 versions were saved</source>
        <translation>uratowane wersje: %1</translation>
    </message>
    <message>
        <source>lost: versions %1 to %2</source>
        <translation>utracone: wersje od %1 do %2</translation>
    </message>
    <message>
        <source>Saved version</source>
        <translation>Uratowana wersja</translation>
    </message>
    <message>
        <source>version %1 was saved without the edits before it</source>
        <translation>wersję %1 uratowano bez wcześniejszych zmian</translation>
    </message>
    <message>
        <source>lost: the names of %1 versions</source>
        <translation>utracone: nazwy wersji (%1)</translation>
    </message>
    <message>
        <source>lost: the file &quot;%1&quot;</source>
        <translation>utracone: plik „%1”</translation>
    </message>
    <message>
        <source>the tables of &quot;%1&quot; are not those of a Bolster project</source>
        <translation>tabele w „%1” nie są tabelami projektu Bolstera</translation>
    </message>
    <message>
        <source>a checksum is incomplete</source>
        <translation>suma kontrolna jest niekompletna</translation>
    </message>
    <message>
        <source>another window has it</source>
        <translation>ma go inne okno</translation>
    </message>
    <message>
        <source>must be a list of pairs in braces, with patch and fabric</source>
        <translation>musi być listą par w nawiasach klamrowych, z patch i fabric</translation>
    </message>
    <message>
        <source>must be a pair in braces, with patch and fabric</source>
        <translation>musi być parą w nawiasach klamrowych, z patch i fabric</translation>
    </message>
    <message>
        <source>there is no colourway %1; the patches show their own fabrics</source>
        <translation>nie ma wariantu kolorystycznego %1; elementy pokazują własne materiały</translation>
    </message>
    <message>
        <source>%1 has a fabric in this colourway already; remove one of the two</source>
        <translation>%1 ma już materiał w tym wariancie kolorystycznym; usuń jeden z dwóch</translation>
    </message>
    <message>
        <source>what it says of missing patches and fabrics is left out</source>
        <translation>pominięto to, co dotyczy brakujących elementów i materiałów</translation>
    </message>
    <message>
        <source>Make %1 of %2</source>
        <translation>Wykonaj %1 z: %2</translation>
    </message>
    <message>
        <source>Make %1 patches of %2</source>
        <translation>Wykonaj elementy (%1) z: %2</translation>
    </message>
    <message>
        <source>Add colourway %1</source>
        <translation>Dodaj wariant kolorystyczny %1</translation>
    </message>
    <message>
        <source>Change what %1 shows</source>
        <translation>Zmień, co pokazuje %1</translation>
    </message>
    <message>
        <source>Change what %1 patches show</source>
        <translation>Zmień, co pokazują elementy (%1)</translation>
    </message>
    <message>
        <source>Show no colourway</source>
        <translation>Nie pokazuj wariantu kolorystycznego</translation>
    </message>
    <message>
        <source>Show colourway %1</source>
        <translation>Pokaż wariant kolorystyczny %1</translation>
    </message>
    <message>
        <source>A stretch of %1 that is sewn, fixed or trimmed would have no length.</source>
        <translation>Zszyty, zamocowany lub wykończony odcinek (%1) nie miałby długości.</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that has a trim.</source>
        <translation>Odcinek nakładałby się na inny z wykończeniem (%1).</translation>
    </message>
    <message>
        <source>Add a trim</source>
        <translation>Dodaj wykończenie</translation>
    </message>
    <message>
        <source>Move an end of a trim of %1</source>
        <translation>Przesuń koniec wykończenia: %1</translation>
    </message>
    <message>
        <source>Change the trim of %1 seams</source>
        <translation>Zmień wykończenie szwów (%1)</translation>
    </message>
    <message>
        <source>Change the trim of %1</source>
        <translation>Zmień wykończenie: %1</translation>
    </message>
    <message>
        <source>A part of this stretch of %1 has a trim already: change that one, or choose another stretch.</source>
        <translation>Część tego odcinka (%1) ma już wykończenie: zmień je lub wybierz inny odcinek.</translation>
    </message>
    <message>
        <source>Trim the edge of %1</source>
        <translation>Wykończ krawędź: %1</translation>
    </message>
    <message>
        <source>%1: the file cannot be read any further; it has changed, or its disk is gone</source>
        <translation>%1: pliku nie da się dalej odczytać; zmienił się lub zniknął jego dysk</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a picture that can be read; PNG, JPEG, TIFF and OpenEXR can</source>
        <translation>„%1” nie jest obrazem, który można odczytać; można PNG, JPEG, TIFF i OpenEXR</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 by %3 pixels, and at most 64 million are read; make the picture smaller in a picture editor</source>
        <translation>„%1” ma %2 na %3 pikseli, a odczytywane są najwyżej 64 miliony; zmniejsz obraz w edytorze grafiki</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a kind of picture whose colours cannot be read; save it as PNG in a picture editor</source>
        <translation>„%1” to obraz, którego kolorów nie można odczytać; zapisz go jako PNG w edytorze grafiki</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged or incomplete; copy it again from where it came from, or save it again in a picture editor</source>
        <translation>„%1” jest uszkodzony lub niekompletny; skopiuj go ponownie ze źródła lub zapisz ponownie w edytorze grafiki</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which reads pictures for Bolster, cannot be started; install Bolster again</source>
        <translation>nie można uruchomić programu „%1”, który odczytuje obrazy dla Bolstera; zainstaluj Bolstera ponownie</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes too long to read; save it as PNG in a picture editor</source>
        <translation>odczyt „%1” trwa zbyt długo; zapisz jako PNG w edytorze grafiki</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be decoded: it is damaged or incomplete, or needs too much memory; save it again as PNG in a picture editor</source>
        <translation>nie można zdekodować „%1”: plik jest uszkodzony lub niekompletny albo wymaga zbyt dużo pamięci; zapisz ponownie jako PNG w edytorze grafiki</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this picture</source>
        <translation>%1: za mało pamięci na ten obraz</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this file</source>
        <translation>%1: za mało pamięci na ten plik</translation>
    </message>
    <message>
        <source>%1: the line is too long</source>
        <translation>%1: wiersz jest za długi</translation>
    </message>
    <message>
        <source>both have a file &quot;%1&quot;, and they are different: save under another name</source>
        <translation>oba mają plik „%1”, lecz różny: zapisz pod inną nazwą</translation>
    </message>
    <message>
        <source>there is another project in the file now</source>
        <translation>w pliku jest teraz inny projekt</translation>
    </message>
    <message>
        <source>the last edits are not on the disk yet</source>
        <translation>ostatnich zmian nie ma jeszcze na dysku</translation>
    </message>
    <message>
        <source>Change the stitching of %1</source>
        <translation>Zmień stebnowanie: %1</translation>
    </message>
    <message>
        <source>Change the piping of %1</source>
        <translation>Zmień kedrę: %1</translation>
    </message>
    <message>
        <source>Change the seam allowance of %1</source>
        <translation>Zmień naddatek na szew: %1</translation>
    </message>
    <message>
        <source>Change the valley of %1</source>
        <translation>Zmień zagłębienie: %1</translation>
    </message>
    <message>
        <source>there is no fabric in &quot;%1&quot;</source>
        <translation>w „%1” nie ma materiału</translation>
    </message>
    <message>
        <source>the design uses &quot;%1&quot; itself; choose another name</source>
        <translation>model sam używa „%1”; wybierz inną nazwę</translation>
    </message>
    <message>
        <source>there is not enough memory to show this fabric</source>
        <translation>za mało pamięci, by pokazać ten materiał</translation>
    </message>
    <message>
        <source>Replace fabric %1 by %2</source>
        <translation>Zastąp materiał %1: %2</translation>
    </message>
    <message>
        <source>Change the limits of %1</source>
        <translation>Zmień granice: %1</translation>
    </message>
    <message>
        <source>Change the look of %1</source>
        <translation>Zmień wygląd: %1</translation>
    </message>
    <message>
        <source>Change the second colour of %1</source>
        <translation>Zmień drugi kolor: %1</translation>
    </message>
    <message>
        <source>Change the kind of %1</source>
        <translation>Zmień rodzaj: %1</translation>
    </message>
    <message>
        <source>there is no place for the files of this project</source>
        <translation>nie ma miejsca na pliki tego projektu</translation>
    </message>
    <message>
        <source>A side of this seam does not end at corners: its length cannot be changed alone.</source>
        <translation>Jedna ze stron tego szwu nie kończy się w rogach: nie można zmienić samej jej długości.</translation>
    </message>
    <message>
        <source>These edges cannot have this length: they hang together.</source>
        <translation>Te krawędzie nie mogą mieć tej długości: są ze sobą związane.</translation>
    </message>
    <message>
        <source>Change the length of an edge of %1</source>
        <translation>Zmień długość krawędzi: %1</translation>
    </message>
    <message>
        <source>Change the length of %1 edges</source>
        <translation>Zmień długość krawędzi (%1)</translation>
    </message>
    <message>
        <source>Make %1 edges equally long</source>
        <translation>Zrównaj długości krawędzi (%1)</translation>
    </message>
    <message>
        <source>Make the sides of a seam equally long</source>
        <translation>Zrównaj długości stron szwu</translation>
    </message>
    <message>
        <source>Make the sides of %1 seams equally long</source>
        <translation>Zrównaj długości stron szwów (%1)</translation>
    </message>
    <message>
        <source>There is a &quot;%1&quot; already: this one is called &quot;%2&quot;.</source>
        <translation>„%1” już istnieje: ten obiekt nazywa się „%2”.</translation>
    </message>
    <message>
        <source>Change the size of %1 patches</source>
        <translation>Zmień rozmiar elementów (%1)</translation>
    </message>
    <message>
        <source>%1: the rows hold more than the header of the file says; what is too much in each was left out</source>
        <translation>%1: wiersze zawierają więcej, niż podaje nagłówek pliku; nadmiar w każdym pominięto</translation>
    </message>
    <message>
        <source>this changes more at once than can be stored: at most %1 MB, and %2 keys; do it in parts</source>
        <translation>to zmienia naraz więcej, niż można zapisać: najwyżej %1&#xa0;MB i %2 kluczy; zrób to po kawałku</translation>
    </message>
    <message>
        <source>&quot;%1&quot; unpacks to more than any project; it was not made by Bolster, or is damaged</source>
        <translation>„%1” po rozpakowaniu jest większy niż jakikolwiek projekt; nie pochodzi z Bolstera lub jest uszkodzony</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which recovers projects for Bolster, cannot be started; install Bolster again</source>
        <translation>nie można uruchomić programu „%1”, który ratuje projekty dla Bolstera; zainstaluj Bolstera ponownie</translation>
    </message>
    <message>
        <source>nothing in &quot;%1&quot; can be saved: it is damaged in a way that takes too much time or memory</source>
        <translation>nic z „%1” nie da się uratować: uszkodzenie wymaga zbyt wiele czasu lub pamięci</translation>
    </message>
    <message>
        <source>lost: the table &quot;%1&quot;, which is missing or has other columns than it should</source>
        <translation>utracone: tabela „%1”, której brakuje lub która ma inne kolumny, niż powinna</translation>
    </message>
    <message>
        <source>lost: %1 more such gaps</source>
        <translation>utracone: dalsze takie luki (%1)</translation>
    </message>
    <message>
        <source>what comes after version %1 takes too long to recover</source>
        <translation>ratowanie tego, co następuje po wersji %1, trwa zbyt długo</translation>
    </message>
    <message>
        <source>the edit of version %1 does not lead to the design that was kept with it</source>
        <translation>zmiana wersji %1 nie prowadzi do modelu, który z nią zachowano</translation>
    </message>
    <message>
        <source>it pushes nothing: no part of the frame lies under the cover</source>
        <translation>nic nie wypycha: pod pokrowcem nie leży żadna część stelaża</translation>
    </message>
    <message>
        <source>contact looks at the frame in steps of %1 mm; something of these parts is thinner, so that the cover may pass through: %2; make it thicker</source>
        <translation>kontakt bada stelaż z krokiem %1&#xa0;mm; coś w tych częściach jest cieńsze, więc pokrowiec może przez nie przejść: %2; pogrub je</translation>
    </message>
    <message>
        <source>contact does nothing: in steps of %1 mm it finds no inside of the frame, which is thinner than that, or so open that it has none; close the frame, or make it thicker</source>
        <translation>kontakt nic nie robi: z krokiem %1&#xa0;mm nie znajduje wnętrza stelaża, który jest cieńszy lub tak otwarty, że go nie ma; zamknij stelaż lub go pogrub</translation>
    </message>
    <message>
        <source>%1 lies in folds: there is more cloth than room for it</source>
        <translation>%1 układa się w fałdy: materiału jest więcej niż miejsca</translation>
    </message>
    <message>
        <source>%1 floats free: nothing holds it, and it is sewn to nothing that is held</source>
        <translation>%1 unosi się swobodnie: nic tego elementu nie trzyma ani nie łączy z trzymanymi</translation>
    </message>
    <message>
        <source>%1 holds the cloth %2 mm off the frame</source>
        <translation>%1 trzyma materiał w odległości %2&#xa0;mm od stelaża</translation>
    </message>
    <message>
        <source>The seam of %1 and %2 has %3 % ease: it puckers above %4 %</source>
        <translation>Szew %1 i %2 ma wdanie %3%: powyżej %4% się marszczy</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations.</source>
        <translation>Powierzchnia uciekła po iteracjach w liczbie %1.</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations: %2 holds it %3 mm from everything else. Bring that curve nearer.</source>
        <translation>Powierzchnia uciekła po iteracjach w liczbie %1: %2 trzyma ją %3&#xa0;mm od wszystkiego innego. Przybliż tę krzywą.</translation>
    </message>
    <message>
        <source>The equations of the cover could not be solved: %1 is degenerate or its numbers are too large. Check its outline and its fabric.</source>
        <translation>Nie udało się rozwiązać równań pokrowca: element %1 jest zdegenerowany lub ma za duże liczby. Sprawdź kontur i materiał.</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations: the pressure of %2 (%3) is too high for its fabric. Lower it.</source>
        <translation>Powierzchnia uciekła po iteracjach w liczbie %1: ciśnienie (%2: %3) jest za wysokie dla materiału. Zmniejsz je.</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations, most likely because of %2. Check the size of that patch, its pressure and its fabric.</source>
        <translation>Powierzchnia uciekła po iteracjach w liczbie %1, najpewniej z powodu: %2. Sprawdź rozmiar, ciśnienie i materiał tego elementu.</translation>
    </message>
    <message>
        <source>Change the material of %1</source>
        <translation>Zmień tworzywo: %1</translation>
    </message>
    <message>
        <source>Show a part of %1</source>
        <translation>Pokaż część: %1</translation>
    </message>
    <message>
        <source>Hide a part of %1</source>
        <translation>Ukryj część: %1</translation>
    </message>
    <message>
        <source>Show all parts of %1</source>
        <translation>Pokaż wszystkie części: %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a link to &quot;%2&quot; now</source>
        <translation>„%1” jest teraz dowiązaniem do „%2”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was changed by another program</source>
        <translation>„%1” zmienił inny program</translation>
    </message>
    <message>
        <source>somebody else has changed &quot;%1&quot; since it was opened here</source>
        <translation>ktoś inny zmienił „%1” po otwarciu tutaj</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is another project now</source>
        <translation>„%1” jest teraz innym projektem</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be renamed (%2)</source>
        <translation>nie można zmienić nazwy „%1” (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: the content number %2 cannot be read</source>
        <translation>„%1” jest uszkodzony: nie można odczytać zawartości numer %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: a row holds something of another kind than it should</source>
        <translation>„%1” jest uszkodzony: wiersz zawiera coś innego rodzaju, niż powinien</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: row %2 of the table &quot;%3&quot; contradicts others</source>
        <translation>„%1” jest uszkodzony: wiersz %2 tabeli „%3” jest sprzeczny z innymi</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: parts of the file are not what was written</source>
        <translation>„%1” jest uszkodzony: części pliku nie są tym, co zapisano</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: rows are missing, or there are some too many</source>
        <translation>„%1” jest uszkodzony: brakuje wierszy lub jest ich za dużo</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: the edits up to number %2 do not lead to the design that was stored with them</source>
        <translation>„%1” jest uszkodzony: zmiany do numeru %2 nie prowadzą do modelu, który z nimi zapisano</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: row %2 of the table &quot;%3&quot; is not what was written</source>
        <translation>„%1” jest uszkodzony: wiersz %2 tabeli „%3” nie jest tym, co zapisano</translation>
    </message>
    <message>
        <source>there is no picture to write</source>
        <translation>nie ma obrazu do zapisania</translation>
    </message>
    <message>
        <source>%1: a face has %2 corners, and at most %3 are read; have it split into triangles by the program that has made the file</source>
        <translation>%1: ściana ma %2 rogów, a odczytywanych jest najwyżej %3; podziel ją na trójkąty w programie, który utworzył plik</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: no file can be made in &quot;%2&quot;; choose another folder</source>
        <translation>nie można zapisać „%1”: w „%2” nie można utworzyć pliku; wybierz inny folder</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>przerwano</translation>
    </message>
    <message>
        <source>at most %1 cushions push; this one and those after it are left out</source>
        <translation>wypycha najwyżej %1 wyściółek; ta i następne są pominięte</translation>
    </message>
    <message>
        <source>the picture cannot be encoded (%1)</source>
        <translation>nie można zakodować obrazu (%1)</translation>
    </message>
    <message>
        <source>a smallest detail of %1 mm is too fine for a frame as large as this (%2 million cubes of it, and %3 are the limit), so the cushion is left out; take at least %4 mm</source>
        <translation>najmniejszy szczegół %1&#xa0;mm jest za drobny dla tak dużego stelaża (%2&#xa0;mln sześcianów, granica to %3), więc wyściółka jest pominięta; weź co najmniej %4&#xa0;mm</translation>
    </message>
    <message>
        <source>something of these parts of the frame is thinner than the smallest detail of the padding, %1 mm, so that it may have gaps there: %2; take a smaller detail</source>
        <translation>coś w tych częściach stelaża jest cieńsze niż najmniejszy szczegół wyściółki, %1&#xa0;mm, więc mogą tam być luki: %2; weź mniejszy szczegół</translation>
    </message>
    <message>
        <source>it pushes nothing: with a smallest detail of %1 mm there is no inside of the frame, which is thinner than that, or so open that it has none; take a smaller detail, or close the frame</source>
        <translation>nic nie wypycha: przy najmniejszym szczególe %1&#xa0;mm stelaż nie ma wnętrza, bo jest cieńszy lub tak otwarty, że go nie ma; weź mniejszy szczegół lub zamknij stelaż</translation>
    </message>
    <message>
        <source>Change the slanted faces of %1</source>
        <translation>Zmień skośne ściany: %1</translation>
    </message>
    <message>
        <source>Change the smallest detail of %1</source>
        <translation>Zmień najmniejszy szczegół: %1</translation>
    </message>
    <message>
        <source>the log of &quot;%1&quot; is damaged: the last edits cannot be read</source>
        <translation>dziennik „%1” jest uszkodzony: nie można odczytać ostatnich zmian</translation>
    </message>
    <message>
        <source>the kind %1 is unknown; there are %2 and %3</source>
        <translation>rodzaj %1 jest nieznany; są %2 i %3</translation>
    </message>
    <message>
        <source>its label finds no room: make the words shorter, or put it elsewhere</source>
        <translation>opis się nie mieści: skróć słowa lub przenieś go gdzie indziej</translation>
    </message>
    <message>
        <source>its cut lines meet here: make the allowance smaller</source>
        <translation>linie cięcia spotykają się tutaj: zmniejsz naddatek</translation>
    </message>
    <message>
        <source>a notch of %1 mm reaches the sewing line, which is %2 mm away: make it shallower, or the allowance wider</source>
        <translation>nacięcie %1&#xa0;mm sięga linii szycia, odległej o %2&#xa0;mm: zmniejsz głębokość lub poszerz naddatek</translation>
    </message>
    <message>
        <source>nothing is sewn where it is, so it has no partner</source>
        <translation>nic tu nie jest szyte, więc nie ma odpowiednika</translation>
    </message>
    <message>
        <source>it has no partner on the other side of its seam: another notch is too near there</source>
        <translation>nie ma odpowiednika po drugiej stronie szwu: inne nacięcie jest tam zbyt blisko</translation>
    </message>
    <message>
        <source>it is %1 mm wide across the grain, but &quot;%2&quot; only %3 mm: split it, or turn its grain</source>
        <translation>ma w poprzek nitki %1&#xa0;mm, a „%2” tylko %3&#xa0;mm: podziel element lub obróć nitkę</translation>
    </message>
    <message>
        <source>an inner corner of %1 degrees is too sharp for its seam allowances: make them smaller there, or the corner wider</source>
        <translation>róg wewnętrzny %1° jest za ostry dla naddatków na szew: zmniejsz je tam lub rozewrzyj róg</translation>
    </message>
    <message>
        <source>There is no such place on an outline.</source>
        <translation>Nie ma takiego miejsca na konturze.</translation>
    </message>
    <message>
        <source>A part of this stretch of %1 has a seam allowance of its own already: change that one, or choose another stretch.</source>
        <translation>Część tego odcinka (%1) ma już własny naddatek na szew: zmień go lub wybierz inny odcinek.</translation>
    </message>
    <message>
        <source>There is a notch of %1 at this place already.</source>
        <translation>W tym miejscu już jest nacięcie: %1.</translation>
    </message>
    <message>
        <source>This corner of %1 has a join of its own already.</source>
        <translation>Ten róg (%1) ma już własny kształt.</translation>
    </message>
    <message>
        <source>Change the seam allowance of %1 patches</source>
        <translation>Zmień naddatek na szew elementów (%1)</translation>
    </message>
    <message>
        <source>Change the seam allowance of an edge of %1</source>
        <translation>Zmień naddatek na szew krawędzi: %1</translation>
    </message>
    <message>
        <source>Change a corner of the cut line of %1</source>
        <translation>Zmień róg linii cięcia: %1</translation>
    </message>
    <message>
        <source>Add a notch to %1</source>
        <translation>Dodaj nacięcie: %1</translation>
    </message>
    <message>
        <source>Move a notch</source>
        <translation>Przesuń nacięcie</translation>
    </message>
    <message>
        <source>Move the join of a corner</source>
        <translation>Przesuń kształt rogu</translation>
    </message>
    <message>
        <source>A drill hole must lie inside its patch.</source>
        <translation>Nawiert musi leżeć wewnątrz elementu.</translation>
    </message>
    <message>
        <source>Move %1 drill holes</source>
        <translation>Przesuń nawierty (%1)</translation>
    </message>
    <message>
        <source>Move the label of %1</source>
        <translation>Przesuń opis: %1</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that has its own seam allowance.</source>
        <translation>Odcinek nakładałby się na inny z własnym naddatkiem na szew (%1).</translation>
    </message>
    <message>
        <source>Give an edge its own seam allowance</source>
        <translation>Nadaj krawędzi własny naddatek na szew</translation>
    </message>
    <message>
        <source>Change a corner of the cut line</source>
        <translation>Zmień róg linii cięcia</translation>
    </message>
    <message>
        <source>Add drill hole %1</source>
        <translation>Dodaj nawiert %1</translation>
    </message>
    <message>
        <source>Change the diameter of %1</source>
        <translation>Zmień średnicę: %1</translation>
    </message>
    <message>
        <source>Change the notches of %1</source>
        <translation>Zmień nacięcia: %1</translation>
    </message>
    <message>
        <source>Change the automatic notches</source>
        <translation>Zmień nacięcia automatyczne</translation>
    </message>
    <message>
        <source>Add a notch</source>
        <translation>Dodaj nacięcie</translation>
    </message>
    <message>
        <source>Change how %1 is cut</source>
        <translation>Zmień krojenie: %1</translation>
    </message>
    <message>
        <source>Change how the pattern is cut</source>
        <translation>Zmień krojenie wykroju</translation>
    </message>
    <message>
        <source>Add internal line %1</source>
        <translation>Dodaj linię wewnętrzną %1</translation>
    </message>
    <message>
        <source>Change the purpose of %1</source>
        <translation>Zmień przeznaczenie: %1</translation>
    </message>
    <message>
        <source>Change the ease of %1</source>
        <translation>Zmień wdanie: %1</translation>
    </message>
    <message>
        <source>is %1, but must be a whole number; %2 are cut</source>
        <translation>wynosi %1, a musi być liczbą całkowitą; krojonych jest: %2</translation>
    </message>
    <message>
        <source>%1 is an allowance of a part of this stretch already; remove one of the two, or make their stretches meet</source>
        <translation>%1 jest już naddatkiem części tego odcinka; usuń jeden z nich lub zetknij ich odcinki</translation>
    </message>
    <message>
        <source>the hole lies outside of &quot;%1&quot;; move it inside</source>
        <translation>nawiert leży poza „%1”; przesuń go do środka</translation>
    </message>
    <message>
        <source>its sides are %1 mm and %2 mm long: true the seam, or say in its properties how much ease is wanted</source>
        <translation>strony mają długość %1&#xa0;mm i %2&#xa0;mm: wyrównaj szew lub podaj w jego właściwościach żądane wdanie</translation>
    </message>
    <message>
        <source>its sides are %1 mm and %2 mm long, but the second one shall be longer by %3 mm: true the seam, or change the ease in its properties</source>
        <translation>strony mają długość %1&#xa0;mm i %2&#xa0;mm, a druga ma być dłuższa o %3&#xa0;mm: wyrównaj szew lub zmień wdanie w jego właściwościach</translation>
    </message>
    <message>
        <source>The mouth of a dart must be at least 1 mm wide.</source>
        <translation>Rozwarcie zaszewki musi mieć co najmniej 1&#xa0;mm szerokości.</translation>
    </message>
    <message>
        <source>The tip of a dart must lie inside its patch, at least 5 mm from its mouth.</source>
        <translation>Wierzchołek zaszewki musi leżeć wewnątrz elementu, co najmniej 5&#xa0;mm od rozwarcia.</translation>
    </message>
    <message>
        <source>The legs of the dart would cross the outline of %1: put its tip elsewhere.</source>
        <translation>Ramiona zaszewki przecinałyby kontur (%1): umieść wierzchołek gdzie indziej.</translation>
    </message>
    <message>
        <source>Add a dart to %1</source>
        <translation>Dodaj zaszewkę: %1</translation>
    </message>
    <message>
        <source>Select the seam of a dart.</source>
        <translation>Zaznacz szew zaszewki.</translation>
    </message>
    <message>
        <source>Without this dart the outline of %1 would cross itself.</source>
        <translation>Bez tej zaszewki kontur (%1) przecinałby sam siebie.</translation>
    </message>
    <message>
        <source>Move a dart of %1</source>
        <translation>Przesuń zaszewkę: %1</translation>
    </message>
    <message>
        <source>there is no piece in it</source>
        <translation>nie ma w nim żadnego elementu</translation>
    </message>
    <message>
        <source>Import a pattern of %1 pieces</source>
        <translation>Importuj wykrój (elementy: %1)</translation>
    </message>
    <message>
        <source>%1 is left out: its outline crosses itself or encloses nothing</source>
        <translation>%1 pominięto: kontur przecina sam siebie lub nic nie obejmuje</translation>
    </message>
    <message>
        <source>%1: %2 notches or lines belong to nothing and are left out</source>
        <translation>%1: nacięcia lub linie bez przynależności pominięto: %2</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 points)</source>
        <translation>%1: narysowano więcej, niż może mieć wykrój (ponad %2 punktów)</translation>
    </message>
    <message>
        <source>%1: the file is larger than a pattern can be (%2 MB)</source>
        <translation>%1: plik jest większy, niż może być wykrój (%2&#xa0;MB)</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a group code of DXF</source>
        <translation>%1: „%2” nie jest kodem grupy DXF</translation>
    </message>
    <message>
        <source>%1: the file ends in the middle of something</source>
        <translation>%1: plik urywa się w połowie</translation>
    </message>
    <message>
        <source>%1 is not a DXF file: it has no sections</source>
        <translation>%1 nie jest plikiem DXF: nie ma sekcji</translation>
    </message>
    <message>
        <source>%1 is not an SVG file</source>
        <translation>%1 nie jest plikiem SVG</translation>
    </message>
    <message>
        <source>%1: this is not well-formed XML (%2)</source>
        <translation>%1: to nie jest poprawny składniowo XML (%2)</translation>
    </message>
    <message>
        <source>Sew %1 proposed seams</source>
        <translation>Zszyj proponowane szwy (%1)</translation>
    </message>
    <message>
        <source>Remove a dart of %1</source>
        <translation>Usuń zaszewkę: %1</translation>
    </message>
    <message>
        <source>Move the tip of a dart of %1</source>
        <translation>Przesuń wierzchołek zaszewki: %1</translation>
    </message>
    <message>
        <source>Opened there, the outline of %1 would cross itself.</source>
        <translation>Po otwarciu w tym miejscu kontur (%1) przecinałby sam siebie.</translation>
    </message>
    <message>
        <source>The legs of the dart must be of one length to be rotated: drag its tip onto the dotted line.</source>
        <translation>Do przeniesienia ramiona zaszewki muszą być równe: przeciągnij wierzchołek na linię kropkowaną.</translation>
    </message>
    <message>
        <source>A dart is rotated to a place at least 5 mm from its mouth.</source>
        <translation>Zaszewkę przenosi się w miejsce odległe o co najmniej 5&#xa0;mm od rozwarcia.</translation>
    </message>
    <message>
        <source>The line from the tip of the dart to there would leave %1.</source>
        <translation>Linia stąd do wierzchołka zaszewki wychodziłaby poza: %1.</translation>
    </message>
    <message>
        <source>%1 lies across the line from the tip of the dart to there: move it, or rotate the dart elsewhere.</source>
        <translation>%1 leży w poprzek linii od wierzchołka zaszewki do tego miejsca: przesuń lub przenieś zaszewkę gdzie indziej.</translation>
    </message>
    <message>
        <source>Rotate a dart of %1</source>
        <translation>Przenieś zaszewkę: %1</translation>
    </message>
    <message>
        <source>Smooth outlines across ends of seams</source>
        <translation>Wygładź kontury na końcach szwów</translation>
    </message>
    <message>
        <source>This seam ends in no corners: there is nothing to smooth.</source>
        <translation>Ten szew nie kończy się w rogach: nie ma czego wygładzać.</translation>
    </message>
    <message>
        <source>The outlines meet at more than 60° there: that is a corner, and stays one.</source>
        <translation>Kontury spotykają się tam pod kątem ponad 60°: to róg i nim pozostanie.</translation>
    </message>
    <message>
        <source>Sew earlier</source>
        <translation>Szyj wcześniej</translation>
    </message>
    <message>
        <source>Sew later</source>
        <translation>Szyj później</translation>
    </message>
    <message>
        <source>Sew in the proposed order</source>
        <translation>Szyj w proponowanej kolejności</translation>
    </message>
    <message>
        <source>Change the zip of %1</source>
        <translation>Zmień zamek: %1</translation>
    </message>
    <message>
        <source>Change when %1 is sewn</source>
        <translation>Zmień kolejność szycia: %1</translation>
    </message>
    <message>
        <source>its sides have allowances of %1 mm and %2 mm: make them alike, or mind it when they are laid together</source>
        <translation>strony mają naddatki %1&#xa0;mm i %2&#xa0;mm: zrównaj je lub pamiętaj o tym przy składaniu</translation>
    </message>
    <message>
        <source>This edge of %1 is not as long as that.</source>
        <translation>Ta krawędź (%1) nie jest tak długa.</translation>
    </message>
    <message>
        <source>the pattern is so large that the edge length of its triangles becomes %1 mm; is the unit right?</source>
        <translation>wykrój jest tak duży, że długość krawędzi trójkątów wyniesie %1&#xa0;mm; czy jednostka jest właściwa?</translation>
    </message>
    <message>
        <source>%1 is left out: it is %2 m large, the most is %3 m; is the unit right?</source>
        <translation>%1 pominięto: ma rozmiar %2&#xa0;m, a najwyżej może mieć %3&#xa0;m; czy jednostka jest właściwa?</translation>
    </message>
    <message>
        <source>%1 is left out: its outline has fewer than three points</source>
        <translation>%1 pominięto: kontur ma mniej niż trzy punkty</translation>
    </message>
    <message>
        <source>%1 is left out: of the %2 points of its outline no curve with at most %3 can be made</source>
        <translation>%1 pominięto: z punktów konturu (%2) nie da się zrobić krzywej mającej najwyżej %3</translation>
    </message>
    <message>
        <source>%1: its outline has more than %2 points and is simplified, by %3 mm at most</source>
        <translation>%1: kontur ma ponad %2 punktów i zostaje uproszczony, najwyżej o %3&#xa0;mm</translation>
    </message>
    <message>
        <source>%1: its quantity &quot;%2&quot; is no number of pieces; it is cut once until somebody says how often</source>
        <translation>%1: „%2” nie jest liczbą sztuk; element kroi się raz, dopóki ktoś nie poda, ile razy</translation>
    </message>
    <message>
        <source>%1: its quantity %2 is more than possible and becomes %3</source>
        <translation>%1: liczba sztuk %2 jest większa niż możliwa i zmienia się na %3</translation>
    </message>
    <message>
        <source>%1: %2 drill holes are narrower than %3 mm or wider than %4 mm and become as wide as possible</source>
        <translation>%1: nawierty węższe niż %3&#xa0;mm lub szersze niż %4&#xa0;mm: %2; dostają najbliższą możliwą średnicę</translation>
    </message>
    <message>
        <source>%1 is left out: it would be a patch with mistakes</source>
        <translation>%1 pominięto: byłby to element z błędami</translation>
    </message>
    <message>
        <source>%1: the file ends in the middle of its section %2, so it is not whole; get it once more</source>
        <translation>%1: plik kończy się w środku sekcji %2, nie jest więc cały; pobierz go ponownie</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 groups)</source>
        <translation>%1: narysowano więcej, niż może mieć wykrój (ponad %2 grup)</translation>
    </message>
    <message>
        <source>%1: %2 is larger than any pattern (%3)</source>
        <translation>%1: %2 przekracza rozmiar każdego wykroju (%3)</translation>
    </message>
    <message>
        <source>the mark at the end of the file (EOF) is missing: look whether everything is there</source>
        <translation>brakuje znaku końca pliku (EOF): sprawdź, czy wszystko jest</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is inserted more often than a pattern needs (over %3 times)</source>
        <translation>%1: „%2” wstawiono częściej, niż potrzebuje wykrój (ponad %3 razy)</translation>
    </message>
    <message>
        <source>%1: an element has more than %2 attributes</source>
        <translation>%1: element ma więcej niż %2 atrybutów</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 elements)</source>
        <translation>%1: narysowano więcej, niż może mieć wykrój (ponad %2 elementów)</translation>
    </message>
    <message>
        <source>%1: elements lie in each other more than %2 times</source>
        <translation>%1: elementy są zagnieżdżone ponad %2 razy</translation>
    </message>
    <message>
        <source>&quot;%1&quot; would be replaced, which is needed; choose another name</source>
        <translation>zastąpiono by „%1”, a jest potrzebny; wybierz inną nazwę</translation>
    </message>
    <message>
        <source>there is no cover yet: nothing is sewn or solved</source>
        <translation>nie ma jeszcze pokrowca: nic nie zszyto ani nie obliczono</translation>
    </message>
    <message>
        <source>there is not enough memory for this file</source>
        <translation>za mało pamięci na ten plik</translation>
    </message>
    <message>
        <source>the cover cannot be made a file (%1)</source>
        <translation>z pokrowca nie można zrobić pliku (%1)</translation>
    </message>
    <message>
        <source>the cover is %1 mm thick and has %2 cm³</source>
        <translation>pokrowiec ma grubość %1&#xa0;mm i objętość %2&#xa0;cm³</translation>
    </message>
    <message>
        <source>there is no room for foam between the frame and the cover</source>
        <translation>między stelażem a pokrowcem nie ma miejsca na piankę</translation>
    </message>
    <message>
        <source>the foam has %1 l and weighs %2 kg at %3 kg/m³</source>
        <translation>pianka ma %1&#xa0;l i waży %2&#xa0;kg przy %3&#xa0;kg/m³</translation>
    </message>
    <message>
        <source>there are neither fixation curves nor seams</source>
        <translation>nie ma ani krzywych mocowania, ani szwów</translation>
    </message>
    <message>
        <source>The three places lie on a line: choose some that do not.</source>
        <translation>Te trzy miejsca leżą na jednej prostej: wybierz inne.</translation>
    </message>
    <message>
        <source>The places are not as far from each other on the scan as where they belong: check the scale of the scan, and which is which.</source>
        <translation>Odległości między miejscami na skanie są inne niż tam, gdzie one należą: sprawdź skalę skanu i które jest które.</translation>
    </message>
    <message>
        <source>The scan could not be aligned: there are not enough of its points where it would stand. Click other places, or bring back what is cut away of it.</source>
        <translation>Nie udało się wyrównać skanu: tam, gdzie by stał, jest za mało jego punktów. Kliknij inne miejsca lub przywróć to, co z niego odcięto.</translation>
    </message>
    <message>
        <source>%1: the numbers of &quot;%2&quot; are not described as they must be: &quot;%3&quot;</source>
        <translation>%1: liczby „%2” nie są opisane tak, jak trzeba: „%3”</translation>
    </message>
    <message>
        <source>%1: the file is damaged: something is said to be at byte %2, where nothing can be; copy it again, or export the scan anew</source>
        <translation>%1: plik jest uszkodzony: coś ma się znajdować przy bajcie %2, gdzie nic być nie może; skopiuj go ponownie lub wyeksportuj skan od nowa</translation>
    </message>
    <message>
        <source>%1: the file is damaged: a checksum is wrong; copy it again, or export the scan anew</source>
        <translation>%1: plik jest uszkodzony: błędna suma kontrolna; skopiuj go ponownie lub wyeksportuj skan od nowa</translation>
    </message>
    <message>
        <source>%1 is not an E57 file</source>
        <translation>%1 nie jest plikiem E57</translation>
    </message>
    <message>
        <source>%1: E57 of version %2 cannot be read, or its pages have another size than 1024; export the scan as E57 1.0</source>
        <translation>%1: nie można odczytać E57 w wersji %2 lub jego strony mają inny rozmiar niż 1024; wyeksportuj skan jako E57 1.0</translation>
    </message>
    <message>
        <source>%1: the pose of a scan is no rotation and translation</source>
        <translation>%1: położenie skanu nie jest obrotem i przesunięciem</translation>
    </message>
    <message>
        <source>%1: two scans are said to be at one place of the file; export them anew</source>
        <translation>%1: dwa skany mają być w tym samym miejscu pliku; wyeksportuj je od nowa</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; of the points is missing or no number of things</source>
        <translation>%1: brakuje „%2” punktów lub nie jest to liczność</translation>
    </message>
    <message>
        <source>%1: the file is damaged: a packet of points is not as it must be; export the scan anew</source>
        <translation>%1: plik jest uszkodzony: pakiet punktów nie jest taki, jak trzeba; wyeksportuj skan od nowa</translation>
    </message>
    <message>
        <source>%1: the points are packed by &quot;%2&quot;, which cannot be read; export the scan without an extension</source>
        <translation>%1: punkty są spakowane przez „%2”, czego nie można odczytać; wyeksportuj skan bez rozszerzenia</translation>
    </message>
    <message>
        <source>%1: more is described in it than a scan can have</source>
        <translation>%1: opisano w nim więcej, niż może mieć skan</translation>
    </message>
    <message>
        <source>%1: numbers that belong to one point lie too far from each other; export the scan anew</source>
        <translation>%1: liczby należące do jednego punktu leżą zbyt daleko od siebie; wyeksportuj skan od nowa</translation>
    </message>
    <message>
        <source>%1: a document type is not expected here</source>
        <translation>%1: nieoczekiwany typ dokumentu</translation>
    </message>
    <message>
        <source>%1 is not a LAS file</source>
        <translation>%1 nie jest plikiem LAS</translation>
    </message>
    <message>
        <source>%1 is compressed (LAZ), which cannot be read: save it as LAS, for example with laszip or CloudCompare, or as E57</source>
        <translation>%1 jest skompresowany (LAZ), a tego nie można odczytać: zapisz jako LAS, na przykład programem laszip lub CloudCompare, albo jako E57</translation>
    </message>
    <message>
        <source>%1: points of format %2 with %3 bytes cannot be read; save them as LAS 1.2 or 1.4</source>
        <translation>%1: nie można odczytać punktów formatu %2 o długości %3&#xa0;B; zapisz je jako LAS 1.2 lub 1.4</translation>
    </message>
    <message>
        <source>%1: its scale and offset make no points</source>
        <translation>%1: skala i przesunięcie nie dają punktów</translation>
    </message>
    <message>
        <source>%1: the points are said to begin within the header</source>
        <translation>%1: punkty mają się zaczynać wewnątrz nagłówka</translation>
    </message>
    <message>
        <source>The second side ends inside an edge, so the first one was changed.</source>
        <translation>Druga strona kończy się wewnątrz krawędzi, zmieniono więc pierwszą.</translation>
    </message>
    <message>
        <source>it has no triangle with an area</source>
        <translation>nie ma trójkąta o niezerowym polu</translation>
    </message>
    <message>
        <source>%1 is left out: laid flat it would lie over itself. Divide it, or cut it in where it bulges most</source>
        <translation>kawałek %1 pominięto: po rozłożeniu nachodziłby sam na siebie. Podziel go lub natnij tam, gdzie jest najbardziej wypukły</translation>
    </message>
    <message>
        <source>the stretch does not lie on its outline any more. Sew or fix it anew.</source>
        <translation>odcinek nie leży już na swoim konturze. Zszyj lub zamocuj go od nowa.</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which reads such files for Bolster, cannot be started; install Bolster again</source>
        <translation>nie można uruchomić programu „%1”, który odczytuje takie pliki dla Bolstera; zainstaluj Bolstera ponownie</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes too long to read; export fewer parts of it, or triangles (OBJ, STL) instead</source>
        <translation>odczyt „%1” trwa zbyt długo; wyeksportuj mniej części lub trójkąty (OBJ, STL)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be read: it is damaged, or needs too much memory; export it again, or fewer parts of it, from the program that it comes from</source>
        <translation>nie udało się odczytać „%1”: plik jest uszkodzony lub wymaga zbyt dużo pamięci; wyeksportuj go ponownie lub mniej jego części z programu, z którego pochodzi</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds no faces, and a frame needs some; export bodies or surfaces, not lines and points alone</source>
        <translation>„%1” nie zawiera ścian, a stelaż ich wymaga; eksportuj bryły lub powierzchnie, nie same linie i punkty</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than %2 triangles; export fewer parts of it, or coarser</source>
        <translation>„%1” ma ponad %2 trójkątów; wyeksportuj mniej części lub zgrubniej</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than %2 parts; export those that the cover touches</source>
        <translation>„%1” ma ponad %2 części; wyeksportuj te, których dotyka pokrowiec</translation>
    </message>
    <message>
        <source>%1: the part &quot;%2&quot; reaches beyond 10,000,000; export it without that part, or near the origin</source>
        <translation>%1: część „%2” wykracza poza 10&#xa0;000&#xa0;000; wyeksportuj bez tej części lub blisko początku układu</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs the file &quot;%2&quot; in its own folder; copy it there, or export as GLB, which is one file</source>
        <translation>„%1” wymaga pliku „%2” we własnym folderze; skopiuj go tam lub wyeksportuj jako GLB, który jest jednym plikiem</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged or incomplete, or not what its ending says; export it again from the program that it comes from</source>
        <translation>„%1” jest uszkodzony lub niekompletny albo nie jest tym, co mówi rozszerzenie; wyeksportuj go ponownie z programu, z którego pochodzi</translation>
    </message>
    <message>
        <source>%1: %2 triangles are left out: their corners are no numbers</source>
        <translation>%1: pominięto trójkąty, których rogi nie są liczbami: %2</translation>
    </message>
    <message>
        <source>%1: parts are left out that are scaled to nothing: %2, the first is &quot;%3&quot;</source>
        <translation>%1: pominięto części zmniejszone do zera: %2, pierwsza to „%3”</translation>
    </message>
    <message>
        <source>%1: %2 faces could not be made triangles of, and leave holes</source>
        <translation>%1: ścian niepodzielonych na trójkąty: %2; zostają po nich dziury</translation>
    </message>
    <message>
        <source>%1: %2 parts are left out that lie too deep in the tree</source>
        <translation>%1: pominięto części leżące zbyt głęboko w drzewie: %2</translation>
    </message>
    <message>
        <source>%1: the parts in the file &quot;%2&quot; are not read; export all in one file</source>
        <translation>%1: części z pliku „%2” nie są odczytywane; wyeksportuj wszystko w jednym pliku</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no file that frames are written to; OBJ, PLY and STL are</source>
        <translation>„%1” nie jest plikiem, do którego zapisuje się stelaże; są nimi OBJ, PLY i STL</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a scan that can be read; these can: %2</source>
        <translation>„%1” nie jest skanem, który można odczytać; można: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a frame that can be read; these can: %2</source>
        <translation>„%1” nie jest stelażem, który można odczytać; można: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a pattern that can be read; these can: %2</source>
        <translation>„%1” nie jest wykrojem, który można odczytać; można: %2</translation>
    </message>
    <message>
        <source>nothing is left of the parts that are wanted</source>
        <translation>z żądanych części nic nie zostaje</translation>
    </message>
    <message>
        <source>nothing is sewn where %1 of its notches are, so they have no partners</source>
        <translation>nacięcia tam, gdzie nic się nie szyje, więc bez odpowiedników: %1</translation>
    </message>
    <message>
        <source>notches at edges without an allowance cut into the piece: there are %1; give these edges an allowance</source>
        <translation>nacięcia na krawędziach bez naddatku wcinają się w element: %1; nadaj tym krawędziom naddatek</translation>
    </message>
    <message>
        <source>There is a dart already: put this one beside it, or remove that one first.</source>
        <translation>Jest tu już zaszewka: umieść tę obok niej lub najpierw usuń tamtą.</translation>
    </message>
    <message>
        <source>%1 is left out: with its holes, notches and lines the design would have more than %2 elements</source>
        <translation>%1 pominięto: z jego otworami, nacięciami i liniami model miałby ponad %2 obiektów</translation>
    </message>
    <message>
        <source>%1: its nap &quot;%2&quot; is neither one way, two ways nor any; it is taken for two ways</source>
        <translation>%1: włos „%2” nie oznacza jednego, dwóch ani dowolnego kierunku; przyjęto dwa kierunki</translation>
    </message>
    <message>
        <source>%1 is drawn larger by what its fabric shrinks (%2), and taken as it is drawn: a shrinkage of the fabric here would come on top</source>
        <translation>element %1 jest narysowany większy o skurcz materiału (%2) i tak przyjęty: skurcz podany tutaj doszedłby do tego</translation>
    </message>
    <message>
        <source>the viewBox &quot;%1&quot; is no four numbers and is left out: check the size of the pieces</source>
        <translation>viewBox „%1” to nie cztery liczby i zostaje pominięty: sprawdź rozmiar elementów</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs the file &quot;%2&quot; beside it, and the frame of a design is one file; import it again, or export it as GLB</source>
        <translation>„%1” wymaga obok pliku „%2”, a stelaż modelu to jeden plik; zaimportuj go ponownie lub wyeksportuj jako GLB</translation>
    </message>
    <message>
        <source>99 % of its surface is within %1 mm</source>
        <translation>99% powierzchni mieści się w %1&#xa0;mm</translation>
    </message>
    <message>
        <source>it reaches beyond its piece: end it at the edge</source>
        <translation>wystaje poza element: zakończ na krawędzi</translation>
    </message>
    <message>
        <source>the hole breaks through the edge of its piece: move it inwards, or make it smaller</source>
        <translation>nawiert przebija krawędź elementu: przesuń go do środka lub zmniejsz</translation>
    </message>
    <message>
        <source>only %1 mm are left of the piece at the tip of a dart: make it shorter</source>
        <translation>przy wierzchołku zaszewki zostaje tylko %1&#xa0;mm elementu: skróć ją</translation>
    </message>
    <message>
        <source>%1 of its notches have no partners on the other sides of their seams: others are too near there. Ask for fewer</source>
        <translation>nacięcia bez odpowiedników po drugiej stronie szwów: %1; inne są tam zbyt blisko. Zażądaj mniejszej liczby</translation>
    </message>
    <message>
        <source>%1 has %2 sewing lines beside each other; the largest is taken, the others are left out</source>
        <translation>%1 ma obok siebie linie szycia w liczbie %2; wzięto największą, pozostałe pominięto</translation>
    </message>
    <message>
        <source>%1: its cut line lies %2 mm outside of its sewing line, which is wider than an allowance may be; it becomes %3 mm there</source>
        <translation>%1: linia cięcia leży %2&#xa0;mm poza linią szycia, czyli dalej, niż może sięgać naddatek; będzie tam %3&#xa0;mm</translation>
    </message>
    <message>
        <source>The cover is pulled to the scan where it lies now: switch &quot;Fit the cover to it&quot; off, place it, and switch that on again.</source>
        <translation>Pokrowiec jest przyciągany do obecnego położenia skanu: wyłącz „Dopasuj pokrowiec”, umieść skan i włącz to ponownie.</translation>
    </message>
    <message>
        <source>Place on the cover to %2 mm rms: %1 (%3 % of its points matched)</source>
        <translation>Umieść na pokrowcu z dokładnością %2&#xa0;mm RMS: %1 (sparowano %3% punktów)</translation>
    </message>
    <message>
        <source>The scan could not be placed: it is too far from the cover. Align it by three places, or cut away what does not belong to it.</source>
        <translation>Nie udało się umieścić skanu: jest za daleko od pokrowca. Wyrównaj go według trzech miejsc lub odetnij to, co do niego nie należy.</translation>
    </message>
    <message>
        <source>Align to %2 mm rms: %1 (%3 % of its points matched)</source>
        <translation>Wyrównaj z dokładnością %2&#xa0;mm RMS: %1 (sparowano %3% punktów)</translation>
    </message>
    <message>
        <source>Import the pattern of %1</source>
        <translation>Importuj wykrój: %1</translation>
    </message>
    <message>
        <source>%1: a gap of %2 mm in its outline is closed by a straight line</source>
        <translation>%1: przerwę %2&#xa0;mm w konturze zamknięto linią prostą</translation>
    </message>
    <message>
        <source>%1: its cut line is drawn anew from its allowances, and differs from that of the file by up to %2 mm</source>
        <translation>%1: linia cięcia jest rysowana na nowo z naddatków i różni się od tej z pliku do %2&#xa0;mm</translation>
    </message>
    <message>
        <source>the size &quot;%1&quot; of the page is in no unit that is known and is left out: check the size of the pieces</source>
        <translation>rozmiar strony „%1” jest w nieznanej jednostce i zostaje pominięty: sprawdź rozmiar elementów</translation>
    </message>
    <message>
        <source>Sew a proposed seam</source>
        <translation>Zszyj proponowany szew</translation>
    </message>
    <message>
        <source>it is in %1 pieces</source>
        <translation>składa się z kawałków: %1</translation>
    </message>
    <message>
        <source>one piece of less than 1 cm³ is left out</source>
        <translation>pominięto jeden kawałek poniżej 1&#xa0;cm³</translation>
    </message>
    <message>
        <source>%1 pieces of less than 1 cm³ are left out</source>
        <translation>pominięto kawałki poniżej 1&#xa0;cm³: %1</translation>
    </message>
    <message>
        <source>Change whether the cover fits %1</source>
        <translation>Zmień dopasowanie pokrowca: %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs too much memory: it has too many parts, or places them too often; export those that the cover touches</source>
        <translation>„%1” wymaga zbyt dużo pamięci: ma za dużo części lub umieszcza je zbyt często; wyeksportuj te, których dotyka pokrowiec</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has decimal commas; export it with decimal points</source>
        <translation>„%1” ma przecinki dziesiętne; wyeksportuj z kropkami</translation>
    </message>
    <message>
        <source>%1: triangles are left out that name points which are not in the file</source>
        <translation>%1: pominięto trójkąty z punktami, których nie ma w pliku</translation>
    </message>
    <message>
        <source>%1: %2 triangles are left out: they name points that are not in the file</source>
        <translation>%1: pominięto trójkąty z punktami, których nie ma w pliku: %2</translation>
    </message>
    <message>
        <source>%1: none of its %2 points has a place</source>
        <translation>%1: żaden z punktów (%2) nie ma położenia</translation>
    </message>
    <message>
        <source>%1: %2 points are left out: they have no place, as where a scanner saw nothing</source>
        <translation>%1: pominięto punkty bez położenia, jak tam, gdzie skaner nic nie widział: %2</translation>
    </message>
    <message>
        <source>%1 is text in UTF-16, which is not read; save it as UTF-8</source>
        <translation>%1 to tekst w UTF-16, który nie jest odczytywany; zapisz go jako UTF-8</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; has a decimal comma; export with decimal points</source>
        <translation>%1: „%2” ma przecinek dziesiętny; wyeksportuj z kropkami</translation>
    </message>
    <message>
        <source>Make the pattern of a form</source>
        <translation>Utwórz wykrój formy</translation>
    </message>
    <message>
        <source>Fit the pattern to a goal</source>
        <translation>Dopasuj wykrój do celu</translation>
    </message>
    <message>
        <source>it has %1 triangles, and cannot be made simpler</source>
        <translation>ma %1 trójkątów i nie da się uprościć</translation>
    </message>
    <message>
        <source>The form has %1 triangles; %2 stand for it, which are up to %3 mm off</source>
        <translation>Forma ma %1 trójkątów; zastępuje je %2, z odchyłką do %3&#xa0;mm</translation>
    </message>
    <message>
        <source>%1 ends inside a piece, at %2: it is cut in there like a dart. The next line or border is %3 mm away; draw it on to there to divide the piece</source>
        <translation>%1 kończy się wewnątrz kawałka, w %2: nacięto tam jak zaszewkę. Do następnej linii lub brzegu jest %3&#xa0;mm; przedłuż do tego miejsca, aby podzielić kawałek</translation>
    </message>
    <message>
        <source>No place of the cover is near the form: put it where the cover is, in millimetres.</source>
        <translation>Żadne miejsce pokrowca nie jest blisko formy: umieść ją tam, gdzie pokrowiec, w milimetrach.</translation>
    </message>
    <message>
        <source>Nothing that may change does anything to the cover.</source>
        <translation>Nic z tego, co może się zmienić, nie wpływa na pokrowiec.</translation>
    </message>
    <message>
        <source>A step would have turned the outline of %1 over itself; a smaller one was taken</source>
        <translation>Krok wywinąłby kontur (%1) na siebie; wykonano mniejszy</translation>
    </message>
    <message>
        <source>Nothing may change.</source>
        <translation>Nic nie może się zmienić.</translation>
    </message>
    <message>
        <source>The cover does not come to rest.</source>
        <translation>Pokrowiec się nie stabilizuje.</translation>
    </message>
    <message>
        <source>Make %1 longer by %3 mm where it is sewn to %2</source>
        <translation>Wydłuż %1 o %3&#xa0;mm na szwie z: %2</translation>
    </message>
    <message>
        <source>Make %1 shorter by %3 mm where it is sewn to %2</source>
        <translation>Skróć %1 o %3&#xa0;mm na szwie z: %2</translation>
    </message>
    <message>
        <source>Move the seam of %1 and %2 by %3 mm into %2</source>
        <translation>Przesuń szew %1 i %2 o %3&#xa0;mm w głąb: %2</translation>
    </message>
    <message>
        <source>Move the seam of %1 and %2 by %3 mm into %1</source>
        <translation>Przesuń szew %1 i %2 o %3&#xa0;mm w głąb: %1</translation>
    </message>
    <message>
        <source>Let out the corner of %1 at %2 by %3 mm</source>
        <translation>Wysuń róg (%1) przy %2 o %3&#xa0;mm</translation>
    </message>
    <message>
        <source>Take in the corner of %1 at %2 by %3 mm</source>
        <translation>Cofnij róg (%1) przy %2 o %3&#xa0;mm</translation>
    </message>
    <message>
        <source>Cut a dart into %1 at %2, %3 mm wide and %4 mm deep</source>
        <translation>Natnij zaszewkę (%1) przy %2, szeroką na %3&#xa0;mm i głęboką na %4&#xa0;mm</translation>
    </message>
    <message>
        <source>Make the seam of %1 and %2 smooth</source>
        <translation>Wygładź szew: %1 i %2</translation>
    </message>
    <message>
        <source>Let the seam of %1 and %2 be sharp</source>
        <translation>Pozostaw szew ostry: %1 i %2</translation>
    </message>
    <message>
        <source>it is no file of preferences: it breaks off or has a mistake at character %1; choose one that Bolster has exported</source>
        <translation>to nie jest plik preferencji: urywa się lub ma błąd przy znaku %1; wybierz plik wyeksportowany przez Bolstera</translation>
    </message>
    <message>
        <source>it is no file of preferences; choose one that Bolster has exported</source>
        <translation>to nie jest plik preferencji; wybierz plik wyeksportowany przez Bolstera</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be what it is there; remove that line from the file, or export it again</source>
        <translation>„%1” nie może mieć podanej tam wartości; usuń ten wiersz z pliku lub wyeksportuj go ponownie</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, where a portable Bolster keeps settings and work, cannot be written; copy its folder to where you may write</source>
        <translation>nie można zapisywać w „%1”, gdzie przenośny Bolster trzyma ustawienia i pracę; skopiuj jego folder tam, gdzie wolno Ci zapisywać</translation>
    </message>
    <message>
        <source>the disk with &quot;%1&quot; is full; make room on it, and change a setting once more: all of them are kept then</source>
        <translation>dysk z „%1” jest pełny; zwolnij miejsce i zmień jeszcze jedno ustawienie: wtedy wszystkie zostaną zachowane</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be written; give yourself the right to write there and in its folder, and change a setting once more: all of them are kept then</source>
        <translation>nie można zapisać „%1”; nadaj sobie prawo zapisu tam i w tym folderze i zmień jeszcze jedno ustawienie: wtedy wszystkie zostaną zachowane</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands there twice; remove one of its lines from the file, or export it again</source>
        <translation>„%1” występuje tam dwa razy; usuń jeden z wierszy z pliku albo wyeksportuj go ponownie</translation>
    </message>
    <message>
        <source>Change the note of %1</source>
        <translation>Zmień uwagę: %1</translation>
    </message>
    <message>
        <source>Add measurement %1</source>
        <translation>Dodaj pomiar %1</translation>
    </message>
    <message>
        <source>it does not lie in &quot;%1&quot; any more; measure anew</source>
        <translation>nie leży już w „%1”; zmierz ponownie</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; holds other files: choose one of its own.</source>
        <translation>Folder „%1” zawiera inne pliki: wybierz osobny.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; holds the work of another design or of other options: choose another folder.</source>
        <translation>Folder „%1” zawiera pracę innego projektu lub innych opcji: wybierz inny folder.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be made (%2).</source>
        <translation>Nie można utworzyć folderu „%1” (%2).</translation>
    </message>
    <message>
        <source>Remove %1 and what needs it (%2 elements)</source>
        <translation>Usuń: %1 i to, co tego wymaga (elementy: %2)</translation>
    </message>
    <message>
        <source>one version was saved</source>
        <translation>Odzyskano jedną wersję</translation>
    </message>
    <message>
        <source>%1: none of its triangles has an area</source>
        <translation>%1: żaden z trójkątów nie ma powierzchni</translation>
    </message>
    <message>
        <source>Where a piece would have had a hole or been a ring it is cut and sewn again, number of cuts: %1</source>
        <translation>Gdzie element miałby otwór lub byłby pierścieniem, jest rozcięty i zszyty, liczba cięć: %1</translation>
    </message>
    <message>
        <source>%1 is stretched by %2 % along the grain, its fabric allows %3 %</source>
        <translation>%1: rozciągnięcie wzdłuż nitki %2%, materiał dopuszcza %3%</translation>
    </message>
    <message>
        <source>%1 is stretched by %2 % across the grain, its fabric allows %3 %</source>
        <translation>%1: rozciągnięcie w poprzek nitki %2%, materiał dopuszcza %3%</translation>
    </message>
    <message>
        <source>%1 is sheared by %2 %, its fabric allows %3 %</source>
        <translation>%1: ścinanie %2%, materiał dopuszcza %3%</translation>
    </message>
    <message>
        <source>The form has one side only, as a twisted band: it is left open where its outside meets its inside</source>
        <translation>Forma ma tylko jedną stronę, jak skręcona wstęga: pozostaje otwarta tam, gdzie zewnętrze styka się z wnętrzem</translation>
    </message>
    <message>
        <source>Parts of %1 that are shorter than a mesh edge have gone with the cut.</source>
        <translation>Części %1 krótsze niż krawędź siatki zniknęły przy cięciu.</translation>
    </message>
    <message>
        <source>the usual value is used instead</source>
        <translation>zamiast tego użyto zwykłej wartości</translation>
    </message>
    <message>
        <source>it is the project that is open here; choose another name</source>
        <translation>to projekt, który jest tu otwarty; wybierz inną nazwę</translation>
    </message>
    <message>
        <source>the file is empty; nothing was written to it, or it was lost</source>
        <translation>plik jest pusty; nic do niego nie zapisano albo treść przepadła</translation>
    </message>
    <message>
        <source>it is open in another window; choose another name</source>
        <translation>jest otwarty w innym oknie; wybierz inną nazwę</translation>
    </message>
    <message>
        <source>the disk of &quot;%1&quot; is full, where work is protected from crashes; make room, and open it again</source>
        <translation>dysk z „%1”, gdzie praca jest chroniona przed awarią, jest pełny; zwolnij miejsce i otwórz ponownie</translation>
    </message>
    <message>
        <source>The form is %1 mm large: with edges of %2 mm its cover has more triangles than can be solved. See whether the unit is right; else make the mesh edges at least %3 mm long</source>
        <translation>Bryła ma %1 mm: przy krawędziach %2 mm jej pokrowiec ma więcej trójkątów, niż da się rozwiązać. Proszę sprawdzić jednostkę; jeśli jest dobra, krawędzie siatki muszą mieć co najmniej %3 mm</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already; choose another name</source>
        <translation>„%1” już istnieje; proszę wybrać inną nazwę</translation>
    </message>
    <message>
        <source>%1 is strained by %2 % when it lies on the form, more than any fabric bears. Divide it, or cut it in where it bulges most</source>
        <translation>%1 odkształca się na bryle o %2 %, więcej, niż zniesie jakakolwiek tkanina. Proszę je podzielić albo naciąć tam, gdzie najbardziej się wybrzusza</translation>
    </message>
    <message>
        <source>Let no scan pull at the cover</source>
        <translation>Niech żaden skan nie przyciąga pokrowca</translation>
    </message>
    <message>
        <source>%1 bends too sharply at %2: it is not cut along it</source>
        <translation>%1 zagina się zbyt ostro w %2: nie ma tam cięcia</translation>
    </message>
    <message>
        <source>The form goes through itself at %2: it is not cut along %1</source>
        <translation>Forma przenika samą siebie w %2: nie ma cięcia wzdłuż %1</translation>
    </message>
    <message>
        <source>What is closed all around has no border to be held at: its cover is fixed along its seams. Delete the fixations of those that are to be free</source>
        <translation>Co jest zamknięte dookoła, nie ma brzegu do trzymania: pokrowiec jest przymocowany wzdłuż szwów. Usuń mocowania tych, które mają być wolne</translation>
    </message>
    <message>
        <source>No vertex of the area is near the form: make the area larger than the mesh edges, or put the form where the cover is.</source>
        <translation>Żaden wierzchołek obszaru nie jest blisko formy: powiększ obszar ponad krawędzie siatki albo umieść formę tam, gdzie pokrowiec.</translation>
    </message>
    <message>
        <source>%1 is left out: it is too narrow to be sewn. Join it to what lies beside it</source>
        <translation>kawałek %1 pominięto: jest za wąski, aby go zszyć. Połącz go z tym, co leży obok</translation>
    </message>
    <message>
        <source>Make the pattern of a form again</source>
        <translation>Utwórz ponownie wykrój formy</translation>
    </message>
    <message>
        <source>Make the pattern of %1 again</source>
        <translation>Utwórz ponownie wykrój: %1</translation>
    </message>
    <message>
        <source>Make the pattern of %1</source>
        <translation>Utwórz wykrój: %1</translation>
    </message>
    <message>
        <source>Fit the pattern to %1, %2 mm from it</source>
        <translation>Dopasuj wykrój do: %1, odległość %2&#xa0;mm</translation>
    </message>
    <message>
        <source>Fit the pattern to %1</source>
        <translation>Dopasuj wykrój do: %1</translation>
    </message>
    <message>
        <source>Fit the pattern to a limit of strain, %1 % of the cover over it</source>
        <translation>Dopasuj wykrój do granicy odkształcenia, %1% pokrowca powyżej niej</translation>
    </message>
    <message>
        <source>Let the scan pull at the cover again</source>
        <translation>Niech skan znów przyciąga pokrowiec</translation>
    </message>
    <message>
        <source>%1 runs along %2, at %3: it is cut there once</source>
        <translation>%1 biegnie wzdłuż %2, w %3: tam tnie się raz</translation>
    </message>
    <message>
        <source>%1 runs along the border of the form, or where it is cut anyway, at %2: there is nothing to cut</source>
        <translation>%1 biegnie wzdłuż brzegu formy albo tam, gdzie i tak się ją tnie, w %2: nie ma czego ciąć</translation>
    </message>
    <message>
        <source>%1 is too short or too long, at %2: it is not cut along it</source>
        <translation>%1 jest za krótka lub za długa, w %2: nie ma tam cięcia</translation>
    </message>
    <message>
        <source>%1 is %2 mm away from the form, at %3: it is not cut along it</source>
        <translation>%1 leży %2&#xa0;mm od formy, w %3: nie ma tam cięcia</translation>
    </message>
    <message>
        <source>lines cannot be cut into it: it has edges where more than two faces meet, or sheets that touch in a point, at %1</source>
        <translation>nie można wciąć w nią linii: ma krawędzie, gdzie spotykają się więcej niż dwie ściany, lub płaty stykające się w punkcie, w %1</translation>
    </message>
    <message>
        <source>%1 cannot be cut into it, at %2: the form goes through itself there</source>
        <translation>nie można w nią wciąć linii %1, w %2: forma przenika tam samą siebie</translation>
    </message>
    <message>
        <source>Small for the triangles of the cover, whose edges are %1 mm long: %2. Their shape will be coarse; with mesh edges of %3 mm it is not</source>
        <translation>Małe w stosunku do trójkątów pokrowca o krawędziach %1&#xa0;mm: %2. Ich kształt będzie zgrubny; z krawędziami siatki %3&#xa0;mm nie będzie</translation>
    </message>
    <message>
        <source>Too small for the triangles of the cover, whose edges are %1 mm long: %2. Join them to what lies beside them, or leave them out</source>
        <translation>Za małe w stosunku do trójkątów pokrowca o krawędziach %1&#xa0;mm: %2. Połącz je z tym, co leży obok, albo je pomiń</translation>
    </message>
    <message>
        <source>After %1 iterations it cannot be told yet where the surface comes to rest. Allow more iterations.</source>
        <translation>Po iteracjach w liczbie %1 nie da się jeszcze powiedzieć, gdzie powierzchnia się zatrzyma. Dopuść więcej iteracji.</translation>
    </message>
    <message>
        <source>Wider across the grain than the fabric, of which %1 mm can be used: %2. Divide them, or turn their grain</source>
        <translation>W poprzek nitki prostej szersze niż tkanina, z której można użyć %1 mm: %2. Podziel je albo obróć ich nitkę prostą</translation>
    </message>
    <message>
        <source>%1 ends inside a piece, at %2: it is cut in there like a dart. There is no other line or border; lead it around to where it began to divide the piece</source>
        <translation>%1 kończy się wewnątrz kawałka, w %2: nacięto tam jak zaszewkę. Nie ma innej linii ani brzegu; poprowadź ją dookoła aż do jej początku, aby podzielić kawałek</translation>
    </message>
    <message>
        <source>A line is not cut in at %1: the sides of the cut would lie over each other when it is laid flat. Draw it elsewhere, or on to a border</source>
        <translation>W %1 linia nie jest nacięta: po rozłożeniu boki nacięcia zachodziłyby na siebie. Narysuj ją gdzie indziej albo aż do brzegu</translation>
    </message>
    <message>
        <source>A line is not cut in at %1: the piece was divided another way. Draw it on to a border</source>
        <translation>W %1 linia nie jest nacięta: element podzielono inaczej. Poprowadź ją aż do brzegu</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no design, but what one is made of: import it</source>
        <translation>„%1” nie jest modelem, lecz tym, z czego się go robi: zaimportuj ten plik</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by %2 mm in each: it does not come to rest. Make curves as long as the outlines they hold, or try other mesh edges.</source>
        <translation>Po iteracjach w liczbie %1 powierzchnia w każdej nadal przesuwa się o %2&#xa0;mm: nie stabilizuje się. Zrób krzywe tak długie jak kontury, które trzymają, lub spróbuj innych krawędzi siatki.</translation>
    </message>
    <message>
        <source>%1, with what is sewn to it, is held only at a border of %2 mm: fix it along other curves, too, or close that hole of the form</source>
        <translation>%1 wraz z tym, co do niego przyszyto, trzyma tylko brzeg o długości %2&#xa0;mm: zamocuj go także wzdłuż innych krzywych albo zamknij ten otwór bryły</translation>
    </message>
    <message>
        <source>%1 is left out: it is closed all around and cannot be laid flat. Cut it along lines</source>
        <translation>kawałek %1 pominięto: jest zamknięty ze wszystkich stron i nie da się rozłożyć na płasko. Przetnij go wzdłuż linii</translation>
    </message>
    <message>
        <source>%1 is left out: it has a handle, like a cup, and cannot be laid flat. Cut it along lines</source>
        <translation>kawałek %1 pominięto: ma ucho jak filiżanka i nie da się rozłożyć na płasko. Przetnij go wzdłuż linii</translation>
    </message>
    <message>
        <source>Let out %1 by %3 mm where it is sewn to %2</source>
        <translation>Poszerz %1 o %3&#xa0;mm na szwie z: %2</translation>
    </message>
    <message>
        <source>Take in %1 by %3 mm where it is sewn to %2</source>
        <translation>Zwęź %1 o %3&#xa0;mm na szwie z: %2</translation>
    </message>
    <message>
        <source>Let out %1 by %3 mm where the curve %2 holds it</source>
        <translation>Poszerz %1 o %3&#xa0;mm tam, gdzie trzyma go krzywa %2</translation>
    </message>
    <message>
        <source>Take in %1 by %3 mm where the curve %2 holds it</source>
        <translation>Zwęź %1 o %3&#xa0;mm tam, gdzie trzyma go krzywa %2</translation>
    </message>
    <message>
        <source>What would not lie flat, or be strained by more than the fabric may be, is divided, which makes so many pieces more: %1</source>
        <translation>Co nie leżałoby płasko lub byłoby rozciągnięte bardziej, niż tkanina pozwala, podzielono. Liczba dodatkowych kawałków: %1</translation>
    </message>
    <message>
        <source>%1 is not divided: more than %2 pieces would be needed until it lies flat. It is rough, as scans are: smooth it, or fit a cover to it and take that</source>
        <translation>kawałek %1 nie został podzielony: aby leżał płasko, potrzeba by więcej niż %2 części. Jest chropowaty jak skany: wygładź go albo dopasuj do niego pokrowiec i użyj go</translation>
    </message>
    <message>
        <source>%1 is left out: it has more than %2 holes. Close them, or cut it along lines</source>
        <translation>kawałek %1 pominięto: ma więcej niż %2 otworów. Zamknij je albo przetnij go wzdłuż linii</translation>
    </message>
    <message>
        <source>Too narrow for the triangles of the cover, whose edges are %1 mm long, so that it cannot be solved: %2. Make the mesh edges shorter, or join them to what lies beside them</source>
        <translation>Za wąskie w stosunku do trójkątów pokrowca o krawędziach %1&#xa0;mm, więc nie da się go policzyć: %2. Skróć krawędzie siatki albo połącz je z tym, co leży obok</translation>
    </message>
    <message>
        <source>Lead open seam lines on</source>
        <translation>Przedłuż otwarte linie szwów</translation>
    </message>
    <message>
        <source>Lead %1 on</source>
        <translation>Przedłuż: %1</translation>
    </message>
    <message>
        <source>Bodies of the form go through each other, as at %1: what of one lies inside of another one is covered, too, and pushed out. Unite them before, or leave one out. Number of such pairs: %2</source>
        <translation>Bryły formy przechodzą jedna przez drugą, na przykład w %1: to, co z jednej leży wewnątrz innej, też dostaje pokrowiec i jest wypychane. Połącz je wcześniej albo pomiń jedną z nich. Liczba takich par: %2</translation>
    </message>
    <message>
        <source>Faces of the form that lie where another one lies, and are left out: %1</source>
        <translation>Ściany formy, które leżą tam, gdzie już jest inna, i są pominięte: %1</translation>
    </message>
    <message>
        <source>Faces of the form that were turned round: %1</source>
        <translation>Odwrócone ściany formy: %1</translation>
    </message>
    <message>
        <source>Edges of the form that belong to more than two faces, so that they are borders and nothing is sewn there: %1</source>
        <translation>Krawędzie formy, które należą do więcej niż dwóch ścian, są więc brzegami i nic się tam nie zszywa: %1</translation>
    </message>
</context>
<context>
    <name>MouseStyle</name>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Shift</translation>
    </message>
    <message>
        <source>middle button</source>
        <translation>środkowy przycisk</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>prawy przycisk</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>przeciąganie</translation>
    </message>
    <message>
        <source>two fingers</source>
        <translation>gest dwoma palcami</translation>
    </message>
    <message>
        <source>pinch or Ctrl+wheel</source>
        <translation>gest szczypania lub Ctrl+kółko</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>kółko</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>CAD (like SolidWorks)</source>
        <translation>CAD (jak SolidWorks)</translation>
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
        <translation>Element</translation>
    </message>
    <message>
        <source>From the corner</source>
        <translation>Od rogu</translation>
    </message>
    <message>
        <source>Along the outline from the nearer corner, on the same side of it.</source>
        <translation>Wzdłuż konturu od bliższego rogu, po tej samej jego stronie.</translation>
    </message>
</context>
<context>
    <name>OrientationFields</name>
    <message>
        <source>Free</source>
        <translation>Swobodnie</translation>
    </message>
    <message>
        <source>Normal held</source>
        <translation>Normalna ustalona</translation>
    </message>
    <message>
        <source>Tangent plane held</source>
        <translation>Pł. styczna ustalona</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>Nachylenie</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Kierunek</translation>
    </message>
    <message>
        <source>%1 directions, interpolated along the curve; the first is shown.</source>
        <translation>Kierunki interpolowane wzdłuż krzywej: %1; pokazano pierwszy.</translation>
    </message>
</context>
<context>
    <name>OutlineTool</name>
    <message>
        <source>This cannot be a patch: %1</source>
        <translation>To nie może być element: %1</translation>
    </message>
    <message>
        <source>The outline would cross itself here – Backspace takes a point back</source>
        <translation>Kontur przecinałby tu sam siebie – Backspace cofa punkt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no length: try 500, 500&lt;30 or 120, 40</source>
        <translation>„%1” to nie długość: spróbuj 500, 500&lt;30 lub 120, 40</translation>
    </message>
    <message>
        <source>Click to set the first corner, press and drag for a smooth point – Esc ends the tool</source>
        <translation>Kliknij, aby postawić pierwszy róg; naciśnij i przeciągnij, aby postawić gładki punkt – Esc kończy</translation>
    </message>
    <message>
        <source>Click to close the outline</source>
        <translation>Kliknij, aby zamknąć kontur</translation>
    </message>
    <message>
        <source>Enter sets the point: 500 goes that far, 500&lt;30 at an angle, 120, 40 to the right and up</source>
        <translation>Enter stawia punkt: 500 – tak daleko, 500&lt;30 – pod kątem, 120, 40 – w prawo i w górę</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, or type a length – Ctrl does not snap</source>
        <translation>Kliknij, by postawić róg, przeciągnij, by postawić gładki punkt, lub wpisz długość – Ctrl wyłącza przyciąganie</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, type a length – Enter or a click on the first point closes, Backspace takes a point back</source>
        <translation>Kliknij: róg, przeciągnij: gładki punkt, lub wpisz długość – Enter lub kliknięcie pierwszego punktu zamyka, Backspace cofa punkt</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
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
        <translation>Kontur</translation>
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
        <translation>Element %1</translation>
    </message>
    <message>
        <source>An outline needs at least three points in different places.</source>
        <translation>Kontur wymaga co najmniej trzech punktów w różnych miejscach.</translation>
    </message>
    <message>
        <source>This cannot be a patch: %1</source>
        <translation>To nie może być element: %1</translation>
    </message>
</context>
<context>
    <name>PatchForm</name>
    <message>
        <source>Outline</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Rozmiar</translation>
    </message>
    <message>
        <source>Width and height as it lies in the pattern view.</source>
        <translation>Szerokość i wysokość w położeniu z widoku wykroju.</translation>
    </message>
</context>
<context>
    <name>PatternDrawTool</name>
    <message>
        <source>Begin inside a patch.</source>
        <translation>Zacznij wewnątrz elementu.</translation>
    </message>
    <message>
        <source>Fancy seam %1</source>
        <translation>Szew ozdobny %1</translation>
    </message>
    <message>
        <source>Handle %1</source>
        <translation>Krzywa sterująca %1</translation>
    </message>
    <message>
        <source>A curve needs two points, a closed one three.</source>
        <translation>Krzywa wymaga dwóch punktów, zamknięta – trzech.</translation>
    </message>
    <message>
        <source>There is no surface in this patch yet on which the handle could lie.</source>
        <translation>W tym elemencie nie ma jeszcze powierzchni, na której mogłaby leżeć krzywa sterująca.</translation>
    </message>
    <message>
        <source>Click inside a patch to begin a handle curve – Esc ends the tool</source>
        <translation>Kliknij wewnątrz elementu, aby zacząć krzywą sterującą – Esc kończy</translation>
    </message>
    <message>
        <source>Click inside a patch or on its outline to begin a fancy seam – Esc ends the tool</source>
        <translation>Kliknij wewnątrz elementu lub na jego konturze, aby zacząć szew ozdobny – Esc kończy</translation>
    </message>
    <message>
        <source>Click to close the curve</source>
        <translation>Kliknij, aby zamknąć krzywą</translation>
    </message>
    <message>
        <source>Click for the next point, double click or Enter ends – B makes it straight, Backspace takes a point back</source>
        <translation>Kliknij następny punkt; dwukrotne kliknięcie lub Enter kończy – B prostuje, Backspace cofa punkt</translation>
    </message>
    <message>
        <source>Click for the next point, double click or Enter ends – B makes it smooth, Backspace takes a point back</source>
        <translation>Kliknij następny punkt; dwukrotne kliknięcie lub Enter kończy – B wygładza, Backspace cofa punkt</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Linia %1</translation>
    </message>
    <message>
        <source>Click inside a patch or on its outline to begin a line for the cutter – Esc ends the tool</source>
        <translation>Kliknij wewnątrz elementu lub na jego konturze, aby zacząć linię do krojenia – Esc kończy</translation>
    </message>
</context>
<context>
    <name>PatternPdf</name>
    <message>
        <source>1 inch</source>
        <translation>1 cal</translation>
    </message>
    <message>
        <source>Print at 100 %</source>
        <translation>Drukuj w skali 100%</translation>
    </message>
    <message>
        <source>%1 – print at 100 %</source>
        <translation>%1 – drukuj w skali 100%</translation>
    </message>
    <message>
        <source>Overview of %1 x %2 sheets</source>
        <translation>Przegląd arkuszy: %1 x %2</translation>
    </message>
    <message>
        <source>%1: sheet %2</source>
        <translation>%1: arkusz %2</translation>
    </message>
    <message>
        <source>%1: sheets %2 to %3</source>
        <translation>%1: arkusze od %2 do %3</translation>
    </message>
    <message>
        <source>100 mm: to measure, no part of the pattern</source>
        <translation>100&#xa0;mm: do zmierzenia, nie część wykroju</translation>
    </message>
    <message>
        <source>Sheet %1 (row %2 of %3, column %4 of %5)</source>
        <translation>Arkusz %1 (wiersz %2 z %3, kolumna %4 z %5)</translation>
    </message>
</context>
<context>
    <name>PatternSelectTool</name>
    <message>
        <source>There is a control point already.</source>
        <translation>Tu już jest punkt kontrolny.</translation>
    </message>
    <message>
        <source>Drag to turn the selected patches in the layout</source>
        <translation>Przeciągnij, aby obrócić zaznaczone elementy w układzie</translation>
    </message>
    <message>
        <source>Drag to move the control point – Shift+click selects several, Del removes</source>
        <translation>Przeciągnij, aby przesunąć punkt kontrolny – Shift+kliknięcie zaznacza kilka, Del usuwa</translation>
    </message>
    <message>
        <source>Click to select the patch, drag to move it in the layout</source>
        <translation>Kliknij, aby zaznaczyć element; przeciągnij, aby przesunąć go w układzie</translation>
    </message>
    <message>
        <source>Click to select the curve, drag to move it, double click to add a control point here</source>
        <translation>Kliknij, aby zaznaczyć krzywą; przeciągnij, aby ją przesunąć; dwukrotne kliknięcie dodaje tu punkt kontrolny</translation>
    </message>
    <message>
        <source>Drag to scale the selected patches – Shift keeps the proportions</source>
        <translation>Przeciągnij, aby skalować zaznaczone elementy – Shift zachowuje proporcje</translation>
    </message>
    <message>
        <source>Drag to move this end of the stretch along the outline</source>
        <translation>Przeciągnij, aby przesunąć ten koniec odcinka wzdłuż konturu</translation>
    </message>
    <message>
        <source>Drag to move the edge, double click to add a control point here – its length is in the properties</source>
        <translation>Przeciągnij, aby przesunąć krawędź; dwukrotne kliknięcie dodaje tu punkt kontrolny – jej długość jest we właściwościach</translation>
    </message>
    <message>
        <source>Click to select the edge, double click to add a control point here, drag to move the patch</source>
        <translation>Kliknij, aby zaznaczyć krawędź; dwukrotne kliknięcie dodaje tu punkt kontrolny; przeciągnij, aby przesunąć element</translation>
    </message>
    <message>
        <source>Click to select the seam and the edge, double click to add a control point here</source>
        <translation>Kliknij, aby zaznaczyć szew i krawędź; dwukrotne kliknięcie dodaje tu punkt kontrolny</translation>
    </message>
    <message>
        <source>Click to select it, drag to move it, Delete removes it</source>
        <translation>Kliknięcie zaznacza, przeciągnięcie przesuwa, Delete usuwa</translation>
    </message>
    <message>
        <source>Drag the tip of the dart</source>
        <translation>Przeciągnij wierzchołek zaszewki</translation>
    </message>
    <message>
        <source>Drag the dart along the outline</source>
        <translation>Przeciągnij zaszewkę wzdłuż konturu</translation>
    </message>
    <message>
        <source>Drag the label to where it can be read, click to select the patch</source>
        <translation>Przeciągnij opis tam, gdzie da się go odczytać; kliknij, aby zaznaczyć element</translation>
    </message>
    <message>
        <source>Click to select, drag a box to select several – %1 or Space pans, %2 zooms</source>
        <translation>Kliknięcie zaznacza, przeciągnięcie ramki zaznacza kilka – %1 lub spacja przesuwa, %2 powiększa</translation>
    </message>
    <message>
        <source>Click to select the measurement, Delete removes it</source>
        <translation>Kliknięcie zaznacza pomiar, Delete go usuwa</translation>
    </message>
</context>
<context>
    <name>PatternSplitTool</name>
    <message>
        <source>Click beside a patch or on its outline to begin the cut – Esc ends the tool</source>
        <translation>Kliknij obok elementu lub na jego konturze, aby zacząć cięcie – Esc kończy</translation>
    </message>
    <message>
        <source>Double click or Enter splits the patch – click to bend the cut, Backspace takes a point back</source>
        <translation>Dwukrotne kliknięcie lub Enter dzieli element – kliknięcie załamuje cięcie, Backspace cofa punkt</translation>
    </message>
    <message>
        <source>Click on the other side of the patch – Shift keeps the cut straight, Backspace takes a point back</source>
        <translation>Kliknij po drugiej stronie elementu – Shift utrzymuje cięcie proste, Backspace cofa punkt</translation>
    </message>
</context>
<context>
    <name>PatternTool</name>
    <message>
        <source>Moved by %1, %2 – Shift keeps to one axis, Esc takes it back</source>
        <translation>Przesunięto o %1, %2 – Shift trzyma się jednej osi, Esc cofa</translation>
    </message>
    <message>
        <source>Turned by %1 – Shift turns in steps of 15°, Esc takes it back</source>
        <translation>Obrócono o %1 – Shift obraca co 15°, Esc cofa</translation>
    </message>
    <message>
        <source>Release to select what lies in the box – Shift adds, Esc takes it back</source>
        <translation>Puść, aby zaznaczyć to, co leży w ramce – Shift dodaje, Esc cofa</translation>
    </message>
    <message>
        <source>Release to select what lies in the loop – Shift adds, Esc takes it back</source>
        <translation>Puść, aby zaznaczyć to, co leży w pętli – Shift dodaje, Esc cofa</translation>
    </message>
    <message>
        <source>Enter moves it so far: 50, or 30, 20</source>
        <translation>Enter przesuwa o tyle: 50 albo 30, 20</translation>
    </message>
    <message>
        <source>Enter turns it by this angle, counter-clockwise: 45</source>
        <translation>Enter obraca o ten kąt, w lewo: 45</translation>
    </message>
    <message>
        <source>Enter makes it this size: 300 x 200, 300 (wide, in proportion), or 120 %</source>
        <translation>Enter nadaje ten rozmiar: 300 x 200, 300 (szerokość, proporcjonalnie) lub 120 %</translation>
    </message>
    <message>
        <source>Scaled to %1 × %2 – or type the size; Shift keeps the proportions, Esc takes it back</source>
        <translation>Przeskalowano do %1 × %2 – lub wpisz rozmiar; Shift zachowuje proporcje, Esc cofa</translation>
    </message>
</context>
<context>
    <name>PatternToolHost</name>
    <message>
        <source>%1 Let go here, and it goes back to where it was.</source>
        <translation>%1 Puszczenie tutaj przywróci poprzednie położenie.</translation>
    </message>
</context>
<context>
    <name>PieceCuttingSection</name>
    <message>
        <source>Cutting</source>
        <translation>Krojenie</translation>
    </message>
    <message>
        <source>Own seam allowance</source>
        <translation>Własny naddatek na szew</translation>
    </message>
    <message>
        <source>Label where it finds room</source>
        <translation>Opis tam, gdzie jest miejsce</translation>
    </message>
</context>
<context>
    <name>PlacementGizmo</name>
    <message>
        <source>Turned by %1° – Ctrl snaps to 15°, Escape cancels</source>
        <translation>Obrócono o %1° – Ctrl przyciąga co 15°, Escape anuluje</translation>
    </message>
    <message>
        <source>Drag to move it along this axis</source>
        <translation>Przeciągnij, aby przesunąć wzdłuż tej osi</translation>
    </message>
    <message>
        <source>Drag to turn it about this axis</source>
        <translation>Przeciągnij, aby obrócić wokół tej osi</translation>
    </message>
    <message>
        <source>Drag to move it parallel to the picture</source>
        <translation>Przeciągnij, aby przesunąć równolegle do obrazu</translation>
    </message>
    <message>
        <source>Moved by x %1, y %2, z %3 – Ctrl snaps to %4, Escape cancels</source>
        <translation>Przesunięto o x %1, y %2, z %3 – Ctrl przyciąga co %4, Escape anuluje</translation>
    </message>
</context>
<context>
    <name>PreferenceCommands</name>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation>Pre&amp;ferencje…</translation>
    </message>
    <message>
        <source>Units, language, theme, mouse, keys and more</source>
        <translation>Jednostki, język, motyw, mysz, klawisze i inne</translation>
    </message>
    <message>
        <source>The preferences could not be stored: they hold only until Bolster is closed.</source>
        <translation>Nie można zapisać preferencji: obowiązują tylko do zamknięcia programu Bolster.</translation>
    </message>
</context>
<context>
    <name>Preferences</name>
    <message>
        <source>Millimetres (314 mm)</source>
        <translation>Milimetry (314 mm)</translation>
    </message>
    <message>
        <source>Centimetres (31.4 cm)</source>
        <translation>Centymetry (31,4 cm)</translation>
    </message>
    <message>
        <source>Inches (12 3/8″)</source>
        <translation>Cale (12 3/8″)</translation>
    </message>
    <message>
        <source>Up to 1/8</source>
        <translation>Do 1/8</translation>
    </message>
    <message>
        <source>Up to 1/16</source>
        <translation>Do 1/16</translation>
    </message>
    <message>
        <source>Up to 1/32</source>
        <translation>Do 1/32</translation>
    </message>
    <message>
        <source>Up to 1/64</source>
        <translation>Do 1/64</translation>
    </message>
    <message>
        <source>Decimals (12.375)</source>
        <translation>Dziesiętne (12,375)</translation>
    </message>
    <message>
        <source>Of the language</source>
        <translation>Według języka</translation>
    </message>
    <message>
        <source>Comma (1,5)</source>
        <translation>Przecinek (1,5)</translation>
    </message>
    <message>
        <source>Point (1.5)</source>
        <translation>Kropka (1.5)</translation>
    </message>
    <message>
        <source>Of the system</source>
        <translation>Język systemu</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Jak w systemie</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Jasny</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Ciemny</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Wysoki kontrast</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Pełna</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Zmniejszona</translation>
    </message>
    <message>
        <source>Plain, as it comes</source>
        <translation>Gładki, domyślny</translation>
    </message>
    <message>
        <source>Units and numbers</source>
        <translation>Jednostki i liczby</translation>
    </message>
    <message>
        <source>Language and looks</source>
        <translation>Język i wygląd</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Mysz</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Klawiatura</translation>
    </message>
    <message>
        <source>Pattern view</source>
        <translation>Widok wykroju</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Widok 3D</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Niezapisana praca</translation>
    </message>
    <message>
        <source>New designs</source>
        <translation>Nowe modele</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>Jednostka długości</translation>
    </message>
    <message>
        <source>unit measure metric imperial millimetre centimetre inch</source>
        <translation>jednostki miara metryczne imperialne calowe milimetr centymetr cal długość</translation>
    </message>
    <message>
        <source>How lengths are shown. Whatever it is, you may type others: 3 in, 2.5 cm, 1&apos; 2 3/8&quot;. Designs keep millimetres, and so do printed sheets and files.</source>
        <translation>Jak pokazywane są długości. Zawsze można wpisać inne: „3 in”, „2,5 cm”, „1&apos; 2 3/8&quot;”. Modele zachowują milimetry, podobnie jak drukowane arkusze i pliki.</translation>
    </message>
    <message>
        <source>Parts of an inch</source>
        <translation>Części cala</translation>
    </message>
    <message>
        <source>fraction imperial 1/16 decimals</source>
        <translation>ułamek imperialne 1/16 dziesiętne</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>Znak dziesiętny</translation>
    </message>
    <message>
        <source>comma point dot separator numbers</source>
        <translation>przecinek kropka separator liczby</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Język</translation>
    </message>
    <message>
        <source>translation words english german deutsch</source>
        <translation>tłumaczenie słowa polski angielski niemiecki language english</translation>
    </message>
    <message>
        <source>Bolster speaks it when it is started the next time.</source>
        <translation>Bolster użyje go przy następnym uruchomieniu.</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Motyw</translation>
    </message>
    <message>
        <source>colours dark light contrast night appearance accessibility</source>
        <translation>kolory ciemny jasny kontrast noc wygląd dostępność</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Size of the letters</source>
        <translation>Wielkość liter</translation>
    </message>
    <message>
        <source>font text large small zoom scale accessibility</source>
        <translation>czcionka tekst duży mały zoom skala dostępność</translation>
    </message>
    <message>
        <source>Move the views as in</source>
        <translation>Poruszanie widokami jak w</translation>
    </message>
    <message>
        <source>navigation rotate turn pan zoom buttons trackpad orbit preset</source>
        <translation>nawigacja obrót obracanie przesuwanie zoom przyciski touchpad gładzik orbita zestaw</translation>
    </message>
    <message>
        <source>Zoom the other way round</source>
        <translation>Odwróć kierunek powiększania</translation>
    </message>
    <message>
        <source>invert wheel scroll reverse direction</source>
        <translation>odwrócenie kółko przewijanie przeciwny kierunek</translation>
    </message>
    <message>
        <source>Keys as in</source>
        <translation>Klawisze jak w</translation>
    </message>
    <message>
        <source>shortcuts hotkeys preset</source>
        <translation>skróty klawiszowe zestaw</translation>
    </message>
    <message>
        <source>Some commands get the keys that you know from there. Keys that you have chosen yourself stay.</source>
        <translation>Niektóre polecenia dostają klawisze, które stamtąd znasz. Klawisze wybrane samodzielnie pozostają.</translation>
    </message>
    <message>
        <source>Snap to points, edges, guides and the grid</source>
        <translation>Przyciągaj do punktów, krawędzi, prowadnic i siatki</translation>
    </message>
    <message>
        <source>magnet catch align</source>
        <translation>magnes przyciąganie wyrównanie</translation>
    </message>
    <message>
        <source>Ctrl or Alt lets go while you drag.</source>
        <translation>Ctrl lub Alt wyłącza to podczas przeciągania.</translation>
    </message>
    <message>
        <source>Show rulers</source>
        <translation>Pokaż linijki</translation>
    </message>
    <message>
        <source>scale measure</source>
        <translation>skala miara</translation>
    </message>
    <message>
        <source>Show guides</source>
        <translation>Pokaż prowadnice</translation>
    </message>
    <message>
        <source>lines help</source>
        <translation>linie pomocnicze</translation>
    </message>
    <message>
        <source>Quality of the picture</source>
        <translation>Jakość obrazu</translation>
    </message>
    <message>
        <source>performance slow fast remote desktop graphics opengl</source>
        <translation>wydajność wolno szybko pulpit zdalny grafika opengl</translation>
    </message>
    <message>
        <source>Reduced: fewer pixels and triangles, no soft shadows. For slow machines and for screens that are far away. Pictures that you export stay fine.</source>
        <translation>Zmniejszona: mniej pikseli i trójkątów, bez miękkich cieni. Dla wolnych komputerów i ekranów zdalnych. Eksportowane obrazy pozostają dokładne.</translation>
    </message>
    <message>
        <source>Go to other views at once, without a flight</source>
        <translation>Zmieniaj widoki od razu, bez przelotu</translation>
    </message>
    <message>
        <source>reduced motion animation camera accessibility remote</source>
        <translation>ograniczenie ruchu animacja kamera dostępność zdalny</translation>
    </message>
    <message>
        <source> days</source>
        <translation> dni</translation>
    </message>
    <message>
        <source>Keep work that was thrown away for</source>
        <translation>Usuniętą pracę przechowuj przez</translation>
    </message>
    <message>
        <source>autosave backup recovery crash journal bin unsaved delete</source>
        <translation>autozapis kopia zapasowa odzyskiwanie awaria dziennik kosz niezapisane usuń</translation>
    </message>
    <message>
        <source>Every step is on the disk as soon as it is done, so there is no interval to set. Unsaved work stays until you open it again or throw it away; after that it lies in the bin for at least 30 days.</source>
        <translation>Każdy krok jest na dysku, gdy tylko zostanie wykonany, więc nie ma odstępu do ustawienia. Niezapisana praca pozostaje, aż ją otworzysz lub wyrzucisz; potem leży w koszu co najmniej 30 dni.</translation>
    </message>
    <message>
        <source>Fabric of new patches</source>
        <translation>Materiał nowych elementów</translation>
    </message>
    <message>
        <source>default material leather weave colour</source>
        <translation>domyślny materiał skóra tkanina kolor</translation>
    </message>
    <message>
        <source>A new design begins with it, and patches are made of a design&apos;s first fabric.</source>
        <translation>Nowy model zaczyna się od niego, a elementy powstają z pierwszego materiału modelu.</translation>
    </message>
    <message>
        <source>Seam allowance</source>
        <translation>Naddatek na szew</translation>
    </message>
    <message>
        <source>default cutting margin hem width</source>
        <translation>domyślny krojenie margines podwinięcie szerokość</translation>
    </message>
    <message>
        <source>New designs begin with it; in a design it is changed in its properties.</source>
        <translation>Nowe modele zaczynają się od niego; w modelu zmienia się go we właściwościach.</translation>
    </message>
    <message>
        <source>Folder of your fabrics</source>
        <translation>Folder materiałów</translation>
    </message>
    <message>
        <source>library directory path import export picture swatch</source>
        <translation>biblioteka katalog ścieżka import eksport obraz próbnik</translation>
    </message>
    <message>
        <source>Where fabrics and their pictures are looked for first. Without one it is the folder of the design.</source>
        <translation>Gdzie najpierw szukać materiałów i ich obrazów. Jeśli brak, jest to folder modelu.</translation>
    </message>
    <message>
        <source>Lengths are kept as they are, and shown to the nearest part; what is shorter than one has decimals.</source>
        <translation>Długości pozostają bez zmian i są pokazywane z dokładnością do najbliższej części; co jest krótsze, ma miejsca dziesiętne.</translation>
    </message>
</context>
<context>
    <name>SavedViewCommands</name>
    <message>
        <source>&amp;Save view …</source>
        <translation>&amp;Zapisz widok…</translation>
    </message>
    <message>
        <source>&amp;Delete view</source>
        <translation>&amp;Usuń widok</translation>
    </message>
    <message>
        <source>View %1 deleted</source>
        <translation>Usunięto widok %1</translation>
    </message>
    <message>
        <source>Save view</source>
        <translation>Zapisz widok</translation>
    </message>
    <message>
        <source>Name of the view; one of the same name is replaced:</source>
        <translation>Nazwa widoku; widok o tej samej nazwie zostanie zastąpiony:</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Widok %1</translation>
    </message>
    <message>
        <source>View %1 saved: View &gt; Saved views</source>
        <translation>Zapisano widok %1: Widok &gt; Zapisane widoki</translation>
    </message>
</context>
<context>
    <name>ScanAlignTool</name>
    <message>
        <source>There is no point of the scan here: click on one.</source>
        <translation>Nie ma tu punktu skanu: kliknij na którymś.</translation>
    </message>
    <message>
        <source>There is neither a frame nor the cover here: click where that place of the scan belongs.</source>
        <translation>Nie ma tu stelaża ani pokrowca: kliknij tam, gdzie należy to miejsce skanu.</translation>
    </message>
    <message>
        <source>Take the last place &amp;back</source>
        <translation>&amp;Cofnij ostatnie miejsce</translation>
    </message>
    <message>
        <source>Click on the frame or the cover where place %1 of the scan belongs – Backspace takes it back</source>
        <translation>Kliknij na stelażu lub pokrowcu tam, gdzie należy miejsce %1 skanu – Backspace je cofa</translation>
    </message>
    <message>
        <source>Click on a place of the scan that can be told from others, such as a corner – drag turns the view, Esc ends the tool</source>
        <translation>Kliknij miejsce skanu, które da się odróżnić od innych, np. róg – przeciąganie obraca widok, Esc kończy</translation>
    </message>
    <message>
        <source>Click on place %1 of 3 of the scan, far from the others – Backspace takes one back</source>
        <translation>Kliknij miejsce %1 z 3 na skanie, daleko od pozostałych – Backspace cofa jedno</translation>
    </message>
    <message>
        <source>%1: where it belongs</source>
        <translation>%1: gdzie należy</translation>
    </message>
    <message>
        <source>%1: on the scan</source>
        <translation>%1: na skanie</translation>
    </message>
    <message>
        <source>The scan is no longer there – Esc ends the tool</source>
        <translation>Skanu już nie ma – Esc kończy</translation>
    </message>
</context>
<context>
    <name>ScanCommands</name>
    <message>
        <source>&amp;Place on the cover</source>
        <translation>&amp;Umieść na pokrowcu</translation>
    </message>
    <message>
        <source>Moves and turns the scan so that it lies on the cover as well as it can</source>
        <translation>Przesuwa i obraca skan, by jak najlepiej leżał na pokrowcu</translation>
    </message>
    <message>
        <source>&amp;Cut away …</source>
        <translation>Odetni&amp;j…</translation>
    </message>
    <message>
        <source>Drag a rectangle in the 3D view over what is to be cut away of the scan</source>
        <translation>Przeciągnij w widoku 3D prostokąt nad tym, co odciąć ze skanu</translation>
    </message>
    <message>
        <source>&amp;Keep only …</source>
        <translation>&amp;Zachowaj tylko…</translation>
    </message>
    <message>
        <source>Drag a rectangle in the 3D view around what is to be kept of the scan</source>
        <translation>Przeciągnij w widoku 3D prostokąt wokół tego, co zachować ze skanu</translation>
    </message>
    <message>
        <source>Keep &amp;around the cover</source>
        <translation>Zachowaj &amp;otoczenie pokrowca</translation>
    </message>
    <message>
        <source>Cuts away what is farther from the cover than the threshold</source>
        <translation>Odcina to, co leży od pokrowca dalej niż próg</translation>
    </message>
    <message>
        <source>&amp;Remove all cuts</source>
        <translation>U&amp;suń wszystkie cięcia</translation>
    </message>
    <message>
        <source>Brings back all that was cut away of the scan</source>
        <translation>Przywraca wszystko, co odcięto ze skanu</translation>
    </message>
    <message>
        <source>Choose another &amp;file …</source>
        <translation>Wybierz inny &amp;plik…</translation>
    </message>
    <message>
        <source>Reads the scan from another file</source>
        <translation>Odczytuje skan z innego pliku</translation>
    </message>
    <message>
        <source>Select the scan that is meant.</source>
        <translation>Zaznacz właściwy skan.</translation>
    </message>
    <message>
        <source>Placing the scan on the cover …</source>
        <translation>Umieszczanie skanu na pokrowcu…</translation>
    </message>
    <message>
        <source>Placing the scan on the cover: step %1</source>
        <translation>Umieszczanie skanu na pokrowcu: krok %1</translation>
    </message>
    <message>
        <source>A&amp;lign …</source>
        <translation>&amp;Wyrównaj…</translation>
    </message>
    <message>
        <source>Click three places of the scan and where each belongs; the rest is found</source>
        <translation>Kliknij trzy miejsca skanu i wskaż, gdzie każde należy; resztę znajdzie program</translation>
    </message>
    <message>
        <source>Aligning the scan …</source>
        <translation>Wyrównywanie skanu…</translation>
    </message>
    <message>
        <source>Aligning the scan: step %1</source>
        <translation>Wyrównywanie skanu: krok %1</translation>
    </message>
</context>
<context>
    <name>ScanCutTool</name>
    <message>
        <source>Drag a rectangle around what is to be kept of the scan. Esc ends.</source>
        <translation>Przeciągnij prostokąt wokół tego, co zachować ze skanu. Esc kończy.</translation>
    </message>
    <message>
        <source>Drag a rectangle over what is to be cut away of the scan. Esc ends.</source>
        <translation>Przeciągnij prostokąt nad tym, co odciąć ze skanu. Esc kończy.</translation>
    </message>
</context>
<context>
    <name>ScanForm</name>
    <message>
        <source>File</source>
        <translation>Plik</translation>
    </message>
    <message>
        <source>Place on &amp;the cover</source>
        <translation>Umieść na po&amp;krowcu</translation>
    </message>
    <message>
        <source>Choose an&amp;other file …</source>
        <translation>Wy&amp;bierz inny plik…</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Zawartość</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>Punkty: %1</translation>
    </message>
    <message>
        <source>%1 of %2 points, one every %3</source>
        <translation>Punkty: %1 z %2, jeden co %3</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Odchyłka</translation>
    </message>
    <message>
        <source>%1 rms</source>
        <translation>%1 RMS</translation>
    </message>
    <message>
        <source>Median, 95 %</source>
        <translation>Mediana, 95%</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Największa</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Pokrycie</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkty</translation>
    </message>
    <message>
        <source>Floor at</source>
        <translation>Podłoga na</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Cięcia</translation>
    </message>
    <message>
        <source>Cut awa&amp;y …</source>
        <translation>Odetni&amp;j…</translation>
    </message>
    <message>
        <source>&amp;Keep only …</source>
        <translation>&amp;Zachowaj tylko…</translation>
    </message>
    <message>
        <source>Keep aroun&amp;d the cover</source>
        <translation>Zachowaj &amp;otoczenie pokrowca</translation>
    </message>
    <message>
        <source>Remove a&amp;ll cuts</source>
        <translation>U&amp;suń wszystkie cięcia</translation>
    </message>
    <message>
        <source>Ali&amp;gn …</source>
        <translation>&amp;Wyrównaj…</translation>
    </message>
    <message>
        <source>Between the cover and the scan, where they are nearer than the threshold.</source>
        <translation>Między pokrowcem a skanem, tam gdzie są bliżej niż próg.</translation>
    </message>
    <message>
        <source>Half of what is measured, and 95 % of it, is no farther from the scan than that.</source>
        <translation>Połowa tego, co zmierzono, i 95% z tego nie leży dalej od skanu.</translation>
    </message>
    <message>
        <source>How much of the cover has points of the scan near it.</source>
        <translation>Jaka część pokrowca ma blisko punkty skanu.</translation>
    </message>
    <message>
        <source>Of the scan, without what is cut away.</source>
        <translation>Ze skanu, bez tego, co odcięto.</translation>
    </message>
</context>
<context>
    <name>SeamForm</name>
    <message>
        <source>First side</source>
        <translation>Pierwsza strona</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Second side</source>
        <translation>Druga strona</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Wdanie</translation>
    </message>
</context>
<context>
    <name>SectionHandle</name>
    <message>
        <source>Section at %1 – Ctrl turns it by 15°, Escape puts it back</source>
        <translation>Przekrój na %1 – Ctrl obraca go o 15°, Escape przywraca</translation>
    </message>
    <message>
        <source>Drag to move the section, with Ctrl to turn it</source>
        <translation>Przeciągnij, aby przesunąć przekrój, z Ctrl – aby go obrócić</translation>
    </message>
</context>
<context>
    <name>SelectedEdgesForm</name>
    <message>
        <source>Edge length</source>
        <translation>Długość krawędzi</translation>
    </message>
    <message>
        <source>Edge lengths</source>
        <translation>Długości krawędzi</translation>
    </message>
    <message>
        <source>%1 edges. Of &quot;Make equally long&quot; the first one stays: %2 of %3.</source>
        <translation>Krawędzie: %1. Przy „Zrównaj długości” pierwsza zostaje: %2, %3.</translation>
    </message>
    <message>
        <source>Edge of</source>
        <translation>Krawędź elementu</translation>
    </message>
</context>
<context>
    <name>SelectedPointsForm</name>
    <message>
        <source>Points</source>
        <translation>Punkty</translation>
    </message>
    <message>
        <source>Layout x, y</source>
        <translation>Układ x, y</translation>
    </message>
    <message>
        <source>Length between</source>
        <translation>Długość pomiędzy</translation>
    </message>
    <message>
        <source>Space x, y, z</source>
        <translation>Przestrzeń x, y, z</translation>
    </message>
</context>
<context>
    <name>SelectionEdits</name>
    <message>
        <source>Not removed: the curve needs these points.</source>
        <translation>Nie usunięto: krzywa potrzebuje tych punktów.</translation>
    </message>
    <message>
        <source>Not removed: other elements need this fabric.</source>
        <translation>Nie usunięto: inne obiekty potrzebują tego materiału.</translation>
    </message>
    <message>
        <source>An edge cannot be removed: its points can, or with Esc the whole patch.</source>
        <translation>Krawędzi nie można usunąć: można jej punkty lub, po Esc, cały element.</translation>
    </message>
</context>
<context>
    <name>SettingsForm</name>
    <message>
        <source>Patches</source>
        <translation>Elementy</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Szwy</translation>
    </message>
    <message>
        <source>Select something to see its properties.</source>
        <translation>Zaznacz coś, aby zobaczyć właściwości.</translation>
    </message>
    <message>
        <source>Symmetric design</source>
        <translation>Model symetryczny</translation>
    </message>
    <message>
        <source>Plane through</source>
        <translation>Płaszczyzna przez</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normalna</translation>
    </message>
    <message>
        <source>Axis through</source>
        <translation>Oś przez</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Kierunek</translation>
    </message>
    <message>
        <source>%1, %2 in all</source>
        <translation>%1, razem %2</translation>
    </message>
    <message>
        <source>A point of the plane in which the cover is mirrored</source>
        <translation>Punkt płaszczyzny, w której odbija się pokrowiec</translation>
    </message>
    <message>
        <source>The direction straight out of that plane</source>
        <translation>Kierunek prostopadły do tej płaszczyzny</translation>
    </message>
    <message>
        <source>A point of the line of the pattern at which patches are mirrored</source>
        <translation>Punkt linii wykroju, względem której odbijają się elementy</translation>
    </message>
    <message>
        <source>The direction of that line</source>
        <translation>Kierunek tej linii</translation>
    </message>
    <message>
        <source>Twins are mirror images of each other. With this mark you say where the mirror stands; without it, it stands in the middle, between left and right.</source>
        <translation>Bliźniaki są swoimi lustrzanymi odbiciami. Z tym zaznaczeniem określa się, gdzie stoi lustro; bez niego stoi pośrodku, między lewą a prawą stroną.</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Wierzchołki</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>około %1</translation>
    </message>
    <message>
        <source>How many points the cover has at this edge length: solving takes time and memory for each.</source>
        <translation>Tyle punktów ma pokrowiec przy tej długości krawędzi: każdy kosztuje czas i pamięć podczas obliczeń.</translation>
    </message>
</context>
<context>
    <name>SewPicture</name>
    <message>
        <source>Ease %1, %2</source>
        <translation>Wdanie %1, %2</translation>
    </message>
</context>
<context>
    <name>SewTool</name>
    <message>
        <source>Click on the outline of a patch.</source>
        <translation>Kliknij kontur elementu.</translation>
    </message>
    <message>
        <source>Choose the other side first.</source>
        <translation>Najpierw wybierz drugą stronę.</translation>
    </message>
    <message>
        <source>Release where the stretch ends</source>
        <translation>Puść tam, gdzie odcinek się kończy</translation>
    </message>
    <message>
        <source>Click where the stretch ends – Esc goes back</source>
        <translation>Kliknij tam, gdzie odcinek się kończy – Esc wraca</translation>
    </message>
    <message>
        <source>Click to sew it the other way round (F)</source>
        <translation>Kliknij, aby zszyć odwrotnie (F)</translation>
    </message>
    <message>
        <source>Click the edge to sew – drag along the outline, or Shift+click twice, for a part of it; Esc ends the tool</source>
        <translation>Kliknij krawędź do zszycia – przeciągnięcie po konturze lub dwa razy Shift+kliknięcie bierze jej część; Esc kończy</translation>
    </message>
    <message>
        <source>Click the edges of the row one after the other, Enter sews – F flips, Backspace takes one back</source>
        <translation>Klikaj kolejno krawędzie rzędu, Enter zszywa – F odwraca, Backspace cofa ostatnią</translation>
    </message>
    <message>
        <source>Click the edge it is sewn to – F flips, Ctrl+click or M for several in a row, Backspace goes back</source>
        <translation>Kliknij krawędź, do której ma być przyszyta – F odwraca, Ctrl+kliknięcie lub M: kilka w rzędzie, Backspace wraca</translation>
    </message>
    <message>
        <source>Ctrl+click the next edge of the row, click the last one – Enter sews, F flips, Backspace takes one back</source>
        <translation>Ctrl+kliknięcie: następna krawędź rzędu, kliknięcie: ostatnia – Enter zszywa, F odwraca, Backspace cofa ostatnią</translation>
    </message>
    <message>
        <source>&amp;Sew what is marked</source>
        <translation>&amp;Zszyj oznaczone</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>&amp;Odwróć</translation>
    </message>
    <message>
        <source>Take &amp;one edge</source>
        <translation>Weź &amp;jedną krawędź</translation>
    </message>
    <message>
        <source>Take se&amp;veral edges in a row</source>
        <translation>Weź &amp;kilka krawędzi w rzędzie</translation>
    </message>
    <message>
        <source>&amp;Take back the last edge</source>
        <translation>&amp;Cofnij ostatnią krawędź</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>&amp;Porzuć</translation>
    </message>
</context>
<context>
    <name>SewingSheet</name>
    <message>
        <source>Sewing sheet</source>
        <translation>Karta szycia</translation>
    </message>
    <message>
        <source>Sewing sheet: %1</source>
        <translation>Karta szycia: %1</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materiały</translation>
    </message>
    <message>
        <source>Seams in the order of sewing</source>
        <translation>Szwy w kolejności szycia</translation>
    </message>
    <message>
        <source>%1 and %1 mirrored</source>
        <translation>%1 i %1 lustrzanie</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2&#xa0;mm</translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1&#xa0;m²</translation>
    </message>
    <message>
        <source>Piece</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Sztuk</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Materiał</translation>
    </message>
    <message>
        <source>Area as cut</source>
        <translation>Pole po skrojeniu</translation>
    </message>
    <message>
        <source>top stitched on both sides</source>
        <translation>stebnowany z obu stron</translation>
    </message>
    <message>
        <source>top stitched</source>
        <translation>stebnowany</translation>
    </message>
    <message>
        <source>%1 mm long, %2 mm from the seam</source>
        <translation>ścieg %1&#xa0;mm, %2&#xa0;mm od szwu</translation>
    </message>
    <message>
        <source>piping, %1 mm thick</source>
        <translation>kedra, grubość %1&#xa0;mm</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>zwykły</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 i %2</translation>
    </message>
    <message>
        <source>%1, with itself</source>
        <translation>%1, ze sobą</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Szew</translation>
    </message>
    <message>
        <source>Lengths, mm</source>
        <translation>Długości, mm</translation>
    </message>
    <message>
        <source>Allowance, mm</source>
        <translation>Naddatek, mm</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Nacięcia</translation>
    </message>
    <message>
        <source>Stitch</source>
        <translation>Ścieg</translation>
    </message>
    <message>
        <source>%1 m², without what lies between the pieces</source>
        <translation>%1&#xa0;m², bez tego, co leży między elementami</translation>
    </message>
    <message>
        <source>Sewing thread</source>
        <translation>Nici do szycia</translation>
    </message>
    <message>
        <source>Top thread &lt;span style=&quot;background-color:%1&quot;&gt;&amp;nbsp;&amp;nbsp;&amp;nbsp;&amp;nbsp;&lt;/span&gt; %1</source>
        <translation>Nić ozdobna &lt;span style=&quot;background-color:%1&quot;&gt;&#xa0;&#xa0;&#xa0;&#xa0;&lt;/span&gt; %1</translation>
    </message>
    <message>
        <source>%1 m, at %2 m for each metre of a row</source>
        <translation>%1&#xa0;m, licząc %2&#xa0;m na każdy metr rzędu</translation>
    </message>
    <message>
        <source>Piping</source>
        <translation>Kedra</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1&#xa0;m</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Co</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>Ile</translation>
    </message>
    <message>
        <source>zip</source>
        <translation>zamek</translation>
    </message>
    <message>
        <source>Zip</source>
        <translation>Zamek błyskawiczny</translation>
    </message>
    <message>
        <source>Pieces, with the numbers of their seams</source>
        <translation>Elementy z numerami ich szwów</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Szwy</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr</translation>
    </message>
    <message>
        <source>Width × height as cut</source>
        <translation>Szerokość × wysokość po skrojeniu</translation>
    </message>
    <message>
        <source>Ease, %</source>
        <translation>Wdanie, %</translation>
    </message>
    <message>
        <source>nap one way: all pieces point up</source>
        <translation>włos w jednym kierunku: wszystkie elementy górą do góry</translation>
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
        <translation>Środek</translation>
    </message>
    <message>
        <source>On an outline</source>
        <translation>Na konturze</translation>
    </message>
    <message>
        <source>Aligned</source>
        <translation>W linii</translation>
    </message>
    <message>
        <source>Direction %1</source>
        <translation>Kierunek %1</translation>
    </message>
    <message>
        <source>Perpendicular</source>
        <translation>Prostopadle</translation>
    </message>
    <message>
        <source>As long: %1</source>
        <translation>Równa długość: %1</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Prowadnica</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Siatka</translation>
    </message>
</context>
<context>
    <name>StartCommands</name>
    <message>
        <source>Start pa&amp;ge</source>
        <translation>Strona startow&amp;a</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Nowe &amp;okno</translation>
    </message>
    <message>
        <source>No other window could be opened.</source>
        <translation>Nie udało się otworzyć kolejnego okna.</translation>
    </message>
    <message>
        <source>The system did not start the program again. Close some programs, and try once more.</source>
        <translation>System nie uruchomił programu ponownie. Zamknij niektóre programy i spróbuj jeszcze raz.</translation>
    </message>
    <message>
        <source>&amp;Report a problem …</source>
        <translation>Zgłoś p&amp;roblem…</translation>
    </message>
    <message>
        <source>What&apos;s &amp;new</source>
        <translation>Co &amp;nowego</translation>
    </message>
    <message>
        <source>This is Bolster %1. What is new is under Help &gt; What&apos;s new.</source>
        <translation>To jest Bolster %1. Nowości są w menu Pomoc &gt; Co nowego.</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Pokaż</translation>
    </message>
    <message>
        <source>The frame is in the 3D view. Draw the curves on it where the cloth is fixed, or the first patch.</source>
        <translation>Stelaż jest w widoku 3D. Narysuj na nim krzywe w miejscach mocowania materiału lub pierwszy element.</translation>
    </message>
    <message>
        <source>Draw a &amp;fixation curve</source>
        <translation>Narysuj krzywą &amp;mocowania</translation>
    </message>
    <message>
        <source>Draw a &amp;rectangle</source>
        <translation>Narysuj p&amp;rostokąt</translation>
    </message>
    <message>
        <source>Pattern of a form …</source>
        <translation>Wykrój formy…</translation>
    </message>
</context>
<context>
    <name>StretchEndDrag</name>
    <message>
        <source>%1 long – Ctrl lets go of what is near, Esc takes it back</source>
        <translation>długość %1 – Ctrl wyłącza przyciąganie, Esc cofa</translation>
    </message>
    <message>
        <source>%1 long, the other side %2: ease %3, %4 – Ctrl lets go of what is near, Esc takes it back</source>
        <translation>długość %1, druga strona %2: wdanie %3, %4 – Ctrl wyłącza przyciąganie, Esc cofa</translation>
    </message>
    <message>
        <source>End of another stretch</source>
        <translation>Koniec innego odcinka</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Róg</translation>
    </message>
    <message>
        <source>As long as the other side</source>
        <translation>Długość jak druga strona</translation>
    </message>
</context>
<context>
    <name>SurfaceCommands</name>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Wstrzymaj</translation>
    </message>
    <message>
        <source>&amp;Figures …</source>
        <translation>&amp;Dane liczbowe…</translation>
    </message>
</context>
<context>
    <name>SweepWindow</name>
    <message>
        <source>&amp;Cut</source>
        <translation>&amp;Krojenie</translation>
    </message>
    <message>
        <source>Each piece is cut so much larger or smaller all around</source>
        <translation>O ile każdy element jest wycięty większy lub mniejszy dookoła</translation>
    </message>
    <message>
        <source>Cut of %1</source>
        <translation>Krojenie: %1</translation>
    </message>
    <message>
        <source>S&amp;eams</source>
        <translation>Sz&amp;wy</translation>
    </message>
    <message>
        <source>Each seam is sewn so much farther inside or outside, on both sides</source>
        <translation>O ile każdy szew jest zszyty dalej do wewnątrz lub na zewnątrz, po obu stronach</translation>
    </message>
    <message>
        <source>Seam %1</source>
        <translation>Szew %1</translation>
    </message>
    <message>
        <source>&amp;Foam</source>
        <translation>&amp;Pianka</translation>
    </message>
    <message>
        <source>Each cushion and foam is so much thicker or thinner</source>
        <translation>O ile każda wyściółka i pianka jest grubsza lub cieńsza</translation>
    </message>
    <message>
        <source>Thickness of %1</source>
        <translation>Grubość: %1</translation>
    </message>
    <message>
        <source>Fi&amp;xations</source>
        <translation>&amp;Mocowania</translation>
    </message>
    <message>
        <source>Each fixation curve lies so much elsewhere, along each axis</source>
        <translation>O ile każda krzywa mocowania leży gdzie indziej, wzdłuż każdej osi</translation>
    </message>
    <message>
        <source>Place of %1</source>
        <translation>Położenie: %1</translation>
    </message>
    <message>
        <source>S&amp;tiffness</source>
        <translation>&amp;Sztywność</translation>
    </message>
    <message>
        <source>Each fabric is so much stiffer or softer</source>
        <translation>O ile każdy materiał jest sztywniejszy lub bardziej miękki</translation>
    </message>
    <message>
        <source>Stiffness of %1</source>
        <translation>Sztywność: %1</translation>
    </message>
    <message>
        <source>Sh&amp;rinkage</source>
        <translation>Sk&amp;urcz</translation>
    </message>
    <message>
        <source>Each piece shrinks or stretches by so much</source>
        <translation>O ile każdy element się kurczy lub rozciąga</translation>
    </message>
    <message>
        <source>Shrinkage of %1</source>
        <translation>Skurcz: %1</translation>
    </message>
</context>
<context>
    <name>Templates</name>
    <message>
        <source>Cushion</source>
        <translation>Poduszka</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Wałek</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>Ławka</translation>
    </message>
    <message>
        <source>Dining chair</source>
        <translation>Krzesło</translation>
    </message>
    <message>
        <source>Wing chair</source>
        <translation>Fotel uszak</translation>
    </message>
    <message>
        <source>Car seat</source>
        <translation>Fotel samochodowy</translation>
    </message>
    <message>
        <source>Headrest</source>
        <translation>Zagłówek</translation>
    </message>
</context>
<context>
    <name>ToolCommands</name>
    <message>
        <source>&amp;Select and move</source>
        <translation>&amp;Zaznacz i przesuń</translation>
    </message>
    <message>
        <source>Draw &amp;outline</source>
        <translation>Rysuj &amp;kontur</translation>
    </message>
    <message>
        <source>Draw &amp;rectangle</source>
        <translation>Rysuj &amp;prostokąt</translation>
    </message>
    <message>
        <source>Draw &amp;ellipse</source>
        <translation>Rysuj &amp;elipsę</translation>
    </message>
    <message>
        <source>S&amp;plit patch</source>
        <translation>Po&amp;dziel element</translation>
    </message>
    <message>
        <source>Draw &amp;handle curve</source>
        <translation>Rysuj krzywą &amp;sterującą</translation>
    </message>
    <message>
        <source>Draw &amp;fancy seam</source>
        <translation>Rysuj szew &amp;ozdobny</translation>
    </message>
    <message>
        <source>Se&amp;w</source>
        <translation>Zszy&amp;j</translation>
    </message>
    <message>
        <source>&amp;Attach to fixation curve</source>
        <translation>Zamoc&amp;uj do krzywej mocowania</translation>
    </message>
    <message>
        <source>Stitch or pipe a seam</source>
        <translation>Stebnuj szew lub dodaj kedrę</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>Z&amp;mierz</translation>
    </message>
    <message>
        <source>&amp;Draw fixation curve</source>
        <translation>&amp;Rysuj krzywą mocowania</translation>
    </message>
    <message>
        <source>Draw &amp;internal line</source>
        <translation>Rysuj linię &amp;wewnętrzną</translation>
    </message>
    <message>
        <source>Allowance of an ed&amp;ge</source>
        <translation>Nadda&amp;tek krawędzi</translation>
    </message>
    <message>
        <source>&amp;Corner of the cut line</source>
        <translation>&amp;Róg linii cięcia</translation>
    </message>
    <message>
        <source>Place &amp;notches</source>
        <translation>Umieść na&amp;cięcia</translation>
    </message>
    <message>
        <source>Place &amp;drill holes</source>
        <translation>Umieść &amp;nawierty</translation>
    </message>
    <message>
        <source>&amp;Cutting</source>
        <translation>Krojen&amp;ie</translation>
    </message>
    <message>
        <source>Draw &amp;dart</source>
        <translation>Rysuj z&amp;aszewkę</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Samouczek</translation>
    </message>
    <message>
        <source>The coloured curves on the frame are where the cloth is tied down. Click one of them, then drag one of its points: the cover follows.</source>
        <translation>Kolorowe krzywe na stelażu pokazują, gdzie materiał jest zamocowany. Kliknij jedną z nich, a potem przeciągnij jeden z jej punktów: pokrowiec podąża.</translation>
    </message>
    <message>
        <source>The cover follows while you drag, and comes to rest when you let go.</source>
        <translation>Pokrowiec podąża za przeciąganiem i uspokaja się po puszczeniu.</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>Cofnij to</translation>
    </message>
    <message>
        <source>Ctrl+Z, or this button, takes back whatever was done, as far as you like. Nothing is lost by it: the history keeps what was undone, too.</source>
        <translation>Ctrl+Z lub ten przycisk cofa wszystko, co zrobiono, tak daleko, jak chcesz. Nic się przy tym nie traci: historia zachowuje też to, co cofnięto.</translation>
    </message>
    <message>
        <source>It is as it was. Undone steps are still in the history.</source>
        <translation>Jest jak było. Cofnięte kroki są nadal w historii.</translation>
    </message>
    <message>
        <source>Choose a seam</source>
        <translation>Wybierz szew</translation>
    </message>
    <message>
        <source>Seams join two edges of the pattern. Click one, in the pattern or on the cover: both of its edges light up, and the cover shows where it is.</source>
        <translation>Szwy łączą dwie krawędzie wykroju. Kliknij jeden – w wykroju lub na pokrowcu: obie jego krawędzie się podświetlą, a pokrowiec pokaże, gdzie leży.</translation>
    </message>
    <message>
        <source>Its properties are at the right now.</source>
        <translation>Jego właściwości są teraz po prawej.</translation>
    </message>
    <message>
        <source>Change how it is sewn</source>
        <translation>Zmień sposób szycia</translation>
    </message>
    <message>
        <source>With the seam selected, choose another continuity in its properties, or another stitching: an edge, a rounded seam or a smooth one.</source>
        <translation>Przy zaznaczonym szwie wybierz w jego właściwościach inną ciągłość lub inne stebnowanie: krawędź, szew zaokrąglony lub gładki.</translation>
    </message>
    <message>
        <source>The cover shows the seam as it will be sewn.</source>
        <translation>Pokrowiec pokazuje szew tak, jak będzie uszyty.</translation>
    </message>
    <message>
        <source>Look at the strain</source>
        <translation>Obejrzyj odkształcenia</translation>
    </message>
    <message>
        <source>View &gt; Map colours the cover by what the cloth has to bear. Choose Largest strain to see where it is stretched most.</source>
        <translation>Widok &gt; Mapa barwi pokrowiec według tego, co znosi materiał. Wybierz Największe odkształcenie, aby zobaczyć, gdzie jest najbardziej rozciągnięty.</translation>
    </message>
    <message>
        <source>The legend says how much, and the pointer reads it at any place.</source>
        <translation>Legenda mówi, ile to jest, a wskaźnik odczytuje wartość w każdym miejscu.</translation>
    </message>
    <message>
        <source>Change the pattern</source>
        <translation>Zmień wykrój</translation>
    </message>
    <message>
        <source>Drag a point of an outline, or cut a dart (Pattern &gt; Draw dart): what you change in the flat is sewn at once.</source>
        <translation>Przeciągnij punkt konturu lub natnij zaszewkę (Wykrój &gt; Rysuj zaszewkę): co zmienisz na płasko, jest od razu zszywane.</translation>
    </message>
    <message>
        <source>Seams keep their places on an outline that changes.</source>
        <translation>Szwy zachowują miejsca na zmieniającym się konturze.</translation>
    </message>
    <message>
        <source>Take it with you</source>
        <translation>Weź to ze sobą</translation>
    </message>
    <message>
        <source>File &gt; Export pattern writes DXF, PDF or SVG with seam allowances and notches; Export cover writes the cover for others.</source>
        <translation>Plik &gt; Eksportuj wykrój zapisuje DXF, PDF lub SVG z naddatkami na szwy i nacięciami; Eksportuj pokrowiec zapisuje pokrowiec dla innych.</translation>
    </message>
    <message>
        <source>The file is written.</source>
        <translation>Plik zapisano.</translation>
    </message>
    <message>
        <source>That was the tour</source>
        <translation>To był samouczek</translation>
    </message>
    <message>
        <source>You have seen how pattern, seams and frame make the cover. Begin with a design of your own: File &gt; Start page has templates. What each key does is under Help &gt; Keys and mouse.</source>
        <translation>Wiesz już, jak wykrój, szwy i stelaż tworzą pokrowiec. Zacznij własny model: szablony są w menu Plik &gt; Strona startowa. Co robi który klawisz, pokazuje Pomoc &gt; Klawisze i mysz.</translation>
    </message>
    <message>
        <source>Drag a fixation curve</source>
        <translation>Przeciągnij krzywą mocowania</translation>
    </message>
</context>
<context>
    <name>TrimSection</name>
    <message>
        <source>Stitching</source>
        <translation>Stebnowanie</translation>
    </message>
    <message>
        <source>Colour of the thread</source>
        <translation>Kolor nici</translation>
    </message>
    <message>
        <source>Piping</source>
        <translation>Kedra</translation>
    </message>
    <message>
        <source>As the patch</source>
        <translation>Jak element</translation>
    </message>
</context>
<context>
    <name>TwinCommands</name>
    <message>
        <source>Make &amp;mirror twin</source>
        <translation>Utwórz &amp;lustrzanego bliźniaka</translation>
    </message>
    <message>
        <source>Link as t&amp;wins</source>
        <translation>&amp;Połącz jako bliźniaki</translation>
    </message>
    <message>
        <source>&amp;Unlink twins</source>
        <translation>&amp;Rozłącz bliźniaki</translation>
    </message>
    <message>
        <source>R&amp;elease points from the twin</source>
        <translation>&amp;Uwolnij punkty od bliźniaka</translation>
    </message>
    <message>
        <source>Re-l&amp;ink points to the twin</source>
        <translation>Połą&amp;cz ponownie punkty</translation>
    </message>
    <message>
        <source>S&amp;ymmetry …</source>
        <translation>&amp;Symetria…</translation>
    </message>
    <message>
        <source>%1, mirrored</source>
        <translation>%1, lustrzanie</translation>
    </message>
    <message>
        <source>Select patches or curves that have no twin yet.</source>
        <translation>Zaznacz elementy lub krzywe, które nie mają jeszcze bliźniaka.</translation>
    </message>
    <message>
        <source>Nothing that is selected has a twin.</source>
        <translation>Nic z zaznaczenia nie ma bliźniaka.</translation>
    </message>
    <message>
        <source>Select points of a twin, or a seam on it, that still follow.</source>
        <translation>Zaznacz punkty bliźniaka lub szew na nim, które jeszcze za nim podążają.</translation>
    </message>
    <message>
        <source>No point that is selected has been released.</source>
        <translation>Żaden zaznaczony punkt nie został uwolniony.</translation>
    </message>
</context>
<context>
    <name>TwinForm</name>
    <message>
        <source>Mirror image</source>
        <translation>Odbicie lustrzane</translation>
    </message>
    <message>
        <source>released</source>
        <translation>uwolniony</translation>
    </message>
    <message>
        <source>itself</source>
        <translation>on sam</translation>
    </message>
    <message>
        <source>Re-lin&amp;k to its mirror image</source>
        <translation>Połącz ponownie z od&amp;biciem</translation>
    </message>
    <message>
        <source>Re&amp;lease from its mirror image</source>
        <translation>&amp;Uwolnij od odbicia</translation>
    </message>
    <message>
        <source>Twin of</source>
        <translation>Bliźniak obiektu</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>Wyjątki</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message numerus="yes">
        <source>%n released points</source>
        <translation>
            <numerusform>%n uwolniony punkt</numerusform>
            <numerusform>%n uwolnione punkty</numerusform>
            <numerusform>%n uwolnionych punktów</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Unlink from its twin</source>
        <translation>&amp;Odłącz od bliźniaka</translation>
    </message>
    <message>
        <source>Re-link all poi&amp;nts</source>
        <translation>Połącz ponownie wszystkie pun&amp;kty</translation>
    </message>
</context>
<context>
    <name>Units</name>
    <message>
        <source>%1 mm</source>
        <translation>%1&#xa0;mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
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
        <translation>%1&#xa0;ft</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1&#xa0;m</translation>
    </message>
    <message>
        <source>%1 ft²</source>
        <translation>%1&#xa0;ft²</translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1&#xa0;m²</translation>
    </message>
</context>
<context>
    <name>UnusableForm</name>
    <message>
        <source>Problems</source>
        <translation>Problemy</translation>
    </message>
    <message>
        <source>It keeps its text and is saved as it is.</source>
        <translation>Zachowuje swój tekst i jest zapisywany bez zmian.</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>Show &amp;all</source>
        <translation>Pokaż &amp;wszystko</translation>
    </message>
    <message>
        <source>Show &amp;selection</source>
        <translation>Pokaż &amp;zaznaczenie</translation>
    </message>
    <message>
        <source>Look at the &amp;cover from</source>
        <translation>Patrz na po&amp;krowiec</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>Z &amp;przodu</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>Z &amp;tyłu</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>Z &amp;lewej</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>Z p&amp;rawej</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>Z &amp;góry</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>Z &amp;dołu</translation>
    </message>
    <message>
        <source>Three-&amp;quarter</source>
        <translation>&amp;Ukośnie z przodu</translation>
    </message>
    <message>
        <source>Sa&amp;ved views</source>
        <translation>Zapi&amp;sane widoki</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspektywa</translation>
    </message>
    <message>
        <source>Sec&amp;tion</source>
        <translation>Przekró&amp;j</translation>
    </message>
    <message>
        <source>Lin&amp;k the views</source>
        <translation>Po&amp;łącz widoki</translation>
    </message>
    <message>
        <source>Show the pointer&apos;s place in the other view, too</source>
        <translation>Pokazuj położenie wskaźnika także w drugim widoku</translation>
    </message>
    <message>
        <source>&amp;Hide selected</source>
        <translation>&amp;Ukryj zaznaczone</translation>
    </message>
    <message>
        <source>&amp;Isolate selected</source>
        <translation>&amp;Izoluj zaznaczone</translation>
    </message>
    <message>
        <source>Sho&amp;w hidden again</source>
        <translation>Pokaż ponownie ukryt&amp;e</translation>
    </message>
    <message>
        <source>Th&amp;eme</source>
        <translation>&amp;Motyw</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Jak &amp;system</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Jasny</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Ciemny</translation>
    </message>
    <message>
        <source>&amp;Opacity</source>
        <translation>Kr&amp;ycie</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>Frames and foam</source>
        <translation>Stelaże i pianka</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Skany</translation>
    </message>
    <message>
        <source>Opacity of frames and scans</source>
        <translation>Krycie stelaży i skanów</translation>
    </message>
    <message>
        <source>Select patches, curves, frames, foam or scans to hide them.</source>
        <translation>Zaznacz elementy, krzywe, stelaże, piankę lub skany, aby je ukryć.</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>&amp;Wysoki kontrast</translation>
    </message>
</context>
<context>
    <name>ViewPrint</name>
    <message>
        <source>Print the view</source>
        <translation>Drukuj widok</translation>
    </message>
    <message>
        <source>The view could not be printed.</source>
        <translation>Nie udało się wydrukować widoku.</translation>
    </message>
    <message>
        <source>The printer takes nothing at the moment. Look whether it is on and has paper, or print to a file.</source>
        <translation>Drukarka w tej chwili nic nie przyjmuje. Sprawdź, czy jest włączona i ma papier, albo drukuj do pliku.</translation>
    </message>
</context>
<context>
    <name>WhatsNew</name>
    <message>
        <source>What&apos;s new</source>
        <translation>Co nowego</translation>
    </message>
</context>
<context>
    <name>WindowCommands</name>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>&amp;Następna część okna</translation>
    </message>
    <message>
        <source>Pre&amp;vious part of the window</source>
        <translation>&amp;Poprzednia część okna</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>P&amp;rzywróć układ okna</translation>
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
        <translation>T&amp;ylko w pomalowanym obszarze</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Maluj</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Wyczyść</translation>
    </message>
    <message>
        <source>The form and the limit of strain count only there</source>
        <translation>Forma i granica odkształcenia liczą się tylko tam</translation>
    </message>
    <message>
        <source>Drag over the cover in the 3D view; with Shift held down it takes away</source>
        <translation>Przeciągnij po pokrowcu w widoku 3D; z wciśniętym Shift odejmuje</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Promień pędzla</translation>
    </message>
    <message>
        <source>Painted area</source>
        <translation>Pomalowany obszar</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Promień</translation>
    </message>
</context>
<context>
    <name>bolster::Banner</name>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
</context>
<context>
    <name>bolster::CanvasChoice</name>
    <message>
        <source>Drawn in software</source>
        <translation>Rysowanie programowe</translation>
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
        <translation>Dlaczego tak jest?</translation>
    </message>
    <message>
        <source>The scan of the piece</source>
        <translation>Skan sztuki</translation>
    </message>
    <message>
        <source>The scan of a sound piece</source>
        <translation>Skan dobrej sztuki</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Brak</translation>
    </message>
    <message>
        <source>Of a piece that is as it should be: where that lies elsewhere than the cover no cause is looked for</source>
        <translation>Skan sztuki, która jest taka, jak powinna: gdzie leży ona inaczej niż pokrowiec, przyczyny się nie szuka</translation>
    </message>
    <message>
        <source>Scan of the &amp;piece</source>
        <translation>Skan &amp;sztuki</translation>
    </message>
    <message>
        <source>Scan of a so&amp;und piece</source>
        <translation>Skan &amp;dobrej sztuki</translation>
    </message>
    <message>
        <source>Look for the &amp;cause</source>
        <translation>Szukaj &amp;przyczyny</translation>
    </message>
    <message>
        <source>Looking for a cause …</source>
        <translation>Szukanie przyczyny…</translation>
    </message>
    <message>
        <source>Says which one cause explains best how far a built piece lies from the cover: foam, a seam&apos;s allowance, a stretched piece, a fixation off its place, a slipped notch.</source>
        <translation>Mówi, która jedna przyczyna najlepiej wyjaśnia odległość wykonanej sztuki od pokrowca: pianka, naddatek szwu, rozciągnięty element, przesunięte mocowanie, przesunięte nacięcie.</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Przyczyna</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Wielkość</translation>
    </message>
    <message>
        <source>Explains</source>
        <translation>Wyjaśnia</translation>
    </message>
    <message>
        <source>Probability</source>
        <translation>Prawdopodobieństwo</translation>
    </message>
    <message>
        <source>Causes</source>
        <translation>Przyczyny</translation>
    </message>
    <message>
        <source>Choose the scan of the piece that was built.</source>
        <translation>Wybierz skan wykonanej sztuki.</translation>
    </message>
    <message>
        <source>Covers with each cause are solved …</source>
        <translation>Obliczanie pokrowców z każdą przyczyną…</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Zatrzymano.</translation>
    </message>
    <message>
        <source>The scan shows nothing of the cover: does it lie where the design is?</source>
        <translation>Skan nie pokazuje nic z pokrowca: czy leży tam, gdzie model?</translation>
    </message>
    <message>
        <source>The scan shows %1 of the cover and lies %2 (rms) from it. All causes together leave %3.</source>
        <translation>Skan pokazuje %1 pokrowca i leży od niego %2 (RMS). Wszystkie przyczyny razem pozostawiają %3.</translation>
    </message>
    <message>
        <source>No single cause explains that better than noise does.</source>
        <translation>Żadna pojedyncza przyczyna nie wyjaśnia tego lepiej niż szum.</translation>
    </message>
    <message>
        <source>Most of the deviation has no cause of these kinds, so the first need not be the right one: give the scan of a sound piece, too.</source>
        <translation>Większość odchyłki nie ma przyczyny tego rodzaju, więc pierwsza nie musi być właściwa: podaj też skan dobrej sztuki.</translation>
    </message>
    <message numerus="yes">
        <source>and %n others</source>
        <translation>
            <numerusform>i %n inna</numerusform>
            <numerusform>i %n inne</numerusform>
            <numerusform>i %n innych</numerusform>
        </translation>
    </message>
    <message>
        <source>The scan does not tell it apart from: %1</source>
        <translation>Skan nie odróżnia jej od: %1</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: look again.</source>
        <translation>Model się tymczasem zmienił: szukaj ponownie.</translation>
    </message>
    <message>
        <source>Stopped. The list is that of the search before.</source>
        <translation>Zatrzymano. Lista pochodzi z poprzedniego wyszukiwania.</translation>
    </message>
    <message>
        <source>The scan lies on the cover: there is nothing to explain.</source>
        <translation>Skan leży na pokrowcu: nie ma czego wyjaśniać.</translation>
    </message>
    <message>
        <source>Even the likeliest cause explains only %1 of it: there may be several, or others than these.</source>
        <translation>Nawet najbardziej prawdopodobna przyczyna wyjaśnia tylko %1: może być ich kilka albo inne niż te.</translation>
    </message>
    <message>
        <source>Foam is thicker or thinner</source>
        <translation>Pianka jest grubsza lub cieńsza</translation>
    </message>
    <message>
        <source>Foam is harder or softer</source>
        <translation>Pianka jest twardsza lub miększa</translation>
    </message>
    <message>
        <source>Allowance of a seam</source>
        <translation>Naddatek szwu</translation>
    </message>
    <message>
        <source>Piece is larger or smaller</source>
        <translation>Element jest większy lub mniejszy</translation>
    </message>
    <message>
        <source>Fixation lies elsewhere</source>
        <translation>Mocowanie leży gdzie indziej</translation>
    </message>
    <message>
        <source>Seam is sewn shifted</source>
        <translation>Szew jest zszyty z przesunięciem</translation>
    </message>
    <message>
        <source>%1 thicker</source>
        <translation>o %1 grubsza</translation>
    </message>
    <message>
        <source>%1 thinner</source>
        <translation>o %1 cieńsza</translation>
    </message>
    <message>
        <source>%1 harder</source>
        <translation>o %1 twardsza</translation>
    </message>
    <message>
        <source>%1 softer</source>
        <translation>o %1 miększa</translation>
    </message>
    <message>
        <source>%1 farther out</source>
        <translation>o %1 dalej na zewnątrz</translation>
    </message>
    <message>
        <source>%1 farther in</source>
        <translation>o %1 dalej do wewnątrz</translation>
    </message>
    <message>
        <source>%1 larger</source>
        <translation>o %1 większy</translation>
    </message>
    <message>
        <source>%1 smaller</source>
        <translation>o %1 mniejszy</translation>
    </message>
    <message>
        <source>%1 counter-clockwise</source>
        <translation>%1 przeciwnie do ruchu wskazówek zegara</translation>
    </message>
    <message>
        <source>%1 clockwise</source>
        <translation>%1 zgodnie z ruchem wskazówek zegara</translation>
    </message>
    <message>
        <source>Farther out: the allowance was taken narrower, on both sides</source>
        <translation>Dalej na zewnątrz: po obu stronach przyjęto węższy naddatek</translation>
    </message>
    <message>
        <source>Along the edge of %1, as it lies in the pattern</source>
        <translation>Wzdłuż krawędzi %1, tak jak leży w wykroju</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>poniżej %1</translation>
    </message>
    <message>
        <source>The scan shows %1 of the cover. Its points lie %2 (rms) from the cover, of which all causes together leave %3. From the cover to the nearest point, as a fit measures, it is %4.</source>
        <translation>Skan pokazuje %1 pokrowca. Jego punkty leżą od pokrowca %2 (RMS), z czego wszystkie przyczyny razem pozostawiają %3. Od pokrowca do najbliższego punktu, jak mierzy dopasowanie, jest %4.</translation>
    </message>
    <message>
        <source>That is far more than such a cause usually is: there may be several, or others than these.</source>
        <translation>To znacznie więcej, niż taka przyczyna zwykle wynosi: może być ich kilka albo inne niż te.</translation>
    </message>
    <message>
        <source>What the likeliest cause leaves is more than noise: something else may be wrong, too, and its amount may be off by more than is said.</source>
        <translation>To, co pozostawia najbardziej prawdopodobna przyczyna, to więcej niż szum: być może coś jeszcze jest nie tak, a jej wartość może być mniej dokładna, niż podano.</translation>
    </message>
    <message numerus="yes">
        <source>%n more causes explain some of it, less likely than these.</source>
        <translation>
            <numerusform>%n dalsza przyczyna wyjaśnia coś z tego, mniej prawdopodobna niż te.</numerusform>
            <numerusform>%n dalsze przyczyny wyjaśniają coś z tego, mniej prawdopodobne niż te.</numerusform>
            <numerusform>%n dalszych przyczyn wyjaśnia coś z tego, mniej prawdopodobnych niż te.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::ColourwayWindow</name>
    <message>
        <source>Compare colourways</source>
        <translation>Porównaj warianty kolorystyczne</translation>
    </message>
    <message>
        <source>The colourway that is shown below</source>
        <translation>Wariant kolorystyczny pokazany poniżej</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>Jak wykonano</translation>
    </message>
</context>
<context>
    <name>bolster::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Znajdź polecenie</translation>
    </message>
    <message>
        <source>There is no such command.</source>
        <translation>Nie ma takiego polecenia.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Polecenia</translation>
    </message>
</context>
<context>
    <name>bolster::CompareWindow</name>
    <message>
        <source>&amp;Take from there</source>
        <translation>&amp;Przejmij stamtąd</translation>
    </message>
    <message>
        <source>Compare versions</source>
        <translation>Porównaj wersje</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>Różnice</translation>
    </message>
    <message>
        <source>There</source>
        <translation>Tam</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Teraz</translation>
    </message>
    <message>
        <source>Makes the chosen elements as they are in the other version: one step in the history</source>
        <translation>Nadaje wybranym obiektom stan z innej wersji: jeden krok historii</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Początek</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>only now</source>
        <translation>tylko teraz</translation>
    </message>
    <message>
        <source>only there</source>
        <translation>tylko tam</translation>
    </message>
    <message>
        <source>Nothing differs</source>
        <translation>Brak różnic</translation>
    </message>
    <message>
        <source>&amp;Move both together</source>
        <translation>Poruszaj &amp;obiema razem</translation>
    </message>
    <message>
        <source>Turning, moving or zooming one version does the same to the other</source>
        <translation>Obracanie, przesuwanie i powiększanie jednej wersji działa też na drugą</translation>
    </message>
</context>
<context>
    <name>bolster::ContextMenus</name>
    <message>
        <source>Leave this &amp;piece out</source>
        <translation>Pomiń ten &amp;kawałek</translation>
    </message>
    <message>
        <source>Hides this piece of the frame from the view, drawing, cushioning and contact; the frame&apos;s properties bring it back</source>
        <translation>Ukrywa ten kawałek stelaża w widoku, przy rysowaniu, wyściełaniu i kontakcie; przywracają go właściwości stelaża</translation>
    </message>
</context>
<context>
    <name>bolster::CoverSelectTool</name>
    <message>
        <source>Kept to an axis; the same key frees it</source>
        <translation>Związany z osią; ten sam klawisz uwalnia</translation>
    </message>
    <message>
        <source>Lifted off the frame along its normal; let go of Ctrl to slide on it</source>
        <translation>Uniesiony ze stelaża wzdłuż normalnej; puść Ctrl, aby się po nim ślizgać</translation>
    </message>
    <message>
        <source>On the frame: Ctrl lifts off, S lets go of it, X, Y, Z or Shift keep to an axis</source>
        <translation>Na stelażu: Ctrl unosi, S odrywa, X, Y, Z lub Shift trzymają się osi</translation>
    </message>
    <message>
        <source>X, Y, Z or Shift keep to an axis, S keeps to the frame, Ctrl lifts off, Escape cancels</source>
        <translation>X, Y, Z lub Shift trzymają się osi, S trzyma się stelaża, Ctrl unosi, Escape anuluje</translation>
    </message>
    <message>
        <source>Moved by x %1, y %2, z %3</source>
        <translation>Przesunięto o x %1, y %2, z %3</translation>
    </message>
</context>
<context>
    <name>bolster::CutFindingsList</name>
    <message>
        <source>What to look at before cutting</source>
        <translation>Co obejrzeć przed krojeniem</translation>
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
        <translation>Dwukrotne kliknięcie pokazuje, gdzie to jest.</translation>
    </message>
    <message>
        <source>Nothing to mend: the pattern can be cut.</source>
        <translation>Nic do poprawienia: wykrój można kroić.</translation>
    </message>
    <message>
        <source>Looking the pattern over …</source>
        <translation>Sprawdzanie wykroju…</translation>
    </message>
    <message>
        <source>There is no pattern yet.</source>
        <translation>Nie ma jeszcze wykroju.</translation>
    </message>
</context>
<context>
    <name>bolster::DesignSession</name>
    <message>
        <source>New design</source>
        <translation>Nowy model</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Materiał</translation>
    </message>
    <message>
        <source>Restored design</source>
        <translation>Przywrócony model</translation>
    </message>
    <message>
        <source> (other)</source>
        <translation> (inny)</translation>
    </message>
    <message>
        <source> (other %1)</source>
        <translation> (inny %1)</translation>
    </message>
</context>
<context>
    <name>bolster::DockTitle</name>
    <message>
        <source>Take out of the window, or put back</source>
        <translation>Wyjmij z okna lub włóż z powrotem</translation>
    </message>
    <message>
        <source>Close; the Window menu brings it back</source>
        <translation>Zamknij; przywraca menu Okno</translation>
    </message>
</context>
<context>
    <name>bolster::DropFlow</name>
    <message>
        <source>&quot;%1&quot; cannot be opened.</source>
        <translation>Nie można otworzyć „%1”.</translation>
    </message>
    <message>
        <source>The system did not start the program again for another window. Open it from here instead.</source>
        <translation>System nie uruchomił programu ponownie dla kolejnego okna. Otwórz plik stąd.</translation>
    </message>
    <message>
        <source>It is a folder. Drop the files that are in it.</source>
        <translation>To jest folder. Upuść pliki, które w nim są.</translation>
    </message>
    <message>
        <source>It is not on this computer, or not any more. Save it to a folder first.</source>
        <translation>Nie ma go na tym komputerze lub już go nie ma. Najpierw zapisz go w folderze.</translation>
    </message>
    <message>
        <source>Bolster opens projects and designs (%1), frames (%2), scans (%3), patterns (%4) and pictures of fabrics (%5). Save it in one of these formats with the program it comes from.</source>
        <translation>Bolster otwiera projekty i modele (%1), stelaże (%2), skany (%3), wykroje (%4) i obrazy materiałów (%5). Zapisz plik w jednym z tych formatów programem, z którego pochodzi.</translation>
    </message>
</context>
<context>
    <name>bolster::ElementsModel</name>
    <message>
        <source>Hidden in the 3D view</source>
        <translation>Ukryty w widoku 3D</translation>
    </message>
</context>
<context>
    <name>bolster::ElementsView</name>
    <message>
        <source>Find an element</source>
        <translation>Znajdź obiekt</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Obiekty</translation>
    </message>
    <message>
        <source>By its name, or by a word of its note</source>
        <translation>Po nazwie lub słowie z uwagi</translation>
    </message>
</context>
<context>
    <name>bolster::ExportFlow</name>
    <message>
        <source>Export pattern</source>
        <translation>Eksportuj wykrój</translation>
    </message>
    <message>
        <source>-sewing</source>
        <translation>-szycie</translation>
    </message>
    <message>
        <source>-pattern</source>
        <translation>-wykroj</translation>
    </message>
    <message>
        <source>%1 (*.%2)</source>
        <translation>%1 (*.%2)</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>Zapisywanie: %1…</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Wyeksportowano do %1</translation>
    </message>
    <message>
        <source>The pattern could not be exported.</source>
        <translation>Nie udało się wyeksportować wykroju.</translation>
    </message>
    <message>
        <source>Export cover</source>
        <translation>Eksportuj pokrowiec</translation>
    </message>
    <message>
        <source>-cover</source>
        <translation>-pokrowiec</translation>
    </message>
    <message>
        <source>Export foam</source>
        <translation>Eksportuj piankę</translation>
    </message>
    <message>
        <source>-foam</source>
        <translation>-pianka</translation>
    </message>
    <message>
        <source>Exporting %1 …</source>
        <translation>Eksportowanie: %1…</translation>
    </message>
    <message>
        <source>The cover could not be exported.</source>
        <translation>Nie udało się wyeksportować pokrowca.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is written.</source>
        <translation>Zapisano „%1”.</translation>
    </message>
    <message>
        <source>Export surface</source>
        <translation>Eksportuj powierzchnię</translation>
    </message>
    <message>
        <source>The surface could not be exported.</source>
        <translation>Nie udało się wyeksportować powierzchni.</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Eksportuj obraz</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>The picture could not be exported.</source>
        <translation>Nie udało się wyeksportować obrazu.</translation>
    </message>
    <message>
        <source>-surface</source>
        <translation>-powierzchnia</translation>
    </message>
</context>
<context>
    <name>bolster::ExportPatternDialog</name>
    <message>
        <source>Export pattern</source>
        <translation>Eksportuj wykrój</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Elementy</translation>
    </message>
    <message>
        <source>&amp;Export …</source>
        <translation>&amp;Eksportuj…</translation>
    </message>
    <message>
        <source>PDF – to print and put together</source>
        <translation>PDF – do druku i sklejenia</translation>
    </message>
    <message>
        <source>DXF AAMA – for cutters</source>
        <translation>DXF AAMA – do cutterów</translation>
    </message>
    <message>
        <source>DXF ASTM – for cutters</source>
        <translation>DXF ASTM – do cutterów</translation>
    </message>
    <message>
        <source>DXF, plain lines</source>
        <translation>DXF, zwykłe linie</translation>
    </message>
    <message>
        <source>SVG – 1:1</source>
        <translation>SVG – 1:1</translation>
    </message>
    <message>
        <source>HPGL – for plotters</source>
        <translation>HPGL – do ploterów</translation>
    </message>
    <message>
        <source>Roll, %1 mm wide</source>
        <translation>Rola, szerokość %1&#xa0;mm</translation>
    </message>
    <message>
        <source>&amp;Landscape</source>
        <translation>Po&amp;ziomo</translation>
    </message>
    <message>
        <source>Mirrored pairs as &amp;two pieces</source>
        <translation>Pary lustrzane jako &amp;dwa elementy</translation>
    </message>
    <message>
        <source>The design says it; it is changed in its properties.</source>
        <translation>Określa to model; zmienia się we właściwościach.</translation>
    </message>
    <message>
        <source>Of patches and edges that have none of their own.</source>
        <translation>Elementów i krawędzi bez własnego.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Plik</translation>
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
        <translation>N&amp;addatek na szew</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Sewing li&amp;nes</source>
        <translation>Linie &amp;szycia</translation>
    </message>
    <message>
        <source>Notc&amp;hes</source>
        <translation>Na&amp;cięcia</translation>
    </message>
    <message>
        <source>&amp;Grain lines</source>
        <translation>&amp;Nitka prosta</translation>
    </message>
    <message>
        <source>La&amp;bels</source>
        <translation>&amp;Opisy</translation>
    </message>
    <message>
        <source>&amp;Internal lines</source>
        <translation>Linie &amp;wewnętrzne</translation>
    </message>
    <message>
        <source>&amp;Drill holes</source>
        <translation>Naw&amp;ierty</translation>
    </message>
    <message numerus="yes">
        <source>%n pages</source>
        <translation>
            <numerusform>%n strona</numerusform>
            <numerusform>%n strony</numerusform>
            <numerusform>%n stron</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n patches are left out: their outlines cross themselves</source>
        <translation>
            <numerusform>Pominięto %n element: jego kontur przecina sam siebie</numerusform>
            <numerusform>Pominięto %n elementy: ich kontury przecinają same siebie</numerusform>
            <numerusform>Pominięto %n elementów: ich kontury przecinają same siebie</numerusform>
        </translation>
    </message>
    <message>
        <source>C&amp;ut lines</source>
        <translation>&amp;Linie cięcia</translation>
    </message>
    <message>
        <source>Sewing sheet (PDF)</source>
        <translation>Karta szycia (PDF)</translation>
    </message>
    <message>
        <source>DXF, plain curves (R2000)</source>
        <translation>DXF, zwykłe krzywe (R2000)</translation>
    </message>
    <message>
        <source>too many sheets: is its unit right?</source>
        <translation>za dużo arkuszy: czy jednostka jest właściwa?</translation>
    </message>
    <message>
        <source>the first %1 are shown</source>
        <translation>pokazano pierwsze %1</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>Nie ma nic do krojenia.</translation>
    </message>
    <message>
        <source>A double click leaves this window and shows where it is; the whole list is in the panel &quot;Check before cutting&quot;.</source>
        <translation>Dwukrotne kliknięcie opuszcza to okno i pokazuje, gdzie to jest; cała lista jest w panelu „Kontrola przed krojeniem”.</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces on %1</source>
        <translation>
            <numerusform>%n element na %1</numerusform>
            <numerusform>%n elementy na %1</numerusform>
            <numerusform>%n elementów na %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FabricCommands</name>
    <message>
        <source>Rename fabric</source>
        <translation>Zmień nazwę materiału</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nazwa:</translation>
    </message>
    <message>
        <source>Delete fabric</source>
        <translation>Usuń materiał</translation>
    </message>
    <message numerus="yes">
        <source>%n patches have &quot;%1&quot;. What shall they get instead?</source>
        <translation>
            <numerusform>%n element ma „%1”. Co ma dostać w zamian?</numerusform>
            <numerusform>%n elementy mają „%1”. Co mają dostać w zamian?</numerusform>
            <numerusform>%n elementów ma „%1”. Co mają dostać w zamian?</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the patches that shall get the fabric, then choose it in the library.</source>
        <translation>Zaznacz elementy, które mają dostać materiał, potem wybierz go w bibliotece.</translation>
    </message>
    <message>
        <source>New colourway</source>
        <translation>Nowy wariant kolorystyczny</translation>
    </message>
    <message>
        <source>Name of the colourway; it begins as what is shown now:</source>
        <translation>Nazwa wariantu kolorystycznego; zaczyna od tego, co teraz widać:</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>Wariant kolorystyczny</translation>
    </message>
    <message>
        <source>Rename colourway</source>
        <translation>Zmień nazwę wariantu</translation>
    </message>
    <message>
        <source>Picture of a fabric</source>
        <translation>Obraz materiału</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Obrazy (%1)</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Odczytywanie: %1…</translation>
    </message>
    <message>
        <source>The picture could not be read.</source>
        <translation>Nie udało się odczytać obrazu.</translation>
    </message>
    <message>
        <source>The picture could not be taken into the design.</source>
        <translation>Nie udało się przejąć obrazu do modelu.</translation>
    </message>
    <message>
        <source>Import fabrics</source>
        <translation>Importuj materiały</translation>
    </message>
    <message>
        <source>Fabrics, designs and projects (*.json *.bolster)</source>
        <translation>Materiały, modele i projekty (*.json *.bolster)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be read.</source>
        <translation>Nie udało się odczytać „%1”.</translation>
    </message>
    <message>
        <source>Nothing was imported.</source>
        <translation>Niczego nie zaimportowano.</translation>
    </message>
    <message numerus="yes">
        <source>%n fabrics imported from %1</source>
        <translation>
            <numerusform>Zaimportowano %n materiał z %1</numerusform>
            <numerusform>Zaimportowano %n materiały z %1</numerusform>
            <numerusform>Zaimportowano %n materiałów z %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Export fabric</source>
        <translation>Eksportuj materiał</translation>
    </message>
    <message>
        <source>Fabrics (*.json)</source>
        <translation>Materiały (*.json)</translation>
    </message>
    <message>
        <source>The fabric could not be exported.</source>
        <translation>Nie udało się wyeksportować materiału.</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Wyeksportowano do %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not deleted.</source>
        <translation>„%1” nie zostaje usunięty.</translation>
    </message>
    <message>
        <source>It is the only fabric, and patches are made of it. Add another one first.</source>
        <translation>To jedyny materiał i są z niego elementy. Najpierw dodaj inny.</translation>
    </message>
</context>
<context>
    <name>bolster::FabricPanel</name>
    <message>
        <source>Colourways</source>
        <translation>Warianty kolorystyczne</translation>
    </message>
    <message>
        <source>A click shows the cover in this colourway</source>
        <translation>Kliknięcie pokazuje pokrowiec w tym wariancie kolorystycznym</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Materiały</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>Wariant</translation>
    </message>
    <message>
        <source>New …</source>
        <translation>Nowy…</translation>
    </message>
    <message>
        <source>Rename …</source>
        <translation>Zmień nazwę…</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Porównaj</translation>
    </message>
    <message>
        <source>Fabrics: drag them onto patches</source>
        <translation>Materiały: przeciągnij na elementy</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nowy</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Przypisz</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiuj</translation>
    </message>
    <message>
        <source>Delete …</source>
        <translation>Usuń…</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>Jak wykonano</translation>
    </message>
    <message>
        <source>No patch has it.</source>
        <translation>Nie ma go żaden element.</translation>
    </message>
    <message numerus="yes">
        <source>%n patches have it.</source>
        <translation>
            <numerusform>Ma go %n element.</numerusform>
            <numerusform>Mają go %n elementy.</numerusform>
            <numerusform>Ma go %n elementów.</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag it onto a patch; a double click shows its properties.</source>
        <translation>Przeciągnij na element; dwukrotne kliknięcie pokazuje właściwości.</translation>
    </message>
    <message>
        <source>Adds this fabric to the library of the design</source>
        <translation>Dodaje ten materiał do biblioteki modelu</translation>
    </message>
</context>
<context>
    <name>bolster::FieldText</name>
    <message>
        <source>usual</source>
        <translation>zwykle</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>tak</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>turned by %1</source>
        <translation>obrót o %1</translation>
    </message>
    <message>
        <source>%1, from %2 to %3</source>
        <translation>%1, od %2 do %3</translation>
    </message>
    <message numerus="yes">
        <source>%n points, %1</source>
        <translation>
            <numerusform>%n punkt, %1</numerusform>
            <numerusform>%n punkty, %1</numerusform>
            <numerusform>%n punktów, %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FileChoice</name>
    <message>
        <source>A file …</source>
        <translation>Plik…</translation>
    </message>
</context>
<context>
    <name>bolster::FileImportDialog</name>
    <message>
        <source> mm per unit</source>
        <translation> mm na jednostkę</translation>
    </message>
    <message>
        <source>Import scan</source>
        <translation>Importuj skan</translation>
    </message>
    <message>
        <source>Import frame</source>
        <translation>Importuj stelaż</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Milimetry</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centymetry</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Metry</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Cale</translation>
    </message>
    <message>
        <source>Another factor</source>
        <translation>Inny współczynnik</translation>
    </message>
    <message>
        <source>z points up</source>
        <translation>z w górę</translation>
    </message>
    <message>
        <source>y points up</source>
        <translation>y w górę</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;Punkty: %2</translation>
    </message>
    <message>
        <source>Width, depth, height</source>
        <translation>Szerokość, głębokość, wysokość</translation>
    </message>
    <message>
        <source>That is unusual for a piece of furniture: check the unit.</source>
        <translation>To nietypowe dla mebla: sprawdź jednostkę.</translation>
    </message>
    <message>
        <source>&amp;Keep scale, position and rotation</source>
        <translation>Zachowaj &amp;skalę, położenie i obrót</translation>
    </message>
    <message>
        <source>&amp;Place it on the floor, in the middle</source>
        <translation>Umieść na środku &amp;podłogi</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>&amp;Jednostka pliku</translation>
    </message>
    <message>
        <source>&amp;Factor</source>
        <translation>&amp;Współczynnik</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>&amp;Osie</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importuj</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>It would be %1 large. Import it like that?</source>
        <translation>Miałby rozmiar %1. Importować w ten sposób?</translation>
    </message>
    <message>
        <source>Another unit or factor makes it as large as it is meant.</source>
        <translation>Inna jednostka lub inny współczynnik nada mu właściwy rozmiar.</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Stopy</translation>
    </message>
    <message>
        <source>x points up</source>
        <translation>x w górę</translation>
    </message>
    <message>
        <source>The file says its unit and its axes.</source>
        <translation>Plik podaje jednostkę i osie.</translation>
    </message>
    <message numerus="yes">
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points, %Ln triangles</source>
        <translation>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;Punkty: %2, %Ln trójkąt</numerusform>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;Punkty: %2, %Ln trójkąty</numerusform>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;Punkty: %2, %Ln trójkątów</numerusform>
        </translation>
    </message>
    <message>
        <source>The file says its unit; the axes are guessed.</source>
        <translation>Plik podaje jednostkę; osie odgadnięto.</translation>
    </message>
    <message>
        <source>The file says its axes; the unit is guessed.</source>
        <translation>Plik podaje osie; jednostkę odgadnięto.</translation>
    </message>
    <message>
        <source>Unit and axes are guessed: look at the picture and the size.</source>
        <translation>Jednostkę i osie odgadnięto: spójrz na obraz i rozmiar.</translation>
    </message>
    <message>
        <source>&amp;Keep position and rotation</source>
        <translation>&amp;Zachowaj położenie i obrót</translation>
    </message>
    <message>
        <source>The file has %1 points. That is more than are needed to fit a cover, so they were thinned out to one every %2.</source>
        <translation>Punkty w pliku: %1. To więcej, niż trzeba do dopasowania pokrowca, więc przerzedzono je do jednego co %2.</translation>
    </message>
    <message>
        <source>It was %1 large and becomes %2: check the unit.</source>
        <translation>Miał rozmiar %1, a ma mieć %2: sprawdź jednostkę.</translation>
    </message>
    <message>
        <source>The unit is guessed: look at the size.</source>
        <translation>Jednostka jest odgadnięta: proszę sprawdzić rozmiar.</translation>
    </message>
    <message>
        <source>The axes are guessed: look at the picture.</source>
        <translation>Osie są odgadnięte: proszę sprawdzić obraz.</translation>
    </message>
</context>
<context>
    <name>bolster::FileTalk</name>
    <message>
        <source>&quot;%1&quot; is not replaced.</source>
        <translation>„%1” nie zostaje zastąpiony.</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Odczytywanie: %1…</translation>
    </message>
</context>
<context>
    <name>bolster::FitOrderPanel</name>
    <message>
        <source>Goal</source>
        <translation>Cel</translation>
    </message>
    <message>
        <source>The cover &amp;lies on</source>
        <translation>Pokrowiec &amp;leży na</translation>
    </message>
    <message>
        <source>The form that the cover shall lie on</source>
        <translation>Forma, na której ma leżeć pokrowiec</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>&amp;Strain is at most</source>
        <translation>&amp;Odkształcenie najwyżej</translation>
    </message>
    <message>
        <source>Along the grain, across it, and in shear; the cover stays where it is</source>
        <translation>Wzdłuż nitki, w poprzek i przy ścinaniu; pokrowiec pozostaje na miejscu</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Limit of strain</source>
        <translation>Granica odkształcenia</translation>
    </message>
    <message>
        <source>&amp;No folds in selected patches</source>
        <translation>Bez &amp;fałd w zaznaczonych elementach</translation>
    </message>
    <message>
        <source>No cloth of them is pressed together; none selected: all</source>
        <translation>Ich materiał nigdzie nie jest ściskany; gdy nic nie zaznaczono: wszystkie</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Krzywa</translation>
    </message>
    <message>
        <source>The selected seam r&amp;uns along</source>
        <translation>Zaznaczony szew b&amp;iegnie wzdłuż</translation>
    </message>
    <message>
        <source>A curve drawn on the frame or the form; it need hold nothing</source>
        <translation>Krzywa narysowana na stelażu lub formie; nie musi niczego mocować</translation>
    </message>
    <message>
        <source>Share of the area</source>
        <translation>Udział powierzchni</translation>
    </message>
    <message>
        <source>Area of selected patches &amp;becomes</source>
        <translation>Powierzchnia zaznaczonych elementów &amp;wynosi</translation>
    </message>
    <message>
        <source>Less than 100 %: they become smaller</source>
        <translation>Poniżej 100%: stają się mniejsze</translation>
    </message>
    <message>
        <source>What may change</source>
        <translation>Co może się zmienić</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>&amp;Kontury</translation>
    </message>
    <message>
        <source>Control points of the patches</source>
        <translation>Punkty kontrolne elementów</translation>
    </message>
    <message>
        <source>Ends of seams</source>
        <translation>Końce szwów</translation>
    </message>
    <message>
        <source>Where seams and fixations end on smooth edges</source>
        <translation>Gdzie szwy i mocowania kończą się na gładkich krawędziach</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Wdanie</translation>
    </message>
    <message>
        <source>Sides of seams may come to differ in length; that is then the ease wanted</source>
        <translation>Boki szwów mogą stać się różnej długości; to jest wtedy żądane wdanie</translation>
    </message>
    <message>
        <source>Fo&amp;am</source>
        <translation>Pi&amp;anka</translation>
    </message>
    <message>
        <source>How thick cushions and foam are, by whole voxels</source>
        <translation>Grubość wyściółek i pianki, w całych wokselach</translation>
    </message>
    <message>
        <source>F&amp;ixations</source>
        <translation>&amp;Mocowania</translation>
    </message>
    <message>
        <source>Where fixation curves lie: on their frames, or in space where there is none</source>
        <translation>Gdzie leżą krzywe mocowania: na stelażach albo w przestrzeni, jeśli stelaża nie ma</translation>
    </message>
    <message>
        <source>&amp;Pressure</source>
        <translation>&amp;Ciśnienie</translation>
    </message>
    <message>
        <source>The pressure under each patch</source>
        <translation>Ciśnienie pod każdym elementem</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Rozciągliwość</translation>
    </message>
    <message>
        <source>Stiffness of the fabrics, and how much they contract across a pull</source>
        <translation>Sztywność materiałów i to, jak kurczą się w poprzek naciągu</translation>
    </message>
    <message>
        <source>Of sele&amp;cted patches only</source>
        <translation>Tylko w &amp;zaznaczonych elementach</translation>
    </message>
    <message>
        <source>What stays</source>
        <translation>Co pozostaje</translation>
    </message>
    <message>
        <source>L&amp;engths of seams</source>
        <translation>&amp;Długości szwów</translation>
    </message>
    <message>
        <source>The sides of a seam keep their difference; if it is far from the seam&apos;s ease, it comes nearer to it</source>
        <translation>Strony szwu zachowują różnicę; jeśli jest daleka od wdania szwu, zbliża się do niego</translation>
    </message>
    <message>
        <source>St&amp;raight edges</source>
        <translation>P&amp;roste krawędzie</translation>
    </message>
    <message>
        <source>An&amp;gles of corners</source>
        <translation>Kąty ro&amp;gów</translation>
    </message>
    <message>
        <source>No point &amp;moves farther than</source>
        <translation>Żaden punkt nie przesunie &amp;się dalej niż</translation>
    </message>
    <message>
        <source>Choose the scan or the file that the cover shall lie on.</source>
        <translation>Wybierz skan lub plik, na którym ma leżeć pokrowiec.</translation>
    </message>
    <message>
        <source>Select the seam that shall run along the curve.</source>
        <translation>Zaznacz szew, który ma biec wzdłuż krzywej.</translation>
    </message>
    <message>
        <source>Paint the area in the 3D view, or untick it.</source>
        <translation>Pomaluj obszar w widoku 3D albo odznacz go.</translation>
    </message>
    <message>
        <source>Select the patches that shall become larger or smaller.</source>
        <translation>Zaznacz elementy, które mają się stać większe lub mniejsze.</translation>
    </message>
    <message>
        <source>Choose a goal.</source>
        <translation>Wybierz cel.</translation>
    </message>
    <message>
        <source>Edges that look straight stay so: those that bow by less than %1 in %2</source>
        <translation>Krawędzie, które wyglądają na proste, takie pozostają: te, które wyginają się o mniej niż %1 na %2</translation>
    </message>
</context>
<context>
    <name>bolster::FlatPiecesView</name>
    <message>
        <source>Pieces laid flat</source>
        <translation>Elementy na płasko</translation>
    </message>
    <message>
        <source>Strain: %1</source>
        <translation>Odkształcenie: %1</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 i więcej</translation>
    </message>
    <message>
        <source>%1: strain %2 (rms)</source>
        <translation>%1: odkształcenie %2 (rms)</translation>
    </message>
</context>
<context>
    <name>bolster::FormChoice</name>
    <message>
        <source>Meshes and scans (%1);;All files (*)</source>
        <translation>Siatki i skany (%1);;Wszystkie pliki (*)</translation>
    </message>
</context>
<context>
    <name>bolster::FormPatternWindow</name>
    <message>
        <source>&amp;Make the pattern</source>
        <translation>&amp;Utwórz wykrój</translation>
    </message>
    <message>
        <source>Laying it flat …</source>
        <translation>Rozkładanie na płasko…</translation>
    </message>
    <message>
        <source>&amp;Make it without what is left out</source>
        <translation>&amp;Utwórz bez pominiętego</translation>
    </message>
    <message>
        <source>Laying a form flat …</source>
        <translation>Rozkładanie formy na płasko…</translation>
    </message>
    <message>
        <source>What came of it</source>
        <translation>Co z tego wyszło</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>Za&amp;trzymaj</translation>
    </message>
    <message>
        <source>Choose a file with a form above, or import a frame first.</source>
        <translation>Wybierz powyżej plik z formą albo najpierw zaimportuj stelaż.</translation>
    </message>
    <message>
        <source>It is laid flat again when you let go.</source>
        <translation>Zostanie ponownie rozłożona, gdy puścisz.</translation>
    </message>
    <message numerus="yes">
        <source>Dividing it, %n pieces so far …</source>
        <translation>
            <numerusform>Dzielenie, dotąd %n kawałek …</numerusform>
            <numerusform>Dzielenie, dotąd %n kawałki …</numerusform>
            <numerusform>Dzielenie, dotąd %n kawałków …</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Lay it flat</source>
        <translation>&amp;Rozłóż na płasko</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>Zatrzymano.</translation>
    </message>
    <message>
        <source>It was stopped. These are the pieces from before.</source>
        <translation>Zatrzymano. To są poprzednie elementy.</translation>
    </message>
    <message>
        <source>From a form</source>
        <translation>Z formy</translation>
    </message>
</context>
<context>
    <name>bolster::FormWishesPanel</name>
    <message>
        <source>The form to be covered</source>
        <translation>Forma do pokrycia</translation>
    </message>
    <message>
        <source>Meshes and CAD files (%1);;All files (*)</source>
        <translation>Siatki i pliki CAD (%1);;Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>Where the grain line runs on the form</source>
        <translation>Jak biegnie kierunek nitki na formie</translation>
    </message>
    <message>
        <source>upwards</source>
        <translation>w górę</translation>
    </message>
    <message>
        <source>to the back</source>
        <translation>do tyłu</translation>
    </message>
    <message>
        <source>sideways</source>
        <translation>w bok</translation>
    </message>
    <message>
        <source>&amp;Form</source>
        <translation>&amp;Forma</translation>
    </message>
    <message>
        <source>Fa&amp;bric</source>
        <translation>&amp;Materiał</translation>
    </message>
    <message>
        <source>&amp;Grain runs</source>
        <translation>Kierunek &amp;nitki</translation>
    </message>
    <message>
        <source>It is cut</source>
        <translation>Cięcie</translation>
    </message>
    <message>
        <source>and along the ticked lines:</source>
        <translation>oraz wzdłuż zaznaczonych linii:</translation>
    </message>
    <message>
        <source>where its &amp;parts meet</source>
        <translation>tam, gdzie stykają się jej &amp;części</translation>
    </message>
    <message>
        <source>at the edges of its &amp;CAD faces</source>
        <translation>na krawędziach jego ścian &amp;CAD</translation>
    </message>
    <message>
        <source>Each face as the CAD program has it, also where two go on smoothly in each other</source>
        <translation>Każda ściana tak, jak zna ją program CAD, także tam, gdzie dwie gładko przechodzą w siebie</translation>
    </message>
    <message>
        <source>where it &amp;bends by more than</source>
        <translation>tam, gdzie &amp;zagina się o więcej niż</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Kąt</translation>
    </message>
    <message>
        <source>where it would &amp;not lie flat</source>
        <translation>tam, gdzie &amp;nie leżałaby płasko</translation>
    </message>
    <message>
        <source>Pieces that would lie over themselves, or be strained by more than the fabric may be, are divided where they bend most or are narrow; an armchair takes some seconds</source>
        <translation>Kawałki, które nachodziłyby same na siebie lub byłyby rozciągnięte bardziej, niż tkanina pozwala, są dzielone tam, gdzie najbardziej się zaginają lub są wąskie; fotel zajmuje kilka sekund</translation>
    </message>
    <message>
        <source>Keep its cover &amp;outside of the frame</source>
        <translation>Nie wpuszczaj jego pokr&amp;owca w stelaż</translation>
    </message>
    <message>
        <source>Making the pattern ticks &quot;Keeps the cover outside&quot; at the frame. A cover that is held along its seams alone may sink into the frame or turn inside out.</source>
        <translation>Utworzenie wykroju zaznacza przy stelażu „Nie wpuszcza pokrowca”. Pokrowiec trzymany tylko wzdłuż szwów może zapaść się w stelaż albo wywrócić na lewą stronę.</translation>
    </message>
    <message>
        <source>Patches that this form became before go, with their seams and the curves that hold nothing else. One Undo brings them back.</source>
        <translation>Elementy, które wcześniej powstały z tej formy, znikają, z ich szwami i krzywymi, które nie trzymają nic innego. Jedno Cofnij je przywraca.</translation>
    </message>
    <message>
        <source>The cover as it is</source>
        <translation>Obecny pokrowiec</translation>
    </message>
    <message>
        <source>Choose a form</source>
        <translation>Wybierz formę</translation>
    </message>
    <message>
        <source>New fabric</source>
        <translation>Nowy materiał</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Materiał</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Replace the %n patches of these names</source>
        <translation>
            <numerusform>&amp;Zastąp %n element o tej nazwie</numerusform>
            <numerusform>&amp;Zastąp elementy o tych nazwach (%n)</numerusform>
            <numerusform>&amp;Zastąp elementy o tych nazwach (%n)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>(%n curves that hold them will hold nothing)</source>
        <translation>
            <numerusform>(%n krzywa, która je trzyma, nie będzie trzymać niczego)</numerusform>
            <numerusform>(%n krzywe, które je trzymają, nie będą trzymać niczego)</numerusform>
            <numerusform>(%n krzywych, które je trzymają, nie będzie trzymać niczego)</numerusform>
        </translation>
    </message>
    <message>
        <source>They end inside a piece (marked in the 3D view) and do not divide it: each goes on to the border or line that is nearest, along the way shown there</source>
        <translation>Kończą się wewnątrz kawałka (zaznaczone w widoku 3D) i go nie dzielą: każda idzie dalej pokazaną tam drogą do najbliższego brzegu lub linii</translation>
    </message>
    <message numerus="yes">
        <source>Lead %n open ends &amp;on</source>
        <translation>
            <numerusform>Przedłuż %n &amp;otwarty koniec</numerusform>
            <numerusform>Przedłuż %n &amp;otwarte końce</numerusform>
            <numerusform>Przedłuż %n &amp;otwartych końców</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FoundPiecesView</name>
    <message>
        <source>Pieces in the file</source>
        <translation>Elementy w pliku</translation>
    </message>
    <message>
        <source>There is no piece in it.</source>
        <translation>Nie ma w nim żadnego elementu.</translation>
    </message>
    <message>
        <source>Reading …</source>
        <translation>Odczytywanie…</translation>
    </message>
</context>
<context>
    <name>bolster::GlCanvas</name>
    <message>
        <source>No OpenGL: drawn in software</source>
        <translation>Brak OpenGL: rysowanie programowe</translation>
    </message>
    <message>
        <source>OpenGL is older than 3.3: drawn in software</source>
        <translation>OpenGL starszy niż 3.3: rysowanie programowe</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryModel</name>
    <message>
        <source>Start</source>
        <translation>Początek</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Zmiana</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryPanel</name>
    <message>
        <source>Find a change or a version</source>
        <translation>Znajdź zmianę lub wersję</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historia</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryView</name>
    <message>
        <source>&amp;Go to this version</source>
        <translation>&amp;Przejdź do tej wersji</translation>
    </message>
    <message>
        <source>&amp;Name this version …</source>
        <translation>&amp;Nazwij tę wersję…</translation>
    </message>
    <message>
        <source>&amp;Remove its name</source>
        <translation>&amp;Usuń jej nazwę</translation>
    </message>
    <message>
        <source>&amp;Compare with now …</source>
        <translation>P&amp;orównaj z obecną…</translation>
    </message>
    <message>
        <source>Name of this branch</source>
        <translation>Nazwa tej gałęzi</translation>
    </message>
    <message>
        <source>Name of this version</source>
        <translation>Nazwa tej wersji</translation>
    </message>
    <message>
        <source>Name this &amp;branch …</source>
        <translation>Nazwij tę &amp;gałąź…</translation>
    </message>
</context>
<context>
    <name>bolster::ImportFlow</name>
    <message>
        <source>Frames (%1)</source>
        <translation>Stelaże (%1)</translation>
    </message>
    <message>
        <source>Scans (%1)</source>
        <translation>Skany (%1)</translation>
    </message>
    <message>
        <source>Import frame</source>
        <translation>Importuj stelaż</translation>
    </message>
    <message>
        <source>Import scan</source>
        <translation>Importuj skan</translation>
    </message>
    <message>
        <source>Import pattern</source>
        <translation>Importuj wykrój</translation>
    </message>
    <message>
        <source>Patterns (%1)</source>
        <translation>Wykroje (%1)</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>Wybierz inny plik</translation>
    </message>
    <message>
        <source>The pattern is imported. What is otherwise than in the file:</source>
        <translation>Zaimportowano wykrój. Różnice względem pliku:</translation>
    </message>
    <message>
        <source>Simplifying %1 …</source>
        <translation>Upraszczanie: %1…</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>Zapisywanie: %1…</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be imported.</source>
        <translation>Nie udało się zaimportować „%1”.</translation>
    </message>
</context>
<context>
    <name>bolster::ImportPatternDialog</name>
    <message>
        <source>Import pattern</source>
        <translation>Importuj wykrój</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Elementy</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importuj</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Milimetry</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centymetry</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Cale</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Metry</translation>
    </message>
    <message>
        <source>Sewing lines, with allowances</source>
        <translation>Linie szycia, z naddatkami</translation>
    </message>
    <message>
        <source>Cut lines, without allowance</source>
        <translation>Linie cięcia, bez naddatku</translation>
    </message>
    <message>
        <source>What the outlines of patches become where the file has both lines.</source>
        <translation>Co staje się konturem elementów, gdy plik ma obie linie.</translation>
    </message>
    <message>
        <source>Outlines whose ends are no farther apart are closed by a straight line.</source>
        <translation>Kontury, których końce nie są bardziej oddalone, zamyka linia prosta.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Plik</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>&amp;Jednostka pliku</translation>
    </message>
    <message>
        <source>Largest piece</source>
        <translation>Największy element</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Rozmiar</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>&amp;Kontury</translation>
    </message>
    <message>
        <source>&amp;Close gaps up to</source>
        <translation>&amp;Zamknij przerwy do</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1&#xa0;mm</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>, %n pairs</source>
        <translation>
            <numerusform>, %n para</numerusform>
            <numerusform>, %n pary</numerusform>
            <numerusform>, %n par</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n times</source>
        <translation>
            <numerusform>, %n raz</numerusform>
            <numerusform>, %n razy</numerusform>
            <numerusform>, %n razy</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines lay twice on themselves and are taken once.</source>
        <translation>
            <numerusform>%n linia leżała podwójnie i jest wzięta raz.</numerusform>
            <numerusform>%n linie leżały podwójnie i są wzięte raz.</numerusform>
            <numerusform>%n linii leżało podwójnie i jest wziętych raz.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not read: %1</source>
        <translation>Nieodczytane: %1</translation>
    </message>
    <message>
        <source>The file does not say its unit for certain: look at the measures.</source>
        <translation>Plik nie podaje jednostki na pewno: sprawdź wymiary.</translation>
    </message>
    <message>
        <source>Pixels (1/96 inch)</source>
        <translation>Piksele (1/96 cala)</translation>
    </message>
    <message>
        <source>Points (1/72 inch)</source>
        <translation>Punkty (1/72 cala)</translation>
    </message>
    <message>
        <source>In no piece and left out, by layer: %1</source>
        <translation>Poza elementami i pominięte, według warstw: %1</translation>
    </message>
    <message>
        <source>Marks of grading, stripes or nothing that is known, left out by layer: %1</source>
        <translation>Znaki stopniowania, pasy lub nieznane, pominięte według warstw: %1</translation>
    </message>
    <message>
        <source>%1 has %2 pieces; at most %3 can be imported at once: the first ones are chosen.</source>
        <translation>%1: liczba elementów %2; naraz można zaimportować najwyżej %3: wybrano pierwsze.</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message numerus="yes">
        <source>%n outlines are open: their ends are up to %1 apart. Close gaps up to that, if they are outlines.</source>
        <translation>
            <numerusform>%n kontur jest otwarty: jego końce dzieli do %1. Jeśli to kontur, zamknij przerwy do tej wielkości.</numerusform>
            <numerusform>%n kontury są otwarte: ich końce dzieli do %1. Jeśli to kontury, zamknij przerwy do tej wielkości.</numerusform>
            <numerusform>%n konturów jest otwartych: ich końce dzieli do %1. Jeśli to kontury, zamknij przerwy do tej wielkości.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::JobsPanel</name>
    <message>
        <source>Nothing is being worked at.</source>
        <translation>Nic nie jest wykonywane.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Zatrzymaj</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Zadania</translation>
    </message>
</context>
<context>
    <name>bolster::LeftWork</name>
    <message>
        <source>New design</source>
        <translation>Nowy model</translation>
    </message>
    <message numerus="yes">
        <source>%n more designs are under File &gt; Unsaved work.</source>
        <translation>
            <numerusform>Jeszcze %n model jest w menu Plik &gt; Niezapisana praca.</numerusform>
            <numerusform>Jeszcze %n modele są w menu Plik &gt; Niezapisana praca.</numerusform>
            <numerusform>Jeszcze %n modeli jest w menu Plik &gt; Niezapisana praca.</numerusform>
        </translation>
    </message>
    <message>
        <source>Restoring the work on &quot;%1&quot; …</source>
        <translation>Przywracanie pracy nad „%1”…</translation>
    </message>
    <message>
        <source>The work stays under File &gt; Unsaved work</source>
        <translation>Praca pozostaje w menu Plik &gt; Niezapisana praca</translation>
    </message>
    <message>
        <source>The unsaved work on &quot;%1&quot; could not be restored.</source>
        <translation>Nie udało się przywrócić niezapisanej pracy nad „%1”.</translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved edits restored.</source>
        <translation>
            <numerusform>Przywrócono %n niezapisaną zmianę.</numerusform>
            <numerusform>Przywrócono %n niezapisane zmiany.</numerusform>
            <numerusform>Przywrócono %n niezapisanych zmian.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved edits are in the history, undone or on other branches.</source>
        <translation>
            <numerusform>W historii jest %n niezapisana zmiana, cofnięta lub na innej gałęzi.</numerusform>
            <numerusform>W historii są %n niezapisane zmiany, cofnięte lub na innych gałęziach.</numerusform>
            <numerusform>W historii jest %n niezapisanych zmian, cofniętych lub na innych gałęziach.</numerusform>
        </translation>
    </message>
    <message>
        <source>Unsaved names of versions or branches restored.</source>
        <translation>Przywrócono niezapisane nazwy wersji lub gałęzi.</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Pokaż</translation>
    </message>
    <message>
        <source>Go &amp;back to saved</source>
        <translation>&amp;Wróć do zapisanego</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, %2, damaged</source>
        <translation>%1, %2, uszkodzony</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nic</translation>
    </message>
</context>
<context>
    <name>bolster::MainWindow</name>
    <message>
        <source>Tools</source>
        <translation>Narzędzia</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Komunikaty</translation>
    </message>
    <message>
        <source>%1[*] – Bolster</source>
        <translation>%1[*] – Bolster</translation>
    </message>
    <message>
        <source>%1 It is back where it was.</source>
        <translation>%1 Wrócono do poprzedniego położenia.</translation>
    </message>
    <message>
        <source>More commands</source>
        <translation>Więcej poleceń</translation>
    </message>
    <message>
        <source>The cover sprang by %1.</source>
        <translation>Pokrowiec przeskoczył o %1.</translation>
    </message>
    <message>
        <source>Folded cloth can lie in several ways, and where a drag leaves it depends on the way of the pointer. What you see now follows from the design alone: whoever opens it sees the same, and so do exports and pictures. If you want the other shape, tell the design: hold the cloth there with a handle, or make the piece smaller until it needs no folds.</source>
        <translation>Sfałdowany materiał może ułożyć się na kilka sposobów, a to, jak zostawi go przeciąganie, zależy od drogi wskaźnika. To, co teraz widać, wynika z samego modelu: każdy, kto go otworzy, zobaczy to samo, podobnie eksporty i obrazy. Jeśli chcesz innego kształtu, zapisz to w modelu: przytrzymaj tam materiał krzywą sterującą lub zmniejszaj element, aż fałdy nie będą potrzebne.</translation>
    </message>
    <message>
        <source>%1[*] (read-only) – Bolster</source>
        <translation>%1[*] (tylko do odczytu) – Bolster</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces are in the pattern. Seam &gt; Propose seams finds what belongs together.</source>
        <translation>
            <numerusform>W wykroju jest %n element. Szew &gt; Zaproponuj szwy znajduje, co do siebie należy.</numerusform>
            <numerusform>W wykroju są %n elementy. Szew &gt; Zaproponuj szwy znajduje, co do siebie należy.</numerusform>
            <numerusform>W wykroju jest %n elementów. Szew &gt; Zaproponuj szwy znajduje, co do siebie należy.</numerusform>
        </translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>Bolster is still working at something.</source>
        <translation>Bolster jeszcze nad czymś pracuje.</translation>
    </message>
    <message>
        <source>What is closed now is not finished; files that are being written stay as they were.</source>
        <translation>Co zostanie teraz zamknięte, nie będzie ukończone; zapisywane pliki pozostaną takie, jakie były.</translation>
    </message>
    <message>
        <source>&amp;Stop it and close</source>
        <translation>&amp;Zatrzymaj i zamknij</translation>
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
        <translation>&amp;Cofnij</translation>
    </message>
    <message>
        <source>This change has taken away as well: %1</source>
        <translation>Ta zmiana usunęła także: %1</translation>
    </message>
</context>
<context>
    <name>bolster::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Podręcznik</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Spis treści</translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>Wstecz (Alt+Lewo)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Wstecz</translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation>Dalej (Alt+Prawo)</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Dalej</translation>
    </message>
    <message>
        <source>Find in all pages</source>
        <translation>Szukaj na wszystkich stronach</translation>
    </message>
    <message>
        <source>The manual has no page &quot;%1&quot;.</source>
        <translation>Podręcznik nie ma strony „%1”.</translation>
    </message>
    <message>
        <source>The manual is in English.</source>
        <translation>Podręcznik jest po angielsku.</translation>
    </message>
</context>
<context>
    <name>bolster::MapLegend</name>
    <message>
        <source>over the fabric&apos;s limit</source>
        <translation>powyżej granicy materiału</translation>
    </message>
</context>
<context>
    <name>bolster::MapLink</name>
    <message>
        <source>Largest strain</source>
        <translation>Największe odkształcenie</translation>
    </message>
    <message>
        <source>Strain along the grain</source>
        <translation>Odkształcenie wzdłuż nitki</translation>
    </message>
    <message>
        <source>Strain across the grain</source>
        <translation>Odkształcenie w poprzek nitki</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Ścinanie</translation>
    </message>
    <message>
        <source>Mean curvature</source>
        <translation>Średnia krzywizna</translation>
    </message>
    <message>
        <source>Distance to the frame</source>
        <translation>Odległość od stelaża</translation>
    </message>
    <message>
        <source>hollow</source>
        <translation>wklęsłe</translation>
    </message>
    <message>
        <source>bulging</source>
        <translation>wypukłe</translation>
    </message>
    <message>
        <source>pressed</source>
        <translation>ściśnięte</translation>
    </message>
    <message>
        <source>stretched</source>
        <translation>rozciągnięte</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 w: %2</translation>
    </message>
    <message>
        <source>%1, over the limit of %2</source>
        <translation>%1, powyżej granicy %2</translation>
    </message>
    <message>
        <source>Here: %1</source>
        <translation>Tutaj: %1</translation>
    </message>
    <message>
        <source>over the fabric&apos;s limit</source>
        <translation>powyżej granicy materiału</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>wewnątrz</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>na zewnątrz</translation>
    </message>
    <message>
        <source>Deviation from the scan</source>
        <translation>Odchyłka od skanu</translation>
    </message>
</context>
<context>
    <name>bolster::MarkTool</name>
    <message>
        <source>Hole %1</source>
        <translation>Nawiert %1</translation>
    </message>
    <message>
        <source>Click to select it, drag to move it – its properties say what it is like</source>
        <translation>Kliknij, aby zaznaczyć; przeciągnij, aby przesunąć – reszta jest we właściwościach</translation>
    </message>
    <message>
        <source>Click a corner of an outline to choose how its cut lines are joined – Esc ends the tool</source>
        <translation>Kliknij róg konturu, aby wybrać, jak łączą się jego linie cięcia – Esc kończy</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no distance from the corner on this edge.</source>
        <translation>„%1” nie jest odległością od rogu na tej krawędzi.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no place: try 120, 40</source>
        <translation>„%1” to nie położenie: spróbuj 120, 40</translation>
    </message>
    <message>
        <source>Click an outline to place a notch, or type how far it is from the corner; on a seam the other side gets one, too – Esc ends the tool</source>
        <translation>Kliknij kontur, aby umieścić nacięcie, lub wpisz odległość od rogu; na szwie dostaje je też druga strona – Esc kończy</translation>
    </message>
    <message>
        <source>Click inside a patch to place a drill hole, or type where: 120, 40 – Esc ends the tool</source>
        <translation>Kliknij wewnątrz elementu, aby umieścić nawiert, lub wpisz gdzie: 120, 40 – Esc kończy</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no width of an allowance: try 12</source>
        <translation>„%1” to nie szerokość naddatku: spróbuj 12</translation>
    </message>
    <message>
        <source>Drag its handle, or type its width – its properties say what it is like</source>
        <translation>Przeciągnij uchwyt lub wpisz szerokość – reszta jest we właściwościach</translation>
    </message>
    <message>
        <source>Click an edge to give it a seam allowance of its own, or type its width; drag its handle – Esc ends the tool</source>
        <translation>Kliknij krawędź, aby nadać jej własny naddatek na szew, lub wpisz jego szerokość; przeciągnij uchwyt – Esc kończy</translation>
    </message>
    <message>
        <source>Point at an outline, then type how far the notch is from the corner</source>
        <translation>Wskaż kontur, potem wpisz odległość nacięcia od rogu</translation>
    </message>
    <message>
        <source>Point into a patch, then type where the drill hole lies: 120, 40</source>
        <translation>Wskaż wnętrze elementu, potem wpisz położenie nawiertu: 120, 40</translation>
    </message>
    <message>
        <source>Point at an edge, then type how wide its allowance is</source>
        <translation>Wskaż krawędź, potem wpisz szerokość jej naddatku</translation>
    </message>
</context>
<context>
    <name>bolster::NextStep</name>
    <message>
        <source>Next: %1 for the other side.</source>
        <translation>Następnie: %1 na drugą stronę.</translation>
    </message>
    <message>
        <source>draw a second patch</source>
        <translation>narysuj drugi element</translation>
    </message>
    <message>
        <source>Next: %1 – click an edge, then the edge it is sewn to.</source>
        <translation>Następnie: %1 – kliknij krawędź, potem krawędź, do której ma być przyszyta.</translation>
    </message>
    <message>
        <source>sew the patches</source>
        <translation>zszyj elementy</translation>
    </message>
    <message>
        <source>Next: %1 and give them a pressure in the properties.</source>
        <translation>Następnie: %1 i nadaj im ciśnienie we właściwościach.</translation>
    </message>
    <message>
        <source>select all patches</source>
        <translation>zaznacz wszystkie elementy</translation>
    </message>
    <message>
        <source>Next: %1 – click points on it, Enter ends – to which the cover is attached.</source>
        <translation>Następnie: %1 – klikaj na nim punkty, Enter kończy – do niej mocuje się pokrowiec.</translation>
    </message>
    <message>
        <source>draw a fixation curve on the frame</source>
        <translation>narysuj krzywą mocowania na stelażu</translation>
    </message>
    <message>
        <source>Next: select a fixation curve and %1 to it.</source>
        <translation>Następnie: zaznacz krzywą mocowania i %1.</translation>
    </message>
    <message>
        <source>attach an edge</source>
        <translation>zamocuj do niej krawędź</translation>
    </message>
</context>
<context>
    <name>bolster::NumberBox</name>
    <message>
        <source>varies</source>
        <translation>różne</translation>
    </message>
    <message>
        <source>Not taken: a number is needed</source>
        <translation>Nie przyjęto: wymagana jest liczba</translation>
    </message>
    <message>
        <source>Not taken: &quot;%1&quot; is not a length</source>
        <translation>Nie przyjęto: „%1” nie jest długością</translation>
    </message>
    <message>
        <source>Not taken: &quot;%1&quot; is not a number</source>
        <translation>Nie przyjęto: „%1” nie jest liczbą</translation>
    </message>
    <message>
        <source>Not taken: %1 is too little, at least %2</source>
        <translation>Nie przyjęto: %1 to za mało, co najmniej %2</translation>
    </message>
    <message>
        <source>Not taken: %1 is too much, at most %2</source>
        <translation>Nie przyjęto: %1 to za dużo, najwyżej %2</translation>
    </message>
</context>
<context>
    <name>bolster::OpenFlow</name>
    <message>
        <source>Projects and designs (%1)</source>
        <translation>Projekty i modele (%1)</translation>
    </message>
    <message>
        <source>This is the version where you were last; the one in the file is under File &gt; Revert to saved</source>
        <translation>To wersja, nad którą ostatnio pracowano; wersja z pliku: Plik &gt; Przywróć zapisane</translation>
    </message>
    <message>
        <source>Open project or design</source>
        <translation>Otwórz projekt lub model</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open in another window.</source>
        <translation>„%1” jest otwarty w innym oknie.</translation>
    </message>
    <message>
        <source>It can be opened here to look at; what is changed is saved under another name.</source>
        <translation>Można go tu otworzyć do obejrzenia; zmiany zapisuje się pod inną nazwą.</translation>
    </message>
    <message numerus="yes">
        <source>%n elements cannot be used as they are; everything else works.</source>
        <translation>
            <numerusform>%n obiektu nie można użyć w tej postaci; wszystko inne działa.</numerusform>
            <numerusform>%n obiektów nie można użyć w tej postaci; wszystko inne działa.</numerusform>
            <numerusform>%n obiektów nie można użyć w tej postaci; wszystko inne działa.</numerusform>
        </translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Pokaż</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Jeszcze nic</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>&amp;Wyczyść listę</translation>
    </message>
    <message>
        <source>The samples are not installed</source>
        <translation>Przykłady nie są zainstalowane</translation>
    </message>
</context>
<context>
    <name>bolster::PagesView</name>
    <message>
        <source>Pages</source>
        <translation>Strony</translation>
    </message>
</context>
<context>
    <name>bolster::PartsTree</name>
    <message>
        <source>Part</source>
        <translation>Część</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Trójkąty</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Części</translation>
    </message>
</context>
<context>
    <name>bolster::PatternCommands</name>
    <message>
        <source>This stretch is straight already.</source>
        <translation>Ten odcinek jest już prosty.</translation>
    </message>
    <message>
        <source>They are equally long already.</source>
        <translation>Mają już równą długość.</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Wy&amp;tnij</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiuj</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Wklej</translation>
    </message>
    <message>
        <source>Dupl&amp;icate</source>
        <translation>Powi&amp;el</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>&amp;Rozmieść</translation>
    </message>
    <message>
        <source>Turn 90° to the &amp;left</source>
        <translation>Obróć o 90° w &amp;lewo</translation>
    </message>
    <message>
        <source>Turn 90° to the &amp;right</source>
        <translation>Obróć o 90° w &amp;prawo</translation>
    </message>
    <message>
        <source>Mirror hori&amp;zontally</source>
        <translation>Odbij w pozio&amp;mie</translation>
    </message>
    <message>
        <source>Mirror &amp;vertically</source>
        <translation>Odbij w pio&amp;nie</translation>
    </message>
    <message>
        <source>Al&amp;ign</source>
        <translation>W&amp;yrównaj</translation>
    </message>
    <message>
        <source>&amp;Left edges</source>
        <translation>&amp;Lewe krawędzie</translation>
    </message>
    <message>
        <source>Centres in a &amp;column</source>
        <translation>Środki w &amp;kolumnie</translation>
    </message>
    <message>
        <source>&amp;Right edges</source>
        <translation>&amp;Prawe krawędzie</translation>
    </message>
    <message>
        <source>&amp;Top edges</source>
        <translation>&amp;Górne krawędzie</translation>
    </message>
    <message>
        <source>Centres in a ro&amp;w</source>
        <translation>Środki w &amp;rzędzie</translation>
    </message>
    <message>
        <source>&amp;Bottom edges</source>
        <translation>&amp;Dolne krawędzie</translation>
    </message>
    <message>
        <source>&amp;Distribute</source>
        <translation>Ro&amp;złóż</translation>
    </message>
    <message>
        <source>&amp;Horizontally</source>
        <translation>&amp;Poziomo</translation>
    </message>
    <message>
        <source>&amp;Vertically</source>
        <translation>Pio&amp;nowo</translation>
    </message>
    <message>
        <source>Arrange &amp;automatically</source>
        <translation>Rozmieść &amp;automatycznie</translation>
    </message>
    <message>
        <source>Poin&amp;ts and edges</source>
        <translation>Punkt&amp;y i krawędzie</translation>
    </message>
    <message>
        <source>Make &amp;corner</source>
        <translation>Utwórz &amp;róg</translation>
    </message>
    <message>
        <source>Make s&amp;mooth</source>
        <translation>Wy&amp;gładź</translation>
    </message>
    <message>
        <source>Strai&amp;ghten</source>
        <translation>Wypro&amp;stuj</translation>
    </message>
    <message>
        <source>Edge &amp;length …</source>
        <translation>&amp;Długość krawędzi…</translation>
    </message>
    <message>
        <source>Type the length of the selected edge</source>
        <translation>Wpisz długość zaznaczonej krawędzi</translation>
    </message>
    <message>
        <source>Make e&amp;qually long</source>
        <translation>&amp;Zrównaj długości</translation>
    </message>
    <message>
        <source>Makes the selected edges as long as the first one, or the second side of a seam as long as its first</source>
        <translation>Nadaje zaznaczonym krawędziom długość pierwszej lub drugiej stronie szwu długość pierwszej</translation>
    </message>
    <message>
        <source>Mirror twi&amp;ns</source>
        <translation>L&amp;ustrzane bliźniaki</translation>
    </message>
    <message>
        <source>Merge a&amp;long seam</source>
        <translation>S&amp;cal wzdłuż szwu</translation>
    </message>
    <message>
        <source>Smooth &amp;across seam ends</source>
        <translation>Wygładź na końcac&amp;h szwów</translation>
    </message>
    <message>
        <source>Outlines go on without a kink from one patch to the other where the selected seams end, when both sides lie together</source>
        <translation>Tam, gdzie kończą się zaznaczone szwy, kontury przechodzą bez załamania z elementu na element, gdy obie strony leżą razem</translation>
    </message>
    <message>
        <source>They go on without a kink already.</source>
        <translation>Przechodzą już bez załamania.</translation>
    </message>
</context>
<context>
    <name>bolster::PatternFitWindow</name>
    <message>
        <source>&amp;Take the changes</source>
        <translation>&amp;Przejmij zmiany</translation>
    </message>
    <message>
        <source>Changes of</source>
        <translation>Zmiany</translation>
    </message>
    <message>
        <source>Moves by</source>
        <translation>Przesuwa się o</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Zmiany</translation>
    </message>
    <message>
        <source>What is ticked is changed</source>
        <translation>Zmieniane jest to, co zaznaczono</translation>
    </message>
    <message>
        <source>&amp;How much of it</source>
        <translation>&amp;Ile z tego</translation>
    </message>
    <message>
        <source>Solving the cover …</source>
        <translation>Obliczanie pokrowca…</translation>
    </message>
    <message>
        <source>Stopped; nothing has changed.</source>
        <translation>Zatrzymano; nic się nie zmieniło.</translation>
    </message>
    <message>
        <source>&amp;Find changes</source>
        <translation>Z&amp;najdź zmiany</translation>
    </message>
    <message>
        <source>The cover moves by %1 (rms).</source>
        <translation>Pokrowiec przesuwa się o %1 (RMS).</translation>
    </message>
    <message>
        <source>On the way a fold came or went: look at the cover before you take it.</source>
        <translation>Po drodze powstała lub znikła fałda: obejrzyj pokrowiec, zanim przejmiesz zmiany.</translation>
    </message>
    <message numerus="yes">
        <source>%n of the numbers that may change do nothing here.</source>
        <translation>
            <numerusform>%n z liczb, które mogą się zmienić, nic tu nie daje.</numerusform>
            <numerusform>%n z liczb, które mogą się zmienić, nic tu nie dają.</numerusform>
            <numerusform>%n z liczb, które mogą się zmienić, nic tu nie daje.</numerusform>
        </translation>
    </message>
    <message>
        <source>Arrows in the pattern: %1 times as long as the way</source>
        <translation>Strzałki w wykroju: %1 razy dłuższe niż droga</translation>
    </message>
    <message>
        <source>Arrows in the pattern: where its outlines go</source>
        <translation>Strzałki w wykroju: dokąd przesuwają się kontury</translation>
    </message>
    <message>
        <source>Taken. Undo takes it back.</source>
        <translation>Przejęto. Cofnij to odwraca.</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: find the changes again.</source>
        <translation>Model się tymczasem zmienił: znajdź zmiany ponownie.</translation>
    </message>
    <message>
        <source>With all of the changes:</source>
        <translation>Ze wszystkimi zmianami:</translation>
    </message>
    <message>
        <source>Fitting the pattern …</source>
        <translation>Dopasowywanie wykroju…</translation>
    </message>
    <message>
        <source>Changing the pattern …</source>
        <translation>Zmienianie wykroju…</translation>
    </message>
    <message>
        <source>Pressed together: %1 before, %2 now</source>
        <translation>Ściśnięte: %1 przedtem, %2 teraz</translation>
    </message>
    <message>
        <source>From the curve: %1 before, %2 now (rms)</source>
        <translation>Od krzywej: %1 przedtem, %2 teraz (RMS)</translation>
    </message>
    <message>
        <source>Off the area that is wanted: %1 before, %2 now</source>
        <translation>Odchyłka od żądanej powierzchni: %1 przedtem, %2 teraz</translation>
    </message>
    <message>
        <source>Nothing is over the limits: there is nothing to do.</source>
        <translation>Nic nie przekracza granic: nie ma nic do zrobienia.</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit (before: %2), on few triangles at first</source>
        <translation>%1 pokrowca powyżej granicy (przedtem: %2), najpierw na niewielu trójkątach</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit (before: %2)</source>
        <translation>%1 pokrowca powyżej granicy (przedtem: %2)</translation>
    </message>
    <message>
        <source>With what is shown of the changes the cover cannot be solved.</source>
        <translation>Z pokazaną częścią zmian nie można obliczyć pokrowca.</translation>
    </message>
    <message>
        <source>With what is shown of the changes:</source>
        <translation>Z pokazaną częścią zmian:</translation>
    </message>
    <message>
        <source>Nothing of the changes is shown now: move the slider to see them.</source>
        <translation>Teraz nie widać żadnej ze zmian: przesuń suwak, aby je zobaczyć.</translation>
    </message>
    <message>
        <source>Sides of seams differ by up to %1 more than is wanted: change their neighbours, too, or let the ease change.</source>
        <translation>Boki szwów różnią się o nawet %1 bardziej, niż trzeba: proszę zmienić też sąsiednie elementy albo pozwolić na zmianę wdania.</translation>
    </message>
    <message>
        <source>Strained over the limit: %1 of the painted area before, %2 now</source>
        <translation>Odkształcone ponad granicę: przedtem %1 zamalowanego obszaru, teraz %2</translation>
    </message>
    <message>
        <source>Strained over the limit: %1 of the cover before, %2 now</source>
        <translation>Odkształcone ponad granicę: przedtem %1 pokrowca, teraz %2</translation>
    </message>
    <message>
        <source>That is hardly nearer, and strains the cloth more: let something else change, or less of it.</source>
        <translation>To prawie nie zbliża, a bardziej odkształca tkaninę: proszę pozwolić zmienić się czemuś innemu albo mniej.</translation>
    </message>
    <message>
        <source>Stopped. What was found until then makes it no better: nothing has changed.</source>
        <translation>Zatrzymano. To, co dotąd znaleziono, niczego nie poprawia: nic się nie zmieniło.</translation>
    </message>
    <message>
        <source>Stopped. With all of the changes that were found until then, measured anew on all triangles:</source>
        <translation>Zatrzymano. Ze wszystkimi zmianami znalezionymi do tej chwili, zmierzonymi na nowo na wszystkich trójkątach:</translation>
    </message>
    <message>
        <source>Sides of seams off their ease: up to %1 before, %2 now</source>
        <translation>Boki szwów poza swoim wdaniem: do %1 przedtem, %2 teraz</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Over the fabrics&apos; limits: %1 of the cover before, %2 now</source>
        <translation>Powyżej granic materiałów: przedtem %1 pokrowca, teraz %2</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: find the changes again, or undo that.</source>
        <translation>Model się tymczasem zmienił: znajdź zmiany ponownie albo to cofnij.</translation>
    </message>
    <message>
        <source>Taken back. Move the slider to see the changes again.</source>
        <translation>Cofnięto. Przesuń suwak, aby znów zobaczyć zmiany.</translation>
    </message>
    <message>
        <source>That is hardly nearer to the limit: let something else change, or more of it.</source>
        <translation>To prawie nie jest bliżej granicy: pozwól zmienić się czemuś innemu albo bardziej.</translation>
    </message>
    <message>
        <source>%1 from %3 (rms; before: %2), on few triangles at first</source>
        <translation>%1 od %3 (RMS; przedtem: %2), najpierw na niewielu trójkątach</translation>
    </message>
    <message>
        <source>%1 from %3 (rms; before: %2)</source>
        <translation>%1 od %3 (RMS; przedtem: %2)</translation>
    </message>
    <message>
        <source>From %5: %1 before, %2 now (rms); %3 before, %4 now (95 %)</source>
        <translation>Odległość od %5: %1 przedtem, %2 teraz (RMS); %3 przedtem, %4 teraz (95%)</translation>
    </message>
    <message>
        <source>That is hardly nearer to %1: let something else change, or more of it.</source>
        <translation>To prawie nie jest bliżej %1: pozwól zmienić się czemuś innemu albo bardziej.</translation>
    </message>
    <message>
        <source>Hardly less is pressed together: let something else change, or more of it.</source>
        <translation>Ściśniętych miejsc prawie nie jest mniej: pozwól zmienić się czemuś innemu albo bardziej.</translation>
    </message>
    <message>
        <source>That is hardly nearer to the curve: let something else change, or more of it.</source>
        <translation>To prawie nie jest bliżej krzywej: pozwól zmienić się czemuś innemu albo bardziej.</translation>
    </message>
    <message>
        <source>That is hardly nearer to the area that is wanted: let something else change, or more of it.</source>
        <translation>To prawie nie jest bliżej żądanego pola: pozwól zmienić się czemuś innemu albo bardziej.</translation>
    </message>
    <message>
        <source>Changes the pattern until the cover is as it is wished: tick one goal or several, and what may change.</source>
        <translation>Zmienia szablon, aż pokrowiec będzie taki, jak trzeba: zaznacz jeden lub kilka celów i to, co może się zmienić.</translation>
    </message>
    <message>
        <source>%1 of the painted area is over the limit (before: %2), on few triangles at first</source>
        <translation>%1 zamalowanego obszaru powyżej granicy (przedtem: %2), najpierw na niewielu trójkątach</translation>
    </message>
    <message>
        <source>%1 of the painted area is over the limit (before: %2)</source>
        <translation>%1 zamalowanego obszaru powyżej granicy (przedtem: %2)</translation>
    </message>
    <message>
        <source>No change makes it better on all triangles: let something else change, or points move farther.</source>
        <translation>Żadna zmiana nie poprawia tego na wszystkich trójkątach: pozwól zmienić się czemuś innemu albo punktom przesunąć się dalej.</translation>
    </message>
    <message>
        <source>More of the cloth is strained over its limits: make these a goal, too, or let points move less.</source>
        <translation>Więcej tkaniny jest rozciągnięte ponad jej granice: uczyń je także celem albo pozwól punktom przesuwać się mniej.</translation>
    </message>
    <message>
        <source>What is wished</source>
        <translation>Czego się oczekuje</translation>
    </message>
    <message>
        <source>Fit to a goal</source>
        <translation>Dopasuj do celu</translation>
    </message>
</context>
<context>
    <name>bolster::PatternRuler</name>
    <message>
        <source>Drag down for a level guide. Marks move upright guides; drag them off to remove them.</source>
        <translation>Przeciągnij w dół, aby utworzyć poziomą prowadnicę. Znaczniki przesuwają pionowe prowadnice; wyciągnięte znikają.</translation>
    </message>
    <message>
        <source>Drag to the right for an upright guide. Marks move level guides; drag them off to remove them.</source>
        <translation>Przeciągnij w prawo, aby utworzyć pionową prowadnicę. Znaczniki przesuwają poziome prowadnice; wyciągnięte znikają.</translation>
    </message>
</context>
<context>
    <name>bolster::PreferencesWindow</name>
    <message>
        <source>Preferences (*.json)</source>
        <translation>Preferencje (*.json)</translation>
    </message>
    <message>
        <source>No setting has these words.</source>
        <translation>Żadne ustawienie nie zawiera tych słów.</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Preferencje</translation>
    </message>
    <message>
        <source>Find a setting</source>
        <translation>Znajdź ustawienie</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Strony</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ustawienia</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Wybierz…</translation>
    </message>
    <message>
        <source>&amp;Edit single shortcuts …</source>
        <translation>&amp;Edytuj poszczególne skróty…</translation>
    </message>
    <message>
        <source>Back to &amp;defaults</source>
        <translation>Przywróć &amp;domyślne</translation>
    </message>
    <message>
        <source>All settings of this page</source>
        <translation>Wszystkie ustawienia tej strony</translation>
    </message>
    <message>
        <source>E&amp;xport …</source>
        <translation>E&amp;ksportuj…</translation>
    </message>
    <message>
        <source>&amp;Import …</source>
        <translation>&amp;Importuj…</translation>
    </message>
    <message>
        <source>Export preferences</source>
        <translation>Eksportuj preferencje</translation>
    </message>
    <message>
        <source>Bolster preferences.json</source>
        <translation>Preferencje Bolstera.json</translation>
    </message>
    <message>
        <source>Import preferences</source>
        <translation>Importuj preferencje</translation>
    </message>
    <message>
        <source>The preferences could not be exported.</source>
        <translation>Nie udało się wyeksportować preferencji.</translation>
    </message>
    <message>
        <source>Nothing was imported from &quot;%1&quot;; all settings are as they were.</source>
        <translation>Nic nie zaimportowano z „%1”; wszystkie ustawienia są, jakie były.</translation>
    </message>
    <message>
        <source>The preferences were imported.</source>
        <translation>Zaimportowano preferencje.</translation>
    </message>
    <message numerus="yes">
        <source>This version of Bolster does not know %n of them: %1</source>
        <translation>
            <numerusform>Ta wersja Bolstera nie zna %n z nich: %1</numerusform>
            <numerusform>Ta wersja Bolstera nie zna %n z nich: %1</numerusform>
            <numerusform>Ta wersja Bolstera nie zna %n z nich: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Obróć widok</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Przesuń widok</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Powiększ</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>W widoku 3D</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>W wykroju</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no folder on this machine: the folder of your fabrics stays what it was.</source>
        <translation>„%1” nie jest folderem na tym komputerze: folder materiałów pozostaje bez zmian.</translation>
    </message>
    <message>
        <source>&amp;Restart now</source>
        <translation>&amp;Uruchom ponownie teraz</translation>
    </message>
    <message>
        <source>Closes Bolster, and asks about unsaved work as always; then it starts again with the same project</source>
        <translation>Zamyka Bolster, pytając jak zawsze o niezapisaną pracę, a potem uruchamia go ponownie z tym samym projektem</translation>
    </message>
</context>
<context>
    <name>bolster::ProblemsView</name>
    <message>
        <source>F1: what it means, and what to do</source>
        <translation>F1: co to znaczy i co zrobić</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Nothing to worry about.</source>
        <translation>Nie ma się czym martwić.</translation>
    </message>
    <message>
        <source>All elements can be used.</source>
        <translation>Wszystkie elementy nadają się do użycia.</translation>
    </message>
</context>
<context>
    <name>bolster::PullNote</name>
    <message>
        <source>The cover in the 3D view is pulled to a scan; here it counts as the pattern alone makes it.</source>
        <translation>Pokrowiec w widoku 3D jest przyciągany do skanu; tutaj liczy się taki, jaki daje sam wykrój.</translation>
    </message>
    <message>
        <source>No scan pulls at the cover any more (a step in the history).</source>
        <translation>Żaden skan nie przyciąga już pokrowca (jeden krok historii).</translation>
    </message>
    <message>
        <source>Switch the pull off</source>
        <translation>Wyłącz przyciąganie</translation>
    </message>
    <message>
        <source>Pull again</source>
        <translation>Przyciągaj znów</translation>
    </message>
</context>
<context>
    <name>bolster::ReliefWindow</name>
    <message>
        <source>Relieve strain</source>
        <translation>Zmniejsz odkształcenia</translation>
    </message>
    <message>
        <source>&amp;Look for changes</source>
        <translation>&amp;Szukaj zmian</translation>
    </message>
    <message>
        <source>Looking for what relieves strain …</source>
        <translation>Szukanie zmian zmniejszających odkształcenia…</translation>
    </message>
    <message>
        <source>Where cloth is strained or pressed together more than it may be, changes of the pattern are tried, and the best are solved.</source>
        <translation>Gdzie materiał jest odkształcony lub ściśnięty bardziej, niż wolno, próbowane są zmiany wykroju, a najlepsze są obliczane.</translation>
    </message>
    <message>
        <source>Proposed changes</source>
        <translation>Proponowane zmiany</translation>
    </message>
    <message>
        <source>Strain is at &amp;most</source>
        <translation>&amp;Odkształcenie najwyżej</translation>
    </message>
    <message>
        <source>Else the limits of the fabrics count</source>
        <translation>W przeciwnym razie obowiązują granice materiałów</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Limit of strain</source>
        <translation>Granica odkształcenia</translation>
    </message>
    <message>
        <source>Edges move &amp;by at most</source>
        <translation>&amp;Krawędzie przesuwają się najwyżej o</translation>
    </message>
    <message>
        <source>Trying changes …</source>
        <translation>Próbowanie zmian…</translation>
    </message>
    <message>
        <source>Stopped; nothing has changed.</source>
        <translation>Zatrzymano; nic się nie zmieniło.</translation>
    </message>
    <message>
        <source>Nothing is strained over the limit.</source>
        <translation>Nic nie jest odkształcone powyżej granicy.</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit. No change relieves it.</source>
        <translation>%1 pokrowca powyżej granicy. Żadna zmiana tego nie zmniejsza.</translation>
    </message>
    <message>
        <source>Each is solved by itself; &quot;Make it&quot; is one step that Undo takes back.</source>
        <translation>Każda jest obliczona osobno; „Wykonaj” to jeden krok, który można cofnąć.</translation>
    </message>
    <message>
        <source>As it is now</source>
        <translation>Jak jest teraz</translation>
    </message>
    <message>
        <source>Sewn: %1 more</source>
        <translation>Szycie: o %1 więcej</translation>
    </message>
    <message>
        <source>Sides of seams differ by %1 more</source>
        <translation>Strony szwów różnią się o %1 więcej</translation>
    </message>
    <message>
        <source>Outlines change by %1</source>
        <translation>Kontury zmieniają się o %1</translation>
    </message>
    <message>
        <source>Show where</source>
        <translation>Pokaż gdzie</translation>
    </message>
    <message>
        <source>Make it</source>
        <translation>Wykonaj</translation>
    </message>
    <message>
        <source>Make it: %1</source>
        <translation>Wykonaj: %1</translation>
    </message>
    <message>
        <source>Made. Undo takes it back; look again to see what helps now.</source>
        <translation>Wykonano. Można to cofnąć; szukaj ponownie, aby zobaczyć, co teraz pomoże.</translation>
    </message>
    <message>
        <source>Stopped. These are solved:</source>
        <translation>Zatrzymano. Te są obliczone:</translation>
    </message>
    <message>
        <source>The best changes are being solved …</source>
        <translation>Obliczanie najlepszych zmian…</translation>
    </message>
    <message>
        <source>Hardly anything is over the limit: there is little to gain. &quot;Make it&quot; is one step that Undo takes back.</source>
        <translation>Prawie nic nie przekracza granicy: niewiele można zyskać. „Wykonaj” to jeden krok, który można cofnąć.</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit, by %2 (rms of all of it).</source>
        <translation>%1 pokrowca powyżej granicy, o %2 (RMS na całym pokrowcu).</translation>
    </message>
    <message>
        <source>Over the limit: %1 of the cover, then %2</source>
        <translation>Powyżej granicy: %1 pokrowca, potem %2</translation>
    </message>
    <message>
        <source>Strain over it (rms): %1, then %2</source>
        <translation>Odkształcenie powyżej niej (RMS): %1, potem %2</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: look again, or undo that.</source>
        <translation>Model się tymczasem zmienił: szukaj ponownie albo to cofnij.</translation>
    </message>
    <message>
        <source>The cover moves by %1 (rms).</source>
        <translation>Pokrowiec przesuwa się o %1 (RMS).</translation>
    </message>
    <message>
        <source>From %1 (rms): %2, then %3</source>
        <translation>Odległość od %1 (RMS): %2, potem %3</translation>
    </message>
</context>
<context>
    <name>bolster::RenderDialog</name>
    <message>
        <source>Render</source>
        <translation>Renderowanie</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>As in the window</source>
        <translation>Jak w oknie</translation>
    </message>
    <message>
        <source>Three-quarter</source>
        <translation>Ukośnie z przodu</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Z przodu</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Z tyłu</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Z lewej</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Z prawej</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Z góry</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Robocza</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Dobra</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Najlepsza</translation>
    </message>
    <message>
        <source>How often each pixel is looked at</source>
        <translation>Ile razy badany jest każdy piksel</translation>
    </message>
    <message>
        <source>Transparent &amp;background</source>
        <translation>&amp;Przezroczyste tło</translation>
    </message>
    <message>
        <source>The shadow on the ground is kept</source>
        <translation>Cień na podłożu pozostaje</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Rozmiar:</translation>
    </message>
    <message>
        <source>&amp;View:</source>
        <translation>&amp;Widok:</translation>
    </message>
    <message>
        <source>Sho&amp;w:</source>
        <translation>P&amp;okaż:</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>&amp;Jakość:</translation>
    </message>
    <message>
        <source>Drawing …</source>
        <translation>Rysowanie…</translation>
    </message>
    <message>
        <source>&amp;Render …</source>
        <translation>R&amp;enderuj…</translation>
    </message>
    <message>
        <source>The fabrics as in the window</source>
        <translation>Materiały jak w oknie</translation>
    </message>
    <message>
        <source>Colourway %1</source>
        <translation>Wariant kolorystyczny %1</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>Szachownica</translation>
    </message>
    <message>
        <source>At most %1 million pixels are drawn; choose a smaller size.</source>
        <translation>Rysowane jest najwyżej %1&#xa0;mln pikseli; wybierz mniejszy rozmiar.</translation>
    </message>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation>Nie można zapisać obrazu: %1</translation>
    </message>
    <message>
        <source>Render to</source>
        <translation>Renderuj do</translation>
    </message>
    <message>
        <source>PNG, 8 bits (*.png);;TIFF, 16 bits (*.tif *.tiff);;OpenEXR, linear light (*.exr)</source>
        <translation>PNG, 8 bitów (*.png);;TIFF, 16 bitów (*.tif *.tiff);;OpenEXR, światło liniowe (*.exr)</translation>
    </message>
    <message>
        <source>The name must end in .png, .tif or .exr.</source>
        <translation>Nazwa musi kończyć się na .png, .tif lub .exr.</translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>Anulowano; niczego nie zapisano.</translation>
    </message>
    <message>
        <source>one picture</source>
        <translation>jeden obraz</translation>
    </message>
    <message>
        <source> pictures</source>
        <translation> szt.</translation>
    </message>
    <message>
        <source>So many pictures from all around, with numbers in their names</source>
        <translation>Tyle obrazów dookoła, z numerami w nazwach</translation>
    </message>
    <message>
        <source>&amp;Around the cover:</source>
        <translation>O&amp;brazy wokół pokrowca:</translation>
    </message>
    <message>
        <source>All colourways on a sheet</source>
        <translation>Wszystkie warianty na arkuszu</translation>
    </message>
    <message>
        <source>Map: %1</source>
        <translation>Mapa: %1</translation>
    </message>
    <message>
        <source>&amp;Frame and foam</source>
        <translation>&amp;Stelaż i pianka</translation>
    </message>
    <message>
        <source>In the materials that their properties say</source>
        <translation>W tworzywach podanych we właściwościach</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Zamknij</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Anuluj</translation>
    </message>
    <message>
        <source>The picture is written: %1</source>
        <translation>Zapisano obraz: %1</translation>
    </message>
    <message>
        <source>Open its folder</source>
        <translation>Otwórz folder</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Podgląd</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Szerokość</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Wysokość</translation>
    </message>
    <message>
        <source>What was made</source>
        <translation>Wynik</translation>
    </message>
    <message>
        <source>Drawing %1 …</source>
        <translation>Rysowanie: %1…</translation>
    </message>
</context>
<context>
    <name>bolster::ReportDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>Zgłoś problem</translation>
    </message>
    <message>
        <source>What did you do, what happened, and what should have happened?</source>
        <translation>Co zostało zrobione, co się stało i co powinno było się stać?</translation>
    </message>
    <message>
        <source>&amp;What happened:</source>
        <translation>&amp;Co się stało:</translation>
    </message>
    <message>
        <source>&amp;Add the design (&quot;%1&quot;), without its frames, scans and pictures</source>
        <translation>&amp;Dodaj model („%1”), bez jego stelaży, skanów i obrazów</translation>
    </message>
    <message>
        <source>What the &amp;report says besides:</source>
        <translation>Co jeszcze zawiera &amp;zgłoszenie:</translation>
    </message>
    <message>
        <source>Write the report …</source>
        <translation>Zapisz zgłoszenie…</translation>
    </message>
    <message>
        <source>This writes a file that you can give to those who can help. Bolster sends nothing.</source>
        <translation>Zapisuje to plik, który możesz dać tym, którzy mogą pomóc. Bolster niczego nie wysyła.</translation>
    </message>
    <message>
        <source>not known yet</source>
        <translation>jeszcze nieznane</translation>
    </message>
    <message>
        <source>Messages of this run:</source>
        <translation>Komunikaty tej sesji:</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(brak)</translation>
    </message>
    <message>
        <source>The last crash:</source>
        <translation>Ostatnia awaria:</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Zapisz zgłoszenie</translation>
    </message>
    <message>
        <source>ZIP (*.zip)</source>
        <translation>ZIP (*.zip)</translation>
    </message>
    <message>
        <source>The report is written: %1</source>
        <translation>Zapisano zgłoszenie: %1</translation>
    </message>
    <message>
        <source>The report could not be written: %1</source>
        <translation>Nie udało się zapisać zgłoszenia: %1</translation>
    </message>
</context>
<context>
    <name>bolster::Rescue</name>
    <message>
        <source>%1 (recovered)</source>
        <translation>%1 (uratowany)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be opened.</source>
        <translation>Nie udało się otworzyć „%1”.</translation>
    </message>
    <message>
        <source>What can be read goes into a new project beside it. This file stays as it is.</source>
        <translation>Co da się odczytać, trafi do nowego projektu obok. Ten plik pozostaje bez zmian.</translation>
    </message>
    <message>
        <source>&amp;Recover what can be read</source>
        <translation>&amp;Uratuj, co da się odczytać</translation>
    </message>
    <message>
        <source>Recovering &quot;%1&quot; …</source>
        <translation>Ratowanie „%1”…</translation>
    </message>
    <message>
        <source>Nothing could be recovered.</source>
        <translation>Nic nie dało się uratować.</translation>
    </message>
    <message>
        <source>What could be read is in &quot;%1&quot; now.</source>
        <translation>Co dało się odczytać, jest teraz w „%1”.</translation>
    </message>
    <message>
        <source>The unsaved work on &quot;%1&quot; is damaged.</source>
        <translation>Niezapisana praca nad „%1” jest uszkodzona.</translation>
    </message>
    <message numerus="yes">
        <source>What can be read goes into a new project. What you do not want any more is deleted %n days after it was put into the bin.</source>
        <translation>
            <numerusform>Co da się odczytać, trafi do nowego projektu. Czego już nie chcesz, zostaje usunięte %n dzień po włożeniu do kosza.</numerusform>
            <numerusform>Co da się odczytać, trafi do nowego projektu. Czego już nie chcesz, zostaje usunięte %n dni po włożeniu do kosza.</numerusform>
            <numerusform>Co da się odczytać, trafi do nowego projektu. Czego już nie chcesz, zostaje usunięte %n dni po włożeniu do kosza.</numerusform>
        </translation>
    </message>
    <message>
        <source>Put it into the &amp;bin</source>
        <translation>Przenieś do &amp;kosza</translation>
    </message>
    <message>
        <source>The damaged work is kept under File &gt; Unsaved work</source>
        <translation>Uszkodzona praca jest zachowana w menu Plik &gt; Niezapisana praca</translation>
    </message>
    <message>
        <source>What could be read of it is in &quot;%1&quot; now.</source>
        <translation>Co dało się z niej odczytać, jest teraz w „%1”.</translation>
    </message>
    <message>
        <source>Nothing of it could be read.</source>
        <translation>Nic nie dało się z niej odczytać.</translation>
    </message>
    <message>
        <source>Nothing that was saved is concerned. The damaged work is kept under File &gt; Unsaved work.</source>
        <translation>Nie dotyczy to niczego, co zapisano. Uszkodzona praca pozostaje w menu Plik &gt; Niezapisana praca.</translation>
    </message>
    <message>
        <source>Open what was &amp;recovered</source>
        <translation>Otwórz &amp;uratowane</translation>
    </message>
    <message>
        <source>Looking for what can be read in &quot;%1&quot; …</source>
        <translation>Szukanie tego, co można odczytać w „%1”…</translation>
    </message>
</context>
<context>
    <name>bolster::RunRow</name>
    <message>
        <source>&amp;Stop</source>
        <translation>Za&amp;trzymaj</translation>
    </message>
</context>
<context>
    <name>bolster::SaveFlow</name>
    <message>
        <source>Project with its history (*.bolster);;Design as text (*.json)</source>
        <translation>Projekt z historią (*.bolster);;Model jako tekst (*.json)</translation>
    </message>
    <message numerus="yes">
        <source>%n edits</source>
        <translation>
            <numerusform>%n zmiana</numerusform>
            <numerusform>%n zmiany</numerusform>
            <numerusform>%n zmian</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edits that were undone or are on other branches</source>
        <translation>
            <numerusform>%n zmiana cofnięta lub na innej gałęzi</numerusform>
            <numerusform>%n zmiany cofnięte lub na innych gałęziach</numerusform>
            <numerusform>%n zmian cofniętych lub na innych gałęziach</numerusform>
        </translation>
    </message>
    <message>
        <source>names of versions or branches</source>
        <translation>nazwy wersji lub gałęzi</translation>
    </message>
    <message>
        <source>The file holds another version of the design than the one you see.</source>
        <translation>Plik zawiera inną wersję modelu niż widoczna.</translation>
    </message>
    <message>
        <source>Not saved yet: %1.</source>
        <translation>Jeszcze niezapisane: %1.</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>Zapisz kopię</translation>
    </message>
    <message>
        <source>-copy</source>
        <translation>-kopia</translation>
    </message>
    <message>
        <source>Project (*.%1)</source>
        <translation>Projekt (*.%1)</translation>
    </message>
    <message>
        <source>Save the changes in &quot;%1&quot;?</source>
        <translation>Zapisać zmiany w „%1”?</translation>
    </message>
    <message>
        <source>A design as text cannot hold that, a project can.</source>
        <translation>Model jako tekst nie może tego pomieścić, projekt może.</translation>
    </message>
    <message>
        <source>Work that is kept for later, with all its steps, is under File &gt; Unsaved work.</source>
        <translation>Praca zachowana na później, ze wszystkimi krokami, jest w menu Plik &gt; Niezapisana praca.</translation>
    </message>
    <message>
        <source>Save as &amp;project …</source>
        <translation>Zapisz jako &amp;projekt…</translation>
    </message>
    <message>
        <source>&amp;Keep for later</source>
        <translation>Za&amp;chowaj na później</translation>
    </message>
    <message>
        <source>The work cannot be kept.</source>
        <translation>Pracy nie można zachować.</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Zapisz projekt</translation>
    </message>
    <message>
        <source>Saved a copy as %1</source>
        <translation>Zapisano kopię jako %1</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Zapisano jako %1</translation>
    </message>
    <message>
        <source>%1: the design alone, without its history</source>
        <translation>%1: sam model, bez historii</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the file any more that was opened or saved here.</source>
        <translation>„%1” nie jest już plikiem, który tu otwarto lub zapisano.</translation>
    </message>
    <message>
        <source>Save your design under another name, or let what is there now have another name beside it. If that is a damaged project, File &gt; Open recovers what can be read of it.</source>
        <translation>Zapisz model pod inną nazwą albo nadaj temu, co tam teraz jest, inną nazwę obok. Jeśli to uszkodzony projekt, Plik &gt; Otwórz uratuje z niego to, co da się odczytać.</translation>
    </message>
    <message>
        <source>&amp;Keep the other file beside it, and save</source>
        <translation>&amp;Zachowaj drugi plik obok i zapisz</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be saved.</source>
        <translation>Nie udało się zapisać „%1”.</translation>
    </message>
    <message>
        <source>What was in the place of &quot;%1&quot; is in &quot;%2&quot; now.</source>
        <translation>To, co było w miejscu „%1”, jest teraz w „%2”.</translation>
    </message>
    <message>
        <source>Somebody else has changed &quot;%1&quot; since it was opened here.</source>
        <translation>Ktoś inny zmienił „%1” po otwarciu tutaj.</translation>
    </message>
    <message>
        <source>Their changes can become a branch of the history here, then both are saved. Your design stays as it is, and you can go to theirs.</source>
        <translation>Cudze zmiany mogą tu stać się gałęzią historii, wtedy zapisane zostanie jedno i drugie. Twój model pozostaje bez zmian, a do cudzego można przejść.</translation>
    </message>
    <message>
        <source>&amp;Take their changes in as a branch</source>
        <translation>&amp;Przejmij zmiany jako gałąź</translation>
    </message>
    <message>
        <source>From the file, %1</source>
        <translation>Z pliku, %1</translation>
    </message>
    <message>
        <source>Their changes could not be taken in.</source>
        <translation>Nie udało się przejąć cudzych zmian.</translation>
    </message>
    <message>
        <source>The changes of somebody else are a branch of the history now.</source>
        <translation>Cudze zmiany są teraz gałęzią historii.</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Pokaż</translation>
    </message>
    <message>
        <source>Go &amp;there</source>
        <translation>P&amp;rzejdź tam</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>&amp;Spróbuj ponownie</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>Zapisz j&amp;ako…</translation>
    </message>
    <message>
        <source>Nothing protects what you do since %1 against a crash: Bolster cannot write to the folder &quot;%2&quot;. Make room there, or save the design.</source>
        <translation>Od %1 nic nie chroni Twojej pracy przed awarią: Bolster nie może zapisywać w folderze „%2”. Zwolnij tam miejsce lub zapisz model.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Zapisz</translation>
    </message>
</context>
<context>
    <name>bolster::ScanLink</name>
    <message>
        <source>Deviation from %1</source>
        <translation>Odchyłka od: %1</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>wewnątrz</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>na zewnątrz</translation>
    </message>
</context>
<context>
    <name>bolster::SeamLineList</name>
    <message>
        <source>Seam lines</source>
        <translation>Linie szwów</translation>
    </message>
    <message>
        <source>Fixation curves of the design. Draw seam lines on a frame with the tool for fixation curves: what is drawn meanwhile is cut at once</source>
        <translation>Krzywe mocowania modelu. Rysuj linie szwów na stelażu narzędziem krzywych mocowania: narysowane w tym czasie są od razu cięte</translation>
    </message>
    <message numerus="yes">
        <source>%n lines that hold a cover</source>
        <translation>
            <numerusform>%n linia, która trzyma pokrowiec</numerusform>
            <numerusform>%n linie, które trzymają pokrowiec</numerusform>
            <numerusform>%n linii, które trzymają pokrowiec</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::SeamProposalsWindow</name>
    <message>
        <source>Proposed seams</source>
        <translation>Proponowane szwy</translation>
    </message>
    <message>
        <source>Edge of</source>
        <translation>Krawędź elementu</translation>
    </message>
    <message>
        <source>to edge of</source>
        <translation>z krawędzią elementu</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Długości</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>Pewność</translation>
    </message>
    <message>
        <source>Select rows to see their edges in the pattern; Enter or a double click sews them.</source>
        <translation>Zaznacz wiersze, aby zobaczyć ich krawędzie w wykroju; Enter lub dwukrotne kliknięcie je zszywa.</translation>
    </message>
    <message>
        <source>&amp;Sew selected</source>
        <translation>&amp;Zszyj zaznaczone</translation>
    </message>
    <message>
        <source>Sew &amp;all</source>
        <translation>Zszyj &amp;wszystkie</translation>
    </message>
    <message>
        <source>Looking for edges that belong together …</source>
        <translation>Wyszukiwanie krawędzi, które do siebie należą…</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>There are no free edges that seem to belong together.</source>
        <translation>Nie ma wolnych krawędzi, które zdają się do siebie należeć.</translation>
    </message>
    <message>
        <source>Sew &amp;likely ones</source>
        <translation>Zszyj &amp;prawdopodobne</translation>
    </message>
    <message>
        <source>Those of 50 % and more. What is sewn tells where its neighbours belong.</source>
        <translation>Te od 50% wzwyż. To, co zszyte, wskazuje, gdzie należą sąsiednie.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 i %2</translation>
    </message>
    <message>
        <source>Found by their lengths, corners that would close, names and directions; the most certain first. Look at each in the pattern before you sew it.</source>
        <translation>Według długości, rogów, które by się zamknęły, nazw i kierunków; najpewniejsze najpierw. Obejrzyj każdy w wykroju, zanim go zszyjesz.</translation>
    </message>
</context>
<context>
    <name>bolster::SeamsModel</name>
    <message>
        <source>Length</source>
        <translation>Długość</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parametr</translation>
    </message>
    <message>
        <source>More than 5 % ease puckers.</source>
        <translation>Przy wdaniu ponad 5% szew się marszczy.</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Szew</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Wdanie</translation>
    </message>
    <message>
        <source>Ease %</source>
        <translation>Wdanie, %</translation>
    </message>
    <message>
        <source>Joins</source>
        <translation>Ciągłość</translation>
    </message>
    <message>
        <source>Length 1</source>
        <translation>Długość 1</translation>
    </message>
    <message>
        <source>Length 2</source>
        <translation>Długość 2</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Parowanie</translation>
    </message>
    <message>
        <source>The letter on both stretches in the pattern</source>
        <translation>Litera na obu odcinkach w wykroju</translation>
    </message>
    <message>
        <source>The patches and their edges</source>
        <translation>Elementy i ich krawędzie</translation>
    </message>
    <message>
        <source>C0: an edge, C1: smooth with the texture, G1: rounded</source>
        <translation>C0: krawędź, C1: gładko wraz z wzorem, G1: zaokrąglenie</translation>
    </message>
    <message>
        <source>Of the first side</source>
        <translation>Pierwszej strony</translation>
    </message>
    <message>
        <source>Of the second side</source>
        <translation>Drugiej strony</translation>
    </message>
    <message>
        <source>What is sewn together: equal parts of the length, or of the curve&apos;s parameter</source>
        <translation>Co się zszywa: równe części długości lub parametru krzywej</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Krok</translation>
    </message>
    <message>
        <source>The place in the order of sewing; Seam &gt; Sew earlier and Sew later change it</source>
        <translation>Miejsce w kolejności szycia; zmieniają je Szew &gt; Szyj wcześniej i Szyj później</translation>
    </message>
    <message>
        <source>How much longer the second side is than the first one</source>
        <translation>O ile druga strona jest dłuższa od pierwszej</translation>
    </message>
    <message>
        <source>The ease over the shorter side; more than 5 % puckers</source>
        <translation>Wdanie w stosunku do krótszej strony; powyżej 5% szew się marszczy</translation>
    </message>
</context>
<context>
    <name>bolster::SeamsView</name>
    <message>
        <source>No seams yet. Choose the sewing tool (W), then click the two edges that belong together.</source>
        <translation>Nie ma jeszcze szwów. Wybierz narzędzie szycia (W), potem kliknij dwie krawędzie, które do siebie należą.</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Szwy</translation>
    </message>
</context>
<context>
    <name>bolster::SectionPanel</name>
    <message>
        <source>Section</source>
        <translation>Przekrój</translation>
    </message>
    <message>
        <source>Cut across the x axis</source>
        <translation>Tnij w poprzek osi x</translation>
    </message>
    <message>
        <source>Cut across the y axis</source>
        <translation>Tnij w poprzek osi y</translation>
    </message>
    <message>
        <source>Cut across the z axis</source>
        <translation>Tnij w poprzek osi z</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Widok</translation>
    </message>
    <message>
        <source>Cut parallel to the picture, as it is seen now</source>
        <translation>Tnij równolegle do obrazu, jak go teraz widać</translation>
    </message>
    <message>
        <source>Moves the plane</source>
        <translation>Przesuwa płaszczyznę</translation>
    </message>
    <message>
        <source>Show the other half</source>
        <translation>Pokaż drugą połowę</translation>
    </message>
    <message>
        <source>Close the section</source>
        <translation>Zamknij przekrój</translation>
    </message>
    <message>
        <source>Place of the section</source>
        <translation>Położenie przekroju</translation>
    </message>
</context>
<context>
    <name>bolster::SewingCommands</name>
    <message>
        <source>Propos&amp;e seams …</source>
        <translation>&amp;Zaproponuj szwy…</translation>
    </message>
    <message>
        <source>Show seam li&amp;st</source>
        <translation>Pokaż listę sz&amp;wów</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>&amp;Odwróć</translation>
    </message>
    <message>
        <source>Swap si&amp;des</source>
        <translation>Zamień s&amp;trony</translation>
    </message>
    <message>
        <source>C&amp;0 – an edge</source>
        <translation>C&amp;0 – krawędź</translation>
    </message>
    <message>
        <source>C&amp;1 – smooth, texture too</source>
        <translation>C&amp;1 – gładko, także wzór</translation>
    </message>
    <message>
        <source>&amp;G1 – rounded</source>
        <translation>&amp;G1 – zaokrąglenie</translation>
    </message>
    <message>
        <source>Match by &amp;length</source>
        <translation>Paruj według &amp;długości</translation>
    </message>
    <message>
        <source>Match by &amp;parameter</source>
        <translation>Paruj według para&amp;metru</translation>
    </message>
    <message>
        <source>Sew earl&amp;ier</source>
        <translation>Szyj w&amp;cześniej</translation>
    </message>
    <message>
        <source>Sew l&amp;ater</source>
        <translation>Szyj &amp;później</translation>
    </message>
    <message>
        <source>Sewi&amp;ng order as proposed</source>
        <translation>&amp;Kolejność szycia jak w propozycji</translation>
    </message>
</context>
<context>
    <name>bolster::SheetPreview</name>
    <message>
        <source>What will be on the sheets</source>
        <translation>Co będzie na arkuszach</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>Nie ma nic do krojenia.</translation>
    </message>
    <message>
        <source>Laying out …</source>
        <translation>Rozkładanie…</translation>
    </message>
</context>
<context>
    <name>bolster::ShortcutsDialog</name>
    <message>
        <source>&amp;No keys</source>
        <translation>&amp;Bez klawiszy</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Przywróć</translation>
    </message>
    <message>
        <source>&amp;Take them over</source>
        <translation>Prze&amp;jmij</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Skróty</translation>
    </message>
    <message>
        <source>Find a command or a key</source>
        <translation>Znajdź polecenie lub klawisz</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Polecenie</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Klawisze</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>Przywróć &amp;wszystkie</translation>
    </message>
    <message>
        <source>Click into the field and press the keys.</source>
        <translation>Kliknij pole i naciśnij klawisze.</translation>
    </message>
    <message>
        <source>Choose a command to change its keys.</source>
        <translation>Wybierz polecenie, aby zmienić jego klawisze.</translation>
    </message>
    <message>
        <source>%1 is needed by the views and fields themselves.</source>
        <translation>%1 jest potrzebny samym widokom i polom.</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 należy do „%2”.</translation>
    </message>
    <message>
        <source>%1 it is.</source>
        <translation>%1: przypisano.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Polecenia</translation>
    </message>
</context>
<context>
    <name>bolster::ShownPattern</name>
    <message>
        <source>Edge: %1</source>
        <translation>Krawędź: %1</translation>
    </message>
</context>
<context>
    <name>bolster::SimplifyChoice</name>
    <message>
        <source>&amp;Simplify to about</source>
        <translation>&amp;Uprość do około</translation>
    </message>
    <message>
        <source> triangles</source>
        <translation> trójkątów</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Trójkąty</translation>
    </message>
    <message>
        <source>Writes the parts that are wanted into an OBJ file of the design&apos;s own; the file that was chosen stays as it is</source>
        <translation>Zapisuje żądane części do własnego pliku OBJ modelu; wybrany plik pozostaje bez zmian</translation>
    </message>
</context>
<context>
    <name>bolster::SpotsPanel</name>
    <message>
        <source>Worst spots</source>
        <translation>Najgorsze miejsca</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>Element</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wartość</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Granica</translation>
    </message>
    <message>
        <source>Negative where the fabric is pressed together</source>
        <translation>Ujemna tam, gdzie materiał jest ściśnięty</translation>
    </message>
    <message>
        <source>What the fabric there may suffer. The spots are sorted by how much of it they take</source>
        <translation>Ile materiał może tam znieść. Miejsca są uporządkowane według tego, jaką część tego zużywają</translation>
    </message>
    <message>
        <source>As soon as there is a cover, its worst spots will be listed here.</source>
        <translation>Gdy tylko powstanie pokrowiec, tu pojawią się jego najgorsze miejsca.</translation>
    </message>
    <message>
        <source>A map of strain or shear shows what the fabric suffers. Its worst spots will be listed here.</source>
        <translation>Mapa odkształceń lub ścinania pokazuje, co znosi materiał. Tu pojawią się jego najgorsze miejsca.</translation>
    </message>
    <message>
        <source>Nothing is over the limit of its fabric.</source>
        <translation>Nic nie przekracza granicy materiału.</translation>
    </message>
    <message>
        <source>Over the limit of the fabric: %1 of %2</source>
        <translation>Powyżej granicy materiału: %1 z %2</translation>
    </message>
    <message>
        <source>over the limit of %1</source>
        <translation>powyżej granicy %1</translation>
    </message>
    <message>
        <source>Show the &amp;largest strain</source>
        <translation>Pokaż &amp;największe odkształcenie</translation>
    </message>
</context>
<context>
    <name>bolster::StartHint</name>
    <message>
        <source>A new cover</source>
        <translation>Nowy pokrowiec</translation>
    </message>
    <message>
        <source>Draw the first patch, import a frame, or open a design:</source>
        <translation>Narysuj pierwszy element, zaimportuj stelaż lub otwórz model:</translation>
    </message>
    <message>
        <source>Or look at a sample:</source>
        <translation>Albo obejrzyj przykład:</translation>
    </message>
    <message>
        <source>%1 more are under File &gt; Samples</source>
        <translation>Jeszcze %1 w menu Plik &gt; Przykłady</translation>
    </message>
    <message>
        <source>Go on with:</source>
        <translation>Kontynuuj:</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Wyczyść listę</translation>
    </message>
    <message>
        <source>Rectan&amp;gle</source>
        <translation>&amp;Prostokąt</translation>
    </message>
    <message>
        <source>Ou&amp;tline</source>
        <translation>&amp;Kontur</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>&amp;Otwórz…</translation>
    </message>
    <message>
        <source>&amp;Import frame …</source>
        <translation>&amp;Importuj stelaż…</translation>
    </message>
</context>
<context>
    <name>bolster::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Strona startowa</translation>
    </message>
    <message>
        <source>Welcome to Bolster</source>
        <translation>Witamy w Bolsterze</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>Rozpocznij samouczek</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Otwórz…</translation>
    </message>
    <message>
        <source>Back to the design</source>
        <translation>Wróć do modelu</translation>
    </message>
    <message>
        <source>What do you have?</source>
        <translation>Co masz?</translation>
    </message>
    <message>
        <source>A frame</source>
        <translation>Stelaż</translation>
    </message>
    <message>
        <source>The cover is fixed on it: %1</source>
        <translation>Na nim mocuje się pokrowiec: %1</translation>
    </message>
    <message>
        <source>A pattern</source>
        <translation>Wykrój</translation>
    </message>
    <message>
        <source>Its pieces become the cover: %1</source>
        <translation>Z jego elementów powstaje pokrowiec: %1</translation>
    </message>
    <message>
        <source>A scan</source>
        <translation>Skan</translation>
    </message>
    <message>
        <source>The cover is fitted to it: %1</source>
        <translation>Do niego dopasowuje się pokrowiec: %1</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Jeszcze nic</translation>
    </message>
    <message>
        <source>Draw a rectangle, the first patch</source>
        <translation>Narysuj prostokąt, pierwszy element</translation>
    </message>
    <message>
        <source>Go on with</source>
        <translation>Kontynuuj</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Wyczyść listę</translation>
    </message>
    <message>
        <source>Take it out of this list; the file stays</source>
        <translation>Usuń z tej listy; plik pozostaje</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Niezapisana praca</translation>
    </message>
    <message>
        <source>Kept for later, last edit %1</source>
        <translation>Zachowano na później, ostatnia zmiana %1</translation>
    </message>
    <message>
        <source>Left by a crash, last edit %1</source>
        <translation>Pozostało po awarii, ostatnia zmiana %1</translation>
    </message>
    <message>
        <source>Begin with a template</source>
        <translation>Zacznij od szablonu</translation>
    </message>
    <message>
        <source>Look at a sample</source>
        <translation>Obejrzyj przykład</translation>
    </message>
    <message>
        <source>It is not there now</source>
        <translation>Teraz go tam nie ma</translation>
    </message>
</context>
<context>
    <name>bolster::StatusLine</name>
    <message>
        <source>Nothing to sew yet</source>
        <translation>Nie ma jeszcze nic do zszycia</translation>
    </message>
    <message>
        <source>Preparing …</source>
        <translation>Przygotowanie…</translation>
    </message>
    <message>
        <source>Moving, %1/s</source>
        <translation>W ruchu, %1/s</translation>
    </message>
    <message>
        <source>Solved – %1 iterations</source>
        <translation>Obliczono – iteracje: %1</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Wstrzymano</translation>
    </message>
    <message numerus="yes">
        <source>%n problems</source>
        <translation>
            <numerusform>%n problem</numerusform>
            <numerusform>%n problemy</numerusform>
            <numerusform>%n problemów</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n ostrzeżenie</numerusform>
            <numerusform>%n ostrzeżenia</numerusform>
            <numerusform>%n ostrzeżeń</numerusform>
        </translation>
    </message>
    <message>
        <source>Solved in part</source>
        <translation>Obliczono częściowo</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Dlaczego?</translation>
    </message>
    <message>
        <source>Following the drag</source>
        <translation>Podąża za przeciąganiem</translation>
    </message>
    <message>
        <source>Solved, with warnings</source>
        <translation>Obliczono, z ostrzeżeniami</translation>
    </message>
    <message>
        <source>Show (%1)</source>
        <translation>Pokaż (%1)</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Pokaż</translation>
    </message>
    <message>
        <source>The cloth went on moving until the computation was ended. What usually causes that:
• A piece that nothing holds: fix one of its edges, or sew it on.
• A seam whose two sides differ much in length: make them more alike.
• A very long or very narrow piece: divide it, or make it wider.
• High pressure: lower it in the properties of the patch.
What you see is where the cloth was at the end.</source>
        <translation>Materiał poruszał się aż do końca obliczeń. Zwykle powoduje to:
• Element, którego nic nie trzyma: zamocuj jedną z jego krawędzi lub go przyszyj.
• Szew, którego strony mają bardzo różną długość: zbliż je do siebie.
• Element bardzo długi lub bardzo wąski: podziel go lub poszerz.
• Wysokie ciśnienie: zmniejsz je we właściwościach elementu.
Widać materiał w położeniu, w którym znalazł się na końcu.</translation>
    </message>
    <message>
        <source>Drawing and checking …</source>
        <translation>Rysowanie i sprawdzanie…</translation>
    </message>
    <message>
        <source>Preparing: on fewer triangles …</source>
        <translation>Przygotowanie: mniej trójkątów…</translation>
    </message>
    <message>
        <source>Preparing: forces and equations …</source>
        <translation>Przygotowanie: siły i równania…</translation>
    </message>
    <message>
        <source>&amp;What does it mean?</source>
        <translation>&amp;Co to znaczy?</translation>
    </message>
    <message>
        <source>A preview, not checked yet</source>
        <translation>Podgląd, jeszcze niesprawdzony</translation>
    </message>
</context>
<context>
    <name>bolster::SweepWindow</name>
    <message>
        <source>Tolerances</source>
        <translation>Tolerancje</translation>
    </message>
    <message>
        <source>&amp;Draw pieces</source>
        <translation>&amp;Losuj sztuki</translation>
    </message>
    <message>
        <source>Solving pieces within tolerances …</source>
        <translation>Obliczanie sztuk w granicach tolerancji…</translation>
    </message>
    <message>
        <source>Pieces are drawn at random within their tolerances: where does the cover vary, which tolerance matters, how many pieces are out of the limit?</source>
        <translation>Sztuki są losowane w granicach tolerancji: gdzie pokrowiec się zmienia, która tolerancja ma znaczenie, ile sztuk przekracza granicę?</translation>
    </message>
    <message>
        <source>&amp;Show on the cover what 95 % of the pieces do not exceed</source>
        <translation>Pok&amp;aż na pokrowcu, czego nie przekracza 95% sztuk</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancja</translation>
    </message>
    <message>
        <source>Moves by at most</source>
        <translation>Przesuwa najwyżej o</translation>
    </message>
    <message>
        <source>Tolerances by their influence</source>
        <translation>Tolerancje według wpływu</translation>
    </message>
    <message>
        <source>Tolerances (±); 0: none</source>
        <translation>Tolerancje (±); 0: brak</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Sztuki</translation>
    </message>
    <message>
        <source>Every size within is as likely</source>
        <translation>Każdy wymiar w granicach jest równie prawdopodobny</translation>
    </message>
    <message>
        <source>Normal: the tolerance is three standard deviations</source>
        <translation>Normalny: tolerancja to trzy odchylenia standardowe</translation>
    </message>
    <message>
        <source>Before them ten thousand are drawn as if covers were linear, which takes seconds</source>
        <translation>Przed nimi losuje się dziesięć tysięcy w przybliżeniu liniowym, co trwa kilka sekund</translation>
    </message>
    <message>
        <source>Dr&amp;awn</source>
        <translation>L&amp;osowanie</translation>
    </message>
    <message>
        <source>S&amp;olved</source>
        <translation>O&amp;bliczone</translation>
    </message>
    <message>
        <source>Nothing varies: give a tolerance above 0 of something that the design has.</source>
        <translation>Nic się nie zmienia: podaj tolerancję powyżej 0 dla czegoś, co jest w modelu.</translation>
    </message>
    <message>
        <source>Covers with each tolerance are solved …</source>
        <translation>Obliczanie pokrowców z każdą tolerancją…</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Zatrzymano.</translation>
    </message>
    <message>
        <source>That is as if covers were linear; pieces are being solved …</source>
        <translation>To przybliżenie liniowe; trwa obliczanie sztuk…</translation>
    </message>
    <message>
        <source>That is as if covers were linear.</source>
        <translation>To przybliżenie liniowe.</translation>
    </message>
    <message numerus="yes">
        <source>By %n solved pieces.</source>
        <translation>
            <numerusform>Na podstawie %n obliczonej sztuki.</numerusform>
            <numerusform>Na podstawie %n obliczonych sztuk.</numerusform>
            <numerusform>Na podstawie %n obliczonych sztuk.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces have no cover at rest.</source>
        <translation>
            <numerusform>%n sztuka nie ma pokrowca w spoczynku.</numerusform>
            <numerusform>%n sztuki nie mają pokrowca w spoczynku.</numerusform>
            <numerusform>%n sztuk nie ma pokrowca w spoczynku.</numerusform>
        </translation>
    </message>
    <message>
        <source>What 95 % of the pieces do not exceed</source>
        <translation>Czego nie przekracza 95% sztuk</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: draw the pieces again.</source>
        <translation>Model się tymczasem zmienił: losuj sztuki ponownie.</translation>
    </message>
    <message numerus="yes">
        <source>By %n solved pieces so far; more are being solved …</source>
        <translation>
            <numerusform>Na podstawie %n obliczonej dotąd sztuki; obliczane są następne…</numerusform>
            <numerusform>Na podstawie %n obliczonych dotąd sztuk; obliczane są następne…</numerusform>
            <numerusform>Na podstawie %n obliczonych dotąd sztuk; obliczane są następne…</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With %n tolerances no cover is found, as with: %1. They are left out of this: make them smaller.</source>
        <translation>
            <numerusform>Przy %n tolerancji nie ma pokrowca: %1. Pominięto ją tutaj: proszę ją zmniejszyć.</numerusform>
            <numerusform>Przy %n tolerancjach nie ma pokrowca, na przykład: %1. Pominięto je tutaj: proszę je zmniejszyć.</numerusform>
            <numerusform>Przy %n tolerancjach nie ma pokrowca, na przykład: %1. Pominięto je tutaj: proszę je zmniejszyć.</numerusform>
        </translation>
    </message>
    <message>
        <source>A piece is out of it when more than 5 % of its cover lie farther from where they should be</source>
        <translation>Sztuka przekracza granicę, gdy ponad 5% jej pokrowca leży dalej od właściwego miejsca</translation>
    </message>
    <message>
        <source>95 % of the pieces do not exceed, place by place, %1 (rms over the cover), %2 where it is most.</source>
        <translation>Czego 95% sztuk nie przekracza, miejsce po miejscu: %1 (RMS na pokrowcu), %2 w najgorszym miejscu.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Udział</translation>
    </message>
    <message>
        <source>How much of the variance of the whole cover comes of it</source>
        <translation>Jaka część wariancji całego pokrowca z niej wynika</translation>
    </message>
    <message>
        <source>± is what many more of them may change.</source>
        <translation>± to zmiana możliwa przy znacznie większej ich liczbie.</translation>
    </message>
    <message>
        <source>Out of the limit: about %1 of the pieces.</source>
        <translation>Poza granicą: około %1 sztuk.</translation>
    </message>
    <message>
        <source>Out of the limit: %1 of %2 pieces (of many: %3 to %4).</source>
        <translation>Poza granicą: %1 z %2 sztuk (z wielu: od %3 do %4).</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>These are too few to say how sure that is.</source>
        <translation>To za mało, by powiedzieć, jak pewne to jest.</translation>
    </message>
    <message>
        <source>&amp;Limit for 95 % of a cover</source>
        <translation>&amp;Granica dla 95% pokrowca</translation>
    </message>
    <message>
        <source>This is of what was set before: draw pieces for what is set now.</source>
        <translation>To dotyczy poprzednich ustawień: wylosuj sztuki dla obecnych.</translation>
    </message>
</context>
<context>
    <name>bolster::ToolHost</name>
    <message>
        <source>This could not be done, and nothing was changed: %1</source>
        <translation>Nie udało się tego wykonać i nic nie zmieniono: %1</translation>
    </message>
</context>
<context>
    <name>bolster::TourPanel</name>
    <message>
        <source>Back</source>
        <translation>Wstecz</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Dalej</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>Zakończ samouczek</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Samouczek</translation>
    </message>
    <message>
        <source>Help &gt; Tour goes on from here</source>
        <translation>Pomoc &gt; Samouczek pozwala stąd kontynuować</translation>
    </message>
    <message>
        <source>Tour, %1 of %2</source>
        <translation>Samouczek, %1 z %2</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Zakończ</translation>
    </message>
</context>
<context>
    <name>bolster::TrimTool</name>
    <message>
        <source>Click a seam or an edge of an outline.</source>
        <translation>Kliknij szew lub krawędź konturu.</translation>
    </message>
    <message>
        <source>Click to stitch this seam; stitches and piping are in the properties</source>
        <translation>Kliknij, aby stebnować ten szew; ściegi i kedra są we właściwościach</translation>
    </message>
    <message>
        <source>Click to stitch this edge; stitches and piping are in the properties</source>
        <translation>Kliknij, aby stebnować tę krawędź; ściegi i kedra są we właściwościach</translation>
    </message>
    <message>
        <source>Click a seam or an edge of an outline to stitch it – Esc ends the tool</source>
        <translation>Kliknij szew lub krawędź konturu, aby je stebnować – Esc kończy</translation>
    </message>
</context>
<context>
    <name>bolster::VersionPane</name>
    <message>
        <source>Computing the cover …</source>
        <translation>Obliczanie pokrowca…</translation>
    </message>
    <message>
        <source>Pattern of %1</source>
        <translation>Wykrój: %1</translation>
    </message>
    <message>
        <source>Cover of %1</source>
        <translation>Pokrowiec: %1</translation>
    </message>
</context>
<context>
    <name>bolster::ViewCube</name>
    <message>
        <source>FRONT</source>
        <translation>PRZÓD</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>TYŁ</translation>
    </message>
    <message>
        <source>LEFT</source>
        <translation>LEWA</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <translation>PRAWA</translation>
    </message>
    <message>
        <source>TOP</source>
        <translation>GÓRA</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <translation>DÓŁ</translation>
    </message>
    <message>
        <source>Click a face, an edge or a corner to look from there; drag to turn</source>
        <translation>Kliknij ścianę, krawędź lub róg, aby spojrzeć stamtąd; przeciągnij, aby obrócić</translation>
    </message>
</context>
</TS>
