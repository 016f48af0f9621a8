<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>AreaBrushTool</name>
    <message>
        <source>Drag over the cover to paint the area; with Shift held down to take away. + and − change the brush. Esc ends.</source>
        <translation>カバーの上をドラッグして範囲を塗ります。Shift を押しながらで消します。+ と − でブラシを変えます。Esc で終わります。</translation>
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
        <translation>「%1」はすでに存在します。置き換えますか?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
</context>
<context>
    <name>AttachTool</name>
    <message>
        <source>Click an edge of an outline.</source>
        <translation>輪郭の辺をクリックしてください。</translation>
    </message>
    <message>
        <source>Select a fixation curve first, in the 3D view or in the list.</source>
        <translation>先に 3D ビューまたは一覧で固定曲線を選択してください。</translation>
    </message>
    <message>
        <source>Several stretches go with one curve, or one stretch with several curves.</source>
        <translation>1 本の曲線に複数の区間、または 1 つの区間に複数の曲線を割り当てられます。</translation>
    </message>
    <message>
        <source>The stretches overlap each other, or are attached like this already.</source>
        <translation>区間が互いに重なっているか、すでにこのように固定されています。</translation>
    </message>
    <message>
        <source>This stretch is attached like this already.</source>
        <translation>この区間はすでにこのように固定されています。</translation>
    </message>
    <message>
        <source>Select a fixation curve in the 3D view or in the list, then click an edge of an outline – Esc ends the tool</source>
        <translation>3D ビューまたは一覧で固定曲線を選択し、輪郭の辺をクリック。Esc でツールを終了</translation>
    </message>
    <message>
        <source>%1 curves</source>
        <translation>%1 本の曲線</translation>
    </message>
    <message>
        <source>Click to fix this stretch of %1 to %2 – Shift+click collects several</source>
        <translation>クリックで %1 のこの区間を %2 に固定。Shift+クリックで複数を集める</translation>
    </message>
    <message>
        <source>Click the last edge, or Enter attaches %1 stretches to %2 – Backspace takes one back</source>
        <translation>最後の辺をクリックするか Enter で、%1 区間を %2 に固定。Backspace で 1 つ取り消す</translation>
    </message>
    <message>
        <source>Click an edge of an outline to fix it to %1 – Enter takes the selected stretch, Esc ends the tool</source>
        <translation>輪郭の辺をクリックして %1 に固定。Enter で選択中の区間を使用、Esc でツールを終了</translation>
    </message>
    <message>
        <source>&amp;Attach what is marked</source>
        <translation>マークしたものを固定(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Take back the last edge</source>
        <translation>最後の辺を取り消す(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>中止(&amp;G)</translation>
    </message>
</context>
<context>
    <name>BackgroundMoveTool</name>
    <message>
        <source>There is no background picture yet.</source>
        <translation>背景画像はまだありません。</translation>
    </message>
    <message>
        <source>Drag the picture to its place – Enter or Esc ends the tool</source>
        <translation>画像を所定の位置へドラッグ。Enter または Esc でツールを終了</translation>
    </message>
</context>
<context>
    <name>BackgroundPicture</name>
    <message>
        <source>%1 cannot be read as a picture: %2</source>
        <translation>%1 を画像として読み込めません: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an ordinary file.</source>
        <translation>「%1」は通常のファイルではありません。</translation>
    </message>
</context>
<context>
    <name>BackgroundScaleTool</name>
    <message>
        <source>There is no background picture yet.</source>
        <translation>背景画像はまだありません。</translation>
    </message>
    <message>
        <source>Type the true distance of the two points, for example 500 or 20 in.</source>
        <translation>2 点間の実際の距離を入力してください (例: 500、20 in)。</translation>
    </message>
    <message>
        <source>Click the first of two points of the picture whose distance you know – Esc ends the tool</source>
        <translation>画像上で、距離がわかっている 2 点の 1 点目をクリック。Esc でツールを終了</translation>
    </message>
    <message>
        <source>Click the second point</source>
        <translation>2 点目をクリック</translation>
    </message>
    <message>
        <source>Type their true distance, then Enter</source>
        <translation>実際の距離を入力して Enter</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>現在 %1</translation>
    </message>
</context>
<context>
    <name>BoxShapeTool</name>
    <message>
        <source>&quot;%1&quot; is no size: try 300 x 200</source>
        <translation>「%1」はサイズではありません (例: 300 x 200)</translation>
    </message>
    <message>
        <source>Enter makes it as wide and high as typed, for example 300 x 200</source>
        <translation>Enter で入力した幅と高さにする (例: 300 x 200)</translation>
    </message>
    <message>
        <source>Drag a rectangle, or click two opposite corners – Esc ends the tool</source>
        <translation>長方形をドラッグするか、対角の 2 点をクリック。Esc でツールを終了</translation>
    </message>
    <message>
        <source>Drag an ellipse, or click two opposite corners of its box – Esc ends the tool</source>
        <translation>楕円をドラッグするか、外枠の対角の 2 点をクリック。Esc でツールを終了</translation>
    </message>
    <message>
        <source>Click the opposite corner, or type width x height – Shift makes both equal, Ctrl does not snap</source>
        <translation>対角をクリックするか、幅 x 高さを入力。Shift で縦横を同じに、Ctrl でスナップしない</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>There was no room where you clicked: the patch lies beside the others.</source>
        <translation>クリックした場所に余地がないため、パーツは他のパーツの横に置かれました。</translation>
    </message>
    <message>
        <source>The new patch lies on %1: drag it away, or let all be arranged (Pattern &gt; Arrange).</source>
        <translation>新しいパーツが %1 に重なっています。ドラッグしてずらすか、すべてを配置してください (型紙 &gt; 配置)。</translation>
    </message>
    <message>
        <source>lies on %1</source>
        <translation>%1 に重なっています</translation>
    </message>
</context>
<context>
    <name>ColourwayForm</name>
    <message>
        <source>Fabrics</source>
        <translation>生地</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>those of the patches</source>
        <translation>パーツの生地</translation>
    </message>
</context>
<context>
    <name>ContextMenus</name>
    <message>
        <source>&amp;Show</source>
        <translation>表示(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>視点(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation>マップ(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Continuity</source>
        <translation>連続性(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Match</source>
        <translation>対応付け(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Arrange</source>
        <translation>配置(&amp;A)</translation>
    </message>
</context>
<context>
    <name>CoverAtRest</name>
    <message>
        <source>As soon as the cover has come to rest …</source>
        <translation>カバーが静止したら…</translation>
    </message>
    <message>
        <source>This needs the cover of the present design: let the solver go on first (Pause).</source>
        <translation>現在のデザインのカバーが必要です。先に計算を進めてください (一時停止を解除)。</translation>
    </message>
</context>
<context>
    <name>CoverMeasureTool</name>
    <message>
        <source>There is no cover here: click on the cover.</source>
        <translation>ここにカバーはありません。カバーをクリックしてください。</translation>
    </message>
    <message>
        <source>&amp;Keep the measurement</source>
        <translation>測定を残す(&amp;K)</translation>
    </message>
    <message>
        <source>%1 – Enter keeps the measurement, a click begins anew</source>
        <translation>%1。Enter で測定を残す、クリックで測り直し</translation>
    </message>
    <message>
        <source>Click the second point on the cover – Esc gives it up</source>
        <translation>カバー上の 2 点目をクリック。Esc で取り消し</translation>
    </message>
    <message>
        <source>Click two points of the cover or of the pattern to measure – Esc ends the tool</source>
        <translation>カバーまたは型紙の 2 点をクリックして測定。Esc でツールを終了</translation>
    </message>
</context>
<context>
    <name>CoverSelectTool</name>
    <message>
        <source>There is a control point already.</source>
        <translation>ここにはすでに制御点があります。</translation>
    </message>
    <message>
        <source>Drag to move the control point – Shift+click selects several, Del removes</source>
        <translation>ドラッグで制御点を移動。Shift+クリックで複数選択、Del で削除</translation>
    </message>
    <message>
        <source>Click to select the seam</source>
        <translation>クリックで縫い目を選択</translation>
    </message>
    <message>
        <source>Click to select the patch, drag to turn the view</source>
        <translation>クリックでパーツを選択、ドラッグでビューを回転</translation>
    </message>
    <message>
        <source>Click to select the curve, double click to add a control point here</source>
        <translation>クリックで曲線を選択、ダブルクリックでここに制御点を追加</translation>
    </message>
    <message>
        <source>Click to select what stands here, drag to turn the view</source>
        <translation>クリックでここにあるものを選択、ドラッグでビューを回転</translation>
    </message>
    <message>
        <source>Click to select, drag to turn – %1 pans, %2 zooms</source>
        <translation>クリックで選択、ドラッグで回転。%1で移動、%2でズーム</translation>
    </message>
    <message>
        <source>Click to select the measurement, Delete removes it</source>
        <translation>クリックで測定を選択、Delete で削除</translation>
    </message>
</context>
<context>
    <name>CushionForm</name>
    <message>
        <source>Cover of %1</source>
        <translation>%1 のカバー</translation>
    </message>
    <message>
        <source>Every cover</source>
        <translation>すべてのカバー</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>押す対象</translation>
    </message>
</context>
<context>
    <name>CutCornerForm</name>
    <message>
        <source>Patch</source>
        <translation>パーツ</translation>
    </message>
</context>
<context>
    <name>CutLabelWords</name>
    <message>
        <source>Cut %1</source>
        <translation>裁断 %1 枚</translation>
    </message>
    <message>
        <source>Cut %1 and %1 mirrored</source>
        <translation>裁断 %1 枚、反転 %1 枚</translation>
    </message>
</context>
<context>
    <name>CuttingCommands</name>
    <message>
        <source>Chec&amp;k before cutting</source>
        <translation>裁断前チェック(&amp;K)</translation>
    </message>
</context>
<context>
    <name>DartCommands</name>
    <message>
        <source>Remove da&amp;rt</source>
        <translation>ダーツを削除(&amp;R)</translation>
    </message>
    <message>
        <source>The edge goes on as if the selected dart had never been cut</source>
        <translation>選択したダーツがなかったものとして辺をつなげます</translation>
    </message>
    <message>
        <source>R&amp;otate dart to …</source>
        <translation>ダーツを移動(&amp;O)…</translation>
    </message>
    <message>
        <source>Turns the selected dart shut and opens the pattern where you click, by the same angle</source>
        <translation>選択したダーツをたたみ、クリックした位置で型紙を同じ角度だけ開きます</translation>
    </message>
</context>
<context>
    <name>DartDrag</name>
    <message>
        <source>Near the dotted line both legs become of one length, or type how deep it is – Shift keeps to it, Ctrl lets go, Esc takes it back</source>
        <translation>点線の近くで両辺が同じ長さになります。深さの入力も可。Shift で点線に固定、Ctrl で解除、Esc で取り消す</translation>
    </message>
    <message>
        <source>Drag the dart along the outline, or type how far its middle is from the corner – Esc takes it back</source>
        <translation>ダーツを輪郭に沿ってドラッグするか、角から中心までの距離を入力。Esc で取り消す</translation>
    </message>
</context>
<context>
    <name>DartPicture</name>
    <message>
        <source>Depth %1, legs of one length</source>
        <translation>深さ %1、両辺同じ長さ</translation>
    </message>
    <message>
        <source>Depth %1</source>
        <translation>深さ %1</translation>
    </message>
    <message>
        <source>Mouth %1</source>
        <translation>開き %1</translation>
    </message>
</context>
<context>
    <name>DartRotateTool</name>
    <message>
        <source>Select the seam of a dart first – Esc ends the tool</source>
        <translation>先にダーツの縫い目を選択してください。Esc でツールを終了</translation>
    </message>
    <message>
        <source>Click the outline where the dart shall open instead – Ctrl does not snap, Esc ends the tool</source>
        <translation>ダーツを新たに開く輪郭上の位置をクリック。Ctrl でスナップしない、Esc でツールを終了</translation>
    </message>
</context>
<context>
    <name>DartTool</name>
    <message>
        <source>There is no room for a mouth of &quot;%1&quot;.</source>
        <translation>「%1」の開きをとる余地がありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no depth: try 60</source>
        <translation>「%1」は深さではありません (例: 60)</translation>
    </message>
    <message>
        <source>Click the tip inside the patch, or type how deep it lies – on the dotted line both legs are of one length (Shift keeps to it, Ctrl lets go), Esc takes a click back</source>
        <translation>パーツ内でダーツの先端をクリックするか、深さを入力。点線上では両辺が同じ長さ (Shift で点線に固定、Ctrl で解除)、Esc でクリックを取り消す</translation>
    </message>
    <message>
        <source>Click where the mouth ends on the same outline, or type how wide it is – Ctrl does not snap, Esc takes the click back</source>
        <translation>同じ輪郭上で開きの終点をクリックするか、幅を入力。Ctrl でスナップしない、Esc でクリックを取り消す</translation>
    </message>
    <message>
        <source>Click an outline where the mouth of the dart begins – Esc ends the tool</source>
        <translation>輪郭上でダーツの開きの始点をクリック。Esc でツールを終了</translation>
    </message>
</context>
<context>
    <name>DescribedField</name>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
</context>
<context>
    <name>DesignCuttingSection</name>
    <message>
        <source>Cutting</source>
        <translation>裁断</translation>
    </message>
    <message>
        <source>Seam allowance of all patches</source>
        <translation>全パーツの縫い代</translation>
    </message>
    <message>
        <source>Depth of notches</source>
        <translation>ノッチの深さ</translation>
    </message>
    <message>
        <source>Width of notches</source>
        <translation>ノッチの幅</translation>
    </message>
</context>
<context>
    <name>Docks</name>
    <message>
        <source>Pattern</source>
        <translation>型紙</translation>
    </message>
    <message>
        <source>Cover</source>
        <translation>カバー</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>要素</translation>
    </message>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>プロパティ</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>問題</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>縫い目</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>生地</translation>
    </message>
    <message>
        <source>Worst spots</source>
        <translation>要注意箇所</translation>
    </message>
    <message>
        <source>Check before cutting</source>
        <translation>裁断前チェック</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>ジョブ</translation>
    </message>
</context>
<context>
    <name>DrawingCommands</name>
    <message>
        <source>&amp;Grid and snapping</source>
        <translation>グリッドとスナップ(&amp;G)</translation>
    </message>
    <message>
        <source>S&amp;napping</source>
        <translation>スナップ(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Rulers</source>
        <translation>ルーラー(&amp;R)</translation>
    </message>
    <message>
        <source>Gui&amp;des</source>
        <translation>ガイド(&amp;D)</translation>
    </message>
    <message>
        <source>Remove all g&amp;uides</source>
        <translation>ガイドをすべて削除(&amp;U)</translation>
    </message>
    <message>
        <source>Select with a &amp;loop</source>
        <translation>投げ縄で選択(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Background picture</source>
        <translation>背景画像(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Open picture …</source>
        <translation>画像を開く(&amp;O)…</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>表示(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Scale by two points</source>
        <translation>2 点で拡大縮小(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>移動(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>削除(&amp;R)</translation>
    </message>
    <message>
        <source>Opacity %1</source>
        <translation>不透明度 %1</translation>
    </message>
    <message>
        <source>Open a picture to trace</source>
        <translation>下絵の画像を開く</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.webp);;All files (*)</source>
        <translation>画像 (*.png *.jpg *.jpeg *.bmp *.webp);;すべてのファイル (*)</translation>
    </message>
</context>
<context>
    <name>DrawingKeys</name>
    <message>
        <source>&amp;Finish</source>
        <translation>完了(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Take back the last point</source>
        <translation>最後の点を取り消す(&amp;T)</translation>
    </message>
    <message>
        <source>Switch between &amp;straight and smooth</source>
        <translation>直線と曲線を切り替え(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>中止(&amp;G)</translation>
    </message>
</context>
<context>
    <name>DrillHoleForm</name>
    <message>
        <source>Patch</source>
        <translation>パーツ</translation>
    </message>
</context>
<context>
    <name>EdgeAllowanceForm</name>
    <message>
        <source>Outline</source>
        <translation>輪郭</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
</context>
<context>
    <name>EditCommands</name>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直す(&amp;R)</translation>
    </message>
    <message>
        <source>Name this &amp;branch …</source>
        <translation>この分岐に名前を付ける(&amp;B)…</translation>
    </message>
    <message>
        <source>Name the way that the history has gone since it forked</source>
        <translation>最後の分かれ目から履歴がたどった道筋に名前を付けます</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>名前を変更(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>削除(&amp;D)</translation>
    </message>
    <message>
        <source>Select &amp;all patches</source>
        <translation>すべてのパーツを選択(&amp;A)</translation>
    </message>
    <message>
        <source>Select n&amp;othing</source>
        <translation>選択を解除(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>元に戻す(&amp;U): %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>やり直す(&amp;R): %1</translation>
    </message>
</context>
<context>
    <name>ElementText</name>
    <message>
        <source>missing element %1</source>
        <translation>存在しない要素 %1</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>縫い目</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>縫い目</translation>
    </message>
    <message>
        <source>Fixation curve</source>
        <translation>固定曲線</translation>
    </message>
    <message>
        <source>Fixation curves</source>
        <translation>固定曲線</translation>
    </message>
    <message>
        <source>Fixation</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>Fixations</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>生地</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>生地</translation>
    </message>
    <message>
        <source>Unusable element</source>
        <translation>使用できない要素</translation>
    </message>
    <message>
        <source>Unusable elements</source>
        <translation>使用できない要素</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>デザイン</translation>
    </message>
    <message>
        <source>%1 and %2, ease %3</source>
        <translation>%1 と %2、いせ %3</translation>
    </message>
    <message>
        <source>%1, normal held</source>
        <translation>%1、法線固定</translation>
    </message>
    <message>
        <source>Handle curve</source>
        <translation>ハンドル曲線</translation>
    </message>
    <message>
        <source>Handle curves</source>
        <translation>ハンドル曲線</translation>
    </message>
    <message>
        <source>Fancy seam</source>
        <translation>飾り縫い</translation>
    </message>
    <message>
        <source>Fancy seams</source>
        <translation>飾り縫い</translation>
    </message>
    <message>
        <source>Cushion</source>
        <translation>クッション</translation>
    </message>
    <message>
        <source>Cushions</source>
        <translation>クッション</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>フォーム</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>スキャン</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>スキャン</translation>
    </message>
    <message>
        <source>%1 patches</source>
        <translation>パーツ %1 個</translation>
    </message>
    <message>
        <source>%1 seams</source>
        <translation>縫い目 %1 本</translation>
    </message>
    <message>
        <source>%1 fixation curves</source>
        <translation>固定曲線 %1 本</translation>
    </message>
    <message>
        <source>%1 fixations</source>
        <translation>固定 %1 件</translation>
    </message>
    <message>
        <source>%1 handle curves</source>
        <translation>ハンドル曲線 %1 本</translation>
    </message>
    <message>
        <source>%1 fancy seams</source>
        <translation>飾り縫い %1 本</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>フレーム %1 個</translation>
    </message>
    <message>
        <source>%1 cushions</source>
        <translation>クッション %1 個</translation>
    </message>
    <message>
        <source>%1 pieces of foam</source>
        <translation>フォーム %1 個</translation>
    </message>
    <message>
        <source>%1 scans</source>
        <translation>スキャン %1 件</translation>
    </message>
    <message>
        <source>%1 fabrics</source>
        <translation>生地 %1 種</translation>
    </message>
    <message>
        <source>%1 unusable elements</source>
        <translation>使用できない要素 %1 個</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>要素 %1 個</translation>
    </message>
    <message>
        <source>Trimmed edge</source>
        <translation>装飾した辺</translation>
    </message>
    <message>
        <source>Trimmed edges</source>
        <translation>装飾した辺</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>カラーウェイ</translation>
    </message>
    <message>
        <source>Colourways</source>
        <translation>カラーウェイ</translation>
    </message>
    <message>
        <source>%1 trimmed edges</source>
        <translation>装飾した辺 %1 本</translation>
    </message>
    <message>
        <source>%1 colourways</source>
        <translation>カラーウェイ %1 種</translation>
    </message>
    <message>
        <source>Edge of %1</source>
        <translation>%1 の辺</translation>
    </message>
    <message>
        <source>Allowance of an edge</source>
        <translation>辺の縫い代</translation>
    </message>
    <message>
        <source>Allowances of edges</source>
        <translation>辺の縫い代</translation>
    </message>
    <message>
        <source>%1 allowances of edges</source>
        <translation>辺の縫い代 %1 件</translation>
    </message>
    <message>
        <source>Corner of the cut line</source>
        <translation>裁断線の角</translation>
    </message>
    <message>
        <source>Corners of the cut line</source>
        <translation>裁断線の角</translation>
    </message>
    <message>
        <source>%1 corners of the cut line</source>
        <translation>裁断線の角 %1 個</translation>
    </message>
    <message>
        <source>Drill hole</source>
        <translation>ドリル穴</translation>
    </message>
    <message>
        <source>Drill holes</source>
        <translation>ドリル穴</translation>
    </message>
    <message>
        <source>%1 drill holes</source>
        <translation>ドリル穴 %1 個</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>ノッチ</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>ノッチ</translation>
    </message>
    <message>
        <source>%1 notches</source>
        <translation>ノッチ %1 個</translation>
    </message>
    <message>
        <source>Internal line</source>
        <translation>内部線</translation>
    </message>
    <message>
        <source>Internal lines</source>
        <translation>内部線</translation>
    </message>
    <message>
        <source>%1 internal lines</source>
        <translation>内部線 %1 本</translation>
    </message>
    <message>
        <source>%1, allowance %2</source>
        <translation>%1、縫い代 %2</translation>
    </message>
    <message>
        <source>Notch of %1</source>
        <translation>%1 のノッチ</translation>
    </message>
    <message>
        <source>Corner of %1</source>
        <translation>%1 の角</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>測定</translation>
    </message>
    <message>
        <source>%1 measurements</source>
        <translation>測定 %1 個</translation>
    </message>
</context>
<context>
    <name>ElementsModel</name>
    <message>
        <source>edge %1</source>
        <translation>辺 %1</translation>
    </message>
    <message>
        <source>%1 from the corner</source>
        <translation>角から %1</translation>
    </message>
</context>
<context>
    <name>FabricForm</name>
    <message>
        <source>Weft</source>
        <translation>よこ糸</translation>
    </message>
    <message>
        <source>Creases</source>
        <translation>溝</translation>
    </message>
    <message>
        <source>Depth of the pile</source>
        <translation>パイルの深さ</translation>
    </message>
    <message>
        <source>Other squares</source>
        <translation>もう一方の升目</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>縮尺</translation>
    </message>
    <message>
        <source>Squares</source>
        <translation>升目</translation>
    </message>
    <message>
        <source>Grain size</source>
        <translation>シボの大きさ</translation>
    </message>
    <message>
        <source>Repeat of the weave</source>
        <translation>織りの繰り返し</translation>
    </message>
    <message>
        <source>Nap</source>
        <translation>毛並み</translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation>画像の幅</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>特性</translation>
    </message>
    <message>
        <source>The fabric on a cushion and on a ball</source>
        <translation>クッションと球に張った生地</translation>
    </message>
    <message>
        <source>The fabric on a cushion and on a ball, at its real scale</source>
        <translation>クッションと球に張った生地 (実寸)</translation>
    </message>
    <message>
        <source>Colour of the fabric</source>
        <translation>生地の色</translation>
    </message>
    <message>
        <source>Second colour of the fabric</source>
        <translation>生地の 2 番目の色</translation>
    </message>
    <message>
        <source>From the first colour</source>
        <translation>1 番目の色から</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Choose an&amp;other picture …</source>
        <translation>別の画像を選択(&amp;O)…</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>裁断</translation>
    </message>
</context>
<context>
    <name>FabricMenu</name>
    <message>
        <source>&amp;New fabric</source>
        <translation>新しい生地(&amp;N)</translation>
    </message>
    <message>
        <source>Adds leather, weave, velvet or another fabric to the library of the design</source>
        <translation>革、織物、ベルベットなどの生地をデザインのライブラリに追加します</translation>
    </message>
    <message>
        <source>From a &amp;picture …</source>
        <translation>画像から(&amp;P)…</translation>
    </message>
    <message>
        <source>A fabric that looks like a picture: PNG, JPEG, TIFF or OpenEXR</source>
        <translation>画像の見た目をもつ生地: PNG、JPEG、TIFF、OpenEXR</translation>
    </message>
    <message>
        <source>&amp;Assign to selection</source>
        <translation>選択に割り当て(&amp;A)</translation>
    </message>
    <message>
        <source>Gives the selected patches the fabric that is chosen in the library</source>
        <translation>ライブラリで選んだ生地を選択中のパーツに割り当てます</translation>
    </message>
    <message>
        <source>Fabric p&amp;roperties</source>
        <translation>生地のプロパティ(&amp;R)</translation>
    </message>
    <message>
        <source>Shows kind, colours, size and limits of the fabric</source>
        <translation>生地の種類、色、大きさ、限界を表示します</translation>
    </message>
    <message>
        <source>Picture on the &amp;fabric …</source>
        <translation>生地に画像を適用(&amp;F)…</translation>
    </message>
    <message>
        <source>Lets the fabric look like a picture: PNG, JPEG, TIFF or OpenEXR</source>
        <translation>生地を画像の見た目にします: PNG、JPEG、TIFF、OpenEXR</translation>
    </message>
    <message>
        <source>D&amp;uplicate fabric</source>
        <translation>生地を複製(&amp;U)</translation>
    </message>
    <message>
        <source>Adds a copy of the fabric, to be changed</source>
        <translation>変更用に生地のコピーを追加します</translation>
    </message>
    <message>
        <source>Rename fa&amp;bric …</source>
        <translation>生地の名前を変更(&amp;B)…</translation>
    </message>
    <message>
        <source>Gives the fabric another name</source>
        <translation>生地に別の名前を付けます</translation>
    </message>
    <message>
        <source>&amp;Delete fabric …</source>
        <translation>生地を削除(&amp;D)…</translation>
    </message>
    <message>
        <source>Removes the fabric; asks what patches get instead</source>
        <translation>生地を削除し、代わりにパーツに割り当てる生地を尋ねます</translation>
    </message>
    <message>
        <source>&amp;Import fabrics …</source>
        <translation>生地をインポート(&amp;I)…</translation>
    </message>
    <message>
        <source>Takes over the fabrics of a file, a design or a project</source>
        <translation>ファイル、デザイン、プロジェクトの生地を取り込みます</translation>
    </message>
    <message>
        <source>&amp;Export fabric …</source>
        <translation>生地をエクスポート(&amp;E)…</translation>
    </message>
    <message>
        <source>Writes the fabric to a file, its picture beside it</source>
        <translation>生地をファイルに書き出し、画像を横に置きます</translation>
    </message>
    <message>
        <source>Pre&amp;views</source>
        <translation>プレビュー(&amp;V)</translation>
    </message>
    <message>
        <source>On &amp;cushions</source>
        <translation>クッション(&amp;C)</translation>
    </message>
    <message>
        <source>Shows the fabrics of the library on cushions</source>
        <translation>ライブラリの生地をクッションで表示します</translation>
    </message>
    <message>
        <source>On &amp;balls</source>
        <translation>球(&amp;B)</translation>
    </message>
    <message>
        <source>Shows the fabrics of the library on balls</source>
        <translation>ライブラリの生地を球で表示します</translation>
    </message>
    <message>
        <source>&amp;Show colourway</source>
        <translation>カラーウェイを表示(&amp;S)</translation>
    </message>
    <message>
        <source>Chooses which fabrics are seen; the shape stays</source>
        <translation>表示する生地を選びます。形は変わりません</translation>
    </message>
    <message>
        <source>New &amp;colourway …</source>
        <translation>新しいカラーウェイ(&amp;C)…</translation>
    </message>
    <message>
        <source>Adds a set of fabrics for the patches; it begins as what is shown now</source>
        <translation>パーツ用の生地一式を追加します。現在の表示から始まります</translation>
    </message>
    <message>
        <source>Rena&amp;me colourway …</source>
        <translation>カラーウェイの名前を変更(&amp;M)…</translation>
    </message>
    <message>
        <source>Gives the colourway that is shown another name</source>
        <translation>表示中のカラーウェイに別の名前を付けます</translation>
    </message>
    <message>
        <source>De&amp;lete colourway</source>
        <translation>カラーウェイを削除(&amp;L)</translation>
    </message>
    <message>
        <source>Removes the colourway that is shown</source>
        <translation>表示中のカラーウェイを削除します</translation>
    </message>
    <message>
        <source>Compare c&amp;olourways …</source>
        <translation>カラーウェイを比較(&amp;O)…</translation>
    </message>
    <message>
        <source>Shows two colourways side by side</source>
        <translation>2 つのカラーウェイを並べて表示します</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>元の仕様</translation>
    </message>
</context>
<context>
    <name>FabricPresets</name>
    <message>
        <source>Leather, cognac</source>
        <translation>革、コニャック</translation>
    </message>
    <message>
        <source>Leather, black</source>
        <translation>革、黒</translation>
    </message>
    <message>
        <source>Leather, cream</source>
        <translation>革、クリーム</translation>
    </message>
    <message>
        <source>Smooth leather, dark brown</source>
        <translation>スムース革、こげ茶</translation>
    </message>
    <message>
        <source>Smooth leather, red</source>
        <translation>スムース革、赤</translation>
    </message>
    <message>
        <source>Weave, grey</source>
        <translation>織物、グレー</translation>
    </message>
    <message>
        <source>Weave, blue</source>
        <translation>織物、青</translation>
    </message>
    <message>
        <source>Weave, sand</source>
        <translation>織物、サンド</translation>
    </message>
    <message>
        <source>Velvet, green</source>
        <translation>ベルベット、緑</translation>
    </message>
    <message>
        <source>Velvet, petrol</source>
        <translation>ベルベット、青緑</translation>
    </message>
    <message>
        <source>Checker, 20 mm</source>
        <translation>市松、20&#xa0;mm</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>無地</translation>
    </message>
</context>
<context>
    <name>FancySeamForm</name>
    <message>
        <source>Patch</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>It stands out: a welt.</source>
        <translation>盛り上がっています (うね)。</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>Patch</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>生地</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>生地</translation>
    </message>
    <message>
        <source>Press harder</source>
        <translation>より強く押す</translation>
    </message>
    <message>
        <source>Press like straight ones</source>
        <translation>まっすぐな面と同じ</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Padded parts</source>
        <translation>詰め物をする部品</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>押す対象</translation>
    </message>
    <message>
        <source>Smallest detail</source>
        <translation>最小ディテール</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>詰め物</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>強さ</translation>
    </message>
    <message>
        <source>Slanted faces</source>
        <translation>斜めの面</translation>
    </message>
    <message>
        <source>Pushes the cover</source>
        <translation>カバーを押す</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>無地</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>市松</translation>
    </message>
    <message>
        <source>Smooth leather</source>
        <translation>スムース革</translation>
    </message>
    <message>
        <source>Grained leather</source>
        <translation>シボ革</translation>
    </message>
    <message>
        <source>Woven</source>
        <translation>織物</translation>
    </message>
    <message>
        <source>Velvet</source>
        <translation>ベルベット</translation>
    </message>
    <message>
        <source>Picture …</source>
        <translation>画像…</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Second colour</source>
        <translation>2 番目の色</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>粗さ</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>縮尺</translation>
    </message>
    <message>
        <source>Turned from the grain</source>
        <translation>地の目からの回転</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>凹凸</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Most along the grain</source>
        <translation>地の目方向の最大</translation>
    </message>
    <message>
        <source>Most across</source>
        <translation>直交方向の最大</translation>
    </message>
    <message>
        <source>Most shear</source>
        <translation>せん断の最大</translation>
    </message>
    <message>
        <source>Poisson</source>
        <translation>ポアソン比</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>剛性</translation>
    </message>
    <message>
        <source>Bending length</source>
        <translation>曲げ長さ</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>外観</translation>
    </message>
    <message>
        <source>Strain limits</source>
        <translation>ひずみ限界</translation>
    </message>
    <message>
        <source>Mirror twin</source>
        <translation>対称ペア</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>On the curve</source>
        <translation>曲線上の位置</translation>
    </message>
    <message>
        <source>Curve runs backwards</source>
        <translation>曲線が逆向き</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>重み</translation>
    </message>
    <message>
        <source>Curve in space</source>
        <translation>空間上の曲線</translation>
    </message>
    <message>
        <source>Round – a soft groove</source>
        <translation>丸い – 柔らかな溝</translation>
    </message>
    <message>
        <source>Sharp – a crease</source>
        <translation>鋭い – 折り目</translation>
    </message>
    <message>
        <source>Welt – between creases</source>
        <translation>うね – 折り目の間</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深さ</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>断面形状</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>地の目</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>圧力</translation>
    </message>
    <message>
        <source>Wrong side out</source>
        <translation>裏を外にする</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>輪郭</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>木材</translation>
    </message>
    <message>
        <source>Metal</source>
        <translation>金属</translation>
    </message>
    <message>
        <source>Plastic</source>
        <translation>プラスチック</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>フォーム</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Keeps the cover outside</source>
        <translation>カバーを外側に保つ</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>すき間</translation>
    </message>
    <message>
        <source>Hidden parts</source>
        <translation>非表示の部品</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>直方体</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>円柱</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>球</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>メッシュ</translation>
    </message>
    <message>
        <source>Cushion</source>
        <translation>クッション</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>くり抜く</translation>
    </message>
    <message>
        <source>Along the normal</source>
        <translation>法線方向</translation>
    </message>
    <message>
        <source>To the point itself</source>
        <translation>点そのものへ</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>しきい値</translation>
    </message>
    <message>
        <source>Fit the cover to it</source>
        <translation>カバーを合わせる</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>引く力</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>切り取り</translation>
    </message>
    <message>
        <source>C0 – an edge</source>
        <translation>C0 – 角あり</translation>
    </message>
    <message>
        <source>C1 – smooth, texture too</source>
        <translation>C1 – 滑らか、柄も</translation>
    </message>
    <message>
        <source>G1 – rounded</source>
        <translation>G1 – 丸める</translation>
    </message>
    <message>
        <source>First stretch</source>
        <translation>1 番目の区間</translation>
    </message>
    <message>
        <source>Second stretch</source>
        <translation>2 番目の区間</translation>
    </message>
    <message>
        <source>Second side runs backwards</source>
        <translation>2 番目の側が逆向き</translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation>連続性</translation>
    </message>
    <message>
        <source>Mesh edges</source>
        <translation>メッシュのエッジ</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>対称</translation>
    </message>
    <message>
        <source>Colourway shown</source>
        <translation>表示中のカラーウェイ</translation>
    </message>
    <message>
        <source>Begins at</source>
        <translation>始点</translation>
    </message>
    <message>
        <source>Ends at</source>
        <translation>終点</translation>
    </message>
    <message>
        <source>By length</source>
        <translation>長さで</translation>
    </message>
    <message>
        <source>By parameter</source>
        <translation>パラメータで</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>対応付け</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Single row</source>
        <translation>シングル</translation>
    </message>
    <message>
        <source>Twin rows</source>
        <translation>ダブル</translation>
    </message>
    <message>
        <source>Stitches</source>
        <translation>ステッチ</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>糸</translation>
    </message>
    <message>
        <source>Stitch length</source>
        <translation>ステッチ長さ</translation>
    </message>
    <message>
        <source>Distance from the seam</source>
        <translation>縫い目からの距離</translation>
    </message>
    <message>
        <source>Thread width</source>
        <translation>糸の太さ</translation>
    </message>
    <message>
        <source>Radius (0: none)</source>
        <translation>半径 (0: なし)</translation>
    </message>
    <message>
        <source>Seam allowance</source>
        <translation>縫い代</translation>
    </message>
    <message>
        <source>The cover dips into the seam</source>
        <translation>カバーが縫い目でくぼむ</translation>
    </message>
    <message>
        <source>Trim</source>
        <translation>装飾</translation>
    </message>
    <message>
        <source> mm per unit</source>
        <translation> mm/単位</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>The frame that is padded</source>
        <translation>詰め物をするフレーム</translation>
    </message>
    <message>
        <source>Which cover the padding presses outwards</source>
        <translation>詰め物が外へ押すカバー</translation>
    </message>
    <message>
        <source>How finely the frame is looked at: what is thinner may stay without padding</source>
        <translation>フレームを見る細かさ。これより薄い部分には詰め物が付かないことがあります</translation>
    </message>
    <message>
        <source>How thick the padding around the frame is</source>
        <translation>フレームまわりの詰め物の厚さ</translation>
    </message>
    <message>
        <source>How hard the padding presses the cover outwards; from about 2 on it gives no more</source>
        <translation>詰め物がカバーを外へ押す強さ。約 2 以上では変わりません</translation>
    </message>
    <message>
        <source>How padding presses that is aslant to width, depth and height: harder fills the cover more</source>
        <translation>幅・奥行・高さに対して斜めの詰め物の押し方。強いほどカバーがよく張ります</translation>
    </message>
    <message>
        <source>How thick the padding around this foam is</source>
        <translation>このフォームまわりの詰め物の厚さ</translation>
    </message>
    <message>
        <source>How hard this foam presses the cover outwards; from about 2 on it gives no more</source>
        <translation>このフォームがカバーを外へ押す強さ。約 2 以上では変わりません</translation>
    </message>
    <message>
        <source>Takes this shape out of the cushion instead of adding it</source>
        <translation>この形状をクッションに加えず、くり抜きます</translation>
    </message>
    <message>
        <source>as made</source>
        <translation>元の仕様</translation>
    </message>
    <message>
        <source>Stitching</source>
        <translation>ステッチ</translation>
    </message>
    <message>
        <source>Thread colour</source>
        <translation>糸の色</translation>
    </message>
    <message>
        <source>Stitch distance</source>
        <translation>ステッチの距離</translation>
    </message>
    <message>
        <source>Piping radius</source>
        <translation>パイピングの半径</translation>
    </message>
    <message>
        <source>Piping fabric</source>
        <translation>パイピングの生地</translation>
    </message>
    <message>
        <source>Valley</source>
        <translation>谷</translation>
    </message>
    <message>
        <source>Mitred – to a point</source>
        <translation>留め – 尖らせる</translation>
    </message>
    <message>
        <source>Square – cut off</source>
        <translation>直角 – 切り落とす</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>丸める</translation>
    </message>
    <message>
        <source>Folded – lies under the piece</source>
        <translation>折り返し – パーツの下に重なる</translation>
    </message>
    <message>
        <source>Stepped</source>
        <translation>段付き</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>縫い代</translation>
    </message>
    <message>
        <source>From the sewing line to the line where the fabric is cut.</source>
        <translation>出来上がり線から裁断線まで。</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>角</translation>
    </message>
    <message>
        <source>Corners of the cut line</source>
        <translation>裁断線の角</translation>
    </message>
    <message>
        <source>as the design&apos;s</source>
        <translation>デザインと同じ</translation>
    </message>
    <message>
        <source>Lies at</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>角</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>スリット</translation>
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
        <translation>角形</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>ノッチ</translation>
    </message>
    <message>
        <source>Depth of notches</source>
        <translation>ノッチの深さ</translation>
    </message>
    <message>
        <source>Width of notches</source>
        <translation>ノッチの幅</translation>
    </message>
    <message>
        <source>Notches along seams every</source>
        <translation>縫い目のノッチの間隔</translation>
    </message>
    <message>
        <source>Notches at ends of seams</source>
        <translation>縫い目の端のノッチ</translation>
    </message>
    <message>
        <source>Notches that tell halves apart</source>
        <translation>左右を区別するノッチ</translation>
    </message>
    <message>
        <source>Two side by side</source>
        <translation>2 つ並び</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>裁断</translation>
    </message>
    <message>
        <source>Label at</source>
        <translation>ラベルの位置</translation>
    </message>
    <message>
        <source>Label turned by</source>
        <translation>ラベルの回転</translation>
    </message>
    <message>
        <source>Two ways – either end up</source>
        <translation>二方向 – 上下どちらでも</translation>
    </message>
    <message>
        <source>One way – one end up</source>
        <translation>一方向 – 上下を揃える</translation>
    </message>
    <message>
        <source>Any direction</source>
        <translation>全方向</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>Mirrored pair</source>
        <translation>左右対</translation>
    </message>
    <message>
        <source>Nap</source>
        <translation>毛並み</translation>
    </message>
    <message>
        <source>Grain may be off by</source>
        <translation>地の目の許容ずれ</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>ラベル</translation>
    </message>
    <message>
        <source>where it finds room</source>
        <translation>空いている場所</translation>
    </message>
    <message>
        <source>Usable width</source>
        <translation>有効幅</translation>
    </message>
    <message>
        <source>Shrinks along</source>
        <translation>縦の縮み</translation>
    </message>
    <message>
        <source>Pieces are cut so much larger along the grain that they have their size when the fabric has shrunk.</source>
        <translation>生地が縮んだ後に寸法どおりになるよう、地の目方向にその分大きく裁断します。</translation>
    </message>
    <message>
        <source>Shrinks across</source>
        <translation>横の縮み</translation>
    </message>
    <message>
        <source>10 mm</source>
        <translation>10&#xa0;mm</translation>
    </message>
    <message>
        <source>Automatic notches</source>
        <translation>自動ノッチ</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>品番</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>バージョン</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>描く</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切る</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>省略</translation>
    </message>
    <message>
        <source>On the cutting table</source>
        <translation>裁断台上</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>目安線</translation>
    </message>
    <message>
        <source>Top stitching</source>
        <translation>トップステッチ</translation>
    </message>
    <message>
        <source>Tie-down strip</source>
        <translation>吊り込み布</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>折り線</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>用途</translation>
    </message>
    <message>
        <source>Ease wanted</source>
        <translation>目標のいせ</translation>
    </message>
    <message>
        <source>How much longer the second side shall be than the first one: it is gathered when it is sewn.</source>
        <translation>2 番目の側を 1 番目よりどれだけ長くするか。縫うときにいせ込みます。</translation>
    </message>
    <message>
        <source>Bulge of the allowance</source>
        <translation>縫い代のふくらみ</translation>
    </message>
    <message>
        <source>With a zip</source>
        <translation>ファスナー付き</translation>
    </message>
    <message>
        <source>A zip joins the two sides; the sewing sheet tells its length.</source>
        <translation>ファスナーで両側をつなぎます。長さは縫製シートに記載されます。</translation>
    </message>
    <message>
        <source>Step in sewing</source>
        <translation>縫製の順番</translation>
    </message>
    <message>
        <source>Seams with a number are sewn first, smaller ones before larger ones. 0: as the program proposes it.</source>
        <translation>番号のある縫い目を、小さい順に先に縫います。0: プログラムの提案どおり。</translation>
    </message>
    <message>
        <source>How near a point of the scan must be to pull at the cover. What the scan has not seen stays as the pattern makes it.</source>
        <translation>スキャンの点がカバーを引く距離の上限。スキャンに写っていない所は型紙どおりのままです。</translation>
    </message>
    <message>
        <source>How firmly the scan pulls at the cover, against the pattern: more follows finer detail, and more of the noise.</source>
        <translation>スキャンが型紙に対してカバーを引く強さ。大きいほど細部に沿い、ノイズも拾います。</translation>
    </message>
    <message>
        <source>The cover is pulled to the scan. Without that it is only measured. Align the scan first.</source>
        <translation>カバーをスキャンに引き寄せます。オフなら測定のみです。先にスキャンを位置合わせしてください。</translation>
    </message>
    <message>
        <source>To its surface: the cover may slide along it. To its points: it may not, which suits scans with few points.</source>
        <translation>面へ: カバーは面に沿って滑れます。点へ: 滑れません。点の少ないスキャンに向きます。</translation>
    </message>
    <message>
        <source>For whoever works on the design: it changes neither the cover nor what is cut</source>
        <translation>デザインを扱う人のためのメモ。カバーにも裁断にも影響しません</translation>
    </message>
    <message>
        <source>Line on the label</source>
        <translation>ラベルの行</translation>
    </message>
    <message>
        <source>From</source>
        <translation>始点</translation>
    </message>
    <message>
        <source>To</source>
        <translation>終点</translation>
    </message>
    <message>
        <source>A filling that presses from inside. 0.05 to 0.3 fills a cushion; at 1 most fabrics are stretched too far.</source>
        <translation>内側から押す詰め物です。0.05～0.3でクッションが膨らみ、1ではほとんどの生地が伸びすぎます。</translation>
    </message>
    <message>
        <source>How long the edges of the triangles are: shorter ones show smaller folds, and take longer.</source>
        <translation>三角形の辺の長さです。短いほど細かいしわが表れ、時間がかかります。</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>&amp;New</source>
        <translation>新規(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>開く(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近使ったファイル(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Unsaved work</source>
        <translation>未保存の作業(&amp;U)</translation>
    </message>
    <message>
        <source>Sa&amp;mples</source>
        <translation>サンプル(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>名前を付けて保存(&amp;A)…</translation>
    </message>
    <message>
        <source>Save a &amp;copy</source>
        <translation>コピーを保存(&amp;C)</translation>
    </message>
    <message>
        <source>With &amp;everything …</source>
        <translation>すべて含む(&amp;E)…</translation>
    </message>
    <message>
        <source>Without &amp;history …</source>
        <translation>履歴なし(&amp;H)…</translation>
    </message>
    <message>
        <source>Without history and &amp;scans …</source>
        <translation>履歴とスキャンなし(&amp;S)…</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>保存した状態に戻す(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Import frame …</source>
        <translation>フレームをインポート(&amp;I)…</translation>
    </message>
    <message>
        <source>Impor&amp;t scan …</source>
        <translation>スキャンをインポート(&amp;T)…</translation>
    </message>
    <message>
        <source>&amp;Export surface …</source>
        <translation>面をエクスポート(&amp;E)…</translation>
    </message>
    <message>
        <source>Export &amp;picture …</source>
        <translation>画像をエクスポート(&amp;P)…</translation>
    </message>
    <message>
        <source>Ren&amp;der picture …</source>
        <translation>画像をレンダリング(&amp;D)…</translation>
    </message>
    <message>
        <source>E&amp;xport pattern …</source>
        <translation>型紙をエクスポート(&amp;X)…</translation>
    </message>
    <message>
        <source>Import pattern (DX&amp;F, SVG) …</source>
        <translation>型紙をインポート (DXF、SVG)(&amp;F)…</translation>
    </message>
    <message>
        <source>Export cover (&amp;HTML, glTF, STL) …</source>
        <translation>カバーをエクスポート (HTML、glTF、STL)(&amp;H)…</translation>
    </message>
    <message>
        <source>Export foam &amp;body …</source>
        <translation>フォームの形状をエクスポート(&amp;B)…</translation>
    </message>
    <message>
        <source>Print view …</source>
        <translation>ビューを印刷…</translation>
    </message>
</context>
<context>
    <name>FileFormats</name>
    <message>
        <source>Page for the customer</source>
        <translation>顧客向けページ</translation>
    </message>
    <message>
        <source>USDZ, for phones</source>
        <translation>USDZ、スマートフォン用</translation>
    </message>
    <message>
        <source>OBJ with materials</source>
        <translation>OBJ、マテリアル付き</translation>
    </message>
    <message>
        <source>STL, with a thickness</source>
        <translation>STL、厚み付き</translation>
    </message>
    <message>
        <source>3MF, with a thickness</source>
        <translation>3MF、厚み付き</translation>
    </message>
    <message>
        <source>STEP, curves alone</source>
        <translation>STEP、曲線のみ</translation>
    </message>
    <message>
        <source>STEP, of flat faces</source>
        <translation>STEP、平面で構成</translation>
    </message>
</context>
<context>
    <name>FixationCurveForm</name>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
</context>
<context>
    <name>FixationDrawTool</name>
    <message>
        <source>A curve needs two points, a closed one three.</source>
        <translation>曲線には 2 点、閉じた曲線には 3 点が必要です。</translation>
    </message>
    <message>
        <source>Fixation %1</source>
        <translation>固定 %1</translation>
    </message>
    <message>
        <source>Click to close the curve</source>
        <translation>クリックで曲線を閉じる</translation>
    </message>
    <message>
        <source>There is neither a frame nor the cover here: click on one, or type x, y, z.</source>
        <translation>ここにはフレームもカバーもありません。どちらかをクリックするか、x, y, z を入力してください。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no place: try 250, -100, 40</source>
        <translation>「%1」は位置ではありません (例: 250, -100, 40)</translation>
    </message>
    <message>
        <source>Enter sets the point: x, y, z – without z it is as high as the last one</source>
        <translation>Enter で点を設定: x, y, z。z を省くと直前の点と同じ高さ</translation>
    </message>
    <message>
        <source>Click on a frame to begin a fixation curve, or type x, y, z – drag turns the view, Esc ends the tool</source>
        <translation>フレームをクリックして固定曲線を始めるか、x, y, z を入力。ドラッグでビューを回転、Esc でツールを終了</translation>
    </message>
    <message>
        <source>Click or type the next point, Enter ends, C closes – B makes it straight, Backspace takes a point back</source>
        <translation>次の点をクリックまたは入力、Enter で終了、C で閉じる。B で直線、Backspace で点を取り消す</translation>
    </message>
    <message>
        <source>Click or type the next point, Enter ends, C closes – straight from point to point, whatever lies between: B makes it smooth along the surface, Backspace takes a point back</source>
        <translation>次の点をクリックまたは入力、Enter で終了、C で閉じる。間に何があっても点から点へ直線: B で面に沿って滑らかに、Backspace で点を取り消す</translation>
    </message>
    <message>
        <source>&amp;Close the curve</source>
        <translation>曲線を閉じる(&amp;C)</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1、%2、%3</translation>
    </message>
</context>
<context>
    <name>FixationSeamForm</name>
    <message>
        <source>Curve</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>輪郭</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>On the curve</source>
        <translation>曲線上の位置</translation>
    </message>
</context>
<context>
    <name>FixationsLeft</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>他 %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>They stay where they are. Drag their points onto the frame, or undo the change.</source>
        <translation>そのままの位置に残ります。点をフレーム上へドラッグするか、変更を元に戻してください。</translation>
    </message>
    <message numerus="yes">
        <source>%n fixation curve(s) no longer lie on the frame.</source>
        <translation>
            <numerusform>%n 本の固定曲線がフレーム上から外れました。</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1”: its edge is up to %2 away</source>
        <translation>「%1」: 辺が最大 %2 離れています</translation>
    </message>
    <message>
        <source>“%1”: up to %2</source>
        <translation>「%1」: 最大 %2</translation>
    </message>
    <message>
        <source>“%1”: more than %2</source>
        <translation>「%1」: %2 超</translation>
    </message>
</context>
<context>
    <name>FixingCommands</name>
    <message>
        <source>&amp;Create fixation curve</source>
        <translation>固定曲線を作成(&amp;C)</translation>
    </message>
    <message>
        <source>Select two points of an outline first: what lies between them is fixed.</source>
        <translation>先に輪郭の 2 点を選択してください。その間が固定されます。</translation>
    </message>
    <message>
        <source>Fixation %1</source>
        <translation>固定 %1</translation>
    </message>
    <message>
        <source>There is no surface of this patch yet on which the curve could lie.</source>
        <translation>このパーツには、曲線を置ける面がまだありません。</translation>
    </message>
</context>
<context>
    <name>FoamForm</name>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
</context>
<context>
    <name>FormPatternReport</name>
    <message numerus="yes">
        <source>(and %n more)</source>
        <translation>
            <numerusform>（ほか %n 件）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>パーツ %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seams, whose sides are equally long</source>
        <translation>
            <numerusform>縫い目 %n 本、両側は同じ長さ</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seams, whose sides differ by %1 at most</source>
        <translation>
            <numerusform>縫い目 %n 本、両側の長さの差は最大 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Its cover at rest lies up to %1 beside the form, where nothing holds it: tick &quot;Keeps the cover outside&quot; at the frame, or hold it by a fixation.</source>
        <translation>静止時のカバーは、固定するものがない所で形状から最大 %1 離れています。フレームで「カバーを外側に保つ」にチェックを入れるか、固定してください。</translation>
    </message>
    <message>
        <source>Its cover at rest lies up to %1 beside the form, where nothing holds it: hold it by a fixation, or give its pieces pressure.</source>
        <translation>静止時のカバーは、固定するものがない所で形状から最大 %1 離れています。固定するか、パーツに圧力を与えてください。</translation>
    </message>
    <message>
        <source>Its cover is being solved …</source>
        <translation>カバーを計算しています …</translation>
    </message>
    <message>
        <source>Its cover does not come to rest.</source>
        <translation>カバーが静止しません。</translation>
    </message>
    <message>
        <source>Its cover at rest is strained no more than the fabric may be.</source>
        <translation>静止したカバーのひずみは生地の許容範囲内です。</translation>
    </message>
    <message>
        <source>What counts is its cover at rest: %1</source>
        <translation>重要なのは静止したカバーです: %1</translation>
    </message>
    <message>
        <source>Laid on the form by itself no piece is strained so much. Narrow tips and steps of a line do that, or mesh edges that are long for them.</source>
        <translation>単独で形状に載せたときは、これほどひずむパーツはありません。細い先端や線の段差、またはそれに対して長いメッシュの辺が原因です。</translation>
    </message>
    <message numerus="yes">
        <source>and %n more are left out, too</source>
        <translation>
            <numerusform>ほかに %n 個も除外されます</numerusform>
        </translation>
    </message>
    <message>
        <source>Laid on the form by itself most strained: %1, %2 (rms), %3 within 99 % of its area, %4 where it is most</source>
        <translation>単独で形状に載せたときの最大ひずみ: %1、%2 (RMS)、面積の 99 % で %3 以内、最大の所で %4</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces are strained by more than the fabric may be in more than a hundredth of their area (yellow): divide them, or cut them in there.</source>
        <translation>
            <numerusform>%n 個のパーツで、面積の 100 分の 1 を超える所に生地の許容を超えるひずみがあります (黄色)。分割するか、そこに切り込みを入れてください。</numerusform>
        </translation>
    </message>
    <message>
        <source>Its cover will have about %1 vertices, and is not solved here: with mesh edges of %2 it is.</source>
        <translation>カバーの頂点は約 %1 個になり、ここでは計算しません: メッシュの辺を %2 にすると計算します。</translation>
    </message>
    <message>
        <source>So that the cover does not sink into the frame, tick &quot;Keeps the cover outside&quot; at the frame.</source>
        <translation>カバーがフレームに沈まないようにするには、フレームで「カバーを外側に保つ」にチェックを入れてください。</translation>
    </message>
    <message>
        <source>With shorter mesh edges smaller pieces are divided, too.</source>
        <translation>メッシュの辺を短くすると、より小さなパーツも分割されます。</translation>
    </message>
    <message>
        <source>Tick &quot;where it would not lie flat&quot;: that finds where to divide them.</source>
        <translation>「平らにならない所」にチェックを入れてください。分割する所が見つかります。</translation>
    </message>
    <message>
        <source>The form is taken as %1 large. If that is wrong, import the file as a frame.</source>
        <translation>形状の大きさを %1 とみなします。違う場合は、ファイルをフレームとして読み込んでください。</translation>
    </message>
</context>
<context>
    <name>FrameEdgeCommands</name>
    <message>
        <source>Fixation curve along an &amp;edge</source>
        <translation>エッジに沿った固定曲線(&amp;E)</translation>
    </message>
    <message>
        <source>Click an edge of a frame: of STEP and IGES the edges of its faces, exactly; of others where their triangles bend</source>
        <translation>フレームのエッジをクリック: STEP と IGES では面のエッジそのもの、その他では三角形の折れ目</translation>
    </message>
    <message>
        <source>Looking for the edges of the frames …</source>
        <translation>フレームのエッジを検索しています…</translation>
    </message>
    <message>
        <source>The frames have no edges: they are smooth everywhere, or are not read yet.</source>
        <translation>フレームにエッジがありません。全体が滑らかか、まだ読み込まれていません。</translation>
    </message>
</context>
<context>
    <name>FrameEdgeTool</name>
    <message>
        <source>Fixation %1</source>
        <translation>固定 %1</translation>
    </message>
    <message>
        <source>Click an edge of a frame to make a fixation curve of it – drag turns the view, Esc ends the tool</source>
        <translation>フレームのエッジをクリックして固定曲線にする。ドラッグでビューを回転、Esc でツールを終了</translation>
    </message>
    <message>
        <source>Click to make a fixation curve of this edge – Ctrl takes it alone, without those in which it goes on smoothly</source>
        <translation>クリックでこのエッジを固定曲線にする。Ctrl で、滑らかに続くエッジを含めずこれだけ</translation>
    </message>
    <message>
        <source>There is no edge of a frame here. A curve of your own: Frame &gt; Draw fixation curve.</source>
        <translation>ここにはフレームのエッジがありません。自分で描くには：フレーム &gt; 固定曲線を描く。</translation>
    </message>
</context>
<context>
    <name>FrameForm</name>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Choose an&amp;other file …</source>
        <translation>別のファイルを選択(&amp;O)…</translation>
    </message>
    <message>
        <source>Colour of the frame</source>
        <translation>フレームの色</translation>
    </message>
</context>
<context>
    <name>FrameParts</name>
    <message>
        <source>Mesh</source>
        <translation>メッシュ</translation>
    </message>
    <message>
        <source>Piece %1: %2</source>
        <translation>部分 %1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n piece(s)</source>
        <translation>
            <numerusform>%1: %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>部品</translation>
    </message>
    <message>
        <source>Show a&amp;ll parts</source>
        <translation>すべての部品を表示(&amp;L)</translation>
    </message>
    <message>
        <source>Parts without a mark are left out: they are not drawn, and neither drawing along the frame nor cushioning nor contact knows them.</source>
        <translation>チェックのない部品は除外されます。描画されず、フレームに沿った作図、クッション、接触の対象にもなりません。</translation>
    </message>
    <message>
        <source>%1: not in this frame</source>
        <translation>%1: このフレームにありません</translation>
    </message>
    <message>
        <source>Padded parts</source>
        <translation>詰め物をする部品</translation>
    </message>
    <message>
        <source>Without a mark, those parts are padded that the cover is fixed to.</source>
        <translation>チェックがなければ、カバーを固定した部品に詰め物をします。</translation>
    </message>
    <message>
        <source>This frame is large: the smallest detail can be %1 here.</source>
        <translation>このフレームは大きいため、最小ディテールは %1 までです。</translation>
    </message>
</context>
<context>
    <name>HandleCurveForm</name>
    <message>
        <source>Patch</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>型紙上</translation>
    </message>
    <message>
        <source>In space</source>
        <translation>空間上</translation>
    </message>
    <message>
        <source>free</source>
        <translation>自由</translation>
    </message>
</context>
<context>
    <name>HelpCommands</name>
    <message>
        <source>&amp;Find a command …</source>
        <translation>コマンドを検索(&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse …</source>
        <translation>キーとマウス(&amp;K)…</translation>
    </message>
    <message>
        <source>&amp;Edit shortcuts …</source>
        <translation>ショートカットを編集(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;About Bolster</source>
        <translation>Bolster について(&amp;A)</translation>
    </message>
</context>
<context>
    <name>HelpDialogs</name>
    <message>
        <source>Select</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>click; Shift+click adds; drag a box</source>
        <translation>クリック。Shift+クリックで追加、ドラッグで範囲選択</translation>
    </message>
    <message>
        <source>Move control points or patches</source>
        <translation>制御点またはパーツを移動</translation>
    </message>
    <message>
        <source>drag; Shift keeps to one axis; Esc takes it back</source>
        <translation>ドラッグ。Shift で 1 軸に固定、Esc で取り消す</translation>
    </message>
    <message>
        <source>Turn patches</source>
        <translation>パーツを回転</translation>
    </message>
    <message>
        <source>drag the round handle; Shift in steps of 15°</source>
        <translation>丸いハンドルをドラッグ。Shift で 15° 刻み</translation>
    </message>
    <message>
        <source>Add a control point</source>
        <translation>制御点を追加</translation>
    </message>
    <message>
        <source>arrow keys, Shift+arrow keys</source>
        <translation>矢印キー、Shift+矢印キー</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>表示を移動</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>ズーム</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>A workbench for people who design upholstered furniture and car seats: a sewing pattern, its seams and its fixation on the frame become the cover, live.</source>
        <translation>張り家具やカーシートをデザインする人のための作業環境。型紙、縫い目、フレームへの固定が、その場でカバーになります。</translation>
    </message>
    <message>
        <source>The surface is computed after the published method of sewing patterns on static constraints; docs/solver.md names the paper and what is different.</source>
        <translation>面は、静的拘束下の縫製パターンに関する公表された手法で計算しています。論文と相違点は docs/solver.md を参照してください。</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. It comes without any warranty. Built with Qt, Eigen, CGAL, SuiteSparse, Embree and OpenImageIO.</source>
        <translation>GNU General Public License バージョン 3 以降に基づくフリーソフトウェアです。いかなる保証もありません。Qt、Eigen、CGAL、SuiteSparse、Embree、OpenImageIO を使用しています。</translation>
    </message>
    <message>
        <source>About Bolster</source>
        <translation>Bolster について</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>型紙上</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>3D ビュー上</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>キーとマウス</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1&#xa0;ms</translation>
    </message>
    <message>
        <source>Patches, seams</source>
        <translation>パーツ、縫い目</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Vertices after sewing</source>
        <translation>縫製後の頂点</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Vertices held by fixations</source>
        <translation>固定された頂点</translation>
    </message>
    <message>
        <source>Sewn pairs</source>
        <translation>縫い合わせた組</translation>
    </message>
    <message>
        <source>Largest gap at seams</source>
        <translation>縫い目の最大すき間</translation>
    </message>
    <message>
        <source>Largest distance from fixations</source>
        <translation>固定からの最大距離</translation>
    </message>
    <message>
        <source>Curves to fixed outlines between vertices</source>
        <translation>曲線と固定輪郭の距離 (頂点間)</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1、%2、%3</translation>
    </message>
    <message>
        <source>Area of the cover, of the pattern</source>
        <translation>カバーの面積、型紙の面積</translation>
    </message>
    <message>
        <source>Turned triangles</source>
        <translation>反転した三角形</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>反復回数</translation>
    </message>
    <message>
        <source>Triangulation</source>
        <translation>三角形分割</translation>
    </message>
    <message>
        <source>Assembly and factorisation</source>
        <translation>組み立てと分解</translation>
    </message>
    <message>
        <source>One iteration</source>
        <translation>反復 1 回</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>メッシュ</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>面</translation>
    </message>
    <message>
        <source>Computation</source>
        <translation>計算</translation>
    </message>
    <message>
        <source>Figures of the surface</source>
        <translation>面の数値</translation>
    </message>
    <message>
        <source>Strain: root mean square, 99 %, largest</source>
        <translation>ひずみ: 二乗平均平方根、99&#xa0;%、最大</translation>
    </message>
    <message>
        <source>double click on an outline or curve</source>
        <translation>輪郭または曲線をダブルクリック</translation>
    </message>
    <message>
        <source>Draw a handle curve or a fancy seam</source>
        <translation>ハンドル曲線または飾り縫いを描く</translation>
    </message>
    <message>
        <source>click points; Enter or double click ends; click the first one to close; B: straight or smooth</source>
        <translation>点をクリック。Enter またはダブルクリックで終了、最初の点のクリックで閉じる、B: 直線/曲線</translation>
    </message>
    <message>
        <source>Move control points of curves</source>
        <translation>曲線の制御点を移動</translation>
    </message>
    <message>
        <source>Sew</source>
        <translation>縫う</translation>
    </message>
    <message>
        <source>click two edges; drag or Shift+click takes a part of one; Ctrl+click several in a row, Enter sews them; F: flip</source>
        <translation>2 つの辺をクリック。ドラッグまたは Shift+クリックで一部、Ctrl+クリックで連続した複数を選び Enter で縫う、F: 反転</translation>
    </message>
    <message>
        <source>Attach to the selected fixation curve</source>
        <translation>選択した固定曲線に固定</translation>
    </message>
    <message>
        <source>Draw an outline</source>
        <translation>輪郭を描く</translation>
    </message>
    <message>
        <source>click corners, drag smooth points, or type 500, 500&lt;30 or 120, 40; Enter or a click on the first point closes</source>
        <translation>角をクリック、滑らかな点はドラッグ、または 500、500&lt;30、120, 40 と入力。Enter か最初の点のクリックで閉じる</translation>
    </message>
    <message>
        <source>Not snapped</source>
        <translation>スナップしない</translation>
    </message>
    <message>
        <source>hold Ctrl or Alt</source>
        <translation>Ctrl または Alt を押し続ける</translation>
    </message>
    <message>
        <source>Select in a loop</source>
        <translation>投げ縄で選択</translation>
    </message>
    <message>
        <source>Alt and drag</source>
        <translation>Alt+ドラッグ</translation>
    </message>
    <message>
        <source>Next patch or control point, previous one</source>
        <translation>次または前のパーツ・制御点</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab、Shift+Tab</translation>
    </message>
    <message>
        <source>drag; those on a frame stay on it: Ctrl lifts them off, S lets go; X, Y, Z keep to an axis</source>
        <translation>ドラッグ。フレーム上の点はフレーム上を動く: Ctrl で離す、S で解除、X、Y、Z で軸に固定</translation>
    </message>
    <message>
        <source>Draw a fixation curve</source>
        <translation>固定曲線を描く</translation>
    </message>
    <message>
        <source>click points on a frame; Enter or double click ends; click the first one to close</source>
        <translation>フレーム上の点をクリック。Enter またはダブルクリックで終了、最初の点のクリックで閉じる</translation>
    </message>
    <message>
        <source>Move the ends of a seam or fixation</source>
        <translation>縫い目や固定の端を移動</translation>
    </message>
    <message>
        <source>select it and drag the round handles at its ends</source>
        <translation>選択して、端の丸いハンドルをドラッグ</translation>
    </message>
    <message>
        <source>Stitch or pipe a seam or an edge</source>
        <translation>縫い目や辺にステッチまたはパイピングを付ける</translation>
    </message>
    <message>
        <source>click it; stitches and piping are in the properties</source>
        <translation>クリック。ステッチとパイピングはプロパティにあります</translation>
    </message>
    <message>
        <source>Select an edge</source>
        <translation>辺を選択</translation>
    </message>
    <message>
        <source>click the outline; drag it then to move it; L types its length</source>
        <translation>輪郭をクリック。続けてドラッグで移動、L で長さを入力</translation>
    </message>
    <message>
        <source>Commands for what lies there</source>
        <translation>その場所のコマンド</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>右ボタン</translation>
    </message>
    <message>
        <source>A number instead of a drag</source>
        <translation>ドラッグの代わりに数値を入力</translation>
    </message>
    <message>
        <source>type it while dragging: 50, 30, 20, for sizes 300 x 200 or 120 %; Enter lets go</source>
        <translation>ドラッグ中に入力: 50 または 30, 20、サイズは 300 x 200 や 120&#xa0;%。Enter で離す</translation>
    </message>
    <message>
        <source>click edges; Shift+click collects several; Esc ends</source>
        <translation>辺をクリック。Shift+クリックで複数を集める、Esc で終了</translation>
    </message>
    <message>
        <source>right button, without a drag</source>
        <translation>右ボタン (ドラッグなし)</translation>
    </message>
    <message>
        <source>Move by %1, by %2</source>
        <translation>%1、%2 移動</translation>
    </message>
    <message>
        <source>%1, or Space and drag</source>
        <translation>%1、または Space を押しながらドラッグ</translation>
    </message>
    <message>
        <source>%1, or drag beside the cover</source>
        <translation>%1、またはカバーの外をドラッグ</translation>
    </message>
</context>
<context>
    <name>Insert</name>
    <message>
        <source>Padding</source>
        <translation>詰め物</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>フォーム</translation>
    </message>
    <message>
        <source>This frame is large: its smallest detail is set to %1; the usual %2 would need too much memory.</source>
        <translation>このフレームは大きいため、最小ディテールを %1 にしました。通常の %2 ではメモリが足りません。</translation>
    </message>
</context>
<context>
    <name>InsertCommands</name>
    <message>
        <source>&amp;Cushion</source>
        <translation>クッション(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Box of foam</source>
        <translation>直方体フォーム(&amp;B)</translation>
    </message>
    <message>
        <source>C&amp;ylinder of foam</source>
        <translation>円柱フォーム(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Sphere of foam</source>
        <translation>球フォーム(&amp;S)</translation>
    </message>
    <message>
        <source>Foam belongs to a cushion: insert one first.</source>
        <translation>フォームはクッションに属します。先にクッションを挿入してください。</translation>
    </message>
    <message>
        <source>Cushioning needs a frame: import one first.</source>
        <translation>クッションにはフレームが必要です。先にインポートしてください。</translation>
    </message>
</context>
<context>
    <name>InspectorForms</name>
    <message numerus="yes">
        <source>%n elements</source>
        <translation>
            <numerusform>要素 %n 個</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>InternalLineForm</name>
    <message>
        <source>Patch</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
</context>
<context>
    <name>InverseCommands</name>
    <message>
        <source>From a form …</source>
        <translation>形状から…</translation>
    </message>
    <message>
        <source>Cuts a frame, a mesh or the cover into pieces, lays them flat and makes the pattern of them</source>
        <translation>フレーム、メッシュまたはカバーを分割して平らに展開し、型紙にします</translation>
    </message>
    <message>
        <source>F&amp;it to a goal …</source>
        <translation>目標に合わせる(&amp;I)…</translation>
    </message>
    <message>
        <source>Changes the pattern until the cover lies on a scan, or is strained less</source>
        <translation>カバーがスキャンに沿うように、またはひずみが減るように型紙を変えます</translation>
    </message>
    <message>
        <source>Relieve strain …</source>
        <translation>ひずみを緩和…</translation>
    </message>
    <message>
        <source>Proposes changes of the pattern where cloth is strained too much, with what each gains</source>
        <translation>生地のひずみが大きすぎる所の型紙の変更と、それぞれの効果を提案します</translation>
    </message>
    <message>
        <source>Why is it so? …</source>
        <translation>原因は?…</translation>
    </message>
    <message>
        <source>Which cause explains best how far the scan of a built piece lies from the cover</source>
        <translation>実物のスキャンとカバーの差を最もよく説明する原因を調べます</translation>
    </message>
    <message>
        <source>Tolerances …</source>
        <translation>公差…</translation>
    </message>
    <message>
        <source>Where the cover varies from piece to piece, and which tolerance of making matters</source>
        <translation>カバーの個体差が出る所と、影響の大きい製作公差を調べます</translation>
    </message>
</context>
<context>
    <name>KeptMeasure</name>
    <message>
        <source>Measurement %1</source>
        <translation>測定 %1</translation>
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
        <translation>ラベルを読みやすい場所へドラッグ。Shift で 1 軸に固定、Ctrl でスナップしない、Esc で取り消す</translation>
    </message>
</context>
<context>
    <name>LayerCommands</name>
    <message>
        <source>La&amp;yers</source>
        <translation>レイヤー(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Triangulation</source>
        <translation>三角形分割(&amp;T)</translation>
    </message>
    <message>
        <source>Chec&amp;ker</source>
        <translation>市松模様(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>フレーム(&amp;F)</translation>
    </message>
    <message>
        <source>Control po&amp;ints</source>
        <translation>制御点(&amp;I)</translation>
    </message>
    <message>
        <source>Sea&amp;ms and fixations</source>
        <translation>縫い目と固定(&amp;M)</translation>
    </message>
    <message>
        <source>Fixation c&amp;urves</source>
        <translation>固定曲線(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Handle curves</source>
        <translation>ハンドル曲線(&amp;H)</translation>
    </message>
    <message>
        <source>Fanc&amp;y seams</source>
        <translation>飾り縫い(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>ラベル(&amp;L)</translation>
    </message>
    <message>
        <source>Sca&amp;ns</source>
        <translation>スキャン(&amp;N)</translation>
    </message>
    <message>
        <source>Gr&amp;ound</source>
        <translation>床(&amp;O)</translation>
    </message>
    <message>
        <source>Cushionin&amp;g</source>
        <translation>クッション(&amp;G)</translation>
    </message>
    <message>
        <source>Mirror image of the &amp;selection</source>
        <translation>選択の鏡像(&amp;S)</translation>
    </message>
    <message>
        <source>Symmetry &amp;axis and plane</source>
        <translation>対称軸と対称面(&amp;A)</translation>
    </message>
    <message>
        <source>Pairs of co&amp;ver and scan</source>
        <translation>カバーとスキャンの対応点(&amp;V)</translation>
    </message>
    <message>
        <source>Own &amp;colours of scans</source>
        <translation>スキャン自体の色(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>グリッド(&amp;G)</translation>
    </message>
    <message>
        <source>Cut lines, notches and la&amp;bels</source>
        <translation>裁断線、ノッチ、ラベル(&amp;B)</translation>
    </message>
    <message>
        <source>M&amp;easurements</source>
        <translation>測定(&amp;E)</translation>
    </message>
</context>
<context>
    <name>MainMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Pattern</source>
        <translation>型紙(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>面(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>ウィンドウ(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>挿入(&amp;I)</translation>
    </message>
    <message>
        <source>Sea&amp;m</source>
        <translation>縫い目(&amp;M)</translation>
    </message>
    <message>
        <source>F&amp;rame</source>
        <translation>フレーム(&amp;R)</translation>
    </message>
    <message>
        <source>F&amp;abric</source>
        <translation>生地(&amp;A)</translation>
    </message>
    <message>
        <source>S&amp;can</source>
        <translation>スキャン(&amp;C)</translation>
    </message>
</context>
<context>
    <name>ManualCommands</name>
    <message>
        <source>&amp;Manual</source>
        <translation>マニュアル(&amp;M)</translation>
    </message>
    <message>
        <source>The page about what you are at</source>
        <translation>今の操作についてのページ</translation>
    </message>
    <message>
        <source>The manual is not installed.</source>
        <translation>マニュアルがインストールされていません。</translation>
    </message>
    <message>
        <source>It is a folder &quot;manual&quot; with the program&apos;s other files.</source>
        <translation>プログラムの他のファイルと同じ場所にある「manual」フォルダーです。</translation>
    </message>
</context>
<context>
    <name>MapCommands</name>
    <message>
        <source>&amp;Map</source>
        <translation>マップ(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Largest strain</source>
        <translation>最大ひずみ(&amp;L)</translation>
    </message>
    <message>
        <source>Strain al&amp;ong the grain</source>
        <translation>地の目方向のひずみ(&amp;O)</translation>
    </message>
    <message>
        <source>Strain a&amp;cross the grain</source>
        <translation>直交方向のひずみ(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Shear</source>
        <translation>せん断(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Mean curvature</source>
        <translation>平均曲率(&amp;M)</translation>
    </message>
    <message>
        <source>Distance to the &amp;frame</source>
        <translation>フレームまでの距離(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Deviation from the scan</source>
        <translation>スキャンとの偏差(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Worst spots</source>
        <translation>要注意箇所(&amp;W)</translation>
    </message>
    <message>
        <source>Show worst spots as a l&amp;ist</source>
        <translation>要注意箇所を一覧表示(&amp;I)</translation>
    </message>
    <message>
        <source>Show this place in both windows</source>
        <translation>この場所を両方のウィンドウに表示</translation>
    </message>
    <message>
        <source>Choose a map of strain first</source>
        <translation>先にひずみのマップを選んでください</translation>
    </message>
</context>
<context>
    <name>MarkDrag</name>
    <message>
        <source>Drag it to where it belongs – Esc takes it back</source>
        <translation>所定の位置へドラッグ。Esc で取り消す</translation>
    </message>
    <message>
        <source>Allowance of %1 – or type it; Ctrl for any width, Esc takes it back</source>
        <translation>縫い代 %1。数値入力も可。Ctrl で任意の幅、Esc で取り消す</translation>
    </message>
    <message>
        <source>Drag it to where it belongs, or type its place: 120, 40 – Esc takes it back</source>
        <translation>所定の位置へドラッグするか、位置を入力: 120, 40。Esc で取り消す</translation>
    </message>
    <message>
        <source>Drag it along the outline, or type how far it is from the corner – Esc takes it back</source>
        <translation>輪郭に沿ってドラッグするか、角からの距離を入力。Esc で取り消す</translation>
    </message>
</context>
<context>
    <name>MeasureTool</name>
    <message>
        <source>dx %1, dy %2</source>
        <translation>dx %1、dy %2</translation>
    </message>
    <message>
        <source>This edge is %1 long – click for a point to measure from</source>
        <translation>この辺の長さは %1。クリックで測定の始点を指定</translation>
    </message>
    <message>
        <source>Edge: %1</source>
        <translation>辺: %1</translation>
    </message>
    <message>
        <source>Only a measurement between two points of patches can be kept.</source>
        <translation>残せるのはパーツの 2 点間の測定だけです。</translation>
    </message>
    <message>
        <source>&amp;Keep the measurement</source>
        <translation>測定を残す(&amp;K)</translation>
    </message>
    <message>
        <source>%1 – Enter keeps the measurement, a click begins anew</source>
        <translation>%1。Enter で測定を残す、クリックで測り直し</translation>
    </message>
    <message>
        <source>Click two points of the pattern or of the cover to measure, or point at an outline – Esc ends the tool</source>
        <translation>型紙またはカバーの 2 点をクリックして測定するか、輪郭をポイント。Esc でツールを終了</translation>
    </message>
    <message>
        <source>%1 – a click begins anew</source>
        <translation>%1。クリックで測り直し</translation>
    </message>
</context>
<context>
    <name>MeasurementForm</name>
    <message>
        <source>From</source>
        <translation>始点</translation>
    </message>
    <message>
        <source>To</source>
        <translation>終点</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>型紙上</translation>
    </message>
    <message>
        <source>two patches</source>
        <translation>2 つのパーツ</translation>
    </message>
    <message>
        <source>On the cover</source>
        <translation>カバー上</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>未測定</translation>
    </message>
</context>
<context>
    <name>Message</name>
    <message>
        <source>the degree must be 1, 2 or 3, not %1</source>
        <translation>次数は %1 ではなく 1、2、3 のいずれかでなければなりません</translation>
    </message>
    <message>
        <source>a closed curve needs at least %1 points, not %2</source>
        <translation>閉じた曲線には少なくとも %1 点が必要ですが、%2 点しかありません</translation>
    </message>
    <message>
        <source>an open curve of this degree needs at least %1 points, not %2</source>
        <translation>この次数の開いた曲線には少なくとも %1 点が必要ですが、%2 点しかありません</translation>
    </message>
    <message>
        <source>point %1 is no number or beyond 1e7 mm</source>
        <translation>点 %1 は数値でないか、1e7&#xa0;mm を超えています</translation>
    </message>
    <message>
        <source>corners belong to closed curves of degree 3 only</source>
        <translation>角は次数 3 の閉じた曲線にしかありません</translation>
    </message>
    <message>
        <source>the list of corners is empty; leave it out</source>
        <translation>角のリストが空です。省いてください</translation>
    </message>
    <message>
        <source>corner %1 does not exist; the points are numbered 0 to %2</source>
        <translation>角 %1 は存在しません。点の番号は 0 から %2 までです</translation>
    </message>
    <message>
        <source>the corners must increase, but %1 follows %2</source>
        <translation>角は昇順でなければなりませんが、%2 の後に %1 があります</translation>
    </message>
    <message>
        <source>there must be at least two points between the corners %1 and %2 (a straight edge: at its thirds)</source>
        <translation>角 %1 と %2 の間には少なくとも 2 点が必要です (直線の辺ではその三等分点)</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text goes on after the design&apos;s last bracket; remove what follows</source>
        <translation>%1 行 %2 列: デザインの最後の括弧の後にテキストが続いています。続きを削除してください</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text ends in the middle of the design; the file is incomplete</source>
        <translation>%1 行 %2 列: テキストがデザインの途中で終わっています。ファイルが不完全です</translation>
    </message>
    <message>
        <source>Line %1, column %2: brackets are nested more than 64 deep; no design needs that</source>
        <translation>%1 行 %2 列: 括弧の入れ子が 64 段を超えています。デザインには不要な深さです</translation>
    </message>
    <message>
        <source>Line %1, column %2: a value is expected here: a number, a text in quotes, true, false or a bracket (NaN and Infinity are no numbers)</source>
        <translation>%1 行 %2 列: ここには値が必要です: 数値、引用符付きテキスト、true、false、括弧のいずれか (NaN と Infinity は数値ではありません)</translation>
    </message>
    <message>
        <source>Line %1, column %2: a comma or &quot;]&quot; is missing here</source>
        <translation>%1 行 %2 列: コンマまたは「]」がありません</translation>
    </message>
    <message>
        <source>Line %1, column %2: a key in quotes is expected here</source>
        <translation>%1 行 %2 列: ここには引用符付きのキーが必要です</translation>
    </message>
    <message>
        <source>Line %1, column %2: a colon is missing after the key</source>
        <translation>%1 行 %2 列: キーの後にコロンがありません</translation>
    </message>
    <message>
        <source>Line %1, column %2: a comma or &quot;}&quot; is missing here</source>
        <translation>%1 行 %2 列: コンマまたは「}」がありません</translation>
    </message>
    <message>
        <source>Line %1, column %2: a text in quotes must end on its line; a quote is missing</source>
        <translation>%1 行 %2 列: 引用符付きテキストは同じ行で終わらなければなりません。引用符が足りません</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is no valid escape; write a backslash as &quot;\\&quot;</source>
        <translation>%1 行 %2 列: 無効なエスケープです。バックスラッシュは「\\」と書いてください</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is not UTF-8; save the file in that encoding</source>
        <translation>%1 行 %2 列: UTF-8 ではありません。UTF-8 で保存してください</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text ends inside quotes; the file is incomplete</source>
        <translation>%1 行 %2 列: テキストが引用符の中で終わっています。ファイルが不完全です</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is no number; write it like 12.5, -3 or 1e-3</source>
        <translation>%1 行 %2 列: 数値ではありません。12.5、-3、1e-3 のように書いてください</translation>
    </message>
    <message>
        <source>the text is larger than %1 MB; that is no design</source>
        <translation>テキストが %1&#xa0;MB を超えており、デザインではありません</translation>
    </message>
    <message>
        <source>knot %1 occurs more often than %2 times, the degree; remove the surplus ones</source>
        <translation>ノット %1 が次数の %2 回より多くあります。余分を削除してください</translation>
    </message>
    <message>
        <source>the knots of an open curve must begin with %1 equal ones and end with %1 equal, larger ones</source>
        <translation>開いた曲線のノットは、%1 個の等しい値で始まり、それより大きい %1 個の等しい値で終わらなければなりません</translation>
    </message>
    <message>
        <source>%1 points of degree %2 need %3 knots, not %4</source>
        <translation>次数 %2 の %1 点には、%4 個ではなく %3 個のノットが必要です</translation>
    </message>
    <message>
        <source>a knot is no number or beyond 1e7</source>
        <translation>ノットが数値でないか、1e7 を超えています</translation>
    </message>
    <message>
        <source>the knots must not decrease</source>
        <translation>ノットは減少してはなりません</translation>
    </message>
    <message>
        <source>the last knot must be larger than the first</source>
        <translation>最後のノットは最初より大きくなければなりません</translation>
    </message>
    <message>
        <source>two knots near %1 are almost equal; make them equal</source>
        <translation>%1 付近の 2 つのノットがほぼ同じです。等しくしてください</translation>
    </message>
    <message>
        <source>there is not enough memory for this design</source>
        <translation>このデザインにはメモリが足りません</translation>
    </message>
    <message>
        <source>%1: the file promises more than it holds</source>
        <translation>%1: ファイルの内容が記載より少なくなっています</translation>
    </message>
    <message>
        <source>%1: the mesh is too large, the limit is %2 points and as many triangles</source>
        <translation>%1: メッシュが大きすぎます。上限は %2 点、三角形も同数です</translation>
    </message>
    <message>
        <source>%1: the point is not finite, or beyond 10,000,000</source>
        <translation>%1: 点が有限でないか、10,000,000 を超えています</translation>
    </message>
    <message>
        <source>%1: a face refers to point %2, but there are %3 points</source>
        <translation>%1: 面が点 %2 を参照していますが、点は %3 個です</translation>
    </message>
    <message>
        <source>%1: the mesh has too many groups, the limit is %2</source>
        <translation>%1: メッシュのグループが多すぎます。上限は %2 です</translation>
    </message>
    <message>
        <source>%1 holds no mesh</source>
        <translation>%1 にメッシュはありません</translation>
    </message>
    <message>
        <source>%1 holds points only; a frame needs faces between them</source>
        <translation>%1 には点しかありません。フレームには点の間の面が必要です</translation>
    </message>
    <message>
        <source>%1: points are counted from 1, not from 0</source>
        <translation>%1: 点の番号は 0 ではなく 1 から始まります</translation>
    </message>
    <message>
        <source>%1: the file ends too early</source>
        <translation>%1: ファイルが途中で終わっています</translation>
    </message>
    <message>
        <source>%1: the file does not begin with OFF</source>
        <translation>%1: ファイルが OFF で始まっていません</translation>
    </message>
    <message>
        <source>%1: binary OFF is not read; save it as text</source>
        <translation>%1: バイナリ OFF は読み込めません。テキストで保存してください</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PLY number type</source>
        <translation>%1: 「%2」は PLY の数値型ではありません</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PLY format</source>
        <translation>%1: 「%2」は PLY の形式ではありません</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; cannot count a list</source>
        <translation>%1: 「%2」はリストの個数に使えません</translation>
    </message>
    <message>
        <source>%1: the file does not begin with &quot;ply&quot;</source>
        <translation>%1: ファイルが「ply」で始まっていません</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not expected in a PLY header</source>
        <translation>%1: 「%2」は PLY ヘッダーでは想定外です</translation>
    </message>
    <message>
        <source>%1: a count is negative</source>
        <translation>%1: 個数が負です</translation>
    </message>
    <message>
        <source>%1: the points have no coordinate &quot;%2&quot;</source>
        <translation>%1: 点に座標「%2」がありません</translation>
    </message>
    <message>
        <source>%1: the faces have no list &quot;%2&quot;</source>
        <translation>%1: 面にリスト「%2」がありません</translation>
    </message>
    <message>
        <source>%1: a number is missing</source>
        <translation>%1: 数値がありません</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a number</source>
        <translation>%1: 「%2」は数値ではありません</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a whole number</source>
        <translation>%1: 「%2」は整数ではありません</translation>
    </message>
    <message>
        <source>unsaved work cannot be protected: &quot;%1&quot; cannot be written</source>
        <translation>未保存の作業を保護できません。「%1」に書き込めません</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot;</source>
        <translation>ファイル「%1」がありません</translation>
    </message>
    <message>
        <source>you are not allowed to read &quot;%1&quot;</source>
        <translation>「%1」を読み取る権限がありません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a folder, not a file</source>
        <translation>「%1」はファイルではなくフォルダーです</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an ordinary file</source>
        <translation>「%1」は通常のファイルではありません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read (%2)</source>
        <translation>「%1」を読み込めません (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: the disk is full; make room or choose another folder</source>
        <translation>「%1」に書き込めません: ディスクがいっぱいです。空きを作るか、別のフォルダーを選んでください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: you are not allowed to write into &quot;%2&quot;; choose another folder</source>
        <translation>「%1」に書き込めません: 「%2」への書き込み権限がありません。別のフォルダーを選んでください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: there is no folder &quot;%2&quot;</source>
        <translation>「%1」に書き込めません: フォルダー「%2」がありません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is a folder</source>
        <translation>「%1」に書き込めません: フォルダーです</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written (%2)</source>
        <translation>「%1」に書き込めません (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too large: %2 MB, and at most %3 MB are read</source>
        <translation>「%1」は大きすぎます: %2&#xa0;MB。読み込めるのは %3&#xa0;MB までです</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is write-protected</source>
        <translation>「%1」に書き込めません: 書き込み禁止です</translation>
    </message>
    <message>
        <source>The equations of the cover could not be solved: a patch is degenerate or its numbers are too large.</source>
        <translation>カバーの方程式を解けませんでした。パーツが退化しているか、数値が大きすぎます。</translation>
    </message>
    <message>
        <source>this seam and its neighbours carry their ends round in a circle without ever meeting. Let the seams of this circle end at common points.</source>
        <translation>この縫い目と隣の縫い目の端が輪のように送られ、出会いません。この輪の縫い目を共通の点で終わらせてください。</translation>
    </message>
    <message>
        <source>the corners of the two stretches lie too close together to be matched. Move them apart or choose a smaller edge length.</source>
        <translation>2 つの区間の角が近すぎて対応付けできません。離すか、エッジ長を小さくしてください。</translation>
    </message>
    <message>
        <source>%1 and %2 hold the same point of the cover in two places, %3 mm apart. Let both curves meet there, or end one stretch earlier.</source>
        <translation>%1 と %2 がカバーの同じ点を %3&#xa0;mm 離れた 2 か所で保持しています。そこで両方の曲線を合わせるか、一方の区間を手前で終わらせてください。</translation>
    </message>
    <message>
        <source>the patch is too narrow somewhere for edges of %1 mm. Choose a smaller edge length.</source>
        <translation>パーツに、%1&#xa0;mm のエッジには狭すぎる所があります。エッジ長を小さくしてください。</translation>
    </message>
    <message>
        <source>The design cannot be solved: %2</source>
        <translation>デザインを計算できません: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>There is no patch to solve. Add a patch to the pattern.</source>
        <translation>計算するパーツがありません。型紙にパーツを追加してください。</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by an estimated %2 mm. Allow more iterations.</source>
        <translation>%1 回の反復後も、面がまだ推定 %2&#xa0;mm 動いています。反復回数を増やしてください。</translation>
    </message>
    <message>
        <source>Remove %1 points</source>
        <translation>%1 個の点を削除</translation>
    </message>
    <message>
        <source>Move %1 points</source>
        <translation>%1 個の点を移動</translation>
    </message>
    <message>
        <source>another element has the number %1 already; give this one a number of its own</source>
        <translation>番号 %1 は別の要素がすでに使っています。この要素に固有の番号を付けてください</translation>
    </message>
    <message>
        <source>this is no Bolster design; it must say &quot;format&quot;: &quot;bolster-design&quot;</source>
        <translation>Bolster のデザインではありません。&quot;format&quot;: &quot;bolster-design&quot; の記載が必要です</translation>
    </message>
    <message>
        <source>the design was made by a newer Bolster (version %1 of the format, this program knows %2); update the program</source>
        <translation>このデザインは新しい Bolster で作られています (形式バージョン %1、このプログラムは %2 まで)。プログラムを更新してください</translation>
    </message>
    <message>
        <source>must be %1</source>
        <translation>%1 でなければなりません</translation>
    </message>
    <message>
        <source>must be &quot;mm&quot;; convert the design to millimetres</source>
        <translation>&quot;mm&quot; でなければなりません。デザインをミリメートルに変換してください</translation>
    </message>
    <message>
        <source>must be a list of elements in square brackets</source>
        <translation>角括弧で囲んだ要素のリストでなければなりません</translation>
    </message>
    <message>
        <source>must be a list of points in square brackets</source>
        <translation>角括弧で囲んだ点のリストでなければなりません</translation>
    </message>
    <message>
        <source>must be a list of numbers in square brackets</source>
        <translation>角括弧で囲んだ数値のリストでなければなりません</translation>
    </message>
    <message>
        <source>the list is empty; leave it out</source>
        <translation>リストが空です。省いてください</translation>
    </message>
    <message>
        <source>must be a curve in braces, with degree, closed and points</source>
        <translation>degree、closed、points をもつ、波括弧で囲んだ曲線でなければなりません</translation>
    </message>
    <message>
        <source>a curve has either corners or knots; remove one of them</source>
        <translation>曲線がもてるのは corners か knots の一方です。どちらかを削除してください</translation>
    </message>
    <message>
        <source>an outline must be closed; write true</source>
        <translation>輪郭は閉じていなければなりません。true と書いてください</translation>
    </message>
    <message>
        <source>must be a stretch in braces, with patch, from and to</source>
        <translation>patch、from、to をもつ、波括弧で囲んだ区間でなければなりません</translation>
    </message>
    <message>
        <source>must be a quaternion [w, x, y, z] of length 1, not of length %1</source>
        <translation>長さ %1 ではなく、長さ 1 の四元数 [w, x, y, z] でなければなりません</translation>
    </message>
    <message>
        <source>must be an object in braces</source>
        <translation>波括弧で囲んだオブジェクトでなければなりません</translation>
    </message>
    <message>
        <source>an element must be an object in braces</source>
        <translation>要素は波括弧で囲んだオブジェクトでなければなりません</translation>
    </message>
    <message>
        <source>must be true or false, without quotes</source>
        <translation>引用符なしの true または false でなければなりません</translation>
    </message>
    <message>
        <source>must be a text in quotes</source>
        <translation>引用符付きテキストでなければなりません</translation>
    </message>
    <message>
        <source>and %1 more problems of this element</source>
        <translation>この要素には他に %1 件の問題があります</translation>
    </message>
    <message>
        <source>must be a number, without quotes</source>
        <translation>引用符なしの数値でなければなりません</translation>
    </message>
    <message>
        <source>must be a whole number from %1 to %2</source>
        <translation>%1 から %2 までの整数でなければなりません</translation>
    </message>
    <message>
        <source>must be a list of %1 numbers in square brackets</source>
        <translation>角括弧で囲んだ %1 個の数値のリストでなければなりません</translation>
    </message>
    <message>
        <source>this key occurs twice; remove one of them</source>
        <translation>このキーが 2 回あります。一方を削除してください</translation>
    </message>
    <message>
        <source>this key is missing; add it</source>
        <translation>このキーがありません。追加してください</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>%1 のいずれかでなければなりません</translation>
    </message>
    <message>
        <source>this key is unknown; check its spelling or remove it</source>
        <translation>不明なキーです。綴りを確認するか削除してください</translation>
    </message>
    <message>
        <source>Move a point of %1</source>
        <translation>%1 の点を移動</translation>
    </message>
    <message>
        <source>Move %2 points of %1</source>
        <translation>%1 の点 %2 個を移動</translation>
    </message>
    <message>
        <source>Insert a point into %1</source>
        <translation>%1 に点を挿入</translation>
    </message>
    <message>
        <source>Remove a point of %1</source>
        <translation>%1 の点を削除</translation>
    </message>
    <message>
        <source>Change the settings</source>
        <translation>設定を変更</translation>
    </message>
    <message>
        <source>Add fabric %1</source>
        <translation>生地 %1 を追加</translation>
    </message>
    <message>
        <source>Add patch %1</source>
        <translation>パーツ %1 を追加</translation>
    </message>
    <message>
        <source>Add a seam</source>
        <translation>縫い目を追加</translation>
    </message>
    <message>
        <source>Add fixation curve %1</source>
        <translation>固定曲線 %1 を追加</translation>
    </message>
    <message>
        <source>Add a fixation seam</source>
        <translation>固定を追加</translation>
    </message>
    <message>
        <source>Add frame %1</source>
        <translation>フレーム %1 を追加</translation>
    </message>
    <message>
        <source>Add an unreadable element</source>
        <translation>読み取れない要素を追加</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>%1 の名前を %2 に変更</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 を削除</translation>
    </message>
    <message>
        <source>Remove %1 elements</source>
        <translation>%1 個の要素を削除</translation>
    </message>
    <message>
        <source>Move %1 patches</source>
        <translation>%1 個のパーツを移動</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 を移動</translation>
    </message>
    <message>
        <source>Turn %1 patches</source>
        <translation>%1 個のパーツを回転</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>%1 を回転</translation>
    </message>
    <message>
        <source>There is not enough memory for this surface. Choose a larger edge length.</source>
        <translation>この面にはメモリが足りません。エッジ長を大きくしてください。</translation>
    </message>
    <message>
        <source>The solver failed: %1. The last good surface is kept.</source>
        <translation>計算に失敗しました: %1。最後の正常な面を保持します。</translation>
    </message>
    <message>
        <source>Change the colour of %1</source>
        <translation>%1 の色を変更</translation>
    </message>
    <message>
        <source>Change the stiffness of %1</source>
        <translation>%1 の剛性を変更</translation>
    </message>
    <message>
        <source>Change the Poisson parameter of %1</source>
        <translation>%1 のポアソン比を変更</translation>
    </message>
    <message>
        <source>Change the bending length of %1</source>
        <translation>%1 の曲げ長さを変更</translation>
    </message>
    <message>
        <source>Change the fabric of %1</source>
        <translation>%1 の生地を変更</translation>
    </message>
    <message>
        <source>Change the grain of %1</source>
        <translation>%1 の地の目を変更</translation>
    </message>
    <message>
        <source>Change the pressure of %1</source>
        <translation>%1 の圧力を変更</translation>
    </message>
    <message>
        <source>Change the right side of %1</source>
        <translation>%1 の表側を変更</translation>
    </message>
    <message>
        <source>Move %1 in the layout</source>
        <translation>%1 をレイアウト上で移動</translation>
    </message>
    <message>
        <source>Turn %1 in the layout</source>
        <translation>%1 をレイアウト上で回転</translation>
    </message>
    <message>
        <source>Change the continuity of %1</source>
        <translation>%1 の連続性を変更</translation>
    </message>
    <message>
        <source>Change how %1 is matched</source>
        <translation>%1 の対応付けを変更</translation>
    </message>
    <message>
        <source>Reverse %1</source>
        <translation>%1 を逆向きにする</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>%1 を拡大縮小</translation>
    </message>
    <message>
        <source>The surface still moves after %1 iterations.</source>
        <translation>%1 回の反復後も面がまだ動いています。</translation>
    </message>
    <message>
        <source>this is no name of a file</source>
        <translation>ファイル名ではありません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be relative to the design&apos;s folder and use &quot;/&quot; between folders</source>
        <translation>「%1」はデザインのフォルダーからの相対パスとし、フォルダーの区切りに「/」を使ってください</translation>
    </message>
    <message>
        <source>left out because of its errors</source>
        <translation>エラーのため除外されました</translation>
    </message>
    <message>
        <source>left out because it needs %1, which is not there</source>
        <translation>必要な %1 がないため除外されました</translation>
    </message>
    <message>
        <source>an edge length of %1 mm is used instead</source>
        <translation>代わりにエッジ長 %1&#xa0;mm を使います</translation>
    </message>
    <message>
        <source>the file is not a design</source>
        <translation>ファイルがデザインではありません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written</source>
        <translation>「%1」に書き込めません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be copied to &quot;%2&quot;: %3</source>
        <translation>「%1」を「%2」にコピーできませんでした: %3</translation>
    </message>
    <message>
        <source>the folder &quot;%1&quot; could not be made</source>
        <translation>フォルダー「%1」を作成できませんでした</translation>
    </message>
    <message>
        <source>the patch is free in space: nothing fixes it to the frame; add a fixation</source>
        <translation>パーツが空間に浮いています。フレームに固定するものがありません。固定を追加してください</translation>
    </message>
    <message>
        <source>this patch and the %1 sewn to it are free in space: nothing fixes them to the frame; add a fixation</source>
        <translation>このパーツと、縫い付けられた %1 個が空間に浮いています。フレームに固定するものがありません。固定を追加してください</translation>
    </message>
    <message>
        <source>is %1, but must lie between %2 and %3</source>
        <translation>値は %1 ですが、%2 から %3 の間でなければなりません</translation>
    </message>
    <message>
        <source>there is no element %1; name a %2</source>
        <translation>要素 %1 がありません。%2 を指定してください</translation>
    </message>
    <message>
        <source>element %1 cannot be read; repair it or name another %2</source>
        <translation>要素 %1 を読み取れません。修復するか、別の %2 を指定してください</translation>
    </message>
    <message>
        <source>%1 is no %2; name another element</source>
        <translation>%1 は %2 ではありません。別の要素を指定してください</translation>
    </message>
    <message>
        <source>%1 mm would make more than 5 million triangles; take at least %2 mm for these patches</source>
        <translation>%1&#xa0;mm では三角形が 500 万を超えます。これらのパーツには少なくとも %2&#xa0;mm を指定してください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no colour; write it like #7a4a2b</source>
        <translation>「%1」は色ではありません。#7a4a2b のように書いてください</translation>
    </message>
    <message>
        <source>the mesh cannot resolve folds as small as a bending length of %1 mm makes them: with edges of %2 mm it acts like %3 mm; take an edge length of at most %4 mm, or a longer bending length</source>
        <translation>曲げ長さ %1&#xa0;mm でできる細かいしわは、このメッシュでは表せません。%2&#xa0;mm のエッジでは %3&#xa0;mm 相当になります。エッジ長を %4&#xa0;mm 以下にするか、曲げ長さを大きくしてください</translation>
    </message>
    <message>
        <source>an outline must be a closed curve</source>
        <translation>輪郭は閉じた曲線でなければなりません</translation>
    </message>
    <message>
        <source>the outline needs at least three points in different places</source>
        <translation>輪郭には、異なる位置に少なくとも 3 点が必要です</translation>
    </message>
    <message>
        <source>all points of the outline lie on one line, it encloses no area; move one of them</source>
        <translation>輪郭の点がすべて一直線上にあり、面積がありません。どれかを移動してください</translation>
    </message>
    <message>
        <source>the outline crosses or touches itself near %1; move its points apart there</source>
        <translation>輪郭が %1 付近で交差または接触しています。そこの点を離してください</translation>
    </message>
    <message>
        <source>the outline encloses no area</source>
        <translation>輪郭に面積がありません</translation>
    </message>
    <message>
        <source>%1 is the end of the curve; write %2, its start</source>
        <translation>%1 は曲線の終点です。始点の %2 と書いてください</translation>
    </message>
    <message>
        <source>is %1, but must be larger than the start of the stretch, %2</source>
        <translation>値は %1 ですが、区間の始点 %2 より大きくなければなりません</translation>
    </message>
    <message>
        <source>the stretch from %1 to %2 is empty or longer than the curve</source>
        <translation>%1 から %2 までの区間が空か、曲線より長くなっています</translation>
    </message>
    <message>
        <source>the stretch from %1 to %2 has no length; the outline&apos;s points coincide there</source>
        <translation>%1 から %2 までの区間に長さがありません。輪郭の点が重なっています</translation>
    </message>
    <message>
        <source>the seam would sew a stretch of &quot;%1&quot; to itself: %2 to %3 and %4 to %5 overlap; choose two separate stretches</source>
        <translation>この縫い目は「%1」の区間を自身に縫い付けます。%2 から %3 と %4 から %5 が重なっています。離れた 2 つの区間を選んでください</translation>
    </message>
    <message>
        <source>the seam joins the right side of &quot;%1&quot; to the wrong side of &quot;%2&quot;; turn &quot;reversed&quot; round, or one patch wrong side out</source>
        <translation>この縫い目は「%1」の表と「%2」の裏を縫い合わせます。「reversed」を逆にするか、一方のパーツを裏返してください</translation>
    </message>
    <message>
        <source>the sides of the seam are %1 mm (&quot;%2&quot;) and %3 mm (&quot;%4&quot;) long: %5 % ease, more than 5 % puckers; make them equal or check the ends of the stretches</source>
        <translation>縫い目の両側の長さが %1&#xa0;mm (「%2」) と %3&#xa0;mm (「%4」) です。いせ %5&#xa0;%。5&#xa0;% を超えるとしわになります。長さを揃えるか、区間の端を確認してください</translation>
    </message>
    <message>
        <source>the curve has no length; move its points apart</source>
        <translation>曲線に長さがありません。点を離してください</translation>
    </message>
    <message>
        <source>the curve from %1 to %2 has no length</source>
        <translation>%1 から %2 までの曲線に長さがありません</translation>
    </message>
    <message>
        <source>is %1, but must be positive: millimetres per unit of the file</source>
        <translation>値は %1 ですが、正でなければなりません (ファイルの 1 単位あたりの mm)</translation>
    </message>
    <message>
        <source>a design has at most %1 elements</source>
        <translation>デザインの要素は最大 %1 個です</translation>
    </message>
    <message>
        <source>a curve has at most %1 points</source>
        <translation>曲線の点は最大 %1 個です</translation>
    </message>
    <message>
        <source>the usual values of a fabric are used instead</source>
        <translation>代わりに生地の標準値を使います</translation>
    </message>
    <message>
        <source>Remove %1 and what is sewn to it</source>
        <translation>%1 と、それに縫い付けたものを削除</translation>
    </message>
    <message>
        <source>Remove %1 and %2 seams and fixations</source>
        <translation>%1 と、縫い目・固定 %2 件を削除</translation>
    </message>
    <message>
        <source>is %1, but must be a positive length of at most %2; 12 mm is usual</source>
        <translation>値は %1 ですが、%2 以下の正の長さでなければなりません。標準は 12&#xa0;mm です</translation>
    </message>
    <message>
        <source>no mesh can resolve folds as small as a bending length of %1 mm makes them: with edges of %2 mm it acts like %3 mm; take a longer bending length</source>
        <translation>曲げ長さ %1&#xa0;mm でできる細かいしわは、どのメッシュでも表せません。%2&#xa0;mm のエッジでは %3&#xa0;mm 相当になります。曲げ長さを大きくしてください</translation>
    </message>
    <message>
        <source>it sews what %1 sews already; remove one of them</source>
        <translation>%1 がすでに縫っている所を縫っています。一方を削除してください</translation>
    </message>
    <message>
        <source>it sews the same stretches as %1, but the other way round: each would be folded onto itself; remove one of the two</source>
        <translation>%1 と同じ区間を逆向きに縫っており、それぞれが自身の上に折られます。一方を削除してください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; goes up with &quot;..&quot;; write the way from the design&apos;s folder without it, or copy the file there</source>
        <translation>「%1」は「..」で上の階層へ出ます。デザインのフォルダーからのパスをこれなしで書くか、ファイルをそこへコピーしてください</translation>
    </message>
    <message>
        <source>the number %1 is too large or too small; stay within %2</source>
        <translation>数値 %1 は大きすぎるか小さすぎます。%2 以内にしてください</translation>
    </message>
    <message>
        <source>the text is UTF-16; save it as UTF-8</source>
        <translation>テキストが UTF-16 です。UTF-8 で保存してください</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by %2 mm in each: it does not come to rest. Lower the pressure, or make curves as long as the outlines they hold.</source>
        <translation>%1 回の反復後も、面が毎回 %2&#xa0;mm 動き、静止しません。圧力を下げるか、曲線を、保持する輪郭と同じ長さにしてください。</translation>
    </message>
    <message>
        <source>%1 of %2 triangles of the cover lie upside down. Look for cloth pressed into too little room, or a bending length that is long for its patch.</source>
        <translation>カバーの三角形 %2 個のうち %1 個が裏返っています。狭い所に押し込まれた生地や、パーツに対して大きすぎる曲げ長さがないか確認してください。</translation>
    </message>
    <message>
        <source>there is either a normal or a tangent; remove one of them</source>
        <translation>指定できるのは法線か接線の一方です。どちらかを削除してください</translation>
    </message>
    <message>
        <source>there are %1 directions, but at most %2 are possible</source>
        <translation>方向が %1 個ありますが、最大 %2 個です</translation>
    </message>
    <message>
        <source>a direction must be three numbers that are not all 0</source>
        <translation>方向は、すべてが 0 ではない 3 つの数値でなければなりません</translation>
    </message>
    <message>
        <source>direction %1 is opposite to the one before, so that it is not known on which way to turn; add one between them</source>
        <translation>方向 %1 は直前と逆向きで、どちらへ回るか決まりません。間に 1 つ追加してください</translation>
    </message>
    <message>
        <source>there is no curve; name one, or leave out curve_from and curve_to</source>
        <translation>曲線がありません。指定するか、curve_from と curve_to を省いてください</translation>
    </message>
    <message>
        <source>Change the normal held by %1</source>
        <translation>%1 が保持する法線を変更</translation>
    </message>
    <message>
        <source>must be a text in quotation marks</source>
        <translation>引用符付きテキストでなければなりません</translation>
    </message>
    <message>
        <source>the curve in the patch and its target must both be open or both be closed</source>
        <translation>パーツ内の曲線とその目標は、両方とも開いているか、両方とも閉じていなければなりません</translation>
    </message>
    <message>
        <source>Add handle curve %1</source>
        <translation>ハンドル曲線 %1 を追加</translation>
    </message>
    <message>
        <source>Add fancy seam %1</source>
        <translation>飾り縫い %1 を追加</translation>
    </message>
    <message>
        <source>Add cushion %1</source>
        <translation>クッション %1 を追加</translation>
    </message>
    <message>
        <source>Add foam %1</source>
        <translation>フォーム %1 を追加</translation>
    </message>
    <message>
        <source>a width of %1 mm is too narrow for edges of %2 mm; make it at least %3 mm wide, or choose a smaller edge length</source>
        <translation>幅 %1&#xa0;mm は %2&#xa0;mm のエッジには狭すぎます。幅を %3&#xa0;mm 以上にするか、エッジ長を小さくしてください</translation>
    </message>
    <message>
        <source>it lies outside its patch; move its points inside the outline</source>
        <translation>パーツの外にあります。点を輪郭の内側へ移動してください</translation>
    </message>
    <message>
        <source>it leaves the patch and comes back; keep it inside, or end it at the outline</source>
        <translation>パーツの外へ出て戻っています。内側に収めるか、輪郭で終わらせてください</translation>
    </message>
    <message>
        <source>it runs too flat into the outline near %1; let it meet the outline more steeply, or end it before</source>
        <translation>%1 付近で輪郭への角度が浅すぎます。もっと急な角度で当てるか、手前で終わらせてください</translation>
    </message>
    <message>
        <source>it bends too sharply for a width of %1 mm near %2; make it narrower, or bend it less there</source>
        <translation>%2 付近の曲がりが幅 %1&#xa0;mm には急すぎます。幅を狭くするか、曲がりを緩めてください</translation>
    </message>
    <message>
        <source>a cushion takes at most %1 bodies of foam; this one is left out</source>
        <translation>クッションのフォームは最大 %1 個です。これは除外されます</translation>
    </message>
    <message>
        <source>the frame has no part &quot;%1&quot;; it has %2</source>
        <translation>フレームに部品「%1」はありません。あるのは %2 です</translation>
    </message>
    <message>
        <source>it is only %1 mm long; draw it at least %2 mm long, or choose a smaller edge length</source>
        <translation>長さが %1&#xa0;mm しかありません。%2&#xa0;mm 以上にするか、エッジ長を小さくしてください</translation>
    </message>
    <message>
        <source>it reaches beyond its patch near %1; move its points inside the outline</source>
        <translation>%1 付近でパーツからはみ出しています。点を輪郭の内側へ移動してください</translation>
    </message>
    <message>
        <source>it comes closer than %1 mm to the outline near %2; keep away from it, or choose a smaller edge length</source>
        <translation>%2 付近で輪郭から %1&#xa0;mm 以内に近づいています。離すか、エッジ長を小さくしてください</translation>
    </message>
    <message>
        <source>it crosses %1, or comes closer to it than %2 mm, near %3; move them apart, or choose a smaller edge length</source>
        <translation>%3 付近で %1 と交差するか、%2&#xa0;mm 以内に近づいています。離すか、エッジ長を小さくしてください</translation>
    </message>
    <message>
        <source>it crosses itself, or comes closer to itself than %1 mm, near %2; move its points apart, or choose a smaller edge length</source>
        <translation>%2 付近で自身と交差するか、%1&#xa0;mm 以内に近づいています。点を離すか、エッジ長を小さくしてください</translation>
    </message>
    <message>
        <source>the patch cannot be triangulated along it with edges of %1 mm. Choose a smaller edge length.</source>
        <translation>%1&#xa0;mm のエッジでは、パーツをこの曲線に沿って三角形分割できません。エッジ長を小さくしてください。</translation>
    </message>
    <message>
        <source>Change the frame of %1</source>
        <translation>%1 のフレームを変更</translation>
    </message>
    <message>
        <source>Change what %1 pushes</source>
        <translation>%1 の押す対象を変更</translation>
    </message>
    <message>
        <source>Switch %1</source>
        <translation>%1 のオン/オフを切り替え</translation>
    </message>
    <message>
        <source>Change the parts of %1</source>
        <translation>%1 の部品を変更</translation>
    </message>
    <message>
        <source>Change the padding of %1</source>
        <translation>%1 の詰め物を変更</translation>
    </message>
    <message>
        <source>Change the strength of %1</source>
        <translation>%1 の強さを変更</translation>
    </message>
    <message>
        <source>Change the distance of %1</source>
        <translation>%1 の距離を変更</translation>
    </message>
    <message>
        <source>Change the voxels of %1</source>
        <translation>%1 のボクセルを変更</translation>
    </message>
    <message>
        <source>Change the cushion of %1</source>
        <translation>%1 のクッションを変更</translation>
    </message>
    <message>
        <source>Change the shape of %1</source>
        <translation>%1 の形状を変更</translation>
    </message>
    <message>
        <source>Change the size of %1</source>
        <translation>%1 のサイズを変更</translation>
    </message>
    <message>
        <source>Add or cut %1</source>
        <translation>%1 の追加/くり抜きを切り替え</translation>
    </message>
    <message>
        <source>Change the contact of %1</source>
        <translation>%1 の接触を変更</translation>
    </message>
    <message>
        <source>Change the gap of %1</source>
        <translation>%1 のすき間を変更</translation>
    </message>
    <message>
        <source>Change the width of %1</source>
        <translation>%1 の幅を変更</translation>
    </message>
    <message>
        <source>Change the depth of %1</source>
        <translation>%1 の深さを変更</translation>
    </message>
    <message>
        <source>Change the profile of %1</source>
        <translation>%1 の断面形状を変更</translation>
    </message>
    <message>
        <source>Move points of %1 curves</source>
        <translation>%1 本の曲線の点を移動</translation>
    </message>
    <message>
        <source>Rename a file</source>
        <translation>ファイルの名前を変更</translation>
    </message>
    <message>
        <source>Change the file of %1</source>
        <translation>%1 のファイルを変更</translation>
    </message>
    <message>
        <source>the file is missing</source>
        <translation>ファイルがありません</translation>
    </message>
    <message>
        <source>it is a file that this design refers to; choose another name</source>
        <translation>このデザインが参照しているファイルです。別の名前を選んでください</translation>
    </message>
    <message>
        <source>There is no cover to place the scan on.</source>
        <translation>スキャンを合わせるカバーがありません。</translation>
    </message>
    <message>
        <source>must be a list of at most %1 planes, [x, y, z, distance] each</source>
        <translation>[x, y, z, 距離] の平面を最大 %1 個並べたリストでなければなりません</translation>
    </message>
    <message>
        <source>must be a list of at most %1 cuts in braces</source>
        <translation>波括弧で囲んだ切り取りを最大 %1 個並べたリストでなければなりません</translation>
    </message>
    <message>
        <source>must be a cut in braces, with planes</source>
        <translation>planes をもつ、波括弧で囲んだ切り取りでなければなりません</translation>
    </message>
    <message>
        <source>the first three numbers are the plane&apos;s normal; not all of them may be 0</source>
        <translation>最初の 3 つの数値は平面の法線です。すべてを 0 にはできません</translation>
    </message>
    <message>
        <source>no file is named; write the name of a file beside the design</source>
        <translation>ファイルの指定がありません。デザインと同じ場所にあるファイルの名前を書いてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no file in the design&apos;s folder; copy the file into that folder and name it here</source>
        <translation>「%1」はデザインのフォルダー内のファイルではありません。そのフォルダーにコピーして、ここに名前を書いてください</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot; in the design&apos;s folder; copy the file there or choose another one</source>
        <translation>デザインのフォルダーにファイル「%1」がありません。そこにコピーするか、別のファイルを選んでください</translation>
    </message>
    <message>
        <source>with this scale and position the points reach beyond 10,000,000 mm</source>
        <translation>この縮尺と位置では、点が 10,000,000&#xa0;mm を超えます</translation>
    </message>
    <message>
        <source>Add scan %1</source>
        <translation>スキャン %1 を追加</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>%1 を切り取る</translation>
    </message>
    <message>
        <source>Show all of %1</source>
        <translation>%1 をすべて表示</translation>
    </message>
    <message>
        <source>Cut the floor off %1</source>
        <translation>%1 の床を切り取る</translation>
    </message>
    <message>
        <source>%1 holds no points</source>
        <translation>%1 に点がありません</translation>
    </message>
    <message>
        <source>%1: the scan is too large, the limit is %2 points</source>
        <translation>%1: スキャンが大きすぎます。上限は %2 点です</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not expected in a PCD header</source>
        <translation>%1: 「%2」は PCD ヘッダーでは想定外です</translation>
    </message>
    <message>
        <source>%1: the compressed points are damaged</source>
        <translation>%1: 圧縮された点が破損しています</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PCD format</source>
        <translation>%1: 「%2」は PCD の形式ではありません</translation>
    </message>
    <message>
        <source>the cuts leave nothing of the scan; remove one of them</source>
        <translation>切り取りによりスキャンが残りません。どれかを削除してください</translation>
    </message>
    <message>
        <source>Change the threshold of %1</source>
        <translation>%1 のしきい値を変更</translation>
    </message>
    <message>
        <source>Change how %1 pulls</source>
        <translation>%1 の引き方を変更</translation>
    </message>
    <message>
        <source>Release points of twins</source>
        <translation>対称ペアの点の連動を解除</translation>
    </message>
    <message>
        <source>Re-link points of twins</source>
        <translation>対称ペアの点を再び連動</translation>
    </message>
    <message>
        <source>Make the design symmetric</source>
        <translation>デザインを対称にする</translation>
    </message>
    <message>
        <source>These two cannot be twins.</source>
        <translation>この 2 つは対称ペアにできません。</translation>
    </message>
    <message>
        <source>Make corners</source>
        <translation>角にする</translation>
    </message>
    <message>
        <source>Make curves smooth</source>
        <translation>曲線を滑らかにする</translation>
    </message>
    <message>
        <source>element %1 cannot be its twin: that must be another %2 which is nobody else&apos;s; until then it has none</source>
        <translation>要素 %1 は対称ペアの相手にできません。他と組んでいない別の %2 が必要です。それまで相手はありません</translation>
    </message>
    <message>
        <source>there is no point %1</source>
        <translation>点 %1 がありません</translation>
    </message>
    <message>
        <source>its points and knots are not those of %1; the next edit of one of them makes it the mirror image</source>
        <translation>点とノットが %1 と一致しません。どちらかを次に編集すると鏡像になります</translation>
    </message>
    <message>
        <source>%1 of its points are no mirror images of those of %2; release them, or move them</source>
        <translation>点のうち %1 個が %2 の点の鏡像ではありません。連動を解除するか、移動してください</translation>
    </message>
    <message>
        <source>the plane needs a normal that is not 0, and numbers within 1e7; x = 0 is used instead</source>
        <translation>平面には 0 でない法線と 1e7 以内の数値が必要です。代わりに x = 0 を使います</translation>
    </message>
    <message>
        <source>the axis needs a direction that is not 0, and numbers within 1e7; x = 0 is used instead</source>
        <translation>軸には 0 でない方向と 1e7 以内の数値が必要です。代わりに x = 0 を使います</translation>
    </message>
    <message>
        <source>The clipboard holds no parts of a design.</source>
        <translation>クリップボードにデザインの要素がありません。</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>%1 を貼り付け</translation>
    </message>
    <message>
        <source>Paste %1 pieces</source>
        <translation>%1 個を貼り付け</translation>
    </message>
    <message>
        <source>The clipboard holds no patches and no fixation curves.</source>
        <translation>クリップボードにパーツも固定曲線もありません。</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 を複製</translation>
    </message>
    <message>
        <source>Duplicate %1 pieces</source>
        <translation>%1 個を複製</translation>
    </message>
    <message>
        <source>Make a corner in %1</source>
        <translation>%1 に角を作成</translation>
    </message>
    <message>
        <source>Make %1 smooth</source>
        <translation>%1 を滑らかにする</translation>
    </message>
    <message>
        <source>Straighten a stretch of %1</source>
        <translation>%1 の区間を直線にする</translation>
    </message>
    <message>
        <source>Attach %1 to %2</source>
        <translation>%1 を %2 に固定</translation>
    </message>
    <message>
        <source>There is no such stretch of an outline.</source>
        <translation>そのような輪郭の区間はありません。</translation>
    </message>
    <message>
        <source>The stretch has no length.</source>
        <translation>区間に長さがありません。</translation>
    </message>
    <message>
        <source>A part of this stretch is fixed to %1 already: remove that fixation or choose another stretch.</source>
        <translation>この区間の一部はすでに %1 に固定されています。その固定を削除するか、別の区間を選んでください。</translation>
    </message>
    <message>
        <source>Create fixation curve %1</source>
        <translation>固定曲線 %1 を作成</translation>
    </message>
    <message>
        <source>Attach %1 stretches to %2</source>
        <translation>%1 区間を %2 に固定</translation>
    </message>
    <message>
        <source>Attach %1 to %2 curves</source>
        <translation>%1 を %2 本の曲線に固定</translation>
    </message>
    <message>
        <source>Align %1 patches</source>
        <translation>%1 個のパーツを整列</translation>
    </message>
    <message>
        <source>Distribute %1 patches</source>
        <translation>%1 個のパーツを等間隔に配置</translation>
    </message>
    <message>
        <source>Arrange %1 patches</source>
        <translation>%1 個のパーツを配置</translation>
    </message>
    <message>
        <source>Make %1 and %2 twins</source>
        <translation>%1 と %2 を対称ペアにする</translation>
    </message>
    <message>
        <source>They are no mirror images: they differ by %1 mm. Twins must be alike; make a mirror twin of one of them instead.</source>
        <translation>鏡像ではありません。%1&#xa0;mm の差があります。対称ペアは同じ形でなければなりません。代わりに、一方から対称ペアを作成してください。</translation>
    </message>
    <message>
        <source>Make a mirror twin of %1</source>
        <translation>%1 の対称ペアを作成</translation>
    </message>
    <message>
        <source>Make %1 mirror twins</source>
        <translation>対称ペアを %1 個作成</translation>
    </message>
    <message>
        <source>A patch of the seam is missing or invalid: repair it first.</source>
        <translation>縫い目のパーツがないか無効です。先に修復してください。</translation>
    </message>
    <message>
        <source>The seam joins %1 to itself: there is nothing to merge.</source>
        <translation>%1 自身を縫い合わせる縫い目です。結合するものがありません。</translation>
    </message>
    <message>
        <source>The seam takes up a whole outline: nothing would be left.</source>
        <translation>縫い目が輪郭全体を占めています。何も残りません。</translation>
    </message>
    <message>
        <source>The seam joins the right side of %1 to the wrong side of %2: one patch cannot be both.</source>
        <translation>%1 の表と %2 の裏を縫い合わせる縫い目です。1 つのパーツにはできません。</translation>
    </message>
    <message>
        <source>The sides of the seam differ by %1 % in length, more than 5 %.</source>
        <translation>縫い目の両側の長さの差が %1&#xa0;% で、5&#xa0;% を超えています。</translation>
    </message>
    <message>
        <source>Select the seam along which to merge.</source>
        <translation>結合する縫い目を選択してください。</translation>
    </message>
    <message>
        <source>Merged, %1 and %2 would overlap or cross: the seam stays.</source>
        <translation>結合すると %1 と %2 が重なるか交差します。縫い目はそのままです。</translation>
    </message>
    <message>
        <source>Merge %1 and %2</source>
        <translation>%1 と %2 を結合</translation>
    </message>
    <message>
        <source>Scale %1 patches</source>
        <translation>%1 個のパーツを拡大縮小</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>%1 を反転</translation>
    </message>
    <message>
        <source>Mirror %1 patches</source>
        <translation>%1 個のパーツを反転</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>%1 を分割</translation>
    </message>
    <message>
        <source>The line must cross the outline of %1 exactly twice, not %2 times.</source>
        <translation>線は %1 の輪郭とちょうど 2 回交わる必要がありますが、%2 回交わっています。</translation>
    </message>
    <message>
        <source>Draw a line over a patch to split it.</source>
        <translation>パーツの上に線を引いて分割してください。</translation>
    </message>
    <message>
        <source>The outline of %1 is invalid: repair it first.</source>
        <translation>%1 の輪郭が無効です。先に修復してください。</translation>
    </message>
    <message>
        <source>The line must run inside %1.</source>
        <translation>線は %1 の内側を通らなければなりません。</translation>
    </message>
    <message>
        <source>A piece of %1 would cross itself or be too narrow: draw another line.</source>
        <translation>%1 の一部が自身と交差するか、狭くなりすぎます。別の線を引いてください。</translation>
    </message>
    <message>
        <source>Sew %1 to %2</source>
        <translation>%1 を %2 に縫う</translation>
    </message>
    <message>
        <source>Sew %1 to %2 stretches in a row</source>
        <translation>%1 を連続する %2 区間に縫う</translation>
    </message>
    <message>
        <source>Flip %1</source>
        <translation>%1 の向きを反転</translation>
    </message>
    <message>
        <source>Flip %1 seams</source>
        <translation>%1 本の縫い目の向きを反転</translation>
    </message>
    <message>
        <source>Swap the sides of %1</source>
        <translation>%1 の両側を入れ替え</translation>
    </message>
    <message>
        <source>Swap the sides of %1 seams</source>
        <translation>%1 本の縫い目の両側を入れ替え</translation>
    </message>
    <message>
        <source>Change the continuity of %1 seams</source>
        <translation>%1 本の縫い目の連続性を変更</translation>
    </message>
    <message>
        <source>Change how %1 seams are matched</source>
        <translation>%1 本の縫い目の対応付けを変更</translation>
    </message>
    <message>
        <source>This stretch has no length: choose two different points.</source>
        <translation>この区間に長さがありません。異なる 2 点を選んでください。</translation>
    </message>
    <message>
        <source>Move an end of %1</source>
        <translation>%1 の端を移動</translation>
    </message>
    <message>
        <source>%1 is already sewn to %2 here: remove that seam first, or take a free stretch.</source>
        <translation>%1 はここですでに %2 に縫われています。先にその縫い目を削除するか、空いている区間を選んでください。</translation>
    </message>
    <message>
        <source>A stretch cannot be sewn to itself: choose two that have no part in common.</source>
        <translation>区間を自身に縫うことはできません。共通部分のない 2 区間を選んでください。</translation>
    </message>
    <message>
        <source>Unlink %1 and %2</source>
        <translation>%1 と %2 の連動を解除</translation>
    </message>
    <message>
        <source>Unlink %1 pairs of twins</source>
        <translation>%1 組の対称ペアの連動を解除</translation>
    </message>
    <message>
        <source>Release a point of %1</source>
        <translation>%1 の点の連動を解除</translation>
    </message>
    <message>
        <source>Release %2 points of %1</source>
        <translation>%1 の点 %2 個の連動を解除</translation>
    </message>
    <message>
        <source>Re-link a point of %1</source>
        <translation>%1 の点を再び連動</translation>
    </message>
    <message>
        <source>Re-link %2 points of %1</source>
        <translation>%1 の点 %2 個を再び連動</translation>
    </message>
    <message>
        <source>Change the curve of %1</source>
        <translation>%1 の曲線を変更</translation>
    </message>
    <message>
        <source>The outline of %1 would cross or touch itself.</source>
        <translation>%1 の輪郭が自身と交差または接触します。</translation>
    </message>
    <message>
        <source>The outline of %1 would enclose nothing.</source>
        <translation>%1 の輪郭に面積がなくなります。</translation>
    </message>
    <message>
        <source>%1 would not lie inside %2 any more.</source>
        <translation>%1 が %2 の内側からはみ出します。</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that is fixed to %2.</source>
        <translation>区間が、%2 に固定された %1 の別の区間と重なります。</translation>
    </message>
    <message>
        <source>The stretch would overlap the seam of %1 and %2.</source>
        <translation>区間が %1 と %2 の縫い目と重なります。</translation>
    </message>
    <message>
        <source>The two sides of the seam would overlap.</source>
        <translation>縫い目の両側が重なります。</translation>
    </message>
    <message>
        <source>Change the length of a stretch of %1</source>
        <translation>%1 の区間の長さを変更</translation>
    </message>
    <message>
        <source>Move an end of a fixation of %1</source>
        <translation>%1 の固定の端を移動</translation>
    </message>
    <message>
        <source>Re-link a seam to its mirror image</source>
        <translation>縫い目を鏡像と再び連動</translation>
    </message>
    <message>
        <source>Release a seam from its mirror image</source>
        <translation>縫い目と鏡像の連動を解除</translation>
    </message>
    <message>
        <source>another element had the same number; give this one a number of its own</source>
        <translation>別の要素が同じ番号でした。この要素に固有の番号を付けてください</translation>
    </message>
    <message>
        <source>Take %1 elements from another version</source>
        <translation>%1 個の要素を別のバージョンから取り込む</translation>
    </message>
    <message>
        <source>Take %1 from another version</source>
        <translation>%1 を別のバージョンから取り込む</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is not an ordinary file</source>
        <translation>「%1」に書き込めません: 通常のファイルではありません</translation>
    </message>
    <message>
        <source>a file that the design uses cannot be read (%1)</source>
        <translation>デザインが使うファイルを読み込めません (%1)</translation>
    </message>
    <message>
        <source>a file of the project cannot be written out (%1)</source>
        <translation>プロジェクトのファイルを書き出せません (%1)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be opened or made</source>
        <translation>「%1」を開くことも作成することもできません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is in use by another program</source>
        <translation>「%1」は別のプログラムが使用中です</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged (%2)</source>
        <translation>「%1」は破損しています (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read or written (%2)</source>
        <translation>「%1」を読み書きできません (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is closed</source>
        <translation>「%1」は閉じられています</translation>
    </message>
    <message>
        <source>%1 cannot be stored: it holds a number that is none, or text in an unknown encoding</source>
        <translation>%1 を保存できません。数値でない値、または文字コードが不明なテキストを含んでいます</translation>
    </message>
    <message>
        <source>there is a file &quot;%1&quot; already</source>
        <translation>ファイル「%1」はすでに存在します</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no Bolster project</source>
        <translation>「%1」は Bolster のプロジェクトではありません</translation>
    </message>
    <message>
        <source>there is not enough memory for this project</source>
        <translation>このプロジェクトにはメモリが足りません</translation>
    </message>
    <message>
        <source>an edit of the project cannot be read any more</source>
        <translation>プロジェクトの編集の 1 つを読み取れなくなっています</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name for a file of a project</source>
        <translation>「%1」はプロジェクトのファイル名に使えません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was made by a newer Bolster (version %2 of the format, this program knows %3); update the program</source>
        <translation>「%1」は新しい Bolster で作られています (形式バージョン %2、このプログラムは %3 まで)。プログラムを更新してください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; says that it has version %2 of the format, which never was</source>
        <translation>「%1」の形式バージョンは %2 とありますが、存在しないバージョンです</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the journal of a running program, or of one that crashed, not a project file</source>
        <translation>「%1」は実行中またはクラッシュしたプログラムのジャーナルで、プロジェクトファイルではありません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: it is %2 bytes long and should have %3</source>
        <translation>「%1」は破損しています: 長さが %2 バイトで、本来は %3 バイトです</translation>
    </message>
    <message>
        <source>a temporary folder cannot be made (%1)</source>
        <translation>一時フォルダーを作成できません (%1)</translation>
    </message>
    <message>
        <source>a temporary file cannot be made (%1)</source>
        <translation>一時ファイルを作成できません (%1)</translation>
    </message>
    <message>
        <source>nothing in &quot;%1&quot; can be saved</source>
        <translation>「%1」から復旧できるものはありません</translation>
    </message>
    <message>
        <source>%1 versions were saved</source>
        <translation>%1 個のバージョンを復旧しました</translation>
    </message>
    <message>
        <source>lost: versions %1 to %2</source>
        <translation>失われたもの: バージョン %1 から %2</translation>
    </message>
    <message>
        <source>Saved version</source>
        <translation>復旧したバージョン</translation>
    </message>
    <message>
        <source>version %1 was saved without the edits before it</source>
        <translation>バージョン %1 は、それ以前の編集なしで復旧しました</translation>
    </message>
    <message>
        <source>lost: the names of %1 versions</source>
        <translation>失われたもの: %1 個のバージョンの名前</translation>
    </message>
    <message>
        <source>lost: the file &quot;%1&quot;</source>
        <translation>失われたもの: ファイル「%1」</translation>
    </message>
    <message>
        <source>the tables of &quot;%1&quot; are not those of a Bolster project</source>
        <translation>「%1」の表は Bolster プロジェクトのものではありません</translation>
    </message>
    <message>
        <source>a checksum is incomplete</source>
        <translation>チェックサムが不完全です</translation>
    </message>
    <message>
        <source>another window has it</source>
        <translation>別のウィンドウで開かれています</translation>
    </message>
    <message>
        <source>must be a list of pairs in braces, with patch and fabric</source>
        <translation>patch と fabric をもつ、波括弧で囲んだ組のリストでなければなりません</translation>
    </message>
    <message>
        <source>must be a pair in braces, with patch and fabric</source>
        <translation>patch と fabric をもつ、波括弧で囲んだ組でなければなりません</translation>
    </message>
    <message>
        <source>there is no colourway %1; the patches show their own fabrics</source>
        <translation>カラーウェイ %1 がありません。パーツ自身の生地を表示します</translation>
    </message>
    <message>
        <source>%1 has a fabric in this colourway already; remove one of the two</source>
        <translation>このカラーウェイで %1 にはすでに生地があります。一方を削除してください</translation>
    </message>
    <message>
        <source>what it says of missing patches and fabrics is left out</source>
        <translation>存在しないパーツと生地に関する記載は無視します</translation>
    </message>
    <message>
        <source>Make %1 of %2</source>
        <translation>%1 を %2 にする</translation>
    </message>
    <message>
        <source>Make %1 patches of %2</source>
        <translation>%1 個のパーツを %2 にする</translation>
    </message>
    <message>
        <source>Add colourway %1</source>
        <translation>カラーウェイ %1 を追加</translation>
    </message>
    <message>
        <source>Change what %1 shows</source>
        <translation>%1 の表示を変更</translation>
    </message>
    <message>
        <source>Change what %1 patches show</source>
        <translation>%1 個のパーツの表示を変更</translation>
    </message>
    <message>
        <source>Show no colourway</source>
        <translation>カラーウェイを表示しない</translation>
    </message>
    <message>
        <source>Show colourway %1</source>
        <translation>カラーウェイ %1 を表示</translation>
    </message>
    <message>
        <source>A stretch of %1 that is sewn, fixed or trimmed would have no length.</source>
        <translation>%1 の縫製、固定または装飾した区間の長さがなくなります。</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that has a trim.</source>
        <translation>区間が、%1 の装飾のある別の区間と重なります。</translation>
    </message>
    <message>
        <source>Add a trim</source>
        <translation>装飾を追加</translation>
    </message>
    <message>
        <source>Move an end of a trim of %1</source>
        <translation>%1 の装飾の端を移動</translation>
    </message>
    <message>
        <source>Change the trim of %1 seams</source>
        <translation>%1 本の縫い目の装飾を変更</translation>
    </message>
    <message>
        <source>Change the trim of %1</source>
        <translation>%1 の装飾を変更</translation>
    </message>
    <message>
        <source>A part of this stretch of %1 has a trim already: change that one, or choose another stretch.</source>
        <translation>%1 のこの区間の一部にはすでに装飾があります。それを変更するか、別の区間を選んでください。</translation>
    </message>
    <message>
        <source>Trim the edge of %1</source>
        <translation>%1 の辺を装飾</translation>
    </message>
    <message>
        <source>%1: the file cannot be read any further; it has changed, or its disk is gone</source>
        <translation>%1: ファイルの続きを読み込めません。変更されたか、ディスクがなくなっています</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a picture that can be read; PNG, JPEG, TIFF and OpenEXR can</source>
        <translation>「%1」は読み込める画像ではありません。読み込めるのは PNG、JPEG、TIFF、OpenEXR です</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 by %3 pixels, and at most 64 million are read; make the picture smaller in a picture editor</source>
        <translation>「%1」は %2 × %3 ピクセルです。読み込めるのは 6400 万ピクセルまでです。画像編集ソフトで小さくしてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a kind of picture whose colours cannot be read; save it as PNG in a picture editor</source>
        <translation>「%1」は色を読み込めない種類の画像です。画像編集ソフトで PNG として保存してください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged or incomplete; copy it again from where it came from, or save it again in a picture editor</source>
        <translation>「%1」は破損しているか不完全です。元の場所からコピーし直すか、画像編集ソフトで保存し直してください</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which reads pictures for Bolster, cannot be started; install Bolster again</source>
        <translation>Bolster 用に画像を読み込むプログラム「%1」を起動できません。Bolster を再インストールしてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes too long to read; save it as PNG in a picture editor</source>
        <translation>「%1」の読み込みに時間がかかりすぎます。画像編集ソフトで PNG として保存してください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be decoded: it is damaged or incomplete, or needs too much memory; save it again as PNG in a picture editor</source>
        <translation>「%1」をデコードできません。破損または不完全か、メモリを使いすぎます。画像編集ソフトで PNG として保存し直してください</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this picture</source>
        <translation>%1: この画像にはメモリが足りません</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this file</source>
        <translation>%1: このファイルにはメモリが足りません</translation>
    </message>
    <message>
        <source>%1: the line is too long</source>
        <translation>%1: 行が長すぎます</translation>
    </message>
    <message>
        <source>both have a file &quot;%1&quot;, and they are different: save under another name</source>
        <translation>両方にファイル「%1」があり、内容が異なります。別の名前で保存してください</translation>
    </message>
    <message>
        <source>there is another project in the file now</source>
        <translation>ファイルは現在、別のプロジェクトになっています</translation>
    </message>
    <message>
        <source>the last edits are not on the disk yet</source>
        <translation>最後の編集がまだディスクに書き込まれていません</translation>
    </message>
    <message>
        <source>Change the stitching of %1</source>
        <translation>%1 のステッチを変更</translation>
    </message>
    <message>
        <source>Change the piping of %1</source>
        <translation>%1 のパイピングを変更</translation>
    </message>
    <message>
        <source>Change the seam allowance of %1</source>
        <translation>%1 の縫い代を変更</translation>
    </message>
    <message>
        <source>Change the valley of %1</source>
        <translation>%1 の谷を変更</translation>
    </message>
    <message>
        <source>there is no fabric in &quot;%1&quot;</source>
        <translation>「%1」に生地がありません</translation>
    </message>
    <message>
        <source>the design uses &quot;%1&quot; itself; choose another name</source>
        <translation>「%1」はデザイン自身が使用しています。別の名前を選んでください</translation>
    </message>
    <message>
        <source>there is not enough memory to show this fabric</source>
        <translation>この生地を表示するメモリが足りません</translation>
    </message>
    <message>
        <source>Replace fabric %1 by %2</source>
        <translation>生地 %1 を %2 に置き換え</translation>
    </message>
    <message>
        <source>Change the limits of %1</source>
        <translation>%1 の限界を変更</translation>
    </message>
    <message>
        <source>Change the look of %1</source>
        <translation>%1 の外観を変更</translation>
    </message>
    <message>
        <source>Change the second colour of %1</source>
        <translation>%1 の 2 番目の色を変更</translation>
    </message>
    <message>
        <source>Change the kind of %1</source>
        <translation>%1 の種類を変更</translation>
    </message>
    <message>
        <source>there is no place for the files of this project</source>
        <translation>このプロジェクトのファイルを置く場所がありません</translation>
    </message>
    <message>
        <source>A side of this seam does not end at corners: its length cannot be changed alone.</source>
        <translation>この縫い目の一方の側が角で終わっていません。その長さだけを変更することはできません。</translation>
    </message>
    <message>
        <source>These edges cannot have this length: they hang together.</source>
        <translation>これらの辺は互いにつながっているため、この長さにはできません。</translation>
    </message>
    <message>
        <source>Change the length of an edge of %1</source>
        <translation>%1 の辺の長さを変更</translation>
    </message>
    <message>
        <source>Change the length of %1 edges</source>
        <translation>%1 本の辺の長さを変更</translation>
    </message>
    <message>
        <source>Make %1 edges equally long</source>
        <translation>%1 本の辺を同じ長さにする</translation>
    </message>
    <message>
        <source>Make the sides of a seam equally long</source>
        <translation>縫い目の両側を同じ長さにする</translation>
    </message>
    <message>
        <source>Make the sides of %1 seams equally long</source>
        <translation>%1 本の縫い目の両側を同じ長さにする</translation>
    </message>
    <message>
        <source>There is a &quot;%1&quot; already: this one is called &quot;%2&quot;.</source>
        <translation>「%1」はすでにあります。これは「%2」という名前になります。</translation>
    </message>
    <message>
        <source>Change the size of %1 patches</source>
        <translation>%1 個のパーツのサイズを変更</translation>
    </message>
    <message>
        <source>%1: the rows hold more than the header of the file says; what is too much in each was left out</source>
        <translation>%1: 行の内容がヘッダーの記載より多くなっています。各行の余分は無視しました</translation>
    </message>
    <message>
        <source>this changes more at once than can be stored: at most %1 MB, and %2 keys; do it in parts</source>
        <translation>一度の変更が保存できる量を超えています (最大 %1&#xa0;MB、キー %2 個)。分けて行ってください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; unpacks to more than any project; it was not made by Bolster, or is damaged</source>
        <translation>「%1」の展開後のサイズがプロジェクトの範囲を超えています。Bolster で作られていないか、破損しています</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which recovers projects for Bolster, cannot be started; install Bolster again</source>
        <translation>Bolster 用にプロジェクトを復旧するプログラム「%1」を起動できません。Bolster を再インストールしてください</translation>
    </message>
    <message>
        <source>nothing in &quot;%1&quot; can be saved: it is damaged in a way that takes too much time or memory</source>
        <translation>「%1」から復旧できるものはありません。破損の程度により、時間かメモリがかかりすぎます</translation>
    </message>
    <message>
        <source>lost: the table &quot;%1&quot;, which is missing or has other columns than it should</source>
        <translation>失われたもの: 表「%1」。存在しないか、列が異なります</translation>
    </message>
    <message>
        <source>lost: %1 more such gaps</source>
        <translation>失われたもの: 同様の欠落が他 %1 件</translation>
    </message>
    <message>
        <source>what comes after version %1 takes too long to recover</source>
        <translation>バージョン %1 より後の復旧には時間がかかりすぎます</translation>
    </message>
    <message>
        <source>the edit of version %1 does not lead to the design that was kept with it</source>
        <translation>バージョン %1 の編集の結果が、一緒に保存されたデザインと一致しません</translation>
    </message>
    <message>
        <source>it pushes nothing: no part of the frame lies under the cover</source>
        <translation>何も押していません。カバーの下にフレームの部品がありません</translation>
    </message>
    <message>
        <source>contact looks at the frame in steps of %1 mm; something of these parts is thinner, so that the cover may pass through: %2; make it thicker</source>
        <translation>接触はフレームを %1&#xa0;mm 刻みで調べます。次の部品にそれより薄い所があり、カバーが通り抜けることがあります: %2。厚くしてください</translation>
    </message>
    <message>
        <source>contact does nothing: in steps of %1 mm it finds no inside of the frame, which is thinner than that, or so open that it has none; close the frame, or make it thicker</source>
        <translation>接触は効いていません。%1&#xa0;mm 刻みではフレームの内部が見つかりません。フレームがそれより薄いか、開きすぎています。フレームを閉じるか、厚くしてください</translation>
    </message>
    <message>
        <source>%1 lies in folds: there is more cloth than room for it</source>
        <translation>%1 にしわが寄っています。収まる広さに対して生地が余っています</translation>
    </message>
    <message>
        <source>%1 floats free: nothing holds it, and it is sewn to nothing that is held</source>
        <translation>%1 は浮いています。固定されておらず、固定されたものにも縫われていません</translation>
    </message>
    <message>
        <source>%1 holds the cloth %2 mm off the frame</source>
        <translation>%1 が生地をフレームから %2&#xa0;mm 離して保持しています</translation>
    </message>
    <message>
        <source>The seam of %1 and %2 has %3 % ease: it puckers above %4 %</source>
        <translation>%1 と %2 の縫い目のいせは %3&#xa0;% です。%4&#xa0;% を超えるとしわになります</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations.</source>
        <translation>%1 回の反復後、面が発散しました。</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations: %2 holds it %3 mm from everything else. Bring that curve nearer.</source>
        <translation>%1 回の反復後、面が発散しました。%2 が他のすべてから %3&#xa0;mm 離れて保持しています。その曲線を近づけてください。</translation>
    </message>
    <message>
        <source>The equations of the cover could not be solved: %1 is degenerate or its numbers are too large. Check its outline and its fabric.</source>
        <translation>カバーの方程式を解けませんでした。%1 が退化しているか、数値が大きすぎます。輪郭と生地を確認してください。</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations: the pressure of %2 (%3) is too high for its fabric. Lower it.</source>
        <translation>%1 回の反復後、面が発散しました。%2 の圧力 (%3) が生地に対して高すぎます。下げてください。</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations, most likely because of %2. Check the size of that patch, its pressure and its fabric.</source>
        <translation>%1 回の反復後、面が発散しました。おそらく %2 が原因です。そのパーツのサイズ、圧力、生地を確認してください。</translation>
    </message>
    <message>
        <source>Change the material of %1</source>
        <translation>%1 の材料を変更</translation>
    </message>
    <message>
        <source>Show a part of %1</source>
        <translation>%1 の部品を表示</translation>
    </message>
    <message>
        <source>Hide a part of %1</source>
        <translation>%1 の部品を非表示</translation>
    </message>
    <message>
        <source>Show all parts of %1</source>
        <translation>%1 のすべての部品を表示</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a link to &quot;%2&quot; now</source>
        <translation>「%1」は現在「%2」へのリンクです</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was changed by another program</source>
        <translation>「%1」は別のプログラムで変更されました</translation>
    </message>
    <message>
        <source>somebody else has changed &quot;%1&quot; since it was opened here</source>
        <translation>「%1」は、ここで開いた後に他の人が変更しました</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is another project now</source>
        <translation>「%1」は現在、別のプロジェクトです</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be renamed (%2)</source>
        <translation>「%1」の名前を変更できません (%2)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: the content number %2 cannot be read</source>
        <translation>「%1」は破損しています: 内容 %2 を読み取れません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: a row holds something of another kind than it should</source>
        <translation>「%1」は破損しています: 行の内容の種類が異なります</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: row %2 of the table &quot;%3&quot; contradicts others</source>
        <translation>「%1」は破損しています: 表「%3」の行 %2 が他と矛盾しています</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: parts of the file are not what was written</source>
        <translation>「%1」は破損しています: ファイルの一部が書き込んだ内容と異なります</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: rows are missing, or there are some too many</source>
        <translation>「%1」は破損しています: 行が足りないか、多すぎます</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: the edits up to number %2 do not lead to the design that was stored with them</source>
        <translation>「%1」は破損しています: 番号 %2 までの編集の結果が、一緒に保存されたデザインと一致しません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: row %2 of the table &quot;%3&quot; is not what was written</source>
        <translation>「%1」は破損しています: 表「%3」の行 %2 が書き込んだ内容と異なります</translation>
    </message>
    <message>
        <source>there is no picture to write</source>
        <translation>書き出す画像がありません</translation>
    </message>
    <message>
        <source>%1: a face has %2 corners, and at most %3 are read; have it split into triangles by the program that has made the file</source>
        <translation>%1: 面の角が %2 個あります。読み込めるのは %3 個までです。ファイルを作成したプログラムで三角形に分割してください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: no file can be made in &quot;%2&quot;; choose another folder</source>
        <translation>「%1」に書き込めません: 「%2」にファイルを作成できません。別のフォルダーを選んでください</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>中断されました</translation>
    </message>
    <message>
        <source>at most %1 cushions push; this one and those after it are left out</source>
        <translation>押すクッションは最大 %1 個です。これ以降は除外されます</translation>
    </message>
    <message>
        <source>the picture cannot be encoded (%1)</source>
        <translation>画像をエンコードできません (%1)</translation>
    </message>
    <message>
        <source>a smallest detail of %1 mm is too fine for a frame as large as this (%2 million cubes of it, and %3 are the limit), so the cushion is left out; take at least %4 mm</source>
        <translation>最小ディテール %1&#xa0;mm は、これほど大きいフレームには細かすぎます (立方体の数、百万個単位: %2、上限 %3)。そのためクッションは除外されます。%4&#xa0;mm 以上にしてください</translation>
    </message>
    <message>
        <source>something of these parts of the frame is thinner than the smallest detail of the padding, %1 mm, so that it may have gaps there: %2; take a smaller detail</source>
        <translation>次の部品に、詰め物の最小ディテール %1&#xa0;mm より薄い所があり、詰め物に欠けができることがあります: %2。ディテールを小さくしてください</translation>
    </message>
    <message>
        <source>it pushes nothing: with a smallest detail of %1 mm there is no inside of the frame, which is thinner than that, or so open that it has none; take a smaller detail, or close the frame</source>
        <translation>何も押していません。最小ディテール %1&#xa0;mm ではフレームの内部がありません。フレームがそれより薄いか、開きすぎています。ディテールを小さくするか、フレームを閉じてください</translation>
    </message>
    <message>
        <source>Change the slanted faces of %1</source>
        <translation>%1 の斜めの面を変更</translation>
    </message>
    <message>
        <source>Change the smallest detail of %1</source>
        <translation>%1 の最小ディテールを変更</translation>
    </message>
    <message>
        <source>the log of &quot;%1&quot; is damaged: the last edits cannot be read</source>
        <translation>「%1」のログが破損しています。最後の編集を読み取れません</translation>
    </message>
    <message>
        <source>the kind %1 is unknown; there are %2 and %3</source>
        <translation>種類 %1 は不明です。あるのは %2 と %3 です</translation>
    </message>
    <message>
        <source>its label finds no room: make the words shorter, or put it elsewhere</source>
        <translation>ラベルの収まる場所がありません。文字を短くするか、別の場所に置いてください</translation>
    </message>
    <message>
        <source>its cut lines meet here: make the allowance smaller</source>
        <translation>裁断線がここで接しています。縫い代を小さくしてください</translation>
    </message>
    <message>
        <source>a notch of %1 mm reaches the sewing line, which is %2 mm away: make it shallower, or the allowance wider</source>
        <translation>%1&#xa0;mm のノッチが %2&#xa0;mm 先の出来上がり線に届きます。浅くするか、縫い代を広げてください</translation>
    </message>
    <message>
        <source>nothing is sewn where it is, so it has no partner</source>
        <translation>この場所は縫われていないため、相手のノッチがありません</translation>
    </message>
    <message>
        <source>it has no partner on the other side of its seam: another notch is too near there</source>
        <translation>縫い目の反対側に相手がありません。別のノッチが近すぎます</translation>
    </message>
    <message>
        <source>it is %1 mm wide across the grain, but &quot;%2&quot; only %3 mm: split it, or turn its grain</source>
        <translation>直交方向の幅が %1&#xa0;mm ですが、「%2」は %3&#xa0;mm しかありません。分割するか、地の目を回転してください</translation>
    </message>
    <message>
        <source>an inner corner of %1 degrees is too sharp for its seam allowances: make them smaller there, or the corner wider</source>
        <translation>%1 度の入隅は縫い代に対して鋭すぎます。そこの縫い代を小さくするか、角を広げてください</translation>
    </message>
    <message>
        <source>There is no such place on an outline.</source>
        <translation>輪郭上にそのような場所はありません。</translation>
    </message>
    <message>
        <source>A part of this stretch of %1 has a seam allowance of its own already: change that one, or choose another stretch.</source>
        <translation>%1 のこの区間の一部にはすでに独自の縫い代があります。それを変更するか、別の区間を選んでください。</translation>
    </message>
    <message>
        <source>There is a notch of %1 at this place already.</source>
        <translation>%1 のこの場所にはすでにノッチがあります。</translation>
    </message>
    <message>
        <source>This corner of %1 has a join of its own already.</source>
        <translation>%1 のこの角にはすでに独自の形があります。</translation>
    </message>
    <message>
        <source>Change the seam allowance of %1 patches</source>
        <translation>%1 個のパーツの縫い代を変更</translation>
    </message>
    <message>
        <source>Change the seam allowance of an edge of %1</source>
        <translation>%1 の辺の縫い代を変更</translation>
    </message>
    <message>
        <source>Change a corner of the cut line of %1</source>
        <translation>%1 の裁断線の角を変更</translation>
    </message>
    <message>
        <source>Add a notch to %1</source>
        <translation>%1 にノッチを追加</translation>
    </message>
    <message>
        <source>Move a notch</source>
        <translation>ノッチを移動</translation>
    </message>
    <message>
        <source>Move the join of a corner</source>
        <translation>角の形を移動</translation>
    </message>
    <message>
        <source>A drill hole must lie inside its patch.</source>
        <translation>ドリル穴はパーツの内側になければなりません。</translation>
    </message>
    <message>
        <source>Move %1 drill holes</source>
        <translation>%1 個のドリル穴を移動</translation>
    </message>
    <message>
        <source>Move the label of %1</source>
        <translation>%1 のラベルを移動</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that has its own seam allowance.</source>
        <translation>区間が、%1 の独自の縫い代をもつ別の区間と重なります。</translation>
    </message>
    <message>
        <source>Give an edge its own seam allowance</source>
        <translation>辺に独自の縫い代を設定</translation>
    </message>
    <message>
        <source>Change a corner of the cut line</source>
        <translation>裁断線の角を変更</translation>
    </message>
    <message>
        <source>Add drill hole %1</source>
        <translation>ドリル穴 %1 を追加</translation>
    </message>
    <message>
        <source>Change the diameter of %1</source>
        <translation>%1 の直径を変更</translation>
    </message>
    <message>
        <source>Change the notches of %1</source>
        <translation>%1 のノッチを変更</translation>
    </message>
    <message>
        <source>Change the automatic notches</source>
        <translation>自動ノッチを変更</translation>
    </message>
    <message>
        <source>Add a notch</source>
        <translation>ノッチを追加</translation>
    </message>
    <message>
        <source>Change how %1 is cut</source>
        <translation>%1 の裁断を変更</translation>
    </message>
    <message>
        <source>Change how the pattern is cut</source>
        <translation>型紙の裁断を変更</translation>
    </message>
    <message>
        <source>Add internal line %1</source>
        <translation>内部線 %1 を追加</translation>
    </message>
    <message>
        <source>Change the purpose of %1</source>
        <translation>%1 の用途を変更</translation>
    </message>
    <message>
        <source>Change the ease of %1</source>
        <translation>%1 のいせを変更</translation>
    </message>
    <message>
        <source>is %1, but must be a whole number; %2 are cut</source>
        <translation>値は %1 ですが、整数でなければなりません。%2 枚を裁断します</translation>
    </message>
    <message>
        <source>%1 is an allowance of a part of this stretch already; remove one of the two, or make their stretches meet</source>
        <translation>%1 がすでにこの区間の一部の縫い代です。一方を削除するか、区間を突き合わせてください</translation>
    </message>
    <message>
        <source>the hole lies outside of &quot;%1&quot;; move it inside</source>
        <translation>穴が「%1」の外にあります。内側へ移動してください</translation>
    </message>
    <message>
        <source>its sides are %1 mm and %2 mm long: true the seam, or say in its properties how much ease is wanted</source>
        <translation>両側の長さが %1&#xa0;mm と %2&#xa0;mm です。縫い目の長さを揃えるか、目標のいせをプロパティで指定してください</translation>
    </message>
    <message>
        <source>its sides are %1 mm and %2 mm long, but the second one shall be longer by %3 mm: true the seam, or change the ease in its properties</source>
        <translation>両側の長さが %1&#xa0;mm と %2&#xa0;mm ですが、2 番目の側は %3&#xa0;mm 長くなければなりません。縫い目の長さを揃えるか、プロパティでいせを変更してください</translation>
    </message>
    <message>
        <source>The mouth of a dart must be at least 1 mm wide.</source>
        <translation>ダーツの開きは 1&#xa0;mm 以上必要です。</translation>
    </message>
    <message>
        <source>The tip of a dart must lie inside its patch, at least 5 mm from its mouth.</source>
        <translation>ダーツの先端はパーツの内側で、開きから 5&#xa0;mm 以上離れていなければなりません。</translation>
    </message>
    <message>
        <source>The legs of the dart would cross the outline of %1: put its tip elsewhere.</source>
        <translation>ダーツの辺が %1 の輪郭と交差します。先端を別の場所に置いてください。</translation>
    </message>
    <message>
        <source>Add a dart to %1</source>
        <translation>%1 にダーツを追加</translation>
    </message>
    <message>
        <source>Select the seam of a dart.</source>
        <translation>ダーツの縫い目を選択してください。</translation>
    </message>
    <message>
        <source>Without this dart the outline of %1 would cross itself.</source>
        <translation>このダーツがないと %1 の輪郭が自身と交差します。</translation>
    </message>
    <message>
        <source>Move a dart of %1</source>
        <translation>%1 のダーツを移動</translation>
    </message>
    <message>
        <source>there is no piece in it</source>
        <translation>パーツがありません</translation>
    </message>
    <message>
        <source>Import a pattern of %1 pieces</source>
        <translation>%1 個のパーツの型紙をインポート</translation>
    </message>
    <message>
        <source>%1 is left out: its outline crosses itself or encloses nothing</source>
        <translation>%1 を除外しました: 輪郭が自身と交差するか、面積がありません</translation>
    </message>
    <message>
        <source>%1: %2 notches or lines belong to nothing and are left out</source>
        <translation>%1: %2 個のノッチまたは線は所属先がなく、除外しました</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 points)</source>
        <translation>%1: 型紙の上限を超える量が描かれています (%2 点超)</translation>
    </message>
    <message>
        <source>%1: the file is larger than a pattern can be (%2 MB)</source>
        <translation>%1: ファイルが型紙の上限を超えています (%2&#xa0;MB)</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a group code of DXF</source>
        <translation>%1: 「%2」は DXF のグループコードではありません</translation>
    </message>
    <message>
        <source>%1: the file ends in the middle of something</source>
        <translation>%1: ファイルが途中で終わっています</translation>
    </message>
    <message>
        <source>%1 is not a DXF file: it has no sections</source>
        <translation>%1 は DXF ファイルではありません: セクションがありません</translation>
    </message>
    <message>
        <source>%1 is not an SVG file</source>
        <translation>%1 は SVG ファイルではありません</translation>
    </message>
    <message>
        <source>%1: this is not well-formed XML (%2)</source>
        <translation>%1: 整形式の XML ではありません (%2)</translation>
    </message>
    <message>
        <source>Sew %1 proposed seams</source>
        <translation>提案された縫い目 %1 本を縫う</translation>
    </message>
    <message>
        <source>Remove a dart of %1</source>
        <translation>%1 のダーツを削除</translation>
    </message>
    <message>
        <source>Move the tip of a dart of %1</source>
        <translation>%1 のダーツの先端を移動</translation>
    </message>
    <message>
        <source>Opened there, the outline of %1 would cross itself.</source>
        <translation>そこで開くと %1 の輪郭が自身と交差します。</translation>
    </message>
    <message>
        <source>The legs of the dart must be of one length to be rotated: drag its tip onto the dotted line.</source>
        <translation>ダーツを移動するには両辺が同じ長さでなければなりません。先端を点線上へドラッグしてください。</translation>
    </message>
    <message>
        <source>A dart is rotated to a place at least 5 mm from its mouth.</source>
        <translation>ダーツの移動先は、開きから 5&#xa0;mm 以上離れた場所にしてください。</translation>
    </message>
    <message>
        <source>The line from the tip of the dart to there would leave %1.</source>
        <translation>ダーツの先端からそこまでの線が %1 の外に出ます。</translation>
    </message>
    <message>
        <source>%1 lies across the line from the tip of the dart to there: move it, or rotate the dart elsewhere.</source>
        <translation>ダーツの先端からそこまでの線を %1 が横切っています。それを移動するか、ダーツを別の場所に移してください。</translation>
    </message>
    <message>
        <source>Rotate a dart of %1</source>
        <translation>%1 のダーツを別の位置に移す</translation>
    </message>
    <message>
        <source>Smooth outlines across ends of seams</source>
        <translation>縫い目の端で輪郭を滑らかにする</translation>
    </message>
    <message>
        <source>This seam ends in no corners: there is nothing to smooth.</source>
        <translation>この縫い目は角で終わっていません。滑らかにする所がありません。</translation>
    </message>
    <message>
        <source>The outlines meet at more than 60° there: that is a corner, and stays one.</source>
        <translation>輪郭がそこで 60° を超える角度で出会っています。これは角であり、そのまま残します。</translation>
    </message>
    <message>
        <source>Sew earlier</source>
        <translation>先に縫う</translation>
    </message>
    <message>
        <source>Sew later</source>
        <translation>後で縫う</translation>
    </message>
    <message>
        <source>Sew in the proposed order</source>
        <translation>提案された順に縫う</translation>
    </message>
    <message>
        <source>Change the zip of %1</source>
        <translation>%1 のファスナーを変更</translation>
    </message>
    <message>
        <source>Change when %1 is sewn</source>
        <translation>%1 を縫う順番を変更</translation>
    </message>
    <message>
        <source>its sides have allowances of %1 mm and %2 mm: make them alike, or mind it when they are laid together</source>
        <translation>両側の縫い代が %1&#xa0;mm と %2&#xa0;mm です。揃えるか、重ねるときに注意してください</translation>
    </message>
    <message>
        <source>This edge of %1 is not as long as that.</source>
        <translation>%1 のこの辺はそれほど長くありません。</translation>
    </message>
    <message>
        <source>the pattern is so large that the edge length of its triangles becomes %1 mm; is the unit right?</source>
        <translation>型紙が大きいため、三角形のエッジ長が %1&#xa0;mm になります。単位は正しいですか?</translation>
    </message>
    <message>
        <source>%1 is left out: it is %2 m large, the most is %3 m; is the unit right?</source>
        <translation>%1 を除外しました: 大きさが %2&#xa0;m で、上限は %3&#xa0;m です。単位は正しいですか?</translation>
    </message>
    <message>
        <source>%1 is left out: its outline has fewer than three points</source>
        <translation>%1 を除外しました: 輪郭の点が 3 個未満です</translation>
    </message>
    <message>
        <source>%1 is left out: of the %2 points of its outline no curve with at most %3 can be made</source>
        <translation>%1 を除外しました: 輪郭の %2 点から %3 点以下の曲線を作れません</translation>
    </message>
    <message>
        <source>%1: its outline has more than %2 points and is simplified, by %3 mm at most</source>
        <translation>%1: 輪郭の点が %2 個を超えるため、最大 %3&#xa0;mm の誤差で単純化しました</translation>
    </message>
    <message>
        <source>%1: its quantity &quot;%2&quot; is no number of pieces; it is cut once until somebody says how often</source>
        <translation>%1: 数量「%2」は枚数ではありません。指定があるまで 1 枚裁断します</translation>
    </message>
    <message>
        <source>%1: its quantity %2 is more than possible and becomes %3</source>
        <translation>%1: 数量 %2 は上限を超えるため、%3 にしました</translation>
    </message>
    <message>
        <source>%1: %2 drill holes are narrower than %3 mm or wider than %4 mm and become as wide as possible</source>
        <translation>%1: ドリル穴 %2 個が %3&#xa0;mm より小さいか %4&#xa0;mm より大きいため、可能な最大の大きさにしました</translation>
    </message>
    <message>
        <source>%1 is left out: it would be a patch with mistakes</source>
        <translation>%1 を除外しました: 誤りのあるパーツになります</translation>
    </message>
    <message>
        <source>%1: the file ends in the middle of its section %2, so it is not whole; get it once more</source>
        <translation>%1: ファイルがセクション %2 の途中で終わっており、不完全です。取得し直してください</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 groups)</source>
        <translation>%1: 型紙の上限を超える量が描かれています (%2 グループ超)</translation>
    </message>
    <message>
        <source>%1: %2 is larger than any pattern (%3)</source>
        <translation>%1: %2 は型紙の上限を超える大きさです (%3)</translation>
    </message>
    <message>
        <source>the mark at the end of the file (EOF) is missing: look whether everything is there</source>
        <translation>ファイル末尾の印 (EOF) がありません。すべて揃っているか確認してください</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is inserted more often than a pattern needs (over %3 times)</source>
        <translation>%1: 「%2」の挿入回数が型紙の上限を超えています (%3 回超)</translation>
    </message>
    <message>
        <source>%1: an element has more than %2 attributes</source>
        <translation>%1: 要素の属性が %2 個を超えています</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 elements)</source>
        <translation>%1: 型紙の上限を超える量が描かれています (%2 要素超)</translation>
    </message>
    <message>
        <source>%1: elements lie in each other more than %2 times</source>
        <translation>%1: 要素の入れ子が %2 段を超えています</translation>
    </message>
    <message>
        <source>&quot;%1&quot; would be replaced, which is needed; choose another name</source>
        <translation>必要な「%1」が置き換えられてしまいます。別の名前を選んでください</translation>
    </message>
    <message>
        <source>there is no cover yet: nothing is sewn or solved</source>
        <translation>カバーがまだありません。縫製も計算もされていません</translation>
    </message>
    <message>
        <source>there is not enough memory for this file</source>
        <translation>このファイルにはメモリが足りません</translation>
    </message>
    <message>
        <source>the cover cannot be made a file (%1)</source>
        <translation>カバーをファイルにできません (%1)</translation>
    </message>
    <message>
        <source>the cover is %1 mm thick and has %2 cm³</source>
        <translation>カバーは厚さ %1&#xa0;mm、体積 %2&#xa0;cm³ です</translation>
    </message>
    <message>
        <source>there is no room for foam between the frame and the cover</source>
        <translation>フレームとカバーの間にフォームの入る余地がありません</translation>
    </message>
    <message>
        <source>the foam has %1 l and weighs %2 kg at %3 kg/m³</source>
        <translation>フォームは %1&#xa0;l、%3&#xa0;kg/m³ で %2&#xa0;kg です</translation>
    </message>
    <message>
        <source>there are neither fixation curves nor seams</source>
        <translation>固定曲線も縫い目もありません</translation>
    </message>
    <message>
        <source>The three places lie on a line: choose some that do not.</source>
        <translation>3 つの場所が一直線上にあります。別の場所を選んでください。</translation>
    </message>
    <message>
        <source>The places are not as far from each other on the scan as where they belong: check the scale of the scan, and which is which.</source>
        <translation>スキャン上の各場所の間隔が、合わせ先の間隔と異なります。スキャンの縮尺と、場所の組み合わせを確認してください。</translation>
    </message>
    <message>
        <source>The scan could not be aligned: there are not enough of its points where it would stand. Click other places, or bring back what is cut away of it.</source>
        <translation>スキャンを位置合わせできませんでした。合わせ先にある点が足りません。別の場所をクリックするか、切り取った部分を戻してください。</translation>
    </message>
    <message>
        <source>%1: the numbers of &quot;%2&quot; are not described as they must be: &quot;%3&quot;</source>
        <translation>%1: 「%2」の数値の記述が正しくありません: 「%3」</translation>
    </message>
    <message>
        <source>%1: the file is damaged: something is said to be at byte %2, where nothing can be; copy it again, or export the scan anew</source>
        <translation>%1: ファイルが破損しています。データがあり得ないバイト位置 %2 が指定されています。コピーし直すか、スキャンをエクスポートし直してください</translation>
    </message>
    <message>
        <source>%1: the file is damaged: a checksum is wrong; copy it again, or export the scan anew</source>
        <translation>%1: ファイルが破損しています。チェックサムが一致しません。コピーし直すか、スキャンをエクスポートし直してください</translation>
    </message>
    <message>
        <source>%1 is not an E57 file</source>
        <translation>%1 は E57 ファイルではありません</translation>
    </message>
    <message>
        <source>%1: E57 of version %2 cannot be read, or its pages have another size than 1024; export the scan as E57 1.0</source>
        <translation>%1: E57 バージョン %2 は読み込めないか、ページサイズが 1024 ではありません。スキャンを E57 1.0 でエクスポートしてください</translation>
    </message>
    <message>
        <source>%1: the pose of a scan is no rotation and translation</source>
        <translation>%1: スキャンの姿勢が回転と移動になっていません</translation>
    </message>
    <message>
        <source>%1: two scans are said to be at one place of the file; export them anew</source>
        <translation>%1: 2 つのスキャンがファイルの同じ位置を指しています。エクスポートし直してください</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; of the points is missing or no number of things</source>
        <translation>%1: 点の「%2」がないか、個数ではありません</translation>
    </message>
    <message>
        <source>%1: the file is damaged: a packet of points is not as it must be; export the scan anew</source>
        <translation>%1: ファイルが破損しています。点のパケットが正しくありません。スキャンをエクスポートし直してください</translation>
    </message>
    <message>
        <source>%1: the points are packed by &quot;%2&quot;, which cannot be read; export the scan without an extension</source>
        <translation>%1: 点が、読み込めない「%2」で圧縮されています。拡張なしでスキャンをエクスポートしてください</translation>
    </message>
    <message>
        <source>%1: more is described in it than a scan can have</source>
        <translation>%1: スキャンの上限を超える記述があります</translation>
    </message>
    <message>
        <source>%1: numbers that belong to one point lie too far from each other; export the scan anew</source>
        <translation>%1: 同じ点の数値が離れすぎています。スキャンをエクスポートし直してください</translation>
    </message>
    <message>
        <source>%1: a document type is not expected here</source>
        <translation>%1: 文書型はここでは想定外です</translation>
    </message>
    <message>
        <source>%1 is not a LAS file</source>
        <translation>%1 は LAS ファイルではありません</translation>
    </message>
    <message>
        <source>%1 is compressed (LAZ), which cannot be read: save it as LAS, for example with laszip or CloudCompare, or as E57</source>
        <translation>%1 は圧縮 (LAZ) されており読み込めません。laszip や CloudCompare などで LAS として、または E57 として保存してください</translation>
    </message>
    <message>
        <source>%1: points of format %2 with %3 bytes cannot be read; save them as LAS 1.2 or 1.4</source>
        <translation>%1: %3 バイトの形式 %2 の点は読み込めません。LAS 1.2 または 1.4 で保存してください</translation>
    </message>
    <message>
        <source>%1: its scale and offset make no points</source>
        <translation>%1: 縮尺とオフセットから点が得られません</translation>
    </message>
    <message>
        <source>%1: the points are said to begin within the header</source>
        <translation>%1: 点の開始位置がヘッダーの中を指しています</translation>
    </message>
    <message>
        <source>The second side ends inside an edge, so the first one was changed.</source>
        <translation>2 番目の側が辺の途中で終わるため、1 番目の側を変更しました。</translation>
    </message>
    <message>
        <source>it has no triangle with an area</source>
        <translation>面積のある三角形がありません</translation>
    </message>
    <message>
        <source>%1 is left out: laid flat it would lie over itself. Divide it, or cut it in where it bulges most</source>
        <translation>%1 を除外しました: 平らに展開すると自身と重なります。分割するか、最もふくらんだ所に切り込みを入れてください</translation>
    </message>
    <message>
        <source>the stretch does not lie on its outline any more. Sew or fix it anew.</source>
        <translation>区間が輪郭上から外れました。縫い直すか、固定し直してください。</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which reads such files for Bolster, cannot be started; install Bolster again</source>
        <translation>Bolster 用にこの種のファイルを読み込むプログラム「%1」を起動できません。Bolster を再インストールしてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes too long to read; export fewer parts of it, or triangles (OBJ, STL) instead</source>
        <translation>「%1」の読み込みに時間がかかりすぎます。エクスポートする部品を減らすか、三角形 (OBJ、STL) にしてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be read: it is damaged, or needs too much memory; export it again, or fewer parts of it, from the program that it comes from</source>
        <translation>「%1」を読み込めませんでした。破損しているか、メモリを使いすぎます。元のプログラムからエクスポートし直すか、部品を減らしてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds no faces, and a frame needs some; export bodies or surfaces, not lines and points alone</source>
        <translation>「%1」に面がありません。フレームには面が必要です。線と点だけでなく、ボディまたはサーフェスをエクスポートしてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than %2 triangles; export fewer parts of it, or coarser</source>
        <translation>「%1」の三角形が %2 個を超えています。部品を減らすか、粗くしてエクスポートしてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than %2 parts; export those that the cover touches</source>
        <translation>「%1」の部品が %2 個を超えています。カバーが触れるものだけエクスポートしてください</translation>
    </message>
    <message>
        <source>%1: the part &quot;%2&quot; reaches beyond 10,000,000; export it without that part, or near the origin</source>
        <translation>%1: 部品「%2」が 10,000,000 を超えています。その部品なしで、または原点の近くでエクスポートしてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs the file &quot;%2&quot; in its own folder; copy it there, or export as GLB, which is one file</source>
        <translation>「%1」には同じフォルダーにファイル「%2」が必要です。コピーするか、1 ファイルになる GLB でエクスポートしてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged or incomplete, or not what its ending says; export it again from the program that it comes from</source>
        <translation>「%1」は破損または不完全か、内容が拡張子と異なります。元のプログラムからエクスポートし直してください</translation>
    </message>
    <message>
        <source>%1: %2 triangles are left out: their corners are no numbers</source>
        <translation>%1: %2 個の三角形を除外しました: 角が数値ではありません</translation>
    </message>
    <message>
        <source>%1: parts are left out that are scaled to nothing: %2, the first is &quot;%3&quot;</source>
        <translation>%1: 縮尺がゼロの部品を除外しました: %2 個、最初は「%3」</translation>
    </message>
    <message>
        <source>%1: %2 faces could not be made triangles of, and leave holes</source>
        <translation>%1: %2 枚の面を三角形にできず、穴が残ります</translation>
    </message>
    <message>
        <source>%1: %2 parts are left out that lie too deep in the tree</source>
        <translation>%1: 階層が深すぎる部品 %2 個を除外しました</translation>
    </message>
    <message>
        <source>%1: the parts in the file &quot;%2&quot; are not read; export all in one file</source>
        <translation>%1: ファイル「%2」の部品は読み込まれません。すべてを 1 ファイルにエクスポートしてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no file that frames are written to; OBJ, PLY and STL are</source>
        <translation>「%1」はフレームを書き出せるファイルではありません。OBJ、PLY、STL が可能です</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a scan that can be read; these can: %2</source>
        <translation>「%1」は読み込めるスキャンではありません。読み込めるもの: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a frame that can be read; these can: %2</source>
        <translation>「%1」は読み込めるフレームではありません。読み込めるもの: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a pattern that can be read; these can: %2</source>
        <translation>「%1」は読み込める型紙ではありません。読み込めるもの: %2</translation>
    </message>
    <message>
        <source>nothing is left of the parts that are wanted</source>
        <translation>必要な部品が何も残りません</translation>
    </message>
    <message>
        <source>nothing is sewn where %1 of its notches are, so they have no partners</source>
        <translation>ノッチのうち %1 個は縫われていない場所にあり、相手がありません</translation>
    </message>
    <message>
        <source>notches at edges without an allowance cut into the piece: there are %1; give these edges an allowance</source>
        <translation>縫い代のない辺のノッチはパーツに切り込みます (%1 個)。これらの辺に縫い代を付けてください</translation>
    </message>
    <message>
        <source>There is a dart already: put this one beside it, or remove that one first.</source>
        <translation>すでにダーツがあります。これを横に置くか、先にそのダーツを削除してください。</translation>
    </message>
    <message>
        <source>%1 is left out: with its holes, notches and lines the design would have more than %2 elements</source>
        <translation>%1 を除外しました: その穴、ノッチ、線を含めるとデザインの要素が %2 個を超えます</translation>
    </message>
    <message>
        <source>%1: its nap &quot;%2&quot; is neither one way, two ways nor any; it is taken for two ways</source>
        <translation>%1: 毛並み「%2」は一方向、二方向、全方向のいずれでもありません。二方向とみなします</translation>
    </message>
    <message>
        <source>%1 is drawn larger by what its fabric shrinks (%2), and taken as it is drawn: a shrinkage of the fabric here would come on top</source>
        <translation>%1 は生地の縮み (%2) の分だけ大きく描かれており、そのまま取り込みます。ここで生地の縮みを設定すると二重になります</translation>
    </message>
    <message>
        <source>the viewBox &quot;%1&quot; is no four numbers and is left out: check the size of the pieces</source>
        <translation>viewBox「%1」は 4 つの数値でないため無視しました。パーツのサイズを確認してください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs the file &quot;%2&quot; beside it, and the frame of a design is one file; import it again, or export it as GLB</source>
        <translation>「%1」には隣にファイル「%2」が必要ですが、デザインのフレームは 1 ファイルです。インポートし直すか、GLB でエクスポートしてください</translation>
    </message>
    <message>
        <source>99 % of its surface is within %1 mm</source>
        <translation>面の 99&#xa0;% が %1&#xa0;mm 以内にあります</translation>
    </message>
    <message>
        <source>it reaches beyond its piece: end it at the edge</source>
        <translation>パーツからはみ出しています。端で終わらせてください</translation>
    </message>
    <message>
        <source>the hole breaks through the edge of its piece: move it inwards, or make it smaller</source>
        <translation>穴がパーツの端を突き破っています。内側へ移動するか、小さくしてください</translation>
    </message>
    <message>
        <source>only %1 mm are left of the piece at the tip of a dart: make it shorter</source>
        <translation>ダーツの先端でパーツが %1&#xa0;mm しか残りません。ダーツを短くしてください</translation>
    </message>
    <message>
        <source>%1 of its notches have no partners on the other sides of their seams: others are too near there. Ask for fewer</source>
        <translation>ノッチのうち %1 個は、縫い目の反対側で他のノッチが近すぎ、相手がありません。数を減らしてください</translation>
    </message>
    <message>
        <source>%1 has %2 sewing lines beside each other; the largest is taken, the others are left out</source>
        <translation>%1 には出来上がり線が %2 本並んでいます。最大のものを使い、他は除外しました</translation>
    </message>
    <message>
        <source>%1: its cut line lies %2 mm outside of its sewing line, which is wider than an allowance may be; it becomes %3 mm there</source>
        <translation>%1: 裁断線が出来上がり線の %2&#xa0;mm 外側にあり、縫い代の上限を超えています。そこは %3&#xa0;mm にしました</translation>
    </message>
    <message>
        <source>The cover is pulled to the scan where it lies now: switch &quot;Fit the cover to it&quot; off, place it, and switch that on again.</source>
        <translation>カバーは現在の位置のスキャンに引き寄せられています。「カバーを合わせる」をオフにして配置し、再びオンにしてください。</translation>
    </message>
    <message>
        <source>Place on the cover to %2 mm rms: %1 (%3 % of its points matched)</source>
        <translation>カバーに位置合わせ、RMS %2&#xa0;mm: %1 (点の %3&#xa0;% が対応)</translation>
    </message>
    <message>
        <source>The scan could not be placed: it is too far from the cover. Align it by three places, or cut away what does not belong to it.</source>
        <translation>スキャンを合わせられませんでした。カバーから遠すぎます。3 か所で位置合わせするか、無関係な部分を切り取ってください。</translation>
    </message>
    <message>
        <source>Align to %2 mm rms: %1 (%3 % of its points matched)</source>
        <translation>位置合わせ、RMS %2&#xa0;mm: %1 (点の %3&#xa0;% が対応)</translation>
    </message>
    <message>
        <source>Import the pattern of %1</source>
        <translation>%1 の型紙をインポート</translation>
    </message>
    <message>
        <source>%1: a gap of %2 mm in its outline is closed by a straight line</source>
        <translation>%1: 輪郭の %2&#xa0;mm のすき間を直線で閉じました</translation>
    </message>
    <message>
        <source>%1: its cut line is drawn anew from its allowances, and differs from that of the file by up to %2 mm</source>
        <translation>%1: 裁断線を縫い代から描き直しました。ファイルの裁断線との差は最大 %2&#xa0;mm です</translation>
    </message>
    <message>
        <source>the size &quot;%1&quot; of the page is in no unit that is known and is left out: check the size of the pieces</source>
        <translation>ページのサイズ「%1」の単位が不明なため無視しました。パーツのサイズを確認してください</translation>
    </message>
    <message>
        <source>Sew a proposed seam</source>
        <translation>提案された縫い目を縫う</translation>
    </message>
    <message>
        <source>it is in %1 pieces</source>
        <translation>%1 個に分かれています</translation>
    </message>
    <message>
        <source>one piece of less than 1 cm³ is left out</source>
        <translation>1&#xa0;cm³ 未満の 1 個を除外しました</translation>
    </message>
    <message>
        <source>%1 pieces of less than 1 cm³ are left out</source>
        <translation>1&#xa0;cm³ 未満の %1 個を除外しました</translation>
    </message>
    <message>
        <source>Change whether the cover fits %1</source>
        <translation>カバーを %1 に合わせるかどうかを変更</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs too much memory: it has too many parts, or places them too often; export those that the cover touches</source>
        <translation>「%1」はメモリを使いすぎます。部品が多すぎるか、配置回数が多すぎます。カバーが触れるものだけエクスポートしてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has decimal commas; export it with decimal points</source>
        <translation>「%1」の小数点がコンマです。ピリオドでエクスポートしてください</translation>
    </message>
    <message>
        <source>%1: triangles are left out that name points which are not in the file</source>
        <translation>%1: ファイルにない点を参照する三角形を除外しました</translation>
    </message>
    <message>
        <source>%1: %2 triangles are left out: they name points that are not in the file</source>
        <translation>%1: %2 個の三角形を除外しました: ファイルにない点を参照しています</translation>
    </message>
    <message>
        <source>%1: none of its %2 points has a place</source>
        <translation>%1: %2 個の点のどれにも位置がありません</translation>
    </message>
    <message>
        <source>%1: %2 points are left out: they have no place, as where a scanner saw nothing</source>
        <translation>%1: %2 個の点を除外しました: スキャナーに写らなかった所など、位置がありません</translation>
    </message>
    <message>
        <source>%1 is text in UTF-16, which is not read; save it as UTF-8</source>
        <translation>%1 は UTF-16 のテキストで、読み込めません。UTF-8 で保存してください</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; has a decimal comma; export with decimal points</source>
        <translation>%1: 「%2」の小数点がコンマです。ピリオドでエクスポートしてください</translation>
    </message>
    <message>
        <source>Make the pattern of a form</source>
        <translation>形状から型紙を作成</translation>
    </message>
    <message>
        <source>Fit the pattern to a goal</source>
        <translation>型紙を目標に合わせる</translation>
    </message>
    <message>
        <source>it has %1 triangles, and cannot be made simpler</source>
        <translation>三角形が %1 個あり、これ以上単純化できません</translation>
    </message>
    <message>
        <source>The form has %1 triangles; %2 stand for it, which are up to %3 mm off</source>
        <translation>形状の三角形は %1 個です。これを %2 個で代用し、誤差は最大 %3&#xa0;mm です</translation>
    </message>
    <message>
        <source>%1 ends inside a piece, at %2: it is cut in there like a dart. The next line or border is %3 mm away; draw it on to there to divide the piece</source>
        <translation>%1 がパーツの内側の %2 で終わっています。そこはダーツのように切り込みます。次の線または境界まで %3&#xa0;mm です。パーツを分けるにはそこまで延ばしてください</translation>
    </message>
    <message>
        <source>No place of the cover is near the form: put it where the cover is, in millimetres.</source>
        <translation>カバーに形状の近くの場所がありません。カバーのある場所に置いてください (単位 mm)。</translation>
    </message>
    <message>
        <source>Nothing that may change does anything to the cover.</source>
        <translation>変更できるものの中に、カバーに影響するものがありません。</translation>
    </message>
    <message>
        <source>A step would have turned the outline of %1 over itself; a smaller one was taken</source>
        <translation>%1 の輪郭が裏返るため、より小さいステップにしました</translation>
    </message>
    <message>
        <source>Nothing may change.</source>
        <translation>変更できるものがありません。</translation>
    </message>
    <message>
        <source>The cover does not come to rest.</source>
        <translation>カバーが静止しません。</translation>
    </message>
    <message>
        <source>Make %1 longer by %3 mm where it is sewn to %2</source>
        <translation>%2 に縫う所で %1 を %3&#xa0;mm 長くする</translation>
    </message>
    <message>
        <source>Make %1 shorter by %3 mm where it is sewn to %2</source>
        <translation>%2 に縫う所で %1 を %3&#xa0;mm 短くする</translation>
    </message>
    <message>
        <source>Move the seam of %1 and %2 by %3 mm into %2</source>
        <translation>%1 と %2 の縫い目を %2 側へ %3&#xa0;mm 移動</translation>
    </message>
    <message>
        <source>Move the seam of %1 and %2 by %3 mm into %1</source>
        <translation>%1 と %2 の縫い目を %1 側へ %3&#xa0;mm 移動</translation>
    </message>
    <message>
        <source>Let out the corner of %1 at %2 by %3 mm</source>
        <translation>%1 の角を %2 で %3&#xa0;mm 出す</translation>
    </message>
    <message>
        <source>Take in the corner of %1 at %2 by %3 mm</source>
        <translation>%1 の角を %2 で %3&#xa0;mm 詰める</translation>
    </message>
    <message>
        <source>Cut a dart into %1 at %2, %3 mm wide and %4 mm deep</source>
        <translation>%1 の %2 に幅 %3&#xa0;mm、深さ %4&#xa0;mm のダーツをとる</translation>
    </message>
    <message>
        <source>Make the seam of %1 and %2 smooth</source>
        <translation>%1 と %2 の縫い目を滑らかにする</translation>
    </message>
    <message>
        <source>Let the seam of %1 and %2 be sharp</source>
        <translation>%1 と %2 の縫い目を鋭くする</translation>
    </message>
    <message>
        <source>it is no file of preferences: it breaks off or has a mistake at character %1; choose one that Bolster has exported</source>
        <translation>環境設定ファイルではありません。%1 文字目で途切れているか、誤りがあります。Bolster がエクスポートしたものを選んでください</translation>
    </message>
    <message>
        <source>it is no file of preferences; choose one that Bolster has exported</source>
        <translation>環境設定ファイルではありません。Bolster がエクスポートしたものを選んでください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be what it is there; remove that line from the file, or export it again</source>
        <translation>「%1」は書かれている値にできません。その行をファイルから削除するか、エクスポートし直してください</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, where a portable Bolster keeps settings and work, cannot be written; copy its folder to where you may write</source>
        <translation>ポータブル版 Bolster が設定と作業を保存する「%1」に書き込めません。フォルダーを書き込み可能な場所へコピーしてください</translation>
    </message>
    <message>
        <source>the disk with &quot;%1&quot; is full; make room on it, and change a setting once more: all of them are kept then</source>
        <translation>「%1」のあるディスクがいっぱいです。空きを作り、設定をもう一度変えると、すべて保存されます</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be written; give yourself the right to write there and in its folder, and change a setting once more: all of them are kept then</source>
        <translation>「%1」に書き込めませんでした。そのファイルとフォルダーへの書き込みを許可し、設定をもう一度変えると、すべて保存されます</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands there twice; remove one of its lines from the file, or export it again</source>
        <translation>「%1」が 2 回あります。ファイルから 1 行を消すか、もう一度書き出してください</translation>
    </message>
    <message>
        <source>Change the note of %1</source>
        <translation>%1 のメモを変更</translation>
    </message>
    <message>
        <source>Add measurement %1</source>
        <translation>測定 %1 を追加</translation>
    </message>
    <message>
        <source>it does not lie in &quot;%1&quot; any more; measure anew</source>
        <translation>「%1」の中にありません。測り直してください</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; holds other files: choose one of its own.</source>
        <translation>フォルダー「%1」には他のファイルがあります。専用のフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; holds the work of another design or of other options: choose another folder.</source>
        <translation>フォルダー「%1」には別のデザインまたは別のオプションの結果があります。別のフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be made (%2).</source>
        <translation>フォルダー「%1」を作成できません (%2)。</translation>
    </message>
    <message>
        <source>Remove %1 and what needs it (%2 elements)</source>
        <translation>%1 とそれに依存するもの (%2 要素) を削除</translation>
    </message>
    <message>
        <source>one version was saved</source>
        <translation>1 個のバージョンを復旧しました</translation>
    </message>
    <message>
        <source>%1: none of its triangles has an area</source>
        <translation>%1: 面積のある三角形がありません</translation>
    </message>
    <message>
        <source>Where a piece would have had a hole or been a ring it is cut and sewn again, number of cuts: %1</source>
        <translation>穴や輪になるパーツは切り開いて縫い直しています。切り込みの数: %1</translation>
    </message>
    <message>
        <source>%1 is stretched by %2 % along the grain, its fabric allows %3 %</source>
        <translation>%1 は地の目方向に %2&#xa0;% 伸びています。生地の許容は %3&#xa0;% です</translation>
    </message>
    <message>
        <source>%1 is stretched by %2 % across the grain, its fabric allows %3 %</source>
        <translation>%1 は直交方向に %2&#xa0;% 伸びています。生地の許容は %3&#xa0;% です</translation>
    </message>
    <message>
        <source>%1 is sheared by %2 %, its fabric allows %3 %</source>
        <translation>%1 は %2&#xa0;% せん断されています。生地の許容は %3&#xa0;% です</translation>
    </message>
    <message>
        <source>The form has one side only, as a twisted band: it is left open where its outside meets its inside</source>
        <translation>形状はねじれた帯のように片面しかありません。表と裏が出会う所は開いたままにします</translation>
    </message>
    <message>
        <source>Parts of %1 that are shorter than a mesh edge have gone with the cut.</source>
        <translation>%1 のうちメッシュの辺より短い部分は切断でなくなりました。</translation>
    </message>
    <message>
        <source>the usual value is used instead</source>
        <translation>代わりに通常の値が使われます</translation>
    </message>
    <message>
        <source>it is the project that is open here; choose another name</source>
        <translation>ここで開いているプロジェクトです。別の名前を選んでください</translation>
    </message>
    <message>
        <source>the file is empty; nothing was written to it, or it was lost</source>
        <translation>ファイルが空です。何も書き込まれなかったか、内容が失われました</translation>
    </message>
    <message>
        <source>it is open in another window; choose another name</source>
        <translation>別のウィンドウで開かれています。ほかの名前を選んでください</translation>
    </message>
    <message>
        <source>the disk of &quot;%1&quot; is full, where work is protected from crashes; make room, and open it again</source>
        <translation>作業をクラッシュから守る場所「%1」のディスクがいっぱいです。空きを作り、もう一度開いてください</translation>
    </message>
    <message>
        <source>The form is %1 mm large: with edges of %2 mm its cover has more triangles than can be solved. See whether the unit is right; else make the mesh edges at least %3 mm long</source>
        <translation>形状の大きさは %1 mm です。辺の長さ %2 mm では、カバーの三角形が多すぎて解けません。単位が正しいか確認し、正しければメッシュの辺を %3 mm 以上にしてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already; choose another name</source>
        <translation>「%1」はすでにあります。別の名前を選んでください</translation>
    </message>
    <message>
        <source>%1 is strained by %2 % when it lies on the form, more than any fabric bears. Divide it, or cut it in where it bulges most</source>
        <translation>%1 は形状の上で %2 % ひずみ、どの布地の限度も超えます。分割するか、最もふくらむ所に切り込みを入れてください</translation>
    </message>
    <message>
        <source>Let no scan pull at the cover</source>
        <translation>スキャンがカバーを引かないようにする</translation>
    </message>
    <message>
        <source>%1 bends too sharply at %2: it is not cut along it</source>
        <translation>%1 は %2 で急に曲がりすぎているため、これに沿って切りません</translation>
    </message>
    <message>
        <source>The form goes through itself at %2: it is not cut along %1</source>
        <translation>形が %2 で自身と交差しているため、%1 に沿って切りません</translation>
    </message>
    <message>
        <source>What is closed all around has no border to be held at: its cover is fixed along its seams. Delete the fixations of those that are to be free</source>
        <translation>全周が閉じたものには留める縁がないため、カバーを縫い目に沿って固定しました。自由にする縫い目の固定は削除してください</translation>
    </message>
    <message>
        <source>No vertex of the area is near the form: make the area larger than the mesh edges, or put the form where the cover is.</source>
        <translation>範囲の頂点が形状の近くにありません。範囲をメッシュの辺より大きくするか、形状をカバーのある場所に置いてください。</translation>
    </message>
    <message>
        <source>%1 is left out: it is too narrow to be sewn. Join it to what lies beside it</source>
        <translation>%1 を除外しました: 縫うには幅が狭すぎます。隣のものと一つにしてください</translation>
    </message>
    <message>
        <source>Make the pattern of a form again</source>
        <translation>形状から型紙を作り直す</translation>
    </message>
    <message>
        <source>Make the pattern of %1 again</source>
        <translation>%1 から型紙を作り直す</translation>
    </message>
    <message>
        <source>Make the pattern of %1</source>
        <translation>%1 から型紙を作成</translation>
    </message>
    <message>
        <source>Fit the pattern to %1, %2 mm from it</source>
        <translation>型紙を %1 に合わせる (差 %2&#xa0;mm)</translation>
    </message>
    <message>
        <source>Fit the pattern to %1</source>
        <translation>型紙を %1 に合わせる</translation>
    </message>
    <message>
        <source>Fit the pattern to a limit of strain, %1 % of the cover over it</source>
        <translation>型紙をひずみの限界に合わせる (カバーの %1&#xa0;% が超過)</translation>
    </message>
    <message>
        <source>Let the scan pull at the cover again</source>
        <translation>スキャンが再びカバーを引くようにする</translation>
    </message>
    <message>
        <source>%1 runs along %2, at %3: it is cut there once</source>
        <translation>%1 は %3 で %2 に沿っています。そこは 1 回だけ切ります</translation>
    </message>
    <message>
        <source>%1 runs along the border of the form, or where it is cut anyway, at %2: there is nothing to cut</source>
        <translation>%1 は %2 で形状の縁、またはすでに切る所に沿っています。切るものはありません</translation>
    </message>
    <message>
        <source>%1 is too short or too long, at %2: it is not cut along it</source>
        <translation>%2 の %1 は短すぎるか長すぎるため、これに沿って切りません</translation>
    </message>
    <message>
        <source>%1 is %2 mm away from the form, at %3: it is not cut along it</source>
        <translation>%1 は %3 で形状から %2&#xa0;mm 離れているため、これに沿って切りません</translation>
    </message>
    <message>
        <source>lines cannot be cut into it: it has edges where more than two faces meet, or sheets that touch in a point, at %1</source>
        <translation>線で切り込めません: %1 に、3 枚以上の面が出会うエッジ、または点で接する面があります</translation>
    </message>
    <message>
        <source>%1 cannot be cut into it, at %2: the form goes through itself there</source>
        <translation>%2 で %1 に沿って切り込めません: 形状がそこで自身と交差しています</translation>
    </message>
    <message>
        <source>Small for the triangles of the cover, whose edges are %1 mm long: %2. Their shape will be coarse; with mesh edges of %3 mm it is not</source>
        <translation>カバーの三角形（辺の長さ %1&#xa0;mm）に対して小さいパーツ: %2。形が粗くなります。メッシュの辺を %3&#xa0;mm にすれば粗くなりません</translation>
    </message>
    <message>
        <source>Too small for the triangles of the cover, whose edges are %1 mm long: %2. Join them to what lies beside them, or leave them out</source>
        <translation>カバーの三角形（辺の長さ %1&#xa0;mm）に対して小さすぎるパーツ: %2。隣のものと一つにするか、除外してください</translation>
    </message>
    <message>
        <source>After %1 iterations it cannot be told yet where the surface comes to rest. Allow more iterations.</source>
        <translation>%1 回の反復後も、面がどこで静止するかまだわかりません。反復回数を増やしてください。</translation>
    </message>
    <message>
        <source>Wider across the grain than the fabric, of which %1 mm can be used: %2. Divide them, or turn their grain</source>
        <translation>地の目に直交する幅が生地の使用可能幅 %1 mm を超えています: %2。分割するか、地の目を回してください</translation>
    </message>
    <message>
        <source>%1 ends inside a piece, at %2: it is cut in there like a dart. There is no other line or border; lead it around to where it began to divide the piece</source>
        <translation>%1 がパーツの内側の %2 で終わっています。そこはダーツのように切り込みます。ほかの線や境界はありません。パーツを分けるには始点まで一周させてください</translation>
    </message>
    <message>
        <source>A line is not cut in at %1: the sides of the cut would lie over each other when it is laid flat. Draw it elsewhere, or on to a border</source>
        <translation>%1 では線を切り込みません。平らにすると切り込みの両側が重なります。別の場所に引くか、境界まで延ばしてください</translation>
    </message>
    <message>
        <source>A line is not cut in at %1: the piece was divided another way. Draw it on to a border</source>
        <translation>%1 では線を切り込みません。パーツが別の形に分割されました。境界まで延ばしてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no design, but what one is made of: import it</source>
        <translation>「%1」はデザインではなく、その材料となるファイルです。インポートしてください</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by %2 mm in each: it does not come to rest. Make curves as long as the outlines they hold, or try other mesh edges.</source>
        <translation>%1 回の反復後も、面が毎回 %2&#xa0;mm 動き、静止しません。曲線を、保持する輪郭と同じ長さにするか、メッシュのエッジの長さを変えてみてください。</translation>
    </message>
    <message>
        <source>%1, with what is sewn to it, is held only at a border of %2 mm: fix it along other curves, too, or close that hole of the form</source>
        <translation>%1 とそれに縫われたものは %2&#xa0;mm の縁だけで支えられています: ほかの曲線でも固定するか、形の穴をふさいでください</translation>
    </message>
    <message>
        <source>%1 is left out: it is closed all around and cannot be laid flat. Cut it along lines</source>
        <translation>%1 を除外しました: 全周が閉じていて平らに展開できません。線に沿って切ってください</translation>
    </message>
    <message>
        <source>%1 is left out: it has a handle, like a cup, and cannot be laid flat. Cut it along lines</source>
        <translation>%1 を除外しました: カップのような取っ手があり平らに展開できません。線に沿って切ってください</translation>
    </message>
    <message>
        <source>Let out %1 by %3 mm where it is sewn to %2</source>
        <translation>%2 に縫う所で %1 を %3&#xa0;mm 出す</translation>
    </message>
    <message>
        <source>Take in %1 by %3 mm where it is sewn to %2</source>
        <translation>%2 に縫う所で %1 を %3&#xa0;mm 詰める</translation>
    </message>
    <message>
        <source>Let out %1 by %3 mm where the curve %2 holds it</source>
        <translation>曲線 %2 が固定する所で %1 を %3&#xa0;mm 出す</translation>
    </message>
    <message>
        <source>Take in %1 by %3 mm where the curve %2 holds it</source>
        <translation>曲線 %2 が固定する所で %1 を %3&#xa0;mm 詰める</translation>
    </message>
    <message>
        <source>What would not lie flat, or be strained by more than the fabric may be, is divided, which makes so many pieces more: %1</source>
        <translation>平らにならない所、または生地の許容を超えて伸びる所を分割しました。増えたパーツの数: %1</translation>
    </message>
    <message>
        <source>%1 is not divided: more than %2 pieces would be needed until it lies flat. It is rough, as scans are: smooth it, or fit a cover to it and take that</source>
        <translation>%1 は分割しません: 平らになるまでに %2 個より多くのパーツが必要です。スキャンのように粗いためです。滑らかにするか、それにカバーを合わせて、そのカバーを使ってください</translation>
    </message>
    <message>
        <source>%1 is left out: it has more than %2 holes. Close them, or cut it along lines</source>
        <translation>%1 を除外しました: 穴が %2 個より多くあります。穴をふさぐか、線に沿って切ってください</translation>
    </message>
    <message>
        <source>Too narrow for the triangles of the cover, whose edges are %1 mm long, so that it cannot be solved: %2. Make the mesh edges shorter, or join them to what lies beside them</source>
        <translation>カバーの三角形（辺の長さ %1&#xa0;mm）に対して幅が狭すぎ、カバーを計算できないパーツ: %2。メッシュの辺を短くするか、隣のものと一つにしてください</translation>
    </message>
    <message>
        <source>Lead open seam lines on</source>
        <translation>開いた縫い目線を延ばす</translation>
    </message>
    <message>
        <source>Lead %1 on</source>
        <translation>%1を延ばす</translation>
    </message>
    <message>
        <source>Bodies of the form go through each other, as at %1: what of one lies inside of another one is covered, too, and pushed out. Unite them before, or leave one out. Number of such pairs: %2</source>
        <translation>形状の立体どうしが互いに突き抜けています（例：%1）。一方のうち他方の内側にある部分もカバーされ、外へ押し出されます。先に合体させるか、一方を除いてください。そのような組の数：%2</translation>
    </message>
    <message>
        <source>Faces of the form that lie where another one lies, and are left out: %1</source>
        <translation>他の面と同じ場所にあるため除かれた形状の面：%1</translation>
    </message>
    <message>
        <source>Faces of the form that were turned round: %1</source>
        <translation>向きを裏返した形状の面：%1</translation>
    </message>
    <message>
        <source>Edges of the form that belong to more than two faces, so that they are borders and nothing is sewn there: %1</source>
        <translation>三つ以上の面に属するため縁となり、そこでは何も縫われない形状の辺：%1</translation>
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
        <translation>中ボタン</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>右ボタン</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>ドラッグ</translation>
    </message>
    <message>
        <source>two fingers</source>
        <translation>2 本指の操作</translation>
    </message>
    <message>
        <source>pinch or Ctrl+wheel</source>
        <translation>ピンチまたは Ctrl+ホイール</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>ホイール</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>CAD (like SolidWorks)</source>
        <translation>CAD (SolidWorks 風)</translation>
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
        <translation>タッチパッド</translation>
    </message>
</context>
<context>
    <name>NotchForm</name>
    <message>
        <source>Patch</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>From the corner</source>
        <translation>角から</translation>
    </message>
    <message>
        <source>Along the outline from the nearer corner, on the same side of it.</source>
        <translation>近い方の角から輪郭に沿って、角と同じ側。</translation>
    </message>
</context>
<context>
    <name>OrientationFields</name>
    <message>
        <source>Free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Normal held</source>
        <translation>法線を固定</translation>
    </message>
    <message>
        <source>Tangent plane held</source>
        <translation>接平面を固定</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>傾き</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>%1 directions, interpolated along the curve; the first is shown.</source>
        <translation>%1 個の方向 (曲線に沿って補間)。最初のものを表示。</translation>
    </message>
</context>
<context>
    <name>OutlineTool</name>
    <message>
        <source>This cannot be a patch: %1</source>
        <translation>パーツにできません: %1</translation>
    </message>
    <message>
        <source>The outline would cross itself here – Backspace takes a point back</source>
        <translation>ここで輪郭が自身と交差します。Backspace で点を取り消す</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no length: try 500, 500&lt;30 or 120, 40</source>
        <translation>「%1」は長さではありません (例: 500、500&lt;30、120, 40)</translation>
    </message>
    <message>
        <source>Click to set the first corner, press and drag for a smooth point – Esc ends the tool</source>
        <translation>クリックで最初の角、押してドラッグで滑らかな点。Esc でツールを終了</translation>
    </message>
    <message>
        <source>Click to close the outline</source>
        <translation>クリックで輪郭を閉じる</translation>
    </message>
    <message>
        <source>Enter sets the point: 500 goes that far, 500&lt;30 at an angle, 120, 40 to the right and up</source>
        <translation>Enter で点を設定: 500 は距離、500&lt;30 は角度付き、120, 40 は右と上</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, or type a length – Ctrl does not snap</source>
        <translation>クリックで角、ドラッグで滑らかな点、または長さを入力。Ctrl でスナップしない</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, type a length – Enter or a click on the first point closes, Backspace takes a point back</source>
        <translation>クリックで角、ドラッグで滑らかな点、長さも入力可。Enter か最初の点のクリックで閉じる、Backspace で点を取り消す</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
</context>
<context>
    <name>OutlineTrimForm</name>
    <message>
        <source>Outline</source>
        <translation>輪郭</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
</context>
<context>
    <name>PatchDrawingTool</name>
    <message>
        <source>Patch %1</source>
        <translation>パーツ %1</translation>
    </message>
    <message>
        <source>An outline needs at least three points in different places.</source>
        <translation>輪郭には、異なる位置に少なくとも 3 点が必要です。</translation>
    </message>
    <message>
        <source>This cannot be a patch: %1</source>
        <translation>パーツにできません: %1</translation>
    </message>
</context>
<context>
    <name>PatchForm</name>
    <message>
        <source>Outline</source>
        <translation>輪郭</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>Width and height as it lies in the pattern view.</source>
        <translation>型紙ビューに置かれた状態の幅と高さ。</translation>
    </message>
</context>
<context>
    <name>PatternDrawTool</name>
    <message>
        <source>Begin inside a patch.</source>
        <translation>パーツの内側から始めてください。</translation>
    </message>
    <message>
        <source>Fancy seam %1</source>
        <translation>飾り縫い %1</translation>
    </message>
    <message>
        <source>Handle %1</source>
        <translation>ハンドル %1</translation>
    </message>
    <message>
        <source>A curve needs two points, a closed one three.</source>
        <translation>曲線には 2 点、閉じた曲線には 3 点が必要です。</translation>
    </message>
    <message>
        <source>There is no surface in this patch yet on which the handle could lie.</source>
        <translation>このパーツには、ハンドル曲線を置ける面がまだありません。</translation>
    </message>
    <message>
        <source>Click inside a patch to begin a handle curve – Esc ends the tool</source>
        <translation>パーツ内をクリックしてハンドル曲線を開始。Esc でツールを終了</translation>
    </message>
    <message>
        <source>Click inside a patch or on its outline to begin a fancy seam – Esc ends the tool</source>
        <translation>パーツ内または輪郭上をクリックして飾り縫いを開始。Esc でツールを終了</translation>
    </message>
    <message>
        <source>Click to close the curve</source>
        <translation>クリックで曲線を閉じる</translation>
    </message>
    <message>
        <source>Click for the next point, double click or Enter ends – B makes it straight, Backspace takes a point back</source>
        <translation>クリックで次の点、ダブルクリックか Enter で終了。B で直線、Backspace で点を取り消す</translation>
    </message>
    <message>
        <source>Click for the next point, double click or Enter ends – B makes it smooth, Backspace takes a point back</source>
        <translation>クリックで次の点、ダブルクリックか Enter で終了。B で滑らかに、Backspace で点を取り消す</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>線 %1</translation>
    </message>
    <message>
        <source>Click inside a patch or on its outline to begin a line for the cutter – Esc ends the tool</source>
        <translation>パーツ内または輪郭上をクリックして裁断用の線を開始。Esc でツールを終了</translation>
    </message>
</context>
<context>
    <name>PatternPdf</name>
    <message>
        <source>1 inch</source>
        <translation>1 インチ</translation>
    </message>
    <message>
        <source>Print at 100 %</source>
        <translation>100&#xa0;% で印刷</translation>
    </message>
    <message>
        <source>%1 – print at 100 %</source>
        <translation>%1 – 100&#xa0;% で印刷</translation>
    </message>
    <message>
        <source>Overview of %1 x %2 sheets</source>
        <translation>全体図 %1 x %2 枚</translation>
    </message>
    <message>
        <source>%1: sheet %2</source>
        <translation>%1: シート %2</translation>
    </message>
    <message>
        <source>%1: sheets %2 to %3</source>
        <translation>%1: シート %2 ～ %3</translation>
    </message>
    <message>
        <source>100 mm: to measure, no part of the pattern</source>
        <translation>100&#xa0;mm: 確認用。型紙の一部ではありません</translation>
    </message>
    <message>
        <source>Sheet %1 (row %2 of %3, column %4 of %5)</source>
        <translation>シート %1 (行 %2/%3、列 %4/%5)</translation>
    </message>
</context>
<context>
    <name>PatternSelectTool</name>
    <message>
        <source>There is a control point already.</source>
        <translation>ここにはすでに制御点があります。</translation>
    </message>
    <message>
        <source>Drag to turn the selected patches in the layout</source>
        <translation>ドラッグで選択中のパーツをレイアウト上で回転</translation>
    </message>
    <message>
        <source>Drag to move the control point – Shift+click selects several, Del removes</source>
        <translation>ドラッグで制御点を移動。Shift+クリックで複数選択、Del で削除</translation>
    </message>
    <message>
        <source>Click to select the patch, drag to move it in the layout</source>
        <translation>クリックでパーツを選択、ドラッグでレイアウト上を移動</translation>
    </message>
    <message>
        <source>Click to select the curve, drag to move it, double click to add a control point here</source>
        <translation>クリックで曲線を選択、ドラッグで移動、ダブルクリックでここに制御点を追加</translation>
    </message>
    <message>
        <source>Drag to scale the selected patches – Shift keeps the proportions</source>
        <translation>ドラッグで選択中のパーツを拡大縮小。Shift で縦横比を保持</translation>
    </message>
    <message>
        <source>Drag to move this end of the stretch along the outline</source>
        <translation>ドラッグで区間のこの端を輪郭に沿って移動</translation>
    </message>
    <message>
        <source>Drag to move the edge, double click to add a control point here – its length is in the properties</source>
        <translation>ドラッグで辺を移動、ダブルクリックでここに制御点を追加。長さはプロパティにあります</translation>
    </message>
    <message>
        <source>Click to select the edge, double click to add a control point here, drag to move the patch</source>
        <translation>クリックで辺を選択、ダブルクリックでここに制御点を追加、ドラッグでパーツを移動</translation>
    </message>
    <message>
        <source>Click to select the seam and the edge, double click to add a control point here</source>
        <translation>クリックで縫い目と辺を選択、ダブルクリックでここに制御点を追加</translation>
    </message>
    <message>
        <source>Click to select it, drag to move it, Delete removes it</source>
        <translation>クリックで選択、ドラッグで移動、Delete で削除</translation>
    </message>
    <message>
        <source>Drag the tip of the dart</source>
        <translation>ダーツの先端をドラッグ</translation>
    </message>
    <message>
        <source>Drag the dart along the outline</source>
        <translation>ダーツを輪郭に沿ってドラッグ</translation>
    </message>
    <message>
        <source>Drag the label to where it can be read, click to select the patch</source>
        <translation>ラベルを読みやすい場所へドラッグ。クリックでパーツを選択</translation>
    </message>
    <message>
        <source>Click to select, drag a box to select several – %1 or Space pans, %2 zooms</source>
        <translation>クリックで選択、範囲のドラッグで複数選択。%1か Space で表示を移動、%2でズーム</translation>
    </message>
    <message>
        <source>Click to select the measurement, Delete removes it</source>
        <translation>クリックで測定を選択、Delete で削除</translation>
    </message>
</context>
<context>
    <name>PatternSplitTool</name>
    <message>
        <source>Click beside a patch or on its outline to begin the cut – Esc ends the tool</source>
        <translation>パーツの横または輪郭上をクリックして切断を開始。Esc でツールを終了</translation>
    </message>
    <message>
        <source>Double click or Enter splits the patch – click to bend the cut, Backspace takes a point back</source>
        <translation>ダブルクリックか Enter でパーツを分割。クリックで切断線を曲げる、Backspace で点を取り消す</translation>
    </message>
    <message>
        <source>Click on the other side of the patch – Shift keeps the cut straight, Backspace takes a point back</source>
        <translation>パーツの反対側をクリック。Shift で切断線をまっすぐに、Backspace で点を取り消す</translation>
    </message>
</context>
<context>
    <name>PatternTool</name>
    <message>
        <source>Moved by %1, %2 – Shift keeps to one axis, Esc takes it back</source>
        <translation>%1、%2 移動。Shift で 1 軸に固定、Esc で取り消す</translation>
    </message>
    <message>
        <source>Turned by %1 – Shift turns in steps of 15°, Esc takes it back</source>
        <translation>%1 回転。Shift で 15° 刻み、Esc で取り消す</translation>
    </message>
    <message>
        <source>Release to select what lies in the box – Shift adds, Esc takes it back</source>
        <translation>離すと範囲内を選択。Shift で追加、Esc で取り消す</translation>
    </message>
    <message>
        <source>Release to select what lies in the loop – Shift adds, Esc takes it back</source>
        <translation>離すと投げ縄内を選択。Shift で追加、Esc で取り消す</translation>
    </message>
    <message>
        <source>Enter moves it so far: 50, or 30, 20</source>
        <translation>Enter でその分だけ移動: 50 または 30, 20</translation>
    </message>
    <message>
        <source>Enter turns it by this angle, counter-clockwise: 45</source>
        <translation>Enter でこの角度だけ反時計回りに回転: 45</translation>
    </message>
    <message>
        <source>Enter makes it this size: 300 x 200, 300 (wide, in proportion), or 120 %</source>
        <translation>Enter でこのサイズにする: 300 x 200、300 (幅、比率保持)、120&#xa0;%</translation>
    </message>
    <message>
        <source>Scaled to %1 × %2 – or type the size; Shift keeps the proportions, Esc takes it back</source>
        <translation>%1 × %2 に拡大縮小。サイズの入力も可。Shift で縦横比を保持、Esc で取り消す</translation>
    </message>
</context>
<context>
    <name>PatternToolHost</name>
    <message>
        <source>%1 Let go here, and it goes back to where it was.</source>
        <translation>%1 ここで離すと、元の場所に戻ります。</translation>
    </message>
</context>
<context>
    <name>PieceCuttingSection</name>
    <message>
        <source>Cutting</source>
        <translation>裁断</translation>
    </message>
    <message>
        <source>Own seam allowance</source>
        <translation>独自の縫い代</translation>
    </message>
    <message>
        <source>Label where it finds room</source>
        <translation>ラベルを空いている場所に</translation>
    </message>
</context>
<context>
    <name>PlacementGizmo</name>
    <message>
        <source>Turned by %1° – Ctrl snaps to 15°, Escape cancels</source>
        <translation>%1° 回転。Ctrl で 15° にスナップ、Esc でキャンセル</translation>
    </message>
    <message>
        <source>Drag to move it along this axis</source>
        <translation>ドラッグでこの軸に沿って移動</translation>
    </message>
    <message>
        <source>Drag to turn it about this axis</source>
        <translation>ドラッグでこの軸まわりに回転</translation>
    </message>
    <message>
        <source>Drag to move it parallel to the picture</source>
        <translation>ドラッグで画面と平行に移動</translation>
    </message>
    <message>
        <source>Moved by x %1, y %2, z %3 – Ctrl snaps to %4, Escape cancels</source>
        <translation>x %1、y %2、z %3 移動。Ctrl で %4 にスナップ、Esc でキャンセル</translation>
    </message>
</context>
<context>
    <name>PreferenceCommands</name>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation>環境設定(&amp;F)…</translation>
    </message>
    <message>
        <source>Units, language, theme, mouse, keys and more</source>
        <translation>単位、言語、テーマ、マウス、キーなど</translation>
    </message>
    <message>
        <source>The preferences could not be stored: they hold only until Bolster is closed.</source>
        <translation>環境設定を保存できませんでした。Bolster を閉じるまでだけ有効です。</translation>
    </message>
</context>
<context>
    <name>Preferences</name>
    <message>
        <source>Millimetres (314 mm)</source>
        <translation>ミリメートル (314 mm)</translation>
    </message>
    <message>
        <source>Centimetres (31.4 cm)</source>
        <translation>センチメートル (31.4 cm)</translation>
    </message>
    <message>
        <source>Inches (12 3/8″)</source>
        <translation>インチ (12 3/8″)</translation>
    </message>
    <message>
        <source>Up to 1/8</source>
        <translation>1/8 まで</translation>
    </message>
    <message>
        <source>Up to 1/16</source>
        <translation>1/16 まで</translation>
    </message>
    <message>
        <source>Up to 1/32</source>
        <translation>1/32 まで</translation>
    </message>
    <message>
        <source>Up to 1/64</source>
        <translation>1/64 まで</translation>
    </message>
    <message>
        <source>Decimals (12.375)</source>
        <translation>小数 (12.375)</translation>
    </message>
    <message>
        <source>Of the language</source>
        <translation>言語に従う</translation>
    </message>
    <message>
        <source>Comma (1,5)</source>
        <translation>コンマ (1,5)</translation>
    </message>
    <message>
        <source>Point (1.5)</source>
        <translation>ピリオド (1.5)</translation>
    </message>
    <message>
        <source>Of the system</source>
        <translation>システムの言語</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>システムに従う</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>ダーク</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>ハイコントラスト</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>高</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>低</translation>
    </message>
    <message>
        <source>Plain, as it comes</source>
        <translation>無地 (既定)</translation>
    </message>
    <message>
        <source>Units and numbers</source>
        <translation>単位と数値</translation>
    </message>
    <message>
        <source>Language and looks</source>
        <translation>言語と外観</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>マウス</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>キーボード</translation>
    </message>
    <message>
        <source>Pattern view</source>
        <translation>型紙ビュー</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D ビュー</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>未保存の作業</translation>
    </message>
    <message>
        <source>New designs</source>
        <translation>新しいデザイン</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>長さの単位</translation>
    </message>
    <message>
        <source>unit measure metric imperial millimetre centimetre inch</source>
        <translation>単位 寸法 メートル法 ヤードポンド法 ミリ センチ インチ</translation>
    </message>
    <message>
        <source>How lengths are shown. Whatever it is, you may type others: 3 in, 2.5 cm, 1&apos; 2 3/8&quot;. Designs keep millimetres, and so do printed sheets and files.</source>
        <translation>長さの表示方法。どの設定でも、「3 in」「2.5 cm」「1&apos; 2 3/8&quot;」など他の単位で入力できます。デザイン、印刷物、ファイルは常にミリメートルです。</translation>
    </message>
    <message>
        <source>Parts of an inch</source>
        <translation>インチの分数</translation>
    </message>
    <message>
        <source>fraction imperial 1/16 decimals</source>
        <translation>分数 ヤードポンド法 1/16 小数</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>小数点の記号</translation>
    </message>
    <message>
        <source>comma point dot separator numbers</source>
        <translation>コンマ カンマ ピリオド 小数点 区切り 数値</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>translation words english german deutsch</source>
        <translation>翻訳 文字 日本語 英語 ドイツ語 language english</translation>
    </message>
    <message>
        <source>Bolster speaks it when it is started the next time.</source>
        <translation>次回の起動時から使われます。</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>テーマ</translation>
    </message>
    <message>
        <source>colours dark light contrast night appearance accessibility</source>
        <translation>色 カラー ダーク ライト 明るい 暗い コントラスト 夜 外観 アクセシビリティ</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Size of the letters</source>
        <translation>文字の大きさ</translation>
    </message>
    <message>
        <source>font text large small zoom scale accessibility</source>
        <translation>フォント 文字 大きい 小さい ズーム 拡大 アクセシビリティ</translation>
    </message>
    <message>
        <source>Move the views as in</source>
        <translation>ビューの操作方法</translation>
    </message>
    <message>
        <source>navigation rotate turn pan zoom buttons trackpad orbit preset</source>
        <translation>ナビゲーション 回転 移動 パン ズーム ボタン トラックパッド オービット プリセット</translation>
    </message>
    <message>
        <source>Zoom the other way round</source>
        <translation>ズームの方向を逆にする</translation>
    </message>
    <message>
        <source>invert wheel scroll reverse direction</source>
        <translation>反転 ホイール スクロール 逆 方向</translation>
    </message>
    <message>
        <source>Keys as in</source>
        <translation>キーの割り当て</translation>
    </message>
    <message>
        <source>shortcuts hotkeys preset</source>
        <translation>ショートカット ホットキー プリセット</translation>
    </message>
    <message>
        <source>Some commands get the keys that you know from there. Keys that you have chosen yourself stay.</source>
        <translation>一部のコマンドが、そのソフトで使い慣れたキーになります。自分で選んだキーはそのままです。</translation>
    </message>
    <message>
        <source>Snap to points, edges, guides and the grid</source>
        <translation>点、辺、ガイド、グリッドにスナップ</translation>
    </message>
    <message>
        <source>magnet catch align</source>
        <translation>吸着 マグネット 整列</translation>
    </message>
    <message>
        <source>Ctrl or Alt lets go while you drag.</source>
        <translation>ドラッグ中は Ctrl か Alt で解除できます。</translation>
    </message>
    <message>
        <source>Show rulers</source>
        <translation>ルーラーを表示</translation>
    </message>
    <message>
        <source>scale measure</source>
        <translation>目盛り 定規 測定</translation>
    </message>
    <message>
        <source>Show guides</source>
        <translation>ガイドを表示</translation>
    </message>
    <message>
        <source>lines help</source>
        <translation>線 補助線</translation>
    </message>
    <message>
        <source>Quality of the picture</source>
        <translation>表示品質</translation>
    </message>
    <message>
        <source>performance slow fast remote desktop graphics opengl</source>
        <translation>性能 パフォーマンス 遅い 速い リモートデスクトップ グラフィックス opengl</translation>
    </message>
    <message>
        <source>Reduced: fewer pixels and triangles, no soft shadows. For slow machines and for screens that are far away. Pictures that you export stay fine.</source>
        <translation>低: ピクセルと三角形を減らし、柔らかい影を省きます。遅いコンピューターやリモート画面向けです。エクスポートする画像の品質は変わりません。</translation>
    </message>
    <message>
        <source>Go to other views at once, without a flight</source>
        <translation>アニメーションなしでビューを切り替える</translation>
    </message>
    <message>
        <source>reduced motion animation camera accessibility remote</source>
        <translation>視差効果 動きを減らす アニメーション カメラ アクセシビリティ リモート</translation>
    </message>
    <message>
        <source> days</source>
        <translation> 日</translation>
    </message>
    <message>
        <source>Keep work that was thrown away for</source>
        <translation>破棄した作業の保管期間</translation>
    </message>
    <message>
        <source>autosave backup recovery crash journal bin unsaved delete</source>
        <translation>自動保存 バックアップ 復元 クラッシュ ジャーナル ごみ箱 未保存 削除</translation>
    </message>
    <message>
        <source>Every step is on the disk as soon as it is done, so there is no interval to set. Unsaved work stays until you open it again or throw it away; after that it lies in the bin for at least 30 days.</source>
        <translation>各ステップは完了するとすぐディスクに保存されるため、間隔の設定はありません。未保存の作業は、開き直すか破棄するまで残り、その後ごみ箱に少なくとも 30 日間保管されます。</translation>
    </message>
    <message>
        <source>Fabric of new patches</source>
        <translation>新しいパーツの生地</translation>
    </message>
    <message>
        <source>default material leather weave colour</source>
        <translation>既定 素材 材料 革 織物 色</translation>
    </message>
    <message>
        <source>A new design begins with it, and patches are made of a design&apos;s first fabric.</source>
        <translation>新しいデザインはこの生地で始まり、パーツはデザインの最初の生地で作られます。</translation>
    </message>
    <message>
        <source>Seam allowance</source>
        <translation>縫い代</translation>
    </message>
    <message>
        <source>default cutting margin hem width</source>
        <translation>既定 裁断 余白 ヘム 幅</translation>
    </message>
    <message>
        <source>New designs begin with it; in a design it is changed in its properties.</source>
        <translation>新しいデザインの初期値です。デザインごとの値はプロパティで変更します。</translation>
    </message>
    <message>
        <source>Folder of your fabrics</source>
        <translation>生地のフォルダー</translation>
    </message>
    <message>
        <source>library directory path import export picture swatch</source>
        <translation>ライブラリ ディレクトリ パス インポート エクスポート 画像 見本</translation>
    </message>
    <message>
        <source>Where fabrics and their pictures are looked for first. Without one it is the folder of the design.</source>
        <translation>生地とその画像を最初に探す場所。指定がなければデザインのフォルダーです。</translation>
    </message>
    <message>
        <source>Lengths are kept as they are, and shown to the nearest part; what is shorter than one has decimals.</source>
        <translation>長さはそのまま保たれ、最も近い分数で表示されます。それより短いものは小数になります。</translation>
    </message>
</context>
<context>
    <name>SavedViewCommands</name>
    <message>
        <source>&amp;Save view …</source>
        <translation>ビューを保存(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Delete view</source>
        <translation>ビューを削除(&amp;D)</translation>
    </message>
    <message>
        <source>View %1 deleted</source>
        <translation>ビュー %1 を削除しました</translation>
    </message>
    <message>
        <source>Save view</source>
        <translation>ビューを保存</translation>
    </message>
    <message>
        <source>Name of the view; one of the same name is replaced:</source>
        <translation>ビューの名前 (同じ名前のビューは置き換えます):</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>ビュー %1</translation>
    </message>
    <message>
        <source>View %1 saved: View &gt; Saved views</source>
        <translation>ビュー %1 を保存しました: 表示 &gt; 保存したビュー</translation>
    </message>
</context>
<context>
    <name>ScanAlignTool</name>
    <message>
        <source>There is no point of the scan here: click on one.</source>
        <translation>ここにスキャンの点はありません。点をクリックしてください。</translation>
    </message>
    <message>
        <source>There is neither a frame nor the cover here: click where that place of the scan belongs.</source>
        <translation>ここにはフレームもカバーもありません。スキャンのその場所の合わせ先をクリックしてください。</translation>
    </message>
    <message>
        <source>Take the last place &amp;back</source>
        <translation>最後の場所を取り消す(&amp;B)</translation>
    </message>
    <message>
        <source>Click on the frame or the cover where place %1 of the scan belongs – Backspace takes it back</source>
        <translation>スキャンの場所 %1 の合わせ先をフレームかカバー上でクリック。Backspace で取り消す</translation>
    </message>
    <message>
        <source>Click on a place of the scan that can be told from others, such as a corner – drag turns the view, Esc ends the tool</source>
        <translation>角など、他と区別できるスキャンの場所をクリック。ドラッグでビューを回転、Esc でツールを終了</translation>
    </message>
    <message>
        <source>Click on place %1 of 3 of the scan, far from the others – Backspace takes one back</source>
        <translation>スキャンの場所 %1/3 を、他から離れた所でクリック。Backspace で 1 つ取り消す</translation>
    </message>
    <message>
        <source>%1: where it belongs</source>
        <translation>%1: 合わせ先</translation>
    </message>
    <message>
        <source>%1: on the scan</source>
        <translation>%1: スキャン上</translation>
    </message>
    <message>
        <source>The scan is no longer there – Esc ends the tool</source>
        <translation>スキャンがなくなりました。Esc でツールを終了</translation>
    </message>
</context>
<context>
    <name>ScanCommands</name>
    <message>
        <source>&amp;Place on the cover</source>
        <translation>カバーに位置合わせ(&amp;P)</translation>
    </message>
    <message>
        <source>Moves and turns the scan so that it lies on the cover as well as it can</source>
        <translation>カバーにできるだけ合うようにスキャンを移動、回転します</translation>
    </message>
    <message>
        <source>&amp;Cut away …</source>
        <translation>切り取る(&amp;C)…</translation>
    </message>
    <message>
        <source>Drag a rectangle in the 3D view over what is to be cut away of the scan</source>
        <translation>スキャンの切り取る部分を 3D ビューで長方形にドラッグします</translation>
    </message>
    <message>
        <source>&amp;Keep only …</source>
        <translation>残す範囲を指定(&amp;K)…</translation>
    </message>
    <message>
        <source>Drag a rectangle in the 3D view around what is to be kept of the scan</source>
        <translation>スキャンの残す部分を 3D ビューで長方形にドラッグします</translation>
    </message>
    <message>
        <source>Keep &amp;around the cover</source>
        <translation>カバーの周囲を残す(&amp;A)</translation>
    </message>
    <message>
        <source>Cuts away what is farther from the cover than the threshold</source>
        <translation>カバーからしきい値より離れたものを切り取ります</translation>
    </message>
    <message>
        <source>&amp;Remove all cuts</source>
        <translation>切り取りをすべて解除(&amp;R)</translation>
    </message>
    <message>
        <source>Brings back all that was cut away of the scan</source>
        <translation>スキャンから切り取ったものをすべて戻します</translation>
    </message>
    <message>
        <source>Choose another &amp;file …</source>
        <translation>別のファイルを選択(&amp;F)…</translation>
    </message>
    <message>
        <source>Reads the scan from another file</source>
        <translation>スキャンを別のファイルから読み込みます</translation>
    </message>
    <message>
        <source>Select the scan that is meant.</source>
        <translation>対象のスキャンを選択してください。</translation>
    </message>
    <message>
        <source>Placing the scan on the cover …</source>
        <translation>スキャンをカバーに位置合わせしています…</translation>
    </message>
    <message>
        <source>Placing the scan on the cover: step %1</source>
        <translation>スキャンをカバーに位置合わせしています: ステップ %1</translation>
    </message>
    <message>
        <source>A&amp;lign …</source>
        <translation>位置合わせ(&amp;L)…</translation>
    </message>
    <message>
        <source>Click three places of the scan and where each belongs; the rest is found</source>
        <translation>スキャンの 3 か所とそれぞれの合わせ先をクリックします。残りは自動です</translation>
    </message>
    <message>
        <source>Aligning the scan …</source>
        <translation>スキャンを位置合わせしています…</translation>
    </message>
    <message>
        <source>Aligning the scan: step %1</source>
        <translation>スキャンを位置合わせしています: ステップ %1</translation>
    </message>
</context>
<context>
    <name>ScanCutTool</name>
    <message>
        <source>Drag a rectangle around what is to be kept of the scan. Esc ends.</source>
        <translation>スキャンの残す部分を囲むように長方形をドラッグしてください。Esc で終了。</translation>
    </message>
    <message>
        <source>Drag a rectangle over what is to be cut away of the scan. Esc ends.</source>
        <translation>スキャンの切り取る部分に長方形をドラッグしてください。Esc で終了。</translation>
    </message>
</context>
<context>
    <name>ScanForm</name>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Place on &amp;the cover</source>
        <translation>カバーに位置合わせ(&amp;T)</translation>
    </message>
    <message>
        <source>Choose an&amp;other file …</source>
        <translation>別のファイルを選択(&amp;O)…</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 点</translation>
    </message>
    <message>
        <source>%1 of %2 points, one every %3</source>
        <translation>%2 点中 %1 点、%3 ごとに 1 点</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>%1 rms</source>
        <translation>%1 RMS</translation>
    </message>
    <message>
        <source>Median, 95 %</source>
        <translation>中央値、95&#xa0;%</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>カバー率</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Floor at</source>
        <translation>床の位置</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>切り取り</translation>
    </message>
    <message>
        <source>Cut awa&amp;y …</source>
        <translation>切り取る(&amp;Y)…</translation>
    </message>
    <message>
        <source>&amp;Keep only …</source>
        <translation>残す範囲を指定(&amp;K)…</translation>
    </message>
    <message>
        <source>Keep aroun&amp;d the cover</source>
        <translation>カバーの周囲を残す(&amp;D)</translation>
    </message>
    <message>
        <source>Remove a&amp;ll cuts</source>
        <translation>切り取りをすべて解除(&amp;L)</translation>
    </message>
    <message>
        <source>Ali&amp;gn …</source>
        <translation>位置合わせ(&amp;G)…</translation>
    </message>
    <message>
        <source>Between the cover and the scan, where they are nearer than the threshold.</source>
        <translation>カバーとスキャンが、しきい値より近い所の両者の間。</translation>
    </message>
    <message>
        <source>Half of what is measured, and 95 % of it, is no farther from the scan than that.</source>
        <translation>測定した所の半分と 95&#xa0;% が、スキャンからこの距離以内にあります。</translation>
    </message>
    <message>
        <source>How much of the cover has points of the scan near it.</source>
        <translation>近くにスキャンの点があるカバーの割合。</translation>
    </message>
    <message>
        <source>Of the scan, without what is cut away.</source>
        <translation>スキャンの点。切り取った部分を除く。</translation>
    </message>
</context>
<context>
    <name>SeamForm</name>
    <message>
        <source>First side</source>
        <translation>1 番目の側</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Second side</source>
        <translation>2 番目の側</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>いせ</translation>
    </message>
</context>
<context>
    <name>SectionHandle</name>
    <message>
        <source>Section at %1 – Ctrl turns it by 15°, Escape puts it back</source>
        <translation>断面 %1。Ctrl で 15° ずつ回転、Esc で元に戻す</translation>
    </message>
    <message>
        <source>Drag to move the section, with Ctrl to turn it</source>
        <translation>ドラッグで断面を移動、Ctrl で回転</translation>
    </message>
</context>
<context>
    <name>SelectedEdgesForm</name>
    <message>
        <source>Edge length</source>
        <translation>辺の長さ</translation>
    </message>
    <message>
        <source>Edge lengths</source>
        <translation>辺の長さ</translation>
    </message>
    <message>
        <source>%1 edges. Of &quot;Make equally long&quot; the first one stays: %2 of %3.</source>
        <translation>%1 本の辺。「同じ長さにする」では 1 番目の %3 の %2 が基準です。</translation>
    </message>
    <message>
        <source>Edge of</source>
        <translation>辺の所属</translation>
    </message>
</context>
<context>
    <name>SelectedPointsForm</name>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Layout x, y</source>
        <translation>レイアウト x、y</translation>
    </message>
    <message>
        <source>Length between</source>
        <translation>間の長さ</translation>
    </message>
    <message>
        <source>Space x, y, z</source>
        <translation>空間 x、y、z</translation>
    </message>
</context>
<context>
    <name>SelectionEdits</name>
    <message>
        <source>Not removed: the curve needs these points.</source>
        <translation>削除されません: 曲線にこれらの点が必要です。</translation>
    </message>
    <message>
        <source>Not removed: other elements need this fabric.</source>
        <translation>削除されません: 他の要素にこの生地が必要です。</translation>
    </message>
    <message>
        <source>An edge cannot be removed: its points can, or with Esc the whole patch.</source>
        <translation>辺は削除できません。その点を削除するか、Esc の後にパーツ全体を削除できます。</translation>
    </message>
</context>
<context>
    <name>SettingsForm</name>
    <message>
        <source>Patches</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>縫い目</translation>
    </message>
    <message>
        <source>Select something to see its properties.</source>
        <translation>何かを選択するとプロパティが表示されます。</translation>
    </message>
    <message>
        <source>Symmetric design</source>
        <translation>対称なデザイン</translation>
    </message>
    <message>
        <source>Plane through</source>
        <translation>平面の通過点</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>法線</translation>
    </message>
    <message>
        <source>Axis through</source>
        <translation>軸の通過点</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>%1, %2 in all</source>
        <translation>%1、計 %2</translation>
    </message>
    <message>
        <source>A point of the plane in which the cover is mirrored</source>
        <translation>カバーを反転する平面上の点</translation>
    </message>
    <message>
        <source>The direction straight out of that plane</source>
        <translation>その平面に垂直な方向</translation>
    </message>
    <message>
        <source>A point of the line of the pattern at which patches are mirrored</source>
        <translation>型紙でパーツを反転する線上の点</translation>
    </message>
    <message>
        <source>The direction of that line</source>
        <translation>その線の方向</translation>
    </message>
    <message>
        <source>Twins are mirror images of each other. With this mark you say where the mirror stands; without it, it stands in the middle, between left and right.</source>
        <translation>対称ペアは互いの鏡像です。チェックを入れると鏡の位置を決められ、外すと左右の中央になります。</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>頂点</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>約 %1</translation>
    </message>
    <message>
        <source>How many points the cover has at this edge length: solving takes time and memory for each.</source>
        <translation>この辺の長さでカバーがもつ点の数です。点が多いほど、計算に時間とメモリがかかります。</translation>
    </message>
</context>
<context>
    <name>SewPicture</name>
    <message>
        <source>Ease %1, %2</source>
        <translation>いせ %1、%2</translation>
    </message>
</context>
<context>
    <name>SewTool</name>
    <message>
        <source>Click on the outline of a patch.</source>
        <translation>パーツの輪郭をクリックしてください。</translation>
    </message>
    <message>
        <source>Choose the other side first.</source>
        <translation>先に反対側を選んでください。</translation>
    </message>
    <message>
        <source>Release where the stretch ends</source>
        <translation>区間の終点で離す</translation>
    </message>
    <message>
        <source>Click where the stretch ends – Esc goes back</source>
        <translation>区間の終点をクリック。Esc で戻る</translation>
    </message>
    <message>
        <source>Click to sew it the other way round (F)</source>
        <translation>クリックで逆向きに縫う (F)</translation>
    </message>
    <message>
        <source>Click the edge to sew – drag along the outline, or Shift+click twice, for a part of it; Esc ends the tool</source>
        <translation>縫う辺をクリック。輪郭に沿ったドラッグか Shift+クリック 2 回で一部を指定、Esc でツールを終了</translation>
    </message>
    <message>
        <source>Click the edges of the row one after the other, Enter sews – F flips, Backspace takes one back</source>
        <translation>連続する辺を順にクリックし、Enter で縫う。F で反転、Backspace で 1 つ取り消す</translation>
    </message>
    <message>
        <source>Click the edge it is sewn to – F flips, Ctrl+click or M for several in a row, Backspace goes back</source>
        <translation>縫い合わせる相手の辺をクリック。F で反転、Ctrl+クリックか M で連続する複数、Backspace で戻る</translation>
    </message>
    <message>
        <source>Ctrl+click the next edge of the row, click the last one – Enter sews, F flips, Backspace takes one back</source>
        <translation>連続する次の辺を Ctrl+クリック、最後の辺をクリック。Enter で縫う、F で反転、Backspace で 1 つ取り消す</translation>
    </message>
    <message>
        <source>&amp;Sew what is marked</source>
        <translation>マークしたものを縫う(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>反転(&amp;F)</translation>
    </message>
    <message>
        <source>Take &amp;one edge</source>
        <translation>1 つの辺を使う(&amp;O)</translation>
    </message>
    <message>
        <source>Take se&amp;veral edges in a row</source>
        <translation>連続する複数の辺を使う(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Take back the last edge</source>
        <translation>最後の辺を取り消す(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>中止(&amp;G)</translation>
    </message>
</context>
<context>
    <name>SewingSheet</name>
    <message>
        <source>Sewing sheet</source>
        <translation>縫製シート</translation>
    </message>
    <message>
        <source>Sewing sheet: %1</source>
        <translation>縫製シート: %1</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Seams in the order of sewing</source>
        <translation>縫い目 (縫製順)</translation>
    </message>
    <message>
        <source>%1 and %1 mirrored</source>
        <translation>%1、反転 %1</translation>
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
        <translation>パーツ</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>生地</translation>
    </message>
    <message>
        <source>Area as cut</source>
        <translation>裁断面積</translation>
    </message>
    <message>
        <source>top stitched on both sides</source>
        <translation>両側にトップステッチ</translation>
    </message>
    <message>
        <source>top stitched</source>
        <translation>トップステッチ</translation>
    </message>
    <message>
        <source>%1 mm long, %2 mm from the seam</source>
        <translation>ステッチ長さ %1&#xa0;mm、縫い目から %2&#xa0;mm</translation>
    </message>
    <message>
        <source>piping, %1 mm thick</source>
        <translation>パイピング、太さ %1&#xa0;mm</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>地縫い</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 と %2</translation>
    </message>
    <message>
        <source>%1, with itself</source>
        <translation>%1 自身</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 を %2 に</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>縫い目</translation>
    </message>
    <message>
        <source>Lengths, mm</source>
        <translation>長さ (mm)</translation>
    </message>
    <message>
        <source>Allowance, mm</source>
        <translation>縫い代 (mm)</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>ノッチ</translation>
    </message>
    <message>
        <source>Stitch</source>
        <translation>ステッチ</translation>
    </message>
    <message>
        <source>%1 m², without what lies between the pieces</source>
        <translation>%1&#xa0;m²、パーツ間を除く</translation>
    </message>
    <message>
        <source>Sewing thread</source>
        <translation>縫い糸</translation>
    </message>
    <message>
        <source>Top thread &lt;span style=&quot;background-color:%1&quot;&gt;&amp;nbsp;&amp;nbsp;&amp;nbsp;&amp;nbsp;&lt;/span&gt; %1</source>
        <translation>ステッチ糸 &lt;span style=&quot;background-color:%1&quot;&gt;&#xa0;&#xa0;&#xa0;&#xa0;&lt;/span&gt; %1</translation>
    </message>
    <message>
        <source>%1 m, at %2 m for each metre of a row</source>
        <translation>%1&#xa0;m、1 列 1&#xa0;m あたり %2&#xa0;m</translation>
    </message>
    <message>
        <source>Piping</source>
        <translation>パイピング</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1&#xa0;m</translation>
    </message>
    <message>
        <source>What</source>
        <translation>品目</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>量</translation>
    </message>
    <message>
        <source>zip</source>
        <translation>ファスナー</translation>
    </message>
    <message>
        <source>Zip</source>
        <translation>ファスナー</translation>
    </message>
    <message>
        <source>Pieces, with the numbers of their seams</source>
        <translation>パーツと縫い目の番号</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>縫い目</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>Width × height as cut</source>
        <translation>裁断時の幅 × 高さ</translation>
    </message>
    <message>
        <source>Ease, %</source>
        <translation>いせ (%)</translation>
    </message>
    <message>
        <source>nap one way: all pieces point up</source>
        <translation>毛並み一方向: すべてのパーツを上向きに</translation>
    </message>
</context>
<context>
    <name>SnapHints</name>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Midpoint</source>
        <translation>中点</translation>
    </message>
    <message>
        <source>On an outline</source>
        <translation>輪郭上</translation>
    </message>
    <message>
        <source>Aligned</source>
        <translation>整列</translation>
    </message>
    <message>
        <source>Direction %1</source>
        <translation>方向 %1</translation>
    </message>
    <message>
        <source>Perpendicular</source>
        <translation>直角</translation>
    </message>
    <message>
        <source>As long: %1</source>
        <translation>同じ長さ: %1</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>ガイド</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>グリッド</translation>
    </message>
</context>
<context>
    <name>StartCommands</name>
    <message>
        <source>Start pa&amp;ge</source>
        <translation>スタートページ(&amp;G)</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>新しいウィンドウ(&amp;W)</translation>
    </message>
    <message>
        <source>No other window could be opened.</source>
        <translation>別のウィンドウを開けませんでした。</translation>
    </message>
    <message>
        <source>The system did not start the program again. Close some programs, and try once more.</source>
        <translation>システムがプログラムをもう一度起動できませんでした。他のプログラムをいくつか閉じて、やり直してください。</translation>
    </message>
    <message>
        <source>&amp;Report a problem …</source>
        <translation>問題を報告(&amp;R)…</translation>
    </message>
    <message>
        <source>What&apos;s &amp;new</source>
        <translation>新機能(&amp;N)</translation>
    </message>
    <message>
        <source>This is Bolster %1. What is new is under Help &gt; What&apos;s new.</source>
        <translation>Bolster %1 です。新機能は「ヘルプ &gt; 新機能」にあります。</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>表示(&amp;O)</translation>
    </message>
    <message>
        <source>The frame is in the 3D view. Draw the curves on it where the cloth is fixed, or the first patch.</source>
        <translation>フレームが 3D ビューにあります。生地を固定する曲線をその上に描くか、最初のパーツを描いてください。</translation>
    </message>
    <message>
        <source>Draw a &amp;fixation curve</source>
        <translation>固定曲線を描く(&amp;F)</translation>
    </message>
    <message>
        <source>Draw a &amp;rectangle</source>
        <translation>長方形を描く(&amp;R)</translation>
    </message>
    <message>
        <source>Pattern of a form …</source>
        <translation>形状の型紙…</translation>
    </message>
</context>
<context>
    <name>StretchEndDrag</name>
    <message>
        <source>%1 long – Ctrl lets go of what is near, Esc takes it back</source>
        <translation>長さ %1。Ctrl でスナップを解除、Esc で取り消す</translation>
    </message>
    <message>
        <source>%1 long, the other side %2: ease %3, %4 – Ctrl lets go of what is near, Esc takes it back</source>
        <translation>長さ %1、反対側 %2: いせ %3、%4。Ctrl でスナップを解除、Esc で取り消す</translation>
    </message>
    <message>
        <source>End of another stretch</source>
        <translation>別の区間の端</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>角</translation>
    </message>
    <message>
        <source>As long as the other side</source>
        <translation>反対側と同じ長さ</translation>
    </message>
</context>
<context>
    <name>SurfaceCommands</name>
    <message>
        <source>&amp;Pause</source>
        <translation>一時停止(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Figures …</source>
        <translation>数値(&amp;F)…</translation>
    </message>
</context>
<context>
    <name>SweepWindow</name>
    <message>
        <source>&amp;Cut</source>
        <translation>裁断(&amp;C)</translation>
    </message>
    <message>
        <source>Each piece is cut so much larger or smaller all around</source>
        <translation>各パーツが全周で大きめ、または小さめに裁断される量</translation>
    </message>
    <message>
        <source>Cut of %1</source>
        <translation>%1 の裁断</translation>
    </message>
    <message>
        <source>S&amp;eams</source>
        <translation>縫い目(&amp;E)</translation>
    </message>
    <message>
        <source>Each seam is sewn so much farther inside or outside, on both sides</source>
        <translation>各縫い目が両側で内側、または外側に縫われる量</translation>
    </message>
    <message>
        <source>Seam %1</source>
        <translation>縫い目 %1</translation>
    </message>
    <message>
        <source>&amp;Foam</source>
        <translation>フォーム(&amp;F)</translation>
    </message>
    <message>
        <source>Each cushion and foam is so much thicker or thinner</source>
        <translation>各クッションとフォームが厚く、または薄くなる量</translation>
    </message>
    <message>
        <source>Thickness of %1</source>
        <translation>%1 の厚さ</translation>
    </message>
    <message>
        <source>Fi&amp;xations</source>
        <translation>固定(&amp;X)</translation>
    </message>
    <message>
        <source>Each fixation curve lies so much elsewhere, along each axis</source>
        <translation>各固定曲線が各軸方向にずれる量</translation>
    </message>
    <message>
        <source>Place of %1</source>
        <translation>%1 の位置</translation>
    </message>
    <message>
        <source>S&amp;tiffness</source>
        <translation>剛性(&amp;T)</translation>
    </message>
    <message>
        <source>Each fabric is so much stiffer or softer</source>
        <translation>各生地が硬く、または軟らかくなる割合</translation>
    </message>
    <message>
        <source>Stiffness of %1</source>
        <translation>%1 の剛性</translation>
    </message>
    <message>
        <source>Sh&amp;rinkage</source>
        <translation>縮み(&amp;R)</translation>
    </message>
    <message>
        <source>Each piece shrinks or stretches by so much</source>
        <translation>各パーツが縮む、または伸びる割合</translation>
    </message>
    <message>
        <source>Shrinkage of %1</source>
        <translation>%1 の縮み</translation>
    </message>
</context>
<context>
    <name>Templates</name>
    <message>
        <source>Cushion</source>
        <translation>クッション</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>ボルスター</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>ベンチ</translation>
    </message>
    <message>
        <source>Dining chair</source>
        <translation>ダイニングチェア</translation>
    </message>
    <message>
        <source>Wing chair</source>
        <translation>ウイングチェア</translation>
    </message>
    <message>
        <source>Car seat</source>
        <translation>カーシート</translation>
    </message>
    <message>
        <source>Headrest</source>
        <translation>ヘッドレスト</translation>
    </message>
</context>
<context>
    <name>ToolCommands</name>
    <message>
        <source>&amp;Select and move</source>
        <translation>選択と移動(&amp;S)</translation>
    </message>
    <message>
        <source>Draw &amp;outline</source>
        <translation>輪郭を描く(&amp;O)</translation>
    </message>
    <message>
        <source>Draw &amp;rectangle</source>
        <translation>長方形を描く(&amp;R)</translation>
    </message>
    <message>
        <source>Draw &amp;ellipse</source>
        <translation>楕円を描く(&amp;E)</translation>
    </message>
    <message>
        <source>S&amp;plit patch</source>
        <translation>パーツを分割(&amp;P)</translation>
    </message>
    <message>
        <source>Draw &amp;handle curve</source>
        <translation>ハンドル曲線を描く(&amp;H)</translation>
    </message>
    <message>
        <source>Draw &amp;fancy seam</source>
        <translation>飾り縫いを描く(&amp;F)</translation>
    </message>
    <message>
        <source>Se&amp;w</source>
        <translation>縫う(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Attach to fixation curve</source>
        <translation>固定曲線に固定(&amp;A)</translation>
    </message>
    <message>
        <source>Stitch or pipe a seam</source>
        <translation>縫い目にステッチまたはパイピング</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>測定(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Draw fixation curve</source>
        <translation>固定曲線を描く(&amp;D)</translation>
    </message>
    <message>
        <source>Draw &amp;internal line</source>
        <translation>内部線を描く(&amp;I)</translation>
    </message>
    <message>
        <source>Allowance of an ed&amp;ge</source>
        <translation>辺の縫い代(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Corner of the cut line</source>
        <translation>裁断線の角(&amp;C)</translation>
    </message>
    <message>
        <source>Place &amp;notches</source>
        <translation>ノッチを配置(&amp;N)</translation>
    </message>
    <message>
        <source>Place &amp;drill holes</source>
        <translation>ドリル穴を配置(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Cutting</source>
        <translation>裁断(&amp;C)</translation>
    </message>
    <message>
        <source>Draw &amp;dart</source>
        <translation>ダーツを描く(&amp;D)</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>&amp;Tour</source>
        <translation>ツアー(&amp;T)</translation>
    </message>
    <message>
        <source>The coloured curves on the frame are where the cloth is tied down. Click one of them, then drag one of its points: the cover follows.</source>
        <translation>フレーム上の色付きの曲線は、生地を固定する所です。1 本をクリックし、その点をドラッグしてください。カバーが追従します。</translation>
    </message>
    <message>
        <source>The cover follows while you drag, and comes to rest when you let go.</source>
        <translation>カバーはドラッグに追従し、離すと静止します。</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Ctrl+Z, or this button, takes back whatever was done, as far as you like. Nothing is lost by it: the history keeps what was undone, too.</source>
        <translation>Ctrl+Z かこのボタンで、行った操作をどこまでも元に戻せます。何も失われません。元に戻した操作も履歴に残ります。</translation>
    </message>
    <message>
        <source>It is as it was. Undone steps are still in the history.</source>
        <translation>元の状態です。元に戻したステップも履歴に残っています。</translation>
    </message>
    <message>
        <source>Choose a seam</source>
        <translation>縫い目を選択</translation>
    </message>
    <message>
        <source>Seams join two edges of the pattern. Click one, in the pattern or on the cover: both of its edges light up, and the cover shows where it is.</source>
        <translation>縫い目は型紙の 2 つの辺をつなぎます。型紙かカバー上で 1 本クリックしてください。両方の辺が光り、カバーに位置が表示されます。</translation>
    </message>
    <message>
        <source>Its properties are at the right now.</source>
        <translation>右側にプロパティが表示されています。</translation>
    </message>
    <message>
        <source>Change how it is sewn</source>
        <translation>縫い方を変更</translation>
    </message>
    <message>
        <source>With the seam selected, choose another continuity in its properties, or another stitching: an edge, a rounded seam or a smooth one.</source>
        <translation>縫い目を選択したまま、プロパティで別の連続性 (角あり、丸める、滑らか) か別のステッチを選んでください。</translation>
    </message>
    <message>
        <source>The cover shows the seam as it will be sewn.</source>
        <translation>カバーに、縫い上がりの縫い目が表示されます。</translation>
    </message>
    <message>
        <source>Look at the strain</source>
        <translation>ひずみを見る</translation>
    </message>
    <message>
        <source>View &gt; Map colours the cover by what the cloth has to bear. Choose Largest strain to see where it is stretched most.</source>
        <translation>「表示 &gt; マップ」は、生地への負担に応じてカバーに色を付けます。「最大ひずみ」を選ぶと、最も伸びている所がわかります。</translation>
    </message>
    <message>
        <source>The legend says how much, and the pointer reads it at any place.</source>
        <translation>凡例で大きさがわかり、ポインターで任意の場所の値を読めます。</translation>
    </message>
    <message>
        <source>Change the pattern</source>
        <translation>型紙を変更</translation>
    </message>
    <message>
        <source>Drag a point of an outline, or cut a dart (Pattern &gt; Draw dart): what you change in the flat is sewn at once.</source>
        <translation>輪郭の点をドラッグするか、ダーツをとってください (型紙 &gt; ダーツを描く)。平面での変更がすぐに縫われます。</translation>
    </message>
    <message>
        <source>Seams keep their places on an outline that changes.</source>
        <translation>輪郭が変わっても、縫い目の位置は保たれます。</translation>
    </message>
    <message>
        <source>Take it with you</source>
        <translation>書き出す</translation>
    </message>
    <message>
        <source>File &gt; Export pattern writes DXF, PDF or SVG with seam allowances and notches; Export cover writes the cover for others.</source>
        <translation>「ファイル &gt; 型紙をエクスポート」は、縫い代とノッチ付きの DXF、PDF、SVG を書き出します。「カバーをエクスポート」は、他の人向けにカバーを書き出します。</translation>
    </message>
    <message>
        <source>The file is written.</source>
        <translation>ファイルを書き出しました。</translation>
    </message>
    <message>
        <source>That was the tour</source>
        <translation>ツアーは終わりです</translation>
    </message>
    <message>
        <source>You have seen how pattern, seams and frame make the cover. Begin with a design of your own: File &gt; Start page has templates. What each key does is under Help &gt; Keys and mouse.</source>
        <translation>型紙、縫い目、フレームからカバーができるまでを見ました。次は自分のデザインを始めましょう。テンプレートは「ファイル &gt; スタートページ」に、キーの働きは「ヘルプ &gt; キーとマウス」にあります。</translation>
    </message>
    <message>
        <source>Drag a fixation curve</source>
        <translation>固定曲線をドラッグ</translation>
    </message>
</context>
<context>
    <name>TrimSection</name>
    <message>
        <source>Stitching</source>
        <translation>ステッチ</translation>
    </message>
    <message>
        <source>Colour of the thread</source>
        <translation>糸の色</translation>
    </message>
    <message>
        <source>Piping</source>
        <translation>パイピング</translation>
    </message>
    <message>
        <source>As the patch</source>
        <translation>パーツと同じ</translation>
    </message>
</context>
<context>
    <name>TwinCommands</name>
    <message>
        <source>Make &amp;mirror twin</source>
        <translation>対称ペアを作成(&amp;M)</translation>
    </message>
    <message>
        <source>Link as t&amp;wins</source>
        <translation>対称ペアとして連動(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Unlink twins</source>
        <translation>対称ペアの連動を解除(&amp;U)</translation>
    </message>
    <message>
        <source>R&amp;elease points from the twin</source>
        <translation>対称ペアから点の連動を解除(&amp;E)</translation>
    </message>
    <message>
        <source>Re-l&amp;ink points to the twin</source>
        <translation>対称ペアに点を再び連動(&amp;I)</translation>
    </message>
    <message>
        <source>S&amp;ymmetry …</source>
        <translation>対称(&amp;Y)…</translation>
    </message>
    <message>
        <source>%1, mirrored</source>
        <translation>%1、反転</translation>
    </message>
    <message>
        <source>Select patches or curves that have no twin yet.</source>
        <translation>対称ペアのないパーツまたは曲線を選択してください。</translation>
    </message>
    <message>
        <source>Nothing that is selected has a twin.</source>
        <translation>選択したものに対称ペアはありません。</translation>
    </message>
    <message>
        <source>Select points of a twin, or a seam on it, that still follow.</source>
        <translation>連動している対称ペアの点、またはそこの縫い目を選択してください。</translation>
    </message>
    <message>
        <source>No point that is selected has been released.</source>
        <translation>選択した点に、連動を解除したものはありません。</translation>
    </message>
</context>
<context>
    <name>TwinForm</name>
    <message>
        <source>Mirror image</source>
        <translation>鏡像</translation>
    </message>
    <message>
        <source>released</source>
        <translation>連動解除</translation>
    </message>
    <message>
        <source>itself</source>
        <translation>自身</translation>
    </message>
    <message>
        <source>Re-lin&amp;k to its mirror image</source>
        <translation>鏡像と再び連動(&amp;K)</translation>
    </message>
    <message>
        <source>Re&amp;lease from its mirror image</source>
        <translation>鏡像との連動を解除(&amp;L)</translation>
    </message>
    <message>
        <source>Twin of</source>
        <translation>対称ペア</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>例外</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message numerus="yes">
        <source>%n released points</source>
        <translation>
            <numerusform>連動解除した点 %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Unlink from its twin</source>
        <translation>ペアの連動を解除(&amp;U)</translation>
    </message>
    <message>
        <source>Re-link all poi&amp;nts</source>
        <translation>すべての点を再び連動(&amp;N)</translation>
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
        <translation>問題</translation>
    </message>
    <message>
        <source>It keeps its text and is saved as it is.</source>
        <translation>テキストを保ったまま、そのまま保存されます。</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>Show &amp;all</source>
        <translation>すべて表示(&amp;A)</translation>
    </message>
    <message>
        <source>Show &amp;selection</source>
        <translation>選択を表示(&amp;S)</translation>
    </message>
    <message>
        <source>Look at the &amp;cover from</source>
        <translation>カバーの視点(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>正面(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>背面(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>左(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>右(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>上(&amp;T)</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>下(&amp;O)</translation>
    </message>
    <message>
        <source>Three-&amp;quarter</source>
        <translation>斜め前(&amp;Q)</translation>
    </message>
    <message>
        <source>Sa&amp;ved views</source>
        <translation>保存したビュー(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>透視投影(&amp;P)</translation>
    </message>
    <message>
        <source>Sec&amp;tion</source>
        <translation>断面(&amp;T)</translation>
    </message>
    <message>
        <source>Lin&amp;k the views</source>
        <translation>ビューを連動(&amp;K)</translation>
    </message>
    <message>
        <source>Show the pointer&apos;s place in the other view, too</source>
        <translation>ポインターの位置をもう一方のビューにも表示します</translation>
    </message>
    <message>
        <source>&amp;Hide selected</source>
        <translation>選択を非表示(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Isolate selected</source>
        <translation>選択のみ表示(&amp;I)</translation>
    </message>
    <message>
        <source>Sho&amp;w hidden again</source>
        <translation>非表示を再表示(&amp;W)</translation>
    </message>
    <message>
        <source>Th&amp;eme</source>
        <translation>テーマ(&amp;E)</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>システムに合わせる(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>ライト(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>ダーク(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Opacity</source>
        <translation>不透明度(&amp;O)</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>Frames and foam</source>
        <translation>フレームとフォーム</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>スキャン</translation>
    </message>
    <message>
        <source>Opacity of frames and scans</source>
        <translation>フレームとスキャンの不透明度</translation>
    </message>
    <message>
        <source>Select patches, curves, frames, foam or scans to hide them.</source>
        <translation>非表示にするパーツ、曲線、フレーム、フォームまたはスキャンを選択してください。</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>ハイコントラスト(&amp;H)</translation>
    </message>
</context>
<context>
    <name>ViewPrint</name>
    <message>
        <source>Print the view</source>
        <translation>ビューを印刷</translation>
    </message>
    <message>
        <source>The view could not be printed.</source>
        <translation>ビューを印刷できませんでした。</translation>
    </message>
    <message>
        <source>The printer takes nothing at the moment. Look whether it is on and has paper, or print to a file.</source>
        <translation>プリンターが現在受け付けていません。電源と用紙を確認するか、ファイルに印刷してください。</translation>
    </message>
</context>
<context>
    <name>WhatsNew</name>
    <message>
        <source>What&apos;s new</source>
        <translation>新機能</translation>
    </message>
</context>
<context>
    <name>WindowCommands</name>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>ウィンドウの次の領域(&amp;N)</translation>
    </message>
    <message>
        <source>Pre&amp;vious part of the window</source>
        <translation>ウィンドウの前の領域(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>レイアウトをリセット(&amp;R)</translation>
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
        <translation>塗った範囲だけ(&amp;Y)</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>塗る</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>消去</translation>
    </message>
    <message>
        <source>The form and the limit of strain count only there</source>
        <translation>形状とひずみの上限はそこでだけ働きます</translation>
    </message>
    <message>
        <source>Drag over the cover in the 3D view; with Shift held down it takes away</source>
        <translation>3D ビューでカバーの上をドラッグします。Shift を押しながらで消します</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>ブラシの半径</translation>
    </message>
    <message>
        <source>Painted area</source>
        <translation>塗った範囲</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
</context>
<context>
    <name>bolster::Banner</name>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
</context>
<context>
    <name>bolster::CanvasChoice</name>
    <message>
        <source>Drawn in software</source>
        <translation>ソフトウェア描画</translation>
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
        <translation>原因は?</translation>
    </message>
    <message>
        <source>The scan of the piece</source>
        <translation>実物のスキャン</translation>
    </message>
    <message>
        <source>The scan of a sound piece</source>
        <translation>良品のスキャン</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Of a piece that is as it should be: where that lies elsewhere than the cover no cause is looked for</source>
        <translation>正しくできた実物のスキャン。良品でもカバーとずれている所では、原因を探しません</translation>
    </message>
    <message>
        <source>Scan of the &amp;piece</source>
        <translation>実物のスキャン(&amp;P)</translation>
    </message>
    <message>
        <source>Scan of a so&amp;und piece</source>
        <translation>良品のスキャン(&amp;U)</translation>
    </message>
    <message>
        <source>Look for the &amp;cause</source>
        <translation>原因を探す(&amp;C)</translation>
    </message>
    <message>
        <source>Looking for a cause …</source>
        <translation>原因を探しています…</translation>
    </message>
    <message>
        <source>Says which one cause explains best how far a built piece lies from the cover: foam, a seam&apos;s allowance, a stretched piece, a fixation off its place, a slipped notch.</source>
        <translation>実物とカバーの差を最もよく説明する原因を 1 つ示します。フォーム、縫い目の縫い代、パーツの伸び、固定のずれ、ノッチのずれを調べます。</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>量</translation>
    </message>
    <message>
        <source>Explains</source>
        <translation>説明率</translation>
    </message>
    <message>
        <source>Probability</source>
        <translation>確率</translation>
    </message>
    <message>
        <source>Causes</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Choose the scan of the piece that was built.</source>
        <translation>実物のスキャンを選んでください。</translation>
    </message>
    <message>
        <source>Covers with each cause are solved …</source>
        <translation>各原因でのカバーを計算しています…</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>停止しました。</translation>
    </message>
    <message>
        <source>The scan shows nothing of the cover: does it lie where the design is?</source>
        <translation>スキャンにカバーが写っていません。デザインと同じ位置にありますか?</translation>
    </message>
    <message>
        <source>The scan shows %1 of the cover and lies %2 (rms) from it. All causes together leave %3.</source>
        <translation>スキャンはカバーの %1 を捉え、差は %2 (RMS) です。すべての原因を合わせると、残りは %3 です。</translation>
    </message>
    <message>
        <source>No single cause explains that better than noise does.</source>
        <translation>単独でノイズよりよく説明できる原因はありません。</translation>
    </message>
    <message>
        <source>Most of the deviation has no cause of these kinds, so the first need not be the right one: give the scan of a sound piece, too.</source>
        <translation>偏差の大部分は、これらの種類の原因では説明できないため、先頭のものが正しいとは限りません。良品のスキャンも指定してください。</translation>
    </message>
    <message numerus="yes">
        <source>and %n others</source>
        <translation>
            <numerusform>他 %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>The scan does not tell it apart from: %1</source>
        <translation>スキャンでは次と区別できません: %1</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: look again.</source>
        <translation>その間にデザインが変わりました。探し直してください。</translation>
    </message>
    <message>
        <source>Stopped. The list is that of the search before.</source>
        <translation>停止しました。一覧は前回の検索の結果です。</translation>
    </message>
    <message>
        <source>The scan lies on the cover: there is nothing to explain.</source>
        <translation>スキャンはカバーと一致しています。説明することはありません。</translation>
    </message>
    <message>
        <source>Even the likeliest cause explains only %1 of it: there may be several, or others than these.</source>
        <translation>最も可能性の高い原因でも %1 しか説明できません。原因が複数か、これら以外かもしれません。</translation>
    </message>
    <message>
        <source>Foam is thicker or thinner</source>
        <translation>フォームが厚い、または薄い</translation>
    </message>
    <message>
        <source>Foam is harder or softer</source>
        <translation>フォームが硬い、または軟らかい</translation>
    </message>
    <message>
        <source>Allowance of a seam</source>
        <translation>縫い目の縫い代</translation>
    </message>
    <message>
        <source>Piece is larger or smaller</source>
        <translation>パーツが大きい、または小さい</translation>
    </message>
    <message>
        <source>Fixation lies elsewhere</source>
        <translation>固定の位置がずれている</translation>
    </message>
    <message>
        <source>Seam is sewn shifted</source>
        <translation>縫い目がずれて縫われている</translation>
    </message>
    <message>
        <source>%1 thicker</source>
        <translation>%1 厚い</translation>
    </message>
    <message>
        <source>%1 thinner</source>
        <translation>%1 薄い</translation>
    </message>
    <message>
        <source>%1 harder</source>
        <translation>%1 硬い</translation>
    </message>
    <message>
        <source>%1 softer</source>
        <translation>%1 軟らかい</translation>
    </message>
    <message>
        <source>%1 farther out</source>
        <translation>%1 外側</translation>
    </message>
    <message>
        <source>%1 farther in</source>
        <translation>%1 内側</translation>
    </message>
    <message>
        <source>%1 larger</source>
        <translation>%1 大きい</translation>
    </message>
    <message>
        <source>%1 smaller</source>
        <translation>%1 小さい</translation>
    </message>
    <message>
        <source>%1 counter-clockwise</source>
        <translation>反時計回りに %1</translation>
    </message>
    <message>
        <source>%1 clockwise</source>
        <translation>時計回りに %1</translation>
    </message>
    <message>
        <source>Farther out: the allowance was taken narrower, on both sides</source>
        <translation>外側: 両側で縫い代を狭くとって縫われた場合</translation>
    </message>
    <message>
        <source>Along the edge of %1, as it lies in the pattern</source>
        <translation>型紙に置かれた向きで見て、%1 の辺に沿って</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>%1 未満</translation>
    </message>
    <message>
        <source>The scan shows %1 of the cover. Its points lie %2 (rms) from the cover, of which all causes together leave %3. From the cover to the nearest point, as a fit measures, it is %4.</source>
        <translation>スキャンはカバーの %1 を捉えています。その点とカバーの差は %2 (RMS) で、すべての原因を合わせると、残りは %3 です。型紙を合わせるときのように、カバーから最も近い点まで測ると %4 です。</translation>
    </message>
    <message>
        <source>That is far more than such a cause usually is: there may be several, or others than these.</source>
        <translation>このような原因の通常の大きさをはるかに超えています。原因が複数か、これら以外かもしれません。</translation>
    </message>
    <message>
        <source>What the likeliest cause leaves is more than noise: something else may be wrong, too, and its amount may be off by more than is said.</source>
        <translation>最も可能性の高い原因で説明できずに残る分はノイズより大きく、ほかにも何かがおかしいかもしれず、その量は表示より大きく外れているかもしれません。</translation>
    </message>
    <message numerus="yes">
        <source>%n more causes explain some of it, less likely than these.</source>
        <translation>
            <numerusform>ほかに %n 個の原因も一部を説明しますが、可能性はこれらより低いです。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::ColourwayWindow</name>
    <message>
        <source>Compare colourways</source>
        <translation>カラーウェイを比較</translation>
    </message>
    <message>
        <source>The colourway that is shown below</source>
        <translation>下に表示するカラーウェイ</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>元の仕様</translation>
    </message>
</context>
<context>
    <name>bolster::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>コマンドを検索</translation>
    </message>
    <message>
        <source>There is no such command.</source>
        <translation>該当するコマンドはありません。</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>コマンド</translation>
    </message>
</context>
<context>
    <name>bolster::CompareWindow</name>
    <message>
        <source>&amp;Take from there</source>
        <translation>相手から取り込む(&amp;T)</translation>
    </message>
    <message>
        <source>Compare versions</source>
        <translation>バージョンを比較</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>相違点</translation>
    </message>
    <message>
        <source>There</source>
        <translation>相手</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>現在</translation>
    </message>
    <message>
        <source>Makes the chosen elements as they are in the other version: one step in the history</source>
        <translation>選んだ要素をもう一方のバージョンの状態にします (履歴の 1 ステップ)</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>only now</source>
        <translation>現在のみ</translation>
    </message>
    <message>
        <source>only there</source>
        <translation>相手のみ</translation>
    </message>
    <message>
        <source>Nothing differs</source>
        <translation>相違点なし</translation>
    </message>
    <message>
        <source>&amp;Move both together</source>
        <translation>両方を一緒に動かす(&amp;M)</translation>
    </message>
    <message>
        <source>Turning, moving or zooming one version does the same to the other</source>
        <translation>一方のバージョンの回転、移動、ズームがもう一方にも反映されます</translation>
    </message>
</context>
<context>
    <name>bolster::ContextMenus</name>
    <message>
        <source>Leave this &amp;piece out</source>
        <translation>この部分を除外(&amp;P)</translation>
    </message>
    <message>
        <source>Hides this piece of the frame from the view, drawing, cushioning and contact; the frame&apos;s properties bring it back</source>
        <translation>フレームのこの部分を表示、作図、クッション、接触から除きます。フレームのプロパティで戻せます</translation>
    </message>
</context>
<context>
    <name>bolster::CoverSelectTool</name>
    <message>
        <source>Kept to an axis; the same key frees it</source>
        <translation>軸に固定中。同じキーで解除</translation>
    </message>
    <message>
        <source>Lifted off the frame along its normal; let go of Ctrl to slide on it</source>
        <translation>法線に沿ってフレームから離れています。Ctrl を離すとフレーム上を滑ります</translation>
    </message>
    <message>
        <source>On the frame: Ctrl lifts off, S lets go of it, X, Y, Z or Shift keep to an axis</source>
        <translation>フレーム上: Ctrl で離す、S で解除、X、Y、Z または Shift で軸に固定</translation>
    </message>
    <message>
        <source>X, Y, Z or Shift keep to an axis, S keeps to the frame, Ctrl lifts off, Escape cancels</source>
        <translation>X、Y、Z または Shift で軸に固定、S でフレームに固定、Ctrl で離す、Esc でキャンセル</translation>
    </message>
    <message>
        <source>Moved by x %1, y %2, z %3</source>
        <translation>x %1、y %2、z %3 移動</translation>
    </message>
</context>
<context>
    <name>bolster::CutFindingsList</name>
    <message>
        <source>What to look at before cutting</source>
        <translation>裁断前に確認すること</translation>
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
        <translation>ダブルクリックで場所を表示。</translation>
    </message>
    <message>
        <source>Nothing to mend: the pattern can be cut.</source>
        <translation>修正箇所はありません。型紙を裁断できます。</translation>
    </message>
    <message>
        <source>Looking the pattern over …</source>
        <translation>型紙をチェックしています…</translation>
    </message>
    <message>
        <source>There is no pattern yet.</source>
        <translation>型紙はまだありません。</translation>
    </message>
</context>
<context>
    <name>bolster::DesignSession</name>
    <message>
        <source>New design</source>
        <translation>新しいデザイン</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>生地</translation>
    </message>
    <message>
        <source>Restored design</source>
        <translation>復元したデザイン</translation>
    </message>
    <message>
        <source> (other)</source>
        <translation> (別)</translation>
    </message>
    <message>
        <source> (other %1)</source>
        <translation> (別 %1)</translation>
    </message>
</context>
<context>
    <name>bolster::DockTitle</name>
    <message>
        <source>Take out of the window, or put back</source>
        <translation>ウィンドウから切り離す、または戻す</translation>
    </message>
    <message>
        <source>Close; the Window menu brings it back</source>
        <translation>閉じる。「ウィンドウ」メニューで再表示できます</translation>
    </message>
</context>
<context>
    <name>bolster::DropFlow</name>
    <message>
        <source>&quot;%1&quot; cannot be opened.</source>
        <translation>「%1」を開けません。</translation>
    </message>
    <message>
        <source>The system did not start the program again for another window. Open it from here instead.</source>
        <translation>システムが別のウィンドウ用にプログラムをもう一度起動できませんでした。代わりにここから開いてください。</translation>
    </message>
    <message>
        <source>It is a folder. Drop the files that are in it.</source>
        <translation>フォルダーです。中のファイルをドロップしてください。</translation>
    </message>
    <message>
        <source>It is not on this computer, or not any more. Save it to a folder first.</source>
        <translation>このコンピューターにないか、もうありません。先にフォルダーに保存してください。</translation>
    </message>
    <message>
        <source>Bolster opens projects and designs (%1), frames (%2), scans (%3), patterns (%4) and pictures of fabrics (%5). Save it in one of these formats with the program it comes from.</source>
        <translation>Bolster で開けるのは、プロジェクトとデザイン (%1)、フレーム (%2)、スキャン (%3)、型紙 (%4)、生地の画像 (%5) です。元のプログラムで、これらの形式のいずれかで保存してください。</translation>
    </message>
</context>
<context>
    <name>bolster::ElementsModel</name>
    <message>
        <source>Hidden in the 3D view</source>
        <translation>3D ビューで非表示</translation>
    </message>
</context>
<context>
    <name>bolster::ElementsView</name>
    <message>
        <source>Find an element</source>
        <translation>要素を検索</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>要素</translation>
    </message>
    <message>
        <source>By its name, or by a word of its note</source>
        <translation>名前またはメモの語で検索</translation>
    </message>
</context>
<context>
    <name>bolster::ExportFlow</name>
    <message>
        <source>Export pattern</source>
        <translation>型紙をエクスポート</translation>
    </message>
    <message>
        <source>-sewing</source>
        <translation>-縫製</translation>
    </message>
    <message>
        <source>-pattern</source>
        <translation>-型紙</translation>
    </message>
    <message>
        <source>%1 (*.%2)</source>
        <translation>%1 (*.%2)</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>%1 を書き出しています…</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>%1 にエクスポートしました</translation>
    </message>
    <message>
        <source>The pattern could not be exported.</source>
        <translation>型紙をエクスポートできませんでした。</translation>
    </message>
    <message>
        <source>Export cover</source>
        <translation>カバーをエクスポート</translation>
    </message>
    <message>
        <source>-cover</source>
        <translation>-カバー</translation>
    </message>
    <message>
        <source>Export foam</source>
        <translation>フォームをエクスポート</translation>
    </message>
    <message>
        <source>-foam</source>
        <translation>-フォーム</translation>
    </message>
    <message>
        <source>Exporting %1 …</source>
        <translation>%1 をエクスポートしています…</translation>
    </message>
    <message>
        <source>The cover could not be exported.</source>
        <translation>カバーをエクスポートできませんでした。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is written.</source>
        <translation>「%1」を書き出しました。</translation>
    </message>
    <message>
        <source>Export surface</source>
        <translation>面をエクスポート</translation>
    </message>
    <message>
        <source>The surface could not be exported.</source>
        <translation>面をエクスポートできませんでした。</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>画像をエクスポート</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>The picture could not be exported.</source>
        <translation>画像をエクスポートできませんでした。</translation>
    </message>
    <message>
        <source>-surface</source>
        <translation>-サーフェス</translation>
    </message>
</context>
<context>
    <name>bolster::ExportPatternDialog</name>
    <message>
        <source>Export pattern</source>
        <translation>型紙をエクスポート</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>&amp;Export …</source>
        <translation>エクスポート(&amp;E)…</translation>
    </message>
    <message>
        <source>PDF – to print and put together</source>
        <translation>PDF – 印刷して貼り合わせる</translation>
    </message>
    <message>
        <source>DXF AAMA – for cutters</source>
        <translation>DXF AAMA – 裁断機用</translation>
    </message>
    <message>
        <source>DXF ASTM – for cutters</source>
        <translation>DXF ASTM – 裁断機用</translation>
    </message>
    <message>
        <source>DXF, plain lines</source>
        <translation>DXF、単純な線</translation>
    </message>
    <message>
        <source>SVG – 1:1</source>
        <translation>SVG – 1:1</translation>
    </message>
    <message>
        <source>HPGL – for plotters</source>
        <translation>HPGL – プロッター用</translation>
    </message>
    <message>
        <source>Roll, %1 mm wide</source>
        <translation>ロール、幅 %1&#xa0;mm</translation>
    </message>
    <message>
        <source>&amp;Landscape</source>
        <translation>横向き(&amp;L)</translation>
    </message>
    <message>
        <source>Mirrored pairs as &amp;two pieces</source>
        <translation>左右対を 2 枚として(&amp;T)</translation>
    </message>
    <message>
        <source>The design says it; it is changed in its properties.</source>
        <translation>デザインの設定です。デザインのプロパティで変更します。</translation>
    </message>
    <message>
        <source>Of patches and edges that have none of their own.</source>
        <translation>独自の設定のないパーツと辺。</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>形式(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Paper</source>
        <translation>用紙(&amp;P)</translation>
    </message>
    <message>
        <source>Seam &amp;allowance</source>
        <translation>縫い代(&amp;A)</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>線</translation>
    </message>
    <message>
        <source>Sewing li&amp;nes</source>
        <translation>出来上がり線(&amp;N)</translation>
    </message>
    <message>
        <source>Notc&amp;hes</source>
        <translation>ノッチ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Grain lines</source>
        <translation>地の目線(&amp;G)</translation>
    </message>
    <message>
        <source>La&amp;bels</source>
        <translation>ラベル(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Internal lines</source>
        <translation>内部線(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Drill holes</source>
        <translation>ドリル穴(&amp;D)</translation>
    </message>
    <message numerus="yes">
        <source>%n pages</source>
        <translation>
            <numerusform>%n ページ</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n patches are left out: their outlines cross themselves</source>
        <translation>
            <numerusform>パーツ %n 個を除外しました: 輪郭が自身と交差しています</numerusform>
        </translation>
    </message>
    <message>
        <source>C&amp;ut lines</source>
        <translation>裁断線(&amp;U)</translation>
    </message>
    <message>
        <source>Sewing sheet (PDF)</source>
        <translation>縫製シート (PDF)</translation>
    </message>
    <message>
        <source>DXF, plain curves (R2000)</source>
        <translation>DXF、単純な曲線 (R2000)</translation>
    </message>
    <message>
        <source>too many sheets: is its unit right?</source>
        <translation>シートが多すぎます。単位は正しいですか?</translation>
    </message>
    <message>
        <source>the first %1 are shown</source>
        <translation>最初の %1 件を表示</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>裁断するものがありません。</translation>
    </message>
    <message>
        <source>A double click leaves this window and shows where it is; the whole list is in the panel &quot;Check before cutting&quot;.</source>
        <translation>ダブルクリックでこのウィンドウを離れ、場所を表示します。一覧全体は「裁断前チェック」パネルにあります。</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces on %1</source>
        <translation>
            <numerusform>パーツ %n 個、%1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FabricCommands</name>
    <message>
        <source>Rename fabric</source>
        <translation>生地の名前を変更</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>名前:</translation>
    </message>
    <message>
        <source>Delete fabric</source>
        <translation>生地を削除</translation>
    </message>
    <message numerus="yes">
        <source>%n patches have &quot;%1&quot;. What shall they get instead?</source>
        <translation>
            <numerusform>「%1」のパーツが %n 個あります。代わりに何を割り当てますか?</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the patches that shall get the fabric, then choose it in the library.</source>
        <translation>生地を割り当てるパーツを選択し、ライブラリで生地を選んでください。</translation>
    </message>
    <message>
        <source>New colourway</source>
        <translation>新しいカラーウェイ</translation>
    </message>
    <message>
        <source>Name of the colourway; it begins as what is shown now:</source>
        <translation>カラーウェイの名前 (現在の表示から始まります):</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>カラーウェイ</translation>
    </message>
    <message>
        <source>Rename colourway</source>
        <translation>カラーウェイの名前を変更</translation>
    </message>
    <message>
        <source>Picture of a fabric</source>
        <translation>生地の画像</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>画像 (%1)</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 を読み込んでいます…</translation>
    </message>
    <message>
        <source>The picture could not be read.</source>
        <translation>画像を読み込めませんでした。</translation>
    </message>
    <message>
        <source>The picture could not be taken into the design.</source>
        <translation>画像をデザインに取り込めませんでした。</translation>
    </message>
    <message>
        <source>Import fabrics</source>
        <translation>生地をインポート</translation>
    </message>
    <message>
        <source>Fabrics, designs and projects (*.json *.bolster)</source>
        <translation>生地、デザイン、プロジェクト (*.json *.bolster)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be read.</source>
        <translation>「%1」を読み込めませんでした。</translation>
    </message>
    <message>
        <source>Nothing was imported.</source>
        <translation>何もインポートされませんでした。</translation>
    </message>
    <message numerus="yes">
        <source>%n fabrics imported from %1</source>
        <translation>
            <numerusform>%1 から %n 種の生地をインポートしました</numerusform>
        </translation>
    </message>
    <message>
        <source>Export fabric</source>
        <translation>生地をエクスポート</translation>
    </message>
    <message>
        <source>Fabrics (*.json)</source>
        <translation>生地 (*.json)</translation>
    </message>
    <message>
        <source>The fabric could not be exported.</source>
        <translation>生地をエクスポートできませんでした。</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>%1 にエクスポートしました</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not deleted.</source>
        <translation>「%1」は削除されません。</translation>
    </message>
    <message>
        <source>It is the only fabric, and patches are made of it. Add another one first.</source>
        <translation>これは唯一の生地で、使用中のパーツがあります。先に別の生地を追加してください。</translation>
    </message>
</context>
<context>
    <name>bolster::FabricPanel</name>
    <message>
        <source>Colourways</source>
        <translation>カラーウェイ</translation>
    </message>
    <message>
        <source>A click shows the cover in this colourway</source>
        <translation>クリックでカバーをこのカラーウェイで表示</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>生地</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>カラーウェイ</translation>
    </message>
    <message>
        <source>New …</source>
        <translation>新規…</translation>
    </message>
    <message>
        <source>Rename …</source>
        <translation>名前を変更…</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>Fabrics: drag them onto patches</source>
        <translation>生地: パーツへドラッグ</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>割り当て</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Delete …</source>
        <translation>削除…</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>元の仕様</translation>
    </message>
    <message>
        <source>No patch has it.</source>
        <translation>使用しているパーツはありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n patches have it.</source>
        <translation>
            <numerusform>%n 個のパーツが使用しています。</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag it onto a patch; a double click shows its properties.</source>
        <translation>パーツへドラッグ。ダブルクリックでプロパティを表示。</translation>
    </message>
    <message>
        <source>Adds this fabric to the library of the design</source>
        <translation>この生地をデザインのライブラリに追加します</translation>
    </message>
</context>
<context>
    <name>bolster::FieldText</name>
    <message>
        <source>usual</source>
        <translation>標準</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>turned by %1</source>
        <translation>%1 回転</translation>
    </message>
    <message>
        <source>%1, from %2 to %3</source>
        <translation>%1、%2 から %3</translation>
    </message>
    <message numerus="yes">
        <source>%n points, %1</source>
        <translation>
            <numerusform>%n 点、%1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FileChoice</name>
    <message>
        <source>A file …</source>
        <translation>ファイル…</translation>
    </message>
</context>
<context>
    <name>bolster::FileImportDialog</name>
    <message>
        <source> mm per unit</source>
        <translation> mm/単位</translation>
    </message>
    <message>
        <source>Import scan</source>
        <translation>スキャンをインポート</translation>
    </message>
    <message>
        <source>Import frame</source>
        <translation>フレームをインポート</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>インチ</translation>
    </message>
    <message>
        <source>Another factor</source>
        <translation>その他の倍率</translation>
    </message>
    <message>
        <source>z points up</source>
        <translation>z が上</translation>
    </message>
    <message>
        <source>y points up</source>
        <translation>y が上</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 点</translation>
    </message>
    <message>
        <source>Width, depth, height</source>
        <translation>幅、奥行、高さ</translation>
    </message>
    <message>
        <source>That is unusual for a piece of furniture: check the unit.</source>
        <translation>家具としては通常でない大きさです。単位を確認してください。</translation>
    </message>
    <message>
        <source>&amp;Keep scale, position and rotation</source>
        <translation>縮尺、位置、回転を保持(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Place it on the floor, in the middle</source>
        <translation>床の中央に置く(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>ファイルの単位(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Factor</source>
        <translation>倍率(&amp;F)</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>軸(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>インポート(&amp;I)</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>It would be %1 large. Import it like that?</source>
        <translation>大きさが %1 になります。このままインポートしますか?</translation>
    </message>
    <message>
        <source>Another unit or factor makes it as large as it is meant.</source>
        <translation>別の単位または倍率で、本来の大きさになります。</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>フィート</translation>
    </message>
    <message>
        <source>x points up</source>
        <translation>x が上</translation>
    </message>
    <message>
        <source>The file says its unit and its axes.</source>
        <translation>単位と軸はファイルに記載されています。</translation>
    </message>
    <message numerus="yes">
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points, %Ln triangles</source>
        <translation>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 点、三角形 %Ln 個</numerusform>
        </translation>
    </message>
    <message>
        <source>The file says its unit; the axes are guessed.</source>
        <translation>単位はファイルの記載、軸は推定です。</translation>
    </message>
    <message>
        <source>The file says its axes; the unit is guessed.</source>
        <translation>軸はファイルの記載、単位は推定です。</translation>
    </message>
    <message>
        <source>Unit and axes are guessed: look at the picture and the size.</source>
        <translation>単位と軸は推定です。図と大きさを確認してください。</translation>
    </message>
    <message>
        <source>&amp;Keep position and rotation</source>
        <translation>位置と回転を保持(&amp;K)</translation>
    </message>
    <message>
        <source>The file has %1 points. That is more than are needed to fit a cover, so they were thinned out to one every %2.</source>
        <translation>ファイルには %1 点あります。カバーを合わせるには多すぎるため、%2 ごとに 1 点に間引きました。</translation>
    </message>
    <message>
        <source>It was %1 large and becomes %2: check the unit.</source>
        <translation>大きさが %1 から %2 になります。単位を確認してください。</translation>
    </message>
    <message>
        <source>The unit is guessed: look at the size.</source>
        <translation>単位は推測です。大きさを確認してください。</translation>
    </message>
    <message>
        <source>The axes are guessed: look at the picture.</source>
        <translation>軸は推測です。画像を確認してください。</translation>
    </message>
</context>
<context>
    <name>bolster::FileTalk</name>
    <message>
        <source>&quot;%1&quot; is not replaced.</source>
        <translation>「%1」は置き換えられません。</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 を読み込んでいます…</translation>
    </message>
</context>
<context>
    <name>bolster::FitOrderPanel</name>
    <message>
        <source>Goal</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>The cover &amp;lies on</source>
        <translation>カバーを沿わせる対象(&amp;L)</translation>
    </message>
    <message>
        <source>The form that the cover shall lie on</source>
        <translation>カバーを沿わせる形状</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>&amp;Strain is at most</source>
        <translation>ひずみの上限(&amp;S)</translation>
    </message>
    <message>
        <source>Along the grain, across it, and in shear; the cover stays where it is</source>
        <translation>地の目方向、直交方向、せん断。カバーの位置は変わりません</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Limit of strain</source>
        <translation>ひずみの限界</translation>
    </message>
    <message>
        <source>&amp;No folds in selected patches</source>
        <translation>選択したパーツにしわなし(&amp;N)</translation>
    </message>
    <message>
        <source>No cloth of them is pressed together; none selected: all</source>
        <translation>生地が押し縮められないようにします。選択なし: すべて</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>The selected seam r&amp;uns along</source>
        <translation>選択した縫い目を沿わせる曲線(&amp;U)</translation>
    </message>
    <message>
        <source>A curve drawn on the frame or the form; it need hold nothing</source>
        <translation>フレームまたは形状に描いた曲線。何も固定していなくてもかまいません</translation>
    </message>
    <message>
        <source>Share of the area</source>
        <translation>面積の割合</translation>
    </message>
    <message>
        <source>Area of selected patches &amp;becomes</source>
        <translation>選択したパーツの面積の割合(&amp;K)</translation>
    </message>
    <message>
        <source>Less than 100 %: they become smaller</source>
        <translation>100 % 未満: 小さくなります</translation>
    </message>
    <message>
        <source>What may change</source>
        <translation>変更するもの</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>輪郭(&amp;O)</translation>
    </message>
    <message>
        <source>Control points of the patches</source>
        <translation>パーツの制御点</translation>
    </message>
    <message>
        <source>Ends of seams</source>
        <translation>縫い目の端</translation>
    </message>
    <message>
        <source>Where seams and fixations end on smooth edges</source>
        <translation>縫い目と固定が滑らかな縁で終わる位置</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>いせ</translation>
    </message>
    <message>
        <source>Sides of seams may come to differ in length; that is then the ease wanted</source>
        <translation>縫い目の両側の長さが違ってもよく、その差が目標のいせになります</translation>
    </message>
    <message>
        <source>Fo&amp;am</source>
        <translation>フォーム(&amp;A)</translation>
    </message>
    <message>
        <source>How thick cushions and foam are, by whole voxels</source>
        <translation>クッションとフォームの厚さ (ボクセル単位)</translation>
    </message>
    <message>
        <source>F&amp;ixations</source>
        <translation>固定(&amp;I)</translation>
    </message>
    <message>
        <source>Where fixation curves lie: on their frames, or in space where there is none</source>
        <translation>固定曲線の位置：フレームの上、フレームがなければ空間内</translation>
    </message>
    <message>
        <source>&amp;Pressure</source>
        <translation>圧力(&amp;P)</translation>
    </message>
    <message>
        <source>The pressure under each patch</source>
        <translation>各パーツの下の圧力</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>伸び</translation>
    </message>
    <message>
        <source>Stiffness of the fabrics, and how much they contract across a pull</source>
        <translation>生地の剛性と、引いたときに横へ縮む度合い</translation>
    </message>
    <message>
        <source>Of sele&amp;cted patches only</source>
        <translation>選択したパーツのみ(&amp;C)</translation>
    </message>
    <message>
        <source>What stays</source>
        <translation>保持するもの</translation>
    </message>
    <message>
        <source>L&amp;engths of seams</source>
        <translation>縫い目の長さ(&amp;E)</translation>
    </message>
    <message>
        <source>The sides of a seam keep their difference; if it is far from the seam&apos;s ease, it comes nearer to it</source>
        <translation>縫い目の両側の長さの差を保ちます。縫い目のいせから大きく外れていれば、いせに近づけます</translation>
    </message>
    <message>
        <source>St&amp;raight edges</source>
        <translation>直線の辺(&amp;R)</translation>
    </message>
    <message>
        <source>An&amp;gles of corners</source>
        <translation>角の角度(&amp;G)</translation>
    </message>
    <message>
        <source>No point &amp;moves farther than</source>
        <translation>点の移動の上限(&amp;M)</translation>
    </message>
    <message>
        <source>Choose the scan or the file that the cover shall lie on.</source>
        <translation>カバーを沿わせるスキャンまたはファイルを選んでください。</translation>
    </message>
    <message>
        <source>Select the seam that shall run along the curve.</source>
        <translation>曲線に沿わせる縫い目を選択してください。</translation>
    </message>
    <message>
        <source>Paint the area in the 3D view, or untick it.</source>
        <translation>3D ビューで範囲を塗るか、チェックを外してください。</translation>
    </message>
    <message>
        <source>Select the patches that shall become larger or smaller.</source>
        <translation>大きく、または小さくするパーツを選択してください。</translation>
    </message>
    <message>
        <source>Choose a goal.</source>
        <translation>目標を選んでください。</translation>
    </message>
    <message>
        <source>Edges that look straight stay so: those that bow by less than %1 in %2</source>
        <translation>まっすぐに見える縁はそのままです：%2で%1未満しか反っていないもの</translation>
    </message>
</context>
<context>
    <name>bolster::FlatPiecesView</name>
    <message>
        <source>Pieces laid flat</source>
        <translation>展開したパーツ</translation>
    </message>
    <message>
        <source>Strain: %1</source>
        <translation>ひずみ：%1</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 以上</translation>
    </message>
    <message>
        <source>%1: strain %2 (rms)</source>
        <translation>%1: ひずみ %2（rms）</translation>
    </message>
</context>
<context>
    <name>bolster::FormChoice</name>
    <message>
        <source>Meshes and scans (%1);;All files (*)</source>
        <translation>メッシュとスキャン (%1);;すべてのファイル (*)</translation>
    </message>
</context>
<context>
    <name>bolster::FormPatternWindow</name>
    <message>
        <source>&amp;Make the pattern</source>
        <translation>型紙を作成(&amp;M)</translation>
    </message>
    <message>
        <source>Laying it flat …</source>
        <translation>展開しています…</translation>
    </message>
    <message>
        <source>&amp;Make it without what is left out</source>
        <translation>除外したもの以外で作成(&amp;M)</translation>
    </message>
    <message>
        <source>Laying a form flat …</source>
        <translation>形状を平らに展開しています…</translation>
    </message>
    <message>
        <source>What came of it</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Choose a file with a form above, or import a frame first.</source>
        <translation>上で形状のファイルを選ぶか、先にフレームを読み込んでください。</translation>
    </message>
    <message>
        <source>It is laid flat again when you let go.</source>
        <translation>放すと、もう一度平らに展開します。</translation>
    </message>
    <message numerus="yes">
        <source>Dividing it, %n pieces so far …</source>
        <translation>
            <numerusform>分割中、これまでに %n 個 …</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Lay it flat</source>
        <translation>平らに展開(&amp;L)</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>停止しました。</translation>
    </message>
    <message>
        <source>It was stopped. These are the pieces from before.</source>
        <translation>停止しました。これは以前のパーツです。</translation>
    </message>
    <message>
        <source>From a form</source>
        <translation>形状から</translation>
    </message>
</context>
<context>
    <name>bolster::FormWishesPanel</name>
    <message>
        <source>The form to be covered</source>
        <translation>カバーをかける形状</translation>
    </message>
    <message>
        <source>Meshes and CAD files (%1);;All files (*)</source>
        <translation>メッシュと CAD ファイル (%1);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Where the grain line runs on the form</source>
        <translation>形状の上での地の目の向き</translation>
    </message>
    <message>
        <source>upwards</source>
        <translation>上へ</translation>
    </message>
    <message>
        <source>to the back</source>
        <translation>後ろへ</translation>
    </message>
    <message>
        <source>sideways</source>
        <translation>横へ</translation>
    </message>
    <message>
        <source>&amp;Form</source>
        <translation>形状(&amp;F)</translation>
    </message>
    <message>
        <source>Fa&amp;bric</source>
        <translation>生地(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Grain runs</source>
        <translation>地の目(&amp;G)</translation>
    </message>
    <message>
        <source>It is cut</source>
        <translation>切る場所</translation>
    </message>
    <message>
        <source>and along the ticked lines:</source>
        <translation>チェックした線でも切る:</translation>
    </message>
    <message>
        <source>where its &amp;parts meet</source>
        <translation>グループの境目(&amp;P)</translation>
    </message>
    <message>
        <source>at the edges of its &amp;CAD faces</source>
        <translation>CAD 面の縁で(&amp;C)</translation>
    </message>
    <message>
        <source>Each face as the CAD program has it, also where two go on smoothly in each other</source>
        <translation>CAD プログラムにあるとおりの面ごとに。滑らかにつながる面どうしも分けます</translation>
    </message>
    <message>
        <source>where it &amp;bends by more than</source>
        <translation>曲がりが次を超える所(&amp;B)</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>where it would &amp;not lie flat</source>
        <translation>平らにならない所(&amp;N)</translation>
    </message>
    <message>
        <source>Pieces that would lie over themselves, or be strained by more than the fabric may be, are divided where they bend most or are narrow; an armchair takes some seconds</source>
        <translation>自身と重なるパーツや、生地の許容を超えて伸びるパーツを、最も曲がる所や細い所で分割します。肘掛け椅子で数秒かかります</translation>
    </message>
    <message>
        <source>Keep its cover &amp;outside of the frame</source>
        <translation>カバーをフレームの外側に保つ(&amp;O)</translation>
    </message>
    <message>
        <source>Making the pattern ticks &quot;Keeps the cover outside&quot; at the frame. A cover that is held along its seams alone may sink into the frame or turn inside out.</source>
        <translation>パターンを作ると、フレームの「カバーを外側に保つ」にチェックが入ります。縫い目だけで留められたカバーは、フレームに沈んだり裏返ったりすることがあります。</translation>
    </message>
    <message>
        <source>Patches that this form became before go, with their seams and the curves that hold nothing else. One Undo brings them back.</source>
        <translation>この形から以前作られたパーツが、その縫い目と、ほかに何も留めていないカーブとともに消えます。一度の「元に戻す」で戻ります。</translation>
    </message>
    <message>
        <source>The cover as it is</source>
        <translation>現在のカバー</translation>
    </message>
    <message>
        <source>Choose a form</source>
        <translation>形状を選択</translation>
    </message>
    <message>
        <source>New fabric</source>
        <translation>新しい生地</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>生地</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Replace the %n patches of these names</source>
        <translation>
            <numerusform>これらの名前のパーツ %n 個を置き換える(&amp;R)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>(%n curves that hold them will hold nothing)</source>
        <translation>
            <numerusform>（それらを留めている曲線 %n 本は何も留めなくなります）</numerusform>
        </translation>
    </message>
    <message>
        <source>They end inside a piece (marked in the 3D view) and do not divide it: each goes on to the border or line that is nearest, along the way shown there</source>
        <translation>パーツの内側で終わっていて（3Dビューに印があります）、パーツを分けていません。それぞれそこに示された道に沿って最も近い縁または線まで延びます</translation>
    </message>
    <message numerus="yes">
        <source>Lead %n open ends &amp;on</source>
        <translation>
            <numerusform>開いた端%n個を延ばす(&amp;O)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FoundPiecesView</name>
    <message>
        <source>Pieces in the file</source>
        <translation>ファイル内のパーツ</translation>
    </message>
    <message>
        <source>There is no piece in it.</source>
        <translation>パーツがありません。</translation>
    </message>
    <message>
        <source>Reading …</source>
        <translation>読み込んでいます…</translation>
    </message>
</context>
<context>
    <name>bolster::GlCanvas</name>
    <message>
        <source>No OpenGL: drawn in software</source>
        <translation>OpenGL なし: ソフトウェア描画</translation>
    </message>
    <message>
        <source>OpenGL is older than 3.3: drawn in software</source>
        <translation>OpenGL が 3.3 より古い: ソフトウェア描画</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryModel</name>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>変更</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryPanel</name>
    <message>
        <source>Find a change or a version</source>
        <translation>変更またはバージョンを検索</translation>
    </message>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryView</name>
    <message>
        <source>&amp;Go to this version</source>
        <translation>このバージョンに移動(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Name this version …</source>
        <translation>このバージョンに名前を付ける(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Remove its name</source>
        <translation>名前を削除(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Compare with now …</source>
        <translation>現在と比較(&amp;C)…</translation>
    </message>
    <message>
        <source>Name of this branch</source>
        <translation>この分岐の名前</translation>
    </message>
    <message>
        <source>Name of this version</source>
        <translation>このバージョンの名前</translation>
    </message>
    <message>
        <source>Name this &amp;branch …</source>
        <translation>この分岐に名前を付ける(&amp;B)…</translation>
    </message>
</context>
<context>
    <name>bolster::ImportFlow</name>
    <message>
        <source>Frames (%1)</source>
        <translation>フレーム (%1)</translation>
    </message>
    <message>
        <source>Scans (%1)</source>
        <translation>スキャン (%1)</translation>
    </message>
    <message>
        <source>Import frame</source>
        <translation>フレームをインポート</translation>
    </message>
    <message>
        <source>Import scan</source>
        <translation>スキャンをインポート</translation>
    </message>
    <message>
        <source>Import pattern</source>
        <translation>型紙をインポート</translation>
    </message>
    <message>
        <source>Patterns (%1)</source>
        <translation>型紙 (%1)</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>別のファイルを選択</translation>
    </message>
    <message>
        <source>The pattern is imported. What is otherwise than in the file:</source>
        <translation>型紙をインポートしました。ファイルとの相違点:</translation>
    </message>
    <message>
        <source>Simplifying %1 …</source>
        <translation>%1 を単純化しています…</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>%1 を書き出しています…</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be imported.</source>
        <translation>「%1」をインポートできませんでした。</translation>
    </message>
</context>
<context>
    <name>bolster::ImportPatternDialog</name>
    <message>
        <source>Import pattern</source>
        <translation>型紙をインポート</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>インポート(&amp;I)</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>インチ</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>Sewing lines, with allowances</source>
        <translation>出来上がり線 (縫い代あり)</translation>
    </message>
    <message>
        <source>Cut lines, without allowance</source>
        <translation>裁断線 (縫い代なし)</translation>
    </message>
    <message>
        <source>What the outlines of patches become where the file has both lines.</source>
        <translation>ファイルに両方の線がある場合に、パーツの輪郭とする線。</translation>
    </message>
    <message>
        <source>Outlines whose ends are no farther apart are closed by a straight line.</source>
        <translation>端の間隔がこれ以下の輪郭を直線で閉じます。</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>ファイルの単位(&amp;U)</translation>
    </message>
    <message>
        <source>Largest piece</source>
        <translation>最大のパーツ</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>サイズ(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>輪郭(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Close gaps up to</source>
        <translation>閉じるすき間の上限(&amp;C)</translation>
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
            <numerusform>、%n 対</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n times</source>
        <translation>
            <numerusform>、%n 枚</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines lay twice on themselves and are taken once.</source>
        <translation>
            <numerusform>二重になっていた線 %n 本を 1 本にしました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Not read: %1</source>
        <translation>読み込まれないもの: %1</translation>
    </message>
    <message>
        <source>The file does not say its unit for certain: look at the measures.</source>
        <translation>ファイルの単位が確実ではありません。寸法を確認してください。</translation>
    </message>
    <message>
        <source>Pixels (1/96 inch)</source>
        <translation>ピクセル (1/96 インチ)</translation>
    </message>
    <message>
        <source>Points (1/72 inch)</source>
        <translation>ポイント (1/72 インチ)</translation>
    </message>
    <message>
        <source>In no piece and left out, by layer: %1</source>
        <translation>パーツの外にあり除外したもの (レイヤー別): %1</translation>
    </message>
    <message>
        <source>Marks of grading, stripes or nothing that is known, left out by layer: %1</source>
        <translation>グレーディングや縞の印、または不明なため除外したもの (レイヤー別): %1</translation>
    </message>
    <message>
        <source>%1 has %2 pieces; at most %3 can be imported at once: the first ones are chosen.</source>
        <translation>%1 にはパーツが %2 個あります。一度にインポートできるのは %3 個までなので、最初のものを選びました。</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message numerus="yes">
        <source>%n outlines are open: their ends are up to %1 apart. Close gaps up to that, if they are outlines.</source>
        <translation>
            <numerusform>%n 本の輪郭が開いています。端の間隔は最大 %1 です。輪郭であれば、すき間をそこまで閉じてください。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::JobsPanel</name>
    <message>
        <source>Nothing is being worked at.</source>
        <translation>実行中の処理はありません。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>ジョブ</translation>
    </message>
</context>
<context>
    <name>bolster::LeftWork</name>
    <message>
        <source>New design</source>
        <translation>新しいデザイン</translation>
    </message>
    <message numerus="yes">
        <source>%n more designs are under File &gt; Unsaved work.</source>
        <translation>
            <numerusform>他 %n 件のデザインが「ファイル &gt; 未保存の作業」にあります。</numerusform>
        </translation>
    </message>
    <message>
        <source>Restoring the work on &quot;%1&quot; …</source>
        <translation>「%1」の作業を復元しています…</translation>
    </message>
    <message>
        <source>The work stays under File &gt; Unsaved work</source>
        <translation>作業は「ファイル &gt; 未保存の作業」に残ります</translation>
    </message>
    <message>
        <source>The unsaved work on &quot;%1&quot; could not be restored.</source>
        <translation>「%1」の未保存の作業を復元できませんでした。</translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved edits restored.</source>
        <translation>
            <numerusform>未保存の編集 %n 件を復元しました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved edits are in the history, undone or on other branches.</source>
        <translation>
            <numerusform>元に戻した、または他の分岐にある未保存の編集 %n 件が履歴にあります。</numerusform>
        </translation>
    </message>
    <message>
        <source>Unsaved names of versions or branches restored.</source>
        <translation>バージョンまたは分岐の未保存の名前を復元しました。</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>表示(&amp;O)</translation>
    </message>
    <message>
        <source>Go &amp;back to saved</source>
        <translation>保存した状態に戻る(&amp;B)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>%1, %2, damaged</source>
        <translation>%1、%2、破損</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>なし</translation>
    </message>
</context>
<context>
    <name>bolster::MainWindow</name>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>%1[*] – Bolster</source>
        <translation>%1[*] – Bolster</translation>
    </message>
    <message>
        <source>%1 It is back where it was.</source>
        <translation>%1 元の場所に戻りました。</translation>
    </message>
    <message>
        <source>More commands</source>
        <translation>その他のコマンド</translation>
    </message>
    <message>
        <source>The cover sprang by %1.</source>
        <translation>カバーが %1 跳びました。</translation>
    </message>
    <message>
        <source>Folded cloth can lie in several ways, and where a drag leaves it depends on the way of the pointer. What you see now follows from the design alone: whoever opens it sees the same, and so do exports and pictures. If you want the other shape, tell the design: hold the cloth there with a handle, or make the piece smaller until it needs no folds.</source>
        <translation>しわのある生地の収まり方は一通りではなく、ドラッグ後の形はポインターの通り道で変わります。今の表示はデザインだけで決まり、誰が開いても、エクスポートや画像でも同じです。もう一方の形にしたい場合は、デザインで指定してください。ハンドル曲線で生地をそこに保持するか、しわが要らなくなるまでパーツを小さくします。</translation>
    </message>
    <message>
        <source>%1[*] (read-only) – Bolster</source>
        <translation>%1[*] (読み取り専用) – Bolster</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces are in the pattern. Seam &gt; Propose seams finds what belongs together.</source>
        <translation>
            <numerusform>型紙に %n 個のパーツがあります。「縫い目 &gt; 縫い目を提案」で組み合わせを探せます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>Bolster is still working at something.</source>
        <translation>Bolster はまだ処理中です。</translation>
    </message>
    <message>
        <source>What is closed now is not finished; files that are being written stay as they were.</source>
        <translation>今閉じると、処理は完了しません。書き出し中のファイルは元のままです。</translation>
    </message>
    <message>
        <source>&amp;Stop it and close</source>
        <translation>停止して閉じる(&amp;S)</translation>
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
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>This change has taken away as well: %1</source>
        <translation>この変更により次のものもなくなりました: %1</translation>
    </message>
</context>
<context>
    <name>bolster::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>マニュアル</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目次</translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>戻る (Alt+左)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation>進む (Alt+右)</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>進む</translation>
    </message>
    <message>
        <source>Find in all pages</source>
        <translation>すべてのページを検索</translation>
    </message>
    <message>
        <source>The manual has no page &quot;%1&quot;.</source>
        <translation>マニュアルに「%1」というページはありません。</translation>
    </message>
    <message>
        <source>The manual is in English.</source>
        <translation>マニュアルは英語です。</translation>
    </message>
</context>
<context>
    <name>bolster::MapLegend</name>
    <message>
        <source>over the fabric&apos;s limit</source>
        <translation>生地の限界超過</translation>
    </message>
</context>
<context>
    <name>bolster::MapLink</name>
    <message>
        <source>Largest strain</source>
        <translation>最大ひずみ</translation>
    </message>
    <message>
        <source>Strain along the grain</source>
        <translation>地の目方向のひずみ</translation>
    </message>
    <message>
        <source>Strain across the grain</source>
        <translation>直交方向のひずみ</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>せん断</translation>
    </message>
    <message>
        <source>Mean curvature</source>
        <translation>平均曲率</translation>
    </message>
    <message>
        <source>Distance to the frame</source>
        <translation>フレームまでの距離</translation>
    </message>
    <message>
        <source>hollow</source>
        <translation>凹</translation>
    </message>
    <message>
        <source>bulging</source>
        <translation>凸</translation>
    </message>
    <message>
        <source>pressed</source>
        <translation>圧縮</translation>
    </message>
    <message>
        <source>stretched</source>
        <translation>伸び</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%2 で %1</translation>
    </message>
    <message>
        <source>%1, over the limit of %2</source>
        <translation>%1、限界 %2 を超過</translation>
    </message>
    <message>
        <source>Here: %1</source>
        <translation>ここ: %1</translation>
    </message>
    <message>
        <source>over the fabric&apos;s limit</source>
        <translation>生地の限界超過</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>内側</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>外側</translation>
    </message>
    <message>
        <source>Deviation from the scan</source>
        <translation>スキャンとの偏差</translation>
    </message>
</context>
<context>
    <name>bolster::MarkTool</name>
    <message>
        <source>Hole %1</source>
        <translation>穴 %1</translation>
    </message>
    <message>
        <source>Click to select it, drag to move it – its properties say what it is like</source>
        <translation>クリックで選択、ドラッグで移動。詳細はプロパティにあります</translation>
    </message>
    <message>
        <source>Click a corner of an outline to choose how its cut lines are joined – Esc ends the tool</source>
        <translation>輪郭の角をクリックして裁断線のつなぎ方を選択。Esc でツールを終了</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no distance from the corner on this edge.</source>
        <translation>「%1」はこの辺上の角からの距離ではありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no place: try 120, 40</source>
        <translation>「%1」は位置ではありません (例: 120, 40)</translation>
    </message>
    <message>
        <source>Click an outline to place a notch, or type how far it is from the corner; on a seam the other side gets one, too – Esc ends the tool</source>
        <translation>輪郭をクリックしてノッチを配置するか、角からの距離を入力。縫い目では反対側にも付きます。Esc でツールを終了</translation>
    </message>
    <message>
        <source>Click inside a patch to place a drill hole, or type where: 120, 40 – Esc ends the tool</source>
        <translation>パーツ内をクリックしてドリル穴を配置するか、位置を入力: 120, 40。Esc でツールを終了</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no width of an allowance: try 12</source>
        <translation>「%1」は縫い代の幅ではありません (例: 12)</translation>
    </message>
    <message>
        <source>Drag its handle, or type its width – its properties say what it is like</source>
        <translation>ハンドルをドラッグするか、幅を入力。詳細はプロパティにあります</translation>
    </message>
    <message>
        <source>Click an edge to give it a seam allowance of its own, or type its width; drag its handle – Esc ends the tool</source>
        <translation>辺をクリックして独自の縫い代を設定するか、幅を入力。ハンドルのドラッグも可。Esc でツールを終了</translation>
    </message>
    <message>
        <source>Point at an outline, then type how far the notch is from the corner</source>
        <translation>輪郭を指し、角からノッチまでの距離を入力</translation>
    </message>
    <message>
        <source>Point into a patch, then type where the drill hole lies: 120, 40</source>
        <translation>パーツ内を指し、ドリル穴の位置を入力: 120, 40</translation>
    </message>
    <message>
        <source>Point at an edge, then type how wide its allowance is</source>
        <translation>辺を指し、縫い代の幅を入力</translation>
    </message>
</context>
<context>
    <name>bolster::NextStep</name>
    <message>
        <source>Next: %1 for the other side.</source>
        <translation>次: 反対側用に%1。</translation>
    </message>
    <message>
        <source>draw a second patch</source>
        <translation>2 つ目のパーツを描く</translation>
    </message>
    <message>
        <source>Next: %1 – click an edge, then the edge it is sewn to.</source>
        <translation>次: %1。辺をクリックし、続けて縫い合わせる辺をクリック。</translation>
    </message>
    <message>
        <source>sew the patches</source>
        <translation>パーツを縫う</translation>
    </message>
    <message>
        <source>Next: %1 and give them a pressure in the properties.</source>
        <translation>次: %1。続けてプロパティで圧力を設定。</translation>
    </message>
    <message>
        <source>select all patches</source>
        <translation>すべてのパーツを選択</translation>
    </message>
    <message>
        <source>Next: %1 – click points on it, Enter ends – to which the cover is attached.</source>
        <translation>次: カバーを固定するため%1。点をクリックし、Enter で終了。</translation>
    </message>
    <message>
        <source>draw a fixation curve on the frame</source>
        <translation>フレームに固定曲線を描く</translation>
    </message>
    <message>
        <source>Next: select a fixation curve and %1 to it.</source>
        <translation>次: 固定曲線を選択し、%1。</translation>
    </message>
    <message>
        <source>attach an edge</source>
        <translation>辺を固定</translation>
    </message>
</context>
<context>
    <name>bolster::NumberBox</name>
    <message>
        <source>varies</source>
        <translation>混在</translation>
    </message>
    <message>
        <source>Not taken: a number is needed</source>
        <translation>適用されません: 数値が必要です</translation>
    </message>
    <message>
        <source>Not taken: &quot;%1&quot; is not a length</source>
        <translation>適用されません: 「%1」は長さではありません</translation>
    </message>
    <message>
        <source>Not taken: &quot;%1&quot; is not a number</source>
        <translation>適用されません: 「%1」は数値ではありません</translation>
    </message>
    <message>
        <source>Not taken: %1 is too little, at least %2</source>
        <translation>適用されません: %1 は小さすぎます。%2 以上にしてください</translation>
    </message>
    <message>
        <source>Not taken: %1 is too much, at most %2</source>
        <translation>適用されません: %1 は大きすぎます。%2 以下にしてください</translation>
    </message>
</context>
<context>
    <name>bolster::OpenFlow</name>
    <message>
        <source>Projects and designs (%1)</source>
        <translation>プロジェクトとデザイン (%1)</translation>
    </message>
    <message>
        <source>This is the version where you were last; the one in the file is under File &gt; Revert to saved</source>
        <translation>最後に作業していたバージョンです。ファイルのバージョンは「ファイル &gt; 保存した状態に戻す」で開けます</translation>
    </message>
    <message>
        <source>Open project or design</source>
        <translation>プロジェクトまたはデザインを開く</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open in another window.</source>
        <translation>「%1」は別のウィンドウで開かれています。</translation>
    </message>
    <message>
        <source>It can be opened here to look at; what is changed is saved under another name.</source>
        <translation>ここでは閲覧用に開けます。変更は別の名前で保存されます。</translation>
    </message>
    <message numerus="yes">
        <source>%n elements cannot be used as they are; everything else works.</source>
        <translation>
            <numerusform>%n 個の要素はこのままでは使えません。その他は正常です。</numerusform>
        </translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>表示(&amp;O)</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>まだありません</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>一覧を消去(&amp;C)</translation>
    </message>
    <message>
        <source>The samples are not installed</source>
        <translation>サンプルがインストールされていません</translation>
    </message>
</context>
<context>
    <name>bolster::PagesView</name>
    <message>
        <source>Pages</source>
        <translation>ページ</translation>
    </message>
</context>
<context>
    <name>bolster::PartsTree</name>
    <message>
        <source>Part</source>
        <translation>部品</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>部品</translation>
    </message>
</context>
<context>
    <name>bolster::PatternCommands</name>
    <message>
        <source>This stretch is straight already.</source>
        <translation>この区間はすでに直線です。</translation>
    </message>
    <message>
        <source>They are equally long already.</source>
        <translation>すでに同じ長さです。</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>切り取り(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>コピー(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>貼り付け(&amp;P)</translation>
    </message>
    <message>
        <source>Dupl&amp;icate</source>
        <translation>複製(&amp;I)</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>配置(&amp;G)</translation>
    </message>
    <message>
        <source>Turn 90° to the &amp;left</source>
        <translation>左に 90° 回転(&amp;L)</translation>
    </message>
    <message>
        <source>Turn 90° to the &amp;right</source>
        <translation>右に 90° 回転(&amp;R)</translation>
    </message>
    <message>
        <source>Mirror hori&amp;zontally</source>
        <translation>左右に反転(&amp;Z)</translation>
    </message>
    <message>
        <source>Mirror &amp;vertically</source>
        <translation>上下に反転(&amp;V)</translation>
    </message>
    <message>
        <source>Al&amp;ign</source>
        <translation>整列(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Left edges</source>
        <translation>左端(&amp;L)</translation>
    </message>
    <message>
        <source>Centres in a &amp;column</source>
        <translation>中心を縦一列に(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Right edges</source>
        <translation>右端(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Top edges</source>
        <translation>上端(&amp;T)</translation>
    </message>
    <message>
        <source>Centres in a ro&amp;w</source>
        <translation>中心を横一列に(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Bottom edges</source>
        <translation>下端(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Distribute</source>
        <translation>等間隔に配置(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Horizontally</source>
        <translation>左右(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Vertically</source>
        <translation>上下(&amp;V)</translation>
    </message>
    <message>
        <source>Arrange &amp;automatically</source>
        <translation>自動配置(&amp;A)</translation>
    </message>
    <message>
        <source>Poin&amp;ts and edges</source>
        <translation>点と辺(&amp;T)</translation>
    </message>
    <message>
        <source>Make &amp;corner</source>
        <translation>角にする(&amp;C)</translation>
    </message>
    <message>
        <source>Make s&amp;mooth</source>
        <translation>滑らかにする(&amp;M)</translation>
    </message>
    <message>
        <source>Strai&amp;ghten</source>
        <translation>直線にする(&amp;G)</translation>
    </message>
    <message>
        <source>Edge &amp;length …</source>
        <translation>辺の長さ(&amp;L)…</translation>
    </message>
    <message>
        <source>Type the length of the selected edge</source>
        <translation>選択した辺の長さを入力します</translation>
    </message>
    <message>
        <source>Make e&amp;qually long</source>
        <translation>同じ長さにする(&amp;Q)</translation>
    </message>
    <message>
        <source>Makes the selected edges as long as the first one, or the second side of a seam as long as its first</source>
        <translation>選択した辺を 1 番目と同じ長さに、または縫い目の 2 番目の側を 1 番目と同じ長さにします</translation>
    </message>
    <message>
        <source>Mirror twi&amp;ns</source>
        <translation>対称ペア(&amp;N)</translation>
    </message>
    <message>
        <source>Merge a&amp;long seam</source>
        <translation>縫い目で結合(&amp;L)</translation>
    </message>
    <message>
        <source>Smooth &amp;across seam ends</source>
        <translation>縫い目の端を滑らかに(&amp;A)</translation>
    </message>
    <message>
        <source>Outlines go on without a kink from one patch to the other where the selected seams end, when both sides lie together</source>
        <translation>選択した縫い目の端で、両側を合わせたときに輪郭が隣のパーツへ折れずに続くようにします</translation>
    </message>
    <message>
        <source>They go on without a kink already.</source>
        <translation>すでに折れずに続いています。</translation>
    </message>
</context>
<context>
    <name>bolster::PatternFitWindow</name>
    <message>
        <source>&amp;Take the changes</source>
        <translation>変更を適用(&amp;T)</translation>
    </message>
    <message>
        <source>Changes of</source>
        <translation>変更対象</translation>
    </message>
    <message>
        <source>Moves by</source>
        <translation>移動量</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>変更</translation>
    </message>
    <message>
        <source>What is ticked is changed</source>
        <translation>チェックしたものが変更されます</translation>
    </message>
    <message>
        <source>&amp;How much of it</source>
        <translation>適用量(&amp;H)</translation>
    </message>
    <message>
        <source>Solving the cover …</source>
        <translation>カバーを計算しています…</translation>
    </message>
    <message>
        <source>Stopped; nothing has changed.</source>
        <translation>停止しました。何も変更されていません。</translation>
    </message>
    <message>
        <source>&amp;Find changes</source>
        <translation>変更を探す(&amp;F)</translation>
    </message>
    <message>
        <source>The cover moves by %1 (rms).</source>
        <translation>カバーの移動量は %1 (RMS) です。</translation>
    </message>
    <message>
        <source>On the way a fold came or went: look at the cover before you take it.</source>
        <translation>途中でしわが現れたか消えました。適用前にカバーを確認してください。</translation>
    </message>
    <message numerus="yes">
        <source>%n of the numbers that may change do nothing here.</source>
        <translation>
            <numerusform>変更できる数値のうち %n 個はここでは効果がありません。</numerusform>
        </translation>
    </message>
    <message>
        <source>Arrows in the pattern: %1 times as long as the way</source>
        <translation>型紙の矢印: 移動量の %1 倍</translation>
    </message>
    <message>
        <source>Arrows in the pattern: where its outlines go</source>
        <translation>型紙の矢印: 輪郭の移動先</translation>
    </message>
    <message>
        <source>Taken. Undo takes it back.</source>
        <translation>適用しました。「元に戻す」で取り消せます。</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: find the changes again.</source>
        <translation>その間にデザインが変わりました。変更を探し直してください。</translation>
    </message>
    <message>
        <source>With all of the changes:</source>
        <translation>すべての変更を適用した場合:</translation>
    </message>
    <message>
        <source>Fitting the pattern …</source>
        <translation>型紙を合わせています…</translation>
    </message>
    <message>
        <source>Changing the pattern …</source>
        <translation>型紙を変更しています…</translation>
    </message>
    <message>
        <source>Pressed together: %1 before, %2 now</source>
        <translation>押し縮め: 変更前 %1、現在 %2</translation>
    </message>
    <message>
        <source>From the curve: %1 before, %2 now (rms)</source>
        <translation>曲線との差: 変更前 %1、現在 %2 (RMS)</translation>
    </message>
    <message>
        <source>Off the area that is wanted: %1 before, %2 now</source>
        <translation>目標の面積との差: 変更前 %1、現在 %2</translation>
    </message>
    <message>
        <source>Nothing is over the limits: there is nothing to do.</source>
        <translation>限度を超える箇所はありません。変更は不要です。</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit (before: %2), on few triangles at first</source>
        <translation>カバーの %1 が限界を超えています（変更前: %2）、まず少ない三角形で</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit (before: %2)</source>
        <translation>カバーの %1 が限界を超えています（変更前: %2）</translation>
    </message>
    <message>
        <source>With what is shown of the changes the cover cannot be solved.</source>
        <translation>表示されている変更の分では、カバーを計算できません。</translation>
    </message>
    <message>
        <source>With what is shown of the changes:</source>
        <translation>表示されている変更の分:</translation>
    </message>
    <message>
        <source>Nothing of the changes is shown now: move the slider to see them.</source>
        <translation>変更は今は何も表示されていません。スライダーを動かすと表示されます。</translation>
    </message>
    <message>
        <source>Sides of seams differ by up to %1 more than is wanted: change their neighbours, too, or let the ease change.</source>
        <translation>縫い目の両側の長さの差が望みより最大 %1 大きくなっています。隣のパーツも変えるか、いせを変えられるようにしてください。</translation>
    </message>
    <message>
        <source>Strained over the limit: %1 of the painted area before, %2 now</source>
        <translation>限度を超えたひずみ：塗った範囲の %1（前）、%2（今）</translation>
    </message>
    <message>
        <source>Strained over the limit: %1 of the cover before, %2 now</source>
        <translation>限度を超えたひずみ：カバーの %1（前）、%2（今）</translation>
    </message>
    <message>
        <source>That is hardly nearer, and strains the cloth more: let something else change, or less of it.</source>
        <translation>ほとんど近づかず、布地のひずみが増えています。別のものを変えるか、変更を少なくしてください。</translation>
    </message>
    <message>
        <source>Stopped. What was found until then makes it no better: nothing has changed.</source>
        <translation>停止しました。それまでに見つかった変更では改善しません。何も変更されていません。</translation>
    </message>
    <message>
        <source>Stopped. With all of the changes that were found until then, measured anew on all triangles:</source>
        <translation>停止しました。それまでに見つかった変更をすべて適用し、すべての三角形で測り直した場合:</translation>
    </message>
    <message>
        <source>Sides of seams off their ease: up to %1 before, %2 now</source>
        <translation>いせから外れている縫い目の両側: 以前は最大 %1、現在 %2</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Over the fabrics&apos; limits: %1 of the cover before, %2 now</source>
        <translation>生地の限度を超過：カバーの %1（前）、%2（今）</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: find the changes again, or undo that.</source>
        <translation>その間にデザインが変わりました。変更を探し直すか、その操作を元に戻してください。</translation>
    </message>
    <message>
        <source>Taken back. Move the slider to see the changes again.</source>
        <translation>元に戻しました。スライダーを動かすと、変更が再び表示されます。</translation>
    </message>
    <message>
        <source>That is hardly nearer to the limit: let something else change, or more of it.</source>
        <translation>限界にほとんど近づいていません。ほかのものを変えるか、もっと大きく変えてください。</translation>
    </message>
    <message>
        <source>%1 from %3 (rms; before: %2), on few triangles at first</source>
        <translation>%3 から %1（RMS、変更前：%2）、まず少ない三角形で</translation>
    </message>
    <message>
        <source>%1 from %3 (rms; before: %2)</source>
        <translation>%3 から %1（RMS、変更前：%2）</translation>
    </message>
    <message>
        <source>From %5: %1 before, %2 now (rms); %3 before, %4 now (95 %)</source>
        <translation>%5 との差: 変更前 %1、現在 %2 (RMS)。変更前 %3、現在 %4 (95&#xa0;%)</translation>
    </message>
    <message>
        <source>That is hardly nearer to %1: let something else change, or more of it.</source>
        <translation>%1 にほとんど近づいていません。ほかのものを変えるか、もっと大きく変えてください。</translation>
    </message>
    <message>
        <source>Hardly less is pressed together: let something else change, or more of it.</source>
        <translation>押し縮められた部分がほとんど減っていません。ほかのものを変えるか、もっと大きく変えてください。</translation>
    </message>
    <message>
        <source>That is hardly nearer to the curve: let something else change, or more of it.</source>
        <translation>曲線にほとんど近づいていません。ほかのものを変えるか、もっと大きく変えてください。</translation>
    </message>
    <message>
        <source>That is hardly nearer to the area that is wanted: let something else change, or more of it.</source>
        <translation>希望の面積にほとんど近づいていません。ほかのものを変えるか、もっと大きく変えてください。</translation>
    </message>
    <message>
        <source>Changes the pattern until the cover is as it is wished: tick one goal or several, and what may change.</source>
        <translation>カバーが望みどおりになるまで型紙を変えます。目標を 1 つ以上と、変えてよいものにチェックを入れてください。</translation>
    </message>
    <message>
        <source>%1 of the painted area is over the limit (before: %2), on few triangles at first</source>
        <translation>塗った領域の %1 が限界を超えています（変更前: %2）、まず少ない三角形で</translation>
    </message>
    <message>
        <source>%1 of the painted area is over the limit (before: %2)</source>
        <translation>塗った領域の %1 が限界を超えています（変更前: %2）</translation>
    </message>
    <message>
        <source>No change makes it better on all triangles: let something else change, or points move farther.</source>
        <translation>すべての三角形では改善する変更がありません。ほかのものを変えるか、点をもっと遠くまで動かせるようにしてください。</translation>
    </message>
    <message>
        <source>More of the cloth is strained over its limits: make these a goal, too, or let points move less.</source>
        <translation>限界を超えてひずむ生地が増えています。限界も目標にするか、点の移動を小さくしてください。</translation>
    </message>
    <message>
        <source>What is wished</source>
        <translation>希望する内容</translation>
    </message>
    <message>
        <source>Fit to a goal</source>
        <translation>目標に合わせる</translation>
    </message>
</context>
<context>
    <name>bolster::PatternRuler</name>
    <message>
        <source>Drag down for a level guide. Marks move upright guides; drag them off to remove them.</source>
        <translation>下へドラッグで水平ガイドを追加。目盛りの印で垂直ガイドを移動、外へドラッグで削除。</translation>
    </message>
    <message>
        <source>Drag to the right for an upright guide. Marks move level guides; drag them off to remove them.</source>
        <translation>右へドラッグで垂直ガイドを追加。目盛りの印で水平ガイドを移動、外へドラッグで削除。</translation>
    </message>
</context>
<context>
    <name>bolster::PreferencesWindow</name>
    <message>
        <source>Preferences (*.json)</source>
        <translation>環境設定 (*.json)</translation>
    </message>
    <message>
        <source>No setting has these words.</source>
        <translation>該当する設定はありません。</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>環境設定</translation>
    </message>
    <message>
        <source>Find a setting</source>
        <translation>設定を検索</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>ページ</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>選択…</translation>
    </message>
    <message>
        <source>&amp;Edit single shortcuts …</source>
        <translation>個々のショートカットを編集(&amp;E)…</translation>
    </message>
    <message>
        <source>Back to &amp;defaults</source>
        <translation>既定値に戻す(&amp;D)</translation>
    </message>
    <message>
        <source>All settings of this page</source>
        <translation>このページのすべての設定</translation>
    </message>
    <message>
        <source>E&amp;xport …</source>
        <translation>エクスポート(&amp;X)…</translation>
    </message>
    <message>
        <source>&amp;Import …</source>
        <translation>インポート(&amp;I)…</translation>
    </message>
    <message>
        <source>Export preferences</source>
        <translation>環境設定をエクスポート</translation>
    </message>
    <message>
        <source>Bolster preferences.json</source>
        <translation>Bolster 環境設定.json</translation>
    </message>
    <message>
        <source>Import preferences</source>
        <translation>環境設定をインポート</translation>
    </message>
    <message>
        <source>The preferences could not be exported.</source>
        <translation>環境設定をエクスポートできませんでした。</translation>
    </message>
    <message>
        <source>Nothing was imported from &quot;%1&quot;; all settings are as they were.</source>
        <translation>「%1」から何もインポートされませんでした。すべての設定は元のままです。</translation>
    </message>
    <message>
        <source>The preferences were imported.</source>
        <translation>環境設定をインポートしました。</translation>
    </message>
    <message numerus="yes">
        <source>This version of Bolster does not know %n of them: %1</source>
        <translation>
            <numerusform>このバージョンの Bolster が認識できない設定 %n 件: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>表示を移動</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>ズーム</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>3D ビュー上</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>型紙上</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no folder on this machine: the folder of your fabrics stays what it was.</source>
        <translation>「%1」はこのコンピューターのフォルダーではありません。生地のフォルダーは元のままです。</translation>
    </message>
    <message>
        <source>&amp;Restart now</source>
        <translation>今すぐ再起動(&amp;R)</translation>
    </message>
    <message>
        <source>Closes Bolster, and asks about unsaved work as always; then it starts again with the same project</source>
        <translation>Bolsterを閉じ（未保存の作業についてはいつもどおり確認します）、同じプロジェクトでもう一度起動します</translation>
    </message>
</context>
<context>
    <name>bolster::ProblemsView</name>
    <message>
        <source>F1: what it means, and what to do</source>
        <translation>F1: 意味と対処方法</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Nothing to worry about.</source>
        <translation>気になる点はありません。</translation>
    </message>
    <message>
        <source>All elements can be used.</source>
        <translation>すべての要素を使えます。</translation>
    </message>
</context>
<context>
    <name>bolster::PullNote</name>
    <message>
        <source>The cover in the 3D view is pulled to a scan; here it counts as the pattern alone makes it.</source>
        <translation>3D ビューのカバーはスキャンに引き寄せられています。ここでは型紙だけで生じるカバーとして扱われます。</translation>
    </message>
    <message>
        <source>No scan pulls at the cover any more (a step in the history).</source>
        <translation>スキャンはもうカバーを引いていません (履歴の 1 ステップ)。</translation>
    </message>
    <message>
        <source>Switch the pull off</source>
        <translation>引き寄せをオフにする</translation>
    </message>
    <message>
        <source>Pull again</source>
        <translation>再び引き寄せる</translation>
    </message>
</context>
<context>
    <name>bolster::ReliefWindow</name>
    <message>
        <source>Relieve strain</source>
        <translation>ひずみを緩和</translation>
    </message>
    <message>
        <source>&amp;Look for changes</source>
        <translation>変更を探す(&amp;L)</translation>
    </message>
    <message>
        <source>Looking for what relieves strain …</source>
        <translation>ひずみを緩和する変更を探しています…</translation>
    </message>
    <message>
        <source>Where cloth is strained or pressed together more than it may be, changes of the pattern are tried, and the best are solved.</source>
        <translation>生地のひずみや押し縮めが許容を超える所で型紙の変更を試し、最も良いものを計算します。</translation>
    </message>
    <message>
        <source>Proposed changes</source>
        <translation>変更の提案</translation>
    </message>
    <message>
        <source>Strain is at &amp;most</source>
        <translation>ひずみの上限(&amp;M)</translation>
    </message>
    <message>
        <source>Else the limits of the fabrics count</source>
        <translation>オフの場合は生地の限界を使います</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Limit of strain</source>
        <translation>ひずみの限界</translation>
    </message>
    <message>
        <source>Edges move &amp;by at most</source>
        <translation>辺の移動の上限(&amp;B)</translation>
    </message>
    <message>
        <source>Trying changes …</source>
        <translation>変更を試しています…</translation>
    </message>
    <message>
        <source>Stopped; nothing has changed.</source>
        <translation>停止しました。何も変更されていません。</translation>
    </message>
    <message>
        <source>Nothing is strained over the limit.</source>
        <translation>限界を超えるひずみはありません。</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit. No change relieves it.</source>
        <translation>カバーの %1 が限界を超えています。緩和できる変更はありません。</translation>
    </message>
    <message>
        <source>Each is solved by itself; &quot;Make it&quot; is one step that Undo takes back.</source>
        <translation>それぞれ単独で計算しています。「実行」は 1 ステップで、元に戻せます。</translation>
    </message>
    <message>
        <source>As it is now</source>
        <translation>現在の状態</translation>
    </message>
    <message>
        <source>Sewn: %1 more</source>
        <translation>縫う長さ: %1 増</translation>
    </message>
    <message>
        <source>Sides of seams differ by %1 more</source>
        <translation>縫い目の両側の差: %1 増</translation>
    </message>
    <message>
        <source>Outlines change by %1</source>
        <translation>輪郭の変化: %1</translation>
    </message>
    <message>
        <source>Show where</source>
        <translation>場所を表示</translation>
    </message>
    <message>
        <source>Make it</source>
        <translation>実行</translation>
    </message>
    <message>
        <source>Make it: %1</source>
        <translation>実行: %1</translation>
    </message>
    <message>
        <source>Made. Undo takes it back; look again to see what helps now.</source>
        <translation>実行しました。元に戻せます。今有効な変更は、もう一度探すとわかります。</translation>
    </message>
    <message>
        <source>Stopped. These are solved:</source>
        <translation>停止しました。計算済みのもの：</translation>
    </message>
    <message>
        <source>The best changes are being solved …</source>
        <translation>最も良い変更を計算しています…</translation>
    </message>
    <message>
        <source>Hardly anything is over the limit: there is little to gain. &quot;Make it&quot; is one step that Undo takes back.</source>
        <translation>限界を超える所はほとんどなく、改善の余地はわずかです。「実行」は 1 ステップで、元に戻せます。</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit, by %2 (rms of all of it).</source>
        <translation>カバーの %1 が限界を超えています。超過は %2 (カバー全体の RMS) です。</translation>
    </message>
    <message>
        <source>Over the limit: %1 of the cover, then %2</source>
        <translation>限界を超える所: カバーの %1、変更後 %2</translation>
    </message>
    <message>
        <source>Strain over it (rms): %1, then %2</source>
        <translation>限界超過のひずみ (RMS): %1、変更後 %2</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: look again, or undo that.</source>
        <translation>その間にデザインが変わりました。探し直すか、その操作を元に戻してください。</translation>
    </message>
    <message>
        <source>The cover moves by %1 (rms).</source>
        <translation>カバーの移動量は %1 (RMS) です。</translation>
    </message>
    <message>
        <source>From %1 (rms): %2, then %3</source>
        <translation>%1 との差 (RMS): 現在 %2、変更後 %3</translation>
    </message>
</context>
<context>
    <name>bolster::RenderDialog</name>
    <message>
        <source>Render</source>
        <translation>レンダリング</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>As in the window</source>
        <translation>ウィンドウと同じ</translation>
    </message>
    <message>
        <source>Three-quarter</source>
        <translation>斜め前</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>背面</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>下書き</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>良い</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>最高</translation>
    </message>
    <message>
        <source>How often each pixel is looked at</source>
        <translation>各ピクセルのサンプル数</translation>
    </message>
    <message>
        <source>Transparent &amp;background</source>
        <translation>背景を透明に(&amp;B)</translation>
    </message>
    <message>
        <source>The shadow on the ground is kept</source>
        <translation>床の影は残ります</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>サイズ(&amp;S):</translation>
    </message>
    <message>
        <source>&amp;View:</source>
        <translation>ビュー(&amp;V):</translation>
    </message>
    <message>
        <source>Sho&amp;w:</source>
        <translation>表示(&amp;W):</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>品質(&amp;Q):</translation>
    </message>
    <message>
        <source>Drawing …</source>
        <translation>描画しています…</translation>
    </message>
    <message>
        <source>&amp;Render …</source>
        <translation>レンダリング(&amp;R)…</translation>
    </message>
    <message>
        <source>The fabrics as in the window</source>
        <translation>ウィンドウと同じ生地</translation>
    </message>
    <message>
        <source>Colourway %1</source>
        <translation>カラーウェイ %1</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>市松</translation>
    </message>
    <message>
        <source>At most %1 million pixels are drawn; choose a smaller size.</source>
        <translation>描画できるのは最大 %1 百万ピクセルです。サイズを小さくしてください。</translation>
    </message>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation>画像を書き込めません: %1</translation>
    </message>
    <message>
        <source>Render to</source>
        <translation>レンダリングの保存先</translation>
    </message>
    <message>
        <source>PNG, 8 bits (*.png);;TIFF, 16 bits (*.tif *.tiff);;OpenEXR, linear light (*.exr)</source>
        <translation>PNG、8 ビット (*.png);;TIFF、16 ビット (*.tif *.tiff);;OpenEXR、リニア (*.exr)</translation>
    </message>
    <message>
        <source>The name must end in .png, .tif or .exr.</source>
        <translation>名前は .png、.tif または .exr で終わらなければなりません。</translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>キャンセルしました。何も書き込まれていません。</translation>
    </message>
    <message>
        <source>one picture</source>
        <translation>1 枚</translation>
    </message>
    <message>
        <source> pictures</source>
        <translation> 枚</translation>
    </message>
    <message>
        <source>So many pictures from all around, with numbers in their names</source>
        <translation>周囲からこの枚数の画像を作成し、名前に番号を付けます</translation>
    </message>
    <message>
        <source>&amp;Around the cover:</source>
        <translation>カバーの周囲(&amp;A):</translation>
    </message>
    <message>
        <source>All colourways on a sheet</source>
        <translation>全カラーウェイを 1 枚に</translation>
    </message>
    <message>
        <source>Map: %1</source>
        <translation>マップ: %1</translation>
    </message>
    <message>
        <source>&amp;Frame and foam</source>
        <translation>フレームとフォーム(&amp;F)</translation>
    </message>
    <message>
        <source>In the materials that their properties say</source>
        <translation>それぞれのプロパティの材料で</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>閉じる(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>The picture is written: %1</source>
        <translation>画像を書き出しました: %1</translation>
    </message>
    <message>
        <source>Open its folder</source>
        <translation>フォルダーを開く</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>プレビュー</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>What was made</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Drawing %1 …</source>
        <translation>%1 を描画しています…</translation>
    </message>
</context>
<context>
    <name>bolster::ReportDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>問題を報告</translation>
    </message>
    <message>
        <source>What did you do, what happened, and what should have happened?</source>
        <translation>何をして、何が起き、本来どうなるはずでしたか?</translation>
    </message>
    <message>
        <source>&amp;What happened:</source>
        <translation>起きたこと(&amp;W):</translation>
    </message>
    <message>
        <source>&amp;Add the design (&quot;%1&quot;), without its frames, scans and pictures</source>
        <translation>デザイン (「%1」) を添付 (フレーム、スキャン、画像を除く)(&amp;A)</translation>
    </message>
    <message>
        <source>What the &amp;report says besides:</source>
        <translation>報告のその他の内容(&amp;R):</translation>
    </message>
    <message>
        <source>Write the report …</source>
        <translation>報告を書き出す…</translation>
    </message>
    <message>
        <source>This writes a file that you can give to those who can help. Bolster sends nothing.</source>
        <translation>サポートできる人に渡せるファイルを書き出します。Bolster は何も送信しません。</translation>
    </message>
    <message>
        <source>not known yet</source>
        <translation>まだ不明</translation>
    </message>
    <message>
        <source>Messages of this run:</source>
        <translation>今回の実行のメッセージ:</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(なし)</translation>
    </message>
    <message>
        <source>The last crash:</source>
        <translation>前回のクラッシュ:</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>報告を書き出す</translation>
    </message>
    <message>
        <source>ZIP (*.zip)</source>
        <translation>ZIP (*.zip)</translation>
    </message>
    <message>
        <source>The report is written: %1</source>
        <translation>報告を書き出しました: %1</translation>
    </message>
    <message>
        <source>The report could not be written: %1</source>
        <translation>報告を書き出せませんでした: %1</translation>
    </message>
</context>
<context>
    <name>bolster::Rescue</name>
    <message>
        <source>%1 (recovered)</source>
        <translation>%1 (復旧)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be opened.</source>
        <translation>「%1」を開けませんでした。</translation>
    </message>
    <message>
        <source>What can be read goes into a new project beside it. This file stays as it is.</source>
        <translation>読み取れる内容を、隣の新しいプロジェクトに入れます。このファイルは変わりません。</translation>
    </message>
    <message>
        <source>&amp;Recover what can be read</source>
        <translation>読み取れる内容を復旧(&amp;R)</translation>
    </message>
    <message>
        <source>Recovering &quot;%1&quot; …</source>
        <translation>「%1」を復旧しています…</translation>
    </message>
    <message>
        <source>Nothing could be recovered.</source>
        <translation>何も復旧できませんでした。</translation>
    </message>
    <message>
        <source>What could be read is in &quot;%1&quot; now.</source>
        <translation>読み取れた内容は「%1」にあります。</translation>
    </message>
    <message>
        <source>The unsaved work on &quot;%1&quot; is damaged.</source>
        <translation>「%1」の未保存の作業が破損しています。</translation>
    </message>
    <message numerus="yes">
        <source>What can be read goes into a new project. What you do not want any more is deleted %n days after it was put into the bin.</source>
        <translation>
            <numerusform>読み取れる内容は新しいプロジェクトに入ります。不要なものは、ごみ箱に入れて %n 日後に削除されます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Put it into the &amp;bin</source>
        <translation>ごみ箱に入れる(&amp;B)</translation>
    </message>
    <message>
        <source>The damaged work is kept under File &gt; Unsaved work</source>
        <translation>破損した作業は「ファイル &gt; 未保存の作業」に保管されます</translation>
    </message>
    <message>
        <source>What could be read of it is in &quot;%1&quot; now.</source>
        <translation>読み取れた内容は「%1」にあります。</translation>
    </message>
    <message>
        <source>Nothing of it could be read.</source>
        <translation>読み取れる内容はありませんでした。</translation>
    </message>
    <message>
        <source>Nothing that was saved is concerned. The damaged work is kept under File &gt; Unsaved work.</source>
        <translation>保存済みのものに影響はありません。破損した作業は「ファイル &gt; 未保存の作業」に保管されます。</translation>
    </message>
    <message>
        <source>Open what was &amp;recovered</source>
        <translation>復旧した内容を開く(&amp;R)</translation>
    </message>
    <message>
        <source>Looking for what can be read in &quot;%1&quot; …</source>
        <translation>「%1」で読み取れるものを探しています…</translation>
    </message>
</context>
<context>
    <name>bolster::RunRow</name>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
</context>
<context>
    <name>bolster::SaveFlow</name>
    <message>
        <source>Project with its history (*.bolster);;Design as text (*.json)</source>
        <translation>履歴付きプロジェクト (*.bolster);;テキスト形式のデザイン (*.json)</translation>
    </message>
    <message numerus="yes">
        <source>%n edits</source>
        <translation>
            <numerusform>編集 %n 件</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edits that were undone or are on other branches</source>
        <translation>
            <numerusform>元に戻した、または他の分岐にある編集 %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>names of versions or branches</source>
        <translation>バージョンまたは分岐の名前</translation>
    </message>
    <message>
        <source>The file holds another version of the design than the one you see.</source>
        <translation>ファイルにあるデザインは、表示中のものとは別のバージョンです。</translation>
    </message>
    <message>
        <source>Not saved yet: %1.</source>
        <translation>未保存: %1。</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>コピーを保存</translation>
    </message>
    <message>
        <source>-copy</source>
        <translation>-コピー</translation>
    </message>
    <message>
        <source>Project (*.%1)</source>
        <translation>プロジェクト (*.%1)</translation>
    </message>
    <message>
        <source>Save the changes in &quot;%1&quot;?</source>
        <translation>「%1」の変更を保存しますか?</translation>
    </message>
    <message>
        <source>A design as text cannot hold that, a project can.</source>
        <translation>テキスト形式のデザインには保存できません。プロジェクトなら保存できます。</translation>
    </message>
    <message>
        <source>Work that is kept for later, with all its steps, is under File &gt; Unsaved work.</source>
        <translation>後のために保管した作業は、すべてのステップとともに「ファイル &gt; 未保存の作業」にあります。</translation>
    </message>
    <message>
        <source>Save as &amp;project …</source>
        <translation>プロジェクトとして保存(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Keep for later</source>
        <translation>後のために保管(&amp;K)</translation>
    </message>
    <message>
        <source>The work cannot be kept.</source>
        <translation>作業を保管できません。</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>プロジェクトを保存</translation>
    </message>
    <message>
        <source>Saved a copy as %1</source>
        <translation>コピーを %1 として保存しました</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>%1 として保存しました</translation>
    </message>
    <message>
        <source>%1: the design alone, without its history</source>
        <translation>%1: 履歴なしのデザインのみ</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the file any more that was opened or saved here.</source>
        <translation>「%1」は、ここで開いた、または保存したファイルではなくなっています。</translation>
    </message>
    <message>
        <source>Save your design under another name, or let what is there now have another name beside it. If that is a damaged project, File &gt; Open recovers what can be read of it.</source>
        <translation>デザインを別の名前で保存するか、現在そこにあるファイルを別の名前で横に残してください。それが破損したプロジェクトなら、「ファイル &gt; 開く」で読み取れる内容を復旧できます。</translation>
    </message>
    <message>
        <source>&amp;Keep the other file beside it, and save</source>
        <translation>他のファイルを横に残して保存(&amp;K)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be saved.</source>
        <translation>「%1」を保存できませんでした。</translation>
    </message>
    <message>
        <source>What was in the place of &quot;%1&quot; is in &quot;%2&quot; now.</source>
        <translation>「%1」の場所にあったものは「%2」に移しました。</translation>
    </message>
    <message>
        <source>Somebody else has changed &quot;%1&quot; since it was opened here.</source>
        <translation>「%1」は、ここで開いた後に他の人が変更しました。</translation>
    </message>
    <message>
        <source>Their changes can become a branch of the history here, then both are saved. Your design stays as it is, and you can go to theirs.</source>
        <translation>その変更をここで履歴の分岐にし、両方を保存できます。あなたのデザインはそのまま残り、相手のデザインに移動することもできます。</translation>
    </message>
    <message>
        <source>&amp;Take their changes in as a branch</source>
        <translation>相手の変更を分岐として取り込む(&amp;T)</translation>
    </message>
    <message>
        <source>From the file, %1</source>
        <translation>ファイルから、%1</translation>
    </message>
    <message>
        <source>Their changes could not be taken in.</source>
        <translation>相手の変更を取り込めませんでした。</translation>
    </message>
    <message>
        <source>The changes of somebody else are a branch of the history now.</source>
        <translation>他の人の変更が履歴の分岐になりました。</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>表示(&amp;O)</translation>
    </message>
    <message>
        <source>Go &amp;there</source>
        <translation>そこへ移動(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>再試行(&amp;T)</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>名前を付けて保存(&amp;A)…</translation>
    </message>
    <message>
        <source>Nothing protects what you do since %1 against a crash: Bolster cannot write to the folder &quot;%2&quot;. Make room there, or save the design.</source>
        <translation>%1 以降の作業はクラッシュから保護されていません。フォルダー「%2」に書き込めません。空きを作るか、デザインを保存してください。</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
</context>
<context>
    <name>bolster::ScanLink</name>
    <message>
        <source>Deviation from %1</source>
        <translation>%1 との偏差</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>内側</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>外側</translation>
    </message>
</context>
<context>
    <name>bolster::SeamLineList</name>
    <message>
        <source>Seam lines</source>
        <translation>縫い目の線</translation>
    </message>
    <message>
        <source>Fixation curves of the design. Draw seam lines on a frame with the tool for fixation curves: what is drawn meanwhile is cut at once</source>
        <translation>デザインの固定曲線。縫い目の線は固定曲線ツールでフレーム上に描きます。その間に描いた線ですぐに切られます</translation>
    </message>
    <message numerus="yes">
        <source>%n lines that hold a cover</source>
        <translation>
            <numerusform>カバーを留めている線 %n 本</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::SeamProposalsWindow</name>
    <message>
        <source>Proposed seams</source>
        <translation>提案された縫い目</translation>
    </message>
    <message>
        <source>Edge of</source>
        <translation>辺</translation>
    </message>
    <message>
        <source>to edge of</source>
        <translation>相手の辺</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>確実さ</translation>
    </message>
    <message>
        <source>Select rows to see their edges in the pattern; Enter or a double click sews them.</source>
        <translation>行を選ぶと型紙に辺が表示されます。Enter またはダブルクリックで縫います。</translation>
    </message>
    <message>
        <source>&amp;Sew selected</source>
        <translation>選択を縫う(&amp;S)</translation>
    </message>
    <message>
        <source>Sew &amp;all</source>
        <translation>すべて縫う(&amp;A)</translation>
    </message>
    <message>
        <source>Looking for edges that belong together …</source>
        <translation>対になる辺を探しています…</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>There are no free edges that seem to belong together.</source>
        <translation>対になりそうな空いた辺はありません。</translation>
    </message>
    <message>
        <source>Sew &amp;likely ones</source>
        <translation>可能性の高いものを縫う(&amp;L)</translation>
    </message>
    <message>
        <source>Those of 50 % and more. What is sewn tells where its neighbours belong.</source>
        <translation>50&#xa0;% 以上のもの。縫うと、隣の辺の相手がわかります。</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 と %2</translation>
    </message>
    <message>
        <source>Found by their lengths, corners that would close, names and directions; the most certain first. Look at each in the pattern before you sew it.</source>
        <translation>長さ、閉じる角、名前、方向による順で、確実なものが先です。縫う前に型紙で確認してください。</translation>
    </message>
</context>
<context>
    <name>bolster::SeamsModel</name>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>More than 5 % ease puckers.</source>
        <translation>いせが 5&#xa0;% を超えるとしわになります。</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>縫い目</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>いせ</translation>
    </message>
    <message>
        <source>Ease %</source>
        <translation>いせ %</translation>
    </message>
    <message>
        <source>Joins</source>
        <translation>連続性</translation>
    </message>
    <message>
        <source>Length 1</source>
        <translation>長さ 1</translation>
    </message>
    <message>
        <source>Length 2</source>
        <translation>長さ 2</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>対応付け</translation>
    </message>
    <message>
        <source>The letter on both stretches in the pattern</source>
        <translation>型紙の両区間に付く文字</translation>
    </message>
    <message>
        <source>The patches and their edges</source>
        <translation>パーツとその辺</translation>
    </message>
    <message>
        <source>C0: an edge, C1: smooth with the texture, G1: rounded</source>
        <translation>C0: 角あり、C1: 柄も滑らか、G1: 丸める</translation>
    </message>
    <message>
        <source>Of the first side</source>
        <translation>1 番目の側</translation>
    </message>
    <message>
        <source>Of the second side</source>
        <translation>2 番目の側</translation>
    </message>
    <message>
        <source>What is sewn together: equal parts of the length, or of the curve&apos;s parameter</source>
        <translation>縫い合わせ方: 長さの等分、または曲線パラメータの等分</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>順番</translation>
    </message>
    <message>
        <source>The place in the order of sewing; Seam &gt; Sew earlier and Sew later change it</source>
        <translation>縫製順での位置。「縫い目 &gt; 先に縫う」「後で縫う」で変更します</translation>
    </message>
    <message>
        <source>How much longer the second side is than the first one</source>
        <translation>2 番目の側が 1 番目よりどれだけ長いか</translation>
    </message>
    <message>
        <source>The ease over the shorter side; more than 5 % puckers</source>
        <translation>短い側に対するいせの割合。5&#xa0;% を超えるとしわになります</translation>
    </message>
</context>
<context>
    <name>bolster::SeamsView</name>
    <message>
        <source>No seams yet. Choose the sewing tool (W), then click the two edges that belong together.</source>
        <translation>縫い目はまだありません。縫うツール (W) を選び、縫い合わせる 2 つの辺をクリックしてください。</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>縫い目</translation>
    </message>
</context>
<context>
    <name>bolster::SectionPanel</name>
    <message>
        <source>Section</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>Cut across the x axis</source>
        <translation>x 軸に直交して切る</translation>
    </message>
    <message>
        <source>Cut across the y axis</source>
        <translation>y 軸に直交して切る</translation>
    </message>
    <message>
        <source>Cut across the z axis</source>
        <translation>z 軸に直交して切る</translation>
    </message>
    <message>
        <source>View</source>
        <translation>ビュー</translation>
    </message>
    <message>
        <source>Cut parallel to the picture, as it is seen now</source>
        <translation>現在の画面と平行に切る</translation>
    </message>
    <message>
        <source>Moves the plane</source>
        <translation>平面を移動</translation>
    </message>
    <message>
        <source>Show the other half</source>
        <translation>反対側の半分を表示</translation>
    </message>
    <message>
        <source>Close the section</source>
        <translation>断面を閉じる</translation>
    </message>
    <message>
        <source>Place of the section</source>
        <translation>断面の位置</translation>
    </message>
</context>
<context>
    <name>bolster::SewingCommands</name>
    <message>
        <source>Propos&amp;e seams …</source>
        <translation>縫い目を提案(&amp;E)…</translation>
    </message>
    <message>
        <source>Show seam li&amp;st</source>
        <translation>縫い目一覧を表示(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>反転(&amp;F)</translation>
    </message>
    <message>
        <source>Swap si&amp;des</source>
        <translation>両側を入れ替え(&amp;D)</translation>
    </message>
    <message>
        <source>C&amp;0 – an edge</source>
        <translation>C0 – 角あり(&amp;0)</translation>
    </message>
    <message>
        <source>C&amp;1 – smooth, texture too</source>
        <translation>C1 – 滑らか、柄も(&amp;1)</translation>
    </message>
    <message>
        <source>&amp;G1 – rounded</source>
        <translation>G1 – 丸める(&amp;G)</translation>
    </message>
    <message>
        <source>Match by &amp;length</source>
        <translation>長さで対応付け(&amp;L)</translation>
    </message>
    <message>
        <source>Match by &amp;parameter</source>
        <translation>パラメータで対応付け(&amp;P)</translation>
    </message>
    <message>
        <source>Sew earl&amp;ier</source>
        <translation>先に縫う(&amp;I)</translation>
    </message>
    <message>
        <source>Sew l&amp;ater</source>
        <translation>後で縫う(&amp;A)</translation>
    </message>
    <message>
        <source>Sewi&amp;ng order as proposed</source>
        <translation>提案された順に縫う(&amp;N)</translation>
    </message>
</context>
<context>
    <name>bolster::SheetPreview</name>
    <message>
        <source>What will be on the sheets</source>
        <translation>シートに載る内容</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>裁断するものがありません。</translation>
    </message>
    <message>
        <source>Laying out …</source>
        <translation>配置しています…</translation>
    </message>
</context>
<context>
    <name>bolster::ShortcutsDialog</name>
    <message>
        <source>&amp;No keys</source>
        <translation>キーなし(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>リセット(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Take them over</source>
        <translation>キーを引き継ぐ(&amp;T)</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>ショートカット</translation>
    </message>
    <message>
        <source>Find a command or a key</source>
        <translation>コマンドまたはキーを検索</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>すべてリセット(&amp;A)</translation>
    </message>
    <message>
        <source>Click into the field and press the keys.</source>
        <translation>欄をクリックしてキーを押してください。</translation>
    </message>
    <message>
        <source>Choose a command to change its keys.</source>
        <translation>キーを変更するコマンドを選んでください。</translation>
    </message>
    <message>
        <source>%1 is needed by the views and fields themselves.</source>
        <translation>%1 はビューと入力欄自身が使用します。</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 は「%2」のキーです。</translation>
    </message>
    <message>
        <source>%1 it is.</source>
        <translation>%1 にしました。</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>コマンド</translation>
    </message>
</context>
<context>
    <name>bolster::ShownPattern</name>
    <message>
        <source>Edge: %1</source>
        <translation>辺: %1</translation>
    </message>
</context>
<context>
    <name>bolster::SimplifyChoice</name>
    <message>
        <source>&amp;Simplify to about</source>
        <translation>単純化、目安(&amp;S)</translation>
    </message>
    <message>
        <source> triangles</source>
        <translation> 三角形</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Writes the parts that are wanted into an OBJ file of the design&apos;s own; the file that was chosen stays as it is</source>
        <translation>必要な部品をデザイン専用の OBJ ファイルに書き出します。選んだファイルは変わりません</translation>
    </message>
</context>
<context>
    <name>bolster::SpotsPanel</name>
    <message>
        <source>Worst spots</source>
        <translation>要注意箇所</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>限界</translation>
    </message>
    <message>
        <source>Negative where the fabric is pressed together</source>
        <translation>生地が圧縮されている所は負</translation>
    </message>
    <message>
        <source>What the fabric there may suffer. The spots are sorted by how much of it they take</source>
        <translation>その場所の生地が耐えられる限界。限界に対する割合の順に並べます</translation>
    </message>
    <message>
        <source>As soon as there is a cover, its worst spots will be listed here.</source>
        <translation>カバーができると、要注意箇所がここに表示されます。</translation>
    </message>
    <message>
        <source>A map of strain or shear shows what the fabric suffers. Its worst spots will be listed here.</source>
        <translation>ひずみまたはせん断のマップは生地への負担を示します。要注意箇所がここに表示されます。</translation>
    </message>
    <message>
        <source>Nothing is over the limit of its fabric.</source>
        <translation>生地の限界を超える所はありません。</translation>
    </message>
    <message>
        <source>Over the limit of the fabric: %1 of %2</source>
        <translation>生地の限界超過: %2 件中 %1 件</translation>
    </message>
    <message>
        <source>over the limit of %1</source>
        <translation>限界 %1 を超過</translation>
    </message>
    <message>
        <source>Show the &amp;largest strain</source>
        <translation>最大ひずみを表示(&amp;L)</translation>
    </message>
</context>
<context>
    <name>bolster::StartHint</name>
    <message>
        <source>A new cover</source>
        <translation>新しいカバー</translation>
    </message>
    <message>
        <source>Draw the first patch, import a frame, or open a design:</source>
        <translation>最初のパーツを描く、フレームをインポートする、またはデザインを開く:</translation>
    </message>
    <message>
        <source>Or look at a sample:</source>
        <translation>またはサンプルを見る:</translation>
    </message>
    <message>
        <source>%1 more are under File &gt; Samples</source>
        <translation>他 %1 件は「ファイル &gt; サンプル」にあります</translation>
    </message>
    <message>
        <source>Go on with:</source>
        <translation>続きから:</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>一覧を消去</translation>
    </message>
    <message>
        <source>Rectan&amp;gle</source>
        <translation>長方形(&amp;G)</translation>
    </message>
    <message>
        <source>Ou&amp;tline</source>
        <translation>輪郭(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>開く(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Import frame …</source>
        <translation>フレームをインポート(&amp;I)…</translation>
    </message>
</context>
<context>
    <name>bolster::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>スタートページ</translation>
    </message>
    <message>
        <source>Welcome to Bolster</source>
        <translation>Bolster へようこそ</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>ツアーを始める</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>開く…</translation>
    </message>
    <message>
        <source>Back to the design</source>
        <translation>デザインに戻る</translation>
    </message>
    <message>
        <source>What do you have?</source>
        <translation>何がありますか?</translation>
    </message>
    <message>
        <source>A frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>The cover is fixed on it: %1</source>
        <translation>カバーを固定します: %1</translation>
    </message>
    <message>
        <source>A pattern</source>
        <translation>型紙</translation>
    </message>
    <message>
        <source>Its pieces become the cover: %1</source>
        <translation>パーツがカバーになります: %1</translation>
    </message>
    <message>
        <source>A scan</source>
        <translation>スキャン</translation>
    </message>
    <message>
        <source>The cover is fitted to it: %1</source>
        <translation>カバーを合わせます: %1</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>まだありません</translation>
    </message>
    <message>
        <source>Draw a rectangle, the first patch</source>
        <translation>最初のパーツとして長方形を描く</translation>
    </message>
    <message>
        <source>Go on with</source>
        <translation>続きから始める</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>一覧を消去</translation>
    </message>
    <message>
        <source>Take it out of this list; the file stays</source>
        <translation>この一覧から除く (ファイルは残ります)</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>未保存の作業</translation>
    </message>
    <message>
        <source>Kept for later, last edit %1</source>
        <translation>後のために保管、最終編集 %1</translation>
    </message>
    <message>
        <source>Left by a crash, last edit %1</source>
        <translation>クラッシュで残ったもの、最終編集 %1</translation>
    </message>
    <message>
        <source>Begin with a template</source>
        <translation>テンプレートから始める</translation>
    </message>
    <message>
        <source>Look at a sample</source>
        <translation>サンプルを見る</translation>
    </message>
    <message>
        <source>It is not there now</source>
        <translation>現在その場所にありません</translation>
    </message>
</context>
<context>
    <name>bolster::StatusLine</name>
    <message>
        <source>Nothing to sew yet</source>
        <translation>まだ縫うものがありません</translation>
    </message>
    <message>
        <source>Preparing …</source>
        <translation>準備中…</translation>
    </message>
    <message>
        <source>Moving, %1/s</source>
        <translation>変形中、%1/s</translation>
    </message>
    <message>
        <source>Solved – %1 iterations</source>
        <translation>計算完了 – 反復 %1 回</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>一時停止中</translation>
    </message>
    <message numerus="yes">
        <source>%n problems</source>
        <translation>
            <numerusform>問題 %n 件</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>警告 %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Solved in part</source>
        <translation>一部計算済み</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>理由は?</translation>
    </message>
    <message>
        <source>Following the drag</source>
        <translation>ドラッグに追従中</translation>
    </message>
    <message>
        <source>Solved, with warnings</source>
        <translation>計算完了 (警告あり)</translation>
    </message>
    <message>
        <source>Show (%1)</source>
        <translation>表示 (%1)</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>The cloth went on moving until the computation was ended. What usually causes that:
• A piece that nothing holds: fix one of its edges, or sew it on.
• A seam whose two sides differ much in length: make them more alike.
• A very long or very narrow piece: divide it, or make it wider.
• High pressure: lower it in the properties of the patch.
What you see is where the cloth was at the end.</source>
        <translation>計算が終わるまで生地が動き続けました。主な原因:
• 固定されていないパーツ: 辺を固定するか、縫い付けてください。
• 両側の長さが大きく異なる縫い目: 長さを近づけてください。
• 非常に長い、または狭いパーツ: 分割するか、幅を広げてください。
• 高い圧力: パーツのプロパティで下げてください。
表示は終了時点の生地の状態です。</translation>
    </message>
    <message>
        <source>Drawing and checking …</source>
        <translation>描画と確認中…</translation>
    </message>
    <message>
        <source>Preparing: on fewer triangles …</source>
        <translation>準備中: 少ない三角形で計算…</translation>
    </message>
    <message>
        <source>Preparing: forces and equations …</source>
        <translation>準備中: 力と方程式…</translation>
    </message>
    <message>
        <source>&amp;What does it mean?</source>
        <translation>これはどういう意味ですか(&amp;W)</translation>
    </message>
    <message>
        <source>A preview, not checked yet</source>
        <translation>プレビュー、未確認</translation>
    </message>
</context>
<context>
    <name>bolster::SweepWindow</name>
    <message>
        <source>Tolerances</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>&amp;Draw pieces</source>
        <translation>個体を抽出(&amp;D)</translation>
    </message>
    <message>
        <source>Solving pieces within tolerances …</source>
        <translation>公差内の個体を計算しています…</translation>
    </message>
    <message>
        <source>Pieces are drawn at random within their tolerances: where does the cover vary, which tolerance matters, how many pieces are out of the limit?</source>
        <translation>公差内で個体を無作為に抽出します。カバーのどこがばらつき、どの公差が影響し、いくつの個体が限界を超えるでしょうか。</translation>
    </message>
    <message>
        <source>&amp;Show on the cover what 95 % of the pieces do not exceed</source>
        <translation>個体の 95 % が超えない値をカバーに表示(&amp;S)</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>Moves by at most</source>
        <translation>最大移動量</translation>
    </message>
    <message>
        <source>Tolerances by their influence</source>
        <translation>影響の大きい順の公差</translation>
    </message>
    <message>
        <source>Tolerances (±); 0: none</source>
        <translation>公差 (±)、0: なし</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>個体</translation>
    </message>
    <message>
        <source>Every size within is as likely</source>
        <translation>範囲内のどの値も同じ確率</translation>
    </message>
    <message>
        <source>Normal: the tolerance is three standard deviations</source>
        <translation>正規分布: 公差は標準偏差の 3 倍</translation>
    </message>
    <message>
        <source>Before them ten thousand are drawn as if covers were linear, which takes seconds</source>
        <translation>その前に線形近似で 1 万個を抽出します。数秒で済みます</translation>
    </message>
    <message>
        <source>Dr&amp;awn</source>
        <translation>抽出方法(&amp;A)</translation>
    </message>
    <message>
        <source>S&amp;olved</source>
        <translation>計算する数(&amp;O)</translation>
    </message>
    <message>
        <source>Nothing varies: give a tolerance above 0 of something that the design has.</source>
        <translation>ばらつくものがありません。デザインにあるものに 0 より大きい公差を指定してください。</translation>
    </message>
    <message>
        <source>Covers with each tolerance are solved …</source>
        <translation>各公差でのカバーを計算しています…</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>停止しました。</translation>
    </message>
    <message>
        <source>That is as if covers were linear; pieces are being solved …</source>
        <translation>これは線形近似です。個体を計算しています…</translation>
    </message>
    <message>
        <source>That is as if covers were linear.</source>
        <translation>これは線形近似です。</translation>
    </message>
    <message numerus="yes">
        <source>By %n solved pieces.</source>
        <translation>
            <numerusform>計算した個体 %n 個による結果です。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces have no cover at rest.</source>
        <translation>
            <numerusform>%n 個の個体には、静止したカバーがありません。</numerusform>
        </translation>
    </message>
    <message>
        <source>What 95 % of the pieces do not exceed</source>
        <translation>個体の 95 % が超えない値</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: draw the pieces again.</source>
        <translation>その間にデザインが変わりました。個体を抽出し直してください。</translation>
    </message>
    <message numerus="yes">
        <source>By %n solved pieces so far; more are being solved …</source>
        <translation>
            <numerusform>これまでに計算した個体 %n 個による結果です。計算を続けています…</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With %n tolerances no cover is found, as with: %1. They are left out of this: make them smaller.</source>
        <translation>
            <numerusform>公差 %n 個ではカバーが求まりません（例：%1）。ここには含まれません。小さくしてください。</numerusform>
        </translation>
    </message>
    <message>
        <source>A piece is out of it when more than 5 % of its cover lie farther from where they should be</source>
        <translation>カバーの 5 % 超が本来の位置からこの値より離れている個体を、限界超過とします</translation>
    </message>
    <message>
        <source>95 % of the pieces do not exceed, place by place, %1 (rms over the cover), %2 where it is most.</source>
        <translation>場所ごとに個体の 95 % が超えない値: %1 (カバー全体の RMS)、最大の所で %2。</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>割合</translation>
    </message>
    <message>
        <source>How much of the variance of the whole cover comes of it</source>
        <translation>カバー全体の分散のうち、その公差による割合</translation>
    </message>
    <message>
        <source>± is what many more of them may change.</source>
        <translation>± は、さらに多く解いた場合に変わりうる幅です。</translation>
    </message>
    <message>
        <source>Out of the limit: about %1 of the pieces.</source>
        <translation>限界超過: 個体の約 %1。</translation>
    </message>
    <message>
        <source>Out of the limit: %1 of %2 pieces (of many: %3 to %4).</source>
        <translation>限界超過: 個体 %2 個のうち %1 個 (多数では %3～%4)。</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>These are too few to say how sure that is.</source>
        <translation>どの程度確かかを言うには少なすぎます。</translation>
    </message>
    <message>
        <source>&amp;Limit for 95 % of a cover</source>
        <translation>カバーの 95&#xa0;% についての限界(&amp;L)</translation>
    </message>
    <message>
        <source>This is of what was set before: draw pieces for what is set now.</source>
        <translation>これは以前の設定についての結果です。現在の設定で個体を抽出してください。</translation>
    </message>
</context>
<context>
    <name>bolster::ToolHost</name>
    <message>
        <source>This could not be done, and nothing was changed: %1</source>
        <translation>実行できず、何も変更されませんでした: %1</translation>
    </message>
</context>
<context>
    <name>bolster::TourPanel</name>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>次へ</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>ツアーを終了</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>ツアー</translation>
    </message>
    <message>
        <source>Help &gt; Tour goes on from here</source>
        <translation>「ヘルプ &gt; ツアー」で続きから再開できます</translation>
    </message>
    <message>
        <source>Tour, %1 of %2</source>
        <translation>ツアー、%1/%2</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完了</translation>
    </message>
</context>
<context>
    <name>bolster::TrimTool</name>
    <message>
        <source>Click a seam or an edge of an outline.</source>
        <translation>縫い目または輪郭の辺をクリックしてください。</translation>
    </message>
    <message>
        <source>Click to stitch this seam; stitches and piping are in the properties</source>
        <translation>クリックでこの縫い目にステッチ。ステッチとパイピングはプロパティにあります</translation>
    </message>
    <message>
        <source>Click to stitch this edge; stitches and piping are in the properties</source>
        <translation>クリックでこの辺にステッチ。ステッチとパイピングはプロパティにあります</translation>
    </message>
    <message>
        <source>Click a seam or an edge of an outline to stitch it – Esc ends the tool</source>
        <translation>縫い目または輪郭の辺をクリックしてステッチ。Esc でツールを終了</translation>
    </message>
</context>
<context>
    <name>bolster::VersionPane</name>
    <message>
        <source>Computing the cover …</source>
        <translation>カバーを計算しています…</translation>
    </message>
    <message>
        <source>Pattern of %1</source>
        <translation>%1 の型紙</translation>
    </message>
    <message>
        <source>Cover of %1</source>
        <translation>%1 のカバー</translation>
    </message>
</context>
<context>
    <name>bolster::ViewCube</name>
    <message>
        <source>FRONT</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>背面</translation>
    </message>
    <message>
        <source>LEFT</source>
        <translation>左</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <translation>右</translation>
    </message>
    <message>
        <source>TOP</source>
        <translation>上</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <translation>下</translation>
    </message>
    <message>
        <source>Click a face, an edge or a corner to look from there; drag to turn</source>
        <translation>面、辺、角をクリックしてその方向から見る。ドラッグで回転</translation>
    </message>
</context>
</TS>
