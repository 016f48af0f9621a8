<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>AreaBrushTool</name>
    <message>
        <source>Drag over the cover to paint the area; with Shift held down to take away. + and − change the brush. Esc ends.</source>
        <translation>Arrastre sobre la funda para pintar la zona; con Mayús pulsada, para quitar. + y − cambian el pincel. Esc termina.</translation>
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
        <translation>«%1» ya existe. ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>AttachTool</name>
    <message>
        <source>Click an edge of an outline.</source>
        <translation>Haga clic en un borde de un contorno.</translation>
    </message>
    <message>
        <source>Select a fixation curve first, in the 3D view or in the list.</source>
        <translation>Seleccione antes una curva de fijación, en la vista 3D o en la lista.</translation>
    </message>
    <message>
        <source>Several stretches go with one curve, or one stretch with several curves.</source>
        <translation>Varios tramos van con una curva, o un tramo con varias curvas.</translation>
    </message>
    <message>
        <source>The stretches overlap each other, or are attached like this already.</source>
        <translation>Los tramos se solapan o ya están fijados así.</translation>
    </message>
    <message>
        <source>This stretch is attached like this already.</source>
        <translation>Este tramo ya está fijado así.</translation>
    </message>
    <message>
        <source>Select a fixation curve in the 3D view or in the list, then click an edge of an outline – Esc ends the tool</source>
        <translation>Seleccione una curva de fijación en la vista 3D o en la lista y haga clic en un borde de un contorno — Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>%1 curves</source>
        <translation>%1 curvas</translation>
    </message>
    <message>
        <source>Click to fix this stretch of %1 to %2 – Shift+click collects several</source>
        <translation>Clic para fijar este tramo de %1 a %2 — Mayús+clic reúne varios</translation>
    </message>
    <message>
        <source>Click the last edge, or Enter attaches %1 stretches to %2 – Backspace takes one back</source>
        <translation>Clic en el último borde, o Intro fija %1 tramos a %2 — Retroceso quita uno</translation>
    </message>
    <message>
        <source>Click an edge of an outline to fix it to %1 – Enter takes the selected stretch, Esc ends the tool</source>
        <translation>Haga clic en un borde de un contorno para fijarlo a %1 — Intro toma el tramo seleccionado, Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>&amp;Attach what is marked</source>
        <translation>&amp;Fijar lo marcado</translation>
    </message>
    <message>
        <source>&amp;Take back the last edge</source>
        <translation>&amp;Quitar el último borde</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>&amp;Descartar</translation>
    </message>
</context>
<context>
    <name>BackgroundMoveTool</name>
    <message>
        <source>There is no background picture yet.</source>
        <translation>Aún no hay imagen de fondo.</translation>
    </message>
    <message>
        <source>Drag the picture to its place – Enter or Esc ends the tool</source>
        <translation>Arrastre la imagen a su sitio — Intro o Esc sale de la herramienta</translation>
    </message>
</context>
<context>
    <name>BackgroundPicture</name>
    <message>
        <source>%1 cannot be read as a picture: %2</source>
        <translation>%1 no se puede leer como imagen: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an ordinary file.</source>
        <translation>«%1» no es un archivo normal.</translation>
    </message>
</context>
<context>
    <name>BackgroundScaleTool</name>
    <message>
        <source>There is no background picture yet.</source>
        <translation>Aún no hay imagen de fondo.</translation>
    </message>
    <message>
        <source>Type the true distance of the two points, for example 500 or 20 in.</source>
        <translation>Escriba la distancia real entre los dos puntos, por ejemplo 500 o 20&#xa0;in.</translation>
    </message>
    <message>
        <source>Click the first of two points of the picture whose distance you know – Esc ends the tool</source>
        <translation>Haga clic en el primero de dos puntos de la imagen cuya distancia conozca — Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>Click the second point</source>
        <translation>Haga clic en el segundo punto</translation>
    </message>
    <message>
        <source>Type their true distance, then Enter</source>
        <translation>Escriba su distancia real y pulse Intro</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>ahora %1</translation>
    </message>
</context>
<context>
    <name>BoxShapeTool</name>
    <message>
        <source>&quot;%1&quot; is no size: try 300 x 200</source>
        <translation>«%1» no es un tamaño: pruebe 300 x 200</translation>
    </message>
    <message>
        <source>Enter makes it as wide and high as typed, for example 300 x 200</source>
        <translation>Intro le da el ancho y el alto escritos, por ejemplo 300 x 200</translation>
    </message>
    <message>
        <source>Drag a rectangle, or click two opposite corners – Esc ends the tool</source>
        <translation>Arrastre un rectángulo o haga clic en dos esquinas opuestas — Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>Drag an ellipse, or click two opposite corners of its box – Esc ends the tool</source>
        <translation>Arrastre una elipse o haga clic en dos esquinas opuestas de su marco — Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>Click the opposite corner, or type width x height – Shift makes both equal, Ctrl does not snap</source>
        <translation>Haga clic en la esquina opuesta o escriba ancho x alto — Mayús iguala ambos, Ctrl: sin ajuste</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>There was no room where you clicked: the patch lies beside the others.</source>
        <translation>No había sitio donde hizo clic: la pieza está junto a las demás.</translation>
    </message>
    <message>
        <source>The new patch lies on %1: drag it away, or let all be arranged (Pattern &gt; Arrange).</source>
        <translation>La pieza nueva está encima de %1: apártela o deje que se ordenen todas (Patrón &gt; Ordenar).</translation>
    </message>
    <message>
        <source>lies on %1</source>
        <translation>está encima de %1</translation>
    </message>
</context>
<context>
    <name>ColourwayForm</name>
    <message>
        <source>Fabrics</source>
        <translation>Telas</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>those of the patches</source>
        <translation>las de las piezas</translation>
    </message>
</context>
<context>
    <name>ContextMenus</name>
    <message>
        <source>&amp;Show</source>
        <translation>Mo&amp;strar</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>Mirar &amp;desde</translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Mapa</translation>
    </message>
    <message>
        <source>&amp;Continuity</source>
        <translation>&amp;Continuidad</translation>
    </message>
    <message>
        <source>&amp;Match</source>
        <translation>&amp;Emparejado</translation>
    </message>
    <message>
        <source>&amp;Arrange</source>
        <translation>&amp;Ordenar</translation>
    </message>
</context>
<context>
    <name>CoverAtRest</name>
    <message>
        <source>As soon as the cover has come to rest …</source>
        <translation>En cuanto la funda esté en reposo…</translation>
    </message>
    <message>
        <source>This needs the cover of the present design: let the solver go on first (Pause).</source>
        <translation>Esto necesita la funda del diseño actual: deje antes seguir el cálculo (Pausa).</translation>
    </message>
</context>
<context>
    <name>CoverMeasureTool</name>
    <message>
        <source>There is no cover here: click on the cover.</source>
        <translation>Aquí no hay funda: haga clic en la funda.</translation>
    </message>
    <message>
        <source>&amp;Keep the measurement</source>
        <translation>&amp;Conservar la medida</translation>
    </message>
    <message>
        <source>%1 – Enter keeps the measurement, a click begins anew</source>
        <translation>%1 – Intro conserva la medida, un clic empieza de nuevo</translation>
    </message>
    <message>
        <source>Click the second point on the cover – Esc gives it up</source>
        <translation>Haga clic en el segundo punto de la funda – Esc lo abandona</translation>
    </message>
    <message>
        <source>Click two points of the cover or of the pattern to measure – Esc ends the tool</source>
        <translation>Haga clic en dos puntos de la funda o del patrón para medir – Esc sale de la herramienta</translation>
    </message>
</context>
<context>
    <name>CoverSelectTool</name>
    <message>
        <source>There is a control point already.</source>
        <translation>Aquí ya hay un punto de control.</translation>
    </message>
    <message>
        <source>Drag to move the control point – Shift+click selects several, Del removes</source>
        <translation>Arrastre para mover el punto de control — Mayús+clic selecciona varios, Supr elimina</translation>
    </message>
    <message>
        <source>Click to select the seam</source>
        <translation>Clic para seleccionar la costura</translation>
    </message>
    <message>
        <source>Click to select the patch, drag to turn the view</source>
        <translation>Clic para seleccionar la pieza, arrastrar para girar la vista</translation>
    </message>
    <message>
        <source>Click to select the curve, double click to add a control point here</source>
        <translation>Clic para seleccionar la curva, doble clic para añadir aquí un punto de control</translation>
    </message>
    <message>
        <source>Click to select what stands here, drag to turn the view</source>
        <translation>Clic para seleccionar lo que hay aquí, arrastrar para girar la vista</translation>
    </message>
    <message>
        <source>Click to select, drag to turn – %1 pans, %2 zooms</source>
        <translation>Clic para seleccionar, arrastrar para girar — %1 desplaza, %2 amplía</translation>
    </message>
    <message>
        <source>Click to select the measurement, Delete removes it</source>
        <translation>Clic para seleccionar la medida, Supr la elimina</translation>
    </message>
</context>
<context>
    <name>CushionForm</name>
    <message>
        <source>Cover of %1</source>
        <translation>Funda de %1</translation>
    </message>
    <message>
        <source>Every cover</source>
        <translation>Todas las fundas</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Empuja</translation>
    </message>
</context>
<context>
    <name>CutCornerForm</name>
    <message>
        <source>Patch</source>
        <translation>Pieza</translation>
    </message>
</context>
<context>
    <name>CutLabelWords</name>
    <message>
        <source>Cut %1</source>
        <translation>Cortar %1</translation>
    </message>
    <message>
        <source>Cut %1 and %1 mirrored</source>
        <translation>Cortar %1 y %1 en espejo</translation>
    </message>
</context>
<context>
    <name>CuttingCommands</name>
    <message>
        <source>Chec&amp;k before cutting</source>
        <translation>&amp;Revisar antes de cortar</translation>
    </message>
</context>
<context>
    <name>DartCommands</name>
    <message>
        <source>Remove da&amp;rt</source>
        <translation>&amp;Eliminar pinza</translation>
    </message>
    <message>
        <source>The edge goes on as if the selected dart had never been cut</source>
        <translation>El borde sigue como si la pinza seleccionada nunca se hubiera cortado</translation>
    </message>
    <message>
        <source>R&amp;otate dart to …</source>
        <translation>&amp;Trasladar pinza a…</translation>
    </message>
    <message>
        <source>Turns the selected dart shut and opens the pattern where you click, by the same angle</source>
        <translation>Cierra la pinza seleccionada y abre el patrón donde haga clic, con el mismo ángulo</translation>
    </message>
</context>
<context>
    <name>DartDrag</name>
    <message>
        <source>Near the dotted line both legs become of one length, or type how deep it is – Shift keeps to it, Ctrl lets go, Esc takes it back</source>
        <translation>Cerca de la línea de puntos ambos lados se igualan; o escriba la profundidad — Mayús la sigue, Ctrl la suelta, Esc lo anula</translation>
    </message>
    <message>
        <source>Drag the dart along the outline, or type how far its middle is from the corner – Esc takes it back</source>
        <translation>Arrastre la pinza por el contorno o escriba a qué distancia de la esquina está su centro — Esc lo anula</translation>
    </message>
</context>
<context>
    <name>DartPicture</name>
    <message>
        <source>Depth %1, legs of one length</source>
        <translation>Profundidad %1, lados iguales</translation>
    </message>
    <message>
        <source>Depth %1</source>
        <translation>Profundidad %1</translation>
    </message>
    <message>
        <source>Mouth %1</source>
        <translation>Abertura %1</translation>
    </message>
</context>
<context>
    <name>DartRotateTool</name>
    <message>
        <source>Select the seam of a dart first – Esc ends the tool</source>
        <translation>Seleccione antes la costura de una pinza — Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>Click the outline where the dart shall open instead – Ctrl does not snap, Esc ends the tool</source>
        <translation>Haga clic en el contorno donde deba abrirse la pinza — Ctrl: sin ajuste, Esc sale de la herramienta</translation>
    </message>
</context>
<context>
    <name>DartTool</name>
    <message>
        <source>There is no room for a mouth of &quot;%1&quot;.</source>
        <translation>No hay sitio para una abertura de «%1».</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no depth: try 60</source>
        <translation>«%1» no es una profundidad: pruebe 60</translation>
    </message>
    <message>
        <source>Click the tip inside the patch, or type how deep it lies – on the dotted line both legs are of one length (Shift keeps to it, Ctrl lets go), Esc takes a click back</source>
        <translation>Haga clic en el vértice dentro de la pieza o escriba su profundidad — en la línea de puntos ambos lados son iguales (Mayús la sigue, Ctrl la suelta), Esc anula un clic</translation>
    </message>
    <message>
        <source>Click where the mouth ends on the same outline, or type how wide it is – Ctrl does not snap, Esc takes the click back</source>
        <translation>Haga clic donde termina la abertura en el mismo contorno o escriba su ancho — Ctrl: sin ajuste, Esc anula el clic</translation>
    </message>
    <message>
        <source>Click an outline where the mouth of the dart begins – Esc ends the tool</source>
        <translation>Haga clic en un contorno donde empieza la abertura de la pinza — Esc sale de la herramienta</translation>
    </message>
</context>
<context>
    <name>DescribedField</name>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
</context>
<context>
    <name>DesignCuttingSection</name>
    <message>
        <source>Cutting</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Seam allowance of all patches</source>
        <translation>Margen de todas las piezas</translation>
    </message>
    <message>
        <source>Depth of notches</source>
        <translation>Profundidad de piquetes</translation>
    </message>
    <message>
        <source>Width of notches</source>
        <translation>Ancho de piquetes</translation>
    </message>
</context>
<context>
    <name>Docks</name>
    <message>
        <source>Pattern</source>
        <translation>Patrón</translation>
    </message>
    <message>
        <source>Cover</source>
        <translation>Funda</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elementos</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propiedades</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemas</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Costuras</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Telas</translation>
    </message>
    <message>
        <source>Worst spots</source>
        <translation>Peores zonas</translation>
    </message>
    <message>
        <source>Check before cutting</source>
        <translation>Revisión antes de cortar</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Tareas</translation>
    </message>
</context>
<context>
    <name>DrawingCommands</name>
    <message>
        <source>&amp;Grid and snapping</source>
        <translation>&amp;Cuadrícula y ajuste</translation>
    </message>
    <message>
        <source>S&amp;napping</source>
        <translation>A&amp;juste</translation>
    </message>
    <message>
        <source>&amp;Rulers</source>
        <translation>&amp;Reglas</translation>
    </message>
    <message>
        <source>Gui&amp;des</source>
        <translation>&amp;Guías</translation>
    </message>
    <message>
        <source>Remove all g&amp;uides</source>
        <translation>Eliminar todas las g&amp;uías</translation>
    </message>
    <message>
        <source>Select with a &amp;loop</source>
        <translation>Seleccionar con un &amp;lazo</translation>
    </message>
    <message>
        <source>&amp;Background picture</source>
        <translation>Imagen de &amp;fondo</translation>
    </message>
    <message>
        <source>&amp;Open picture …</source>
        <translation>&amp;Abrir imagen…</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>&amp;Mostrar</translation>
    </message>
    <message>
        <source>&amp;Scale by two points</source>
        <translation>&amp;Escalar con dos puntos</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>Mo&amp;ver</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>El&amp;iminar</translation>
    </message>
    <message>
        <source>Opacity %1</source>
        <translation>Opacidad %1</translation>
    </message>
    <message>
        <source>Open a picture to trace</source>
        <translation>Abrir una imagen para calcar</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.webp);;All files (*)</source>
        <translation>Imágenes (*.png *.jpg *.jpeg *.bmp *.webp);;Todos los archivos (*)</translation>
    </message>
</context>
<context>
    <name>DrawingKeys</name>
    <message>
        <source>&amp;Finish</source>
        <translation>&amp;Terminar</translation>
    </message>
    <message>
        <source>&amp;Take back the last point</source>
        <translation>&amp;Quitar el último punto</translation>
    </message>
    <message>
        <source>Switch between &amp;straight and smooth</source>
        <translation>Cambiar entre &amp;recto y suave</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>&amp;Descartar</translation>
    </message>
</context>
<context>
    <name>DrillHoleForm</name>
    <message>
        <source>Patch</source>
        <translation>Pieza</translation>
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
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Name this &amp;branch …</source>
        <translation>Nombrar esta ra&amp;ma…</translation>
    </message>
    <message>
        <source>Name the way that the history has gone since it forked</source>
        <translation>Da nombre al camino que ha seguido el historial desde que se bifurcó</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Cambiar &amp;nombre</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>E&amp;liminar</translation>
    </message>
    <message>
        <source>Select &amp;all patches</source>
        <translation>Seleccionar &amp;todas las piezas</translation>
    </message>
    <message>
        <source>Select n&amp;othing</source>
        <translation>No &amp;seleccionar nada</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Deshacer: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rehacer: %1</translation>
    </message>
</context>
<context>
    <name>ElementText</name>
    <message>
        <source>missing element %1</source>
        <translation>falta el elemento %1</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>Pieza</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>Piezas</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Costura</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Costuras</translation>
    </message>
    <message>
        <source>Fixation curve</source>
        <translation>Curva de fijación</translation>
    </message>
    <message>
        <source>Fixation curves</source>
        <translation>Curvas de fijación</translation>
    </message>
    <message>
        <source>Fixation</source>
        <translation>Fijación</translation>
    </message>
    <message>
        <source>Fixations</source>
        <translation>Fijaciones</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Armazón</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Armazones</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Tela</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Telas</translation>
    </message>
    <message>
        <source>Unusable element</source>
        <translation>Elemento inservible</translation>
    </message>
    <message>
        <source>Unusable elements</source>
        <translation>Elementos inservibles</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Diseño</translation>
    </message>
    <message>
        <source>%1 and %2, ease %3</source>
        <translation>%1 y %2, embebido %3</translation>
    </message>
    <message>
        <source>%1, normal held</source>
        <translation>%1, normal fijada</translation>
    </message>
    <message>
        <source>Handle curve</source>
        <translation>Curva de tirador</translation>
    </message>
    <message>
        <source>Handle curves</source>
        <translation>Curvas de tirador</translation>
    </message>
    <message>
        <source>Fancy seam</source>
        <translation>Costura decorativa</translation>
    </message>
    <message>
        <source>Fancy seams</source>
        <translation>Costuras decorativas</translation>
    </message>
    <message>
        <source>Cushion</source>
        <translation>Acolchado</translation>
    </message>
    <message>
        <source>Cushions</source>
        <translation>Acolchados</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>Espuma</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Escaneo</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Escaneos</translation>
    </message>
    <message>
        <source>%1 patches</source>
        <translation>%1 piezas</translation>
    </message>
    <message>
        <source>%1 seams</source>
        <translation>%1 costuras</translation>
    </message>
    <message>
        <source>%1 fixation curves</source>
        <translation>%1 curvas de fijación</translation>
    </message>
    <message>
        <source>%1 fixations</source>
        <translation>%1 fijaciones</translation>
    </message>
    <message>
        <source>%1 handle curves</source>
        <translation>%1 curvas de tirador</translation>
    </message>
    <message>
        <source>%1 fancy seams</source>
        <translation>%1 costuras decorativas</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 armazones</translation>
    </message>
    <message>
        <source>%1 cushions</source>
        <translation>%1 acolchados</translation>
    </message>
    <message>
        <source>%1 pieces of foam</source>
        <translation>%1 cuerpos de espuma</translation>
    </message>
    <message>
        <source>%1 scans</source>
        <translation>%1 escaneos</translation>
    </message>
    <message>
        <source>%1 fabrics</source>
        <translation>%1 telas</translation>
    </message>
    <message>
        <source>%1 unusable elements</source>
        <translation>%1 elementos inservibles</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 elementos</translation>
    </message>
    <message>
        <source>Trimmed edge</source>
        <translation>Borde con adorno</translation>
    </message>
    <message>
        <source>Trimmed edges</source>
        <translation>Bordes con adorno</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>Variante de color</translation>
    </message>
    <message>
        <source>Colourways</source>
        <translation>Variantes de color</translation>
    </message>
    <message>
        <source>%1 trimmed edges</source>
        <translation>%1 bordes con adorno</translation>
    </message>
    <message>
        <source>%1 colourways</source>
        <translation>%1 variantes de color</translation>
    </message>
    <message>
        <source>Edge of %1</source>
        <translation>Borde de %1</translation>
    </message>
    <message>
        <source>Allowance of an edge</source>
        <translation>Margen de un borde</translation>
    </message>
    <message>
        <source>Allowances of edges</source>
        <translation>Márgenes de bordes</translation>
    </message>
    <message>
        <source>%1 allowances of edges</source>
        <translation>%1 márgenes de bordes</translation>
    </message>
    <message>
        <source>Corner of the cut line</source>
        <translation>Esquina de la línea de corte</translation>
    </message>
    <message>
        <source>Corners of the cut line</source>
        <translation>Esquinas de la línea de corte</translation>
    </message>
    <message>
        <source>%1 corners of the cut line</source>
        <translation>%1 esquinas de la línea de corte</translation>
    </message>
    <message>
        <source>Drill hole</source>
        <translation>Taladro</translation>
    </message>
    <message>
        <source>Drill holes</source>
        <translation>Taladros</translation>
    </message>
    <message>
        <source>%1 drill holes</source>
        <translation>%1 taladros</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>Piquete</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Piquetes</translation>
    </message>
    <message>
        <source>%1 notches</source>
        <translation>%1 piquetes</translation>
    </message>
    <message>
        <source>Internal line</source>
        <translation>Línea interior</translation>
    </message>
    <message>
        <source>Internal lines</source>
        <translation>Líneas interiores</translation>
    </message>
    <message>
        <source>%1 internal lines</source>
        <translation>%1 líneas interiores</translation>
    </message>
    <message>
        <source>%1, allowance %2</source>
        <translation>%1, margen %2</translation>
    </message>
    <message>
        <source>Notch of %1</source>
        <translation>Piquete de %1</translation>
    </message>
    <message>
        <source>Corner of %1</source>
        <translation>Esquina de %1</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Medida</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Medidas</translation>
    </message>
    <message>
        <source>%1 measurements</source>
        <translation>%1 medidas</translation>
    </message>
</context>
<context>
    <name>ElementsModel</name>
    <message>
        <source>edge %1</source>
        <translation>borde %1</translation>
    </message>
    <message>
        <source>%1 from the corner</source>
        <translation>a %1 de la esquina</translation>
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
        <translation>Surcos</translation>
    </message>
    <message>
        <source>Depth of the pile</source>
        <translation>Altura del pelo</translation>
    </message>
    <message>
        <source>Other squares</source>
        <translation>Otros cuadros</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>Squares</source>
        <translation>Cuadros</translation>
    </message>
    <message>
        <source>Grain size</source>
        <translation>Tamaño del grano</translation>
    </message>
    <message>
        <source>Repeat of the weave</source>
        <translation>Rapport del tejido</translation>
    </message>
    <message>
        <source>Nap</source>
        <translation>Pelo</translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation>Ancho de la imagen</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>Comportamiento</translation>
    </message>
    <message>
        <source>The fabric on a cushion and on a ball</source>
        <translation>La tela sobre un cojín y una bola</translation>
    </message>
    <message>
        <source>The fabric on a cushion and on a ball, at its real scale</source>
        <translation>La tela sobre un cojín y una bola, a escala real</translation>
    </message>
    <message>
        <source>Colour of the fabric</source>
        <translation>Color de la tela</translation>
    </message>
    <message>
        <source>Second colour of the fabric</source>
        <translation>Segundo color de la tela</translation>
    </message>
    <message>
        <source>From the first colour</source>
        <translation>A partir del primer color</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Choose an&amp;other picture …</source>
        <translation>Elegir &amp;otra imagen…</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Corte</translation>
    </message>
</context>
<context>
    <name>FabricMenu</name>
    <message>
        <source>&amp;New fabric</source>
        <translation>&amp;Nueva tela</translation>
    </message>
    <message>
        <source>Adds leather, weave, velvet or another fabric to the library of the design</source>
        <translation>Añade piel, tejido, terciopelo u otra tela a la biblioteca del diseño</translation>
    </message>
    <message>
        <source>From a &amp;picture …</source>
        <translation>A partir de una &amp;imagen…</translation>
    </message>
    <message>
        <source>A fabric that looks like a picture: PNG, JPEG, TIFF or OpenEXR</source>
        <translation>Una tela con el aspecto de una imagen: PNG, JPEG, TIFF u OpenEXR</translation>
    </message>
    <message>
        <source>&amp;Assign to selection</source>
        <translation>&amp;Asignar a la selección</translation>
    </message>
    <message>
        <source>Gives the selected patches the fabric that is chosen in the library</source>
        <translation>Da a las piezas seleccionadas la tela elegida en la biblioteca</translation>
    </message>
    <message>
        <source>Fabric p&amp;roperties</source>
        <translation>P&amp;ropiedades de la tela</translation>
    </message>
    <message>
        <source>Shows kind, colours, size and limits of the fabric</source>
        <translation>Muestra tipo, colores, tamaño y límites de la tela</translation>
    </message>
    <message>
        <source>Picture on the &amp;fabric …</source>
        <translation>Imagen en la &amp;tela…</translation>
    </message>
    <message>
        <source>Lets the fabric look like a picture: PNG, JPEG, TIFF or OpenEXR</source>
        <translation>Da a la tela el aspecto de una imagen: PNG, JPEG, TIFF u OpenEXR</translation>
    </message>
    <message>
        <source>D&amp;uplicate fabric</source>
        <translation>&amp;Duplicar tela</translation>
    </message>
    <message>
        <source>Adds a copy of the fabric, to be changed</source>
        <translation>Añade una copia de la tela para modificarla</translation>
    </message>
    <message>
        <source>Rename fa&amp;bric …</source>
        <translation>&amp;Cambiar nombre de tela…</translation>
    </message>
    <message>
        <source>Gives the fabric another name</source>
        <translation>Da otro nombre a la tela</translation>
    </message>
    <message>
        <source>&amp;Delete fabric …</source>
        <translation>&amp;Eliminar tela…</translation>
    </message>
    <message>
        <source>Removes the fabric; asks what patches get instead</source>
        <translation>Elimina la tela; pregunta cuál reciben las piezas en su lugar</translation>
    </message>
    <message>
        <source>&amp;Import fabrics …</source>
        <translation>I&amp;mportar telas…</translation>
    </message>
    <message>
        <source>Takes over the fabrics of a file, a design or a project</source>
        <translation>Toma las telas de un archivo, un diseño o un proyecto</translation>
    </message>
    <message>
        <source>&amp;Export fabric …</source>
        <translation>E&amp;xportar tela…</translation>
    </message>
    <message>
        <source>Writes the fabric to a file, its picture beside it</source>
        <translation>Escribe la tela en un archivo, con su imagen al lado</translation>
    </message>
    <message>
        <source>Pre&amp;views</source>
        <translation>&amp;Vistas previas</translation>
    </message>
    <message>
        <source>On &amp;cushions</source>
        <translation>Sobre &amp;cojines</translation>
    </message>
    <message>
        <source>Shows the fabrics of the library on cushions</source>
        <translation>Muestra las telas de la biblioteca sobre cojines</translation>
    </message>
    <message>
        <source>On &amp;balls</source>
        <translation>Sobre &amp;bolas</translation>
    </message>
    <message>
        <source>Shows the fabrics of the library on balls</source>
        <translation>Muestra las telas de la biblioteca sobre bolas</translation>
    </message>
    <message>
        <source>&amp;Show colourway</source>
        <translation>Mo&amp;strar variante</translation>
    </message>
    <message>
        <source>Chooses which fabrics are seen; the shape stays</source>
        <translation>Elige qué telas se ven; la forma no cambia</translation>
    </message>
    <message>
        <source>New &amp;colourway …</source>
        <translation>Nueva variante de c&amp;olor…</translation>
    </message>
    <message>
        <source>Adds a set of fabrics for the patches; it begins as what is shown now</source>
        <translation>Añade un juego de telas para las piezas; empieza con lo que se ve ahora</translation>
    </message>
    <message>
        <source>Rena&amp;me colourway …</source>
        <translation>Cambiar nom&amp;bre de variante…</translation>
    </message>
    <message>
        <source>Gives the colourway that is shown another name</source>
        <translation>Da otro nombre a la variante de color mostrada</translation>
    </message>
    <message>
        <source>De&amp;lete colourway</source>
        <translation>E&amp;liminar variante</translation>
    </message>
    <message>
        <source>Removes the colourway that is shown</source>
        <translation>Elimina la variante de color mostrada</translation>
    </message>
    <message>
        <source>Compare c&amp;olourways …</source>
        <translation>Com&amp;parar variantes…</translation>
    </message>
    <message>
        <source>Shows two colourways side by side</source>
        <translation>Muestra dos variantes de color una junto a otra</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>Como está hecha</translation>
    </message>
</context>
<context>
    <name>FabricPresets</name>
    <message>
        <source>Leather, cognac</source>
        <translation>Piel, coñac</translation>
    </message>
    <message>
        <source>Leather, black</source>
        <translation>Piel, negro</translation>
    </message>
    <message>
        <source>Leather, cream</source>
        <translation>Piel, crema</translation>
    </message>
    <message>
        <source>Smooth leather, dark brown</source>
        <translation>Piel lisa, marrón oscuro</translation>
    </message>
    <message>
        <source>Smooth leather, red</source>
        <translation>Piel lisa, rojo</translation>
    </message>
    <message>
        <source>Weave, grey</source>
        <translation>Tejido, gris</translation>
    </message>
    <message>
        <source>Weave, blue</source>
        <translation>Tejido, azul</translation>
    </message>
    <message>
        <source>Weave, sand</source>
        <translation>Tejido, arena</translation>
    </message>
    <message>
        <source>Velvet, green</source>
        <translation>Terciopelo, verde</translation>
    </message>
    <message>
        <source>Velvet, petrol</source>
        <translation>Terciopelo, petróleo</translation>
    </message>
    <message>
        <source>Checker, 20 mm</source>
        <translation>Damero, 20&#xa0;mm</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Liso</translation>
    </message>
</context>
<context>
    <name>FancySeamForm</name>
    <message>
        <source>Patch</source>
        <translation>Pieza</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>It stands out: a welt.</source>
        <translation>Sobresale: un resalte.</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>Patch</source>
        <translation>Pieza</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Tela</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Telas</translation>
    </message>
    <message>
        <source>Press harder</source>
        <translation>Empujan más</translation>
    </message>
    <message>
        <source>Press like straight ones</source>
        <translation>Empujan como las rectas</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Armazón</translation>
    </message>
    <message>
        <source>Padded parts</source>
        <translation>Partes acolchadas</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Empuja</translation>
    </message>
    <message>
        <source>Smallest detail</source>
        <translation>Detalle mínimo</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>Acolchado</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Fuerza</translation>
    </message>
    <message>
        <source>Slanted faces</source>
        <translation>Caras inclinadas</translation>
    </message>
    <message>
        <source>Pushes the cover</source>
        <translation>Empuja la funda</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Liso</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>Damero</translation>
    </message>
    <message>
        <source>Smooth leather</source>
        <translation>Piel lisa</translation>
    </message>
    <message>
        <source>Grained leather</source>
        <translation>Piel con grano</translation>
    </message>
    <message>
        <source>Woven</source>
        <translation>Tejido</translation>
    </message>
    <message>
        <source>Velvet</source>
        <translation>Terciopelo</translation>
    </message>
    <message>
        <source>Picture …</source>
        <translation>Imagen…</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Second colour</source>
        <translation>Segundo color</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rugosidad</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>Turned from the grain</source>
        <translation>Giro respecto al hilo</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>Relieve</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Most along the grain</source>
        <translation>Máximo al hilo</translation>
    </message>
    <message>
        <source>Most across</source>
        <translation>Máximo a contrahilo</translation>
    </message>
    <message>
        <source>Most shear</source>
        <translation>Cizalladura máxima</translation>
    </message>
    <message>
        <source>Poisson</source>
        <translation>Coef. de Poisson</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidez</translation>
    </message>
    <message>
        <source>Bending length</source>
        <translation>Longitud de flexión</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aspecto</translation>
    </message>
    <message>
        <source>Strain limits</source>
        <translation>Límites de deformación</translation>
    </message>
    <message>
        <source>Mirror twin</source>
        <translation>Gemelo simétrico</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>On the curve</source>
        <translation>Sobre la curva</translation>
    </message>
    <message>
        <source>Curve runs backwards</source>
        <translation>Curva en sentido inverso</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Peso</translation>
    </message>
    <message>
        <source>Curve in space</source>
        <translation>Curva en el espacio</translation>
    </message>
    <message>
        <source>Round – a soft groove</source>
        <translation>Redondo — un surco suave</translation>
    </message>
    <message>
        <source>Sharp – a crease</source>
        <translation>Marcado — un doblez</translation>
    </message>
    <message>
        <source>Welt – between creases</source>
        <translation>Resalte — entre dobleces</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidad</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Perfil</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotación</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Sentido del hilo</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Presión</translation>
    </message>
    <message>
        <source>Wrong side out</source>
        <translation>Revés hacia fuera</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Madera</translation>
    </message>
    <message>
        <source>Metal</source>
        <translation>Metal</translation>
    </message>
    <message>
        <source>Plastic</source>
        <translation>Plástico</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>Espuma</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Keeps the cover outside</source>
        <translation>Mantiene la funda fuera</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Separación</translation>
    </message>
    <message>
        <source>Hidden parts</source>
        <translation>Partes ocultas</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Caja</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Cilindro</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Esfera</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Malla</translation>
    </message>
    <message>
        <source>Cushion</source>
        <translation>Acolchado</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Recortado</translation>
    </message>
    <message>
        <source>Along the normal</source>
        <translation>A lo largo de la normal</translation>
    </message>
    <message>
        <source>To the point itself</source>
        <translation>Al punto mismo</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Umbral</translation>
    </message>
    <message>
        <source>Fit the cover to it</source>
        <translation>Adaptar la funda a él</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Tracción</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Cortes</translation>
    </message>
    <message>
        <source>C0 – an edge</source>
        <translation>C0 — con arista</translation>
    </message>
    <message>
        <source>C1 – smooth, texture too</source>
        <translation>C1 — suave, textura incluida</translation>
    </message>
    <message>
        <source>G1 – rounded</source>
        <translation>G1 — redondeado</translation>
    </message>
    <message>
        <source>First stretch</source>
        <translation>Primer tramo</translation>
    </message>
    <message>
        <source>Second stretch</source>
        <translation>Segundo tramo</translation>
    </message>
    <message>
        <source>Second side runs backwards</source>
        <translation>Segundo lado en sentido inverso</translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation>Continuidad</translation>
    </message>
    <message>
        <source>Mesh edges</source>
        <translation>Aristas de malla</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Simetría</translation>
    </message>
    <message>
        <source>Colourway shown</source>
        <translation>Variante mostrada</translation>
    </message>
    <message>
        <source>Begins at</source>
        <translation>Empieza en</translation>
    </message>
    <message>
        <source>Ends at</source>
        <translation>Termina en</translation>
    </message>
    <message>
        <source>By length</source>
        <translation>Por longitud</translation>
    </message>
    <message>
        <source>By parameter</source>
        <translation>Por parámetro</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Emparejado</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Single row</source>
        <translation>Una fila</translation>
    </message>
    <message>
        <source>Twin rows</source>
        <translation>Dos filas</translation>
    </message>
    <message>
        <source>Stitches</source>
        <translation>Puntadas</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>Hilo</translation>
    </message>
    <message>
        <source>Stitch length</source>
        <translation>Largo de puntada</translation>
    </message>
    <message>
        <source>Distance from the seam</source>
        <translation>Distancia a la costura</translation>
    </message>
    <message>
        <source>Thread width</source>
        <translation>Grosor del hilo</translation>
    </message>
    <message>
        <source>Radius (0: none)</source>
        <translation>Radio (0: ninguno)</translation>
    </message>
    <message>
        <source>Seam allowance</source>
        <translation>Margen de costura</translation>
    </message>
    <message>
        <source>The cover dips into the seam</source>
        <translation>La funda se hunde en la costura</translation>
    </message>
    <message>
        <source>Trim</source>
        <translation>Adorno</translation>
    </message>
    <message>
        <source> mm per unit</source>
        <translation> mm por unidad</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>The frame that is padded</source>
        <translation>El armazón que se acolcha</translation>
    </message>
    <message>
        <source>Which cover the padding presses outwards</source>
        <translation>Qué funda empuja el acolchado hacia fuera</translation>
    </message>
    <message>
        <source>How finely the frame is looked at: what is thinner may stay without padding</source>
        <translation>Con qué finura se mira el armazón: lo más fino puede quedar sin acolchado</translation>
    </message>
    <message>
        <source>How thick the padding around the frame is</source>
        <translation>Grosor del acolchado alrededor del armazón</translation>
    </message>
    <message>
        <source>How hard the padding presses the cover outwards; from about 2 on it gives no more</source>
        <translation>Fuerza con que el acolchado empuja la funda hacia fuera; a partir de 2, más o menos, ya no aumenta</translation>
    </message>
    <message>
        <source>How padding presses that is aslant to width, depth and height: harder fills the cover more</source>
        <translation>Cómo empuja el acolchado oblicuo al ancho, el fondo y el alto: con más fuerza llena más la funda</translation>
    </message>
    <message>
        <source>How thick the padding around this foam is</source>
        <translation>Grosor del acolchado alrededor de esta espuma</translation>
    </message>
    <message>
        <source>How hard this foam presses the cover outwards; from about 2 on it gives no more</source>
        <translation>Fuerza con que esta espuma empuja la funda hacia fuera; a partir de 2, más o menos, ya no aumenta</translation>
    </message>
    <message>
        <source>Takes this shape out of the cushion instead of adding it</source>
        <translation>Quita esta forma del acolchado en lugar de añadirla</translation>
    </message>
    <message>
        <source>as made</source>
        <translation>como está hecha</translation>
    </message>
    <message>
        <source>Stitching</source>
        <translation>Pespunte</translation>
    </message>
    <message>
        <source>Thread colour</source>
        <translation>Color del hilo</translation>
    </message>
    <message>
        <source>Stitch distance</source>
        <translation>Distancia entre puntadas</translation>
    </message>
    <message>
        <source>Piping radius</source>
        <translation>Radio del vivo</translation>
    </message>
    <message>
        <source>Piping fabric</source>
        <translation>Tela del vivo</translation>
    </message>
    <message>
        <source>Valley</source>
        <translation>Hundimiento</translation>
    </message>
    <message>
        <source>Mitred – to a point</source>
        <translation>En inglete — en punta</translation>
    </message>
    <message>
        <source>Square – cut off</source>
        <translation>Recta — cortada</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>Redondeada</translation>
    </message>
    <message>
        <source>Folded – lies under the piece</source>
        <translation>Doblada — queda bajo la pieza</translation>
    </message>
    <message>
        <source>Stepped</source>
        <translation>Escalonada</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Margen</translation>
    </message>
    <message>
        <source>From the sewing line to the line where the fabric is cut.</source>
        <translation>De la línea de costura a la línea por la que se corta la tela.</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Esquinas</translation>
    </message>
    <message>
        <source>Corners of the cut line</source>
        <translation>Esquinas de la línea de corte</translation>
    </message>
    <message>
        <source>as the design&apos;s</source>
        <translation>como en el diseño</translation>
    </message>
    <message>
        <source>Lies at</source>
        <translation>Está en</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Esquina</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diámetro</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Corte</translation>
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
        <translation>Rectángulo</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>Piquete</translation>
    </message>
    <message>
        <source>Depth of notches</source>
        <translation>Profundidad de piquetes</translation>
    </message>
    <message>
        <source>Width of notches</source>
        <translation>Ancho de piquetes</translation>
    </message>
    <message>
        <source>Notches along seams every</source>
        <translation>Piquetes en costuras cada</translation>
    </message>
    <message>
        <source>Notches at ends of seams</source>
        <translation>Piquetes en finales de costura</translation>
    </message>
    <message>
        <source>Notches that tell halves apart</source>
        <translation>Piquetes que distinguen mitades</translation>
    </message>
    <message>
        <source>Two side by side</source>
        <translation>Dos juntos</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Label at</source>
        <translation>Etiqueta en</translation>
    </message>
    <message>
        <source>Label turned by</source>
        <translation>Etiqueta girada</translation>
    </message>
    <message>
        <source>Two ways – either end up</source>
        <translation>Dos sentidos — cualquier extremo arriba</translation>
    </message>
    <message>
        <source>One way – one end up</source>
        <translation>Un sentido — un extremo arriba</translation>
    </message>
    <message>
        <source>Any direction</source>
        <translation>Cualquier dirección</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Cantidad</translation>
    </message>
    <message>
        <source>Mirrored pair</source>
        <translation>Par en espejo</translation>
    </message>
    <message>
        <source>Nap</source>
        <translation>Sentido del pelo</translation>
    </message>
    <message>
        <source>Grain may be off by</source>
        <translation>El hilo puede desviarse</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Etiqueta</translation>
    </message>
    <message>
        <source>where it finds room</source>
        <translation>donde haya sitio</translation>
    </message>
    <message>
        <source>Usable width</source>
        <translation>Ancho útil</translation>
    </message>
    <message>
        <source>Shrinks along</source>
        <translation>Encoge al hilo</translation>
    </message>
    <message>
        <source>Pieces are cut so much larger along the grain that they have their size when the fabric has shrunk.</source>
        <translation>Las piezas se cortan al hilo tanto más grandes que tengan su medida cuando la tela haya encogido.</translation>
    </message>
    <message>
        <source>Shrinks across</source>
        <translation>Encoge a contrahilo</translation>
    </message>
    <message>
        <source>10 mm</source>
        <translation>10&#xa0;mm</translation>
    </message>
    <message>
        <source>Automatic notches</source>
        <translation>Piquetes automáticos</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Versión</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Dibujado</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cortado</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Omitido</translation>
    </message>
    <message>
        <source>On the cutting table</source>
        <translation>En la mesa de corte</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guía</translation>
    </message>
    <message>
        <source>Top stitching</source>
        <translation>Pespunte visto</translation>
    </message>
    <message>
        <source>Tie-down strip</source>
        <translation>Tira de anclaje</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Doblez</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>Finalidad</translation>
    </message>
    <message>
        <source>Ease wanted</source>
        <translation>Embebido deseado</translation>
    </message>
    <message>
        <source>How much longer the second side shall be than the first one: it is gathered when it is sewn.</source>
        <translation>Cuánto más largo debe ser el segundo lado que el primero: se embebe al coser.</translation>
    </message>
    <message>
        <source>Bulge of the allowance</source>
        <translation>Bulto del margen</translation>
    </message>
    <message>
        <source>With a zip</source>
        <translation>Con cremallera</translation>
    </message>
    <message>
        <source>A zip joins the two sides; the sewing sheet tells its length.</source>
        <translation>Una cremallera une los dos lados; la ficha de confección indica su longitud.</translation>
    </message>
    <message>
        <source>Step in sewing</source>
        <translation>Paso de costura</translation>
    </message>
    <message>
        <source>Seams with a number are sewn first, smaller ones before larger ones. 0: as the program proposes it.</source>
        <translation>Las costuras con número se cosen primero, las de número menor antes que las de mayor. 0: como propone el programa.</translation>
    </message>
    <message>
        <source>How near a point of the scan must be to pull at the cover. What the scan has not seen stays as the pattern makes it.</source>
        <translation>A qué distancia debe estar un punto del escaneo para tirar de la funda. Lo que el escaneo no ha visto queda como lo hace el patrón.</translation>
    </message>
    <message>
        <source>How firmly the scan pulls at the cover, against the pattern: more follows finer detail, and more of the noise.</source>
        <translation>Con qué firmeza tira el escaneo de la funda frente al patrón: más sigue detalles más finos, y más ruido.</translation>
    </message>
    <message>
        <source>The cover is pulled to the scan. Without that it is only measured. Align the scan first.</source>
        <translation>La funda es atraída hacia el escaneo. Sin esto solo se mide. Alinee antes el escaneo.</translation>
    </message>
    <message>
        <source>To its surface: the cover may slide along it. To its points: it may not, which suits scans with few points.</source>
        <translation>A su superficie: la funda puede deslizarse por ella. A sus puntos: no puede, lo que conviene a escaneos con pocos puntos.</translation>
    </message>
    <message>
        <source>For whoever works on the design: it changes neither the cover nor what is cut</source>
        <translation>Para quien trabaje en el diseño: no cambia ni la funda ni lo que se corta</translation>
    </message>
    <message>
        <source>Line on the label</source>
        <translation>Línea en la etiqueta</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>A filling that presses from inside. 0.05 to 0.3 fills a cushion; at 1 most fabrics are stretched too far.</source>
        <translation>Un relleno que presiona desde dentro. De 0,05 a 0,3 llena un cojín; con 1 la mayoría de las telas se estiran demasiado.</translation>
    </message>
    <message>
        <source>How long the edges of the triangles are: shorter ones show smaller folds, and take longer.</source>
        <translation>Qué longitud tienen las aristas de los triángulos: las más cortas muestran pliegues más pequeños y tardan más.</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nuevo</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir &amp;recientes</translation>
    </message>
    <message>
        <source>&amp;Unsaved work</source>
        <translation>&amp;Trabajo sin guardar</translation>
    </message>
    <message>
        <source>Sa&amp;mples</source>
        <translation>E&amp;jemplos</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>Guardar c&amp;omo…</translation>
    </message>
    <message>
        <source>Save a &amp;copy</source>
        <translation>Guardar una &amp;copia</translation>
    </message>
    <message>
        <source>With &amp;everything …</source>
        <translation>Con &amp;todo…</translation>
    </message>
    <message>
        <source>Without &amp;history …</source>
        <translation>Sin &amp;historial…</translation>
    </message>
    <message>
        <source>Without history and &amp;scans …</source>
        <translation>Sin historial ni &amp;escaneos…</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>&amp;Volver a lo guardado</translation>
    </message>
    <message>
        <source>&amp;Import frame …</source>
        <translation>&amp;Importar armazón…</translation>
    </message>
    <message>
        <source>Impor&amp;t scan …</source>
        <translation>I&amp;mportar escaneo…</translation>
    </message>
    <message>
        <source>&amp;Export surface …</source>
        <translation>&amp;Exportar superficie…</translation>
    </message>
    <message>
        <source>Export &amp;picture …</source>
        <translation>Ex&amp;portar imagen…</translation>
    </message>
    <message>
        <source>Ren&amp;der picture …</source>
        <translation>Ren&amp;derizar imagen…</translation>
    </message>
    <message>
        <source>E&amp;xport pattern …</source>
        <translation>E&amp;xportar patrón…</translation>
    </message>
    <message>
        <source>Import pattern (DX&amp;F, SVG) …</source>
        <translation>Importar patrón (DX&amp;F, SVG)…</translation>
    </message>
    <message>
        <source>Export cover (&amp;HTML, glTF, STL) …</source>
        <translation>Exportar funda (&amp;HTML, glTF, STL)…</translation>
    </message>
    <message>
        <source>Export foam &amp;body …</source>
        <translation>Exportar c&amp;uerpo de espuma…</translation>
    </message>
    <message>
        <source>Print view …</source>
        <translation>Imprimir vista…</translation>
    </message>
</context>
<context>
    <name>FileFormats</name>
    <message>
        <source>Page for the customer</source>
        <translation>Página para el cliente</translation>
    </message>
    <message>
        <source>USDZ, for phones</source>
        <translation>USDZ, para teléfonos</translation>
    </message>
    <message>
        <source>OBJ with materials</source>
        <translation>OBJ con materiales</translation>
    </message>
    <message>
        <source>STL, with a thickness</source>
        <translation>STL, con grosor</translation>
    </message>
    <message>
        <source>3MF, with a thickness</source>
        <translation>3MF, con grosor</translation>
    </message>
    <message>
        <source>STEP, curves alone</source>
        <translation>STEP, solo curvas</translation>
    </message>
    <message>
        <source>STEP, of flat faces</source>
        <translation>STEP, de caras planas</translation>
    </message>
</context>
<context>
    <name>FixationCurveForm</name>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
</context>
<context>
    <name>FixationDrawTool</name>
    <message>
        <source>A curve needs two points, a closed one three.</source>
        <translation>Una curva necesita dos puntos; una cerrada, tres.</translation>
    </message>
    <message>
        <source>Fixation %1</source>
        <translation>Fijación %1</translation>
    </message>
    <message>
        <source>Click to close the curve</source>
        <translation>Clic para cerrar la curva</translation>
    </message>
    <message>
        <source>There is neither a frame nor the cover here: click on one, or type x, y, z.</source>
        <translation>Aquí no hay ni armazón ni funda: haga clic en uno de ellos o escriba x, y, z.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no place: try 250, -100, 40</source>
        <translation>«%1» no es un lugar: pruebe 250, -100, 40</translation>
    </message>
    <message>
        <source>Enter sets the point: x, y, z – without z it is as high as the last one</source>
        <translation>Intro pone el punto: x, y, z — sin z queda a la altura del anterior</translation>
    </message>
    <message>
        <source>Click on a frame to begin a fixation curve, or type x, y, z – drag turns the view, Esc ends the tool</source>
        <translation>Haga clic en un armazón para empezar una curva de fijación o escriba x, y, z — arrastrar gira la vista, Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>Click or type the next point, Enter ends, C closes – B makes it straight, Backspace takes a point back</source>
        <translation>Haga clic en el siguiente punto o escríbalo; Intro termina, C cierra — B la hace recta, Retroceso quita un punto</translation>
    </message>
    <message>
        <source>Click or type the next point, Enter ends, C closes – straight from point to point, whatever lies between: B makes it smooth along the surface, Backspace takes a point back</source>
        <translation>Haga clic en el siguiente punto o escríbalo; Intro termina, C cierra — recta de punto a punto, haya lo que haya en medio: B la hace suave por la superficie, Retroceso quita un punto</translation>
    </message>
    <message>
        <source>&amp;Close the curve</source>
        <translation>&amp;Cerrar la curva</translation>
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
        <translation>Sobre la curva</translation>
    </message>
</context>
<context>
    <name>FixationsLeft</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>y %n más</numerusform>
            <numerusform>y %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>They stay where they are. Drag their points onto the frame, or undo the change.</source>
        <translation>Se quedan donde están. Arrastre sus puntos al armazón o deshaga el cambio.</translation>
    </message>
    <message numerus="yes">
        <source>%n fixation curve(s) no longer lie on the frame.</source>
        <translation>
            <numerusform>%n curva de fijación ya no está sobre el armazón.</numerusform>
            <numerusform>%n curvas de fijación ya no están sobre el armazón.</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1”: its edge is up to %2 away</source>
        <translation>«%1»: su borde está a hasta %2</translation>
    </message>
    <message>
        <source>“%1”: up to %2</source>
        <translation>«%1»: hasta %2</translation>
    </message>
    <message>
        <source>“%1”: more than %2</source>
        <translation>«%1»: más de %2</translation>
    </message>
</context>
<context>
    <name>FixingCommands</name>
    <message>
        <source>&amp;Create fixation curve</source>
        <translation>&amp;Crear curva de fijación</translation>
    </message>
    <message>
        <source>Select two points of an outline first: what lies between them is fixed.</source>
        <translation>Seleccione antes dos puntos de un contorno: se fija lo que hay entre ellos.</translation>
    </message>
    <message>
        <source>Fixation %1</source>
        <translation>Fijación %1</translation>
    </message>
    <message>
        <source>There is no surface of this patch yet on which the curve could lie.</source>
        <translation>Esta pieza aún no tiene una superficie sobre la que pueda estar la curva.</translation>
    </message>
</context>
<context>
    <name>FoamForm</name>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
</context>
<context>
    <name>FormPatternReport</name>
    <message numerus="yes">
        <source>(and %n more)</source>
        <translation>
            <numerusform>(y %n más)</numerusform>
            <numerusform>(y %n más)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n pieza</numerusform>
            <numerusform>%n piezas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seams, whose sides are equally long</source>
        <translation>
            <numerusform>%n costura, cuyos lados miden lo mismo</numerusform>
            <numerusform>%n costuras, cuyos lados miden lo mismo</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seams, whose sides differ by %1 at most</source>
        <translation>
            <numerusform>%n costura, cuyos lados difieren %1 como máximo</numerusform>
            <numerusform>%n costuras, cuyos lados difieren %1 como máximo</numerusform>
        </translation>
    </message>
    <message>
        <source>Its cover at rest lies up to %1 beside the form, where nothing holds it: tick &quot;Keeps the cover outside&quot; at the frame, or hold it by a fixation.</source>
        <translation>Su funda en reposo queda hasta %1 al lado de la forma, donde nada la sujeta: marque «Mantiene la funda fuera» en el armazón, o sujétela con una fijación.</translation>
    </message>
    <message>
        <source>Its cover at rest lies up to %1 beside the form, where nothing holds it: hold it by a fixation, or give its pieces pressure.</source>
        <translation>Su funda en reposo queda hasta %1 al lado de la forma, donde nada la sujeta: sujétela con una fijación, o dé presión a sus piezas.</translation>
    </message>
    <message>
        <source>Its cover is being solved …</source>
        <translation>Se calcula su funda …</translation>
    </message>
    <message>
        <source>Its cover does not come to rest.</source>
        <translation>Su funda no llega al reposo.</translation>
    </message>
    <message>
        <source>Its cover at rest is strained no more than the fabric may be.</source>
        <translation>Su funda en reposo no está más estirada de lo que permite la tela.</translation>
    </message>
    <message>
        <source>What counts is its cover at rest: %1</source>
        <translation>Lo que cuenta es su funda en reposo: %1</translation>
    </message>
    <message>
        <source>Laid on the form by itself no piece is strained so much. Narrow tips and steps of a line do that, or mesh edges that are long for them.</source>
        <translation>Puesta por sí sola sobre la forma, ninguna pieza está tan deformada. Eso lo hacen puntas estrechas y escalones de una línea, o aristas de malla largas para ellos.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more are left out, too</source>
        <translation>
            <numerusform>y también se omite %n más</numerusform>
            <numerusform>y también se omiten %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>Laid on the form by itself most strained: %1, %2 (rms), %3 within 99 % of its area, %4 where it is most</source>
        <translation>Puesta por sí sola sobre la forma, la más deformada: %1, %2 (RMS), %3 en el 99 % de su superficie, %4 donde es máximo</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces are strained by more than the fabric may be in more than a hundredth of their area (yellow): divide them, or cut them in there.</source>
        <translation>
            <numerusform>%n pieza se deforma en más de una centésima de su superficie más de lo que admite la tela (amarillo): divídala o córtela allí.</numerusform>
            <numerusform>%n piezas se deforman en más de una centésima de su superficie más de lo que admite la tela (amarillo): divídalas o córtelas allí.</numerusform>
        </translation>
    </message>
    <message>
        <source>Its cover will have about %1 vertices, and is not solved here: with mesh edges of %2 it is.</source>
        <translation>Su funda tendrá unos %1 vértices, y aquí no se calcula: con aristas de malla de %2, sí.</translation>
    </message>
    <message>
        <source>So that the cover does not sink into the frame, tick &quot;Keeps the cover outside&quot; at the frame.</source>
        <translation>Para que la funda no se hunda en el armazón, marque «Mantiene la funda fuera» en el armazón.</translation>
    </message>
    <message>
        <source>With shorter mesh edges smaller pieces are divided, too.</source>
        <translation>Con aristas de malla más cortas también se dividen piezas más pequeñas.</translation>
    </message>
    <message>
        <source>Tick &quot;where it would not lie flat&quot;: that finds where to divide them.</source>
        <translation>Marque «donde no quedaría plana»: así se encuentra por dónde dividirlas.</translation>
    </message>
    <message>
        <source>The form is taken as %1 large. If that is wrong, import the file as a frame.</source>
        <translation>La forma se toma con un tamaño de %1. Si no es correcto, importe el archivo como armazón.</translation>
    </message>
</context>
<context>
    <name>FrameEdgeCommands</name>
    <message>
        <source>Fixation curve along an &amp;edge</source>
        <translation>Curva de fijación en una &amp;arista</translation>
    </message>
    <message>
        <source>Click an edge of a frame: of STEP and IGES the edges of its faces, exactly; of others where their triangles bend</source>
        <translation>Haga clic en una arista de un armazón: en STEP e IGES, las aristas exactas de sus caras; en otros, donde se doblan sus triángulos</translation>
    </message>
    <message>
        <source>Looking for the edges of the frames …</source>
        <translation>Buscando las aristas de los armazones…</translation>
    </message>
    <message>
        <source>The frames have no edges: they are smooth everywhere, or are not read yet.</source>
        <translation>Los armazones no tienen aristas: son suaves en todas partes o aún no se han leído.</translation>
    </message>
</context>
<context>
    <name>FrameEdgeTool</name>
    <message>
        <source>Fixation %1</source>
        <translation>Fijación %1</translation>
    </message>
    <message>
        <source>Click an edge of a frame to make a fixation curve of it – drag turns the view, Esc ends the tool</source>
        <translation>Haga clic en una arista de un armazón para hacer de ella una curva de fijación — arrastrar gira la vista, Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>Click to make a fixation curve of this edge – Ctrl takes it alone, without those in which it goes on smoothly</source>
        <translation>Clic para hacer de esta arista una curva de fijación — Ctrl la toma sola, sin aquellas en las que continúa suavemente</translation>
    </message>
    <message>
        <source>There is no edge of a frame here. A curve of your own: Frame &gt; Draw fixation curve.</source>
        <translation>Aquí no hay ninguna arista de un armazón. Una curva propia: Armazón &gt; Dibujar curva de fijación.</translation>
    </message>
</context>
<context>
    <name>FrameForm</name>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Choose an&amp;other file …</source>
        <translation>Elegir &amp;otro archivo…</translation>
    </message>
    <message>
        <source>Colour of the frame</source>
        <translation>Color del armazón</translation>
    </message>
</context>
<context>
    <name>FrameParts</name>
    <message>
        <source>Mesh</source>
        <translation>Malla</translation>
    </message>
    <message>
        <source>Piece %1: %2</source>
        <translation>Trozo %1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n piece(s)</source>
        <translation>
            <numerusform>%1: %n trozo</numerusform>
            <numerusform>%1: %n trozos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Partes</translation>
    </message>
    <message>
        <source>Show a&amp;ll parts</source>
        <translation>Mostrar &amp;todas las partes</translation>
    </message>
    <message>
        <source>Parts without a mark are left out: they are not drawn, and neither drawing along the frame nor cushioning nor contact knows them.</source>
        <translation>Las partes sin marca se omiten: no se dibujan, ni las tienen en cuenta el dibujo sobre el armazón, el acolchado o el contacto.</translation>
    </message>
    <message>
        <source>%1: not in this frame</source>
        <translation>%1: no está en este armazón</translation>
    </message>
    <message>
        <source>Padded parts</source>
        <translation>Partes acolchadas</translation>
    </message>
    <message>
        <source>Without a mark, those parts are padded that the cover is fixed to.</source>
        <translation>Sin marcas, se acolchan las partes a las que está fijada la funda.</translation>
    </message>
    <message>
        <source>This frame is large: the smallest detail can be %1 here.</source>
        <translation>Este armazón es grande: el detalle mínimo puede ser aquí %1.</translation>
    </message>
</context>
<context>
    <name>HandleCurveForm</name>
    <message>
        <source>Patch</source>
        <translation>Pieza</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>En el patrón</translation>
    </message>
    <message>
        <source>In space</source>
        <translation>En el espacio</translation>
    </message>
    <message>
        <source>free</source>
        <translation>libre</translation>
    </message>
</context>
<context>
    <name>HelpCommands</name>
    <message>
        <source>&amp;Find a command …</source>
        <translation>&amp;Buscar un comando…</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse …</source>
        <translation>&amp;Teclado y ratón…</translation>
    </message>
    <message>
        <source>&amp;Edit shortcuts …</source>
        <translation>&amp;Editar atajos…</translation>
    </message>
    <message>
        <source>&amp;About Bolster</source>
        <translation>&amp;Acerca de Bolster</translation>
    </message>
</context>
<context>
    <name>HelpDialogs</name>
    <message>
        <source>Select</source>
        <translation>Seleccionar</translation>
    </message>
    <message>
        <source>click; Shift+click adds; drag a box</source>
        <translation>clic; Mayús+clic añade; arrastrar un marco</translation>
    </message>
    <message>
        <source>Move control points or patches</source>
        <translation>Mover puntos de control o piezas</translation>
    </message>
    <message>
        <source>drag; Shift keeps to one axis; Esc takes it back</source>
        <translation>arrastrar; Mayús fija un eje; Esc lo anula</translation>
    </message>
    <message>
        <source>Turn patches</source>
        <translation>Girar piezas</translation>
    </message>
    <message>
        <source>drag the round handle; Shift in steps of 15°</source>
        <translation>arrastrar el tirador redondo; Mayús en pasos de 15°</translation>
    </message>
    <message>
        <source>Add a control point</source>
        <translation>Añadir un punto de control</translation>
    </message>
    <message>
        <source>arrow keys, Shift+arrow keys</source>
        <translation>teclas de flecha, Mayús+teclas de flecha</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Desplazar la vista</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Girar la vista</translation>
    </message>
    <message>
        <source>A workbench for people who design upholstered furniture and car seats: a sewing pattern, its seams and its fixation on the frame become the cover, live.</source>
        <translation>Un banco de trabajo para quienes diseñan muebles tapizados y asientos de coche: el patrón, sus costuras y su fijación al armazón se convierten en la funda, en vivo.</translation>
    </message>
    <message>
        <source>The surface is computed after the published method of sewing patterns on static constraints; docs/solver.md names the paper and what is different.</source>
        <translation>La superficie se calcula según el método publicado de patrones de costura con restricciones estáticas; docs/solver.md cita el artículo e indica las diferencias.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. It comes without any warranty. Built with Qt, Eigen, CGAL, SuiteSparse, Embree and OpenImageIO.</source>
        <translation>Software libre bajo la Licencia Pública General de GNU, versión 3 o posterior. Sin garantía alguna. Hecho con Qt, Eigen, CGAL, SuiteSparse, Embree y OpenImageIO.</translation>
    </message>
    <message>
        <source>About Bolster</source>
        <translation>Acerca de Bolster</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>En el patrón</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>En la vista 3D</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Teclado y ratón</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1&#xa0;ms</translation>
    </message>
    <message>
        <source>Patches, seams</source>
        <translation>Piezas, costuras</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Vertices after sewing</source>
        <translation>Vértices tras coser</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triángulos</translation>
    </message>
    <message>
        <source>Vertices held by fixations</source>
        <translation>Vértices con fijación</translation>
    </message>
    <message>
        <source>Sewn pairs</source>
        <translation>Pares cosidos</translation>
    </message>
    <message>
        <source>Largest gap at seams</source>
        <translation>Mayor separación en costuras</translation>
    </message>
    <message>
        <source>Largest distance from fixations</source>
        <translation>Mayor distancia a las fijaciones</translation>
    </message>
    <message>
        <source>Curves to fixed outlines between vertices</source>
        <translation>De curvas a contornos fijados, entre vértices</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>Area of the cover, of the pattern</source>
        <translation>Área de la funda, del patrón</translation>
    </message>
    <message>
        <source>Turned triangles</source>
        <translation>Triángulos volteados</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iteraciones</translation>
    </message>
    <message>
        <source>Triangulation</source>
        <translation>Triangulación</translation>
    </message>
    <message>
        <source>Assembly and factorisation</source>
        <translation>Ensamblaje y factorización</translation>
    </message>
    <message>
        <source>One iteration</source>
        <translation>Una iteración</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Malla</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>Computation</source>
        <translation>Cálculo</translation>
    </message>
    <message>
        <source>Figures of the surface</source>
        <translation>Datos de la superficie</translation>
    </message>
    <message>
        <source>Strain: root mean square, 99 %, largest</source>
        <translation>Deformación: media cuadrática, 99&#xa0;%, máxima</translation>
    </message>
    <message>
        <source>double click on an outline or curve</source>
        <translation>doble clic en un contorno o una curva</translation>
    </message>
    <message>
        <source>Draw a handle curve or a fancy seam</source>
        <translation>Dibujar una curva de tirador o una costura decorativa</translation>
    </message>
    <message>
        <source>click points; Enter or double click ends; click the first one to close; B: straight or smooth</source>
        <translation>clic en puntos; Intro o doble clic termina; clic en el primero cierra; B: recto o suave</translation>
    </message>
    <message>
        <source>Move control points of curves</source>
        <translation>Mover puntos de control de curvas</translation>
    </message>
    <message>
        <source>Sew</source>
        <translation>Coser</translation>
    </message>
    <message>
        <source>click two edges; drag or Shift+click takes a part of one; Ctrl+click several in a row, Enter sews them; F: flip</source>
        <translation>clic en dos bordes; arrastrar o Mayús+clic toma una parte; Ctrl+clic varios en fila, Intro los cose; F: invertir</translation>
    </message>
    <message>
        <source>Attach to the selected fixation curve</source>
        <translation>Fijar a la curva de fijación seleccionada</translation>
    </message>
    <message>
        <source>Draw an outline</source>
        <translation>Dibujar un contorno</translation>
    </message>
    <message>
        <source>click corners, drag smooth points, or type 500, 500&lt;30 or 120, 40; Enter or a click on the first point closes</source>
        <translation>clic en esquinas, arrastrar puntos suaves, o escribir 500, 500&lt;30 o 120, 40; Intro o clic en el primer punto cierra</translation>
    </message>
    <message>
        <source>Not snapped</source>
        <translation>Sin ajuste</translation>
    </message>
    <message>
        <source>hold Ctrl or Alt</source>
        <translation>mantener Ctrl o Alt</translation>
    </message>
    <message>
        <source>Select in a loop</source>
        <translation>Seleccionar con un lazo</translation>
    </message>
    <message>
        <source>Alt and drag</source>
        <translation>Alt y arrastrar</translation>
    </message>
    <message>
        <source>Next patch or control point, previous one</source>
        <translation>Pieza o punto de control siguiente, anterior</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Mayús+Tab</translation>
    </message>
    <message>
        <source>drag; those on a frame stay on it: Ctrl lifts them off, S lets go; X, Y, Z keep to an axis</source>
        <translation>arrastrar; los que están en un armazón siguen en él: Ctrl los separa, S los suelta; X, Y, Z fijan un eje</translation>
    </message>
    <message>
        <source>Draw a fixation curve</source>
        <translation>Dibujar una curva de fijación</translation>
    </message>
    <message>
        <source>click points on a frame; Enter or double click ends; click the first one to close</source>
        <translation>clic en puntos de un armazón; Intro o doble clic termina; clic en el primero cierra</translation>
    </message>
    <message>
        <source>Move the ends of a seam or fixation</source>
        <translation>Mover los extremos de una costura o fijación</translation>
    </message>
    <message>
        <source>select it and drag the round handles at its ends</source>
        <translation>seleccionarla y arrastrar los tiradores redondos de sus extremos</translation>
    </message>
    <message>
        <source>Stitch or pipe a seam or an edge</source>
        <translation>Pespuntear una costura o un borde, o ponerle vivo</translation>
    </message>
    <message>
        <source>click it; stitches and piping are in the properties</source>
        <translation>clic; las puntadas y el vivo están en las propiedades</translation>
    </message>
    <message>
        <source>Select an edge</source>
        <translation>Seleccionar un borde</translation>
    </message>
    <message>
        <source>click the outline; drag it then to move it; L types its length</source>
        <translation>clic en el contorno; luego arrastrar lo mueve; L permite escribir su longitud</translation>
    </message>
    <message>
        <source>Commands for what lies there</source>
        <translation>Comandos para lo que hay allí</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>botón derecho</translation>
    </message>
    <message>
        <source>A number instead of a drag</source>
        <translation>Un número en lugar de arrastrar</translation>
    </message>
    <message>
        <source>type it while dragging: 50, 30, 20, for sizes 300 x 200 or 120 %; Enter lets go</source>
        <translation>escribirlo al arrastrar: 50, 30, 20, para tamaños 300 x 200 o 120&#xa0;%; Intro suelta</translation>
    </message>
    <message>
        <source>click edges; Shift+click collects several; Esc ends</source>
        <translation>clic en bordes; Mayús+clic reúne varios; Esc termina</translation>
    </message>
    <message>
        <source>right button, without a drag</source>
        <translation>botón derecho, sin arrastrar</translation>
    </message>
    <message>
        <source>Move by %1, by %2</source>
        <translation>Mover %1, %2</translation>
    </message>
    <message>
        <source>%1, or Space and drag</source>
        <translation>%1, o Espacio y arrastrar</translation>
    </message>
    <message>
        <source>%1, or drag beside the cover</source>
        <translation>%1, o arrastrar junto a la funda</translation>
    </message>
</context>
<context>
    <name>Insert</name>
    <message>
        <source>Padding</source>
        <translation>Acolchado</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>Espuma</translation>
    </message>
    <message>
        <source>This frame is large: its smallest detail is set to %1; the usual %2 would need too much memory.</source>
        <translation>Este armazón es grande: su detalle mínimo se pone en %1; el habitual, de %2, necesitaría demasiada memoria.</translation>
    </message>
</context>
<context>
    <name>InsertCommands</name>
    <message>
        <source>&amp;Cushion</source>
        <translation>&amp;Acolchado</translation>
    </message>
    <message>
        <source>&amp;Box of foam</source>
        <translation>&amp;Caja de espuma</translation>
    </message>
    <message>
        <source>C&amp;ylinder of foam</source>
        <translation>C&amp;ilindro de espuma</translation>
    </message>
    <message>
        <source>&amp;Sphere of foam</source>
        <translation>&amp;Esfera de espuma</translation>
    </message>
    <message>
        <source>Foam belongs to a cushion: insert one first.</source>
        <translation>La espuma pertenece a un acolchado: inserte antes uno.</translation>
    </message>
    <message>
        <source>Cushioning needs a frame: import one first.</source>
        <translation>El acolchado necesita un armazón: importe antes uno.</translation>
    </message>
</context>
<context>
    <name>InspectorForms</name>
    <message numerus="yes">
        <source>%n elements</source>
        <translation>
            <numerusform>%n elemento</numerusform>
            <numerusform>%n elementos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>InternalLineForm</name>
    <message>
        <source>Patch</source>
        <translation>Pieza</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
</context>
<context>
    <name>InverseCommands</name>
    <message>
        <source>From a form …</source>
        <translation>A partir de una forma…</translation>
    </message>
    <message>
        <source>Cuts a frame, a mesh or the cover into pieces, lays them flat and makes the pattern of them</source>
        <translation>Corta un armazón, una malla o la funda en piezas, las aplana y hace con ellas el patrón</translation>
    </message>
    <message>
        <source>F&amp;it to a goal …</source>
        <translation>&amp;Adaptar a un objetivo…</translation>
    </message>
    <message>
        <source>Changes the pattern until the cover lies on a scan, or is strained less</source>
        <translation>Cambia el patrón hasta que la funda se ajuste a un escaneo o esté menos deformada</translation>
    </message>
    <message>
        <source>Relieve strain …</source>
        <translation>Aliviar la deformación…</translation>
    </message>
    <message>
        <source>Proposes changes of the pattern where cloth is strained too much, with what each gains</source>
        <translation>Propone cambios en el patrón donde la tela se deforma demasiado, con lo que mejora cada uno</translation>
    </message>
    <message>
        <source>Why is it so? …</source>
        <translation>¿Por qué es así?…</translation>
    </message>
    <message>
        <source>Which cause explains best how far the scan of a built piece lies from the cover</source>
        <translation>Qué causa explica mejor cuánto se aparta de la funda el escaneo de una pieza fabricada</translation>
    </message>
    <message>
        <source>Tolerances …</source>
        <translation>Tolerancias…</translation>
    </message>
    <message>
        <source>Where the cover varies from piece to piece, and which tolerance of making matters</source>
        <translation>Dónde varía la funda de pieza a pieza y qué tolerancia de fabricación importa</translation>
    </message>
</context>
<context>
    <name>KeptMeasure</name>
    <message>
        <source>Measurement %1</source>
        <translation>Medida %1</translation>
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
        <translation>Arrastre la etiqueta a donde se pueda leer — Mayús fija un eje, Ctrl: sin ajuste, Esc lo anula</translation>
    </message>
</context>
<context>
    <name>LayerCommands</name>
    <message>
        <source>La&amp;yers</source>
        <translation>C&amp;apas</translation>
    </message>
    <message>
        <source>&amp;Triangulation</source>
        <translation>&amp;Triangulación</translation>
    </message>
    <message>
        <source>Chec&amp;ker</source>
        <translation>Da&amp;mero</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>&amp;Armazón</translation>
    </message>
    <message>
        <source>Control po&amp;ints</source>
        <translation>P&amp;untos de control</translation>
    </message>
    <message>
        <source>Sea&amp;ms and fixations</source>
        <translation>Costuras &amp;y fijaciones</translation>
    </message>
    <message>
        <source>Fixation c&amp;urves</source>
        <translation>Cur&amp;vas de fijación</translation>
    </message>
    <message>
        <source>&amp;Handle curves</source>
        <translation>Curvas de ti&amp;rador</translation>
    </message>
    <message>
        <source>Fanc&amp;y seams</source>
        <translation>Co&amp;sturas decorativas</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Etiquetas</translation>
    </message>
    <message>
        <source>Sca&amp;ns</source>
        <translation>Esca&amp;neos</translation>
    </message>
    <message>
        <source>Gr&amp;ound</source>
        <translation>Sue&amp;lo</translation>
    </message>
    <message>
        <source>Cushionin&amp;g</source>
        <translation>Ac&amp;olchado</translation>
    </message>
    <message>
        <source>Mirror image of the &amp;selection</source>
        <translation>Ima&amp;gen especular de la selección</translation>
    </message>
    <message>
        <source>Symmetry &amp;axis and plane</source>
        <translation>E&amp;je y plano de simetría</translation>
    </message>
    <message>
        <source>Pairs of co&amp;ver and scan</source>
        <translation>Pares de &amp;funda y escaneo</translation>
    </message>
    <message>
        <source>Own &amp;colours of scans</source>
        <translation>&amp;Colores propios de los escaneos</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>Cua&amp;drícula</translation>
    </message>
    <message>
        <source>Cut lines, notches and la&amp;bels</source>
        <translation>Líneas de corte, pi&amp;quetes y etiquetas</translation>
    </message>
    <message>
        <source>M&amp;easurements</source>
        <translation>M&amp;edidas</translation>
    </message>
</context>
<context>
    <name>MainMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Edición</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Pattern</source>
        <translation>&amp;Patrón</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>&amp;Superficie</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>Ve&amp;ntana</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>&amp;Insertar</translation>
    </message>
    <message>
        <source>Sea&amp;m</source>
        <translation>&amp;Costura</translation>
    </message>
    <message>
        <source>F&amp;rame</source>
        <translation>A&amp;rmazón</translation>
    </message>
    <message>
        <source>F&amp;abric</source>
        <translation>&amp;Tela</translation>
    </message>
    <message>
        <source>S&amp;can</source>
        <translation>Escane&amp;o</translation>
    </message>
</context>
<context>
    <name>ManualCommands</name>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manual</translation>
    </message>
    <message>
        <source>The page about what you are at</source>
        <translation>La página sobre lo que está haciendo</translation>
    </message>
    <message>
        <source>The manual is not installed.</source>
        <translation>El manual no está instalado.</translation>
    </message>
    <message>
        <source>It is a folder &quot;manual&quot; with the program&apos;s other files.</source>
        <translation>Es una carpeta «manual» junto a los demás archivos del programa.</translation>
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
        <translation>Deformación má&amp;xima</translation>
    </message>
    <message>
        <source>Strain al&amp;ong the grain</source>
        <translation>Deformación al &amp;hilo</translation>
    </message>
    <message>
        <source>Strain a&amp;cross the grain</source>
        <translation>Deformación a &amp;contrahilo</translation>
    </message>
    <message>
        <source>&amp;Shear</source>
        <translation>C&amp;izalladura</translation>
    </message>
    <message>
        <source>&amp;Mean curvature</source>
        <translation>Curvatura &amp;media</translation>
    </message>
    <message>
        <source>Distance to the &amp;frame</source>
        <translation>Distancia al &amp;armazón</translation>
    </message>
    <message>
        <source>&amp;Deviation from the scan</source>
        <translation>&amp;Desviación respecto al escaneo</translation>
    </message>
    <message>
        <source>&amp;Worst spots</source>
        <translation>&amp;Peores zonas</translation>
    </message>
    <message>
        <source>Show worst spots as a l&amp;ist</source>
        <translation>Ver peores zonas en una &amp;lista</translation>
    </message>
    <message>
        <source>Show this place in both windows</source>
        <translation>Mostrar este lugar en ambas ventanas</translation>
    </message>
    <message>
        <source>Choose a map of strain first</source>
        <translation>Elija antes un mapa de deformación</translation>
    </message>
</context>
<context>
    <name>MarkDrag</name>
    <message>
        <source>Drag it to where it belongs – Esc takes it back</source>
        <translation>Arrástrelo a su sitio — Esc lo anula</translation>
    </message>
    <message>
        <source>Allowance of %1 – or type it; Ctrl for any width, Esc takes it back</source>
        <translation>Margen de %1 — o escríbalo; Ctrl para cualquier ancho, Esc lo anula</translation>
    </message>
    <message>
        <source>Drag it to where it belongs, or type its place: 120, 40 – Esc takes it back</source>
        <translation>Arrástrelo a su sitio o escriba el lugar: 120, 40 — Esc lo anula</translation>
    </message>
    <message>
        <source>Drag it along the outline, or type how far it is from the corner – Esc takes it back</source>
        <translation>Arrástrelo por el contorno o escriba a qué distancia está de la esquina — Esc lo anula</translation>
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
        <translation>Este borde mide %1 — haga clic para medir desde un punto</translation>
    </message>
    <message>
        <source>Edge: %1</source>
        <translation>Borde: %1</translation>
    </message>
    <message>
        <source>Only a measurement between two points of patches can be kept.</source>
        <translation>Solo se puede conservar una medida entre dos puntos de piezas.</translation>
    </message>
    <message>
        <source>&amp;Keep the measurement</source>
        <translation>&amp;Conservar la medida</translation>
    </message>
    <message>
        <source>%1 – Enter keeps the measurement, a click begins anew</source>
        <translation>%1 – Intro conserva la medida, un clic empieza de nuevo</translation>
    </message>
    <message>
        <source>Click two points of the pattern or of the cover to measure, or point at an outline – Esc ends the tool</source>
        <translation>Haga clic en dos puntos del patrón o de la funda para medir, o señale un contorno – Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>%1 – a click begins anew</source>
        <translation>%1 – un clic empieza de nuevo</translation>
    </message>
</context>
<context>
    <name>MeasurementForm</name>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>En el patrón</translation>
    </message>
    <message>
        <source>two patches</source>
        <translation>dos piezas</translation>
    </message>
    <message>
        <source>On the cover</source>
        <translation>En la funda</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>todavía no</translation>
    </message>
</context>
<context>
    <name>Message</name>
    <message>
        <source>the degree must be 1, 2 or 3, not %1</source>
        <translation>el grado debe ser 1, 2 o 3, no %1</translation>
    </message>
    <message>
        <source>a closed curve needs at least %1 points, not %2</source>
        <translation>una curva cerrada necesita al menos %1 puntos, no %2</translation>
    </message>
    <message>
        <source>an open curve of this degree needs at least %1 points, not %2</source>
        <translation>una curva abierta de este grado necesita al menos %1 puntos, no %2</translation>
    </message>
    <message>
        <source>point %1 is no number or beyond 1e7 mm</source>
        <translation>el punto %1 no es un número o supera 1e7&#xa0;mm</translation>
    </message>
    <message>
        <source>corners belong to closed curves of degree 3 only</source>
        <translation>las esquinas solo existen en curvas cerradas de grado 3</translation>
    </message>
    <message>
        <source>the list of corners is empty; leave it out</source>
        <translation>la lista de esquinas está vacía; omítala</translation>
    </message>
    <message>
        <source>corner %1 does not exist; the points are numbered 0 to %2</source>
        <translation>la esquina %1 no existe; los puntos se numeran de 0 a %2</translation>
    </message>
    <message>
        <source>the corners must increase, but %1 follows %2</source>
        <translation>las esquinas deben ir en aumento, pero %1 sigue a %2</translation>
    </message>
    <message>
        <source>there must be at least two points between the corners %1 and %2 (a straight edge: at its thirds)</source>
        <translation>debe haber al menos dos puntos entre las esquinas %1 y %2 (en un borde recto: en sus tercios)</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text goes on after the design&apos;s last bracket; remove what follows</source>
        <translation>Línea %1, columna %2: el texto sigue tras el último corchete o llave del diseño; elimine lo que sigue</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text ends in the middle of the design; the file is incomplete</source>
        <translation>Línea %1, columna %2: el texto termina en medio del diseño; el archivo está incompleto</translation>
    </message>
    <message>
        <source>Line %1, column %2: brackets are nested more than 64 deep; no design needs that</source>
        <translation>Línea %1, columna %2: hay más de 64 niveles de corchetes o llaves; ningún diseño necesita eso</translation>
    </message>
    <message>
        <source>Line %1, column %2: a value is expected here: a number, a text in quotes, true, false or a bracket (NaN and Infinity are no numbers)</source>
        <translation>Línea %1, columna %2: aquí se espera un valor: un número, un texto entre comillas, true, false, un corchete o una llave (NaN e Infinity no son números)</translation>
    </message>
    <message>
        <source>Line %1, column %2: a comma or &quot;]&quot; is missing here</source>
        <translation>Línea %1, columna %2: aquí falta una coma o «]»</translation>
    </message>
    <message>
        <source>Line %1, column %2: a key in quotes is expected here</source>
        <translation>Línea %1, columna %2: aquí se espera una clave entre comillas</translation>
    </message>
    <message>
        <source>Line %1, column %2: a colon is missing after the key</source>
        <translation>Línea %1, columna %2: faltan dos puntos tras la clave</translation>
    </message>
    <message>
        <source>Line %1, column %2: a comma or &quot;}&quot; is missing here</source>
        <translation>Línea %1, columna %2: aquí falta una coma o «}»</translation>
    </message>
    <message>
        <source>Line %1, column %2: a text in quotes must end on its line; a quote is missing</source>
        <translation>Línea %1, columna %2: un texto entre comillas debe terminar en su línea; falta una comilla</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is no valid escape; write a backslash as &quot;\\&quot;</source>
        <translation>Línea %1, columna %2: secuencia de escape no válida; escriba la barra invertida como «\\»</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is not UTF-8; save the file in that encoding</source>
        <translation>Línea %1, columna %2: esto no es UTF-8; guarde el archivo con esa codificación</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text ends inside quotes; the file is incomplete</source>
        <translation>Línea %1, columna %2: el texto termina dentro de unas comillas; el archivo está incompleto</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is no number; write it like 12.5, -3 or 1e-3</source>
        <translation>Línea %1, columna %2: esto no es un número; escríbalo como 12.5, -3 o 1e-3</translation>
    </message>
    <message>
        <source>the text is larger than %1 MB; that is no design</source>
        <translation>el texto ocupa más de %1&#xa0;MB; eso no es un diseño</translation>
    </message>
    <message>
        <source>knot %1 occurs more often than %2 times, the degree; remove the surplus ones</source>
        <translation>el nodo %1 aparece más de %2 veces, el grado; elimine los sobrantes</translation>
    </message>
    <message>
        <source>the knots of an open curve must begin with %1 equal ones and end with %1 equal, larger ones</source>
        <translation>los nodos de una curva abierta deben empezar con %1 iguales y terminar con %1 iguales y mayores</translation>
    </message>
    <message>
        <source>%1 points of degree %2 need %3 knots, not %4</source>
        <translation>%1 puntos de grado %2 necesitan %3 nodos, no %4</translation>
    </message>
    <message>
        <source>a knot is no number or beyond 1e7</source>
        <translation>un nodo no es un número o supera 1e7</translation>
    </message>
    <message>
        <source>the knots must not decrease</source>
        <translation>los nodos no deben disminuir</translation>
    </message>
    <message>
        <source>the last knot must be larger than the first</source>
        <translation>el último nodo debe ser mayor que el primero</translation>
    </message>
    <message>
        <source>two knots near %1 are almost equal; make them equal</source>
        <translation>dos nodos cerca de %1 son casi iguales; iguálelos</translation>
    </message>
    <message>
        <source>there is not enough memory for this design</source>
        <translation>no hay memoria suficiente para este diseño</translation>
    </message>
    <message>
        <source>%1: the file promises more than it holds</source>
        <translation>%1: el archivo promete más de lo que contiene</translation>
    </message>
    <message>
        <source>%1: the mesh is too large, the limit is %2 points and as many triangles</source>
        <translation>%1: la malla es demasiado grande; el límite es de %2 puntos y otros tantos triángulos</translation>
    </message>
    <message>
        <source>%1: the point is not finite, or beyond 10,000,000</source>
        <translation>%1: el punto no es finito o supera 10&#xa0;000&#xa0;000</translation>
    </message>
    <message>
        <source>%1: a face refers to point %2, but there are %3 points</source>
        <translation>%1: una cara remite al punto %2, pero hay %3 puntos</translation>
    </message>
    <message>
        <source>%1: the mesh has too many groups, the limit is %2</source>
        <translation>%1: la malla tiene demasiados grupos; el límite es %2</translation>
    </message>
    <message>
        <source>%1 holds no mesh</source>
        <translation>%1 no contiene ninguna malla</translation>
    </message>
    <message>
        <source>%1 holds points only; a frame needs faces between them</source>
        <translation>%1 solo contiene puntos; un armazón necesita caras entre ellos</translation>
    </message>
    <message>
        <source>%1: points are counted from 1, not from 0</source>
        <translation>%1: los puntos se cuentan desde 1, no desde 0</translation>
    </message>
    <message>
        <source>%1: the file ends too early</source>
        <translation>%1: el archivo termina demasiado pronto</translation>
    </message>
    <message>
        <source>%1: the file does not begin with OFF</source>
        <translation>%1: el archivo no empieza con OFF</translation>
    </message>
    <message>
        <source>%1: binary OFF is not read; save it as text</source>
        <translation>%1: no se lee OFF binario; guárdelo como texto</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PLY number type</source>
        <translation>%1: «%2» no es un tipo numérico de PLY</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PLY format</source>
        <translation>%1: «%2» no es un formato PLY</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; cannot count a list</source>
        <translation>%1: «%2» no puede contar una lista</translation>
    </message>
    <message>
        <source>%1: the file does not begin with &quot;ply&quot;</source>
        <translation>%1: el archivo no empieza con «ply»</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not expected in a PLY header</source>
        <translation>%1: no se espera «%2» en una cabecera PLY</translation>
    </message>
    <message>
        <source>%1: a count is negative</source>
        <translation>%1: una cantidad es negativa</translation>
    </message>
    <message>
        <source>%1: the points have no coordinate &quot;%2&quot;</source>
        <translation>%1: los puntos no tienen la coordenada «%2»</translation>
    </message>
    <message>
        <source>%1: the faces have no list &quot;%2&quot;</source>
        <translation>%1: las caras no tienen la lista «%2»</translation>
    </message>
    <message>
        <source>%1: a number is missing</source>
        <translation>%1: falta un número</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a number</source>
        <translation>%1: «%2» no es un número</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a whole number</source>
        <translation>%1: «%2» no es un número entero</translation>
    </message>
    <message>
        <source>unsaved work cannot be protected: &quot;%1&quot; cannot be written</source>
        <translation>el trabajo sin guardar no se puede proteger: no se puede escribir «%1»</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot;</source>
        <translation>no existe el archivo «%1»</translation>
    </message>
    <message>
        <source>you are not allowed to read &quot;%1&quot;</source>
        <translation>no tiene permiso para leer «%1»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a folder, not a file</source>
        <translation>«%1» es una carpeta, no un archivo</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an ordinary file</source>
        <translation>«%1» no es un archivo normal</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read (%2)</source>
        <translation>«%1» no se puede leer (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: the disk is full; make room or choose another folder</source>
        <translation>«%1» no se puede escribir: el disco está lleno; libere espacio o elija otra carpeta</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: you are not allowed to write into &quot;%2&quot;; choose another folder</source>
        <translation>«%1» no se puede escribir: no tiene permiso para escribir en «%2»; elija otra carpeta</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: there is no folder &quot;%2&quot;</source>
        <translation>«%1» no se puede escribir: no existe la carpeta «%2»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is a folder</source>
        <translation>«%1» no se puede escribir: es una carpeta</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written (%2)</source>
        <translation>«%1» no se puede escribir (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too large: %2 MB, and at most %3 MB are read</source>
        <translation>«%1» es demasiado grande: %2&#xa0;MB; se leen como máximo %3&#xa0;MB</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is write-protected</source>
        <translation>«%1» no se puede escribir: está protegido contra escritura</translation>
    </message>
    <message>
        <source>The equations of the cover could not be solved: a patch is degenerate or its numbers are too large.</source>
        <translation>No se pudieron resolver las ecuaciones de la funda: una pieza es degenerada o sus números son demasiado grandes.</translation>
    </message>
    <message>
        <source>this seam and its neighbours carry their ends round in a circle without ever meeting. Let the seams of this circle end at common points.</source>
        <translation>esta costura y sus vecinas se pasan los extremos en círculo sin encontrarse nunca. Haga que las costuras de este círculo terminen en puntos comunes.</translation>
    </message>
    <message>
        <source>the corners of the two stretches lie too close together to be matched. Move them apart or choose a smaller edge length.</source>
        <translation>las esquinas de los dos tramos están demasiado juntas para emparejarlas. Sepárelas o elija una longitud de arista menor.</translation>
    </message>
    <message>
        <source>%1 and %2 hold the same point of the cover in two places, %3 mm apart. Let both curves meet there, or end one stretch earlier.</source>
        <translation>%1 y %2 sujetan el mismo punto de la funda en dos lugares, a %3&#xa0;mm uno de otro. Haga que ambas curvas se encuentren allí o termine antes un tramo.</translation>
    </message>
    <message>
        <source>the patch is too narrow somewhere for edges of %1 mm. Choose a smaller edge length.</source>
        <translation>la pieza es demasiado estrecha en algún punto para aristas de %1&#xa0;mm. Elija una longitud de arista menor.</translation>
    </message>
    <message>
        <source>The design cannot be solved: %2</source>
        <translation>No se puede calcular el diseño: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>There is no patch to solve. Add a patch to the pattern.</source>
        <translation>No hay ninguna pieza que calcular. Añada una pieza al patrón.</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by an estimated %2 mm. Allow more iterations.</source>
        <translation>Tras %1 iteraciones la superficie aún se mueve unos %2&#xa0;mm. Permita más iteraciones.</translation>
    </message>
    <message>
        <source>Remove %1 points</source>
        <translation>Eliminar %1 puntos</translation>
    </message>
    <message>
        <source>Move %1 points</source>
        <translation>Mover %1 puntos</translation>
    </message>
    <message>
        <source>another element has the number %1 already; give this one a number of its own</source>
        <translation>otro elemento ya tiene el número %1; dé a este uno propio</translation>
    </message>
    <message>
        <source>this is no Bolster design; it must say &quot;format&quot;: &quot;bolster-design&quot;</source>
        <translation>esto no es un diseño de Bolster; debe decir &quot;format&quot;: &quot;bolster-design&quot;</translation>
    </message>
    <message>
        <source>the design was made by a newer Bolster (version %1 of the format, this program knows %2); update the program</source>
        <translation>el diseño se hizo con un Bolster más nuevo (versión %1 del formato, este programa conoce la %2); actualice el programa</translation>
    </message>
    <message>
        <source>must be %1</source>
        <translation>debe ser %1</translation>
    </message>
    <message>
        <source>must be &quot;mm&quot;; convert the design to millimetres</source>
        <translation>debe ser &quot;mm&quot;; convierta el diseño a milímetros</translation>
    </message>
    <message>
        <source>must be a list of elements in square brackets</source>
        <translation>debe ser una lista de elementos entre corchetes</translation>
    </message>
    <message>
        <source>must be a list of points in square brackets</source>
        <translation>debe ser una lista de puntos entre corchetes</translation>
    </message>
    <message>
        <source>must be a list of numbers in square brackets</source>
        <translation>debe ser una lista de números entre corchetes</translation>
    </message>
    <message>
        <source>the list is empty; leave it out</source>
        <translation>la lista está vacía; omítala</translation>
    </message>
    <message>
        <source>must be a curve in braces, with degree, closed and points</source>
        <translation>debe ser una curva entre llaves, con degree, closed y points</translation>
    </message>
    <message>
        <source>a curve has either corners or knots; remove one of them</source>
        <translation>una curva tiene o corners o knots; elimine uno de los dos</translation>
    </message>
    <message>
        <source>an outline must be closed; write true</source>
        <translation>un contorno debe ser cerrado; escriba true</translation>
    </message>
    <message>
        <source>must be a stretch in braces, with patch, from and to</source>
        <translation>debe ser un tramo entre llaves, con patch, from y to</translation>
    </message>
    <message>
        <source>must be a quaternion [w, x, y, z] of length 1, not of length %1</source>
        <translation>debe ser un cuaternión [w, x, y, z] de longitud 1, no de longitud %1</translation>
    </message>
    <message>
        <source>must be an object in braces</source>
        <translation>debe ser un objeto entre llaves</translation>
    </message>
    <message>
        <source>an element must be an object in braces</source>
        <translation>un elemento debe ser un objeto entre llaves</translation>
    </message>
    <message>
        <source>must be true or false, without quotes</source>
        <translation>debe ser true o false, sin comillas</translation>
    </message>
    <message>
        <source>must be a text in quotes</source>
        <translation>debe ser un texto entre comillas</translation>
    </message>
    <message>
        <source>and %1 more problems of this element</source>
        <translation>y %1 problemas más de este elemento</translation>
    </message>
    <message>
        <source>must be a number, without quotes</source>
        <translation>debe ser un número, sin comillas</translation>
    </message>
    <message>
        <source>must be a whole number from %1 to %2</source>
        <translation>debe ser un número entero de %1 a %2</translation>
    </message>
    <message>
        <source>must be a list of %1 numbers in square brackets</source>
        <translation>debe ser una lista de %1 números entre corchetes</translation>
    </message>
    <message>
        <source>this key occurs twice; remove one of them</source>
        <translation>esta clave aparece dos veces; elimine una</translation>
    </message>
    <message>
        <source>this key is missing; add it</source>
        <translation>falta esta clave; añádala</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>debe ser uno de %1</translation>
    </message>
    <message>
        <source>this key is unknown; check its spelling or remove it</source>
        <translation>esta clave es desconocida; compruebe la ortografía o elimínela</translation>
    </message>
    <message>
        <source>Move a point of %1</source>
        <translation>Mover un punto de %1</translation>
    </message>
    <message>
        <source>Move %2 points of %1</source>
        <translation>Mover %2 puntos de %1</translation>
    </message>
    <message>
        <source>Insert a point into %1</source>
        <translation>Insertar un punto en %1</translation>
    </message>
    <message>
        <source>Remove a point of %1</source>
        <translation>Eliminar un punto de %1</translation>
    </message>
    <message>
        <source>Change the settings</source>
        <translation>Cambiar los ajustes</translation>
    </message>
    <message>
        <source>Add fabric %1</source>
        <translation>Añadir tela %1</translation>
    </message>
    <message>
        <source>Add patch %1</source>
        <translation>Añadir pieza %1</translation>
    </message>
    <message>
        <source>Add a seam</source>
        <translation>Añadir una costura</translation>
    </message>
    <message>
        <source>Add fixation curve %1</source>
        <translation>Añadir curva de fijación %1</translation>
    </message>
    <message>
        <source>Add a fixation seam</source>
        <translation>Añadir una fijación</translation>
    </message>
    <message>
        <source>Add frame %1</source>
        <translation>Añadir armazón %1</translation>
    </message>
    <message>
        <source>Add an unreadable element</source>
        <translation>Añadir un elemento ilegible</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>Cambiar nombre de %1 a %2</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Eliminar %1</translation>
    </message>
    <message>
        <source>Remove %1 elements</source>
        <translation>Eliminar %1 elementos</translation>
    </message>
    <message>
        <source>Move %1 patches</source>
        <translation>Mover %1 piezas</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Mover %1</translation>
    </message>
    <message>
        <source>Turn %1 patches</source>
        <translation>Girar %1 piezas</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>Girar %1</translation>
    </message>
    <message>
        <source>There is not enough memory for this surface. Choose a larger edge length.</source>
        <translation>No hay memoria suficiente para esta superficie. Elija una longitud de arista mayor.</translation>
    </message>
    <message>
        <source>The solver failed: %1. The last good surface is kept.</source>
        <translation>El cálculo ha fallado: %1. Se conserva la última superficie buena.</translation>
    </message>
    <message>
        <source>Change the colour of %1</source>
        <translation>Cambiar el color de %1</translation>
    </message>
    <message>
        <source>Change the stiffness of %1</source>
        <translation>Cambiar la rigidez de %1</translation>
    </message>
    <message>
        <source>Change the Poisson parameter of %1</source>
        <translation>Cambiar el coef. de Poisson de %1</translation>
    </message>
    <message>
        <source>Change the bending length of %1</source>
        <translation>Cambiar la longitud de flexión de %1</translation>
    </message>
    <message>
        <source>Change the fabric of %1</source>
        <translation>Cambiar la tela de %1</translation>
    </message>
    <message>
        <source>Change the grain of %1</source>
        <translation>Cambiar el sentido del hilo de %1</translation>
    </message>
    <message>
        <source>Change the pressure of %1</source>
        <translation>Cambiar la presión de %1</translation>
    </message>
    <message>
        <source>Change the right side of %1</source>
        <translation>Cambiar el derecho de %1</translation>
    </message>
    <message>
        <source>Move %1 in the layout</source>
        <translation>Mover %1 en la disposición</translation>
    </message>
    <message>
        <source>Turn %1 in the layout</source>
        <translation>Girar %1 en la disposición</translation>
    </message>
    <message>
        <source>Change the continuity of %1</source>
        <translation>Cambiar la continuidad de %1</translation>
    </message>
    <message>
        <source>Change how %1 is matched</source>
        <translation>Cambiar el emparejado de %1</translation>
    </message>
    <message>
        <source>Reverse %1</source>
        <translation>Invertir %1</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>Escalar %1</translation>
    </message>
    <message>
        <source>The surface still moves after %1 iterations.</source>
        <translation>La superficie aún se mueve tras %1 iteraciones.</translation>
    </message>
    <message>
        <source>this is no name of a file</source>
        <translation>esto no es un nombre de archivo</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be relative to the design&apos;s folder and use &quot;/&quot; between folders</source>
        <translation>«%1» debe ser relativo a la carpeta del diseño y usar «/» entre carpetas</translation>
    </message>
    <message>
        <source>left out because of its errors</source>
        <translation>omitido por sus errores</translation>
    </message>
    <message>
        <source>left out because it needs %1, which is not there</source>
        <translation>omitido porque necesita %1, que no existe</translation>
    </message>
    <message>
        <source>an edge length of %1 mm is used instead</source>
        <translation>en su lugar se usa una longitud de arista de %1&#xa0;mm</translation>
    </message>
    <message>
        <source>the file is not a design</source>
        <translation>el archivo no es un diseño</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written</source>
        <translation>«%1» no se puede escribir</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be copied to &quot;%2&quot;: %3</source>
        <translation>«%1» no se pudo copiar a «%2»: %3</translation>
    </message>
    <message>
        <source>the folder &quot;%1&quot; could not be made</source>
        <translation>no se pudo crear la carpeta «%1»</translation>
    </message>
    <message>
        <source>the patch is free in space: nothing fixes it to the frame; add a fixation</source>
        <translation>la pieza está libre en el espacio: nada la fija al armazón; añada una fijación</translation>
    </message>
    <message>
        <source>this patch and the %1 sewn to it are free in space: nothing fixes them to the frame; add a fixation</source>
        <translation>esta pieza y las %1 cosidas a ella están libres en el espacio: nada las fija al armazón; añada una fijación</translation>
    </message>
    <message>
        <source>is %1, but must lie between %2 and %3</source>
        <translation>es %1, pero debe estar entre %2 y %3</translation>
    </message>
    <message>
        <source>there is no element %1; name a %2</source>
        <translation>no existe el elemento %1; indique uno del tipo «%2»</translation>
    </message>
    <message>
        <source>element %1 cannot be read; repair it or name another %2</source>
        <translation>el elemento %1 no se puede leer; repárelo o indique otro del tipo «%2»</translation>
    </message>
    <message>
        <source>%1 is no %2; name another element</source>
        <translation>%1 no es del tipo «%2»; indique otro elemento</translation>
    </message>
    <message>
        <source>%1 mm would make more than 5 million triangles; take at least %2 mm for these patches</source>
        <translation>%1&#xa0;mm darían más de 5 millones de triángulos; use al menos %2&#xa0;mm para estas piezas</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no colour; write it like #7a4a2b</source>
        <translation>«%1» no es un color; escríbalo como #7a4a2b</translation>
    </message>
    <message>
        <source>the mesh cannot resolve folds as small as a bending length of %1 mm makes them: with edges of %2 mm it acts like %3 mm; take an edge length of at most %4 mm, or a longer bending length</source>
        <translation>la malla no puede resolver pliegues tan pequeños como los que hace una longitud de flexión de %1&#xa0;mm: con aristas de %2&#xa0;mm actúa como %3&#xa0;mm; use una longitud de arista de %4&#xa0;mm como máximo o una longitud de flexión mayor</translation>
    </message>
    <message>
        <source>an outline must be a closed curve</source>
        <translation>un contorno debe ser una curva cerrada</translation>
    </message>
    <message>
        <source>the outline needs at least three points in different places</source>
        <translation>el contorno necesita al menos tres puntos en lugares distintos</translation>
    </message>
    <message>
        <source>all points of the outline lie on one line, it encloses no area; move one of them</source>
        <translation>todos los puntos del contorno están en una recta; no encierra ningún área; mueva uno de ellos</translation>
    </message>
    <message>
        <source>the outline crosses or touches itself near %1; move its points apart there</source>
        <translation>el contorno se cruza o se toca cerca de %1; separe allí sus puntos</translation>
    </message>
    <message>
        <source>the outline encloses no area</source>
        <translation>el contorno no encierra ningún área</translation>
    </message>
    <message>
        <source>%1 is the end of the curve; write %2, its start</source>
        <translation>%1 es el final de la curva; escriba %2, su inicio</translation>
    </message>
    <message>
        <source>is %1, but must be larger than the start of the stretch, %2</source>
        <translation>es %1, pero debe ser mayor que el inicio del tramo, %2</translation>
    </message>
    <message>
        <source>the stretch from %1 to %2 is empty or longer than the curve</source>
        <translation>el tramo de %1 a %2 está vacío o es más largo que la curva</translation>
    </message>
    <message>
        <source>the stretch from %1 to %2 has no length; the outline&apos;s points coincide there</source>
        <translation>el tramo de %1 a %2 no tiene longitud; los puntos del contorno coinciden allí</translation>
    </message>
    <message>
        <source>the seam would sew a stretch of &quot;%1&quot; to itself: %2 to %3 and %4 to %5 overlap; choose two separate stretches</source>
        <translation>la costura cosería un tramo de «%1» consigo mismo: de %2 a %3 y de %4 a %5 se solapan; elija dos tramos separados</translation>
    </message>
    <message>
        <source>the seam joins the right side of &quot;%1&quot; to the wrong side of &quot;%2&quot;; turn &quot;reversed&quot; round, or one patch wrong side out</source>
        <translation>la costura une el derecho de «%1» con el revés de «%2»; invierta &quot;reversed&quot; o ponga una pieza del revés</translation>
    </message>
    <message>
        <source>the sides of the seam are %1 mm (&quot;%2&quot;) and %3 mm (&quot;%4&quot;) long: %5 % ease, more than 5 % puckers; make them equal or check the ends of the stretches</source>
        <translation>los lados de la costura miden %1&#xa0;mm («%2») y %3&#xa0;mm («%4»): %5&#xa0;% de embebido; con más del 5&#xa0;% se frunce; iguálelos o revise los extremos de los tramos</translation>
    </message>
    <message>
        <source>the curve has no length; move its points apart</source>
        <translation>la curva no tiene longitud; separe sus puntos</translation>
    </message>
    <message>
        <source>the curve from %1 to %2 has no length</source>
        <translation>la curva de %1 a %2 no tiene longitud</translation>
    </message>
    <message>
        <source>is %1, but must be positive: millimetres per unit of the file</source>
        <translation>es %1, pero debe ser positivo: milímetros por unidad del archivo</translation>
    </message>
    <message>
        <source>a design has at most %1 elements</source>
        <translation>un diseño tiene como máximo %1 elementos</translation>
    </message>
    <message>
        <source>a curve has at most %1 points</source>
        <translation>una curva tiene como máximo %1 puntos</translation>
    </message>
    <message>
        <source>the usual values of a fabric are used instead</source>
        <translation>en su lugar se usan los valores habituales de una tela</translation>
    </message>
    <message>
        <source>Remove %1 and what is sewn to it</source>
        <translation>Eliminar %1 y lo que está cosido a él</translation>
    </message>
    <message>
        <source>Remove %1 and %2 seams and fixations</source>
        <translation>Eliminar %1 y %2 costuras y fijaciones</translation>
    </message>
    <message>
        <source>is %1, but must be a positive length of at most %2; 12 mm is usual</source>
        <translation>es %1, pero debe ser una longitud positiva de %2 como máximo; lo habitual son 12&#xa0;mm</translation>
    </message>
    <message>
        <source>no mesh can resolve folds as small as a bending length of %1 mm makes them: with edges of %2 mm it acts like %3 mm; take a longer bending length</source>
        <translation>ninguna malla puede resolver pliegues tan pequeños como los que hace una longitud de flexión de %1&#xa0;mm: con aristas de %2&#xa0;mm actúa como %3&#xa0;mm; use una longitud de flexión mayor</translation>
    </message>
    <message>
        <source>it sews what %1 sews already; remove one of them</source>
        <translation>cose lo que ya cose %1; elimine una de las dos</translation>
    </message>
    <message>
        <source>it sews the same stretches as %1, but the other way round: each would be folded onto itself; remove one of the two</source>
        <translation>cose los mismos tramos que %1, pero en sentido contrario: cada uno se doblaría sobre sí mismo; elimine una de las dos</translation>
    </message>
    <message>
        <source>&quot;%1&quot; goes up with &quot;..&quot;; write the way from the design&apos;s folder without it, or copy the file there</source>
        <translation>«%1» sube con «..»; escriba la ruta desde la carpeta del diseño sin eso o copie allí el archivo</translation>
    </message>
    <message>
        <source>the number %1 is too large or too small; stay within %2</source>
        <translation>el número %1 es demasiado grande o demasiado pequeño; no supere %2</translation>
    </message>
    <message>
        <source>the text is UTF-16; save it as UTF-8</source>
        <translation>el texto está en UTF-16; guárdelo como UTF-8</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by %2 mm in each: it does not come to rest. Lower the pressure, or make curves as long as the outlines they hold.</source>
        <translation>Tras %1 iteraciones la superficie aún se mueve %2&#xa0;mm en cada una: no llega al reposo. Baje la presión o haga las curvas tan largas como los contornos que sujetan.</translation>
    </message>
    <message>
        <source>%1 of %2 triangles of the cover lie upside down. Look for cloth pressed into too little room, or a bending length that is long for its patch.</source>
        <translation>%1 de %2 triángulos de la funda están del revés. Busque tela apretada en muy poco sitio o una longitud de flexión grande para su pieza.</translation>
    </message>
    <message>
        <source>there is either a normal or a tangent; remove one of them</source>
        <translation>hay o una normal o una tangente; elimine una de las dos</translation>
    </message>
    <message>
        <source>there are %1 directions, but at most %2 are possible</source>
        <translation>hay %1 direcciones, pero son posibles %2 como máximo</translation>
    </message>
    <message>
        <source>a direction must be three numbers that are not all 0</source>
        <translation>una dirección debe ser tres números que no sean todos 0</translation>
    </message>
    <message>
        <source>direction %1 is opposite to the one before, so that it is not known on which way to turn; add one between them</source>
        <translation>la dirección %1 es opuesta a la anterior, así que no se sabe hacia dónde girar; añada una entre ellas</translation>
    </message>
    <message>
        <source>there is no curve; name one, or leave out curve_from and curve_to</source>
        <translation>no hay ninguna curva; indique una u omita curve_from y curve_to</translation>
    </message>
    <message>
        <source>Change the normal held by %1</source>
        <translation>Cambiar la normal que fija %1</translation>
    </message>
    <message>
        <source>must be a text in quotation marks</source>
        <translation>debe ser un texto entre comillas</translation>
    </message>
    <message>
        <source>the curve in the patch and its target must both be open or both be closed</source>
        <translation>la curva de la pieza y su destino deben ser ambos abiertos o ambos cerrados</translation>
    </message>
    <message>
        <source>Add handle curve %1</source>
        <translation>Añadir curva de tirador %1</translation>
    </message>
    <message>
        <source>Add fancy seam %1</source>
        <translation>Añadir costura decorativa %1</translation>
    </message>
    <message>
        <source>Add cushion %1</source>
        <translation>Añadir acolchado %1</translation>
    </message>
    <message>
        <source>Add foam %1</source>
        <translation>Añadir espuma %1</translation>
    </message>
    <message>
        <source>a width of %1 mm is too narrow for edges of %2 mm; make it at least %3 mm wide, or choose a smaller edge length</source>
        <translation>un ancho de %1&#xa0;mm es demasiado estrecho para aristas de %2&#xa0;mm; póngale al menos %3&#xa0;mm o elija una longitud de arista menor</translation>
    </message>
    <message>
        <source>it lies outside its patch; move its points inside the outline</source>
        <translation>está fuera de su pieza; lleve sus puntos dentro del contorno</translation>
    </message>
    <message>
        <source>it leaves the patch and comes back; keep it inside, or end it at the outline</source>
        <translation>sale de la pieza y vuelve; manténgala dentro o termínela en el contorno</translation>
    </message>
    <message>
        <source>it runs too flat into the outline near %1; let it meet the outline more steeply, or end it before</source>
        <translation>llega demasiado oblicua al contorno cerca de %1; haga que lo corte más recta o termínela antes</translation>
    </message>
    <message>
        <source>it bends too sharply for a width of %1 mm near %2; make it narrower, or bend it less there</source>
        <translation>se curva demasiado para un ancho de %1&#xa0;mm cerca de %2; hágala más estrecha o cúrvela menos allí</translation>
    </message>
    <message>
        <source>a cushion takes at most %1 bodies of foam; this one is left out</source>
        <translation>un acolchado admite como máximo %1 cuerpos de espuma; este se omite</translation>
    </message>
    <message>
        <source>the frame has no part &quot;%1&quot;; it has %2</source>
        <translation>el armazón no tiene la parte «%1»; tiene %2</translation>
    </message>
    <message>
        <source>it is only %1 mm long; draw it at least %2 mm long, or choose a smaller edge length</source>
        <translation>solo mide %1&#xa0;mm; dibújela de al menos %2&#xa0;mm o elija una longitud de arista menor</translation>
    </message>
    <message>
        <source>it reaches beyond its patch near %1; move its points inside the outline</source>
        <translation>sobresale de su pieza cerca de %1; lleve sus puntos dentro del contorno</translation>
    </message>
    <message>
        <source>it comes closer than %1 mm to the outline near %2; keep away from it, or choose a smaller edge length</source>
        <translation>se acerca a menos de %1&#xa0;mm del contorno cerca de %2; apártela o elija una longitud de arista menor</translation>
    </message>
    <message>
        <source>it crosses %1, or comes closer to it than %2 mm, near %3; move them apart, or choose a smaller edge length</source>
        <translation>cruza %1, o se le acerca a menos de %2&#xa0;mm, cerca de %3; sepárelas o elija una longitud de arista menor</translation>
    </message>
    <message>
        <source>it crosses itself, or comes closer to itself than %1 mm, near %2; move its points apart, or choose a smaller edge length</source>
        <translation>se cruza, o se acerca a sí misma a menos de %1&#xa0;mm, cerca de %2; separe sus puntos o elija una longitud de arista menor</translation>
    </message>
    <message>
        <source>the patch cannot be triangulated along it with edges of %1 mm. Choose a smaller edge length.</source>
        <translation>la pieza no se puede triangular a lo largo de ella con aristas de %1&#xa0;mm. Elija una longitud de arista menor.</translation>
    </message>
    <message>
        <source>Change the frame of %1</source>
        <translation>Cambiar el armazón de %1</translation>
    </message>
    <message>
        <source>Change what %1 pushes</source>
        <translation>Cambiar lo que empuja %1</translation>
    </message>
    <message>
        <source>Switch %1</source>
        <translation>Activar o desactivar %1</translation>
    </message>
    <message>
        <source>Change the parts of %1</source>
        <translation>Cambiar las partes de %1</translation>
    </message>
    <message>
        <source>Change the padding of %1</source>
        <translation>Cambiar el acolchado de %1</translation>
    </message>
    <message>
        <source>Change the strength of %1</source>
        <translation>Cambiar la fuerza de %1</translation>
    </message>
    <message>
        <source>Change the distance of %1</source>
        <translation>Cambiar la distancia de %1</translation>
    </message>
    <message>
        <source>Change the voxels of %1</source>
        <translation>Cambiar los vóxeles de %1</translation>
    </message>
    <message>
        <source>Change the cushion of %1</source>
        <translation>Cambiar el acolchado de %1</translation>
    </message>
    <message>
        <source>Change the shape of %1</source>
        <translation>Cambiar la forma de %1</translation>
    </message>
    <message>
        <source>Change the size of %1</source>
        <translation>Cambiar el tamaño de %1</translation>
    </message>
    <message>
        <source>Add or cut %1</source>
        <translation>Añadir o recortar %1</translation>
    </message>
    <message>
        <source>Change the contact of %1</source>
        <translation>Cambiar el contacto de %1</translation>
    </message>
    <message>
        <source>Change the gap of %1</source>
        <translation>Cambiar la separación de %1</translation>
    </message>
    <message>
        <source>Change the width of %1</source>
        <translation>Cambiar el ancho de %1</translation>
    </message>
    <message>
        <source>Change the depth of %1</source>
        <translation>Cambiar la profundidad de %1</translation>
    </message>
    <message>
        <source>Change the profile of %1</source>
        <translation>Cambiar el perfil de %1</translation>
    </message>
    <message>
        <source>Move points of %1 curves</source>
        <translation>Mover puntos de %1 curvas</translation>
    </message>
    <message>
        <source>Rename a file</source>
        <translation>Cambiar nombre de un archivo</translation>
    </message>
    <message>
        <source>Change the file of %1</source>
        <translation>Cambiar el archivo de %1</translation>
    </message>
    <message>
        <source>the file is missing</source>
        <translation>falta el archivo</translation>
    </message>
    <message>
        <source>it is a file that this design refers to; choose another name</source>
        <translation>es un archivo al que remite este diseño; elija otro nombre</translation>
    </message>
    <message>
        <source>There is no cover to place the scan on.</source>
        <translation>No hay ninguna funda sobre la que colocar el escaneo.</translation>
    </message>
    <message>
        <source>must be a list of at most %1 planes, [x, y, z, distance] each</source>
        <translation>debe ser una lista de %1 planos como máximo, cada uno [x, y, z, distancia]</translation>
    </message>
    <message>
        <source>must be a list of at most %1 cuts in braces</source>
        <translation>debe ser una lista de %1 cortes como máximo, entre llaves</translation>
    </message>
    <message>
        <source>must be a cut in braces, with planes</source>
        <translation>debe ser un corte entre llaves, con planes</translation>
    </message>
    <message>
        <source>the first three numbers are the plane&apos;s normal; not all of them may be 0</source>
        <translation>los tres primeros números son la normal del plano; no pueden ser todos 0</translation>
    </message>
    <message>
        <source>no file is named; write the name of a file beside the design</source>
        <translation>no se indica ningún archivo; escriba el nombre de un archivo situado junto al diseño</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no file in the design&apos;s folder; copy the file into that folder and name it here</source>
        <translation>«%1» no es un archivo de la carpeta del diseño; cópielo en esa carpeta e indíquelo aquí</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot; in the design&apos;s folder; copy the file there or choose another one</source>
        <translation>no existe el archivo «%1» en la carpeta del diseño; cópielo allí o elija otro</translation>
    </message>
    <message>
        <source>with this scale and position the points reach beyond 10,000,000 mm</source>
        <translation>con esta escala y posición los puntos superan los 10&#xa0;000&#xa0;000&#xa0;mm</translation>
    </message>
    <message>
        <source>Add scan %1</source>
        <translation>Añadir escaneo %1</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Recortar %1</translation>
    </message>
    <message>
        <source>Show all of %1</source>
        <translation>Mostrar todo de %1</translation>
    </message>
    <message>
        <source>Cut the floor off %1</source>
        <translation>Recortar el suelo de %1</translation>
    </message>
    <message>
        <source>%1 holds no points</source>
        <translation>%1 no contiene puntos</translation>
    </message>
    <message>
        <source>%1: the scan is too large, the limit is %2 points</source>
        <translation>%1: el escaneo es demasiado grande; el límite es de %2 puntos</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not expected in a PCD header</source>
        <translation>%1: no se espera «%2» en una cabecera PCD</translation>
    </message>
    <message>
        <source>%1: the compressed points are damaged</source>
        <translation>%1: los puntos comprimidos están dañados</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PCD format</source>
        <translation>%1: «%2» no es un formato PCD</translation>
    </message>
    <message>
        <source>the cuts leave nothing of the scan; remove one of them</source>
        <translation>los cortes no dejan nada del escaneo; elimine uno de ellos</translation>
    </message>
    <message>
        <source>Change the threshold of %1</source>
        <translation>Cambiar el umbral de %1</translation>
    </message>
    <message>
        <source>Change how %1 pulls</source>
        <translation>Cambiar cómo tira %1</translation>
    </message>
    <message>
        <source>Release points of twins</source>
        <translation>Liberar puntos de gemelos</translation>
    </message>
    <message>
        <source>Re-link points of twins</source>
        <translation>Volver a vincular puntos de gemelos</translation>
    </message>
    <message>
        <source>Make the design symmetric</source>
        <translation>Hacer simétrico el diseño</translation>
    </message>
    <message>
        <source>These two cannot be twins.</source>
        <translation>Estos dos no pueden ser gemelos.</translation>
    </message>
    <message>
        <source>Make corners</source>
        <translation>Crear esquinas</translation>
    </message>
    <message>
        <source>Make curves smooth</source>
        <translation>Suavizar curvas</translation>
    </message>
    <message>
        <source>element %1 cannot be its twin: that must be another %2 which is nobody else&apos;s; until then it has none</source>
        <translation>el elemento %1 no puede ser su gemelo: debe ser otro del tipo «%2» que no lo sea de nadie más; hasta entonces no tiene ninguno</translation>
    </message>
    <message>
        <source>there is no point %1</source>
        <translation>no existe el punto %1</translation>
    </message>
    <message>
        <source>its points and knots are not those of %1; the next edit of one of them makes it the mirror image</source>
        <translation>sus puntos y nodos no son los de %1; la próxima edición de uno de ellos lo convertirá en la imagen especular</translation>
    </message>
    <message>
        <source>%1 of its points are no mirror images of those of %2; release them, or move them</source>
        <translation>%1 de sus puntos no son imágenes especulares de los de %2; libérelos o muévalos</translation>
    </message>
    <message>
        <source>the plane needs a normal that is not 0, and numbers within 1e7; x = 0 is used instead</source>
        <translation>el plano necesita una normal que no sea 0 y números dentro de 1e7; en su lugar se usa x = 0</translation>
    </message>
    <message>
        <source>the axis needs a direction that is not 0, and numbers within 1e7; x = 0 is used instead</source>
        <translation>el eje necesita una dirección que no sea 0 y números dentro de 1e7; en su lugar se usa x = 0</translation>
    </message>
    <message>
        <source>The clipboard holds no parts of a design.</source>
        <translation>El portapapeles no contiene partes de un diseño.</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Pegar %1</translation>
    </message>
    <message>
        <source>Paste %1 pieces</source>
        <translation>Pegar %1 piezas</translation>
    </message>
    <message>
        <source>The clipboard holds no patches and no fixation curves.</source>
        <translation>El portapapeles no contiene ni piezas ni curvas de fijación.</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Duplicar %1</translation>
    </message>
    <message>
        <source>Duplicate %1 pieces</source>
        <translation>Duplicar %1 piezas</translation>
    </message>
    <message>
        <source>Make a corner in %1</source>
        <translation>Crear una esquina en %1</translation>
    </message>
    <message>
        <source>Make %1 smooth</source>
        <translation>Suavizar %1</translation>
    </message>
    <message>
        <source>Straighten a stretch of %1</source>
        <translation>Enderezar un tramo de %1</translation>
    </message>
    <message>
        <source>Attach %1 to %2</source>
        <translation>Fijar %1 a %2</translation>
    </message>
    <message>
        <source>There is no such stretch of an outline.</source>
        <translation>No existe tal tramo de un contorno.</translation>
    </message>
    <message>
        <source>The stretch has no length.</source>
        <translation>El tramo no tiene longitud.</translation>
    </message>
    <message>
        <source>A part of this stretch is fixed to %1 already: remove that fixation or choose another stretch.</source>
        <translation>Una parte de este tramo ya está fijada a %1: elimine esa fijación o elija otro tramo.</translation>
    </message>
    <message>
        <source>Create fixation curve %1</source>
        <translation>Crear curva de fijación %1</translation>
    </message>
    <message>
        <source>Attach %1 stretches to %2</source>
        <translation>Fijar %1 tramos a %2</translation>
    </message>
    <message>
        <source>Attach %1 to %2 curves</source>
        <translation>Fijar %1 a %2 curvas</translation>
    </message>
    <message>
        <source>Align %1 patches</source>
        <translation>Alinear %1 piezas</translation>
    </message>
    <message>
        <source>Distribute %1 patches</source>
        <translation>Distribuir %1 piezas</translation>
    </message>
    <message>
        <source>Arrange %1 patches</source>
        <translation>Ordenar %1 piezas</translation>
    </message>
    <message>
        <source>Make %1 and %2 twins</source>
        <translation>Hacer gemelos %1 y %2</translation>
    </message>
    <message>
        <source>They are no mirror images: they differ by %1 mm. Twins must be alike; make a mirror twin of one of them instead.</source>
        <translation>No son imágenes especulares: difieren en %1&#xa0;mm. Los gemelos deben ser iguales; cree mejor un gemelo simétrico de uno de ellos.</translation>
    </message>
    <message>
        <source>Make a mirror twin of %1</source>
        <translation>Crear gemelo simétrico de %1</translation>
    </message>
    <message>
        <source>Make %1 mirror twins</source>
        <translation>Crear %1 gemelos simétricos</translation>
    </message>
    <message>
        <source>A patch of the seam is missing or invalid: repair it first.</source>
        <translation>Falta una pieza de la costura o no es válida: repárela antes.</translation>
    </message>
    <message>
        <source>The seam joins %1 to itself: there is nothing to merge.</source>
        <translation>La costura une %1 consigo misma: no hay nada que fusionar.</translation>
    </message>
    <message>
        <source>The seam takes up a whole outline: nothing would be left.</source>
        <translation>La costura ocupa todo un contorno: no quedaría nada.</translation>
    </message>
    <message>
        <source>The seam joins the right side of %1 to the wrong side of %2: one patch cannot be both.</source>
        <translation>La costura une el derecho de %1 con el revés de %2: una pieza no puede ser ambos.</translation>
    </message>
    <message>
        <source>The sides of the seam differ by %1 % in length, more than 5 %.</source>
        <translation>Los lados de la costura difieren en longitud un %1&#xa0;%, más del 5&#xa0;%.</translation>
    </message>
    <message>
        <source>Select the seam along which to merge.</source>
        <translation>Seleccione la costura por la que fusionar.</translation>
    </message>
    <message>
        <source>Merged, %1 and %2 would overlap or cross: the seam stays.</source>
        <translation>Fusionadas, %1 y %2 se solaparían o cruzarían: la costura se queda.</translation>
    </message>
    <message>
        <source>Merge %1 and %2</source>
        <translation>Fusionar %1 y %2</translation>
    </message>
    <message>
        <source>Scale %1 patches</source>
        <translation>Escalar %1 piezas</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>Reflejar %1</translation>
    </message>
    <message>
        <source>Mirror %1 patches</source>
        <translation>Reflejar %1 piezas</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>Dividir %1</translation>
    </message>
    <message>
        <source>The line must cross the outline of %1 exactly twice, not %2 times.</source>
        <translation>La línea debe cruzar el contorno de %1 exactamente dos veces, no %2.</translation>
    </message>
    <message>
        <source>Draw a line over a patch to split it.</source>
        <translation>Dibuje una línea sobre una pieza para dividirla.</translation>
    </message>
    <message>
        <source>The outline of %1 is invalid: repair it first.</source>
        <translation>El contorno de %1 no es válido: repárelo antes.</translation>
    </message>
    <message>
        <source>The line must run inside %1.</source>
        <translation>La línea debe ir por dentro de %1.</translation>
    </message>
    <message>
        <source>A piece of %1 would cross itself or be too narrow: draw another line.</source>
        <translation>Un trozo de %1 se cruzaría o sería demasiado estrecho: dibuje otra línea.</translation>
    </message>
    <message>
        <source>Sew %1 to %2</source>
        <translation>Coser %1 con %2</translation>
    </message>
    <message>
        <source>Sew %1 to %2 stretches in a row</source>
        <translation>Coser %1 con %2 tramos en fila</translation>
    </message>
    <message>
        <source>Flip %1</source>
        <translation>Invertir %1</translation>
    </message>
    <message>
        <source>Flip %1 seams</source>
        <translation>Invertir %1 costuras</translation>
    </message>
    <message>
        <source>Swap the sides of %1</source>
        <translation>Intercambiar los lados de %1</translation>
    </message>
    <message>
        <source>Swap the sides of %1 seams</source>
        <translation>Intercambiar los lados de %1 costuras</translation>
    </message>
    <message>
        <source>Change the continuity of %1 seams</source>
        <translation>Cambiar la continuidad de %1 costuras</translation>
    </message>
    <message>
        <source>Change how %1 seams are matched</source>
        <translation>Cambiar el emparejado de %1 costuras</translation>
    </message>
    <message>
        <source>This stretch has no length: choose two different points.</source>
        <translation>Este tramo no tiene longitud: elija dos puntos distintos.</translation>
    </message>
    <message>
        <source>Move an end of %1</source>
        <translation>Mover un extremo de %1</translation>
    </message>
    <message>
        <source>%1 is already sewn to %2 here: remove that seam first, or take a free stretch.</source>
        <translation>%1 ya está cosida aquí a %2: elimine antes esa costura o tome un tramo libre.</translation>
    </message>
    <message>
        <source>A stretch cannot be sewn to itself: choose two that have no part in common.</source>
        <translation>Un tramo no se puede coser consigo mismo: elija dos sin ninguna parte en común.</translation>
    </message>
    <message>
        <source>Unlink %1 and %2</source>
        <translation>Desvincular %1 y %2</translation>
    </message>
    <message>
        <source>Unlink %1 pairs of twins</source>
        <translation>Desvincular %1 pares de gemelos</translation>
    </message>
    <message>
        <source>Release a point of %1</source>
        <translation>Liberar un punto de %1</translation>
    </message>
    <message>
        <source>Release %2 points of %1</source>
        <translation>Liberar %2 puntos de %1</translation>
    </message>
    <message>
        <source>Re-link a point of %1</source>
        <translation>Volver a vincular un punto de %1</translation>
    </message>
    <message>
        <source>Re-link %2 points of %1</source>
        <translation>Volver a vincular %2 puntos de %1</translation>
    </message>
    <message>
        <source>Change the curve of %1</source>
        <translation>Cambiar la curva de %1</translation>
    </message>
    <message>
        <source>The outline of %1 would cross or touch itself.</source>
        <translation>El contorno de %1 se cruzaría o se tocaría.</translation>
    </message>
    <message>
        <source>The outline of %1 would enclose nothing.</source>
        <translation>El contorno de %1 no encerraría nada.</translation>
    </message>
    <message>
        <source>%1 would not lie inside %2 any more.</source>
        <translation>%1 ya no estaría dentro de %2.</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that is fixed to %2.</source>
        <translation>El tramo se solaparía con otro de %1 que está fijado a %2.</translation>
    </message>
    <message>
        <source>The stretch would overlap the seam of %1 and %2.</source>
        <translation>El tramo se solaparía con la costura de %1 y %2.</translation>
    </message>
    <message>
        <source>The two sides of the seam would overlap.</source>
        <translation>Los dos lados de la costura se solaparían.</translation>
    </message>
    <message>
        <source>Change the length of a stretch of %1</source>
        <translation>Cambiar la longitud de un tramo de %1</translation>
    </message>
    <message>
        <source>Move an end of a fixation of %1</source>
        <translation>Mover un extremo de una fijación de %1</translation>
    </message>
    <message>
        <source>Re-link a seam to its mirror image</source>
        <translation>Volver a vincular una costura a su imagen especular</translation>
    </message>
    <message>
        <source>Release a seam from its mirror image</source>
        <translation>Liberar una costura de su imagen especular</translation>
    </message>
    <message>
        <source>another element had the same number; give this one a number of its own</source>
        <translation>otro elemento tenía el mismo número; dé a este uno propio</translation>
    </message>
    <message>
        <source>Take %1 elements from another version</source>
        <translation>Tomar %1 elementos de otra versión</translation>
    </message>
    <message>
        <source>Take %1 from another version</source>
        <translation>Tomar %1 de otra versión</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is not an ordinary file</source>
        <translation>«%1» no se puede escribir: no es un archivo normal</translation>
    </message>
    <message>
        <source>a file that the design uses cannot be read (%1)</source>
        <translation>no se puede leer un archivo que usa el diseño (%1)</translation>
    </message>
    <message>
        <source>a file of the project cannot be written out (%1)</source>
        <translation>no se puede escribir un archivo del proyecto (%1)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be opened or made</source>
        <translation>«%1» no se puede abrir ni crear</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is in use by another program</source>
        <translation>otro programa está usando «%1»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged (%2)</source>
        <translation>«%1» está dañado (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read or written (%2)</source>
        <translation>«%1» no se puede leer o escribir (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is closed</source>
        <translation>«%1» está cerrado</translation>
    </message>
    <message>
        <source>%1 cannot be stored: it holds a number that is none, or text in an unknown encoding</source>
        <translation>%1 no se puede guardar: contiene un número que no lo es o texto en una codificación desconocida</translation>
    </message>
    <message>
        <source>there is a file &quot;%1&quot; already</source>
        <translation>ya existe un archivo «%1»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no Bolster project</source>
        <translation>«%1» no es un proyecto de Bolster</translation>
    </message>
    <message>
        <source>there is not enough memory for this project</source>
        <translation>no hay memoria suficiente para este proyecto</translation>
    </message>
    <message>
        <source>an edit of the project cannot be read any more</source>
        <translation>una edición del proyecto ya no se puede leer</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name for a file of a project</source>
        <translation>«%1» no es un nombre para un archivo de un proyecto</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was made by a newer Bolster (version %2 of the format, this program knows %3); update the program</source>
        <translation>«%1» se hizo con un Bolster más nuevo (versión %2 del formato, este programa conoce la %3); actualice el programa</translation>
    </message>
    <message>
        <source>&quot;%1&quot; says that it has version %2 of the format, which never was</source>
        <translation>«%1» dice tener la versión %2 del formato, que nunca existió</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the journal of a running program, or of one that crashed, not a project file</source>
        <translation>«%1» es el registro de un programa en marcha o que falló, no un archivo de proyecto</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: it is %2 bytes long and should have %3</source>
        <translation>«%1» está dañado: ocupa %2 bytes y debería ocupar %3</translation>
    </message>
    <message>
        <source>a temporary folder cannot be made (%1)</source>
        <translation>no se puede crear una carpeta temporal (%1)</translation>
    </message>
    <message>
        <source>a temporary file cannot be made (%1)</source>
        <translation>no se puede crear un archivo temporal (%1)</translation>
    </message>
    <message>
        <source>nothing in &quot;%1&quot; can be saved</source>
        <translation>no se puede salvar nada de «%1»</translation>
    </message>
    <message>
        <source>%1 versions were saved</source>
        <translation>se salvaron %1 versiones</translation>
    </message>
    <message>
        <source>lost: versions %1 to %2</source>
        <translation>perdido: versiones %1 a %2</translation>
    </message>
    <message>
        <source>Saved version</source>
        <translation>Versión salvada</translation>
    </message>
    <message>
        <source>version %1 was saved without the edits before it</source>
        <translation>la versión %1 se salvó sin las ediciones anteriores</translation>
    </message>
    <message>
        <source>lost: the names of %1 versions</source>
        <translation>perdido: los nombres de %1 versiones</translation>
    </message>
    <message>
        <source>lost: the file &quot;%1&quot;</source>
        <translation>perdido: el archivo «%1»</translation>
    </message>
    <message>
        <source>the tables of &quot;%1&quot; are not those of a Bolster project</source>
        <translation>las tablas de «%1» no son las de un proyecto de Bolster</translation>
    </message>
    <message>
        <source>a checksum is incomplete</source>
        <translation>una suma de comprobación está incompleta</translation>
    </message>
    <message>
        <source>another window has it</source>
        <translation>lo tiene otra ventana</translation>
    </message>
    <message>
        <source>must be a list of pairs in braces, with patch and fabric</source>
        <translation>debe ser una lista de pares entre llaves, con patch y fabric</translation>
    </message>
    <message>
        <source>must be a pair in braces, with patch and fabric</source>
        <translation>debe ser un par entre llaves, con patch y fabric</translation>
    </message>
    <message>
        <source>there is no colourway %1; the patches show their own fabrics</source>
        <translation>no existe la variante de color %1; las piezas muestran sus propias telas</translation>
    </message>
    <message>
        <source>%1 has a fabric in this colourway already; remove one of the two</source>
        <translation>%1 ya tiene una tela en esta variante de color; elimine una de las dos</translation>
    </message>
    <message>
        <source>what it says of missing patches and fabrics is left out</source>
        <translation>se omite lo que dice de piezas y telas que faltan</translation>
    </message>
    <message>
        <source>Make %1 of %2</source>
        <translation>Hacer %1 de %2</translation>
    </message>
    <message>
        <source>Make %1 patches of %2</source>
        <translation>Hacer %1 piezas de %2</translation>
    </message>
    <message>
        <source>Add colourway %1</source>
        <translation>Añadir variante de color %1</translation>
    </message>
    <message>
        <source>Change what %1 shows</source>
        <translation>Cambiar lo que muestra %1</translation>
    </message>
    <message>
        <source>Change what %1 patches show</source>
        <translation>Cambiar lo que muestran %1 piezas</translation>
    </message>
    <message>
        <source>Show no colourway</source>
        <translation>No mostrar variante de color</translation>
    </message>
    <message>
        <source>Show colourway %1</source>
        <translation>Mostrar variante de color %1</translation>
    </message>
    <message>
        <source>A stretch of %1 that is sewn, fixed or trimmed would have no length.</source>
        <translation>Un tramo de %1 cosido, fijado o con adorno no tendría longitud.</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that has a trim.</source>
        <translation>El tramo se solaparía con otro de %1 que tiene adorno.</translation>
    </message>
    <message>
        <source>Add a trim</source>
        <translation>Añadir un adorno</translation>
    </message>
    <message>
        <source>Move an end of a trim of %1</source>
        <translation>Mover un extremo de un adorno de %1</translation>
    </message>
    <message>
        <source>Change the trim of %1 seams</source>
        <translation>Cambiar el adorno de %1 costuras</translation>
    </message>
    <message>
        <source>Change the trim of %1</source>
        <translation>Cambiar el adorno de %1</translation>
    </message>
    <message>
        <source>A part of this stretch of %1 has a trim already: change that one, or choose another stretch.</source>
        <translation>Una parte de este tramo de %1 ya tiene adorno: cambie ese o elija otro tramo.</translation>
    </message>
    <message>
        <source>Trim the edge of %1</source>
        <translation>Adornar el borde de %1</translation>
    </message>
    <message>
        <source>%1: the file cannot be read any further; it has changed, or its disk is gone</source>
        <translation>%1: el archivo no se puede seguir leyendo; ha cambiado o su disco ya no está</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a picture that can be read; PNG, JPEG, TIFF and OpenEXR can</source>
        <translation>«%1» no es una imagen que se pueda leer; sí PNG, JPEG, TIFF y OpenEXR</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 by %3 pixels, and at most 64 million are read; make the picture smaller in a picture editor</source>
        <translation>«%1» tiene %2 por %3 píxeles y se leen 64 millones como máximo; reduzca la imagen en un editor de imágenes</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a kind of picture whose colours cannot be read; save it as PNG in a picture editor</source>
        <translation>«%1» es un tipo de imagen cuyos colores no se pueden leer; guárdela como PNG en un editor de imágenes</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged or incomplete; copy it again from where it came from, or save it again in a picture editor</source>
        <translation>«%1» está dañado o incompleto; cópielo de nuevo desde su origen o guárdelo de nuevo en un editor de imágenes</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which reads pictures for Bolster, cannot be started; install Bolster again</source>
        <translation>el programa «%1», que lee imágenes para Bolster, no se puede iniciar; vuelva a instalar Bolster</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes too long to read; save it as PNG in a picture editor</source>
        <translation>«%1» tarda demasiado en leerse; guárdelo como PNG en un editor de imágenes</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be decoded: it is damaged or incomplete, or needs too much memory; save it again as PNG in a picture editor</source>
        <translation>«%1» no se puede descodificar: está dañado o incompleto, o necesita demasiada memoria; guárdelo de nuevo como PNG en un editor de imágenes</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this picture</source>
        <translation>%1: no hay memoria suficiente para esta imagen</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this file</source>
        <translation>%1: no hay memoria suficiente para este archivo</translation>
    </message>
    <message>
        <source>%1: the line is too long</source>
        <translation>%1: la línea es demasiado larga</translation>
    </message>
    <message>
        <source>both have a file &quot;%1&quot;, and they are different: save under another name</source>
        <translation>ambos tienen un archivo «%1» y son distintos: guarde con otro nombre</translation>
    </message>
    <message>
        <source>there is another project in the file now</source>
        <translation>ahora hay otro proyecto en el archivo</translation>
    </message>
    <message>
        <source>the last edits are not on the disk yet</source>
        <translation>las últimas ediciones aún no están en el disco</translation>
    </message>
    <message>
        <source>Change the stitching of %1</source>
        <translation>Cambiar el pespunte de %1</translation>
    </message>
    <message>
        <source>Change the piping of %1</source>
        <translation>Cambiar el vivo de %1</translation>
    </message>
    <message>
        <source>Change the seam allowance of %1</source>
        <translation>Cambiar el margen de costura de %1</translation>
    </message>
    <message>
        <source>Change the valley of %1</source>
        <translation>Cambiar el hundimiento de %1</translation>
    </message>
    <message>
        <source>there is no fabric in &quot;%1&quot;</source>
        <translation>no hay ninguna tela en «%1»</translation>
    </message>
    <message>
        <source>the design uses &quot;%1&quot; itself; choose another name</source>
        <translation>el diseño usa «%1»; elija otro nombre</translation>
    </message>
    <message>
        <source>there is not enough memory to show this fabric</source>
        <translation>no hay memoria suficiente para mostrar esta tela</translation>
    </message>
    <message>
        <source>Replace fabric %1 by %2</source>
        <translation>Reemplazar la tela %1 por %2</translation>
    </message>
    <message>
        <source>Change the limits of %1</source>
        <translation>Cambiar los límites de %1</translation>
    </message>
    <message>
        <source>Change the look of %1</source>
        <translation>Cambiar el aspecto de %1</translation>
    </message>
    <message>
        <source>Change the second colour of %1</source>
        <translation>Cambiar el segundo color de %1</translation>
    </message>
    <message>
        <source>Change the kind of %1</source>
        <translation>Cambiar el tipo de %1</translation>
    </message>
    <message>
        <source>there is no place for the files of this project</source>
        <translation>no hay sitio para los archivos de este proyecto</translation>
    </message>
    <message>
        <source>A side of this seam does not end at corners: its length cannot be changed alone.</source>
        <translation>Un lado de esta costura no termina en esquinas: su longitud no se puede cambiar por separado.</translation>
    </message>
    <message>
        <source>These edges cannot have this length: they hang together.</source>
        <translation>Estos bordes no pueden tener esta longitud: dependen unos de otros.</translation>
    </message>
    <message>
        <source>Change the length of an edge of %1</source>
        <translation>Cambiar la longitud de un borde de %1</translation>
    </message>
    <message>
        <source>Change the length of %1 edges</source>
        <translation>Cambiar la longitud de %1 bordes</translation>
    </message>
    <message>
        <source>Make %1 edges equally long</source>
        <translation>Igualar la longitud de %1 bordes</translation>
    </message>
    <message>
        <source>Make the sides of a seam equally long</source>
        <translation>Igualar los lados de una costura</translation>
    </message>
    <message>
        <source>Make the sides of %1 seams equally long</source>
        <translation>Igualar los lados de %1 costuras</translation>
    </message>
    <message>
        <source>There is a &quot;%1&quot; already: this one is called &quot;%2&quot;.</source>
        <translation>Ya existe «%1»: este se llama «%2».</translation>
    </message>
    <message>
        <source>Change the size of %1 patches</source>
        <translation>Cambiar el tamaño de %1 piezas</translation>
    </message>
    <message>
        <source>%1: the rows hold more than the header of the file says; what is too much in each was left out</source>
        <translation>%1: las filas contienen más de lo que dice la cabecera del archivo; lo que sobra en cada una se ha omitido</translation>
    </message>
    <message>
        <source>this changes more at once than can be stored: at most %1 MB, and %2 keys; do it in parts</source>
        <translation>esto cambia de una vez más de lo que se puede guardar: como máximo %1&#xa0;MB y %2 claves; hágalo por partes</translation>
    </message>
    <message>
        <source>&quot;%1&quot; unpacks to more than any project; it was not made by Bolster, or is damaged</source>
        <translation>«%1» ocupa descomprimido más que cualquier proyecto; no lo hizo Bolster o está dañado</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which recovers projects for Bolster, cannot be started; install Bolster again</source>
        <translation>el programa «%1», que recupera proyectos para Bolster, no se puede iniciar; vuelva a instalar Bolster</translation>
    </message>
    <message>
        <source>nothing in &quot;%1&quot; can be saved: it is damaged in a way that takes too much time or memory</source>
        <translation>no se puede salvar nada de «%1»: está tan dañado que exige demasiado tiempo o memoria</translation>
    </message>
    <message>
        <source>lost: the table &quot;%1&quot;, which is missing or has other columns than it should</source>
        <translation>perdido: la tabla «%1», que falta o tiene otras columnas de las que debería</translation>
    </message>
    <message>
        <source>lost: %1 more such gaps</source>
        <translation>perdido: %1 huecos más como estos</translation>
    </message>
    <message>
        <source>what comes after version %1 takes too long to recover</source>
        <translation>recuperar lo que sigue a la versión %1 tarda demasiado</translation>
    </message>
    <message>
        <source>the edit of version %1 does not lead to the design that was kept with it</source>
        <translation>la edición de la versión %1 no conduce al diseño que se conservó con ella</translation>
    </message>
    <message>
        <source>it pushes nothing: no part of the frame lies under the cover</source>
        <translation>no empuja nada: ninguna parte del armazón está bajo la funda</translation>
    </message>
    <message>
        <source>contact looks at the frame in steps of %1 mm; something of these parts is thinner, so that the cover may pass through: %2; make it thicker</source>
        <translation>el contacto mira el armazón en pasos de %1&#xa0;mm; algo de estas partes es más fino, así que la funda puede atravesarlo: %2; hágalo más grueso</translation>
    </message>
    <message>
        <source>contact does nothing: in steps of %1 mm it finds no inside of the frame, which is thinner than that, or so open that it has none; close the frame, or make it thicker</source>
        <translation>el contacto no hace nada: en pasos de %1&#xa0;mm no encuentra ningún interior del armazón, que es más fino o tan abierto que no lo tiene; cierre el armazón o hágalo más grueso</translation>
    </message>
    <message>
        <source>%1 lies in folds: there is more cloth than room for it</source>
        <translation>%1 hace pliegues: hay más tela que sitio para ella</translation>
    </message>
    <message>
        <source>%1 floats free: nothing holds it, and it is sewn to nothing that is held</source>
        <translation>%1 flota libre: nada la sujeta, y no está cosida a nada sujeto</translation>
    </message>
    <message>
        <source>%1 holds the cloth %2 mm off the frame</source>
        <translation>%1 mantiene la tela a %2&#xa0;mm del armazón</translation>
    </message>
    <message>
        <source>The seam of %1 and %2 has %3 % ease: it puckers above %4 %</source>
        <translation>La costura de %1 y %2 tiene un %3&#xa0;% de embebido: por encima del %4&#xa0;% se frunce</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations.</source>
        <translation>La superficie se disparó tras %1 iteraciones.</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations: %2 holds it %3 mm from everything else. Bring that curve nearer.</source>
        <translation>La superficie se disparó tras %1 iteraciones: %2 la sujeta a %3&#xa0;mm de todo lo demás. Acerque esa curva.</translation>
    </message>
    <message>
        <source>The equations of the cover could not be solved: %1 is degenerate or its numbers are too large. Check its outline and its fabric.</source>
        <translation>No se pudieron resolver las ecuaciones de la funda: %1 es degenerada o sus números son demasiado grandes. Revise su contorno y su tela.</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations: the pressure of %2 (%3) is too high for its fabric. Lower it.</source>
        <translation>La superficie se disparó tras %1 iteraciones: la presión de %2 (%3) es demasiado alta para su tela. Bájela.</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations, most likely because of %2. Check the size of that patch, its pressure and its fabric.</source>
        <translation>La superficie se disparó tras %1 iteraciones, muy probablemente por %2. Revise el tamaño de esa pieza, su presión y su tela.</translation>
    </message>
    <message>
        <source>Change the material of %1</source>
        <translation>Cambiar el material de %1</translation>
    </message>
    <message>
        <source>Show a part of %1</source>
        <translation>Mostrar una parte de %1</translation>
    </message>
    <message>
        <source>Hide a part of %1</source>
        <translation>Ocultar una parte de %1</translation>
    </message>
    <message>
        <source>Show all parts of %1</source>
        <translation>Mostrar todas las partes de %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a link to &quot;%2&quot; now</source>
        <translation>«%1» es ahora un enlace a «%2»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was changed by another program</source>
        <translation>otro programa ha modificado «%1»</translation>
    </message>
    <message>
        <source>somebody else has changed &quot;%1&quot; since it was opened here</source>
        <translation>otra persona ha modificado «%1» desde que se abrió aquí</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is another project now</source>
        <translation>«%1» es ahora otro proyecto</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be renamed (%2)</source>
        <translation>no se puede cambiar el nombre de «%1» (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: the content number %2 cannot be read</source>
        <translation>«%1» está dañado: no se puede leer el contenido número %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: a row holds something of another kind than it should</source>
        <translation>«%1» está dañado: una fila contiene algo de otro tipo del que debería</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: row %2 of the table &quot;%3&quot; contradicts others</source>
        <translation>«%1» está dañado: la fila %2 de la tabla «%3» contradice otras</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: parts of the file are not what was written</source>
        <translation>«%1» está dañado: partes del archivo no son lo que se escribió</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: rows are missing, or there are some too many</source>
        <translation>«%1» está dañado: faltan o sobran filas</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: the edits up to number %2 do not lead to the design that was stored with them</source>
        <translation>«%1» está dañado: las ediciones hasta la número %2 no conducen al diseño guardado con ellas</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: row %2 of the table &quot;%3&quot; is not what was written</source>
        <translation>«%1» está dañado: la fila %2 de la tabla «%3» no es lo que se escribió</translation>
    </message>
    <message>
        <source>there is no picture to write</source>
        <translation>no hay ninguna imagen que escribir</translation>
    </message>
    <message>
        <source>%1: a face has %2 corners, and at most %3 are read; have it split into triangles by the program that has made the file</source>
        <translation>%1: una cara tiene %2 vértices y se leen %3 como máximo; divídala en triángulos con el programa que hizo el archivo</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: no file can be made in &quot;%2&quot;; choose another folder</source>
        <translation>«%1» no se puede escribir: no se puede crear ningún archivo en «%2»; elija otra carpeta</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>interrumpido</translation>
    </message>
    <message>
        <source>at most %1 cushions push; this one and those after it are left out</source>
        <translation>empujan como máximo %1 acolchados; este y los siguientes se omiten</translation>
    </message>
    <message>
        <source>the picture cannot be encoded (%1)</source>
        <translation>la imagen no se puede codificar (%1)</translation>
    </message>
    <message>
        <source>a smallest detail of %1 mm is too fine for a frame as large as this (%2 million cubes of it, and %3 are the limit), so the cushion is left out; take at least %4 mm</source>
        <translation>un detalle mínimo de %1&#xa0;mm es demasiado fino para un armazón tan grande (%2 millones de cubos, y el límite son %3), así que el acolchado se omite; use al menos %4&#xa0;mm</translation>
    </message>
    <message>
        <source>something of these parts of the frame is thinner than the smallest detail of the padding, %1 mm, so that it may have gaps there: %2; take a smaller detail</source>
        <translation>algo de estas partes del armazón es más fino que el detalle mínimo del acolchado, %1&#xa0;mm, así que puede tener huecos allí: %2; use un detalle menor</translation>
    </message>
    <message>
        <source>it pushes nothing: with a smallest detail of %1 mm there is no inside of the frame, which is thinner than that, or so open that it has none; take a smaller detail, or close the frame</source>
        <translation>no empuja nada: con un detalle mínimo de %1&#xa0;mm no hay interior del armazón, que es más fino o tan abierto que no lo tiene; use un detalle menor o cierre el armazón</translation>
    </message>
    <message>
        <source>Change the slanted faces of %1</source>
        <translation>Cambiar las caras inclinadas de %1</translation>
    </message>
    <message>
        <source>Change the smallest detail of %1</source>
        <translation>Cambiar el detalle mínimo de %1</translation>
    </message>
    <message>
        <source>the log of &quot;%1&quot; is damaged: the last edits cannot be read</source>
        <translation>el registro de «%1» está dañado: no se pueden leer las últimas ediciones</translation>
    </message>
    <message>
        <source>the kind %1 is unknown; there are %2 and %3</source>
        <translation>el tipo %1 es desconocido; existen %2 y %3</translation>
    </message>
    <message>
        <source>its label finds no room: make the words shorter, or put it elsewhere</source>
        <translation>su etiqueta no cabe: acorte el texto o póngala en otro lugar</translation>
    </message>
    <message>
        <source>its cut lines meet here: make the allowance smaller</source>
        <translation>sus líneas de corte se juntan aquí: reduzca el margen</translation>
    </message>
    <message>
        <source>a notch of %1 mm reaches the sewing line, which is %2 mm away: make it shallower, or the allowance wider</source>
        <translation>un piquete de %1&#xa0;mm llega a la línea de costura, que está a %2&#xa0;mm: hágalo menos profundo o amplíe el margen</translation>
    </message>
    <message>
        <source>nothing is sewn where it is, so it has no partner</source>
        <translation>no hay nada cosido donde está, así que no tiene pareja</translation>
    </message>
    <message>
        <source>it has no partner on the other side of its seam: another notch is too near there</source>
        <translation>no tiene pareja al otro lado de su costura: allí hay otro piquete demasiado cerca</translation>
    </message>
    <message>
        <source>it is %1 mm wide across the grain, but &quot;%2&quot; only %3 mm: split it, or turn its grain</source>
        <translation>mide %1&#xa0;mm a contrahilo, pero «%2» solo %3&#xa0;mm: divídala o gire su sentido del hilo</translation>
    </message>
    <message>
        <source>an inner corner of %1 degrees is too sharp for its seam allowances: make them smaller there, or the corner wider</source>
        <translation>una esquina interior de %1 grados es demasiado aguda para sus márgenes de costura: redúzcalos allí o abra la esquina</translation>
    </message>
    <message>
        <source>There is no such place on an outline.</source>
        <translation>No existe tal lugar en un contorno.</translation>
    </message>
    <message>
        <source>A part of this stretch of %1 has a seam allowance of its own already: change that one, or choose another stretch.</source>
        <translation>Una parte de este tramo de %1 ya tiene un margen de costura propio: cambie ese o elija otro tramo.</translation>
    </message>
    <message>
        <source>There is a notch of %1 at this place already.</source>
        <translation>Ya hay un piquete de %1 en este lugar.</translation>
    </message>
    <message>
        <source>This corner of %1 has a join of its own already.</source>
        <translation>Esta esquina de %1 ya tiene una unión propia.</translation>
    </message>
    <message>
        <source>Change the seam allowance of %1 patches</source>
        <translation>Cambiar el margen de costura de %1 piezas</translation>
    </message>
    <message>
        <source>Change the seam allowance of an edge of %1</source>
        <translation>Cambiar el margen de costura de un borde de %1</translation>
    </message>
    <message>
        <source>Change a corner of the cut line of %1</source>
        <translation>Cambiar una esquina de la línea de corte de %1</translation>
    </message>
    <message>
        <source>Add a notch to %1</source>
        <translation>Añadir un piquete a %1</translation>
    </message>
    <message>
        <source>Move a notch</source>
        <translation>Mover un piquete</translation>
    </message>
    <message>
        <source>Move the join of a corner</source>
        <translation>Mover la unión de una esquina</translation>
    </message>
    <message>
        <source>A drill hole must lie inside its patch.</source>
        <translation>Un taladro debe estar dentro de su pieza.</translation>
    </message>
    <message>
        <source>Move %1 drill holes</source>
        <translation>Mover %1 taladros</translation>
    </message>
    <message>
        <source>Move the label of %1</source>
        <translation>Mover la etiqueta de %1</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that has its own seam allowance.</source>
        <translation>El tramo se solaparía con otro de %1 que tiene margen de costura propio.</translation>
    </message>
    <message>
        <source>Give an edge its own seam allowance</source>
        <translation>Dar a un borde su propio margen de costura</translation>
    </message>
    <message>
        <source>Change a corner of the cut line</source>
        <translation>Cambiar una esquina de la línea de corte</translation>
    </message>
    <message>
        <source>Add drill hole %1</source>
        <translation>Añadir taladro %1</translation>
    </message>
    <message>
        <source>Change the diameter of %1</source>
        <translation>Cambiar el diámetro de %1</translation>
    </message>
    <message>
        <source>Change the notches of %1</source>
        <translation>Cambiar los piquetes de %1</translation>
    </message>
    <message>
        <source>Change the automatic notches</source>
        <translation>Cambiar los piquetes automáticos</translation>
    </message>
    <message>
        <source>Add a notch</source>
        <translation>Añadir un piquete</translation>
    </message>
    <message>
        <source>Change how %1 is cut</source>
        <translation>Cambiar el corte de %1</translation>
    </message>
    <message>
        <source>Change how the pattern is cut</source>
        <translation>Cambiar el corte del patrón</translation>
    </message>
    <message>
        <source>Add internal line %1</source>
        <translation>Añadir línea interior %1</translation>
    </message>
    <message>
        <source>Change the purpose of %1</source>
        <translation>Cambiar la finalidad de %1</translation>
    </message>
    <message>
        <source>Change the ease of %1</source>
        <translation>Cambiar el embebido de %1</translation>
    </message>
    <message>
        <source>is %1, but must be a whole number; %2 are cut</source>
        <translation>es %1, pero debe ser un número entero; se cortan %2</translation>
    </message>
    <message>
        <source>%1 is an allowance of a part of this stretch already; remove one of the two, or make their stretches meet</source>
        <translation>%1 ya es un margen de una parte de este tramo; elimine uno de los dos o haga que sus tramos se toquen</translation>
    </message>
    <message>
        <source>the hole lies outside of &quot;%1&quot;; move it inside</source>
        <translation>el taladro está fuera de «%1»; muévalo adentro</translation>
    </message>
    <message>
        <source>its sides are %1 mm and %2 mm long: true the seam, or say in its properties how much ease is wanted</source>
        <translation>sus lados miden %1&#xa0;mm y %2&#xa0;mm: iguale la costura o indique en sus propiedades cuánto embebido se desea</translation>
    </message>
    <message>
        <source>its sides are %1 mm and %2 mm long, but the second one shall be longer by %3 mm: true the seam, or change the ease in its properties</source>
        <translation>sus lados miden %1&#xa0;mm y %2&#xa0;mm, pero el segundo debe medir %3&#xa0;mm más: iguale la costura o cambie el embebido en sus propiedades</translation>
    </message>
    <message>
        <source>The mouth of a dart must be at least 1 mm wide.</source>
        <translation>La abertura de una pinza debe medir al menos 1&#xa0;mm.</translation>
    </message>
    <message>
        <source>The tip of a dart must lie inside its patch, at least 5 mm from its mouth.</source>
        <translation>El vértice de una pinza debe estar dentro de su pieza, al menos a 5&#xa0;mm de su abertura.</translation>
    </message>
    <message>
        <source>The legs of the dart would cross the outline of %1: put its tip elsewhere.</source>
        <translation>Los lados de la pinza cruzarían el contorno de %1: ponga el vértice en otro lugar.</translation>
    </message>
    <message>
        <source>Add a dart to %1</source>
        <translation>Añadir una pinza a %1</translation>
    </message>
    <message>
        <source>Select the seam of a dart.</source>
        <translation>Seleccione la costura de una pinza.</translation>
    </message>
    <message>
        <source>Without this dart the outline of %1 would cross itself.</source>
        <translation>Sin esta pinza el contorno de %1 se cruzaría.</translation>
    </message>
    <message>
        <source>Move a dart of %1</source>
        <translation>Mover una pinza de %1</translation>
    </message>
    <message>
        <source>there is no piece in it</source>
        <translation>no contiene ninguna pieza</translation>
    </message>
    <message>
        <source>Import a pattern of %1 pieces</source>
        <translation>Importar un patrón de %1 piezas</translation>
    </message>
    <message>
        <source>%1 is left out: its outline crosses itself or encloses nothing</source>
        <translation>%1 se omite: su contorno se cruza o no encierra nada</translation>
    </message>
    <message>
        <source>%1: %2 notches or lines belong to nothing and are left out</source>
        <translation>%1: %2 piquetes o líneas no pertenecen a nada y se omiten</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 points)</source>
        <translation>%1: hay dibujado más de lo que puede tener un patrón (más de %2 puntos)</translation>
    </message>
    <message>
        <source>%1: the file is larger than a pattern can be (%2 MB)</source>
        <translation>%1: el archivo es mayor de lo que puede ser un patrón (%2&#xa0;MB)</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a group code of DXF</source>
        <translation>%1: «%2» no es un código de grupo de DXF</translation>
    </message>
    <message>
        <source>%1: the file ends in the middle of something</source>
        <translation>%1: el archivo termina en medio de algo</translation>
    </message>
    <message>
        <source>%1 is not a DXF file: it has no sections</source>
        <translation>%1 no es un archivo DXF: no tiene secciones</translation>
    </message>
    <message>
        <source>%1 is not an SVG file</source>
        <translation>%1 no es un archivo SVG</translation>
    </message>
    <message>
        <source>%1: this is not well-formed XML (%2)</source>
        <translation>%1: esto no es XML bien formado (%2)</translation>
    </message>
    <message>
        <source>Sew %1 proposed seams</source>
        <translation>Coser %1 costuras propuestas</translation>
    </message>
    <message>
        <source>Remove a dart of %1</source>
        <translation>Eliminar una pinza de %1</translation>
    </message>
    <message>
        <source>Move the tip of a dart of %1</source>
        <translation>Mover el vértice de una pinza de %1</translation>
    </message>
    <message>
        <source>Opened there, the outline of %1 would cross itself.</source>
        <translation>Abierto allí, el contorno de %1 se cruzaría.</translation>
    </message>
    <message>
        <source>The legs of the dart must be of one length to be rotated: drag its tip onto the dotted line.</source>
        <translation>Para trasladar la pinza, sus lados deben medir lo mismo: arrastre su vértice a la línea de puntos.</translation>
    </message>
    <message>
        <source>A dart is rotated to a place at least 5 mm from its mouth.</source>
        <translation>Una pinza se traslada a un lugar situado al menos a 5&#xa0;mm de su abertura.</translation>
    </message>
    <message>
        <source>The line from the tip of the dart to there would leave %1.</source>
        <translation>La línea del vértice de la pinza hasta allí saldría de %1.</translation>
    </message>
    <message>
        <source>%1 lies across the line from the tip of the dart to there: move it, or rotate the dart elsewhere.</source>
        <translation>%1 está atravesado en la línea del vértice de la pinza hasta allí: muévalo o traslade la pinza a otro lugar.</translation>
    </message>
    <message>
        <source>Rotate a dart of %1</source>
        <translation>Trasladar una pinza de %1</translation>
    </message>
    <message>
        <source>Smooth outlines across ends of seams</source>
        <translation>Suavizar contornos en los finales de costura</translation>
    </message>
    <message>
        <source>This seam ends in no corners: there is nothing to smooth.</source>
        <translation>Esta costura no termina en esquinas: no hay nada que suavizar.</translation>
    </message>
    <message>
        <source>The outlines meet at more than 60° there: that is a corner, and stays one.</source>
        <translation>Los contornos se encuentran allí a más de 60°: eso es una esquina, y se queda.</translation>
    </message>
    <message>
        <source>Sew earlier</source>
        <translation>Coser antes</translation>
    </message>
    <message>
        <source>Sew later</source>
        <translation>Coser después</translation>
    </message>
    <message>
        <source>Sew in the proposed order</source>
        <translation>Coser en el orden propuesto</translation>
    </message>
    <message>
        <source>Change the zip of %1</source>
        <translation>Cambiar la cremallera de %1</translation>
    </message>
    <message>
        <source>Change when %1 is sewn</source>
        <translation>Cambiar cuándo se cose %1</translation>
    </message>
    <message>
        <source>its sides have allowances of %1 mm and %2 mm: make them alike, or mind it when they are laid together</source>
        <translation>sus lados tienen márgenes de %1&#xa0;mm y %2&#xa0;mm: iguálelos o téngalo en cuenta al superponerlos</translation>
    </message>
    <message>
        <source>This edge of %1 is not as long as that.</source>
        <translation>Este borde de %1 no es tan largo.</translation>
    </message>
    <message>
        <source>the pattern is so large that the edge length of its triangles becomes %1 mm; is the unit right?</source>
        <translation>el patrón es tan grande que la longitud de arista de sus triángulos pasa a ser %1&#xa0;mm; ¿es correcta la unidad?</translation>
    </message>
    <message>
        <source>%1 is left out: it is %2 m large, the most is %3 m; is the unit right?</source>
        <translation>%1 se omite: mide %2&#xa0;m y el máximo son %3&#xa0;m; ¿es correcta la unidad?</translation>
    </message>
    <message>
        <source>%1 is left out: its outline has fewer than three points</source>
        <translation>%1 se omite: su contorno tiene menos de tres puntos</translation>
    </message>
    <message>
        <source>%1 is left out: of the %2 points of its outline no curve with at most %3 can be made</source>
        <translation>%1 se omite: con los %2 puntos de su contorno no se puede hacer una curva de %3 como máximo</translation>
    </message>
    <message>
        <source>%1: its outline has more than %2 points and is simplified, by %3 mm at most</source>
        <translation>%1: su contorno tiene más de %2 puntos y se simplifica, %3&#xa0;mm como máximo</translation>
    </message>
    <message>
        <source>%1: its quantity &quot;%2&quot; is no number of pieces; it is cut once until somebody says how often</source>
        <translation>%1: su cantidad «%2» no es un número de piezas; se corta una vez hasta que alguien diga cuántas</translation>
    </message>
    <message>
        <source>%1: its quantity %2 is more than possible and becomes %3</source>
        <translation>%1: su cantidad %2 es mayor de lo posible y pasa a ser %3</translation>
    </message>
    <message>
        <source>%1: %2 drill holes are narrower than %3 mm or wider than %4 mm and become as wide as possible</source>
        <translation>%1: %2 taladros miden menos de %3&#xa0;mm o más de %4&#xa0;mm y pasan a la medida posible</translation>
    </message>
    <message>
        <source>%1 is left out: it would be a patch with mistakes</source>
        <translation>%1 se omite: sería una pieza con errores</translation>
    </message>
    <message>
        <source>%1: the file ends in the middle of its section %2, so it is not whole; get it once more</source>
        <translation>%1: el archivo termina en medio de su sección %2, así que no está entero; consígalo de nuevo</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 groups)</source>
        <translation>%1: hay dibujado más de lo que puede tener un patrón (más de %2 grupos)</translation>
    </message>
    <message>
        <source>%1: %2 is larger than any pattern (%3)</source>
        <translation>%1: %2 es mayor que cualquier patrón (%3)</translation>
    </message>
    <message>
        <source>the mark at the end of the file (EOF) is missing: look whether everything is there</source>
        <translation>falta la marca de fin de archivo (EOF): compruebe si está todo</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is inserted more often than a pattern needs (over %3 times)</source>
        <translation>%1: «%2» se inserta más veces de las que necesita un patrón (más de %3)</translation>
    </message>
    <message>
        <source>%1: an element has more than %2 attributes</source>
        <translation>%1: un elemento tiene más de %2 atributos</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 elements)</source>
        <translation>%1: hay dibujado más de lo que puede tener un patrón (más de %2 elementos)</translation>
    </message>
    <message>
        <source>%1: elements lie in each other more than %2 times</source>
        <translation>%1: hay elementos anidados más de %2 veces</translation>
    </message>
    <message>
        <source>&quot;%1&quot; would be replaced, which is needed; choose another name</source>
        <translation>se reemplazaría «%1», que hace falta; elija otro nombre</translation>
    </message>
    <message>
        <source>there is no cover yet: nothing is sewn or solved</source>
        <translation>aún no hay funda: no hay nada cosido o calculado</translation>
    </message>
    <message>
        <source>there is not enough memory for this file</source>
        <translation>no hay memoria suficiente para este archivo</translation>
    </message>
    <message>
        <source>the cover cannot be made a file (%1)</source>
        <translation>no se puede hacer un archivo con la funda (%1)</translation>
    </message>
    <message>
        <source>the cover is %1 mm thick and has %2 cm³</source>
        <translation>la funda tiene un grosor de %1&#xa0;mm y %2&#xa0;cm³</translation>
    </message>
    <message>
        <source>there is no room for foam between the frame and the cover</source>
        <translation>no hay sitio para espuma entre el armazón y la funda</translation>
    </message>
    <message>
        <source>the foam has %1 l and weighs %2 kg at %3 kg/m³</source>
        <translation>la espuma tiene %1&#xa0;l y pesa %2&#xa0;kg a %3&#xa0;kg/m³</translation>
    </message>
    <message>
        <source>there are neither fixation curves nor seams</source>
        <translation>no hay ni curvas de fijación ni costuras</translation>
    </message>
    <message>
        <source>The three places lie on a line: choose some that do not.</source>
        <translation>Los tres lugares están en una recta: elija otros.</translation>
    </message>
    <message>
        <source>The places are not as far from each other on the scan as where they belong: check the scale of the scan, and which is which.</source>
        <translation>Los lugares no están tan separados en el escaneo como allí donde deben ir: revise la escala del escaneo y cuál es cuál.</translation>
    </message>
    <message>
        <source>The scan could not be aligned: there are not enough of its points where it would stand. Click other places, or bring back what is cut away of it.</source>
        <translation>No se pudo alinear el escaneo: donde quedaría no hay bastantes de sus puntos. Haga clic en otros lugares o recupere lo recortado.</translation>
    </message>
    <message>
        <source>%1: the numbers of &quot;%2&quot; are not described as they must be: &quot;%3&quot;</source>
        <translation>%1: los números de «%2» no están descritos como deben: «%3»</translation>
    </message>
    <message>
        <source>%1: the file is damaged: something is said to be at byte %2, where nothing can be; copy it again, or export the scan anew</source>
        <translation>%1: el archivo está dañado: algo debería estar en el byte %2, donde no puede haber nada; cópielo de nuevo o vuelva a exportar el escaneo</translation>
    </message>
    <message>
        <source>%1: the file is damaged: a checksum is wrong; copy it again, or export the scan anew</source>
        <translation>%1: el archivo está dañado: una suma de comprobación es incorrecta; cópielo de nuevo o vuelva a exportar el escaneo</translation>
    </message>
    <message>
        <source>%1 is not an E57 file</source>
        <translation>%1 no es un archivo E57</translation>
    </message>
    <message>
        <source>%1: E57 of version %2 cannot be read, or its pages have another size than 1024; export the scan as E57 1.0</source>
        <translation>%1: no se puede leer E57 de la versión %2, o sus páginas no tienen el tamaño 1024; exporte el escaneo como E57 1.0</translation>
    </message>
    <message>
        <source>%1: the pose of a scan is no rotation and translation</source>
        <translation>%1: la posición de un escaneo no es una rotación y traslación</translation>
    </message>
    <message>
        <source>%1: two scans are said to be at one place of the file; export them anew</source>
        <translation>%1: dos escaneos estarían en el mismo lugar del archivo; vuelva a exportarlos</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; of the points is missing or no number of things</source>
        <translation>%1: «%2» de los puntos falta o no es una cantidad</translation>
    </message>
    <message>
        <source>%1: the file is damaged: a packet of points is not as it must be; export the scan anew</source>
        <translation>%1: el archivo está dañado: un paquete de puntos no es como debe; vuelva a exportar el escaneo</translation>
    </message>
    <message>
        <source>%1: the points are packed by &quot;%2&quot;, which cannot be read; export the scan without an extension</source>
        <translation>%1: los puntos están empaquetados con «%2», que no se puede leer; exporte el escaneo sin extensión</translation>
    </message>
    <message>
        <source>%1: more is described in it than a scan can have</source>
        <translation>%1: describe más de lo que puede tener un escaneo</translation>
    </message>
    <message>
        <source>%1: numbers that belong to one point lie too far from each other; export the scan anew</source>
        <translation>%1: los números de un mismo punto están demasiado separados; vuelva a exportar el escaneo</translation>
    </message>
    <message>
        <source>%1: a document type is not expected here</source>
        <translation>%1: no se espera aquí un tipo de documento</translation>
    </message>
    <message>
        <source>%1 is not a LAS file</source>
        <translation>%1 no es un archivo LAS</translation>
    </message>
    <message>
        <source>%1 is compressed (LAZ), which cannot be read: save it as LAS, for example with laszip or CloudCompare, or as E57</source>
        <translation>%1 está comprimido (LAZ) y no se puede leer: guárdelo como LAS, por ejemplo con laszip o CloudCompare, o como E57</translation>
    </message>
    <message>
        <source>%1: points of format %2 with %3 bytes cannot be read; save them as LAS 1.2 or 1.4</source>
        <translation>%1: no se pueden leer puntos de formato %2 con %3 bytes; guárdelos como LAS 1.2 o 1.4</translation>
    </message>
    <message>
        <source>%1: its scale and offset make no points</source>
        <translation>%1: su escala y su desplazamiento no dan puntos</translation>
    </message>
    <message>
        <source>%1: the points are said to begin within the header</source>
        <translation>%1: los puntos empezarían dentro de la cabecera</translation>
    </message>
    <message>
        <source>The second side ends inside an edge, so the first one was changed.</source>
        <translation>El segundo lado termina dentro de un borde, así que se cambió el primero.</translation>
    </message>
    <message>
        <source>it has no triangle with an area</source>
        <translation>no tiene ningún triángulo con área</translation>
    </message>
    <message>
        <source>%1 is left out: laid flat it would lie over itself. Divide it, or cut it in where it bulges most</source>
        <translation>%1 se omite: aplanado quedaría sobre sí mismo. Divídalo o córtelo donde más se abomba</translation>
    </message>
    <message>
        <source>the stretch does not lie on its outline any more. Sew or fix it anew.</source>
        <translation>el tramo ya no está en su contorno. Cósalo o fíjelo de nuevo.</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which reads such files for Bolster, cannot be started; install Bolster again</source>
        <translation>el programa «%1», que lee estos archivos para Bolster, no se puede iniciar; vuelva a instalar Bolster</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes too long to read; export fewer parts of it, or triangles (OBJ, STL) instead</source>
        <translation>«%1» tarda demasiado en leerse; exporte menos partes o, en su lugar, triángulos (OBJ, STL)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be read: it is damaged, or needs too much memory; export it again, or fewer parts of it, from the program that it comes from</source>
        <translation>«%1» no se pudo leer: está dañado o necesita demasiada memoria; expórtelo de nuevo, o menos partes, desde el programa de origen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds no faces, and a frame needs some; export bodies or surfaces, not lines and points alone</source>
        <translation>«%1» no contiene caras y un armazón las necesita; exporte cuerpos o superficies, no solo líneas y puntos</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than %2 triangles; export fewer parts of it, or coarser</source>
        <translation>«%1» tiene más de %2 triángulos; exporte menos partes o con menos detalle</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than %2 parts; export those that the cover touches</source>
        <translation>«%1» tiene más de %2 partes; exporte las que toca la funda</translation>
    </message>
    <message>
        <source>%1: the part &quot;%2&quot; reaches beyond 10,000,000; export it without that part, or near the origin</source>
        <translation>%1: la parte «%2» supera 10&#xa0;000&#xa0;000; exporte sin esa parte o cerca del origen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs the file &quot;%2&quot; in its own folder; copy it there, or export as GLB, which is one file</source>
        <translation>«%1» necesita el archivo «%2» en su misma carpeta; cópielo allí o exporte como GLB, que es un solo archivo</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged or incomplete, or not what its ending says; export it again from the program that it comes from</source>
        <translation>«%1» está dañado o incompleto, o no es lo que dice su extensión; expórtelo de nuevo desde el programa de origen</translation>
    </message>
    <message>
        <source>%1: %2 triangles are left out: their corners are no numbers</source>
        <translation>%1: se omiten %2 triángulos: sus vértices no son números</translation>
    </message>
    <message>
        <source>%1: parts are left out that are scaled to nothing: %2, the first is &quot;%3&quot;</source>
        <translation>%1: se omiten partes reducidas a nada por su escala: %2, la primera es «%3»</translation>
    </message>
    <message>
        <source>%1: %2 faces could not be made triangles of, and leave holes</source>
        <translation>%1: %2 caras no se pudieron dividir en triángulos y dejan agujeros</translation>
    </message>
    <message>
        <source>%1: %2 parts are left out that lie too deep in the tree</source>
        <translation>%1: se omiten %2 partes situadas demasiado hondo en el árbol</translation>
    </message>
    <message>
        <source>%1: the parts in the file &quot;%2&quot; are not read; export all in one file</source>
        <translation>%1: las partes del archivo «%2» no se leen; exporte todo en un solo archivo</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no file that frames are written to; OBJ, PLY and STL are</source>
        <translation>en «%1» no se pueden escribir armazones; sí en OBJ, PLY y STL</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a scan that can be read; these can: %2</source>
        <translation>«%1» no es un escaneo que se pueda leer; estos sí: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a frame that can be read; these can: %2</source>
        <translation>«%1» no es un armazón que se pueda leer; estos sí: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a pattern that can be read; these can: %2</source>
        <translation>«%1» no es un patrón que se pueda leer; estos sí: %2</translation>
    </message>
    <message>
        <source>nothing is left of the parts that are wanted</source>
        <translation>no queda nada de las partes deseadas</translation>
    </message>
    <message>
        <source>nothing is sewn where %1 of its notches are, so they have no partners</source>
        <translation>no hay nada cosido donde están %1 de sus piquetes, así que no tienen pareja</translation>
    </message>
    <message>
        <source>notches at edges without an allowance cut into the piece: there are %1; give these edges an allowance</source>
        <translation>los piquetes en bordes sin margen cortan la pieza: hay %1; dé un margen a estos bordes</translation>
    </message>
    <message>
        <source>There is a dart already: put this one beside it, or remove that one first.</source>
        <translation>Ya hay una pinza: ponga esta al lado o elimine antes aquella.</translation>
    </message>
    <message>
        <source>%1 is left out: with its holes, notches and lines the design would have more than %2 elements</source>
        <translation>%1 se omite: con sus taladros, piquetes y líneas el diseño tendría más de %2 elementos</translation>
    </message>
    <message>
        <source>%1: its nap &quot;%2&quot; is neither one way, two ways nor any; it is taken for two ways</source>
        <translation>%1: su pelo «%2» no es ni de un sentido, ni de dos, ni cualquiera; se toma como de dos sentidos</translation>
    </message>
    <message>
        <source>%1 is drawn larger by what its fabric shrinks (%2), and taken as it is drawn: a shrinkage of the fabric here would come on top</source>
        <translation>%1 está dibujado más grande por lo que encoge su tela (%2) y se toma como está: un encogimiento de la tela aquí se sumaría</translation>
    </message>
    <message>
        <source>the viewBox &quot;%1&quot; is no four numbers and is left out: check the size of the pieces</source>
        <translation>la viewBox «%1» no son cuatro números y se omite: revise el tamaño de las piezas</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs the file &quot;%2&quot; beside it, and the frame of a design is one file; import it again, or export it as GLB</source>
        <translation>«%1» necesita el archivo «%2» a su lado y el armazón de un diseño es un solo archivo; impórtelo de nuevo o expórtelo como GLB</translation>
    </message>
    <message>
        <source>99 % of its surface is within %1 mm</source>
        <translation>el 99&#xa0;% de su superficie está dentro de %1&#xa0;mm</translation>
    </message>
    <message>
        <source>it reaches beyond its piece: end it at the edge</source>
        <translation>sobresale de su pieza: termínela en el borde</translation>
    </message>
    <message>
        <source>the hole breaks through the edge of its piece: move it inwards, or make it smaller</source>
        <translation>el taladro rompe el borde de su pieza: muévalo hacia dentro o redúzcalo</translation>
    </message>
    <message>
        <source>only %1 mm are left of the piece at the tip of a dart: make it shorter</source>
        <translation>solo quedan %1&#xa0;mm de pieza en el vértice de una pinza: acórtela</translation>
    </message>
    <message>
        <source>%1 of its notches have no partners on the other sides of their seams: others are too near there. Ask for fewer</source>
        <translation>%1 de sus piquetes no tienen pareja al otro lado de sus costuras: hay otros demasiado cerca. Pida menos</translation>
    </message>
    <message>
        <source>%1 has %2 sewing lines beside each other; the largest is taken, the others are left out</source>
        <translation>%1 tiene %2 líneas de costura una junto a otra; se toma la mayor y las demás se omiten</translation>
    </message>
    <message>
        <source>%1: its cut line lies %2 mm outside of its sewing line, which is wider than an allowance may be; it becomes %3 mm there</source>
        <translation>%1: su línea de corte está %2&#xa0;mm por fuera de su línea de costura, más de lo que admite un margen; allí pasa a ser %3&#xa0;mm</translation>
    </message>
    <message>
        <source>The cover is pulled to the scan where it lies now: switch &quot;Fit the cover to it&quot; off, place it, and switch that on again.</source>
        <translation>La funda es atraída hacia donde está ahora el escaneo: desactive «Adaptar la funda a él», colóquelo y vuelva a activarlo.</translation>
    </message>
    <message>
        <source>Place on the cover to %2 mm rms: %1 (%3 % of its points matched)</source>
        <translation>Colocar sobre la funda con %2&#xa0;mm RMS: %1 (emparejado el %3&#xa0;% de sus puntos)</translation>
    </message>
    <message>
        <source>The scan could not be placed: it is too far from the cover. Align it by three places, or cut away what does not belong to it.</source>
        <translation>No se pudo colocar el escaneo: está demasiado lejos de la funda. Alinéelo con tres lugares o recorte lo que no le pertenece.</translation>
    </message>
    <message>
        <source>Align to %2 mm rms: %1 (%3 % of its points matched)</source>
        <translation>Alinear con %2&#xa0;mm RMS: %1 (emparejado el %3&#xa0;% de sus puntos)</translation>
    </message>
    <message>
        <source>Import the pattern of %1</source>
        <translation>Importar el patrón de %1</translation>
    </message>
    <message>
        <source>%1: a gap of %2 mm in its outline is closed by a straight line</source>
        <translation>%1: un hueco de %2&#xa0;mm en su contorno se cierra con una recta</translation>
    </message>
    <message>
        <source>%1: its cut line is drawn anew from its allowances, and differs from that of the file by up to %2 mm</source>
        <translation>%1: su línea de corte se dibuja de nuevo a partir de sus márgenes y difiere de la del archivo hasta %2&#xa0;mm</translation>
    </message>
    <message>
        <source>the size &quot;%1&quot; of the page is in no unit that is known and is left out: check the size of the pieces</source>
        <translation>el tamaño «%1» de la página no tiene una unidad conocida y se omite: revise el tamaño de las piezas</translation>
    </message>
    <message>
        <source>Sew a proposed seam</source>
        <translation>Coser una costura propuesta</translation>
    </message>
    <message>
        <source>it is in %1 pieces</source>
        <translation>consta de %1 trozos</translation>
    </message>
    <message>
        <source>one piece of less than 1 cm³ is left out</source>
        <translation>se omite un trozo de menos de 1&#xa0;cm³</translation>
    </message>
    <message>
        <source>%1 pieces of less than 1 cm³ are left out</source>
        <translation>se omiten %1 trozos de menos de 1&#xa0;cm³</translation>
    </message>
    <message>
        <source>Change whether the cover fits %1</source>
        <translation>Cambiar si la funda se adapta a %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs too much memory: it has too many parts, or places them too often; export those that the cover touches</source>
        <translation>«%1» necesita demasiada memoria: tiene demasiadas partes o las repite demasiado; exporte las que toca la funda</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has decimal commas; export it with decimal points</source>
        <translation>«%1» tiene comas decimales; expórtelo con puntos decimales</translation>
    </message>
    <message>
        <source>%1: triangles are left out that name points which are not in the file</source>
        <translation>%1: se omiten triángulos que remiten a puntos que no están en el archivo</translation>
    </message>
    <message>
        <source>%1: %2 triangles are left out: they name points that are not in the file</source>
        <translation>%1: se omiten %2 triángulos: remiten a puntos que no están en el archivo</translation>
    </message>
    <message>
        <source>%1: none of its %2 points has a place</source>
        <translation>%1: ninguno de sus %2 puntos tiene lugar</translation>
    </message>
    <message>
        <source>%1: %2 points are left out: they have no place, as where a scanner saw nothing</source>
        <translation>%1: se omiten %2 puntos: no tienen lugar, como donde un escáner no vio nada</translation>
    </message>
    <message>
        <source>%1 is text in UTF-16, which is not read; save it as UTF-8</source>
        <translation>%1 es texto en UTF-16, que no se lee; guárdelo como UTF-8</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; has a decimal comma; export with decimal points</source>
        <translation>%1: «%2» tiene una coma decimal; exporte con puntos decimales</translation>
    </message>
    <message>
        <source>Make the pattern of a form</source>
        <translation>Hacer el patrón de una forma</translation>
    </message>
    <message>
        <source>Fit the pattern to a goal</source>
        <translation>Adaptar el patrón a un objetivo</translation>
    </message>
    <message>
        <source>it has %1 triangles, and cannot be made simpler</source>
        <translation>tiene %1 triángulos y no se puede simplificar</translation>
    </message>
    <message>
        <source>The form has %1 triangles; %2 stand for it, which are up to %3 mm off</source>
        <translation>La forma tiene %1 triángulos; la representan %2, con una diferencia de hasta %3&#xa0;mm</translation>
    </message>
    <message>
        <source>%1 ends inside a piece, at %2: it is cut in there like a dart. The next line or border is %3 mm away; draw it on to there to divide the piece</source>
        <translation>%1 termina dentro de una pieza, en %2: allí se corta como una pinza. La línea o el borde siguiente está a %3&#xa0;mm; prolónguela hasta allí para dividir la pieza</translation>
    </message>
    <message>
        <source>No place of the cover is near the form: put it where the cover is, in millimetres.</source>
        <translation>Ningún punto de la funda está cerca de la forma: póngala donde está la funda, en milímetros.</translation>
    </message>
    <message>
        <source>Nothing that may change does anything to the cover.</source>
        <translation>Nada de lo que puede cambiar afecta a la funda.</translation>
    </message>
    <message>
        <source>A step would have turned the outline of %1 over itself; a smaller one was taken</source>
        <translation>Un paso habría plegado el contorno de %1 sobre sí mismo; se dio uno menor</translation>
    </message>
    <message>
        <source>Nothing may change.</source>
        <translation>Nada puede cambiar.</translation>
    </message>
    <message>
        <source>The cover does not come to rest.</source>
        <translation>La funda no llega al reposo.</translation>
    </message>
    <message>
        <source>Make %1 longer by %3 mm where it is sewn to %2</source>
        <translation>Alargar %1 %3&#xa0;mm donde está cosido a %2</translation>
    </message>
    <message>
        <source>Make %1 shorter by %3 mm where it is sewn to %2</source>
        <translation>Acortar %1 %3&#xa0;mm donde está cosido a %2</translation>
    </message>
    <message>
        <source>Move the seam of %1 and %2 by %3 mm into %2</source>
        <translation>Mover la costura de %1 y %2 %3&#xa0;mm hacia %2</translation>
    </message>
    <message>
        <source>Move the seam of %1 and %2 by %3 mm into %1</source>
        <translation>Mover la costura de %1 y %2 %3&#xa0;mm hacia %1</translation>
    </message>
    <message>
        <source>Let out the corner of %1 at %2 by %3 mm</source>
        <translation>Soltar la esquina de %1 en %2 %3&#xa0;mm</translation>
    </message>
    <message>
        <source>Take in the corner of %1 at %2 by %3 mm</source>
        <translation>Meter la esquina de %1 en %2 %3&#xa0;mm</translation>
    </message>
    <message>
        <source>Cut a dart into %1 at %2, %3 mm wide and %4 mm deep</source>
        <translation>Cortar una pinza en %1 en %2, de %3&#xa0;mm de ancho y %4&#xa0;mm de profundidad</translation>
    </message>
    <message>
        <source>Make the seam of %1 and %2 smooth</source>
        <translation>Suavizar la costura de %1 y %2</translation>
    </message>
    <message>
        <source>Let the seam of %1 and %2 be sharp</source>
        <translation>Dejar marcada la costura de %1 y %2</translation>
    </message>
    <message>
        <source>it is no file of preferences: it breaks off or has a mistake at character %1; choose one that Bolster has exported</source>
        <translation>no es un archivo de preferencias: se interrumpe o tiene un error en el carácter %1; elija uno que haya exportado Bolster</translation>
    </message>
    <message>
        <source>it is no file of preferences; choose one that Bolster has exported</source>
        <translation>no es un archivo de preferencias; elija uno que haya exportado Bolster</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be what it is there; remove that line from the file, or export it again</source>
        <translation>«%1» no puede tener el valor que tiene ahí; quite esa línea del archivo o expórtelo de nuevo</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, where a portable Bolster keeps settings and work, cannot be written; copy its folder to where you may write</source>
        <translation>«%1», donde un Bolster portátil guarda los ajustes y el trabajo, no se puede escribir; copie la carpeta de Bolster a un lugar donde pueda escribir</translation>
    </message>
    <message>
        <source>the disk with &quot;%1&quot; is full; make room on it, and change a setting once more: all of them are kept then</source>
        <translation>el disco con «%1» está lleno; libere espacio y cambie otra vez un ajuste: entonces se conservan todos</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be written; give yourself the right to write there and in its folder, and change a setting once more: all of them are kept then</source>
        <translation>no se pudo escribir «%1»; concédase el derecho de escribir ahí y en su carpeta y cambie otra vez un ajuste: entonces se conservan todos</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands there twice; remove one of its lines from the file, or export it again</source>
        <translation>«%1» aparece ahí dos veces; quite una de las líneas del archivo o expórtelo de nuevo</translation>
    </message>
    <message>
        <source>Change the note of %1</source>
        <translation>Cambiar la nota de %1</translation>
    </message>
    <message>
        <source>Add measurement %1</source>
        <translation>Añadir medida %1</translation>
    </message>
    <message>
        <source>it does not lie in &quot;%1&quot; any more; measure anew</source>
        <translation>ya no está en «%1»; mida de nuevo</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; holds other files: choose one of its own.</source>
        <translation>La carpeta «%1» contiene otros archivos: elija una propia.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; holds the work of another design or of other options: choose another folder.</source>
        <translation>La carpeta «%1» contiene el trabajo de otro diseño o de otras opciones: elija otra carpeta.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be made (%2).</source>
        <translation>No se puede crear la carpeta «%1» (%2).</translation>
    </message>
    <message>
        <source>Remove %1 and what needs it (%2 elements)</source>
        <translation>Quitar %1 y lo que lo necesita (%2 elementos)</translation>
    </message>
    <message>
        <source>one version was saved</source>
        <translation>Se recuperó una versión</translation>
    </message>
    <message>
        <source>%1: none of its triangles has an area</source>
        <translation>%1: ninguno de sus triángulos tiene área</translation>
    </message>
    <message>
        <source>Where a piece would have had a hole or been a ring it is cut and sewn again, number of cuts: %1</source>
        <translation>Donde una pieza tendría un agujero o sería un anillo se corta y se vuelve a coser, número de cortes: %1</translation>
    </message>
    <message>
        <source>%1 is stretched by %2 % along the grain, its fabric allows %3 %</source>
        <translation>%1 está estirada un %2&#xa0;% al hilo; su tela admite un %3&#xa0;%</translation>
    </message>
    <message>
        <source>%1 is stretched by %2 % across the grain, its fabric allows %3 %</source>
        <translation>%1 está estirada un %2&#xa0;% a contrahilo; su tela admite un %3&#xa0;%</translation>
    </message>
    <message>
        <source>%1 is sheared by %2 %, its fabric allows %3 %</source>
        <translation>%1 tiene una cizalladura del %2&#xa0;%; su tela admite un %3&#xa0;%</translation>
    </message>
    <message>
        <source>The form has one side only, as a twisted band: it is left open where its outside meets its inside</source>
        <translation>La forma tiene una sola cara, como una banda retorcida: queda abierta donde su exterior se junta con su interior</translation>
    </message>
    <message>
        <source>Parts of %1 that are shorter than a mesh edge have gone with the cut.</source>
        <translation>Las partes de %1 más cortas que una arista de la malla han desaparecido con el corte.</translation>
    </message>
    <message>
        <source>the usual value is used instead</source>
        <translation>en su lugar se usa el valor habitual</translation>
    </message>
    <message>
        <source>it is the project that is open here; choose another name</source>
        <translation>es el proyecto que está abierto aquí; elija otro nombre</translation>
    </message>
    <message>
        <source>the file is empty; nothing was written to it, or it was lost</source>
        <translation>el archivo está vacío; no se escribió nada en él, o se perdió</translation>
    </message>
    <message>
        <source>it is open in another window; choose another name</source>
        <translation>está abierto en otra ventana; elija otro nombre</translation>
    </message>
    <message>
        <source>the disk of &quot;%1&quot; is full, where work is protected from crashes; make room, and open it again</source>
        <translation>el disco de «%1», donde el trabajo se protege de fallos, está lleno; libere espacio y ábralo de nuevo</translation>
    </message>
    <message>
        <source>The form is %1 mm large: with edges of %2 mm its cover has more triangles than can be solved. See whether the unit is right; else make the mesh edges at least %3 mm long</source>
        <translation>La forma mide %1 mm: con aristas de %2 mm su funda tiene más triángulos de los que se pueden resolver. Compruebe si la unidad es correcta; si lo es, haga las aristas de la malla de al menos %3 mm</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already; choose another name</source>
        <translation>«%1» ya existe; elija otro nombre</translation>
    </message>
    <message>
        <source>%1 is strained by %2 % when it lies on the form, more than any fabric bears. Divide it, or cut it in where it bulges most</source>
        <translation>%1 se deforma un %2 % sobre la forma, más de lo que soporta cualquier tela. Divídala, o haga un corte donde más se abomba</translation>
    </message>
    <message>
        <source>Let no scan pull at the cover</source>
        <translation>No dejar que ningún escaneo tire de la funda</translation>
    </message>
    <message>
        <source>%1 bends too sharply at %2: it is not cut along it</source>
        <translation>%1 se dobla demasiado en %2: no se corta por ahí</translation>
    </message>
    <message>
        <source>The form goes through itself at %2: it is not cut along %1</source>
        <translation>La forma se atraviesa a sí misma en %2: no se corta por %1</translation>
    </message>
    <message>
        <source>What is closed all around has no border to be held at: its cover is fixed along its seams. Delete the fixations of those that are to be free</source>
        <translation>Lo que está cerrado por completo no tiene borde por el que sujetarlo: su funda se fija a lo largo de sus costuras. Borre las fijaciones de las que deban quedar libres</translation>
    </message>
    <message>
        <source>No vertex of the area is near the form: make the area larger than the mesh edges, or put the form where the cover is.</source>
        <translation>Ningún vértice de la zona está cerca de la forma: agrande la zona por encima de las aristas de la malla o ponga la forma donde está la funda.</translation>
    </message>
    <message>
        <source>%1 is left out: it is too narrow to be sewn. Join it to what lies beside it</source>
        <translation>%1 se omite: es demasiado estrecha para coserla. Únala a lo que está al lado</translation>
    </message>
    <message>
        <source>Make the pattern of a form again</source>
        <translation>Volver a hacer el patrón de una forma</translation>
    </message>
    <message>
        <source>Make the pattern of %1 again</source>
        <translation>Volver a hacer el patrón de %1</translation>
    </message>
    <message>
        <source>Make the pattern of %1</source>
        <translation>Hacer el patrón de %1</translation>
    </message>
    <message>
        <source>Fit the pattern to %1, %2 mm from it</source>
        <translation>Adaptar el patrón a %1, a %2&#xa0;mm de distancia</translation>
    </message>
    <message>
        <source>Fit the pattern to %1</source>
        <translation>Adaptar el patrón a %1</translation>
    </message>
    <message>
        <source>Fit the pattern to a limit of strain, %1 % of the cover over it</source>
        <translation>Adaptar el patrón a un límite de deformación, con el %1&#xa0;% de la funda por encima</translation>
    </message>
    <message>
        <source>Let the scan pull at the cover again</source>
        <translation>Dejar que el escaneo vuelva a tirar de la funda</translation>
    </message>
    <message>
        <source>%1 runs along %2, at %3: it is cut there once</source>
        <translation>%1 va a lo largo de %2, en %3: allí se corta una sola vez</translation>
    </message>
    <message>
        <source>%1 runs along the border of the form, or where it is cut anyway, at %2: there is nothing to cut</source>
        <translation>%1 va por el borde de la forma o por donde ya se corta, en %2: no hay nada que cortar</translation>
    </message>
    <message>
        <source>%1 is too short or too long, at %2: it is not cut along it</source>
        <translation>%1 es demasiado corta o demasiado larga, en %2: no se corta por ahí</translation>
    </message>
    <message>
        <source>%1 is %2 mm away from the form, at %3: it is not cut along it</source>
        <translation>%1 está a %2&#xa0;mm de la forma, en %3: no se corta por ahí</translation>
    </message>
    <message>
        <source>lines cannot be cut into it: it has edges where more than two faces meet, or sheets that touch in a point, at %1</source>
        <translation>no se pueden cortar líneas en ella: tiene aristas donde se juntan más de dos caras, o láminas que se tocan en un punto, en %1</translation>
    </message>
    <message>
        <source>%1 cannot be cut into it, at %2: the form goes through itself there</source>
        <translation>no se puede cortar %1 en ella, en %2: allí la forma se atraviesa a sí misma</translation>
    </message>
    <message>
        <source>Small for the triangles of the cover, whose edges are %1 mm long: %2. Their shape will be coarse; with mesh edges of %3 mm it is not</source>
        <translation>Pequeñas para los triángulos de la funda, cuyas aristas miden %1&#xa0;mm: %2. Su forma será tosca; con aristas de malla de %3&#xa0;mm no lo es</translation>
    </message>
    <message>
        <source>Too small for the triangles of the cover, whose edges are %1 mm long: %2. Join them to what lies beside them, or leave them out</source>
        <translation>Demasiado pequeñas para los triángulos de la funda, cuyas aristas miden %1&#xa0;mm: %2. Únalas a lo que está al lado u omítalas</translation>
    </message>
    <message>
        <source>After %1 iterations it cannot be told yet where the surface comes to rest. Allow more iterations.</source>
        <translation>Tras %1 iteraciones aún no se puede decir dónde quedará en reposo la superficie. Permita más iteraciones.</translation>
    </message>
    <message>
        <source>Wider across the grain than the fabric, of which %1 mm can be used: %2. Divide them, or turn their grain</source>
        <translation>Más anchas a contrahilo que la tela, de la que se pueden usar %1 mm: %2. Divídalas o gire su sentido del hilo</translation>
    </message>
    <message>
        <source>%1 ends inside a piece, at %2: it is cut in there like a dart. There is no other line or border; lead it around to where it began to divide the piece</source>
        <translation>%1 termina dentro de una pieza, en %2: allí se corta como una pinza. No hay otra línea ni borde; llévela alrededor hasta su principio para dividir la pieza</translation>
    </message>
    <message>
        <source>A line is not cut in at %1: the sides of the cut would lie over each other when it is laid flat. Draw it elsewhere, or on to a border</source>
        <translation>En %1 no se corta una línea: los lados del corte quedarían uno sobre otro en plano. Dibújela en otro sitio, o hasta un borde</translation>
    </message>
    <message>
        <source>A line is not cut in at %1: the piece was divided another way. Draw it on to a border</source>
        <translation>En %1 no se corta una línea: la pieza se dividió de otro modo. Prolónguela hasta un borde</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no design, but what one is made of: import it</source>
        <translation>«%1» no es un diseño, sino algo con lo que se hace uno: impórtelo</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by %2 mm in each: it does not come to rest. Make curves as long as the outlines they hold, or try other mesh edges.</source>
        <translation>Tras %1 iteraciones la superficie aún se mueve %2&#xa0;mm en cada una: no llega al reposo. Haga las curvas tan largas como los contornos que sujetan o pruebe otras aristas de malla.</translation>
    </message>
    <message>
        <source>%1, with what is sewn to it, is held only at a border of %2 mm: fix it along other curves, too, or close that hole of the form</source>
        <translation>%1, con lo que está cosido a ella, solo se sujeta por un borde de %2&#xa0;mm: fíjela también a lo largo de otras curvas, o cierre ese agujero de la forma</translation>
    </message>
    <message>
        <source>%1 is left out: it is closed all around and cannot be laid flat. Cut it along lines</source>
        <translation>%1 se omite: está cerrada por todos lados y no se puede aplanar. Córtela a lo largo de líneas</translation>
    </message>
    <message>
        <source>%1 is left out: it has a handle, like a cup, and cannot be laid flat. Cut it along lines</source>
        <translation>%1 se omite: tiene un asa, como una taza, y no se puede aplanar. Córtela a lo largo de líneas</translation>
    </message>
    <message>
        <source>Let out %1 by %3 mm where it is sewn to %2</source>
        <translation>Soltar %1 %3&#xa0;mm donde está cosido a %2</translation>
    </message>
    <message>
        <source>Take in %1 by %3 mm where it is sewn to %2</source>
        <translation>Meter %1 %3&#xa0;mm donde está cosido a %2</translation>
    </message>
    <message>
        <source>Let out %1 by %3 mm where the curve %2 holds it</source>
        <translation>Soltar %1 %3&#xa0;mm donde lo sujeta la curva %2</translation>
    </message>
    <message>
        <source>Take in %1 by %3 mm where the curve %2 holds it</source>
        <translation>Meter %1 %3&#xa0;mm donde lo sujeta la curva %2</translation>
    </message>
    <message>
        <source>What would not lie flat, or be strained by more than the fabric may be, is divided, which makes so many pieces more: %1</source>
        <translation>Lo que no quedaría plano, o se estiraría más de lo que admite la tela, se divide. Son tantas piezas más: %1</translation>
    </message>
    <message>
        <source>%1 is not divided: more than %2 pieces would be needed until it lies flat. It is rough, as scans are: smooth it, or fit a cover to it and take that</source>
        <translation>%1 no se divide: harían falta más de %2 piezas para que quede plana. Es rugosa, como lo son los escaneos: alísela, o ajuste una funda a ella y tome esa</translation>
    </message>
    <message>
        <source>%1 is left out: it has more than %2 holes. Close them, or cut it along lines</source>
        <translation>%1 se omite: tiene más de %2 agujeros. Ciérrelos, o córtela a lo largo de líneas</translation>
    </message>
    <message>
        <source>Too narrow for the triangles of the cover, whose edges are %1 mm long, so that it cannot be solved: %2. Make the mesh edges shorter, or join them to what lies beside them</source>
        <translation>Demasiado estrechas para los triángulos de la funda, cuyas aristas miden %1&#xa0;mm, así que no se puede calcular: %2. Acorte las aristas de malla, o únalas a lo que está al lado</translation>
    </message>
    <message>
        <source>Lead open seam lines on</source>
        <translation>Prolongar las líneas de costura abiertas</translation>
    </message>
    <message>
        <source>Lead %1 on</source>
        <translation>Prolongar %1</translation>
    </message>
    <message>
        <source>Bodies of the form go through each other, as at %1: what of one lies inside of another one is covered, too, and pushed out. Unite them before, or leave one out. Number of such pairs: %2</source>
        <translation>Hay cuerpos de la forma que se atraviesan, como en %1: lo que de uno queda dentro de otro también se tapiza y es empujado hacia fuera. Únalos antes o deje uno fuera. Número de esos pares: %2</translation>
    </message>
    <message>
        <source>Faces of the form that lie where another one lies, and are left out: %1</source>
        <translation>Caras de la forma que están donde ya hay otra y se omiten: %1</translation>
    </message>
    <message>
        <source>Faces of the form that were turned round: %1</source>
        <translation>Caras de la forma a las que se dio la vuelta: %1</translation>
    </message>
    <message>
        <source>Edges of the form that belong to more than two faces, so that they are borders and nothing is sewn there: %1</source>
        <translation>Aristas de la forma que pertenecen a más de dos caras, por lo que son bordes y allí no se cose nada: %1</translation>
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
        <translation>Mayús</translation>
    </message>
    <message>
        <source>middle button</source>
        <translation>botón central</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>botón derecho</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>arrastrar</translation>
    </message>
    <message>
        <source>two fingers</source>
        <translation>dos dedos</translation>
    </message>
    <message>
        <source>pinch or Ctrl+wheel</source>
        <translation>pellizco o Ctrl+rueda</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>rueda</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>CAD (like SolidWorks)</source>
        <translation>CAD (como SolidWorks)</translation>
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
        <translation>Panel táctil</translation>
    </message>
</context>
<context>
    <name>NotchForm</name>
    <message>
        <source>Patch</source>
        <translation>Pieza</translation>
    </message>
    <message>
        <source>From the corner</source>
        <translation>Desde la esquina</translation>
    </message>
    <message>
        <source>Along the outline from the nearer corner, on the same side of it.</source>
        <translation>Por el contorno desde la esquina más próxima, del mismo lado de ella.</translation>
    </message>
</context>
<context>
    <name>OrientationFields</name>
    <message>
        <source>Free</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>Normal held</source>
        <translation>Normal fijada</translation>
    </message>
    <message>
        <source>Tangent plane held</source>
        <translation>Plano tangente fijado</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>Inclinación</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>%1 directions, interpolated along the curve; the first is shown.</source>
        <translation>%1 direcciones, interpoladas a lo largo de la curva; se muestra la primera.</translation>
    </message>
</context>
<context>
    <name>OutlineTool</name>
    <message>
        <source>This cannot be a patch: %1</source>
        <translation>Esto no puede ser una pieza: %1</translation>
    </message>
    <message>
        <source>The outline would cross itself here – Backspace takes a point back</source>
        <translation>El contorno se cruzaría aquí — Retroceso quita un punto</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no length: try 500, 500&lt;30 or 120, 40</source>
        <translation>«%1» no es una longitud: pruebe 500, 500&lt;30 o 120, 40</translation>
    </message>
    <message>
        <source>Click to set the first corner, press and drag for a smooth point – Esc ends the tool</source>
        <translation>Haga clic para poner la primera esquina; pulse y arrastre para un punto suave — Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>Click to close the outline</source>
        <translation>Clic para cerrar el contorno</translation>
    </message>
    <message>
        <source>Enter sets the point: 500 goes that far, 500&lt;30 at an angle, 120, 40 to the right and up</source>
        <translation>Intro pone el punto: 500 avanza esa distancia, 500&lt;30 con un ángulo, 120, 40 a la derecha y arriba</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, or type a length – Ctrl does not snap</source>
        <translation>Clic para una esquina, arrastrar para un punto suave, o escribir una longitud — Ctrl: sin ajuste</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, type a length – Enter or a click on the first point closes, Backspace takes a point back</source>
        <translation>Clic para una esquina, arrastrar para un punto suave, escribir una longitud — Intro o clic en el primer punto cierra, Retroceso quita un punto</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
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
        <translation>Pieza %1</translation>
    </message>
    <message>
        <source>An outline needs at least three points in different places.</source>
        <translation>Un contorno necesita al menos tres puntos en lugares distintos.</translation>
    </message>
    <message>
        <source>This cannot be a patch: %1</source>
        <translation>Esto no puede ser una pieza: %1</translation>
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
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Width and height as it lies in the pattern view.</source>
        <translation>Ancho y alto tal como está en la vista del patrón.</translation>
    </message>
</context>
<context>
    <name>PatternDrawTool</name>
    <message>
        <source>Begin inside a patch.</source>
        <translation>Empiece dentro de una pieza.</translation>
    </message>
    <message>
        <source>Fancy seam %1</source>
        <translation>Costura decorativa %1</translation>
    </message>
    <message>
        <source>Handle %1</source>
        <translation>Tirador %1</translation>
    </message>
    <message>
        <source>A curve needs two points, a closed one three.</source>
        <translation>Una curva necesita dos puntos; una cerrada, tres.</translation>
    </message>
    <message>
        <source>There is no surface in this patch yet on which the handle could lie.</source>
        <translation>Esta pieza aún no tiene una superficie sobre la que pueda estar el tirador.</translation>
    </message>
    <message>
        <source>Click inside a patch to begin a handle curve – Esc ends the tool</source>
        <translation>Haga clic dentro de una pieza para empezar una curva de tirador — Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>Click inside a patch or on its outline to begin a fancy seam – Esc ends the tool</source>
        <translation>Haga clic dentro de una pieza o en su contorno para empezar una costura decorativa — Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>Click to close the curve</source>
        <translation>Clic para cerrar la curva</translation>
    </message>
    <message>
        <source>Click for the next point, double click or Enter ends – B makes it straight, Backspace takes a point back</source>
        <translation>Clic para el siguiente punto, doble clic o Intro termina — B la hace recta, Retroceso quita un punto</translation>
    </message>
    <message>
        <source>Click for the next point, double click or Enter ends – B makes it smooth, Backspace takes a point back</source>
        <translation>Clic para el siguiente punto, doble clic o Intro termina — B la hace suave, Retroceso quita un punto</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Línea %1</translation>
    </message>
    <message>
        <source>Click inside a patch or on its outline to begin a line for the cutter – Esc ends the tool</source>
        <translation>Haga clic dentro de una pieza o en su contorno para empezar una línea para el corte — Esc sale de la herramienta</translation>
    </message>
</context>
<context>
    <name>PatternPdf</name>
    <message>
        <source>1 inch</source>
        <translation>1 pulgada</translation>
    </message>
    <message>
        <source>Print at 100 %</source>
        <translation>Imprimir al 100&#xa0;%</translation>
    </message>
    <message>
        <source>%1 – print at 100 %</source>
        <translation>%1 — imprimir al 100&#xa0;%</translation>
    </message>
    <message>
        <source>Overview of %1 x %2 sheets</source>
        <translation>Esquema de %1 x %2 hojas</translation>
    </message>
    <message>
        <source>%1: sheet %2</source>
        <translation>%1: hoja %2</translation>
    </message>
    <message>
        <source>%1: sheets %2 to %3</source>
        <translation>%1: hojas %2 a %3</translation>
    </message>
    <message>
        <source>100 mm: to measure, no part of the pattern</source>
        <translation>100&#xa0;mm: para medir, no es parte del patrón</translation>
    </message>
    <message>
        <source>Sheet %1 (row %2 of %3, column %4 of %5)</source>
        <translation>Hoja %1 (fila %2 de %3, columna %4 de %5)</translation>
    </message>
</context>
<context>
    <name>PatternSelectTool</name>
    <message>
        <source>There is a control point already.</source>
        <translation>Aquí ya hay un punto de control.</translation>
    </message>
    <message>
        <source>Drag to turn the selected patches in the layout</source>
        <translation>Arrastre para girar las piezas seleccionadas en la disposición</translation>
    </message>
    <message>
        <source>Drag to move the control point – Shift+click selects several, Del removes</source>
        <translation>Arrastre para mover el punto de control — Mayús+clic selecciona varios, Supr elimina</translation>
    </message>
    <message>
        <source>Click to select the patch, drag to move it in the layout</source>
        <translation>Clic para seleccionar la pieza, arrastrar para moverla en la disposición</translation>
    </message>
    <message>
        <source>Click to select the curve, drag to move it, double click to add a control point here</source>
        <translation>Clic para seleccionar la curva, arrastrar para moverla, doble clic para añadir aquí un punto de control</translation>
    </message>
    <message>
        <source>Drag to scale the selected patches – Shift keeps the proportions</source>
        <translation>Arrastre para escalar las piezas seleccionadas — Mayús mantiene las proporciones</translation>
    </message>
    <message>
        <source>Drag to move this end of the stretch along the outline</source>
        <translation>Arrastre para mover este extremo del tramo por el contorno</translation>
    </message>
    <message>
        <source>Drag to move the edge, double click to add a control point here – its length is in the properties</source>
        <translation>Arrastre para mover el borde, doble clic para añadir aquí un punto de control — su longitud está en las propiedades</translation>
    </message>
    <message>
        <source>Click to select the edge, double click to add a control point here, drag to move the patch</source>
        <translation>Clic para seleccionar el borde, doble clic para añadir aquí un punto de control, arrastrar para mover la pieza</translation>
    </message>
    <message>
        <source>Click to select the seam and the edge, double click to add a control point here</source>
        <translation>Clic para seleccionar la costura y el borde, doble clic para añadir aquí un punto de control</translation>
    </message>
    <message>
        <source>Click to select it, drag to move it, Delete removes it</source>
        <translation>Clic para seleccionarlo, arrastrar para moverlo, Supr lo elimina</translation>
    </message>
    <message>
        <source>Drag the tip of the dart</source>
        <translation>Arrastre el vértice de la pinza</translation>
    </message>
    <message>
        <source>Drag the dart along the outline</source>
        <translation>Arrastre la pinza por el contorno</translation>
    </message>
    <message>
        <source>Drag the label to where it can be read, click to select the patch</source>
        <translation>Arrastre la etiqueta a donde se pueda leer, clic para seleccionar la pieza</translation>
    </message>
    <message>
        <source>Click to select, drag a box to select several – %1 or Space pans, %2 zooms</source>
        <translation>Clic para seleccionar, arrastrar un marco para seleccionar varios — %1 o Espacio desplaza, %2 amplía</translation>
    </message>
    <message>
        <source>Click to select the measurement, Delete removes it</source>
        <translation>Clic para seleccionar la medida, Supr la elimina</translation>
    </message>
</context>
<context>
    <name>PatternSplitTool</name>
    <message>
        <source>Click beside a patch or on its outline to begin the cut – Esc ends the tool</source>
        <translation>Haga clic junto a una pieza o en su contorno para empezar el corte — Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>Double click or Enter splits the patch – click to bend the cut, Backspace takes a point back</source>
        <translation>Doble clic o Intro divide la pieza — clic para doblar el corte, Retroceso quita un punto</translation>
    </message>
    <message>
        <source>Click on the other side of the patch – Shift keeps the cut straight, Backspace takes a point back</source>
        <translation>Haga clic al otro lado de la pieza — Mayús mantiene recto el corte, Retroceso quita un punto</translation>
    </message>
</context>
<context>
    <name>PatternTool</name>
    <message>
        <source>Moved by %1, %2 – Shift keeps to one axis, Esc takes it back</source>
        <translation>Movido %1, %2 — Mayús fija un eje, Esc lo anula</translation>
    </message>
    <message>
        <source>Turned by %1 – Shift turns in steps of 15°, Esc takes it back</source>
        <translation>Girado %1 — Mayús gira en pasos de 15°, Esc lo anula</translation>
    </message>
    <message>
        <source>Release to select what lies in the box – Shift adds, Esc takes it back</source>
        <translation>Suelte para seleccionar lo que hay en el marco — Mayús añade, Esc lo anula</translation>
    </message>
    <message>
        <source>Release to select what lies in the loop – Shift adds, Esc takes it back</source>
        <translation>Suelte para seleccionar lo que hay en el lazo — Mayús añade, Esc lo anula</translation>
    </message>
    <message>
        <source>Enter moves it so far: 50, or 30, 20</source>
        <translation>Intro lo mueve esta distancia: 50, o 30, 20</translation>
    </message>
    <message>
        <source>Enter turns it by this angle, counter-clockwise: 45</source>
        <translation>Intro lo gira este ángulo, en sentido antihorario: 45</translation>
    </message>
    <message>
        <source>Enter makes it this size: 300 x 200, 300 (wide, in proportion), or 120 %</source>
        <translation>Intro le da este tamaño: 300 x 200, 300 (ancho, en proporción) o 120&#xa0;%</translation>
    </message>
    <message>
        <source>Scaled to %1 × %2 – or type the size; Shift keeps the proportions, Esc takes it back</source>
        <translation>Escalado a %1 × %2 — o escriba el tamaño; Mayús mantiene las proporciones, Esc lo anula</translation>
    </message>
</context>
<context>
    <name>PatternToolHost</name>
    <message>
        <source>%1 Let go here, and it goes back to where it was.</source>
        <translation>%1 Si suelta aquí, vuelve a donde estaba.</translation>
    </message>
</context>
<context>
    <name>PieceCuttingSection</name>
    <message>
        <source>Cutting</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Own seam allowance</source>
        <translation>Margen de costura propio</translation>
    </message>
    <message>
        <source>Label where it finds room</source>
        <translation>Etiqueta donde haya sitio</translation>
    </message>
</context>
<context>
    <name>PlacementGizmo</name>
    <message>
        <source>Turned by %1° – Ctrl snaps to 15°, Escape cancels</source>
        <translation>Girado %1° — Ctrl ajusta a 15°, Esc cancela</translation>
    </message>
    <message>
        <source>Drag to move it along this axis</source>
        <translation>Arrastre para moverlo a lo largo de este eje</translation>
    </message>
    <message>
        <source>Drag to turn it about this axis</source>
        <translation>Arrastre para girarlo en torno a este eje</translation>
    </message>
    <message>
        <source>Drag to move it parallel to the picture</source>
        <translation>Arrastre para moverlo en paralelo a la imagen</translation>
    </message>
    <message>
        <source>Moved by x %1, y %2, z %3 – Ctrl snaps to %4, Escape cancels</source>
        <translation>Movido x %1, y %2, z %3 — Ctrl ajusta a %4, Esc cancela</translation>
    </message>
</context>
<context>
    <name>PreferenceCommands</name>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation>Pre&amp;ferencias…</translation>
    </message>
    <message>
        <source>Units, language, theme, mouse, keys and more</source>
        <translation>Unidades, idioma, tema, ratón, teclas y más</translation>
    </message>
    <message>
        <source>The preferences could not be stored: they hold only until Bolster is closed.</source>
        <translation>No se pudieron guardar las preferencias: valen solo hasta que se cierre Bolster.</translation>
    </message>
</context>
<context>
    <name>Preferences</name>
    <message>
        <source>Millimetres (314 mm)</source>
        <translation>Milímetros (314&#xa0;mm)</translation>
    </message>
    <message>
        <source>Centimetres (31.4 cm)</source>
        <translation>Centímetros (31,4&#xa0;cm)</translation>
    </message>
    <message>
        <source>Inches (12 3/8″)</source>
        <translation>Pulgadas (12 3/8″)</translation>
    </message>
    <message>
        <source>Up to 1/8</source>
        <translation>Hasta 1/8</translation>
    </message>
    <message>
        <source>Up to 1/16</source>
        <translation>Hasta 1/16</translation>
    </message>
    <message>
        <source>Up to 1/32</source>
        <translation>Hasta 1/32</translation>
    </message>
    <message>
        <source>Up to 1/64</source>
        <translation>Hasta 1/64</translation>
    </message>
    <message>
        <source>Decimals (12.375)</source>
        <translation>Decimales (12,375)</translation>
    </message>
    <message>
        <source>Of the language</source>
        <translation>Del idioma</translation>
    </message>
    <message>
        <source>Comma (1,5)</source>
        <translation>Coma (1,5)</translation>
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
        <translation>Como el sistema</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Alto contraste</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Completa</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Reducida</translation>
    </message>
    <message>
        <source>Plain, as it comes</source>
        <translation>Lisa, la predeterminada</translation>
    </message>
    <message>
        <source>Units and numbers</source>
        <translation>Unidades y números</translation>
    </message>
    <message>
        <source>Language and looks</source>
        <translation>Idioma y aspecto</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Ratón</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Teclado</translation>
    </message>
    <message>
        <source>Pattern view</source>
        <translation>Vista del patrón</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Vista 3D</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Trabajo sin guardar</translation>
    </message>
    <message>
        <source>New designs</source>
        <translation>Diseños nuevos</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>Longitudes en</translation>
    </message>
    <message>
        <source>unit measure metric imperial millimetre centimetre inch</source>
        <translation>unidad medida métrico imperial milímetros centímetros pulgadas mm cm longitud</translation>
    </message>
    <message>
        <source>How lengths are shown. Whatever it is, you may type others: 3 in, 2.5 cm, 1&apos; 2 3/8&quot;. Designs keep millimetres, and so do printed sheets and files.</source>
        <translation>Cómo se muestran las longitudes. En todo caso puede escribir otras: «3&#xa0;in», «2,5&#xa0;cm», «1&apos; 2 3/8&quot;». Los diseños conservan los milímetros, igual que las hojas impresas y los archivos.</translation>
    </message>
    <message>
        <source>Parts of an inch</source>
        <translation>Fracciones de pulgada</translation>
    </message>
    <message>
        <source>fraction imperial 1/16 decimals</source>
        <translation>fracción imperial 1/16 decimales pulgada</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>Separador decimal</translation>
    </message>
    <message>
        <source>comma point dot separator numbers</source>
        <translation>coma punto separador decimales números signo</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>translation words english german deutsch</source>
        <translation>traducción palabras inglés alemán español english lengua</translation>
    </message>
    <message>
        <source>Bolster speaks it when it is started the next time.</source>
        <translation>Vale desde el próximo inicio de Bolster.</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>colours dark light contrast night appearance accessibility</source>
        <translation>colores oscuro claro contraste noche aspecto accesibilidad</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Size of the letters</source>
        <translation>Tamaño de letra</translation>
    </message>
    <message>
        <source>font text large small zoom scale accessibility</source>
        <translation>fuente tipografía texto grande pequeño zoom escala accesibilidad</translation>
    </message>
    <message>
        <source>Move the views as in</source>
        <translation>Mover las vistas como en</translation>
    </message>
    <message>
        <source>navigation rotate turn pan zoom buttons trackpad orbit preset</source>
        <translation>navegación girar rotar desplazar zoom botones panel táctil trackpad órbita preajuste</translation>
    </message>
    <message>
        <source>Zoom the other way round</source>
        <translation>Zoom en sentido inverso</translation>
    </message>
    <message>
        <source>invert wheel scroll reverse direction</source>
        <translation>invertir rueda desplazamiento contrario dirección</translation>
    </message>
    <message>
        <source>Keys as in</source>
        <translation>Teclas como en</translation>
    </message>
    <message>
        <source>shortcuts hotkeys preset</source>
        <translation>atajos teclado teclas rápidas preajuste</translation>
    </message>
    <message>
        <source>Some commands get the keys that you know from there. Keys that you have chosen yourself stay.</source>
        <translation>Algunos comandos reciben las teclas que ya conoce de allí. Las que haya elegido usted se conservan.</translation>
    </message>
    <message>
        <source>Snap to points, edges, guides and the grid</source>
        <translation>Ajustar a puntos, bordes, guías y cuadrícula</translation>
    </message>
    <message>
        <source>magnet catch align</source>
        <translation>imán atraer alinear ajuste snap</translation>
    </message>
    <message>
        <source>Ctrl or Alt lets go while you drag.</source>
        <translation>Ctrl o Alt lo suspende mientras se arrastra.</translation>
    </message>
    <message>
        <source>Show rulers</source>
        <translation>Mostrar reglas</translation>
    </message>
    <message>
        <source>scale measure</source>
        <translation>escala medida regla</translation>
    </message>
    <message>
        <source>Show guides</source>
        <translation>Mostrar guías</translation>
    </message>
    <message>
        <source>lines help</source>
        <translation>líneas ayuda guía</translation>
    </message>
    <message>
        <source>Quality of the picture</source>
        <translation>Calidad de la imagen</translation>
    </message>
    <message>
        <source>performance slow fast remote desktop graphics opengl</source>
        <translation>rendimiento lento rápido escritorio remoto gráficos opengl</translation>
    </message>
    <message>
        <source>Reduced: fewer pixels and triangles, no soft shadows. For slow machines and for screens that are far away. Pictures that you export stay fine.</source>
        <translation>Reducida: menos píxeles y triángulos, sin sombras suaves. Para equipos lentos y pantallas remotas. Las imágenes exportadas conservan su calidad.</translation>
    </message>
    <message>
        <source>Go to other views at once, without a flight</source>
        <translation>Pasar a otras vistas al instante, sin recorrido</translation>
    </message>
    <message>
        <source>reduced motion animation camera accessibility remote</source>
        <translation>movimiento reducido animación cámara accesibilidad remoto</translation>
    </message>
    <message>
        <source> days</source>
        <translation> días</translation>
    </message>
    <message>
        <source>Keep work that was thrown away for</source>
        <translation>Conservar el trabajo desechado durante</translation>
    </message>
    <message>
        <source>autosave backup recovery crash journal bin unsaved delete</source>
        <translation>autoguardado copia de seguridad recuperación fallo registro papelera sin guardar eliminar</translation>
    </message>
    <message>
        <source>Every step is on the disk as soon as it is done, so there is no interval to set. Unsaved work stays until you open it again or throw it away; after that it lies in the bin for at least 30 days.</source>
        <translation>Cada paso está en el disco en cuanto se hace, así que no hay intervalo que ajustar. El trabajo sin guardar se conserva hasta que lo abra de nuevo o lo deseche; después queda en la papelera al menos 30 días.</translation>
    </message>
    <message>
        <source>Fabric of new patches</source>
        <translation>Tela de las piezas nuevas</translation>
    </message>
    <message>
        <source>default material leather weave colour</source>
        <translation>predeterminado material piel cuero tejido color</translation>
    </message>
    <message>
        <source>A new design begins with it, and patches are made of a design&apos;s first fabric.</source>
        <translation>Un diseño nuevo empieza con ella, y las piezas se hacen con la primera tela del diseño.</translation>
    </message>
    <message>
        <source>Seam allowance</source>
        <translation>Margen de costura</translation>
    </message>
    <message>
        <source>default cutting margin hem width</source>
        <translation>predeterminado corte margen dobladillo ancho</translation>
    </message>
    <message>
        <source>New designs begin with it; in a design it is changed in its properties.</source>
        <translation>Los diseños nuevos empiezan con él; en un diseño se cambia en sus propiedades.</translation>
    </message>
    <message>
        <source>Folder of your fabrics</source>
        <translation>Carpeta de sus telas</translation>
    </message>
    <message>
        <source>library directory path import export picture swatch</source>
        <translation>biblioteca directorio carpeta ruta importar exportar imagen muestra</translation>
    </message>
    <message>
        <source>Where fabrics and their pictures are looked for first. Without one it is the folder of the design.</source>
        <translation>Dónde se buscan primero las telas y sus imágenes. Si no hay ninguna, es la carpeta del diseño.</translation>
    </message>
    <message>
        <source>Lengths are kept as they are, and shown to the nearest part; what is shorter than one has decimals.</source>
        <translation>Las longitudes quedan como son y se muestran hasta la parte más próxima; lo que es más corto que una lleva decimales.</translation>
    </message>
</context>
<context>
    <name>SavedViewCommands</name>
    <message>
        <source>&amp;Save view …</source>
        <translation>&amp;Guardar vista…</translation>
    </message>
    <message>
        <source>&amp;Delete view</source>
        <translation>&amp;Eliminar vista</translation>
    </message>
    <message>
        <source>View %1 deleted</source>
        <translation>Vista %1 eliminada</translation>
    </message>
    <message>
        <source>Save view</source>
        <translation>Guardar vista</translation>
    </message>
    <message>
        <source>Name of the view; one of the same name is replaced:</source>
        <translation>Nombre de la vista; una con el mismo nombre se reemplaza:</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vista %1</translation>
    </message>
    <message>
        <source>View %1 saved: View &gt; Saved views</source>
        <translation>Vista %1 guardada: Ver &gt; Vistas guardadas</translation>
    </message>
</context>
<context>
    <name>ScanAlignTool</name>
    <message>
        <source>There is no point of the scan here: click on one.</source>
        <translation>Aquí no hay ningún punto del escaneo: haga clic en uno.</translation>
    </message>
    <message>
        <source>There is neither a frame nor the cover here: click where that place of the scan belongs.</source>
        <translation>Aquí no hay ni armazón ni funda: haga clic donde deba ir ese lugar del escaneo.</translation>
    </message>
    <message>
        <source>Take the last place &amp;back</source>
        <translation>&amp;Quitar el último lugar</translation>
    </message>
    <message>
        <source>Click on the frame or the cover where place %1 of the scan belongs – Backspace takes it back</source>
        <translation>Haga clic en el armazón o la funda donde deba ir el lugar %1 del escaneo — Retroceso lo quita</translation>
    </message>
    <message>
        <source>Click on a place of the scan that can be told from others, such as a corner – drag turns the view, Esc ends the tool</source>
        <translation>Haga clic en un lugar del escaneo que se distinga de otros, como una esquina — arrastrar gira la vista, Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>Click on place %1 of 3 of the scan, far from the others – Backspace takes one back</source>
        <translation>Haga clic en el lugar %1 de 3 del escaneo, lejos de los otros — Retroceso quita uno</translation>
    </message>
    <message>
        <source>%1: where it belongs</source>
        <translation>%1: donde debe ir</translation>
    </message>
    <message>
        <source>%1: on the scan</source>
        <translation>%1: en el escaneo</translation>
    </message>
    <message>
        <source>The scan is no longer there – Esc ends the tool</source>
        <translation>El escaneo ya no está — Esc sale de la herramienta</translation>
    </message>
</context>
<context>
    <name>ScanCommands</name>
    <message>
        <source>&amp;Place on the cover</source>
        <translation>Co&amp;locar sobre la funda</translation>
    </message>
    <message>
        <source>Moves and turns the scan so that it lies on the cover as well as it can</source>
        <translation>Mueve y gira el escaneo para que quede lo mejor posible sobre la funda</translation>
    </message>
    <message>
        <source>&amp;Cut away …</source>
        <translation>&amp;Recortar…</translation>
    </message>
    <message>
        <source>Drag a rectangle in the 3D view over what is to be cut away of the scan</source>
        <translation>Arrastre en la vista 3D un rectángulo sobre lo que se deba recortar del escaneo</translation>
    </message>
    <message>
        <source>&amp;Keep only …</source>
        <translation>&amp;Conservar solo…</translation>
    </message>
    <message>
        <source>Drag a rectangle in the 3D view around what is to be kept of the scan</source>
        <translation>Arrastre en la vista 3D un rectángulo alrededor de lo que se deba conservar del escaneo</translation>
    </message>
    <message>
        <source>Keep &amp;around the cover</source>
        <translation>Conservar lo cercano a la &amp;funda</translation>
    </message>
    <message>
        <source>Cuts away what is farther from the cover than the threshold</source>
        <translation>Recorta lo que esté más lejos de la funda que el umbral</translation>
    </message>
    <message>
        <source>&amp;Remove all cuts</source>
        <translation>&amp;Eliminar todos los cortes</translation>
    </message>
    <message>
        <source>Brings back all that was cut away of the scan</source>
        <translation>Recupera todo lo recortado del escaneo</translation>
    </message>
    <message>
        <source>Choose another &amp;file …</source>
        <translation>Elegir &amp;otro archivo…</translation>
    </message>
    <message>
        <source>Reads the scan from another file</source>
        <translation>Lee el escaneo de otro archivo</translation>
    </message>
    <message>
        <source>Select the scan that is meant.</source>
        <translation>Seleccione el escaneo correspondiente.</translation>
    </message>
    <message>
        <source>Placing the scan on the cover …</source>
        <translation>Colocando el escaneo sobre la funda…</translation>
    </message>
    <message>
        <source>Placing the scan on the cover: step %1</source>
        <translation>Colocando el escaneo sobre la funda: paso %1</translation>
    </message>
    <message>
        <source>A&amp;lign …</source>
        <translation>&amp;Alinear…</translation>
    </message>
    <message>
        <source>Click three places of the scan and where each belongs; the rest is found</source>
        <translation>Haga clic en tres lugares del escaneo y donde debe ir cada uno; el resto se calcula</translation>
    </message>
    <message>
        <source>Aligning the scan …</source>
        <translation>Alineando el escaneo…</translation>
    </message>
    <message>
        <source>Aligning the scan: step %1</source>
        <translation>Alineando el escaneo: paso %1</translation>
    </message>
</context>
<context>
    <name>ScanCutTool</name>
    <message>
        <source>Drag a rectangle around what is to be kept of the scan. Esc ends.</source>
        <translation>Arrastre un rectángulo alrededor de lo que se deba conservar del escaneo. Esc termina.</translation>
    </message>
    <message>
        <source>Drag a rectangle over what is to be cut away of the scan. Esc ends.</source>
        <translation>Arrastre un rectángulo sobre lo que se deba recortar del escaneo. Esc termina.</translation>
    </message>
</context>
<context>
    <name>ScanForm</name>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Place on &amp;the cover</source>
        <translation>Colocar sobre &amp;la funda</translation>
    </message>
    <message>
        <source>Choose an&amp;other file …</source>
        <translation>Elegir &amp;otro archivo…</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Contenido</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 puntos</translation>
    </message>
    <message>
        <source>%1 of %2 points, one every %3</source>
        <translation>%1 de %2 puntos, uno cada %3</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Desviación</translation>
    </message>
    <message>
        <source>%1 rms</source>
        <translation>%1 RMS</translation>
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
        <translation>Máxima</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Cobertura</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Floor at</source>
        <translation>Suelo en</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Cortes</translation>
    </message>
    <message>
        <source>Cut awa&amp;y …</source>
        <translation>&amp;Recortar…</translation>
    </message>
    <message>
        <source>&amp;Keep only …</source>
        <translation>&amp;Conservar solo…</translation>
    </message>
    <message>
        <source>Keep aroun&amp;d the cover</source>
        <translation>Conservar lo cercano a la &amp;funda</translation>
    </message>
    <message>
        <source>Remove a&amp;ll cuts</source>
        <translation>&amp;Eliminar todos los cortes</translation>
    </message>
    <message>
        <source>Ali&amp;gn …</source>
        <translation>&amp;Alinear…</translation>
    </message>
    <message>
        <source>Between the cover and the scan, where they are nearer than the threshold.</source>
        <translation>Entre la funda y el escaneo, donde están más cerca que el umbral.</translation>
    </message>
    <message>
        <source>Half of what is measured, and 95 % of it, is no farther from the scan than that.</source>
        <translation>La mitad de lo medido, y el 95&#xa0;%, no están más lejos del escaneo que eso.</translation>
    </message>
    <message>
        <source>How much of the cover has points of the scan near it.</source>
        <translation>Qué parte de la funda tiene puntos del escaneo cerca.</translation>
    </message>
    <message>
        <source>Of the scan, without what is cut away.</source>
        <translation>Del escaneo, sin lo recortado.</translation>
    </message>
</context>
<context>
    <name>SeamForm</name>
    <message>
        <source>First side</source>
        <translation>Primer lado</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Second side</source>
        <translation>Segundo lado</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Embebido</translation>
    </message>
</context>
<context>
    <name>SectionHandle</name>
    <message>
        <source>Section at %1 – Ctrl turns it by 15°, Escape puts it back</source>
        <translation>Sección en %1 — Ctrl la gira 15°, Esc la devuelve</translation>
    </message>
    <message>
        <source>Drag to move the section, with Ctrl to turn it</source>
        <translation>Arrastre para mover la sección, con Ctrl para girarla</translation>
    </message>
</context>
<context>
    <name>SelectedEdgesForm</name>
    <message>
        <source>Edge length</source>
        <translation>Longitud del borde</translation>
    </message>
    <message>
        <source>Edge lengths</source>
        <translation>Longitudes de los bordes</translation>
    </message>
    <message>
        <source>%1 edges. Of &quot;Make equally long&quot; the first one stays: %2 of %3.</source>
        <translation>%1 bordes. Con «Igualar longitud» el primero se queda: %2 de %3.</translation>
    </message>
    <message>
        <source>Edge of</source>
        <translation>Borde de</translation>
    </message>
</context>
<context>
    <name>SelectedPointsForm</name>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Layout x, y</source>
        <translation>Disposición x, y</translation>
    </message>
    <message>
        <source>Length between</source>
        <translation>Longitud entre ellos</translation>
    </message>
    <message>
        <source>Space x, y, z</source>
        <translation>Espacio x, y, z</translation>
    </message>
</context>
<context>
    <name>SelectionEdits</name>
    <message>
        <source>Not removed: the curve needs these points.</source>
        <translation>No se elimina: la curva necesita estos puntos.</translation>
    </message>
    <message>
        <source>Not removed: other elements need this fabric.</source>
        <translation>No se elimina: otros elementos necesitan esta tela.</translation>
    </message>
    <message>
        <source>An edge cannot be removed: its points can, or with Esc the whole patch.</source>
        <translation>Un borde no se puede eliminar: sus puntos sí, o con Esc toda la pieza.</translation>
    </message>
</context>
<context>
    <name>SettingsForm</name>
    <message>
        <source>Patches</source>
        <translation>Piezas</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Costuras</translation>
    </message>
    <message>
        <source>Select something to see its properties.</source>
        <translation>Seleccione algo para ver sus propiedades.</translation>
    </message>
    <message>
        <source>Symmetric design</source>
        <translation>Diseño simétrico</translation>
    </message>
    <message>
        <source>Plane through</source>
        <translation>Plano por</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Axis through</source>
        <translation>Eje por</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>%1, %2 in all</source>
        <translation>%1, %2 en total</translation>
    </message>
    <message>
        <source>A point of the plane in which the cover is mirrored</source>
        <translation>Un punto del plano en que se refleja la funda</translation>
    </message>
    <message>
        <source>The direction straight out of that plane</source>
        <translation>La dirección perpendicular a ese plano</translation>
    </message>
    <message>
        <source>A point of the line of the pattern at which patches are mirrored</source>
        <translation>Un punto de la línea del patrón en que se reflejan las piezas</translation>
    </message>
    <message>
        <source>The direction of that line</source>
        <translation>La dirección de esa línea</translation>
    </message>
    <message>
        <source>Twins are mirror images of each other. With this mark you say where the mirror stands; without it, it stands in the middle, between left and right.</source>
        <translation>Los gemelos son imágenes reflejadas uno del otro. Con esta marca usted dice dónde está el espejo; sin ella está en el medio, entre izquierda y derecha.</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vértices</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>unos %1</translation>
    </message>
    <message>
        <source>How many points the cover has at this edge length: solving takes time and memory for each.</source>
        <translation>Cuántos puntos tiene la funda con esta longitud de arista: cada uno cuesta tiempo y memoria al resolver.</translation>
    </message>
</context>
<context>
    <name>SewPicture</name>
    <message>
        <source>Ease %1, %2</source>
        <translation>Embebido %1, %2</translation>
    </message>
</context>
<context>
    <name>SewTool</name>
    <message>
        <source>Click on the outline of a patch.</source>
        <translation>Haga clic en el contorno de una pieza.</translation>
    </message>
    <message>
        <source>Choose the other side first.</source>
        <translation>Elija antes el otro lado.</translation>
    </message>
    <message>
        <source>Release where the stretch ends</source>
        <translation>Suelte donde termina el tramo</translation>
    </message>
    <message>
        <source>Click where the stretch ends – Esc goes back</source>
        <translation>Haga clic donde termina el tramo — Esc vuelve atrás</translation>
    </message>
    <message>
        <source>Click to sew it the other way round (F)</source>
        <translation>Clic para coserlo al revés (F)</translation>
    </message>
    <message>
        <source>Click the edge to sew – drag along the outline, or Shift+click twice, for a part of it; Esc ends the tool</source>
        <translation>Haga clic en el borde que coser — arrastre por el contorno, o Mayús+clic dos veces, para una parte; Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>Click the edges of the row one after the other, Enter sews – F flips, Backspace takes one back</source>
        <translation>Haga clic en los bordes de la fila uno tras otro, Intro cose — F invierte, Retroceso quita uno</translation>
    </message>
    <message>
        <source>Click the edge it is sewn to – F flips, Ctrl+click or M for several in a row, Backspace goes back</source>
        <translation>Haga clic en el borde al que se cose — F invierte, Ctrl+clic o M para varios en fila, Retroceso vuelve atrás</translation>
    </message>
    <message>
        <source>Ctrl+click the next edge of the row, click the last one – Enter sews, F flips, Backspace takes one back</source>
        <translation>Ctrl+clic en el siguiente borde de la fila, clic en el último — Intro cose, F invierte, Retroceso quita uno</translation>
    </message>
    <message>
        <source>&amp;Sew what is marked</source>
        <translation>&amp;Coser lo marcado</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>&amp;Invertir</translation>
    </message>
    <message>
        <source>Take &amp;one edge</source>
        <translation>Tomar &amp;un borde</translation>
    </message>
    <message>
        <source>Take se&amp;veral edges in a row</source>
        <translation>Tomar &amp;varios bordes en fila</translation>
    </message>
    <message>
        <source>&amp;Take back the last edge</source>
        <translation>&amp;Quitar el último borde</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>&amp;Descartar</translation>
    </message>
</context>
<context>
    <name>SewingSheet</name>
    <message>
        <source>Sewing sheet</source>
        <translation>Ficha de confección</translation>
    </message>
    <message>
        <source>Sewing sheet: %1</source>
        <translation>Ficha de confección: %1</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Materiales</translation>
    </message>
    <message>
        <source>Seams in the order of sewing</source>
        <translation>Costuras en orden de costura</translation>
    </message>
    <message>
        <source>%1 and %1 mirrored</source>
        <translation>%1 y %1 en espejo</translation>
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
        <translation>Pieza</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Cantidad</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Tela</translation>
    </message>
    <message>
        <source>Area as cut</source>
        <translation>Área cortada</translation>
    </message>
    <message>
        <source>top stitched on both sides</source>
        <translation>con pespunte a ambos lados</translation>
    </message>
    <message>
        <source>top stitched</source>
        <translation>con pespunte</translation>
    </message>
    <message>
        <source>%1 mm long, %2 mm from the seam</source>
        <translation>de %1&#xa0;mm, a %2&#xa0;mm de la costura</translation>
    </message>
    <message>
        <source>piping, %1 mm thick</source>
        <translation>vivo, %1&#xa0;mm de grosor</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>simple</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>%1, with itself</source>
        <translation>%1, consigo misma</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 con %2</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Costura</translation>
    </message>
    <message>
        <source>Lengths, mm</source>
        <translation>Longitudes, mm</translation>
    </message>
    <message>
        <source>Allowance, mm</source>
        <translation>Margen, mm</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Piquetes</translation>
    </message>
    <message>
        <source>Stitch</source>
        <translation>Puntada</translation>
    </message>
    <message>
        <source>%1 m², without what lies between the pieces</source>
        <translation>%1&#xa0;m², sin lo que queda entre las piezas</translation>
    </message>
    <message>
        <source>Sewing thread</source>
        <translation>Hilo de coser</translation>
    </message>
    <message>
        <source>Top thread &lt;span style=&quot;background-color:%1&quot;&gt;&amp;nbsp;&amp;nbsp;&amp;nbsp;&amp;nbsp;&lt;/span&gt; %1</source>
        <translation>Hilo de pespunte &lt;span style=&quot;background-color:%1&quot;&gt;&#xa0;&#xa0;&#xa0;&#xa0;&lt;/span&gt; %1</translation>
    </message>
    <message>
        <source>%1 m, at %2 m for each metre of a row</source>
        <translation>%1&#xa0;m, a %2&#xa0;m por metro de fila</translation>
    </message>
    <message>
        <source>Piping</source>
        <translation>Vivo</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1&#xa0;m</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>Cuánto</translation>
    </message>
    <message>
        <source>zip</source>
        <translation>cremallera</translation>
    </message>
    <message>
        <source>Zip</source>
        <translation>Cremallera</translation>
    </message>
    <message>
        <source>Pieces, with the numbers of their seams</source>
        <translation>Piezas, con los números de sus costuras</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Costuras</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N.º</translation>
    </message>
    <message>
        <source>Width × height as cut</source>
        <translation>Ancho × alto cortado</translation>
    </message>
    <message>
        <source>Ease, %</source>
        <translation>Embebido, %</translation>
    </message>
    <message>
        <source>nap one way: all pieces point up</source>
        <translation>pelo en un sentido: todas las piezas hacia arriba</translation>
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
        <translation>Sobre un contorno</translation>
    </message>
    <message>
        <source>Aligned</source>
        <translation>Alineado</translation>
    </message>
    <message>
        <source>Direction %1</source>
        <translation>Dirección %1</translation>
    </message>
    <message>
        <source>Perpendicular</source>
        <translation>Perpendicular</translation>
    </message>
    <message>
        <source>As long: %1</source>
        <translation>Igual de largo: %1</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guía</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Cuadrícula</translation>
    </message>
</context>
<context>
    <name>StartCommands</name>
    <message>
        <source>Start pa&amp;ge</source>
        <translation>Página inicia&amp;l</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Nueva &amp;ventana</translation>
    </message>
    <message>
        <source>No other window could be opened.</source>
        <translation>No se pudo abrir otra ventana.</translation>
    </message>
    <message>
        <source>The system did not start the program again. Close some programs, and try once more.</source>
        <translation>El sistema no inició de nuevo el programa. Cierre algunos programas e inténtelo otra vez.</translation>
    </message>
    <message>
        <source>&amp;Report a problem …</source>
        <translation>&amp;Informar de un problema…</translation>
    </message>
    <message>
        <source>What&apos;s &amp;new</source>
        <translation>&amp;Novedades</translation>
    </message>
    <message>
        <source>This is Bolster %1. What is new is under Help &gt; What&apos;s new.</source>
        <translation>Este es Bolster %1. Las novedades están en Ayuda &gt; Novedades.</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Mostrar</translation>
    </message>
    <message>
        <source>The frame is in the 3D view. Draw the curves on it where the cloth is fixed, or the first patch.</source>
        <translation>El armazón está en la vista 3D. Dibuje en él las curvas donde se fija la tela, o la primera pieza.</translation>
    </message>
    <message>
        <source>Draw a &amp;fixation curve</source>
        <translation>Dibujar curva de &amp;fijación</translation>
    </message>
    <message>
        <source>Draw a &amp;rectangle</source>
        <translation>Dibujar &amp;rectángulo</translation>
    </message>
    <message>
        <source>Pattern of a form …</source>
        <translation>Patrón de una forma…</translation>
    </message>
</context>
<context>
    <name>StretchEndDrag</name>
    <message>
        <source>%1 long – Ctrl lets go of what is near, Esc takes it back</source>
        <translation>Longitud %1 — Ctrl suelta lo que está cerca, Esc lo anula</translation>
    </message>
    <message>
        <source>%1 long, the other side %2: ease %3, %4 – Ctrl lets go of what is near, Esc takes it back</source>
        <translation>Longitud %1, el otro lado %2: embebido %3, %4 — Ctrl suelta lo que está cerca, Esc lo anula</translation>
    </message>
    <message>
        <source>End of another stretch</source>
        <translation>Final de otro tramo</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Esquina</translation>
    </message>
    <message>
        <source>As long as the other side</source>
        <translation>Tan largo como el otro lado</translation>
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
        <translation>&amp;Datos…</translation>
    </message>
</context>
<context>
    <name>SweepWindow</name>
    <message>
        <source>&amp;Cut</source>
        <translation>Co&amp;rte</translation>
    </message>
    <message>
        <source>Each piece is cut so much larger or smaller all around</source>
        <translation>Cada pieza se corta ese tanto más grande o más pequeña por todo el contorno</translation>
    </message>
    <message>
        <source>Cut of %1</source>
        <translation>Corte de %1</translation>
    </message>
    <message>
        <source>S&amp;eams</source>
        <translation>Cos&amp;turas</translation>
    </message>
    <message>
        <source>Each seam is sewn so much farther inside or outside, on both sides</source>
        <translation>Cada costura se cose ese tanto más adentro o más afuera, en ambos lados</translation>
    </message>
    <message>
        <source>Seam %1</source>
        <translation>Costura %1</translation>
    </message>
    <message>
        <source>&amp;Foam</source>
        <translation>Esp&amp;uma</translation>
    </message>
    <message>
        <source>Each cushion and foam is so much thicker or thinner</source>
        <translation>Cada acolchado y espuma es ese tanto más grueso o más fino</translation>
    </message>
    <message>
        <source>Thickness of %1</source>
        <translation>Grosor de %1</translation>
    </message>
    <message>
        <source>Fi&amp;xations</source>
        <translation>F&amp;ijaciones</translation>
    </message>
    <message>
        <source>Each fixation curve lies so much elsewhere, along each axis</source>
        <translation>Cada curva de fijación se desplaza ese tanto, a lo largo de cada eje</translation>
    </message>
    <message>
        <source>Place of %1</source>
        <translation>Lugar de %1</translation>
    </message>
    <message>
        <source>S&amp;tiffness</source>
        <translation>Rigide&amp;z</translation>
    </message>
    <message>
        <source>Each fabric is so much stiffer or softer</source>
        <translation>Cada tela es ese tanto más rígida o más blanda</translation>
    </message>
    <message>
        <source>Stiffness of %1</source>
        <translation>Rigidez de %1</translation>
    </message>
    <message>
        <source>Sh&amp;rinkage</source>
        <translation>E&amp;ncogimiento</translation>
    </message>
    <message>
        <source>Each piece shrinks or stretches by so much</source>
        <translation>Cada pieza encoge o se alarga ese tanto</translation>
    </message>
    <message>
        <source>Shrinkage of %1</source>
        <translation>Encogimiento de %1</translation>
    </message>
</context>
<context>
    <name>Templates</name>
    <message>
        <source>Cushion</source>
        <translation>Cojín</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Cojín cilíndrico</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>Banco</translation>
    </message>
    <message>
        <source>Dining chair</source>
        <translation>Silla de comedor</translation>
    </message>
    <message>
        <source>Wing chair</source>
        <translation>Sillón orejero</translation>
    </message>
    <message>
        <source>Car seat</source>
        <translation>Asiento de coche</translation>
    </message>
    <message>
        <source>Headrest</source>
        <translation>Reposacabezas</translation>
    </message>
</context>
<context>
    <name>ToolCommands</name>
    <message>
        <source>&amp;Select and move</source>
        <translation>&amp;Seleccionar y mover</translation>
    </message>
    <message>
        <source>Draw &amp;outline</source>
        <translation>Dibujar co&amp;ntorno</translation>
    </message>
    <message>
        <source>Draw &amp;rectangle</source>
        <translation>Dibujar &amp;rectángulo</translation>
    </message>
    <message>
        <source>Draw &amp;ellipse</source>
        <translation>Dibujar &amp;elipse</translation>
    </message>
    <message>
        <source>S&amp;plit patch</source>
        <translation>Di&amp;vidir pieza</translation>
    </message>
    <message>
        <source>Draw &amp;handle curve</source>
        <translation>Dibujar curva de &amp;tirador</translation>
    </message>
    <message>
        <source>Draw &amp;fancy seam</source>
        <translation>Di&amp;bujar costura decorativa</translation>
    </message>
    <message>
        <source>Se&amp;w</source>
        <translation>&amp;Coser</translation>
    </message>
    <message>
        <source>&amp;Attach to fixation curve</source>
        <translation>Fi&amp;jar a curva de fijación</translation>
    </message>
    <message>
        <source>Stitch or pipe a seam</source>
        <translation>Pespuntear una costura o ponerle vivo</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Medir</translation>
    </message>
    <message>
        <source>&amp;Draw fixation curve</source>
        <translation>&amp;Dibujar curva de fijación</translation>
    </message>
    <message>
        <source>Draw &amp;internal line</source>
        <translation>Dibujar línea &amp;interior</translation>
    </message>
    <message>
        <source>Allowance of an ed&amp;ge</source>
        <translation>Mar&amp;gen de un borde</translation>
    </message>
    <message>
        <source>&amp;Corner of the cut line</source>
        <translation>Es&amp;quina de la línea de corte</translation>
    </message>
    <message>
        <source>Place &amp;notches</source>
        <translation>&amp;Poner piquetes</translation>
    </message>
    <message>
        <source>Place &amp;drill holes</source>
        <translation>Poner t&amp;aladros</translation>
    </message>
    <message>
        <source>&amp;Cutting</source>
        <translation>C&amp;orte</translation>
    </message>
    <message>
        <source>Draw &amp;dart</source>
        <translation>Dibujar pin&amp;za</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Recorrido</translation>
    </message>
    <message>
        <source>The coloured curves on the frame are where the cloth is tied down. Click one of them, then drag one of its points: the cover follows.</source>
        <translation>Las curvas de color en el armazón indican dónde se fija la tela. Haga clic en una y arrastre después uno de sus puntos: la funda lo sigue.</translation>
    </message>
    <message>
        <source>The cover follows while you drag, and comes to rest when you let go.</source>
        <translation>La funda sigue mientras arrastra y se asienta cuando suelta.</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>Deshágalo</translation>
    </message>
    <message>
        <source>Ctrl+Z, or this button, takes back whatever was done, as far as you like. Nothing is lost by it: the history keeps what was undone, too.</source>
        <translation>Ctrl+Z, o este botón, deshace lo que se haya hecho, hasta donde quiera. No se pierde nada: el historial también conserva lo deshecho.</translation>
    </message>
    <message>
        <source>It is as it was. Undone steps are still in the history.</source>
        <translation>Está como estaba. Los pasos deshechos siguen en el historial.</translation>
    </message>
    <message>
        <source>Choose a seam</source>
        <translation>Elija una costura</translation>
    </message>
    <message>
        <source>Seams join two edges of the pattern. Click one, in the pattern or on the cover: both of its edges light up, and the cover shows where it is.</source>
        <translation>Las costuras unen dos bordes del patrón. Haga clic en una, en el patrón o en la funda: sus dos bordes se iluminan y la funda muestra dónde está.</translation>
    </message>
    <message>
        <source>Its properties are at the right now.</source>
        <translation>Ahora sus propiedades están a la derecha.</translation>
    </message>
    <message>
        <source>Change how it is sewn</source>
        <translation>Cambie cómo se cose</translation>
    </message>
    <message>
        <source>With the seam selected, choose another continuity in its properties, or another stitching: an edge, a rounded seam or a smooth one.</source>
        <translation>Con la costura seleccionada, elija en sus propiedades otra continuidad u otro pespunte: una arista, una costura redondeada o una suave.</translation>
    </message>
    <message>
        <source>The cover shows the seam as it will be sewn.</source>
        <translation>La funda muestra la costura tal como se coserá.</translation>
    </message>
    <message>
        <source>Look at the strain</source>
        <translation>Mire la deformación</translation>
    </message>
    <message>
        <source>View &gt; Map colours the cover by what the cloth has to bear. Choose Largest strain to see where it is stretched most.</source>
        <translation>Ver &gt; Mapa colorea la funda según lo que soporta la tela. Elija Deformación máxima para ver dónde está más estirada.</translation>
    </message>
    <message>
        <source>The legend says how much, and the pointer reads it at any place.</source>
        <translation>La leyenda dice cuánto, y el puntero lo lee en cualquier lugar.</translation>
    </message>
    <message>
        <source>Change the pattern</source>
        <translation>Cambie el patrón</translation>
    </message>
    <message>
        <source>Drag a point of an outline, or cut a dart (Pattern &gt; Draw dart): what you change in the flat is sewn at once.</source>
        <translation>Arrastre un punto de un contorno o corte una pinza (Patrón &gt; Dibujar pinza): lo que cambie en plano se cose al momento.</translation>
    </message>
    <message>
        <source>Seams keep their places on an outline that changes.</source>
        <translation>Las costuras conservan su lugar en un contorno que cambia.</translation>
    </message>
    <message>
        <source>Take it with you</source>
        <translation>Lléveselo</translation>
    </message>
    <message>
        <source>File &gt; Export pattern writes DXF, PDF or SVG with seam allowances and notches; Export cover writes the cover for others.</source>
        <translation>Archivo &gt; Exportar patrón escribe DXF, PDF o SVG con márgenes de costura y piquetes; Exportar funda escribe la funda para otros.</translation>
    </message>
    <message>
        <source>The file is written.</source>
        <translation>El archivo está escrito.</translation>
    </message>
    <message>
        <source>That was the tour</source>
        <translation>Fin del recorrido</translation>
    </message>
    <message>
        <source>You have seen how pattern, seams and frame make the cover. Begin with a design of your own: File &gt; Start page has templates. What each key does is under Help &gt; Keys and mouse.</source>
        <translation>Ha visto cómo el patrón, las costuras y el armazón forman la funda. Empiece con un diseño propio: en Archivo &gt; Página inicial hay plantillas. Qué hace cada tecla está en Ayuda &gt; Teclado y ratón.</translation>
    </message>
    <message>
        <source>Drag a fixation curve</source>
        <translation>Arrastrar una curva de fijación</translation>
    </message>
</context>
<context>
    <name>TrimSection</name>
    <message>
        <source>Stitching</source>
        <translation>Pespunte</translation>
    </message>
    <message>
        <source>Colour of the thread</source>
        <translation>Color del hilo</translation>
    </message>
    <message>
        <source>Piping</source>
        <translation>Vivo</translation>
    </message>
    <message>
        <source>As the patch</source>
        <translation>Como la pieza</translation>
    </message>
</context>
<context>
    <name>TwinCommands</name>
    <message>
        <source>Make &amp;mirror twin</source>
        <translation>Crear gemelo &amp;simétrico</translation>
    </message>
    <message>
        <source>Link as t&amp;wins</source>
        <translation>Vincular como &amp;gemelos</translation>
    </message>
    <message>
        <source>&amp;Unlink twins</source>
        <translation>&amp;Desvincular gemelos</translation>
    </message>
    <message>
        <source>R&amp;elease points from the twin</source>
        <translation>&amp;Liberar puntos del gemelo</translation>
    </message>
    <message>
        <source>Re-l&amp;ink points to the twin</source>
        <translation>&amp;Volver a vincular puntos</translation>
    </message>
    <message>
        <source>S&amp;ymmetry …</source>
        <translation>Si&amp;metría…</translation>
    </message>
    <message>
        <source>%1, mirrored</source>
        <translation>%1, en espejo</translation>
    </message>
    <message>
        <source>Select patches or curves that have no twin yet.</source>
        <translation>Seleccione piezas o curvas que aún no tengan gemelo.</translation>
    </message>
    <message>
        <source>Nothing that is selected has a twin.</source>
        <translation>Nada de lo seleccionado tiene gemelo.</translation>
    </message>
    <message>
        <source>Select points of a twin, or a seam on it, that still follow.</source>
        <translation>Seleccione puntos de un gemelo, o una costura en él, que aún lo sigan.</translation>
    </message>
    <message>
        <source>No point that is selected has been released.</source>
        <translation>Ningún punto seleccionado está liberado.</translation>
    </message>
</context>
<context>
    <name>TwinForm</name>
    <message>
        <source>Mirror image</source>
        <translation>Imagen especular</translation>
    </message>
    <message>
        <source>released</source>
        <translation>liberada</translation>
    </message>
    <message>
        <source>itself</source>
        <translation>ella misma</translation>
    </message>
    <message>
        <source>Re-lin&amp;k to its mirror image</source>
        <translation>&amp;Volver a vincular a su imagen</translation>
    </message>
    <message>
        <source>Re&amp;lease from its mirror image</source>
        <translation>&amp;Liberar de su imagen especular</translation>
    </message>
    <message>
        <source>Twin of</source>
        <translation>Gemelo de</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>Excepciones</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message numerus="yes">
        <source>%n released points</source>
        <translation>
            <numerusform>%n punto liberado</numerusform>
            <numerusform>%n puntos liberados</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Unlink from its twin</source>
        <translation>&amp;Desvincular de su gemelo</translation>
    </message>
    <message>
        <source>Re-link all poi&amp;nts</source>
        <translation>Volver a vincular todos los &amp;puntos</translation>
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
        <translation>Problemas</translation>
    </message>
    <message>
        <source>It keeps its text and is saved as it is.</source>
        <translation>Conserva su texto y se guarda tal como está.</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>Show &amp;all</source>
        <translation>Mostrar &amp;todo</translation>
    </message>
    <message>
        <source>Show &amp;selection</source>
        <translation>Mostrar &amp;selección</translation>
    </message>
    <message>
        <source>Look at the &amp;cover from</source>
        <translation>Mirar la &amp;funda desde</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Delante</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>De&amp;trás</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Izquierda</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>De&amp;recha</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Arriba</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>A&amp;bajo</translation>
    </message>
    <message>
        <source>Three-&amp;quarter</source>
        <translation>Tres &amp;cuartos</translation>
    </message>
    <message>
        <source>Sa&amp;ved views</source>
        <translation>Vistas &amp;guardadas</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspectiva</translation>
    </message>
    <message>
        <source>Sec&amp;tion</source>
        <translation>Secció&amp;n</translation>
    </message>
    <message>
        <source>Lin&amp;k the views</source>
        <translation>&amp;Vincular las vistas</translation>
    </message>
    <message>
        <source>Show the pointer&apos;s place in the other view, too</source>
        <translation>Mostrar el lugar del puntero también en la otra vista</translation>
    </message>
    <message>
        <source>&amp;Hide selected</source>
        <translation>&amp;Ocultar lo seleccionado</translation>
    </message>
    <message>
        <source>&amp;Isolate selected</source>
        <translation>Ais&amp;lar lo seleccionado</translation>
    </message>
    <message>
        <source>Sho&amp;w hidden again</source>
        <translation>Most&amp;rar lo oculto</translation>
    </message>
    <message>
        <source>Th&amp;eme</source>
        <translation>T&amp;ema</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Como el &amp;sistema</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Oscuro</translation>
    </message>
    <message>
        <source>&amp;Opacity</source>
        <translation>Opaci&amp;dad</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>Frames and foam</source>
        <translation>Armazones y espuma</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Escaneos</translation>
    </message>
    <message>
        <source>Opacity of frames and scans</source>
        <translation>Opacidad de armazones y escaneos</translation>
    </message>
    <message>
        <source>Select patches, curves, frames, foam or scans to hide them.</source>
        <translation>Seleccione piezas, curvas, armazones, espuma o escaneos para ocultarlos.</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>&amp;Alto contraste</translation>
    </message>
</context>
<context>
    <name>ViewPrint</name>
    <message>
        <source>Print the view</source>
        <translation>Imprimir vista</translation>
    </message>
    <message>
        <source>The view could not be printed.</source>
        <translation>No se pudo imprimir la vista.</translation>
    </message>
    <message>
        <source>The printer takes nothing at the moment. Look whether it is on and has paper, or print to a file.</source>
        <translation>La impresora no acepta nada en este momento. Compruebe que está encendida y tiene papel, o imprima en un archivo.</translation>
    </message>
</context>
<context>
    <name>WhatsNew</name>
    <message>
        <source>What&apos;s new</source>
        <translation>Novedades</translation>
    </message>
</context>
<context>
    <name>WindowCommands</name>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>Parte &amp;siguiente de la ventana</translation>
    </message>
    <message>
        <source>Pre&amp;vious part of the window</source>
        <translation>Parte &amp;anterior de la ventana</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Restablecer disposición</translation>
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
        <translation>&amp;Solo en una zona pintada</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Pintar</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>The form and the limit of strain count only there</source>
        <translation>La forma y el límite de deformación cuentan solo ahí</translation>
    </message>
    <message>
        <source>Drag over the cover in the 3D view; with Shift held down it takes away</source>
        <translation>Arrastre sobre la funda en la vista 3D; con Mayús pulsada quita</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Radio del pincel</translation>
    </message>
    <message>
        <source>Painted area</source>
        <translation>Zona pintada</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
</context>
<context>
    <name>bolster::Banner</name>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>bolster::CanvasChoice</name>
    <message>
        <source>Drawn in software</source>
        <translation>Dibujado por software</translation>
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
        <translation>¿Por qué es así?</translation>
    </message>
    <message>
        <source>The scan of the piece</source>
        <translation>El escaneo de la pieza</translation>
    </message>
    <message>
        <source>The scan of a sound piece</source>
        <translation>El escaneo de una pieza correcta</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Of a piece that is as it should be: where that lies elsewhere than the cover no cause is looked for</source>
        <translation>De una pieza que está como debe: donde también ella se aparta de la funda no se busca ninguna causa</translation>
    </message>
    <message>
        <source>Scan of the &amp;piece</source>
        <translation>Escaneo de la &amp;pieza</translation>
    </message>
    <message>
        <source>Scan of a so&amp;und piece</source>
        <translation>Escaneo de una pieza c&amp;orrecta</translation>
    </message>
    <message>
        <source>Look for the &amp;cause</source>
        <translation>&amp;Buscar la causa</translation>
    </message>
    <message>
        <source>Looking for a cause …</source>
        <translation>Buscando una causa…</translation>
    </message>
    <message>
        <source>Says which one cause explains best how far a built piece lies from the cover: foam, a seam&apos;s allowance, a stretched piece, a fixation off its place, a slipped notch.</source>
        <translation>Dice qué única causa explica mejor cuánto se aparta de la funda una pieza fabricada: espuma, margen de una costura, pieza estirada, fijación fuera de lugar, piquete desplazado.</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Causa</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Magnitud</translation>
    </message>
    <message>
        <source>Explains</source>
        <translation>Explica</translation>
    </message>
    <message>
        <source>Probability</source>
        <translation>Probabilidad</translation>
    </message>
    <message>
        <source>Causes</source>
        <translation>Causas</translation>
    </message>
    <message>
        <source>Choose the scan of the piece that was built.</source>
        <translation>Elija el escaneo de la pieza fabricada.</translation>
    </message>
    <message>
        <source>Covers with each cause are solved …</source>
        <translation>Calculando las fundas con cada causa…</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Detenido.</translation>
    </message>
    <message>
        <source>The scan shows nothing of the cover: does it lie where the design is?</source>
        <translation>El escaneo no muestra nada de la funda: ¿está donde está el diseño?</translation>
    </message>
    <message>
        <source>The scan shows %1 of the cover and lies %2 (rms) from it. All causes together leave %3.</source>
        <translation>El escaneo muestra el %1 de la funda y está a %2 (RMS) de ella. Todas las causas juntas dejan %3.</translation>
    </message>
    <message>
        <source>No single cause explains that better than noise does.</source>
        <translation>Ninguna causa única lo explica mejor que el ruido.</translation>
    </message>
    <message>
        <source>Most of the deviation has no cause of these kinds, so the first need not be the right one: give the scan of a sound piece, too.</source>
        <translation>La mayor parte de la desviación no tiene causa de estos tipos, así que la primera puede no ser la correcta: indique también el escaneo de una pieza correcta.</translation>
    </message>
    <message numerus="yes">
        <source>and %n others</source>
        <translation>
            <numerusform>y %n más</numerusform>
            <numerusform>y %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>The scan does not tell it apart from: %1</source>
        <translation>El escaneo no la distingue de: %1</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: look again.</source>
        <translation>El diseño ha cambiado entretanto: busque de nuevo.</translation>
    </message>
    <message>
        <source>Stopped. The list is that of the search before.</source>
        <translation>Detenido. La lista es la de la búsqueda anterior.</translation>
    </message>
    <message>
        <source>The scan lies on the cover: there is nothing to explain.</source>
        <translation>El escaneo coincide con la funda: no hay nada que explicar.</translation>
    </message>
    <message>
        <source>Even the likeliest cause explains only %1 of it: there may be several, or others than these.</source>
        <translation>Incluso la causa más probable explica solo el %1: puede haber varias, u otras distintas.</translation>
    </message>
    <message>
        <source>Foam is thicker or thinner</source>
        <translation>Espuma más gruesa o más fina</translation>
    </message>
    <message>
        <source>Foam is harder or softer</source>
        <translation>Espuma más dura o más blanda</translation>
    </message>
    <message>
        <source>Allowance of a seam</source>
        <translation>Margen de una costura</translation>
    </message>
    <message>
        <source>Piece is larger or smaller</source>
        <translation>Pieza más grande o más pequeña</translation>
    </message>
    <message>
        <source>Fixation lies elsewhere</source>
        <translation>Fijación en otro lugar</translation>
    </message>
    <message>
        <source>Seam is sewn shifted</source>
        <translation>Costura cosida con desfase</translation>
    </message>
    <message>
        <source>%1 thicker</source>
        <translation>%1 más gruesa</translation>
    </message>
    <message>
        <source>%1 thinner</source>
        <translation>%1 más fina</translation>
    </message>
    <message>
        <source>%1 harder</source>
        <translation>%1 más dura</translation>
    </message>
    <message>
        <source>%1 softer</source>
        <translation>%1 más blanda</translation>
    </message>
    <message>
        <source>%1 farther out</source>
        <translation>%1 más afuera</translation>
    </message>
    <message>
        <source>%1 farther in</source>
        <translation>%1 más adentro</translation>
    </message>
    <message>
        <source>%1 larger</source>
        <translation>%1 más grande</translation>
    </message>
    <message>
        <source>%1 smaller</source>
        <translation>%1 más pequeña</translation>
    </message>
    <message>
        <source>%1 counter-clockwise</source>
        <translation>%1 en sentido antihorario</translation>
    </message>
    <message>
        <source>%1 clockwise</source>
        <translation>%1 en sentido horario</translation>
    </message>
    <message>
        <source>Farther out: the allowance was taken narrower, on both sides</source>
        <translation>Más afuera: se tomó un margen más estrecho, a ambos lados</translation>
    </message>
    <message>
        <source>Along the edge of %1, as it lies in the pattern</source>
        <translation>A lo largo del borde de %1, tal como está en el patrón</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>menos del %1</translation>
    </message>
    <message>
        <source>The scan shows %1 of the cover. Its points lie %2 (rms) from the cover, of which all causes together leave %3. From the cover to the nearest point, as a fit measures, it is %4.</source>
        <translation>El escaneo muestra el %1 de la funda. Sus puntos están a %2 (RMS) de la funda, de los que todas las causas juntas dejan %3. De la funda al punto más cercano, como mide una adaptación, son %4.</translation>
    </message>
    <message>
        <source>That is far more than such a cause usually is: there may be several, or others than these.</source>
        <translation>Es mucho más de lo habitual en una causa así: puede haber varias, u otras distintas.</translation>
    </message>
    <message>
        <source>What the likeliest cause leaves is more than noise: something else may be wrong, too, and its amount may be off by more than is said.</source>
        <translation>Lo que deja la causa más probable es más que ruido: puede haber algo más que esté mal, y su medida puede fallar más de lo indicado.</translation>
    </message>
    <message numerus="yes">
        <source>%n more causes explain some of it, less likely than these.</source>
        <translation>
            <numerusform>%n causa más explica algo, menos probable que estas.</numerusform>
            <numerusform>%n causas más explican algo, menos probables que estas.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::ColourwayWindow</name>
    <message>
        <source>Compare colourways</source>
        <translation>Comparar variantes de color</translation>
    </message>
    <message>
        <source>The colourway that is shown below</source>
        <translation>La variante de color mostrada debajo</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>Como está hecha</translation>
    </message>
</context>
<context>
    <name>bolster::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Buscar un comando</translation>
    </message>
    <message>
        <source>There is no such command.</source>
        <translation>No existe tal comando.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Comandos</translation>
    </message>
</context>
<context>
    <name>bolster::CompareWindow</name>
    <message>
        <source>&amp;Take from there</source>
        <translation>&amp;Tomar de allí</translation>
    </message>
    <message>
        <source>Compare versions</source>
        <translation>Comparar versiones</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>Qué difiere</translation>
    </message>
    <message>
        <source>There</source>
        <translation>Allí</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Ahora</translation>
    </message>
    <message>
        <source>Makes the chosen elements as they are in the other version: one step in the history</source>
        <translation>Deja los elementos elegidos como están en la otra versión: un paso del historial</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>only now</source>
        <translation>solo ahora</translation>
    </message>
    <message>
        <source>only there</source>
        <translation>solo allí</translation>
    </message>
    <message>
        <source>Nothing differs</source>
        <translation>Nada difiere</translation>
    </message>
    <message>
        <source>&amp;Move both together</source>
        <translation>&amp;Mover ambas juntas</translation>
    </message>
    <message>
        <source>Turning, moving or zooming one version does the same to the other</source>
        <translation>Girar, mover o ampliar una versión hace lo mismo en la otra</translation>
    </message>
</context>
<context>
    <name>bolster::ContextMenus</name>
    <message>
        <source>Leave this &amp;piece out</source>
        <translation>&amp;Omitir este trozo</translation>
    </message>
    <message>
        <source>Hides this piece of the frame from the view, drawing, cushioning and contact; the frame&apos;s properties bring it back</source>
        <translation>Oculta este trozo del armazón en la vista, el dibujo, el acolchado y el contacto; las propiedades del armazón lo recuperan</translation>
    </message>
</context>
<context>
    <name>bolster::CoverSelectTool</name>
    <message>
        <source>Kept to an axis; the same key frees it</source>
        <translation>Sujeto a un eje; la misma tecla lo libera</translation>
    </message>
    <message>
        <source>Lifted off the frame along its normal; let go of Ctrl to slide on it</source>
        <translation>Separado del armazón por su normal; suelte Ctrl para deslizarlo sobre él</translation>
    </message>
    <message>
        <source>On the frame: Ctrl lifts off, S lets go of it, X, Y, Z or Shift keep to an axis</source>
        <translation>Sobre el armazón: Ctrl separa, S lo suelta, X, Y, Z o Mayús fijan un eje</translation>
    </message>
    <message>
        <source>X, Y, Z or Shift keep to an axis, S keeps to the frame, Ctrl lifts off, Escape cancels</source>
        <translation>X, Y, Z o Mayús fijan un eje, S lo mantiene en el armazón, Ctrl separa, Esc cancela</translation>
    </message>
    <message>
        <source>Moved by x %1, y %2, z %3</source>
        <translation>Movido x %1, y %2, z %3</translation>
    </message>
</context>
<context>
    <name>bolster::CutFindingsList</name>
    <message>
        <source>What to look at before cutting</source>
        <translation>Qué revisar antes de cortar</translation>
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
        <translation>Un doble clic muestra dónde está.</translation>
    </message>
    <message>
        <source>Nothing to mend: the pattern can be cut.</source>
        <translation>Nada que corregir: el patrón se puede cortar.</translation>
    </message>
    <message>
        <source>Looking the pattern over …</source>
        <translation>Revisando el patrón…</translation>
    </message>
    <message>
        <source>There is no pattern yet.</source>
        <translation>Aún no hay patrón.</translation>
    </message>
</context>
<context>
    <name>bolster::DesignSession</name>
    <message>
        <source>New design</source>
        <translation>Diseño nuevo</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Tela</translation>
    </message>
    <message>
        <source>Restored design</source>
        <translation>Diseño restaurado</translation>
    </message>
    <message>
        <source> (other)</source>
        <translation> (otro)</translation>
    </message>
    <message>
        <source> (other %1)</source>
        <translation> (otro %1)</translation>
    </message>
</context>
<context>
    <name>bolster::DockTitle</name>
    <message>
        <source>Take out of the window, or put back</source>
        <translation>Sacar de la ventana o devolver</translation>
    </message>
    <message>
        <source>Close; the Window menu brings it back</source>
        <translation>Cerrar; el menú «Ventana» lo recupera</translation>
    </message>
</context>
<context>
    <name>bolster::DropFlow</name>
    <message>
        <source>&quot;%1&quot; cannot be opened.</source>
        <translation>No se puede abrir «%1».</translation>
    </message>
    <message>
        <source>The system did not start the program again for another window. Open it from here instead.</source>
        <translation>El sistema no inició de nuevo el programa para otra ventana. Ábralo desde aquí.</translation>
    </message>
    <message>
        <source>It is a folder. Drop the files that are in it.</source>
        <translation>Es una carpeta. Suelte los archivos que contiene.</translation>
    </message>
    <message>
        <source>It is not on this computer, or not any more. Save it to a folder first.</source>
        <translation>No está en este equipo, o ya no. Guárdelo antes en una carpeta.</translation>
    </message>
    <message>
        <source>Bolster opens projects and designs (%1), frames (%2), scans (%3), patterns (%4) and pictures of fabrics (%5). Save it in one of these formats with the program it comes from.</source>
        <translation>Bolster abre proyectos y diseños (%1), armazones (%2), escaneos (%3), patrones (%4) e imágenes de telas (%5). Guárdelo en uno de estos formatos con el programa de origen.</translation>
    </message>
</context>
<context>
    <name>bolster::ElementsModel</name>
    <message>
        <source>Hidden in the 3D view</source>
        <translation>Oculto en la vista 3D</translation>
    </message>
</context>
<context>
    <name>bolster::ElementsView</name>
    <message>
        <source>Find an element</source>
        <translation>Buscar un elemento</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elementos</translation>
    </message>
    <message>
        <source>By its name, or by a word of its note</source>
        <translation>Por su nombre o por una palabra de su nota</translation>
    </message>
</context>
<context>
    <name>bolster::ExportFlow</name>
    <message>
        <source>Export pattern</source>
        <translation>Exportar patrón</translation>
    </message>
    <message>
        <source>-sewing</source>
        <translation>-confeccion</translation>
    </message>
    <message>
        <source>-pattern</source>
        <translation>-patron</translation>
    </message>
    <message>
        <source>%1 (*.%2)</source>
        <translation>%1 (*.%2)</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>Escribiendo %1…</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Exportado a %1</translation>
    </message>
    <message>
        <source>The pattern could not be exported.</source>
        <translation>No se pudo exportar el patrón.</translation>
    </message>
    <message>
        <source>Export cover</source>
        <translation>Exportar funda</translation>
    </message>
    <message>
        <source>-cover</source>
        <translation>-funda</translation>
    </message>
    <message>
        <source>Export foam</source>
        <translation>Exportar espuma</translation>
    </message>
    <message>
        <source>-foam</source>
        <translation>-espuma</translation>
    </message>
    <message>
        <source>Exporting %1 …</source>
        <translation>Exportando %1…</translation>
    </message>
    <message>
        <source>The cover could not be exported.</source>
        <translation>No se pudo exportar la funda.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is written.</source>
        <translation>«%1» está escrito.</translation>
    </message>
    <message>
        <source>Export surface</source>
        <translation>Exportar superficie</translation>
    </message>
    <message>
        <source>The surface could not be exported.</source>
        <translation>No se pudo exportar la superficie.</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Exportar imagen</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>The picture could not be exported.</source>
        <translation>No se pudo exportar la imagen.</translation>
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
        <translation>Exportar patrón</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Piezas</translation>
    </message>
    <message>
        <source>&amp;Export …</source>
        <translation>&amp;Exportar…</translation>
    </message>
    <message>
        <source>PDF – to print and put together</source>
        <translation>PDF — para imprimir y unir</translation>
    </message>
    <message>
        <source>DXF AAMA – for cutters</source>
        <translation>DXF AAMA — para cortadoras</translation>
    </message>
    <message>
        <source>DXF ASTM – for cutters</source>
        <translation>DXF ASTM — para cortadoras</translation>
    </message>
    <message>
        <source>DXF, plain lines</source>
        <translation>DXF, líneas simples</translation>
    </message>
    <message>
        <source>SVG – 1:1</source>
        <translation>SVG — 1:1</translation>
    </message>
    <message>
        <source>HPGL – for plotters</source>
        <translation>HPGL — para plóteres</translation>
    </message>
    <message>
        <source>Roll, %1 mm wide</source>
        <translation>Rollo, %1&#xa0;mm de ancho</translation>
    </message>
    <message>
        <source>&amp;Landscape</source>
        <translation>Apai&amp;sado</translation>
    </message>
    <message>
        <source>Mirrored pairs as &amp;two pieces</source>
        <translation>Pares en espejo como &amp;dos piezas</translation>
    </message>
    <message>
        <source>The design says it; it is changed in its properties.</source>
        <translation>Lo dice el diseño; se cambia en sus propiedades.</translation>
    </message>
    <message>
        <source>Of patches and edges that have none of their own.</source>
        <translation>De piezas y bordes que no tienen propio.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Formato</translation>
    </message>
    <message>
        <source>&amp;Paper</source>
        <translation>&amp;Papel</translation>
    </message>
    <message>
        <source>Seam &amp;allowance</source>
        <translation>&amp;Margen de costura</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Líneas</translation>
    </message>
    <message>
        <source>Sewing li&amp;nes</source>
        <translation>Líneas de &amp;costura</translation>
    </message>
    <message>
        <source>Notc&amp;hes</source>
        <translation>Pi&amp;quetes</translation>
    </message>
    <message>
        <source>&amp;Grain lines</source>
        <translation>Líneas de &amp;hilo</translation>
    </message>
    <message>
        <source>La&amp;bels</source>
        <translation>E&amp;tiquetas</translation>
    </message>
    <message>
        <source>&amp;Internal lines</source>
        <translation>Líneas &amp;interiores</translation>
    </message>
    <message>
        <source>&amp;Drill holes</source>
        <translation>T&amp;aladros</translation>
    </message>
    <message numerus="yes">
        <source>%n pages</source>
        <translation>
            <numerusform>%n página</numerusform>
            <numerusform>%n páginas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n patches are left out: their outlines cross themselves</source>
        <translation>
            <numerusform>se omite %n pieza: su contorno se cruza</numerusform>
            <numerusform>se omiten %n piezas: sus contornos se cruzan</numerusform>
        </translation>
    </message>
    <message>
        <source>C&amp;ut lines</source>
        <translation>Líneas de co&amp;rte</translation>
    </message>
    <message>
        <source>Sewing sheet (PDF)</source>
        <translation>Ficha de confección (PDF)</translation>
    </message>
    <message>
        <source>DXF, plain curves (R2000)</source>
        <translation>DXF, curvas simples (R2000)</translation>
    </message>
    <message>
        <source>too many sheets: is its unit right?</source>
        <translation>demasiadas hojas: ¿es correcta la unidad?</translation>
    </message>
    <message>
        <source>the first %1 are shown</source>
        <translation>se muestran las primeras %1</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>No hay nada que cortar.</translation>
    </message>
    <message>
        <source>A double click leaves this window and shows where it is; the whole list is in the panel &quot;Check before cutting&quot;.</source>
        <translation>Un doble clic sale de esta ventana y muestra dónde está; la lista completa está en el panel «Revisión antes de cortar».</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces on %1</source>
        <translation>
            <numerusform>%n pieza en %1</numerusform>
            <numerusform>%n piezas en %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FabricCommands</name>
    <message>
        <source>Rename fabric</source>
        <translation>Cambiar nombre de tela</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nombre:</translation>
    </message>
    <message>
        <source>Delete fabric</source>
        <translation>Eliminar tela</translation>
    </message>
    <message numerus="yes">
        <source>%n patches have &quot;%1&quot;. What shall they get instead?</source>
        <translation>
            <numerusform>%n pieza tiene «%1». ¿Qué debe recibir en su lugar?</numerusform>
            <numerusform>%n piezas tienen «%1». ¿Qué deben recibir en su lugar?</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the patches that shall get the fabric, then choose it in the library.</source>
        <translation>Seleccione las piezas que deban recibir la tela y elíjala después en la biblioteca.</translation>
    </message>
    <message>
        <source>New colourway</source>
        <translation>Nueva variante de color</translation>
    </message>
    <message>
        <source>Name of the colourway; it begins as what is shown now:</source>
        <translation>Nombre de la variante de color; empieza con lo que se ve ahora:</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>Variante de color</translation>
    </message>
    <message>
        <source>Rename colourway</source>
        <translation>Cambiar nombre de variante</translation>
    </message>
    <message>
        <source>Picture of a fabric</source>
        <translation>Imagen de una tela</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Imágenes (%1)</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Leyendo %1…</translation>
    </message>
    <message>
        <source>The picture could not be read.</source>
        <translation>No se pudo leer la imagen.</translation>
    </message>
    <message>
        <source>The picture could not be taken into the design.</source>
        <translation>No se pudo incorporar la imagen al diseño.</translation>
    </message>
    <message>
        <source>Import fabrics</source>
        <translation>Importar telas</translation>
    </message>
    <message>
        <source>Fabrics, designs and projects (*.json *.bolster)</source>
        <translation>Telas, diseños y proyectos (*.json *.bolster)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be read.</source>
        <translation>No se pudo leer «%1».</translation>
    </message>
    <message>
        <source>Nothing was imported.</source>
        <translation>No se importó nada.</translation>
    </message>
    <message numerus="yes">
        <source>%n fabrics imported from %1</source>
        <translation>
            <numerusform>%n tela importada de %1</numerusform>
            <numerusform>%n telas importadas de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Export fabric</source>
        <translation>Exportar tela</translation>
    </message>
    <message>
        <source>Fabrics (*.json)</source>
        <translation>Telas (*.json)</translation>
    </message>
    <message>
        <source>The fabric could not be exported.</source>
        <translation>No se pudo exportar la tela.</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Exportado a %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not deleted.</source>
        <translation>«%1» no se elimina.</translation>
    </message>
    <message>
        <source>It is the only fabric, and patches are made of it. Add another one first.</source>
        <translation>Es la única tela y hay piezas hechas de ella. Añada antes otra.</translation>
    </message>
</context>
<context>
    <name>bolster::FabricPanel</name>
    <message>
        <source>Colourways</source>
        <translation>Variantes de color</translation>
    </message>
    <message>
        <source>A click shows the cover in this colourway</source>
        <translation>Un clic muestra la funda en esta variante de color</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Telas</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>Variante de color</translation>
    </message>
    <message>
        <source>New …</source>
        <translation>Nueva…</translation>
    </message>
    <message>
        <source>Rename …</source>
        <translation>Cambiar nombre…</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Fabrics: drag them onto patches</source>
        <translation>Telas: arrástrelas a las piezas</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nueva</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Asignar</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Delete …</source>
        <translation>Eliminar…</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>Como está hecha</translation>
    </message>
    <message>
        <source>No patch has it.</source>
        <translation>Ninguna pieza la tiene.</translation>
    </message>
    <message numerus="yes">
        <source>%n patches have it.</source>
        <translation>
            <numerusform>%n pieza la tiene.</numerusform>
            <numerusform>%n piezas la tienen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag it onto a patch; a double click shows its properties.</source>
        <translation>Arrástrela a una pieza; un doble clic muestra sus propiedades.</translation>
    </message>
    <message>
        <source>Adds this fabric to the library of the design</source>
        <translation>Añade esta tela a la biblioteca del diseño</translation>
    </message>
</context>
<context>
    <name>bolster::FieldText</name>
    <message>
        <source>usual</source>
        <translation>habitual</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
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
        <translation>girado %1</translation>
    </message>
    <message>
        <source>%1, from %2 to %3</source>
        <translation>%1, de %2 a %3</translation>
    </message>
    <message numerus="yes">
        <source>%n points, %1</source>
        <translation>
            <numerusform>%n punto, %1</numerusform>
            <numerusform>%n puntos, %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FileChoice</name>
    <message>
        <source>A file …</source>
        <translation>Un archivo…</translation>
    </message>
</context>
<context>
    <name>bolster::FileImportDialog</name>
    <message>
        <source> mm per unit</source>
        <translation> mm por unidad</translation>
    </message>
    <message>
        <source>Import scan</source>
        <translation>Importar escaneo</translation>
    </message>
    <message>
        <source>Import frame</source>
        <translation>Importar armazón</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Milímetros</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centímetros</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Metros</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pulgadas</translation>
    </message>
    <message>
        <source>Another factor</source>
        <translation>Otro factor</translation>
    </message>
    <message>
        <source>z points up</source>
        <translation>z hacia arriba</translation>
    </message>
    <message>
        <source>y points up</source>
        <translation>y hacia arriba</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 puntos</translation>
    </message>
    <message>
        <source>Width, depth, height</source>
        <translation>Ancho, fondo, alto</translation>
    </message>
    <message>
        <source>That is unusual for a piece of furniture: check the unit.</source>
        <translation>Eso no es habitual en un mueble: revise la unidad.</translation>
    </message>
    <message>
        <source>&amp;Keep scale, position and rotation</source>
        <translation>&amp;Conservar escala, posición y rotación</translation>
    </message>
    <message>
        <source>&amp;Place it on the floor, in the middle</source>
        <translation>&amp;Poner en el suelo, en el centro</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>&amp;Unidad del archivo</translation>
    </message>
    <message>
        <source>&amp;Factor</source>
        <translation>&amp;Factor</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>&amp;Ejes</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importar</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>It would be %1 large. Import it like that?</source>
        <translation>Mediría %1. ¿Importarlo así?</translation>
    </message>
    <message>
        <source>Another unit or factor makes it as large as it is meant.</source>
        <translation>Otra unidad o factor le da el tamaño previsto.</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pies</translation>
    </message>
    <message>
        <source>x points up</source>
        <translation>x hacia arriba</translation>
    </message>
    <message>
        <source>The file says its unit and its axes.</source>
        <translation>El archivo indica su unidad y sus ejes.</translation>
    </message>
    <message numerus="yes">
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points, %Ln triangles</source>
        <translation>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 puntos, %Ln triángulo</numerusform>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 puntos, %Ln triángulos</numerusform>
        </translation>
    </message>
    <message>
        <source>The file says its unit; the axes are guessed.</source>
        <translation>El archivo indica su unidad; los ejes se suponen.</translation>
    </message>
    <message>
        <source>The file says its axes; the unit is guessed.</source>
        <translation>El archivo indica sus ejes; la unidad se supone.</translation>
    </message>
    <message>
        <source>Unit and axes are guessed: look at the picture and the size.</source>
        <translation>Unidad y ejes se suponen: mire la imagen y el tamaño.</translation>
    </message>
    <message>
        <source>&amp;Keep position and rotation</source>
        <translation>&amp;Conservar posición y rotación</translation>
    </message>
    <message>
        <source>The file has %1 points. That is more than are needed to fit a cover, so they were thinned out to one every %2.</source>
        <translation>El archivo tiene %1 puntos. Son más de los necesarios para adaptar una funda, así que se redujeron a uno cada %2.</translation>
    </message>
    <message>
        <source>It was %1 large and becomes %2: check the unit.</source>
        <translation>Medía %1 y pasa a medir %2: revise la unidad.</translation>
    </message>
    <message>
        <source>The unit is guessed: look at the size.</source>
        <translation>La unidad es una suposición: mire el tamaño.</translation>
    </message>
    <message>
        <source>The axes are guessed: look at the picture.</source>
        <translation>Los ejes son una suposición: mire la imagen.</translation>
    </message>
</context>
<context>
    <name>bolster::FileTalk</name>
    <message>
        <source>&quot;%1&quot; is not replaced.</source>
        <translation>«%1» no se reemplaza.</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Leyendo %1…</translation>
    </message>
</context>
<context>
    <name>bolster::FitOrderPanel</name>
    <message>
        <source>Goal</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>The cover &amp;lies on</source>
        <translation>La &amp;funda se ajusta a</translation>
    </message>
    <message>
        <source>The form that the cover shall lie on</source>
        <translation>La forma a la que debe ajustarse la funda</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>&amp;Strain is at most</source>
        <translation>La &amp;deformación es como máximo</translation>
    </message>
    <message>
        <source>Along the grain, across it, and in shear; the cover stays where it is</source>
        <translation>Al hilo, a contrahilo y en cizalladura; la funda se queda donde está</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Limit of strain</source>
        <translation>Límite de deformación</translation>
    </message>
    <message>
        <source>&amp;No folds in selected patches</source>
        <translation>Sin plie&amp;gues en las piezas seleccionadas</translation>
    </message>
    <message>
        <source>No cloth of them is pressed together; none selected: all</source>
        <translation>Ninguna parte de su tela queda comprimida; si no hay ninguna seleccionada: todas</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>The selected seam r&amp;uns along</source>
        <translation>La &amp;costura seleccionada sigue</translation>
    </message>
    <message>
        <source>A curve drawn on the frame or the form; it need hold nothing</source>
        <translation>Una curva dibujada en el armazón o la forma; no hace falta que fije nada</translation>
    </message>
    <message>
        <source>Share of the area</source>
        <translation>Proporción del área</translation>
    </message>
    <message>
        <source>Area of selected patches &amp;becomes</source>
        <translation>Área que conser&amp;van las piezas seleccionadas</translation>
    </message>
    <message>
        <source>Less than 100 %: they become smaller</source>
        <translation>Menos del 100&#xa0;%: se hacen más pequeñas</translation>
    </message>
    <message>
        <source>What may change</source>
        <translation>Qué puede cambiar</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>C&amp;ontornos</translation>
    </message>
    <message>
        <source>Control points of the patches</source>
        <translation>Puntos de control de las piezas</translation>
    </message>
    <message>
        <source>Ends of seams</source>
        <translation>Extremos</translation>
    </message>
    <message>
        <source>Where seams and fixations end on smooth edges</source>
        <translation>Dónde terminan costuras y fijaciones en bordes lisos</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Embebido</translation>
    </message>
    <message>
        <source>Sides of seams may come to differ in length; that is then the ease wanted</source>
        <translation>Los lados de las costuras pueden llegar a tener longitud distinta; ese es entonces el embebido deseado</translation>
    </message>
    <message>
        <source>Fo&amp;am</source>
        <translation>Esp&amp;uma</translation>
    </message>
    <message>
        <source>How thick cushions and foam are, by whole voxels</source>
        <translation>Grosor del acolchado y la espuma, en vóxeles enteros</translation>
    </message>
    <message>
        <source>F&amp;ixations</source>
        <translation>F&amp;ijaciones</translation>
    </message>
    <message>
        <source>Where fixation curves lie: on their frames, or in space where there is none</source>
        <translation>Dónde están las curvas de fijación: sobre sus armazones o en el espacio donde no hay ninguno</translation>
    </message>
    <message>
        <source>&amp;Pressure</source>
        <translation>&amp;Presión</translation>
    </message>
    <message>
        <source>The pressure under each patch</source>
        <translation>La presión bajo cada pieza</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Elasticidad</translation>
    </message>
    <message>
        <source>Stiffness of the fabrics, and how much they contract across a pull</source>
        <translation>Rigidez de las telas, y cuánto se contraen de través a la tracción</translation>
    </message>
    <message>
        <source>Of sele&amp;cted patches only</source>
        <translation>&amp;Solo de las piezas seleccionadas</translation>
    </message>
    <message>
        <source>What stays</source>
        <translation>Qué se mantiene</translation>
    </message>
    <message>
        <source>L&amp;engths of seams</source>
        <translation>&amp;Longitudes de costuras</translation>
    </message>
    <message>
        <source>The sides of a seam keep their difference; if it is far from the seam&apos;s ease, it comes nearer to it</source>
        <translation>Los lados de una costura conservan su diferencia; si está lejos del embebido de la costura, se le acerca</translation>
    </message>
    <message>
        <source>St&amp;raight edges</source>
        <translation>Bordes &amp;rectos</translation>
    </message>
    <message>
        <source>An&amp;gles of corners</source>
        <translation>Á&amp;ngulos de las esquinas</translation>
    </message>
    <message>
        <source>No point &amp;moves farther than</source>
        <translation>Ningún punto se &amp;mueve más de</translation>
    </message>
    <message>
        <source>Choose the scan or the file that the cover shall lie on.</source>
        <translation>Elija el escaneo o el archivo al que debe ajustarse la funda.</translation>
    </message>
    <message>
        <source>Select the seam that shall run along the curve.</source>
        <translation>Seleccione la costura que debe seguir la curva.</translation>
    </message>
    <message>
        <source>Paint the area in the 3D view, or untick it.</source>
        <translation>Pinte la zona en la vista 3D o quite la marca.</translation>
    </message>
    <message>
        <source>Select the patches that shall become larger or smaller.</source>
        <translation>Seleccione las piezas que deben hacerse más grandes o más pequeñas.</translation>
    </message>
    <message>
        <source>Choose a goal.</source>
        <translation>Elija un objetivo.</translation>
    </message>
    <message>
        <source>Edges that look straight stay so: those that bow by less than %1 in %2</source>
        <translation>Los bordes que parecen rectos siguen así: los que se arquean menos de %1 en %2</translation>
    </message>
</context>
<context>
    <name>bolster::FlatPiecesView</name>
    <message>
        <source>Pieces laid flat</source>
        <translation>Piezas aplanadas</translation>
    </message>
    <message>
        <source>Strain: %1</source>
        <translation>Deformación: %1</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 y más</translation>
    </message>
    <message>
        <source>%1: strain %2 (rms)</source>
        <translation>%1: deformación %2 (rms)</translation>
    </message>
</context>
<context>
    <name>bolster::FormChoice</name>
    <message>
        <source>Meshes and scans (%1);;All files (*)</source>
        <translation>Mallas y escaneos (%1);;Todos los archivos (*)</translation>
    </message>
</context>
<context>
    <name>bolster::FormPatternWindow</name>
    <message>
        <source>&amp;Make the pattern</source>
        <translation>&amp;Hacer el patrón</translation>
    </message>
    <message>
        <source>Laying it flat …</source>
        <translation>Aplanando…</translation>
    </message>
    <message>
        <source>&amp;Make it without what is left out</source>
        <translation>&amp;Hacerlo sin lo omitido</translation>
    </message>
    <message>
        <source>Laying a form flat …</source>
        <translation>Aplanando una forma…</translation>
    </message>
    <message>
        <source>What came of it</source>
        <translation>Lo que resultó</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Detener</translation>
    </message>
    <message>
        <source>Choose a file with a form above, or import a frame first.</source>
        <translation>Elija arriba un archivo con una forma, o importe primero un armazón.</translation>
    </message>
    <message>
        <source>It is laid flat again when you let go.</source>
        <translation>Se volverá a aplanar cuando suelte.</translation>
    </message>
    <message numerus="yes">
        <source>Dividing it, %n pieces so far …</source>
        <translation>
            <numerusform>Dividiendo, %n pieza hasta ahora …</numerusform>
            <numerusform>Dividiendo, %n piezas hasta ahora …</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Lay it flat</source>
        <translation>&amp;Aplanar</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>Se ha detenido.</translation>
    </message>
    <message>
        <source>It was stopped. These are the pieces from before.</source>
        <translation>Se ha detenido. Estas son las piezas de antes.</translation>
    </message>
    <message>
        <source>From a form</source>
        <translation>A partir de una forma</translation>
    </message>
</context>
<context>
    <name>bolster::FormWishesPanel</name>
    <message>
        <source>The form to be covered</source>
        <translation>La forma que se debe enfundar</translation>
    </message>
    <message>
        <source>Meshes and CAD files (%1);;All files (*)</source>
        <translation>Mallas y archivos CAD (%1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Where the grain line runs on the form</source>
        <translation>Por dónde va el hilo en la forma</translation>
    </message>
    <message>
        <source>upwards</source>
        <translation>hacia arriba</translation>
    </message>
    <message>
        <source>to the back</source>
        <translation>hacia atrás</translation>
    </message>
    <message>
        <source>sideways</source>
        <translation>hacia el lado</translation>
    </message>
    <message>
        <source>&amp;Form</source>
        <translation>&amp;Forma</translation>
    </message>
    <message>
        <source>Fa&amp;bric</source>
        <translation>&amp;Tela</translation>
    </message>
    <message>
        <source>&amp;Grain runs</source>
        <translation>&amp;Hilo</translation>
    </message>
    <message>
        <source>It is cut</source>
        <translation>Se corta</translation>
    </message>
    <message>
        <source>and along the ticked lines:</source>
        <translation>y por las líneas marcadas:</translation>
    </message>
    <message>
        <source>where its &amp;parts meet</source>
        <translation>donde se &amp;juntan sus grupos</translation>
    </message>
    <message>
        <source>at the edges of its &amp;CAD faces</source>
        <translation>en las aristas de sus caras &amp;CAD</translation>
    </message>
    <message>
        <source>Each face as the CAD program has it, also where two go on smoothly in each other</source>
        <translation>Cada cara como la tiene el programa de CAD, también donde dos continúan suavemente una en otra</translation>
    </message>
    <message>
        <source>where it &amp;bends by more than</source>
        <translation>donde se &amp;dobla más de</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>where it would &amp;not lie flat</source>
        <translation>do&amp;nde no quedaría plana</translation>
    </message>
    <message>
        <source>Pieces that would lie over themselves, or be strained by more than the fabric may be, are divided where they bend most or are narrow; an armchair takes some seconds</source>
        <translation>Las piezas que quedarían sobre sí mismas, o se estirarían más de lo que admite la tela, se dividen donde más se doblan o son estrechas; un sillón tarda unos segundos</translation>
    </message>
    <message>
        <source>Keep its cover &amp;outside of the frame</source>
        <translation>Mantener su funda fuera del arma&amp;zón</translation>
    </message>
    <message>
        <source>Making the pattern ticks &quot;Keeps the cover outside&quot; at the frame. A cover that is held along its seams alone may sink into the frame or turn inside out.</source>
        <translation>Al hacer el patrón se marca «Mantiene la funda fuera» en el armazón. Una funda sujeta solo por sus costuras puede hundirse en el armazón o volverse del revés.</translation>
    </message>
    <message>
        <source>Patches that this form became before go, with their seams and the curves that hold nothing else. One Undo brings them back.</source>
        <translation>Las piezas que antes salieron de esta forma se van, con sus costuras y las curvas que no sujetan otra cosa. Un solo Deshacer las devuelve.</translation>
    </message>
    <message>
        <source>The cover as it is</source>
        <translation>La funda como está</translation>
    </message>
    <message>
        <source>Choose a form</source>
        <translation>Elegir una forma</translation>
    </message>
    <message>
        <source>New fabric</source>
        <translation>Tela nueva</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Tela</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Replace the %n patches of these names</source>
        <translation>
            <numerusform>&amp;Reemplazar la %n pieza de este nombre</numerusform>
            <numerusform>&amp;Reemplazar las %n piezas de estos nombres</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>(%n curves that hold them will hold nothing)</source>
        <translation>
            <numerusform>(%n curva que las sujeta no sujetará nada)</numerusform>
            <numerusform>(%n curvas que las sujetan no sujetarán nada)</numerusform>
        </translation>
    </message>
    <message>
        <source>They end inside a piece (marked in the 3D view) and do not divide it: each goes on to the border or line that is nearest, along the way shown there</source>
        <translation>Terminan dentro de una pieza (marcado en la vista 3D) y no la dividen: cada una sigue hasta el borde o la línea más próximos, por el camino que se muestra allí</translation>
    </message>
    <message numerus="yes">
        <source>Lead %n open ends &amp;on</source>
        <translation>
            <numerusform>Pr&amp;olongar %n extremo abierto</numerusform>
            <numerusform>Pr&amp;olongar %n extremos abiertos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FoundPiecesView</name>
    <message>
        <source>Pieces in the file</source>
        <translation>Piezas del archivo</translation>
    </message>
    <message>
        <source>There is no piece in it.</source>
        <translation>No contiene ninguna pieza.</translation>
    </message>
    <message>
        <source>Reading …</source>
        <translation>Leyendo…</translation>
    </message>
</context>
<context>
    <name>bolster::GlCanvas</name>
    <message>
        <source>No OpenGL: drawn in software</source>
        <translation>Sin OpenGL: dibujado por software</translation>
    </message>
    <message>
        <source>OpenGL is older than 3.3: drawn in software</source>
        <translation>OpenGL es anterior a 3.3: dibujado por software</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryModel</name>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambio</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryPanel</name>
    <message>
        <source>Find a change or a version</source>
        <translation>Buscar un cambio o una versión</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryView</name>
    <message>
        <source>&amp;Go to this version</source>
        <translation>&amp;Ir a esta versión</translation>
    </message>
    <message>
        <source>&amp;Name this version …</source>
        <translation>&amp;Nombrar esta versión…</translation>
    </message>
    <message>
        <source>&amp;Remove its name</source>
        <translation>&amp;Quitar su nombre</translation>
    </message>
    <message>
        <source>&amp;Compare with now …</source>
        <translation>&amp;Comparar con ahora…</translation>
    </message>
    <message>
        <source>Name of this branch</source>
        <translation>Nombre de esta rama</translation>
    </message>
    <message>
        <source>Name of this version</source>
        <translation>Nombre de esta versión</translation>
    </message>
    <message>
        <source>Name this &amp;branch …</source>
        <translation>Nombrar esta &amp;rama…</translation>
    </message>
</context>
<context>
    <name>bolster::ImportFlow</name>
    <message>
        <source>Frames (%1)</source>
        <translation>Armazones (%1)</translation>
    </message>
    <message>
        <source>Scans (%1)</source>
        <translation>Escaneos (%1)</translation>
    </message>
    <message>
        <source>Import frame</source>
        <translation>Importar armazón</translation>
    </message>
    <message>
        <source>Import scan</source>
        <translation>Importar escaneo</translation>
    </message>
    <message>
        <source>Import pattern</source>
        <translation>Importar patrón</translation>
    </message>
    <message>
        <source>Patterns (%1)</source>
        <translation>Patrones (%1)</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>Elegir otro archivo</translation>
    </message>
    <message>
        <source>The pattern is imported. What is otherwise than in the file:</source>
        <translation>El patrón se ha importado. Lo que difiere del archivo:</translation>
    </message>
    <message>
        <source>Simplifying %1 …</source>
        <translation>Simplificando %1…</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>Escribiendo %1…</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be imported.</source>
        <translation>No se pudo importar «%1».</translation>
    </message>
</context>
<context>
    <name>bolster::ImportPatternDialog</name>
    <message>
        <source>Import pattern</source>
        <translation>Importar patrón</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Piezas</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importar</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Milímetros</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centímetros</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pulgadas</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Metros</translation>
    </message>
    <message>
        <source>Sewing lines, with allowances</source>
        <translation>Líneas de costura, con márgenes</translation>
    </message>
    <message>
        <source>Cut lines, without allowance</source>
        <translation>Líneas de corte, sin margen</translation>
    </message>
    <message>
        <source>What the outlines of patches become where the file has both lines.</source>
        <translation>En qué se convierten los contornos de las piezas donde el archivo tiene ambas líneas.</translation>
    </message>
    <message>
        <source>Outlines whose ends are no farther apart are closed by a straight line.</source>
        <translation>Los contornos cuyos extremos no distan más se cierran con una recta.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>&amp;Unidad del archivo</translation>
    </message>
    <message>
        <source>Largest piece</source>
        <translation>Pieza mayor</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Tamaño</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>C&amp;ontornos</translation>
    </message>
    <message>
        <source>&amp;Close gaps up to</source>
        <translation>&amp;Cerrar huecos hasta</translation>
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
            <numerusform>, %n par</numerusform>
            <numerusform>, %n pares</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n times</source>
        <translation>
            <numerusform>, %n vez</numerusform>
            <numerusform>, %n veces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines lay twice on themselves and are taken once.</source>
        <translation>
            <numerusform>%n línea estaba duplicada y se toma una vez.</numerusform>
            <numerusform>%n líneas estaban duplicadas y se toman una vez.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not read: %1</source>
        <translation>No se lee: %1</translation>
    </message>
    <message>
        <source>The file does not say its unit for certain: look at the measures.</source>
        <translation>El archivo no indica su unidad con certeza: mire las medidas.</translation>
    </message>
    <message>
        <source>Pixels (1/96 inch)</source>
        <translation>Píxeles (1/96 de pulgada)</translation>
    </message>
    <message>
        <source>Points (1/72 inch)</source>
        <translation>Puntos (1/72 de pulgada)</translation>
    </message>
    <message>
        <source>In no piece and left out, by layer: %1</source>
        <translation>En ninguna pieza y omitido, por capa: %1</translation>
    </message>
    <message>
        <source>Marks of grading, stripes or nothing that is known, left out by layer: %1</source>
        <translation>Marcas de escalado, de rayas o desconocidas, omitidas, por capa: %1</translation>
    </message>
    <message>
        <source>%1 has %2 pieces; at most %3 can be imported at once: the first ones are chosen.</source>
        <translation>%1 tiene %2 piezas; se pueden importar %3 a la vez como máximo: se eligen las primeras.</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 — %2</translation>
    </message>
    <message numerus="yes">
        <source>%n outlines are open: their ends are up to %1 apart. Close gaps up to that, if they are outlines.</source>
        <translation>
            <numerusform>%n contorno está abierto: sus extremos distan hasta %1. Cierre huecos hasta ese valor si es un contorno.</numerusform>
            <numerusform>%n contornos están abiertos: sus extremos distan hasta %1. Cierre huecos hasta ese valor si son contornos.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::JobsPanel</name>
    <message>
        <source>Nothing is being worked at.</source>
        <translation>No hay tareas en curso.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Tareas</translation>
    </message>
</context>
<context>
    <name>bolster::LeftWork</name>
    <message>
        <source>New design</source>
        <translation>Diseño nuevo</translation>
    </message>
    <message numerus="yes">
        <source>%n more designs are under File &gt; Unsaved work.</source>
        <translation>
            <numerusform>%n diseño más está en Archivo &gt; Trabajo sin guardar.</numerusform>
            <numerusform>%n diseños más están en Archivo &gt; Trabajo sin guardar.</numerusform>
        </translation>
    </message>
    <message>
        <source>Restoring the work on &quot;%1&quot; …</source>
        <translation>Restaurando el trabajo de «%1»…</translation>
    </message>
    <message>
        <source>The work stays under File &gt; Unsaved work</source>
        <translation>El trabajo sigue en Archivo &gt; Trabajo sin guardar</translation>
    </message>
    <message>
        <source>The unsaved work on &quot;%1&quot; could not be restored.</source>
        <translation>No se pudo restaurar el trabajo sin guardar de «%1».</translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved edits restored.</source>
        <translation>
            <numerusform>%n edición sin guardar restaurada.</numerusform>
            <numerusform>%n ediciones sin guardar restauradas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved edits are in the history, undone or on other branches.</source>
        <translation>
            <numerusform>%n edición sin guardar está en el historial, deshecha o en otras ramas.</numerusform>
            <numerusform>%n ediciones sin guardar están en el historial, deshechas o en otras ramas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Unsaved names of versions or branches restored.</source>
        <translation>Nombres de versiones o ramas sin guardar restaurados.</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Mostrar</translation>
    </message>
    <message>
        <source>Go &amp;back to saved</source>
        <translation>&amp;Volver a lo guardado</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, %2, damaged</source>
        <translation>%1, %2, dañado</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nada</translation>
    </message>
</context>
<context>
    <name>bolster::MainWindow</name>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Mensajes</translation>
    </message>
    <message>
        <source>%1[*] – Bolster</source>
        <translation>%1[*] — Bolster</translation>
    </message>
    <message>
        <source>%1 It is back where it was.</source>
        <translation>%1 Ha vuelto a donde estaba.</translation>
    </message>
    <message>
        <source>More commands</source>
        <translation>Más comandos</translation>
    </message>
    <message>
        <source>The cover sprang by %1.</source>
        <translation>La funda saltó %1.</translation>
    </message>
    <message>
        <source>Folded cloth can lie in several ways, and where a drag leaves it depends on the way of the pointer. What you see now follows from the design alone: whoever opens it sees the same, and so do exports and pictures. If you want the other shape, tell the design: hold the cloth there with a handle, or make the piece smaller until it needs no folds.</source>
        <translation>La tela plegada puede quedar de varias formas, y cómo la deja el arrastre depende del recorrido del puntero. Lo que ve ahora resulta solo del diseño: quien lo abra verá lo mismo, igual que las exportaciones e imágenes. Si quiere la otra forma, indíquelo en el diseño: sujete allí la tela con una curva de tirador o reduzca la pieza hasta que no necesite pliegues.</translation>
    </message>
    <message>
        <source>%1[*] (read-only) – Bolster</source>
        <translation>%1[*] (solo lectura) — Bolster</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces are in the pattern. Seam &gt; Propose seams finds what belongs together.</source>
        <translation>
            <numerusform>Hay %n pieza en el patrón. Costura &gt; Proponer costuras encuentra lo que va unido.</numerusform>
            <numerusform>Hay %n piezas en el patrón. Costura &gt; Proponer costuras encuentra lo que va unido.</numerusform>
        </translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>Bolster is still working at something.</source>
        <translation>Bolster sigue trabajando.</translation>
    </message>
    <message>
        <source>What is closed now is not finished; files that are being written stay as they were.</source>
        <translation>Lo que se cierre ahora no se termina; los archivos que se están escribiendo quedan como estaban.</translation>
    </message>
    <message>
        <source>&amp;Stop it and close</source>
        <translation>&amp;Detener y cerrar</translation>
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
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>This change has taken away as well: %1</source>
        <translation>Este cambio también ha quitado: %1</translation>
    </message>
</context>
<context>
    <name>bolster::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Manual</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Contenido</translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>Atrás (Alt+Izquierda)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation>Adelante (Alt+Derecha)</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Adelante</translation>
    </message>
    <message>
        <source>Find in all pages</source>
        <translation>Buscar en todas las páginas</translation>
    </message>
    <message>
        <source>The manual has no page &quot;%1&quot;.</source>
        <translation>El manual no tiene la página «%1».</translation>
    </message>
    <message>
        <source>The manual is in English.</source>
        <translation>El manual está en inglés.</translation>
    </message>
</context>
<context>
    <name>bolster::MapLegend</name>
    <message>
        <source>over the fabric&apos;s limit</source>
        <translation>por encima del límite de la tela</translation>
    </message>
</context>
<context>
    <name>bolster::MapLink</name>
    <message>
        <source>Largest strain</source>
        <translation>Deformación máxima</translation>
    </message>
    <message>
        <source>Strain along the grain</source>
        <translation>Deformación al hilo</translation>
    </message>
    <message>
        <source>Strain across the grain</source>
        <translation>Deformación a contrahilo</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Cizalladura</translation>
    </message>
    <message>
        <source>Mean curvature</source>
        <translation>Curvatura media</translation>
    </message>
    <message>
        <source>Distance to the frame</source>
        <translation>Distancia al armazón</translation>
    </message>
    <message>
        <source>hollow</source>
        <translation>hundido</translation>
    </message>
    <message>
        <source>bulging</source>
        <translation>abombado</translation>
    </message>
    <message>
        <source>pressed</source>
        <translation>comprimido</translation>
    </message>
    <message>
        <source>stretched</source>
        <translation>estirado</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>%1, over the limit of %2</source>
        <translation>%1, por encima del límite de %2</translation>
    </message>
    <message>
        <source>Here: %1</source>
        <translation>Aquí: %1</translation>
    </message>
    <message>
        <source>over the fabric&apos;s limit</source>
        <translation>por encima del límite de la tela</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>dentro</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>fuera</translation>
    </message>
    <message>
        <source>Deviation from the scan</source>
        <translation>Desviación respecto al escaneo</translation>
    </message>
</context>
<context>
    <name>bolster::MarkTool</name>
    <message>
        <source>Hole %1</source>
        <translation>Taladro %1</translation>
    </message>
    <message>
        <source>Click to select it, drag to move it – its properties say what it is like</source>
        <translation>Clic para seleccionarlo, arrastrar para moverlo — sus propiedades dicen cómo es</translation>
    </message>
    <message>
        <source>Click a corner of an outline to choose how its cut lines are joined – Esc ends the tool</source>
        <translation>Haga clic en una esquina de un contorno para elegir cómo se unen sus líneas de corte — Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no distance from the corner on this edge.</source>
        <translation>«%1» no es una distancia a la esquina en este borde.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no place: try 120, 40</source>
        <translation>«%1» no es un lugar: pruebe 120, 40</translation>
    </message>
    <message>
        <source>Click an outline to place a notch, or type how far it is from the corner; on a seam the other side gets one, too – Esc ends the tool</source>
        <translation>Haga clic en un contorno para poner un piquete o escriba a qué distancia está de la esquina; en una costura el otro lado también recibe uno — Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>Click inside a patch to place a drill hole, or type where: 120, 40 – Esc ends the tool</source>
        <translation>Haga clic dentro de una pieza para poner un taladro o escriba dónde: 120, 40 — Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no width of an allowance: try 12</source>
        <translation>«%1» no es un ancho de margen: pruebe 12</translation>
    </message>
    <message>
        <source>Drag its handle, or type its width – its properties say what it is like</source>
        <translation>Arrastre su tirador o escriba su ancho — sus propiedades dicen cómo es</translation>
    </message>
    <message>
        <source>Click an edge to give it a seam allowance of its own, or type its width; drag its handle – Esc ends the tool</source>
        <translation>Haga clic en un borde para darle un margen de costura propio o escriba su ancho; arrastre su tirador — Esc sale de la herramienta</translation>
    </message>
    <message>
        <source>Point at an outline, then type how far the notch is from the corner</source>
        <translation>Señale un contorno y escriba a qué distancia de la esquina está el piquete</translation>
    </message>
    <message>
        <source>Point into a patch, then type where the drill hole lies: 120, 40</source>
        <translation>Señale dentro de una pieza y escriba dónde está el taladro: 120, 40</translation>
    </message>
    <message>
        <source>Point at an edge, then type how wide its allowance is</source>
        <translation>Señale un borde y escriba el ancho de su margen</translation>
    </message>
</context>
<context>
    <name>bolster::NextStep</name>
    <message>
        <source>Next: %1 for the other side.</source>
        <translation>Siguiente: %1 para el otro lado.</translation>
    </message>
    <message>
        <source>draw a second patch</source>
        <translation>dibujar una segunda pieza</translation>
    </message>
    <message>
        <source>Next: %1 – click an edge, then the edge it is sewn to.</source>
        <translation>Siguiente: %1 — clic en un borde y luego en el borde al que se cose.</translation>
    </message>
    <message>
        <source>sew the patches</source>
        <translation>coser las piezas</translation>
    </message>
    <message>
        <source>Next: %1 and give them a pressure in the properties.</source>
        <translation>Siguiente: %1 y darles una presión en las propiedades.</translation>
    </message>
    <message>
        <source>select all patches</source>
        <translation>seleccionar todas las piezas</translation>
    </message>
    <message>
        <source>Next: %1 – click points on it, Enter ends – to which the cover is attached.</source>
        <translation>Siguiente: %1 — clic en puntos sobre él, Intro termina — a la que se fija la funda.</translation>
    </message>
    <message>
        <source>draw a fixation curve on the frame</source>
        <translation>dibujar en el armazón una curva de fijación</translation>
    </message>
    <message>
        <source>Next: select a fixation curve and %1 to it.</source>
        <translation>Siguiente: seleccionar una curva de fijación y %1.</translation>
    </message>
    <message>
        <source>attach an edge</source>
        <translation>fijar un borde a ella</translation>
    </message>
</context>
<context>
    <name>bolster::NumberBox</name>
    <message>
        <source>varies</source>
        <translation>varía</translation>
    </message>
    <message>
        <source>Not taken: a number is needed</source>
        <translation>No aceptado: hace falta un número</translation>
    </message>
    <message>
        <source>Not taken: &quot;%1&quot; is not a length</source>
        <translation>No aceptado: «%1» no es una longitud</translation>
    </message>
    <message>
        <source>Not taken: &quot;%1&quot; is not a number</source>
        <translation>No aceptado: «%1» no es un número</translation>
    </message>
    <message>
        <source>Not taken: %1 is too little, at least %2</source>
        <translation>No aceptado: %1 es demasiado poco, mínimo %2</translation>
    </message>
    <message>
        <source>Not taken: %1 is too much, at most %2</source>
        <translation>No aceptado: %1 es demasiado, máximo %2</translation>
    </message>
</context>
<context>
    <name>bolster::OpenFlow</name>
    <message>
        <source>Projects and designs (%1)</source>
        <translation>Proyectos y diseños (%1)</translation>
    </message>
    <message>
        <source>This is the version where you were last; the one in the file is under File &gt; Revert to saved</source>
        <translation>Esta es la versión en la que estuvo por última vez; la del archivo está en Archivo &gt; Volver a lo guardado</translation>
    </message>
    <message>
        <source>Open project or design</source>
        <translation>Abrir proyecto o diseño</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open in another window.</source>
        <translation>«%1» está abierto en otra ventana.</translation>
    </message>
    <message>
        <source>It can be opened here to look at; what is changed is saved under another name.</source>
        <translation>Aquí se puede abrir para verlo; lo que se cambie se guarda con otro nombre.</translation>
    </message>
    <message numerus="yes">
        <source>%n elements cannot be used as they are; everything else works.</source>
        <translation>
            <numerusform>%n elemento no se puede usar tal como está; todo lo demás funciona.</numerusform>
            <numerusform>%n elementos no se pueden usar tal como están; todo lo demás funciona.</numerusform>
        </translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Mostrar</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Nada aún</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>&amp;Vaciar esta lista</translation>
    </message>
    <message>
        <source>The samples are not installed</source>
        <translation>Los ejemplos no están instalados</translation>
    </message>
</context>
<context>
    <name>bolster::PagesView</name>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
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
        <translation>Triángulos</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Partes</translation>
    </message>
</context>
<context>
    <name>bolster::PatternCommands</name>
    <message>
        <source>This stretch is straight already.</source>
        <translation>Este tramo ya es recto.</translation>
    </message>
    <message>
        <source>They are equally long already.</source>
        <translation>Ya tienen la misma longitud.</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Cor&amp;tar</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Pegar</translation>
    </message>
    <message>
        <source>Dupl&amp;icate</source>
        <translation>D&amp;uplicar</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>&amp;Ordenar</translation>
    </message>
    <message>
        <source>Turn 90° to the &amp;left</source>
        <translation>Girar 90° a la &amp;izquierda</translation>
    </message>
    <message>
        <source>Turn 90° to the &amp;right</source>
        <translation>Girar 90° a la &amp;derecha</translation>
    </message>
    <message>
        <source>Mirror hori&amp;zontally</source>
        <translation>Reflejar en &amp;horizontal</translation>
    </message>
    <message>
        <source>Mirror &amp;vertically</source>
        <translation>Reflejar en &amp;vertical</translation>
    </message>
    <message>
        <source>Al&amp;ign</source>
        <translation>&amp;Alinear</translation>
    </message>
    <message>
        <source>&amp;Left edges</source>
        <translation>Bordes i&amp;zquierdos</translation>
    </message>
    <message>
        <source>Centres in a &amp;column</source>
        <translation>Centros en c&amp;olumna</translation>
    </message>
    <message>
        <source>&amp;Right edges</source>
        <translation>Bordes &amp;derechos</translation>
    </message>
    <message>
        <source>&amp;Top edges</source>
        <translation>Bordes &amp;superiores</translation>
    </message>
    <message>
        <source>Centres in a ro&amp;w</source>
        <translation>Centros en &amp;fila</translation>
    </message>
    <message>
        <source>&amp;Bottom edges</source>
        <translation>Bordes &amp;inferiores</translation>
    </message>
    <message>
        <source>&amp;Distribute</source>
        <translation>Di&amp;stribuir</translation>
    </message>
    <message>
        <source>&amp;Horizontally</source>
        <translation>En &amp;horizontal</translation>
    </message>
    <message>
        <source>&amp;Vertically</source>
        <translation>En &amp;vertical</translation>
    </message>
    <message>
        <source>Arrange &amp;automatically</source>
        <translation>Ordenar auto&amp;máticamente</translation>
    </message>
    <message>
        <source>Poin&amp;ts and edges</source>
        <translation>Pu&amp;ntos y bordes</translation>
    </message>
    <message>
        <source>Make &amp;corner</source>
        <translation>Crear &amp;esquina</translation>
    </message>
    <message>
        <source>Make s&amp;mooth</source>
        <translation>&amp;Suavizar</translation>
    </message>
    <message>
        <source>Strai&amp;ghten</source>
        <translation>En&amp;derezar</translation>
    </message>
    <message>
        <source>Edge &amp;length …</source>
        <translation>&amp;Longitud del borde…</translation>
    </message>
    <message>
        <source>Type the length of the selected edge</source>
        <translation>Escribir la longitud del borde seleccionado</translation>
    </message>
    <message>
        <source>Make e&amp;qually long</source>
        <translation>I&amp;gualar longitud</translation>
    </message>
    <message>
        <source>Makes the selected edges as long as the first one, or the second side of a seam as long as its first</source>
        <translation>Da a los bordes seleccionados la longitud del primero, o al segundo lado de una costura la del primero</translation>
    </message>
    <message>
        <source>Mirror twi&amp;ns</source>
        <translation>&amp;Gemelos simétricos</translation>
    </message>
    <message>
        <source>Merge a&amp;long seam</source>
        <translation>&amp;Fusionar por la costura</translation>
    </message>
    <message>
        <source>Smooth &amp;across seam ends</source>
        <translation>Suavi&amp;zar en finales de costura</translation>
    </message>
    <message>
        <source>Outlines go on without a kink from one patch to the other where the selected seams end, when both sides lie together</source>
        <translation>Los contornos pasan sin quiebro de una pieza a la otra donde terminan las costuras seleccionadas, al juntar ambos lados</translation>
    </message>
    <message>
        <source>They go on without a kink already.</source>
        <translation>Ya pasan sin quiebro.</translation>
    </message>
</context>
<context>
    <name>bolster::PatternFitWindow</name>
    <message>
        <source>&amp;Take the changes</source>
        <translation>&amp;Aplicar los cambios</translation>
    </message>
    <message>
        <source>Changes of</source>
        <translation>Cambios en</translation>
    </message>
    <message>
        <source>Moves by</source>
        <translation>Se mueve</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Cambios</translation>
    </message>
    <message>
        <source>What is ticked is changed</source>
        <translation>Se cambia lo marcado</translation>
    </message>
    <message>
        <source>&amp;How much of it</source>
        <translation>&amp;Qué proporción</translation>
    </message>
    <message>
        <source>Solving the cover …</source>
        <translation>Calculando la funda…</translation>
    </message>
    <message>
        <source>Stopped; nothing has changed.</source>
        <translation>Detenido; nada ha cambiado.</translation>
    </message>
    <message>
        <source>&amp;Find changes</source>
        <translation>&amp;Buscar cambios</translation>
    </message>
    <message>
        <source>The cover moves by %1 (rms).</source>
        <translation>La funda se mueve %1 (RMS).</translation>
    </message>
    <message>
        <source>On the way a fold came or went: look at the cover before you take it.</source>
        <translation>Por el camino apareció o desapareció un pliegue: mire la funda antes de aplicarlo.</translation>
    </message>
    <message numerus="yes">
        <source>%n of the numbers that may change do nothing here.</source>
        <translation>
            <numerusform>%n de los números que pueden cambiar no hace nada aquí.</numerusform>
            <numerusform>%n de los números que pueden cambiar no hacen nada aquí.</numerusform>
        </translation>
    </message>
    <message>
        <source>Arrows in the pattern: %1 times as long as the way</source>
        <translation>Flechas en el patrón: %1 veces el recorrido</translation>
    </message>
    <message>
        <source>Arrows in the pattern: where its outlines go</source>
        <translation>Flechas en el patrón: adónde van sus contornos</translation>
    </message>
    <message>
        <source>Taken. Undo takes it back.</source>
        <translation>Aplicado. Deshacer lo revierte.</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: find the changes again.</source>
        <translation>El diseño ha cambiado entretanto: busque los cambios de nuevo.</translation>
    </message>
    <message>
        <source>With all of the changes:</source>
        <translation>Con todos los cambios:</translation>
    </message>
    <message>
        <source>Fitting the pattern …</source>
        <translation>Adaptando el patrón…</translation>
    </message>
    <message>
        <source>Changing the pattern …</source>
        <translation>Cambiando el patrón…</translation>
    </message>
    <message>
        <source>Pressed together: %1 before, %2 now</source>
        <translation>Comprimido: antes %1, ahora %2</translation>
    </message>
    <message>
        <source>From the curve: %1 before, %2 now (rms)</source>
        <translation>Respecto a la curva: antes %1, ahora %2 (RMS)</translation>
    </message>
    <message>
        <source>Off the area that is wanted: %1 before, %2 now</source>
        <translation>Respecto al área deseada: antes %1, ahora %2</translation>
    </message>
    <message>
        <source>Nothing is over the limits: there is nothing to do.</source>
        <translation>Nada supera los límites: no hay nada que hacer.</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit (before: %2), on few triangles at first</source>
        <translation>El %1 de la funda supera el límite (antes: %2), primero con pocos triángulos</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit (before: %2)</source>
        <translation>El %1 de la funda supera el límite (antes: %2)</translation>
    </message>
    <message>
        <source>With what is shown of the changes the cover cannot be solved.</source>
        <translation>Con la parte de los cambios que se muestra no se puede calcular la funda.</translation>
    </message>
    <message>
        <source>With what is shown of the changes:</source>
        <translation>Con la parte de los cambios que se muestra:</translation>
    </message>
    <message>
        <source>Nothing of the changes is shown now: move the slider to see them.</source>
        <translation>Ahora no se muestra ninguno de los cambios: mueva el control deslizante para verlos.</translation>
    </message>
    <message>
        <source>Sides of seams differ by up to %1 more than is wanted: change their neighbours, too, or let the ease change.</source>
        <translation>Los lados de las costuras difieren hasta %1 más de lo deseado: cambie también las piezas vecinas, o deje variar el embebido.</translation>
    </message>
    <message>
        <source>Strained over the limit: %1 of the painted area before, %2 now</source>
        <translation>Deformado por encima del límite: antes %1 de la zona pintada, ahora %2</translation>
    </message>
    <message>
        <source>Strained over the limit: %1 of the cover before, %2 now</source>
        <translation>Deformado por encima del límite: antes %1 de la funda, ahora %2</translation>
    </message>
    <message>
        <source>That is hardly nearer, and strains the cloth more: let something else change, or less of it.</source>
        <translation>Apenas se acerca y deforma más la tela: deje cambiar otra cosa, o menos.</translation>
    </message>
    <message>
        <source>Stopped. What was found until then makes it no better: nothing has changed.</source>
        <translation>Detenido. Lo hallado hasta entonces no lo mejora: nada ha cambiado.</translation>
    </message>
    <message>
        <source>Stopped. With all of the changes that were found until then, measured anew on all triangles:</source>
        <translation>Detenido. Con todos los cambios encontrados hasta entonces, medidos de nuevo en todos los triángulos:</translation>
    </message>
    <message>
        <source>Sides of seams off their ease: up to %1 before, %2 now</source>
        <translation>Lados de costuras fuera de su embebido: hasta %1 antes, %2 ahora</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Over the fabrics&apos; limits: %1 of the cover before, %2 now</source>
        <translation>Por encima de los límites de las telas: antes %1 de la funda, ahora %2</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: find the changes again, or undo that.</source>
        <translation>El diseño ha cambiado entretanto: busque los cambios de nuevo o deshaga eso.</translation>
    </message>
    <message>
        <source>Taken back. Move the slider to see the changes again.</source>
        <translation>Deshecho. Mueva el control deslizante para volver a ver los cambios.</translation>
    </message>
    <message>
        <source>That is hardly nearer to the limit: let something else change, or more of it.</source>
        <translation>Apenas se acerca al límite: deje cambiar otra cosa, o más.</translation>
    </message>
    <message>
        <source>%1 from %3 (rms; before: %2), on few triangles at first</source>
        <translation>%1 de %3 (RMS; antes: %2), primero con pocos triángulos</translation>
    </message>
    <message>
        <source>%1 from %3 (rms; before: %2)</source>
        <translation>%1 de %3 (RMS; antes: %2)</translation>
    </message>
    <message>
        <source>From %5: %1 before, %2 now (rms); %3 before, %4 now (95 %)</source>
        <translation>Respecto a %5: antes %1, ahora %2 (RMS); antes %3, ahora %4 (95&#xa0;%)</translation>
    </message>
    <message>
        <source>That is hardly nearer to %1: let something else change, or more of it.</source>
        <translation>Apenas se acerca a %1: deje cambiar otra cosa, o más.</translation>
    </message>
    <message>
        <source>Hardly less is pressed together: let something else change, or more of it.</source>
        <translation>Apenas hay menos tela comprimida: deje cambiar otra cosa, o más.</translation>
    </message>
    <message>
        <source>That is hardly nearer to the curve: let something else change, or more of it.</source>
        <translation>Apenas se acerca a la curva: deje cambiar otra cosa, o más.</translation>
    </message>
    <message>
        <source>That is hardly nearer to the area that is wanted: let something else change, or more of it.</source>
        <translation>Apenas se acerca a la superficie deseada: deje cambiar otra cosa, o más.</translation>
    </message>
    <message>
        <source>Changes the pattern until the cover is as it is wished: tick one goal or several, and what may change.</source>
        <translation>Cambia el patrón hasta que la funda sea como se desea: marque uno o varios objetivos y lo que puede cambiar.</translation>
    </message>
    <message>
        <source>%1 of the painted area is over the limit (before: %2), on few triangles at first</source>
        <translation>El %1 del área pintada supera el límite (antes: %2), primero con pocos triángulos</translation>
    </message>
    <message>
        <source>%1 of the painted area is over the limit (before: %2)</source>
        <translation>El %1 del área pintada supera el límite (antes: %2)</translation>
    </message>
    <message>
        <source>No change makes it better on all triangles: let something else change, or points move farther.</source>
        <translation>Ningún cambio lo mejora con todos los triángulos: deje cambiar otra cosa o que los puntos se muevan más.</translation>
    </message>
    <message>
        <source>More of the cloth is strained over its limits: make these a goal, too, or let points move less.</source>
        <translation>Hay más tela estirada por encima de sus límites: haga de ellos también un objetivo, o deje que los puntos se muevan menos.</translation>
    </message>
    <message>
        <source>What is wished</source>
        <translation>Lo que se desea</translation>
    </message>
    <message>
        <source>Fit to a goal</source>
        <translation>Adaptar a un objetivo</translation>
    </message>
</context>
<context>
    <name>bolster::PatternRuler</name>
    <message>
        <source>Drag down for a level guide. Marks move upright guides; drag them off to remove them.</source>
        <translation>Arrastre hacia abajo para una guía horizontal. Las marcas mueven guías verticales; arrástrelas fuera para eliminarlas.</translation>
    </message>
    <message>
        <source>Drag to the right for an upright guide. Marks move level guides; drag them off to remove them.</source>
        <translation>Arrastre a la derecha para una guía vertical. Las marcas mueven guías horizontales; arrástrelas fuera para eliminarlas.</translation>
    </message>
</context>
<context>
    <name>bolster::PreferencesWindow</name>
    <message>
        <source>Preferences (*.json)</source>
        <translation>Preferencias (*.json)</translation>
    </message>
    <message>
        <source>No setting has these words.</source>
        <translation>Ningún ajuste contiene estas palabras.</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Preferencias</translation>
    </message>
    <message>
        <source>Find a setting</source>
        <translation>Buscar un ajuste</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>&amp;Edit single shortcuts …</source>
        <translation>&amp;Editar atajos sueltos…</translation>
    </message>
    <message>
        <source>Back to &amp;defaults</source>
        <translation>&amp;Valores predeterminados</translation>
    </message>
    <message>
        <source>All settings of this page</source>
        <translation>Todos los ajustes de esta página</translation>
    </message>
    <message>
        <source>E&amp;xport …</source>
        <translation>E&amp;xportar…</translation>
    </message>
    <message>
        <source>&amp;Import …</source>
        <translation>&amp;Importar…</translation>
    </message>
    <message>
        <source>Export preferences</source>
        <translation>Exportar preferencias</translation>
    </message>
    <message>
        <source>Bolster preferences.json</source>
        <translation>Preferencias de Bolster.json</translation>
    </message>
    <message>
        <source>Import preferences</source>
        <translation>Importar preferencias</translation>
    </message>
    <message>
        <source>The preferences could not be exported.</source>
        <translation>No se pudieron exportar las preferencias.</translation>
    </message>
    <message>
        <source>Nothing was imported from &quot;%1&quot;; all settings are as they were.</source>
        <translation>No se importó nada de «%1»; todos los ajustes siguen como estaban.</translation>
    </message>
    <message>
        <source>The preferences were imported.</source>
        <translation>Se importaron las preferencias.</translation>
    </message>
    <message numerus="yes">
        <source>This version of Bolster does not know %n of them: %1</source>
        <translation>
            <numerusform>Esta versión de Bolster no conoce %n de ellas: %1</numerusform>
            <numerusform>Esta versión de Bolster no conoce %n de ellas: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Girar la vista</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Desplazar la vista</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>En la vista 3D</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>En el patrón</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no folder on this machine: the folder of your fabrics stays what it was.</source>
        <translation>«%1» no es una carpeta de este equipo: la carpeta de sus telas queda como estaba.</translation>
    </message>
    <message>
        <source>&amp;Restart now</source>
        <translation>&amp;Reiniciar ahora</translation>
    </message>
    <message>
        <source>Closes Bolster, and asks about unsaved work as always; then it starts again with the same project</source>
        <translation>Cierra Bolster y pregunta como siempre por el trabajo sin guardar; después vuelve a iniciarlo con el mismo proyecto</translation>
    </message>
</context>
<context>
    <name>bolster::ProblemsView</name>
    <message>
        <source>F1: what it means, and what to do</source>
        <translation>F1: qué significa y qué hacer</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Nothing to worry about.</source>
        <translation>Nada de qué preocuparse.</translation>
    </message>
    <message>
        <source>All elements can be used.</source>
        <translation>Todos los elementos se pueden usar.</translation>
    </message>
</context>
<context>
    <name>bolster::PullNote</name>
    <message>
        <source>The cover in the 3D view is pulled to a scan; here it counts as the pattern alone makes it.</source>
        <translation>La funda de la vista 3D es atraída hacia un escaneo; aquí cuenta tal como la hace el patrón por sí solo.</translation>
    </message>
    <message>
        <source>No scan pulls at the cover any more (a step in the history).</source>
        <translation>Ningún escaneo tira ya de la funda (un paso del historial).</translation>
    </message>
    <message>
        <source>Switch the pull off</source>
        <translation>Desactivar la atracción</translation>
    </message>
    <message>
        <source>Pull again</source>
        <translation>Volver a tirar</translation>
    </message>
</context>
<context>
    <name>bolster::ReliefWindow</name>
    <message>
        <source>Relieve strain</source>
        <translation>Aliviar la deformación</translation>
    </message>
    <message>
        <source>&amp;Look for changes</source>
        <translation>&amp;Buscar cambios</translation>
    </message>
    <message>
        <source>Looking for what relieves strain …</source>
        <translation>Buscando qué alivia la deformación…</translation>
    </message>
    <message>
        <source>Where cloth is strained or pressed together more than it may be, changes of the pattern are tried, and the best are solved.</source>
        <translation>Donde la tela se deforma o comprime más de lo admisible, se prueban cambios en el patrón y se calculan los mejores.</translation>
    </message>
    <message>
        <source>Proposed changes</source>
        <translation>Cambios propuestos</translation>
    </message>
    <message>
        <source>Strain is at &amp;most</source>
        <translation>La deformación es como &amp;máximo</translation>
    </message>
    <message>
        <source>Else the limits of the fabrics count</source>
        <translation>Si no, valen los límites de las telas</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Limit of strain</source>
        <translation>Límite de deformación</translation>
    </message>
    <message>
        <source>Edges move &amp;by at most</source>
        <translation>Los bor&amp;des se mueven como máximo</translation>
    </message>
    <message>
        <source>Trying changes …</source>
        <translation>Probando cambios…</translation>
    </message>
    <message>
        <source>Stopped; nothing has changed.</source>
        <translation>Detenido; nada ha cambiado.</translation>
    </message>
    <message>
        <source>Nothing is strained over the limit.</source>
        <translation>Nada se deforma por encima del límite.</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit. No change relieves it.</source>
        <translation>El %1 de la funda supera el límite. Ningún cambio lo alivia.</translation>
    </message>
    <message>
        <source>Each is solved by itself; &quot;Make it&quot; is one step that Undo takes back.</source>
        <translation>Cada uno se calcula por separado; «Aplicar» es un solo paso que Deshacer revierte.</translation>
    </message>
    <message>
        <source>As it is now</source>
        <translation>Como está ahora</translation>
    </message>
    <message>
        <source>Sewn: %1 more</source>
        <translation>Costura: %1 más</translation>
    </message>
    <message>
        <source>Sides of seams differ by %1 more</source>
        <translation>Los lados de las costuras difieren %1 más</translation>
    </message>
    <message>
        <source>Outlines change by %1</source>
        <translation>Los contornos cambian %1</translation>
    </message>
    <message>
        <source>Show where</source>
        <translation>Mostrar dónde</translation>
    </message>
    <message>
        <source>Make it</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Make it: %1</source>
        <translation>Aplicar: %1</translation>
    </message>
    <message>
        <source>Made. Undo takes it back; look again to see what helps now.</source>
        <translation>Aplicado. Deshacer lo revierte; busque de nuevo para ver qué ayuda ahora.</translation>
    </message>
    <message>
        <source>Stopped. These are solved:</source>
        <translation>Detenido. Estos están calculados:</translation>
    </message>
    <message>
        <source>The best changes are being solved …</source>
        <translation>Se calculan los mejores cambios…</translation>
    </message>
    <message>
        <source>Hardly anything is over the limit: there is little to gain. &quot;Make it&quot; is one step that Undo takes back.</source>
        <translation>Casi nada supera el límite: hay poco que ganar. «Aplicar» es un solo paso que Deshacer revierte.</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit, by %2 (rms of all of it).</source>
        <translation>El %1 de la funda supera el límite, en %2 (RMS sobre toda ella).</translation>
    </message>
    <message>
        <source>Over the limit: %1 of the cover, then %2</source>
        <translation>Por encima del límite: %1 de la funda, después %2</translation>
    </message>
    <message>
        <source>Strain over it (rms): %1, then %2</source>
        <translation>Deformación por encima de él (RMS): %1, después %2</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: look again, or undo that.</source>
        <translation>El diseño ha cambiado entretanto: busque de nuevo o deshaga eso.</translation>
    </message>
    <message>
        <source>The cover moves by %1 (rms).</source>
        <translation>La funda se mueve %1 (RMS).</translation>
    </message>
    <message>
        <source>From %1 (rms): %2, then %3</source>
        <translation>Respecto a %1 (RMS): %2, después %3</translation>
    </message>
</context>
<context>
    <name>bolster::RenderDialog</name>
    <message>
        <source>Render</source>
        <translation>Renderizar</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>As in the window</source>
        <translation>Como en la ventana</translation>
    </message>
    <message>
        <source>Three-quarter</source>
        <translation>Tres cuartos</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Delante</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Detrás</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Borrador</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Buena</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Óptima</translation>
    </message>
    <message>
        <source>How often each pixel is looked at</source>
        <translation>Cuántas veces se mira cada píxel</translation>
    </message>
    <message>
        <source>Transparent &amp;background</source>
        <translation>&amp;Fondo transparente</translation>
    </message>
    <message>
        <source>The shadow on the ground is kept</source>
        <translation>Se conserva la sombra en el suelo</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Tamaño:</translation>
    </message>
    <message>
        <source>&amp;View:</source>
        <translation>&amp;Vista:</translation>
    </message>
    <message>
        <source>Sho&amp;w:</source>
        <translation>&amp;Mostrar:</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>C&amp;alidad:</translation>
    </message>
    <message>
        <source>Drawing …</source>
        <translation>Dibujando…</translation>
    </message>
    <message>
        <source>&amp;Render …</source>
        <translation>&amp;Renderizar…</translation>
    </message>
    <message>
        <source>The fabrics as in the window</source>
        <translation>Las telas como en la ventana</translation>
    </message>
    <message>
        <source>Colourway %1</source>
        <translation>Variante de color %1</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>Damero</translation>
    </message>
    <message>
        <source>At most %1 million pixels are drawn; choose a smaller size.</source>
        <translation>Se dibujan como máximo %1 millones de píxeles; elija un tamaño menor.</translation>
    </message>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation>No se puede escribir la imagen: %1</translation>
    </message>
    <message>
        <source>Render to</source>
        <translation>Renderizar en</translation>
    </message>
    <message>
        <source>PNG, 8 bits (*.png);;TIFF, 16 bits (*.tif *.tiff);;OpenEXR, linear light (*.exr)</source>
        <translation>PNG, 8 bits (*.png);;TIFF, 16 bits (*.tif *.tiff);;OpenEXR, luz lineal (*.exr)</translation>
    </message>
    <message>
        <source>The name must end in .png, .tif or .exr.</source>
        <translation>El nombre debe terminar en .png, .tif o .exr.</translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>Cancelado; no se escribió nada.</translation>
    </message>
    <message>
        <source>one picture</source>
        <translation>una imagen</translation>
    </message>
    <message>
        <source> pictures</source>
        <translation> imágenes</translation>
    </message>
    <message>
        <source>So many pictures from all around, with numbers in their names</source>
        <translation>Tantas imágenes alrededor, con números en sus nombres</translation>
    </message>
    <message>
        <source>&amp;Around the cover:</source>
        <translation>Alre&amp;dedor de la funda:</translation>
    </message>
    <message>
        <source>All colourways on a sheet</source>
        <translation>Todas las variantes en una hoja</translation>
    </message>
    <message>
        <source>Map: %1</source>
        <translation>Mapa: %1</translation>
    </message>
    <message>
        <source>&amp;Frame and foam</source>
        <translation>Armazón y &amp;espuma</translation>
    </message>
    <message>
        <source>In the materials that their properties say</source>
        <translation>Con los materiales que dicen sus propiedades</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Cerrar</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Ca&amp;ncelar</translation>
    </message>
    <message>
        <source>The picture is written: %1</source>
        <translation>La imagen está escrita: %1</translation>
    </message>
    <message>
        <source>Open its folder</source>
        <translation>Abrir su carpeta</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>What was made</source>
        <translation>Lo que se ha creado</translation>
    </message>
    <message>
        <source>Drawing %1 …</source>
        <translation>Dibujando %1…</translation>
    </message>
</context>
<context>
    <name>bolster::ReportDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>Informar de un problema</translation>
    </message>
    <message>
        <source>What did you do, what happened, and what should have happened?</source>
        <translation>¿Qué hizo, qué ocurrió y qué debería haber ocurrido?</translation>
    </message>
    <message>
        <source>&amp;What happened:</source>
        <translation>&amp;Qué ocurrió:</translation>
    </message>
    <message>
        <source>&amp;Add the design (&quot;%1&quot;), without its frames, scans and pictures</source>
        <translation>&amp;Añadir el diseño («%1»), sin sus armazones, escaneos e imágenes</translation>
    </message>
    <message>
        <source>What the &amp;report says besides:</source>
        <translation>Qué más dice el &amp;informe:</translation>
    </message>
    <message>
        <source>Write the report …</source>
        <translation>Escribir el informe…</translation>
    </message>
    <message>
        <source>This writes a file that you can give to those who can help. Bolster sends nothing.</source>
        <translation>Esto escribe un archivo que puede dar a quien pueda ayudar. Bolster no envía nada.</translation>
    </message>
    <message>
        <source>not known yet</source>
        <translation>aún desconocido</translation>
    </message>
    <message>
        <source>Messages of this run:</source>
        <translation>Mensajes de esta ejecución:</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(ninguno)</translation>
    </message>
    <message>
        <source>The last crash:</source>
        <translation>El último fallo:</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Escribir el informe</translation>
    </message>
    <message>
        <source>ZIP (*.zip)</source>
        <translation>ZIP (*.zip)</translation>
    </message>
    <message>
        <source>The report is written: %1</source>
        <translation>El informe está escrito: %1</translation>
    </message>
    <message>
        <source>The report could not be written: %1</source>
        <translation>No se pudo escribir el informe: %1</translation>
    </message>
</context>
<context>
    <name>bolster::Rescue</name>
    <message>
        <source>%1 (recovered)</source>
        <translation>%1 (recuperado)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be opened.</source>
        <translation>No se pudo abrir «%1».</translation>
    </message>
    <message>
        <source>What can be read goes into a new project beside it. This file stays as it is.</source>
        <translation>Lo que se pueda leer va a un proyecto nuevo, al lado. Este archivo queda como está.</translation>
    </message>
    <message>
        <source>&amp;Recover what can be read</source>
        <translation>&amp;Recuperar lo que se pueda leer</translation>
    </message>
    <message>
        <source>Recovering &quot;%1&quot; …</source>
        <translation>Recuperando «%1»…</translation>
    </message>
    <message>
        <source>Nothing could be recovered.</source>
        <translation>No se pudo recuperar nada.</translation>
    </message>
    <message>
        <source>What could be read is in &quot;%1&quot; now.</source>
        <translation>Lo que se pudo leer está ahora en «%1».</translation>
    </message>
    <message>
        <source>The unsaved work on &quot;%1&quot; is damaged.</source>
        <translation>El trabajo sin guardar de «%1» está dañado.</translation>
    </message>
    <message numerus="yes">
        <source>What can be read goes into a new project. What you do not want any more is deleted %n days after it was put into the bin.</source>
        <translation>
            <numerusform>Lo que se pueda leer va a un proyecto nuevo. Lo que ya no quiera se elimina a %n día de ponerlo en la papelera.</numerusform>
            <numerusform>Lo que se pueda leer va a un proyecto nuevo. Lo que ya no quiera se elimina a los %n días de ponerlo en la papelera.</numerusform>
        </translation>
    </message>
    <message>
        <source>Put it into the &amp;bin</source>
        <translation>Mover a la &amp;papelera</translation>
    </message>
    <message>
        <source>The damaged work is kept under File &gt; Unsaved work</source>
        <translation>El trabajo dañado se conserva en Archivo &gt; Trabajo sin guardar</translation>
    </message>
    <message>
        <source>What could be read of it is in &quot;%1&quot; now.</source>
        <translation>Lo que se pudo leer de él está ahora en «%1».</translation>
    </message>
    <message>
        <source>Nothing of it could be read.</source>
        <translation>No se pudo leer nada de él.</translation>
    </message>
    <message>
        <source>Nothing that was saved is concerned. The damaged work is kept under File &gt; Unsaved work.</source>
        <translation>Nada de lo guardado está afectado. El trabajo dañado se conserva en Archivo &gt; Trabajo sin guardar.</translation>
    </message>
    <message>
        <source>Open what was &amp;recovered</source>
        <translation>&amp;Abrir lo recuperado</translation>
    </message>
    <message>
        <source>Looking for what can be read in &quot;%1&quot; …</source>
        <translation>Buscando lo que se puede leer en «%1»…</translation>
    </message>
</context>
<context>
    <name>bolster::RunRow</name>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Detener</translation>
    </message>
</context>
<context>
    <name>bolster::SaveFlow</name>
    <message>
        <source>Project with its history (*.bolster);;Design as text (*.json)</source>
        <translation>Proyecto con su historial (*.bolster);;Diseño como texto (*.json)</translation>
    </message>
    <message numerus="yes">
        <source>%n edits</source>
        <translation>
            <numerusform>%n edición</numerusform>
            <numerusform>%n ediciones</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edits that were undone or are on other branches</source>
        <translation>
            <numerusform>%n edición deshecha o en otras ramas</numerusform>
            <numerusform>%n ediciones deshechas o en otras ramas</numerusform>
        </translation>
    </message>
    <message>
        <source>names of versions or branches</source>
        <translation>nombres de versiones o ramas</translation>
    </message>
    <message>
        <source>The file holds another version of the design than the one you see.</source>
        <translation>El archivo contiene otra versión del diseño, no la que ve.</translation>
    </message>
    <message>
        <source>Not saved yet: %1.</source>
        <translation>Sin guardar aún: %1.</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>Guardar una copia</translation>
    </message>
    <message>
        <source>-copy</source>
        <translation>-copia</translation>
    </message>
    <message>
        <source>Project (*.%1)</source>
        <translation>Proyecto (*.%1)</translation>
    </message>
    <message>
        <source>Save the changes in &quot;%1&quot;?</source>
        <translation>¿Guardar los cambios de «%1»?</translation>
    </message>
    <message>
        <source>A design as text cannot hold that, a project can.</source>
        <translation>Un diseño como texto no puede contener eso; un proyecto, sí.</translation>
    </message>
    <message>
        <source>Work that is kept for later, with all its steps, is under File &gt; Unsaved work.</source>
        <translation>El trabajo conservado para después, con todos sus pasos, está en Archivo &gt; Trabajo sin guardar.</translation>
    </message>
    <message>
        <source>Save as &amp;project …</source>
        <translation>Guardar como &amp;proyecto…</translation>
    </message>
    <message>
        <source>&amp;Keep for later</source>
        <translation>Conservar para &amp;después</translation>
    </message>
    <message>
        <source>The work cannot be kept.</source>
        <translation>El trabajo no se puede conservar.</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Guardar proyecto</translation>
    </message>
    <message>
        <source>Saved a copy as %1</source>
        <translation>Copia guardada como %1</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Guardado como %1</translation>
    </message>
    <message>
        <source>%1: the design alone, without its history</source>
        <translation>%1: solo el diseño, sin su historial</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the file any more that was opened or saved here.</source>
        <translation>«%1» ya no es el archivo que se abrió o guardó aquí.</translation>
    </message>
    <message>
        <source>Save your design under another name, or let what is there now have another name beside it. If that is a damaged project, File &gt; Open recovers what can be read of it.</source>
        <translation>Guarde su diseño con otro nombre o deje que lo que hay allí ahora tenga otro nombre al lado. Si es un proyecto dañado, Archivo &gt; Abrir recupera lo que se pueda leer.</translation>
    </message>
    <message>
        <source>&amp;Keep the other file beside it, and save</source>
        <translation>Co&amp;nservar el otro archivo al lado y guardar</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be saved.</source>
        <translation>No se pudo guardar «%1».</translation>
    </message>
    <message>
        <source>What was in the place of &quot;%1&quot; is in &quot;%2&quot; now.</source>
        <translation>Lo que estaba en el lugar de «%1» está ahora en «%2».</translation>
    </message>
    <message>
        <source>Somebody else has changed &quot;%1&quot; since it was opened here.</source>
        <translation>Otra persona ha modificado «%1» desde que se abrió aquí.</translation>
    </message>
    <message>
        <source>Their changes can become a branch of the history here, then both are saved. Your design stays as it is, and you can go to theirs.</source>
        <translation>Sus cambios pueden pasar a ser aquí una rama del historial; así se guardan ambos. Su diseño queda como está y puede ir al otro.</translation>
    </message>
    <message>
        <source>&amp;Take their changes in as a branch</source>
        <translation>&amp;Incorporar sus cambios como rama</translation>
    </message>
    <message>
        <source>From the file, %1</source>
        <translation>Del archivo, %1</translation>
    </message>
    <message>
        <source>Their changes could not be taken in.</source>
        <translation>No se pudieron incorporar sus cambios.</translation>
    </message>
    <message>
        <source>The changes of somebody else are a branch of the history now.</source>
        <translation>Los cambios de la otra persona son ahora una rama del historial.</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Mostrar</translation>
    </message>
    <message>
        <source>Go &amp;there</source>
        <translation>&amp;Ir allí</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>&amp;Reintentar</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>Guardar &amp;como…</translation>
    </message>
    <message>
        <source>Nothing protects what you do since %1 against a crash: Bolster cannot write to the folder &quot;%2&quot;. Make room there, or save the design.</source>
        <translation>Nada protege de un fallo lo que haga desde %1: Bolster no puede escribir en la carpeta «%2». Libere espacio allí o guarde el diseño.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
</context>
<context>
    <name>bolster::ScanLink</name>
    <message>
        <source>Deviation from %1</source>
        <translation>Desviación respecto a %1</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>dentro</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>fuera</translation>
    </message>
</context>
<context>
    <name>bolster::SeamLineList</name>
    <message>
        <source>Seam lines</source>
        <translation>Líneas de costura</translation>
    </message>
    <message>
        <source>Fixation curves of the design. Draw seam lines on a frame with the tool for fixation curves: what is drawn meanwhile is cut at once</source>
        <translation>Curvas de fijación del diseño. Dibuje líneas de costura en un armazón con la herramienta de curvas de fijación: lo que se dibuje entretanto se corta al momento</translation>
    </message>
    <message numerus="yes">
        <source>%n lines that hold a cover</source>
        <translation>
            <numerusform>%n línea que sujeta una funda</numerusform>
            <numerusform>%n líneas que sujetan una funda</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::SeamProposalsWindow</name>
    <message>
        <source>Proposed seams</source>
        <translation>Costuras propuestas</translation>
    </message>
    <message>
        <source>Edge of</source>
        <translation>Borde de</translation>
    </message>
    <message>
        <source>to edge of</source>
        <translation>con borde de</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Longitudes</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>Certeza</translation>
    </message>
    <message>
        <source>Select rows to see their edges in the pattern; Enter or a double click sews them.</source>
        <translation>Seleccione filas para ver sus bordes en el patrón; Intro o un doble clic las cose.</translation>
    </message>
    <message>
        <source>&amp;Sew selected</source>
        <translation>&amp;Coser selección</translation>
    </message>
    <message>
        <source>Sew &amp;all</source>
        <translation>Coser &amp;todas</translation>
    </message>
    <message>
        <source>Looking for edges that belong together …</source>
        <translation>Buscando bordes que van unidos…</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>There are no free edges that seem to belong together.</source>
        <translation>No hay bordes libres que parezcan ir unidos.</translation>
    </message>
    <message>
        <source>Sew &amp;likely ones</source>
        <translation>Coser &amp;probables</translation>
    </message>
    <message>
        <source>Those of 50 % and more. What is sewn tells where its neighbours belong.</source>
        <translation>Las del 50&#xa0;% o más. Lo cosido indica dónde van sus vecinas.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>Found by their lengths, corners that would close, names and directions; the most certain first. Look at each in the pattern before you sew it.</source>
        <translation>Por sus longitudes, las esquinas que se cerrarían, nombres y direcciones; primero las más seguras. Mire cada una en el patrón antes de coserla.</translation>
    </message>
</context>
<context>
    <name>bolster::SeamsModel</name>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parámetro</translation>
    </message>
    <message>
        <source>More than 5 % ease puckers.</source>
        <translation>Con más del 5&#xa0;% de embebido se frunce.</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Costura</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Embebido</translation>
    </message>
    <message>
        <source>Ease %</source>
        <translation>Embeb. %</translation>
    </message>
    <message>
        <source>Joins</source>
        <translation>Unión</translation>
    </message>
    <message>
        <source>Length 1</source>
        <translation>Longitud 1</translation>
    </message>
    <message>
        <source>Length 2</source>
        <translation>Longitud 2</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Emparejado</translation>
    </message>
    <message>
        <source>The letter on both stretches in the pattern</source>
        <translation>La letra de ambos tramos en el patrón</translation>
    </message>
    <message>
        <source>The patches and their edges</source>
        <translation>Las piezas y sus bordes</translation>
    </message>
    <message>
        <source>C0: an edge, C1: smooth with the texture, G1: rounded</source>
        <translation>C0: con arista, C1: suave con la textura, G1: redondeado</translation>
    </message>
    <message>
        <source>Of the first side</source>
        <translation>Del primer lado</translation>
    </message>
    <message>
        <source>Of the second side</source>
        <translation>Del segundo lado</translation>
    </message>
    <message>
        <source>What is sewn together: equal parts of the length, or of the curve&apos;s parameter</source>
        <translation>Qué se cose entre sí: partes iguales de la longitud o del parámetro de la curva</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>The place in the order of sewing; Seam &gt; Sew earlier and Sew later change it</source>
        <translation>El lugar en el orden de costura; lo cambian Costura &gt; Coser antes y Coser después</translation>
    </message>
    <message>
        <source>How much longer the second side is than the first one</source>
        <translation>Cuánto más largo es el segundo lado que el primero</translation>
    </message>
    <message>
        <source>The ease over the shorter side; more than 5 % puckers</source>
        <translation>El embebido dividido por el lado más corto; con más del 5&#xa0;% se frunce</translation>
    </message>
</context>
<context>
    <name>bolster::SeamsView</name>
    <message>
        <source>No seams yet. Choose the sewing tool (W), then click the two edges that belong together.</source>
        <translation>Aún no hay costuras. Elija la herramienta de coser (W) y haga clic en los dos bordes que van unidos.</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Costuras</translation>
    </message>
</context>
<context>
    <name>bolster::SectionPanel</name>
    <message>
        <source>Section</source>
        <translation>Sección</translation>
    </message>
    <message>
        <source>Cut across the x axis</source>
        <translation>Cortar perpendicularmente al eje x</translation>
    </message>
    <message>
        <source>Cut across the y axis</source>
        <translation>Cortar perpendicularmente al eje y</translation>
    </message>
    <message>
        <source>Cut across the z axis</source>
        <translation>Cortar perpendicularmente al eje z</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Cut parallel to the picture, as it is seen now</source>
        <translation>Cortar en paralelo a la imagen, como se ve ahora</translation>
    </message>
    <message>
        <source>Moves the plane</source>
        <translation>Mueve el plano</translation>
    </message>
    <message>
        <source>Show the other half</source>
        <translation>Mostrar la otra mitad</translation>
    </message>
    <message>
        <source>Close the section</source>
        <translation>Cerrar la sección</translation>
    </message>
    <message>
        <source>Place of the section</source>
        <translation>Posición de la sección</translation>
    </message>
</context>
<context>
    <name>bolster::SewingCommands</name>
    <message>
        <source>Propos&amp;e seams …</source>
        <translation>&amp;Proponer costuras…</translation>
    </message>
    <message>
        <source>Show seam li&amp;st</source>
        <translation>Mostrar lista de co&amp;sturas</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>&amp;Invertir</translation>
    </message>
    <message>
        <source>Swap si&amp;des</source>
        <translation>Intercambiar la&amp;dos</translation>
    </message>
    <message>
        <source>C&amp;0 – an edge</source>
        <translation>C&amp;0 — con arista</translation>
    </message>
    <message>
        <source>C&amp;1 – smooth, texture too</source>
        <translation>C&amp;1 — suave, textura incluida</translation>
    </message>
    <message>
        <source>&amp;G1 – rounded</source>
        <translation>&amp;G1 — redondeado</translation>
    </message>
    <message>
        <source>Match by &amp;length</source>
        <translation>Emparejar por &amp;longitud</translation>
    </message>
    <message>
        <source>Match by &amp;parameter</source>
        <translation>Emparejar por pa&amp;rámetro</translation>
    </message>
    <message>
        <source>Sew earl&amp;ier</source>
        <translation>Coser &amp;antes</translation>
    </message>
    <message>
        <source>Sew l&amp;ater</source>
        <translation>Coser desp&amp;ués</translation>
    </message>
    <message>
        <source>Sewi&amp;ng order as proposed</source>
        <translation>&amp;Orden de costura propuesto</translation>
    </message>
</context>
<context>
    <name>bolster::SheetPreview</name>
    <message>
        <source>What will be on the sheets</source>
        <translation>Qué habrá en las hojas</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>No hay nada que cortar.</translation>
    </message>
    <message>
        <source>Laying out …</source>
        <translation>Disponiendo…</translation>
    </message>
</context>
<context>
    <name>bolster::ShortcutsDialog</name>
    <message>
        <source>&amp;No keys</source>
        <translation>&amp;Sin teclas</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Restablecer</translation>
    </message>
    <message>
        <source>&amp;Take them over</source>
        <translation>T&amp;omarlas</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Atajos de teclado</translation>
    </message>
    <message>
        <source>Find a command or a key</source>
        <translation>Buscar un comando o una tecla</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>Restablecer &amp;todo</translation>
    </message>
    <message>
        <source>Click into the field and press the keys.</source>
        <translation>Haga clic en el campo y pulse las teclas.</translation>
    </message>
    <message>
        <source>Choose a command to change its keys.</source>
        <translation>Elija un comando para cambiar sus teclas.</translation>
    </message>
    <message>
        <source>%1 is needed by the views and fields themselves.</source>
        <translation>%1 lo necesitan las propias vistas y campos.</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 pertenece a «%2».</translation>
    </message>
    <message>
        <source>%1 it is.</source>
        <translation>%1 queda asignado.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Comandos</translation>
    </message>
</context>
<context>
    <name>bolster::ShownPattern</name>
    <message>
        <source>Edge: %1</source>
        <translation>Borde: %1</translation>
    </message>
</context>
<context>
    <name>bolster::SimplifyChoice</name>
    <message>
        <source>&amp;Simplify to about</source>
        <translation>&amp;Simplificar a unos</translation>
    </message>
    <message>
        <source> triangles</source>
        <translation> triángulos</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triángulos</translation>
    </message>
    <message>
        <source>Writes the parts that are wanted into an OBJ file of the design&apos;s own; the file that was chosen stays as it is</source>
        <translation>Escribe las partes deseadas en un archivo OBJ propio del diseño; el archivo elegido queda como está</translation>
    </message>
</context>
<context>
    <name>bolster::SpotsPanel</name>
    <message>
        <source>Worst spots</source>
        <translation>Peores zonas</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>Pieza</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Límite</translation>
    </message>
    <message>
        <source>Negative where the fabric is pressed together</source>
        <translation>Negativo donde la tela está comprimida</translation>
    </message>
    <message>
        <source>What the fabric there may suffer. The spots are sorted by how much of it they take</source>
        <translation>Lo que puede soportar allí la tela. Las zonas están ordenadas según cuánto de ello ocupan</translation>
    </message>
    <message>
        <source>As soon as there is a cover, its worst spots will be listed here.</source>
        <translation>En cuanto haya una funda, aquí se listarán sus peores zonas.</translation>
    </message>
    <message>
        <source>A map of strain or shear shows what the fabric suffers. Its worst spots will be listed here.</source>
        <translation>Un mapa de deformación o cizalladura muestra lo que soporta la tela. Aquí se listarán sus peores zonas.</translation>
    </message>
    <message>
        <source>Nothing is over the limit of its fabric.</source>
        <translation>Nada supera el límite de su tela.</translation>
    </message>
    <message>
        <source>Over the limit of the fabric: %1 of %2</source>
        <translation>Por encima del límite de la tela: %1 de %2</translation>
    </message>
    <message>
        <source>over the limit of %1</source>
        <translation>por encima del límite de %1</translation>
    </message>
    <message>
        <source>Show the &amp;largest strain</source>
        <translation>Mostrar la deformación &amp;máxima</translation>
    </message>
</context>
<context>
    <name>bolster::StartHint</name>
    <message>
        <source>A new cover</source>
        <translation>Una funda nueva</translation>
    </message>
    <message>
        <source>Draw the first patch, import a frame, or open a design:</source>
        <translation>Dibuje la primera pieza, importe un armazón o abra un diseño:</translation>
    </message>
    <message>
        <source>Or look at a sample:</source>
        <translation>O vea un ejemplo:</translation>
    </message>
    <message>
        <source>%1 more are under File &gt; Samples</source>
        <translation>%1 más en Archivo &gt; Ejemplos</translation>
    </message>
    <message>
        <source>Go on with:</source>
        <translation>Continuar con:</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Vaciar esta lista</translation>
    </message>
    <message>
        <source>Rectan&amp;gle</source>
        <translation>&amp;Rectángulo</translation>
    </message>
    <message>
        <source>Ou&amp;tline</source>
        <translation>&amp;Contorno</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>&amp;Import frame …</source>
        <translation>&amp;Importar armazón…</translation>
    </message>
</context>
<context>
    <name>bolster::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Página inicial</translation>
    </message>
    <message>
        <source>Welcome to Bolster</source>
        <translation>Le damos la bienvenida a Bolster</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>Hacer el recorrido</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Abrir…</translation>
    </message>
    <message>
        <source>Back to the design</source>
        <translation>Volver al diseño</translation>
    </message>
    <message>
        <source>What do you have?</source>
        <translation>¿Qué tiene?</translation>
    </message>
    <message>
        <source>A frame</source>
        <translation>Un armazón</translation>
    </message>
    <message>
        <source>The cover is fixed on it: %1</source>
        <translation>La funda se fija en él: %1</translation>
    </message>
    <message>
        <source>A pattern</source>
        <translation>Un patrón</translation>
    </message>
    <message>
        <source>Its pieces become the cover: %1</source>
        <translation>Sus piezas forman la funda: %1</translation>
    </message>
    <message>
        <source>A scan</source>
        <translation>Un escaneo</translation>
    </message>
    <message>
        <source>The cover is fitted to it: %1</source>
        <translation>La funda se adapta a él: %1</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Nada aún</translation>
    </message>
    <message>
        <source>Draw a rectangle, the first patch</source>
        <translation>Dibujar un rectángulo, la primera pieza</translation>
    </message>
    <message>
        <source>Go on with</source>
        <translation>Continuar con</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Vaciar esta lista</translation>
    </message>
    <message>
        <source>Take it out of this list; the file stays</source>
        <translation>Quitarlo de esta lista; el archivo se queda</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Trabajo sin guardar</translation>
    </message>
    <message>
        <source>Kept for later, last edit %1</source>
        <translation>Conservado para después, última edición %1</translation>
    </message>
    <message>
        <source>Left by a crash, last edit %1</source>
        <translation>Quedó tras un fallo, última edición %1</translation>
    </message>
    <message>
        <source>Begin with a template</source>
        <translation>Empezar con una plantilla</translation>
    </message>
    <message>
        <source>Look at a sample</source>
        <translation>Ver un ejemplo</translation>
    </message>
    <message>
        <source>It is not there now</source>
        <translation>Ahora no está ahí</translation>
    </message>
</context>
<context>
    <name>bolster::StatusLine</name>
    <message>
        <source>Nothing to sew yet</source>
        <translation>Aún no hay nada que coser</translation>
    </message>
    <message>
        <source>Preparing …</source>
        <translation>Preparando…</translation>
    </message>
    <message>
        <source>Moving, %1/s</source>
        <translation>En movimiento, %1/s</translation>
    </message>
    <message>
        <source>Solved – %1 iterations</source>
        <translation>Calculado — %1 iteraciones</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pausa</translation>
    </message>
    <message numerus="yes">
        <source>%n problems</source>
        <translation>
            <numerusform>%n problema</numerusform>
            <numerusform>%n problemas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n aviso</numerusform>
            <numerusform>%n avisos</numerusform>
        </translation>
    </message>
    <message>
        <source>Solved in part</source>
        <translation>Calculado en parte</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>¿Por qué?</translation>
    </message>
    <message>
        <source>Following the drag</source>
        <translation>Siguiendo el arrastre</translation>
    </message>
    <message>
        <source>Solved, with warnings</source>
        <translation>Calculado, con avisos</translation>
    </message>
    <message>
        <source>Show (%1)</source>
        <translation>Mostrar (%1)</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>The cloth went on moving until the computation was ended. What usually causes that:
• A piece that nothing holds: fix one of its edges, or sew it on.
• A seam whose two sides differ much in length: make them more alike.
• A very long or very narrow piece: divide it, or make it wider.
• High pressure: lower it in the properties of the patch.
What you see is where the cloth was at the end.</source>
        <translation>La tela siguió moviéndose hasta que se terminó el cálculo. Las causas habituales:
• Una pieza que nada sujeta: fije uno de sus bordes o cósala.
• Una costura cuyos dos lados difieren mucho en longitud: iguálelos más.
• Una pieza muy larga o muy estrecha: divídala o ensánchela.
• Presión alta: bájela en las propiedades de la pieza.
Lo que ve es donde estaba la tela al final.</translation>
    </message>
    <message>
        <source>Drawing and checking …</source>
        <translation>Dibujando y comprobando…</translation>
    </message>
    <message>
        <source>Preparing: on fewer triangles …</source>
        <translation>Preparando: con menos triángulos…</translation>
    </message>
    <message>
        <source>Preparing: forces and equations …</source>
        <translation>Preparando: fuerzas y ecuaciones…</translation>
    </message>
    <message>
        <source>&amp;What does it mean?</source>
        <translation>¿&amp;Qué significa?</translation>
    </message>
    <message>
        <source>A preview, not checked yet</source>
        <translation>Vista previa, aún sin comprobar</translation>
    </message>
</context>
<context>
    <name>bolster::SweepWindow</name>
    <message>
        <source>Tolerances</source>
        <translation>Tolerancias</translation>
    </message>
    <message>
        <source>&amp;Draw pieces</source>
        <translation>&amp;Generar piezas</translation>
    </message>
    <message>
        <source>Solving pieces within tolerances …</source>
        <translation>Calculando piezas dentro de las tolerancias…</translation>
    </message>
    <message>
        <source>Pieces are drawn at random within their tolerances: where does the cover vary, which tolerance matters, how many pieces are out of the limit?</source>
        <translation>Se generan piezas al azar dentro de sus tolerancias: ¿dónde varía la funda, qué tolerancia importa, cuántas piezas quedan fuera del límite?</translation>
    </message>
    <message>
        <source>&amp;Show on the cover what 95 % of the pieces do not exceed</source>
        <translation>&amp;Mostrar en la funda lo que no supera el 95&#xa0;% de las piezas</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>Moves by at most</source>
        <translation>Se mueve como máximo</translation>
    </message>
    <message>
        <source>Tolerances by their influence</source>
        <translation>Tolerancias según su influencia</translation>
    </message>
    <message>
        <source>Tolerances (±); 0: none</source>
        <translation>Tolerancias (±); 0: ninguna</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Piezas</translation>
    </message>
    <message>
        <source>Every size within is as likely</source>
        <translation>Toda medida dentro de ella es igual de probable</translation>
    </message>
    <message>
        <source>Normal: the tolerance is three standard deviations</source>
        <translation>Normal: la tolerancia equivale a tres desviaciones típicas</translation>
    </message>
    <message>
        <source>Before them ten thousand are drawn as if covers were linear, which takes seconds</source>
        <translation>Antes se generan diez mil como si las fundas fueran lineales, lo que lleva segundos</translation>
    </message>
    <message>
        <source>Dr&amp;awn</source>
        <translation>Generad&amp;as</translation>
    </message>
    <message>
        <source>S&amp;olved</source>
        <translation>&amp;Calculadas</translation>
    </message>
    <message>
        <source>Nothing varies: give a tolerance above 0 of something that the design has.</source>
        <translation>Nada varía: indique una tolerancia mayor que 0 para algo que tenga el diseño.</translation>
    </message>
    <message>
        <source>Covers with each tolerance are solved …</source>
        <translation>Calculando las fundas con cada tolerancia…</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Detenido.</translation>
    </message>
    <message>
        <source>That is as if covers were linear; pieces are being solved …</source>
        <translation>Eso, como si las fundas fueran lineales; se están calculando piezas…</translation>
    </message>
    <message>
        <source>That is as if covers were linear.</source>
        <translation>Eso, como si las fundas fueran lineales.</translation>
    </message>
    <message numerus="yes">
        <source>By %n solved pieces.</source>
        <translation>
            <numerusform>Según %n pieza calculada.</numerusform>
            <numerusform>Según %n piezas calculadas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces have no cover at rest.</source>
        <translation>
            <numerusform>%n pieza no tiene ninguna funda en reposo.</numerusform>
            <numerusform>%n piezas no tienen ninguna funda en reposo.</numerusform>
        </translation>
    </message>
    <message>
        <source>What 95 % of the pieces do not exceed</source>
        <translation>Lo que no supera el 95&#xa0;% de las piezas</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: draw the pieces again.</source>
        <translation>El diseño ha cambiado entretanto: genere las piezas de nuevo.</translation>
    </message>
    <message numerus="yes">
        <source>By %n solved pieces so far; more are being solved …</source>
        <translation>
            <numerusform>Según %n pieza calculada hasta ahora; se calculan más…</numerusform>
            <numerusform>Según %n piezas calculadas hasta ahora; se calculan más…</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With %n tolerances no cover is found, as with: %1. They are left out of this: make them smaller.</source>
        <translation>
            <numerusform>Con %n tolerancia no se halla funda: %1. Queda fuera de esto: redúzcala.</numerusform>
            <numerusform>Con %n tolerancias no se halla funda, como con: %1. Quedan fuera de esto: redúzcalas.</numerusform>
        </translation>
    </message>
    <message>
        <source>A piece is out of it when more than 5 % of its cover lie farther from where they should be</source>
        <translation>Una pieza queda fuera cuando más del 5&#xa0;% de su funda está más lejos de donde debería</translation>
    </message>
    <message>
        <source>95 % of the pieces do not exceed, place by place, %1 (rms over the cover), %2 where it is most.</source>
        <translation>Lo que el 95&#xa0;% de las piezas no supera, punto por punto: %1 (RMS sobre la funda), %2 donde es máximo.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Parte</translation>
    </message>
    <message>
        <source>How much of the variance of the whole cover comes of it</source>
        <translation>Qué parte de la varianza de toda la funda procede de ella</translation>
    </message>
    <message>
        <source>± is what many more of them may change.</source>
        <translation>± es lo que muchas más podrían cambiar.</translation>
    </message>
    <message>
        <source>Out of the limit: about %1 of the pieces.</source>
        <translation>Fuera del límite: alrededor del %1 de las piezas.</translation>
    </message>
    <message>
        <source>Out of the limit: %1 of %2 pieces (of many: %3 to %4).</source>
        <translation>Fuera del límite: %1 de %2 piezas (de muchas: del %3 al %4).</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>These are too few to say how sure that is.</source>
        <translation>Son demasiado pocas para decir qué tan seguro es.</translation>
    </message>
    <message>
        <source>&amp;Limit for 95 % of a cover</source>
        <translation>&amp;Límite para el 95&#xa0;% de una funda</translation>
    </message>
    <message>
        <source>This is of what was set before: draw pieces for what is set now.</source>
        <translation>Esto corresponde a lo que se había ajustado antes: genere piezas para lo que está ajustado ahora.</translation>
    </message>
</context>
<context>
    <name>bolster::ToolHost</name>
    <message>
        <source>This could not be done, and nothing was changed: %1</source>
        <translation>No se pudo hacer y no se cambió nada: %1</translation>
    </message>
</context>
<context>
    <name>bolster::TourPanel</name>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>Salir del recorrido</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Help &gt; Tour goes on from here</source>
        <translation>Ayuda &gt; Recorrido continúa desde aquí</translation>
    </message>
    <message>
        <source>Tour, %1 of %2</source>
        <translation>Recorrido, %1 de %2</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Terminar</translation>
    </message>
</context>
<context>
    <name>bolster::TrimTool</name>
    <message>
        <source>Click a seam or an edge of an outline.</source>
        <translation>Haga clic en una costura o un borde de un contorno.</translation>
    </message>
    <message>
        <source>Click to stitch this seam; stitches and piping are in the properties</source>
        <translation>Clic para pespuntear esta costura; las puntadas y el vivo están en las propiedades</translation>
    </message>
    <message>
        <source>Click to stitch this edge; stitches and piping are in the properties</source>
        <translation>Clic para pespuntear este borde; las puntadas y el vivo están en las propiedades</translation>
    </message>
    <message>
        <source>Click a seam or an edge of an outline to stitch it – Esc ends the tool</source>
        <translation>Haga clic en una costura o un borde de un contorno para pespuntearlo — Esc sale de la herramienta</translation>
    </message>
</context>
<context>
    <name>bolster::VersionPane</name>
    <message>
        <source>Computing the cover …</source>
        <translation>Calculando la funda…</translation>
    </message>
    <message>
        <source>Pattern of %1</source>
        <translation>Patrón de %1</translation>
    </message>
    <message>
        <source>Cover of %1</source>
        <translation>Funda de %1</translation>
    </message>
</context>
<context>
    <name>bolster::ViewCube</name>
    <message>
        <source>FRONT</source>
        <translation>FRENTE</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>DETRÁS</translation>
    </message>
    <message>
        <source>LEFT</source>
        <translation>IZDA.</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <translation>DCHA.</translation>
    </message>
    <message>
        <source>TOP</source>
        <translation>ARRIBA</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <translation>ABAJO</translation>
    </message>
    <message>
        <source>Click a face, an edge or a corner to look from there; drag to turn</source>
        <translation>Haga clic en una cara, arista o esquina para mirar desde allí; arrastre para girar</translation>
    </message>
</context>
</TS>
