<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>AreaBrushTool</name>
    <message>
        <source>Drag over the cover to paint the area; with Shift held down to take away. + and − change the brush. Esc ends.</source>
        <translation>Glissez sur la housse pour peindre la zone&#x202f;; avec Maj enfoncée, pour retirer. + et − changent le pinceau. Échap termine.</translation>
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
        <translation>«&#x202f;%1&#x202f;» existe déjà. Remplacer&#x202f;?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>AttachTool</name>
    <message>
        <source>Click an edge of an outline.</source>
        <translation>Cliquez sur un bord d’un contour.</translation>
    </message>
    <message>
        <source>Select a fixation curve first, in the 3D view or in the list.</source>
        <translation>Sélectionnez d’abord une courbe de fixation, dans la vue 3D ou dans la liste.</translation>
    </message>
    <message>
        <source>Several stretches go with one curve, or one stretch with several curves.</source>
        <translation>Plusieurs tronçons vont avec une courbe, ou un tronçon avec plusieurs courbes.</translation>
    </message>
    <message>
        <source>The stretches overlap each other, or are attached like this already.</source>
        <translation>Les tronçons se chevauchent, ou sont déjà fixés ainsi.</translation>
    </message>
    <message>
        <source>This stretch is attached like this already.</source>
        <translation>Ce tronçon est déjà fixé ainsi.</translation>
    </message>
    <message>
        <source>Select a fixation curve in the 3D view or in the list, then click an edge of an outline – Esc ends the tool</source>
        <translation>Sélectionnez une courbe de fixation dans la vue 3D ou dans la liste, puis cliquez sur un bord d’un contour – Échap quitte l’outil</translation>
    </message>
    <message>
        <source>%1 curves</source>
        <translation>%1 courbes</translation>
    </message>
    <message>
        <source>Click to fix this stretch of %1 to %2 – Shift+click collects several</source>
        <translation>Cliquez pour fixer ce tronçon de %1 à %2 – Maj+clic en réunit plusieurs</translation>
    </message>
    <message>
        <source>Click the last edge, or Enter attaches %1 stretches to %2 – Backspace takes one back</source>
        <translation>Cliquez sur le dernier bord, ou Entrée fixe %1 tronçons à %2 – Retour arrière en retire un</translation>
    </message>
    <message>
        <source>Click an edge of an outline to fix it to %1 – Enter takes the selected stretch, Esc ends the tool</source>
        <translation>Cliquez sur un bord d’un contour pour le fixer à %1 – Entrée prend le tronçon sélectionné, Échap quitte l’outil</translation>
    </message>
    <message>
        <source>&amp;Attach what is marked</source>
        <translation>&amp;Fixer ce qui est marqué</translation>
    </message>
    <message>
        <source>&amp;Take back the last edge</source>
        <translation>&amp;Retirer le dernier bord</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>&amp;Abandonner</translation>
    </message>
</context>
<context>
    <name>BackgroundMoveTool</name>
    <message>
        <source>There is no background picture yet.</source>
        <translation>Il n’y a pas encore d’image de fond.</translation>
    </message>
    <message>
        <source>Drag the picture to its place – Enter or Esc ends the tool</source>
        <translation>Faites glisser l’image à sa place – Entrée ou Échap quitte l’outil</translation>
    </message>
</context>
<context>
    <name>BackgroundPicture</name>
    <message>
        <source>%1 cannot be read as a picture: %2</source>
        <translation>%1 n’est pas lisible comme image&#x202f;: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an ordinary file.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un fichier ordinaire.</translation>
    </message>
</context>
<context>
    <name>BackgroundScaleTool</name>
    <message>
        <source>There is no background picture yet.</source>
        <translation>Il n’y a pas encore d’image de fond.</translation>
    </message>
    <message>
        <source>Type the true distance of the two points, for example 500 or 20 in.</source>
        <translation>Saisissez la distance réelle des deux points, par exemple 500 ou 20 in.</translation>
    </message>
    <message>
        <source>Click the first of two points of the picture whose distance you know – Esc ends the tool</source>
        <translation>Cliquez sur le premier de deux points de l’image dont vous connaissez la distance – Échap quitte l’outil</translation>
    </message>
    <message>
        <source>Click the second point</source>
        <translation>Cliquez sur le second point</translation>
    </message>
    <message>
        <source>Type their true distance, then Enter</source>
        <translation>Saisissez leur distance réelle, puis Entrée</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>maintenant %1</translation>
    </message>
</context>
<context>
    <name>BoxShapeTool</name>
    <message>
        <source>&quot;%1&quot; is no size: try 300 x 200</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas une taille&#x202f;: essayez 300 x 200</translation>
    </message>
    <message>
        <source>Enter makes it as wide and high as typed, for example 300 x 200</source>
        <translation>Entrée donne la largeur et la hauteur saisies, par exemple 300 x 200</translation>
    </message>
    <message>
        <source>Drag a rectangle, or click two opposite corners – Esc ends the tool</source>
        <translation>Tracez un rectangle, ou cliquez sur deux coins opposés – Échap quitte l’outil</translation>
    </message>
    <message>
        <source>Drag an ellipse, or click two opposite corners of its box – Esc ends the tool</source>
        <translation>Tracez une ellipse, ou cliquez sur deux coins opposés de son cadre – Échap quitte l’outil</translation>
    </message>
    <message>
        <source>Click the opposite corner, or type width x height – Shift makes both equal, Ctrl does not snap</source>
        <translation>Cliquez sur le coin opposé, ou saisissez largeur x hauteur – Maj les rend égales, Ctrl désactive l’accrochage</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>There was no room where you clicked: the patch lies beside the others.</source>
        <translation>Il n’y avait pas de place là où vous avez cliqué&#x202f;: la pièce est à côté des autres.</translation>
    </message>
    <message>
        <source>The new patch lies on %1: drag it away, or let all be arranged (Pattern &gt; Arrange).</source>
        <translation>La nouvelle pièce recouvre %1&#x202f;: déplacez-la, ou faites tout disposer (Patron &gt; Disposer).</translation>
    </message>
    <message>
        <source>lies on %1</source>
        <translation>recouvre %1</translation>
    </message>
</context>
<context>
    <name>ColourwayForm</name>
    <message>
        <source>Fabrics</source>
        <translation>Tissus</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>those of the patches</source>
        <translation>ceux des pièces</translation>
    </message>
</context>
<context>
    <name>ContextMenus</name>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Afficher</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>&amp;Regarder depuis</translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Carte</translation>
    </message>
    <message>
        <source>&amp;Continuity</source>
        <translation>Co&amp;ntinuité</translation>
    </message>
    <message>
        <source>&amp;Match</source>
        <translation>Corre&amp;spondance</translation>
    </message>
    <message>
        <source>&amp;Arrange</source>
        <translation>&amp;Disposer</translation>
    </message>
</context>
<context>
    <name>CoverAtRest</name>
    <message>
        <source>As soon as the cover has come to rest …</source>
        <translation>Dès que la housse est au repos…</translation>
    </message>
    <message>
        <source>This needs the cover of the present design: let the solver go on first (Pause).</source>
        <translation>Cela demande la housse du modèle actuel&#x202f;: laissez d’abord le calcul continuer (Pause).</translation>
    </message>
</context>
<context>
    <name>CoverMeasureTool</name>
    <message>
        <source>There is no cover here: click on the cover.</source>
        <translation>Il n’y a pas de housse ici&#x202f;: cliquez sur la housse.</translation>
    </message>
    <message>
        <source>&amp;Keep the measurement</source>
        <translation>&amp;Garder la mesure</translation>
    </message>
    <message>
        <source>%1 – Enter keeps the measurement, a click begins anew</source>
        <translation>%1 – Entrée garde la mesure, un clic recommence</translation>
    </message>
    <message>
        <source>Click the second point on the cover – Esc gives it up</source>
        <translation>Cliquez le second point sur la housse – Échap abandonne</translation>
    </message>
    <message>
        <source>Click two points of the cover or of the pattern to measure – Esc ends the tool</source>
        <translation>Cliquez deux points de la housse ou du patron pour mesurer – Échap quitte l’outil</translation>
    </message>
</context>
<context>
    <name>CoverSelectTool</name>
    <message>
        <source>There is a control point already.</source>
        <translation>Il y a déjà un point de contrôle ici.</translation>
    </message>
    <message>
        <source>Drag to move the control point – Shift+click selects several, Del removes</source>
        <translation>Faites glisser pour déplacer le point de contrôle – Maj+clic en sélectionne plusieurs, Suppr supprime</translation>
    </message>
    <message>
        <source>Click to select the seam</source>
        <translation>Cliquez pour sélectionner la couture</translation>
    </message>
    <message>
        <source>Click to select the patch, drag to turn the view</source>
        <translation>Cliquez pour sélectionner la pièce, faites glisser pour tourner la vue</translation>
    </message>
    <message>
        <source>Click to select the curve, double click to add a control point here</source>
        <translation>Cliquez pour sélectionner la courbe, double-cliquez pour ajouter ici un point de contrôle</translation>
    </message>
    <message>
        <source>Click to select what stands here, drag to turn the view</source>
        <translation>Cliquez pour sélectionner ce qui se trouve ici, faites glisser pour tourner la vue</translation>
    </message>
    <message>
        <source>Click to select, drag to turn – %1 pans, %2 zooms</source>
        <translation>Cliquez pour sélectionner, faites glisser pour tourner – déplacer la vue&#x202f;: %1, zoomer&#x202f;: %2</translation>
    </message>
    <message>
        <source>Click to select the measurement, Delete removes it</source>
        <translation>Cliquez pour sélectionner la mesure, Suppr la supprime</translation>
    </message>
</context>
<context>
    <name>CushionForm</name>
    <message>
        <source>Cover of %1</source>
        <translation>Housse de %1</translation>
    </message>
    <message>
        <source>Every cover</source>
        <translation>Toutes les housses</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Pousse</translation>
    </message>
</context>
<context>
    <name>CutCornerForm</name>
    <message>
        <source>Patch</source>
        <translation>Pièce</translation>
    </message>
</context>
<context>
    <name>CutLabelWords</name>
    <message>
        <source>Cut %1</source>
        <translation>Couper %1 fois</translation>
    </message>
    <message>
        <source>Cut %1 and %1 mirrored</source>
        <translation>Couper %1 fois et %1 en miroir</translation>
    </message>
</context>
<context>
    <name>CuttingCommands</name>
    <message>
        <source>Chec&amp;k before cutting</source>
        <translation>&amp;Vérifier avant la coupe</translation>
    </message>
</context>
<context>
    <name>DartCommands</name>
    <message>
        <source>Remove da&amp;rt</source>
        <translation>&amp;Supprimer la pince</translation>
    </message>
    <message>
        <source>The edge goes on as if the selected dart had never been cut</source>
        <translation>Le bord continue comme si la pince sélectionnée n’avait jamais été coupée</translation>
    </message>
    <message>
        <source>R&amp;otate dart to …</source>
        <translation>Pi&amp;voter la pince vers…</translation>
    </message>
    <message>
        <source>Turns the selected dart shut and opens the pattern where you click, by the same angle</source>
        <translation>Ferme la pince sélectionnée et ouvre le patron là où vous cliquez, du même angle</translation>
    </message>
</context>
<context>
    <name>DartDrag</name>
    <message>
        <source>Near the dotted line both legs become of one length, or type how deep it is – Shift keeps to it, Ctrl lets go, Esc takes it back</source>
        <translation>Près de la ligne pointillée, les deux côtés deviennent égaux&#x202f;; ou saisissez la profondeur – Maj y reste, Ctrl s’en libère, Échap annule</translation>
    </message>
    <message>
        <source>Drag the dart along the outline, or type how far its middle is from the corner – Esc takes it back</source>
        <translation>Faites glisser la pince le long du contour, ou saisissez la distance de son milieu au coin – Échap annule</translation>
    </message>
</context>
<context>
    <name>DartPicture</name>
    <message>
        <source>Depth %1, legs of one length</source>
        <translation>Profondeur %1, côtés égaux</translation>
    </message>
    <message>
        <source>Depth %1</source>
        <translation>Profondeur %1</translation>
    </message>
    <message>
        <source>Mouth %1</source>
        <translation>Ouverture %1</translation>
    </message>
</context>
<context>
    <name>DartRotateTool</name>
    <message>
        <source>Select the seam of a dart first – Esc ends the tool</source>
        <translation>Sélectionnez d’abord la couture d’une pince – Échap quitte l’outil</translation>
    </message>
    <message>
        <source>Click the outline where the dart shall open instead – Ctrl does not snap, Esc ends the tool</source>
        <translation>Cliquez sur le contour là où la pince doit s’ouvrir – Ctrl désactive l’accrochage, Échap quitte l’outil</translation>
    </message>
</context>
<context>
    <name>DartTool</name>
    <message>
        <source>There is no room for a mouth of &quot;%1&quot;.</source>
        <translation>Il n’y a pas la place pour une ouverture de «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no depth: try 60</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas une profondeur&#x202f;: essayez 60</translation>
    </message>
    <message>
        <source>Click the tip inside the patch, or type how deep it lies – on the dotted line both legs are of one length (Shift keeps to it, Ctrl lets go), Esc takes a click back</source>
        <translation>Cliquez sur la pointe dans la pièce, ou saisissez sa profondeur – sur la ligne pointillée les deux côtés sont égaux (Maj y reste, Ctrl s’en libère), Échap annule un clic</translation>
    </message>
    <message>
        <source>Click where the mouth ends on the same outline, or type how wide it is – Ctrl does not snap, Esc takes the click back</source>
        <translation>Cliquez là où l’ouverture finit sur le même contour, ou saisissez sa largeur – Ctrl désactive l’accrochage, Échap annule le clic</translation>
    </message>
    <message>
        <source>Click an outline where the mouth of the dart begins – Esc ends the tool</source>
        <translation>Cliquez sur un contour là où commence l’ouverture de la pince – Échap quitte l’outil</translation>
    </message>
</context>
<context>
    <name>DescribedField</name>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
</context>
<context>
    <name>DesignCuttingSection</name>
    <message>
        <source>Cutting</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Seam allowance of all patches</source>
        <translation>Marge de couture de toutes les pièces</translation>
    </message>
    <message>
        <source>Depth of notches</source>
        <translation>Profondeur des crans</translation>
    </message>
    <message>
        <source>Width of notches</source>
        <translation>Largeur des crans</translation>
    </message>
</context>
<context>
    <name>Docks</name>
    <message>
        <source>Pattern</source>
        <translation>Patron</translation>
    </message>
    <message>
        <source>Cover</source>
        <translation>Housse</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Éléments</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propriétés</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problèmes</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Coutures</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Tissus</translation>
    </message>
    <message>
        <source>Worst spots</source>
        <translation>Zones critiques</translation>
    </message>
    <message>
        <source>Check before cutting</source>
        <translation>Vérification avant coupe</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Tâches</translation>
    </message>
</context>
<context>
    <name>DrawingCommands</name>
    <message>
        <source>&amp;Grid and snapping</source>
        <translation>&amp;Grille et accrochage</translation>
    </message>
    <message>
        <source>S&amp;napping</source>
        <translation>&amp;Accrochage</translation>
    </message>
    <message>
        <source>&amp;Rulers</source>
        <translation>&amp;Règles</translation>
    </message>
    <message>
        <source>Gui&amp;des</source>
        <translation>R&amp;epères</translation>
    </message>
    <message>
        <source>Remove all g&amp;uides</source>
        <translation>&amp;Supprimer tous les repères</translation>
    </message>
    <message>
        <source>Select with a &amp;loop</source>
        <translation>Sélectionner au &amp;lasso</translation>
    </message>
    <message>
        <source>&amp;Background picture</source>
        <translation>Image de &amp;fond</translation>
    </message>
    <message>
        <source>&amp;Open picture …</source>
        <translation>&amp;Ouvrir une image…</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>&amp;Afficher</translation>
    </message>
    <message>
        <source>&amp;Scale by two points</source>
        <translation>Mettre à l’é&amp;chelle par deux points</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Déplacer</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Opacity %1</source>
        <translation>Opacité %1</translation>
    </message>
    <message>
        <source>Open a picture to trace</source>
        <translation>Ouvrir une image à décalquer</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.webp);;All files (*)</source>
        <translation>Images (*.png *.jpg *.jpeg *.bmp *.webp);;Tous les fichiers (*)</translation>
    </message>
</context>
<context>
    <name>DrawingKeys</name>
    <message>
        <source>&amp;Finish</source>
        <translation>&amp;Terminer</translation>
    </message>
    <message>
        <source>&amp;Take back the last point</source>
        <translation>&amp;Retirer le dernier point</translation>
    </message>
    <message>
        <source>Switch between &amp;straight and smooth</source>
        <translation>Alterner &amp;droit et lisse</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>&amp;Abandonner</translation>
    </message>
</context>
<context>
    <name>DrillHoleForm</name>
    <message>
        <source>Patch</source>
        <translation>Pièce</translation>
    </message>
</context>
<context>
    <name>EdgeAllowanceForm</name>
    <message>
        <source>Outline</source>
        <translation>Contour</translation>
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
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Name this &amp;branch …</source>
        <translation>Nommer cette &amp;branche…</translation>
    </message>
    <message>
        <source>Name the way that the history has gone since it forked</source>
        <translation>Nomme le chemin pris par l’historique depuis la dernière bifurcation</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Re&amp;nommer</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Select &amp;all patches</source>
        <translation>Sélectionner &amp;toutes les pièces</translation>
    </message>
    <message>
        <source>Select n&amp;othing</source>
        <translation>Tout &amp;désélectionner</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Annuler&#x202f;: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rétablir&#x202f;: %1</translation>
    </message>
</context>
<context>
    <name>ElementText</name>
    <message>
        <source>missing element %1</source>
        <translation>élément manquant %1</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Couture</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Coutures</translation>
    </message>
    <message>
        <source>Fixation curve</source>
        <translation>Courbe de fixation</translation>
    </message>
    <message>
        <source>Fixation curves</source>
        <translation>Courbes de fixation</translation>
    </message>
    <message>
        <source>Fixation</source>
        <translation>Fixation</translation>
    </message>
    <message>
        <source>Fixations</source>
        <translation>Fixations</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Armature</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Armatures</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Tissu</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Tissus</translation>
    </message>
    <message>
        <source>Unusable element</source>
        <translation>Élément inutilisable</translation>
    </message>
    <message>
        <source>Unusable elements</source>
        <translation>Éléments inutilisables</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>%1 and %2, ease %3</source>
        <translation>%1 et %2, embu %3</translation>
    </message>
    <message>
        <source>%1, normal held</source>
        <translation>%1, normale imposée</translation>
    </message>
    <message>
        <source>Handle curve</source>
        <translation>Courbe de maintien</translation>
    </message>
    <message>
        <source>Handle curves</source>
        <translation>Courbes de maintien</translation>
    </message>
    <message>
        <source>Fancy seam</source>
        <translation>Couture décorative</translation>
    </message>
    <message>
        <source>Fancy seams</source>
        <translation>Coutures décoratives</translation>
    </message>
    <message>
        <source>Cushion</source>
        <translation>Rembourrage</translation>
    </message>
    <message>
        <source>Cushions</source>
        <translation>Rembourrages</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>Mousse</translation>
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
        <translation>%1 pièces</translation>
    </message>
    <message>
        <source>%1 seams</source>
        <translation>%1 coutures</translation>
    </message>
    <message>
        <source>%1 fixation curves</source>
        <translation>%1 courbes de fixation</translation>
    </message>
    <message>
        <source>%1 fixations</source>
        <translation>%1 fixations</translation>
    </message>
    <message>
        <source>%1 handle curves</source>
        <translation>%1 courbes de maintien</translation>
    </message>
    <message>
        <source>%1 fancy seams</source>
        <translation>%1 coutures décoratives</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 armatures</translation>
    </message>
    <message>
        <source>%1 cushions</source>
        <translation>%1 rembourrages</translation>
    </message>
    <message>
        <source>%1 pieces of foam</source>
        <translation>%1 blocs de mousse</translation>
    </message>
    <message>
        <source>%1 scans</source>
        <translation>%1 scans</translation>
    </message>
    <message>
        <source>%1 fabrics</source>
        <translation>%1 tissus</translation>
    </message>
    <message>
        <source>%1 unusable elements</source>
        <translation>%1 éléments inutilisables</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 éléments</translation>
    </message>
    <message>
        <source>Trimmed edge</source>
        <translation>Bord avec finition</translation>
    </message>
    <message>
        <source>Trimmed edges</source>
        <translation>Bords avec finition</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>Coloris</translation>
    </message>
    <message>
        <source>Colourways</source>
        <translation>Coloris</translation>
    </message>
    <message>
        <source>%1 trimmed edges</source>
        <translation>%1 bords avec finition</translation>
    </message>
    <message>
        <source>%1 colourways</source>
        <translation>%1 coloris</translation>
    </message>
    <message>
        <source>Edge of %1</source>
        <translation>Bord de %1</translation>
    </message>
    <message>
        <source>Allowance of an edge</source>
        <translation>Marge d’un bord</translation>
    </message>
    <message>
        <source>Allowances of edges</source>
        <translation>Marges de bords</translation>
    </message>
    <message>
        <source>%1 allowances of edges</source>
        <translation>%1 marges de bords</translation>
    </message>
    <message>
        <source>Corner of the cut line</source>
        <translation>Coin de la ligne de coupe</translation>
    </message>
    <message>
        <source>Corners of the cut line</source>
        <translation>Coins de la ligne de coupe</translation>
    </message>
    <message>
        <source>%1 corners of the cut line</source>
        <translation>%1 coins de la ligne de coupe</translation>
    </message>
    <message>
        <source>Drill hole</source>
        <translation>Perçage</translation>
    </message>
    <message>
        <source>Drill holes</source>
        <translation>Perçages</translation>
    </message>
    <message>
        <source>%1 drill holes</source>
        <translation>%1 perçages</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>Cran</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Crans</translation>
    </message>
    <message>
        <source>%1 notches</source>
        <translation>%1 crans</translation>
    </message>
    <message>
        <source>Internal line</source>
        <translation>Ligne interne</translation>
    </message>
    <message>
        <source>Internal lines</source>
        <translation>Lignes internes</translation>
    </message>
    <message>
        <source>%1 internal lines</source>
        <translation>%1 lignes internes</translation>
    </message>
    <message>
        <source>%1, allowance %2</source>
        <translation>%1, marge %2</translation>
    </message>
    <message>
        <source>Notch of %1</source>
        <translation>Cran de %1</translation>
    </message>
    <message>
        <source>Corner of %1</source>
        <translation>Coin de %1</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>%1 measurements</source>
        <translation>%1 mesures</translation>
    </message>
</context>
<context>
    <name>ElementsModel</name>
    <message>
        <source>edge %1</source>
        <translation>bord %1</translation>
    </message>
    <message>
        <source>%1 from the corner</source>
        <translation>%1 depuis le coin</translation>
    </message>
</context>
<context>
    <name>FabricForm</name>
    <message>
        <source>Weft</source>
        <translation>Trame</translation>
    </message>
    <message>
        <source>Creases</source>
        <translation>Rides</translation>
    </message>
    <message>
        <source>Depth of the pile</source>
        <translation>Hauteur du poil</translation>
    </message>
    <message>
        <source>Other squares</source>
        <translation>Autres carreaux</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Squares</source>
        <translation>Carreaux</translation>
    </message>
    <message>
        <source>Grain size</source>
        <translation>Taille du grain</translation>
    </message>
    <message>
        <source>Repeat of the weave</source>
        <translation>Rapport d’armure</translation>
    </message>
    <message>
        <source>Nap</source>
        <translation>Sens du poil</translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation>Largeur de l’image</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>Comportement</translation>
    </message>
    <message>
        <source>The fabric on a cushion and on a ball</source>
        <translation>Le tissu sur un coussin et sur une boule</translation>
    </message>
    <message>
        <source>The fabric on a cushion and on a ball, at its real scale</source>
        <translation>Le tissu sur un coussin et sur une boule, à son échelle réelle</translation>
    </message>
    <message>
        <source>Colour of the fabric</source>
        <translation>Couleur du tissu</translation>
    </message>
    <message>
        <source>Second colour of the fabric</source>
        <translation>Seconde couleur du tissu</translation>
    </message>
    <message>
        <source>From the first colour</source>
        <translation>D’après la première couleur</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Choose an&amp;other picture …</source>
        <translation>Choisir une a&amp;utre image…</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Coupe</translation>
    </message>
</context>
<context>
    <name>FabricMenu</name>
    <message>
        <source>&amp;New fabric</source>
        <translation>&amp;Nouveau tissu</translation>
    </message>
    <message>
        <source>Adds leather, weave, velvet or another fabric to the library of the design</source>
        <translation>Ajoute un cuir, un tissé, un velours ou un autre tissu à la bibliothèque du modèle</translation>
    </message>
    <message>
        <source>From a &amp;picture …</source>
        <translation>Depuis une ima&amp;ge…</translation>
    </message>
    <message>
        <source>A fabric that looks like a picture: PNG, JPEG, TIFF or OpenEXR</source>
        <translation>Un tissu qui a l’aspect d’une image&#x202f;: PNG, JPEG, TIFF ou OpenEXR</translation>
    </message>
    <message>
        <source>&amp;Assign to selection</source>
        <translation>A&amp;ffecter à la sélection</translation>
    </message>
    <message>
        <source>Gives the selected patches the fabric that is chosen in the library</source>
        <translation>Donne aux pièces sélectionnées le tissu choisi dans la bibliothèque</translation>
    </message>
    <message>
        <source>Fabric p&amp;roperties</source>
        <translation>&amp;Propriétés du tissu</translation>
    </message>
    <message>
        <source>Shows kind, colours, size and limits of the fabric</source>
        <translation>Affiche le type, les couleurs, la taille et les limites du tissu</translation>
    </message>
    <message>
        <source>Picture on the &amp;fabric …</source>
        <translation>Image sur le &amp;tissu…</translation>
    </message>
    <message>
        <source>Lets the fabric look like a picture: PNG, JPEG, TIFF or OpenEXR</source>
        <translation>Donne au tissu l’aspect d’une image&#x202f;: PNG, JPEG, TIFF ou OpenEXR</translation>
    </message>
    <message>
        <source>D&amp;uplicate fabric</source>
        <translation>&amp;Dupliquer le tissu</translation>
    </message>
    <message>
        <source>Adds a copy of the fabric, to be changed</source>
        <translation>Ajoute une copie du tissu, à modifier</translation>
    </message>
    <message>
        <source>Rename fa&amp;bric …</source>
        <translation>&amp;Renommer le tissu…</translation>
    </message>
    <message>
        <source>Gives the fabric another name</source>
        <translation>Donne un autre nom au tissu</translation>
    </message>
    <message>
        <source>&amp;Delete fabric …</source>
        <translation>S&amp;upprimer le tissu…</translation>
    </message>
    <message>
        <source>Removes the fabric; asks what patches get instead</source>
        <translation>Supprime le tissu&#x202f;; demande ce que les pièces reçoivent à la place</translation>
    </message>
    <message>
        <source>&amp;Import fabrics …</source>
        <translation>&amp;Importer des tissus…</translation>
    </message>
    <message>
        <source>Takes over the fabrics of a file, a design or a project</source>
        <translation>Reprend les tissus d’un fichier, d’un modèle ou d’un projet</translation>
    </message>
    <message>
        <source>&amp;Export fabric …</source>
        <translation>&amp;Exporter le tissu…</translation>
    </message>
    <message>
        <source>Writes the fabric to a file, its picture beside it</source>
        <translation>Écrit le tissu dans un fichier, son image à côté</translation>
    </message>
    <message>
        <source>Pre&amp;views</source>
        <translation>&amp;Aperçus</translation>
    </message>
    <message>
        <source>On &amp;cushions</source>
        <translation>Sur &amp;coussins</translation>
    </message>
    <message>
        <source>Shows the fabrics of the library on cushions</source>
        <translation>Montre les tissus de la bibliothèque sur des coussins</translation>
    </message>
    <message>
        <source>On &amp;balls</source>
        <translation>Sur &amp;boules</translation>
    </message>
    <message>
        <source>Shows the fabrics of the library on balls</source>
        <translation>Montre les tissus de la bibliothèque sur des boules</translation>
    </message>
    <message>
        <source>&amp;Show colourway</source>
        <translation>Afficher le &amp;coloris</translation>
    </message>
    <message>
        <source>Chooses which fabrics are seen; the shape stays</source>
        <translation>Choisit les tissus visibles&#x202f;; la forme reste</translation>
    </message>
    <message>
        <source>New &amp;colourway …</source>
        <translation>N&amp;ouveau coloris…</translation>
    </message>
    <message>
        <source>Adds a set of fabrics for the patches; it begins as what is shown now</source>
        <translation>Ajoute un jeu de tissus pour les pièces&#x202f;; il part de ce qui est affiché</translation>
    </message>
    <message>
        <source>Rena&amp;me colourway …</source>
        <translation>Renommer le colori&amp;s…</translation>
    </message>
    <message>
        <source>Gives the colourway that is shown another name</source>
        <translation>Donne un autre nom au coloris affiché</translation>
    </message>
    <message>
        <source>De&amp;lete colourway</source>
        <translation>Supprimer &amp;le coloris</translation>
    </message>
    <message>
        <source>Removes the colourway that is shown</source>
        <translation>Supprime le coloris affiché</translation>
    </message>
    <message>
        <source>Compare c&amp;olourways …</source>
        <translation>Co&amp;mparer les coloris…</translation>
    </message>
    <message>
        <source>Shows two colourways side by side</source>
        <translation>Montre deux coloris côte à côte</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>D’origine</translation>
    </message>
</context>
<context>
    <name>FabricPresets</name>
    <message>
        <source>Leather, cognac</source>
        <translation>Cuir, cognac</translation>
    </message>
    <message>
        <source>Leather, black</source>
        <translation>Cuir, noir</translation>
    </message>
    <message>
        <source>Leather, cream</source>
        <translation>Cuir, crème</translation>
    </message>
    <message>
        <source>Smooth leather, dark brown</source>
        <translation>Cuir lisse, brun foncé</translation>
    </message>
    <message>
        <source>Smooth leather, red</source>
        <translation>Cuir lisse, rouge</translation>
    </message>
    <message>
        <source>Weave, grey</source>
        <translation>Tissé, gris</translation>
    </message>
    <message>
        <source>Weave, blue</source>
        <translation>Tissé, bleu</translation>
    </message>
    <message>
        <source>Weave, sand</source>
        <translation>Tissé, sable</translation>
    </message>
    <message>
        <source>Velvet, green</source>
        <translation>Velours, vert</translation>
    </message>
    <message>
        <source>Velvet, petrol</source>
        <translation>Velours, pétrole</translation>
    </message>
    <message>
        <source>Checker, 20 mm</source>
        <translation>Damier, 20&#xa0;mm</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Uni</translation>
    </message>
</context>
<context>
    <name>FancySeamForm</name>
    <message>
        <source>Patch</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>It stands out: a welt.</source>
        <translation>Elle est en relief&#x202f;: un bourrelet.</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>Patch</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Tissu</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Tissus</translation>
    </message>
    <message>
        <source>Press harder</source>
        <translation>Appuient plus fort</translation>
    </message>
    <message>
        <source>Press like straight ones</source>
        <translation>Appuient comme les droites</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Armature</translation>
    </message>
    <message>
        <source>Padded parts</source>
        <translation>Parties garnies</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Pousse</translation>
    </message>
    <message>
        <source>Smallest detail</source>
        <translation>Plus petit détail</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>Garniture</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>Slanted faces</source>
        <translation>Faces obliques</translation>
    </message>
    <message>
        <source>Pushes the cover</source>
        <translation>Pousse la housse</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Uni</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>Damier</translation>
    </message>
    <message>
        <source>Smooth leather</source>
        <translation>Cuir lisse</translation>
    </message>
    <message>
        <source>Grained leather</source>
        <translation>Cuir grainé</translation>
    </message>
    <message>
        <source>Woven</source>
        <translation>Tissé</translation>
    </message>
    <message>
        <source>Velvet</source>
        <translation>Velours</translation>
    </message>
    <message>
        <source>Picture …</source>
        <translation>Image…</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Second colour</source>
        <translation>Seconde couleur</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rugosité</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Turned from the grain</source>
        <translation>Angle au droit-fil</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>Relief</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Most along the grain</source>
        <translation>Max. en droit-fil</translation>
    </message>
    <message>
        <source>Most across</source>
        <translation>Max. en travers</translation>
    </message>
    <message>
        <source>Most shear</source>
        <translation>Cisaillement max.</translation>
    </message>
    <message>
        <source>Poisson</source>
        <translation>Poisson</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidité</translation>
    </message>
    <message>
        <source>Bending length</source>
        <translation>Longueur de flexion</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aspect</translation>
    </message>
    <message>
        <source>Strain limits</source>
        <translation>Limites de déformation</translation>
    </message>
    <message>
        <source>Mirror twin</source>
        <translation>Jumeau symétrique</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>On the curve</source>
        <translation>Sur la courbe</translation>
    </message>
    <message>
        <source>Curve runs backwards</source>
        <translation>Courbe inversée</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Poids</translation>
    </message>
    <message>
        <source>Curve in space</source>
        <translation>Courbe dans l’espace</translation>
    </message>
    <message>
        <source>Round – a soft groove</source>
        <translation>Arrondi – rainure douce</translation>
    </message>
    <message>
        <source>Sharp – a crease</source>
        <translation>Vif – pli marqué</translation>
    </message>
    <message>
        <source>Welt – between creases</source>
        <translation>Bourrelet – entre deux plis</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
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
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>Droit-fil</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Pression</translation>
    </message>
    <message>
        <source>Wrong side out</source>
        <translation>Envers à l’extérieur</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Bois</translation>
    </message>
    <message>
        <source>Metal</source>
        <translation>Métal</translation>
    </message>
    <message>
        <source>Plastic</source>
        <translation>Plastique</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>Mousse</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Keeps the cover outside</source>
        <translation>Garde la housse dehors</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Jeu</translation>
    </message>
    <message>
        <source>Hidden parts</source>
        <translation>Parties masquées</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Pavé</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Cylindre</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Sphère</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>Cushion</source>
        <translation>Rembourrage</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Évidé</translation>
    </message>
    <message>
        <source>Along the normal</source>
        <translation>Le long de la normale</translation>
    </message>
    <message>
        <source>To the point itself</source>
        <translation>Vers le point même</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Seuil</translation>
    </message>
    <message>
        <source>Fit the cover to it</source>
        <translation>Y ajuster la housse</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Traction</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Découpes</translation>
    </message>
    <message>
        <source>C0 – an edge</source>
        <translation>C0 – arête</translation>
    </message>
    <message>
        <source>C1 – smooth, texture too</source>
        <translation>C1 – lisse, motif compris</translation>
    </message>
    <message>
        <source>G1 – rounded</source>
        <translation>G1 – arrondi</translation>
    </message>
    <message>
        <source>First stretch</source>
        <translation>Premier tronçon</translation>
    </message>
    <message>
        <source>Second stretch</source>
        <translation>Second tronçon</translation>
    </message>
    <message>
        <source>Second side runs backwards</source>
        <translation>Second côté inversé</translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation>Continuité</translation>
    </message>
    <message>
        <source>Mesh edges</source>
        <translation>Arêtes du maillage</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symétrie</translation>
    </message>
    <message>
        <source>Colourway shown</source>
        <translation>Coloris affiché</translation>
    </message>
    <message>
        <source>Begins at</source>
        <translation>Commence à</translation>
    </message>
    <message>
        <source>Ends at</source>
        <translation>Finit à</translation>
    </message>
    <message>
        <source>By length</source>
        <translation>Par longueur</translation>
    </message>
    <message>
        <source>By parameter</source>
        <translation>Par paramètre</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Correspondance</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Single row</source>
        <translation>Une rangée</translation>
    </message>
    <message>
        <source>Twin rows</source>
        <translation>Deux rangées</translation>
    </message>
    <message>
        <source>Stitches</source>
        <translation>Surpiqûre</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Stitch length</source>
        <translation>Longueur de point</translation>
    </message>
    <message>
        <source>Distance from the seam</source>
        <translation>Distance à la couture</translation>
    </message>
    <message>
        <source>Thread width</source>
        <translation>Grosseur du fil</translation>
    </message>
    <message>
        <source>Radius (0: none)</source>
        <translation>Rayon (0&#x202f;: aucun)</translation>
    </message>
    <message>
        <source>Seam allowance</source>
        <translation>Marge de couture</translation>
    </message>
    <message>
        <source>The cover dips into the seam</source>
        <translation>La housse se creuse à la couture</translation>
    </message>
    <message>
        <source>Trim</source>
        <translation>Finition</translation>
    </message>
    <message>
        <source> mm per unit</source>
        <translation> mm par unité</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>The frame that is padded</source>
        <translation>L’armature qui est garnie</translation>
    </message>
    <message>
        <source>Which cover the padding presses outwards</source>
        <translation>La housse que la garniture pousse vers l’extérieur</translation>
    </message>
    <message>
        <source>How finely the frame is looked at: what is thinner may stay without padding</source>
        <translation>Finesse d’examen de l’armature&#x202f;: ce qui est plus mince peut rester sans garniture</translation>
    </message>
    <message>
        <source>How thick the padding around the frame is</source>
        <translation>Épaisseur de la garniture autour de l’armature</translation>
    </message>
    <message>
        <source>How hard the padding presses the cover outwards; from about 2 on it gives no more</source>
        <translation>Force avec laquelle la garniture pousse la housse vers l’extérieur&#x202f;; à partir de 2 environ, elle n’augmente plus</translation>
    </message>
    <message>
        <source>How padding presses that is aslant to width, depth and height: harder fills the cover more</source>
        <translation>Poussée de la garniture oblique par rapport à la largeur, la profondeur et la hauteur&#x202f;: plus forte, elle remplit mieux la housse</translation>
    </message>
    <message>
        <source>How thick the padding around this foam is</source>
        <translation>Épaisseur de la garniture autour de cette mousse</translation>
    </message>
    <message>
        <source>How hard this foam presses the cover outwards; from about 2 on it gives no more</source>
        <translation>Force avec laquelle cette mousse pousse la housse vers l’extérieur&#x202f;; à partir de 2 environ, elle n’augmente plus</translation>
    </message>
    <message>
        <source>Takes this shape out of the cushion instead of adding it</source>
        <translation>Retire cette forme du rembourrage au lieu de l’ajouter</translation>
    </message>
    <message>
        <source>as made</source>
        <translation>d’origine</translation>
    </message>
    <message>
        <source>Stitching</source>
        <translation>Surpiqûre</translation>
    </message>
    <message>
        <source>Thread colour</source>
        <translation>Couleur du fil</translation>
    </message>
    <message>
        <source>Stitch distance</source>
        <translation>Distance des points</translation>
    </message>
    <message>
        <source>Piping radius</source>
        <translation>Rayon du passepoil</translation>
    </message>
    <message>
        <source>Piping fabric</source>
        <translation>Tissu du passepoil</translation>
    </message>
    <message>
        <source>Valley</source>
        <translation>Creux</translation>
    </message>
    <message>
        <source>Mitred – to a point</source>
        <translation>En onglet – pointu</translation>
    </message>
    <message>
        <source>Square – cut off</source>
        <translation>Droit – coupé</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>Arrondi</translation>
    </message>
    <message>
        <source>Folded – lies under the piece</source>
        <translation>Replié – sous la pièce</translation>
    </message>
    <message>
        <source>Stepped</source>
        <translation>À décrochement</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>From the sewing line to the line where the fabric is cut.</source>
        <translation>De la ligne de couture à la ligne où le tissu est coupé.</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Coins</translation>
    </message>
    <message>
        <source>Corners of the cut line</source>
        <translation>Coins de la ligne de coupe</translation>
    </message>
    <message>
        <source>as the design&apos;s</source>
        <translation>comme le modèle</translation>
    </message>
    <message>
        <source>Lies at</source>
        <translation>Placé à</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Coin</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diamètre</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>Fente</translation>
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
        <translation>Créneau</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>Cran</translation>
    </message>
    <message>
        <source>Depth of notches</source>
        <translation>Profondeur des crans</translation>
    </message>
    <message>
        <source>Width of notches</source>
        <translation>Largeur des crans</translation>
    </message>
    <message>
        <source>Notches along seams every</source>
        <translation>Crans le long des coutures tous les</translation>
    </message>
    <message>
        <source>Notches at ends of seams</source>
        <translation>Crans aux bouts des coutures</translation>
    </message>
    <message>
        <source>Notches that tell halves apart</source>
        <translation>Crans distinguant les moitiés</translation>
    </message>
    <message>
        <source>Two side by side</source>
        <translation>Deux côte à côte</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Label at</source>
        <translation>Étiquette à</translation>
    </message>
    <message>
        <source>Label turned by</source>
        <translation>Étiquette tournée de</translation>
    </message>
    <message>
        <source>Two ways – either end up</source>
        <translation>Double sens – les deux bouts en haut</translation>
    </message>
    <message>
        <source>One way – one end up</source>
        <translation>Sens unique – un seul bout en haut</translation>
    </message>
    <message>
        <source>Any direction</source>
        <translation>Tous les sens</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Quantité</translation>
    </message>
    <message>
        <source>Mirrored pair</source>
        <translation>Paire symétrique</translation>
    </message>
    <message>
        <source>Nap</source>
        <translation>Sens du poil</translation>
    </message>
    <message>
        <source>Grain may be off by</source>
        <translation>Écart admis au droit-fil</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Étiquette</translation>
    </message>
    <message>
        <source>where it finds room</source>
        <translation>où il y a de la place</translation>
    </message>
    <message>
        <source>Usable width</source>
        <translation>Laize utile</translation>
    </message>
    <message>
        <source>Shrinks along</source>
        <translation>Retrait en droit-fil</translation>
    </message>
    <message>
        <source>Pieces are cut so much larger along the grain that they have their size when the fabric has shrunk.</source>
        <translation>Les pièces sont coupées d’autant plus grandes en droit-fil, pour être à leur taille une fois le tissu rétréci.</translation>
    </message>
    <message>
        <source>Shrinks across</source>
        <translation>Retrait en travers</translation>
    </message>
    <message>
        <source>10 mm</source>
        <translation>10&#xa0;mm</translation>
    </message>
    <message>
        <source>Automatic notches</source>
        <translation>Crans automatiques</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Article</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>Dessinée</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Coupée</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Omise</translation>
    </message>
    <message>
        <source>On the cutting table</source>
        <translation>Sur la table de coupe</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>Top stitching</source>
        <translation>Surpiqûre</translation>
    </message>
    <message>
        <source>Tie-down strip</source>
        <translation>Bande de tirant</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Pli</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>Usage</translation>
    </message>
    <message>
        <source>Ease wanted</source>
        <translation>Embu voulu</translation>
    </message>
    <message>
        <source>How much longer the second side shall be than the first one: it is gathered when it is sewn.</source>
        <translation>De combien le second côté doit être plus long que le premier&#x202f;: il est résorbé à la couture.</translation>
    </message>
    <message>
        <source>Bulge of the allowance</source>
        <translation>Bourrelet de la marge</translation>
    </message>
    <message>
        <source>With a zip</source>
        <translation>Avec fermeture à glissière</translation>
    </message>
    <message>
        <source>A zip joins the two sides; the sewing sheet tells its length.</source>
        <translation>Une fermeture à glissière joint les deux côtés&#x202f;; la gamme de montage en donne la longueur.</translation>
    </message>
    <message>
        <source>Step in sewing</source>
        <translation>Étape de montage</translation>
    </message>
    <message>
        <source>Seams with a number are sewn first, smaller ones before larger ones. 0: as the program proposes it.</source>
        <translation>Les coutures numérotées sont cousues d’abord, les petits numéros avant les grands. 0&#x202f;: comme le propose le programme.</translation>
    </message>
    <message>
        <source>How near a point of the scan must be to pull at the cover. What the scan has not seen stays as the pattern makes it.</source>
        <translation>Distance à laquelle un point du scan tire sur la housse. Ce que le scan n’a pas vu reste tel que le patron le fait.</translation>
    </message>
    <message>
        <source>How firmly the scan pulls at the cover, against the pattern: more follows finer detail, and more of the noise.</source>
        <translation>Fermeté avec laquelle le scan tire sur la housse, contre le patron&#x202f;: plus, c’est plus de détails, et plus de bruit.</translation>
    </message>
    <message>
        <source>The cover is pulled to the scan. Without that it is only measured. Align the scan first.</source>
        <translation>La housse est tirée vers le scan. Sinon, il n’y a que la mesure. Alignez d’abord le scan.</translation>
    </message>
    <message>
        <source>To its surface: the cover may slide along it. To its points: it may not, which suits scans with few points.</source>
        <translation>Vers sa surface&#x202f;: la housse peut glisser dessus. Vers ses points&#x202f;: elle ne le peut pas, ce qui convient aux scans à peu de points.</translation>
    </message>
    <message>
        <source>For whoever works on the design: it changes neither the cover nor what is cut</source>
        <translation>Pour ceux qui travaillent sur le projet&#x202f;: ne change ni la housse ni ce qui est coupé</translation>
    </message>
    <message>
        <source>Line on the label</source>
        <translation>Ligne sur l’étiquette</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>A filling that presses from inside. 0.05 to 0.3 fills a cushion; at 1 most fabrics are stretched too far.</source>
        <translation>Un garnissage qui presse de l’intérieur. 0,05 à 0,3 remplit un coussin&#x202f;; à 1, la plupart des tissus sont trop étirés.</translation>
    </message>
    <message>
        <source>How long the edges of the triangles are: shorter ones show smaller folds, and take longer.</source>
        <translation>La longueur des arêtes des triangles&#x202f;: plus courtes, elles montrent des plis plus petits et demandent plus de temps.</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nouveau</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Fichiers &amp;récents</translation>
    </message>
    <message>
        <source>&amp;Unsaved work</source>
        <translation>Tra&amp;vail non enregistré</translation>
    </message>
    <message>
        <source>Sa&amp;mples</source>
        <translation>E&amp;xemples</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>Save a &amp;copy</source>
        <translation>Enregistrer une &amp;copie</translation>
    </message>
    <message>
        <source>With &amp;everything …</source>
        <translation>&amp;Avec tout…</translation>
    </message>
    <message>
        <source>Without &amp;history …</source>
        <translation>Sans &amp;historique…</translation>
    </message>
    <message>
        <source>Without history and &amp;scans …</source>
        <translation>Sans historique ni &amp;scans…</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>Revenir à la version enre&amp;gistrée</translation>
    </message>
    <message>
        <source>&amp;Import frame …</source>
        <translation>&amp;Importer une armature…</translation>
    </message>
    <message>
        <source>Impor&amp;t scan …</source>
        <translation>Im&amp;porter un scan…</translation>
    </message>
    <message>
        <source>&amp;Export surface …</source>
        <translation>Exporter la s&amp;urface…</translation>
    </message>
    <message>
        <source>Export &amp;picture …</source>
        <translation>Exporter une i&amp;mage…</translation>
    </message>
    <message>
        <source>Ren&amp;der picture …</source>
        <translation>Calculer un ren&amp;du…</translation>
    </message>
    <message>
        <source>E&amp;xport pattern …</source>
        <translation>Exporter le pa&amp;tron…</translation>
    </message>
    <message>
        <source>Import pattern (DX&amp;F, SVG) …</source>
        <translation>Importer un patron (DX&amp;F, SVG)…</translation>
    </message>
    <message>
        <source>Export cover (&amp;HTML, glTF, STL) …</source>
        <translation>Exporter la housse (&amp;HTML, glTF, STL)…</translation>
    </message>
    <message>
        <source>Export foam &amp;body …</source>
        <translation>Exporter &amp;le corps en mousse…</translation>
    </message>
    <message>
        <source>Print view …</source>
        <translation>Imprimer la vue…</translation>
    </message>
</context>
<context>
    <name>FileFormats</name>
    <message>
        <source>Page for the customer</source>
        <translation>Page pour le client</translation>
    </message>
    <message>
        <source>USDZ, for phones</source>
        <translation>USDZ, pour téléphones</translation>
    </message>
    <message>
        <source>OBJ with materials</source>
        <translation>OBJ avec matériaux</translation>
    </message>
    <message>
        <source>STL, with a thickness</source>
        <translation>STL, avec une épaisseur</translation>
    </message>
    <message>
        <source>3MF, with a thickness</source>
        <translation>3MF, avec une épaisseur</translation>
    </message>
    <message>
        <source>STEP, curves alone</source>
        <translation>STEP, courbes seules</translation>
    </message>
    <message>
        <source>STEP, of flat faces</source>
        <translation>STEP, en faces planes</translation>
    </message>
</context>
<context>
    <name>FixationCurveForm</name>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
</context>
<context>
    <name>FixationDrawTool</name>
    <message>
        <source>A curve needs two points, a closed one three.</source>
        <translation>Une courbe demande deux points, une courbe fermée trois.</translation>
    </message>
    <message>
        <source>Fixation %1</source>
        <translation>Fixation %1</translation>
    </message>
    <message>
        <source>Click to close the curve</source>
        <translation>Cliquez pour fermer la courbe</translation>
    </message>
    <message>
        <source>There is neither a frame nor the cover here: click on one, or type x, y, z.</source>
        <translation>Il n’y a ici ni armature ni housse&#x202f;: cliquez sur l’une d’elles, ou saisissez x, y, z.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no place: try 250, -100, 40</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas une position&#x202f;: essayez 250, -100, 40</translation>
    </message>
    <message>
        <source>Enter sets the point: x, y, z – without z it is as high as the last one</source>
        <translation>Entrée place le point&#x202f;: x, y, z – sans z, il est à la hauteur du dernier</translation>
    </message>
    <message>
        <source>Click on a frame to begin a fixation curve, or type x, y, z – drag turns the view, Esc ends the tool</source>
        <translation>Cliquez sur une armature pour commencer une courbe de fixation, ou saisissez x, y, z – glisser tourne la vue, Échap quitte l’outil</translation>
    </message>
    <message>
        <source>Click or type the next point, Enter ends, C closes – B makes it straight, Backspace takes a point back</source>
        <translation>Cliquez ou saisissez le point suivant, Entrée termine, C ferme – B rend droit, Retour arrière retire un point</translation>
    </message>
    <message>
        <source>Click or type the next point, Enter ends, C closes – straight from point to point, whatever lies between: B makes it smooth along the surface, Backspace takes a point back</source>
        <translation>Cliquez ou saisissez le point suivant, Entrée termine, C ferme – droit de point en point, quoi qu’il y ait entre eux&#x202f;: B rend lisse le long de la surface, Retour arrière retire un point</translation>
    </message>
    <message>
        <source>&amp;Close the curve</source>
        <translation>&amp;Fermer la courbe</translation>
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
        <translation>Courbe</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>On the curve</source>
        <translation>Sur la courbe</translation>
    </message>
</context>
<context>
    <name>FixationsLeft</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>et %n autre</numerusform>
            <numerusform>et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>They stay where they are. Drag their points onto the frame, or undo the change.</source>
        <translation>Elles restent où elles sont. Faites glisser leurs points sur l’armature, ou annulez la modification.</translation>
    </message>
    <message numerus="yes">
        <source>%n fixation curve(s) no longer lie on the frame.</source>
        <translation>
            <numerusform>%n courbe de fixation n’est plus sur l’armature.</numerusform>
            <numerusform>%n courbes de fixation ne sont plus sur l’armature.</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1”: its edge is up to %2 away</source>
        <translation>«&#x202f;%1&#x202f;»&#x202f;: son bord est éloigné jusqu’à %2</translation>
    </message>
    <message>
        <source>“%1”: up to %2</source>
        <translation>«&#x202f;%1&#x202f;»&#x202f;: jusqu’à %2</translation>
    </message>
    <message>
        <source>“%1”: more than %2</source>
        <translation>«&#x202f;%1&#x202f;»&#x202f;: plus de %2</translation>
    </message>
</context>
<context>
    <name>FixingCommands</name>
    <message>
        <source>&amp;Create fixation curve</source>
        <translation>&amp;Créer une courbe de fixation</translation>
    </message>
    <message>
        <source>Select two points of an outline first: what lies between them is fixed.</source>
        <translation>Sélectionnez d’abord deux points d’un contour&#x202f;: ce qui est entre eux est fixé.</translation>
    </message>
    <message>
        <source>Fixation %1</source>
        <translation>Fixation %1</translation>
    </message>
    <message>
        <source>There is no surface of this patch yet on which the curve could lie.</source>
        <translation>Cette pièce n’a pas encore de surface sur laquelle la courbe pourrait être.</translation>
    </message>
</context>
<context>
    <name>FoamForm</name>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
</context>
<context>
    <name>FormPatternReport</name>
    <message numerus="yes">
        <source>(and %n more)</source>
        <translation>
            <numerusform>(et %n autre)</numerusform>
            <numerusform>(et %n autres)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n pièce</numerusform>
            <numerusform>%n pièces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seams, whose sides are equally long</source>
        <translation>
            <numerusform>%n couture, dont les côtés sont de même longueur</numerusform>
            <numerusform>%n coutures, dont les côtés sont de même longueur</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seams, whose sides differ by %1 at most</source>
        <translation>
            <numerusform>%n couture, dont les côtés diffèrent d’au plus %1</numerusform>
            <numerusform>%n coutures, dont les côtés diffèrent d’au plus %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Its cover at rest lies up to %1 beside the form, where nothing holds it: tick &quot;Keeps the cover outside&quot; at the frame, or hold it by a fixation.</source>
        <translation>Sa housse au repos s’écarte de la forme jusqu’à %1, là où rien ne la tient&#x202f;: cochez «&#x202f;Garde la housse dehors&#x202f;» pour l’armature, ou tenez-la par une fixation.</translation>
    </message>
    <message>
        <source>Its cover at rest lies up to %1 beside the form, where nothing holds it: hold it by a fixation, or give its pieces pressure.</source>
        <translation>Sa housse au repos s’écarte de la forme jusqu’à %1, là où rien ne la tient&#x202f;: tenez-la par une fixation, ou donnez de la pression à ses pièces.</translation>
    </message>
    <message>
        <source>Its cover is being solved …</source>
        <translation>Sa housse est calculée …</translation>
    </message>
    <message>
        <source>Its cover does not come to rest.</source>
        <translation>Sa housse ne trouve pas le repos.</translation>
    </message>
    <message>
        <source>Its cover at rest is strained no more than the fabric may be.</source>
        <translation>Sa housse au repos n’est pas plus étirée que le tissu ne peut l’être.</translation>
    </message>
    <message>
        <source>What counts is its cover at rest: %1</source>
        <translation>Ce qui compte est sa housse au repos : %1</translation>
    </message>
    <message>
        <source>Laid on the form by itself no piece is strained so much. Narrow tips and steps of a line do that, or mesh edges that are long for them.</source>
        <translation>Posée seule sur la forme, aucune pièce n’est aussi déformée. Cela vient de pointes étroites et de marches d’une ligne, ou d’arêtes du maillage longues pour elles.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more are left out, too</source>
        <translation>
            <numerusform>et %n de plus est omise</numerusform>
            <numerusform>et %n de plus sont omises</numerusform>
        </translation>
    </message>
    <message>
        <source>Laid on the form by itself most strained: %1, %2 (rms), %3 within 99 % of its area, %4 where it is most</source>
        <translation>Posée seule sur la forme, la plus déformée : %1, %2 (RMS), %3 sur 99 % de sa surface, %4 au plus fort</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces are strained by more than the fabric may be in more than a hundredth of their area (yellow): divide them, or cut them in there.</source>
        <translation>
            <numerusform>%n pièce est, sur plus d’un centième de sa surface, plus déformée que le tissu ne l’admet (jaune)&#x202f;: divisez-la, ou entaillez-la là.</numerusform>
            <numerusform>%n pièces sont, sur plus d’un centième de leur surface, plus déformées que le tissu ne l’admet (jaune)&#x202f;: divisez-les, ou entaillez-les là.</numerusform>
        </translation>
    </message>
    <message>
        <source>Its cover will have about %1 vertices, and is not solved here: with mesh edges of %2 it is.</source>
        <translation>Sa housse aura environ %1 sommets et n’est pas calculée ici&#x202f;: avec des arêtes du maillage de %2, elle l’est.</translation>
    </message>
    <message>
        <source>So that the cover does not sink into the frame, tick &quot;Keeps the cover outside&quot; at the frame.</source>
        <translation>Pour que la housse ne s’enfonce pas dans l’armature, cochez «&#x202f;Garde la housse dehors&#x202f;» pour l’armature.</translation>
    </message>
    <message>
        <source>With shorter mesh edges smaller pieces are divided, too.</source>
        <translation>Avec des arêtes de maillage plus courtes, des pièces plus petites sont divisées aussi.</translation>
    </message>
    <message>
        <source>Tick &quot;where it would not lie flat&quot;: that finds where to divide them.</source>
        <translation>Cochez « là où elle ne serait pas à plat » : cela trouve où les diviser.</translation>
    </message>
    <message>
        <source>The form is taken as %1 large. If that is wrong, import the file as a frame.</source>
        <translation>La forme est prise avec une taille de %1. Si c’est faux, importez le fichier comme armature.</translation>
    </message>
</context>
<context>
    <name>FrameEdgeCommands</name>
    <message>
        <source>Fixation curve along an &amp;edge</source>
        <translation>Courbe de fixation le long d’une &amp;arête</translation>
    </message>
    <message>
        <source>Click an edge of a frame: of STEP and IGES the edges of its faces, exactly; of others where their triangles bend</source>
        <translation>Cliquez sur une arête d’une armature&#x202f;: pour STEP et IGES, les arêtes exactes de ses faces&#x202f;; pour les autres, là où leurs triangles se plient</translation>
    </message>
    <message>
        <source>Looking for the edges of the frames …</source>
        <translation>Recherche des arêtes des armatures…</translation>
    </message>
    <message>
        <source>The frames have no edges: they are smooth everywhere, or are not read yet.</source>
        <translation>Les armatures n’ont pas d’arêtes&#x202f;: elles sont lisses partout, ou pas encore lues.</translation>
    </message>
</context>
<context>
    <name>FrameEdgeTool</name>
    <message>
        <source>Fixation %1</source>
        <translation>Fixation %1</translation>
    </message>
    <message>
        <source>Click an edge of a frame to make a fixation curve of it – drag turns the view, Esc ends the tool</source>
        <translation>Cliquez sur une arête d’une armature pour en faire une courbe de fixation – glisser tourne la vue, Échap quitte l’outil</translation>
    </message>
    <message>
        <source>Click to make a fixation curve of this edge – Ctrl takes it alone, without those in which it goes on smoothly</source>
        <translation>Cliquez pour faire de cette arête une courbe de fixation – Ctrl la prend seule, sans celles qui la prolongent en douceur</translation>
    </message>
    <message>
        <source>There is no edge of a frame here. A curve of your own: Frame &gt; Draw fixation curve.</source>
        <translation>Il n’y a pas d’arête d’armature ici. Une courbe à vous&#x202f;: Armature &gt; Dessiner une courbe de fixation.</translation>
    </message>
</context>
<context>
    <name>FrameForm</name>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Choose an&amp;other file …</source>
        <translation>Choisir un a&amp;utre fichier…</translation>
    </message>
    <message>
        <source>Colour of the frame</source>
        <translation>Couleur de l’armature</translation>
    </message>
</context>
<context>
    <name>FrameParts</name>
    <message>
        <source>Mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>Piece %1: %2</source>
        <translation>Morceau %1&#x202f;: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n piece(s)</source>
        <translation>
            <numerusform>%1&#x202f;: %n morceau</numerusform>
            <numerusform>%1&#x202f;: %n morceaux</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Parties</translation>
    </message>
    <message>
        <source>Show a&amp;ll parts</source>
        <translation>Afficher &amp;toutes les parties</translation>
    </message>
    <message>
        <source>Parts without a mark are left out: they are not drawn, and neither drawing along the frame nor cushioning nor contact knows them.</source>
        <translation>Les parties non cochées sont ignorées&#x202f;: elles ne sont pas dessinées, et ni le dessin sur l’armature, ni le rembourrage, ni le contact n’en tiennent compte.</translation>
    </message>
    <message>
        <source>%1: not in this frame</source>
        <translation>%1&#x202f;: absente de cette armature</translation>
    </message>
    <message>
        <source>Padded parts</source>
        <translation>Parties garnies</translation>
    </message>
    <message>
        <source>Without a mark, those parts are padded that the cover is fixed to.</source>
        <translation>Sans coche, les parties garnies sont celles où la housse est fixée.</translation>
    </message>
    <message>
        <source>This frame is large: the smallest detail can be %1 here.</source>
        <translation>Cette armature est grande&#x202f;: le plus petit détail peut être de %1 ici.</translation>
    </message>
</context>
<context>
    <name>HandleCurveForm</name>
    <message>
        <source>Patch</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>Dans le patron</translation>
    </message>
    <message>
        <source>In space</source>
        <translation>Dans l’espace</translation>
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
        <translation>&amp;Rechercher une commande…</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse …</source>
        <translation>&amp;Touches et souris…</translation>
    </message>
    <message>
        <source>&amp;Edit shortcuts …</source>
        <translation>&amp;Modifier les raccourcis…</translation>
    </message>
    <message>
        <source>&amp;About Bolster</source>
        <translation>À &amp;propos de Bolster</translation>
    </message>
</context>
<context>
    <name>HelpDialogs</name>
    <message>
        <source>Select</source>
        <translation>Sélectionner</translation>
    </message>
    <message>
        <source>click; Shift+click adds; drag a box</source>
        <translation>clic&#x202f;; Maj+clic ajoute&#x202f;; tracer un cadre</translation>
    </message>
    <message>
        <source>Move control points or patches</source>
        <translation>Déplacer des points de contrôle ou des pièces</translation>
    </message>
    <message>
        <source>drag; Shift keeps to one axis; Esc takes it back</source>
        <translation>glisser&#x202f;; Maj limite à un axe&#x202f;; Échap annule</translation>
    </message>
    <message>
        <source>Turn patches</source>
        <translation>Tourner des pièces</translation>
    </message>
    <message>
        <source>drag the round handle; Shift in steps of 15°</source>
        <translation>glisser la poignée ronde&#x202f;; Maj par pas de 15°</translation>
    </message>
    <message>
        <source>Add a control point</source>
        <translation>Ajouter un point de contrôle</translation>
    </message>
    <message>
        <source>arrow keys, Shift+arrow keys</source>
        <translation>touches fléchées, Maj+touches fléchées</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Déplacer la vue</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomer</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Tourner</translation>
    </message>
    <message>
        <source>A workbench for people who design upholstered furniture and car seats: a sewing pattern, its seams and its fixation on the frame become the cover, live.</source>
        <translation>Un atelier pour ceux qui conçoivent des meubles rembourrés et des sièges auto&#x202f;: un patron, ses coutures et sa fixation sur l’armature deviennent la housse, en direct.</translation>
    </message>
    <message>
        <source>The surface is computed after the published method of sewing patterns on static constraints; docs/solver.md names the paper and what is different.</source>
        <translation>La surface est calculée selon la méthode publiée des patrons sous contraintes statiques&#x202f;; docs/solver.md cite l’article et ce qui diffère.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. It comes without any warranty. Built with Qt, Eigen, CGAL, SuiteSparse, Embree and OpenImageIO.</source>
        <translation>Logiciel libre sous licence GNU General Public License, version 3 ou ultérieure. Sans aucune garantie. Construit avec Qt, Eigen, CGAL, SuiteSparse, Embree et OpenImageIO.</translation>
    </message>
    <message>
        <source>About Bolster</source>
        <translation>À propos de Bolster</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>Dans le patron</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>Dans la vue 3D</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Touches et souris</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1&#xa0;ms</translation>
    </message>
    <message>
        <source>Patches, seams</source>
        <translation>Pièces, coutures</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Vertices after sewing</source>
        <translation>Sommets après couture</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
    <message>
        <source>Vertices held by fixations</source>
        <translation>Sommets tenus par des fixations</translation>
    </message>
    <message>
        <source>Sewn pairs</source>
        <translation>Paires cousues</translation>
    </message>
    <message>
        <source>Largest gap at seams</source>
        <translation>Plus grand jour aux coutures</translation>
    </message>
    <message>
        <source>Largest distance from fixations</source>
        <translation>Plus grande distance aux fixations</translation>
    </message>
    <message>
        <source>Curves to fixed outlines between vertices</source>
        <translation>Des courbes aux contours fixés, entre sommets</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>Area of the cover, of the pattern</source>
        <translation>Aire de la housse, du patron</translation>
    </message>
    <message>
        <source>Turned triangles</source>
        <translation>Triangles retournés</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Itérations</translation>
    </message>
    <message>
        <source>Triangulation</source>
        <translation>Triangulation</translation>
    </message>
    <message>
        <source>Assembly and factorisation</source>
        <translation>Assemblage et factorisation</translation>
    </message>
    <message>
        <source>One iteration</source>
        <translation>Une itération</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Computation</source>
        <translation>Calcul</translation>
    </message>
    <message>
        <source>Figures of the surface</source>
        <translation>Chiffres de la surface</translation>
    </message>
    <message>
        <source>Strain: root mean square, 99 %, largest</source>
        <translation>Déformation&#x202f;: moyenne quadratique, 99&#x202f;%, maximum</translation>
    </message>
    <message>
        <source>double click on an outline or curve</source>
        <translation>double-clic sur un contour ou une courbe</translation>
    </message>
    <message>
        <source>Draw a handle curve or a fancy seam</source>
        <translation>Dessiner une courbe de maintien ou une couture décorative</translation>
    </message>
    <message>
        <source>click points; Enter or double click ends; click the first one to close; B: straight or smooth</source>
        <translation>cliquer des points&#x202f;; Entrée ou double-clic termine&#x202f;; clic sur le premier pour fermer&#x202f;; B&#x202f;: droit ou lisse</translation>
    </message>
    <message>
        <source>Move control points of curves</source>
        <translation>Déplacer des points de contrôle de courbes</translation>
    </message>
    <message>
        <source>Sew</source>
        <translation>Coudre</translation>
    </message>
    <message>
        <source>click two edges; drag or Shift+click takes a part of one; Ctrl+click several in a row, Enter sews them; F: flip</source>
        <translation>cliquer deux bords&#x202f;; glisser ou Maj+clic n’en prend qu’une partie&#x202f;; Ctrl+clic plusieurs à la suite, Entrée les coud&#x202f;; F&#x202f;: inverser</translation>
    </message>
    <message>
        <source>Attach to the selected fixation curve</source>
        <translation>Fixer à la courbe de fixation sélectionnée</translation>
    </message>
    <message>
        <source>Draw an outline</source>
        <translation>Dessiner un contour</translation>
    </message>
    <message>
        <source>click corners, drag smooth points, or type 500, 500&lt;30 or 120, 40; Enter or a click on the first point closes</source>
        <translation>cliquer les coins, glisser les points lisses, ou saisir 500, 500&lt;30 ou 120, 40&#x202f;; Entrée ou un clic sur le premier point ferme</translation>
    </message>
    <message>
        <source>Not snapped</source>
        <translation>Sans accrochage</translation>
    </message>
    <message>
        <source>hold Ctrl or Alt</source>
        <translation>maintenir Ctrl ou Alt</translation>
    </message>
    <message>
        <source>Select in a loop</source>
        <translation>Sélectionner au lasso</translation>
    </message>
    <message>
        <source>Alt and drag</source>
        <translation>Alt et glisser</translation>
    </message>
    <message>
        <source>Next patch or control point, previous one</source>
        <translation>Pièce ou point de contrôle suivant, précédent</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Maj+Tab</translation>
    </message>
    <message>
        <source>drag; those on a frame stay on it: Ctrl lifts them off, S lets go; X, Y, Z keep to an axis</source>
        <translation>glisser&#x202f;; ceux d’une armature y restent&#x202f;: Ctrl les soulève, S les détache&#x202f;; X, Y, Z limitent à un axe</translation>
    </message>
    <message>
        <source>Draw a fixation curve</source>
        <translation>Dessiner une courbe de fixation</translation>
    </message>
    <message>
        <source>click points on a frame; Enter or double click ends; click the first one to close</source>
        <translation>cliquer des points sur une armature&#x202f;; Entrée ou double-clic termine&#x202f;; clic sur le premier pour fermer</translation>
    </message>
    <message>
        <source>Move the ends of a seam or fixation</source>
        <translation>Déplacer les bouts d’une couture ou d’une fixation</translation>
    </message>
    <message>
        <source>select it and drag the round handles at its ends</source>
        <translation>la sélectionner et glisser les poignées rondes à ses bouts</translation>
    </message>
    <message>
        <source>Stitch or pipe a seam or an edge</source>
        <translation>Surpiquer ou passepoiler une couture ou un bord</translation>
    </message>
    <message>
        <source>click it; stitches and piping are in the properties</source>
        <translation>cliquer dessus&#x202f;; points et passepoil sont dans les propriétés</translation>
    </message>
    <message>
        <source>Select an edge</source>
        <translation>Sélectionner un bord</translation>
    </message>
    <message>
        <source>click the outline; drag it then to move it; L types its length</source>
        <translation>cliquer sur le contour&#x202f;; glisser ensuite pour le déplacer&#x202f;; L saisit sa longueur</translation>
    </message>
    <message>
        <source>Commands for what lies there</source>
        <translation>Commandes pour ce qui se trouve là</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>bouton droit</translation>
    </message>
    <message>
        <source>A number instead of a drag</source>
        <translation>Un nombre au lieu d’un glissement</translation>
    </message>
    <message>
        <source>type it while dragging: 50, 30, 20, for sizes 300 x 200 or 120 %; Enter lets go</source>
        <translation>le saisir en glissant&#x202f;: 50, 30, 20, pour les tailles 300 x 200 ou 120&#x202f;%&#x202f;; Entrée relâche</translation>
    </message>
    <message>
        <source>click edges; Shift+click collects several; Esc ends</source>
        <translation>cliquer sur des bords&#x202f;; Maj+clic en réunit plusieurs&#x202f;; Échap termine</translation>
    </message>
    <message>
        <source>right button, without a drag</source>
        <translation>bouton droit, sans glisser</translation>
    </message>
    <message>
        <source>Move by %1, by %2</source>
        <translation>Déplacer de %1, de %2</translation>
    </message>
    <message>
        <source>%1, or Space and drag</source>
        <translation>%1, ou Espace et glisser</translation>
    </message>
    <message>
        <source>%1, or drag beside the cover</source>
        <translation>%1, ou glisser à côté de la housse</translation>
    </message>
</context>
<context>
    <name>Insert</name>
    <message>
        <source>Padding</source>
        <translation>Garniture</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>Mousse</translation>
    </message>
    <message>
        <source>This frame is large: its smallest detail is set to %1; the usual %2 would need too much memory.</source>
        <translation>Cette armature est grande&#x202f;: son plus petit détail est mis à %1&#x202f;; les %2 habituels demanderaient trop de mémoire.</translation>
    </message>
</context>
<context>
    <name>InsertCommands</name>
    <message>
        <source>&amp;Cushion</source>
        <translation>&amp;Rembourrage</translation>
    </message>
    <message>
        <source>&amp;Box of foam</source>
        <translation>&amp;Pavé de mousse</translation>
    </message>
    <message>
        <source>C&amp;ylinder of foam</source>
        <translation>C&amp;ylindre de mousse</translation>
    </message>
    <message>
        <source>&amp;Sphere of foam</source>
        <translation>&amp;Sphère de mousse</translation>
    </message>
    <message>
        <source>Foam belongs to a cushion: insert one first.</source>
        <translation>La mousse appartient à un rembourrage&#x202f;: insérez-en d’abord un.</translation>
    </message>
    <message>
        <source>Cushioning needs a frame: import one first.</source>
        <translation>Un rembourrage demande une armature&#x202f;: importez-en d’abord une.</translation>
    </message>
</context>
<context>
    <name>InspectorForms</name>
    <message numerus="yes">
        <source>%n elements</source>
        <translation>
            <numerusform>%n élément</numerusform>
            <numerusform>%n éléments</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>InternalLineForm</name>
    <message>
        <source>Patch</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
</context>
<context>
    <name>InverseCommands</name>
    <message>
        <source>From a form …</source>
        <translation>D’après une forme…</translation>
    </message>
    <message>
        <source>Cuts a frame, a mesh or the cover into pieces, lays them flat and makes the pattern of them</source>
        <translation>Découpe une armature, un maillage ou la housse en morceaux, les met à plat et en fait le patron</translation>
    </message>
    <message>
        <source>F&amp;it to a goal …</source>
        <translation>Aj&amp;uster à un objectif…</translation>
    </message>
    <message>
        <source>Changes the pattern until the cover lies on a scan, or is strained less</source>
        <translation>Modifie le patron jusqu’à ce que la housse repose sur un scan, ou soit moins déformée</translation>
    </message>
    <message>
        <source>Relieve strain …</source>
        <translation>Détendre le tissu…</translation>
    </message>
    <message>
        <source>Proposes changes of the pattern where cloth is strained too much, with what each gains</source>
        <translation>Propose des modifications du patron là où le tissu est trop déformé, avec ce que chacune apporte</translation>
    </message>
    <message>
        <source>Why is it so? …</source>
        <translation>D’où vient l’écart&#x202f;?…</translation>
    </message>
    <message>
        <source>Which cause explains best how far the scan of a built piece lies from the cover</source>
        <translation>Quelle cause explique le mieux l’écart entre le scan d’un exemplaire fabriqué et la housse</translation>
    </message>
    <message>
        <source>Tolerances …</source>
        <translation>Tolérances…</translation>
    </message>
    <message>
        <source>Where the cover varies from piece to piece, and which tolerance of making matters</source>
        <translation>Où la housse varie d’un exemplaire à l’autre, et quelle tolérance de fabrication compte</translation>
    </message>
</context>
<context>
    <name>KeptMeasure</name>
    <message>
        <source>Measurement %1</source>
        <translation>Mesure %1</translation>
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
        <translation>Faites glisser l’étiquette là où on peut la lire – Maj limite à un axe, Ctrl désactive l’accrochage, Échap annule</translation>
    </message>
</context>
<context>
    <name>LayerCommands</name>
    <message>
        <source>La&amp;yers</source>
        <translation>&amp;Calques</translation>
    </message>
    <message>
        <source>&amp;Triangulation</source>
        <translation>&amp;Triangulation</translation>
    </message>
    <message>
        <source>Chec&amp;ker</source>
        <translation>&amp;Damier</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>&amp;Armature</translation>
    </message>
    <message>
        <source>Control po&amp;ints</source>
        <translation>&amp;Points de contrôle</translation>
    </message>
    <message>
        <source>Sea&amp;ms and fixations</source>
        <translation>Coutures et &amp;fixations</translation>
    </message>
    <message>
        <source>Fixation c&amp;urves</source>
        <translation>Co&amp;urbes de fixation</translation>
    </message>
    <message>
        <source>&amp;Handle curves</source>
        <translation>Courbes de &amp;maintien</translation>
    </message>
    <message>
        <source>Fanc&amp;y seams</source>
        <translation>Coutures déc&amp;oratives</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>Éti&amp;quettes</translation>
    </message>
    <message>
        <source>Sca&amp;ns</source>
        <translation>Sca&amp;ns</translation>
    </message>
    <message>
        <source>Gr&amp;ound</source>
        <translation>&amp;Sol</translation>
    </message>
    <message>
        <source>Cushionin&amp;g</source>
        <translation>&amp;Rembourrage</translation>
    </message>
    <message>
        <source>Mirror image of the &amp;selection</source>
        <translation>Image miroir de la sé&amp;lection</translation>
    </message>
    <message>
        <source>Symmetry &amp;axis and plane</source>
        <translation>Axe et plan de s&amp;ymétrie</translation>
    </message>
    <message>
        <source>Pairs of co&amp;ver and scan</source>
        <translation>Paires &amp;housse-scan</translation>
    </message>
    <message>
        <source>Own &amp;colours of scans</source>
        <translation>Couleurs propr&amp;es des scans</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Grille</translation>
    </message>
    <message>
        <source>Cut lines, notches and la&amp;bels</source>
        <translation>Lignes de coupe, crans et ét&amp;iquettes</translation>
    </message>
    <message>
        <source>M&amp;easurements</source>
        <translation>M&amp;esures</translation>
    </message>
</context>
<context>
    <name>MainMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aide</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>Affic&amp;hage</translation>
    </message>
    <message>
        <source>&amp;Pattern</source>
        <translation>&amp;Patron</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>&amp;Surface</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>F&amp;enêtre</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>&amp;Insertion</translation>
    </message>
    <message>
        <source>Sea&amp;m</source>
        <translation>&amp;Couture</translation>
    </message>
    <message>
        <source>F&amp;rame</source>
        <translation>A&amp;rmature</translation>
    </message>
    <message>
        <source>F&amp;abric</source>
        <translation>&amp;Tissu</translation>
    </message>
    <message>
        <source>S&amp;can</source>
        <translation>Sca&amp;n</translation>
    </message>
</context>
<context>
    <name>ManualCommands</name>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>The page about what you are at</source>
        <translation>La page sur ce que vous faites</translation>
    </message>
    <message>
        <source>The manual is not installed.</source>
        <translation>Le manuel n’est pas installé.</translation>
    </message>
    <message>
        <source>It is a folder &quot;manual&quot; with the program&apos;s other files.</source>
        <translation>C’est un dossier « manual » avec les autres fichiers du programme.</translation>
    </message>
</context>
<context>
    <name>MapCommands</name>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Carte</translation>
    </message>
    <message>
        <source>&amp;Largest strain</source>
        <translation>&amp;Déformation maximale</translation>
    </message>
    <message>
        <source>Strain al&amp;ong the grain</source>
        <translation>Déformation en dr&amp;oit-fil</translation>
    </message>
    <message>
        <source>Strain a&amp;cross the grain</source>
        <translation>Déformation en &amp;travers</translation>
    </message>
    <message>
        <source>&amp;Shear</source>
        <translation>&amp;Cisaillement</translation>
    </message>
    <message>
        <source>&amp;Mean curvature</source>
        <translation>Courbure &amp;moyenne</translation>
    </message>
    <message>
        <source>Distance to the &amp;frame</source>
        <translation>Distance à l’&amp;armature</translation>
    </message>
    <message>
        <source>&amp;Deviation from the scan</source>
        <translation>Écart au &amp;scan</translation>
    </message>
    <message>
        <source>&amp;Worst spots</source>
        <translation>&amp;Zones critiques</translation>
    </message>
    <message>
        <source>Show worst spots as a l&amp;ist</source>
        <translation>&amp;Liste des zones critiques</translation>
    </message>
    <message>
        <source>Show this place in both windows</source>
        <translation>Montrer cet endroit dans les deux fenêtres</translation>
    </message>
    <message>
        <source>Choose a map of strain first</source>
        <translation>Choisissez d’abord une carte de déformation</translation>
    </message>
</context>
<context>
    <name>MarkDrag</name>
    <message>
        <source>Drag it to where it belongs – Esc takes it back</source>
        <translation>Faites glisser à sa place – Échap annule</translation>
    </message>
    <message>
        <source>Allowance of %1 – or type it; Ctrl for any width, Esc takes it back</source>
        <translation>Marge de %1 – ou saisissez-la&#x202f;; Ctrl pour une largeur quelconque, Échap annule</translation>
    </message>
    <message>
        <source>Drag it to where it belongs, or type its place: 120, 40 – Esc takes it back</source>
        <translation>Faites glisser à sa place, ou saisissez la position&#x202f;: 120, 40 – Échap annule</translation>
    </message>
    <message>
        <source>Drag it along the outline, or type how far it is from the corner – Esc takes it back</source>
        <translation>Faites glisser le long du contour, ou saisissez la distance au coin – Échap annule</translation>
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
        <translation>Ce bord mesure %1 – cliquez pour mesurer à partir d’un point</translation>
    </message>
    <message>
        <source>Edge: %1</source>
        <translation>Bord&#x202f;: %1</translation>
    </message>
    <message>
        <source>Only a measurement between two points of patches can be kept.</source>
        <translation>Seule une mesure entre deux points de pièces peut être gardée.</translation>
    </message>
    <message>
        <source>&amp;Keep the measurement</source>
        <translation>&amp;Garder la mesure</translation>
    </message>
    <message>
        <source>%1 – Enter keeps the measurement, a click begins anew</source>
        <translation>%1 – Entrée garde la mesure, un clic recommence</translation>
    </message>
    <message>
        <source>Click two points of the pattern or of the cover to measure, or point at an outline – Esc ends the tool</source>
        <translation>Cliquez deux points du patron ou de la housse pour mesurer, ou pointez un contour – Échap quitte l’outil</translation>
    </message>
    <message>
        <source>%1 – a click begins anew</source>
        <translation>%1 – un clic recommence</translation>
    </message>
</context>
<context>
    <name>MeasurementForm</name>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>Dans le patron</translation>
    </message>
    <message>
        <source>two patches</source>
        <translation>deux pièces</translation>
    </message>
    <message>
        <source>On the cover</source>
        <translation>Sur la housse</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>pas encore</translation>
    </message>
</context>
<context>
    <name>Message</name>
    <message>
        <source>the degree must be 1, 2 or 3, not %1</source>
        <translation>le degré doit être 1, 2 ou 3, pas %1</translation>
    </message>
    <message>
        <source>a closed curve needs at least %1 points, not %2</source>
        <translation>une courbe fermée demande au moins %1 points, pas %2</translation>
    </message>
    <message>
        <source>an open curve of this degree needs at least %1 points, not %2</source>
        <translation>une courbe ouverte de ce degré demande au moins %1 points, pas %2</translation>
    </message>
    <message>
        <source>point %1 is no number or beyond 1e7 mm</source>
        <translation>le point %1 n’est pas un nombre ou dépasse 1e7&#xa0;mm</translation>
    </message>
    <message>
        <source>corners belong to closed curves of degree 3 only</source>
        <translation>seules les courbes fermées de degré 3 ont des coins</translation>
    </message>
    <message>
        <source>the list of corners is empty; leave it out</source>
        <translation>la liste des coins est vide&#x202f;; omettez-la</translation>
    </message>
    <message>
        <source>corner %1 does not exist; the points are numbered 0 to %2</source>
        <translation>le coin %1 n’existe pas&#x202f;; les points sont numérotés de 0 à %2</translation>
    </message>
    <message>
        <source>the corners must increase, but %1 follows %2</source>
        <translation>les coins doivent être croissants, mais %1 suit %2</translation>
    </message>
    <message>
        <source>there must be at least two points between the corners %1 and %2 (a straight edge: at its thirds)</source>
        <translation>il doit y avoir au moins deux points entre les coins %1 et %2 (bord droit&#x202f;: à ses tiers)</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text goes on after the design&apos;s last bracket; remove what follows</source>
        <translation>Ligne %1, colonne %2&#x202f;: le texte continue après le dernier crochet du modèle&#x202f;; supprimez ce qui suit</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text ends in the middle of the design; the file is incomplete</source>
        <translation>Ligne %1, colonne %2&#x202f;: le texte finit au milieu du modèle&#x202f;; le fichier est incomplet</translation>
    </message>
    <message>
        <source>Line %1, column %2: brackets are nested more than 64 deep; no design needs that</source>
        <translation>Ligne %1, colonne %2&#x202f;: les crochets sont imbriqués sur plus de 64 niveaux&#x202f;; aucun modèle n’en a besoin</translation>
    </message>
    <message>
        <source>Line %1, column %2: a value is expected here: a number, a text in quotes, true, false or a bracket (NaN and Infinity are no numbers)</source>
        <translation>Ligne %1, colonne %2&#x202f;: une valeur est attendue ici&#x202f;: un nombre, un texte entre guillemets, true, false ou un crochet (NaN et Infinity ne sont pas des nombres)</translation>
    </message>
    <message>
        <source>Line %1, column %2: a comma or &quot;]&quot; is missing here</source>
        <translation>Ligne %1, colonne %2&#x202f;: il manque ici une virgule ou «&#x202f;]&#x202f;»</translation>
    </message>
    <message>
        <source>Line %1, column %2: a key in quotes is expected here</source>
        <translation>Ligne %1, colonne %2&#x202f;: une clé entre guillemets est attendue ici</translation>
    </message>
    <message>
        <source>Line %1, column %2: a colon is missing after the key</source>
        <translation>Ligne %1, colonne %2&#x202f;: il manque deux-points après la clé</translation>
    </message>
    <message>
        <source>Line %1, column %2: a comma or &quot;}&quot; is missing here</source>
        <translation>Ligne %1, colonne %2&#x202f;: il manque ici une virgule ou «&#x202f;}&#x202f;»</translation>
    </message>
    <message>
        <source>Line %1, column %2: a text in quotes must end on its line; a quote is missing</source>
        <translation>Ligne %1, colonne %2&#x202f;: un texte entre guillemets doit finir sur sa ligne&#x202f;; il manque un guillemet</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is no valid escape; write a backslash as &quot;\\&quot;</source>
        <translation>Ligne %1, colonne %2&#x202f;: séquence d’échappement non valide&#x202f;; écrivez une barre oblique inverse comme «&#x202f;\\&#x202f;»</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is not UTF-8; save the file in that encoding</source>
        <translation>Ligne %1, colonne %2&#x202f;: ce n’est pas de l’UTF-8&#x202f;; enregistrez le fichier dans ce codage</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text ends inside quotes; the file is incomplete</source>
        <translation>Ligne %1, colonne %2&#x202f;: le texte finit entre guillemets&#x202f;; le fichier est incomplet</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is no number; write it like 12.5, -3 or 1e-3</source>
        <translation>Ligne %1, colonne %2&#x202f;: ce n’est pas un nombre&#x202f;; écrivez-le comme 12.5, -3 ou 1e-3</translation>
    </message>
    <message>
        <source>the text is larger than %1 MB; that is no design</source>
        <translation>le texte dépasse %1&#xa0;Mo&#x202f;; ce n’est pas un modèle</translation>
    </message>
    <message>
        <source>knot %1 occurs more often than %2 times, the degree; remove the surplus ones</source>
        <translation>le nœud %1 apparaît plus de %2 fois (le degré)&#x202f;; supprimez ceux en trop</translation>
    </message>
    <message>
        <source>the knots of an open curve must begin with %1 equal ones and end with %1 equal, larger ones</source>
        <translation>les nœuds d’une courbe ouverte doivent commencer par %1 égaux et finir par %1 égaux et plus grands</translation>
    </message>
    <message>
        <source>%1 points of degree %2 need %3 knots, not %4</source>
        <translation>%1 points de degré %2 demandent %3 nœuds, pas %4</translation>
    </message>
    <message>
        <source>a knot is no number or beyond 1e7</source>
        <translation>un nœud n’est pas un nombre ou dépasse 1e7</translation>
    </message>
    <message>
        <source>the knots must not decrease</source>
        <translation>les nœuds ne doivent pas décroître</translation>
    </message>
    <message>
        <source>the last knot must be larger than the first</source>
        <translation>le dernier nœud doit être plus grand que le premier</translation>
    </message>
    <message>
        <source>two knots near %1 are almost equal; make them equal</source>
        <translation>deux nœuds près de %1 sont presque égaux&#x202f;; rendez-les égaux</translation>
    </message>
    <message>
        <source>there is not enough memory for this design</source>
        <translation>la mémoire ne suffit pas pour ce modèle</translation>
    </message>
    <message>
        <source>%1: the file promises more than it holds</source>
        <translation>%1&#x202f;: le fichier annonce plus qu’il ne contient</translation>
    </message>
    <message>
        <source>%1: the mesh is too large, the limit is %2 points and as many triangles</source>
        <translation>%1&#x202f;: le maillage est trop grand, la limite est de %2 points et autant de triangles</translation>
    </message>
    <message>
        <source>%1: the point is not finite, or beyond 10,000,000</source>
        <translation>%1&#x202f;: le point n’est pas fini, ou dépasse 10&#x202f;000&#x202f;000</translation>
    </message>
    <message>
        <source>%1: a face refers to point %2, but there are %3 points</source>
        <translation>%1&#x202f;: une face renvoie au point %2, mais il y a %3 points</translation>
    </message>
    <message>
        <source>%1: the mesh has too many groups, the limit is %2</source>
        <translation>%1&#x202f;: le maillage a trop de groupes, la limite est de %2</translation>
    </message>
    <message>
        <source>%1 holds no mesh</source>
        <translation>%1 ne contient pas de maillage</translation>
    </message>
    <message>
        <source>%1 holds points only; a frame needs faces between them</source>
        <translation>%1 ne contient que des points&#x202f;; une armature demande des faces entre eux</translation>
    </message>
    <message>
        <source>%1: points are counted from 1, not from 0</source>
        <translation>%1&#x202f;: les points se comptent à partir de 1, pas de 0</translation>
    </message>
    <message>
        <source>%1: the file ends too early</source>
        <translation>%1&#x202f;: le fichier finit trop tôt</translation>
    </message>
    <message>
        <source>%1: the file does not begin with OFF</source>
        <translation>%1&#x202f;: le fichier ne commence pas par OFF</translation>
    </message>
    <message>
        <source>%1: binary OFF is not read; save it as text</source>
        <translation>%1&#x202f;: l’OFF binaire n’est pas lu&#x202f;; enregistrez-le en texte</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PLY number type</source>
        <translation>%1&#x202f;: «&#x202f;%2&#x202f;» n’est pas un type de nombre PLY</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PLY format</source>
        <translation>%1&#x202f;: «&#x202f;%2&#x202f;» n’est pas un format PLY</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; cannot count a list</source>
        <translation>%1&#x202f;: «&#x202f;%2&#x202f;» ne peut pas compter une liste</translation>
    </message>
    <message>
        <source>%1: the file does not begin with &quot;ply&quot;</source>
        <translation>%1&#x202f;: le fichier ne commence pas par «&#x202f;ply&#x202f;»</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not expected in a PLY header</source>
        <translation>%1&#x202f;: «&#x202f;%2&#x202f;» n’est pas attendu dans un en-tête PLY</translation>
    </message>
    <message>
        <source>%1: a count is negative</source>
        <translation>%1&#x202f;: un nombre d’éléments est négatif</translation>
    </message>
    <message>
        <source>%1: the points have no coordinate &quot;%2&quot;</source>
        <translation>%1&#x202f;: les points n’ont pas de coordonnée «&#x202f;%2&#x202f;»</translation>
    </message>
    <message>
        <source>%1: the faces have no list &quot;%2&quot;</source>
        <translation>%1&#x202f;: les faces n’ont pas de liste «&#x202f;%2&#x202f;»</translation>
    </message>
    <message>
        <source>%1: a number is missing</source>
        <translation>%1&#x202f;: il manque un nombre</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a number</source>
        <translation>%1&#x202f;: «&#x202f;%2&#x202f;» n’est pas un nombre</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a whole number</source>
        <translation>%1&#x202f;: «&#x202f;%2&#x202f;» n’est pas un nombre entier</translation>
    </message>
    <message>
        <source>unsaved work cannot be protected: &quot;%1&quot; cannot be written</source>
        <translation>le travail non enregistré ne peut pas être protégé&#x202f;: impossible d’écrire «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot;</source>
        <translation>il n’y a pas de fichier «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>you are not allowed to read &quot;%1&quot;</source>
        <translation>vous n’avez pas le droit de lire «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a folder, not a file</source>
        <translation>«&#x202f;%1&#x202f;» est un dossier, pas un fichier</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an ordinary file</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read (%2)</source>
        <translation>impossible de lire «&#x202f;%1&#x202f;» (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: the disk is full; make room or choose another folder</source>
        <translation>impossible d’écrire «&#x202f;%1&#x202f;»&#x202f;: le disque est plein&#x202f;; libérez de la place ou choisissez un autre dossier</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: you are not allowed to write into &quot;%2&quot;; choose another folder</source>
        <translation>impossible d’écrire «&#x202f;%1&#x202f;»&#x202f;: vous n’avez pas le droit d’écrire dans «&#x202f;%2&#x202f;»&#x202f;; choisissez un autre dossier</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: there is no folder &quot;%2&quot;</source>
        <translation>impossible d’écrire «&#x202f;%1&#x202f;»&#x202f;: il n’y a pas de dossier «&#x202f;%2&#x202f;»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is a folder</source>
        <translation>impossible d’écrire «&#x202f;%1&#x202f;»&#x202f;: c’est un dossier</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written (%2)</source>
        <translation>impossible d’écrire «&#x202f;%1&#x202f;» (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too large: %2 MB, and at most %3 MB are read</source>
        <translation>«&#x202f;%1&#x202f;» est trop grand&#x202f;: %2&#xa0;Mo, et %3&#xa0;Mo au plus sont lus</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is write-protected</source>
        <translation>impossible d’écrire «&#x202f;%1&#x202f;»&#x202f;: il est protégé en écriture</translation>
    </message>
    <message>
        <source>The equations of the cover could not be solved: a patch is degenerate or its numbers are too large.</source>
        <translation>Les équations de la housse n’ont pas pu être résolues&#x202f;: une pièce est dégénérée ou ses nombres sont trop grands.</translation>
    </message>
    <message>
        <source>this seam and its neighbours carry their ends round in a circle without ever meeting. Let the seams of this circle end at common points.</source>
        <translation>cette couture et ses voisines se renvoient leurs bouts en cercle sans jamais se rejoindre. Faites finir les coutures de ce cercle en des points communs.</translation>
    </message>
    <message>
        <source>the corners of the two stretches lie too close together to be matched. Move them apart or choose a smaller edge length.</source>
        <translation>les coins des deux tronçons sont trop rapprochés pour être mis en correspondance. Écartez-les ou choisissez une longueur d’arête plus petite.</translation>
    </message>
    <message>
        <source>%1 and %2 hold the same point of the cover in two places, %3 mm apart. Let both curves meet there, or end one stretch earlier.</source>
        <translation>%1 et %2 tiennent le même point de la housse à deux endroits, à %3&#xa0;mm l’un de l’autre. Faites s’y rejoindre les deux courbes, ou finissez un tronçon plus tôt.</translation>
    </message>
    <message>
        <source>the patch is too narrow somewhere for edges of %1 mm. Choose a smaller edge length.</source>
        <translation>la pièce est trop étroite par endroits pour des arêtes de %1&#xa0;mm. Choisissez une longueur d’arête plus petite.</translation>
    </message>
    <message>
        <source>The design cannot be solved: %2</source>
        <translation>Le modèle ne peut pas être résolu&#x202f;: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>There is no patch to solve. Add a patch to the pattern.</source>
        <translation>Il n’y a pas de pièce à calculer. Ajoutez une pièce au patron.</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by an estimated %2 mm. Allow more iterations.</source>
        <translation>Après %1 itérations, la surface bouge encore d’environ %2&#xa0;mm. Permettez plus d’itérations.</translation>
    </message>
    <message>
        <source>Remove %1 points</source>
        <translation>Supprimer %1 points</translation>
    </message>
    <message>
        <source>Move %1 points</source>
        <translation>Déplacer %1 points</translation>
    </message>
    <message>
        <source>another element has the number %1 already; give this one a number of its own</source>
        <translation>un autre élément a déjà le numéro %1&#x202f;; donnez à celui-ci son propre numéro</translation>
    </message>
    <message>
        <source>this is no Bolster design; it must say &quot;format&quot;: &quot;bolster-design&quot;</source>
        <translation>ce n’est pas un modèle Bolster&#x202f;; il doit contenir &quot;format&quot;: &quot;bolster-design&quot;</translation>
    </message>
    <message>
        <source>the design was made by a newer Bolster (version %1 of the format, this program knows %2); update the program</source>
        <translation>le modèle vient d’un Bolster plus récent (version %1 du format, ce programme connaît %2)&#x202f;; mettez le programme à jour</translation>
    </message>
    <message>
        <source>must be %1</source>
        <translation>doit être %1</translation>
    </message>
    <message>
        <source>must be &quot;mm&quot;; convert the design to millimetres</source>
        <translation>doit être &quot;mm&quot;&#x202f;; convertissez le modèle en millimètres</translation>
    </message>
    <message>
        <source>must be a list of elements in square brackets</source>
        <translation>doit être une liste d’éléments entre crochets</translation>
    </message>
    <message>
        <source>must be a list of points in square brackets</source>
        <translation>doit être une liste de points entre crochets</translation>
    </message>
    <message>
        <source>must be a list of numbers in square brackets</source>
        <translation>doit être une liste de nombres entre crochets</translation>
    </message>
    <message>
        <source>the list is empty; leave it out</source>
        <translation>la liste est vide&#x202f;; omettez-la</translation>
    </message>
    <message>
        <source>must be a curve in braces, with degree, closed and points</source>
        <translation>doit être une courbe entre accolades, avec degree, closed et points</translation>
    </message>
    <message>
        <source>a curve has either corners or knots; remove one of them</source>
        <translation>une courbe a soit corners, soit knots&#x202f;; supprimez l’un des deux</translation>
    </message>
    <message>
        <source>an outline must be closed; write true</source>
        <translation>un contour doit être fermé&#x202f;; écrivez true</translation>
    </message>
    <message>
        <source>must be a stretch in braces, with patch, from and to</source>
        <translation>doit être un tronçon entre accolades, avec patch, from et to</translation>
    </message>
    <message>
        <source>must be a quaternion [w, x, y, z] of length 1, not of length %1</source>
        <translation>doit être un quaternion [w, x, y, z] de longueur 1, pas de longueur %1</translation>
    </message>
    <message>
        <source>must be an object in braces</source>
        <translation>doit être un objet entre accolades</translation>
    </message>
    <message>
        <source>an element must be an object in braces</source>
        <translation>un élément doit être un objet entre accolades</translation>
    </message>
    <message>
        <source>must be true or false, without quotes</source>
        <translation>doit être true ou false, sans guillemets</translation>
    </message>
    <message>
        <source>must be a text in quotes</source>
        <translation>doit être un texte entre guillemets</translation>
    </message>
    <message>
        <source>and %1 more problems of this element</source>
        <translation>et encore %1 problèmes de cet élément</translation>
    </message>
    <message>
        <source>must be a number, without quotes</source>
        <translation>doit être un nombre, sans guillemets</translation>
    </message>
    <message>
        <source>must be a whole number from %1 to %2</source>
        <translation>doit être un nombre entier de %1 à %2</translation>
    </message>
    <message>
        <source>must be a list of %1 numbers in square brackets</source>
        <translation>doit être une liste de %1 nombres entre crochets</translation>
    </message>
    <message>
        <source>this key occurs twice; remove one of them</source>
        <translation>cette clé apparaît deux fois&#x202f;; supprimez-en une</translation>
    </message>
    <message>
        <source>this key is missing; add it</source>
        <translation>cette clé manque&#x202f;; ajoutez-la</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>doit être l’un de %1</translation>
    </message>
    <message>
        <source>this key is unknown; check its spelling or remove it</source>
        <translation>cette clé est inconnue&#x202f;; vérifiez l’orthographe ou supprimez-la</translation>
    </message>
    <message>
        <source>Move a point of %1</source>
        <translation>Déplacer un point de %1</translation>
    </message>
    <message>
        <source>Move %2 points of %1</source>
        <translation>Déplacer %2 points de %1</translation>
    </message>
    <message>
        <source>Insert a point into %1</source>
        <translation>Insérer un point dans %1</translation>
    </message>
    <message>
        <source>Remove a point of %1</source>
        <translation>Supprimer un point de %1</translation>
    </message>
    <message>
        <source>Change the settings</source>
        <translation>Modifier les réglages</translation>
    </message>
    <message>
        <source>Add fabric %1</source>
        <translation>Ajouter le tissu %1</translation>
    </message>
    <message>
        <source>Add patch %1</source>
        <translation>Ajouter la pièce %1</translation>
    </message>
    <message>
        <source>Add a seam</source>
        <translation>Ajouter une couture</translation>
    </message>
    <message>
        <source>Add fixation curve %1</source>
        <translation>Ajouter la courbe de fixation %1</translation>
    </message>
    <message>
        <source>Add a fixation seam</source>
        <translation>Ajouter une fixation</translation>
    </message>
    <message>
        <source>Add frame %1</source>
        <translation>Ajouter l’armature %1</translation>
    </message>
    <message>
        <source>Add an unreadable element</source>
        <translation>Ajouter un élément illisible</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>Renommer %1 en %2</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Supprimer %1</translation>
    </message>
    <message>
        <source>Remove %1 elements</source>
        <translation>Supprimer %1 éléments</translation>
    </message>
    <message>
        <source>Move %1 patches</source>
        <translation>Déplacer %1 pièces</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Déplacer %1</translation>
    </message>
    <message>
        <source>Turn %1 patches</source>
        <translation>Tourner %1 pièces</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>Tourner %1</translation>
    </message>
    <message>
        <source>There is not enough memory for this surface. Choose a larger edge length.</source>
        <translation>La mémoire ne suffit pas pour cette surface. Choisissez une longueur d’arête plus grande.</translation>
    </message>
    <message>
        <source>The solver failed: %1. The last good surface is kept.</source>
        <translation>Le calcul a échoué&#x202f;: %1. La dernière bonne surface est conservée.</translation>
    </message>
    <message>
        <source>Change the colour of %1</source>
        <translation>Modifier la couleur de %1</translation>
    </message>
    <message>
        <source>Change the stiffness of %1</source>
        <translation>Modifier la rigidité de %1</translation>
    </message>
    <message>
        <source>Change the Poisson parameter of %1</source>
        <translation>Modifier le coefficient de Poisson de %1</translation>
    </message>
    <message>
        <source>Change the bending length of %1</source>
        <translation>Modifier la longueur de flexion de %1</translation>
    </message>
    <message>
        <source>Change the fabric of %1</source>
        <translation>Modifier le tissu de %1</translation>
    </message>
    <message>
        <source>Change the grain of %1</source>
        <translation>Modifier le droit-fil de %1</translation>
    </message>
    <message>
        <source>Change the pressure of %1</source>
        <translation>Modifier la pression de %1</translation>
    </message>
    <message>
        <source>Change the right side of %1</source>
        <translation>Modifier l’endroit de %1</translation>
    </message>
    <message>
        <source>Move %1 in the layout</source>
        <translation>Déplacer %1 dans la disposition</translation>
    </message>
    <message>
        <source>Turn %1 in the layout</source>
        <translation>Tourner %1 dans la disposition</translation>
    </message>
    <message>
        <source>Change the continuity of %1</source>
        <translation>Modifier la continuité de %1</translation>
    </message>
    <message>
        <source>Change how %1 is matched</source>
        <translation>Modifier la correspondance de %1</translation>
    </message>
    <message>
        <source>Reverse %1</source>
        <translation>Inverser %1</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>Mettre %1 à l’échelle</translation>
    </message>
    <message>
        <source>The surface still moves after %1 iterations.</source>
        <translation>La surface bouge encore après %1 itérations.</translation>
    </message>
    <message>
        <source>this is no name of a file</source>
        <translation>ce n’est pas un nom de fichier</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be relative to the design&apos;s folder and use &quot;/&quot; between folders</source>
        <translation>«&#x202f;%1&#x202f;» doit être relatif au dossier du modèle et utiliser «&#x202f;/&#x202f;» entre les dossiers</translation>
    </message>
    <message>
        <source>left out because of its errors</source>
        <translation>omis à cause de ses erreurs</translation>
    </message>
    <message>
        <source>left out because it needs %1, which is not there</source>
        <translation>omis, car il lui faut %1, qui n’existe pas</translation>
    </message>
    <message>
        <source>an edge length of %1 mm is used instead</source>
        <translation>une longueur d’arête de %1&#xa0;mm est utilisée à la place</translation>
    </message>
    <message>
        <source>the file is not a design</source>
        <translation>le fichier n’est pas un modèle</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written</source>
        <translation>impossible d’écrire «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be copied to &quot;%2&quot;: %3</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas pu être copié vers «&#x202f;%2&#x202f;»&#x202f;: %3</translation>
    </message>
    <message>
        <source>the folder &quot;%1&quot; could not be made</source>
        <translation>le dossier «&#x202f;%1&#x202f;» n’a pas pu être créé</translation>
    </message>
    <message>
        <source>the patch is free in space: nothing fixes it to the frame; add a fixation</source>
        <translation>la pièce est libre dans l’espace&#x202f;: rien ne la fixe à l’armature&#x202f;; ajoutez une fixation</translation>
    </message>
    <message>
        <source>this patch and the %1 sewn to it are free in space: nothing fixes them to the frame; add a fixation</source>
        <translation>cette pièce et les %1 qui y sont cousues sont libres dans l’espace&#x202f;: rien ne les fixe à l’armature&#x202f;; ajoutez une fixation</translation>
    </message>
    <message>
        <source>is %1, but must lie between %2 and %3</source>
        <translation>vaut %1, mais doit être entre %2 et %3</translation>
    </message>
    <message>
        <source>there is no element %1; name a %2</source>
        <translation>il n’y a pas d’élément %1&#x202f;; indiquez un élément du type %2</translation>
    </message>
    <message>
        <source>element %1 cannot be read; repair it or name another %2</source>
        <translation>l’élément %1 est illisible&#x202f;; réparez-le ou indiquez-en un autre du type %2</translation>
    </message>
    <message>
        <source>%1 is no %2; name another element</source>
        <translation>%1 n’est pas du type %2&#x202f;; indiquez un autre élément</translation>
    </message>
    <message>
        <source>%1 mm would make more than 5 million triangles; take at least %2 mm for these patches</source>
        <translation>%1&#xa0;mm donneraient plus de 5 millions de triangles&#x202f;; prenez au moins %2&#xa0;mm pour ces pièces</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no colour; write it like #7a4a2b</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas une couleur&#x202f;; écrivez-la comme #7a4a2b</translation>
    </message>
    <message>
        <source>the mesh cannot resolve folds as small as a bending length of %1 mm makes them: with edges of %2 mm it acts like %3 mm; take an edge length of at most %4 mm, or a longer bending length</source>
        <translation>le maillage ne peut pas rendre des plis aussi petits que ceux d’une longueur de flexion de %1&#xa0;mm&#x202f;: avec des arêtes de %2&#xa0;mm, elle agit comme %3&#xa0;mm&#x202f;; prenez une longueur d’arête d’au plus %4&#xa0;mm, ou une longueur de flexion plus grande</translation>
    </message>
    <message>
        <source>an outline must be a closed curve</source>
        <translation>un contour doit être une courbe fermée</translation>
    </message>
    <message>
        <source>the outline needs at least three points in different places</source>
        <translation>le contour demande au moins trois points à des endroits différents</translation>
    </message>
    <message>
        <source>all points of the outline lie on one line, it encloses no area; move one of them</source>
        <translation>tous les points du contour sont alignés, il n’enferme aucune aire&#x202f;; déplacez-en un</translation>
    </message>
    <message>
        <source>the outline crosses or touches itself near %1; move its points apart there</source>
        <translation>le contour se croise ou se touche près de %1&#x202f;; écartez-y ses points</translation>
    </message>
    <message>
        <source>the outline encloses no area</source>
        <translation>le contour n’enferme aucune aire</translation>
    </message>
    <message>
        <source>%1 is the end of the curve; write %2, its start</source>
        <translation>%1 est la fin de la courbe&#x202f;; écrivez %2, son début</translation>
    </message>
    <message>
        <source>is %1, but must be larger than the start of the stretch, %2</source>
        <translation>vaut %1, mais doit être plus grand que le début du tronçon, %2</translation>
    </message>
    <message>
        <source>the stretch from %1 to %2 is empty or longer than the curve</source>
        <translation>le tronçon de %1 à %2 est vide ou plus long que la courbe</translation>
    </message>
    <message>
        <source>the stretch from %1 to %2 has no length; the outline&apos;s points coincide there</source>
        <translation>le tronçon de %1 à %2 n’a pas de longueur&#x202f;; les points du contour y coïncident</translation>
    </message>
    <message>
        <source>the seam would sew a stretch of &quot;%1&quot; to itself: %2 to %3 and %4 to %5 overlap; choose two separate stretches</source>
        <translation>la couture coudrait un tronçon de «&#x202f;%1&#x202f;» à lui-même&#x202f;: %2 à %3 et %4 à %5 se chevauchent&#x202f;; choisissez deux tronçons séparés</translation>
    </message>
    <message>
        <source>the seam joins the right side of &quot;%1&quot; to the wrong side of &quot;%2&quot;; turn &quot;reversed&quot; round, or one patch wrong side out</source>
        <translation>la couture joint l’endroit de «&#x202f;%1&#x202f;» à l’envers de «&#x202f;%2&#x202f;»&#x202f;; inversez «&#x202f;reversed&#x202f;», ou mettez l’une des pièces envers à l’extérieur</translation>
    </message>
    <message>
        <source>the sides of the seam are %1 mm (&quot;%2&quot;) and %3 mm (&quot;%4&quot;) long: %5 % ease, more than 5 % puckers; make them equal or check the ends of the stretches</source>
        <translation>les côtés de la couture mesurent %1&#xa0;mm («&#x202f;%2&#x202f;») et %3&#xa0;mm («&#x202f;%4&#x202f;»)&#x202f;: %5&#x202f;% d’embu, au-delà de 5&#x202f;% elle fronce&#x202f;; égalisez-les ou vérifiez les bouts des tronçons</translation>
    </message>
    <message>
        <source>the curve has no length; move its points apart</source>
        <translation>la courbe n’a pas de longueur&#x202f;; écartez ses points</translation>
    </message>
    <message>
        <source>the curve from %1 to %2 has no length</source>
        <translation>la courbe de %1 à %2 n’a pas de longueur</translation>
    </message>
    <message>
        <source>is %1, but must be positive: millimetres per unit of the file</source>
        <translation>vaut %1, mais doit être positif&#x202f;: millimètres par unité du fichier</translation>
    </message>
    <message>
        <source>a design has at most %1 elements</source>
        <translation>un modèle a au plus %1 éléments</translation>
    </message>
    <message>
        <source>a curve has at most %1 points</source>
        <translation>une courbe a au plus %1 points</translation>
    </message>
    <message>
        <source>the usual values of a fabric are used instead</source>
        <translation>les valeurs habituelles d’un tissu sont utilisées à la place</translation>
    </message>
    <message>
        <source>Remove %1 and what is sewn to it</source>
        <translation>Supprimer %1 et ce qui y est cousu</translation>
    </message>
    <message>
        <source>Remove %1 and %2 seams and fixations</source>
        <translation>Supprimer %1 et %2 coutures et fixations</translation>
    </message>
    <message>
        <source>is %1, but must be a positive length of at most %2; 12 mm is usual</source>
        <translation>vaut %1, mais doit être une longueur positive d’au plus %2&#x202f;; 12&#xa0;mm est habituel</translation>
    </message>
    <message>
        <source>no mesh can resolve folds as small as a bending length of %1 mm makes them: with edges of %2 mm it acts like %3 mm; take a longer bending length</source>
        <translation>aucun maillage ne peut rendre des plis aussi petits que ceux d’une longueur de flexion de %1&#xa0;mm&#x202f;: avec des arêtes de %2&#xa0;mm, elle agit comme %3&#xa0;mm&#x202f;; prenez une longueur de flexion plus grande</translation>
    </message>
    <message>
        <source>it sews what %1 sews already; remove one of them</source>
        <translation>elle coud ce que %1 coud déjà&#x202f;; supprimez l’une des deux</translation>
    </message>
    <message>
        <source>it sews the same stretches as %1, but the other way round: each would be folded onto itself; remove one of the two</source>
        <translation>elle coud les mêmes tronçons que %1, mais en sens inverse&#x202f;: chacun serait replié sur lui-même&#x202f;; supprimez l’une des deux</translation>
    </message>
    <message>
        <source>&quot;%1&quot; goes up with &quot;..&quot;; write the way from the design&apos;s folder without it, or copy the file there</source>
        <translation>«&#x202f;%1&#x202f;» remonte avec «&#x202f;..&#x202f;»&#x202f;; écrivez le chemin depuis le dossier du modèle sans cela, ou copiez-y le fichier</translation>
    </message>
    <message>
        <source>the number %1 is too large or too small; stay within %2</source>
        <translation>le nombre %1 est trop grand ou trop petit&#x202f;; restez dans %2</translation>
    </message>
    <message>
        <source>the text is UTF-16; save it as UTF-8</source>
        <translation>le texte est en UTF-16&#x202f;; enregistrez-le en UTF-8</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by %2 mm in each: it does not come to rest. Lower the pressure, or make curves as long as the outlines they hold.</source>
        <translation>Après %1 itérations, la surface bouge encore de %2&#xa0;mm à chacune&#x202f;: elle ne se stabilise pas. Réduisez la pression, ou donnez aux courbes la longueur des contours qu’elles tiennent.</translation>
    </message>
    <message>
        <source>%1 of %2 triangles of the cover lie upside down. Look for cloth pressed into too little room, or a bending length that is long for its patch.</source>
        <translation>%1 des %2 triangles de la housse sont à l’envers. Cherchez du tissu à l’étroit, ou une longueur de flexion grande pour sa pièce.</translation>
    </message>
    <message>
        <source>there is either a normal or a tangent; remove one of them</source>
        <translation>il y a soit une normale, soit une tangente&#x202f;; supprimez l’une des deux</translation>
    </message>
    <message>
        <source>there are %1 directions, but at most %2 are possible</source>
        <translation>il y a %1 directions, mais %2 au plus sont possibles</translation>
    </message>
    <message>
        <source>a direction must be three numbers that are not all 0</source>
        <translation>une direction doit avoir trois nombres qui ne sont pas tous 0</translation>
    </message>
    <message>
        <source>direction %1 is opposite to the one before, so that it is not known on which way to turn; add one between them</source>
        <translation>la direction %1 est opposée à la précédente, si bien que le sens de rotation est inconnu&#x202f;; ajoutez-en une entre elles</translation>
    </message>
    <message>
        <source>there is no curve; name one, or leave out curve_from and curve_to</source>
        <translation>il n’y a pas de courbe&#x202f;; indiquez-en une, ou omettez curve_from et curve_to</translation>
    </message>
    <message>
        <source>Change the normal held by %1</source>
        <translation>Modifier la normale imposée par %1</translation>
    </message>
    <message>
        <source>must be a text in quotation marks</source>
        <translation>doit être un texte entre guillemets</translation>
    </message>
    <message>
        <source>the curve in the patch and its target must both be open or both be closed</source>
        <translation>la courbe dans la pièce et sa cible doivent être toutes deux ouvertes ou toutes deux fermées</translation>
    </message>
    <message>
        <source>Add handle curve %1</source>
        <translation>Ajouter la courbe de maintien %1</translation>
    </message>
    <message>
        <source>Add fancy seam %1</source>
        <translation>Ajouter la couture décorative %1</translation>
    </message>
    <message>
        <source>Add cushion %1</source>
        <translation>Ajouter le rembourrage %1</translation>
    </message>
    <message>
        <source>Add foam %1</source>
        <translation>Ajouter la mousse %1</translation>
    </message>
    <message>
        <source>a width of %1 mm is too narrow for edges of %2 mm; make it at least %3 mm wide, or choose a smaller edge length</source>
        <translation>une largeur de %1&#xa0;mm est trop étroite pour des arêtes de %2&#xa0;mm&#x202f;; donnez-lui au moins %3&#xa0;mm, ou choisissez une longueur d’arête plus petite</translation>
    </message>
    <message>
        <source>it lies outside its patch; move its points inside the outline</source>
        <translation>elle est hors de sa pièce&#x202f;; déplacez ses points dans le contour</translation>
    </message>
    <message>
        <source>it leaves the patch and comes back; keep it inside, or end it at the outline</source>
        <translation>elle quitte la pièce et y revient&#x202f;; gardez-la à l’intérieur, ou finissez-la au contour</translation>
    </message>
    <message>
        <source>it runs too flat into the outline near %1; let it meet the outline more steeply, or end it before</source>
        <translation>elle arrive trop à plat sur le contour près de %1&#x202f;; faites-la arriver plus droit, ou finissez-la avant</translation>
    </message>
    <message>
        <source>it bends too sharply for a width of %1 mm near %2; make it narrower, or bend it less there</source>
        <translation>elle se courbe trop près de %2 pour une largeur de %1&#xa0;mm&#x202f;; rétrécissez-la, ou courbez-la moins à cet endroit</translation>
    </message>
    <message>
        <source>a cushion takes at most %1 bodies of foam; this one is left out</source>
        <translation>un rembourrage prend au plus %1 blocs de mousse&#x202f;; celui-ci est omis</translation>
    </message>
    <message>
        <source>the frame has no part &quot;%1&quot;; it has %2</source>
        <translation>l’armature n’a pas de partie «&#x202f;%1&#x202f;»&#x202f;; elle a %2</translation>
    </message>
    <message>
        <source>it is only %1 mm long; draw it at least %2 mm long, or choose a smaller edge length</source>
        <translation>elle ne mesure que %1&#xa0;mm&#x202f;; dessinez-la d’au moins %2&#xa0;mm, ou choisissez une longueur d’arête plus petite</translation>
    </message>
    <message>
        <source>it reaches beyond its patch near %1; move its points inside the outline</source>
        <translation>elle dépasse de sa pièce près de %1&#x202f;; déplacez ses points dans le contour</translation>
    </message>
    <message>
        <source>it comes closer than %1 mm to the outline near %2; keep away from it, or choose a smaller edge length</source>
        <translation>elle est à moins de %1&#xa0;mm du contour près de %2&#x202f;; éloignez-la, ou choisissez une longueur d’arête plus petite</translation>
    </message>
    <message>
        <source>it crosses %1, or comes closer to it than %2 mm, near %3; move them apart, or choose a smaller edge length</source>
        <translation>elle croise %1, ou s’en approche à moins de %2&#xa0;mm, près de %3&#x202f;; écartez-les, ou choisissez une longueur d’arête plus petite</translation>
    </message>
    <message>
        <source>it crosses itself, or comes closer to itself than %1 mm, near %2; move its points apart, or choose a smaller edge length</source>
        <translation>elle se croise, ou s’approche d’elle-même à moins de %1&#xa0;mm, près de %2&#x202f;; écartez ses points, ou choisissez une longueur d’arête plus petite</translation>
    </message>
    <message>
        <source>the patch cannot be triangulated along it with edges of %1 mm. Choose a smaller edge length.</source>
        <translation>la pièce ne peut pas être triangulée le long de cette courbe avec des arêtes de %1&#xa0;mm. Choisissez une longueur d’arête plus petite.</translation>
    </message>
    <message>
        <source>Change the frame of %1</source>
        <translation>Modifier l’armature de %1</translation>
    </message>
    <message>
        <source>Change what %1 pushes</source>
        <translation>Modifier ce que %1 pousse</translation>
    </message>
    <message>
        <source>Switch %1</source>
        <translation>Activer ou désactiver %1</translation>
    </message>
    <message>
        <source>Change the parts of %1</source>
        <translation>Modifier les parties de %1</translation>
    </message>
    <message>
        <source>Change the padding of %1</source>
        <translation>Modifier la garniture de %1</translation>
    </message>
    <message>
        <source>Change the strength of %1</source>
        <translation>Modifier la force de %1</translation>
    </message>
    <message>
        <source>Change the distance of %1</source>
        <translation>Modifier la distance de %1</translation>
    </message>
    <message>
        <source>Change the voxels of %1</source>
        <translation>Modifier les voxels de %1</translation>
    </message>
    <message>
        <source>Change the cushion of %1</source>
        <translation>Modifier le rembourrage de %1</translation>
    </message>
    <message>
        <source>Change the shape of %1</source>
        <translation>Modifier la forme de %1</translation>
    </message>
    <message>
        <source>Change the size of %1</source>
        <translation>Modifier la taille de %1</translation>
    </message>
    <message>
        <source>Add or cut %1</source>
        <translation>Ajouter ou évider %1</translation>
    </message>
    <message>
        <source>Change the contact of %1</source>
        <translation>Modifier le contact de %1</translation>
    </message>
    <message>
        <source>Change the gap of %1</source>
        <translation>Modifier le jeu de %1</translation>
    </message>
    <message>
        <source>Change the width of %1</source>
        <translation>Modifier la largeur de %1</translation>
    </message>
    <message>
        <source>Change the depth of %1</source>
        <translation>Modifier la profondeur de %1</translation>
    </message>
    <message>
        <source>Change the profile of %1</source>
        <translation>Modifier le profil de %1</translation>
    </message>
    <message>
        <source>Move points of %1 curves</source>
        <translation>Déplacer des points de %1 courbes</translation>
    </message>
    <message>
        <source>Rename a file</source>
        <translation>Renommer un fichier</translation>
    </message>
    <message>
        <source>Change the file of %1</source>
        <translation>Modifier le fichier de %1</translation>
    </message>
    <message>
        <source>the file is missing</source>
        <translation>le fichier manque</translation>
    </message>
    <message>
        <source>it is a file that this design refers to; choose another name</source>
        <translation>c’est un fichier auquel ce modèle renvoie&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>There is no cover to place the scan on.</source>
        <translation>Il n’y a pas de housse sur laquelle placer le scan.</translation>
    </message>
    <message>
        <source>must be a list of at most %1 planes, [x, y, z, distance] each</source>
        <translation>doit être une liste d’au plus %1 plans, chacun [x, y, z, distance]</translation>
    </message>
    <message>
        <source>must be a list of at most %1 cuts in braces</source>
        <translation>doit être une liste d’au plus %1 découpes entre accolades</translation>
    </message>
    <message>
        <source>must be a cut in braces, with planes</source>
        <translation>doit être une découpe entre accolades, avec planes</translation>
    </message>
    <message>
        <source>the first three numbers are the plane&apos;s normal; not all of them may be 0</source>
        <translation>les trois premiers nombres sont la normale du plan&#x202f;; ils ne peuvent pas tous être 0</translation>
    </message>
    <message>
        <source>no file is named; write the name of a file beside the design</source>
        <translation>aucun fichier n’est indiqué&#x202f;; écrivez le nom d’un fichier placé à côté du modèle</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no file in the design&apos;s folder; copy the file into that folder and name it here</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un fichier du dossier du modèle&#x202f;; copiez le fichier dans ce dossier et indiquez-le ici</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot; in the design&apos;s folder; copy the file there or choose another one</source>
        <translation>il n’y a pas de fichier «&#x202f;%1&#x202f;» dans le dossier du modèle&#x202f;; copiez-y le fichier ou choisissez-en un autre</translation>
    </message>
    <message>
        <source>with this scale and position the points reach beyond 10,000,000 mm</source>
        <translation>avec cette échelle et cette position, les points dépassent 10&#x202f;000&#x202f;000&#xa0;mm</translation>
    </message>
    <message>
        <source>Add scan %1</source>
        <translation>Ajouter le scan %1</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Découper %1</translation>
    </message>
    <message>
        <source>Show all of %1</source>
        <translation>Afficher tout %1</translation>
    </message>
    <message>
        <source>Cut the floor off %1</source>
        <translation>Retirer le sol de %1</translation>
    </message>
    <message>
        <source>%1 holds no points</source>
        <translation>%1 ne contient pas de points</translation>
    </message>
    <message>
        <source>%1: the scan is too large, the limit is %2 points</source>
        <translation>%1&#x202f;: le scan est trop grand, la limite est de %2 points</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not expected in a PCD header</source>
        <translation>%1&#x202f;: «&#x202f;%2&#x202f;» n’est pas attendu dans un en-tête PCD</translation>
    </message>
    <message>
        <source>%1: the compressed points are damaged</source>
        <translation>%1&#x202f;: les points compressés sont endommagés</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PCD format</source>
        <translation>%1&#x202f;: «&#x202f;%2&#x202f;» n’est pas un format PCD</translation>
    </message>
    <message>
        <source>the cuts leave nothing of the scan; remove one of them</source>
        <translation>les découpes ne laissent rien du scan&#x202f;; supprimez-en une</translation>
    </message>
    <message>
        <source>Change the threshold of %1</source>
        <translation>Modifier le seuil de %1</translation>
    </message>
    <message>
        <source>Change how %1 pulls</source>
        <translation>Modifier la traction de %1</translation>
    </message>
    <message>
        <source>Release points of twins</source>
        <translation>Libérer des points de jumeaux</translation>
    </message>
    <message>
        <source>Re-link points of twins</source>
        <translation>Relier des points de jumeaux</translation>
    </message>
    <message>
        <source>Make the design symmetric</source>
        <translation>Rendre le modèle symétrique</translation>
    </message>
    <message>
        <source>These two cannot be twins.</source>
        <translation>Ces deux-là ne peuvent pas être jumeaux.</translation>
    </message>
    <message>
        <source>Make corners</source>
        <translation>Faire des coins</translation>
    </message>
    <message>
        <source>Make curves smooth</source>
        <translation>Rendre des courbes lisses</translation>
    </message>
    <message>
        <source>element %1 cannot be its twin: that must be another %2 which is nobody else&apos;s; until then it has none</source>
        <translation>l’élément %1 ne peut pas être son jumeau&#x202f;: il faut un autre élément du type %2, qui ne soit celui de personne&#x202f;; d’ici là, il n’en a pas</translation>
    </message>
    <message>
        <source>there is no point %1</source>
        <translation>il n’y a pas de point %1</translation>
    </message>
    <message>
        <source>its points and knots are not those of %1; the next edit of one of them makes it the mirror image</source>
        <translation>ses points et nœuds ne sont pas ceux de %1&#x202f;; la prochaine modification de l’un des deux en fera l’image miroir</translation>
    </message>
    <message>
        <source>%1 of its points are no mirror images of those of %2; release them, or move them</source>
        <translation>%1 de ses points ne sont pas les images miroir de ceux de %2&#x202f;; libérez-les ou déplacez-les</translation>
    </message>
    <message>
        <source>the plane needs a normal that is not 0, and numbers within 1e7; x = 0 is used instead</source>
        <translation>le plan demande une normale non nulle et des nombres jusqu’à 1e7&#x202f;; x = 0 est utilisé à la place</translation>
    </message>
    <message>
        <source>the axis needs a direction that is not 0, and numbers within 1e7; x = 0 is used instead</source>
        <translation>l’axe demande une direction non nulle et des nombres jusqu’à 1e7&#x202f;; x = 0 est utilisé à la place</translation>
    </message>
    <message>
        <source>The clipboard holds no parts of a design.</source>
        <translation>Le presse-papiers ne contient pas de parties d’un modèle.</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Coller %1</translation>
    </message>
    <message>
        <source>Paste %1 pieces</source>
        <translation>Coller %1 éléments</translation>
    </message>
    <message>
        <source>The clipboard holds no patches and no fixation curves.</source>
        <translation>Le presse-papiers ne contient ni pièces ni courbes de fixation.</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Dupliquer %1</translation>
    </message>
    <message>
        <source>Duplicate %1 pieces</source>
        <translation>Dupliquer %1 éléments</translation>
    </message>
    <message>
        <source>Make a corner in %1</source>
        <translation>Faire un coin dans %1</translation>
    </message>
    <message>
        <source>Make %1 smooth</source>
        <translation>Rendre %1 lisse</translation>
    </message>
    <message>
        <source>Straighten a stretch of %1</source>
        <translation>Rendre droit un tronçon de %1</translation>
    </message>
    <message>
        <source>Attach %1 to %2</source>
        <translation>Fixer %1 à %2</translation>
    </message>
    <message>
        <source>There is no such stretch of an outline.</source>
        <translation>Il n’y a pas de tel tronçon d’un contour.</translation>
    </message>
    <message>
        <source>The stretch has no length.</source>
        <translation>Le tronçon n’a pas de longueur.</translation>
    </message>
    <message>
        <source>A part of this stretch is fixed to %1 already: remove that fixation or choose another stretch.</source>
        <translation>Une partie de ce tronçon est déjà fixée à %1&#x202f;: supprimez cette fixation ou choisissez un autre tronçon.</translation>
    </message>
    <message>
        <source>Create fixation curve %1</source>
        <translation>Créer la courbe de fixation %1</translation>
    </message>
    <message>
        <source>Attach %1 stretches to %2</source>
        <translation>Fixer %1 tronçons à %2</translation>
    </message>
    <message>
        <source>Attach %1 to %2 curves</source>
        <translation>Fixer %1 à %2 courbes</translation>
    </message>
    <message>
        <source>Align %1 patches</source>
        <translation>Aligner %1 pièces</translation>
    </message>
    <message>
        <source>Distribute %1 patches</source>
        <translation>Répartir %1 pièces</translation>
    </message>
    <message>
        <source>Arrange %1 patches</source>
        <translation>Disposer %1 pièces</translation>
    </message>
    <message>
        <source>Make %1 and %2 twins</source>
        <translation>Faire de %1 et %2 des jumeaux</translation>
    </message>
    <message>
        <source>They are no mirror images: they differ by %1 mm. Twins must be alike; make a mirror twin of one of them instead.</source>
        <translation>Ce ne sont pas des images miroir&#x202f;: elles diffèrent de %1&#xa0;mm. Des jumeaux doivent se ressembler&#x202f;; créez plutôt un jumeau symétrique de l’une d’elles.</translation>
    </message>
    <message>
        <source>Make a mirror twin of %1</source>
        <translation>Créer un jumeau symétrique de %1</translation>
    </message>
    <message>
        <source>Make %1 mirror twins</source>
        <translation>Créer %1 jumeaux symétriques</translation>
    </message>
    <message>
        <source>A patch of the seam is missing or invalid: repair it first.</source>
        <translation>Une pièce de la couture manque ou n’est pas valide&#x202f;: réparez-la d’abord.</translation>
    </message>
    <message>
        <source>The seam joins %1 to itself: there is nothing to merge.</source>
        <translation>La couture joint %1 à elle-même&#x202f;: il n’y a rien à fusionner.</translation>
    </message>
    <message>
        <source>The seam takes up a whole outline: nothing would be left.</source>
        <translation>La couture occupe tout un contour&#x202f;: il ne resterait rien.</translation>
    </message>
    <message>
        <source>The seam joins the right side of %1 to the wrong side of %2: one patch cannot be both.</source>
        <translation>La couture joint l’endroit de %1 à l’envers de %2&#x202f;: une pièce ne peut pas être les deux.</translation>
    </message>
    <message>
        <source>The sides of the seam differ by %1 % in length, more than 5 %.</source>
        <translation>Les côtés de la couture diffèrent de %1&#x202f;% en longueur, plus de 5&#x202f;%.</translation>
    </message>
    <message>
        <source>Select the seam along which to merge.</source>
        <translation>Sélectionnez la couture le long de laquelle fusionner.</translation>
    </message>
    <message>
        <source>Merged, %1 and %2 would overlap or cross: the seam stays.</source>
        <translation>Une fois fusionnées, %1 et %2 se chevaucheraient ou se croiseraient&#x202f;: la couture reste.</translation>
    </message>
    <message>
        <source>Merge %1 and %2</source>
        <translation>Fusionner %1 et %2</translation>
    </message>
    <message>
        <source>Scale %1 patches</source>
        <translation>Mettre %1 pièces à l’échelle</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>Refléter %1</translation>
    </message>
    <message>
        <source>Mirror %1 patches</source>
        <translation>Refléter %1 pièces</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>Diviser %1</translation>
    </message>
    <message>
        <source>The line must cross the outline of %1 exactly twice, not %2 times.</source>
        <translation>La ligne doit croiser le contour de %1 exactement deux fois, pas %2 fois.</translation>
    </message>
    <message>
        <source>Draw a line over a patch to split it.</source>
        <translation>Dessinez une ligne en travers d’une pièce pour la diviser.</translation>
    </message>
    <message>
        <source>The outline of %1 is invalid: repair it first.</source>
        <translation>Le contour de %1 n’est pas valide&#x202f;: réparez-le d’abord.</translation>
    </message>
    <message>
        <source>The line must run inside %1.</source>
        <translation>La ligne doit passer à l’intérieur de %1.</translation>
    </message>
    <message>
        <source>A piece of %1 would cross itself or be too narrow: draw another line.</source>
        <translation>Un morceau de %1 se croiserait ou serait trop étroit&#x202f;: dessinez une autre ligne.</translation>
    </message>
    <message>
        <source>Sew %1 to %2</source>
        <translation>Coudre %1 à %2</translation>
    </message>
    <message>
        <source>Sew %1 to %2 stretches in a row</source>
        <translation>Coudre %1 à %2 tronçons à la suite</translation>
    </message>
    <message>
        <source>Flip %1</source>
        <translation>Inverser %1</translation>
    </message>
    <message>
        <source>Flip %1 seams</source>
        <translation>Inverser %1 coutures</translation>
    </message>
    <message>
        <source>Swap the sides of %1</source>
        <translation>Échanger les côtés de %1</translation>
    </message>
    <message>
        <source>Swap the sides of %1 seams</source>
        <translation>Échanger les côtés de %1 coutures</translation>
    </message>
    <message>
        <source>Change the continuity of %1 seams</source>
        <translation>Modifier la continuité de %1 coutures</translation>
    </message>
    <message>
        <source>Change how %1 seams are matched</source>
        <translation>Modifier la correspondance de %1 coutures</translation>
    </message>
    <message>
        <source>This stretch has no length: choose two different points.</source>
        <translation>Ce tronçon n’a pas de longueur&#x202f;: choisissez deux points différents.</translation>
    </message>
    <message>
        <source>Move an end of %1</source>
        <translation>Déplacer un bout de %1</translation>
    </message>
    <message>
        <source>%1 is already sewn to %2 here: remove that seam first, or take a free stretch.</source>
        <translation>%1 est déjà cousue à %2 ici&#x202f;: supprimez d’abord cette couture, ou prenez un tronçon libre.</translation>
    </message>
    <message>
        <source>A stretch cannot be sewn to itself: choose two that have no part in common.</source>
        <translation>Un tronçon ne peut pas être cousu à lui-même&#x202f;: choisissez-en deux sans partie commune.</translation>
    </message>
    <message>
        <source>Unlink %1 and %2</source>
        <translation>Délier %1 et %2</translation>
    </message>
    <message>
        <source>Unlink %1 pairs of twins</source>
        <translation>Délier %1 paires de jumeaux</translation>
    </message>
    <message>
        <source>Release a point of %1</source>
        <translation>Libérer un point de %1</translation>
    </message>
    <message>
        <source>Release %2 points of %1</source>
        <translation>Libérer %2 points de %1</translation>
    </message>
    <message>
        <source>Re-link a point of %1</source>
        <translation>Relier un point de %1</translation>
    </message>
    <message>
        <source>Re-link %2 points of %1</source>
        <translation>Relier %2 points de %1</translation>
    </message>
    <message>
        <source>Change the curve of %1</source>
        <translation>Modifier la courbe de %1</translation>
    </message>
    <message>
        <source>The outline of %1 would cross or touch itself.</source>
        <translation>Le contour de %1 se croiserait ou se toucherait.</translation>
    </message>
    <message>
        <source>The outline of %1 would enclose nothing.</source>
        <translation>Le contour de %1 n’enfermerait rien.</translation>
    </message>
    <message>
        <source>%1 would not lie inside %2 any more.</source>
        <translation>%1 ne serait plus à l’intérieur de %2.</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that is fixed to %2.</source>
        <translation>Le tronçon en chevaucherait un autre de %1 qui est fixé à %2.</translation>
    </message>
    <message>
        <source>The stretch would overlap the seam of %1 and %2.</source>
        <translation>Le tronçon chevaucherait la couture de %1 et %2.</translation>
    </message>
    <message>
        <source>The two sides of the seam would overlap.</source>
        <translation>Les deux côtés de la couture se chevaucheraient.</translation>
    </message>
    <message>
        <source>Change the length of a stretch of %1</source>
        <translation>Modifier la longueur d’un tronçon de %1</translation>
    </message>
    <message>
        <source>Move an end of a fixation of %1</source>
        <translation>Déplacer un bout d’une fixation de %1</translation>
    </message>
    <message>
        <source>Re-link a seam to its mirror image</source>
        <translation>Relier une couture à son image miroir</translation>
    </message>
    <message>
        <source>Release a seam from its mirror image</source>
        <translation>Libérer une couture de son image miroir</translation>
    </message>
    <message>
        <source>another element had the same number; give this one a number of its own</source>
        <translation>un autre élément avait le même numéro&#x202f;; donnez à celui-ci son propre numéro</translation>
    </message>
    <message>
        <source>Take %1 elements from another version</source>
        <translation>Reprendre %1 éléments d’une autre version</translation>
    </message>
    <message>
        <source>Take %1 from another version</source>
        <translation>Reprendre %1 d’une autre version</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is not an ordinary file</source>
        <translation>impossible d’écrire «&#x202f;%1&#x202f;»&#x202f;: ce n’est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>a file that the design uses cannot be read (%1)</source>
        <translation>impossible de lire un fichier que le modèle utilise (%1)</translation>
    </message>
    <message>
        <source>a file of the project cannot be written out (%1)</source>
        <translation>impossible d’extraire un fichier du projet (%1)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be opened or made</source>
        <translation>impossible d’ouvrir ou de créer «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is in use by another program</source>
        <translation>«&#x202f;%1&#x202f;» est utilisé par un autre programme</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged (%2)</source>
        <translation>«&#x202f;%1&#x202f;» est endommagé (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read or written (%2)</source>
        <translation>impossible de lire ou d’écrire «&#x202f;%1&#x202f;» (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is closed</source>
        <translation>«&#x202f;%1&#x202f;» est fermé</translation>
    </message>
    <message>
        <source>%1 cannot be stored: it holds a number that is none, or text in an unknown encoding</source>
        <translation>impossible d’enregistrer %1&#x202f;: il contient un nombre qui n’en est pas un, ou un texte au codage inconnu</translation>
    </message>
    <message>
        <source>there is a file &quot;%1&quot; already</source>
        <translation>il y a déjà un fichier «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no Bolster project</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un projet Bolster</translation>
    </message>
    <message>
        <source>there is not enough memory for this project</source>
        <translation>la mémoire ne suffit pas pour ce projet</translation>
    </message>
    <message>
        <source>an edit of the project cannot be read any more</source>
        <translation>une modification du projet n’est plus lisible</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name for a file of a project</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un nom pour un fichier de projet</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was made by a newer Bolster (version %2 of the format, this program knows %3); update the program</source>
        <translation>«&#x202f;%1&#x202f;» vient d’un Bolster plus récent (version %2 du format, ce programme connaît %3)&#x202f;; mettez le programme à jour</translation>
    </message>
    <message>
        <source>&quot;%1&quot; says that it has version %2 of the format, which never was</source>
        <translation>«&#x202f;%1&#x202f;» dit avoir la version %2 du format, qui n’a jamais existé</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the journal of a running program, or of one that crashed, not a project file</source>
        <translation>«&#x202f;%1&#x202f;» est le journal d’un programme en cours ou planté, pas un fichier de projet</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: it is %2 bytes long and should have %3</source>
        <translation>«&#x202f;%1&#x202f;» est endommagé&#x202f;: il fait %2 octets et devrait en faire %3</translation>
    </message>
    <message>
        <source>a temporary folder cannot be made (%1)</source>
        <translation>impossible de créer un dossier temporaire (%1)</translation>
    </message>
    <message>
        <source>a temporary file cannot be made (%1)</source>
        <translation>impossible de créer un fichier temporaire (%1)</translation>
    </message>
    <message>
        <source>nothing in &quot;%1&quot; can be saved</source>
        <translation>rien dans «&#x202f;%1&#x202f;» ne peut être récupéré</translation>
    </message>
    <message>
        <source>%1 versions were saved</source>
        <translation>%1 versions ont été récupérées</translation>
    </message>
    <message>
        <source>lost: versions %1 to %2</source>
        <translation>perdu&#x202f;: versions %1 à %2</translation>
    </message>
    <message>
        <source>Saved version</source>
        <translation>Version récupérée</translation>
    </message>
    <message>
        <source>version %1 was saved without the edits before it</source>
        <translation>la version %1 a été récupérée sans les modifications qui la précèdent</translation>
    </message>
    <message>
        <source>lost: the names of %1 versions</source>
        <translation>perdu&#x202f;: les noms de %1 versions</translation>
    </message>
    <message>
        <source>lost: the file &quot;%1&quot;</source>
        <translation>perdu&#x202f;: le fichier «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>the tables of &quot;%1&quot; are not those of a Bolster project</source>
        <translation>les tables de «&#x202f;%1&#x202f;» ne sont pas celles d’un projet Bolster</translation>
    </message>
    <message>
        <source>a checksum is incomplete</source>
        <translation>une somme de contrôle est incomplète</translation>
    </message>
    <message>
        <source>another window has it</source>
        <translation>une autre fenêtre l’utilise</translation>
    </message>
    <message>
        <source>must be a list of pairs in braces, with patch and fabric</source>
        <translation>doit être une liste de paires entre accolades, avec patch et fabric</translation>
    </message>
    <message>
        <source>must be a pair in braces, with patch and fabric</source>
        <translation>doit être une paire entre accolades, avec patch et fabric</translation>
    </message>
    <message>
        <source>there is no colourway %1; the patches show their own fabrics</source>
        <translation>il n’y a pas de coloris %1&#x202f;; les pièces montrent leurs propres tissus</translation>
    </message>
    <message>
        <source>%1 has a fabric in this colourway already; remove one of the two</source>
        <translation>%1 a déjà un tissu dans ce coloris&#x202f;; supprimez l’un des deux</translation>
    </message>
    <message>
        <source>what it says of missing patches and fabrics is left out</source>
        <translation>ce qu’il dit de pièces et tissus manquants est omis</translation>
    </message>
    <message>
        <source>Make %1 of %2</source>
        <translation>Faire %1 en %2</translation>
    </message>
    <message>
        <source>Make %1 patches of %2</source>
        <translation>Faire %1 pièces en %2</translation>
    </message>
    <message>
        <source>Add colourway %1</source>
        <translation>Ajouter le coloris %1</translation>
    </message>
    <message>
        <source>Change what %1 shows</source>
        <translation>Modifier ce que %1 montre</translation>
    </message>
    <message>
        <source>Change what %1 patches show</source>
        <translation>Modifier ce que %1 pièces montrent</translation>
    </message>
    <message>
        <source>Show no colourway</source>
        <translation>N’afficher aucun coloris</translation>
    </message>
    <message>
        <source>Show colourway %1</source>
        <translation>Afficher le coloris %1</translation>
    </message>
    <message>
        <source>A stretch of %1 that is sewn, fixed or trimmed would have no length.</source>
        <translation>Un tronçon de %1 cousu, fixé ou avec finition n’aurait pas de longueur.</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that has a trim.</source>
        <translation>Le tronçon en chevaucherait un autre de %1 qui a une finition.</translation>
    </message>
    <message>
        <source>Add a trim</source>
        <translation>Ajouter une finition</translation>
    </message>
    <message>
        <source>Move an end of a trim of %1</source>
        <translation>Déplacer un bout d’une finition de %1</translation>
    </message>
    <message>
        <source>Change the trim of %1 seams</source>
        <translation>Modifier la finition de %1 coutures</translation>
    </message>
    <message>
        <source>Change the trim of %1</source>
        <translation>Modifier la finition de %1</translation>
    </message>
    <message>
        <source>A part of this stretch of %1 has a trim already: change that one, or choose another stretch.</source>
        <translation>Une partie de ce tronçon de %1 a déjà une finition&#x202f;: modifiez celle-ci, ou choisissez un autre tronçon.</translation>
    </message>
    <message>
        <source>Trim the edge of %1</source>
        <translation>Ajouter une finition au bord de %1</translation>
    </message>
    <message>
        <source>%1: the file cannot be read any further; it has changed, or its disk is gone</source>
        <translation>%1&#x202f;: impossible de lire la suite du fichier&#x202f;; il a changé, ou son disque n’est plus là</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a picture that can be read; PNG, JPEG, TIFF and OpenEXR can</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas une image lisible&#x202f;; PNG, JPEG, TIFF et OpenEXR le sont</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 by %3 pixels, and at most 64 million are read; make the picture smaller in a picture editor</source>
        <translation>«&#x202f;%1&#x202f;» fait %2 sur %3 pixels, et 64 millions au plus sont lus&#x202f;; réduisez l’image dans un éditeur d’images</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a kind of picture whose colours cannot be read; save it as PNG in a picture editor</source>
        <translation>«&#x202f;%1&#x202f;» est un type d’image aux couleurs illisibles&#x202f;; enregistrez-la en PNG dans un éditeur d’images</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged or incomplete; copy it again from where it came from, or save it again in a picture editor</source>
        <translation>«&#x202f;%1&#x202f;» est endommagé ou incomplet&#x202f;; recopiez-le depuis son origine, ou réenregistrez-le dans un éditeur d’images</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which reads pictures for Bolster, cannot be started; install Bolster again</source>
        <translation>le programme «&#x202f;%1&#x202f;», qui lit les images pour Bolster, ne démarre pas&#x202f;; réinstallez Bolster</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes too long to read; save it as PNG in a picture editor</source>
        <translation>«&#x202f;%1&#x202f;» est trop long à lire&#x202f;; enregistrez-le en PNG dans un éditeur d’images</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be decoded: it is damaged or incomplete, or needs too much memory; save it again as PNG in a picture editor</source>
        <translation>impossible de décoder «&#x202f;%1&#x202f;»&#x202f;: il est endommagé ou incomplet, ou demande trop de mémoire&#x202f;; réenregistrez-le en PNG dans un éditeur d’images</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this picture</source>
        <translation>%1&#x202f;: la mémoire ne suffit pas pour cette image</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this file</source>
        <translation>%1&#x202f;: la mémoire ne suffit pas pour ce fichier</translation>
    </message>
    <message>
        <source>%1: the line is too long</source>
        <translation>%1&#x202f;: la ligne est trop longue</translation>
    </message>
    <message>
        <source>both have a file &quot;%1&quot;, and they are different: save under another name</source>
        <translation>les deux ont un fichier «&#x202f;%1&#x202f;», et ils sont différents&#x202f;: enregistrez sous un autre nom</translation>
    </message>
    <message>
        <source>there is another project in the file now</source>
        <translation>il y a maintenant un autre projet dans le fichier</translation>
    </message>
    <message>
        <source>the last edits are not on the disk yet</source>
        <translation>les dernières modifications ne sont pas encore sur le disque</translation>
    </message>
    <message>
        <source>Change the stitching of %1</source>
        <translation>Modifier la surpiqûre de %1</translation>
    </message>
    <message>
        <source>Change the piping of %1</source>
        <translation>Modifier le passepoil de %1</translation>
    </message>
    <message>
        <source>Change the seam allowance of %1</source>
        <translation>Modifier la marge de couture de %1</translation>
    </message>
    <message>
        <source>Change the valley of %1</source>
        <translation>Modifier le creux de %1</translation>
    </message>
    <message>
        <source>there is no fabric in &quot;%1&quot;</source>
        <translation>il n’y a pas de tissu dans «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>the design uses &quot;%1&quot; itself; choose another name</source>
        <translation>le modèle lui-même utilise «&#x202f;%1&#x202f;»&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>there is not enough memory to show this fabric</source>
        <translation>la mémoire ne suffit pas pour montrer ce tissu</translation>
    </message>
    <message>
        <source>Replace fabric %1 by %2</source>
        <translation>Remplacer le tissu %1 par %2</translation>
    </message>
    <message>
        <source>Change the limits of %1</source>
        <translation>Modifier les limites de %1</translation>
    </message>
    <message>
        <source>Change the look of %1</source>
        <translation>Modifier l’aspect de %1</translation>
    </message>
    <message>
        <source>Change the second colour of %1</source>
        <translation>Modifier la seconde couleur de %1</translation>
    </message>
    <message>
        <source>Change the kind of %1</source>
        <translation>Modifier le type de %1</translation>
    </message>
    <message>
        <source>there is no place for the files of this project</source>
        <translation>il n’y a pas d’endroit pour les fichiers de ce projet</translation>
    </message>
    <message>
        <source>A side of this seam does not end at corners: its length cannot be changed alone.</source>
        <translation>Un côté de cette couture ne finit pas à des coins&#x202f;: sa longueur ne peut pas être modifiée seule.</translation>
    </message>
    <message>
        <source>These edges cannot have this length: they hang together.</source>
        <translation>Ces bords ne peuvent pas avoir cette longueur&#x202f;: ils se tiennent.</translation>
    </message>
    <message>
        <source>Change the length of an edge of %1</source>
        <translation>Modifier la longueur d’un bord de %1</translation>
    </message>
    <message>
        <source>Change the length of %1 edges</source>
        <translation>Modifier la longueur de %1 bords</translation>
    </message>
    <message>
        <source>Make %1 edges equally long</source>
        <translation>Rendre %1 bords égaux</translation>
    </message>
    <message>
        <source>Make the sides of a seam equally long</source>
        <translation>Rendre égaux les côtés d’une couture</translation>
    </message>
    <message>
        <source>Make the sides of %1 seams equally long</source>
        <translation>Rendre égaux les côtés de %1 coutures</translation>
    </message>
    <message>
        <source>There is a &quot;%1&quot; already: this one is called &quot;%2&quot;.</source>
        <translation>Il y a déjà «&#x202f;%1&#x202f;»&#x202f;: celui-ci s’appelle «&#x202f;%2&#x202f;».</translation>
    </message>
    <message>
        <source>Change the size of %1 patches</source>
        <translation>Modifier la taille de %1 pièces</translation>
    </message>
    <message>
        <source>%1: the rows hold more than the header of the file says; what is too much in each was left out</source>
        <translation>%1&#x202f;: les lignes contiennent plus que ne dit l’en-tête du fichier&#x202f;; le surplus de chacune a été omis</translation>
    </message>
    <message>
        <source>this changes more at once than can be stored: at most %1 MB, and %2 keys; do it in parts</source>
        <translation>cela modifie plus à la fois que ce qui peut être enregistré&#x202f;: au plus %1&#xa0;Mo et %2 clés&#x202f;; procédez par parties</translation>
    </message>
    <message>
        <source>&quot;%1&quot; unpacks to more than any project; it was not made by Bolster, or is damaged</source>
        <translation>«&#x202f;%1&#x202f;» est plus grand qu’aucun projet une fois décompressé&#x202f;; il ne vient pas de Bolster, ou il est endommagé</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which recovers projects for Bolster, cannot be started; install Bolster again</source>
        <translation>le programme «&#x202f;%1&#x202f;», qui récupère les projets pour Bolster, ne démarre pas&#x202f;; réinstallez Bolster</translation>
    </message>
    <message>
        <source>nothing in &quot;%1&quot; can be saved: it is damaged in a way that takes too much time or memory</source>
        <translation>rien dans «&#x202f;%1&#x202f;» ne peut être récupéré&#x202f;: il est endommagé au point de demander trop de temps ou de mémoire</translation>
    </message>
    <message>
        <source>lost: the table &quot;%1&quot;, which is missing or has other columns than it should</source>
        <translation>perdu&#x202f;: la table «&#x202f;%1&#x202f;», qui manque ou n’a pas les colonnes voulues</translation>
    </message>
    <message>
        <source>lost: %1 more such gaps</source>
        <translation>perdu&#x202f;: encore %1 lacunes de ce genre</translation>
    </message>
    <message>
        <source>what comes after version %1 takes too long to recover</source>
        <translation>ce qui suit la version %1 est trop long à récupérer</translation>
    </message>
    <message>
        <source>the edit of version %1 does not lead to the design that was kept with it</source>
        <translation>la modification de la version %1 ne mène pas au modèle conservé avec elle</translation>
    </message>
    <message>
        <source>it pushes nothing: no part of the frame lies under the cover</source>
        <translation>il ne pousse rien&#x202f;: aucune partie de l’armature n’est sous la housse</translation>
    </message>
    <message>
        <source>contact looks at the frame in steps of %1 mm; something of these parts is thinner, so that the cover may pass through: %2; make it thicker</source>
        <translation>le contact examine l’armature par pas de %1&#xa0;mm&#x202f;; quelque chose y est plus mince dans ces parties, si bien que la housse peut traverser&#x202f;: %2&#x202f;; épaississez-le</translation>
    </message>
    <message>
        <source>contact does nothing: in steps of %1 mm it finds no inside of the frame, which is thinner than that, or so open that it has none; close the frame, or make it thicker</source>
        <translation>le contact ne fait rien&#x202f;: par pas de %1&#xa0;mm, il ne trouve pas d’intérieur à l’armature, qui est plus mince, ou trop ouverte pour en avoir un&#x202f;; fermez l’armature, ou épaississez-la</translation>
    </message>
    <message>
        <source>%1 lies in folds: there is more cloth than room for it</source>
        <translation>%1 fait des plis&#x202f;: il y a plus de tissu que de place</translation>
    </message>
    <message>
        <source>%1 floats free: nothing holds it, and it is sewn to nothing that is held</source>
        <translation>%1 flotte librement&#x202f;: rien ne la tient, et elle n’est cousue à rien qui soit tenu</translation>
    </message>
    <message>
        <source>%1 holds the cloth %2 mm off the frame</source>
        <translation>%1 tient le tissu à %2&#xa0;mm de l’armature</translation>
    </message>
    <message>
        <source>The seam of %1 and %2 has %3 % ease: it puckers above %4 %</source>
        <translation>La couture de %1 et %2 a %3&#x202f;% d’embu&#x202f;: au-delà de %4&#x202f;%, elle fronce</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations.</source>
        <translation>La surface s’est échappée après %1 itérations.</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations: %2 holds it %3 mm from everything else. Bring that curve nearer.</source>
        <translation>La surface s’est échappée après %1 itérations&#x202f;: %2 la tient à %3&#xa0;mm de tout le reste. Rapprochez cette courbe.</translation>
    </message>
    <message>
        <source>The equations of the cover could not be solved: %1 is degenerate or its numbers are too large. Check its outline and its fabric.</source>
        <translation>Les équations de la housse n’ont pas pu être résolues&#x202f;: %1 est dégénérée ou ses nombres sont trop grands. Vérifiez son contour et son tissu.</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations: the pressure of %2 (%3) is too high for its fabric. Lower it.</source>
        <translation>La surface s’est échappée après %1 itérations&#x202f;: la pression de %2 (%3) est trop forte pour son tissu. Réduisez-la.</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations, most likely because of %2. Check the size of that patch, its pressure and its fabric.</source>
        <translation>La surface s’est échappée après %1 itérations, sans doute à cause de %2. Vérifiez la taille de cette pièce, sa pression et son tissu.</translation>
    </message>
    <message>
        <source>Change the material of %1</source>
        <translation>Modifier le matériau de %1</translation>
    </message>
    <message>
        <source>Show a part of %1</source>
        <translation>Afficher une partie de %1</translation>
    </message>
    <message>
        <source>Hide a part of %1</source>
        <translation>Masquer une partie de %1</translation>
    </message>
    <message>
        <source>Show all parts of %1</source>
        <translation>Afficher toutes les parties de %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a link to &quot;%2&quot; now</source>
        <translation>«&#x202f;%1&#x202f;» est maintenant un lien vers «&#x202f;%2&#x202f;»</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was changed by another program</source>
        <translation>«&#x202f;%1&#x202f;» a été modifié par un autre programme</translation>
    </message>
    <message>
        <source>somebody else has changed &quot;%1&quot; since it was opened here</source>
        <translation>quelqu’un d’autre a modifié «&#x202f;%1&#x202f;» depuis son ouverture ici</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is another project now</source>
        <translation>«&#x202f;%1&#x202f;» est maintenant un autre projet</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be renamed (%2)</source>
        <translation>impossible de renommer «&#x202f;%1&#x202f;» (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: the content number %2 cannot be read</source>
        <translation>«&#x202f;%1&#x202f;» est endommagé&#x202f;: le contenu numéro %2 est illisible</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: a row holds something of another kind than it should</source>
        <translation>«&#x202f;%1&#x202f;» est endommagé&#x202f;: une ligne contient une donnée d’un autre type que prévu</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: row %2 of the table &quot;%3&quot; contradicts others</source>
        <translation>«&#x202f;%1&#x202f;» est endommagé&#x202f;: la ligne %2 de la table «&#x202f;%3&#x202f;» en contredit d’autres</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: parts of the file are not what was written</source>
        <translation>«&#x202f;%1&#x202f;» est endommagé&#x202f;: des parties du fichier ne sont pas ce qui a été écrit</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: rows are missing, or there are some too many</source>
        <translation>«&#x202f;%1&#x202f;» est endommagé&#x202f;: il manque des lignes, ou il y en a trop</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: the edits up to number %2 do not lead to the design that was stored with them</source>
        <translation>«&#x202f;%1&#x202f;» est endommagé&#x202f;: les modifications jusqu’au numéro %2 ne mènent pas au modèle enregistré avec elles</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: row %2 of the table &quot;%3&quot; is not what was written</source>
        <translation>«&#x202f;%1&#x202f;» est endommagé&#x202f;: la ligne %2 de la table «&#x202f;%3&#x202f;» n’est pas ce qui a été écrit</translation>
    </message>
    <message>
        <source>there is no picture to write</source>
        <translation>il n’y a pas d’image à écrire</translation>
    </message>
    <message>
        <source>%1: a face has %2 corners, and at most %3 are read; have it split into triangles by the program that has made the file</source>
        <translation>%1&#x202f;: une face a %2 coins, et %3 au plus sont lus&#x202f;; faites-la diviser en triangles par le programme qui a créé le fichier</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: no file can be made in &quot;%2&quot;; choose another folder</source>
        <translation>impossible d’écrire «&#x202f;%1&#x202f;»&#x202f;: aucun fichier ne peut être créé dans «&#x202f;%2&#x202f;»&#x202f;; choisissez un autre dossier</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>interrompu</translation>
    </message>
    <message>
        <source>at most %1 cushions push; this one and those after it are left out</source>
        <translation>%1 rembourrages au plus poussent&#x202f;; celui-ci et les suivants sont omis</translation>
    </message>
    <message>
        <source>the picture cannot be encoded (%1)</source>
        <translation>l’image ne peut pas être codée (%1)</translation>
    </message>
    <message>
        <source>a smallest detail of %1 mm is too fine for a frame as large as this (%2 million cubes of it, and %3 are the limit), so the cushion is left out; take at least %4 mm</source>
        <translation>un plus petit détail de %1&#xa0;mm est trop fin pour une armature aussi grande (%2 millions de cubes, la limite est de %3), le rembourrage est donc omis&#x202f;; prenez au moins %4&#xa0;mm</translation>
    </message>
    <message>
        <source>something of these parts of the frame is thinner than the smallest detail of the padding, %1 mm, so that it may have gaps there: %2; take a smaller detail</source>
        <translation>quelque chose dans ces parties de l’armature est plus mince que le plus petit détail de la garniture, %1&#xa0;mm, si bien qu’elle peut y avoir des trous&#x202f;: %2&#x202f;; prenez un détail plus petit</translation>
    </message>
    <message>
        <source>it pushes nothing: with a smallest detail of %1 mm there is no inside of the frame, which is thinner than that, or so open that it has none; take a smaller detail, or close the frame</source>
        <translation>il ne pousse rien&#x202f;: avec un plus petit détail de %1&#xa0;mm, l’armature n’a pas d’intérieur&#x202f;; elle est plus mince, ou trop ouverte pour en avoir un&#x202f;; prenez un détail plus petit, ou fermez l’armature</translation>
    </message>
    <message>
        <source>Change the slanted faces of %1</source>
        <translation>Modifier les faces obliques de %1</translation>
    </message>
    <message>
        <source>Change the smallest detail of %1</source>
        <translation>Modifier le plus petit détail de %1</translation>
    </message>
    <message>
        <source>the log of &quot;%1&quot; is damaged: the last edits cannot be read</source>
        <translation>le journal de «&#x202f;%1&#x202f;» est endommagé&#x202f;: les dernières modifications sont illisibles</translation>
    </message>
    <message>
        <source>the kind %1 is unknown; there are %2 and %3</source>
        <translation>le type %1 est inconnu&#x202f;; il y a %2 et %3</translation>
    </message>
    <message>
        <source>its label finds no room: make the words shorter, or put it elsewhere</source>
        <translation>son étiquette ne trouve pas de place&#x202f;: raccourcissez le texte, ou placez-la ailleurs</translation>
    </message>
    <message>
        <source>its cut lines meet here: make the allowance smaller</source>
        <translation>ses lignes de coupe se rejoignent ici&#x202f;: réduisez la marge</translation>
    </message>
    <message>
        <source>a notch of %1 mm reaches the sewing line, which is %2 mm away: make it shallower, or the allowance wider</source>
        <translation>un cran de %1&#xa0;mm atteint la ligne de couture, à %2&#xa0;mm&#x202f;: faites-le moins profond, ou élargissez la marge</translation>
    </message>
    <message>
        <source>nothing is sewn where it is, so it has no partner</source>
        <translation>rien n’est cousu à cet endroit, il n’a donc pas de vis-à-vis</translation>
    </message>
    <message>
        <source>it has no partner on the other side of its seam: another notch is too near there</source>
        <translation>il n’a pas de vis-à-vis de l’autre côté de sa couture&#x202f;: un autre cran y est trop proche</translation>
    </message>
    <message>
        <source>it is %1 mm wide across the grain, but &quot;%2&quot; only %3 mm: split it, or turn its grain</source>
        <translation>elle fait %1&#xa0;mm de large en travers du droit-fil, mais «&#x202f;%2&#x202f;» seulement %3&#xa0;mm&#x202f;: divisez-la, ou tournez son droit-fil</translation>
    </message>
    <message>
        <source>an inner corner of %1 degrees is too sharp for its seam allowances: make them smaller there, or the corner wider</source>
        <translation>un coin rentrant de %1 degrés est trop aigu pour ses marges de couture&#x202f;: réduisez-les à cet endroit, ou ouvrez le coin</translation>
    </message>
    <message>
        <source>There is no such place on an outline.</source>
        <translation>Il n’y a pas de tel endroit sur un contour.</translation>
    </message>
    <message>
        <source>A part of this stretch of %1 has a seam allowance of its own already: change that one, or choose another stretch.</source>
        <translation>Une partie de ce tronçon de %1 a déjà sa propre marge de couture&#x202f;: modifiez celle-ci, ou choisissez un autre tronçon.</translation>
    </message>
    <message>
        <source>There is a notch of %1 at this place already.</source>
        <translation>Il y a déjà un cran de %1 à cet endroit.</translation>
    </message>
    <message>
        <source>This corner of %1 has a join of its own already.</source>
        <translation>Ce coin de %1 a déjà sa propre forme.</translation>
    </message>
    <message>
        <source>Change the seam allowance of %1 patches</source>
        <translation>Modifier la marge de couture de %1 pièces</translation>
    </message>
    <message>
        <source>Change the seam allowance of an edge of %1</source>
        <translation>Modifier la marge de couture d’un bord de %1</translation>
    </message>
    <message>
        <source>Change a corner of the cut line of %1</source>
        <translation>Modifier un coin de la ligne de coupe de %1</translation>
    </message>
    <message>
        <source>Add a notch to %1</source>
        <translation>Ajouter un cran à %1</translation>
    </message>
    <message>
        <source>Move a notch</source>
        <translation>Déplacer un cran</translation>
    </message>
    <message>
        <source>Move the join of a corner</source>
        <translation>Déplacer la forme d’un coin</translation>
    </message>
    <message>
        <source>A drill hole must lie inside its patch.</source>
        <translation>Un perçage doit être à l’intérieur de sa pièce.</translation>
    </message>
    <message>
        <source>Move %1 drill holes</source>
        <translation>Déplacer %1 perçages</translation>
    </message>
    <message>
        <source>Move the label of %1</source>
        <translation>Déplacer l’étiquette de %1</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that has its own seam allowance.</source>
        <translation>Le tronçon en chevaucherait un autre de %1 qui a sa propre marge de couture.</translation>
    </message>
    <message>
        <source>Give an edge its own seam allowance</source>
        <translation>Donner à un bord sa propre marge de couture</translation>
    </message>
    <message>
        <source>Change a corner of the cut line</source>
        <translation>Modifier un coin de la ligne de coupe</translation>
    </message>
    <message>
        <source>Add drill hole %1</source>
        <translation>Ajouter le perçage %1</translation>
    </message>
    <message>
        <source>Change the diameter of %1</source>
        <translation>Modifier le diamètre de %1</translation>
    </message>
    <message>
        <source>Change the notches of %1</source>
        <translation>Modifier les crans de %1</translation>
    </message>
    <message>
        <source>Change the automatic notches</source>
        <translation>Modifier les crans automatiques</translation>
    </message>
    <message>
        <source>Add a notch</source>
        <translation>Ajouter un cran</translation>
    </message>
    <message>
        <source>Change how %1 is cut</source>
        <translation>Modifier la coupe de %1</translation>
    </message>
    <message>
        <source>Change how the pattern is cut</source>
        <translation>Modifier la coupe du patron</translation>
    </message>
    <message>
        <source>Add internal line %1</source>
        <translation>Ajouter la ligne interne %1</translation>
    </message>
    <message>
        <source>Change the purpose of %1</source>
        <translation>Modifier l’usage de %1</translation>
    </message>
    <message>
        <source>Change the ease of %1</source>
        <translation>Modifier l’embu de %1</translation>
    </message>
    <message>
        <source>is %1, but must be a whole number; %2 are cut</source>
        <translation>vaut %1, mais doit être un nombre entier&#x202f;; %2 sont coupées</translation>
    </message>
    <message>
        <source>%1 is an allowance of a part of this stretch already; remove one of the two, or make their stretches meet</source>
        <translation>%1 est déjà une marge d’une partie de ce tronçon&#x202f;; supprimez l’une des deux, ou faites se rejoindre leurs tronçons</translation>
    </message>
    <message>
        <source>the hole lies outside of &quot;%1&quot;; move it inside</source>
        <translation>le trou est hors de «&#x202f;%1&#x202f;»&#x202f;; déplacez-le à l’intérieur</translation>
    </message>
    <message>
        <source>its sides are %1 mm and %2 mm long: true the seam, or say in its properties how much ease is wanted</source>
        <translation>ses côtés mesurent %1&#xa0;mm et %2&#xa0;mm&#x202f;: égalisez-les, ou indiquez dans ses propriétés l’embu voulu</translation>
    </message>
    <message>
        <source>its sides are %1 mm and %2 mm long, but the second one shall be longer by %3 mm: true the seam, or change the ease in its properties</source>
        <translation>ses côtés mesurent %1&#xa0;mm et %2&#xa0;mm, mais le second doit être plus long de %3&#xa0;mm&#x202f;: égalisez-les, ou modifiez l’embu dans ses propriétés</translation>
    </message>
    <message>
        <source>The mouth of a dart must be at least 1 mm wide.</source>
        <translation>L’ouverture d’une pince doit faire au moins 1&#xa0;mm de large.</translation>
    </message>
    <message>
        <source>The tip of a dart must lie inside its patch, at least 5 mm from its mouth.</source>
        <translation>La pointe d’une pince doit être dans sa pièce, à au moins 5&#xa0;mm de son ouverture.</translation>
    </message>
    <message>
        <source>The legs of the dart would cross the outline of %1: put its tip elsewhere.</source>
        <translation>Les côtés de la pince croiseraient le contour de %1&#x202f;: placez sa pointe ailleurs.</translation>
    </message>
    <message>
        <source>Add a dart to %1</source>
        <translation>Ajouter une pince à %1</translation>
    </message>
    <message>
        <source>Select the seam of a dart.</source>
        <translation>Sélectionnez la couture d’une pince.</translation>
    </message>
    <message>
        <source>Without this dart the outline of %1 would cross itself.</source>
        <translation>Sans cette pince, le contour de %1 se croiserait.</translation>
    </message>
    <message>
        <source>Move a dart of %1</source>
        <translation>Déplacer une pince de %1</translation>
    </message>
    <message>
        <source>there is no piece in it</source>
        <translation>il n’y a aucune pièce dedans</translation>
    </message>
    <message>
        <source>Import a pattern of %1 pieces</source>
        <translation>Importer un patron de %1 pièces</translation>
    </message>
    <message>
        <source>%1 is left out: its outline crosses itself or encloses nothing</source>
        <translation>%1 est omise&#x202f;: son contour se croise ou n’enferme rien</translation>
    </message>
    <message>
        <source>%1: %2 notches or lines belong to nothing and are left out</source>
        <translation>%1&#x202f;: %2 crans ou lignes n’appartiennent à rien et sont omis</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 points)</source>
        <translation>%1&#x202f;: il contient plus de dessin qu’un patron ne peut en avoir (plus de %2 points)</translation>
    </message>
    <message>
        <source>%1: the file is larger than a pattern can be (%2 MB)</source>
        <translation>%1&#x202f;: le fichier est plus grand qu’un patron ne peut l’être (%2&#xa0;Mo)</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a group code of DXF</source>
        <translation>%1&#x202f;: «&#x202f;%2&#x202f;» n’est pas un code de groupe DXF</translation>
    </message>
    <message>
        <source>%1: the file ends in the middle of something</source>
        <translation>%1&#x202f;: le fichier finit au milieu de quelque chose</translation>
    </message>
    <message>
        <source>%1 is not a DXF file: it has no sections</source>
        <translation>%1 n’est pas un fichier DXF&#x202f;: il n’a pas de sections</translation>
    </message>
    <message>
        <source>%1 is not an SVG file</source>
        <translation>%1 n’est pas un fichier SVG</translation>
    </message>
    <message>
        <source>%1: this is not well-formed XML (%2)</source>
        <translation>%1&#x202f;: ce n’est pas du XML bien formé (%2)</translation>
    </message>
    <message>
        <source>Sew %1 proposed seams</source>
        <translation>Coudre %1 coutures proposées</translation>
    </message>
    <message>
        <source>Remove a dart of %1</source>
        <translation>Supprimer une pince de %1</translation>
    </message>
    <message>
        <source>Move the tip of a dart of %1</source>
        <translation>Déplacer la pointe d’une pince de %1</translation>
    </message>
    <message>
        <source>Opened there, the outline of %1 would cross itself.</source>
        <translation>Ouvert là, le contour de %1 se croiserait.</translation>
    </message>
    <message>
        <source>The legs of the dart must be of one length to be rotated: drag its tip onto the dotted line.</source>
        <translation>Pour pivoter la pince, ses côtés doivent être égaux&#x202f;: faites glisser sa pointe sur la ligne pointillée.</translation>
    </message>
    <message>
        <source>A dart is rotated to a place at least 5 mm from its mouth.</source>
        <translation>Une pince se pivote vers un endroit à au moins 5&#xa0;mm de son ouverture.</translation>
    </message>
    <message>
        <source>The line from the tip of the dart to there would leave %1.</source>
        <translation>La ligne de la pointe de la pince à cet endroit sortirait de %1.</translation>
    </message>
    <message>
        <source>%1 lies across the line from the tip of the dart to there: move it, or rotate the dart elsewhere.</source>
        <translation>%1 est en travers de la ligne de la pointe de la pince à cet endroit&#x202f;: déplacez cet élément, ou pivotez la pince ailleurs.</translation>
    </message>
    <message>
        <source>Rotate a dart of %1</source>
        <translation>Pivoter une pince de %1</translation>
    </message>
    <message>
        <source>Smooth outlines across ends of seams</source>
        <translation>Lisser des contours aux bouts de coutures</translation>
    </message>
    <message>
        <source>This seam ends in no corners: there is nothing to smooth.</source>
        <translation>Cette couture ne finit à aucun coin&#x202f;: il n’y a rien à lisser.</translation>
    </message>
    <message>
        <source>The outlines meet at more than 60° there: that is a corner, and stays one.</source>
        <translation>Les contours s’y rejoignent à plus de 60°&#x202f;: c’est un coin, et il le reste.</translation>
    </message>
    <message>
        <source>Sew earlier</source>
        <translation>Coudre plus tôt</translation>
    </message>
    <message>
        <source>Sew later</source>
        <translation>Coudre plus tard</translation>
    </message>
    <message>
        <source>Sew in the proposed order</source>
        <translation>Coudre dans l’ordre proposé</translation>
    </message>
    <message>
        <source>Change the zip of %1</source>
        <translation>Modifier la fermeture à glissière de %1</translation>
    </message>
    <message>
        <source>Change when %1 is sewn</source>
        <translation>Modifier l’étape de montage de %1</translation>
    </message>
    <message>
        <source>its sides have allowances of %1 mm and %2 mm: make them alike, or mind it when they are laid together</source>
        <translation>ses côtés ont des marges de %1&#xa0;mm et %2&#xa0;mm&#x202f;: égalisez-les, ou tenez-en compte en les superposant</translation>
    </message>
    <message>
        <source>This edge of %1 is not as long as that.</source>
        <translation>Ce bord de %1 n’est pas aussi long.</translation>
    </message>
    <message>
        <source>the pattern is so large that the edge length of its triangles becomes %1 mm; is the unit right?</source>
        <translation>le patron est si grand que la longueur d’arête de ses triangles devient %1&#xa0;mm&#x202f;; l’unité est-elle la bonne&#x202f;?</translation>
    </message>
    <message>
        <source>%1 is left out: it is %2 m large, the most is %3 m; is the unit right?</source>
        <translation>%1 est omise&#x202f;: elle mesure %2&#xa0;m, le maximum est de %3&#xa0;m&#x202f;; l’unité est-elle la bonne&#x202f;?</translation>
    </message>
    <message>
        <source>%1 is left out: its outline has fewer than three points</source>
        <translation>%1 est omise&#x202f;: son contour a moins de trois points</translation>
    </message>
    <message>
        <source>%1 is left out: of the %2 points of its outline no curve with at most %3 can be made</source>
        <translation>%1 est omise&#x202f;: des %2 points de son contour, on ne peut faire aucune courbe d’au plus %3</translation>
    </message>
    <message>
        <source>%1: its outline has more than %2 points and is simplified, by %3 mm at most</source>
        <translation>%1&#x202f;: son contour a plus de %2 points et est simplifié, de %3&#xa0;mm au plus</translation>
    </message>
    <message>
        <source>%1: its quantity &quot;%2&quot; is no number of pieces; it is cut once until somebody says how often</source>
        <translation>%1&#x202f;: sa quantité «&#x202f;%2&#x202f;» n’est pas un nombre de pièces&#x202f;; elle est coupée une fois jusqu’à indication contraire</translation>
    </message>
    <message>
        <source>%1: its quantity %2 is more than possible and becomes %3</source>
        <translation>%1&#x202f;: sa quantité %2 dépasse le possible et devient %3</translation>
    </message>
    <message>
        <source>%1: %2 drill holes are narrower than %3 mm or wider than %4 mm and become as wide as possible</source>
        <translation>%1&#x202f;: %2 perçages font moins de %3&#xa0;mm ou plus de %4&#xa0;mm et sont ramenés à la limite</translation>
    </message>
    <message>
        <source>%1 is left out: it would be a patch with mistakes</source>
        <translation>%1 est omise&#x202f;: ce serait une pièce avec des erreurs</translation>
    </message>
    <message>
        <source>%1: the file ends in the middle of its section %2, so it is not whole; get it once more</source>
        <translation>%1&#x202f;: le fichier finit au milieu de sa section %2, il n’est donc pas complet&#x202f;; procurez-vous-le de nouveau</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 groups)</source>
        <translation>%1&#x202f;: il contient plus de dessin qu’un patron ne peut en avoir (plus de %2 groupes)</translation>
    </message>
    <message>
        <source>%1: %2 is larger than any pattern (%3)</source>
        <translation>%1&#x202f;: %2 est plus grand que tout patron (%3)</translation>
    </message>
    <message>
        <source>the mark at the end of the file (EOF) is missing: look whether everything is there</source>
        <translation>la marque de fin du fichier (EOF) manque&#x202f;: vérifiez que tout y est</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is inserted more often than a pattern needs (over %3 times)</source>
        <translation>%1&#x202f;: «&#x202f;%2&#x202f;» est inséré plus souvent qu’un patron n’en a besoin (plus de %3 fois)</translation>
    </message>
    <message>
        <source>%1: an element has more than %2 attributes</source>
        <translation>%1&#x202f;: un élément a plus de %2 attributs</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 elements)</source>
        <translation>%1&#x202f;: il contient plus de dessin qu’un patron ne peut en avoir (plus de %2 éléments)</translation>
    </message>
    <message>
        <source>%1: elements lie in each other more than %2 times</source>
        <translation>%1&#x202f;: des éléments sont imbriqués plus de %2 fois</translation>
    </message>
    <message>
        <source>&quot;%1&quot; would be replaced, which is needed; choose another name</source>
        <translation>«&#x202f;%1&#x202f;» serait remplacé, or il est nécessaire&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>there is no cover yet: nothing is sewn or solved</source>
        <translation>il n’y a pas encore de housse&#x202f;: rien n’est cousu ni calculé</translation>
    </message>
    <message>
        <source>there is not enough memory for this file</source>
        <translation>la mémoire ne suffit pas pour ce fichier</translation>
    </message>
    <message>
        <source>the cover cannot be made a file (%1)</source>
        <translation>la housse ne peut pas devenir un fichier (%1)</translation>
    </message>
    <message>
        <source>the cover is %1 mm thick and has %2 cm³</source>
        <translation>la housse a une épaisseur de %1&#xa0;mm et %2&#xa0;cm³</translation>
    </message>
    <message>
        <source>there is no room for foam between the frame and the cover</source>
        <translation>il n’y a pas de place pour de la mousse entre l’armature et la housse</translation>
    </message>
    <message>
        <source>the foam has %1 l and weighs %2 kg at %3 kg/m³</source>
        <translation>la mousse a %1&#xa0;l et pèse %2&#xa0;kg à %3&#xa0;kg/m³</translation>
    </message>
    <message>
        <source>there are neither fixation curves nor seams</source>
        <translation>il n’y a ni courbes de fixation ni coutures</translation>
    </message>
    <message>
        <source>The three places lie on a line: choose some that do not.</source>
        <translation>Les trois endroits sont alignés&#x202f;: choisissez-en d’autres.</translation>
    </message>
    <message>
        <source>The places are not as far from each other on the scan as where they belong: check the scale of the scan, and which is which.</source>
        <translation>Les endroits n’ont pas la même distance entre eux sur le scan qu’à leur place&#x202f;: vérifiez l’échelle du scan, et lequel est lequel.</translation>
    </message>
    <message>
        <source>The scan could not be aligned: there are not enough of its points where it would stand. Click other places, or bring back what is cut away of it.</source>
        <translation>Le scan n’a pas pu être aligné&#x202f;: trop peu de ses points sont là où il serait. Cliquez d’autres endroits, ou rétablissez ce qui en est découpé.</translation>
    </message>
    <message>
        <source>%1: the numbers of &quot;%2&quot; are not described as they must be: &quot;%3&quot;</source>
        <translation>%1&#x202f;: les nombres de «&#x202f;%2&#x202f;» ne sont pas décrits comme il faut&#x202f;: «&#x202f;%3&#x202f;»</translation>
    </message>
    <message>
        <source>%1: the file is damaged: something is said to be at byte %2, where nothing can be; copy it again, or export the scan anew</source>
        <translation>%1&#x202f;: le fichier est endommagé&#x202f;: quelque chose devrait être à l’octet %2, où rien ne peut être&#x202f;; recopiez-le, ou exportez de nouveau le scan</translation>
    </message>
    <message>
        <source>%1: the file is damaged: a checksum is wrong; copy it again, or export the scan anew</source>
        <translation>%1&#x202f;: le fichier est endommagé&#x202f;: une somme de contrôle est fausse&#x202f;; recopiez-le, ou exportez de nouveau le scan</translation>
    </message>
    <message>
        <source>%1 is not an E57 file</source>
        <translation>%1 n’est pas un fichier E57</translation>
    </message>
    <message>
        <source>%1: E57 of version %2 cannot be read, or its pages have another size than 1024; export the scan as E57 1.0</source>
        <translation>%1&#x202f;: l’E57 de version %2 n’est pas lisible, ou ses pages n’ont pas la taille 1024&#x202f;; exportez le scan en E57 1.0</translation>
    </message>
    <message>
        <source>%1: the pose of a scan is no rotation and translation</source>
        <translation>%1&#x202f;: la pose d’un scan n’est pas une rotation avec translation</translation>
    </message>
    <message>
        <source>%1: two scans are said to be at one place of the file; export them anew</source>
        <translation>%1&#x202f;: deux scans seraient au même endroit du fichier&#x202f;; exportez-les de nouveau</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; of the points is missing or no number of things</source>
        <translation>%1&#x202f;: «&#x202f;%2&#x202f;» des points manque ou n’est pas un nombre d’éléments</translation>
    </message>
    <message>
        <source>%1: the file is damaged: a packet of points is not as it must be; export the scan anew</source>
        <translation>%1&#x202f;: le fichier est endommagé&#x202f;: un paquet de points n’est pas comme il faut&#x202f;; exportez de nouveau le scan</translation>
    </message>
    <message>
        <source>%1: the points are packed by &quot;%2&quot;, which cannot be read; export the scan without an extension</source>
        <translation>%1&#x202f;: les points sont compressés par «&#x202f;%2&#x202f;», illisible&#x202f;; exportez le scan sans extension</translation>
    </message>
    <message>
        <source>%1: more is described in it than a scan can have</source>
        <translation>%1&#x202f;: il décrit plus qu’un scan ne peut avoir</translation>
    </message>
    <message>
        <source>%1: numbers that belong to one point lie too far from each other; export the scan anew</source>
        <translation>%1&#x202f;: des nombres d’un même point sont trop éloignés les uns des autres&#x202f;; exportez de nouveau le scan</translation>
    </message>
    <message>
        <source>%1: a document type is not expected here</source>
        <translation>%1&#x202f;: un type de document n’est pas attendu ici</translation>
    </message>
    <message>
        <source>%1 is not a LAS file</source>
        <translation>%1 n’est pas un fichier LAS</translation>
    </message>
    <message>
        <source>%1 is compressed (LAZ), which cannot be read: save it as LAS, for example with laszip or CloudCompare, or as E57</source>
        <translation>%1 est compressé (LAZ), donc illisible&#x202f;: enregistrez-le en LAS, par exemple avec laszip ou CloudCompare, ou en E57</translation>
    </message>
    <message>
        <source>%1: points of format %2 with %3 bytes cannot be read; save them as LAS 1.2 or 1.4</source>
        <translation>%1&#x202f;: les points au format %2 de %3 octets ne sont pas lisibles&#x202f;; enregistrez-les en LAS 1.2 ou 1.4</translation>
    </message>
    <message>
        <source>%1: its scale and offset make no points</source>
        <translation>%1&#x202f;: son échelle et son décalage ne donnent pas de points</translation>
    </message>
    <message>
        <source>%1: the points are said to begin within the header</source>
        <translation>%1&#x202f;: les points commenceraient dans l’en-tête</translation>
    </message>
    <message>
        <source>The second side ends inside an edge, so the first one was changed.</source>
        <translation>Le second côté finit à l’intérieur d’un bord, le premier a donc été modifié.</translation>
    </message>
    <message>
        <source>it has no triangle with an area</source>
        <translation>elle n’a aucun triangle avec une aire</translation>
    </message>
    <message>
        <source>%1 is left out: laid flat it would lie over itself. Divide it, or cut it in where it bulges most</source>
        <translation>%1 est omise&#x202f;: à plat, elle se recouvrirait. Divisez-la, ou entaillez-la là où elle est la plus bombée</translation>
    </message>
    <message>
        <source>the stretch does not lie on its outline any more. Sew or fix it anew.</source>
        <translation>le tronçon n’est plus sur son contour. Cousez-le ou fixez-le de nouveau.</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which reads such files for Bolster, cannot be started; install Bolster again</source>
        <translation>le programme «&#x202f;%1&#x202f;», qui lit ces fichiers pour Bolster, ne démarre pas&#x202f;; réinstallez Bolster</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes too long to read; export fewer parts of it, or triangles (OBJ, STL) instead</source>
        <translation>«&#x202f;%1&#x202f;» est trop long à lire&#x202f;; exportez-en moins de parties, ou plutôt des triangles (OBJ, STL)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be read: it is damaged, or needs too much memory; export it again, or fewer parts of it, from the program that it comes from</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas pu être lu&#x202f;: il est endommagé, ou demande trop de mémoire&#x202f;; exportez-le de nouveau, ou moins de ses parties, depuis le programme d’origine</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds no faces, and a frame needs some; export bodies or surfaces, not lines and points alone</source>
        <translation>«&#x202f;%1&#x202f;» ne contient pas de faces, et une armature en demande&#x202f;; exportez des corps ou des surfaces, pas seulement des lignes et des points</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than %2 triangles; export fewer parts of it, or coarser</source>
        <translation>«&#x202f;%1&#x202f;» a plus de %2 triangles&#x202f;; exportez-en moins de parties, ou plus grossièrement</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than %2 parts; export those that the cover touches</source>
        <translation>«&#x202f;%1&#x202f;» a plus de %2 parties&#x202f;; exportez celles que la housse touche</translation>
    </message>
    <message>
        <source>%1: the part &quot;%2&quot; reaches beyond 10,000,000; export it without that part, or near the origin</source>
        <translation>%1&#x202f;: la partie «&#x202f;%2&#x202f;» dépasse 10&#x202f;000&#x202f;000&#x202f;; exportez sans cette partie, ou près de l’origine</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs the file &quot;%2&quot; in its own folder; copy it there, or export as GLB, which is one file</source>
        <translation>«&#x202f;%1&#x202f;» demande le fichier «&#x202f;%2&#x202f;» dans le même dossier&#x202f;; copiez-l’y, ou exportez en GLB, qui est un seul fichier</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged or incomplete, or not what its ending says; export it again from the program that it comes from</source>
        <translation>«&#x202f;%1&#x202f;» est endommagé ou incomplet, ou n’est pas ce que dit son extension&#x202f;; exportez-le de nouveau depuis le programme d’origine</translation>
    </message>
    <message>
        <source>%1: %2 triangles are left out: their corners are no numbers</source>
        <translation>%1&#x202f;: %2 triangles sont omis&#x202f;: leurs coins ne sont pas des nombres</translation>
    </message>
    <message>
        <source>%1: parts are left out that are scaled to nothing: %2, the first is &quot;%3&quot;</source>
        <translation>%1&#x202f;: des parties réduites à rien sont omises&#x202f;: %2, la première est «&#x202f;%3&#x202f;»</translation>
    </message>
    <message>
        <source>%1: %2 faces could not be made triangles of, and leave holes</source>
        <translation>%1&#x202f;: %2 faces n’ont pas pu être triangulées et laissent des trous</translation>
    </message>
    <message>
        <source>%1: %2 parts are left out that lie too deep in the tree</source>
        <translation>%1&#x202f;: %2 parties trop profondes dans l’arborescence sont omises</translation>
    </message>
    <message>
        <source>%1: the parts in the file &quot;%2&quot; are not read; export all in one file</source>
        <translation>%1&#x202f;: les parties du fichier «&#x202f;%2&#x202f;» ne sont pas lues&#x202f;; exportez tout dans un seul fichier</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no file that frames are written to; OBJ, PLY and STL are</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un fichier où s’écrivent des armatures&#x202f;; OBJ, PLY et STL le sont</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a scan that can be read; these can: %2</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un scan lisible&#x202f;; ceux-ci le sont&#x202f;: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a frame that can be read; these can: %2</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas une armature lisible&#x202f;; celles-ci le sont&#x202f;: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a pattern that can be read; these can: %2</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un patron lisible&#x202f;; ceux-ci le sont&#x202f;: %2</translation>
    </message>
    <message>
        <source>nothing is left of the parts that are wanted</source>
        <translation>il ne reste rien des parties voulues</translation>
    </message>
    <message>
        <source>nothing is sewn where %1 of its notches are, so they have no partners</source>
        <translation>rien n’est cousu là où sont %1 de ses crans, ils n’ont donc pas de vis-à-vis</translation>
    </message>
    <message>
        <source>notches at edges without an allowance cut into the piece: there are %1; give these edges an allowance</source>
        <translation>des crans sur des bords sans marge entaillent la pièce&#x202f;: il y en a %1&#x202f;; donnez une marge à ces bords</translation>
    </message>
    <message>
        <source>There is a dart already: put this one beside it, or remove that one first.</source>
        <translation>Il y a déjà une pince&#x202f;: placez celle-ci à côté, ou supprimez d’abord l’autre.</translation>
    </message>
    <message>
        <source>%1 is left out: with its holes, notches and lines the design would have more than %2 elements</source>
        <translation>%1 est omise&#x202f;: avec ses trous, crans et lignes, le modèle aurait plus de %2 éléments</translation>
    </message>
    <message>
        <source>%1: its nap &quot;%2&quot; is neither one way, two ways nor any; it is taken for two ways</source>
        <translation>%1&#x202f;: son sens du poil «&#x202f;%2&#x202f;» n’est ni sens unique, ni double sens, ni tous les sens&#x202f;; double sens est retenu</translation>
    </message>
    <message>
        <source>%1 is drawn larger by what its fabric shrinks (%2), and taken as it is drawn: a shrinkage of the fabric here would come on top</source>
        <translation>%1 est dessinée plus grande du retrait de son tissu (%2), et prise telle quelle&#x202f;: un retrait du tissu indiqué ici s’y ajouterait</translation>
    </message>
    <message>
        <source>the viewBox &quot;%1&quot; is no four numbers and is left out: check the size of the pieces</source>
        <translation>la viewBox «&#x202f;%1&#x202f;» n’a pas quatre nombres et est omise&#x202f;: vérifiez la taille des pièces</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs the file &quot;%2&quot; beside it, and the frame of a design is one file; import it again, or export it as GLB</source>
        <translation>«&#x202f;%1&#x202f;» demande le fichier «&#x202f;%2&#x202f;» à côté, et l’armature d’un modèle est un seul fichier&#x202f;; importez-la de nouveau, ou exportez-la en GLB</translation>
    </message>
    <message>
        <source>99 % of its surface is within %1 mm</source>
        <translation>99&#x202f;% de sa surface est à moins de %1&#xa0;mm</translation>
    </message>
    <message>
        <source>it reaches beyond its piece: end it at the edge</source>
        <translation>elle dépasse de sa pièce&#x202f;: finissez-la au bord</translation>
    </message>
    <message>
        <source>the hole breaks through the edge of its piece: move it inwards, or make it smaller</source>
        <translation>le trou traverse le bord de sa pièce&#x202f;: rentrez-le, ou réduisez-le</translation>
    </message>
    <message>
        <source>only %1 mm are left of the piece at the tip of a dart: make it shorter</source>
        <translation>il ne reste que %1&#xa0;mm de la pièce à la pointe d’une pince&#x202f;: raccourcissez-la</translation>
    </message>
    <message>
        <source>%1 of its notches have no partners on the other sides of their seams: others are too near there. Ask for fewer</source>
        <translation>%1 de ses crans n’ont pas de vis-à-vis de l’autre côté de leurs coutures&#x202f;: d’autres y sont trop proches. Demandez-en moins</translation>
    </message>
    <message>
        <source>%1 has %2 sewing lines beside each other; the largest is taken, the others are left out</source>
        <translation>%1 a %2 lignes de couture côte à côte&#x202f;; la plus grande est prise, les autres sont omises</translation>
    </message>
    <message>
        <source>%1: its cut line lies %2 mm outside of its sewing line, which is wider than an allowance may be; it becomes %3 mm there</source>
        <translation>%1&#x202f;: sa ligne de coupe est à %2&#xa0;mm hors de sa ligne de couture, plus que ne le permet une marge&#x202f;; elle y devient %3&#xa0;mm</translation>
    </message>
    <message>
        <source>The cover is pulled to the scan where it lies now: switch &quot;Fit the cover to it&quot; off, place it, and switch that on again.</source>
        <translation>La housse est tirée vers le scan là où il se trouve&#x202f;: désactivez «&#x202f;Y ajuster la housse&#x202f;», placez-le, puis réactivez.</translation>
    </message>
    <message>
        <source>Place on the cover to %2 mm rms: %1 (%3 % of its points matched)</source>
        <translation>Placer sur la housse à %2&#xa0;mm RMS&#x202f;: %1 (%3&#x202f;% de ses points associés)</translation>
    </message>
    <message>
        <source>The scan could not be placed: it is too far from the cover. Align it by three places, or cut away what does not belong to it.</source>
        <translation>Le scan n’a pas pu être placé&#x202f;: il est trop loin de la housse. Alignez-le par trois endroits, ou découpez ce qui n’en fait pas partie.</translation>
    </message>
    <message>
        <source>Align to %2 mm rms: %1 (%3 % of its points matched)</source>
        <translation>Aligner à %2&#xa0;mm RMS&#x202f;: %1 (%3&#x202f;% de ses points associés)</translation>
    </message>
    <message>
        <source>Import the pattern of %1</source>
        <translation>Importer le patron de %1</translation>
    </message>
    <message>
        <source>%1: a gap of %2 mm in its outline is closed by a straight line</source>
        <translation>%1&#x202f;: un jour de %2&#xa0;mm dans son contour est fermé par une droite</translation>
    </message>
    <message>
        <source>%1: its cut line is drawn anew from its allowances, and differs from that of the file by up to %2 mm</source>
        <translation>%1&#x202f;: sa ligne de coupe est redessinée d’après ses marges et s’écarte de celle du fichier jusqu’à %2&#xa0;mm</translation>
    </message>
    <message>
        <source>the size &quot;%1&quot; of the page is in no unit that is known and is left out: check the size of the pieces</source>
        <translation>la taille «&#x202f;%1&#x202f;» de la page n’a pas d’unité connue et est omise&#x202f;: vérifiez la taille des pièces</translation>
    </message>
    <message>
        <source>Sew a proposed seam</source>
        <translation>Coudre une couture proposée</translation>
    </message>
    <message>
        <source>it is in %1 pieces</source>
        <translation>elle est en %1 morceaux</translation>
    </message>
    <message>
        <source>one piece of less than 1 cm³ is left out</source>
        <translation>un morceau de moins de 1&#xa0;cm³ est omis</translation>
    </message>
    <message>
        <source>%1 pieces of less than 1 cm³ are left out</source>
        <translation>%1 morceaux de moins de 1&#xa0;cm³ sont omis</translation>
    </message>
    <message>
        <source>Change whether the cover fits %1</source>
        <translation>Modifier l’ajustement de la housse à %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs too much memory: it has too many parts, or places them too often; export those that the cover touches</source>
        <translation>«&#x202f;%1&#x202f;» demande trop de mémoire&#x202f;: il a trop de parties, ou les place trop souvent&#x202f;; exportez celles que la housse touche</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has decimal commas; export it with decimal points</source>
        <translation>«&#x202f;%1&#x202f;» a des virgules décimales&#x202f;; exportez-le avec des points décimaux</translation>
    </message>
    <message>
        <source>%1: triangles are left out that name points which are not in the file</source>
        <translation>%1&#x202f;: les triangles qui renvoient à des points absents du fichier sont omis</translation>
    </message>
    <message>
        <source>%1: %2 triangles are left out: they name points that are not in the file</source>
        <translation>%1&#x202f;: %2 triangles sont omis&#x202f;: ils renvoient à des points absents du fichier</translation>
    </message>
    <message>
        <source>%1: none of its %2 points has a place</source>
        <translation>%1&#x202f;: aucun de ses %2 points n’a de position</translation>
    </message>
    <message>
        <source>%1: %2 points are left out: they have no place, as where a scanner saw nothing</source>
        <translation>%1&#x202f;: %2 points sont omis&#x202f;: ils n’ont pas de position, comme là où un scanner n’a rien vu</translation>
    </message>
    <message>
        <source>%1 is text in UTF-16, which is not read; save it as UTF-8</source>
        <translation>%1 est un texte en UTF-16, qui n’est pas lu&#x202f;; enregistrez-le en UTF-8</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; has a decimal comma; export with decimal points</source>
        <translation>%1&#x202f;: «&#x202f;%2&#x202f;» a une virgule décimale&#x202f;; exportez avec des points décimaux</translation>
    </message>
    <message>
        <source>Make the pattern of a form</source>
        <translation>Faire le patron d’une forme</translation>
    </message>
    <message>
        <source>Fit the pattern to a goal</source>
        <translation>Ajuster le patron à un objectif</translation>
    </message>
    <message>
        <source>it has %1 triangles, and cannot be made simpler</source>
        <translation>elle a %1 triangles et ne peut pas être simplifiée</translation>
    </message>
    <message>
        <source>The form has %1 triangles; %2 stand for it, which are up to %3 mm off</source>
        <translation>La forme a %1 triangles&#x202f;; %2 la représentent, à %3&#xa0;mm près</translation>
    </message>
    <message>
        <source>%1 ends inside a piece, at %2: it is cut in there like a dart. The next line or border is %3 mm away; draw it on to there to divide the piece</source>
        <translation>%1 finit dans un morceau, en %2&#x202f;: il y est entaillé comme par une pince. La ligne ou bordure suivante est à %3&#xa0;mm&#x202f;; prolongez-la jusque-là pour diviser le morceau</translation>
    </message>
    <message>
        <source>No place of the cover is near the form: put it where the cover is, in millimetres.</source>
        <translation>Aucun endroit de la housse n’est près de la forme&#x202f;: placez-la là où est la housse, en millimètres.</translation>
    </message>
    <message>
        <source>Nothing that may change does anything to the cover.</source>
        <translation>Rien de ce qui peut changer n’agit sur la housse.</translation>
    </message>
    <message>
        <source>A step would have turned the outline of %1 over itself; a smaller one was taken</source>
        <translation>Un pas aurait replié le contour de %1 sur lui-même&#x202f;; un plus petit a été fait</translation>
    </message>
    <message>
        <source>Nothing may change.</source>
        <translation>Rien ne peut changer.</translation>
    </message>
    <message>
        <source>The cover does not come to rest.</source>
        <translation>La housse ne se stabilise pas.</translation>
    </message>
    <message>
        <source>Make %1 longer by %3 mm where it is sewn to %2</source>
        <translation>Allonger %1 de %3&#xa0;mm là où elle est cousue à %2</translation>
    </message>
    <message>
        <source>Make %1 shorter by %3 mm where it is sewn to %2</source>
        <translation>Raccourcir %1 de %3&#xa0;mm là où elle est cousue à %2</translation>
    </message>
    <message>
        <source>Move the seam of %1 and %2 by %3 mm into %2</source>
        <translation>Déplacer la couture de %1 et %2 de %3&#xa0;mm dans %2</translation>
    </message>
    <message>
        <source>Move the seam of %1 and %2 by %3 mm into %1</source>
        <translation>Déplacer la couture de %1 et %2 de %3&#xa0;mm dans %1</translation>
    </message>
    <message>
        <source>Let out the corner of %1 at %2 by %3 mm</source>
        <translation>Élargir le coin de %1 en %2 de %3&#xa0;mm</translation>
    </message>
    <message>
        <source>Take in the corner of %1 at %2 by %3 mm</source>
        <translation>Reprendre le coin de %1 en %2 de %3&#xa0;mm</translation>
    </message>
    <message>
        <source>Cut a dart into %1 at %2, %3 mm wide and %4 mm deep</source>
        <translation>Couper une pince dans %1 en %2, large de %3&#xa0;mm et profonde de %4&#xa0;mm</translation>
    </message>
    <message>
        <source>Make the seam of %1 and %2 smooth</source>
        <translation>Rendre lisse la couture de %1 et %2</translation>
    </message>
    <message>
        <source>Let the seam of %1 and %2 be sharp</source>
        <translation>Laisser vive la couture de %1 et %2</translation>
    </message>
    <message>
        <source>it is no file of preferences: it breaks off or has a mistake at character %1; choose one that Bolster has exported</source>
        <translation>ce n’est pas un fichier de préférences&#x202f;: il s’interrompt ou a une erreur au caractère %1&#x202f;; choisissez-en un que Bolster a exporté</translation>
    </message>
    <message>
        <source>it is no file of preferences; choose one that Bolster has exported</source>
        <translation>ce n’est pas un fichier de préférences&#x202f;; choisissez-en un que Bolster a exporté</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be what it is there; remove that line from the file, or export it again</source>
        <translation>«&#x202f;%1&#x202f;» ne peut pas avoir cette valeur&#x202f;; supprimez cette ligne du fichier, ou exportez-le de nouveau</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, where a portable Bolster keeps settings and work, cannot be written; copy its folder to where you may write</source>
        <translation>impossible d’écrire «&#x202f;%1&#x202f;», où un Bolster portable garde réglages et travail&#x202f;; copiez son dossier là où vous avez le droit d’écrire</translation>
    </message>
    <message>
        <source>the disk with &quot;%1&quot; is full; make room on it, and change a setting once more: all of them are kept then</source>
        <translation>le disque de « %1 » est plein&#x202f;; faites-y de la place et changez encore un réglage&#x202f;: tous sont alors conservés</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be written; give yourself the right to write there and in its folder, and change a setting once more: all of them are kept then</source>
        <translation>« %1 » n’a pas pu être écrit&#x202f;; donnez-vous le droit d’y écrire ainsi que dans son dossier, puis changez encore un réglage&#x202f;: tous sont alors conservés</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands there twice; remove one of its lines from the file, or export it again</source>
        <translation>« %1 » y figure deux fois&#x202f;; supprimez l’une des lignes du fichier, ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>Change the note of %1</source>
        <translation>Modifier la note de %1</translation>
    </message>
    <message>
        <source>Add measurement %1</source>
        <translation>Ajouter la mesure %1</translation>
    </message>
    <message>
        <source>it does not lie in &quot;%1&quot; any more; measure anew</source>
        <translation>elle n’est plus dans «&#x202f;%1&#x202f;»&#x202f;; mesurez de nouveau</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; holds other files: choose one of its own.</source>
        <translation>Le dossier «&#x202f;%1&#x202f;» contient d’autres fichiers&#x202f;: choisissez-en un à part.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; holds the work of another design or of other options: choose another folder.</source>
        <translation>Le dossier «&#x202f;%1&#x202f;» contient le travail d’un autre projet ou d’autres options&#x202f;: choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be made (%2).</source>
        <translation>Impossible de créer le dossier «&#x202f;%1&#x202f;» (%2).</translation>
    </message>
    <message>
        <source>Remove %1 and what needs it (%2 elements)</source>
        <translation>Supprimer %1 et ce qui en dépend (%2 éléments)</translation>
    </message>
    <message>
        <source>one version was saved</source>
        <translation>Une version a été récupérée</translation>
    </message>
    <message>
        <source>%1: none of its triangles has an area</source>
        <translation>%1&#x202f;: aucun de ses triangles n’a de surface</translation>
    </message>
    <message>
        <source>Where a piece would have had a hole or been a ring it is cut and sewn again, number of cuts: %1</source>
        <translation>Là où une pièce aurait un trou ou serait un anneau, elle est coupée et recousue, nombre de coupes&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1 is stretched by %2 % along the grain, its fabric allows %3 %</source>
        <translation>%1 est étirée de %2&#x202f;% en droit-fil, son tissu admet %3&#x202f;%</translation>
    </message>
    <message>
        <source>%1 is stretched by %2 % across the grain, its fabric allows %3 %</source>
        <translation>%1 est étirée de %2&#x202f;% en travers, son tissu admet %3&#x202f;%</translation>
    </message>
    <message>
        <source>%1 is sheared by %2 %, its fabric allows %3 %</source>
        <translation>%1 est cisaillée de %2&#x202f;%, son tissu admet %3&#x202f;%</translation>
    </message>
    <message>
        <source>The form has one side only, as a twisted band: it is left open where its outside meets its inside</source>
        <translation>La forme n’a qu’une face, comme une bande torsadée&#x202f;: elle reste ouverte là où l’extérieur rejoint l’intérieur</translation>
    </message>
    <message>
        <source>Parts of %1 that are shorter than a mesh edge have gone with the cut.</source>
        <translation>Les parties de %1 plus courtes qu’une arête du maillage ont disparu avec la coupe.</translation>
    </message>
    <message>
        <source>the usual value is used instead</source>
        <translation>la valeur habituelle est utilisée à la place</translation>
    </message>
    <message>
        <source>it is the project that is open here; choose another name</source>
        <translation>c’est le projet qui est ouvert ici&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>the file is empty; nothing was written to it, or it was lost</source>
        <translation>le fichier est vide&#x202f;; rien n’y a été écrit, ou le contenu s’est perdu</translation>
    </message>
    <message>
        <source>it is open in another window; choose another name</source>
        <translation>il est ouvert dans une autre fenêtre&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>the disk of &quot;%1&quot; is full, where work is protected from crashes; make room, and open it again</source>
        <translation>le disque de «&#xa0;%1&#xa0;», où le travail est protégé des plantages, est plein&#x202f;; faites de la place et rouvrez-le</translation>
    </message>
    <message>
        <source>The form is %1 mm large: with edges of %2 mm its cover has more triangles than can be solved. See whether the unit is right; else make the mesh edges at least %3 mm long</source>
        <translation>La forme mesure %1 mm&#x202f;: avec des arêtes de %2 mm, sa housse a plus de triangles qu’on ne peut en résoudre. Vérifiez l’unité&#x202f;; sinon, donnez aux arêtes du maillage au moins %3 mm</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already; choose another name</source>
        <translation>«&#x202f;%1&#x202f;» existe déjà&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>%1 is strained by %2 % when it lies on the form, more than any fabric bears. Divide it, or cut it in where it bulges most</source>
        <translation>%1 est déformée de %2&#x202f;% lorsqu’elle est sur la forme, plus qu’aucun tissu ne supporte. Divisez-la, ou entaillez-la là où elle est le plus bombée</translation>
    </message>
    <message>
        <source>Let no scan pull at the cover</source>
        <translation>Ne laisser aucun scan tirer la housse</translation>
    </message>
    <message>
        <source>%1 bends too sharply at %2: it is not cut along it</source>
        <translation>%1 se plie trop à %2&#x202f;: il n’y a pas de coupe à cet endroit</translation>
    </message>
    <message>
        <source>The form goes through itself at %2: it is not cut along %1</source>
        <translation>La forme se traverse elle-même à %2&#x202f;: il n’y a pas de coupe le long de %1</translation>
    </message>
    <message>
        <source>What is closed all around has no border to be held at: its cover is fixed along its seams. Delete the fixations of those that are to be free</source>
        <translation>Ce qui est fermé tout autour n’a pas de bord par lequel le tenir&#x202f;: sa housse est fixée le long de ses coutures. Supprimez les fixations de celles qui doivent rester libres</translation>
    </message>
    <message>
        <source>No vertex of the area is near the form: make the area larger than the mesh edges, or put the form where the cover is.</source>
        <translation>Aucun sommet de la zone n’est près de la forme&#x202f;: agrandissez la zone au-delà des arêtes du maillage, ou placez la forme là où est la housse.</translation>
    </message>
    <message>
        <source>%1 is left out: it is too narrow to be sewn. Join it to what lies beside it</source>
        <translation>%1 est omise&#x202f;: elle est trop étroite pour être cousue. Réunissez-la à ce qui est à côté</translation>
    </message>
    <message>
        <source>Make the pattern of a form again</source>
        <translation>Refaire le patron d’une forme</translation>
    </message>
    <message>
        <source>Make the pattern of %1 again</source>
        <translation>Refaire le patron de %1</translation>
    </message>
    <message>
        <source>Make the pattern of %1</source>
        <translation>Faire le patron de %1</translation>
    </message>
    <message>
        <source>Fit the pattern to %1, %2 mm from it</source>
        <translation>Ajuster le patron à %1, à %2&#xa0;mm</translation>
    </message>
    <message>
        <source>Fit the pattern to %1</source>
        <translation>Ajuster le patron à %1</translation>
    </message>
    <message>
        <source>Fit the pattern to a limit of strain, %1 % of the cover over it</source>
        <translation>Ajuster le patron à une limite de déformation, %1&#x202f;% de la housse au-delà</translation>
    </message>
    <message>
        <source>Let the scan pull at the cover again</source>
        <translation>Laisser de nouveau le scan tirer la housse</translation>
    </message>
    <message>
        <source>%1 runs along %2, at %3: it is cut there once</source>
        <translation>%1 suit %2, à %3&#x202f;: on n’y coupe qu’une fois</translation>
    </message>
    <message>
        <source>%1 runs along the border of the form, or where it is cut anyway, at %2: there is nothing to cut</source>
        <translation>%1 suit le bord de la forme, ou un endroit déjà coupé, à %2&#x202f;: il n’y a rien à couper</translation>
    </message>
    <message>
        <source>%1 is too short or too long, at %2: it is not cut along it</source>
        <translation>%1 est trop courte ou trop longue, à %2&#x202f;: il n’y a pas de coupe à cet endroit</translation>
    </message>
    <message>
        <source>%1 is %2 mm away from the form, at %3: it is not cut along it</source>
        <translation>%1 est à %2&#xa0;mm de la forme, à %3&#x202f;: il n’y a pas de coupe à cet endroit</translation>
    </message>
    <message>
        <source>lines cannot be cut into it: it has edges where more than two faces meet, or sheets that touch in a point, at %1</source>
        <translation>on ne peut pas y couper de lignes&#x202f;: elle a des arêtes où se rejoignent plus de deux faces, ou des nappes qui se touchent en un point, à %1</translation>
    </message>
    <message>
        <source>%1 cannot be cut into it, at %2: the form goes through itself there</source>
        <translation>on ne peut pas y couper %1, à %2&#x202f;: la forme s’y traverse elle-même</translation>
    </message>
    <message>
        <source>Small for the triangles of the cover, whose edges are %1 mm long: %2. Their shape will be coarse; with mesh edges of %3 mm it is not</source>
        <translation>Petites pour les triangles de la housse, dont les arêtes mesurent %1&#xa0;mm&#x202f;: %2. Leur forme sera grossière&#x202f;; avec des arêtes de maillage de %3&#xa0;mm, elle ne l’est pas</translation>
    </message>
    <message>
        <source>Too small for the triangles of the cover, whose edges are %1 mm long: %2. Join them to what lies beside them, or leave them out</source>
        <translation>Trop petites pour les triangles de la housse, dont les arêtes mesurent %1&#xa0;mm&#x202f;: %2. Réunissez-les à ce qui est à côté, ou omettez-les</translation>
    </message>
    <message>
        <source>After %1 iterations it cannot be told yet where the surface comes to rest. Allow more iterations.</source>
        <translation>Après %1 itérations, on ne peut pas encore dire où la surface s’immobilisera. Permettez plus d’itérations.</translation>
    </message>
    <message>
        <source>Wider across the grain than the fabric, of which %1 mm can be used: %2. Divide them, or turn their grain</source>
        <translation>Plus larges en travers du droit-fil que le tissu, dont %1&#x202f;mm sont utilisables&#x202f;: %2. Divisez-les ou tournez leur droit-fil</translation>
    </message>
    <message>
        <source>%1 ends inside a piece, at %2: it is cut in there like a dart. There is no other line or border; lead it around to where it began to divide the piece</source>
        <translation>%1 finit dans un morceau, en %2&#x202f;: il y est entaillé comme par une pince. Il n’y a pas d’autre ligne ni de bordure&#x202f;; faites-en le tour jusqu’à son début pour diviser le morceau</translation>
    </message>
    <message>
        <source>A line is not cut in at %1: the sides of the cut would lie over each other when it is laid flat. Draw it elsewhere, or on to a border</source>
        <translation>Une ligne n’est pas entaillée en %1&#x202f;: à plat, les côtés de l’entaille se recouvriraient. Tracez-la ailleurs, ou jusqu’à une bordure</translation>
    </message>
    <message>
        <source>A line is not cut in at %1: the piece was divided another way. Draw it on to a border</source>
        <translation>Une ligne n’est pas entaillée en %1&#x202f;: la pièce a été divisée autrement. Prolongez-la jusqu’à une bordure</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no design, but what one is made of: import it</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un modèle, mais ce dont on en fait un&#x202f;: importez-le</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by %2 mm in each: it does not come to rest. Make curves as long as the outlines they hold, or try other mesh edges.</source>
        <translation>Après %1 itérations, la surface bouge encore de %2&#xa0;mm à chacune&#x202f;: elle ne se stabilise pas. Donnez aux courbes la longueur des contours qu’elles tiennent, ou essayez d’autres arêtes de maillage.</translation>
    </message>
    <message>
        <source>%1, with what is sewn to it, is held only at a border of %2 mm: fix it along other curves, too, or close that hole of the form</source>
        <translation>%1, avec ce qui y est cousu, n’est tenue que par un bord de %2&#xa0;mm&#x202f;: fixez-la aussi le long d’autres courbes, ou bouchez ce trou de la forme</translation>
    </message>
    <message>
        <source>%1 is left out: it is closed all around and cannot be laid flat. Cut it along lines</source>
        <translation>%1 est omise&#x202f;: elle est fermée de toutes parts et ne peut être mise à plat. Coupez-la le long de lignes</translation>
    </message>
    <message>
        <source>%1 is left out: it has a handle, like a cup, and cannot be laid flat. Cut it along lines</source>
        <translation>%1 est omise&#x202f;: elle a une anse, comme une tasse, et ne peut être mise à plat. Coupez-la le long de lignes</translation>
    </message>
    <message>
        <source>Let out %1 by %3 mm where it is sewn to %2</source>
        <translation>Élargir %1 de %3&#xa0;mm là où elle est cousue à %2</translation>
    </message>
    <message>
        <source>Take in %1 by %3 mm where it is sewn to %2</source>
        <translation>Reprendre %1 de %3&#xa0;mm là où elle est cousue à %2</translation>
    </message>
    <message>
        <source>Let out %1 by %3 mm where the curve %2 holds it</source>
        <translation>Élargir %1 de %3&#xa0;mm là où la courbe %2 la tient</translation>
    </message>
    <message>
        <source>Take in %1 by %3 mm where the curve %2 holds it</source>
        <translation>Reprendre %1 de %3&#xa0;mm là où la courbe %2 la tient</translation>
    </message>
    <message>
        <source>What would not lie flat, or be strained by more than the fabric may be, is divided, which makes so many pieces more: %1</source>
        <translation>Ce qui ne serait pas à plat, ou serait plus étiré que le tissu ne l’admet, est divisé. Nombre de pièces en plus&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1 is not divided: more than %2 pieces would be needed until it lies flat. It is rough, as scans are: smooth it, or fit a cover to it and take that</source>
        <translation>%1 n’est pas divisée&#x202f;: il faudrait plus de %2 pièces pour qu’elle soit à plat. Elle est rugueuse, comme le sont les numérisations&#x202f;: lissez-la, ou ajustez-lui une housse et prenez celle-ci</translation>
    </message>
    <message>
        <source>%1 is left out: it has more than %2 holes. Close them, or cut it along lines</source>
        <translation>%1 est omise&#x202f;: elle a plus de %2 trous. Bouchez-les, ou coupez-la le long de lignes</translation>
    </message>
    <message>
        <source>Too narrow for the triangles of the cover, whose edges are %1 mm long, so that it cannot be solved: %2. Make the mesh edges shorter, or join them to what lies beside them</source>
        <translation>Trop étroites pour les triangles de la housse, dont les arêtes mesurent %1&#xa0;mm, si bien qu’elle ne peut être calculée&#x202f;: %2. Raccourcissez les arêtes du maillage, ou réunissez-les à ce qui est à côté</translation>
    </message>
    <message>
        <source>Lead open seam lines on</source>
        <translation>Prolonger les lignes de couture ouvertes</translation>
    </message>
    <message>
        <source>Lead %1 on</source>
        <translation>Prolonger %1</translation>
    </message>
    <message>
        <source>Bodies of the form go through each other, as at %1: what of one lies inside of another one is covered, too, and pushed out. Unite them before, or leave one out. Number of such pairs: %2</source>
        <translation>Des corps de la forme se traversent, par exemple en %1 : ce qui de l’un se trouve dans un autre est couvert aussi, et repoussé vers l’extérieur. Réunissez-les avant, ou laissez-en un de côté. Nombre de ces paires : %2</translation>
    </message>
    <message>
        <source>Faces of the form that lie where another one lies, and are left out: %1</source>
        <translation>Faces de la forme qui se trouvent là où il y en a déjà une, et sont omises : %1</translation>
    </message>
    <message>
        <source>Faces of the form that were turned round: %1</source>
        <translation>Faces de la forme qui ont été retournées : %1</translation>
    </message>
    <message>
        <source>Edges of the form that belong to more than two faces, so that they are borders and nothing is sewn there: %1</source>
        <translation>Arêtes de la forme qui appartiennent à plus de deux faces, de sorte qu’elles sont des bords et que rien n’y est cousu : %1</translation>
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
        <translation>Maj</translation>
    </message>
    <message>
        <source>middle button</source>
        <translation>bouton central</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>bouton droit</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>glisser</translation>
    </message>
    <message>
        <source>two fingers</source>
        <translation>deux doigts</translation>
    </message>
    <message>
        <source>pinch or Ctrl+wheel</source>
        <translation>pincer ou Ctrl+molette</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>molette</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>CAD (like SolidWorks)</source>
        <translation>CAO (comme SolidWorks)</translation>
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
        <translation>Pavé tactile</translation>
    </message>
</context>
<context>
    <name>NotchForm</name>
    <message>
        <source>Patch</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>From the corner</source>
        <translation>Depuis le coin</translation>
    </message>
    <message>
        <source>Along the outline from the nearer corner, on the same side of it.</source>
        <translation>Le long du contour depuis le coin le plus proche, du même côté.</translation>
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
        <translation>Normale imposée</translation>
    </message>
    <message>
        <source>Tangent plane held</source>
        <translation>Plan tangent imposé</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>Inclinaison</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>%1 directions, interpolated along the curve; the first is shown.</source>
        <translation>%1 directions, interpolées le long de la courbe&#x202f;; la première est affichée.</translation>
    </message>
</context>
<context>
    <name>OutlineTool</name>
    <message>
        <source>This cannot be a patch: %1</source>
        <translation>Cela ne peut pas être une pièce&#x202f;: %1</translation>
    </message>
    <message>
        <source>The outline would cross itself here – Backspace takes a point back</source>
        <translation>Le contour se croiserait ici – Retour arrière retire un point</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no length: try 500, 500&lt;30 or 120, 40</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas une longueur&#x202f;: essayez 500, 500&lt;30 ou 120, 40</translation>
    </message>
    <message>
        <source>Click to set the first corner, press and drag for a smooth point – Esc ends the tool</source>
        <translation>Cliquez pour placer le premier coin, appuyez et glissez pour un point lisse – Échap quitte l’outil</translation>
    </message>
    <message>
        <source>Click to close the outline</source>
        <translation>Cliquez pour fermer le contour</translation>
    </message>
    <message>
        <source>Enter sets the point: 500 goes that far, 500&lt;30 at an angle, 120, 40 to the right and up</source>
        <translation>Entrée place le point&#x202f;: 500 va à cette distance, 500&lt;30 selon un angle, 120, 40 à droite et en haut</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, or type a length – Ctrl does not snap</source>
        <translation>Cliquez pour un coin, glissez pour un point lisse, ou saisissez une longueur – Ctrl désactive l’accrochage</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, type a length – Enter or a click on the first point closes, Backspace takes a point back</source>
        <translation>Cliquez pour un coin, glissez pour un point lisse, saisissez une longueur – Entrée ou un clic sur le premier point ferme, Retour arrière retire un point</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
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
        <translation>Contour</translation>
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
        <translation>Pièce %1</translation>
    </message>
    <message>
        <source>An outline needs at least three points in different places.</source>
        <translation>Un contour demande au moins trois points à des endroits différents.</translation>
    </message>
    <message>
        <source>This cannot be a patch: %1</source>
        <translation>Cela ne peut pas être une pièce&#x202f;: %1</translation>
    </message>
</context>
<context>
    <name>PatchForm</name>
    <message>
        <source>Outline</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Width and height as it lies in the pattern view.</source>
        <translation>Largeur et hauteur telles que dans la vue du patron.</translation>
    </message>
</context>
<context>
    <name>PatternDrawTool</name>
    <message>
        <source>Begin inside a patch.</source>
        <translation>Commencez dans une pièce.</translation>
    </message>
    <message>
        <source>Fancy seam %1</source>
        <translation>Couture décorative %1</translation>
    </message>
    <message>
        <source>Handle %1</source>
        <translation>Maintien %1</translation>
    </message>
    <message>
        <source>A curve needs two points, a closed one three.</source>
        <translation>Une courbe demande deux points, une courbe fermée trois.</translation>
    </message>
    <message>
        <source>There is no surface in this patch yet on which the handle could lie.</source>
        <translation>Cette pièce n’a pas encore de surface sur laquelle la courbe de maintien pourrait être.</translation>
    </message>
    <message>
        <source>Click inside a patch to begin a handle curve – Esc ends the tool</source>
        <translation>Cliquez dans une pièce pour commencer une courbe de maintien – Échap quitte l’outil</translation>
    </message>
    <message>
        <source>Click inside a patch or on its outline to begin a fancy seam – Esc ends the tool</source>
        <translation>Cliquez dans une pièce ou sur son contour pour commencer une couture décorative – Échap quitte l’outil</translation>
    </message>
    <message>
        <source>Click to close the curve</source>
        <translation>Cliquez pour fermer la courbe</translation>
    </message>
    <message>
        <source>Click for the next point, double click or Enter ends – B makes it straight, Backspace takes a point back</source>
        <translation>Cliquez pour le point suivant, double-clic ou Entrée termine – B rend droit, Retour arrière retire un point</translation>
    </message>
    <message>
        <source>Click for the next point, double click or Enter ends – B makes it smooth, Backspace takes a point back</source>
        <translation>Cliquez pour le point suivant, double-clic ou Entrée termine – B rend lisse, Retour arrière retire un point</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Ligne %1</translation>
    </message>
    <message>
        <source>Click inside a patch or on its outline to begin a line for the cutter – Esc ends the tool</source>
        <translation>Cliquez dans une pièce ou sur son contour pour commencer une ligne pour la coupe – Échap quitte l’outil</translation>
    </message>
</context>
<context>
    <name>PatternPdf</name>
    <message>
        <source>1 inch</source>
        <translation>1 pouce</translation>
    </message>
    <message>
        <source>Print at 100 %</source>
        <translation>Imprimer à 100&#x202f;%</translation>
    </message>
    <message>
        <source>%1 – print at 100 %</source>
        <translation>%1 – imprimer à 100&#x202f;%</translation>
    </message>
    <message>
        <source>Overview of %1 x %2 sheets</source>
        <translation>Vue d’ensemble de %1 x %2 feuilles</translation>
    </message>
    <message>
        <source>%1: sheet %2</source>
        <translation>%1&#x202f;: feuille %2</translation>
    </message>
    <message>
        <source>%1: sheets %2 to %3</source>
        <translation>%1&#x202f;: feuilles %2 à %3</translation>
    </message>
    <message>
        <source>100 mm: to measure, no part of the pattern</source>
        <translation>100&#xa0;mm&#x202f;: pour mesurer, hors patron</translation>
    </message>
    <message>
        <source>Sheet %1 (row %2 of %3, column %4 of %5)</source>
        <translation>Feuille %1 (rangée %2 sur %3, colonne %4 sur %5)</translation>
    </message>
</context>
<context>
    <name>PatternSelectTool</name>
    <message>
        <source>There is a control point already.</source>
        <translation>Il y a déjà un point de contrôle ici.</translation>
    </message>
    <message>
        <source>Drag to turn the selected patches in the layout</source>
        <translation>Faites glisser pour tourner les pièces sélectionnées dans la disposition</translation>
    </message>
    <message>
        <source>Drag to move the control point – Shift+click selects several, Del removes</source>
        <translation>Faites glisser pour déplacer le point de contrôle – Maj+clic en sélectionne plusieurs, Suppr supprime</translation>
    </message>
    <message>
        <source>Click to select the patch, drag to move it in the layout</source>
        <translation>Cliquez pour sélectionner la pièce, faites glisser pour la déplacer dans la disposition</translation>
    </message>
    <message>
        <source>Click to select the curve, drag to move it, double click to add a control point here</source>
        <translation>Cliquez pour sélectionner la courbe, faites glisser pour la déplacer, double-cliquez pour ajouter ici un point de contrôle</translation>
    </message>
    <message>
        <source>Drag to scale the selected patches – Shift keeps the proportions</source>
        <translation>Faites glisser pour mettre à l’échelle les pièces sélectionnées – Maj garde les proportions</translation>
    </message>
    <message>
        <source>Drag to move this end of the stretch along the outline</source>
        <translation>Faites glisser pour déplacer ce bout du tronçon le long du contour</translation>
    </message>
    <message>
        <source>Drag to move the edge, double click to add a control point here – its length is in the properties</source>
        <translation>Faites glisser pour déplacer le bord, double-cliquez pour ajouter ici un point de contrôle – sa longueur est dans les propriétés</translation>
    </message>
    <message>
        <source>Click to select the edge, double click to add a control point here, drag to move the patch</source>
        <translation>Cliquez pour sélectionner le bord, double-cliquez pour ajouter ici un point de contrôle, faites glisser pour déplacer la pièce</translation>
    </message>
    <message>
        <source>Click to select the seam and the edge, double click to add a control point here</source>
        <translation>Cliquez pour sélectionner la couture et le bord, double-cliquez pour ajouter ici un point de contrôle</translation>
    </message>
    <message>
        <source>Click to select it, drag to move it, Delete removes it</source>
        <translation>Cliquez pour sélectionner, faites glisser pour déplacer, Suppr supprime</translation>
    </message>
    <message>
        <source>Drag the tip of the dart</source>
        <translation>Faites glisser la pointe de la pince</translation>
    </message>
    <message>
        <source>Drag the dart along the outline</source>
        <translation>Faites glisser la pince le long du contour</translation>
    </message>
    <message>
        <source>Drag the label to where it can be read, click to select the patch</source>
        <translation>Faites glisser l’étiquette là où on peut la lire, cliquez pour sélectionner la pièce</translation>
    </message>
    <message>
        <source>Click to select, drag a box to select several – %1 or Space pans, %2 zooms</source>
        <translation>Cliquez pour sélectionner, tracez un cadre pour en sélectionner plusieurs – déplacer la vue&#x202f;: %1 ou Espace, zoomer&#x202f;: %2</translation>
    </message>
    <message>
        <source>Click to select the measurement, Delete removes it</source>
        <translation>Cliquez pour sélectionner la mesure, Suppr la supprime</translation>
    </message>
</context>
<context>
    <name>PatternSplitTool</name>
    <message>
        <source>Click beside a patch or on its outline to begin the cut – Esc ends the tool</source>
        <translation>Cliquez à côté d’une pièce ou sur son contour pour commencer la coupe – Échap quitte l’outil</translation>
    </message>
    <message>
        <source>Double click or Enter splits the patch – click to bend the cut, Backspace takes a point back</source>
        <translation>Double-clic ou Entrée divise la pièce – cliquez pour couder la coupe, Retour arrière retire un point</translation>
    </message>
    <message>
        <source>Click on the other side of the patch – Shift keeps the cut straight, Backspace takes a point back</source>
        <translation>Cliquez de l’autre côté de la pièce – Maj garde la coupe droite, Retour arrière retire un point</translation>
    </message>
</context>
<context>
    <name>PatternTool</name>
    <message>
        <source>Moved by %1, %2 – Shift keeps to one axis, Esc takes it back</source>
        <translation>Déplacé de %1, %2 – Maj limite à un axe, Échap annule</translation>
    </message>
    <message>
        <source>Turned by %1 – Shift turns in steps of 15°, Esc takes it back</source>
        <translation>Tourné de %1 – Maj tourne par pas de 15°, Échap annule</translation>
    </message>
    <message>
        <source>Release to select what lies in the box – Shift adds, Esc takes it back</source>
        <translation>Relâchez pour sélectionner ce qui est dans le cadre – Maj ajoute, Échap annule</translation>
    </message>
    <message>
        <source>Release to select what lies in the loop – Shift adds, Esc takes it back</source>
        <translation>Relâchez pour sélectionner ce qui est dans le lasso – Maj ajoute, Échap annule</translation>
    </message>
    <message>
        <source>Enter moves it so far: 50, or 30, 20</source>
        <translation>Entrée déplace d’autant&#x202f;: 50, ou 30, 20</translation>
    </message>
    <message>
        <source>Enter turns it by this angle, counter-clockwise: 45</source>
        <translation>Entrée tourne de cet angle, dans le sens antihoraire&#x202f;: 45</translation>
    </message>
    <message>
        <source>Enter makes it this size: 300 x 200, 300 (wide, in proportion), or 120 %</source>
        <translation>Entrée donne cette taille&#x202f;: 300 x 200, 300 (largeur, proportions gardées) ou 120&#x202f;%</translation>
    </message>
    <message>
        <source>Scaled to %1 × %2 – or type the size; Shift keeps the proportions, Esc takes it back</source>
        <translation>Mis à l’échelle à %1 × %2 – ou saisissez la taille&#x202f;; Maj garde les proportions, Échap annule</translation>
    </message>
</context>
<context>
    <name>PatternToolHost</name>
    <message>
        <source>%1 Let go here, and it goes back to where it was.</source>
        <translation>%1 Si vous relâchez ici, tout revient à sa place.</translation>
    </message>
</context>
<context>
    <name>PieceCuttingSection</name>
    <message>
        <source>Cutting</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Own seam allowance</source>
        <translation>Marge de couture propre</translation>
    </message>
    <message>
        <source>Label where it finds room</source>
        <translation>Étiquette où il y a de la place</translation>
    </message>
</context>
<context>
    <name>PlacementGizmo</name>
    <message>
        <source>Turned by %1° – Ctrl snaps to 15°, Escape cancels</source>
        <translation>Tourné de %1° – Ctrl accroche à 15°, Échap annule</translation>
    </message>
    <message>
        <source>Drag to move it along this axis</source>
        <translation>Faites glisser pour déplacer selon cet axe</translation>
    </message>
    <message>
        <source>Drag to turn it about this axis</source>
        <translation>Faites glisser pour tourner autour de cet axe</translation>
    </message>
    <message>
        <source>Drag to move it parallel to the picture</source>
        <translation>Faites glisser pour déplacer parallèlement à l’image</translation>
    </message>
    <message>
        <source>Moved by x %1, y %2, z %3 – Ctrl snaps to %4, Escape cancels</source>
        <translation>Déplacé de x %1, y %2, z %3 – Ctrl accroche à %4, Échap annule</translation>
    </message>
</context>
<context>
    <name>PreferenceCommands</name>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation>Pré&amp;férences…</translation>
    </message>
    <message>
        <source>Units, language, theme, mouse, keys and more</source>
        <translation>Unités, langue, thème, souris, touches, etc.</translation>
    </message>
    <message>
        <source>The preferences could not be stored: they hold only until Bolster is closed.</source>
        <translation>Les préférences n’ont pas pu être enregistrées&#x202f;: elles ne valent que jusqu’à la fermeture de Bolster.</translation>
    </message>
</context>
<context>
    <name>Preferences</name>
    <message>
        <source>Millimetres (314 mm)</source>
        <translation>Millimètres (314&#xa0;mm)</translation>
    </message>
    <message>
        <source>Centimetres (31.4 cm)</source>
        <translation>Centimètres (31,4&#xa0;cm)</translation>
    </message>
    <message>
        <source>Inches (12 3/8″)</source>
        <translation>Pouces (12 3/8″)</translation>
    </message>
    <message>
        <source>Up to 1/8</source>
        <translation>Jusqu’à 1/8</translation>
    </message>
    <message>
        <source>Up to 1/16</source>
        <translation>Jusqu’à 1/16</translation>
    </message>
    <message>
        <source>Up to 1/32</source>
        <translation>Jusqu’à 1/32</translation>
    </message>
    <message>
        <source>Up to 1/64</source>
        <translation>Jusqu’à 1/64</translation>
    </message>
    <message>
        <source>Decimals (12.375)</source>
        <translation>Décimales (12,375)</translation>
    </message>
    <message>
        <source>Of the language</source>
        <translation>Selon la langue</translation>
    </message>
    <message>
        <source>Comma (1,5)</source>
        <translation>Virgule (1,5)</translation>
    </message>
    <message>
        <source>Point (1.5)</source>
        <translation>Point (1.5)</translation>
    </message>
    <message>
        <source>Of the system</source>
        <translation>Langue du système</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Comme le système</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Contraste élevé</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Complète</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Réduite</translation>
    </message>
    <message>
        <source>Plain, as it comes</source>
        <translation>Uni, sans préréglage</translation>
    </message>
    <message>
        <source>Units and numbers</source>
        <translation>Unités et nombres</translation>
    </message>
    <message>
        <source>Language and looks</source>
        <translation>Langue et apparence</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Souris</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>Clavier</translation>
    </message>
    <message>
        <source>Pattern view</source>
        <translation>Vue du patron</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Vue 3D</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Travail non enregistré</translation>
    </message>
    <message>
        <source>New designs</source>
        <translation>Nouveaux modèles</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>Longueurs en</translation>
    </message>
    <message>
        <source>unit measure metric imperial millimetre centimetre inch</source>
        <translation>unité mesure métrique impérial millimètre centimètre pouce</translation>
    </message>
    <message>
        <source>How lengths are shown. Whatever it is, you may type others: 3 in, 2.5 cm, 1&apos; 2 3/8&quot;. Designs keep millimetres, and so do printed sheets and files.</source>
        <translation>Façon d’afficher les longueurs. Vous pouvez en saisir d’autres de toute façon&#x202f;: «&#x202f;3&#xa0;in&#x202f;», «&#x202f;2,5&#xa0;cm&#x202f;», «&#x202f;1&apos; 2 3/8&quot;&#x202f;». Les modèles restent en millimètres, les feuilles imprimées et les fichiers aussi.</translation>
    </message>
    <message>
        <source>Parts of an inch</source>
        <translation>Fractions de pouce</translation>
    </message>
    <message>
        <source>fraction imperial 1/16 decimals</source>
        <translation>fraction impérial pouce 1/16 décimales</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>Séparateur décimal</translation>
    </message>
    <message>
        <source>comma point dot separator numbers</source>
        <translation>virgule point séparateur décimal nombres</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>translation words english german deutsch</source>
        <translation>traduction mots anglais français english language</translation>
    </message>
    <message>
        <source>Bolster speaks it when it is started the next time.</source>
        <translation>Bolster la parle à son prochain démarrage.</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>colours dark light contrast night appearance accessibility</source>
        <translation>couleurs sombre clair contraste nuit apparence accessibilité</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Size of the letters</source>
        <translation>Taille des caractères</translation>
    </message>
    <message>
        <source>font text large small zoom scale accessibility</source>
        <translation>police texte grand petit zoom échelle lettres accessibilité</translation>
    </message>
    <message>
        <source>Move the views as in</source>
        <translation>Bouger les vues comme dans</translation>
    </message>
    <message>
        <source>navigation rotate turn pan zoom buttons trackpad orbit preset</source>
        <translation>navigation rotation tourner déplacer zoomer boutons pavé tactile trackpad orbite préréglage</translation>
    </message>
    <message>
        <source>Zoom the other way round</source>
        <translation>Inverser le sens du zoom</translation>
    </message>
    <message>
        <source>invert wheel scroll reverse direction</source>
        <translation>inverser molette défilement sens direction</translation>
    </message>
    <message>
        <source>Keys as in</source>
        <translation>Touches comme dans</translation>
    </message>
    <message>
        <source>shortcuts hotkeys preset</source>
        <translation>raccourcis clavier préréglage</translation>
    </message>
    <message>
        <source>Some commands get the keys that you know from there. Keys that you have chosen yourself stay.</source>
        <translation>Certaines commandes reçoivent les touches que vous y connaissez. Les touches que vous avez choisies vous-même restent.</translation>
    </message>
    <message>
        <source>Snap to points, edges, guides and the grid</source>
        <translation>Accrocher aux points, bords, repères et à la grille</translation>
    </message>
    <message>
        <source>magnet catch align</source>
        <translation>magnétisme aimant accrochage aligner</translation>
    </message>
    <message>
        <source>Ctrl or Alt lets go while you drag.</source>
        <translation>Ctrl ou Alt le suspend pendant que vous faites glisser.</translation>
    </message>
    <message>
        <source>Show rulers</source>
        <translation>Afficher les règles</translation>
    </message>
    <message>
        <source>scale measure</source>
        <translation>échelle mesure graduation</translation>
    </message>
    <message>
        <source>Show guides</source>
        <translation>Afficher les repères</translation>
    </message>
    <message>
        <source>lines help</source>
        <translation>lignes guides aide</translation>
    </message>
    <message>
        <source>Quality of the picture</source>
        <translation>Qualité de l’image</translation>
    </message>
    <message>
        <source>performance slow fast remote desktop graphics opengl</source>
        <translation>performances lent rapide bureau à distance graphisme opengl</translation>
    </message>
    <message>
        <source>Reduced: fewer pixels and triangles, no soft shadows. For slow machines and for screens that are far away. Pictures that you export stay fine.</source>
        <translation>Réduite&#x202f;: moins de pixels et de triangles, pas d’ombres douces. Pour les machines lentes et les écrans distants. Les images exportées restent fines.</translation>
    </message>
    <message>
        <source>Go to other views at once, without a flight</source>
        <translation>Passer aux autres vues d’un coup, sans survol</translation>
    </message>
    <message>
        <source>reduced motion animation camera accessibility remote</source>
        <translation>mouvement réduit animation caméra accessibilité distance</translation>
    </message>
    <message>
        <source> days</source>
        <translation> jours</translation>
    </message>
    <message>
        <source>Keep work that was thrown away for</source>
        <translation>Garder le travail jeté pendant</translation>
    </message>
    <message>
        <source>autosave backup recovery crash journal bin unsaved delete</source>
        <translation>enregistrement automatique sauvegarde récupération plantage journal corbeille non enregistré supprimer</translation>
    </message>
    <message>
        <source>Every step is on the disk as soon as it is done, so there is no interval to set. Unsaved work stays until you open it again or throw it away; after that it lies in the bin for at least 30 days.</source>
        <translation>Chaque étape est sur le disque dès qu’elle est faite&#x202f;: il n’y a pas d’intervalle à régler. Le travail non enregistré reste jusqu’à ce que vous le rouvriez ou le jetiez&#x202f;; il est ensuite dans la corbeille pendant au moins 30 jours.</translation>
    </message>
    <message>
        <source>Fabric of new patches</source>
        <translation>Tissu des nouvelles pièces</translation>
    </message>
    <message>
        <source>default material leather weave colour</source>
        <translation>défaut matière matériau cuir tissage couleur</translation>
    </message>
    <message>
        <source>A new design begins with it, and patches are made of a design&apos;s first fabric.</source>
        <translation>Un nouveau modèle commence avec lui, et les pièces sont faites du premier tissu d’un modèle.</translation>
    </message>
    <message>
        <source>Seam allowance</source>
        <translation>Marge de couture</translation>
    </message>
    <message>
        <source>default cutting margin hem width</source>
        <translation>défaut valeur de couture coupe marge ourlet largeur</translation>
    </message>
    <message>
        <source>New designs begin with it; in a design it is changed in its properties.</source>
        <translation>Les nouveaux modèles commencent avec elle&#x202f;; dans un modèle, elle se modifie dans ses propriétés.</translation>
    </message>
    <message>
        <source>Folder of your fabrics</source>
        <translation>Dossier de vos tissus</translation>
    </message>
    <message>
        <source>library directory path import export picture swatch</source>
        <translation>bibliothèque répertoire chemin importer exporter image échantillon</translation>
    </message>
    <message>
        <source>Where fabrics and their pictures are looked for first. Without one it is the folder of the design.</source>
        <translation>Où les tissus et leurs images sont cherchés d’abord. Sans indication, c’est le dossier du modèle.</translation>
    </message>
    <message>
        <source>Lengths are kept as they are, and shown to the nearest part; what is shorter than one has decimals.</source>
        <translation>Les longueurs restent telles quelles et sont montrées à la fraction la plus proche&#x202f;; ce qui est plus court a des décimales.</translation>
    </message>
</context>
<context>
    <name>SavedViewCommands</name>
    <message>
        <source>&amp;Save view …</source>
        <translation>&amp;Enregistrer la vue…</translation>
    </message>
    <message>
        <source>&amp;Delete view</source>
        <translation>&amp;Supprimer la vue</translation>
    </message>
    <message>
        <source>View %1 deleted</source>
        <translation>Vue %1 supprimée</translation>
    </message>
    <message>
        <source>Save view</source>
        <translation>Enregistrer la vue</translation>
    </message>
    <message>
        <source>Name of the view; one of the same name is replaced:</source>
        <translation>Nom de la vue&#x202f;; une vue du même nom est remplacée&#x202f;:</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vue %1</translation>
    </message>
    <message>
        <source>View %1 saved: View &gt; Saved views</source>
        <translation>Vue %1 enregistrée&#x202f;: Affichage &gt; Vues enregistrées</translation>
    </message>
</context>
<context>
    <name>ScanAlignTool</name>
    <message>
        <source>There is no point of the scan here: click on one.</source>
        <translation>Il n’y a pas de point du scan ici&#x202f;: cliquez sur un point.</translation>
    </message>
    <message>
        <source>There is neither a frame nor the cover here: click where that place of the scan belongs.</source>
        <translation>Il n’y a ici ni armature ni housse&#x202f;: cliquez là où va cet endroit du scan.</translation>
    </message>
    <message>
        <source>Take the last place &amp;back</source>
        <translation>&amp;Retirer le dernier endroit</translation>
    </message>
    <message>
        <source>Click on the frame or the cover where place %1 of the scan belongs – Backspace takes it back</source>
        <translation>Cliquez sur l’armature ou la housse, là où va l’endroit %1 du scan – Retour arrière le retire</translation>
    </message>
    <message>
        <source>Click on a place of the scan that can be told from others, such as a corner – drag turns the view, Esc ends the tool</source>
        <translation>Cliquez sur un endroit du scan bien reconnaissable, comme un coin – glisser tourne la vue, Échap quitte l’outil</translation>
    </message>
    <message>
        <source>Click on place %1 of 3 of the scan, far from the others – Backspace takes one back</source>
        <translation>Cliquez sur l’endroit %1 de 3 du scan, loin des autres – Retour arrière en retire un</translation>
    </message>
    <message>
        <source>%1: where it belongs</source>
        <translation>%1&#x202f;: à sa place</translation>
    </message>
    <message>
        <source>%1: on the scan</source>
        <translation>%1&#x202f;: sur le scan</translation>
    </message>
    <message>
        <source>The scan is no longer there – Esc ends the tool</source>
        <translation>Le scan n’est plus là – Échap quitte l’outil</translation>
    </message>
</context>
<context>
    <name>ScanCommands</name>
    <message>
        <source>&amp;Place on the cover</source>
        <translation>&amp;Placer sur la housse</translation>
    </message>
    <message>
        <source>Moves and turns the scan so that it lies on the cover as well as it can</source>
        <translation>Déplace et tourne le scan pour qu’il repose au mieux sur la housse</translation>
    </message>
    <message>
        <source>&amp;Cut away …</source>
        <translation>&amp;Découper…</translation>
    </message>
    <message>
        <source>Drag a rectangle in the 3D view over what is to be cut away of the scan</source>
        <translation>Tracez dans la vue 3D un rectangle sur ce qui doit être retiré du scan</translation>
    </message>
    <message>
        <source>&amp;Keep only …</source>
        <translation>&amp;Garder seulement…</translation>
    </message>
    <message>
        <source>Drag a rectangle in the 3D view around what is to be kept of the scan</source>
        <translation>Tracez dans la vue 3D un rectangle autour de ce qui doit rester du scan</translation>
    </message>
    <message>
        <source>Keep &amp;around the cover</source>
        <translation>Garder au&amp;tour de la housse</translation>
    </message>
    <message>
        <source>Cuts away what is farther from the cover than the threshold</source>
        <translation>Retire ce qui est plus loin de la housse que le seuil</translation>
    </message>
    <message>
        <source>&amp;Remove all cuts</source>
        <translation>&amp;Supprimer toutes les découpes</translation>
    </message>
    <message>
        <source>Brings back all that was cut away of the scan</source>
        <translation>Rétablit tout ce qui a été découpé du scan</translation>
    </message>
    <message>
        <source>Choose another &amp;file …</source>
        <translation>Choisir un autre &amp;fichier…</translation>
    </message>
    <message>
        <source>Reads the scan from another file</source>
        <translation>Lit le scan dans un autre fichier</translation>
    </message>
    <message>
        <source>Select the scan that is meant.</source>
        <translation>Sélectionnez le scan voulu.</translation>
    </message>
    <message>
        <source>Placing the scan on the cover …</source>
        <translation>Placement du scan sur la housse…</translation>
    </message>
    <message>
        <source>Placing the scan on the cover: step %1</source>
        <translation>Placement du scan sur la housse&#x202f;: étape %1</translation>
    </message>
    <message>
        <source>A&amp;lign …</source>
        <translation>&amp;Aligner…</translation>
    </message>
    <message>
        <source>Click three places of the scan and where each belongs; the rest is found</source>
        <translation>Cliquez trois endroits du scan et la place de chacun&#x202f;; le reste est trouvé</translation>
    </message>
    <message>
        <source>Aligning the scan …</source>
        <translation>Alignement du scan…</translation>
    </message>
    <message>
        <source>Aligning the scan: step %1</source>
        <translation>Alignement du scan&#x202f;: étape %1</translation>
    </message>
</context>
<context>
    <name>ScanCutTool</name>
    <message>
        <source>Drag a rectangle around what is to be kept of the scan. Esc ends.</source>
        <translation>Tracez un rectangle autour de ce qui doit rester du scan. Échap termine.</translation>
    </message>
    <message>
        <source>Drag a rectangle over what is to be cut away of the scan. Esc ends.</source>
        <translation>Tracez un rectangle sur ce qui doit être retiré du scan. Échap termine.</translation>
    </message>
</context>
<context>
    <name>ScanForm</name>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Place on &amp;the cover</source>
        <translation>Placer sur la &amp;housse</translation>
    </message>
    <message>
        <source>Choose an&amp;other file …</source>
        <translation>Choisir un a&amp;utre fichier…</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Contenu</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 points</translation>
    </message>
    <message>
        <source>%1 of %2 points, one every %3</source>
        <translation>%1 points sur %2, un tous les %3</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>%1 rms</source>
        <translation>%1 RMS</translation>
    </message>
    <message>
        <source>Median, 95 %</source>
        <translation>Médiane, 95&#x202f;%</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Couverture</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Floor at</source>
        <translation>Sol à</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Découpes</translation>
    </message>
    <message>
        <source>Cut awa&amp;y …</source>
        <translation>&amp;Découper…</translation>
    </message>
    <message>
        <source>&amp;Keep only …</source>
        <translation>&amp;Garder seulement…</translation>
    </message>
    <message>
        <source>Keep aroun&amp;d the cover</source>
        <translation>Garder au&amp;tour de la housse</translation>
    </message>
    <message>
        <source>Remove a&amp;ll cuts</source>
        <translation>&amp;Supprimer toutes les découpes</translation>
    </message>
    <message>
        <source>Ali&amp;gn …</source>
        <translation>&amp;Aligner…</translation>
    </message>
    <message>
        <source>Between the cover and the scan, where they are nearer than the threshold.</source>
        <translation>Entre la housse et le scan, là où ils sont plus proches que le seuil.</translation>
    </message>
    <message>
        <source>Half of what is measured, and 95 % of it, is no farther from the scan than that.</source>
        <translation>La moitié de ce qui est mesuré, et 95&#x202f;%, n’est pas plus loin du scan que cela.</translation>
    </message>
    <message>
        <source>How much of the cover has points of the scan near it.</source>
        <translation>La part de la housse qui a des points du scan à proximité.</translation>
    </message>
    <message>
        <source>Of the scan, without what is cut away.</source>
        <translation>Du scan, sans ce qui est découpé.</translation>
    </message>
</context>
<context>
    <name>SeamForm</name>
    <message>
        <source>First side</source>
        <translation>Premier côté</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Second side</source>
        <translation>Second côté</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Embu</translation>
    </message>
</context>
<context>
    <name>SectionHandle</name>
    <message>
        <source>Section at %1 – Ctrl turns it by 15°, Escape puts it back</source>
        <translation>Plan de coupe à %1 – Ctrl le tourne par 15°, Échap le remet en place</translation>
    </message>
    <message>
        <source>Drag to move the section, with Ctrl to turn it</source>
        <translation>Faites glisser pour déplacer le plan de coupe, avec Ctrl pour le tourner</translation>
    </message>
</context>
<context>
    <name>SelectedEdgesForm</name>
    <message>
        <source>Edge length</source>
        <translation>Longueur du bord</translation>
    </message>
    <message>
        <source>Edge lengths</source>
        <translation>Longueurs des bords</translation>
    </message>
    <message>
        <source>%1 edges. Of &quot;Make equally long&quot; the first one stays: %2 of %3.</source>
        <translation>%1 bords. Avec «&#x202f;Rendre égaux&#x202f;», le premier reste tel quel&#x202f;: %2 de %3.</translation>
    </message>
    <message>
        <source>Edge of</source>
        <translation>Bord de</translation>
    </message>
</context>
<context>
    <name>SelectedPointsForm</name>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Layout x, y</source>
        <translation>Disposition x, y</translation>
    </message>
    <message>
        <source>Length between</source>
        <translation>Longueur entre eux</translation>
    </message>
    <message>
        <source>Space x, y, z</source>
        <translation>Espace x, y, z</translation>
    </message>
</context>
<context>
    <name>SelectionEdits</name>
    <message>
        <source>Not removed: the curve needs these points.</source>
        <translation>Non supprimé&#x202f;: la courbe a besoin de ces points.</translation>
    </message>
    <message>
        <source>Not removed: other elements need this fabric.</source>
        <translation>Non supprimé&#x202f;: d’autres éléments ont besoin de ce tissu.</translation>
    </message>
    <message>
        <source>An edge cannot be removed: its points can, or with Esc the whole patch.</source>
        <translation>Un bord ne peut pas être supprimé&#x202f;: ses points, oui, ou avec Échap toute la pièce.</translation>
    </message>
</context>
<context>
    <name>SettingsForm</name>
    <message>
        <source>Patches</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Coutures</translation>
    </message>
    <message>
        <source>Select something to see its properties.</source>
        <translation>Sélectionnez un élément pour voir ses propriétés.</translation>
    </message>
    <message>
        <source>Symmetric design</source>
        <translation>Modèle symétrique</translation>
    </message>
    <message>
        <source>Plane through</source>
        <translation>Plan par</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Axis through</source>
        <translation>Axe par</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>%1, %2 in all</source>
        <translation>%1, %2 en tout</translation>
    </message>
    <message>
        <source>A point of the plane in which the cover is mirrored</source>
        <translation>Un point du plan dans lequel la housse est réfléchie</translation>
    </message>
    <message>
        <source>The direction straight out of that plane</source>
        <translation>La direction perpendiculaire à ce plan</translation>
    </message>
    <message>
        <source>A point of the line of the pattern at which patches are mirrored</source>
        <translation>Un point de la ligne du patron par rapport à laquelle les pièces sont réfléchies</translation>
    </message>
    <message>
        <source>The direction of that line</source>
        <translation>La direction de cette ligne</translation>
    </message>
    <message>
        <source>Twins are mirror images of each other. With this mark you say where the mirror stands; without it, it stands in the middle, between left and right.</source>
        <translation>Les jumeaux sont l’image l’un de l’autre dans un miroir. Avec cette coche, vous dites où se trouve le miroir&#x202f;; sans elle, il est au milieu, entre gauche et droite.</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Sommets</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>environ %1</translation>
    </message>
    <message>
        <source>How many points the cover has at this edge length: solving takes time and memory for each.</source>
        <translation>Nombre de points de la housse avec cette longueur d’arête&#x202f;: chacun coûte du temps et de la mémoire au calcul.</translation>
    </message>
</context>
<context>
    <name>SewPicture</name>
    <message>
        <source>Ease %1, %2</source>
        <translation>Embu %1, %2</translation>
    </message>
</context>
<context>
    <name>SewTool</name>
    <message>
        <source>Click on the outline of a patch.</source>
        <translation>Cliquez sur le contour d’une pièce.</translation>
    </message>
    <message>
        <source>Choose the other side first.</source>
        <translation>Choisissez d’abord l’autre côté.</translation>
    </message>
    <message>
        <source>Release where the stretch ends</source>
        <translation>Relâchez là où le tronçon finit</translation>
    </message>
    <message>
        <source>Click where the stretch ends – Esc goes back</source>
        <translation>Cliquez là où le tronçon finit – Échap revient</translation>
    </message>
    <message>
        <source>Click to sew it the other way round (F)</source>
        <translation>Cliquez pour coudre dans l’autre sens (F)</translation>
    </message>
    <message>
        <source>Click the edge to sew – drag along the outline, or Shift+click twice, for a part of it; Esc ends the tool</source>
        <translation>Cliquez sur le bord à coudre – glissez le long du contour, ou Maj+clic deux fois, pour une partie&#x202f;; Échap quitte l’outil</translation>
    </message>
    <message>
        <source>Click the edges of the row one after the other, Enter sews – F flips, Backspace takes one back</source>
        <translation>Cliquez les bords à la suite, Entrée coud – F inverse, Retour arrière en retire un</translation>
    </message>
    <message>
        <source>Click the edge it is sewn to – F flips, Ctrl+click or M for several in a row, Backspace goes back</source>
        <translation>Cliquez sur le bord auquel il est cousu – F inverse, Ctrl+clic ou M pour plusieurs à la suite, Retour arrière revient</translation>
    </message>
    <message>
        <source>Ctrl+click the next edge of the row, click the last one – Enter sews, F flips, Backspace takes one back</source>
        <translation>Ctrl+clic sur le bord suivant, clic sur le dernier – Entrée coud, F inverse, Retour arrière en retire un</translation>
    </message>
    <message>
        <source>&amp;Sew what is marked</source>
        <translation>&amp;Coudre ce qui est marqué</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>&amp;Inverser</translation>
    </message>
    <message>
        <source>Take &amp;one edge</source>
        <translation>Prendre &amp;un bord</translation>
    </message>
    <message>
        <source>Take se&amp;veral edges in a row</source>
        <translation>Prendre &amp;plusieurs bords à la suite</translation>
    </message>
    <message>
        <source>&amp;Take back the last edge</source>
        <translation>&amp;Retirer le dernier bord</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>&amp;Abandonner</translation>
    </message>
</context>
<context>
    <name>SewingSheet</name>
    <message>
        <source>Sewing sheet</source>
        <translation>Gamme de montage</translation>
    </message>
    <message>
        <source>Sewing sheet: %1</source>
        <translation>Gamme de montage&#x202f;: %1</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Fournitures</translation>
    </message>
    <message>
        <source>Seams in the order of sewing</source>
        <translation>Coutures dans l’ordre de montage</translation>
    </message>
    <message>
        <source>%1 and %1 mirrored</source>
        <translation>%1 et %1 en miroir</translation>
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
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Quantité</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Tissu</translation>
    </message>
    <message>
        <source>Area as cut</source>
        <translation>Surface coupée</translation>
    </message>
    <message>
        <source>top stitched on both sides</source>
        <translation>surpiquée des deux côtés</translation>
    </message>
    <message>
        <source>top stitched</source>
        <translation>surpiquée</translation>
    </message>
    <message>
        <source>%1 mm long, %2 mm from the seam</source>
        <translation>points de %1&#xa0;mm, à %2&#xa0;mm de la couture</translation>
    </message>
    <message>
        <source>piping, %1 mm thick</source>
        <translation>passepoil de %1&#xa0;mm</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>simple</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>%1, with itself</source>
        <translation>%1, avec elle-même</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Couture</translation>
    </message>
    <message>
        <source>Lengths, mm</source>
        <translation>Longueurs, mm</translation>
    </message>
    <message>
        <source>Allowance, mm</source>
        <translation>Marge, mm</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>Crans</translation>
    </message>
    <message>
        <source>Stitch</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>%1 m², without what lies between the pieces</source>
        <translation>%1&#xa0;m², sans ce qui est entre les pièces</translation>
    </message>
    <message>
        <source>Sewing thread</source>
        <translation>Fil à coudre</translation>
    </message>
    <message>
        <source>Top thread &lt;span style=&quot;background-color:%1&quot;&gt;&amp;nbsp;&amp;nbsp;&amp;nbsp;&amp;nbsp;&lt;/span&gt; %1</source>
        <translation>Fil de surpiqûre &lt;span style=&quot;background-color:%1&quot;&gt;&#xa0;&#xa0;&#xa0;&#xa0;&lt;/span&gt; %1</translation>
    </message>
    <message>
        <source>%1 m, at %2 m for each metre of a row</source>
        <translation>%1&#xa0;m, à %2&#xa0;m par mètre de rangée</translation>
    </message>
    <message>
        <source>Piping</source>
        <translation>Passepoil</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1&#xa0;m</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>Combien</translation>
    </message>
    <message>
        <source>zip</source>
        <translation>fermeture à glissière</translation>
    </message>
    <message>
        <source>Zip</source>
        <translation>Fermeture à glissière</translation>
    </message>
    <message>
        <source>Pieces, with the numbers of their seams</source>
        <translation>Pièces, avec les numéros de leurs coutures</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Coutures</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Width × height as cut</source>
        <translation>Largeur × hauteur coupée</translation>
    </message>
    <message>
        <source>Ease, %</source>
        <translation>Embu,&#x202f;%</translation>
    </message>
    <message>
        <source>nap one way: all pieces point up</source>
        <translation>poil en sens unique&#x202f;: toutes les pièces vers le haut</translation>
    </message>
</context>
<context>
    <name>SnapHints</name>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Midpoint</source>
        <translation>Milieu</translation>
    </message>
    <message>
        <source>On an outline</source>
        <translation>Sur un contour</translation>
    </message>
    <message>
        <source>Aligned</source>
        <translation>Aligné</translation>
    </message>
    <message>
        <source>Direction %1</source>
        <translation>Direction %1</translation>
    </message>
    <message>
        <source>Perpendicular</source>
        <translation>Perpendiculaire</translation>
    </message>
    <message>
        <source>As long: %1</source>
        <translation>Même longueur&#x202f;: %1</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
</context>
<context>
    <name>StartCommands</name>
    <message>
        <source>Start pa&amp;ge</source>
        <translation>Page d’&amp;accueil</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>Nou&amp;velle fenêtre</translation>
    </message>
    <message>
        <source>No other window could be opened.</source>
        <translation>Aucune autre fenêtre n’a pu être ouverte.</translation>
    </message>
    <message>
        <source>The system did not start the program again. Close some programs, and try once more.</source>
        <translation>Le système n’a pas démarré le programme une autre fois. Fermez quelques programmes, puis réessayez.</translation>
    </message>
    <message>
        <source>&amp;Report a problem …</source>
        <translation>&amp;Signaler un problème…</translation>
    </message>
    <message>
        <source>What&apos;s &amp;new</source>
        <translation>&amp;Nouveautés</translation>
    </message>
    <message>
        <source>This is Bolster %1. What is new is under Help &gt; What&apos;s new.</source>
        <translation>Voici Bolster %1. Les nouveautés sont sous Aide &gt; Nouveautés.</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Afficher</translation>
    </message>
    <message>
        <source>The frame is in the 3D view. Draw the curves on it where the cloth is fixed, or the first patch.</source>
        <translation>L’armature est dans la vue 3D. Dessinez-y les courbes où le tissu est fixé, ou la première pièce.</translation>
    </message>
    <message>
        <source>Draw a &amp;fixation curve</source>
        <translation>Dessiner une courbe de &amp;fixation</translation>
    </message>
    <message>
        <source>Draw a &amp;rectangle</source>
        <translation>Dessiner un &amp;rectangle</translation>
    </message>
    <message>
        <source>Pattern of a form …</source>
        <translation>Patron d’après une forme…</translation>
    </message>
</context>
<context>
    <name>StretchEndDrag</name>
    <message>
        <source>%1 long – Ctrl lets go of what is near, Esc takes it back</source>
        <translation>longueur %1 – Ctrl ignore ce qui est proche, Échap annule</translation>
    </message>
    <message>
        <source>%1 long, the other side %2: ease %3, %4 – Ctrl lets go of what is near, Esc takes it back</source>
        <translation>longueur %1, l’autre côté %2&#x202f;: embu %3, %4 – Ctrl ignore ce qui est proche, Échap annule</translation>
    </message>
    <message>
        <source>End of another stretch</source>
        <translation>Bout d’un autre tronçon</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Coin</translation>
    </message>
    <message>
        <source>As long as the other side</source>
        <translation>Même longueur que l’autre côté</translation>
    </message>
</context>
<context>
    <name>SurfaceCommands</name>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>&amp;Figures …</source>
        <translation>&amp;Chiffres…</translation>
    </message>
</context>
<context>
    <name>SweepWindow</name>
    <message>
        <source>&amp;Cut</source>
        <translation>Cou&amp;pe</translation>
    </message>
    <message>
        <source>Each piece is cut so much larger or smaller all around</source>
        <translation>Chaque pièce est coupée d’autant plus grande ou plus petite tout autour</translation>
    </message>
    <message>
        <source>Cut of %1</source>
        <translation>Coupe de %1</translation>
    </message>
    <message>
        <source>S&amp;eams</source>
        <translation>&amp;Coutures</translation>
    </message>
    <message>
        <source>Each seam is sewn so much farther inside or outside, on both sides</source>
        <translation>Chaque couture est cousue d’autant plus à l’intérieur ou à l’extérieur, des deux côtés</translation>
    </message>
    <message>
        <source>Seam %1</source>
        <translation>Couture %1</translation>
    </message>
    <message>
        <source>&amp;Foam</source>
        <translation>&amp;Mousse</translation>
    </message>
    <message>
        <source>Each cushion and foam is so much thicker or thinner</source>
        <translation>Chaque rembourrage et chaque mousse est d’autant plus épais ou plus mince</translation>
    </message>
    <message>
        <source>Thickness of %1</source>
        <translation>Épaisseur de %1</translation>
    </message>
    <message>
        <source>Fi&amp;xations</source>
        <translation>&amp;Fixations</translation>
    </message>
    <message>
        <source>Each fixation curve lies so much elsewhere, along each axis</source>
        <translation>Chaque courbe de fixation est décalée d’autant, selon chaque axe</translation>
    </message>
    <message>
        <source>Place of %1</source>
        <translation>Position de %1</translation>
    </message>
    <message>
        <source>S&amp;tiffness</source>
        <translation>Ri&amp;gidité</translation>
    </message>
    <message>
        <source>Each fabric is so much stiffer or softer</source>
        <translation>Chaque tissu est d’autant plus rigide ou plus souple</translation>
    </message>
    <message>
        <source>Stiffness of %1</source>
        <translation>Rigidité de %1</translation>
    </message>
    <message>
        <source>Sh&amp;rinkage</source>
        <translation>&amp;Retrait</translation>
    </message>
    <message>
        <source>Each piece shrinks or stretches by so much</source>
        <translation>Chaque pièce rétrécit ou s’étire d’autant</translation>
    </message>
    <message>
        <source>Shrinkage of %1</source>
        <translation>Retrait de %1</translation>
    </message>
</context>
<context>
    <name>Templates</name>
    <message>
        <source>Cushion</source>
        <translation>Coussin</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Traversin</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>Banquette</translation>
    </message>
    <message>
        <source>Dining chair</source>
        <translation>Chaise de salle à manger</translation>
    </message>
    <message>
        <source>Wing chair</source>
        <translation>Fauteuil à oreilles</translation>
    </message>
    <message>
        <source>Car seat</source>
        <translation>Siège auto</translation>
    </message>
    <message>
        <source>Headrest</source>
        <translation>Appuie-tête</translation>
    </message>
</context>
<context>
    <name>ToolCommands</name>
    <message>
        <source>&amp;Select and move</source>
        <translation>&amp;Sélectionner et déplacer</translation>
    </message>
    <message>
        <source>Draw &amp;outline</source>
        <translation>Dessiner un c&amp;ontour</translation>
    </message>
    <message>
        <source>Draw &amp;rectangle</source>
        <translation>Dessiner un &amp;rectangle</translation>
    </message>
    <message>
        <source>Draw &amp;ellipse</source>
        <translation>Dessiner une &amp;ellipse</translation>
    </message>
    <message>
        <source>S&amp;plit patch</source>
        <translation>Di&amp;viser une pièce</translation>
    </message>
    <message>
        <source>Draw &amp;handle curve</source>
        <translation>Dessiner une courbe de &amp;maintien</translation>
    </message>
    <message>
        <source>Draw &amp;fancy seam</source>
        <translation>Dessiner une couture &amp;décorative</translation>
    </message>
    <message>
        <source>Se&amp;w</source>
        <translation>&amp;Coudre</translation>
    </message>
    <message>
        <source>&amp;Attach to fixation curve</source>
        <translation>Fi&amp;xer à une courbe de fixation</translation>
    </message>
    <message>
        <source>Stitch or pipe a seam</source>
        <translation>Surpiquer ou passepoiler une couture</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>Mes&amp;urer</translation>
    </message>
    <message>
        <source>&amp;Draw fixation curve</source>
        <translation>Dessiner une courbe de &amp;fixation</translation>
    </message>
    <message>
        <source>Draw &amp;internal line</source>
        <translation>Dessiner une &amp;ligne interne</translation>
    </message>
    <message>
        <source>Allowance of an ed&amp;ge</source>
        <translation>Marge d’un &amp;bord</translation>
    </message>
    <message>
        <source>&amp;Corner of the cut line</source>
        <translation>Coin de la li&amp;gne de coupe</translation>
    </message>
    <message>
        <source>Place &amp;notches</source>
        <translation>Placer des cra&amp;ns</translation>
    </message>
    <message>
        <source>Place &amp;drill holes</source>
        <translation>Placer des &amp;perçages</translation>
    </message>
    <message>
        <source>&amp;Cutting</source>
        <translation>Cou&amp;pe</translation>
    </message>
    <message>
        <source>Draw &amp;dart</source>
        <translation>Dessiner une p&amp;ince</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Visite guidée</translation>
    </message>
    <message>
        <source>The coloured curves on the frame are where the cloth is tied down. Click one of them, then drag one of its points: the cover follows.</source>
        <translation>Les courbes colorées sur l’armature sont là où le tissu est fixé. Cliquez sur l’une d’elles, puis faites glisser un de ses points&#x202f;: la housse suit.</translation>
    </message>
    <message>
        <source>The cover follows while you drag, and comes to rest when you let go.</source>
        <translation>La housse suit pendant que vous faites glisser, et se stabilise quand vous relâchez.</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>Revenir en arrière</translation>
    </message>
    <message>
        <source>Ctrl+Z, or this button, takes back whatever was done, as far as you like. Nothing is lost by it: the history keeps what was undone, too.</source>
        <translation>Ctrl+Z, ou ce bouton, annule tout ce qui a été fait, aussi loin que vous voulez. Rien n’est perdu&#x202f;: l’historique garde aussi ce qui a été annulé.</translation>
    </message>
    <message>
        <source>It is as it was. Undone steps are still in the history.</source>
        <translation>Tout est comme avant. Les étapes annulées sont encore dans l’historique.</translation>
    </message>
    <message>
        <source>Choose a seam</source>
        <translation>Choisir une couture</translation>
    </message>
    <message>
        <source>Seams join two edges of the pattern. Click one, in the pattern or on the cover: both of its edges light up, and the cover shows where it is.</source>
        <translation>Les coutures joignent deux bords du patron. Cliquez sur l’une d’elles, dans le patron ou sur la housse&#x202f;: ses deux bords s’illuminent, et la housse montre où elle est.</translation>
    </message>
    <message>
        <source>Its properties are at the right now.</source>
        <translation>Ses propriétés sont maintenant à droite.</translation>
    </message>
    <message>
        <source>Change how it is sewn</source>
        <translation>Changer la façon de la coudre</translation>
    </message>
    <message>
        <source>With the seam selected, choose another continuity in its properties, or another stitching: an edge, a rounded seam or a smooth one.</source>
        <translation>La couture étant sélectionnée, choisissez dans ses propriétés une autre continuité ou une autre surpiqûre&#x202f;: une arête, une couture arrondie ou lisse.</translation>
    </message>
    <message>
        <source>The cover shows the seam as it will be sewn.</source>
        <translation>La housse montre la couture telle qu’elle sera cousue.</translation>
    </message>
    <message>
        <source>Look at the strain</source>
        <translation>Regarder la déformation</translation>
    </message>
    <message>
        <source>View &gt; Map colours the cover by what the cloth has to bear. Choose Largest strain to see where it is stretched most.</source>
        <translation>Affichage &gt; Carte colore la housse d’après ce que le tissu doit supporter. Choisissez Déformation maximale pour voir où il est le plus étiré.</translation>
    </message>
    <message>
        <source>The legend says how much, and the pointer reads it at any place.</source>
        <translation>La légende dit de combien, et le pointeur lit la valeur à tout endroit.</translation>
    </message>
    <message>
        <source>Change the pattern</source>
        <translation>Modifier le patron</translation>
    </message>
    <message>
        <source>Drag a point of an outline, or cut a dart (Pattern &gt; Draw dart): what you change in the flat is sewn at once.</source>
        <translation>Faites glisser un point d’un contour, ou coupez une pince (Patron &gt; Dessiner une pince)&#x202f;: ce que vous modifiez à plat est cousu aussitôt.</translation>
    </message>
    <message>
        <source>Seams keep their places on an outline that changes.</source>
        <translation>Les coutures gardent leur place sur un contour qui change.</translation>
    </message>
    <message>
        <source>Take it with you</source>
        <translation>L’emporter</translation>
    </message>
    <message>
        <source>File &gt; Export pattern writes DXF, PDF or SVG with seam allowances and notches; Export cover writes the cover for others.</source>
        <translation>Fichier &gt; Exporter le patron écrit du DXF, PDF ou SVG avec marges de couture et crans&#x202f;; Exporter la housse écrit la housse pour les autres.</translation>
    </message>
    <message>
        <source>The file is written.</source>
        <translation>Le fichier est écrit.</translation>
    </message>
    <message>
        <source>That was the tour</source>
        <translation>La visite est finie</translation>
    </message>
    <message>
        <source>You have seen how pattern, seams and frame make the cover. Begin with a design of your own: File &gt; Start page has templates. What each key does is under Help &gt; Keys and mouse.</source>
        <translation>Vous avez vu comment patron, coutures et armature font la housse. Commencez un modèle à vous&#x202f;: Fichier &gt; Page d’accueil a des gabarits. Ce que fait chaque touche est sous Aide &gt; Touches et souris.</translation>
    </message>
    <message>
        <source>Drag a fixation curve</source>
        <translation>Tirer une courbe de fixation</translation>
    </message>
</context>
<context>
    <name>TrimSection</name>
    <message>
        <source>Stitching</source>
        <translation>Surpiqûre</translation>
    </message>
    <message>
        <source>Colour of the thread</source>
        <translation>Couleur du fil</translation>
    </message>
    <message>
        <source>Piping</source>
        <translation>Passepoil</translation>
    </message>
    <message>
        <source>As the patch</source>
        <translation>Comme la pièce</translation>
    </message>
</context>
<context>
    <name>TwinCommands</name>
    <message>
        <source>Make &amp;mirror twin</source>
        <translation>&amp;Créer un jumeau symétrique</translation>
    </message>
    <message>
        <source>Link as t&amp;wins</source>
        <translation>Lier comme &amp;jumeaux</translation>
    </message>
    <message>
        <source>&amp;Unlink twins</source>
        <translation>&amp;Délier les jumeaux</translation>
    </message>
    <message>
        <source>R&amp;elease points from the twin</source>
        <translation>Libérer des &amp;points du jumeau</translation>
    </message>
    <message>
        <source>Re-l&amp;ink points to the twin</source>
        <translation>Relier des poi&amp;nts au jumeau</translation>
    </message>
    <message>
        <source>S&amp;ymmetry …</source>
        <translation>S&amp;ymétrie…</translation>
    </message>
    <message>
        <source>%1, mirrored</source>
        <translation>%1, en miroir</translation>
    </message>
    <message>
        <source>Select patches or curves that have no twin yet.</source>
        <translation>Sélectionnez des pièces ou des courbes qui n’ont pas encore de jumeau.</translation>
    </message>
    <message>
        <source>Nothing that is selected has a twin.</source>
        <translation>Rien de ce qui est sélectionné n’a de jumeau.</translation>
    </message>
    <message>
        <source>Select points of a twin, or a seam on it, that still follow.</source>
        <translation>Sélectionnez des points d’un jumeau, ou une couture dessus, qui suivent encore.</translation>
    </message>
    <message>
        <source>No point that is selected has been released.</source>
        <translation>Aucun point sélectionné n’a été libéré.</translation>
    </message>
</context>
<context>
    <name>TwinForm</name>
    <message>
        <source>Mirror image</source>
        <translation>Image miroir</translation>
    </message>
    <message>
        <source>released</source>
        <translation>libérée</translation>
    </message>
    <message>
        <source>itself</source>
        <translation>elle-même</translation>
    </message>
    <message>
        <source>Re-lin&amp;k to its mirror image</source>
        <translation>&amp;Relier à son image miroir</translation>
    </message>
    <message>
        <source>Re&amp;lease from its mirror image</source>
        <translation>&amp;Libérer de son image miroir</translation>
    </message>
    <message>
        <source>Twin of</source>
        <translation>Jumeau de</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>Exceptions</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message numerus="yes">
        <source>%n released points</source>
        <translation>
            <numerusform>%n point libéré</numerusform>
            <numerusform>%n points libérés</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Unlink from its twin</source>
        <translation>&amp;Délier de son jumeau</translation>
    </message>
    <message>
        <source>Re-link all poi&amp;nts</source>
        <translation>Relier &amp;tous les points</translation>
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
        <translation>%1&#x202f;%</translation>
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
        <translation>Problèmes</translation>
    </message>
    <message>
        <source>It keeps its text and is saved as it is.</source>
        <translation>Il garde son texte et est enregistré tel quel.</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>Show &amp;all</source>
        <translation>&amp;Tout afficher</translation>
    </message>
    <message>
        <source>Show &amp;selection</source>
        <translation>Afficher la &amp;sélection</translation>
    </message>
    <message>
        <source>Look at the &amp;cover from</source>
        <translation>Regarder la &amp;housse depuis</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>A&amp;vant</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>A&amp;rrière</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Gauche</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Droite</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>De&amp;ssus</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>Dess&amp;ous</translation>
    </message>
    <message>
        <source>Three-&amp;quarter</source>
        <translation>&amp;Trois quarts</translation>
    </message>
    <message>
        <source>Sa&amp;ved views</source>
        <translation>V&amp;ues enregistrées</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspective</translation>
    </message>
    <message>
        <source>Sec&amp;tion</source>
        <translation>Plan de &amp;coupe</translation>
    </message>
    <message>
        <source>Lin&amp;k the views</source>
        <translation>&amp;Lier les vues</translation>
    </message>
    <message>
        <source>Show the pointer&apos;s place in the other view, too</source>
        <translation>Montrer aussi la position du pointeur dans l’autre vue</translation>
    </message>
    <message>
        <source>&amp;Hide selected</source>
        <translation>&amp;Masquer la sélection</translation>
    </message>
    <message>
        <source>&amp;Isolate selected</source>
        <translation>&amp;Isoler la sélection</translation>
    </message>
    <message>
        <source>Sho&amp;w hidden again</source>
        <translation>Réafficher les éléments mas&amp;qués</translation>
    </message>
    <message>
        <source>Th&amp;eme</source>
        <translation>Thèm&amp;e</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Comme le s&amp;ystème</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Sombre</translation>
    </message>
    <message>
        <source>&amp;Opacity</source>
        <translation>&amp;Opacité</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>Frames and foam</source>
        <translation>Armatures et mousse</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>Scans</translation>
    </message>
    <message>
        <source>Opacity of frames and scans</source>
        <translation>Opacité des armatures et des scans</translation>
    </message>
    <message>
        <source>Select patches, curves, frames, foam or scans to hide them.</source>
        <translation>Sélectionnez des pièces, courbes, armatures, mousses ou scans pour les masquer.</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>Contraste é&amp;levé</translation>
    </message>
</context>
<context>
    <name>ViewPrint</name>
    <message>
        <source>Print the view</source>
        <translation>Imprimer la vue</translation>
    </message>
    <message>
        <source>The view could not be printed.</source>
        <translation>La vue n’a pas pu être imprimée.</translation>
    </message>
    <message>
        <source>The printer takes nothing at the moment. Look whether it is on and has paper, or print to a file.</source>
        <translation>L’imprimante n’accepte rien pour l’instant. Vérifiez qu’elle est allumée et a du papier, ou imprimez dans un fichier.</translation>
    </message>
</context>
<context>
    <name>WhatsNew</name>
    <message>
        <source>What&apos;s new</source>
        <translation>Nouveautés</translation>
    </message>
</context>
<context>
    <name>WindowCommands</name>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>Partie &amp;suivante de la fenêtre</translation>
    </message>
    <message>
        <source>Pre&amp;vious part of the window</source>
        <translation>Partie &amp;précédente de la fenêtre</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Réinitialiser la disposition</translation>
    </message>
</context>
<context>
    <name>bolster::AreaRow</name>
    <message>
        <source> %</source>
        <translation>&#x202f;%</translation>
    </message>
    <message>
        <source>Onl&amp;y in a painted area</source>
        <translation>&amp;Seulement dans une zone peinte</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Peindre</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>The form and the limit of strain count only there</source>
        <translation>La forme et la limite d’étirement ne comptent que là</translation>
    </message>
    <message>
        <source>Drag over the cover in the 3D view; with Shift held down it takes away</source>
        <translation>Glissez sur la housse dans la vue 3D&#x202f;; avec Maj enfoncée, cela retire</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Rayon du pinceau</translation>
    </message>
    <message>
        <source>Painted area</source>
        <translation>Zone peinte</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
</context>
<context>
    <name>bolster::Banner</name>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>bolster::CanvasChoice</name>
    <message>
        <source>Drawn in software</source>
        <translation>Rendu logiciel</translation>
    </message>
</context>
<context>
    <name>bolster::CauseWindow</name>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>Why is it so?</source>
        <translation>D’où vient l’écart&#x202f;?</translation>
    </message>
    <message>
        <source>The scan of the piece</source>
        <translation>Le scan de l’exemplaire</translation>
    </message>
    <message>
        <source>The scan of a sound piece</source>
        <translation>Le scan d’un exemplaire conforme</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Of a piece that is as it should be: where that lies elsewhere than the cover no cause is looked for</source>
        <translation>D’un exemplaire tel qu’il doit être&#x202f;: là où il s’écarte de la housse, aucune cause n’est cherchée</translation>
    </message>
    <message>
        <source>Scan of the &amp;piece</source>
        <translation>Scan de l’&amp;exemplaire</translation>
    </message>
    <message>
        <source>Scan of a so&amp;und piece</source>
        <translation>Scan d’un exemplaire con&amp;forme</translation>
    </message>
    <message>
        <source>Look for the &amp;cause</source>
        <translation>&amp;Chercher la cause</translation>
    </message>
    <message>
        <source>Looking for a cause …</source>
        <translation>Recherche d’une cause…</translation>
    </message>
    <message>
        <source>Says which one cause explains best how far a built piece lies from the cover: foam, a seam&apos;s allowance, a stretched piece, a fixation off its place, a slipped notch.</source>
        <translation>Dit quelle cause unique explique le mieux l’écart entre un exemplaire fabriqué et la housse&#x202f;: mousse, marge d’une couture, pièce étirée, fixation mal placée, cran décalé.</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Cause</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Explains</source>
        <translation>Explique</translation>
    </message>
    <message>
        <source>Probability</source>
        <translation>Probabilité</translation>
    </message>
    <message>
        <source>Causes</source>
        <translation>Causes</translation>
    </message>
    <message>
        <source>Choose the scan of the piece that was built.</source>
        <translation>Choisissez le scan de l’exemplaire fabriqué.</translation>
    </message>
    <message>
        <source>Covers with each cause are solved …</source>
        <translation>Calcul de housses avec chaque cause…</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Arrêté.</translation>
    </message>
    <message>
        <source>The scan shows nothing of the cover: does it lie where the design is?</source>
        <translation>Le scan ne montre rien de la housse&#x202f;: est-il là où est le modèle&#x202f;?</translation>
    </message>
    <message>
        <source>The scan shows %1 of the cover and lies %2 (rms) from it. All causes together leave %3.</source>
        <translation>Le scan montre %1 de la housse et s’en écarte de %2 (RMS). Toutes les causes ensemble laissent %3.</translation>
    </message>
    <message>
        <source>No single cause explains that better than noise does.</source>
        <translation>Aucune cause seule ne l’explique mieux que le bruit.</translation>
    </message>
    <message>
        <source>Most of the deviation has no cause of these kinds, so the first need not be the right one: give the scan of a sound piece, too.</source>
        <translation>La plus grande part de l’écart n’a pas de cause de ces types, la première n’est donc pas forcément la bonne&#x202f;: donnez aussi le scan d’un exemplaire conforme.</translation>
    </message>
    <message numerus="yes">
        <source>and %n others</source>
        <translation>
            <numerusform>et %n autre</numerusform>
            <numerusform>et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>The scan does not tell it apart from: %1</source>
        <translation>Le scan ne la distingue pas de&#x202f;: %1</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: look again.</source>
        <translation>Le modèle a changé entre-temps&#x202f;: cherchez de nouveau.</translation>
    </message>
    <message>
        <source>Stopped. The list is that of the search before.</source>
        <translation>Arrêté. La liste est celle de la recherche précédente.</translation>
    </message>
    <message>
        <source>The scan lies on the cover: there is nothing to explain.</source>
        <translation>Le scan est sur la housse&#x202f;: il n’y a rien à expliquer.</translation>
    </message>
    <message>
        <source>Even the likeliest cause explains only %1 of it: there may be several, or others than these.</source>
        <translation>Même la cause la plus probable n’en explique que %1&#x202f;: il peut y en avoir plusieurs, ou d’autres que celles-ci.</translation>
    </message>
    <message>
        <source>Foam is thicker or thinner</source>
        <translation>Mousse plus épaisse ou plus mince</translation>
    </message>
    <message>
        <source>Foam is harder or softer</source>
        <translation>Mousse plus dure ou plus souple</translation>
    </message>
    <message>
        <source>Allowance of a seam</source>
        <translation>Marge d’une couture</translation>
    </message>
    <message>
        <source>Piece is larger or smaller</source>
        <translation>Pièce plus grande ou plus petite</translation>
    </message>
    <message>
        <source>Fixation lies elsewhere</source>
        <translation>Fixation à un autre endroit</translation>
    </message>
    <message>
        <source>Seam is sewn shifted</source>
        <translation>Couture cousue décalée</translation>
    </message>
    <message>
        <source>%1 thicker</source>
        <translation>plus épaisse de %1</translation>
    </message>
    <message>
        <source>%1 thinner</source>
        <translation>plus mince de %1</translation>
    </message>
    <message>
        <source>%1 harder</source>
        <translation>plus dure de %1</translation>
    </message>
    <message>
        <source>%1 softer</source>
        <translation>plus souple de %1</translation>
    </message>
    <message>
        <source>%1 farther out</source>
        <translation>%1 plus à l’extérieur</translation>
    </message>
    <message>
        <source>%1 farther in</source>
        <translation>%1 plus à l’intérieur</translation>
    </message>
    <message>
        <source>%1 larger</source>
        <translation>plus grande de %1</translation>
    </message>
    <message>
        <source>%1 smaller</source>
        <translation>plus petite de %1</translation>
    </message>
    <message>
        <source>%1 counter-clockwise</source>
        <translation>%1 dans le sens antihoraire</translation>
    </message>
    <message>
        <source>%1 clockwise</source>
        <translation>%1 dans le sens horaire</translation>
    </message>
    <message>
        <source>Farther out: the allowance was taken narrower, on both sides</source>
        <translation>Plus à l’extérieur&#x202f;: la marge a été prise plus étroite, des deux côtés</translation>
    </message>
    <message>
        <source>Along the edge of %1, as it lies in the pattern</source>
        <translation>Le long du bord de %1, telle qu’elle est dans le patron</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>moins de %1</translation>
    </message>
    <message>
        <source>The scan shows %1 of the cover. Its points lie %2 (rms) from the cover, of which all causes together leave %3. From the cover to the nearest point, as a fit measures, it is %4.</source>
        <translation>Le scan montre %1 de la housse. Ses points s’en écartent de %2 (RMS), dont toutes les causes ensemble laissent %3. De la housse au point le plus proche, comme le mesure un ajustement, il y a %4.</translation>
    </message>
    <message>
        <source>That is far more than such a cause usually is: there may be several, or others than these.</source>
        <translation>C’est bien plus que d’ordinaire pour une telle cause&#x202f;: il peut y en avoir plusieurs, ou d’autres que celles-ci.</translation>
    </message>
    <message>
        <source>What the likeliest cause leaves is more than noise: something else may be wrong, too, and its amount may be off by more than is said.</source>
        <translation>Ce que laisse la cause la plus probable est plus que du bruit&#x202f;: autre chose ne va peut-être pas non plus, et sa valeur peut être plus fausse qu’indiqué.</translation>
    </message>
    <message numerus="yes">
        <source>%n more causes explain some of it, less likely than these.</source>
        <translation>
            <numerusform>%n autre cause en explique un peu, moins probable que celles-ci.</numerusform>
            <numerusform>%n autres causes en expliquent un peu, moins probables que celles-ci.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::ColourwayWindow</name>
    <message>
        <source>Compare colourways</source>
        <translation>Comparer les coloris</translation>
    </message>
    <message>
        <source>The colourway that is shown below</source>
        <translation>Le coloris affiché dessous</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>D’origine</translation>
    </message>
</context>
<context>
    <name>bolster::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Rechercher une commande</translation>
    </message>
    <message>
        <source>There is no such command.</source>
        <translation>Cette commande n’existe pas.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
</context>
<context>
    <name>bolster::CompareWindow</name>
    <message>
        <source>&amp;Take from there</source>
        <translation>&amp;Reprendre de là</translation>
    </message>
    <message>
        <source>Compare versions</source>
        <translation>Comparer les versions</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>Ce qui diffère</translation>
    </message>
    <message>
        <source>There</source>
        <translation>Là</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Maintenant</translation>
    </message>
    <message>
        <source>Makes the chosen elements as they are in the other version: one step in the history</source>
        <translation>Rend les éléments choisis tels qu’ils sont dans l’autre version&#x202f;: une étape de l’historique</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>only now</source>
        <translation>seulement maintenant</translation>
    </message>
    <message>
        <source>only there</source>
        <translation>seulement là</translation>
    </message>
    <message>
        <source>Nothing differs</source>
        <translation>Rien ne diffère</translation>
    </message>
    <message>
        <source>&amp;Move both together</source>
        <translation>&amp;Bouger les deux ensemble</translation>
    </message>
    <message>
        <source>Turning, moving or zooming one version does the same to the other</source>
        <translation>Tourner, déplacer ou zoomer une version fait de même pour l’autre</translation>
    </message>
</context>
<context>
    <name>bolster::ContextMenus</name>
    <message>
        <source>Leave this &amp;piece out</source>
        <translation>Omettre ce &amp;morceau</translation>
    </message>
    <message>
        <source>Hides this piece of the frame from the view, drawing, cushioning and contact; the frame&apos;s properties bring it back</source>
        <translation>Masque ce morceau de l’armature pour la vue, le dessin, le rembourrage et le contact&#x202f;; les propriétés de l’armature le rétablissent</translation>
    </message>
</context>
<context>
    <name>bolster::CoverSelectTool</name>
    <message>
        <source>Kept to an axis; the same key frees it</source>
        <translation>Limité à un axe&#x202f;; la même touche libère</translation>
    </message>
    <message>
        <source>Lifted off the frame along its normal; let go of Ctrl to slide on it</source>
        <translation>Soulevé de l’armature le long de sa normale&#x202f;; relâchez Ctrl pour glisser dessus</translation>
    </message>
    <message>
        <source>On the frame: Ctrl lifts off, S lets go of it, X, Y, Z or Shift keep to an axis</source>
        <translation>Sur l’armature&#x202f;: Ctrl soulève, S détache, X, Y, Z ou Maj limitent à un axe</translation>
    </message>
    <message>
        <source>X, Y, Z or Shift keep to an axis, S keeps to the frame, Ctrl lifts off, Escape cancels</source>
        <translation>X, Y, Z ou Maj limitent à un axe, S reste sur l’armature, Ctrl soulève, Échap annule</translation>
    </message>
    <message>
        <source>Moved by x %1, y %2, z %3</source>
        <translation>Déplacé de x %1, y %2, z %3</translation>
    </message>
</context>
<context>
    <name>bolster::CutFindingsList</name>
    <message>
        <source>What to look at before cutting</source>
        <translation>À regarder avant la coupe</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
</context>
<context>
    <name>bolster::CuttingPanel</name>
    <message>
        <source>A double click shows where it is.</source>
        <translation>Un double-clic montre où c’est.</translation>
    </message>
    <message>
        <source>Nothing to mend: the pattern can be cut.</source>
        <translation>Rien à corriger&#x202f;: le patron peut être coupé.</translation>
    </message>
    <message>
        <source>Looking the pattern over …</source>
        <translation>Examen du patron…</translation>
    </message>
    <message>
        <source>There is no pattern yet.</source>
        <translation>Il n’y a pas encore de patron.</translation>
    </message>
</context>
<context>
    <name>bolster::DesignSession</name>
    <message>
        <source>New design</source>
        <translation>Nouveau modèle</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Tissu</translation>
    </message>
    <message>
        <source>Restored design</source>
        <translation>Modèle restauré</translation>
    </message>
    <message>
        <source> (other)</source>
        <translation> (autre)</translation>
    </message>
    <message>
        <source> (other %1)</source>
        <translation> (autre %1)</translation>
    </message>
</context>
<context>
    <name>bolster::DockTitle</name>
    <message>
        <source>Take out of the window, or put back</source>
        <translation>Détacher de la fenêtre, ou remettre</translation>
    </message>
    <message>
        <source>Close; the Window menu brings it back</source>
        <translation>Fermer&#x202f;; le menu Fenêtre le rouvre</translation>
    </message>
</context>
<context>
    <name>bolster::DropFlow</name>
    <message>
        <source>&quot;%1&quot; cannot be opened.</source>
        <translation>Impossible d’ouvrir «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>The system did not start the program again for another window. Open it from here instead.</source>
        <translation>Le système n’a pas démarré le programme une autre fois pour une autre fenêtre. Ouvrez-le plutôt d’ici.</translation>
    </message>
    <message>
        <source>It is a folder. Drop the files that are in it.</source>
        <translation>C’est un dossier. Déposez les fichiers qu’il contient.</translation>
    </message>
    <message>
        <source>It is not on this computer, or not any more. Save it to a folder first.</source>
        <translation>Il n’est pas sur cet ordinateur, ou n’y est plus. Enregistrez-le d’abord dans un dossier.</translation>
    </message>
    <message>
        <source>Bolster opens projects and designs (%1), frames (%2), scans (%3), patterns (%4) and pictures of fabrics (%5). Save it in one of these formats with the program it comes from.</source>
        <translation>Bolster ouvre les projets et modèles (%1), armatures (%2), scans (%3), patrons (%4) et images de tissus (%5). Enregistrez-le dans l’un de ces formats avec le programme d’où il vient.</translation>
    </message>
</context>
<context>
    <name>bolster::ElementsModel</name>
    <message>
        <source>Hidden in the 3D view</source>
        <translation>Masqué dans la vue 3D</translation>
    </message>
</context>
<context>
    <name>bolster::ElementsView</name>
    <message>
        <source>Find an element</source>
        <translation>Rechercher un élément</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Éléments</translation>
    </message>
    <message>
        <source>By its name, or by a word of its note</source>
        <translation>Par son nom, ou par un mot de sa note</translation>
    </message>
</context>
<context>
    <name>bolster::ExportFlow</name>
    <message>
        <source>Export pattern</source>
        <translation>Exporter le patron</translation>
    </message>
    <message>
        <source>-sewing</source>
        <translation>-montage</translation>
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
        <translation>Écriture de %1…</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Exporté vers %1</translation>
    </message>
    <message>
        <source>The pattern could not be exported.</source>
        <translation>Le patron n’a pas pu être exporté.</translation>
    </message>
    <message>
        <source>Export cover</source>
        <translation>Exporter la housse</translation>
    </message>
    <message>
        <source>-cover</source>
        <translation>-housse</translation>
    </message>
    <message>
        <source>Export foam</source>
        <translation>Exporter la mousse</translation>
    </message>
    <message>
        <source>-foam</source>
        <translation>-mousse</translation>
    </message>
    <message>
        <source>Exporting %1 …</source>
        <translation>Exportation de %1…</translation>
    </message>
    <message>
        <source>The cover could not be exported.</source>
        <translation>La housse n’a pas pu être exportée.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is written.</source>
        <translation>«&#x202f;%1&#x202f;» est écrit.</translation>
    </message>
    <message>
        <source>Export surface</source>
        <translation>Exporter la surface</translation>
    </message>
    <message>
        <source>The surface could not be exported.</source>
        <translation>La surface n’a pas pu être exportée.</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Exporter une image</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>The picture could not be exported.</source>
        <translation>L’image n’a pas pu être exportée.</translation>
    </message>
    <message>
        <source>-surface</source>
        <translation>-surface</translation>
    </message>
</context>
<context>
    <name>bolster::ExportPatternDialog</name>
    <message>
        <source>Export pattern</source>
        <translation>Exporter le patron</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>&amp;Export …</source>
        <translation>&amp;Exporter…</translation>
    </message>
    <message>
        <source>PDF – to print and put together</source>
        <translation>PDF – à imprimer et assembler</translation>
    </message>
    <message>
        <source>DXF AAMA – for cutters</source>
        <translation>DXF AAMA – pour machines de coupe</translation>
    </message>
    <message>
        <source>DXF ASTM – for cutters</source>
        <translation>DXF ASTM – pour machines de coupe</translation>
    </message>
    <message>
        <source>DXF, plain lines</source>
        <translation>DXF, lignes simples</translation>
    </message>
    <message>
        <source>SVG – 1:1</source>
        <translation>SVG – 1:1</translation>
    </message>
    <message>
        <source>HPGL – for plotters</source>
        <translation>HPGL – pour traceurs</translation>
    </message>
    <message>
        <source>Roll, %1 mm wide</source>
        <translation>Rouleau, %1&#xa0;mm de large</translation>
    </message>
    <message>
        <source>&amp;Landscape</source>
        <translation>Pa&amp;ysage</translation>
    </message>
    <message>
        <source>Mirrored pairs as &amp;two pieces</source>
        <translation>Paires symétriques en &amp;deux pièces</translation>
    </message>
    <message>
        <source>The design says it; it is changed in its properties.</source>
        <translation>Le modèle l’indique&#x202f;; cela se modifie dans ses propriétés.</translation>
    </message>
    <message>
        <source>Of patches and edges that have none of their own.</source>
        <translation>Des pièces et des bords qui n’en ont pas de propre.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
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
        <translation>&amp;Marge de couture</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Lignes</translation>
    </message>
    <message>
        <source>Sewing li&amp;nes</source>
        <translation>Lig&amp;nes de couture</translation>
    </message>
    <message>
        <source>Notc&amp;hes</source>
        <translation>Cr&amp;ans</translation>
    </message>
    <message>
        <source>&amp;Grain lines</source>
        <translation>Dro&amp;its-fils</translation>
    </message>
    <message>
        <source>La&amp;bels</source>
        <translation>É&amp;tiquettes</translation>
    </message>
    <message>
        <source>&amp;Internal lines</source>
        <translation>Li&amp;gnes internes</translation>
    </message>
    <message>
        <source>&amp;Drill holes</source>
        <translation>Per&amp;çages</translation>
    </message>
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
            <numerusform>%n pièce est omise&#x202f;: son contour se croise</numerusform>
            <numerusform>%n pièces sont omises&#x202f;: leurs contours se croisent</numerusform>
        </translation>
    </message>
    <message>
        <source>C&amp;ut lines</source>
        <translation>Lignes de co&amp;upe</translation>
    </message>
    <message>
        <source>Sewing sheet (PDF)</source>
        <translation>Gamme de montage (PDF)</translation>
    </message>
    <message>
        <source>DXF, plain curves (R2000)</source>
        <translation>DXF, courbes simples (R2000)</translation>
    </message>
    <message>
        <source>too many sheets: is its unit right?</source>
        <translation>trop de feuilles&#x202f;: l’unité est-elle la bonne&#x202f;?</translation>
    </message>
    <message>
        <source>the first %1 are shown</source>
        <translation>les %1 premières sont affichées</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>Il n’y a rien à couper.</translation>
    </message>
    <message>
        <source>A double click leaves this window and shows where it is; the whole list is in the panel &quot;Check before cutting&quot;.</source>
        <translation>Un double-clic quitte cette fenêtre et montre où c’est&#x202f;; toute la liste est dans le panneau «&#x202f;Vérification avant coupe&#x202f;».</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces on %1</source>
        <translation>
            <numerusform>%n pièce sur %1</numerusform>
            <numerusform>%n pièces sur %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FabricCommands</name>
    <message>
        <source>Rename fabric</source>
        <translation>Renommer le tissu</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nom&#x202f;:</translation>
    </message>
    <message>
        <source>Delete fabric</source>
        <translation>Supprimer le tissu</translation>
    </message>
    <message numerus="yes">
        <source>%n patches have &quot;%1&quot;. What shall they get instead?</source>
        <translation>
            <numerusform>%n pièce a «&#x202f;%1&#x202f;». Que doit-elle recevoir à la place&#x202f;?</numerusform>
            <numerusform>%n pièces ont «&#x202f;%1&#x202f;». Que doivent-elles recevoir à la place&#x202f;?</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the patches that shall get the fabric, then choose it in the library.</source>
        <translation>Sélectionnez les pièces qui doivent recevoir le tissu, puis choisissez-le dans la bibliothèque.</translation>
    </message>
    <message>
        <source>New colourway</source>
        <translation>Nouveau coloris</translation>
    </message>
    <message>
        <source>Name of the colourway; it begins as what is shown now:</source>
        <translation>Nom du coloris&#x202f;; il part de ce qui est affiché&#x202f;:</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>Coloris</translation>
    </message>
    <message>
        <source>Rename colourway</source>
        <translation>Renommer le coloris</translation>
    </message>
    <message>
        <source>Picture of a fabric</source>
        <translation>Image d’un tissu</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Images (%1)</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Lecture de %1…</translation>
    </message>
    <message>
        <source>The picture could not be read.</source>
        <translation>L’image n’a pas pu être lue.</translation>
    </message>
    <message>
        <source>The picture could not be taken into the design.</source>
        <translation>L’image n’a pas pu être reprise dans le modèle.</translation>
    </message>
    <message>
        <source>Import fabrics</source>
        <translation>Importer des tissus</translation>
    </message>
    <message>
        <source>Fabrics, designs and projects (*.json *.bolster)</source>
        <translation>Tissus, modèles et projets (*.json *.bolster)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be read.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas pu être lu.</translation>
    </message>
    <message>
        <source>Nothing was imported.</source>
        <translation>Rien n’a été importé.</translation>
    </message>
    <message numerus="yes">
        <source>%n fabrics imported from %1</source>
        <translation>
            <numerusform>%n tissu importé de %1</numerusform>
            <numerusform>%n tissus importés de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Export fabric</source>
        <translation>Exporter le tissu</translation>
    </message>
    <message>
        <source>Fabrics (*.json)</source>
        <translation>Tissus (*.json)</translation>
    </message>
    <message>
        <source>The fabric could not be exported.</source>
        <translation>Le tissu n’a pas pu être exporté.</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Exporté vers %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not deleted.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas supprimé.</translation>
    </message>
    <message>
        <source>It is the only fabric, and patches are made of it. Add another one first.</source>
        <translation>C’est le seul tissu, et des pièces en sont faites. Ajoutez-en d’abord un autre.</translation>
    </message>
</context>
<context>
    <name>bolster::FabricPanel</name>
    <message>
        <source>Colourways</source>
        <translation>Coloris</translation>
    </message>
    <message>
        <source>A click shows the cover in this colourway</source>
        <translation>Un clic montre la housse dans ce coloris</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>Tissus</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>Coloris</translation>
    </message>
    <message>
        <source>New …</source>
        <translation>Nouveau…</translation>
    </message>
    <message>
        <source>Rename …</source>
        <translation>Renommer…</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Fabrics: drag them onto patches</source>
        <translation>Tissus&#x202f;: à glisser sur les pièces</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Affecter</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Delete …</source>
        <translation>Supprimer…</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>D’origine</translation>
    </message>
    <message>
        <source>No patch has it.</source>
        <translation>Aucune pièce ne l’a.</translation>
    </message>
    <message numerus="yes">
        <source>%n patches have it.</source>
        <translation>
            <numerusform>%n pièce l’a.</numerusform>
            <numerusform>%n pièces l’ont.</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag it onto a patch; a double click shows its properties.</source>
        <translation>Glissez-le sur une pièce&#x202f;; un double-clic montre ses propriétés.</translation>
    </message>
    <message>
        <source>Adds this fabric to the library of the design</source>
        <translation>Ajoute ce tissu à la bibliothèque du modèle</translation>
    </message>
</context>
<context>
    <name>bolster::FieldText</name>
    <message>
        <source>usual</source>
        <translation>habituel</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>turned by %1</source>
        <translation>tourné de %1</translation>
    </message>
    <message>
        <source>%1, from %2 to %3</source>
        <translation>%1, de %2 à %3</translation>
    </message>
    <message numerus="yes">
        <source>%n points, %1</source>
        <translation>
            <numerusform>%n point, %1</numerusform>
            <numerusform>%n points, %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FileChoice</name>
    <message>
        <source>A file …</source>
        <translation>Un fichier…</translation>
    </message>
</context>
<context>
    <name>bolster::FileImportDialog</name>
    <message>
        <source> mm per unit</source>
        <translation> mm par unité</translation>
    </message>
    <message>
        <source>Import scan</source>
        <translation>Importer un scan</translation>
    </message>
    <message>
        <source>Import frame</source>
        <translation>Importer une armature</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimètres</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centimètres</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Mètres</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pouces</translation>
    </message>
    <message>
        <source>Another factor</source>
        <translation>Autre facteur</translation>
    </message>
    <message>
        <source>z points up</source>
        <translation>z vers le haut</translation>
    </message>
    <message>
        <source>y points up</source>
        <translation>y vers le haut</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points</translation>
    </message>
    <message>
        <source>Width, depth, height</source>
        <translation>Largeur, profondeur, hauteur</translation>
    </message>
    <message>
        <source>That is unusual for a piece of furniture: check the unit.</source>
        <translation>C’est inhabituel pour un meuble&#x202f;: vérifiez l’unité.</translation>
    </message>
    <message>
        <source>&amp;Keep scale, position and rotation</source>
        <translation>&amp;Garder échelle, position et rotation</translation>
    </message>
    <message>
        <source>&amp;Place it on the floor, in the middle</source>
        <translation>&amp;Poser au sol, au milieu</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>&amp;Unité du fichier</translation>
    </message>
    <message>
        <source>&amp;Factor</source>
        <translation>&amp;Facteur</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>A&amp;xes</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importer</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>It would be %1 large. Import it like that?</source>
        <translation>Cela ferait %1. Importer ainsi&#x202f;?</translation>
    </message>
    <message>
        <source>Another unit or factor makes it as large as it is meant.</source>
        <translation>Une autre unité ou un autre facteur donne la taille voulue.</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pieds</translation>
    </message>
    <message>
        <source>x points up</source>
        <translation>x vers le haut</translation>
    </message>
    <message>
        <source>The file says its unit and its axes.</source>
        <translation>Le fichier indique son unité et ses axes.</translation>
    </message>
    <message numerus="yes">
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points, %Ln triangles</source>
        <translation>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points, %Ln triangle</numerusform>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points, %Ln triangles</numerusform>
        </translation>
    </message>
    <message>
        <source>The file says its unit; the axes are guessed.</source>
        <translation>Le fichier indique son unité&#x202f;; les axes sont supposés.</translation>
    </message>
    <message>
        <source>The file says its axes; the unit is guessed.</source>
        <translation>Le fichier indique ses axes&#x202f;; l’unité est supposée.</translation>
    </message>
    <message>
        <source>Unit and axes are guessed: look at the picture and the size.</source>
        <translation>Unité et axes sont supposés&#x202f;: regardez l’image et la taille.</translation>
    </message>
    <message>
        <source>&amp;Keep position and rotation</source>
        <translation>&amp;Garder position et rotation</translation>
    </message>
    <message>
        <source>The file has %1 points. That is more than are needed to fit a cover, so they were thinned out to one every %2.</source>
        <translation>Le fichier a %1 points. C’est plus qu’il n’en faut pour ajuster une housse&#x202f;; ils ont donc été réduits à un tous les %2.</translation>
    </message>
    <message>
        <source>It was %1 large and becomes %2: check the unit.</source>
        <translation>La taille était de %1 et devient %2&#x202f;: vérifiez l’unité.</translation>
    </message>
    <message>
        <source>The unit is guessed: look at the size.</source>
        <translation>L’unité est supposée&#x202f;: regardez la taille.</translation>
    </message>
    <message>
        <source>The axes are guessed: look at the picture.</source>
        <translation>Les axes sont supposés&#x202f;: regardez l’image.</translation>
    </message>
</context>
<context>
    <name>bolster::FileTalk</name>
    <message>
        <source>&quot;%1&quot; is not replaced.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas remplacé.</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Lecture de %1…</translation>
    </message>
</context>
<context>
    <name>bolster::FitOrderPanel</name>
    <message>
        <source>Goal</source>
        <translation>Objectif</translation>
    </message>
    <message>
        <source>The cover &amp;lies on</source>
        <translation>La housse re&amp;pose sur</translation>
    </message>
    <message>
        <source>The form that the cover shall lie on</source>
        <translation>La forme sur laquelle la housse doit reposer</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>&amp;Strain is at most</source>
        <translation>La déformation est d’au pl&amp;us</translation>
    </message>
    <message>
        <source>Along the grain, across it, and in shear; the cover stays where it is</source>
        <translation>En droit-fil, en travers et en cisaillement&#x202f;; la housse reste où elle est</translation>
    </message>
    <message>
        <source> %</source>
        <translation>&#x202f;%</translation>
    </message>
    <message>
        <source>Limit of strain</source>
        <translation>Limite de déformation</translation>
    </message>
    <message>
        <source>&amp;No folds in selected patches</source>
        <translation>Aucu&amp;n pli dans les pièces sélectionnées</translation>
    </message>
    <message>
        <source>No cloth of them is pressed together; none selected: all</source>
        <translation>Leur tissu n’est comprimé nulle part&#x202f;; aucune sélectionnée&#x202f;: toutes</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>The selected seam r&amp;uns along</source>
        <translation>La couture sélectionnée sui&amp;t</translation>
    </message>
    <message>
        <source>A curve drawn on the frame or the form; it need hold nothing</source>
        <translation>Une courbe dessinée sur l’armature ou la forme&#x202f;; elle n’a rien à tenir</translation>
    </message>
    <message>
        <source>Share of the area</source>
        <translation>Part de l’aire</translation>
    </message>
    <message>
        <source>Area of selected patches &amp;becomes</source>
        <translation>Aire que gardent les pièces &amp;sélectionnées</translation>
    </message>
    <message>
        <source>Less than 100 %: they become smaller</source>
        <translation>Moins de 100&#x202f;%&#x202f;: elles rapetissent</translation>
    </message>
    <message>
        <source>What may change</source>
        <translation>Ce qui peut changer</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>&amp;Contours</translation>
    </message>
    <message>
        <source>Control points of the patches</source>
        <translation>Points de contrôle des pièces</translation>
    </message>
    <message>
        <source>Ends of seams</source>
        <translation>Bouts de coutures</translation>
    </message>
    <message>
        <source>Where seams and fixations end on smooth edges</source>
        <translation>Où les coutures et les fixations finissent sur des bords lisses</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Embu</translation>
    </message>
    <message>
        <source>Sides of seams may come to differ in length; that is then the ease wanted</source>
        <translation>Les côtés des coutures peuvent devenir de longueurs différentes&#x202f;; c’est alors l’embu voulu</translation>
    </message>
    <message>
        <source>Fo&amp;am</source>
        <translation>&amp;Mousse</translation>
    </message>
    <message>
        <source>How thick cushions and foam are, by whole voxels</source>
        <translation>Épaisseur des rembourrages et de la mousse, par voxels entiers</translation>
    </message>
    <message>
        <source>F&amp;ixations</source>
        <translation>&amp;Fixations</translation>
    </message>
    <message>
        <source>Where fixation curves lie: on their frames, or in space where there is none</source>
        <translation>Où se trouvent les courbes de fixation&#x202f;: sur leurs armatures, ou dans l’espace s’il n’y en a pas</translation>
    </message>
    <message>
        <source>&amp;Pressure</source>
        <translation>Press&amp;ion</translation>
    </message>
    <message>
        <source>The pressure under each patch</source>
        <translation>La pression sous chaque pièce</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Élasticité</translation>
    </message>
    <message>
        <source>Stiffness of the fabrics, and how much they contract across a pull</source>
        <translation>Rigidité des tissus, et combien ils se contractent en travers d’une traction</translation>
    </message>
    <message>
        <source>Of sele&amp;cted patches only</source>
        <translation>Seulement les pièces sé&amp;lectionnées</translation>
    </message>
    <message>
        <source>What stays</source>
        <translation>Ce qui reste</translation>
    </message>
    <message>
        <source>L&amp;engths of seams</source>
        <translation>Longueurs &amp;des coutures</translation>
    </message>
    <message>
        <source>The sides of a seam keep their difference; if it is far from the seam&apos;s ease, it comes nearer to it</source>
        <translation>Les côtés d’une couture gardent leur différence&#x202f;; si elle est loin de l’embu de la couture, elle s’en rapproche</translation>
    </message>
    <message>
        <source>St&amp;raight edges</source>
        <translation>&amp;Bords droits</translation>
    </message>
    <message>
        <source>An&amp;gles of corners</source>
        <translation>An&amp;gles des coins</translation>
    </message>
    <message>
        <source>No point &amp;moves farther than</source>
        <translation>Aucun point ne bouge de plus &amp;que</translation>
    </message>
    <message>
        <source>Choose the scan or the file that the cover shall lie on.</source>
        <translation>Choisissez le scan ou le fichier sur lequel la housse doit reposer.</translation>
    </message>
    <message>
        <source>Select the seam that shall run along the curve.</source>
        <translation>Sélectionnez la couture qui doit suivre la courbe.</translation>
    </message>
    <message>
        <source>Paint the area in the 3D view, or untick it.</source>
        <translation>Peignez la zone dans la vue 3D, ou décochez-la.</translation>
    </message>
    <message>
        <source>Select the patches that shall become larger or smaller.</source>
        <translation>Sélectionnez les pièces qui doivent grandir ou rapetisser.</translation>
    </message>
    <message>
        <source>Choose a goal.</source>
        <translation>Choisissez un objectif.</translation>
    </message>
    <message>
        <source>Edges that look straight stay so: those that bow by less than %1 in %2</source>
        <translation>Les bords qui paraissent droits le restent : ceux dont la flèche est de moins de %1 sur %2</translation>
    </message>
</context>
<context>
    <name>bolster::FlatPiecesView</name>
    <message>
        <source>Pieces laid flat</source>
        <translation>Pièces mises à plat</translation>
    </message>
    <message>
        <source>Strain: %1</source>
        <translation>Déformation&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 et plus</translation>
    </message>
    <message>
        <source>%1: strain %2 (rms)</source>
        <translation>%1&#x202f;: déformation %2 (rms)</translation>
    </message>
</context>
<context>
    <name>bolster::FormChoice</name>
    <message>
        <source>Meshes and scans (%1);;All files (*)</source>
        <translation>Maillages et scans (%1);;Tous les fichiers (*)</translation>
    </message>
</context>
<context>
    <name>bolster::FormPatternWindow</name>
    <message>
        <source>&amp;Make the pattern</source>
        <translation>&amp;Faire le patron</translation>
    </message>
    <message>
        <source>Laying it flat …</source>
        <translation>Mise à plat…</translation>
    </message>
    <message>
        <source>&amp;Make it without what is left out</source>
        <translation>&amp;Faire sans ce qui est omis</translation>
    </message>
    <message>
        <source>Laying a form flat …</source>
        <translation>Mise à plat d’une forme…</translation>
    </message>
    <message>
        <source>What came of it</source>
        <translation>Ce qui en est résulté</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <source>Choose a file with a form above, or import a frame first.</source>
        <translation>Choisissez ci-dessus un fichier avec une forme, ou importez d’abord une armature.</translation>
    </message>
    <message>
        <source>It is laid flat again when you let go.</source>
        <translation>Elle sera remise à plat quand vous relâcherez.</translation>
    </message>
    <message numerus="yes">
        <source>Dividing it, %n pieces so far …</source>
        <translation>
            <numerusform>Division, %n pièce jusqu’ici …</numerusform>
            <numerusform>Division, %n pièces jusqu’ici …</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Lay it flat</source>
        <translation>&amp;Mettre à plat</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>Arrêté.</translation>
    </message>
    <message>
        <source>It was stopped. These are the pieces from before.</source>
        <translation>Arrêté. Ce sont les pièces d’avant.</translation>
    </message>
    <message>
        <source>From a form</source>
        <translation>D’après une forme</translation>
    </message>
</context>
<context>
    <name>bolster::FormWishesPanel</name>
    <message>
        <source>The form to be covered</source>
        <translation>La forme à recouvrir</translation>
    </message>
    <message>
        <source>Meshes and CAD files (%1);;All files (*)</source>
        <translation>Maillages et fichiers CAO (%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Where the grain line runs on the form</source>
        <translation>Où va le droit-fil sur la forme</translation>
    </message>
    <message>
        <source>upwards</source>
        <translation>vers le haut</translation>
    </message>
    <message>
        <source>to the back</source>
        <translation>vers l’arrière</translation>
    </message>
    <message>
        <source>sideways</source>
        <translation>de côté</translation>
    </message>
    <message>
        <source>&amp;Form</source>
        <translation>F&amp;orme</translation>
    </message>
    <message>
        <source>Fa&amp;bric</source>
        <translation>&amp;Tissu</translation>
    </message>
    <message>
        <source>&amp;Grain runs</source>
        <translation>&amp;Droit-fil</translation>
    </message>
    <message>
        <source>It is cut</source>
        <translation>Elle est coupée</translation>
    </message>
    <message>
        <source>and along the ticked lines:</source>
        <translation>et le long des lignes cochées&#x202f;:</translation>
    </message>
    <message>
        <source>where its &amp;parts meet</source>
        <translation>là où ses &amp;parties se rejoignent</translation>
    </message>
    <message>
        <source>at the edges of its &amp;CAD faces</source>
        <translation>aux arêtes de ses faces &amp;CAO</translation>
    </message>
    <message>
        <source>Each face as the CAD program has it, also where two go on smoothly in each other</source>
        <translation>Chaque face telle que le programme de CAO la connaît, même là où deux se prolongent sans pli</translation>
    </message>
    <message>
        <source>where it &amp;bends by more than</source>
        <translation>là où elle se pl&amp;ie de plus de</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>where it would &amp;not lie flat</source>
        <translation>là où elle &amp;ne serait pas à plat</translation>
    </message>
    <message>
        <source>Pieces that would lie over themselves, or be strained by more than the fabric may be, are divided where they bend most or are narrow; an armchair takes some seconds</source>
        <translation>Les pièces qui se recouvriraient, ou seraient plus étirées que le tissu ne l’admet, sont divisées là où elles se plient le plus ou sont étroites&#x202f;; un fauteuil prend quelques secondes</translation>
    </message>
    <message>
        <source>Keep its cover &amp;outside of the frame</source>
        <translation>Garder sa housse h&amp;ors de l’armature</translation>
    </message>
    <message>
        <source>Making the pattern ticks &quot;Keeps the cover outside&quot; at the frame. A cover that is held along its seams alone may sink into the frame or turn inside out.</source>
        <translation>Faire le patron coche « Garde la housse dehors » pour l’armature. Une housse tenue par ses seules coutures peut s’enfoncer dans l’armature ou se retourner.</translation>
    </message>
    <message>
        <source>Patches that this form became before go, with their seams and the curves that hold nothing else. One Undo brings them back.</source>
        <translation>Les pièces issues auparavant de cette forme disparaissent, avec leurs coutures et les courbes qui ne tiennent rien d’autre. Une seule annulation les ramène.</translation>
    </message>
    <message>
        <source>The cover as it is</source>
        <translation>La housse telle quelle</translation>
    </message>
    <message>
        <source>Choose a form</source>
        <translation>Choisir une forme</translation>
    </message>
    <message>
        <source>New fabric</source>
        <translation>Nouveau tissu</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>Tissu</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Replace the %n patches of these names</source>
        <translation>
            <numerusform>&amp;Remplacer la %n pièce de ce nom</numerusform>
            <numerusform>&amp;Remplacer les %n pièces de ces noms</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>(%n curves that hold them will hold nothing)</source>
        <translation>
            <numerusform>(%n courbe qui les tient ne tiendra plus rien)</numerusform>
            <numerusform>(%n courbes qui les tiennent ne tiendront plus rien)</numerusform>
        </translation>
    </message>
    <message>
        <source>They end inside a piece (marked in the 3D view) and do not divide it: each goes on to the border or line that is nearest, along the way shown there</source>
        <translation>Elles finissent à l’intérieur d’une pièce (marqué dans la vue 3D) et ne la divisent pas : chacune continue jusqu’au bord ou à la ligne la plus proche, le long du chemin qui y est montré</translation>
    </message>
    <message numerus="yes">
        <source>Lead %n open ends &amp;on</source>
        <translation>
            <numerusform>Pr&amp;olonger %n bout ouvert</numerusform>
            <numerusform>Pr&amp;olonger %n bouts ouverts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FoundPiecesView</name>
    <message>
        <source>Pieces in the file</source>
        <translation>Pièces du fichier</translation>
    </message>
    <message>
        <source>There is no piece in it.</source>
        <translation>Il n’y a aucune pièce dedans.</translation>
    </message>
    <message>
        <source>Reading …</source>
        <translation>Lecture…</translation>
    </message>
</context>
<context>
    <name>bolster::GlCanvas</name>
    <message>
        <source>No OpenGL: drawn in software</source>
        <translation>Pas d’OpenGL&#x202f;: rendu logiciel</translation>
    </message>
    <message>
        <source>OpenGL is older than 3.3: drawn in software</source>
        <translation>OpenGL antérieur à 3.3&#x202f;: rendu logiciel</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryModel</name>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Modifier</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryPanel</name>
    <message>
        <source>Find a change or a version</source>
        <translation>Rechercher une modification ou une version</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryView</name>
    <message>
        <source>&amp;Go to this version</source>
        <translation>&amp;Aller à cette version</translation>
    </message>
    <message>
        <source>&amp;Name this version …</source>
        <translation>&amp;Nommer cette version…</translation>
    </message>
    <message>
        <source>&amp;Remove its name</source>
        <translation>&amp;Supprimer son nom</translation>
    </message>
    <message>
        <source>&amp;Compare with now …</source>
        <translation>&amp;Comparer avec maintenant…</translation>
    </message>
    <message>
        <source>Name of this branch</source>
        <translation>Nom de cette branche</translation>
    </message>
    <message>
        <source>Name of this version</source>
        <translation>Nom de cette version</translation>
    </message>
    <message>
        <source>Name this &amp;branch …</source>
        <translation>Nommer cette &amp;branche…</translation>
    </message>
</context>
<context>
    <name>bolster::ImportFlow</name>
    <message>
        <source>Frames (%1)</source>
        <translation>Armatures (%1)</translation>
    </message>
    <message>
        <source>Scans (%1)</source>
        <translation>Scans (%1)</translation>
    </message>
    <message>
        <source>Import frame</source>
        <translation>Importer une armature</translation>
    </message>
    <message>
        <source>Import scan</source>
        <translation>Importer un scan</translation>
    </message>
    <message>
        <source>Import pattern</source>
        <translation>Importer un patron</translation>
    </message>
    <message>
        <source>Patterns (%1)</source>
        <translation>Patrons (%1)</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>Choisir un autre fichier</translation>
    </message>
    <message>
        <source>The pattern is imported. What is otherwise than in the file:</source>
        <translation>Le patron est importé. Ce qui diffère du fichier&#x202f;:</translation>
    </message>
    <message>
        <source>Simplifying %1 …</source>
        <translation>Simplification de %1…</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>Écriture de %1…</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be imported.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas pu être importé.</translation>
    </message>
</context>
<context>
    <name>bolster::ImportPatternDialog</name>
    <message>
        <source>Import pattern</source>
        <translation>Importer un patron</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importer</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimètres</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centimètres</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pouces</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Mètres</translation>
    </message>
    <message>
        <source>Sewing lines, with allowances</source>
        <translation>Lignes de couture, avec marges</translation>
    </message>
    <message>
        <source>Cut lines, without allowance</source>
        <translation>Lignes de coupe, sans marge</translation>
    </message>
    <message>
        <source>What the outlines of patches become where the file has both lines.</source>
        <translation>Ce que deviennent les contours des pièces quand le fichier a les deux lignes.</translation>
    </message>
    <message>
        <source>Outlines whose ends are no farther apart are closed by a straight line.</source>
        <translation>Les contours dont les bouts ne sont pas plus éloignés sont fermés par une droite.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>&amp;Unité du fichier</translation>
    </message>
    <message>
        <source>Largest piece</source>
        <translation>Plus grande pièce</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Taille</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>&amp;Contours</translation>
    </message>
    <message>
        <source>&amp;Close gaps up to</source>
        <translation>&amp;Fermer les jours jusqu’à</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1&#xa0;mm</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message numerus="yes">
        <source>, %n pairs</source>
        <translation>
            <numerusform>, %n paire</numerusform>
            <numerusform>, %n paires</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n times</source>
        <translation>
            <numerusform>, %n fois</numerusform>
            <numerusform>, %n fois</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines lay twice on themselves and are taken once.</source>
        <translation>
            <numerusform>%n ligne était en double et est prise une fois.</numerusform>
            <numerusform>%n lignes étaient en double et sont prises une fois.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not read: %1</source>
        <translation>Non lu&#x202f;: %1</translation>
    </message>
    <message>
        <source>The file does not say its unit for certain: look at the measures.</source>
        <translation>Le fichier n’indique pas son unité avec certitude&#x202f;: regardez les mesures.</translation>
    </message>
    <message>
        <source>Pixels (1/96 inch)</source>
        <translation>Pixels (1/96 pouce)</translation>
    </message>
    <message>
        <source>Points (1/72 inch)</source>
        <translation>Points (1/72 pouce)</translation>
    </message>
    <message>
        <source>In no piece and left out, by layer: %1</source>
        <translation>Dans aucune pièce et omis, par calque&#x202f;: %1</translation>
    </message>
    <message>
        <source>Marks of grading, stripes or nothing that is known, left out by layer: %1</source>
        <translation>Marques de gradation, de rayures ou inconnues, omises par calque&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1 has %2 pieces; at most %3 can be imported at once: the first ones are chosen.</source>
        <translation>%1 a %2 pièces&#x202f;; %3 au plus peuvent être importées à la fois&#x202f;: les premières sont choisies.</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message numerus="yes">
        <source>%n outlines are open: their ends are up to %1 apart. Close gaps up to that, if they are outlines.</source>
        <translation>
            <numerusform>%n contour est ouvert&#x202f;: ses bouts sont éloignés jusqu’à %1. Fermez les jours jusqu’à cette valeur, si c’est un contour.</numerusform>
            <numerusform>%n contours sont ouverts&#x202f;: leurs bouts sont éloignés jusqu’à %1. Fermez les jours jusqu’à cette valeur, si ce sont des contours.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::JobsPanel</name>
    <message>
        <source>Nothing is being worked at.</source>
        <translation>Aucun travail en cours.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Tâches</translation>
    </message>
</context>
<context>
    <name>bolster::LeftWork</name>
    <message>
        <source>New design</source>
        <translation>Nouveau modèle</translation>
    </message>
    <message numerus="yes">
        <source>%n more designs are under File &gt; Unsaved work.</source>
        <translation>
            <numerusform>%n autre modèle est sous Fichier &gt; Travail non enregistré.</numerusform>
            <numerusform>%n autres modèles sont sous Fichier &gt; Travail non enregistré.</numerusform>
        </translation>
    </message>
    <message>
        <source>Restoring the work on &quot;%1&quot; …</source>
        <translation>Restauration du travail sur «&#x202f;%1&#x202f;»…</translation>
    </message>
    <message>
        <source>The work stays under File &gt; Unsaved work</source>
        <translation>Le travail reste sous Fichier &gt; Travail non enregistré</translation>
    </message>
    <message>
        <source>The unsaved work on &quot;%1&quot; could not be restored.</source>
        <translation>Le travail non enregistré sur «&#x202f;%1&#x202f;» n’a pas pu être restauré.</translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved edits restored.</source>
        <translation>
            <numerusform>%n modification non enregistrée restaurée.</numerusform>
            <numerusform>%n modifications non enregistrées restaurées.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved edits are in the history, undone or on other branches.</source>
        <translation>
            <numerusform>%n modification non enregistrée est dans l’historique, annulée ou sur une autre branche.</numerusform>
            <numerusform>%n modifications non enregistrées sont dans l’historique, annulées ou sur d’autres branches.</numerusform>
        </translation>
    </message>
    <message>
        <source>Unsaved names of versions or branches restored.</source>
        <translation>Noms non enregistrés de versions ou de branches restaurés.</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Afficher</translation>
    </message>
    <message>
        <source>Go &amp;back to saved</source>
        <translation>Reve&amp;nir à la version enregistrée</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, %2, damaged</source>
        <translation>%1, %2, endommagé</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Rien</translation>
    </message>
</context>
<context>
    <name>bolster::MainWindow</name>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>%1[*] – Bolster</source>
        <translation>%1[*] – Bolster</translation>
    </message>
    <message>
        <source>%1 It is back where it was.</source>
        <translation>%1 Tout est revenu à sa place.</translation>
    </message>
    <message>
        <source>More commands</source>
        <translation>Plus de commandes</translation>
    </message>
    <message>
        <source>The cover sprang by %1.</source>
        <translation>La housse a sauté de %1.</translation>
    </message>
    <message>
        <source>Folded cloth can lie in several ways, and where a drag leaves it depends on the way of the pointer. What you see now follows from the design alone: whoever opens it sees the same, and so do exports and pictures. If you want the other shape, tell the design: hold the cloth there with a handle, or make the piece smaller until it needs no folds.</source>
        <translation>Un tissu plié peut reposer de plusieurs façons, et celle que laisse un glissement dépend du trajet du pointeur. Ce que vous voyez maintenant découle du modèle seul&#x202f;: quiconque l’ouvre voit la même chose, de même que les exportations et les images. Si vous voulez l’autre forme, dites-le au modèle&#x202f;: tenez-y le tissu par une courbe de maintien, ou réduisez la pièce jusqu’à ce qu’elle n’ait plus besoin de plis.</translation>
    </message>
    <message>
        <source>%1[*] (read-only) – Bolster</source>
        <translation>%1[*] (lecture seule) – Bolster</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces are in the pattern. Seam &gt; Propose seams finds what belongs together.</source>
        <translation>
            <numerusform>%n pièce est dans le patron. Couture &gt; Proposer des coutures trouve ce qui va ensemble.</numerusform>
            <numerusform>%n pièces sont dans le patron. Couture &gt; Proposer des coutures trouve ce qui va ensemble.</numerusform>
        </translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>Bolster is still working at something.</source>
        <translation>Bolster a encore un travail en cours.</translation>
    </message>
    <message>
        <source>What is closed now is not finished; files that are being written stay as they were.</source>
        <translation>Ce qui est fermé maintenant n’est pas fini&#x202f;; les fichiers en cours d’écriture restent comme avant.</translation>
    </message>
    <message>
        <source>&amp;Stop it and close</source>
        <translation>&amp;Arrêter et fermer</translation>
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
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>This change has taken away as well: %1</source>
        <translation>Cette modification a aussi retiré&#x202f;: %1</translation>
    </message>
</context>
<context>
    <name>bolster::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Manuel</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>Retour (Alt+Gauche)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation>Avancer (Alt+Droite)</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Avancer</translation>
    </message>
    <message>
        <source>Find in all pages</source>
        <translation>Chercher dans toutes les pages</translation>
    </message>
    <message>
        <source>The manual has no page &quot;%1&quot;.</source>
        <translation>Le manuel n’a pas de page « %1 ».</translation>
    </message>
    <message>
        <source>The manual is in English.</source>
        <translation>Le manuel est en anglais.</translation>
    </message>
</context>
<context>
    <name>bolster::MapLegend</name>
    <message>
        <source>over the fabric&apos;s limit</source>
        <translation>au-delà de la limite du tissu</translation>
    </message>
</context>
<context>
    <name>bolster::MapLink</name>
    <message>
        <source>Largest strain</source>
        <translation>Déformation maximale</translation>
    </message>
    <message>
        <source>Strain along the grain</source>
        <translation>Déformation en droit-fil</translation>
    </message>
    <message>
        <source>Strain across the grain</source>
        <translation>Déformation en travers</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Cisaillement</translation>
    </message>
    <message>
        <source>Mean curvature</source>
        <translation>Courbure moyenne</translation>
    </message>
    <message>
        <source>Distance to the frame</source>
        <translation>Distance à l’armature</translation>
    </message>
    <message>
        <source>hollow</source>
        <translation>creux</translation>
    </message>
    <message>
        <source>bulging</source>
        <translation>bombé</translation>
    </message>
    <message>
        <source>pressed</source>
        <translation>comprimé</translation>
    </message>
    <message>
        <source>stretched</source>
        <translation>étiré</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 dans %2</translation>
    </message>
    <message>
        <source>%1, over the limit of %2</source>
        <translation>%1, au-delà de la limite de %2</translation>
    </message>
    <message>
        <source>Here: %1</source>
        <translation>Ici&#x202f;: %1</translation>
    </message>
    <message>
        <source>over the fabric&apos;s limit</source>
        <translation>au-delà de la limite du tissu</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>dedans</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>dehors</translation>
    </message>
    <message>
        <source>Deviation from the scan</source>
        <translation>Écart au scan</translation>
    </message>
</context>
<context>
    <name>bolster::MarkTool</name>
    <message>
        <source>Hole %1</source>
        <translation>Trou %1</translation>
    </message>
    <message>
        <source>Click to select it, drag to move it – its properties say what it is like</source>
        <translation>Cliquez pour sélectionner, faites glisser pour déplacer – les propriétés en donnent le détail</translation>
    </message>
    <message>
        <source>Click a corner of an outline to choose how its cut lines are joined – Esc ends the tool</source>
        <translation>Cliquez sur un coin d’un contour pour choisir la forme de sa ligne de coupe – Échap quitte l’outil</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no distance from the corner on this edge.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas une distance au coin sur ce bord.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no place: try 120, 40</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas une position&#x202f;: essayez 120, 40</translation>
    </message>
    <message>
        <source>Click an outline to place a notch, or type how far it is from the corner; on a seam the other side gets one, too – Esc ends the tool</source>
        <translation>Cliquez sur un contour pour placer un cran, ou saisissez sa distance au coin&#x202f;; sur une couture, l’autre côté en reçoit un aussi – Échap quitte l’outil</translation>
    </message>
    <message>
        <source>Click inside a patch to place a drill hole, or type where: 120, 40 – Esc ends the tool</source>
        <translation>Cliquez dans une pièce pour placer un perçage, ou saisissez où&#x202f;: 120, 40 – Échap quitte l’outil</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no width of an allowance: try 12</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas une largeur de marge&#x202f;: essayez 12</translation>
    </message>
    <message>
        <source>Drag its handle, or type its width – its properties say what it is like</source>
        <translation>Faites glisser sa poignée, ou saisissez sa largeur – les propriétés en donnent le détail</translation>
    </message>
    <message>
        <source>Click an edge to give it a seam allowance of its own, or type its width; drag its handle – Esc ends the tool</source>
        <translation>Cliquez sur un bord pour lui donner sa propre marge de couture, ou saisissez sa largeur&#x202f;; faites glisser sa poignée – Échap quitte l’outil</translation>
    </message>
    <message>
        <source>Point at an outline, then type how far the notch is from the corner</source>
        <translation>Pointez un contour, puis saisissez la distance du cran au coin</translation>
    </message>
    <message>
        <source>Point into a patch, then type where the drill hole lies: 120, 40</source>
        <translation>Pointez dans une pièce, puis saisissez où est le perçage&#x202f;: 120, 40</translation>
    </message>
    <message>
        <source>Point at an edge, then type how wide its allowance is</source>
        <translation>Pointez un bord, puis saisissez la largeur de sa marge</translation>
    </message>
</context>
<context>
    <name>bolster::NextStep</name>
    <message>
        <source>Next: %1 for the other side.</source>
        <translation>Ensuite&#x202f;: %1 pour l’autre côté.</translation>
    </message>
    <message>
        <source>draw a second patch</source>
        <translation>dessiner une seconde pièce</translation>
    </message>
    <message>
        <source>Next: %1 – click an edge, then the edge it is sewn to.</source>
        <translation>Ensuite&#x202f;: %1 – cliquez sur un bord, puis sur le bord auquel il est cousu.</translation>
    </message>
    <message>
        <source>sew the patches</source>
        <translation>coudre les pièces</translation>
    </message>
    <message>
        <source>Next: %1 and give them a pressure in the properties.</source>
        <translation>Ensuite&#x202f;: %1 et leur donner une pression dans les propriétés.</translation>
    </message>
    <message>
        <source>select all patches</source>
        <translation>sélectionner toutes les pièces</translation>
    </message>
    <message>
        <source>Next: %1 – click points on it, Enter ends – to which the cover is attached.</source>
        <translation>Ensuite&#x202f;: %1 – cliquez des points dessus, Entrée termine – à laquelle la housse est fixée.</translation>
    </message>
    <message>
        <source>draw a fixation curve on the frame</source>
        <translation>dessiner une courbe de fixation sur l’armature</translation>
    </message>
    <message>
        <source>Next: select a fixation curve and %1 to it.</source>
        <translation>Ensuite&#x202f;: sélectionner une courbe de fixation et y %1.</translation>
    </message>
    <message>
        <source>attach an edge</source>
        <translation>fixer un bord</translation>
    </message>
</context>
<context>
    <name>bolster::NumberBox</name>
    <message>
        <source>varies</source>
        <translation>variable</translation>
    </message>
    <message>
        <source>Not taken: a number is needed</source>
        <translation>Non repris&#x202f;: il faut un nombre</translation>
    </message>
    <message>
        <source>Not taken: &quot;%1&quot; is not a length</source>
        <translation>Non repris&#x202f;: «&#x202f;%1&#x202f;» n’est pas une longueur</translation>
    </message>
    <message>
        <source>Not taken: &quot;%1&quot; is not a number</source>
        <translation>Non repris&#x202f;: «&#x202f;%1&#x202f;» n’est pas un nombre</translation>
    </message>
    <message>
        <source>Not taken: %1 is too little, at least %2</source>
        <translation>Non repris&#x202f;: %1 est trop petit, au moins %2</translation>
    </message>
    <message>
        <source>Not taken: %1 is too much, at most %2</source>
        <translation>Non repris&#x202f;: %1 est trop grand, au plus %2</translation>
    </message>
</context>
<context>
    <name>bolster::OpenFlow</name>
    <message>
        <source>Projects and designs (%1)</source>
        <translation>Projets et modèles (%1)</translation>
    </message>
    <message>
        <source>This is the version where you were last; the one in the file is under File &gt; Revert to saved</source>
        <translation>C’est la version où vous étiez en dernier&#x202f;; celle du fichier est sous Fichier &gt; Revenir à la version enregistrée</translation>
    </message>
    <message>
        <source>Open project or design</source>
        <translation>Ouvrir un projet ou un modèle</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open in another window.</source>
        <translation>«&#x202f;%1&#x202f;» est ouvert dans une autre fenêtre.</translation>
    </message>
    <message>
        <source>It can be opened here to look at; what is changed is saved under another name.</source>
        <translation>Il peut être ouvert ici pour consultation&#x202f;; ce qui est modifié s’enregistre sous un autre nom.</translation>
    </message>
    <message numerus="yes">
        <source>%n elements cannot be used as they are; everything else works.</source>
        <translation>
            <numerusform>%n élément n’est pas utilisable tel quel&#x202f;; tout le reste fonctionne.</numerusform>
            <numerusform>%n éléments ne sont pas utilisables tels quels&#x202f;; tout le reste fonctionne.</numerusform>
        </translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Afficher</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Rien encore</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>&amp;Vider cette liste</translation>
    </message>
    <message>
        <source>The samples are not installed</source>
        <translation>Les exemples ne sont pas installés</translation>
    </message>
</context>
<context>
    <name>bolster::PagesView</name>
    <message>
        <source>Pages</source>
        <translation>Pages</translation>
    </message>
</context>
<context>
    <name>bolster::PartsTree</name>
    <message>
        <source>Part</source>
        <translation>Partie</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Parties</translation>
    </message>
</context>
<context>
    <name>bolster::PatternCommands</name>
    <message>
        <source>This stretch is straight already.</source>
        <translation>Ce tronçon est déjà droit.</translation>
    </message>
    <message>
        <source>They are equally long already.</source>
        <translation>Ils sont déjà égaux.</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Cou&amp;per</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>C&amp;oller</translation>
    </message>
    <message>
        <source>Dupl&amp;icate</source>
        <translation>&amp;Dupliquer</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>Dispos&amp;er</translation>
    </message>
    <message>
        <source>Turn 90° to the &amp;left</source>
        <translation>Tourner de 90° à &amp;gauche</translation>
    </message>
    <message>
        <source>Turn 90° to the &amp;right</source>
        <translation>Tourner de 90° à &amp;droite</translation>
    </message>
    <message>
        <source>Mirror hori&amp;zontally</source>
        <translation>Miroir &amp;horizontal</translation>
    </message>
    <message>
        <source>Mirror &amp;vertically</source>
        <translation>Miroir &amp;vertical</translation>
    </message>
    <message>
        <source>Al&amp;ign</source>
        <translation>&amp;Aligner</translation>
    </message>
    <message>
        <source>&amp;Left edges</source>
        <translation>Bords &amp;gauches</translation>
    </message>
    <message>
        <source>Centres in a &amp;column</source>
        <translation>Centres en &amp;colonne</translation>
    </message>
    <message>
        <source>&amp;Right edges</source>
        <translation>Bords &amp;droits</translation>
    </message>
    <message>
        <source>&amp;Top edges</source>
        <translation>Bords &amp;supérieurs</translation>
    </message>
    <message>
        <source>Centres in a ro&amp;w</source>
        <translation>Centres en &amp;rangée</translation>
    </message>
    <message>
        <source>&amp;Bottom edges</source>
        <translation>Bords &amp;inférieurs</translation>
    </message>
    <message>
        <source>&amp;Distribute</source>
        <translation>&amp;Répartir</translation>
    </message>
    <message>
        <source>&amp;Horizontally</source>
        <translation>&amp;Horizontalement</translation>
    </message>
    <message>
        <source>&amp;Vertically</source>
        <translation>&amp;Verticalement</translation>
    </message>
    <message>
        <source>Arrange &amp;automatically</source>
        <translation>Disposer a&amp;utomatiquement</translation>
    </message>
    <message>
        <source>Poin&amp;ts and edges</source>
        <translation>Poin&amp;ts et bords</translation>
    </message>
    <message>
        <source>Make &amp;corner</source>
        <translation>Faire un &amp;coin</translation>
    </message>
    <message>
        <source>Make s&amp;mooth</source>
        <translation>Rendre &amp;lisse</translation>
    </message>
    <message>
        <source>Strai&amp;ghten</source>
        <translation>Rendre &amp;droit</translation>
    </message>
    <message>
        <source>Edge &amp;length …</source>
        <translation>Lon&amp;gueur du bord…</translation>
    </message>
    <message>
        <source>Type the length of the selected edge</source>
        <translation>Saisir la longueur du bord sélectionné</translation>
    </message>
    <message>
        <source>Make e&amp;qually long</source>
        <translation>Re&amp;ndre égaux</translation>
    </message>
    <message>
        <source>Makes the selected edges as long as the first one, or the second side of a seam as long as its first</source>
        <translation>Donne aux bords sélectionnés la longueur du premier, ou au second côté d’une couture celle du premier</translation>
    </message>
    <message>
        <source>Mirror twi&amp;ns</source>
        <translation>&amp;Jumeaux symétriques</translation>
    </message>
    <message>
        <source>Merge a&amp;long seam</source>
        <translation>&amp;Fusionner le long de la couture</translation>
    </message>
    <message>
        <source>Smooth &amp;across seam ends</source>
        <translation>Lisser au&amp;x bouts de couture</translation>
    </message>
    <message>
        <source>Outlines go on without a kink from one patch to the other where the selected seams end, when both sides lie together</source>
        <translation>Là où finissent les coutures sélectionnées, les contours continuent sans angle d’une pièce à l’autre quand les deux côtés sont réunis</translation>
    </message>
    <message>
        <source>They go on without a kink already.</source>
        <translation>Ils continuent déjà sans angle.</translation>
    </message>
</context>
<context>
    <name>bolster::PatternFitWindow</name>
    <message>
        <source>&amp;Take the changes</source>
        <translation>&amp;Reprendre les modifications</translation>
    </message>
    <message>
        <source>Changes of</source>
        <translation>Modifications de</translation>
    </message>
    <message>
        <source>Moves by</source>
        <translation>Bouge de</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Modifications</translation>
    </message>
    <message>
        <source>What is ticked is changed</source>
        <translation>Ce qui est coché est modifié</translation>
    </message>
    <message>
        <source>&amp;How much of it</source>
        <translation>&amp;Combien</translation>
    </message>
    <message>
        <source>Solving the cover …</source>
        <translation>Calcul de la housse…</translation>
    </message>
    <message>
        <source>Stopped; nothing has changed.</source>
        <translation>Arrêté&#x202f;; rien n’a changé.</translation>
    </message>
    <message>
        <source>&amp;Find changes</source>
        <translation>C&amp;hercher des modifications</translation>
    </message>
    <message>
        <source>The cover moves by %1 (rms).</source>
        <translation>La housse bouge de %1 (RMS).</translation>
    </message>
    <message>
        <source>On the way a fold came or went: look at the cover before you take it.</source>
        <translation>En chemin, un pli est apparu ou a disparu&#x202f;: regardez la housse avant de reprendre.</translation>
    </message>
    <message numerus="yes">
        <source>%n of the numbers that may change do nothing here.</source>
        <translation>
            <numerusform>%n des nombres qui peuvent changer ne fait rien ici.</numerusform>
            <numerusform>%n des nombres qui peuvent changer ne font rien ici.</numerusform>
        </translation>
    </message>
    <message>
        <source>Arrows in the pattern: %1 times as long as the way</source>
        <translation>Flèches dans le patron&#x202f;: %1 fois la longueur du trajet</translation>
    </message>
    <message>
        <source>Arrows in the pattern: where its outlines go</source>
        <translation>Flèches dans le patron&#x202f;: où vont ses contours</translation>
    </message>
    <message>
        <source>Taken. Undo takes it back.</source>
        <translation>Repris. Annuler revient en arrière.</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: find the changes again.</source>
        <translation>Le modèle a changé entre-temps&#x202f;: cherchez de nouveau les modifications.</translation>
    </message>
    <message>
        <source>With all of the changes:</source>
        <translation>Avec toutes les modifications&#x202f;:</translation>
    </message>
    <message>
        <source>Fitting the pattern …</source>
        <translation>Ajustement du patron…</translation>
    </message>
    <message>
        <source>Changing the pattern …</source>
        <translation>Modification du patron…</translation>
    </message>
    <message>
        <source>Pressed together: %1 before, %2 now</source>
        <translation>Comprimé&#x202f;: %1 avant, %2 maintenant</translation>
    </message>
    <message>
        <source>From the curve: %1 before, %2 now (rms)</source>
        <translation>De la courbe&#x202f;: %1 avant, %2 maintenant (RMS)</translation>
    </message>
    <message>
        <source>Off the area that is wanted: %1 before, %2 now</source>
        <translation>Écart à l’aire voulue&#x202f;: %1 avant, %2 maintenant</translation>
    </message>
    <message>
        <source>Nothing is over the limits: there is nothing to do.</source>
        <translation>Rien ne dépasse les limites&#x202f;: il n’y a rien à faire.</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit (before: %2), on few triangles at first</source>
        <translation>%1 de la housse dépasse la limite (avant&#x202f;: %2), d’abord sur peu de triangles</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit (before: %2)</source>
        <translation>%1 de la housse dépasse la limite (avant&#x202f;: %2)</translation>
    </message>
    <message>
        <source>With what is shown of the changes the cover cannot be solved.</source>
        <translation>Avec la part des modifications qui est montrée, la housse ne peut pas être calculée.</translation>
    </message>
    <message>
        <source>With what is shown of the changes:</source>
        <translation>Avec la part des modifications qui est montrée&#x202f;:</translation>
    </message>
    <message>
        <source>Nothing of the changes is shown now: move the slider to see them.</source>
        <translation>Rien des modifications n’est montré maintenant&#x202f;: déplacez le curseur pour les voir.</translation>
    </message>
    <message>
        <source>Sides of seams differ by up to %1 more than is wanted: change their neighbours, too, or let the ease change.</source>
        <translation>Les côtés des coutures diffèrent de jusqu’à %1 de plus que voulu&#x202f;: modifiez aussi les voisines, ou laissez varier l’embu.</translation>
    </message>
    <message>
        <source>Strained over the limit: %1 of the painted area before, %2 now</source>
        <translation>Déformé au-delà de la limite&#x202f;: %1 de la zone peinte avant, %2 maintenant</translation>
    </message>
    <message>
        <source>Strained over the limit: %1 of the cover before, %2 now</source>
        <translation>Déformé au-delà de la limite&#x202f;: %1 de la housse avant, %2 maintenant</translation>
    </message>
    <message>
        <source>That is hardly nearer, and strains the cloth more: let something else change, or less of it.</source>
        <translation>C’est à peine plus près, et le tissu est plus déformé&#x202f;: laissez changer autre chose, ou moins.</translation>
    </message>
    <message>
        <source>Stopped. What was found until then makes it no better: nothing has changed.</source>
        <translation>Arrêté. Ce qui a été trouvé jusque-là ne l’améliore pas&#x202f;: rien n’a changé.</translation>
    </message>
    <message>
        <source>Stopped. With all of the changes that were found until then, measured anew on all triangles:</source>
        <translation>Arrêté. Avec toutes les modifications trouvées jusque-là, mesurées à nouveau sur tous les triangles&#x202f;:</translation>
    </message>
    <message>
        <source>Sides of seams off their ease: up to %1 before, %2 now</source>
        <translation>Côtés de coutures hors de leur embu&#x202f;: jusqu’à %1 avant, %2 maintenant</translation>
    </message>
    <message>
        <source> %</source>
        <translation>&#x202f;%</translation>
    </message>
    <message>
        <source>Over the fabrics&apos; limits: %1 of the cover before, %2 now</source>
        <translation>Au-delà des limites des tissus&#x202f;: %1 de la housse avant, %2 maintenant</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: find the changes again, or undo that.</source>
        <translation>Le modèle a changé entre-temps&#x202f;: cherchez de nouveau les modifications, ou annulez cela.</translation>
    </message>
    <message>
        <source>Taken back. Move the slider to see the changes again.</source>
        <translation>Annulé. Déplacez le curseur pour revoir les modifications.</translation>
    </message>
    <message>
        <source>That is hardly nearer to the limit: let something else change, or more of it.</source>
        <translation>Ce n’est guère plus près de la limite&#x202f;: laissez autre chose changer, ou davantage.</translation>
    </message>
    <message>
        <source>%1 from %3 (rms; before: %2), on few triangles at first</source>
        <translation>à %1 de %3 (RMS&#x202f;; avant&#x202f;: %2), d’abord sur peu de triangles</translation>
    </message>
    <message>
        <source>%1 from %3 (rms; before: %2)</source>
        <translation>à %1 de %3 (RMS&#x202f;; avant&#x202f;: %2)</translation>
    </message>
    <message>
        <source>From %5: %1 before, %2 now (rms); %3 before, %4 now (95 %)</source>
        <translation>De %5&#x202f;: %1 avant, %2 maintenant (RMS)&#x202f;; %3 avant, %4 maintenant (95&#x202f;%)</translation>
    </message>
    <message>
        <source>That is hardly nearer to %1: let something else change, or more of it.</source>
        <translation>Ce n’est guère plus près de %1&#x202f;: laissez autre chose changer, ou davantage.</translation>
    </message>
    <message>
        <source>Hardly less is pressed together: let something else change, or more of it.</source>
        <translation>Il n’y a guère moins de tissu comprimé&#x202f;: laissez autre chose changer, ou davantage.</translation>
    </message>
    <message>
        <source>That is hardly nearer to the curve: let something else change, or more of it.</source>
        <translation>Ce n’est guère plus près de la courbe&#x202f;: laissez autre chose changer, ou davantage.</translation>
    </message>
    <message>
        <source>That is hardly nearer to the area that is wanted: let something else change, or more of it.</source>
        <translation>Ce n’est guère plus près de la surface voulue&#x202f;: laissez autre chose changer, ou davantage.</translation>
    </message>
    <message>
        <source>Changes the pattern until the cover is as it is wished: tick one goal or several, and what may change.</source>
        <translation>Change le patron jusqu’à ce que la housse soit comme voulue&#x202f;: cochez un ou plusieurs buts, et ce qui peut changer.</translation>
    </message>
    <message>
        <source>%1 of the painted area is over the limit (before: %2), on few triangles at first</source>
        <translation>%1 de la surface peinte dépasse la limite (avant&#x202f;: %2), d’abord sur peu de triangles</translation>
    </message>
    <message>
        <source>%1 of the painted area is over the limit (before: %2)</source>
        <translation>%1 de la surface peinte dépasse la limite (avant&#x202f;: %2)</translation>
    </message>
    <message>
        <source>No change makes it better on all triangles: let something else change, or points move farther.</source>
        <translation>Aucune modification n’améliore le résultat sur tous les triangles&#x202f;: laissez autre chose changer, ou les points aller plus loin.</translation>
    </message>
    <message>
        <source>More of the cloth is strained over its limits: make these a goal, too, or let points move less.</source>
        <translation>Davantage de tissu est étiré au-delà de ses limites&#x202f;: faites-en aussi un but, ou laissez les points bouger moins.</translation>
    </message>
    <message>
        <source>What is wished</source>
        <translation>Ce qui est souhaité</translation>
    </message>
    <message>
        <source>Fit to a goal</source>
        <translation>Ajuster à un objectif</translation>
    </message>
</context>
<context>
    <name>bolster::PatternRuler</name>
    <message>
        <source>Drag down for a level guide. Marks move upright guides; drag them off to remove them.</source>
        <translation>Glissez vers le bas pour un repère horizontal. Les marques déplacent les repères verticaux&#x202f;; glissez-les hors de la règle pour les supprimer.</translation>
    </message>
    <message>
        <source>Drag to the right for an upright guide. Marks move level guides; drag them off to remove them.</source>
        <translation>Glissez vers la droite pour un repère vertical. Les marques déplacent les repères horizontaux&#x202f;; glissez-les hors de la règle pour les supprimer.</translation>
    </message>
</context>
<context>
    <name>bolster::PreferencesWindow</name>
    <message>
        <source>Preferences (*.json)</source>
        <translation>Préférences (*.json)</translation>
    </message>
    <message>
        <source>No setting has these words.</source>
        <translation>Aucun réglage n’a ces mots.</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>Find a setting</source>
        <translation>Rechercher un réglage</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Pages</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>&amp;Edit single shortcuts …</source>
        <translation>&amp;Modifier les raccourcis un par un…</translation>
    </message>
    <message>
        <source>Back to &amp;defaults</source>
        <translation>Revenir aux valeurs par &amp;défaut</translation>
    </message>
    <message>
        <source>All settings of this page</source>
        <translation>Tous les réglages de cette page</translation>
    </message>
    <message>
        <source>E&amp;xport …</source>
        <translation>E&amp;xporter…</translation>
    </message>
    <message>
        <source>&amp;Import …</source>
        <translation>&amp;Importer…</translation>
    </message>
    <message>
        <source>Export preferences</source>
        <translation>Exporter les préférences</translation>
    </message>
    <message>
        <source>Bolster preferences.json</source>
        <translation>Préférences Bolster.json</translation>
    </message>
    <message>
        <source>Import preferences</source>
        <translation>Importer des préférences</translation>
    </message>
    <message>
        <source>The preferences could not be exported.</source>
        <translation>Les préférences n’ont pas pu être exportées.</translation>
    </message>
    <message>
        <source>Nothing was imported from &quot;%1&quot;; all settings are as they were.</source>
        <translation>Rien n’a été importé de «&#x202f;%1&#x202f;»&#x202f;; tous les réglages sont comme avant.</translation>
    </message>
    <message>
        <source>The preferences were imported.</source>
        <translation>Les préférences ont été importées.</translation>
    </message>
    <message numerus="yes">
        <source>This version of Bolster does not know %n of them: %1</source>
        <translation>
            <numerusform>Cette version de Bolster n’en connaît pas %n&#x202f;: %1</numerusform>
            <numerusform>Cette version de Bolster n’en connaît pas %n&#x202f;: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Tourner</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Déplacer la vue</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomer</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>Dans la vue 3D</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>Dans le patron</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no folder on this machine: the folder of your fabrics stays what it was.</source>
        <translation>« %1 » n’est pas un dossier de cette machine&#x202f;: le dossier de vos tissus reste inchangé.</translation>
    </message>
    <message>
        <source>&amp;Restart now</source>
        <translation>&amp;Redémarrer maintenant</translation>
    </message>
    <message>
        <source>Closes Bolster, and asks about unsaved work as always; then it starts again with the same project</source>
        <translation>Ferme Bolster, en demandant comme toujours quoi faire du travail non enregistré, puis le redémarre avec le même projet</translation>
    </message>
</context>
<context>
    <name>bolster::ProblemsView</name>
    <message>
        <source>F1: what it means, and what to do</source>
        <translation>F1 : ce que cela signifie et que faire</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>Nothing to worry about.</source>
        <translation>Rien d’inquiétant.</translation>
    </message>
    <message>
        <source>All elements can be used.</source>
        <translation>Tous les éléments sont utilisables.</translation>
    </message>
</context>
<context>
    <name>bolster::PullNote</name>
    <message>
        <source>The cover in the 3D view is pulled to a scan; here it counts as the pattern alone makes it.</source>
        <translation>La housse de la vue 3D est tirée vers un scan&#x202f;; ici elle compte telle que le patron seul la fait.</translation>
    </message>
    <message>
        <source>No scan pulls at the cover any more (a step in the history).</source>
        <translation>Plus aucun scan ne tire la housse (une étape de l’historique).</translation>
    </message>
    <message>
        <source>Switch the pull off</source>
        <translation>Désactiver la traction</translation>
    </message>
    <message>
        <source>Pull again</source>
        <translation>Tirer de nouveau</translation>
    </message>
</context>
<context>
    <name>bolster::ReliefWindow</name>
    <message>
        <source>Relieve strain</source>
        <translation>Détendre le tissu</translation>
    </message>
    <message>
        <source>&amp;Look for changes</source>
        <translation>C&amp;hercher des modifications</translation>
    </message>
    <message>
        <source>Looking for what relieves strain …</source>
        <translation>Recherche de ce qui détend le tissu…</translation>
    </message>
    <message>
        <source>Where cloth is strained or pressed together more than it may be, changes of the pattern are tried, and the best are solved.</source>
        <translation>Là où le tissu est plus déformé ou comprimé qu’il ne doit, des modifications du patron sont essayées, et les meilleures calculées.</translation>
    </message>
    <message>
        <source>Proposed changes</source>
        <translation>Modifications proposées</translation>
    </message>
    <message>
        <source>Strain is at &amp;most</source>
        <translation>La déformation est d’au pl&amp;us</translation>
    </message>
    <message>
        <source>Else the limits of the fabrics count</source>
        <translation>Sinon, les limites des tissus comptent</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Limit of strain</source>
        <translation>Limite de déformation</translation>
    </message>
    <message>
        <source>Edges move &amp;by at most</source>
        <translation>Les &amp;bords bougent d’au plus</translation>
    </message>
    <message>
        <source>Trying changes …</source>
        <translation>Essai de modifications…</translation>
    </message>
    <message>
        <source>Stopped; nothing has changed.</source>
        <translation>Arrêté&#x202f;; rien n’a changé.</translation>
    </message>
    <message>
        <source>Nothing is strained over the limit.</source>
        <translation>Rien n’est déformé au-delà de la limite.</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit. No change relieves it.</source>
        <translation>%1 de la housse dépasse la limite. Aucune modification ne la détend.</translation>
    </message>
    <message>
        <source>Each is solved by itself; &quot;Make it&quot; is one step that Undo takes back.</source>
        <translation>Chacune est calculée séparément&#x202f;; «&#x202f;Appliquer&#x202f;» est une seule étape, que l’on peut annuler.</translation>
    </message>
    <message>
        <source>As it is now</source>
        <translation>État actuel</translation>
    </message>
    <message>
        <source>Sewn: %1 more</source>
        <translation>Cousu&#x202f;: %1 de plus</translation>
    </message>
    <message>
        <source>Sides of seams differ by %1 more</source>
        <translation>Côtés de coutures plus inégaux de %1</translation>
    </message>
    <message>
        <source>Outlines change by %1</source>
        <translation>Contours modifiés de %1</translation>
    </message>
    <message>
        <source>Show where</source>
        <translation>Montrer où</translation>
    </message>
    <message>
        <source>Make it</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Make it: %1</source>
        <translation>Appliquer&#x202f;: %1</translation>
    </message>
    <message>
        <source>Made. Undo takes it back; look again to see what helps now.</source>
        <translation>Appliqué. Annuler revient en arrière&#x202f;; cherchez de nouveau pour voir ce qui aide maintenant.</translation>
    </message>
    <message>
        <source>Stopped. These are solved:</source>
        <translation>Arrêté. Celles-ci sont calculées&#x202f;:</translation>
    </message>
    <message>
        <source>The best changes are being solved …</source>
        <translation>Calcul des meilleures modifications…</translation>
    </message>
    <message>
        <source>Hardly anything is over the limit: there is little to gain. &quot;Make it&quot; is one step that Undo takes back.</source>
        <translation>Presque rien ne dépasse la limite&#x202f;: il y a peu à gagner. «&#x202f;Appliquer&#x202f;» est une seule étape, que l’on peut annuler.</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit, by %2 (rms of all of it).</source>
        <translation>%1 de la housse dépasse la limite, de %2 (RMS sur toute la housse).</translation>
    </message>
    <message>
        <source>Over the limit: %1 of the cover, then %2</source>
        <translation>Au-delà de la limite&#x202f;: %1 de la housse, puis %2</translation>
    </message>
    <message>
        <source>Strain over it (rms): %1, then %2</source>
        <translation>Déformation au-delà (RMS)&#x202f;: %1, puis %2</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: look again, or undo that.</source>
        <translation>Le modèle a changé entre-temps&#x202f;: cherchez de nouveau, ou annulez cela.</translation>
    </message>
    <message>
        <source>The cover moves by %1 (rms).</source>
        <translation>La housse bouge de %1 (RMS).</translation>
    </message>
    <message>
        <source>From %1 (rms): %2, then %3</source>
        <translation>De %1 (RMS)&#x202f;: %2, puis %3</translation>
    </message>
</context>
<context>
    <name>bolster::RenderDialog</name>
    <message>
        <source>Render</source>
        <translation>Calculer un rendu</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>As in the window</source>
        <translation>Comme dans la fenêtre</translation>
    </message>
    <message>
        <source>Three-quarter</source>
        <translation>Trois quarts</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Brouillon</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Bonne</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>La meilleure</translation>
    </message>
    <message>
        <source>How often each pixel is looked at</source>
        <translation>Nombre d’examens de chaque pixel</translation>
    </message>
    <message>
        <source>Transparent &amp;background</source>
        <translation>&amp;Fond transparent</translation>
    </message>
    <message>
        <source>The shadow on the ground is kept</source>
        <translation>L’ombre au sol est conservée</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Taille&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;View:</source>
        <translation>&amp;Vue&#x202f;:</translation>
    </message>
    <message>
        <source>Sho&amp;w:</source>
        <translation>Affic&amp;hage&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>&amp;Qualité&#x202f;:</translation>
    </message>
    <message>
        <source>Drawing …</source>
        <translation>Dessin…</translation>
    </message>
    <message>
        <source>&amp;Render …</source>
        <translation>&amp;Calculer…</translation>
    </message>
    <message>
        <source>The fabrics as in the window</source>
        <translation>Les tissus comme dans la fenêtre</translation>
    </message>
    <message>
        <source>Colourway %1</source>
        <translation>Coloris %1</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>Damier</translation>
    </message>
    <message>
        <source>At most %1 million pixels are drawn; choose a smaller size.</source>
        <translation>%1 millions de pixels au plus sont dessinés&#x202f;; choisissez une taille plus petite.</translation>
    </message>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation>Impossible d’écrire l’image&#x202f;: %1</translation>
    </message>
    <message>
        <source>Render to</source>
        <translation>Enregistrer le rendu sous</translation>
    </message>
    <message>
        <source>PNG, 8 bits (*.png);;TIFF, 16 bits (*.tif *.tiff);;OpenEXR, linear light (*.exr)</source>
        <translation>PNG, 8 bits (*.png);;TIFF, 16 bits (*.tif *.tiff);;OpenEXR, lumière linéaire (*.exr)</translation>
    </message>
    <message>
        <source>The name must end in .png, .tif or .exr.</source>
        <translation>Le nom doit finir par .png, .tif ou .exr.</translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>Annulé&#x202f;; rien n’a été écrit.</translation>
    </message>
    <message>
        <source>one picture</source>
        <translation>une image</translation>
    </message>
    <message>
        <source> pictures</source>
        <translation> images</translation>
    </message>
    <message>
        <source>So many pictures from all around, with numbers in their names</source>
        <translation>Autant d’images tout autour, numérotées dans leurs noms</translation>
    </message>
    <message>
        <source>&amp;Around the cover:</source>
        <translation>Autou&amp;r de la housse&#x202f;:</translation>
    </message>
    <message>
        <source>All colourways on a sheet</source>
        <translation>Tous les coloris sur une planche</translation>
    </message>
    <message>
        <source>Map: %1</source>
        <translation>Carte&#x202f;: %1</translation>
    </message>
    <message>
        <source>&amp;Frame and foam</source>
        <translation>Armature et &amp;mousse</translation>
    </message>
    <message>
        <source>In the materials that their properties say</source>
        <translation>Dans les matériaux indiqués par leurs propriétés</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>F&amp;ermer</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>The picture is written: %1</source>
        <translation>L’image est écrite&#x202f;: %1</translation>
    </message>
    <message>
        <source>Open its folder</source>
        <translation>Ouvrir son dossier</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>What was made</source>
        <translation>Ce qui a été produit</translation>
    </message>
    <message>
        <source>Drawing %1 …</source>
        <translation>Dessin de %1…</translation>
    </message>
</context>
<context>
    <name>bolster::ReportDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>Signaler un problème</translation>
    </message>
    <message>
        <source>What did you do, what happened, and what should have happened?</source>
        <translation>Qu’avez-vous fait, que s’est-il passé, et qu’aurait-il dû se passer&#x202f;?</translation>
    </message>
    <message>
        <source>&amp;What happened:</source>
        <translation>&amp;Ce qui s’est passé&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Add the design (&quot;%1&quot;), without its frames, scans and pictures</source>
        <translation>&amp;Joindre le modèle («&#x202f;%1&#x202f;»), sans ses armatures, scans et images</translation>
    </message>
    <message>
        <source>What the &amp;report says besides:</source>
        <translation>Ce que le &amp;rapport dit d’autre&#x202f;:</translation>
    </message>
    <message>
        <source>Write the report …</source>
        <translation>Écrire le rapport…</translation>
    </message>
    <message>
        <source>This writes a file that you can give to those who can help. Bolster sends nothing.</source>
        <translation>Cela écrit un fichier que vous pouvez donner à ceux qui peuvent aider. Bolster n’envoie rien.</translation>
    </message>
    <message>
        <source>not known yet</source>
        <translation>pas encore connu</translation>
    </message>
    <message>
        <source>Messages of this run:</source>
        <translation>Messages depuis le démarrage&#x202f;:</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(aucun)</translation>
    </message>
    <message>
        <source>The last crash:</source>
        <translation>Le dernier plantage&#x202f;:</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Écrire le rapport</translation>
    </message>
    <message>
        <source>ZIP (*.zip)</source>
        <translation>ZIP (*.zip)</translation>
    </message>
    <message>
        <source>The report is written: %1</source>
        <translation>Le rapport est écrit&#x202f;: %1</translation>
    </message>
    <message>
        <source>The report could not be written: %1</source>
        <translation>Le rapport n’a pas pu être écrit&#x202f;: %1</translation>
    </message>
</context>
<context>
    <name>bolster::Rescue</name>
    <message>
        <source>%1 (recovered)</source>
        <translation>%1 (récupéré)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be opened.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas pu être ouvert.</translation>
    </message>
    <message>
        <source>What can be read goes into a new project beside it. This file stays as it is.</source>
        <translation>Ce qui est lisible va dans un nouveau projet à côté. Ce fichier reste tel quel.</translation>
    </message>
    <message>
        <source>&amp;Recover what can be read</source>
        <translation>&amp;Récupérer ce qui est lisible</translation>
    </message>
    <message>
        <source>Recovering &quot;%1&quot; …</source>
        <translation>Récupération de «&#x202f;%1&#x202f;»…</translation>
    </message>
    <message>
        <source>Nothing could be recovered.</source>
        <translation>Rien n’a pu être récupéré.</translation>
    </message>
    <message>
        <source>What could be read is in &quot;%1&quot; now.</source>
        <translation>Ce qui était lisible est maintenant dans «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>The unsaved work on &quot;%1&quot; is damaged.</source>
        <translation>Le travail non enregistré sur «&#x202f;%1&#x202f;» est endommagé.</translation>
    </message>
    <message numerus="yes">
        <source>What can be read goes into a new project. What you do not want any more is deleted %n days after it was put into the bin.</source>
        <translation>
            <numerusform>Ce qui est lisible va dans un nouveau projet. Ce que vous ne voulez plus est supprimé après %n jour dans la corbeille.</numerusform>
            <numerusform>Ce qui est lisible va dans un nouveau projet. Ce que vous ne voulez plus est supprimé après %n jours dans la corbeille.</numerusform>
        </translation>
    </message>
    <message>
        <source>Put it into the &amp;bin</source>
        <translation>Mettre à la &amp;corbeille</translation>
    </message>
    <message>
        <source>The damaged work is kept under File &gt; Unsaved work</source>
        <translation>Le travail endommagé est gardé sous Fichier &gt; Travail non enregistré</translation>
    </message>
    <message>
        <source>What could be read of it is in &quot;%1&quot; now.</source>
        <translation>Ce qui en était lisible est maintenant dans «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>Nothing of it could be read.</source>
        <translation>Rien n’en était lisible.</translation>
    </message>
    <message>
        <source>Nothing that was saved is concerned. The damaged work is kept under File &gt; Unsaved work.</source>
        <translation>Rien de ce qui a été enregistré n’est touché. Le travail endommagé est gardé sous Fichier &gt; Travail non enregistré.</translation>
    </message>
    <message>
        <source>Open what was &amp;recovered</source>
        <translation>&amp;Ouvrir ce qui a été récupéré</translation>
    </message>
    <message>
        <source>Looking for what can be read in &quot;%1&quot; …</source>
        <translation>Recherche de ce qui peut être lu dans «&#xa0;%1&#xa0;»…</translation>
    </message>
</context>
<context>
    <name>bolster::RunRow</name>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Arrêter</translation>
    </message>
</context>
<context>
    <name>bolster::SaveFlow</name>
    <message>
        <source>Project with its history (*.bolster);;Design as text (*.json)</source>
        <translation>Projet avec son historique (*.bolster);;Modèle en texte (*.json)</translation>
    </message>
    <message numerus="yes">
        <source>%n edits</source>
        <translation>
            <numerusform>%n modification</numerusform>
            <numerusform>%n modifications</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edits that were undone or are on other branches</source>
        <translation>
            <numerusform>%n modification annulée ou sur une autre branche</numerusform>
            <numerusform>%n modifications annulées ou sur d’autres branches</numerusform>
        </translation>
    </message>
    <message>
        <source>names of versions or branches</source>
        <translation>noms de versions ou de branches</translation>
    </message>
    <message>
        <source>The file holds another version of the design than the one you see.</source>
        <translation>Le fichier contient une autre version du modèle que celle que vous voyez.</translation>
    </message>
    <message>
        <source>Not saved yet: %1.</source>
        <translation>Pas encore enregistré&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>Enregistrer une copie</translation>
    </message>
    <message>
        <source>-copy</source>
        <translation>-copie</translation>
    </message>
    <message>
        <source>Project (*.%1)</source>
        <translation>Projet (*.%1)</translation>
    </message>
    <message>
        <source>Save the changes in &quot;%1&quot;?</source>
        <translation>Enregistrer les modifications de «&#x202f;%1&#x202f;»&#x202f;?</translation>
    </message>
    <message>
        <source>A design as text cannot hold that, a project can.</source>
        <translation>Un modèle en texte ne peut pas contenir cela, un projet si.</translation>
    </message>
    <message>
        <source>Work that is kept for later, with all its steps, is under File &gt; Unsaved work.</source>
        <translation>Le travail gardé pour plus tard, avec toutes ses étapes, est sous Fichier &gt; Travail non enregistré.</translation>
    </message>
    <message>
        <source>Save as &amp;project …</source>
        <translation>Enregistrer comme &amp;projet…</translation>
    </message>
    <message>
        <source>&amp;Keep for later</source>
        <translation>&amp;Garder pour plus tard</translation>
    </message>
    <message>
        <source>The work cannot be kept.</source>
        <translation>Le travail ne peut pas être gardé.</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Enregistrer le projet</translation>
    </message>
    <message>
        <source>Saved a copy as %1</source>
        <translation>Copie enregistrée sous %1</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Enregistré sous %1</translation>
    </message>
    <message>
        <source>%1: the design alone, without its history</source>
        <translation>%1&#x202f;: le modèle seul, sans son historique</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the file any more that was opened or saved here.</source>
        <translation>«&#x202f;%1&#x202f;» n’est plus le fichier qui a été ouvert ou enregistré ici.</translation>
    </message>
    <message>
        <source>Save your design under another name, or let what is there now have another name beside it. If that is a damaged project, File &gt; Open recovers what can be read of it.</source>
        <translation>Enregistrez votre modèle sous un autre nom, ou donnez à ce qui s’y trouve maintenant un autre nom à côté. Si c’est un projet endommagé, Fichier &gt; Ouvrir en récupère ce qui est lisible.</translation>
    </message>
    <message>
        <source>&amp;Keep the other file beside it, and save</source>
        <translation>&amp;Garder l’autre fichier à côté, et enregistrer</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be saved.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas pu être enregistré.</translation>
    </message>
    <message>
        <source>What was in the place of &quot;%1&quot; is in &quot;%2&quot; now.</source>
        <translation>Ce qui était à la place de «&#x202f;%1&#x202f;» est maintenant dans «&#x202f;%2&#x202f;».</translation>
    </message>
    <message>
        <source>Somebody else has changed &quot;%1&quot; since it was opened here.</source>
        <translation>Quelqu’un d’autre a modifié «&#x202f;%1&#x202f;» depuis son ouverture ici.</translation>
    </message>
    <message>
        <source>Their changes can become a branch of the history here, then both are saved. Your design stays as it is, and you can go to theirs.</source>
        <translation>Ses modifications peuvent devenir ici une branche de l’historique, puis les deux sont enregistrées. Votre modèle reste tel quel, et vous pouvez aller au sien.</translation>
    </message>
    <message>
        <source>&amp;Take their changes in as a branch</source>
        <translation>Reprendre ses modifications en &amp;branche</translation>
    </message>
    <message>
        <source>From the file, %1</source>
        <translation>Du fichier, %1</translation>
    </message>
    <message>
        <source>Their changes could not be taken in.</source>
        <translation>Ses modifications n’ont pas pu être reprises.</translation>
    </message>
    <message>
        <source>The changes of somebody else are a branch of the history now.</source>
        <translation>Les modifications de l’autre personne sont maintenant une branche de l’historique.</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>&amp;Afficher</translation>
    </message>
    <message>
        <source>Go &amp;there</source>
        <translation>Y a&amp;ller</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>&amp;Réessayer</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>Nothing protects what you do since %1 against a crash: Bolster cannot write to the folder &quot;%2&quot;. Make room there, or save the design.</source>
        <translation>Rien ne protège d’un plantage ce que vous faites depuis %1&#x202f;: Bolster ne peut pas écrire dans le dossier «&#x202f;%2&#x202f;». Libérez-y de la place, ou enregistrez le modèle.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
</context>
<context>
    <name>bolster::ScanLink</name>
    <message>
        <source>Deviation from %1</source>
        <translation>Écart à %1</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>dedans</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>dehors</translation>
    </message>
</context>
<context>
    <name>bolster::SeamLineList</name>
    <message>
        <source>Seam lines</source>
        <translation>Lignes de couture</translation>
    </message>
    <message>
        <source>Fixation curves of the design. Draw seam lines on a frame with the tool for fixation curves: what is drawn meanwhile is cut at once</source>
        <translation>Courbes de fixation du modèle. Dessinez des lignes de couture sur une armature avec l’outil des courbes de fixation&#x202f;: ce qui est dessiné entre-temps est aussitôt coupé</translation>
    </message>
    <message numerus="yes">
        <source>%n lines that hold a cover</source>
        <translation>
            <numerusform>%n ligne qui tient une housse</numerusform>
            <numerusform>%n lignes qui tiennent une housse</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::SeamProposalsWindow</name>
    <message>
        <source>Proposed seams</source>
        <translation>Coutures proposées</translation>
    </message>
    <message>
        <source>Edge of</source>
        <translation>Bord de</translation>
    </message>
    <message>
        <source>to edge of</source>
        <translation>au bord de</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Longueurs</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>Certitude</translation>
    </message>
    <message>
        <source>Select rows to see their edges in the pattern; Enter or a double click sews them.</source>
        <translation>Sélectionnez des lignes pour voir leurs bords dans le patron&#x202f;; Entrée ou un double-clic les coud.</translation>
    </message>
    <message>
        <source>&amp;Sew selected</source>
        <translation>Coudre la &amp;sélection</translation>
    </message>
    <message>
        <source>Sew &amp;all</source>
        <translation>Coudre &amp;tout</translation>
    </message>
    <message>
        <source>Looking for edges that belong together …</source>
        <translation>Recherche de bords qui vont ensemble…</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>There are no free edges that seem to belong together.</source>
        <translation>Il n’y a pas de bords libres qui semblent aller ensemble.</translation>
    </message>
    <message>
        <source>Sew &amp;likely ones</source>
        <translation>Coudre les &amp;probables</translation>
    </message>
    <message>
        <source>Those of 50 % and more. What is sewn tells where its neighbours belong.</source>
        <translation>Celles de 50&#x202f;% et plus. Ce qui est cousu indique où vont les voisines.</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>Found by their lengths, corners that would close, names and directions; the most certain first. Look at each in the pattern before you sew it.</source>
        <translation>D’après les longueurs, les coins qui se fermeraient, les noms et les directions&#x202f;; les plus certaines d’abord. Regardez chacune dans le patron avant de la coudre.</translation>
    </message>
</context>
<context>
    <name>bolster::SeamsModel</name>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Paramètre</translation>
    </message>
    <message>
        <source>More than 5 % ease puckers.</source>
        <translation>Au-delà de 5&#x202f;% d’embu, cela fronce.</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Couture</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Embu</translation>
    </message>
    <message>
        <source>Ease %</source>
        <translation>Embu&#x202f;%</translation>
    </message>
    <message>
        <source>Joins</source>
        <translation>Continuité</translation>
    </message>
    <message>
        <source>Length 1</source>
        <translation>Longueur 1</translation>
    </message>
    <message>
        <source>Length 2</source>
        <translation>Longueur 2</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Correspondance</translation>
    </message>
    <message>
        <source>The letter on both stretches in the pattern</source>
        <translation>La lettre sur les deux tronçons dans le patron</translation>
    </message>
    <message>
        <source>The patches and their edges</source>
        <translation>Les pièces et leurs bords</translation>
    </message>
    <message>
        <source>C0: an edge, C1: smooth with the texture, G1: rounded</source>
        <translation>C0&#x202f;: arête, C1&#x202f;: lisse, motif compris, G1&#x202f;: arrondi</translation>
    </message>
    <message>
        <source>Of the first side</source>
        <translation>Du premier côté</translation>
    </message>
    <message>
        <source>Of the second side</source>
        <translation>Du second côté</translation>
    </message>
    <message>
        <source>What is sewn together: equal parts of the length, or of the curve&apos;s parameter</source>
        <translation>Ce qui est cousu ensemble&#x202f;: des parts égales de la longueur, ou du paramètre de la courbe</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>The place in the order of sewing; Seam &gt; Sew earlier and Sew later change it</source>
        <translation>Le rang dans l’ordre de montage&#x202f;; Couture &gt; Coudre plus tôt et Coudre plus tard le modifient</translation>
    </message>
    <message>
        <source>How much longer the second side is than the first one</source>
        <translation>De combien le second côté est plus long que le premier</translation>
    </message>
    <message>
        <source>The ease over the shorter side; more than 5 % puckers</source>
        <translation>L’embu rapporté au côté le plus court&#x202f;; au-delà de 5&#x202f;%, cela fronce</translation>
    </message>
</context>
<context>
    <name>bolster::SeamsView</name>
    <message>
        <source>No seams yet. Choose the sewing tool (W), then click the two edges that belong together.</source>
        <translation>Pas encore de coutures. Choisissez l’outil de couture (W), puis cliquez sur les deux bords qui vont ensemble.</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>Coutures</translation>
    </message>
</context>
<context>
    <name>bolster::SectionPanel</name>
    <message>
        <source>Section</source>
        <translation>Plan de coupe</translation>
    </message>
    <message>
        <source>Cut across the x axis</source>
        <translation>Couper en travers de l’axe x</translation>
    </message>
    <message>
        <source>Cut across the y axis</source>
        <translation>Couper en travers de l’axe y</translation>
    </message>
    <message>
        <source>Cut across the z axis</source>
        <translation>Couper en travers de l’axe z</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Cut parallel to the picture, as it is seen now</source>
        <translation>Couper parallèlement à l’image, telle qu’elle est vue</translation>
    </message>
    <message>
        <source>Moves the plane</source>
        <translation>Déplace le plan</translation>
    </message>
    <message>
        <source>Show the other half</source>
        <translation>Afficher l’autre moitié</translation>
    </message>
    <message>
        <source>Close the section</source>
        <translation>Fermer le plan de coupe</translation>
    </message>
    <message>
        <source>Place of the section</source>
        <translation>Position du plan de coupe</translation>
    </message>
</context>
<context>
    <name>bolster::SewingCommands</name>
    <message>
        <source>Propos&amp;e seams …</source>
        <translation>Propos&amp;er des coutures…</translation>
    </message>
    <message>
        <source>Show seam li&amp;st</source>
        <translation>&amp;Liste des coutures</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>&amp;Inverser</translation>
    </message>
    <message>
        <source>Swap si&amp;des</source>
        <translation>Éc&amp;hanger les côtés</translation>
    </message>
    <message>
        <source>C&amp;0 – an edge</source>
        <translation>C&amp;0 – arête</translation>
    </message>
    <message>
        <source>C&amp;1 – smooth, texture too</source>
        <translation>C&amp;1 – lisse, motif compris</translation>
    </message>
    <message>
        <source>&amp;G1 – rounded</source>
        <translation>&amp;G1 – arrondi</translation>
    </message>
    <message>
        <source>Match by &amp;length</source>
        <translation>Correspondance par longue&amp;ur</translation>
    </message>
    <message>
        <source>Match by &amp;parameter</source>
        <translation>Correspondance par &amp;paramètre</translation>
    </message>
    <message>
        <source>Sew earl&amp;ier</source>
        <translation>Coudre plus &amp;tôt</translation>
    </message>
    <message>
        <source>Sew l&amp;ater</source>
        <translation>Coudre plus t&amp;ard</translation>
    </message>
    <message>
        <source>Sewi&amp;ng order as proposed</source>
        <translation>&amp;Ordre de montage proposé</translation>
    </message>
</context>
<context>
    <name>bolster::SheetPreview</name>
    <message>
        <source>What will be on the sheets</source>
        <translation>Ce qu’il y aura sur les feuilles</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>Il n’y a rien à couper.</translation>
    </message>
    <message>
        <source>Laying out …</source>
        <translation>Mise en page…</translation>
    </message>
</context>
<context>
    <name>bolster::ShortcutsDialog</name>
    <message>
        <source>&amp;No keys</source>
        <translation>&amp;Aucune touche</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Réinitialiser</translation>
    </message>
    <message>
        <source>&amp;Take them over</source>
        <translation>Re&amp;prendre</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>Find a command or a key</source>
        <translation>Rechercher une commande ou une touche</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>&amp;Tout réinitialiser</translation>
    </message>
    <message>
        <source>Click into the field and press the keys.</source>
        <translation>Cliquez dans le champ et appuyez sur les touches.</translation>
    </message>
    <message>
        <source>Choose a command to change its keys.</source>
        <translation>Choisissez une commande pour modifier ses touches.</translation>
    </message>
    <message>
        <source>%1 is needed by the views and fields themselves.</source>
        <translation>%1 sert aux vues et aux champs eux-mêmes.</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 appartient à «&#x202f;%2&#x202f;».</translation>
    </message>
    <message>
        <source>%1 it is.</source>
        <translation>%1 est déjà pris.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
</context>
<context>
    <name>bolster::ShownPattern</name>
    <message>
        <source>Edge: %1</source>
        <translation>Bord&#x202f;: %1</translation>
    </message>
</context>
<context>
    <name>bolster::SimplifyChoice</name>
    <message>
        <source>&amp;Simplify to about</source>
        <translation>&amp;Simplifier à environ</translation>
    </message>
    <message>
        <source> triangles</source>
        <translation> triangles</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
    <message>
        <source>Writes the parts that are wanted into an OBJ file of the design&apos;s own; the file that was chosen stays as it is</source>
        <translation>Écrit les parties voulues dans un fichier OBJ propre au modèle&#x202f;; le fichier choisi reste tel quel</translation>
    </message>
</context>
<context>
    <name>bolster::SpotsPanel</name>
    <message>
        <source>Worst spots</source>
        <translation>Zones critiques</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Negative where the fabric is pressed together</source>
        <translation>Négative là où le tissu est comprimé</translation>
    </message>
    <message>
        <source>What the fabric there may suffer. The spots are sorted by how much of it they take</source>
        <translation>Ce que le tissu peut y supporter. Les zones sont triées selon la part qu’elles en prennent</translation>
    </message>
    <message>
        <source>As soon as there is a cover, its worst spots will be listed here.</source>
        <translation>Dès qu’il y a une housse, ses zones critiques figurent ici.</translation>
    </message>
    <message>
        <source>A map of strain or shear shows what the fabric suffers. Its worst spots will be listed here.</source>
        <translation>Une carte de déformation ou de cisaillement montre ce que le tissu subit. Ses zones critiques figureront ici.</translation>
    </message>
    <message>
        <source>Nothing is over the limit of its fabric.</source>
        <translation>Rien ne dépasse la limite de son tissu.</translation>
    </message>
    <message>
        <source>Over the limit of the fabric: %1 of %2</source>
        <translation>Au-delà de la limite du tissu&#x202f;: %1 sur %2</translation>
    </message>
    <message>
        <source>over the limit of %1</source>
        <translation>au-delà de la limite de %1</translation>
    </message>
    <message>
        <source>Show the &amp;largest strain</source>
        <translation>Afficher la &amp;déformation maximale</translation>
    </message>
</context>
<context>
    <name>bolster::StartHint</name>
    <message>
        <source>A new cover</source>
        <translation>Une nouvelle housse</translation>
    </message>
    <message>
        <source>Draw the first patch, import a frame, or open a design:</source>
        <translation>Dessinez la première pièce, importez une armature ou ouvrez un modèle&#x202f;:</translation>
    </message>
    <message>
        <source>Or look at a sample:</source>
        <translation>Ou regardez un exemple&#x202f;:</translation>
    </message>
    <message>
        <source>%1 more are under File &gt; Samples</source>
        <translation>%1 de plus sous Fichier &gt; Exemples</translation>
    </message>
    <message>
        <source>Go on with:</source>
        <translation>Continuer avec&#x202f;:</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Vider cette liste</translation>
    </message>
    <message>
        <source>Rectan&amp;gle</source>
        <translation>&amp;Rectangle</translation>
    </message>
    <message>
        <source>Ou&amp;tline</source>
        <translation>&amp;Contour</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>&amp;Import frame …</source>
        <translation>&amp;Importer une armature…</translation>
    </message>
</context>
<context>
    <name>bolster::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Page d’accueil</translation>
    </message>
    <message>
        <source>Welcome to Bolster</source>
        <translation>Bienvenue dans Bolster</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>Suivre la visite guidée</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Back to the design</source>
        <translation>Retour au modèle</translation>
    </message>
    <message>
        <source>What do you have?</source>
        <translation>Qu’avez-vous&#x202f;?</translation>
    </message>
    <message>
        <source>A frame</source>
        <translation>Une armature</translation>
    </message>
    <message>
        <source>The cover is fixed on it: %1</source>
        <translation>La housse y est fixée&#x202f;: %1</translation>
    </message>
    <message>
        <source>A pattern</source>
        <translation>Un patron</translation>
    </message>
    <message>
        <source>Its pieces become the cover: %1</source>
        <translation>Ses pièces deviennent la housse&#x202f;: %1</translation>
    </message>
    <message>
        <source>A scan</source>
        <translation>Un scan</translation>
    </message>
    <message>
        <source>The cover is fitted to it: %1</source>
        <translation>La housse y est ajustée&#x202f;: %1</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Rien encore</translation>
    </message>
    <message>
        <source>Draw a rectangle, the first patch</source>
        <translation>Dessiner un rectangle, la première pièce</translation>
    </message>
    <message>
        <source>Go on with</source>
        <translation>Continuer avec</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Vider cette liste</translation>
    </message>
    <message>
        <source>Take it out of this list; the file stays</source>
        <translation>Retirer de cette liste&#x202f;; le fichier reste</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Travail non enregistré</translation>
    </message>
    <message>
        <source>Kept for later, last edit %1</source>
        <translation>Gardé pour plus tard, dernière modification %1</translation>
    </message>
    <message>
        <source>Left by a crash, last edit %1</source>
        <translation>Laissé par un plantage, dernière modification %1</translation>
    </message>
    <message>
        <source>Begin with a template</source>
        <translation>Commencer avec un gabarit</translation>
    </message>
    <message>
        <source>Look at a sample</source>
        <translation>Regarder un exemple</translation>
    </message>
    <message>
        <source>It is not there now</source>
        <translation>Absent pour le moment</translation>
    </message>
</context>
<context>
    <name>bolster::StatusLine</name>
    <message>
        <source>Nothing to sew yet</source>
        <translation>Rien à coudre encore</translation>
    </message>
    <message>
        <source>Preparing …</source>
        <translation>Préparation…</translation>
    </message>
    <message>
        <source>Moving, %1/s</source>
        <translation>En mouvement, %1/s</translation>
    </message>
    <message>
        <source>Solved – %1 iterations</source>
        <translation>Résolu – %1 itérations</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pause</translation>
    </message>
    <message numerus="yes">
        <source>%n problems</source>
        <translation>
            <numerusform>%n problème</numerusform>
            <numerusform>%n problèmes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n avertissement</numerusform>
            <numerusform>%n avertissements</numerusform>
        </translation>
    </message>
    <message>
        <source>Solved in part</source>
        <translation>Résolu en partie</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Pourquoi&#x202f;?</translation>
    </message>
    <message>
        <source>Following the drag</source>
        <translation>Suit le glissement</translation>
    </message>
    <message>
        <source>Solved, with warnings</source>
        <translation>Résolu, avec avertissements</translation>
    </message>
    <message>
        <source>Show (%1)</source>
        <translation>Afficher (%1)</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>The cloth went on moving until the computation was ended. What usually causes that:
• A piece that nothing holds: fix one of its edges, or sew it on.
• A seam whose two sides differ much in length: make them more alike.
• A very long or very narrow piece: divide it, or make it wider.
• High pressure: lower it in the properties of the patch.
What you see is where the cloth was at the end.</source>
        <translation>Le tissu a bougé jusqu’à la fin du calcul. Les causes habituelles&#x202f;:
• Une pièce que rien ne tient&#x202f;: fixez un de ses bords, ou cousez-la.
• Une couture dont les deux côtés ont des longueurs très différentes&#x202f;: rapprochez-les.
• Une pièce très longue ou très étroite&#x202f;: divisez-la, ou élargissez-la.
• Une forte pression&#x202f;: réduisez-la dans les propriétés de la pièce.
Vous voyez le tissu tel qu’il était à la fin.</translation>
    </message>
    <message>
        <source>Drawing and checking …</source>
        <translation>Dessin et vérification…</translation>
    </message>
    <message>
        <source>Preparing: on fewer triangles …</source>
        <translation>Préparation&#x202f;: sur moins de triangles…</translation>
    </message>
    <message>
        <source>Preparing: forces and equations …</source>
        <translation>Préparation&#x202f;: forces et équations…</translation>
    </message>
    <message>
        <source>&amp;What does it mean?</source>
        <translation>&amp;Qu’est-ce que cela signifie&#x202f;?</translation>
    </message>
    <message>
        <source>A preview, not checked yet</source>
        <translation>Un aperçu, pas encore vérifié</translation>
    </message>
</context>
<context>
    <name>bolster::SweepWindow</name>
    <message>
        <source>Tolerances</source>
        <translation>Tolérances</translation>
    </message>
    <message>
        <source>&amp;Draw pieces</source>
        <translation>T&amp;irer des exemplaires</translation>
    </message>
    <message>
        <source>Solving pieces within tolerances …</source>
        <translation>Calcul d’exemplaires dans les tolérances…</translation>
    </message>
    <message>
        <source>Pieces are drawn at random within their tolerances: where does the cover vary, which tolerance matters, how many pieces are out of the limit?</source>
        <translation>Des exemplaires sont tirés au hasard dans leurs tolérances&#x202f;: où la housse varie-t-elle, quelle tolérance compte, combien d’exemplaires sont hors limite&#x202f;?</translation>
    </message>
    <message>
        <source>&amp;Show on the cover what 95 % of the pieces do not exceed</source>
        <translation>Montrer &amp;sur la housse ce que 95&#x202f;% des exemplaires ne dépassent pas</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Moves by at most</source>
        <translation>Bouge d’au plus</translation>
    </message>
    <message>
        <source>Tolerances by their influence</source>
        <translation>Tolérances par influence</translation>
    </message>
    <message>
        <source>Tolerances (±); 0: none</source>
        <translation>Tolérances (±)&#x202f;; 0&#x202f;: aucune</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Exemplaires</translation>
    </message>
    <message>
        <source>Every size within is as likely</source>
        <translation>Toute cote comprise est aussi probable</translation>
    </message>
    <message>
        <source>Normal: the tolerance is three standard deviations</source>
        <translation>Normale&#x202f;: la tolérance vaut trois écarts types</translation>
    </message>
    <message>
        <source>Before them ten thousand are drawn as if covers were linear, which takes seconds</source>
        <translation>Avant eux, dix mille sont tirés comme si les housses étaient linéaires, ce qui prend quelques secondes</translation>
    </message>
    <message>
        <source>Dr&amp;awn</source>
        <translation>Tirés &amp;au hasard</translation>
    </message>
    <message>
        <source>S&amp;olved</source>
        <translation>Calcu&amp;lés</translation>
    </message>
    <message>
        <source>Nothing varies: give a tolerance above 0 of something that the design has.</source>
        <translation>Rien ne varie&#x202f;: donnez une tolérance supérieure à 0 à quelque chose que le modèle possède.</translation>
    </message>
    <message>
        <source>Covers with each tolerance are solved …</source>
        <translation>Calcul de housses avec chaque tolérance…</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Arrêté.</translation>
    </message>
    <message>
        <source>That is as if covers were linear; pieces are being solved …</source>
        <translation>C’est comme si les housses étaient linéaires&#x202f;; des exemplaires sont en cours de calcul…</translation>
    </message>
    <message>
        <source>That is as if covers were linear.</source>
        <translation>C’est comme si les housses étaient linéaires.</translation>
    </message>
    <message numerus="yes">
        <source>By %n solved pieces.</source>
        <translation>
            <numerusform>D’après %n exemplaire calculé.</numerusform>
            <numerusform>D’après %n exemplaires calculés.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces have no cover at rest.</source>
        <translation>
            <numerusform>%n exemplaire n’a pas de housse stable.</numerusform>
            <numerusform>%n exemplaires n’ont pas de housse stable.</numerusform>
        </translation>
    </message>
    <message>
        <source>What 95 % of the pieces do not exceed</source>
        <translation>Ce que 95&#x202f;% des exemplaires ne dépassent pas</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: draw the pieces again.</source>
        <translation>Le modèle a changé entre-temps&#x202f;: tirez de nouveau les exemplaires.</translation>
    </message>
    <message numerus="yes">
        <source>By %n solved pieces so far; more are being solved …</source>
        <translation>
            <numerusform>D’après %n exemplaire calculé jusqu’ici&#x202f;; d’autres sont en cours…</numerusform>
            <numerusform>D’après %n exemplaires calculés jusqu’ici&#x202f;; d’autres sont en cours…</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With %n tolerances no cover is found, as with: %1. They are left out of this: make them smaller.</source>
        <translation>
            <numerusform>Avec %n tolérance aucune housse n’est trouvée&#x202f;: %1. Elle n’est pas comprise ici&#x202f;: réduisez-la.</numerusform>
            <numerusform>Avec %n tolérances aucune housse n’est trouvée, comme avec&#x202f;: %1. Elles ne sont pas comprises ici&#x202f;: réduisez-les.</numerusform>
        </translation>
    </message>
    <message>
        <source>A piece is out of it when more than 5 % of its cover lie farther from where they should be</source>
        <translation>Un exemplaire est hors limite quand plus de 5&#x202f;% de sa housse s’écarte davantage de sa place</translation>
    </message>
    <message>
        <source>95 % of the pieces do not exceed, place by place, %1 (rms over the cover), %2 where it is most.</source>
        <translation>Ce que 95&#x202f;% des exemplaires ne dépassent pas, point par point&#x202f;: %1 (RMS sur la housse), %2 au plus fort.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Part</translation>
    </message>
    <message>
        <source>How much of the variance of the whole cover comes of it</source>
        <translation>Part de la variance de toute la housse qui en provient</translation>
    </message>
    <message>
        <source>± is what many more of them may change.</source>
        <translation>± est ce que bien plus d’exemplaires peuvent changer.</translation>
    </message>
    <message>
        <source>Out of the limit: about %1 of the pieces.</source>
        <translation>Hors limite&#x202f;: environ %1 des exemplaires.</translation>
    </message>
    <message>
        <source>Out of the limit: %1 of %2 pieces (of many: %3 to %4).</source>
        <translation>Hors limite&#x202f;: %1 sur %2 exemplaires (sur un grand nombre&#x202f;: de %3 à %4).</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>These are too few to say how sure that is.</source>
        <translation>C’est trop peu pour dire à quel point c’est sûr.</translation>
    </message>
    <message>
        <source>&amp;Limit for 95 % of a cover</source>
        <translation>Limi&amp;te pour 95&#x202f;% d’une housse</translation>
    </message>
    <message>
        <source>This is of what was set before: draw pieces for what is set now.</source>
        <translation>Cela vaut pour ce qui était réglé avant&#x202f;: tirez des exemplaires pour ce qui est réglé maintenant.</translation>
    </message>
</context>
<context>
    <name>bolster::ToolHost</name>
    <message>
        <source>This could not be done, and nothing was changed: %1</source>
        <translation>Cela n’a pas pu être fait, et rien n’a été modifié&#x202f;: %1</translation>
    </message>
</context>
<context>
    <name>bolster::TourPanel</name>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>Quitter la visite</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Visite guidée</translation>
    </message>
    <message>
        <source>Help &gt; Tour goes on from here</source>
        <translation>Aide &gt; Visite guidée reprend ici</translation>
    </message>
    <message>
        <source>Tour, %1 of %2</source>
        <translation>Visite guidée, %1 sur %2</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Terminer</translation>
    </message>
</context>
<context>
    <name>bolster::TrimTool</name>
    <message>
        <source>Click a seam or an edge of an outline.</source>
        <translation>Cliquez sur une couture ou un bord d’un contour.</translation>
    </message>
    <message>
        <source>Click to stitch this seam; stitches and piping are in the properties</source>
        <translation>Cliquez pour surpiquer cette couture&#x202f;; points et passepoil sont dans les propriétés</translation>
    </message>
    <message>
        <source>Click to stitch this edge; stitches and piping are in the properties</source>
        <translation>Cliquez pour surpiquer ce bord&#x202f;; points et passepoil sont dans les propriétés</translation>
    </message>
    <message>
        <source>Click a seam or an edge of an outline to stitch it – Esc ends the tool</source>
        <translation>Cliquez sur une couture ou un bord d’un contour pour le surpiquer – Échap quitte l’outil</translation>
    </message>
</context>
<context>
    <name>bolster::VersionPane</name>
    <message>
        <source>Computing the cover …</source>
        <translation>Calcul de la housse…</translation>
    </message>
    <message>
        <source>Pattern of %1</source>
        <translation>Patron de %1</translation>
    </message>
    <message>
        <source>Cover of %1</source>
        <translation>Housse de %1</translation>
    </message>
</context>
<context>
    <name>bolster::ViewCube</name>
    <message>
        <source>FRONT</source>
        <translation>AVANT</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>ARRIÈRE</translation>
    </message>
    <message>
        <source>LEFT</source>
        <translation>GAUCHE</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <translation>DROITE</translation>
    </message>
    <message>
        <source>TOP</source>
        <translation>DESSUS</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <translation>DESSOUS</translation>
    </message>
    <message>
        <source>Click a face, an edge or a corner to look from there; drag to turn</source>
        <translation>Cliquez sur une face, une arête ou un coin pour regarder de là&#x202f;; faites glisser pour tourner</translation>
    </message>
</context>
</TS>
