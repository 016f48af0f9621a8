<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="it" sourcelanguage="en">
<context>
    <name>AreaBrushTool</name>
    <message>
        <source>Drag over the cover to paint the area; with Shift held down to take away. + and − change the brush. Esc ends.</source>
        <translation>Trascina sul rivestimento per dipingere la zona; con Maiusc premuto per togliere. + e − cambiano il pennello. Esc termina.</translation>
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
        <translation>«%1» esiste già. Sostituirlo?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
</context>
<context>
    <name>AttachTool</name>
    <message>
        <source>Click an edge of an outline.</source>
        <translation>Fare clic su un lato di un contorno.</translation>
    </message>
    <message>
        <source>Select a fixation curve first, in the 3D view or in the list.</source>
        <translation>Selezionare prima una curva di fissaggio, nella vista 3D o nell’elenco.</translation>
    </message>
    <message>
        <source>Several stretches go with one curve, or one stretch with several curves.</source>
        <translation>Più tratti vanno con una curva, o un tratto con più curve.</translation>
    </message>
    <message>
        <source>The stretches overlap each other, or are attached like this already.</source>
        <translation>I tratti si sovrappongono o sono già fissati così.</translation>
    </message>
    <message>
        <source>This stretch is attached like this already.</source>
        <translation>Questo tratto è già fissato così.</translation>
    </message>
    <message>
        <source>Select a fixation curve in the 3D view or in the list, then click an edge of an outline – Esc ends the tool</source>
        <translation>Selezionare una curva di fissaggio nella vista 3D o nell’elenco, poi fare clic su un lato di un contorno – Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>%1 curves</source>
        <translation>%1 curve</translation>
    </message>
    <message>
        <source>Click to fix this stretch of %1 to %2 – Shift+click collects several</source>
        <translation>Clic per fissare questo tratto di %1 a %2 – Maiusc+clic ne raccoglie più d’uno</translation>
    </message>
    <message>
        <source>Click the last edge, or Enter attaches %1 stretches to %2 – Backspace takes one back</source>
        <translation>Clic sull’ultimo lato, oppure Invio fissa %1 tratti a %2 – Backspace ne toglie uno</translation>
    </message>
    <message>
        <source>Click an edge of an outline to fix it to %1 – Enter takes the selected stretch, Esc ends the tool</source>
        <translation>Fare clic su un lato di un contorno per fissarlo a %1 – Invio prende il tratto selezionato, Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>&amp;Attach what is marked</source>
        <translation>&amp;Fissa i tratti marcati</translation>
    </message>
    <message>
        <source>&amp;Take back the last edge</source>
        <translation>&amp;Togli l’ultimo lato</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>&amp;Abbandona</translation>
    </message>
</context>
<context>
    <name>BackgroundMoveTool</name>
    <message>
        <source>There is no background picture yet.</source>
        <translation>Non c’è ancora un’immagine di sfondo.</translation>
    </message>
    <message>
        <source>Drag the picture to its place – Enter or Esc ends the tool</source>
        <translation>Trascinare l’immagine al suo posto – Invio o Esc chiude lo strumento</translation>
    </message>
</context>
<context>
    <name>BackgroundPicture</name>
    <message>
        <source>%1 cannot be read as a picture: %2</source>
        <translation>%1 non può essere letto come immagine: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an ordinary file.</source>
        <translation>«%1» non è un file ordinario.</translation>
    </message>
</context>
<context>
    <name>BackgroundScaleTool</name>
    <message>
        <source>There is no background picture yet.</source>
        <translation>Non c’è ancora un’immagine di sfondo.</translation>
    </message>
    <message>
        <source>Type the true distance of the two points, for example 500 or 20 in.</source>
        <translation>Digitare la distanza reale dei due punti, ad esempio 500 o 20 in.</translation>
    </message>
    <message>
        <source>Click the first of two points of the picture whose distance you know – Esc ends the tool</source>
        <translation>Fare clic sul primo di due punti dell’immagine di distanza nota – Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>Click the second point</source>
        <translation>Fare clic sul secondo punto</translation>
    </message>
    <message>
        <source>Type their true distance, then Enter</source>
        <translation>Digitare la distanza reale, poi Invio</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>ora %1</translation>
    </message>
</context>
<context>
    <name>BoxShapeTool</name>
    <message>
        <source>&quot;%1&quot; is no size: try 300 x 200</source>
        <translation>«%1» non è una dimensione: ad esempio 300 x 200</translation>
    </message>
    <message>
        <source>Enter makes it as wide and high as typed, for example 300 x 200</source>
        <translation>Invio usa larghezza e altezza digitate, ad esempio 300 x 200</translation>
    </message>
    <message>
        <source>Drag a rectangle, or click two opposite corners – Esc ends the tool</source>
        <translation>Tracciare un rettangolo o fare clic su due angoli opposti – Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>Drag an ellipse, or click two opposite corners of its box – Esc ends the tool</source>
        <translation>Tracciare un’ellisse o fare clic su due angoli opposti del suo riquadro – Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>Click the opposite corner, or type width x height – Shift makes both equal, Ctrl does not snap</source>
        <translation>Fare clic sull’angolo opposto o digitare larghezza x altezza – Maiusc le rende uguali, Ctrl esclude l’aggancio</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>There was no room where you clicked: the patch lies beside the others.</source>
        <translation>Nel punto del clic non c’era spazio: il pezzo è accanto agli altri.</translation>
    </message>
    <message>
        <source>The new patch lies on %1: drag it away, or let all be arranged (Pattern &gt; Arrange).</source>
        <translation>Il nuovo pezzo è sopra %1: trascinarlo via o far disporre tutti i pezzi (Cartamodello &gt; Disponi).</translation>
    </message>
    <message>
        <source>lies on %1</source>
        <translation>è sopra %1</translation>
    </message>
</context>
<context>
    <name>ColourwayForm</name>
    <message>
        <source>Fabrics</source>
        <translation>Tessuti</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>those of the patches</source>
        <translation>quelli dei pezzi</translation>
    </message>
</context>
<context>
    <name>ContextMenus</name>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Mostra</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>&amp;Guarda da</translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation>Ma&amp;ppa</translation>
    </message>
    <message>
        <source>&amp;Continuity</source>
        <translation>&amp;Continuità</translation>
    </message>
    <message>
        <source>&amp;Match</source>
        <translation>C&amp;orrispondenza</translation>
    </message>
    <message>
        <source>&amp;Arrange</source>
        <translation>&amp;Disponi</translation>
    </message>
</context>
<context>
    <name>CoverAtRest</name>
    <message>
        <source>As soon as the cover has come to rest …</source>
        <translation>Appena il rivestimento è a riposo…</translation>
    </message>
    <message>
        <source>This needs the cover of the present design: let the solver go on first (Pause).</source>
        <translation>Serve il rivestimento del modello attuale: lasciare prima proseguire il calcolo (disattivare Pausa).</translation>
    </message>
</context>
<context>
    <name>CoverMeasureTool</name>
    <message>
        <source>There is no cover here: click on the cover.</source>
        <translation>Qui non c’è rivestimento: fare clic sul rivestimento.</translation>
    </message>
    <message>
        <source>&amp;Keep the measurement</source>
        <translation>&amp;Mantieni la misura</translation>
    </message>
    <message>
        <source>%1 – Enter keeps the measurement, a click begins anew</source>
        <translation>%1 – Invio mantiene la misura, un clic ricomincia</translation>
    </message>
    <message>
        <source>Click the second point on the cover – Esc gives it up</source>
        <translation>Fare clic sul secondo punto del rivestimento – Esc rinuncia</translation>
    </message>
    <message>
        <source>Click two points of the cover or of the pattern to measure – Esc ends the tool</source>
        <translation>Fare clic su due punti del rivestimento o del cartamodello per misurare – Esc chiude lo strumento</translation>
    </message>
</context>
<context>
    <name>CoverSelectTool</name>
    <message>
        <source>There is a control point already.</source>
        <translation>Qui c’è già un punto di controllo.</translation>
    </message>
    <message>
        <source>Drag to move the control point – Shift+click selects several, Del removes</source>
        <translation>Trascinare per spostare il punto di controllo – Maiusc+clic ne seleziona più d’uno, Canc lo rimuove</translation>
    </message>
    <message>
        <source>Click to select the seam</source>
        <translation>Clic per selezionare la cucitura</translation>
    </message>
    <message>
        <source>Click to select the patch, drag to turn the view</source>
        <translation>Clic per selezionare il pezzo, trascinare per ruotare la vista</translation>
    </message>
    <message>
        <source>Click to select the curve, double click to add a control point here</source>
        <translation>Clic per selezionare la curva, doppio clic per aggiungere qui un punto di controllo</translation>
    </message>
    <message>
        <source>Click to select what stands here, drag to turn the view</source>
        <translation>Clic per selezionare ciò che si trova qui, trascinare per ruotare la vista</translation>
    </message>
    <message>
        <source>Click to select, drag to turn – %1 pans, %2 zooms</source>
        <translation>Clic per selezionare, trascinare per ruotare – %1 sposta la vista, %2 esegue lo zoom</translation>
    </message>
    <message>
        <source>Click to select the measurement, Delete removes it</source>
        <translation>Clic per selezionare la misura, Canc la rimuove</translation>
    </message>
</context>
<context>
    <name>CushionForm</name>
    <message>
        <source>Cover of %1</source>
        <translation>Rivestimento di %1</translation>
    </message>
    <message>
        <source>Every cover</source>
        <translation>Ogni rivestimento</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Preme</translation>
    </message>
</context>
<context>
    <name>CutCornerForm</name>
    <message>
        <source>Patch</source>
        <translation>Pezzo</translation>
    </message>
</context>
<context>
    <name>CutLabelWords</name>
    <message>
        <source>Cut %1</source>
        <translation>Tagliare %1×</translation>
    </message>
    <message>
        <source>Cut %1 and %1 mirrored</source>
        <translation>Tagliare %1× e %1× speculare</translation>
    </message>
</context>
<context>
    <name>CuttingCommands</name>
    <message>
        <source>Chec&amp;k before cutting</source>
        <translation>Ve&amp;rifica prima del taglio</translation>
    </message>
</context>
<context>
    <name>DartCommands</name>
    <message>
        <source>Remove da&amp;rt</source>
        <translation>Rimuovi &amp;pince</translation>
    </message>
    <message>
        <source>The edge goes on as if the selected dart had never been cut</source>
        <translation>Il lato prosegue come se la pince selezionata non fosse mai stata tagliata</translation>
    </message>
    <message>
        <source>R&amp;otate dart to …</source>
        <translation>R&amp;uota pince in…</translation>
    </message>
    <message>
        <source>Turns the selected dart shut and opens the pattern where you click, by the same angle</source>
        <translation>Chiude la pince selezionata e apre il cartamodello nel punto del clic, dello stesso angolo</translation>
    </message>
</context>
<context>
    <name>DartDrag</name>
    <message>
        <source>Near the dotted line both legs become of one length, or type how deep it is – Shift keeps to it, Ctrl lets go, Esc takes it back</source>
        <translation>Presso la linea punteggiata i due lati hanno la stessa lunghezza, oppure digitare la profondità – Maiusc resta sulla linea, Ctrl la lascia, Esc annulla</translation>
    </message>
    <message>
        <source>Drag the dart along the outline, or type how far its middle is from the corner – Esc takes it back</source>
        <translation>Trascinare la pince lungo il contorno o digitare la distanza del suo centro dall’angolo – Esc annulla</translation>
    </message>
</context>
<context>
    <name>DartPicture</name>
    <message>
        <source>Depth %1, legs of one length</source>
        <translation>Profondità %1, lati di pari lunghezza</translation>
    </message>
    <message>
        <source>Depth %1</source>
        <translation>Profondità %1</translation>
    </message>
    <message>
        <source>Mouth %1</source>
        <translation>Apertura %1</translation>
    </message>
</context>
<context>
    <name>DartRotateTool</name>
    <message>
        <source>Select the seam of a dart first – Esc ends the tool</source>
        <translation>Selezionare prima la cucitura di una pince – Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>Click the outline where the dart shall open instead – Ctrl does not snap, Esc ends the tool</source>
        <translation>Fare clic sul contorno dove la pince deve invece aprirsi – Ctrl esclude l’aggancio, Esc chiude lo strumento</translation>
    </message>
</context>
<context>
    <name>DartTool</name>
    <message>
        <source>There is no room for a mouth of &quot;%1&quot;.</source>
        <translation>Non c’è spazio per un’apertura di «%1».</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no depth: try 60</source>
        <translation>«%1» non è una profondità: provare 60</translation>
    </message>
    <message>
        <source>Click the tip inside the patch, or type how deep it lies – on the dotted line both legs are of one length (Shift keeps to it, Ctrl lets go), Esc takes a click back</source>
        <translation>Fare clic sulla punta dentro il pezzo o digitarne la profondità – sulla linea punteggiata i due lati hanno la stessa lunghezza (Maiusc resta sulla linea, Ctrl la lascia), Esc toglie un clic</translation>
    </message>
    <message>
        <source>Click where the mouth ends on the same outline, or type how wide it is – Ctrl does not snap, Esc takes the click back</source>
        <translation>Fare clic dove finisce l’apertura sullo stesso contorno o digitarne la larghezza – Ctrl esclude l’aggancio, Esc toglie il clic</translation>
    </message>
    <message>
        <source>Click an outline where the mouth of the dart begins – Esc ends the tool</source>
        <translation>Fare clic su un contorno dove inizia l’apertura della pince – Esc chiude lo strumento</translation>
    </message>
</context>
<context>
    <name>DescribedField</name>
    <message>
        <source>none</source>
        <translation>nessuna</translation>
    </message>
</context>
<context>
    <name>DesignCuttingSection</name>
    <message>
        <source>Cutting</source>
        <translation>Taglio</translation>
    </message>
    <message>
        <source>Seam allowance of all patches</source>
        <translation>Margine di tutti i pezzi</translation>
    </message>
    <message>
        <source>Depth of notches</source>
        <translation>Profondità tacche</translation>
    </message>
    <message>
        <source>Width of notches</source>
        <translation>Larghezza tacche</translation>
    </message>
</context>
<context>
    <name>Docks</name>
    <message>
        <source>Pattern</source>
        <translation>Cartamodello</translation>
    </message>
    <message>
        <source>Cover</source>
        <translation>Rivestimento</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elementi</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Cronologia</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Proprietà</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemi</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Cuciture</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Tessuti</translation>
    </message>
    <message>
        <source>Worst spots</source>
        <translation>Punti critici</translation>
    </message>
    <message>
        <source>Check before cutting</source>
        <translation>Verifica prima del taglio</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Attività</translation>
    </message>
</context>
<context>
    <name>DrawingCommands</name>
    <message>
        <source>&amp;Grid and snapping</source>
        <translation>&amp;Griglia e aggancio</translation>
    </message>
    <message>
        <source>S&amp;napping</source>
        <translation>Agg&amp;ancio</translation>
    </message>
    <message>
        <source>&amp;Rulers</source>
        <translation>&amp;Righelli</translation>
    </message>
    <message>
        <source>Gui&amp;des</source>
        <translation>Gu&amp;ide</translation>
    </message>
    <message>
        <source>Remove all g&amp;uides</source>
        <translation>Rimuovi tutte le g&amp;uide</translation>
    </message>
    <message>
        <source>Select with a &amp;loop</source>
        <translation>Seleziona con il &amp;lazo</translation>
    </message>
    <message>
        <source>&amp;Background picture</source>
        <translation>Immagine di s&amp;fondo</translation>
    </message>
    <message>
        <source>&amp;Open picture …</source>
        <translation>&amp;Apri immagine…</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>&amp;Mostra</translation>
    </message>
    <message>
        <source>&amp;Scale by two points</source>
        <translation>&amp;Scala con due punti</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>S&amp;posta</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Rimuovi</translation>
    </message>
    <message>
        <source>Opacity %1</source>
        <translation>Opacità %1</translation>
    </message>
    <message>
        <source>Open a picture to trace</source>
        <translation>Apri un’immagine da ricalcare</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.webp);;All files (*)</source>
        <translation>Immagini (*.png *.jpg *.jpeg *.bmp *.webp);;Tutti i file (*)</translation>
    </message>
</context>
<context>
    <name>DrawingKeys</name>
    <message>
        <source>&amp;Finish</source>
        <translation>&amp;Fine</translation>
    </message>
    <message>
        <source>&amp;Take back the last point</source>
        <translation>&amp;Togli l’ultimo punto</translation>
    </message>
    <message>
        <source>Switch between &amp;straight and smooth</source>
        <translation>Alterna &amp;dritto e curvo</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>&amp;Abbandona</translation>
    </message>
</context>
<context>
    <name>DrillHoleForm</name>
    <message>
        <source>Patch</source>
        <translation>Pezzo</translation>
    </message>
</context>
<context>
    <name>EdgeAllowanceForm</name>
    <message>
        <source>Outline</source>
        <translation>Contorno</translation>
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
        <translation>&amp;Annulla</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Ripristina</translation>
    </message>
    <message>
        <source>Name this &amp;branch …</source>
        <translation>&amp;Dai un nome al ramo…</translation>
    </message>
    <message>
        <source>Name the way that the history has gone since it forked</source>
        <translation>Dà un nome al percorso della cronologia dall’ultima diramazione</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Ri&amp;nomina</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Elimina</translation>
    </message>
    <message>
        <source>Select &amp;all patches</source>
        <translation>Seleziona &amp;tutti i pezzi</translation>
    </message>
    <message>
        <source>Select n&amp;othing</source>
        <translation>&amp;Deseleziona tutto</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Annulla: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Ripristina: %1</translation>
    </message>
</context>
<context>
    <name>ElementText</name>
    <message>
        <source>missing element %1</source>
        <translation>elemento %1 mancante</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>Pezzi</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Cucitura</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Cuciture</translation>
    </message>
    <message>
        <source>Fixation curve</source>
        <translation>Curva di fissaggio</translation>
    </message>
    <message>
        <source>Fixation curves</source>
        <translation>Curve di fissaggio</translation>
    </message>
    <message>
        <source>Fixation</source>
        <translation>Fissaggio</translation>
    </message>
    <message>
        <source>Fixations</source>
        <translation>Fissaggi</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Telaio</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Telai</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Tessuto</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Tessuti</translation>
    </message>
    <message>
        <source>Unusable element</source>
        <translation>Elemento inutilizzabile</translation>
    </message>
    <message>
        <source>Unusable elements</source>
        <translation>Elementi inutilizzabili</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Modello</translation>
    </message>
    <message>
        <source>%1 and %2, ease %3</source>
        <translation>%1 e %2, lentezza %3</translation>
    </message>
    <message>
        <source>%1, normal held</source>
        <translation>%1, normale vincolata</translation>
    </message>
    <message>
        <source>Handle curve</source>
        <translation>Curva maniglia</translation>
    </message>
    <message>
        <source>Handle curves</source>
        <translation>Curve maniglia</translation>
    </message>
    <message>
        <source>Fancy seam</source>
        <translation>Cucitura decorativa</translation>
    </message>
    <message>
        <source>Fancy seams</source>
        <translation>Cuciture decorative</translation>
    </message>
    <message>
        <source>Cushion</source>
        <translation>Imbottitura</translation>
    </message>
    <message>
        <source>Cushions</source>
        <translation>Imbottiture</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>Espanso</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scansione</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Scansioni</translation>
    </message>
    <message>
        <source>%1 patches</source>
        <translation>%1 pezzi</translation>
    </message>
    <message>
        <source>%1 seams</source>
        <translation>%1 cuciture</translation>
    </message>
    <message>
        <source>%1 fixation curves</source>
        <translation>%1 curve di fissaggio</translation>
    </message>
    <message>
        <source>%1 fixations</source>
        <translation>%1 fissaggi</translation>
    </message>
    <message>
        <source>%1 handle curves</source>
        <translation>%1 curve maniglia</translation>
    </message>
    <message>
        <source>%1 fancy seams</source>
        <translation>%1 cuciture decorative</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 telai</translation>
    </message>
    <message>
        <source>%1 cushions</source>
        <translation>%1 imbottiture</translation>
    </message>
    <message>
        <source>%1 pieces of foam</source>
        <translation>%1 parti di espanso</translation>
    </message>
    <message>
        <source>%1 scans</source>
        <translation>%1 scansioni</translation>
    </message>
    <message>
        <source>%1 fabrics</source>
        <translation>%1 tessuti</translation>
    </message>
    <message>
        <source>%1 unusable elements</source>
        <translation>%1 elementi inutilizzabili</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 elementi</translation>
    </message>
    <message>
        <source>Trimmed edge</source>
        <translation>Lato rifinito</translation>
    </message>
    <message>
        <source>Trimmed edges</source>
        <translation>Lati rifiniti</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>Variante colore</translation>
    </message>
    <message>
        <source>Colourways</source>
        <translation>Varianti colore</translation>
    </message>
    <message>
        <source>%1 trimmed edges</source>
        <translation>%1 lati rifiniti</translation>
    </message>
    <message>
        <source>%1 colourways</source>
        <translation>%1 varianti colore</translation>
    </message>
    <message>
        <source>Edge of %1</source>
        <translation>Lato di %1</translation>
    </message>
    <message>
        <source>Allowance of an edge</source>
        <translation>Margine di un lato</translation>
    </message>
    <message>
        <source>Allowances of edges</source>
        <translation>Margini di lati</translation>
    </message>
    <message>
        <source>%1 allowances of edges</source>
        <translation>%1 margini di lati</translation>
    </message>
    <message>
        <source>Corner of the cut line</source>
        <translation>Angolo della linea di taglio</translation>
    </message>
    <message>
        <source>Corners of the cut line</source>
        <translation>Angoli della linea di taglio</translation>
    </message>
    <message>
        <source>%1 corners of the cut line</source>
        <translation>%1 angoli della linea di taglio</translation>
    </message>
    <message>
        <source>Drill hole</source>
        <translation>Foro</translation>
    </message>
    <message>
        <source>Drill holes</source>
        <translation>Fori</translation>
    </message>
    <message>
        <source>%1 drill holes</source>
        <translation>%1 fori</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>Tacca</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Tacche</translation>
    </message>
    <message>
        <source>%1 notches</source>
        <translation>%1 tacche</translation>
    </message>
    <message>
        <source>Internal line</source>
        <translation>Linea interna</translation>
    </message>
    <message>
        <source>Internal lines</source>
        <translation>Linee interne</translation>
    </message>
    <message>
        <source>%1 internal lines</source>
        <translation>%1 linee interne</translation>
    </message>
    <message>
        <source>%1, allowance %2</source>
        <translation>%1, margine %2</translation>
    </message>
    <message>
        <source>Notch of %1</source>
        <translation>Tacca di %1</translation>
    </message>
    <message>
        <source>Corner of %1</source>
        <translation>Angolo di %1</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Misura</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Misure</translation>
    </message>
    <message>
        <source>%1 measurements</source>
        <translation>%1 misure</translation>
    </message>
</context>
<context>
    <name>ElementsModel</name>
    <message>
        <source>edge %1</source>
        <translation>lato %1</translation>
    </message>
    <message>
        <source>%1 from the corner</source>
        <translation>%1 dall’angolo</translation>
    </message>
</context>
<context>
    <name>FabricForm</name>
    <message>
        <source>Weft</source>
        <translation>Trama</translation>
    </message>
    <message>
        <source>Creases</source>
        <translation>Solchi</translation>
    </message>
    <message>
        <source>Depth of the pile</source>
        <translation>Altezza del pelo</translation>
    </message>
    <message>
        <source>Other squares</source>
        <translation>Altri quadri</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Scala</translation>
    </message>
    <message>
        <source>Squares</source>
        <translation>Quadri</translation>
    </message>
    <message>
        <source>Grain size</source>
        <translation>Dimensione della grana</translation>
    </message>
    <message>
        <source>Repeat of the weave</source>
        <translation>Rapporto dell’armatura</translation>
    </message>
    <message>
        <source>Nap</source>
        <translation>Verso del pelo</translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation>Larghezza immagine</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>Comportamento</translation>
    </message>
    <message>
        <source>The fabric on a cushion and on a ball</source>
        <translation>Il tessuto su un cuscino e su una sfera</translation>
    </message>
    <message>
        <source>The fabric on a cushion and on a ball, at its real scale</source>
        <translation>Il tessuto su un cuscino e su una sfera, in scala reale</translation>
    </message>
    <message>
        <source>Colour of the fabric</source>
        <translation>Colore del tessuto</translation>
    </message>
    <message>
        <source>Second colour of the fabric</source>
        <translation>Secondo colore del tessuto</translation>
    </message>
    <message>
        <source>From the first colour</source>
        <translation>Dal primo colore</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Choose an&amp;other picture …</source>
        <translation>Scegli un’&amp;altra immagine…</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Taglio</translation>
    </message>
</context>
<context>
    <name>FabricMenu</name>
    <message>
        <source>&amp;New fabric</source>
        <translation>&amp;Nuovo tessuto</translation>
    </message>
    <message>
        <source>Adds leather, weave, velvet or another fabric to the library of the design</source>
        <translation>Aggiunge alla raccolta del modello pelle, tela, velluto o un altro tessuto</translation>
    </message>
    <message>
        <source>From a &amp;picture …</source>
        <translation>Da &amp;immagine…</translation>
    </message>
    <message>
        <source>A fabric that looks like a picture: PNG, JPEG, TIFF or OpenEXR</source>
        <translation>Un tessuto con l’aspetto di un’immagine: PNG, JPEG, TIFF o OpenEXR</translation>
    </message>
    <message>
        <source>&amp;Assign to selection</source>
        <translation>&amp;Assegna alla selezione</translation>
    </message>
    <message>
        <source>Gives the selected patches the fabric that is chosen in the library</source>
        <translation>Assegna ai pezzi selezionati il tessuto scelto nella raccolta</translation>
    </message>
    <message>
        <source>Fabric p&amp;roperties</source>
        <translation>Proprietà del tess&amp;uto</translation>
    </message>
    <message>
        <source>Shows kind, colours, size and limits of the fabric</source>
        <translation>Mostra tipo, colori, dimensioni e limiti del tessuto</translation>
    </message>
    <message>
        <source>Picture on the &amp;fabric …</source>
        <translation>Immagine &amp;sul tessuto…</translation>
    </message>
    <message>
        <source>Lets the fabric look like a picture: PNG, JPEG, TIFF or OpenEXR</source>
        <translation>Dà al tessuto l’aspetto di un’immagine: PNG, JPEG, TIFF o OpenEXR</translation>
    </message>
    <message>
        <source>D&amp;uplicate fabric</source>
        <translation>&amp;Duplica tessuto</translation>
    </message>
    <message>
        <source>Adds a copy of the fabric, to be changed</source>
        <translation>Aggiunge una copia del tessuto, da modificare</translation>
    </message>
    <message>
        <source>Rename fa&amp;bric …</source>
        <translation>&amp;Rinomina tessuto…</translation>
    </message>
    <message>
        <source>Gives the fabric another name</source>
        <translation>Dà al tessuto un altro nome</translation>
    </message>
    <message>
        <source>&amp;Delete fabric …</source>
        <translation>&amp;Elimina tessuto…</translation>
    </message>
    <message>
        <source>Removes the fabric; asks what patches get instead</source>
        <translation>Rimuove il tessuto; chiede con che cosa sostituirlo nei pezzi</translation>
    </message>
    <message>
        <source>&amp;Import fabrics …</source>
        <translation>I&amp;mporta tessuti…</translation>
    </message>
    <message>
        <source>Takes over the fabrics of a file, a design or a project</source>
        <translation>Riprende i tessuti di un file, un modello o un progetto</translation>
    </message>
    <message>
        <source>&amp;Export fabric …</source>
        <translation>Esp&amp;orta tessuto…</translation>
    </message>
    <message>
        <source>Writes the fabric to a file, its picture beside it</source>
        <translation>Scrive il tessuto in un file, con accanto la sua immagine</translation>
    </message>
    <message>
        <source>Pre&amp;views</source>
        <translation>Ante&amp;prime</translation>
    </message>
    <message>
        <source>On &amp;cushions</source>
        <translation>Su &amp;cuscini</translation>
    </message>
    <message>
        <source>Shows the fabrics of the library on cushions</source>
        <translation>Mostra i tessuti della raccolta su cuscini</translation>
    </message>
    <message>
        <source>On &amp;balls</source>
        <translation>Su &amp;sfere</translation>
    </message>
    <message>
        <source>Shows the fabrics of the library on balls</source>
        <translation>Mostra i tessuti della raccolta su sfere</translation>
    </message>
    <message>
        <source>&amp;Show colourway</source>
        <translation>Mostra &amp;variante colore</translation>
    </message>
    <message>
        <source>Chooses which fabrics are seen; the shape stays</source>
        <translation>Sceglie quali tessuti si vedono; la forma resta</translation>
    </message>
    <message>
        <source>New &amp;colourway …</source>
        <translation>Nuova variante &amp;colore…</translation>
    </message>
    <message>
        <source>Adds a set of fabrics for the patches; it begins as what is shown now</source>
        <translation>Aggiunge un insieme di tessuti per i pezzi; parte da ciò che si vede ora</translation>
    </message>
    <message>
        <source>Rena&amp;me colourway …</source>
        <translation>Rinomina variante co&amp;lore…</translation>
    </message>
    <message>
        <source>Gives the colourway that is shown another name</source>
        <translation>Dà un altro nome alla variante colore mostrata</translation>
    </message>
    <message>
        <source>De&amp;lete colourway</source>
        <translation>Elimina varian&amp;te colore</translation>
    </message>
    <message>
        <source>Removes the colourway that is shown</source>
        <translation>Rimuove la variante colore mostrata</translation>
    </message>
    <message>
        <source>Compare c&amp;olourways …</source>
        <translation>Con&amp;fronta varianti colore…</translation>
    </message>
    <message>
        <source>Shows two colourways side by side</source>
        <translation>Mostra due varianti colore affiancate</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>Come prodotto</translation>
    </message>
</context>
<context>
    <name>FabricPresets</name>
    <message>
        <source>Leather, cognac</source>
        <translation>Pelle, cognac</translation>
    </message>
    <message>
        <source>Leather, black</source>
        <translation>Pelle, nera</translation>
    </message>
    <message>
        <source>Leather, cream</source>
        <translation>Pelle, crema</translation>
    </message>
    <message>
        <source>Smooth leather, dark brown</source>
        <translation>Pelle liscia, marrone scuro</translation>
    </message>
    <message>
        <source>Smooth leather, red</source>
        <translation>Pelle liscia, rossa</translation>
    </message>
    <message>
        <source>Weave, grey</source>
        <translation>Tela, grigia</translation>
    </message>
    <message>
        <source>Weave, blue</source>
        <translation>Tela, blu</translation>
    </message>
    <message>
        <source>Weave, sand</source>
        <translation>Tela, sabbia</translation>
    </message>
    <message>
        <source>Velvet, green</source>
        <translation>Velluto, verde</translation>
    </message>
    <message>
        <source>Velvet, petrol</source>
        <translation>Velluto, petrolio</translation>
    </message>
    <message>
        <source>Checker, 20 mm</source>
        <translation>Quadri, 20&#xa0;mm</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Tinta unita</translation>
    </message>
</context>
<context>
    <name>FancySeamForm</name>
    <message>
        <source>Patch</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lunghezza</translation>
    </message>
    <message>
        <source>It stands out: a welt.</source>
        <translation>Sporge: una nervatura.</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>Patch</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Tessuto</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Tessuti</translation>
    </message>
    <message>
        <source>Press harder</source>
        <translation>Premono di più</translation>
    </message>
    <message>
        <source>Press like straight ones</source>
        <translation>Premono come le diritte</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Telaio</translation>
    </message>
    <message>
        <source>Padded parts</source>
        <translation>Parti imbottite</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Preme</translation>
    </message>
    <message>
        <source>Smallest detail</source>
        <translation>Dettaglio minimo</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>Imbottitura</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Forza</translation>
    </message>
    <message>
        <source>Slanted faces</source>
        <translation>Facce oblique</translation>
    </message>
    <message>
        <source>Pushes the cover</source>
        <translation>Preme sul rivestimento</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Tinta unita</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>A quadri</translation>
    </message>
    <message>
        <source>Smooth leather</source>
        <translation>Pelle liscia</translation>
    </message>
    <message>
        <source>Grained leather</source>
        <translation>Pelle martellata</translation>
    </message>
    <message>
        <source>Woven</source>
        <translation>Tela</translation>
    </message>
    <message>
        <source>Velvet</source>
        <translation>Velluto</translation>
    </message>
    <message>
        <source>Picture …</source>
        <translation>Immagine…</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Second colour</source>
        <translation>Secondo colore</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Ruvidità</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Scala</translation>
    </message>
    <message>
        <source>Turned from the grain</source>
        <translation>Ruotato dal drittofilo</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>Rilievo</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Most along the grain</source>
        <translation>Max in drittofilo</translation>
    </message>
    <message>
        <source>Most across</source>
        <translation>Max in traverso</translation>
    </message>
    <message>
        <source>Most shear</source>
        <translation>Max scorrimento</translation>
    </message>
    <message>
        <source>Poisson</source>
        <translation>Poisson</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidezza</translation>
    </message>
    <message>
        <source>Bending length</source>
        <translation>Lunghezza di flessione</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Colore</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aspetto</translation>
    </message>
    <message>
        <source>Strain limits</source>
        <translation>Limiti di deformazione</translation>
    </message>
    <message>
        <source>Mirror twin</source>
        <translation>Gemello speculare</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>On the curve</source>
        <translation>Sulla curva</translation>
    </message>
    <message>
        <source>Curve runs backwards</source>
        <translation>Curva invertita</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direzione</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Peso</translation>
    </message>
    <message>
        <source>Curve in space</source>
        <translation>Curva nello spazio</translation>
    </message>
    <message>
        <source>Round – a soft groove</source>
        <translation>Tondo – un solco morbido</translation>
    </message>
    <message>
        <source>Sharp – a crease</source>
        <translation>Vivo – una piega</translation>
    </message>
    <message>
        <source>Welt – between creases</source>
        <translation>Nervatura – tra due pieghe</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Larghezza</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondità</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profilo</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posizione</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotazione</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Drittofilo</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Pressione</translation>
    </message>
    <message>
        <source>Wrong side out</source>
        <translation>Rovescio all’esterno</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Legno</translation>
    </message>
    <message>
        <source>Metal</source>
        <translation>Metallo</translation>
    </message>
    <message>
        <source>Plastic</source>
        <translation>Plastica</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>Espanso</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiale</translation>
    </message>
    <message>
        <source>Keeps the cover outside</source>
        <translation>Tiene fuori il rivestimento</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Distanza</translation>
    </message>
    <message>
        <source>Hidden parts</source>
        <translation>Parti nascoste</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Blocco</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Cilindro</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Sfera</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Mesh</translation>
    </message>
    <message>
        <source>Cushion</source>
        <translation>Imbottitura</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Dimensioni</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Ritagliato</translation>
    </message>
    <message>
        <source>Along the normal</source>
        <translation>Lungo la normale</translation>
    </message>
    <message>
        <source>To the point itself</source>
        <translation>Al punto stesso</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Soglia</translation>
    </message>
    <message>
        <source>Fit the cover to it</source>
        <translation>Adatta il rivestimento</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Trazione</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Ritagli</translation>
    </message>
    <message>
        <source>C0 – an edge</source>
        <translation>C0 – uno spigolo</translation>
    </message>
    <message>
        <source>C1 – smooth, texture too</source>
        <translation>C1 – liscio, anche la trama</translation>
    </message>
    <message>
        <source>G1 – rounded</source>
        <translation>G1 – arrotondato</translation>
    </message>
    <message>
        <source>First stretch</source>
        <translation>Primo tratto</translation>
    </message>
    <message>
        <source>Second stretch</source>
        <translation>Secondo tratto</translation>
    </message>
    <message>
        <source>Second side runs backwards</source>
        <translation>Secondo lato invertito</translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation>Continuità</translation>
    </message>
    <message>
        <source>Mesh edges</source>
        <translation>Lati della mesh</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Simmetria</translation>
    </message>
    <message>
        <source>Colourway shown</source>
        <translation>Variante mostrata</translation>
    </message>
    <message>
        <source>Begins at</source>
        <translation>Inizia a</translation>
    </message>
    <message>
        <source>Ends at</source>
        <translation>Finisce a</translation>
    </message>
    <message>
        <source>By length</source>
        <translation>Per lunghezza</translation>
    </message>
    <message>
        <source>By parameter</source>
        <translation>Per parametro</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Corrispondenza</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nessuna</translation>
    </message>
    <message>
        <source>Single row</source>
        <translation>Una fila</translation>
    </message>
    <message>
        <source>Twin rows</source>
        <translation>Due file</translation>
    </message>
    <message>
        <source>Stitches</source>
        <translation>Impunture</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>Filo</translation>
    </message>
    <message>
        <source>Stitch length</source>
        <translation>Lunghezza punto</translation>
    </message>
    <message>
        <source>Distance from the seam</source>
        <translation>Distanza dalla cucitura</translation>
    </message>
    <message>
        <source>Thread width</source>
        <translation>Spessore filo</translation>
    </message>
    <message>
        <source>Radius (0: none)</source>
        <translation>Raggio (0: nessuno)</translation>
    </message>
    <message>
        <source>Seam allowance</source>
        <translation>Margine di cucitura</translation>
    </message>
    <message>
        <source>The cover dips into the seam</source>
        <translation>Il rivestimento scende nella cucitura</translation>
    </message>
    <message>
        <source>Trim</source>
        <translation>Finitura</translation>
    </message>
    <message>
        <source> mm per unit</source>
        <translation> mm per unità</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuno</translation>
    </message>
    <message>
        <source>The frame that is padded</source>
        <translation>Il telaio che viene imbottito</translation>
    </message>
    <message>
        <source>Which cover the padding presses outwards</source>
        <translation>Quale rivestimento l’imbottitura preme verso l’esterno</translation>
    </message>
    <message>
        <source>How finely the frame is looked at: what is thinner may stay without padding</source>
        <translation>Quanto finemente si esamina il telaio: ciò che è più sottile può restare senza imbottitura</translation>
    </message>
    <message>
        <source>How thick the padding around the frame is</source>
        <translation>Spessore dell’imbottitura intorno al telaio</translation>
    </message>
    <message>
        <source>How hard the padding presses the cover outwards; from about 2 on it gives no more</source>
        <translation>Con quale forza l’imbottitura preme il rivestimento verso l’esterno; da circa 2 in poi non cambia più</translation>
    </message>
    <message>
        <source>How padding presses that is aslant to width, depth and height: harder fills the cover more</source>
        <translation>Come preme l’imbottitura obliqua rispetto a larghezza, profondità e altezza: se preme di più, riempie meglio il rivestimento</translation>
    </message>
    <message>
        <source>How thick the padding around this foam is</source>
        <translation>Spessore dell’imbottitura intorno a questo espanso</translation>
    </message>
    <message>
        <source>How hard this foam presses the cover outwards; from about 2 on it gives no more</source>
        <translation>Con quale forza questo espanso preme il rivestimento verso l’esterno; da circa 2 in poi non cambia più</translation>
    </message>
    <message>
        <source>Takes this shape out of the cushion instead of adding it</source>
        <translation>Toglie questa forma dall’imbottitura invece di aggiungerla</translation>
    </message>
    <message>
        <source>as made</source>
        <translation>come prodotto</translation>
    </message>
    <message>
        <source>Stitching</source>
        <translation>Impuntura</translation>
    </message>
    <message>
        <source>Thread colour</source>
        <translation>Colore del filo</translation>
    </message>
    <message>
        <source>Stitch distance</source>
        <translation>Distanza dei punti</translation>
    </message>
    <message>
        <source>Piping radius</source>
        <translation>Raggio del bordino</translation>
    </message>
    <message>
        <source>Piping fabric</source>
        <translation>Tessuto del bordino</translation>
    </message>
    <message>
        <source>Valley</source>
        <translation>Avvallamento</translation>
    </message>
    <message>
        <source>Mitred – to a point</source>
        <translation>Angolo vivo – a punta</translation>
    </message>
    <message>
        <source>Square – cut off</source>
        <translation>Squadrato – troncato</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>Arrotondato</translation>
    </message>
    <message>
        <source>Folded – lies under the piece</source>
        <translation>Ripiegato – sta sotto il pezzo</translation>
    </message>
    <message>
        <source>Stepped</source>
        <translation>A gradino</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Margine</translation>
    </message>
    <message>
        <source>From the sewing line to the line where the fabric is cut.</source>
        <translation>Dalla linea di cucitura alla linea dove si taglia il tessuto.</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Angoli</translation>
    </message>
    <message>
        <source>Corners of the cut line</source>
        <translation>Angoli della linea di taglio</translation>
    </message>
    <message>
        <source>as the design&apos;s</source>
        <translation>come nel modello</translation>
    </message>
    <message>
        <source>Lies at</source>
        <translation>Si trova a</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Angolo</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diametro</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Taglietto</translation>
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
        <translation>Rettangolo</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>Tacca</translation>
    </message>
    <message>
        <source>Depth of notches</source>
        <translation>Profondità tacche</translation>
    </message>
    <message>
        <source>Width of notches</source>
        <translation>Larghezza tacche</translation>
    </message>
    <message>
        <source>Notches along seams every</source>
        <translation>Tacche lungo le cuciture ogni</translation>
    </message>
    <message>
        <source>Notches at ends of seams</source>
        <translation>Tacche alle estremità</translation>
    </message>
    <message>
        <source>Notches that tell halves apart</source>
        <translation>Tacche che distinguono le metà</translation>
    </message>
    <message>
        <source>Two side by side</source>
        <translation>Due affiancate</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Taglio</translation>
    </message>
    <message>
        <source>Label at</source>
        <translation>Etichetta a</translation>
    </message>
    <message>
        <source>Label turned by</source>
        <translation>Etichetta ruotata di</translation>
    </message>
    <message>
        <source>Two ways – either end up</source>
        <translation>Due sensi – testa in su o in giù</translation>
    </message>
    <message>
        <source>One way – one end up</source>
        <translation>Senso unico – testa in su</translation>
    </message>
    <message>
        <source>Any direction</source>
        <translation>Qualsiasi direzione</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Quantità</translation>
    </message>
    <message>
        <source>Mirrored pair</source>
        <translation>Coppia speculare</translation>
    </message>
    <message>
        <source>Nap</source>
        <translation>Verso del pelo</translation>
    </message>
    <message>
        <source>Grain may be off by</source>
        <translation>Drittofilo può deviare di</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Etichetta</translation>
    </message>
    <message>
        <source>where it finds room</source>
        <translation>dove c’è spazio</translation>
    </message>
    <message>
        <source>Usable width</source>
        <translation>Altezza utile</translation>
    </message>
    <message>
        <source>Shrinks along</source>
        <translation>Ritiro in lungo</translation>
    </message>
    <message>
        <source>Pieces are cut so much larger along the grain that they have their size when the fabric has shrunk.</source>
        <translation>I pezzi si tagliano più grandi in drittofilo, così da avere la loro misura dopo il ritiro del tessuto.</translation>
    </message>
    <message>
        <source>Shrinks across</source>
        <translation>Ritiro in traverso</translation>
    </message>
    <message>
        <source>10 mm</source>
        <translation>10&#xa0;mm</translation>
    </message>
    <message>
        <source>Automatic notches</source>
        <translation>Tacche automatiche</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Articolo</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Versione</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Tracciata</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Tagliata</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Omessa</translation>
    </message>
    <message>
        <source>On the cutting table</source>
        <translation>Sul tavolo da taglio</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guida</translation>
    </message>
    <message>
        <source>Top stitching</source>
        <translation>Impuntura</translation>
    </message>
    <message>
        <source>Tie-down strip</source>
        <translation>Striscia di tiraggio</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Piega</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>Scopo</translation>
    </message>
    <message>
        <source>Ease wanted</source>
        <translation>Lentezza voluta</translation>
    </message>
    <message>
        <source>How much longer the second side shall be than the first one: it is gathered when it is sewn.</source>
        <translation>Di quanto il secondo lato deve essere più lungo del primo: l’eccesso si riprende in cucitura.</translation>
    </message>
    <message>
        <source>Bulge of the allowance</source>
        <translation>Rigonfiamento del margine</translation>
    </message>
    <message>
        <source>With a zip</source>
        <translation>Con cerniera</translation>
    </message>
    <message>
        <source>A zip joins the two sides; the sewing sheet tells its length.</source>
        <translation>Una cerniera unisce i due lati; la scheda di cucitura ne indica la lunghezza.</translation>
    </message>
    <message>
        <source>Step in sewing</source>
        <translation>Fase di cucitura</translation>
    </message>
    <message>
        <source>Seams with a number are sewn first, smaller ones before larger ones. 0: as the program proposes it.</source>
        <translation>Le cuciture con un numero si eseguono per prime, dal numero minore al maggiore. 0: come propone il programma.</translation>
    </message>
    <message>
        <source>How near a point of the scan must be to pull at the cover. What the scan has not seen stays as the pattern makes it.</source>
        <translation>Quanto vicino deve essere un punto della scansione per tirare il rivestimento. Ciò che la scansione non ha visto resta come lo determina il cartamodello.</translation>
    </message>
    <message>
        <source>How firmly the scan pulls at the cover, against the pattern: more follows finer detail, and more of the noise.</source>
        <translation>Con quale forza la scansione tira il rivestimento, contro il cartamodello: un valore maggiore segue più i dettagli fini, ma anche il rumore.</translation>
    </message>
    <message>
        <source>The cover is pulled to the scan. Without that it is only measured. Align the scan first.</source>
        <translation>Il rivestimento viene tirato verso la scansione. Altrimenti si misura soltanto. Allineare prima la scansione.</translation>
    </message>
    <message>
        <source>To its surface: the cover may slide along it. To its points: it may not, which suits scans with few points.</source>
        <translation>Alla superficie: il rivestimento può scorrervi sopra. Ai punti: non può, il che si addice a scansioni con pochi punti.</translation>
    </message>
    <message>
        <source>For whoever works on the design: it changes neither the cover nor what is cut</source>
        <translation>Per chi lavora al progetto: non cambia né il rivestimento né ciò che si taglia</translation>
    </message>
    <message>
        <source>Line on the label</source>
        <translation>Riga sull’etichetta</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Da</translation>
    </message>
    <message>
        <source>To</source>
        <translation>A</translation>
    </message>
    <message>
        <source>A filling that presses from inside. 0.05 to 0.3 fills a cushion; at 1 most fabrics are stretched too far.</source>
        <translation>Un’imbottitura che preme dall’interno. Da 0,05 a 0,3 riempie un cuscino; a 1 la maggior parte dei tessuti è stirata troppo.</translation>
    </message>
    <message>
        <source>How long the edges of the triangles are: shorter ones show smaller folds, and take longer.</source>
        <translation>Quanto sono lunghi i lati dei triangoli: più corti mostrano pieghe più piccole e richiedono più tempo.</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nuovo</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>&amp;Apri…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Esci</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Apri &amp;recenti</translation>
    </message>
    <message>
        <source>&amp;Unsaved work</source>
        <translation>&amp;Lavoro non salvato</translation>
    </message>
    <message>
        <source>Sa&amp;mples</source>
        <translation>Esem&amp;pi</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Salva</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>Salva &amp;con nome…</translation>
    </message>
    <message>
        <source>Save a &amp;copy</source>
        <translation>Salva una c&amp;opia</translation>
    </message>
    <message>
        <source>With &amp;everything …</source>
        <translation>Con &amp;tutto…</translation>
    </message>
    <message>
        <source>Without &amp;history …</source>
        <translation>Senza &amp;cronologia…</translation>
    </message>
    <message>
        <source>Without history and &amp;scans …</source>
        <translation>Senza cronologia e &amp;scansioni…</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>Torna al sal&amp;vato</translation>
    </message>
    <message>
        <source>&amp;Import frame …</source>
        <translation>&amp;Importa telaio…</translation>
    </message>
    <message>
        <source>Impor&amp;t scan …</source>
        <translation>I&amp;mporta scansione…</translation>
    </message>
    <message>
        <source>&amp;Export surface …</source>
        <translation>Esporta s&amp;uperficie…</translation>
    </message>
    <message>
        <source>Export &amp;picture …</source>
        <translation>Esporta imma&amp;gine…</translation>
    </message>
    <message>
        <source>Ren&amp;der picture …</source>
        <translation>Ren&amp;derizza immagine…</translation>
    </message>
    <message>
        <source>E&amp;xport pattern …</source>
        <translation>Esporta car&amp;tamodello…</translation>
    </message>
    <message>
        <source>Import pattern (DX&amp;F, SVG) …</source>
        <translation>Importa cartamodello (DX&amp;F, SVG)…</translation>
    </message>
    <message>
        <source>Export cover (&amp;HTML, glTF, STL) …</source>
        <translation>Esporta rivestimento (&amp;HTML, glTF, STL)…</translation>
    </message>
    <message>
        <source>Export foam &amp;body …</source>
        <translation>Esporta corp&amp;o di espanso…</translation>
    </message>
    <message>
        <source>Print view …</source>
        <translation>Stampa vista…</translation>
    </message>
</context>
<context>
    <name>FileFormats</name>
    <message>
        <source>Page for the customer</source>
        <translation>Pagina per il cliente</translation>
    </message>
    <message>
        <source>USDZ, for phones</source>
        <translation>USDZ, per telefoni</translation>
    </message>
    <message>
        <source>OBJ with materials</source>
        <translation>OBJ con materiali</translation>
    </message>
    <message>
        <source>STL, with a thickness</source>
        <translation>STL, con spessore</translation>
    </message>
    <message>
        <source>3MF, with a thickness</source>
        <translation>3MF, con spessore</translation>
    </message>
    <message>
        <source>STEP, curves alone</source>
        <translation>STEP, solo curve</translation>
    </message>
    <message>
        <source>STEP, of flat faces</source>
        <translation>STEP, a facce piane</translation>
    </message>
</context>
<context>
    <name>FixationCurveForm</name>
    <message>
        <source>Length</source>
        <translation>Lunghezza</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punti</translation>
    </message>
</context>
<context>
    <name>FixationDrawTool</name>
    <message>
        <source>A curve needs two points, a closed one three.</source>
        <translation>Una curva richiede due punti, una chiusa tre.</translation>
    </message>
    <message>
        <source>Fixation %1</source>
        <translation>Fissaggio %1</translation>
    </message>
    <message>
        <source>Click to close the curve</source>
        <translation>Clic per chiudere la curva</translation>
    </message>
    <message>
        <source>There is neither a frame nor the cover here: click on one, or type x, y, z.</source>
        <translation>Qui non c’è né un telaio né il rivestimento: fare clic su uno dei due o digitare x, y, z.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no place: try 250, -100, 40</source>
        <translation>«%1» non è una posizione: ad esempio 250, -100, 40</translation>
    </message>
    <message>
        <source>Enter sets the point: x, y, z – without z it is as high as the last one</source>
        <translation>Invio fissa il punto: x, y, z – senza z ha l’altezza del precedente</translation>
    </message>
    <message>
        <source>Click on a frame to begin a fixation curve, or type x, y, z – drag turns the view, Esc ends the tool</source>
        <translation>Fare clic su un telaio per iniziare una curva di fissaggio o digitare x, y, z – trascinare ruota la vista, Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>Click or type the next point, Enter ends, C closes – B makes it straight, Backspace takes a point back</source>
        <translation>Fare clic o digitare il punto successivo, Invio termina, C chiude – B rende dritto, Backspace toglie un punto</translation>
    </message>
    <message>
        <source>Click or type the next point, Enter ends, C closes – straight from point to point, whatever lies between: B makes it smooth along the surface, Backspace takes a point back</source>
        <translation>Fare clic o digitare il punto successivo, Invio termina, C chiude – dritto da punto a punto, qualunque cosa vi sia in mezzo: B segue la superficie, Backspace toglie un punto</translation>
    </message>
    <message>
        <source>&amp;Close the curve</source>
        <translation>&amp;Chiudi la curva</translation>
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
        <translation>Curva</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>On the curve</source>
        <translation>Sulla curva</translation>
    </message>
</context>
<context>
    <name>FixationsLeft</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>e un’altra (%n)</numerusform>
            <numerusform>e altre %n</numerusform>
        </translation>
    </message>
    <message>
        <source>They stay where they are. Drag their points onto the frame, or undo the change.</source>
        <translation>Restano dove sono. Trascinare i loro punti sul telaio o annullare la modifica.</translation>
    </message>
    <message numerus="yes">
        <source>%n fixation curve(s) no longer lie on the frame.</source>
        <translation>
            <numerusform>%n curva di fissaggio non è più sul telaio.</numerusform>
            <numerusform>%n curve di fissaggio non sono più sul telaio.</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1”: its edge is up to %2 away</source>
        <translation>«%1»: il suo lato dista fino a %2</translation>
    </message>
    <message>
        <source>“%1”: up to %2</source>
        <translation>«%1»: fino a %2</translation>
    </message>
    <message>
        <source>“%1”: more than %2</source>
        <translation>«%1»: più di %2</translation>
    </message>
</context>
<context>
    <name>FixingCommands</name>
    <message>
        <source>&amp;Create fixation curve</source>
        <translation>&amp;Crea curva di fissaggio</translation>
    </message>
    <message>
        <source>Select two points of an outline first: what lies between them is fixed.</source>
        <translation>Selezionare prima due punti di un contorno: viene fissato ciò che sta in mezzo.</translation>
    </message>
    <message>
        <source>Fixation %1</source>
        <translation>Fissaggio %1</translation>
    </message>
    <message>
        <source>There is no surface of this patch yet on which the curve could lie.</source>
        <translation>Questo pezzo non ha ancora una superficie su cui la curva possa stare.</translation>
    </message>
</context>
<context>
    <name>FoamForm</name>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
</context>
<context>
    <name>FormPatternReport</name>
    <message numerus="yes">
        <source>(and %n more)</source>
        <translation>
            <numerusform>(e %n altro)</numerusform>
            <numerusform>(e %n altri)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n pezzo</numerusform>
            <numerusform>%n pezzi</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seams, whose sides are equally long</source>
        <translation>
            <numerusform>%n cucitura, i cui lati sono ugualmente lunghi</numerusform>
            <numerusform>%n cuciture, i cui lati sono ugualmente lunghi</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seams, whose sides differ by %1 at most</source>
        <translation>
            <numerusform>%n cucitura, i cui lati differiscono al massimo di %1</numerusform>
            <numerusform>%n cuciture, i cui lati differiscono al massimo di %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Its cover at rest lies up to %1 beside the form, where nothing holds it: tick &quot;Keeps the cover outside&quot; at the frame, or hold it by a fixation.</source>
        <translation>Il suo rivestimento a riposo sta fino a %1 accanto alla forma, dove niente lo tiene: spuntare «Tiene fuori il rivestimento» nel telaio, o tenerlo con un fissaggio.</translation>
    </message>
    <message>
        <source>Its cover at rest lies up to %1 beside the form, where nothing holds it: hold it by a fixation, or give its pieces pressure.</source>
        <translation>Il suo rivestimento a riposo sta fino a %1 accanto alla forma, dove niente lo tiene: tenerlo con un fissaggio, o dare pressione ai suoi pezzi.</translation>
    </message>
    <message>
        <source>Its cover is being solved …</source>
        <translation>Il suo rivestimento viene calcolato …</translation>
    </message>
    <message>
        <source>Its cover does not come to rest.</source>
        <translation>Il suo rivestimento non trova riposo.</translation>
    </message>
    <message>
        <source>Its cover at rest is strained no more than the fabric may be.</source>
        <translation>Il suo rivestimento a riposo non è più teso di quanto il tessuto consenta.</translation>
    </message>
    <message>
        <source>What counts is its cover at rest: %1</source>
        <translation>Ciò che conta è il suo rivestimento a riposo: %1</translation>
    </message>
    <message>
        <source>Laid on the form by itself no piece is strained so much. Narrow tips and steps of a line do that, or mesh edges that are long for them.</source>
        <translation>Posato da solo sulla forma, nessun pezzo è così deformato. Lo fanno punte strette e gradini di una linea, o lati della mesh lunghi per essi.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more are left out, too</source>
        <translation>
            <numerusform>e anche %n altro è escluso</numerusform>
            <numerusform>e anche %n altri sono esclusi</numerusform>
        </translation>
    </message>
    <message>
        <source>Laid on the form by itself most strained: %1, %2 (rms), %3 within 99 % of its area, %4 where it is most</source>
        <translation>Posato da solo sulla forma, più deformato: %1, %2 (rms), %3 sul 99 % della sua area, %4 dove è massimo</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces are strained by more than the fabric may be in more than a hundredth of their area (yellow): divide them, or cut them in there.</source>
        <translation>
            <numerusform>%n pezzo è deformato su più di un centesimo della sua superficie più di quanto ammette il tessuto (giallo): dividerlo o inciderlo lì.</numerusform>
            <numerusform>%n pezzi sono deformati su più di un centesimo della loro superficie più di quanto ammette il tessuto (giallo): dividerli o inciderli lì.</numerusform>
        </translation>
    </message>
    <message>
        <source>Its cover will have about %1 vertices, and is not solved here: with mesh edges of %2 it is.</source>
        <translation>Il suo rivestimento avrà circa %1 vertici e non viene calcolato qui: con lati della mesh di %2 sì.</translation>
    </message>
    <message>
        <source>So that the cover does not sink into the frame, tick &quot;Keeps the cover outside&quot; at the frame.</source>
        <translation>Perché il rivestimento non affondi nel telaio, spuntare «Tiene fuori il rivestimento» nel telaio.</translation>
    </message>
    <message>
        <source>With shorter mesh edges smaller pieces are divided, too.</source>
        <translation>Con spigoli della mesh più corti si dividono anche pezzi più piccoli.</translation>
    </message>
    <message>
        <source>Tick &quot;where it would not lie flat&quot;: that finds where to divide them.</source>
        <translation>Spuntate «dove non starebbe in piano»: trova dove dividerli.</translation>
    </message>
    <message>
        <source>The form is taken as %1 large. If that is wrong, import the file as a frame.</source>
        <translation>La forma è presa con una dimensione di %1. Se non è giusto, importi il file come telaio.</translation>
    </message>
</context>
<context>
    <name>FrameEdgeCommands</name>
    <message>
        <source>Fixation curve along an &amp;edge</source>
        <translation>Curva di fissaggio lungo uno &amp;spigolo</translation>
    </message>
    <message>
        <source>Click an edge of a frame: of STEP and IGES the edges of its faces, exactly; of others where their triangles bend</source>
        <translation>Fare clic su uno spigolo di un telaio: per STEP e IGES gli spigoli esatti delle facce; per gli altri dove i triangoli si piegano</translation>
    </message>
    <message>
        <source>Looking for the edges of the frames …</source>
        <translation>Ricerca degli spigoli dei telai…</translation>
    </message>
    <message>
        <source>The frames have no edges: they are smooth everywhere, or are not read yet.</source>
        <translation>I telai non hanno spigoli: sono lisci ovunque o non ancora letti.</translation>
    </message>
</context>
<context>
    <name>FrameEdgeTool</name>
    <message>
        <source>Fixation %1</source>
        <translation>Fissaggio %1</translation>
    </message>
    <message>
        <source>Click an edge of a frame to make a fixation curve of it – drag turns the view, Esc ends the tool</source>
        <translation>Fare clic su uno spigolo di un telaio per farne una curva di fissaggio – trascinare ruota la vista, Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>Click to make a fixation curve of this edge – Ctrl takes it alone, without those in which it goes on smoothly</source>
        <translation>Clic per fare di questo spigolo una curva di fissaggio – Ctrl prende solo questo, senza quelli in cui prosegue liscio</translation>
    </message>
    <message>
        <source>There is no edge of a frame here. A curve of your own: Frame &gt; Draw fixation curve.</source>
        <translation>Qui non c’è alcuno spigolo di un telaio. Una curva propria: Telaio &gt; Disegna curva di fissaggio.</translation>
    </message>
</context>
<context>
    <name>FrameForm</name>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Choose an&amp;other file …</source>
        <translation>Scegli un &amp;altro file…</translation>
    </message>
    <message>
        <source>Colour of the frame</source>
        <translation>Colore del telaio</translation>
    </message>
</context>
<context>
    <name>FrameParts</name>
    <message>
        <source>Mesh</source>
        <translation>Mesh</translation>
    </message>
    <message>
        <source>Piece %1: %2</source>
        <translation>Pezzo %1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n piece(s)</source>
        <translation>
            <numerusform>%1: %n pezzo</numerusform>
            <numerusform>%1: %n pezzi</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Parti</translation>
    </message>
    <message>
        <source>Show a&amp;ll parts</source>
        <translation>Mostra &amp;tutte le parti</translation>
    </message>
    <message>
        <source>Parts without a mark are left out: they are not drawn, and neither drawing along the frame nor cushioning nor contact knows them.</source>
        <translation>Le parti senza segno di spunta sono escluse: non vengono disegnate e sono ignorate dal disegno sul telaio, dall’imbottitura e dal contatto.</translation>
    </message>
    <message>
        <source>%1: not in this frame</source>
        <translation>%1: non in questo telaio</translation>
    </message>
    <message>
        <source>Padded parts</source>
        <translation>Parti imbottite</translation>
    </message>
    <message>
        <source>Without a mark, those parts are padded that the cover is fixed to.</source>
        <translation>Senza segno di spunta si imbottiscono le parti a cui è fissato il rivestimento.</translation>
    </message>
    <message>
        <source>This frame is large: the smallest detail can be %1 here.</source>
        <translation>Questo telaio è grande: qui il dettaglio minimo può essere %1.</translation>
    </message>
</context>
<context>
    <name>HandleCurveForm</name>
    <message>
        <source>Patch</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>Nel cartamodello</translation>
    </message>
    <message>
        <source>In space</source>
        <translation>Nello spazio</translation>
    </message>
    <message>
        <source>free</source>
        <translation>libera</translation>
    </message>
</context>
<context>
    <name>HelpCommands</name>
    <message>
        <source>&amp;Find a command …</source>
        <translation>&amp;Trova un comando…</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse …</source>
        <translation>Tasti e &amp;mouse…</translation>
    </message>
    <message>
        <source>&amp;Edit shortcuts …</source>
        <translation>Modifica &amp;scorciatoie…</translation>
    </message>
    <message>
        <source>&amp;About Bolster</source>
        <translation>&amp;Informazioni su Bolster</translation>
    </message>
</context>
<context>
    <name>HelpDialogs</name>
    <message>
        <source>Select</source>
        <translation>Selezionare</translation>
    </message>
    <message>
        <source>click; Shift+click adds; drag a box</source>
        <translation>clic; Maiusc+clic aggiunge; trascinare un riquadro</translation>
    </message>
    <message>
        <source>Move control points or patches</source>
        <translation>Spostare punti di controllo o pezzi</translation>
    </message>
    <message>
        <source>drag; Shift keeps to one axis; Esc takes it back</source>
        <translation>trascinare; Maiusc mantiene un asse; Esc annulla</translation>
    </message>
    <message>
        <source>Turn patches</source>
        <translation>Ruotare pezzi</translation>
    </message>
    <message>
        <source>drag the round handle; Shift in steps of 15°</source>
        <translation>trascinare la maniglia tonda; Maiusc a passi di 15°</translation>
    </message>
    <message>
        <source>Add a control point</source>
        <translation>Aggiungere un punto di controllo</translation>
    </message>
    <message>
        <source>arrow keys, Shift+arrow keys</source>
        <translation>tasti freccia, Maiusc+tasti freccia</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Spostare la vista</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Ruotare</translation>
    </message>
    <message>
        <source>A workbench for people who design upholstered furniture and car seats: a sewing pattern, its seams and its fixation on the frame become the cover, live.</source>
        <translation>Un banco di lavoro per chi progetta mobili imbottiti e sedili per auto: un cartamodello, le sue cuciture e il suo fissaggio al telaio diventano il rivestimento, dal vivo.</translation>
    </message>
    <message>
        <source>The surface is computed after the published method of sewing patterns on static constraints; docs/solver.md names the paper and what is different.</source>
        <translation>La superficie è calcolata con il metodo pubblicato per cartamodelli con vincoli statici; docs/solver.md indica l’articolo e le differenze.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. It comes without any warranty. Built with Qt, Eigen, CGAL, SuiteSparse, Embree and OpenImageIO.</source>
        <translation>Software libero con licenza GNU General Public License, versione 3 o successiva. Fornito senza alcuna garanzia. Realizzato con Qt, Eigen, CGAL, SuiteSparse, Embree e OpenImageIO.</translation>
    </message>
    <message>
        <source>About Bolster</source>
        <translation>Informazioni su Bolster</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>Nel cartamodello</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>Nella vista 3D</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasti</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasti e mouse</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1&#xa0;ms</translation>
    </message>
    <message>
        <source>Patches, seams</source>
        <translation>Pezzi, cuciture</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Vertices after sewing</source>
        <translation>Vertici dopo la cucitura</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangoli</translation>
    </message>
    <message>
        <source>Vertices held by fixations</source>
        <translation>Vertici fissati</translation>
    </message>
    <message>
        <source>Sewn pairs</source>
        <translation>Coppie cucite</translation>
    </message>
    <message>
        <source>Largest gap at seams</source>
        <translation>Distacco massimo nelle cuciture</translation>
    </message>
    <message>
        <source>Largest distance from fixations</source>
        <translation>Distanza massima dai fissaggi</translation>
    </message>
    <message>
        <source>Curves to fixed outlines between vertices</source>
        <translation>Curve rispetto ai contorni fissati tra i vertici</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>Area of the cover, of the pattern</source>
        <translation>Area di rivestimento e cartamodello</translation>
    </message>
    <message>
        <source>Turned triangles</source>
        <translation>Triangoli ribaltati</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterazioni</translation>
    </message>
    <message>
        <source>Triangulation</source>
        <translation>Triangolazione</translation>
    </message>
    <message>
        <source>Assembly and factorisation</source>
        <translation>Assemblaggio e fattorizzazione</translation>
    </message>
    <message>
        <source>One iteration</source>
        <translation>Una iterazione</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Mesh</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>Computation</source>
        <translation>Calcolo</translation>
    </message>
    <message>
        <source>Figures of the surface</source>
        <translation>Dati della superficie</translation>
    </message>
    <message>
        <source>Strain: root mean square, 99 %, largest</source>
        <translation>Deformazione: media quadratica, 99&#xa0;%, massima</translation>
    </message>
    <message>
        <source>double click on an outline or curve</source>
        <translation>doppio clic su un contorno o una curva</translation>
    </message>
    <message>
        <source>Draw a handle curve or a fancy seam</source>
        <translation>Disegnare una curva maniglia o una cucitura decorativa</translation>
    </message>
    <message>
        <source>click points; Enter or double click ends; click the first one to close; B: straight or smooth</source>
        <translation>clic sui punti; Invio o doppio clic termina; clic sul primo chiude; B: dritto o curvo</translation>
    </message>
    <message>
        <source>Move control points of curves</source>
        <translation>Spostare punti di controllo di curve</translation>
    </message>
    <message>
        <source>Sew</source>
        <translation>Cucire</translation>
    </message>
    <message>
        <source>click two edges; drag or Shift+click takes a part of one; Ctrl+click several in a row, Enter sews them; F: flip</source>
        <translation>clic su due lati; trascinare o Maiusc+clic ne prende una parte; Ctrl+clic più lati di seguito, Invio li cuce; F: inverte</translation>
    </message>
    <message>
        <source>Attach to the selected fixation curve</source>
        <translation>Fissare alla curva di fissaggio selezionata</translation>
    </message>
    <message>
        <source>Draw an outline</source>
        <translation>Disegnare un contorno</translation>
    </message>
    <message>
        <source>click corners, drag smooth points, or type 500, 500&lt;30 or 120, 40; Enter or a click on the first point closes</source>
        <translation>clic per gli angoli, trascinare per punti curvi, o digitare 500, 500&lt;30 oppure 120, 40; Invio o un clic sul primo punto chiude</translation>
    </message>
    <message>
        <source>Not snapped</source>
        <translation>Senza aggancio</translation>
    </message>
    <message>
        <source>hold Ctrl or Alt</source>
        <translation>tenere premuto Ctrl o Alt</translation>
    </message>
    <message>
        <source>Select in a loop</source>
        <translation>Selezionare con il lazo</translation>
    </message>
    <message>
        <source>Alt and drag</source>
        <translation>Alt e trascinare</translation>
    </message>
    <message>
        <source>Next patch or control point, previous one</source>
        <translation>Pezzo o punto di controllo successivo, precedente</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Maiusc+Tab</translation>
    </message>
    <message>
        <source>drag; those on a frame stay on it: Ctrl lifts them off, S lets go; X, Y, Z keep to an axis</source>
        <translation>trascinare; quelli su un telaio vi restano: Ctrl li solleva, S li rilascia; X, Y, Z mantengono un asse</translation>
    </message>
    <message>
        <source>Draw a fixation curve</source>
        <translation>Disegnare una curva di fissaggio</translation>
    </message>
    <message>
        <source>click points on a frame; Enter or double click ends; click the first one to close</source>
        <translation>clic su punti di un telaio; Invio o doppio clic termina; clic sul primo chiude</translation>
    </message>
    <message>
        <source>Move the ends of a seam or fixation</source>
        <translation>Spostare le estremità di una cucitura o un fissaggio</translation>
    </message>
    <message>
        <source>select it and drag the round handles at its ends</source>
        <translation>selezionare e trascinare le maniglie tonde alle estremità</translation>
    </message>
    <message>
        <source>Stitch or pipe a seam or an edge</source>
        <translation>Impunturare o bordare una cucitura o un lato</translation>
    </message>
    <message>
        <source>click it; stitches and piping are in the properties</source>
        <translation>clic; impunture e bordino sono nelle proprietà</translation>
    </message>
    <message>
        <source>Select an edge</source>
        <translation>Selezionare un lato</translation>
    </message>
    <message>
        <source>click the outline; drag it then to move it; L types its length</source>
        <translation>clic sul contorno; poi trascinare per spostarlo; L ne digita la lunghezza</translation>
    </message>
    <message>
        <source>Commands for what lies there</source>
        <translation>Comandi per ciò che si trova lì</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>pulsante destro</translation>
    </message>
    <message>
        <source>A number instead of a drag</source>
        <translation>Un numero invece di trascinare</translation>
    </message>
    <message>
        <source>type it while dragging: 50, 30, 20, for sizes 300 x 200 or 120 %; Enter lets go</source>
        <translation>digitarlo trascinando: 50 o 30, 20, per le dimensioni 300 x 200 o 120&#xa0;%; Invio rilascia</translation>
    </message>
    <message>
        <source>click edges; Shift+click collects several; Esc ends</source>
        <translation>clic sui lati; Maiusc+clic ne raccoglie più d’uno; Esc termina</translation>
    </message>
    <message>
        <source>right button, without a drag</source>
        <translation>pulsante destro, senza trascinare</translation>
    </message>
    <message>
        <source>Move by %1, by %2</source>
        <translation>Spostare di %1, di %2</translation>
    </message>
    <message>
        <source>%1, or Space and drag</source>
        <translation>%1, o Spazio e trascinare</translation>
    </message>
    <message>
        <source>%1, or drag beside the cover</source>
        <translation>%1, o trascinare accanto al rivestimento</translation>
    </message>
</context>
<context>
    <name>Insert</name>
    <message>
        <source>Padding</source>
        <translation>Imbottitura</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>Espanso</translation>
    </message>
    <message>
        <source>This frame is large: its smallest detail is set to %1; the usual %2 would need too much memory.</source>
        <translation>Questo telaio è grande: il dettaglio minimo è impostato a %1; il consueto valore di %2 richiederebbe troppa memoria.</translation>
    </message>
</context>
<context>
    <name>InsertCommands</name>
    <message>
        <source>&amp;Cushion</source>
        <translation>&amp;Imbottitura</translation>
    </message>
    <message>
        <source>&amp;Box of foam</source>
        <translation>&amp;Blocco di espanso</translation>
    </message>
    <message>
        <source>C&amp;ylinder of foam</source>
        <translation>&amp;Cilindro di espanso</translation>
    </message>
    <message>
        <source>&amp;Sphere of foam</source>
        <translation>&amp;Sfera di espanso</translation>
    </message>
    <message>
        <source>Foam belongs to a cushion: insert one first.</source>
        <translation>L’espanso appartiene a un’imbottitura: inserirne prima una.</translation>
    </message>
    <message>
        <source>Cushioning needs a frame: import one first.</source>
        <translation>L’imbottitura richiede un telaio: importarne prima uno.</translation>
    </message>
</context>
<context>
    <name>InspectorForms</name>
    <message numerus="yes">
        <source>%n elements</source>
        <translation>
            <numerusform>%n elemento</numerusform>
            <numerusform>%n elementi</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>InternalLineForm</name>
    <message>
        <source>Patch</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lunghezza</translation>
    </message>
</context>
<context>
    <name>InverseCommands</name>
    <message>
        <source>From a form …</source>
        <translation>Da una forma…</translation>
    </message>
    <message>
        <source>Cuts a frame, a mesh or the cover into pieces, lays them flat and makes the pattern of them</source>
        <translation>Taglia a pezzi un telaio, una mesh o il rivestimento, li stende in piano e ne fa il cartamodello</translation>
    </message>
    <message>
        <source>F&amp;it to a goal …</source>
        <translation>&amp;Adatta a un obiettivo…</translation>
    </message>
    <message>
        <source>Changes the pattern until the cover lies on a scan, or is strained less</source>
        <translation>Modifica il cartamodello finché il rivestimento aderisce a una scansione o è meno deformato</translation>
    </message>
    <message>
        <source>Relieve strain …</source>
        <translation>Riduci la deformazione…</translation>
    </message>
    <message>
        <source>Proposes changes of the pattern where cloth is strained too much, with what each gains</source>
        <translation>Propone modifiche del cartamodello dove il tessuto è troppo deformato, con il vantaggio di ciascuna</translation>
    </message>
    <message>
        <source>Why is it so? …</source>
        <translation>Perché è così?…</translation>
    </message>
    <message>
        <source>Which cause explains best how far the scan of a built piece lies from the cover</source>
        <translation>Quale causa spiega meglio lo scostamento della scansione di un pezzo realizzato dal rivestimento</translation>
    </message>
    <message>
        <source>Tolerances …</source>
        <translation>Tolleranze…</translation>
    </message>
    <message>
        <source>Where the cover varies from piece to piece, and which tolerance of making matters</source>
        <translation>Dove il rivestimento varia da pezzo a pezzo e quale tolleranza di confezione conta</translation>
    </message>
</context>
<context>
    <name>KeptMeasure</name>
    <message>
        <source>Measurement %1</source>
        <translation>Misura %1</translation>
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
        <translation>Trascinare l’etichetta dove si può leggere – Maiusc mantiene un asse, Ctrl esclude l’aggancio, Esc annulla</translation>
    </message>
</context>
<context>
    <name>LayerCommands</name>
    <message>
        <source>La&amp;yers</source>
        <translation>Li&amp;velli</translation>
    </message>
    <message>
        <source>&amp;Triangulation</source>
        <translation>&amp;Triangolazione</translation>
    </message>
    <message>
        <source>Chec&amp;ker</source>
        <translation>&amp;Quadri</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>Te&amp;laio</translation>
    </message>
    <message>
        <source>Control po&amp;ints</source>
        <translation>&amp;Punti di controllo</translation>
    </message>
    <message>
        <source>Sea&amp;ms and fixations</source>
        <translation>C&amp;uciture e fissaggi</translation>
    </message>
    <message>
        <source>Fixation c&amp;urves</source>
        <translation>Curve di &amp;fissaggio</translation>
    </message>
    <message>
        <source>&amp;Handle curves</source>
        <translation>Curve &amp;maniglia</translation>
    </message>
    <message>
        <source>Fanc&amp;y seams</source>
        <translation>Cuciture &amp;decorative</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Etichette</translation>
    </message>
    <message>
        <source>Sca&amp;ns</source>
        <translation>Sca&amp;nsioni</translation>
    </message>
    <message>
        <source>Gr&amp;ound</source>
        <translation>&amp;Suolo</translation>
    </message>
    <message>
        <source>Cushionin&amp;g</source>
        <translation>&amp;Imbottitura</translation>
    </message>
    <message>
        <source>Mirror image of the &amp;selection</source>
        <translation>Immagine speculare della sele&amp;zione</translation>
    </message>
    <message>
        <source>Symmetry &amp;axis and plane</source>
        <translation>&amp;Asse e piano di simmetria</translation>
    </message>
    <message>
        <source>Pairs of co&amp;ver and scan</source>
        <translation>C&amp;oppie rivestimento-scansione</translation>
    </message>
    <message>
        <source>Own &amp;colours of scans</source>
        <translation>&amp;Colori propri delle scansioni</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Griglia</translation>
    </message>
    <message>
        <source>Cut lines, notches and la&amp;bels</source>
        <translation>Linee di taglio, tacc&amp;he ed etichette</translation>
    </message>
    <message>
        <source>M&amp;easurements</source>
        <translation>Misur&amp;e</translation>
    </message>
</context>
<context>
    <name>MainMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aiuto</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;File</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Modifica</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Visualizza</translation>
    </message>
    <message>
        <source>&amp;Pattern</source>
        <translation>&amp;Cartamodello</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>&amp;Superficie</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>Fi&amp;nestra</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>&amp;Inserisci</translation>
    </message>
    <message>
        <source>Sea&amp;m</source>
        <translation>C&amp;ucitura</translation>
    </message>
    <message>
        <source>F&amp;rame</source>
        <translation>&amp;Telaio</translation>
    </message>
    <message>
        <source>F&amp;abric</source>
        <translation>T&amp;essuto</translation>
    </message>
    <message>
        <source>S&amp;can</source>
        <translation>Scansi&amp;one</translation>
    </message>
</context>
<context>
    <name>ManualCommands</name>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manuale</translation>
    </message>
    <message>
        <source>The page about what you are at</source>
        <translation>La pagina su ciò che si sta facendo</translation>
    </message>
    <message>
        <source>The manual is not installed.</source>
        <translation>Il manuale non è installato.</translation>
    </message>
    <message>
        <source>It is a folder &quot;manual&quot; with the program&apos;s other files.</source>
        <translation>È una cartella «manual» con gli altri file del programma.</translation>
    </message>
</context>
<context>
    <name>MapCommands</name>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Mappa</translation>
    </message>
    <message>
        <source>&amp;Largest strain</source>
        <translation>Deformazione &amp;massima</translation>
    </message>
    <message>
        <source>Strain al&amp;ong the grain</source>
        <translation>Deformazione in &amp;drittofilo</translation>
    </message>
    <message>
        <source>Strain a&amp;cross the grain</source>
        <translation>Deformazione in &amp;traverso</translation>
    </message>
    <message>
        <source>&amp;Shear</source>
        <translation>Sc&amp;orrimento</translation>
    </message>
    <message>
        <source>&amp;Mean curvature</source>
        <translation>&amp;Curvatura media</translation>
    </message>
    <message>
        <source>Distance to the &amp;frame</source>
        <translation>Distanza dal te&amp;laio</translation>
    </message>
    <message>
        <source>&amp;Deviation from the scan</source>
        <translation>&amp;Scostamento dalla scansione</translation>
    </message>
    <message>
        <source>&amp;Worst spots</source>
        <translation>Punti c&amp;ritici</translation>
    </message>
    <message>
        <source>Show worst spots as a l&amp;ist</source>
        <translation>Mostra &amp;elenco dei punti critici</translation>
    </message>
    <message>
        <source>Show this place in both windows</source>
        <translation>Mostra questo punto in entrambe le finestre</translation>
    </message>
    <message>
        <source>Choose a map of strain first</source>
        <translation>Scegliere prima una mappa di deformazione</translation>
    </message>
</context>
<context>
    <name>MarkDrag</name>
    <message>
        <source>Drag it to where it belongs – Esc takes it back</source>
        <translation>Trascinare dove serve – Esc annulla</translation>
    </message>
    <message>
        <source>Allowance of %1 – or type it; Ctrl for any width, Esc takes it back</source>
        <translation>Margine %1 – oppure digitarlo; Ctrl per qualsiasi larghezza, Esc annulla</translation>
    </message>
    <message>
        <source>Drag it to where it belongs, or type its place: 120, 40 – Esc takes it back</source>
        <translation>Trascinare dove serve o digitare la posizione: 120, 40 – Esc annulla</translation>
    </message>
    <message>
        <source>Drag it along the outline, or type how far it is from the corner – Esc takes it back</source>
        <translation>Trascinare lungo il contorno o digitare la distanza dall’angolo – Esc annulla</translation>
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
        <translation>Questo lato è lungo %1 – clic per un punto da cui misurare</translation>
    </message>
    <message>
        <source>Edge: %1</source>
        <translation>Lato: %1</translation>
    </message>
    <message>
        <source>Only a measurement between two points of patches can be kept.</source>
        <translation>Si può mantenere solo una misura tra due punti di pezzi.</translation>
    </message>
    <message>
        <source>&amp;Keep the measurement</source>
        <translation>&amp;Mantieni la misura</translation>
    </message>
    <message>
        <source>%1 – Enter keeps the measurement, a click begins anew</source>
        <translation>%1 – Invio mantiene la misura, un clic ricomincia</translation>
    </message>
    <message>
        <source>Click two points of the pattern or of the cover to measure, or point at an outline – Esc ends the tool</source>
        <translation>Fare clic su due punti del cartamodello o del rivestimento per misurare, o puntare un contorno – Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>%1 – a click begins anew</source>
        <translation>%1 – un clic ricomincia</translation>
    </message>
</context>
<context>
    <name>MeasurementForm</name>
    <message>
        <source>From</source>
        <translation>Da</translation>
    </message>
    <message>
        <source>To</source>
        <translation>A</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>Nel cartamodello</translation>
    </message>
    <message>
        <source>two patches</source>
        <translation>due pezzi</translation>
    </message>
    <message>
        <source>On the cover</source>
        <translation>Sul rivestimento</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>non ancora</translation>
    </message>
</context>
<context>
    <name>Message</name>
    <message>
        <source>the degree must be 1, 2 or 3, not %1</source>
        <translation>il grado deve essere 1, 2 o 3, non %1</translation>
    </message>
    <message>
        <source>a closed curve needs at least %1 points, not %2</source>
        <translation>una curva chiusa richiede almeno %1 punti, non %2</translation>
    </message>
    <message>
        <source>an open curve of this degree needs at least %1 points, not %2</source>
        <translation>una curva aperta di questo grado richiede almeno %1 punti, non %2</translation>
    </message>
    <message>
        <source>point %1 is no number or beyond 1e7 mm</source>
        <translation>il punto %1 non è un numero o supera 1e7 mm</translation>
    </message>
    <message>
        <source>corners belong to closed curves of degree 3 only</source>
        <translation>gli angoli esistono solo nelle curve chiuse di grado 3</translation>
    </message>
    <message>
        <source>the list of corners is empty; leave it out</source>
        <translation>l’elenco degli angoli è vuoto; ometterlo</translation>
    </message>
    <message>
        <source>corner %1 does not exist; the points are numbered 0 to %2</source>
        <translation>l’angolo %1 non esiste; i punti sono numerati da 0 a %2</translation>
    </message>
    <message>
        <source>the corners must increase, but %1 follows %2</source>
        <translation>gli angoli devono essere crescenti, ma %1 segue %2</translation>
    </message>
    <message>
        <source>there must be at least two points between the corners %1 and %2 (a straight edge: at its thirds)</source>
        <translation>devono esserci almeno due punti tra gli angoli %1 e %2 (lato dritto: ai suoi terzi)</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text goes on after the design&apos;s last bracket; remove what follows</source>
        <translation>Riga %1, colonna %2: il testo prosegue dopo l’ultima parentesi del modello; rimuovere ciò che segue</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text ends in the middle of the design; the file is incomplete</source>
        <translation>Riga %1, colonna %2: il testo finisce a metà del modello; il file è incompleto</translation>
    </message>
    <message>
        <source>Line %1, column %2: brackets are nested more than 64 deep; no design needs that</source>
        <translation>Riga %1, colonna %2: parentesi annidate per oltre 64 livelli; nessun modello ne ha bisogno</translation>
    </message>
    <message>
        <source>Line %1, column %2: a value is expected here: a number, a text in quotes, true, false or a bracket (NaN and Infinity are no numbers)</source>
        <translation>Riga %1, colonna %2: qui ci vuole un valore: un numero, un testo tra virgolette, true, false o una parentesi (NaN e Infinity non sono numeri)</translation>
    </message>
    <message>
        <source>Line %1, column %2: a comma or &quot;]&quot; is missing here</source>
        <translation>Riga %1, colonna %2: qui manca una virgola o «]»</translation>
    </message>
    <message>
        <source>Line %1, column %2: a key in quotes is expected here</source>
        <translation>Riga %1, colonna %2: qui ci vuole una chiave tra virgolette</translation>
    </message>
    <message>
        <source>Line %1, column %2: a colon is missing after the key</source>
        <translation>Riga %1, colonna %2: mancano i due punti dopo la chiave</translation>
    </message>
    <message>
        <source>Line %1, column %2: a comma or &quot;}&quot; is missing here</source>
        <translation>Riga %1, colonna %2: qui manca una virgola o «}»</translation>
    </message>
    <message>
        <source>Line %1, column %2: a text in quotes must end on its line; a quote is missing</source>
        <translation>Riga %1, colonna %2: un testo tra virgolette deve finire nella sua riga; mancano le virgolette</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is no valid escape; write a backslash as &quot;\\&quot;</source>
        <translation>Riga %1, colonna %2: sequenza di escape non valida; scrivere la barra rovesciata come &quot;\\&quot;</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is not UTF-8; save the file in that encoding</source>
        <translation>Riga %1, colonna %2: questo non è UTF-8; salvare il file in tale codifica</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text ends inside quotes; the file is incomplete</source>
        <translation>Riga %1, colonna %2: il testo finisce tra virgolette; il file è incompleto</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is no number; write it like 12.5, -3 or 1e-3</source>
        <translation>Riga %1, colonna %2: questo non è un numero; scriverlo come 12.5, -3 o 1e-3</translation>
    </message>
    <message>
        <source>the text is larger than %1 MB; that is no design</source>
        <translation>il testo supera %1&#xa0;MB; non è un modello</translation>
    </message>
    <message>
        <source>knot %1 occurs more often than %2 times, the degree; remove the surplus ones</source>
        <translation>il nodo %1 compare più di %2 volte, il grado; rimuovere quelli in eccesso</translation>
    </message>
    <message>
        <source>the knots of an open curve must begin with %1 equal ones and end with %1 equal, larger ones</source>
        <translation>i nodi di una curva aperta devono iniziare con %1 uguali e finire con %1 uguali, maggiori</translation>
    </message>
    <message>
        <source>%1 points of degree %2 need %3 knots, not %4</source>
        <translation>%1 punti di grado %2 richiedono %3 nodi, non %4</translation>
    </message>
    <message>
        <source>a knot is no number or beyond 1e7</source>
        <translation>un nodo non è un numero o supera 1e7</translation>
    </message>
    <message>
        <source>the knots must not decrease</source>
        <translation>i nodi non devono decrescere</translation>
    </message>
    <message>
        <source>the last knot must be larger than the first</source>
        <translation>l’ultimo nodo deve essere maggiore del primo</translation>
    </message>
    <message>
        <source>two knots near %1 are almost equal; make them equal</source>
        <translation>due nodi presso %1 sono quasi uguali; renderli uguali</translation>
    </message>
    <message>
        <source>there is not enough memory for this design</source>
        <translation>la memoria non basta per questo modello</translation>
    </message>
    <message>
        <source>%1: the file promises more than it holds</source>
        <translation>%1: il file dichiara più di quanto contiene</translation>
    </message>
    <message>
        <source>%1: the mesh is too large, the limit is %2 points and as many triangles</source>
        <translation>%1: la mesh è troppo grande, il limite è %2 punti e altrettanti triangoli</translation>
    </message>
    <message>
        <source>%1: the point is not finite, or beyond 10,000,000</source>
        <translation>%1: il punto non è finito o supera 10&#xa0;000&#xa0;000</translation>
    </message>
    <message>
        <source>%1: a face refers to point %2, but there are %3 points</source>
        <translation>%1: una faccia indica il punto %2, ma i punti sono %3</translation>
    </message>
    <message>
        <source>%1: the mesh has too many groups, the limit is %2</source>
        <translation>%1: la mesh ha troppi gruppi, il limite è %2</translation>
    </message>
    <message>
        <source>%1 holds no mesh</source>
        <translation>%1 non contiene una mesh</translation>
    </message>
    <message>
        <source>%1 holds points only; a frame needs faces between them</source>
        <translation>%1 contiene solo punti; un telaio richiede facce tra di essi</translation>
    </message>
    <message>
        <source>%1: points are counted from 1, not from 0</source>
        <translation>%1: i punti si contano da 1, non da 0</translation>
    </message>
    <message>
        <source>%1: the file ends too early</source>
        <translation>%1: il file finisce troppo presto</translation>
    </message>
    <message>
        <source>%1: the file does not begin with OFF</source>
        <translation>%1: il file non inizia con OFF</translation>
    </message>
    <message>
        <source>%1: binary OFF is not read; save it as text</source>
        <translation>%1: OFF binario non viene letto; salvarlo come testo</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PLY number type</source>
        <translation>%1: «%2» non è un tipo numerico PLY</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PLY format</source>
        <translation>%1: «%2» non è un formato PLY</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; cannot count a list</source>
        <translation>%1: «%2» non può contare un elenco</translation>
    </message>
    <message>
        <source>%1: the file does not begin with &quot;ply&quot;</source>
        <translation>%1: il file non inizia con «ply»</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not expected in a PLY header</source>
        <translation>%1: «%2» è inatteso in un’intestazione PLY</translation>
    </message>
    <message>
        <source>%1: a count is negative</source>
        <translation>%1: un conteggio è negativo</translation>
    </message>
    <message>
        <source>%1: the points have no coordinate &quot;%2&quot;</source>
        <translation>%1: i punti non hanno la coordinata «%2»</translation>
    </message>
    <message>
        <source>%1: the faces have no list &quot;%2&quot;</source>
        <translation>%1: le facce non hanno l’elenco «%2»</translation>
    </message>
    <message>
        <source>%1: a number is missing</source>
        <translation>%1: manca un numero</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a number</source>
        <translation>%1: «%2» non è un numero</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a whole number</source>
        <translation>%1: «%2» non è un numero intero</translation>
    </message>
    <message>
        <source>unsaved work cannot be protected: &quot;%1&quot; cannot be written</source>
        <translation>il lavoro non salvato non può essere protetto: «%1» non può essere scritto</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot;</source>
        <translation>il file «%1» non esiste</translation>
    </message>
    <message>
        <source>you are not allowed to read &quot;%1&quot;</source>
        <translation>manca il permesso di leggere «%1»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a folder, not a file</source>
        <translation>«%1» è una cartella, non un file</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an ordinary file</source>
        <translation>«%1» non è un file ordinario</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read (%2)</source>
        <translation>«%1» non può essere letto (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: the disk is full; make room or choose another folder</source>
        <translation>«%1» non può essere scritto: il disco è pieno; liberare spazio o scegliere un’altra cartella</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: you are not allowed to write into &quot;%2&quot;; choose another folder</source>
        <translation>«%1» non può essere scritto: manca il permesso di scrivere in «%2»; scegliere un’altra cartella</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: there is no folder &quot;%2&quot;</source>
        <translation>«%1» non può essere scritto: la cartella «%2» non esiste</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is a folder</source>
        <translation>«%1» non può essere scritto: è una cartella</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written (%2)</source>
        <translation>«%1» non può essere scritto (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too large: %2 MB, and at most %3 MB are read</source>
        <translation>«%1» è troppo grande: %2&#xa0;MB, e se ne leggono al massimo %3&#xa0;MB</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is write-protected</source>
        <translation>«%1» non può essere scritto: è protetto da scrittura</translation>
    </message>
    <message>
        <source>The equations of the cover could not be solved: a patch is degenerate or its numbers are too large.</source>
        <translation>Le equazioni del rivestimento non sono risolvibili: un pezzo è degenere o i suoi numeri sono troppo grandi.</translation>
    </message>
    <message>
        <source>this seam and its neighbours carry their ends round in a circle without ever meeting. Let the seams of this circle end at common points.</source>
        <translation>questa cucitura e le vicine si passano le estremità in circolo senza mai incontrarsi. Far finire le cuciture di questo circolo in punti comuni.</translation>
    </message>
    <message>
        <source>the corners of the two stretches lie too close together to be matched. Move them apart or choose a smaller edge length.</source>
        <translation>gli angoli dei due tratti sono troppo vicini per essere fatti corrispondere. Allontanarli o scegliere una lunghezza dei lati minore.</translation>
    </message>
    <message>
        <source>%1 and %2 hold the same point of the cover in two places, %3 mm apart. Let both curves meet there, or end one stretch earlier.</source>
        <translation>%1 e %2 tengono lo stesso punto del rivestimento in due posizioni distanti %3&#xa0;mm. Far incontrare lì le due curve o far finire prima un tratto.</translation>
    </message>
    <message>
        <source>the patch is too narrow somewhere for edges of %1 mm. Choose a smaller edge length.</source>
        <translation>il pezzo è in qualche punto troppo stretto per lati di %1&#xa0;mm. Scegliere una lunghezza dei lati minore.</translation>
    </message>
    <message>
        <source>The design cannot be solved: %2</source>
        <translation>Il modello non può essere calcolato: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>There is no patch to solve. Add a patch to the pattern.</source>
        <translation>Non c’è alcun pezzo da calcolare. Aggiungere un pezzo al cartamodello.</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by an estimated %2 mm. Allow more iterations.</source>
        <translation>Dopo %1 iterazioni la superficie si muove ancora di circa %2&#xa0;mm. Consentire più iterazioni.</translation>
    </message>
    <message>
        <source>Remove %1 points</source>
        <translation>Rimuovi %1 punti</translation>
    </message>
    <message>
        <source>Move %1 points</source>
        <translation>Sposta %1 punti</translation>
    </message>
    <message>
        <source>another element has the number %1 already; give this one a number of its own</source>
        <translation>un altro elemento ha già il numero %1; assegnare a questo un numero proprio</translation>
    </message>
    <message>
        <source>this is no Bolster design; it must say &quot;format&quot;: &quot;bolster-design&quot;</source>
        <translation>questo non è un modello Bolster; deve contenere &quot;format&quot;: &quot;bolster-design&quot;</translation>
    </message>
    <message>
        <source>the design was made by a newer Bolster (version %1 of the format, this program knows %2); update the program</source>
        <translation>il modello è stato creato con un Bolster più recente (versione %1 del formato, questo programma conosce la %2); aggiornare il programma</translation>
    </message>
    <message>
        <source>must be %1</source>
        <translation>deve essere %1</translation>
    </message>
    <message>
        <source>must be &quot;mm&quot;; convert the design to millimetres</source>
        <translation>deve essere &quot;mm&quot;; convertire il modello in millimetri</translation>
    </message>
    <message>
        <source>must be a list of elements in square brackets</source>
        <translation>deve essere un elenco di elementi tra parentesi quadre</translation>
    </message>
    <message>
        <source>must be a list of points in square brackets</source>
        <translation>deve essere un elenco di punti tra parentesi quadre</translation>
    </message>
    <message>
        <source>must be a list of numbers in square brackets</source>
        <translation>deve essere un elenco di numeri tra parentesi quadre</translation>
    </message>
    <message>
        <source>the list is empty; leave it out</source>
        <translation>l’elenco è vuoto; ometterlo</translation>
    </message>
    <message>
        <source>must be a curve in braces, with degree, closed and points</source>
        <translation>deve essere una curva tra parentesi graffe, con degree, closed e points</translation>
    </message>
    <message>
        <source>a curve has either corners or knots; remove one of them</source>
        <translation>una curva ha corners oppure knots; rimuovere uno dei due</translation>
    </message>
    <message>
        <source>an outline must be closed; write true</source>
        <translation>un contorno deve essere chiuso; scrivere true</translation>
    </message>
    <message>
        <source>must be a stretch in braces, with patch, from and to</source>
        <translation>deve essere un tratto tra parentesi graffe, con patch, from e to</translation>
    </message>
    <message>
        <source>must be a quaternion [w, x, y, z] of length 1, not of length %1</source>
        <translation>deve essere un quaternione [w, x, y, z] di lunghezza 1, non di lunghezza %1</translation>
    </message>
    <message>
        <source>must be an object in braces</source>
        <translation>deve essere un oggetto tra parentesi graffe</translation>
    </message>
    <message>
        <source>an element must be an object in braces</source>
        <translation>un elemento deve essere un oggetto tra parentesi graffe</translation>
    </message>
    <message>
        <source>must be true or false, without quotes</source>
        <translation>deve essere true o false, senza virgolette</translation>
    </message>
    <message>
        <source>must be a text in quotes</source>
        <translation>deve essere un testo tra virgolette</translation>
    </message>
    <message>
        <source>and %1 more problems of this element</source>
        <translation>e altri %1 problemi di questo elemento</translation>
    </message>
    <message>
        <source>must be a number, without quotes</source>
        <translation>deve essere un numero, senza virgolette</translation>
    </message>
    <message>
        <source>must be a whole number from %1 to %2</source>
        <translation>deve essere un numero intero da %1 a %2</translation>
    </message>
    <message>
        <source>must be a list of %1 numbers in square brackets</source>
        <translation>deve essere un elenco di %1 numeri tra parentesi quadre</translation>
    </message>
    <message>
        <source>this key occurs twice; remove one of them</source>
        <translation>questa chiave compare due volte; rimuoverne una</translation>
    </message>
    <message>
        <source>this key is missing; add it</source>
        <translation>questa chiave manca; aggiungerla</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>deve essere uno di %1</translation>
    </message>
    <message>
        <source>this key is unknown; check its spelling or remove it</source>
        <translation>questa chiave è sconosciuta; controllarne la grafia o rimuoverla</translation>
    </message>
    <message>
        <source>Move a point of %1</source>
        <translation>Sposta un punto di %1</translation>
    </message>
    <message>
        <source>Move %2 points of %1</source>
        <translation>Sposta %2 punti di %1</translation>
    </message>
    <message>
        <source>Insert a point into %1</source>
        <translation>Inserisci un punto in %1</translation>
    </message>
    <message>
        <source>Remove a point of %1</source>
        <translation>Rimuovi un punto di %1</translation>
    </message>
    <message>
        <source>Change the settings</source>
        <translation>Modifica le impostazioni</translation>
    </message>
    <message>
        <source>Add fabric %1</source>
        <translation>Aggiungi tessuto %1</translation>
    </message>
    <message>
        <source>Add patch %1</source>
        <translation>Aggiungi pezzo %1</translation>
    </message>
    <message>
        <source>Add a seam</source>
        <translation>Aggiungi una cucitura</translation>
    </message>
    <message>
        <source>Add fixation curve %1</source>
        <translation>Aggiungi curva di fissaggio %1</translation>
    </message>
    <message>
        <source>Add a fixation seam</source>
        <translation>Aggiungi un fissaggio</translation>
    </message>
    <message>
        <source>Add frame %1</source>
        <translation>Aggiungi telaio %1</translation>
    </message>
    <message>
        <source>Add an unreadable element</source>
        <translation>Aggiungi un elemento illeggibile</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>Rinomina %1 in %2</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Rimuovi %1</translation>
    </message>
    <message>
        <source>Remove %1 elements</source>
        <translation>Rimuovi %1 elementi</translation>
    </message>
    <message>
        <source>Move %1 patches</source>
        <translation>Sposta %1 pezzi</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Sposta %1</translation>
    </message>
    <message>
        <source>Turn %1 patches</source>
        <translation>Ruota %1 pezzi</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>Ruota %1</translation>
    </message>
    <message>
        <source>There is not enough memory for this surface. Choose a larger edge length.</source>
        <translation>La memoria non basta per questa superficie. Scegliere una lunghezza dei lati maggiore.</translation>
    </message>
    <message>
        <source>The solver failed: %1. The last good surface is kept.</source>
        <translation>Il calcolo è fallito: %1. Si mantiene l’ultima superficie valida.</translation>
    </message>
    <message>
        <source>Change the colour of %1</source>
        <translation>Modifica il colore di %1</translation>
    </message>
    <message>
        <source>Change the stiffness of %1</source>
        <translation>Modifica la rigidezza di %1</translation>
    </message>
    <message>
        <source>Change the Poisson parameter of %1</source>
        <translation>Modifica il parametro di Poisson di %1</translation>
    </message>
    <message>
        <source>Change the bending length of %1</source>
        <translation>Modifica la lunghezza di flessione di %1</translation>
    </message>
    <message>
        <source>Change the fabric of %1</source>
        <translation>Cambia il tessuto di %1</translation>
    </message>
    <message>
        <source>Change the grain of %1</source>
        <translation>Modifica il drittofilo di %1</translation>
    </message>
    <message>
        <source>Change the pressure of %1</source>
        <translation>Modifica la pressione di %1</translation>
    </message>
    <message>
        <source>Change the right side of %1</source>
        <translation>Cambia il diritto di %1</translation>
    </message>
    <message>
        <source>Move %1 in the layout</source>
        <translation>Sposta %1 nel layout</translation>
    </message>
    <message>
        <source>Turn %1 in the layout</source>
        <translation>Ruota %1 nel layout</translation>
    </message>
    <message>
        <source>Change the continuity of %1</source>
        <translation>Modifica la continuità di %1</translation>
    </message>
    <message>
        <source>Change how %1 is matched</source>
        <translation>Modifica la corrispondenza di %1</translation>
    </message>
    <message>
        <source>Reverse %1</source>
        <translation>Inverti %1</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>Scala %1</translation>
    </message>
    <message>
        <source>The surface still moves after %1 iterations.</source>
        <translation>La superficie si muove ancora dopo %1 iterazioni.</translation>
    </message>
    <message>
        <source>this is no name of a file</source>
        <translation>questo non è un nome di file</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be relative to the design&apos;s folder and use &quot;/&quot; between folders</source>
        <translation>«%1» deve essere relativo alla cartella del modello e usare «/» tra le cartelle</translation>
    </message>
    <message>
        <source>left out because of its errors</source>
        <translation>omesso a causa dei suoi errori</translation>
    </message>
    <message>
        <source>left out because it needs %1, which is not there</source>
        <translation>omesso perché richiede %1, che manca</translation>
    </message>
    <message>
        <source>an edge length of %1 mm is used instead</source>
        <translation>si usa invece una lunghezza dei lati di %1&#xa0;mm</translation>
    </message>
    <message>
        <source>the file is not a design</source>
        <translation>il file non è un modello</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written</source>
        <translation>«%1» non può essere scritto</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be copied to &quot;%2&quot;: %3</source>
        <translation>«%1» non è stato copiato in «%2»: %3</translation>
    </message>
    <message>
        <source>the folder &quot;%1&quot; could not be made</source>
        <translation>impossibile creare la cartella «%1»</translation>
    </message>
    <message>
        <source>the patch is free in space: nothing fixes it to the frame; add a fixation</source>
        <translation>il pezzo è libero nello spazio: nulla lo fissa al telaio; aggiungere un fissaggio</translation>
    </message>
    <message>
        <source>this patch and the %1 sewn to it are free in space: nothing fixes them to the frame; add a fixation</source>
        <translation>questo pezzo e i %1 cuciti ad esso sono liberi nello spazio: nulla li fissa al telaio; aggiungere un fissaggio</translation>
    </message>
    <message>
        <source>is %1, but must lie between %2 and %3</source>
        <translation>è %1, ma deve essere tra %2 e %3</translation>
    </message>
    <message>
        <source>there is no element %1; name a %2</source>
        <translation>l’elemento %1 non esiste; indicarne uno di tipo %2</translation>
    </message>
    <message>
        <source>element %1 cannot be read; repair it or name another %2</source>
        <translation>l’elemento %1 non è leggibile; ripararlo o indicarne un altro di tipo %2</translation>
    </message>
    <message>
        <source>%1 is no %2; name another element</source>
        <translation>%1 non è di tipo %2; indicare un altro elemento</translation>
    </message>
    <message>
        <source>%1 mm would make more than 5 million triangles; take at least %2 mm for these patches</source>
        <translation>%1&#xa0;mm darebbero più di 5 milioni di triangoli; usare almeno %2&#xa0;mm per questi pezzi</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no colour; write it like #7a4a2b</source>
        <translation>«%1» non è un colore; scriverlo come #7a4a2b</translation>
    </message>
    <message>
        <source>the mesh cannot resolve folds as small as a bending length of %1 mm makes them: with edges of %2 mm it acts like %3 mm; take an edge length of at most %4 mm, or a longer bending length</source>
        <translation>la mesh non può riprodurre pieghe piccole come quelle di una lunghezza di flessione di %1&#xa0;mm: con lati di %2&#xa0;mm equivale a %3&#xa0;mm; usare lati di al massimo %4&#xa0;mm o una lunghezza di flessione maggiore</translation>
    </message>
    <message>
        <source>an outline must be a closed curve</source>
        <translation>un contorno deve essere una curva chiusa</translation>
    </message>
    <message>
        <source>the outline needs at least three points in different places</source>
        <translation>il contorno richiede almeno tre punti in posizioni diverse</translation>
    </message>
    <message>
        <source>all points of the outline lie on one line, it encloses no area; move one of them</source>
        <translation>tutti i punti del contorno sono su una retta, non racchiude alcuna area; spostarne uno</translation>
    </message>
    <message>
        <source>the outline crosses or touches itself near %1; move its points apart there</source>
        <translation>il contorno incrocia o tocca sé stesso presso %1; allontanare lì i suoi punti</translation>
    </message>
    <message>
        <source>the outline encloses no area</source>
        <translation>il contorno non racchiude alcuna area</translation>
    </message>
    <message>
        <source>%1 is the end of the curve; write %2, its start</source>
        <translation>%1 è la fine della curva; scrivere %2, il suo inizio</translation>
    </message>
    <message>
        <source>is %1, but must be larger than the start of the stretch, %2</source>
        <translation>è %1, ma deve essere maggiore dell’inizio del tratto, %2</translation>
    </message>
    <message>
        <source>the stretch from %1 to %2 is empty or longer than the curve</source>
        <translation>il tratto da %1 a %2 è vuoto o più lungo della curva</translation>
    </message>
    <message>
        <source>the stretch from %1 to %2 has no length; the outline&apos;s points coincide there</source>
        <translation>il tratto da %1 a %2 non ha lunghezza; lì i punti del contorno coincidono</translation>
    </message>
    <message>
        <source>the seam would sew a stretch of &quot;%1&quot; to itself: %2 to %3 and %4 to %5 overlap; choose two separate stretches</source>
        <translation>la cucitura cucirebbe un tratto di «%1» a sé stesso: %2–%3 e %4–%5 si sovrappongono; scegliere due tratti separati</translation>
    </message>
    <message>
        <source>the seam joins the right side of &quot;%1&quot; to the wrong side of &quot;%2&quot;; turn &quot;reversed&quot; round, or one patch wrong side out</source>
        <translation>la cucitura unisce il diritto di «%1» al rovescio di «%2»; invertire «reversed» o rivoltare uno dei pezzi</translation>
    </message>
    <message>
        <source>the sides of the seam are %1 mm (&quot;%2&quot;) and %3 mm (&quot;%4&quot;) long: %5 % ease, more than 5 % puckers; make them equal or check the ends of the stretches</source>
        <translation>i lati della cucitura sono lunghi %1&#xa0;mm («%2») e %3&#xa0;mm («%4»): lentezza %5&#xa0;%, oltre il 5&#xa0;% arriccia; renderli uguali o controllare le estremità dei tratti</translation>
    </message>
    <message>
        <source>the curve has no length; move its points apart</source>
        <translation>la curva non ha lunghezza; allontanare i suoi punti</translation>
    </message>
    <message>
        <source>the curve from %1 to %2 has no length</source>
        <translation>la curva da %1 a %2 non ha lunghezza</translation>
    </message>
    <message>
        <source>is %1, but must be positive: millimetres per unit of the file</source>
        <translation>è %1, ma deve essere positivo: millimetri per unità del file</translation>
    </message>
    <message>
        <source>a design has at most %1 elements</source>
        <translation>un modello ha al massimo %1 elementi</translation>
    </message>
    <message>
        <source>a curve has at most %1 points</source>
        <translation>una curva ha al massimo %1 punti</translation>
    </message>
    <message>
        <source>the usual values of a fabric are used instead</source>
        <translation>si usano invece i valori consueti di un tessuto</translation>
    </message>
    <message>
        <source>Remove %1 and what is sewn to it</source>
        <translation>Rimuovi %1 e ciò che vi è cucito</translation>
    </message>
    <message>
        <source>Remove %1 and %2 seams and fixations</source>
        <translation>Rimuovi %1 e %2 cuciture e fissaggi</translation>
    </message>
    <message>
        <source>is %1, but must be a positive length of at most %2; 12 mm is usual</source>
        <translation>è %1, ma deve essere una lunghezza positiva di al massimo %2; 12&#xa0;mm è il valore consueto</translation>
    </message>
    <message>
        <source>no mesh can resolve folds as small as a bending length of %1 mm makes them: with edges of %2 mm it acts like %3 mm; take a longer bending length</source>
        <translation>nessuna mesh può riprodurre pieghe piccole come quelle di una lunghezza di flessione di %1&#xa0;mm: con lati di %2&#xa0;mm equivale a %3&#xa0;mm; usare una lunghezza di flessione maggiore</translation>
    </message>
    <message>
        <source>it sews what %1 sews already; remove one of them</source>
        <translation>cuce ciò che %1 cuce già; rimuoverne una</translation>
    </message>
    <message>
        <source>it sews the same stretches as %1, but the other way round: each would be folded onto itself; remove one of the two</source>
        <translation>cuce gli stessi tratti di %1, ma in senso inverso: ognuno verrebbe ripiegato su sé stesso; rimuovere una delle due</translation>
    </message>
    <message>
        <source>&quot;%1&quot; goes up with &quot;..&quot;; write the way from the design&apos;s folder without it, or copy the file there</source>
        <translation>«%1» risale con «..»; scrivere il percorso dalla cartella del modello senza, o copiarvi il file</translation>
    </message>
    <message>
        <source>the number %1 is too large or too small; stay within %2</source>
        <translation>il numero %1 è troppo grande o troppo piccolo; restare entro %2</translation>
    </message>
    <message>
        <source>the text is UTF-16; save it as UTF-8</source>
        <translation>il testo è UTF-16; salvarlo come UTF-8</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by %2 mm in each: it does not come to rest. Lower the pressure, or make curves as long as the outlines they hold.</source>
        <translation>Dopo %1 iterazioni la superficie si muove ancora di %2&#xa0;mm in ognuna: non va a riposo. Ridurre la pressione o fare le curve lunghe quanto i contorni che tengono.</translation>
    </message>
    <message>
        <source>%1 of %2 triangles of the cover lie upside down. Look for cloth pressed into too little room, or a bending length that is long for its patch.</source>
        <translation>%1 di %2 triangoli del rivestimento sono rovesciati. Cercare tessuto premuto in troppo poco spazio o una lunghezza di flessione troppo grande per il suo pezzo.</translation>
    </message>
    <message>
        <source>there is either a normal or a tangent; remove one of them</source>
        <translation>c’è una normale oppure una tangente; rimuovere una delle due</translation>
    </message>
    <message>
        <source>there are %1 directions, but at most %2 are possible</source>
        <translation>le direzioni sono %1, ma ne sono possibili al massimo %2</translation>
    </message>
    <message>
        <source>a direction must be three numbers that are not all 0</source>
        <translation>una direzione deve essere di tre numeri non tutti 0</translation>
    </message>
    <message>
        <source>direction %1 is opposite to the one before, so that it is not known on which way to turn; add one between them</source>
        <translation>la direzione %1 è opposta alla precedente, quindi non si sa in che senso ruotare; aggiungerne una in mezzo</translation>
    </message>
    <message>
        <source>there is no curve; name one, or leave out curve_from and curve_to</source>
        <translation>non c’è alcuna curva; indicarne una o omettere curve_from e curve_to</translation>
    </message>
    <message>
        <source>Change the normal held by %1</source>
        <translation>Modifica la normale vincolata da %1</translation>
    </message>
    <message>
        <source>must be a text in quotation marks</source>
        <translation>deve essere un testo tra virgolette</translation>
    </message>
    <message>
        <source>the curve in the patch and its target must both be open or both be closed</source>
        <translation>la curva nel pezzo e la sua destinazione devono essere entrambe aperte o entrambe chiuse</translation>
    </message>
    <message>
        <source>Add handle curve %1</source>
        <translation>Aggiungi curva maniglia %1</translation>
    </message>
    <message>
        <source>Add fancy seam %1</source>
        <translation>Aggiungi cucitura decorativa %1</translation>
    </message>
    <message>
        <source>Add cushion %1</source>
        <translation>Aggiungi imbottitura %1</translation>
    </message>
    <message>
        <source>Add foam %1</source>
        <translation>Aggiungi espanso %1</translation>
    </message>
    <message>
        <source>a width of %1 mm is too narrow for edges of %2 mm; make it at least %3 mm wide, or choose a smaller edge length</source>
        <translation>una larghezza di %1&#xa0;mm è troppo stretta per lati di %2&#xa0;mm; farla di almeno %3&#xa0;mm o scegliere una lunghezza dei lati minore</translation>
    </message>
    <message>
        <source>it lies outside its patch; move its points inside the outline</source>
        <translation>è fuori dal suo pezzo; spostare i suoi punti dentro il contorno</translation>
    </message>
    <message>
        <source>it leaves the patch and comes back; keep it inside, or end it at the outline</source>
        <translation>esce dal pezzo e vi rientra; tenerla all’interno o farla finire sul contorno</translation>
    </message>
    <message>
        <source>it runs too flat into the outline near %1; let it meet the outline more steeply, or end it before</source>
        <translation>arriva troppo radente al contorno presso %1; farla arrivare più ripida o finire prima</translation>
    </message>
    <message>
        <source>it bends too sharply for a width of %1 mm near %2; make it narrower, or bend it less there</source>
        <translation>curva troppo stretta per una larghezza di %1&#xa0;mm presso %2; farla meno larga o curvarla meno in quel punto</translation>
    </message>
    <message>
        <source>a cushion takes at most %1 bodies of foam; this one is left out</source>
        <translation>un’imbottitura accetta al massimo %1 corpi di espanso; questo viene omesso</translation>
    </message>
    <message>
        <source>the frame has no part &quot;%1&quot;; it has %2</source>
        <translation>il telaio non ha la parte «%1»; ha %2</translation>
    </message>
    <message>
        <source>it is only %1 mm long; draw it at least %2 mm long, or choose a smaller edge length</source>
        <translation>è lunga solo %1&#xa0;mm; disegnarla di almeno %2&#xa0;mm o scegliere una lunghezza dei lati minore</translation>
    </message>
    <message>
        <source>it reaches beyond its patch near %1; move its points inside the outline</source>
        <translation>sporge dal suo pezzo presso %1; spostare i suoi punti dentro il contorno</translation>
    </message>
    <message>
        <source>it comes closer than %1 mm to the outline near %2; keep away from it, or choose a smaller edge length</source>
        <translation>si avvicina a meno di %1&#xa0;mm dal contorno presso %2; starne lontano o scegliere una lunghezza dei lati minore</translation>
    </message>
    <message>
        <source>it crosses %1, or comes closer to it than %2 mm, near %3; move them apart, or choose a smaller edge length</source>
        <translation>incrocia %1, o vi si avvicina a meno di %2&#xa0;mm, presso %3; allontanarle o scegliere una lunghezza dei lati minore</translation>
    </message>
    <message>
        <source>it crosses itself, or comes closer to itself than %1 mm, near %2; move its points apart, or choose a smaller edge length</source>
        <translation>incrocia sé stessa, o si avvicina a sé stessa a meno di %1&#xa0;mm, presso %2; allontanare i suoi punti o scegliere una lunghezza dei lati minore</translation>
    </message>
    <message>
        <source>the patch cannot be triangulated along it with edges of %1 mm. Choose a smaller edge length.</source>
        <translation>il pezzo non può essere triangolato lungo di essa con lati di %1&#xa0;mm. Scegliere una lunghezza dei lati minore.</translation>
    </message>
    <message>
        <source>Change the frame of %1</source>
        <translation>Cambia il telaio di %1</translation>
    </message>
    <message>
        <source>Change what %1 pushes</source>
        <translation>Cambia ciò che %1 preme</translation>
    </message>
    <message>
        <source>Switch %1</source>
        <translation>Attiva o disattiva %1</translation>
    </message>
    <message>
        <source>Change the parts of %1</source>
        <translation>Modifica le parti di %1</translation>
    </message>
    <message>
        <source>Change the padding of %1</source>
        <translation>Modifica l’imbottitura di %1</translation>
    </message>
    <message>
        <source>Change the strength of %1</source>
        <translation>Modifica la forza di %1</translation>
    </message>
    <message>
        <source>Change the distance of %1</source>
        <translation>Modifica la distanza di %1</translation>
    </message>
    <message>
        <source>Change the voxels of %1</source>
        <translation>Modifica i voxel di %1</translation>
    </message>
    <message>
        <source>Change the cushion of %1</source>
        <translation>Cambia l’imbottitura di %1</translation>
    </message>
    <message>
        <source>Change the shape of %1</source>
        <translation>Modifica la forma di %1</translation>
    </message>
    <message>
        <source>Change the size of %1</source>
        <translation>Modifica le dimensioni di %1</translation>
    </message>
    <message>
        <source>Add or cut %1</source>
        <translation>Aggiungi o ritaglia %1</translation>
    </message>
    <message>
        <source>Change the contact of %1</source>
        <translation>Modifica il contatto di %1</translation>
    </message>
    <message>
        <source>Change the gap of %1</source>
        <translation>Modifica la distanza di %1</translation>
    </message>
    <message>
        <source>Change the width of %1</source>
        <translation>Modifica la larghezza di %1</translation>
    </message>
    <message>
        <source>Change the depth of %1</source>
        <translation>Modifica la profondità di %1</translation>
    </message>
    <message>
        <source>Change the profile of %1</source>
        <translation>Modifica il profilo di %1</translation>
    </message>
    <message>
        <source>Move points of %1 curves</source>
        <translation>Sposta punti di %1 curve</translation>
    </message>
    <message>
        <source>Rename a file</source>
        <translation>Rinomina un file</translation>
    </message>
    <message>
        <source>Change the file of %1</source>
        <translation>Cambia il file di %1</translation>
    </message>
    <message>
        <source>the file is missing</source>
        <translation>il file manca</translation>
    </message>
    <message>
        <source>it is a file that this design refers to; choose another name</source>
        <translation>è un file a cui questo modello rimanda; scegliere un altro nome</translation>
    </message>
    <message>
        <source>There is no cover to place the scan on.</source>
        <translation>Non c’è un rivestimento su cui posizionare la scansione.</translation>
    </message>
    <message>
        <source>must be a list of at most %1 planes, [x, y, z, distance] each</source>
        <translation>deve essere un elenco di al massimo %1 piani, ognuno [x, y, z, distanza]</translation>
    </message>
    <message>
        <source>must be a list of at most %1 cuts in braces</source>
        <translation>deve essere un elenco di al massimo %1 ritagli tra parentesi graffe</translation>
    </message>
    <message>
        <source>must be a cut in braces, with planes</source>
        <translation>deve essere un ritaglio tra parentesi graffe, con planes</translation>
    </message>
    <message>
        <source>the first three numbers are the plane&apos;s normal; not all of them may be 0</source>
        <translation>i primi tre numeri sono la normale del piano; non possono essere tutti 0</translation>
    </message>
    <message>
        <source>no file is named; write the name of a file beside the design</source>
        <translation>nessun file indicato; scrivere il nome di un file accanto al modello</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no file in the design&apos;s folder; copy the file into that folder and name it here</source>
        <translation>«%1» non è un file nella cartella del modello; copiare il file in quella cartella e indicarlo qui</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot; in the design&apos;s folder; copy the file there or choose another one</source>
        <translation>nella cartella del modello non c’è il file «%1»; copiarvelo o sceglierne un altro</translation>
    </message>
    <message>
        <source>with this scale and position the points reach beyond 10,000,000 mm</source>
        <translation>con questa scala e posizione i punti superano 10&#xa0;000&#xa0;000&#xa0;mm</translation>
    </message>
    <message>
        <source>Add scan %1</source>
        <translation>Aggiungi scansione %1</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Ritaglia %1</translation>
    </message>
    <message>
        <source>Show all of %1</source>
        <translation>Mostra tutto di %1</translation>
    </message>
    <message>
        <source>Cut the floor off %1</source>
        <translation>Taglia via il pavimento da %1</translation>
    </message>
    <message>
        <source>%1 holds no points</source>
        <translation>%1 non contiene punti</translation>
    </message>
    <message>
        <source>%1: the scan is too large, the limit is %2 points</source>
        <translation>%1: la scansione è troppo grande, il limite è %2 punti</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not expected in a PCD header</source>
        <translation>%1: «%2» è inatteso in un’intestazione PCD</translation>
    </message>
    <message>
        <source>%1: the compressed points are damaged</source>
        <translation>%1: i punti compressi sono danneggiati</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PCD format</source>
        <translation>%1: «%2» non è un formato PCD</translation>
    </message>
    <message>
        <source>the cuts leave nothing of the scan; remove one of them</source>
        <translation>i ritagli non lasciano nulla della scansione; rimuoverne uno</translation>
    </message>
    <message>
        <source>Change the threshold of %1</source>
        <translation>Modifica la soglia di %1</translation>
    </message>
    <message>
        <source>Change how %1 pulls</source>
        <translation>Modifica come tira %1</translation>
    </message>
    <message>
        <source>Release points of twins</source>
        <translation>Scollega punti di gemelli</translation>
    </message>
    <message>
        <source>Re-link points of twins</source>
        <translation>Ricollega punti di gemelli</translation>
    </message>
    <message>
        <source>Make the design symmetric</source>
        <translation>Rendi simmetrico il modello</translation>
    </message>
    <message>
        <source>These two cannot be twins.</source>
        <translation>Questi due non possono essere gemelli.</translation>
    </message>
    <message>
        <source>Make corners</source>
        <translation>Crea angoli</translation>
    </message>
    <message>
        <source>Make curves smooth</source>
        <translation>Rendi lisce le curve</translation>
    </message>
    <message>
        <source>element %1 cannot be its twin: that must be another %2 which is nobody else&apos;s; until then it has none</source>
        <translation>l’elemento %1 non può essere il suo gemello: deve essere un altro elemento di tipo %2 che non lo sia già di altri; fino ad allora non ne ha</translation>
    </message>
    <message>
        <source>there is no point %1</source>
        <translation>il punto %1 non esiste</translation>
    </message>
    <message>
        <source>its points and knots are not those of %1; the next edit of one of them makes it the mirror image</source>
        <translation>i suoi punti e nodi non sono quelli di %1; la prossima modifica di uno dei due ne fa l’immagine speculare</translation>
    </message>
    <message>
        <source>%1 of its points are no mirror images of those of %2; release them, or move them</source>
        <translation>%1 dei suoi punti non sono speculari a quelli di %2; scollegarli o spostarli</translation>
    </message>
    <message>
        <source>the plane needs a normal that is not 0, and numbers within 1e7; x = 0 is used instead</source>
        <translation>il piano richiede una normale diversa da 0 e numeri entro 1e7; si usa invece x = 0</translation>
    </message>
    <message>
        <source>the axis needs a direction that is not 0, and numbers within 1e7; x = 0 is used instead</source>
        <translation>l’asse richiede una direzione diversa da 0 e numeri entro 1e7; si usa invece x = 0</translation>
    </message>
    <message>
        <source>The clipboard holds no parts of a design.</source>
        <translation>Gli appunti non contengono parti di un modello.</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Incolla %1</translation>
    </message>
    <message>
        <source>Paste %1 pieces</source>
        <translation>Incolla %1 parti</translation>
    </message>
    <message>
        <source>The clipboard holds no patches and no fixation curves.</source>
        <translation>Gli appunti non contengono né pezzi né curve di fissaggio.</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Duplica %1</translation>
    </message>
    <message>
        <source>Duplicate %1 pieces</source>
        <translation>Duplica %1 parti</translation>
    </message>
    <message>
        <source>Make a corner in %1</source>
        <translation>Crea un angolo in %1</translation>
    </message>
    <message>
        <source>Make %1 smooth</source>
        <translation>Rendi liscio %1</translation>
    </message>
    <message>
        <source>Straighten a stretch of %1</source>
        <translation>Raddrizza un tratto di %1</translation>
    </message>
    <message>
        <source>Attach %1 to %2</source>
        <translation>Fissa %1 a %2</translation>
    </message>
    <message>
        <source>There is no such stretch of an outline.</source>
        <translation>Un tale tratto di contorno non esiste.</translation>
    </message>
    <message>
        <source>The stretch has no length.</source>
        <translation>Il tratto non ha lunghezza.</translation>
    </message>
    <message>
        <source>A part of this stretch is fixed to %1 already: remove that fixation or choose another stretch.</source>
        <translation>Una parte di questo tratto è già fissata a %1: rimuovere quel fissaggio o scegliere un altro tratto.</translation>
    </message>
    <message>
        <source>Create fixation curve %1</source>
        <translation>Crea curva di fissaggio %1</translation>
    </message>
    <message>
        <source>Attach %1 stretches to %2</source>
        <translation>Fissa %1 tratti a %2</translation>
    </message>
    <message>
        <source>Attach %1 to %2 curves</source>
        <translation>Fissa %1 a %2 curve</translation>
    </message>
    <message>
        <source>Align %1 patches</source>
        <translation>Allinea %1 pezzi</translation>
    </message>
    <message>
        <source>Distribute %1 patches</source>
        <translation>Distribuisci %1 pezzi</translation>
    </message>
    <message>
        <source>Arrange %1 patches</source>
        <translation>Disponi %1 pezzi</translation>
    </message>
    <message>
        <source>Make %1 and %2 twins</source>
        <translation>Rendi gemelli %1 e %2</translation>
    </message>
    <message>
        <source>They are no mirror images: they differ by %1 mm. Twins must be alike; make a mirror twin of one of them instead.</source>
        <translation>Non sono speculari: differiscono di %1&#xa0;mm. I gemelli devono essere uguali; creare invece un gemello speculare di uno dei due.</translation>
    </message>
    <message>
        <source>Make a mirror twin of %1</source>
        <translation>Crea un gemello speculare di %1</translation>
    </message>
    <message>
        <source>Make %1 mirror twins</source>
        <translation>Crea %1 gemelli speculari</translation>
    </message>
    <message>
        <source>A patch of the seam is missing or invalid: repair it first.</source>
        <translation>Un pezzo della cucitura manca o non è valido: prima ripararlo.</translation>
    </message>
    <message>
        <source>The seam joins %1 to itself: there is nothing to merge.</source>
        <translation>La cucitura unisce %1 a sé stesso: non c’è nulla da unire.</translation>
    </message>
    <message>
        <source>The seam takes up a whole outline: nothing would be left.</source>
        <translation>La cucitura occupa un intero contorno: non resterebbe nulla.</translation>
    </message>
    <message>
        <source>The seam joins the right side of %1 to the wrong side of %2: one patch cannot be both.</source>
        <translation>La cucitura unisce il diritto di %1 al rovescio di %2: un pezzo non può essere entrambi.</translation>
    </message>
    <message>
        <source>The sides of the seam differ by %1 % in length, more than 5 %.</source>
        <translation>I lati della cucitura differiscono in lunghezza del %1&#xa0;%, più del 5&#xa0;%.</translation>
    </message>
    <message>
        <source>Select the seam along which to merge.</source>
        <translation>Selezionare la cucitura lungo cui unire.</translation>
    </message>
    <message>
        <source>Merged, %1 and %2 would overlap or cross: the seam stays.</source>
        <translation>Uniti, %1 e %2 si sovrapporrebbero o incrocerebbero: la cucitura resta.</translation>
    </message>
    <message>
        <source>Merge %1 and %2</source>
        <translation>Unisci %1 e %2</translation>
    </message>
    <message>
        <source>Scale %1 patches</source>
        <translation>Scala %1 pezzi</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>Specchia %1</translation>
    </message>
    <message>
        <source>Mirror %1 patches</source>
        <translation>Specchia %1 pezzi</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>Dividi %1</translation>
    </message>
    <message>
        <source>The line must cross the outline of %1 exactly twice, not %2 times.</source>
        <translation>La linea deve incrociare il contorno di %1 esattamente due volte, non %2.</translation>
    </message>
    <message>
        <source>Draw a line over a patch to split it.</source>
        <translation>Per dividere un pezzo, tracciarvi sopra una linea.</translation>
    </message>
    <message>
        <source>The outline of %1 is invalid: repair it first.</source>
        <translation>Il contorno di %1 non è valido: prima ripararlo.</translation>
    </message>
    <message>
        <source>The line must run inside %1.</source>
        <translation>La linea deve correre dentro %1.</translation>
    </message>
    <message>
        <source>A piece of %1 would cross itself or be too narrow: draw another line.</source>
        <translation>Una parte di %1 incrocerebbe sé stessa o sarebbe troppo stretta: tracciare un’altra linea.</translation>
    </message>
    <message>
        <source>Sew %1 to %2</source>
        <translation>Cuci %1 a %2</translation>
    </message>
    <message>
        <source>Sew %1 to %2 stretches in a row</source>
        <translation>Cuci %1 a %2 tratti di seguito</translation>
    </message>
    <message>
        <source>Flip %1</source>
        <translation>Inverti %1</translation>
    </message>
    <message>
        <source>Flip %1 seams</source>
        <translation>Inverti %1 cuciture</translation>
    </message>
    <message>
        <source>Swap the sides of %1</source>
        <translation>Scambia i lati di %1</translation>
    </message>
    <message>
        <source>Swap the sides of %1 seams</source>
        <translation>Scambia i lati di %1 cuciture</translation>
    </message>
    <message>
        <source>Change the continuity of %1 seams</source>
        <translation>Modifica la continuità di %1 cuciture</translation>
    </message>
    <message>
        <source>Change how %1 seams are matched</source>
        <translation>Modifica la corrispondenza di %1 cuciture</translation>
    </message>
    <message>
        <source>This stretch has no length: choose two different points.</source>
        <translation>Questo tratto non ha lunghezza: scegliere due punti diversi.</translation>
    </message>
    <message>
        <source>Move an end of %1</source>
        <translation>Sposta un’estremità di %1</translation>
    </message>
    <message>
        <source>%1 is already sewn to %2 here: remove that seam first, or take a free stretch.</source>
        <translation>%1 è già cucito qui a %2: prima rimuovere quella cucitura o prendere un tratto libero.</translation>
    </message>
    <message>
        <source>A stretch cannot be sewn to itself: choose two that have no part in common.</source>
        <translation>Un tratto non può essere cucito a sé stesso: sceglierne due senza parti in comune.</translation>
    </message>
    <message>
        <source>Unlink %1 and %2</source>
        <translation>Separa %1 e %2</translation>
    </message>
    <message>
        <source>Unlink %1 pairs of twins</source>
        <translation>Separa %1 coppie di gemelli</translation>
    </message>
    <message>
        <source>Release a point of %1</source>
        <translation>Scollega un punto di %1</translation>
    </message>
    <message>
        <source>Release %2 points of %1</source>
        <translation>Scollega %2 punti di %1</translation>
    </message>
    <message>
        <source>Re-link a point of %1</source>
        <translation>Ricollega un punto di %1</translation>
    </message>
    <message>
        <source>Re-link %2 points of %1</source>
        <translation>Ricollega %2 punti di %1</translation>
    </message>
    <message>
        <source>Change the curve of %1</source>
        <translation>Modifica la curva di %1</translation>
    </message>
    <message>
        <source>The outline of %1 would cross or touch itself.</source>
        <translation>Il contorno di %1 incrocerebbe o toccherebbe sé stesso.</translation>
    </message>
    <message>
        <source>The outline of %1 would enclose nothing.</source>
        <translation>Il contorno di %1 non racchiuderebbe nulla.</translation>
    </message>
    <message>
        <source>%1 would not lie inside %2 any more.</source>
        <translation>%1 non starebbe più dentro %2.</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that is fixed to %2.</source>
        <translation>Il tratto si sovrapporrebbe a un altro di %1 fissato a %2.</translation>
    </message>
    <message>
        <source>The stretch would overlap the seam of %1 and %2.</source>
        <translation>Il tratto si sovrapporrebbe alla cucitura di %1 e %2.</translation>
    </message>
    <message>
        <source>The two sides of the seam would overlap.</source>
        <translation>I due lati della cucitura si sovrapporrebbero.</translation>
    </message>
    <message>
        <source>Change the length of a stretch of %1</source>
        <translation>Modifica la lunghezza di un tratto di %1</translation>
    </message>
    <message>
        <source>Move an end of a fixation of %1</source>
        <translation>Sposta un’estremità di un fissaggio di %1</translation>
    </message>
    <message>
        <source>Re-link a seam to its mirror image</source>
        <translation>Ricollega una cucitura alla sua speculare</translation>
    </message>
    <message>
        <source>Release a seam from its mirror image</source>
        <translation>Scollega una cucitura dalla sua speculare</translation>
    </message>
    <message>
        <source>another element had the same number; give this one a number of its own</source>
        <translation>un altro elemento aveva lo stesso numero; assegnare a questo un numero proprio</translation>
    </message>
    <message>
        <source>Take %1 elements from another version</source>
        <translation>Prendi %1 elementi da un’altra versione</translation>
    </message>
    <message>
        <source>Take %1 from another version</source>
        <translation>Prendi %1 da un’altra versione</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is not an ordinary file</source>
        <translation>«%1» non può essere scritto: non è un file ordinario</translation>
    </message>
    <message>
        <source>a file that the design uses cannot be read (%1)</source>
        <translation>un file usato dal modello non può essere letto (%1)</translation>
    </message>
    <message>
        <source>a file of the project cannot be written out (%1)</source>
        <translation>un file del progetto non può essere estratto (%1)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be opened or made</source>
        <translation>«%1» non può essere aperto o creato</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is in use by another program</source>
        <translation>«%1» è in uso da un altro programma</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged (%2)</source>
        <translation>«%1» è danneggiato (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read or written (%2)</source>
        <translation>«%1» non può essere letto o scritto (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is closed</source>
        <translation>«%1» è chiuso</translation>
    </message>
    <message>
        <source>%1 cannot be stored: it holds a number that is none, or text in an unknown encoding</source>
        <translation>%1 non può essere salvato: contiene un numero non valido o testo in codifica sconosciuta</translation>
    </message>
    <message>
        <source>there is a file &quot;%1&quot; already</source>
        <translation>il file «%1» esiste già</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no Bolster project</source>
        <translation>«%1» non è un progetto Bolster</translation>
    </message>
    <message>
        <source>there is not enough memory for this project</source>
        <translation>la memoria non basta per questo progetto</translation>
    </message>
    <message>
        <source>an edit of the project cannot be read any more</source>
        <translation>una modifica del progetto non è più leggibile</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name for a file of a project</source>
        <translation>«%1» non è un nome per un file di un progetto</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was made by a newer Bolster (version %2 of the format, this program knows %3); update the program</source>
        <translation>«%1» è stato creato con un Bolster più recente (versione %2 del formato, questo programma conosce la %3); aggiornare il programma</translation>
    </message>
    <message>
        <source>&quot;%1&quot; says that it has version %2 of the format, which never was</source>
        <translation>«%1» dichiara la versione %2 del formato, mai esistita</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the journal of a running program, or of one that crashed, not a project file</source>
        <translation>«%1» è il journal di un programma in esecuzione o arrestatosi in modo anomalo, non un file di progetto</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: it is %2 bytes long and should have %3</source>
        <translation>«%1» è danneggiato: è lungo %2 byte e dovrebbe averne %3</translation>
    </message>
    <message>
        <source>a temporary folder cannot be made (%1)</source>
        <translation>impossibile creare una cartella temporanea (%1)</translation>
    </message>
    <message>
        <source>a temporary file cannot be made (%1)</source>
        <translation>impossibile creare un file temporaneo (%1)</translation>
    </message>
    <message>
        <source>nothing in &quot;%1&quot; can be saved</source>
        <translation>nulla di «%1» può essere recuperato</translation>
    </message>
    <message>
        <source>%1 versions were saved</source>
        <translation>%1 versioni recuperate</translation>
    </message>
    <message>
        <source>lost: versions %1 to %2</source>
        <translation>perdute: versioni da %1 a %2</translation>
    </message>
    <message>
        <source>Saved version</source>
        <translation>Versione recuperata</translation>
    </message>
    <message>
        <source>version %1 was saved without the edits before it</source>
        <translation>la versione %1 è stata recuperata senza le modifiche precedenti</translation>
    </message>
    <message>
        <source>lost: the names of %1 versions</source>
        <translation>perduti: i nomi di %1 versioni</translation>
    </message>
    <message>
        <source>lost: the file &quot;%1&quot;</source>
        <translation>perduto: il file «%1»</translation>
    </message>
    <message>
        <source>the tables of &quot;%1&quot; are not those of a Bolster project</source>
        <translation>le tabelle di «%1» non sono quelle di un progetto Bolster</translation>
    </message>
    <message>
        <source>a checksum is incomplete</source>
        <translation>una somma di controllo è incompleta</translation>
    </message>
    <message>
        <source>another window has it</source>
        <translation>lo ha un’altra finestra</translation>
    </message>
    <message>
        <source>must be a list of pairs in braces, with patch and fabric</source>
        <translation>deve essere un elenco di coppie tra parentesi graffe, con patch e fabric</translation>
    </message>
    <message>
        <source>must be a pair in braces, with patch and fabric</source>
        <translation>deve essere una coppia tra parentesi graffe, con patch e fabric</translation>
    </message>
    <message>
        <source>there is no colourway %1; the patches show their own fabrics</source>
        <translation>la variante colore %1 non esiste; i pezzi mostrano i propri tessuti</translation>
    </message>
    <message>
        <source>%1 has a fabric in this colourway already; remove one of the two</source>
        <translation>%1 ha già un tessuto in questa variante colore; rimuovere uno dei due</translation>
    </message>
    <message>
        <source>what it says of missing patches and fabrics is left out</source>
        <translation>ciò che indica su pezzi e tessuti mancanti viene omesso</translation>
    </message>
    <message>
        <source>Make %1 of %2</source>
        <translation>Fai %1 di %2</translation>
    </message>
    <message>
        <source>Make %1 patches of %2</source>
        <translation>Fai %1 pezzi di %2</translation>
    </message>
    <message>
        <source>Add colourway %1</source>
        <translation>Aggiungi variante colore %1</translation>
    </message>
    <message>
        <source>Change what %1 shows</source>
        <translation>Cambia ciò che mostra %1</translation>
    </message>
    <message>
        <source>Change what %1 patches show</source>
        <translation>Cambia ciò che mostrano %1 pezzi</translation>
    </message>
    <message>
        <source>Show no colourway</source>
        <translation>Non mostrare varianti colore</translation>
    </message>
    <message>
        <source>Show colourway %1</source>
        <translation>Mostra variante colore %1</translation>
    </message>
    <message>
        <source>A stretch of %1 that is sewn, fixed or trimmed would have no length.</source>
        <translation>Un tratto di %1 cucito, fissato o rifinito non avrebbe lunghezza.</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that has a trim.</source>
        <translation>Il tratto si sovrapporrebbe a un altro di %1 che ha una finitura.</translation>
    </message>
    <message>
        <source>Add a trim</source>
        <translation>Aggiungi una finitura</translation>
    </message>
    <message>
        <source>Move an end of a trim of %1</source>
        <translation>Sposta un’estremità di una finitura di %1</translation>
    </message>
    <message>
        <source>Change the trim of %1 seams</source>
        <translation>Modifica la finitura di %1 cuciture</translation>
    </message>
    <message>
        <source>Change the trim of %1</source>
        <translation>Modifica la finitura di %1</translation>
    </message>
    <message>
        <source>A part of this stretch of %1 has a trim already: change that one, or choose another stretch.</source>
        <translation>Una parte di questo tratto di %1 ha già una finitura: modificare quella o scegliere un altro tratto.</translation>
    </message>
    <message>
        <source>Trim the edge of %1</source>
        <translation>Rifinisci il lato di %1</translation>
    </message>
    <message>
        <source>%1: the file cannot be read any further; it has changed, or its disk is gone</source>
        <translation>%1: il file non è più leggibile; è cambiato o il suo disco non c’è più</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a picture that can be read; PNG, JPEG, TIFF and OpenEXR can</source>
        <translation>«%1» non è un’immagine leggibile; lo sono PNG, JPEG, TIFF e OpenEXR</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 by %3 pixels, and at most 64 million are read; make the picture smaller in a picture editor</source>
        <translation>«%1» ha %2 per %3 pixel e se ne leggono al massimo 64 milioni; ridurre l’immagine con un programma di grafica</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a kind of picture whose colours cannot be read; save it as PNG in a picture editor</source>
        <translation>«%1» è un tipo d’immagine di cui non si possono leggere i colori; salvarla come PNG con un programma di grafica</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged or incomplete; copy it again from where it came from, or save it again in a picture editor</source>
        <translation>«%1» è danneggiato o incompleto; copiarlo di nuovo dall’origine o salvarlo di nuovo con un programma di grafica</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which reads pictures for Bolster, cannot be started; install Bolster again</source>
        <translation>il programma «%1», che legge le immagini per Bolster, non si avvia; reinstallare Bolster</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes too long to read; save it as PNG in a picture editor</source>
        <translation>la lettura di «%1» richiede troppo tempo; salvarlo come PNG con un programma di grafica</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be decoded: it is damaged or incomplete, or needs too much memory; save it again as PNG in a picture editor</source>
        <translation>«%1» non può essere decodificato: è danneggiato, incompleto o richiede troppa memoria; salvarlo di nuovo come PNG con un programma di grafica</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this picture</source>
        <translation>%1: la memoria non basta per questa immagine</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this file</source>
        <translation>%1: la memoria non basta per questo file</translation>
    </message>
    <message>
        <source>%1: the line is too long</source>
        <translation>%1: la riga è troppo lunga</translation>
    </message>
    <message>
        <source>both have a file &quot;%1&quot;, and they are different: save under another name</source>
        <translation>entrambi hanno un file «%1», ma diverso: salvare con un altro nome</translation>
    </message>
    <message>
        <source>there is another project in the file now</source>
        <translation>nel file ora c’è un altro progetto</translation>
    </message>
    <message>
        <source>the last edits are not on the disk yet</source>
        <translation>le ultime modifiche non sono ancora sul disco</translation>
    </message>
    <message>
        <source>Change the stitching of %1</source>
        <translation>Modifica l’impuntura di %1</translation>
    </message>
    <message>
        <source>Change the piping of %1</source>
        <translation>Modifica il bordino di %1</translation>
    </message>
    <message>
        <source>Change the seam allowance of %1</source>
        <translation>Modifica il margine di cucitura di %1</translation>
    </message>
    <message>
        <source>Change the valley of %1</source>
        <translation>Modifica l’avvallamento di %1</translation>
    </message>
    <message>
        <source>there is no fabric in &quot;%1&quot;</source>
        <translation>in «%1» non c’è alcun tessuto</translation>
    </message>
    <message>
        <source>the design uses &quot;%1&quot; itself; choose another name</source>
        <translation>il modello stesso usa «%1»; scegliere un altro nome</translation>
    </message>
    <message>
        <source>there is not enough memory to show this fabric</source>
        <translation>la memoria non basta per mostrare questo tessuto</translation>
    </message>
    <message>
        <source>Replace fabric %1 by %2</source>
        <translation>Sostituisci il tessuto %1 con %2</translation>
    </message>
    <message>
        <source>Change the limits of %1</source>
        <translation>Modifica i limiti di %1</translation>
    </message>
    <message>
        <source>Change the look of %1</source>
        <translation>Modifica l’aspetto di %1</translation>
    </message>
    <message>
        <source>Change the second colour of %1</source>
        <translation>Modifica il secondo colore di %1</translation>
    </message>
    <message>
        <source>Change the kind of %1</source>
        <translation>Modifica il tipo di %1</translation>
    </message>
    <message>
        <source>there is no place for the files of this project</source>
        <translation>non c’è posto per i file di questo progetto</translation>
    </message>
    <message>
        <source>A side of this seam does not end at corners: its length cannot be changed alone.</source>
        <translation>Un lato di questa cucitura non finisce in angoli: la sua lunghezza non può cambiare da sola.</translation>
    </message>
    <message>
        <source>These edges cannot have this length: they hang together.</source>
        <translation>Questi lati non possono avere questa lunghezza: dipendono l’uno dall’altro.</translation>
    </message>
    <message>
        <source>Change the length of an edge of %1</source>
        <translation>Modifica la lunghezza di un lato di %1</translation>
    </message>
    <message>
        <source>Change the length of %1 edges</source>
        <translation>Modifica la lunghezza di %1 lati</translation>
    </message>
    <message>
        <source>Make %1 edges equally long</source>
        <translation>Rendi uguali %1 lati</translation>
    </message>
    <message>
        <source>Make the sides of a seam equally long</source>
        <translation>Pareggia i lati di una cucitura</translation>
    </message>
    <message>
        <source>Make the sides of %1 seams equally long</source>
        <translation>Pareggia i lati di %1 cuciture</translation>
    </message>
    <message>
        <source>There is a &quot;%1&quot; already: this one is called &quot;%2&quot;.</source>
        <translation>C’è già un «%1»: questo si chiama «%2».</translation>
    </message>
    <message>
        <source>Change the size of %1 patches</source>
        <translation>Modifica le dimensioni di %1 pezzi</translation>
    </message>
    <message>
        <source>%1: the rows hold more than the header of the file says; what is too much in each was left out</source>
        <translation>%1: le righe contengono più di quanto indica l’intestazione del file; l’eccesso di ognuna è stato omesso</translation>
    </message>
    <message>
        <source>this changes more at once than can be stored: at most %1 MB, and %2 keys; do it in parts</source>
        <translation>ciò cambia in una volta più di quanto si possa salvare: al massimo %1&#xa0;MB e %2 chiavi; procedere a parti</translation>
    </message>
    <message>
        <source>&quot;%1&quot; unpacks to more than any project; it was not made by Bolster, or is damaged</source>
        <translation>«%1» decompresso supera qualsiasi progetto; non è stato creato da Bolster o è danneggiato</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which recovers projects for Bolster, cannot be started; install Bolster again</source>
        <translation>il programma «%1», che recupera i progetti per Bolster, non si avvia; reinstallare Bolster</translation>
    </message>
    <message>
        <source>nothing in &quot;%1&quot; can be saved: it is damaged in a way that takes too much time or memory</source>
        <translation>nulla di «%1» può essere recuperato: il danno è tale da richiedere troppo tempo o memoria</translation>
    </message>
    <message>
        <source>lost: the table &quot;%1&quot;, which is missing or has other columns than it should</source>
        <translation>perduta: la tabella «%1», che manca o ha colonne diverse da quelle previste</translation>
    </message>
    <message>
        <source>lost: %1 more such gaps</source>
        <translation>perdute: altre %1 lacune simili</translation>
    </message>
    <message>
        <source>what comes after version %1 takes too long to recover</source>
        <translation>recuperare ciò che segue la versione %1 richiede troppo tempo</translation>
    </message>
    <message>
        <source>the edit of version %1 does not lead to the design that was kept with it</source>
        <translation>la modifica della versione %1 non porta al modello conservato con essa</translation>
    </message>
    <message>
        <source>it pushes nothing: no part of the frame lies under the cover</source>
        <translation>non preme nulla: nessuna parte del telaio è sotto il rivestimento</translation>
    </message>
    <message>
        <source>contact looks at the frame in steps of %1 mm; something of these parts is thinner, so that the cover may pass through: %2; make it thicker</source>
        <translation>il contatto esamina il telaio a passi di %1&#xa0;mm; qualcosa in queste parti è più sottile e il rivestimento può attraversarlo: %2; farlo più spesso</translation>
    </message>
    <message>
        <source>contact does nothing: in steps of %1 mm it finds no inside of the frame, which is thinner than that, or so open that it has none; close the frame, or make it thicker</source>
        <translation>il contatto non agisce: a passi di %1&#xa0;mm non trova un interno del telaio, che è più sottile o così aperto da non averne; chiudere il telaio o farlo più spesso</translation>
    </message>
    <message>
        <source>%1 lies in folds: there is more cloth than room for it</source>
        <translation>%1 fa pieghe: c’è più tessuto che spazio</translation>
    </message>
    <message>
        <source>%1 floats free: nothing holds it, and it is sewn to nothing that is held</source>
        <translation>%1 è libero: nulla lo tiene e non è cucito a nulla che sia tenuto</translation>
    </message>
    <message>
        <source>%1 holds the cloth %2 mm off the frame</source>
        <translation>%1 tiene il tessuto a %2&#xa0;mm dal telaio</translation>
    </message>
    <message>
        <source>The seam of %1 and %2 has %3 % ease: it puckers above %4 %</source>
        <translation>La cucitura di %1 e %2 ha il %3&#xa0;% di lentezza: oltre il %4&#xa0;% arriccia</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations.</source>
        <translation>La superficie è divergente dopo %1 iterazioni.</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations: %2 holds it %3 mm from everything else. Bring that curve nearer.</source>
        <translation>La superficie è divergente dopo %1 iterazioni: %2 la tiene a %3&#xa0;mm da tutto il resto. Avvicinare quella curva.</translation>
    </message>
    <message>
        <source>The equations of the cover could not be solved: %1 is degenerate or its numbers are too large. Check its outline and its fabric.</source>
        <translation>Le equazioni del rivestimento non sono risolvibili: %1 è degenere o i suoi numeri sono troppo grandi. Controllarne contorno e tessuto.</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations: the pressure of %2 (%3) is too high for its fabric. Lower it.</source>
        <translation>La superficie è divergente dopo %1 iterazioni: la pressione di %2 (%3) è troppo alta per il suo tessuto. Ridurla.</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations, most likely because of %2. Check the size of that patch, its pressure and its fabric.</source>
        <translation>La superficie è divergente dopo %1 iterazioni, molto probabilmente a causa di %2. Controllare dimensioni, pressione e tessuto di quel pezzo.</translation>
    </message>
    <message>
        <source>Change the material of %1</source>
        <translation>Cambia il materiale di %1</translation>
    </message>
    <message>
        <source>Show a part of %1</source>
        <translation>Mostra una parte di %1</translation>
    </message>
    <message>
        <source>Hide a part of %1</source>
        <translation>Nascondi una parte di %1</translation>
    </message>
    <message>
        <source>Show all parts of %1</source>
        <translation>Mostra tutte le parti di %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a link to &quot;%2&quot; now</source>
        <translation>«%1» ora è un collegamento a «%2»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was changed by another program</source>
        <translation>«%1» è stato modificato da un altro programma</translation>
    </message>
    <message>
        <source>somebody else has changed &quot;%1&quot; since it was opened here</source>
        <translation>qualcun altro ha modificato «%1» dopo l’apertura qui</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is another project now</source>
        <translation>«%1» ora è un altro progetto</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be renamed (%2)</source>
        <translation>«%1» non può essere rinominato (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: the content number %2 cannot be read</source>
        <translation>«%1» è danneggiato: il contenuto numero %2 non è leggibile</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: a row holds something of another kind than it should</source>
        <translation>«%1» è danneggiato: una riga contiene qualcosa di tipo diverso dal previsto</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: row %2 of the table &quot;%3&quot; contradicts others</source>
        <translation>«%1» è danneggiato: la riga %2 della tabella «%3» contraddice altre</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: parts of the file are not what was written</source>
        <translation>«%1» è danneggiato: parti del file non sono ciò che è stato scritto</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: rows are missing, or there are some too many</source>
        <translation>«%1» è danneggiato: mancano righe o ce ne sono di troppo</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: the edits up to number %2 do not lead to the design that was stored with them</source>
        <translation>«%1» è danneggiato: le modifiche fino al numero %2 non portano al modello salvato con esse</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: row %2 of the table &quot;%3&quot; is not what was written</source>
        <translation>«%1» è danneggiato: la riga %2 della tabella «%3» non è ciò che è stato scritto</translation>
    </message>
    <message>
        <source>there is no picture to write</source>
        <translation>non c’è un’immagine da scrivere</translation>
    </message>
    <message>
        <source>%1: a face has %2 corners, and at most %3 are read; have it split into triangles by the program that has made the file</source>
        <translation>%1: una faccia ha %2 vertici e se ne leggono al massimo %3; farla dividere in triangoli dal programma che ha creato il file</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: no file can be made in &quot;%2&quot;; choose another folder</source>
        <translation>«%1» non può essere scritto: impossibile creare un file in «%2»; scegliere un’altra cartella</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>interrotto</translation>
    </message>
    <message>
        <source>at most %1 cushions push; this one and those after it are left out</source>
        <translation>al massimo %1 imbottiture premono; questa e le successive vengono omesse</translation>
    </message>
    <message>
        <source>the picture cannot be encoded (%1)</source>
        <translation>l’immagine non può essere codificata (%1)</translation>
    </message>
    <message>
        <source>a smallest detail of %1 mm is too fine for a frame as large as this (%2 million cubes of it, and %3 are the limit), so the cushion is left out; take at least %4 mm</source>
        <translation>un dettaglio minimo di %1&#xa0;mm è troppo fine per un telaio così grande (%2 milioni di cubi, il limite è %3), perciò l’imbottitura viene omessa; usare almeno %4&#xa0;mm</translation>
    </message>
    <message>
        <source>something of these parts of the frame is thinner than the smallest detail of the padding, %1 mm, so that it may have gaps there: %2; take a smaller detail</source>
        <translation>qualcosa in queste parti del telaio è più sottile del dettaglio minimo dell’imbottitura, %1&#xa0;mm, e vi possono essere lacune: %2; usare un dettaglio minore</translation>
    </message>
    <message>
        <source>it pushes nothing: with a smallest detail of %1 mm there is no inside of the frame, which is thinner than that, or so open that it has none; take a smaller detail, or close the frame</source>
        <translation>non preme nulla: con un dettaglio minimo di %1&#xa0;mm il telaio non ha un interno, è più sottile o così aperto da non averne; usare un dettaglio minore o chiudere il telaio</translation>
    </message>
    <message>
        <source>Change the slanted faces of %1</source>
        <translation>Modifica le facce oblique di %1</translation>
    </message>
    <message>
        <source>Change the smallest detail of %1</source>
        <translation>Modifica il dettaglio minimo di %1</translation>
    </message>
    <message>
        <source>the log of &quot;%1&quot; is damaged: the last edits cannot be read</source>
        <translation>il log di «%1» è danneggiato: le ultime modifiche non sono leggibili</translation>
    </message>
    <message>
        <source>the kind %1 is unknown; there are %2 and %3</source>
        <translation>il tipo %1 è sconosciuto; ci sono %2 e %3</translation>
    </message>
    <message>
        <source>its label finds no room: make the words shorter, or put it elsewhere</source>
        <translation>la sua etichetta non trova spazio: abbreviare il testo o metterla altrove</translation>
    </message>
    <message>
        <source>its cut lines meet here: make the allowance smaller</source>
        <translation>le sue linee di taglio si incontrano qui: ridurre il margine</translation>
    </message>
    <message>
        <source>a notch of %1 mm reaches the sewing line, which is %2 mm away: make it shallower, or the allowance wider</source>
        <translation>una tacca di %1&#xa0;mm arriva alla linea di cucitura, distante %2&#xa0;mm: farla meno profonda o allargare il margine</translation>
    </message>
    <message>
        <source>nothing is sewn where it is, so it has no partner</source>
        <translation>dove si trova non si cuce nulla, quindi non ha corrispondente</translation>
    </message>
    <message>
        <source>it has no partner on the other side of its seam: another notch is too near there</source>
        <translation>non ha corrispondente sull’altro lato della cucitura: lì un’altra tacca è troppo vicina</translation>
    </message>
    <message>
        <source>it is %1 mm wide across the grain, but &quot;%2&quot; only %3 mm: split it, or turn its grain</source>
        <translation>in traverso è largo %1&#xa0;mm, ma «%2» solo %3&#xa0;mm: dividerlo o ruotarne il drittofilo</translation>
    </message>
    <message>
        <source>an inner corner of %1 degrees is too sharp for its seam allowances: make them smaller there, or the corner wider</source>
        <translation>un angolo rientrante di %1 gradi è troppo acuto per i suoi margini di cucitura: ridurli lì o allargare l’angolo</translation>
    </message>
    <message>
        <source>There is no such place on an outline.</source>
        <translation>Una tale posizione su un contorno non esiste.</translation>
    </message>
    <message>
        <source>A part of this stretch of %1 has a seam allowance of its own already: change that one, or choose another stretch.</source>
        <translation>Una parte di questo tratto di %1 ha già un proprio margine di cucitura: modificare quello o scegliere un altro tratto.</translation>
    </message>
    <message>
        <source>There is a notch of %1 at this place already.</source>
        <translation>In questo punto c’è già una tacca di %1.</translation>
    </message>
    <message>
        <source>This corner of %1 has a join of its own already.</source>
        <translation>Questo angolo di %1 ha già una propria forma.</translation>
    </message>
    <message>
        <source>Change the seam allowance of %1 patches</source>
        <translation>Modifica il margine di cucitura di %1 pezzi</translation>
    </message>
    <message>
        <source>Change the seam allowance of an edge of %1</source>
        <translation>Modifica il margine di cucitura di un lato di %1</translation>
    </message>
    <message>
        <source>Change a corner of the cut line of %1</source>
        <translation>Modifica un angolo della linea di taglio di %1</translation>
    </message>
    <message>
        <source>Add a notch to %1</source>
        <translation>Aggiungi una tacca a %1</translation>
    </message>
    <message>
        <source>Move a notch</source>
        <translation>Sposta una tacca</translation>
    </message>
    <message>
        <source>Move the join of a corner</source>
        <translation>Sposta la forma di un angolo</translation>
    </message>
    <message>
        <source>A drill hole must lie inside its patch.</source>
        <translation>Un foro deve essere dentro il suo pezzo.</translation>
    </message>
    <message>
        <source>Move %1 drill holes</source>
        <translation>Sposta %1 fori</translation>
    </message>
    <message>
        <source>Move the label of %1</source>
        <translation>Sposta l’etichetta di %1</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that has its own seam allowance.</source>
        <translation>Il tratto si sovrapporrebbe a un altro di %1 con un proprio margine di cucitura.</translation>
    </message>
    <message>
        <source>Give an edge its own seam allowance</source>
        <translation>Dai a un lato un proprio margine di cucitura</translation>
    </message>
    <message>
        <source>Change a corner of the cut line</source>
        <translation>Modifica un angolo della linea di taglio</translation>
    </message>
    <message>
        <source>Add drill hole %1</source>
        <translation>Aggiungi foro %1</translation>
    </message>
    <message>
        <source>Change the diameter of %1</source>
        <translation>Modifica il diametro di %1</translation>
    </message>
    <message>
        <source>Change the notches of %1</source>
        <translation>Modifica le tacche di %1</translation>
    </message>
    <message>
        <source>Change the automatic notches</source>
        <translation>Modifica le tacche automatiche</translation>
    </message>
    <message>
        <source>Add a notch</source>
        <translation>Aggiungi una tacca</translation>
    </message>
    <message>
        <source>Change how %1 is cut</source>
        <translation>Modifica il taglio di %1</translation>
    </message>
    <message>
        <source>Change how the pattern is cut</source>
        <translation>Modifica il taglio del cartamodello</translation>
    </message>
    <message>
        <source>Add internal line %1</source>
        <translation>Aggiungi linea interna %1</translation>
    </message>
    <message>
        <source>Change the purpose of %1</source>
        <translation>Modifica lo scopo di %1</translation>
    </message>
    <message>
        <source>Change the ease of %1</source>
        <translation>Modifica la lentezza di %1</translation>
    </message>
    <message>
        <source>is %1, but must be a whole number; %2 are cut</source>
        <translation>è %1, ma deve essere un numero intero; se ne tagliano %2</translation>
    </message>
    <message>
        <source>%1 is an allowance of a part of this stretch already; remove one of the two, or make their stretches meet</source>
        <translation>%1 è già un margine di una parte di questo tratto; rimuovere uno dei due o far combaciare i loro tratti</translation>
    </message>
    <message>
        <source>the hole lies outside of &quot;%1&quot;; move it inside</source>
        <translation>il foro è fuori da «%1»; spostarlo all’interno</translation>
    </message>
    <message>
        <source>its sides are %1 mm and %2 mm long: true the seam, or say in its properties how much ease is wanted</source>
        <translation>i suoi lati sono lunghi %1&#xa0;mm e %2&#xa0;mm: pareggiarli o indicare nelle proprietà la lentezza voluta</translation>
    </message>
    <message>
        <source>its sides are %1 mm and %2 mm long, but the second one shall be longer by %3 mm: true the seam, or change the ease in its properties</source>
        <translation>i suoi lati sono lunghi %1&#xa0;mm e %2&#xa0;mm, ma il secondo deve essere più lungo di %3&#xa0;mm: pareggiarli o modificare la lentezza nelle proprietà</translation>
    </message>
    <message>
        <source>The mouth of a dart must be at least 1 mm wide.</source>
        <translation>L’apertura di una pince deve essere larga almeno 1&#xa0;mm.</translation>
    </message>
    <message>
        <source>The tip of a dart must lie inside its patch, at least 5 mm from its mouth.</source>
        <translation>La punta di una pince deve essere dentro il suo pezzo, ad almeno 5&#xa0;mm dall’apertura.</translation>
    </message>
    <message>
        <source>The legs of the dart would cross the outline of %1: put its tip elsewhere.</source>
        <translation>I lati della pince incrocerebbero il contorno di %1: mettere la punta altrove.</translation>
    </message>
    <message>
        <source>Add a dart to %1</source>
        <translation>Aggiungi una pince a %1</translation>
    </message>
    <message>
        <source>Select the seam of a dart.</source>
        <translation>Selezionare la cucitura di una pince.</translation>
    </message>
    <message>
        <source>Without this dart the outline of %1 would cross itself.</source>
        <translation>Senza questa pince il contorno di %1 incrocerebbe sé stesso.</translation>
    </message>
    <message>
        <source>Move a dart of %1</source>
        <translation>Sposta una pince di %1</translation>
    </message>
    <message>
        <source>there is no piece in it</source>
        <translation>non contiene alcun pezzo</translation>
    </message>
    <message>
        <source>Import a pattern of %1 pieces</source>
        <translation>Importa un cartamodello di %1 pezzi</translation>
    </message>
    <message>
        <source>%1 is left out: its outline crosses itself or encloses nothing</source>
        <translation>%1 viene omesso: il suo contorno incrocia sé stesso o non racchiude nulla</translation>
    </message>
    <message>
        <source>%1: %2 notches or lines belong to nothing and are left out</source>
        <translation>%1: %2 tacche o linee non appartengono a nulla e vengono omesse</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 points)</source>
        <translation>%1: contiene più disegno di quanto un cartamodello possa avere (oltre %2 punti)</translation>
    </message>
    <message>
        <source>%1: the file is larger than a pattern can be (%2 MB)</source>
        <translation>%1: il file è più grande di quanto un cartamodello possa essere (%2&#xa0;MB)</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a group code of DXF</source>
        <translation>%1: «%2» non è un codice di gruppo DXF</translation>
    </message>
    <message>
        <source>%1: the file ends in the middle of something</source>
        <translation>%1: il file si interrompe a metà</translation>
    </message>
    <message>
        <source>%1 is not a DXF file: it has no sections</source>
        <translation>%1 non è un file DXF: non ha sezioni</translation>
    </message>
    <message>
        <source>%1 is not an SVG file</source>
        <translation>%1 non è un file SVG</translation>
    </message>
    <message>
        <source>%1: this is not well-formed XML (%2)</source>
        <translation>%1: XML mal formato (%2)</translation>
    </message>
    <message>
        <source>Sew %1 proposed seams</source>
        <translation>Cuci %1 cuciture proposte</translation>
    </message>
    <message>
        <source>Remove a dart of %1</source>
        <translation>Rimuovi una pince di %1</translation>
    </message>
    <message>
        <source>Move the tip of a dart of %1</source>
        <translation>Sposta la punta di una pince di %1</translation>
    </message>
    <message>
        <source>Opened there, the outline of %1 would cross itself.</source>
        <translation>Aperto lì, il contorno di %1 incrocerebbe sé stesso.</translation>
    </message>
    <message>
        <source>The legs of the dart must be of one length to be rotated: drag its tip onto the dotted line.</source>
        <translation>Per ruotare la pince i suoi lati devono avere la stessa lunghezza: trascinare la punta sulla linea punteggiata.</translation>
    </message>
    <message>
        <source>A dart is rotated to a place at least 5 mm from its mouth.</source>
        <translation>Una pince si ruota in un punto ad almeno 5&#xa0;mm dalla sua apertura.</translation>
    </message>
    <message>
        <source>The line from the tip of the dart to there would leave %1.</source>
        <translation>La linea dalla punta della pince fin lì uscirebbe da %1.</translation>
    </message>
    <message>
        <source>%1 lies across the line from the tip of the dart to there: move it, or rotate the dart elsewhere.</source>
        <translation>%1 attraversa la linea dalla punta della pince fin lì: spostarlo o ruotare la pince altrove.</translation>
    </message>
    <message>
        <source>Rotate a dart of %1</source>
        <translation>Ruota una pince di %1</translation>
    </message>
    <message>
        <source>Smooth outlines across ends of seams</source>
        <translation>Raccorda i contorni attraverso le estremità delle cuciture</translation>
    </message>
    <message>
        <source>This seam ends in no corners: there is nothing to smooth.</source>
        <translation>Questa cucitura non finisce in angoli: non c’è nulla da raccordare.</translation>
    </message>
    <message>
        <source>The outlines meet at more than 60° there: that is a corner, and stays one.</source>
        <translation>Lì i contorni si incontrano a più di 60°: è un angolo e tale resta.</translation>
    </message>
    <message>
        <source>Sew earlier</source>
        <translation>Cuci prima</translation>
    </message>
    <message>
        <source>Sew later</source>
        <translation>Cuci dopo</translation>
    </message>
    <message>
        <source>Sew in the proposed order</source>
        <translation>Cuci nell’ordine proposto</translation>
    </message>
    <message>
        <source>Change the zip of %1</source>
        <translation>Modifica la cerniera di %1</translation>
    </message>
    <message>
        <source>Change when %1 is sewn</source>
        <translation>Modifica quando si cuce %1</translation>
    </message>
    <message>
        <source>its sides have allowances of %1 mm and %2 mm: make them alike, or mind it when they are laid together</source>
        <translation>i suoi lati hanno margini di %1&#xa0;mm e %2&#xa0;mm: renderli uguali o tenerne conto nell’accostarli</translation>
    </message>
    <message>
        <source>This edge of %1 is not as long as that.</source>
        <translation>Questo lato di %1 non è così lungo.</translation>
    </message>
    <message>
        <source>the pattern is so large that the edge length of its triangles becomes %1 mm; is the unit right?</source>
        <translation>il cartamodello è così grande che i lati dei suoi triangoli diventano di %1&#xa0;mm; l’unità è giusta?</translation>
    </message>
    <message>
        <source>%1 is left out: it is %2 m large, the most is %3 m; is the unit right?</source>
        <translation>%1 viene omesso: misura %2&#xa0;m, il massimo è %3&#xa0;m; l’unità è giusta?</translation>
    </message>
    <message>
        <source>%1 is left out: its outline has fewer than three points</source>
        <translation>%1 viene omesso: il suo contorno ha meno di tre punti</translation>
    </message>
    <message>
        <source>%1 is left out: of the %2 points of its outline no curve with at most %3 can be made</source>
        <translation>%1 viene omesso: dai %2 punti del suo contorno non si ottiene una curva con al massimo %3</translation>
    </message>
    <message>
        <source>%1: its outline has more than %2 points and is simplified, by %3 mm at most</source>
        <translation>%1: il suo contorno ha più di %2 punti e viene semplificato, al massimo di %3&#xa0;mm</translation>
    </message>
    <message>
        <source>%1: its quantity &quot;%2&quot; is no number of pieces; it is cut once until somebody says how often</source>
        <translation>%1: la sua quantità «%2» non è un numero di pezzi; viene tagliato una volta finché non si indica quante</translation>
    </message>
    <message>
        <source>%1: its quantity %2 is more than possible and becomes %3</source>
        <translation>%1: la sua quantità %2 supera il possibile e diventa %3</translation>
    </message>
    <message>
        <source>%1: %2 drill holes are narrower than %3 mm or wider than %4 mm and become as wide as possible</source>
        <translation>%1: %2 fori sono più stretti di %3&#xa0;mm o più larghi di %4&#xa0;mm e diventano larghi quanto possibile</translation>
    </message>
    <message>
        <source>%1 is left out: it would be a patch with mistakes</source>
        <translation>%1 viene omesso: sarebbe un pezzo con errori</translation>
    </message>
    <message>
        <source>%1: the file ends in the middle of its section %2, so it is not whole; get it once more</source>
        <translation>%1: il file finisce a metà della sezione %2, quindi non è completo; procurarselo di nuovo</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 groups)</source>
        <translation>%1: contiene più disegno di quanto un cartamodello possa avere (oltre %2 gruppi)</translation>
    </message>
    <message>
        <source>%1: %2 is larger than any pattern (%3)</source>
        <translation>%1: %2 è più grande di qualsiasi cartamodello (%3)</translation>
    </message>
    <message>
        <source>the mark at the end of the file (EOF) is missing: look whether everything is there</source>
        <translation>manca il segno di fine file (EOF): controllare che ci sia tutto</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is inserted more often than a pattern needs (over %3 times)</source>
        <translation>%1: «%2» è inserito più spesso di quanto serva a un cartamodello (oltre %3 volte)</translation>
    </message>
    <message>
        <source>%1: an element has more than %2 attributes</source>
        <translation>%1: un elemento ha più di %2 attributi</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 elements)</source>
        <translation>%1: contiene più disegno di quanto un cartamodello possa avere (oltre %2 elementi)</translation>
    </message>
    <message>
        <source>%1: elements lie in each other more than %2 times</source>
        <translation>%1: gli elementi sono annidati per oltre %2 livelli</translation>
    </message>
    <message>
        <source>&quot;%1&quot; would be replaced, which is needed; choose another name</source>
        <translation>«%1» verrebbe sostituito, ma serve; scegliere un altro nome</translation>
    </message>
    <message>
        <source>there is no cover yet: nothing is sewn or solved</source>
        <translation>non c’è ancora un rivestimento: nulla è cucito o calcolato</translation>
    </message>
    <message>
        <source>there is not enough memory for this file</source>
        <translation>la memoria non basta per questo file</translation>
    </message>
    <message>
        <source>the cover cannot be made a file (%1)</source>
        <translation>impossibile fare un file del rivestimento (%1)</translation>
    </message>
    <message>
        <source>the cover is %1 mm thick and has %2 cm³</source>
        <translation>il rivestimento è spesso %1&#xa0;mm e ha %2&#xa0;cm³</translation>
    </message>
    <message>
        <source>there is no room for foam between the frame and the cover</source>
        <translation>tra telaio e rivestimento non c’è spazio per l’espanso</translation>
    </message>
    <message>
        <source>the foam has %1 l and weighs %2 kg at %3 kg/m³</source>
        <translation>l’espanso ha %1&#xa0;l e pesa %2&#xa0;kg a %3&#xa0;kg/m³</translation>
    </message>
    <message>
        <source>there are neither fixation curves nor seams</source>
        <translation>non ci sono né curve di fissaggio né cuciture</translation>
    </message>
    <message>
        <source>The three places lie on a line: choose some that do not.</source>
        <translation>Le tre posizioni sono su una retta: sceglierne altre.</translation>
    </message>
    <message>
        <source>The places are not as far from each other on the scan as where they belong: check the scale of the scan, and which is which.</source>
        <translation>Le distanze tra le posizioni sulla scansione sono diverse da quelle di destinazione: controllare la scala della scansione e le corrispondenze.</translation>
    </message>
    <message>
        <source>The scan could not be aligned: there are not enough of its points where it would stand. Click other places, or bring back what is cut away of it.</source>
        <translation>La scansione non può essere allineata: dove si collocherebbe ha troppo pochi punti. Fare clic su altre posizioni o ripristinare ciò che ne è stato ritagliato.</translation>
    </message>
    <message>
        <source>%1: the numbers of &quot;%2&quot; are not described as they must be: &quot;%3&quot;</source>
        <translation>%1: i numeri di «%2» non sono descritti come devono: «%3»</translation>
    </message>
    <message>
        <source>%1: the file is damaged: something is said to be at byte %2, where nothing can be; copy it again, or export the scan anew</source>
        <translation>%1: il file è danneggiato: qualcosa sarebbe al byte %2, dove non può esserci nulla; copiarlo di nuovo o riesportare la scansione</translation>
    </message>
    <message>
        <source>%1: the file is damaged: a checksum is wrong; copy it again, or export the scan anew</source>
        <translation>%1: il file è danneggiato: una somma di controllo è errata; copiarlo di nuovo o riesportare la scansione</translation>
    </message>
    <message>
        <source>%1 is not an E57 file</source>
        <translation>%1 non è un file E57</translation>
    </message>
    <message>
        <source>%1: E57 of version %2 cannot be read, or its pages have another size than 1024; export the scan as E57 1.0</source>
        <translation>%1: E57 in versione %2 non è leggibile, o le sue pagine non sono di 1024; esportare la scansione come E57 1.0</translation>
    </message>
    <message>
        <source>%1: the pose of a scan is no rotation and translation</source>
        <translation>%1: la posa di una scansione non è una rotazione e traslazione</translation>
    </message>
    <message>
        <source>%1: two scans are said to be at one place of the file; export them anew</source>
        <translation>%1: due scansioni sarebbero nello stesso punto del file; riesportarle</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; of the points is missing or no number of things</source>
        <translation>%1: «%2» dei punti manca o non è un numero di elementi</translation>
    </message>
    <message>
        <source>%1: the file is damaged: a packet of points is not as it must be; export the scan anew</source>
        <translation>%1: il file è danneggiato: un pacchetto di punti non è come deve; riesportare la scansione</translation>
    </message>
    <message>
        <source>%1: the points are packed by &quot;%2&quot;, which cannot be read; export the scan without an extension</source>
        <translation>%1: i punti sono compressi con «%2», non leggibile; esportare la scansione senza estensione</translation>
    </message>
    <message>
        <source>%1: more is described in it than a scan can have</source>
        <translation>%1: vi è descritto più di quanto una scansione possa avere</translation>
    </message>
    <message>
        <source>%1: numbers that belong to one point lie too far from each other; export the scan anew</source>
        <translation>%1: i numeri di uno stesso punto sono troppo lontani tra loro; riesportare la scansione</translation>
    </message>
    <message>
        <source>%1: a document type is not expected here</source>
        <translation>%1: qui un tipo di documento è inatteso</translation>
    </message>
    <message>
        <source>%1 is not a LAS file</source>
        <translation>%1 non è un file LAS</translation>
    </message>
    <message>
        <source>%1 is compressed (LAZ), which cannot be read: save it as LAS, for example with laszip or CloudCompare, or as E57</source>
        <translation>%1 è compresso (LAZ) e non leggibile: salvarlo come LAS, ad esempio con laszip o CloudCompare, o come E57</translation>
    </message>
    <message>
        <source>%1: points of format %2 with %3 bytes cannot be read; save them as LAS 1.2 or 1.4</source>
        <translation>%1: punti in formato %2 con %3 byte non sono leggibili; salvarli come LAS 1.2 o 1.4</translation>
    </message>
    <message>
        <source>%1: its scale and offset make no points</source>
        <translation>%1: scala e offset non danno punti</translation>
    </message>
    <message>
        <source>%1: the points are said to begin within the header</source>
        <translation>%1: i punti inizierebbero già nell’intestazione</translation>
    </message>
    <message>
        <source>The second side ends inside an edge, so the first one was changed.</source>
        <translation>Il secondo lato finisce dentro un lato del contorno, perciò è stato modificato il primo.</translation>
    </message>
    <message>
        <source>it has no triangle with an area</source>
        <translation>non ha triangoli con un’area</translation>
    </message>
    <message>
        <source>%1 is left out: laid flat it would lie over itself. Divide it, or cut it in where it bulges most</source>
        <translation>%1 viene omesso: steso in piano si sovrapporrebbe a sé stesso. Dividerlo o inciderlo dove è più bombato</translation>
    </message>
    <message>
        <source>the stretch does not lie on its outline any more. Sew or fix it anew.</source>
        <translation>il tratto non è più sul suo contorno. Cucirlo o fissarlo di nuovo.</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which reads such files for Bolster, cannot be started; install Bolster again</source>
        <translation>il programma «%1», che legge questi file per Bolster, non si avvia; reinstallare Bolster</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes too long to read; export fewer parts of it, or triangles (OBJ, STL) instead</source>
        <translation>la lettura di «%1» richiede troppo tempo; esportarne meno parti o invece triangoli (OBJ, STL)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be read: it is damaged, or needs too much memory; export it again, or fewer parts of it, from the program that it comes from</source>
        <translation>«%1» non è leggibile: è danneggiato o richiede troppa memoria; riesportarlo, o esportarne meno parti, dal programma d’origine</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds no faces, and a frame needs some; export bodies or surfaces, not lines and points alone</source>
        <translation>«%1» non contiene facce, necessarie per un telaio; esportare corpi o superfici, non solo linee e punti</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than %2 triangles; export fewer parts of it, or coarser</source>
        <translation>«%1» ha più di %2 triangoli; esportarne meno parti o in modo meno fine</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than %2 parts; export those that the cover touches</source>
        <translation>«%1» ha più di %2 parti; esportare quelle che il rivestimento tocca</translation>
    </message>
    <message>
        <source>%1: the part &quot;%2&quot; reaches beyond 10,000,000; export it without that part, or near the origin</source>
        <translation>%1: la parte «%2» supera 10&#xa0;000&#xa0;000; esportarlo senza quella parte o vicino all’origine</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs the file &quot;%2&quot; in its own folder; copy it there, or export as GLB, which is one file</source>
        <translation>«%1» richiede il file «%2» nella propria cartella; copiarvelo o esportare come GLB, che è un file unico</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged or incomplete, or not what its ending says; export it again from the program that it comes from</source>
        <translation>«%1» è danneggiato, incompleto o non è ciò che indica l’estensione; riesportarlo dal programma d’origine</translation>
    </message>
    <message>
        <source>%1: %2 triangles are left out: their corners are no numbers</source>
        <translation>%1: %2 triangoli vengono omessi: i loro vertici non sono numeri</translation>
    </message>
    <message>
        <source>%1: parts are left out that are scaled to nothing: %2, the first is &quot;%3&quot;</source>
        <translation>%1: parti omesse perché scalate a zero: %2, la prima è «%3»</translation>
    </message>
    <message>
        <source>%1: %2 faces could not be made triangles of, and leave holes</source>
        <translation>%1: %2 facce non sono scomponibili in triangoli e lasciano fori</translation>
    </message>
    <message>
        <source>%1: %2 parts are left out that lie too deep in the tree</source>
        <translation>%1: %2 parti troppo in profondità nell’albero vengono omesse</translation>
    </message>
    <message>
        <source>%1: the parts in the file &quot;%2&quot; are not read; export all in one file</source>
        <translation>%1: le parti nel file «%2» non vengono lette; esportare tutto in un unico file</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no file that frames are written to; OBJ, PLY and STL are</source>
        <translation>«%1» non è un file in cui si scrivono telai; lo sono OBJ, PLY e STL</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a scan that can be read; these can: %2</source>
        <translation>«%1» non è una scansione leggibile; lo sono: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a frame that can be read; these can: %2</source>
        <translation>«%1» non è un telaio leggibile; lo sono: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a pattern that can be read; these can: %2</source>
        <translation>«%1» non è un cartamodello leggibile; lo sono: %2</translation>
    </message>
    <message>
        <source>nothing is left of the parts that are wanted</source>
        <translation>non resta nulla delle parti volute</translation>
    </message>
    <message>
        <source>nothing is sewn where %1 of its notches are, so they have no partners</source>
        <translation>dove sono %1 delle sue tacche non si cuce nulla, quindi non hanno corrispondenti</translation>
    </message>
    <message>
        <source>notches at edges without an allowance cut into the piece: there are %1; give these edges an allowance</source>
        <translation>le tacche sui lati senza margine entrano nel pezzo: sono %1; dare un margine a questi lati</translation>
    </message>
    <message>
        <source>There is a dart already: put this one beside it, or remove that one first.</source>
        <translation>C’è già una pince: mettere questa accanto o prima rimuovere quella.</translation>
    </message>
    <message>
        <source>%1 is left out: with its holes, notches and lines the design would have more than %2 elements</source>
        <translation>%1 viene omesso: con i suoi fori, tacche e linee il modello avrebbe più di %2 elementi</translation>
    </message>
    <message>
        <source>%1: its nap &quot;%2&quot; is neither one way, two ways nor any; it is taken for two ways</source>
        <translation>%1: il suo verso del pelo «%2» non è né un senso, né due sensi, né qualsiasi; si assumono due sensi</translation>
    </message>
    <message>
        <source>%1 is drawn larger by what its fabric shrinks (%2), and taken as it is drawn: a shrinkage of the fabric here would come on top</source>
        <translation>%1 è disegnato più grande del ritiro del suo tessuto (%2) ed è preso così com’è: un ritiro del tessuto qui si aggiungerebbe</translation>
    </message>
    <message>
        <source>the viewBox &quot;%1&quot; is no four numbers and is left out: check the size of the pieces</source>
        <translation>la viewBox «%1» non è fatta di quattro numeri e viene ignorata: controllare le dimensioni dei pezzi</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs the file &quot;%2&quot; beside it, and the frame of a design is one file; import it again, or export it as GLB</source>
        <translation>«%1» richiede accanto il file «%2», ma il telaio di un modello è un file unico; importarlo di nuovo o esportarlo come GLB</translation>
    </message>
    <message>
        <source>99 % of its surface is within %1 mm</source>
        <translation>il 99&#xa0;% della sua superficie è entro %1&#xa0;mm</translation>
    </message>
    <message>
        <source>it reaches beyond its piece: end it at the edge</source>
        <translation>esce dal suo pezzo: farla finire sul bordo</translation>
    </message>
    <message>
        <source>the hole breaks through the edge of its piece: move it inwards, or make it smaller</source>
        <translation>il foro rompe il bordo del suo pezzo: spostarlo verso l’interno o rimpicciolirlo</translation>
    </message>
    <message>
        <source>only %1 mm are left of the piece at the tip of a dart: make it shorter</source>
        <translation>alla punta di una pince restano solo %1&#xa0;mm del pezzo: accorciarla</translation>
    </message>
    <message>
        <source>%1 of its notches have no partners on the other sides of their seams: others are too near there. Ask for fewer</source>
        <translation>%1 delle sue tacche non hanno corrispondenti sull’altro lato delle cuciture: lì altre sono troppo vicine. Chiederne meno</translation>
    </message>
    <message>
        <source>%1 has %2 sewing lines beside each other; the largest is taken, the others are left out</source>
        <translation>%1 ha %2 linee di cucitura affiancate; si prende la più grande, le altre vengono omesse</translation>
    </message>
    <message>
        <source>%1: its cut line lies %2 mm outside of its sewing line, which is wider than an allowance may be; it becomes %3 mm there</source>
        <translation>%1: la sua linea di taglio è %2&#xa0;mm fuori dalla linea di cucitura, più di quanto ammesso per un margine; lì diventa %3&#xa0;mm</translation>
    </message>
    <message>
        <source>The cover is pulled to the scan where it lies now: switch &quot;Fit the cover to it&quot; off, place it, and switch that on again.</source>
        <translation>Il rivestimento è tirato verso la scansione dove si trova ora: disattivare «Adatta il rivestimento», posizionarla e riattivarlo.</translation>
    </message>
    <message>
        <source>Place on the cover to %2 mm rms: %1 (%3 % of its points matched)</source>
        <translation>Posiziona sul rivestimento, %2&#xa0;mm rms: %1 (%3&#xa0;% dei suoi punti abbinati)</translation>
    </message>
    <message>
        <source>The scan could not be placed: it is too far from the cover. Align it by three places, or cut away what does not belong to it.</source>
        <translation>La scansione non può essere posizionata: è troppo lontana dal rivestimento. Allinearla con tre posizioni o ritagliare ciò che non c’entra.</translation>
    </message>
    <message>
        <source>Align to %2 mm rms: %1 (%3 % of its points matched)</source>
        <translation>Allinea, %2&#xa0;mm rms: %1 (%3&#xa0;% dei suoi punti abbinati)</translation>
    </message>
    <message>
        <source>Import the pattern of %1</source>
        <translation>Importa il cartamodello di %1</translation>
    </message>
    <message>
        <source>%1: a gap of %2 mm in its outline is closed by a straight line</source>
        <translation>%1: un’interruzione di %2&#xa0;mm nel contorno viene chiusa con una retta</translation>
    </message>
    <message>
        <source>%1: its cut line is drawn anew from its allowances, and differs from that of the file by up to %2 mm</source>
        <translation>%1: la sua linea di taglio è ridisegnata dai margini e differisce da quella del file fino a %2&#xa0;mm</translation>
    </message>
    <message>
        <source>the size &quot;%1&quot; of the page is in no unit that is known and is left out: check the size of the pieces</source>
        <translation>la dimensione «%1» della pagina è in un’unità sconosciuta e viene ignorata: controllare le dimensioni dei pezzi</translation>
    </message>
    <message>
        <source>Sew a proposed seam</source>
        <translation>Cuci una cucitura proposta</translation>
    </message>
    <message>
        <source>it is in %1 pieces</source>
        <translation>è in %1 pezzi</translation>
    </message>
    <message>
        <source>one piece of less than 1 cm³ is left out</source>
        <translation>un pezzo inferiore a 1&#xa0;cm³ viene omesso</translation>
    </message>
    <message>
        <source>%1 pieces of less than 1 cm³ are left out</source>
        <translation>%1 pezzi inferiori a 1&#xa0;cm³ vengono omessi</translation>
    </message>
    <message>
        <source>Change whether the cover fits %1</source>
        <translation>Cambia se il rivestimento si adatta a %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs too much memory: it has too many parts, or places them too often; export those that the cover touches</source>
        <translation>«%1» richiede troppa memoria: ha troppe parti o le ripete troppo spesso; esportare quelle che il rivestimento tocca</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has decimal commas; export it with decimal points</source>
        <translation>«%1» ha virgole decimali; esportarlo con punti decimali</translation>
    </message>
    <message>
        <source>%1: triangles are left out that name points which are not in the file</source>
        <translation>%1: vengono omessi triangoli che indicano punti assenti nel file</translation>
    </message>
    <message>
        <source>%1: %2 triangles are left out: they name points that are not in the file</source>
        <translation>%1: %2 triangoli vengono omessi: indicano punti assenti nel file</translation>
    </message>
    <message>
        <source>%1: none of its %2 points has a place</source>
        <translation>%1: nessuno dei suoi %2 punti ha una posizione</translation>
    </message>
    <message>
        <source>%1: %2 points are left out: they have no place, as where a scanner saw nothing</source>
        <translation>%1: %2 punti vengono omessi: non hanno posizione, come dove lo scanner non ha visto nulla</translation>
    </message>
    <message>
        <source>%1 is text in UTF-16, which is not read; save it as UTF-8</source>
        <translation>%1 è testo in UTF-16, che non viene letto; salvarlo come UTF-8</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; has a decimal comma; export with decimal points</source>
        <translation>%1: «%2» ha una virgola decimale; esportare con punti decimali</translation>
    </message>
    <message>
        <source>Make the pattern of a form</source>
        <translation>Crea il cartamodello di una forma</translation>
    </message>
    <message>
        <source>Fit the pattern to a goal</source>
        <translation>Adatta il cartamodello a un obiettivo</translation>
    </message>
    <message>
        <source>it has %1 triangles, and cannot be made simpler</source>
        <translation>ha %1 triangoli e non può essere semplificata</translation>
    </message>
    <message>
        <source>The form has %1 triangles; %2 stand for it, which are up to %3 mm off</source>
        <translation>La forma ha %1 triangoli; la rappresentano %2, con scarto fino a %3&#xa0;mm</translation>
    </message>
    <message>
        <source>%1 ends inside a piece, at %2: it is cut in there like a dart. The next line or border is %3 mm away; draw it on to there to divide the piece</source>
        <translation>%1 finisce dentro un pezzo, in %2: lì si incide come per una pince. La linea o il bordo più vicino dista %3&#xa0;mm; prolungarla fin lì per dividere il pezzo</translation>
    </message>
    <message>
        <source>No place of the cover is near the form: put it where the cover is, in millimetres.</source>
        <translation>Nessun punto del rivestimento è vicino alla forma: metterla dove si trova il rivestimento, in millimetri.</translation>
    </message>
    <message>
        <source>Nothing that may change does anything to the cover.</source>
        <translation>Nulla di ciò che può cambiare influisce sul rivestimento.</translation>
    </message>
    <message>
        <source>A step would have turned the outline of %1 over itself; a smaller one was taken</source>
        <translation>Un passo avrebbe ribaltato su sé stesso il contorno di %1; ne è stato fatto uno più piccolo</translation>
    </message>
    <message>
        <source>Nothing may change.</source>
        <translation>Nulla può cambiare.</translation>
    </message>
    <message>
        <source>The cover does not come to rest.</source>
        <translation>Il rivestimento non va a riposo.</translation>
    </message>
    <message>
        <source>Make %1 longer by %3 mm where it is sewn to %2</source>
        <translation>Allunga %1 di %3&#xa0;mm dove è cucito a %2</translation>
    </message>
    <message>
        <source>Make %1 shorter by %3 mm where it is sewn to %2</source>
        <translation>Accorcia %1 di %3&#xa0;mm dove è cucito a %2</translation>
    </message>
    <message>
        <source>Move the seam of %1 and %2 by %3 mm into %2</source>
        <translation>Sposta la cucitura di %1 e %2 di %3&#xa0;mm dentro %2</translation>
    </message>
    <message>
        <source>Move the seam of %1 and %2 by %3 mm into %1</source>
        <translation>Sposta la cucitura di %1 e %2 di %3&#xa0;mm dentro %1</translation>
    </message>
    <message>
        <source>Let out the corner of %1 at %2 by %3 mm</source>
        <translation>Allarga l’angolo di %1 in %2 di %3&#xa0;mm</translation>
    </message>
    <message>
        <source>Take in the corner of %1 at %2 by %3 mm</source>
        <translation>Stringi l’angolo di %1 in %2 di %3&#xa0;mm</translation>
    </message>
    <message>
        <source>Cut a dart into %1 at %2, %3 mm wide and %4 mm deep</source>
        <translation>Taglia una pince in %1 in %2, larga %3&#xa0;mm e profonda %4&#xa0;mm</translation>
    </message>
    <message>
        <source>Make the seam of %1 and %2 smooth</source>
        <translation>Rendi liscia la cucitura di %1 e %2</translation>
    </message>
    <message>
        <source>Let the seam of %1 and %2 be sharp</source>
        <translation>Lascia viva la cucitura di %1 e %2</translation>
    </message>
    <message>
        <source>it is no file of preferences: it breaks off or has a mistake at character %1; choose one that Bolster has exported</source>
        <translation>non è un file di preferenze: si interrompe o contiene un errore al carattere %1; sceglierne uno esportato da Bolster</translation>
    </message>
    <message>
        <source>it is no file of preferences; choose one that Bolster has exported</source>
        <translation>non è un file di preferenze; sceglierne uno esportato da Bolster</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be what it is there; remove that line from the file, or export it again</source>
        <translation>«%1» non può avere il valore indicato; rimuovere quella riga dal file o esportarlo di nuovo</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, where a portable Bolster keeps settings and work, cannot be written; copy its folder to where you may write</source>
        <translation>«%1», dove un Bolster portatile conserva impostazioni e lavoro, non può essere scritto; copiare la cartella di Bolster dove è consentito scrivere</translation>
    </message>
    <message>
        <source>the disk with &quot;%1&quot; is full; make room on it, and change a setting once more: all of them are kept then</source>
        <translation>il disco con «%1» è pieno; libera spazio e cambia ancora un’impostazione: allora vengono conservate tutte</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be written; give yourself the right to write there and in its folder, and change a setting once more: all of them are kept then</source>
        <translation>non è stato possibile scrivere «%1»; concediti il diritto di scrivere lì e nella sua cartella e cambia ancora un’impostazione: allora vengono conservate tutte</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands there twice; remove one of its lines from the file, or export it again</source>
        <translation>«%1» vi compare due volte; togli una delle righe dal file o esportalo di nuovo</translation>
    </message>
    <message>
        <source>Change the note of %1</source>
        <translation>Modifica la nota di %1</translation>
    </message>
    <message>
        <source>Add measurement %1</source>
        <translation>Aggiungi misura %1</translation>
    </message>
    <message>
        <source>it does not lie in &quot;%1&quot; any more; measure anew</source>
        <translation>non si trova più in «%1»; misurare di nuovo</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; holds other files: choose one of its own.</source>
        <translation>La cartella «%1» contiene altri file: sceglierne una apposita.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; holds the work of another design or of other options: choose another folder.</source>
        <translation>La cartella «%1» contiene il lavoro di un altro progetto o di altre opzioni: scegliere un’altra cartella.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be made (%2).</source>
        <translation>Impossibile creare la cartella «%1» (%2).</translation>
    </message>
    <message>
        <source>Remove %1 and what needs it (%2 elements)</source>
        <translation>Rimuovi %1 e ciò che ne ha bisogno (%2 elementi)</translation>
    </message>
    <message>
        <source>one version was saved</source>
        <translation>È stata recuperata una versione</translation>
    </message>
    <message>
        <source>%1: none of its triangles has an area</source>
        <translation>%1: nessuno dei suoi triangoli ha un’area</translation>
    </message>
    <message>
        <source>Where a piece would have had a hole or been a ring it is cut and sewn again, number of cuts: %1</source>
        <translation>Dove un pezzo avrebbe un foro o sarebbe un anello è tagliato e ricucito, numero di tagli: %1</translation>
    </message>
    <message>
        <source>%1 is stretched by %2 % along the grain, its fabric allows %3 %</source>
        <translation>%1 si allunga del %2&#xa0;% in drittofilo, il suo tessuto tollera il %3&#xa0;%</translation>
    </message>
    <message>
        <source>%1 is stretched by %2 % across the grain, its fabric allows %3 %</source>
        <translation>%1 si allunga del %2&#xa0;% in traverso, il suo tessuto tollera il %3&#xa0;%</translation>
    </message>
    <message>
        <source>%1 is sheared by %2 %, its fabric allows %3 %</source>
        <translation>%1 ha uno scorrimento del %2&#xa0;%, il suo tessuto tollera il %3&#xa0;%</translation>
    </message>
    <message>
        <source>The form has one side only, as a twisted band: it is left open where its outside meets its inside</source>
        <translation>La forma ha un solo lato, come un nastro ritorto: resta aperta dove l’esterno incontra l’interno</translation>
    </message>
    <message>
        <source>Parts of %1 that are shorter than a mesh edge have gone with the cut.</source>
        <translation>Le parti di %1 più corte di un lato della maglia sono scomparse con il taglio.</translation>
    </message>
    <message>
        <source>the usual value is used instead</source>
        <translation>al suo posto si usa il valore abituale</translation>
    </message>
    <message>
        <source>it is the project that is open here; choose another name</source>
        <translation>è il progetto aperto qui; scegliere un altro nome</translation>
    </message>
    <message>
        <source>the file is empty; nothing was written to it, or it was lost</source>
        <translation>il file è vuoto; non vi è stato scritto nulla, o è andato perso</translation>
    </message>
    <message>
        <source>it is open in another window; choose another name</source>
        <translation>è aperto in un’altra finestra; scelga un altro nome</translation>
    </message>
    <message>
        <source>the disk of &quot;%1&quot; is full, where work is protected from crashes; make room, and open it again</source>
        <translation>il disco di «%1», dove il lavoro è protetto dai blocchi, è pieno; faccia spazio e lo riapra</translation>
    </message>
    <message>
        <source>The form is %1 mm large: with edges of %2 mm its cover has more triangles than can be solved. See whether the unit is right; else make the mesh edges at least %3 mm long</source>
        <translation>La forma è grande %1 mm: con spigoli di %2 mm il suo rivestimento ha più triangoli di quanti se ne possano risolvere. Controlli se l’unità è giusta; altrimenti faccia gli spigoli della mesh lunghi almeno %3 mm</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already; choose another name</source>
        <translation>«%1» esiste già; scelga un altro nome</translation>
    </message>
    <message>
        <source>%1 is strained by %2 % when it lies on the form, more than any fabric bears. Divide it, or cut it in where it bulges most</source>
        <translation>%1 si deforma del %2 % quando sta sulla forma, più di quanto regga qualsiasi tessuto. La divida, o la incida dove è più bombata</translation>
    </message>
    <message>
        <source>Let no scan pull at the cover</source>
        <translation>Nessuna scansione tira il rivestimento</translation>
    </message>
    <message>
        <source>%1 bends too sharply at %2: it is not cut along it</source>
        <translation>%1 si piega troppo in %2: lì non si taglia</translation>
    </message>
    <message>
        <source>The form goes through itself at %2: it is not cut along %1</source>
        <translation>La forma attraversa sé stessa in %2: non si taglia lungo %1</translation>
    </message>
    <message>
        <source>What is closed all around has no border to be held at: its cover is fixed along its seams. Delete the fixations of those that are to be free</source>
        <translation>Ciò che è chiuso tutto intorno non ha un bordo a cui tenerlo: il suo rivestimento è fissato lungo le cuciture. Eliminate i fissaggi di quelle che devono restare libere</translation>
    </message>
    <message>
        <source>No vertex of the area is near the form: make the area larger than the mesh edges, or put the form where the cover is.</source>
        <translation>Nessun vertice dell’area è vicino alla forma: ingrandire l’area oltre gli spigoli della maglia, o mettere la forma dove si trova il rivestimento.</translation>
    </message>
    <message>
        <source>%1 is left out: it is too narrow to be sewn. Join it to what lies beside it</source>
        <translation>%1 viene omesso: è troppo stretto per essere cucito. Unirlo a ciò che gli sta accanto</translation>
    </message>
    <message>
        <source>Make the pattern of a form again</source>
        <translation>Crea di nuovo il cartamodello di una forma</translation>
    </message>
    <message>
        <source>Make the pattern of %1 again</source>
        <translation>Crea di nuovo il cartamodello di %1</translation>
    </message>
    <message>
        <source>Make the pattern of %1</source>
        <translation>Crea il cartamodello di %1</translation>
    </message>
    <message>
        <source>Fit the pattern to %1, %2 mm from it</source>
        <translation>Adatta il cartamodello a %1, a %2&#xa0;mm di distanza</translation>
    </message>
    <message>
        <source>Fit the pattern to %1</source>
        <translation>Adatta il cartamodello a %1</translation>
    </message>
    <message>
        <source>Fit the pattern to a limit of strain, %1 % of the cover over it</source>
        <translation>Adatta il cartamodello a un limite di deformazione, %1&#xa0;% del rivestimento oltre</translation>
    </message>
    <message>
        <source>Let the scan pull at the cover again</source>
        <translation>La scansione tira di nuovo il rivestimento</translation>
    </message>
    <message>
        <source>%1 runs along %2, at %3: it is cut there once</source>
        <translation>%1 corre lungo %2, in %3: lì si taglia una volta sola</translation>
    </message>
    <message>
        <source>%1 runs along the border of the form, or where it is cut anyway, at %2: there is nothing to cut</source>
        <translation>%1 corre lungo il bordo della forma, o dove la si taglia comunque, in %2: non c’è niente da tagliare</translation>
    </message>
    <message>
        <source>%1 is too short or too long, at %2: it is not cut along it</source>
        <translation>%1 è troppo corta o troppo lunga, in %2: lì non si taglia</translation>
    </message>
    <message>
        <source>%1 is %2 mm away from the form, at %3: it is not cut along it</source>
        <translation>%1 dista %2&#xa0;mm dalla forma, in %3: lì non si taglia</translation>
    </message>
    <message>
        <source>lines cannot be cut into it: it has edges where more than two faces meet, or sheets that touch in a point, at %1</source>
        <translation>non vi si possono tagliare linee: ha spigoli dove si incontrano più di due facce, o superfici che si toccano in un punto, in %1</translation>
    </message>
    <message>
        <source>%1 cannot be cut into it, at %2: the form goes through itself there</source>
        <translation>non vi si può tagliare %1, in %2: lì la forma attraversa sé stessa</translation>
    </message>
    <message>
        <source>Small for the triangles of the cover, whose edges are %1 mm long: %2. Their shape will be coarse; with mesh edges of %3 mm it is not</source>
        <translation>Piccoli per i triangoli del rivestimento, i cui spigoli misurano %1&#xa0;mm: %2. La loro forma sarà grossolana; con spigoli della maglia di %3&#xa0;mm non lo è</translation>
    </message>
    <message>
        <source>Too small for the triangles of the cover, whose edges are %1 mm long: %2. Join them to what lies beside them, or leave them out</source>
        <translation>Troppo piccoli per i triangoli del rivestimento, i cui spigoli misurano %1&#xa0;mm: %2. Unirli a ciò che sta loro accanto o ometterli</translation>
    </message>
    <message>
        <source>After %1 iterations it cannot be told yet where the surface comes to rest. Allow more iterations.</source>
        <translation>Dopo %1 iterazioni non si può ancora dire dove la superficie si fermerà. Consentire più iterazioni.</translation>
    </message>
    <message>
        <source>Wider across the grain than the fabric, of which %1 mm can be used: %2. Divide them, or turn their grain</source>
        <translation>Più larghi attraverso il drittofilo del tessuto, di cui sono utilizzabili %1 mm: %2. Li divida o giri il loro drittofilo</translation>
    </message>
    <message>
        <source>%1 ends inside a piece, at %2: it is cut in there like a dart. There is no other line or border; lead it around to where it began to divide the piece</source>
        <translation>%1 finisce dentro un pezzo, in %2: lì si incide come per una pince. Non c’è altra linea né bordo; portarla intorno fino al suo inizio per dividere il pezzo</translation>
    </message>
    <message>
        <source>A line is not cut in at %1: the sides of the cut would lie over each other when it is laid flat. Draw it elsewhere, or on to a border</source>
        <translation>Una linea non viene incisa in %1: in piano i lati del taglio si sovrapporrebbero. La disegni altrove, o fino a un bordo</translation>
    </message>
    <message>
        <source>A line is not cut in at %1: the piece was divided another way. Draw it on to a border</source>
        <translation>Una linea non viene incisa in %1: il pezzo è stato diviso diversamente. La prolunghi fino a un bordo</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no design, but what one is made of: import it</source>
        <translation>«%1» non è un modello, ma ciò di cui se ne fa uno: importarlo</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by %2 mm in each: it does not come to rest. Make curves as long as the outlines they hold, or try other mesh edges.</source>
        <translation>Dopo %1 iterazioni la superficie si muove ancora di %2&#xa0;mm in ognuna: non va a riposo. Fare le curve lunghe quanto i contorni che tengono o provare altri lati della mesh.</translation>
    </message>
    <message>
        <source>%1, with what is sewn to it, is held only at a border of %2 mm: fix it along other curves, too, or close that hole of the form</source>
        <translation>%1, con ciò che vi è cucito, è tenuto solo da un bordo di %2&#xa0;mm: fissarlo anche lungo altre curve, oppure chiudere quel foro della forma</translation>
    </message>
    <message>
        <source>%1 is left out: it is closed all around and cannot be laid flat. Cut it along lines</source>
        <translation>%1 viene omesso: è chiuso tutt’intorno e non si può stendere in piano. Tagliarlo lungo linee</translation>
    </message>
    <message>
        <source>%1 is left out: it has a handle, like a cup, and cannot be laid flat. Cut it along lines</source>
        <translation>%1 viene omesso: ha un manico, come una tazza, e non si può stendere in piano. Tagliarlo lungo linee</translation>
    </message>
    <message>
        <source>Let out %1 by %3 mm where it is sewn to %2</source>
        <translation>Allarga %1 di %3&#xa0;mm dove è cucito a %2</translation>
    </message>
    <message>
        <source>Take in %1 by %3 mm where it is sewn to %2</source>
        <translation>Stringi %1 di %3&#xa0;mm dove è cucito a %2</translation>
    </message>
    <message>
        <source>Let out %1 by %3 mm where the curve %2 holds it</source>
        <translation>Allarga %1 di %3&#xa0;mm dove lo tiene la curva %2</translation>
    </message>
    <message>
        <source>Take in %1 by %3 mm where the curve %2 holds it</source>
        <translation>Stringi %1 di %3&#xa0;mm dove lo tiene la curva %2</translation>
    </message>
    <message>
        <source>What would not lie flat, or be strained by more than the fabric may be, is divided, which makes so many pieces more: %1</source>
        <translation>Ciò che non starebbe in piano, o si tenderebbe più di quanto il tessuto consente, è diviso. Pezzi in più: %1</translation>
    </message>
    <message>
        <source>%1 is not divided: more than %2 pieces would be needed until it lies flat. It is rough, as scans are: smooth it, or fit a cover to it and take that</source>
        <translation>%1 non viene diviso: servirebbero più di %2 pezzi perché stia in piano. È ruvido, come lo sono le scansioni: lo si lisci, oppure si adatti a esso un rivestimento e si prenda quello</translation>
    </message>
    <message>
        <source>%1 is left out: it has more than %2 holes. Close them, or cut it along lines</source>
        <translation>%1 viene omesso: ha più di %2 fori. Chiuderli, o tagliarlo lungo linee</translation>
    </message>
    <message>
        <source>Too narrow for the triangles of the cover, whose edges are %1 mm long, so that it cannot be solved: %2. Make the mesh edges shorter, or join them to what lies beside them</source>
        <translation>Troppo stretti per i triangoli del rivestimento, i cui lati misurano %1&#xa0;mm, così che non si può calcolare: %2. Accorciare i lati della mesh, o unirli a ciò che sta loro accanto</translation>
    </message>
    <message>
        <source>Lead open seam lines on</source>
        <translation>Prolungare le linee di cucitura aperte</translation>
    </message>
    <message>
        <source>Lead %1 on</source>
        <translation>Prolungare %1</translation>
    </message>
    <message>
        <source>Bodies of the form go through each other, as at %1: what of one lies inside of another one is covered, too, and pushed out. Unite them before, or leave one out. Number of such pairs: %2</source>
        <translation>Ci sono corpi della forma che si attraversano, come in %1: ciò che di uno sta dentro un altro viene rivestito anch’esso, e spinto fuori. Unirli prima, oppure tralasciarne uno. Numero di queste coppie: %2</translation>
    </message>
    <message>
        <source>Faces of the form that lie where another one lies, and are left out: %1</source>
        <translation>Facce della forma che stanno dove ce n’è già un’altra, e sono tralasciate: %1</translation>
    </message>
    <message>
        <source>Faces of the form that were turned round: %1</source>
        <translation>Facce della forma che sono state rivoltate: %1</translation>
    </message>
    <message>
        <source>Edges of the form that belong to more than two faces, so that they are borders and nothing is sewn there: %1</source>
        <translation>Spigoli della forma che appartengono a più di due facce, per cui sono bordi e lì non si cuce nulla: %1</translation>
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
        <translation>Maiusc</translation>
    </message>
    <message>
        <source>middle button</source>
        <translation>pulsante centrale</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>pulsante destro</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>trascinare</translation>
    </message>
    <message>
        <source>two fingers</source>
        <translation>due dita</translation>
    </message>
    <message>
        <source>pinch or Ctrl+wheel</source>
        <translation>pizzico o Ctrl+rotellina</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>rotellina</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>CAD (like SolidWorks)</source>
        <translation>CAD (come SolidWorks)</translation>
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
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>From the corner</source>
        <translation>Dall’angolo</translation>
    </message>
    <message>
        <source>Along the outline from the nearer corner, on the same side of it.</source>
        <translation>Lungo il contorno dall’angolo più vicino, dallo stesso lato.</translation>
    </message>
</context>
<context>
    <name>OrientationFields</name>
    <message>
        <source>Free</source>
        <translation>Libera</translation>
    </message>
    <message>
        <source>Normal held</source>
        <translation>Normale vincolata</translation>
    </message>
    <message>
        <source>Tangent plane held</source>
        <translation>Piano tangente vincolato</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>Inclinazione</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direzione</translation>
    </message>
    <message>
        <source>%1 directions, interpolated along the curve; the first is shown.</source>
        <translation>%1 direzioni, interpolate lungo la curva; è mostrata la prima.</translation>
    </message>
</context>
<context>
    <name>OutlineTool</name>
    <message>
        <source>This cannot be a patch: %1</source>
        <translation>Questo non può essere un pezzo: %1</translation>
    </message>
    <message>
        <source>The outline would cross itself here – Backspace takes a point back</source>
        <translation>Qui il contorno incrocerebbe sé stesso – Backspace toglie un punto</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no length: try 500, 500&lt;30 or 120, 40</source>
        <translation>«%1» non è una lunghezza: ad esempio 500, 500&lt;30 o 120, 40</translation>
    </message>
    <message>
        <source>Click to set the first corner, press and drag for a smooth point – Esc ends the tool</source>
        <translation>Clic per il primo angolo, premere e trascinare per un punto curvo – Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>Click to close the outline</source>
        <translation>Clic per chiudere il contorno</translation>
    </message>
    <message>
        <source>Enter sets the point: 500 goes that far, 500&lt;30 at an angle, 120, 40 to the right and up</source>
        <translation>Invio fissa il punto: 500 a quella distanza, 500&lt;30 con un angolo, 120, 40 a destra e in alto</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, or type a length – Ctrl does not snap</source>
        <translation>Clic per un angolo, trascinare per un punto curvo o digitare una lunghezza – Ctrl esclude l’aggancio</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, type a length – Enter or a click on the first point closes, Backspace takes a point back</source>
        <translation>Clic per un angolo, trascinare per un punto curvo, digitare una lunghezza – Invio o un clic sul primo punto chiude, Backspace toglie un punto</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
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
        <translation>Contorno</translation>
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
        <translation>Pezzo %1</translation>
    </message>
    <message>
        <source>An outline needs at least three points in different places.</source>
        <translation>Un contorno richiede almeno tre punti in posizioni diverse.</translation>
    </message>
    <message>
        <source>This cannot be a patch: %1</source>
        <translation>Questo non può essere un pezzo: %1</translation>
    </message>
</context>
<context>
    <name>PatchForm</name>
    <message>
        <source>Outline</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Dimensioni</translation>
    </message>
    <message>
        <source>Width and height as it lies in the pattern view.</source>
        <translation>Larghezza e altezza come si presenta nella vista del cartamodello.</translation>
    </message>
</context>
<context>
    <name>PatternDrawTool</name>
    <message>
        <source>Begin inside a patch.</source>
        <translation>Iniziare dentro un pezzo.</translation>
    </message>
    <message>
        <source>Fancy seam %1</source>
        <translation>Cucitura decorativa %1</translation>
    </message>
    <message>
        <source>Handle %1</source>
        <translation>Maniglia %1</translation>
    </message>
    <message>
        <source>A curve needs two points, a closed one three.</source>
        <translation>Una curva richiede due punti, una chiusa tre.</translation>
    </message>
    <message>
        <source>There is no surface in this patch yet on which the handle could lie.</source>
        <translation>Questo pezzo non ha ancora una superficie su cui la maniglia possa stare.</translation>
    </message>
    <message>
        <source>Click inside a patch to begin a handle curve – Esc ends the tool</source>
        <translation>Fare clic dentro un pezzo per iniziare una curva maniglia – Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>Click inside a patch or on its outline to begin a fancy seam – Esc ends the tool</source>
        <translation>Fare clic dentro un pezzo o sul suo contorno per iniziare una cucitura decorativa – Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>Click to close the curve</source>
        <translation>Clic per chiudere la curva</translation>
    </message>
    <message>
        <source>Click for the next point, double click or Enter ends – B makes it straight, Backspace takes a point back</source>
        <translation>Clic per il punto successivo, doppio clic o Invio termina – B rende dritto, Backspace toglie un punto</translation>
    </message>
    <message>
        <source>Click for the next point, double click or Enter ends – B makes it smooth, Backspace takes a point back</source>
        <translation>Clic per il punto successivo, doppio clic o Invio termina – B rende curvo, Backspace toglie un punto</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Linea %1</translation>
    </message>
    <message>
        <source>Click inside a patch or on its outline to begin a line for the cutter – Esc ends the tool</source>
        <translation>Fare clic dentro un pezzo o sul suo contorno per iniziare una linea per il taglio – Esc chiude lo strumento</translation>
    </message>
</context>
<context>
    <name>PatternPdf</name>
    <message>
        <source>1 inch</source>
        <translation>1 pollice</translation>
    </message>
    <message>
        <source>Print at 100 %</source>
        <translation>Stampare al 100&#xa0;%</translation>
    </message>
    <message>
        <source>%1 – print at 100 %</source>
        <translation>%1 – stampare al 100&#xa0;%</translation>
    </message>
    <message>
        <source>Overview of %1 x %2 sheets</source>
        <translation>Quadro d’insieme di %1 x %2 fogli</translation>
    </message>
    <message>
        <source>%1: sheet %2</source>
        <translation>%1: foglio %2</translation>
    </message>
    <message>
        <source>%1: sheets %2 to %3</source>
        <translation>%1: fogli da %2 a %3</translation>
    </message>
    <message>
        <source>100 mm: to measure, no part of the pattern</source>
        <translation>100&#xa0;mm: per verifica, non è parte del cartamodello</translation>
    </message>
    <message>
        <source>Sheet %1 (row %2 of %3, column %4 of %5)</source>
        <translation>Foglio %1 (riga %2 di %3, colonna %4 di %5)</translation>
    </message>
</context>
<context>
    <name>PatternSelectTool</name>
    <message>
        <source>There is a control point already.</source>
        <translation>Qui c’è già un punto di controllo.</translation>
    </message>
    <message>
        <source>Drag to turn the selected patches in the layout</source>
        <translation>Trascinare per ruotare i pezzi selezionati nel layout</translation>
    </message>
    <message>
        <source>Drag to move the control point – Shift+click selects several, Del removes</source>
        <translation>Trascinare per spostare il punto di controllo – Maiusc+clic ne seleziona più d’uno, Canc lo rimuove</translation>
    </message>
    <message>
        <source>Click to select the patch, drag to move it in the layout</source>
        <translation>Clic per selezionare il pezzo, trascinare per spostarlo nel layout</translation>
    </message>
    <message>
        <source>Click to select the curve, drag to move it, double click to add a control point here</source>
        <translation>Clic per selezionare la curva, trascinare per spostarla, doppio clic per aggiungere qui un punto di controllo</translation>
    </message>
    <message>
        <source>Drag to scale the selected patches – Shift keeps the proportions</source>
        <translation>Trascinare per scalare i pezzi selezionati – Maiusc mantiene le proporzioni</translation>
    </message>
    <message>
        <source>Drag to move this end of the stretch along the outline</source>
        <translation>Trascinare per spostare questa estremità del tratto lungo il contorno</translation>
    </message>
    <message>
        <source>Drag to move the edge, double click to add a control point here – its length is in the properties</source>
        <translation>Trascinare per spostare il lato, doppio clic per aggiungere qui un punto di controllo – la sua lunghezza è nelle proprietà</translation>
    </message>
    <message>
        <source>Click to select the edge, double click to add a control point here, drag to move the patch</source>
        <translation>Clic per selezionare il lato, doppio clic per aggiungere qui un punto di controllo, trascinare per spostare il pezzo</translation>
    </message>
    <message>
        <source>Click to select the seam and the edge, double click to add a control point here</source>
        <translation>Clic per selezionare la cucitura e il lato, doppio clic per aggiungere qui un punto di controllo</translation>
    </message>
    <message>
        <source>Click to select it, drag to move it, Delete removes it</source>
        <translation>Clic per selezionare, trascinare per spostare, Canc rimuove</translation>
    </message>
    <message>
        <source>Drag the tip of the dart</source>
        <translation>Trascinare la punta della pince</translation>
    </message>
    <message>
        <source>Drag the dart along the outline</source>
        <translation>Trascinare la pince lungo il contorno</translation>
    </message>
    <message>
        <source>Drag the label to where it can be read, click to select the patch</source>
        <translation>Trascinare l’etichetta dove si può leggere, clic per selezionare il pezzo</translation>
    </message>
    <message>
        <source>Click to select, drag a box to select several – %1 or Space pans, %2 zooms</source>
        <translation>Clic per selezionare, trascinare un riquadro per selezionare più elementi – %1 o Spazio sposta la vista, %2 esegue lo zoom</translation>
    </message>
    <message>
        <source>Click to select the measurement, Delete removes it</source>
        <translation>Clic per selezionare la misura, Canc la rimuove</translation>
    </message>
</context>
<context>
    <name>PatternSplitTool</name>
    <message>
        <source>Click beside a patch or on its outline to begin the cut – Esc ends the tool</source>
        <translation>Fare clic accanto a un pezzo o sul suo contorno per iniziare il taglio – Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>Double click or Enter splits the patch – click to bend the cut, Backspace takes a point back</source>
        <translation>Doppio clic o Invio divide il pezzo – clic per piegare il taglio, Backspace toglie un punto</translation>
    </message>
    <message>
        <source>Click on the other side of the patch – Shift keeps the cut straight, Backspace takes a point back</source>
        <translation>Fare clic sull’altro lato del pezzo – Maiusc mantiene dritto il taglio, Backspace toglie un punto</translation>
    </message>
</context>
<context>
    <name>PatternTool</name>
    <message>
        <source>Moved by %1, %2 – Shift keeps to one axis, Esc takes it back</source>
        <translation>Spostato di %1, %2 – Maiusc mantiene un asse, Esc annulla</translation>
    </message>
    <message>
        <source>Turned by %1 – Shift turns in steps of 15°, Esc takes it back</source>
        <translation>Ruotato di %1 – Maiusc ruota a passi di 15°, Esc annulla</translation>
    </message>
    <message>
        <source>Release to select what lies in the box – Shift adds, Esc takes it back</source>
        <translation>Rilasciare per selezionare ciò che è nel riquadro – Maiusc aggiunge, Esc annulla</translation>
    </message>
    <message>
        <source>Release to select what lies in the loop – Shift adds, Esc takes it back</source>
        <translation>Rilasciare per selezionare ciò che è nel lazo – Maiusc aggiunge, Esc annulla</translation>
    </message>
    <message>
        <source>Enter moves it so far: 50, or 30, 20</source>
        <translation>Invio sposta di tanto: 50 oppure 30, 20</translation>
    </message>
    <message>
        <source>Enter turns it by this angle, counter-clockwise: 45</source>
        <translation>Invio ruota di questo angolo, in senso antiorario: 45</translation>
    </message>
    <message>
        <source>Enter makes it this size: 300 x 200, 300 (wide, in proportion), or 120 %</source>
        <translation>Invio dà queste dimensioni: 300 x 200, 300 (larghezza, in proporzione) o 120&#xa0;%</translation>
    </message>
    <message>
        <source>Scaled to %1 × %2 – or type the size; Shift keeps the proportions, Esc takes it back</source>
        <translation>Scalato a %1 × %2 – oppure digitare le dimensioni; Maiusc mantiene le proporzioni, Esc annulla</translation>
    </message>
</context>
<context>
    <name>PatternToolHost</name>
    <message>
        <source>%1 Let go here, and it goes back to where it was.</source>
        <translation>%1 Rilasciando qui, tutto torna dov’era.</translation>
    </message>
</context>
<context>
    <name>PieceCuttingSection</name>
    <message>
        <source>Cutting</source>
        <translation>Taglio</translation>
    </message>
    <message>
        <source>Own seam allowance</source>
        <translation>Margine di cucitura proprio</translation>
    </message>
    <message>
        <source>Label where it finds room</source>
        <translation>Etichetta dove c’è spazio</translation>
    </message>
</context>
<context>
    <name>PlacementGizmo</name>
    <message>
        <source>Turned by %1° – Ctrl snaps to 15°, Escape cancels</source>
        <translation>Ruotato di %1° – Ctrl aggancia a 15°, Esc annulla</translation>
    </message>
    <message>
        <source>Drag to move it along this axis</source>
        <translation>Trascinare per spostare lungo questo asse</translation>
    </message>
    <message>
        <source>Drag to turn it about this axis</source>
        <translation>Trascinare per ruotare attorno a questo asse</translation>
    </message>
    <message>
        <source>Drag to move it parallel to the picture</source>
        <translation>Trascinare per spostare parallelamente all’immagine</translation>
    </message>
    <message>
        <source>Moved by x %1, y %2, z %3 – Ctrl snaps to %4, Escape cancels</source>
        <translation>Spostato di x %1, y %2, z %3 – Ctrl aggancia a %4, Esc annulla</translation>
    </message>
</context>
<context>
    <name>PreferenceCommands</name>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation>Pre&amp;ferenze…</translation>
    </message>
    <message>
        <source>Units, language, theme, mouse, keys and more</source>
        <translation>Unità, lingua, tema, mouse, tasti e altro</translation>
    </message>
    <message>
        <source>The preferences could not be stored: they hold only until Bolster is closed.</source>
        <translation>Non è stato possibile salvare le preferenze: valgono solo finché Bolster resta aperto.</translation>
    </message>
</context>
<context>
    <name>Preferences</name>
    <message>
        <source>Millimetres (314 mm)</source>
        <translation>Millimetri (314&#xa0;mm)</translation>
    </message>
    <message>
        <source>Centimetres (31.4 cm)</source>
        <translation>Centimetri (31,4&#xa0;cm)</translation>
    </message>
    <message>
        <source>Inches (12 3/8″)</source>
        <translation>Pollici (12 3/8″)</translation>
    </message>
    <message>
        <source>Up to 1/8</source>
        <translation>Fino a 1/8</translation>
    </message>
    <message>
        <source>Up to 1/16</source>
        <translation>Fino a 1/16</translation>
    </message>
    <message>
        <source>Up to 1/32</source>
        <translation>Fino a 1/32</translation>
    </message>
    <message>
        <source>Up to 1/64</source>
        <translation>Fino a 1/64</translation>
    </message>
    <message>
        <source>Decimals (12.375)</source>
        <translation>Decimali (12,375)</translation>
    </message>
    <message>
        <source>Of the language</source>
        <translation>Della lingua</translation>
    </message>
    <message>
        <source>Comma (1,5)</source>
        <translation>Virgola (1,5)</translation>
    </message>
    <message>
        <source>Point (1.5)</source>
        <translation>Punto (1.5)</translation>
    </message>
    <message>
        <source>Of the system</source>
        <translation>Del sistema</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Come il sistema</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Chiaro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Scuro</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Alto contrasto</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Completa</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Ridotta</translation>
    </message>
    <message>
        <source>Plain, as it comes</source>
        <translation>Tinta unita, predefinito</translation>
    </message>
    <message>
        <source>Units and numbers</source>
        <translation>Unità e numeri</translation>
    </message>
    <message>
        <source>Language and looks</source>
        <translation>Lingua e aspetto</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Mouse</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Tastiera</translation>
    </message>
    <message>
        <source>Pattern view</source>
        <translation>Vista cartamodello</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Vista 3D</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Lavoro non salvato</translation>
    </message>
    <message>
        <source>New designs</source>
        <translation>Nuovi modelli</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>Lunghezze in</translation>
    </message>
    <message>
        <source>unit measure metric imperial millimetre centimetre inch</source>
        <translation>unità misura metrico imperiale millimetri centimetri pollici mm cm lunghezza</translation>
    </message>
    <message>
        <source>How lengths are shown. Whatever it is, you may type others: 3 in, 2.5 cm, 1&apos; 2 3/8&quot;. Designs keep millimetres, and so do printed sheets and files.</source>
        <translation>Come sono mostrate le lunghezze. In ogni caso si possono digitare anche altre unità: «3&#xa0;in», «2,5&#xa0;cm», «1&apos; 2 3/8&quot;». I modelli restano in millimetri, come i fogli stampati e i file.</translation>
    </message>
    <message>
        <source>Parts of an inch</source>
        <translation>Frazioni di pollice</translation>
    </message>
    <message>
        <source>fraction imperial 1/16 decimals</source>
        <translation>frazione imperiale 1/16 decimali pollice</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>Separatore decimale</translation>
    </message>
    <message>
        <source>comma point dot separator numbers</source>
        <translation>virgola punto separatore decimali numeri segno</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Lingua</translation>
    </message>
    <message>
        <source>translation words english german deutsch</source>
        <translation>traduzione parole inglese tedesco italiano english idioma</translation>
    </message>
    <message>
        <source>Bolster speaks it when it is started the next time.</source>
        <translation>Vale dal prossimo avvio di Bolster.</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>colours dark light contrast night appearance accessibility</source>
        <translation>colori scuro chiaro contrasto notte aspetto accessibilità</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Size of the letters</source>
        <translation>Dimensione dei caratteri</translation>
    </message>
    <message>
        <source>font text large small zoom scale accessibility</source>
        <translation>carattere font testo grande piccolo zoom scala accessibilità</translation>
    </message>
    <message>
        <source>Move the views as in</source>
        <translation>Muovere le viste come in</translation>
    </message>
    <message>
        <source>navigation rotate turn pan zoom buttons trackpad orbit preset</source>
        <translation>navigazione ruotare girare spostare zoom pulsanti trackpad orbita preimpostazione</translation>
    </message>
    <message>
        <source>Zoom the other way round</source>
        <translation>Zoom in senso inverso</translation>
    </message>
    <message>
        <source>invert wheel scroll reverse direction</source>
        <translation>invertire inverti rotellina scorrimento contrario direzione</translation>
    </message>
    <message>
        <source>Keys as in</source>
        <translation>Tasti come in</translation>
    </message>
    <message>
        <source>shortcuts hotkeys preset</source>
        <translation>scorciatoie tasti rapidi tastiera preimpostazione</translation>
    </message>
    <message>
        <source>Some commands get the keys that you know from there. Keys that you have chosen yourself stay.</source>
        <translation>Alcuni comandi ricevono i tasti già noti da quei programmi. I tasti scelti personalmente restano.</translation>
    </message>
    <message>
        <source>Snap to points, edges, guides and the grid</source>
        <translation>Aggancio a punti, lati, guide e griglia</translation>
    </message>
    <message>
        <source>magnet catch align</source>
        <translation>magnete calamita agganciare allineare snap</translation>
    </message>
    <message>
        <source>Ctrl or Alt lets go while you drag.</source>
        <translation>Ctrl o Alt lo esclude durante il trascinamento.</translation>
    </message>
    <message>
        <source>Show rulers</source>
        <translation>Mostra righelli</translation>
    </message>
    <message>
        <source>scale measure</source>
        <translation>scala misura righello</translation>
    </message>
    <message>
        <source>Show guides</source>
        <translation>Mostra guide</translation>
    </message>
    <message>
        <source>lines help</source>
        <translation>linee aiuto guida</translation>
    </message>
    <message>
        <source>Quality of the picture</source>
        <translation>Qualità dell’immagine</translation>
    </message>
    <message>
        <source>performance slow fast remote desktop graphics opengl</source>
        <translation>prestazioni lento veloce desktop remoto grafica opengl</translation>
    </message>
    <message>
        <source>Reduced: fewer pixels and triangles, no soft shadows. For slow machines and for screens that are far away. Pictures that you export stay fine.</source>
        <translation>Ridotta: meno pixel e triangoli, niente ombre morbide. Per computer lenti e schermi remoti. Le immagini esportate restano di qualità piena.</translation>
    </message>
    <message>
        <source>Go to other views at once, without a flight</source>
        <translation>Cambio di vista immediato, senza animazione</translation>
    </message>
    <message>
        <source>reduced motion animation camera accessibility remote</source>
        <translation>movimento ridotto animazione telecamera accessibilità remoto</translation>
    </message>
    <message>
        <source> days</source>
        <translation> giorni</translation>
    </message>
    <message>
        <source>Keep work that was thrown away for</source>
        <translation>Conserva il lavoro scartato per</translation>
    </message>
    <message>
        <source>autosave backup recovery crash journal bin unsaved delete</source>
        <translation>salvataggio automatico backup recupero arresto crash journal cestino non salvato elimina</translation>
    </message>
    <message>
        <source>Every step is on the disk as soon as it is done, so there is no interval to set. Unsaved work stays until you open it again or throw it away; after that it lies in the bin for at least 30 days.</source>
        <translation>Ogni passo è sul disco appena è fatto, perciò non c’è un intervallo da impostare. Il lavoro non salvato resta finché non viene riaperto o scartato; poi sta nel cestino per almeno 30 giorni.</translation>
    </message>
    <message>
        <source>Fabric of new patches</source>
        <translation>Tessuto dei nuovi pezzi</translation>
    </message>
    <message>
        <source>default material leather weave colour</source>
        <translation>predefinito materiale pelle tela trama colore</translation>
    </message>
    <message>
        <source>A new design begins with it, and patches are made of a design&apos;s first fabric.</source>
        <translation>Un nuovo modello inizia con questo, e i pezzi sono del primo tessuto del modello.</translation>
    </message>
    <message>
        <source>Seam allowance</source>
        <translation>Margine di cucitura</translation>
    </message>
    <message>
        <source>default cutting margin hem width</source>
        <translation>predefinito taglio margine orlo larghezza</translation>
    </message>
    <message>
        <source>New designs begin with it; in a design it is changed in its properties.</source>
        <translation>I nuovi modelli iniziano con questo; in un modello si modifica nelle sue proprietà.</translation>
    </message>
    <message>
        <source>Folder of your fabrics</source>
        <translation>Cartella dei tessuti</translation>
    </message>
    <message>
        <source>library directory path import export picture swatch</source>
        <translation>raccolta libreria cartella percorso importa esporta immagine campione</translation>
    </message>
    <message>
        <source>Where fabrics and their pictures are looked for first. Without one it is the folder of the design.</source>
        <translation>Dove si cercano per primi i tessuti e le loro immagini. Se manca, è la cartella del modello.</translation>
    </message>
    <message>
        <source>Lengths are kept as they are, and shown to the nearest part; what is shorter than one has decimals.</source>
        <translation>Le lunghezze restano come sono e si mostrano alla frazione più vicina; ciò che è più corto ha decimali.</translation>
    </message>
</context>
<context>
    <name>SavedViewCommands</name>
    <message>
        <source>&amp;Save view …</source>
        <translation>&amp;Salva vista…</translation>
    </message>
    <message>
        <source>&amp;Delete view</source>
        <translation>&amp;Elimina vista</translation>
    </message>
    <message>
        <source>View %1 deleted</source>
        <translation>Vista %1 eliminata</translation>
    </message>
    <message>
        <source>Save view</source>
        <translation>Salva vista</translation>
    </message>
    <message>
        <source>Name of the view; one of the same name is replaced:</source>
        <translation>Nome della vista; una con lo stesso nome viene sostituita:</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vista %1</translation>
    </message>
    <message>
        <source>View %1 saved: View &gt; Saved views</source>
        <translation>Vista %1 salvata: Visualizza &gt; Viste salvate</translation>
    </message>
</context>
<context>
    <name>ScanAlignTool</name>
    <message>
        <source>There is no point of the scan here: click on one.</source>
        <translation>Qui non c’è alcun punto della scansione: fare clic su uno.</translation>
    </message>
    <message>
        <source>There is neither a frame nor the cover here: click where that place of the scan belongs.</source>
        <translation>Qui non c’è né un telaio né il rivestimento: fare clic dove va quella posizione della scansione.</translation>
    </message>
    <message>
        <source>Take the last place &amp;back</source>
        <translation>&amp;Togli l’ultima posizione</translation>
    </message>
    <message>
        <source>Click on the frame or the cover where place %1 of the scan belongs – Backspace takes it back</source>
        <translation>Fare clic sul telaio o sul rivestimento dove va la posizione %1 della scansione – Backspace la toglie</translation>
    </message>
    <message>
        <source>Click on a place of the scan that can be told from others, such as a corner – drag turns the view, Esc ends the tool</source>
        <translation>Fare clic su una posizione della scansione distinguibile dalle altre, ad esempio un angolo – trascinare ruota la vista, Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>Click on place %1 of 3 of the scan, far from the others – Backspace takes one back</source>
        <translation>Fare clic sulla posizione %1 di 3 della scansione, lontano dalle altre – Backspace ne toglie una</translation>
    </message>
    <message>
        <source>%1: where it belongs</source>
        <translation>%1: dove va</translation>
    </message>
    <message>
        <source>%1: on the scan</source>
        <translation>%1: sulla scansione</translation>
    </message>
    <message>
        <source>The scan is no longer there – Esc ends the tool</source>
        <translation>La scansione non c’è più – Esc chiude lo strumento</translation>
    </message>
</context>
<context>
    <name>ScanCommands</name>
    <message>
        <source>&amp;Place on the cover</source>
        <translation>&amp;Posiziona sul rivestimento</translation>
    </message>
    <message>
        <source>Moves and turns the scan so that it lies on the cover as well as it can</source>
        <translation>Sposta e ruota la scansione perché aderisca il meglio possibile al rivestimento</translation>
    </message>
    <message>
        <source>&amp;Cut away …</source>
        <translation>&amp;Ritaglia…</translation>
    </message>
    <message>
        <source>Drag a rectangle in the 3D view over what is to be cut away of the scan</source>
        <translation>Tracciare nella vista 3D un rettangolo su ciò che va ritagliato dalla scansione</translation>
    </message>
    <message>
        <source>&amp;Keep only …</source>
        <translation>&amp;Mantieni solo…</translation>
    </message>
    <message>
        <source>Drag a rectangle in the 3D view around what is to be kept of the scan</source>
        <translation>Tracciare nella vista 3D un rettangolo intorno a ciò che va mantenuto della scansione</translation>
    </message>
    <message>
        <source>Keep &amp;around the cover</source>
        <translation>Mantieni &amp;intorno al rivestimento</translation>
    </message>
    <message>
        <source>Cuts away what is farther from the cover than the threshold</source>
        <translation>Ritaglia ciò che dista dal rivestimento più della soglia</translation>
    </message>
    <message>
        <source>&amp;Remove all cuts</source>
        <translation>Rimuovi &amp;tutti i ritagli</translation>
    </message>
    <message>
        <source>Brings back all that was cut away of the scan</source>
        <translation>Ripristina tutto ciò che è stato ritagliato dalla scansione</translation>
    </message>
    <message>
        <source>Choose another &amp;file …</source>
        <translation>Scegli un altro &amp;file…</translation>
    </message>
    <message>
        <source>Reads the scan from another file</source>
        <translation>Legge la scansione da un altro file</translation>
    </message>
    <message>
        <source>Select the scan that is meant.</source>
        <translation>Selezionare la scansione desiderata.</translation>
    </message>
    <message>
        <source>Placing the scan on the cover …</source>
        <translation>Posizionamento della scansione sul rivestimento…</translation>
    </message>
    <message>
        <source>Placing the scan on the cover: step %1</source>
        <translation>Posizionamento della scansione sul rivestimento: passo %1</translation>
    </message>
    <message>
        <source>A&amp;lign …</source>
        <translation>A&amp;llinea…</translation>
    </message>
    <message>
        <source>Click three places of the scan and where each belongs; the rest is found</source>
        <translation>Clic su tre posizioni della scansione e su dove va ognuna; il resto si trova da sé</translation>
    </message>
    <message>
        <source>Aligning the scan …</source>
        <translation>Allineamento della scansione…</translation>
    </message>
    <message>
        <source>Aligning the scan: step %1</source>
        <translation>Allineamento della scansione: passo %1</translation>
    </message>
</context>
<context>
    <name>ScanCutTool</name>
    <message>
        <source>Drag a rectangle around what is to be kept of the scan. Esc ends.</source>
        <translation>Tracciare un rettangolo intorno a ciò che va mantenuto della scansione. Esc termina.</translation>
    </message>
    <message>
        <source>Drag a rectangle over what is to be cut away of the scan. Esc ends.</source>
        <translation>Tracciare un rettangolo su ciò che va ritagliato dalla scansione. Esc termina.</translation>
    </message>
</context>
<context>
    <name>ScanForm</name>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Place on &amp;the cover</source>
        <translation>&amp;Posiziona sul rivestimento</translation>
    </message>
    <message>
        <source>Choose an&amp;other file …</source>
        <translation>Scegli un &amp;altro file…</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Contenuto</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 punti</translation>
    </message>
    <message>
        <source>%1 of %2 points, one every %3</source>
        <translation>%1 di %2 punti, uno ogni %3</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Scostamento</translation>
    </message>
    <message>
        <source>%1 rms</source>
        <translation>%1 rms</translation>
    </message>
    <message>
        <source>Median, 95 %</source>
        <translation>Mediana, 95&#xa0;%</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Massimo</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Copertura</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punti</translation>
    </message>
    <message>
        <source>Floor at</source>
        <translation>Pavimento a</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Ritagli</translation>
    </message>
    <message>
        <source>Cut awa&amp;y …</source>
        <translation>&amp;Ritaglia…</translation>
    </message>
    <message>
        <source>&amp;Keep only …</source>
        <translation>&amp;Mantieni solo…</translation>
    </message>
    <message>
        <source>Keep aroun&amp;d the cover</source>
        <translation>Mantieni &amp;intorno al rivestimento</translation>
    </message>
    <message>
        <source>Remove a&amp;ll cuts</source>
        <translation>Rimuovi &amp;tutti i ritagli</translation>
    </message>
    <message>
        <source>Ali&amp;gn …</source>
        <translation>A&amp;llinea…</translation>
    </message>
    <message>
        <source>Between the cover and the scan, where they are nearer than the threshold.</source>
        <translation>Tra rivestimento e scansione, dove distano meno della soglia.</translation>
    </message>
    <message>
        <source>Half of what is measured, and 95 % of it, is no farther from the scan than that.</source>
        <translation>La metà di ciò che è misurato, e il 95&#xa0;%, non è più lontano di così dalla scansione.</translation>
    </message>
    <message>
        <source>How much of the cover has points of the scan near it.</source>
        <translation>Quanta parte del rivestimento ha vicino punti della scansione.</translation>
    </message>
    <message>
        <source>Of the scan, without what is cut away.</source>
        <translation>Della scansione, senza ciò che è ritagliato.</translation>
    </message>
</context>
<context>
    <name>SeamForm</name>
    <message>
        <source>First side</source>
        <translation>Primo lato</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Second side</source>
        <translation>Secondo lato</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Lentezza</translation>
    </message>
</context>
<context>
    <name>SectionHandle</name>
    <message>
        <source>Section at %1 – Ctrl turns it by 15°, Escape puts it back</source>
        <translation>Sezione a %1 – Ctrl la ruota di 15°, Esc la ripristina</translation>
    </message>
    <message>
        <source>Drag to move the section, with Ctrl to turn it</source>
        <translation>Trascinare per spostare la sezione, con Ctrl per ruotarla</translation>
    </message>
</context>
<context>
    <name>SelectedEdgesForm</name>
    <message>
        <source>Edge length</source>
        <translation>Lunghezza lato</translation>
    </message>
    <message>
        <source>Edge lengths</source>
        <translation>Lunghezze lati</translation>
    </message>
    <message>
        <source>%1 edges. Of &quot;Make equally long&quot; the first one stays: %2 of %3.</source>
        <translation>%1 lati. Con «Rendi uguali» il primo resta com’è: %2 di %3.</translation>
    </message>
    <message>
        <source>Edge of</source>
        <translation>Lato di</translation>
    </message>
</context>
<context>
    <name>SelectedPointsForm</name>
    <message>
        <source>Points</source>
        <translation>Punti</translation>
    </message>
    <message>
        <source>Layout x, y</source>
        <translation>Layout x, y</translation>
    </message>
    <message>
        <source>Length between</source>
        <translation>Lunghezza intermedia</translation>
    </message>
    <message>
        <source>Space x, y, z</source>
        <translation>Spazio x, y, z</translation>
    </message>
</context>
<context>
    <name>SelectionEdits</name>
    <message>
        <source>Not removed: the curve needs these points.</source>
        <translation>Non rimossi: la curva ha bisogno di questi punti.</translation>
    </message>
    <message>
        <source>Not removed: other elements need this fabric.</source>
        <translation>Non rimosso: altri elementi hanno bisogno di questo tessuto.</translation>
    </message>
    <message>
        <source>An edge cannot be removed: its points can, or with Esc the whole patch.</source>
        <translation>Un lato non può essere rimosso: i suoi punti sì, o dopo Esc l’intero pezzo.</translation>
    </message>
</context>
<context>
    <name>SettingsForm</name>
    <message>
        <source>Patches</source>
        <translation>Pezzi</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Cuciture</translation>
    </message>
    <message>
        <source>Select something to see its properties.</source>
        <translation>Selezionare qualcosa per vederne le proprietà.</translation>
    </message>
    <message>
        <source>Symmetric design</source>
        <translation>Modello simmetrico</translation>
    </message>
    <message>
        <source>Plane through</source>
        <translation>Piano per</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Axis through</source>
        <translation>Asse per</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direzione</translation>
    </message>
    <message>
        <source>%1, %2 in all</source>
        <translation>%1, %2 in tutto</translation>
    </message>
    <message>
        <source>A point of the plane in which the cover is mirrored</source>
        <translation>Un punto del piano in cui il rivestimento è specchiato</translation>
    </message>
    <message>
        <source>The direction straight out of that plane</source>
        <translation>La direzione perpendicolare a quel piano</translation>
    </message>
    <message>
        <source>A point of the line of the pattern at which patches are mirrored</source>
        <translation>Un punto della linea del cartamodello rispetto alla quale i pezzi sono specchiati</translation>
    </message>
    <message>
        <source>The direction of that line</source>
        <translation>La direzione di quella linea</translation>
    </message>
    <message>
        <source>Twins are mirror images of each other. With this mark you say where the mirror stands; without it, it stands in the middle, between left and right.</source>
        <translation>I gemelli sono immagini speculari l’uno dell’altro. Con questo segno si stabilisce dove sta lo specchio; senza, sta nel mezzo, tra sinistra e destra.</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vertici</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>circa %1</translation>
    </message>
    <message>
        <source>How many points the cover has at this edge length: solving takes time and memory for each.</source>
        <translation>Quanti punti ha il rivestimento con questa lunghezza dello spigolo: ognuno costa tempo e memoria nel calcolo.</translation>
    </message>
</context>
<context>
    <name>SewPicture</name>
    <message>
        <source>Ease %1, %2</source>
        <translation>Lentezza %1, %2</translation>
    </message>
</context>
<context>
    <name>SewTool</name>
    <message>
        <source>Click on the outline of a patch.</source>
        <translation>Fare clic sul contorno di un pezzo.</translation>
    </message>
    <message>
        <source>Choose the other side first.</source>
        <translation>Scegliere prima l’altro lato.</translation>
    </message>
    <message>
        <source>Release where the stretch ends</source>
        <translation>Rilasciare dove finisce il tratto</translation>
    </message>
    <message>
        <source>Click where the stretch ends – Esc goes back</source>
        <translation>Fare clic dove finisce il tratto – Esc torna indietro</translation>
    </message>
    <message>
        <source>Click to sew it the other way round (F)</source>
        <translation>Clic per cucire nell’altro senso (F)</translation>
    </message>
    <message>
        <source>Click the edge to sew – drag along the outline, or Shift+click twice, for a part of it; Esc ends the tool</source>
        <translation>Fare clic sul lato da cucire – trascinare lungo il contorno, o due volte Maiusc+clic, per una sua parte; Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>Click the edges of the row one after the other, Enter sews – F flips, Backspace takes one back</source>
        <translation>Fare clic in sequenza sui lati della fila, Invio cuce – F inverte, Backspace ne toglie uno</translation>
    </message>
    <message>
        <source>Click the edge it is sewn to – F flips, Ctrl+click or M for several in a row, Backspace goes back</source>
        <translation>Fare clic sul lato a cui va cucito – F inverte, Ctrl+clic o M per più lati di seguito, Backspace torna indietro</translation>
    </message>
    <message>
        <source>Ctrl+click the next edge of the row, click the last one – Enter sews, F flips, Backspace takes one back</source>
        <translation>Ctrl+clic sul lato successivo della fila, clic sull’ultimo – Invio cuce, F inverte, Backspace ne toglie uno</translation>
    </message>
    <message>
        <source>&amp;Sew what is marked</source>
        <translation>&amp;Cuci i lati marcati</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>&amp;Inverti</translation>
    </message>
    <message>
        <source>Take &amp;one edge</source>
        <translation>Prendi &amp;un lato</translation>
    </message>
    <message>
        <source>Take se&amp;veral edges in a row</source>
        <translation>Prendi &amp;più lati di seguito</translation>
    </message>
    <message>
        <source>&amp;Take back the last edge</source>
        <translation>&amp;Togli l’ultimo lato</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>&amp;Abbandona</translation>
    </message>
</context>
<context>
    <name>SewingSheet</name>
    <message>
        <source>Sewing sheet</source>
        <translation>Scheda di cucitura</translation>
    </message>
    <message>
        <source>Sewing sheet: %1</source>
        <translation>Scheda di cucitura: %1</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materiali</translation>
    </message>
    <message>
        <source>Seams in the order of sewing</source>
        <translation>Cuciture nell’ordine di esecuzione</translation>
    </message>
    <message>
        <source>%1 and %1 mirrored</source>
        <translation>%1 e %1 speculari</translation>
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
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Quantità</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Tessuto</translation>
    </message>
    <message>
        <source>Area as cut</source>
        <translation>Area di taglio</translation>
    </message>
    <message>
        <source>top stitched on both sides</source>
        <translation>impunturata sui due lati</translation>
    </message>
    <message>
        <source>top stitched</source>
        <translation>impunturata</translation>
    </message>
    <message>
        <source>%1 mm long, %2 mm from the seam</source>
        <translation>punti di %1&#xa0;mm, a %2&#xa0;mm dalla cucitura</translation>
    </message>
    <message>
        <source>piping, %1 mm thick</source>
        <translation>bordino, spessore %1&#xa0;mm</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>semplice</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 e %2</translation>
    </message>
    <message>
        <source>%1, with itself</source>
        <translation>%1, con sé stesso</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Cucitura</translation>
    </message>
    <message>
        <source>Lengths, mm</source>
        <translation>Lunghezze, mm</translation>
    </message>
    <message>
        <source>Allowance, mm</source>
        <translation>Margine, mm</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Tacche</translation>
    </message>
    <message>
        <source>Stitch</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>%1 m², without what lies between the pieces</source>
        <translation>%1&#xa0;m², esclusi gli spazi tra i pezzi</translation>
    </message>
    <message>
        <source>Sewing thread</source>
        <translation>Filo per cucire</translation>
    </message>
    <message>
        <source>Top thread &lt;span style=&quot;background-color:%1&quot;&gt;&amp;nbsp;&amp;nbsp;&amp;nbsp;&amp;nbsp;&lt;/span&gt; %1</source>
        <translation>Filo per impunture &lt;span style=&quot;background-color:%1&quot;&gt;&#xa0;&#xa0;&#xa0;&#xa0;&lt;/span&gt; %1</translation>
    </message>
    <message>
        <source>%1 m, at %2 m for each metre of a row</source>
        <translation>%1&#xa0;m, con %2&#xa0;m per ogni metro di fila</translation>
    </message>
    <message>
        <source>Piping</source>
        <translation>Bordino</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1&#xa0;m</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Che cosa</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>Quanto</translation>
    </message>
    <message>
        <source>zip</source>
        <translation>cerniera</translation>
    </message>
    <message>
        <source>Zip</source>
        <translation>Cerniera</translation>
    </message>
    <message>
        <source>Pieces, with the numbers of their seams</source>
        <translation>Pezzi, con i numeri delle loro cuciture</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Cuciture</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N.</translation>
    </message>
    <message>
        <source>Width × height as cut</source>
        <translation>Larghezza × altezza di taglio</translation>
    </message>
    <message>
        <source>Ease, %</source>
        <translation>Lentezza, %</translation>
    </message>
    <message>
        <source>nap one way: all pieces point up</source>
        <translation>pelo a senso unico: tutti i pezzi con la testa in su</translation>
    </message>
</context>
<context>
    <name>SnapHints</name>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>Midpoint</source>
        <translation>Punto medio</translation>
    </message>
    <message>
        <source>On an outline</source>
        <translation>Su un contorno</translation>
    </message>
    <message>
        <source>Aligned</source>
        <translation>Allineato</translation>
    </message>
    <message>
        <source>Direction %1</source>
        <translation>Direzione %1</translation>
    </message>
    <message>
        <source>Perpendicular</source>
        <translation>Perpendicolare</translation>
    </message>
    <message>
        <source>As long: %1</source>
        <translation>Pari lunghezza: %1</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guida</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Griglia</translation>
    </message>
</context>
<context>
    <name>StartCommands</name>
    <message>
        <source>Start pa&amp;ge</source>
        <translation>Pagina ini&amp;ziale</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Nuova &amp;finestra</translation>
    </message>
    <message>
        <source>No other window could be opened.</source>
        <translation>Impossibile aprire un’altra finestra.</translation>
    </message>
    <message>
        <source>The system did not start the program again. Close some programs, and try once more.</source>
        <translation>Il sistema non ha riavviato il programma. Chiudere alcuni programmi e riprovare.</translation>
    </message>
    <message>
        <source>&amp;Report a problem …</source>
        <translation>Segna&amp;la un problema…</translation>
    </message>
    <message>
        <source>What&apos;s &amp;new</source>
        <translation>&amp;Novità</translation>
    </message>
    <message>
        <source>This is Bolster %1. What is new is under Help &gt; What&apos;s new.</source>
        <translation>Questo è Bolster %1. Le novità sono in Aiuto &gt; Novità.</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Mostra</translation>
    </message>
    <message>
        <source>The frame is in the 3D view. Draw the curves on it where the cloth is fixed, or the first patch.</source>
        <translation>Il telaio è nella vista 3D. Disegnarvi le curve a cui è fissato il tessuto, o il primo pezzo.</translation>
    </message>
    <message>
        <source>Draw a &amp;fixation curve</source>
        <translation>Disegna curva di &amp;fissaggio</translation>
    </message>
    <message>
        <source>Draw a &amp;rectangle</source>
        <translation>Disegna &amp;rettangolo</translation>
    </message>
    <message>
        <source>Pattern of a form …</source>
        <translation>Cartamodello di una forma…</translation>
    </message>
</context>
<context>
    <name>StretchEndDrag</name>
    <message>
        <source>%1 long – Ctrl lets go of what is near, Esc takes it back</source>
        <translation>Lungo %1 – Ctrl esclude l’aggancio, Esc annulla</translation>
    </message>
    <message>
        <source>%1 long, the other side %2: ease %3, %4 – Ctrl lets go of what is near, Esc takes it back</source>
        <translation>Lungo %1, l’altro lato %2: lentezza %3, %4 – Ctrl esclude l’aggancio, Esc annulla</translation>
    </message>
    <message>
        <source>End of another stretch</source>
        <translation>Estremità di un altro tratto</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Angolo</translation>
    </message>
    <message>
        <source>As long as the other side</source>
        <translation>Lungo quanto l’altro lato</translation>
    </message>
</context>
<context>
    <name>SurfaceCommands</name>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pausa</translation>
    </message>
    <message>
        <source>&amp;Figures …</source>
        <translation>&amp;Dati…</translation>
    </message>
</context>
<context>
    <name>SweepWindow</name>
    <message>
        <source>&amp;Cut</source>
        <translation>&amp;Taglio</translation>
    </message>
    <message>
        <source>Each piece is cut so much larger or smaller all around</source>
        <translation>Ogni pezzo è tagliato di tanto più grande o più piccolo tutt’intorno</translation>
    </message>
    <message>
        <source>Cut of %1</source>
        <translation>Taglio di %1</translation>
    </message>
    <message>
        <source>S&amp;eams</source>
        <translation>C&amp;uciture</translation>
    </message>
    <message>
        <source>Each seam is sewn so much farther inside or outside, on both sides</source>
        <translation>Ogni cucitura è cucita di tanto più all’interno o all’esterno, su entrambi i lati</translation>
    </message>
    <message>
        <source>Seam %1</source>
        <translation>Cucitura %1</translation>
    </message>
    <message>
        <source>&amp;Foam</source>
        <translation>&amp;Espanso</translation>
    </message>
    <message>
        <source>Each cushion and foam is so much thicker or thinner</source>
        <translation>Ogni imbottitura e ogni espanso è di tanto più spesso o più sottile</translation>
    </message>
    <message>
        <source>Thickness of %1</source>
        <translation>Spessore di %1</translation>
    </message>
    <message>
        <source>Fi&amp;xations</source>
        <translation>&amp;Fissaggi</translation>
    </message>
    <message>
        <source>Each fixation curve lies so much elsewhere, along each axis</source>
        <translation>Ogni curva di fissaggio è spostata di tanto, lungo ogni asse</translation>
    </message>
    <message>
        <source>Place of %1</source>
        <translation>Posizione di %1</translation>
    </message>
    <message>
        <source>S&amp;tiffness</source>
        <translation>Rig&amp;idezza</translation>
    </message>
    <message>
        <source>Each fabric is so much stiffer or softer</source>
        <translation>Ogni tessuto è di tanto più rigido o più morbido</translation>
    </message>
    <message>
        <source>Stiffness of %1</source>
        <translation>Rigidezza di %1</translation>
    </message>
    <message>
        <source>Sh&amp;rinkage</source>
        <translation>&amp;Ritiro</translation>
    </message>
    <message>
        <source>Each piece shrinks or stretches by so much</source>
        <translation>Ogni pezzo si ritira o si allunga di tanto</translation>
    </message>
    <message>
        <source>Shrinkage of %1</source>
        <translation>Ritiro di %1</translation>
    </message>
</context>
<context>
    <name>Templates</name>
    <message>
        <source>Cushion</source>
        <translation>Cuscino</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Cuscino a rullo</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>Panca</translation>
    </message>
    <message>
        <source>Dining chair</source>
        <translation>Sedia da pranzo</translation>
    </message>
    <message>
        <source>Wing chair</source>
        <translation>Poltrona bergère</translation>
    </message>
    <message>
        <source>Car seat</source>
        <translation>Sedile auto</translation>
    </message>
    <message>
        <source>Headrest</source>
        <translation>Poggiatesta</translation>
    </message>
</context>
<context>
    <name>ToolCommands</name>
    <message>
        <source>&amp;Select and move</source>
        <translation>&amp;Seleziona e sposta</translation>
    </message>
    <message>
        <source>Draw &amp;outline</source>
        <translation>Disegna &amp;contorno</translation>
    </message>
    <message>
        <source>Draw &amp;rectangle</source>
        <translation>Disegna &amp;rettangolo</translation>
    </message>
    <message>
        <source>Draw &amp;ellipse</source>
        <translation>Disegna &amp;ellisse</translation>
    </message>
    <message>
        <source>S&amp;plit patch</source>
        <translation>&amp;Dividi pezzo</translation>
    </message>
    <message>
        <source>Draw &amp;handle curve</source>
        <translation>Disegna curva &amp;maniglia</translation>
    </message>
    <message>
        <source>Draw &amp;fancy seam</source>
        <translation>Disegna cucitura decorati&amp;va</translation>
    </message>
    <message>
        <source>Se&amp;w</source>
        <translation>C&amp;uci</translation>
    </message>
    <message>
        <source>&amp;Attach to fixation curve</source>
        <translation>&amp;Fissa a curva di fissaggio</translation>
    </message>
    <message>
        <source>Stitch or pipe a seam</source>
        <translation>Impuntura o borda una cucitura</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>Misur&amp;a</translation>
    </message>
    <message>
        <source>&amp;Draw fixation curve</source>
        <translation>Disegna curva di fissa&amp;ggio</translation>
    </message>
    <message>
        <source>Draw &amp;internal line</source>
        <translation>Disegna &amp;linea interna</translation>
    </message>
    <message>
        <source>Allowance of an ed&amp;ge</source>
        <translation>Margi&amp;ne di un lato</translation>
    </message>
    <message>
        <source>&amp;Corner of the cut line</source>
        <translation>Ang&amp;olo della linea di taglio</translation>
    </message>
    <message>
        <source>Place &amp;notches</source>
        <translation>Posiziona &amp;tacche</translation>
    </message>
    <message>
        <source>Place &amp;drill holes</source>
        <translation>Pos&amp;iziona fori</translation>
    </message>
    <message>
        <source>&amp;Cutting</source>
        <translation>Ta&amp;glio</translation>
    </message>
    <message>
        <source>Draw &amp;dart</source>
        <translation>Disegna &amp;pince</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>&amp;Tour</source>
        <translation>T&amp;our</translation>
    </message>
    <message>
        <source>The coloured curves on the frame are where the cloth is tied down. Click one of them, then drag one of its points: the cover follows.</source>
        <translation>Le curve colorate sul telaio indicano dove è fissato il tessuto. Fare clic su una di esse, poi trascinare uno dei suoi punti: il rivestimento segue.</translation>
    </message>
    <message>
        <source>The cover follows while you drag, and comes to rest when you let go.</source>
        <translation>Il rivestimento segue durante il trascinamento e si assesta al rilascio.</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>Annullare</translation>
    </message>
    <message>
        <source>Ctrl+Z, or this button, takes back whatever was done, as far as you like. Nothing is lost by it: the history keeps what was undone, too.</source>
        <translation>Ctrl+Z, o questo pulsante, annulla ciò che è stato fatto, fin dove si vuole. Nulla va perso: la cronologia conserva anche ciò che è stato annullato.</translation>
    </message>
    <message>
        <source>It is as it was. Undone steps are still in the history.</source>
        <translation>È tutto come prima. I passi annullati sono ancora nella cronologia.</translation>
    </message>
    <message>
        <source>Choose a seam</source>
        <translation>Scegliere una cucitura</translation>
    </message>
    <message>
        <source>Seams join two edges of the pattern. Click one, in the pattern or on the cover: both of its edges light up, and the cover shows where it is.</source>
        <translation>Le cuciture uniscono due lati del cartamodello. Fare clic su una, nel cartamodello o sul rivestimento: entrambi i lati si illuminano e il rivestimento mostra dove si trova.</translation>
    </message>
    <message>
        <source>Its properties are at the right now.</source>
        <translation>Ora le sue proprietà sono a destra.</translation>
    </message>
    <message>
        <source>Change how it is sewn</source>
        <translation>Cambiare come è cucita</translation>
    </message>
    <message>
        <source>With the seam selected, choose another continuity in its properties, or another stitching: an edge, a rounded seam or a smooth one.</source>
        <translation>Con la cucitura selezionata, scegliere nelle sue proprietà un’altra continuità o un’altra impuntura: uno spigolo, una cucitura arrotondata o una liscia.</translation>
    </message>
    <message>
        <source>The cover shows the seam as it will be sewn.</source>
        <translation>Il rivestimento mostra la cucitura come sarà cucita.</translation>
    </message>
    <message>
        <source>Look at the strain</source>
        <translation>Guardare la deformazione</translation>
    </message>
    <message>
        <source>View &gt; Map colours the cover by what the cloth has to bear. Choose Largest strain to see where it is stretched most.</source>
        <translation>Visualizza &gt; Mappa colora il rivestimento secondo ciò che il tessuto deve sopportare. Scegliere Deformazione massima per vedere dove è più teso.</translation>
    </message>
    <message>
        <source>The legend says how much, and the pointer reads it at any place.</source>
        <translation>La legenda dice quanto, e il puntatore lo legge in ogni posizione.</translation>
    </message>
    <message>
        <source>Change the pattern</source>
        <translation>Modificare il cartamodello</translation>
    </message>
    <message>
        <source>Drag a point of an outline, or cut a dart (Pattern &gt; Draw dart): what you change in the flat is sewn at once.</source>
        <translation>Trascinare un punto di un contorno o tagliare una pince (Cartamodello &gt; Disegna pince): ciò che si modifica in piano viene subito cucito.</translation>
    </message>
    <message>
        <source>Seams keep their places on an outline that changes.</source>
        <translation>Le cuciture mantengono il loro posto su un contorno che cambia.</translation>
    </message>
    <message>
        <source>Take it with you</source>
        <translation>Portare via il risultato</translation>
    </message>
    <message>
        <source>File &gt; Export pattern writes DXF, PDF or SVG with seam allowances and notches; Export cover writes the cover for others.</source>
        <translation>File &gt; Esporta cartamodello scrive DXF, PDF o SVG con margini di cucitura e tacche; Esporta rivestimento scrive il rivestimento per altri.</translation>
    </message>
    <message>
        <source>The file is written.</source>
        <translation>Il file è stato scritto.</translation>
    </message>
    <message>
        <source>That was the tour</source>
        <translation>Fine del tour</translation>
    </message>
    <message>
        <source>You have seen how pattern, seams and frame make the cover. Begin with a design of your own: File &gt; Start page has templates. What each key does is under Help &gt; Keys and mouse.</source>
        <translation>Ora è chiaro come cartamodello, cuciture e telaio formano il rivestimento. Iniziare con un proprio modello: in File &gt; Pagina iniziale ci sono modelli pronti. Che cosa fa ogni tasto è in Aiuto &gt; Tasti e mouse.</translation>
    </message>
    <message>
        <source>Drag a fixation curve</source>
        <translation>Trascinare una curva di fissaggio</translation>
    </message>
</context>
<context>
    <name>TrimSection</name>
    <message>
        <source>Stitching</source>
        <translation>Impuntura</translation>
    </message>
    <message>
        <source>Colour of the thread</source>
        <translation>Colore del filo</translation>
    </message>
    <message>
        <source>Piping</source>
        <translation>Bordino</translation>
    </message>
    <message>
        <source>As the patch</source>
        <translation>Come il pezzo</translation>
    </message>
</context>
<context>
    <name>TwinCommands</name>
    <message>
        <source>Make &amp;mirror twin</source>
        <translation>Crea &amp;gemello speculare</translation>
    </message>
    <message>
        <source>Link as t&amp;wins</source>
        <translation>Co&amp;llega come gemelli</translation>
    </message>
    <message>
        <source>&amp;Unlink twins</source>
        <translation>&amp;Separa gemelli</translation>
    </message>
    <message>
        <source>R&amp;elease points from the twin</source>
        <translation>S&amp;collega punti dal gemello</translation>
    </message>
    <message>
        <source>Re-l&amp;ink points to the twin</source>
        <translation>&amp;Ricollega punti al gemello</translation>
    </message>
    <message>
        <source>S&amp;ymmetry …</source>
        <translation>Si&amp;mmetria…</translation>
    </message>
    <message>
        <source>%1, mirrored</source>
        <translation>%1, speculare</translation>
    </message>
    <message>
        <source>Select patches or curves that have no twin yet.</source>
        <translation>Selezionare pezzi o curve che non hanno ancora un gemello.</translation>
    </message>
    <message>
        <source>Nothing that is selected has a twin.</source>
        <translation>Nulla di ciò che è selezionato ha un gemello.</translation>
    </message>
    <message>
        <source>Select points of a twin, or a seam on it, that still follow.</source>
        <translation>Selezionare punti di un gemello, o una sua cucitura, ancora collegati.</translation>
    </message>
    <message>
        <source>No point that is selected has been released.</source>
        <translation>Nessun punto selezionato è scollegato.</translation>
    </message>
</context>
<context>
    <name>TwinForm</name>
    <message>
        <source>Mirror image</source>
        <translation>Immagine speculare</translation>
    </message>
    <message>
        <source>released</source>
        <translation>scollegata</translation>
    </message>
    <message>
        <source>itself</source>
        <translation>sé stessa</translation>
    </message>
    <message>
        <source>Re-lin&amp;k to its mirror image</source>
        <translation>&amp;Ricollega alla sua speculare</translation>
    </message>
    <message>
        <source>Re&amp;lease from its mirror image</source>
        <translation>S&amp;collega dalla sua speculare</translation>
    </message>
    <message>
        <source>Twin of</source>
        <translation>Gemello di</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>Eccezioni</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuna</translation>
    </message>
    <message numerus="yes">
        <source>%n released points</source>
        <translation>
            <numerusform>%n punto scollegato</numerusform>
            <numerusform>%n punti scollegati</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Unlink from its twin</source>
        <translation>&amp;Separa dal gemello</translation>
    </message>
    <message>
        <source>Re-link all poi&amp;nts</source>
        <translation>Ricollega tutti i &amp;punti</translation>
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
        <translation>%1&#xa0;%</translation>
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
        <translation>Problemi</translation>
    </message>
    <message>
        <source>It keeps its text and is saved as it is.</source>
        <translation>Conserva il suo testo e viene salvato com’è.</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>Show &amp;all</source>
        <translation>Mostra &amp;tutto</translation>
    </message>
    <message>
        <source>Show &amp;selection</source>
        <translation>Mostra &amp;selezione</translation>
    </message>
    <message>
        <source>Look at the &amp;cover from</source>
        <translation>&amp;Guarda il rivestimento da</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>Da&amp;vanti</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>D&amp;ietro</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Sinistra</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Destra</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>S&amp;opra</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>So&amp;tto</translation>
    </message>
    <message>
        <source>Three-&amp;quarter</source>
        <translation>Tre &amp;quarti</translation>
    </message>
    <message>
        <source>Sa&amp;ved views</source>
        <translation>&amp;Viste salvate</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Prospettiva</translation>
    </message>
    <message>
        <source>Sec&amp;tion</source>
        <translation>Se&amp;zione</translation>
    </message>
    <message>
        <source>Lin&amp;k the views</source>
        <translation>Co&amp;llega le viste</translation>
    </message>
    <message>
        <source>Show the pointer&apos;s place in the other view, too</source>
        <translation>Mostra la posizione del puntatore anche nell’altra vista</translation>
    </message>
    <message>
        <source>&amp;Hide selected</source>
        <translation>&amp;Nascondi selezione</translation>
    </message>
    <message>
        <source>&amp;Isolate selected</source>
        <translation>&amp;Isola selezione</translation>
    </message>
    <message>
        <source>Sho&amp;w hidden again</source>
        <translation>&amp;Mostra i nascosti</translation>
    </message>
    <message>
        <source>Th&amp;eme</source>
        <translation>T&amp;ema</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Come il &amp;sistema</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Chiaro</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>Sc&amp;uro</translation>
    </message>
    <message>
        <source>&amp;Opacity</source>
        <translation>&amp;Opacità</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>Frames and foam</source>
        <translation>Telai ed espanso</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Scansioni</translation>
    </message>
    <message>
        <source>Opacity of frames and scans</source>
        <translation>Opacità di telai e scansioni</translation>
    </message>
    <message>
        <source>Select patches, curves, frames, foam or scans to hide them.</source>
        <translation>Selezionare pezzi, curve, telai, espanso o scansioni per nasconderli.</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>&amp;Alto contrasto</translation>
    </message>
</context>
<context>
    <name>ViewPrint</name>
    <message>
        <source>Print the view</source>
        <translation>Stampa vista</translation>
    </message>
    <message>
        <source>The view could not be printed.</source>
        <translation>Impossibile stampare la vista.</translation>
    </message>
    <message>
        <source>The printer takes nothing at the moment. Look whether it is on and has paper, or print to a file.</source>
        <translation>La stampante al momento non accetta nulla. Controllare che sia accesa e abbia carta, o stampare su file.</translation>
    </message>
</context>
<context>
    <name>WhatsNew</name>
    <message>
        <source>What&apos;s new</source>
        <translation>Novità</translation>
    </message>
</context>
<context>
    <name>WindowCommands</name>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>&amp;Parte successiva della finestra</translation>
    </message>
    <message>
        <source>Pre&amp;vious part of the window</source>
        <translation>Pa&amp;rte precedente della finestra</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Ripristina &amp;disposizione</translation>
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
        <translation>So&amp;lo in una zona dipinta</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Dipingi</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Cancella</translation>
    </message>
    <message>
        <source>The form and the limit of strain count only there</source>
        <translation>La forma e il limite di deformazione contano solo lì</translation>
    </message>
    <message>
        <source>Drag over the cover in the 3D view; with Shift held down it takes away</source>
        <translation>Trascina sul rivestimento nella vista 3D; con Maiusc premuto toglie</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Raggio del pennello</translation>
    </message>
    <message>
        <source>Painted area</source>
        <translation>Zona dipinta</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Raggio</translation>
    </message>
</context>
<context>
    <name>bolster::Banner</name>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
</context>
<context>
    <name>bolster::CanvasChoice</name>
    <message>
        <source>Drawn in software</source>
        <translation>Disegnato via software</translation>
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
        <translation>Perché è così?</translation>
    </message>
    <message>
        <source>The scan of the piece</source>
        <translation>La scansione del pezzo</translation>
    </message>
    <message>
        <source>The scan of a sound piece</source>
        <translation>La scansione di un pezzo corretto</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nessuna</translation>
    </message>
    <message>
        <source>Of a piece that is as it should be: where that lies elsewhere than the cover no cause is looked for</source>
        <translation>Di un pezzo come deve essere: dove anche questo si scosta dal rivestimento non si cerca alcuna causa</translation>
    </message>
    <message>
        <source>Scan of the &amp;piece</source>
        <translation>Scansione del &amp;pezzo</translation>
    </message>
    <message>
        <source>Scan of a so&amp;und piece</source>
        <translation>Scansione di un pezzo c&amp;orretto</translation>
    </message>
    <message>
        <source>Look for the &amp;cause</source>
        <translation>&amp;Cerca la causa</translation>
    </message>
    <message>
        <source>Looking for a cause …</source>
        <translation>Ricerca di una causa…</translation>
    </message>
    <message>
        <source>Says which one cause explains best how far a built piece lies from the cover: foam, a seam&apos;s allowance, a stretched piece, a fixation off its place, a slipped notch.</source>
        <translation>Indica quale singola causa spiega meglio quanto un pezzo realizzato si scosta dal rivestimento: espanso, margine di una cucitura, pezzo allungato, fissaggio fuori posto, tacca slittata.</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Causa</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Entità</translation>
    </message>
    <message>
        <source>Explains</source>
        <translation>Spiega</translation>
    </message>
    <message>
        <source>Probability</source>
        <translation>Probabilità</translation>
    </message>
    <message>
        <source>Causes</source>
        <translation>Cause</translation>
    </message>
    <message>
        <source>Choose the scan of the piece that was built.</source>
        <translation>Scegliere la scansione del pezzo realizzato.</translation>
    </message>
    <message>
        <source>Covers with each cause are solved …</source>
        <translation>Calcolo dei rivestimenti con ogni causa…</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Interrotto.</translation>
    </message>
    <message>
        <source>The scan shows nothing of the cover: does it lie where the design is?</source>
        <translation>La scansione non mostra nulla del rivestimento: si trova dov’è il modello?</translation>
    </message>
    <message>
        <source>The scan shows %1 of the cover and lies %2 (rms) from it. All causes together leave %3.</source>
        <translation>La scansione mostra %1 del rivestimento e ne dista %2 (rms). Tutte le cause insieme lasciano %3.</translation>
    </message>
    <message>
        <source>No single cause explains that better than noise does.</source>
        <translation>Nessuna singola causa lo spiega meglio del rumore.</translation>
    </message>
    <message>
        <source>Most of the deviation has no cause of these kinds, so the first need not be the right one: give the scan of a sound piece, too.</source>
        <translation>La maggior parte dello scostamento non ha cause di questi tipi, perciò la prima non è per forza quella giusta: indicare anche la scansione di un pezzo corretto.</translation>
    </message>
    <message numerus="yes">
        <source>and %n others</source>
        <translation>
            <numerusform>e un’altra (%n)</numerusform>
            <numerusform>e altre %n</numerusform>
        </translation>
    </message>
    <message>
        <source>The scan does not tell it apart from: %1</source>
        <translation>La scansione non la distingue da: %1</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: look again.</source>
        <translation>Nel frattempo il modello è cambiato: cercare di nuovo.</translation>
    </message>
    <message>
        <source>Stopped. The list is that of the search before.</source>
        <translation>Interrotto. L’elenco è quello della ricerca precedente.</translation>
    </message>
    <message>
        <source>The scan lies on the cover: there is nothing to explain.</source>
        <translation>La scansione sta sul rivestimento: non c’è niente da spiegare.</translation>
    </message>
    <message>
        <source>Even the likeliest cause explains only %1 of it: there may be several, or others than these.</source>
        <translation>Anche la causa più probabile ne spiega solo %1: possono essere più d’una, o altre da queste.</translation>
    </message>
    <message>
        <source>Foam is thicker or thinner</source>
        <translation>Espanso più spesso o più sottile</translation>
    </message>
    <message>
        <source>Foam is harder or softer</source>
        <translation>Espanso più duro o più morbido</translation>
    </message>
    <message>
        <source>Allowance of a seam</source>
        <translation>Margine di una cucitura</translation>
    </message>
    <message>
        <source>Piece is larger or smaller</source>
        <translation>Pezzo più grande o più piccolo</translation>
    </message>
    <message>
        <source>Fixation lies elsewhere</source>
        <translation>Fissaggio in un’altra posizione</translation>
    </message>
    <message>
        <source>Seam is sewn shifted</source>
        <translation>Cucitura sfalsata</translation>
    </message>
    <message>
        <source>%1 thicker</source>
        <translation>%1 più spesso</translation>
    </message>
    <message>
        <source>%1 thinner</source>
        <translation>%1 più sottile</translation>
    </message>
    <message>
        <source>%1 harder</source>
        <translation>%1 più duro</translation>
    </message>
    <message>
        <source>%1 softer</source>
        <translation>%1 più morbido</translation>
    </message>
    <message>
        <source>%1 farther out</source>
        <translation>%1 più all’esterno</translation>
    </message>
    <message>
        <source>%1 farther in</source>
        <translation>%1 più all’interno</translation>
    </message>
    <message>
        <source>%1 larger</source>
        <translation>%1 più grande</translation>
    </message>
    <message>
        <source>%1 smaller</source>
        <translation>%1 più piccolo</translation>
    </message>
    <message>
        <source>%1 counter-clockwise</source>
        <translation>%1 in senso antiorario</translation>
    </message>
    <message>
        <source>%1 clockwise</source>
        <translation>%1 in senso orario</translation>
    </message>
    <message>
        <source>Farther out: the allowance was taken narrower, on both sides</source>
        <translation>Più all’esterno: il margine è stato preso più stretto, da entrambi i lati</translation>
    </message>
    <message>
        <source>Along the edge of %1, as it lies in the pattern</source>
        <translation>Lungo il lato di %1, come sta nel cartamodello</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>meno di %1</translation>
    </message>
    <message>
        <source>The scan shows %1 of the cover. Its points lie %2 (rms) from the cover, of which all causes together leave %3. From the cover to the nearest point, as a fit measures, it is %4.</source>
        <translation>La scansione mostra %1 del rivestimento. I suoi punti ne distano %2 (rms), di cui tutte le cause insieme lasciano %3. Dal rivestimento al punto più vicino, come misura un adattamento, sono %4.</translation>
    </message>
    <message>
        <source>That is far more than such a cause usually is: there may be several, or others than these.</source>
        <translation>È molto più di quanto una causa simile sia di solito: possono essere più d’una, o altre da queste.</translation>
    </message>
    <message>
        <source>What the likeliest cause leaves is more than noise: something else may be wrong, too, and its amount may be off by more than is said.</source>
        <translation>Quel che la causa più probabile lascia è più che rumore: forse c’è anche altro che non va, e la sua misura può sbagliare più di quanto indicato.</translation>
    </message>
    <message numerus="yes">
        <source>%n more causes explain some of it, less likely than these.</source>
        <translation>
            <numerusform>%n altra causa ne spiega una parte, meno probabile di queste.</numerusform>
            <numerusform>%n altre cause ne spiegano una parte, meno probabili di queste.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::ColourwayWindow</name>
    <message>
        <source>Compare colourways</source>
        <translation>Confronta varianti colore</translation>
    </message>
    <message>
        <source>The colourway that is shown below</source>
        <translation>La variante colore mostrata sotto</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>Come prodotto</translation>
    </message>
</context>
<context>
    <name>bolster::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Trova un comando</translation>
    </message>
    <message>
        <source>There is no such command.</source>
        <translation>Questo comando non esiste.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Comandi</translation>
    </message>
</context>
<context>
    <name>bolster::CompareWindow</name>
    <message>
        <source>&amp;Take from there</source>
        <translation>&amp;Prendi da lì</translation>
    </message>
    <message>
        <source>Compare versions</source>
        <translation>Confronta versioni</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>Differenze</translation>
    </message>
    <message>
        <source>There</source>
        <translation>Là</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Ora</translation>
    </message>
    <message>
        <source>Makes the chosen elements as they are in the other version: one step in the history</source>
        <translation>Rende gli elementi scelti come sono nell’altra versione: un passo della cronologia</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inizio</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>only now</source>
        <translation>solo ora</translation>
    </message>
    <message>
        <source>only there</source>
        <translation>solo là</translation>
    </message>
    <message>
        <source>Nothing differs</source>
        <translation>Nessuna differenza</translation>
    </message>
    <message>
        <source>&amp;Move both together</source>
        <translation>&amp;Muovi entrambe insieme</translation>
    </message>
    <message>
        <source>Turning, moving or zooming one version does the same to the other</source>
        <translation>Ruotare, spostare o ingrandire una versione fa lo stesso con l’altra</translation>
    </message>
</context>
<context>
    <name>bolster::ContextMenus</name>
    <message>
        <source>Leave this &amp;piece out</source>
        <translation>&amp;Escludi questo pezzo</translation>
    </message>
    <message>
        <source>Hides this piece of the frame from the view, drawing, cushioning and contact; the frame&apos;s properties bring it back</source>
        <translation>Esclude questo pezzo del telaio da vista, disegno, imbottitura e contatto; si riattiva nelle proprietà del telaio</translation>
    </message>
</context>
<context>
    <name>bolster::CoverSelectTool</name>
    <message>
        <source>Kept to an axis; the same key frees it</source>
        <translation>Vincolato a un asse; lo stesso tasto lo libera</translation>
    </message>
    <message>
        <source>Lifted off the frame along its normal; let go of Ctrl to slide on it</source>
        <translation>Sollevato dal telaio lungo la normale; rilasciare Ctrl per scorrervi sopra</translation>
    </message>
    <message>
        <source>On the frame: Ctrl lifts off, S lets go of it, X, Y, Z or Shift keep to an axis</source>
        <translation>Sul telaio: Ctrl solleva, S rilascia, X, Y, Z o Maiusc mantengono un asse</translation>
    </message>
    <message>
        <source>X, Y, Z or Shift keep to an axis, S keeps to the frame, Ctrl lifts off, Escape cancels</source>
        <translation>X, Y, Z o Maiusc mantengono un asse, S resta sul telaio, Ctrl solleva, Esc annulla</translation>
    </message>
    <message>
        <source>Moved by x %1, y %2, z %3</source>
        <translation>Spostato di x %1, y %2, z %3</translation>
    </message>
</context>
<context>
    <name>bolster::CutFindingsList</name>
    <message>
        <source>What to look at before cutting</source>
        <translation>Che cosa controllare prima del taglio</translation>
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
        <translation>Un doppio clic mostra dove si trova.</translation>
    </message>
    <message>
        <source>Nothing to mend: the pattern can be cut.</source>
        <translation>Nulla da correggere: il cartamodello può essere tagliato.</translation>
    </message>
    <message>
        <source>Looking the pattern over …</source>
        <translation>Controllo del cartamodello…</translation>
    </message>
    <message>
        <source>There is no pattern yet.</source>
        <translation>Non c’è ancora un cartamodello.</translation>
    </message>
</context>
<context>
    <name>bolster::DesignSession</name>
    <message>
        <source>New design</source>
        <translation>Nuovo modello</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Tessuto</translation>
    </message>
    <message>
        <source>Restored design</source>
        <translation>Modello ripristinato</translation>
    </message>
    <message>
        <source> (other)</source>
        <translation> (altro)</translation>
    </message>
    <message>
        <source> (other %1)</source>
        <translation> (altro %1)</translation>
    </message>
</context>
<context>
    <name>bolster::DockTitle</name>
    <message>
        <source>Take out of the window, or put back</source>
        <translation>Stacca dalla finestra o rimetti a posto</translation>
    </message>
    <message>
        <source>Close; the Window menu brings it back</source>
        <translation>Chiudi; si riapre dal menu Finestra</translation>
    </message>
</context>
<context>
    <name>bolster::DropFlow</name>
    <message>
        <source>&quot;%1&quot; cannot be opened.</source>
        <translation>Impossibile aprire «%1».</translation>
    </message>
    <message>
        <source>The system did not start the program again for another window. Open it from here instead.</source>
        <translation>Il sistema non ha riavviato il programma per un’altra finestra. Aprirlo invece da qui.</translation>
    </message>
    <message>
        <source>It is a folder. Drop the files that are in it.</source>
        <translation>È una cartella. Trascinare qui i file che contiene.</translation>
    </message>
    <message>
        <source>It is not on this computer, or not any more. Save it to a folder first.</source>
        <translation>Non è su questo computer, o non lo è più. Salvarlo prima in una cartella.</translation>
    </message>
    <message>
        <source>Bolster opens projects and designs (%1), frames (%2), scans (%3), patterns (%4) and pictures of fabrics (%5). Save it in one of these formats with the program it comes from.</source>
        <translation>Bolster apre progetti e modelli (%1), telai (%2), scansioni (%3), cartamodelli (%4) e immagini di tessuti (%5). Salvarlo in uno di questi formati con il programma d’origine.</translation>
    </message>
</context>
<context>
    <name>bolster::ElementsModel</name>
    <message>
        <source>Hidden in the 3D view</source>
        <translation>Nascosto nella vista 3D</translation>
    </message>
</context>
<context>
    <name>bolster::ElementsView</name>
    <message>
        <source>Find an element</source>
        <translation>Trova un elemento</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elementi</translation>
    </message>
    <message>
        <source>By its name, or by a word of its note</source>
        <translation>Per nome, o per una parola della nota</translation>
    </message>
</context>
<context>
    <name>bolster::ExportFlow</name>
    <message>
        <source>Export pattern</source>
        <translation>Esporta cartamodello</translation>
    </message>
    <message>
        <source>-sewing</source>
        <translation>-cucitura</translation>
    </message>
    <message>
        <source>-pattern</source>
        <translation>-cartamodello</translation>
    </message>
    <message>
        <source>%1 (*.%2)</source>
        <translation>%1 (*.%2)</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>Scrittura di %1…</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Esportato in %1</translation>
    </message>
    <message>
        <source>The pattern could not be exported.</source>
        <translation>Impossibile esportare il cartamodello.</translation>
    </message>
    <message>
        <source>Export cover</source>
        <translation>Esporta rivestimento</translation>
    </message>
    <message>
        <source>-cover</source>
        <translation>-rivestimento</translation>
    </message>
    <message>
        <source>Export foam</source>
        <translation>Esporta espanso</translation>
    </message>
    <message>
        <source>-foam</source>
        <translation>-espanso</translation>
    </message>
    <message>
        <source>Exporting %1 …</source>
        <translation>Esportazione di %1…</translation>
    </message>
    <message>
        <source>The cover could not be exported.</source>
        <translation>Impossibile esportare il rivestimento.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is written.</source>
        <translation>«%1» è stato scritto.</translation>
    </message>
    <message>
        <source>Export surface</source>
        <translation>Esporta superficie</translation>
    </message>
    <message>
        <source>The surface could not be exported.</source>
        <translation>Impossibile esportare la superficie.</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Esporta immagine</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>The picture could not be exported.</source>
        <translation>Impossibile esportare l’immagine.</translation>
    </message>
    <message>
        <source>-surface</source>
        <translation>-superficie</translation>
    </message>
</context>
<context>
    <name>bolster::ExportPatternDialog</name>
    <message>
        <source>Export pattern</source>
        <translation>Esporta cartamodello</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Pezzi</translation>
    </message>
    <message>
        <source>&amp;Export …</source>
        <translation>&amp;Esporta…</translation>
    </message>
    <message>
        <source>PDF – to print and put together</source>
        <translation>PDF – da stampare e assemblare</translation>
    </message>
    <message>
        <source>DXF AAMA – for cutters</source>
        <translation>DXF AAMA – per sistemi di taglio</translation>
    </message>
    <message>
        <source>DXF ASTM – for cutters</source>
        <translation>DXF ASTM – per sistemi di taglio</translation>
    </message>
    <message>
        <source>DXF, plain lines</source>
        <translation>DXF, linee semplici</translation>
    </message>
    <message>
        <source>SVG – 1:1</source>
        <translation>SVG – 1:1</translation>
    </message>
    <message>
        <source>HPGL – for plotters</source>
        <translation>HPGL – per plotter</translation>
    </message>
    <message>
        <source>Roll, %1 mm wide</source>
        <translation>Rotolo, altezza %1&#xa0;mm</translation>
    </message>
    <message>
        <source>&amp;Landscape</source>
        <translation>&amp;Orizzontale</translation>
    </message>
    <message>
        <source>Mirrored pairs as &amp;two pieces</source>
        <translation>Coppie speculari come &amp;due pezzi</translation>
    </message>
    <message>
        <source>The design says it; it is changed in its properties.</source>
        <translation>Lo stabilisce il modello; si modifica nelle sue proprietà.</translation>
    </message>
    <message>
        <source>Of patches and edges that have none of their own.</source>
        <translation>Di pezzi e lati che non ne hanno uno proprio.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>For&amp;mato</translation>
    </message>
    <message>
        <source>&amp;Paper</source>
        <translation>&amp;Carta</translation>
    </message>
    <message>
        <source>Seam &amp;allowance</source>
        <translation>Mar&amp;gine di cucitura</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linee</translation>
    </message>
    <message>
        <source>Sewing li&amp;nes</source>
        <translation>Linee di c&amp;ucitura</translation>
    </message>
    <message>
        <source>Notc&amp;hes</source>
        <translation>&amp;Tacche</translation>
    </message>
    <message>
        <source>&amp;Grain lines</source>
        <translation>Drittofi&amp;li</translation>
    </message>
    <message>
        <source>La&amp;bels</source>
        <translation>Etic&amp;hette</translation>
    </message>
    <message>
        <source>&amp;Internal lines</source>
        <translation>Linee &amp;interne</translation>
    </message>
    <message>
        <source>&amp;Drill holes</source>
        <translation>&amp;Fori</translation>
    </message>
    <message numerus="yes">
        <source>%n pages</source>
        <translation>
            <numerusform>%n pagina</numerusform>
            <numerusform>%n pagine</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n patches are left out: their outlines cross themselves</source>
        <translation>
            <numerusform>%n pezzo viene omesso: il suo contorno incrocia sé stesso</numerusform>
            <numerusform>%n pezzi vengono omessi: i loro contorni incrociano sé stessi</numerusform>
        </translation>
    </message>
    <message>
        <source>C&amp;ut lines</source>
        <translation>Linee di t&amp;aglio</translation>
    </message>
    <message>
        <source>Sewing sheet (PDF)</source>
        <translation>Scheda di cucitura (PDF)</translation>
    </message>
    <message>
        <source>DXF, plain curves (R2000)</source>
        <translation>DXF, curve semplici (R2000)</translation>
    </message>
    <message>
        <source>too many sheets: is its unit right?</source>
        <translation>troppi fogli: l’unità è giusta?</translation>
    </message>
    <message>
        <source>the first %1 are shown</source>
        <translation>sono mostrati i primi %1</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>Non c’è nulla da tagliare.</translation>
    </message>
    <message>
        <source>A double click leaves this window and shows where it is; the whole list is in the panel &quot;Check before cutting&quot;.</source>
        <translation>Un doppio clic lascia questa finestra e mostra dove si trova; l’elenco completo è nel pannello «Verifica prima del taglio».</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces on %1</source>
        <translation>
            <numerusform>%n pezzo su %1</numerusform>
            <numerusform>%n pezzi su %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FabricCommands</name>
    <message>
        <source>Rename fabric</source>
        <translation>Rinomina tessuto</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nome:</translation>
    </message>
    <message>
        <source>Delete fabric</source>
        <translation>Elimina tessuto</translation>
    </message>
    <message numerus="yes">
        <source>%n patches have &quot;%1&quot;. What shall they get instead?</source>
        <translation>
            <numerusform>%n pezzo ha «%1». Che cosa deve avere invece?</numerusform>
            <numerusform>%n pezzi hanno «%1». Che cosa devono avere invece?</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the patches that shall get the fabric, then choose it in the library.</source>
        <translation>Selezionare i pezzi che devono avere il tessuto, poi sceglierlo nella raccolta.</translation>
    </message>
    <message>
        <source>New colourway</source>
        <translation>Nuova variante colore</translation>
    </message>
    <message>
        <source>Name of the colourway; it begins as what is shown now:</source>
        <translation>Nome della variante colore; parte da ciò che si vede ora:</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>Variante colore</translation>
    </message>
    <message>
        <source>Rename colourway</source>
        <translation>Rinomina variante colore</translation>
    </message>
    <message>
        <source>Picture of a fabric</source>
        <translation>Immagine di un tessuto</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Immagini (%1)</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Lettura di %1…</translation>
    </message>
    <message>
        <source>The picture could not be read.</source>
        <translation>Impossibile leggere l’immagine.</translation>
    </message>
    <message>
        <source>The picture could not be taken into the design.</source>
        <translation>Impossibile inserire l’immagine nel modello.</translation>
    </message>
    <message>
        <source>Import fabrics</source>
        <translation>Importa tessuti</translation>
    </message>
    <message>
        <source>Fabrics, designs and projects (*.json *.bolster)</source>
        <translation>Tessuti, modelli e progetti (*.json *.bolster)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be read.</source>
        <translation>Impossibile leggere «%1».</translation>
    </message>
    <message>
        <source>Nothing was imported.</source>
        <translation>Non è stato importato nulla.</translation>
    </message>
    <message numerus="yes">
        <source>%n fabrics imported from %1</source>
        <translation>
            <numerusform>%n tessuto importato da %1</numerusform>
            <numerusform>%n tessuti importati da %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Export fabric</source>
        <translation>Esporta tessuto</translation>
    </message>
    <message>
        <source>Fabrics (*.json)</source>
        <translation>Tessuti (*.json)</translation>
    </message>
    <message>
        <source>The fabric could not be exported.</source>
        <translation>Impossibile esportare il tessuto.</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Esportato in %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not deleted.</source>
        <translation>«%1» non viene eliminato.</translation>
    </message>
    <message>
        <source>It is the only fabric, and patches are made of it. Add another one first.</source>
        <translation>È l’unico tessuto e vi sono pezzi fatti con esso. Aggiungerne prima un altro.</translation>
    </message>
</context>
<context>
    <name>bolster::FabricPanel</name>
    <message>
        <source>Colourways</source>
        <translation>Varianti colore</translation>
    </message>
    <message>
        <source>A click shows the cover in this colourway</source>
        <translation>Un clic mostra il rivestimento in questa variante colore</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Tessuti</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>Variante colore</translation>
    </message>
    <message>
        <source>New …</source>
        <translation>Nuova…</translation>
    </message>
    <message>
        <source>Rename …</source>
        <translation>Rinomina…</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Elimina</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Confronta</translation>
    </message>
    <message>
        <source>Fabrics: drag them onto patches</source>
        <translation>Tessuti: trascinarli sui pezzi</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nuovo</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Assegna</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copia</translation>
    </message>
    <message>
        <source>Delete …</source>
        <translation>Elimina…</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>Come prodotto</translation>
    </message>
    <message>
        <source>No patch has it.</source>
        <translation>Nessun pezzo lo ha.</translation>
    </message>
    <message numerus="yes">
        <source>%n patches have it.</source>
        <translation>
            <numerusform>%n pezzo lo ha.</numerusform>
            <numerusform>%n pezzi lo hanno.</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag it onto a patch; a double click shows its properties.</source>
        <translation>Trascinarlo su un pezzo; un doppio clic ne mostra le proprietà.</translation>
    </message>
    <message>
        <source>Adds this fabric to the library of the design</source>
        <translation>Aggiunge questo tessuto alla raccolta del modello</translation>
    </message>
</context>
<context>
    <name>bolster::FieldText</name>
    <message>
        <source>usual</source>
        <translation>consueto</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sì</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>turned by %1</source>
        <translation>ruotato di %1</translation>
    </message>
    <message>
        <source>%1, from %2 to %3</source>
        <translation>%1, da %2 a %3</translation>
    </message>
    <message numerus="yes">
        <source>%n points, %1</source>
        <translation>
            <numerusform>%n punto, %1</numerusform>
            <numerusform>%n punti, %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FileChoice</name>
    <message>
        <source>A file …</source>
        <translation>Un file…</translation>
    </message>
</context>
<context>
    <name>bolster::FileImportDialog</name>
    <message>
        <source> mm per unit</source>
        <translation> mm per unità</translation>
    </message>
    <message>
        <source>Import scan</source>
        <translation>Importa scansione</translation>
    </message>
    <message>
        <source>Import frame</source>
        <translation>Importa telaio</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimetri</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centimetri</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Metri</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pollici</translation>
    </message>
    <message>
        <source>Another factor</source>
        <translation>Altro fattore</translation>
    </message>
    <message>
        <source>z points up</source>
        <translation>z verso l’alto</translation>
    </message>
    <message>
        <source>y points up</source>
        <translation>y verso l’alto</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 punti</translation>
    </message>
    <message>
        <source>Width, depth, height</source>
        <translation>Larghezza, profondità, altezza</translation>
    </message>
    <message>
        <source>That is unusual for a piece of furniture: check the unit.</source>
        <translation>È insolito per un mobile: controllare l’unità.</translation>
    </message>
    <message>
        <source>&amp;Keep scale, position and rotation</source>
        <translation>&amp;Mantieni scala, posizione e rotazione</translation>
    </message>
    <message>
        <source>&amp;Place it on the floor, in the middle</source>
        <translation>&amp;Poggia sul pavimento, al centro</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>&amp;Unità del file</translation>
    </message>
    <message>
        <source>&amp;Factor</source>
        <translation>&amp;Fattore</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>&amp;Assi</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importa</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>It would be %1 large. Import it like that?</source>
        <translation>Sarebbe grande %1. Importare così?</translation>
    </message>
    <message>
        <source>Another unit or factor makes it as large as it is meant.</source>
        <translation>Un’altra unità o un altro fattore dà la dimensione voluta.</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Piedi</translation>
    </message>
    <message>
        <source>x points up</source>
        <translation>x verso l’alto</translation>
    </message>
    <message>
        <source>The file says its unit and its axes.</source>
        <translation>Il file indica unità e assi.</translation>
    </message>
    <message numerus="yes">
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points, %Ln triangles</source>
        <translation>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 punti, %Ln triangolo</numerusform>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 punti, %Ln triangoli</numerusform>
        </translation>
    </message>
    <message>
        <source>The file says its unit; the axes are guessed.</source>
        <translation>Il file indica l’unità; gli assi sono ipotizzati.</translation>
    </message>
    <message>
        <source>The file says its axes; the unit is guessed.</source>
        <translation>Il file indica gli assi; l’unità è ipotizzata.</translation>
    </message>
    <message>
        <source>Unit and axes are guessed: look at the picture and the size.</source>
        <translation>Unità e assi sono ipotizzati: controllare immagine e dimensioni.</translation>
    </message>
    <message>
        <source>&amp;Keep position and rotation</source>
        <translation>&amp;Mantieni posizione e rotazione</translation>
    </message>
    <message>
        <source>The file has %1 points. That is more than are needed to fit a cover, so they were thinned out to one every %2.</source>
        <translation>Il file ha %1 punti. Sono più di quanti servano per adattare un rivestimento, perciò sono stati ridotti a uno ogni %2.</translation>
    </message>
    <message>
        <source>It was %1 large and becomes %2: check the unit.</source>
        <translation>Era di %1 e diventa di %2: controllare l’unità.</translation>
    </message>
    <message>
        <source>The unit is guessed: look at the size.</source>
        <translation>L’unità è supposta: guardi la dimensione.</translation>
    </message>
    <message>
        <source>The axes are guessed: look at the picture.</source>
        <translation>Gli assi sono supposti: guardi l’immagine.</translation>
    </message>
</context>
<context>
    <name>bolster::FileTalk</name>
    <message>
        <source>&quot;%1&quot; is not replaced.</source>
        <translation>«%1» non viene sostituito.</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Lettura di %1…</translation>
    </message>
</context>
<context>
    <name>bolster::FitOrderPanel</name>
    <message>
        <source>Goal</source>
        <translation>Obiettivo</translation>
    </message>
    <message>
        <source>The cover &amp;lies on</source>
        <translation>Il ri&amp;vestimento aderisce a</translation>
    </message>
    <message>
        <source>The form that the cover shall lie on</source>
        <translation>La forma a cui deve aderire il rivestimento</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>&amp;Strain is at most</source>
        <translation>&amp;Deformazione al massimo</translation>
    </message>
    <message>
        <source>Along the grain, across it, and in shear; the cover stays where it is</source>
        <translation>In drittofilo, in traverso e a scorrimento; il rivestimento resta dov’è</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Limit of strain</source>
        <translation>Limite di deformazione</translation>
    </message>
    <message>
        <source>&amp;No folds in selected patches</source>
        <translation>Nessuna pie&amp;ga nei pezzi selezionati</translation>
    </message>
    <message>
        <source>No cloth of them is pressed together; none selected: all</source>
        <translation>Nessun loro tessuto è compresso; se nessuno è selezionato: tutti</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>The selected seam r&amp;uns along</source>
        <translation>La c&amp;ucitura selezionata segue</translation>
    </message>
    <message>
        <source>A curve drawn on the frame or the form; it need hold nothing</source>
        <translation>Una curva disegnata sul telaio o sulla forma; non occorre che fissi qualcosa</translation>
    </message>
    <message>
        <source>Share of the area</source>
        <translation>Quota dell’area</translation>
    </message>
    <message>
        <source>Area of selected patches &amp;becomes</source>
        <translation>Area mantenuta dai pe&amp;zzi selezionati</translation>
    </message>
    <message>
        <source>Less than 100 %: they become smaller</source>
        <translation>Meno di 100&#xa0;%: diventano più piccoli</translation>
    </message>
    <message>
        <source>What may change</source>
        <translation>Che cosa può cambiare</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>&amp;Contorni</translation>
    </message>
    <message>
        <source>Control points of the patches</source>
        <translation>Punti di controllo dei pezzi</translation>
    </message>
    <message>
        <source>Ends of seams</source>
        <translation>Estremi cuciture</translation>
    </message>
    <message>
        <source>Where seams and fixations end on smooth edges</source>
        <translation>Dove cuciture e fissaggi finiscono su bordi lisci</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Lentezza</translation>
    </message>
    <message>
        <source>Sides of seams may come to differ in length; that is then the ease wanted</source>
        <translation>I lati delle cuciture possono diventare di lunghezza diversa; questa è poi la lentezza voluta</translation>
    </message>
    <message>
        <source>Fo&amp;am</source>
        <translation>&amp;Espanso</translation>
    </message>
    <message>
        <source>How thick cushions and foam are, by whole voxels</source>
        <translation>Quanto sono spessi imbottitura ed espanso, a voxel interi</translation>
    </message>
    <message>
        <source>F&amp;ixations</source>
        <translation>&amp;Fissaggi</translation>
    </message>
    <message>
        <source>Where fixation curves lie: on their frames, or in space where there is none</source>
        <translation>Dove si trovano le curve di fissaggio: sui loro telai, o nello spazio dove non ce n’è</translation>
    </message>
    <message>
        <source>&amp;Pressure</source>
        <translation>&amp;Pressione</translation>
    </message>
    <message>
        <source>The pressure under each patch</source>
        <translation>La pressione sotto ogni pezzo</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Elasticità</translation>
    </message>
    <message>
        <source>Stiffness of the fabrics, and how much they contract across a pull</source>
        <translation>Rigidezza dei tessuti, e quanto si contraggono di traverso alla trazione</translation>
    </message>
    <message>
        <source>Of sele&amp;cted patches only</source>
        <translation>&amp;Solo dei pezzi selezionati</translation>
    </message>
    <message>
        <source>What stays</source>
        <translation>Che cosa resta</translation>
    </message>
    <message>
        <source>L&amp;engths of seams</source>
        <translation>&amp;Lunghezze delle cuciture</translation>
    </message>
    <message>
        <source>The sides of a seam keep their difference; if it is far from the seam&apos;s ease, it comes nearer to it</source>
        <translation>I lati di una cucitura mantengono la loro differenza; se è lontana dalla lentezza della cucitura, vi si avvicina</translation>
    </message>
    <message>
        <source>St&amp;raight edges</source>
        <translation>Lati d&amp;ritti</translation>
    </message>
    <message>
        <source>An&amp;gles of corners</source>
        <translation>An&amp;goli</translation>
    </message>
    <message>
        <source>No point &amp;moves farther than</source>
        <translation>&amp;Nessun punto si sposta oltre</translation>
    </message>
    <message>
        <source>Choose the scan or the file that the cover shall lie on.</source>
        <translation>Scegliere la scansione o il file a cui deve aderire il rivestimento.</translation>
    </message>
    <message>
        <source>Select the seam that shall run along the curve.</source>
        <translation>Selezionare la cucitura che deve seguire la curva.</translation>
    </message>
    <message>
        <source>Paint the area in the 3D view, or untick it.</source>
        <translation>Dipingi la zona nella vista 3D o togli la spunta.</translation>
    </message>
    <message>
        <source>Select the patches that shall become larger or smaller.</source>
        <translation>Selezionare i pezzi che devono diventare più grandi o più piccoli.</translation>
    </message>
    <message>
        <source>Choose a goal.</source>
        <translation>Scegliere un obiettivo.</translation>
    </message>
    <message>
        <source>Edges that look straight stay so: those that bow by less than %1 in %2</source>
        <translation>I bordi che sembrano diritti restano tali: quelli che si incurvano di meno di %1 su %2</translation>
    </message>
</context>
<context>
    <name>bolster::FlatPiecesView</name>
    <message>
        <source>Pieces laid flat</source>
        <translation>Pezzi stesi in piano</translation>
    </message>
    <message>
        <source>Strain: %1</source>
        <translation>Deformazione: %1</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 e più</translation>
    </message>
    <message>
        <source>%1: strain %2 (rms)</source>
        <translation>%1: deformazione %2 (rms)</translation>
    </message>
</context>
<context>
    <name>bolster::FormChoice</name>
    <message>
        <source>Meshes and scans (%1);;All files (*)</source>
        <translation>Mesh e scansioni (%1);;Tutti i file (*)</translation>
    </message>
</context>
<context>
    <name>bolster::FormPatternWindow</name>
    <message>
        <source>&amp;Make the pattern</source>
        <translation>&amp;Crea il cartamodello</translation>
    </message>
    <message>
        <source>Laying it flat …</source>
        <translation>Stesura in piano…</translation>
    </message>
    <message>
        <source>&amp;Make it without what is left out</source>
        <translation>&amp;Crea senza ciò che è omesso</translation>
    </message>
    <message>
        <source>Laying a form flat …</source>
        <translation>Stesura in piano di una forma…</translation>
    </message>
    <message>
        <source>What came of it</source>
        <translation>Che cosa ne è venuto</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Interrompi</translation>
    </message>
    <message>
        <source>Choose a file with a form above, or import a frame first.</source>
        <translation>Scegli sopra un file con una forma, oppure importa prima un telaio.</translation>
    </message>
    <message>
        <source>It is laid flat again when you let go.</source>
        <translation>Sarà stesa di nuovo in piano al rilascio.</translation>
    </message>
    <message numerus="yes">
        <source>Dividing it, %n pieces so far …</source>
        <translation>
            <numerusform>Divisione, %n pezzo finora …</numerusform>
            <numerusform>Divisione, %n pezzi finora …</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Lay it flat</source>
        <translation>&amp;Stendi in piano</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>È stato fermato.</translation>
    </message>
    <message>
        <source>It was stopped. These are the pieces from before.</source>
        <translation>È stato fermato. Questi sono i pezzi di prima.</translation>
    </message>
    <message>
        <source>From a form</source>
        <translation>Da una forma</translation>
    </message>
</context>
<context>
    <name>bolster::FormWishesPanel</name>
    <message>
        <source>The form to be covered</source>
        <translation>La forma da rivestire</translation>
    </message>
    <message>
        <source>Meshes and CAD files (%1);;All files (*)</source>
        <translation>Mesh e file CAD (%1);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>Where the grain line runs on the form</source>
        <translation>Dove corre il drittofilo sulla forma</translation>
    </message>
    <message>
        <source>upwards</source>
        <translation>verso l’alto</translation>
    </message>
    <message>
        <source>to the back</source>
        <translation>verso dietro</translation>
    </message>
    <message>
        <source>sideways</source>
        <translation>di lato</translation>
    </message>
    <message>
        <source>&amp;Form</source>
        <translation>&amp;Forma</translation>
    </message>
    <message>
        <source>Fa&amp;bric</source>
        <translation>&amp;Tessuto</translation>
    </message>
    <message>
        <source>&amp;Grain runs</source>
        <translation>&amp;Drittofilo</translation>
    </message>
    <message>
        <source>It is cut</source>
        <translation>Si taglia</translation>
    </message>
    <message>
        <source>and along the ticked lines:</source>
        <translation>e lungo le linee spuntate:</translation>
    </message>
    <message>
        <source>where its &amp;parts meet</source>
        <translation>dove le sue &amp;parti si incontrano</translation>
    </message>
    <message>
        <source>at the edges of its &amp;CAD faces</source>
        <translation>lungo i bordi delle sue facce &amp;CAD</translation>
    </message>
    <message>
        <source>Each face as the CAD program has it, also where two go on smoothly in each other</source>
        <translation>Ogni faccia come la conosce il programma CAD, anche dove due proseguono dolcemente l&apos;una nell&apos;altra</translation>
    </message>
    <message>
        <source>where it &amp;bends by more than</source>
        <translation>dove si pie&amp;ga più di</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angolo</translation>
    </message>
    <message>
        <source>where it would &amp;not lie flat</source>
        <translation>dove &amp;non starebbe in piano</translation>
    </message>
    <message>
        <source>Pieces that would lie over themselves, or be strained by more than the fabric may be, are divided where they bend most or are narrow; an armchair takes some seconds</source>
        <translation>I pezzi che si sovrapporrebbero, o si tenderebbero più di quanto il tessuto consente, sono divisi dove si piegano di più o sono stretti; una poltrona richiede alcuni secondi</translation>
    </message>
    <message>
        <source>Keep its cover &amp;outside of the frame</source>
        <translation>Tenere il suo rivestimento fu&amp;ori dal telaio</translation>
    </message>
    <message>
        <source>Making the pattern ticks &quot;Keeps the cover outside&quot; at the frame. A cover that is held along its seams alone may sink into the frame or turn inside out.</source>
        <translation>Facendo il cartamodello si spunta «Tiene fuori il rivestimento» nel telaio. Un rivestimento tenuto solo lungo le cuciture può affondare nel telaio o rovesciarsi.</translation>
    </message>
    <message>
        <source>Patches that this form became before go, with their seams and the curves that hold nothing else. One Undo brings them back.</source>
        <translation>I pezzi nati prima da questa forma se ne vanno, con le loro cuciture e le curve che non tengono altro. Un solo Annulla li riporta.</translation>
    </message>
    <message>
        <source>The cover as it is</source>
        <translation>Il rivestimento com’è</translation>
    </message>
    <message>
        <source>Choose a form</source>
        <translation>Scegli una forma</translation>
    </message>
    <message>
        <source>New fabric</source>
        <translation>Nuovo tessuto</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Tessuto</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Replace the %n patches of these names</source>
        <translation>
            <numerusform>Sostitui&amp;re il %n pezzo con questo nome</numerusform>
            <numerusform>Sostitui&amp;re i %n pezzi con questi nomi</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>(%n curves that hold them will hold nothing)</source>
        <translation>
            <numerusform>(%n curva che li tiene non terrà più niente)</numerusform>
            <numerusform>(%n curve che li tengono non terranno più niente)</numerusform>
        </translation>
    </message>
    <message>
        <source>They end inside a piece (marked in the 3D view) and do not divide it: each goes on to the border or line that is nearest, along the way shown there</source>
        <translation>Finiscono dentro un pezzo (segnato nella vista 3D) e non lo dividono: ciascuna prosegue fino al bordo o alla linea più vicina, lungo il percorso che vi è mostrato</translation>
    </message>
    <message numerus="yes">
        <source>Lead %n open ends &amp;on</source>
        <translation>
            <numerusform>Pr&amp;olungare %n estremità aperta</numerusform>
            <numerusform>Pr&amp;olungare %n estremità aperte</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FoundPiecesView</name>
    <message>
        <source>Pieces in the file</source>
        <translation>Pezzi nel file</translation>
    </message>
    <message>
        <source>There is no piece in it.</source>
        <translation>Non contiene alcun pezzo.</translation>
    </message>
    <message>
        <source>Reading …</source>
        <translation>Lettura…</translation>
    </message>
</context>
<context>
    <name>bolster::GlCanvas</name>
    <message>
        <source>No OpenGL: drawn in software</source>
        <translation>Niente OpenGL: disegnato via software</translation>
    </message>
    <message>
        <source>OpenGL is older than 3.3: drawn in software</source>
        <translation>OpenGL è precedente a 3.3: disegnato via software</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryModel</name>
    <message>
        <source>Start</source>
        <translation>Inizio</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Modifica</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryPanel</name>
    <message>
        <source>Find a change or a version</source>
        <translation>Trova una modifica o una versione</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Cronologia</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryView</name>
    <message>
        <source>&amp;Go to this version</source>
        <translation>&amp;Vai a questa versione</translation>
    </message>
    <message>
        <source>&amp;Name this version …</source>
        <translation>&amp;Dai un nome alla versione…</translation>
    </message>
    <message>
        <source>&amp;Remove its name</source>
        <translation>&amp;Rimuovi il nome</translation>
    </message>
    <message>
        <source>&amp;Compare with now …</source>
        <translation>&amp;Confronta con adesso…</translation>
    </message>
    <message>
        <source>Name of this branch</source>
        <translation>Nome di questo ramo</translation>
    </message>
    <message>
        <source>Name of this version</source>
        <translation>Nome di questa versione</translation>
    </message>
    <message>
        <source>Name this &amp;branch …</source>
        <translation>Dai un nome al r&amp;amo…</translation>
    </message>
</context>
<context>
    <name>bolster::ImportFlow</name>
    <message>
        <source>Frames (%1)</source>
        <translation>Telai (%1)</translation>
    </message>
    <message>
        <source>Scans (%1)</source>
        <translation>Scansioni (%1)</translation>
    </message>
    <message>
        <source>Import frame</source>
        <translation>Importa telaio</translation>
    </message>
    <message>
        <source>Import scan</source>
        <translation>Importa scansione</translation>
    </message>
    <message>
        <source>Import pattern</source>
        <translation>Importa cartamodello</translation>
    </message>
    <message>
        <source>Patterns (%1)</source>
        <translation>Cartamodelli (%1)</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>Scegli un altro file</translation>
    </message>
    <message>
        <source>The pattern is imported. What is otherwise than in the file:</source>
        <translation>Il cartamodello è importato. Differenze rispetto al file:</translation>
    </message>
    <message>
        <source>Simplifying %1 …</source>
        <translation>Semplificazione di %1…</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>Scrittura di %1…</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be imported.</source>
        <translation>Impossibile importare «%1».</translation>
    </message>
</context>
<context>
    <name>bolster::ImportPatternDialog</name>
    <message>
        <source>Import pattern</source>
        <translation>Importa cartamodello</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Pezzi</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importa</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimetri</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centimetri</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pollici</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Metri</translation>
    </message>
    <message>
        <source>Sewing lines, with allowances</source>
        <translation>Linee di cucitura, con margini</translation>
    </message>
    <message>
        <source>Cut lines, without allowance</source>
        <translation>Linee di taglio, senza margine</translation>
    </message>
    <message>
        <source>What the outlines of patches become where the file has both lines.</source>
        <translation>Che cosa diventa contorno dei pezzi se il file ha entrambe le linee.</translation>
    </message>
    <message>
        <source>Outlines whose ends are no farther apart are closed by a straight line.</source>
        <translation>I contorni con estremità non più distanti di così vengono chiusi da una retta.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>&amp;Unità del file</translation>
    </message>
    <message>
        <source>Largest piece</source>
        <translation>Pezzo maggiore</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Dimensioni</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>&amp;Contorni</translation>
    </message>
    <message>
        <source>&amp;Close gaps up to</source>
        <translation>C&amp;hiudi interruzioni fino a</translation>
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
            <numerusform>, %n coppia</numerusform>
            <numerusform>, %n coppie</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n times</source>
        <translation>
            <numerusform>, %n volta</numerusform>
            <numerusform>, %n volte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines lay twice on themselves and are taken once.</source>
        <translation>
            <numerusform>%n linea era doppia e viene presa una volta.</numerusform>
            <numerusform>%n linee erano doppie e vengono prese una volta.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not read: %1</source>
        <translation>Non letto: %1</translation>
    </message>
    <message>
        <source>The file does not say its unit for certain: look at the measures.</source>
        <translation>Il file non indica l’unità con certezza: controllare le misure.</translation>
    </message>
    <message>
        <source>Pixels (1/96 inch)</source>
        <translation>Pixel (1/96 di pollice)</translation>
    </message>
    <message>
        <source>Points (1/72 inch)</source>
        <translation>Punti (1/72 di pollice)</translation>
    </message>
    <message>
        <source>In no piece and left out, by layer: %1</source>
        <translation>In nessun pezzo e omessi, per livello: %1</translation>
    </message>
    <message>
        <source>Marks of grading, stripes or nothing that is known, left out by layer: %1</source>
        <translation>Segni di sviluppo taglie, righe o sconosciuti, omessi per livello: %1</translation>
    </message>
    <message>
        <source>%1 has %2 pieces; at most %3 can be imported at once: the first ones are chosen.</source>
        <translation>%1 ha %2 pezzi; se ne possono importare al massimo %3 alla volta: sono scelti i primi.</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message numerus="yes">
        <source>%n outlines are open: their ends are up to %1 apart. Close gaps up to that, if they are outlines.</source>
        <translation>
            <numerusform>%n contorno è aperto: le sue estremità distano fino a %1. Chiudere le interruzioni fino a tale misura, se è un contorno.</numerusform>
            <numerusform>%n contorni sono aperti: le loro estremità distano fino a %1. Chiudere le interruzioni fino a tale misura, se sono contorni.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::JobsPanel</name>
    <message>
        <source>Nothing is being worked at.</source>
        <translation>Nessuna attività in corso.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Interrompi</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Attività</translation>
    </message>
</context>
<context>
    <name>bolster::LeftWork</name>
    <message>
        <source>New design</source>
        <translation>Nuovo modello</translation>
    </message>
    <message numerus="yes">
        <source>%n more designs are under File &gt; Unsaved work.</source>
        <translation>
            <numerusform>Un altro modello (%n) è in File &gt; Lavoro non salvato.</numerusform>
            <numerusform>Altri %n modelli sono in File &gt; Lavoro non salvato.</numerusform>
        </translation>
    </message>
    <message>
        <source>Restoring the work on &quot;%1&quot; …</source>
        <translation>Ripristino del lavoro su «%1»…</translation>
    </message>
    <message>
        <source>The work stays under File &gt; Unsaved work</source>
        <translation>Il lavoro resta in File &gt; Lavoro non salvato</translation>
    </message>
    <message>
        <source>The unsaved work on &quot;%1&quot; could not be restored.</source>
        <translation>Impossibile ripristinare il lavoro non salvato su «%1».</translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved edits restored.</source>
        <translation>
            <numerusform>%n modifica non salvata ripristinata.</numerusform>
            <numerusform>%n modifiche non salvate ripristinate.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved edits are in the history, undone or on other branches.</source>
        <translation>
            <numerusform>%n modifica non salvata è nella cronologia, annullata o su altri rami.</numerusform>
            <numerusform>%n modifiche non salvate sono nella cronologia, annullate o su altri rami.</numerusform>
        </translation>
    </message>
    <message>
        <source>Unsaved names of versions or branches restored.</source>
        <translation>Nomi non salvati di versioni o rami ripristinati.</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Mostra</translation>
    </message>
    <message>
        <source>Go &amp;back to saved</source>
        <translation>&amp;Torna al salvato</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, %2, damaged</source>
        <translation>%1, %2, danneggiato</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nulla</translation>
    </message>
</context>
<context>
    <name>bolster::MainWindow</name>
    <message>
        <source>Tools</source>
        <translation>Strumenti</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messaggi</translation>
    </message>
    <message>
        <source>%1[*] – Bolster</source>
        <translation>%1[*] – Bolster</translation>
    </message>
    <message>
        <source>%1 It is back where it was.</source>
        <translation>%1 È di nuovo dov’era.</translation>
    </message>
    <message>
        <source>More commands</source>
        <translation>Altri comandi</translation>
    </message>
    <message>
        <source>The cover sprang by %1.</source>
        <translation>Il rivestimento è scattato di %1.</translation>
    </message>
    <message>
        <source>Folded cloth can lie in several ways, and where a drag leaves it depends on the way of the pointer. What you see now follows from the design alone: whoever opens it sees the same, and so do exports and pictures. If you want the other shape, tell the design: hold the cloth there with a handle, or make the piece smaller until it needs no folds.</source>
        <translation>Il tessuto in pieghe può disporsi in più modi, e dove lo lascia un trascinamento dipende dal percorso del puntatore. Ciò che si vede ora deriva solo dal modello: chi lo apre vede lo stesso, e così esportazioni e immagini. Per avere l’altra forma bisogna indicarla nel modello: tenere lì il tessuto con una curva maniglia o rimpicciolire il pezzo finché non servono pieghe.</translation>
    </message>
    <message>
        <source>%1[*] (read-only) – Bolster</source>
        <translation>%1[*] (sola lettura) – Bolster</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces are in the pattern. Seam &gt; Propose seams finds what belongs together.</source>
        <translation>
            <numerusform>%n pezzo è nel cartamodello. Cucitura &gt; Proponi cuciture trova ciò che va insieme.</numerusform>
            <numerusform>%n pezzi sono nel cartamodello. Cucitura &gt; Proponi cuciture trova ciò che va insieme.</numerusform>
        </translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>Bolster is still working at something.</source>
        <translation>Bolster sta ancora lavorando.</translation>
    </message>
    <message>
        <source>What is closed now is not finished; files that are being written stay as they were.</source>
        <translation>Ciò che ora si chiude non viene completato; i file in corso di scrittura restano com’erano.</translation>
    </message>
    <message>
        <source>&amp;Stop it and close</source>
        <translation>&amp;Interrompi e chiudi</translation>
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
        <translation>&amp;Annulla</translation>
    </message>
    <message>
        <source>This change has taken away as well: %1</source>
        <translation>Questa modifica ha tolto anche: %1</translation>
    </message>
</context>
<context>
    <name>bolster::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Manuale</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Indice</translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>Indietro (Alt+Sinistra)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Indietro</translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation>Avanti (Alt+Destra)</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Avanti</translation>
    </message>
    <message>
        <source>Find in all pages</source>
        <translation>Cerca in tutte le pagine</translation>
    </message>
    <message>
        <source>The manual has no page &quot;%1&quot;.</source>
        <translation>Il manuale non ha una pagina «%1».</translation>
    </message>
    <message>
        <source>The manual is in English.</source>
        <translation>Il manuale è in inglese.</translation>
    </message>
</context>
<context>
    <name>bolster::MapLegend</name>
    <message>
        <source>over the fabric&apos;s limit</source>
        <translation>oltre il limite del tessuto</translation>
    </message>
</context>
<context>
    <name>bolster::MapLink</name>
    <message>
        <source>Largest strain</source>
        <translation>Deformazione massima</translation>
    </message>
    <message>
        <source>Strain along the grain</source>
        <translation>Deformazione in drittofilo</translation>
    </message>
    <message>
        <source>Strain across the grain</source>
        <translation>Deformazione in traverso</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Scorrimento</translation>
    </message>
    <message>
        <source>Mean curvature</source>
        <translation>Curvatura media</translation>
    </message>
    <message>
        <source>Distance to the frame</source>
        <translation>Distanza dal telaio</translation>
    </message>
    <message>
        <source>hollow</source>
        <translation>concavo</translation>
    </message>
    <message>
        <source>bulging</source>
        <translation>convesso</translation>
    </message>
    <message>
        <source>pressed</source>
        <translation>compresso</translation>
    </message>
    <message>
        <source>stretched</source>
        <translation>teso</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>%1, over the limit of %2</source>
        <translation>%1, oltre il limite di %2</translation>
    </message>
    <message>
        <source>Here: %1</source>
        <translation>Qui: %1</translation>
    </message>
    <message>
        <source>over the fabric&apos;s limit</source>
        <translation>oltre il limite del tessuto</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>dentro</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>fuori</translation>
    </message>
    <message>
        <source>Deviation from the scan</source>
        <translation>Scostamento dalla scansione</translation>
    </message>
</context>
<context>
    <name>bolster::MarkTool</name>
    <message>
        <source>Hole %1</source>
        <translation>Foro %1</translation>
    </message>
    <message>
        <source>Click to select it, drag to move it – its properties say what it is like</source>
        <translation>Clic per selezionare, trascinare per spostare – le proprietà ne indicano le caratteristiche</translation>
    </message>
    <message>
        <source>Click a corner of an outline to choose how its cut lines are joined – Esc ends the tool</source>
        <translation>Fare clic su un angolo di un contorno per scegliere come si uniscono le linee di taglio – Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no distance from the corner on this edge.</source>
        <translation>«%1» non è una distanza dall’angolo su questo lato.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no place: try 120, 40</source>
        <translation>«%1» non è una posizione: ad esempio 120, 40</translation>
    </message>
    <message>
        <source>Click an outline to place a notch, or type how far it is from the corner; on a seam the other side gets one, too – Esc ends the tool</source>
        <translation>Fare clic su un contorno per mettere una tacca o digitarne la distanza dall’angolo; su una cucitura ne riceve una anche l’altro lato – Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>Click inside a patch to place a drill hole, or type where: 120, 40 – Esc ends the tool</source>
        <translation>Fare clic dentro un pezzo per mettere un foro o digitare dove: 120, 40 – Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no width of an allowance: try 12</source>
        <translation>«%1» non è una larghezza di margine: ad esempio 12</translation>
    </message>
    <message>
        <source>Drag its handle, or type its width – its properties say what it is like</source>
        <translation>Trascinare la maniglia o digitare la larghezza – le proprietà ne indicano le caratteristiche</translation>
    </message>
    <message>
        <source>Click an edge to give it a seam allowance of its own, or type its width; drag its handle – Esc ends the tool</source>
        <translation>Fare clic su un lato per dargli un proprio margine di cucitura o digitarne la larghezza; trascinare la maniglia – Esc chiude lo strumento</translation>
    </message>
    <message>
        <source>Point at an outline, then type how far the notch is from the corner</source>
        <translation>Indicare un contorno, poi digitare la distanza della tacca dall’angolo</translation>
    </message>
    <message>
        <source>Point into a patch, then type where the drill hole lies: 120, 40</source>
        <translation>Indicare dentro un pezzo, poi digitare dove si trova il foro: 120, 40</translation>
    </message>
    <message>
        <source>Point at an edge, then type how wide its allowance is</source>
        <translation>Indicare un lato, poi digitare la larghezza del margine</translation>
    </message>
</context>
<context>
    <name>bolster::NextStep</name>
    <message>
        <source>Next: %1 for the other side.</source>
        <translation>Ora: %1 per l’altro lato.</translation>
    </message>
    <message>
        <source>draw a second patch</source>
        <translation>disegnare un secondo pezzo</translation>
    </message>
    <message>
        <source>Next: %1 – click an edge, then the edge it is sewn to.</source>
        <translation>Ora: %1 – clic su un lato, poi sul lato a cui va cucito.</translation>
    </message>
    <message>
        <source>sew the patches</source>
        <translation>cucire i pezzi</translation>
    </message>
    <message>
        <source>Next: %1 and give them a pressure in the properties.</source>
        <translation>Ora: %1 e dare loro una pressione nelle proprietà.</translation>
    </message>
    <message>
        <source>select all patches</source>
        <translation>selezionare tutti i pezzi</translation>
    </message>
    <message>
        <source>Next: %1 – click points on it, Enter ends – to which the cover is attached.</source>
        <translation>Ora: %1 – clic sui punti, Invio termina – a cui fissare il rivestimento.</translation>
    </message>
    <message>
        <source>draw a fixation curve on the frame</source>
        <translation>disegnare una curva di fissaggio sul telaio</translation>
    </message>
    <message>
        <source>Next: select a fixation curve and %1 to it.</source>
        <translation>Ora: selezionare una curva di fissaggio e %1.</translation>
    </message>
    <message>
        <source>attach an edge</source>
        <translation>fissarvi un lato</translation>
    </message>
</context>
<context>
    <name>bolster::NumberBox</name>
    <message>
        <source>varies</source>
        <translation>varia</translation>
    </message>
    <message>
        <source>Not taken: a number is needed</source>
        <translation>Non accettato: serve un numero</translation>
    </message>
    <message>
        <source>Not taken: &quot;%1&quot; is not a length</source>
        <translation>Non accettato: «%1» non è una lunghezza</translation>
    </message>
    <message>
        <source>Not taken: &quot;%1&quot; is not a number</source>
        <translation>Non accettato: «%1» non è un numero</translation>
    </message>
    <message>
        <source>Not taken: %1 is too little, at least %2</source>
        <translation>Non accettato: %1 è troppo poco, almeno %2</translation>
    </message>
    <message>
        <source>Not taken: %1 is too much, at most %2</source>
        <translation>Non accettato: %1 è troppo, al massimo %2</translation>
    </message>
</context>
<context>
    <name>bolster::OpenFlow</name>
    <message>
        <source>Projects and designs (%1)</source>
        <translation>Progetti e modelli (%1)</translation>
    </message>
    <message>
        <source>This is the version where you were last; the one in the file is under File &gt; Revert to saved</source>
        <translation>Questa è la versione dell’ultimo lavoro; quella nel file è in File &gt; Torna al salvato</translation>
    </message>
    <message>
        <source>Open project or design</source>
        <translation>Apri progetto o modello</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open in another window.</source>
        <translation>«%1» è aperto in un’altra finestra.</translation>
    </message>
    <message>
        <source>It can be opened here to look at; what is changed is saved under another name.</source>
        <translation>Qui può essere aperto per consultarlo; le modifiche si salvano con un altro nome.</translation>
    </message>
    <message numerus="yes">
        <source>%n elements cannot be used as they are; everything else works.</source>
        <translation>
            <numerusform>%n elemento non è utilizzabile così com’è; tutto il resto funziona.</numerusform>
            <numerusform>%n elementi non sono utilizzabili così come sono; tutto il resto funziona.</numerusform>
        </translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Mostra</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Ancora nulla</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>&amp;Svuota l’elenco</translation>
    </message>
    <message>
        <source>The samples are not installed</source>
        <translation>Gli esempi non sono installati</translation>
    </message>
</context>
<context>
    <name>bolster::PagesView</name>
    <message>
        <source>Pages</source>
        <translation>Pagine</translation>
    </message>
</context>
<context>
    <name>bolster::PartsTree</name>
    <message>
        <source>Part</source>
        <translation>Parte</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangoli</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Parti</translation>
    </message>
</context>
<context>
    <name>bolster::PatternCommands</name>
    <message>
        <source>This stretch is straight already.</source>
        <translation>Questo tratto è già dritto.</translation>
    </message>
    <message>
        <source>They are equally long already.</source>
        <translation>Sono già di pari lunghezza.</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Taglia</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copia</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Incolla</translation>
    </message>
    <message>
        <source>Dupl&amp;icate</source>
        <translation>&amp;Duplica</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>Dis&amp;poni</translation>
    </message>
    <message>
        <source>Turn 90° to the &amp;left</source>
        <translation>Ruota di 90° a &amp;sinistra</translation>
    </message>
    <message>
        <source>Turn 90° to the &amp;right</source>
        <translation>Ruota di 90° a d&amp;estra</translation>
    </message>
    <message>
        <source>Mirror hori&amp;zontally</source>
        <translation>Specchia ori&amp;zzontalmente</translation>
    </message>
    <message>
        <source>Mirror &amp;vertically</source>
        <translation>Specchia &amp;verticalmente</translation>
    </message>
    <message>
        <source>Al&amp;ign</source>
        <translation>A&amp;llinea</translation>
    </message>
    <message>
        <source>&amp;Left edges</source>
        <translation>Lati &amp;sinistri</translation>
    </message>
    <message>
        <source>Centres in a &amp;column</source>
        <translation>Centri in &amp;colonna</translation>
    </message>
    <message>
        <source>&amp;Right edges</source>
        <translation>Lati &amp;destri</translation>
    </message>
    <message>
        <source>&amp;Top edges</source>
        <translation>Lati su&amp;periori</translation>
    </message>
    <message>
        <source>Centres in a ro&amp;w</source>
        <translation>Centri in &amp;riga</translation>
    </message>
    <message>
        <source>&amp;Bottom edges</source>
        <translation>Lati &amp;inferiori</translation>
    </message>
    <message>
        <source>&amp;Distribute</source>
        <translation>Distri&amp;buisci</translation>
    </message>
    <message>
        <source>&amp;Horizontally</source>
        <translation>&amp;Orizzontalmente</translation>
    </message>
    <message>
        <source>&amp;Vertically</source>
        <translation>&amp;Verticalmente</translation>
    </message>
    <message>
        <source>Arrange &amp;automatically</source>
        <translation>Disponi &amp;automaticamente</translation>
    </message>
    <message>
        <source>Poin&amp;ts and edges</source>
        <translation>Pu&amp;nti e lati</translation>
    </message>
    <message>
        <source>Make &amp;corner</source>
        <translation>Crea &amp;angolo</translation>
    </message>
    <message>
        <source>Make s&amp;mooth</source>
        <translation>Rendi li&amp;scio</translation>
    </message>
    <message>
        <source>Strai&amp;ghten</source>
        <translation>&amp;Raddrizza</translation>
    </message>
    <message>
        <source>Edge &amp;length …</source>
        <translation>&amp;Lunghezza del lato…</translation>
    </message>
    <message>
        <source>Type the length of the selected edge</source>
        <translation>Digitare la lunghezza del lato selezionato</translation>
    </message>
    <message>
        <source>Make e&amp;qually long</source>
        <translation>Rendi &amp;uguali</translation>
    </message>
    <message>
        <source>Makes the selected edges as long as the first one, or the second side of a seam as long as its first</source>
        <translation>Rende i lati selezionati lunghi quanto il primo, o il secondo lato di una cucitura quanto il suo primo</translation>
    </message>
    <message>
        <source>Mirror twi&amp;ns</source>
        <translation>Ge&amp;melli speculari</translation>
    </message>
    <message>
        <source>Merge a&amp;long seam</source>
        <translation>&amp;Unisci lungo la cucitura</translation>
    </message>
    <message>
        <source>Smooth &amp;across seam ends</source>
        <translation>Racc&amp;orda alle estremità delle cuciture</translation>
    </message>
    <message>
        <source>Outlines go on without a kink from one patch to the other where the selected seams end, when both sides lie together</source>
        <translation>Dove finiscono le cuciture selezionate i contorni proseguono senza spigolo da un pezzo all’altro, quando i due lati sono accostati</translation>
    </message>
    <message>
        <source>They go on without a kink already.</source>
        <translation>Proseguono già senza spigolo.</translation>
    </message>
</context>
<context>
    <name>bolster::PatternFitWindow</name>
    <message>
        <source>&amp;Take the changes</source>
        <translation>&amp;Applica le modifiche</translation>
    </message>
    <message>
        <source>Changes of</source>
        <translation>Modifiche di</translation>
    </message>
    <message>
        <source>Moves by</source>
        <translation>Si sposta di</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Modifiche</translation>
    </message>
    <message>
        <source>What is ticked is changed</source>
        <translation>Ciò che è spuntato viene modificato</translation>
    </message>
    <message>
        <source>&amp;How much of it</source>
        <translation>&amp;Quanto se ne applica</translation>
    </message>
    <message>
        <source>Solving the cover …</source>
        <translation>Calcolo del rivestimento…</translation>
    </message>
    <message>
        <source>Stopped; nothing has changed.</source>
        <translation>Interrotto; nulla è cambiato.</translation>
    </message>
    <message>
        <source>&amp;Find changes</source>
        <translation>&amp;Trova modifiche</translation>
    </message>
    <message>
        <source>The cover moves by %1 (rms).</source>
        <translation>Il rivestimento si sposta di %1 (rms).</translation>
    </message>
    <message>
        <source>On the way a fold came or went: look at the cover before you take it.</source>
        <translation>Nel percorso è comparsa o scomparsa una piega: guardare il rivestimento prima di applicare.</translation>
    </message>
    <message numerus="yes">
        <source>%n of the numbers that may change do nothing here.</source>
        <translation>
            <numerusform>%n dei numeri che possono cambiare qui non ha effetto.</numerusform>
            <numerusform>%n dei numeri che possono cambiare qui non hanno effetto.</numerusform>
        </translation>
    </message>
    <message>
        <source>Arrows in the pattern: %1 times as long as the way</source>
        <translation>Frecce nel cartamodello: lunghe %1 volte lo spostamento</translation>
    </message>
    <message>
        <source>Arrows in the pattern: where its outlines go</source>
        <translation>Frecce nel cartamodello: dove vanno i contorni</translation>
    </message>
    <message>
        <source>Taken. Undo takes it back.</source>
        <translation>Applicato. Annulla lo revoca.</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: find the changes again.</source>
        <translation>Nel frattempo il modello è cambiato: trovare di nuovo le modifiche.</translation>
    </message>
    <message>
        <source>With all of the changes:</source>
        <translation>Con tutte le modifiche:</translation>
    </message>
    <message>
        <source>Fitting the pattern …</source>
        <translation>Adattamento del cartamodello…</translation>
    </message>
    <message>
        <source>Changing the pattern …</source>
        <translation>Modifica del cartamodello…</translation>
    </message>
    <message>
        <source>Pressed together: %1 before, %2 now</source>
        <translation>Compresso: %1 prima, %2 ora</translation>
    </message>
    <message>
        <source>From the curve: %1 before, %2 now (rms)</source>
        <translation>Dalla curva: %1 prima, %2 ora (rms)</translation>
    </message>
    <message>
        <source>Off the area that is wanted: %1 before, %2 now</source>
        <translation>Dall’area voluta: %1 prima, %2 ora</translation>
    </message>
    <message>
        <source>Nothing is over the limits: there is nothing to do.</source>
        <translation>Niente supera i limiti: non c’è nulla da fare.</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit (before: %2), on few triangles at first</source>
        <translation>%1 del rivestimento è oltre il limite (prima: %2), dapprima su pochi triangoli</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit (before: %2)</source>
        <translation>%1 del rivestimento è oltre il limite (prima: %2)</translation>
    </message>
    <message>
        <source>With what is shown of the changes the cover cannot be solved.</source>
        <translation>Con la parte delle modifiche che è mostrata il rivestimento non si può calcolare.</translation>
    </message>
    <message>
        <source>With what is shown of the changes:</source>
        <translation>Con la parte delle modifiche che è mostrata:</translation>
    </message>
    <message>
        <source>Nothing of the changes is shown now: move the slider to see them.</source>
        <translation>Ora delle modifiche non si mostra nulla: sposti il cursore per vederle.</translation>
    </message>
    <message>
        <source>Sides of seams differ by up to %1 more than is wanted: change their neighbours, too, or let the ease change.</source>
        <translation>I lati delle cuciture differiscono fino a %1 più del voluto: cambi anche i vicini, o lasci variare l’agio.</translation>
    </message>
    <message>
        <source>Strained over the limit: %1 of the painted area before, %2 now</source>
        <translation>Deformato oltre il limite: prima %1 dell’area dipinta, ora %2</translation>
    </message>
    <message>
        <source>Strained over the limit: %1 of the cover before, %2 now</source>
        <translation>Deformato oltre il limite: prima %1 del rivestimento, ora %2</translation>
    </message>
    <message>
        <source>That is hardly nearer, and strains the cloth more: let something else change, or less of it.</source>
        <translation>È appena più vicino e deforma di più il tessuto: lasci cambiare altro, o meno.</translation>
    </message>
    <message>
        <source>Stopped. What was found until then makes it no better: nothing has changed.</source>
        <translation>Fermato. Quanto trovato finora non lo migliora: nulla è cambiato.</translation>
    </message>
    <message>
        <source>Stopped. With all of the changes that were found until then, measured anew on all triangles:</source>
        <translation>Fermato. Con tutte le modifiche trovate fino a quel momento, misurate di nuovo su tutti i triangoli:</translation>
    </message>
    <message>
        <source>Sides of seams off their ease: up to %1 before, %2 now</source>
        <translation>Lati di cuciture fuori dal loro agio: fino a %1 prima, %2 ora</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Over the fabrics&apos; limits: %1 of the cover before, %2 now</source>
        <translation>Oltre i limiti dei tessuti: prima %1 del rivestimento, ora %2</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: find the changes again, or undo that.</source>
        <translation>Nel frattempo il modello è cambiato: trovare di nuovo le modifiche o annullare ciò che è cambiato.</translation>
    </message>
    <message>
        <source>Taken back. Move the slider to see the changes again.</source>
        <translation>Annullato. Spostare il cursore per rivedere le modifiche.</translation>
    </message>
    <message>
        <source>That is hardly nearer to the limit: let something else change, or more of it.</source>
        <translation>È appena più vicino al limite: lasci cambiare altro, o di più.</translation>
    </message>
    <message>
        <source>%1 from %3 (rms; before: %2), on few triangles at first</source>
        <translation>%1 da %3 (RMS; prima: %2), dapprima su pochi triangoli</translation>
    </message>
    <message>
        <source>%1 from %3 (rms; before: %2)</source>
        <translation>%1 da %3 (RMS; prima: %2)</translation>
    </message>
    <message>
        <source>From %5: %1 before, %2 now (rms); %3 before, %4 now (95 %)</source>
        <translation>Da %5: %1 prima, %2 ora (rms); %3 prima, %4 ora (95&#xa0;%)</translation>
    </message>
    <message>
        <source>That is hardly nearer to %1: let something else change, or more of it.</source>
        <translation>È appena più vicino a %1: lasci cambiare altro, o di più.</translation>
    </message>
    <message>
        <source>Hardly less is pressed together: let something else change, or more of it.</source>
        <translation>È compresso appena di meno: lasci cambiare altro, o di più.</translation>
    </message>
    <message>
        <source>That is hardly nearer to the curve: let something else change, or more of it.</source>
        <translation>È appena più vicino alla curva: lasci cambiare altro, o di più.</translation>
    </message>
    <message>
        <source>That is hardly nearer to the area that is wanted: let something else change, or more of it.</source>
        <translation>È appena più vicino all’area voluta: lasci cambiare altro, o di più.</translation>
    </message>
    <message>
        <source>Changes the pattern until the cover is as it is wished: tick one goal or several, and what may change.</source>
        <translation>Cambia il cartamodello finché il rivestimento è come lo si desidera: spuntare uno o più obiettivi e ciò che può cambiare.</translation>
    </message>
    <message>
        <source>%1 of the painted area is over the limit (before: %2), on few triangles at first</source>
        <translation>%1 dell’area dipinta è oltre il limite (prima: %2), dapprima su pochi triangoli</translation>
    </message>
    <message>
        <source>%1 of the painted area is over the limit (before: %2)</source>
        <translation>%1 dell’area dipinta è oltre il limite (prima: %2)</translation>
    </message>
    <message>
        <source>No change makes it better on all triangles: let something else change, or points move farther.</source>
        <translation>Nessuna modifica lo migliora su tutti i triangoli: lasci cambiare altro, o che i punti vadano più lontano.</translation>
    </message>
    <message>
        <source>More of the cloth is strained over its limits: make these a goal, too, or let points move less.</source>
        <translation>Più tessuto è teso oltre i suoi limiti: ne faccia anche un obiettivo, o lasci muovere meno i punti.</translation>
    </message>
    <message>
        <source>What is wished</source>
        <translation>Ciò che si desidera</translation>
    </message>
    <message>
        <source>Fit to a goal</source>
        <translation>Adatta a un obiettivo</translation>
    </message>
</context>
<context>
    <name>bolster::PatternRuler</name>
    <message>
        <source>Drag down for a level guide. Marks move upright guides; drag them off to remove them.</source>
        <translation>Trascinare in giù per una guida orizzontale. I segni spostano le guide verticali; trascinarle fuori per rimuoverle.</translation>
    </message>
    <message>
        <source>Drag to the right for an upright guide. Marks move level guides; drag them off to remove them.</source>
        <translation>Trascinare a destra per una guida verticale. I segni spostano le guide orizzontali; trascinarle fuori per rimuoverle.</translation>
    </message>
</context>
<context>
    <name>bolster::PreferencesWindow</name>
    <message>
        <source>Preferences (*.json)</source>
        <translation>Preferenze (*.json)</translation>
    </message>
    <message>
        <source>No setting has these words.</source>
        <translation>Nessuna impostazione contiene queste parole.</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Preferenze</translation>
    </message>
    <message>
        <source>Find a setting</source>
        <translation>Trova un’impostazione</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Pagine</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Impostazioni</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuna</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Scegli…</translation>
    </message>
    <message>
        <source>&amp;Edit single shortcuts …</source>
        <translation>&amp;Modifica singole scorciatoie…</translation>
    </message>
    <message>
        <source>Back to &amp;defaults</source>
        <translation>&amp;Valori predefiniti</translation>
    </message>
    <message>
        <source>All settings of this page</source>
        <translation>Tutte le impostazioni di questa pagina</translation>
    </message>
    <message>
        <source>E&amp;xport …</source>
        <translation>&amp;Esporta…</translation>
    </message>
    <message>
        <source>&amp;Import …</source>
        <translation>&amp;Importa…</translation>
    </message>
    <message>
        <source>Export preferences</source>
        <translation>Esporta preferenze</translation>
    </message>
    <message>
        <source>Bolster preferences.json</source>
        <translation>Preferenze di Bolster.json</translation>
    </message>
    <message>
        <source>Import preferences</source>
        <translation>Importa preferenze</translation>
    </message>
    <message>
        <source>The preferences could not be exported.</source>
        <translation>Impossibile esportare le preferenze.</translation>
    </message>
    <message>
        <source>Nothing was imported from &quot;%1&quot;; all settings are as they were.</source>
        <translation>Da «%1» non è stato importato nulla; tutte le impostazioni sono com’erano.</translation>
    </message>
    <message>
        <source>The preferences were imported.</source>
        <translation>Le preferenze sono state importate.</translation>
    </message>
    <message numerus="yes">
        <source>This version of Bolster does not know %n of them: %1</source>
        <translation>
            <numerusform>Questa versione di Bolster non ne conosce %n: %1</numerusform>
            <numerusform>Questa versione di Bolster non ne conosce %n: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Ruotare</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Spostare la vista</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>Nella vista 3D</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>Nel cartamodello</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no folder on this machine: the folder of your fabrics stays what it was.</source>
        <translation>«%1» non è una cartella di questo computer: la cartella dei tuoi tessuti resta com’era.</translation>
    </message>
    <message>
        <source>&amp;Restart now</source>
        <translation>&amp;Riavvia ora</translation>
    </message>
    <message>
        <source>Closes Bolster, and asks about unsaved work as always; then it starts again with the same project</source>
        <translation>Chiude Bolster, chiedendo come sempre del lavoro non salvato; poi lo riavvia con lo stesso progetto</translation>
    </message>
</context>
<context>
    <name>bolster::ProblemsView</name>
    <message>
        <source>F1: what it means, and what to do</source>
        <translation>F1: che cosa significa e che cosa fare</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Nothing to worry about.</source>
        <translation>Niente di cui preoccuparsi.</translation>
    </message>
    <message>
        <source>All elements can be used.</source>
        <translation>Tutti gli elementi sono utilizzabili.</translation>
    </message>
</context>
<context>
    <name>bolster::PullNote</name>
    <message>
        <source>The cover in the 3D view is pulled to a scan; here it counts as the pattern alone makes it.</source>
        <translation>Il rivestimento nella vista 3D è tirato verso una scansione; qui conta così come lo fa il cartamodello da solo.</translation>
    </message>
    <message>
        <source>No scan pulls at the cover any more (a step in the history).</source>
        <translation>Nessuna scansione tira più il rivestimento (un passo della cronologia).</translation>
    </message>
    <message>
        <source>Switch the pull off</source>
        <translation>Disattiva la trazione</translation>
    </message>
    <message>
        <source>Pull again</source>
        <translation>Tira di nuovo</translation>
    </message>
</context>
<context>
    <name>bolster::ReliefWindow</name>
    <message>
        <source>Relieve strain</source>
        <translation>Riduci la deformazione</translation>
    </message>
    <message>
        <source>&amp;Look for changes</source>
        <translation>&amp;Cerca modifiche</translation>
    </message>
    <message>
        <source>Looking for what relieves strain …</source>
        <translation>Ricerca di ciò che riduce la deformazione…</translation>
    </message>
    <message>
        <source>Where cloth is strained or pressed together more than it may be, changes of the pattern are tried, and the best are solved.</source>
        <translation>Dove il tessuto è deformato o compresso più di quanto può, si provano modifiche del cartamodello e si calcolano le migliori.</translation>
    </message>
    <message>
        <source>Proposed changes</source>
        <translation>Modifiche proposte</translation>
    </message>
    <message>
        <source>Strain is at &amp;most</source>
        <translation>Deformazione al &amp;massimo</translation>
    </message>
    <message>
        <source>Else the limits of the fabrics count</source>
        <translation>Altrimenti valgono i limiti dei tessuti</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Limit of strain</source>
        <translation>Limite di deformazione</translation>
    </message>
    <message>
        <source>Edges move &amp;by at most</source>
        <translation>&amp;Spostamento massimo dei lati</translation>
    </message>
    <message>
        <source>Trying changes …</source>
        <translation>Prova delle modifiche…</translation>
    </message>
    <message>
        <source>Stopped; nothing has changed.</source>
        <translation>Interrotto; nulla è cambiato.</translation>
    </message>
    <message>
        <source>Nothing is strained over the limit.</source>
        <translation>Nulla è deformato oltre il limite.</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit. No change relieves it.</source>
        <translation>%1 del rivestimento è oltre il limite. Nessuna modifica lo migliora.</translation>
    </message>
    <message>
        <source>Each is solved by itself; &quot;Make it&quot; is one step that Undo takes back.</source>
        <translation>Ognuna è calcolata a sé; «Applica» è un solo passo, che Annulla revoca.</translation>
    </message>
    <message>
        <source>As it is now</source>
        <translation>Com’è ora</translation>
    </message>
    <message>
        <source>Sewn: %1 more</source>
        <translation>Da cucire: %1 in più</translation>
    </message>
    <message>
        <source>Sides of seams differ by %1 more</source>
        <translation>I lati delle cuciture differiscono di %1 in più</translation>
    </message>
    <message>
        <source>Outlines change by %1</source>
        <translation>I contorni cambiano di %1</translation>
    </message>
    <message>
        <source>Show where</source>
        <translation>Mostra dove</translation>
    </message>
    <message>
        <source>Make it</source>
        <translation>Applica</translation>
    </message>
    <message>
        <source>Make it: %1</source>
        <translation>Applica: %1</translation>
    </message>
    <message>
        <source>Made. Undo takes it back; look again to see what helps now.</source>
        <translation>Applicato. Annulla lo revoca; cercare di nuovo per vedere che cosa serve ora.</translation>
    </message>
    <message>
        <source>Stopped. These are solved:</source>
        <translation>Fermato. Queste sono calcolate:</translation>
    </message>
    <message>
        <source>The best changes are being solved …</source>
        <translation>Si calcolano le modifiche migliori…</translation>
    </message>
    <message>
        <source>Hardly anything is over the limit: there is little to gain. &quot;Make it&quot; is one step that Undo takes back.</source>
        <translation>Quasi nulla è oltre il limite: c’è poco da guadagnare. «Applica» è un solo passo, che Annulla revoca.</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit, by %2 (rms of all of it).</source>
        <translation>%1 del rivestimento è oltre il limite, di %2 (rms su tutto il rivestimento).</translation>
    </message>
    <message>
        <source>Over the limit: %1 of the cover, then %2</source>
        <translation>Oltre il limite: %1 del rivestimento, poi %2</translation>
    </message>
    <message>
        <source>Strain over it (rms): %1, then %2</source>
        <translation>Deformazione oltre il limite (rms): %1, poi %2</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: look again, or undo that.</source>
        <translation>Nel frattempo il modello è cambiato: cercare di nuovo o annullare ciò che è cambiato.</translation>
    </message>
    <message>
        <source>The cover moves by %1 (rms).</source>
        <translation>Il rivestimento si sposta di %1 (rms).</translation>
    </message>
    <message>
        <source>From %1 (rms): %2, then %3</source>
        <translation>Da %1 (rms): %2, poi %3</translation>
    </message>
</context>
<context>
    <name>bolster::RenderDialog</name>
    <message>
        <source>Render</source>
        <translation>Rendering</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>As in the window</source>
        <translation>Come nella finestra</translation>
    </message>
    <message>
        <source>Three-quarter</source>
        <translation>Tre quarti</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Davanti</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Dietro</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Sinistra</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Destra</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Sopra</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Bozza</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Buona</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Ottima</translation>
    </message>
    <message>
        <source>How often each pixel is looked at</source>
        <translation>Quante volte si esamina ogni pixel</translation>
    </message>
    <message>
        <source>Transparent &amp;background</source>
        <translation>&amp;Sfondo trasparente</translation>
    </message>
    <message>
        <source>The shadow on the ground is kept</source>
        <translation>L’ombra al suolo resta</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Dimensioni:</translation>
    </message>
    <message>
        <source>&amp;View:</source>
        <translation>&amp;Vista:</translation>
    </message>
    <message>
        <source>Sho&amp;w:</source>
        <translation>&amp;Mostra:</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>&amp;Qualità:</translation>
    </message>
    <message>
        <source>Drawing …</source>
        <translation>Disegno…</translation>
    </message>
    <message>
        <source>&amp;Render …</source>
        <translation>&amp;Renderizza…</translation>
    </message>
    <message>
        <source>The fabrics as in the window</source>
        <translation>I tessuti come nella finestra</translation>
    </message>
    <message>
        <source>Colourway %1</source>
        <translation>Variante colore %1</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>Quadri</translation>
    </message>
    <message>
        <source>At most %1 million pixels are drawn; choose a smaller size.</source>
        <translation>Si disegnano al massimo %1 milioni di pixel; scegliere una dimensione minore.</translation>
    </message>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation>L’immagine non può essere scritta: %1</translation>
    </message>
    <message>
        <source>Render to</source>
        <translation>Salva rendering in</translation>
    </message>
    <message>
        <source>PNG, 8 bits (*.png);;TIFF, 16 bits (*.tif *.tiff);;OpenEXR, linear light (*.exr)</source>
        <translation>PNG, 8 bit (*.png);;TIFF, 16 bit (*.tif *.tiff);;OpenEXR, luce lineare (*.exr)</translation>
    </message>
    <message>
        <source>The name must end in .png, .tif or .exr.</source>
        <translation>Il nome deve finire in .png, .tif o .exr.</translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>Annullato; non è stato scritto nulla.</translation>
    </message>
    <message>
        <source>one picture</source>
        <translation>una immagine</translation>
    </message>
    <message>
        <source> pictures</source>
        <translation> immagini</translation>
    </message>
    <message>
        <source>So many pictures from all around, with numbers in their names</source>
        <translation>Altrettante immagini tutt’intorno, numerate nel nome</translation>
    </message>
    <message>
        <source>&amp;Around the cover:</source>
        <translation>&amp;Intorno al rivestimento:</translation>
    </message>
    <message>
        <source>All colourways on a sheet</source>
        <translation>Tutte le varianti colore su un foglio</translation>
    </message>
    <message>
        <source>Map: %1</source>
        <translation>Mappa: %1</translation>
    </message>
    <message>
        <source>&amp;Frame and foam</source>
        <translation>&amp;Telaio ed espanso</translation>
    </message>
    <message>
        <source>In the materials that their properties say</source>
        <translation>Nei materiali indicati nelle loro proprietà</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Chiudi</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annulla</translation>
    </message>
    <message>
        <source>The picture is written: %1</source>
        <translation>L’immagine è stata scritta: %1</translation>
    </message>
    <message>
        <source>Open its folder</source>
        <translation>Apri la cartella</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Anteprima</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Larghezza</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altezza</translation>
    </message>
    <message>
        <source>What was made</source>
        <translation>Che cosa è stato creato</translation>
    </message>
    <message>
        <source>Drawing %1 …</source>
        <translation>Disegno di %1…</translation>
    </message>
</context>
<context>
    <name>bolster::ReportDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>Segnala un problema</translation>
    </message>
    <message>
        <source>What did you do, what happened, and what should have happened?</source>
        <translation>Che cosa si stava facendo, che cosa è successo e che cosa sarebbe dovuto succedere?</translation>
    </message>
    <message>
        <source>&amp;What happened:</source>
        <translation>&amp;Che cosa è successo:</translation>
    </message>
    <message>
        <source>&amp;Add the design (&quot;%1&quot;), without its frames, scans and pictures</source>
        <translation>&amp;Aggiungi il modello («%1»), senza telai, scansioni e immagini</translation>
    </message>
    <message>
        <source>What the &amp;report says besides:</source>
        <translation>Altro contenuto del &amp;rapporto:</translation>
    </message>
    <message>
        <source>Write the report …</source>
        <translation>Scrivi il rapporto…</translation>
    </message>
    <message>
        <source>This writes a file that you can give to those who can help. Bolster sends nothing.</source>
        <translation>Scrive un file da dare a chi può aiutare. Bolster non invia nulla.</translation>
    </message>
    <message>
        <source>not known yet</source>
        <translation>non ancora noto</translation>
    </message>
    <message>
        <source>Messages of this run:</source>
        <translation>Messaggi di questa esecuzione:</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(nessuno)</translation>
    </message>
    <message>
        <source>The last crash:</source>
        <translation>L’ultimo arresto anomalo:</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Scrivi il rapporto</translation>
    </message>
    <message>
        <source>ZIP (*.zip)</source>
        <translation>ZIP (*.zip)</translation>
    </message>
    <message>
        <source>The report is written: %1</source>
        <translation>Il rapporto è stato scritto: %1</translation>
    </message>
    <message>
        <source>The report could not be written: %1</source>
        <translation>Impossibile scrivere il rapporto: %1</translation>
    </message>
</context>
<context>
    <name>bolster::Rescue</name>
    <message>
        <source>%1 (recovered)</source>
        <translation>%1 (recuperato)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be opened.</source>
        <translation>Impossibile aprire «%1».</translation>
    </message>
    <message>
        <source>What can be read goes into a new project beside it. This file stays as it is.</source>
        <translation>Ciò che è leggibile va in un nuovo progetto accanto. Questo file resta com’è.</translation>
    </message>
    <message>
        <source>&amp;Recover what can be read</source>
        <translation>&amp;Recupera ciò che è leggibile</translation>
    </message>
    <message>
        <source>Recovering &quot;%1&quot; …</source>
        <translation>Recupero di «%1»…</translation>
    </message>
    <message>
        <source>Nothing could be recovered.</source>
        <translation>Non è stato recuperato nulla.</translation>
    </message>
    <message>
        <source>What could be read is in &quot;%1&quot; now.</source>
        <translation>Ciò che era leggibile è ora in «%1».</translation>
    </message>
    <message>
        <source>The unsaved work on &quot;%1&quot; is damaged.</source>
        <translation>Il lavoro non salvato su «%1» è danneggiato.</translation>
    </message>
    <message numerus="yes">
        <source>What can be read goes into a new project. What you do not want any more is deleted %n days after it was put into the bin.</source>
        <translation>
            <numerusform>Ciò che è leggibile va in un nuovo progetto. Ciò che non serve più viene eliminato %n giorno dopo essere finito nel cestino.</numerusform>
            <numerusform>Ciò che è leggibile va in un nuovo progetto. Ciò che non serve più viene eliminato %n giorni dopo essere finito nel cestino.</numerusform>
        </translation>
    </message>
    <message>
        <source>Put it into the &amp;bin</source>
        <translation>Metti nel &amp;cestino</translation>
    </message>
    <message>
        <source>The damaged work is kept under File &gt; Unsaved work</source>
        <translation>Il lavoro danneggiato è conservato in File &gt; Lavoro non salvato</translation>
    </message>
    <message>
        <source>What could be read of it is in &quot;%1&quot; now.</source>
        <translation>Ciò che ne era leggibile è ora in «%1».</translation>
    </message>
    <message>
        <source>Nothing of it could be read.</source>
        <translation>Nulla ne era leggibile.</translation>
    </message>
    <message>
        <source>Nothing that was saved is concerned. The damaged work is kept under File &gt; Unsaved work.</source>
        <translation>Ciò che era salvato non è toccato. Il lavoro danneggiato è conservato in File &gt; Lavoro non salvato.</translation>
    </message>
    <message>
        <source>Open what was &amp;recovered</source>
        <translation>Apri ciò che è stato &amp;recuperato</translation>
    </message>
    <message>
        <source>Looking for what can be read in &quot;%1&quot; …</source>
        <translation>Ricerca di ciò che si può leggere in «%1»…</translation>
    </message>
</context>
<context>
    <name>bolster::RunRow</name>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Interrompi</translation>
    </message>
</context>
<context>
    <name>bolster::SaveFlow</name>
    <message>
        <source>Project with its history (*.bolster);;Design as text (*.json)</source>
        <translation>Progetto con la sua cronologia (*.bolster);;Modello come testo (*.json)</translation>
    </message>
    <message numerus="yes">
        <source>%n edits</source>
        <translation>
            <numerusform>%n modifica</numerusform>
            <numerusform>%n modifiche</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edits that were undone or are on other branches</source>
        <translation>
            <numerusform>%n modifica annullata o su altri rami</numerusform>
            <numerusform>%n modifiche annullate o su altri rami</numerusform>
        </translation>
    </message>
    <message>
        <source>names of versions or branches</source>
        <translation>nomi di versioni o rami</translation>
    </message>
    <message>
        <source>The file holds another version of the design than the one you see.</source>
        <translation>Il file contiene una versione del modello diversa da quella visibile.</translation>
    </message>
    <message>
        <source>Not saved yet: %1.</source>
        <translation>Non ancora salvato: %1.</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>Salva una copia</translation>
    </message>
    <message>
        <source>-copy</source>
        <translation>-copia</translation>
    </message>
    <message>
        <source>Project (*.%1)</source>
        <translation>Progetto (*.%1)</translation>
    </message>
    <message>
        <source>Save the changes in &quot;%1&quot;?</source>
        <translation>Salvare le modifiche in «%1»?</translation>
    </message>
    <message>
        <source>A design as text cannot hold that, a project can.</source>
        <translation>Un modello come testo non può contenerlo, un progetto sì.</translation>
    </message>
    <message>
        <source>Work that is kept for later, with all its steps, is under File &gt; Unsaved work.</source>
        <translation>Il lavoro conservato per dopo, con tutti i suoi passi, è in File &gt; Lavoro non salvato.</translation>
    </message>
    <message>
        <source>Save as &amp;project …</source>
        <translation>Salva come &amp;progetto…</translation>
    </message>
    <message>
        <source>&amp;Keep for later</source>
        <translation>&amp;Conserva per dopo</translation>
    </message>
    <message>
        <source>The work cannot be kept.</source>
        <translation>Il lavoro non può essere conservato.</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Salva progetto</translation>
    </message>
    <message>
        <source>Saved a copy as %1</source>
        <translation>Copia salvata come %1</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Salvato come %1</translation>
    </message>
    <message>
        <source>%1: the design alone, without its history</source>
        <translation>%1: solo il modello, senza la sua cronologia</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the file any more that was opened or saved here.</source>
        <translation>«%1» non è più il file che è stato aperto o salvato qui.</translation>
    </message>
    <message>
        <source>Save your design under another name, or let what is there now have another name beside it. If that is a damaged project, File &gt; Open recovers what can be read of it.</source>
        <translation>Salvare il modello con un altro nome, oppure dare un altro nome a ciò che ora si trova lì. Se è un progetto danneggiato, File &gt; Apri recupera ciò che ne è leggibile.</translation>
    </message>
    <message>
        <source>&amp;Keep the other file beside it, and save</source>
        <translation>&amp;Conserva accanto l’altro file e salva</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be saved.</source>
        <translation>Impossibile salvare «%1».</translation>
    </message>
    <message>
        <source>What was in the place of &quot;%1&quot; is in &quot;%2&quot; now.</source>
        <translation>Ciò che era al posto di «%1» è ora in «%2».</translation>
    </message>
    <message>
        <source>Somebody else has changed &quot;%1&quot; since it was opened here.</source>
        <translation>Qualcun altro ha modificato «%1» dopo l’apertura qui.</translation>
    </message>
    <message>
        <source>Their changes can become a branch of the history here, then both are saved. Your design stays as it is, and you can go to theirs.</source>
        <translation>Le altre modifiche possono diventare qui un ramo della cronologia, poi si salvano entrambe. Il proprio modello resta com’è e si può passare all’altro.</translation>
    </message>
    <message>
        <source>&amp;Take their changes in as a branch</source>
        <translation>&amp;Accogli le modifiche come ramo</translation>
    </message>
    <message>
        <source>From the file, %1</source>
        <translation>Dal file, %1</translation>
    </message>
    <message>
        <source>Their changes could not be taken in.</source>
        <translation>Impossibile accogliere le altre modifiche.</translation>
    </message>
    <message>
        <source>The changes of somebody else are a branch of the history now.</source>
        <translation>Le modifiche dell’altra persona sono ora un ramo della cronologia.</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Mostra</translation>
    </message>
    <message>
        <source>Go &amp;there</source>
        <translation>&amp;Vai lì</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>&amp;Riprova</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>Salva con &amp;nome…</translation>
    </message>
    <message>
        <source>Nothing protects what you do since %1 against a crash: Bolster cannot write to the folder &quot;%2&quot;. Make room there, or save the design.</source>
        <translation>Il lavoro da %1 in poi non è protetto da un arresto anomalo: Bolster non può scrivere nella cartella «%2». Liberare spazio o salvare il modello.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Salva</translation>
    </message>
</context>
<context>
    <name>bolster::ScanLink</name>
    <message>
        <source>Deviation from %1</source>
        <translation>Scostamento da %1</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>dentro</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>fuori</translation>
    </message>
</context>
<context>
    <name>bolster::SeamLineList</name>
    <message>
        <source>Seam lines</source>
        <translation>Linee di cucitura</translation>
    </message>
    <message>
        <source>Fixation curves of the design. Draw seam lines on a frame with the tool for fixation curves: what is drawn meanwhile is cut at once</source>
        <translation>Curve di fissaggio del modello. Disegnare linee di cucitura su un telaio con lo strumento per curve di fissaggio: ciò che si disegna nel frattempo viene subito tagliato</translation>
    </message>
    <message numerus="yes">
        <source>%n lines that hold a cover</source>
        <translation>
            <numerusform>%n linea che tiene un rivestimento</numerusform>
            <numerusform>%n linee che tengono un rivestimento</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::SeamProposalsWindow</name>
    <message>
        <source>Proposed seams</source>
        <translation>Cuciture proposte</translation>
    </message>
    <message>
        <source>Edge of</source>
        <translation>Lato di</translation>
    </message>
    <message>
        <source>to edge of</source>
        <translation>a lato di</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Lunghezze</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>Certezza</translation>
    </message>
    <message>
        <source>Select rows to see their edges in the pattern; Enter or a double click sews them.</source>
        <translation>Selezionare righe per vederne i lati nel cartamodello; Invio o un doppio clic li cuce.</translation>
    </message>
    <message>
        <source>&amp;Sew selected</source>
        <translation>&amp;Cuci selezionate</translation>
    </message>
    <message>
        <source>Sew &amp;all</source>
        <translation>Cuci &amp;tutte</translation>
    </message>
    <message>
        <source>Looking for edges that belong together …</source>
        <translation>Ricerca di lati che vanno insieme…</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>There are no free edges that seem to belong together.</source>
        <translation>Non ci sono lati liberi che sembrino andare insieme.</translation>
    </message>
    <message>
        <source>Sew &amp;likely ones</source>
        <translation>Cuci le &amp;probabili</translation>
    </message>
    <message>
        <source>Those of 50 % and more. What is sewn tells where its neighbours belong.</source>
        <translation>Quelle dal 50&#xa0;% in su. Ciò che è cucito indica dove vanno le vicine.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 e %2</translation>
    </message>
    <message>
        <source>Found by their lengths, corners that would close, names and directions; the most certain first. Look at each in the pattern before you sew it.</source>
        <translation>In base a lunghezze, angoli che si chiuderebbero, nomi e direzioni; prima le più certe. Guardarle nel cartamodello prima di cucirle.</translation>
    </message>
</context>
<context>
    <name>bolster::SeamsModel</name>
    <message>
        <source>Length</source>
        <translation>Lunghezza</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parametro</translation>
    </message>
    <message>
        <source>More than 5 % ease puckers.</source>
        <translation>Oltre il 5&#xa0;% di lentezza arriccia.</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Cucitura</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Lentezza</translation>
    </message>
    <message>
        <source>Ease %</source>
        <translation>Lent. %</translation>
    </message>
    <message>
        <source>Joins</source>
        <translation>Continuità</translation>
    </message>
    <message>
        <source>Length 1</source>
        <translation>Lunghezza 1</translation>
    </message>
    <message>
        <source>Length 2</source>
        <translation>Lunghezza 2</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Corrispondenza</translation>
    </message>
    <message>
        <source>The letter on both stretches in the pattern</source>
        <translation>La lettera sui due tratti nel cartamodello</translation>
    </message>
    <message>
        <source>The patches and their edges</source>
        <translation>I pezzi e i loro lati</translation>
    </message>
    <message>
        <source>C0: an edge, C1: smooth with the texture, G1: rounded</source>
        <translation>C0: uno spigolo, C1: liscio anche nella trama, G1: arrotondato</translation>
    </message>
    <message>
        <source>Of the first side</source>
        <translation>Del primo lato</translation>
    </message>
    <message>
        <source>Of the second side</source>
        <translation>Del secondo lato</translation>
    </message>
    <message>
        <source>What is sewn together: equal parts of the length, or of the curve&apos;s parameter</source>
        <translation>Che cosa si cuce insieme: parti uguali della lunghezza o del parametro della curva</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Fase</translation>
    </message>
    <message>
        <source>The place in the order of sewing; Seam &gt; Sew earlier and Sew later change it</source>
        <translation>Il posto nell’ordine di cucitura; lo cambiano Cucitura &gt; Cuci prima e Cuci dopo</translation>
    </message>
    <message>
        <source>How much longer the second side is than the first one</source>
        <translation>Di quanto il secondo lato è più lungo del primo</translation>
    </message>
    <message>
        <source>The ease over the shorter side; more than 5 % puckers</source>
        <translation>La lentezza rispetto al lato più corto; oltre il 5&#xa0;% arriccia</translation>
    </message>
</context>
<context>
    <name>bolster::SeamsView</name>
    <message>
        <source>No seams yet. Choose the sewing tool (W), then click the two edges that belong together.</source>
        <translation>Ancora nessuna cucitura. Scegliere lo strumento di cucitura (W), poi fare clic sui due lati che vanno insieme.</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Cuciture</translation>
    </message>
</context>
<context>
    <name>bolster::SectionPanel</name>
    <message>
        <source>Section</source>
        <translation>Sezione</translation>
    </message>
    <message>
        <source>Cut across the x axis</source>
        <translation>Taglia perpendicolarmente all’asse x</translation>
    </message>
    <message>
        <source>Cut across the y axis</source>
        <translation>Taglia perpendicolarmente all’asse y</translation>
    </message>
    <message>
        <source>Cut across the z axis</source>
        <translation>Taglia perpendicolarmente all’asse z</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Cut parallel to the picture, as it is seen now</source>
        <translation>Taglia parallelamente all’immagine, come si vede ora</translation>
    </message>
    <message>
        <source>Moves the plane</source>
        <translation>Sposta il piano</translation>
    </message>
    <message>
        <source>Show the other half</source>
        <translation>Mostra l’altra metà</translation>
    </message>
    <message>
        <source>Close the section</source>
        <translation>Chiudi la sezione</translation>
    </message>
    <message>
        <source>Place of the section</source>
        <translation>Posizione della sezione</translation>
    </message>
</context>
<context>
    <name>bolster::SewingCommands</name>
    <message>
        <source>Propos&amp;e seams …</source>
        <translation>&amp;Proponi cuciture…</translation>
    </message>
    <message>
        <source>Show seam li&amp;st</source>
        <translation>Mostra &amp;elenco cuciture</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>&amp;Inverti</translation>
    </message>
    <message>
        <source>Swap si&amp;des</source>
        <translation>&amp;Scambia lati</translation>
    </message>
    <message>
        <source>C&amp;0 – an edge</source>
        <translation>C&amp;0 – uno spigolo</translation>
    </message>
    <message>
        <source>C&amp;1 – smooth, texture too</source>
        <translation>C&amp;1 – liscio, anche la trama</translation>
    </message>
    <message>
        <source>&amp;G1 – rounded</source>
        <translation>&amp;G1 – arrotondato</translation>
    </message>
    <message>
        <source>Match by &amp;length</source>
        <translation>Corrispondenza per &amp;lunghezza</translation>
    </message>
    <message>
        <source>Match by &amp;parameter</source>
        <translation>Corrispondenza per pa&amp;rametro</translation>
    </message>
    <message>
        <source>Sew earl&amp;ier</source>
        <translation>&amp;Cuci prima</translation>
    </message>
    <message>
        <source>Sew l&amp;ater</source>
        <translation>Cuci &amp;dopo</translation>
    </message>
    <message>
        <source>Sewi&amp;ng order as proposed</source>
        <translation>&amp;Ordine di cucitura proposto</translation>
    </message>
</context>
<context>
    <name>bolster::SheetPreview</name>
    <message>
        <source>What will be on the sheets</source>
        <translation>Che cosa ci sarà sui fogli</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>Non c’è nulla da tagliare.</translation>
    </message>
    <message>
        <source>Laying out …</source>
        <translation>Disposizione…</translation>
    </message>
</context>
<context>
    <name>bolster::ShortcutsDialog</name>
    <message>
        <source>&amp;No keys</source>
        <translation>&amp;Nessun tasto</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Ripristina</translation>
    </message>
    <message>
        <source>&amp;Take them over</source>
        <translation>Ri&amp;assegna</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Scorciatoie</translation>
    </message>
    <message>
        <source>Find a command or a key</source>
        <translation>Trova un comando o un tasto</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasti</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>Ripristina &amp;tutto</translation>
    </message>
    <message>
        <source>Click into the field and press the keys.</source>
        <translation>Fare clic nel campo e premere i tasti.</translation>
    </message>
    <message>
        <source>Choose a command to change its keys.</source>
        <translation>Scegliere un comando per cambiarne i tasti.</translation>
    </message>
    <message>
        <source>%1 is needed by the views and fields themselves.</source>
        <translation>%1 serve alle viste e ai campi stessi.</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 appartiene a «%2».</translation>
    </message>
    <message>
        <source>%1 it is.</source>
        <translation>%1 è assegnato.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Comandi</translation>
    </message>
</context>
<context>
    <name>bolster::ShownPattern</name>
    <message>
        <source>Edge: %1</source>
        <translation>Lato: %1</translation>
    </message>
</context>
<context>
    <name>bolster::SimplifyChoice</name>
    <message>
        <source>&amp;Simplify to about</source>
        <translation>&amp;Semplifica a circa</translation>
    </message>
    <message>
        <source> triangles</source>
        <translation> triangoli</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangoli</translation>
    </message>
    <message>
        <source>Writes the parts that are wanted into an OBJ file of the design&apos;s own; the file that was chosen stays as it is</source>
        <translation>Scrive le parti volute in un file OBJ proprio del modello; il file scelto resta com’è</translation>
    </message>
</context>
<context>
    <name>bolster::SpotsPanel</name>
    <message>
        <source>Worst spots</source>
        <translation>Punti critici</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>Pezzo</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valore</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Negative where the fabric is pressed together</source>
        <translation>Negativo dove il tessuto è compresso</translation>
    </message>
    <message>
        <source>What the fabric there may suffer. The spots are sorted by how much of it they take</source>
        <translation>Ciò che il tessuto può sopportare lì. I punti sono ordinati secondo quanto ne impegnano</translation>
    </message>
    <message>
        <source>As soon as there is a cover, its worst spots will be listed here.</source>
        <translation>Appena c’è un rivestimento, i suoi punti critici saranno elencati qui.</translation>
    </message>
    <message>
        <source>A map of strain or shear shows what the fabric suffers. Its worst spots will be listed here.</source>
        <translation>Una mappa di deformazione o scorrimento mostra ciò che il tessuto sopporta. I suoi punti critici saranno elencati qui.</translation>
    </message>
    <message>
        <source>Nothing is over the limit of its fabric.</source>
        <translation>Nulla è oltre il limite del suo tessuto.</translation>
    </message>
    <message>
        <source>Over the limit of the fabric: %1 of %2</source>
        <translation>Oltre il limite del tessuto: %1 di %2</translation>
    </message>
    <message>
        <source>over the limit of %1</source>
        <translation>oltre il limite di %1</translation>
    </message>
    <message>
        <source>Show the &amp;largest strain</source>
        <translation>Mostra la deformazione &amp;massima</translation>
    </message>
</context>
<context>
    <name>bolster::StartHint</name>
    <message>
        <source>A new cover</source>
        <translation>Un nuovo rivestimento</translation>
    </message>
    <message>
        <source>Draw the first patch, import a frame, or open a design:</source>
        <translation>Disegnare il primo pezzo, importare un telaio o aprire un modello:</translation>
    </message>
    <message>
        <source>Or look at a sample:</source>
        <translation>Oppure guardare un esempio:</translation>
    </message>
    <message>
        <source>%1 more are under File &gt; Samples</source>
        <translation>Altri %1 sono in File &gt; Esempi</translation>
    </message>
    <message>
        <source>Go on with:</source>
        <translation>Continuare con:</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Svuota l’elenco</translation>
    </message>
    <message>
        <source>Rectan&amp;gle</source>
        <translation>&amp;Rettangolo</translation>
    </message>
    <message>
        <source>Ou&amp;tline</source>
        <translation>&amp;Contorno</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>&amp;Apri…</translation>
    </message>
    <message>
        <source>&amp;Import frame …</source>
        <translation>&amp;Importa telaio…</translation>
    </message>
</context>
<context>
    <name>bolster::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Pagina iniziale</translation>
    </message>
    <message>
        <source>Welcome to Bolster</source>
        <translation>Benvenuti in Bolster</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>Inizia il tour</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Apri…</translation>
    </message>
    <message>
        <source>Back to the design</source>
        <translation>Torna al modello</translation>
    </message>
    <message>
        <source>What do you have?</source>
        <translation>Da che cosa si parte?</translation>
    </message>
    <message>
        <source>A frame</source>
        <translation>Un telaio</translation>
    </message>
    <message>
        <source>The cover is fixed on it: %1</source>
        <translation>Il rivestimento vi viene fissato: %1</translation>
    </message>
    <message>
        <source>A pattern</source>
        <translation>Un cartamodello</translation>
    </message>
    <message>
        <source>Its pieces become the cover: %1</source>
        <translation>I suoi pezzi diventano il rivestimento: %1</translation>
    </message>
    <message>
        <source>A scan</source>
        <translation>Una scansione</translation>
    </message>
    <message>
        <source>The cover is fitted to it: %1</source>
        <translation>Il rivestimento vi viene adattato: %1</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Ancora nulla</translation>
    </message>
    <message>
        <source>Draw a rectangle, the first patch</source>
        <translation>Disegnare un rettangolo, il primo pezzo</translation>
    </message>
    <message>
        <source>Go on with</source>
        <translation>Continuare con</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Svuota l’elenco</translation>
    </message>
    <message>
        <source>Take it out of this list; the file stays</source>
        <translation>Togli da questo elenco; il file resta</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Lavoro non salvato</translation>
    </message>
    <message>
        <source>Kept for later, last edit %1</source>
        <translation>Conservato per dopo, ultima modifica %1</translation>
    </message>
    <message>
        <source>Left by a crash, last edit %1</source>
        <translation>Rimasto da un arresto anomalo, ultima modifica %1</translation>
    </message>
    <message>
        <source>Begin with a template</source>
        <translation>Iniziare da un modello pronto</translation>
    </message>
    <message>
        <source>Look at a sample</source>
        <translation>Guardare un esempio</translation>
    </message>
    <message>
        <source>It is not there now</source>
        <translation>Ora non è reperibile</translation>
    </message>
</context>
<context>
    <name>bolster::StatusLine</name>
    <message>
        <source>Nothing to sew yet</source>
        <translation>Ancora nulla da cucire</translation>
    </message>
    <message>
        <source>Preparing …</source>
        <translation>Preparazione…</translation>
    </message>
    <message>
        <source>Moving, %1/s</source>
        <translation>In movimento, %1/s</translation>
    </message>
    <message>
        <source>Solved – %1 iterations</source>
        <translation>Calcolato – %1 iterazioni</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>In pausa</translation>
    </message>
    <message numerus="yes">
        <source>%n problems</source>
        <translation>
            <numerusform>%n problema</numerusform>
            <numerusform>%n problemi</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n avviso</numerusform>
            <numerusform>%n avvisi</numerusform>
        </translation>
    </message>
    <message>
        <source>Solved in part</source>
        <translation>Calcolato in parte</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Perché?</translation>
    </message>
    <message>
        <source>Following the drag</source>
        <translation>Segue il trascinamento</translation>
    </message>
    <message>
        <source>Solved, with warnings</source>
        <translation>Calcolato, con avvisi</translation>
    </message>
    <message>
        <source>Show (%1)</source>
        <translation>Mostra (%1)</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostra</translation>
    </message>
    <message>
        <source>The cloth went on moving until the computation was ended. What usually causes that:
• A piece that nothing holds: fix one of its edges, or sew it on.
• A seam whose two sides differ much in length: make them more alike.
• A very long or very narrow piece: divide it, or make it wider.
• High pressure: lower it in the properties of the patch.
What you see is where the cloth was at the end.</source>
        <translation>Il tessuto ha continuato a muoversi fino al termine del calcolo. Le cause consuete:
• Un pezzo che nulla tiene: fissarne un lato o cucirlo ad altri.
• Una cucitura con lati di lunghezza molto diversa: renderli più simili.
• Un pezzo molto lungo o molto stretto: dividerlo o allargarlo.
• Pressione alta: ridurla nelle proprietà del pezzo.
Si vede il tessuto com’era alla fine.</translation>
    </message>
    <message>
        <source>Drawing and checking …</source>
        <translation>Disegno e verifica…</translation>
    </message>
    <message>
        <source>Preparing: on fewer triangles …</source>
        <translation>Preparazione: su meno triangoli…</translation>
    </message>
    <message>
        <source>Preparing: forces and equations …</source>
        <translation>Preparazione: forze ed equazioni…</translation>
    </message>
    <message>
        <source>&amp;What does it mean?</source>
        <translation>&amp;Che cosa significa?</translation>
    </message>
    <message>
        <source>A preview, not checked yet</source>
        <translation>Un’anteprima, non ancora controllata</translation>
    </message>
</context>
<context>
    <name>bolster::SweepWindow</name>
    <message>
        <source>Tolerances</source>
        <translation>Tolleranze</translation>
    </message>
    <message>
        <source>&amp;Draw pieces</source>
        <translation>&amp;Genera pezzi</translation>
    </message>
    <message>
        <source>Solving pieces within tolerances …</source>
        <translation>Calcolo di pezzi entro le tolleranze…</translation>
    </message>
    <message>
        <source>Pieces are drawn at random within their tolerances: where does the cover vary, which tolerance matters, how many pieces are out of the limit?</source>
        <translation>I pezzi sono generati a caso entro le tolleranze: dove varia il rivestimento, quale tolleranza conta, quanti pezzi sono fuori limite?</translation>
    </message>
    <message>
        <source>&amp;Show on the cover what 95 % of the pieces do not exceed</source>
        <translation>M&amp;ostra sul rivestimento ciò che il 95&#xa0;% dei pezzi non supera</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolleranza</translation>
    </message>
    <message>
        <source>Moves by at most</source>
        <translation>Spostamento massimo</translation>
    </message>
    <message>
        <source>Tolerances by their influence</source>
        <translation>Tolleranze per influenza</translation>
    </message>
    <message>
        <source>Tolerances (±); 0: none</source>
        <translation>Tolleranze (±); 0: nessuna</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Pezzi</translation>
    </message>
    <message>
        <source>Every size within is as likely</source>
        <translation>Ogni misura compresa è ugualmente probabile</translation>
    </message>
    <message>
        <source>Normal: the tolerance is three standard deviations</source>
        <translation>Normale: la tolleranza equivale a tre deviazioni standard</translation>
    </message>
    <message>
        <source>Before them ten thousand are drawn as if covers were linear, which takes seconds</source>
        <translation>Prima se ne generano diecimila come se i rivestimenti fossero lineari, il che richiede secondi</translation>
    </message>
    <message>
        <source>Dr&amp;awn</source>
        <translation>Ge&amp;nerati</translation>
    </message>
    <message>
        <source>S&amp;olved</source>
        <translation>Ca&amp;lcolati</translation>
    </message>
    <message>
        <source>Nothing varies: give a tolerance above 0 of something that the design has.</source>
        <translation>Nulla varia: indicare una tolleranza maggiore di 0 per qualcosa che il modello ha.</translation>
    </message>
    <message>
        <source>Covers with each tolerance are solved …</source>
        <translation>Calcolo dei rivestimenti con ogni tolleranza…</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Interrotto.</translation>
    </message>
    <message>
        <source>That is as if covers were linear; pieces are being solved …</source>
        <translation>Questo come se i rivestimenti fossero lineari; calcolo dei pezzi in corso…</translation>
    </message>
    <message>
        <source>That is as if covers were linear.</source>
        <translation>Questo come se i rivestimenti fossero lineari.</translation>
    </message>
    <message numerus="yes">
        <source>By %n solved pieces.</source>
        <translation>
            <numerusform>In base a %n pezzo calcolato.</numerusform>
            <numerusform>In base a %n pezzi calcolati.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces have no cover at rest.</source>
        <translation>
            <numerusform>%n pezzo non ha un rivestimento a riposo.</numerusform>
            <numerusform>%n pezzi non hanno un rivestimento a riposo.</numerusform>
        </translation>
    </message>
    <message>
        <source>What 95 % of the pieces do not exceed</source>
        <translation>Ciò che il 95&#xa0;% dei pezzi non supera</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: draw the pieces again.</source>
        <translation>Nel frattempo il modello è cambiato: generare di nuovo i pezzi.</translation>
    </message>
    <message numerus="yes">
        <source>By %n solved pieces so far; more are being solved …</source>
        <translation>
            <numerusform>In base a %n pezzo calcolato finora; altri sono in calcolo…</numerusform>
            <numerusform>In base a %n pezzi calcolati finora; altri sono in calcolo…</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With %n tolerances no cover is found, as with: %1. They are left out of this: make them smaller.</source>
        <translation>
            <numerusform>Con %n tolleranza non si trova un rivestimento: %1. Qui non è compresa: la riduca.</numerusform>
            <numerusform>Con %n tolleranze non si trova un rivestimento, come con: %1. Qui non sono comprese: le riduca.</numerusform>
        </translation>
    </message>
    <message>
        <source>A piece is out of it when more than 5 % of its cover lie farther from where they should be</source>
        <translation>Un pezzo è fuori limite quando più del 5&#xa0;% del rivestimento dista di più da dove dovrebbe essere</translation>
    </message>
    <message>
        <source>95 % of the pieces do not exceed, place by place, %1 (rms over the cover), %2 where it is most.</source>
        <translation>Ciò che il 95&#xa0;% dei pezzi non supera, punto per punto: %1 (rms sul rivestimento), %2 dove è massimo.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Quota</translation>
    </message>
    <message>
        <source>How much of the variance of the whole cover comes of it</source>
        <translation>Quanta parte della varianza di tutto il rivestimento ne deriva</translation>
    </message>
    <message>
        <source>± is what many more of them may change.</source>
        <translation>± è quanto molti altri possono cambiare.</translation>
    </message>
    <message>
        <source>Out of the limit: about %1 of the pieces.</source>
        <translation>Fuori limite: circa %1 dei pezzi.</translation>
    </message>
    <message>
        <source>Out of the limit: %1 of %2 pieces (of many: %3 to %4).</source>
        <translation>Fuori limite: %1 di %2 pezzi (di molti: da %3 a %4).</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>These are too few to say how sure that is.</source>
        <translation>Sono troppo pochi per dire quanto è sicuro.</translation>
    </message>
    <message>
        <source>&amp;Limit for 95 % of a cover</source>
        <translation>Li&amp;mite per il 95&#xa0;% di un rivestimento</translation>
    </message>
    <message>
        <source>This is of what was set before: draw pieces for what is set now.</source>
        <translation>Questo vale per ciò che era impostato prima: generi pezzi per ciò che è impostato ora.</translation>
    </message>
</context>
<context>
    <name>bolster::ToolHost</name>
    <message>
        <source>This could not be done, and nothing was changed: %1</source>
        <translation>Operazione impossibile, nulla è stato modificato: %1</translation>
    </message>
</context>
<context>
    <name>bolster::TourPanel</name>
    <message>
        <source>Back</source>
        <translation>Indietro</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Avanti</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>Esci dal tour</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Tour</translation>
    </message>
    <message>
        <source>Help &gt; Tour goes on from here</source>
        <translation>Aiuto &gt; Tour riprende da qui</translation>
    </message>
    <message>
        <source>Tour, %1 of %2</source>
        <translation>Tour, %1 di %2</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fine</translation>
    </message>
</context>
<context>
    <name>bolster::TrimTool</name>
    <message>
        <source>Click a seam or an edge of an outline.</source>
        <translation>Fare clic su una cucitura o un lato di un contorno.</translation>
    </message>
    <message>
        <source>Click to stitch this seam; stitches and piping are in the properties</source>
        <translation>Clic per impunturare questa cucitura; impunture e bordino sono nelle proprietà</translation>
    </message>
    <message>
        <source>Click to stitch this edge; stitches and piping are in the properties</source>
        <translation>Clic per impunturare questo lato; impunture e bordino sono nelle proprietà</translation>
    </message>
    <message>
        <source>Click a seam or an edge of an outline to stitch it – Esc ends the tool</source>
        <translation>Fare clic su una cucitura o un lato di un contorno per impunturarlo – Esc chiude lo strumento</translation>
    </message>
</context>
<context>
    <name>bolster::VersionPane</name>
    <message>
        <source>Computing the cover …</source>
        <translation>Calcolo del rivestimento…</translation>
    </message>
    <message>
        <source>Pattern of %1</source>
        <translation>Cartamodello di %1</translation>
    </message>
    <message>
        <source>Cover of %1</source>
        <translation>Rivestimento di %1</translation>
    </message>
</context>
<context>
    <name>bolster::ViewCube</name>
    <message>
        <source>FRONT</source>
        <translation>DAVANTI</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>DIETRO</translation>
    </message>
    <message>
        <source>LEFT</source>
        <translation>SINISTRA</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <translation>DESTRA</translation>
    </message>
    <message>
        <source>TOP</source>
        <translation>SOPRA</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <translation>SOTTO</translation>
    </message>
    <message>
        <source>Click a face, an edge or a corner to look from there; drag to turn</source>
        <translation>Fare clic su una faccia, uno spigolo o un angolo per guardare da lì; trascinare per ruotare</translation>
    </message>
</context>
</TS>
