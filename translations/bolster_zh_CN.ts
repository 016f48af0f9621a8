<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>AreaBrushTool</name>
    <message>
        <source>Drag over the cover to paint the area; with Shift held down to take away. + and − change the brush. Esc ends.</source>
        <translation>在面套上拖动以涂出区域；按住 Shift 则擦除。+ 和 − 改变画笔。Esc 结束。</translation>
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
        <translation>“%1”已存在。要替换吗？</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>AttachTool</name>
    <message>
        <source>Click an edge of an outline.</source>
        <translation>请单击轮廓的一条边。</translation>
    </message>
    <message>
        <source>Select a fixation curve first, in the 3D view or in the list.</source>
        <translation>请先在三维视图或列表中选择一条固定曲线。</translation>
    </message>
    <message>
        <source>Several stretches go with one curve, or one stretch with several curves.</source>
        <translation>可以多个区段对一条曲线，或一个区段对多条曲线。</translation>
    </message>
    <message>
        <source>The stretches overlap each other, or are attached like this already.</source>
        <translation>这些区段互相重叠，或已经这样固定。</translation>
    </message>
    <message>
        <source>This stretch is attached like this already.</source>
        <translation>此区段已经这样固定。</translation>
    </message>
    <message>
        <source>Select a fixation curve in the 3D view or in the list, then click an edge of an outline – Esc ends the tool</source>
        <translation>在三维视图或列表中选择固定曲线，再单击轮廓的一条边——Esc 结束工具</translation>
    </message>
    <message>
        <source>%1 curves</source>
        <translation>%1 条曲线</translation>
    </message>
    <message>
        <source>Click to fix this stretch of %1 to %2 – Shift+click collects several</source>
        <translation>单击将 %1 的此区段固定到 %2——Shift+单击可收集多个</translation>
    </message>
    <message>
        <source>Click the last edge, or Enter attaches %1 stretches to %2 – Backspace takes one back</source>
        <translation>单击最后一条边，或按 Enter 将 %1 个区段固定到 %2——Backspace 撤回一个</translation>
    </message>
    <message>
        <source>Click an edge of an outline to fix it to %1 – Enter takes the selected stretch, Esc ends the tool</source>
        <translation>单击轮廓的一条边，将其固定到 %1——Enter 采用所选区段，Esc 结束工具</translation>
    </message>
    <message>
        <source>&amp;Attach what is marked</source>
        <translation>固定已标记的区段(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Take back the last edge</source>
        <translation>撤回最后一条边(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>放弃(&amp;G)</translation>
    </message>
</context>
<context>
    <name>BackgroundMoveTool</name>
    <message>
        <source>There is no background picture yet.</source>
        <translation>还没有背景图片。</translation>
    </message>
    <message>
        <source>Drag the picture to its place – Enter or Esc ends the tool</source>
        <translation>将图片拖到位——Enter 或 Esc 结束工具</translation>
    </message>
</context>
<context>
    <name>BackgroundPicture</name>
    <message>
        <source>%1 cannot be read as a picture: %2</source>
        <translation>无法将 %1 作为图片读取：%2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an ordinary file.</source>
        <translation>“%1”不是普通文件。</translation>
    </message>
</context>
<context>
    <name>BackgroundScaleTool</name>
    <message>
        <source>There is no background picture yet.</source>
        <translation>还没有背景图片。</translation>
    </message>
    <message>
        <source>Type the true distance of the two points, for example 500 or 20 in.</source>
        <translation>请输入两点的实际距离，例如 500 或 20 in。</translation>
    </message>
    <message>
        <source>Click the first of two points of the picture whose distance you know – Esc ends the tool</source>
        <translation>在图片上单击两个已知距离的点中的第一个——Esc 结束工具</translation>
    </message>
    <message>
        <source>Click the second point</source>
        <translation>单击第二个点</translation>
    </message>
    <message>
        <source>Type their true distance, then Enter</source>
        <translation>输入两点的实际距离，然后按 Enter</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>当前 %1</translation>
    </message>
</context>
<context>
    <name>BoxShapeTool</name>
    <message>
        <source>&quot;%1&quot; is no size: try 300 x 200</source>
        <translation>“%1”不是尺寸：例如 300 x 200</translation>
    </message>
    <message>
        <source>Enter makes it as wide and high as typed, for example 300 x 200</source>
        <translation>按 Enter 采用输入的宽和高，例如 300 x 200</translation>
    </message>
    <message>
        <source>Drag a rectangle, or click two opposite corners – Esc ends the tool</source>
        <translation>拖出一个矩形，或单击两个对角——Esc 结束工具</translation>
    </message>
    <message>
        <source>Drag an ellipse, or click two opposite corners of its box – Esc ends the tool</source>
        <translation>拖出一个椭圆，或单击其外框的两个对角——Esc 结束工具</translation>
    </message>
    <message>
        <source>Click the opposite corner, or type width x height – Shift makes both equal, Ctrl does not snap</source>
        <translation>单击对角，或输入宽 x 高——Shift 使宽高相等，Ctrl 不捕捉</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>There was no room where you clicked: the patch lies beside the others.</source>
        <translation>单击处没有空位：样片放在了其他样片旁边。</translation>
    </message>
    <message>
        <source>The new patch lies on %1: drag it away, or let all be arranged (Pattern &gt; Arrange).</source>
        <translation>新样片压在 %1 上：请将其拖开，或自动排列所有样片（样板 &gt; 排列）。</translation>
    </message>
    <message>
        <source>lies on %1</source>
        <translation>压在 %1 上</translation>
    </message>
</context>
<context>
    <name>ColourwayForm</name>
    <message>
        <source>Fabrics</source>
        <translation>面料</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>those of the patches</source>
        <translation>样片自身的面料</translation>
    </message>
</context>
<context>
    <name>ContextMenus</name>
    <message>
        <source>&amp;Show</source>
        <translation>显示(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>观察方向(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation>云图(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Continuity</source>
        <translation>连续性(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Match</source>
        <translation>对应(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Arrange</source>
        <translation>排列(&amp;A)</translation>
    </message>
</context>
<context>
    <name>CoverAtRest</name>
    <message>
        <source>As soon as the cover has come to rest …</source>
        <translation>待面套静止后…</translation>
    </message>
    <message>
        <source>This needs the cover of the present design: let the solver go on first (Pause).</source>
        <translation>需要当前设计的面套：请先让求解继续（取消“暂停”）。</translation>
    </message>
</context>
<context>
    <name>CoverMeasureTool</name>
    <message>
        <source>There is no cover here: click on the cover.</source>
        <translation>此处没有面套：请单击面套。</translation>
    </message>
    <message>
        <source>&amp;Keep the measurement</source>
        <translation>保留测量(&amp;K)</translation>
    </message>
    <message>
        <source>%1 – Enter keeps the measurement, a click begins anew</source>
        <translation>%1——Enter 保留测量，单击重新开始</translation>
    </message>
    <message>
        <source>Click the second point on the cover – Esc gives it up</source>
        <translation>单击面套上的第二点——Esc 放弃</translation>
    </message>
    <message>
        <source>Click two points of the cover or of the pattern to measure – Esc ends the tool</source>
        <translation>单击面套或样板上的两点进行测量——Esc 结束工具</translation>
    </message>
</context>
<context>
    <name>CoverSelectTool</name>
    <message>
        <source>There is a control point already.</source>
        <translation>此处已有控制点。</translation>
    </message>
    <message>
        <source>Drag to move the control point – Shift+click selects several, Del removes</source>
        <translation>拖动以移动控制点——Shift+单击选择多个，Del 删除</translation>
    </message>
    <message>
        <source>Click to select the seam</source>
        <translation>单击选择接缝</translation>
    </message>
    <message>
        <source>Click to select the patch, drag to turn the view</source>
        <translation>单击选择样片，拖动旋转视图</translation>
    </message>
    <message>
        <source>Click to select the curve, double click to add a control point here</source>
        <translation>单击选择曲线，双击在此添加控制点</translation>
    </message>
    <message>
        <source>Click to select what stands here, drag to turn the view</source>
        <translation>单击选择此处的对象，拖动旋转视图</translation>
    </message>
    <message>
        <source>Click to select, drag to turn – %1 pans, %2 zooms</source>
        <translation>单击选择，拖动旋转——%1 平移，%2 缩放</translation>
    </message>
    <message>
        <source>Click to select the measurement, Delete removes it</source>
        <translation>单击选择测量，Delete 删除</translation>
    </message>
</context>
<context>
    <name>CushionForm</name>
    <message>
        <source>Cover of %1</source>
        <translation>%1 的面套</translation>
    </message>
    <message>
        <source>Every cover</source>
        <translation>所有面套</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>推压</translation>
    </message>
</context>
<context>
    <name>CutCornerForm</name>
    <message>
        <source>Patch</source>
        <translation>样片</translation>
    </message>
</context>
<context>
    <name>CutLabelWords</name>
    <message>
        <source>Cut %1</source>
        <translation>裁 %1 片</translation>
    </message>
    <message>
        <source>Cut %1 and %1 mirrored</source>
        <translation>裁 %1 片，镜像 %1 片</translation>
    </message>
</context>
<context>
    <name>CuttingCommands</name>
    <message>
        <source>Chec&amp;k before cutting</source>
        <translation>裁剪前检查(&amp;K)</translation>
    </message>
</context>
<context>
    <name>DartCommands</name>
    <message>
        <source>Remove da&amp;rt</source>
        <translation>删除省道(&amp;R)</translation>
    </message>
    <message>
        <source>The edge goes on as if the selected dart had never been cut</source>
        <translation>边将恢复为从未剪出所选省道的样子</translation>
    </message>
    <message>
        <source>R&amp;otate dart to …</source>
        <translation>省道转移到(&amp;O)…</translation>
    </message>
    <message>
        <source>Turns the selected dart shut and opens the pattern where you click, by the same angle</source>
        <translation>合拢所选省道，并在单击处以相同角度打开样板</translation>
    </message>
</context>
<context>
    <name>DartDrag</name>
    <message>
        <source>Near the dotted line both legs become of one length, or type how deep it is – Shift keeps to it, Ctrl lets go, Esc takes it back</source>
        <translation>靠近虚线时两省边等长，也可输入省深——Shift 保持在虚线上，Ctrl 脱离，Esc 还原</translation>
    </message>
    <message>
        <source>Drag the dart along the outline, or type how far its middle is from the corner – Esc takes it back</source>
        <translation>沿轮廓拖动省道，或输入其中点到角点的距离——Esc 还原</translation>
    </message>
</context>
<context>
    <name>DartPicture</name>
    <message>
        <source>Depth %1, legs of one length</source>
        <translation>省深 %1，省边等长</translation>
    </message>
    <message>
        <source>Depth %1</source>
        <translation>省深 %1</translation>
    </message>
    <message>
        <source>Mouth %1</source>
        <translation>省口 %1</translation>
    </message>
</context>
<context>
    <name>DartRotateTool</name>
    <message>
        <source>Select the seam of a dart first – Esc ends the tool</source>
        <translation>请先选择省道的接缝——Esc 结束工具</translation>
    </message>
    <message>
        <source>Click the outline where the dart shall open instead – Ctrl does not snap, Esc ends the tool</source>
        <translation>单击轮廓上省道要改在何处打开——Ctrl 不捕捉，Esc 结束工具</translation>
    </message>
</context>
<context>
    <name>DartTool</name>
    <message>
        <source>There is no room for a mouth of &quot;%1&quot;.</source>
        <translation>放不下“%1”的省口。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no depth: try 60</source>
        <translation>“%1”不是深度：例如 60</translation>
    </message>
    <message>
        <source>Click the tip inside the patch, or type how deep it lies – on the dotted line both legs are of one length (Shift keeps to it, Ctrl lets go), Esc takes a click back</source>
        <translation>单击样片内的省尖，或输入省深——在虚线上两省边等长（Shift 保持，Ctrl 脱离），Esc 撤回一次单击</translation>
    </message>
    <message>
        <source>Click where the mouth ends on the same outline, or type how wide it is – Ctrl does not snap, Esc takes the click back</source>
        <translation>单击同一轮廓上省口的终点，或输入省口宽度——Ctrl 不捕捉，Esc 撤回单击</translation>
    </message>
    <message>
        <source>Click an outline where the mouth of the dart begins – Esc ends the tool</source>
        <translation>单击轮廓上省口的起点——Esc 结束工具</translation>
    </message>
</context>
<context>
    <name>DescribedField</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>DesignCuttingSection</name>
    <message>
        <source>Cutting</source>
        <translation>裁剪</translation>
    </message>
    <message>
        <source>Seam allowance of all patches</source>
        <translation>所有样片的缝份</translation>
    </message>
    <message>
        <source>Depth of notches</source>
        <translation>剪口深度</translation>
    </message>
    <message>
        <source>Width of notches</source>
        <translation>剪口宽度</translation>
    </message>
</context>
<context>
    <name>Docks</name>
    <message>
        <source>Pattern</source>
        <translation>样板</translation>
    </message>
    <message>
        <source>Cover</source>
        <translation>面套</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>元素</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>接缝</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>面料</translation>
    </message>
    <message>
        <source>Worst spots</source>
        <translation>最严重部位</translation>
    </message>
    <message>
        <source>Check before cutting</source>
        <translation>裁剪前检查</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>任务</translation>
    </message>
</context>
<context>
    <name>DrawingCommands</name>
    <message>
        <source>&amp;Grid and snapping</source>
        <translation>栅格与捕捉(&amp;G)</translation>
    </message>
    <message>
        <source>S&amp;napping</source>
        <translation>捕捉(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Rulers</source>
        <translation>标尺(&amp;R)</translation>
    </message>
    <message>
        <source>Gui&amp;des</source>
        <translation>参考线(&amp;D)</translation>
    </message>
    <message>
        <source>Remove all g&amp;uides</source>
        <translation>删除所有参考线(&amp;U)</translation>
    </message>
    <message>
        <source>Select with a &amp;loop</source>
        <translation>套索选择(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Background picture</source>
        <translation>背景图片(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Open picture …</source>
        <translation>打开图片(&amp;O)…</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>显示(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Scale by two points</source>
        <translation>按两点缩放(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>移动(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>Opacity %1</source>
        <translation>不透明度 %1</translation>
    </message>
    <message>
        <source>Open a picture to trace</source>
        <translation>打开要描摹的图片</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.webp);;All files (*)</source>
        <translation>图片 (*.png *.jpg *.jpeg *.bmp *.webp);;所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>DrawingKeys</name>
    <message>
        <source>&amp;Finish</source>
        <translation>完成(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Take back the last point</source>
        <translation>撤回最后一个点(&amp;T)</translation>
    </message>
    <message>
        <source>Switch between &amp;straight and smooth</source>
        <translation>直线/平滑切换(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>放弃(&amp;G)</translation>
    </message>
</context>
<context>
    <name>DrillHoleForm</name>
    <message>
        <source>Patch</source>
        <translation>样片</translation>
    </message>
</context>
<context>
    <name>EdgeAllowanceForm</name>
    <message>
        <source>Outline</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
</context>
<context>
    <name>EditCommands</name>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Name this &amp;branch …</source>
        <translation>命名此分支(&amp;B)…</translation>
    </message>
    <message>
        <source>Name the way that the history has gone since it forked</source>
        <translation>为历史自分叉以来的路径命名</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>重命名(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>Select &amp;all patches</source>
        <translation>选择所有样片(&amp;A)</translation>
    </message>
    <message>
        <source>Select n&amp;othing</source>
        <translation>取消选择(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>撤销(&amp;U)：%1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>重做(&amp;R)：%1</translation>
    </message>
</context>
<context>
    <name>ElementText</name>
    <message>
        <source>missing element %1</source>
        <translation>缺失的元素 %1</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>样片</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>样片</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>接缝</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>接缝</translation>
    </message>
    <message>
        <source>Fixation curve</source>
        <translation>固定曲线</translation>
    </message>
    <message>
        <source>Fixation curves</source>
        <translation>固定曲线</translation>
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
        <translation>骨架</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>骨架</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>面料</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>面料</translation>
    </message>
    <message>
        <source>Unusable element</source>
        <translation>不可用的元素</translation>
    </message>
    <message>
        <source>Unusable elements</source>
        <translation>不可用的元素</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>设计</translation>
    </message>
    <message>
        <source>%1 and %2, ease %3</source>
        <translation>%1 与 %2，吃势 %3</translation>
    </message>
    <message>
        <source>%1, normal held</source>
        <translation>%1，保持法线</translation>
    </message>
    <message>
        <source>Handle curve</source>
        <translation>操控曲线</translation>
    </message>
    <message>
        <source>Handle curves</source>
        <translation>操控曲线</translation>
    </message>
    <message>
        <source>Fancy seam</source>
        <translation>装饰缝</translation>
    </message>
    <message>
        <source>Fancy seams</source>
        <translation>装饰缝</translation>
    </message>
    <message>
        <source>Cushion</source>
        <translation>软垫</translation>
    </message>
    <message>
        <source>Cushions</source>
        <translation>软垫</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>泡沫</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>%1 patches</source>
        <translation>%1 个样片</translation>
    </message>
    <message>
        <source>%1 seams</source>
        <translation>%1 条接缝</translation>
    </message>
    <message>
        <source>%1 fixation curves</source>
        <translation>%1 条固定曲线</translation>
    </message>
    <message>
        <source>%1 fixations</source>
        <translation>%1 个固定</translation>
    </message>
    <message>
        <source>%1 handle curves</source>
        <translation>%1 条操控曲线</translation>
    </message>
    <message>
        <source>%1 fancy seams</source>
        <translation>%1 条装饰缝</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 个骨架</translation>
    </message>
    <message>
        <source>%1 cushions</source>
        <translation>%1 个软垫</translation>
    </message>
    <message>
        <source>%1 pieces of foam</source>
        <translation>%1 块泡沫</translation>
    </message>
    <message>
        <source>%1 scans</source>
        <translation>%1 个扫描</translation>
    </message>
    <message>
        <source>%1 fabrics</source>
        <translation>%1 种面料</translation>
    </message>
    <message>
        <source>%1 unusable elements</source>
        <translation>%1 个不可用的元素</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 个元素</translation>
    </message>
    <message>
        <source>Trimmed edge</source>
        <translation>饰边</translation>
    </message>
    <message>
        <source>Trimmed edges</source>
        <translation>饰边</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>配色</translation>
    </message>
    <message>
        <source>Colourways</source>
        <translation>配色</translation>
    </message>
    <message>
        <source>%1 trimmed edges</source>
        <translation>%1 条饰边</translation>
    </message>
    <message>
        <source>%1 colourways</source>
        <translation>%1 个配色</translation>
    </message>
    <message>
        <source>Edge of %1</source>
        <translation>%1 的边</translation>
    </message>
    <message>
        <source>Allowance of an edge</source>
        <translation>边的缝份</translation>
    </message>
    <message>
        <source>Allowances of edges</source>
        <translation>边的缝份</translation>
    </message>
    <message>
        <source>%1 allowances of edges</source>
        <translation>%1 个边的缝份</translation>
    </message>
    <message>
        <source>Corner of the cut line</source>
        <translation>裁剪线角</translation>
    </message>
    <message>
        <source>Corners of the cut line</source>
        <translation>裁剪线角</translation>
    </message>
    <message>
        <source>%1 corners of the cut line</source>
        <translation>%1 个裁剪线角</translation>
    </message>
    <message>
        <source>Drill hole</source>
        <translation>钻孔</translation>
    </message>
    <message>
        <source>Drill holes</source>
        <translation>钻孔</translation>
    </message>
    <message>
        <source>%1 drill holes</source>
        <translation>%1 个钻孔</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>剪口</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>剪口</translation>
    </message>
    <message>
        <source>%1 notches</source>
        <translation>%1 个剪口</translation>
    </message>
    <message>
        <source>Internal line</source>
        <translation>内部线</translation>
    </message>
    <message>
        <source>Internal lines</source>
        <translation>内部线</translation>
    </message>
    <message>
        <source>%1 internal lines</source>
        <translation>%1 条内部线</translation>
    </message>
    <message>
        <source>%1, allowance %2</source>
        <translation>%1，缝份 %2</translation>
    </message>
    <message>
        <source>Notch of %1</source>
        <translation>%1 的剪口</translation>
    </message>
    <message>
        <source>Corner of %1</source>
        <translation>%1 的角点</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>%1 measurements</source>
        <translation>%1 个测量</translation>
    </message>
</context>
<context>
    <name>ElementsModel</name>
    <message>
        <source>edge %1</source>
        <translation>边 %1</translation>
    </message>
    <message>
        <source>%1 from the corner</source>
        <translation>距角点 %1</translation>
    </message>
</context>
<context>
    <name>FabricForm</name>
    <message>
        <source>Weft</source>
        <translation>纬纱</translation>
    </message>
    <message>
        <source>Creases</source>
        <translation>皮纹沟</translation>
    </message>
    <message>
        <source>Depth of the pile</source>
        <translation>绒毛深处</translation>
    </message>
    <message>
        <source>Other squares</source>
        <translation>其余方格</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>Squares</source>
        <translation>方格</translation>
    </message>
    <message>
        <source>Grain size</source>
        <translation>粒纹大小</translation>
    </message>
    <message>
        <source>Repeat of the weave</source>
        <translation>织纹循环</translation>
    </message>
    <message>
        <source>Nap</source>
        <translation>毛向</translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation>图片宽度</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>性能</translation>
    </message>
    <message>
        <source>The fabric on a cushion and on a ball</source>
        <translation>面料在靠垫和球上的效果</translation>
    </message>
    <message>
        <source>The fabric on a cushion and on a ball, at its real scale</source>
        <translation>面料在靠垫和球上的效果，按实际比例</translation>
    </message>
    <message>
        <source>Colour of the fabric</source>
        <translation>面料颜色</translation>
    </message>
    <message>
        <source>Second colour of the fabric</source>
        <translation>面料的第二颜色</translation>
    </message>
    <message>
        <source>From the first colour</source>
        <translation>取自第一颜色</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Choose an&amp;other picture …</source>
        <translation>选择其他图片(&amp;O)…</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>裁剪</translation>
    </message>
</context>
<context>
    <name>FabricMenu</name>
    <message>
        <source>&amp;New fabric</source>
        <translation>新建面料(&amp;N)</translation>
    </message>
    <message>
        <source>Adds leather, weave, velvet or another fabric to the library of the design</source>
        <translation>向设计的面料库添加皮革、机织物、丝绒或其他面料</translation>
    </message>
    <message>
        <source>From a &amp;picture …</source>
        <translation>从图片(&amp;P)…</translation>
    </message>
    <message>
        <source>A fabric that looks like a picture: PNG, JPEG, TIFF or OpenEXR</source>
        <translation>外观取自图片的面料：PNG、JPEG、TIFF 或 OpenEXR</translation>
    </message>
    <message>
        <source>&amp;Assign to selection</source>
        <translation>赋予所选(&amp;A)</translation>
    </message>
    <message>
        <source>Gives the selected patches the fabric that is chosen in the library</source>
        <translation>将面料库中选定的面料赋予所选样片</translation>
    </message>
    <message>
        <source>Fabric p&amp;roperties</source>
        <translation>面料属性(&amp;R)</translation>
    </message>
    <message>
        <source>Shows kind, colours, size and limits of the fabric</source>
        <translation>显示面料的种类、颜色、尺寸和极限</translation>
    </message>
    <message>
        <source>Picture on the &amp;fabric …</source>
        <translation>面料上的图片(&amp;F)…</translation>
    </message>
    <message>
        <source>Lets the fabric look like a picture: PNG, JPEG, TIFF or OpenEXR</source>
        <translation>使面料外观取自图片：PNG、JPEG、TIFF 或 OpenEXR</translation>
    </message>
    <message>
        <source>D&amp;uplicate fabric</source>
        <translation>创建面料副本(&amp;U)</translation>
    </message>
    <message>
        <source>Adds a copy of the fabric, to be changed</source>
        <translation>添加面料的副本以供修改</translation>
    </message>
    <message>
        <source>Rename fa&amp;bric …</source>
        <translation>重命名面料(&amp;B)…</translation>
    </message>
    <message>
        <source>Gives the fabric another name</source>
        <translation>为面料另取名称</translation>
    </message>
    <message>
        <source>&amp;Delete fabric …</source>
        <translation>删除面料(&amp;D)…</translation>
    </message>
    <message>
        <source>Removes the fabric; asks what patches get instead</source>
        <translation>删除面料；会询问样片改用何种面料</translation>
    </message>
    <message>
        <source>&amp;Import fabrics …</source>
        <translation>导入面料(&amp;I)…</translation>
    </message>
    <message>
        <source>Takes over the fabrics of a file, a design or a project</source>
        <translation>采用文件、设计或项目中的面料</translation>
    </message>
    <message>
        <source>&amp;Export fabric …</source>
        <translation>导出面料(&amp;E)…</translation>
    </message>
    <message>
        <source>Writes the fabric to a file, its picture beside it</source>
        <translation>将面料写入文件，图片放在旁边</translation>
    </message>
    <message>
        <source>Pre&amp;views</source>
        <translation>预览(&amp;V)</translation>
    </message>
    <message>
        <source>On &amp;cushions</source>
        <translation>靠垫(&amp;C)</translation>
    </message>
    <message>
        <source>Shows the fabrics of the library on cushions</source>
        <translation>在靠垫上显示面料库中的面料</translation>
    </message>
    <message>
        <source>On &amp;balls</source>
        <translation>球(&amp;B)</translation>
    </message>
    <message>
        <source>Shows the fabrics of the library on balls</source>
        <translation>在球上显示面料库中的面料</translation>
    </message>
    <message>
        <source>&amp;Show colourway</source>
        <translation>显示配色(&amp;S)</translation>
    </message>
    <message>
        <source>Chooses which fabrics are seen; the shape stays</source>
        <translation>选择显示哪些面料；形状不变</translation>
    </message>
    <message>
        <source>New &amp;colourway …</source>
        <translation>新建配色(&amp;C)…</translation>
    </message>
    <message>
        <source>Adds a set of fabrics for the patches; it begins as what is shown now</source>
        <translation>为样片添加一组面料；以当前显示为初始内容</translation>
    </message>
    <message>
        <source>Rena&amp;me colourway …</source>
        <translation>重命名配色(&amp;M)…</translation>
    </message>
    <message>
        <source>Gives the colourway that is shown another name</source>
        <translation>为显示的配色另取名称</translation>
    </message>
    <message>
        <source>De&amp;lete colourway</source>
        <translation>删除配色(&amp;L)</translation>
    </message>
    <message>
        <source>Removes the colourway that is shown</source>
        <translation>删除显示的配色</translation>
    </message>
    <message>
        <source>Compare c&amp;olourways …</source>
        <translation>比较配色(&amp;O)…</translation>
    </message>
    <message>
        <source>Shows two colourways side by side</source>
        <translation>并排显示两个配色</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>原样</translation>
    </message>
</context>
<context>
    <name>FabricPresets</name>
    <message>
        <source>Leather, cognac</source>
        <translation>皮革，干邑色</translation>
    </message>
    <message>
        <source>Leather, black</source>
        <translation>皮革，黑色</translation>
    </message>
    <message>
        <source>Leather, cream</source>
        <translation>皮革，奶油色</translation>
    </message>
    <message>
        <source>Smooth leather, dark brown</source>
        <translation>光面皮革，深棕色</translation>
    </message>
    <message>
        <source>Smooth leather, red</source>
        <translation>光面皮革，红色</translation>
    </message>
    <message>
        <source>Weave, grey</source>
        <translation>机织物，灰色</translation>
    </message>
    <message>
        <source>Weave, blue</source>
        <translation>机织物，蓝色</translation>
    </message>
    <message>
        <source>Weave, sand</source>
        <translation>机织物，沙色</translation>
    </message>
    <message>
        <source>Velvet, green</source>
        <translation>丝绒，绿色</translation>
    </message>
    <message>
        <source>Velvet, petrol</source>
        <translation>丝绒，石油蓝</translation>
    </message>
    <message>
        <source>Checker, 20 mm</source>
        <translation>棋盘格，20 mm</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>纯色</translation>
    </message>
</context>
<context>
    <name>FancySeamForm</name>
    <message>
        <source>Patch</source>
        <translation>样片</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>It stands out: a welt.</source>
        <translation>向外凸起：凸棱。</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>Patch</source>
        <translation>样片</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>面料</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>面料</translation>
    </message>
    <message>
        <source>Press harder</source>
        <translation>加重推压</translation>
    </message>
    <message>
        <source>Press like straight ones</source>
        <translation>与正面相同</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>骨架</translation>
    </message>
    <message>
        <source>Padded parts</source>
        <translation>加垫部件</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>推压</translation>
    </message>
    <message>
        <source>Smallest detail</source>
        <translation>最小细节</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>垫层</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>Slanted faces</source>
        <translation>斜面</translation>
    </message>
    <message>
        <source>Pushes the cover</source>
        <translation>推压面套</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>纯色</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>棋盘格</translation>
    </message>
    <message>
        <source>Smooth leather</source>
        <translation>光面皮革</translation>
    </message>
    <message>
        <source>Grained leather</source>
        <translation>粒纹皮革</translation>
    </message>
    <message>
        <source>Woven</source>
        <translation>机织物</translation>
    </message>
    <message>
        <source>Velvet</source>
        <translation>丝绒</translation>
    </message>
    <message>
        <source>Picture …</source>
        <translation>图片…</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>种类</translation>
    </message>
    <message>
        <source>Second colour</source>
        <translation>第二颜色</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>粗糙度</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>Turned from the grain</source>
        <translation>相对布纹的转角</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>凹凸</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Most along the grain</source>
        <translation>沿布纹最大</translation>
    </message>
    <message>
        <source>Most across</source>
        <translation>横布纹最大</translation>
    </message>
    <message>
        <source>Most shear</source>
        <translation>最大剪切</translation>
    </message>
    <message>
        <source>Poisson</source>
        <translation>泊松比</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>刚度</translation>
    </message>
    <message>
        <source>Bending length</source>
        <translation>弯曲长度</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>外观</translation>
    </message>
    <message>
        <source>Strain limits</source>
        <translation>应变极限</translation>
    </message>
    <message>
        <source>Mirror twin</source>
        <translation>镜像件</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>On the curve</source>
        <translation>曲线上的位置</translation>
    </message>
    <message>
        <source>Curve runs backwards</source>
        <translation>曲线反向</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>权重</translation>
    </message>
    <message>
        <source>Curve in space</source>
        <translation>空间曲线</translation>
    </message>
    <message>
        <source>Round – a soft groove</source>
        <translation>圆——柔和的凹槽</translation>
    </message>
    <message>
        <source>Sharp – a crease</source>
        <translation>尖——折痕</translation>
    </message>
    <message>
        <source>Welt – between creases</source>
        <translation>凸棱——位于折痕之间</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>布纹</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>压力</translation>
    </message>
    <message>
        <source>Wrong side out</source>
        <translation>反面朝外</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>轮廓</translation>
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
        <translation>塑料</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>泡沫</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Keeps the cover outside</source>
        <translation>挡住面套</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>Hidden parts</source>
        <translation>隐藏的部件</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>圆柱体</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>球体</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Cushion</source>
        <translation>软垫</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>挖除</translation>
    </message>
    <message>
        <source>Along the normal</source>
        <translation>沿法线</translation>
    </message>
    <message>
        <source>To the point itself</source>
        <translation>到点本身</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>Fit the cover to it</source>
        <translation>使面套贴合</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>拉力</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>裁切</translation>
    </message>
    <message>
        <source>C0 – an edge</source>
        <translation>C0——有棱边</translation>
    </message>
    <message>
        <source>C1 – smooth, texture too</source>
        <translation>C1——平滑，纹理也连续</translation>
    </message>
    <message>
        <source>G1 – rounded</source>
        <translation>G1——圆顺</translation>
    </message>
    <message>
        <source>First stretch</source>
        <translation>第一区段</translation>
    </message>
    <message>
        <source>Second stretch</source>
        <translation>第二区段</translation>
    </message>
    <message>
        <source>Second side runs backwards</source>
        <translation>第二侧反向</translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation>连续性</translation>
    </message>
    <message>
        <source>Mesh edges</source>
        <translation>网格边长</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>对称</translation>
    </message>
    <message>
        <source>Colourway shown</source>
        <translation>显示的配色</translation>
    </message>
    <message>
        <source>Begins at</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>Ends at</source>
        <translation>终点</translation>
    </message>
    <message>
        <source>By length</source>
        <translation>按长度</translation>
    </message>
    <message>
        <source>By parameter</source>
        <translation>按参数</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>对应</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Single row</source>
        <translation>单明线</translation>
    </message>
    <message>
        <source>Twin rows</source>
        <translation>双明线</translation>
    </message>
    <message>
        <source>Stitches</source>
        <translation>明线</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>缝线</translation>
    </message>
    <message>
        <source>Stitch length</source>
        <translation>针距</translation>
    </message>
    <message>
        <source>Distance from the seam</source>
        <translation>距接缝距离</translation>
    </message>
    <message>
        <source>Thread width</source>
        <translation>缝线粗细</translation>
    </message>
    <message>
        <source>Radius (0: none)</source>
        <translation>半径（0：无）</translation>
    </message>
    <message>
        <source>Seam allowance</source>
        <translation>缝份</translation>
    </message>
    <message>
        <source>The cover dips into the seam</source>
        <translation>面套在接缝处下凹</translation>
    </message>
    <message>
        <source>Trim</source>
        <translation>饰边</translation>
    </message>
    <message>
        <source> mm per unit</source>
        <translation> mm/单位</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>The frame that is padded</source>
        <translation>要加垫的骨架</translation>
    </message>
    <message>
        <source>Which cover the padding presses outwards</source>
        <translation>垫层向外推压哪个面套</translation>
    </message>
    <message>
        <source>How finely the frame is looked at: what is thinner may stay without padding</source>
        <translation>考察骨架的精细程度：更薄之处可能没有垫层</translation>
    </message>
    <message>
        <source>How thick the padding around the frame is</source>
        <translation>骨架外垫层的厚度</translation>
    </message>
    <message>
        <source>How hard the padding presses the cover outwards; from about 2 on it gives no more</source>
        <translation>垫层向外推压面套的力度；约大于 2 后不再增加</translation>
    </message>
    <message>
        <source>How padding presses that is aslant to width, depth and height: harder fills the cover more</source>
        <translation>与宽、深、高方向倾斜的垫层如何推压：加重则面套更饱满</translation>
    </message>
    <message>
        <source>How thick the padding around this foam is</source>
        <translation>此泡沫外垫层的厚度</translation>
    </message>
    <message>
        <source>How hard this foam presses the cover outwards; from about 2 on it gives no more</source>
        <translation>此泡沫向外推压面套的力度；约大于 2 后不再增加</translation>
    </message>
    <message>
        <source>Takes this shape out of the cushion instead of adding it</source>
        <translation>从软垫中挖去此形状，而不是添加</translation>
    </message>
    <message>
        <source>as made</source>
        <translation>原样</translation>
    </message>
    <message>
        <source>Stitching</source>
        <translation>明线</translation>
    </message>
    <message>
        <source>Thread colour</source>
        <translation>线色</translation>
    </message>
    <message>
        <source>Stitch distance</source>
        <translation>明线边距</translation>
    </message>
    <message>
        <source>Piping radius</source>
        <translation>嵌线半径</translation>
    </message>
    <message>
        <source>Piping fabric</source>
        <translation>嵌线面料</translation>
    </message>
    <message>
        <source>Valley</source>
        <translation>凹陷</translation>
    </message>
    <message>
        <source>Mitred – to a point</source>
        <translation>斜接——尖角</translation>
    </message>
    <message>
        <source>Square – cut off</source>
        <translation>平切——切平</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>圆角</translation>
    </message>
    <message>
        <source>Folded – lies under the piece</source>
        <translation>折角——折在样片下</translation>
    </message>
    <message>
        <source>Stepped</source>
        <translation>阶梯角</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>缝份</translation>
    </message>
    <message>
        <source>From the sewing line to the line where the fabric is cut.</source>
        <translation>从缝合线到裁剪线的距离。</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>角</translation>
    </message>
    <message>
        <source>Corners of the cut line</source>
        <translation>裁剪线角</translation>
    </message>
    <message>
        <source>as the design&apos;s</source>
        <translation>同设计</translation>
    </message>
    <message>
        <source>Lies at</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>角点</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>一字</translation>
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
        <translation>方形</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>剪口</translation>
    </message>
    <message>
        <source>Depth of notches</source>
        <translation>剪口深度</translation>
    </message>
    <message>
        <source>Width of notches</source>
        <translation>剪口宽度</translation>
    </message>
    <message>
        <source>Notches along seams every</source>
        <translation>沿接缝的剪口间距</translation>
    </message>
    <message>
        <source>Notches at ends of seams</source>
        <translation>接缝端点的剪口</translation>
    </message>
    <message>
        <source>Notches that tell halves apart</source>
        <translation>区分两半的剪口</translation>
    </message>
    <message>
        <source>Two side by side</source>
        <translation>两个并排</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>裁剪</translation>
    </message>
    <message>
        <source>Label at</source>
        <translation>标签位置</translation>
    </message>
    <message>
        <source>Label turned by</source>
        <translation>标签转角</translation>
    </message>
    <message>
        <source>Two ways – either end up</source>
        <translation>双向——任一端朝上</translation>
    </message>
    <message>
        <source>One way – one end up</source>
        <translation>单向——一端朝上</translation>
    </message>
    <message>
        <source>Any direction</source>
        <translation>任意方向</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>Mirrored pair</source>
        <translation>镜像成对</translation>
    </message>
    <message>
        <source>Nap</source>
        <translation>毛向</translation>
    </message>
    <message>
        <source>Grain may be off by</source>
        <translation>布纹允许偏斜</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>where it finds room</source>
        <translation>有空位处</translation>
    </message>
    <message>
        <source>Usable width</source>
        <translation>有效门幅</translation>
    </message>
    <message>
        <source>Shrinks along</source>
        <translation>经向缩率</translation>
    </message>
    <message>
        <source>Pieces are cut so much larger along the grain that they have their size when the fabric has shrunk.</source>
        <translation>样片沿布纹方向相应放大裁剪，使面料收缩后尺寸正确。</translation>
    </message>
    <message>
        <source>Shrinks across</source>
        <translation>纬向缩率</translation>
    </message>
    <message>
        <source>10 mm</source>
        <translation>10 mm</translation>
    </message>
    <message>
        <source>Automatic notches</source>
        <translation>自动剪口</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>款号</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>绘出</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切割</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>略去</translation>
    </message>
    <message>
        <source>On the cutting table</source>
        <translation>在裁床上</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>参考线</translation>
    </message>
    <message>
        <source>Top stitching</source>
        <translation>明线</translation>
    </message>
    <message>
        <source>Tie-down strip</source>
        <translation>吊紧布</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>折线</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>用途</translation>
    </message>
    <message>
        <source>Ease wanted</source>
        <translation>所需吃势</translation>
    </message>
    <message>
        <source>How much longer the second side shall be than the first one: it is gathered when it is sewn.</source>
        <translation>第二侧应比第一侧长多少：缝制时缩缝。</translation>
    </message>
    <message>
        <source>Bulge of the allowance</source>
        <translation>缝份隆起</translation>
    </message>
    <message>
        <source>With a zip</source>
        <translation>带拉链</translation>
    </message>
    <message>
        <source>A zip joins the two sides; the sewing sheet tells its length.</source>
        <translation>拉链连接两侧；缝制工艺单注明其长度。</translation>
    </message>
    <message>
        <source>Step in sewing</source>
        <translation>缝制步骤</translation>
    </message>
    <message>
        <source>Seams with a number are sewn first, smaller ones before larger ones. 0: as the program proposes it.</source>
        <translation>有编号的接缝先缝，小号在前。0：按程序建议。</translation>
    </message>
    <message>
        <source>How near a point of the scan must be to pull at the cover. What the scan has not seen stays as the pattern makes it.</source>
        <translation>扫描的点距面套多近才会拉动面套。扫描未覆盖之处保持样板的形状。</translation>
    </message>
    <message>
        <source>How firmly the scan pulls at the cover, against the pattern: more follows finer detail, and more of the noise.</source>
        <translation>扫描相对样板拉动面套的力度：越大越贴合细节，噪声也越多。</translation>
    </message>
    <message>
        <source>The cover is pulled to the scan. Without that it is only measured. Align the scan first.</source>
        <translation>将面套拉向扫描；否则仅测量。请先对齐扫描。</translation>
    </message>
    <message>
        <source>To its surface: the cover may slide along it. To its points: it may not, which suits scans with few points.</source>
        <translation>到表面：面套可沿其滑动。到点：不可滑动，适合点少的扫描。</translation>
    </message>
    <message>
        <source>For whoever works on the design: it changes neither the cover nor what is cut</source>
        <translation>供设计人员参考：不改变面套，也不改变裁剪内容</translation>
    </message>
    <message>
        <source>Line on the label</source>
        <translation>标签上的一行</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>A filling that presses from inside. 0.05 to 0.3 fills a cushion; at 1 most fabrics are stretched too far.</source>
        <translation>从内部施压的填充。0.05 到 0.3 可充满坐垫；为 1 时多数面料会拉伸过度。</translation>
    </message>
    <message>
        <source>How long the edges of the triangles are: shorter ones show smaller folds, and take longer.</source>
        <translation>三角形边的长度：越短显示的褶皱越细，用时也越长。</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>&amp;New</source>
        <translation>新建(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近打开(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Unsaved work</source>
        <translation>未保存的工作(&amp;U)</translation>
    </message>
    <message>
        <source>Sa&amp;mples</source>
        <translation>示例(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Save a &amp;copy</source>
        <translation>保存副本(&amp;C)</translation>
    </message>
    <message>
        <source>With &amp;everything …</source>
        <translation>包含全部(&amp;E)…</translation>
    </message>
    <message>
        <source>Without &amp;history …</source>
        <translation>不含历史(&amp;H)…</translation>
    </message>
    <message>
        <source>Without history and &amp;scans …</source>
        <translation>不含历史和扫描(&amp;S)…</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>恢复到已保存(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Import frame …</source>
        <translation>导入骨架(&amp;I)…</translation>
    </message>
    <message>
        <source>Impor&amp;t scan …</source>
        <translation>导入扫描(&amp;T)…</translation>
    </message>
    <message>
        <source>&amp;Export surface …</source>
        <translation>导出曲面(&amp;E)…</translation>
    </message>
    <message>
        <source>Export &amp;picture …</source>
        <translation>导出图片(&amp;P)…</translation>
    </message>
    <message>
        <source>Ren&amp;der picture …</source>
        <translation>渲染图片(&amp;D)…</translation>
    </message>
    <message>
        <source>E&amp;xport pattern …</source>
        <translation>导出样板(&amp;X)…</translation>
    </message>
    <message>
        <source>Import pattern (DX&amp;F, SVG) …</source>
        <translation>导入样板 (DXF、SVG)(&amp;F)…</translation>
    </message>
    <message>
        <source>Export cover (&amp;HTML, glTF, STL) …</source>
        <translation>导出面套 (HTML、glTF、STL)(&amp;H)…</translation>
    </message>
    <message>
        <source>Export foam &amp;body …</source>
        <translation>导出泡沫体(&amp;B)…</translation>
    </message>
    <message>
        <source>Print view …</source>
        <translation>打印视图…</translation>
    </message>
</context>
<context>
    <name>FileFormats</name>
    <message>
        <source>Page for the customer</source>
        <translation>给客户的网页</translation>
    </message>
    <message>
        <source>USDZ, for phones</source>
        <translation>USDZ，用于手机</translation>
    </message>
    <message>
        <source>OBJ with materials</source>
        <translation>OBJ，带材质</translation>
    </message>
    <message>
        <source>STL, with a thickness</source>
        <translation>STL，带厚度</translation>
    </message>
    <message>
        <source>3MF, with a thickness</source>
        <translation>3MF，带厚度</translation>
    </message>
    <message>
        <source>STEP, curves alone</source>
        <translation>STEP，仅曲线</translation>
    </message>
    <message>
        <source>STEP, of flat faces</source>
        <translation>STEP，平面片</translation>
    </message>
</context>
<context>
    <name>FixationCurveForm</name>
    <message>
        <source>Length</source>
        <translation>长度</translation>
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
        <translation>曲线至少需要两个点，闭合曲线需要三个。</translation>
    </message>
    <message>
        <source>Fixation %1</source>
        <translation>固定 %1</translation>
    </message>
    <message>
        <source>Click to close the curve</source>
        <translation>单击以闭合曲线</translation>
    </message>
    <message>
        <source>There is neither a frame nor the cover here: click on one, or type x, y, z.</source>
        <translation>此处既无骨架也无面套：请单击其中之一，或输入 x, y, z。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no place: try 250, -100, 40</source>
        <translation>“%1”不是位置：例如 250, -100, 40</translation>
    </message>
    <message>
        <source>Enter sets the point: x, y, z – without z it is as high as the last one</source>
        <translation>按 Enter 设置点：x, y, z——不输入 z 则与上一点等高</translation>
    </message>
    <message>
        <source>Click on a frame to begin a fixation curve, or type x, y, z – drag turns the view, Esc ends the tool</source>
        <translation>单击骨架开始绘制固定曲线，或输入 x, y, z——拖动旋转视图，Esc 结束工具</translation>
    </message>
    <message>
        <source>Click or type the next point, Enter ends, C closes – B makes it straight, Backspace takes a point back</source>
        <translation>单击或输入下一点，Enter 结束，C 闭合——B 改为直线，Backspace 撤回一点</translation>
    </message>
    <message>
        <source>Click or type the next point, Enter ends, C closes – straight from point to point, whatever lies between: B makes it smooth along the surface, Backspace takes a point back</source>
        <translation>单击或输入下一点，Enter 结束，C 闭合——点与点间为直线，不论中间有何物：B 改为沿曲面平滑，Backspace 撤回一点</translation>
    </message>
    <message>
        <source>&amp;Close the curve</source>
        <translation>闭合曲线(&amp;C)</translation>
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
        <translation>曲线</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>On the curve</source>
        <translation>曲线上的位置</translation>
    </message>
</context>
<context>
    <name>FixationsLeft</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>还有 %n 条</numerusform>
        </translation>
    </message>
    <message>
        <source>They stay where they are. Drag their points onto the frame, or undo the change.</source>
        <translation>它们留在原处。请将其点拖到骨架上，或撤销更改。</translation>
    </message>
    <message numerus="yes">
        <source>%n fixation curve(s) no longer lie on the frame.</source>
        <translation>
            <numerusform>%n 条固定曲线不再位于骨架上。</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1”: its edge is up to %2 away</source>
        <translation>“%1”：其边最多相距 %2</translation>
    </message>
    <message>
        <source>“%1”: up to %2</source>
        <translation>“%1”：最多 %2</translation>
    </message>
    <message>
        <source>“%1”: more than %2</source>
        <translation>“%1”：超过 %2</translation>
    </message>
</context>
<context>
    <name>FixingCommands</name>
    <message>
        <source>&amp;Create fixation curve</source>
        <translation>创建固定曲线(&amp;C)</translation>
    </message>
    <message>
        <source>Select two points of an outline first: what lies between them is fixed.</source>
        <translation>请先选择轮廓的两个点：其间的部分将被固定。</translation>
    </message>
    <message>
        <source>Fixation %1</source>
        <translation>固定 %1</translation>
    </message>
    <message>
        <source>There is no surface of this patch yet on which the curve could lie.</source>
        <translation>此样片还没有可供曲线依附的曲面。</translation>
    </message>
</context>
<context>
    <name>FoamForm</name>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
</context>
<context>
    <name>FormPatternReport</name>
    <message numerus="yes">
        <source>(and %n more)</source>
        <translation>
            <numerusform>（另有 %n 项）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n 个样片</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seams, whose sides are equally long</source>
        <translation>
            <numerusform>%n 条接缝，两侧等长</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n seams, whose sides differ by %1 at most</source>
        <translation>
            <numerusform>%n 条接缝，两侧最多相差 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Its cover at rest lies up to %1 beside the form, where nothing holds it: tick &quot;Keeps the cover outside&quot; at the frame, or hold it by a fixation.</source>
        <translation>静止的面套在无固定处偏离形体最多 %1：请在骨架处勾选“挡住面套”，或用固定将其固定。</translation>
    </message>
    <message>
        <source>Its cover at rest lies up to %1 beside the form, where nothing holds it: hold it by a fixation, or give its pieces pressure.</source>
        <translation>静止的面套在无固定处偏离形体最多 %1：请用固定将其固定，或给其样片施加压力。</translation>
    </message>
    <message>
        <source>Its cover is being solved …</source>
        <translation>正在求解其面套 …</translation>
    </message>
    <message>
        <source>Its cover does not come to rest.</source>
        <translation>其面套无法静止。</translation>
    </message>
    <message>
        <source>Its cover at rest is strained no more than the fabric may be.</source>
        <translation>其静止面套的应变未超过面料允许的范围。</translation>
    </message>
    <message>
        <source>What counts is its cover at rest: %1</source>
        <translation>以其静止面套为准：%1</translation>
    </message>
    <message>
        <source>Laid on the form by itself no piece is strained so much. Narrow tips and steps of a line do that, or mesh edges that are long for them.</source>
        <translation>单独铺在形体上时，没有样片应变这么大。这是线条的窄尖和台阶，或对它们来说过长的网格边造成的。</translation>
    </message>
    <message numerus="yes">
        <source>and %n more are left out, too</source>
        <translation>
            <numerusform>另有 %n 个也被略去</numerusform>
        </translation>
    </message>
    <message>
        <source>Laid on the form by itself most strained: %1, %2 (rms), %3 within 99 % of its area, %4 where it is most</source>
        <translation>单独铺在形体上时应变最大：%1，%2（均方根），99 % 面积内 %3，最大处 %4</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces are strained by more than the fabric may be in more than a hundredth of their area (yellow): divide them, or cut them in there.</source>
        <translation>
            <numerusform>%n 个样片有超过百分之一的面积应变超出面料允许值（黄色）：请将其划分，或在该处切开。</numerusform>
        </translation>
    </message>
    <message>
        <source>Its cover will have about %1 vertices, and is not solved here: with mesh edges of %2 it is.</source>
        <translation>其面套约有 %1 个顶点，此处不求解：网格边长为 %2 时才求解。</translation>
    </message>
    <message>
        <source>So that the cover does not sink into the frame, tick &quot;Keeps the cover outside&quot; at the frame.</source>
        <translation>为使面套不陷入骨架，请在骨架处勾选“挡住面套”。</translation>
    </message>
    <message>
        <source>With shorter mesh edges smaller pieces are divided, too.</source>
        <translation>网格边更短时，更小的样片也会被分割。</translation>
    </message>
    <message>
        <source>Tick &quot;where it would not lie flat&quot;: that finds where to divide them.</source>
        <translation>勾选“在无法展平处”即可找到划分之处。</translation>
    </message>
    <message>
        <source>The form is taken as %1 large. If that is wrong, import the file as a frame.</source>
        <translation>形状按 %1 的大小处理。如果不对，请将文件作为骨架导入。</translation>
    </message>
</context>
<context>
    <name>FrameEdgeCommands</name>
    <message>
        <source>Fixation curve along an &amp;edge</source>
        <translation>沿棱边的固定曲线(&amp;E)</translation>
    </message>
    <message>
        <source>Click an edge of a frame: of STEP and IGES the edges of its faces, exactly; of others where their triangles bend</source>
        <translation>单击骨架的棱边：STEP 和 IGES 取其面的精确边，其他格式取三角形转折处</translation>
    </message>
    <message>
        <source>Looking for the edges of the frames …</source>
        <translation>正在查找骨架的棱边…</translation>
    </message>
    <message>
        <source>The frames have no edges: they are smooth everywhere, or are not read yet.</source>
        <translation>骨架没有棱边：处处平滑，或尚未读取。</translation>
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
        <translation>单击骨架的棱边，将其作为固定曲线——拖动旋转视图，Esc 结束工具</translation>
    </message>
    <message>
        <source>Click to make a fixation curve of this edge – Ctrl takes it alone, without those in which it goes on smoothly</source>
        <translation>单击将此棱边作为固定曲线——Ctrl 只取此边，不含与其平滑相接的边</translation>
    </message>
    <message>
        <source>There is no edge of a frame here. A curve of your own: Frame &gt; Draw fixation curve.</source>
        <translation>此处没有骨架的棱边。自行绘制曲线：骨架 &gt; 绘制固定曲线。</translation>
    </message>
</context>
<context>
    <name>FrameForm</name>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Choose an&amp;other file …</source>
        <translation>选择其他文件(&amp;O)…</translation>
    </message>
    <message>
        <source>Colour of the frame</source>
        <translation>骨架颜色</translation>
    </message>
</context>
<context>
    <name>FrameParts</name>
    <message>
        <source>Mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Piece %1: %2</source>
        <translation>块 %1：%2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n piece(s)</source>
        <translation>
            <numerusform>%1：%n 块</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>部件</translation>
    </message>
    <message>
        <source>Show a&amp;ll parts</source>
        <translation>显示所有部件(&amp;L)</translation>
    </message>
    <message>
        <source>Parts without a mark are left out: they are not drawn, and neither drawing along the frame nor cushioning nor contact knows them.</source>
        <translation>未勾选的部件被略去：不绘制，沿骨架绘图、软垫和接触也不考虑它们。</translation>
    </message>
    <message>
        <source>%1: not in this frame</source>
        <translation>%1：不在此骨架中</translation>
    </message>
    <message>
        <source>Padded parts</source>
        <translation>加垫部件</translation>
    </message>
    <message>
        <source>Without a mark, those parts are padded that the cover is fixed to.</source>
        <translation>都不勾选时，为固定面套的部件加垫。</translation>
    </message>
    <message>
        <source>This frame is large: the smallest detail can be %1 here.</source>
        <translation>此骨架较大：最小细节在此可为 %1。</translation>
    </message>
</context>
<context>
    <name>HandleCurveForm</name>
    <message>
        <source>Patch</source>
        <translation>样片</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>样板中</translation>
    </message>
    <message>
        <source>In space</source>
        <translation>空间中</translation>
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
        <translation>查找命令(&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse …</source>
        <translation>键盘与鼠标(&amp;K)…</translation>
    </message>
    <message>
        <source>&amp;Edit shortcuts …</source>
        <translation>编辑快捷键(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;About Bolster</source>
        <translation>关于 Bolster(&amp;A)</translation>
    </message>
</context>
<context>
    <name>HelpDialogs</name>
    <message>
        <source>Select</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>click; Shift+click adds; drag a box</source>
        <translation>单击；Shift+单击添加；拖出选框</translation>
    </message>
    <message>
        <source>Move control points or patches</source>
        <translation>移动控制点或样片</translation>
    </message>
    <message>
        <source>drag; Shift keeps to one axis; Esc takes it back</source>
        <translation>拖动；Shift 限于一个轴；Esc 还原</translation>
    </message>
    <message>
        <source>Turn patches</source>
        <translation>旋转样片</translation>
    </message>
    <message>
        <source>drag the round handle; Shift in steps of 15°</source>
        <translation>拖动圆形手柄；Shift 每次 15°</translation>
    </message>
    <message>
        <source>Add a control point</source>
        <translation>添加控制点</translation>
    </message>
    <message>
        <source>arrow keys, Shift+arrow keys</source>
        <translation>方向键、Shift+方向键</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>A workbench for people who design upholstered furniture and car seats: a sewing pattern, its seams and its fixation on the frame become the cover, live.</source>
        <translation>为软体家具和汽车座椅设计者打造的工作台：样板、接缝及在骨架上的固定，实时生成面套。</translation>
    </message>
    <message>
        <source>The surface is computed after the published method of sewing patterns on static constraints; docs/solver.md names the paper and what is different.</source>
        <translation>曲面按已发表的“静态约束下的缝纫样板”方法计算；docs/solver.md 列出论文及不同之处。</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. It comes without any warranty. Built with Qt, Eigen, CGAL, SuiteSparse, Embree and OpenImageIO.</source>
        <translation>自由软件，遵循 GNU General Public License 第 3 版或更高版本，不附带任何担保。使用 Qt、Eigen、CGAL、SuiteSparse、Embree 和 OpenImageIO 构建。</translation>
    </message>
    <message>
        <source>About Bolster</source>
        <translation>关于 Bolster</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>在样板中</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>在三维视图中</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>键盘与鼠标</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Patches, seams</source>
        <translation>样片、接缝</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Vertices after sewing</source>
        <translation>缝合后的顶点</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Vertices held by fixations</source>
        <translation>被固定的顶点</translation>
    </message>
    <message>
        <source>Sewn pairs</source>
        <translation>缝合的点对</translation>
    </message>
    <message>
        <source>Largest gap at seams</source>
        <translation>接缝处最大间隙</translation>
    </message>
    <message>
        <source>Largest distance from fixations</source>
        <translation>与固定的最大距离</translation>
    </message>
    <message>
        <source>Curves to fixed outlines between vertices</source>
        <translation>顶点间曲线到被固定轮廓</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1、%2、%3</translation>
    </message>
    <message>
        <source>Area of the cover, of the pattern</source>
        <translation>面套、样板的面积</translation>
    </message>
    <message>
        <source>Turned triangles</source>
        <translation>翻转的三角形</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>迭代次数</translation>
    </message>
    <message>
        <source>Triangulation</source>
        <translation>三角剖分</translation>
    </message>
    <message>
        <source>Assembly and factorisation</source>
        <translation>组装与分解</translation>
    </message>
    <message>
        <source>One iteration</source>
        <translation>单次迭代</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>曲面</translation>
    </message>
    <message>
        <source>Computation</source>
        <translation>计算</translation>
    </message>
    <message>
        <source>Figures of the surface</source>
        <translation>曲面数据</translation>
    </message>
    <message>
        <source>Strain: root mean square, 99 %, largest</source>
        <translation>应变：均方根、99%、最大</translation>
    </message>
    <message>
        <source>double click on an outline or curve</source>
        <translation>双击轮廓或曲线</translation>
    </message>
    <message>
        <source>Draw a handle curve or a fancy seam</source>
        <translation>绘制操控曲线或装饰缝</translation>
    </message>
    <message>
        <source>click points; Enter or double click ends; click the first one to close; B: straight or smooth</source>
        <translation>单击各点；Enter 或双击结束；单击第一点闭合；B：直线或平滑</translation>
    </message>
    <message>
        <source>Move control points of curves</source>
        <translation>移动曲线的控制点</translation>
    </message>
    <message>
        <source>Sew</source>
        <translation>缝合</translation>
    </message>
    <message>
        <source>click two edges; drag or Shift+click takes a part of one; Ctrl+click several in a row, Enter sews them; F: flip</source>
        <translation>单击两条边；拖动或 Shift+单击取其一部分；Ctrl+单击连续多条，Enter 缝合；F：翻转</translation>
    </message>
    <message>
        <source>Attach to the selected fixation curve</source>
        <translation>固定到所选固定曲线</translation>
    </message>
    <message>
        <source>Draw an outline</source>
        <translation>绘制轮廓</translation>
    </message>
    <message>
        <source>click corners, drag smooth points, or type 500, 500&lt;30 or 120, 40; Enter or a click on the first point closes</source>
        <translation>单击为角点，拖动为平滑点，或输入 500、500&lt;30 或 120, 40；Enter 或单击第一点闭合</translation>
    </message>
    <message>
        <source>Not snapped</source>
        <translation>不捕捉</translation>
    </message>
    <message>
        <source>hold Ctrl or Alt</source>
        <translation>按住 Ctrl 或 Alt</translation>
    </message>
    <message>
        <source>Select in a loop</source>
        <translation>套索选择</translation>
    </message>
    <message>
        <source>Alt and drag</source>
        <translation>Alt 加拖动</translation>
    </message>
    <message>
        <source>Next patch or control point, previous one</source>
        <translation>下一个、上一个样片或控制点</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab、Shift+Tab</translation>
    </message>
    <message>
        <source>drag; those on a frame stay on it: Ctrl lifts them off, S lets go; X, Y, Z keep to an axis</source>
        <translation>拖动；骨架上的点留在骨架上：Ctrl 抬离，S 脱离；X、Y、Z 限于一个轴</translation>
    </message>
    <message>
        <source>Draw a fixation curve</source>
        <translation>绘制固定曲线</translation>
    </message>
    <message>
        <source>click points on a frame; Enter or double click ends; click the first one to close</source>
        <translation>单击骨架上的点；Enter 或双击结束；单击第一点闭合</translation>
    </message>
    <message>
        <source>Move the ends of a seam or fixation</source>
        <translation>移动接缝或固定的端点</translation>
    </message>
    <message>
        <source>select it and drag the round handles at its ends</source>
        <translation>选中后拖动两端的圆形手柄</translation>
    </message>
    <message>
        <source>Stitch or pipe a seam or an edge</source>
        <translation>给接缝或边缘缉明线、加嵌线</translation>
    </message>
    <message>
        <source>click it; stitches and piping are in the properties</source>
        <translation>单击；明线和嵌线在属性中</translation>
    </message>
    <message>
        <source>Select an edge</source>
        <translation>选择边</translation>
    </message>
    <message>
        <source>click the outline; drag it then to move it; L types its length</source>
        <translation>单击轮廓；再拖动可移动；L 输入长度</translation>
    </message>
    <message>
        <source>Commands for what lies there</source>
        <translation>该处对象的命令</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>右键</translation>
    </message>
    <message>
        <source>A number instead of a drag</source>
        <translation>以输入数值代替拖动</translation>
    </message>
    <message>
        <source>type it while dragging: 50, 30, 20, for sizes 300 x 200 or 120 %; Enter lets go</source>
        <translation>拖动时输入：50 或 30, 20，尺寸用 300 x 200 或 120 %；Enter 确认</translation>
    </message>
    <message>
        <source>click edges; Shift+click collects several; Esc ends</source>
        <translation>单击边；Shift+单击收集多条；Esc 结束</translation>
    </message>
    <message>
        <source>right button, without a drag</source>
        <translation>右键，不拖动</translation>
    </message>
    <message>
        <source>Move by %1, by %2</source>
        <translation>移动 %1、%2</translation>
    </message>
    <message>
        <source>%1, or Space and drag</source>
        <translation>%1，或按住空格拖动</translation>
    </message>
    <message>
        <source>%1, or drag beside the cover</source>
        <translation>%1，或在面套旁拖动</translation>
    </message>
</context>
<context>
    <name>Insert</name>
    <message>
        <source>Padding</source>
        <translation>垫层</translation>
    </message>
    <message>
        <source>Foam</source>
        <translation>泡沫</translation>
    </message>
    <message>
        <source>This frame is large: its smallest detail is set to %1; the usual %2 would need too much memory.</source>
        <translation>此骨架较大：其最小细节设为 %1；通常的 %2 会占用过多内存。</translation>
    </message>
</context>
<context>
    <name>InsertCommands</name>
    <message>
        <source>&amp;Cushion</source>
        <translation>软垫(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Box of foam</source>
        <translation>长方体泡沫(&amp;B)</translation>
    </message>
    <message>
        <source>C&amp;ylinder of foam</source>
        <translation>圆柱体泡沫(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Sphere of foam</source>
        <translation>球体泡沫(&amp;S)</translation>
    </message>
    <message>
        <source>Foam belongs to a cushion: insert one first.</source>
        <translation>泡沫属于软垫：请先插入软垫。</translation>
    </message>
    <message>
        <source>Cushioning needs a frame: import one first.</source>
        <translation>软垫需要骨架：请先导入骨架。</translation>
    </message>
</context>
<context>
    <name>InspectorForms</name>
    <message numerus="yes">
        <source>%n elements</source>
        <translation>
            <numerusform>%n 个元素</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>InternalLineForm</name>
    <message>
        <source>Patch</source>
        <translation>样片</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
</context>
<context>
    <name>InverseCommands</name>
    <message>
        <source>From a form …</source>
        <translation>由形体生成…</translation>
    </message>
    <message>
        <source>Cuts a frame, a mesh or the cover into pieces, lays them flat and makes the pattern of them</source>
        <translation>将骨架、网格或面套切分、展平，并由此生成样板</translation>
    </message>
    <message>
        <source>F&amp;it to a goal …</source>
        <translation>拟合到目标(&amp;I)…</translation>
    </message>
    <message>
        <source>Changes the pattern until the cover lies on a scan, or is strained less</source>
        <translation>更改样板，直到面套贴合扫描或应变减小</translation>
    </message>
    <message>
        <source>Relieve strain …</source>
        <translation>释放应变…</translation>
    </message>
    <message>
        <source>Proposes changes of the pattern where cloth is strained too much, with what each gains</source>
        <translation>在面料应变过大处建议更改样板，并说明各项更改的效果</translation>
    </message>
    <message>
        <source>Why is it so? …</source>
        <translation>为何如此？…</translation>
    </message>
    <message>
        <source>Which cause explains best how far the scan of a built piece lies from the cover</source>
        <translation>哪个原因最能解释实物扫描与面套的距离</translation>
    </message>
    <message>
        <source>Tolerances …</source>
        <translation>公差…</translation>
    </message>
    <message>
        <source>Where the cover varies from piece to piece, and which tolerance of making matters</source>
        <translation>各件的面套在何处有差异，哪项制作公差影响大</translation>
    </message>
</context>
<context>
    <name>KeptMeasure</name>
    <message>
        <source>Measurement %1</source>
        <translation>测量 %1</translation>
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
        <translation>将标签拖到便于阅读之处——Shift 限于一个轴，Ctrl 不捕捉，Esc 还原</translation>
    </message>
</context>
<context>
    <name>LayerCommands</name>
    <message>
        <source>La&amp;yers</source>
        <translation>图层(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Triangulation</source>
        <translation>三角剖分(&amp;T)</translation>
    </message>
    <message>
        <source>Chec&amp;ker</source>
        <translation>棋盘格(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>骨架(&amp;F)</translation>
    </message>
    <message>
        <source>Control po&amp;ints</source>
        <translation>控制点(&amp;I)</translation>
    </message>
    <message>
        <source>Sea&amp;ms and fixations</source>
        <translation>接缝和固定(&amp;M)</translation>
    </message>
    <message>
        <source>Fixation c&amp;urves</source>
        <translation>固定曲线(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Handle curves</source>
        <translation>操控曲线(&amp;H)</translation>
    </message>
    <message>
        <source>Fanc&amp;y seams</source>
        <translation>装饰缝(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>标签(&amp;L)</translation>
    </message>
    <message>
        <source>Sca&amp;ns</source>
        <translation>扫描(&amp;N)</translation>
    </message>
    <message>
        <source>Gr&amp;ound</source>
        <translation>地面(&amp;O)</translation>
    </message>
    <message>
        <source>Cushionin&amp;g</source>
        <translation>软垫(&amp;G)</translation>
    </message>
    <message>
        <source>Mirror image of the &amp;selection</source>
        <translation>所选的镜像(&amp;S)</translation>
    </message>
    <message>
        <source>Symmetry &amp;axis and plane</source>
        <translation>对称轴和对称面(&amp;A)</translation>
    </message>
    <message>
        <source>Pairs of co&amp;ver and scan</source>
        <translation>面套与扫描的对应点对(&amp;V)</translation>
    </message>
    <message>
        <source>Own &amp;colours of scans</source>
        <translation>扫描自身的颜色(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>栅格(&amp;G)</translation>
    </message>
    <message>
        <source>Cut lines, notches and la&amp;bels</source>
        <translation>裁剪线、剪口和标签(&amp;B)</translation>
    </message>
    <message>
        <source>M&amp;easurements</source>
        <translation>测量(&amp;E)</translation>
    </message>
</context>
<context>
    <name>MainMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Pattern</source>
        <translation>样板(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Surface</source>
        <translation>曲面(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>窗口(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>插入(&amp;I)</translation>
    </message>
    <message>
        <source>Sea&amp;m</source>
        <translation>接缝(&amp;M)</translation>
    </message>
    <message>
        <source>F&amp;rame</source>
        <translation>骨架(&amp;R)</translation>
    </message>
    <message>
        <source>F&amp;abric</source>
        <translation>面料(&amp;A)</translation>
    </message>
    <message>
        <source>S&amp;can</source>
        <translation>扫描(&amp;C)</translation>
    </message>
</context>
<context>
    <name>ManualCommands</name>
    <message>
        <source>&amp;Manual</source>
        <translation>手册(&amp;M)</translation>
    </message>
    <message>
        <source>The page about what you are at</source>
        <translation>与当前操作有关的页面</translation>
    </message>
    <message>
        <source>The manual is not installed.</source>
        <translation>未安装手册。</translation>
    </message>
    <message>
        <source>It is a folder &quot;manual&quot; with the program&apos;s other files.</source>
        <translation>它是程序其他文件旁的“manual”文件夹。</translation>
    </message>
</context>
<context>
    <name>MapCommands</name>
    <message>
        <source>&amp;Map</source>
        <translation>云图(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Largest strain</source>
        <translation>最大应变(&amp;L)</translation>
    </message>
    <message>
        <source>Strain al&amp;ong the grain</source>
        <translation>沿布纹应变(&amp;O)</translation>
    </message>
    <message>
        <source>Strain a&amp;cross the grain</source>
        <translation>横布纹应变(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Shear</source>
        <translation>剪切(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Mean curvature</source>
        <translation>平均曲率(&amp;M)</translation>
    </message>
    <message>
        <source>Distance to the &amp;frame</source>
        <translation>到骨架的距离(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Deviation from the scan</source>
        <translation>与扫描的偏差(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Worst spots</source>
        <translation>最严重部位(&amp;W)</translation>
    </message>
    <message>
        <source>Show worst spots as a l&amp;ist</source>
        <translation>以列表显示最严重部位(&amp;I)</translation>
    </message>
    <message>
        <source>Show this place in both windows</source>
        <translation>在两个窗口中显示此处</translation>
    </message>
    <message>
        <source>Choose a map of strain first</source>
        <translation>请先选择应变云图</translation>
    </message>
</context>
<context>
    <name>MarkDrag</name>
    <message>
        <source>Drag it to where it belongs – Esc takes it back</source>
        <translation>将其拖到应在之处——Esc 还原</translation>
    </message>
    <message>
        <source>Allowance of %1 – or type it; Ctrl for any width, Esc takes it back</source>
        <translation>缝份 %1——也可输入；Ctrl 可取任意宽度，Esc 还原</translation>
    </message>
    <message>
        <source>Drag it to where it belongs, or type its place: 120, 40 – Esc takes it back</source>
        <translation>将其拖到应在之处，或输入位置：120, 40——Esc 还原</translation>
    </message>
    <message>
        <source>Drag it along the outline, or type how far it is from the corner – Esc takes it back</source>
        <translation>沿轮廓拖动，或输入到角点的距离——Esc 还原</translation>
    </message>
</context>
<context>
    <name>MeasureTool</name>
    <message>
        <source>dx %1, dy %2</source>
        <translation>dx %1，dy %2</translation>
    </message>
    <message>
        <source>This edge is %1 long – click for a point to measure from</source>
        <translation>此边长 %1——单击可从一点开始测量</translation>
    </message>
    <message>
        <source>Edge: %1</source>
        <translation>边：%1</translation>
    </message>
    <message>
        <source>Only a measurement between two points of patches can be kept.</source>
        <translation>只能保留样片上两点之间的测量。</translation>
    </message>
    <message>
        <source>&amp;Keep the measurement</source>
        <translation>保留测量(&amp;K)</translation>
    </message>
    <message>
        <source>%1 – Enter keeps the measurement, a click begins anew</source>
        <translation>%1——Enter 保留测量，单击重新开始</translation>
    </message>
    <message>
        <source>Click two points of the pattern or of the cover to measure, or point at an outline – Esc ends the tool</source>
        <translation>单击样板或面套上的两点进行测量，或指向轮廓——Esc 结束工具</translation>
    </message>
    <message>
        <source>%1 – a click begins anew</source>
        <translation>%1——单击重新开始</translation>
    </message>
</context>
<context>
    <name>MeasurementForm</name>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>样板中</translation>
    </message>
    <message>
        <source>two patches</source>
        <translation>两个样片</translation>
    </message>
    <message>
        <source>On the cover</source>
        <translation>在面套上</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>尚无</translation>
    </message>
</context>
<context>
    <name>Message</name>
    <message>
        <source>the degree must be 1, 2 or 3, not %1</source>
        <translation>次数必须是 1、2 或 3，而不是 %1</translation>
    </message>
    <message>
        <source>a closed curve needs at least %1 points, not %2</source>
        <translation>闭合曲线至少需要 %1 个点，而不是 %2 个</translation>
    </message>
    <message>
        <source>an open curve of this degree needs at least %1 points, not %2</source>
        <translation>此次数的开放曲线至少需要 %1 个点，而不是 %2 个</translation>
    </message>
    <message>
        <source>point %1 is no number or beyond 1e7 mm</source>
        <translation>点 %1 不是数字，或超出 1e7 mm</translation>
    </message>
    <message>
        <source>corners belong to closed curves of degree 3 only</source>
        <translation>角点仅用于 3 次闭合曲线</translation>
    </message>
    <message>
        <source>the list of corners is empty; leave it out</source>
        <translation>角点列表为空；请将其去掉</translation>
    </message>
    <message>
        <source>corner %1 does not exist; the points are numbered 0 to %2</source>
        <translation>角点 %1 不存在；点的编号为 0 到 %2</translation>
    </message>
    <message>
        <source>the corners must increase, but %1 follows %2</source>
        <translation>角点必须递增，但 %1 在 %2 之后</translation>
    </message>
    <message>
        <source>there must be at least two points between the corners %1 and %2 (a straight edge: at its thirds)</source>
        <translation>角点 %1 与 %2 之间至少要有两个点（直边：在其三等分处）</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text goes on after the design&apos;s last bracket; remove what follows</source>
        <translation>第 %1 行，第 %2 列：设计的最后一个括号后还有文本；请删除其后内容</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text ends in the middle of the design; the file is incomplete</source>
        <translation>第 %1 行，第 %2 列：文本在设计中途结束；文件不完整</translation>
    </message>
    <message>
        <source>Line %1, column %2: brackets are nested more than 64 deep; no design needs that</source>
        <translation>第 %1 行，第 %2 列：括号嵌套超过 64 层；设计不需要这么多</translation>
    </message>
    <message>
        <source>Line %1, column %2: a value is expected here: a number, a text in quotes, true, false or a bracket (NaN and Infinity are no numbers)</source>
        <translation>第 %1 行，第 %2 列：此处应为值：数字、带引号的文本、true、false 或括号（NaN 和 Infinity 不是数字）</translation>
    </message>
    <message>
        <source>Line %1, column %2: a comma or &quot;]&quot; is missing here</source>
        <translation>第 %1 行，第 %2 列：此处缺少逗号或“]”</translation>
    </message>
    <message>
        <source>Line %1, column %2: a key in quotes is expected here</source>
        <translation>第 %1 行，第 %2 列：此处应为带引号的键</translation>
    </message>
    <message>
        <source>Line %1, column %2: a colon is missing after the key</source>
        <translation>第 %1 行，第 %2 列：键后缺少冒号</translation>
    </message>
    <message>
        <source>Line %1, column %2: a comma or &quot;}&quot; is missing here</source>
        <translation>第 %1 行，第 %2 列：此处缺少逗号或“}”</translation>
    </message>
    <message>
        <source>Line %1, column %2: a text in quotes must end on its line; a quote is missing</source>
        <translation>第 %1 行，第 %2 列：带引号的文本必须在本行结束；缺少引号</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is no valid escape; write a backslash as &quot;\\&quot;</source>
        <translation>第 %1 行，第 %2 列：转义无效；反斜杠请写成“\\”</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is not UTF-8; save the file in that encoding</source>
        <translation>第 %1 行，第 %2 列：不是 UTF-8；请以该编码保存文件</translation>
    </message>
    <message>
        <source>Line %1, column %2: the text ends inside quotes; the file is incomplete</source>
        <translation>第 %1 行，第 %2 列：文本在引号内结束；文件不完整</translation>
    </message>
    <message>
        <source>Line %1, column %2: this is no number; write it like 12.5, -3 or 1e-3</source>
        <translation>第 %1 行，第 %2 列：不是数字；写法如 12.5、-3 或 1e-3</translation>
    </message>
    <message>
        <source>the text is larger than %1 MB; that is no design</source>
        <translation>文本超过 %1 MB；这不是设计</translation>
    </message>
    <message>
        <source>knot %1 occurs more often than %2 times, the degree; remove the surplus ones</source>
        <translation>节点 %1 出现超过 %2 次（即次数）；请删除多余的</translation>
    </message>
    <message>
        <source>the knots of an open curve must begin with %1 equal ones and end with %1 equal, larger ones</source>
        <translation>开放曲线的节点必须以 %1 个相等的节点开始，并以 %1 个相等且更大的节点结束</translation>
    </message>
    <message>
        <source>%1 points of degree %2 need %3 knots, not %4</source>
        <translation>%1 个 %2 次的点需要 %3 个节点，而不是 %4 个</translation>
    </message>
    <message>
        <source>a knot is no number or beyond 1e7</source>
        <translation>节点不是数字，或超出 1e7</translation>
    </message>
    <message>
        <source>the knots must not decrease</source>
        <translation>节点不得递减</translation>
    </message>
    <message>
        <source>the last knot must be larger than the first</source>
        <translation>最后一个节点必须大于第一个</translation>
    </message>
    <message>
        <source>two knots near %1 are almost equal; make them equal</source>
        <translation>%1 附近有两个节点几乎相等；请使其相等</translation>
    </message>
    <message>
        <source>there is not enough memory for this design</source>
        <translation>内存不足，无法处理此设计</translation>
    </message>
    <message>
        <source>%1: the file promises more than it holds</source>
        <translation>%1：文件实际内容少于其声明</translation>
    </message>
    <message>
        <source>%1: the mesh is too large, the limit is %2 points and as many triangles</source>
        <translation>%1：网格过大，上限为 %2 个点和同样多的三角形</translation>
    </message>
    <message>
        <source>%1: the point is not finite, or beyond 10,000,000</source>
        <translation>%1：点不是有限值，或超出 10,000,000</translation>
    </message>
    <message>
        <source>%1: a face refers to point %2, but there are %3 points</source>
        <translation>%1：有面引用点 %2，但只有 %3 个点</translation>
    </message>
    <message>
        <source>%1: the mesh has too many groups, the limit is %2</source>
        <translation>%1：网格的组过多，上限为 %2</translation>
    </message>
    <message>
        <source>%1 holds no mesh</source>
        <translation>%1 不含网格</translation>
    </message>
    <message>
        <source>%1 holds points only; a frame needs faces between them</source>
        <translation>%1 只含点；骨架需要点之间的面</translation>
    </message>
    <message>
        <source>%1: points are counted from 1, not from 0</source>
        <translation>%1：点从 1 开始计数，而不是 0</translation>
    </message>
    <message>
        <source>%1: the file ends too early</source>
        <translation>%1：文件提前结束</translation>
    </message>
    <message>
        <source>%1: the file does not begin with OFF</source>
        <translation>%1：文件不以 OFF 开头</translation>
    </message>
    <message>
        <source>%1: binary OFF is not read; save it as text</source>
        <translation>%1：不读取二进制 OFF；请保存为文本</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PLY number type</source>
        <translation>%1：“%2”不是 PLY 数字类型</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PLY format</source>
        <translation>%1：“%2”不是 PLY 格式</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; cannot count a list</source>
        <translation>%1：“%2”不能用作列表计数</translation>
    </message>
    <message>
        <source>%1: the file does not begin with &quot;ply&quot;</source>
        <translation>%1：文件不以“ply”开头</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not expected in a PLY header</source>
        <translation>%1：PLY 文件头中不应有“%2”</translation>
    </message>
    <message>
        <source>%1: a count is negative</source>
        <translation>%1：计数为负</translation>
    </message>
    <message>
        <source>%1: the points have no coordinate &quot;%2&quot;</source>
        <translation>%1：点缺少坐标“%2”</translation>
    </message>
    <message>
        <source>%1: the faces have no list &quot;%2&quot;</source>
        <translation>%1：面缺少列表“%2”</translation>
    </message>
    <message>
        <source>%1: a number is missing</source>
        <translation>%1：缺少一个数字</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a number</source>
        <translation>%1：“%2”不是数字</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a whole number</source>
        <translation>%1：“%2”不是整数</translation>
    </message>
    <message>
        <source>unsaved work cannot be protected: &quot;%1&quot; cannot be written</source>
        <translation>无法保护未保存的工作：无法写入“%1”</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot;</source>
        <translation>文件“%1”不存在</translation>
    </message>
    <message>
        <source>you are not allowed to read &quot;%1&quot;</source>
        <translation>您无权读取“%1”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a folder, not a file</source>
        <translation>“%1”是文件夹，不是文件</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an ordinary file</source>
        <translation>“%1”不是普通文件</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read (%2)</source>
        <translation>无法读取“%1”（%2）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: the disk is full; make room or choose another folder</source>
        <translation>无法写入“%1”：磁盘已满；请腾出空间或选择其他文件夹</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: you are not allowed to write into &quot;%2&quot;; choose another folder</source>
        <translation>无法写入“%1”：您无权写入“%2”；请选择其他文件夹</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: there is no folder &quot;%2&quot;</source>
        <translation>无法写入“%1”：文件夹“%2”不存在</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is a folder</source>
        <translation>无法写入“%1”：它是文件夹</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written (%2)</source>
        <translation>无法写入“%1”（%2）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too large: %2 MB, and at most %3 MB are read</source>
        <translation>“%1”过大：%2 MB，最多读取 %3 MB</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is write-protected</source>
        <translation>无法写入“%1”：它有写保护</translation>
    </message>
    <message>
        <source>The equations of the cover could not be solved: a patch is degenerate or its numbers are too large.</source>
        <translation>面套方程无法求解：有样片退化，或其数值过大。</translation>
    </message>
    <message>
        <source>this seam and its neighbours carry their ends round in a circle without ever meeting. Let the seams of this circle end at common points.</source>
        <translation>此接缝与相邻接缝的端点首尾循环，从不相接。请使这一圈接缝终止于公共点。</translation>
    </message>
    <message>
        <source>the corners of the two stretches lie too close together to be matched. Move them apart or choose a smaller edge length.</source>
        <translation>两个区段的角点过近，无法对应。请将其移开，或选择更小的边长。</translation>
    </message>
    <message>
        <source>%1 and %2 hold the same point of the cover in two places, %3 mm apart. Let both curves meet there, or end one stretch earlier.</source>
        <translation>%1 和 %2 将面套的同一点固定在两处，相距 %3 mm。请使两曲线在此相接，或提前结束一个区段。</translation>
    </message>
    <message>
        <source>the patch is too narrow somewhere for edges of %1 mm. Choose a smaller edge length.</source>
        <translation>样片有处过窄，容不下 %1 mm 的边。请选择更小的边长。</translation>
    </message>
    <message>
        <source>The design cannot be solved: %2</source>
        <translation>设计无法求解：%2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>There is no patch to solve. Add a patch to the pattern.</source>
        <translation>没有可求解的样片。请向样板添加样片。</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by an estimated %2 mm. Allow more iterations.</source>
        <translation>%1 次迭代后，曲面估计仍移动 %2 mm。请允许更多迭代。</translation>
    </message>
    <message>
        <source>Remove %1 points</source>
        <translation>删除 %1 个点</translation>
    </message>
    <message>
        <source>Move %1 points</source>
        <translation>移动 %1 个点</translation>
    </message>
    <message>
        <source>another element has the number %1 already; give this one a number of its own</source>
        <translation>另一元素已有编号 %1；请为此元素另设编号</translation>
    </message>
    <message>
        <source>this is no Bolster design; it must say &quot;format&quot;: &quot;bolster-design&quot;</source>
        <translation>这不是 Bolster 设计；其中必须有 &quot;format&quot;: &quot;bolster-design&quot;</translation>
    </message>
    <message>
        <source>the design was made by a newer Bolster (version %1 of the format, this program knows %2); update the program</source>
        <translation>设计由较新的 Bolster 创建（格式版本 %1，本程序支持 %2）；请更新程序</translation>
    </message>
    <message>
        <source>must be %1</source>
        <translation>必须是 %1</translation>
    </message>
    <message>
        <source>must be &quot;mm&quot;; convert the design to millimetres</source>
        <translation>必须是 &quot;mm&quot;；请将设计换算为毫米</translation>
    </message>
    <message>
        <source>must be a list of elements in square brackets</source>
        <translation>必须是方括号中的元素列表</translation>
    </message>
    <message>
        <source>must be a list of points in square brackets</source>
        <translation>必须是方括号中的点列表</translation>
    </message>
    <message>
        <source>must be a list of numbers in square brackets</source>
        <translation>必须是方括号中的数字列表</translation>
    </message>
    <message>
        <source>the list is empty; leave it out</source>
        <translation>列表为空；请将其去掉</translation>
    </message>
    <message>
        <source>must be a curve in braces, with degree, closed and points</source>
        <translation>必须是花括号中的曲线，含 degree、closed 和 points</translation>
    </message>
    <message>
        <source>a curve has either corners or knots; remove one of them</source>
        <translation>曲线只能有 corners 或 knots 之一；请删除其中一个</translation>
    </message>
    <message>
        <source>an outline must be closed; write true</source>
        <translation>轮廓必须闭合；请写 true</translation>
    </message>
    <message>
        <source>must be a stretch in braces, with patch, from and to</source>
        <translation>必须是花括号中的区段，含 patch、from 和 to</translation>
    </message>
    <message>
        <source>must be a quaternion [w, x, y, z] of length 1, not of length %1</source>
        <translation>必须是长度为 1 的四元数 [w, x, y, z]，而不是长度 %1</translation>
    </message>
    <message>
        <source>must be an object in braces</source>
        <translation>必须是花括号中的对象</translation>
    </message>
    <message>
        <source>an element must be an object in braces</source>
        <translation>元素必须是花括号中的对象</translation>
    </message>
    <message>
        <source>must be true or false, without quotes</source>
        <translation>必须是 true 或 false，不带引号</translation>
    </message>
    <message>
        <source>must be a text in quotes</source>
        <translation>必须是带引号的文本</translation>
    </message>
    <message>
        <source>and %1 more problems of this element</source>
        <translation>此元素还有 %1 个问题</translation>
    </message>
    <message>
        <source>must be a number, without quotes</source>
        <translation>必须是数字，不带引号</translation>
    </message>
    <message>
        <source>must be a whole number from %1 to %2</source>
        <translation>必须是 %1 到 %2 的整数</translation>
    </message>
    <message>
        <source>must be a list of %1 numbers in square brackets</source>
        <translation>必须是方括号中 %1 个数字的列表</translation>
    </message>
    <message>
        <source>this key occurs twice; remove one of them</source>
        <translation>此键出现两次；请删除其中一个</translation>
    </message>
    <message>
        <source>this key is missing; add it</source>
        <translation>缺少此键；请添加</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>必须是 %1 之一</translation>
    </message>
    <message>
        <source>this key is unknown; check its spelling or remove it</source>
        <translation>未知的键；请检查拼写或将其删除</translation>
    </message>
    <message>
        <source>Move a point of %1</source>
        <translation>移动 %1 的一个点</translation>
    </message>
    <message>
        <source>Move %2 points of %1</source>
        <translation>移动 %1 的 %2 个点</translation>
    </message>
    <message>
        <source>Insert a point into %1</source>
        <translation>在 %1 中插入点</translation>
    </message>
    <message>
        <source>Remove a point of %1</source>
        <translation>删除 %1 的一个点</translation>
    </message>
    <message>
        <source>Change the settings</source>
        <translation>更改设置</translation>
    </message>
    <message>
        <source>Add fabric %1</source>
        <translation>添加面料 %1</translation>
    </message>
    <message>
        <source>Add patch %1</source>
        <translation>添加样片 %1</translation>
    </message>
    <message>
        <source>Add a seam</source>
        <translation>添加接缝</translation>
    </message>
    <message>
        <source>Add fixation curve %1</source>
        <translation>添加固定曲线 %1</translation>
    </message>
    <message>
        <source>Add a fixation seam</source>
        <translation>添加固定</translation>
    </message>
    <message>
        <source>Add frame %1</source>
        <translation>添加骨架 %1</translation>
    </message>
    <message>
        <source>Add an unreadable element</source>
        <translation>添加无法读取的元素</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>将 %1 重命名为 %2</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>删除 %1</translation>
    </message>
    <message>
        <source>Remove %1 elements</source>
        <translation>删除 %1 个元素</translation>
    </message>
    <message>
        <source>Move %1 patches</source>
        <translation>移动 %1 个样片</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>Turn %1 patches</source>
        <translation>旋转 %1 个样片</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>旋转 %1</translation>
    </message>
    <message>
        <source>There is not enough memory for this surface. Choose a larger edge length.</source>
        <translation>内存不足，无法处理此曲面。请选择更大的边长。</translation>
    </message>
    <message>
        <source>The solver failed: %1. The last good surface is kept.</source>
        <translation>求解失败：%1。保留上一个有效曲面。</translation>
    </message>
    <message>
        <source>Change the colour of %1</source>
        <translation>更改 %1 的颜色</translation>
    </message>
    <message>
        <source>Change the stiffness of %1</source>
        <translation>更改 %1 的刚度</translation>
    </message>
    <message>
        <source>Change the Poisson parameter of %1</source>
        <translation>更改 %1 的泊松比</translation>
    </message>
    <message>
        <source>Change the bending length of %1</source>
        <translation>更改 %1 的弯曲长度</translation>
    </message>
    <message>
        <source>Change the fabric of %1</source>
        <translation>更改 %1 的面料</translation>
    </message>
    <message>
        <source>Change the grain of %1</source>
        <translation>更改 %1 的布纹</translation>
    </message>
    <message>
        <source>Change the pressure of %1</source>
        <translation>更改 %1 的压力</translation>
    </message>
    <message>
        <source>Change the right side of %1</source>
        <translation>更改 %1 的正面</translation>
    </message>
    <message>
        <source>Move %1 in the layout</source>
        <translation>在布局中移动 %1</translation>
    </message>
    <message>
        <source>Turn %1 in the layout</source>
        <translation>在布局中旋转 %1</translation>
    </message>
    <message>
        <source>Change the continuity of %1</source>
        <translation>更改 %1 的连续性</translation>
    </message>
    <message>
        <source>Change how %1 is matched</source>
        <translation>更改 %1 的对应</translation>
    </message>
    <message>
        <source>Reverse %1</source>
        <translation>反转 %1</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>缩放 %1</translation>
    </message>
    <message>
        <source>The surface still moves after %1 iterations.</source>
        <translation>%1 次迭代后曲面仍在移动。</translation>
    </message>
    <message>
        <source>this is no name of a file</source>
        <translation>这不是文件名</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be relative to the design&apos;s folder and use &quot;/&quot; between folders</source>
        <translation>“%1”必须相对于设计的文件夹，文件夹之间用“/”</translation>
    </message>
    <message>
        <source>left out because of its errors</source>
        <translation>因其错误而略去</translation>
    </message>
    <message>
        <source>left out because it needs %1, which is not there</source>
        <translation>因缺少所需的 %1 而略去</translation>
    </message>
    <message>
        <source>an edge length of %1 mm is used instead</source>
        <translation>改用边长 %1 mm</translation>
    </message>
    <message>
        <source>the file is not a design</source>
        <translation>该文件不是设计</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written</source>
        <translation>无法写入“%1”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be copied to &quot;%2&quot;: %3</source>
        <translation>无法将“%1”复制到“%2”：%3</translation>
    </message>
    <message>
        <source>the folder &quot;%1&quot; could not be made</source>
        <translation>无法创建文件夹“%1”</translation>
    </message>
    <message>
        <source>the patch is free in space: nothing fixes it to the frame; add a fixation</source>
        <translation>样片悬空：没有任何东西将其固定到骨架；请添加固定</translation>
    </message>
    <message>
        <source>this patch and the %1 sewn to it are free in space: nothing fixes them to the frame; add a fixation</source>
        <translation>此样片及与其缝合的 %1 个悬空：没有任何东西将其固定到骨架；请添加固定</translation>
    </message>
    <message>
        <source>is %1, but must lie between %2 and %3</source>
        <translation>为 %1，但必须介于 %2 与 %3 之间</translation>
    </message>
    <message>
        <source>there is no element %1; name a %2</source>
        <translation>元素 %1 不存在；请指定一个%2</translation>
    </message>
    <message>
        <source>element %1 cannot be read; repair it or name another %2</source>
        <translation>无法读取元素 %1；请修复，或指定另一个%2</translation>
    </message>
    <message>
        <source>%1 is no %2; name another element</source>
        <translation>%1 不是%2；请指定其他元素</translation>
    </message>
    <message>
        <source>%1 mm would make more than 5 million triangles; take at least %2 mm for these patches</source>
        <translation>%1 mm 会产生超过 500 万个三角形；这些样片至少取 %2 mm</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no colour; write it like #7a4a2b</source>
        <translation>“%1”不是颜色；写法如 #7a4a2b</translation>
    </message>
    <message>
        <source>the mesh cannot resolve folds as small as a bending length of %1 mm makes them: with edges of %2 mm it acts like %3 mm; take an edge length of at most %4 mm, or a longer bending length</source>
        <translation>网格无法分辨弯曲长度 %1 mm 所产生的细小褶皱：边长 %2 mm 时效果等同 %3 mm；请取不超过 %4 mm 的边长，或更大的弯曲长度</translation>
    </message>
    <message>
        <source>an outline must be a closed curve</source>
        <translation>轮廓必须是闭合曲线</translation>
    </message>
    <message>
        <source>the outline needs at least three points in different places</source>
        <translation>轮廓至少需要三个位置不同的点</translation>
    </message>
    <message>
        <source>all points of the outline lie on one line, it encloses no area; move one of them</source>
        <translation>轮廓的所有点共线，不围成面积；请移动其中一点</translation>
    </message>
    <message>
        <source>the outline crosses or touches itself near %1; move its points apart there</source>
        <translation>轮廓在 %1 附近与自身相交或相触；请将该处的点移开</translation>
    </message>
    <message>
        <source>the outline encloses no area</source>
        <translation>轮廓不围成面积</translation>
    </message>
    <message>
        <source>%1 is the end of the curve; write %2, its start</source>
        <translation>%1 是曲线的终点；请写其起点 %2</translation>
    </message>
    <message>
        <source>is %1, but must be larger than the start of the stretch, %2</source>
        <translation>为 %1，但必须大于区段的起点 %2</translation>
    </message>
    <message>
        <source>the stretch from %1 to %2 is empty or longer than the curve</source>
        <translation>从 %1 到 %2 的区段为空，或比曲线长</translation>
    </message>
    <message>
        <source>the stretch from %1 to %2 has no length; the outline&apos;s points coincide there</source>
        <translation>从 %1 到 %2 的区段没有长度；轮廓的点在此重合</translation>
    </message>
    <message>
        <source>the seam would sew a stretch of &quot;%1&quot; to itself: %2 to %3 and %4 to %5 overlap; choose two separate stretches</source>
        <translation>接缝会将“%1”的区段与自身缝合：%2 到 %3 与 %4 到 %5 重叠；请选择两个分开的区段</translation>
    </message>
    <message>
        <source>the seam joins the right side of &quot;%1&quot; to the wrong side of &quot;%2&quot;; turn &quot;reversed&quot; round, or one patch wrong side out</source>
        <translation>接缝将“%1”的正面与“%2”的反面相连；请翻转“reversed”，或使其中一个样片反面朝外</translation>
    </message>
    <message>
        <source>the sides of the seam are %1 mm (&quot;%2&quot;) and %3 mm (&quot;%4&quot;) long: %5 % ease, more than 5 % puckers; make them equal or check the ends of the stretches</source>
        <translation>接缝两侧长 %1 mm（“%2”）和 %3 mm（“%4”）：吃势 %5%，超过 5% 会起皱；请使其等长，或检查区段端点</translation>
    </message>
    <message>
        <source>the curve has no length; move its points apart</source>
        <translation>曲线没有长度；请将其点移开</translation>
    </message>
    <message>
        <source>the curve from %1 to %2 has no length</source>
        <translation>曲线从 %1 到 %2 没有长度</translation>
    </message>
    <message>
        <source>is %1, but must be positive: millimetres per unit of the file</source>
        <translation>为 %1，但必须为正：文件每单位的毫米数</translation>
    </message>
    <message>
        <source>a design has at most %1 elements</source>
        <translation>设计最多有 %1 个元素</translation>
    </message>
    <message>
        <source>a curve has at most %1 points</source>
        <translation>曲线最多有 %1 个点</translation>
    </message>
    <message>
        <source>the usual values of a fabric are used instead</source>
        <translation>改用面料的常用值</translation>
    </message>
    <message>
        <source>Remove %1 and what is sewn to it</source>
        <translation>删除 %1 及与其缝合的内容</translation>
    </message>
    <message>
        <source>Remove %1 and %2 seams and fixations</source>
        <translation>删除 %1 及 %2 个接缝和固定</translation>
    </message>
    <message>
        <source>is %1, but must be a positive length of at most %2; 12 mm is usual</source>
        <translation>为 %1，但必须是不超过 %2 的正长度；通常为 12 mm</translation>
    </message>
    <message>
        <source>no mesh can resolve folds as small as a bending length of %1 mm makes them: with edges of %2 mm it acts like %3 mm; take a longer bending length</source>
        <translation>任何网格都无法分辨弯曲长度 %1 mm 所产生的细小褶皱：边长 %2 mm 时效果等同 %3 mm；请取更大的弯曲长度</translation>
    </message>
    <message>
        <source>it sews what %1 sews already; remove one of them</source>
        <translation>它缝合的内容 %1 已缝合；请删除其中一条</translation>
    </message>
    <message>
        <source>it sews the same stretches as %1, but the other way round: each would be folded onto itself; remove one of the two</source>
        <translation>它与 %1 缝合相同的区段，但方向相反：各区段会折到自身上；请删除其中一条</translation>
    </message>
    <message>
        <source>&quot;%1&quot; goes up with &quot;..&quot;; write the way from the design&apos;s folder without it, or copy the file there</source>
        <translation>“%1”用“..”返回上级；请从设计的文件夹起写路径而不用它，或将文件复制到该处</translation>
    </message>
    <message>
        <source>the number %1 is too large or too small; stay within %2</source>
        <translation>数字 %1 过大或过小；请保持在 %2 以内</translation>
    </message>
    <message>
        <source>the text is UTF-16; save it as UTF-8</source>
        <translation>文本为 UTF-16；请保存为 UTF-8</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by %2 mm in each: it does not come to rest. Lower the pressure, or make curves as long as the outlines they hold.</source>
        <translation>%1 次迭代后，曲面每次仍移动 %2 mm：无法静止。请降低压力，或使曲线与其固定的轮廓等长。</translation>
    </message>
    <message>
        <source>%1 of %2 triangles of the cover lie upside down. Look for cloth pressed into too little room, or a bending length that is long for its patch.</source>
        <translation>面套的 %2 个三角形中有 %1 个翻面。请查找空间过小处的布料，或相对样片过大的弯曲长度。</translation>
    </message>
    <message>
        <source>there is either a normal or a tangent; remove one of them</source>
        <translation>只能有法线或切线之一；请删除其中一个</translation>
    </message>
    <message>
        <source>there are %1 directions, but at most %2 are possible</source>
        <translation>有 %1 个方向，但最多允许 %2 个</translation>
    </message>
    <message>
        <source>a direction must be three numbers that are not all 0</source>
        <translation>方向必须是三个不全为 0 的数字</translation>
    </message>
    <message>
        <source>direction %1 is opposite to the one before, so that it is not known on which way to turn; add one between them</source>
        <translation>方向 %1 与前一个相反，无法确定转向；请在两者之间添加一个</translation>
    </message>
    <message>
        <source>there is no curve; name one, or leave out curve_from and curve_to</source>
        <translation>没有曲线；请指定一条，或去掉 curve_from 和 curve_to</translation>
    </message>
    <message>
        <source>Change the normal held by %1</source>
        <translation>更改 %1 保持的法线</translation>
    </message>
    <message>
        <source>must be a text in quotation marks</source>
        <translation>必须是引号中的文本</translation>
    </message>
    <message>
        <source>the curve in the patch and its target must both be open or both be closed</source>
        <translation>样片中的曲线与其目标必须同为开放或同为闭合</translation>
    </message>
    <message>
        <source>Add handle curve %1</source>
        <translation>添加操控曲线 %1</translation>
    </message>
    <message>
        <source>Add fancy seam %1</source>
        <translation>添加装饰缝 %1</translation>
    </message>
    <message>
        <source>Add cushion %1</source>
        <translation>添加软垫 %1</translation>
    </message>
    <message>
        <source>Add foam %1</source>
        <translation>添加泡沫 %1</translation>
    </message>
    <message>
        <source>a width of %1 mm is too narrow for edges of %2 mm; make it at least %3 mm wide, or choose a smaller edge length</source>
        <translation>宽度 %1 mm 对 %2 mm 的边过窄；请至少取 %3 mm，或选择更小的边长</translation>
    </message>
    <message>
        <source>it lies outside its patch; move its points inside the outline</source>
        <translation>它位于样片之外；请将其点移到轮廓内</translation>
    </message>
    <message>
        <source>it leaves the patch and comes back; keep it inside, or end it at the outline</source>
        <translation>它离开样片又返回；请使其留在内部，或终止于轮廓</translation>
    </message>
    <message>
        <source>it runs too flat into the outline near %1; let it meet the outline more steeply, or end it before</source>
        <translation>它在 %1 附近与轮廓夹角过小；请使其更陡地相接，或提前结束</translation>
    </message>
    <message>
        <source>it bends too sharply for a width of %1 mm near %2; make it narrower, or bend it less there</source>
        <translation>在 %2 附近，对宽度 %1 mm 而言弯曲过急；请改窄，或减小该处弯曲</translation>
    </message>
    <message>
        <source>a cushion takes at most %1 bodies of foam; this one is left out</source>
        <translation>一个软垫最多容纳 %1 个泡沫体；此泡沫体被略去</translation>
    </message>
    <message>
        <source>the frame has no part &quot;%1&quot;; it has %2</source>
        <translation>骨架没有部件“%1”；它有 %2</translation>
    </message>
    <message>
        <source>it is only %1 mm long; draw it at least %2 mm long, or choose a smaller edge length</source>
        <translation>它仅长 %1 mm；请至少画 %2 mm，或选择更小的边长</translation>
    </message>
    <message>
        <source>it reaches beyond its patch near %1; move its points inside the outline</source>
        <translation>它在 %1 附近超出样片；请将其点移到轮廓内</translation>
    </message>
    <message>
        <source>it comes closer than %1 mm to the outline near %2; keep away from it, or choose a smaller edge length</source>
        <translation>它在 %2 附近距轮廓不足 %1 mm；请保持距离，或选择更小的边长</translation>
    </message>
    <message>
        <source>it crosses %1, or comes closer to it than %2 mm, near %3; move them apart, or choose a smaller edge length</source>
        <translation>它在 %3 附近与 %1 相交，或相距不足 %2 mm；请将两者移开，或选择更小的边长</translation>
    </message>
    <message>
        <source>it crosses itself, or comes closer to itself than %1 mm, near %2; move its points apart, or choose a smaller edge length</source>
        <translation>它在 %2 附近与自身相交，或相距不足 %1 mm；请将其点移开，或选择更小的边长</translation>
    </message>
    <message>
        <source>the patch cannot be triangulated along it with edges of %1 mm. Choose a smaller edge length.</source>
        <translation>边长为 %1 mm 时，样片无法沿其剖分三角形。请选择更小的边长。</translation>
    </message>
    <message>
        <source>Change the frame of %1</source>
        <translation>更改 %1 的骨架</translation>
    </message>
    <message>
        <source>Change what %1 pushes</source>
        <translation>更改 %1 的推压对象</translation>
    </message>
    <message>
        <source>Switch %1</source>
        <translation>切换 %1</translation>
    </message>
    <message>
        <source>Change the parts of %1</source>
        <translation>更改 %1 的部件</translation>
    </message>
    <message>
        <source>Change the padding of %1</source>
        <translation>更改 %1 的垫层</translation>
    </message>
    <message>
        <source>Change the strength of %1</source>
        <translation>更改 %1 的强度</translation>
    </message>
    <message>
        <source>Change the distance of %1</source>
        <translation>更改 %1 的距离</translation>
    </message>
    <message>
        <source>Change the voxels of %1</source>
        <translation>更改 %1 的体素</translation>
    </message>
    <message>
        <source>Change the cushion of %1</source>
        <translation>更改 %1 的软垫</translation>
    </message>
    <message>
        <source>Change the shape of %1</source>
        <translation>更改 %1 的形状</translation>
    </message>
    <message>
        <source>Change the size of %1</source>
        <translation>更改 %1 的尺寸</translation>
    </message>
    <message>
        <source>Add or cut %1</source>
        <translation>添加或挖除 %1</translation>
    </message>
    <message>
        <source>Change the contact of %1</source>
        <translation>更改 %1 的接触</translation>
    </message>
    <message>
        <source>Change the gap of %1</source>
        <translation>更改 %1 的间隙</translation>
    </message>
    <message>
        <source>Change the width of %1</source>
        <translation>更改 %1 的宽度</translation>
    </message>
    <message>
        <source>Change the depth of %1</source>
        <translation>更改 %1 的深度</translation>
    </message>
    <message>
        <source>Change the profile of %1</source>
        <translation>更改 %1 的断面</translation>
    </message>
    <message>
        <source>Move points of %1 curves</source>
        <translation>移动 %1 条曲线的点</translation>
    </message>
    <message>
        <source>Rename a file</source>
        <translation>重命名文件</translation>
    </message>
    <message>
        <source>Change the file of %1</source>
        <translation>更改 %1 的文件</translation>
    </message>
    <message>
        <source>the file is missing</source>
        <translation>文件缺失</translation>
    </message>
    <message>
        <source>it is a file that this design refers to; choose another name</source>
        <translation>此设计引用了该文件；请另选名称</translation>
    </message>
    <message>
        <source>There is no cover to place the scan on.</source>
        <translation>没有可供对齐扫描的面套。</translation>
    </message>
    <message>
        <source>must be a list of at most %1 planes, [x, y, z, distance] each</source>
        <translation>必须是最多 %1 个平面的列表，各为 [x, y, z, 距离]</translation>
    </message>
    <message>
        <source>must be a list of at most %1 cuts in braces</source>
        <translation>必须是花括号中最多 %1 个裁切的列表</translation>
    </message>
    <message>
        <source>must be a cut in braces, with planes</source>
        <translation>必须是花括号中的裁切，含 planes</translation>
    </message>
    <message>
        <source>the first three numbers are the plane&apos;s normal; not all of them may be 0</source>
        <translation>前三个数字是平面法线，不能全为 0</translation>
    </message>
    <message>
        <source>no file is named; write the name of a file beside the design</source>
        <translation>未指定文件；请写出设计旁边的文件名</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no file in the design&apos;s folder; copy the file into that folder and name it here</source>
        <translation>“%1”不是设计文件夹中的文件；请将文件复制到该文件夹并在此指定</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot; in the design&apos;s folder; copy the file there or choose another one</source>
        <translation>设计文件夹中没有文件“%1”；请将其复制到该处或另选一个</translation>
    </message>
    <message>
        <source>with this scale and position the points reach beyond 10,000,000 mm</source>
        <translation>按此比例和位置，点会超出 10,000,000 mm</translation>
    </message>
    <message>
        <source>Add scan %1</source>
        <translation>添加扫描 %1</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>裁切 %1</translation>
    </message>
    <message>
        <source>Show all of %1</source>
        <translation>显示 %1 的全部</translation>
    </message>
    <message>
        <source>Cut the floor off %1</source>
        <translation>从 %1 裁掉地面</translation>
    </message>
    <message>
        <source>%1 holds no points</source>
        <translation>%1 不含点</translation>
    </message>
    <message>
        <source>%1: the scan is too large, the limit is %2 points</source>
        <translation>%1：扫描过大，上限为 %2 个点</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not expected in a PCD header</source>
        <translation>%1：PCD 文件头中不应有“%2”</translation>
    </message>
    <message>
        <source>%1: the compressed points are damaged</source>
        <translation>%1：压缩的点已损坏</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a PCD format</source>
        <translation>%1：“%2”不是 PCD 格式</translation>
    </message>
    <message>
        <source>the cuts leave nothing of the scan; remove one of them</source>
        <translation>裁切后扫描不剩任何内容；请删除其中一个裁切</translation>
    </message>
    <message>
        <source>Change the threshold of %1</source>
        <translation>更改 %1 的阈值</translation>
    </message>
    <message>
        <source>Change how %1 pulls</source>
        <translation>更改 %1 的拉力方式</translation>
    </message>
    <message>
        <source>Release points of twins</source>
        <translation>使镜像件的点脱离</translation>
    </message>
    <message>
        <source>Re-link points of twins</source>
        <translation>重新关联镜像件的点</translation>
    </message>
    <message>
        <source>Make the design symmetric</source>
        <translation>使设计对称</translation>
    </message>
    <message>
        <source>These two cannot be twins.</source>
        <translation>这两者不能互为镜像件。</translation>
    </message>
    <message>
        <source>Make corners</source>
        <translation>设为角点</translation>
    </message>
    <message>
        <source>Make curves smooth</source>
        <translation>使曲线平滑</translation>
    </message>
    <message>
        <source>element %1 cannot be its twin: that must be another %2 which is nobody else&apos;s; until then it has none</source>
        <translation>元素 %1 不能作其镜像件：必须是另一个未被占用的%2；在此之前它没有镜像件</translation>
    </message>
    <message>
        <source>there is no point %1</source>
        <translation>没有点 %1</translation>
    </message>
    <message>
        <source>its points and knots are not those of %1; the next edit of one of them makes it the mirror image</source>
        <translation>其点和节点与 %1 的不符；下次编辑其中之一时将使之成为镜像</translation>
    </message>
    <message>
        <source>%1 of its points are no mirror images of those of %2; release them, or move them</source>
        <translation>其 %1 个点不是 %2 对应点的镜像；请使其脱离，或移动它们</translation>
    </message>
    <message>
        <source>the plane needs a normal that is not 0, and numbers within 1e7; x = 0 is used instead</source>
        <translation>平面需要不为 0 的法线和 1e7 以内的数字；改用 x = 0</translation>
    </message>
    <message>
        <source>the axis needs a direction that is not 0, and numbers within 1e7; x = 0 is used instead</source>
        <translation>轴需要不为 0 的方向和 1e7 以内的数字；改用 x = 0</translation>
    </message>
    <message>
        <source>The clipboard holds no parts of a design.</source>
        <translation>剪贴板中没有设计的内容。</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>粘贴 %1</translation>
    </message>
    <message>
        <source>Paste %1 pieces</source>
        <translation>粘贴 %1 个对象</translation>
    </message>
    <message>
        <source>The clipboard holds no patches and no fixation curves.</source>
        <translation>剪贴板中没有样片和固定曲线。</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>创建 %1 的副本</translation>
    </message>
    <message>
        <source>Duplicate %1 pieces</source>
        <translation>创建 %1 个对象的副本</translation>
    </message>
    <message>
        <source>Make a corner in %1</source>
        <translation>在 %1 中设角点</translation>
    </message>
    <message>
        <source>Make %1 smooth</source>
        <translation>使 %1 平滑</translation>
    </message>
    <message>
        <source>Straighten a stretch of %1</source>
        <translation>拉直 %1 的区段</translation>
    </message>
    <message>
        <source>Attach %1 to %2</source>
        <translation>将 %1 固定到 %2</translation>
    </message>
    <message>
        <source>There is no such stretch of an outline.</source>
        <translation>轮廓上没有这样的区段。</translation>
    </message>
    <message>
        <source>The stretch has no length.</source>
        <translation>该区段没有长度。</translation>
    </message>
    <message>
        <source>A part of this stretch is fixed to %1 already: remove that fixation or choose another stretch.</source>
        <translation>此区段的一部分已固定到 %1：请删除该固定，或选择其他区段。</translation>
    </message>
    <message>
        <source>Create fixation curve %1</source>
        <translation>创建固定曲线 %1</translation>
    </message>
    <message>
        <source>Attach %1 stretches to %2</source>
        <translation>将 %1 个区段固定到 %2</translation>
    </message>
    <message>
        <source>Attach %1 to %2 curves</source>
        <translation>将 %1 固定到 %2 条曲线</translation>
    </message>
    <message>
        <source>Align %1 patches</source>
        <translation>对齐 %1 个样片</translation>
    </message>
    <message>
        <source>Distribute %1 patches</source>
        <translation>分布 %1 个样片</translation>
    </message>
    <message>
        <source>Arrange %1 patches</source>
        <translation>排列 %1 个样片</translation>
    </message>
    <message>
        <source>Make %1 and %2 twins</source>
        <translation>使 %1 与 %2 互为镜像件</translation>
    </message>
    <message>
        <source>They are no mirror images: they differ by %1 mm. Twins must be alike; make a mirror twin of one of them instead.</source>
        <translation>它们不是镜像：相差 %1 mm。镜像件必须一致；请改为创建其中一个的镜像件。</translation>
    </message>
    <message>
        <source>Make a mirror twin of %1</source>
        <translation>创建 %1 的镜像件</translation>
    </message>
    <message>
        <source>Make %1 mirror twins</source>
        <translation>创建 %1 个镜像件</translation>
    </message>
    <message>
        <source>A patch of the seam is missing or invalid: repair it first.</source>
        <translation>接缝的样片缺失或无效：请先修复。</translation>
    </message>
    <message>
        <source>The seam joins %1 to itself: there is nothing to merge.</source>
        <translation>接缝连接 %1 自身：没有可合并的内容。</translation>
    </message>
    <message>
        <source>The seam takes up a whole outline: nothing would be left.</source>
        <translation>接缝占满整个轮廓：不会有任何剩余。</translation>
    </message>
    <message>
        <source>The seam joins the right side of %1 to the wrong side of %2: one patch cannot be both.</source>
        <translation>接缝将 %1 的正面与 %2 的反面相连：一个样片不能兼为两者。</translation>
    </message>
    <message>
        <source>The sides of the seam differ by %1 % in length, more than 5 %.</source>
        <translation>接缝两侧的长度相差 %1%，超过 5%。</translation>
    </message>
    <message>
        <source>Select the seam along which to merge.</source>
        <translation>请选择要沿其合并的接缝。</translation>
    </message>
    <message>
        <source>Merged, %1 and %2 would overlap or cross: the seam stays.</source>
        <translation>合并后 %1 与 %2 会重叠或相交：保留接缝。</translation>
    </message>
    <message>
        <source>Merge %1 and %2</source>
        <translation>合并 %1 与 %2</translation>
    </message>
    <message>
        <source>Scale %1 patches</source>
        <translation>缩放 %1 个样片</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>镜像 %1</translation>
    </message>
    <message>
        <source>Mirror %1 patches</source>
        <translation>镜像 %1 个样片</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>分割 %1</translation>
    </message>
    <message>
        <source>The line must cross the outline of %1 exactly twice, not %2 times.</source>
        <translation>线必须与 %1 的轮廓恰好相交两次，而不是 %2 次。</translation>
    </message>
    <message>
        <source>Draw a line over a patch to split it.</source>
        <translation>请画一条越过样片的线来分割它。</translation>
    </message>
    <message>
        <source>The outline of %1 is invalid: repair it first.</source>
        <translation>%1 的轮廓无效：请先修复。</translation>
    </message>
    <message>
        <source>The line must run inside %1.</source>
        <translation>线必须在 %1 内部。</translation>
    </message>
    <message>
        <source>A piece of %1 would cross itself or be too narrow: draw another line.</source>
        <translation>%1 的一块会与自身相交或过窄：请另画一条线。</translation>
    </message>
    <message>
        <source>Sew %1 to %2</source>
        <translation>将 %1 与 %2 缝合</translation>
    </message>
    <message>
        <source>Sew %1 to %2 stretches in a row</source>
        <translation>将 %1 与连续 %2 个区段缝合</translation>
    </message>
    <message>
        <source>Flip %1</source>
        <translation>翻转 %1</translation>
    </message>
    <message>
        <source>Flip %1 seams</source>
        <translation>翻转 %1 条接缝</translation>
    </message>
    <message>
        <source>Swap the sides of %1</source>
        <translation>交换 %1 的两侧</translation>
    </message>
    <message>
        <source>Swap the sides of %1 seams</source>
        <translation>交换 %1 条接缝的两侧</translation>
    </message>
    <message>
        <source>Change the continuity of %1 seams</source>
        <translation>更改 %1 条接缝的连续性</translation>
    </message>
    <message>
        <source>Change how %1 seams are matched</source>
        <translation>更改 %1 条接缝的对应</translation>
    </message>
    <message>
        <source>This stretch has no length: choose two different points.</source>
        <translation>此区段没有长度：请选择两个不同的点。</translation>
    </message>
    <message>
        <source>Move an end of %1</source>
        <translation>移动 %1 的端点</translation>
    </message>
    <message>
        <source>%1 is already sewn to %2 here: remove that seam first, or take a free stretch.</source>
        <translation>%1 在此已与 %2 缝合：请先删除该接缝，或选空闲区段。</translation>
    </message>
    <message>
        <source>A stretch cannot be sewn to itself: choose two that have no part in common.</source>
        <translation>区段不能与自身缝合：请选择两个不重叠的区段。</translation>
    </message>
    <message>
        <source>Unlink %1 and %2</source>
        <translation>解除 %1 与 %2 的关联</translation>
    </message>
    <message>
        <source>Unlink %1 pairs of twins</source>
        <translation>解除 %1 对镜像件的关联</translation>
    </message>
    <message>
        <source>Release a point of %1</source>
        <translation>使 %1 的一个点脱离</translation>
    </message>
    <message>
        <source>Release %2 points of %1</source>
        <translation>使 %1 的 %2 个点脱离</translation>
    </message>
    <message>
        <source>Re-link a point of %1</source>
        <translation>重新关联 %1 的一个点</translation>
    </message>
    <message>
        <source>Re-link %2 points of %1</source>
        <translation>重新关联 %1 的 %2 个点</translation>
    </message>
    <message>
        <source>Change the curve of %1</source>
        <translation>更改 %1 的曲线</translation>
    </message>
    <message>
        <source>The outline of %1 would cross or touch itself.</source>
        <translation>%1 的轮廓会与自身相交或相触。</translation>
    </message>
    <message>
        <source>The outline of %1 would enclose nothing.</source>
        <translation>%1 的轮廓会不围成面积。</translation>
    </message>
    <message>
        <source>%1 would not lie inside %2 any more.</source>
        <translation>%1 将不再位于 %2 之内。</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that is fixed to %2.</source>
        <translation>该区段会与 %1 固定到 %2 的另一区段重叠。</translation>
    </message>
    <message>
        <source>The stretch would overlap the seam of %1 and %2.</source>
        <translation>该区段会与 %1 和 %2 的接缝重叠。</translation>
    </message>
    <message>
        <source>The two sides of the seam would overlap.</source>
        <translation>接缝的两侧会重叠。</translation>
    </message>
    <message>
        <source>Change the length of a stretch of %1</source>
        <translation>更改 %1 的区段长度</translation>
    </message>
    <message>
        <source>Move an end of a fixation of %1</source>
        <translation>移动 %1 的固定端点</translation>
    </message>
    <message>
        <source>Re-link a seam to its mirror image</source>
        <translation>将接缝重新关联到其镜像</translation>
    </message>
    <message>
        <source>Release a seam from its mirror image</source>
        <translation>使接缝脱离其镜像</translation>
    </message>
    <message>
        <source>another element had the same number; give this one a number of its own</source>
        <translation>另一元素有相同编号；请为此元素另设编号</translation>
    </message>
    <message>
        <source>Take %1 elements from another version</source>
        <translation>从另一版本采用 %1 个元素</translation>
    </message>
    <message>
        <source>Take %1 from another version</source>
        <translation>从另一版本采用 %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: it is not an ordinary file</source>
        <translation>无法写入“%1”：它不是普通文件</translation>
    </message>
    <message>
        <source>a file that the design uses cannot be read (%1)</source>
        <translation>无法读取设计所用的文件（%1）</translation>
    </message>
    <message>
        <source>a file of the project cannot be written out (%1)</source>
        <translation>无法写出项目中的文件（%1）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be opened or made</source>
        <translation>无法打开或创建“%1”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is in use by another program</source>
        <translation>“%1”正被其他程序使用</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged (%2)</source>
        <translation>“%1”已损坏（%2）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read or written (%2)</source>
        <translation>无法读取或写入“%1”（%2）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is closed</source>
        <translation>“%1”已关闭</translation>
    </message>
    <message>
        <source>%1 cannot be stored: it holds a number that is none, or text in an unknown encoding</source>
        <translation>无法存储 %1：其中有无效数字，或编码未知的文本</translation>
    </message>
    <message>
        <source>there is a file &quot;%1&quot; already</source>
        <translation>文件“%1”已存在</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no Bolster project</source>
        <translation>“%1”不是 Bolster 项目</translation>
    </message>
    <message>
        <source>there is not enough memory for this project</source>
        <translation>内存不足，无法处理此项目</translation>
    </message>
    <message>
        <source>an edit of the project cannot be read any more</source>
        <translation>项目的一步编辑已无法读取</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no name for a file of a project</source>
        <translation>“%1”不能作为项目文件的名称</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was made by a newer Bolster (version %2 of the format, this program knows %3); update the program</source>
        <translation>“%1”由较新的 Bolster 创建（格式版本 %2，本程序支持 %3）；请更新程序</translation>
    </message>
    <message>
        <source>&quot;%1&quot; says that it has version %2 of the format, which never was</source>
        <translation>“%1”声明格式版本为 %2，该版本从未存在</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the journal of a running program, or of one that crashed, not a project file</source>
        <translation>“%1”是正在运行或已崩溃程序的日志，不是项目文件</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: it is %2 bytes long and should have %3</source>
        <translation>“%1”已损坏：长度为 %2 字节，应为 %3</translation>
    </message>
    <message>
        <source>a temporary folder cannot be made (%1)</source>
        <translation>无法创建临时文件夹（%1）</translation>
    </message>
    <message>
        <source>a temporary file cannot be made (%1)</source>
        <translation>无法创建临时文件（%1）</translation>
    </message>
    <message>
        <source>nothing in &quot;%1&quot; can be saved</source>
        <translation>“%1”中没有可恢复的内容</translation>
    </message>
    <message>
        <source>%1 versions were saved</source>
        <translation>恢复了 %1 个版本</translation>
    </message>
    <message>
        <source>lost: versions %1 to %2</source>
        <translation>丢失：版本 %1 到 %2</translation>
    </message>
    <message>
        <source>Saved version</source>
        <translation>恢复的版本</translation>
    </message>
    <message>
        <source>version %1 was saved without the edits before it</source>
        <translation>版本 %1 已恢复，但不含其之前的编辑</translation>
    </message>
    <message>
        <source>lost: the names of %1 versions</source>
        <translation>丢失：%1 个版本的名称</translation>
    </message>
    <message>
        <source>lost: the file &quot;%1&quot;</source>
        <translation>丢失：文件“%1”</translation>
    </message>
    <message>
        <source>the tables of &quot;%1&quot; are not those of a Bolster project</source>
        <translation>“%1”的表不是 Bolster 项目的表</translation>
    </message>
    <message>
        <source>a checksum is incomplete</source>
        <translation>校验和不完整</translation>
    </message>
    <message>
        <source>another window has it</source>
        <translation>已在另一窗口中打开</translation>
    </message>
    <message>
        <source>must be a list of pairs in braces, with patch and fabric</source>
        <translation>必须是花括号中成对项的列表，含 patch 和 fabric</translation>
    </message>
    <message>
        <source>must be a pair in braces, with patch and fabric</source>
        <translation>必须是花括号中的成对项，含 patch 和 fabric</translation>
    </message>
    <message>
        <source>there is no colourway %1; the patches show their own fabrics</source>
        <translation>没有配色 %1；样片显示自身的面料</translation>
    </message>
    <message>
        <source>%1 has a fabric in this colourway already; remove one of the two</source>
        <translation>%1 在此配色中已有面料；请删除其中一个</translation>
    </message>
    <message>
        <source>what it says of missing patches and fabrics is left out</source>
        <translation>其中关于缺失样片和面料的内容被略去</translation>
    </message>
    <message>
        <source>Make %1 of %2</source>
        <translation>将 %1 改用 %2</translation>
    </message>
    <message>
        <source>Make %1 patches of %2</source>
        <translation>将 %1 个样片改用 %2</translation>
    </message>
    <message>
        <source>Add colourway %1</source>
        <translation>添加配色 %1</translation>
    </message>
    <message>
        <source>Change what %1 shows</source>
        <translation>更改 %1 的显示</translation>
    </message>
    <message>
        <source>Change what %1 patches show</source>
        <translation>更改 %1 个样片的显示</translation>
    </message>
    <message>
        <source>Show no colourway</source>
        <translation>不显示配色</translation>
    </message>
    <message>
        <source>Show colourway %1</source>
        <translation>显示配色 %1</translation>
    </message>
    <message>
        <source>A stretch of %1 that is sewn, fixed or trimmed would have no length.</source>
        <translation>%1 的一个已缝合、固定或带饰边的区段会没有长度。</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that has a trim.</source>
        <translation>该区段会与 %1 的另一带饰边的区段重叠。</translation>
    </message>
    <message>
        <source>Add a trim</source>
        <translation>添加饰边</translation>
    </message>
    <message>
        <source>Move an end of a trim of %1</source>
        <translation>移动 %1 的饰边端点</translation>
    </message>
    <message>
        <source>Change the trim of %1 seams</source>
        <translation>更改 %1 条接缝的饰边</translation>
    </message>
    <message>
        <source>Change the trim of %1</source>
        <translation>更改 %1 的饰边</translation>
    </message>
    <message>
        <source>A part of this stretch of %1 has a trim already: change that one, or choose another stretch.</source>
        <translation>%1 的此区段有一部分已有饰边：请更改该饰边，或选择其他区段。</translation>
    </message>
    <message>
        <source>Trim the edge of %1</source>
        <translation>为 %1 的边加饰边</translation>
    </message>
    <message>
        <source>%1: the file cannot be read any further; it has changed, or its disk is gone</source>
        <translation>%1：文件无法继续读取；它已更改，或其磁盘已不在</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a picture that can be read; PNG, JPEG, TIFF and OpenEXR can</source>
        <translation>“%1”不是可读取的图片；可读取 PNG、JPEG、TIFF 和 OpenEXR</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 by %3 pixels, and at most 64 million are read; make the picture smaller in a picture editor</source>
        <translation>“%1”为 %2 × %3 像素，最多读取 6400 万像素；请在图片编辑器中缩小</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a kind of picture whose colours cannot be read; save it as PNG in a picture editor</source>
        <translation>“%1”这类图片的颜色无法读取；请在图片编辑器中保存为 PNG</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged or incomplete; copy it again from where it came from, or save it again in a picture editor</source>
        <translation>“%1”已损坏或不完整；请从来源重新复制，或在图片编辑器中重新保存</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which reads pictures for Bolster, cannot be started; install Bolster again</source>
        <translation>为 Bolster 读取图片的程序“%1”无法启动；请重新安装 Bolster</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes too long to read; save it as PNG in a picture editor</source>
        <translation>读取“%1”耗时过长；请在图片编辑器中保存为 PNG</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be decoded: it is damaged or incomplete, or needs too much memory; save it again as PNG in a picture editor</source>
        <translation>无法解码“%1”：已损坏或不完整，或占用内存过多；请在图片编辑器中重新保存为 PNG</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this picture</source>
        <translation>%1：内存不足，无法处理此图片</translation>
    </message>
    <message>
        <source>%1: there is not enough memory for this file</source>
        <translation>%1：内存不足，无法处理此文件</translation>
    </message>
    <message>
        <source>%1: the line is too long</source>
        <translation>%1：行过长</translation>
    </message>
    <message>
        <source>both have a file &quot;%1&quot;, and they are different: save under another name</source>
        <translation>两者都有文件“%1”且内容不同：请以其他名称保存</translation>
    </message>
    <message>
        <source>there is another project in the file now</source>
        <translation>文件中现在是另一个项目</translation>
    </message>
    <message>
        <source>the last edits are not on the disk yet</source>
        <translation>最后的编辑尚未写入磁盘</translation>
    </message>
    <message>
        <source>Change the stitching of %1</source>
        <translation>更改 %1 的明线</translation>
    </message>
    <message>
        <source>Change the piping of %1</source>
        <translation>更改 %1 的嵌线</translation>
    </message>
    <message>
        <source>Change the seam allowance of %1</source>
        <translation>更改 %1 的缝份</translation>
    </message>
    <message>
        <source>Change the valley of %1</source>
        <translation>更改 %1 的凹陷</translation>
    </message>
    <message>
        <source>there is no fabric in &quot;%1&quot;</source>
        <translation>“%1”中没有面料</translation>
    </message>
    <message>
        <source>the design uses &quot;%1&quot; itself; choose another name</source>
        <translation>设计本身使用“%1”；请另选名称</translation>
    </message>
    <message>
        <source>there is not enough memory to show this fabric</source>
        <translation>内存不足，无法显示此面料</translation>
    </message>
    <message>
        <source>Replace fabric %1 by %2</source>
        <translation>将面料 %1 替换为 %2</translation>
    </message>
    <message>
        <source>Change the limits of %1</source>
        <translation>更改 %1 的极限</translation>
    </message>
    <message>
        <source>Change the look of %1</source>
        <translation>更改 %1 的外观</translation>
    </message>
    <message>
        <source>Change the second colour of %1</source>
        <translation>更改 %1 的第二颜色</translation>
    </message>
    <message>
        <source>Change the kind of %1</source>
        <translation>更改 %1 的种类</translation>
    </message>
    <message>
        <source>there is no place for the files of this project</source>
        <translation>没有存放此项目文件的位置</translation>
    </message>
    <message>
        <source>A side of this seam does not end at corners: its length cannot be changed alone.</source>
        <translation>此接缝的一侧不终止于角点：其长度无法单独更改。</translation>
    </message>
    <message>
        <source>These edges cannot have this length: they hang together.</source>
        <translation>这些边不能取此长度：它们相互关联。</translation>
    </message>
    <message>
        <source>Change the length of an edge of %1</source>
        <translation>更改 %1 的边长度</translation>
    </message>
    <message>
        <source>Change the length of %1 edges</source>
        <translation>更改 %1 条边的长度</translation>
    </message>
    <message>
        <source>Make %1 edges equally long</source>
        <translation>使 %1 条边等长</translation>
    </message>
    <message>
        <source>Make the sides of a seam equally long</source>
        <translation>使接缝两侧等长</translation>
    </message>
    <message>
        <source>Make the sides of %1 seams equally long</source>
        <translation>使 %1 条接缝的两侧等长</translation>
    </message>
    <message>
        <source>There is a &quot;%1&quot; already: this one is called &quot;%2&quot;.</source>
        <translation>已有“%1”：此项命名为“%2”。</translation>
    </message>
    <message>
        <source>Change the size of %1 patches</source>
        <translation>更改 %1 个样片的尺寸</translation>
    </message>
    <message>
        <source>%1: the rows hold more than the header of the file says; what is too much in each was left out</source>
        <translation>%1：各行内容多于文件头的声明；每行多余部分已略去</translation>
    </message>
    <message>
        <source>this changes more at once than can be stored: at most %1 MB, and %2 keys; do it in parts</source>
        <translation>一次更改的内容超出可存储范围：最多 %1 MB 和 %2 个键；请分次进行</translation>
    </message>
    <message>
        <source>&quot;%1&quot; unpacks to more than any project; it was not made by Bolster, or is damaged</source>
        <translation>“%1”解压后大于任何项目；它不是由 Bolster 创建，或已损坏</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which recovers projects for Bolster, cannot be started; install Bolster again</source>
        <translation>为 Bolster 恢复项目的程序“%1”无法启动；请重新安装 Bolster</translation>
    </message>
    <message>
        <source>nothing in &quot;%1&quot; can be saved: it is damaged in a way that takes too much time or memory</source>
        <translation>“%1”中没有可恢复的内容：其损坏方式使恢复耗费过多时间或内存</translation>
    </message>
    <message>
        <source>lost: the table &quot;%1&quot;, which is missing or has other columns than it should</source>
        <translation>丢失：表“%1”，它缺失或列不正确</translation>
    </message>
    <message>
        <source>lost: %1 more such gaps</source>
        <translation>丢失：另有 %1 处此类缺口</translation>
    </message>
    <message>
        <source>what comes after version %1 takes too long to recover</source>
        <translation>版本 %1 之后的内容恢复耗时过长</translation>
    </message>
    <message>
        <source>the edit of version %1 does not lead to the design that was kept with it</source>
        <translation>版本 %1 的编辑得不到与其一同保存的设计</translation>
    </message>
    <message>
        <source>it pushes nothing: no part of the frame lies under the cover</source>
        <translation>它不推压任何东西：面套下没有骨架部件</translation>
    </message>
    <message>
        <source>contact looks at the frame in steps of %1 mm; something of these parts is thinner, so that the cover may pass through: %2; make it thicker</source>
        <translation>接触以 %1 mm 为步长考察骨架；这些部件有更薄之处，面套可能穿过：%2；请加厚</translation>
    </message>
    <message>
        <source>contact does nothing: in steps of %1 mm it finds no inside of the frame, which is thinner than that, or so open that it has none; close the frame, or make it thicker</source>
        <translation>接触不起作用：以 %1 mm 为步长找不到骨架内部，骨架更薄，或过于敞开而没有内部；请封闭骨架，或加厚</translation>
    </message>
    <message>
        <source>%1 lies in folds: there is more cloth than room for it</source>
        <translation>%1 有褶皱：布料多于可容空间</translation>
    </message>
    <message>
        <source>%1 floats free: nothing holds it, and it is sewn to nothing that is held</source>
        <translation>%1 悬空：没有固定，也未与任何被固定的部分缝合</translation>
    </message>
    <message>
        <source>%1 holds the cloth %2 mm off the frame</source>
        <translation>%1 使布料离骨架 %2 mm</translation>
    </message>
    <message>
        <source>The seam of %1 and %2 has %3 % ease: it puckers above %4 %</source>
        <translation>%1 与 %2 的接缝有 %3% 吃势：超过 %4% 会起皱</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations.</source>
        <translation>%1 次迭代后曲面发散。</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations: %2 holds it %3 mm from everything else. Bring that curve nearer.</source>
        <translation>%1 次迭代后曲面发散：%2 使其距其他一切 %3 mm。请将该曲线移近。</translation>
    </message>
    <message>
        <source>The equations of the cover could not be solved: %1 is degenerate or its numbers are too large. Check its outline and its fabric.</source>
        <translation>面套方程无法求解：%1 退化，或其数值过大。请检查其轮廓和面料。</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations: the pressure of %2 (%3) is too high for its fabric. Lower it.</source>
        <translation>%1 次迭代后曲面发散：%2 的压力（%3）对其面料过高。请降低。</translation>
    </message>
    <message>
        <source>The surface ran away after %1 iterations, most likely because of %2. Check the size of that patch, its pressure and its fabric.</source>
        <translation>%1 次迭代后曲面发散，很可能因为 %2。请检查该样片的尺寸、压力和面料。</translation>
    </message>
    <message>
        <source>Change the material of %1</source>
        <translation>更改 %1 的材料</translation>
    </message>
    <message>
        <source>Show a part of %1</source>
        <translation>显示 %1 的部件</translation>
    </message>
    <message>
        <source>Hide a part of %1</source>
        <translation>隐藏 %1 的部件</translation>
    </message>
    <message>
        <source>Show all parts of %1</source>
        <translation>显示 %1 的所有部件</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a link to &quot;%2&quot; now</source>
        <translation>“%1”现在是指向“%2”的链接</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was changed by another program</source>
        <translation>“%1”已被其他程序更改</translation>
    </message>
    <message>
        <source>somebody else has changed &quot;%1&quot; since it was opened here</source>
        <translation>自在此打开后，他人更改了“%1”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is another project now</source>
        <translation>“%1”现在是另一个项目</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be renamed (%2)</source>
        <translation>无法重命名“%1”（%2）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: the content number %2 cannot be read</source>
        <translation>“%1”已损坏：无法读取第 %2 项内容</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: a row holds something of another kind than it should</source>
        <translation>“%1”已损坏：某行内容的类型不正确</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: row %2 of the table &quot;%3&quot; contradicts others</source>
        <translation>“%1”已损坏：表“%3”的第 %2 行与其他行矛盾</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: parts of the file are not what was written</source>
        <translation>“%1”已损坏：文件的部分内容与写入时不符</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: rows are missing, or there are some too many</source>
        <translation>“%1”已损坏：缺少行，或行过多</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: the edits up to number %2 do not lead to the design that was stored with them</source>
        <translation>“%1”已损坏：截至第 %2 步的编辑得不到与其一同存储的设计</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged: row %2 of the table &quot;%3&quot; is not what was written</source>
        <translation>“%1”已损坏：表“%3”的第 %2 行与写入时不符</translation>
    </message>
    <message>
        <source>there is no picture to write</source>
        <translation>没有可写入的图片</translation>
    </message>
    <message>
        <source>%1: a face has %2 corners, and at most %3 are read; have it split into triangles by the program that has made the file</source>
        <translation>%1：有面具有 %2 个角，最多读取 %3 个；请在生成该文件的程序中将其分为三角形</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written: no file can be made in &quot;%2&quot;; choose another folder</source>
        <translation>无法写入“%1”：无法在“%2”中创建文件；请选择其他文件夹</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>已中断</translation>
    </message>
    <message>
        <source>at most %1 cushions push; this one and those after it are left out</source>
        <translation>最多 %1 个软垫推压；此软垫及其后的被略去</translation>
    </message>
    <message>
        <source>the picture cannot be encoded (%1)</source>
        <translation>无法编码图片（%1）</translation>
    </message>
    <message>
        <source>a smallest detail of %1 mm is too fine for a frame as large as this (%2 million cubes of it, and %3 are the limit), so the cushion is left out; take at least %4 mm</source>
        <translation>最小细节 %1 mm 对这么大的骨架过细（需 %2 百万个立方体，上限为 %3），因此略去软垫；请至少取 %4 mm</translation>
    </message>
    <message>
        <source>something of these parts of the frame is thinner than the smallest detail of the padding, %1 mm, so that it may have gaps there: %2; take a smaller detail</source>
        <translation>骨架的这些部件有比垫层最小细节 %1 mm 更薄之处，垫层在此可能有空缺：%2；请取更小的细节</translation>
    </message>
    <message>
        <source>it pushes nothing: with a smallest detail of %1 mm there is no inside of the frame, which is thinner than that, or so open that it has none; take a smaller detail, or close the frame</source>
        <translation>它不推压任何东西：最小细节为 %1 mm 时骨架没有内部，骨架更薄，或过于敞开而没有内部；请取更小的细节，或封闭骨架</translation>
    </message>
    <message>
        <source>Change the slanted faces of %1</source>
        <translation>更改 %1 的斜面</translation>
    </message>
    <message>
        <source>Change the smallest detail of %1</source>
        <translation>更改 %1 的最小细节</translation>
    </message>
    <message>
        <source>the log of &quot;%1&quot; is damaged: the last edits cannot be read</source>
        <translation>“%1”的日志已损坏：无法读取最后的编辑</translation>
    </message>
    <message>
        <source>the kind %1 is unknown; there are %2 and %3</source>
        <translation>种类 %1 未知；可用 %2 和 %3</translation>
    </message>
    <message>
        <source>its label finds no room: make the words shorter, or put it elsewhere</source>
        <translation>其标签放不下：请缩短文字，或放在别处</translation>
    </message>
    <message>
        <source>its cut lines meet here: make the allowance smaller</source>
        <translation>其裁剪线在此相遇：请减小缝份</translation>
    </message>
    <message>
        <source>a notch of %1 mm reaches the sewing line, which is %2 mm away: make it shallower, or the allowance wider</source>
        <translation>%1 mm 的剪口到达相距 %2 mm 的缝合线：请减小剪口深度，或加宽缝份</translation>
    </message>
    <message>
        <source>nothing is sewn where it is, so it has no partner</source>
        <translation>其所在处没有缝合，因此没有对应剪口</translation>
    </message>
    <message>
        <source>it has no partner on the other side of its seam: another notch is too near there</source>
        <translation>接缝另一侧没有对应剪口：那里另一剪口过近</translation>
    </message>
    <message>
        <source>it is %1 mm wide across the grain, but &quot;%2&quot; only %3 mm: split it, or turn its grain</source>
        <translation>它横布纹宽 %1 mm，而“%2”只有 %3 mm：请分割，或旋转布纹</translation>
    </message>
    <message>
        <source>an inner corner of %1 degrees is too sharp for its seam allowances: make them smaller there, or the corner wider</source>
        <translation>%1 度的内角对其缝份过尖：请减小该处缝份，或增大内角</translation>
    </message>
    <message>
        <source>There is no such place on an outline.</source>
        <translation>轮廓上没有这样的位置。</translation>
    </message>
    <message>
        <source>A part of this stretch of %1 has a seam allowance of its own already: change that one, or choose another stretch.</source>
        <translation>%1 的此区段有一部分已有自己的缝份：请更改该缝份，或选择其他区段。</translation>
    </message>
    <message>
        <source>There is a notch of %1 at this place already.</source>
        <translation>%1 在此位置已有剪口。</translation>
    </message>
    <message>
        <source>This corner of %1 has a join of its own already.</source>
        <translation>%1 的此角已有自己的处理方式。</translation>
    </message>
    <message>
        <source>Change the seam allowance of %1 patches</source>
        <translation>更改 %1 个样片的缝份</translation>
    </message>
    <message>
        <source>Change the seam allowance of an edge of %1</source>
        <translation>更改 %1 的边的缝份</translation>
    </message>
    <message>
        <source>Change a corner of the cut line of %1</source>
        <translation>更改 %1 的裁剪线角</translation>
    </message>
    <message>
        <source>Add a notch to %1</source>
        <translation>在 %1 上添加剪口</translation>
    </message>
    <message>
        <source>Move a notch</source>
        <translation>移动剪口</translation>
    </message>
    <message>
        <source>Move the join of a corner</source>
        <translation>移动裁剪线角</translation>
    </message>
    <message>
        <source>A drill hole must lie inside its patch.</source>
        <translation>钻孔必须位于样片之内。</translation>
    </message>
    <message>
        <source>Move %1 drill holes</source>
        <translation>移动 %1 个钻孔</translation>
    </message>
    <message>
        <source>Move the label of %1</source>
        <translation>移动 %1 的标签</translation>
    </message>
    <message>
        <source>The stretch would overlap another one of %1 that has its own seam allowance.</source>
        <translation>该区段会与 %1 的另一有自己缝份的区段重叠。</translation>
    </message>
    <message>
        <source>Give an edge its own seam allowance</source>
        <translation>为边设定自己的缝份</translation>
    </message>
    <message>
        <source>Change a corner of the cut line</source>
        <translation>更改裁剪线角</translation>
    </message>
    <message>
        <source>Add drill hole %1</source>
        <translation>添加钻孔 %1</translation>
    </message>
    <message>
        <source>Change the diameter of %1</source>
        <translation>更改 %1 的直径</translation>
    </message>
    <message>
        <source>Change the notches of %1</source>
        <translation>更改 %1 的剪口</translation>
    </message>
    <message>
        <source>Change the automatic notches</source>
        <translation>更改自动剪口</translation>
    </message>
    <message>
        <source>Add a notch</source>
        <translation>添加剪口</translation>
    </message>
    <message>
        <source>Change how %1 is cut</source>
        <translation>更改 %1 的裁剪方式</translation>
    </message>
    <message>
        <source>Change how the pattern is cut</source>
        <translation>更改样板的裁剪方式</translation>
    </message>
    <message>
        <source>Add internal line %1</source>
        <translation>添加内部线 %1</translation>
    </message>
    <message>
        <source>Change the purpose of %1</source>
        <translation>更改 %1 的用途</translation>
    </message>
    <message>
        <source>Change the ease of %1</source>
        <translation>更改 %1 的吃势</translation>
    </message>
    <message>
        <source>is %1, but must be a whole number; %2 are cut</source>
        <translation>为 %1，但必须是整数；将裁 %2 片</translation>
    </message>
    <message>
        <source>%1 is an allowance of a part of this stretch already; remove one of the two, or make their stretches meet</source>
        <translation>%1 已是此区段一部分的缝份；请删除其中一个，或使两区段首尾相接</translation>
    </message>
    <message>
        <source>the hole lies outside of &quot;%1&quot;; move it inside</source>
        <translation>孔位于“%1”之外；请移到内部</translation>
    </message>
    <message>
        <source>its sides are %1 mm and %2 mm long: true the seam, or say in its properties how much ease is wanted</source>
        <translation>其两侧长 %1 mm 和 %2 mm：请修正接缝，或在属性中说明所需吃势</translation>
    </message>
    <message>
        <source>its sides are %1 mm and %2 mm long, but the second one shall be longer by %3 mm: true the seam, or change the ease in its properties</source>
        <translation>其两侧长 %1 mm 和 %2 mm，但第二侧应长 %3 mm：请修正接缝，或在属性中更改吃势</translation>
    </message>
    <message>
        <source>The mouth of a dart must be at least 1 mm wide.</source>
        <translation>省口至少宽 1 mm。</translation>
    </message>
    <message>
        <source>The tip of a dart must lie inside its patch, at least 5 mm from its mouth.</source>
        <translation>省尖必须位于样片之内，距省口至少 5 mm。</translation>
    </message>
    <message>
        <source>The legs of the dart would cross the outline of %1: put its tip elsewhere.</source>
        <translation>省边会与 %1 的轮廓相交：请将省尖放在别处。</translation>
    </message>
    <message>
        <source>Add a dart to %1</source>
        <translation>在 %1 上添加省道</translation>
    </message>
    <message>
        <source>Select the seam of a dart.</source>
        <translation>请选择省道的接缝。</translation>
    </message>
    <message>
        <source>Without this dart the outline of %1 would cross itself.</source>
        <translation>没有此省道，%1 的轮廓会与自身相交。</translation>
    </message>
    <message>
        <source>Move a dart of %1</source>
        <translation>移动 %1 的省道</translation>
    </message>
    <message>
        <source>there is no piece in it</source>
        <translation>其中没有样片</translation>
    </message>
    <message>
        <source>Import a pattern of %1 pieces</source>
        <translation>导入 %1 个样片的样板</translation>
    </message>
    <message>
        <source>%1 is left out: its outline crosses itself or encloses nothing</source>
        <translation>%1 被略去：其轮廓与自身相交，或不围成面积</translation>
    </message>
    <message>
        <source>%1: %2 notches or lines belong to nothing and are left out</source>
        <translation>%1：%2 个剪口或线无所归属，已略去</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 points)</source>
        <translation>%1：绘制内容超出样板可容范围（超过 %2 个点）</translation>
    </message>
    <message>
        <source>%1: the file is larger than a pattern can be (%2 MB)</source>
        <translation>%1：文件超出样板可有的大小（%2 MB）</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not a group code of DXF</source>
        <translation>%1：“%2”不是 DXF 组码</translation>
    </message>
    <message>
        <source>%1: the file ends in the middle of something</source>
        <translation>%1：文件中途结束</translation>
    </message>
    <message>
        <source>%1 is not a DXF file: it has no sections</source>
        <translation>%1 不是 DXF 文件：没有段</translation>
    </message>
    <message>
        <source>%1 is not an SVG file</source>
        <translation>%1 不是 SVG 文件</translation>
    </message>
    <message>
        <source>%1: this is not well-formed XML (%2)</source>
        <translation>%1：不是格式正确的 XML（%2）</translation>
    </message>
    <message>
        <source>Sew %1 proposed seams</source>
        <translation>缝合 %1 条建议接缝</translation>
    </message>
    <message>
        <source>Remove a dart of %1</source>
        <translation>删除 %1 的省道</translation>
    </message>
    <message>
        <source>Move the tip of a dart of %1</source>
        <translation>移动 %1 的省尖</translation>
    </message>
    <message>
        <source>Opened there, the outline of %1 would cross itself.</source>
        <translation>在此打开，%1 的轮廓会与自身相交。</translation>
    </message>
    <message>
        <source>The legs of the dart must be of one length to be rotated: drag its tip onto the dotted line.</source>
        <translation>省道转移要求两省边等长：请将省尖拖到虚线上。</translation>
    </message>
    <message>
        <source>A dart is rotated to a place at least 5 mm from its mouth.</source>
        <translation>省道须转移到距省口至少 5 mm 处。</translation>
    </message>
    <message>
        <source>The line from the tip of the dart to there would leave %1.</source>
        <translation>从省尖到该处的线会离开 %1。</translation>
    </message>
    <message>
        <source>%1 lies across the line from the tip of the dart to there: move it, or rotate the dart elsewhere.</source>
        <translation>%1 横在省尖到该处的线上：请将其移开，或将省道转移到别处。</translation>
    </message>
    <message>
        <source>Rotate a dart of %1</source>
        <translation>转移 %1 的省道</translation>
    </message>
    <message>
        <source>Smooth outlines across ends of seams</source>
        <translation>圆顺接缝端点处的轮廓</translation>
    </message>
    <message>
        <source>This seam ends in no corners: there is nothing to smooth.</source>
        <translation>此接缝不终止于角点：没有可圆顺之处。</translation>
    </message>
    <message>
        <source>The outlines meet at more than 60° there: that is a corner, and stays one.</source>
        <translation>轮廓在此以超过 60° 相交：这是角点，保持不变。</translation>
    </message>
    <message>
        <source>Sew earlier</source>
        <translation>提前缝制</translation>
    </message>
    <message>
        <source>Sew later</source>
        <translation>推后缝制</translation>
    </message>
    <message>
        <source>Sew in the proposed order</source>
        <translation>按建议顺序缝制</translation>
    </message>
    <message>
        <source>Change the zip of %1</source>
        <translation>更改 %1 的拉链</translation>
    </message>
    <message>
        <source>Change when %1 is sewn</source>
        <translation>更改 %1 的缝制顺序</translation>
    </message>
    <message>
        <source>its sides have allowances of %1 mm and %2 mm: make them alike, or mind it when they are laid together</source>
        <translation>其两侧缝份为 %1 mm 和 %2 mm：请使其一致，或在对合时留意</translation>
    </message>
    <message>
        <source>This edge of %1 is not as long as that.</source>
        <translation>%1 的此边没有那么长。</translation>
    </message>
    <message>
        <source>the pattern is so large that the edge length of its triangles becomes %1 mm; is the unit right?</source>
        <translation>样板过大，三角形边长变为 %1 mm；单位是否正确？</translation>
    </message>
    <message>
        <source>%1 is left out: it is %2 m large, the most is %3 m; is the unit right?</source>
        <translation>%1 被略去：大小为 %2 m，上限为 %3 m；单位是否正确？</translation>
    </message>
    <message>
        <source>%1 is left out: its outline has fewer than three points</source>
        <translation>%1 被略去：其轮廓少于三个点</translation>
    </message>
    <message>
        <source>%1 is left out: of the %2 points of its outline no curve with at most %3 can be made</source>
        <translation>%1 被略去：其轮廓的 %2 个点无法构成不超过 %3 个点的曲线</translation>
    </message>
    <message>
        <source>%1: its outline has more than %2 points and is simplified, by %3 mm at most</source>
        <translation>%1：其轮廓超过 %2 个点，已简化，最多偏差 %3 mm</translation>
    </message>
    <message>
        <source>%1: its quantity &quot;%2&quot; is no number of pieces; it is cut once until somebody says how often</source>
        <translation>%1：其数量“%2”不是片数；在指定之前裁一片</translation>
    </message>
    <message>
        <source>%1: its quantity %2 is more than possible and becomes %3</source>
        <translation>%1：其数量 %2 超出上限，改为 %3</translation>
    </message>
    <message>
        <source>%1: %2 drill holes are narrower than %3 mm or wider than %4 mm and become as wide as possible</source>
        <translation>%1：%2 个钻孔小于 %3 mm 或大于 %4 mm，已改为最接近的允许值</translation>
    </message>
    <message>
        <source>%1 is left out: it would be a patch with mistakes</source>
        <translation>%1 被略去：它会是有错误的样片</translation>
    </message>
    <message>
        <source>%1: the file ends in the middle of its section %2, so it is not whole; get it once more</source>
        <translation>%1：文件在其 %2 段中途结束，不完整；请重新获取</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 groups)</source>
        <translation>%1：绘制内容超出样板可容范围（超过 %2 个组）</translation>
    </message>
    <message>
        <source>%1: %2 is larger than any pattern (%3)</source>
        <translation>%1：%2 大于任何样板（%3）</translation>
    </message>
    <message>
        <source>the mark at the end of the file (EOF) is missing: look whether everything is there</source>
        <translation>缺少文件结束标记 (EOF)：请检查内容是否齐全</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is inserted more often than a pattern needs (over %3 times)</source>
        <translation>%1：“%2”插入次数超出样板所需（超过 %3 次）</translation>
    </message>
    <message>
        <source>%1: an element has more than %2 attributes</source>
        <translation>%1：有元素的属性超过 %2 个</translation>
    </message>
    <message>
        <source>%1: more is drawn in it than a pattern can have (over %2 elements)</source>
        <translation>%1：绘制内容超出样板可容范围（超过 %2 个元素）</translation>
    </message>
    <message>
        <source>%1: elements lie in each other more than %2 times</source>
        <translation>%1：元素嵌套超过 %2 层</translation>
    </message>
    <message>
        <source>&quot;%1&quot; would be replaced, which is needed; choose another name</source>
        <translation>“%1”会被替换，但仍需使用；请另选名称</translation>
    </message>
    <message>
        <source>there is no cover yet: nothing is sewn or solved</source>
        <translation>还没有面套：尚未缝合或求解</translation>
    </message>
    <message>
        <source>there is not enough memory for this file</source>
        <translation>内存不足，无法处理此文件</translation>
    </message>
    <message>
        <source>the cover cannot be made a file (%1)</source>
        <translation>无法将面套写成文件（%1）</translation>
    </message>
    <message>
        <source>the cover is %1 mm thick and has %2 cm³</source>
        <translation>面套厚 %1 mm，体积 %2 cm³</translation>
    </message>
    <message>
        <source>there is no room for foam between the frame and the cover</source>
        <translation>骨架与面套之间没有放泡沫的空间</translation>
    </message>
    <message>
        <source>the foam has %1 l and weighs %2 kg at %3 kg/m³</source>
        <translation>泡沫体积 %1 l，按 %3 kg/m³ 重 %2 kg</translation>
    </message>
    <message>
        <source>there are neither fixation curves nor seams</source>
        <translation>既无固定曲线也无接缝</translation>
    </message>
    <message>
        <source>The three places lie on a line: choose some that do not.</source>
        <translation>三个位置共线：请选择不共线的位置。</translation>
    </message>
    <message>
        <source>The places are not as far from each other on the scan as where they belong: check the scale of the scan, and which is which.</source>
        <translation>扫描上各位置的间距与其应在之处不符：请检查扫描的比例，以及位置是否对应正确。</translation>
    </message>
    <message>
        <source>The scan could not be aligned: there are not enough of its points where it would stand. Click other places, or bring back what is cut away of it.</source>
        <translation>扫描无法对齐：其目标位置处的点太少。请单击其他位置，或恢复被裁掉的部分。</translation>
    </message>
    <message>
        <source>%1: the numbers of &quot;%2&quot; are not described as they must be: &quot;%3&quot;</source>
        <translation>%1：“%2”的数字描述不正确：“%3”</translation>
    </message>
    <message>
        <source>%1: the file is damaged: something is said to be at byte %2, where nothing can be; copy it again, or export the scan anew</source>
        <translation>%1：文件已损坏：字节 %2 处不可能有所声明的内容；请重新复制，或重新导出扫描</translation>
    </message>
    <message>
        <source>%1: the file is damaged: a checksum is wrong; copy it again, or export the scan anew</source>
        <translation>%1：文件已损坏：校验和错误；请重新复制，或重新导出扫描</translation>
    </message>
    <message>
        <source>%1 is not an E57 file</source>
        <translation>%1 不是 E57 文件</translation>
    </message>
    <message>
        <source>%1: E57 of version %2 cannot be read, or its pages have another size than 1024; export the scan as E57 1.0</source>
        <translation>%1：无法读取 E57 版本 %2，或其页大小不是 1024；请将扫描导出为 E57 1.0</translation>
    </message>
    <message>
        <source>%1: the pose of a scan is no rotation and translation</source>
        <translation>%1：扫描的位姿不是旋转加平移</translation>
    </message>
    <message>
        <source>%1: two scans are said to be at one place of the file; export them anew</source>
        <translation>%1：两个扫描声明在文件的同一位置；请重新导出</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; of the points is missing or no number of things</source>
        <translation>%1：点的“%2”缺失，或不是数量</translation>
    </message>
    <message>
        <source>%1: the file is damaged: a packet of points is not as it must be; export the scan anew</source>
        <translation>%1：文件已损坏：点数据包不正确；请重新导出扫描</translation>
    </message>
    <message>
        <source>%1: the points are packed by &quot;%2&quot;, which cannot be read; export the scan without an extension</source>
        <translation>%1：点用“%2”压缩，无法读取；请不用扩展导出扫描</translation>
    </message>
    <message>
        <source>%1: more is described in it than a scan can have</source>
        <translation>%1：描述内容超出扫描可容范围</translation>
    </message>
    <message>
        <source>%1: numbers that belong to one point lie too far from each other; export the scan anew</source>
        <translation>%1：属于同一点的数字相隔过远；请重新导出扫描</translation>
    </message>
    <message>
        <source>%1: a document type is not expected here</source>
        <translation>%1：此处不应有文档类型</translation>
    </message>
    <message>
        <source>%1 is not a LAS file</source>
        <translation>%1 不是 LAS 文件</translation>
    </message>
    <message>
        <source>%1 is compressed (LAZ), which cannot be read: save it as LAS, for example with laszip or CloudCompare, or as E57</source>
        <translation>%1 已压缩 (LAZ)，无法读取：请保存为 LAS（例如用 laszip 或 CloudCompare），或保存为 E57</translation>
    </message>
    <message>
        <source>%1: points of format %2 with %3 bytes cannot be read; save them as LAS 1.2 or 1.4</source>
        <translation>%1：无法读取格式 %2、每点 %3 字节的点；请保存为 LAS 1.2 或 1.4</translation>
    </message>
    <message>
        <source>%1: its scale and offset make no points</source>
        <translation>%1：其比例和偏移得不到点</translation>
    </message>
    <message>
        <source>%1: the points are said to begin within the header</source>
        <translation>%1：点声明从文件头内开始</translation>
    </message>
    <message>
        <source>The second side ends inside an edge, so the first one was changed.</source>
        <translation>第二侧终止于边的中间，因此更改了第一侧。</translation>
    </message>
    <message>
        <source>it has no triangle with an area</source>
        <translation>它没有有面积的三角形</translation>
    </message>
    <message>
        <source>%1 is left out: laid flat it would lie over itself. Divide it, or cut it in where it bulges most</source>
        <translation>%1 被略去：展平后会与自身重叠。请将其划分，或在最鼓处切开</translation>
    </message>
    <message>
        <source>the stretch does not lie on its outline any more. Sew or fix it anew.</source>
        <translation>该区段不再位于其轮廓上。请重新缝合或固定。</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot;, which reads such files for Bolster, cannot be started; install Bolster again</source>
        <translation>为 Bolster 读取此类文件的程序“%1”无法启动；请重新安装 Bolster</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes too long to read; export fewer parts of it, or triangles (OBJ, STL) instead</source>
        <translation>读取“%1”耗时过长；请导出较少部件，或改用三角形（OBJ、STL）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be read: it is damaged, or needs too much memory; export it again, or fewer parts of it, from the program that it comes from</source>
        <translation>无法读取“%1”：已损坏，或占用内存过多；请从来源程序重新导出，或导出较少部件</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds no faces, and a frame needs some; export bodies or surfaces, not lines and points alone</source>
        <translation>“%1”不含面，而骨架需要面；请导出实体或曲面，而不只是线和点</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than %2 triangles; export fewer parts of it, or coarser</source>
        <translation>“%1”的三角形超过 %2 个；请导出较少部件，或降低精度</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than %2 parts; export those that the cover touches</source>
        <translation>“%1”的部件超过 %2 个；请导出面套接触到的部件</translation>
    </message>
    <message>
        <source>%1: the part &quot;%2&quot; reaches beyond 10,000,000; export it without that part, or near the origin</source>
        <translation>%1：部件“%2”超出 10,000,000；请去掉该部件导出，或在原点附近导出</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs the file &quot;%2&quot; in its own folder; copy it there, or export as GLB, which is one file</source>
        <translation>“%1”需要同一文件夹中的文件“%2”；请复制到该处，或导出为单文件的 GLB</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged or incomplete, or not what its ending says; export it again from the program that it comes from</source>
        <translation>“%1”已损坏或不完整，或与扩展名不符；请从来源程序重新导出</translation>
    </message>
    <message>
        <source>%1: %2 triangles are left out: their corners are no numbers</source>
        <translation>%1：%2 个三角形被略去：其顶点不是数字</translation>
    </message>
    <message>
        <source>%1: parts are left out that are scaled to nothing: %2, the first is &quot;%3&quot;</source>
        <translation>%1：缩放为零的部件被略去：%2 个，第一个是“%3”</translation>
    </message>
    <message>
        <source>%1: %2 faces could not be made triangles of, and leave holes</source>
        <translation>%1：%2 个面无法分为三角形，留下孔洞</translation>
    </message>
    <message>
        <source>%1: %2 parts are left out that lie too deep in the tree</source>
        <translation>%1：树中层次过深的 %2 个部件被略去</translation>
    </message>
    <message>
        <source>%1: the parts in the file &quot;%2&quot; are not read; export all in one file</source>
        <translation>%1：文件“%2”中的部件不读取；请全部导出到一个文件</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no file that frames are written to; OBJ, PLY and STL are</source>
        <translation>“%1”不是可写入骨架的文件；可写入 OBJ、PLY 和 STL</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a scan that can be read; these can: %2</source>
        <translation>“%1”不是可读取的扫描；可读取：%2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a frame that can be read; these can: %2</source>
        <translation>“%1”不是可读取的骨架；可读取：%2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a pattern that can be read; these can: %2</source>
        <translation>“%1”不是可读取的样板；可读取：%2</translation>
    </message>
    <message>
        <source>nothing is left of the parts that are wanted</source>
        <translation>所需部件没有任何剩余</translation>
    </message>
    <message>
        <source>nothing is sewn where %1 of its notches are, so they have no partners</source>
        <translation>其 %1 个剪口处没有缝合，因此没有对应剪口</translation>
    </message>
    <message>
        <source>notches at edges without an allowance cut into the piece: there are %1; give these edges an allowance</source>
        <translation>无缝份边上的剪口会切入样片：共 %1 个；请为这些边设缝份</translation>
    </message>
    <message>
        <source>There is a dart already: put this one beside it, or remove that one first.</source>
        <translation>此处已有省道：请将此省道放在旁边，或先删除原有省道。</translation>
    </message>
    <message>
        <source>%1 is left out: with its holes, notches and lines the design would have more than %2 elements</source>
        <translation>%1 被略去：加上其孔、剪口和线，设计会超过 %2 个元素</translation>
    </message>
    <message>
        <source>%1: its nap &quot;%2&quot; is neither one way, two ways nor any; it is taken for two ways</source>
        <translation>%1：其毛向“%2”既非单向、双向，也非任意；按双向处理</translation>
    </message>
    <message>
        <source>%1 is drawn larger by what its fabric shrinks (%2), and taken as it is drawn: a shrinkage of the fabric here would come on top</source>
        <translation>%1 按其面料收缩量 (%2) 放大绘制，并照此采用：此处面料的缩率会再次叠加</translation>
    </message>
    <message>
        <source>the viewBox &quot;%1&quot; is no four numbers and is left out: check the size of the pieces</source>
        <translation>viewBox“%1”不是四个数字，已忽略：请检查样片尺寸</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs the file &quot;%2&quot; beside it, and the frame of a design is one file; import it again, or export it as GLB</source>
        <translation>“%1”需要旁边的文件“%2”，而设计的骨架只能是一个文件；请重新导入，或导出为 GLB</translation>
    </message>
    <message>
        <source>99 % of its surface is within %1 mm</source>
        <translation>99% 的表面在 %1 mm 以内</translation>
    </message>
    <message>
        <source>it reaches beyond its piece: end it at the edge</source>
        <translation>它超出样片：请使其终止于边</translation>
    </message>
    <message>
        <source>the hole breaks through the edge of its piece: move it inwards, or make it smaller</source>
        <translation>孔穿破样片的边：请向内移动，或改小</translation>
    </message>
    <message>
        <source>only %1 mm are left of the piece at the tip of a dart: make it shorter</source>
        <translation>省尖处样片仅剩 %1 mm：请缩短省道</translation>
    </message>
    <message>
        <source>%1 of its notches have no partners on the other sides of their seams: others are too near there. Ask for fewer</source>
        <translation>其 %1 个剪口在接缝另一侧没有对应剪口：那里其他剪口过近。请减少剪口</translation>
    </message>
    <message>
        <source>%1 has %2 sewing lines beside each other; the largest is taken, the others are left out</source>
        <translation>%1 有 %2 条并列的缝合线；取最大的，其余略去</translation>
    </message>
    <message>
        <source>%1: its cut line lies %2 mm outside of its sewing line, which is wider than an allowance may be; it becomes %3 mm there</source>
        <translation>%1：其裁剪线在缝合线外 %2 mm，超过缝份允许宽度；该处改为 %3 mm</translation>
    </message>
    <message>
        <source>The cover is pulled to the scan where it lies now: switch &quot;Fit the cover to it&quot; off, place it, and switch that on again.</source>
        <translation>面套正被拉向扫描的当前位置：请关闭“使面套贴合”，对齐扫描后再打开。</translation>
    </message>
    <message>
        <source>Place on the cover to %2 mm rms: %1 (%3 % of its points matched)</source>
        <translation>对齐到面套，均方根 %2 mm：%1（其 %3% 的点已匹配）</translation>
    </message>
    <message>
        <source>The scan could not be placed: it is too far from the cover. Align it by three places, or cut away what does not belong to it.</source>
        <translation>扫描无法对齐到面套：距面套过远。请用三个位置对齐，或裁掉不属于它的部分。</translation>
    </message>
    <message>
        <source>Align to %2 mm rms: %1 (%3 % of its points matched)</source>
        <translation>对齐，均方根 %2 mm：%1（其 %3% 的点已匹配）</translation>
    </message>
    <message>
        <source>Import the pattern of %1</source>
        <translation>导入 %1 的样板</translation>
    </message>
    <message>
        <source>%1: a gap of %2 mm in its outline is closed by a straight line</source>
        <translation>%1：其轮廓中 %2 mm 的缺口以直线闭合</translation>
    </message>
    <message>
        <source>%1: its cut line is drawn anew from its allowances, and differs from that of the file by up to %2 mm</source>
        <translation>%1：其裁剪线按缝份重新绘制，与文件中的最多相差 %2 mm</translation>
    </message>
    <message>
        <source>the size &quot;%1&quot; of the page is in no unit that is known and is left out: check the size of the pieces</source>
        <translation>页面尺寸“%1”的单位未知，已忽略：请检查样片尺寸</translation>
    </message>
    <message>
        <source>Sew a proposed seam</source>
        <translation>缝合一条建议接缝</translation>
    </message>
    <message>
        <source>it is in %1 pieces</source>
        <translation>它由 %1 块组成</translation>
    </message>
    <message>
        <source>one piece of less than 1 cm³ is left out</source>
        <translation>略去一块小于 1 cm³ 的</translation>
    </message>
    <message>
        <source>%1 pieces of less than 1 cm³ are left out</source>
        <translation>略去 %1 块小于 1 cm³ 的</translation>
    </message>
    <message>
        <source>Change whether the cover fits %1</source>
        <translation>更改面套是否贴合 %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs too much memory: it has too many parts, or places them too often; export those that the cover touches</source>
        <translation>“%1”占用内存过多：部件过多，或放置次数过多；请导出面套接触到的部件</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has decimal commas; export it with decimal points</source>
        <translation>“%1”使用小数逗号；请以小数点导出</translation>
    </message>
    <message>
        <source>%1: triangles are left out that name points which are not in the file</source>
        <translation>%1：引用了文件中不存在的点的三角形被略去</translation>
    </message>
    <message>
        <source>%1: %2 triangles are left out: they name points that are not in the file</source>
        <translation>%1：%2 个三角形被略去：它们引用了文件中不存在的点</translation>
    </message>
    <message>
        <source>%1: none of its %2 points has a place</source>
        <translation>%1：其 %2 个点都没有位置</translation>
    </message>
    <message>
        <source>%1: %2 points are left out: they have no place, as where a scanner saw nothing</source>
        <translation>%1：%2 个点被略去：它们没有位置，如扫描仪未测到之处</translation>
    </message>
    <message>
        <source>%1 is text in UTF-16, which is not read; save it as UTF-8</source>
        <translation>%1 是 UTF-16 文本，不能读取；请保存为 UTF-8</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; has a decimal comma; export with decimal points</source>
        <translation>%1：“%2”使用小数逗号；请以小数点导出</translation>
    </message>
    <message>
        <source>Make the pattern of a form</source>
        <translation>由形体生成样板</translation>
    </message>
    <message>
        <source>Fit the pattern to a goal</source>
        <translation>将样板拟合到目标</translation>
    </message>
    <message>
        <source>it has %1 triangles, and cannot be made simpler</source>
        <translation>它有 %1 个三角形，无法简化</translation>
    </message>
    <message>
        <source>The form has %1 triangles; %2 stand for it, which are up to %3 mm off</source>
        <translation>形体有 %1 个三角形；以 %2 个代表，最多偏差 %3 mm</translation>
    </message>
    <message>
        <source>%1 ends inside a piece, at %2: it is cut in there like a dart. The next line or border is %3 mm away; draw it on to there to divide the piece</source>
        <translation>%1 在样片内的 %2 处结束：该处像省道一样切开。下一条线或边界相距 %3 mm；延长至该处可将样片分开</translation>
    </message>
    <message>
        <source>No place of the cover is near the form: put it where the cover is, in millimetres.</source>
        <translation>面套没有任何位置靠近形体：请将其放到面套所在处，以毫米为单位。</translation>
    </message>
    <message>
        <source>Nothing that may change does anything to the cover.</source>
        <translation>可更改的内容对面套都没有影响。</translation>
    </message>
    <message>
        <source>A step would have turned the outline of %1 over itself; a smaller one was taken</source>
        <translation>一步会使 %1 的轮廓翻过自身；已取较小的一步</translation>
    </message>
    <message>
        <source>Nothing may change.</source>
        <translation>没有允许更改的内容。</translation>
    </message>
    <message>
        <source>The cover does not come to rest.</source>
        <translation>面套无法静止。</translation>
    </message>
    <message>
        <source>Make %1 longer by %3 mm where it is sewn to %2</source>
        <translation>将 %1 与 %2 缝合处加长 %3 mm</translation>
    </message>
    <message>
        <source>Make %1 shorter by %3 mm where it is sewn to %2</source>
        <translation>将 %1 与 %2 缝合处缩短 %3 mm</translation>
    </message>
    <message>
        <source>Move the seam of %1 and %2 by %3 mm into %2</source>
        <translation>将 %1 与 %2 的接缝向 %2 内移 %3 mm</translation>
    </message>
    <message>
        <source>Move the seam of %1 and %2 by %3 mm into %1</source>
        <translation>将 %1 与 %2 的接缝向 %1 内移 %3 mm</translation>
    </message>
    <message>
        <source>Let out the corner of %1 at %2 by %3 mm</source>
        <translation>将 %1 在 %2 处的角放出 %3 mm</translation>
    </message>
    <message>
        <source>Take in the corner of %1 at %2 by %3 mm</source>
        <translation>将 %1 在 %2 处的角收进 %3 mm</translation>
    </message>
    <message>
        <source>Cut a dart into %1 at %2, %3 mm wide and %4 mm deep</source>
        <translation>在 %1 的 %2 处剪省道，宽 %3 mm，深 %4 mm</translation>
    </message>
    <message>
        <source>Make the seam of %1 and %2 smooth</source>
        <translation>使 %1 与 %2 的接缝平滑</translation>
    </message>
    <message>
        <source>Let the seam of %1 and %2 be sharp</source>
        <translation>使 %1 与 %2 的接缝保留棱边</translation>
    </message>
    <message>
        <source>it is no file of preferences: it breaks off or has a mistake at character %1; choose one that Bolster has exported</source>
        <translation>不是首选项文件：在第 %1 个字符处中断或有错误；请选择由 Bolster 导出的文件</translation>
    </message>
    <message>
        <source>it is no file of preferences; choose one that Bolster has exported</source>
        <translation>不是首选项文件；请选择由 Bolster 导出的文件</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be what it is there; remove that line from the file, or export it again</source>
        <translation>“%1”不能取文件中的值；请从文件中删除该行，或重新导出</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, where a portable Bolster keeps settings and work, cannot be written; copy its folder to where you may write</source>
        <translation>便携版 Bolster 用于保存设置和工作的“%1”无法写入；请将其文件夹复制到有写入权限的位置</translation>
    </message>
    <message>
        <source>the disk with &quot;%1&quot; is full; make room on it, and change a setting once more: all of them are kept then</source>
        <translation>“%1”所在的磁盘已满；请腾出空间，再更改一项设置：届时全部保存</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be written; give yourself the right to write there and in its folder, and change a setting once more: all of them are kept then</source>
        <translation>无法写入“%1”；请取得该文件及其文件夹的写入权限，再更改一项设置：届时全部保存</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands there twice; remove one of its lines from the file, or export it again</source>
        <translation>“%1”在其中出现两次；请从文件中删去一行，或重新导出</translation>
    </message>
    <message>
        <source>Change the note of %1</source>
        <translation>更改 %1 的备注</translation>
    </message>
    <message>
        <source>Add measurement %1</source>
        <translation>添加测量 %1</translation>
    </message>
    <message>
        <source>it does not lie in &quot;%1&quot; any more; measure anew</source>
        <translation>已不在“%1”内；请重新测量</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; holds other files: choose one of its own.</source>
        <translation>文件夹“%1”中有其他文件：请选择专用文件夹。</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; holds the work of another design or of other options: choose another folder.</source>
        <translation>文件夹“%1”中是另一设计或其他选项的结果：请选择其他文件夹。</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be made (%2).</source>
        <translation>无法创建文件夹“%1”（%2）。</translation>
    </message>
    <message>
        <source>Remove %1 and what needs it (%2 elements)</source>
        <translation>移除 %1 及依赖它的内容（%2 个元素）</translation>
    </message>
    <message>
        <source>one version was saved</source>
        <translation>已恢复一个版本</translation>
    </message>
    <message>
        <source>%1: none of its triangles has an area</source>
        <translation>%1：没有任何三角形具有面积</translation>
    </message>
    <message>
        <source>Where a piece would have had a hole or been a ring it is cut and sewn again, number of cuts: %1</source>
        <translation>样片会有孔或成环之处已剪开并重新缝合，剪口数：%1</translation>
    </message>
    <message>
        <source>%1 is stretched by %2 % along the grain, its fabric allows %3 %</source>
        <translation>%1 沿布纹拉伸 %2%，其面料允许 %3%</translation>
    </message>
    <message>
        <source>%1 is stretched by %2 % across the grain, its fabric allows %3 %</source>
        <translation>%1 横布纹拉伸 %2%，其面料允许 %3%</translation>
    </message>
    <message>
        <source>%1 is sheared by %2 %, its fabric allows %3 %</source>
        <translation>%1 剪切 %2%，其面料允许 %3%</translation>
    </message>
    <message>
        <source>The form has one side only, as a twisted band: it is left open where its outside meets its inside</source>
        <translation>形体像扭转的带子一样只有一面：内外相接处保持敞开</translation>
    </message>
    <message>
        <source>Parts of %1 that are shorter than a mesh edge have gone with the cut.</source>
        <translation>%1 中短于网格边的部分已随剪切消失。</translation>
    </message>
    <message>
        <source>the usual value is used instead</source>
        <translation>改用通常的值</translation>
    </message>
    <message>
        <source>it is the project that is open here; choose another name</source>
        <translation>这是此处打开的项目；请另选名称</translation>
    </message>
    <message>
        <source>the file is empty; nothing was written to it, or it was lost</source>
        <translation>文件是空的；没有写入任何内容，或者内容已丢失</translation>
    </message>
    <message>
        <source>it is open in another window; choose another name</source>
        <translation>它已在另一个窗口中打开；请另选名称</translation>
    </message>
    <message>
        <source>the disk of &quot;%1&quot; is full, where work is protected from crashes; make room, and open it again</source>
        <translation>用于防止崩溃丢失工作的“%1”所在磁盘已满；请腾出空间后重新打开</translation>
    </message>
    <message>
        <source>The form is %1 mm large: with edges of %2 mm its cover has more triangles than can be solved. See whether the unit is right; else make the mesh edges at least %3 mm long</source>
        <translation>形体大小为 %1 mm：边长为 %2 mm 时，面套的三角形多得无法求解。请检查单位是否正确；若正确，请把网格边长设为至少 %3 mm</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already; choose another name</source>
        <translation>“%1”已存在；请选择其他名称</translation>
    </message>
    <message>
        <source>%1 is strained by %2 % when it lies on the form, more than any fabric bears. Divide it, or cut it in where it bulges most</source>
        <translation>%1 贴在形体上时应变达 %2 %，超过任何面料所能承受。请将其分开，或在最鼓处开剪口</translation>
    </message>
    <message>
        <source>Let no scan pull at the cover</source>
        <translation>不让任何扫描拉动面套</translation>
    </message>
    <message>
        <source>%1 bends too sharply at %2: it is not cut along it</source>
        <translation>%1 在 %2 处弯折过急：不沿其切分</translation>
    </message>
    <message>
        <source>The form goes through itself at %2: it is not cut along %1</source>
        <translation>形体在 %2 处穿过自身：不沿 %1 切分</translation>
    </message>
    <message>
        <source>What is closed all around has no border to be held at: its cover is fixed along its seams. Delete the fixations of those that are to be free</source>
        <translation>完全封闭的部分没有可固定的边缘：其面套沿缝固定。需要自由的缝，请删除其固定</translation>
    </message>
    <message>
        <source>No vertex of the area is near the form: make the area larger than the mesh edges, or put the form where the cover is.</source>
        <translation>区域内没有顶点靠近形体：请使区域大于网格边长，或将形体放到面套所在处。</translation>
    </message>
    <message>
        <source>%1 is left out: it is too narrow to be sewn. Join it to what lies beside it</source>
        <translation>%1 被略去：太窄，无法缝制。请将其与相邻部分合并</translation>
    </message>
    <message>
        <source>Make the pattern of a form again</source>
        <translation>重新由形体生成样板</translation>
    </message>
    <message>
        <source>Make the pattern of %1 again</source>
        <translation>重新由 %1 生成样板</translation>
    </message>
    <message>
        <source>Make the pattern of %1</source>
        <translation>由 %1 生成样板</translation>
    </message>
    <message>
        <source>Fit the pattern to %1, %2 mm from it</source>
        <translation>将样板拟合到 %1，相距 %2 mm</translation>
    </message>
    <message>
        <source>Fit the pattern to %1</source>
        <translation>将样板拟合到 %1</translation>
    </message>
    <message>
        <source>Fit the pattern to a limit of strain, %1 % of the cover over it</source>
        <translation>将样板拟合到应变极限，面套的 %1% 超过它</translation>
    </message>
    <message>
        <source>Let the scan pull at the cover again</source>
        <translation>让扫描再次拉动面套</translation>
    </message>
    <message>
        <source>%1 runs along %2, at %3: it is cut there once</source>
        <translation>%1 在 %3 处与 %2 重合：该处只裁一次</translation>
    </message>
    <message>
        <source>%1 runs along the border of the form, or where it is cut anyway, at %2: there is nothing to cut</source>
        <translation>%1 在 %2 处沿着形体的边界或本来就要裁开的地方：没有可裁的</translation>
    </message>
    <message>
        <source>%1 is too short or too long, at %2: it is not cut along it</source>
        <translation>%1 在 %2 处过短或过长：不沿其切分</translation>
    </message>
    <message>
        <source>%1 is %2 mm away from the form, at %3: it is not cut along it</source>
        <translation>%1 在 %3 处距形体 %2 mm：不沿其切分</translation>
    </message>
    <message>
        <source>lines cannot be cut into it: it has edges where more than two faces meet, or sheets that touch in a point, at %1</source>
        <translation>无法在其上切线：它在 %1 处有两个以上的面相接的边，或仅在一点相触的片</translation>
    </message>
    <message>
        <source>%1 cannot be cut into it, at %2: the form goes through itself there</source>
        <translation>无法在 %2 处切出 %1：形体在该处穿过自身</translation>
    </message>
    <message>
        <source>Small for the triangles of the cover, whose edges are %1 mm long: %2. Their shape will be coarse; with mesh edges of %3 mm it is not</source>
        <translation>相对于面套三角形（边长 %1 mm）偏小：%2。其形状会很粗糙；网格边长取 %3 mm 则不会</translation>
    </message>
    <message>
        <source>Too small for the triangles of the cover, whose edges are %1 mm long: %2. Join them to what lies beside them, or leave them out</source>
        <translation>相对于面套三角形（边长 %1 mm）过小：%2。请将其与相邻部分合并，或略去</translation>
    </message>
    <message>
        <source>After %1 iterations it cannot be told yet where the surface comes to rest. Allow more iterations.</source>
        <translation>%1 次迭代后，尚无法判断曲面将静止在何处。请允许更多迭代。</translation>
    </message>
    <message>
        <source>Wider across the grain than the fabric, of which %1 mm can be used: %2. Divide them, or turn their grain</source>
        <translation>垂直于布纹的宽度超过面料可用宽度 %1 mm：%2。请分割它们，或旋转其布纹</translation>
    </message>
    <message>
        <source>%1 ends inside a piece, at %2: it is cut in there like a dart. There is no other line or border; lead it around to where it began to divide the piece</source>
        <translation>%1 在样片内的 %2 处结束：该处像省道一样切开。没有其他线或边界；绕一圈回到起点可将样片分开</translation>
    </message>
    <message>
        <source>A line is not cut in at %1: the sides of the cut would lie over each other when it is laid flat. Draw it elsewhere, or on to a border</source>
        <translation>%1 处的线未切开：展平后切口两侧会相互重叠。请画在别处，或延长至边界</translation>
    </message>
    <message>
        <source>A line is not cut in at %1: the piece was divided another way. Draw it on to a border</source>
        <translation>%1 处的线未切开：样片已按其他方式分割。请延长至边界</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no design, but what one is made of: import it</source>
        <translation>“%1”不是设计，而是用来制作设计的文件：请导入它</translation>
    </message>
    <message>
        <source>After %1 iterations the surface still moves by %2 mm in each: it does not come to rest. Make curves as long as the outlines they hold, or try other mesh edges.</source>
        <translation>%1 次迭代后，曲面每次仍移动 %2 mm：无法静止。请使曲线与其固定的轮廓等长，或尝试其他网格边长。</translation>
    </message>
    <message>
        <source>%1, with what is sewn to it, is held only at a border of %2 mm: fix it along other curves, too, or close that hole of the form</source>
        <translation>%1 及与其缝合的部分仅由 %2 mm 的边缘固定：请再沿其他曲线固定，或封闭形体上的该孔</translation>
    </message>
    <message>
        <source>%1 is left out: it is closed all around and cannot be laid flat. Cut it along lines</source>
        <translation>%1 被略去：其四周封闭，无法展平。请沿线将其切开</translation>
    </message>
    <message>
        <source>%1 is left out: it has a handle, like a cup, and cannot be laid flat. Cut it along lines</source>
        <translation>%1 被略去：其带有杯柄状的环，无法展平。请沿线将其切开</translation>
    </message>
    <message>
        <source>Let out %1 by %3 mm where it is sewn to %2</source>
        <translation>将 %1 与 %2 缝合处放出 %3 mm</translation>
    </message>
    <message>
        <source>Take in %1 by %3 mm where it is sewn to %2</source>
        <translation>将 %1 与 %2 缝合处收进 %3 mm</translation>
    </message>
    <message>
        <source>Let out %1 by %3 mm where the curve %2 holds it</source>
        <translation>将 %1 在由曲线 %2 固定处放出 %3 mm</translation>
    </message>
    <message>
        <source>Take in %1 by %3 mm where the curve %2 holds it</source>
        <translation>将 %1 在由曲线 %2 固定处收进 %3 mm</translation>
    </message>
    <message>
        <source>What would not lie flat, or be strained by more than the fabric may be, is divided, which makes so many pieces more: %1</source>
        <translation>无法展平或拉伸超过面料允许值的部分已划分，增加的样片数：%1</translation>
    </message>
    <message>
        <source>%1 is not divided: more than %2 pieces would be needed until it lies flat. It is rough, as scans are: smooth it, or fit a cover to it and take that</source>
        <translation>%1 未划分：要使其展平，需要超过 %2 片。它像扫描一样粗糙：请将其平滑，或为其拟合一个面套并采用该面套</translation>
    </message>
    <message>
        <source>%1 is left out: it has more than %2 holes. Close them, or cut it along lines</source>
        <translation>%1 被略去：孔超过 %2 个。请封闭这些孔，或沿线将其切开</translation>
    </message>
    <message>
        <source>Too narrow for the triangles of the cover, whose edges are %1 mm long, so that it cannot be solved: %2. Make the mesh edges shorter, or join them to what lies beside them</source>
        <translation>相对于面套三角形（边长 %1 mm）过窄，无法求解面套：%2。请减小网格边长，或将其与相邻部分合并</translation>
    </message>
    <message>
        <source>Lead open seam lines on</source>
        <translation>延长未闭合的缝线</translation>
    </message>
    <message>
        <source>Lead %1 on</source>
        <translation>延长 %1</translation>
    </message>
    <message>
        <source>Bodies of the form go through each other, as at %1: what of one lies inside of another one is covered, too, and pushed out. Unite them before, or leave one out. Number of such pairs: %2</source>
        <translation>形体中有实体相互穿插，例如在 %1：一个实体位于另一个内部的部分也会被包覆，并被推到外面。请先将它们合并，或者舍去其中一个。这样的对数：%2</translation>
    </message>
    <message>
        <source>Faces of the form that lie where another one lies, and are left out: %1</source>
        <translation>与其他面位置重合而被略去的形体面：%1</translation>
    </message>
    <message>
        <source>Faces of the form that were turned round: %1</source>
        <translation>被翻转的形体面：%1</translation>
    </message>
    <message>
        <source>Edges of the form that belong to more than two faces, so that they are borders and nothing is sewn there: %1</source>
        <translation>属于两个以上面的形体边，因此作为边界，那里不缝合：%1</translation>
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
        <translation>中键</translation>
    </message>
    <message>
        <source>right button</source>
        <translation>右键</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>拖动</translation>
    </message>
    <message>
        <source>two fingers</source>
        <translation>双指滑动</translation>
    </message>
    <message>
        <source>pinch or Ctrl+wheel</source>
        <translation>双指捏合或 Ctrl+滚轮</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>滚轮</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>CAD (like SolidWorks)</source>
        <translation>CAD（类似 SolidWorks）</translation>
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
        <translation>触控板</translation>
    </message>
</context>
<context>
    <name>NotchForm</name>
    <message>
        <source>Patch</source>
        <translation>样片</translation>
    </message>
    <message>
        <source>From the corner</source>
        <translation>距角点</translation>
    </message>
    <message>
        <source>Along the outline from the nearer corner, on the same side of it.</source>
        <translation>从较近的角点沿轮廓量取，在角点的同一侧。</translation>
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
        <translation>保持法线</translation>
    </message>
    <message>
        <source>Tangent plane held</source>
        <translation>保持切平面</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>倾斜</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>%1 directions, interpolated along the curve; the first is shown.</source>
        <translation>%1 个方向，沿曲线插值；显示第一个。</translation>
    </message>
</context>
<context>
    <name>OutlineTool</name>
    <message>
        <source>This cannot be a patch: %1</source>
        <translation>这不能成为样片：%1</translation>
    </message>
    <message>
        <source>The outline would cross itself here – Backspace takes a point back</source>
        <translation>轮廓在此会与自身相交——Backspace 撤回一点</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no length: try 500, 500&lt;30 or 120, 40</source>
        <translation>“%1”不是长度：例如 500、500&lt;30 或 120, 40</translation>
    </message>
    <message>
        <source>Click to set the first corner, press and drag for a smooth point – Esc ends the tool</source>
        <translation>单击设置第一个角点，按住拖动为平滑点——Esc 结束工具</translation>
    </message>
    <message>
        <source>Click to close the outline</source>
        <translation>单击以闭合轮廓</translation>
    </message>
    <message>
        <source>Enter sets the point: 500 goes that far, 500&lt;30 at an angle, 120, 40 to the right and up</source>
        <translation>按 Enter 设置点：500 为距离，500&lt;30 带角度，120, 40 为向右和向上</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, or type a length – Ctrl does not snap</source>
        <translation>单击为角点，拖动为平滑点，或输入长度——Ctrl 不捕捉</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, type a length – Enter or a click on the first point closes, Backspace takes a point back</source>
        <translation>单击为角点，拖动为平滑点，或输入长度——Enter 或单击第一点闭合，Backspace 撤回一点</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
</context>
<context>
    <name>OutlineTrimForm</name>
    <message>
        <source>Outline</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
</context>
<context>
    <name>PatchDrawingTool</name>
    <message>
        <source>Patch %1</source>
        <translation>样片 %1</translation>
    </message>
    <message>
        <source>An outline needs at least three points in different places.</source>
        <translation>轮廓至少需要三个位置不同的点。</translation>
    </message>
    <message>
        <source>This cannot be a patch: %1</source>
        <translation>这不能成为样片：%1</translation>
    </message>
</context>
<context>
    <name>PatchForm</name>
    <message>
        <source>Outline</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Width and height as it lies in the pattern view.</source>
        <translation>在样板视图中摆放时的宽和高。</translation>
    </message>
</context>
<context>
    <name>PatternDrawTool</name>
    <message>
        <source>Begin inside a patch.</source>
        <translation>请从样片内开始。</translation>
    </message>
    <message>
        <source>Fancy seam %1</source>
        <translation>装饰缝 %1</translation>
    </message>
    <message>
        <source>Handle %1</source>
        <translation>操控 %1</translation>
    </message>
    <message>
        <source>A curve needs two points, a closed one three.</source>
        <translation>曲线至少需要两个点，闭合曲线需要三个。</translation>
    </message>
    <message>
        <source>There is no surface in this patch yet on which the handle could lie.</source>
        <translation>此样片还没有可供操控曲线依附的曲面。</translation>
    </message>
    <message>
        <source>Click inside a patch to begin a handle curve – Esc ends the tool</source>
        <translation>单击样片内部开始绘制操控曲线——Esc 结束工具</translation>
    </message>
    <message>
        <source>Click inside a patch or on its outline to begin a fancy seam – Esc ends the tool</source>
        <translation>单击样片内部或其轮廓开始绘制装饰缝——Esc 结束工具</translation>
    </message>
    <message>
        <source>Click to close the curve</source>
        <translation>单击以闭合曲线</translation>
    </message>
    <message>
        <source>Click for the next point, double click or Enter ends – B makes it straight, Backspace takes a point back</source>
        <translation>单击设置下一点，双击或 Enter 结束——B 改为直线，Backspace 撤回一点</translation>
    </message>
    <message>
        <source>Click for the next point, double click or Enter ends – B makes it smooth, Backspace takes a point back</source>
        <translation>单击设置下一点，双击或 Enter 结束——B 改为平滑，Backspace 撤回一点</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>线 %1</translation>
    </message>
    <message>
        <source>Click inside a patch or on its outline to begin a line for the cutter – Esc ends the tool</source>
        <translation>单击样片内部或其轮廓开始绘制裁床用线——Esc 结束工具</translation>
    </message>
</context>
<context>
    <name>PatternPdf</name>
    <message>
        <source>1 inch</source>
        <translation>1 英寸</translation>
    </message>
    <message>
        <source>Print at 100 %</source>
        <translation>按 100% 打印</translation>
    </message>
    <message>
        <source>%1 – print at 100 %</source>
        <translation>%1——按 100% 打印</translation>
    </message>
    <message>
        <source>Overview of %1 x %2 sheets</source>
        <translation>%1 x %2 张纸的总览</translation>
    </message>
    <message>
        <source>%1: sheet %2</source>
        <translation>%1：第 %2 张</translation>
    </message>
    <message>
        <source>%1: sheets %2 to %3</source>
        <translation>%1：第 %2 至 %3 张</translation>
    </message>
    <message>
        <source>100 mm: to measure, no part of the pattern</source>
        <translation>100 mm：供测量核对，不属于样板</translation>
    </message>
    <message>
        <source>Sheet %1 (row %2 of %3, column %4 of %5)</source>
        <translation>第 %1 张（第 %2 行，共 %3 行；第 %4 列，共 %5 列）</translation>
    </message>
</context>
<context>
    <name>PatternSelectTool</name>
    <message>
        <source>There is a control point already.</source>
        <translation>此处已有控制点。</translation>
    </message>
    <message>
        <source>Drag to turn the selected patches in the layout</source>
        <translation>拖动以在布局中旋转所选样片</translation>
    </message>
    <message>
        <source>Drag to move the control point – Shift+click selects several, Del removes</source>
        <translation>拖动以移动控制点——Shift+单击选择多个，Del 删除</translation>
    </message>
    <message>
        <source>Click to select the patch, drag to move it in the layout</source>
        <translation>单击选择样片，拖动在布局中移动</translation>
    </message>
    <message>
        <source>Click to select the curve, drag to move it, double click to add a control point here</source>
        <translation>单击选择曲线，拖动移动，双击在此添加控制点</translation>
    </message>
    <message>
        <source>Drag to scale the selected patches – Shift keeps the proportions</source>
        <translation>拖动以缩放所选样片——Shift 保持比例</translation>
    </message>
    <message>
        <source>Drag to move this end of the stretch along the outline</source>
        <translation>拖动以沿轮廓移动区段的此端</translation>
    </message>
    <message>
        <source>Drag to move the edge, double click to add a control point here – its length is in the properties</source>
        <translation>拖动移动边，双击在此添加控制点——长度在属性中</translation>
    </message>
    <message>
        <source>Click to select the edge, double click to add a control point here, drag to move the patch</source>
        <translation>单击选择边，双击在此添加控制点，拖动移动样片</translation>
    </message>
    <message>
        <source>Click to select the seam and the edge, double click to add a control point here</source>
        <translation>单击选择接缝和边，双击在此添加控制点</translation>
    </message>
    <message>
        <source>Click to select it, drag to move it, Delete removes it</source>
        <translation>单击选择，拖动移动，Delete 删除</translation>
    </message>
    <message>
        <source>Drag the tip of the dart</source>
        <translation>拖动省尖</translation>
    </message>
    <message>
        <source>Drag the dart along the outline</source>
        <translation>沿轮廓拖动省道</translation>
    </message>
    <message>
        <source>Drag the label to where it can be read, click to select the patch</source>
        <translation>将标签拖到便于阅读之处，单击选择样片</translation>
    </message>
    <message>
        <source>Click to select, drag a box to select several – %1 or Space pans, %2 zooms</source>
        <translation>单击选择，拖出选框选择多个——%1 或空格平移，%2 缩放</translation>
    </message>
    <message>
        <source>Click to select the measurement, Delete removes it</source>
        <translation>单击选择测量，Delete 删除</translation>
    </message>
</context>
<context>
    <name>PatternSplitTool</name>
    <message>
        <source>Click beside a patch or on its outline to begin the cut – Esc ends the tool</source>
        <translation>在样片旁或其轮廓上单击开始切割——Esc 结束工具</translation>
    </message>
    <message>
        <source>Double click or Enter splits the patch – click to bend the cut, Backspace takes a point back</source>
        <translation>双击或 Enter 分割样片——单击使切割线转折，Backspace 撤回一点</translation>
    </message>
    <message>
        <source>Click on the other side of the patch – Shift keeps the cut straight, Backspace takes a point back</source>
        <translation>单击样片的另一侧——Shift 使切割线保持直线，Backspace 撤回一点</translation>
    </message>
</context>
<context>
    <name>PatternTool</name>
    <message>
        <source>Moved by %1, %2 – Shift keeps to one axis, Esc takes it back</source>
        <translation>已移动 %1，%2——Shift 限于一个轴，Esc 还原</translation>
    </message>
    <message>
        <source>Turned by %1 – Shift turns in steps of 15°, Esc takes it back</source>
        <translation>已旋转 %1——Shift 每次 15°，Esc 还原</translation>
    </message>
    <message>
        <source>Release to select what lies in the box – Shift adds, Esc takes it back</source>
        <translation>松开以选择框内对象——Shift 添加，Esc 还原</translation>
    </message>
    <message>
        <source>Release to select what lies in the loop – Shift adds, Esc takes it back</source>
        <translation>松开以选择套索内对象——Shift 添加，Esc 还原</translation>
    </message>
    <message>
        <source>Enter moves it so far: 50, or 30, 20</source>
        <translation>按 Enter 移动此距离：50，或 30, 20</translation>
    </message>
    <message>
        <source>Enter turns it by this angle, counter-clockwise: 45</source>
        <translation>按 Enter 逆时针旋转此角度：45</translation>
    </message>
    <message>
        <source>Enter makes it this size: 300 x 200, 300 (wide, in proportion), or 120 %</source>
        <translation>按 Enter 设为此尺寸：300 x 200、300（宽，按比例）或 120 %</translation>
    </message>
    <message>
        <source>Scaled to %1 × %2 – or type the size; Shift keeps the proportions, Esc takes it back</source>
        <translation>已缩放至 %1 × %2——也可输入尺寸；Shift 保持比例，Esc 还原</translation>
    </message>
</context>
<context>
    <name>PatternToolHost</name>
    <message>
        <source>%1 Let go here, and it goes back to where it was.</source>
        <translation>%1 在此松开将回到原处。</translation>
    </message>
</context>
<context>
    <name>PieceCuttingSection</name>
    <message>
        <source>Cutting</source>
        <translation>裁剪</translation>
    </message>
    <message>
        <source>Own seam allowance</source>
        <translation>自有缝份</translation>
    </message>
    <message>
        <source>Label where it finds room</source>
        <translation>标签放在有空位处</translation>
    </message>
</context>
<context>
    <name>PlacementGizmo</name>
    <message>
        <source>Turned by %1° – Ctrl snaps to 15°, Escape cancels</source>
        <translation>已旋转 %1°——Ctrl 捕捉到 15°，Esc 取消</translation>
    </message>
    <message>
        <source>Drag to move it along this axis</source>
        <translation>拖动以沿此轴移动</translation>
    </message>
    <message>
        <source>Drag to turn it about this axis</source>
        <translation>拖动以绕此轴旋转</translation>
    </message>
    <message>
        <source>Drag to move it parallel to the picture</source>
        <translation>拖动以平行于画面移动</translation>
    </message>
    <message>
        <source>Moved by x %1, y %2, z %3 – Ctrl snaps to %4, Escape cancels</source>
        <translation>已移动 x %1，y %2，z %3——Ctrl 捕捉到 %4，Esc 取消</translation>
    </message>
</context>
<context>
    <name>PreferenceCommands</name>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation>首选项(&amp;F)…</translation>
    </message>
    <message>
        <source>Units, language, theme, mouse, keys and more</source>
        <translation>单位、语言、主题、鼠标、按键等</translation>
    </message>
    <message>
        <source>The preferences could not be stored: they hold only until Bolster is closed.</source>
        <translation>无法保存首选项：只在关闭 Bolster 之前有效。</translation>
    </message>
</context>
<context>
    <name>Preferences</name>
    <message>
        <source>Millimetres (314 mm)</source>
        <translation>毫米 (314 mm)</translation>
    </message>
    <message>
        <source>Centimetres (31.4 cm)</source>
        <translation>厘米 (31.4 cm)</translation>
    </message>
    <message>
        <source>Inches (12 3/8″)</source>
        <translation>英寸 (12 3/8″)</translation>
    </message>
    <message>
        <source>Up to 1/8</source>
        <translation>精确到 1/8</translation>
    </message>
    <message>
        <source>Up to 1/16</source>
        <translation>精确到 1/16</translation>
    </message>
    <message>
        <source>Up to 1/32</source>
        <translation>精确到 1/32</translation>
    </message>
    <message>
        <source>Up to 1/64</source>
        <translation>精确到 1/64</translation>
    </message>
    <message>
        <source>Decimals (12.375)</source>
        <translation>小数 (12.375)</translation>
    </message>
    <message>
        <source>Of the language</source>
        <translation>按语言</translation>
    </message>
    <message>
        <source>Comma (1,5)</source>
        <translation>逗号 (1,5)</translation>
    </message>
    <message>
        <source>Point (1.5)</source>
        <translation>点 (1.5)</translation>
    </message>
    <message>
        <source>Of the system</source>
        <translation>系统语言</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>高对比度</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>完整</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>降低</translation>
    </message>
    <message>
        <source>Plain, as it comes</source>
        <translation>素色，默认</translation>
    </message>
    <message>
        <source>Units and numbers</source>
        <translation>单位和数字</translation>
    </message>
    <message>
        <source>Language and looks</source>
        <translation>语言和外观</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>鼠标</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>键盘</translation>
    </message>
    <message>
        <source>Pattern view</source>
        <translation>样板视图</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>三维视图</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>未保存的工作</translation>
    </message>
    <message>
        <source>New designs</source>
        <translation>新设计</translation>
    </message>
    <message>
        <source>Lengths in</source>
        <translation>长度单位</translation>
    </message>
    <message>
        <source>unit measure metric imperial millimetre centimetre inch</source>
        <translation>单位 度量 公制 英制 毫米 厘米 英寸 长度</translation>
    </message>
    <message>
        <source>How lengths are shown. Whatever it is, you may type others: 3 in, 2.5 cm, 1&apos; 2 3/8&quot;. Designs keep millimetres, and so do printed sheets and files.</source>
        <translation>长度的显示方式。无论如何设置，都可输入其他单位：“3 in”、“2.5 cm”、“1&apos; 2 3/8&quot;”。设计始终使用毫米，打印的图纸和文件也是如此。</translation>
    </message>
    <message>
        <source>Parts of an inch</source>
        <translation>英寸分数</translation>
    </message>
    <message>
        <source>fraction imperial 1/16 decimals</source>
        <translation>分数 英制 1/16 小数</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>小数点符号</translation>
    </message>
    <message>
        <source>comma point dot separator numbers</source>
        <translation>逗号 点 小数点 分隔符 数字</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>translation words english german deutsch</source>
        <translation>翻译 文字 中文 英语 德语 language english</translation>
    </message>
    <message>
        <source>Bolster speaks it when it is started the next time.</source>
        <translation>下次启动 Bolster 时生效。</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>colours dark light contrast night appearance accessibility</source>
        <translation>颜色 深色 浅色 暗色 对比度 夜间 外观 无障碍</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Size of the letters</source>
        <translation>文字大小</translation>
    </message>
    <message>
        <source>font text large small zoom scale accessibility</source>
        <translation>字体 字号 文本 大 小 缩放 无障碍</translation>
    </message>
    <message>
        <source>Move the views as in</source>
        <translation>视图操作方式同</translation>
    </message>
    <message>
        <source>navigation rotate turn pan zoom buttons trackpad orbit preset</source>
        <translation>导航 旋转 转动 平移 缩放 按键 触控板 环绕 预设</translation>
    </message>
    <message>
        <source>Zoom the other way round</source>
        <translation>反转缩放方向</translation>
    </message>
    <message>
        <source>invert wheel scroll reverse direction</source>
        <translation>反转 滚轮 滚动 反向 方向</translation>
    </message>
    <message>
        <source>Keys as in</source>
        <translation>按键同</translation>
    </message>
    <message>
        <source>shortcuts hotkeys preset</source>
        <translation>快捷键 热键 预设</translation>
    </message>
    <message>
        <source>Some commands get the keys that you know from there. Keys that you have chosen yourself stay.</source>
        <translation>部分命令采用您在该软件中熟悉的按键。您自选的按键保持不变。</translation>
    </message>
    <message>
        <source>Snap to points, edges, guides and the grid</source>
        <translation>捕捉到点、边、参考线和栅格</translation>
    </message>
    <message>
        <source>magnet catch align</source>
        <translation>磁吸 吸附 捕捉 对齐</translation>
    </message>
    <message>
        <source>Ctrl or Alt lets go while you drag.</source>
        <translation>拖动时按 Ctrl 或 Alt 可暂停捕捉。</translation>
    </message>
    <message>
        <source>Show rulers</source>
        <translation>显示标尺</translation>
    </message>
    <message>
        <source>scale measure</source>
        <translation>刻度 测量 尺寸</translation>
    </message>
    <message>
        <source>Show guides</source>
        <translation>显示参考线</translation>
    </message>
    <message>
        <source>lines help</source>
        <translation>线 辅助线</translation>
    </message>
    <message>
        <source>Quality of the picture</source>
        <translation>画面质量</translation>
    </message>
    <message>
        <source>performance slow fast remote desktop graphics opengl</source>
        <translation>性能 慢 快 远程桌面 图形 显卡 opengl</translation>
    </message>
    <message>
        <source>Reduced: fewer pixels and triangles, no soft shadows. For slow machines and for screens that are far away. Pictures that you export stay fine.</source>
        <translation>降低：减少像素和三角形，无柔和阴影。适用于较慢的电脑和远程屏幕。导出的图片仍保持精细。</translation>
    </message>
    <message>
        <source>Go to other views at once, without a flight</source>
        <translation>立即切换视图，不用过渡动画</translation>
    </message>
    <message>
        <source>reduced motion animation camera accessibility remote</source>
        <translation>减少动态效果 动画 相机 无障碍 远程</translation>
    </message>
    <message>
        <source> days</source>
        <translation> 天</translation>
    </message>
    <message>
        <source>Keep work that was thrown away for</source>
        <translation>丢弃的工作保留</translation>
    </message>
    <message>
        <source>autosave backup recovery crash journal bin unsaved delete</source>
        <translation>自动保存 备份 恢复 崩溃 日志 回收站 未保存 删除</translation>
    </message>
    <message>
        <source>Every step is on the disk as soon as it is done, so there is no interval to set. Unsaved work stays until you open it again or throw it away; after that it lies in the bin for at least 30 days.</source>
        <translation>每一步完成后立即写入磁盘，因此无需设置间隔。未保存的工作会一直保留，直到您重新打开或丢弃；此后在回收站中至少保留 30 天。</translation>
    </message>
    <message>
        <source>Fabric of new patches</source>
        <translation>新样片的面料</translation>
    </message>
    <message>
        <source>default material leather weave colour</source>
        <translation>默认 材料 面料 皮革 机织物 颜色</translation>
    </message>
    <message>
        <source>A new design begins with it, and patches are made of a design&apos;s first fabric.</source>
        <translation>新设计以此面料开始，样片采用设计的第一种面料。</translation>
    </message>
    <message>
        <source>Seam allowance</source>
        <translation>缝份</translation>
    </message>
    <message>
        <source>default cutting margin hem width</source>
        <translation>默认 裁剪 余量 折边 缝头 宽度</translation>
    </message>
    <message>
        <source>New designs begin with it; in a design it is changed in its properties.</source>
        <translation>新设计以此值开始；在设计中可于其属性中更改。</translation>
    </message>
    <message>
        <source>Folder of your fabrics</source>
        <translation>您的面料文件夹</translation>
    </message>
    <message>
        <source>library directory path import export picture swatch</source>
        <translation>面料库 目录 路径 导入 导出 图片 色卡</translation>
    </message>
    <message>
        <source>Where fabrics and their pictures are looked for first. Without one it is the folder of the design.</source>
        <translation>优先在此查找面料及其图片。未设置时为设计所在的文件夹。</translation>
    </message>
    <message>
        <source>Lengths are kept as they are, and shown to the nearest part; what is shorter than one has decimals.</source>
        <translation>长度保持原值，按最接近的分数显示；比一份更短的用小数。</translation>
    </message>
</context>
<context>
    <name>SavedViewCommands</name>
    <message>
        <source>&amp;Save view …</source>
        <translation>保存视图(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Delete view</source>
        <translation>删除视图(&amp;D)</translation>
    </message>
    <message>
        <source>View %1 deleted</source>
        <translation>视图 %1 已删除</translation>
    </message>
    <message>
        <source>Save view</source>
        <translation>保存视图</translation>
    </message>
    <message>
        <source>Name of the view; one of the same name is replaced:</source>
        <translation>视图名称；同名视图将被替换：</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>视图 %1</translation>
    </message>
    <message>
        <source>View %1 saved: View &gt; Saved views</source>
        <translation>视图 %1 已保存：视图 &gt; 已保存的视图</translation>
    </message>
</context>
<context>
    <name>ScanAlignTool</name>
    <message>
        <source>There is no point of the scan here: click on one.</source>
        <translation>此处没有扫描的点：请单击一个点。</translation>
    </message>
    <message>
        <source>There is neither a frame nor the cover here: click where that place of the scan belongs.</source>
        <translation>此处既无骨架也无面套：请单击扫描的该位置应在之处。</translation>
    </message>
    <message>
        <source>Take the last place &amp;back</source>
        <translation>撤回最后一个位置(&amp;B)</translation>
    </message>
    <message>
        <source>Click on the frame or the cover where place %1 of the scan belongs – Backspace takes it back</source>
        <translation>在骨架或面套上单击扫描位置 %1 应在之处——Backspace 撤回</translation>
    </message>
    <message>
        <source>Click on a place of the scan that can be told from others, such as a corner – drag turns the view, Esc ends the tool</source>
        <translation>单击扫描上易于辨认的位置，例如角——拖动旋转视图，Esc 结束工具</translation>
    </message>
    <message>
        <source>Click on place %1 of 3 of the scan, far from the others – Backspace takes one back</source>
        <translation>单击扫描的位置 %1（共 3 个），远离其他位置——Backspace 撤回一个</translation>
    </message>
    <message>
        <source>%1: where it belongs</source>
        <translation>%1：应在之处</translation>
    </message>
    <message>
        <source>%1: on the scan</source>
        <translation>%1：扫描上</translation>
    </message>
    <message>
        <source>The scan is no longer there – Esc ends the tool</source>
        <translation>扫描已不存在——Esc 结束工具</translation>
    </message>
</context>
<context>
    <name>ScanCommands</name>
    <message>
        <source>&amp;Place on the cover</source>
        <translation>对齐到面套(&amp;P)</translation>
    </message>
    <message>
        <source>Moves and turns the scan so that it lies on the cover as well as it can</source>
        <translation>移动并旋转扫描，使其尽量贴合面套</translation>
    </message>
    <message>
        <source>&amp;Cut away …</source>
        <translation>裁掉(&amp;C)…</translation>
    </message>
    <message>
        <source>Drag a rectangle in the 3D view over what is to be cut away of the scan</source>
        <translation>在三维视图中用矩形框出扫描要裁掉的部分</translation>
    </message>
    <message>
        <source>&amp;Keep only …</source>
        <translation>仅保留(&amp;K)…</translation>
    </message>
    <message>
        <source>Drag a rectangle in the 3D view around what is to be kept of the scan</source>
        <translation>在三维视图中用矩形框出扫描要保留的部分</translation>
    </message>
    <message>
        <source>Keep &amp;around the cover</source>
        <translation>保留面套周围(&amp;A)</translation>
    </message>
    <message>
        <source>Cuts away what is farther from the cover than the threshold</source>
        <translation>裁掉距面套超过阈值的部分</translation>
    </message>
    <message>
        <source>&amp;Remove all cuts</source>
        <translation>删除所有裁切(&amp;R)</translation>
    </message>
    <message>
        <source>Brings back all that was cut away of the scan</source>
        <translation>恢复扫描被裁掉的全部内容</translation>
    </message>
    <message>
        <source>Choose another &amp;file …</source>
        <translation>选择其他文件(&amp;F)…</translation>
    </message>
    <message>
        <source>Reads the scan from another file</source>
        <translation>从其他文件读取扫描</translation>
    </message>
    <message>
        <source>Select the scan that is meant.</source>
        <translation>请选择要处理的扫描。</translation>
    </message>
    <message>
        <source>Placing the scan on the cover …</source>
        <translation>正在将扫描对齐到面套…</translation>
    </message>
    <message>
        <source>Placing the scan on the cover: step %1</source>
        <translation>正在将扫描对齐到面套：第 %1 步</translation>
    </message>
    <message>
        <source>A&amp;lign …</source>
        <translation>三点对齐(&amp;L)…</translation>
    </message>
    <message>
        <source>Click three places of the scan and where each belongs; the rest is found</source>
        <translation>单击扫描的三个位置及各自应在之处；其余自动完成</translation>
    </message>
    <message>
        <source>Aligning the scan …</source>
        <translation>正在对齐扫描…</translation>
    </message>
    <message>
        <source>Aligning the scan: step %1</source>
        <translation>正在对齐扫描：第 %1 步</translation>
    </message>
</context>
<context>
    <name>ScanCutTool</name>
    <message>
        <source>Drag a rectangle around what is to be kept of the scan. Esc ends.</source>
        <translation>用矩形框出扫描要保留的部分。Esc 结束。</translation>
    </message>
    <message>
        <source>Drag a rectangle over what is to be cut away of the scan. Esc ends.</source>
        <translation>用矩形框出扫描要裁掉的部分。Esc 结束。</translation>
    </message>
</context>
<context>
    <name>ScanForm</name>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Place on &amp;the cover</source>
        <translation>对齐到面套(&amp;T)</translation>
    </message>
    <message>
        <source>Choose an&amp;other file …</source>
        <translation>选择其他文件(&amp;O)…</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 个点</translation>
    </message>
    <message>
        <source>%1 of %2 points, one every %3</source>
        <translation>%1 个点（共 %2 个），每 %3 一个</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>%1 rms</source>
        <translation>均方根 %1</translation>
    </message>
    <message>
        <source>Median, 95 %</source>
        <translation>中位数、95%</translation>
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
        <translation>覆盖率</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Floor at</source>
        <translation>地面位置</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>裁切</translation>
    </message>
    <message>
        <source>Cut awa&amp;y …</source>
        <translation>裁掉(&amp;Y)…</translation>
    </message>
    <message>
        <source>&amp;Keep only …</source>
        <translation>仅保留(&amp;K)…</translation>
    </message>
    <message>
        <source>Keep aroun&amp;d the cover</source>
        <translation>保留面套周围(&amp;D)</translation>
    </message>
    <message>
        <source>Remove a&amp;ll cuts</source>
        <translation>删除所有裁切(&amp;L)</translation>
    </message>
    <message>
        <source>Ali&amp;gn …</source>
        <translation>三点对齐(&amp;G)…</translation>
    </message>
    <message>
        <source>Between the cover and the scan, where they are nearer than the threshold.</source>
        <translation>面套与扫描之间，距离小于阈值之处。</translation>
    </message>
    <message>
        <source>Half of what is measured, and 95 % of it, is no farther from the scan than that.</source>
        <translation>测量值的一半、95% 距扫描不超过此值。</translation>
    </message>
    <message>
        <source>How much of the cover has points of the scan near it.</source>
        <translation>面套有多少部分附近有扫描的点。</translation>
    </message>
    <message>
        <source>Of the scan, without what is cut away.</source>
        <translation>扫描的点，不含被裁掉的部分。</translation>
    </message>
</context>
<context>
    <name>SeamForm</name>
    <message>
        <source>First side</source>
        <translation>第一侧</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Second side</source>
        <translation>第二侧</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>吃势</translation>
    </message>
</context>
<context>
    <name>SectionHandle</name>
    <message>
        <source>Section at %1 – Ctrl turns it by 15°, Escape puts it back</source>
        <translation>剖面位于 %1——Ctrl 每次旋转 15°，Esc 恢复</translation>
    </message>
    <message>
        <source>Drag to move the section, with Ctrl to turn it</source>
        <translation>拖动移动剖面，按住 Ctrl 旋转</translation>
    </message>
</context>
<context>
    <name>SelectedEdgesForm</name>
    <message>
        <source>Edge length</source>
        <translation>边的长度</translation>
    </message>
    <message>
        <source>Edge lengths</source>
        <translation>各边长度</translation>
    </message>
    <message>
        <source>%1 edges. Of &quot;Make equally long&quot; the first one stays: %2 of %3.</source>
        <translation>%1 条边。“设为等长”时第一条保持不变：%3 的 %2。</translation>
    </message>
    <message>
        <source>Edge of</source>
        <translation>所属样片</translation>
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
        <translation>布局 x, y</translation>
    </message>
    <message>
        <source>Length between</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>Space x, y, z</source>
        <translation>空间 x, y, z</translation>
    </message>
</context>
<context>
    <name>SelectionEdits</name>
    <message>
        <source>Not removed: the curve needs these points.</source>
        <translation>未删除：曲线需要这些点。</translation>
    </message>
    <message>
        <source>Not removed: other elements need this fabric.</source>
        <translation>未删除：其他元素需要此面料。</translation>
    </message>
    <message>
        <source>An edge cannot be removed: its points can, or with Esc the whole patch.</source>
        <translation>边不能删除：可删除其点，或按 Esc 后删除整个样片。</translation>
    </message>
</context>
<context>
    <name>SettingsForm</name>
    <message>
        <source>Patches</source>
        <translation>样片</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>接缝</translation>
    </message>
    <message>
        <source>Select something to see its properties.</source>
        <translation>选择对象以查看其属性。</translation>
    </message>
    <message>
        <source>Symmetric design</source>
        <translation>对称设计</translation>
    </message>
    <message>
        <source>Plane through</source>
        <translation>平面经过</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>法线</translation>
    </message>
    <message>
        <source>Axis through</source>
        <translation>轴经过</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>%1, %2 in all</source>
        <translation>%1，共 %2</translation>
    </message>
    <message>
        <source>A point of the plane in which the cover is mirrored</source>
        <translation>镜像面套所用平面上的一点</translation>
    </message>
    <message>
        <source>The direction straight out of that plane</source>
        <translation>垂直于该平面的方向</translation>
    </message>
    <message>
        <source>A point of the line of the pattern at which patches are mirrored</source>
        <translation>纸样中镜像样片所用直线上的一点</translation>
    </message>
    <message>
        <source>The direction of that line</source>
        <translation>该直线的方向</translation>
    </message>
    <message>
        <source>Twins are mirror images of each other. With this mark you say where the mirror stands; without it, it stands in the middle, between left and right.</source>
        <translation>镜像件互为镜像。勾选后由您指定镜面的位置；不勾选则位于左右正中。</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>约 %1</translation>
    </message>
    <message>
        <source>How many points the cover has at this edge length: solving takes time and memory for each.</source>
        <translation>在此边长下面套所含的点数：每个点都会占用求解的时间和内存。</translation>
    </message>
</context>
<context>
    <name>SewPicture</name>
    <message>
        <source>Ease %1, %2</source>
        <translation>吃势 %1，%2</translation>
    </message>
</context>
<context>
    <name>SewTool</name>
    <message>
        <source>Click on the outline of a patch.</source>
        <translation>请单击样片的轮廓。</translation>
    </message>
    <message>
        <source>Choose the other side first.</source>
        <translation>请先选择另一侧。</translation>
    </message>
    <message>
        <source>Release where the stretch ends</source>
        <translation>在区段终点处松开</translation>
    </message>
    <message>
        <source>Click where the stretch ends – Esc goes back</source>
        <translation>单击区段的终点——Esc 返回</translation>
    </message>
    <message>
        <source>Click to sew it the other way round (F)</source>
        <translation>单击以反方向缝合 (F)</translation>
    </message>
    <message>
        <source>Click the edge to sew – drag along the outline, or Shift+click twice, for a part of it; Esc ends the tool</source>
        <translation>单击要缝合的边——沿轮廓拖动或 Shift+单击两次取其一部分；Esc 结束工具</translation>
    </message>
    <message>
        <source>Click the edges of the row one after the other, Enter sews – F flips, Backspace takes one back</source>
        <translation>依次单击这一串边，Enter 缝合——F 翻转，Backspace 撤回一条</translation>
    </message>
    <message>
        <source>Click the edge it is sewn to – F flips, Ctrl+click or M for several in a row, Backspace goes back</source>
        <translation>单击与之缝合的边——F 翻转，Ctrl+单击或 M 取连续多条，Backspace 返回</translation>
    </message>
    <message>
        <source>Ctrl+click the next edge of the row, click the last one – Enter sews, F flips, Backspace takes one back</source>
        <translation>Ctrl+单击下一条边，单击最后一条——Enter 缝合，F 翻转，Backspace 撤回一条</translation>
    </message>
    <message>
        <source>&amp;Sew what is marked</source>
        <translation>缝合已标记的边(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>翻转(&amp;F)</translation>
    </message>
    <message>
        <source>Take &amp;one edge</source>
        <translation>取一条边(&amp;O)</translation>
    </message>
    <message>
        <source>Take se&amp;veral edges in a row</source>
        <translation>取连续多条边(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Take back the last edge</source>
        <translation>撤回最后一条边(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Give up</source>
        <translation>放弃(&amp;G)</translation>
    </message>
</context>
<context>
    <name>SewingSheet</name>
    <message>
        <source>Sewing sheet</source>
        <translation>缝制工艺单</translation>
    </message>
    <message>
        <source>Sewing sheet: %1</source>
        <translation>缝制工艺单：%1</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Seams in the order of sewing</source>
        <translation>接缝（按缝制顺序）</translation>
    </message>
    <message>
        <source>%1 and %1 mirrored</source>
        <translation>%1 片，镜像 %1 片</translation>
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
        <translation>裁片</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>面料</translation>
    </message>
    <message>
        <source>Area as cut</source>
        <translation>裁剪面积</translation>
    </message>
    <message>
        <source>top stitched on both sides</source>
        <translation>双侧明线</translation>
    </message>
    <message>
        <source>top stitched</source>
        <translation>明线</translation>
    </message>
    <message>
        <source>%1 mm long, %2 mm from the seam</source>
        <translation>针距 %1 mm，距接缝 %2 mm</translation>
    </message>
    <message>
        <source>piping, %1 mm thick</source>
        <translation>嵌线，粗 %1 mm</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>平缝</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 与 %2</translation>
    </message>
    <message>
        <source>%1, with itself</source>
        <translation>%1，与自身</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 与 %2</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>接缝</translation>
    </message>
    <message>
        <source>Lengths, mm</source>
        <translation>长度，mm</translation>
    </message>
    <message>
        <source>Allowance, mm</source>
        <translation>缝份，mm</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>剪口</translation>
    </message>
    <message>
        <source>Stitch</source>
        <translation>线迹</translation>
    </message>
    <message>
        <source>%1 m², without what lies between the pieces</source>
        <translation>%1 m²，不含裁片间的余料</translation>
    </message>
    <message>
        <source>Sewing thread</source>
        <translation>缝纫线</translation>
    </message>
    <message>
        <source>Top thread &lt;span style=&quot;background-color:%1&quot;&gt;&amp;nbsp;&amp;nbsp;&amp;nbsp;&amp;nbsp;&lt;/span&gt; %1</source>
        <translation>明线用线 &lt;span style=&quot;background-color:%1&quot;&gt;&#xa0;&#xa0;&#xa0;&#xa0;&lt;/span&gt; %1</translation>
    </message>
    <message>
        <source>%1 m, at %2 m for each metre of a row</source>
        <translation>%1 m，每米线迹 %2 m</translation>
    </message>
    <message>
        <source>Piping</source>
        <translation>嵌线</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>What</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>用量</translation>
    </message>
    <message>
        <source>zip</source>
        <translation>拉链</translation>
    </message>
    <message>
        <source>Zip</source>
        <translation>拉链</translation>
    </message>
    <message>
        <source>Pieces, with the numbers of their seams</source>
        <translation>裁片及其接缝编号</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>接缝</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Width × height as cut</source>
        <translation>裁剪宽 × 高</translation>
    </message>
    <message>
        <source>Ease, %</source>
        <translation>吃势，%</translation>
    </message>
    <message>
        <source>nap one way: all pieces point up</source>
        <translation>单向毛向：所有裁片朝上</translation>
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
        <translation>在轮廓上</translation>
    </message>
    <message>
        <source>Aligned</source>
        <translation>已对齐</translation>
    </message>
    <message>
        <source>Direction %1</source>
        <translation>方向 %1</translation>
    </message>
    <message>
        <source>Perpendicular</source>
        <translation>垂直</translation>
    </message>
    <message>
        <source>As long: %1</source>
        <translation>等长：%1</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>参考线</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>栅格</translation>
    </message>
</context>
<context>
    <name>StartCommands</name>
    <message>
        <source>Start pa&amp;ge</source>
        <translation>开始页(&amp;G)</translation>
    </message>
    <message>
        <source>New &amp;window</source>
        <translation>新建窗口(&amp;W)</translation>
    </message>
    <message>
        <source>No other window could be opened.</source>
        <translation>无法打开另一窗口。</translation>
    </message>
    <message>
        <source>The system did not start the program again. Close some programs, and try once more.</source>
        <translation>系统未能再次启动程序。请关闭一些程序后重试。</translation>
    </message>
    <message>
        <source>&amp;Report a problem …</source>
        <translation>报告问题(&amp;R)…</translation>
    </message>
    <message>
        <source>What&apos;s &amp;new</source>
        <translation>新增功能(&amp;N)</translation>
    </message>
    <message>
        <source>This is Bolster %1. What is new is under Help &gt; What&apos;s new.</source>
        <translation>这是 Bolster %1。新增功能见“帮助 &gt; 新增功能”。</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>显示(&amp;O)</translation>
    </message>
    <message>
        <source>The frame is in the 3D view. Draw the curves on it where the cloth is fixed, or the first patch.</source>
        <translation>骨架已在三维视图中。请在其上绘制固定布料的曲线，或绘制第一个样片。</translation>
    </message>
    <message>
        <source>Draw a &amp;fixation curve</source>
        <translation>绘制固定曲线(&amp;F)</translation>
    </message>
    <message>
        <source>Draw a &amp;rectangle</source>
        <translation>绘制矩形(&amp;R)</translation>
    </message>
    <message>
        <source>Pattern of a form …</source>
        <translation>由形体生成样板…</translation>
    </message>
</context>
<context>
    <name>StretchEndDrag</name>
    <message>
        <source>%1 long – Ctrl lets go of what is near, Esc takes it back</source>
        <translation>长 %1——Ctrl 脱离捕捉，Esc 还原</translation>
    </message>
    <message>
        <source>%1 long, the other side %2: ease %3, %4 – Ctrl lets go of what is near, Esc takes it back</source>
        <translation>长 %1，另一侧 %2：吃势 %3，%4——Ctrl 脱离捕捉，Esc 还原</translation>
    </message>
    <message>
        <source>End of another stretch</source>
        <translation>另一区段的端点</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>角点</translation>
    </message>
    <message>
        <source>As long as the other side</source>
        <translation>与另一侧等长</translation>
    </message>
</context>
<context>
    <name>SurfaceCommands</name>
    <message>
        <source>&amp;Pause</source>
        <translation>暂停(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Figures …</source>
        <translation>数据(&amp;F)…</translation>
    </message>
</context>
<context>
    <name>SweepWindow</name>
    <message>
        <source>&amp;Cut</source>
        <translation>裁剪(&amp;C)</translation>
    </message>
    <message>
        <source>Each piece is cut so much larger or smaller all around</source>
        <translation>每个样片四周裁得偏大或偏小的量</translation>
    </message>
    <message>
        <source>Cut of %1</source>
        <translation>%1 的裁剪</translation>
    </message>
    <message>
        <source>S&amp;eams</source>
        <translation>接缝(&amp;E)</translation>
    </message>
    <message>
        <source>Each seam is sewn so much farther inside or outside, on both sides</source>
        <translation>每条接缝在两侧偏内或偏外缝合的量</translation>
    </message>
    <message>
        <source>Seam %1</source>
        <translation>接缝 %1</translation>
    </message>
    <message>
        <source>&amp;Foam</source>
        <translation>泡沫(&amp;F)</translation>
    </message>
    <message>
        <source>Each cushion and foam is so much thicker or thinner</source>
        <translation>每个软垫和泡沫偏厚或偏薄的量</translation>
    </message>
    <message>
        <source>Thickness of %1</source>
        <translation>%1 的厚度</translation>
    </message>
    <message>
        <source>Fi&amp;xations</source>
        <translation>固定(&amp;X)</translation>
    </message>
    <message>
        <source>Each fixation curve lies so much elsewhere, along each axis</source>
        <translation>每条固定曲线沿各轴偏移的量</translation>
    </message>
    <message>
        <source>Place of %1</source>
        <translation>%1 的位置</translation>
    </message>
    <message>
        <source>S&amp;tiffness</source>
        <translation>刚度(&amp;T)</translation>
    </message>
    <message>
        <source>Each fabric is so much stiffer or softer</source>
        <translation>每种面料偏硬或偏软的程度</translation>
    </message>
    <message>
        <source>Stiffness of %1</source>
        <translation>%1 的刚度</translation>
    </message>
    <message>
        <source>Sh&amp;rinkage</source>
        <translation>收缩(&amp;R)</translation>
    </message>
    <message>
        <source>Each piece shrinks or stretches by so much</source>
        <translation>每个样片收缩或拉伸的程度</translation>
    </message>
    <message>
        <source>Shrinkage of %1</source>
        <translation>%1 的收缩</translation>
    </message>
</context>
<context>
    <name>Templates</name>
    <message>
        <source>Cushion</source>
        <translation>靠垫</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>圆枕</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>长凳</translation>
    </message>
    <message>
        <source>Dining chair</source>
        <translation>餐椅</translation>
    </message>
    <message>
        <source>Wing chair</source>
        <translation>翼背椅</translation>
    </message>
    <message>
        <source>Car seat</source>
        <translation>汽车座椅</translation>
    </message>
    <message>
        <source>Headrest</source>
        <translation>头枕</translation>
    </message>
</context>
<context>
    <name>ToolCommands</name>
    <message>
        <source>&amp;Select and move</source>
        <translation>选择和移动(&amp;S)</translation>
    </message>
    <message>
        <source>Draw &amp;outline</source>
        <translation>绘制轮廓(&amp;O)</translation>
    </message>
    <message>
        <source>Draw &amp;rectangle</source>
        <translation>绘制矩形(&amp;R)</translation>
    </message>
    <message>
        <source>Draw &amp;ellipse</source>
        <translation>绘制椭圆(&amp;E)</translation>
    </message>
    <message>
        <source>S&amp;plit patch</source>
        <translation>分割样片(&amp;P)</translation>
    </message>
    <message>
        <source>Draw &amp;handle curve</source>
        <translation>绘制操控曲线(&amp;H)</translation>
    </message>
    <message>
        <source>Draw &amp;fancy seam</source>
        <translation>绘制装饰缝(&amp;F)</translation>
    </message>
    <message>
        <source>Se&amp;w</source>
        <translation>缝合(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Attach to fixation curve</source>
        <translation>固定到固定曲线(&amp;A)</translation>
    </message>
    <message>
        <source>Stitch or pipe a seam</source>
        <translation>为接缝缉明线、加嵌线</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>测量(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Draw fixation curve</source>
        <translation>绘制固定曲线(&amp;D)</translation>
    </message>
    <message>
        <source>Draw &amp;internal line</source>
        <translation>绘制内部线(&amp;I)</translation>
    </message>
    <message>
        <source>Allowance of an ed&amp;ge</source>
        <translation>边的缝份(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Corner of the cut line</source>
        <translation>裁剪线角(&amp;C)</translation>
    </message>
    <message>
        <source>Place &amp;notches</source>
        <translation>放置剪口(&amp;N)</translation>
    </message>
    <message>
        <source>Place &amp;drill holes</source>
        <translation>放置钻孔(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Cutting</source>
        <translation>裁剪(&amp;C)</translation>
    </message>
    <message>
        <source>Draw &amp;dart</source>
        <translation>绘制省道(&amp;D)</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>&amp;Tour</source>
        <translation>导览(&amp;T)</translation>
    </message>
    <message>
        <source>The coloured curves on the frame are where the cloth is tied down. Click one of them, then drag one of its points: the cover follows.</source>
        <translation>骨架上的彩色曲线是布料固定之处。单击其中一条，再拖动其上一点：面套随之变化。</translation>
    </message>
    <message>
        <source>The cover follows while you drag, and comes to rest when you let go.</source>
        <translation>拖动时面套随之变化，松开后静止。</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>撤销操作</translation>
    </message>
    <message>
        <source>Ctrl+Z, or this button, takes back whatever was done, as far as you like. Nothing is lost by it: the history keeps what was undone, too.</source>
        <translation>Ctrl+Z 或此按钮可撤销已做的任何操作，步数不限。内容不会丢失：历史也保留已撤销的步骤。</translation>
    </message>
    <message>
        <source>It is as it was. Undone steps are still in the history.</source>
        <translation>已恢复原样。撤销的步骤仍在历史中。</translation>
    </message>
    <message>
        <source>Choose a seam</source>
        <translation>选择接缝</translation>
    </message>
    <message>
        <source>Seams join two edges of the pattern. Click one, in the pattern or on the cover: both of its edges light up, and the cover shows where it is.</source>
        <translation>接缝连接样板的两条边。在样板中或面套上单击一条：其两条边都会亮起，面套显示其位置。</translation>
    </message>
    <message>
        <source>Its properties are at the right now.</source>
        <translation>其属性现已显示在右侧。</translation>
    </message>
    <message>
        <source>Change how it is sewn</source>
        <translation>更改缝法</translation>
    </message>
    <message>
        <source>With the seam selected, choose another continuity in its properties, or another stitching: an edge, a rounded seam or a smooth one.</source>
        <translation>选中接缝后，在其属性中选择其他连续性或明线：有棱边、圆顺或平滑的接缝。</translation>
    </message>
    <message>
        <source>The cover shows the seam as it will be sewn.</source>
        <translation>面套按缝制后的样子显示接缝。</translation>
    </message>
    <message>
        <source>Look at the strain</source>
        <translation>查看应变</translation>
    </message>
    <message>
        <source>View &gt; Map colours the cover by what the cloth has to bear. Choose Largest strain to see where it is stretched most.</source>
        <translation>“视图 &gt; 云图”按布料的承受情况为面套着色。选择“最大应变”可查看拉伸最大之处。</translation>
    </message>
    <message>
        <source>The legend says how much, and the pointer reads it at any place.</source>
        <translation>图例显示大小，指针可读取任意位置的值。</translation>
    </message>
    <message>
        <source>Change the pattern</source>
        <translation>更改样板</translation>
    </message>
    <message>
        <source>Drag a point of an outline, or cut a dart (Pattern &gt; Draw dart): what you change in the flat is sewn at once.</source>
        <translation>拖动轮廓上的点，或绘制省道（“样板 &gt; 绘制省道”）：平面上的更改会立即缝合到面套。</translation>
    </message>
    <message>
        <source>Seams keep their places on an outline that changes.</source>
        <translation>轮廓更改时，接缝保持其位置。</translation>
    </message>
    <message>
        <source>Take it with you</source>
        <translation>带走成果</translation>
    </message>
    <message>
        <source>File &gt; Export pattern writes DXF, PDF or SVG with seam allowances and notches; Export cover writes the cover for others.</source>
        <translation>“文件 &gt; 导出样板”写出带缝份和剪口的 DXF、PDF 或 SVG；“导出面套”写出供他人使用的面套。</translation>
    </message>
    <message>
        <source>The file is written.</source>
        <translation>文件已写入。</translation>
    </message>
    <message>
        <source>That was the tour</source>
        <translation>导览结束</translation>
    </message>
    <message>
        <source>You have seen how pattern, seams and frame make the cover. Begin with a design of your own: File &gt; Start page has templates. What each key does is under Help &gt; Keys and mouse.</source>
        <translation>您已了解样板、接缝和骨架如何形成面套。现在开始自己的设计：“文件 &gt; 开始页”有模板。各按键的作用见“帮助 &gt; 键盘与鼠标”。</translation>
    </message>
    <message>
        <source>Drag a fixation curve</source>
        <translation>拖动固定曲线</translation>
    </message>
</context>
<context>
    <name>TrimSection</name>
    <message>
        <source>Stitching</source>
        <translation>明线</translation>
    </message>
    <message>
        <source>Colour of the thread</source>
        <translation>缝线颜色</translation>
    </message>
    <message>
        <source>Piping</source>
        <translation>嵌线</translation>
    </message>
    <message>
        <source>As the patch</source>
        <translation>同样片</translation>
    </message>
</context>
<context>
    <name>TwinCommands</name>
    <message>
        <source>Make &amp;mirror twin</source>
        <translation>创建镜像件(&amp;M)</translation>
    </message>
    <message>
        <source>Link as t&amp;wins</source>
        <translation>关联为镜像件(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Unlink twins</source>
        <translation>解除镜像关联(&amp;U)</translation>
    </message>
    <message>
        <source>R&amp;elease points from the twin</source>
        <translation>使点脱离镜像件(&amp;E)</translation>
    </message>
    <message>
        <source>Re-l&amp;ink points to the twin</source>
        <translation>重新关联点(&amp;I)</translation>
    </message>
    <message>
        <source>S&amp;ymmetry …</source>
        <translation>对称(&amp;Y)…</translation>
    </message>
    <message>
        <source>%1, mirrored</source>
        <translation>%1（镜像）</translation>
    </message>
    <message>
        <source>Select patches or curves that have no twin yet.</source>
        <translation>请选择还没有镜像件的样片或曲线。</translation>
    </message>
    <message>
        <source>Nothing that is selected has a twin.</source>
        <translation>所选内容都没有镜像件。</translation>
    </message>
    <message>
        <source>Select points of a twin, or a seam on it, that still follow.</source>
        <translation>请选择镜像件上仍跟随的点或接缝。</translation>
    </message>
    <message>
        <source>No point that is selected has been released.</source>
        <translation>所选的点均未脱离。</translation>
    </message>
</context>
<context>
    <name>TwinForm</name>
    <message>
        <source>Mirror image</source>
        <translation>镜像</translation>
    </message>
    <message>
        <source>released</source>
        <translation>已脱离</translation>
    </message>
    <message>
        <source>itself</source>
        <translation>自身</translation>
    </message>
    <message>
        <source>Re-lin&amp;k to its mirror image</source>
        <translation>重新关联到其镜像(&amp;K)</translation>
    </message>
    <message>
        <source>Re&amp;lease from its mirror image</source>
        <translation>脱离其镜像(&amp;L)</translation>
    </message>
    <message>
        <source>Twin of</source>
        <translation>镜像对象</translation>
    </message>
    <message>
        <source>Exceptions</source>
        <translation>例外</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message numerus="yes">
        <source>%n released points</source>
        <translation>
            <numerusform>%n 个脱离的点</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Unlink from its twin</source>
        <translation>解除与镜像件的关联(&amp;U)</translation>
    </message>
    <message>
        <source>Re-link all poi&amp;nts</source>
        <translation>重新关联所有点(&amp;N)</translation>
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
        <translation>问题</translation>
    </message>
    <message>
        <source>It keeps its text and is saved as it is.</source>
        <translation>保留其文本，原样保存。</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>Show &amp;all</source>
        <translation>显示全部(&amp;A)</translation>
    </message>
    <message>
        <source>Show &amp;selection</source>
        <translation>显示所选(&amp;S)</translation>
    </message>
    <message>
        <source>Look at the &amp;cover from</source>
        <translation>面套观察方向(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>前(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>后(&amp;B)</translation>
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
        <translation>斜视(&amp;Q)</translation>
    </message>
    <message>
        <source>Sa&amp;ved views</source>
        <translation>已保存的视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>透视(&amp;P)</translation>
    </message>
    <message>
        <source>Sec&amp;tion</source>
        <translation>剖面(&amp;T)</translation>
    </message>
    <message>
        <source>Lin&amp;k the views</source>
        <translation>联动视图(&amp;K)</translation>
    </message>
    <message>
        <source>Show the pointer&apos;s place in the other view, too</source>
        <translation>在另一视图中也显示指针所在位置</translation>
    </message>
    <message>
        <source>&amp;Hide selected</source>
        <translation>隐藏所选(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Isolate selected</source>
        <translation>仅显示所选(&amp;I)</translation>
    </message>
    <message>
        <source>Sho&amp;w hidden again</source>
        <translation>重新显示隐藏内容(&amp;W)</translation>
    </message>
    <message>
        <source>Th&amp;eme</source>
        <translation>主题(&amp;E)</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>跟随系统(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>深色(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Opacity</source>
        <translation>不透明度(&amp;O)</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>Frames and foam</source>
        <translation>骨架和泡沫</translation>
    </message>
    <message>
        <source>Scans</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>Opacity of frames and scans</source>
        <translation>骨架和扫描的不透明度</translation>
    </message>
    <message>
        <source>Select patches, curves, frames, foam or scans to hide them.</source>
        <translation>选择要隐藏的样片、曲线、骨架、泡沫或扫描。</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>高对比度(&amp;H)</translation>
    </message>
</context>
<context>
    <name>ViewPrint</name>
    <message>
        <source>Print the view</source>
        <translation>打印视图</translation>
    </message>
    <message>
        <source>The view could not be printed.</source>
        <translation>无法打印视图。</translation>
    </message>
    <message>
        <source>The printer takes nothing at the moment. Look whether it is on and has paper, or print to a file.</source>
        <translation>打印机目前不接收任务。请检查是否已开机并有纸，或打印到文件。</translation>
    </message>
</context>
<context>
    <name>WhatsNew</name>
    <message>
        <source>What&apos;s new</source>
        <translation>新增功能</translation>
    </message>
</context>
<context>
    <name>WindowCommands</name>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>窗口的下一部分(&amp;N)</translation>
    </message>
    <message>
        <source>Pre&amp;vious part of the window</source>
        <translation>窗口的上一部分(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>重置布局(&amp;R)</translation>
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
        <translation>仅在涂出的区域(&amp;Y)</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>涂抹</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>The form and the limit of strain count only there</source>
        <translation>形体和应变上限只在那里起作用</translation>
    </message>
    <message>
        <source>Drag over the cover in the 3D view; with Shift held down it takes away</source>
        <translation>在三维视图中的面套上拖动；按住 Shift 则擦除</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>画笔半径</translation>
    </message>
    <message>
        <source>Painted area</source>
        <translation>涂出的区域</translation>
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
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>bolster::CanvasChoice</name>
    <message>
        <source>Drawn in software</source>
        <translation>软件绘制</translation>
    </message>
</context>
<context>
    <name>bolster::CauseWindow</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Why is it so?</source>
        <translation>为何如此？</translation>
    </message>
    <message>
        <source>The scan of the piece</source>
        <translation>实物的扫描</translation>
    </message>
    <message>
        <source>The scan of a sound piece</source>
        <translation>合格件的扫描</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Of a piece that is as it should be: where that lies elsewhere than the cover no cause is looked for</source>
        <translation>合格件即符合要求的一件：其与面套不一致之处不再查找原因</translation>
    </message>
    <message>
        <source>Scan of the &amp;piece</source>
        <translation>实物的扫描(&amp;P)</translation>
    </message>
    <message>
        <source>Scan of a so&amp;und piece</source>
        <translation>合格件的扫描(&amp;U)</translation>
    </message>
    <message>
        <source>Look for the &amp;cause</source>
        <translation>查找原因(&amp;C)</translation>
    </message>
    <message>
        <source>Looking for a cause …</source>
        <translation>正在查找原因…</translation>
    </message>
    <message>
        <source>Says which one cause explains best how far a built piece lies from the cover: foam, a seam&apos;s allowance, a stretched piece, a fixation off its place, a slipped notch.</source>
        <translation>说明哪一个原因最能解释实物与面套的距离：泡沫、接缝的缝份、样片被拉伸、固定偏移、剪口错位。</translation>
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
        <translation>解释比例</translation>
    </message>
    <message>
        <source>Probability</source>
        <translation>概率</translation>
    </message>
    <message>
        <source>Causes</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Choose the scan of the piece that was built.</source>
        <translation>请选择实物的扫描。</translation>
    </message>
    <message>
        <source>Covers with each cause are solved …</source>
        <translation>正在求解含各原因的面套…</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>The scan shows nothing of the cover: does it lie where the design is?</source>
        <translation>扫描中没有面套的任何部分：其位置与设计一致吗？</translation>
    </message>
    <message>
        <source>The scan shows %1 of the cover and lies %2 (rms) from it. All causes together leave %3.</source>
        <translation>扫描覆盖面套的 %1，与其相距 %2（均方根）。计入所有原因后剩余 %3。</translation>
    </message>
    <message>
        <source>No single cause explains that better than noise does.</source>
        <translation>没有单一原因比噪声更能解释。</translation>
    </message>
    <message>
        <source>Most of the deviation has no cause of these kinds, so the first need not be the right one: give the scan of a sound piece, too.</source>
        <translation>大部分偏差不属于这几类原因，因此首个原因未必正确：请同时提供合格件的扫描。</translation>
    </message>
    <message numerus="yes">
        <source>and %n others</source>
        <translation>
            <numerusform>及其他 %n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>The scan does not tell it apart from: %1</source>
        <translation>扫描无法将其与以下原因区分：%1</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: look again.</source>
        <translation>设计在此期间已更改：请重新查找。</translation>
    </message>
    <message>
        <source>Stopped. The list is that of the search before.</source>
        <translation>已停止。列表是上一次查找的结果。</translation>
    </message>
    <message>
        <source>The scan lies on the cover: there is nothing to explain.</source>
        <translation>扫描与面套重合：没有需要解释的。</translation>
    </message>
    <message>
        <source>Even the likeliest cause explains only %1 of it: there may be several, or others than these.</source>
        <translation>即使最可能的原因也只能解释其中的 %1：可能有多个原因，或是其他原因。</translation>
    </message>
    <message>
        <source>Foam is thicker or thinner</source>
        <translation>泡沫偏厚或偏薄</translation>
    </message>
    <message>
        <source>Foam is harder or softer</source>
        <translation>泡沫偏硬或偏软</translation>
    </message>
    <message>
        <source>Allowance of a seam</source>
        <translation>接缝的缝份</translation>
    </message>
    <message>
        <source>Piece is larger or smaller</source>
        <translation>样片偏大或偏小</translation>
    </message>
    <message>
        <source>Fixation lies elsewhere</source>
        <translation>固定位置偏移</translation>
    </message>
    <message>
        <source>Seam is sewn shifted</source>
        <translation>接缝错位缝合</translation>
    </message>
    <message>
        <source>%1 thicker</source>
        <translation>厚 %1</translation>
    </message>
    <message>
        <source>%1 thinner</source>
        <translation>薄 %1</translation>
    </message>
    <message>
        <source>%1 harder</source>
        <translation>硬 %1</translation>
    </message>
    <message>
        <source>%1 softer</source>
        <translation>软 %1</translation>
    </message>
    <message>
        <source>%1 farther out</source>
        <translation>偏外 %1</translation>
    </message>
    <message>
        <source>%1 farther in</source>
        <translation>偏内 %1</translation>
    </message>
    <message>
        <source>%1 larger</source>
        <translation>大 %1</translation>
    </message>
    <message>
        <source>%1 smaller</source>
        <translation>小 %1</translation>
    </message>
    <message>
        <source>%1 counter-clockwise</source>
        <translation>逆时针 %1</translation>
    </message>
    <message>
        <source>%1 clockwise</source>
        <translation>顺时针 %1</translation>
    </message>
    <message>
        <source>Farther out: the allowance was taken narrower, on both sides</source>
        <translation>偏外：两侧的缝份都取得较窄</translation>
    </message>
    <message>
        <source>Along the edge of %1, as it lies in the pattern</source>
        <translation>沿 %1 的边，按其在样板中的放置方向</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>低于 %1</translation>
    </message>
    <message>
        <source>The scan shows %1 of the cover. Its points lie %2 (rms) from the cover, of which all causes together leave %3. From the cover to the nearest point, as a fit measures, it is %4.</source>
        <translation>扫描覆盖面套的 %1。其点与面套相距 %2（均方根），计入所有原因后剩余 %3。按拟合的度量，从面套到最近点为 %4。</translation>
    </message>
    <message>
        <source>That is far more than such a cause usually is: there may be several, or others than these.</source>
        <translation>这远大于此类原因的通常程度：可能有多个原因，或是其他原因。</translation>
    </message>
    <message>
        <source>What the likeliest cause leaves is more than noise: something else may be wrong, too, and its amount may be off by more than is said.</source>
        <translation>最可能的原因未能解释的部分大于噪声：可能还有别的问题，其数值的偏差可能比所示的更大。</translation>
    </message>
    <message numerus="yes">
        <source>%n more causes explain some of it, less likely than these.</source>
        <translation>
            <numerusform>另有 %n 个原因也能解释其中一部分，但可能性低于以上各项。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::ColourwayWindow</name>
    <message>
        <source>Compare colourways</source>
        <translation>比较配色</translation>
    </message>
    <message>
        <source>The colourway that is shown below</source>
        <translation>下方显示的配色</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>原样</translation>
    </message>
</context>
<context>
    <name>bolster::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>查找命令</translation>
    </message>
    <message>
        <source>There is no such command.</source>
        <translation>没有这样的命令。</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
</context>
<context>
    <name>bolster::CompareWindow</name>
    <message>
        <source>&amp;Take from there</source>
        <translation>采用该版本(&amp;T)</translation>
    </message>
    <message>
        <source>Compare versions</source>
        <translation>比较版本</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>There</source>
        <translation>该版本</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Makes the chosen elements as they are in the other version: one step in the history</source>
        <translation>使所选元素与另一版本中一致：历史中的一步</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>only now</source>
        <translation>仅当前有</translation>
    </message>
    <message>
        <source>only there</source>
        <translation>仅该版本有</translation>
    </message>
    <message>
        <source>Nothing differs</source>
        <translation>没有差异</translation>
    </message>
    <message>
        <source>&amp;Move both together</source>
        <translation>两者同步移动(&amp;M)</translation>
    </message>
    <message>
        <source>Turning, moving or zooming one version does the same to the other</source>
        <translation>旋转、平移或缩放一个版本时，另一个同步</translation>
    </message>
</context>
<context>
    <name>bolster::ContextMenus</name>
    <message>
        <source>Leave this &amp;piece out</source>
        <translation>略去此块(&amp;P)</translation>
    </message>
    <message>
        <source>Hides this piece of the frame from the view, drawing, cushioning and contact; the frame&apos;s properties bring it back</source>
        <translation>在视图、绘图、软垫和接触中隐藏骨架的此块；可在骨架属性中恢复</translation>
    </message>
</context>
<context>
    <name>bolster::CoverSelectTool</name>
    <message>
        <source>Kept to an axis; the same key frees it</source>
        <translation>限于一个轴；再按同一键解除</translation>
    </message>
    <message>
        <source>Lifted off the frame along its normal; let go of Ctrl to slide on it</source>
        <translation>沿法线抬离骨架；松开 Ctrl 在其上滑动</translation>
    </message>
    <message>
        <source>On the frame: Ctrl lifts off, S lets go of it, X, Y, Z or Shift keep to an axis</source>
        <translation>在骨架上：Ctrl 抬离，S 脱离，X、Y、Z 或 Shift 限于一个轴</translation>
    </message>
    <message>
        <source>X, Y, Z or Shift keep to an axis, S keeps to the frame, Ctrl lifts off, Escape cancels</source>
        <translation>X、Y、Z 或 Shift 限于一个轴，S 留在骨架上，Ctrl 抬离，Esc 取消</translation>
    </message>
    <message>
        <source>Moved by x %1, y %2, z %3</source>
        <translation>已移动 x %1，y %2，z %3</translation>
    </message>
</context>
<context>
    <name>bolster::CutFindingsList</name>
    <message>
        <source>What to look at before cutting</source>
        <translation>裁剪前需查看的内容</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>bolster::CuttingPanel</name>
    <message>
        <source>A double click shows where it is.</source>
        <translation>双击可显示所在位置。</translation>
    </message>
    <message>
        <source>Nothing to mend: the pattern can be cut.</source>
        <translation>无需修正：样板可以裁剪。</translation>
    </message>
    <message>
        <source>Looking the pattern over …</source>
        <translation>正在检查样板…</translation>
    </message>
    <message>
        <source>There is no pattern yet.</source>
        <translation>还没有样板。</translation>
    </message>
</context>
<context>
    <name>bolster::DesignSession</name>
    <message>
        <source>New design</source>
        <translation>新设计</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>面料</translation>
    </message>
    <message>
        <source>Restored design</source>
        <translation>恢复的设计</translation>
    </message>
    <message>
        <source> (other)</source>
        <translation> (其他)</translation>
    </message>
    <message>
        <source> (other %1)</source>
        <translation> (其他 %1)</translation>
    </message>
</context>
<context>
    <name>bolster::DockTitle</name>
    <message>
        <source>Take out of the window, or put back</source>
        <translation>从窗口中取出或放回</translation>
    </message>
    <message>
        <source>Close; the Window menu brings it back</source>
        <translation>关闭；可在“窗口”菜单中重新打开</translation>
    </message>
</context>
<context>
    <name>bolster::DropFlow</name>
    <message>
        <source>&quot;%1&quot; cannot be opened.</source>
        <translation>无法打开“%1”。</translation>
    </message>
    <message>
        <source>The system did not start the program again for another window. Open it from here instead.</source>
        <translation>系统未能为另一窗口再次启动程序。请改为在此处打开。</translation>
    </message>
    <message>
        <source>It is a folder. Drop the files that are in it.</source>
        <translation>这是文件夹。请拖入其中的文件。</translation>
    </message>
    <message>
        <source>It is not on this computer, or not any more. Save it to a folder first.</source>
        <translation>它不在此电脑上，或已不存在。请先将其保存到文件夹。</translation>
    </message>
    <message>
        <source>Bolster opens projects and designs (%1), frames (%2), scans (%3), patterns (%4) and pictures of fabrics (%5). Save it in one of these formats with the program it comes from.</source>
        <translation>Bolster 可打开项目和设计 (%1)、骨架 (%2)、扫描 (%3)、样板 (%4) 和面料图片 (%5)。请用来源程序将其保存为其中一种格式。</translation>
    </message>
</context>
<context>
    <name>bolster::ElementsModel</name>
    <message>
        <source>Hidden in the 3D view</source>
        <translation>在三维视图中隐藏</translation>
    </message>
</context>
<context>
    <name>bolster::ElementsView</name>
    <message>
        <source>Find an element</source>
        <translation>查找元素</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>元素</translation>
    </message>
    <message>
        <source>By its name, or by a word of its note</source>
        <translation>按名称或备注中的词</translation>
    </message>
</context>
<context>
    <name>bolster::ExportFlow</name>
    <message>
        <source>Export pattern</source>
        <translation>导出样板</translation>
    </message>
    <message>
        <source>-sewing</source>
        <translation>-工艺单</translation>
    </message>
    <message>
        <source>-pattern</source>
        <translation>-样板</translation>
    </message>
    <message>
        <source>%1 (*.%2)</source>
        <translation>%1 (*.%2)</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>正在写入 %1…</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>已导出到 %1</translation>
    </message>
    <message>
        <source>The pattern could not be exported.</source>
        <translation>无法导出样板。</translation>
    </message>
    <message>
        <source>Export cover</source>
        <translation>导出面套</translation>
    </message>
    <message>
        <source>-cover</source>
        <translation>-面套</translation>
    </message>
    <message>
        <source>Export foam</source>
        <translation>导出泡沫体</translation>
    </message>
    <message>
        <source>-foam</source>
        <translation>-泡沫</translation>
    </message>
    <message>
        <source>Exporting %1 …</source>
        <translation>正在导出 %1…</translation>
    </message>
    <message>
        <source>The cover could not be exported.</source>
        <translation>无法导出面套。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is written.</source>
        <translation>已写入“%1”。</translation>
    </message>
    <message>
        <source>Export surface</source>
        <translation>导出曲面</translation>
    </message>
    <message>
        <source>The surface could not be exported.</source>
        <translation>无法导出曲面。</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>导出图片</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>The picture could not be exported.</source>
        <translation>无法导出图片。</translation>
    </message>
    <message>
        <source>-surface</source>
        <translation>-曲面</translation>
    </message>
</context>
<context>
    <name>bolster::ExportPatternDialog</name>
    <message>
        <source>Export pattern</source>
        <translation>导出样板</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>样片</translation>
    </message>
    <message>
        <source>&amp;Export …</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>PDF – to print and put together</source>
        <translation>PDF——用于打印拼接</translation>
    </message>
    <message>
        <source>DXF AAMA – for cutters</source>
        <translation>DXF AAMA——用于裁床</translation>
    </message>
    <message>
        <source>DXF ASTM – for cutters</source>
        <translation>DXF ASTM——用于裁床</translation>
    </message>
    <message>
        <source>DXF, plain lines</source>
        <translation>DXF，普通线</translation>
    </message>
    <message>
        <source>SVG – 1:1</source>
        <translation>SVG——1:1</translation>
    </message>
    <message>
        <source>HPGL – for plotters</source>
        <translation>HPGL——用于绘图仪</translation>
    </message>
    <message>
        <source>Roll, %1 mm wide</source>
        <translation>卷材，宽 %1 mm</translation>
    </message>
    <message>
        <source>&amp;Landscape</source>
        <translation>横向(&amp;L)</translation>
    </message>
    <message>
        <source>Mirrored pairs as &amp;two pieces</source>
        <translation>镜像成对作为两个样片(&amp;T)</translation>
    </message>
    <message>
        <source>The design says it; it is changed in its properties.</source>
        <translation>由设计决定；可在其属性中更改。</translation>
    </message>
    <message>
        <source>Of patches and edges that have none of their own.</source>
        <translation>用于没有自有设置的样片和边。</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>格式(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Paper</source>
        <translation>纸张(&amp;P)</translation>
    </message>
    <message>
        <source>Seam &amp;allowance</source>
        <translation>缝份(&amp;A)</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>线</translation>
    </message>
    <message>
        <source>Sewing li&amp;nes</source>
        <translation>缝合线(&amp;N)</translation>
    </message>
    <message>
        <source>Notc&amp;hes</source>
        <translation>剪口(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Grain lines</source>
        <translation>布纹线(&amp;G)</translation>
    </message>
    <message>
        <source>La&amp;bels</source>
        <translation>标签(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Internal lines</source>
        <translation>内部线(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Drill holes</source>
        <translation>钻孔(&amp;D)</translation>
    </message>
    <message numerus="yes">
        <source>%n pages</source>
        <translation>
            <numerusform>%n 页</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n patches are left out: their outlines cross themselves</source>
        <translation>
            <numerusform>略去 %n 个样片：其轮廓与自身相交</numerusform>
        </translation>
    </message>
    <message>
        <source>C&amp;ut lines</source>
        <translation>裁剪线(&amp;U)</translation>
    </message>
    <message>
        <source>Sewing sheet (PDF)</source>
        <translation>缝制工艺单 (PDF)</translation>
    </message>
    <message>
        <source>DXF, plain curves (R2000)</source>
        <translation>DXF，普通曲线 (R2000)</translation>
    </message>
    <message>
        <source>too many sheets: is its unit right?</source>
        <translation>纸张过多：单位是否正确？</translation>
    </message>
    <message>
        <source>the first %1 are shown</source>
        <translation>显示前 %1 张</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>没有可裁剪的内容。</translation>
    </message>
    <message>
        <source>A double click leaves this window and shows where it is; the whole list is in the panel &quot;Check before cutting&quot;.</source>
        <translation>双击将离开此窗口并显示所在位置；完整列表在“裁剪前检查”面板中。</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces on %1</source>
        <translation>
            <numerusform>%n 个样片，%1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FabricCommands</name>
    <message>
        <source>Rename fabric</source>
        <translation>重命名面料</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>名称：</translation>
    </message>
    <message>
        <source>Delete fabric</source>
        <translation>删除面料</translation>
    </message>
    <message numerus="yes">
        <source>%n patches have &quot;%1&quot;. What shall they get instead?</source>
        <translation>
            <numerusform>%n 个样片使用“%1”。改用什么？</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the patches that shall get the fabric, then choose it in the library.</source>
        <translation>请先选择要赋予面料的样片，再在面料库中选择面料。</translation>
    </message>
    <message>
        <source>New colourway</source>
        <translation>新建配色</translation>
    </message>
    <message>
        <source>Name of the colourway; it begins as what is shown now:</source>
        <translation>配色名称；以当前显示为初始内容：</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>配色</translation>
    </message>
    <message>
        <source>Rename colourway</source>
        <translation>重命名配色</translation>
    </message>
    <message>
        <source>Picture of a fabric</source>
        <translation>面料图片</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>图片 (%1)</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>正在读取 %1…</translation>
    </message>
    <message>
        <source>The picture could not be read.</source>
        <translation>无法读取图片。</translation>
    </message>
    <message>
        <source>The picture could not be taken into the design.</source>
        <translation>无法将图片纳入设计。</translation>
    </message>
    <message>
        <source>Import fabrics</source>
        <translation>导入面料</translation>
    </message>
    <message>
        <source>Fabrics, designs and projects (*.json *.bolster)</source>
        <translation>面料、设计和项目 (*.json *.bolster)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be read.</source>
        <translation>无法读取“%1”。</translation>
    </message>
    <message>
        <source>Nothing was imported.</source>
        <translation>未导入任何内容。</translation>
    </message>
    <message numerus="yes">
        <source>%n fabrics imported from %1</source>
        <translation>
            <numerusform>已从 %1 导入 %n 种面料</numerusform>
        </translation>
    </message>
    <message>
        <source>Export fabric</source>
        <translation>导出面料</translation>
    </message>
    <message>
        <source>Fabrics (*.json)</source>
        <translation>面料 (*.json)</translation>
    </message>
    <message>
        <source>The fabric could not be exported.</source>
        <translation>无法导出面料。</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>已导出到 %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not deleted.</source>
        <translation>未删除“%1”。</translation>
    </message>
    <message>
        <source>It is the only fabric, and patches are made of it. Add another one first.</source>
        <translation>这是唯一的面料，且有样片使用。请先添加其他面料。</translation>
    </message>
</context>
<context>
    <name>bolster::FabricPanel</name>
    <message>
        <source>Colourways</source>
        <translation>配色</translation>
    </message>
    <message>
        <source>A click shows the cover in this colourway</source>
        <translation>单击以此配色显示面套</translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation>面料</translation>
    </message>
    <message>
        <source>Colourway</source>
        <translation>配色</translation>
    </message>
    <message>
        <source>New …</source>
        <translation>新建…</translation>
    </message>
    <message>
        <source>Rename …</source>
        <translation>重命名…</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Fabrics: drag them onto patches</source>
        <translation>面料：拖到样片上</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新建</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>赋予</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Delete …</source>
        <translation>删除…</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>原样</translation>
    </message>
    <message>
        <source>No patch has it.</source>
        <translation>没有样片使用。</translation>
    </message>
    <message numerus="yes">
        <source>%n patches have it.</source>
        <translation>
            <numerusform>%n 个样片使用。</numerusform>
        </translation>
    </message>
    <message>
        <source>Drag it onto a patch; a double click shows its properties.</source>
        <translation>拖到样片上；双击显示其属性。</translation>
    </message>
    <message>
        <source>Adds this fabric to the library of the design</source>
        <translation>将此面料添加到设计的面料库</translation>
    </message>
</context>
<context>
    <name>bolster::FieldText</name>
    <message>
        <source>usual</source>
        <translation>常用</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>turned by %1</source>
        <translation>旋转 %1</translation>
    </message>
    <message>
        <source>%1, from %2 to %3</source>
        <translation>%1，从 %2 到 %3</translation>
    </message>
    <message numerus="yes">
        <source>%n points, %1</source>
        <translation>
            <numerusform>%n 个点，%1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FileChoice</name>
    <message>
        <source>A file …</source>
        <translation>文件…</translation>
    </message>
</context>
<context>
    <name>bolster::FileImportDialog</name>
    <message>
        <source> mm per unit</source>
        <translation> mm/单位</translation>
    </message>
    <message>
        <source>Import scan</source>
        <translation>导入扫描</translation>
    </message>
    <message>
        <source>Import frame</source>
        <translation>导入骨架</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>厘米</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>米</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>Another factor</source>
        <translation>其他系数</translation>
    </message>
    <message>
        <source>z points up</source>
        <translation>z 轴向上</translation>
    </message>
    <message>
        <source>y points up</source>
        <translation>y 轴向上</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 个点</translation>
    </message>
    <message>
        <source>Width, depth, height</source>
        <translation>宽、深、高</translation>
    </message>
    <message>
        <source>That is unusual for a piece of furniture: check the unit.</source>
        <translation>这对家具而言不常见：请检查单位。</translation>
    </message>
    <message>
        <source>&amp;Keep scale, position and rotation</source>
        <translation>保持比例、位置和旋转(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Place it on the floor, in the middle</source>
        <translation>放在地面中央(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>文件单位(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Factor</source>
        <translation>系数(&amp;F)</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>坐标轴(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>导入(&amp;I)</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>It would be %1 large. Import it like that?</source>
        <translation>大小将为 %1。这样导入吗？</translation>
    </message>
    <message>
        <source>Another unit or factor makes it as large as it is meant.</source>
        <translation>换用其他单位或系数可得到预期大小。</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>英尺</translation>
    </message>
    <message>
        <source>x points up</source>
        <translation>x 轴向上</translation>
    </message>
    <message>
        <source>The file says its unit and its axes.</source>
        <translation>文件给出了单位和坐标轴。</translation>
    </message>
    <message numerus="yes">
        <source>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 points, %Ln triangles</source>
        <translation>
            <numerusform>&lt;b&gt;%1&lt;/b&gt;&lt;br&gt;%2 个点，%Ln 个三角形</numerusform>
        </translation>
    </message>
    <message>
        <source>The file says its unit; the axes are guessed.</source>
        <translation>文件给出了单位；坐标轴为推测。</translation>
    </message>
    <message>
        <source>The file says its axes; the unit is guessed.</source>
        <translation>文件给出了坐标轴；单位为推测。</translation>
    </message>
    <message>
        <source>Unit and axes are guessed: look at the picture and the size.</source>
        <translation>单位和坐标轴均为推测：请查看图片和尺寸。</translation>
    </message>
    <message>
        <source>&amp;Keep position and rotation</source>
        <translation>保持位置和旋转(&amp;K)</translation>
    </message>
    <message>
        <source>The file has %1 points. That is more than are needed to fit a cover, so they were thinned out to one every %2.</source>
        <translation>文件有 %1 个点，超过贴合面套所需，因此已抽稀为每 %2 一个点。</translation>
    </message>
    <message>
        <source>It was %1 large and becomes %2: check the unit.</source>
        <translation>原来大小为 %1，现为 %2：请检查单位。</translation>
    </message>
    <message>
        <source>The unit is guessed: look at the size.</source>
        <translation>单位是猜测的：请查看尺寸。</translation>
    </message>
    <message>
        <source>The axes are guessed: look at the picture.</source>
        <translation>坐标轴是猜测的：请查看图片。</translation>
    </message>
</context>
<context>
    <name>bolster::FileTalk</name>
    <message>
        <source>&quot;%1&quot; is not replaced.</source>
        <translation>未替换“%1”。</translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>正在读取 %1…</translation>
    </message>
</context>
<context>
    <name>bolster::FitOrderPanel</name>
    <message>
        <source>Goal</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>The cover &amp;lies on</source>
        <translation>面套贴合(&amp;L)</translation>
    </message>
    <message>
        <source>The form that the cover shall lie on</source>
        <translation>面套要贴合的形体</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>形体</translation>
    </message>
    <message>
        <source>&amp;Strain is at most</source>
        <translation>应变不超过(&amp;S)</translation>
    </message>
    <message>
        <source>Along the grain, across it, and in shear; the cover stays where it is</source>
        <translation>沿布纹、横布纹和剪切；面套保持原位</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Limit of strain</source>
        <translation>应变极限</translation>
    </message>
    <message>
        <source>&amp;No folds in selected patches</source>
        <translation>所选样片无褶皱(&amp;N)</translation>
    </message>
    <message>
        <source>No cloth of them is pressed together; none selected: all</source>
        <translation>其布料不受挤压；未选择时：全部</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>The selected seam r&amp;uns along</source>
        <translation>所选接缝沿曲线(&amp;U)</translation>
    </message>
    <message>
        <source>A curve drawn on the frame or the form; it need hold nothing</source>
        <translation>在骨架或形体上绘制的曲线；无需起固定作用</translation>
    </message>
    <message>
        <source>Share of the area</source>
        <translation>面积比例</translation>
    </message>
    <message>
        <source>Area of selected patches &amp;becomes</source>
        <translation>所选样片保留面积(&amp;K)</translation>
    </message>
    <message>
        <source>Less than 100 %: they become smaller</source>
        <translation>小于 100%：样片变小</translation>
    </message>
    <message>
        <source>What may change</source>
        <translation>允许更改</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>轮廓(&amp;O)</translation>
    </message>
    <message>
        <source>Control points of the patches</source>
        <translation>样片的控制点</translation>
    </message>
    <message>
        <source>Ends of seams</source>
        <translation>接缝端点</translation>
    </message>
    <message>
        <source>Where seams and fixations end on smooth edges</source>
        <translation>接缝和固定在平滑边上的端点位置</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>吃势</translation>
    </message>
    <message>
        <source>Sides of seams may come to differ in length; that is then the ease wanted</source>
        <translation>接缝两侧长度可以变得不同；差值即为所需吃势</translation>
    </message>
    <message>
        <source>Fo&amp;am</source>
        <translation>泡沫(&amp;A)</translation>
    </message>
    <message>
        <source>How thick cushions and foam are, by whole voxels</source>
        <translation>软垫和泡沫的厚度，以整数个体素计</translation>
    </message>
    <message>
        <source>F&amp;ixations</source>
        <translation>固定(&amp;I)</translation>
    </message>
    <message>
        <source>Where fixation curves lie: on their frames, or in space where there is none</source>
        <translation>固定曲线的位置：在骨架上，没有骨架时在空间中</translation>
    </message>
    <message>
        <source>&amp;Pressure</source>
        <translation>压力(&amp;P)</translation>
    </message>
    <message>
        <source>The pressure under each patch</source>
        <translation>各样片下的压力</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>弹性</translation>
    </message>
    <message>
        <source>Stiffness of the fabrics, and how much they contract across a pull</source>
        <translation>面料的刚度，以及受拉时横向收缩多少</translation>
    </message>
    <message>
        <source>Of sele&amp;cted patches only</source>
        <translation>仅所选样片(&amp;C)</translation>
    </message>
    <message>
        <source>What stays</source>
        <translation>保持不变</translation>
    </message>
    <message>
        <source>L&amp;engths of seams</source>
        <translation>接缝长度(&amp;E)</translation>
    </message>
    <message>
        <source>The sides of a seam keep their difference; if it is far from the seam&apos;s ease, it comes nearer to it</source>
        <translation>接缝两侧保持其差值；若与接缝吃势相差较大，则向其靠近</translation>
    </message>
    <message>
        <source>St&amp;raight edges</source>
        <translation>直边(&amp;R)</translation>
    </message>
    <message>
        <source>An&amp;gles of corners</source>
        <translation>角点角度(&amp;G)</translation>
    </message>
    <message>
        <source>No point &amp;moves farther than</source>
        <translation>点移动不超过(&amp;M)</translation>
    </message>
    <message>
        <source>Choose the scan or the file that the cover shall lie on.</source>
        <translation>请选择面套要贴合的扫描或文件。</translation>
    </message>
    <message>
        <source>Select the seam that shall run along the curve.</source>
        <translation>请选择要沿曲线的接缝。</translation>
    </message>
    <message>
        <source>Paint the area in the 3D view, or untick it.</source>
        <translation>请在三维视图中涂出区域，或取消勾选。</translation>
    </message>
    <message>
        <source>Select the patches that shall become larger or smaller.</source>
        <translation>请选择要变大或变小的样片。</translation>
    </message>
    <message>
        <source>Choose a goal.</source>
        <translation>请选择目标。</translation>
    </message>
    <message>
        <source>Edges that look straight stay so: those that bow by less than %1 in %2</source>
        <translation>看上去笔直的边保持不变：在 %2 内弯曲小于 %1 的边</translation>
    </message>
</context>
<context>
    <name>bolster::FlatPiecesView</name>
    <message>
        <source>Pieces laid flat</source>
        <translation>展平的样片</translation>
    </message>
    <message>
        <source>Strain: %1</source>
        <translation>应变：%1</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 及以上</translation>
    </message>
    <message>
        <source>%1: strain %2 (rms)</source>
        <translation>%1：应变 %2（均方根）</translation>
    </message>
</context>
<context>
    <name>bolster::FormChoice</name>
    <message>
        <source>Meshes and scans (%1);;All files (*)</source>
        <translation>网格和扫描 (%1);;所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>bolster::FormPatternWindow</name>
    <message>
        <source>&amp;Make the pattern</source>
        <translation>生成样板(&amp;M)</translation>
    </message>
    <message>
        <source>Laying it flat …</source>
        <translation>正在展平…</translation>
    </message>
    <message>
        <source>&amp;Make it without what is left out</source>
        <translation>不含略去部分生成(&amp;M)</translation>
    </message>
    <message>
        <source>Laying a form flat …</source>
        <translation>正在展平形体…</translation>
    </message>
    <message>
        <source>What came of it</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Choose a file with a form above, or import a frame first.</source>
        <translation>请在上方选择形体文件，或先导入骨架。</translation>
    </message>
    <message>
        <source>It is laid flat again when you let go.</source>
        <translation>松开后会重新展平。</translation>
    </message>
    <message numerus="yes">
        <source>Dividing it, %n pieces so far …</source>
        <translation>
            <numerusform>正在划分，目前 %n 片 …</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Lay it flat</source>
        <translation>展平(&amp;L)</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>It was stopped. These are the pieces from before.</source>
        <translation>已停止。这些是之前的样片。</translation>
    </message>
    <message>
        <source>From a form</source>
        <translation>由形体生成</translation>
    </message>
</context>
<context>
    <name>bolster::FormWishesPanel</name>
    <message>
        <source>The form to be covered</source>
        <translation>要覆面的形体</translation>
    </message>
    <message>
        <source>Meshes and CAD files (%1);;All files (*)</source>
        <translation>网格和 CAD 文件 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Where the grain line runs on the form</source>
        <translation>布纹线在形体上的走向</translation>
    </message>
    <message>
        <source>upwards</source>
        <translation>向上</translation>
    </message>
    <message>
        <source>to the back</source>
        <translation>向后</translation>
    </message>
    <message>
        <source>sideways</source>
        <translation>横向</translation>
    </message>
    <message>
        <source>&amp;Form</source>
        <translation>形体(&amp;F)</translation>
    </message>
    <message>
        <source>Fa&amp;bric</source>
        <translation>面料(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Grain runs</source>
        <translation>布纹走向(&amp;G)</translation>
    </message>
    <message>
        <source>It is cut</source>
        <translation>切分位置</translation>
    </message>
    <message>
        <source>and along the ticked lines:</source>
        <translation>以及沿勾选的线：</translation>
    </message>
    <message>
        <source>where its &amp;parts meet</source>
        <translation>在部件相接处(&amp;P)</translation>
    </message>
    <message>
        <source>at the edges of its &amp;CAD faces</source>
        <translation>在其 CAD 面的边上(&amp;C)</translation>
    </message>
    <message>
        <source>Each face as the CAD program has it, also where two go on smoothly in each other</source>
        <translation>按 CAD 程序中的每个面切开，平滑相接的面也分开</translation>
    </message>
    <message>
        <source>where it &amp;bends by more than</source>
        <translation>在弯折大于此角处(&amp;B)</translation>
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
        <translation>在无法展平处(&amp;N)</translation>
    </message>
    <message>
        <source>Pieces that would lie over themselves, or be strained by more than the fabric may be, are divided where they bend most or are narrow; an armchair takes some seconds</source>
        <translation>会与自身重叠或拉伸超过面料允许值的样片，在弯折最大或狭窄处划分；一张扶手椅需几秒钟</translation>
    </message>
    <message>
        <source>Keep its cover &amp;outside of the frame</source>
        <translation>使其面套不陷入骨架(&amp;O)</translation>
    </message>
    <message>
        <source>Making the pattern ticks &quot;Keeps the cover outside&quot; at the frame. A cover that is held along its seams alone may sink into the frame or turn inside out.</source>
        <translation>生成样板时会在骨架处勾选“挡住面套”。只沿缝线固定的面套可能陷入骨架或翻转过来。</translation>
    </message>
    <message>
        <source>Patches that this form became before go, with their seams and the curves that hold nothing else. One Undo brings them back.</source>
        <translation>此前由该形体生成的样片将被移除，连同其缝线以及不固定其他任何东西的曲线。撤销一次即可恢复。</translation>
    </message>
    <message>
        <source>The cover as it is</source>
        <translation>当前的面套</translation>
    </message>
    <message>
        <source>Choose a form</source>
        <translation>选择形体</translation>
    </message>
    <message>
        <source>New fabric</source>
        <translation>新面料</translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation>面料</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Replace the %n patches of these names</source>
        <translation>
            <numerusform>替换这些名称的 %n 个样片(&amp;R)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>(%n curves that hold them will hold nothing)</source>
        <translation>
            <numerusform>（固定它们的 %n 条曲线将不再固定任何东西）</numerusform>
        </translation>
    </message>
    <message>
        <source>They end inside a piece (marked in the 3D view) and do not divide it: each goes on to the border or line that is nearest, along the way shown there</source>
        <translation>它们在样片内部结束（3D 视图中有标记），没有将其分开：每条线沿那里显示的路径延伸到最近的边界或线</translation>
    </message>
    <message numerus="yes">
        <source>Lead %n open ends &amp;on</source>
        <translation>
            <numerusform>延长 %n 个开放端点(&amp;O)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::FoundPiecesView</name>
    <message>
        <source>Pieces in the file</source>
        <translation>文件中的样片</translation>
    </message>
    <message>
        <source>There is no piece in it.</source>
        <translation>其中没有样片。</translation>
    </message>
    <message>
        <source>Reading …</source>
        <translation>正在读取…</translation>
    </message>
</context>
<context>
    <name>bolster::GlCanvas</name>
    <message>
        <source>No OpenGL: drawn in software</source>
        <translation>没有 OpenGL：软件绘制</translation>
    </message>
    <message>
        <source>OpenGL is older than 3.3: drawn in software</source>
        <translation>OpenGL 低于 3.3：软件绘制</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryModel</name>
    <message>
        <source>Start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>更改</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryPanel</name>
    <message>
        <source>Find a change or a version</source>
        <translation>查找更改或版本</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
</context>
<context>
    <name>bolster::HistoryView</name>
    <message>
        <source>&amp;Go to this version</source>
        <translation>转到此版本(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Name this version …</source>
        <translation>命名此版本(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Remove its name</source>
        <translation>删除其名称(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Compare with now …</source>
        <translation>与当前比较(&amp;C)…</translation>
    </message>
    <message>
        <source>Name of this branch</source>
        <translation>此分支的名称</translation>
    </message>
    <message>
        <source>Name of this version</source>
        <translation>此版本的名称</translation>
    </message>
    <message>
        <source>Name this &amp;branch …</source>
        <translation>命名此分支(&amp;B)…</translation>
    </message>
</context>
<context>
    <name>bolster::ImportFlow</name>
    <message>
        <source>Frames (%1)</source>
        <translation>骨架 (%1)</translation>
    </message>
    <message>
        <source>Scans (%1)</source>
        <translation>扫描 (%1)</translation>
    </message>
    <message>
        <source>Import frame</source>
        <translation>导入骨架</translation>
    </message>
    <message>
        <source>Import scan</source>
        <translation>导入扫描</translation>
    </message>
    <message>
        <source>Import pattern</source>
        <translation>导入样板</translation>
    </message>
    <message>
        <source>Patterns (%1)</source>
        <translation>样板 (%1)</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>选择其他文件</translation>
    </message>
    <message>
        <source>The pattern is imported. What is otherwise than in the file:</source>
        <translation>样板已导入。与文件不同之处：</translation>
    </message>
    <message>
        <source>Simplifying %1 …</source>
        <translation>正在简化 %1…</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>正在写入 %1…</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be imported.</source>
        <translation>无法导入“%1”。</translation>
    </message>
</context>
<context>
    <name>bolster::ImportPatternDialog</name>
    <message>
        <source>Import pattern</source>
        <translation>导入样板</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>样片</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>导入(&amp;I)</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>厘米</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>米</translation>
    </message>
    <message>
        <source>Sewing lines, with allowances</source>
        <translation>缝合线，带缝份</translation>
    </message>
    <message>
        <source>Cut lines, without allowance</source>
        <translation>裁剪线，不带缝份</translation>
    </message>
    <message>
        <source>What the outlines of patches become where the file has both lines.</source>
        <translation>文件有两种线时，以何者作为样片轮廓。</translation>
    </message>
    <message>
        <source>Outlines whose ends are no farther apart are closed by a straight line.</source>
        <translation>端点相距不超过此值的轮廓以直线闭合。</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>文件单位(&amp;U)</translation>
    </message>
    <message>
        <source>Largest piece</source>
        <translation>最大样片</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>大小(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>轮廓(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Close gaps up to</source>
        <translation>闭合缺口上限(&amp;C)</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message numerus="yes">
        <source>, %n pairs</source>
        <translation>
            <numerusform>，%n 对</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n times</source>
        <translation>
            <numerusform>，%n 次</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines lay twice on themselves and are taken once.</source>
        <translation>
            <numerusform>%n 条线重复，只取一次。</numerusform>
        </translation>
    </message>
    <message>
        <source>Not read: %1</source>
        <translation>未读取：%1</translation>
    </message>
    <message>
        <source>The file does not say its unit for certain: look at the measures.</source>
        <translation>文件未明确给出单位：请查看尺寸。</translation>
    </message>
    <message>
        <source>Pixels (1/96 inch)</source>
        <translation>像素（1/96 英寸）</translation>
    </message>
    <message>
        <source>Points (1/72 inch)</source>
        <translation>点（1/72 英寸）</translation>
    </message>
    <message>
        <source>In no piece and left out, by layer: %1</source>
        <translation>不属于任何样片而略去，按图层：%1</translation>
    </message>
    <message>
        <source>Marks of grading, stripes or nothing that is known, left out by layer: %1</source>
        <translation>放码标记、条格或未知内容而略去，按图层：%1</translation>
    </message>
    <message>
        <source>%1 has %2 pieces; at most %3 can be imported at once: the first ones are chosen.</source>
        <translation>%1 有 %2 个样片；一次最多导入 %3 个：已选前面的。</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1——%2</translation>
    </message>
    <message numerus="yes">
        <source>%n outlines are open: their ends are up to %1 apart. Close gaps up to that, if they are outlines.</source>
        <translation>
            <numerusform>%n 个轮廓未闭合：其端点最多相距 %1。若确为轮廓，请将闭合缺口上限设为此值。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::JobsPanel</name>
    <message>
        <source>Nothing is being worked at.</source>
        <translation>当前没有任务。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>任务</translation>
    </message>
</context>
<context>
    <name>bolster::LeftWork</name>
    <message>
        <source>New design</source>
        <translation>新设计</translation>
    </message>
    <message numerus="yes">
        <source>%n more designs are under File &gt; Unsaved work.</source>
        <translation>
            <numerusform>另有 %n 个设计位于“文件 &gt; 未保存的工作”。</numerusform>
        </translation>
    </message>
    <message>
        <source>Restoring the work on &quot;%1&quot; …</source>
        <translation>正在恢复“%1”的工作…</translation>
    </message>
    <message>
        <source>The work stays under File &gt; Unsaved work</source>
        <translation>工作保留在“文件 &gt; 未保存的工作”</translation>
    </message>
    <message>
        <source>The unsaved work on &quot;%1&quot; could not be restored.</source>
        <translation>无法恢复“%1”未保存的工作。</translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved edits restored.</source>
        <translation>
            <numerusform>已恢复 %n 步未保存的编辑。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unsaved edits are in the history, undone or on other branches.</source>
        <translation>
            <numerusform>%n 步未保存的编辑在历史中，已撤销或在其他分支上。</numerusform>
        </translation>
    </message>
    <message>
        <source>Unsaved names of versions or branches restored.</source>
        <translation>已恢复未保存的版本或分支名称。</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>显示(&amp;O)</translation>
    </message>
    <message>
        <source>Go &amp;back to saved</source>
        <translation>返回已保存(&amp;B)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>%1, %2, damaged</source>
        <translation>%1，%2，已损坏</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>暂无</translation>
    </message>
</context>
<context>
    <name>bolster::MainWindow</name>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>%1[*] – Bolster</source>
        <translation>%1[*] – Bolster</translation>
    </message>
    <message>
        <source>%1 It is back where it was.</source>
        <translation>%1 已回到原处。</translation>
    </message>
    <message>
        <source>More commands</source>
        <translation>更多命令</translation>
    </message>
    <message>
        <source>The cover sprang by %1.</source>
        <translation>面套跳动了 %1。</translation>
    </message>
    <message>
        <source>Folded cloth can lie in several ways, and where a drag leaves it depends on the way of the pointer. What you see now follows from the design alone: whoever opens it sees the same, and so do exports and pictures. If you want the other shape, tell the design: hold the cloth there with a handle, or make the piece smaller until it needs no folds.</source>
        <translation>有褶皱的布料可有多种形态，拖动后停在哪一种取决于指针的路径。现在所见只由设计决定：任何人打开都看到同样的结果，导出和图片也是如此。若想要另一种形态，请在设计中说明：用操控曲线将布料固定在该处，或缩小样片直到不再需要褶皱。</translation>
    </message>
    <message>
        <source>%1[*] (read-only) – Bolster</source>
        <translation>%1[*]（只读） – Bolster</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces are in the pattern. Seam &gt; Propose seams finds what belongs together.</source>
        <translation>
            <numerusform>样板中有 %n 个样片。“接缝 &gt; 建议接缝”可找出相配的边。</numerusform>
        </translation>
    </message>
    <message>
        <source>Bolster</source>
        <translation>Bolster</translation>
    </message>
    <message>
        <source>Bolster is still working at something.</source>
        <translation>Bolster 仍在处理任务。</translation>
    </message>
    <message>
        <source>What is closed now is not finished; files that are being written stay as they were.</source>
        <translation>现在关闭则任务不会完成；正在写入的文件保持原样。</translation>
    </message>
    <message>
        <source>&amp;Stop it and close</source>
        <translation>停止并关闭(&amp;S)</translation>
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
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>This change has taken away as well: %1</source>
        <translation>此更改还去掉了：%1</translation>
    </message>
</context>
<context>
    <name>bolster::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>手册</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>Back (Alt+Left)</source>
        <translation>后退 (Alt+左)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后退</translation>
    </message>
    <message>
        <source>Forward (Alt+Right)</source>
        <translation>前进 (Alt+右)</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>前进</translation>
    </message>
    <message>
        <source>Find in all pages</source>
        <translation>在所有页面中查找</translation>
    </message>
    <message>
        <source>The manual has no page &quot;%1&quot;.</source>
        <translation>手册中没有页面“%1”。</translation>
    </message>
    <message>
        <source>The manual is in English.</source>
        <translation>手册为英文。</translation>
    </message>
</context>
<context>
    <name>bolster::MapLegend</name>
    <message>
        <source>over the fabric&apos;s limit</source>
        <translation>超过面料极限</translation>
    </message>
</context>
<context>
    <name>bolster::MapLink</name>
    <message>
        <source>Largest strain</source>
        <translation>最大应变</translation>
    </message>
    <message>
        <source>Strain along the grain</source>
        <translation>沿布纹应变</translation>
    </message>
    <message>
        <source>Strain across the grain</source>
        <translation>横布纹应变</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>Mean curvature</source>
        <translation>平均曲率</translation>
    </message>
    <message>
        <source>Distance to the frame</source>
        <translation>到骨架的距离</translation>
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
        <translation>压缩</translation>
    </message>
    <message>
        <source>stretched</source>
        <translation>拉伸</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%2 中 %1</translation>
    </message>
    <message>
        <source>%1, over the limit of %2</source>
        <translation>%1，超过极限 %2</translation>
    </message>
    <message>
        <source>Here: %1</source>
        <translation>此处：%1</translation>
    </message>
    <message>
        <source>over the fabric&apos;s limit</source>
        <translation>超过面料极限</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>内</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>外</translation>
    </message>
    <message>
        <source>Deviation from the scan</source>
        <translation>与扫描的偏差</translation>
    </message>
</context>
<context>
    <name>bolster::MarkTool</name>
    <message>
        <source>Hole %1</source>
        <translation>孔 %1</translation>
    </message>
    <message>
        <source>Click to select it, drag to move it – its properties say what it is like</source>
        <translation>单击选择，拖动移动——属性中为其设置</translation>
    </message>
    <message>
        <source>Click a corner of an outline to choose how its cut lines are joined – Esc ends the tool</source>
        <translation>单击轮廓的角点，选择裁剪线的连接方式——Esc 结束工具</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no distance from the corner on this edge.</source>
        <translation>“%1”不是此边上到角点的距离。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no place: try 120, 40</source>
        <translation>“%1”不是位置：例如 120, 40</translation>
    </message>
    <message>
        <source>Click an outline to place a notch, or type how far it is from the corner; on a seam the other side gets one, too – Esc ends the tool</source>
        <translation>单击轮廓放置剪口，或输入到角点的距离；在接缝上另一侧也会放置——Esc 结束工具</translation>
    </message>
    <message>
        <source>Click inside a patch to place a drill hole, or type where: 120, 40 – Esc ends the tool</source>
        <translation>单击样片内部放置钻孔，或输入位置：120, 40——Esc 结束工具</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no width of an allowance: try 12</source>
        <translation>“%1”不是缝份宽度：例如 12</translation>
    </message>
    <message>
        <source>Drag its handle, or type its width – its properties say what it is like</source>
        <translation>拖动其手柄，或输入宽度——属性中为其设置</translation>
    </message>
    <message>
        <source>Click an edge to give it a seam allowance of its own, or type its width; drag its handle – Esc ends the tool</source>
        <translation>单击边为其设自有缝份，或输入宽度；拖动其手柄——Esc 结束工具</translation>
    </message>
    <message>
        <source>Point at an outline, then type how far the notch is from the corner</source>
        <translation>指向轮廓，然后输入剪口到角点的距离</translation>
    </message>
    <message>
        <source>Point into a patch, then type where the drill hole lies: 120, 40</source>
        <translation>指向样片内部，然后输入钻孔位置：120, 40</translation>
    </message>
    <message>
        <source>Point at an edge, then type how wide its allowance is</source>
        <translation>指向边，然后输入其缝份宽度</translation>
    </message>
</context>
<context>
    <name>bolster::NextStep</name>
    <message>
        <source>Next: %1 for the other side.</source>
        <translation>下一步：为另一侧%1。</translation>
    </message>
    <message>
        <source>draw a second patch</source>
        <translation>绘制第二个样片</translation>
    </message>
    <message>
        <source>Next: %1 – click an edge, then the edge it is sewn to.</source>
        <translation>下一步：%1——单击一条边，再单击与之缝合的边。</translation>
    </message>
    <message>
        <source>sew the patches</source>
        <translation>缝合样片</translation>
    </message>
    <message>
        <source>Next: %1 and give them a pressure in the properties.</source>
        <translation>下一步：%1，并在属性中为其设置压力。</translation>
    </message>
    <message>
        <source>select all patches</source>
        <translation>选择所有样片</translation>
    </message>
    <message>
        <source>Next: %1 – click points on it, Enter ends – to which the cover is attached.</source>
        <translation>下一步：%1以固定面套——单击其上的点，Enter 结束。</translation>
    </message>
    <message>
        <source>draw a fixation curve on the frame</source>
        <translation>在骨架上绘制固定曲线</translation>
    </message>
    <message>
        <source>Next: select a fixation curve and %1 to it.</source>
        <translation>下一步：选择固定曲线，并向其%1。</translation>
    </message>
    <message>
        <source>attach an edge</source>
        <translation>固定一条边</translation>
    </message>
</context>
<context>
    <name>bolster::NumberBox</name>
    <message>
        <source>varies</source>
        <translation>不一</translation>
    </message>
    <message>
        <source>Not taken: a number is needed</source>
        <translation>未采用：需要数字</translation>
    </message>
    <message>
        <source>Not taken: &quot;%1&quot; is not a length</source>
        <translation>未采用：“%1”不是长度</translation>
    </message>
    <message>
        <source>Not taken: &quot;%1&quot; is not a number</source>
        <translation>未采用：“%1”不是数字</translation>
    </message>
    <message>
        <source>Not taken: %1 is too little, at least %2</source>
        <translation>未采用：%1 过小，至少 %2</translation>
    </message>
    <message>
        <source>Not taken: %1 is too much, at most %2</source>
        <translation>未采用：%1 过大，最多 %2</translation>
    </message>
</context>
<context>
    <name>bolster::OpenFlow</name>
    <message>
        <source>Projects and designs (%1)</source>
        <translation>项目和设计 (%1)</translation>
    </message>
    <message>
        <source>This is the version where you were last; the one in the file is under File &gt; Revert to saved</source>
        <translation>这是您上次所在的版本；文件中的版本可通过“文件 &gt; 恢复到已保存”找到</translation>
    </message>
    <message>
        <source>Open project or design</source>
        <translation>打开项目或设计</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is open in another window.</source>
        <translation>“%1”已在另一窗口中打开。</translation>
    </message>
    <message>
        <source>It can be opened here to look at; what is changed is saved under another name.</source>
        <translation>可在此打开查看；更改将以其他名称保存。</translation>
    </message>
    <message numerus="yes">
        <source>%n elements cannot be used as they are; everything else works.</source>
        <translation>
            <numerusform>%n 个元素按现状无法使用；其余均正常。</numerusform>
        </translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>显示(&amp;O)</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>暂无</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>清空此列表(&amp;C)</translation>
    </message>
    <message>
        <source>The samples are not installed</source>
        <translation>未安装示例</translation>
    </message>
</context>
<context>
    <name>bolster::PagesView</name>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
    </message>
</context>
<context>
    <name>bolster::PartsTree</name>
    <message>
        <source>Part</source>
        <translation>部件</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>部件</translation>
    </message>
</context>
<context>
    <name>bolster::PatternCommands</name>
    <message>
        <source>This stretch is straight already.</source>
        <translation>此区段已是直线。</translation>
    </message>
    <message>
        <source>They are equally long already.</source>
        <translation>它们已等长。</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>剪切(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>粘贴(&amp;P)</translation>
    </message>
    <message>
        <source>Dupl&amp;icate</source>
        <translation>创建副本(&amp;I)</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>排列(&amp;G)</translation>
    </message>
    <message>
        <source>Turn 90° to the &amp;left</source>
        <translation>向左旋转 90°(&amp;L)</translation>
    </message>
    <message>
        <source>Turn 90° to the &amp;right</source>
        <translation>向右旋转 90°(&amp;R)</translation>
    </message>
    <message>
        <source>Mirror hori&amp;zontally</source>
        <translation>水平镜像(&amp;Z)</translation>
    </message>
    <message>
        <source>Mirror &amp;vertically</source>
        <translation>垂直镜像(&amp;V)</translation>
    </message>
    <message>
        <source>Al&amp;ign</source>
        <translation>对齐(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Left edges</source>
        <translation>左对齐(&amp;L)</translation>
    </message>
    <message>
        <source>Centres in a &amp;column</source>
        <translation>中心成列(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Right edges</source>
        <translation>右对齐(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Top edges</source>
        <translation>上对齐(&amp;T)</translation>
    </message>
    <message>
        <source>Centres in a ro&amp;w</source>
        <translation>中心成行(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Bottom edges</source>
        <translation>下对齐(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Distribute</source>
        <translation>分布(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Horizontally</source>
        <translation>水平(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Vertically</source>
        <translation>垂直(&amp;V)</translation>
    </message>
    <message>
        <source>Arrange &amp;automatically</source>
        <translation>自动排列(&amp;A)</translation>
    </message>
    <message>
        <source>Poin&amp;ts and edges</source>
        <translation>点和边(&amp;T)</translation>
    </message>
    <message>
        <source>Make &amp;corner</source>
        <translation>设为角点(&amp;C)</translation>
    </message>
    <message>
        <source>Make s&amp;mooth</source>
        <translation>设为平滑(&amp;M)</translation>
    </message>
    <message>
        <source>Strai&amp;ghten</source>
        <translation>拉直(&amp;G)</translation>
    </message>
    <message>
        <source>Edge &amp;length …</source>
        <translation>边的长度(&amp;L)…</translation>
    </message>
    <message>
        <source>Type the length of the selected edge</source>
        <translation>输入所选边的长度</translation>
    </message>
    <message>
        <source>Make e&amp;qually long</source>
        <translation>设为等长(&amp;Q)</translation>
    </message>
    <message>
        <source>Makes the selected edges as long as the first one, or the second side of a seam as long as its first</source>
        <translation>使所选边与第一条等长，或使接缝的第二侧与第一侧等长</translation>
    </message>
    <message>
        <source>Mirror twi&amp;ns</source>
        <translation>镜像件(&amp;N)</translation>
    </message>
    <message>
        <source>Merge a&amp;long seam</source>
        <translation>沿接缝合并(&amp;L)</translation>
    </message>
    <message>
        <source>Smooth &amp;across seam ends</source>
        <translation>圆顺接缝端点(&amp;A)</translation>
    </message>
    <message>
        <source>Outlines go on without a kink from one patch to the other where the selected seams end, when both sides lie together</source>
        <translation>两侧对合时，轮廓在所选接缝端点处从一个样片圆顺过渡到另一个，没有折角</translation>
    </message>
    <message>
        <source>They go on without a kink already.</source>
        <translation>它们已圆顺过渡。</translation>
    </message>
</context>
<context>
    <name>bolster::PatternFitWindow</name>
    <message>
        <source>&amp;Take the changes</source>
        <translation>采用更改(&amp;T)</translation>
    </message>
    <message>
        <source>Changes of</source>
        <translation>更改对象</translation>
    </message>
    <message>
        <source>Moves by</source>
        <translation>移动量</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>What is ticked is changed</source>
        <translation>勾选的内容将被更改</translation>
    </message>
    <message>
        <source>&amp;How much of it</source>
        <translation>采用多少(&amp;H)</translation>
    </message>
    <message>
        <source>Solving the cover …</source>
        <translation>正在求解面套…</translation>
    </message>
    <message>
        <source>Stopped; nothing has changed.</source>
        <translation>已停止；没有任何更改。</translation>
    </message>
    <message>
        <source>&amp;Find changes</source>
        <translation>查找更改(&amp;F)</translation>
    </message>
    <message>
        <source>The cover moves by %1 (rms).</source>
        <translation>面套移动 %1（均方根）。</translation>
    </message>
    <message>
        <source>On the way a fold came or went: look at the cover before you take it.</source>
        <translation>其间有褶皱出现或消失：采用前请查看面套。</translation>
    </message>
    <message numerus="yes">
        <source>%n of the numbers that may change do nothing here.</source>
        <translation>
            <numerusform>允许更改的数值中有 %n 个在此不起作用。</numerusform>
        </translation>
    </message>
    <message>
        <source>Arrows in the pattern: %1 times as long as the way</source>
        <translation>样板中的箭头：为位移的 %1 倍</translation>
    </message>
    <message>
        <source>Arrows in the pattern: where its outlines go</source>
        <translation>样板中的箭头：轮廓移向何处</translation>
    </message>
    <message>
        <source>Taken. Undo takes it back.</source>
        <translation>已采用。可用撤销还原。</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: find the changes again.</source>
        <translation>设计在此期间已更改：请重新查找更改。</translation>
    </message>
    <message>
        <source>With all of the changes:</source>
        <translation>采用全部更改后：</translation>
    </message>
    <message>
        <source>Fitting the pattern …</source>
        <translation>正在拟合样板…</translation>
    </message>
    <message>
        <source>Changing the pattern …</source>
        <translation>正在更改样板…</translation>
    </message>
    <message>
        <source>Pressed together: %1 before, %2 now</source>
        <translation>受挤压：之前 %1，现在 %2</translation>
    </message>
    <message>
        <source>From the curve: %1 before, %2 now (rms)</source>
        <translation>距曲线：之前 %1，现在 %2（均方根）</translation>
    </message>
    <message>
        <source>Off the area that is wanted: %1 before, %2 now</source>
        <translation>与目标面积相差：之前 %1，现在 %2</translation>
    </message>
    <message>
        <source>Nothing is over the limits: there is nothing to do.</source>
        <translation>没有超出限度之处：无需更改。</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit (before: %2), on few triangles at first</source>
        <translation>面套的 %1 超过极限（之前：%2），先用较少的三角形</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit (before: %2)</source>
        <translation>面套的 %1 超过极限（之前：%2）</translation>
    </message>
    <message>
        <source>With what is shown of the changes the cover cannot be solved.</source>
        <translation>按所显示的这部分更改，无法求解面套。</translation>
    </message>
    <message>
        <source>With what is shown of the changes:</source>
        <translation>按所显示的这部分更改：</translation>
    </message>
    <message>
        <source>Nothing of the changes is shown now: move the slider to see them.</source>
        <translation>现在未显示任何更改：移动滑块即可查看。</translation>
    </message>
    <message>
        <source>Sides of seams differ by up to %1 more than is wanted: change their neighbours, too, or let the ease change.</source>
        <translation>缝线两侧的长度差比所需多出最多 %1：请同时更改相邻样片，或允许吃势变化。</translation>
    </message>
    <message>
        <source>Strained over the limit: %1 of the painted area before, %2 now</source>
        <translation>应变超限：涂画区域中之前 %1，现在 %2</translation>
    </message>
    <message>
        <source>Strained over the limit: %1 of the cover before, %2 now</source>
        <translation>应变超限：面套中之前 %1，现在 %2</translation>
    </message>
    <message>
        <source>That is hardly nearer, and strains the cloth more: let something else change, or less of it.</source>
        <translation>这样几乎没有更接近，面料应变却更大：请改为允许其他变化，或减少变化。</translation>
    </message>
    <message>
        <source>Stopped. What was found until then makes it no better: nothing has changed.</source>
        <translation>已停止。此前找到的更改并没有改善：未作任何更改。</translation>
    </message>
    <message>
        <source>Stopped. With all of the changes that were found until then, measured anew on all triangles:</source>
        <translation>已停止。采用到此为止找到的全部更改，并在所有三角形上重新测量：</translation>
    </message>
    <message>
        <source>Sides of seams off their ease: up to %1 before, %2 now</source>
        <translation>偏离吃势的缝线两侧：之前最多 %1，现在 %2</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Over the fabrics&apos; limits: %1 of the cover before, %2 now</source>
        <translation>超过面料极限：面套中之前 %1，现在 %2</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: find the changes again, or undo that.</source>
        <translation>设计在此期间已更改：请重新查找更改，或撤销该操作。</translation>
    </message>
    <message>
        <source>Taken back. Move the slider to see the changes again.</source>
        <translation>已撤回。移动滑块即可再次查看更改。</translation>
    </message>
    <message>
        <source>That is hardly nearer to the limit: let something else change, or more of it.</source>
        <translation>几乎没有更接近极限：请让其他内容改变，或改变得更多。</translation>
    </message>
    <message>
        <source>%1 from %3 (rms; before: %2), on few triangles at first</source>
        <translation>与 %3 相距 %1（均方根；之前：%2），先用少量三角形</translation>
    </message>
    <message>
        <source>%1 from %3 (rms; before: %2)</source>
        <translation>与 %3 相距 %1（均方根；之前：%2）</translation>
    </message>
    <message>
        <source>From %5: %1 before, %2 now (rms); %3 before, %4 now (95 %)</source>
        <translation>距 %5：之前 %1，现在 %2（均方根）；之前 %3，现在 %4 (95%)</translation>
    </message>
    <message>
        <source>That is hardly nearer to %1: let something else change, or more of it.</source>
        <translation>几乎没有更接近 %1：请让其他内容改变，或改变得更多。</translation>
    </message>
    <message>
        <source>Hardly less is pressed together: let something else change, or more of it.</source>
        <translation>受压的部分几乎没有减少：请让其他内容改变，或改变得更多。</translation>
    </message>
    <message>
        <source>That is hardly nearer to the curve: let something else change, or more of it.</source>
        <translation>几乎没有更接近曲线：请让其他内容改变，或改变得更多。</translation>
    </message>
    <message>
        <source>That is hardly nearer to the area that is wanted: let something else change, or more of it.</source>
        <translation>几乎没有更接近所需面积：请让其他内容改变，或改变得更多。</translation>
    </message>
    <message>
        <source>Changes the pattern until the cover is as it is wished: tick one goal or several, and what may change.</source>
        <translation>更改样板，直到面套符合期望：勾选一个或多个目标，以及可以改变的内容。</translation>
    </message>
    <message>
        <source>%1 of the painted area is over the limit (before: %2), on few triangles at first</source>
        <translation>涂抹区域的 %1 超过极限（之前：%2），先用较少的三角形</translation>
    </message>
    <message>
        <source>%1 of the painted area is over the limit (before: %2)</source>
        <translation>涂抹区域的 %1 超过极限（之前：%2）</translation>
    </message>
    <message>
        <source>No change makes it better on all triangles: let something else change, or points move farther.</source>
        <translation>在全部三角形上没有更改能使其更好：请让其他内容改变，或让点移动得更远。</translation>
    </message>
    <message>
        <source>More of the cloth is strained over its limits: make these a goal, too, or let points move less.</source>
        <translation>更多面料的应变超过其极限：请将其也设为目标，或让点移动得更少。</translation>
    </message>
    <message>
        <source>What is wished</source>
        <translation>期望的结果</translation>
    </message>
    <message>
        <source>Fit to a goal</source>
        <translation>拟合到目标</translation>
    </message>
</context>
<context>
    <name>bolster::PatternRuler</name>
    <message>
        <source>Drag down for a level guide. Marks move upright guides; drag them off to remove them.</source>
        <translation>向下拖动得到水平参考线。刻度标记移动竖直参考线；拖出即删除。</translation>
    </message>
    <message>
        <source>Drag to the right for an upright guide. Marks move level guides; drag them off to remove them.</source>
        <translation>向右拖动得到竖直参考线。刻度标记移动水平参考线；拖出即删除。</translation>
    </message>
</context>
<context>
    <name>bolster::PreferencesWindow</name>
    <message>
        <source>Preferences (*.json)</source>
        <translation>首选项 (*.json)</translation>
    </message>
    <message>
        <source>No setting has these words.</source>
        <translation>没有设置包含这些词。</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>Find a setting</source>
        <translation>查找设置</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>&amp;Edit single shortcuts …</source>
        <translation>编辑单个快捷键(&amp;E)…</translation>
    </message>
    <message>
        <source>Back to &amp;defaults</source>
        <translation>恢复默认值(&amp;D)</translation>
    </message>
    <message>
        <source>All settings of this page</source>
        <translation>此页的所有设置</translation>
    </message>
    <message>
        <source>E&amp;xport …</source>
        <translation>导出(&amp;X)…</translation>
    </message>
    <message>
        <source>&amp;Import …</source>
        <translation>导入(&amp;I)…</translation>
    </message>
    <message>
        <source>Export preferences</source>
        <translation>导出首选项</translation>
    </message>
    <message>
        <source>Bolster preferences.json</source>
        <translation>Bolster 首选项.json</translation>
    </message>
    <message>
        <source>Import preferences</source>
        <translation>导入首选项</translation>
    </message>
    <message>
        <source>The preferences could not be exported.</source>
        <translation>无法导出首选项。</translation>
    </message>
    <message>
        <source>Nothing was imported from &quot;%1&quot;; all settings are as they were.</source>
        <translation>未从“%1”导入任何内容；所有设置保持原样。</translation>
    </message>
    <message>
        <source>The preferences were imported.</source>
        <translation>已导入首选项。</translation>
    </message>
    <message numerus="yes">
        <source>This version of Bolster does not know %n of them: %1</source>
        <translation>
            <numerusform>此版本的 Bolster 不认识其中 %n 项：%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>In the 3D view</source>
        <translation>在三维视图中</translation>
    </message>
    <message>
        <source>In the pattern</source>
        <translation>样板中</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no folder on this machine: the folder of your fabrics stays what it was.</source>
        <translation>“%1”不是本机上的文件夹：面料文件夹保持不变。</translation>
    </message>
    <message>
        <source>&amp;Restart now</source>
        <translation>立即重启(&amp;R)</translation>
    </message>
    <message>
        <source>Closes Bolster, and asks about unsaved work as always; then it starts again with the same project</source>
        <translation>关闭 Bolster（未保存的工作照常询问），然后用同一项目重新启动</translation>
    </message>
</context>
<context>
    <name>bolster::ProblemsView</name>
    <message>
        <source>F1: what it means, and what to do</source>
        <translation>F1：含义及处理方法</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Nothing to worry about.</source>
        <translation>没有需要担心的地方。</translation>
    </message>
    <message>
        <source>All elements can be used.</source>
        <translation>所有元素都可以使用。</translation>
    </message>
</context>
<context>
    <name>bolster::PullNote</name>
    <message>
        <source>The cover in the 3D view is pulled to a scan; here it counts as the pattern alone makes it.</source>
        <translation>3D 视图中的面套正被拉向扫描；这里按纸样自身形成的面套计算。</translation>
    </message>
    <message>
        <source>No scan pulls at the cover any more (a step in the history).</source>
        <translation>已没有扫描拉动面套（历史中的一步）。</translation>
    </message>
    <message>
        <source>Switch the pull off</source>
        <translation>关闭拉动</translation>
    </message>
    <message>
        <source>Pull again</source>
        <translation>再次拉动</translation>
    </message>
</context>
<context>
    <name>bolster::ReliefWindow</name>
    <message>
        <source>Relieve strain</source>
        <translation>释放应变</translation>
    </message>
    <message>
        <source>&amp;Look for changes</source>
        <translation>查找更改(&amp;L)</translation>
    </message>
    <message>
        <source>Looking for what relieves strain …</source>
        <translation>正在查找可释放应变的更改…</translation>
    </message>
    <message>
        <source>Where cloth is strained or pressed together more than it may be, changes of the pattern are tried, and the best are solved.</source>
        <translation>在布料应变或受挤压超出允许之处，尝试更改样板，并求解其中最好的更改。</translation>
    </message>
    <message>
        <source>Proposed changes</source>
        <translation>建议的更改</translation>
    </message>
    <message>
        <source>Strain is at &amp;most</source>
        <translation>应变不超过(&amp;M)</translation>
    </message>
    <message>
        <source>Else the limits of the fabrics count</source>
        <translation>否则以面料的极限为准</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Limit of strain</source>
        <translation>应变极限</translation>
    </message>
    <message>
        <source>Edges move &amp;by at most</source>
        <translation>边最多移动(&amp;B)</translation>
    </message>
    <message>
        <source>Trying changes …</source>
        <translation>正在尝试更改…</translation>
    </message>
    <message>
        <source>Stopped; nothing has changed.</source>
        <translation>已停止；没有任何更改。</translation>
    </message>
    <message>
        <source>Nothing is strained over the limit.</source>
        <translation>没有应变超过极限之处。</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit. No change relieves it.</source>
        <translation>面套的 %1 超过极限。没有更改可释放应变。</translation>
    </message>
    <message>
        <source>Each is solved by itself; &quot;Make it&quot; is one step that Undo takes back.</source>
        <translation>各项单独求解；“执行”是一个步骤，可撤销。</translation>
    </message>
    <message>
        <source>As it is now</source>
        <translation>当前状态</translation>
    </message>
    <message>
        <source>Sewn: %1 more</source>
        <translation>缝合：多 %1</translation>
    </message>
    <message>
        <source>Sides of seams differ by %1 more</source>
        <translation>接缝两侧多相差 %1</translation>
    </message>
    <message>
        <source>Outlines change by %1</source>
        <translation>轮廓改变 %1</translation>
    </message>
    <message>
        <source>Show where</source>
        <translation>显示位置</translation>
    </message>
    <message>
        <source>Make it</source>
        <translation>执行</translation>
    </message>
    <message>
        <source>Make it: %1</source>
        <translation>执行：%1</translation>
    </message>
    <message>
        <source>Made. Undo takes it back; look again to see what helps now.</source>
        <translation>已执行。可撤销；再次查找可了解现在何种更改有效。</translation>
    </message>
    <message>
        <source>Stopped. These are solved:</source>
        <translation>已停止。以下已求解：</translation>
    </message>
    <message>
        <source>The best changes are being solved …</source>
        <translation>正在求解最佳更改…</translation>
    </message>
    <message>
        <source>Hardly anything is over the limit: there is little to gain. &quot;Make it&quot; is one step that Undo takes back.</source>
        <translation>几乎没有超过极限之处：改善余地很小。“执行”是一个步骤，可撤销。</translation>
    </message>
    <message>
        <source>%1 of the cover is over the limit, by %2 (rms of all of it).</source>
        <translation>面套的 %1 超过极限，超出 %2（整个面套的均方根）。</translation>
    </message>
    <message>
        <source>Over the limit: %1 of the cover, then %2</source>
        <translation>超过极限：面套的 %1，之后 %2</translation>
    </message>
    <message>
        <source>Strain over it (rms): %1, then %2</source>
        <translation>超过极限的应变（均方根）：%1，之后 %2</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: look again, or undo that.</source>
        <translation>设计在此期间已更改：请重新查找，或撤销该操作。</translation>
    </message>
    <message>
        <source>The cover moves by %1 (rms).</source>
        <translation>面套移动 %1（均方根）。</translation>
    </message>
    <message>
        <source>From %1 (rms): %2, then %3</source>
        <translation>距 %1（均方根）：%2，之后 %3</translation>
    </message>
</context>
<context>
    <name>bolster::RenderDialog</name>
    <message>
        <source>Render</source>
        <translation>渲染</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>As in the window</source>
        <translation>同窗口</translation>
    </message>
    <message>
        <source>Three-quarter</source>
        <translation>斜视</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后</translation>
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
        <translation>草图</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>最佳</translation>
    </message>
    <message>
        <source>How often each pixel is looked at</source>
        <translation>每个像素的采样次数</translation>
    </message>
    <message>
        <source>Transparent &amp;background</source>
        <translation>透明背景(&amp;B)</translation>
    </message>
    <message>
        <source>The shadow on the ground is kept</source>
        <translation>保留地面上的阴影</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>尺寸(&amp;S)：</translation>
    </message>
    <message>
        <source>&amp;View:</source>
        <translation>视图(&amp;V)：</translation>
    </message>
    <message>
        <source>Sho&amp;w:</source>
        <translation>显示(&amp;W)：</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>质量(&amp;Q)：</translation>
    </message>
    <message>
        <source>Drawing …</source>
        <translation>正在绘制…</translation>
    </message>
    <message>
        <source>&amp;Render …</source>
        <translation>渲染(&amp;R)…</translation>
    </message>
    <message>
        <source>The fabrics as in the window</source>
        <translation>面料同窗口</translation>
    </message>
    <message>
        <source>Colourway %1</source>
        <translation>配色 %1</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>棋盘格</translation>
    </message>
    <message>
        <source>At most %1 million pixels are drawn; choose a smaller size.</source>
        <translation>最多绘制 %1 百万像素；请选择更小的尺寸。</translation>
    </message>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation>无法写入图片：%1</translation>
    </message>
    <message>
        <source>Render to</source>
        <translation>渲染到</translation>
    </message>
    <message>
        <source>PNG, 8 bits (*.png);;TIFF, 16 bits (*.tif *.tiff);;OpenEXR, linear light (*.exr)</source>
        <translation>PNG，8 位 (*.png);;TIFF，16 位 (*.tif *.tiff);;OpenEXR，线性光 (*.exr)</translation>
    </message>
    <message>
        <source>The name must end in .png, .tif or .exr.</source>
        <translation>名称必须以 .png、.tif 或 .exr 结尾。</translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>已取消；未写入任何内容。</translation>
    </message>
    <message>
        <source>one picture</source>
        <translation>一张图片</translation>
    </message>
    <message>
        <source> pictures</source>
        <translation> 张图片</translation>
    </message>
    <message>
        <source>So many pictures from all around, with numbers in their names</source>
        <translation>环绕一周的图片张数，文件名中带编号</translation>
    </message>
    <message>
        <source>&amp;Around the cover:</source>
        <translation>环绕面套(&amp;A)：</translation>
    </message>
    <message>
        <source>All colourways on a sheet</source>
        <translation>所有配色在一张图上</translation>
    </message>
    <message>
        <source>Map: %1</source>
        <translation>云图：%1</translation>
    </message>
    <message>
        <source>&amp;Frame and foam</source>
        <translation>骨架和泡沫(&amp;F)</translation>
    </message>
    <message>
        <source>In the materials that their properties say</source>
        <translation>采用其属性中指定的材料</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>The picture is written: %1</source>
        <translation>图片已写入：%1</translation>
    </message>
    <message>
        <source>Open its folder</source>
        <translation>打开其文件夹</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>What was made</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Drawing %1 …</source>
        <translation>正在绘制 %1…</translation>
    </message>
</context>
<context>
    <name>bolster::ReportDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>报告问题</translation>
    </message>
    <message>
        <source>What did you do, what happened, and what should have happened?</source>
        <translation>您做了什么，发生了什么，本应发生什么？</translation>
    </message>
    <message>
        <source>&amp;What happened:</source>
        <translation>发生了什么(&amp;W)：</translation>
    </message>
    <message>
        <source>&amp;Add the design (&quot;%1&quot;), without its frames, scans and pictures</source>
        <translation>附上设计（“%1”），不含其骨架、扫描和图片(&amp;A)</translation>
    </message>
    <message>
        <source>What the &amp;report says besides:</source>
        <translation>报告中的其他内容(&amp;R)：</translation>
    </message>
    <message>
        <source>Write the report …</source>
        <translation>写入报告…</translation>
    </message>
    <message>
        <source>This writes a file that you can give to those who can help. Bolster sends nothing.</source>
        <translation>将写入一个文件，您可将其交给能提供帮助的人。Bolster 不发送任何内容。</translation>
    </message>
    <message>
        <source>not known yet</source>
        <translation>尚不清楚</translation>
    </message>
    <message>
        <source>Messages of this run:</source>
        <translation>本次运行的消息：</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>（无）</translation>
    </message>
    <message>
        <source>The last crash:</source>
        <translation>上次崩溃：</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>写入报告</translation>
    </message>
    <message>
        <source>ZIP (*.zip)</source>
        <translation>ZIP (*.zip)</translation>
    </message>
    <message>
        <source>The report is written: %1</source>
        <translation>报告已写入：%1</translation>
    </message>
    <message>
        <source>The report could not be written: %1</source>
        <translation>无法写入报告：%1</translation>
    </message>
</context>
<context>
    <name>bolster::Rescue</name>
    <message>
        <source>%1 (recovered)</source>
        <translation>%1（已恢复）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be opened.</source>
        <translation>无法打开“%1”。</translation>
    </message>
    <message>
        <source>What can be read goes into a new project beside it. This file stays as it is.</source>
        <translation>可读取的内容将放入旁边的新项目。此文件保持不变。</translation>
    </message>
    <message>
        <source>&amp;Recover what can be read</source>
        <translation>恢复可读取的内容(&amp;R)</translation>
    </message>
    <message>
        <source>Recovering &quot;%1&quot; …</source>
        <translation>正在恢复“%1”…</translation>
    </message>
    <message>
        <source>Nothing could be recovered.</source>
        <translation>没有可恢复的内容。</translation>
    </message>
    <message>
        <source>What could be read is in &quot;%1&quot; now.</source>
        <translation>可读取的内容现已在“%1”中。</translation>
    </message>
    <message>
        <source>The unsaved work on &quot;%1&quot; is damaged.</source>
        <translation>“%1”未保存的工作已损坏。</translation>
    </message>
    <message numerus="yes">
        <source>What can be read goes into a new project. What you do not want any more is deleted %n days after it was put into the bin.</source>
        <translation>
            <numerusform>可读取的内容将放入新项目。不再需要的内容放入回收站 %n 天后删除。</numerusform>
        </translation>
    </message>
    <message>
        <source>Put it into the &amp;bin</source>
        <translation>放入回收站(&amp;B)</translation>
    </message>
    <message>
        <source>The damaged work is kept under File &gt; Unsaved work</source>
        <translation>损坏的工作保留在“文件 &gt; 未保存的工作”</translation>
    </message>
    <message>
        <source>What could be read of it is in &quot;%1&quot; now.</source>
        <translation>其中可读取的内容现已在“%1”中。</translation>
    </message>
    <message>
        <source>Nothing of it could be read.</source>
        <translation>其中没有可读取的内容。</translation>
    </message>
    <message>
        <source>Nothing that was saved is concerned. The damaged work is kept under File &gt; Unsaved work.</source>
        <translation>已保存的内容不受影响。损坏的工作保留在“文件 &gt; 未保存的工作”。</translation>
    </message>
    <message>
        <source>Open what was &amp;recovered</source>
        <translation>打开恢复的内容(&amp;R)</translation>
    </message>
    <message>
        <source>Looking for what can be read in &quot;%1&quot; …</source>
        <translation>正在查找“%1”中可读取的内容…</translation>
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
        <translation>带历史的项目 (*.bolster);;文本设计 (*.json)</translation>
    </message>
    <message numerus="yes">
        <source>%n edits</source>
        <translation>
            <numerusform>%n 步编辑</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edits that were undone or are on other branches</source>
        <translation>
            <numerusform>%n 步已撤销或在其他分支上的编辑</numerusform>
        </translation>
    </message>
    <message>
        <source>names of versions or branches</source>
        <translation>版本或分支的名称</translation>
    </message>
    <message>
        <source>The file holds another version of the design than the one you see.</source>
        <translation>文件中是设计的另一版本，与您看到的不同。</translation>
    </message>
    <message>
        <source>Not saved yet: %1.</source>
        <translation>尚未保存：%1。</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>保存副本</translation>
    </message>
    <message>
        <source>-copy</source>
        <translation>-副本</translation>
    </message>
    <message>
        <source>Project (*.%1)</source>
        <translation>项目 (*.%1)</translation>
    </message>
    <message>
        <source>Save the changes in &quot;%1&quot;?</source>
        <translation>保存对“%1”的更改吗？</translation>
    </message>
    <message>
        <source>A design as text cannot hold that, a project can.</source>
        <translation>文本设计无法包含这些，项目可以。</translation>
    </message>
    <message>
        <source>Work that is kept for later, with all its steps, is under File &gt; Unsaved work.</source>
        <translation>留待以后的工作连同所有步骤位于“文件 &gt; 未保存的工作”。</translation>
    </message>
    <message>
        <source>Save as &amp;project …</source>
        <translation>另存为项目(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Keep for later</source>
        <translation>留待以后(&amp;K)</translation>
    </message>
    <message>
        <source>The work cannot be kept.</source>
        <translation>无法保留此工作。</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>保存项目</translation>
    </message>
    <message>
        <source>Saved a copy as %1</source>
        <translation>副本已保存为 %1</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>已保存为 %1</translation>
    </message>
    <message>
        <source>%1: the design alone, without its history</source>
        <translation>%1：仅设计，不含历史</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the file any more that was opened or saved here.</source>
        <translation>“%1”已不是在此打开或保存的文件。</translation>
    </message>
    <message>
        <source>Save your design under another name, or let what is there now have another name beside it. If that is a damaged project, File &gt; Open recovers what can be read of it.</source>
        <translation>请以其他名称保存您的设计，或让现有文件改名放在旁边。若那是损坏的项目，“文件 &gt; 打开”可恢复其中可读取的内容。</translation>
    </message>
    <message>
        <source>&amp;Keep the other file beside it, and save</source>
        <translation>将另一文件保留在旁边并保存(&amp;K)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be saved.</source>
        <translation>无法保存“%1”。</translation>
    </message>
    <message>
        <source>What was in the place of &quot;%1&quot; is in &quot;%2&quot; now.</source>
        <translation>原在“%1”处的内容现已在“%2”中。</translation>
    </message>
    <message>
        <source>Somebody else has changed &quot;%1&quot; since it was opened here.</source>
        <translation>自在此打开后，他人更改了“%1”。</translation>
    </message>
    <message>
        <source>Their changes can become a branch of the history here, then both are saved. Your design stays as it is, and you can go to theirs.</source>
        <translation>可将其更改作为历史的一个分支纳入，然后一并保存。您的设计保持不变，也可转到对方的设计。</translation>
    </message>
    <message>
        <source>&amp;Take their changes in as a branch</source>
        <translation>将其更改作为分支纳入(&amp;T)</translation>
    </message>
    <message>
        <source>From the file, %1</source>
        <translation>来自文件，%1</translation>
    </message>
    <message>
        <source>Their changes could not be taken in.</source>
        <translation>无法纳入其更改。</translation>
    </message>
    <message>
        <source>The changes of somebody else are a branch of the history now.</source>
        <translation>他人的更改现已是历史的一个分支。</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>显示(&amp;O)</translation>
    </message>
    <message>
        <source>Go &amp;there</source>
        <translation>转到该处(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Try again</source>
        <translation>重试(&amp;T)</translation>
    </message>
    <message>
        <source>Save &amp;as …</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Nothing protects what you do since %1 against a crash: Bolster cannot write to the folder &quot;%2&quot;. Make room there, or save the design.</source>
        <translation>自 %1 起的操作没有崩溃保护：Bolster 无法写入文件夹“%2”。请在该处腾出空间，或保存设计。</translation>
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
        <translation>与 %1 的偏差</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>内</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>外</translation>
    </message>
</context>
<context>
    <name>bolster::SeamLineList</name>
    <message>
        <source>Seam lines</source>
        <translation>接缝线</translation>
    </message>
    <message>
        <source>Fixation curves of the design. Draw seam lines on a frame with the tool for fixation curves: what is drawn meanwhile is cut at once</source>
        <translation>设计的固定曲线。请用固定曲线工具在骨架上绘制接缝线：期间绘制的线会立即切分</translation>
    </message>
    <message numerus="yes">
        <source>%n lines that hold a cover</source>
        <translation>
            <numerusform>%n 条固定面套的线</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bolster::SeamProposalsWindow</name>
    <message>
        <source>Proposed seams</source>
        <translation>建议的接缝</translation>
    </message>
    <message>
        <source>Edge of</source>
        <translation>边，所属样片</translation>
    </message>
    <message>
        <source>to edge of</source>
        <translation>与边，所属样片</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Certainty</source>
        <translation>可信度</translation>
    </message>
    <message>
        <source>Select rows to see their edges in the pattern; Enter or a double click sews them.</source>
        <translation>选择行可在样板中查看其边；Enter 或双击将其缝合。</translation>
    </message>
    <message>
        <source>&amp;Sew selected</source>
        <translation>缝合所选(&amp;S)</translation>
    </message>
    <message>
        <source>Sew &amp;all</source>
        <translation>全部缝合(&amp;A)</translation>
    </message>
    <message>
        <source>Looking for edges that belong together …</source>
        <translation>正在查找相配的边…</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>There are no free edges that seem to belong together.</source>
        <translation>没有看来相配的空闲边。</translation>
    </message>
    <message>
        <source>Sew &amp;likely ones</source>
        <translation>缝合可能的(&amp;L)</translation>
    </message>
    <message>
        <source>Those of 50 % and more. What is sewn tells where its neighbours belong.</source>
        <translation>50% 及以上的接缝。已缝合的接缝可推断其相邻接缝的归属。</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 与 %2</translation>
    </message>
    <message>
        <source>Found by their lengths, corners that would close, names and directions; the most certain first. Look at each in the pattern before you sew it.</source>
        <translation>依据长度、可闭合的角、名称和方向；可信度高的在前。缝合前请在样板中逐一查看。</translation>
    </message>
</context>
<context>
    <name>bolster::SeamsModel</name>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>More than 5 % ease puckers.</source>
        <translation>吃势超过 5% 会起皱。</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>接缝</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>吃势</translation>
    </message>
    <message>
        <source>Ease %</source>
        <translation>吃势 %</translation>
    </message>
    <message>
        <source>Joins</source>
        <translation>连续性</translation>
    </message>
    <message>
        <source>Length 1</source>
        <translation>长度 1</translation>
    </message>
    <message>
        <source>Length 2</source>
        <translation>长度 2</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>对应</translation>
    </message>
    <message>
        <source>The letter on both stretches in the pattern</source>
        <translation>样板中两个区段上的字母</translation>
    </message>
    <message>
        <source>The patches and their edges</source>
        <translation>样片及其边</translation>
    </message>
    <message>
        <source>C0: an edge, C1: smooth with the texture, G1: rounded</source>
        <translation>C0：有棱边，C1：平滑且纹理连续，G1：圆顺</translation>
    </message>
    <message>
        <source>Of the first side</source>
        <translation>第一侧</translation>
    </message>
    <message>
        <source>Of the second side</source>
        <translation>第二侧</translation>
    </message>
    <message>
        <source>What is sewn together: equal parts of the length, or of the curve&apos;s parameter</source>
        <translation>如何缝合：长度或曲线参数的等分</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>The place in the order of sewing; Seam &gt; Sew earlier and Sew later change it</source>
        <translation>缝制顺序中的位置；用“接缝 &gt; 提前缝制”和“推后缝制”更改</translation>
    </message>
    <message>
        <source>How much longer the second side is than the first one</source>
        <translation>第二侧比第一侧长多少</translation>
    </message>
    <message>
        <source>The ease over the shorter side; more than 5 % puckers</source>
        <translation>吃势与较短一侧之比；超过 5% 会起皱</translation>
    </message>
</context>
<context>
    <name>bolster::SeamsView</name>
    <message>
        <source>No seams yet. Choose the sewing tool (W), then click the two edges that belong together.</source>
        <translation>还没有接缝。请选择缝合工具 (W)，然后单击相配的两条边。</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>接缝</translation>
    </message>
</context>
<context>
    <name>bolster::SectionPanel</name>
    <message>
        <source>Section</source>
        <translation>剖面</translation>
    </message>
    <message>
        <source>Cut across the x axis</source>
        <translation>垂直于 x 轴剖切</translation>
    </message>
    <message>
        <source>Cut across the y axis</source>
        <translation>垂直于 y 轴剖切</translation>
    </message>
    <message>
        <source>Cut across the z axis</source>
        <translation>垂直于 z 轴剖切</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Cut parallel to the picture, as it is seen now</source>
        <translation>平行于当前画面剖切</translation>
    </message>
    <message>
        <source>Moves the plane</source>
        <translation>移动剖面</translation>
    </message>
    <message>
        <source>Show the other half</source>
        <translation>显示另一半</translation>
    </message>
    <message>
        <source>Close the section</source>
        <translation>关闭剖面</translation>
    </message>
    <message>
        <source>Place of the section</source>
        <translation>剖面位置</translation>
    </message>
</context>
<context>
    <name>bolster::SewingCommands</name>
    <message>
        <source>Propos&amp;e seams …</source>
        <translation>建议接缝(&amp;E)…</translation>
    </message>
    <message>
        <source>Show seam li&amp;st</source>
        <translation>显示接缝列表(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Flip</source>
        <translation>翻转(&amp;F)</translation>
    </message>
    <message>
        <source>Swap si&amp;des</source>
        <translation>交换两侧(&amp;D)</translation>
    </message>
    <message>
        <source>C&amp;0 – an edge</source>
        <translation>C0——有棱边(&amp;0)</translation>
    </message>
    <message>
        <source>C&amp;1 – smooth, texture too</source>
        <translation>C1——平滑，纹理也连续(&amp;1)</translation>
    </message>
    <message>
        <source>&amp;G1 – rounded</source>
        <translation>G1——圆顺(&amp;G)</translation>
    </message>
    <message>
        <source>Match by &amp;length</source>
        <translation>按长度对应(&amp;L)</translation>
    </message>
    <message>
        <source>Match by &amp;parameter</source>
        <translation>按参数对应(&amp;P)</translation>
    </message>
    <message>
        <source>Sew earl&amp;ier</source>
        <translation>提前缝制(&amp;I)</translation>
    </message>
    <message>
        <source>Sew l&amp;ater</source>
        <translation>推后缝制(&amp;A)</translation>
    </message>
    <message>
        <source>Sewi&amp;ng order as proposed</source>
        <translation>按建议的缝制顺序(&amp;N)</translation>
    </message>
</context>
<context>
    <name>bolster::SheetPreview</name>
    <message>
        <source>What will be on the sheets</source>
        <translation>纸张上的内容</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>没有可裁剪的内容。</translation>
    </message>
    <message>
        <source>Laying out …</source>
        <translation>正在排版…</translation>
    </message>
</context>
<context>
    <name>bolster::ShortcutsDialog</name>
    <message>
        <source>&amp;No keys</source>
        <translation>无按键(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>重置(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Take them over</source>
        <translation>采用(&amp;T)</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Find a command or a key</source>
        <translation>查找命令或按键</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>全部重置(&amp;A)</translation>
    </message>
    <message>
        <source>Click into the field and press the keys.</source>
        <translation>请单击输入框并按下按键。</translation>
    </message>
    <message>
        <source>Choose a command to change its keys.</source>
        <translation>请选择要更改按键的命令。</translation>
    </message>
    <message>
        <source>%1 is needed by the views and fields themselves.</source>
        <translation>视图和输入框自身需要 %1。</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 已用于“%2”。</translation>
    </message>
    <message>
        <source>%1 it is.</source>
        <translation>已设为 %1。</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
</context>
<context>
    <name>bolster::ShownPattern</name>
    <message>
        <source>Edge: %1</source>
        <translation>边：%1</translation>
    </message>
</context>
<context>
    <name>bolster::SimplifyChoice</name>
    <message>
        <source>&amp;Simplify to about</source>
        <translation>简化至约(&amp;S)</translation>
    </message>
    <message>
        <source> triangles</source>
        <translation> 个三角形</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Writes the parts that are wanted into an OBJ file of the design&apos;s own; the file that was chosen stays as it is</source>
        <translation>将所需部件写入设计自己的 OBJ 文件；所选文件保持不变</translation>
    </message>
</context>
<context>
    <name>bolster::SpotsPanel</name>
    <message>
        <source>Worst spots</source>
        <translation>最严重部位</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>样片</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>极限</translation>
    </message>
    <message>
        <source>Negative where the fabric is pressed together</source>
        <translation>面料受压缩处为负</translation>
    </message>
    <message>
        <source>What the fabric there may suffer. The spots are sorted by how much of it they take</source>
        <translation>面料在该处可承受的值。各部位按其占用比例排序</translation>
    </message>
    <message>
        <source>As soon as there is a cover, its worst spots will be listed here.</source>
        <translation>有面套后，其最严重部位将列在此处。</translation>
    </message>
    <message>
        <source>A map of strain or shear shows what the fabric suffers. Its worst spots will be listed here.</source>
        <translation>应变或剪切云图显示面料的承受情况。其最严重部位将列在此处。</translation>
    </message>
    <message>
        <source>Nothing is over the limit of its fabric.</source>
        <translation>没有超过面料极限之处。</translation>
    </message>
    <message>
        <source>Over the limit of the fabric: %1 of %2</source>
        <translation>超过面料极限：%2 中的 %1</translation>
    </message>
    <message>
        <source>over the limit of %1</source>
        <translation>超过极限 %1</translation>
    </message>
    <message>
        <source>Show the &amp;largest strain</source>
        <translation>显示最大应变(&amp;L)</translation>
    </message>
</context>
<context>
    <name>bolster::StartHint</name>
    <message>
        <source>A new cover</source>
        <translation>新面套</translation>
    </message>
    <message>
        <source>Draw the first patch, import a frame, or open a design:</source>
        <translation>绘制第一个样片、导入骨架或打开设计：</translation>
    </message>
    <message>
        <source>Or look at a sample:</source>
        <translation>或查看示例：</translation>
    </message>
    <message>
        <source>%1 more are under File &gt; Samples</source>
        <translation>另有 %1 个位于“文件 &gt; 示例”</translation>
    </message>
    <message>
        <source>Go on with:</source>
        <translation>继续：</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>清空此列表</translation>
    </message>
    <message>
        <source>Rectan&amp;gle</source>
        <translation>矩形(&amp;G)</translation>
    </message>
    <message>
        <source>Ou&amp;tline</source>
        <translation>轮廓(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Import frame …</source>
        <translation>导入骨架(&amp;I)…</translation>
    </message>
</context>
<context>
    <name>bolster::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>开始页</translation>
    </message>
    <message>
        <source>Welcome to Bolster</source>
        <translation>欢迎使用 Bolster</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>开始导览</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Back to the design</source>
        <translation>返回设计</translation>
    </message>
    <message>
        <source>What do you have?</source>
        <translation>您有什么？</translation>
    </message>
    <message>
        <source>A frame</source>
        <translation>骨架</translation>
    </message>
    <message>
        <source>The cover is fixed on it: %1</source>
        <translation>面套固定在其上：%1</translation>
    </message>
    <message>
        <source>A pattern</source>
        <translation>样板</translation>
    </message>
    <message>
        <source>Its pieces become the cover: %1</source>
        <translation>其样片构成面套：%1</translation>
    </message>
    <message>
        <source>A scan</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>The cover is fitted to it: %1</source>
        <translation>面套贴合到其上：%1</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>暂无</translation>
    </message>
    <message>
        <source>Draw a rectangle, the first patch</source>
        <translation>绘制矩形，即第一个样片</translation>
    </message>
    <message>
        <source>Go on with</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>清空此列表</translation>
    </message>
    <message>
        <source>Take it out of this list; the file stays</source>
        <translation>从此列表中移除；文件保留</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>未保存的工作</translation>
    </message>
    <message>
        <source>Kept for later, last edit %1</source>
        <translation>留待以后，上次编辑 %1</translation>
    </message>
    <message>
        <source>Left by a crash, last edit %1</source>
        <translation>崩溃后遗留，上次编辑 %1</translation>
    </message>
    <message>
        <source>Begin with a template</source>
        <translation>从模板开始</translation>
    </message>
    <message>
        <source>Look at a sample</source>
        <translation>查看示例</translation>
    </message>
    <message>
        <source>It is not there now</source>
        <translation>目前不在该处</translation>
    </message>
</context>
<context>
    <name>bolster::StatusLine</name>
    <message>
        <source>Nothing to sew yet</source>
        <translation>还没有可缝合的内容</translation>
    </message>
    <message>
        <source>Preparing …</source>
        <translation>正在准备…</translation>
    </message>
    <message>
        <source>Moving, %1/s</source>
        <translation>移动中，%1/s</translation>
    </message>
    <message>
        <source>Solved – %1 iterations</source>
        <translation>已求解——%1 次迭代</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>已暂停</translation>
    </message>
    <message numerus="yes">
        <source>%n problems</source>
        <translation>
            <numerusform>%n 个问题</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n 个警告</numerusform>
        </translation>
    </message>
    <message>
        <source>Solved in part</source>
        <translation>部分求解</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Following the drag</source>
        <translation>跟随拖动</translation>
    </message>
    <message>
        <source>Solved, with warnings</source>
        <translation>已求解，有警告</translation>
    </message>
    <message>
        <source>Show (%1)</source>
        <translation>显示 (%1)</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>The cloth went on moving until the computation was ended. What usually causes that:
• A piece that nothing holds: fix one of its edges, or sew it on.
• A seam whose two sides differ much in length: make them more alike.
• A very long or very narrow piece: divide it, or make it wider.
• High pressure: lower it in the properties of the patch.
What you see is where the cloth was at the end.</source>
        <translation>布料一直移动到计算结束。通常原因：
• 样片没有任何固定：请固定其一条边，或将其缝上。
• 接缝两侧长度相差很大：请使其更接近。
• 样片过长或过窄：请将其划分，或加宽。
• 压力过高：请在样片属性中降低。
您看到的是布料结束时的位置。</translation>
    </message>
    <message>
        <source>Drawing and checking …</source>
        <translation>正在绘制和检查…</translation>
    </message>
    <message>
        <source>Preparing: on fewer triangles …</source>
        <translation>正在准备：用较少的三角形…</translation>
    </message>
    <message>
        <source>Preparing: forces and equations …</source>
        <translation>正在准备：力和方程…</translation>
    </message>
    <message>
        <source>&amp;What does it mean?</source>
        <translation>这是什么意思(&amp;W)？</translation>
    </message>
    <message>
        <source>A preview, not checked yet</source>
        <translation>预览，尚未检查</translation>
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
        <translation>抽取样件(&amp;D)</translation>
    </message>
    <message>
        <source>Solving pieces within tolerances …</source>
        <translation>正在求解公差范围内的样件…</translation>
    </message>
    <message>
        <source>Pieces are drawn at random within their tolerances: where does the cover vary, which tolerance matters, how many pieces are out of the limit?</source>
        <translation>在公差范围内随机抽取样件：面套在何处有差异，哪项公差影响大，有多少样件超出极限？</translation>
    </message>
    <message>
        <source>&amp;Show on the cover what 95 % of the pieces do not exceed</source>
        <translation>在面套上显示 95% 的样件不超过的值(&amp;S)</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>Moves by at most</source>
        <translation>最大移动量</translation>
    </message>
    <message>
        <source>Tolerances by their influence</source>
        <translation>按影响排列的公差</translation>
    </message>
    <message>
        <source>Tolerances (±); 0: none</source>
        <translation>公差 (±)；0：无</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>样件</translation>
    </message>
    <message>
        <source>Every size within is as likely</source>
        <translation>范围内各尺寸的可能性相同</translation>
    </message>
    <message>
        <source>Normal: the tolerance is three standard deviations</source>
        <translation>正态：公差为三倍标准差</translation>
    </message>
    <message>
        <source>Before them ten thousand are drawn as if covers were linear, which takes seconds</source>
        <translation>在此之前先按线性近似抽取一万件，只需数秒</translation>
    </message>
    <message>
        <source>Dr&amp;awn</source>
        <translation>抽取方式(&amp;A)</translation>
    </message>
    <message>
        <source>S&amp;olved</source>
        <translation>求解数(&amp;O)</translation>
    </message>
    <message>
        <source>Nothing varies: give a tolerance above 0 of something that the design has.</source>
        <translation>没有变化：请为设计中存在的某项给出大于 0 的公差。</translation>
    </message>
    <message>
        <source>Covers with each tolerance are solved …</source>
        <translation>正在求解含各公差的面套…</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>That is as if covers were linear; pieces are being solved …</source>
        <translation>这是线性近似的结果；正在求解样件…</translation>
    </message>
    <message>
        <source>That is as if covers were linear.</source>
        <translation>这是线性近似的结果。</translation>
    </message>
    <message numerus="yes">
        <source>By %n solved pieces.</source>
        <translation>
            <numerusform>根据 %n 个已求解的样件。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces have no cover at rest.</source>
        <translation>
            <numerusform>%n 个样件没有静止的面套。</numerusform>
        </translation>
    </message>
    <message>
        <source>What 95 % of the pieces do not exceed</source>
        <translation>95% 的样件不超过的值</translation>
    </message>
    <message>
        <source>The design has changed meanwhile: draw the pieces again.</source>
        <translation>设计在此期间已更改：请重新抽取样件。</translation>
    </message>
    <message numerus="yes">
        <source>By %n solved pieces so far; more are being solved …</source>
        <translation>
            <numerusform>根据目前 %n 个已求解的样件；其余正在求解…</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With %n tolerances no cover is found, as with: %1. They are left out of this: make them smaller.</source>
        <translation>
            <numerusform>有 %n 个公差找不到面套，例如：%1。此处未计入：请将其减小。</numerusform>
        </translation>
    </message>
    <message>
        <source>A piece is out of it when more than 5 % of its cover lie farther from where they should be</source>
        <translation>当面套有 5% 以上距应在之处超过此值时，该样件超出极限</translation>
    </message>
    <message>
        <source>95 % of the pieces do not exceed, place by place, %1 (rms over the cover), %2 where it is most.</source>
        <translation>95% 的样件在各处不超过：%1（面套的均方根），最大处 %2。</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>占比</translation>
    </message>
    <message>
        <source>How much of the variance of the whole cover comes of it</source>
        <translation>整个面套的方差中由它引起的部分</translation>
    </message>
    <message>
        <source>± is what many more of them may change.</source>
        <translation>± 为求解更多时可能的变化。</translation>
    </message>
    <message>
        <source>Out of the limit: about %1 of the pieces.</source>
        <translation>超出极限：约占样件的 %1。</translation>
    </message>
    <message>
        <source>Out of the limit: %1 of %2 pieces (of many: %3 to %4).</source>
        <translation>超出极限：%2 个样件中的 %1 个（大量样件时：%3 至 %4）。</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>These are too few to say how sure that is.</source>
        <translation>数量太少，无法说明其可靠程度。</translation>
    </message>
    <message>
        <source>&amp;Limit for 95 % of a cover</source>
        <translation>面套 95% 的极限(&amp;L)</translation>
    </message>
    <message>
        <source>This is of what was set before: draw pieces for what is set now.</source>
        <translation>这是之前设置的结果：请为现在的设置抽取样件。</translation>
    </message>
</context>
<context>
    <name>bolster::ToolHost</name>
    <message>
        <source>This could not be done, and nothing was changed: %1</source>
        <translation>无法执行，未做任何更改：%1</translation>
    </message>
</context>
<context>
    <name>bolster::TourPanel</name>
    <message>
        <source>Back</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>退出导览</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>导览</translation>
    </message>
    <message>
        <source>Help &gt; Tour goes on from here</source>
        <translation>可从“帮助 &gt; 导览”继续</translation>
    </message>
    <message>
        <source>Tour, %1 of %2</source>
        <translation>导览，第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完成</translation>
    </message>
</context>
<context>
    <name>bolster::TrimTool</name>
    <message>
        <source>Click a seam or an edge of an outline.</source>
        <translation>请单击接缝或轮廓的边。</translation>
    </message>
    <message>
        <source>Click to stitch this seam; stitches and piping are in the properties</source>
        <translation>单击为此接缝缉明线；明线和嵌线在属性中</translation>
    </message>
    <message>
        <source>Click to stitch this edge; stitches and piping are in the properties</source>
        <translation>单击为此边缉明线；明线和嵌线在属性中</translation>
    </message>
    <message>
        <source>Click a seam or an edge of an outline to stitch it – Esc ends the tool</source>
        <translation>单击接缝或轮廓的边以缉明线——Esc 结束工具</translation>
    </message>
</context>
<context>
    <name>bolster::VersionPane</name>
    <message>
        <source>Computing the cover …</source>
        <translation>正在计算面套…</translation>
    </message>
    <message>
        <source>Pattern of %1</source>
        <translation>%1 的样板</translation>
    </message>
    <message>
        <source>Cover of %1</source>
        <translation>%1 的面套</translation>
    </message>
</context>
<context>
    <name>bolster::ViewCube</name>
    <message>
        <source>FRONT</source>
        <translation>前</translation>
    </message>
    <message>
        <source>BACK</source>
        <translation>后</translation>
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
        <translation>单击面、边或角从该处观察；拖动旋转</translation>
    </message>
</context>
</TS>
