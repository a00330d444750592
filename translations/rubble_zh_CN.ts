<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>BundleWords</name>
    <message>
        <source>container</source>
        <translation>容器</translation>
    </message>
    <message>
        <source>equal</source>
        <translation>相同</translation>
    </message>
    <message>
        <source>simulated again, it is the same bit by bit at every recorded instant</source>
        <translation>重新计算后，在每个记录时刻逐位相同</translation>
    </message>
    <message>
        <source>not simulated</source>
        <translation>未计算</translation>
    </message>
    <message>
        <source>not equal</source>
        <translation>不相同</translation>
    </message>
    <message>
        <source>%1, sealed %2</source>
        <translation>%1，封存于 %2</translation>
    </message>
    <message>
        <source>%1, sealed %2 by %3</source>
        <translation>%1，由 %3 封存于 %2</translation>
    </message>
    <message>
        <source>SHA-256 of the key: %1</source>
        <translation>密钥的 SHA-256：%1</translation>
    </message>
    <message>
        <source>SHA-256 of the statement: %1</source>
        <translation>声明的 SHA-256：%1</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1: %2 became %3</source>
        <translation>%1：%2 改为 %3</translation>
    </message>
    <message>
        <source>The bundle is %1.</source>
        <translation>封存包：%1。</translation>
    </message>
</context>
<context>
    <name>ClusterWork</name>
    <message>
        <source>Cancel on the cluster?</source>
        <translation>在集群上取消？</translation>
    </message>
    <message>
        <source>The worlds that wait or run are taken from the cluster. What is made is kept, and starting again submits only what is missing.</source>
        <translation>等待或运行的世界将从集群撤去。已生成的保留，再次开始只提交缺少的。</translation>
    </message>
</context>
<context>
    <name>FolderChoice</name>
    <message>
        <source>%1 is a file, and no folder can have its name.</source>
        <translation>%1 是文件，文件夹不能与其同名。</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2 is no folder that you may write to.</source>
        <translation>无法建立 %1：%2 不是您可写入的文件夹。</translation>
    </message>
    <message>
        <source>Choose another place, or another name.</source>
        <translation>请选择其他位置或其他名称。</translation>
    </message>
</context>
<context>
    <name>HealthGrade</name>
    <message>
        <source>notice</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>finding</source>
        <translation>发现项</translation>
    </message>
    <message>
        <source>tainted</source>
        <translation>存疑</translation>
    </message>
</context>
<context>
    <name>PairsTable</name>
    <message>
        <source>Measured points that the pairs name</source>
        <translation>点对所指的测量点</translation>
    </message>
    <message>
        <source>Points of a total station (*.csv *.txt *.dxf);;All files (*)</source>
        <translation>全站仪的点 (*.csv *.txt *.dxf);;所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>actions</name>
    <message>
        <source>Save the run as one page that any browser opens without network, with both views and its sources</source>
        <translation>把计算保存为一个网页，任何浏览器无需网络即可打开，含两个视图及其来源</translation>
    </message>
    <message>
        <source>Share as a page…</source>
        <translation>共享为网页…</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Open a case or an FE result</source>
        <translation>打开案例或有限元结果</translation>
    </message>
    <message>
        <source>Open the sample</source>
        <translation>打开示例</translation>
    </message>
    <message>
        <source>Open the collapse of the stone arch bridge and simulate it</source>
        <translation>打开石拱桥倒塌示例并进行模拟</translation>
    </message>
    <message>
        <source>Refresh result</source>
        <translation>刷新结果</translation>
    </message>
    <message>
        <source>Look what the analysis has written since, and show it; settings, time and camera stay</source>
        <translation>查看分析程序此后新写出的内容并显示；设置、时间和相机保持不变</translation>
    </message>
    <message>
        <source>Keep copies of results</source>
        <translation>保留结果副本</translation>
    </message>
    <message>
        <source>Keep a compressed copy of every FE result that is read: it opens at once next time</source>
        <translation>为读取的每个有限元结果保留压缩副本：下次可立即打开</translation>
    </message>
    <message>
        <source>Terrain…</source>
        <translation>地形…</translation>
    </message>
    <message>
        <source>Choose the raster of heights that the debris falls on</source>
        <translation>选择承接堆积物的高程栅格</translation>
    </message>
    <message>
        <source>Without terrain</source>
        <translation>不用地形</translation>
    </message>
    <message>
        <source>Let the debris fall on level ground again</source>
        <translation>让堆积物重新落在水平地面上</translation>
    </message>
    <message>
        <source>Save case</source>
        <translation>保存案例</translation>
    </message>
    <message>
        <source>Save the case</source>
        <translation>保存当前案例</translation>
    </message>
    <message>
        <source>Save case as…</source>
        <translation>案例另存为…</translation>
    </message>
    <message>
        <source>Save the case under another name</source>
        <translation>以另一名称保存案例</translation>
    </message>
    <message>
        <source>Save run as…</source>
        <translation>计算另存为…</translation>
    </message>
    <message>
        <source>Save the last run as a run file, for rubble-cli and for later</source>
        <translation>将上一次计算保存为计算文件，供 rubble-cli 和以后使用</translation>
    </message>
    <message>
        <source>Close case</source>
        <translation>关闭案例</translation>
    </message>
    <message>
        <source>Close the case</source>
        <translation>关闭当前案例</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>退出</translation>
    </message>
    <message>
        <source>Leave Rubble</source>
        <translation>退出 Rubble</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Take the last change back</source>
        <translation>撤回上一次更改</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Make the change again</source>
        <translation>重新执行该更改</translation>
    </message>
    <message>
        <source>Settings as delivered</source>
        <translation>默认设置</translation>
    </message>
    <message>
        <source>Apply the default settings</source>
        <translation>应用默认设置</translation>
    </message>
    <message>
        <source>Settings as published</source>
        <translation>论文设置</translation>
    </message>
    <message>
        <source>Apply the settings of the published method</source>
        <translation>应用论文所发表方法的设置</translation>
    </message>
    <message>
        <source>Stacked</source>
        <translation>上下排列</translation>
    </message>
    <message>
        <source>FE view above the fragments</source>
        <translation>有限元视图在上，碎块在下</translation>
    </message>
    <message>
        <source>Beside</source>
        <translation>左右排列</translation>
    </message>
    <message>
        <source>FE view left, fragments right</source>
        <translation>有限元视图在左，碎块在右</translation>
    </message>
    <message>
        <source>FE only</source>
        <translation>仅有限元</translation>
    </message>
    <message>
        <source>Only the conventional FE view</source>
        <translation>仅显示常规有限元视图</translation>
    </message>
    <message>
        <source>Fragments only</source>
        <translation>仅碎块</translation>
    </message>
    <message>
        <source>Only the view with the fragments</source>
        <translation>仅显示碎块视图</translation>
    </message>
    <message>
        <source>Cameras linked</source>
        <translation>相机联动</translation>
    </message>
    <message>
        <source>Both views look from the same place</source>
        <translation>两个视图使用同一视角</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适合窗口</translation>
    </message>
    <message>
        <source>Show the whole model</source>
        <translation>显示整个模型</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>侧视</translation>
    </message>
    <message>
        <source>Look from the side, slightly from above</source>
        <translation>从侧面略偏上方观察</translation>
    </message>
    <message>
        <source>Along y</source>
        <translation>沿 y 轴</translation>
    </message>
    <message>
        <source>Look straight along y</source>
        <translation>正对 y 轴方向观察</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>俯视</translation>
    </message>
    <message>
        <source>Look straight down</source>
        <translation>垂直向下观察</translation>
    </message>
    <message>
        <source>Colours of the system</source>
        <translation>跟随系统配色</translation>
    </message>
    <message>
        <source>Light or dark as the system has it</source>
        <translation>浅色或深色跟随系统</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>浅色配色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>深色配色</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>Simulate the whole collapse as fast as it goes</source>
        <translation>以最快速度模拟整个倒塌过程</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Simulate at the pace of the collapse and watch</source>
        <translation>按倒塌的实际速度模拟并观看</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Stop what runs; what is computed is kept</source>
        <translation>停止正在运行的工作；已计算的内容保留</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>播放或暂停</translation>
    </message>
    <message>
        <source>Back one state</source>
        <translation>后退一个状态</translation>
    </message>
    <message>
        <source>Forward one state</source>
        <translation>前进一个状态</translation>
    </message>
    <message>
        <source>Back ten states</source>
        <translation>后退十个状态</translation>
    </message>
    <message>
        <source>Forward ten states</source>
        <translation>前进十个状态</translation>
    </message>
    <message>
        <source>To the first instant</source>
        <translation>到起始时刻</translation>
    </message>
    <message>
        <source>To the last instant</source>
        <translation>到最后时刻</translation>
    </message>
    <message>
        <source>Figure of this instant…</source>
        <translation>当前时刻的图…</translation>
    </message>
    <message>
        <source>Table of fragments…</source>
        <translation>碎块表…</translation>
    </message>
    <message>
        <source>Save where every fragment went, as CSV</source>
        <translation>将每个碎块的去向保存为 CSV</translation>
    </message>
    <message>
        <source>Series for ParaView…</source>
        <translation>ParaView 序列…</translation>
    </message>
    <message>
        <source>Save fragments and active structure over time, as PVD</source>
        <translation>将碎块和未失效结构随时间的变化保存为 PVD</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>手册</translation>
    </message>
    <message>
        <source>About Rubble</source>
        <translation>关于 Rubble</translation>
    </message>
    <message>
        <source>Version and method</source>
        <translation>版本与方法</translation>
    </message>
    <message>
        <source>Preferences…</source>
        <translation>首选项…</translation>
    </message>
    <message>
        <source>Language, colours, threads, memory, autosave</source>
        <translation>语言、配色、线程、内存、自动保存</translation>
    </message>
    <message>
        <source>The page of the manual about what has the focus</source>
        <translation>手册中与当前焦点相关的页面</translation>
    </message>
    <message>
        <source>Search the manual…</source>
        <translation>搜索手册…</translation>
    </message>
    <message>
        <source>Find words in the manual</source>
        <translation>在手册中查找词语</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>案例</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>编辑</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>模拟计算</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Duplicate scenario</source>
        <translation>复制方案</translation>
    </message>
    <message>
        <source>Go on with a copy of the scenario; the Case panel lists all of them</source>
        <translation>以方案的副本继续；“案例”面板列出全部方案</translation>
    </message>
    <message>
        <source>Compare scenarios…</source>
        <translation>比较方案…</translation>
    </message>
    <message>
        <source>Show in which settings and results two scenarios differ</source>
        <translation>显示两个方案在哪些设置和结果上不同</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>List every edit since the case was opened; a click goes there</source>
        <translation>列出打开案例以来的每次编辑；单击可转到该处</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>重置布局</translation>
    </message>
    <message>
        <source>Put panels, docks and bars back where they were at the first start</source>
        <translation>将面板、停靠窗和工具栏恢复到首次启动时的位置</translation>
    </message>
    <message>
        <source>Play backwards</source>
        <translation>倒放</translation>
    </message>
    <message>
        <source>Play backwards or pause</source>
        <translation>倒放或暂停</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>循环</translation>
    </message>
    <message>
        <source>Playback goes round the range dragged with Shift in the timeline, or round all of it</source>
        <translation>回放在时间轴上按住 Shift 拖出的区间内循环，或整体循环</translation>
    </message>
    <message>
        <source>Loop from here</source>
        <translation>循环起点</translation>
    </message>
    <message>
        <source>The range that playback goes round begins at this instant</source>
        <translation>循环回放的区间从此时刻开始</translation>
    </message>
    <message>
        <source>Loop to here</source>
        <translation>循环终点</translation>
    </message>
    <message>
        <source>The range that playback goes round ends at this instant</source>
        <translation>循环回放的区间在此时刻结束</translation>
    </message>
    <message>
        <source>Bookmark…</source>
        <translation>书签…</translation>
    </message>
    <message>
        <source>Mark this instant with a note; kept in the case</source>
        <translation>以备注标记此时刻；保存在案例中</translation>
    </message>
    <message>
        <source>To the bookmark before</source>
        <translation>到前一个书签</translation>
    </message>
    <message>
        <source>To the next bookmark</source>
        <translation>到后一个书签</translation>
    </message>
    <message>
        <source>Snap to states</source>
        <translation>对准状态</translation>
    </message>
    <message>
        <source>Scrubbing stops at true states and recorded frames only, so that nothing is interpolated</source>
        <translation>浏览只停在真实状态和已记录的帧，不作插值</translation>
    </message>
    <message>
        <source>Time from zero</source>
        <translation>从零计时</translation>
    </message>
    <message>
        <source>Count times from the first state instead of as the FE result has them</source>
        <translation>时间从首个状态算起，而不按有限元结果的时间</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>导览</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>叠加</translation>
    </message>
    <message>
        <source>Fragments and active structure with the outline of the intact structure over them</source>
        <translation>碎块和激活结构，叠加完好结构的轮廓</translation>
    </message>
    <message>
        <source>Four</source>
        <translation>四视图</translation>
    </message>
    <message>
        <source>FE view, fragments, overlay, and the fragments in plan</source>
        <translation>有限元视图、碎块、叠加视图和碎块平面图</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>剖切</translation>
    </message>
    <message>
        <source>Open the model with a plane that can be moved</source>
        <translation>用可移动的平面剖开模型</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Measure distances: two clicks each</source>
        <translation>测量距离：每次单击两点</translation>
    </message>
    <message>
        <source>Measure heights</source>
        <translation>测量高差</translation>
    </message>
    <message>
        <source>Measure differences of height: two clicks each</source>
        <translation>测量高度之差：每次单击两点</translation>
    </message>
    <message>
        <source>Clear measurements</source>
        <translation>清除测量</translation>
    </message>
    <message>
        <source>Take all measured lengths away</source>
        <translation>移除所有测得的长度</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>构件列表</translation>
    </message>
    <message>
        <source>The component tree: what is shown, and of what it is made</source>
        <translation>构件树：显示什么，由什么组成</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>检查器</translation>
    </message>
    <message>
        <source>What is known of what is selected</source>
        <translation>所选内容的已知信息</translation>
    </message>
    <message>
        <source>Along −y</source>
        <translation>沿 −y 轴</translation>
    </message>
    <message>
        <source>Look straight against y</source>
        <translation>逆着 y 轴方向观察</translation>
    </message>
    <message>
        <source>Along x</source>
        <translation>沿 x 轴</translation>
    </message>
    <message>
        <source>Look straight along x</source>
        <translation>正对 x 轴方向观察</translation>
    </message>
    <message>
        <source>Along −x</source>
        <translation>沿 −x 轴</translation>
    </message>
    <message>
        <source>Look straight against x</source>
        <translation>逆着 x 轴方向观察</translation>
    </message>
    <message>
        <source>From below</source>
        <translation>仰视</translation>
    </message>
    <message>
        <source>Look straight up</source>
        <translation>垂直向上观察</translation>
    </message>
    <message>
        <source>From a corner</source>
        <translation>角部视角</translation>
    </message>
    <message>
        <source>Look from a corner above</source>
        <translation>从上方角部观察</translation>
    </message>
    <message>
        <source>Parallel projection</source>
        <translation>平行投影</translation>
    </message>
    <message>
        <source>What is far away is drawn as large as what is near</source>
        <translation>远处与近处按同样大小绘制</translation>
    </message>
    <message>
        <source>Nearer</source>
        <translation>靠近</translation>
    </message>
    <message>
        <source>Go nearer to the middle of the views</source>
        <translation>向视图中心靠近</translation>
    </message>
    <message>
        <source>Farther</source>
        <translation>远离</translation>
    </message>
    <message>
        <source>Go away from the middle of the views</source>
        <translation>从视图中心远离</translation>
    </message>
    <message>
        <source>Turn left</source>
        <translation>左转</translation>
    </message>
    <message>
        <source>Turn the views by 15 degrees</source>
        <translation>将视图转动 15 度</translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation>右转</translation>
    </message>
    <message>
        <source>Turn up</source>
        <translation>上转</translation>
    </message>
    <message>
        <source>Look from 15 degrees higher</source>
        <translation>从高 15 度处观察</translation>
    </message>
    <message>
        <source>Turn down</source>
        <translation>下转</translation>
    </message>
    <message>
        <source>Look from 15 degrees lower</source>
        <translation>从低 15 度处观察</translation>
    </message>
    <message>
        <source>Presentation style</source>
        <translation>展示样式</translation>
    </message>
    <message>
        <source>Every element in the look of its material, alive or fragment</source>
        <translation>每个单元按其材料外观显示，不论存活还是碎块</translation>
    </message>
    <message>
        <source>Shade edges</source>
        <translation>边缘阴影</translation>
    </message>
    <message>
        <source>Darken edges and hollows; takes time on machines without a graphics card</source>
        <translation>加深边缘和凹处；在没有显卡的机器上较慢</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>阴影</translation>
    </message>
    <message>
        <source>One sun, and its shadow on the ground, which is darker beneath what lies on it</source>
        <translation>一个太阳及其在地面上的阴影；地面在其上之物下方更暗</translation>
    </message>
    <message>
        <source>Ground grid</source>
        <translation>地面网格</translation>
    </message>
    <message>
        <source>Lines on the ground</source>
        <translation>地面上的线</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>坐标轴</translation>
    </message>
    <message>
        <source>Directions of x, y and z in every view</source>
        <translation>在每个视图中显示 x、y 和 z 的方向</translation>
    </message>
    <message>
        <source>Standard colour scales</source>
        <translation>标准色标</translation>
    </message>
    <message>
        <source>Birth time and speed in the program&apos;s own scales</source>
        <translation>产生时刻和速度采用程序自身的色标</translation>
    </message>
    <message>
        <source>Colour scale viridis</source>
        <translation>色标 viridis</translation>
    </message>
    <message>
        <source>Birth time and speed in viridis</source>
        <translation>产生时刻和速度采用 viridis</translation>
    </message>
    <message>
        <source>Colour scale cividis</source>
        <translation>色标 cividis</translation>
    </message>
    <message>
        <source>Birth time and speed in cividis</source>
        <translation>产生时刻和速度采用 cividis</translation>
    </message>
    <message>
        <source>Colour scale grey</source>
        <translation>灰度色标</translation>
    </message>
    <message>
        <source>Birth time and speed in greys</source>
        <translation>产生时刻和速度采用灰度</translation>
    </message>
    <message>
        <source>Select by…</source>
        <translation>按条件选择…</translation>
    </message>
    <message>
        <source>Select by component, birth time, cluster or region</source>
        <translation>按构件、产生时刻、聚类或区域选择</translation>
    </message>
    <message>
        <source>Whole clusters</source>
        <translation>整个聚类</translation>
    </message>
    <message>
        <source>Select all fragments that move with those selected</source>
        <translation>选择与所选碎块一起运动的全部碎块</translation>
    </message>
    <message>
        <source>Whole components</source>
        <translation>整个构件</translation>
    </message>
    <message>
        <source>Select all elements of the components of those selected</source>
        <translation>选择所选单元所属构件的全部单元</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>全不选</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>不选择任何内容</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Leave what is selected out of the views; what it covered appears</source>
        <translation>在视图中略去所选内容；其遮挡的部分将显现</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>隔离</translation>
    </message>
    <message>
        <source>Hide everything that is not selected</source>
        <translation>隐藏未选择的全部内容</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>全部显示</translation>
    </message>
    <message>
        <source>Show every component and element again</source>
        <translation>重新显示所有构件和单元</translation>
    </message>
    <message>
        <source>Go to its birth</source>
        <translation>转到其产生时刻</translation>
    </message>
    <message>
        <source>Show the last state at which the selected element is active, with it in the middle</source>
        <translation>显示所选单元最后激活的状态，并置于中央</translation>
    </message>
    <message>
        <source>Table of selected fragments…</source>
        <translation>所选碎块表…</translation>
    </message>
    <message>
        <source>Save where the selected fragments went, as CSV</source>
        <translation>将所选碎块的去向保存为 CSV</translation>
    </message>
    <message>
        <source>View…</source>
        <translation>视图…</translation>
    </message>
    <message>
        <source>Open a view…</source>
        <translation>打开视图…</translation>
    </message>
    <message>
        <source>Look at the model as a saved view did</source>
        <translation>按已保存的视图观察模型</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>外观</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>Add photographs…</source>
        <translation>添加照片…</translation>
    </message>
    <message>
        <source>Add photographs of the site to the case</source>
        <translation>向案例添加现场照片</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>添加点</translation>
    </message>
    <message>
        <source>Click a point in the photograph, then the same point in the model</source>
        <translation>单击照片中的一点，然后单击模型中的同一点</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>照片</translation>
    </message>
    <message>
        <source>Show the photograph alone</source>
        <translation>仅显示照片</translation>
    </message>
    <message>
        <source>Swipe</source>
        <translation>划分</translation>
    </message>
    <message>
        <source>Show photograph and simulation to both sides of a line</source>
        <translation>在一条线两侧显示照片和模拟</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>叠合</translation>
    </message>
    <message>
        <source>Lay the simulation over the photograph</source>
        <translation>将模拟叠加在照片上</translation>
    </message>
    <message>
        <source>Blink</source>
        <translation>交替</translation>
    </message>
    <message>
        <source>Show photograph and simulation in turn</source>
        <translation>轮流显示照片和模拟</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Draw the outline of the simulated debris on the photograph</source>
        <translation>在照片上画出模拟堆积物的轮廓</translation>
    </message>
    <message>
        <source>Model beside the photograph</source>
        <translation>照片旁的模型</translation>
    </message>
    <message>
        <source>Show or hide the model beside the photograph</source>
        <translation>显示或隐藏照片旁的模型</translation>
    </message>
    <message>
        <source>Compare debris</source>
        <translation>比较堆积物</translation>
    </message>
    <message>
        <source>Hold the silhouette of the simulated debris against the outline drawn on the photograph</source>
        <translation>将模拟堆积物的剪影与照片上画出的轮廓对照</translation>
    </message>
    <message>
        <source>Look through the camera</source>
        <translation>从相机看</translation>
    </message>
    <message>
        <source>Let the fragment view look as the matched camera does</source>
        <translation>使碎块视图采用匹配所得相机的视角</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>证据</translation>
    </message>
    <message>
        <source>New case…</source>
        <translation>新建案例…</translation>
    </message>
    <message>
        <source>Make a case from an FE result step by step: units, ground, components, deaths</source>
        <translation>由有限元结果逐步建立案例：单位、地面、构件、失效</translation>
    </message>
    <message>
        <source>Save the views, or the arrangement of a published figure, for print: PNG, SVG or PDF</source>
        <translation>保存视图或已发表插图的排版，用于印刷：PNG、SVG 或 PDF</translation>
    </message>
    <message>
        <source>Movie…</source>
        <translation>动画…</translation>
    </message>
    <message>
        <source>Save the collapse as a movie: MP4 or numbered pictures</source>
        <translation>把倒塌过程保存为动画：MP4 或编号图片</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>报告…</translation>
    </message>
    <message>
        <source>Write a report of the run as PDF and HTML</source>
        <translation>把计算写成 PDF 和 HTML 报告</translation>
    </message>
    <message>
        <source>Fragments as glTF…</source>
        <translation>glTF 格式的碎块…</translation>
    </message>
    <message>
        <source>Save the fragments with their motion for Blender and web viewers, as glTF</source>
        <translation>将碎块及其运动保存为 glTF，供 Blender 和网页查看器使用</translation>
    </message>
    <message>
        <source>Another scenario</source>
        <translation>另一方案</translation>
    </message>
    <message>
        <source>Fragments of this scenario left, those of another one right, seen from the same place</source>
        <translation>左侧为本方案的碎块，右侧为另一方案的碎块，视点相同</translation>
    </message>
    <message>
        <source>Orthophoto…</source>
        <translation>正射影像…</translation>
    </message>
    <message>
        <source>Drape a picture from above over the ground</source>
        <translation>将俯视影像铺在地面上</translation>
    </message>
    <message>
        <source>Surroundings…</source>
        <translation>周围环境…</translation>
    </message>
    <message>
        <source>Show meshes of what stands around: OBJ, PLY, glTF</source>
        <translation>显示周围物体的网格：OBJ、PLY、glTF</translation>
    </message>
    <message>
        <source>Without surroundings</source>
        <translation>不用周围环境</translation>
    </message>
    <message>
        <source>Leave orthophoto and meshes out</source>
        <translation>撤除正射影像和网格</translation>
    </message>
    <message>
        <source>Site…</source>
        <translation>场地…</translation>
    </message>
    <message>
        <source>Coordinate system, control points, heights, collision</source>
        <translation>坐标系、控制点、高程、碰撞</translation>
    </message>
    <message>
        <source>Add survey…</source>
        <translation>添加测绘…</translation>
    </message>
    <message>
        <source>Add a surveyed height model or outline of the real debris to the case</source>
        <translation>将实际堆积物的测绘高程模型或轮廓加入案例</translation>
    </message>
    <message>
        <source>Compare with survey</source>
        <translation>与测绘比较</translation>
    </message>
    <message>
        <source>Hold the debris at rest against the survey that is chosen</source>
        <translation>将静止的堆积物与所选测绘对照</translation>
    </message>
    <message>
        <source>Ensemble</source>
        <translation>系综</translation>
    </message>
    <message>
        <source>Show how sure it is where debris lies, with what is not known drawn anew</source>
        <translation>显示在未知量重新抽取时堆积物位置有多确定</translation>
    </message>
    <message>
        <source>Simulate members</source>
        <translation>模拟成员</translation>
    </message>
    <message>
        <source>Simulate the members of the ensemble; those of an earlier start are taken from the cache</source>
        <translation>模拟系综的成员；先前已完成的从缓存中取用</translation>
    </message>
    <message>
        <source>Which cause</source>
        <translation>哪个原因</translation>
    </message>
    <message>
        <source>Show which of several supposed causes explains what was found</source>
        <translation>显示若干假定原因中哪一个能解释现场所见</translation>
    </message>
    <message>
        <source>Compare causes</source>
        <translation>比较原因</translation>
    </message>
    <message>
        <source>Simulate the ensembles of the causes that are ticked and hold them against what was found</source>
        <translation>模拟所勾选原因的系综，并与现场所见对照</translation>
    </message>
    <message>
        <source>Series in one file…</source>
        <translation>单文件序列…</translation>
    </message>
    <message>
        <source>Save fragments and active structure over time for ParaView 5.12 and newer, as VTKHDF</source>
        <translation>将随时间变化的碎块和有效结构保存为 VTKHDF，供 ParaView 5.12 及更新版本使用</translation>
    </message>
    <message>
        <source>Debris map…</source>
        <translation>堆积物图…</translation>
    </message>
    <message>
        <source>Save where the debris of the run lies, as GeoTIFF, GeoPackage, CSV or PNG</source>
        <translation>将本次计算的堆积物位置保存为 GeoTIFF、GeoPackage、CSV 或 PNG</translation>
    </message>
    <message>
        <source>Debris map</source>
        <translation>堆积物图</translation>
    </message>
    <message>
        <source>Where the debris of this run lies, seen from above, beside the views</source>
        <translation>本次计算的堆积物位于何处，俯视，显示在视图旁</translation>
    </message>
    <message>
        <source>Fragment table</source>
        <translation>碎块表</translation>
    </message>
    <message>
        <source>All fragments in a table; show only those of some speed, mass, size, birth or component</source>
        <translation>以表格列出所有碎块；可只显示某种速度、质量、尺寸、产生时刻或构件的碎块</translation>
    </message>
    <message>
        <source>History curves</source>
        <translation>时程曲线</translation>
    </message>
    <message>
        <source>Speed, height and energy over time, of what is selected or of all fragments</source>
        <translation>选中内容或所有碎块的速度、高度和能量随时间的变化</translation>
    </message>
    <message>
        <source>Camera key here</source>
        <translation>在此设相机关键帧</translation>
    </message>
    <message>
        <source>Keep the camera of the fragments at this instant: movies move from key to key</source>
        <translation>保存此时刻碎块视图的相机：动画从一个关键帧移动到下一个</translation>
    </message>
    <message>
        <source>Remove the camera key</source>
        <translation>删除相机关键帧</translation>
    </message>
    <message>
        <source>Remove the camera key of this instant</source>
        <translation>删除此时刻的相机关键帧</translation>
    </message>
    <message>
        <source>Look along the camera keys</source>
        <translation>沿相机关键帧观看</translation>
    </message>
    <message>
        <source>The views move from camera key to camera key as time goes on, as a movie does</source>
        <translation>视图随时间从一个相机关键帧移动到下一个，与动画相同</translation>
    </message>
    <message>
        <source>Validation…</source>
        <translation>验证…</translation>
    </message>
    <message>
        <source>How far simulated falls are from measured ones: the known rate of error</source>
        <translation>模拟的下落离实测的下落有多远：已知的误差率</translation>
    </message>
    <message>
        <source>Seal…</source>
        <translation>封存…</translation>
    </message>
    <message>
        <source>Sign the case with all it stands on as one bundle that can be handed over and checked</source>
        <translation>将案例及其所依据的一切签名为一个可以移交和核验的封存包</translation>
    </message>
    <message>
        <source>Open sealed…</source>
        <translation>打开封存包…</translation>
    </message>
    <message>
        <source>What this window is for, a sentence at a time: over the open case, else over the sample</source>
        <translation>此窗口的用途，每次一句：在打开的案例上，否则在示例上</translation>
    </message>
    <message>
        <source>Kept runs…</source>
        <translation>保留的计算…</translation>
    </message>
    <message>
        <source>The runs that are kept of all cases, with their sizes: open or remove them</source>
        <translation>所有案例保留的计算及其大小：可打开或移除</translation>
    </message>
    <message>
        <source>Measure distances to the cloud</source>
        <translation>量取到点云的距离</translation>
    </message>
    <message>
        <source>Colour the points of the chosen cloud by how far the simulated site lies from them</source>
        <translation>按模拟现场与所选点云各点的距离为点着色</translation>
    </message>
    <message>
        <source>Points of the cloud</source>
        <translation>点云的点</translation>
    </message>
    <message>
        <source>Draw the points of the surveyed cloud that is chosen in the Evidence panel</source>
        <translation>画出“证据”面板中所选测绘点云的点</translation>
    </message>
    <message>
        <source>It acts on the views, which a page covers now: Esc closes the page</source>
        <translation>它作用于视图，而视图现被一页遮住：Esc 关闭该页</translation>
    </message>
    <message>
        <source>Save what the views show and how, for rubble-cli figure and for later</source>
        <translation>保存视图所示内容和方式，供命令行和以后使用</translation>
    </message>
    <message>
        <source>Compare two clouds…</source>
        <translation>比较两个点云…</translation>
    </message>
    <message>
        <source>Measure distances and volumes from one point cloud to another, as of before and after</source>
        <translation>量取一个点云到另一个点云的距离和体积，例如倒塌前后</translation>
    </message>
    <message>
        <source>Scan the run…</source>
        <translation>扫描计算…</translation>
    </message>
    <message>
        <source>Make a point cloud as laser scanners would take it of what the run leaves</source>
        <translation>像激光扫描仪那样从计算留下之物生成点云</translation>
    </message>
    <message>
        <source>Check a sealed bundle, simulate its runs again, open its case to be read only, and add custody, addenda or a time stamp</source>
        <translation>核验封存包，重新计算其中的计算，以只读方式打开其案例，并加入保管条目、附录或时间戳</translation>
    </message>
</context>
<context>
    <name>choices</name>
    <message>
        <source>-x</source>
        <translation>-x</translation>
    </message>
    <message>
        <source>-y</source>
        <translation>-y</translation>
    </message>
    <message>
        <source>-z</source>
        <translation>-z</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>按轴</translation>
    </message>
    <message>
        <source>axis box</source>
        <translation>轴向包围盒</translation>
    </message>
    <message>
        <source>bullet</source>
        <translation>Bullet</translation>
    </message>
    <message>
        <source>component box</source>
        <translation>构件包围盒</translation>
    </message>
    <message>
        <source>compound</source>
        <translation>组合体</translation>
    </message>
    <message>
        <source>concrete</source>
        <translation>混凝土</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>精确</translation>
    </message>
    <message>
        <source>fe</source>
        <translation>有限元</translation>
    </message>
    <message>
        <source>follow</source>
        <translation>跟随</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>坐标框架</translation>
    </message>
    <message>
        <source>g-cm-s</source>
        <translation>g-cm-s</translation>
    </message>
    <message>
        <source>g-cm-us</source>
        <translation>g-cm-us</translation>
    </message>
    <message>
        <source>g-mm-ms</source>
        <translation>g-mm-ms</translation>
    </message>
    <message>
        <source>g-mm-s</source>
        <translation>g-mm-s</translation>
    </message>
    <message>
        <source>grid boxes</source>
        <translation>网格盒</translation>
    </message>
    <message>
        <source>held</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>hull</source>
        <translation>凸包</translation>
    </message>
    <message>
        <source>kg-m-s</source>
        <translation>kg-m-s</translation>
    </message>
    <message>
        <source>kg-mm-ms</source>
        <translation>kg-mm-ms</translation>
    </message>
    <message>
        <source>kg-mm-s</source>
        <translation>kg-mm-s</translation>
    </message>
    <message>
        <source>kip-in-s</source>
        <translation>kip-in-s</translation>
    </message>
    <message>
        <source>latch</source>
        <translation>锁定</translation>
    </message>
    <message>
        <source>lbf-ft-s</source>
        <translation>lbf-ft-s</translation>
    </message>
    <message>
        <source>lbf-in-s</source>
        <translation>lbf-in-s</translation>
    </message>
    <message>
        <source>masonry</source>
        <translation>砌体</translation>
    </message>
    <message>
        <source>nested</source>
        <translation>嵌套</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>oriented box</source>
        <translation>有向包围盒</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>released</source>
        <translation>释放</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>soft-step</source>
        <translation>软步法</translation>
    </message>
    <message>
        <source>soil</source>
        <translation>土</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>steel</source>
        <translation>钢</translation>
    </message>
    <message>
        <source>stone</source>
        <translation>石材</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>t-m-s</source>
        <translation>t-m-s</translation>
    </message>
    <message>
        <source>t-mm-s</source>
        <translation>t-mm-s</translation>
    </message>
    <message>
        <source>water bed</source>
        <translation>水底</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>beam</source>
        <translation>梁</translation>
    </message>
    <message>
        <source>hexahedron</source>
        <translation>六面体</translation>
    </message>
    <message>
        <source>pyramid</source>
        <translation>棱锥</translation>
    </message>
    <message>
        <source>quadrilateral</source>
        <translation>四边形</translation>
    </message>
    <message>
        <source>tetrahedron</source>
        <translation>四面体</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>wedge</source>
        <translation>楔形体</translation>
    </message>
    <message>
        <source>at once</source>
        <translation>立即</translation>
    </message>
    <message>
        <source>bricks</source>
        <translation>砖块</translation>
    </message>
</context>
<context>
    <name>compass</name>
    <message>
        <source>E</source>
        <translation>东</translation>
    </message>
    <message>
        <source>NE</source>
        <translation>东北</translation>
    </message>
    <message>
        <source>N</source>
        <translation>北</translation>
    </message>
    <message>
        <source>NW</source>
        <translation>西北</translation>
    </message>
    <message>
        <source>W</source>
        <translation>西</translation>
    </message>
    <message>
        <source>SW</source>
        <translation>西南</translation>
    </message>
    <message>
        <source>S</source>
        <translation>南</translation>
    </message>
    <message>
        <source>SE</source>
        <translation>东南</translation>
    </message>
</context>
<context>
    <name>figures</name>
    <message>
        <source>%1 high</source>
        <translation>高 %1</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>The settings of the program could not be read.</source>
        <translation>无法读取程序的设置。</translation>
    </message>
    <message>
        <source>They start anew; the file was set aside as %1.</source>
        <translation>设置重新开始；该文件已另存为 %1。</translation>
    </message>
</context>
<context>
    <name>manual</name>
    <message>
        <source>Actions and keys</source>
        <translation>操作与按键</translation>
    </message>
    <message>
        <source>Menu|Action|Key|What it does</source>
        <translation>菜单|操作|按键|作用</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Every setting of a scenario, as the panels, `rubble-cli --set key=value` and the case file know it.</source>
        <translation>方案的全部设置，与面板、`rubble-cli --set key=value` 和案例文件中的一致。</translation>
    </message>
    <message>
        <source>Key|Meaning|Unit|Default|Values|What it does and what it costs</source>
        <translation>键|含义|单位|默认|取值|作用与代价</translation>
    </message>
</context>
<context>
    <name>messages</name>
    <message>
        <source>Fragments</source>
        <translation>碎块</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; cannot be the name of a regrouped component</source>
        <translation>“{0}”不能作为重新分组后构件的名称</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is not a pair of materials.</source>
        <translation>“{0}”不是一对材料。</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is not an axis that can point up</source>
        <translation>“{0}”不是可以指向上方的坐标轴</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; never meet: no body is made of either.</source>
        <translation>“{0}”不会相遇：没有刚体由其中任一材料制成。</translation>
    </message>
    <message>
        <source>, or auto</source>
        <translation>，或 auto</translation>
    </message>
    <message>
        <source>.cdb, with its .mac</source>
        <translation>.cdb，附其 .mac</translation>
    </message>
    <message>
        <source>.fil with its .inp</source>
        <translation>.fil，附其 .inp</translation>
    </message>
    <message>
        <source>.frd with its .inp</source>
        <translation>.frd，附其 .inp</translation>
    </message>
    <message>
        <source>.h5, made by rubble-cli convert</source>
        <translation>.h5，由 rubble-cli convert 生成</translation>
    </message>
    <message>
        <source>.rst with a list of deaths</source>
        <translation>.rst，附失效清单</translation>
    </message>
    <message>
        <source>0.95 is what is usual.</source>
        <translation>通常取 0.95。</translation>
    </message>
    <message>
        <source>2 repeats and 1e-6 m are usual.</source>
        <translation>通常重复 2 次，扰动 1e-6 m。</translation>
    </message>
    <message>
        <source>32 lower-case hexadecimal digits</source>
        <translation>32 位小写十六进制数字</translation>
    </message>
    <message>
        <source>@(#)ADF Database</source>
        <translation>@(#)ADF Database</translation>
    </message>
    <message>
        <source>No material has this density: they have {0} to {1}</source>
        <translation>没有材料具有此密度：材料密度为 {0} 至 {1}</translation>
    </message>
    <message>
        <source>A dying element has positions that are not numbers and makes no fragment</source>
        <translation>某失效单元的位置含非数值，不生成碎块</translation>
    </message>
    <message>
        <source>A dying element is too large or too fast for numbers and makes no fragment</source>
        <translation>某失效单元过大或过快，超出数值范围，不生成碎块</translation>
    </message>
    <message>
        <source>A few dozen pairs are enough.</source>
        <translation>几十对点就足够。</translation>
    </message>
    <message>
        <source>A figure of {0} x {1} pixels at {2} dpi cannot be drawn</source>
        <translation>无法绘制 {0} x {1} 像素、{2} dpi 的图</translation>
    </message>
    <message>
        <source>A fragment is thinner than the engine can bear: its solid is thickened, its mass is not</source>
        <translation>某碎块薄于引擎所能承受：其实体被加厚，质量不变</translation>
    </message>
    <message>
        <source>A map cannot have cells of {0}.</source>
        <translation>地图的单元格不能为 {0}。</translation>
    </message>
    <message>
        <source>A map of {0} x {1} pixels at {2} dpi cannot be drawn</source>
        <translation>无法绘制 {0} x {1} 像素、{2} dpi 的地图</translation>
    </message>
    <message>
        <source>A map with cells of {0} would take too many of them: the debris is too large or too far away for it.</source>
        <translation>单元格为 {0} 的地图需要过多单元格：堆积物过大或过远。</translation>
    </message>
    <message>
        <source>A picture of {0} x {1} pixels with these settings of its camera cannot be matched.</source>
        <translation>{0} x {1} 像素且采用这些相机设置的照片无法匹配。</translation>
    </message>
    <message>
        <source>A regrouping step holds a number that is not finite</source>
        <translation>某重新分组步骤含有非有限数值</translation>
    </message>
    <message>
        <source>A regrouping step moved no elements</source>
        <translation>某重新分组步骤未移动任何单元</translation>
    </message>
    <message>
        <source>A repeat floor takes at least 1 repeat and a birth shift above zero.</source>
        <translation>重复性下限至少需要 1 次重复和大于零的产生位置扰动。</translation>
    </message>
    <message>
        <source>A result could not be kept for a second start.</source>
        <translation>某项结果无法保留供再次启动使用。</translation>
    </message>
    <message>
        <source>A state within the series is cut off or of another length; it was left out</source>
        <translation>序列中某状态被截断或长度不同；已略去</translation>
    </message>
    <message>
        <source>A sweep has 1 to {0} settings; {1} were asked for.</source>
        <translation>一次对比可含 1 至 {0} 项设置；请求了 {1} 项。</translation>
    </message>
    <message>
        <source>A terrain with its first node at ({0}, {1}) and cells of {2} has no place</source>
        <translation>首节点在 ({0}, {1})、单元格为 {2} 的地形没有位置</translation>
    </message>
    <message>
        <source>A world that was kept under this name was simulated from something else: it is not compared.</source>
        <translation>以此名称保留的计算来自其他输入：不予比较。</translation>
    </message>
    <message>
        <source>A world was simulated on another machine: its debris is compared, its figures of time are not.</source>
        <translation>某次计算是在另一台机器上模拟的：比较其堆积物，不比较其时间。</translation>
    </message>
    <message>
        <source>ACI 318 (2019): concrete on hardened concrete that was not roughened 0.6</source>
        <translation>ACI 318 (2019)：混凝土对未凿毛的硬化混凝土 0.6</translation>
    </message>
    <message>
        <source>Abaqus results file</source>
        <translation>Abaqus 结果文件</translation>
    </message>
    <message>
        <source>Accept a live rate of about {0}, merge small components into their neighbours, or raise bodies_max if this machine moves more</source>
        <translation>接受约 {0} 的实时帧率，将小构件并入相邻构件，或在本机能承载更多时提高 bodies_max</translation>
    </message>
    <message>
        <source>Add it, or take the last good copy.</source>
        <translation>补上它，或采用上一份完好的副本。</translation>
    </message>
    <message>
        <source>Add pairs, or give the focal length.</source>
        <translation>增加点对，或给出焦距。</translation>
    </message>
    <message>
        <source>Add points at other distances and in other corners of the picture, or find fewer numbers.</source>
        <translation>增加位于其他距离和照片其他角落的点，或减少待求参数。</translation>
    </message>
    <message>
        <source>Add points in front of or behind that plane, or give the focal length.</source>
        <translation>增加该平面前方或后方的点，或给出焦距。</translation>
    </message>
    <message>
        <source>Add points in front of or behind the others.</source>
        <translation>增加位于其他点前方或后方的点。</translation>
    </message>
    <message>
        <source>Add points well away from that line.</source>
        <translation>增加远离该直线的点。</translation>
    </message>
    <message>
        <source>Along {0} the grid of {1} is larger than the smallest structural component, &quot;{2}&quot; with {3}</source>
        <translation>沿 {0}，网格 {1} 大于最小结构构件“{2}”（{3}）</translation>
    </message>
    <message>
        <source>Along {0} the grid of {1} is smaller than the largest fragment, element {2} of &quot;{3}&quot; with {4}</source>
        <translation>沿 {0}，网格 {1} 小于最大碎块，即“{3}”的单元 {2}（{4}）</translation>
    </message>
    <message>
        <source>Along {0} the largest fragment, element {1} of &quot;{2}&quot; with {3}, exceeds the smallest structural component, &quot;{4}&quot; with {5}</source>
        <translation>沿 {0}，最大碎块，即“{2}”的单元 {1}（{3}），超过最小结构构件“{4}”（{5}）</translation>
    </message>
    <message>
        <source>Along {0} the mean distance of the fragments, {1}, exceeds the smallest structural component, &quot;{2}&quot; with {3}; the largest fragment is element {4} of &quot;{5}&quot; with {6}</source>
        <translation>沿 {0}，碎块平均间距 {1} 超过最小结构构件“{2}”（{3}）；最大碎块为“{5}”的单元 {4}（{6}）</translation>
    </message>
    <message>
        <source>Altair Binary</source>
        <translation>Altair Binary</translation>
    </message>
    <message>
        <source>An acknowledgement needs a {0}.</source>
        <translation>确认需要填写{0}。</translation>
    </message>
    <message>
        <source>An element comes back to life after its death</source>
        <translation>某单元失效后又复活</translation>
    </message>
    <message>
        <source>An element has no volume at its death: a box of the minimum thickness stands for it</source>
        <translation>某单元失效时没有体积：以最小厚度的盒代替</translation>
    </message>
    <message>
        <source>An element is a sliver at its death: a box of the minimum thickness stands for it</source>
        <translation>某单元失效时为薄片：以最小厚度的盒代替</translation>
    </message>
    <message>
        <source>An element is folded through itself at its death: a box stands for it</source>
        <translation>某单元失效时自身翻折：以盒代替</translation>
    </message>
    <message>
        <source>An element is inactive at every state and makes no fragment</source>
        <translation>某单元在所有状态均未激活，不生成碎块</translation>
    </message>
    <message>
        <source>An element is inactive at first and appears later</source>
        <translation>某单元起初未激活，后来出现</translation>
    </message>
    <message>
        <source>An element is inside out at its death: its corners are numbered anew</source>
        <translation>某单元失效时内外翻转：其角点重新编号</translation>
    </message>
    <message>
        <source>An element without volume at rest weighs what its fragment&apos;s solid would</source>
        <translation>静止时没有体积的单元按其碎块实体计重</translation>
    </message>
    <message>
        <source>An exact death time lies outside the states between which the element dies</source>
        <translation>精确失效时刻不在单元失效的两个状态之间</translation>
    </message>
    <message>
        <source>Another program makes the copy</source>
        <translation>另一程序正在生成该副本</translation>
    </message>
    <message>
        <source>Ansys coded database</source>
        <translation>Ansys 编码数据库</translation>
    </message>
    <message>
        <source>Ansys results</source>
        <translation>Ansys 结果</translation>
    </message>
    <message>
        <source>As computed</source>
        <translation>按计算值</translation>
    </message>
    <message>
        <source>Ask for 16 to {0} pixels a side and 20 to 2400 dpi.</source>
        <translation>请给出每边 16 至 {0} 像素、20 至 2400 dpi。</translation>
    </message>
    <message>
        <source>Ask for 2 repeats or more.</source>
        <translation>请给出 2 次或更多重复。</translation>
    </message>
    <message>
        <source>Ask for {0} to {1} pixels a side and 20 to 2400 dpi.</source>
        <translation>请给出每边 {0} 至 {1} 像素、20 至 2400 dpi。</translation>
    </message>
    <message>
        <source>Auditing deaths</source>
        <translation>正在核查失效</translation>
    </message>
    <message>
        <source>Baltay &amp; Gjelsvik (1990): sliding about 0.47; Rabbat &amp; Russell (1985): cast on, at rest, 0.57-0.70</source>
        <translation>Baltay &amp; Gjelsvik (1990)：滑动约 0.47；Rabbat &amp; Russell (1985)：现浇、静止 0.57-0.70</translation>
    </message>
    <message>
        <source>Blocks without attribute names: their first attribute was taken for thickness or area</source>
        <translation>单元块没有属性名：其第一个属性被当作厚度或面积</translation>
    </message>
    <message>
        <source>CalculiX results</source>
        <translation>CalculiX 结果</translation>
    </message>
    <message>
        <source>Cannot make the folder {0}: {1}</source>
        <translation>无法建立文件夹 {0}：{1}</translation>
    </message>
    <message>
        <source>Cannot read the input deck {0}</source>
        <translation>无法读取输入卡 {0}</translation>
    </message>
    <message>
        <source>Cannot read the run file {0}: {1}</source>
        <translation>无法读取计算文件 {0}：{1}</translation>
    </message>
    <message>
        <source>Cannot read {0}: {1}</source>
        <translation>无法读取 {0}：{1}</translation>
    </message>
    <message>
        <source>Cannot write the run file {0}: {1}</source>
        <translation>无法写入计算文件 {0}：{1}</translation>
    </message>
    <message>
        <source>Cannot write {0}: {1}</source>
        <translation>无法写入 {0}：{1}</translation>
    </message>
    <message>
        <source>Cases (*.rubble)</source>
        <translation>案例 (*.rubble)</translation>
    </message>
    <message>
        <source>Cell arrays with one component: {0}</source>
        <translation>单分量的单元数组：{0}</translation>
    </message>
    <message>
        <source>Cells of a type that makes no fragment were left out</source>
        <translation>不生成碎块的单元类型已略去</translation>
    </message>
    <message>
        <source>Cells were taken apart into solids, shells or beams, which die together</source>
        <translation>一些网格单元被拆分为实体、壳或梁，它们一起失效</translation>
    </message>
    <message>
        <source>Check free space and rights of the folder, or choose another place.</source>
        <translation>请检查剩余空间和文件夹权限，或选择其他位置。</translation>
    </message>
    <message>
        <source>Check free space and rights of the folder, or choose another place; what was there before is unchanged.</source>
        <translation>请检查剩余空间和文件夹权限，或选择其他位置；原有内容未变。</translation>
    </message>
    <message>
        <source>Check it, or set component[NAME].section.</source>
        <translation>请检查，或设置 component[NAME].section。</translation>
    </message>
    <message>
        <source>Check rights and free space, or choose another place.</source>
        <translation>请检查权限和剩余空间，或选择其他位置。</translation>
    </message>
    <message>
        <source>Check that all files are of one run; move the others away.</source>
        <translation>请检查所有文件是否属于同一次分析；将其他文件移走。</translation>
    </message>
    <message>
        <source>Check that it is the deck of this result.</source>
        <translation>请检查它是否为此结果的输入卡。</translation>
    </message>
    <message>
        <source>Check that list and result belong together.</source>
        <translation>请检查清单与结果是否对应。</translation>
    </message>
    <message>
        <source>Check that the file exists and that you may read it.</source>
        <translation>请检查文件是否存在以及您是否有读取权限。</translation>
    </message>
    <message>
        <source>Check that the folder exists, may be written and has room.</source>
        <translation>请检查文件夹是否存在、可写且有空间。</translation>
    </message>
    <message>
        <source>Check the disk if this is said again.</source>
        <translation>若再次出现，请检查磁盘。</translation>
    </message>
    <message>
        <source>Check the element&apos;s nodes, or its thickness or section.</source>
        <translation>请检查该单元的节点、厚度或截面。</translation>
    </message>
    <message>
        <source>Check the masses, or set component[NAME].density.</source>
        <translation>请检查质量，或设置 component[NAME].density。</translation>
    </message>
    <message>
        <source>Check the node order of the element; a solver that lets elements invert may need other limits.</source>
        <translation>请检查单元的节点次序；允许单元翻转的求解器可能需要其他限值。</translation>
    </message>
    <message>
        <source>Check the path and that you may read the file.</source>
        <translation>请检查路径以及您是否有读取权限。</translation>
    </message>
    <message>
        <source>Check the path, or leave the terrain out.</source>
        <translation>请检查路径，或不使用地形。</translation>
    </message>
    <message>
        <source>Check the rights of the folder.</source>
        <translation>请检查文件夹权限。</translation>
    </message>
    <message>
        <source>Check the step&apos;s box, plane or component, or remove the step.</source>
        <translation>请检查该步骤的盒、平面或构件，或删除该步骤。</translation>
    </message>
    <message>
        <source>Check the units of the file and set component[NAME].density in kg/m3.</source>
        <translation>请检查文件单位，并以 kg/m3 设置 component[NAME].density。</translation>
    </message>
    <message>
        <source>Check the variable: --set status_variable=NAME and active_value say another.</source>
        <translation>请检查该变量：用 --set status_variable=NAME 和 active_value 另行指定。</translation>
    </message>
    <message>
        <source>Check these elements; the file may be damaged.</source>
        <translation>请检查这些单元；文件可能已损坏。</translation>
    </message>
    <message>
        <source>Check which point belongs to which, the size of the picture and the focal length; more good pairs show which ones are wrong.</source>
        <translation>请检查点的对应关系、照片尺寸和焦距；更多正确的点对可显示哪些有误。</translation>
    </message>
    <message>
        <source>Checking {0}</source>
        <translation>正在检查 {0}</translation>
    </message>
    <message>
        <source>Choose another folder, or make room there.</source>
        <translation>请选择其他文件夹，或腾出空间。</translation>
    </message>
    <message>
        <source>Choose another name, or move the folder away.</source>
        <translation>请选择其他名称，或移走该文件夹。</translation>
    </message>
    <message>
        <source>Choose larger cells if memory is short; else look at the coordinate system of the case.</source>
        <translation>若内存不足请选择更大的单元格；否则请查看案例的坐标系。</translation>
    </message>
    <message>
        <source>Choose larger cells, or look for bodies that left the site.</source>
        <translation>请选择更大的单元格，或查找离开场地的刚体。</translation>
    </message>
    <message>
        <source>Choose larger cells, or write a table, which lists only cells that hold something.</source>
        <translation>请选择更大的单元格，或输出仅列出非空单元格的表格。</translation>
    </message>
    <message>
        <source>Choose one of default, paper, reference.</source>
        <translation>请选择 default、paper、reference 之一。</translation>
    </message>
    <message>
        <source>Choose one of {0}.</source>
        <translation>请选择 {0} 之一。</translation>
    </message>
    <message>
        <source>Compare runs of the same FE result with the same cells and shares.</source>
        <translation>请以相同的单元格和比例比较同一有限元结果的计算。</translation>
    </message>
    <message>
        <source>Compare the deaths with the analysis.</source>
        <translation>请将失效情况与分析对照。</translation>
    </message>
    <message>
        <source>Compare the masses with the analysis, or write quadratic elements.</source>
        <translation>请与分析比较质量，或写出二次单元。</translation>
    </message>
    <message>
        <source>Contours cannot be drawn every {0} up to a height of {1}.</source>
        <translation>无法按 {0} 间隔绘制高至 {1} 的等值线。</translation>
    </message>
    <message>
        <source>Convert it to .vtu files with a .pvd, or to Exodus II, with the dead cells left out or flagged.</source>
        <translation>请转换为带 .pvd 的 .vtu 文件或 Exodus II，略去失效单元或加以标记。</translation>
    </message>
    <message>
        <source>Coordinates must be finite: let the analysis write the file again.</source>
        <translation>坐标必须为有限值：请让分析程序重新写出文件。</translation>
    </message>
    <message>
        <source>Copy it again from where it came.</source>
        <translation>请从来源处重新复制。</translation>
    </message>
    <message>
        <source>Copy it beside the result with all that it includes.</source>
        <translation>请连同其包含的所有文件复制到结果旁。</translation>
    </message>
    <message>
        <source>Copy the file again, or wait until the analysis has finished writing it.</source>
        <translation>请重新复制文件，或等待分析程序写完。</translation>
    </message>
    <message>
        <source>Copy the file again, or wait until the analysis has written it.</source>
        <translation>请重新复制文件，或等待分析程序写出。</translation>
    </message>
    <message>
        <source>Copy the files again; check that all are of one analysis.</source>
        <translation>请重新复制这些文件；检查它们是否属于同一分析。</translation>
    </message>
    <message>
        <source>Copy the missing files beside the others.</source>
        <translation>请将缺少的文件复制到其他文件旁。</translation>
    </message>
    <message>
        <source>Copy the whole sequence.</source>
        <translation>请复制整个序列。</translation>
    </message>
    <message>
        <source>Copy the whole series, or remove the entry.</source>
        <translation>请复制整个序列，或删除该条目。</translation>
    </message>
    <message>
        <source>Copy them beside the deck if they hold densities or sections.</source>
        <translation>若其中有密度或截面，请复制到输入卡旁。</translation>
    </message>
    <message>
        <source>Copy these files again.</source>
        <translation>请重新复制这些文件。</translation>
    </message>
    <message>
        <source>Correct it in the file, or take the last good copy.</source>
        <translation>请在文件中更正，或采用上一份完好的副本。</translation>
    </message>
    <message>
        <source>Correct it or leave it out.</source>
        <translation>请更正或删去。</translation>
    </message>
    <message>
        <source>Correct the box or plane of the step.</source>
        <translation>请更正该步骤的盒或平面。</translation>
    </message>
    <message>
        <source>Correct the inputs and scenarios of the case.</source>
        <translation>请更正案例的输入和方案。</translation>
    </message>
    <message>
        <source>Correct the value in the file, or take the last good copy.</source>
        <translation>请在文件中更正该值，或采用上一份完好的副本。</translation>
    </message>
    <message>
        <source>Curved beams were taken straight, which changes their length by {0} %</source>
        <translation>弯曲的梁按直线处理，其长度因此改变 {0} %</translation>
    </message>
    <message>
        <source>Curved edges of shells were taken straight, which changes their area by {0} %</source>
        <translation>壳的弯曲边按直线处理，其面积因此改变 {0} %</translation>
    </message>
    <message>
        <source>Curved edges of solids were taken straight, which changes their volume by {0} %</source>
        <translation>实体的弯曲边按直线处理，其体积因此改变 {0} %</translation>
    </message>
    <message>
        <source>Debris of {0} fragments cannot be compared with debris of {1}: they are of different collapses, or were measured in different ways.</source>
        <translation>{0} 个碎块的堆积物不能与 {1} 个碎块的堆积物比较：它们属于不同的倒塌，或测量方式不同。</translation>
    </message>
    <message>
        <source>Delete it to have it simulated here.</source>
        <translation>删除它即可在本机重新模拟。</translation>
    </message>
    <message>
        <source>Delete the file named, if this is said each time.</source>
        <translation>若每次都出现，请删除所指文件。</translation>
    </message>
    <message>
        <source>Densities and sections were taken from the input deck</source>
        <translation>密度和截面取自输入卡</translation>
    </message>
    <message>
        <source>Did you mean one of {0}?</source>
        <translation>您是指 {0} 之一吗？</translation>
    </message>
    <message>
        <source>Did you mean one of {0}? `rubble-cli parameters` lists all.</source>
        <translation>您是指 {0} 之一吗？`rubble-cli parameters` 可列出全部。</translation>
    </message>
    <message>
        <source>Draw another layer; impact energy needs a complete run, live structure its layers.</source>
        <translation>请绘制其他图层；冲击能需要完整的计算，未失效结构需要其图层。</translation>
    </message>
    <message>
        <source>EROSION_STATUS, 1 is active</source>
        <translation>EROSION_STATUS，1 为激活</translation>
    </message>
    <message>
        <source>Element values do not have the length that their counts give and were passed over</source>
        <translation>单元值的长度与其计数不符，已跳过</translation>
    </message>
    <message>
        <source>Elements are inactive in every state: they may be rigid, which these files do not tell</source>
        <translation>某些单元在所有状态均未激活：可能是刚性的，这些文件不作说明</translation>
    </message>
    <message>
        <source>Elements change their part from state to state</source>
        <translation>单元在不同状态间改变所属部件</translation>
    </message>
    <message>
        <source>Elements of a type that makes no fragment were left out</source>
        <translation>不生成碎块的单元类型已略去</translation>
    </message>
    <message>
        <source>Elements of blocks without {0} count as always active</source>
        <translation>没有 {0} 的单元块中的单元视为始终激活</translation>
    </message>
    <message>
        <source>Elements share a number; they were told apart by their nodes</source>
        <translation>某些单元编号相同；已按节点区分</translation>
    </message>
    <message>
        <source>Elements that never carry stress are taken for dead as well. Let UACTIVE take them off the post file (mode -1), or put a list of deaths (element,time) beside it.</source>
        <translation>从不受力的单元也被视为失效。请用 UACTIVE 将其从后处理文件移除（模式 -1），或在旁边放置失效清单（单元，时刻）。</translation>
    </message>
    <message>
        <source>Elements that {0} calls dead at every state were taken for rigid ones that stand</source>
        <translation>{0} 在所有状态称为失效的单元被视为站立的刚性单元</translation>
    </message>
    <message>
        <source>Elements whose nodes all belong to living ones are missed: put the input deck (.inp) with its MODEL CHANGE beside it.</source>
        <translation>其节点全部属于存活单元的失效单元会被遗漏：请将含 MODEL CHANGE 的输入卡（.inp）放在旁边。</translation>
    </message>
    <message>
        <source>Elements whose type the file does not say were left out</source>
        <translation>文件未说明类型的单元已略去</translation>
    </message>
    <message>
        <source>Entries of the deletion table are negative or no number; these elements count as dead</source>
        <translation>删除表中有负值或非数值；这些单元视为失效</translation>
    </message>
    <message>
        <source>Exodus II</source>
        <translation>Exodus II</translation>
    </message>
    <message>
        <source>FE result</source>
        <translation>有限元结果</translation>
    </message>
    <message>
        <source>Fetch the file: git annex get.</source>
        <translation>请获取该文件：git annex get。</translation>
    </message>
    <message>
        <source>Fetch the file: git lfs pull.</source>
        <translation>请获取该文件：git lfs pull。</translation>
    </message>
    <message>
        <source>Files of the sequence are missing: states between them are not known</source>
        <translation>序列缺少文件：其间的状态未知</translation>
    </message>
    <message>
        <source>Files that the input deck includes are not there</source>
        <translation>输入卡包含的文件不存在</translation>
    </message>
    <message>
        <source>Files whose states have another length were left out</source>
        <translation>状态长度不同的文件已略去</translation>
    </message>
    <message>
        <source>Finding the states</source>
        <translation>正在查找状态</translation>
    </message>
    <message>
        <source>Formats that can be read: {0}.</source>
        <translation>可读取的格式：{0}。</translation>
    </message>
    <message>
        <source>Fortran Binary</source>
        <translation>Fortran Binary</translation>
    </message>
    <message>
        <source>Fragments wider than the grid mostly stand alone; raise it for fewer bodies</source>
        <translation>宽于网格的碎块大多单独成类；增大网格可减少刚体</translation>
    </message>
    <message>
        <source>Free space on that disk or choose another place for the run file, then run again; the frames written so far can be read.</source>
        <translation>请在该磁盘腾出空间或为计算文件选择其他位置，然后重新计算；已写出的帧可以读取。</translation>
    </message>
    <message>
        <source>Give a distance above zero.</source>
        <translation>请给出大于零的距离。</translation>
    </message>
    <message>
        <source>Give a file or a folder; pipes and devices hold no result.</source>
        <translation>请给出文件或文件夹；管道和设备中没有结果。</translation>
    </message>
    <message>
        <source>Give a name that is not empty and that no other component has.</source>
        <translation>请给出非空且未被其他构件使用的名称。</translation>
    </message>
    <message>
        <source>Give a normal that is not zero and a point of finite coordinates.</source>
        <translation>请给出非零法向和有限坐标的点。</translation>
    </message>
    <message>
        <source>Give a number from {0} to {1}.</source>
        <translation>请给出 {0} 至 {1} 之间的数值。</translation>
    </message>
    <message>
        <source>Give a part of the model.</source>
        <translation>请给出模型的一部分。</translation>
    </message>
    <message>
        <source>Give a raster in one file, such as a GeoTIFF.</source>
        <translation>请以单个文件给出栅格，例如 GeoTIFF。</translation>
    </message>
    <message>
        <source>Give a raster of finite heights with at least two rows and columns.</source>
        <translation>请给出至少两行两列的有限高程栅格。</translation>
    </message>
    <message>
        <source>Give a raster of heights with one band.</source>
        <translation>请给出单波段高程栅格。</translation>
    </message>
    <message>
        <source>Give a raster that covers the site, or fill its gaps with gdal_fillnodata.py.</source>
        <translation>请给出覆盖场地的栅格，或用 gdal_fillnodata.py 填补空缺。</translation>
    </message>
    <message>
        <source>Give a raster that covers the site.</source>
        <translation>请给出覆盖场地的栅格。</translation>
    </message>
    <message>
        <source>Give a series of .cdb files with updated coordinates (UPCOORD), one a state.</source>
        <translation>请给出坐标已更新（UPCOORD）的 .cdb 文件序列，每个状态一个。</translation>
    </message>
    <message>
        <source>Give a size above zero, 0.25 m or 1 m for example.</source>
        <translation>请给出大于零的尺寸，例如 0.25 m 或 1 m。</translation>
    </message>
    <message>
        <source>Give a size above zero, 1 m or 2 m for example.</source>
        <translation>请给出大于零的尺寸，例如 1 m 或 2 m。</translation>
    </message>
    <message>
        <source>Give a spacing above zero that makes a thousand lines at most, 0.5 m for example.</source>
        <translation>请给出大于零且最多产生一千条线的间距，例如 0.5 m。</translation>
    </message>
    <message>
        <source>Give a table of at most {0} bytes.</source>
        <translation>请给出不超过 {0} 字节的表格。</translation>
    </message>
    <message>
        <source>Give a text.</source>
        <translation>请给出文字。</translation>
    </message>
    <message>
        <source>Give a three-dimensional analysis.</source>
        <translation>请给出三维分析。</translation>
    </message>
    <message>
        <source>Give a time within the run.</source>
        <translation>请给出计算范围内的时刻。</translation>
    </message>
    <message>
        <source>Give a whole number from {0} to {1}.</source>
        <translation>请给出 {0} 至 {1} 之间的整数。</translation>
    </message>
    <message>
        <source>Give an analysis whose structure is made of such elements.</source>
        <translation>请给出由此类单元构成结构的分析。</translation>
    </message>
    <message>
        <source>Give each once.</source>
        <translation>每项只能给出一次。</translation>
    </message>
    <message>
        <source>Give fewer values, or sweep the parameters one after the other.</source>
        <translation>请减少取值，或逐个变化参数。</translation>
    </message>
    <message>
        <source>Give it a place with gdal_translate -a_ullr, or put its world file beside it.</source>
        <translation>请用 gdal_translate -a_ullr 给定位置，或在旁边放置其坐标文件。</translation>
    </message>
    <message>
        <source>Give numbers from {0} to {1}.</source>
        <translation>请给出 {0} 至 {1} 之间的数值。</translation>
    </message>
    <message>
        <source>Give one of them: {0}.</source>
        <translation>请给出其中之一：{0}。</translation>
    </message>
    <message>
        <source>Give the FE file that the run names.</source>
        <translation>请给出该计算所指的有限元文件。</translation>
    </message>
    <message>
        <source>Give the animation files (A001, ...) that they were made from.</source>
        <translation>请给出其来源的动画文件（A001、…）。</translation>
    </message>
    <message>
        <source>Give the animation files themselves: they tell rigid from dead.</source>
        <translation>请给出动画文件本身：它们能区分刚性与失效。</translation>
    </message>
    <message>
        <source>Give the case a projected system, such as the UTM zone of the site.</source>
        <translation>请为案例采用投影坐标系，例如场地所在的 UTM 带。</translation>
    </message>
    <message>
        <source>Give the case an EPSG code, EPSG:25832 for example, or none.</source>
        <translation>请为案例给出 EPSG 代码，例如 EPSG:25832，或不给出。</translation>
    </message>
    <message>
        <source>Give the d3plot of the analysis.</source>
        <translation>请给出该分析的 d3plot。</translation>
    </message>
    <message>
        <source>Give the deck as text, or take the file away.</source>
        <translation>请以文本给出输入卡，或移走该文件。</translation>
    </message>
    <message>
        <source>Give the elevation model, not a picture of it.</source>
        <translation>请给出高程模型，而不是其图片。</translation>
    </message>
    <message>
        <source>Give the file of the one that you want.</source>
        <translation>请给出所需的那一个文件。</translation>
    </message>
    <message>
        <source>Give the length of the file&apos;s unit in metres, 0.001 for millimetres.</source>
        <translation>请给出文件长度单位对应的米数，毫米为 0.001。</translation>
    </message>
    <message>
        <source>Give the output another name.</source>
        <translation>请为输出另取名称。</translation>
    </message>
    <message>
        <source>Give the result file of the analysis, not its input mesh.</source>
        <translation>请给出分析的结果文件，而不是输入网格。</translation>
    </message>
    <message>
        <source>Give the result file. Formats that can be read: {0}.</source>
        <translation>请给出结果文件。可读取的格式：{0}。</translation>
    </message>
    <message>
        <source>Give the result of an FE analysis; surroundings are added to the case as meshes.</source>
        <translation>请给出有限元分析的结果；周围环境作为网格加入案例。</translation>
    </message>
    <message>
        <source>Give the result of the analysis as .vtu, Exodus II or another format that is read.</source>
        <translation>请以 .vtu、Exodus II 或其他可读取的格式给出分析结果。</translation>
    </message>
    <message>
        <source>Give the result of the analysis; Gmsh writes results as .vtk or .med.</source>
        <translation>请给出分析结果；Gmsh 可将结果写为 .vtk 或 .med。</translation>
    </message>
    <message>
        <source>Give the result of the solver itself: d3plot, the animation files of OpenRadioss, or the .odb as .fil.</source>
        <translation>请给出求解器自身的结果：d3plot、OpenRadioss 动画文件，或转换为 .fil 的 .odb。</translation>
    </message>
    <message>
        <source>Give the results of the collapse: a static or a transient analysis.</source>
        <translation>请给出倒塌的结果：静力或瞬态分析。</translation>
    </message>
    <message>
        <source>Give the size of the picture, a focal length above zero or none, and up to two radial terms.</source>
        <translation>请给出照片尺寸、大于零的焦距（或不给出），以及至多两个径向畸变项。</translation>
    </message>
    <message>
        <source>Give the whole family (d3plot, d3plot01, ...), or wait until the analysis has gone on.</source>
        <translation>请给出整个系列（d3plot、d3plot01、…），或等待分析继续。</translation>
    </message>
    <message>
        <source>Give true or false.</source>
        <translation>请给出 true 或 false。</translation>
    </message>
    <message>
        <source>Give two materials with a comma between them, such as stone,soil.</source>
        <translation>请给出以逗号分隔的两种材料，例如 stone,soil。</translation>
    </message>
    <message>
        <source>Give {0}.</source>
        <translation>请给出{0}。</translation>
    </message>
    <message>
        <source>Height, live structure</source>
        <translation>高度，未失效结构</translation>
    </message>
    <message>
        <source>If it should be debris, check the name and the polarity of the active flag.</source>
        <translation>若它应成为堆积物，请检查激活标志的名称和取值方向。</translation>
    </message>
    <message>
        <source>If the flag is the other way round: --set active_value=0 or 1.</source>
        <translation>若标志方向相反：--set active_value=0 或 1。</translation>
    </message>
    <message>
        <source>If the flag is the other way round: --set active_value={0}.</source>
        <translation>若标志方向相反：--set active_value={0}。</translation>
    </message>
    <message>
        <source>If they die so, name the parts of the dead: --set dead_parts=NAME. Their first part counts otherwise.</source>
        <translation>若单元由此失效，请指定失效单元所在的部件：--set dead_parts=NAME。否则以其最初的部件为准。</translation>
    </message>
    <message>
        <source>Impact energy</source>
        <translation>冲击能</translation>
    </message>
    <message>
        <source>It counts as structure from then on; check the polarity of the active flag if this is not meant.</source>
        <translation>此后它计为结构；若非本意，请检查激活标志的取值方向。</translation>
    </message>
    <message>
        <source>It is made again; delete the file if this is said each time.</source>
        <translation>已重新生成；若每次都出现，请删除该文件。</translation>
    </message>
    <message>
        <source>It stays dead (revival = latch); revival = follow lets it come back.</source>
        <translation>它保持失效（revival = latch）；revival = follow 允许其复活。</translation>
    </message>
    <message>
        <source>It was active at a single state of a result without velocities: ask the solver for velocities or for more states.</source>
        <translation>在没有速度的结果中，它只在一个状态激活：请让求解器输出速度或更多状态。</translation>
    </message>
    <message>
        <source>Its fragment ends then (revival = follow); revival = latch keeps it dead.</source>
        <translation>其碎块随之结束（revival = follow）；revival = latch 使其保持失效。</translation>
    </message>
    <message>
        <source>Kills that do not name an element by number were passed over</source>
        <translation>未按编号指定单元的删除指令已跳过</translation>
    </message>
    <message>
        <source>LS-DYNA d3plot</source>
        <translation>LS-DYNA d3plot</translation>
    </message>
    <message>
        <source>Largest piece</source>
        <translation>最大碎块</translation>
    </message>
    <message>
        <source>Leave the name out: elements that a file of the sequence leaves out are dead.</source>
        <translation>请不要给出名称：序列文件略去的单元即为失效。</translation>
    </message>
    <message>
        <source>Let Abaqus write it as a results file: abaqus python odb_to_fil.py JOB.odb (resources/abaqus), then give JOB-rubble.fil.</source>
        <translation>请让 Abaqus 将其写为结果文件：abaqus python odb_to_fil.py JOB.odb（resources/abaqus），然后给出 JOB-rubble.fil。</translation>
    </message>
    <message>
        <source>Let CDWRITE write the whole database (CDWRITE,DB).</source>
        <translation>请用 CDWRITE 写出整个数据库（CDWRITE,DB）。</translation>
    </message>
    <message>
        <source>Let the analysis number its elements uniquely.</source>
        <translation>请让分析程序给单元唯一编号。</translation>
    </message>
    <message>
        <source>Let the analysis write all nodes: *NODE FILE without NSET.</source>
        <translation>请让分析写出所有节点：*NODE FILE 不带 NSET。</translation>
    </message>
    <message>
        <source>Let the analysis write it without compression (/FCOMP,RST,0).</source>
        <translation>请让分析程序不压缩写出（/FCOMP,RST,0）。</translation>
    </message>
    <message>
        <source>Let the analysis write the file again.</source>
        <translation>请让分析程序重新写出文件。</translation>
    </message>
    <message>
        <source>Let the name end in .exo (Exodus II), .pvd (a series of VTU files) or .h5 (a copy that opens at once).</source>
        <translation>名称须以 .exo（Exodus II）、.pvd（VTU 文件序列）或 .h5（可立即打开的副本）结尾。</translation>
    </message>
    <message>
        <source>Let the solver delete such elements earlier if they matter.</source>
        <translation>若有影响，请让求解器更早删除此类单元。</translation>
    </message>
    <message>
        <source>Lines without an element number were left out: they are links of rigid bodies</source>
        <translation>没有单元编号的行已略去：它们是刚体连接</translation>
    </message>
    <message>
        <source>Links of rigid bodies were left out: they are no elements</source>
        <translation>刚体连接已略去：它们不是单元</translation>
    </message>
    <message>
        <source>Live FPS could not be measured: nothing can be drawn here.</source>
        <translation>无法测量实时 FPS：此处不能绘图。</translation>
    </message>
    <message>
        <source>Local frame of the case</source>
        <translation>案例的局部坐标框架</translation>
    </message>
    <message>
        <source>Look at the health of the run; a higher step rate may keep it sound.</source>
        <translation>请查看计算的健康状况；提高步率或可使其正常。</translation>
    </message>
    <message>
        <source>Looking when debris came to where it lies</source>
        <translation>正在查找堆积物到达现位置的时刻</translation>
    </message>
    <message>
        <source>Looking when debris was hit hardest</source>
        <translation>正在查找堆积物受最大撞击的时刻</translation>
    </message>
    <message>
        <source>Lower minimum_thickness_ratio or minimum_half_extent if stability allows it.</source>
        <translation>若稳定性允许，请减小 minimum_thickness_ratio 或 minimum_half_extent。</translation>
    </message>
    <message>
        <source>MODEL CHANGE names sets of elements that the deck does not have</source>
        <translation>MODEL CHANGE 指定了输入文件中没有的单元集</translation>
    </message>
    <message>
        <source>MODEL CHANGE of the input deck</source>
        <translation>输入卡的 MODEL CHANGE</translation>
    </message>
    <message>
        <source>MSC Marc post file</source>
        <translation>MSC Marc 后处理文件</translation>
    </message>
    <message>
        <source>Make room for the cache (rubble-cli cache clear), or name another folder.</source>
        <translation>请为缓存腾出空间（rubble-cli cache clear），或指定其他文件夹。</translation>
    </message>
    <message>
        <source>Make room for the cache, or name another folder.</source>
        <translation>请为缓存腾出空间，或指定其他文件夹。</translation>
    </message>
    <message>
        <source>Make room there, or set TMPDIR to a folder with room and start again.</source>
        <translation>请在该处腾出空间，或将 TMPDIR 设为有空间的文件夹后重新启动。</translation>
    </message>
    <message>
        <source>Make the copy again from the result itself: rubble-cli convert.</source>
        <translation>请由结果本身重新生成副本：rubble-cli convert。</translation>
    </message>
    <message>
        <source>Making fragments</source>
        <translation>正在生成碎块</translation>
    </message>
    <message>
        <source>Mass per area</source>
        <translation>单位面积质量</translation>
    </message>
    <message>
        <source>Mass per area, live structure</source>
        <translation>单位面积质量，未失效结构</translation>
    </message>
    <message>
        <source>Measure again when the machine is quiet.</source>
        <translation>请在机器空闲时重新测量。</translation>
    </message>
    <message>
        <source>Most elements are inactive at the first state: {0}</source>
        <translation>多数单元在初始状态未激活：{0}</translation>
    </message>
    <message>
        <source>NAVFAC DM 7.02 (1986): concrete or masonry on silty sand or gravel 0.45-0.55, on fine silty sand 0.35-0.45</source>
        <translation>NAVFAC DM 7.02 (1986)：混凝土或砌体对粉质砂或砾石 0.45-0.55，对粉细砂 0.35-0.45</translation>
    </message>
    <message>
        <source>NAVFAC DM 7.02 (1986): dressed rock on dressed rock 0.55-0.70</source>
        <translation>NAVFAC DM 7.02 (1986)：修琢石对修琢石 0.55-0.70</translation>
    </message>
    <message>
        <source>NAVFAC DM 7.02 (1986): sheet pile interlocks 0.30; Avallone &amp; Baumeister (1996): sliding, dry, 0.42-0.57</source>
        <translation>NAVFAC DM 7.02 (1986)：板桩锁口 0.30；Avallone &amp; Baumeister (1996)：干滑动 0.42-0.57</translation>
    </message>
    <message>
        <source>NAVFAC DM 7.02 (1986): steel sheet piles on gravel 0.40, on sand 0.30</source>
        <translation>NAVFAC DM 7.02 (1986)：钢板桩对砾石 0.40，对砂 0.30</translation>
    </message>
    <message>
        <source>NAVFAC DM 7.02 (1986): steel sheet piles on silty sand 0.25, on silt 0.20</source>
        <translation>NAVFAC DM 7.02 (1986)：钢板桩对粉质砂 0.25，对粉土 0.20</translation>
    </message>
    <message>
        <source>Name another folder, or check its rights.</source>
        <translation>请指定其他文件夹，或检查其权限。</translation>
    </message>
    <message>
        <source>Name every column in the heading, and write numbers with points, or part the fields by semicolons.</source>
        <translation>请在标题行中命名每一列，并用小数点书写数字，或用分号分隔各项。</translation>
    </message>
    <message>
        <source>Name one of these in dead_parts: {0}.</source>
        <translation>请在 dead_parts 中指定其中之一：{0}。</translation>
    </message>
    <message>
        <source>Name one of these: {0}; displacement=none if the points are where the nodes are.</source>
        <translation>请指定其中之一：{0}；若点即为节点所在位置，则 displacement=none。</translation>
    </message>
    <message>
        <source>Name the components that are to become one.</source>
        <translation>请指定要合并的构件。</translation>
    </message>
    <message>
        <source>Name the flag: --set status_variable=NAME (there are {0}), or put a list of deaths (element,time) beside it as {1}.</source>
        <translation>请指定标志：--set status_variable=NAME（有 {0}），或在旁边放置失效清单（单元，时刻）{1}。</translation>
    </message>
    <message>
        <source>Names that come near: {0}. `rubble-cli inspect` lists all.</source>
        <translation>相近的名称：{0}。`rubble-cli inspect` 可列出全部。</translation>
    </message>
    <message>
        <source>No camera sees enough of these {0} pairs where the picture shows them.</source>
        <translation>没有相机能在照片所示位置看到这 {0} 对点中足够多的点。</translation>
    </message>
    <message>
        <source>No density is known: {0} is assumed</source>
        <translation>密度未知：假定为 {0}</translation>
    </message>
    <message>
        <source>No exact death time is known: the first state that reports the death is taken</source>
        <translation>精确失效时刻未知：取首个报告失效的状态</translation>
    </message>
    <message>
        <source>No figure can be drawn: there is no X display that answers</source>
        <translation>无法绘图：没有可响应的 X 显示</translation>
    </message>
    <message>
        <source>No folder for the run can be made in {0}</source>
        <translation>无法在 {0} 建立计算文件夹</translation>
    </message>
    <message>
        <source>No section is known: {0} is assumed</source>
        <translation>截面未知：假定为 {0}</translation>
    </message>
    <message>
        <source>No thickness is known: {0} is assumed</source>
        <translation>厚度未知：假定为 {0}</translation>
    </message>
    <message>
        <source>Nodes of active elements need finite values: let the analysis write the state again, or cut the result before it.</source>
        <translation>激活单元的节点需要有限值：请让分析程序重新写出该状态，或在其之前截断结果。</translation>
    </message>
    <message>
        <source>Nodes of elements have displacements at no state: they were left where they are at rest</source>
        <translation>一些单元节点在任何状态都没有位移：它们留在初始位置</translation>
    </message>
    <message>
        <source>Nodes of no element have no finite place</source>
        <translation>不属于任何单元的节点没有有限位置</translation>
    </message>
    <message>
        <source>Nothing can be drawn here: only the physics was measured.</source>
        <translation>此处不能绘图：仅测量了物理计算。</translation>
    </message>
    <message>
        <source>Nothing needs doing: it is simulated anew.</source>
        <translation>无需处理：将重新模拟。</translation>
    </message>
    <message>
        <source>Nothing says which elements are dead: all count as active</source>
        <translation>没有信息说明哪些单元失效：全部视为激活</translation>
    </message>
    <message>
        <source>Nothing to do if the dead are left out of the mesh.</source>
        <translation>若网格中已略去失效单元，则无需处理。</translation>
    </message>
    <message>
        <source>Nothing to do if the element dies soon after.</source>
        <translation>若该单元随后很快失效，则无需处理。</translation>
    </message>
    <message>
        <source>Nothing to do if the elements look right.</source>
        <translation>若单元看起来正确，则无需处理。</translation>
    </message>
    <message>
        <source>Nothing to do if these blocks cannot fail.</source>
        <translation>若这些单元块不会破坏，则无需处理。</translation>
    </message>
    <message>
        <source>Nothing to do if they are gravel or debris beside the structure.</source>
        <translation>若它们是结构旁的碎石或堆积物，则无需处理。</translation>
    </message>
    <message>
        <source>Nothing to do if they are masses, contacts or particles.</source>
        <translation>若它们是质量、接触或粒子，则无需处理。</translation>
    </message>
    <message>
        <source>Nothing to do if they are masses, springs, contacts or rigid surfaces.</source>
        <translation>若它们是质量、弹簧、接触或刚性面，则无需处理。</translation>
    </message>
    <message>
        <source>Nothing to do if you do not need the numbers.</source>
        <translation>若不需要编号，则无需处理。</translation>
    </message>
    <message>
        <source>Nothing to do.</source>
        <translation>无需处理。</translation>
    </message>
    <message>
        <source>Nothing to do: a restart writes its first state again.</source>
        <translation>无需处理：重启动会再次写出其首个状态。</translation>
    </message>
    <message>
        <source>Nothing to do: exports add it again.</source>
        <translation>无需处理：导出时会加回。</translation>
    </message>
    <message>
        <source>Nothing to do: these deaths are known by their states.</source>
        <translation>无需处理：这些失效由状态得知。</translation>
    </message>
    <message>
        <source>Nothing to do: they are not used.</source>
        <translation>无需处理：它们未被使用。</translation>
    </message>
    <message>
        <source>Nothing to do: they fill the same volume.</source>
        <translation>无需处理：它们占据相同的体积。</translation>
    </message>
    <message>
        <source>Nothing to merge into &quot;{0}&quot;</source>
        <translation>没有可并入“{0}”的内容</translation>
    </message>
    <message>
        <source>Number the elements of all kinds in one row if one alone is meant.</source>
        <translation>若仅指其中一个，请将各类单元统一编号。</translation>
    </message>
    <message>
        <source>Numbers are missing in the series; deaths are known less exactly there</source>
        <translation>序列缺号；该处的失效时刻不够准确</translation>
    </message>
    <message>
        <source>One of the two is stone, concrete, steel or masonry.</source>
        <translation>两者之一须为石材、混凝土、钢或砌体。</translation>
    </message>
    <message>
        <source>Open a *.rubble file or an FE result.</source>
        <translation>请打开 *.rubble 文件或有限元结果。</translation>
    </message>
    <message>
        <source>Open it with a newer Rubble.</source>
        <translation>请用更新版本的 Rubble 打开。</translation>
    </message>
    <message>
        <source>Open it with a newer Rubble; the file is unchanged.</source>
        <translation>请用更新版本的 Rubble 打开；文件未变。</translation>
    </message>
    <message>
        <source>Open it with the Rubble that wrote it, or run the case again.</source>
        <translation>请用写出它的 Rubble 打开，或重新计算该案例。</translation>
    </message>
    <message>
        <source>Open the FE result itself.</source>
        <translation>请直接打开有限元结果。</translation>
    </message>
    <message>
        <source>Open the result again once the analysis has gone on.</source>
        <translation>分析继续进行后请重新打开结果。</translation>
    </message>
    <message>
        <source>Open the result again.</source>
        <translation>请重新打开结果。</translation>
    </message>
    <message>
        <source>Open the result that it was made from to choose other variables.</source>
        <translation>请打开其来源结果以选择其他变量。</translation>
    </message>
    <message>
        <source>OpenRadioss animation</source>
        <translation>OpenRadioss 动画</translation>
    </message>
    <message>
        <source>OpenRadioss animation converted to VTK</source>
        <translation>转换为 VTK 的 OpenRadioss 动画</translation>
    </message>
    <message>
        <source>Other programs worked on this machine while it was measured: nothing is predicted from this.</source>
        <translation>测量时本机有其他程序运行：不据此作任何预测。</translation>
    </message>
    <message>
        <source>Other programs worked on this machine while settings were timed.</source>
        <translation>设置计时期间本机有其他程序运行。</translation>
    </message>
    <message>
        <source>Particles are shown and dropped as cubes of their volume</source>
        <translation>粒子显示并下落为同体积的立方体</translation>
    </message>
    <message>
        <source>Parts share a name; their numbers were added to it</source>
        <translation>部件重名；已在名称后加编号</translation>
    </message>
    <message>
        <source>Points of one element do not agree whether it is active; it counts as active</source>
        <translation>同一单元的各点对其是否激活不一致；视为激活</translation>
    </message>
    <message>
        <source>Put a list of deaths (element,time) beside it as {0}, or let the analysis write the status of its elements.</source>
        <translation>请在旁边放置失效清单（单元，时刻）{0}，或让分析程序写出单元状态。</translation>
    </message>
    <message>
        <source>Put a list of deaths (element,time) beside the file.</source>
        <translation>请在文件旁放置失效清单（单元，时刻）。</translation>
    </message>
    <message>
        <source>RC arch (published)</source>
        <translation>钢筋混凝土拱桥（论文）</translation>
    </message>
    <message>
        <source>Reading active elements</source>
        <translation>正在读取激活单元</translation>
    </message>
    <message>
        <source>Reading the copy</source>
        <translation>正在读取副本</translation>
    </message>
    <message>
        <source>Reading the increments</source>
        <translation>正在读取增量步</translation>
    </message>
    <message>
        <source>Reading the mesh</source>
        <translation>正在读取网格</translation>
    </message>
    <message>
        <source>Reading the states</source>
        <translation>正在读取状态</translation>
    </message>
    <message>
        <source>Remove it, or correct it to one of: </source>
        <translation>请删除，或更正为以下之一：</translation>
    </message>
    <message>
        <source>Remove one of the two.</source>
        <translation>请删除其中之一。</translation>
    </message>
    <message>
        <source>Remove the include.</source>
        <translation>请删除该包含语句。</translation>
    </message>
    <message>
        <source>Remove the states that a restart wrote twice.</source>
        <translation>请删除重启动重复写出的状态。</translation>
    </message>
    <message>
        <source>Rename the file or the component in question.</source>
        <translation>请重命名相关文件或构件。</translation>
    </message>
    <message>
        <source>Rename them by regrouping.</source>
        <translation>请通过重新分组重命名。</translation>
    </message>
    <message>
        <source>Rubble copy</source>
        <translation>Rubble 副本</translation>
    </message>
    <message>
        <source>Run the analysis with OpenRadioss, or a newer version.</source>
        <translation>请用 OpenRadioss 或更新版本运行分析。</translation>
    </message>
    <message>
        <source>Run the analysis without it.</source>
        <translation>请在没有它的情况下运行分析。</translation>
    </message>
    <message>
        <source>Run the case again to the end.</source>
        <translation>请重新将案例计算到底。</translation>
    </message>
    <message>
        <source>Run the case again, or take a good copy of the run file.</source>
        <translation>请重新计算该案例，或取计算文件的完好副本。</translation>
    </message>
    <message>
        <source>Runs (*.run.h5)</source>
        <translation>计算 (*.run.h5)</translation>
    </message>
    <message>
        <source>Save the table as CSV in UTF-8.</source>
        <translation>请将表格存为 UTF-8 编码的 CSV。</translation>
    </message>
    <message>
        <source>Save the view again, or mend the file there.</source>
        <translation>请重新保存视图，或在该处修正文件。</translation>
    </message>
    <message>
        <source>Saving the run</source>
        <translation>正在保存计算</translation>
    </message>
    <message>
        <source>Say how its components begin: --set displacement=PREFIX; displacement=none if the nodes do not move. Nodal variables in the file: {0}</source>
        <translation>请说明其分量的前缀：--set displacement=PREFIX；若节点不移动，则 displacement=none。文件中的节点变量：{0}</translation>
    </message>
    <message>
        <source>Say which variable tells active from dead elements: --set status_variable=NAME (and active_value=0 or 1), or put a list of deaths (element,time) beside it as {1}. Element variables in the file: {0}</source>
        <translation>请说明哪个变量区分激活与失效单元：--set status_variable=NAME（以及 active_value=0 或 1），或在旁边放置失效清单（单元，时刻）{1}。文件中的单元变量：{0}</translation>
    </message>
    <message>
        <source>Say who has looked at the breaches, and why the run may be used.</source>
        <translation>请说明谁查看了超限，以及为何仍可使用该计算。</translation>
    </message>
    <message>
        <source>Searching the Basic Grid</source>
        <translation>正在搜索基本网格</translation>
    </message>
    <message>
        <source>Series (*.pvd)</source>
        <translation>序列 (*.pvd)</translation>
    </message>
    <message>
        <source>Set DISPLAY to a running X server, or install xvfb: the command line then starts one itself.</source>
        <translation>请将 DISPLAY 设为正在运行的 X 服务器，或安装 xvfb：命令行将自动启动它。</translation>
    </message>
    <message>
        <source>Set birth_time = state to treat all elements alike.</source>
        <translation>请设置 birth_time = state 以同样处理所有单元。</translation>
    </message>
    <message>
        <source>Set component[NAME].density to {0} times its value to keep the mass, or mesh finer.</source>
        <translation>将 component[NAME].density 设为原值的 {0} 倍以保持质量，或细化网格。</translation>
    </message>
    <message>
        <source>Set component[NAME].density.</source>
        <translation>请设置 component[NAME].density。</translation>
    </message>
    <message>
        <source>Set component[NAME].section.</source>
        <translation>请设置 component[NAME].section。</translation>
    </message>
    <message>
        <source>Set component[{0}].density to a positive number.</source>
        <translation>请将 component[{0}].density 设为正数。</translation>
    </message>
    <message>
        <source>Set it for the whole sweep, and vary what costs time: the grid, birth_window, cluster_shape, pieces, step_rate, substeps, iterations, solver, break_up_speed or an effect.</source>
        <translation>请对整个对比统一设置，而变化影响耗时的参数：网格、birth_window、cluster_shape、pieces、step_rate、substeps、iterations、solver、break_up_speed 或某一效应。</translation>
    </message>
    <message>
        <source>Set revival to latch (dead is dead) or follow (its fragment ends).</source>
        <translation>请将 revival 设为 latch（失效即永久失效）或 follow（其碎块结束）。</translation>
    </message>
    <message>
        <source>Set the up axis of the case&apos;s frame to x, y, z, -x, -y or -z.</source>
        <translation>请将案例坐标框架的竖直轴设为 x、y、z、-x、-y 或 -z。</translation>
    </message>
    <message>
        <source>Set units to the system of the analysis. {0}.</source>
        <translation>请将 units 设为分析所用的单位制。{0}。</translation>
    </message>
    <message>
        <source>Set units to the system of the analysis; the frame of the case holds until then.</source>
        <translation>请将 units 设为分析所用的单位制；在此之前按案例的坐标框架。</translation>
    </message>
    <message>
        <source>Set units={0}.</source>
        <translation>请设置 units={0}。</translation>
    </message>
    <message>
        <source>Set units={0}. {1}.</source>
        <translation>请设置 units={0}。{1}。</translation>
    </message>
    <message>
        <source>Set up_axis; the frame of the case holds until then.</source>
        <translation>请设置 up_axis；在此之前按案例的坐标框架。</translation>
    </message>
    <message>
        <source>Sets have a list of dead elements whose meaning nobody has verified; it was not used</source>
        <translation>结果集含有一份含义未经证实的失效单元清单；未采用</translation>
    </message>
    <message>
        <source>Simulate it to its end.</source>
        <translation>请将其模拟到底。</translation>
    </message>
    <message>
        <source>Solids were numbered inside out at rest; they were turned</source>
        <translation>实体单元静止时内外编号颠倒；已翻转</translation>
    </message>
    <message>
        <source>Source component</source>
        <translation>来源构件</translation>
    </message>
    <message>
        <source>Start again: what is done is kept.</source>
        <translation>请重新启动：已完成的内容保留。</translation>
    </message>
    <message>
        <source>States within the series are cut off and were left out</source>
        <translation>序列中被截断的状态已略去</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Take the grid that was searched by counting; the guide is shown for comparison only</source>
        <translation>请采用通过计数搜索得到的网格；参考值仅供比较</translation>
    </message>
    <message>
        <source>Taking the digest of the files</source>
        <translation>正在计算文件摘要</translation>
    </message>
    <message>
        <source>The active flag is neither 0 nor 1</source>
        <translation>激活标志既非 0 也非 1</translation>
    </message>
    <message>
        <source>The active flag is not a number; the element stays as it was at the state before</source>
        <translation>激活标志不是数值；该单元保持前一状态的情形</translation>
    </message>
    <message>
        <source>The active flag lies between active and dead; the element counts as active until it is dead</source>
        <translation>激活标志介于激活与失效之间；该单元在失效之前视为激活</translation>
    </message>
    <message>
        <source>The calibration could not be kept.</source>
        <translation>标定无法保留。</translation>
    </message>
    <message>
        <source>The case cannot be saved: a name or a path in it is not valid UTF-8</source>
        <translation>案例无法保存：其中的名称或路径不是有效的 UTF-8</translation>
    </message>
    <message>
        <source>The case cannot be saved: at {0}: {1}</source>
        <translation>案例无法保存：在 {0}：{1}</translation>
    </message>
    <message>
        <source>The coordinate system &quot;{0}&quot; of the case is not known.</source>
        <translation>案例的坐标系“{0}”未知。</translation>
    </message>
    <message>
        <source>The coordinate system &quot;{0}&quot; of the case is not one of eastings and northings.</source>
        <translation>案例的坐标系“{0}”不是东向和北向坐标系。</translation>
    </message>
    <message>
        <source>The copy has settled which elements are active: import settings do nothing</source>
        <translation>副本已确定哪些单元激活：导入设置不起作用</translation>
    </message>
    <message>
        <source>The copy of the result could not be kept in the cache</source>
        <translation>结果的副本无法保留在缓存中</translation>
    </message>
    <message>
        <source>The copy of the result in the cache was damaged and is made again</source>
        <translation>缓存中的结果副本已损坏，正在重新生成</translation>
    </message>
    <message>
        <source>The deck of the analysis counts in {0}, the file was taken to count in {1}</source>
        <translation>分析的输入卡采用 {0}，而文件被判定为 {1}</translation>
    </message>
    <message>
        <source>The density of element {0} (&quot;{1}&quot;) is {2}</source>
        <translation>单元 {0}（“{1}”）的密度为 {2}</translation>
    </message>
    <message>
        <source>The download was not the file: log in or follow the link to the file itself.</source>
        <translation>下载到的不是该文件：请登录，或打开文件本身的链接。</translation>
    </message>
    <message>
        <source>The file does not say which elements are dead: those whose stress falls to exactly zero for good were taken</source>
        <translation>文件未说明哪些单元失效：取应力永久降为零的单元</translation>
    </message>
    <message>
        <source>The file does not say which elements are dead: those with a node that a state leaves out were taken</source>
        <translation>文件未说明哪些单元失效：取有节点在某状态被略去的单元</translation>
    </message>
    <message>
        <source>The file has discrete elements (spheres), which are not read</source>
        <translation>文件含有离散单元（球体），这些单元不被读取</translation>
    </message>
    <message>
        <source>The file has no deletion table; elements whose stresses have become 0 are taken for dead</source>
        <translation>文件没有删除表；应力变为 0 的单元视为失效</translation>
    </message>
    <message>
        <source>The file has no displacements: nodes stay where they are</source>
        <translation>文件没有位移：节点保持不动</translation>
    </message>
    <message>
        <source>The file is damaged or not yet whole: copy it again or let the analysis write it again.</source>
        <translation>文件已损坏或尚不完整：请重新复制或让分析程序重新写出。</translation>
    </message>
    <message>
        <source>The file is damaged or not yet whole: copy it again or write it again.</source>
        <translation>文件已损坏或尚不完整：请重新复制或重新写出。</translation>
    </message>
    <message>
        <source>The file is damaged or was edited by hand: put it right there, or take the last good copy.</source>
        <translation>文件已损坏或被手工修改：请在该处更正，或采用上一份完好的副本。</translation>
    </message>
    <message>
        <source>The file is damaged, or no d3plot: copy it again.</source>
        <translation>文件已损坏，或不是 d3plot：请重新复制。</translation>
    </message>
    <message>
        <source>The file is damaged, or too large for this machine.</source>
        <translation>文件已损坏，或对本机过大。</translation>
    </message>
    <message>
        <source>The file is damaged: copy it again or leave it out.</source>
        <translation>文件已损坏：请重新复制或不使用它。</translation>
    </message>
    <message>
        <source>The file is damaged: copy it again or let the analysis write it again.</source>
        <translation>文件已损坏：请重新复制或让分析程序重新写出。</translation>
    </message>
    <message>
        <source>The file is damaged: copy it again or write it again.</source>
        <translation>文件已损坏：请重新复制或重新写出。</translation>
    </message>
    <message>
        <source>The file is damaged: copy it again, or let CDWRITE write it again (blocked format).</source>
        <translation>文件已损坏：请重新复制，或让 CDWRITE 重新写出（分块格式）。</translation>
    </message>
    <message>
        <source>The file may be cut short: copy it again from where it came.</source>
        <translation>文件可能被截短：请从来源处重新复制。</translation>
    </message>
    <message>
        <source>The file tells which nodes are gone, not which elements: dead elements whose nodes others still use cannot be seen</source>
        <translation>文件只说明哪些节点消失，未说明单元：节点仍被其他单元使用的失效单元无法识别</translation>
    </message>
    <message>
        <source>The first state that reports the death is taken instead; birth_time = state does so for all.</source>
        <translation>改取首个报告失效的状态；birth_time = state 对全部如此。</translation>
    </message>
    <message>
        <source>The folder holds further results, which were not read</source>
        <translation>文件夹中还有其他结果，未读取</translation>
    </message>
    <message>
        <source>The folder {0} cannot be made: {1}</source>
        <translation>无法建立文件夹 {0}：{1}</translation>
    </message>
    <message>
        <source>The folder {0} cannot be read: {1}</source>
        <translation>无法读取文件夹 {0}：{1}</translation>
    </message>
    <message>
        <source>The folder {0} holds {1} results of one format</source>
        <translation>文件夹 {0} 中有 {1} 个同一格式的结果</translation>
    </message>
    <message>
        <source>The folder {0} would be replaced, but holds {1}</source>
        <translation>文件夹 {0} 将被替换，但其中有 {1}</translation>
    </message>
    <message>
        <source>The grid is {0} along {1}; the split by component keeps every cluster within one component. To give it room, merge &quot;{2}&quot; with a neighbour or set component[{2}].structural = false</source>
        <translation>沿 {1} 的网格为 {0}；按构件分离使每个聚类限于一个构件之内。如需放宽，请将“{2}”并入相邻构件，或设置 component[{2}].structural = false</translation>
    </message>
    <message>
        <source>The influence of effects takes a floor of at least 2 repeats.</source>
        <translation>效应影响分析的下限至少需要 2 次重复。</translation>
    </message>
    <message>
        <source>The last state is not complete and was left out</source>
        <translation>最后一个状态不完整，已略去</translation>
    </message>
    <message>
        <source>The last state is not whole and was left out</source>
        <translation>最后一个状态不完整，已略去</translation>
    </message>
    <message>
        <source>The length unit of the frame is {0}</source>
        <translation>坐标框架的长度单位为 {0}</translation>
    </message>
    <message>
        <source>The list of deaths names elements that the mesh does not have</source>
        <translation>失效清单列有网格中不存在的单元</translation>
    </message>
    <message>
        <source>The list of deaths names numbers that several elements share: all of them die</source>
        <translation>失效清单中有多个单元共用的编号：它们全部失效</translation>
    </message>
    <message>
        <source>The map has no layer &quot;{0}&quot;</source>
        <translation>地图没有图层“{0}”</translation>
    </message>
    <message>
        <source>The map is {0} x {1} cells of {2} and too large for a raster: some debris lies far away.</source>
        <translation>地图为 {0} x {1} 个 {2} 的单元格，作为栅格过大：有堆积物在很远处。</translation>
    </message>
    <message>
        <source>The match is {0}: {1} of {2} pairs agree to {3} RMS; with 95 % confidence the camera stands within {4} of where it was found, {5} from the points, and looks within {6} of that direction.</source>
        <translation>匹配结果为{0}：{2} 对点中有 {1} 对以 {3} 的均方根误差相符；在 95 % 置信度下，相机位于所求位置 {4} 以内，距各点 {5}，视线方向偏差在 {6} 以内。</translation>
    </message>
    <message>
        <source>The pair &quot;{0}&quot; has a coordinate that is not a number.</source>
        <translation>点对“{0}”的坐标不是数值。</translation>
    </message>
    <message>
        <source>The pairs that agree</source>
        <translation>相符的点对</translation>
    </message>
    <message>
        <source>The parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>The place, size or mass of fragment {0} at {1} is not a number, or negative: this debris cannot be measured.</source>
        <translation>碎块 {0} 在 {1} 的位置、尺寸或质量不是数值或为负：无法测量此堆积物。</translation>
    </message>
    <message>
        <source>The place, size or mass of piece {0} of the debris is not a number, or negative: it cannot be mapped.</source>
        <translation>堆积物第 {0} 块的位置、尺寸或质量不是数值或为负：无法制图。</translation>
    </message>
    <message>
        <source>The plane that splits &quot;{0}&quot; has no direction</source>
        <translation>分割“{0}”的平面没有方向</translation>
    </message>
    <message>
        <source>The points</source>
        <translation>各点</translation>
    </message>
    <message>
        <source>The result file is damaged there, or its solver diverged: its mass is missing from the debris.</source>
        <translation>结果文件在该处已损坏，或其求解器发散：堆积物缺少其质量。</translation>
    </message>
    <message>
        <source>The run is not complete, so it does not say how hard fragments hit: there is no impact energy.</source>
        <translation>计算不完整，未说明碎块撞击的强度：没有冲击能。</translation>
    </message>
    <message>
        <source>The run of {0} was stopped before its simulation began</source>
        <translation>{0} 的计算在模拟开始前已停止</translation>
    </message>
    <message>
        <source>The run was not made from {0}: it has fewer elements</source>
        <translation>该计算不是由 {0} 得到的：后者单元较少</translation>
    </message>
    <message>
        <source>The run was not made from {0}: it has fewer elements.</source>
        <translation>该计算不是由 {0} 得到的：后者单元较少。</translation>
    </message>
    <message>
        <source>The run was stopped before anything was simulated: there is nothing to map.</source>
        <translation>计算在模拟任何内容之前已停止：没有可制图的内容。</translation>
    </message>
    <message>
        <source>The series does not say when its states are: they were taken one second apart</source>
        <translation>序列未说明各状态的时刻：按间隔一秒处理</translation>
    </message>
    <message>
        <source>The shares of the core and of the run-out must lie above 0 and at most at 1.</source>
        <translation>核心区和散落距离的比例必须大于 0 且不超过 1。</translation>
    </message>
    <message>
        <source>The states hold no places of nodes: nothing moves</source>
        <translation>各状态没有节点位置：没有运动</translation>
    </message>
    <message>
        <source>The status of elements is neither 0, 1 nor 255; these count as active</source>
        <translation>单元状态既非 0、1 也非 255；这些视为激活</translation>
    </message>
    <message>
        <source>The structure lies far from the origin and was moved to a local one</source>
        <translation>结构远离原点，已移至局部原点</translation>
    </message>
    <message>
        <source>The structure would be {0} large</source>
        <translation>结构尺寸将为 {0}</translation>
    </message>
    <message>
        <source>The structure would be {0} large: no structure is</source>
        <translation>结构尺寸将为 {0}：没有这样的结构</translation>
    </message>
    <message>
        <source>The terrain has no finite height at node {0} of row {1}, counted from the south-west</source>
        <translation>地形在第 {1} 行（自西南起）节点 {0} 处没有有限高程</translation>
    </message>
    <message>
        <source>The terrain {0} is empty</source>
        <translation>地形 {0} 为空</translation>
    </message>
    <message>
        <source>The terrain {0} is not a file</source>
        <translation>地形 {0} 不是文件</translation>
    </message>
    <message>
        <source>The unit of mass was taken from the densities: t, kg or g per cubed length unit</source>
        <translation>质量单位由密度得出：t、kg 或 g 每立方长度单位</translation>
    </message>
    <message>
        <source>The units of the file cannot be told: {0}</source>
        <translation>无法判断文件的单位：{0}</translation>
    </message>
    <message>
        <source>The up axis of the file cannot be told: {0}</source>
        <translation>无法判断文件的竖直轴：{0}</translation>
    </message>
    <message>
        <source>The user&apos;s numbers cannot be read; elements are numbered as they stand in the file</source>
        <translation>无法读取用户编号；单元按文件中的次序编号</translation>
    </message>
    <message>
        <source>The value</source>
        <translation>该值</translation>
    </message>
    <message>
        <source>The velocity of a dying element is not known: it is born at rest</source>
        <translation>某失效单元的速度未知：产生时静止</translation>
    </message>
    <message>
        <source>The velocity of some corners of a dying element is not known</source>
        <translation>某失效单元部分角点的速度未知</translation>
    </message>
    <message>
        <source>The velocity of elements of released islands is not known</source>
        <translation>释放的孤立部分中有单元的速度未知</translation>
    </message>
    <message>
        <source>Their elements keep what they were: copy the files that the deck includes beside it.</source>
        <translation>其单元保持原状：请将输入文件所包含的文件复制到旁边。</translation>
    </message>
    <message>
        <source>There is no component &quot;{0}&quot; among {1}</source>
        <translation>{1} 中没有构件“{0}”</translation>
    </message>
    <message>
        <source>There is no file {0}</source>
        <translation>没有文件 {0}</translation>
    </message>
    <message>
        <source>There is no map at {0}: the run goes from {1} to {2}.</source>
        <translation>{0} 没有地图：计算范围为 {1} 至 {2}。</translation>
    </message>
    <message>
        <source>There is no material &quot;{0}&quot;.</source>
        <translation>没有材料“{0}”。</translation>
    </message>
    <message>
        <source>There is no parameter &quot;{0}&quot;.</source>
        <translation>没有参数“{0}”。</translation>
    </message>
    <message>
        <source>There is no preset &quot;{0}&quot;.</source>
        <translation>没有预设“{0}”。</translation>
    </message>
    <message>
        <source>There is no terrain file {0}</source>
        <translation>没有地形文件 {0}</translation>
    </message>
    <message>
        <source>These pairs leave the camera open: other cameras see them alike.</source>
        <translation>这些点对不能确定相机：其他相机所见相同。</translation>
    </message>
    <message>
        <source>The points do not fit the focal length given, {0}: with {1} they would fit, and the camera would stand {2} from where it was found.</source>
        <translation>各点与给定的焦距 {0} 不吻合：取 {1} 则吻合，相机将距求得的位置 {2}。</translation>
    </message>
    <message>
        <source>Let the focal length be found. What a file notes is rounded, and holds for the whole picture only.</source>
        <translation>请求解焦距。文件所记的焦距经过取整，且只对整张照片成立。</translation>
    </message>
    <message>
        <source>The points do not fit a lens whose axis meets the picture where it was said: it seems to be {0} off, and the camera {1} from where it was found.</source>
        <translation>各点与光轴位于所述主点的镜头不吻合：主点似乎偏离 {0}，相机距求得的位置 {1}。</translation>
    </message>
    <message>
        <source>Let the principal point be found, and look whether the photograph was cropped.</source>
        <translation>请求解主点，并查看照片是否被裁剪。</translation>
    </message>
    <message>
        <source>The residuals go with the distance from the middle of the picture: the lens bends lines otherwise than was said. With its distortion found the camera would stand {0} from where it was found.</source>
        <translation>残差随到照片中央的距离变化：镜头的畸变与所述不同。若求解畸变，相机将距求得的位置 {0}。</translation>
    </message>
    <message>
        <source>Let the distortion be found automatically.</source>
        <translation>请自动求解畸变。</translation>
    </message>
    <message>
        <source>The residuals go with the distance from the middle of the picture: two radial terms do not describe this lens. A third would move the camera by {0}.</source>
        <translation>残差随到照片中央的距离变化：两项径向畸变不足以描述该镜头。第三项会使相机移动 {0}。</translation>
    </message>
    <message>
        <source>Take points nearer to the middle, or a picture whose distortion was taken out.</source>
        <translation>请取更靠近中央的点，或使用已消除畸变的照片。</translation>
    </message>
    <message>
        <source>The points hardly tell the distortion of the lens from its focal length: they lie {0} to {1} % of the way from the middle of the picture to its corners. The regions allow for that; the corners may lie {2} % nearer or farther.</source>
        <translation>各点几乎不能区分镜头的畸变与焦距：它们位于照片中央到四角距离的 {0} 至 {1} %。区域已计及此点；四角可能近或远 {2} %。</translation>
    </message>
    <message>
        <source>Add points near the middle and near the corners, or say that there is no distortion if it was taken out.</source>
        <translation>请添加靠近中央和四角的点；若畸变已被消除，请说明没有畸变。</translation>
    </message>
    <message>
        <source>Give a JPEG, PNG, TIFF or HEIC file, copied anew from where it came.</source>
        <translation>请给出 JPEG、PNG、TIFF 或 HEIC 文件，从来源重新复制。</translation>
    </message>
    <message>
        <source>What the photograph says of its camera, time and place is not read from this kind of file.</source>
        <translation>照片关于相机、时间和地点的记录不能从这种文件读取。</translation>
    </message>
    <message>
        <source>The focal length is found from the point pairs; set the time by hand, or give the photograph as it came from the camera.</source>
        <translation>焦距由点对求得；时间请手工设置，或给出相机直接生成的照片。</translation>
    </message>
    <message>
        <source>What the photograph says of its camera, time and place is damaged and cannot be read.</source>
        <translation>照片关于相机、时间和地点的记录已损坏，不能读取。</translation>
    </message>
    <message>
        <source>Copy the photograph anew from where it came; else set the time by hand.</source>
        <translation>请从来源重新复制照片；否则手工设置时间。</translation>
    </message>
    <message>
        <source>EXIF says that the photograph lies on a side, the boxes of its HEIF file do not; these count.</source>
        <translation>EXIF 说照片侧放，其 HEIF 文件的盒则不然；以后者为准。</translation>
    </message>
    <message>
        <source>If it lies on its side, turn it in a program for photographs and add it anew.</source>
        <translation>若照片侧放，请用照片程序转正后重新添加。</translation>
    </message>
    <message>
        <source>They move with the mean of the others; ask the solver for velocities or for more states.</source>
        <translation>它们取其余的平均运动；请让求解器输出速度或更多状态。</translation>
    </message>
    <message>
        <source>They were active at a single state of a result without velocities and are released at rest.</source>
        <translation>在没有速度的结果中，它们只在一个状态激活，因此静止释放。</translation>
    </message>
    <message>
        <source>Time of arrival</source>
        <translation>到达时刻</translation>
    </message>
    <message>
        <source>Times must be finite: write the file again, or give a .pvd with the times.</source>
        <translation>时刻必须为有限值：请重新写出文件，或给出带时间的 .pvd。</translation>
    </message>
    <message>
        <source>Times of deletion lie outside the interval in which the element dies; they were left out</source>
        <translation>删除时刻不在单元失效的区间内；已略去</translation>
    </message>
    <message>
        <source>Times that only some of the collections have were left out</source>
        <translation>仅部分集合具有的时刻已略去</translation>
    </message>
    <message>
        <source>Two cameras see these points alike: one {0} from the other.</source>
        <translation>两个相机所见各点相同：两者相距 {0}。</translation>
    </message>
    <message>
        <source>Unpack it, then give the result in it.</source>
        <translation>请解压，然后给出其中的结果。</translation>
    </message>
    <message>
        <source>Use a newer version of Rubble, or make the copy again.</source>
        <translation>请使用更新版本的 Rubble，或重新生成副本。</translation>
    </message>
    <message>
        <source>Use the run as it is, or name the run that you mean.</source>
        <translation>请按现状使用该计算，或指明所要的计算。</translation>
    </message>
    <message>
        <source>VTK legacy</source>
        <translation>VTK 旧格式</translation>
    </message>
    <message>
        <source>Volume per area</source>
        <translation>单位面积体积</translation>
    </message>
    <message>
        <source>Volume per area, live structure</source>
        <translation>单位面积体积，未失效结构</translation>
    </message>
    <message>
        <source>Wait until the analysis has written it, or copy it again.</source>
        <translation>请等待分析程序写出，或重新复制。</translation>
    </message>
    <message>
        <source>What was kept of an earlier study is damaged and is made again.</source>
        <translation>先前研究保留的内容已损坏，将重新生成。</translation>
    </message>
    <message>
        <source>Whole components may move as one body; lower the grid for accuracy</source>
        <translation>整个构件可能作为一个刚体运动；减小网格可提高精度</translation>
    </message>
    <message>
        <source>Write all functions at the same times.</source>
        <translation>请在相同的时刻写出所有函数。</translation>
    </message>
    <message>
        <source>Write all numbers with one decimal sign and without marks of thousands.</source>
        <translation>请用同一种小数符号书写所有数字，且不用千位分隔符。</translation>
    </message>
    <message>
        <source>Write it again, or give one of the series&apos; own files.</source>
        <translation>请重新写出，或给出序列自身的文件之一。</translation>
    </message>
    <message>
        <source>Write it as an unstructured grid (VTKHDF 1.0 or 2.x), or as .vtu files with a .pvd.</source>
        <translation>请写成非结构网格（VTKHDF 1.0 或 2.x），或 .vtu 文件加 .pvd。</translation>
    </message>
    <message>
        <source>Write it with a newer version.</source>
        <translation>请用更新版本写出。</translation>
    </message>
    <message>
        <source>Write it with a point as decimal sign, or leave the line out.</source>
        <translation>请以小数点书写，或删去该行。</translation>
    </message>
    <message>
        <source>Write it without QUADR in *DATABASE_EXTENT_BINARY.</source>
        <translation>请在 *DATABASE_EXTENT_BINARY 中不使用 QUADR 写出。</translation>
    </message>
    <message>
        <source>Write it without the rigid body data (*DATABASE_BINARY_D3PLOT).</source>
        <translation>请不带刚体数据写出（*DATABASE_BINARY_D3PLOT）。</translation>
    </message>
    <message>
        <source>Write it without them.</source>
        <translation>请不带它们写出。</translation>
    </message>
    <message>
        <source>Write the d3plot with a version that deletes by element.</source>
        <translation>请用按单元删除的版本写出 d3plot。</translation>
    </message>
    <message>
        <source>Write the d3plot with the geometry of the nodes.</source>
        <translation>请带节点几何写出 d3plot。</translation>
    </message>
    <message>
        <source>Write the element&apos;s number and the time of its death on each line, and 0 (dead) or 1 (active) if there is a status.</source>
        <translation>每行写单元编号及其失效时刻；若有状态，写 0（失效）或 1（激活）。</translation>
    </message>
    <message>
        <source>Write the result as .vtu files with a .pvd, or with its values in HDF5.</source>
        <translation>请将结果写成 .vtu 文件加 .pvd，或将数值写入 HDF5。</translation>
    </message>
    <message>
        <source>Write the result as an unstructured grid (.vtu) or a series of them (.pvd).</source>
        <translation>请将结果写成非结构网格（.vtu）或其序列（.pvd）。</translation>
    </message>
    <message>
        <source>Write the series with a unique number for every element.</source>
        <translation>请写出每个单元编号唯一的序列。</translation>
    </message>
    <message>
        <source>Write the series with node numbers (point data NODE_ID or GlobalNodeId), or keep all points.</source>
        <translation>请写出带节点编号的序列（点数据 NODE_ID 或 GlobalNodeId），或保留全部点。</translation>
    </message>
    <message>
        <source>Writing the states</source>
        <translation>正在写入状态</translation>
    </message>
    <message>
        <source>Writing {0}</source>
        <translation>正在写入 {0}</translation>
    </message>
    <message>
        <source>Wyllie (2014): about 0.2 for normal impacts in the field on rock and concrete; laboratory 0.3-0.5, Asteriou &amp; Tsiambaos (2018)</source>
        <translation>Wyllie (2014)：现场对岩石和混凝土的法向撞击约 0.2；室内 0.3-0.5，Asteriou &amp; Tsiambaos (2018)</translation>
    </message>
    <message>
        <source>a JSON text, perhaps a case</source>
        <translation>JSON 文本，可能是案例</translation>
    </message>
    <message>
        <source>a SHA-256 has 64 lower-case hexadecimal digits</source>
        <translation>SHA-256 为 64 位小写十六进制数字</translation>
    </message>
    <message>
        <source>a VTK legacy file</source>
        <translation>VTK 旧格式文件</translation>
    </message>
    <message>
        <source>a binary file of another format</source>
        <translation>其他格式的二进制文件</translation>
    </message>
    <message>
        <source>a blast file</source>
        <translation>爆炸文件</translation>
    </message>
    <message>
        <source>a block has no end</source>
        <translation>某块没有结尾</translation>
    </message>
    <message>
        <source>a block has no format</source>
        <translation>某块没有格式</translation>
    </message>
    <message>
        <source>a block of 4096 bytes</source>
        <translation>一个 4096 字节的块</translation>
    </message>
    <message>
        <source>a block of results should say how many nodes it has</source>
        <translation>结果块应说明节点数</translation>
    </message>
    <message>
        <source>a cluster has members that do not exist</source>
        <translation>某聚类的成员不存在</translation>
    </message>
    <message>
        <source>a collapse log of OpenSees</source>
        <translation>OpenSees 的倒塌日志</translation>
    </message>
    <message>
        <source>a count is negative</source>
        <translation>某计数为负</translation>
    </message>
    <message>
        <source>a cpm file (airbag particles)</source>
        <translation>cpm 文件（气囊粒子）</translation>
    </message>
    <message>
        <source>a d3drlf file (dynamic relaxation)</source>
        <translation>d3drlf 文件（动力松弛）</translation>
    </message>
    <message>
        <source>a d3eigv file (eigenvectors)</source>
        <translation>d3eigv 文件（特征向量）</translation>
    </message>
    <message>
        <source>a d3thdt file (time histories)</source>
        <translation>d3thdt 文件（时程）</translation>
    </message>
    <message>
        <source>a digest of 32 hexadecimal digits</source>
        <translation>32 位十六进制摘要</translation>
    </message>
    <message>
        <source>a file of Tecplot</source>
        <translation>Tecplot 文件</translation>
    </message>
    <message>
        <source>a fragment names a component that does not exist</source>
        <translation>某碎块所指的构件不存在</translation>
    </message>
    <message>
        <source>a grid has no topology or no geometry</source>
        <translation>某网格没有拓扑或几何</translation>
    </message>
    <message>
        <source>a harmonic analysis</source>
        <translation>谐响应分析</translation>
    </message>
    <message>
        <source>a line of 80 columns</source>
        <translation>一行 80 列</translation>
    </message>
    <message>
        <source>a list of three numbers</source>
        <translation>三个数值的列表</translation>
    </message>
    <message>
        <source>a list of three whole numbers</source>
        <translation>三个整数的列表</translation>
    </message>
    <message>
        <source>a longer one</source>
        <translation>更长的一个</translation>
    </message>
    <message>
        <source>a mesh of Gmsh (.msh)</source>
        <translation>Gmsh 网格（.msh）</translation>
    </message>
    <message>
        <source>a modal analysis</source>
        <translation>模态分析</translation>
    </message>
    <message>
        <source>a number above zero</source>
        <translation>大于零的数值</translation>
    </message>
    <message>
        <source>a pile at rest wakes</source>
        <translation>静止的堆积体被唤醒</translation>
    </message>
    <message>
        <source>a pointer of Git LFS, not the file itself</source>
        <translation>Git LFS 指针，而非文件本身</translation>
    </message>
    <message>
        <source>a pointer of git-annex, not the file itself</source>
        <translation>git-annex 指针，而非文件本身</translation>
    </message>
    <message>
        <source>a positive length in metres</source>
        <translation>以米为单位的正长度</translation>
    </message>
    <message>
        <source>a punch file of Nastran</source>
        <translation>Nastran 穿孔文件</translation>
    </message>
    <message>
        <source>a real of 22 columns</source>
        <translation>22 列的实数</translation>
    </message>
    <message>
        <source>a record of 2 or more words</source>
        <translation>2 个或更多字的记录</translation>
    </message>
    <message>
        <source>a result in CGNS</source>
        <translation>CGNS 结果</translation>
    </message>
    <message>
        <source>a result in EnSight format</source>
        <translation>EnSight 格式的结果</translation>
    </message>
    <message>
        <source>a result of GiD</source>
        <translation>GiD 结果</translation>
    </message>
    <message>
        <source>a result of HyperView (.h3d)</source>
        <translation>HyperView 结果（.h3d）</translation>
    </message>
    <message>
        <source>a result of Nastran (.op2)</source>
        <translation>Nastran 结果（.op2）</translation>
    </message>
    <message>
        <source>a solid does not have the corners of its shape</source>
        <translation>某实体单元的角点数与其形状不符</translation>
    </message>
    <message>
        <source>a spectrum analysis</source>
        <translation>谱分析</translation>
    </message>
    <message>
        <source>a substructure analysis</source>
        <translation>子结构分析</translation>
    </message>
    <message>
        <source>a surface mesh</source>
        <translation>表面网格</translation>
    </message>
    <message>
        <source>a surface of the rigid road</source>
        <translation>刚性路面</translation>
    </message>
    <message>
        <source>a text of at most 4096 bytes</source>
        <translation>至多 4096 字节的文本</translation>
    </message>
    <message>
        <source>a universal file (.unv)</source>
        <translation>通用格式文件（.unv）</translation>
    </message>
    <message>
        <source>a vector of nodes</source>
        <translation>节点向量</translation>
    </message>
    <message>
        <source>a web page</source>
        <translation>网页</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>adapted elements</source>
        <translation>自适应单元</translation>
    </message>
    <message>
        <source>an XML text</source>
        <translation>XML 文本</translation>
    </message>
    <message>
        <source>an angle between 0 and 180 degrees</source>
        <translation>0 至 180 度之间的角度</translation>
    </message>
    <message>
        <source>an archive or a compressed file</source>
        <translation>压缩包或压缩文件</translation>
    </message>
    <message>
        <source>an eigenvalue buckling analysis</source>
        <translation>特征值屈曲分析</translation>
    </message>
    <message>
        <source>an element is short</source>
        <translation>某单元过短</translation>
    </message>
    <message>
        <source>an element makes a fragment here or in the reference, not in both</source>
        <translation>有单元只在此处或只在基准计算中形成碎块，而非两者皆有</translation>
    </message>
    <message>
        <source>an entry names no file</source>
        <translation>某条目未指定文件</translation>
    </message>
    <message>
        <source>an id must not be empty and must be the only one of its kind</source>
        <translation>标识不能为空，且同类中必须唯一</translation>
    </message>
    <message>
        <source>an increment does not say its time</source>
        <translation>某增量步未说明其时间</translation>
    </message>
    <message>
        <source>an input deck of Nastran</source>
        <translation>Nastran 输入文件</translation>
    </message>
    <message>
        <source>an input needs a path</source>
        <translation>输入需要路径</translation>
    </message>
    <message>
        <source>an intfor file (interface forces)</source>
        <translation>intfor 文件（界面力）</translation>
    </message>
    <message>
        <source>an item I, D or A</source>
        <translation>I、D 或 A 项</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>an output database of Abaqus (.odb)</source>
        <translation>Abaqus 输出数据库（.odb）</translation>
    </message>
    <message>
        <source>api version</source>
        <translation>API 版本</translation>
    </message>
    <message>
        <source>as many fragments as the file has room for</source>
        <translation>文件所能容纳的碎块数</translation>
    </message>
    <message>
        <source>as set</source>
        <translation>按设置</translation>
    </message>
    <message>
        <source>beams and their values</source>
        <translation>梁及其数值</translation>
    </message>
    <message>
        <source>below the ground</source>
        <translation>位于地面以下</translation>
    </message>
    <message>
        <source>biquadratic quadratic hexahedron</source>
        <translation>双二次-二次六面体</translation>
    </message>
    <message>
        <source>biquadratic quadratic wedge</source>
        <translation>双二次-二次楔形体</translation>
    </message>
    <message>
        <source>biquadratic quadrilateral</source>
        <translation>双二次四边形</translation>
    </message>
    <message>
        <source>biquadratic triangle</source>
        <translation>双二次三角形</translation>
    </message>
    <message>
        <source>birth/death field</source>
        <translation>生死场</translation>
    </message>
    <message>
        <source>bodies can meet: the fall columns of {0} and {1} overlap by {2}</source>
        <translation>刚体可能相遇：{0} 与 {1} 的下落柱重叠 {2}</translation>
    </message>
    <message>
        <source>bodies inside each other</source>
        <translation>刚体相互侵入</translation>
    </message>
    <message>
        <source>by its name</source>
        <translation>按名称</translation>
    </message>
    <message>
        <source>by the frame of the case</source>
        <translation>按案例的坐标框架</translation>
    </message>
    <message>
        <source>by the setting units</source>
        <translation>按设置 units</translation>
    </message>
    <message>
        <source>by the setting up_axis</source>
        <translation>按设置 up_axis</translation>
    </message>
    <message>
        <source>bytes that have the digest at the end</source>
        <translation>末尾具有该摘要的字节</translation>
    </message>
    <message>
        <source>cells of {0} by {1} were resampled to {2}</source>
        <translation>{0} x {1} 的单元格已重采样为 {2}</translation>
    </message>
    <message>
        <source>clustering {0} settings</source>
        <translation>正在对 {0} 项设置聚类</translation>
    </message>
    <message>
        <source>clusters can hit at {0}, above the assumed threshold of {1}, but would leave {2} bodies where {3} are allowed (bodies_max)</source>
        <translation>聚类的撞击速度可达 {0}，超过假定阈值 {1}，但会产生 {2} 个刚体，而允许 {3} 个（bodies_max）</translation>
    </message>
    <message>
        <source>component that most of the mass in the cell comes from</source>
        <translation>单元格内大部分质量来自的构件</translation>
    </message>
    <message>
        <source>convert them first if they are feet</source>
        <translation>若为英尺请先换算</translation>
    </message>
    <message>
        <source>convert them first if they are not</source>
        <translation>若不是请先换算</translation>
    </message>
    <message>
        <source>convex set of points</source>
        <translation>凸点集</translation>
    </message>
    <message>
        <source>corners of a cell</source>
        <translation>单元格的角点</translation>
    </message>
    <message>
        <source>cubic line</source>
        <translation>三次线</translation>
    </message>
    <message>
        <source>d3plot, d3plot01, ...</source>
        <translation>d3plot、d3plot01、…</translation>
    </message>
    <message>
        <source>debris can fall on the terrain, which lies between {0} and {1}</source>
        <translation>堆积物可能落在高程 {0} 至 {1} 之间的地形上</translation>
    </message>
    <message>
        <source>debris can reach {0} below the level of the water at {1}</source>
        <translation>堆积物可到达水位 {1} 以下 {0} 处</translation>
    </message>
    <message>
        <source>deletion table of nodes: dead when all nodes are gone (MDLOPT 1)</source>
        <translation>节点删除表：全部节点消失即失效（MDLOPT 1）</translation>
    </message>
    <message>
        <source>deletion table, 0 is dead (MDLOPT 2)</source>
        <translation>删除表，0 为失效（MDLOPT 2）</translation>
    </message>
    <message>
        <source>density {0} of &quot;{1}&quot; is {2}, {3}</source>
        <translation>“{1}”的密度 {0} 为 {2}，{3}</translation>
    </message>
    <message>
        <source>element post codes</source>
        <translation>单元后处理代码</translation>
    </message>
    <message>
        <source>elements are not written in the solid format (EBLOCK,19,SOLID)</source>
        <translation>单元未以实体格式写出（EBLOCK,19,SOLID）</translation>
    </message>
    <message>
        <source>empty cell</source>
        <translation>空单元</translation>
    </message>
    <message>
        <source>ends inside its values</source>
        <translation>在其数值内部结束</translation>
    </message>
    <message>
        <source>energy gained</source>
        <translation>能量增加</translation>
    </message>
    <message>
        <source>energy rose by {0} of the work of gravity beyond gravity, births, overlap, pieces and effects; the limit is {1} ({2} gained most)</source>
        <translation>除重力、产生、重叠、运动结构和效应外，能量增加了重力功的 {0}；限值为 {1}（{2} 增加最多）</translation>
    </message>
    <message>
        <source>far outside the site</source>
        <translation>远在场地之外</translation>
    </message>
    <message>
        <source>faster than gravity</source>
        <translation>快于重力所能</translation>
    </message>
    <message>
        <source>find the file with the SHA-256 of the case, or save the case anew</source>
        <translation>请找到与案例 SHA-256 相符的文件，或重新保存案例</translation>
    </message>
    <message>
        <source>flags of airbags</source>
        <translation>气囊标志</translation>
    </message>
    <message>
        <source>flags of particles</source>
        <translation>粒子标志</translation>
    </message>
    <message>
        <source>floating point word size</source>
        <translation>浮点字长</translation>
    </message>
    <message>
        <source>fluid materials</source>
        <translation>流体材料</translation>
    </message>
    <message>
        <source>free nodes fall along {0}</source>
        <translation>自由节点沿 {0} 下落</translation>
    </message>
    <message>
        <source>free nodes fall at {0}, which is {1}</source>
        <translation>自由节点以 {0} 下落，即 {1}</translation>
    </message>
    <message>
        <source>further nodes of elements</source>
        <translation>单元的其他节点</translation>
    </message>
    <message>
        <source>give a raster that covers the whole site</source>
        <translation>请给出覆盖整个场地的栅格</translation>
    </message>
    <message>
        <source>give a raster with one band if that is not right</source>
        <translation>若不对，请给出单波段栅格</translation>
    </message>
    <message>
        <source>grams, centimetres, microseconds (stress in Mbar)</source>
        <translation>克、厘米、微秒（应力 Mbar）</translation>
    </message>
    <message>
        <source>grams, centimetres, seconds (stress in dyn/cm2)</source>
        <translation>克、厘米、秒（应力 dyn/cm2）</translation>
    </message>
    <message>
        <source>grams, millimetres, milliseconds (stress in MPa)</source>
        <translation>克、毫米、毫秒（应力 MPa）</translation>
    </message>
    <message>
        <source>grams, millimetres, seconds (stress in Pa)</source>
        <translation>克、毫米、秒（应力 Pa）</translation>
    </message>
    <message>
        <source>has elements of higher order in full</source>
        <translation>含完整的高阶单元</translation>
    </message>
    <message>
        <source>has flow variables</source>
        <translation>含流动变量</translation>
    </message>
    <message>
        <source>has two dimensions</source>
        <translation>为二维</translation>
    </message>
    <message>
        <source>held by most elements at the first state</source>
        <translation>初始状态多数单元的取值</translation>
    </message>
    <message>
        <source>hexagonal prism</source>
        <translation>六棱柱</translation>
    </message>
    <message>
        <source>how many fragments reach into the cell</source>
        <translation>有多少碎块伸入该单元格</translation>
    </message>
    <message>
        <source>inferred: dead when all stresses have become 0 (no deletion table, MDLOPT 0)</source>
        <translation>推断：全部应力变为 0 即失效（没有删除表，MDLOPT 0）</translation>
    </message>
    <message>
        <source>integration points</source>
        <translation>积分点</translation>
    </message>
    <message>
        <source>it does not have one row for each fragment</source>
        <translation>它没有为每个碎块提供一行</translation>
    </message>
    <message>
        <source>it does not have the columns of this version</source>
        <translation>它没有此版本的各列</translation>
    </message>
    <message>
        <source>it does not match the vertices</source>
        <translation>它与顶点不符</translation>
    </message>
    <message>
        <source>it has no attribute version</source>
        <translation>它没有版本属性</translation>
    </message>
    <message>
        <source>it has no shape</source>
        <translation>它没有形状</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>它已损坏</translation>
    </message>
    <message>
        <source>it is larger than an index can be</source>
        <translation>它大于索引所能表示</translation>
    </message>
    <message>
        <source>it is no unstructured grid</source>
        <translation>它不是非结构网格</translation>
    </message>
    <message>
        <source>it is not there</source>
        <translation>它不存在</translation>
    </message>
    <message>
        <source>it lies too far outside the {0} earlier points</source>
        <translation>它超出 {0} 个已有点的范围太远</translation>
    </message>
    <message>
        <source>it names a body or elements that do not exist</source>
        <translation>它所指的刚体或单元不存在</translation>
    </message>
    <message>
        <source>it names a cluster that does not exist</source>
        <translation>它所指的聚类不存在</translation>
    </message>
    <message>
        <source>it names a fragment or a body that does not exist</source>
        <translation>它所指的碎块或刚体不存在</translation>
    </message>
    <message>
        <source>it names a fragment that does not exist</source>
        <translation>它所指的碎块不存在</translation>
    </message>
    <message>
        <source>it names no files</source>
        <translation>它未指定文件</translation>
    </message>
    <message>
        <source>its activity does not go with its states and elements</source>
        <translation>其激活信息与状态数和单元数不符</translation>
    </message>
    <message>
        <source>its content is not what the run wrote</source>
        <translation>其内容不是该计算所写</translation>
    </message>
    <message>
        <source>its counts of points, cells and connectivity do not go together</source>
        <translation>其点数、单元数与连接关系不一致</translation>
    </message>
    <message>
        <source>its points do not have three coordinates</source>
        <translation>其点没有三个坐标</translation>
    </message>
    <message>
        <source>its rows are longer than the file</source>
        <translation>其行数超过文件长度</translation>
    </message>
    <message>
        <source>its size cannot be read</source>
        <translation>无法读取其大小</translation>
    </message>
    <message>
        <source>its tables are not those that it was sealed with</source>
        <translation>其各表不是封存时的内容</translation>
    </message>
    <message>
        <source>its tables do not go together</source>
        <translation>其各表不一致</translation>
    </message>
    <message>
        <source>its temporal collections have no time in common</source>
        <translation>其时间集合没有共同的时刻</translation>
    </message>
    <message>
        <source>keep one, or merge them into one raster</source>
        <translation>请保留一个，或合并为一个栅格</translation>
    </message>
    <message>
        <source>kilograms, metres, seconds (stress in Pa)</source>
        <translation>千克、米、秒（应力 Pa）</translation>
    </message>
    <message>
        <source>kilograms, millimetres, milliseconds (stress in GPa)</source>
        <translation>千克、毫米、毫秒（应力 GPa）</translation>
    </message>
    <message>
        <source>kilograms, millimetres, seconds (stress in kPa)</source>
        <translation>千克、毫米、秒（应力 kPa）</translation>
    </message>
    <message>
        <source>kinetic energy before the hardest hit, over the area of the cell</source>
        <translation>最大撞击前的动能除以单元格面积</translation>
    </message>
    <message>
        <source>kip s2/in, inches, seconds (stress in ksi)</source>
        <translation>kip s2/in、英寸、秒（应力 ksi）</translation>
    </message>
    <message>
        <source>lbf s2/in, inches, seconds (stress in psi)</source>
        <translation>lbf s2/in、英寸、秒（应力 psi）</translation>
    </message>
    <message>
        <source>leaves out the nodes of rigid bodies</source>
        <translation>略去刚体的节点</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>已略去</translation>
    </message>
    <message>
        <source>lengths in m, z up, mass in kg</source>
        <translation>长度 m，z 向上，质量 kg</translation>
    </message>
    <message>
        <source>level ground at {0} carries the debris; there is no terrain</source>
        <translation>高程 {0} 的水平地面承接堆积物；没有地形</translation>
    </message>
    <message>
        <source>live structure</source>
        <translation>未失效结构</translation>
    </message>
    <message>
        <source>local, metres</source>
        <translation>局部，米</translation>
    </message>
    <message>
        <source>look at the body&apos;s element and its birth velocity in the FE file, or set birth_velocity = rest; without ground bodies fall for ever (ground)</source>
        <translation>请查看该刚体的单元及其在有限元文件中的产生速度，或设置 birth_velocity = rest；没有地面时刚体一直下落（ground）</translation>
    </message>
    <message>
        <source>look at the element of that body in the FE file; switch the effects off one by one to find the one that fails</source>
        <translation>请在有限元文件中查看该刚体的单元；逐一关闭效应以找出出错者</translation>
    </message>
    <message>
        <source>look at the named element in the FE file; check density and coordinates</source>
        <translation>请在有限元文件中查看所指单元；检查密度和坐标</translation>
    </message>
    <message>
        <source>look at the terrain where the debris lies, or give a raster without gaps</source>
        <translation>请查看堆积物处的地形，或给出没有空缺的栅格</translation>
    </message>
    <message>
        <source>lower box_bulking, choose cluster_shape = hull or compound, or raise bodies_max for smaller clusters</source>
        <translation>请减小 box_bulking，选择 cluster_shape = hull 或 compound，或提高 bodies_max 以减小聚类</translation>
    </message>
    <message>
        <source>lower end of the laboratory values for hard blocks, 0.3-0.5, Asteriou &amp; Tsiambaos (2018)</source>
        <translation>坚硬块体室内值的下端，0.3-0.5，Asteriou &amp; Tsiambaos (2018)</translation>
    </message>
    <message>
        <source>lower end of the range for soil, 0.05-0.3, Wyllie (2014)</source>
        <translation>土的取值范围下端，0.05-0.3，Wyllie (2014)</translation>
    </message>
    <message>
        <source>lower half of the range for soil and rubble, 0.05-0.3, Wyllie (2014)</source>
        <translation>土和碎石取值范围的下半部，0.05-0.3，Wyllie (2014)</translation>
    </message>
    <message>
        <source>make sure that both are in the same one</source>
        <translation>请确保两者在同一坐标系中</translation>
    </message>
    <message>
        <source>mass of fallen live structure over the area of the cell</source>
        <translation>坠落的未失效结构的质量除以单元格面积</translation>
    </message>
    <message>
        <source>mass over the area of the cell</source>
        <translation>质量除以单元格面积</translation>
    </message>
    <message>
        <source>material types</source>
        <translation>材料类型</translation>
    </message>
    <message>
        <source>materials and properties</source>
        <translation>材料与属性</translation>
    </message>
    <message>
        <source>mean height of the top of fallen live structure above the ground</source>
        <translation>坠落的未失效结构顶面距地面的平均高度</translation>
    </message>
    <message>
        <source>mean height of the top of the debris above the ground</source>
        <translation>堆积物顶面距地面的平均高度</translation>
    </message>
    <message>
        <source>measuring drawing</source>
        <translation>正在测量绘制</translation>
    </message>
    <message>
        <source>measuring live frames</source>
        <translation>正在测量实时帧</translation>
    </message>
    <message>
        <source>measuring this machine</source>
        <translation>正在测量本机</translation>
    </message>
    <message>
        <source>members of a subset</source>
        <translation>子集的成员</translation>
    </message>
    <message>
        <source>metres, kilograms and seconds</source>
        <translation>米、千克和秒</translation>
    </message>
    <message>
        <source>metres, z up, origin of the frame added</source>
        <translation>米，z 向上，已加上坐标框架原点</translation>
    </message>
    <message>
        <source>minus infinite</source>
        <translation>负无穷</translation>
    </message>
    <message>
        <source>missing elements are dead</source>
        <translation>略去的单元即为失效</translation>
    </message>
    <message>
        <source>more bytes</source>
        <translation>更多字节</translation>
    </message>
    <message>
        <source>name the value for no data with gdal_translate -a_nodata</source>
        <translation>请用 gdal_translate -a_nodata 指定无数据值</translation>
    </message>
    <message>
        <source>names of tensors</source>
        <translation>张量名称</translation>
    </message>
    <message>
        <source>no body</source>
        <translation>没有刚体</translation>
    </message>
    <message>
        <source>no cluster of two or more fragments can be faster than {0}; the assumed threshold is {1}</source>
        <translation>没有两个或更多碎块的聚类能快于 {0}；假定阈值为 {1}</translation>
    </message>
    <message>
        <source>no cluster of two or more fragments is of stone or masonry without reinforcement</source>
        <translation>没有两个或更多碎块的聚类属于未配筋的石材或砌体</translation>
    </message>
    <message>
        <source>no component is marked as reinforced (component[NAME].reinforced)</source>
        <translation>没有构件标为配筋（component[NAME].reinforced）</translation>
    </message>
    <message>
        <source>no element is active once a fragment has been handed over</source>
        <translation>碎块交接后没有单元处于激活状态</translation>
    </message>
    <message>
        <source>no further bytes</source>
        <translation>没有更多字节</translation>
    </message>
    <message>
        <source>no known system fits; the best would be {0}: {1}</source>
        <translation>没有已知单位制相符；最接近的是 {0}：{1}</translation>
    </message>
    <message>
        <source>no level of water is given (water_level)</source>
        <translation>未给出水位（water_level）</translation>
    </message>
    <message>
        <source>no material</source>
        <translation>没有材料</translation>
    </message>
    <message>
        <source>no more is known</source>
        <translation>没有更多信息</translation>
    </message>
    <message>
        <source>no reinforced component falls in two or more clusters</source>
        <translation>没有配筋构件分成两个或更多聚类下落</translation>
    </message>
    <message>
        <source>no two bodies fall</source>
        <translation>没有两个刚体下落</translation>
    </message>
    <message>
        <source>no two of {0} fall columns overlap; the nearest, of {1} and {2}, are {3} apart</source>
        <translation>{0} 个下落柱中没有两个重叠；最近的 {1} 与 {2} 相距 {3}</translation>
    </message>
    <message>
        <source>no usual material</source>
        <translation>不是常见材料</translation>
    </message>
    <message>
        <source>nodal results do not say how many vectors there are</source>
        <translation>节点结果未说明向量数</translation>
    </message>
    <message>
        <source>nodal values</source>
        <translation>节点值</translation>
    </message>
    <message>
        <source>nodes of elements</source>
        <translation>单元的节点</translation>
    </message>
    <message>
        <source>nodes of the rigid road</source>
        <translation>刚性路面的节点</translation>
    </message>
    <message>
        <source>nodes, shells and values</source>
        <translation>节点、壳和数值</translation>
    </message>
    <message>
        <source>none is needed; heights between nodes are interpolated</source>
        <translation>不需要；节点之间的高程为插值</translation>
    </message>
    <message>
        <source>not a file</source>
        <translation>不是文件</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>不是数值</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>未说明</translation>
    </message>
    <message>
        <source>nothing falls into it</source>
        <translation>没有物体落入其中</translation>
    </message>
    <message>
        <source>nothing falls on it</source>
        <translation>没有物体落在其上</translation>
    </message>
    <message>
        <source>nothing moves through the air, or the air has no density</source>
        <translation>没有物体在空气中运动，或空气没有密度</translation>
    </message>
    <message>
        <source>nothing says which elements are dead</source>
        <translation>没有信息说明哪些单元失效</translation>
    </message>
    <message>
        <source>one of the known names</source>
        <translation>已知名称之一</translation>
    </message>
    <message>
        <source>packs three node numbers into a word, as very old versions did</source>
        <translation>像很旧的版本那样将三个节点编号压入一个字</translation>
    </message>
    <message>
        <source>particles and their values</source>
        <translation>粒子及其数值</translation>
    </message>
    <message>
        <source>pentagonal prism</source>
        <translation>五棱柱</translation>
    </message>
    <message>
        <source>pieces = none leaves the structure without collision shapes</source>
        <translation>pieces = none 使结构没有碰撞形状</translation>
    </message>
    <message>
        <source>quadratic edge</source>
        <translation>二次边</translation>
    </message>
    <message>
        <source>quadratic hexahedron</source>
        <translation>二次六面体</translation>
    </message>
    <message>
        <source>quadratic linear quadrilateral</source>
        <translation>二次-线性四边形</translation>
    </message>
    <message>
        <source>quadratic linear wedge</source>
        <translation>二次-线性楔形体</translation>
    </message>
    <message>
        <source>quadratic polygon</source>
        <translation>二次多边形</translation>
    </message>
    <message>
        <source>quadratic pyramid</source>
        <translation>二次棱锥</translation>
    </message>
    <message>
        <source>quadratic quadrilateral</source>
        <translation>二次四边形</translation>
    </message>
    <message>
        <source>quadratic tetrahedron</source>
        <translation>二次四面体</translation>
    </message>
    <message>
        <source>quadratic triangle</source>
        <translation>二次三角形</translation>
    </message>
    <message>
        <source>quadratic wedge</source>
        <translation>二次楔形体</translation>
    </message>
    <message>
        <source>raise bodies_max, or read the debris there as coarser than it is</source>
        <translation>请提高 bodies_max，或将该处堆积物视为偏粗</translation>
    </message>
    <message>
        <source>raise freeze_delay or lower freeze_speed, so that bodies freeze only when at rest</source>
        <translation>请提高 freeze_delay 或减小 freeze_speed，使刚体仅在静止时冻结</translation>
    </message>
    <message>
        <source>raise step_rate for the whole run, or set auto_remedy = false</source>
        <translation>请提高整个计算的 step_rate，或设置 auto_remedy = false</translation>
    </message>
    <message>
        <source>raise step_rate or substeps; light bodies between far heavier ones ask for it</source>
        <translation>请提高 step_rate 或 substeps；夹在重得多的刚体之间的轻刚体需要如此</translation>
    </message>
    <message>
        <source>raise step_rate, or set auto_remedy = true, or raise bodies_max for smaller clusters; under solver = bullet deep piles squeeze together, take soft-step there</source>
        <translation>请提高 step_rate，或设置 auto_remedy = true，或提高 bodies_max 以减小聚类；solver = bullet 时深堆积体会压缩，请改用 soft-step</translation>
    </message>
    <message>
        <source>raise step_rate, or set auto_remedy = true; solver = bullet gains more than soft-step</source>
        <translation>请提高 step_rate，或设置 auto_remedy = true；solver = bullet 的增量大于 soft-step</translation>
    </message>
    <message>
        <source>raise step_rate, or set ground_height (or the terrain) to its real height</source>
        <translation>请提高 step_rate，或将 ground_height（或地形）设为实际高程</translation>
    </message>
    <message>
        <source>raise step_rate; look for births inside other bodies (overlap_speed) and for restitution above 1</source>
        <translation>请提高 step_rate；检查是否在其他刚体内部产生（overlap_speed），以及恢复系数是否大于 1</translation>
    </message>
    <message>
        <source>raise step_rate; under solver = bullet piles squeeze together, take soft-step there</source>
        <translation>请提高 step_rate；solver = bullet 时堆积体会压缩，请改用 soft-step</translation>
    </message>
    <message>
        <source>read them as debris that the FE analysis did not delete</source>
        <translation>请将其视为有限元分析未删除的堆积物</translation>
    </message>
    <message>
        <source>records of elements</source>
        <translation>单元记录</translation>
    </message>
    <message>
        <source>rigid road</source>
        <translation>刚性路面</translation>
    </message>
    <message>
        <source>rigid shells</source>
        <translation>刚性壳</translation>
    </message>
    <message>
        <source>segments of the rigid road</source>
        <translation>刚性路面的面段</translation>
    </message>
    <message>
        <source>series of VTU files</source>
        <translation>VTU 文件序列</translation>
    </message>
    <message>
        <source>set off, as auto would: </source>
        <translation>设为关闭，自动亦然：</translation>
    </message>
    <message>
        <source>set off; auto would be on: </source>
        <translation>设为关闭；自动则会开启：</translation>
    </message>
    <message>
        <source>set on, as auto would: </source>
        <translation>设为开启，自动亦然：</translation>
    </message>
    <message>
        <source>set on, but cannot be: </source>
        <translation>设为开启，但无法开启：</translation>
    </message>
    <message>
        <source>set on; auto would be off: </source>
        <translation>设为开启；自动则会关闭：</translation>
    </message>
    <message>
        <source>should hold integers, but its flags say reals</source>
        <translation>应为整数，但其标志为实数</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>已模拟</translation>
    </message>
    <message>
        <source>simulated, interpolated between two recorded instants</source>
        <translation>已模拟，在两个记录时刻之间插值</translation>
    </message>
    <message>
        <source>simulating {0} worlds for the repeat floor</source>
        <translation>正在为重复性下限模拟 {0} 次计算</translation>
    </message>
    <message>
        <source>simulating {0} worlds: the reference, the settings, their repeats</source>
        <translation>正在模拟 {0} 次计算：基准、各项设置及其重复</translation>
    </message>
    <message>
        <source>simulating {0} worlds: the run, {1} repeats, {2} effects switched</source>
        <translation>正在模拟 {0} 次计算：原计算、{1} 次重复、切换 {2} 个效应</translation>
    </message>
    <message>
        <source>simulating, {0} bodies at {1}</source>
        <translation>正在模拟，{1} 时 {0} 个刚体</translation>
    </message>
    <message>
        <source>size {0} is {1}</source>
        <translation>尺寸 {0} 为 {1}</translation>
    </message>
    <message>
        <source>slugs, feet, seconds (stress in psf)</source>
        <translation>斯勒格、英尺、秒（应力 psf）</translation>
    </message>
    <message>
        <source>solids and their values</source>
        <translation>实体及其数值</translation>
    </message>
    <message>
        <source>split_by_connectivity, split_by_box, split_by_plane, merge or rename</source>
        <translation>split_by_connectivity、split_by_box、split_by_plane、merge 或 rename</translation>
    </message>
    <message>
        <source>status byte, 0 is deleted</source>
        <translation>状态字节，0 为已删除</translation>
    </message>
    <message>
        <source>status_variable</source>
        <translation>status_variable</translation>
    </message>
    <message>
        <source>stone arch (published)</source>
        <translation>石拱桥（论文）</translation>
    </message>
    <message>
        <source>study world</source>
        <translation>研究计算</translation>
    </message>
    <message>
        <source>terrain or stage of the program</source>
        <translation>地形或程序的阶段</translation>
    </message>
    <message>
        <source>the * of a record</source>
        <translation>记录的 *</translation>
    </message>
    <message>
        <source>the active structure stays {0} outside the ballistic reach of every fragment (nearest: {1} to the fragment of {2})</source>
        <translation>激活结构始终在所有碎块的弹道可达范围之外 {0}（最近：距 {2} 的碎块 {1}）</translation>
    </message>
    <message>
        <source>the axes of beams</source>
        <translation>梁的轴</translation>
    </message>
    <message>
        <source>the block names</source>
        <translation>单元块名称</translation>
    </message>
    <message>
        <source>the block numbers</source>
        <translation>单元块编号</translation>
    </message>
    <message>
        <source>the case has no terrain</source>
        <translation>案例没有地形</translation>
    </message>
    <message>
        <source>the case has {0} terrains; the first is used</source>
        <translation>案例有 {0} 个地形；采用第一个</translation>
    </message>
    <message>
        <source>the cells</source>
        <translation>单元格</translation>
    </message>
    <message>
        <source>the cluster of {0} can hit at {1}, above the assumed threshold of {2}; at most {3} bodies result</source>
        <translation>{0} 的聚类撞击速度可达 {1}，超过假定阈值 {2}；至多产生 {3} 个刚体</translation>
    </message>
    <message>
        <source>the control block</source>
        <translation>控制块</translation>
    </message>
    <message>
        <source>the control block and its extension</source>
        <translation>控制块及其扩展</translation>
    </message>
    <message>
        <source>the coordinates</source>
        <translation>坐标</translation>
    </message>
    <message>
        <source>the corner of a cell</source>
        <translation>单元格的角点</translation>
    </message>
    <message>
        <source>the cost of this world on this machine</source>
        <translation>该计算在本机的代价</translation>
    </message>
    <message>
        <source>the element numbers</source>
        <translation>单元编号</translation>
    </message>
    <message>
        <source>the elements have no end</source>
        <translation>单元没有结尾</translation>
    </message>
    <message>
        <source>the fields</source>
        <translation>场</translation>
    </message>
    <message>
        <source>the file cannot be closed</source>
        <translation>文件无法关闭</translation>
    </message>
    <message>
        <source>the file or a deck beside it says so</source>
        <translation>文件或其旁的输入卡如此说明</translation>
    </message>
    <message>
        <source>the first word</source>
        <translation>第一个字</translation>
    </message>
    <message>
        <source>the flags of the header</source>
        <translation>文件头的标志</translation>
    </message>
    <message>
        <source>the forces of beams</source>
        <translation>梁的内力</translation>
    </message>
    <message>
        <source>the header</source>
        <translation>文件头</translation>
    </message>
    <message>
        <source>the header of a set is short</source>
        <translation>结果集的头过短</translation>
    </message>
    <message>
        <source>the header of its geometry is short</source>
        <translation>其几何的头过短</translation>
    </message>
    <message>
        <source>the length of a record, 2 or more words</source>
        <translation>记录长度，2 个或更多字</translation>
    </message>
    <message>
        <source>the length of the extension</source>
        <translation>扩展的长度</translation>
    </message>
    <message>
        <source>the length of the numbers</source>
        <translation>数值的长度</translation>
    </message>
    <message>
        <source>the library fails on it</source>
        <translation>库读取失败</translation>
    </message>
    <message>
        <source>the local axes</source>
        <translation>局部坐标轴</translation>
    </message>
    <message>
        <source>the masses of elements</source>
        <translation>单元的质量</translation>
    </message>
    <message>
        <source>the masses of nodes</source>
        <translation>节点的质量</translation>
    </message>
    <message>
        <source>the materials of parts</source>
        <translation>部件的材料</translation>
    </message>
    <message>
        <source>the mixed topology ends inside a cell</source>
        <translation>混合拓扑在单元格内部结束</translation>
    </message>
    <message>
        <source>the mixed topology ends inside a polyhedron</source>
        <translation>混合拓扑在一个多面体中间结束</translation>
    </message>
    <message>
        <source>the name of a part</source>
        <translation>部件名称</translation>
    </message>
    <message>
        <source>the names of the variables</source>
        <translation>变量名称</translation>
    </message>
    <message>
        <source>the node numbers</source>
        <translation>节点编号</translation>
    </message>
    <message>
        <source>the nodes have no end</source>
        <translation>节点没有结尾</translation>
    </message>
    <message>
        <source>the nodes of elements</source>
        <translation>单元的节点</translation>
    </message>
    <message>
        <source>the nodes&apos; format has no reals</source>
        <translation>节点格式中没有实数</translation>
    </message>
    <message>
        <source>the normals</source>
        <translation>法向</translation>
    </message>
    <message>
        <source>the number of adapted elements</source>
        <translation>自适应单元数</translation>
    </message>
    <message>
        <source>the number of beams</source>
        <translation>梁数</translation>
    </message>
    <message>
        <source>the number of fluid materials</source>
        <translation>流体材料数</translation>
    </message>
    <message>
        <source>the number of global values</source>
        <translation>全局值数</translation>
    </message>
    <message>
        <source>the number of history variables of a shell</source>
        <translation>壳的历史变量数</translation>
    </message>
    <message>
        <source>the number of history variables of a solid</source>
        <translation>实体的历史变量数</translation>
    </message>
    <message>
        <source>the number of materials of beams</source>
        <translation>梁的材料数</translation>
    </message>
    <message>
        <source>the number of materials of particles</source>
        <translation>粒子的材料数</translation>
    </message>
    <message>
        <source>the number of materials of shells</source>
        <translation>壳的材料数</translation>
    </message>
    <message>
        <source>the number of materials of solids</source>
        <translation>实体的材料数</translation>
    </message>
    <message>
        <source>the number of materials of thick shells</source>
        <translation>厚壳的材料数</translation>
    </message>
    <message>
        <source>the number of nodes</source>
        <translation>节点数</translation>
    </message>
    <message>
        <source>the number of particles</source>
        <translation>粒子数</translation>
    </message>
    <message>
        <source>the number of parts</source>
        <translation>部件数</translation>
    </message>
    <message>
        <source>the number of points through the thickness</source>
        <translation>厚度方向的积分点数</translation>
    </message>
    <message>
        <source>the number of shells</source>
        <translation>壳数</translation>
    </message>
    <message>
        <source>the number of shells of eight nodes</source>
        <translation>八节点壳数</translation>
    </message>
    <message>
        <source>the number of solids</source>
        <translation>实体数</translation>
    </message>
    <message>
        <source>the number of solids of twenty nodes</source>
        <translation>二十节点实体数</translation>
    </message>
    <message>
        <source>the number of states</source>
        <translation>状态数</translation>
    </message>
    <message>
        <source>the number of thermal values of a solid</source>
        <translation>实体的热学值数</translation>
    </message>
    <message>
        <source>the number of thick shells</source>
        <translation>厚壳数</translation>
    </message>
    <message>
        <source>the number of values of a beam</source>
        <translation>梁的数值个数</translation>
    </message>
    <message>
        <source>the number of values of a shell</source>
        <translation>壳的数值个数</translation>
    </message>
    <message>
        <source>the number of values of a solid</source>
        <translation>实体的数值个数</translation>
    </message>
    <message>
        <source>the number of values of a thick shell</source>
        <translation>厚壳的数值个数</translation>
    </message>
    <message>
        <source>the number of variables</source>
        <translation>变量数</translation>
    </message>
    <message>
        <source>the numbers of elements</source>
        <translation>单元编号</translation>
    </message>
    <message>
        <source>the numbers of nodes</source>
        <translation>节点编号</translation>
    </message>
    <message>
        <source>the numbers of shells</source>
        <translation>壳的编号</translation>
    </message>
    <message>
        <source>the parts</source>
        <translation>部件</translation>
    </message>
    <message>
        <source>the pile has not the volume that rubble has</source>
        <translation>堆积体的体积与碎石不符</translation>
    </message>
    <message>
        <source>the pile has {0} times the volume of its material, less than {1}: it is squeezed into itself</source>
        <translation>堆积体体积为其材料体积的 {0} 倍，小于 {1}：自身压缩</translation>
    </message>
    <message>
        <source>the pile has {0} times the volume of its material, more than {1}: its shapes are inflated</source>
        <translation>堆积体体积为其材料体积的 {0} 倍，大于 {1}：形状过于膨胀</translation>
    </message>
    <message>
        <source>the place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>the points</source>
        <translation>各点</translation>
    </message>
    <message>
        <source>the record 1921 of a results file</source>
        <translation>结果文件的 1921 号记录</translation>
    </message>
    <message>
        <source>the reinforced component &quot;{0}&quot; falls in {1} clusters</source>
        <translation>配筋构件 “{0}” 分成 {1} 个聚类下落</translation>
    </message>
    <message>
        <source>the rigid road</source>
        <translation>刚性路面</translation>
    </message>
    <message>
        <source>the share of bodies at rest fell to {0} after it had reached {1}</source>
        <translation>静止刚体的比例在达到 {1} 后降至 {0}</translation>
    </message>
    <message>
        <source>the state of elements</source>
        <translation>单元状态</translation>
    </message>
    <message>
        <source>the table of its elements is short</source>
        <translation>其单元表过短</translation>
    </message>
    <message>
        <source>the table of its sets is short</source>
        <translation>其结果集表过短</translation>
    </message>
    <message>
        <source>the tensors of particles</source>
        <translation>粒子的张量</translation>
    </message>
    <message>
        <source>the tensors of shells</source>
        <translation>壳的张量</translation>
    </message>
    <message>
        <source>the tensors of solids</source>
        <translation>实体的张量</translation>
    </message>
    <message>
        <source>the terrain ends {0} beside all that falls</source>
        <translation>地形在所有下落物旁边 {0} 处终止</translation>
    </message>
    <message>
        <source>the terrain ends {0} short of the outline of the structure and goes on level from there</source>
        <translation>地形在距结构轮廓 {0} 处终止，由此以水平面延续</translation>
    </message>
    <message>
        <source>the terrain is not the one the case was saved with</source>
        <translation>地形不是保存案例时的那一个</translation>
    </message>
    <message>
        <source>the terrain lies {0} above all that falls</source>
        <translation>地形位于所有下落物之上 {0}</translation>
    </message>
    <message>
        <source>the terrain lies {0} {1} the whole structure</source>
        <translation>地形位于整个结构{1} {0}</translation>
    </message>
    <message>
        <source>the terrain takes its place, and goes on level beyond its edges</source>
        <translation>由地形代替，并在其边缘之外以水平面延续</translation>
    </message>
    <message>
        <source>{0} at x = {1} m, y = {2} m</source>
        <translation>{0}，位于 x = {1} m、y = {2} m</translation>
    </message>
    <message>
        <source>the library that reads rasters fails on it</source>
        <translation>读取栅格的库在其上失败</translation>
    </message>
    <message>
        <source>loose structure</source>
        <translation>松脱的结构</translation>
    </message>
    <message>
        <source>look at the terrain if debris runs there</source>
        <translation>若堆积物到达那里，请检查地形</translation>
    </message>
    <message>
        <source>{0} places beyond the window about the structure had no height, or one that stands out, and were filled from their neighbours</source>
        <translation>结构周围窗口之外有 {0} 处没有高程或高程突兀，已由相邻值填补</translation>
    </message>
    <message>
        <source>copy the raster again from where it came; debris that runs there falls on a level guess</source>
        <translation>从来源处重新复制栅格；堆积物到达那里时落在水平推测的地面上</translation>
    </message>
    <message>
        <source>what lies beyond the window about the structure cannot be read: {0}</source>
        <translation>结构周围窗口之外的部分无法读取：{0}</translation>
    </message>
    <message>
        <source>make the raster coarser, or cut it about x = {0} to {1}, y = {2} to {3} of the local frame</source>
        <translation>把栅格变粗，或围绕局部坐标框架的 x = {0} 至 {1}、y = {2} 至 {3} 裁剪</translation>
    </message>
    <message>
        <source>{0} pieces of debris ran beyond the part of the terrain that there was room for: the ground there is a level guess, though the raster goes on</source>
        <translation>{0} 块堆积物越过了容纳得下的那部分地形：栅格仍在延续，但该处地面是水平推测</translation>
    </message>
    <message>
        <source>give a larger raster, beyond x = {0} to {1}, y = {2} to {3} of the local frame</source>
        <translation>提供更大的栅格，超出局部坐标框架的 x = {0} 至 {1}、y = {2} 至 {3}</translation>
    </message>
    <message>
        <source>{0} pieces of debris ran beyond the end of the terrain, where its raster has no heights: the ground there is a level guess</source>
        <translation>{0} 块堆积物越过了地形的末端，那里栅格没有高程：该处地面是水平推测</translation>
    </message>
    <message>
        <source>the text ends too early</source>
        <translation>文本过早结束</translation>
    </message>
    <message>
        <source>the texts of the header</source>
        <translation>文件头的文本</translation>
    </message>
    <message>
        <source>the time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>the times of a collection are no numbers</source>
        <translation>一个集合的时刻不是数字</translation>
    </message>
    <message>
        <source>the times of the states</source>
        <translation>各状态的时刻</translation>
    </message>
    <message>
        <source>the top</source>
        <translation>顶部</translation>
    </message>
    <message>
        <source>the truth table of the element variables</source>
        <translation>单元变量的真值表</translation>
    </message>
    <message>
        <source>the type of a cell</source>
        <translation>单元格类型</translation>
    </message>
    <message>
        <source>the types of elements have no end</source>
        <translation>单元类型没有结尾</translation>
    </message>
    <message>
        <source>the unit must be a number above zero</source>
        <translation>单位必须为大于零的数值</translation>
    </message>
    <message>
        <source>the values of elements</source>
        <translation>单元的数值</translation>
    </message>
    <message>
        <source>the values of nodes</source>
        <translation>节点的数值</translation>
    </message>
    <message>
        <source>the velocities</source>
        <translation>各速度</translation>
    </message>
    <message>
        <source>the velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>the verification data is not whole</source>
        <translation>校验数据不完整</translation>
    </message>
    <message>
        <source>the water at {0} stays {1} below the lowest place that debris can reach</source>
        <translation>水位 {0} 低于堆积物可达最低处 {1}</translation>
    </message>
    <message>
        <source>the word on airbags</source>
        <translation>关于气囊的字</translation>
    </message>
    <message>
        <source>the word on coordinates</source>
        <translation>关于坐标的字</translation>
    </message>
    <message>
        <source>the word on derivatives</source>
        <translation>关于导数的字</translation>
    </message>
    <message>
        <source>the word on penetration</source>
        <translation>关于侵入的字</translation>
    </message>
    <message>
        <source>the word on temperatures</source>
        <translation>关于温度的字</translation>
    </message>
    <message>
        <source>the word rubble-world and a digest</source>
        <translation>rubble-world 字样和摘要</translation>
    </message>
    <message>
        <source>there is no mesh</source>
        <translation>没有网格</translation>
    </message>
    <message>
        <source>there was not enough memory for it</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>thick shells</source>
        <translation>厚壳</translation>
    </message>
    <message>
        <source>this is not valid JSON</source>
        <translation>不是有效的 JSON</translation>
    </message>
    <message>
        <source>this key is unknown here</source>
        <translation>此处不认识该键</translation>
    </message>
    <message>
        <source>this machine was busy with other work when it was calibrated</source>
        <translation>标定时本机正忙于其他工作</translation>
    </message>
    <message>
        <source>this machine was calibrated with fragments alone; here whole spans are simulated as well (loose_structure)</source>
        <translation>本机仅以碎块标定，而这里还要模拟整跨（loose_structure）</translation>
    </message>
    <message>
        <source>three finite numbers</source>
        <translation>三个有限数值</translation>
    </message>
    <message>
        <source>time histories</source>
        <translation>时程</translation>
    </message>
    <message>
        <source>timing one setting at a time: {0}</source>
        <translation>正在逐项设置计时：{0}</translation>
    </message>
    <message>
        <source>tonnes, metres, seconds (stress in kPa)</source>
        <translation>吨、米、秒（应力 kPa）</translation>
    </message>
    <message>
        <source>tonnes, millimetres, seconds (stress in MPa)</source>
        <translation>吨、毫米、秒（应力 MPa）</translation>
    </message>
    <message>
        <source>triangle strip</source>
        <translation>三角形条带</translation>
    </message>
    <message>
        <source>triquadratic hexahedron</source>
        <translation>三二次六面体</translation>
    </message>
    <message>
        <source>triquadratic pyramid</source>
        <translation>三二次棱锥</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 或 false</translation>
    </message>
    <message>
        <source>types of cells</source>
        <translation>单元格类型</translation>
    </message>
    <message>
        <source>typical or worst</source>
        <translation>典型或最差</translation>
    </message>
    <message>
        <source>units above zero</source>
        <translation>大于零的单位</translation>
    </message>
    <message>
        <source>unknown reason</source>
        <translation>未知原因</translation>
    </message>
    <message>
        <source>user&apos;s numbers of 8 bytes</source>
        <translation>8 字节的用户编号</translation>
    </message>
    <message>
        <source>values of cells</source>
        <translation>单元格的数值</translation>
    </message>
    <message>
        <source>values of points</source>
        <translation>点的数值</translation>
    </message>
    <message>
        <source>version https://git-lfs</source>
        <translation>version https://git-lfs</translation>
    </message>
    <message>
        <source>volume from mass and density</source>
        <translation>由质量和密度得出的体积</translation>
    </message>
    <message>
        <source>volume from mass and density, or from the space between them</source>
        <translation>由质量和密度或由所围空间得出的体积</translation>
    </message>
    <message>
        <source>volume from the space between them</source>
        <translation>由所围空间得出的体积</translation>
    </message>
    <message>
        <source>volume of fallen live structure over the area of the cell</source>
        <translation>坠落的未失效结构的体积除以单元格面积</translation>
    </message>
    <message>
        <source>volume of material over the area of the cell</source>
        <translation>材料体积除以单元格面积</translation>
    </message>
    <message>
        <source>volume of the largest fragment that reaches into the cell</source>
        <translation>伸入该单元格的最大碎块的体积</translation>
    </message>
    <message>
        <source>volume of the pile</source>
        <translation>堆积体的体积</translation>
    </message>
    <message>
        <source>was written with *DATABASE_EXTENT_BINARY_COMP and leaves out parts of the states</source>
        <translation>以 *DATABASE_EXTENT_BINARY_COMP 写出，略去了部分状态</translation>
    </message>
    <message>
        <source>weight over drag at the highest possible speed of {0} is only {1} (the fragment of {2}), below {3}</source>
        <translation>以最大可能速度 {0} 计，重量与阻力之比仅为 {1}（{2} 的碎块），低于 {3}</translation>
    </message>
    <message>
        <source>weight over drag at the highest possible speed of {0} is {1} or more (least for the fragment of {2}); below {3} a landing would move by 1 %</source>
        <translation>以最大可能速度 {0} 计，重量与阻力之比不小于 {1}（最小者为 {2} 的碎块）；低于 {3} 时落点将移动 1 %</translation>
    </message>
    <message>
        <source>when the first of what lies in the cell came there</source>
        <translation>单元格内首个物体到达的时刻</translation>
    </message>
    <message>
        <source>words of cells</source>
        <translation>单元格的字</translation>
    </message>
    <message>
        <source>{0} asks for more memory than there is</source>
        <translation>{0} 需要的内存超过现有内存</translation>
    </message>
    <message>
        <source>{0} bodies are more or fewer than this machine was calibrated with</source>
        <translation>{0} 个刚体超出本机标定的范围</translation>
    </message>
    <message>
        <source>{0} bodies cannot be calibrated with.</source>
        <translation>不能以 {0} 个刚体标定。</translation>
    </message>
    <message>
        <source>{0} bodies have no finite, positive mass, inertia, place or size and were left out</source>
        <translation>{0} 个刚体没有有限且为正的质量、惯量、位置或尺寸，已略去</translation>
    </message>
    <message>
        <source>{0} cannot be &quot;{1}&quot;.</source>
        <translation>{0} 不能为“{1}”。</translation>
    </message>
    <message>
        <source>{0} cannot be made: {1}</source>
        <translation>无法生成 {0}：{1}</translation>
    </message>
    <message>
        <source>{0} cannot be opened as HDF5: {1}</source>
        <translation>无法以 HDF5 打开 {0}：{1}</translation>
    </message>
    <message>
        <source>{0} cannot be opened as netCDF ({1})</source>
        <translation>无法以 netCDF 打开 {0}（{1}）</translation>
    </message>
    <message>
        <source>{0} cannot be read</source>
        <translation>无法读取 {0}</translation>
    </message>
    <message>
        <source>{0} cannot be read any more</source>
        <translation>{0} 已无法读取</translation>
    </message>
    <message>
        <source>{0} cannot be read as XDMF: {1}</source>
        <translation>无法以 XDMF 读取 {0}：{1}</translation>
    </message>
    <message>
        <source>{0} cannot be read as a VTK grid: {1}</source>
        <translation>无法以 VTK 网格读取 {0}：{1}</translation>
    </message>
    <message>
        <source>{0} cannot be read from row {1} of {2} on: {3}</source>
        <translation>无法从第 {1} 行（共 {2} 行）起读取 {0}：{3}</translation>
    </message>
    <message>
        <source>{0} cannot be read: {1}</source>
        <translation>无法读取 {0}：{1}</translation>
    </message>
    <message>
        <source>{0} cannot be removed: {1}</source>
        <translation>无法删除 {0}：{1}</translation>
    </message>
    <message>
        <source>{0} cannot be written: {1}</source>
        <translation>无法写入 {0}：{1}</translation>
    </message>
    <message>
        <source>{0} clusters were hit hard enough to break up and were left whole: no room for more bodies</source>
        <translation>{0} 个聚类受到足以破碎的撞击，但保持完整：没有容纳更多刚体的余地</translation>
    </message>
    <message>
        <source>{0} covers x = {1} to {2}, y = {3} to {4} of the local frame; the structure stands at x = {5} to {6}, y = {7} to {8}</source>
        <translation>{0} 覆盖局部坐标框架的 x = {1} 至 {2}，y = {3} 至 {4}；结构位于 x = {5} 至 {6}，y = {7} 至 {8}</translation>
    </message>
    <message>
        <source>{0} does not say of which types its {1} elements are</source>
        <translation>{0} 未说明其 {1} 个单元的类型</translation>
    </message>
    <message>
        <source>{0} does not say what to convert to</source>
        <translation>{0} 未说明转换为何种格式</translation>
    </message>
    <message>
        <source>{0} does not say where its pixels lie</source>
        <translation>{0} 未说明其像素的位置</translation>
    </message>
    <message>
        <source>{0} earlier points scatter too much: it may be anything from {1} to {2}</source>
        <translation>{0} 个已有点过于分散：可能为 {1} 至 {2} 的任何值</translation>
    </message>
    <message>
        <source>{0} earlier points with the same settings but for numbers; {1} are needed</source>
        <translation>仅数值不同的已有点有 {0} 个；需要 {1} 个</translation>
    </message>
    <message>
        <source>{0} fragments are born at {1} instants: at the guide of {2} mean distances, which would give {3} clusters for one birth time, {4} clusters are counted. The published &quot;two to three&quot; mean distances do not carry over where few fragments share a birth</source>
        <translation>{0} 个碎块在 {1} 个时刻产生：按参考值 {2} 倍平均间距，若同一时刻产生应有 {3} 个聚类，实际统计 {4} 个。当同一时刻产生的碎块很少时，论文的“二至三”倍平均间距并不适用</translation>
    </message>
    <message>
        <source>{0} has a second section {1} before byte {2}</source>
        <translation>{0} 在字节 {2} 之前有第二个 {1} 段</translation>
    </message>
    <message>
        <source>{0} has become shorter since it was opened: it ends before byte {1}</source>
        <translation>{0} 打开后变短：在字节 {1} 之前结束</translation>
    </message>
    <message>
        <source>{0} has more elements than can be held</source>
        <translation>{0} 的单元数超过所能容纳</translation>
    </message>
    <message>
        <source>{0} has no cell array &quot;{1}&quot;</source>
        <translation>{0} 没有单元数组“{1}”</translation>
    </message>
    <message>
        <source>{0} has no complete state: a state takes {1} bytes, and {2} bytes follow the mesh</source>
        <translation>{0} 没有完整的状态：一个状态需 {1} 字节，网格之后仅有 {2} 字节</translation>
    </message>
    <message>
        <source>{0} has no element variable &quot;{1}&quot;</source>
        <translation>{0} 没有单元变量“{1}”</translation>
    </message>
    <message>
        <source>{0} has no health breaches: there is nothing to acknowledge</source>
        <translation>{0} 没有健康超限：没有可确认的内容</translation>
    </message>
    <message>
        <source>{0} has no height at all around the structure ({1} of {2} have none)</source>
        <translation>{0} 在结构周围没有任何高程（{2} 处中 {1} 处没有）</translation>
    </message>
    <message>
        <source>{0} has no height for {1} of {2} places around the structure</source>
        <translation>{0} 在结构周围 {2} 处中有 {1} 处没有高程</translation>
    </message>
    <message>
        <source>{0} has no nodal displacement under a known name</source>
        <translation>{0} 没有已知名称的节点位移</translation>
    </message>
    <message>
        <source>{0} has no nodal variables {1}_x, {1}_y and {1}_z in any spelling</source>
        <translation>{0} 没有任何拼写的节点变量 {1}_x、{1}_y 和 {1}_z</translation>
    </message>
    <message>
        <source>{0} has no nodes</source>
        <translation>{0} 没有节点</translation>
    </message>
    <message>
        <source>{0} has no part &quot;{1}&quot;</source>
        <translation>{0} 中没有部件“{1}”</translation>
    </message>
    <message>
        <source>{0} has no point array &quot;{1}&quot; with three components</source>
        <translation>{0} 没有三分量的点数组“{1}”</translation>
    </message>
    <message>
        <source>{0} has no solids, shells or beams</source>
        <translation>{0} 没有实体、壳或梁</translation>
    </message>
    <message>
        <source>{0} has no states: it is a mesh without results</source>
        <translation>{0} 没有状态：它是没有结果的网格</translation>
    </message>
    <message>
        <source>{0} has other elements than {1}: {2} of one kind, where there were {3}, or other numbers</source>
        <translation>{0} 的单元与 {1} 不同：某一类有 {2} 个，原为 {3} 个，或编号不同</translation>
    </message>
    <message>
        <source>{0} has {1} columns and {2} rows; a surface takes two of each</source>
        <translation>{0} 有 {1} 列 {2} 行；曲面至少各需两个</translation>
    </message>
    <message>
        <source>{0} has {1} coordinates a node instead of three</source>
        <translation>{0} 的节点有 {1} 个坐标，而不是三个</translation>
    </message>
    <message>
        <source>{0} has {1} dimensions; only solids, shells and beams in space make fragments</source>
        <translation>{0} 为 {1} 维；只有空间中的实体、壳和梁生成碎块</translation>
    </message>
    <message>
        <source>{0} has {1} nodes and {2} velocities; expected: {3} and {4}</source>
        <translation>{0} 有 {1} 个节点和 {2} 个速度；应为 {3} 和 {4}</translation>
    </message>
    <message>
        <source>{0} has {1} states of {2} elements, more than can be held</source>
        <translation>{0} 有 {2} 个单元的 {1} 个状态，超过所能容纳</translation>
    </message>
    <message>
        <source>{0} heights do not make a terrain of {1} by {2} nodes</source>
        <translation>{0} 个高程不能构成 {1} x {2} 个节点的地形</translation>
    </message>
    <message>
        <source>{0} heights such as {1} cannot be heights of land and were taken as gaps</source>
        <translation>{0} 个高程（例如 {1}）不可能是地面高程，按空缺处理</translation>
    </message>
    <message>
        <source>{0} holds colours or complex numbers, not heights</source>
        <translation>{0} 含颜色或复数，而不是高程</translation>
    </message>
    <message>
        <source>{0} holds no raster</source>
        <translation>{0} 不含栅格</translation>
    </message>
    <message>
        <source>{0} is JSON, but not a case of Rubble</source>
        <translation>{0} 是 JSON，但不是 Rubble 的案例</translation>
    </message>
    <message>
        <source>{0} is a VTK file, but no unstructured grid</source>
        <translation>{0} 是 VTK 文件，但不是非结构网格</translation>
    </message>
    <message>
        <source>{0} is a copy of version {1}; this program reads up to version {2}</source>
        <translation>{0} 是版本 {1} 的副本；本程序最高可读版本 {2}</translation>
    </message>
    <message>
        <source>{0} is a flat analysis: element {1} is of type {2}</source>
        <translation>{0} 为平面分析：单元 {1} 的类型为 {2}</translation>
    </message>
    <message>
        <source>{0} is a folder without an FE result</source>
        <translation>{0} 是没有有限元结果的文件夹</translation>
    </message>
    <message>
        <source>{0} is a run of version {1}; this program reads version {2}</source>
        <translation>{0} 是版本 {1} 的计算；本程序读取版本 {2}</translation>
    </message>
    <message>
        <source>{0} is active within the ballistic reach of the fragment of {1}</source>
        <translation>{0} 在 {1} 的碎块的弹道可达范围内处于激活状态</translation>
    </message>
    <message>
        <source>{0} is an HDF5 file, but not a run of Rubble</source>
        <translation>{0} 是 HDF5 文件，但不是 Rubble 的计算</translation>
    </message>
    <message>
        <source>{0} is an animation file of another version: it begins with {1}, {2} is read</source>
        <translation>{0} 是其他版本的动画文件：以 {1} 开头，可读取的是 {2}</translation>
    </message>
    <message>
        <source>{0} is cut off: it ends after {1} bytes, inside its header</source>
        <translation>{0} 被截断：在 {1} 字节后的文件头内结束</translation>
    </message>
    <message>
        <source>{0} is cut off: it ends after {1} of {2} bytes</source>
        <translation>{0} 被截断：共 {2} 字节，在 {1} 字节后结束</translation>
    </message>
    <message>
        <source>{0} is cut off: it ends after {1} of {2} bytes; the end of {3} is missing</source>
        <translation>{0} 被截断：共 {2} 字节，在 {1} 字节后结束；缺少 {3} 的末尾</translation>
    </message>
    <message>
        <source>{0} is cut off: it ends at byte {1} within {2}</source>
        <translation>{0} 被截断：在 {2} 内的字节 {1} 处结束</translation>
    </message>
    <message>
        <source>{0} is cut off: {1} take {2} bytes from byte {3} on, which the file does not have</source>
        <translation>{0} 被截断：{1} 从字节 {3} 起需 {2} 字节，文件没有</translation>
    </message>
    <message>
        <source>{0} is cut off: {1} take {2} bytes from {3} on, and {4} bytes are left</source>
        <translation>{0} 被截断：{1} 从 {3} 起需 {2} 字节，只剩 {4} 字节</translation>
    </message>
    <message>
        <source>{0} is cut off: {1} takes {2} bytes, the file has {3}</source>
        <translation>{0} 被截断：{1} 需 {2} 字节，文件有 {3} 字节</translation>
    </message>
    <message>
        <source>{0} is damaged so that the HDF5 library fails on it</source>
        <translation>{0} 已损坏，HDF5 库读取失败</translation>
    </message>
    <message>
        <source>{0} is damaged: {1}</source>
        <translation>{0} 已损坏：{1}</translation>
    </message>
    <message>
        <source>{0} is empty</source>
        <translation>{0} 为空</translation>
    </message>
    <message>
        <source>{0} is no Exodus II file: {1}</source>
        <translation>{0} 不是 Exodus II 文件：{1}</translation>
    </message>
    <message>
        <source>{0} is no FE result that can be read: it is {1}</source>
        <translation>{0} 不是可读取的有限元结果：它是{1}</translation>
    </message>
    <message>
        <source>{0} is no VTKHDF grid that can be read: {1}</source>
        <translation>{0} 不是可读取的 VTKHDF 网格：{1}</translation>
    </message>
    <message>
        <source>{0} is no d3plot any more</source>
        <translation>{0} 已不是 d3plot</translation>
    </message>
    <message>
        <source>{0} is no index of a VTK series: {1}</source>
        <translation>{0} 不是 VTK 序列的索引：{1}</translation>
    </message>
    <message>
        <source>{0} is no input deck: line {1} is no text</source>
        <translation>{0} 不是输入卡：第 {1} 行不是文本</translation>
    </message>
    <message>
        <source>{0} is no longer what it was when it was opened</source>
        <translation>{0} 打开后已被更改</translation>
    </message>
    <message>
        <source>{0} is no regular file</source>
        <translation>{0} 不是普通文件</translation>
    </message>
    <message>
        <source>{0} is no sound XML: {1} at byte {2}</source>
        <translation>{0} 不是正确的 XML：字节 {2} 处 {1}</translation>
    </message>
    <message>
        <source>{0} is no sound record of a simulated world: at byte {1} {2} were expected.</source>
        <translation>{0} 不是完好的模拟计算记录：字节 {1} 处应为 {2}。</translation>
    </message>
    <message>
        <source>{0} is no tolerance for the accuracy rate.</source>
        <translation>{0} 不能作为精度率的容差。</translation>
    </message>
    <message>
        <source>{0} is not a run file of Rubble, or is damaged: {1}</source>
        <translation>{0} 不是 Rubble 的计算文件，或已损坏：{1}</translation>
    </message>
    <message>
        <source>{0} is not complete: it has no outcome to acknowledge</source>
        <translation>{0} 不完整：没有可确认的结果</translation>
    </message>
    <message>
        <source>{0} is not complete: its run was stopped before the end</source>
        <translation>{0} 不完整：其计算在结束前停止</translation>
    </message>
    <message>
        <source>{0} is of version {1}; this program reads version {2}</source>
        <translation>{0} 为版本 {1}；本程序读取版本 {2}</translation>
    </message>
    <message>
        <source>{0} is there already</source>
        <translation>{0} 已存在</translation>
    </message>
    <message>
        <source>{0} is too large for a case</source>
        <translation>{0} 作为案例过大</translation>
    </message>
    <message>
        <source>{0} is too large for such a table</source>
        <translation>{0} 对这种表格来说过大</translation>
    </message>
    <message>
        <source>{0} is {1} of Ansys, whose sets are no states of a course of time</source>
        <translation>{0} 是 Ansys 的{1}，其各组不是随时间变化的状态</translation>
    </message>
    <message>
        <source>live structure that is released at the end of the FE result can fall on what stands (islands: {0}, by {1})</source>
        <translation>有限元结果结束时释放的未失效结构可能落在仍立着的部分上（孤立部分 {0} 个，重叠 {1}）</translation>
    </message>
    <message>
        <source>the engine moves loose structure, which can fall on what stands</source>
        <translation>松脱结构由引擎移动，可能落在仍立着的部分上</translation>
    </message>
    <message>
        <source>the engine moves loose structure, which can meet debris</source>
        <translation>松脱结构由引擎移动，可能遇到堆积物</translation>
    </message>
    <message>
        <source>live structure that is released at the end of the FE result can meet other bodies (islands: {0})</source>
        <translation>有限元结果结束时释放的未失效结构可能与其他刚体相遇（孤立部分 {0} 个）</translation>
    </message>
    <message>
        <source>Islands of live structure without a finite place, mass or inertia are held where they are</source>
        <translation>没有有限的位置、质量或惯量的未失效结构孤立部分固定于原处</translation>
    </message>
    <message>
        <source>{0} lie in one plane, which leaves the focal length open.</source>
        <translation>{0}位于同一平面，焦距无法确定。</translation>
    </message>
    <message>
        <source>{0} lie on one line: any camera around it would see them alike.</source>
        <translation>{0}位于一条直线上：其周围的任何相机所见相同。</translation>
    </message>
    <message>
        <source>Loose structure that is alive at the end is held where it is (islands: {0}, elements: {1})</source>
        <translation>结束时仍存活的松散结构固定于原处（孤立部分 {0} 个，单元 {1} 个）</translation>
    </message>
    <message>
        <source>{0} names the file {1}, which is not there</source>
        <translation>{0} 所指的文件 {1} 不存在</translation>
    </message>
    <message>
        <source>{0} of time are {1}</source>
        <translation>{0} 的时间为 {1}</translation>
    </message>
    <message>
        <source>{0} of {1} places of the terrain had no height and were filled from their neighbours</source>
        <translation>地形 {1} 处中有 {0} 处没有高程，由相邻处填补</translation>
    </message>
    <message>
        <source>{0} pairs are too few to find {1} numbers of a camera: it takes {2}.</source>
        <translation>{0} 对点太少，不能求出相机的 {1} 个参数：需要 {2} 对。</translation>
    </message>
    <message>
        <source>{0} says that its time is {1}</source>
        <translation>{0} 给出的时间为 {1}</translation>
    </message>
    <message>
        <source>{0} says what collapses, not how it is simulated: no reference holds for two values of it.</source>
        <translation>{0} 说明的是什么倒塌，而不是如何模拟：其两个取值没有共同的基准。</translation>
    </message>
    <message>
        <source>{0} steps were halved after health breaches</source>
        <translation>健康超限后有 {0} 步被减半</translation>
    </message>
    <message>
        <source>{0} times a body was held back: nothing that it touched could have made it that fast</source>
        <translation>刚体被限速 {0} 次：它接触的物体不可能使其达到如此速度</translation>
    </message>
    <message>
        <source>{0} was written by a newer Rubble: case version {1}, this program reads up to {2}</source>
        <translation>{0} 由更新版本的 Rubble 写出：案例版本 {1}，本程序最高可读 {2}</translation>
    </message>
    <message>
        <source>{0} would be written over {1}, which is read</source>
        <translation>{0} 将覆盖正在读取的 {1}</translation>
    </message>
    <message>
        <source>{0} would fit ({1}), and so would {2}</source>
        <translation>{0} 相符（{1}），{2} 也相符</translation>
    </message>
    <message>
        <source>{0} {1} is given twice.</source>
        <translation>{0} {1} 给出了两次。</translation>
    </message>
    <message>
        <source>{0} {1}, which cannot be read (word {2} is {3})</source>
        <translation>{0} {1}，无法读取（第 {2} 个字为 {3}）</translation>
    </message>
    <message>
        <source>{0}, line 1: there is no column {1}</source>
        <translation>{0} 第 1 行：没有列 {1}</translation>
    </message>
    <message>
        <source>{0}, line {1}, column {2} (byte {3}): {4}</source>
        <translation>{0} 第 {1} 行第 {2} 列（字节 {3}）：{4}</translation>
    </message>
    <message>
        <source>{0}, line {1}: there are more than {2} pairs</source>
        <translation>{0} 第 {1} 行：超过 {2} 对</translation>
    </message>
    <message>
        <source>{0}, line {1}: {2} is &quot;{3}&quot;, which is no number</source>
        <translation>{0} 第 {1} 行：{2} 为“{3}”，不是数值</translation>
    </message>
    <message>
        <source>{0}: &quot;{1}&quot; before byte {2} is no number; expected: {3}</source>
        <translation>{0}：字节 {2} 之前的“{1}”不是数值；应为：{3}</translation>
    </message>
    <message>
        <source>{0}: &quot;{1}&quot; before byte {2} is no section of such a file</source>
        <translation>{0}：字节 {2} 之前的“{1}”不是此类文件的段</translation>
    </message>
    <message>
        <source>{0}: a number is too large</source>
        <translation>{0}：某数值过大</translation>
    </message>
    <message>
        <source>{0}: a state would take more than {1} words; the files have {2}</source>
        <translation>{0}：一个状态需超过 {1} 个字；文件有 {2} 个</translation>
    </message>
    <message>
        <source>{0}: a view of version {1}; this program reads version {2}</source>
        <translation>{0}：版本 {1} 的视图；本程序读取版本 {2}</translation>
    </message>
    <message>
        <source>{0}: an element in the block before byte {1} uses node {2} of {3}</source>
        <translation>{0}：字节 {1} 之前的块中有单元使用节点 {2}（共 {3}）</translation>
    </message>
    <message>
        <source>{0}: at {1}: expected {2}, found {3}</source>
        <translation>{0}：在 {1}：应为 {2}，实为 {3}</translation>
    </message>
    <message>
        <source>{0}: at {1}: {2}</source>
        <translation>{0}：在 {1}：{2}</translation>
    </message>
    <message>
        <source>{0}: before byte {1} {2}</source>
        <translation>{0}：字节 {1} 之前 {2}</translation>
    </message>
    <message>
        <source>{0}: before byte {1}: {2}</source>
        <translation>{0}：字节 {1} 之前：{2}</translation>
    </message>
    <message>
        <source>{0}: byte {1} should be {2}, but there is {3}</source>
        <translation>{0}：字节 {1} 应为 {2}，实为 {3}</translation>
    </message>
    <message>
        <source>{0}: cannot read {1} ({2})</source>
        <translation>{0}：无法读取 {1}（{2}）</translation>
    </message>
    <message>
        <source>{0}: cell {1} at state {2} is a {3} of {4} points</source>
        <translation>{0}：状态 {2} 的单元格 {1} 为 {4} 个点的 {3}</translation>
    </message>
    <message>
        <source>{0}: cell {1} at state {2} uses point {3} of {4}</source>
        <translation>{0}：状态 {2} 的单元格 {1} 使用点 {3}（共 {4}）</translation>
    </message>
    <message>
        <source>{0}: dataset {1}: {2}</source>
        <translation>{0}：数据集 {1}：{2}</translation>
    </message>
    <message>
        <source>{0}: element {1} of &quot;{2}&quot; uses the node at place {3} of {4}</source>
        <translation>{0}：“{2}”的单元 {1} 使用位于 {3} 的节点（共 {4}）</translation>
    </message>
    <message>
        <source>{0}: element {1} of {2} in the block before byte {3} belongs to none of {4} parts</source>
        <translation>{0}：字节 {3} 之前的块中，单元 {1}（共 {2}）不属于 {4} 个部件中的任何一个</translation>
    </message>
    <message>
        <source>{0}: element {1} uses the node {2}, which is not there</source>
        <translation>{0}：单元 {1} 使用不存在的节点 {2}</translation>
    </message>
    <message>
        <source>{0}: frame {1} at {2} is damaged</source>
        <translation>{0}：{2} 的第 {1} 帧已损坏</translation>
    </message>
    <message>
        <source>{0}: line {1} has {2} fields, but the heading names {3}</source>
        <translation>{0}：第 {1} 行有 {2} 项，而标题行有 {3} 项</translation>
    </message>
    <message>
        <source>{0}: line {1} includes files in a circle</source>
        <translation>{0}：第 {1} 行循环包含文件</translation>
    </message>
    <message>
        <source>{0}: line {1} is no text</source>
        <translation>{0}：第 {1} 行不是文本</translation>
    </message>
    <message>
        <source>{0}: line {1} is not &quot;element,time&quot; or &quot;element,time,status&quot;: {2}</source>
        <translation>{0}：第 {1} 行不是“单元，时刻”或“单元，时刻，状态”：{2}</translation>
    </message>
    <message>
        <source>{0}: not a view in JSON, at character {1}: {2}</source>
        <translation>{0}：不是 JSON 视图，字符 {1} 处：{2}</translation>
    </message>
    <message>
        <source>{0}: number {1} of the {2} (after {3}) uses {4} {5} of {6}</source>
        <translation>{0}：{2}（{3} 之后）的第 {1} 个使用 {4} {5}（共 {6}）</translation>
    </message>
    <message>
        <source>{0}: numbers have commas and, in line {1}, points</source>
        <translation>{0}：数字使用逗号，而第 {1} 行使用小数点</translation>
    </message>
    <message>
        <source>{0}: state {1} has the time {2}; times must be finite and grow</source>
        <translation>{0}：状态 {1} 的时间为 {2}；时间必须有限且递增</translation>
    </message>
    <message>
        <source>{0}: state {1} has {2} nodes instead of the {3} it had when it was opened</source>
        <translation>{0}：状态 {1} 有 {2} 个节点，而打开时为 {3} 个</translation>
    </message>
    <message>
        <source>{0}: state {1} has {2} nodes instead of {3}, and no numbers that say which</source>
        <translation>{0}：状态 {1} 有 {2} 个节点，而不是 {3} 个，且没有说明是哪些的编号</translation>
    </message>
    <message>
        <source>{0}: state {1} has {2} offsets for {3} cells</source>
        <translation>{0}：状态 {1} 有 {2} 个偏移量，对应 {3} 个单元格</translation>
    </message>
    <message>
        <source>{0}: the attribute {1} is not a number</source>
        <translation>{0}：属性 {1} 不是数值</translation>
    </message>
    <message>
        <source>{0}: the blocks hold {1} elements, but the header says {2}</source>
        <translation>{0}：各块共有 {1} 个单元，而文件头为 {2} 个</translation>
    </message>
    <message>
        <source>{0}: the cell before byte {1} uses node {2} of {3}</source>
        <translation>{0}：字节 {1} 之前的单元格使用节点 {2}（共 {3}）</translation>
    </message>
    <message>
        <source>{0}: the header of the netCDF file makes no sense</source>
        <translation>{0}：netCDF 文件头没有意义</translation>
    </message>
    <message>
        <source>{0}: the key &quot;{1}&quot; stands twice in one object</source>
        <translation>{0}：键“{1}”在同一对象中出现两次</translation>
    </message>
    <message>
        <source>{0}: the length of the {1} before {2} is {3}; expected: 0 to {4}, the words of all files</source>
        <translation>{0}：{2} 之前的 {1} 长度为 {3}；应为：0 至 {4}，即全部文件的字数</translation>
    </message>
    <message>
        <source>{0}: the number of {1} before byte {2} is {3}; expected: 0 or more</source>
        <translation>{0}：字节 {2} 之前的 {1} 数为 {3}；应为：0 或更大</translation>
    </message>
    <message>
        <source>{0}: the number of {1} before byte {2} is {3}; expected: 0 to {4}, what the file can hold</source>
        <translation>{0}：字节 {2} 之前的 {1} 数为 {3}；应为：0 至 {4}，即文件所能容纳</translation>
    </message>
    <message>
        <source>{0}: the record at byte {1} is compressed</source>
        <translation>{0}：字节 {1} 处的记录经过压缩</translation>
    </message>
    <message>
        <source>{0}: the record at byte {1} {2}</source>
        <translation>{0}：字节 {1} 处的记录 {2}</translation>
    </message>
    <message>
        <source>{0}: the structure of the file cannot be read ({1})</source>
        <translation>{0}：无法读取文件结构（{1}）</translation>
    </message>
    <message>
        <source>{0}: the table {1} cannot be read: {2}</source>
        <translation>{0}：无法读取表 {1}：{2}</translation>
    </message>
    <message>
        <source>{0}: the time of state {1} is {2}</source>
        <translation>{0}：状态 {1} 的时间为 {2}</translation>
    </message>
    <message>
        <source>{0}: the time of the state is {1}</source>
        <translation>{0}：该状态的时间为 {1}</translation>
    </message>
    <message>
        <source>{0}: the type of a cell before byte {1} is {2}; expected: 1, 3, 5, 9, 10 or 12</source>
        <translation>{0}：字节 {1} 之前的单元格类型为 {2}；应为：1、3、5、9、10 或 12</translation>
    </message>
    <message>
        <source>{0}: the view&apos;s {1}</source>
        <translation>{0}：视图的 {1}</translation>
    </message>
    <message>
        <source>{0}: two blocks have the number {1}</source>
        <translation>{0}：两个单元块编号均为 {1}</translation>
    </message>
    <message>
        <source>{0}: two elements of state {1} cannot be told apart (entry {2})</source>
        <translation>{0}：状态 {1} 的两个单元无法区分（条目 {2}）</translation>
    </message>
    <message>
        <source>{0}: {1} (word {2}, {3}) is {4}; expected: {5}</source>
        <translation>{0}：{1}（第 {2} 个字，{3}）为 {4}；应为：{5}</translation>
    </message>
    <message>
        <source>{0}: {1} at state {2} has {3} values and ends before cell {4}</source>
        <translation>{0}：状态 {2} 的 {1} 有 {3} 个值，在单元格 {4} 之前结束</translation>
    </message>
    <message>
        <source>{0}: {1} at state {2} has {3} values for {4} elements</source>
        <translation>{0}：状态 {2} 的 {1} 有 {3} 个值，对应 {4} 个单元</translation>
    </message>
    <message>
        <source>{0}: {1} at state {2} has {3} values instead of {4}</source>
        <translation>{0}：状态 {2} 的 {1} 有 {3} 个值，而不是 {4} 个</translation>
    </message>
    <message>
        <source>{0}: {1} before byte {2}: {3}; expected: {4}</source>
        <translation>{0}：字节 {2} 之前的 {1}：{3}；应为：{4}</translation>
    </message>
    <message>
        <source>{0}: {1} comes back to life, which revival = refuse forbids</source>
        <translation>{0}：{1} 复活，而 revival = refuse 不允许</translation>
    </message>
    <message>
        <source>{0}: {1} does not have the shape that the counts of the file give it</source>
        <translation>{0}：{1} 的形状与文件的计数不符</translation>
    </message>
    <message>
        <source>{0}: {1} does not hold numbers</source>
        <translation>{0}：{1} 不含数值</translation>
    </message>
    <message>
        <source>{0}: {1} does not say of which type its elements are</source>
        <translation>{0}：{1} 未说明其单元的类型</translation>
    </message>
    <message>
        <source>{0}: {1} is {2}, more than the file can hold</source>
        <translation>{0}：{1} 为 {2}，超过文件所能容纳</translation>
    </message>
    <message>
        <source>{0}: {1} lies at ({2}, {3}, {4})</source>
        <translation>{0}：{1} 位于 ({2}, {3}, {4})</translation>
    </message>
    <message>
        <source>{0}: {1} of node {2} at state {3} is ({4}, {5}, {6})</source>
        <translation>{0}：状态 {3} 节点 {2} 的 {1} 为 ({4}, {5}, {6})</translation>
    </message>
    <message>
        <source>{0}: {1} shells are said to be rigid, of {2}</source>
        <translation>{0}：称有 {1} 个刚性壳，共 {2} 个</translation>
    </message>
    <message>
        <source>element {0} ({1}) at state {2}</source>
        <translation>状态 {2} 的单元 {0}（{1}）</translation>
    </message>
    <message>
        <source>element {0} ({1})</source>
        <translation>单元 {0}（{1}）</translation>
    </message>
    <message>
        <source>element {0} of type {1}</source>
        <translation>类型为 {1} 的单元 {0}</translation>
    </message>
    <message>
        <source>element {0} at state {1}: {2}</source>
        <translation>状态 {1} 的单元 {0}：{2}</translation>
    </message>
    <message>
        <source>element {0}</source>
        <translation>单元 {0}</translation>
    </message>
    <message>
        <source>node {0}</source>
        <translation>节点 {0}</translation>
    </message>
    <message>
        <source>body {0}</source>
        <translation>刚体 {0}</translation>
    </message>
    <message>
        <source>the fragment of {0}</source>
        <translation>{0} 的碎块</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>实体</translation>
    </message>
    <message>
        <source>shell</source>
        <translation>壳</translation>
    </message>
    <message>
        <source>beam</source>
        <translation>梁</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>混合</translation>
    </message>
    <message>
        <source>{0}, {1} is active ({2})</source>
        <translation>{0}，{1} 为激活（{2}）</translation>
    </message>
    <message>
        <source>{0}, {1} is active</source>
        <translation>{0}，{1} 为激活</translation>
    </message>
    <message>
        <source>{0} ({1}), up is {2} ({3})</source>
        <translation>{0}（{1}），竖直轴为 {2}（{3}）</translation>
    </message>
    <message>
        <source>{0} of {1} active at the first state</source>
        <translation>初始状态 {1} 个中 {0} 个激活</translation>
    </message>
    <message>
        <source>Comparing with what the case was made with</source>
        <translation>正在与案例建立时的文件核对</translation>
    </message>
    <message>
        <source>Open the case that it belongs to.</source>
        <translation>请打开其所属的案例。</translation>
    </message>
    <message>
        <source>Opening the run</source>
        <translation>正在打开计算</translation>
    </message>
    <message>
        <source>{0} was made from another FE result than the one that is open</source>
        <translation>{0} 来自与当前打开的不同的有限元结果</translation>
    </message>
    <message>
        <source>Check the name and the permissions.</source>
        <translation>请检查名称和权限。</translation>
    </message>
    <message>
        <source>Following a fragment</source>
        <translation>正在跟随碎块</translation>
    </message>
    <message>
        <source>Views (*.json)</source>
        <translation>视图 (*.json)</translation>
    </message>
    <message>
        <source>a direction of some length</source>
        <translation>具有一定长度的方向</translation>
    </message>
    <message>
        <source>A part of it may be missing; copy it anew from where it came.</source>
        <translation>可能缺少一部分；请从来源处重新复制。</translation>
    </message>
    <message>
        <source>Copy the photograph anew from where it came, or save it again as JPEG.</source>
        <translation>请从来源处重新复制照片，或另存为 JPEG。</translation>
    </message>
    <message>
        <source>Correct the time of the photograph, or simulate on to it.</source>
        <translation>请更正照片的时刻，或继续模拟到该时刻。</translation>
    </message>
    <message>
        <source>Draw around the debris that the photograph shows.</source>
        <translation>请沿照片所示堆积物画出轮廓。</translation>
    </message>
    <message>
        <source>Draw less of it as hidden or moved, or check the outline.</source>
        <translation>请减少画为遮挡或已移动的部分，或检查轮廓。</translation>
    </message>
    <message>
        <source>Give a picture of 16 to 100,000 pixels on each side.</source>
        <translation>请给出每边 16 至 100,000 像素的图片。</translation>
    </message>
    <message>
        <source>Let the principal point be found, or take the photograph as it came from the camera.</source>
        <translation>请由程序求主点，或采用相机原始照片。</translation>
    </message>
    <message>
        <source>Neither drawn nor simulated debris lies in what counts of this photograph.</source>
        <translation>此照片有效范围内既没有画出的也没有模拟的堆积物。</translation>
    </message>
    <message>
        <source>No outline of the debris is drawn on the photograph.</source>
        <translation>照片上未画出堆积物的轮廓。</translation>
    </message>
    <message>
        <source>Nothing is simulated yet, so there is no debris to see.</source>
        <translation>尚未模拟，因此看不到堆积物。</translation>
    </message>
    <message>
        <source>Put the file back, or add it as another photograph.</source>
        <translation>请放回该文件，或将其添加为另一张照片。</translation>
    </message>
    <message>
        <source>Simulate the case first.</source>
        <translation>请先模拟该案例。</translation>
    </message>
    <message>
        <source>The focal length is found from the point pairs; set the time by hand.</source>
        <translation>焦距由点对求得；请手动设置时刻。</translation>
    </message>
    <message>
        <source>The photograph as it came from the camera shows more.</source>
        <translation>相机原始照片显示得更多。</translation>
    </message>
    <message>
        <source>The photograph has {0} x {1} pixels, the camera recorded {2} x {3}: it is cropped.</source>
        <translation>照片为 {0} x {1} 像素，相机记录为 {2} x {3}：已被裁剪。</translation>
    </message>
    <message>
        <source>The photograph has {0} x {1} pixels, the camera recorded {2} x {3}: it was made smaller or larger.</source>
        <translation>照片为 {0} x {1} 像素，相机记录为 {2} x {3}：已被缩放。</translation>
    </message>
    <message>
        <source>The photograph is damaged: {0}</source>
        <translation>照片已损坏：{0}</translation>
    </message>
    <message>
        <source>The photograph is of {0}, but the run goes from {1} to {2}.</source>
        <translation>照片的时刻为 {0}，但计算范围为 {1} 至 {2}。</translation>
    </message>
    <message>
        <source>The photograph says nothing of its camera, time and place.</source>
        <translation>照片没有相机、时间和位置的信息。</translation>
    </message>
    <message>
        <source>The photograph {0} is another file than the case names.</source>
        <translation>照片 {0} 与案例所指的文件不同。</translation>
    </message>
    <message>
        <source>The pixels of {0} cannot be read: {1}</source>
        <translation>无法读取 {0} 的像素：{1}</translation>
    </message>
    <message>
        <source>The silhouettes overlap by {0} ± {1}; their edges are {2} ± {3} apart in the mean, {4} from the camera.</source>
        <translation>剪影重合度为 {0} ± {1}；其边缘平均相距 {2} ± {3}（距相机 {4} 处）。</translation>
    </message>
    <message>
        <source>The silhouettes overlap by {0} ± {1}; there are no two edges to compare.</source>
        <translation>剪影重合度为 {0} ± {1}；没有可比较的两条边缘。</translation>
    </message>
    <message>
        <source>a focal length above zero</source>
        <translation>大于零的焦距</translation>
    </message>
    <message>
        <source>a number of seconds, not below zero</source>
        <translation>不小于零的秒数</translation>
    </message>
    <message>
        <source>debris, moved, hidden or not_debris</source>
        <translation>debris、moved、hidden 或 not_debris</translation>
    </message>
    <message>
        <source>it must name a photograph among the inputs that no other names</source>
        <translation>必须指向输入中未被其他项使用的照片</translation>
    </message>
    <message>
        <source>three corners or more</source>
        <translation>三个或更多角点</translation>
    </message>
    <message>
        <source>two numbers</source>
        <translation>两个数值</translation>
    </message>
    <message>
        <source>width and height</source>
        <translation>宽度和高度</translation>
    </message>
    <message>
        <source>{0} has {1} x {2} pixels, which is no photograph that could be matched</source>
        <translation>{0} 为 {1} x {2} 像素，不是可以匹配的照片</translation>
    </message>
    <message>
        <source>{0} is no photograph that can be read: {1}</source>
        <translation>{0} 不是可读取的照片：{1}</translation>
    </message>
    <message>
        <source>Move it away, or put a good copy in its place.</source>
        <translation>请将其移走，或换上完好的副本。</translation>
    </message>
    <message>
        <source>Use the Rubble that wrote it, or move it away.</source>
        <translation>请使用写出它的 Rubble 版本，或将其移走。</translation>
    </message>
    <message>
        <source>{0} has {1} bytes; a file of format {2} has {3} at most</source>
        <translation>{0} 有 {1} 字节；格式 {2} 的文件最多 {3} 字节</translation>
    </message>
    <message>
        <source>free nodes fall at {0} in the file, {1} m/s2</source>
        <translation>自由节点在文件中以 {0} 下落，即 {1} m/s2</translation>
    </message>
    <message>
        <source>what comes down gathers speed at {0} in the file, {1} m/s2</source>
        <translation>坍落部分在文件中以 {0} 加速，即 {1} m/s2</translation>
    </message>
    <message>
        <source>what comes down gathers speed at {0}, which is {1}</source>
        <translation>坍落部分以 {0} 加速，即 {1}</translation>
    </message>
    <message>
        <source>what comes down gathers speed along {0}</source>
        <translation>坍落部分沿 {0} 加速</translation>
    </message>
    <message>
        <source>A member could not be kept for a second start.</source>
        <translation>一个成员未能保留以备再次启动。</translation>
    </message>
    <message>
        <source>A member of the ensemble could not be simulated.</source>
        <translation>系综的一个成员无法模拟。</translation>
    </message>
    <message>
        <source>A movie from {0} to {1} with {2} pictures per second at {3} times the pace of the collapse cannot be made</source>
        <translation>无法制作从 {0} 到 {1}、每秒 {2} 张图片、为倒塌速度 {3} 倍的动画</translation>
    </message>
    <message>
        <source>A setting of the survey comparison is no size</source>
        <translation>测绘比较的某项设置不是有效尺寸</translation>
    </message>
    <message>
        <source>Accounting for every death</source>
        <translation>正在清点每次失效</translation>
    </message>
    <message>
        <source>Add points, three or more so that a wrong one shows.</source>
        <translation>请添加控制点，三个或更多才能看出错误的点。</translation>
    </message>
    <message>
        <source>An MP4 needs the program ffmpeg, which is not installed</source>
        <translation>MP4 需要程序 ffmpeg,但它未安装</translation>
    </message>
    <message>
        <source>An ensemble of {0} members with seed {1} cannot be made.</source>
        <translation>无法建立含 {0} 个成员、种子为 {1} 的系综。</translation>
    </message>
    <message>
        <source>An outline has no heights that could be laid on the ground</source>
        <translation>轮廓没有可与地面配准的高程</translation>
    </message>
    <message>
        <source>Binary glTF (*.glb)</source>
        <translation>二进制 glTF (*.glb)</translation>
    </message>
    <message>
        <source>CONNECTIVITY should follow OFFSETS</source>
        <translation>OFFSETS 之后应为 CONNECTIVITY</translation>
    </message>
    <message>
        <source>Cells of {0} are no size</source>
        <translation>{0} 不是有效的单元尺寸</translation>
    </message>
    <message>
        <source>Check the coordinate systems of survey and case, the origin of the frame and the control points.</source>
        <translation>请检查测绘与案例的坐标系、坐标框架原点以及控制点。</translation>
    </message>
    <message>
        <source>Check the coordinate systems of the outline and of the case.</source>
        <translation>请检查轮廓和案例的坐标系。</translation>
    </message>
    <message>
        <source>Check the path, or copy the file again.</source>
        <translation>请检查路径，或重新复制文件。</translation>
    </message>
    <message>
        <source>Check the path, or leave the mesh out.</source>
        <translation>请检查路径，或不使用该网格。</translation>
    </message>
    <message>
        <source>Check the path, or leave the orthophoto out.</source>
        <translation>请检查路径，或不使用正射影像。</translation>
    </message>
    <message>
        <source>Check their coordinate system and that of the case, or choose smaller cells.</source>
        <translation>请检查其坐标系与案例的坐标系，或选用更小的单元格。</translation>
    </message>
    <message>
        <source>Check what its heights are measured from: height= is above the ground, surface= in the heights of the case.</source>
        <translation>请检查其高度的起算面：height= 为地面以上，surface= 为案例的高程。</translation>
    </message>
    <message>
        <source>Checking that nothing is stale</source>
        <translation>正在检查有无过时内容</translation>
    </message>
    <message>
        <source>Choose a folder that you may write to.</source>
        <translation>请选择可以写入的文件夹。</translation>
    </message>
    <message>
        <source>Choose a run in which elements were deactivated.</source>
        <translation>请选择有单元失效的计算。</translation>
    </message>
    <message>
        <source>Choose an empty folder, or a new one.</source>
        <translation>请选择空文件夹或新文件夹。</translation>
    </message>
    <message>
        <source>Choose cells of 0.05 m or more.</source>
        <translation>请选择 0.05 m 或更大的单元。</translation>
    </message>
    <message>
        <source>Choose larger cells, or cut the survey to the site.</source>
        <translation>请选择更大的单元，或将测绘数据裁剪到场地范围。</translation>
    </message>
    <message>
        <source>Choose points as far apart as the site allows.</source>
        <translation>请在场地允许的范围内选择相距尽可能远的点。</translation>
    </message>
    <message>
        <source>Drawing the figure</source>
        <translation>正在绘制插图</translation>
    </message>
    <message>
        <source>Drawing the figures</source>
        <translation>正在绘制各图</translation>
    </message>
    <message>
        <source>Drawing the movie: picture {0} of {1}</source>
        <translation>正在绘制动画：第 {0} 张，共 {1} 张</translation>
    </message>
    <message>
        <source>ESRI Shapefile</source>
        <translation>ESRI Shapefile</translation>
    </message>
    <message>
        <source>Endings: .png, .svg, .pdf.</source>
        <translation>扩展名：.png、.svg、.pdf。</translation>
    </message>
    <message>
        <source>FE result of the case</source>
        <translation>案例的有限元结果</translation>
    </message>
    <message>
        <source>Figures (*.png *.svg *.pdf)</source>
        <translation>插图 (*.png *.svg *.pdf)</translation>
    </message>
    <message>
        <source>Finding the case of the figure</source>
        <translation>正在查找该图的案例</translation>
    </message>
    <message>
        <source>Give a picture of the ground with its place: GeoTIFF, JPEG 2000, or JPEG or PNG with a world file.</source>
        <translation>请提供带位置的地面影像：GeoTIFF、JPEG 2000，或带坐标文件的 JPEG 或 PNG。</translation>
    </message>
    <message>
        <source>Give a raster with finer cells, or one that covers more of the site.</source>
        <translation>请提供单元更细或覆盖更多场地的栅格。</translation>
    </message>
    <message>
        <source>Give an orthophoto: three bands, or one of bytes.</source>
        <translation>请提供正射影像：三个波段，或一个字节型波段。</translation>
    </message>
    <message>
        <source>Give it a place with gdal_translate -a_ullr.</source>
        <translation>请用 gdal_translate -a_ullr 指定其位置。</translation>
    </message>
    <message>
        <source>Give it coordinates in metres, or remove it.</source>
        <translation>请以米为单位给出坐标，或删除该点。</translation>
    </message>
    <message>
        <source>Give lengths in metres, not below zero, and 1 to 360 sectors.</source>
        <translation>长度以米为单位且不小于零，扇区为 1 到 360 个。</translation>
    </message>
    <message>
        <source>Give the case a projected system in metres, such as EPSG:25832.</source>
        <translation>请为案例指定以米为单位的投影坐标系，如 EPSG:25832。</translation>
    </message>
    <message>
        <source>Give the case the coordinate system of its site, such as EPSG:25832.</source>
        <translation>请为案例指定场地坐标系，如 EPSG:25832。</translation>
    </message>
    <message>
        <source>Give the case the coordinate system of its site, such as EPSG:25832: the raster is then projected to it.</source>
        <translation>请为案例指定场地坐标系，如 EPSG:25832：栅格将投影到该坐标系。</translation>
    </message>
    <message>
        <source>Give the outline of the debris as one or more polygons.</source>
        <translation>请以一个或多个多边形给出堆积物轮廓。</translation>
    </message>
    <message>
        <source>Give three, such as 0.25, 0.5 and 1 m.</source>
        <translation>请给出三个，例如 0.25、0.5 和 1 m。</translation>
    </message>
    <message>
        <source>Height, median</source>
        <translation>高度，中位数</translation>
    </message>
    <message>
        <source>Heights that a map has the probability of must be ascending, and none below zero.</source>
        <translation>概率图的各高度必须递增，且不得小于零。</translation>
    </message>
    <message>
        <source>Highest cell</source>
        <translation>最高单元格</translation>
    </message>
    <message>
        <source>Install the package ffmpeg, or name a folder instead of an MP4: it gets the pictures, numbered.</source>
        <translation>请安装软件包 ffmpeg,或指定文件夹代替 MP4:其中将写入编号图片。</translation>
    </message>
    <message>
        <source>Leave one of the two out.</source>
        <translation>请去掉其中一个。</translation>
    </message>
    <message>
        <source>Lower the least height, or compare without registration.</source>
        <translation>请降低最小高度，或不经配准直接比较。</translation>
    </message>
    <message>
        <source>Make a scenario for each and vary scenario.</source>
        <translation>请为每种情况建立一个方案，并让 scenario 变化。</translation>
    </message>
    <message>
        <source>Make both with the same cells, instant and counting of fallen structure.</source>
        <translation>请用相同的单元格、时刻以及坠落结构的计入方式建立两者。</translation>
    </message>
    <message>
        <source>Make it simpler, to 5,000,000 triangles or fewer.</source>
        <translation>请简化到 5,000,000 个三角形或更少。</translation>
    </message>
    <message>
        <source>Make room, choose another folder, or write a folder of pictures instead of an MP4.</source>
        <translation>请腾出空间、换一个文件夹，或写成图片文件夹而不是 MP4。</translation>
    </message>
    <message>
        <source>Make the mesh simpler, or cut it to the site.</source>
        <translation>请简化网格，或裁剪到场地范围。</translation>
    </message>
    <message>
        <source>Mass per area, 5 % quantile</source>
        <translation>单位面积质量，5 % 分位数</translation>
    </message>
    <message>
        <source>Mass per area, 95 % quantile</source>
        <translation>单位面积质量，95 % 分位数</translation>
    </message>
    <message>
        <source>Mass per area, median</source>
        <translation>单位面积质量，中位数</translation>
    </message>
    <message>
        <source>Mass that fell</source>
        <translation>落下的质量</translation>
    </message>
    <message>
        <source>Mean height of fragments</source>
        <translation>碎块平均高度</translation>
    </message>
    <message>
        <source>Measuring the debris</source>
        <translation>正在测量堆积物</translation>
    </message>
    <message>
        <source>Members go from 1 to 10,000, seeds from 0 to 4,294,967,295.</source>
        <translation>成员数为 1 至 10,000，种子为 0 至 4,294,967,295。</translation>
    </message>
    <message>
        <source>Movies (*.mp4)</source>
        <translation>动画 (*.mp4)</translation>
    </message>
    <message>
        <source>Name as many, in seconds on the file&apos;s clock.</source>
        <translation>请按该数目给出时刻，单位为秒，按文件的时钟。</translation>
    </message>
    <message>
        <source>Name one of its scenarios.</source>
        <translation>请指明其中一个方案。</translation>
    </message>
    <message>
        <source>Name scenarios of the case by their ids.</source>
        <translation>请用案例中方案的标识来指明。</translation>
    </message>
    <message>
        <source>Neither the survey nor the simulation has debris to fit to</source>
        <translation>测绘和模拟都没有可供配准的堆积物</translation>
    </message>
    <message>
        <source>No hypothesis has a member that can be held against the evidence.</source>
        <translation>没有任何假设的成员可与证据比较。</translation>
    </message>
    <message>
        <source>No member of the ensemble is there: there is nothing to map.</source>
        <translation>系综还没有任何成员：无图可绘。</translation>
    </message>
    <message>
        <source>No report is made of {0}, which is stale: {1}</source>
        <translation>{0} 已过时，不生成报告：{1}</translation>
    </message>
    <message>
        <source>Open the case itself.</source>
        <translation>请直接打开案例。</translation>
    </message>
    <message>
        <source>Points, three numbers each,</source>
        <translation>每个点三个数的 Points</translation>
    </message>
    <message>
        <source>Probability above the first height</source>
        <translation>高于第一高度的概率</translation>
    </message>
    <message>
        <source>Probability above the second height</source>
        <translation>高于第二高度的概率</translation>
    </message>
    <message>
        <source>Probability above the third height</source>
        <translation>高于第三高度的概率</translation>
    </message>
    <message>
        <source>Probability of debris</source>
        <translation>碎块出现概率</translation>
    </message>
    <message>
        <source>Probability of debris higher than {0}</source>
        <translation>碎块高于 {0} 的概率</translation>
    </message>
    <message>
        <source>Project the outline to the system of the case first.</source>
        <translation>请先将轮廓投影到案例坐标系。</translation>
    </message>
    <message>
        <source>Put the figure beside its case, or open the case first.</source>
        <translation>请把图放在其案例旁边，或先打开案例。</translation>
    </message>
    <message>
        <source>Register it to the debris, or not at all.</source>
        <translation>请配准到堆积物，或不配准。</translation>
    </message>
    <message>
        <source>Rename the run file, or put the XDMF file beside it.</source>
        <translation>请重命名计算文件，或将 XDMF 文件放在其旁边。</translation>
    </message>
    <message>
        <source>Resample it to square cells with gdalwarp.</source>
        <translation>请用 gdalwarp 重采样为方形单元。</translation>
    </message>
    <message>
        <source>Run-out of 95 % of the mass</source>
        <translation>95 % 质量的散落距离</translation>
    </message>
    <message>
        <source>Set up_axis={0} unless something else drives them.</source>
        <translation>若没有别的作用推动它们，请设置 up_axis={0}。</translation>
    </message>
    <message>
        <source>Simplify the outline.</source>
        <translation>请简化轮廓。</translation>
    </message>
    <message>
        <source>Simulate again with the settings and inputs of now, or report the case as it was.</source>
        <translation>请用现在的设置和输入重新模拟，或按当时的案例报告。</translation>
    </message>
    <message>
        <source>Simulate the ensemble first.</source>
        <translation>请先模拟系综。</translation>
    </message>
    <message>
        <source>Simulate their ensembles, and give evidence.</source>
        <translation>请模拟各假设的系综，并给出证据。</translation>
    </message>
    <message>
        <source>Simulating the run again, and its repeats</source>
        <translation>正在重新模拟该计算及其重复计算</translation>
    </message>
    <message>
        <source>Speaks for &quot;{0}&quot; (above 0) or for &quot;{1}&quot; (below 0)</source>
        <translation>支持 “{0}”（大于 0）或 “{1}”（小于 0）</translation>
    </message>
    <message>
        <source>Standard error of the probability</source>
        <translation>概率的标准误差</translation>
    </message>
    <message>
        <source>Survey and debris take {0} by {1} cells of {2}</source>
        <translation>测绘与堆积物需要 {0} × {1} 个 {2} 的单元</translation>
    </message>
    <message>
        <source>Take a survey with ground around the debris, or compare without registration.</source>
        <translation>请使用包含堆积物周围地面的测绘，或不经配准直接比较。</translation>
    </message>
    <message>
        <source>Take the file as it was exported, or export it again.</source>
        <translation>请使用导出时的原文件，或重新导出。</translation>
    </message>
    <message>
        <source>Testing this machine</source>
        <translation>正在测试本机</translation>
    </message>
    <message>
        <source>The case has no scenario &quot;{0}&quot;</source>
        <translation>案例中没有方案“{0}”</translation>
    </message>
    <message>
        <source>The case of {0} was not found: neither {1} nor a case beside it stands on the FE result {2} with the SHA-256 {3}.</source>
        <translation>未找到 {0} 的案例：{1} 以及旁边的案例都不基于 SHA-256 为 {3} 的有限元结果 {2}。</translation>
    </message>
    <message>
        <source>The control point &quot;{0}&quot; has a coordinate that is no number</source>
        <translation>控制点“{0}”有一个坐标不是数值</translation>
    </message>
    <message>
        <source>The control points lie in one place in plan</source>
        <translation>控制点在平面上位于同一处</translation>
    </message>
    <message>
        <source>The ensembles of &quot;{0}&quot; and &quot;{1}&quot; are not mapped alike.</source>
        <translation>“{0}” 与 “{1}” 的系综制图方式不同。</translation>
    </message>
    <message>
        <source>The folder {0} cannot be made</source>
        <translation>无法创建文件夹 {0}</translation>
    </message>
    <message>
        <source>The pixels of {0} have no size</source>
        <translation>{0} 的像素没有尺寸</translation>
    </message>
    <message>
        <source>The raster has no place at the site in the system of the case</source>
        <translation>栅格在案例坐标系的场地处没有位置</translation>
    </message>
    <message>
        <source>The survey covers no cell of the site</source>
        <translation>测绘数据未覆盖场地的任何单元</translation>
    </message>
    <message>
        <source>The survey shows only {0} cells of ground beside the debris</source>
        <translation>测绘在堆积物旁仅有 {0} 个地面单元</translation>
    </message>
    <message>
        <source>There is no evidence to hold the hypotheses against.</source>
        <translation>没有可用来检验假设的证据。</translation>
    </message>
    <message>
        <source>There is no mesh of surroundings {0} that may be read</source>
        <translation>没有可读取的周边网格 {0}</translation>
    </message>
    <message>
        <source>There is no orthophoto {0}</source>
        <translation>没有正射影像 {0}</translation>
    </message>
    <message>
        <source>There is no scenario &quot;{0}&quot; to vary.</source>
        <translation>没有可供变化的方案“{0}”。</translation>
    </message>
    <message>
        <source>There is no survey {0}, or it is empty</source>
        <translation>没有测绘 {0}，或文件为空</translation>
    </message>
    <message>
        <source>There is no way from the system &quot;{0}&quot; of {1} to &quot;{2}&quot; of the case</source>
        <translation>无法从 {1} 的坐标系“{0}”转换到案例的“{2}”</translation>
    </message>
    <message>
        <source>There is no way from the system of {0} to that of the case</source>
        <translation>无法从 {0} 的坐标系转换到案例坐标系</translation>
    </message>
    <message>
        <source>There is only &quot;{0}&quot;: nothing to tell it from.</source>
        <translation>只有 “{0}”：没有可与之区分的假设。</translation>
    </message>
    <message>
        <source>Things would fall at {0}</source>
        <translation>下落的加速度将是 {0}</translation>
    </message>
    <message>
        <source>This arrangement shows {0} instants, not {1}</source>
        <translation>此排版显示 {0} 个时刻，而不是 {1} 个</translation>
    </message>
    <message>
        <source>This evidence cannot tell &quot;{0}&quot; from &quot;{1}&quot;: &quot;{0}&quot; is closest, but not surely.</source>
        <translation>该证据无法区分 “{0}” 与 “{1}”：“{0}” 最接近，但并不确定。</translation>
    </message>
    <message>
        <source>Up was taken to be {0}, but {1}</source>
        <translation>朝上的轴取为 {0}，但{1}</translation>
    </message>
    <message>
        <source>Use clusters (multiple), or export the series for ParaView.</source>
        <translation>请使用聚类（multiple），或导出供 ParaView 使用的序列。</translation>
    </message>
    <message>
        <source>Vary more of what is not known, look for other causes, and check the place of the evidence.</source>
        <translation>请让更多未知量变化，寻找其他原因，并检查证据的位置。</translation>
    </message>
    <message>
        <source>Volume of the pile</source>
        <translation>堆积体体积</translation>
    </message>
    <message>
        <source>Weighing what speaks for the units</source>
        <translation>正在权衡单位的依据</translation>
    </message>
    <message>
        <source>What tells the causes apart</source>
        <translation>区分各原因之处</translation>
    </message>
    <message>
        <source>a mean and a standard deviation above zero</source>
        <translation>一个平均值和一个大于零的标准差</translation>
    </message>
    <message>
        <source>a table of colours</source>
        <translation>颜色表</translation>
    </message>
    <message>
        <source>above 0 the cell speaks for the first hypothesis, below 0 for the second: logarithm of the ratio of their probabilities</source>
        <translation>大于 0 支持第一个假设，小于 0 支持第二个：两者概率之比的对数</translation>
    </message>
    <message>
        <source>add a terrain; a level one will do</source>
        <translation>请添加地形；水平的也可以</translation>
    </message>
    <message>
        <source>another parameter: every member has a seed of its own</source>
        <translation>另一个参数：每个成员都有自己的种子</translation>
    </message>
    <message>
        <source>application/json</source>
        <translation>application/json</translation>
    </message>
    <message>
        <source>became shorter while it was read</source>
        <translation>在读取时变短了</translation>
    </message>
    <message>
        <source>corners of cells</source>
        <translation>单元角点数</translation>
    </message>
    <message>
        <source>cut the raster to the site if finer heights are needed there</source>
        <translation>若需要更细的高程，请将栅格裁剪到场地范围</translation>
    </message>
    <message>
        <source>debris cannot fall on the surroundings: the case has no terrain that they could be part of</source>
        <translation>堆积物无法落在周边上：案例没有可纳入它们的地形</translation>
    </message>
    <message>
        <source>fe, terrain, photograph, survey, orthophoto or surroundings</source>
        <translation>fe、terrain、photograph、survey、orthophoto 或 surroundings</translation>
    </message>
    <message>
        <source>find the file with the SHA-256 of the case, or accept it as it is</source>
        <translation>请找到 SHA-256 与案例一致的文件，或接受现有文件</translation>
    </message>
    <message>
        <source>four numbers</source>
        <translation>四个数</translation>
    </message>
    <message>
        <source>has blocks that are longer than the file</source>
        <translation>含有比文件还长的数据块</translation>
    </message>
    <message>
        <source>height that 5 % of the members stay below, 0 where they have no debris</source>
        <translation>5 % 的成员低于此高度，无碎块处计为 0</translation>
    </message>
    <message>
        <source>height that 95 % of the members stay below, 0 where they have no debris</source>
        <translation>95 % 的成员低于此高度，无碎块处计为 0</translation>
    </message>
    <message>
        <source>height that half of the members stay below, 0 where they have no debris</source>
        <translation>半数成员低于此高度，无碎块处计为 0</translation>
    </message>
    <message>
        <source>how far the probability may be off because the members are so few, by Agresti and Coull</source>
        <translation>因成员数有限，概率可能的偏差（Agresti 与 Coull）</translation>
    </message>
    <message>
        <source>is no base64</source>
        <translation>不是 base64</translation>
    </message>
    <message>
        <source>it became shorter while it was read</source>
        <translation>文件在读取时变短了</translation>
    </message>
    <message>
        <source>it has no piece</source>
        <translation>文件中没有 Piece</translation>
    </message>
    <message>
        <source>it is no VTK XML</source>
        <translation>它不是 VTK XML</translation>
    </message>
    <message>
        <source>it should say ASCII or BINARY</source>
        <translation>应注明 ASCII 或 BINARY</translation>
    </message>
    <message>
        <source>it should say DATASET UNSTRUCTURED_GRID</source>
        <translation>应注明 DATASET UNSTRUCTURED_GRID</translation>
    </message>
    <message>
        <source>its appended data do not begin</source>
        <translation>其附加数据没有开头</translation>
    </message>
    <message>
        <source>larger than a GLB file can be</source>
        <translation>超出 GLB 文件的大小上限</translation>
    </message>
    <message>
        <source>look at the place of the survey, or allow a longer shift</source>
        <translation>请检查测绘的位置，或允许更大的平移</translation>
    </message>
    <message>
        <source>look at these places; make the raster without poles, birds and marks of no data</source>
        <translation>请检查这些位置；栅格应去除杆件、飞鸟和无数据标记</translation>
    </message>
    <message>
        <source>make sure that the survey lies in the right place in plan</source>
        <translation>请确认测绘在平面上的位置正确</translation>
    </message>
    <message>
        <source>mass per area that 5 % of the members stay below</source>
        <translation>5 % 的成员低于此单位面积质量</translation>
    </message>
    <message>
        <source>mass per area that 95 % of the members stay below</source>
        <translation>95 % 的成员低于此单位面积质量</translation>
    </message>
    <message>
        <source>mass per area that half of the members stay below</source>
        <translation>半数成员低于此单位面积质量</translation>
    </message>
    <message>
        <source>none is needed; heights are interpolated between those of the file</source>
        <translation>无需处理；高程由文件中的高程插值得到</translation>
    </message>
    <message>
        <source>nothing was seen to fall</source>
        <translation>没有看到任何东西下落</translation>
    </message>
    <message>
        <source>numbers with a point as decimal sign, such as uniform:0.4:0.8</source>
        <translation>以点作小数点的数，例如 uniform:0.4:0.8</translation>
    </message>
    <message>
        <source>remove the attribute &quot;of&quot; where they belong to the debris</source>
        <translation>若属于堆积物，请删除属性“of”</translation>
    </message>
    <message>
        <source>says no place of its values</source>
        <translation>没有说明数值的位置</translation>
    </message>
    <message>
        <source>share of the members of the ensemble whose debris reaches into the cell</source>
        <translation>碎块触及该单元格的系综成员所占比例</translation>
    </message>
    <message>
        <source>share of the members whose debris is higher there than the first height</source>
        <translation>该处碎块高于第一高度的成员比例</translation>
    </message>
    <message>
        <source>share of the members whose debris is higher there than the second height</source>
        <translation>该处碎块高于第二高度的成员比例</translation>
    </message>
    <message>
        <source>share of the members whose debris is higher there than the third height</source>
        <translation>该处碎块高于第三高度的成员比例</translation>
    </message>
    <message>
        <source>simulated less surveyed</source>
        <translation>模拟减去测绘</translation>
    </message>
    <message>
        <source>simulated, at rest</source>
        <translation>模拟，静止时</translation>
    </message>
    <message>
        <source>simulated, at the end of the FE result</source>
        <translation>模拟，有限元结果结束时</translation>
    </message>
    <message>
        <source>simulating {0} members of the ensemble</source>
        <translation>正在模拟系综的 {0} 个成员</translation>
    </message>
    <message>
        <source>take a survey of the whole site if that is not meant</source>
        <translation>若非有意，请使用覆盖整个场地的测绘</translation>
    </message>
    <message>
        <source>the arrays of a field</source>
        <translation>场的数组</translation>
    </message>
    <message>
        <source>the best shift of the survey is as far as was looked: {0}</source>
        <translation>测绘的最佳平移已达搜索上限：{0}</translation>
    </message>
    <message>
        <source>the case has {0} orthophotos; the first is used</source>
        <translation>案例有 {0} 幅正射影像；使用第一幅</translation>
    </message>
    <message>
        <source>the case regroups its components in another way than the run</source>
        <translation>案例对构件的重新分组与计算不同</translation>
    </message>
    <message>
        <source>the corners of cells</source>
        <translation>单元的角点</translation>
    </message>
    <message>
        <source>the file is not the one the case was saved with</source>
        <translation>该文件不是案例保存时的文件</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>无法创建文件夹</translation>
    </message>
    <message>
        <source>the ground beside the debris is too level to find a shift in plan; only heights were moved</source>
        <translation>堆积物旁的地面过于平坦，无法确定平面平移；仅调整了高程</translation>
    </message>
    <message>
        <source>the ids of scenarios of the case: choice:scenario-1:scenario-2</source>
        <translation>案例中方案的标识：choice:scenario-1:scenario-2</translation>
    </message>
    <message>
        <source>the index of an element</source>
        <translation>单元的序号</translation>
    </message>
    <message>
        <source>the islands of this world</source>
        <translation>此世界的孤立部分</translation>
    </message>
    <message>
        <source>the offsets of cells</source>
        <translation>单元的偏移</translation>
    </message>
    <message>
        <source>the run has {0}, the case {1}</source>
        <translation>计算中为 {0},案例中为 {1}</translation>
    </message>
    <message>
        <source>the run is not complete: it ends after {0} frames</source>
        <translation>计算未完成：在 {0} 帧后结束</translation>
    </message>
    <message>
        <source>the run&apos;s fingerprint is {0}, its inputs and settings now give {1}</source>
        <translation>计算的指纹为 {0},其输入和设置现在得出 {1}</translation>
    </message>
    <message>
        <source>the types of cells</source>
        <translation>单元的类型</translation>
    </message>
    <message>
        <source>the values to choose from: choice:A:B</source>
        <translation>可供选择的值：choice:A:B</translation>
    </message>
    <message>
        <source>the {0} {1} has the SHA-256 {2} now, the run was made from {3}</source>
        <translation>{0} {1} 现在的 SHA-256 为 {2},而计算基于 {3}</translation>
    </message>
    <message>
        <source>there is a second section CELLS</source>
        <translation>有第二个 CELLS 段</translation>
    </message>
    <message>
        <source>there is a second section POINTS</source>
        <translation>有第二个 POINTS 段</translation>
    </message>
    <message>
        <source>things fall along ({0}, {1}, {2}), which is no axis of the file</source>
        <translation>下落沿 ({0}, {1}, {2})，不是文件的坐标轴</translation>
    </message>
    <message>
        <source>two numbers, the lesser first</source>
        <translation>两个数，较小者在前</translation>
    </message>
    <message>
        <source>uniform:LEAST:GREATEST, normal:MEAN:DEVIATION or choice:A:B</source>
        <translation>uniform:最小:最大、normal:平均:偏差 或 choice:A:B</translation>
    </message>
    <message>
        <source>{0} cannot be read as a VTK grid: before byte {1} {2}</source>
        <translation>无法把 {0} 作为 VTK 网格读取：在字节 {1} 之前，{2}</translation>
    </message>
    <message>
        <source>{0} cannot be varied as &quot;{1}&quot;.</source>
        <translation>{0} 不能按“{1}”变化。</translation>
    </message>
    <message>
        <source>{0} control points are used; a similarity takes two</source>
        <translation>使用了 {0} 个控制点；相似变换需要两个</translation>
    </message>
    <message>
        <source>{0} does not say by its ending what kind of figure it is to be</source>
        <translation>{0} 的扩展名没有说明是哪种插图</translation>
    </message>
    <message>
        <source>{0} does not say what it was made from</source>
        <translation>{0} 没有说明其来源</translation>
    </message>
    <message>
        <source>{0} does not show the site</source>
        <translation>{0} 未显示该场地</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; explains the evidence best: one of its members is closer than one of &quot;{1}&quot; in {2} % of the pairs, at least {3} % with 95 % confidence.</source>
        <translation>“{0}” 对证据的解释最好：在 {2} % 的成对比较中，其成员比 “{1}” 的成员更接近证据，95 % 置信下至少为 {3} %。</translation>
    </message>
    <message>
        <source>{0} has a corner without a place in the system of the case</source>
        <translation>{0} 有一个角点在案例坐标系中没有位置</translation>
    </message>
    <message>
        <source>{0} has cells of {1}, larger than what it shares with the site</source>
        <translation>{0} 的单元为 {1}，大于其与场地的重叠范围</translation>
    </message>
    <message>
        <source>{0} has more than {1} corners</source>
        <translation>{0} 的角点超过 {1} 个</translation>
    </message>
    <message>
        <source>{0} has more than {1} triangles</source>
        <translation>{0} 的三角形超过 {1} 个</translation>
    </message>
    <message>
        <source>{0} heights around the structure are more than can be used: cells of {1} were averaged to {2}</source>
        <translation>结构周围的 {0} 个高程超出上限：{1} 的单元已平均为 {2}</translation>
    </message>
    <message>
        <source>{0} heights stand out from all around them, such as {1} at x = {2}, y = {3}, and were taken as gaps</source>
        <translation>{0} 个高程明显突出于周围，例如 x = {2}、y = {3} 处的 {1}，已按空缺处理</translation>
    </message>
    <message>
        <source>{0} holds no colours</source>
        <translation>{0} 不含颜色</translation>
    </message>
    <message>
        <source>{0} holds no polygon</source>
        <translation>{0} 不含多边形</translation>
    </message>
    <message>
        <source>{0} holds something else than pictures of a movie: {1}</source>
        <translation>{0} 中有动画图片以外的内容：{1}</translation>
    </message>
    <message>
        <source>{0} is damaged so that the library that reads rasters fails on it</source>
        <translation>{0} 已损坏，读取栅格的库无法处理它</translation>
    </message>
    <message>
        <source>{0} is no orthophoto that can be read: {1}</source>
        <translation>{0} 不是可读取的正射影像：{1}</translation>
    </message>
    <message>
        <source>{0} is too large for a mesh of surroundings</source>
        <translation>{0} 作为周边网格过大</translation>
    </message>
    <message>
        <source>{0} is too long and narrow around the structure to be made coarser</source>
        <translation>{0} 在结构周围过于狭长，无法降低分辨率</translation>
    </message>
    <message>
        <source>{0} is varied twice.</source>
        <translation>{0} 被变化了两次。</translation>
    </message>
    <message>
        <source>{0} lies in degrees ({1}), and the case does not say where on Earth it is</source>
        <translation>{0} 采用经纬度（{1}），而案例未说明其地理位置</translation>
    </message>
    <message>
        <source>{0} lies in degrees ({1}); &quot;{2}&quot; of the case is no system it could be projected to</source>
        <translation>{0} 采用经纬度（{1}）；案例的“{2}”不是可投影到的坐标系</translation>
    </message>
    <message>
        <source>{0} lies in degrees, and the case does not say where on Earth it is</source>
        <translation>{0} 采用经纬度，而案例未说明其地理位置</translation>
    </message>
    <message>
        <source>{0} of simulated debris lies where nothing was surveyed and is left out</source>
        <translation>{0} 的模拟堆积物位于未测绘区域，未计入</translation>
    </message>
    <message>
        <source>{0} outlines of live structure in the file were left out</source>
        <translation>文件中 {0} 个未失效结构的轮廓未计入</translation>
    </message>
    <message>
        <source>{0} promises more heights than it can hold</source>
        <translation>{0} 声明的高程数多于文件所能容纳的数量</translation>
    </message>
    <message>
        <source>{0} says how the FE file is read and cannot be varied.</source>
        <translation>{0} 说明如何读取有限元文件，不能变化。</translation>
    </message>
    <message>
        <source>{0} shows no debris: no cell of {1} is higher than the ground</source>
        <translation>{0} 没有显示碎块：没有 {1} 的单元格高于地面</translation>
    </message>
    <message>
        <source>{0}: XDMF cannot name a run file with a colon or a bar in its path: {1}</source>
        <translation>{0}：XDMF 无法指称路径中含冒号或竖线的计算文件：{1}</translation>
    </message>
    <message>
        <source>{0}: its provenance names no FE result</source>
        <translation>{0}:其来源信息没有指明有限元结果</translation>
    </message>
    <message>
        <source>{0}: the array {1} {2}</source>
        <translation>{0}：数组 {1} {2}</translation>
    </message>
    <message>
        <source>{0}: the movie cannot be written: {1}</source>
        <translation>{0}:无法写入动画：{1}</translation>
    </message>
    <message>
        <source>{0}: the run has no fragments that could be written as glTF</source>
        <translation>{0}：该计算没有可写成 glTF 的碎块</translation>
    </message>
    <message>
        <source>{0}: the run has no frame with a body</source>
        <translation>{0}：该计算没有含刚体的帧</translation>
    </message>
    <message>
        <source>{0}: the run is too large for one glTF file: {1} GB</source>
        <translation>{0}：该计算对单个 glTF 文件而言过大：{1} GB</translation>
    </message>
    <message>
        <source>A list of deaths lies beside a result that says itself what is dead: it was not used</source>
        <translation>结果本身已说明哪些单元失效，其旁的失效清单未被采用</translation>
    </message>
    <message>
        <source>A photograph is left out: no outline is drawn on it, or it was not taken at rest.</source>
        <translation>一张照片被略去：其上没有绘制轮廓，或不是静止后拍摄的。</translation>
    </message>
    <message>
        <source>A world could not be kept for a second start.</source>
        <translation>有一个模拟无法保留供再次启动时使用。</translation>
    </message>
    <message>
        <source>Ask sinfo whether the cluster is up, and start the same command again.</source>
        <translation>请用 sinfo 查看集群是否在运行，然后再次启动同一命令。</translation>
    </message>
    <message>
        <source>Check its rights and how much memory is free.</source>
        <translation>请检查其权限以及空闲内存。</translation>
    </message>
    <message>
        <source>Check the rights of the folder and whether its disk is full.</source>
        <translation>请检查文件夹的权限以及磁盘是否已满。</translation>
    </message>
    <message>
        <source>Covered area</source>
        <translation>覆盖面积</translation>
    </message>
    <message>
        <source>Find the file with the SHA-256 of the case, or accept it as it is</source>
        <translation>请找到与案例中 SHA-256 相符的文件，或按原样接受它</translation>
    </message>
    <message>
        <source>Find the file with the SHA-256 of the case, or save the case anew.</source>
        <translation>请找到与案例 SHA-256 相符的文件，或重新保存案例。</translation>
    </message>
    <message>
        <source>GeoTIFF (*.tif);;Images (*.png)</source>
        <translation>GeoTIFF (*.tif);;图像 (*.png)</translation>
    </message>
    <message>
        <source>GeoTIFF (*.tif);;Tables (*.csv);;Images (*.png)</source>
        <translation>GeoTIFF (*.tif);;表格 (*.csv);;图像 (*.png)</translation>
    </message>
    <message>
        <source>Give both cases the same frame: they must be of one site.</source>
        <translation>请让两个案例使用同一坐标框架：它们必须属于同一现场。</translation>
    </message>
    <message>
        <source>Give the result of the FE analysis as Exodus II (.exo, .e, .ex2). Tables that an .xdmf names are opened through it.</source>
        <translation>请给出 Exodus II 格式的有限元分析结果（.exo、.e、.ex2）。.xdmf 所引用的数据表经由该 .xdmf 打开。</translation>
    </message>
    <message>
        <source>Give the result that the analysis has written from it; a deck that lies beside the result is read with it.</source>
        <translation>请给出由它计算得到的结果；结果旁的输入文件会一并读取。</translation>
    </message>
    <message>
        <source>If it holds states of a d3plot family, put the first file of the family, {0}, beside it. Formats that can be read: {1}.</source>
        <translation>若它是某 d3plot 系列的状态文件，请将该系列的首个文件 {0} 放在其旁。可读取的格式：{1}。</translation>
    </message>
    <message>
        <source>Members keep their debris at rest; draw around the debris on photographs of it.</source>
        <translation>成员只保留静止后的堆积物；请在静止后的照片上圈出堆积物。</translation>
    </message>
    <message>
        <source>Opening &quot;{0}&quot;</source>
        <translation>正在打开 “{0}”</translation>
    </message>
    <message>
        <source>See which there are: rubble-cli jobs list.</source>
        <translation>查看现有作业：rubble-cli jobs list。</translation>
    </message>
    <message>
        <source>Slurm does not answer.</source>
        <translation>Slurm 没有应答。</translation>
    </message>
    <message>
        <source>Slurm is not installed here: there is no program {0}.</source>
        <translation>此处未安装 Slurm：没有程序 {0}。</translation>
    </message>
    <message>
        <source>Take it away, or check which of the two is right.</source>
        <translation>请移走该清单，或核对两者哪个正确。</translation>
    </message>
    <message>
        <source>The FE file is not the one the case was saved with.</source>
        <translation>有限元文件不是保存案例时的那个文件。</translation>
    </message>
    <message>
        <source>The program {0} cannot be started: {1}</source>
        <translation>无法启动程序 {0}：{1}</translation>
    </message>
    <message>
        <source>The survey is not the one the case was saved with</source>
        <translation>该测绘不是案例保存时所用的测绘</translation>
    </message>
    <message>
        <source>There is no job {0} in {1}.</source>
        <translation>{1} 中没有作业 {0}。</translation>
    </message>
    <message>
        <source>This study has no world {0}: its inputs, settings or the build of Rubble are not those that the list was made with.</source>
        <translation>此研究中没有模拟 {0}：其输入、设置或 Rubble 的版本与生成列表时不同。</translation>
    </message>
    <message>
        <source>Use one build of Rubble on processors of one kind, leave the inputs as they are, or have the list made anew.</source>
        <translation>请在同类处理器上使用同一版本的 Rubble 并保持输入不变，或重新生成列表。</translation>
    </message>
    <message>
        <source>an input deck</source>
        <translation>输入文件</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>保持现状</translation>
    </message>
    <message>
        <source>islands</source>
        <translation>孤立部分</translation>
    </message>
    <message>
        <source>lost with its node</source>
        <translation>随节点一同丢失</translation>
    </message>
    <message>
        <source>not told apart</source>
        <translation>不可区分</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>timed out</source>
        <translation>超时</translation>
    </message>
    <message>
        <source>told apart</source>
        <translation>可区分</translation>
    </message>
    <message>
        <source>{0} cannot be written.</source>
        <translation>无法写入 {0}。</translation>
    </message>
    <message>
        <source>{0} has no scenarios.</source>
        <translation>{0} 没有方案。</translation>
    </message>
    <message>
        <source>Its scenarios: {0}.</source>
        <translation>它的方案有：{0}。</translation>
    </message>
    <message>
        <source>{0} names no FE result.</source>
        <translation>{0} 未指定有限元结果。</translation>
    </message>
    <message>
        <source>Add the FE result to the case, or open the FE result itself.</source>
        <translation>请把该有限元结果加入案例，或直接打开有限元结果。</translation>
    </message>
    <message>
        <source>{0}: the scenario &quot;{1}&quot; names the FE input &quot;{2}&quot;, which the case does not have.</source>
        <translation>{0}：方案“{1}”指定的有限元输入“{2}”在案例中不存在。</translation>
    </message>
    <message>
        <source>{0} is not a case, so it has no scenarios.</source>
        <translation>{0} 不是案例，因此没有方案。</translation>
    </message>
    <message>
        <source>Name no scenario, or open a case.</source>
        <translation>请不要指定方案，或打开一个案例。</translation>
    </message>
    <message>
        <source>the scenario names no FE result, and the case has {0}; the first is used</source>
        <translation>方案未指定有限元结果，而案例有 {0} 个；采用第一个</translation>
    </message>
    <message>
        <source>name the FE result of the scenario, or keep one in the case</source>
        <translation>请为方案指定有限元结果，或在案例中只保留一个</translation>
    </message>
    <message>
        <source>{0} = {1}: the unit of {0} is {2}, not {3}.</source>
        <translation>{0} = {1}：{0} 的单位是 {2}，而不是 {3}。</translation>
    </message>
    <message>
        <source>Convert the value and give the number alone.</source>
        <translation>请换算数值，只给出数字。</translation>
    </message>
    <message>
        <source>{0} has no scenario &quot;{1}&quot;.</source>
        <translation>{0} 没有方案“{1}”。</translation>
    </message>
    <message>
        <source>{0} of {1} worlds are made; the cluster does not answer</source>
        <translation>已完成 {0}/{1} 个模拟；集群没有应答</translation>
    </message>
    <message>
        <source>Frame of the control points</source>
        <translation>控制点的坐标框架</translation>
    </message>
    <message>
        <source>Give the .cdb with the mesh; a macro of the same name beside it is read with it.</source>
        <translation>请给出含网格的 .cdb；旁边同名的宏会一并读取。</translation>
    </message>
    <message>
        <source>Give the animation files of the run (RUNA001, RUNA002, ...): curves over time have no mesh.</source>
        <translation>请给出该计算的动画文件（RUNA001、RUNA002……）：时程曲线不含网格。</translation>
    </message>
    <message>
        <source>Give the result that lies beside it: the animation files of OpenRadioss, the .frd of CalculiX.</source>
        <translation>请给出旁边的结果文件：OpenRadioss 的动画文件，或 CalculiX 的 .frd。</translation>
    </message>
    <message>
        <source>a listing that the analysis has printed</source>
        <translation>分析程序输出的文本列表</translation>
    </message>
    <message>
        <source>a macro of Ansys that kills elements</source>
        <translation>杀死单元的 Ansys 宏</translation>
    </message>
    <message>
        <source>a time history of OpenRadioss</source>
        <translation>OpenRadioss 的时程文件</translation>
    </message>
    <message>
        <source>metres, z up, easting, northing and height by the control points of the site</source>
        <translation>米，z 向上，东坐标、北坐标和高程由场地的控制点给出</translation>
    </message>
    <message>
        <source>that of the control points, metres</source>
        <translation>控制点所属坐标系，米</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; has another origin, axes, coordinate system or control points than &quot;{1}&quot;.</source>
        <translation>“{0}” 的原点、坐标轴、坐标系或控制点与 “{1}” 不同。</translation>
    </message>
    <message>
        <source>Install rubble-cli beside rubble.</source>
        <translation>请将 rubble-cli 与 rubble 安装在一起。</translation>
    </message>
    <message>
        <source>There is no {0}, which makes the worlds on the cluster.</source>
        <translation>没有 {0}，它在集群上生成世界。</translation>
    </message>
    <message>
        <source>sinfo waits in vain</source>
        <translation>sinfo 没有应答</translation>
    </message>
    <message>
        <source>{0} of {1} worlds are made on the cluster; {2} run, {3} wait, {4} failed</source>
        <translation>集群上已生成 {1} 个世界中的 {0} 个；{2} 个在运行，{3} 个在等待，{4} 个失败</translation>
    </message>
    <message>
        <source>usual for cast iron</source>
        <translation>铸铁的常见值</translation>
    </message>
    <message>
        <source>usual for concrete</source>
        <translation>混凝土的常见值</translation>
    </message>
    <message>
        <source>usual for copper</source>
        <translation>铜的常见值</translation>
    </message>
    <message>
        <source>usual for lead</source>
        <translation>铅的常见值</translation>
    </message>
    <message>
        <source>usual for masonry</source>
        <translation>砌体的常见值</translation>
    </message>
    <message>
        <source>usual for soil or fill</source>
        <translation>土或填料的常见值</translation>
    </message>
    <message>
        <source>usual for steel</source>
        <translation>钢的常见值</translation>
    </message>
    <message>
        <source>usual for stone</source>
        <translation>石材的常见值</translation>
    </message>
    <message>
        <source>usual for timber</source>
        <translation>木材的常见值</translation>
    </message>
    <message>
        <source>usual for titanium</source>
        <translation>钛的常见值</translation>
    </message>
    <message>
        <source>usual for tungsten</source>
        <translation>钨的常见值</translation>
    </message>
    <message>
        <source>{0}; {1} of {2} active at the first state</source>
        <translation>{0}；初始状态 {2} 个中 {1} 个激活</translation>
    </message>
    <message>
        <source>Check the coordinate system and the control points of the case.</source>
        <translation>请检查案例的坐标系和控制点。</translation>
    </message>
    <message>
        <source>Tie the FE model to the coordinate system by control points (Site… in the Case menu), or give the right raster.</source>
        <translation>请用控制点（“案例”菜单中的“场地…”）将有限元模型与坐标系联系起来，或给出正确的栅格。</translation>
    </message>
    <message>
        <source>check the vertical datum, the unit of the heights and the height shift of the site</source>
        <translation>请检查高程基准、高程单位和场地的高程偏移</translation>
    </message>
    <message>
        <source>set the height shift of the site to the difference there</source>
        <translation>请将场地的高程偏移设为当地的差值</translation>
    </message>
    <message>
        <source>the {0} {1} has the SHA-256 {2} now, the case names {3}</source>
        <translation>{0} {1} 现在的 SHA-256 为 {2}，而案例记录的是 {3}</translation>
    </message>
    <message>
        <source>Both sides hold fallen live structure: simulated, what moved farther than {0}.</source>
        <translation>两侧都包含坠落的未失效结构：模拟的为移动超过 {0} 的部分。</translation>
    </message>
    <message>
        <source>Both sides leave out fallen live structure.</source>
        <translation>两侧都略去坠落的未失效结构。</translation>
    </message>
    <message>
        <source>Fallen live structure is left out of the simulated side; the survey shows it.</source>
        <translation>模拟一侧略去坠落的未失效结构；测绘显示它。</translation>
    </message>
    <message>
        <source>Fallen live structure is left out of the simulated side; whether the survey shows it is not known.</source>
        <translation>模拟一侧略去坠落的未失效结构；测绘是否显示它未知。</translation>
    </message>
    <message>
        <source>The evidence lies farther from the members of the closest hypothesis than these lie from each other: perhaps none of the hypotheses is the cause.</source>
        <translation>证据与最接近假设的成员的距离大于这些成员彼此之间的距离：这些假设可能都不是原因。</translation>
    </message>
    <message>
        <source>The simulated side holds fallen live structure, what moved farther than {0}; the survey does not.</source>
        <translation>模拟一侧包含坠落的未失效结构，即移动超过 {0} 的部分；测绘不包含。</translation>
    </message>
    <message>
        <source>The simulated side holds fallen live structure, what moved farther than {0}; whether the survey does is not known.</source>
        <translation>模拟一侧包含坠落的未失效结构，即移动超过 {0} 的部分；测绘是否包含未知。</translation>
    </message>
    <message>
        <source>This evidence cannot tell &quot;{0}&quot; from &quot;{1}&quot;, and it lies outside of what the members of &quot;{0}&quot; do: perhaps none of the hypotheses is the cause.</source>
        <translation>此证据无法区分 “{0}” 与 “{1}”，并且超出了 “{0}” 成员的范围：这些假设可能都不是原因。</translation>
    </message>
    <message>
        <source>count it on both sides or on neither (--live)</source>
        <translation>请在两侧都计入或都不计入（--live）</translation>
    </message>
    <message>
        <source>fallen live structure counts as simulated debris, {0} elements of {1}, and the survey does not hold such structure</source>
        <translation>坠落的未失效结构计为模拟的堆积物（{0} 个单元，{1}），而测绘不包含这类结构</translation>
    </message>
    <message>
        <source>live structure fell, {0} elements of {1}, and it is not known whether the survey shows such structure</source>
        <translation>有未失效结构坠落：{0} 个单元，{1}；测绘是否显示这类结构未知</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>set live_islands=released and simulate again</source>
        <translation>请设 live_islands=released 并重新模拟</translation>
    </message>
    <message>
        <source>the survey shows fallen live structure, and that of the simulation, {0} elements of {1}, is left out</source>
        <translation>测绘显示坠落的未失效结构，而模拟的（{0} 个单元，{1}）被略去</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is closer to the evidence than the others, but the evidence lies outside of what its members do: perhaps none of the hypotheses is the cause.</source>
        <translation>“{0}” 比其他假设更接近证据，但证据超出了其成员的范围：这些假设可能都不是原因。</translation>
    </message>
    <message>
        <source>{0} loose parts of live structure were held where the FE result ends; in the survey they have fallen</source>
        <translation>{0} 个松脱的未失效部分被固定在有限元结果结束处；在测绘中它们已坠落</translation>
    </message>
    <message>
        <source>Heights above the ground have no ground that could be laid on another</source>
        <translation>从地面算起的高度没有可与另一地面配准的地面</translation>
    </message>
    <message>
        <source>Of these hypotheses &quot;{0}&quot; explains the outline best: one of its members is closer than one of &quot;{1}&quot; in {2} % of the pairs, at least {3} % with 95 % confidence. A cause that is not among them may leave the same outline.</source>
        <translation>在这些假设中 “{0}” 最能解释该轮廓：在 {2} % 的成对比较中其成员比 “{1}” 的成员更接近，在 95 % 置信度下至少为 {3} %。不在其中的原因可能留下同样的轮廓。</translation>
    </message>
    <message>
        <source>Register the survey to the debris, or not at all.</source>
        <translation>将测绘配准到堆积物，或不作配准。</translation>
    </message>
    <message>
        <source>Take it as a survey, or give a height model of the site.</source>
        <translation>将其作为测绘，或给出现场的高程模型。</translation>
    </message>
    <message>
        <source>VTKHDF (*.vtkhdf)</source>
        <translation>VTKHDF (*.vtkhdf)</translation>
    </message>
    <message>
        <source>none is needed; the comparison is between two simulations</source>
        <translation>无需处理；这是两次模拟之间的比较</translation>
    </message>
    <message>
        <source>the survey is a debris map: its heights are taken above the ground</source>
        <translation>该测绘是堆积物图：其高度按从地面算起处理</translation>
    </message>
    <message>
        <source>{0} is a debris map: its heights are above the ground, not those of a ground</source>
        <translation>{0} 是堆积物图：其高度从地面算起，不是地面的高度</translation>
    </message>
    <message>
        <source>A live rate of {0} is out of reach: even at the upper bounds {1} clusters are awake at once, {2} are allowed; about {3} can be reached</source>
        <translation>无法达到 {0} 的实时帧率：即使取上限仍同时有 {1} 个聚类在活动，而允许 {2} 个；约可达到 {3}</translation>
    </message>
    <message>
        <source>The grid set by hand has {0} clusters awake at once, more than the {1} bodies that reach {2}</source>
        <translation>手动设置的网格同时有 {0} 个聚类在活动，多于可达到 {2} 的 {1} 个刚体</translation>
    </message>
    <message>
        <source>A checkpoint could not be kept: a run that is stopped goes on from the one before, or begins at its start.</source>
        <translation>检查点未能保存：计算中断后将从上一个检查点继续，或从头开始。</translation>
    </message>
    <message>
        <source>A checkpoint is damaged: the simulation begins at its start.</source>
        <translation>检查点已损坏：模拟从头开始。</translation>
    </message>
    <message>
        <source>A checkpoint is of another build, input or setting: the simulation begins at its start.</source>
        <translation>检查点属于另一个构建、输入或设置：模拟从头开始。</translation>
    </message>
    <message>
        <source>Make room on the disk.</source>
        <translation>请在磁盘上腾出空间。</translation>
    </message>
    <message>
        <source>Nothing needs doing: the next checkpoint takes its place.</source>
        <translation>无需处理：下一个检查点会取代它。</translation>
    </message>
    <message>
        <source>Nothing needs doing: the next checkpoint takes its place. Check the disk.</source>
        <translation>无需处理：下一个检查点会取代它。请检查磁盘。</translation>
    </message>
    <message>
        <source>What was kept is not whole.</source>
        <translation>所保存的内容不完整。</translation>
    </message>
    <message>
        <source>going on from a checkpoint at {0}</source>
        <translation>从 {0} 处的检查点继续</translation>
    </message>
    <message>
        <source>it does not begin as one</source>
        <translation>开头不是检查点</translation>
    </message>
    <message>
        <source>it is shorter than its head</source>
        <translation>比其文件头还短</translation>
    </message>
    <message>
        <source>its bytes are not those that were written</source>
        <translation>其字节与写入时不同</translation>
    </message>
    <message>
        <source>not enough memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>simulating {0} worlds; {1} went on from checkpoints, the latest at {2}</source>
        <translation>正在模拟 {0} 次计算；其中 {1} 次从检查点继续，最近一次在 {2}</translation>
    </message>
    <message>
        <source>what it says does not belong together</source>
        <translation>其内容互不相符</translation>
    </message>
    <message>
        <source>{0}, {1} times its first volume</source>
        <translation>{0}，体积为最初的 {1} 倍</translation>
    </message>
    <message>
        <source>{0}, {1} thick per length</source>
        <translation>{0}，厚度与长度之比为 {1}</translation>
    </message>
    <message>
        <source>{0}, {1} s, but reported at state {2}</source>
        <translation>{0}，{1} s，但到状态 {2} 才报告</translation>
    </message>
    <message>
        <source>element {0} ({1}), {2} s</source>
        <translation>单元 {0}（{1}），{2} s</translation>
    </message>
    <message>
        <source>A repeat could not be simulated.</source>
        <translation>一次重复未能模拟。</translation>
    </message>
    <message>
        <source>Give a GeoPackage, GeoJSON, Shapefile, FlatGeobuf or KML.</source>
        <translation>请给出 GeoPackage、GeoJSON、Shapefile、FlatGeobuf 或 KML。</translation>
    </message>
    <message>
        <source>Give a height model of the site, or a map with the layer height.</source>
        <translation>请给出现场的高程模型，或含 height 图层的图。</translation>
    </message>
    <message>
        <source>Make one file of it with gdal_translate, such as a GeoTIFF.</source>
        <translation>请用 gdal_translate 将其做成单个文件，例如 GeoTIFF。</translation>
    </message>
    <message>
        <source>The polygons of {0} cover no cell of {1}</source>
        <translation>{0} 的多边形未覆盖任何 {1} 的单元格</translation>
    </message>
    <message>
        <source>give outlines as polygons if they belong to the debris</source>
        <translation>若属于堆积物，请以多边形给出轮廓</translation>
    </message>
    <message>
        <source>heights of the raster count from &quot;{0}&quot;, those of the case from &quot;{1}&quot;; they were not converted</source>
        <translation>栅格高程基准为“{0}”，案例为“{1}”；未做换算</translation>
    </message>
    <message>
        <source>none is needed</source>
        <translation>无需处理</translation>
    </message>
    <message>
        <source>none is needed; the comparison leaves these places out</source>
        <translation>无需处理；比较时略去这些位置</translation>
    </message>
    <message>
        <source>the coordinate system of the raster could not be held against that of the case; both are taken as one</source>
        <translation>无法将栅格的坐标系与案例的坐标系核对；视为同一坐标系</translation>
    </message>
    <message>
        <source>the outline names no coordinate system; it is taken to be that of the case</source>
        <translation>轮廓未给出坐标系；按案例的坐标系处理</translation>
    </message>
    <message>
        <source>the outline says that it lies in degrees, but cannot; it is taken as metres</source>
        <translation>轮廓称其坐标为度，但不可能；按米处理</translation>
    </message>
    <message>
        <source>the outline was projected from &quot;{0}&quot; to the system of the case</source>
        <translation>轮廓已从“{0}”投影到案例坐标系</translation>
    </message>
    <message>
        <source>the raster does not say in which unit its heights are; they are taken as metres</source>
        <translation>栅格未说明高程单位；按米处理</translation>
    </message>
    <message>
        <source>the raster gives its heights in &quot;{0}&quot;; they are taken as metres</source>
        <translation>栅格高程的单位为“{0}”；按米处理</translation>
    </message>
    <message>
        <source>the raster has {0} bands; the first is taken as heights</source>
        <translation>栅格有 {0} 个波段；取第一个为高程</translation>
    </message>
    <message>
        <source>the raster was projected from &quot;{0}&quot; to the system of the case</source>
        <translation>栅格已从“{0}”投影到案例坐标系</translation>
    </message>
    <message>
        <source>write the outline with the system that its coordinates are of</source>
        <translation>请写出轮廓坐标所属的坐标系</translation>
    </message>
    <message>
        <source>{0} is a map that Rubble made, and none of its bands holds heights</source>
        <translation>{0} 是 Rubble 生成的图，其各波段均不含高度</translation>
    </message>
    <message>
        <source>{0} is no file of polygons that can be read</source>
        <translation>{0} 不是可读取的多边形文件</translation>
    </message>
    <message>
        <source>{0} is no raster of heights that can be read: {1}</source>
        <translation>{0} 不是可读取的高程栅格：{1}</translation>
    </message>
    <message>
        <source>{0} of {1} heights of the survey have no value ({2} %): nothing was surveyed there</source>
        <translation>测绘的 {1} 个高程中有 {0} 个没有值（{2} %）：该处未测绘</translation>
    </message>
    <message>
        <source>{0} points or lines in the file were left out</source>
        <translation>略去了文件中的 {0} 个点或线</translation>
    </message>
    <message>
        <source>{0} points to heights in other files, which may change unnoticed</source>
        <translation>{0} 指向其他文件中的高程，这些文件可能在不知不觉中改变</translation>
    </message>
    <message>
        <source>looking for loose structure</source>
        <translation>正在查找松脱的结构</translation>
    </message>
    <message>
        <source>../metadata.xml</source>
        <translation>../metadata.xml</translation>
    </message>
    <message>
        <source>Check that the file is what its name says, and export the mesh anew.</source>
        <translation>请检查文件是否名实相符，并重新导出网格。</translation>
    </message>
    <message>
        <source>Cut large faces into triangles before the mesh is exported.</source>
        <translation>请在导出网格之前将大的面剖分为三角形。</translation>
    </message>
    <message>
        <source>Export the mesh anew as glTF 2.0, OBJ or PLY.</source>
        <translation>请将网格重新导出为 glTF 2.0、OBJ 或 PLY。</translation>
    </message>
    <message>
        <source>Export the mesh anew, as PLY.</source>
        <translation>请重新导出为 PLY。</translation>
    </message>
    <message>
        <source>Export the mesh anew, or put the line right.</source>
        <translation>请重新导出网格，或改正该行。</translation>
    </message>
    <message>
        <source>Export the mesh anew, with a point as decimal sign.</source>
        <translation>请以点作为小数点重新导出网格。</translation>
    </message>
    <message>
        <source>Export the mesh anew.</source>
        <translation>请重新导出网格。</translation>
    </message>
    <message>
        <source>Export the mesh anew; each coordinate must be a number in metres.</source>
        <translation>请重新导出网格；每个坐标都必须是以米为单位的数值。</translation>
    </message>
    <message>
        <source>Export the mesh anew; its faces must have corners apart from each other.</source>
        <translation>请重新导出网格；面的角点必须彼此分开。</translation>
    </message>
    <message>
        <source>Export the mesh without them, for example uncompressed and without instances.</source>
        <translation>请不用这些扩展导出网格，例如不压缩、不用实例。</translation>
    </message>
    <message>
        <source>Give a mesh with faces; a cloud of points has no surface.</source>
        <translation>请给出带面的网格；点云没有表面。</translation>
    </message>
    <message>
        <source>Leave the offset out, or add the mesh to the case.</source>
        <translation>请不给偏移，或将网格加入案例。</translation>
    </message>
    <message>
        <source>Put the file beside the glTF, or export it as one .glb.</source>
        <translation>请将该文件放在 glTF 旁，或导出为单个 .glb。</translation>
    </message>
    <message>
        <source>SHIFT.txt</source>
        <translation>SHIFT.txt</translation>
    </message>
    <message>
        <source>Scale it to bytes with gdal_translate -ot Byte -scale.</source>
        <translation>请用 gdal_translate -ot Byte -scale 将其缩放为字节。</translation>
    </message>
    <message>
        <source>The numbers of the glTF, {0}, cannot be read</source>
        <translation>无法读取 glTF 的数值 {0}</translation>
    </message>
    <message>
        <source>a mesh follows a skeleton, which was left out</source>
        <translation>有一个网格跟随骨架，骨架已略去</translation>
    </message>
    <message>
        <source>a mesh has morph targets, which were left out</source>
        <translation>有一个网格带变形目标，已略去</translation>
    </message>
    <message>
        <source>a number from 0 on</source>
        <translation>从 0 起的数</translation>
    </message>
    <message>
        <source>a number from 0 to 6</source>
        <translation>0 至 6 的数</translation>
    </message>
    <message>
        <source>a quaternion of length 1</source>
        <translation>长度为 1 的四元数</translation>
    </message>
    <message>
        <source>apply the pose of the skeleton before the mesh is exported</source>
        <translation>请在导出网格之前应用骨架的姿态</translation>
    </message>
    <message>
        <source>apply them before the mesh is exported</source>
        <translation>请在导出网格之前应用它们</translation>
    </message>
    <message>
        <source>bring the file to the system of the case with a program that knows the way between the two</source>
        <translation>请用知道两者间转换的程序将文件转到案例的坐标系</translation>
    </message>
    <message>
        <source>by the control points the model is {0} times as large as it should be there: a point is wrong, or the two sides have different units</source>
        <translation>按控制点，模型在该处为应有大小的 {0} 倍：有点错误，或两侧单位不同</translation>
    </message>
    <message>
        <source>change easting and northing of the control points for each other</source>
        <translation>请互换控制点的东向和北向</translation>
    </message>
    <message>
        <source>check system and control points of the case</source>
        <translation>请检查案例的坐标系和控制点</translation>
    </message>
    <message>
        <source>check the heights of the mesh, its offset and the height shift of the site</source>
        <translation>请检查网格的高程、偏移和场地的高程偏移</translation>
    </message>
    <message>
        <source>choose a system made for the site, such as its UTM zone, or tie the model to this one by control points</source>
        <translation>请选用适合场地的坐标系，如其 UTM 分带，或用控制点将模型与此坐标系联系</translation>
    </message>
    <message>
        <source>cut these faces into triangles before the mesh is exported</source>
        <translation>请在导出网格之前将这些面剖分为三角形</translation>
    </message>
    <message>
        <source>easting {2}, northing {3} of the site is no place on Earth in &quot;{0}&quot; ({1})</source>
        <translation>在“{0}”（{1}）中，场地的东向 {2}、北向 {3} 不是地球上的位置</translation>
    </message>
    <message>
        <source>export the mesh anew; something of it is missing</source>
        <translation>请重新导出网格；其中有缺失</translation>
    </message>
    <message>
        <source>fetch the grid with projsync --file NAME (package proj-bin), then open the case again</source>
        <translation>请用 projsync --file NAME（软件包 proj-bin）获取网格，然后重新打开案例</translation>
    </message>
    <message>
        <source>give all coordinates in metres, also in a system that counts in feet; else leave points out one by one and look at the residuals</source>
        <translation>请以米给出所有坐标，坐标系以英尺为单位时也如此；否则逐个去掉控制点并查看残差</translation>
    </message>
    <message>
        <source>give easting and northing of the case in metres; what is written for others is in the unit of the system</source>
        <translation>请以米给出案例的东向和北向；写给其他程序的结果用坐标系的单位</translation>
    </message>
    <message>
        <source>give the case a projected system, such as the UTM zone of the site</source>
        <translation>请为案例给出投影坐标系，如场地的 UTM 分带</translation>
    </message>
    <message>
        <source>give the case an EPSG code, EPSG:25832 for example, or none</source>
        <translation>请为案例给出 EPSG 代码，如 EPSG:25832，或不给</translation>
    </message>
    <message>
        <source>give the file in the system of the case if that is too coarse</source>
        <translation>若太粗，请以案例的坐标系给出文件</translation>
    </message>
    <message>
        <source>heights of the raster count from &quot;{0}&quot;, and the case names no vertical datum; they were not converted</source>
        <translation>栅格的高程从“{0}”起算，案例未写明高程基准；未作转换</translation>
    </message>
    <message>
        <source>how well places in &quot;{0}&quot; are known in &quot;{1}&quot; is not known to PROJ; they may be metres or more off</source>
        <translation>PROJ 不知道“{0}”中的位置在“{1}”中有多准；可能偏差数米或更多</translation>
    </message>
    <message>
        <source>it has more numbers than can be read</source>
        <translation>其数值多于可读取的数目</translation>
    </message>
    <message>
        <source>it holds fewer numbers than are asked of it</source>
        <translation>其所含数值少于所需</translation>
    </message>
    <message>
        <source>it is no list of numbers or places</source>
        <translation>不是数值或位置的列表</translation>
    </message>
    <message>
        <source>it names a number that the accessor does not have</source>
        <translation>引用了访问器没有的数值</translation>
    </message>
    <message>
        <source>it reaches beyond the end of its buffer</source>
        <translation>超出其缓冲区的末尾</translation>
    </message>
    <message>
        <source>its unit</source>
        <translation>其单位</translation>
    </message>
    <message>
        <source>lengths in &quot;{0}&quot; are {1} times those on the ground at the site, and the model is laid into it as it is</source>
        <translation>在场地处“{0}”中的长度为地面长度的 {1} 倍，而模型按原样放入</translation>
    </message>
    <message>
        <source>look at its coordinates, or leave it out and look at the residuals of the others</source>
        <translation>请查看其坐标，或去掉该点并查看其余点的残差</translation>
    </message>
    <message>
        <source>look at its heights, or leave it out and look at the residuals of the others</source>
        <translation>请查看其高程，或去掉该点并查看其余点的残差</translation>
    </message>
    <message>
        <source>look for x and y, or easting and northing, that were changed for each other, or an axis against its sign</source>
        <translation>请查找互换的 x 和 y、东向和北向，或符号相反的坐标轴</translation>
    </message>
    <message>
        <source>make sure that all heights of the case count from it, or set the height shift of the site</source>
        <translation>请确认案例的所有高程都从其起算，或设置场地的高程偏移</translation>
    </message>
    <message>
        <source>make sure that shape and place are right without them, or export the mesh anew without them</source>
        <translation>请确认没有这些扩展时形状和位置正确，或不用它们重新导出网格</translation>
    </message>
    <message>
        <source>name the colours of the bands with gdal_translate -colorinterp if that is not right</source>
        <translation>若不正确，请用 gdal_translate -colorinterp 写明各波段的颜色</translation>
    </message>
    <message>
        <source>name the coordinate system of the case; or check that its coordinates are those of the file</source>
        <translation>请写明案例的坐标系；或检查其坐标与文件的是否一致</translation>
    </message>
    <message>
        <source>no more than the accessor has</source>
        <translation>不多于访问器所有</translation>
    </message>
    <message>
        <source>nodes hang too deep below each other</source>
        <translation>节点的层次太深</translation>
    </message>
    <message>
        <source>none is needed if it is of this mesh and of the system of the case; else state the offset in the case</source>
        <translation>若其属于此网格和案例的坐标系则无需处理；否则请在案例中给出偏移</translation>
    </message>
    <message>
        <source>none is needed if it looks right</source>
        <translation>若看起来正确则无需处理</translation>
    </message>
    <message>
        <source>none is needed if they are marks; else export them as faces</source>
        <translation>若只是标记则无需处理；否则请导出为面</translation>
    </message>
    <message>
        <source>not named</source>
        <translation>未写明</translation>
    </message>
    <message>
        <source>numbers in base64</source>
        <translation>base64 编码的数值</translation>
    </message>
    <message>
        <source>one control point is used, which says nothing: the origin of the frame places everything</source>
        <translation>只采用一个控制点，不起作用：一切按坐标框架的原点定位</translation>
    </message>
    <message>
        <source>places are good to {0} only: so accurate is the way from &quot;{1}&quot; to &quot;{2}&quot;, {3}</source>
        <translation>位置只准到 {0}：从“{1}”到“{2}”的转换（{3}）即为此精度</translation>
    </message>
    <message>
        <source>positions of three numbers</source>
        <translation>由三个数组成的位置</translation>
    </message>
    <message>
        <source>scale it to bytes with gdal_translate -ot Byte -scale if it looks too dark or too bright</source>
        <translation>若太暗或太亮，请用 gdal_translate -ot Byte -scale 将其缩放为字节</translation>
    </message>
    <message>
        <source>state the offset of the mesh in the case if it is to be added</source>
        <translation>如需加上，请在案例中给出网格的偏移</translation>
    </message>
    <message>
        <source>state the offset of the mesh in the case, or remove the file</source>
        <translation>请在案例中给出网格的偏移，或移走该文件</translation>
    </message>
    <message>
        <source>the case names the coordinate system &quot;{0}&quot;, but nothing says where in it the model stands</source>
        <translation>案例写明坐标系“{0}”，但没有说明模型在其中何处</translation>
    </message>
    <message>
        <source>the colours of the picture are fractions from 0 to 1</source>
        <translation>影像的颜色为 0 至 1 的小数</translation>
    </message>
    <message>
        <source>the colours of the picture have {0} bits and were scaled to 8</source>
        <translation>影像的颜色为 {0} 位，已缩放为 8 位</translation>
    </message>
    <message>
        <source>the control point &quot;{0}&quot; is {1} off in height, where the points are {2} apart; heights of terrain and surveys are off by as much</source>
        <translation>控制点“{0}”高程偏差 {1}，点间距离 {2}；地形和测绘的高程也偏差这么多</translation>
    </message>
    <message>
        <source>the control point &quot;{0}&quot; is {1} off in plan, where the points are {2} apart; maps are off by as much</source>
        <translation>控制点“{0}”平面偏差 {1}，点间距离 {2}；地图也偏差这么多</translation>
    </message>
    <message>
        <source>the control points fit only a mirrored frame: they are {0} off in plan (RMS), where they are {1} apart</source>
        <translation>控制点只与镜像的坐标框架相符：平面偏差 {0}（均方根），点间距离 {1}</translation>
    </message>
    <message>
        <source>the coordinate system &quot;{0}&quot; of the case has no eastings and northings</source>
        <translation>案例的坐标系“{0}”没有东向和北向坐标</translation>
    </message>
    <message>
        <source>the coordinate system &quot;{0}&quot; of the case is not known</source>
        <translation>案例的坐标系“{0}”未知</translation>
    </message>
    <message>
        <source>the file keeps coordinates to {0} only</source>
        <translation>文件所存坐标只精确到 {0}</translation>
    </message>
    <message>
        <source>the file lies in &quot;{0}&quot;, and the case names no coordinate system; that of the file is taken for it</source>
        <translation>文件的坐标系为“{0}”，而案例未写明坐标系；视为文件的坐标系</translation>
    </message>
    <message>
        <source>the grid {0} is not here, and without it no way from &quot;{1}&quot; to &quot;{2}&quot; is known well; places may be metres or more off</source>
        <translation>没有网格 {0}，缺少它时从“{1}”到“{2}”没有准确的转换；位置可能偏差数米或更多</translation>
    </message>
    <message>
        <source>the grid {0} is not here, so places are good to {1} only: the way from &quot;{2}&quot; to &quot;{3}&quot; is {4}</source>
        <translation>没有网格 {0}，因此位置只准到 {1}：从“{2}”到“{3}”的转换为 {4}</translation>
    </message>
    <message>
        <source>the mesh lies {0} {1} the whole structure</source>
        <translation>网格位于整个结构{1} {0} 处</translation>
    </message>
    <message>
        <source>the mesh uses extensions of glTF that are not known and were left out: {0}</source>
        <translation>网格使用了未知的 glTF 扩展，已略去：{0}</translation>
    </message>
    <message>
        <source>the offset in {0} was not added, for the mesh lies at the site without it</source>
        <translation>未加 {0} 中的偏移，因为网格不加偏移即位于场地</translation>
    </message>
    <message>
        <source>the picture does not say how many bits its colours have; {0} were taken and scaled to 8, for its greatest value is {1}</source>
        <translation>影像未写明颜色的位数；因其最大值为 {1}，取 {0} 位并缩放为 8 位</translation>
    </message>
    <message>
        <source>the picture has two bands, and none says what it holds; the first is taken as grey</source>
        <translation>影像有两个波段，均未说明内容；第一个作为灰度</translation>
    </message>
    <message>
        <source>the site lies outside the area of use of &quot;{0}&quot; ({1}) at easting {2}, northing {3}: latitude {4}, longitude {5}</source>
        <translation>场地位于“{0}”的适用范围（{1}）之外：东向 {2}，北向 {3}，即纬度 {4}，经度 {5}</translation>
    </message>
    <message>
        <source>the site lies outside the area of use of &quot;{0}&quot; ({1}) at easting {2}, northing {3}; changed for each other they lie in it</source>
        <translation>场地位于“{0}”的适用范围（{1}）之外：东向 {2}，北向 {3}；两者互换后位于其内</translation>
    </message>
    <message>
        <source>the site lies outside the area of use of &quot;{0}&quot; ({1}) at easting {2}, northing {3}; in {4} they lie in it</source>
        <translation>场地位于“{0}”的适用范围（{1}）之外：东向 {2}，北向 {3}；以 {4} 计则位于其内</translation>
    </message>
    <message>
        <source>the {0} bands of the picture do not say their colours; the first three are taken as red, green and blue</source>
        <translation>影像的 {0} 个波段未写明颜色；前三个作为红、绿、蓝</translation>
    </message>
    <message>
        <source>this node hangs in two places</source>
        <translation>此节点挂在两处</translation>
    </message>
    <message>
        <source>tie the model to it by two control points or more (Site… in the Case menu), or leave the system out</source>
        <translation>请用两个或更多控制点将模型与其联系（“案例”菜单中的“场地…”），或不写坐标系</translation>
    </message>
    <message>
        <source>turn curves and free-form surfaces into polygons before the mesh is exported</source>
        <translation>请在导出网格之前将曲线和自由曲面转为多边形</translation>
    </message>
    <message>
        <source>use two control points or more, or none</source>
        <translation>请采用两个或更多控制点，或都不采用</translation>
    </message>
    <message>
        <source>write it in double precision, or about an origin near the site with that origin as its offset</source>
        <translation>请以双精度写出，或以场地附近的原点写出并以该原点为偏移</translation>
    </message>
    <message>
        <source>{0} curved shapes of the mesh were left out; only polygons are read</source>
        <translation>网格的 {0} 个曲线或曲面已略去；只读取多边形</translation>
    </message>
    <message>
        <source>{0} does not begin as a PLY does</source>
        <translation>{0} 的开头不是 PLY</translation>
    </message>
    <message>
        <source>{0} ends before what it promises</source>
        <translation>{0} 在其声明的内容之前结束</translation>
    </message>
    <message>
        <source>{0} faces of the mesh cross themselves, the first is face {1}; their triangles may not cover what was meant</source>
        <translation>网格有 {0} 个面自相交，首个为第 {1} 个面；其三角形可能并未覆盖本意的区域</translation>
    </message>
    <message>
        <source>{0} faces of the mesh name points that are not there, the first in line {1}; they were left out</source>
        <translation>网格有 {0} 个面引用了不存在的点，首个在第 {1} 行；这些面已略去</translation>
    </message>
    <message>
        <source>{0} faces of the mesh name points that are not there, the first is face {1}; they were left out</source>
        <translation>网格有 {0} 个面引用了不存在的点，首个为第 {1} 个面；这些面已略去</translation>
    </message>
    <message>
        <source>{0} has more than {1} points</source>
        <translation>{0} 的点多于 {1} 个</translation>
    </message>
    <message>
        <source>{0} has no mesh of surroundings that an offset could move.</source>
        <translation>{0} 没有可供偏移的周围环境网格。</translation>
    </message>
    <message>
        <source>{0} holds no faces, only {1} points</source>
        <translation>{0} 没有面，只有 {1} 个点</translation>
    </message>
    <message>
        <source>{0} holds values as large as {1}, which are no colours</source>
        <translation>{0} 的数值大至 {1}，不是颜色</translation>
    </message>
    <message>
        <source>{0} is glTF {1}; version 2.0 is read</source>
        <translation>{0} 为 glTF {1}；可读取 2.0 版</translation>
    </message>
    <message>
        <source>{0} looks like the offset of the mesh, but cannot be read as one</source>
        <translation>{0} 像是网格的偏移，但无法读取</translation>
    </message>
    <message>
        <source>{0} points and lines of the mesh were left out; they have no surface</source>
        <translation>网格的 {0} 个点和线已略去；它们没有表面</translation>
    </message>
    <message>
        <source>{0} promises more numbers than it holds</source>
        <translation>{0} 声明的数值多于其所含</translation>
    </message>
    <message>
        <source>{0} requires extensions of glTF that are not known: {1}</source>
        <translation>{0} 要求未知的 glTF 扩展：{1}</translation>
    </message>
    <message>
        <source>{0}, line {1} is longer than any line of a mesh</source>
        <translation>{0} 第 {1} 行比网格的任何一行都长</translation>
    </message>
    <message>
        <source>{0}, line {1}: &quot;{2}&quot; is no line of the head of a PLY</source>
        <translation>{0} 第 {1} 行：“{2}”不是 PLY 文件头的一行</translation>
    </message>
    <message>
        <source>{0}, line {1}: &quot;{2}&quot; names no corner of a face</source>
        <translation>{0} 第 {1} 行：“{2}”不是面的角点</translation>
    </message>
    <message>
        <source>{0}, line {1}: &quot;{2}&quot; stands where a number should</source>
        <translation>{0} 第 {1} 行：应为数值之处是“{2}”</translation>
    </message>
    <message>
        <source>{0}, line {1}: a coordinate is no number of metres</source>
        <translation>{0} 第 {1} 行：坐标不是以米为单位的数值</translation>
    </message>
    <message>
        <source>{0}, {1}, {2} was added to the coordinates of the mesh, the offset in {3} (its system: {4})</source>
        <translation>网格的坐标已加上 {0}、{1}、{2}，即 {3} 中的偏移（其坐标系：{4}）</translation>
    </message>
    <message>
        <source>{0}: a buffer promises {1} bytes and holds {2}</source>
        <translation>{0}：一个缓冲区声明 {1} 字节，实有 {2} 字节</translation>
    </message>
    <message>
        <source>{0}: a coordinate of point {1} is no number of metres</source>
        <translation>{0}：第 {1} 个点的坐标不是以米为单位的数值</translation>
    </message>
    <message>
        <source>{0}: face {1} has {2} corners; at most {3} are read</source>
        <translation>{0}：第 {1} 个面有 {2} 个角点；至多读取 {3} 个</translation>
    </message>
    <message>
        <source>{0}: none of its {1} faces has an area</source>
        <translation>{0}：其 {1} 个面均无面积</translation>
    </message>
    <message>
        <source>no pixels</source>
        <translation>没有像素</translation>
    </message>
    <message>
        <source>unknown error</source>
        <translation>未知错误</translation>
    </message>
    <message>
        <source>{0}: the head of the PLY does not end, or names no format</source>
        <translation>{0}：PLY 的文件头没有结束，或没有写明格式</translation>
    </message>
    <message>
        <source>Elements have other numbers than before: they were told apart by their nodes</source>
        <translation>单元编号与之前不同：已按其节点区分</translation>
    </message>
    <message>
        <source>Nodes have other numbers than before: they were told apart by their places</source>
        <translation>节点编号与之前不同：已按其位置区分</translation>
    </message>
    <message>
        <source>Let the analysis keep its numbers (libMesh, MOOSE: allow_renumbering = false).</source>
        <translation>让分析保持编号不变（libMesh、MOOSE：allow_renumbering = false）。</translation>
    </message>
    <message>
        <source>Node numbers stand for several places at once: they were not used</source>
        <translation>同一节点编号同时对应多个位置：未使用这些编号</translation>
    </message>
    <message>
        <source>Let each processor write the numbers of the whole model.</source>
        <translation>让每个处理器写出整个模型的编号。</translation>
    </message>
    <message>
        <source>Elements keep their numbers where nodes are split: they keep their first nodes</source>
        <translation>节点分裂处单元编号不变：这些单元保留其最初的节点</translation>
    </message>
    <message>
        <source>Nothing to do: the gap that opens is not shown.</source>
        <translation>无需处理：裂开的缝隙不显示。</translation>
    </message>
    <message>
        <source>Numbers of elements stand for elements at other nodes: these count as new</source>
        <translation>单元编号对应其他节点上的单元：这些单元按新单元计</translation>
    </message>
    <message>
        <source>{0}: at state {1}, {2} of {3} elements have other nodes than the elements of their numbers had before</source>
        <translation>{0}：在状态 {1}，{3} 个单元中有 {2} 个的节点与先前同编号单元的节点不同</translation>
    </message>
    <message>
        <source>Let the analysis keep the numbers of nodes and elements (libMesh, MOOSE: allow_renumbering = false), or write the points at rest with a displacement.</source>
        <translation>让分析保持节点和单元的编号不变（libMesh、MOOSE：allow_renumbering = false），或写出静止时的点及位移。</translation>
    </message>
    <message>
        <source>{0}: state {1} has {2} nodes instead of {3}, and neither numbers nor times that make it a later state</source>
        <translation>{0}：状态 {1} 有 {2} 个节点而不是 {3} 个，既无编号也无时间表明它是后来的状态</translation>
    </message>
    <message>
        <source>Set only_this_file=true, or give a .pvd or .series file with the times.</source>
        <translation>设 only_this_file=on，或给出带时间的 .pvd 或 .series 文件。</translation>
    </message>
    <message>
        <source>Exact times of death were left out: numbers do not stay with their elements</source>
        <translation>未采用精确的失效时刻：编号并不始终属于同一单元</translation>
    </message>
    <message>
        <source>States were written twice at one time: the later one counts</source>
        <translation>同一时刻的状态写了两次：以后写的为准</translation>
    </message>
    <message>
        <source>The analysis went back in time: the states that a restart abandoned were left out</source>
        <translation>分析在时间上退回：重启所放弃的状态已略去</translation>
    </message>
    <message>
        <source>Nothing to do if the later states count; if an earlier run left them behind, move its files away.</source>
        <translation>若以后来的状态为准，无需处理；若是先前计算的遗留，请移走其文件。</translation>
    </message>
    <message>
        <source>Elements are marked as copies of another piece that does not hold them: they were kept</source>
        <translation>单元标为另一分块的副本，而该分块中没有它们：已保留</translation>
    </message>
    <message>
        <source>Check that all pieces of the result are there.</source>
        <translation>检查结果的所有分块是否齐全。</translation>
    </message>
    <message>
        <source>Elements that several pieces hold were taken once</source>
        <translation>多个分块都含有的单元只取一次</translation>
    </message>
    <message>
        <source>Nothing to do: pieces overlap by a layer of copies (ghosts).</source>
        <translation>无需处理：各分块以一层副本（ghost）相重叠。</translation>
    </message>
    <message>
        <source>Points lie where others lie and are nodes of their own: what they belong to is not connected</source>
        <translation>有些点与其他点位置相同却各为节点：它们所属的部分并不相连</translation>
    </message>
    <message>
        <source>Nothing to do for surfaces in contact and cracks; else write the grid without repeated points.</source>
        <translation>若是接触面或裂缝，无需处理；否则请写出不含重复点的网格。</translation>
    </message>
    <message>
        <source>Looking for repeated points</source>
        <translation>正在查找重复的点</translation>
    </message>
    <message>
        <source>Points at one place part at a later state: they stay nodes of their own</source>
        <translation>同一位置的点在以后的状态分开：它们仍各为节点</translation>
    </message>
    <message>
        <source>Nothing to do for surfaces in contact and cracks.</source>
        <translation>若是接触面或裂缝，无需处理。</translation>
    </message>
    <message>
        <source>Points that pieces or cells repeat at every state were taken for one node</source>
        <translation>分块或单元在每个状态都重复的点已视为同一节点</translation>
    </message>
    <message>
        <source>Nothing to do; surfaces in contact stay apart where nodes have numbers (NODE_ID).</source>
        <translation>无需处理；节点有编号（NODE_ID）时，接触面保持分开。</translation>
    </message>
    <message>
        <source>{0} has the time {1} at state {2}, where {3} has {4}: they are no pieces of one result</source>
        <translation>{0} 在状态 {2} 的时间是 {1}，而 {3} 是 {4}：它们不是同一结果的分块</translation>
    </message>
    <message>
        <source>Copy all pieces of one analysis anew.</source>
        <translation>重新复制同一分析的所有分块。</translation>
    </message>
    <message>
        <source>Cells are marked as copies ({0}) from the first state on: the mark was not taken for death</source>
        <translation>单元从第一个状态起就标为副本（{0}）：该标记未当作失效</translation>
    </message>
    <message>
        <source>Open all pieces of the result; if the mark tells death, set status_variable={0}.</source>
        <translation>打开结果的所有分块；若该标记表示失效，请设 status_variable={0}。</translation>
    </message>
    <message>
        <source>Blocks that are no unstructured grid were left out</source>
        <translation>不是非结构网格的块已略去</translation>
    </message>
    <message>
        <source>Write them as unstructured grids if the structure is made of them.</source>
        <translation>若结构由它们组成，请写成非结构网格。</translation>
    </message>
    <message>
        <source>Give a .pvd or .series file with the times, or files with TimeValue; if the files are pieces of one state, their .pvtu or .vtm; if they are no states of one analysis, set only_this_file=true.</source>
        <translation>给出带时间的 .pvd 或 .series 文件，或带 TimeValue 的文件；若这些文件是同一状态的分块，给出其 .pvtu 或 .vtm；若不是同一分析的状态，请设 only_this_file=true。</translation>
    </message>
    <message>
        <source>Write a line /COM,TIME=T into each file; if the files are no states of one analysis, set only_this_file=true.</source>
        <translation>在每个文件中写一行 /COM,TIME=T；若这些文件不是同一分析的状态，请设 only_this_file=on。</translation>
    </message>
    <message>
        <source>The file holds a piece of each state: the whole result was opened</source>
        <translation>该文件含每个状态的一个分块：已打开整个结果</translation>
    </message>
    <message>
        <source>Nothing to do; only_this_file=true opens the piece by itself.</source>
        <translation>无需处理；only_this_file=on 只打开该分块。</translation>
    </message>
    <message>
        <source>Files that differ in a number have other meshes and no times: they were not taken for states</source>
        <translation>只差编号的文件网格不同且无时间：未当作状态</translation>
    </message>
    <message>
        <source>Give a .pvd or .series file with the times if they are states of one analysis.</source>
        <translation>若它们是同一分析的状态，请给出带时间的 .pvd 或 .series 文件。</translation>
    </message>
    <message>
        <source>{0} holds {1} of {2} elements: it is what one of {3} processors wrote</source>
        <translation>{0} 含 {2} 个单元中的 {1} 个：它由 {3} 个处理器之一写出</translation>
    </message>
    <message>
        <source>Put the files of all processors beside it, named NAME.{0}.0 to NAME.{0}.{1}, or join them by epu.</source>
        <translation>把所有处理器的文件放在一起，名为 NAME.{0}.0 至 NAME.{0}.{1}，或用 epu 合并。</translation>
    </message>
    <message>
        <source>{0} is a piece of a result that {1} processors wrote; not there: {2}</source>
        <translation>{0} 是 {1} 个处理器所写结果的一个分块；缺少：{2}</translation>
    </message>
    <message>
        <source>Put all pieces beside each other, or join them by epu.</source>
        <translation>把所有分块放在一起，或用 epu 合并。</translation>
    </message>
    <message>
        <source>{0} is a piece of a distributed analysis: {1} files hold {2} of {3} nodes; not there: {4}</source>
        <translation>{0} 是分布式分析的一个分块：{1} 个文件含 {3} 个节点中的 {2} 个；缺少：{4}</translation>
    </message>
    <message>
        <source>Put the files of all processes (NAME0.rst, NAME1.rst, ...) beside each other, or let Ansys combine them (COMBINE).</source>
        <translation>把所有进程的文件（NAME0.rst、NAME1.rst……）放在一起，或让 Ansys 合并它们（COMBINE）。</translation>
    </message>
    <message>
        <source>indices name each other</source>
        <translation>索引相互引用</translation>
    </message>
    <message>
        <source>its header</source>
        <translation>其文件头</translation>
    </message>
    <message>
        <source>the files behind the last number</source>
        <translation>最后编号之后的文件</translation>
    </message>
    <message>
        <source>.med, .rmed of Salome and code_aster</source>
        <translation>Salome 和 code_aster 的 .med、.rmed</translation>
    </message>
    <message>
        <source>Copy all pieces of the analysis into one folder.</source>
        <translation>请将分析的所有部分复制到同一文件夹。</translation>
    </message>
    <message>
        <source>Set only_this_file=false to open the whole result.</source>
        <translation>设置 only_this_file=false 可打开整个结果。</translation>
    </message>
    <message>
        <source>Copy the file again, and all pieces of a parallel analysis with it.</source>
        <translation>请重新复制该文件，并一并复制并行分析的所有部分。</translation>
    </message>
    <message>
        <source>Elements at nodes that the displacement never reaches were left out</source>
        <translation>略去了节点从无位移的单元</translation>
    </message>
    <message>
        <source>Elements that are no structure were left out: springs, contacts, loads, links</source>
        <translation>略去了不属于结构的单元：弹簧、接触、荷载、连接</translation>
    </message>
    <message>
        <source>Elements that were removed before the clock was set back are not in the result</source>
        <translation>时钟拨回之前移除的单元不在结果中</translation>
    </message>
    <message>
        <source>Faces and edges of other elements that carry no results were left out</source>
        <translation>略去了没有结果的其他单元的面和边</translation>
    </message>
    <message>
        <source>Fields on elements: {0}</source>
        <translation>单元上的场：{0}</translation>
    </message>
    <message>
        <source>Frames in a plane mostly have y up: --set up_axis=y.</source>
        <translation>平面框架多以 y 为向上：--set up_axis=y。</translation>
    </message>
    <message>
        <source>If elements died, put a list of deaths beside the FE result or name its active flag (status_variable).</source>
        <translation>若有单元失效，请在有限元结果旁放置失效清单，或指定其激活标志（status_variable）。</translation>
    </message>
    <message>
        <source>If the model of the analysis did not change there, put a list of deaths (element,time) beside it.</source>
        <translation>若分析的模型在该处没有改变，请在旁边放置失效清单（单元，时刻）。</translation>
    </message>
    <message>
        <source>If they are shells or bars of the structure, let the analysis write a field on them (SIEF_ELGA).</source>
        <translation>若它们是结构的壳或杆，请让分析为其写出一个场（SIEF_ELGA）。</translation>
    </message>
    <message>
        <source>It says which elements were removed and when, but has no mesh: record the analysis with &quot;recorder mpco&quot;, &quot;recorder vtkhdf&quot; or &quot;recorder pvd&quot; as well and give that file.</source>
        <translation>它说明哪些单元在何时移除，但没有网格：请再用“recorder mpco”“recorder vtkhdf”或“recorder pvd”记录分析并给出该文件。</translation>
    </message>
    <message>
        <source>Let the analysis go on without setting the clock back (loadConst without -time).</source>
        <translation>请让分析继续而不拨回时钟（loadConst 不带 -time）。</translation>
    </message>
    <message>
        <source>Let the analysis write mesh and fields into one file.</source>
        <translation>请让分析将网格和场写入同一文件。</translation>
    </message>
    <message>
        <source>Name it: --set displacement=NAME; displacement=none if the nodes do not move. Fields in the file: {0}</source>
        <translation>请指定：--set displacement=NAME；若节点不移动则为 displacement=none。文件中的场：{0}</translation>
    </message>
    <message>
        <source>Name the displacement of the one that you want: --set displacement=NAME.</source>
        <translation>请指定所需结果的位移：--set displacement=NAME。</translation>
    </message>
    <message>
        <source>No element dies in this result: there is no debris to map.</source>
        <translation>此结果中没有单元失效：没有可制图的堆积物。</translation>
    </message>
    <message>
        <source>Nothing to do if the analysis was gone on with from an earlier time.</source>
        <translation>若分析是从较早的时刻继续的，则无需处理。</translation>
    </message>
    <message>
        <source>Nothing to do if the model does not have them.</source>
        <translation>若模型不含它们，则无需处理。</translation>
    </message>
    <message>
        <source>Nothing to do if they are masses, springs or points.</source>
        <translation>若它们是质量、弹簧或点，则无需处理。</translation>
    </message>
    <message>
        <source>Nothing to do if they are none.</source>
        <translation>若它们确非结构，则无需处理。</translation>
    </message>
    <message>
        <source>Nothing to do if they only applied the loads, such as gravity.</source>
        <translation>若它们只用于施加荷载（如重力），则无需处理。</translation>
    </message>
    <message>
        <source>One piece of a parallel analysis was read as the whole</source>
        <translation>并行分析的一个部分被当作整体读取</translation>
    </message>
    <message>
        <source>Open the result again once all processes have written them.</source>
        <translation>请在所有进程写完后再次打开结果。</translation>
    </message>
    <message>
        <source>OpenSees MPCO</source>
        <translation>OpenSees MPCO</translation>
    </message>
    <message>
        <source>Record it: recorder mpco FILE -N displacement velocity. Nodal results in the file: {0}. With displacement=none its stages are the states and nothing moves.</source>
        <translation>请记录位移：recorder mpco FILE -N displacement velocity。文件中的节点结果：{0}。用 displacement=none 时以其阶段为状态，且没有移动。</translation>
    </message>
    <message>
        <source>States at times that a later state has or has passed again were dropped</source>
        <translation>略去了时刻与后来状态相同或又被越过的状态</translation>
    </message>
    <message>
        <source>States that not all pieces hold were left out</source>
        <translation>略去了并非所有部分都有的状态</translation>
    </message>
    <message>
        <source>The clock of the analysis was set back: earlier states at the same times were dropped</source>
        <translation>分析的时钟曾被拨回：略去了之前相同时刻的状态</translation>
    </message>
    <message>
        <source>The file does not say which elements are dead: those that a state leaves out of its fields were taken</source>
        <translation>文件没有说明哪些单元失效：取了某状态的场所略去的单元</translation>
    </message>
    <message>
        <source>The file holds further results, which were not read</source>
        <translation>文件中还有其他结果，未予读取</translation>
    </message>
    <message>
        <source>The mesh itself has several steps: the first was taken for all states</source>
        <translation>网格本身有多个步：所有状态都取了第一步</translation>
    </message>
    <message>
        <source>The model is plane: the third coordinate of its nodes was taken as zero</source>
        <translation>模型是平面的：其节点的第三个坐标取为零</translation>
    </message>
    <message>
        <source>Write it as an unstructured mesh.</source>
        <translation>请写成非结构网格。</translation>
    </message>
    <message>
        <source>Write the elements that are dead into a field, or a list of deaths.</source>
        <translation>请将失效的单元写入一个场或失效清单。</translation>
    </message>
    <message>
        <source>a table of results</source>
        <translation>结果表</translation>
    </message>
    <message>
        <source>components of fields</source>
        <translation>场的分量</translation>
    </message>
    <message>
        <source>coordinates of nodes</source>
        <translation>节点坐标</translation>
    </message>
    <message>
        <source>no group</source>
        <translation>无组</translation>
    </message>
    <message>
        <source>the library does not open it</source>
        <translation>库无法打开它</translation>
    </message>
    <message>
        <source>values on elements</source>
        <translation>单元上的值</translation>
    </message>
    <message>
        <source>{0} cannot be read as MED: {1}</source>
        <translation>{0} 无法作为 MED 读取：{1}</translation>
    </message>
    <message>
        <source>{0} has no displacement of the nodes under a known name</source>
        <translation>{0} 没有已知名称的节点位移</translation>
    </message>
    <message>
        <source>{0} has no field &quot;{1}&quot; of vectors on nodes</source>
        <translation>{0} 没有节点上的矢量场“{1}”</translation>
    </message>
    <message>
        <source>{0} has no field &quot;{1}&quot; on elements</source>
        <translation>{0} 没有单元上的场“{1}”</translation>
    </message>
    <message>
        <source>{0} has no mesh &quot;{1}&quot;</source>
        <translation>{0} 没有网格“{1}”</translation>
    </message>
    <message>
        <source>{0} has no states with displacements of the nodes</source>
        <translation>{0} 没有含节点位移的状态</translation>
    </message>
    <message>
        <source>{0} has no states with the nodal result &quot;{1}&quot;</source>
        <translation>{0} 没有含节点结果“{1}”的状态</translation>
    </message>
    <message>
        <source>{0} is a piece of a parallel analysis; beside it is missing {1}</source>
        <translation>{0} 是并行分析的一个部分；旁边缺少 {1}</translation>
    </message>
    <message>
        <source>{0} is damaged so that the MED library fails on it</source>
        <translation>{0} 已损坏，MED 库在其上失败</translation>
    </message>
    <message>
        <source>{0} is no MPCO file that can be read: {1}</source>
        <translation>{0} 不是可读取的 MPCO 文件：{1}</translation>
    </message>
    <message>
        <source>{0}: element {1} uses node {2} of {3}</source>
        <translation>{0}：单元 {1} 使用节点 {2}，共 {3} 个</translation>
    </message>
    <message>
        <source>{0}: the mesh {1} is no unstructured one in Cartesian coordinates</source>
        <translation>{0}：网格 {1} 不是笛卡尔坐标的非结构网格</translation>
    </message>
    <message>
        <source>{0}: {1} uses the node {2}, which is not there</source>
        <translation>{0}：{1} 使用不存在的节点 {2}</translation>
    </message>
    <message>
        <source>it is of a version of MED that the library does not know</source>
        <translation>它属于库所不知的 MED 版本</translation>
    </message>
    <message>
        <source>its fields</source>
        <translation>其场</translation>
    </message>
    <message>
        <source>its meshes</source>
        <translation>其网格</translation>
    </message>
    <message>
        <source>steps of its mesh</source>
        <translation>其网格的步</translation>
    </message>
    <message>
        <source>Check the area of interest and what is left out, their coordinate systems and that of the case.</source>
        <translation>检查关注区域和略去的部分、它们的坐标系以及案例的坐标系。</translation>
    </message>
    <message>
        <source>Check the coordinate systems of area, survey and case, the origin of the frame and the control points.</source>
        <translation>检查区域、测绘和案例的坐标系、坐标框架的原点以及控制点。</translation>
    </message>
    <message>
        <source>None of the {0} cells that were surveyed is compared: the area of interest reaches from x = {1} to {2}, y = {3} to {4}</source>
        <translation>{0} 个测绘单元都不参与比较：关注区域范围为 x = {1} 至 {2}，y = {3} 至 {4}</translation>
    </message>
    <message>
        <source>What is compared of {0} holds none of its {1} cells with debris</source>
        <translation>{0} 的比较范围不含其 {1} 个有堆积物的单元中的任何一个</translation>
    </message>
    <message>
        <source>What is left out holds all {0} cells that were surveyed</source>
        <translation>略去的部分包含全部 {0} 个测绘单元</translation>
    </message>
    <message>
        <source>all that was surveyed</source>
        <translation>测绘的全部</translation>
    </message>
    <message>
        <source>all {0} of simulated debris lie outside of what is compared</source>
        <translation>全部 {0} 模拟堆积物都在比较范围之外</translation>
    </message>
    <message>
        <source>an area of interest</source>
        <translation>关注区域</translation>
    </message>
    <message>
        <source>check place, time, unit and vertical datum of the survey, or register it to the ground</source>
        <translation>检查测绘的地点、时间、单位和高程基准，或将其配准到地面</translation>
    </message>
    <message>
        <source>check the area of interest, its coordinate system and that of the case</source>
        <translation>检查关注区域、其坐标系和案例的坐标系</translation>
    </message>
    <message>
        <source>far from all simulated debris the survey lies {0} above the ground, in the median of {1} cells</source>
        <translation>在远离所有模拟堆积物处，测绘高于地面 {0}（{1} 个单元的中位数）</translation>
    </message>
    <message>
        <source>far from all simulated debris the survey lies {0} below the ground, in the median of {1} cells</source>
        <translation>在远离所有模拟堆积物处，测绘低于地面 {0}（{1} 个单元的中位数）</translation>
    </message>
    <message>
        <source>give a finer raster, or turn the local frame by control points so that its axes run along the rows, if that is too much</source>
        <translation>若相差过大，请给出更细的栅格，或用控制点旋转局部坐标框架，使其轴沿栅格的行</translation>
    </message>
    <message>
        <source>heights count from {0} on, the level of detection, and not from the least height of {1}: what lies lower may be noise</source>
        <translation>高度从检测限 {0} 起计入，而不是从最小高度 {1} 起：更低者可能只是噪声</translation>
    </message>
    <message>
        <source>metres, not below zero</source>
        <translation>以米为单位且不小于零的数</translation>
    </message>
    <message>
        <source>none is needed; what lies between two heights is not known better</source>
        <translation>无需处理；两个高程之间的情况无从更好得知</translation>
    </message>
    <message>
        <source>one ring or more</source>
        <translation>一个或更多的环</translation>
    </message>
    <message>
        <source>rows of the raster do not run along x and y: its heights are kept, and laid on the cells as they lie; neighbours differ by {0} at most, 95 % of them by less than {1}</source>
        <translation>栅格的行不沿 x 和 y：其高程保持不变，按其所在位置放到单元上；相邻高程最多相差 {0}，其中 95 % 小于 {1}</translation>
    </message>
    <message>
        <source>rows of the raster do not run along x and y: its heights were interpolated once, to cells of {0}; of {1} heights of the file that were looked at the surface then lies {2} off at most, 95 % are within {3}</source>
        <translation>栅格的行不沿 x 和 y：其高程插值一次，成为 {0} 的单元；所查看的文件中 {1} 个高程与所得表面最多相差 {2}，其中 95 % 在 {3} 以内</translation>
    </message>
    <message>
        <source>state the noise of survey and ground if it is less, or register the survey to the ground</source>
        <translation>若测绘和地面的噪声较小，请给定，或将测绘配准到地面</translation>
    </message>
    <message>
        <source>{0} of what was surveyed lie apart from all simulated debris, {1} to {2} away, in {3} places; the largest is around x = {4}, y = {5}</source>
        <translation>测得的 {0} 远离所有模拟堆积物，相距 {1} 至 {2}，共 {3} 处；最大者在 x = {4}、y = {5} 附近</translation>
    </message>
    <message>
        <source>Copy the later mesh into another folder to open it by itself.</source>
        <translation>将后来的网格复制到另一个文件夹，单独打开。</translation>
    </message>
    <message>
        <source>Copy the missing files.</source>
        <translation>复制缺少的文件。</translation>
    </message>
    <message>
        <source>Files that belong to the family stand behind a missing number; they were not read</source>
        <translation>属于该系列的文件位于缺号之后；未读取</translation>
    </message>
    <message>
        <source>Later meshes of a run with particles were not read</source>
        <translation>含粒子的计算的后来网格未读取</translation>
    </message>
    <message>
        <source>Meshes of an adaptive run were joined: what was refined keeps its first elements</source>
        <translation>自适应计算的各网格已合并：被细分者保留其最初的单元</translation>
    </message>
    <message>
        <source>Nothing to do; deaths of parts of a refined element show when all have died.</source>
        <translation>无需处理；细分单元的各部分全部失效时，才显示其失效。</translation>
    </message>
    <message>
        <source>the library complains of it</source>
        <translation>库报告其有误</translation>
    </message>
    <message>
        <source>the time of a state</source>
        <translation>某状态的时刻</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; is no column of a point cloud</source>
        <translation>“{0}”不是点云的列</translation>
    </message>
    <message>
        <source>&quot;{0}&quot; names no coordinate system</source>
        <translation>“{0}”不是坐标系的名称</translation>
    </message>
    <message>
        <source>Check that the file is what its name says.</source>
        <translation>请检查文件是否与其名称相符。</translation>
    </message>
    <message>
        <source>Check the disk that it lies on, or copy it to another.</source>
        <translation>请检查它所在的磁盘，或把它复制到另一磁盘。</translation>
    </message>
    <message>
        <source>Copy it again from where it came, or export the scans anew.</source>
        <translation>请从来源重新复制，或重新导出测站。</translation>
    </message>
    <message>
        <source>Export the points anew as PCD 0.7.</source>
        <translation>请把点重新导出为 PCD 0.7。</translation>
    </message>
    <message>
        <source>Export the points anew as PLY with x, y and z.</source>
        <translation>请把点重新导出为含 x、y 和 z 的 PLY。</translation>
    </message>
    <message>
        <source>Export the scans anew as PTX or E57.</source>
        <translation>请把测站重新导出为 PTX 或 E57。</translation>
    </message>
    <message>
        <source>GeoTIFF keys</source>
        <translation>GeoTIFF 键</translation>
    </message>
    <message>
        <source>Give a LAS, LAZ, E57, PLY, PCD, PTX or PTS, or a table of text with columns x, y and z.</source>
        <translation>请给出 LAS、LAZ、E57、PLY、PCD、PTX 或 PTS，或含 x、y 和 z 列的文本表格。</translation>
    </message>
    <message>
        <source>Give an EPSG code such as EPSG:25832, WKT or PROJ.</source>
        <translation>请给出 EPSG 代码（如 EPSG:25832）、WKT 或 PROJ。</translation>
    </message>
    <message>
        <source>Give x, y, z and what there is of intensity, red, green, blue, class, return, returns, time; skip for others.</source>
        <translation>请给出 x、y、z 以及有的 intensity、red、green、blue、class、return、returns、time；其他列写 skip。</translation>
    </message>
    <message>
        <source>Name each column in its order, such as x,y,z,intensity.</source>
        <translation>请按次序写出每一列，如 x,y,z,intensity。</translation>
    </message>
    <message>
        <source>Part it into several files.</source>
        <translation>请把它分成几个文件。</translation>
    </message>
    <message>
        <source>Reading the points</source>
        <translation>正在读取点</translation>
    </message>
    <message>
        <source>The columns do not name x, y and z</source>
        <translation>各列未写明 x、y 和 z</translation>
    </message>
    <message>
        <source>The file may be damaged: copy it again from where it came, or write it anew as LAS 1.4.</source>
        <translation>文件可能已损坏：请从来源重新复制，或重新写成 LAS 1.4。</translation>
    </message>
    <message>
        <source>There is no point cloud {0} that may be read</source>
        <translation>没有可读取的点云 {0}</translation>
    </message>
    <message>
        <source>Unpack it to LAS, or pack it anew with LASzip 2.0 or later.</source>
        <translation>请解压为 LAS，或用 LASzip 2.0 或更高版本重新压缩。</translation>
    </message>
    <message>
        <source>Write it anew as E57 1.0.</source>
        <translation>请重新写成 E57 1.0。</translation>
    </message>
    <message>
        <source>asked for</source>
        <translation>按请求</translation>
    </message>
    <message>
        <source>bring it to a projected system, such as the UTM zone of the place, before it is used with a case</source>
        <translation>与案例一起使用前，请先转换到投影坐标系，如当地的 UTM 带</translation>
    </message>
    <message>
        <source>bytes, big end first</source>
        <translation>二进制，高位在前</translation>
    </message>
    <message>
        <source>bytes, little end first</source>
        <translation>二进制，低位在前</translation>
    </message>
    <message>
        <source>check the coordinate system; it may have stood in one of them</source>
        <translation>请检查坐标系；它可能就写在其中一条记录里</translation>
    </message>
    <message>
        <source>colours reach {0} of 65,535: they are taken as colours of 8 bits</source>
        <translation>颜色最大为 {0}（满值 65,535）：按 8 位颜色处理</translation>
    </message>
    <message>
        <source>compare a length in the cloud with what is known, and export the scans anew</source>
        <translation>请把点云中的一段长度与已知值比较，并重新导出测站</translation>
    </message>
    <message>
        <source>compare the range of heights with what is known of the place; have the file written with a vertical system</source>
        <translation>请把高程范围与当地已知的高程比较；请让文件写明高程系统</translation>
    </message>
    <message>
        <source>compare the scans where they overlap, and export them anew</source>
        <translation>请在重叠处比较各测站，并重新导出</translation>
    </message>
    <message>
        <source>every point is of a class of vegetation: the cloud shows neither ground nor debris</source>
        <translation>所有的点都属于植被类别：点云既未显示地面，也未显示堆积物</translation>
    </message>
    <message>
        <source>extra bytes</source>
        <translation>附加字节</translation>
    </message>
    <message>
        <source>give a cloud that has points, and check what was left out and why</source>
        <translation>请给出有点的点云，并检查略去了什么、为什么</translation>
    </message>
    <message>
        <source>give the cloud with its ground, or without classes if they are wrong</source>
        <translation>请给出带地面点的点云；类别有误时请去掉类别</translation>
    </message>
    <message>
        <source>give them another class in a program for point clouds if they are to count</source>
        <translation>如果它们应当计入，请在点云程序中给它们另一类别</translation>
    </message>
    <message>
        <source>have it written in double precision, or about an origin near the site</source>
        <translation>请按双精度写出，或以场地附近的点为原点写出</translation>
    </message>
    <message>
        <source>if they count from the scanner, place the cloud by hand</source>
        <translation>如果坐标从扫描仪算起，请手工放置点云</translation>
    </message>
    <message>
        <source>it has no element vertex</source>
        <translation>其中没有 vertex 元素</translation>
    </message>
    <message>
        <source>its head says that the points are packed, and not how</source>
        <translation>文件头说点已压缩，但未说明方式</translation>
    </message>
    <message>
        <source>its packed bytes are damaged</source>
        <translation>压缩的字节已损坏</translation>
    </message>
    <message>
        <source>its parts are not those of its points</source>
        <translation>压缩的各部分与其点格式不符</translation>
    </message>
    <message>
        <source>its points are packed by a codec of another program</source>
        <translation>点由另一程序的编码压缩</translation>
    </message>
    <message>
        <source>its points have no x, y and z</source>
        <translation>点没有 x、y 和 z</translation>
    </message>
    <message>
        <source>laszip encoded</source>
        <translation>laszip encoded</translation>
    </message>
    <message>
        <source>leave the system away, or have the file written anew with the right one</source>
        <translation>请不要指定坐标系，或让文件以正确的坐标系重新写出</translation>
    </message>
    <message>
        <source>lists stand in front of its points</source>
        <translation>点之前有列表</translation>
    </message>
    <message>
        <source>look at the file in an editor; export it anew if these are points</source>
        <translation>请用编辑器查看文件；如果这些是点，请重新导出</translation>
    </message>
    <message>
        <source>name the system, such as EPSG:25832</source>
        <translation>请写明坐标系，如 EPSG:25832</translation>
    </message>
    <message>
        <source>name the system, such as EPSG:25832, or check the bounds against something whose length is known</source>
        <translation>请写明坐标系，如 EPSG:25832，或用长度已知的物体核对范围</translation>
    </message>
    <message>
        <source>name the system, such as EPSG:4326, if they are degrees</source>
        <translation>如果是度，请写明坐标系，如 EPSG:4326</translation>
    </message>
    <message>
        <source>near infrared</source>
        <translation>近红外</translation>
    </message>
    <message>
        <source>no heading names the columns; the first three are taken as x, y and z</source>
        <translation>没有表头写明各列；前三列按 x、y 和 z 处理</translation>
    </message>
    <message>
        <source>no point is left of the cloud</source>
        <translation>点云中没有剩下任何点</translation>
    </message>
    <message>
        <source>none is needed if its corners are as dense as a scan; else give it as a mesh of the surroundings</source>
        <translation>顶点与扫描一样密时无需处理；否则请作为周围环境的网格给出</translation>
    </message>
    <message>
        <source>none is needed if the other scans are what is wanted</source>
        <translation>如果需要的是其他测站，则无需处理</translation>
    </message>
    <message>
        <source>none is needed if the picture is as bright as it should be</source>
        <translation>如果图像亮度正常，则无需处理</translation>
    </message>
    <message>
        <source>none is needed if the program that wrote the file marks gaps so</source>
        <translation>如果写文件的程序这样标记空缺，则无需处理</translation>
    </message>
    <message>
        <source>none is needed: their scanner saw nothing there</source>
        <translation>无需处理：扫描仪在那里什么也没有看到</translation>
    </message>
    <message>
        <source>none is needed; if they are places, shift the cloud by a whole number of metres</source>
        <translation>无需处理；如果它们是真实位置，请把点云平移整数米</translation>
    </message>
    <message>
        <source>number of returns</source>
        <translation>回波总数</translation>
    </message>
    <message>
        <source>parted by blanks</source>
        <translation>以空格分隔</translation>
    </message>
    <message>
        <source>places count from the centre of the Earth: z is not up</source>
        <translation>坐标从地心算起：z 不朝上</translation>
    </message>
    <message>
        <source>points at 0, 0, 0 were left out: scanners write there what gave no echo</source>
        <translation>位于 0, 0, 0 的点已略去：扫描仪把没有回波的点写在那里</translation>
    </message>
    <message>
        <source>points of the noise classes 7 and 18 were left out</source>
        <translation>噪声类别 7 和 18 的点已略去</translation>
    </message>
    <message>
        <source>points that the file marks as invalid were left out</source>
        <translation>文件标为无效的点已略去</translation>
    </message>
    <message>
        <source>points that the file marks as withheld were left out</source>
        <translation>文件标为撤回的点已略去</translation>
    </message>
    <message>
        <source>points with a coordinate that is no finite number were left out</source>
        <translation>坐标不是有限数的点已略去</translation>
    </message>
    <message>
        <source>records of the head that cannot be as long as they say were left out</source>
        <translation>长度不可能如其所述的文件头记录已略去</translation>
    </message>
    <message>
        <source>return number</source>
        <translation>回波序号</translation>
    </message>
    <message>
        <source>scans without places of their points were left out</source>
        <translation>点没有位置的测站已略去</translation>
    </message>
    <message>
        <source>state the columns, such as x,y,z,intensity</source>
        <translation>请写明各列，如 x,y,z,intensity</translation>
    </message>
    <message>
        <source>take the mark off in a program for point clouds if they are to count</source>
        <translation>如果它们应当计入，请在点云程序中去掉标记</translation>
    </message>
    <message>
        <source>the bounds in the head are up to {0} units off those of the points</source>
        <translation>文件头中的范围与点的范围最多相差 {0} 个单位</translation>
    </message>
    <message>
        <source>the coordinate system of the file cannot be read; its numbers are taken as metres</source>
        <translation>文件的坐标系无法读取；其数值按米处理</translation>
    </message>
    <message>
        <source>the file does not say the unit of its heights; one is taken as {0}</source>
        <translation>文件未写明高程的单位；一个单位按 {0} 处理</translation>
    </message>
    <message>
        <source>the file is a mesh; its corners are taken as points, its faces are left out</source>
        <translation>文件是网格；其顶点作为点，其面已略去</translation>
    </message>
    <message>
        <source>the file may be cut short: compare the number of points with that of the head</source>
        <translation>文件可能被截短：请把点数与文件头中的比较</translation>
    </message>
    <message>
        <source>the file may be cut short: copy it again from where it came</source>
        <translation>文件可能被截短：请从来源重新复制</translation>
    </message>
    <message>
        <source>the file names its coordinate system, so {0} was not taken</source>
        <translation>文件写明了坐标系，因此未采用 {0}</translation>
    </message>
    <message>
        <source>the file names no coordinate system; its numbers are taken as metres</source>
        <translation>文件未写明坐标系；其数值按米处理</translation>
    </message>
    <message>
        <source>the file names where its scanner stood; its points are taken as placed already</source>
        <translation>文件写明了扫描仪的位置；其点按已就位处理</translation>
    </message>
    <message>
        <source>the head says {0} points, the file has {1}</source>
        <translation>文件头说有 {0} 个点，文件中有 {1} 个</translation>
    </message>
    <message>
        <source>the matrix of a scan scales or shears; it was applied as it is</source>
        <translation>测站的矩阵含缩放或剪切；已照原样应用</translation>
    </message>
    <message>
        <source>the points are taken; do not part this cloud by time</source>
        <translation>点已采用；请不要按时间拆分此点云</translation>
    </message>
    <message>
        <source>the rotation of a pose is no rotation; it was brought to one, or left out</source>
        <translation>位姿的旋转不是旋转；已化为旋转或略去</translation>
    </message>
    <message>
        <source>the table of chunks is missing or does not fit the head; chunks were read one after another as far as they go</source>
        <translation>块表缺失或与文件头不符；已逐块读到能读之处</translation>
    </message>
    <message>
        <source>those of the points are used; have the head written anew if other programs need it</source>
        <translation>采用点的范围；其他程序需要时请重新写出文件头</translation>
    </message>
    <message>
        <source>times of points are no finite numbers</source>
        <translation>点的时间不是有限数</translation>
    </message>
    <message>
        <source>visual reference</source>
        <translation>visual reference</translation>
    </message>
    <message>
        <source>wave forms</source>
        <translation>波形</translation>
    </message>
    <message>
        <source>x and y are as small and as fine as degrees are, but are taken as metres</source>
        <translation>x 和 y 像度一样小而细，但按米处理</translation>
    </message>
    <message>
        <source>x and y are degrees of longitude and latitude, no lengths: the cloud has no size in metres</source>
        <translation>x 和 y 是经纬度，不是长度：点云没有以米计的大小</translation>
    </message>
    <message>
        <source>{0} has points of format {1}, which LAS 1.0 to 1.4 do not know</source>
        <translation>{0} 的点格式为 {1}，LAS 1.0 至 1.4 没有这种格式</translation>
    </message>
    <message>
        <source>{0} holds {1} scans; 65,535 can be read</source>
        <translation>{0} 有 {1} 个测站；可读取 65,535 个</translation>
    </message>
    <message>
        <source>{0} is E57 {1} with pages of {2} bytes, which cannot be read</source>
        <translation>{0} 是页长 {2} 字节的 E57 {1}，无法读取</translation>
    </message>
    <message>
        <source>{0} is LAS {1}.{2}; 1.0 to 1.4 can be read</source>
        <translation>{0} 是 LAS {1}.{2}；可读取 1.0 至 1.4</translation>
    </message>
    <message>
        <source>{0} is damaged: no packet of points can be read at byte {1} of its content</source>
        <translation>{0} 已损坏：内容第 {1} 字节处读不出点的数据包</translation>
    </message>
    <message>
        <source>{0} is damaged: page {1} of {2} does not fit its checksum</source>
        <translation>{0} 已损坏：第 {1} 页（共 {2} 页）与其校验和不符</translation>
    </message>
    <message>
        <source>{0} is damaged: the packed points behind point {1} cannot be unpacked</source>
        <translation>{0} 已损坏：点 {1} 之后的压缩点无法解压</translation>
    </message>
    <message>
        <source>{0} is no PCD that can be read: {1}</source>
        <translation>{0} 不是可读取的 PCD：{1}</translation>
    </message>
    <message>
        <source>{0} is no point cloud that can be read</source>
        <translation>{0} 不是可读取的点云</translation>
    </message>
    <message>
        <source>{0} is no point cloud that can be read: {1}</source>
        <translation>{0} 不是可读取的点云：{1}</translation>
    </message>
    <message>
        <source>{0} is packed in a way that cannot be read: {1}</source>
        <translation>{0} 的压缩方式无法读取：{1}</translation>
    </message>
    <message>
        <source>{0} promises more than it holds</source>
        <translation>{0} 声明的内容多于实有</translation>
    </message>
    <message>
        <source>{0}: a line is longer than any of a point cloud</source>
        <translation>{0}：有一行比点云的任何行都长</translation>
    </message>
    <message>
        <source>{0}: a point takes {1} bytes, less than the {2} of its format {3}</source>
        <translation>{0}：一个点占 {1} 字节，少于其格式 {3} 的 {2} 字节</translation>
    </message>
    <message>
        <source>{0}: scale or offset of the coordinates is no number that can be used</source>
        <translation>{0}：坐标的比例或偏移不是可用的数</translation>
    </message>
    <message>
        <source>{0}: scan {1} does not begin with columns, rows, a scanner and a matrix</source>
        <translation>{0}：测站 {1} 不以列数、行数、扫描仪和矩阵开头</translation>
    </message>
    <message>
        <source>{0}: the head says that its points begin inside it, at byte {1}</source>
        <translation>{0}：文件头说点从它内部的第 {1} 字节开始</translation>
    </message>
    <message>
        <source>{0}: the table of its chunks is missing or damaged, and nothing else tells them apart</source>
        <translation>{0}：块表缺失或损坏，没有别的办法区分各块</translation>
    </message>
    <message>
        <source>look whether the scans fit together; export them anew with their registration</source>
        <translation>请查看各测站是否吻合；请连同配准重新导出</translation>
    </message>
    <message>
        <source>scans without a pose are taken as placed already</source>
        <translation>没有位姿的测站按已就位处理</translation>
    </message>
    <message>
        <source>have it written anew as LAS 1.4 or LAZ without the compatibility mode</source>
        <translation>请不用兼容模式、重新写成 LAS 1.4 或 LAZ</translation>
    </message>
    <message>
        <source>points of LAS 1.4 were written as older ones: classes above 31 and echoes beyond the seventh are not read</source>
        <translation>LAS 1.4 的点按旧格式写出：大于 31 的类别和第七次之后的回波未读取</translation>
    </message>
    <message>
        <source>place the cloud by points that are known in it and in the case</source>
        <translation>请用在点云和案例中都已知的点来放置点云</translation>
    </message>
    <message>
        <source>the coordinate system of the file is no place on Earth; a unit of it is {0}</source>
        <translation>文件的坐标系不对应地球上的位置；其一个单位为 {0}</translation>
    </message>
    <message>
        <source>A set is a folder with README.md, LICENSE, a table, and set.json that says what its columns mean; the manual has an example.</source>
        <translation>数据组是一个文件夹，含 README.md、LICENSE、一张表和说明各列含义的 set.json；手册中有示例。</translation>
    </message>
    <message>
        <source>Add the line there, or take the body out of the table.</source>
        <translation>请在那里补上这一行，或从表中去掉该物体。</translation>
    </message>
    <message>
        <source>Correct the heading, or what set.json says of it.</source>
        <translation>请更正表头，或 set.json 对它的说明。</translation>
    </message>
    <message>
        <source>Correct the line, or take the body out of the table.</source>
        <translation>请更正这一行，或从表中去掉该物体。</translation>
    </message>
    <message>
        <source>Correct z, or the datum of one of the two, or write &quot;lifted&quot;: true into set.json.</source>
        <translation>请更正 z 或两者之一的基准面，或在 set.json 中写 &quot;lifted&quot;: true。</translation>
    </message>
    <message>
        <source>Give a heading and one line for each body.</source>
        <translation>请给出表头，并为每个物体写一行。</translation>
    </message>
    <message>
        <source>Give a terrain that covers them, in the same coordinates, or correct their x and y.</source>
        <translation>请给出以同样坐标覆盖它们的地形，或更正它们的 x 和 y。</translation>
    </message>
    <message>
        <source>Give each body an id of its own.</source>
        <translation>请给每个物体各自的标识。</translation>
    </message>
    <message>
        <source>Keep one line for each.</source>
        <translation>请各保留一行。</translation>
    </message>
    <message>
        <source>Keep one of the two.</source>
        <translation>请保留两者之一。</translation>
    </message>
    <message>
        <source>Keep the columns of one of the two.</source>
        <translation>请保留两者之一的各列。</translation>
    </message>
    <message>
        <source>Name it {0}_world_rad_s or {0}_body_rad_s: about the axes of the table or the body&apos;s.</source>
        <translation>请命名为 {0}_world_rad_s 或 {0}_body_rad_s：绕表的坐标轴或绕物体自身的轴。</translation>
    </message>
    <message>
        <source>Name one of {0}, or leave the field empty.</source>
        <translation>请写 {0} 之一，或让该格为空。</translation>
    </message>
    <message>
        <source>Name the columns of the measured places under columns.</source>
        <translation>请在 columns 下写明实测位置的各列。</translation>
    </message>
    <message>
        <source>Name the folder of a set, or one that holds such folders.</source>
        <translation>请给出数据组的文件夹，或含有这类文件夹的文件夹。</translation>
    </message>
    <message>
        <source>Put the licence of the data beside it, as a file LICENSE.</source>
        <translation>请将数据的许可作为文件 LICENSE 放在旁边。</translation>
    </message>
    <message>
        <source>Table of bodies</source>
        <translation>物体表</translation>
    </message>
    <message>
        <source>The set {0} has no licence: nobody knows whether it may be used</source>
        <translation>数据组 {0} 没有许可：无法知道是否可以使用</translation>
    </message>
    <message>
        <source>There is no folder {0}</source>
        <translation>没有文件夹 {0}</translation>
    </message>
    <message>
        <source>Write unit quaternions, {0}qw first.</source>
        <translation>请写单位四元数，{0}qw 在前。</translation>
    </message>
    <message>
        <source>Write {0} and one of these behind it, with a line between: {1}.</source>
        <translation>请写 {0}，其后以下划线接以下之一：{1}。</translation>
    </message>
    <message>
        <source>add the column material: stone, concrete, steel or masonry</source>
        <translation>添加 material 列：stone、concrete、steel 或 masonry</translation>
    </message>
    <message>
        <source>add the columns qw, qx, qy and qz, or turn them at random</source>
        <translation>添加 qw、qx、qy 和 qz 列，或随机转动它们</translation>
    </message>
    <message>
        <source>add the columns vx_m_s, vy_m_s and vz_m_s if they move</source>
        <translation>如果它们在运动，请添加 vx_m_s、vy_m_s 和 vz_m_s 列</translation>
    </message>
    <message>
        <source>add the columns wx_world_rad_s and so on, or wx_body_rad_s and so on, if they turn</source>
        <translation>如果它们在转动，请添加 wx_world_rad_s 等列，或 wx_body_rad_s 等列</translation>
    </message>
    <message>
        <source>bodies have a mass and sides that make {0}, which nothing weighs</source>
        <translation>物体的质量和边长合成 {0}，没有物质有此密度</translation>
    </message>
    <message>
        <source>by the units in the heading</source>
        <translation>按表头中的单位</translation>
    </message>
    <message>
        <source>columns of the table are not known and were not read</source>
        <translation>表中有不认识的列，未读取</translation>
    </message>
    <message>
        <source>each body is let go at its time</source>
        <translation>每个物体在其时刻放开</translation>
    </message>
    <message>
        <source>fitted on one half, judged on the other</source>
        <translation>用一半拟合，用另一半评判</translation>
    </message>
    <message>
        <source>look at heights and datum of the table and the terrain; falls hold that difference too</source>
        <translation>请查看表和地形的高程与基准面；下落高度也含有该差别</translation>
    </message>
    <message>
        <source>look at the units in the heading</source>
        <translation>请查看表头中的单位</translation>
    </message>
    <message>
        <source>net rotation</source>
        <translation>净转角</translation>
    </message>
    <message>
        <source>none is needed where that is less than a side; else look at heights and terrain</source>
        <translation>小于一条边长时无需处理；否则请查看高程和地形</translation>
    </message>
    <message>
        <source>none is needed, unless a name was meant to be one of the manual&apos;s</source>
        <translation>无需处理，除非某名称本应是手册中的名称</translation>
    </message>
    <message>
        <source>none is needed; more repeats narrow what comes of it</source>
        <translation>无需处理；更多的重复可缩小由此产生的区间</translation>
    </message>
    <message>
        <source>orientations of {0} bodies were not measured: they are drawn at random, anew in every repeat</source>
        <translation>{0} 个物体的方位没有测量：随机抽取，每次重复重新抽取</translation>
    </message>
    <message>
        <source>the set has no README.md that says where it comes from</source>
        <translation>数据组没有说明来源的 README.md</translation>
    </message>
    <message>
        <source>the table has no orientations: {0} bodies lie along its axes</source>
        <translation>表中没有方位：{0} 个物体沿其坐标轴放置</translation>
    </message>
    <message>
        <source>the table has no spins: {0} bodies are let go without</source>
        <translation>表中没有自转：{0} 个物体放开时不转动</translation>
    </message>
    <message>
        <source>the table has no velocities: {0} bodies are let go at rest</source>
        <translation>表中没有速度：{0} 个物体从静止放开</translation>
    </message>
    <message>
        <source>there is no column measured_x_m, so nothing can be compared</source>
        <translation>没有 measured_x_m 列，因此无法比较</translation>
    </message>
    <message>
        <source>write one: source, how it was measured, what a row is</source>
        <translation>请写一份：来源、如何测量、一行是什么</translation>
    </message>
    <message>
        <source>{0} bodies do not say what they are made of: their density decides</source>
        <translation>{0} 个物体没有说明材料：由其密度决定</translation>
    </message>
    <message>
        <source>{0} falls began in the surface and were lifted out of it, at most by {1}</source>
        <translation>{0} 次下落起始位于表面之内，已抬出，最多 {1}</translation>
    </message>
    <message>
        <source>{0} has no column {1}</source>
        <translation>{0} 没有 {1} 列</translation>
    </message>
    <message>
        <source>{0} holds no bodies</source>
        <translation>{0} 中没有物体</translation>
    </message>
    <message>
        <source>{0} holds no set of measured falls</source>
        <translation>{0} 中没有实测下落的数据组</translation>
    </message>
    <message>
        <source>{0} measured places lie more than a metre from the surface, the farthest {1} above it</source>
        <translation>{0} 个实测位置离表面超过一米，最远的在其上方 {1}</translation>
    </message>
    <message>
        <source>{0}: line {1} has &quot;{2}&quot; in the column {3}, which is no number</source>
        <translation>{0}：第 {1} 行的 {3} 列为“{2}”，不是数</translation>
    </message>
    <message>
        <source>{0}: line {1} has an orientation of length {2}, which is no rotation</source>
        <translation>{0}：第 {1} 行的方位长度为 {2}，不是旋转</translation>
    </message>
    <message>
        <source>{0}: line {1} has the id {2}, as line {3} has</source>
        <translation>{0}：第 {1} 行的标识为 {2}，与第 {3} 行相同</translation>
    </message>
    <message>
        <source>{0}: line {1} has {2} in the column {3}, as a line before</source>
        <translation>{0}：第 {1} 行的 {3} 列为 {2}，与前面某行相同</translation>
    </message>
    <message>
        <source>{0}: line {1} has {2} in the column {3}, which must be above zero</source>
        <translation>{0}：第 {1} 行的 {3} 列为 {2}，必须大于零</translation>
    </message>
    <message>
        <source>{0}: line {1} has {2} in the column {3}, which {4} does not have</source>
        <translation>{0}：第 {1} 行的 {3} 列为 {2}，而 {4} 中没有</translation>
    </message>
    <message>
        <source>{0}: line {1} names the material &quot;{2}&quot;, of which no body is made</source>
        <translation>{0}：第 {1} 行的材料“{2}”不能构成物体</translation>
    </message>
    <message>
        <source>{0}: orientations stand as quaternions and as angles</source>
        <translation>{0}：方位同时以四元数和角度给出</translation>
    </message>
    <message>
        <source>{0}: spins stand about the axes of the table and about those of the body</source>
        <translation>{0}：自转同时绕表的坐标轴和绕物体自身的轴给出</translation>
    </message>
    <message>
        <source>{0}: the column {1} does not say of which axes the spin is</source>
        <translation>{0}：列 {1} 没有说明自转绕哪组轴</translation>
    </message>
    <message>
        <source>{0}: the column {1} has no unit that is known</source>
        <translation>{0}：列 {1} 没有可识别的单位</translation>
    </message>
    <message>
        <source>{0}: the column {1} stands twice</source>
        <translation>{0}：列 {1} 出现两次</translation>
    </message>
    <message>
        <source>{0}: there is no column {1}</source>
        <translation>{0}：没有 {1} 列</translation>
    </message>
    <message>
        <source>{0}: {1} bodies begin where the terrain {2} has no heights; one is {3}</source>
        <translation>{0}：{1} 个物体起始于地形 {2} 没有高程之处；其一为 {3}</translation>
    </message>
    <message>
        <source>{0}: {1} bodies begin with their centre below the surface, {2} by {3}</source>
        <translation>{0}：{1} 个物体的中心起始于表面之下，{2} 低 {3}</translation>
    </message>
    <message>
        <source>Baker &amp; Kudrolli, Phys. Rev. E 82 (2010) 061304: plastic dice, random loose and random close packing</source>
        <translation>Baker &amp; Kudrolli, Phys. Rev. E 82 (2010) 061304：塑料骰子，随机疏松与随机密实堆积</translation>
    </message>
    <message>
        <source>Dice poured into a vessel</source>
        <translation>倒入容器的骰子</translation>
    </message>
    <message>
        <source>Give a mesh of the ground with z up.</source>
        <translation>请给出 z 向上的地面网格。</translation>
    </message>
    <message>
        <source>a block of 0.5 m and 1.5 m high, friction 0.65: topples</source>
        <translation>0.5 m 宽、1.5 m 高的块体，摩擦 0.65：倾覆</translation>
    </message>
    <message>
        <source>a cube of 1 m, friction 0.65: slides</source>
        <translation>1 m 的立方体，摩擦 0.65：滑动</translation>
    </message>
    <message>
        <source>a cube of 1 m, friction 1.2: topples</source>
        <translation>1 m 的立方体，摩擦 1.2：倾覆</translation>
    </message>
    <message>
        <source>a wall in running bond, 5 courses of blocks 0.4 x 0.6 x 0.3 m, friction 0.65, tilted across: topples</source>
        <translation>错缝砌筑的墙，5 层 0.4 x 0.6 x 0.3 m 的块体，摩擦 0.65，沿厚度方向倾斜：倾覆</translation>
    </message>
    <message>
        <source>an STL states no unit; its numbers are taken as metres</source>
        <translation>STL 不写明单位；其数值按米处理</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>假定</translation>
    </message>
    <message>
        <source>assumed: the source measured none; varied for cubes</source>
        <translation>假定：来源未测量；对立方体取不同的值</translation>
    </message>
    <message>
        <source>at {0} of {1} places the mesh has surfaces above each other, up to {2} apart; the highest is taken</source>
        <translation>在 {1} 处中的 {0} 处，网格有上下重叠的面，最多相距 {2}；取最高者</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>闭式解</translation>
    </message>
    <message>
        <source>cube slides</source>
        <translation>立方体滑动</translation>
    </message>
    <message>
        <source>cube topples</source>
        <translation>立方体倾覆</translation>
    </message>
    <message>
        <source>cubes, friction 0.3</source>
        <translation>立方体，摩擦 0.3</translation>
    </message>
    <message>
        <source>cubes, friction 0.5</source>
        <translation>立方体，摩擦 0.5</translation>
    </message>
    <message>
        <source>cubes, friction 0.8</source>
        <translation>立方体，摩擦 0.8</translation>
    </message>
    <message>
        <source>cut away roofs and overhangs if bodies are to fall below them</source>
        <translation>如果物体应落到屋顶和悬挑之下，请将它们切除</translation>
    </message>
    <message>
        <source>limit analysis of rigid blocks, closed form: a verification, no measurement</source>
        <translation>刚体的极限分析，闭式解：属于核实，不是测量</translation>
    </message>
    <message>
        <source>none is needed; walls and overhangs are steep slopes</source>
        <translation>无需处理；墙和悬挑成为陡坡</translation>
    </message>
    <message>
        <source>numbers of a publication</source>
        <translation>出版物中的数值</translation>
    </message>
    <message>
        <source>pillar topples</source>
        <translation>柱体倾覆</translation>
    </message>
    <message>
        <source>poured without shaking: between random loose and random close packing</source>
        <translation>倒入而不摇动：介于随机疏松与随机密实堆积之间</translation>
    </message>
    <message>
        <source>scale the mesh to metres before it is written if they are not</source>
        <translation>如果不是米，请在写出之前将网格换算为米</translation>
    </message>
    <message>
        <source>the mesh of {0} triangles was taken as heights on cells of {1}</source>
        <translation>{0} 个三角形的网格按 {1} 的单元取为高程</translation>
    </message>
    <message>
        <source>wall across</source>
        <translation>墙沿厚度方向</translation>
    </message>
    <message>
        <source>{0} is no surface that bodies could fall on: it has no area from above</source>
        <translation>{0} 不是物体可落于其上的面：从上方看没有面积</translation>
    </message>
    <message>
        <source>{0} promises {1} triangles, but its length is that of {2}</source>
        <translation>{0} 声明有 {1} 个三角形，但其长度只够 {2} 个</translation>
    </message>
    <message>
        <source>Bring both to one system, such as the UTM zone of the place.</source>
        <translation>请把两者变换到同一坐标系，如当地的 UTM 带。</translation>
    </message>
    <message>
        <source>Bring it to a projected system, such as the UTM zone of the place.</source>
        <translation>请把它变换到投影坐标系，如当地的 UTM 带。</translation>
    </message>
    <message>
        <source>Check the coordinate systems, or give clouds of one site.</source>
        <translation>请检查坐标系，或给出同一场地的点云。</translation>
    </message>
    <message>
        <source>Give a cloud with points.</source>
        <translation>请给出有点的点云。</translation>
    </message>
    <message>
        <source>Give a file with fewer of them, or a greater projection radius.</source>
        <translation>请给出核心点更少的文件，或更大的投影半径。</translation>
    </message>
    <message>
        <source>There are more than {0} core points</source>
        <translation>核心点多于 {0} 个</translation>
    </message>
    <message>
        <source>a unit of x and y is {0}, one of z {1}: distances in the numbers of the file are lengths of neither</source>
        <translation>x 和 y 的一个单位为 {0}，z 的为 {1}：以文件数值计的距离不是任何一种单位的长度</translation>
    </message>
    <message>
        <source>all lengths are in units of the file, each {0}</source>
        <translation>所有长度以文件的单位计，每单位 {0}</translation>
    </message>
    <message>
        <source>core points have no distance: no point of either cloud lies in their cylinder</source>
        <translation>核心点没有距离：其圆柱中没有任何一个点云的点</translation>
    </message>
    <message>
        <source>core points have no distance: no point of the first cloud lies in their cylinder</source>
        <translation>核心点没有距离：其圆柱中没有第一个点云的点</translation>
    </message>
    <message>
        <source>core points have no distance: no point of the second cloud lies in their cylinder</source>
        <translation>核心点没有距离：其圆柱中没有第二个点云的点</translation>
    </message>
    <message>
        <source>core points have no normal: fewer than three points of the first cloud lie about them</source>
        <translation>核心点没有法向：其周围第一个点云的点少于三个</translation>
    </message>
    <message>
        <source>distances have no level of detection: fewer than {0} points of a cloud lie in their cylinder</source>
        <translation>距离没有检测限：其圆柱中某个点云的点少于 {0} 个</translation>
    </message>
    <message>
        <source>distances may be too short: a surface in the cylinder reaches its end</source>
        <translation>距离可能偏短：圆柱中的表面到达其端部</translation>
    </message>
    <message>
        <source>give a greater depth</source>
        <translation>请给出更大的深度</translation>
    </message>
    <message>
        <source>give a greater depth if the surface moved farther; else the second cloud has a hole there</source>
        <translation>如果表面移动得更远，请给出更大的深度；否则第二个点云在那里有空缺</translation>
    </message>
    <message>
        <source>give a greater normal scale, or cores on the first cloud</source>
        <translation>请给出更大的法向尺度，或位于第一个点云上的核心点</translation>
    </message>
    <message>
        <source>give a greater projection scale; these distances are not called significant</source>
        <translation>请给出更大的投影尺度；这些距离不称为显著</translation>
    </message>
    <message>
        <source>give cores on the first cloud, or a greater projection scale</source>
        <translation>请给出位于第一个点云上的核心点，或更大的投影尺度</translation>
    </message>
    <message>
        <source>nobody stated how well one cloud lies against the other: the level of detection holds their roughness alone</source>
        <translation>无人写明两个点云相对就位的精度：检测限只含其粗糙度</translation>
    </message>
    <message>
        <source>state the registration error (--registration-error), 0 only if it is known to be none</source>
        <translation>请写明配准误差（--registration-error），确知没有误差时才写 0</translation>
    </message>
    <message>
        <source>the file names no coordinate system; that of the first cloud is taken</source>
        <translation>文件未写明坐标系；采用第一个点云的坐标系</translation>
    </message>
    <message>
        <source>{0} has no eastings and northings (&quot;{1}&quot;): distances would have no meaning</source>
        <translation>{0} 没有东坐标和北坐标（“{1}”）：距离没有意义</translation>
    </message>
    <message>
        <source>{0} has no point that counts</source>
        <translation>{0} 没有可计入的点</translation>
    </message>
    <message>
        <source>{0} has no point to measure at</source>
        <translation>{0} 没有可供量距的点</translation>
    </message>
    <message>
        <source>{0} is in &quot;{1}&quot;, {2} in &quot;{3}&quot;</source>
        <translation>{0} 在“{1}”中，{2} 在“{3}”中</translation>
    </message>
    <message>
        <source>{0} lies {1} units away from the core points</source>
        <translation>{0} 距核心点 {1} 个单位</translation>
    </message>
    <message>
        <source>Give a raster of heights with one band (GeoTIFF, ESRI ASCII grid, BIL, ENVI, IMG, HGT, DTED, XYZ or Surfer), or a point cloud.</source>
        <translation>请提供单波段的高程栅格（GeoTIFF、ESRI ASCII 网格、BIL、ENVI、IMG、HGT、DTED、XYZ 或 Surfer），或点云。</translation>
    </message>
    <message>
        <source>Give the cloud with its ground, or without classes if they are wrong.</source>
        <translation>请给出带地面的点云；如果类别有误，请给出不带类别的点云。</translation>
    </message>
    <message>
        <source>Its numbers seem to be feet: give it with its coordinate system, or in metres.</source>
        <translation>其数值似乎以英尺计：请连同坐标系给出，或以米给出。</translation>
    </message>
    <message>
        <source>Laying the points on a grid</source>
        <translation>把点放到网格上</translation>
    </message>
    <message>
        <source>classify the ground in a program for point clouds, if trees, vehicles or houses stand there</source>
        <translation>如果那里有树木、车辆或房屋，请在点云程序中对地面分类</translation>
    </message>
    <message>
        <source>give them another class if they are debris</source>
        <translation>如果它们是堆积物，请改为其他类别</translation>
    </message>
    <message>
        <source>no point is of class 2: all but vegetation and wires are taken as ground</source>
        <translation>没有类别 2 的点：除植被和电线外全部作为地面</translation>
    </message>
    <message>
        <source>none is needed unless debris runs there</source>
        <translation>除非堆积物到达那里，否则无需处理</translation>
    </message>
    <message>
        <source>points farther from the structure than there is room for were left out</source>
        <translation>离结构太远、容纳不下的点已略去</translation>
    </message>
    <message>
        <source>points of vegetation and wires were left out</source>
        <translation>植被和电线的点已略去</translation>
    </message>
    <message>
        <source>the cloud has no classes: all its points are taken as ground</source>
        <translation>点云没有类别：其所有点都作为地面</translation>
    </message>
    <message>
        <source>what is smaller than a cell is averaged; a denser cloud gets finer cells</source>
        <translation>小于单元的部分被平均；更密的点云得到更细的单元</translation>
    </message>
    <message>
        <source>{0} counts its places from the centre of the Earth</source>
        <translation>{0} 的坐标从地心算起</translation>
    </message>
    <message>
        <source>{0} holds vegetation and wires alone ({1} points): neither ground nor debris</source>
        <translation>{0} 只有植被和电线（{1} 个点）：既无地面也无堆积物</translation>
    </message>
    <message>
        <source>{0} points were laid on cells of {1}, {2} to a cell in the median; {3} % of the cells have none</source>
        <translation>{0} 个点放到了 {1} 的单元上，每个单元的点数中位数为 {2}；{3} % 的单元没有点</translation>
    </message>
    <message>
        <source>it does not have one row for each island</source>
        <translation>并非每个孤立部分各有一行</translation>
    </message>
    <message>
        <source>the index of a state</source>
        <translation>一个状态的序号</translation>
    </message>
    <message>
        <source>A roughness of {0} on a lattice of {1} is none</source>
        <translation>格点间距 {1} 上的粗糙度 {0} 不成立</translation>
    </message>
    <message>
        <source>Blocks and walls on a tilting table, and an arch</source>
        <translation>倾斜台上的石块和墙，以及一座拱</translation>
    </message>
    <message>
        <source>a semicircle of 15 voussoirs, radius 5 m, friction 0.8: least thickness</source>
        <translation>15 块拱石的半圆拱，半径 5 m，摩擦 0.8：最小厚度</translation>
    </message>
    <message>
        <source>at longer steps piles of Bullet&apos;s solver are pressed into themselves</source>
        <translation>步长更大时，Bullet 求解器的堆积体会被压入自身</translation>
    </message>
    <message>
        <source>by size and number of the bodies, {0} and {1}</source>
        <translation>按刚体的尺寸和数目，{0} 和 {1}</translation>
    </message>
    <message>
        <source>give a terrain, or set terrain_roughness to 0</source>
        <translation>给出地形，或将 terrain_roughness 设为 0</translation>
    </message>
    <message>
        <source>given: nothing slides</source>
        <translation>给定：不发生滑动</translation>
    </message>
    <message>
        <source>repeat with other seeds, or give a finer terrain and no terrain_roughness</source>
        <translation>用其他种子重复，或给出更细的地形而不用 terrain_roughness</translation>
    </message>
    <message>
        <source>set by step_rate</source>
        <translation>由 step_rate 设定</translation>
    </message>
    <message>
        <source>terrain_roughness = {0} has no terrain to lie on: the level ground is smooth</source>
        <translation>terrain_roughness = {0} 没有可依附的地形：水平地面是光滑的</translation>
    </message>
    <message>
        <source>the terrain was given obstacles of {0} on average, {1} apart, at random (seed {2}): nobody measured where they are</source>
        <translation>地形上随机加了平均 {0} 高、间距 {1} 的障碍物（种子 {2}）：没有人测量过它们的位置</translation>
    </message>
    <message>
        <source>there are no bodies</source>
        <translation>没有刚体</translation>
    </message>
    <message>
        <source>wall across, 120 steps</source>
        <translation>墙沿厚度方向，120 步</translation>
    </message>
    <message>
        <source>A scan takes 1 to {0} scanners at places that are numbers</source>
        <translation>扫描需要 1 至 {0} 台扫描仪，其位置必须是数</translation>
    </message>
    <message>
        <source>Check the coordinate systems of the cloud and of the case, and its control points.</source>
        <translation>请检查点云和案例的坐标系以及案例的控制点。</translation>
    </message>
    <message>
        <source>Correct them.</source>
        <translation>请更正。</translation>
    </message>
    <message>
        <source>Give a cloud of the site, and an area of interest that it covers.</source>
        <translation>请给出该现场的点云，以及它所覆盖的关注区域。</translation>
    </message>
    <message>
        <source>Give a greater step, a shorter range or fewer scanners.</source>
        <translation>请给出更大的步长、更短的射程或更少的扫描仪。</translation>
    </message>
    <message>
        <source>Give a greater step, or fewer scanners.</source>
        <translation>请给出更大的步长或更少的扫描仪。</translation>
    </message>
    <message>
        <source>Give a larger area that did not move, or a greater radius.</source>
        <translation>请给出更大的未移动区域，或更大的半径。</translation>
    </message>
    <message>
        <source>Give places with easting, northing and height.</source>
        <translation>请给出带东坐标、北坐标和高程的位置。</translation>
    </message>
    <message>
        <source>Only {0} points of what did not move lie on a surface of the other cloud; a fit takes {1}</source>
        <translation>未移动部分只有 {0} 个点位于另一点云的表面上；拟合需要 {1} 个</translation>
    </message>
    <message>
        <source>Project the cloud to the system of the case first.</source>
        <translation>请先把点云投影到案例的坐标系。</translation>
    </message>
    <message>
        <source>Sending rays</source>
        <translation>正在发出射线</translation>
    </message>
    <message>
        <source>Step and range of a scan must be above zero, its noise not below</source>
        <translation>扫描的步长和射程必须大于零，噪声不得小于零</translation>
    </message>
    <message>
        <source>Take in surfaces that look other ways, such as walls, kerbs and slopes.</source>
        <translation>请纳入朝向其他方向的表面，例如墙、路缘和斜坡。</translation>
    </message>
    <message>
        <source>The scan has more than {0} points</source>
        <translation>扫描的点多于 {0} 个</translation>
    </message>
    <message>
        <source>The scan would take {0} rays; at most {1} are sent</source>
        <translation>该扫描需要 {0} 条射线；最多发出 {1} 条</translation>
    </message>
    <message>
        <source>What did not move leaves a direction or a turn open: its surfaces look too much alike</source>
        <translation>未移动的部分使某个方向或转动悬而未决：其表面朝向过于一致</translation>
    </message>
    <message>
        <source>cells are in no volume: a cloud has fewer than {0} points there within the depth</source>
        <translation>方格不计入任何体积：某个点云在那里的深度之内少于 {0} 个点</translation>
    </message>
    <message>
        <source>check the coordinate systems of the cloud and of the case</source>
        <translation>请检查点云和案例的坐标系</translation>
    </message>
    <message>
        <source>core points have no distance: the scan would not have seen the simulated site within the depth</source>
        <translation>核心点没有距离：扫描在深度之内不会看到模拟的现场</translation>
    </message>
    <message>
        <source>give a greater depth if the surfaces are farther apart; else something simulated hides the place</source>
        <translation>如果两个表面相距更远，请给出更大的深度；否则该处被模拟的物体遮挡</translation>
    </message>
    <message>
        <source>give a greater normal scale, or clouds that lie nearer to each other</source>
        <translation>请给出更大的法向尺度，或相距更近的点云</translation>
    </message>
    <message>
        <source>give a shorter range, or an area of interest</source>
        <translation>请给出更短的射程，或关注区域</translation>
    </message>
    <message>
        <source>give greater cells or a greater depth; the clouds may end or have holes there</source>
        <translation>请给出更大的方格或更大的深度；点云可能在那里终止或有空缺</translation>
    </message>
    <message>
        <source>give the scans with their poses (E57, PTX)</source>
        <translation>请给出带位姿的测站（E57、PTX）</translation>
    </message>
    <message>
        <source>heights of the cloud count from &quot;{0}&quot;, and the case names no vertical datum; they were not converted</source>
        <translation>点云的高程自“{0}”起算，而案例未写明高程基准；未作换算</translation>
    </message>
    <message>
        <source>heights of the cloud count from &quot;{0}&quot;, those of the case from &quot;{1}&quot;; they were not converted</source>
        <translation>点云的高程自“{0}”起算，案例的自“{1}”起算；未作换算</translation>
    </message>
    <message>
        <source>leave it out, unless control points tell it better than the fit</source>
        <translation>除非控制点比拟合更准，请不要给出</translation>
    </message>
    <message>
        <source>name an area of interest (--area)</source>
        <translation>请指明关注区域（--area）</translation>
    </message>
    <message>
        <source>points beyond the area of interest, or within what is left out, were not compared</source>
        <translation>关注区域之外或不计部分之内的点未作比较</translation>
    </message>
    <message>
        <source>points without a place in the system of the case were left out</source>
        <translation>在案例坐标系中没有位置的点已略去</translation>
    </message>
    <message>
        <source>the cloud does not fit into memory: one point in {0} was taken</source>
        <translation>点云放不进内存：每 {0} 个点取一个</translation>
    </message>
    <message>
        <source>the cloud does not say where its scanners stood: the run is seen straight from above, as from an aircraft</source>
        <translation>点云未说明扫描仪的位置：计算按从正上方所见，如同航空测量</translation>
    </message>
    <message>
        <source>the cloud names no coordinate system; it is taken to be that of the case</source>
        <translation>点云未写明坐标系；按案例的坐标系处理</translation>
    </message>
    <message>
        <source>the fit had not settled after {0} rounds</source>
        <translation>拟合在 {0} 轮之后仍未稳定</translation>
    </message>
    <message>
        <source>the points were projected from &quot;{0}&quot; to the system of the case</source>
        <translation>点已从“{0}”投影到案例的坐标系</translation>
    </message>
    <message>
        <source>the stated registration error, {0}, is less than that of the fit, {1}; the stated one was taken</source>
        <translation>给定的配准误差 {0} 小于拟合的 {1}；采用给定的</translation>
    </message>
    <message>
        <source>the terrain has too many nodes to be scanned: one in {0} was taken each way</source>
        <translation>地形的节点过多，无法全部扫描：每个方向每 {0} 个取一个</translation>
    </message>
    <message>
        <source>which of {0} scanners saw a point is not known: the nearest one is taken</source>
        <translation>不知道 {0} 台扫描仪中哪一台看到了某个点：取最近的一台</translation>
    </message>
    <message>
        <source>{0} has no point that could be compared</source>
        <translation>{0} 没有可以比较的点</translation>
    </message>
    <message>
        <source>{0} lies elsewhere: its middle is {1} from that of the site in plan</source>
        <translation>{0} 位于别处：其中心在平面上距现场中心 {1}</translation>
    </message>
    <message>
        <source>{0} lay {1} deep in another for over 0.5 s, {2} of its smallest side; the limit is {3} ({4})</source>
        <translation>{0} 嵌入另一刚体 {1} 深超过 0.5 s，为其最短边的 {2}；限值为 {3}（{4}）</translation>
    </message>
    <message>
        <source>{0} lay {1} deep in another for over 0.5 s, {2} times its smallest side: it has gone through; the limit is {3} of that side ({4})</source>
        <translation>{0} 嵌入另一刚体 {1} 深超过 0.5 s，为其最短边的 {2} 倍：已穿过；限值为该边的 {3}（{4}）</translation>
    </message>
    <message>
        <source>{0} at once lay more than 5 % of a smallest side inside another for over 0.5 s, {1} of all; {2} worst</source>
        <translation>{0} 同时嵌入其他刚体超过最短边的 5 % 达 0.5 s 以上，占全部的 {1}；{2} 最差</translation>
    </message>
    <message>
        <source>{0} was {1} times as fast as its birth and its fall allow; the limit is {2} ({3})</source>
        <translation>{0} 的速度为其产生和下落所允许的 {1} 倍；限值为 {2}（{3}）</translation>
    </message>
    <message>
        <source>the centre of {0} was {1} below the ground ({2})</source>
        <translation>{0} 的形心在地面以下 {1}（{2}）</translation>
    </message>
    <message>
        <source>{0} was {1} from the structure; 10 times its height and the drop of the terrain are {2} ({3})</source>
        <translation>{0} 距结构 {1}；其高度与地形落差的 10 倍为 {2}（{3}）</translation>
    </message>
    <message>
        <source>place or velocity of {0} was no number: it was taken out ({1})</source>
        <translation>{0} 的位置或速度不是数值：已移出（{1}）</translation>
    </message>
    <message>
        <source>1 body</source>
        <translation>1 个刚体</translation>
    </message>
    <message>
        <source>{0} bodies</source>
        <translation>{0} 个刚体</translation>
    </message>
    <message>
        <source>once</source>
        <translation>一次</translation>
    </message>
    <message>
        <source>{0} times</source>
        <translation>{0} 次</translation>
    </message>
    <message>
        <source>1 limit of health</source>
        <translation>1 个健康限值</translation>
    </message>
    <message>
        <source>{0} limits of health</source>
        <translation>{0} 个健康限值</translation>
    </message>
    <message>
        <source>GeoTIFF (*.tif);;GeoPackage (*.gpkg);;Tables (*.csv);;Images (*.png)</source>
        <translation>GeoTIFF (*.tif);;GeoPackage (*.gpkg);;表格 (*.csv);;图像 (*.png)</translation>
    </message>
    <message>
        <source>a pile at rest woke again, {0}</source>
        <translation>静止的堆积体再次醒来，{0}</translation>
    </message>
    <message>
        <source>a pile smaller than its material lies inside itself</source>
        <translation>小于其材料的堆积体嵌入自身</translation>
    </message>
    <message>
        <source>at least {0} stayed at rest: the end comes later, the pile is the same</source>
        <translation>至少 {0} 保持静止：结束较晚，堆积体不变</translation>
    </message>
    <message>
        <source>below the ground: {0}</source>
        <translation>位于地面以下：{0}</translation>
    </message>
    <message>
        <source>beyond {0} debris is thrown farther than it can fall</source>
        <translation>超过 {0} 时堆积物被抛得比能落到的更远</translation>
    </message>
    <message>
        <source>beyond {0} heights and volumes are those of its shapes</source>
        <translation>超过 {0} 时高度和体积是其形状的</translation>
    </message>
    <message>
        <source>beyond {0} something launched it, and whatever it hit</source>
        <translation>超过 {0} 时有东西把它弹出，连同它所撞的</translation>
    </message>
    <message>
        <source>bodies that carry the fragments: {0} for {1}</source>
        <translation>带动碎块的刚体：{0} 个，碎块 {1} 个</translation>
    </message>
    <message>
        <source>deeper than it is thick a body has gone through another: where it lies means nothing</source>
        <translation>深度超过其厚度的刚体已穿过另一个：其位置没有意义</translation>
    </message>
    <message>
        <source>deeper than {0} it has fallen through the ground and lies nowhere</source>
        <translation>深于 {0} 时它已穿过地面，不在任何位置</translation>
    </message>
    <message>
        <source>energy rose beyond what gravity, births, pieces and effects put in, {0}</source>
        <translation>能量超出重力、产生、块体和效应带入的量，{0}</translation>
    </message>
    <message>
        <source>faster than gravity and their birth allow: {0}</source>
        <translation>比重力和产生所允许的更快：{0}</translation>
    </message>
    <message>
        <source>it is single bodies, no deeper than they are thick: the pile keeps its shape</source>
        <translation>只是个别刚体，深度不超过其厚度：堆积体保持其形状</translation>
    </message>
    <message>
        <source>its mass is missing from then on</source>
        <translation>其质量此后缺失</translation>
    </message>
    <message>
        <source>less than {0} stayed at rest: the pile was not at rest before</source>
        <translation>保持静止的少于 {0}：堆积体此前并未静止</translation>
    </message>
    <message>
        <source>no number</source>
        <translation>非数值</translation>
    </message>
    <message>
        <source>not all at rest: at {0}, the last instant, {1} of {2} bodies still moved</source>
        <translation>未全部静止：在最后时刻 {0}，{2} 个刚体中有 {1} 个仍在运动</translation>
    </message>
    <message>
        <source>not complete: the run goes up to {0}, what comes later is not in it</source>
        <translation>不完整：计算到 {0} 为止，其后的内容不在其中</translation>
    </message>
    <message>
        <source>nothing of this collapse can be there: covered area and run-out hold debris that is none</source>
        <translation>本次倒塌的任何东西都不可能在那里：覆盖面积和散落距离含有并非堆积物的东西</translation>
    </message>
    <message>
        <source>poor match of the camera: do not rest a conclusion on it</source>
        <translation>相机匹配差：不要据此下结论</translation>
    </message>
    <message>
        <source>tainted: {0} passed, and nobody vouches for the run</source>
        <translation>存疑：超过 {0}，且无人为本次计算担保</translation>
    </message>
    <message>
        <source>the photograph shows all at rest, but {0} of {1} bodies still move at {2}, where they are compared with it</source>
        <translation>照片显示全部静止，但在与其比较的时刻 {2}，{1} 个刚体中仍有 {0} 个在运动</translation>
    </message>
    <message>
        <source>the pile lies too low, yet holds its material</source>
        <translation>堆积体过低，但容得下其材料</translation>
    </message>
    <message>
        <source>there are no fragments</source>
        <translation>没有碎块</translation>
    </message>
    <message>
        <source>up to {0} it has sunk in: it lies a little too low</source>
        <translation>至 {0} 时它已陷入：位置略低</translation>
    </message>
    <message>
        <source>up to {0} of the bodies the pile lies only a little too low</source>
        <translation>至刚体的 {0} 时堆积体只是略低</translation>
    </message>
    <message>
        <source>up to {0} single bodies fly too far</source>
        <translation>至 {0} 时个别刚体飞得过远</translation>
    </message>
    <message>
        <source>up to {0} single bodies move otherwise, and hardly the shape of the debris</source>
        <translation>至 {0} 时个别刚体的运动不同，堆积物的形状几乎不变</translation>
    </message>
    <message>
        <source>up to {0} the pile lies too high, and in its place</source>
        <translation>至 {0} 时堆积体过高，位置正确</translation>
    </message>
    <message>
        <source>with more than {0} of the bodies the pile is squeezed into itself: its heights are too small</source>
        <translation>超过刚体的 {0} 时堆积体自身压缩：其高度过小</translation>
    </message>
    <message>
        <source>{0} became no number and left the simulation</source>
        <translation>{0} 不再是数值，已移出模拟</translation>
    </message>
    <message>
        <source>{0} lay inside others for over 0.5 s</source>
        <translation>{0} 嵌入其他刚体超过 0.5 s</translation>
    </message>
    <message>
        <source>{0} passed</source>
        <translation>超过 {0}</translation>
    </message>
    <message>
        <source>{0} passed, acknowledged</source>
        <translation>超过 {0}，已确认</translation>
    </message>
    <message>
        <source>{0} went further from the structure than 10 times its height and the drop of the terrain</source>
        <translation>{0} 离结构的距离超过其高度与地形落差的 10 倍</translation>
    </message>
    <message>
        <source>A page shows at most {0} fragments or elements; the run has {1} fragments of {2} elements</source>
        <translation>网页最多显示 {0} 个碎块或单元；此计算有 {1} 个碎块，来自 {2} 个单元</translation>
    </message>
    <message>
        <source>Choose a run in which elements were deactivated, and let it simulate.</source>
        <translation>请选择有单元失效的计算，并完成模拟。</translation>
    </message>
    <message>
        <source>Conventional FE result</source>
        <translation>常规有限元结果</translation>
    </message>
    <message>
        <source>Drawing the pictures of the page</source>
        <translation>正在绘制网页的图片</translation>
    </message>
    <message>
        <source>Packing the motion of the bodies</source>
        <translation>正在压缩刚体的运动</translation>
    </message>
    <message>
        <source>Packing the states of the FE result</source>
        <translation>正在压缩有限元结果的状态</translation>
    </message>
    <message>
        <source>Share a movie or a report, or export the run for ParaView (vtkhdf).</source>
        <translation>请共享动画或报告，或为 ParaView 导出（vtkhdf）。</translation>
    </message>
    <message>
        <source>The run has no fragments that a page could show</source>
        <translation>此计算没有网页可显示的碎块</translation>
    </message>
    <message>
        <source>Pages (*.html)</source>
        <translation>网页 (*.html)</translation>
    </message>
    <message>
        <source>A machine of the cluster failed while it made a world.</source>
        <translation>集群的一台机器在计算一个世界时发生故障。</translation>
    </message>
    <message>
        <source>A world ended with an error on the cluster.</source>
        <translation>一个世界在集群上出错结束。</translation>
    </message>
    <message>
        <source>A world needed more memory than the cluster gave it.</source>
        <translation>一个世界所需的内存超过集群给予的内存。</translation>
    </message>
    <message>
        <source>A world took longer than the cluster gave it.</source>
        <translation>一个世界所用的时间超过集群给予的时间。</translation>
    </message>
    <message>
        <source>A world was cancelled on the cluster.</source>
        <translation>一个世界在集群上被取消。</translation>
    </message>
    <message>
        <source>Ask sinfo whether the cluster answers and has nodes for it, or ask whoever runs it. Slurm says: {0}</source>
        <translation>请用 sinfo 查看集群是否应答、是否有可用节点，或询问其管理者。Slurm 原文：{0}</translation>
    </message>
    <message>
        <source>Ask whoever runs the cluster, or simulate on this machine. Slurm says: {0}</source>
        <translation>请询问集群的管理者，或在本机模拟。Slurm 原文：{0}</translation>
    </message>
    <message>
        <source>Check the options of sbatch against its manual. Slurm says: {0}</source>
        <translation>请对照 sbatch 的手册检查其选项。Slurm 原文：{0}</translation>
    </message>
    <message>
        <source>Mend what the error names, then start again: only what is missing is submitted. The cluster says: {0}</source>
        <translation>请解决错误所指的问题后重新开始：只提交缺少的部分。集群原文：{0}</translation>
    </message>
    <message>
        <source>Name a partition for longer jobs among the options of sbatch (--partition). Slurm says: {0}</source>
        <translation>请在 sbatch 选项中指定适合较长作业的分区（--partition）。Slurm 原文：{0}</translation>
    </message>
    <message>
        <source>Name a partition for longer jobs among the options of sbatch, or use more threads. The cluster says: {0}</source>
        <translation>请在 sbatch 选项中指定适合较长作业的分区，或使用更多线程。集群原文：{0}</translation>
    </message>
    <message>
        <source>Name a partition with larger machines among the options of sbatch. The cluster says: {0}</source>
        <translation>请在 sbatch 选项中指定机器更大的分区。集群原文：{0}</translation>
    </message>
    <message>
        <source>Name another among the options of sbatch (--partition); sinfo lists them. Slurm says: {0}</source>
        <translation>请在 sbatch 选项中指定另一个分区（--partition）；sinfo 会列出它们。Slurm 原文：{0}</translation>
    </message>
    <message>
        <source>Name one of yours among the options of sbatch (--account); sacctmgr lists them. Slurm says: {0}</source>
        <translation>请在 sbatch 选项中指定您的账户（--account）；sacctmgr 会列出它们。Slurm 原文：{0}</translation>
    </message>
    <message>
        <source>No machine of the cluster has the processors and the memory that a world asks for.</source>
        <translation>集群中没有机器具有一个世界所要求的处理器和内存。</translation>
    </message>
    <message>
        <source>Put the cluster&apos;s slurm.conf into /etc/slurm, or simulate on this machine. Slurm says: {0}</source>
        <translation>请将集群的 slurm.conf 放入 /etc/slurm，或在本机模拟。Slurm 原文：{0}</translation>
    </message>
    <message>
        <source>Reading the history of fragments</source>
        <translation>正在读取碎块的时程</translation>
    </message>
    <message>
        <source>See that munge runs here with the key of the cluster, and that it knows the user. Slurm says: {0}</source>
        <translation>请确认本机的 munge 使用集群的密钥运行，且集群认识该用户。Slurm 原文：{0}</translation>
    </message>
    <message>
        <source>Slurm is installed here, but does not know its cluster.</source>
        <translation>此处已安装 Slurm，但不知道其集群。</translation>
    </message>
    <message>
        <source>Start again: only what is missing is submitted. The cluster says: {0}</source>
        <translation>请重新开始：只提交缺少的部分。集群原文：{0}</translation>
    </message>
    <message>
        <source>The cluster did not take this, for a reason of its own.</source>
        <translation>集群因其自身的原因未接受。</translation>
    </message>
    <message>
        <source>The cluster does not accept this user or this machine.</source>
        <translation>集群不接受该用户或本机。</translation>
    </message>
    <message>
        <source>The cluster does not allow a world the time that it needs.</source>
        <translation>集群不允许一个世界使用其所需的时间。</translation>
    </message>
    <message>
        <source>The cluster does not take the account that the job is charged to.</source>
        <translation>集群不接受作业所记入的账户。</translation>
    </message>
    <message>
        <source>The cluster has no such partition, or it takes no jobs now.</source>
        <translation>集群没有该分区，或其现在不接受作业。</translation>
    </message>
    <message>
        <source>The cluster&apos;s controller does not answer.</source>
        <translation>集群的控制器没有应答。</translation>
    </message>
    <message>
        <source>The cluster&apos;s limits do not let this user submit so much.</source>
        <translation>集群的限制不允许该用户提交这么多。</translation>
    </message>
    <message>
        <source>Use fewer threads, or name a partition with larger machines (--partition). Slurm says: {0}</source>
        <translation>请使用较少的线程，或指定机器更大的分区（--partition）。Slurm 原文：{0}</translation>
    </message>
    <message>
        <source>Wait until other jobs have ended, or name another account or quality of service. Slurm says: {0}</source>
        <translation>请等待其他作业结束，或指定另一个账户或服务质量。Slurm 原文：{0}</translation>
    </message>
    <message>
        <source>sbatch does not know one of the options that it was given.</source>
        <translation>sbatch 不认识给它的某个选项。</translation>
    </message>
    <message>
        <source>the name of a component</source>
        <translation>一个构件的名称</translation>
    </message>
    <message>
        <source>a length above 0</source>
        <translation>大于 0 的长度</translation>
    </message>
    <message>
        <source>a point that is not the position</source>
        <translation>不同于位置的点</translation>
    </message>
    <message>
        <source>a time after that of the key before</source>
        <translation>晚于前一关键帧的时刻</translation>
    </message>
    <message>
        <source>an angle above 0 and up to 179 degrees</source>
        <translation>大于 0、至多 179 度的角度</translation>
    </message>
    <message>
        <source>NAVFAC DM 7.02 (1986): concrete or masonry on gravel and coarse sand 0.55-0.60, on silty sand or gravel 0.45-0.55, on fine silty sand 0.35-0.45</source>
        <translation>NAVFAC DM 7.02 (1986)：混凝土或砌体对砾石和粗砂 0.55-0.60，对粉质砂或砾石 0.45-0.55，对粉细砂 0.35-0.45</translation>
    </message>
    <message>
        <source>a single run: what is not known of friction, restitution and births is not in its figures</source>
        <translation>单次计算：摩擦、恢复系数和产生时刻中的未知不在其数值之内</translation>
    </message>
    <message>
        <source>{0} to {1}</source>
        <translation>{0} 至 {1}</translation>
    </message>
    <message>
        <source>{0} to {1}, assumed</source>
        <translation>{0} 至 {1}，假定</translation>
    </message>
    <message>
        <source>Delete the file named and validate again.</source>
        <translation>请删除所列文件并重新验证。</translation>
    </message>
    <message>
        <source>What was kept of a validation is damaged and left out.</source>
        <translation>保存的一项验证已损坏，不予采用。</translation>
    </message>
    <message>
        <source>correct z where that is more than half a side</source>
        <translation>若超过边长的一半，请更正 z</translation>
    </message>
    <message>
        <source>give a terrain that covers where they run</source>
        <translation>给出覆盖其所到之处的地形</translation>
    </message>
    <message>
        <source>lateral place [m]</source>
        <translation>侧向位置 [m]</translation>
    </message>
    <message>
        <source>look at their size and mass, or raise step_rate</source>
        <translation>检查其尺寸和质量，或提高 step_rate</translation>
    </message>
    <message>
        <source>moving for [s]</source>
        <translation>运动时间 [s]</translation>
    </message>
    <message>
        <source>path length [m]</source>
        <translation>路径长度 [m]</translation>
    </message>
    <message>
        <source>raise settle_time</source>
        <translation>提高 settle_time</translation>
    </message>
    <message>
        <source>top speed [m/s]</source>
        <translation>最高速度 [m/s]</translation>
    </message>
    <message>
        <source>x at the end [m]</source>
        <translation>终点 x [m]</translation>
    </message>
    <message>
        <source>y at the end [m]</source>
        <translation>终点 y [m]</translation>
    </message>
    <message>
        <source>{0} bodies begin with a corner in the surface, at most {1} deep; it pushes them out</source>
        <translation>{0} 个物体开始时有一角在地面之下，最深 {1}；地面将其推出</translation>
    </message>
    <message>
        <source>{0} bodies left the terrain; they count in no figure</source>
        <translation>{0} 个物体离开了地形；不计入任何数值</translation>
    </message>
    <message>
        <source>{0} bodies still moved at the end; where they end is not known</source>
        <translation>{0} 个物体结束时仍在运动；其终点未知</translation>
    </message>
    <message>
        <source>{0} bodies were lifted out of the surface, at most by {1}</source>
        <translation>{0} 个物体被抬出地面，最多 {1}</translation>
    </message>
    <message>
        <source>{0} bodies were lost: their place became no number</source>
        <translation>{0} 个物体丢失：其位置不再是数</translation>
    </message>
    <message>
        <source>{0}: {1} bodies begin within more than {2} others each; one is {3}</source>
        <translation>{0}：{1} 个物体开始时各与超过 {2} 个其他物体重叠；其中之一是 {3}</translation>
    </message>
    <message>
        <source>An addendum must be signed by whoever makes it</source>
        <translation>附录必须由其作者签名</translation>
    </message>
    <message>
        <source>Change what you assume otherwise, save the case, and add it then.</source>
        <translation>请更改您有不同假设之处，保存案例，然后再加入。</translation>
    </message>
    <message>
        <source>Checking the bundle</source>
        <translation>正在核验封存包</translation>
    </message>
    <message>
        <source>ECDSA with SHA-256</source>
        <translation>ECDSA（SHA-256）</translation>
    </message>
    <message>
        <source>Get the bundle anew from whoever sealed it, or from another copy.</source>
        <translation>请向封存者重新索取封存包，或使用另一份副本。</translation>
    </message>
    <message>
        <source>Give the passphrase of the key.</source>
        <translation>请给出密钥的口令。</translation>
    </message>
    <message>
        <source>Make one with: openssl genpkey -algorithm ed25519 -out KEY.pem; keep it where only you can read it.</source>
        <translation>可这样生成：openssl genpkey -algorithm ed25519 -out KEY.pem；请存放在只有您能读取之处。</translation>
    </message>
    <message>
        <source>Name a file that rubble-cli seal has written (*.rubblecase).</source>
        <translation>请给出由 rubble-cli seal 写出的文件（*.rubblecase）。</translation>
    </message>
    <message>
        <source>Name a file with the certificates that you trust.</source>
        <translation>请给出含有您所信任证书的文件。</translation>
    </message>
    <message>
        <source>Name a folder that is empty or not there yet.</source>
        <translation>请给出空的或尚不存在的文件夹。</translation>
    </message>
    <message>
        <source>Name an input of the case by its id.</source>
        <translation>请用标识给出案例的一个输入。</translation>
    </message>
    <message>
        <source>Name the file with that SHA-256.</source>
        <translation>请给出具有该 SHA-256 的文件。</translation>
    </message>
    <message>
        <source>Name the key and the certificate of one signer.</source>
        <translation>请给出同一签名者的密钥和证书。</translation>
    </message>
    <message>
        <source>Name the signer&apos;s certificate, or leave it out.</source>
        <translation>请给出签名者的证书，或不给出。</translation>
    </message>
    <message>
        <source>Name the signer&apos;s public key, certificate, or the 64 figures of its fingerprint.</source>
        <translation>请给出签名者的公钥、证书，或其指纹的 64 位字符。</translation>
    </message>
    <message>
        <source>Name your key.</source>
        <translation>请给出您的密钥。</translation>
    </message>
    <message>
        <source>No folder for temporary files can be made in {0}</source>
        <translation>无法在 {0} 中建立临时文件夹</translation>
    </message>
    <message>
        <source>Open it with the program that sealed it, or a newer one.</source>
        <translation>请用封存它的程序或更新的程序打开。</translation>
    </message>
    <message>
        <source>Open it with the program that wrote it, or a newer one.</source>
        <translation>请用写出它的程序或更新的程序打开。</translation>
    </message>
    <message>
        <source>OpenSSL does not sign with this key: {0}</source>
        <translation>OpenSSL 不能用此密钥签名：{0}</translation>
    </message>
    <message>
        <source>OpenSSL makes no request for a time stamp: {0}</source>
        <translation>OpenSSL 无法生成时间戳请求：{0}</translation>
    </message>
    <message>
        <source>Packing the bundle</source>
        <translation>正在打包</translation>
    </message>
    <message>
        <source>RSA with SHA-256</source>
        <translation>RSA（SHA-256）</translation>
    </message>
    <message>
        <source>Rename the files of this input, and save the case anew.</source>
        <translation>请重命名该输入的文件，并重新保存案例。</translation>
    </message>
    <message>
        <source>Run the case to its end, or leave the run out.</source>
        <translation>请将案例计算到结束，或不带该计算。</translation>
    </message>
    <message>
        <source>Seal it with the case that it was made from.</source>
        <translation>请与它所出自的案例一起封存。</translation>
    </message>
    <message>
        <source>Seal without a time stamp.</source>
        <translation>请不带时间戳封存。</translation>
    </message>
    <message>
        <source>A bundle holds at most {0} files</source>
        <translation>封存包最多容纳 {0} 个文件</translation>
    </message>
    <message>
        <source>Send the request that was written for this bundle, and give the answer to that.</source>
        <translation>请发送为本封存包写出的请求，并给出对它的应答。</translation>
    </message>
    <message>
        <source>Set TMPDIR to a folder with room.</source>
        <translation>请将 TMPDIR 设为有空间的文件夹。</translation>
    </message>
    <message>
        <source>Set the clock of this machine right, and add the entry then.</source>
        <translation>请校正本机时钟，然后再加入条目。</translation>
    </message>
    <message>
        <source>Set the clock of this machine right, and seal then.</source>
        <translation>请校正本机时钟，然后再封存。</translation>
    </message>
    <message>
        <source>Take an Ed25519 key, RSA of 2048 bits or more, or an elliptic curve of 256 bits or more.</source>
        <translation>请使用 Ed25519 密钥、2048 位以上的 RSA，或 256 位以上的椭圆曲线。</translation>
    </message>
    <message>
        <source>Taking the digests of the inputs</source>
        <translation>正在计算输入的摘要</translation>
    </message>
    <message>
        <source>The bundle has no input &quot;{0}&quot;</source>
        <translation>封存包没有输入“{0}”</translation>
    </message>
    <message>
        <source>The clock of this machine says {0}, but the journal of {1} goes on until {2}</source>
        <translation>本机时钟为 {0}，但 {1} 的日志延续到 {2}</translation>
    </message>
    <message>
        <source>The clock of this machine says {0}, but the last entry of {1} is of {2}</source>
        <translation>本机时钟为 {0}，但 {1} 的最后一个条目是 {2} 的</translation>
    </message>
    <message>
        <source>The file of the input {0} is not the one that the case was saved with: {1}</source>
        <translation>输入 {0} 的文件不是保存案例时的那一个：{1}</translation>
    </message>
    <message>
        <source>The file of the input {0} is not there: {1}</source>
        <translation>输入 {0} 的文件不存在：{1}</translation>
    </message>
    <message>
        <source>The first certificate of {0} is not of the key {1}</source>
        <translation>{0} 的第一个证书不属于密钥 {1}</translation>
    </message>
    <message>
        <source>The first difference is at t = {0} s: body {1} is {2} m away.</source>
        <translation>首个差别在 t = {0} s：刚体 {1} 相距 {2} m。</translation>
    </message>
    <message>
        <source>The first difference is at t = {0} s: the frames have other times or another number of bodies.</source>
        <translation>首个差别在 t = {0} s：各帧的时间或刚体数量不同。</translation>
    </message>
    <message>
        <source>The key or certificate {0} cannot be read</source>
        <translation>无法读取密钥或证书 {0}</translation>
    </message>
    <message>
        <source>The key {0} is of a kind or size that is not taken</source>
        <translation>密钥 {0} 的类型或长度不被接受</translation>
    </message>
    <message>
        <source>The name {0} holds characters that do not travel: %, \ or line ends</source>
        <translation>名称 {0} 含有不能移交的字符：%、\ 或换行</translation>
    </message>
    <message>
        <source>The run {0} stands on a file that is no input of the case: SHA-256 {1}</source>
        <translation>计算 {0} 所依据的文件不是案例的输入：SHA-256 {1}</translation>
    </message>
    <message>
        <source>The run {0} stands on {1}, which did not travel: SHA-256 {2}</source>
        <translation>计算 {0} 依据 {1}，而它没有移交：SHA-256 {2}</translation>
    </message>
    <message>
        <source>The run {0} was stopped before its end</source>
        <translation>计算 {0} 在结束之前被停止</translation>
    </message>
    <message>
        <source>Unpacking the bundle</source>
        <translation>正在解包</translation>
    </message>
    <message>
        <source>Use a certificate that is valid now, or set the clock of this machine.</source>
        <translation>请使用现在有效的证书，或校正本机时钟。</translation>
    </message>
    <message>
        <source>Use another key.</source>
        <translation>请使用另一个密钥。</translation>
    </message>
    <message>
        <source>Wait until whatever writes it has ended, and seal again.</source>
        <translation>请等写入它的程序结束后再封存。</translation>
    </message>
    <message>
        <source>a place in the bag</source>
        <translation>封存内容中的位置</translation>
    </message>
    <message>
        <source>a record was left out or moved: this is the {0}. by its place, and says {1}</source>
        <translation>有记录被去掉或移动：按位置这是第 {0} 条，而它自称 {1}</translation>
    </message>
    <message>
        <source>a summary of one page in plain language</source>
        <translation>用通俗语言写的一页摘要</translation>
    </message>
    <message>
        <source>add what was found on the site to the case</source>
        <translation>将现场所得加入案例</translation>
    </message>
    <message>
        <source>altered or left out: record {0} names the SHA-256 {1}</source>
        <translation>被改动或遗漏：记录 {0} 所写的 SHA-256 为 {1}</translation>
    </message>
    <message>
        <source>altered: its SHA-256 is {0}, the list of files says {1}</source>
        <translation>被改动：其 SHA-256 为 {0}，文件清单为 {1}</translation>
    </message>
    <message>
        <source>damaged: it cannot be unpacked</source>
        <translation>已损坏：无法解包</translation>
    </message>
    <message>
        <source>entries of the journal are of a time before that of an earlier one</source>
        <translation>日志中有条目的时间早于之前的条目</translation>
    </message>
    <message>
        <source>entry {0} of the journal is of a time before that of an earlier one</source>
        <translation>日志第 {0} 个条目的时间早于之前的条目</translation>
    </message>
    <message>
        <source>entry {0} of the journal was altered, or misses the one before</source>
        <translation>日志的第 {0} 个条目被改动，或缺少前一个条目</translation>
    </message>
    <message>
        <source>files of the material have no digest</source>
        <translation>材料中有文件没有摘要</translation>
    </message>
    <message>
        <source>health breaches</source>
        <translation>健康超限</translation>
    </message>
    <message>
        <source>how far these settings are from the reference is not known</source>
        <translation>这些设置离基准有多远，并不知道</translation>
    </message>
    <message>
        <source>inputs do not travel: the bundle holds only their digests</source>
        <translation>输入不随封存包移交：封存包只含其摘要</translation>
    </message>
    <message>
        <source>it does not follow the record before it: one was altered or left out</source>
        <translation>与前一条记录不相连：有记录被改动或去掉</translation>
    </message>
    <message>
        <source>it is missing, or no list of files as it was written</source>
        <translation>缺失，或不是当初写出的文件清单</translation>
    </message>
    <message>
        <source>it is not what BagIt asks for</source>
        <translation>不是 BagIt 所要求的内容</translation>
    </message>
    <message>
        <source>it is of another version of the format</source>
        <translation>它是另一版本的格式</translation>
    </message>
    <message>
        <source>it is of {0}, before what it follows, {1}</source>
        <translation>其时间为 {0}，早于其前一条 {1}</translation>
    </message>
    <message>
        <source>its time of sealing is none: {0}</source>
        <translation>封存时间无效：{0}</translation>
    </message>
    <message>
        <source>left out: the list of files names it</source>
        <translation>被遗漏：文件清单中有它</translation>
    </message>
    <message>
        <source>look at it with rubble-cli verify before it is sealed</source>
        <translation>封存之前用 rubble-cli verify 查看</translation>
    </message>
    <message>
        <source>made by another build than this program, so its bits need not repeat here: {0}</source>
        <translation>由不同于本程序的构建生成，因此在此未必逐位重复：{0}</translation>
    </message>
    <message>
        <source>match their cameras and draw outlines of the debris, or take them out</source>
        <translation>匹配其相机并绘出堆积物的轮廓，或将其取出</translation>
    </message>
    <message>
        <source>measure it with rubble-cli accuracy, or in the panel Accuracy</source>
        <translation>用 rubble-cli accuracy 或在“精度”面板中测定</translation>
    </message>
    <message>
        <source>mend what the Health panel names, or acknowledge it with reasons</source>
        <translation>处理“健康”面板所指出之处，或说明理由予以确认</translation>
    </message>
    <message>
        <source>neither the statement nor a record has the digest {0} that is known of it</source>
        <translation>声明和各记录都没有已知的摘要 {0}</translation>
    </message>
    <message>
        <source>nobody vouches that the key {0} is the signer&apos;s: compare its fingerprint with one got another way</source>
        <translation>没有人担保密钥 {0} 属于签名者：请将其指纹与经其他途径得到的比较</translation>
    </message>
    <message>
        <source>not what was signed: the statement names the SHA-256 {0}</source>
        <translation>不是签名时的内容：声明所写的 SHA-256 为 {0}</translation>
    </message>
    <message>
        <source>only that build repeats them bit for bit; run them again, or keep it</source>
        <translation>只有该构建能逐位重复；请重新计算，或保留该构建</translation>
    </message>
    <message>
        <source>photographs are in the case, and nothing is compared with them</source>
        <translation>案例中有照片，但没有与之比较</translation>
    </message>
    <message>
        <source>public-key.pem</source>
        <translation>public-key.pem</translation>
    </message>
    <message>
        <source>put in: it lies in the container twice</source>
        <translation>被加入：在容器中出现两次</translation>
    </message>
    <message>
        <source>put in: it lies outside of the bag</source>
        <translation>被加入：位于封存内容之外</translation>
    </message>
    <message>
        <source>put in: no record names it</source>
        <translation>被加入：没有记录写到它</translation>
    </message>
    <message>
        <source>put in: the list of files does not name it</source>
        <translation>被加入：文件清单中没有它</translation>
    </message>
    <message>
        <source>runs were made by another build than this program</source>
        <translation>计算由不同于本程序的构建生成</translation>
    </message>
    <message>
        <source>save the case once the files are where it says</source>
        <translation>待文件位于案例所写之处后保存案例</translation>
    </message>
    <message>
        <source>save the case once with this version</source>
        <translation>用本版本保存一次案例</translation>
    </message>
    <message>
        <source>say in the note how the clock was set</source>
        <translation>在备注中说明时钟是如何设置的</translation>
    </message>
    <message>
        <source>sealed build</source>
        <translation>封存的构建</translation>
    </message>
    <message>
        <source>sealed on {0} by its own word, but the time stamp saw it before, on {1}</source>
        <translation>自称封存于 {0}，但时间戳更早，在 {1} 就已看到它</translation>
    </message>
    <message>
        <source>sealed on {0} by its own word; the time stamp proves it only for {1}, {2} later</source>
        <translation>自称封存于 {0}；时间戳只能证明 {1}，晚 {2}</translation>
    </message>
    <message>
        <source>sealed on {0}, which the clock of this machine has not reached</source>
        <translation>封存于 {0}，本机时钟尚未到达</translation>
    </message>
    <message>
        <source>sealed trajectory hash</source>
        <translation>封存的轨迹哈希</translation>
    </message>
    <message>
        <source>see what the Evidence panel says of them, or take them out</source>
        <translation>查看“证据”面板对其的说明，或将其取出</translation>
    </message>
    <message>
        <source>signed by the key {0}, not by the one expected, {1}</source>
        <translation>由密钥 {0} 签名，而不是预期的 {1}</translation>
    </message>
    <message>
        <source>surveys are in the case, and nothing is compared with them</source>
        <translation>案例中有测绘，但没有与之比较</translation>
    </message>
    <message>
        <source>the case has no journal, so who changed what in it cannot be told</source>
        <translation>案例没有日志，因此无法得知谁更改了什么</translation>
    </message>
    <message>
        <source>the case is not what its journal says</source>
        <translation>案例与其日志所述不同</translation>
    </message>
    <message>
        <source>the certificate beside the signature is of another key</source>
        <translation>签名旁的证书属于另一个密钥</translation>
    </message>
    <message>
        <source>the certificate of {0} ended on {1}, and the time is {2}</source>
        <translation>{0} 的证书已于 {1} 到期，而时间为 {2}</translation>
    </message>
    <message>
        <source>the certificate of {0} is valid from {1} only, and the time is {2}</source>
        <translation>{0} 的证书从 {1} 起才有效，而时间为 {2}</translation>
    </message>
    <message>
        <source>the certificate of {0} was not held against any that are trusted: none were given</source>
        <translation>{0} 的证书没有与任何受信任的证书对照：没有给出</translation>
    </message>
    <message>
        <source>the container was packed anew or altered, first at byte {0}; what lies in it is told of by the rest</source>
        <translation>容器被重新打包或改动，首先在第 {0} 字节；其中的内容由其余各项说明</translation>
    </message>
    <message>
        <source>the directory</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>the journal goes on until {0}, after the time of sealing, {1}</source>
        <translation>日志延续到 {0}，晚于封存时间 {1}</translation>
    </message>
    <message>
        <source>the journal is not the one that was sealed: {0} entries with the head {1}, sealed were {2} with the head {3}</source>
        <translation>日志不是封存时的那一份：{0} 个条目，末端为 {1}；封存时为 {2} 个，末端为 {3}</translation>
    </message>
    <message>
        <source>the key or certificate is not the one that the statement names</source>
        <translation>密钥或证书不是声明所写的那一个</translation>
    </message>
    <message>
        <source>the program was not tested on this machine</source>
        <translation>程序没有在本机上自检</translation>
    </message>
    <message>
        <source>the public key or the certificate beside the signature is damaged</source>
        <translation>签名旁的公钥或证书已损坏</translation>
    </message>
    <message>
        <source>the record of {0} is not signed</source>
        <translation>{0} 的记录没有签名</translation>
    </message>
    <message>
        <source>the report does not say who makes it</source>
        <translation>报告没有写明由谁编写</translation>
    </message>
    <message>
        <source>the report states no question that it answers</source>
        <translation>报告没有写明它所回答的问题</translation>
    </message>
    <message>
        <source>the request for the time stamp is damaged</source>
        <translation>时间戳请求已损坏</translation>
    </message>
    <message>
        <source>the result is held against no photograph and no survey</source>
        <translation>结果没有与任何照片或测绘对照</translation>
    </message>
    <message>
        <source>the results have no intervals: nothing was repeated</source>
        <translation>结果没有区间：没有重复</translation>
    </message>
    <message>
        <source>the run passed limits of health, and nobody vouches for it</source>
        <translation>计算超过了健康限值，没有人为其担保</translation>
    </message>
    <message>
        <source>the run stands alone: no case tells what was received and assumed</source>
        <translation>只有计算：没有案例说明接收了什么、作了何假设</translation>
    </message>
    <message>
        <source>the service granted no time stamp</source>
        <translation>服务机构没有给出时间戳</translation>
    </message>
    <message>
        <source>the signature does not hold: the text is not what the key {0} signed</source>
        <translation>签名不成立：该内容不是密钥 {0} 所签</translation>
    </message>
    <message>
        <source>the signature of the time stamp does not hold</source>
        <translation>时间戳的签名不成立</translation>
    </message>
    <message>
        <source>the statement of the signer is missing</source>
        <translation>缺少签名者的声明</translation>
    </message>
    <message>
        <source>the time stamp answers another request than the one that lies beside it</source>
        <translation>时间戳应答的是另一个请求，而不是其旁的那一个</translation>
    </message>
    <message>
        <source>the time stamp is damaged, or no answer of a time-stamping service (RFC 3161)</source>
        <translation>时间戳已损坏，或不是时间戳服务机构（RFC 3161）的应答</translation>
    </message>
    <message>
        <source>the time stamp is of another file</source>
        <translation>时间戳属于另一个文件</translation>
    </message>
    <message>
        <source>the time-stamping service {0} was not held against any that are trusted: none were given</source>
        <translation>时间戳服务机构 {0} 没有与任何受信任者对照：没有给出</translation>
    </message>
    <message>
        <source>those who are trusted do not vouch for the certificate of {0}: {1}</source>
        <translation>受信任者不为 {0} 的证书担保：{1}</translation>
    </message>
    <message>
        <source>those who are trusted do not vouch for the time-stamping service {0}: {1}</source>
        <translation>受信任者不为时间戳服务机构 {0} 担保：{1}</translation>
    </message>
    <message>
        <source>trajectory hash</source>
        <translation>轨迹哈希</translation>
    </message>
    <message>
        <source>what was not known was not varied</source>
        <translation>未知的量没有变化</translation>
    </message>
    <message>
        <source>what would change the opinion</source>
        <translation>什么会改变意见</translation>
    </message>
    <message>
        <source>who held the material before it came here, and what was done to it</source>
        <translation>材料到此之前由谁保管、做过什么</translation>
    </message>
    <message>
        <source>whoever opens the bundle needs these files to simulate again</source>
        <translation>打开封存包的人需要这些文件才能重新计算</translation>
    </message>
    <message>
        <source>{0} changed while it was sealed</source>
        <translation>{0} 在封存过程中发生了变化</translation>
    </message>
    <message>
        <source>{0} files lie in it, and {1} were sealed</source>
        <translation>其中有 {0} 个文件，封存时为 {1} 个</translation>
    </message>
    <message>
        <source>{0} has no input &quot;{1}&quot;</source>
        <translation>{0} 没有输入“{1}”</translation>
    </message>
    <message>
        <source>{0} holds neither a public key nor a certificate in PEM</source>
        <translation>{0} 既不含 PEM 格式的公钥，也不含证书</translation>
    </message>
    <message>
        <source>{0} holds no certificate in PEM</source>
        <translation>{0} 不含 PEM 格式的证书</translation>
    </message>
    <message>
        <source>{0} holds no private key in PEM</source>
        <translation>{0} 不含 PEM 格式的私钥</translation>
    </message>
    <message>
        <source>{0} is no sealed bundle: it does not begin as a zip container does</source>
        <translation>{0} 不是封存包：开头不是 zip 容器</translation>
    </message>
    <message>
        <source>{0} is no sealed bundle: it holds no bag (bagit.txt in one folder)</source>
        <translation>{0} 不是封存包：其中没有按 BagIt 组织的内容（一个文件夹中的 bagit.txt）</translation>
    </message>
    <message>
        <source>{0} is not as it was sealed, first {1}: {2}</source>
        <translation>{0} 与封存时不同，首先是 {1}：{2}</translation>
    </message>
    <message>
        <source>{0} is not empty, so nothing is unpacked there</source>
        <translation>{0} 不是空的，因此不在其中解包</translation>
    </message>
    <message>
        <source>{0} is not the input {1} that was sealed: its SHA-256 is another than {2}</source>
        <translation>{0} 不是封存的输入 {1}：其 SHA-256 不是 {2}</translation>
    </message>
    <message>
        <source>{0} is not what the journal says</source>
        <translation>{0} 与日志所述不同</translation>
    </message>
    <message>
        <source>{0} is protected by another passphrase than the one given</source>
        <translation>{0} 的口令与给出的不同</translation>
    </message>
    <message>
        <source>{0} says the same as the sealed case</source>
        <translation>{0} 与封存的案例所述相同</translation>
    </message>
    <message>
        <source>{0} was cut short or damaged: the directory at its end is missing</source>
        <translation>{0} 被截断或损坏：缺少末尾的目录</translation>
    </message>
    <message>
        <source>{0}: {1} is damaged: it cannot be unpacked</source>
        <translation>{0}：{1} 已损坏，无法解包</translation>
    </message>
    <message>
        <source>A survey is placed by three pairs or more, not by {0}</source>
        <translation>测绘由三对或更多的点对放置，而不是 {0} 对</translation>
    </message>
    <message>
        <source>Pick places that lie far apart and not on a line.</source>
        <translation>请选取相距较远且不在一条线上的地方。</translation>
    </message>
    <message>
        <source>The pair {0} has no place in the system of the case</source>
        <translation>点对 {0} 在案例的坐标系中没有位置</translation>
    </message>
    <message>
        <source>Check its numbers and the systems of survey and case.</source>
        <translation>请检查其数值以及测绘和案例的坐标系。</translation>
    </message>
    <message>
        <source>lengths of the survey are {0} times as long in the case</source>
        <translation>测绘中的长度在案例中为其 {0} 倍</translation>
    </message>
    <message>
        <source>check the unit of the survey (feet, millimetres) and the pairs</source>
        <translation>请检查测绘的单位（英尺、毫米）和点对</translation>
    </message>
    <message>
        <source>pairs lie farther than {0} from where the others place them</source>
        <translation>点对与其他点对所定的位置相差超过 {0}</translation>
    </message>
    <message>
        <source>pick them again, or leave them out</source>
        <translation>请重新选取，或将其略去</translation>
    </message>
    <message>
        <source>The pairs lie in one place or on a line: the turn about it is open</source>
        <translation>点对在同一处或一条线上：绕该线的转动不能确定</translation>
    </message>
    <message>
        <source>places whose debris had been removed before {0} are not compared</source>
        <translation>{0} 之前堆积物已被运走之处不作比较</translation>
    </message>
    <message>
        <source>debris was removed from places, and when the survey was taken is not known</source>
        <translation>有些地方的堆积物已被运走，而测绘的时间未知</translation>
    </message>
    <message>
        <source>say when the survey was taken; until then these places are compared</source>
        <translation>请说明测绘何时拍摄；在此之前这些地方仍参与比较</translation>
    </message>
    <message>
        <source>{0} was taken before the collapse: it shows no debris</source>
        <translation>{0} 拍摄于倒塌之前：其中没有堆积物</translation>
    </message>
    <message>
        <source>Take it as the terrain, or say that it was taken afterwards.</source>
        <translation>请将其用作地形，或说明它拍摄于倒塌之后。</translation>
    </message>
    <message>
        <source>the debris at {0}</source>
        <translation>{0} 时的堆积物</translation>
    </message>
    <message>
        <source>the debris at rest</source>
        <translation>静止的堆积物</translation>
    </message>
    <message>
        <source>the site before the collapse</source>
        <translation>倒塌之前的现场</translation>
    </message>
    <message>
        <source>nothing: no outline is drawn on it</source>
        <translation>无：其上没有画轮廓</translation>
    </message>
    <message>
        <source>where the case lies: {0} of {1} control points are used</source>
        <translation>案例的位置：{1} 个控制点中使用了 {0} 个</translation>
    </message>
    <message>
        <source>the registration tilts the survey by {0} degrees: its highest and lowest places lie up to {1} from where they should in plan</source>
        <translation>配准使测绘倾斜 {0} 度：最高和最低处在平面上与应在之处相差至多 {1}</translation>
    </message>
    <message>
        <source>register the points of the cloud before a raster is made of them</source>
        <translation>请在由点云的点生成栅格之前对点作配准</translation>
    </message>
    <message>
        <source>the registration of the case moves it by {0} and turns it by {1} degrees; {2} are left, and a place is known to {3}</source>
        <translation>案例的配准将其移动 {0}、转动 {1} 度；剩余 {2}，一处的位置已知到 {3}</translation>
    </message>
    <message>
        <source>the registration of the case moves it by {0} and turns it by {1} degrees; {2} are left, and how well a place is known is not known</source>
        <translation>案例的配准将其移动 {0}、转动 {1} 度；剩余 {2}，位置的准确程度未知</translation>
    </message>
    <message>
        <source>give more pairs, or state the error of the registration</source>
        <translation>请给出更多点对，或给定配准的误差</translation>
    </message>
    <message>
        <source>{0} holds heights above the ground, which no registration moves</source>
        <translation>{0} 的高程为地面以上的高度，配准不能移动它们</translation>
    </message>
    <message>
        <source>Take the registration of this survey out of the case.</source>
        <translation>请从案例中去掉该测绘的配准。</translation>
    </message>
    <message>
        <source>{0} has no point of the classes that are to be the ground: {1}</source>
        <translation>{0} 没有要用作地面的类别的点：{1}</translation>
    </message>
    <message>
        <source>Ask for classes that it has; rubble-cli cloud tells them.</source>
        <translation>请指定其中有的类别；rubble-cli cloud 会列出它们。</translation>
    </message>
    <message>
        <source>points of class {1} are the ground; {0} of other classes were left out</source>
        <translation>类别 {1} 的点为地面；略去了其他类别的 {0} 个点</translation>
    </message>
    <message>
        <source>Begin the table with the line {0}.</source>
        <translation>表格首行应为 {0}。</translation>
    </message>
    <message>
        <source>a class from 0 to 255</source>
        <translation>0 至 255 的类别</translation>
    </message>
    <message>
        <source>date and time, such as 2021-06-25 16:30:00</source>
        <translation>日期和时间，如 2021-06-25 16:30:00</translation>
    </message>
    <message>
        <source>A section needs a line with a length, a width, and at most {0} steps</source>
        <translation>剖面需要一条有长度和宽度的线，至多 {0} 步</translation>
    </message>
    <message>
        <source>Give two places apart from each other, or a greater step.</source>
        <translation>请给出相距的两处，或更大的步长。</translation>
    </message>
    <message>
        <source>Thin it, or cut out what is needed.</source>
        <translation>请将其抽稀，或裁取所需部分。</translation>
    </message>
    <message>
        <source>points of the drawing lie at height 0 while others have heights; they were left out</source>
        <translation>图中有些点的高程为 0，而其他点有高程；已将其略去</translation>
    </message>
    <message>
        <source>give them their heights if they belong to the section</source>
        <translation>若属于剖面，请给出其高程</translation>
    </message>
    <message>
        <source>a DXF names no coordinate system; it is taken to be that of the case, in metres</source>
        <translation>DXF 不说明坐标系；视为案例的坐标系，以米为单位</translation>
    </message>
    <message>
        <source>Give points with heights.</source>
        <translation>请给出有高程的点。</translation>
    </message>
    <message>
        <source>closed lines of the drawing were taken as edges of polygons</source>
        <translation>图中的闭合线被当作多边形的边</translation>
    </message>
    <message>
        <source>leave out layers whose lines are none</source>
        <translation>请去掉其线不是边界的图层</translation>
    </message>
    <message>
        <source>Give the heights as they were surveyed.</source>
        <translation>请给出测得的高程。</translation>
    </message>
    <message>
        <source>Images (*.png)</source>
        <translation>图片 (*.png)</translation>
    </message>
    <message>
        <source>check the ends of the line, or give a greater width</source>
        <translation>检查线的两端，或给出更大的宽度</translation>
    </message>
    <message>
        <source>check where the terrain ends</source>
        <translation>检查地形到何处为止</translation>
    </message>
    <message>
        <source>none of {0} points lies within the width of the line</source>
        <translation>{0} 个点中没有一个位于线的宽度以内</translation>
    </message>
    <message>
        <source>points lie where the simulated site has no surface; they were not compared</source>
        <translation>一些点所在之处模拟现场没有表面；未作比较</translation>
    </message>
    <message>
        <source>{0} holds heights above the ground, which belong to no place</source>
        <translation>{0} 中是离地高度，不对应任何位置</translation>
    </message>
    <message>
        <source>steps are as long as the heights of the survey lie apart: {0}</source>
        <translation>步长取为测绘高程的间距：{0}</translation>
    </message>
    <message>
        <source>The bodies that {0} allow are fragments alone. The engine moves loose structure beside them (loose_structure), {1} of {2} elements at one time (at {3}), which takes from that rate</source>
        <translation>{0} 所允许的刚体只计碎块。引擎在其之外还移动松脱结构（loose_structure），同一时刻 {2} 个单元中的 {1} 个（{3} 时），这会降低该帧率</translation>
    </message>
    <message>
        <source>The bodies that {0} allow are fragments alone. The engine moved loose structure beside them (loose_structure), {1} of {2} elements in all, and simulated at {3} times real time while fragments were born</source>
        <translation>{0} 所允许的刚体只计碎块。引擎在其之外还移动了松脱结构（loose_structure），共 {2} 个单元中的 {1} 个，碎块产生期间的模拟速度为实时的 {3} 倍</translation>
    </message>
    <message>
        <source>Take loose_structure = fe where the rate matters more than where the debris lies, or play the finished run</source>
        <translation>若帧率比堆积物的位置更重要，请取 loose_structure = fe，或播放完成的计算</translation>
    </message>
    <message>
        <source>live_islands = held holds what comes loose where the FE result ends, and nothing else: what the engine carries by then (loose_structure = at_once) goes on moving</source>
        <translation>live_islands = held 只固定有限元结果结束时才松脱的部分：引擎此时已带动的部分（loose_structure = at_once）继续运动</translation>
    </message>
    <message>
        <source>Take loose_structure = fe to hold all of it where the FE result leaves it</source>
        <translation>若要全部固定于有限元结果留下的位置，请取 loose_structure = fe</translation>
    </message>
    <message>
        <source>A table of bodies cannot be kept as {0}: it would no longer say which bodies it has</source>
        <translation>物体表不能存为 {0}：那样就不再说明有哪些物体</translation>
    </message>
    <message>
        <source>A table of bodies has the columns mass_kg, side_x_m, side_y_m, side_z_m (or mesh), x_m, y_m and z_m at least.</source>
        <translation>物体表至少要有列 mass_kg、side_x_m、side_y_m、side_z_m（或 mesh）、x_m、y_m 和 z_m。</translation>
    </message>
    <message>
        <source>Begin the table with the line name,easting,northing,height, in the order of its columns.</source>
        <translation>表的第一行写 name,easting,northing,height，按各列的次序。</translation>
    </message>
    <message>
        <source>Correct the line, or take the point out of the table.</source>
        <translation>改正该行，或把该点从表中去掉。</translation>
    </message>
    <message>
        <source>Give points of the picture the names that they have in the survey.</source>
        <translation>给照片中的点取其在测绘中的名称。</translation>
    </message>
    <message>
        <source>Give points their names: a column of a table, or texts of a drawing beside its points.</source>
        <translation>给出点的名称：表中的一列，或图中各点旁的文字。</translation>
    </message>
    <message>
        <source>Give the columns survey_x, survey_y and survey_z in numbers of the second cloud.</source>
        <translation>给出列 survey_x、survey_y 和 survey_z，按第二个点云的数值。</translation>
    </message>
    <message>
        <source>Give the name of such a file as seen from the folder of the table, or leave the field empty for a box.</source>
        <translation>给出这种文件的名称，从表所在的文件夹算起；长方体则把该栏留空。</translation>
    </message>
    <message>
        <source>Give the surface of a solid.</source>
        <translation>给出实体的表面。</translation>
    </message>
    <message>
        <source>Keep the one that counts: a pair is told by its name.</source>
        <translation>只留所要的一个：点对以名称识别。</translation>
    </message>
    <message>
        <source>Make it simpler: only its hull of at most 32 corners is simulated.</source>
        <translation>将其简化：模拟的只是其最多 32 个顶点的凸包。</translation>
    </message>
    <message>
        <source>Name a mesh, or give the three sides of a box.</source>
        <translation>指明网格，或给出长方体的三条边长。</translation>
    </message>
    <message>
        <source>Open the table itself wherever the copy was to be opened.</source>
        <translation>在要打开副本之处打开表本身。</translation>
    </message>
    <message>
        <source>Write it anew from the drawing, as DXF.</source>
        <translation>由图重新写为 DXF。</translation>
    </message>
    <message>
        <source>close its holes; the hull is simulated, with the mass of the table</source>
        <translation>封闭其孔洞；模拟的是凸包，质量按表</translation>
    </message>
    <message>
        <source>cut it into convex bodies if its hollows matter</source>
        <translation>若其凹处要紧，将其切成凸的物体</translation>
    </message>
    <message>
        <source>give them their heights if they are to count</source>
        <translation>若要计入，给出其高程</translation>
    </message>
    <message>
        <source>measured points without a name were left out</source>
        <translation>没有名称的测量点已略去</translation>
    </message>
    <message>
        <source>named points of the drawing lie at height 0 while others have heights; they were left out</source>
        <translation>图中有些有名称的点高程为 0，而其他点有高程；这些点已略去</translation>
    </message>
    <message>
        <source>none is needed unless one was meant to count</source>
        <translation>不需要，除非其中有要计入的</translation>
    </message>
    <message>
        <source>none is needed unless that is much of its size</source>
        <translation>不需要，除非这在其尺寸中占得多</translation>
    </message>
    <message>
        <source>the mesh of a body has more than {0} corners: points lie up to {1} outside of what is simulated</source>
        <translation>物体的网格顶点多于 {0} 个：有的点在所模拟的形状之外，最远 {1}</translation>
    </message>
    <message>
        <source>the mesh of a body is not closed: how much of its hull it fills is not known</source>
        <translation>物体的网格不封闭：不知其占凸包多少</translation>
    </message>
    <message>
        <source>the mesh of a body is not convex: it fills {0} % of its hull, which is simulated with the mass of the table</source>
        <translation>物体的网格不凸：占其凸包的 {0} %；模拟的是凸包，质量按表</translation>
    </message>
    <message>
        <source>{0} cannot be read as a DXF</source>
        <translation>{0} 不能作为 DXF 读取</translation>
    </message>
    <message>
        <source>{0} has no point with a name</source>
        <translation>{0} 中没有带名称的点</translation>
    </message>
    <message>
        <source>{0} has places in the system of a case, and there is none</source>
        <translation>{0} 中的位置按案例的坐标系，而此处没有案例</translation>
    </message>
    <message>
        <source>{0} has the point {1} twice</source>
        <translation>{0} 中点 {1} 出现两次</translation>
    </message>
    <message>
        <source>{0}: line {1} has &quot;{2}&quot; for the point {3}, which is no number</source>
        <translation>{0}：第 {1} 行点 {3} 的“{2}”不是数</translation>
    </message>
    <message>
        <source>{0}: line {1} has neither a mesh nor sides</source>
        <translation>{0}：第 {1} 行既没有网格也没有边长</translation>
    </message>
    <message>
        <source>{0}: line {1} names the mesh {2} of {3} triangles; a body may have {4}</source>
        <translation>{0}：第 {1} 行指明的网格 {2} 有 {3} 个三角形；一个物体最多 {4} 个</translation>
    </message>
    <message>
        <source>{0}: line {1} names the mesh {2}, which is no STL, OBJ or PLY there</source>
        <translation>{0}：第 {1} 行指明的网格 {2} 不是该处的 STL、OBJ 或 PLY 文件</translation>
    </message>
    <message>
        <source>{0}: line {1} names the mesh {2}, which spans no volume</source>
        <translation>{0}：第 {1} 行指明的网格 {2} 没有体积</translation>
    </message>
    <message>
        <source>{0}: no measured point is called {1}</source>
        <translation>{0}：没有测量点名为 {1}</translation>
    </message>
    <message>
        <source>{0}: the first line does not name the columns of measured points</source>
        <translation>{0}：第一行没有写明测量点的各列</translation>
    </message>
    <message>
        <source>Give several cases or FE results, or a case with several scenarios.</source>
        <translation>给出几个案例或有限元结果，或一个含几个方案的案例。</translation>
    </message>
    <message>
        <source>There are no two causes that further evidence could tell apart.</source>
        <translation>没有两个可由进一步证据区分的原因。</translation>
    </message>
    <message>
        <source>Trying which evidence would tell</source>
        <translation>正在尝试哪种证据能够说明</translation>
    </message>
    <message>
        <source>a heading without text</source>
        <translation>没有文字的标题</translation>
    </message>
    <message>
        <source>heights of all debris</source>
        <translation>全部堆积物的高度</translation>
    </message>
    <message>
        <source>heights of the part x = {0} to {1}, y = {2} to {3} m</source>
        <translation>x = {0} 至 {1}、y = {2} 至 {3} m 部分的高度</translation>
    </message>
    <message>
        <source>no cause is ranked</source>
        <translation>没有原因被排序</translation>
    </message>
    <message>
        <source>outline of all debris</source>
        <translation>全部堆积物的轮廓</translation>
    </message>
    <message>
        <source>outline of the part x = {0} to {1}, y = {2} to {3} m</source>
        <translation>x = {0} 至 {1}、y = {2} 至 {3} m 部分的轮廓</translation>
    </message>
    <message>
        <source>photograph of the debris at rest from x = {0}, y = {1}, towards its middle</source>
        <translation>从 x = {0}、y = {1} 朝堆积物中部拍摄的静止照片</translation>
    </message>
    <message>
        <source>run rubble-cli validate once with this version, or Help &gt; Validation</source>
        <translation>用此版本运行一次 rubble-cli validate，或“帮助 &gt; 验证”</translation>
    </message>
    <message>
        <source>shorten it to 3,000 letters</source>
        <translation>缩短到 1,500 个汉字</translation>
    </message>
    <message>
        <source>text before the first heading</source>
        <translation>首个标题之前的文字</translation>
    </message>
    <message>
        <source>the program was not held against measured falls on this machine: its error is not known</source>
        <translation>本机上没有把程序与实测的下落比较：其误差未知</translation>
    </message>
    <message>
        <source>the summary in plain language is longer than a page</source>
        <translation>通俗摘要超过一页</translation>
    </message>
    <message>
        <source>{0} is not what rubble-cli compare --json prints of causes and evidence: {1}</source>
        <translation>{0} 不是 rubble-cli compare --json 打印的原因和证据：{1}</translation>
    </message>
    <message>
        <source>{0}, line {1}: {2} is no part of what a report lets its author say</source>
        <translation>{0} 第 {1} 行：{2} 不属于报告中由作者说明的部分</translation>
    </message>
    <message>
        <source>simulate the ensemble of the case: rubble-cli ensemble, or on the page Ensemble</source>
        <translation>请模拟案例的系综：rubble-cli ensemble，或在系综页</translation>
    </message>
    <message>
        <source>which other causes were considered, and how each was excluded (rubble-cli compare, or the page Causes)</source>
        <translation>考虑过哪些其他原因，以及如何逐一排除（rubble-cli compare，或原因页）</translation>
    </message>
    <message>
        <source>Hand over report.html beside it, which has them.</source>
        <translation>请提供旁边的 report.html，其中有这些标记。</translation>
    </message>
    <message>
        <source>The report as PDF has no tags for screen readers: {0}</source>
        <translation>PDF 报告没有供读屏软件使用的标记：{0}</translation>
    </message>
    <message>
        <source>Give the standard deviation of the place in m.</source>
        <translation>请给出该处以 m 计的标准差。</translation>
    </message>
    <message>
        <source>of some control points nobody states how accurate they are: they were taken as the others</source>
        <translation>部分控制点无人给出精度：按其余控制点取值</translation>
    </message>
    <message>
        <source>set water=on and simulate again</source>
        <translation>请设 water=on 并重新模拟</translation>
    </message>
    <message>
        <source>state it for each pair</source>
        <translation>请为每一对给出</translation>
    </message>
    <message>
        <source>{0} pieces of debris ran to below the level of the water, which acted on nothing: no flight leads there</source>
        <translation>{0} 块碎块滚到水位以下，而水未起作用：任何抛落都到不了那里</translation>
    </message>
    <message>
        <source>{0}, line {1}: {2} is below zero</source>
        <translation>{0} 第 {1} 行：{2} 小于零</translation>
    </message>
    <message>
        <source>Give a footprint, a height model, a time, or photographs with an outline.</source>
        <translation>请给出覆盖范围、高程模型、时刻，或绘有轮廓的照片。</translation>
    </message>
    <message>
        <source>Lube et al., J. Fluid Mech. 508 (2004) 175: run-out 1.6 a^0.5 and height 0.88 a^(1/6) of tall columns, whatever the grains; Trepanier &amp; Franklin, Phys. Rev. E 82 (2010) 011308: columns of rods, exponent of the run-out of tall ones 0.6 +- 0.1</source>
        <translation>Lube 等，J. Fluid Mech. 508 (2004) 175：高柱的散落距离 1.6 a^0.5 和高度 0.88 a^(1/6)，与颗粒无关；Trepanier &amp; Franklin，Phys. Rev. E 82 (2010) 011308：杆的柱，高柱散落距离的指数 0.6 +- 0.1</translation>
    </message>
    <message>
        <source>Of these hypotheses &quot;{0}&quot; explains the times best: one of its members is closer than one of &quot;{1}&quot; in {2} % of the pairs, at least {3} % with 95 % confidence. A cause that is not among them may give the same times.</source>
        <translation>在这些假设中 “{0}” 最能解释各时刻：在 {2} % 的成员对中，它的一个成员比 “{1}” 的一个成员更接近，95 % 置信度下至少 {3} %。不在其中的原因可能给出同样的时刻。</translation>
    </message>
    <message>
        <source>Round columns of cubes, rods and plates collapse</source>
        <translation>立方体、杆和板的圆柱坍塌</translation>
    </message>
    <message>
        <source>as many rows, columns and times</source>
        <translation>同样多的行、列和时刻</translation>
    </message>
    <message>
        <source>assumed: the sources find that it matters little</source>
        <translation>假定：来源发现其影响很小</translation>
    </message>
    <message>
        <source>cubes of 0.18 m: the law of irregular grains</source>
        <translation>0.18 m 的立方体：不规则颗粒的定律</translation>
    </message>
    <message>
        <source>plates 3 : 3 : 1 of the same volume: no measurement of plates is known, so the law of irregular grains</source>
        <translation>同体积的板，3 : 3 : 1：未知有对板的测量，因此用不规则颗粒的定律</translation>
    </message>
    <message>
        <source>rods 4 : 1 : 1 of the same volume: the measured exponent of rods</source>
        <translation>同体积的杆，4 : 1 : 1：杆的实测指数</translation>
    </message>
    <message>
        <source>the index of a square</source>
        <translation>方格的编号</translation>
    </message>
    <message>
        <source>time at which debris first lay in the part x = {0} to {1}, y = {2} to {3} m, within {4}</source>
        <translation>堆积物首次位于 x = {0} 至 {1}、y = {2} 至 {3} m 部分的时刻，准确到 {4}</translation>
    </message>
    <message>
        <source>columns of cubes</source>
        <translation>立方体的柱</translation>
    </message>
    <message>
        <source>columns of plates</source>
        <translation>板的柱</translation>
    </message>
    <message>
        <source>columns of rods</source>
        <translation>杆的柱</translation>
    </message>
    <message>
        <source>bodies of {0}: one that falls over its edge turns by 1.5 degrees in a step (at least {1}, at most {2} a second)</source>
        <translation>{0} 的刚体：绕棱翻倒的刚体每步转动 1.5 度（每秒至少 {1}，至多 {2}）</translation>
    </message>
    <message>
        <source>fitted on the other half, judged on the one</source>
        <translation>用另一半拟合，用这一半评判</translation>
    </message>
    <message>
        <source>the same at 240 steps a second, six times the least of a collapse</source>
        <translation>同上，每秒 240 步，为倒塌最少步数的六倍</translation>
    </message>
    <message>
        <source>the same wall at 120 steps a second, three times the least of a collapse</source>
        <translation>同一面墙，每秒 120 步，为倒塌最少步数的三倍</translation>
    </message>
    <message>
        <source>Put the file with the SHA-256 {0} there.</source>
        <translation>请把 SHA-256 为 {0} 的文件放在那里。</translation>
    </message>
    <message>
        <source>{0}, which is read with the input {1}, is not there or not the file that was sealed</source>
        <translation>与输入 {1} 一同读取的 {0} 不存在，或不是封存时的文件</translation>
    </message>
    <message>
        <source>Give a mesh in one of these formats, or a point cloud.</source>
        <translation>请给出其中一种格式的网格，或点云。</translation>
    </message>
    <message>
        <source>a point cloud of the surroundings is taken as a surface with a height every {0}, without vegetation and wires</source>
        <translation>周围环境的点云按每 {0} 一个高程的表面采用，不含植被和电线</translation>
    </message>
    <message>
        <source>give the cloud in the system of the case, or a mesh of it</source>
        <translation>请给出案例坐标系中的点云，或其网格</translation>
    </message>
    <message>
        <source>none is needed; what hangs over the ground is not told from it</source>
        <translation>无需处理；悬于地面之上的部分无法区分</translation>
    </message>
    <message>
        <source>the offset was not added, for this is a point cloud: it lies as its coordinates say</source>
        <translation>未加偏移，因为这是点云：它按其坐标放置</translation>
    </message>
    <message>
        <source>{0} does not end in .obj, .ply, .stl, .gltf or .glb, and is no point cloud</source>
        <translation>{0} 不以 .obj、.ply、.stl、.gltf 或 .glb 结尾，也不是点云</translation>
    </message>
    <message>
        <source>Open that case, then choose the run again.</source>
        <translation>请先打开该案例，再选择此次计算。</translation>
    </message>
    <message>
        <source>Put that file there or beside the run, or open the case and choose the run again.</source>
        <translation>请将该文件放回原处或放在计算文件旁，或打开案例后再选择此次计算。</translation>
    </message>
    <message>
        <source>The run {0} was made from {1}, which is not there</source>
        <translation>计算 {0} 由 {1} 得出，但该文件不在那里</translation>
    </message>
    <message>
        <source>The run {0} was made in a case that says how {1} is read</source>
        <translation>计算 {0} 是在规定了如何读取 {1} 的案例中得出的</translation>
    </message>
    <message>
        <source>Delete it: it is made anew from the cloud when it is needed.</source>
        <translation>请删除：需要时由点云重新生成。</translation>
    </message>
    <message>
        <source>Give a cloud that has points, and check what was left out and why.</source>
        <translation>请给出有点的点云，并查看略去了什么、为什么。</translation>
    </message>
    <message>
        <source>Laying points into levels</source>
        <translation>正在把点分层</translation>
    </message>
    <message>
        <source>Reading the cloud for its digest</source>
        <translation>正在读取点云以计算其摘要</translation>
    </message>
    <message>
        <source>The octree of {0} can be written neither beside it nor to {1}: {2}</source>
        <translation>{0} 的八叉树既不能写在其旁，也不能写到 {1}：{2}</translation>
    </message>
    <message>
        <source>Make room on either disk: about {0} MB are needed while it is made. RUBBLE_CACHE names another folder.</source>
        <translation>请在其中一个磁盘上腾出空间：生成时约需 {0} MB。RUBBLE_CACHE 可指定另一个文件夹。</translation>
    </message>
    <message>
        <source>Adding photographs of the cloud</source>
        <translation>正在添加点云的照片</translation>
    </message>
    <message>
        <source>Reading photographs of the cloud</source>
        <translation>正在读取点云的照片</translation>
    </message>
    <message>
        <source>No point is left of {0}</source>
        <translation>{0} 中没有剩下任何点</translation>
    </message>
    <message>
        <source>pictures without a pinhole and a pose were left out</source>
        <translation>没有针孔相机和位姿的图片已略去</translation>
    </message>
    <message>
        <source>pose of the cloud</source>
        <translation>点云的位姿</translation>
    </message>
    <message>
        <source>the camera is the one that the cloud states for its picture: how well it is known nobody said, and no spread here holds it</source>
        <translation>相机取自点云对其图片的说明：无人说明其准确程度，此处的任何离散都不包含它</translation>
    </message>
    <message>
        <source>write them out with rubble-cli cloud --photographs and place them by pairs of points</source>
        <translation>用 rubble-cli cloud --photographs 写出，并用点对放置</translation>
    </message>
    <message>
        <source>{0} is no octree of a cloud, or damaged</source>
        <translation>{0} 不是点云的八叉树，或已损坏</translation>
    </message>
    <message>
        <source>Match its camera by points in the window.</source>
        <translation>请在窗口中用点来匹配其相机。</translation>
    </message>
    <message>
        <source>Try again once it is complete.</source>
        <translation>待其完整后重试。</translation>
    </message>
    <message>
        <source>as the cloud states it for its picture: how well place and turn are known nobody said</source>
        <translation>按点云为其图像所述：位置与转角的精度无人说明</translation>
    </message>
    <message>
        <source>{0} changed while its octree was made</source>
        <translation>制作八叉树期间 {0} 已改变</translation>
    </message>
    <message>
        <source>{0} x {1} pixels, upright, where the cloud states the camera of {2} x {3}: the photograph is added without it</source>
        <translation>照片转正后为 {0} × {1} 像素，而点云所述相机为 {2} × {3} 像素：添加照片时不采用该相机</translation>
    </message>
    <message>
        <source>reading what is kept of {0} members of the ensemble</source>
        <translation>正在读取系综 {0} 个成员中已保存的内容</translation>
    </message>
    <message>
        <source>Show its points anew, and export then.</source>
        <translation>请重新显示其点，然后再导出。</translation>
    </message>
    <message>
        <source>{0} changed after its points were read</source>
        <translation>{0} 在读取其点之后已改变</translation>
    </message>
    <message>
        <source>Ask for 1 to 120 pictures per second, a pace from 0.00000001 to 1000 and at most {0} pictures in all.</source>
        <translation>请设为每秒 1 至 120 幅、快慢 0.00000001 至 1000，总共至多 {0} 幅。</translation>
    </message>
    <message>
        <source>the comparison of causes that the report names does not travel by itself</source>
        <translation>报告所引用的原因比较不会自动随包携带</translation>
    </message>
    <message>
        <source>far from all debris the survey lies {0} above the ground, in the median of {1} cells</source>
        <translation>在远离所有堆积物处，测绘高于地面 {0}（{1} 个单元的中位数）</translation>
    </message>
    <message>
        <source>far from all debris the survey lies {0} below the ground, in the median of {1} cells</source>
        <translation>在远离所有堆积物处，测绘低于地面 {0}（{1} 个单元的中位数）</translation>
    </message>
    <message>
        <source>heights count from {0} on; the level of detection (95 %) is {1}, of a noise of {2} estimated from {3} cells far from all debris</source>
        <translation>高度从 {0} 起计入；检测限（95 %）为 {1}，来自由远离所有堆积物的 {3} 个单元估计的噪声 {2}</translation>
    </message>
    <message>
        <source>heights count from {0} on; the level of detection (95 %) is {1}, of the stated noise of {2}</source>
        <translation>高度从 {0} 起计入；检测限（95 %）为 {1}，来自所给的噪声 {2}</translation>
    </message>
    <message>
        <source>if that is no debris (vehicles, trees, houses), give an area of interest or leave it out; else no hypothesis explains it</source>
        <translation>若那不是堆积物（车辆、树木、房屋），请给出关注区域或将其排除；否则没有假设能解释它</translation>
    </message>
    <message>
        <source>none is needed; what lies lower is taken for ground on both sides</source>
        <translation>不需要；更低之处两侧都视为地面</translation>
    </message>
    <message>
        <source>state the noise of the survey and of the ground in the case</source>
        <translation>请在案例中给出测绘和地面的噪声</translation>
    </message>
    <message>
        <source>the noise of surveyed heights is not known: none is stated, and too few cells lie far from all debris; heights count from {0} on</source>
        <translation>测绘高度的噪声未知：没有给出，且远离所有堆积物的单元太少；高度从 {0} 起计入</translation>
    </message>
    <message>
        <source>{0} of {1} that were seen lie farther than {2} from the debris of every member of every hypothesis</source>
        <translation>所见的 {1} 中有 {0} 距每个假设的每个成员的堆积物都超过 {2}</translation>
    </message>
    <message>
        <source>Check the coordinate system of the raster and that of the case.</source>
        <translation>请检查栅格和案例的坐标系。</translation>
    </message>
    <message>
        <source>Check the index; its writer may have been started twice.</source>
        <translation>请检查索引；其写入程序可能启动了两次。</translation>
    </message>
    <message>
        <source>Files that are listed more than once for a state were read once</source>
        <translation>为同一状态重复列出的文件只读取了一次</translation>
    </message>
    <message>
        <source>Nodes beside the corners were left out where nothing says whether edges or faces are curved</source>
        <translation>角点以外的节点已略去，而边或面是否弯曲无从得知</translation>
    </message>
    <message>
        <source>Solids stand on the same nodes as others that live with them: their mass counts twice</source>
        <translation>实体单元与同时存在的其他实体单元共用全部节点：其质量重复计入</translation>
    </message>
    <message>
        <source>Take one of them out of the model; if both are meant, give them densities that add up.</source>
        <translation>请从模型中去掉其中一个；若两者均有意保留，请使其密度之和等于应有的密度。</translation>
    </message>
    <message>
        <source>The edges of {0} have no place in &quot;{1}&quot;, the system of the case</source>
        <translation>{0} 的边缘在案例的坐标系“{1}”中没有位置</translation>
    </message>
    <message>
        <source>cut it to the site if finer pixels are needed there</source>
        <translation>若该处需要更细的像素，请将其裁剪到场地范围</translation>
    </message>
    <message>
        <source>its offsets lie outside its connectivity</source>
        <translation>其偏移量超出连接表的范围</translation>
    </message>
    <message>
        <source>the name of a section</source>
        <translation>段的名称</translation>
    </message>
    <message>
        <source>the orthophoto is read from x = {0} to {1}, y = {2} to {3}, ten heights about the structure; it goes on {4} beyond, which is cut off</source>
        <translation>正射影像的读取范围为 x = {0} 至 {1}，y = {2} 至 {3}，即结构周围十倍高度；影像在此之外还延伸 {4}，该部分被截去</translation>
    </message>
    <message>
        <source>{0} by {1} pixels of {2} are more than can be drawn: the orthophoto is read as {3} by {4} of {5}</source>
        <translation>{0} × {1} 个 {2} 的像素超出可绘制的数目：正射影像以 {3} × {4} 个 {5} 的像素读取</translation>
    </message>
    <message>
        <source>{0} lies at x = {1} to {2}, y = {3} to {4} of the local frame; the structure stands at x = {5} to {6}, y = {7} to {8}, and surroundings count within x = {9} to {10}, y = {11} to {12}</source>
        <translation>{0} 位于局部坐标框架的 x = {1} 至 {2}，y = {3} 至 {4}；结构位于 x = {5} 至 {6}，y = {7} 至 {8}，周围环境的有效范围为 x = {9} 至 {10}，y = {11} 至 {12}</translation>
    </message>
    <message>
        <source>Name their unit (gdal_edit.py -a_offset and -a_scale, or the band&apos;s unit): cm or mm look so.</source>
        <translation>请注明其单位（gdal_edit.py -a_offset 和 -a_scale，或波段的单位）：cm 或 mm 看起来如此。</translation>
    </message>
    <message>
        <source>None of the heights of {0} can be one of land: {1}, say</source>
        <translation>{0} 的高度中没有一个可能是陆地的高度，例如 {1}</translation>
    </message>
    <message>
        <source>register it by pairs or by a fit, so that what is left of it is known</source>
        <translation>请用点对或拟合配准，以便知道剩余多少</translation>
    </message>
    <message>
        <source>the registration of the case moves it by {0} and turns it by {1} degrees, and does not say by what it was found; a place is known to {2}</source>
        <translation>案例的配准将其移动 {0}、转动 {1} 度，没有说明由何得出；一处的位置已知到 {2}</translation>
    </message>
    <message>
        <source>the registration of the case moves it by {0} and turns it by {1} degrees, and says neither by what it was found nor how well a place is known</source>
        <translation>案例的配准将其移动 {0}、转动 {1} 度，既没有说明由何得出，也没有说明一处的位置已知到多少</translation>
    </message>
    <message>
        <source>Copy it again, or take it away: the series is then read without this state.</source>
        <translation>重新复制该文件，或将其移走：此时读取序列时不含该状态。</translation>
    </message>
    <message>
        <source>Nodes of elements have no displacement along some axes: they were left at rest along them</source>
        <translation>单元的节点沿某些轴没有位移：沿这些轴保持静止位置</translation>
    </message>
    <message>
        <source>Nothing to do if no element resists there, as trusses and plane models do not.</source>
        <translation>如果没有单元在该方向上起作用（如桁架和平面模型），则无需处理。</translation>
    </message>
    <message>
        <source>Nothing to do: the states of the other steps were read.</source>
        <translation>无需处理：其他分析步的状态已读取。</translation>
    </message>
    <message>
        <source>Shapes of frequencies or of buckling are no states of a course of time: they were left out</source>
        <translation>频率或屈曲的振型不是随时间变化的状态：已略去</translation>
    </message>
    <message>
        <source>Write s, ms or us, as in &quot;time [ms]&quot;; without a unit the list counts as the result does.</source>
        <translation>写 s、ms 或 us，如“time [ms]”；不写单位时，清单按结果的时间单位计。</translation>
    </message>
    <message>
        <source>Write the times as the result counts them, and no unit into the heading.</source>
        <translation>按结果的时间单位写时间，表头中不写单位。</translation>
    </message>
    <message>
        <source>a buckling analysis</source>
        <translation>屈曲分析</translation>
    </message>
    <message>
        <source>a frequency analysis</source>
        <translation>频率分析</translation>
    </message>
    <message>
        <source>some of its entries have a timestep, others of one part have none</source>
        <translation>其部分条目有 timestep，而同一部分的其他条目没有</translation>
    </message>
    <message>
        <source>{0} is empty: its state is not there</source>
        <translation>{0} 是空文件：其状态不存在</translation>
    </message>
    <message>
        <source>{0} is {1} of CalculiX, whose shapes are no states of a course of time</source>
        <translation>{0} 是 CalculiX 的{1}，其振型不是随时间变化的状态</translation>
    </message>
    <message>
        <source>{0}: the heading &quot;{1}&quot; names a unit of time that is not known</source>
        <translation>{0}：表头“{1}”所写的时间单位未知</translation>
    </message>
    <message>
        <source>{0}: the heading &quot;{1}&quot; names a unit of time, but the result does not count in seconds</source>
        <translation>{0}：表头“{1}”写了时间单位，但结果不以秒计</translation>
    </message>
    <message>
        <source>Simulate at least {0} members of each cause.</source>
        <translation>请为每个原因至少模拟 {0} 个成员。</translation>
    </message>
    <message>
        <source>Place its camera by pairs of points until the match is good, or compare without it.</source>
        <translation>请以点对确定其相机位置，直到匹配良好，或不用它进行比较。</translation>
    </message>
    <message>
        <source>With {0} members it cannot be told whether the evidence lies outside of what a cause does</source>
        <translation>只有 {0} 个成员，无法判断证据是否落在某个原因所及之外</translation>
    </message>
    <message>
        <source>An addendum must name who makes it</source>
        <translation>附录必须写明由谁制作</translation>
    </message>
    <message>
        <source>An entry of custody must name who received the bundle, and from whom</source>
        <translation>保管条目必须写明由谁接收封存包，以及从何人处接收</translation>
    </message>
    <message>
        <source>Say who it was.</source>
        <translation>请写明是谁。</translation>
    </message>
    <message>
        <source>it asks for a time stamp of something else</source>
        <translation>它请求的是其他内容的时间戳</translation>
    </message>
    <message>
        <source>it does not list what its case assumes otherwise than the sealed one</source>
        <translation>它没有列出其案例与封存案例的不同假设</translation>
    </message>
    <message>
        <source>it does not name who received the bundle, and from whom</source>
        <translation>它没有写明由谁接收封存包，以及从何人处接收</translation>
    </message>
    <message>
        <source>it is of {0}, which the clock of this machine has not reached</source>
        <translation>其时间为 {0}，本机时钟尚未到达</translation>
    </message>
    <message>
        <source>left out: the request for the time stamp was sealed with it</source>
        <translation>被去掉：时间戳的请求曾一同封存</translation>
    </message>
    <message>
        <source>made with {0} = {1}, where the case has {2}</source>
        <translation>计算所用 {0} = {1}，而案例中为 {2}</translation>
    </message>
    <message>
        <source>put in: nothing of a sealed bundle lies there</source>
        <translation>被放入：封存包在此处没有内容</translation>
    </message>
    <message>
        <source>run the case as it is, or save it as it was run; the bundle says which settings these are</source>
        <translation>按案例现状计算，或按计算时的设置保存案例；封存包写明是哪些设置</translation>
    </message>
    <message>
        <source>runs were made under other settings than those of the case</source>
        <translation>计算所用的设置与案例不同</translation>
    </message>
    <message>
        <source>the SHA-256 of what was received, {0}, cannot be proven: a time stamp was put in afterwards</source>
        <translation>所接收内容的 SHA-256 {0} 无法证明：此后放入了时间戳</translation>
    </message>
    <message>
        <source>what was received had the SHA-256 {0}, and not {1}, which it names</source>
        <translation>所接收内容的 SHA-256 为 {0}，而不是所写的 {1}</translation>
    </message>
    <message>
        <source>Begin each part once, with text below: # custody, # alternatives, # change, # summary, # qualification.</source>
        <translation>每部分只开始一次，其下有文字：# custody、# alternatives、# change、# summary、# qualification。</translation>
    </message>
    <message>
        <source>what qualifies its author, and what binds them to a party</source>
        <translation>作者有何资质，与哪一方有何关系</translation>
    </message>
    <message>
        <source>Bring both to one unit.</source>
        <translation>请将两者换算为同一单位。</translation>
    </message>
    <message>
        <source>Check the coordinate systems of the polygons and of the cloud.</source>
        <translation>请检查多边形和点云的坐标系。</translation>
    </message>
    <message>
        <source>Choose an origin of the frame near the model, or export the run for ParaView (vtkhdf).</source>
        <translation>在模型附近选择坐标框架原点，或将计算导出到 ParaView (vtkhdf)。</translation>
    </message>
    <message>
        <source>Correct the heading, or name the system that the numbers are in.</source>
        <translation>请更正表头，或给出这些数所在的坐标系。</translation>
    </message>
    <message>
        <source>Correct z, or the datum of one of the two, or lift them out: rubble-cli drop --lift.</source>
        <translation>请更正 z 或两者之一的高程基准，或将其抬出：rubble-cli drop --lift。</translation>
    </message>
    <message>
        <source>Find the file and save the case anew, or seal without it: rubble-cli seal --leave-out {0}; its digest stays.</source>
        <translation>请找到文件并重新保存案例，或不带它封存：rubble-cli seal --leave-out {0}；其摘要保留。</translation>
    </message>
    <message>
        <source>Give another name, or replace it: rubble-cli convert --force.</source>
        <translation>请改用其他名称，或覆盖它：rubble-cli convert --force。</translation>
    </message>
    <message>
        <source>Give the offset that was taken off its coordinates (--mesh-offset), put the offset file beside it, or check system and control points of the case.</source>
        <translation>请给出从其坐标中减去的偏移（--mesh-offset），将偏移文件放在其旁，或检查案例的坐标系和控制点。</translation>
    </message>
    <message>
        <source>Give them places or times of their own, or let them fall without meeting: rubble-cli drop --apart.</source>
        <translation>请给出各自的位置或时刻，或让它们互不相遇地下落：rubble-cli drop --apart。</translation>
    </message>
    <message>
        <source>Install Slurm&apos;s client programs (Debian: slurm-client) and its slurm.conf, or compute elsewhere (--executor commands).</source>
        <translation>请安装 Slurm 的客户端程序（Debian：slurm-client）及其 slurm.conf，或在别处计算（--executor commands）。</translation>
    </message>
    <message>
        <source>Join an input of many files first (rubble-cli convert), or seal without it: rubble-cli seal --leave-out ID.</source>
        <translation>请先合并由许多文件组成的输入（rubble-cli convert），或不带它封存：rubble-cli seal --leave-out ID。</translation>
    </message>
    <message>
        <source>Make it anew: rubble-cli compare --json.</source>
        <translation>重新生成：rubble-cli compare --json。</translation>
    </message>
    <message>
        <source>None of {0} core points of {1} lies within the area of interest and outside of what is left out</source>
        <translation>{1} 的 {0} 个核心点中没有一个位于关注区域之内且在不计部分之外</translation>
    </message>
    <message>
        <source>Open a *.run.h5 file that the window saved, or rubble-cli run --out.</source>
        <translation>请打开由窗口或 rubble-cli run --out 保存的 *.run.h5 文件。</translation>
    </message>
    <message>
        <source>Places of this run would lie up to {0} m from those recorded; a page allows {1} m</source>
        <translation>此计算的位置与记录值最多会相差 {0} m；网页允许 {1} m</translation>
    </message>
    <message>
        <source>Time them again on a quiet machine (--retime).</source>
        <translation>请在空闲机器上重新计时（--retime）。</translation>
    </message>
    <message>
        <source>Write the unit as m, cm, mm, km, ft or US ft, or leave the brackets out.</source>
        <translation>请用米、厘米、毫米、千米、英尺或美国测量英尺的缩写写明单位，或去掉括号。</translation>
    </message>
    <message>
        <source>a kind of evidence</source>
        <translation>证据的一个种类</translation>
    </message>
    <message>
        <source>add it: rubble-cli seal --add FILE</source>
        <translation>将其加入：rubble-cli seal --add FILE</translation>
    </message>
    <message>
        <source>ask for metres (rubble-cli cloud --metres), and give all lengths in them</source>
        <translation>请要求以米计（rubble-cli cloud --metres），并以米给出所有长度</translation>
    </message>
    <message>
        <source>check the coordinate systems of survey and case and the control points, or place the survey by pairs</source>
        <translation>检查测量和案例的坐标系及控制点，或按点对放置测量</translation>
    </message>
    <message>
        <source>correct z, or lift them out: rubble-cli drop --lift</source>
        <translation>更正 z，或将其抬出：rubble-cli drop --lift</translation>
    </message>
    <message>
        <source>if that is no debris (vehicles, trees, houses), give an area of interest or leave it out (--area, --leave-out)</source>
        <translation>若那不是堆积物（车辆、树木、房屋），请给出关注区域或将其略去（--area、--leave-out）</translation>
    </message>
    <message>
        <source>let at least two repeats be simulated (--repeats)</source>
        <translation>请至少模拟两次重复（--repeats）</translation>
    </message>
    <message>
        <source>let the self-test run (--self-test)</source>
        <translation>请运行自检（--self-test）</translation>
    </message>
    <message>
        <source>lines that are no points were left out, the first of them line {0}: they have too few numbers, or words for them</source>
        <translation>不是点的行已略去，其中第一行为第 {0} 行：数的个数太少，或写的不是数</translation>
    </message>
    <message>
        <source>make a case of the FE result and report the run with it (--case)</source>
        <translation>请由有限元结果建立案例并与计算一同报告（--case）</translation>
    </message>
    <message>
        <source>make sure that both are in the same one, or name that of the cloud (rubble-cli cloud --crs)</source>
        <translation>请确认两者在同一坐标系中，或写明点云的坐标系（rubble-cli cloud --crs）</translation>
    </message>
    <message>
        <source>name the places of the scanners (rubble-cli cloud --scanner) if it was taken from the ground</source>
        <translation>如果是从地面扫描的，请指明扫描仪的位置（rubble-cli cloud --scanner）</translation>
    </message>
    <message>
        <source>name the places of the scanners (rubble-cli cloud --scanner), or export the scans with their poses</source>
        <translation>请指明扫描仪的位置（rubble-cli cloud --scanner），或连同位姿重新导出测站</translation>
    </message>
    <message>
        <source>name who answers for it (--by)</source>
        <translation>写明由谁负责（--by）</translation>
    </message>
    <message>
        <source>none is needed: they lie everywhere; name a smaller area to fit every part of it</source>
        <translation>无需处理：它们遍布各处；如需拟合每一部分，请指定较小的区域</translation>
    </message>
    <message>
        <source>pictures have pixels of {0} by {1}: they are not taken as photographs with a known camera</source>
        <translation>图片的像素为 {0} × {1}：不作为相机已知的照片采用</translation>
    </message>
    <message>
        <source>say what the survey shows (--survey-live)</source>
        <translation>请说明测绘显示什么（--survey-live）</translation>
    </message>
    <message>
        <source>scans state a pose at which no scanner can have stood, by how their points lie about it; it is taken as not stated</source>
        <translation>测站写明的位姿处不可能有扫描仪站立（由点在其四周的分布可知）；按未写明处理</translation>
    </message>
    <message>
        <source>state it in the words of whoever asked (--question)</source>
        <translation>用提问者的话写明（--question）</translation>
    </message>
    <message>
        <source>the survey lies {0} from the structure; debris of this site is not expected there</source>
        <translation>测量距结构 {0}；此现场的堆积物不会到达那里</translation>
    </message>
    <message>
        <source>what did not move has too many points for a fit: one to each cube of side {0} was taken</source>
        <translation>未移动部分的点太多，无法全部参加拟合：每个边长为 {0} 的立方体取一个点</translation>
    </message>
    <message>
        <source>write them out with rubble-cli cloud --photographs, bring them to square pixels and place them by pairs of points</source>
        <translation>用 rubble-cli cloud --photographs 写出，改为正方形像素，并用点对放置</translation>
    </message>
    <message>
        <source>{0}: &quot;{1}&quot; behind &quot;{2}&quot; is no unit of length that is known</source>
        <translation>{0}：“{2}”之后的“{1}”不是已知的长度单位</translation>
    </message>
    <message>
        <source>{0}: its headings name a unit of {1}, and its coordinate system has another one</source>
        <translation>{0}：其表头写明的单位为 {1}，而其坐标系采用另一单位</translation>
    </message>
    <message>
        <source>{0}: its headings name different units for x and y</source>
        <translation>{0}：其表头为 x 和 y 写明不同的单位</translation>
    </message>
    <message>
        <source>Columns or a system are stated of a terrain, and there is none</source>
        <translation>给出了地形的列或坐标系，但没有地形</translation>
    </message>
    <message>
        <source>Give the terrain as well, or leave them out.</source>
        <translation>请同时给出地形，或去掉它们。</translation>
    </message>
    <message>
        <source>Leave columns and system out, or give a cloud.</source>
        <translation>请去掉列和坐标系，或给出点云。</translation>
    </message>
    <message>
        <source>{0} is no point cloud or table of points: it has no columns, and names its system itself</source>
        <translation>{0} 不是点云或点的表格：它没有列，其坐标系由文件自身写明</translation>
    </message>
    <message>
        <source>A drawing without areas stands in every section: compare a survey, and draw a section on its map.</source>
        <translation>没有面域的图出现在每个剖面中：请先比较一个测绘，再在其差异图上绘制剖面。</translation>
    </message>
    <message>
        <source>Check their places, or give a greater range.</source>
        <translation>请检查其位置，或给出更大的量程。</translation>
    </message>
    <message>
        <source>The scanners see nothing within {0}</source>
        <translation>扫描仪在 {0} 以内什么也看不到</translation>
    </message>
    <message>
        <source>check their heights, and that they are in the system of the case</source>
        <translation>请检查其高程，以及是否属于案例的坐标系</translation>
    </message>
    <message>
        <source>heights, cloud, outline or points</source>
        <translation>heights、cloud、outline 或 points</translation>
    </message>
    <message>
        <source>measured heights, which sections are held against</source>
        <translation>测得的高程，供剖面比较</translation>
    </message>
    <message>
        <source>scanners stand below the ground</source>
        <translation>扫描仪位于地面以下</translation>
    </message>
    <message>
        <source>Container</source>
        <translation>容器</translation>
    </message>
    <message>
        <source>Custody and addenda</source>
        <translation>保管与附录</translation>
    </message>
    <message>
        <source>Entry {0} of the bundle is no addendum</source>
        <translation>封存包的条目 {0} 不是附录</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>For you to say</source>
        <translation>需由您说明</translation>
    </message>
    <message>
        <source>Get the file, and say where it is: in the window under Runs, or by rubble-cli open-sealed --input ID=FILE.</source>
        <translation>请取得该文件，并说明在何处：在窗口的“计算”页中，或用 rubble-cli open-sealed --input ID=FILE。</translation>
    </message>
    <message>
        <source>Journal of the case</source>
        <translation>案例日志</translation>
    </message>
    <message>
        <source>Leave it out here, and hold single runs against it as a survey.</source>
        <translation>在此处不采用它，改为将各次模拟与它作为测绘进行比较。</translation>
    </message>
    <message>
        <source>Looking for what the case has</source>
        <translation>正在查找案例所有的内容</translation>
    </message>
    <message>
        <source>Make it first, or seal without it.</source>
        <translation>请先生成它，或不带它封存。</translation>
    </message>
    <message>
        <source>Name an addendum by its number.</source>
        <translation>请用编号指明附录。</translation>
    </message>
    <message>
        <source>Packing: {0}</source>
        <translation>正在打包：{0}</translation>
    </message>
    <message>
        <source>Runs as sealed</source>
        <translation>封存的计算</translation>
    </message>
    <message>
        <source>Save the case under another name.</source>
        <translation>请以其他名称保存案例。</translation>
    </message>
    <message>
        <source>Statement and signature</source>
        <translation>声明与签名</translation>
    </message>
    <message>
        <source>Taking digests: {0}</source>
        <translation>正在计算摘要：{0}</translation>
    </message>
    <message>
        <source>Texts (*.txt)</source>
        <translation>文本 (*.txt)</translation>
    </message>
    <message>
        <source>The command for the time stamp gave no answer: {0}</source>
        <translation>时间戳的命令没有给出应答：{0}</translation>
    </message>
    <message>
        <source>The first difference is the {0}: recorded {1}, now {2}.</source>
        <translation>首个差异是 {0}：记录为 {1}，现在为 {2}。</translation>
    </message>
    <message>
        <source>The report lacks nothing that the program can tell</source>
        <translation>程序所能判断的内容，报告都不缺</translation>
    </message>
    <message>
        <source>The report would lack</source>
        <translation>报告将缺少</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Try it by hand, or write the request and add its answer later: rubble-cli time-stamp.</source>
        <translation>请手动尝试，或先写出请求，以后再放入应答：rubble-cli time-stamp。</translation>
    </message>
    <message>
        <source>a time stamp was asked for when it was sealed, and none is here; until its answer is put in, the time of sealing is the signer&apos;s word</source>
        <translation>封存时请求了时间戳，但这里没有；在放入应答之前，封存时间只是签名者自己所述</translation>
    </message>
    <message>
        <source>as it was sealed, but a run could not be simulated</source>
        <translation>与封存时一致，但有计算无法重新进行</translation>
    </message>
    <message>
        <source>as it was sealed, but a run does not repeat</source>
        <translation>与封存时一致，但有计算不能重复</translation>
    </message>
    <message>
        <source>as it was sealed; every run is equal</source>
        <translation>与封存时一致；所有计算都相同</translation>
    </message>
    <message>
        <source>as it was sealed; it holds no run</source>
        <translation>与封存时一致；其中没有计算</translation>
    </message>
    <message>
        <source>as it was sealed; nothing was simulated</source>
        <translation>与封存时一致；未重新计算</translation>
    </message>
    <message>
        <source>does not hold</source>
        <translation>不成立</translation>
    </message>
    <message>
        <source>entries since it was sealed: {0}, each with the digest of the one before</source>
        <translation>封存之后的条目：{0}，每条写有前一条的摘要</translation>
    </message>
    <message>
        <source>every byte of the file is as it was written</source>
        <translation>文件的每个字节都与写入时一致</translation>
    </message>
    <message>
        <source>for example</source>
        <translation>例如</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>成立</translation>
    </message>
    <message>
        <source>it was made of another FE result</source>
        <translation>它由其他有限元结果得出</translation>
    </message>
    <message>
        <source>its file is not there</source>
        <translation>其文件不在</translation>
    </message>
    <message>
        <source>not as it was sealed</source>
        <translation>与封存时不一致</translation>
    </message>
    <message>
        <source>not named by this build</source>
        <translation>此构建未写明</translation>
    </message>
    <message>
        <source>not proven</source>
        <translation>未证明</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>未记录</translation>
    </message>
    <message>
        <source>not there</source>
        <translation>没有</translation>
    </message>
    <message>
        <source>remedy</source>
        <translation>对策</translation>
    </message>
    <message>
        <source>runs in it: {0}; whether they repeat is seen by simulating them again</source>
        <translation>其中的计算：{0}；能否重复，重新计算后可知</translation>
    </message>
    <message>
        <source>sealed on {0}, as the signer says</source>
        <translation>据签名者所述，封存于 {0}</translation>
    </message>
    <message>
        <source>seen by {0} on {1}</source>
        <translation>{0} 于 {1} 看到</translation>
    </message>
    <message>
        <source>signed by the owner of the key {0}</source>
        <translation>由密钥 {0} 的持有者签名</translation>
    </message>
    <message>
        <source>signed by {0}, key {1}</source>
        <translation>由 {0} 签名，密钥 {1}</translation>
    </message>
    <message>
        <source>there is no time stamp: the time of sealing is the signer&apos;s word</source>
        <translation>没有时间戳：封存时间只是签名者自己所述</translation>
    </message>
    <message>
        <source>{0} entries tell who changed what; the signature holds the last digest</source>
        <translation>{0} 个条目说明谁改了什么；签名含最后一个摘要</translation>
    </message>
    <message>
        <source>{0} files were sealed: none may be altered, left out or put in</source>
        <translation>封存了 {0} 个文件：不得改动、去掉或放入任何一个</translation>
    </message>
    <message>
        <source>{0} is to be read only</source>
        <translation>{0} 只可读取</translation>
    </message>
    <message>
        <source>{0} is to be sealed as well, but is not there</source>
        <translation>{0} 应一同封存，但不在</translation>
    </message>
    <message>
        <source>{0} shows the collapse at {1} s: members keep their debris at rest</source>
        <translation>{0} 显示的是坍塌在 {1} s 时的情形：成员只保留静止时的堆积物</translation>
    </message>
    <message>
        <source>Find the file, and save the case with it.</source>
        <translation>找到该文件，并将其存入案例。</translation>
    </message>
    <message>
        <source>Making what is sealed with {0}</source>
        <translation>正在制作与 {0} 一并封存的内容</translation>
    </message>
    <message>
        <source>there is none yet</source>
        <translation>尚无</translation>
    </message>
    <message>
        <source>what is there was made of another run</source>
        <translation>已有的由另一次计算制作</translation>
    </message>
    <message>
        <source>{0} stands on a file that the case does not have now: SHA-256 {1}</source>
        <translation>{0} 所依据的文件，案例现在没有：SHA-256 {1}</translation>
    </message>
</context>
<context>
    <name>options</name>
    <message>
        <source>--time needs a number of seconds, not “%1”.</source>
        <translation>--time 需要以秒为单位的数值，而不是“%1”。</translation>
    </message>
    <message>
        <source>--size needs WIDTHxHEIGHT, such as 1280x800, not “%1”.</source>
        <translation>--size 需要“宽x高”，例如 1280x800，而不是“%1”。</translation>
    </message>
    <message>
        <source>--theme is light, dark or system, not “%1”.</source>
        <translation>--theme 为 light、dark 或 system，而不是“%1”。</translation>
    </message>
    <message>
        <source>--language is one of %1, not “%2”.</source>
        <translation>--language 为 %1 之一，而不是“%2”。</translation>
    </message>
    <message>
        <source>--panel is one of %1, not “%2”.</source>
        <translation>--panel 为 %1 之一，而不是“%2”。</translation>
    </message>
    <message>
        <source>Workbench for the debris of structural collapses.</source>
        <translation>结构倒塌堆积物分析工作台。</translation>
    </message>
    <message>
        <source>A case (*.rubble) or an FE result.</source>
        <translation>案例（*.rubble）或有限元结果。</translation>
    </message>
    <message>
        <source>Open the embedded sample and simulate it.</source>
        <translation>打开内置示例并进行模拟。</translation>
    </message>
    <message>
        <source>Simulate as soon as the file is open.</source>
        <translation>文件打开后立即模拟。</translation>
    </message>
    <message>
        <source>Compare settings as soon as the file is open.</source>
        <translation>文件打开后立即比较各设置。</translation>
    </message>
    <message>
        <source>Save a picture of the window and leave.</source>
        <translation>保存窗口图片后退出。</translation>
    </message>
    <message>
        <source>Show this instant, in seconds.</source>
        <translation>显示该时刻，单位秒。</translation>
    </message>
    <message>
        <source>Size of the window.</source>
        <translation>窗口大小。</translation>
    </message>
    <message>
        <source>Language: en, zh_CN or system.</source>
        <translation>语言：en、zh_CN 或 system。</translation>
    </message>
    <message>
        <source>Colours: light, dark or system.</source>
        <translation>配色：light、dark 或 system。</translation>
    </message>
    <message>
        <source>One file at a time, please.</source>
        <translation>一次只能打开一个文件。</translation>
    </message>
    <message>
        <source>Trigger these actions before the picture is taken, by their ids.</source>
        <translation>在截图前依次触发这些操作（按标识）。</translation>
    </message>
    <message>
        <source>--action knows no “%1”; the manual lists the actions in the order of the menus.</source>
        <translation>--action 没有“%1”；手册按菜单次序列出了各操作。</translation>
    </message>
    <message>
        <source>Look as a saved view does.</source>
        <translation>采用已保存视图的视角。</translation>
    </message>
    <message>
        <source>--photo is one of %1, not “%2”.</source>
        <translation>--photo 为 %1 之一，而不是“%2”。</translation>
    </message>
    <message>
        <source>How the simulation lies over the photograph: alone, swipe, blend, blink or outline.</source>
        <translation>模拟如何叠加在照片上：alone、swipe、blend、blink 或 outline。</translation>
    </message>
    <message>
        <source>Compare settings, save the chart of what accuracy costs and leave.</source>
        <translation>比较各设置，保存精度代价图后退出。</translation>
    </message>
    <message>
        <source>--new-case is one of %1, not “%2”.</source>
        <translation>--new-case 为 %1 之一，而不是“%2”。</translation>
    </message>
    <message>
        <source>Make a new case from the file, from this step on: units, ground, components, deaths or case.</source>
        <translation>由文件新建案例，从这一步开始：units、ground、components、deaths 或 case。</translation>
    </message>
    <message>
        <source>Print the page for man and leave.</source>
        <translation>输出 man 手册页后退出。</translation>
    </message>
    <message>
        <source>Print the completion for bash and leave.</source>
        <translation>输出 bash 补全脚本后退出。</translation>
    </message>
    <message>
        <source>--against needs footprint, height or surface and a file, not “%1”.</source>
        <translation>--against 需要 footprint、height 或 surface 和一个文件，而不是“%1”。</translation>
    </message>
    <message>
        <source>Open the file, measure how fast window and scrubbing are, print JSON and leave.</source>
        <translation>打开文件，测量窗口和浏览的速度，打印 JSON 并退出。</translation>
    </message>
    <message>
        <source>Show this panel: case, fragments, grid, effects, run, accuracy, evidence, report, ensemble or causes.</source>
        <translation>显示此面板：case、fragments、grid、effects、run、accuracy、evidence、report、ensemble 或 causes。</translation>
    </message>
    <message>
        <source>Another case or FE result to compare causes with; may be repeated.</source>
        <translation>用于比较原因的另一个案例或有限元结果；可重复。</translation>
    </message>
    <message>
        <source>What was found, to compare causes with: footprint, height or surface; may be repeated.</source>
        <translation>用于比较原因的现场所见：footprint、height 或 surface；可重复。</translation>
    </message>
    <message>
        <source>--measure needs a file to open.</source>
        <translation>--measure 需要一个要打开的文件。</translation>
    </message>
</context>
<context>
    <name>parameters</name>
    <message>
        <source>A cluster of stone or masonry falls apart into its fragments on a hard hit. auto: on if one can be hit that hard and the bodies so freed stay within bodies_max.</source>
        <translation>石材或砌体聚类在强烈撞击下散成各个碎块。自动：若可能发生如此强烈的撞击，且由此释放的刚体数不超过 bodies_max，则开启。</translation>
    </message>
    <message>
        <source>A level ground that carries the debris. auto: on unless terrain covers the site.</source>
        <translation>承接堆积物的水平地面。自动：除非地形覆盖整个场地，否则开启。</translation>
    </message>
    <message>
        <source>Acceleration downwards.</source>
        <translation>向下的加速度。</translation>
    </message>
    <message>
        <source>Active flag</source>
        <translation>激活标志</translation>
    </message>
    <message>
        <source>Added mass</source>
        <translation>附加质量</translation>
    </message>
    <message>
        <source>Air drag</source>
        <translation>空气阻力</translation>
    </message>
    <message>
        <source>Area of steel over the area of the face that two clusters of a reinforced component share.</source>
        <translation>钢筋面积与配筋构件的两个聚类共有面面积之比。</translation>
    </message>
    <message>
        <source>Assumed density</source>
        <translation>假定密度</translation>
    </message>
    <message>
        <source>Assumed section</source>
        <translation>假定截面</translation>
    </message>
    <message>
        <source>Assumed thickness</source>
        <translation>假定厚度</translation>
    </message>
    <message>
        <source>At sea level and 15 °C 1.225.</source>
        <translation>海平面、15 °C 时为 1.225。</translation>
    </message>
    <message>
        <source>Axis of the file that points up. frame: as the frame of the case says. auto: against the free fall that is seen in the file.</source>
        <translation>文件中指向上方的坐标轴。frame（坐标框架）：按案例的坐标框架。auto（自动）：与文件中所见的自由下落方向相反。</translation>
    </message>
    <message>
        <source>Birth shift</source>
        <translation>产生位置扰动</translation>
    </message>
    <message>
        <source>Birth time</source>
        <translation>产生时刻</translation>
    </message>
    <message>
        <source>Birth velocity</source>
        <translation>产生速度</translation>
    </message>
    <message>
        <source>Birth window</source>
        <translation>产生时间窗</translation>
    </message>
    <message>
        <source>Bodies allowed here</source>
        <translation>本机允许的刚体数</translation>
    </message>
    <message>
        <source>Bodies that have come to rest are held until something disturbs them. Off: a pile creeps and costs time for ever.</source>
        <translation>静止的刚体保持不动，直到受到扰动。关闭：堆积体会蠕动并一直耗费时间。</translation>
    </message>
    <message>
        <source>Break-up</source>
        <translation>破碎</translation>
    </message>
    <message>
        <source>Break-up speed</source>
        <translation>破碎速度</translation>
    </message>
    <message>
        <source>Bulking of a box</source>
        <translation>包围盒松散系数</translation>
    </message>
    <message>
        <source>Buoyancy, drag and added mass are proportional to it.</source>
        <translation>浮力、阻力和附加质量与之成正比。</translation>
    </message>
    <message>
        <source>Buoyancy, drag, current and added mass below the level of the water. auto: on if a level is given and a body can reach it.</source>
        <translation>水面以下的浮力、阻力、水流和附加质量。自动：若给定水位且有刚体能到达水中，则开启。</translation>
    </message>
    <message>
        <source>Cell size of the grid boxes. Smaller: closer to the structure, slower.</source>
        <translation>网格盒的单元格尺寸。越小越贴近结构，也越慢。</translation>
    </message>
    <message>
        <source>Cluster shape</source>
        <translation>聚类形状</translation>
    </message>
    <message>
        <source>Clusters across components</source>
        <translation>跨构件聚类</translation>
    </message>
    <message>
        <source>Coefficient of drag of a box in air, with its projected area: 1.05 for a cube.</source>
        <translation>盒体在空气中按投影面积计的阻力系数：立方体为 1.05。</translation>
    </message>
    <message>
        <source>Coefficient of drag of a box in water, with its projected area.</source>
        <translation>盒体在水中按投影面积计的阻力系数。</translation>
    </message>
    <message>
        <source>Contact of fragments</source>
        <translation>碎块间接触</translation>
    </message>
    <message>
        <source>Contact with the structure</source>
        <translation>与结构的接触</translation>
    </message>
    <message>
        <source>Coulomb coefficient of every contact. Automatic: by pair of materials.</source>
        <translation>所有接触的库仑摩擦系数。自动：按材料对取值。</translation>
    </message>
    <message>
        <source>Coulomb coefficient of two materials, such as pair[stone,soil].friction. Automatic: the sourced table in the manual.</source>
        <translation>两种材料之间的库仑摩擦系数，例如 pair[stone,soil].friction。自动：取手册中注明来源的表。</translation>
    </message>
    <message>
        <source>Cross-section of beams where neither the file nor a component setting gives one.</source>
        <translation>文件和构件设置均未给出时梁的横截面面积。</translation>
    </message>
    <message>
        <source>Current along x</source>
        <translation>沿 x 的水流</translation>
    </message>
    <message>
        <source>Current along y</source>
        <translation>沿 y 的水流</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>Density of one component; takes the place of what the file says.</source>
        <translation>单个构件的密度；取代文件中的值。</translation>
    </message>
    <message>
        <source>Density of the air</source>
        <translation>空气密度</translation>
    </message>
    <message>
        <source>Density of the water</source>
        <translation>水的密度</translation>
    </message>
    <message>
        <source>Density where neither the file nor a component setting gives one; each use is counted as a finding.</source>
        <translation>文件和构件设置均未给出时的密度；每次采用都计为一条发现。</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>位移</translation>
    </message>
    <message>
        <source>Drag in air</source>
        <translation>空气中的阻力</translation>
    </message>
    <message>
        <source>Drag in water</source>
        <translation>水中的阻力</translation>
    </message>
    <message>
        <source>Drag proportional to speed, on the mass of the displaced water: brings floating bodies to rest.</source>
        <translation>与速度成正比的阻力，按排开水的质量计：使漂浮的刚体静止下来。</translation>
    </message>
    <message>
        <source>Elongation at break</source>
        <translation>断裂伸长率</translation>
    </message>
    <message>
        <source>Every fragment moves alone: the reference run. Slow.</source>
        <translation>每个碎块单独运动：即基准计算。很慢。</translation>
    </message>
    <message>
        <source>Fallen live structure</source>
        <translation>坠落的未失效结构</translation>
    </message>
    <message>
        <source>Fragments hit each other. auto: on unless no two can meet. Most of the cost of a pile.</source>
        <translation>碎块之间相互碰撞。自动：除非任何两块都不可能相遇，否则开启。堆积体的大部分耗时在此。</translation>
    </message>
    <message>
        <source>Fragments hit the structure that still stands or falls. auto: on if any of it lies within the reach of a fragment while it is active. Costs the most where the structure is large.</source>
        <translation>碎块撞击仍然站立或正在下落的结构。自动：若激活的结构处于碎块可达范围内，则开启。结构较大时耗时最多。</translation>
    </message>
    <message>
        <source>Fragments that depart from their cluster&apos;s rigid motion by more than this are split off. 0: no split.</source>
        <translation>偏离聚类刚体运动超过此值的碎块被分离出来。0：不分离。</translation>
    </message>
    <message>
        <source>Frames per second of wall clock that live mode should reach.</source>
        <translation>实时模式应达到的每秒帧数（按实际时间）。</translation>
    </message>
    <message>
        <source>Frames recorded per second of collapse; FE states are always recorded.</source>
        <translation>每秒倒塌时间记录的帧数；有限元状态总会被记录。</translation>
    </message>
    <message>
        <source>Freeze after</source>
        <translation>冻结延迟</translation>
    </message>
    <message>
        <source>Freeze below</source>
        <translation>冻结速度</translation>
    </message>
    <message>
        <source>Freeze bodies at rest</source>
        <translation>冻结静止刚体</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>摩擦</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>重力</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Ground is made of</source>
        <translation>地面材料</translation>
    </message>
    <message>
        <source>Grouping</source>
        <translation>分组方式</translation>
    </message>
    <message>
        <source>Halves the steps for 0.5 s whenever energy is gained or bodies lie inside each other beyond the limits of the health monitor. Costs time only then; the run says when it did.</source>
        <translation>当能量增加或刚体相互侵入超过健康监测限值时，步长减半 0.5 s。仅在此时耗时；计算会说明何时采用。</translation>
    </message>
    <message>
        <source>Height of the ground</source>
        <translation>地面高度</translation>
    </message>
    <message>
        <source>How long it must stay so.</source>
        <translation>须保持多久。</translation>
    </message>
    <message>
        <source>How long the run goes on at most after the last FE state, until 99 % of the bodies sleep.</source>
        <translation>最后一个有限元状态之后计算最多继续多久，直到 99 % 的刚体休眠。</translation>
    </message>
    <message>
        <source>How the active structure collides. component_box: one box for each component, as published. grid_boxes: boxes of its active elements on a grid. surface: every active element at the surface.</source>
        <translation>激活结构如何参与碰撞。component_box（构件包围盒）：每个构件一个盒，论文所用。grid_boxes（网格盒）：网格上激活单元的盒。surface（表面）：表面上的每个激活单元。</translation>
    </message>
    <message>
        <source>Impulse over mass of a hit above which a cluster of stone or masonry falls apart. An assumption.</source>
        <translation>撞击的冲量与质量之比超过此值时，石材或砌体聚类散开。属于假定。</translation>
    </message>
    <message>
        <source>Iterations of Bullet&apos;s contact solver in each step. Costs time; a smaller step buys more.</source>
        <translation>Bullet 接触求解器每步的迭代次数。耗费时间；减小步长更有效。</translation>
    </message>
    <message>
        <source>Largest volume of a cluster&apos;s box over that of its fragments. A box around scattered fragments holds mostly what is not its own; it is drawn in towards its centre of mass to this. At 1 the voids between boxes swell the pile as rubble does, by 1.3 to 1.8. 1000: never drawn in, as published.</source>
        <translation>聚类盒体积与其碎块体积之比的上限。散布碎块的包围盒大部分不属于碎块自身；盒体向质心收缩至此值。取 1 时，盒间空隙使堆积体像碎石一样膨胀 1.3 至 1.8 倍。1000：从不收缩，如论文。</translation>
    </message>
    <message>
        <source>Lets one cluster hold fragments of several components, as the published method does when its grid is too large.</source>
        <translation>允许一个聚类包含多个构件的碎块，论文方法在网格过大时即如此。</translation>
    </message>
    <message>
        <source>Level of the water</source>
        <translation>水位</translation>
    </message>
    <message>
        <source>Limits the grid</source>
        <translation>限制网格</translation>
    </message>
    <message>
        <source>Linear drag in water</source>
        <translation>水中的线性阻力</translation>
    </message>
    <message>
        <source>Live frame rate</source>
        <translation>实时帧率</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Material of ground and terrain: decides friction and restitution of hits on it.</source>
        <translation>地面和地形的材料：决定撞击时的摩擦和恢复系数。</translation>
    </message>
    <message>
        <source>Most rigid bodies that this machine carries at the live frame rate. More bodies: finer debris, slower run.</source>
        <translation>本机在实时帧率下最多能承载的刚体数。刚体越多：堆积物越精细，计算越慢。</translation>
    </message>
    <message>
        <source>Moves every birth place at random by this much: shows how far a result repeats.</source>
        <translation>将每个产生位置随机移动此距离：显示结果的可重复程度。</translation>
    </message>
    <message>
        <source>Moving structure</source>
        <translation>运动结构</translation>
    </message>
    <message>
        <source>Multiple of mean distance</source>
        <translation>平均间距的倍数</translation>
    </message>
    <message>
        <source>Name of the element variable that tells active from deactivated. Empty: recognised by name.</source>
        <translation>区分激活与失效的单元变量名。留空：按名称识别。</translation>
    </message>
    <message>
        <source>Normal restitution of every hit. Automatic: by pair of materials.</source>
        <translation>每次撞击的法向恢复系数。自动：按材料对取值。</translation>
    </message>
    <message>
        <source>Normal restitution of two materials. Automatic: the sourced table in the manual.</source>
        <translation>两种材料之间的法向恢复系数。自动：取手册中注明来源的表。</translation>
    </message>
    <message>
        <source>One body per fragment</source>
        <translation>每个碎块一个刚体</translation>
    </message>
    <message>
        <source>Overlap resolved at</source>
        <translation>重叠消除速度</translation>
    </message>
    <message>
        <source>Parts (blocks, materials) whose elements are dead while they belong to them, by name or number, with semicolons between. Empty: recognised by name where elements move into them.</source>
        <translation>单元属于其中时即为失效的部件（块、材料），按名称或编号，以分号分隔。留空：单元移入时按名称识别。</translation>
    </message>
    <message>
        <source>Parts alive at the end of the FE result without a path to a support, which the engine does not carry yet (loose_structure). released: they go on as rigid bodies. held: they stay where they are.</source>
        <translation>有限元结果结束时仍存活、没有路径通向支座且尚未由引擎带动（loose_structure）的部分。released（释放）：作为刚体继续运动。held（固定）：停在原处。</translation>
    </message>
    <message>
        <source>Parts in which the soft-step solver takes a step, contacts found once for all. It takes more by itself where thin bodies would sink into each other under their load. Automatic: 4, or 12 where the engine moves loose structure and 8 once the FE result has ended and what still falls then has landed.</source>
        <translation>软步法求解器将一步分成的份数，接触只查找一次。当薄刚体会在荷载下相互陷入时，它会自动取更多份。自动：4，由引擎移动松脱结构时为 12，有限元结果结束且其时仍在下落者落定后为 8。</translation>
    </message>
    <message>
        <source>Parts of the dead</source>
        <translation>失效单元的部件</translation>
    </message>
    <message>
        <source>Prefix of the nodal displacement variables. Empty: recognised by name. none: the nodes do not move.</source>
        <translation>节点位移变量的前缀。留空：按名称识别。none（无）：节点不移动。</translation>
    </message>
    <message>
        <source>Recorded frames</source>
        <translation>记录帧率</translation>
    </message>
    <message>
        <source>Reinforced</source>
        <translation>配筋</translation>
    </message>
    <message>
        <source>Reinforcement ties</source>
        <translation>钢筋拉结</translation>
    </message>
    <message>
        <source>Resistance of the air. auto: on if weight is less than 17 times the drag at the highest possible speed of some body, which is 1 % of its travel.</source>
        <translation>空气的阻力。自动：若某刚体的重量小于其最大可能速度下阻力的 17 倍（相当于行程的 1 %），则开启。</translation>
    </message>
    <message>
        <source>Restitution</source>
        <translation>恢复系数</translation>
    </message>
    <message>
        <source>Revived elements</source>
        <translation>复活的单元</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>Seed of the birth shift.</source>
        <translation>产生位置扰动的随机种子。</translation>
    </message>
    <message>
        <source>Settle time</source>
        <translation>稳定时间</translation>
    </message>
    <message>
        <source>Share of its length by which a tie stretches before it breaks.</source>
        <translation>拉结断裂前伸长量与其长度之比。</translation>
    </message>
    <message>
        <source>Share of the displaced water that has to be accelerated with a body: 0.5 for a sphere, about 0.7 for a cube.</source>
        <translation>随刚体一起加速的排开水所占比例：球体为 0.5，立方体约为 0.7。</translation>
    </message>
    <message>
        <source>Size along x</source>
        <translation>沿 x 的尺寸</translation>
    </message>
    <message>
        <source>Size along y</source>
        <translation>沿 y 的尺寸</translation>
    </message>
    <message>
        <source>Size along z</source>
        <translation>沿 z 的尺寸</translation>
    </message>
    <message>
        <source>Size of grid boxes</source>
        <translation>网格盒尺寸</translation>
    </message>
    <message>
        <source>Size of the Basic Grid along x. Automatic: from the multiple.</source>
        <translation>基本网格沿 x 的尺寸。自动：由倍数确定。</translation>
    </message>
    <message>
        <source>Size of the Basic Grid along y. Automatic: from the multiple.</source>
        <translation>基本网格沿 y 的尺寸。自动：由倍数确定。</translation>
    </message>
    <message>
        <source>Size of the Basic Grid along z. Automatic: from the multiple.</source>
        <translation>基本网格沿 z 的尺寸。自动：由倍数确定。</translation>
    </message>
    <message>
        <source>Size of the Basic Grid as a multiple of the mean distance of adjacent fragments. Automatic: the smallest that keeps to the bodies allowed.</source>
        <translation>基本网格尺寸，为相邻碎块平均间距的倍数。自动：不超过允许刚体数的最小值。</translation>
    </message>
    <message>
        <source>Smaller steps when unhealthy</source>
        <translation>异常时减小步长</translation>
    </message>
    <message>
        <source>Smallest half extent</source>
        <translation>最小半尺寸</translation>
    </message>
    <message>
        <source>Smallest half extent of a fragment as a share of its longest; thinner solids are thickened and counted.</source>
        <translation>碎块最小半尺寸与最长半尺寸之比的下限；更薄的实体被加厚并计数。</translation>
    </message>
    <message>
        <source>Smallest half extent of a fragment; thinner solids are thickened and counted.</source>
        <translation>碎块的最小半尺寸；更薄的实体被加厚并计数。</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>求解器</translation>
    </message>
    <message>
        <source>Solver iterations</source>
        <translation>求解器迭代次数</translation>
    </message>
    <message>
        <source>Speed at which overlap that exists at birth is resolved, by position only.</source>
        <translation>产生时已有的重叠被消除的速度，仅修正位置。</translation>
    </message>
    <message>
        <source>Speed of a body&apos;s fastest corner below which it counts as at rest.</source>
        <translation>刚体最快角点的速度低于此值时视为静止。</translation>
    </message>
    <message>
        <source>Steel between neighbouring clusters of reinforced components, until it breaks. auto: on if such a component has two or more clusters.</source>
        <translation>配筋构件相邻聚类之间的钢筋，直至断裂。自动：若此类构件有两个或更多聚类，则开启。</translation>
    </message>
    <message>
        <source>Steel ratio</source>
        <translation>配筋率</translation>
    </message>
    <message>
        <source>Steel runs through the component: neighbouring clusters of it are tied (effect ties).</source>
        <translation>构件内贯穿钢筋：其相邻聚类被拉结（钢筋拉结效应）。</translation>
    </message>
    <message>
        <source>Steps per second</source>
        <translation>每秒步数</translation>
    </message>
    <message>
        <source>Strength of the steel</source>
        <translation>钢筋强度</translation>
    </message>
    <message>
        <source>Stress at which a tie yields; its force never passes stress times area.</source>
        <translation>拉结屈服的应力；其力不超过应力乘以面积。</translation>
    </message>
    <message>
        <source>Substeps</source>
        <translation>子步数</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>地形</translation>
    </message>
    <message>
        <source>The terrain of the case carries the debris. auto: on if the case has one and debris can reach it.</source>
        <translation>由案例的地形承接堆积物。自动：若案例有地形且堆积物能到达，则开启。</translation>
    </message>
    <message>
        <source>Thickness of one component&apos;s shells, cross-section of its beams; takes the place of what the file says.</source>
        <translation>单个构件的壳厚度或梁横截面面积；取代文件中的值。</translation>
    </message>
    <message>
        <source>Thickness of shells where neither the file nor a component setting gives one.</source>
        <translation>文件和构件设置均未给出时壳的厚度。</translation>
    </message>
    <message>
        <source>Thickness or section</source>
        <translation>厚度或截面</translation>
    </message>
    <message>
        <source>Thinnest fragment</source>
        <translation>最薄碎块</translation>
    </message>
    <message>
        <source>Units of the file</source>
        <translation>文件单位</translation>
    </message>
    <message>
        <source>Up axis of the file</source>
        <translation>文件的竖直轴</translation>
    </message>
    <message>
        <source>Value of active</source>
        <translation>激活值</translation>
    </message>
    <message>
        <source>Value of the active flag on active elements. Automatic: by the flag&apos;s convention, else what most elements have at the first state.</source>
        <translation>激活单元的激活标志取值。自动：按该标志的惯例，否则取初始状态下多数单元的值。</translation>
    </message>
    <message>
        <source>Velocity of the water.</source>
        <translation>水的流速。</translation>
    </message>
    <message>
        <source>Velocity tolerance</source>
        <translation>速度容差</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>水</translation>
    </message>
    <message>
        <source>What dies within this time becomes debris together, at the first state of it, so that one cluster can hold what the states part: fewer and fuller bodies, which leave the FE result a little earlier. 0: each state by itself. The reference does not read it, nor does birth_time = exact.</source>
        <translation>在此时间内失效者在其首个状态一起成为堆积物，使一个聚类可以容纳被状态分开的碎块：刚体更少、更饱满，但稍早脱离有限元结果。0：每个状态各自独立。基准计算和 birth_time = exact 均不读取此值。</translation>
    </message>
    <message>
        <source>What one component is made of: decides friction and restitution, and whether clusters break up. Automatic: from its density: from 7,000 to 9,000 kg/m3 steel, from 2,550 to 3,500 stone, from 1,400 to 2,100 masonry, anything else concrete.</source>
        <translation>单个构件的材料：决定摩擦和恢复系数，以及聚类是否破碎。自动：由密度判断：7,000 至 9,000 kg/m3 为钢，2,550 至 3,500 为石材，1,400 至 2,100 为砌体，其余为混凝土。</translation>
    </message>
    <message>
        <source>What the file counts mass, length and time in. frame: as the frame of the case says. auto: what densities, size and free fall in the file fit, if only one system does; inspect says which and why.</source>
        <translation>文件中质量、长度和时间的单位。frame（坐标框架）：按案例的坐标框架。auto（自动）：与文件中的密度、尺寸和自由下落相符的单位制，且仅有一个相符时采用；inspect 会说明结果与原因。</translation>
    </message>
    <message>
        <source>Whether the component&apos;s smallest dimension bounds the Basic Grid.</source>
        <translation>构件的最小尺寸是否限制基本网格。</translation>
    </message>
    <message>
        <source>fe: fragments keep the velocity their element had. rest: they are born at rest, as in the published method.</source>
        <translation>fe（有限元速度）：碎块保持其单元的速度。rest（静止）：如论文方法，产生时静止。</translation>
    </message>
    <message>
        <source>latch: dead is dead. follow: the fragment ends when its element returns. refuse: such a file is an error.</source>
        <translation>latch（锁定）：失效即永久失效。follow（跟随）：单元复活时碎块结束。refuse（拒绝）：此类文件视为错误。</translation>
    </message>
    <message>
        <source>nested: the fragments of a component that are born together are cut in two, again and again, until each cluster is as compact as a full box of the Basic Grid in the proportions of its own fragments. axes: those with the same groups along x, y and z, as published.</source>
        <translation>nested（嵌套）：同一构件中同时产生的碎块不断一分为二，直到每个聚类与一个按其自身碎块比例、装满的基本网格盒同样紧凑。axes（按轴）：沿 x、y、z 分组相同的碎块归为一类，如论文。</translation>
    </message>
    <message>
        <source>soft-step: soft contacts in small substeps; piles keep their volume, several times faster in large ones. bullet: sequential impulses as Bullet has them; large piles squeeze into themselves.</source>
        <translation>soft-step（软步法）：小子步中的软接触；堆积体保持体积，规模大时快数倍。bullet：Bullet 自带的序列冲量法；大型堆积体会自身压缩。</translation>
    </message>
    <message>
        <source>state: a fragment is born at the first state that reports its element inactive. exact: at the death time in the file.</source>
        <translation>state（状态）：碎块在首个报告其单元失效的状态产生。exact（精确）：在文件给出的失效时刻产生。</translation>
    </message>
    <message>
        <source>z of the level ground.</source>
        <translation>水平地面的 z 坐标。</translation>
    </message>
    <message>
        <source>z of the still surface. Automatic: there is no water.</source>
        <translation>静水面的 z 坐标。自动：没有水。</translation>
    </message>
    <message>
        <source>Overlap resolved for</source>
        <translation>重叠消除时长</translation>
    </message>
    <message>
        <source>Awake after birth</source>
        <translation>产生后活动时间</translation>
    </message>
    <message>
        <source>How long a body is taken to move: bodies at rest cost next to nothing, so those born this long ago leave their place among the bodies allowed. Shorter: more and smaller clusters where a collapse lasts long.</source>
        <translation>刚体被视为在运动的时间：静止的刚体几乎不耗时，因此产生已超过此时间的刚体让出其在允许刚体数中的名额。越短：倒塌历时长时聚类越多、越小。</translation>
    </message>
    <message>
        <source>Only this file</source>
        <translation>仅此文件</translation>
    </message>
    <message>
        <source>Open the file by itself: others whose names differ only in a number are not taken for its states, as with variants of a design.</source>
        <translation>单独打开该文件：名称只差编号的其他文件不当作它的状态，例如同一设计的变体。</translation>
    </message>
    <message>
        <source>Collision shape of a cluster. axis_box: as published. oriented_box: same cost, less empty space. hull: closer, slower. compound: a box for every fragment, slowest. bricks: boxes of the volume of the fragments, joined where they leave next to no space between them, or up to 0.4 of the grid&apos;s cell half of it at most. auto: bricks where the engine moves loose structure, oriented_box where the FE result does (loose_structure).</source>
        <translation>聚类的碰撞形状。axis_box：同发表文献。oriented_box：耗时相同，空隙更小。hull：更贴合，更慢。compound：每个碎块一个盒子，最慢。bricks：体积等于碎块体积的盒子，彼此几乎无间隙时合并，长度不超过网格单元的 0.4 时间隙至多占一半也合并。auto：松脱结构由引擎移动时为 bricks，由有限元结果移动时为 oriented_box（loose_structure）。</translation>
    </message>
    <message>
        <source>Loose structure</source>
        <translation>松脱的结构</translation>
    </message>
    <message>
        <source>Who moves live structure without a path to a support. at_once: the engine, from when it comes loose; what the FE result kills is born where the engine has it. fe: the FE result, until its elements die or it ends; quicker, but debris is born inside debris.</source>
        <translation>没有路径通向支座的未失效结构由谁移动。at_once：引擎，从其松脱起；有限元结果令其失效的单元在引擎所在之处产生。fe：有限元结果，直到其单元失效或结果结束；更快，但碎块产生于已有堆积物之中。</translation>
    </message>
    <message>
        <source>Another seed gives other bumps and hollows of the same height and spacing. Repeats count on from it.</source>
        <translation>另一个种子给出高度和间距相同的另一组凸起和凹陷。各次重复由它起依次递增。</translation>
    </message>
    <message>
        <source>Distance of neighbouring bumps and hollows, beyond which they are independent of each other.</source>
        <translation>相邻凸起和凹陷的距离，超过它即相互独立。</translation>
    </message>
    <message>
        <source>Friction of bounces</source>
        <translation>弹跳的摩擦</translation>
    </message>
    <message>
        <source>Mean height of obstacles that the raster of the terrain is too coarse to hold: stones, tufts, ruts; what Rockyfor3D calls the mean obstacle height (Dorren 2016). Bumps and hollows are drawn at random on a lattice. 0: as smooth as the raster.</source>
        <translation>地形栅格过粗而容纳不下的障碍物的平均高度：石块、草丛、沟槽；即 Rockyfor3D 所称的平均障碍物高度（Dorren 2016）。凸起和凹陷在格点上随机抽取。0：与栅格一样光滑。</translation>
    </message>
    <message>
        <source>Roughness of the terrain</source>
        <translation>地形粗糙度</translation>
    </message>
    <message>
        <source>Seed of the roughness</source>
        <translation>粗糙度种子</translation>
    </message>
    <message>
        <source>Spacing of the roughness</source>
        <translation>粗糙度间距</translation>
    </message>
    <message>
        <source>The impulse of a bounce rubs by Coulomb&apos;s law as the impact does, soft-step solver only. Off: blocks that fly or roll keep too much speed along the ground, a tenth at restitution 0.1. On by itself for a table of bodies, off for FE results, whose trajectories were made without.</source>
        <translation>弹跳的冲量与撞击一样按库仑定律产生摩擦，仅用于 soft-step 求解器。关闭：飞行或滚动的块体沿地面保留过多的速度，恢复系数为 0.1 时约十分之一。物体表自动打开；有限元结果关闭，其轨迹是在没有它时得到的。</translation>
    </message>
    <message>
        <source>Level of friction</source>
        <translation>摩擦所处位置</translation>
    </message>
    <message>
        <source>Level of restitution</source>
        <translation>恢复系数所处位置</translation>
    </message>
    <message>
        <source>Where the friction of each pair of materials lies in the range of its source: 0 the least, 1 the greatest, for all pairs alike. A pair that was set stays. Automatic: the number of the table.</source>
        <translation>各材料对的摩擦在其来源范围内的位置：0 为最小，1 为最大，所有材料对相同。已设定的材料对不变。自动：表中的数。</translation>
    </message>
    <message>
        <source>Where the restitution of each pair of materials lies in the range of its source: 0 the least, 1 the greatest, for all pairs alike. A pair that was set stays. Automatic: the number of the table.</source>
        <translation>各材料对的恢复系数在其来源范围内的位置：0 为最小，1 为最大，所有材料对相同。已设定的材料对不变。自动：表中的数。</translation>
    </message>
    <message>
        <source>Lower bound; steps are equal within an FE interval and meet every state. More steps: deeper piles hold, slower run. Automatic: 40 for bodies of up to 0.3 m, up to 60 for more than 10,000 of them, fewer with the square root of their size down to 20, or 40 where the engine moves loose structure, until the FE result has ended and what still falls then has landed; bodies of a table 40 to 480, so that one that falls over its edge turns by 1.5 degrees in a step; always 60 for bullet.</source>
        <translation>下限；步长在每个有限元区间内相等并对准每个状态。步数越多：较深的堆积体更稳定，计算更慢。自动：0.3 m 以内的刚体为 40，多于 10,000 个时最高 60，更大时随尺寸平方根减小，最低 20，由引擎移动松脱结构时在有限元结果结束且其时仍在下落者落定之前最低 40；物体表为 40 至 480，使绕棱翻倒的刚体每步转动 1.5 度；bullet 始终为 60。</translation>
    </message>
    <message>
        <source>m or m2</source>
        <translation>m 或 m2</translation>
    </message>
    <message>
        <source>How long two bodies are brought apart where one was born in the other, or was pressed into it by such; what is left then stays, so that the pile can come to rest. Longer: looser piles that rest later. The time counts from the later birth of the two where the engine moves loose structure (loose_structure), else for each contact. Automatic: 1 s there, else 7 s.</source>
        <translation>两个刚体因产生时重叠或因此被压入彼此时，在多长时间内把它们分开；剩余的重叠保留，使堆积能够静止。时间越长：堆积越松散，静止越晚。松脱结构由引擎运动时（loose_structure），时间从两者中较晚产生者起算，否则按每个接触计。自动：前者 1 s，后者 7 s。</translation>
    </message>
</context>
<context>
    <name>photographs</name>
    <message>
        <source>photograph %1 added</source>
        <translation>照片 %1 已添加</translation>
    </message>
    <message>
        <source>%1 photographs added</source>
        <translation>已添加 %1 张照片</translation>
    </message>
    <message>
        <source>photograph removed</source>
        <translation>照片已移除</translation>
    </message>
</context>
<context>
    <name>prediction</name>
    <message>
        <source>Wall time</source>
        <translation>实际耗时</translation>
    </message>
    <message>
        <source>Of the simulation, from start to end</source>
        <translation>模拟从开始到结束</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步</translation>
    </message>
    <message>
        <source>Mean from the first to the last birth</source>
        <translation>从首次到末次产生的平均值</translation>
    </message>
    <message>
        <source>Live rate</source>
        <translation>实时帧率</translation>
    </message>
    <message>
        <source>Frames per second of live mode, mean from the first to the last birth</source>
        <translation>实时模式的每秒帧数，从首次到末次产生的平均值</translation>
    </message>
    <message>
        <source>Mass map difference</source>
        <translation>质量图差异</translation>
    </message>
    <message>
        <source>Share of the mass that lies in other cells of 2 m than in the reference: 0 is the same</source>
        <translation>与基准相比，落在不同 2 m 单元格中的质量所占比例：0 表示完全相同</translation>
    </message>
    <message>
        <source>Core overlap</source>
        <translation>核心区重合度</translation>
    </message>
    <message>
        <source>Of the cells that hold 95 % of the mass, with the reference: 1 is the same</source>
        <translation>含 95 % 质量的单元格与基准的重合度：1 表示完全相同</translation>
    </message>
    <message>
        <source>Footprint overlap</source>
        <translation>覆盖范围重合度</translation>
    </message>
    <message>
        <source>Of the cells that debris covers, with the reference: 1 is the same</source>
        <translation>堆积物覆盖的单元格与基准的重合度：1 表示完全相同</translation>
    </message>
    <message>
        <source>Height map error</source>
        <translation>高度图误差</translation>
    </message>
    <message>
        <source>Root of the mean square difference of the heights of the pile</source>
        <translation>堆积高度之差的均方根</translation>
    </message>
    <message>
        <source>Mean height error</source>
        <translation>平均高度误差</translation>
    </message>
    <message>
        <source>Difference of the mean height of the mass above ground</source>
        <translation>质量距地面平均高度之差</translation>
    </message>
</context>
<context>
    <name>rubble</name>
    <message>
        <source>auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source> · about %1 left</source>
        <translation> · 约剩 %1</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <comment>two parts of a line</comment>
        <translation>%1；%2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1，另有 %2 个</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>names of a list</comment>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>%1 under “%2”</source>
        <comment>fields, and the panel or menu that they stand under</comment>
        <translation>“%2”下的%1</translation>
    </message>
</context>
<context>
    <name>rubble::AccuracyDisplay</name>
    <message>
        <source>Preparing</source>
        <translation>准备中</translation>
    </message>
    <message>
        <source>Settings compared</source>
        <translation>设置比较完成</translation>
    </message>
    <message>
        <source>The comparison is not complete; what is done is kept, and comparing again goes on</source>
        <translation>比较尚未完成；已完成的部分保留，再次比较会继续进行</translation>
    </message>
    <message>
        <source>These points belong to other settings of the case: compare again before one is used.</source>
        <translation>这些点属于本案例的其他设置：使用前请重新比较。</translation>
    </message>
    <message>
        <source>setting %1</source>
        <translation>设置 %1</translation>
    </message>
    <message>
        <source>Open a result first.</source>
        <translation>请先打开结果。</translation>
    </message>
    <message>
        <source>No element dies in this result, so there is nothing to compare.</source>
        <translation>此结果中没有单元失效，因此没有可比较的内容。</translation>
    </message>
    <message>
        <source>A run is being simulated: comparing beside it would spoil the times. Wait for it or cancel it.</source>
        <translation>正在模拟：同时比较会影响计时。请等待其完成或取消。</translation>
    </message>
    <message>
        <source>Simulate waits until the comparison is through, so that its times hold. Settings can be edited meanwhile.</source>
        <translation>比较完成之前不能模拟，以保证计时有效。其间可以编辑设置。</translation>
    </message>
    <message>
        <source>Settings of this case were compared on the cluster: here they are</source>
        <translation>本案例的设置曾在集群上比较：结果在此</translation>
    </message>
    <message>
        <source>The cluster simulates. Times are not measured there: compare on this machine for them, no world is simulated again.</source>
        <translation>集群正在模拟。那里不测量时间：需要时在本机比较，不会重新模拟任何世界。</translation>
    </message>
</context>
<context>
    <name>rubble::ActionStates</name>
    <message>
        <source>Undo %1</source>
        <translation>撤销 %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>重做 %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
</context>
<context>
    <name>rubble::Autosave</name>
    <message>
        <source>Changes cannot be autosaved in %1</source>
        <translation>无法在 %1 自动保存更改</translation>
    </message>
    <message>
        <source>Make room there or allow writing, or save the case yourself.</source>
        <translation>请在该处腾出空间或允许写入，或自行保存案例。</translation>
    </message>
    <message>
        <source>Changes cannot be autosaved. %1</source>
        <translation>无法自动保存更改。%1</translation>
    </message>
</context>
<context>
    <name>rubble::BundleOpening</name>
    <message>
        <source>Open a sealed bundle</source>
        <translation>打开封存包</translation>
    </message>
    <message>
        <source>Sealed bundles (*.rubblecase);;All files (*)</source>
        <translation>封存包 (*.rubblecase);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Waiting for other work</source>
        <translation>等待其他工作</translation>
    </message>
    <message>
        <source>Cancelled; nothing half-made is left</source>
        <translation>已取消；没有留下未完成的内容</translation>
    </message>
    <message>
        <source>Empty folder to unpack into</source>
        <translation>解包到的空文件夹</translation>
    </message>
    <message>
        <source>The entry is added. Note its SHA-256: %1</source>
        <translation>条目已加入。请记下其 SHA-256：%1</translation>
    </message>
    <message>
        <source>The addendum is signed and added. Note its SHA-256: %1</source>
        <translation>附录已签名并加入。请记下其 SHA-256：%1</translation>
    </message>
    <message>
        <source>The request lies in %1.</source>
        <translation>请求位于 %1。</translation>
    </message>
    <message>
        <source>The answer is of this bundle, and lies in it now.</source>
        <translation>应答属于此封存包，现已放入其中。</translation>
    </message>
    <message>
        <source>Save the list</source>
        <translation>保存列表</translation>
    </message>
    <message>
        <source>Texts (*.txt)</source>
        <translation>文本 (*.txt)</translation>
    </message>
    <message>
        <source>The list lies in %1.</source>
        <translation>列表位于 %1。</translation>
    </message>
</context>
<context>
    <name>rubble::CalibrationDisplay</name>
    <message>
        <source>This machine</source>
        <translation>本机</translation>
    </message>
    <message>
        <source>This machine is calibrated</source>
        <translation>本机标定完成</translation>
    </message>
    <message>
        <source>The calibration was cancelled</source>
        <translation>标定已取消</translation>
    </message>
</context>
<context>
    <name>rubble::CameraKeys</name>
    <message>
        <source>camera key removed</source>
        <translation>相机关键帧已删除</translation>
    </message>
    <message>
        <source>camera key at %1</source>
        <translation>%1 处的相机关键帧</translation>
    </message>
</context>
<context>
    <name>rubble::CameraOverlay</name>
    <message>
        <source>simulation, %1</source>
        <translation>模拟，%1</translation>
    </message>
</context>
<context>
    <name>rubble::CaseSealing</name>
    <message>
        <source>Sealed bundle</source>
        <translation>封存包</translation>
    </message>
    <message>
        <source>Seal the case</source>
        <translation>封存案例</translation>
    </message>
    <message>
        <source>Sealed bundles (*.rubblecase)</source>
        <translation>封存包 (*.rubblecase)</translation>
    </message>
    <message>
        <source>Cancelled; nothing half-made is left</source>
        <translation>已取消；没有留下半成品</translation>
    </message>
    <message>
        <source>Sealed %1; runs in it: %2</source>
        <translation>已封存 %1；其中的计算：%2</translation>
    </message>
    <message>
        <source>%1 in %2 files, signed with the key %3.</source>
        <translation>%1，共 %2 个文件，用密钥 %3 签名。</translation>
    </message>
    <message>
        <source>Note the SHA-256 of the statement, and give it to whoever receives the bundle another way: %1</source>
        <translation>请记下声明的 SHA-256，并经其他途径告知封存包的接收者：%1</translation>
    </message>
    <message>
        <source>There is no time stamp: the time of sealing is your word.</source>
        <translation>没有时间戳：封存时间只是您自己所述。</translation>
    </message>
    <message>
        <source>The request for a time stamp lies in %1. Send it to a time-stamping service, and put its answer in with Open sealed…, Time stamp.</source>
        <translation>时间戳的请求位于 %1。请将其发给时间戳服务机构，并在“打开封存包…”的“时间戳”中放入应答。</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1；%2</translation>
    </message>
    <message>
        <source>The case is sealed: %1</source>
        <translation>案例已封存：%1</translation>
    </message>
    <message>
        <source>Made for it, and in it: %1</source>
        <translation>为此制作并已封入：%1</translation>
    </message>
</context>
<context>
    <name>rubble::CauseChoice</name>
    <message>
        <source>It was not taken at rest: members keep their debris at rest.</source>
        <translation>它不是静止后拍摄的：成员只保留静止后的堆积物。</translation>
    </message>
    <message>
        <source>No outline of the debris is drawn on it.</source>
        <translation>其上没有绘制堆积物的轮廓。</translation>
    </message>
    <message>
        <source>Its camera is not matched.</source>
        <translation>它的相机尚未匹配。</translation>
    </message>
    <message>
        <source>footprint</source>
        <translation>覆盖范围</translation>
    </message>
    <message>
        <source>heights</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>%1 at %2, %3</source>
        <translation>%1，位于 %2, %3</translation>
    </message>
    <message>
        <source>Debris came within %1 of this place so long after the first debris that came down anywhere, give or take %2</source>
        <translation>碎块在任一处首次落下之后经过这段时间，有碎块到达距此处 %1 以内，误差 %2</translation>
    </message>
    <message>
        <source>There is no file %1 any more.</source>
        <translation>文件 %1 已不在。</translation>
    </message>
    <message>
        <source>Put it back, or take it off the list.</source>
        <translation>把它放回，或从列表中移除。</translation>
    </message>
    <message>
        <source>A scenario of this case</source>
        <translation>本案例的一个方案</translation>
    </message>
    <message>
        <source>It was taken before the collapse and shows no debris.</source>
        <translation>它在倒塌之前取得，其中没有堆积物。</translation>
    </message>
    <message>
        <source>It is listed below as well, as what it was added as: that counts.</source>
        <translation>它也作为加入的文件列在下面：以那一项计入。</translation>
    </message>
    <message>
        <source>A photograph of this case, taken at rest</source>
        <translation>本案例的一张照片，静止后拍摄</translation>
    </message>
    <message>
        <source>A survey of this case: noise, areas and registration count as the case says</source>
        <translation>本案例的一份测量：噪声、区域和配准按案例所述计入</translation>
    </message>
</context>
<context>
    <name>rubble::CausesDisplay</name>
    <message>
        <source>Cases of the same site</source>
        <translation>同一现场的案例</translation>
    </message>
    <message>
        <source>Cases and FE results (*);;Cases (*.rubble)</source>
        <translation>案例和有限元结果 (*);;案例 (*.rubble)</translation>
    </message>
    <message>
        <source>Footprint of the debris</source>
        <translation>堆积物的覆盖范围</translation>
    </message>
    <message>
        <source>Heights that were surveyed</source>
        <translation>测绘的高度</translation>
    </message>
    <message>
        <source>Polygons (*.gpkg *.geojson *.json *.shp);;All files (*)</source>
        <translation>多边形 (*.gpkg *.geojson *.json *.shp);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Rasters (*.tif *.tiff *.asc *.vrt);;All files (*)</source>
        <translation>栅格 (*.tif *.tiff *.asc *.vrt);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Open a result first.</source>
        <translation>请先打开结果。</translation>
    </message>
    <message>
        <source>Tick two causes at least: scenarios of this case, or other cases of the site.</source>
        <translation>请至少勾选两个原因：本案例的方案，或同一现场的其他案例。</translation>
    </message>
    <message>
        <source>A run is being simulated: wait for it or cancel it.</source>
        <translation>正在模拟一次计算：请等待或取消。</translation>
    </message>
    <message>
        <source>An ensemble is being simulated: wait for it or cancel it.</source>
        <translation>正在模拟系综：请等待或取消。</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>准备中</translation>
    </message>
    <message>
        <source>Causes compared</source>
        <translation>原因已比较</translation>
    </message>
    <message>
        <source>Each gets %1 members with what is varied under Ensemble.</source>
        <translation>每个原因得到 %1 个成员，变动内容见“系综”。</translation>
    </message>
    <message>
        <source>Ranking of the causes</source>
        <translation>原因的排序</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Map of what tells causes apart</source>
        <translation>区分原因的图</translation>
    </message>
    <message>
        <source>GeoTIFF (*.tif);;Tables (*.csv);;Images (*.png)</source>
        <translation>GeoTIFF (*.tif);;表格 (*.csv);;图像 (*.png)</translation>
    </message>
</context>
<context>
    <name>rubble::CloudPlacing</name>
    <message>
        <source>A cloud is fitted to the site: open the FE result first.</source>
        <translation>点云要拟合到现场：请先打开有限元结果。</translation>
    </message>
    <message>
        <source>It is fitted to what stands and lies where the run ends.</source>
        <translation>拟合到计算结束时站立和堆积之物。</translation>
    </message>
    <message>
        <source>There is no run: it is fitted to the terrain alone.</source>
        <translation>没有计算：只拟合到地形。</translation>
    </message>
    <message>
        <source>What did not move</source>
        <translation>未移动的部分</translation>
    </message>
</context>
<context>
    <name>rubble::CloudPoints</name>
    <message>
        <source>%1 photographs of the cloud added</source>
        <translation>已添加点云的 %1 张照片</translation>
    </message>
    <message>
        <source>Photographs added with the camera that the cloud states: %1</source>
        <translation>按点云所述相机添加的照片：%1</translation>
    </message>
    <message>
        <source>%1 points lie far from the others and are not drawn.</source>
        <translation>%1 个点远离其余的点，未画出。</translation>
    </message>
    <message>
        <source>Adding its photographs, %1 %</source>
        <translation>正在添加其中的照片，%1 %</translation>
    </message>
    <message>
        <source>The case changed meanwhile: add the photographs once more.</source>
        <translation>案例在此期间已改变：请重新添加照片。</translation>
    </message>
    <message>
        <source>The octree is made or opened, %1 %</source>
        <translation>正在生成或打开八叉树，%1 %</translation>
    </message>
    <message>
        <source>%1 of %2 points are drawn.</source>
        <translation>画出 %2 个点中的 %1 个。</translation>
    </message>
    <message>
        <source>Finer ones were left out: no more than %1 are.</source>
        <translation>略去了更细的点：最多画 %1 个。</translation>
    </message>
    <message>
        <source>The octree was made: %1, %2 MB.</source>
        <translation>已生成八叉树：%1，%2 MB。</translation>
    </message>
    <message>
        <source>The octree: %1, %2 MB.</source>
        <translation>八叉树：%1，%2 MB。</translation>
    </message>
    <message>
        <source>Distances are being measured.</source>
        <translation>正在量取距离。</translation>
    </message>
    <message>
        <source>%1 of %2 distances differ by more than the level of detection.</source>
        <translation>%2 个距离中有 %1 个超过检测限。</translation>
    </message>
    <message>
        <source>Fragments that no point looks at: %1 of %2.</source>
        <translation>没有点看到的碎块：%2 个中的 %1 个。</translation>
    </message>
    <message>
        <source>They are of another run or other settings.</source>
        <translation>它们属于另一次计算或其他设置。</translation>
    </message>
    <message>
        <source>Places of which the distance was measured are drawn.</source>
        <translation>画出量得距离之处。</translation>
    </message>
    <message>
        <source>No distances to this run were measured: colours say the height.</source>
        <translation>尚未量取到此次计算的距离：颜色表示高度。</translation>
    </message>
    <message>
        <source>where the scanners stood</source>
        <translation>扫描仪的位置</translation>
    </message>
    <message>
        <source>Fill is where the run lies above the cloud.</source>
        <translation>填方指计算位于点云之上的部分。</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>距离</translation>
    </message>
</context>
<context>
    <name>rubble::CloudReading</name>
    <message>
        <source>No heading names the columns of this table. Left empty, the first three are taken as x, y and z where all rows hold numbers.</source>
        <translation>此表没有表头写明各列。留空时，若各行都是数字，则前三列视为 x、y 和 z。</translation>
    </message>
    <message>
        <source>The file names no coordinate system. Left empty, its coordinates are taken to be those of the case.</source>
        <translation>文件未写明坐标系。留空时，其坐标按案例的坐标系处理。</translation>
    </message>
</context>
<context>
    <name>rubble::CloudTools</name>
    <message>
        <source>%1: %2 points; debris %3, fallen structure %4, standing structure %5, ground %6. Fragments seen: %7 of %8.</source>
        <translation>%1：%2 点；堆积物 %3，坠落结构 %4，站立结构 %5，地面 %6。所见碎块：%7，共 %8。</translation>
    </message>
    <message>
        <source>Places of the scanners</source>
        <translation>扫描仪的位置</translation>
    </message>
    <message>
        <source>Points are saved as LAS, PLY or CSV: end the name with .las, .ply or .csv.</source>
        <translation>点可保存为 LAS、PLY 或 CSV：文件名须以 .las、.ply 或 .csv 结尾。</translation>
    </message>
    <message>
        <source>Scan of the run</source>
        <translation>计算的扫描</translation>
    </message>
    <message>
        <source>Point cloud</source>
        <translation>点云</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>距离</translation>
    </message>
</context>
<context>
    <name>rubble::Computation</name>
    <message>
        <source>Opening</source>
        <translation>正在打开</translation>
    </message>
</context>
<context>
    <name>rubble::DistanceWords</name>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>%1 m³ (± %2 random, ± %3 systematic)</source>
        <translation>%1 m³（随机 ± %2，系统 ± %3）</translation>
    </message>
    <message>
        <source>The level of detection is not known.</source>
        <translation>检测限未知。</translation>
    </message>
    <message>
        <source>Level of detection %1 m in the middle (95 %).</source>
        <translation>检测限的中位数为 %1 m（95 %）。</translation>
    </message>
    <message>
        <source>Level of detection %1 m in the middle (95 %), of roughness alone: nobody stated the registration error.</source>
        <translation>检测限的中位数为 %1 m（95 %），仅由粗糙度得出：无人给出配准误差。</translation>
    </message>
    <message>
        <source>Volumes are not known: no cell was measured.</source>
        <translation>体积未知：没有量到任何单元。</translation>
    </message>
    <message>
        <source>Fill %1, cut %2, net %3, at 95 %.</source>
        <translation>填方 %1，挖方 %2，净值 %3，均为 95 %。</translation>
    </message>
    <message>
        <source>Below the level of detection also lie fill %1, cut %2 m³, which are not counted.</source>
        <translation>另有低于检测限而未计入的填方 %1、挖方 %2 m³。</translation>
    </message>
    <message>
        <source>Cells measured: %1 of %2.</source>
        <translation>量到的单元：%1，共 %2。</translation>
    </message>
    <message>
        <source>Seen straight from above: where the scanners stood is not known.</source>
        <translation>从正上方看：扫描仪的位置未知。</translation>
    </message>
    <message>
        <source>Seen from the scanners that were given: %1.</source>
        <translation>从给定的扫描仪看：%1 台。</translation>
    </message>
    <message>
        <source>Seen from the scanners that the cloud names: %1.</source>
        <translation>从点云写明的扫描仪看：%1 台。</translation>
    </message>
    <message>
        <source>%1 of %2 distances differ by more than the level of detection.</source>
        <translation>%2 个距离中有 %1 个的差别超过检测限。</translation>
    </message>
    <message>
        <source>Fill is where the second cloud lies above the first.</source>
        <translation>填方指第二个点云位于第一个之上的部分。</translation>
    </message>
</context>
<context>
    <name>rubble::Document</name>
    <message>
        <source>preset %1</source>
        <translation>预设 %1</translation>
    </message>
    <message>
        <source>%1, copy</source>
        <translation>%1，副本</translation>
    </message>
    <message>
        <source>%1, copy %2</source>
        <translation>%1，副本 %2</translation>
    </message>
    <message>
        <source>scenario “%1”</source>
        <translation>方案“%1”</translation>
    </message>
    <message>
        <source>scenario “%1” renamed to “%2”</source>
        <translation>方案“%1”重命名为“%2”</translation>
    </message>
    <message>
        <source>note on “%1”</source>
        <translation>“%1”的备注</translation>
    </message>
    <message>
        <source>scenario “%1” deleted</source>
        <translation>方案“%1”已删除</translation>
    </message>
    <message>
        <source>to scenario “%1”</source>
        <translation>转到方案“%1”</translation>
    </message>
</context>
<context>
    <name>rubble::EnsembleDisplay</name>
    <message>
        <source>Preparing</source>
        <translation>准备中</translation>
    </message>
    <message>
        <source>Ensemble simulated</source>
        <translation>系综已模拟</translation>
    </message>
    <message>
        <source>The ensemble is not complete; what is done is kept, and simulating again goes on</source>
        <translation>系综未完成；已完成的予以保留，再次模拟时继续</translation>
    </message>
    <message>
        <source>Open a result first.</source>
        <translation>请先打开结果。</translation>
    </message>
    <message>
        <source>No element dies in this result, so there is nothing to simulate.</source>
        <translation>此结果中没有单元失效，因此没有可模拟的内容。</translation>
    </message>
    <message>
        <source>A run is being simulated: wait for it or cancel it.</source>
        <translation>正在模拟一次计算：请等待或取消。</translation>
    </message>
    <message>
        <source>Causes are being compared: wait for that or cancel it.</source>
        <translation>正在比较原因：请等待或取消。</translation>
    </message>
    <message>
        <source>Map of the ensemble</source>
        <translation>系综的图</translation>
    </message>
    <message>
        <source>GeoTIFF (*.tif);;Tables (*.csv);;Images (*.png)</source>
        <translation>GeoTIFF (*.tif);;表格 (*.csv);;图像 (*.png)</translation>
    </message>
    <message>
        <source>Members of the ensemble</source>
        <translation>系综的成员</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
</context>
<context>
    <name>rubble::ErrorDisplay</name>
    <message>
        <source>The reference is kept (%1 MB).</source>
        <translation>基准已保留（%1 MB）。</translation>
    </message>
    <message>
        <source>It can be computed when the run is through.</source>
        <translation>计算完成后可以计算基准。</translation>
    </message>
</context>
<context>
    <name>rubble::EvidenceDisplay</name>
    <message>
        <source>point %1 moved</source>
        <translation>点 %1 已移动</translation>
    </message>
    <message>
        <source>%1 drawn</source>
        <translation>已画出%1</translation>
    </message>
    <message>
        <source>There is nothing of the model there: click on the structure, a fragment or the ground.</source>
        <translation>该处没有模型：请单击结构、碎块或地面。</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>%1, node</source>
        <translation>%1，节点</translation>
    </message>
    <message>
        <source>Add photographs</source>
        <translation>添加照片</translation>
    </message>
    <message>
        <source>Photographs (*.jpg *.jpeg *.png *.tif *.tiff *.heic *.heif *.JPG *.JPEG *.PNG *.TIF *.TIFF *.HEIC *.HEIF);;All files (*)</source>
        <translation>照片 (*.jpg *.jpeg *.png *.tif *.tiff *.heic *.heif *.JPG *.JPEG *.PNG *.TIF *.TIFF *.HEIC *.HEIF);;所有文件 (*)</translation>
    </message>
    <message>
        <source>%1: among the photographs already</source>
        <translation>%1：已在照片之中</translation>
    </message>
    <message>
        <source>Point pairs</source>
        <translation>点对</translation>
    </message>
    <message>
        <source>Tables of point pairs (*.csv);;All files (*)</source>
        <translation>点对表 (*.csv);;所有文件 (*)</translation>
    </message>
    <message>
        <source>%1 points from %2</source>
        <translation>来自 %2 的 %1 个点</translation>
    </message>
    <message>
        <source>point %1 added</source>
        <translation>点 %1 已添加</translation>
    </message>
    <message>
        <source>Now click the same point in the model, at the right; nodes are caught. Esc ends.</source>
        <translation>现在单击右侧模型中的同一点；会捕捉节点。Esc 结束。</translation>
    </message>
    <message>
        <source>Now click the same point in the photograph.</source>
        <translation>现在单击照片中的同一点。</translation>
    </message>
    <message>
        <source>Click a point in the photograph, then the same point in the model; or the other way round.</source>
        <translation>单击照片中的一点，然后单击模型中的同一点；或相反。</translation>
    </message>
    <message>
        <source>Click the corners around it; a double click or Enter closes, Backspace takes one back, Esc ends.</source>
        <translation>沿其周围单击角点；双击或回车闭合，退格键撤回一个，Esc 结束。</translation>
    </message>
    <message>
        <source>The view looks as the camera does; its distortion and principal point are left out here.</source>
        <translation>视图采用相机的视角；此处不计其畸变和主点。</translation>
    </message>
    <message>
        <source>The camera is to be found first.</source>
        <translation>须先求得相机。</translation>
    </message>
    <message>
        <source>Draw the outline of the debris on the photograph first.</source>
        <translation>请先在照片上画出堆积物的轮廓。</translation>
    </message>
    <message>
        <source>reading the file</source>
        <translation>正在读取文件</translation>
    </message>
    <message>
        <source>unchanged since it was added</source>
        <translation>添加后未变</translation>
    </message>
    <message>
        <source>the file cannot be shown</source>
        <translation>无法显示该文件</translation>
    </message>
    <message>
        <source>changed since it was added</source>
        <translation>添加后已更改</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message>
        <source>Click points that the photograph and the model both show; once the camera is found, the simulation is seen from there.</source>
        <translation>单击照片和模型都能看到的点；求得相机后即可从该处看模拟。</translation>
    </message>
</context>
<context>
    <name>rubble::EvidenceWork</name>
    <message>
        <source>Simulate first: there is no debris yet.</source>
        <translation>请先模拟：还没有堆积物。</translation>
    </message>
</context>
<context>
    <name>rubble::FigureReturn</name>
    <message>
        <source>Shown as in %1</source>
        <translation>显示方式同 %1</translation>
    </message>
    <message>
        <source>The view of %1; its run is not kept here, so simulate to see its fragments</source>
        <translation>%1 的视图；其计算未保存在此处，请模拟后查看碎块</translation>
    </message>
</context>
<context>
    <name>rubble::FileCommands</name>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>地形</translation>
    </message>
    <message>
        <source>terrain %1</source>
        <translation>地形 %1</translation>
    </message>
    <message>
        <source>terrain left out</source>
        <translation>不用地形</translation>
    </message>
    <message>
        <source>Save the case?</source>
        <translation>保存案例？</translation>
    </message>
    <message>
        <source>The settings of this case have changed since it was saved.</source>
        <translation>自上次保存以来，此案例的设置已更改。</translation>
    </message>
    <message>
        <source>Save case</source>
        <translation>保存案例</translation>
    </message>
    <message>
        <source>Cases (*.rubble)</source>
        <translation>案例 (*.rubble)</translation>
    </message>
    <message>
        <source>Save run</source>
        <translation>保存计算</translation>
    </message>
    <message>
        <source>Runs (*.run.h5)</source>
        <translation>计算 (*.run.h5)</translation>
    </message>
    <message>
        <source>Table of fragments</source>
        <translation>碎块表</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Series for ParaView</source>
        <translation>ParaView 序列</translation>
    </message>
    <message>
        <source>Series (*.pvd)</source>
        <translation>序列 (*.pvd)</translation>
    </message>
    <message>
        <source>Settings compared</source>
        <translation>设置比较完成</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>图表</translation>
    </message>
    <message>
        <source>Drawings (*.svg);;Images (*.png)</source>
        <translation>矢量图 (*.svg);;图片 (*.png)</translation>
    </message>
    <message>
        <source>Table of selected fragments</source>
        <translation>所选碎块表</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Views (*.json)</source>
        <translation>视图 (*.json)</translation>
    </message>
    <message>
        <source>Open a view</source>
        <translation>打开视图</translation>
    </message>
    <message>
        <source>Views (*.json);;All files (*)</source>
        <translation>视图 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Fragments as glTF</source>
        <translation>glTF 格式的碎块</translation>
    </message>
    <message>
        <source>Binary glTF (*.glb)</source>
        <translation>二进制 glTF (*.glb)</translation>
    </message>
    <message>
        <source>Orthophoto</source>
        <translation>正射影像</translation>
    </message>
    <message>
        <source>Pictures of the ground (*.tif *.tiff *.jp2 *.jpg *.jpeg *.png *.img);;All files (*)</source>
        <translation>地面影像 (*.tif *.tiff *.jp2 *.jpg *.jpeg *.png *.img);;所有文件 (*)</translation>
    </message>
    <message>
        <source>orthophoto %1</source>
        <translation>正射影像 %1</translation>
    </message>
    <message>
        <source>Surroundings</source>
        <translation>周围环境</translation>
    </message>
    <message>
        <source>surroundings %1</source>
        <translation>周围环境 %1</translation>
    </message>
    <message>
        <source>orthophoto and surroundings left out</source>
        <translation>已撤除正射影像和周围环境</translation>
    </message>
    <message>
        <source>site</source>
        <translation>场地</translation>
    </message>
    <message>
        <source>Series in one file</source>
        <translation>单文件序列</translation>
    </message>
    <message>
        <source>VTKHDF (*.vtkhdf)</source>
        <translation>VTKHDF (*.vtkhdf)</translation>
    </message>
    <message>
        <source>Save the run?</source>
        <translation>保存计算？</translation>
    </message>
    <message>
        <source>The run of this case is kept nowhere and goes with it.</source>
        <translation>此案例的计算没有保留在任何地方，将随案例一起消失。</translation>
    </message>
    <message>
        <source>History curves</source>
        <translation>时程曲线</translation>
    </message>
    <message>
        <source>Meshes and point clouds (*.obj *.ply *.stl *.gltf *.glb *.las *.laz *.e57 *.pcd *.ptx *.pts);;All files (*)</source>
        <translation>网格和点云 (*.obj *.ply *.stl *.gltf *.glb *.las *.laz *.e57 *.pcd *.ptx *.pts);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Cases, FE results, runs and figures of them (*);;Cases (*.rubble);;Runs (*.run.h5)</source>
        <translation>案例、有限元结果、计算及其图片 (*);;案例 (*.rubble);;计算 (*.run.h5)</translation>
    </message>
</context>
<context>
    <name>rubble::FileKinds</name>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Point clouds and tables</source>
        <translation>点云和表格</translation>
    </message>
    <message>
        <source>Rasters of heights</source>
        <translation>高程栅格</translation>
    </message>
    <message>
        <source>Surveys</source>
        <translation>测绘</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Terrains</source>
        <translation>地形</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Polygons</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>Point clouds (*.las *.ply);;Tables (*.csv)</source>
        <translation>点云 (*.las *.ply);;表格 (*.csv)</translation>
    </message>
</context>
<context>
    <name>rubble::Help</name>
    <message>
        <source>What is this number?</source>
        <translation>这个数值是什么？</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
</context>
<context>
    <name>rubble::HistoryDisplay</name>
    <message>
        <source>Simulate first: there are no curves without a run.</source>
        <translation>请先模拟：没有计算就没有曲线。</translation>
    </message>
    <message>
        <source>Nothing of what is selected becomes a fragment: it stays active to the end.</source>
        <translation>选中的内容都不会成为碎块：它们直到结束都保持激活。</translation>
    </message>
    <message>
        <source>Fragment %1</source>
        <translation>碎块 %1</translation>
    </message>
    <message>
        <source>All %1 fragments</source>
        <translation>全部 %1 个碎块</translation>
    </message>
    <message>
        <source>Cluster %1: %2 fragments</source>
        <translation>聚类 %1：%2 个碎块</translation>
    </message>
    <message>
        <source>%1 selected fragments of %2</source>
        <translation>选中的 %1 个碎块，属于 %2</translation>
    </message>
    <message>
        <source>%1 selected fragments</source>
        <translation>选中的 %1 个碎块</translation>
    </message>
</context>
<context>
    <name>rubble::InputsDisplay</name>
    <message>
        <source>The FE result</source>
        <translation>有限元结果</translation>
    </message>
    <message>
        <source>The terrain</source>
        <translation>地形</translation>
    </message>
    <message>
        <source>The photograph</source>
        <translation>照片</translation>
    </message>
    <message>
        <source>The survey</source>
        <translation>测绘</translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>定位…</translation>
    </message>
    <message>
        <source>Choose where this file lies now</source>
        <translation>选择此文件现在的位置</translation>
    </message>
    <message>
        <source>%1 is another file than the case was made with.</source>
        <translation>%1 与建立案例时的文件不同。</translation>
    </message>
    <message>
        <source>SHA-256 %1 instead of %2: results may differ from before.</source>
        <translation>SHA-256 为 %1，而不是 %2：结果可能与以前不同。</translation>
    </message>
    <message>
        <source>Use it all the same</source>
        <translation>仍然使用</translation>
    </message>
    <message>
        <source>Take this file for the one that the case names; can be undone</source>
        <translation>以此文件作为案例所指的文件；可撤销</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>保持不变</translation>
    </message>
    <message>
        <source>Keep the case as it is</source>
        <translation>案例保持原样</translation>
    </message>
    <message>
        <source>%1 %2 is missing.</source>
        <translation>%1 %2 缺失。</translation>
    </message>
    <message>
        <source>It should lie in %1.</source>
        <translation>它应位于 %1。</translation>
    </message>
    <message>
        <source>%1 %2 has changed since the case was saved.</source>
        <translation>%1 %2 在案例保存后已更改。</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>接受</translation>
    </message>
    <message>
        <source>Take the file as it is now; the case records it, and it can be undone</source>
        <translation>采用文件现在的内容；案例会记录，且可撤销</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>定位 %1</translation>
    </message>
    <message>
        <source>%1 used instead</source>
        <translation>改用 %1</translation>
    </message>
    <message>
        <source>%1 located</source>
        <translation>已定位 %1</translation>
    </message>
    <message>
        <source>%1 was found; the case names its place</source>
        <translation>已找到 %1；案例已记下其位置</translation>
    </message>
    <message>
        <source>changed %1 accepted</source>
        <translation>接受已更改的 %1</translation>
    </message>
    <message>
        <source>The orthophoto</source>
        <translation>正射影像</translation>
    </message>
    <message>
        <source>The mesh of surroundings</source>
        <translation>周边网格</translation>
    </message>
</context>
<context>
    <name>rubble::Inspection</name>
    <message>
        <source>Components</source>
        <translation>构件列表</translation>
    </message>
    <message>
        <source>Select by</source>
        <translation>选择条件</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>检查器</translation>
    </message>
    <message>
        <source>Shaded edges are off: a picture took %1 s with them</source>
        <translation>边缘阴影已关闭：带它的一幅画面用了 %1 s</translation>
    </message>
    <message>
        <source>Fragment table</source>
        <translation>碎块表</translation>
    </message>
    <message>
        <source>History curves</source>
        <translation>时程曲线</translation>
    </message>
</context>
<context>
    <name>rubble::KeptRunsDisplay</name>
    <message>
        <source>being written</source>
        <translation>正在写入</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>%1 cannot be removed: it is in use, or its folder cannot be changed</source>
        <translation>无法移除 %1：正在使用，或其文件夹不可更改</translation>
    </message>
</context>
<context>
    <name>rubble::MainWindow</name>
    <message>
        <source>changed</source>
        <translation>已更改</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>未保存</translation>
    </message>
    <message>
        <source>saved %1</source>
        <translation>%1 已保存</translation>
    </message>
    <message>
        <source>scenario</source>
        <translation>方案</translation>
    </message>
    <message>
        <source>About Rubble</source>
        <translation>关于 Rubble</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Rubble %1&lt;/h3&gt;&lt;p&gt;Turns the elements that a collapse analysis deactivates into rigid fragments and shows where they go.&lt;/p&gt;&lt;p&gt;Method: Xu, Lu, Guan, Ren: Physics engine-driven visualization of deactivated elements and its application in bridge collapse simulation. Automation in Construction 35 (2013) 471-481.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Rubble %1&lt;/h3&gt;&lt;p&gt;将倒塌分析中失效的单元转化为刚性碎块，并显示其去向。&lt;/p&gt;&lt;p&gt;方法来源：Xu, Lu, Guan, Ren: Physics engine-driven visualization of deactivated elements and its application in bridge collapse simulation. Automation in Construction 35 (2013) 471-481.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source> Colour by </source>
        <translation> 着色依据 </translation>
    </message>
    <message>
        <source>highlight</source>
        <translation>突出碎块</translation>
    </message>
    <message>
        <source>component</source>
        <translation>构件</translation>
    </message>
    <message>
        <source>birth time</source>
        <translation>按产生时刻</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>cluster</source>
        <translation>聚类</translation>
    </message>
    <message>
        <source>error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>What the colour of a fragment says; island: which loose part of the structure an element belongs to</source>
        <translation>碎块颜色的含义；孤立部分：单元属于结构的哪个松脱部分</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>着色依据</translation>
    </message>
    <message>
        <source>Preferences that could not be read are as delivered: %1</source>
        <translation>无法读取的首选项采用默认值：%1</translation>
    </message>
    <message>
        <source>The panel of a stage</source>
        <translation>各阶段的面板</translation>
    </message>
    <message>
        <source>The views</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>The timeline</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>The order of work</source>
        <translation>工作的次序</translation>
    </message>
    <message>
        <source>What this is for</source>
        <translation>用途</translation>
    </message>
    <message>
        <source>Elements that fail vanish from the conventional view; the other one shows how they fall, hit and come to rest as fragments.</source>
        <translation>失效单元在常规视图中消失；另一视图显示它们作为碎块如何下落、碰撞并静止。</translation>
    </message>
    <message>
        <source>Simulate (Ctrl+R) computes where the fragments go, and the views play what is computed meanwhile.</source>
        <translation>“模拟”（Ctrl+R）计算碎块的去向，其间视图播放已计算的部分。</translation>
    </message>
    <message>
        <source>Drag to go to any instant of the collapse; Space plays and pauses.</source>
        <translation>拖动可到达倒塌的任意时刻；空格播放和暂停。</translation>
    </message>
    <message>
        <source>The left button turns the model, the wheel nears it, and a click on a fragment tells what became of it.</source>
        <translation>左键转动模型，滚轮拉近，单击碎块可知其经过。</translation>
    </message>
    <message>
        <source>The rail leads from the file to the report, top to bottom, and marks what is up to date, stale or running.</source>
        <translation>导轨自上而下从文件引向报告，并标出最新、过期和正在运行的各项。</translation>
    </message>
    <message>
        <source>Each panel answers one question with few settings, and Ctrl+Z takes back every change.</source>
        <translation>每个面板以少量设置回答一个问题，任何更改都可用 Ctrl+Z 撤销。</translation>
    </message>
    <message>
        <source>On from here</source>
        <translation>接下来</translation>
    </message>
    <message>
        <source>Case has New case… for a result of your own, and Help has the manual (F1) and this tour again.</source>
        <translation>“案例”菜单的“新建案例…”用于自己的结果，“帮助”菜单有手册（F1）和本导览。</translation>
    </message>
    <message>
        <source>island</source>
        <translation>孤立部分</translation>
    </message>
    <message>
        <source>read only</source>
        <translation>只读</translation>
    </message>
</context>
<context>
    <name>rubble::ManualWindow</name>
    <message>
        <source>Rubble manual</source>
        <translation>Rubble 手册</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>搜索手册</translation>
    </message>
    <message>
        <source>Words to find; where all of them stand together is listed below</source>
        <translation>要查找的词语；全部词语同时出现之处列于下方</translation>
    </message>
    <message>
        <source>Places found</source>
        <translation>找到的位置</translation>
    </message>
    <message>
        <source>Nothing found. Try fewer words, or the name of a parameter.</source>
        <translation>未找到。请减少词语，或使用参数名称。</translation>
    </message>
    <message>
        <source>%1 places and more</source>
        <translation>%1 处以上</translation>
    </message>
    <message>
        <source>Places: %1</source>
        <translation>%1 处</translation>
    </message>
    <message>
        <source>This page is in English.</source>
        <translation>此页为英文。</translation>
    </message>
</context>
<context>
    <name>rubble::MapDisplay</name>
    <message>
        <source>Debris map</source>
        <translation>堆积物图</translation>
    </message>
    <message>
        <source>The debris is being mapped: save the map once it stands here.</source>
        <translation>正在绘制堆积物图：显示后再保存。</translation>
    </message>
    <message>
        <source>Simulate first: there is no debris yet.</source>
        <translation>请先模拟：还没有堆积物。</translation>
    </message>
    <message>
        <source>GeoTIFF (*.tif);;GeoPackage (*.gpkg);;Tables (*.csv);;Images (*.png)</source>
        <translation>GeoTIFF (*.tif);;GeoPackage (*.gpkg);;表格 (*.csv);;图像 (*.png)</translation>
    </message>
    <message>
        <source>The debris map is there: save it now.</source>
        <translation>堆积物图已完成：现在可以保存。</translation>
    </message>
</context>
<context>
    <name>rubble::NewCase</name>
    <message>
        <source>regrouping dropped</source>
        <translation>撤除重新分组</translation>
    </message>
    <message>
        <source>%1 is a case already.</source>
        <translation>%1 已经是案例。</translation>
    </message>
    <message>
        <source>Open it with Open…, or choose an FE result.</source>
        <translation>请用“打开…”打开它，或选择有限元结果。</translation>
    </message>
    <message>
        <source>As computed</source>
        <translation>按计算值</translation>
    </message>
    <message>
        <source>own</source>
        <translation>自定义</translation>
    </message>
    <message>
        <source>level, z = %1</source>
        <translation>水平，z = %1</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>地形</translation>
    </message>
    <message>
        <source>terrain left out</source>
        <translation>不用地形</translation>
    </message>
    <message>
        <source>terrain %1</source>
        <translation>地形 %1</translation>
    </message>
</context>
<context>
    <name>rubble::Opening</name>
    <message>
        <source>The sample is not installed.</source>
        <translation>示例未安装。</translation>
    </message>
    <message>
        <source>Install Rubble&apos;s samples folder, or open a result of your own.</source>
        <translation>请安装 Rubble 的示例文件夹，或打开您自己的结果。</translation>
    </message>
    <message>
        <source>Nothing new: the result has %1 states</source>
        <translation>没有新内容：结果有 %1 个状态</translation>
    </message>
    <message>
        <source>The result was read again: %1 states</source>
        <translation>已重新读取结果：%1 个状态</translation>
    </message>
    <message>
        <source>FE result of the new case</source>
        <translation>新建案例的有限元结果</translation>
    </message>
    <message>
        <source>FE results (*)</source>
        <translation>有限元结果 (*)</translation>
    </message>
    <message>
        <source>%1 states more, to %2; %3 elements more are dead</source>
        <translation>增加 %1 个状态，至 %2；另有 %3 个单元失效</translation>
    </message>
</context>
<context>
    <name>rubble::PanelDeck</name>
    <message>
        <source>Case</source>
        <translation>案例</translation>
    </message>
    <message>
        <source>What was computed, and of what the structure is made.</source>
        <translation>计算了什么，结构由什么组成。</translation>
    </message>
    <message>
        <source>Fragments</source>
        <translation>碎块</translation>
    </message>
    <message>
        <source>What became debris, when, and with which mass.</source>
        <translation>什么成为堆积物，何时，质量多少。</translation>
    </message>
    <message>
        <source>Basic Grid</source>
        <translation>基本网格</translation>
    </message>
    <message>
        <source>Which fragments move together, and what that costs.</source>
        <translation>哪些碎块一起运动，代价如何。</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>效应</translation>
    </message>
    <message>
        <source>What acts on the fragments, why, and what it costs.</source>
        <translation>什么作用于碎块，原因和代价。</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>计算</translation>
    </message>
    <message>
        <source>Where the fragments go.</source>
        <translation>碎块去向何处。</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>精度</translation>
    </message>
    <message>
        <source>regrouping dropped</source>
        <translation>撤除重新分组</translation>
    </message>
    <message>
        <source>Open a result first.</source>
        <translation>请先打开结果。</translation>
    </message>
    <message>
        <source>No element dies in this result, so there is nothing to simulate.</source>
        <translation>此结果中没有单元失效，因此没有可模拟的内容。</translation>
    </message>
    <message>
        <source>The sizes are counted anew when the simulation is through.</source>
        <translation>模拟完成后将重新统计尺寸。</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>证据</translation>
    </message>
    <message>
        <source>What photographs show, and how far the simulated debris agrees.</source>
        <translation>照片显示了什么，模拟堆积物与之符合到何种程度。</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>What was asked, what was found, and how sure that is.</source>
        <translation>问了什么，发现了什么，有多大把握。</translation>
    </message>
    <message>
        <source>Photographs</source>
        <translation>照片</translation>
    </message>
    <message>
        <source>Ensemble</source>
        <translation>系综</translation>
    </message>
    <message>
        <source>How sure it is where debris lies, with what is not known drawn anew.</source>
        <translation>在未知量重新抽取时，堆积物的位置有多确定。</translation>
    </message>
    <message>
        <source>Causes</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Which of several supposed causes explains what was found.</source>
        <translation>若干假定原因中哪一个能解释现场所见。</translation>
    </message>
    <message>
        <source>Agreement with the reference (verification, no validation), what it costs in time, and which differences mean something.</source>
        <translation>与基准的一致性（核实，不是验证）、它以多少时间为代价，以及哪些差别有意义。</translation>
    </message>
    <message>
        <source>The case has other settings than this run: it is shown as it was. Simulate to bring it up to date, or take its settings.</source>
        <translation>案例的设置与本次计算不同：本次计算按原样显示。请重新模拟，或采用其设置。</translation>
    </message>
    <message>
        <source>What this run stands on has changed: it is shown as it was. Simulate to bring it up to date.</source>
        <translation>本次计算所依据的内容已改变：按原样显示。请重新模拟。</translation>
    </message>
</context>
<context>
    <name>rubble::PictureExport</name>
    <message>
        <source>Pages (*.html)</source>
        <translation>网页 (*.html)</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>网页</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>图</translation>
    </message>
    <message>
        <source>Figures (*.png *.svg *.pdf)</source>
        <translation>插图 (*.png *.svg *.pdf)</translation>
    </message>
    <message>
        <source>Movie</source>
        <translation>动画</translation>
    </message>
    <message>
        <source>Movies (*.mp4)</source>
        <translation>动画 (*.mp4)</translation>
    </message>
    <message>
        <source>Folder for the pictures of the movie</source>
        <translation>动画图片的文件夹</translation>
    </message>
</context>
<context>
    <name>rubble::Playback</name>
    <message>
        <source>loose structure went over to the engine: islands %1, elements %2, %3</source>
        <translation>松脱的结构交给引擎：孤立部分 %1，单元 %2，%3</translation>
    </message>
</context>
<context>
    <name>rubble::ProjectDisplay</name>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>打开时</translation>
    </message>
    <message>
        <source>History of edits</source>
        <translation>编辑历史</translation>
    </message>
    <message>
        <source>Every edit since the case was opened; a click goes back or forward to it</source>
        <translation>打开案例以来的每次编辑；单击可前后转到该处</translation>
    </message>
</context>
<context>
    <name>rubble::ProjectFiles</name>
    <message>
        <source>Unsaved work of an earlier session cannot be read. %1</source>
        <translation>无法读取先前会话中未保存的工作。%1</translation>
    </message>
    <message>
        <source>It was set aside as %1.</source>
        <translation>它已另存为 %1。</translation>
    </message>
</context>
<context>
    <name>rubble::Recovery</name>
    <message>
        <source>The case was never saved.</source>
        <translation>该案例从未保存。</translation>
    </message>
    <message>
        <source>They are not in %1.</source>
        <translation>它们不在 %1 中。</translation>
    </message>
    <message>
        <source>Others follow: %1.</source>
        <translation>其后还有：%1。</translation>
    </message>
    <message>
        <source>Rubble ended before changes of “%1” were saved. They were kept at %2.</source>
        <translation>Rubble 在“%1”的更改保存之前退出。这些更改于 %2 保留。</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Open the case with these changes; they can be saved then</source>
        <translation>打开带有这些更改的案例；随后可保存</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>Remove these changes for good</source>
        <translation>永久删除这些更改</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>稍后</translation>
    </message>
    <message>
        <source>Ask again at the next start</source>
        <translation>下次启动时再询问</translation>
    </message>
    <message>
        <source>Changes of “%1” were discarded</source>
        <translation>“%1”的更改已丢弃</translation>
    </message>
    <message>
        <source>Temporary runs of a program that ended early were removed: %1 GiB</source>
        <translation>已清除异常终止的程序留下的临时计算：%1 GiB</translation>
    </message>
</context>
<context>
    <name>rubble::ReportWork</name>
    <message>
        <source>Open a result first.</source>
        <translation>请先打开结果。</translation>
    </message>
    <message>
        <source>Simulate first: a report is about a run that is complete.</source>
        <translation>请先模拟：报告针对已完成的计算。</translation>
    </message>
    <message>
        <source>Settings have changed since this run. Simulate again, or undo the changes: a stale run is not reported.</source>
        <translation>该次计算之后设置已更改。请重新模拟或撤销更改：过时的计算不予报告。</translation>
    </message>
    <message>
        <source>Folder for the report</source>
        <translation>报告的文件夹</translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation>报告已写入 %1</translation>
    </message>
    <message>
        <source>The report was cancelled</source>
        <translation>报告已取消</translation>
    </message>
    <message>
        <source>The page Causes holds no comparison that is of now.</source>
        <translation>原因页没有与当前设置相符的比较。</translation>
    </message>
    <message>
        <source>The report was checked</source>
        <translation>报告已检查</translation>
    </message>
    <message>
        <source>Comparison of causes</source>
        <translation>原因的比较</translation>
    </message>
    <message>
        <source>Comparisons (*.json);;All files (*)</source>
        <translation>比较 (*.json);;所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>rubble::RunControl</name>
    <message>
        <source>Simulated in %1</source>
        <translation>模拟用时 %1</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>Shown: the run %1</source>
        <translation>显示的是计算 %1</translation>
    </message>
    <message>
        <source>Settings are being compared: work beside it would spoil the times.</source>
        <translation>正在比较设置：同时进行其他工作会影响计时。</translation>
    </message>
    <message>
        <source>This machine is being calibrated: work beside it would spoil the times.</source>
        <translation>正在标定本机：同时进行其他工作会影响计时。</translation>
    </message>
    <message>
        <source>A reference is being computed.</source>
        <translation>正在计算基准。</translation>
    </message>
    <message>
        <source>Members of an ensemble are being simulated.</source>
        <translation>正在模拟系综的成员。</translation>
    </message>
    <message>
        <source>A run is being simulated.</source>
        <translation>正在模拟。</translation>
    </message>
    <message>
        <source>Measured falls are being simulated.</source>
        <translation>正在模拟实测的下落。</translation>
    </message>
    <message>
        <source>Cancelled at %1 after %2; what is computed is kept</source>
        <translation>在 %1 处取消，耗时 %2；已计算的内容保留</translation>
    </message>
    <message>
        <source>take the settings of the run</source>
        <translation>采用计算的设置</translation>
    </message>
    <message>
        <source>Shown: the run %1. It has other settings than the case; Run &gt; Take its settings</source>
        <translation>已显示：计算 %1。其设置与案例不同；计算 &gt; 采用其设置</translation>
    </message>
    <message>
        <source>Causes are being compared: members of their ensembles are being simulated.</source>
        <translation>正在比较原因：正在模拟其系综的成员。</translation>
    </message>
</context>
<context>
    <name>rubble::RunHistory</name>
    <message>
        <source>It was set aside as %1; a new history begins.</source>
        <translation>它已另存为 %1；历史重新开始。</translation>
    </message>
    <message>
        <source>The history of runs cannot be kept. %1</source>
        <translation>无法保留计算历史。%1</translation>
    </message>
    <message>
        <source>Nothing can be written into %1: this run goes with the case unless it is saved</source>
        <translation>无法写入 %1：此计算若不保存，将随案例一起消失</translation>
    </message>
    <message>
        <source>Runs kept: the oldest made room, %1 of them with %2 GiB; Preferences allow %3 GiB</source>
        <translation>保留的计算：最旧的 %1 次（%2 GiB）已让出空间；首选项允许 %3 GiB</translation>
    </message>
</context>
<context>
    <name>rubble::ScenarioPane</name>
    <message>
        <source>Open a kept run</source>
        <translation>打开保留的计算</translation>
    </message>
    <message>
        <source>Runs (*.run.h5);;All files (*)</source>
        <translation>计算 (*.run.h5);;所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>rubble::ScenariosDisplay</name>
    <message>
        <source>No complete run yet</source>
        <translation>尚无完整的计算</translation>
    </message>
    <message>
        <source>Last run: %1 bodies</source>
        <translation>上次计算：%1 个刚体</translation>
    </message>
    <message>
        <source>Scenarios compared</source>
        <translation>方案比较</translation>
    </message>
</context>
<context>
    <name>rubble::Session</name>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>Cancelled; nothing half-made is left</source>
        <translation>已取消；没有留下半成品</translation>
    </message>
</context>
<context>
    <name>rubble::StartDisplay</name>
    <message>
        <source>today, %1</source>
        <translation>今天，%1</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>定位 %1</translation>
    </message>
    <message>
        <source>Cases and FE results (*)</source>
        <translation>案例和有限元结果 (*)</translation>
    </message>
</context>
<context>
    <name>rubble::StatusFeed</name>
    <message>
        <source>Bodies</source>
        <translation>刚体</translation>
    </message>
    <message>
        <source>%1 awake</source>
        <translation>%1 个活动</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>发现项</translation>
    </message>
    <message>
        <source>Health</source>
        <translation>健康</translation>
    </message>
    <message>
        <source>sound</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>No limit of the health monitor was passed in this run.</source>
        <translation>此次计算未超过任何健康监测限值。</translation>
    </message>
    <message>
        <source>tainted</source>
        <translation>存疑</translation>
    </message>
    <message>
        <source>acknowledged</source>
        <translation>已确认</translation>
    </message>
    <message>
        <source> FPS</source>
        <translation> FPS</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>target %1</source>
        <translation>目标 %1</translation>
    </message>
    <message>
        <source>mean, worst second %1</source>
        <translation>平均值，最差一秒为 %1</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>能量</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>内存</translation>
    </message>
    <message>
        <source> GiB</source>
        <translation> GiB</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>%1 项等待中</translation>
    </message>
</context>
<context>
    <name>rubble::StudyWork</name>
    <message>
        <source>cause %1 of %2: %3</source>
        <translation>原因 %1/%2：%3</translation>
    </message>
</context>
<context>
    <name>rubble::SurveyDisplay</name>
    <message>
        <source>Add a survey</source>
        <translation>添加测绘</translation>
    </message>
    <message>
        <source>survey %1 added</source>
        <translation>已添加测绘 %1</translation>
    </message>
    <message>
        <source>survey removed</source>
        <translation>已移除测绘</translation>
    </message>
    <message>
        <source>Difference map</source>
        <translation>差异图</translation>
    </message>
    <message>
        <source>GeoTIFF (*.tif);;Images (*.png)</source>
        <translation>GeoTIFF (*.tif);;图像 (*.png)</translation>
    </message>
    <message>
        <source>The comparison is of another run or other settings.</source>
        <translation>该比较属于另一次计算或其他设置。</translation>
    </message>
    <message>
        <source>Compare again, then save.</source>
        <translation>请重新比较后再保存。</translation>
    </message>
    <message>
        <source>what the survey shows</source>
        <translation>测绘显示的内容</translation>
    </message>
    <message>
        <source>area of interest removed</source>
        <translation>已移除关注区域</translation>
    </message>
    <message>
        <source>left-out polygon removed</source>
        <translation>已移除略去的多边形</translation>
    </message>
    <message>
        <source>noise of the survey</source>
        <translation>测绘的噪声</translation>
    </message>
    <message>
        <source>area of interest drawn</source>
        <translation>已绘制关注区域</translation>
    </message>
    <message>
        <source>left-out polygon drawn</source>
        <translation>已绘制略去的多边形</translation>
    </message>
    <message>
        <source>Compare once, then draw on the difference map.</source>
        <translation>先比较一次，再在差异图上绘制。</translation>
    </message>
    <message>
        <source>Area of interest</source>
        <translation>关注区域</translation>
    </message>
    <message>
        <source>What is left out</source>
        <translation>略去的部分</translation>
    </message>
    <message>
        <source>area of interest added</source>
        <translation>已添加关注区域</translation>
    </message>
    <message>
        <source>left-out polygons added</source>
        <translation>已添加略去的多边形</translation>
    </message>
    <message>
        <source>when the survey was taken</source>
        <translation>测绘的拍摄时间</translation>
    </message>
    <message>
        <source>survey unplaced</source>
        <translation>测绘的放置已取消</translation>
    </message>
    <message>
        <source>Pairs of places</source>
        <translation>点对</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt *.tsv);;All files (*)</source>
        <translation>表格 (*.csv *.txt *.tsv);;所有文件 (*)</translation>
    </message>
    <message>
        <source>There is no survey to place, or the FE result is not open.</source>
        <translation>没有可放置的测绘，或有限元结果未打开。</translation>
    </message>
    <message>
        <source>survey placed by pairs</source>
        <translation>测绘已按点对放置</translation>
    </message>
    <message>
        <source>when debris was removed</source>
        <translation>堆积物何时被运走</translation>
    </message>
    <message>
        <source>removal left out</source>
        <translation>去掉一处运走的堆积物</translation>
    </message>
    <message>
        <source>What was removed</source>
        <translation>被运走之物</translation>
    </message>
    <message>
        <source>removed debris added</source>
        <translation>添加被运走之物</translation>
    </message>
    <message>
        <source>cloud fitted to what did not move</source>
        <translation>点云已拟合到未移动的部分</translation>
    </message>
    <message>
        <source>how the survey is read</source>
        <translation>测绘的读取方式</translation>
    </message>
    <message>
        <source>A drawing without areas stands in every section: compare a survey, and draw a section on its map.</source>
        <translation>没有面域的图出现在每个剖面中：请先比较一个测绘，再在其差异图上绘制剖面。</translation>
    </message>
</context>
<context>
    <name>rubble::SurveyPairs</name>
    <message>
        <source>Places are picked in the model: open the FE result first.</source>
        <translation>位置在模型中选取：请先打开有限元结果。</translation>
    </message>
    <message>
        <source>Keep pairs as a table</source>
        <translation>把点对存为表</translation>
    </message>
    <message>
        <source>Tables of pairs (*.csv)</source>
        <translation>点对表 (*.csv)</translation>
    </message>
    <message>
        <source>%1 pairs kept in %2</source>
        <translation>%1 个点对已存入 %2</translation>
    </message>
</context>
<context>
    <name>rubble::SurveyPlacing</name>
    <message>
        <source>Reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
</context>
<context>
    <name>rubble::SurveySections</name>
    <message>
        <source>Section</source>
        <translation>剖面</translation>
    </message>
    <message>
        <source>Images (*.png)</source>
        <translation>图片 (*.png)</translation>
    </message>
</context>
<context>
    <name>rubble::TimelineDisplay</name>
    <message>
        <source>bookmark “%1”</source>
        <translation>书签“%1”</translation>
    </message>
    <message>
        <source>bookmark removed</source>
        <translation>书签已删除</translation>
    </message>
    <message>
        <source>bookmark “%1” removed</source>
        <translation>书签“%1”已删除</translation>
    </message>
    <message>
        <source>bookmark at %1</source>
        <translation>%1 处的书签</translation>
    </message>
    <message>
        <source>Bookmark at %1</source>
        <translation>位于 %1 的书签</translation>
    </message>
</context>
<context>
    <name>rubble::ValidationDisplay</name>
    <message>
        <source>Validation</source>
        <translation>验证</translation>
    </message>
    <message>
        <source>Simulating the falls of %1</source>
        <translation>正在模拟 %1 的下落</translation>
    </message>
    <message>
        <source>Reading the sets</source>
        <translation>正在读取数据组</translation>
    </message>
    <message>
        <source>Validation has ended; sets that are done are kept</source>
        <translation>验证已结束；已完成的数据组保留</translation>
    </message>
</context>
<context>
    <name>rubble::ViewArea</name>
    <message>
        <source>Nothing to view yet</source>
        <translation>尚无可查看的内容</translation>
    </message>
    <message>
        <source>The case is open, but its FE result is not. What is wrong is said here and in the Case panel; what can be mended is offered above.</source>
        <translation>案例已打开，但其有限元结果未打开。此处和“案例”面板说明了问题；可修复之处列于上方。</translation>
    </message>
</context>
<context>
    <name>rubble::Worker</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>内存不足。</translation>
    </message>
    <message>
        <source>Close other programs or choose a coarser Basic Grid.</source>
        <translation>请关闭其他程序，或选择更粗的基本网格。</translation>
    </message>
    <message>
        <source>This should not happen: please report it with the file.</source>
        <translation>这不应发生：请附上文件反馈此问题。</translation>
    </message>
</context>
<context>
    <name>rubble::figures</name>
    <message>
        <source>%1 more components · %2</source>
        <translation>另有 %1 个构件 · %2</translation>
    </message>
    <message>
        <source>fragments %1, no reference: errors are not known</source>
        <translation>碎块 %1，没有基准：误差未知</translation>
    </message>
    <message>
        <source>error against the reference:</source>
        <translation>与基准的误差：</translation>
    </message>
    <message>
        <source>not in the reference · %1</source>
        <translation>基准中没有 · %1</translation>
    </message>
    <message>
        <source>fragments %1</source>
        <translation>碎块 %1</translation>
    </message>
    <message>
        <source>fragments %1 in %2 clusters</source>
        <translation>碎块 %1，聚类 %2</translation>
    </message>
    <message>
        <source>birth time</source>
        <translation>产生的时刻</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Conventional FE result</source>
        <translation>常规有限元结果</translation>
    </message>
    <message>
        <source>Fragments</source>
        <translation>碎块</translation>
    </message>
    <message>
        <source>interpolated after state %1 of %2</source>
        <translation>在状态 %1（共 %2）之后插值</translation>
    </message>
    <message>
        <source>last state, %1 of %2</source>
        <translation>最后状态 %1（共 %2）</translation>
    </message>
    <message>
        <source>state %1 of %2</source>
        <translation>状态 %1（共 %2）</translation>
    </message>
    <message>
        <source>not simulated, at their birth places</source>
        <translation>未模拟，位于产生位置</translation>
    </message>
    <message>
        <source>simulated so far</source>
        <translation>已模拟到此</translation>
    </message>
    <message>
        <source>simulated, interpolated</source>
        <translation>已模拟，插值</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>已模拟</translation>
    </message>
    <message>
        <source>%1 · t = %2, %3</source>
        <translation>%1 · t = %2，%3</translation>
    </message>
    <message>
        <source>active structure %1</source>
        <translation>激活结构 %1</translation>
    </message>
    <message>
        <source>released structure %1</source>
        <translation>释放的结构 %1</translation>
    </message>
    <message>
        <source>active %1 of %2 elements</source>
        <translation>激活 %1，共 %2 个单元</translation>
    </message>
    <message>
        <source>selected %1</source>
        <translation>选中 %1</translation>
    </message>
    <message>
        <source>stone</source>
        <translation>石材</translation>
    </message>
    <message>
        <source>concrete</source>
        <translation>混凝土</translation>
    </message>
    <message>
        <source>steel</source>
        <translation>钢</translation>
    </message>
    <message>
        <source>masonry</source>
        <translation>砌体</translation>
    </message>
    <message>
        <source>soil</source>
        <translation>土</translation>
    </message>
    <message>
        <source>water bed</source>
        <translation>水底</translation>
    </message>
    <message>
        <source>Fragments and intact outline</source>
        <translation>碎块与完好结构轮廓</translation>
    </message>
    <message>
        <source>Fragments in plan</source>
        <translation>碎块平面图</translation>
    </message>
    <message>
        <source>intact structure</source>
        <translation>完好结构</translation>
    </message>
    <message>
        <source>cut open</source>
        <translation>已剖开</translation>
    </message>
    <message>
        <source>hidden %1</source>
        <translation>已隐藏 %1</translation>
    </message>
    <message>
        <source>Fragments of another scenario</source>
        <translation>另一方案的碎块</translation>
    </message>
    <message>
        <source>Debris and surroundings</source>
        <translation>碎块与周边环境</translation>
    </message>
    <message>
        <source>Original</source>
        <translation>原始状态</translation>
    </message>
    <message>
        <source>Early stage</source>
        <translation>初期</translation>
    </message>
    <message>
        <source>Intermediate stage</source>
        <translation>中期</translation>
    </message>
    <message>
        <source>Final stage</source>
        <translation>最终阶段</translation>
    </message>
    <message>
        <source>%1 times slower</source>
        <translation>慢 %1 倍</translation>
    </message>
    <message>
        <source>%1 times faster</source>
        <translation>快 %1 倍</translation>
    </message>
    <message>
        <source>over %1</source>
        <translation>超过 %1</translation>
    </message>
    <message>
        <source>≤ %1</source>
        <translation>≤ %1</translation>
    </message>
    <message>
        <source>No run of another scenario is chosen</source>
        <translation>未选择另一方案的计算</translation>
    </message>
    <message>
        <source>Scenario %1 · %2</source>
        <translation>方案 %1 · %2</translation>
    </message>
    <message>
        <source>fragments</source>
        <translation>碎块数</translation>
    </message>
    <message>
        <source>active structure</source>
        <translation>未失效结构</translation>
    </message>
    <message>
        <source>released structure</source>
        <translation>已释放结构</translation>
    </message>
    <message>
        <source>a file has the name of the folder</source>
        <translation>有一个文件与该文件夹同名</translation>
    </message>
    <message>
        <source>to within %1</source>
        <translation>精确到 %1</translation>
    </message>
    <message>
        <source>resolution %1 %</source>
        <translation>分辨率 %1 %</translation>
    </message>
    <message>
        <source>over %1 FE intervals</source>
        <translation>跨 %1 个有限元时间间隔</translation>
    </message>
    <message>
        <source>simplified while moving: %1</source>
        <translation>运动时简化：%1</translation>
    </message>
    <message>
        <source>filter: %1 of %2 shown</source>
        <translation>筛选：显示 %1 / %2</translation>
    </message>
    <message>
        <source>along the section [m]</source>
        <translation>沿剖面 [m]</translation>
    </message>
    <message>
        <source>height [m]</source>
        <translation>高程 [m]</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>ground (dashed)</source>
        <translation>地面（虚线）</translation>
    </message>
    <message>
        <source>loose islands are not known yet</source>
        <translation>尚不知道松脱的孤立部分</translation>
    </message>
    <message>
        <source>not loose</source>
        <translation>未松脱</translation>
    </message>
    <message>
        <source>in loose islands %1</source>
        <translation>在松脱的孤立部分中 %1</translation>
    </message>
    <message>
        <source>island %1 · %2</source>
        <translation>孤立部分 %1 · %2</translation>
    </message>
    <message>
        <source>smaller islands: %1</source>
        <translation>较小的孤立部分：%1</translation>
    </message>
    <message>
        <source>each loose island in a colour of its own</source>
        <translation>每个松脱的孤立部分各有一色</translation>
    </message>
    <message>
        <source>computed, between two states</source>
        <translation>计算结果，两个状态之间</translation>
    </message>
    <message>
        <source>computed, last state</source>
        <translation>计算结果，最后状态</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>计算结果</translation>
    </message>
    <message>
        <source>illustrative, not simulated</source>
        <translation>示意，未模拟</translation>
    </message>
    <message>
        <source>%1 outside the picture</source>
        <translation>%1 个在图外</translation>
    </message>
    <message>
        <source>north is up</source>
        <translation>上方为北</translation>
    </message>
    <message>
        <source>north %1° clockwise from up</source>
        <translation>北在上方顺时针 %1°</translation>
    </message>
    <message>
        <source>y is up</source>
        <translation>上方为 y</translation>
    </message>
    <message>
        <source>y %1° clockwise from up</source>
        <translation>y 在上方顺时针 %1°</translation>
    </message>
    <message>
        <source>looking %1° from x towards y</source>
        <translation>视线从 x 向 y 转 %1°</translation>
    </message>
    <message>
        <source>north</source>
        <translation>北</translation>
    </message>
    <message>
        <source>north-east</source>
        <translation>东北</translation>
    </message>
    <message>
        <source>east</source>
        <translation>东</translation>
    </message>
    <message>
        <source>south-east</source>
        <translation>东南</translation>
    </message>
    <message>
        <source>south</source>
        <translation>南</translation>
    </message>
    <message>
        <source>south-west</source>
        <translation>西南</translation>
    </message>
    <message>
        <source>west</source>
        <translation>西</translation>
    </message>
    <message>
        <source>north-west</source>
        <translation>西北</translation>
    </message>
    <message>
        <source>looking %1 (%2°)</source>
        <translation>朝%1 (%2°)</translation>
    </message>
    <message>
        <source>%1 (assumed)</source>
        <translation>%1（假定）</translation>
    </message>
    <message>
        <source>%1: %2 of %3 points</source>
        <translation>%1：%3 个点中的 %2 个</translation>
    </message>
    <message>
        <source>intensity %1</source>
        <translation>强度 %1</translation>
    </message>
    <message>
        <source>class %1</source>
        <translation>类别 %1</translation>
    </message>
    <message>
        <source>simulated site above, up to %1</source>
        <translation>模拟现场在上，至 %1</translation>
    </message>
    <message>
        <source>below, up to %1</source>
        <translation>在下，至 %1</translation>
    </message>
    <message>
        <source>within the level of detection, %1 in the median</source>
        <translation>在检测限之内，中位数 %1</translation>
    </message>
    <message>
        <source>within the level of detection, %1 in the median, without the error of the registration, which is not known</source>
        <translation>在检测限之内，中位数 %1，未计入未知的配准误差</translation>
    </message>
    <message>
        <source>level of detection not known · %1</source>
        <translation>检测限未知 · %1</translation>
    </message>
    <message>
        <source>from %1 to the site at t = %2: %3 of %4 places</source>
        <translation>从 %1 到 t = %2 时的现场：%4 处中的 %3 处</translation>
    </message>
    <message>
        <source>z = %1</source>
        <translation>z = %1</translation>
    </message>
    <message>
        <source>%1 of collapse in a second</source>
        <translation>每秒播放倒塌过程的 %1</translation>
    </message>
</context>
<context>
    <name>rubble::figures::EncodedMovie</name>
    <message>
        <source>ffmpeg ended before the movie did</source>
        <translation>ffmpeg 在动画完成前已结束</translation>
    </message>
    <message>
        <source>ffmpeg does not answer</source>
        <translation>ffmpeg 没有响应</translation>
    </message>
    <message>
        <source>ffmpeg was killed, or crashed</source>
        <translation>ffmpeg 被终止或崩溃</translation>
    </message>
    <message>
        <source>ffmpeg left no whole MP4</source>
        <translation>ffmpeg 未留下完整的 MP4</translation>
    </message>
</context>
<context>
    <name>rubble::figures::MapEdges</name>
    <message>
        <source>E %1</source>
        <translation>东 %1</translation>
    </message>
    <message>
        <source>N %1</source>
        <translation>北 %1</translation>
    </message>
</context>
<context>
    <name>rubble::figures::PictureSequence</name>
    <message>
        <source>the folder cannot be made</source>
        <translation>无法创建文件夹</translation>
    </message>
    <message>
        <source>%1 is there already, and not of this movie</source>
        <translation>%1 已存在，且不属于此影片</translation>
    </message>
</context>
<context>
    <name>rubble::figures::ReportSections</name>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>A finite-element analysis of a collapse deactivates the elements that fail; from then on they are not part of it. Each deactivated element is turned into a rigid fragment with the place, shape and velocity it had when it was last active. A physics engine carries the fragments from there until they lie at rest. The procedure follows Xu, Lu, Guan and Ren, Automation in Construction 35 (2013) 471–481, with the departures that are named below.</source>
        <translation>倒塌的有限元分析会停用失效的单元；此后它们不再属于分析。每个停用的单元被转化为刚性碎块，其位置、形状和速度取自最后一次有效时。物理引擎从那里开始推动碎块，直到静止。过程遵循 Xu、Lu、Guan 和 Ren,Automation in Construction 35 (2013) 471–481,不同之处在下文说明。</translation>
    </message>
    <message>
        <source>Fragments</source>
        <translation>碎块</translation>
    </message>
    <message>
        <source>The mass of a fragment is the volume of its element at rest times the density of its component. Its velocity and its angular velocity conserve the momenta of the nodal velocity field over the last active shape of the element:</source>
        <translation>碎块的质量是其单元静止时的体积乘以构件的密度。其速度和角速度保持单元最后有效形状上节点速度场的动量：</translation>
    </message>
    <message>
        <source>mass times velocity is the integral of density times nodal velocity; inertia times angular velocity is the integral of its moment</source>
        <translation>质量乘速度等于密度乘节点速度的积分；惯量乘角速度等于其矩的积分</translation>
    </message>
    <message>
        <source>with the mass &lt;i&gt;m&lt;/i&gt;, the inertia tensor &lt;i&gt;I&lt;/i&gt; about the centre of mass &lt;b&gt;c&lt;/b&gt;, the place &lt;b&gt;x&lt;/b&gt;, the interpolated nodal velocity &lt;b&gt;u&lt;/b&gt; and the density &lt;i&gt;ρ&lt;/i&gt;, scaled so that its integral over the shape is &lt;i&gt;m&lt;/i&gt;.</source>
        <translation>其中 &lt;i&gt;m&lt;/i&gt; 为质量，&lt;i&gt;I&lt;/i&gt; 为对质心 &lt;b&gt;c&lt;/b&gt; 的惯性张量，&lt;b&gt;x&lt;/b&gt; 为位置，&lt;b&gt;u&lt;/b&gt; 为插值的节点速度，&lt;i&gt;ρ&lt;/i&gt; 为密度，其缩放使形状上的积分等于 &lt;i&gt;m&lt;/i&gt;。</translation>
    </message>
    <message>
        <source>Clusters</source>
        <translation>聚类</translation>
    </message>
    <message>
        <source>Fragments born together that move alike are carried by one rigid body, a cluster, so that the number of bodies stays within what a machine can simulate. The Basic Grid limits how far a cluster reaches along each axis. Between the mean distance &lt;i&gt;d&lt;/i&gt; of fragments that are neighbours in their order along an axis and the grid size &lt;i&gt;h&lt;/i&gt; stand</source>
        <translation>同时产生且运动相近的碎块由一个刚体(聚类)携带，使刚体数目保持在机器可模拟的范围内。基本网格限制聚类沿各轴的伸展。沿一轴排序相邻碎块的平均间距 &lt;i&gt;d&lt;/i&gt; 与网格尺寸 &lt;i&gt;h&lt;/i&gt; 之间有</translation>
    </message>
    <message>
        <source>mean distance of adjacent fragments, the least grid size for efficiency, the least grid size for accuracy</source>
        <translation>相邻碎块的平均间距、按效率的最小网格尺寸、按精度的最小网格尺寸</translation>
    </message>
    <message>
        <source>with the number of fragments &lt;i&gt;N&lt;sub&gt;f&lt;/sub&gt;&lt;/i&gt; and the largest number of bodies &lt;i&gt;N&lt;sub&gt;A&lt;/sub&gt;&lt;/i&gt;; the smallest dimension of a structural component is the upper bound.</source>
        <translation>其中 &lt;i&gt;N&lt;sub&gt;f&lt;/sub&gt;&lt;/i&gt; 为碎块数，&lt;i&gt;N&lt;sub&gt;A&lt;/sub&gt;&lt;/i&gt; 为最大刚体数；结构构件的最小尺寸为上限。</translation>
    </message>
    <message>
        <source>In this run every fragment is a body of its own.</source>
        <translation>本次计算中每个碎块各为一个刚体。</translation>
    </message>
    <message>
        <source>In this run what died within %1 s of each other was handed over together, with the place, shape and velocity of the first state of that time.</source>
        <translation>在本次计算中，相隔不超过 %1 s 的失效一起交接，取该时段首个状态的位置、形状和速度。</translation>
    </message>
    <message>
        <source>In this run clusters are made by nested cuts: the fragments of each component and birth are cut in two where that leaves the least spread, until every part is as compact as a full box of the grid that has the proportions of its own fragments.</source>
        <translation>本次计算的聚类由嵌套切割得到：每个构件、每次产生的碎块在使离散最小处一分为二，直到每部分与按其自身碎块比例的网格满格一样紧凑。</translation>
    </message>
    <message>
        <source>In this run clusters are the product of groups along the three axes, as in the published method.</source>
        <translation>本次计算的聚类是沿三个轴分组的乘积，与已发表的方法相同。</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>Bodies move by the equations of Newton and Euler under gravity, the contacts with each other, the ground and the structure that still stands, and the effects listed below:</source>
        <translation>刚体在重力、相互间以及与地面和仍然站立的结构的接触，以及下列效应作用下，按牛顿和欧拉方程运动：</translation>
    </message>
    <message>
        <source>mass times acceleration is weight plus contact forces; the change of angular momentum is the sum of their moments</source>
        <translation>质量乘加速度等于重量加接触力；角动量的变化等于其力矩之和</translation>
    </message>
    <message>
        <source>with the contact forces &lt;b&gt;f&lt;/b&gt;&lt;sub&gt;&lt;i&gt;k&lt;/i&gt;&lt;/sub&gt; at the arms &lt;b&gt;r&lt;/b&gt;&lt;sub&gt;&lt;i&gt;k&lt;/i&gt;&lt;/sub&gt;. Tangential forces stay within Coulomb&apos;s cone with the friction of the pair of materials. The active structure follows the FE result and is not moved by the debris.</source>
        <translation>其中 &lt;b&gt;f&lt;/b&gt;&lt;sub&gt;&lt;i&gt;k&lt;/i&gt;&lt;/sub&gt; 为作用在力臂 &lt;b&gt;r&lt;/b&gt;&lt;sub&gt;&lt;i&gt;k&lt;/i&gt;&lt;/sub&gt; 上的接触力。切向力保持在以材料对摩擦系数决定的库仑锥内。未失效结构按有限元结果运动，不受碎块推动。</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>比较度量</translation>
    </message>
    <message>
        <source>Two fields of debris are compared by how their mass lies on the ground, by their outlines and by the way of each fragment:</source>
        <translation>两个碎块堆按质量在地面的分布、轮廓和每个碎块的路径比较：</translation>
    </message>
    <message>
        <source>mass-map difference, intersection over union of the footprints, accuracy rate</source>
        <translation>质量图差异、覆盖范围的交并比、准确率</translation>
    </message>
    <message>
        <source>with the mass &lt;i&gt;m&lt;sub&gt;c&lt;/sub&gt;&lt;/i&gt; in cell &lt;i&gt;c&lt;/i&gt;, the total mass &lt;i&gt;M&lt;/i&gt;, the footprints &lt;i&gt;A&lt;/i&gt;, and the number &lt;i&gt;N&lt;/i&gt;&lt;sup&gt;*&lt;/sup&gt; of fragments that lie within a tolerance of their place in the reference, in which every fragment is its own body.</source>
        <translation>其中 &lt;i&gt;m&lt;sub&gt;c&lt;/sub&gt;&lt;/i&gt; 为格 &lt;i&gt;c&lt;/i&gt; 中的质量，&lt;i&gt;M&lt;/i&gt; 为总质量，&lt;i&gt;A&lt;/i&gt; 为覆盖范围，&lt;i&gt;N&lt;/i&gt;&lt;sup&gt;*&lt;/sup&gt; 为与基准中位置相距在容差内的碎块数；基准中每个碎块各为一个刚体。</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>measure</source>
        <translation>度量</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>at the FE end</source>
        <translation>有限元结束时</translation>
    </message>
    <message>
        <source>mass of the fragments</source>
        <translation>碎块的质量</translation>
    </message>
    <message>
        <source>footprint, 1 m cells</source>
        <translation>覆盖范围，1 米格</translation>
    </message>
    <message>
        <source>core, 95 % of the mass in 2 m cells</source>
        <translation>核心区，2 米格中 95 % 的质量</translation>
    </message>
    <message>
        <source>run-out of 95 % of the mass</source>
        <translation>95 % 质量的散落距离</translation>
    </message>
    <message>
        <source>mean height of the mass</source>
        <translation>质量的平均高度</translation>
    </message>
    <message>
        <source>volume of material</source>
        <translation>材料体积</translation>
    </message>
    <message>
        <source>fallen live structure, apart from the fragments</source>
        <translation>坠落的未失效结构，与碎块分开</translation>
    </message>
    <message>
        <source>Fragments by component</source>
        <translation>按构件的碎块</translation>
    </message>
    <message>
        <source>component</source>
        <translation>构件</translation>
    </message>
    <message>
        <source>mass [t]</source>
        <translation>质量 [t]</translation>
    </message>
    <message>
        <source>first birth [s]</source>
        <translation>最早产生 [s]</translation>
    </message>
    <message>
        <source>last birth [s]</source>
        <translation>最晚产生 [s]</translation>
    </message>
    <message>
        <source>farthest way in plan [m]</source>
        <translation>平面上最远路径 [m]</translation>
    </message>
    <message>
        <source>hardest hit [m/s]</source>
        <translation>最重撞击 [m/s]</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>时间 [s]</translation>
    </message>
    <message>
        <source>energy of all bodies [MJ]</source>
        <translation>全部刚体的能量 [MJ]</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>动能</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>势能</translation>
    </message>
    <message>
        <source>What must be conserved when elements are handed over to bodies, and the energy of the run</source>
        <translation>单元交给刚体时必须守恒的量，以及计算的能量</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>量</translation>
    </message>
    <message>
        <source>value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>mass, bodies against the FE result, largest relative error</source>
        <translation>质量，刚体对有限元结果，最大相对误差</translation>
    </message>
    <message>
        <source>momentum, likewise</source>
        <translation>动量，同上</translation>
    </message>
    <message>
        <source>angular momentum, likewise</source>
        <translation>角动量，同上项</translation>
    </message>
    <message>
        <source>work of gravity</source>
        <translation>重力做功</translation>
    </message>
    <message>
        <source>lost in contacts</source>
        <translation>接触中损失</translation>
    </message>
    <message>
        <source>gain beyond all sources, share of the work of gravity</source>
        <translation>超出所有来源的增量，占重力做功的份额</translation>
    </message>
    <message>
        <source>deepest overlap that lasted over 0.5 s</source>
        <translation>持续 0.5 秒以上的最深重叠</translation>
    </message>
    <message>
        <source>bulking factor of the pile</source>
        <translation>堆的松散系数</translation>
    </message>
    <message>
        <source>The run was repeated %1 times with every birth shifted by a micrometre. The largest difference between any two of these runs is the repeat floor: no smaller difference says anything.</source>
        <translation>该计算以每次产生移动一微米重复了 %1 次。其中任意两次计算之间的最大差异为重复性下限：更小的差异不说明任何问题。</translation>
    </message>
    <message>
        <source>The run itself was simulated again for this and came out the same, bit for bit.</source>
        <translation>为此重新模拟了该计算本身，结果逐位相同。</translation>
    </message>
    <message>
        <source>&lt;b&gt;The run itself did not come out the same when it was simulated again&lt;/b&gt;; the recorded run was made by another build or on another machine. Ranges are still those of repeats.</source>
        <translation>&lt;b&gt;重新模拟时该计算本身的结果不同&lt;/b&gt;;所记录的计算由另一构建版本或在另一台机器上完成。范围仍是重复计算的范围。</translation>
    </message>
    <message>
        <source>The repeat floor: largest difference between the run and its repeats</source>
        <translation>重复性下限：计算与其重复计算之间的最大差异</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>下限</translation>
    </message>
    <message>
        <source>mass-map difference</source>
        <translation>质量图差异</translation>
    </message>
    <message>
        <source>1 − IoU of the core</source>
        <translation>1 − 核心区交并比</translation>
    </message>
    <message>
        <source>1 − IoU of the footprint</source>
        <translation>1 − 覆盖范围交并比</translation>
    </message>
    <message>
        <source>run-out [m]</source>
        <translation>散落距离 [m]</translation>
    </message>
    <message>
        <source>mean height [m]</source>
        <translation>平均高度 [m]</translation>
    </message>
    <message>
        <source>median distance of a fragment between two runs [m]</source>
        <translation>两次计算间碎块距离的中位数 [m]</translation>
    </message>
    <message>
        <source>No repeats were made for this report, so the spread of its figures is not known.</source>
        <translation>本报告没有做重复计算，因此其数值的离散程度未知。</translation>
    </message>
    <message>
        <source>No settings of this scene have been compared with the reference, in which every fragment is its own body; how far this run is from it is not known. The panel Accuracy and rubble-cli accuracy measure it.</source>
        <translation>此场景没有任何设置与基准(每个碎块各为一个刚体)比较过；本次计算与基准相差多少未知。精度面板和 rubble-cli accuracy 可以测量。</translation>
    </message>
    <message>
        <source>Settings of this scene that were compared with the reference, by their number of bodies</source>
        <translation>此场景中与基准比较过的设置，按刚体数排列</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>bodies</source>
        <translation>刚体</translation>
    </message>
    <message>
        <source>wall time [s]</source>
        <translation>耗时 [s]</translation>
    </message>
    <message>
        <source>footprint IoU</source>
        <translation>覆盖范围交并比</translation>
    </message>
    <message>
        <source>wall time [s], this machine</source>
        <translation>耗时 [s],本机</translation>
    </message>
    <message>
        <source>mass-map difference from the reference</source>
        <translation>与基准的质量图差异</translation>
    </message>
    <message>
        <source>Each row is a simulation of its own of the same scene, kept in the folder of studies by the fingerprint of the scene; wall times are those of this machine.</source>
        <translation>每行都是同一场景的单独模拟，按场景指纹保存在研究文件夹中；耗时为本机数值。</translation>
    </message>
    <message>
        <source>repeat floor of this run</source>
        <translation>本次计算的重复性下限</translation>
    </message>
    <message>
        <source>Question and answer</source>
        <translation>问题与回答</translation>
    </message>
    <message>
        <source>Where did the debris of this collapse go, and how sure is that?</source>
        <translation>此次倒塌的碎块去了哪里，有多大把握？</translation>
    </message>
    <message>
        <source>Scenario &lt;i&gt;%1&lt;/i&gt;: %2</source>
        <translation>方案 &lt;i&gt;%1&lt;/i&gt;:%2</translation>
    </message>
    <message>
        <source>Ranges are those over the run and its %1 repeats.</source>
        <translation>范围是该计算及其 %1 次重复计算的范围。</translation>
    </message>
    <message>
        <source>No repeats were made: the spread of these figures is not known.</source>
        <translation>没有做重复计算：这些数值的离散程度未知。</translation>
    </message>
    <message>
        <source>%1 elements of %2 were deactivated and became fragments of together %3 t.</source>
        <translation>%2 个单元中有 %1 个停用，成为总计 %3 t 的碎块。</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>证据</translation>
    </message>
    <message>
        <source>The FE result (%1) holds %2 elements and %3 states from %4 s to %5 s. Activity is decided by: %6. Units: %7.</source>
        <translation>有限元结果(%1)有 %2 个单元和 %3 个状态，从 %4 s 到 %5 s。有效性的判定：%6。单位：%7。</translation>
    </message>
    <message>
        <source>Files that this report rests on, as they were when it was made</source>
        <translation>本报告所依据的文件，以编制时为准</translation>
    </message>
    <message>
        <source>role</source>
        <translation>作用</translation>
    </message>
    <message>
        <source>file</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>The case has no photographs; the simulated debris was not held against pictures of the site.</source>
        <translation>案例没有照片；模拟的碎块未与现场图片比较。</translation>
    </message>
    <message>
        <source>Photographs: camera match, and the silhouette of the simulated debris against the outline drawn on them</source>
        <translation>照片：相机匹配，以及模拟碎块的轮廓与照片上所画轮廓的比较</translation>
    </message>
    <message>
        <source>photograph</source>
        <translation>照片</translation>
    </message>
    <message>
        <source>IoU</source>
        <translation>交并比</translation>
    </message>
    <message>
        <source>spread of the IoU</source>
        <translation>交并比的离散</translation>
    </message>
    <message>
        <source>Inputs, settings and assumptions</source>
        <translation>输入、设置与假定</translation>
    </message>
    <message>
        <source>All settings are those that the program is delivered with; the appendix lists them.</source>
        <translation>所有设置均为程序出厂值；见附录。</translation>
    </message>
    <message>
        <source>Settings that depart from those delivered</source>
        <translation>与出厂值不同的设置</translation>
    </message>
    <message>
        <source>key</source>
        <translation>键</translation>
    </message>
    <message>
        <source>delivered</source>
        <translation>出厂值</translation>
    </message>
    <message>
        <source>in this run</source>
        <translation>本次计算中</translation>
    </message>
    <message>
        <source>Components of the structure and what became fragments</source>
        <translation>结构的构件以及成为碎块的部分</translation>
    </message>
    <message>
        <source>material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>density [kg/m³]</source>
        <translation>密度 [kg/m³]</translation>
    </message>
    <message>
        <source>elements</source>
        <translation>单元数</translation>
    </message>
    <message>
        <source>fragments</source>
        <translation>碎块数</translation>
    </message>
    <message>
        <source>their mass [t]</source>
        <translation>碎块质量 [t]</translation>
    </message>
    <message>
        <source>Assumptions and findings</source>
        <translation>假定与发现项</translation>
    </message>
    <message>
        <source>Nothing had to be assumed or worked around.</source>
        <translation>没有需要假定或变通之处。</translation>
    </message>
    <message>
        <source>What was assumed or worked around, how often, and what would settle it</source>
        <translation>所作的假定或变通、次数，以及如何解决</translation>
    </message>
    <message>
        <source>times</source>
        <translation>次数</translation>
    </message>
    <message>
        <source>finding</source>
        <translation>发现项</translation>
    </message>
    <message>
        <source>what to do about it</source>
        <translation>处理办法</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>效应</translation>
    </message>
    <message>
        <source>Only what the scene calls for is simulated. An effect that is off costs nothing and leaves the run as if it did not exist.</source>
        <translation>只模拟场景需要的内容。关闭的效应不费时间，计算如同它不存在。</translation>
    </message>
    <message>
        <source>Effects, whether they took part, and why</source>
        <translation>各效应是否参与及原因</translation>
    </message>
    <message>
        <source>effect</source>
        <translation>单项效应</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>asked for</source>
        <translation>要求</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>ms per step</source>
        <translation>毫秒/步</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Health of the run</source>
        <translation>运行健康状况</translation>
    </message>
    <message>
        <source>No limit of health was passed: energy, overlap, speeds, places and the share at rest stayed within their limits at every step.</source>
        <translation>没有超过任何健康限值：能量、重叠、速度、位置和静止份额在每一步都在限值内。</translation>
    </message>
    <message>
        <source>Limits of health that were passed</source>
        <translation>超过的健康限值</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>最差</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>Acknowledged by %1 on %2: %3</source>
        <translation>由 %1 于 %2 确认：%3</translation>
    </message>
    <message>
        <source>Self-test of this machine</source>
        <translation>本机自检</translation>
    </message>
    <message>
        <source>The self-test was not run for this report.</source>
        <translation>本报告没有运行自检。</translation>
    </message>
    <message>
        <source>The hard cases of the simulation (%1) were run on this machine with the program that made this report: %2 of %3 passed.</source>
        <translation>用编制本报告的程序在本机上运行了模拟的困难算例(%1):%3 项中通过 %2 项。</translation>
    </message>
    <message>
        <source>Cases of the self-test, each with the number closest to its limit</source>
        <translation>自检算例，各列最接近限值的数</translation>
    </message>
    <message>
        <source>case</source>
        <translation>案例</translation>
    </message>
    <message>
        <source>must hold</source>
        <translation>必须满足</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>result</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>&lt;b&gt;failed&lt;/b&gt;</source>
        <translation>&lt;b&gt;未通过&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>局限性</translation>
    </message>
    <message>
        <source>Fragments do not load the structure back: what still stands moves as the FE result says, whatever falls on it.</source>
        <translation>碎块不反过来给结构加载：仍然站立的部分按有限元结果运动，无论有什么落在上面。</translation>
    </message>
    <message>
        <source>Energy that the FE solver lost when it deleted elements is not returned.</source>
        <translation>有限元求解器删除单元时损失的能量不予归还。</translation>
    </message>
    <message>
        <source>Live elements that fell are debris as well. They are no fragments: maps and comparisons carry them as a layer of their own beyond a displacement of %1 m.</source>
        <translation>倒下的未失效单元同样是堆积物。它们不是碎块：位移超过 %1 m 者在地图和比较中作为单独的图层。</translation>
    </message>
    <message>
        <source>Rigid piles are chaotic: a change of a micrometre moves single fragments by metres. Only what exceeds the spread of repeats means anything, and single fragments are never evidence.</source>
        <translation>刚体堆是混沌的：一微米的变化会使单个碎块移动数米。只有超过重复计算离散的差异才有意义，单个碎块绝不能作为证据。</translation>
    </message>
    <message>
        <source>A cluster is a device of computation and no piece of debris.</source>
        <translation>聚类是计算手段，不是一块碎块。</translation>
    </message>
    <message>
        <source>%1 bodies still moved at the end of the simulation.</source>
        <translation>模拟结束时仍有 %1 个刚体在运动。</translation>
    </message>
    <message>
        <source>All settings of the run</source>
        <translation>计算的全部设置</translation>
    </message>
    <message>
        <source>Settings by key, with their unit and the value as delivered</source>
        <translation>按键列出的设置，附单位和出厂值</translation>
    </message>
    <message>
        <source>Journal of the case</source>
        <translation>案例的日志</translation>
    </message>
    <message>
        <source>The report was made from a run alone, without its case.</source>
        <translation>报告仅由计算编制，没有其案例。</translation>
    </message>
    <message>
        <source>The case has no journal: it was saved by a version without one.</source>
        <translation>案例没有日志：由不带日志的版本保存。</translation>
    </message>
    <message>
        <source>When the case was saved, by whom, and what had changed</source>
        <translation>案例何时由谁保存，改了什么</translation>
    </message>
    <message>
        <source>saved (UTC)</source>
        <translation>保存时间 (UTC)</translation>
    </message>
    <message>
        <source>by</source>
        <translation>保存者</translation>
    </message>
    <message>
        <source>changes</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>digest</source>
        <translation>摘要</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>另有 %1 项</translation>
    </message>
    <message>
        <source>outside Rubble</source>
        <translation>Rubble 之外</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1(%2 至 %3)</translation>
    </message>
    <message>
        <source>uniform from %1 to %2</source>
        <translation>均匀分布，%1 至 %2</translation>
    </message>
    <message>
        <source>normal, %1 ± %2</source>
        <translation>正态分布，%1 ± %2</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>取自 %1</translation>
    </message>
    <message>
        <source>What is not known</source>
        <translation>未知的量</translation>
    </message>
    <message>
        <source>No ensemble was simulated of this case: how far friction, births and other things that are not known move the debris is not part of this report. The ranges above are those of repeats alone.</source>
        <translation>本案例没有模拟系综：摩擦、产生时刻等未知量使堆积物移动多少，不在本报告之内。以上范围仅来自重复计算。</translation>
    </message>
    <message>
        <source>The collapse was simulated %1 times with what is not known drawn anew for each member (seed %2). Members differ by what is drawn and by births that are moved by a micrometre.</source>
        <translation>倒塌被模拟 %1 次，每个成员的未知量重新抽取（种子 %2）。成员之间的差别在于抽取的取值，以及产生位置移动一微米。</translation>
    </message>
    <message>
        <source>The case asks for %1 members; %2 of them have been simulated, and what follows is of these.</source>
        <translation>案例要求 %1 个成员；其中 %2 个已模拟，以下内容即来自它们。</translation>
    </message>
    <message>
        <source>What is drawn for each member</source>
        <translation>为每个成员抽取的量</translation>
    </message>
    <message>
        <source>distribution</source>
        <translation>分布</translation>
    </message>
    <message>
        <source>figure</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>平均值</translation>
    </message>
    <message>
        <source>± mean</source>
        <translation>± 平均值</translation>
    </message>
    <message>
        <source>± members</source>
        <translation>± 成员</translation>
    </message>
    <message>
        <source>5 %</source>
        <translation>5 %</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Trajectories of the members: %1 and %2 more.</source>
        <translation>成员的轨迹：%1，另有 %2 个。</translation>
    </message>
    <message>
        <source>Trajectories of the members: %1.</source>
        <translation>成员的轨迹：%1。</translation>
    </message>
    <message>
        <source>Probability that debris reaches into a cell, over %1 members</source>
        <translation>堆积物到达单元的概率，基于 %1 个成员</translation>
    </message>
    <message>
        <source>For so few members the probability of a cell may be off by %1 in the mean and by %2 at most (one standard error). That covers what was varied and nothing else: neither what the FE analysis left out nor the size of its mesh.</source>
        <translation>成员数有限，单元的概率平均可能偏差 %1，最多 %2（一个标准误差）。这只涵盖所变动的量：既不含有限元分析忽略的内容，也不含其网格尺寸的影响。</translation>
    </message>
    <message>
        <source>The reference itself is no longer kept, so what it repeats to is not known.</source>
        <translation>参考计算本身已不再保留，因此其重复性未知。</translation>
    </message>
    <message>
        <source>From the reference that the sweep kept, trajectory %1, and its repeats: %2.</source>
        <translation>来自参数扫描保留的参考计算（轨迹 %1）及其重复计算：%2。</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>In the reference every fragment is its own body: its debris covers %1 m², 95 % of the mass lies within %2 m of the plan of what collapsed, and the mass lies at a mean height of %3 m.</source>
        <translation>在参考计算中每个碎块各为一个刚体：其堆积物覆盖 %1 m²，95 % 的质量位于倒塌部分平面轮廓 %2 m 之内，质量的平均高度为 %3 m。</translation>
    </message>
    <message>
        <source>It was not repeated: its own floor is not known.</source>
        <translation>未对其作重复计算：其自身的重复性下限未知。</translation>
    </message>
    <message>
        <source>It was repeated %1 times as the run was. A setting that is no farther from it than this floor cannot be told from it.</source>
        <translation>与本次计算一样，对其重复了 %1 次。与其差别不超过此下限的设置无法与之区分。</translation>
    </message>
    <message>
        <source>The repeat floor of the reference: largest difference between it and its repeats</source>
        <translation>参考计算的重复性下限：它与其重复计算之间的最大差别</translation>
    </message>
    <message>
        <source>repeat floor of the reference</source>
        <translation>参考计算的重复性下限</translation>
    </message>
    <message>
        <source>Photographs</source>
        <translation>照片对照</translation>
    </message>
    <message>
        <source>The camera of a photograph is found from points that were picked on it and in the model. The silhouette of the simulated debris is then held against the outline that was drawn on the photograph; spreads are those over the cameras that the points allow.</source>
        <translation>照片的相机由在照片上和模型中选取的点求得。然后将模拟堆积物的剪影与照片上所画的轮廓对照；离散为这些点所允许的各相机之间的离散。</translation>
    </message>
    <message>
        <source>points used</source>
        <translation>所用的点</translation>
    </message>
    <message>
        <source>RMS [px]</source>
        <translation>RMS [px]</translation>
    </message>
    <message>
        <source>camera within, 95 % [m]</source>
        <translation>相机位置，95 % [m]</translation>
    </message>
    <message>
        <source>edges apart [m]</source>
        <translation>边缘相距 [m]</translation>
    </message>
    <message>
        <source>spread [m]</source>
        <translation>离散 [m]</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>White: the outline drawn on it; dotted, what was left out.</source>
        <translation>白色：照片上所画的轮廓；点线：不计入的部分。</translation>
    </message>
    <message>
        <source>Orange: the outline of the simulated debris at %1 s, %2.</source>
        <translation>橙色：%1 s 时模拟堆积物的轮廓，%2。</translation>
    </message>
    <message>
        <source>fallen live structure with it</source>
        <translation>含坠落的未失效结构</translation>
    </message>
    <message>
        <source>without fallen live structure</source>
        <translation>不含坠落的未失效结构</translation>
    </message>
    <message>
        <source>The case has no survey of the debris; heights and outline were not held against one.</source>
        <translation>案例没有堆积物的测绘；高度和轮廓未与测绘对照。</translation>
    </message>
    <message>
        <source>Surveys</source>
        <translation>测绘对照</translation>
    </message>
    <message>
        <source>Surveys: surveyed debris against the simulated</source>
        <translation>测绘：测得的堆积物与模拟的堆积物</translation>
    </message>
    <message>
        <source>survey</source>
        <translation>测绘</translation>
    </message>
    <message>
        <source>surveyed</source>
        <translation>测得</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>%1: difference map. %2</source>
        <translation>%1：差异图。%2</translation>
    </message>
    <message>
        <source>area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>volume with voids</source>
        <translation>体积（含空隙）</translation>
    </message>
    <message>
        <source>farthest run-out of 95 % of the area</source>
        <translation>95 % 面积的最大散落距离</translation>
    </message>
    <message>
        <source>overlap of the footprints (IoU)</source>
        <translation>覆盖范围的重合度（IoU）</translation>
    </message>
    <message>
        <source>centroids apart</source>
        <translation>质心相距</translation>
    </message>
    <message>
        <source>heights differ, RMS</source>
        <translation>高度差，RMS</translation>
    </message>
    <message>
        <source>heights differ, mean</source>
        <translation>高度差，平均</translation>
    </message>
    <message>
        <source>The first figures set what the FE result alone shows against the fragments. The tables and the map after them say how much lies where; brackets hold what the repeats came to.</source>
        <translation>前几幅图将有限元结果单独所示与碎块对照。其后的表格和分布图说明何处有多少堆积物；括号内为各次重复的结果。</translation>
    </message>
    <message>
        <source>FE result</source>
        <translation>有限元结果</translation>
    </message>
    <message>
        <source>terrain</source>
        <translation>地形</translation>
    </message>
    <message>
        <source>orthophoto</source>
        <translation>正射影像</translation>
    </message>
    <message>
        <source>surroundings</source>
        <translation>周边</translation>
    </message>
    <message>
        <source>run</source>
        <translation>计算</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Debris at the end of the run, with the least and the largest over it and its %1 repeats, and at the end of the FE result</source>
        <translation>计算结束时的堆积物（附计算及其 %1 次重复的最小和最大值）以及有限元结果结束时的堆积物</translation>
    </message>
    <message>
        <source>Debris at the end of the run and at the end of the FE result</source>
        <translation>计算结束时和有限元结果结束时的堆积物</translation>
    </message>
    <message>
        <source>(all at rest at the end of the run)</source>
        <translation>（计算结束时全部静止）</translation>
    </message>
    <message>
        <source>(%1 bodies still move at the end of the run)</source>
        <translation>（计算结束时仍有 %1 个刚体在运动）</translation>
    </message>
    <message>
        <source>at the end (range)</source>
        <translation>结束时（范围）</translation>
    </message>
    <message>
        <source>kinetic energy with which fragments became bodies</source>
        <translation>碎块成为刚体时带入的动能</translation>
    </message>
    <message>
        <source>work of water, air and ties; below zero they took energy</source>
        <translation>水、空气和连系所作的功；负值表示吸收能量</translation>
    </message>
    <message>
        <source>work of parting what overlapped at birth</source>
        <translation>分开出生时重叠部分所作的功</translation>
    </message>
    <message>
        <source>work of the structure that moved against bodies</source>
        <translation>运动的结构推动刚体所作的功</translation>
    </message>
    <message>
        <source>kinetic energy left at the end</source>
        <translation>结束时剩余的动能</translation>
    </message>
    <message>
        <source>From run %1, trajectory %2</source>
        <translation>来自计算 %1，轨迹 %2</translation>
    </message>
    <message>
        <source>highest cell of 1 m, mean height</source>
        <translation>最高的 1 m 单元的平均高度</translation>
    </message>
    <message>
        <source>At the end, %1 s on the clock of the FE result, the debris covers %2 m² in cells of 1 m; 95 % of its mass lies within %3 m of the plan of what collapsed.</source>
        <translation>结束时(有限元结果时钟 %1 s),碎块以 1 m 单元计覆盖 %2 m²;95 % 的质量位于距倒塌部分平面 %3 m 以内。</translation>
    </message>
    <message>
        <source>The highest of these cells lies %1 m above the ground in the mean; %2 % of the bodies are at rest.</source>
        <translation>其中最高的单元平均高出地面 %1 m;%2 % 的刚体静止。</translation>
    </message>
    <message>
        <source>A survey is compared cell by cell where it was taken, without moving it; volumes lie between ground and top and hold the voids. Steep edges make a surveyed area too large: measures of both sides surveyed alike are free of that.</source>
        <translation>测绘按单元在其所在位置比较，不作移动；体积位于地面与顶面之间，包含空隙。陡峭的边缘使测得的面积偏大：两侧以同样方式测绘的数值不受此影响。</translation>
    </message>
    <message>
        <source>area, both surveyed alike</source>
        <translation>面积，两侧以同样方式测绘</translation>
    </message>
    <message>
        <source>IoU that a perfect simulation reaches on this grid</source>
        <translation>完美模拟在此网格上达到的 IoU</translation>
    </message>
    <message>
        <source>IoU, both surveyed alike</source>
        <translation>IoU，两侧以同样方式测绘</translation>
    </message>
    <message>
        <source>surveyed fill</source>
        <translation>测得填方</translation>
    </message>
    <message>
        <source>surveyed cut</source>
        <translation>测得挖方</translation>
    </message>
    <message>
        <source>surveyed net volume</source>
        <translation>测得净体积</translation>
    </message>
    <message>
        <source>level of detection, stated</source>
        <translation>检测限，给定</translation>
    </message>
    <message>
        <source>level of detection, estimated</source>
        <translation>检测限，估计</translation>
    </message>
    <message>
        <source>surveyed debris that is not compared</source>
        <translation>未比较的测得堆积物</translation>
    </message>
    <message>
        <source>simulated debris that is not compared</source>
        <translation>未比较的模拟堆积物</translation>
    </message>
    <message>
        <source>Loose structure that the engine moved before the FE result ended</source>
        <translation>有限元结果结束之前由引擎移动的松脱结构</translation>
    </message>
    <message>
        <source>islands that came loose</source>
        <translation>松脱的孤立部分</translation>
    </message>
    <message>
        <source>their mass</source>
        <translation>其质量</translation>
    </message>
    <message>
        <source>fragments born from them</source>
        <translation>由其产生的碎块</translation>
    </message>
    <message>
        <source>of these, killed by the FE result after their island had come to rest elsewhere</source>
        <translation>其中孤立部分已在别处静止之后才被有限元结果令其失效的</translation>
    </message>
    <message>
        <source>left of them at the end</source>
        <translation>结束时余下的</translation>
    </message>
    <message>
        <source>kinetic energy of deformation that was dropped</source>
        <translation>舍去的变形动能</translation>
    </message>
    <message>
        <source>mass and momenta against the FE result, largest relative error</source>
        <translation>质量和动量相对有限元结果的最大相对误差</translation>
    </message>
    <message>
        <source>mass and momenta of what was born and left against what there was, likewise</source>
        <translation>产生与余下之和相对原有的质量和动量，同上</translation>
    </message>
    <message>
        <source>&lt;b&gt;The evidence was not asked&lt;/b&gt;: no photograph and no survey was held against this run. What follows is what the simulation says, under the assumptions of this report.</source>
        <translation>&lt;b&gt;未询问证据&lt;/b&gt;：没有照片或测绘与本次计算对照。以下是模拟在本报告的假设下所说的。</translation>
    </message>
    <message>
        <source>The evidence was asked: photographs held against this run: %1, surveys: %2 (see section Evidence).</source>
        <translation>已询问证据：与本次计算对照的照片：%1，测绘：%2（见“证据”一节）。</translation>
    </message>
    <message>
        <source>Its figures should not be relied on (see section Health).</source>
        <translation>不应依据其数值（见“健康”一节）。</translation>
    </message>
    <message>
        <source>%1 vouches for its use: %2 (see section Health).</source>
        <translation>%1 为其使用担保：%2（见“健康”一节）。</translation>
    </message>
    <message>
        <source>notice</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>tainted</source>
        <translation>存疑</translation>
    </message>
    <message>
        <source>when [s]</source>
        <translation>何时 [s]</translation>
    </message>
    <message>
        <source>grade</source>
        <translation>等级</translation>
    </message>
    <message>
        <source>what, and why this grade</source>
        <translation>内容及该等级的原因</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>over the ensemble, 5 to 95 %</source>
        <translation>系综，5 至 95 %</translation>
    </message>
    <message>
        <source>What is not known of friction, restitution and births was not varied: what it does to these figures is not known.</source>
        <translation>摩擦、恢复系数和产生时刻中的未知没有变化过：它对这些数值的影响不得而知。</translation>
    </message>
    <message>
        <source>Friction and restitution of the materials that can meet, and what is known of them</source>
        <translation>能够相遇的材料之间的摩擦和恢复系数，以及对其所知</translation>
    </message>
    <message>
        <source>pair</source>
        <translation>材料对</translation>
    </message>
    <message>
        <source>coefficient</source>
        <translation>系数</translation>
    </message>
    <message>
        <source>range</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 对 %2</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>摩擦</translation>
    </message>
    <message>
        <source>restitution</source>
        <translation>恢复系数</translation>
    </message>
    <message>
        <source>An ensemble draws from these ranges. &lt;i&gt;Assumed&lt;/i&gt; are those that no source gives for the pair itself.</source>
        <translation>系综从这些范围中抽取。&lt;i&gt;假定&lt;/i&gt;的是没有来源就该材料对本身给出的范围。</translation>
    </message>
    <message>
        <source>Spread of repeats, and agreement with the reference</source>
        <translation>重复的离散，以及与基准的一致性</translation>
    </message>
    <message>
        <source>What agreement with the reference costs in time; beside each point its number of bodies</source>
        <translation>与基准的一致性以多少时间为代价；各点旁为其刚体数</translation>
    </message>
    <message>
        <source>Validation: held against measured falls</source>
        <translation>验证：与实测的下落比较</translation>
    </message>
    <message>
        <source>Agreement with the reference, in the section before, compares a simulation with a finer one: a verification, which says nothing of the world. Validation holds the same program against bodies that really fell, and gives the known rate of error as far as such measurements go. None of them is of this collapse.</source>
        <translation>前一节中与基准的一致性把一次模拟与更精细的模拟比较：属于核实，并不说明真实世界。验证把同一程序与真实下落的物体比较，在这些测量所及的范围内给出已知的误差率。其中没有一项属于本次倒塌。</translation>
    </message>
    <message>
        <source>The program that made this report was not held against measured falls on this machine: its rate of error is not part of this report. &lt;code&gt;rubble-cli validate&lt;/code&gt;, or &lt;i&gt;Validation&lt;/i&gt; in the menu &lt;i&gt;Help&lt;/i&gt;, does so.</source>
        <translation>生成本报告的程序尚未在本机上与实测的下落比较：其误差率不在本报告之内。&lt;code&gt;rubble-cli validate&lt;/code&gt; 或菜单&lt;i&gt;帮助&lt;/i&gt;中的&lt;i&gt;验证&lt;/i&gt;进行这一比较。</translation>
    </message>
    <message>
        <source>Measured and simulated falls</source>
        <translation>实测与模拟的下落</translation>
    </message>
    <message>
        <source>set, variant</source>
        <translation>数据组，方式</translation>
    </message>
    <message>
        <source>measured D</source>
        <translation>实测 D</translation>
    </message>
    <message>
        <source>simulated S</source>
        <translation>模拟 S</translation>
    </message>
    <message>
        <source>E = S − D (95 %)</source>
        <translation>E = S − D（95 %）</translation>
    </message>
    <message>
        <source>area (by chance)</source>
        <translation>面积（偶然）</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>asked</source>
        <translation>须满足</translation>
    </message>
    <message>
        <source>What these falls were simulated with, and where the values come from</source>
        <translation>这些下落以什么模拟，以及各值的来源</translation>
    </message>
    <message>
        <source>From simulations of these sets by the program that made this report, apart from its run.</source>
        <translation>来自生成本报告的程序对这些数据组的模拟，与其计算无关。</translation>
    </message>
    <message>
        <source>The size of fragments is the size of the elements: a finer mesh gives smaller debris, and nothing breaks below it. On a stone arch, elements of 6.1 t instead of 1.3 t moved 25 % of the mass map, where a repeat moves 10 %; run-out fell from 10.4 m to 6.3 m, and the mean height rose from 3.0 m to 3.5 m. Part of that is the FE analysis of the other mesh.</source>
        <translation>碎块的大小就是单元的大小：网格越细碎块越小，小于它的不会再破碎。在一座石拱上，单元为 6.1 t 而非 1.3 t 时，质量图移动 25 %，而重复移动 10 %；散落距离由 10.4 m 降至 6.3 m，平均高度由 3.0 m 升至 3.5 m。其中一部分来自另一网格的有限元分析。</translation>
    </message>
    <message>
        <source>and by a blow more than twice as hard as any that the engine had given them</source>
        <translation>以及因冲击超过引擎所给两倍而失效的</translation>
    </message>
    <message>
        <source>comparison of causes</source>
        <translation>原因的比较</translation>
    </message>
    <message>
        <source>words of the author</source>
        <translation>作者的说明</translation>
    </message>
    <message>
        <source>Who held these files before this report was made, and what was done to them, is not said here.</source>
        <translation>此处没有说明在编写本报告之前由谁保管这些文件，以及对其做过什么。</translation>
    </message>
    <message>
        <source>Custody of the material</source>
        <translation>材料的保管</translation>
    </message>
    <message>
        <source>What was read</source>
        <translation>所读取的内容</translation>
    </message>
    <message>
        <source>Summary in plain language</source>
        <translation>通俗摘要</translation>
    </message>
    <message>
        <source>Other causes</source>
        <translation>其他原因</translation>
    </message>
    <message>
        <source>This report is about the cause that the FE result assumes. It does not say which other causes were considered.</source>
        <translation>本报告针对有限元结果所假定的原因，没有说明考虑过哪些其他原因。</translation>
    </message>
    <message>
        <source>%1 causes were held against the same evidence (%2), each with an ensemble in which what is not known was varied.</source>
        <translation>%1 个原因与同样的证据（%2）比较，各有一个系综，其中未知的量有所变动。</translation>
    </message>
    <message>
        <source>&lt;b&gt;The evidence lies outside of what the members of %1 do, which comes closest: perhaps none of these is the cause.&lt;/b&gt;</source>
        <translation>&lt;b&gt;证据在最接近的 %1 的成员所及之外：这些可能都不是原因。&lt;/b&gt;</translation>
    </message>
    <message>
        <source>%1 comes closest, and the evidence tells it from all others.</source>
        <translation>%1 最接近，且证据能将其与其余全部区分。</translation>
    </message>
    <message>
        <source>%1 comes closest, but the evidence cannot tell it from %2.</source>
        <translation>%1 最接近，但证据不能将其与 %2 区分。</translation>
    </message>
    <message>
        <source>Supposed causes, the closest to the evidence first; a cause is excluded where at least 70 % is certain</source>
        <translation>假定的原因，最接近证据者在前；确定至少有 70 % 时，原因被排除</translation>
    </message>
    <message>
        <source>cause</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>members</source>
        <translation>成员</translation>
    </message>
    <message>
        <source>pairs in which the closest is closer</source>
        <translation>最接近者更接近的成员对</translation>
    </message>
    <message>
        <source>at least, 95 %</source>
        <translation>至少，95 %</translation>
    </message>
    <message>
        <source>closest</source>
        <translation>最接近</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>已排除</translation>
    </message>
    <message>
        <source>not excluded</source>
        <translation>未排除</translation>
    </message>
    <message>
        <source>From the comparison of causes among the files that this report rests on</source>
        <translation>来自本报告所依据文件中的原因比较</translation>
    </message>
    <message>
        <source>Which evidence would tell</source>
        <translation>哪种证据能够说明</translation>
    </message>
    <message>
        <source>Each of %1 members in turn was what happened, seen without error, and its cause was looked for. This is what could be told at best; the first of %2 pieces that were tried is flattered by chance.</source>
        <translation>%1 个成员轮流充当实际所发生的，无误差地观测并寻找其原因。这是所能告知的上限；所尝试的 %2 项中居首者有偶然的成分。</translation>
    </message>
    <message>
        <source>Further evidence, that which names the cause rightly most often first</source>
        <translation>进一步的证据，最常正确指出原因者在前</translation>
    </message>
    <message>
        <source>evidence</source>
        <translation>补充证据</translation>
    </message>
    <message>
        <source>named rightly</source>
        <translation>正确指出</translation>
    </message>
    <message>
        <source>named wrongly</source>
        <translation>错误指出</translation>
    </message>
    <message>
        <source>what is at hand</source>
        <translation>现有证据</translation>
    </message>
    <message>
        <source>and %1</source>
        <translation>另加%1</translation>
    </message>
    <message>
        <source>What would change the opinion</source>
        <translation>什么会改变意见</translation>
    </message>
    <message>
        <source>The collapse at three instants: the conventional FE result (computed), and the fragments (simulated) with the structure that still stands, from the same camera</source>
        <translation>三个时刻的倒塌：常规有限元结果（计算），以及碎块（模拟）和未倒塌的结构，相机相同</translation>
    </message>
    <message>
        <source>The conventional FE result (computed) and the fragments (simulated) at the end</source>
        <translation>结束时的常规有限元结果（计算）和碎块（模拟）</translation>
    </message>
    <message>
        <source>Mass of the simulated debris per area at the end</source>
        <translation>结束时单位面积上模拟堆积物的质量</translation>
    </message>
    <message>
        <source>Four stages of the collapse, simulated, fragments in red</source>
        <translation>倒塌的四个阶段，模拟，碎块为红色</translation>
    </message>
    <message>
        <source>Simulated energy of the bodies over time; they enter as their elements are deactivated, or as loose structure that the engine takes over</source>
        <translation>模拟的刚体能量随时间的变化；刚体在其单元失效后进入，或作为由引擎接管的松脱结构进入</translation>
    </message>
    <message>
        <source>Simulated energy of the bodies over time; they enter as their elements are deactivated, or released at the end of the FE result</source>
        <translation>模拟的刚体能量随时间的变化；刚体在其单元失效或在有限元结果结束时释放后进入</translation>
    </message>
    <message>
        <source>of the compared causes</source>
        <translation>所比较的原因</translation>
    </message>
    <message>
        <source>%1, by its density</source>
        <translation>%1（由密度推断）</translation>
    </message>
    <message>
        <source>What is a material &lt;i&gt;by its density&lt;/i&gt; was guessed: nobody said what the component is made of.</source>
        <translation>标明&lt;i&gt;由密度推断&lt;/i&gt;的材料是猜测：没有人说明该构件由什么制成。</translation>
    </message>
    <message>
        <source>The case says of this scenario: %1</source>
        <translation>案例对此方案的说明：%1</translation>
    </message>
    <message>
        <source>Where the debris of the collapse went: simulation report</source>
        <translation>倒塌碎块的去向：模拟报告</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
    <message>
        <source>Figure %1</source>
        <translation>图 %1</translation>
    </message>
    <message>
        <source>Table %1</source>
        <translation>表 %1</translation>
    </message>
    <message>
        <source>%1 · run %2</source>
        <translation>%1 · 计算 %2</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>编制者</translation>
    </message>
    <message>
        <source>Made on (UTC)</source>
        <translation>编制时间 (UTC)</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>方案</translation>
    </message>
    <message>
        <source>SHA-256 of the FE result</source>
        <translation>有限元结果的 SHA-256</translation>
    </message>
    <message>
        <source>Fingerprint of the run</source>
        <translation>计算的指纹</translation>
    </message>
    <message>
        <source>Trajectory hash</source>
        <translation>轨迹哈希</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机器</translation>
    </message>
    <message>
        <source>%1, set alike for %2: %3</source>
        <translation>%1，以下 %2 个取值相同：%3</translation>
    </message>
    <message>
        <source>level of detection, not known: every height counts</source>
        <translation>检测限未知：所有高度都计入</translation>
    </message>
    <message>
        <source>fill also below the level of detection, not counted</source>
        <translation>另有低于检测限的填方，未计入</translation>
    </message>
    <message>
        <source>cut also below the level of detection, not counted</source>
        <translation>另有低于检测限的挖方，未计入</translation>
    </message>
    <message>
        <source>net volume below the level of detection, not counted</source>
        <translation>低于检测限的净体积，未计入</translation>
    </message>
    <message>
        <source>Who answers for this report</source>
        <translation>本报告由谁负责</translation>
    </message>
    <message>
        <source>Name: %1</source>
        <translation>姓名：%1</translation>
    </message>
    <message>
        <source>Place and date: %1</source>
        <translation>地点和日期：%1</translation>
    </message>
    <message>
        <source>Signature: %1</source>
        <translation>签名：%1</translation>
    </message>
    <message>
        <source>laid on cells of %1 m with fallen live structure</source>
        <translation>按 %1 m 的单元格计，含坠落的未失效结构</translation>
    </message>
    <message>
        <source>laid on cells of %1 m without fallen live structure</source>
        <translation>按 %1 m 的单元格计，不含坠落的未失效结构</translation>
    </message>
    <message>
        <source>nine of ten among %1 members</source>
        <translation>%1 个成员中的九成</translation>
    </message>
    <message>
        <source>all %1 members</source>
        <translation>全部 %1 个成员</translation>
    </message>
    <message>
        <source>With what is not known drawn anew, %1 have a run-out of %2 m. Their debris, %3, covers %4 m², and its highest cell is %5 m high in the mean (see section What is not known).</source>
        <translation>未知之处重新抽取后，%1的散落距离为 %2 m。其堆积物（%3）覆盖 %4 m²，最高单元格的平均高度为 %5 m（见“未知的量”一节）。</translation>
    </message>
    <message>
        <source>Spread over %1 members, %2: mean with its standard error, standard deviation of the members, and the values that one member in twenty lies below and above</source>
        <translation>%1 个成员的离散，%2：平均值及其标准误差、成员的标准差，以及二十个成员中有一个低于和高于的值</translation>
    </message>
    <message>
        <source>Spread over %1 members, %2: mean with its standard error, standard deviation of the members, and the least and the most of them, for they are too few for quantiles</source>
        <translation>%1 个成员的离散，%2：平均值及其标准误差、成员的标准差，以及其中的最小和最大值，因为成员太少，没有分位数</translation>
    </message>
    <message>
        <source>least</source>
        <translation>最小值</translation>
    </message>
    <message>
        <source>most</source>
        <translation>最大值</translation>
    </message>
    <message>
        <source>over the ensemble, least to most</source>
        <translation>系综范围，最小至最大</translation>
    </message>
</context>
<context>
    <name>rubble::figures::Sheet</name>
    <message>
        <source>No debris at this time</source>
        <translation>此时没有堆积物</translation>
    </message>
    <message>
        <source>N</source>
        <translation>北</translation>
    </message>
    <message>
        <source>fallen live structure</source>
        <translation>坠落的未失效结构</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>另有 %1 项</translation>
    </message>
    <message>
        <source>%1, t = %2, %3, cells of %4</source>
        <translation>%1，t = %2，%3，单元格 %4</translation>
    </message>
    <message>
        <source>; %1 cells with debris lie outside the picture</source>
        <translation>；另有 %1 个有堆积物的单元格在图外</translation>
    </message>
    <message>
        <source>local coordinates in metres</source>
        <translation>局部坐标，单位 m</translation>
    </message>
    <message>
        <source>for %1</source>
        <translation>支持 %1</translation>
    </message>
    <message>
        <source>P(height &gt; %1 m)</source>
        <translation>P(高度 &gt; %1 m)</translation>
    </message>
    <message>
        <source>log ratio</source>
        <translation>对数比</translation>
    </message>
    <message>
        <source>%1; %2 members of an ensemble, %3, cells of %4</source>
        <translation>%1；系综成员 %2 个，%3，单元格 %4</translation>
    </message>
    <message>
        <source>height, every %1</source>
        <translation>高度，每 %1</translation>
    </message>
    <message>
        <source>stood before the collapse</source>
        <translation>倒塌前的位置</translation>
    </message>
    <message>
        <source>found on the site</source>
        <translation>现场所见</translation>
    </message>
</context>
<context>
    <name>rubble::figures::SurveySheet</name>
    <message>
        <source>simulated only</source>
        <translation>仅模拟</translation>
    </message>
    <message>
        <source>surveyed only</source>
        <translation>仅测绘</translation>
    </message>
    <message>
        <source>both</source>
        <translation>两者</translation>
    </message>
    <message>
        <source>Simulated less surveyed [m]</source>
        <translation>模拟减测绘 [m]</translation>
    </message>
    <message>
        <source>edge of the survey</source>
        <translation>测绘边缘</translation>
    </message>
    <message>
        <source>edge of the simulation</source>
        <translation>模拟边缘</translation>
    </message>
    <message>
        <source>not surveyed</source>
        <translation>未测绘</translation>
    </message>
    <message>
        <source>Simulated debris at t = %1 against the survey; IoU %2, cells of %3; fallen live structure %4</source>
        <translation>t = %1 时的模拟堆积物与测绘；IoU %2，单元 %3；坠落的未失效结构%4</translation>
    </message>
    <message>
        <source>counted</source>
        <translation>计入</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>不计入</translation>
    </message>
    <message>
        <source>local coordinates in metres</source>
        <translation>以米为单位的局部坐标</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>未比较</translation>
    </message>
    <message>
        <source>area of interest</source>
        <translation>关注区域</translation>
    </message>
</context>
<context>
    <name>rubble::figures::ValidationRows</name>
    <message>
        <source>run-out</source>
        <translation>散落距离</translation>
    </message>
    <message>
        <source>fall</source>
        <translation>下落高度</translation>
    </message>
    <message>
        <source>net rotation</source>
        <translation>净转角</translation>
    </message>
    <message>
        <source>right face up</source>
        <translation>朝上的面正确</translation>
    </message>
    <message>
        <source>centroid of the deposit is off by</source>
        <translation>堆积物质心偏离</translation>
    </message>
    <message>
        <source>solid fraction</source>
        <translation>固体分数</translation>
    </message>
    <message>
        <source>bulking</source>
        <translation>松散系数</translation>
    </message>
    <message>
        <source>angle at which it gives way</source>
        <translation>失稳的角度</translation>
    </message>
    <message>
        <source>the same by limit analysis</source>
        <translation>按极限分析的同一值</translation>
    </message>
    <message>
        <source>least thickness over radius</source>
        <translation>最小厚度与半径之比</translation>
    </message>
    <message>
        <source>over limit analysis</source>
        <translation>与极限分析之比</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1（%2 至 %3）</translation>
    </message>
    <message>
        <source>%1: holds</source>
        <translation>%1：满足</translation>
    </message>
    <message>
        <source>%1: &lt;b&gt;does not hold&lt;/b&gt;</source>
        <translation>%1：&lt;b&gt;不满足&lt;/b&gt;</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>%1: %2 falls simulated, of which %3 still moved at the end, %4 left the terrain and %5 were lost</source>
        <translation>%1：模拟 %2 次下落，其中 %3 次结束时仍在运动，%4 次离开地形，%5 次丢失</translation>
    </message>
    <message>
        <source>In the terms of ASME V&amp;amp;V 20 D is what was measured, S what was simulated and E = S − D the comparison error of the means. Its interval holds it in 95 of 100 resamplings of bodies and repeats. The area between the cumulative curves says how far one would have to be moved to become the other, in brackets what chance alone makes of it. Falls that were not at rest, left the terrain or were lost are in no mean. Nothing is fitted unless the source of a value says so.</source>
        <translation>按 ASME V&amp;amp;V 20 的术语，D 为实测，S 为模拟，E = S − D 为平均值的比较误差。其区间在物体和重复的 100 次重抽样中有 95 次包含它。累积曲线之间的面积说明一条需移动多远才成为另一条，括号内为仅由偶然所致。未静止、离开地形或丢失的下落不计入任何平均值。除非某值的来源这样说明，否则没有拟合。</translation>
    </message>
    <message>
        <source>error of rotation</source>
        <translation>转角误差</translation>
    </message>
    <message>
        <source>error of place</source>
        <translation>位置误差</translation>
    </message>
    <message>
        <source>%1, median</source>
        <translation>%1，中位数</translation>
    </message>
    <message>
        <source>%1, 90 %</source>
        <translation>%1，90 %</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>set, variant</comment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>度</translation>
    </message>
    <message>
        <source>error</source>
        <comment>of a mean</comment>
        <translation>误差</translation>
    </message>
    <message>
        <source>ratio of the scatters</source>
        <translation>离散之比</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>模拟值</translation>
    </message>
    <message>
        <source>median</source>
        <translation>中位数</translation>
    </message>
    <message>
        <source>exponent of the run-out</source>
        <translation>散落距离的指数</translation>
    </message>
    <message>
        <source>factor of the run-out</source>
        <translation>散落距离的系数</translation>
    </message>
    <message>
        <source>run-out over the law</source>
        <translation>散落距离与定律之比</translation>
    </message>
    <message>
        <source>height over the law</source>
        <translation>高度与定律之比</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>至多 %1</translation>
    </message>
    <message>
        <source>below %1 (%2)</source>
        <translation>小于 %1（%2）</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <comment>two bounds</comment>
        <translation>%1 且%2</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>what, asked</comment>
        <translation>%1%2</translation>
    </message>
</context>
<context>
    <name>rubble::widgets</name>
    <message>
        <source>reference</source>
        <translation>基准</translation>
    </message>
    <message>
        <source>repeat floor</source>
        <translation>重复性下限</translation>
    </message>
    <message>
        <source>as published</source>
        <translation>论文设置</translation>
    </message>
    <message>
        <source>ms per step</source>
        <translation>每步毫秒</translation>
    </message>
    <message>
        <source>wall time</source>
        <translation>实际耗时</translation>
    </message>
    <message>
        <source>live FPS</source>
        <translation>实时 FPS</translation>
    </message>
    <message>
        <source>cost: milliseconds per step, mean</source>
        <translation>代价：每步平均毫秒数</translation>
    </message>
    <message>
        <source>cost: wall time of the run, s</source>
        <translation>代价：计算的实际耗时，s</translation>
    </message>
    <message>
        <source>live frames per second, mean</source>
        <translation>实时每秒帧数，平均</translation>
    </message>
    <message>
        <source>within %1 m</source>
        <translation>%1 m 以内</translation>
    </message>
    <message>
        <source>fragments within %1 m of their place in the reference, %</source>
        <translation>距基准位置 %1 m 以内的碎块，%</translation>
    </message>
    <message>
        <source>Share of the fragments that lie within %1 m of where the reference has them</source>
        <translation>位于基准位置 %1 m 以内的碎块所占比例</translation>
    </message>
    <message>
        <source> FPS</source>
        <translation> FPS</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>%1 bodies</source>
        <translation>%1 个刚体</translation>
    </message>
    <message>
        <source>not simulated: %1</source>
        <translation>未模拟：%1</translation>
    </message>
    <message>
        <source>not done yet</source>
        <translation>尚未完成</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source> (no more than the floor)</source>
        <translation> （不超过重复性下限）</translation>
    </message>
    <message>
        <source>limits of health passed: %1</source>
        <translation>超过健康限值：%1</translation>
    </message>
    <message>
        <source>other programs took %1 of the processors while it was timed</source>
        <translation>计时期间其他程序占用了处理器的 %1</translation>
    </message>
    <message>
        <source>physics alone</source>
        <translation>仅物理计算</translation>
    </message>
    <message>
        <source>drawing alone</source>
        <translation>仅绘制</translation>
    </message>
    <message>
        <source>both (live)</source>
        <translation>两者（实时）</translation>
    </message>
    <message>
        <source>typical pile</source>
        <translation>典型堆积体</translation>
    </message>
    <message>
        <source>worst pile</source>
        <translation>最差堆积体</translation>
    </message>
    <message>
        <source>over %1</source>
        <translation>超过 %1</translation>
    </message>
    <message>
        <source>under %1</source>
        <translation>低于 %1</translation>
    </message>
    <message>
        <source>as published, on a GTX 480</source>
        <translation>论文数据，GTX 480</translation>
    </message>
    <message>
        <source>%1
%2 bodies
%3 FPS</source>
        <translation>%1
%2 个刚体
%3 FPS</translation>
    </message>
    <message>
        <source>the smallest component</source>
        <translation>最小构件</translation>
    </message>
    <message>
        <source>Every fragment moves alone (One body per fragment): there is no grid.</source>
        <translation>每个碎块单独运动（每个碎块一个刚体）：没有网格。</translation>
    </message>
    <message>
        <source>All three sizes are set by hand: the multiple decides nothing.</source>
        <translation>三个尺寸均为手动设置：倍数不起作用。</translation>
    </message>
    <message>
        <source>Set by hand along %1: the multiple decides the rest.</source>
        <translation>沿 %1 为手动设置：其余由倍数决定。</translation>
    </message>
    <message>
        <source>The search stopped at the smallest multiple that keeps to the bodies allowed.</source>
        <translation>搜索停在不超过允许刚体数的最小倍数处。</translation>
    </message>
    <message>
        <source>%1 FPS is out of reach within the bounds of the sizes: about %2 FPS is. The run goes on at the upper bounds.</source>
        <translation>在尺寸范围内无法达到 %1 FPS：约可达 %2 FPS。计算按上限继续。</translation>
    </message>
    <message>
        <source>Set by hand.</source>
        <translation>手动设置。</translation>
    </message>
    <message>
        <source>mass map</source>
        <translation>质量图</translation>
    </message>
    <message>
        <source>difference of the mass map</source>
        <translation>质量图差异</translation>
    </message>
    <message>
        <source>Share of the mass that lies in other cells of 2 m than in the reference: 0 is the same</source>
        <translation>与基准相比，落在不同 2 m 单元格中的质量所占比例：0 表示完全相同</translation>
    </message>
    <message>
        <source>core overlap</source>
        <translation>核心区重合度</translation>
    </message>
    <message>
        <source>core overlap with the reference (IoU)</source>
        <translation>与基准的核心区重合度（IoU）</translation>
    </message>
    <message>
        <source>Cells in both cores, which hold 95 % of the mass, over cells in either: 1 is the same</source>
        <translation>同属两者核心区（含 95 % 质量）的单元格数与任一核心区单元格数之比：1 表示完全相同</translation>
    </message>
    <message>
        <source>footprint overlap</source>
        <translation>覆盖范围重合度</translation>
    </message>
    <message>
        <source>footprint overlap with the reference (IoU)</source>
        <translation>与基准的覆盖范围重合度（IoU）</translation>
    </message>
    <message>
        <source>Cells of 1 m in both footprints over cells in either: 1 is the same</source>
        <translation>同属两者覆盖范围的 1 m 单元格数与任一覆盖范围单元格数之比：1 表示完全相同</translation>
    </message>
    <message>
        <source>run-out</source>
        <translation>散落距离</translation>
    </message>
    <message>
        <source>error of the 95 % run-out, m</source>
        <translation>95 % 散落距离误差，m</translation>
    </message>
    <message>
        <source>How far the distance within which 95 % of the mass lies differs from the reference</source>
        <translation>包含 95 % 质量的距离与基准相差多少</translation>
    </message>
    <message>
        <source>height map</source>
        <translation>高度图</translation>
    </message>
    <message>
        <source>height map, root mean square error, m</source>
        <translation>高度图均方根误差，m</translation>
    </message>
    <message>
        <source>Root of the mean square difference of the heights of the pile over both footprints</source>
        <translation>在两者覆盖范围内，堆积高度之差的均方根</translation>
    </message>
    <message>
        <source>mean height</source>
        <translation>平均高度</translation>
    </message>
    <message>
        <source>error of the mean height of the mass, m</source>
        <translation>质量平均高度误差，m</translation>
    </message>
    <message>
        <source>How far the mean height of the mass above ground differs from the reference</source>
        <translation>质量距地面的平均高度与基准相差多少</translation>
    </message>
    <message>
        <source>centroid</source>
        <translation>质心</translation>
    </message>
    <message>
        <source>shift of the centroid, m</source>
        <translation>质心偏移，m</translation>
    </message>
    <message>
        <source>Distance between the centroids of the mass</source>
        <translation>两个质量质心之间的距离</translation>
    </message>
    <message>
        <source>fragment error</source>
        <translation>碎块误差</translation>
    </message>
    <message>
        <source>median error of the fragments, m</source>
        <translation>碎块误差中位数，m</translation>
    </message>
    <message>
        <source>Median over the fragments of the distance from their place in the reference</source>
        <translation>各碎块到其基准位置的距离的中位数</translation>
    </message>
    <message>
        <source>%1: smaller than the largest fragment, %2, which then joins no group of its width.</source>
        <translation>%1：小于最大碎块 %2，该碎块因而不加入任何同宽的组。</translation>
    </message>
    <message>
        <source>%1: larger than the smallest component (%2, %3); clusters are split between components all the same.</source>
        <translation>%1：大于最小构件（%2，%3）；聚类仍会在构件之间分开。</translation>
    </message>
    <message>
        <source>%1: the largest fragment (%2) exceeds the smallest component (%3, %4). Clusters stay within one component all the same.</source>
        <translation>%1：最大碎块（%2）超过最小构件（%3，%4）。聚类仍保持在一个构件之内。</translation>
    </message>
    <message>
        <source>%1: held at the largest fragment, %2.</source>
        <translation>%1：取为最大碎块 %2。</translation>
    </message>
    <message>
        <source>%1: held at the smallest component (%2, %3).</source>
        <translation>%1：取为最小构件（%2，%3）。</translation>
    </message>
    <message>
        <source>%1: the mean distance (%2) exceeds the smallest component (%3, %4).</source>
        <translation>%1：平均间距（%2）超过最小构件（%3，%4）。</translation>
    </message>
    <message>
        <source>bodies</source>
        <translation>刚体</translation>
    </message>
    <message>
        <source>cost: bodies that the engine moves</source>
        <translation>代价：引擎移动的刚体数</translation>
    </message>
    <message>
        <source>, %1 to %2 over %3 runs</source>
        <translation>，%3 次计算中为 %1 至 %2</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::AccuracyChart</name>
    <message>
        <source>Cost against accuracy</source>
        <translation>代价与精度</translation>
    </message>
    <message>
        <source>%1 points. Left and Right go from point to point, Enter uses the setting.</source>
        <translation>%1 个点。左右键在点之间移动，回车键采用该设置。</translation>
    </message>
    <message>
        <source>Click to use this setting.</source>
        <translation>单击采用此设置。</translation>
    </message>
    <message>
        <source>No setting has both figures yet. Points appear here as they are done.</source>
        <translation>尚无同时具有两项数值的设置。各点完成后将显示在此。</translation>
    </message>
    <message>
        <source>What accuracy costs</source>
        <translation>精度的代价</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::AccuracyPage</name>
    <message>
        <source>Save table…</source>
        <translation>保存表格…</translation>
    </message>
    <message>
        <source>Save chart…</source>
        <translation>保存图表…</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>精度</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>代价</translation>
    </message>
    <message>
        <source>Milliseconds per step, mean from the first to the last birth</source>
        <translation>每步毫秒数，从首次到末次产生的平均值</translation>
    </message>
    <message>
        <source>Wall time of the simulation from start to end, seconds</source>
        <translation>模拟从开始到结束的实际耗时，秒</translation>
    </message>
    <message>
        <source>Frames per second of live mode: the more the better</source>
        <translation>实时模式的每秒帧数：越高越好</translation>
    </message>
    <message>
        <source>Cost: %1</source>
        <translation>代价：%1</translation>
    </message>
    <message>
        <source>Settings compared</source>
        <translation>设置比较完成</translation>
    </message>
    <message>
        <source>Save the chart as SVG or PNG</source>
        <translation>将图表保存为 SVG 或 PNG</translation>
    </message>
    <message>
        <source>%1 of %2 done, repeats of the reference: %3</source>
        <translation>%2 项中已完成 %1 项，基准重复 %3 次</translation>
    </message>
    <message>
        <source>Nothing has been compared yet.</source>
        <translation>尚未进行比较。</translation>
    </message>
    <message>
        <source>Choose settings at the left and press Compare: each is simulated, measured against the reference, in which every fragment is its own body, and then timed alone.</source>
        <translation>在左侧选择设置并按“比较”：每项设置都会被模拟，与每个碎块各为一个刚体的基准对比，然后单独计时。</translation>
    </message>
    <message>
        <source>The case has changed since these settings were compared.</source>
        <translation>比较这些设置后案例已更改。</translation>
    </message>
    <message>
        <source>Points are shown as they were and cannot be used. Compare again to bring them up to date.</source>
        <translation>各点按当时结果显示，不能采用。请重新比较以更新。</translation>
    </message>
    <message>
        <source>further right</source>
        <translation>越靠右</translation>
    </message>
    <message>
        <source>further left</source>
        <translation>越靠左</translation>
    </message>
    <message>
        <source>Each point is one setting, run on this machine. Click a point to use it. %1 and %2 is better; differences inside the band mean nothing.</source>
        <translation>每个点是在本机运行的一项设置。单击某点即可采用。%1、%2越好；带内的差异没有意义。</translation>
    </message>
    <message>
        <source>Higher</source>
        <translation>越靠上</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>越靠下</translation>
    </message>
    <message>
        <source>Settings without both figures yet: %1.</source>
        <translation>尚缺两项数值的设置：%1。</translation>
    </message>
    <message>
        <source>Settings without both figures: %1, see the table.</source>
        <translation>没有两项数值的设置：%1，见表格。</translation>
    </message>
    <message>
        <source>Where %1 FPS lie is not known: no two points enclose it.</source>
        <translation>%1 FPS 的位置未知：没有两点将其包围。</translation>
    </message>
    <message>
        <source>The current setting is none of the points.</source>
        <translation>当前设置不在这些点之中。</translation>
    </message>
    <message>
        <source>Clusters: each is moved by one rigid body. Known without a measurement of time</source>
        <translation>聚类：每个由一个刚体移动。无需计时即可得知</translation>
    </message>
    <message>
        <source>Each point is one setting. Click a point to use it. %1 and %2 is better; differences inside the band mean nothing.</source>
        <translation>每个点是一项设置。单击某点即可采用。%1、%2越好；带内的差异没有意义。</translation>
    </message>
    <message>
        <source>No time was measured on this machine: bodies stand for the cost.</source>
        <translation>本机没有计时数据：以刚体数表示代价。</translation>
    </message>
    <message>
        <source>What agreement with the reference costs</source>
        <translation>与基准的一致性需付出的代价</translation>
    </message>
    <message>
        <source>Save all settings that are done as CSV, with the columns of rubble-cli accuracy</source>
        <translation>将所有已完成的设置保存为 CSV，列与 rubble-cli accuracy 相同</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::AccuracyPanel</name>
    <message>
        <source>Accuracy</source>
        <translation>精度</translation>
    </message>
    <message>
        <source>Measure live FPS</source>
        <translation>测量实时 FPS</translation>
    </message>
    <message>
        <source>Measure times again</source>
        <translation>重新测量时间</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Simulate the reference, its repeats and every setting, measure them, and time each alone. What was simulated before is not simulated again</source>
        <translation>模拟基准、其重复计算和每项设置，进行测量并分别单独计时。已模拟过的不再重复模拟</translation>
    </message>
    <message>
        <source>Progress of the comparison</source>
        <translation>比较进度</translation>
    </message>
    <message>
        <source>Open a result first.</source>
        <translation>请先打开结果。</translation>
    </message>
    <message>
        <source>Settings to compare</source>
        <translation>要比较的设置</translation>
    </message>
    <message>
        <source>Multiples of the mean distance</source>
        <translation>平均间距的倍数</translation>
    </message>
    <message>
        <source>Sizes of the Basic Grid, as multiples of the mean distance of adjacent fragments (no unit), separated by commas; auto is the size that the program finds. Empty: the grid as set</source>
        <translation>基本网格尺寸，为相邻碎块平均间距的倍数（无单位），以逗号分隔；auto 为程序求得的尺寸。留空：按当前网格</translation>
    </message>
    <message>
        <source>Other parameters to vary</source>
        <translation>要变化的其他参数</translation>
    </message>
    <message>
        <source>Values of other parameters in every combination, such as cluster_shape=oriented_box,hull; several parameters are separated by semicolons. The manual lists all parameters</source>
        <translation>其他参数的取值，组合全部取值，例如 cluster_shape=oriented_box,hull；多个参数以分号分隔。手册列出了所有参数</translation>
    </message>
    <message>
        <source>Repeats of the reference</source>
        <translation>基准重复次数</translation>
    </message>
    <message>
        <source>How often the reference is repeated with births shifted by a micrometre: what its own debris differs by says what a difference means. Each takes as long as the reference</source>
        <translation>将产生位置移动一微米后重复计算基准的次数：其自身堆积物的差异说明多大的差异才有意义。每次与基准耗时相同</translation>
    </message>
    <message>
        <source>Tolerances, m</source>
        <translation>容差，m</translation>
    </message>
    <message>
        <source>Accuracy rates count the fragments within these distances of their place in the reference, and the view coloured by error changes colour there. Metres, separated by commas. Another comparison takes them up without simulating anew</source>
        <translation>精度率统计位于基准位置这些距离以内的碎块，按误差着色的视图也在此变色。单位米，以逗号分隔。再次比较时采用，无需重新模拟</translation>
    </message>
    <message>
        <source>Draw each setting once off screen, as live mode would, and count frames per second</source>
        <translation>每项设置像实时模式那样在屏幕外绘制一次，并统计每秒帧数</translation>
    </message>
    <message>
        <source>Times and live FPS that are kept do not count: for a machine that is quiet now</source>
        <translation>不使用已保留的时间和实时 FPS：适用于现在空闲的机器</translation>
    </message>
    <message>
        <source>The settings of the published method are compared too. A body for every fragment, the reference, is the slowest of all: it can take many times as long as the run itself.</source>
        <translation>同时比较论文方法的设置。每个碎块一个刚体的基准最慢：耗时可能是计算本身的许多倍。</translation>
    </message>
    <message>
        <source>This machine</source>
        <translation>本机</translation>
    </message>
    <message>
        <source>Calibrate this machine…</source>
        <translation>标定本机…</translation>
    </message>
    <message>
        <source>Measure how many bodies this machine carries, and see the curve</source>
        <translation>测量本机能承载多少刚体，并查看曲线</translation>
    </message>
    <message>
        <source>Tells how many bodies a frame rate allows, and lets time and FPS be predicted of a collapse that was not compared yet.</source>
        <translation>说明某帧率允许多少刚体，并可预测尚未比较过的倒塌的时间和 FPS。</translation>
    </message>
    <message>
        <source>One to %1 distances from %2 to %3 m, separated by commas, please. In force: %4.</source>
        <translation>请输入 1 至 %1 个从 %2 到 %3 m 的距离，以逗号分隔。当前有效：%4。</translation>
    </message>
    <message>
        <source>What is done is kept in %1, so that a second start goes on from there.</source>
        <translation>已完成的内容保留在 %1 中，再次启动可从该处继续。</translation>
    </message>
    <message>
        <source>Stop comparing, on a cluster after a question; what is done is kept, and comparing again goes on</source>
        <translation>停止比较，在集群上会先询问；已完成的保留，再次比较时继续</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Repeats of every setting</source>
        <translation>每项设置的重复次数</translation>
    </message>
    <message>
        <source>How often every setting is repeated with births shifted by a micrometre: the chart shows as a line through its point how far its own accuracy scatters, so that two settings are not told apart by chance. Each takes as long as the setting</source>
        <translation>每项设置以移动一微米的产生位置重复多少次：图中以穿过其点的竖线表示其自身精度的离散，以免把出于偶然的差别当作两项设置的差别。每次重复耗时与该设置相同</translation>
    </message>
    <message>
        <source>Agreement with the reference (verification, no validation), what it costs in time, and which differences mean something.</source>
        <translation>与基准的一致性（核实，不是验证）、它以多少时间为代价，以及哪些差别有意义。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::AccuracyPlot</name>
    <message>
        <source>%1 FPS on this machine</source>
        <translation>本机 %1 FPS</translation>
    </message>
    <message>
        <source>repeat floor of the reference</source>
        <translation>基准的重复性下限</translation>
    </message>
    <message>
        <source>%1 (in use)</source>
        <translation>%1（正在使用）</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>使用中</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::AccuracyTable</name>
    <message>
        <source>Settings compared</source>
        <translation>设置比较完成</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>What departs from the settings of the case</source>
        <translation>与案例设置的不同之处</translation>
    </message>
    <message>
        <source>bodies</source>
        <translation>刚体</translation>
    </message>
    <message>
        <source>Clusters: each is moved by one rigid body</source>
        <translation>聚类：每个由一个刚体带动</translation>
    </message>
    <message>
        <source>ms a step</source>
        <translation>每步 ms</translation>
    </message>
    <message>
        <source>Milliseconds per step, mean from the first to the last birth, with nothing beside it</source>
        <translation>每步毫秒数，从首次到末次产生的平均值，期间无其他工作</translation>
    </message>
    <message>
        <source>wall, s</source>
        <translation>耗时，s</translation>
    </message>
    <message>
        <source>Wall time of the simulation from start to end, seconds</source>
        <translation>模拟从开始到结束的实际耗时，秒</translation>
    </message>
    <message>
        <source>live FPS</source>
        <translation>实时 FPS</translation>
    </message>
    <message>
        <source>Frames per second of live mode, mean from the first to the last birth</source>
        <translation>实时模式的每秒帧数，从首次到末次产生的平均值</translation>
    </message>
    <message>
        <source>, %</source>
        <translation>，%</translation>
    </message>
    <message>
        <source>, m</source>
        <translation>，m</translation>
    </message>
    <message>
        <source>● %1 (in use)</source>
        <translation>● %1（正在使用）</translation>
    </message>
    <message>
        <source>: failed</source>
        <translation>：失败</translation>
    </message>
    <message>
        <source>: not done</source>
        <translation>：未完成</translation>
    </message>
    <message>
        <source>No more than the repeat floor of the reference: says nothing</source>
        <translation>不超过基准的重复性下限：不说明任何问题</translation>
    </message>
    <message>
        <source>How far the reference departs from its own repeats, births shifted by a micrometre: the worst of all pairs, repeats: %1</source>
        <translation>基准与自身重复计算（产生位置移动一微米）相差多少：所有配对中的最差值，重复次数：%1</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::BookmarkEditor</name>
    <message>
        <source>Bookmark</source>
        <translation>书签</translation>
    </message>
    <message>
        <source>Note: what is to be seen here</source>
        <translation>备注：此处可见什么</translation>
    </message>
    <message>
        <source>Note of the bookmark</source>
        <translation>书签备注</translation>
    </message>
    <message>
        <source>What is to be seen at this instant; saved with the case</source>
        <translation>此时刻可见什么；随案例保存</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Remove this bookmark; can be undone</source>
        <translation>删除此书签；可撤销</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Keep the bookmark with this note (Enter)</source>
        <translation>以此备注保留书签（回车）</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::BundleAddendaPage</name>
    <message>
        <source>Addenda</source>
        <translation>附录</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>SHA-256 of the entry</source>
        <translation>条目的 SHA-256</translation>
    </message>
    <message>
        <source>Open its case…</source>
        <translation>打开其案例…</translation>
    </message>
    <message>
        <source>Differences of the open case</source>
        <translation>当前案例的差异</translation>
    </message>
    <message>
        <source>What the open case assumes otherwise</source>
        <translation>当前案例的不同假设</translation>
    </message>
    <message>
        <source>List the differences</source>
        <translation>列出差异</translation>
    </message>
    <message>
        <source>Sign and add</source>
        <translation>签名并加入</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>制作者</translation>
    </message>
    <message>
        <source>Who assumes otherwise</source>
        <translation>提出不同假设的人</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Why it is assumed otherwise</source>
        <translation>为何作不同假设</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1. %2: %3</source>
        <translation>%1. %2：%3</translation>
    </message>
    <message>
        <source>To make an addendum, open the case of the bundle, change what you assume otherwise, and save it under another name.</source>
        <translation>要制作附录，请打开封存包的案例，更改您的不同假设，并以其他名称保存。</translation>
    </message>
    <message>
        <source>An addendum can be made of the case that is open: %1</source>
        <translation>可由当前打开的案例制作附录：%1</translation>
    </message>
    <message>
        <source>goes along: the run %1</source>
        <translation>一同加入：计算 %1</translation>
    </message>
    <message>
        <source>nothing: the open case says the same as the sealed one</source>
        <translation>无：当前案例与封存的案例相同</translation>
    </message>
    <message>
        <source>List the differences first, and say who signs with which key.</source>
        <translation>请先列出差异，并写明由谁用哪个密钥签名。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::BundleCustodyPage</name>
    <message>
        <source>Chain of custody</source>
        <translation>保管链</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Received by</source>
        <translation>接收者</translation>
    </message>
    <message>
        <source>From</source>
        <translation>来自</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>地点</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>缘由</translation>
    </message>
    <message>
        <source>Signed</source>
        <translation>已签名</translation>
    </message>
    <message>
        <source>SHA-256 of the bundle then</source>
        <translation>当时封存包的 SHA-256</translation>
    </message>
    <message>
        <source>SHA-256 of the entry</source>
        <translation>条目的 SHA-256</translation>
    </message>
    <message>
        <source>Add the entry</source>
        <translation>加入条目</translation>
    </message>
    <message>
        <source>An entry holds the SHA-256 of the bundle as it was received and that of the entry before. Note the SHA-256 of yours: it shows later that it was not left out.</source>
        <translation>条目含接收时封存包的 SHA-256 和前一条目的 SHA-256。请记下您的条目的 SHA-256：日后可证明它没有被去掉。</translation>
    </message>
    <message>
        <source>Who received the bundle, now</source>
        <translation>现在接收封存包的人</translation>
    </message>
    <message>
        <source>Who handed it over</source>
        <translation>移交者</translation>
    </message>
    <message>
        <source>Where, and on what medium</source>
        <translation>地点及所用介质</translation>
    </message>
    <message>
        <source>For what purpose, on whose authority</source>
        <translation>目的及授权者</translation>
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
        <source>Say who received a sound bundle, and from whom.</source>
        <translation>请写明完好的封存包由谁接收、从何人处接收。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::BundleDialog</name>
    <message>
        <source>Checked</source>
        <translation>核验项</translation>
    </message>
    <message>
        <source>Sealed bundle</source>
        <translation>封存包</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>核验</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>计算</translation>
    </message>
    <message>
        <source>Trust</source>
        <translation>信任</translation>
    </message>
    <message>
        <source>Custody</source>
        <translation>保管</translation>
    </message>
    <message>
        <source>Addenda</source>
        <translation>附录</translation>
    </message>
    <message>
        <source>Time stamp</source>
        <translation>时间戳</translation>
    </message>
    <message>
        <source>How far the work on the bundle is</source>
        <translation>封存包工作的进度</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Save the list…</source>
        <translation>保存列表…</translation>
    </message>
    <message>
        <source>Open the case…</source>
        <translation>打开案例…</translation>
    </message>
    <message>
        <source>Unpacks the bundle into an empty folder and opens the case to be read only; changes are saved under another name</source>
        <translation>将封存包解到空文件夹，并以只读方式打开案例；更改以其他名称保存</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>%1. %2: addendum of %3</source>
        <translation>%1. %2：%3 的附录</translation>
    </message>
    <message>
        <source>%1. %2: %3 received it from %4</source>
        <translation>%1. %2：%3 从 %4 处接收</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::BundleRunsPage</name>
    <message>
        <source>Run</source>
        <translation>计算</translation>
    </message>
    <message>
        <source>These inputs did not travel. Say where they lie; each must have the digest that was sealed.</source>
        <translation>这些输入没有随包。请指明其位置；每个都必须与封存的摘要一致。</translation>
    </message>
    <message>
        <source>Inputs that did not travel</source>
        <translation>没有随包的输入</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>Was called</source>
        <translation>原名</translation>
    </message>
    <message>
        <source>Lies here</source>
        <translation>现在位置</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>Run again</source>
        <translation>重新计算</translation>
    </message>
    <message>
        <source>Point at the file…</source>
        <translation>指明文件…</translation>
    </message>
    <message>
        <source>The bundle is not as it was sealed: nothing of it is simulated.</source>
        <translation>封存包与封存时不一致：不进行任何计算。</translation>
    </message>
    <message>
        <source>Each run is simulated again with the sealed settings and compared bit by bit. Only the same build repeats a run so.</source>
        <translation>每个计算按封存的设置重新进行，并逐位比较。只有同一构建才能如此重复。</translation>
    </message>
    <message>
        <source>Where is the input %1?</source>
        <translation>输入 %1 在哪里？</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::BundleStampPage</name>
    <message>
        <source>Write the request…</source>
        <translation>写出请求…</translation>
    </message>
    <message>
        <source>Put the answer in…</source>
        <translation>放入应答…</translation>
    </message>
    <message>
        <source>1. Write the request (*.tsq).
2. Send it to a time-stamping service (RFC 3161) by the program that the service names; Rubble uses no network.
3. Put its answer (*.tsr) in. It must be of this bundle. With the roots of the service under Trust it is verified offline.</source>
        <translation>1. 写出请求 (*.tsq)。
2. 用服务机构指定的程序把它发给时间戳服务（RFC 3161）；Rubble 不使用网络。
3. 放入其应答 (*.tsr)。应答必须属于此封存包。在“信任”中给出服务机构的根证书后，可离线核验。</translation>
    </message>
    <message>
        <source>Request for a time stamp</source>
        <translation>时间戳的请求</translation>
    </message>
    <message>
        <source>Requests (*.tsq)</source>
        <translation>请求 (*.tsq)</translation>
    </message>
    <message>
        <source>Answer of the service</source>
        <translation>服务机构的应答</translation>
    </message>
    <message>
        <source>Answers (*.tsr);;All files (*)</source>
        <translation>应答 (*.tsr);;所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::BundleTable</name>
    <message>
        <source>Verdict</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>What it means</source>
        <translation>含义</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::BundleTrustPage</name>
    <message>
        <source>Signer</source>
        <translation>签名者</translation>
    </message>
    <message>
        <source>Roots for signers</source>
        <translation>签名者的根证书</translation>
    </message>
    <message>
        <source>Roots for the time stamp</source>
        <translation>时间戳的根证书</translation>
    </message>
    <message>
        <source>What is in a bundle can prove only what you compare with something that you got another way. All files are PEM; nothing is looked up in a network.</source>
        <translation>封存包中的内容，只有与您经其他途径得到的内容比较，才能证明什么。文件均为 PEM 格式；不在网络中查找任何内容。</translation>
    </message>
    <message>
        <source>Public key or certificate that must have signed, or the SHA-256 of that key</source>
        <translation>必须由其签名的公钥或证书，或该密钥的 SHA-256</translation>
    </message>
    <message>
        <source>Certificates that vouch for that of the signer</source>
        <translation>为签名者的证书作保的证书</translation>
    </message>
    <message>
        <source>Certificates that vouch for the time-stamping service</source>
        <translation>为时间戳服务机构作保的证书</translation>
    </message>
    <message>
        <source>Known digest</source>
        <translation>已知摘要</translation>
    </message>
    <message>
        <source>SHA-256 of the statement or of an entry that the bundle must hold</source>
        <translation>封存包必须含有的声明或条目的 SHA-256</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>重新核验</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::CalibrationChart</name>
    <message>
        <source>Frames per second against the number of bodies</source>
        <translation>每秒帧数与刚体数的关系</translation>
    </message>
    <message>
        <source>%1 points. Left and Right go from point to point.</source>
        <translation>%1 个点。左右键在点之间移动。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::CalibrationPlot</name>
    <message>
        <source>bodies in the scene</source>
        <translation>场景中的刚体数</translation>
    </message>
    <message>
        <source>frames per second of wall clock</source>
        <translation>每秒帧数（实际时间）</translation>
    </message>
    <message>
        <source>target: %1 FPS</source>
        <translation>目标：%1 FPS</translation>
    </message>
    <message>
        <source>N max, typical: %1</source>
        <translation>N 上限，典型：%1</translation>
    </message>
    <message>
        <source>N max, worst: %1</source>
        <translation>N 上限，最差：%1</translation>
    </message>
    <message>
        <source>published (GTX 480)</source>
        <translation>论文数据（GTX 480）</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::CalibrationView</name>
    <message>
        <source>Calibrate this machine</source>
        <translation>标定本机</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Save table…</source>
        <translation>保存表格…</translation>
    </message>
    <message>
        <source>Save chart…</source>
        <translation>保存图表…</translation>
    </message>
    <message>
        <source>What this machine carries</source>
        <translation>本机的承载能力</translation>
    </message>
    <message>
        <source>Progress of the calibration</source>
        <translation>标定进度</translation>
    </message>
    <message>
        <source>Simulates and draws piles of several sizes, one after the other; takes some minutes. Let the machine rest meanwhile</source>
        <translation>依次模拟并绘制多种规模的堆积体；需要几分钟。其间请让机器保持空闲</translation>
    </message>
    <message>
        <source>Stop measuring; what was kept before stays</source>
        <translation>停止测量；以前保留的内容不变</translation>
    </message>
    <message>
        <source>The case allows as many bodies as a typical pile may have at the target rate; one step of undo</source>
        <translation>案例允许的刚体数取典型堆积体在目标帧率下的数目；可一步撤销</translation>
    </message>
    <message>
        <source>Save the chart as SVG or PNG</source>
        <translation>将图表保存为 SVG 或 PNG</translation>
    </message>
    <message>
        <source>How many frames per second live mode reaches with so many bodies. Squares are the published points, measured on a GTX 480 in 2012.</source>
        <translation>实时模式在如此多刚体下达到的每秒帧数。方块为论文数据点，2012 年在 GTX 480 上测得。</translation>
    </message>
    <message>
        <source>%1; simulated on %2 threads, drawn by %3. A frame simulates 1/%4 s of the collapse and draws both views. Typical: the mean of a pile that comes to rest. Worst: the worst second of a heap of which nothing ever rests. Both are fragments alone: whole spans that the engine moves (loose_structure) come on top.</source>
        <translation>%1；在 %2 个线程上模拟，由 %3 绘制。每帧模拟倒塌的 1/%4 s 并绘制两个视图。典型：趋于静止的堆积体的平均值。最差：始终不静止的堆积体的最差一秒。两者都只有碎块：由引擎移动的整跨（loose_structure）另计。</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>This machine was not calibrated yet.</source>
        <translation>本机尚未标定。</translation>
    </message>
    <message>
        <source>Until then the bodies allowed are the published 4,500 at 24 FPS, and nothing is predicted of a collapse that was not compared.</source>
        <translation>在此之前允许的刚体数取论文值 24 FPS 下 4,500 个，并且不预测尚未比较过的倒塌。</translation>
    </message>
    <message>
        <source>Calibrate again</source>
        <translation>重新标定</translation>
    </message>
    <message>
        <source>%1: %2 bodies at %3 FPS</source>
        <translation>%1：%3 FPS 下 %2 个刚体</translation>
    </message>
    <message>
        <source>%1: not known, fewer than three points</source>
        <translation>%1：未知，少于三个点</translation>
    </message>
    <message>
        <source>Allow %1 bodies</source>
        <translation>允许 %1 个刚体</translation>
    </message>
    <message>
        <source>Measuring this machine</source>
        <translation>正在测量本机</translation>
    </message>
    <message>
        <source>Save the measured points as CSV, with the columns of rubble-cli calibrate</source>
        <translation>将测得的点保存为 CSV，列与 rubble-cli calibrate 相同</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::CaseCard</name>
    <message>
        <source>%1, missing</source>
        <translation>%1，缺失</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>缺失</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::CasePanel</name>
    <message>
        <source>%1 joined into %2</source>
        <translation>%1 合并为 %2</translation>
    </message>
    <message>
        <source>%1 renamed to %2</source>
        <translation>%1 重命名为 %2</translation>
    </message>
    <message>
        <source>%1 split by a box into %2</source>
        <translation>%1 用盒分割为 %2</translation>
    </message>
    <message>
        <source>%1 split by a plane into %2</source>
        <translation>%1 用平面分割为 %2</translation>
    </message>
    <message>
        <source>%1 split into what hangs together</source>
        <translation>%1 按连通性分割</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>案例</translation>
    </message>
    <message>
        <source>What was computed, and of what the structure is made.</source>
        <translation>计算了什么，结构由什么组成。</translation>
    </message>
    <message>
        <source>Back to the parts of the file</source>
        <translation>恢复文件中的部件</translation>
    </message>
    <message>
        <source>How the file is read</source>
        <translation>文件的读取方式</translation>
    </message>
    <message>
        <source>Assumed where nothing is known</source>
        <translation>未知量的假定</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Open a case or an FE result, or drop one anywhere in the window. The sample is in the Case menu.</source>
        <translation>打开案例或有限元结果，或将其拖放到窗口任意位置。示例在“案例”菜单中。</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>Deactivated</source>
        <translation>失效</translation>
    </message>
    <message>
        <source>Inactive at the last state and active before</source>
        <translation>最后状态未激活而此前激活</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>节点</translation>
    </message>
    <message>
        <source>States</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>What the file was taken to count in; chosen below</source>
        <translation>判定的文件单位；可在下方选择</translation>
    </message>
    <message>
        <source>Active flag</source>
        <translation>激活标志</translation>
    </message>
    <message>
        <source>How the file says which elements are active</source>
        <translation>文件如何说明哪些单元处于激活状态</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>地形</translation>
    </message>
    <message>
        <source>What debris falls on; Terrain… in the Case menu chooses it</source>
        <translation>承接堆积物的表面；由“案例”菜单中的“地形…”选择</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Nodal velocities; else differences of positions at active states</source>
        <translation>节点速度；否则取激活状态下位置之差</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>构件列表</translation>
    </message>
    <message>
        <source>name</source>
        <translation>构件名</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>elem.</source>
        <translation>单元数</translation>
    </message>
    <message>
        <source>dead</source>
        <translation>失效数</translation>
    </message>
    <message>
        <source>kg/m³</source>
        <translation>kg/m³</translation>
    </message>
    <message>
        <source>Density; double-click to change, empty for what the file says</source>
        <translation>密度；双击更改，留空则取文件中的值</translation>
    </message>
    <message>
        <source>level</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>in the file</source>
        <translation>在文件中</translation>
    </message>
    <message>
        <source>from positions</source>
        <translation>由位置计算</translation>
    </message>
    <message>
        <source>own</source>
        <translation>自定义</translation>
    </message>
    <message>
        <source>%1, fits %2</source>
        <translation>%1，相符的是 %2</translation>
    </message>
    <message>
        <source>Taken: %1.
What the file fits: %2.</source>
        <translation>采用：%1。
与文件相符：%2。</translation>
    </message>
    <message>
        <source>The density of %1 stays as it was.</source>
        <translation>%1 的密度保持不变。</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>方案</translation>
    </message>
    <message>
        <source>%1
%2 × %3 heights, %4 apart, %5 to %6</source>
        <translation>%1
%2 × %3 个高程，间距 %4，%5 至 %6</translation>
    </message>
    <message>
        <source>%1: %2, %3 × %4 × %5</source>
        <translation>%1：%2，%3 × %4 × %5</translation>
    </message>
    <message>
        <source>“%1” is not a density from %2 to %3.</source>
        <translation>“%1”不是 %2 至 %3 的密度。</translation>
    </message>
    <message>
        <source>Surroundings</source>
        <translation>周围环境</translation>
    </message>
    <message>
        <source>What is drawn around the structure; Orthophoto… and Surroundings… in the Case menu choose it</source>
        <translation>结构周围所绘内容；由“案例”菜单中的“正射影像…”和“周围环境…”选择</translation>
    </message>
    <message>
        <source>orthophoto</source>
        <translation>正射影像</translation>
    </message>
    <message>
        <source>meshes that debris falls on: %1</source>
        <translation>承接堆积物的网格：%1</translation>
    </message>
    <message>
        <source>meshes: %1</source>
        <translation>网格：%1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::CasePreview</name>
    <message>
        <source>Back one state</source>
        <translation>后退一个状态</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>播放或暂停</translation>
    </message>
    <message>
        <source>Forward one state</source>
        <translation>前进一个状态</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::CauseChart</name>
    <message>
        <source>departure from the evidence, in units of its scatter; less is closer</source>
        <translation>与证据的偏离，以其离散度为单位；越小越接近</translation>
    </message>
    <message>
        <source>closest</source>
        <translation>最接近</translation>
    </message>
    <message>
        <source>told apart</source>
        <translation>可区分</translation>
    </message>
    <message>
        <source>not told apart</source>
        <translation>不可区分</translation>
    </message>
    <message>
        <source>How close each cause comes to the evidence</source>
        <translation>各原因与证据的接近程度</translation>
    </message>
    <message>
        <source>%1: %2, median %3</source>
        <translation>%1：%2，中位数 %3</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::CausesPage</name>
    <message>
        <source>Save table…</source>
        <translation>保存表格…</translation>
    </message>
    <message>
        <source>Save chart…</source>
        <translation>保存图表…</translation>
    </message>
    <message>
        <source>Save map…</source>
        <translation>保存图…</translation>
    </message>
    <message>
        <source>Which cause explains the evidence</source>
        <translation>哪个原因能解释证据</translation>
    </message>
    <message>
        <source>Ranking of the causes</source>
        <translation>原因的排序</translation>
    </message>
    <message>
        <source>Blind test</source>
        <translation>盲测</translation>
    </message>
    <message>
        <source>Save the ranking as CSV, with the columns of rubble-cli compare</source>
        <translation>将排序保存为 CSV，列与 rubble-cli compare 相同</translation>
    </message>
    <message>
        <source>Save the chart as SVG or PNG</source>
        <translation>将图表保存为 SVG 或 PNG</translation>
    </message>
    <message>
        <source>Save the map of what tells the first two causes apart as GeoTIFF, CSV or PNG</source>
        <translation>将区分前两个原因的图保存为 GeoTIFF、CSV 或 PNG</translation>
    </message>
    <message>
        <source>Causes, evidence or settings have changed since.</source>
        <translation>此后原因、证据或设置已改变。</translation>
    </message>
    <message>
        <source>What is shown is as it was. Compare again to bring it up to date.</source>
        <translation>所示为当时的结果。请再次比较以更新。</translation>
    </message>
    <message>
        <source>No causes have been compared yet.</source>
        <translation>尚未比较过原因。</translation>
    </message>
    <message>
        <source>Tick the supposed causes at the left, add what was found on the site, and press Compare causes. Every cause gets an ensemble; those that come closest to what was found come first, or it is said that they cannot be told apart.</source>
        <translation>在左侧勾选假定的原因，加入现场所见，然后按“比较原因”。每个原因都得到一个系综；与现场所见最接近的排在最前，或者说明它们无法区分。</translation>
    </message>
    <message>
        <source>There was no evidence: the blind tests below say what evidence could tell at best.</source>
        <translation>没有证据：下面的盲测说明证据最多能区分到什么程度。</translation>
    </message>
    <message>
        <source>Each dot is one member of an ensemble, held against the evidence that was chosen.</source>
        <translation>每个点是系综的一个成员，与所选证据对照。</translation>
    </message>
    <message>
        <source>%1 tells most: there the closest cause is closer than the next in %2 of the pairs of members.</source>
        <translation>%1 最能区分：在 %2 的成员配对中，最接近的原因比次之的更接近。</translation>
    </message>
    <message>
        <source>On the ground %1 of what speaks for it lies around x = %2, y = %3, on %4 (ringed).</source>
        <translation>在地面上，支持它的内容有 %1 位于 x = %2、y = %3 附近，面积 %4（圈出）。</translation>
    </message>
    <message>
        <source>cause</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>The closest first</source>
        <translation>最接近的在前</translation>
    </message>
    <message>
        <source>members</source>
        <translation>成员数</translation>
    </message>
    <message>
        <source>Members that could be held against the evidence</source>
        <translation>可与证据对照的成员</translation>
    </message>
    <message>
        <source>score</source>
        <translation>得分</translation>
    </message>
    <message>
        <source>Median over the members of the mean departure, in units of its scatter; less is closer</source>
        <translation>成员平均偏离的中位数，以其离散度为单位；越小越接近</translation>
    </message>
    <message>
        <source>5 to 95 %</source>
        <translation>5 至 95 %</translation>
    </message>
    <message>
        <source>All but one member in ten lie in between</source>
        <translation>十个成员中九个位于其间</translation>
    </message>
    <message>
        <source>closest over it</source>
        <translation>最接近者胜出</translation>
    </message>
    <message>
        <source>How often a member of the closest cause is closer than one of this, over all pairs</source>
        <translation>在所有配对中，最接近原因的成员比该原因的成员更接近的比例</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>至少</translation>
    </message>
    <message>
        <source>The lower end of its interval, 95 % for all comparisons together. Above 70 % they are told apart</source>
        <translation>其区间的下端，所有比较合计 95 %。高于 70 % 即可区分</translation>
    </message>
    <message>
        <source>told apart</source>
        <translation>可区分</translation>
    </message>
    <message>
        <source>Whether the evidence tells it from the closest cause</source>
        <translation>证据能否将它与最接近的原因区分</translation>
    </message>
    <message>
        <source>Departure from %1, 0 the same, 1 nothing in common: mean ± standard deviation of the members</source>
        <translation>与 %1 的偏离，0 为相同，1 为毫无共同：成员的平均值 ± 标准差</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>true cause</source>
        <translation>真实原因</translation>
    </message>
    <message>
        <source>The cause that a member of was taken for what was found</source>
        <translation>取其成员作为现场所见的原因</translation>
    </message>
    <message>
        <source>named %1</source>
        <translation>判为 %1</translation>
    </message>
    <message>
        <source>Trials in which this cause was named</source>
        <translation>判为该原因的试验次数</translation>
    </message>
    <message>
        <source>not told apart</source>
        <translation>不可区分</translation>
    </message>
    <message>
        <source>Trials without a verdict</source>
        <translation>无法判定的试验次数</translation>
    </message>
    <message>
        <source>closest rightly</source>
        <translation>最接近者正确</translation>
    </message>
    <message>
        <source>Trials in which the true cause was the closest, told apart or not</source>
        <translation>真实原因最接近的试验次数，无论是否可区分</translation>
    </message>
    <message>
        <source>footprint</source>
        <translation>覆盖范围</translation>
    </message>
    <message>
        <source>heights</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>%1: %2 of %3 named rightly, %4 wrongly</source>
        <translation>%1：%3 次中 %2 次判断正确，%4 次错误</translation>
    </message>
    <message>
        <source>%1, by %2</source>
        <translation>%1，依据%2</translation>
    </message>
    <message>
        <source>Blind test, each member in turn is what was found. %1</source>
        <translation>盲测，依次以每个成员作为现场所见。%1</translation>
    </message>
    <message>
        <source>noticed if left out</source>
        <translation>除去后被察觉</translation>
    </message>
    <message>
        <source>Trials in which, with the true cause not among the hypotheses, perhaps none of them would be the verdict</source>
        <translation>真正的原因不在假设之中时，结论会是可能都不是原因的试验</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Which evidence would tell</source>
        <translation>哪种证据能够说明</translation>
    </message>
    <message>
        <source>Which evidence would tell %1 apart. Each of %2 members in turn is what happened, seen without error.</source>
        <translation>哪种证据能够区分 %1。%2 个成员轮流充当实际所发生的，无误差地观测。</translation>
    </message>
    <message>
        <source>evidence</source>
        <translation>证据</translation>
    </message>
    <message>
        <source>The one that names the cause most often first; the first of many is flattered by chance</source>
        <translation>最常指出原因者在前；许多项中居首者有偶然的成分</translation>
    </message>
    <message>
        <source>named rightly</source>
        <translation>正确指出</translation>
    </message>
    <message>
        <source>Trials in which the true cause is told from the others, with what is at hand</source>
        <translation>连同现有证据，真正的原因能与其余区分的试验</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Interval of that share</source>
        <translation>该份额的区间</translation>
    </message>
    <message>
        <source>named wrongly</source>
        <translation>错误指出</translation>
    </message>
    <message>
        <source>Trials in which another cause is told from the others</source>
        <translation>另一原因被认定的试验</translation>
    </message>
    <message>
        <source>what is at hand</source>
        <translation>现有证据</translation>
    </message>
    <message>
        <source>and %1</source>
        <translation>另加%1</translation>
    </message>
    <message>
        <source>No evidence tells the first two apart: at best the closest cause is closer than the next in %1 of the pairs of members.</source>
        <translation>没有证据能区分前两个原因：最多在 %1 的成员配对中，最接近的原因比下一个更接近。</translation>
    </message>
    <message>
        <source>least to most</source>
        <translation>最小至最大</translation>
    </message>
    <message>
        <source>All members lie in between</source>
        <translation>所有成员都在其间</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::CausesPanel</name>
    <message>
        <source>Which cause?</source>
        <translation>哪个原因？</translation>
    </message>
    <message>
        <source>Which of several supposed causes explains what was found?</source>
        <translation>若干假定原因中哪一个能解释现场所见？</translation>
    </message>
    <message>
        <source>Compare causes</source>
        <translation>比较原因</translation>
    </message>
    <message>
        <source>Add cases…</source>
        <translation>添加案例…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Add evidence</source>
        <translation>添加证据</translation>
    </message>
    <message>
        <source>Blind test as well</source>
        <translation>同时进行盲测</translation>
    </message>
    <message>
        <source>Simulate the ensemble of every cause that is ticked and hold it against the evidence that is ticked. Members that were simulated before are taken from the cache</source>
        <translation>模拟每个所勾选原因的系综，并与所勾选的证据对照。先前模拟过的成员从缓存中取用</translation>
    </message>
    <message>
        <source>Stop; members that are done are kept, and comparing again goes on from there</source>
        <translation>停止；已完成的成员予以保留，再次比较时从此继续</translation>
    </message>
    <message>
        <source>Progress of the comparison of causes</source>
        <translation>原因比较的进度</translation>
    </message>
    <message>
        <source>Supposed causes</source>
        <translation>假定的原因</translation>
    </message>
    <message>
        <source>Causes that are ticked are compared: the scenarios of this case, and other cases and FE results of the same site</source>
        <translation>比较所勾选的原因：本案例的方案，以及同一现场的其他案例和有限元结果</translation>
    </message>
    <message>
        <source>Add cases or FE results of the same site, each computed for another cause</source>
        <translation>添加同一现场、各按不同原因计算的案例或有限元结果</translation>
    </message>
    <message>
        <source>Take the chosen cause off the list; its file stays</source>
        <translation>从列表中移除所选原因；其文件保留</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>现场所见</translation>
    </message>
    <message>
        <source>Footprint, polygons…</source>
        <translation>覆盖范围，多边形…</translation>
    </message>
    <message>
        <source>Heights of the debris above the ground, raster…</source>
        <translation>堆积物高出地面的高度，栅格…</translation>
    </message>
    <message>
        <source>Heights of the surface with the debris, raster…</source>
        <translation>含堆积物的表面高度，栅格…</translation>
    </message>
    <message>
        <source>Take the chosen file off the list; it stays where it is</source>
        <translation>从列表中移除所选文件；文件仍在原处</translation>
    </message>
    <message>
        <source>Let each member in turn be what was observed and say how often its cause is found: how far footprints and heights could tell these causes apart at all. Without evidence this is done anyway</source>
        <translation>依次以每个成员作为观测结果，说明其原因被找到的次数：覆盖范围和高度究竟能在多大程度上区分这些原因。没有证据时总会进行</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>尚无</translation>
    </message>
    <message>
        <source>none: a blind test</source>
        <translation>无：进行盲测</translation>
    </message>
    <message>
        <source>Time at which debris reached a place…</source>
        <translation>堆积物到达某处的时刻…</translation>
    </message>
    <message>
        <source>When debris reached a place</source>
        <translation>堆积物何时到达某处</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>x of the place</source>
        <translation>该处的 x</translation>
    </message>
    <message>
        <source>In the frame of the case</source>
        <translation>在案例的坐标框架中</translation>
    </message>
    <message>
        <source>y of the place</source>
        <translation>该处的 y</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>Around the place</source>
        <translation>该处周围</translation>
    </message>
    <message>
        <source>Give or take</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>How far the time may be off</source>
        <translation>时间可能的偏差</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>After the first debris came down anywhere: by a witness, a video, a gauge</source>
        <translation>自任一处首次落下碎块之后：据目击者、录像或仪器</translation>
    </message>
    <message>
        <source>Evidence that is ticked counts: surveys of this case, its photographs taken at rest with an outline of the debris, and footprints, heights and times that are added</source>
        <translation>所勾选的证据计入：本案例的测量、静止后拍摄并绘有堆积物轮廓的照片，以及加入的覆盖范围、高度和时刻</translation>
    </message>
    <message>
        <source>Add a file of what was found. Photographs and surveys of the case are added under Photographs</source>
        <translation>添加现场所见的文件。案例的照片和测量在“照片列表”中添加</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::ClipBar</name>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>剖切</translation>
    </message>
    <message>
        <source>Cut across</source>
        <translation>剖切方向轴</translation>
    </message>
    <message>
        <source>line of sight</source>
        <translation>视线方向</translation>
    </message>
    <message>
        <source>Direction of the cut</source>
        <translation>剖切方向</translation>
    </message>
    <message>
        <source>The plane stands across this axis, or across the direction in which the views look now</source>
        <translation>平面垂直于此轴，或垂直于视图当前的视线方向</translation>
    </message>
    <message>
        <source>Place of the cut</source>
        <translation>剖切位置</translation>
    </message>
    <message>
        <source>Moves the plane through the model</source>
        <translation>在模型中移动平面</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>另一侧</translation>
    </message>
    <message>
        <source>Keep what was cut away, and cut away what was kept</source>
        <translation>保留已剖去的部分，剖去已保留的部分</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Show the model whole again</source>
        <translation>重新显示完整模型</translation>
    </message>
    <message>
        <source>Place of the cut, typed</source>
        <translation>键入的剖切位置</translation>
    </message>
    <message>
        <source>Where the plane stands; the model reaches from %1 to %2</source>
        <translation>剖切面的位置；模型范围为 %1 至 %2</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::CloudPairDialog</name>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Normal scale</source>
        <translation>法向尺度</translation>
    </message>
    <message>
        <source>Projection scale</source>
        <translation>投影尺度</translation>
    </message>
    <message>
        <source>Depth of the cylinder</source>
        <translation>圆柱的深度</translation>
    </message>
    <message>
        <source>Registration error</source>
        <translation>配准误差</translation>
    </message>
    <message>
        <source>Cells of the volumes</source>
        <translation>体积的单元</translation>
    </message>
    <message>
        <source>Measure distances</source>
        <translation>量取距离</translation>
    </message>
    <message>
        <source>Cancel measuring</source>
        <translation>取消量取</translation>
    </message>
    <message>
        <source>Save distances…</source>
        <translation>保存距离…</translation>
    </message>
    <message>
        <source>Compare two clouds</source>
        <translation>比较两个点云</translation>
    </message>
    <message>
        <source>Measures from the first cloud to the second along the local normal (M3C2), as their files have them: what the case says of their place does not move them. Lengths are brought to metres.</source>
        <translation>沿局部法向（M3C2）从第一个点云量到第二个，位置如其文件所写：案例所说的配准不移动它们。长度换算为米。</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>文件…</translation>
    </message>
    <message>
        <source>Take a cloud that is not in the case</source>
        <translation>采用案例以外的点云</translation>
    </message>
    <message>
        <source>Second cloud</source>
        <translation>第二个点云</translation>
    </message>
    <message>
        <source>First cloud</source>
        <translation>第一个点云</translation>
    </message>
    <message>
        <source>Second, of later</source>
        <translation>第二个，较晚</translation>
    </message>
    <message>
        <source>First, of before</source>
        <translation>第一个，较早</translation>
    </message>
    <message>
        <source>Normal scale, m</source>
        <translation>法向尺度，m</translation>
    </message>
    <message>
        <source>Projection scale, m</source>
        <translation>投影尺度，m</translation>
    </message>
    <message>
        <source>Depth, m</source>
        <translation>深度，m</translation>
    </message>
    <message>
        <source>By which one cloud may be out of place against the other, m</source>
        <translation>一个点云相对另一个可能错开的量，m</translation>
    </message>
    <message>
        <source>Registration error, m</source>
        <translation>配准误差，m</translation>
    </message>
    <message>
        <source>no volumes</source>
        <translation>不求体积</translation>
    </message>
    <message>
        <source>Side of the square cells over which cut, fill and net are summed straight up, m</source>
        <translation>竖直方向累计挖方、填方和净值所用的方形单元的边长，m</translation>
    </message>
    <message>
        <source>Volume cells, m</source>
        <translation>体积单元，m</translation>
    </message>
    <message>
        <source>Choose two clouds.</source>
        <translation>请选择两个点云。</translation>
    </message>
    <message>
        <source>Taken: %1, and %2.</source>
        <translation>拍摄时间：%1 和 %2。</translation>
    </message>
    <message>
        <source>The second is the older one: fill is what was there before.</source>
        <translation>第二个较早：填方是此前在那里的部分。</translation>
    </message>
    <message>
        <source>Distances are being measured.</source>
        <translation>正在量取距离。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::ComponentTree</name>
    <message>
        <source>Solids</source>
        <translation>实体</translation>
    </message>
    <message>
        <source>Shells</source>
        <translation>壳</translation>
    </message>
    <message>
        <source>Beams</source>
        <translation>梁</translation>
    </message>
    <message>
        <source>Mixed</source>
        <translation>混合</translation>
    </message>
    <message>
        <source>The components of a result appear here.</source>
        <translation>结果的构件将显示在此。</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>隔离</translation>
    </message>
    <message>
        <source>Hide all other components</source>
        <translation>隐藏其他所有构件</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>全部显示</translation>
    </message>
    <message>
        <source>Show every component and element again</source>
        <translation>重新显示所有构件和单元</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>Select all elements of the components chosen</source>
        <translation>选择所选构件的全部单元</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>颜色…</translation>
    </message>
    <message>
        <source>Choose the colour of the components chosen; their own again with a second click</source>
        <translation>为所选构件选择颜色；再次单击恢复原色</translation>
    </message>
    <message>
        <source>component</source>
        <translation>构件</translation>
    </message>
    <message>
        <source>alive</source>
        <translation>存活</translation>
    </message>
    <message>
        <source>dead</source>
        <translation>失效数</translation>
    </message>
    <message>
        <source>Elements active in the FE result at the time shown</source>
        <translation>所示时刻在有限元结果中激活的单元</translation>
    </message>
    <message>
        <source>Elements deactivated in the FE result by the time shown</source>
        <translation>到所示时刻在有限元结果中已失效的单元</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>构件列表</translation>
    </message>
    <message>
        <source>Tick what the views show; choose rows to isolate, select or set them</source>
        <translation>勾选视图显示的内容；选择各行可隔离、选择或设置</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation>%1 的颜色</translation>
    </message>
    <message>
        <source>Open a result first</source>
        <translation>请先打开结果</translation>
    </message>
    <message>
        <source>%1 (assumed)</source>
        <translation>%1（假定）</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::ContactTable</name>
    <message>
        <source>All pairs</source>
        <translation>全部材料对</translation>
    </message>
    <message>
        <source>pair</source>
        <translation>材料对</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>摩擦系数 μ</translation>
    </message>
    <message>
        <source>restitution</source>
        <translation>恢复系数 e</translation>
    </message>
    <message>
        <source>source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Coulomb coefficient; an empty cell gives the default back</source>
        <translation>库仑摩擦系数；清空单元格即恢复默认值</translation>
    </message>
    <message>
        <source>Normal restitution of a hit; an empty cell gives the default back</source>
        <translation>撞击的法向恢复系数；清空单元格即恢复默认值</translation>
    </message>
    <message>
        <source>Where the defaults of friction and restitution come from: listed below</source>
        <translation>摩擦和恢复系数默认值的来源：列于下方</translation>
    </message>
    <message>
        <source>Friction and restitution of pairs of materials</source>
        <translation>各材料对的摩擦和恢复系数</translation>
    </message>
    <message>
        <source>Also the pairs of materials that this scene does not have</source>
        <translation>包括此场景中没有的材料对</translation>
    </message>
    <message>
        <source>Open a result first</source>
        <translation>请先打开结果</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 对 %2</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>摩擦</translation>
    </message>
    <message>
        <source>Restitution</source>
        <translation>恢复系数</translation>
    </message>
    <message>
        <source>One %1 is set for all pairs; give it back to automatic to use the table.</source>
        <translation>已为所有材料对统一设置%1；恢复为自动即可使用此表。</translation>
    </message>
    <message>
        <source>Set here. Default %1: Delete or the mark gives it back.</source>
        <translation>已在此设置。默认值 %1：按 Delete 或点击标记可恢复。</translation>
    </message>
    <message>
        <source>set</source>
        <translation>已设</translation>
    </message>
    <message>
        <source>set by you</source>
        <translation>由您设置</translation>
    </message>
    <message>
        <source>“%1” is not a number from %2 to %3; %4 stays.</source>
        <translation>“%1”不是 %2 至 %3 之间的数值；仍为 %4。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::EffectRow</name>
    <message>
        <source>below 0.001 ms</source>
        <translation>小于 0.001 ms</translation>
    </message>
    <message>
        <source>below 1 %</source>
        <translation>小于 1 %</translation>
    </message>
    <message>
        <source>88.88 ms per step</source>
        <translation>每步 88.88 ms</translation>
    </message>
    <message>
        <source>Hide the settings of %1</source>
        <translation>隐藏“%1”的设置</translation>
    </message>
    <message>
        <source>Show the settings of %1</source>
        <translation>显示“%1”的设置</translation>
    </message>
    <message>
        <source>not decided yet</source>
        <translation>尚未判定</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>%1 (before the change)</source>
        <translation>%1（更改之前）</translation>
    </message>
    <message>
        <source>Measured %1, against a threshold of %2</source>
        <translation>测得 %1，阈值 %2</translation>
    </message>
    <message>
        <source>%1 per step</source>
        <translation>每步 %1</translation>
    </message>
    <message>
        <source>Measured in the last run: %1 per step, %2 of the step</source>
        <translation>上次计算中测得：每步 %1，占一步的 %2</translation>
    </message>
    <message>
        <source>Work on bodies: %1</source>
        <translation>对刚体做功：%1</translation>
    </message>
    <message>
        <source>Ties broken: %1</source>
        <translation>断裂的拉结：%1</translation>
    </message>
    <message>
        <source>Clusters broken up: %1</source>
        <translation>破碎的聚类：%1</translation>
    </message>
    <message>
        <source>Settings have changed since.</source>
        <translation>此后设置已更改。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::EffectsPanel</name>
    <message>
        <source>Effects</source>
        <translation>效应</translation>
    </message>
    <message>
        <source>What acts on the fragments, why, and what it costs.</source>
        <translation>什么作用于碎块，原因和代价。</translation>
    </message>
    <message>
        <source>What all effects cost</source>
        <translation>所有效应的代价</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>材料设置</translation>
    </message>
    <message>
        <source>Where materials meet</source>
        <translation>材料接触面</translation>
    </message>
    <message>
        <source>One number for all pairs, in place of the table:</source>
        <translation>所有材料对统一取值，取代下表：</translation>
    </message>
    <message>
        <source>Open a result: which effects its scene calls for appears here, with the reasons, before any run.</source>
        <translation>打开结果：这里将列出该场景所需的效应及原因，无需先计算。</translation>
    </message>
    <message>
        <source>%1 of %2 take part in this scene. One that is off costs nothing.</source>
        <translation>%2 个效应中 %1 个参与此场景；关闭的没有代价。</translation>
    </message>
    <message>
        <source>Settings have changed: decided anew when what runs is through.</source>
        <translation>设置已更改：当前工作完成后重新判定。</translation>
    </message>
    <message>
        <source>What each costs, in ms per step, is measured in a run.</source>
        <translation>各效应的代价（每步毫秒）在计算中测量。</translation>
    </message>
    <message>
        <source>Together &lt;b&gt;%1&lt;/b&gt; per step</source>
        <translation>合计每步 &lt;b&gt;%1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>, &lt;b&gt;%1&lt;/b&gt; of a step of %2; the rest is motion and bookkeeping.</source>
        <translation>，在 %2 的一步中占 &lt;b&gt;%1&lt;/b&gt;；其余为运动与记录。</translation>
    </message>
    <message>
        <source>Measured before the settings changed.</source>
        <translation>在设置更改之前测得。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::EnsemblePage</name>
    <message>
        <source>Save map…</source>
        <translation>保存图…</translation>
    </message>
    <message>
        <source>Save table…</source>
        <translation>保存表格…</translation>
    </message>
    <message>
        <source>Where debris may lie</source>
        <translation>堆积物可能的位置</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Layer of the map</source>
        <translation>图的图层</translation>
    </message>
    <message>
        <source>What the colours of the map say</source>
        <translation>图中颜色的含义</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>铺在地面上</translation>
    </message>
    <message>
        <source>Lay this map on the ground of the views, below the debris</source>
        <translation>把此图铺在视图的地面上，位于堆积物之下</translation>
    </message>
    <message>
        <source>Save the map as GeoTIFF or CSV with all layers, or this layer as PNG</source>
        <translation>将图连同所有图层保存为 GeoTIFF 或 CSV，或将此图层保存为 PNG</translation>
    </message>
    <message>
        <source>Save what every member was given and what came of it, as CSV with the columns of rubble-cli ensemble</source>
        <translation>将每个成员的取值和结果保存为 CSV，列与 rubble-cli ensemble 相同</translation>
    </message>
    <message>
        <source>Spread over the members</source>
        <translation>成员间的离散</translation>
    </message>
    <message>
        <source>No ensemble has been simulated yet.</source>
        <translation>尚未模拟过系综。</translation>
    </message>
    <message>
        <source>State at the left what is not known and press Simulate members: the collapse is simulated again and again, and the map shows how often debris lies where.</source>
        <translation>在左侧说明哪些量未知，然后按“模拟成员”：倒塌被反复模拟，图上显示堆积物在各处出现的频率。</translation>
    </message>
    <message>
        <source>%1 of %2 members done, debris %3, %4, cells of %5.</source>
        <translation>%2 个成员中已完成 %1 个，堆积物%3，%4，单元 %5。</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>静止后</translation>
    </message>
    <message>
        <source>at the end of the FE result</source>
        <translation>有限元结果结束时</translation>
    </message>
    <message>
        <source>fallen structure with it</source>
        <translation>含坠落结构</translation>
    </message>
    <message>
        <source>fallen structure apart</source>
        <translation>坠落结构另计</translation>
    </message>
    <message>
        <source>The case has changed since these members were simulated.</source>
        <translation>模拟这些成员之后，案例已改变。</translation>
    </message>
    <message>
        <source>They are shown as they were. Simulate again to bring them up to date.</source>
        <translation>所示为当时的结果。请再次模拟以更新。</translation>
    </message>
    <message>
        <source>figure</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>What is measured on every member</source>
        <translation>对每个成员测量的量</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>平均值</translation>
    </message>
    <message>
        <source>Mean of the members</source>
        <translation>各成员的平均值</translation>
    </message>
    <message>
        <source>± mean</source>
        <translation>± 平均值</translation>
    </message>
    <message>
        <source>Standard error of the mean: how far it may be off for so few members</source>
        <translation>平均值的标准误差：成员数有限时它可能的偏差</translation>
    </message>
    <message>
        <source>± members</source>
        <translation>± 成员</translation>
    </message>
    <message>
        <source>Standard deviation of the members: how far one differs from another</source>
        <translation>成员的标准差：彼此相差多少</translation>
    </message>
    <message>
        <source>5 %</source>
        <translation>5 %</translation>
    </message>
    <message>
        <source>One member in twenty lies below</source>
        <translation>二十个成员中有一个低于此值</translation>
    </message>
    <message>
        <source>median</source>
        <translation>中位数</translation>
    </message>
    <message>
        <source>Half of the members lie below</source>
        <translation>一半成员低于此值</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>One member in twenty lies above</source>
        <translation>二十个成员中有一个高于此值</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>With %1 members the probability of a cell may be off by %2 in the mean and by %3 at most, one standard error. That covers what was varied and nothing else.</source>
        <translation>有 %1 个成员时，单元的概率平均可能偏差 %2，最多 %3，均为一个标准误差。这只涵盖所变动的量，别无其他。</translation>
    </message>
    <message>
        <source>least</source>
        <translation>最小值</translation>
    </message>
    <message>
        <source>Of all members, which are few</source>
        <translation>取自全部成员，其数很少</translation>
    </message>
    <message>
        <source>most</source>
        <translation>最大值</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::EnsemblePanel</name>
    <message>
        <source>Ensemble</source>
        <translation>系综</translation>
    </message>
    <message>
        <source>How sure is it where debris lies, with what is not known drawn anew?</source>
        <translation>在未知量重新抽取时，堆积物的位置有多确定？</translation>
    </message>
    <message>
        <source>Simulate members</source>
        <translation>模拟成员</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>Fallen structure counts as debris</source>
        <translation>坠落结构计入堆积物</translation>
    </message>
    <message>
        <source>At the end of the FE result</source>
        <translation>取有限元结果结束时</translation>
    </message>
    <message>
        <source>What is varied</source>
        <translation>变动的量</translation>
    </message>
    <message>
        <source>Simulate every member, with values drawn from the distributions below. Members that were simulated before are taken from the cache</source>
        <translation>模拟每个成员，取值按下面的分布抽取。先前模拟过的成员从缓存中取用</translation>
    </message>
    <message>
        <source>Progress of the ensemble</source>
        <translation>系综的进度</translation>
    </message>
    <message>
        <source>Members</source>
        <translation>成员</translation>
    </message>
    <message>
        <source>How often the collapse is simulated, 1 to 10,000. The probability of a cell is sure to about 0.5 / √(n + 4): 0.11 with 16 members, 0.06 with 64</source>
        <translation>倒塌被模拟的次数，1 至 10,000。单元概率的精度约为 0.5 / √(n + 4)：16 个成员为 0.11，64 个为 0.06</translation>
    </message>
    <message>
        <source>Of what is drawn: the same seed gives the same members. 0 to 4,294,967,295</source>
        <translation>抽取所用：相同的种子给出相同的成员。0 至 4,294,967,295</translation>
    </message>
    <message>
        <source>members of the ensemble</source>
        <translation>系综的成员数</translation>
    </message>
    <message>
        <source>seed of the ensemble</source>
        <translation>系综的种子</translation>
    </message>
    <message>
        <source>Debris on the ground</source>
        <translation>地面上的堆积物</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Side of the cells of the maps. From 0.05 to 100 m</source>
        <translation>图中单元的边长。0.05 至 100 m</translation>
    </message>
    <message>
        <source>Live elements that moved farther than %1 are debris</source>
        <translation>位移超过 %1 的存活单元计为堆积物</translation>
    </message>
    <message>
        <source>Maps show the debris at the last FE state, not where it comes to rest</source>
        <translation>图显示最后一个有限元状态时的堆积物，而非其静止位置</translation>
    </message>
    <message>
        <source>Each member takes about as long as a run.</source>
        <translation>每个成员约需一次计算的时间。</translation>
    </message>
    <message>
        <source>Each member takes about as long as the last run: %1 in all, unless members are kept from before.</source>
        <translation>每个成员约需上次计算的时间：共 %1，除非已有先前保留的成员。</translation>
    </message>
    <message>
        <source>Members that are done are kept in %1, so that a second start goes on from there.</source>
        <translation>已完成的成员保存在 %1，再次开始时从此继续。</translation>
    </message>
    <message>
        <source>Stop, on a cluster after a question; members that are done are kept, and simulating again goes on</source>
        <translation>停止，在集群上会先询问；已完成的成员保留，再次模拟时继续</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::ErrorBar</name>
    <message>
        <source>Compute the reference</source>
        <translation>计算基准</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Progress of the reference</source>
        <translation>基准的进度</translation>
    </message>
    <message>
        <source>Simulates the same collapse with a body for every fragment and keeps it; takes several times as long as the run</source>
        <translation>以每个碎块一个刚体模拟同一倒塌并保留；耗时为此次计算的数倍</translation>
    </message>
    <message>
        <source>Errors are not known: simulate first, then compare with a reference.</source>
        <translation>误差未知：请先模拟，再与基准比较。</translation>
    </message>
    <message>
        <source>Errors are not known: there is no reference of this run, in which every fragment is its own body.</source>
        <translation>误差未知：此次计算没有基准（每个碎块各为一个刚体）。</translation>
    </message>
    <message>
        <source>Computing the reference</source>
        <translation>正在计算基准</translation>
    </message>
    <message>
        <source>Coloured by the distance of each fragment from its place in the reference at the same time.</source>
        <translation>按同一时刻每个碎块到其基准位置的距离着色。</translation>
    </message>
    <message>
        <source>The reference could not be computed.</source>
        <translation>无法计算基准。</translation>
    </message>
    <message>
        <source>Computing the reference · about %1 left</source>
        <translation>正在计算基准 · 约剩 %1</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::EvidencePage</name>
    <message>
        <source>Model beside the photograph</source>
        <translation>照片旁的模型</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>照片</translation>
    </message>
    <message>
        <source>The photograph alone (Ctrl+1)</source>
        <translation>仅照片（Ctrl+1）</translation>
    </message>
    <message>
        <source>Swipe</source>
        <translation>划分</translation>
    </message>
    <message>
        <source>Photograph left of a line, simulation right of it: drag the line (Ctrl+2)</source>
        <translation>线左为照片，线右为模拟：可拖动该线（Ctrl+2）</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>叠合</translation>
    </message>
    <message>
        <source>The simulation over the photograph, as strong as the slider says (Ctrl+3)</source>
        <translation>模拟叠加在照片上，强度由滑块决定（Ctrl+3）</translation>
    </message>
    <message>
        <source>Blink</source>
        <translation>交替</translation>
    </message>
    <message>
        <source>Photograph and simulation in turn (Ctrl+4)</source>
        <translation>照片和模拟轮流显示（Ctrl+4）</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>The outline of the simulated debris on the photograph (Ctrl+5)</source>
        <translation>照片上的模拟堆积物轮廓（Ctrl+5）</translation>
    </message>
    <message>
        <source>Beside</source>
        <translation>左右排列</translation>
    </message>
    <message>
        <source>The model beside the photograph (Ctrl+6)</source>
        <translation>照片旁的模型（Ctrl+6）</translation>
    </message>
    <message>
        <source>Share of the simulation</source>
        <translation>模拟所占比例</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>添加点</translation>
    </message>
    <message>
        <source>Click a point in the photograph, then the same point in the model (Shift+A)</source>
        <translation>单击照片中的一点，然后单击模型中的同一点 (Shift+A)</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>所画内容</translation>
    </message>
    <message>
        <source>What the outline that is drawn encloses: debris, what rescuers moved, what is hidden, what is no debris</source>
        <translation>所画轮廓围住的是：堆积物、救援移走的部分、被遮挡的部分、非堆积物</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>绘制</translation>
    </message>
    <message>
        <source>Draw around it: click the corners, double-click or Enter closes, Backspace takes one back</source>
        <translation>沿其周围绘制：单击角点，双击或回车闭合，退格键撤回一个</translation>
    </message>
    <message>
        <source>Where the line stands, 0 to 100 %</source>
        <translation>线的位置，0 至 100 %</translation>
    </message>
    <message>
        <source>How strong the simulation is, 0 to 100 %</source>
        <translation>模拟的强度，0 至 100 %</translation>
    </message>
    <message>
        <source>Survey</source>
        <translation>测绘</translation>
    </message>
    <message>
        <source>The difference map of the survey instead of the photograph</source>
        <translation>显示测绘差异图而非照片</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::EvidencePanel</name>
    <message>
        <source>%1 × %2 px</source>
        <translation>%1 × %2 px</translation>
    </message>
    <message>
        <source>turned upright</source>
        <translation>已转正</translation>
    </message>
    <message>
        <source>focal length %1 mm (%2 mm on 36 × 24 mm)</source>
        <translation>焦距 %1 mm（等效 36 × 24 mm 为 %2 mm）</translation>
    </message>
    <message>
        <source>focal length %1 mm</source>
        <translation>焦距 %1 mm</translation>
    </message>
    <message>
        <source>focal length %1 mm on 36 × 24 mm</source>
        <translation>焦距 %1 mm（等效 36 × 24 mm）</translation>
    </message>
    <message>
        <source>taken %1 by its clock</source>
        <translation>按相机时钟摄于 %1</translation>
    </message>
    <message>
        <source>%1° N, %2° E</source>
        <translation>%1° N，%2° E</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>证据</translation>
    </message>
    <message>
        <source>What photographs show, and how far the simulated debris agrees.</source>
        <translation>照片显示了什么，模拟堆积物与之符合到何种程度。</translation>
    </message>
    <message>
        <source>Add photographs…</source>
        <translation>添加照片…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>when all lay at rest</source>
        <translation>全部静止时</translation>
    </message>
    <message>
        <source>Time of the photograph</source>
        <translation>照片的时刻</translation>
    </message>
    <message>
        <source>Uncertainty of the time</source>
        <translation>时刻的不确定度</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>焦距</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Fallen structure counts as debris</source>
        <translation>坠落结构计入堆积物</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Photographs</source>
        <translation>照片</translation>
    </message>
    <message>
        <source>The photograph that is shown</source>
        <translation>显示的照片</translation>
    </message>
    <message>
        <source>Add photographs to the case: JPEG, PNG, TIFF or HEIC. Their files are only read, never changed</source>
        <translation>向案例添加照片：JPEG、PNG、TIFF 或 HEIC。文件只读取，从不更改</translation>
    </message>
    <message>
        <source>Take the photograph out of the case, with its points and masks; the file stays</source>
        <translation>从案例中移除照片及其点和蒙版；文件保留</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>The photograph shows the debris after all has come to rest: it is held against the end of the run</source>
        <translation>照片显示全部静止之后的堆积物：与计算结束时对照</translation>
    </message>
    <message>
        <source>taken at</source>
        <translation>拍摄时刻</translation>
    </message>
    <message>
        <source>give or take</source>
        <translation>误差范围</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>note: who took it, from where</source>
        <translation>备注：谁拍摄，从何处</translation>
    </message>
    <message>
        <source>A note on the photograph, kept in the case</source>
        <translation>照片的备注，保存在案例中</translation>
    </message>
    <message>
        <source>time of the photograph</source>
        <translation>照片时刻</translation>
    </message>
    <message>
        <source>uncertainty of the time</source>
        <translation>时刻不确定度</translation>
    </message>
    <message>
        <source>note on the photograph</source>
        <translation>照片备注</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>to be found</source>
        <translation>待求</translation>
    </message>
    <message>
        <source>focal length</source>
        <translation>焦距值</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>In pixels, if it is known: in millimetres times the width in pixels over that of the sensor in millimetres. Left empty it is found from the points. From 1 to 10,000,000 px</source>
        <translation>以像素计（若已知）：毫米焦距乘以像素宽度再除以传感器毫米宽度。留空则由点求得。1 至 10,000,000 px</translation>
    </message>
    <message>
        <source>the middle</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>Principal point</source>
        <translation>主点</translation>
    </message>
    <message>
        <source>principal point</source>
        <translation>主点位置</translation>
    </message>
    <message>
        <source>Where the axis of the lens meets the picture: the middle unless the photograph was cropped, px</source>
        <translation>镜头轴线与照片的交点：除非照片被裁剪，否则为中心，px</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>one term</source>
        <translation>一项</translation>
    </message>
    <message>
        <source>two terms</source>
        <translation>两项</translation>
    </message>
    <message>
        <source>Distortion</source>
        <translation>畸变</translation>
    </message>
    <message>
        <source>distortion</source>
        <translation>畸变项数</translation>
    </message>
    <message>
        <source>Terms of radial distortion that are found from the points. Automatic: as far as these tell them; what they leave open is that of real lenses. None: of a picture whose distortion was taken out</source>
        <translation>由点求得的径向畸变项数。自动：按各点所能说明的程度；未能说明的部分取自实有的镜头。无：畸变已被消除的照片</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>within (95 %)</source>
        <translation>误差（95 %）</translation>
    </message>
    <message>
        <source>direction within</source>
        <translation>方向误差</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>With 95 % confidence the camera looked within this of the direction found, degrees</source>
        <translation>在 95 % 置信度下，相机方向与所求方向相差在此范围内，度</translation>
    </message>
    <message>
        <source>With its standard deviation where it was found, pixels</source>
        <translation>若为求得，附标准差，像素</translation>
    </message>
    <message>
        <source>fit, RMS</source>
        <translation>拟合，RMS</translation>
    </message>
    <message>
        <source>Root of the mean square of the residuals of the points that agree, pixels</source>
        <translation>相符各点残差的均方根，像素</translation>
    </message>
    <message>
        <source>focal length of the camera</source>
        <translation>相机焦距</translation>
    </message>
    <message>
        <source>principal point of the camera</source>
        <translation>相机主点</translation>
    </message>
    <message>
        <source>distortion of the camera</source>
        <translation>相机畸变</translation>
    </message>
    <message>
        <source>Drawn on it</source>
        <translation>照片上所画</translation>
    </message>
    <message>
        <source>Outlines and masks</source>
        <translation>轮廓和蒙版</translation>
    </message>
    <message>
        <source>Delete the chosen outline or mask</source>
        <translation>删除所选轮廓或蒙版</translation>
    </message>
    <message>
        <source>%1 deleted</source>
        <translation>%1 已删除</translation>
    </message>
    <message>
        <source>Hold the silhouette of the simulated debris against the outline drawn, with 64 cameras that the match allows</source>
        <translation>以匹配所允许的 64 个相机，将模拟堆积物的剪影与所画轮廓对照</translation>
    </message>
    <message>
        <source>Stop comparing</source>
        <translation>停止比较</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>重合度</translation>
    </message>
    <message>
        <source>Area in both silhouettes over area in either, with the camera as found; 1: the same</source>
        <translation>两个剪影的交集面积与并集面积之比，按所求相机；1：相同</translation>
    </message>
    <message>
        <source>as the camera allows</source>
        <translation>按相机允许范围</translation>
    </message>
    <message>
        <source>Mean and standard deviation of the overlap over the cameras that the match allows</source>
        <translation>匹配所允许的各相机下重合度的平均值和标准差</translation>
    </message>
    <message>
        <source>edges apart</source>
        <translation>边缘间距</translation>
    </message>
    <message>
        <source>The same in pixels of the photograph</source>
        <translation>同上，以照片像素计</translation>
    </message>
    <message>
        <source>over its time</source>
        <translation>按其时刻范围</translation>
    </message>
    <message>
        <source>Least and greatest overlap from the earliest to the latest time of the photograph</source>
        <translation>照片最早至最晚时刻之间的最小和最大重合度</translation>
    </message>
    <message>
        <source>A photograph of the site shows what the debris really did. Add one, click points that the model has too, and the camera is found; then the simulation is seen from there.</source>
        <translation>现场照片显示堆积物的真实情况。添加一张，单击模型中也有的点，即可求得相机；随后可从该处看模拟。</translation>
    </message>
    <message>
        <source>Open a result first.</source>
        <translation>请先打开结果。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1，共 %2</translation>
    </message>
    <message>
        <source>Good match.</source>
        <translation>匹配良好。</translation>
    </message>
    <message>
        <source>Usable match.</source>
        <translation>匹配可用。</translation>
    </message>
    <message>
        <source>More points, spread in depth and to the corners, make it better.</source>
        <translation>增加在深度上分散并靠近角落的点可改善匹配。</translation>
    </message>
    <message>
        <source>Add points, spread in depth and to the corners of the picture.</source>
        <translation>请增加在深度上分散并靠近照片角落的点。</translation>
    </message>
    <message>
        <source>%1, corners: %2</source>
        <translation>%1，角点数：%2</translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation>正在比较…</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Something has changed since: compare again.</source>
        <translation>此后有更改：请重新比较。</translation>
    </message>
    <message>
        <source>fallen structure with it</source>
        <translation>含坠落结构</translation>
    </message>
    <message>
        <source>fallen structure apart</source>
        <translation>坠落结构另计</translation>
    </message>
    <message>
        <source>Where the camera stood: x, y, z in the frame of the case</source>
        <translation>相机所在位置：案例坐标框架中的 x、y、z</translation>
    </message>
    <message>
        <source>With 95 % confidence the camera stood within this of the position</source>
        <translation>以 95 % 的置信度，相机位于距该位置此距离之内</translation>
    </message>
    <message>
        <source>Live elements that moved farther than %1 are debris; else they only hide what lies behind them</source>
        <translation>移动超过 %1 的未失效单元算作堆积物；否则只遮挡其后之物</translation>
    </message>
    <message>
        <source>Mean distance of the edges of the silhouettes at the distance of the debris</source>
        <translation>在堆积物距离处两轮廓边缘的平均距离</translation>
    </message>
    <message>
        <source>An edge %1 away is certain to about %2.</source>
        <translation>距离 %1 处的边缘约有 %2 的把握。</translation>
    </message>
    <message>
        <source>Survey</source>
        <translation>测绘</translation>
    </message>
    <message>
        <source>time taken unknown</source>
        <translation>拍摄时间未知</translation>
    </message>
    <message>
        <source>noted in the file</source>
        <translation>文件中记录</translation>
    </message>
    <message>
        <source>Focal length that the camera noted in the photograph; it is not taken for the true one</source>
        <translation>相机在照片文件中记录的焦距；不视为真实值</translation>
    </message>
    <message>
        <source>Agreement with the photograph</source>
        <translation>与照片的吻合程度</translation>
    </message>
    <message>
        <source>Debris at %1, %2.</source>
        <translation>%1 时的堆积物，%2。</translation>
    </message>
    <message>
        <source>When the photograph was taken, on the clock of the FE result</source>
        <translation>照片拍摄的时刻，按有限元结果的时间</translation>
    </message>
    <message>
        <source>How far the time may be off, as much before as after. From 0 to 1,000,000 s</source>
        <translation>时刻可能的偏差，前后相同。从 0 到 1,000,000 s</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::EvidenceTable</name>
    <message>
        <source>photograph</source>
        <translation>照片</translation>
    </message>
    <message>
        <source>point cloud</source>
        <translation>点云</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>control points</source>
        <translation>控制点</translation>
    </message>
    <message>
        <source>height model</source>
        <translation>高程模型</translation>
    </message>
    <message>
        <source>evidence</source>
        <translation>证据</translation>
    </message>
    <message>
        <source>shows</source>
        <translation>所示</translation>
    </message>
    <message>
        <source>within, m</source>
        <translation>误差，m</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>重合度</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>All evidence of the case</source>
        <translation>案例的全部证据</translation>
    </message>
    <message>
        <source>elsewhere</source>
        <translation>在别处</translation>
    </message>
    <message>
        <source>measured points</source>
        <translation>测点</translation>
    </message>
    <message>
        <source>Photographs, surveys, clouds, outlines, measured points and control points: what each is held to show, within how many metres its place is known (95 %), and how far the run overlaps with it</source>
        <translation>照片、测绘、点云、轮廓、测点和控制点：各自表示什么、其位置准确到多少米（95 %），以及计算与其重合的程度</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::FigureDialog</name>
    <message>
        <source> px</source>
        <translation> 像素</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>Figure for print</source>
        <translation>印刷用插图</translation>
    </message>
    <message>
        <source>As the views are</source>
        <translation>与视图相同</translation>
    </message>
    <message>
        <source>Preview of the figure</source>
        <translation>插图预览</translation>
    </message>
    <message>
        <source>Drawing the preview …</source>
        <translation>正在绘制预览…</translation>
    </message>
    <message>
        <source>Arrangement</source>
        <translation>排版</translation>
    </message>
    <message>
        <source>The panes as they are, or the arrangement of a figure of the published method with its instants</source>
        <translation>按现有窗格，或按已发表方法中插图的排版及其时刻</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Pixels from left to right, 100 to 8000</source>
        <translation>从左到右的像素数，100 至 8000</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>分辨率</translation>
    </message>
    <message>
        <source>Pixels per inch in print, 50 to 1200: text is 9 pt high whatever the size</source>
        <translation>印刷时每英寸像素数，50 至 1200:无论大小，文字高 9 磅</translation>
    </message>
    <message>
        <source>Save figure…</source>
        <translation>保存插图…</translation>
    </message>
    <message>
        <source>Write it as PNG, or as SVG or PDF with text and lines as vectors</source>
        <translation>写成 PNG,或文字与线条为矢量的 SVG 或 PDF</translation>
    </message>
    <message>
        <source>In print %1 × %2 mm</source>
        <translation>印刷尺寸 %1 × %2 毫米</translation>
    </message>
    <message>
        <source>Show what is selected</source>
        <translation>显示选中的内容</translation>
    </message>
    <message>
        <source>Selected elements in their colour; without it the figure is as if nothing were selected</source>
        <translation>选中的单元以其颜色显示；不勾选时，图如同没有选中任何内容</translation>
    </message>
    <message>
        <source>FE against fragments</source>
        <translation>有限元与碎块对照</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>结束时</translation>
    </message>
    <message>
        <source>In its surroundings</source>
        <translation>在周边环境中</translation>
    </message>
    <message>
        <source>Stages</source>
        <translation>各阶段</translation>
    </message>
    <message>
        <source>Pixels from top to bottom, 100 to 8000; below that as high as what the pictures show needs</source>
        <translation>从上到下的像素，100 至 8000；更小时高度按图片所示内容的需要</translation>
    </message>
    <message>
        <source>as the pictures need</source>
        <translation>按图片所需</translation>
    </message>
    <message>
        <source>In print %1 mm wide</source>
        <translation>印刷宽 %1 mm</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::FileField</name>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Choose the file: %1</source>
        <translation>选择文件：%1</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::FindingList</name>
    <message>
        <source>%1×: %2</source>
        <translation>%1 处：%2</translation>
    </message>
    <message>
        <source>first: %1</source>
        <translation>首例：%1</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::FitDialog</name>
    <message>
        <source>Moved by %1 m, turned by %2°.</source>
        <translation>移动 %1 m，转动 %2°。</translation>
    </message>
    <message>
        <source>RMS of %1 points to their surfaces: %2 m before, %3 m after.</source>
        <translation>%1 个点到其表面的 RMS：之前 %2 m，之后 %3 m。</translation>
    </message>
    <message>
        <source>One point to each cube of %1 m was fitted.</source>
        <translation>每个边长 %1 m 的立方体取一点进行拟合。</translation>
    </message>
    <message>
        <source>Places at the structure are then known to %1 m (standard deviation).</source>
        <translation>此后结构处的位置准确到 %1 m（标准差）。</translation>
    </message>
    <message>
        <source>Most of the cloud did not move: fit all of it</source>
        <translation>点云大部分未移动：全部拟合</translation>
    </message>
    <message>
        <source>Radius of the fit</source>
        <translation>拟合半径</translation>
    </message>
    <message>
        <source>Areas from a file…</source>
        <translation>取自文件的区域…</translation>
    </message>
    <message>
        <source>Remove last area</source>
        <translation>删除最后的区域</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>Cancel the fit</source>
        <translation>取消拟合</translation>
    </message>
    <message>
        <source>Fit to what did not move</source>
        <translation>拟合到未移动的部分</translation>
    </message>
    <message>
        <source>Click the corners around what did not move, such as streets and walls that still stand; a double click or Enter closes.</source>
        <translation>点击未移动部分周围的角点，例如街道和仍然站立的墙；双击或 Enter 闭合。</translation>
    </message>
    <message>
        <source>Cloud from above</source>
        <translation>从上方所见的点云</translation>
    </message>
    <message>
        <source>Place survey</source>
        <translation>放置测绘</translation>
    </message>
    <message>
        <source>Radius, m</source>
        <translation>半径，m</translation>
    </message>
    <message>
        <source>Surfaces within it of a point are what the point is fitted to, m: more than the cloud is out of place</source>
        <translation>点拟合到此半径以内的表面，m：应大于点云错开的量</translation>
    </message>
    <message>
        <source>The nearest 80 % of the points decide; what moved must be less than that</source>
        <translation>由最近的 80 % 的点决定；移动的部分须少于其余</translation>
    </message>
    <message>
        <source>Take polygons of a file as areas that did not move</source>
        <translation>把文件中的多边形作为未移动的区域</translation>
    </message>
    <message>
        <source>Fits the points of the areas to the surfaces of the site</source>
        <translation>把区域中的点拟合到现场的表面</translation>
    </message>
    <message>
        <source>The cloud is being fitted.</source>
        <translation>正在拟合点云。</translation>
    </message>
    <message>
        <source>Fit, and what is left is told here.</source>
        <translation>拟合之后，此处列出剩余量。</translation>
    </message>
    <message>
        <source>Nothing is said yet of what did not move.</source>
        <translation>尚未说明哪些部分未移动。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::FragmentModel</name>
    <message>
        <source>Number of the fragment</source>
        <translation>碎块的编号</translation>
    </message>
    <message>
        <source>Number of its element in the FE result</source>
        <translation>其单元在有限元结果中的编号</translation>
    </message>
    <message>
        <source>Component that its element belongs to</source>
        <translation>其单元所属的构件</translation>
    </message>
    <message>
        <source>When it is shown and reported as a fragment</source>
        <translation>作为碎块显示和报告的时刻</translation>
    </message>
    <message>
        <source>Volume at rest times the density of its component</source>
        <translation>静止体积乘以其构件的密度</translation>
    </message>
    <message>
        <source>Longest side of the box around it</source>
        <translation>其包围盒的最长边</translation>
    </message>
    <message>
        <source>Of the body that carries it, at the time shown; a dash: none does then. Without a run: as it is born</source>
        <translation>所示时刻承载它的刚体的速度；短横：当时没有刚体承载它。没有计算时：其产生时的速度</translation>
    </message>
    <message>
        <source>Number of the cluster that it moves with</source>
        <translation>与其一同运动的聚类的编号</translation>
    </message>
    <message>
        <source>fragment</source>
        <translation>碎块</translation>
    </message>
    <message>
        <source>element</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>component</source>
        <translation>构件</translation>
    </message>
    <message>
        <source>born</source>
        <translation>产生</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>longest side</source>
        <translation>最长边</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>cluster</source>
        <translation>聚类</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::FragmentTable</name>
    <message>
        <source>Show all</source>
        <translation>全部显示</translation>
    </message>
    <message>
        <source>Fragments</source>
        <translation>碎块</translation>
    </message>
    <message>
        <source>A row selects the fragment in the views, Ctrl and Shift choose several; Enter goes to its birth</source>
        <translation>点击一行即在视图中选中该碎块，按 Ctrl 和 Shift 可选多个；Enter 转到其产生时刻</translation>
    </message>
    <message>
        <source>%1 from</source>
        <translation>%1 起于</translation>
    </message>
    <message>
        <source>least</source>
        <translation>最小值</translation>
    </message>
    <message>
        <source>%1 to</source>
        <translation>%1 止于</translation>
    </message>
    <message>
        <source>greatest</source>
        <translation>最大值</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Shown are fragments as fast as this at the time shown</source>
        <translation>显示在所示时刻速度如此的碎块</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Shown are fragments as heavy as this</source>
        <translation>显示质量如此的碎块</translation>
    </message>
    <message>
        <source>longest side</source>
        <translation>最长边</translation>
    </message>
    <message>
        <source>Shown are fragments whose box has a longest side like this</source>
        <translation>显示包围盒最长边如此的碎块</translation>
    </message>
    <message>
        <source>born</source>
        <translation>产生</translation>
    </message>
    <message>
        <source>Shown are fragments born within these times</source>
        <translation>显示在此时段内产生的碎块</translation>
    </message>
    <message>
        <source>component</source>
        <translation>构件</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>所属构件</translation>
    </message>
    <message>
        <source>Shown are fragments of this component</source>
        <translation>显示该构件的碎块</translation>
    </message>
    <message>
        <source>Take all bounds away</source>
        <translation>去掉所有界限</translation>
    </message>
    <message>
        <source>any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>There are no fragments yet: open a result whose elements die.</source>
        <translation>还没有碎块：请打开有单元失效的结果。</translation>
    </message>
    <message>
        <source>%1 of %2 fragments shown</source>
        <translation>显示 %1 / %2 个碎块</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::FragmentsPanel</name>
    <message>
        <source>Fragments</source>
        <translation>碎块</translation>
    </message>
    <message>
        <source>What became debris, when, and with which mass.</source>
        <translation>什么成为堆积物，何时，质量多少。</translation>
    </message>
    <message>
        <source>Debris</source>
        <translation>堆积物</translation>
    </message>
    <message>
        <source>Deactivated elements, each one rigid fragment</source>
        <translation>失效单元，每个为一个刚性碎块</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Mass, from to</source>
        <translation>质量范围</translation>
    </message>
    <message>
        <source>Fastest at hand-over</source>
        <translation>交接时最快</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>Births</source>
        <translation>产生</translation>
    </message>
    <message>
        <source>Birth times</source>
        <translation>产生时刻数</translation>
    </message>
    <message>
        <source>First</source>
        <translation>首次</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>末次</translation>
    </message>
    <message>
        <source>Most at once</source>
        <translation>同时最多</translation>
    </message>
    <message>
        <source>Most fragments with one birth time</source>
        <translation>同一产生时刻的最多碎块数</translation>
    </message>
    <message>
        <source>How elements become fragments</source>
        <translation>单元如何变成碎块</translation>
    </message>
    <message>
        <source>No element dies in this result: all %1 elements are active at the last state.</source>
        <translation>此结果中没有单元失效：全部 %1 个单元在最后状态均为激活。</translation>
    </message>
    <message>
        <source>Open a result: its deactivated elements appear here as fragments.</source>
        <translation>打开结果：其失效单元将作为碎块显示在此。</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%2 时 %1 个</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::GridPanel</name>
    <message>
        <source>Basic Grid</source>
        <translation>基本网格</translation>
    </message>
    <message>
        <source>Which fragments move together, and what that costs.</source>
        <translation>哪些碎块一起运动，代价如何。</translation>
    </message>
    <message>
        <source>Clusters</source>
        <translation>聚类</translation>
    </message>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Allow as many bodies as this machine carries at the target rate</source>
        <translation>允许本机在目标帧率下能承载的刚体数</translation>
    </message>
    <message>
        <source>Calibrate this machine…</source>
        <translation>标定本机…</translation>
    </message>
    <message>
        <source>Measure how many bodies this machine carries, and see the curve</source>
        <translation>测量本机能承载多少刚体，并查看曲线</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Multiple of mean distance</source>
        <translation>平均间距的倍数</translation>
    </message>
    <message>
        <source>Drag to set the multiple; clusters are counted and the grid is drawn anew while you drag.</source>
        <translation>拖动以设置倍数；拖动时重新统计聚类并重绘网格。</translation>
    </message>
    <message>
        <source>%1 times the mean distance</source>
        <translation>平均间距的 %1 倍</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>d</source>
        <translation>d</translation>
    </message>
    <message>
        <source>size</source>
        <translation>选定</translation>
    </message>
    <message>
        <source>size/d</source>
        <translation>尺寸/d</translation>
    </message>
    <message>
        <source>comp.</source>
        <translation>构件</translation>
    </message>
    <message>
        <source>Axis of the model</source>
        <translation>模型坐标轴</translation>
    </message>
    <message>
        <source>Size over mean distance; the published method recommends two to three</source>
        <translation>尺寸与平均间距之比；论文推荐二至三</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Fragments</source>
        <translation>碎块</translation>
    </message>
    <message>
        <source>Rigid bodies that the engine moves, counted at these sizes</source>
        <translation>引擎带动的刚体数，按此尺寸统计</translation>
    </message>
    <message>
        <source>Fragments in a cluster, mean</source>
        <translation>每个聚类的碎块数，平均</translation>
    </message>
    <message>
        <source>Split by component, by velocity</source>
        <translation>按构件、按速度分离</translation>
    </message>
    <message>
        <source>Clusters added because none may span two components, or because a fragment moves otherwise</source>
        <translation>因聚类不得跨越两个构件，或因某碎块运动不同而增加的聚类</translation>
    </message>
    <message>
        <source>Against the published two to three</source>
        <translation>与论文的二至三倍对照</translation>
    </message>
    <message>
        <source>Clusters at %1 d</source>
        <translation>%1 d 时的聚类</translation>
    </message>
    <message>
        <source>Counted on these fragments; within their bounds or not</source>
        <translation>按这些碎块统计；不论是否在界限之内</translation>
    </message>
    <message>
        <source>As set</source>
        <translation>当前设置</translation>
    </message>
    <message>
        <source>Few fragments share a birth time in a result with many states: the same number of bodies may need a larger multiple than the two to three of the published method.</source>
        <translation>状态较多的结果中，同一产生时刻的碎块很少：同样的刚体数可能需要比论文的二至三更大的倍数。</translation>
    </message>
    <message>
        <source>This machine is not calibrated: 4,500 bodies at 24 FPS is the published figure.</source>
        <translation>本机尚未标定：24 FPS 下 4,500 个刚体为论文数据。</translation>
    </message>
    <message>
        <source>The calibration of this machine says nothing here: other programs worked meanwhile, or it has too few points.</source>
        <translation>本机的标定在此不适用：标定时有其他程序运行，或点数太少。</translation>
    </message>
    <message>
        <source>This machine carries %1 bodies at %2 FPS where some of them rest, %3 where none does.</source>
        <translation>%2 FPS 下本机可承载 %1 个刚体（其中一部分静止）；若无一静止则为 %3 个。</translation>
    </message>
    <message>
        <source>an unknown number</source>
        <translation>未知数目</translation>
    </message>
    <message>
        <source>Allow %1</source>
        <translation>允许 %1</translation>
    </message>
    <message>
        <source>Element %1</source>
        <translation>单元 %1</translation>
    </message>
    <message>
        <source>Open a result: the sizes that meet the live frame rate appear here.</source>
        <translation>打开结果：满足实时帧率的尺寸将显示在此。</translation>
    </message>
    <message>
        <source>%1 at %2 d</source>
        <translation>%2 d 时 %1</translation>
    </message>
    <message>
        <source>Mean distance of adjacent fragments</source>
        <translation>相邻碎块的平均间距</translation>
    </message>
    <message>
        <source>Chosen size of the Basic Grid</source>
        <translation>基本网格的所取尺寸</translation>
    </message>
    <message>
        <source>Largest fragment: the least sensible size</source>
        <translation>最大碎块：最小的合理尺寸</translation>
    </message>
    <message>
        <source>Smallest component: along axes the greatest sensible size</source>
        <translation>最小构件：沿各轴最大的合理尺寸</translation>
    </message>
    <message>
        <source>Sizes of the Basic Grid and their bounds</source>
        <translation>基本网格的尺寸及其界限</translation>
    </message>
    <message>
        <source>in %1; d is the mean distance of adjacent fragments</source>
        <translation>单位 %1；d 为相邻碎块的平均间距</translation>
    </message>
    <message>
        <source>frag.</source>
        <translation>最大块</translation>
    </message>
    <message>
        <source>Awake at once</source>
        <translation>同时活动</translation>
    </message>
    <message>
        <source>Most of them that move at the same time, each from its birth on for the time set above; bodies at rest cost next to nothing, so this is what the bodies allowed are held against</source>
        <translation>其中同时运动的最多个数，每个自产生起按上面设定的时间计；静止的刚体几乎不耗时，因此以此与允许的刚体数比较</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::HealthList</name>
    <message>
        <source>%1 bodies at worst</source>
        <translation>最差时 %1 个刚体</translation>
    </message>
    <message>
        <source>worst %1%2, limit %3</source>
        <translation>最差 %1%2，限值 %3</translation>
    </message>
    <message>
        <source>1 limit passed</source>
        <translation>超过 1 项限值</translation>
    </message>
    <message>
        <source>%1 limits passed</source>
        <translation>超过 %1 项限值</translation>
    </message>
    <message>
        <source>acknowledged</source>
        <translation>已确认</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Who has looked at these breaches and vouches for the run</source>
        <translation>谁查看了这些超限并为此次计算负责</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Why the run may be used all the same</source>
        <translation>为何仍可使用此次计算</translation>
    </message>
    <message>
        <source>Write name, note and time beside the run file; the run no longer counts as tainted</source>
        <translation>将姓名、备注和时间写在计算文件旁；此次计算不再视为存疑</translation>
    </message>
    <message>
        <source>Sound: no limit was passed.</source>
        <translation>正常：未超过任何限值。</translation>
    </message>
    <message>
        <source>%1: this run is tainted until someone acknowledges it.</source>
        <translation>%1：在有人确认之前，此次计算存疑。</translation>
    </message>
    <message>
        <source>Acknowledged by %1, %2</source>
        <translation>由 %1 确认，%2</translation>
    </message>
    <message>
        <source>Show %1, %2</source>
        <translation>显示 %1，%2</translation>
    </message>
    <message>
        <source>A name is needed: who vouches for this run?</source>
        <translation>需要姓名：由谁为此次计算负责？</translation>
    </message>
    <message>
        <source>A note is needed: why may this run be used all the same?</source>
        <translation>需要备注：为何仍可使用此次计算？</translation>
    </message>
    <message>
        <source>body %1 at x %2, y %3, z %4 %5</source>
        <translation>刚体 %1 位于 x %2、y %3、z %4 %5</translation>
    </message>
    <message>
        <source>Set “%1” to %2</source>
        <translation>将“%1”设为%2</translation>
    </message>
    <message>
        <source>It is set: simulate to see what it does</source>
        <translation>已设定：重新模拟即可看到效果</translation>
    </message>
    <message>
        <source>Change this setting; Ctrl+Z takes it back</source>
        <translation>更改此设置；Ctrl+Z 可撤销</translation>
    </message>
    <message>
        <source>%1 and %2 more times</source>
        <translation>%1，另有 %2 次</translation>
    </message>
    <message>
        <source>%1: single bodies are not as they should be.</source>
        <translation>%1：个别刚体不是应有的样子。</translation>
    </message>
    <message>
        <source>Go to the worst of its times and point out the body</source>
        <translation>转到其中最差的一次并指出刚体</translation>
    </message>
    <message>
        <source>Go to the worst of its times</source>
        <translation>转到其中最差的一次</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>在 %1</translation>
    </message>
    <message>
        <source>%1–%2</source>
        <translation>%1–%2</translation>
    </message>
    <message>
        <source> at %1</source>
        <translation> 于 %1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>显示 %1</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::HistoryChart</name>
    <message>
        <source>fastest</source>
        <translation>最快</translation>
    </message>
    <message>
        <source>in the mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>centre of mass</source>
        <translation>质心</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>势能</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>动能</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>能量</translation>
    </message>
    <message>
        <source>History curves</source>
        <translation>时程曲线</translation>
    </message>
    <message>
        <source>Click or drag to go to an instant</source>
        <translation>点击或拖动以转到某一时刻</translation>
    </message>
    <message>
        <source>None of them is on its way yet.</source>
        <translation>其中还没有碎块开始运动。</translation>
    </message>
    <message>
        <source>%1; at %2; kinetic %3, potential %4</source>
        <translation>%1；高 %2；动能 %3，势能 %4</translation>
    </message>
    <message>
        <source>History of %1</source>
        <translation>%1 的时程</translation>
    </message>
    <message>
        <source>%1: %2 of fragments, %3 in the mean, %4 the fastest</source>
        <translation>%1：碎块 %2，平均 %3，最快 %4</translation>
    </message>
    <message>
        <source>time, %1</source>
        <translation>时间，%1</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::HistoryPanel</name>
    <message>
        <source>Save table…</source>
        <translation>保存表格…</translation>
    </message>
    <message>
        <source>Save chart…</source>
        <translation>保存图表…</translation>
    </message>
    <message>
        <source>Of what is selected; of all fragments while nothing is. Speeds are those of the bodies that carry them</source>
        <translation>属于选中的内容；未选中时属于所有碎块。速度为承载它们的刚体的速度</translation>
    </message>
    <message>
        <source>Save the figures of every frame as CSV</source>
        <translation>将每一帧的数值保存为 CSV</translation>
    </message>
    <message>
        <source>Save the chart as SVG or PNG</source>
        <translation>将图表保存为 SVG 或 PNG</translation>
    </message>
    <message>
        <source>Kinetic energy without spin; potential energy above the level ground</source>
        <translation>动能不含自转；势能自水平地面算起</translation>
    </message>
    <message>
        <source>Simulate first: there are no curves without a run.</source>
        <translation>请先模拟：没有计算就没有曲线。</translation>
    </message>
    <message>
        <source>%1 · being read…</source>
        <translation>%1 · 正在读取…</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::Inspector</name>
    <message>
        <source>Go to birth</source>
        <translation>转到产生时刻</translation>
    </message>
    <message>
        <source>Show the FE view at the last state at which it is active, with it in the middle</source>
        <translation>在有限元视图中显示其最后激活的状态，并置于中央</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>跟随</translation>
    </message>
    <message>
        <source>Keep the fragment in the middle of the views while time goes on</source>
        <translation>时间推进时将碎块保持在视图中央</translation>
    </message>
    <message>
        <source>Cluster</source>
        <translation>所属聚类</translation>
    </message>
    <message>
        <source>Select all fragments that move with it</source>
        <translation>选择与其一起运动的全部碎块</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>隔离</translation>
    </message>
    <message>
        <source>Hide everything that is not selected</source>
        <translation>隐藏未选择的全部内容</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Leave what is selected out of the views; what it covered appears</source>
        <translation>在视图中略去所选内容；其遮挡的部分将显现</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>不选择任何内容</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>检查器</translation>
    </message>
    <message>
        <source>Nothing selected</source>
        <translation>未选择任何内容</translation>
    </message>
    <message>
        <source>Click an element or a fragment in a view. Ctrl-click adds; dragging with Ctrl adds all in a rectangle.</source>
        <translation>在视图中单击单元或碎块。Ctrl 加单击可添加；按住 Ctrl 拖动可添加矩形内的全部。</translation>
    </message>
    <message>
        <source>Fragment %1</source>
        <translation>碎块 %1</translation>
    </message>
    <message>
        <source>%1 · element %2</source>
        <translation>%1 · 单元 %2</translation>
    </message>
    <message>
        <source>Element %1</source>
        <translation>单元 %1</translation>
    </message>
    <message>
        <source>Element</source>
        <translation>有限单元</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>kg</source>
        <translation>kg</translation>
    </message>
    <message>
        <source>Volume at rest times the density of its component</source>
        <translation>静止体积乘以其构件的密度</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>m³</source>
        <translation>m³</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>静止时</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Shape of the finite element</source>
        <translation>有限单元的形状</translation>
    </message>
    <message>
        <source>material</source>
        <translation>材料类别</translation>
    </message>
    <message>
        <source>Of its component; set in the component tree or the Case panel</source>
        <translation>取自其构件；在构件树或“案例”面板设置</translation>
    </message>
    <message>
        <source>Death</source>
        <translation>失效</translation>
    </message>
    <message>
        <source>Never active.</source>
        <translation>从未激活。</translation>
    </message>
    <message>
        <source>It stays active to the end of the FE result.</source>
        <translation>它在有限元结果结束时仍为激活。</translation>
    </message>
    <message>
        <source>last active</source>
        <translation>最后激活</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>The last state at which the file has it active</source>
        <translation>文件中最后为激活的状态</translation>
    </message>
    <message>
        <source>inactive from</source>
        <translation>自此未激活</translation>
    </message>
    <message>
        <source>The first state that reports it inactive: it died in between</source>
        <translation>首个报告其未激活的状态：它在两者之间失效</translation>
    </message>
    <message>
        <source>died at</source>
        <translation>失效时刻</translation>
    </message>
    <message>
        <source>The exact time that the file gives</source>
        <translation>文件给出的精确时刻</translation>
    </message>
    <message>
        <source>The file gives no cause.</source>
        <translation>文件未给出原因。</translation>
    </message>
    <message>
        <source>Reported by %1; the file gives no cause.</source>
        <translation>由 %1 报告；文件未给出原因。</translation>
    </message>
    <message>
        <source>Journey</source>
        <translation>历程</translation>
    </message>
    <message>
        <source>born at</source>
        <translation>产生于</translation>
    </message>
    <message>
        <source>When it is shown and reported as a fragment</source>
        <translation>作为碎块显示和报告的时刻</translation>
    </message>
    <message>
        <source>speed then</source>
        <translation>当时速度</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>Of its centre of mass</source>
        <translation>其质心的速度</translation>
    </message>
    <message>
        <source>birth x, y, z</source>
        <translation>产生位置 x、y、z</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Centre of mass, as exported tables give it</source>
        <translation>质心，与导出表格一致</translation>
    </message>
    <message>
        <source>Simulate to see where it goes.</source>
        <translation>模拟后可查看其去向。</translation>
    </message>
    <message>
        <source>final x, y, z</source>
        <translation>最终位置 x、y、z</translation>
    </message>
    <message>
        <source>moved in plan</source>
        <translation>平面移动</translation>
    </message>
    <message>
        <source>Level distance from birth to the end</source>
        <translation>从产生到结束的水平距离</translation>
    </message>
    <message>
        <source>fell</source>
        <translation>下落</translation>
    </message>
    <message>
        <source>Height of its birth above its end</source>
        <translation>产生位置高出最终位置的高度</translation>
    </message>
    <message>
        <source>at rest from</source>
        <translation>自此静止</translation>
    </message>
    <message>
        <source>moved with cluster</source>
        <translation>随聚类运动</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Number of the cluster, and of its fragments</source>
        <translation>聚类的编号及其碎块数</translation>
    </message>
    <message>
        <source>Its way is being read …</source>
        <translation>正在读取其轨迹 …</translation>
    </message>
    <message>
        <source>Against the reference</source>
        <translation>与基准相比</translation>
    </message>
    <message>
        <source>error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>Impacts</source>
        <translation>撞击</translation>
    </message>
    <message>
        <source>and %1 weaker ones</source>
        <translation>以及 %1 次较弱的撞击</translation>
    </message>
    <message>
        <source>%1 elements</source>
        <translation>%1 个单元</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>所选</translation>
    </message>
    <message>
        <source>Together</source>
        <translation>合计</translation>
    </message>
    <message>
        <source>dead now</source>
        <translation>现已失效</translation>
    </message>
    <message>
        <source>Inactive in the FE result at the time shown</source>
        <translation>所示时刻在有限元结果中未激活</translation>
    </message>
    <message>
        <source>fragments</source>
        <translation>碎块数</translation>
    </message>
    <message>
        <source>Elements that die in the course of the collapse</source>
        <translation>倒塌过程中失效的单元</translation>
    </message>
    <message>
        <source>born</source>
        <translation>产生时段</translation>
    </message>
    <message>
        <source>First and last birth time</source>
        <translation>首次和末次产生时刻</translation>
    </message>
    <message>
        <source>By component</source>
        <translation>按构件</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>and %1 more components</source>
        <translation>另有 %1 个构件</translation>
    </message>
    <message>
        <source>Since then it has stayed within %1 of its last place</source>
        <translation>此后一直停留在最终位置 %1 之内</translation>
    </message>
    <message>
        <source>Nothing has changed its velocity by more than %1 at once.</source>
        <translation>没有任何一次使其速度变化超过 %1。</translation>
    </message>
    <message>
        <source>Go to this hit: its time, the speed just before, the kinetic energy of the centre just before; the velocity changed by %1</source>
        <translation>转到该次撞击：时刻、撞击前的速度、撞击前质心的动能；速度变化 %1</translation>
    </message>
    <message>
        <source>rose</source>
        <translation>上升</translation>
    </message>
    <message>
        <source>Height of its end above its birth</source>
        <translation>终点高出产生处的高度</translation>
    </message>
    <message>
        <source>%1 (assumed)</source>
        <translation>%1（假定）</translation>
    </message>
    <message>
        <source>Nobody says what this component is made of: guessed from its density.</source>
        <translation>没有说明此构件的材料：按其密度猜测。</translation>
    </message>
    <message>
        <source>It is made of</source>
        <translation>材料是</translation>
    </message>
    <message>
        <source>Say what the component is made of; friction, bounce and break-up follow from it. Ctrl+Z takes it back</source>
        <translation>指定构件的材料；摩擦、回弹和破碎由此确定。Ctrl+Z 可撤销</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Carried by the engine since %1, in a loose island.</source>
        <translation>自 %1 起由引擎带动，属于一个松散的孤立部分。</translation>
    </message>
    <message>
        <source>Centre of mass at %1</source>
        <translation>%1 时的质心</translation>
    </message>
    <message>
        <source>Distance from where the reference has it at %1</source>
        <translation>%1 时与基准位置的距离</translation>
    </message>
    <message>
        <source>%1   %2   %3</source>
        <translation>%1   %2   %3</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::KeptRunsDialog</name>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Remove…</source>
        <translation>移除…</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Kept runs</source>
        <translation>保留的计算</translation>
    </message>
    <message>
        <source>Kept runs of all cases</source>
        <translation>所有案例保留的计算</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>案例</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>结束时间</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>方案</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Open the case and show this run in its views (Enter)</source>
        <translation>打开案例并在视图中显示此计算（回车）</translation>
    </message>
    <message>
        <source>Remove the files of the selected runs (Delete); asks before</source>
        <translation>移除所选计算的文件（Delete）；移除前询问</translation>
    </message>
    <message>
        <source>Bring back what was removed since this window opened (Ctrl+Z)</source>
        <translation>带回此窗口打开以来移除的计算（Ctrl+Z）</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close this window; what was removed is gone then (Esc)</source>
        <translation>关闭此窗口；所移除的随之删除（Esc）</translation>
    </message>
    <message>
        <source>%1 · shown</source>
        <translation>%1 · 显示中</translation>
    </message>
    <message>
        <source>Preferences allow %1 GiB a case.</source>
        <translation>首选项允许每个案例 %1 GiB。</translation>
    </message>
    <message>
        <source>Preferences keep no new runs.</source>
        <translation>首选项不保留新的计算。</translation>
    </message>
    <message>
        <source>No runs are kept. %1</source>
        <translation>没有保留的计算。%1</translation>
    </message>
    <message>
        <source>%1 in all; runs: %2, cases: %3. %4</source>
        <translation>共 %1；计算 %2 次，案例 %3 个。%4</translation>
    </message>
    <message>
        <source>Most has %1: %2.</source>
        <translation>最多的是 %1：%2。</translation>
    </message>
    <message>
        <source>Another program writes it.</source>
        <translation>另一程序正在写入。</translation>
    </message>
    <message>
        <source>It is in the views, so it stays.</source>
        <translation>它正在视图中显示，因此保留。</translation>
    </message>
    <message>
        <source>It is not known which case it belongs to.</source>
        <translation>不知道它属于哪个案例。</translation>
    </message>
    <message>
        <source>%1 is not there any more.</source>
        <translation>%1 已不存在。</translation>
    </message>
    <message>
        <source>Selected: %1, %2</source>
        <translation>已选：%1，%2</translation>
    </message>
    <message>
        <source>Remove the run of %1 that ended %2?</source>
        <translation>移除 %1 于 %2 结束的计算？</translation>
    </message>
    <message>
        <source>Remove %1 runs?</source>
        <translation>移除 %1 次计算？</translation>
    </message>
    <message>
        <source>%1 become free. Undo brings it back as long as the list is open; the entry in the history of the case stays.</source>
        <translation>释放 %1。列表打开期间可用“撤销”带回；案例历史中的条目保留。</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::MapView</name>
    <message>
        <source>Map</source>
        <translation>图</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::MaterialsTable</name>
    <message>
        <source>The components of a result appear here.</source>
        <translation>结果的构件将显示在此。</translation>
    </message>
    <message>
        <source>component</source>
        <translation>构件</translation>
    </message>
    <message>
        <source>material</source>
        <translation>材料类别</translation>
    </message>
    <message>
        <source>reinforced</source>
        <translation>有配筋</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1，共 %2</translation>
    </message>
    <message>
        <source>Open a result first</source>
        <translation>请先打开结果</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::MovieDialog</name>
    <message>
        <source>Movie</source>
        <translation>动画</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Half as fast</source>
        <translation>一半速度</translation>
    </message>
    <message>
        <source>A quarter as fast</source>
        <translation>四分之一速度</translation>
    </message>
    <message>
        <source>A tenth as fast</source>
        <translation>十分之一速度</translation>
    </message>
    <message>
        <source>Twice as fast</source>
        <translation>两倍速度</translation>
    </message>
    <message>
        <source>MP4</source>
        <translation>MP4</translation>
    </message>
    <message>
        <source>Folder of pictures (PNG)</source>
        <translation>图片文件夹 (PNG)</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>至</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>How fast the collapse runs in the movie; other paces than real time are printed on it</source>
        <translation>倒塌在动画中的快慢；非实时的速度会印在动画上</translation>
    </message>
    <message>
        <source>Pictures per second</source>
        <translation>每秒图片数</translation>
    </message>
    <message>
        <source>1 to 120; 25 is usual</source>
        <translation>1 至 120;通常为 25</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Width and height in pixels</source>
        <translation>宽度和高度，像素</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>One file to play, or numbered pictures for other programs</source>
        <translation>一个可播放的文件，或供其他程序使用的编号图片</translation>
    </message>
    <message>
        <source>Numbered pictures; for an MP4 install the program ffmpeg</source>
        <translation>编号图片；如需 MP4 请安装程序 ffmpeg</translation>
    </message>
    <message>
        <source>Save movie…</source>
        <translation>保存动画…</translation>
    </message>
    <message>
        <source>%1 pictures, %2 s to watch</source>
        <translation>%1 张图片，播放 %2 s</translation>
    </message>
    <message>
        <source>The end must come after the beginning, with at most 100,000 pictures between them.</source>
        <translation>结束必须在开始之后，其间最多 100,000 张图片。</translation>
    </message>
    <message>
        <source>Along the camera keys (%1)</source>
        <translation>沿相机关键帧（%1 个）</translation>
    </message>
    <message>
        <source>The camera moves from key to key; without it the movie looks as the views do</source>
        <translation>相机从一个关键帧移动到下一个；不勾选时动画与视图所见相同</translation>
    </message>
    <message>
        <source>Where the movie begins, on the clock of the FE result</source>
        <translation>影片的起点，按有限元结果的时间</translation>
    </message>
    <message>
        <source>Where it ends; the run may go on after the FE result</source>
        <translation>影片的终点；计算可在有限元结果之后继续</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::NewCaseComponents</name>
    <message>
        <source>Components</source>
        <translation>构件列表</translation>
    </message>
    <message>
        <source>Of what the structure is made, and into which parts it falls.</source>
        <translation>结构由什么组成，分为哪些部分。</translation>
    </message>
    <message>
        <source>Back to the parts of the file</source>
        <translation>恢复文件中的部件</translation>
    </message>
    <message>
        <source>Parts of the structure</source>
        <translation>结构的各部分</translation>
    </message>
    <message>
        <source>Choose one to set its material; choose several to join them. The preview marks what is chosen.</source>
        <translation>选一个可设定材料；选多个可合并。预览标出所选内容。</translation>
    </message>
    <message>
        <source>Drop all regrouping</source>
        <translation>放弃全部重新分组</translation>
    </message>
    <message>
        <source>Assumed where nothing is known</source>
        <translation>未知量的假定</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::NewCaseDeaths</name>
    <message>
        <source>elements without volume when they die: they become fragments of the least thickness</source>
        <translation>失效时没有体积的单元：成为最小厚度的碎块</translation>
    </message>
    <message>
        <source>elements turned inside out when they die: their shape is taken by its size</source>
        <translation>失效时内外翻转的单元：按其大小取形状</translation>
    </message>
    <message>
        <source>elements as thin as paper when they die: they become fragments of the least thickness</source>
        <translation>失效时薄如纸的单元：按最小厚度成为碎块</translation>
    </message>
    <message>
        <source>elements whose volume is far from the one at rest when they die</source>
        <translation>失效时体积与静止时相差很大的单元</translation>
    </message>
    <message>
        <source>elements inactive from the first state on: they are no debris</source>
        <translation>从第一个状态起即无效的单元：不是堆积物</translation>
    </message>
    <message>
        <source>elements that only come to life later</source>
        <translation>后来才变为有效的单元</translation>
    </message>
    <message>
        <source>elements that come back to life: “Revived elements” decides</source>
        <translation>恢复有效的单元：由“恢复的单元”决定</translation>
    </message>
    <message>
        <source>elements with a time of death that stay active</source>
        <translation>有失效时刻却保持有效的单元</translation>
    </message>
    <message>
        <source>dead elements without a time of death: the state decides</source>
        <translation>没有失效时刻的失效单元：由状态决定</translation>
    </message>
    <message>
        <source>elements whose time of death is not between the states that report it</source>
        <translation>失效时刻不在报告它的两个状态之间的单元</translation>
    </message>
    <message>
        <source>elements without density: the assumed one is taken</source>
        <translation>没有密度的单元：取假定值</translation>
    </message>
    <message>
        <source>shells and beams without thickness or section: the assumed one is taken</source>
        <translation>没有厚度或截面的壳和梁：取假定值</translation>
    </message>
    <message>
        <source>elements without volume at rest: they have no mass</source>
        <translation>静止时没有体积的单元：没有质量</translation>
    </message>
    <message>
        <source>Deaths</source>
        <translation>失效</translation>
    </message>
    <message>
        <source>What dies when, and how far that can be believed.</source>
        <translation>什么在何时失效，以及可信到什么程度。</translation>
    </message>
    <message>
        <source>Account of every death</source>
        <translation>每次失效的清单</translation>
    </message>
    <message>
        <source>What is odd</source>
        <translation>异常</translation>
    </message>
    <message>
        <source>How the file says it</source>
        <translation>文件如何表明</translation>
    </message>
    <message>
        <source>component</source>
        <translation>构件</translation>
    </message>
    <message>
        <source>dead</source>
        <translation>失效数</translation>
    </message>
    <message>
        <source>of it</source>
        <translation>份额</translation>
    </message>
    <message>
        <source>Share of the component&apos;s mass in dead elements</source>
        <translation>失效单元占构件质量的份额</translation>
    </message>
    <message>
        <source>Deaths by component</source>
        <translation>按构件的失效</translation>
    </message>
    <message>
        <source>Deaths by component; the preview goes to the first one of the row chosen</source>
        <translation>按构件的失效；预览转到所选行的最初一次</translation>
    </message>
    <message>
        <source>The account is being made.</source>
        <translation>正在清点。</translation>
    </message>
    <message>
        <source>No element dies: all %1 are active at the last state. Is the active flag the right one?</source>
        <translation>没有单元失效：全部 %1 个在最后状态仍有效。激活标志是否正确？</translation>
    </message>
    <message>
        <source>%1 of %2 elements are dead at the last state: %3 of %4.</source>
        <translation>%2 个单元中有 %1 个在最后状态已失效：%4 中的 %3。</translation>
    </message>
    <message>
        <source>%1×: %2</source>
        <translation>%1 处：%2</translation>
    </message>
    <message>
        <source>first: %1</source>
        <translation>首例：%1</translation>
    </message>
    <message>
        <source>Nothing odd was found.</source>
        <translation>未发现异常。</translation>
    </message>
    <message>
        <source>first</source>
        <translation>最初</translation>
    </message>
    <message>
        <source>last</source>
        <translation>最后</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::NewCaseGround</name>
    <message>
        <source>Ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>On what the debris falls.</source>
        <translation>堆积物落在什么上面。</translation>
    </message>
    <message>
        <source>Put it at the lowest point</source>
        <translation>置于最低点</translation>
    </message>
    <message>
        <source>Without terrain</source>
        <translation>不用地形</translation>
    </message>
    <message>
        <source>Level ground</source>
        <translation>水平地面</translation>
    </message>
    <message>
        <source>Lowest point of the structure</source>
        <translation>结构的最低点</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>z of its lowest node at rest</source>
        <translation>静止时最低节点的 z</translation>
    </message>
    <message>
        <source>Let the level ground pass through the lowest node of the structure at rest</source>
        <translation>使水平地面通过结构静止时的最低节点</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>地形</translation>
    </message>
    <message>
        <source>A raster of heights takes the place of the level ground where it covers the site.</source>
        <translation>高程栅格在其覆盖场地之处取代水平地面。</translation>
    </message>
    <message>
        <source>Raster of heights</source>
        <translation>高程栅格</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Choose the raster of heights that the debris falls on</source>
        <translation>选择承接堆积物的高程栅格</translation>
    </message>
    <message>
        <source>Let the debris fall on level ground again</source>
        <translation>让堆积物重新落在水平地面上</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>水</translation>
    </message>
    <message>
        <source>The structure ends %1 above this ground.</source>
        <translation>结构止于此地面以上 %1。</translation>
    </message>
    <message>
        <source>The structure reaches %1 below this ground.</source>
        <translation>结构伸入此地面以下 %1。</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::NewCaseSummary</name>
    <message>
        <source>Case</source>
        <translation>案例</translation>
    </message>
    <message>
        <source>What the case is called, and what was settled.</source>
        <translation>案例的名称，以及已确定的内容。</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Name of the case</source>
        <translation>案例名称</translation>
    </message>
    <message>
        <source>As it stands in the title of the window and in reports</source>
        <translation>显示在窗口标题和报告中</translation>
    </message>
    <message>
        <source>First scenario</source>
        <translation>第一个方案</translation>
    </message>
    <message>
        <source>What these settings are called among others of the case</source>
        <translation>这些设置在案例各方案中的名称</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>What is known of this analysis, and by whom it was made</source>
        <translation>关于此分析的已知情况以及由谁完成</translation>
    </message>
    <message>
        <source>Kept with the scenario</source>
        <translation>随方案保存</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>已确定</translation>
    </message>
    <message>
        <source>FE result</source>
        <translation>有限元结果</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>向上</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>构件列表</translation>
    </message>
    <message>
        <source>Steps of regrouping</source>
        <translation>重新分组步骤</translation>
    </message>
    <message>
        <source>Fragments</source>
        <translation>碎块</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::NewCaseUnits</name>
    <message>
        <source>Units and axes</source>
        <translation>单位与轴</translation>
    </message>
    <message>
        <source>What the numbers of the file mean.</source>
        <translation>文件中的数值是什么意思。</translation>
    </message>
    <message>
        <source>Units of the file</source>
        <translation>文件单位</translation>
    </message>
    <message>
        <source>Which axis points up</source>
        <translation>哪个轴向上</translation>
    </message>
    <message>
        <source>What follows from that</source>
        <translation>由此得出</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>结构</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Length, width and height at rest, along x, y and z</source>
        <translation>静止时沿 x、y、z 的长、宽、高</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Of all elements, by the densities of their components</source>
        <translation>全部单元的质量，按其构件的密度</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>First and last state</source>
        <translation>最初和最后的状态</translation>
    </message>
    <message>
        <source>States</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>units</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>what speaks for or against them</source>
        <translation>支持或反对的依据</translation>
    </message>
    <message>
        <source>Systems of units, the best fit first</source>
        <translation>单位制，最相符者在先</translation>
    </message>
    <message>
        <source>Take %1</source>
        <translation>采用 %1</translation>
    </message>
    <message>
        <source>Let %1 point up</source>
        <translation>以 %1 向上</translation>
    </message>
    <message>
        <source>Read the file again in the units that it fits best</source>
        <translation>按最相符的单位重新读取文件</translation>
    </message>
    <message>
        <source>Read the file again with the axis against which free nodes fall pointing up</source>
        <translation>以自由节点下落的反方向为向上轴重新读取文件</translation>
    </message>
    <message>
        <source>%1 (taken)</source>
        <translation>%1（已采用）</translation>
    </message>
    <message>
        <source>nothing in the file speaks for or against them</source>
        <translation>文件中没有支持或反对的依据</translation>
    </message>
    <message>
        <source>Systems of units, the best fit first: densities, size and free fall judge them. A click takes one</source>
        <translation>单位制，最符合的在前：由密度、尺寸和自由落体判断。单击即采用</translation>
    </message>
    <message>
        <source>%1: kilograms, metres and seconds, unless the case names another unit of length.
%2: the system that the densities, size and free fall of the file fit, if only one does.</source>
        <translation>%1：千克、米、秒，除非案例指定了其他长度单位。
%2：文件中的密度、尺寸和自由落体相符的单位制，仅当只有一种相符时。</translation>
    </message>
    <message>
        <source>%1: the axis that the case names, z where it names none.
%2: the one against which free nodes are seen to fall.</source>
        <translation>%1：案例指定的轴，未指定时为 z。
%2：自由结点下落方向的反向。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::NewCaseWizard</name>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>上一步(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>下一步(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Make the case</source>
        <translation>建立案例(&amp;M)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>New case from %1</source>
        <translation>由 %1 新建案例</translation>
    </message>
    <message>
        <source>Steps and preview</source>
        <translation>步骤与预览</translation>
    </message>
    <message>
        <source>1  Units and axes</source>
        <translation>1  单位与轴</translation>
    </message>
    <message>
        <source>2  Ground</source>
        <translation>2  地面</translation>
    </message>
    <message>
        <source>3  Components</source>
        <translation>3  构件列表</translation>
    </message>
    <message>
        <source>4  Deaths</source>
        <translation>4  失效</translation>
    </message>
    <message>
        <source>5  Case</source>
        <translation>5  案例</translation>
    </message>
    <message>
        <source>Go to this step (Ctrl+%1)</source>
        <translation>转到这一步 (Ctrl+%1)</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Stop what is being read or counted</source>
        <translation>停止正在进行的读取或清点</translation>
    </message>
    <message>
        <source>Open the case in the window; it is saved when you say so</source>
        <translation>在窗口中打开案例；由您决定何时保存</translation>
    </message>
    <message>
        <source>To the step before</source>
        <translation>到上一步</translation>
    </message>
    <message>
        <source>To the next step</source>
        <translation>到下一步</translation>
    </message>
    <message>
        <source>Leave without a case (Esc)</source>
        <translation>不建立案例而离开 (Esc)</translation>
    </message>
    <message>
        <source>Nothing to take back</source>
        <translation>没有可撤销的内容</translation>
    </message>
    <message>
        <source>Undo %1 (Ctrl+Z)</source>
        <translation>撤销 %1 (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Nothing to make again</source>
        <translation>没有可重做的内容</translation>
    </message>
    <message>
        <source>Redo %1 (Ctrl+Shift+Z)</source>
        <translation>重做 %1 (Ctrl+Shift+Z)</translation>
    </message>
    <message>
        <source>Densities of no material</source>
        <translation>没有材料有的密度</translation>
    </message>
    <message>
        <source>No material has the density of %1 in these units.</source>
        <translation>按这些单位，没有材料具有 %1 的密度。</translation>
    </message>
    <message>
        <source>Masses, and all that follows from them, would be wrong by the same factor. Choose the units that the file is in, or set the densities under Components.</source>
        <translation>质量以及由其得出的一切都会错同样的倍数。请选择文件所用的单位，或在“构件”中设置密度。</translation>
    </message>
    <message>
        <source>Back to the units</source>
        <translation>返回单位</translation>
    </message>
    <message>
        <source>Go on all the same</source>
        <translation>仍然继续</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::Panel</name>
    <message>
        <source>Open a result first</source>
        <translation>请先打开结果</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::ParameterEditor</name>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>自动</translation>
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
        <source>Let Rubble choose this value</source>
        <translation>由 Rubble 选择此值</translation>
    </message>
    <message>
        <source>auto: %1</source>
        <translation>自动：%1</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>“%1”不是数值。</translation>
    </message>
    <message>
        <source>A whole number is needed.</source>
        <translation>需要整数。</translation>
    </message>
    <message>
        <source>Between %1 and %2, please.</source>
        <translation>请输入 %1 至 %2 之间的值。</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>从 %1 到 %2</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::PhotoPairs</name>
    <message>
        <source>behind</source>
        <translation>在后方</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>有误</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>添加点</translation>
    </message>
    <message>
        <source>From table…</source>
        <translation>从表格…</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Point pairs</source>
        <translation>点对</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>residual, px</source>
        <translation>残差，px</translation>
    </message>
    <message>
        <source>How far the point that was clicked lies from where the camera sees it, pixels</source>
        <translation>所单击的点与相机所见位置的距离，像素</translation>
    </message>
    <message>
        <source>Click a point in the photograph, then the same point in the model beside it (Shift+A)</source>
        <translation>单击照片中的一点，然后单击旁边模型中的同一点 (Shift+A)</translation>
    </message>
    <message>
        <source>Read pairs from a table with the columns of rubble-cli camera, for surveyed points</source>
        <translation>从具有命令行相机匹配各列的表格读取点对，用于测绘点</translation>
    </message>
    <message>
        <source>Delete the chosen pair (Delete)</source>
        <translation>删除所选点对（Delete）</translation>
    </message>
    <message>
        <source>Name of the point</source>
        <translation>点名</translation>
    </message>
    <message>
        <source>Name of the point: pier 1, top west corner</source>
        <translation>点名：1 号墩西上角</translation>
    </message>
    <message>
        <source>picture x</source>
        <translation>照片 x</translation>
    </message>
    <message>
        <source>picture y</source>
        <translation>照片 y</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>%1: where the photograph shows the point, pixels from the upper left corner</source>
        <translation>%1：该点在照片中的位置，自左上角起的像素</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>name of point %1</source>
        <translation>点 %1 的名称</translation>
    </message>
    <message>
        <source>%1 (%2 px)</source>
        <translation>%1（%2 px）</translation>
    </message>
    <message>
        <source>%1 (behind the camera)</source>
        <translation>%1（相机后方）</translation>
    </message>
    <message>
        <source>Point %1 disagrees with the other %2 and takes no part.</source>
        <translation>点 %1 与其余 %2 个不符，不参与计算。</translation>
    </message>
    <message>
        <source>Points %1 disagree with the other %2 and take no part.</source>
        <translation>这些点（%1）与其余 %2 个不符，不参与计算。</translation>
    </message>
    <message>
        <source>Move them on the photograph, click their counterparts anew, or delete them.</source>
        <translation>请在照片上移动它们，重新单击其对应点，或将其删除。</translation>
    </message>
    <message>
        <source>place of point %1</source>
        <translation>点 %1 的位置</translation>
    </message>
    <message>
        <source>point %1 deleted</source>
        <translation>点 %1 已删除</translation>
    </message>
    <message>
        <source>%1 of the point of the model or survey, in the frame of the case</source>
        <translation>模型或测绘点的 %1，在案例坐标框架中</translation>
    </message>
    <message>
        <source>no.</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Number of the pair, as it stands in the photograph and in the model</source>
        <translation>点对的编号，与照片和模型中的一致</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::PhotoView</name>
    <message>
        <source>debris outline</source>
        <translation>堆积物轮廓</translation>
    </message>
    <message>
        <source>moved by rescuers</source>
        <translation>被救援移走</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>被遮挡</translation>
    </message>
    <message>
        <source>not debris</source>
        <translation>非堆积物</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>照片</translation>
    </message>
    <message>
        <source>Photographs of the site appear here: drop them on the window, or add them at the left.</source>
        <translation>现场照片显示在此：拖放到窗口，或在左侧添加。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::PlaceChoice</name>
    <message>
        <source>Asking Slurm…</source>
        <translation>正在询问 Slurm…</translation>
    </message>
    <message>
        <source>Run on</source>
        <translation>运行于</translation>
    </message>
    <message>
        <source>this machine</source>
        <translation>本机</translation>
    </message>
    <message>
        <source>Slurm cluster</source>
        <translation>Slurm 集群</translation>
    </message>
    <message>
        <source>Who simulates: this machine, or a Slurm cluster that shares the cache folder with it, with one task for each world</source>
        <translation>由谁模拟：本机，或与本机共用缓存文件夹的 Slurm 集群，每个世界一项任务</translation>
    </message>
    <message>
        <source>Options of sbatch</source>
        <translation>sbatch 选项</translation>
    </message>
    <message>
        <source>More options for sbatch, separated by spaces. Time and memory are asked for by themselves</source>
        <translation>更多 sbatch 选项，以空格分隔。时间和内存会自动请求</translation>
    </message>
    <message>
        <source>Slurm cluster: %1</source>
        <translation>Slurm 集群：%1</translation>
    </message>
    <message>
        <source>The window may be closed meanwhile: the worlds go on, and the case finds them again.</source>
        <translation>其间可以关闭窗口：各世界继续进行，案例会再次找到它们。</translation>
    </message>
    <message>
        <source>Slurm cluster (not reached)</source>
        <translation>Slurm 集群（无法连接）</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::PlacePairsDialog</name>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Remove pair</source>
        <translation>移除点对</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>全部移除</translation>
    </message>
    <message>
        <source>Place the survey by pairs</source>
        <translation>按点对放置测绘</translation>
    </message>
    <message>
        <source>Place survey</source>
        <translation>放置测绘</translation>
    </message>
    <message>
        <source>Survey from above</source>
        <translation>从上方所见的测绘</translation>
    </message>
    <message>
        <source>Model beside the survey</source>
        <translation>测绘旁的模型</translation>
    </message>
    <message>
        <source>There is nothing of the model there: click on the structure, a fragment or the ground.</source>
        <translation>该处没有模型：请单击结构、碎块或地面。</translation>
    </message>
    <message>
        <source>pair</source>
        <translation>点对</translation>
    </message>
    <message>
        <source>Δx, m</source>
        <translation>Δx，m</translation>
    </message>
    <message>
        <source>Δy, m</source>
        <translation>Δy，m</translation>
    </message>
    <message>
        <source>Δz, m</source>
        <translation>Δz，m</translation>
    </message>
    <message>
        <source>apart, m</source>
        <translation>相距，m</translation>
    </message>
    <message>
        <source>What is left of each pair</source>
        <translation>每对的剩余量</translation>
    </message>
    <message>
        <source>Where the place belongs less where the move of all pairs brings it, m</source>
        <translation>该处应在的位置减去全部点对的移动所到的位置，m</translation>
    </message>
    <message>
        <source>Take back the last click (Ctrl+Z)</source>
        <translation>撤回上一次单击 (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Nothing was surveyed there: click where the survey has heights.</source>
        <translation>该处没有测绘：请单击有高程的地方。</translation>
    </message>
    <message>
        <source>Cancel leaves without placing the survey.</source>
        <translation>“取消”离开而不放置测绘。</translation>
    </message>
    <message>
        <source>Moved by %1 m, turned by %2°.</source>
        <translation>移动 %1 m，转动 %2°。</translation>
    </message>
    <message>
        <source>RMS of the pairs %1 m; places known to %2 m (standard deviation).</source>
        <translation>点对的均方根 %1 m；位置的标准差 %2 m。</translation>
    </message>
    <message>
        <source>The survey has a height every %1 m: a click is no better.</source>
        <translation>测绘每 %1 m 有一个高程：单击不会更准。</translation>
    </message>
    <message>
        <source>Now click the same place in the model, at the right; nodes are caught. Esc takes the click back.</source>
        <translation>现在在右侧的模型中单击同一处；会捕捉节点。Esc 撤回单击。</translation>
    </message>
    <message>
        <source>Now click the same place in the survey, at the left. Esc takes the click back.</source>
        <translation>现在在左侧的测绘中单击同一处。Esc 撤回单击。</translation>
    </message>
    <message>
        <source>Click a place that did not move in the survey, then the same place in the model. Pairs: %1 of at least 3, far apart and not on a line.</source>
        <translation>在测绘中单击没有移动的一处，再在模型中单击同一处。点对：%1，至少 3 对，相距要远且不在一条线上。</translation>
    </message>
    <message>
        <source>Place the survey, or add pairs: more of them show better how well it lies.</source>
        <translation>可放置测绘，或添加点对：点对越多，越能看出放置得如何。</translation>
    </message>
    <message>
        <source>Keep as table…</source>
        <translation>存为表…</translation>
    </message>
    <message>
        <source>Write the pairs as a table that Pairs from a table… and the command line take</source>
        <translation>把点对写成表，“取自表的点对…”和命令行可以读取</translation>
    </message>
    <message>
        <source>How accurate the places of the case are is not known, and not in it.</source>
        <translation>案例中各处的精度未知，未计入其中。</translation>
    </message>
    <message>
        <source>Accuracy of the places in the case</source>
        <translation>案例中位置的精度</translation>
    </message>
    <message>
        <source>Places in the case known to, m</source>
        <translation>案例中位置的精度，m</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Standard deviation along each axis of the places clicked in the model, as who measured or modelled them states it; it is part of the error of the registration</source>
        <translation>在模型中点击的位置沿每个轴的标准差，由测量或建模者给出；计入配准误差</translation>
    </message>
    <message>
        <source>The accuracy of the places of the case is in it.</source>
        <translation>案例中位置的精度已计入其中。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::PointBox</name>
    <message>
        <source>Points in the views</source>
        <translation>在视图中显示点</translation>
    </message>
    <message>
        <source>Normal scale</source>
        <translation>法向尺度</translation>
    </message>
    <message>
        <source>Projection scale</source>
        <translation>投影尺度</translation>
    </message>
    <message>
        <source>Depth of the cylinder</source>
        <translation>圆柱的深度</translation>
    </message>
    <message>
        <source>Registration error</source>
        <translation>配准误差</translation>
    </message>
    <message>
        <source>Measure distances</source>
        <translation>量取距离</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Draws the points of this cloud where it lies in the case. They are read from an octree in levels of detail, which is made once beside the cloud</source>
        <translation>在案例中点云所在之处画出其各点。点按细节层次从八叉树读取，八叉树在点云旁生成一次</translation>
    </message>
    <message>
        <source>colours of the file</source>
        <translation>文件的颜色</translation>
    </message>
    <message>
        <source>by height</source>
        <translation>按高度</translation>
    </message>
    <message>
        <source>by class</source>
        <translation>按类别</translation>
    </message>
    <message>
        <source>by distance to the run</source>
        <translation>按到计算的距离</translation>
    </message>
    <message>
        <source>What the colours of the points say</source>
        <translation>点的颜色所表示的内容</translation>
    </message>
    <message>
        <source>Colours of the file, else intensity, else height; height; class; or the measured distance to the simulated site</source>
        <translation>文件的颜色，没有则为强度，再没有则为高度；高度；类别；或量得的到模拟现场的距离</translation>
    </message>
    <message>
        <source>Adds the pictures in this cloud that have a pinhole and a pose as photographs with that camera; their files are written beside the case</source>
        <translation>把此点云中带针孔相机和位姿的图片作为带该相机的照片加入；其文件写在案例旁</translation>
    </message>
    <message>
        <source>as known</source>
        <translation>按已知</translation>
    </message>
    <message>
        <source>Radius within which points of the cloud give the local normal, m: several times their spacing</source>
        <translation>点云各点给出局部法向的半径，m：点间距的数倍</translation>
    </message>
    <message>
        <source>Radius of the cylinder along the normal in which cloud and site are averaged, m: 20 points or more should fall into it</source>
        <translation>沿法向的圆柱的半径，点云和现场在其中取平均，m：其中应有 20 个或更多的点</translation>
    </message>
    <message>
        <source>Of the cylinder to each side, m: more than the largest distance</source>
        <translation>圆柱向每一侧的长度，m：大于最大的距离</translation>
    </message>
    <message>
        <source>By which the cloud may be out of place, m. Left empty it is that of its registration or its offset error</source>
        <translation>点云可能错开的量，m。留空则取其配准误差或偏移误差</translation>
    </message>
    <message>
        <source>Normal scale, m</source>
        <translation>法向尺度，m</translation>
    </message>
    <message>
        <source>Projection scale, m</source>
        <translation>投影尺度，m</translation>
    </message>
    <message>
        <source>Depth, m</source>
        <translation>深度，m</translation>
    </message>
    <message>
        <source>Registration error, m</source>
        <translation>配准误差，m</translation>
    </message>
    <message>
        <source>Measures from points of the cloud to the simulated site along the local normal (M3C2) and colours those that differ by more than the level of detection at 95 %</source>
        <translation>沿局部法向（M3C2）从点云的点量到模拟现场，并为差别超过 95 % 检测限的点着色</translation>
    </message>
    <message>
        <source>Add its photographs: %1</source>
        <translation>添加其中的照片：%1</translation>
    </message>
    <message>
        <source>Cells of the volumes</source>
        <translation>体积的单元</translation>
    </message>
    <message>
        <source>as the cloud says</source>
        <translation>如点云所写</translation>
    </message>
    <message>
        <source>Save distances…</source>
        <translation>保存距离…</translation>
    </message>
    <message>
        <source>Give the scanners</source>
        <translation>给出扫描仪</translation>
    </message>
    <message>
        <source>State the error</source>
        <translation>给出误差</translation>
    </message>
    <message>
        <source>no volumes</source>
        <translation>不求体积</translation>
    </message>
    <message>
        <source>Side of the square cells over which cut, fill and net are summed straight up, m; left empty none are. Where nobody stated the registration error, their systematic error is not known</source>
        <translation>竖直方向累计挖方、填方和净值所用的方形单元的边长，m；留空则不求。无人给出配准误差时，其系统误差未知</translation>
    </message>
    <message>
        <source>Volume cells, m</source>
        <translation>体积单元，m</translation>
    </message>
    <message>
        <source>Scanners</source>
        <translation>扫描仪</translation>
    </message>
    <message>
        <source>Writes the measured places with distance, level of detection and roughness as a cloud (LAS, PLY) or a table (CSV)</source>
        <translation>把量得之处连同距离、检测限和粗糙度写成点云（LAS、PLY）或表格（CSV）</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::PredictionBox</name>
    <message>
        <source>Said before the run, and measured</source>
        <translation>计算前的预测与实测</translation>
    </message>
    <message>
        <source>Predicted for this setting …</source>
        <translation>此设置的预测 …</translation>
    </message>
    <message>
        <source>Predicted for this setting</source>
        <translation>此设置的预测</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>was not predicted</source>
        <translation>未作预测</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>said: %1</source>
        <translation>预测：%1</translation>
    </message>
    <message>
        <source>said: %1 – held</source>
        <translation>预测：%1 – 符合</translation>
    </message>
    <message>
        <source>said: %1 – missed</source>
        <translation>预测：%1 – 不符</translation>
    </message>
    <message>
        <source>From the calibration of this machine alone: piles of other collapses.</source>
        <translation>仅依据本机标定：其他倒塌的堆积体。</translation>
    </message>
    <message>
        <source>From %1 earlier points of this collapse.</source>
        <translation>依据此倒塌的 %1 个已有点。</translation>
    </message>
    <message>
        <source>Four runs in five end in this interval.</source>
        <translation>五次计算中有四次落在此区间。</translation>
    </message>
    <message>
        <source>Not known: %1 (%2).</source>
        <translation>未知：%1（%2）。</translation>
    </message>
    <message>
        <source>How to find out</source>
        <translation>如何得知</translation>
    </message>
    <message>
        <source>crude: %1</source>
        <translation>粗略：%1</translation>
    </message>
    <message>
        <source>Crude: from bodies, their births and what this machine did within a second. Settings that were compared make it better.</source>
        <translation>粗略：由刚体数、其产生时刻和本机一秒内的表现得出。比较过的设置会使其更好。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>In force at once, for all cases. None of this changes a result.</source>
        <translation>立即生效，适用于所有案例。均不改变任何结果。</translation>
    </message>
    <message>
        <source>As delivered</source>
        <translation>恢复默认</translation>
    </message>
    <message>
        <source>Give back all preferences as Rubble comes with them</source>
        <translation>将所有首选项恢复为 Rubble 的默认值</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>外观</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Language of the window, with its numbers and dates; files stay the same in every language</source>
        <translation>窗口的语言及其数值和日期格式；文件在任何语言下都相同</translation>
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
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Light or dark</source>
        <translation>浅色或深色</translation>
    </message>
    <message>
        <source>Vermilion on stone grey</source>
        <translation>朱红碎块，石灰色结构</translation>
    </message>
    <message>
        <source>Yellow on dark grey</source>
        <translation>黄色碎块，深灰色结构</translation>
    </message>
    <message>
        <source>Fragments and structure</source>
        <translation>碎块与结构</translation>
    </message>
    <message>
        <source>Colours of fragments on the active structure. Both pairs can be told apart by the colour-blind; yellow on dark grey also in print without colour</source>
        <translation>激活结构上碎块的颜色。两组颜色色觉障碍者均可分辨；黄色配深灰色在无彩色打印时也可分辨</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>工作</translation>
    </message>
    <message>
        <source>all (%1)</source>
        <translation>全部（%1）</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>线程</translation>
    </message>
    <message>
        <source>How many threads one piece of work may use, from 0 (all) to %1. No result depends on it, times do</source>
        <translation>一项工作可使用的线程数，0（全部）至 %1。不影响任何结果，只影响耗时</translation>
    </message>
    <message>
        <source>Memory for playback</source>
        <translation>回放内存</translation>
    </message>
    <message>
        <source>How much memory states of the FE result and frames of the run may take, from %1 to %2 MiB; what does not fit is read again. For results and runs opened from now on</source>
        <translation>有限元结果的状态和计算的帧可占用的内存，%1 至 %2 MiB；放不下的会重新读取。适用于此后打开的结果和计算</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Autosave</source>
        <translation>自动保存</translation>
    </message>
    <message>
        <source>Seconds between two copies of a changed case that are kept for recovery, from 0 (none) to %1</source>
        <translation>已更改的案例两次恢复副本之间的秒数，0（不保存）至 %1</translation>
    </message>
    <message>
        <source>Keep copies of results</source>
        <translation>保留结果副本</translation>
    </message>
    <message>
        <source>Keep a compressed copy of every FE result that is read: it opens at once next time</source>
        <translation>为读取的每个有限元结果保留压缩副本：下次可立即打开</translation>
    </message>
    <message>
        <source>SI: m, kg, s</source>
        <translation>SI：m、kg、s</translation>
    </message>
    <message>
        <source>mm, t, s</source>
        <translation>mm、t、s</translation>
    </message>
    <message>
        <source>US customary: ft, lb, s</source>
        <translation>美制：ft、lb、s</translation>
    </message>
    <message>
        <source>Units on screen</source>
        <translation>屏幕单位</translation>
    </message>
    <message>
        <source>Units of quantities that panels, docks and views show and take. Cases, runs, tables and figures stay in SI, and so do the comparisons of the Accuracy panel</source>
        <translation>面板、停靠窗和视图显示及接受的量的单位。案例、计算、表格和图保持 SI，“精度”面板的比较也是如此</translation>
    </message>
    <message>
        <source>Simplify moving views</source>
        <translation>简化运动中的视图</translation>
    </message>
    <message>
        <source>Draw large models with less detail while they move, where this machine draws fewer than 50 pictures a second; the legend says so. Counts, picking and figures keep every detail</source>
        <translation>若本机每秒绘制不足 50 幅，大模型在运动时以较少细节绘制，图例会注明。计数、拾取和图保留全部细节</translation>
    </message>
    <message>
        <source>none</source>
        <translation>不保留</translation>
    </message>
    <message>
        <source>Keep runs, up to</source>
        <translation>保留计算，至多</translation>
    </message>
    <message>
        <source>Room for the runs of a case, cancelled ones too, from 0 (none) to %1 GiB; the oldest make room for new ones. The Run panel lists them</source>
        <translation>一个案例的计算可占用的空间，取消的也计入，0（不保留）至 %1 GiB；最旧的为新的让出空间。计算面板列出它们</translation>
    </message>
    <message>
        <source>beside each case</source>
        <translation>在各案例旁</translation>
    </message>
    <message>
        <source>Folder of kept runs</source>
        <translation>保留计算的文件夹</translation>
    </message>
    <message>
        <source>Where runs are kept; empty: in a folder beside the case, and with the program&apos;s own state for one that was never saved</source>
        <translation>计算保留在何处；空：在案例旁的文件夹中，从未保存过的案例则在程序的状态文件夹中</translation>
    </message>
    <message>
        <source>Kept runs…</source>
        <translation>保留的计算…</translation>
    </message>
    <message>
        <source>The runs that are kept of all cases, with their sizes: open or remove them</source>
        <translation>所有案例保留的计算及其大小：可打开或移除</translation>
    </message>
    <message>
        <source>Presentation: materials</source>
        <translation>展示：材料</translation>
    </message>
    <message>
        <source>Analysis: fragments in colour</source>
        <translation>分析：着色碎块</translation>
    </message>
    <message>
        <source>Style of the views</source>
        <translation>视图样式</translation>
    </message>
    <message>
        <source>What views begin with: components in the look of their materials, or fragments set off from the structure</source>
        <translation>视图开始时的样式：构件呈现其材料的外观，或碎块与结构相区别</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::ReadingBox</name>
    <message>
        <source>Coordinate system of the cloud</source>
        <translation>点云的坐标系</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>如文件所写</translation>
    </message>
    <message>
        <source>EPSG code such as EPSG:25832, WKT or PROJ, of a file that names no system. Kept in the case</source>
        <translation>未写明坐标系的文件的坐标系：EPSG 代码（例如 EPSG:25832）、WKT 或 PROJ。保存在案例中</translation>
    </message>
    <message>
        <source>System</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>Columns of the table</source>
        <translation>表的列</translation>
    </message>
    <message>
        <source>as its heading says</source>
        <translation>如表头所写</translation>
    </message>
    <message>
        <source>Columns of a table in their order, parted by commas: x, y, z, intensity, red, green, blue, class, return, returns, time; skip for others. Kept in the case</source>
        <translation>表的各列，按次序以逗号分隔：x, y, z, intensity, red, green, blue, class, return, returns, time；其他列写 skip。保存在案例中</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::ReadingDialog</name>
    <message>
        <source>How %1 is read</source>
        <translation>%1 的读取方式</translation>
    </message>
    <message>
        <source>Add survey</source>
        <translation>添加测绘</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::RegroupForm</name>
    <message>
        <source>Merge…</source>
        <translation>合并…</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>重命名…</translation>
    </message>
    <message>
        <source>Split…</source>
        <translation>分割…</translation>
    </message>
    <message>
        <source>New name</source>
        <translation>新名称</translation>
    </message>
    <message>
        <source>by what hangs together</source>
        <translation>按连通性</translation>
    </message>
    <message>
        <source>by a plane</source>
        <translation>用平面</translation>
    </message>
    <message>
        <source>by a box</source>
        <translation>用盒</translation>
    </message>
    <message>
        <source>How to split</source>
        <translation>分割方式</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>法向</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Select components in the table first</source>
        <translation>请先在表中选择构件</translation>
    </message>
    <message>
        <source>Join the selected components into one</source>
        <translation>将所选构件合并为一个</translation>
    </message>
    <message>
        <source>Give the selected component another name</source>
        <translation>为所选构件另取名称</translation>
    </message>
    <message>
        <source>Split the selected component</source>
        <translation>分割所选构件</translation>
    </message>
    <message>
        <source>Join %1 into one component</source>
        <translation>将 %1 合并为一个构件</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>Split %1</source>
        <translation>分割 %1</translation>
    </message>
    <message>
        <source>%1 part</source>
        <translation>%1 部分</translation>
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
        <source>“To” must lie beyond “From” along every axis.</source>
        <translation>“到”在每个轴上都必须大于“从”。</translation>
    </message>
    <message>
        <source>The normal must not be zero.</source>
        <translation>法向不能为零。</translation>
    </message>
    <message>
        <source>A name is needed.</source>
        <translation>需要名称。</translation>
    </message>
    <message>
        <source>There is a component “%1” already.</source>
        <translation>已有构件“%1”。</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Three numbers are needed in each row.</source>
        <translation>每行需要三个数值。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::RemovalBox</name>
    <message>
        <source>Write date and time, such as 2021-06-25 16:30</source>
        <translation>请写日期和时间，如 2021-06-25 16:30</translation>
    </message>
    <message>
        <source>What was removed</source>
        <translation>被运走之物</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Add a place whose debris rescuers took away; say first from when on it was gone</source>
        <translation>添加救援人员运走堆积物的一处；请先说明自何时起已运走</translation>
    </message>
    <message>
        <source>Draw what was removed</source>
        <translation>绘制被运走之物</translation>
    </message>
    <message>
        <source>What was removed from a file…</source>
        <translation>从文件取被运走之物…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Remove the chosen place from the list</source>
        <translation>从列表中移除所选的一处</translation>
    </message>
    <message>
        <source>Gone since</source>
        <translation>运走时间</translation>
    </message>
    <message>
        <source>From when on it was gone</source>
        <translation>自何时起已运走</translation>
    </message>
    <message>
        <source>date and time</source>
        <translation>日期和时间</translation>
    </message>
    <message>
        <source>Date and time by the clock of the site, such as 2021-06-25 16:30: of the chosen place, or of the next one. Surveys taken later are compared without it. Kept in the case</source>
        <translation>按现场时钟的日期和时间，如 2021-06-25 16:30：所选一处的，或下一处的。此后拍摄的测绘比较时不计该处。保存在案例中</translation>
    </message>
    <message>
        <source>Places whose debris was removed</source>
        <translation>堆积物被运走的各处</translation>
    </message>
    <message>
        <source>since %1: %2, places: %3</source>
        <translation>自 %1 起：%2，处数：%3</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::ReportPanel</name>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>What was asked, what was found, and how sure that is.</source>
        <translation>问了什么，发现了什么，有多大把握。</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Question of the report</source>
        <translation>报告的问题</translation>
    </message>
    <message>
        <source>What the report is to answer, in your words; it stands in its first section</source>
        <translation>报告要回答什么，用您的话；写在第一节</translation>
    </message>
    <message>
        <source>Where did the debris go, and how sure is that?</source>
        <translation>碎块去了哪里，有多大把握？</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>编制者</translation>
    </message>
    <message>
        <source>Who makes the report; stands on its first page</source>
        <translation>谁编制报告；写在首页</translation>
    </message>
    <message>
        <source>Made for the report</source>
        <translation>为报告所做</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>重复计算</translation>
    </message>
    <message>
        <source>How often the run is simulated again with births shifted by a micrometre, 0 to 20: the spread of every result. Each takes as long as the run</source>
        <translation>该计算以产生位置移动一微米重新模拟的次数，0 至 20:得出每项结果的离散。每次耗时与该计算相同</translation>
    </message>
    <message>
        <source>laws of mechanics</source>
        <translation>力学定律</translation>
    </message>
    <message>
        <source>all cases</source>
        <translation>全部算例</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>自检</translation>
    </message>
    <message>
        <source>Hard cases of the simulation, run on this machine: those a law predicts take seconds, all of them minutes</source>
        <translation>在本机上运行的模拟困难算例：有定律可循的只需几秒，全部需要几分钟</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Write report…</source>
        <translation>写报告…</translation>
    </message>
    <message>
        <source>Stop; nothing half-made is left</source>
        <translation>停止；不留下半成品</translation>
    </message>
    <message>
        <source>Choose a folder; it gets report.pdf and report.html, each complete in itself</source>
        <translation>选择文件夹；其中将写入 report.pdf 和 report.html,各自完整</translation>
    </message>
    <message>
        <source>Written to &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;</source>
        <translation>已写入 &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;</translation>
    </message>
    <message>
        <source>Simulates the run and its repeats again: up to about %1.</source>
        <translation>重新模拟此次计算及其重复：最多约 %1。</translation>
    </message>
    <message>
        <source>Simulates the run and its repeats again, each as long as the run took.</source>
        <translation>重新模拟此次计算及其重复，每次耗时与此次计算相同。</translation>
    </message>
    <message>
        <source>Without repeats the report cannot say how far the run repeats itself.</source>
        <translation>没有重复，报告无法说明此次计算的重复性如何。</translation>
    </message>
    <message>
        <source>Who makes the report</source>
        <translation>报告编制者</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>In your words</source>
        <translation>用您的话</translation>
    </message>
    <message>
        <source>Summary in plain language</source>
        <translation>通俗摘要</translation>
    </message>
    <message>
        <source>On one page, for readers who are no engineers; a chapter of the report</source>
        <translation>不超过一页，供非工程师阅读；作为报告的一章</translation>
    </message>
    <message>
        <source>Custody</source>
        <translation>材料的保管</translation>
    </message>
    <message>
        <source>Who held the material before it came here, and what was done to it</source>
        <translation>材料到此之前由谁保管，以及对其做过什么</translation>
    </message>
    <message>
        <source>Other causes</source>
        <translation>其他原因</translation>
    </message>
    <message>
        <source>Which other causes were considered, and how each was excluded</source>
        <translation>考虑过哪些其他原因，以及如何逐一排除</translation>
    </message>
    <message>
        <source>What would change the opinion</source>
        <translation>什么会改变意见</translation>
    </message>
    <message>
        <source>Findings that would make you say something else</source>
        <translation>会使您得出不同结论的发现</translation>
    </message>
    <message>
        <source>of the page Causes</source>
        <translation>原因页的</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>What it lacks</source>
        <translation>缺少什么</translation>
    </message>
    <message>
        <source>Look for what standards for the reports of experts ask for; nothing is simulated and nothing written</source>
        <translation>查找专家报告标准所要求的内容；不模拟，也不写入任何内容</translation>
    </message>
    <message>
        <source>of a file…</source>
        <translation>取自文件…</translation>
    </message>
    <message>
        <source>of %1…</source>
        <translation>取自 %1…</translation>
    </message>
    <message>
        <source>Not checked since the run or the case changed.</source>
        <translation>计算或案例更改后尚未检查。</translation>
    </message>
    <message>
        <source>The report lacks nothing that the program can tell.</source>
        <translation>程序所能判断的内容，报告都不缺。</translation>
    </message>
    <message>
        <source>The report would lack:</source>
        <translation>报告将缺少：</translation>
    </message>
    <message>
        <source>For you to say:</source>
        <translation>需由您说明：</translation>
    </message>
    <message>
        <source>Qualification</source>
        <translation>资质</translation>
    </message>
    <message>
        <source>What qualifies you for this report, and what binds you to a party; stands above the signature</source>
        <translation>您编写本报告的资质，以及与哪一方的关系；位于签名之上</translation>
    </message>
    <message>
        <source>A comparison of causes that becomes a table of the report: that of the page Causes, or what rubble-cli compare printed into a file</source>
        <translation>成为报告中一个表的原因比较：原因页的，或命令行写入文件的</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::RunList</name>
    <message>
        <source>sound</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>1 limit passed</source>
        <translation>超过 1 项限值</translation>
    </message>
    <message>
        <source>%1 limits passed</source>
        <translation>超过 %1 项限值</translation>
    </message>
    <message>
        <source>Every run of this case is listed here: when, what with, and what came of it.</source>
        <translation>此案例的每次计算列于此处：时间、所用设置和结果。</translation>
    </message>
    <message>
        <source>Show this run</source>
        <translation>显示此计算</translation>
    </message>
    <message>
        <source>Runs of this case</source>
        <translation>此案例的计算</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 bodies · %2 · %3</source>
        <translation>%1 个刚体 · %2 · %3</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>正在显示</translation>
    </message>
    <message>
        <source>Fingerprint %1</source>
        <translation>指纹 %1</translation>
    </message>
    <message>
        <source>trajectory %1</source>
        <translation>轨迹 %1</translation>
    </message>
    <message>
        <source>live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>as fast as it went</source>
        <translation>以最快速度</translation>
    </message>
    <message>
        <source>Fingerprint of inputs, settings and program: %1
Trajectory of every recorded frame: %2
Program: %3</source>
        <translation>输入、设置和程序的指纹：%1
所有记录帧的轨迹：%2
程序：%3</translation>
    </message>
    <message>
        <source>It is the run in the views</source>
        <translation>即视图中的计算</translation>
    </message>
    <message>
        <source>Open %1 and show it in the views</source>
        <translation>打开 %1 并在视图中显示</translation>
    </message>
    <message>
        <source>Its file was not kept, so it cannot be shown.</source>
        <translation>其文件未保留，无法显示。</translation>
    </message>
    <message>
        <source>%1 is not there any more, so it cannot be shown.</source>
        <translation>%1 已不存在，无法显示。</translation>
    </message>
    <message>
        <source>cancelled at %1</source>
        <translation>在 %1 取消</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::RunMapPanel</name>
    <message>
        <source>Save map…</source>
        <translation>保存图…</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>What the colours of the map say</source>
        <translation>图中颜色的含义</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>铺在地面上</translation>
    </message>
    <message>
        <source>Lay this map on the ground of the views, below the debris</source>
        <translation>把此图铺在视图的地面上，位于堆积物之下</translation>
    </message>
    <message>
        <source>Save the map as GeoTIFF, GeoPackage or CSV with all layers, or as the picture that stands here</source>
        <translation>将图保存为含全部图层的 GeoTIFF、GeoPackage 或 CSV，或保存为此处所示的图片</translation>
    </message>
    <message>
        <source>at the end</source>
        <translation>结束时</translation>
    </message>
    <message>
        <source>as the views</source>
        <translation>与视图相同</translation>
    </message>
    <message>
        <source>Debris</source>
        <translation>堆积物</translation>
    </message>
    <message>
        <source>At the end of the run, or at the instant that the views show</source>
        <translation>计算结束时，或视图所示的时刻</translation>
    </message>
    <message>
        <source>Cells [%1]</source>
        <translation>单元 [%1]</translation>
    </message>
    <message>
        <source>Side of a cell of the map</source>
        <translation>图中单元的边长</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Contours</source>
        <translation>等高线</translation>
    </message>
    <message>
        <source>Lines of equal height of the debris, so far apart</source>
        <translation>堆积物等高的线，间距如此</translation>
    </message>
    <message>
        <source>Fallen live structure</source>
        <translation>坠落的未失效结构</translation>
    </message>
    <message>
        <source>Live elements that fell, in layers of their own</source>
        <translation>坠落的未失效单元，有自己的图层</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>结构</translation>
    </message>
    <message>
        <source>Outline in plan of what collapsed, as it stood</source>
        <translation>倒塌部分原先站立时的平面轮廓</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>证据</translation>
    </message>
    <message>
        <source>Outlines that were surveyed, and the areas in which surveys are compared</source>
        <translation>测得的轮廓，以及比较测绘的区域</translation>
    </message>
    <message>
        <source>Mapping the debris …</source>
        <translation>正在绘制堆积物图 …</translation>
    </message>
    <message>
        <source>fragments: %1</source>
        <translation>碎块：%1</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>占 %1</translation>
    </message>
    <message>
        <source>fallen live structure beside them: %1</source>
        <translation>另有坠落的未失效结构：%1</translation>
    </message>
    <message>
        <source>mapping anew …</source>
        <translation>正在重新绘制 …</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::RunPanel</name>
    <message>
        <source>mean %1 ms per step</source>
        <translation>平均每步 %1 ms</translation>
    </message>
    <message>
        <source>bulking of the pile %1</source>
        <translation>堆积体松散系数 %1</translation>
    </message>
    <message>
        <source>Solver: soft-step, %1 substeps or more, %2, %3</source>
        <translation>求解器：软步法，至少 %1 个子步，%2，%3</translation>
    </message>
    <message>
        <source>Solver: bullet, %1, %2</source>
        <translation>求解器：Bullet，%1，%2</translation>
    </message>
    <message>
        <source>Solver: soft-step, %1, %2</source>
        <translation>求解器：软步法，%1，%2</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>计算</translation>
    </message>
    <message>
        <source>Where the fragments go.</source>
        <translation>碎块去向何处。</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Simulate the whole collapse as fast as it goes (Ctrl+R)</source>
        <translation>以最快速度模拟整个倒塌过程（Ctrl+R）</translation>
    </message>
    <message>
        <source>Simulate at the pace of the collapse and watch: each frame simulates one frame time and draws both views</source>
        <translation>按倒塌的实际速度模拟并观看：每帧模拟一帧的时间并绘制两个视图</translation>
    </message>
    <message>
        <source>Stop the run (Esc); what is computed is kept</source>
        <translation>停止计算（Esc）；已计算的内容保留</translation>
    </message>
    <message>
        <source>Health of the run</source>
        <translation>计算的健康状况</translation>
    </message>
    <message>
        <source>Open a result first.</source>
        <translation>请先打开结果。</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>引擎</translation>
    </message>
    <message>
        <source>Rest and recording</source>
        <translation>静止与记录</translation>
    </message>
    <message>
        <source>Last run</source>
        <translation>上次计算</translation>
    </message>
    <message>
        <source>What the solver cost, and what it made of the pile: volume under its surface over volume of material. Broken rock has 1.3 to 1.7; below 1.15 the pile has squeezed into itself.</source>
        <translation>求解器的耗时及形成的堆积体：表面以下体积与材料体积之比。碎石为 1.3 至 1.7；低于 1.15 表明堆积体自身压缩。</translation>
    </message>
    <message>
        <source>Bodies at most</source>
        <translation>刚体最多数</translation>
    </message>
    <message>
        <source>Asleep at the end</source>
        <translation>结束时休眠</translation>
    </message>
    <message>
        <source>Share of the bodies</source>
        <translation>占刚体的比例</translation>
    </message>
    <message>
        <source>Still moving</source>
        <translation>仍在运动</translation>
    </message>
    <message>
        <source>bodies</source>
        <translation>刚体</translation>
    </message>
    <message>
        <source>The end</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>When 99 % of the bodies slept, or the settle time was over</source>
        <translation>99 % 的刚体休眠时，或稳定时间用尽时</translation>
    </message>
    <message>
        <source>Wall time</source>
        <translation>实际耗时</translation>
    </message>
    <message>
        <source>Step, mean and worst</source>
        <translation>步耗时，平均与最差</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>From the first to the last birth</source>
        <translation>从首次到末次产生</translation>
    </message>
    <message>
        <source>Real-time factor</source>
        <translation>实时系数</translation>
    </message>
    <message>
        <source>Simulated over wall time, first to last birth, recording included</source>
        <translation>模拟时间与实际耗时之比，从首次到末次产生，含记录</translation>
    </message>
    <message>
        <source>Live rate, mean and worst second</source>
        <translation>实时帧率，平均与最差一秒</translation>
    </message>
    <message>
        <source>FPS</source>
        <translation>FPS</translation>
    </message>
    <message>
        <source>Measured in live mode</source>
        <translation>在实时模式下测得</translation>
    </message>
    <message>
        <source>Energy drift</source>
        <translation>能量漂移</translation>
    </message>
    <message>
        <source>Largest gain beyond gravity, births and pieces, over gravity&apos;s work</source>
        <translation>除重力、产生和运动结构之外的最大增量与重力功之比</translation>
    </message>
    <message>
        <source>Births in occupied space</source>
        <translation>在被占空间中产生</translation>
    </message>
    <message>
        <source>Bodies born inside older debris or pieces</source>
        <translation>产生于已有堆积物或运动结构内部的刚体</translation>
    </message>
    <message>
        <source>Work of resolving overlap</source>
        <translation>消除重叠的功</translation>
    </message>
    <message>
        <source>Deepest contact</source>
        <translation>最深接触</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Released structure</source>
        <translation>释放的结构</translation>
    </message>
    <message>
        <source>Live islands without a path to a support that became rigid bodies when the FE result ended, apart from fragments</source>
        <translation>有限元结果结束时没有路径通向支座而成为刚体的存活部分，不含碎块</translation>
    </message>
    <message>
        <source>Live islands held</source>
        <translation>固定的孤立部分</translation>
    </message>
    <message>
        <source>Parts of the structure alive at the end without a path to a support</source>
        <translation>结束时没有路径通向支座的未失效结构部分</translation>
    </message>
    <message>
        <source>Ledger, fragments</source>
        <translation>守恒账目，碎块</translation>
    </message>
    <message>
        <source>Largest relative error of mass, momentum, angular momentum against the FE result</source>
        <translation>质量、动量、角动量相对有限元结果的最大相对误差</translation>
    </message>
    <message>
        <source>Ledger, bodies</source>
        <translation>守恒账目，刚体</translation>
    </message>
    <message>
        <source>The same for the bodies, as read back from the engine</source>
        <translation>刚体的同一误差，由引擎读回</translation>
    </message>
    <message>
        <source>Trajectory</source>
        <translation>轨迹</translation>
    </message>
    <message>
        <source>Hash of every recorded frame: equal runs have equal hashes</source>
        <translation>所有记录帧的哈希：相同的计算具有相同的哈希</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>%1 (%2 elements)</source>
        <translation>%1（%2 个单元）</translation>
    </message>
    <message>
        <source>Runs of this case</source>
        <translation>此案例的计算</translation>
    </message>
    <message>
        <source>%1; %2 released inside debris or structure; %3 still move at the end</source>
        <translation>%1；%2 个在堆积物或结构内释放；%3 个结束时仍在运动</translation>
    </message>
    <message>
        <source>Bodies that moved at one recorded instant; the others cost next to nothing</source>
        <translation>某一记录时刻在运动的刚体数；其余几乎不耗时</translation>
    </message>
    <message>
        <source>Awake at most</source>
        <translation>活动至多</translation>
    </message>
    <message>
        <source>Carried structure</source>
        <translation>引擎带动的结构</translation>
    </message>
    <message>
        <source>Loose islands that the engine moved from when they came loose, before the FE result ended</source>
        <translation>有限元结果结束之前，自松脱起由引擎移动的松散孤立部分</translation>
    </message>
    <message>
        <source>%1; fragments born from them %2, of these after they had come to rest %3, by a blow twice as hard as in the engine %4; bodies left at the end %5</source>
        <translation>%1；由其产生的碎块 %2，其中静止之后产生的 %3，因冲击为引擎所给两倍以上而产生的 %4；结束时余下的刚体 %5</translation>
    </message>
    <message>
        <source>Settings of the case become those that this run was simulated with, in one step of undo</source>
        <translation>案例的设置变为本次计算所用的设置，一步即可撤销</translation>
    </message>
    <message>
        <source>The case has the settings of this run</source>
        <translation>案例的设置与本次计算相同</translation>
    </message>
    <message>
        <source>Take its settings</source>
        <translation>采用其设置</translation>
    </message>
    <message>
        <source>The FE result lasts %1. Its debris has at most the settle time to come to rest; each of the two has half of the timeline.</source>
        <translation>有限元结果历时 %1。其碎块至多有稳定时间来静止；两者各占时间轴的一半。</translation>
    </message>
    <message>
        <source>Steps per second are those of the settling: every state of the FE result is a step of its own. Times can be typed with a unit: 500 us, 20 ms, 2 s.</source>
        <translation>每秒步数只用于稳定阶段：有限元结果的每个状态本身就是一步。输入时间可带单位：500 us、20 ms、2 s。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::ScanDialog</name>
    <message>
        <source>four around the debris</source>
        <translation>堆积物四周的四台</translation>
    </message>
    <message>
        <source>Step between rays</source>
        <translation>光线的间隔</translation>
    </message>
    <message>
        <source>Range of the scanners</source>
        <translation>扫描仪的量程</translation>
    </message>
    <message>
        <source>Noise along a ray</source>
        <translation>沿光线的噪声</translation>
    </message>
    <message>
        <source>Seed of directions and noise</source>
        <translation>方向和噪声的种子</translation>
    </message>
    <message>
        <source>Scan and save…</source>
        <translation>扫描并保存…</translation>
    </message>
    <message>
        <source>Cancel the scan</source>
        <translation>取消扫描</translation>
    </message>
    <message>
        <source>Scan the run</source>
        <translation>扫描计算</translation>
    </message>
    <message>
        <source>Makes a point cloud as laser scanners would take it of what the run leaves. It shows what a scan can tell of a collapse; what is hidden has no points.</source>
        <translation>像激光扫描仪那样从计算留下之物生成点云，可看出扫描能说明倒塌的什么；被遮挡之处没有点。</translation>
    </message>
    <message>
        <source>One ray falls to each square of this side, degrees</source>
        <translation>每个此边长的方格有一条光线，度</translation>
    </message>
    <message>
        <source>Farthest that a ray goes, m</source>
        <translation>光线所及的最远距离，m</translation>
    </message>
    <message>
        <source>Standard deviation along the ray, m</source>
        <translation>沿光线的标准差，m</translation>
    </message>
    <message>
        <source>Equal seeds give equal points</source>
        <translation>相同的种子给出相同的点</translation>
    </message>
    <message>
        <source>Scanners</source>
        <translation>扫描仪</translation>
    </message>
    <message>
        <source>Step, °</source>
        <translation>间隔，°</translation>
    </message>
    <message>
        <source>Range, m</source>
        <translation>量程，m</translation>
    </message>
    <message>
        <source>Noise, m</source>
        <translation>噪声，m</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>The site is being scanned.</source>
        <translation>正在扫描现场。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::ScannerField</name>
    <message>
        <source>From a table…</source>
        <translation>取自表…</translation>
    </message>
    <message>
        <source>Places of the scanners</source>
        <translation>扫描仪的位置</translation>
    </message>
    <message>
        <source>Easting, northing and height of each scanner in the system of the case, m: 12.5,-3,1.8; 40,7,2.1. Points are held against what was to be seen from there</source>
        <translation>每台扫描仪在案例坐标系中的东坐标、北坐标和高程，m：12.5,-3,1.8; 40,7,2.1。点与从那里所能看到的进行比较</translation>
    </message>
    <message>
        <source>Take them from a table whose heading names easting, northing and height</source>
        <translation>取自表头写明东坐标、北坐标和高程的表</translation>
    </message>
    <message>
        <source>Write easting, northing and height of each scanner, such as 12.5,-3,1.8; 40,7,2.1</source>
        <translation>请写出每台扫描仪的东坐标、北坐标和高程，例如 12.5,-3,1.8; 40,7,2.1</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::ScenarioBar</name>
    <message>
        <source>Open a kept run…</source>
        <translation>打开保留的计算…</translation>
    </message>
    <message>
        <source>Another scenario</source>
        <translation>另一方案</translation>
    </message>
    <message>
        <source>Scenario in the right view</source>
        <translation>右侧视图的方案</translation>
    </message>
    <message>
        <source>Newest complete run of this scenario; camera, time and selection are those of the left view</source>
        <translation>该方案最新的完整计算；相机、时刻和选择与左侧视图相同</translation>
    </message>
    <message>
        <source>Choose a run file (*.run.h5) of the FE result that is open</source>
        <translation>选择已打开的有限元结果的计算文件 (*.run.h5)</translation>
    </message>
    <message>
        <source>No other scenario has a run yet: simulate one, go on with another scenario and simulate that, or open a run that was kept.</source>
        <translation>其他方案尚无计算：先模拟一个方案，再换一个方案模拟，或打开保留的计算。</translation>
    </message>
    <message>
        <source>Left: what was simulated last. Right, from the same place and at the same time:</source>
        <translation>左侧：最近一次模拟。右侧，视点和时刻相同：</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::ScenarioComparison</name>
    <message>
        <source>unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Settings that differ</source>
        <translation>不同的设置</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>result</source>
        <translation>结果项</translation>
    </message>
    <message>
        <source>First scenario</source>
        <translation>第一个方案</translation>
    </message>
    <message>
        <source>The scenario in the first column</source>
        <translation>第一列的方案</translation>
    </message>
    <message>
        <source>Second scenario</source>
        <translation>第二个方案</translation>
    </message>
    <message>
        <source>The scenario in the second column</source>
        <translation>第二列的方案</translation>
    </message>
    <message>
        <source>against</source>
        <translation>对比</translation>
    </message>
    <message>
        <source>SETTINGS THAT DIFFER</source>
        <translation>设置差异</translation>
    </message>
    <message>
        <source>RESULTS OF THE NEWEST COMPLETE RUNS</source>
        <translation>最近完整计算的结果</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 个步骤</translation>
    </message>
    <message>
        <source>Regrouping of components</source>
        <translation>构件重新分组</translation>
    </message>
    <message>
        <source>Which parts of the file are joined, split or renamed; the Case panel lists the steps</source>
        <translation>文件的哪些部件被合并、分割或重命名；“案例”面板列出各步骤</translation>
    </message>
    <message>
        <source>None: all settings are the same.</source>
        <translation>无：所有设置相同。</translation>
    </message>
    <message>
        <source>%1 has no complete run.</source>
        <translation>%1 没有完整的计算。</translation>
    </message>
    <message>
        <source>The run of %1 is stale: settings, inputs or the program have changed since.</source>
        <translation>%1 的计算已过期：此后设置、输入或程序已更改。</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Fragments</source>
        <translation>碎块</translation>
    </message>
    <message>
        <source>Bodies at most</source>
        <translation>刚体最多数</translation>
    </message>
    <message>
        <source>Wall time</source>
        <translation>实际耗时</translation>
    </message>
    <message>
        <source>Step, mean</source>
        <translation>步，平均</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>The end</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>Asleep at the end</source>
        <translation>结束时休眠</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>最高速度</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>Bulking of the pile</source>
        <translation>堆积体松散系数</translation>
    </message>
    <message>
        <source>Energy drift</source>
        <translation>能量漂移</translation>
    </message>
    <message>
        <source>Limits of health passed</source>
        <translation>超过的健康限值</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::ScenarioList</name>
    <message>
        <source>Duplicate</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>比较…</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>方案</translation>
    </message>
    <message>
        <source>The chosen scenario is the one that is worked on; F2 renames it</source>
        <translation>所选方案即正在使用的方案；F2 重命名</translation>
    </message>
    <message>
        <source>Note: what this scenario stands for</source>
        <translation>备注：此方案代表什么</translation>
    </message>
    <message>
        <source>Note on the scenario</source>
        <translation>方案备注</translation>
    </message>
    <message>
        <source>What the chosen scenario stands for; saved with the case</source>
        <translation>所选方案代表什么；随案例保存</translation>
    </message>
    <message>
        <source>A copy of the chosen scenario, with all its settings, becomes the one that is worked on</source>
        <translation>所选方案的副本（含全部设置）成为正在使用的方案</translation>
    </message>
    <message>
        <source>Give the chosen scenario another name (F2)</source>
        <translation>为所选方案另取名称（F2）</translation>
    </message>
    <message>
        <source>Delete the chosen scenario; can be undone. The last one stays</source>
        <translation>删除所选方案；可撤销。最后一个保留</translation>
    </message>
    <message>
        <source>Show side by side in which settings and results two scenarios differ</source>
        <translation>并列显示两个方案在哪些设置和结果上不同</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::SealDialog</name>
    <message>
        <source>Seal the case</source>
        <translation>封存案例</translation>
    </message>
    <message>
        <source>Sealed by</source>
        <translation>封存者</translation>
    </message>
    <message>
        <source>Who seals the case</source>
        <translation>由谁封存案例</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Why, or what is to be known of it</source>
        <translation>为何，或须知之事</translation>
    </message>
    <message>
        <source>Seal…</source>
        <translation>封存…</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>计算</translation>
    </message>
    <message>
        <source>Exports</source>
        <translation>导出内容</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>网页</translation>
    </message>
    <message>
        <source>Write a request for a time stamp</source>
        <translation>写出时间戳的请求</translation>
    </message>
    <message>
        <source>What is sealed</source>
        <translation>封存内容</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>说明</translation>
    </message>
    <message>
        <source>Add files…</source>
        <translation>加入文件…</translation>
    </message>
    <message>
        <source>Runs, exports and pages that lie elsewhere, with their provenance</source>
        <translation>位于别处的计算、导出内容和网页，连同其来源</translation>
    </message>
    <message>
        <source>Add a report…</source>
        <translation>加入报告…</translation>
    </message>
    <message>
        <source>The folder of a report, with all in it</source>
        <translation>报告的文件夹及其全部内容</translation>
    </message>
    <message>
        <source>Without a time stamp the time of sealing is the signer&apos;s word.</source>
        <translation>没有时间戳，封存时间只是签名者自己所述。</translation>
    </message>
    <message>
        <source>A file *.tsq is written beside the bundle. Send it to a time-stamping service (RFC 3161) and put its answer in with Open sealed…, Time stamp. Nothing is sent by Rubble.</source>
        <translation>在封存包旁写出 *.tsq 文件。请将其发给时间戳服务机构（RFC 3161），并在“打开封存包…”的“时间戳”中放入应答。Rubble 不发送任何内容。</translation>
    </message>
    <message>
        <source>Seal these as well</source>
        <translation>一同封存</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Folder of a report</source>
        <translation>报告的文件夹</translation>
    </message>
    <message>
        <source>only its digest is sealed</source>
        <translation>只封存其摘要</translation>
    </message>
    <message>
        <source>The case alone is sealed.</source>
        <translation>只封存案例。</translation>
    </message>
    <message>
        <source>About %1 are sealed; the largest is %2.</source>
        <translation>约封存 %1；最大的是 %2。</translation>
    </message>
    <message>
        <source>Make a report of %1</source>
        <translation>为 %1 制作报告</translation>
    </message>
    <message>
        <source>Make a page of %1</source>
        <translation>为 %1 制作网页</translation>
    </message>
    <message>
        <source>Made before the bundle is written, as Export &gt; Report… makes it of what its panel asks for. It simulates the repeats that are set there.</source>
        <translation>在写出封存包之前制作，与“导出 &gt; 报告…”相同，内容按其面板的设置，并模拟其中设定的重复计算。</translation>
    </message>
    <message>
        <source>Made before the bundle is written, as Export &gt; Share as a page… makes it.</source>
        <translation>在写出封存包之前制作，与“导出 &gt; 共享为网页…”相同。</translation>
    </message>
    <message>
        <source>The case is sealed with its journal. What is ticked goes along; an input that is not ticked stays here, and only its digest is sealed. A run that lacks a report or a page can have it made.</source>
        <translation>案例连同其日志一并封存。勾选的内容随行；未勾选的输入留在这里，只封存其摘要。缺少报告或网页的计算，可在此制作。</translation>
    </message>
    <message>
        <source>What is made comes on top.</source>
        <translation>所制作的内容另计。</translation>
    </message>
    <message>
        <source>its run is not sealed</source>
        <translation>其计算未被封存</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::SectionDialog</name>
    <message>
        <source>Width of the section</source>
        <translation>剖面宽度</translation>
    </message>
    <message>
        <source>Step along the section</source>
        <translation>沿剖面的步长</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>剖面</translation>
    </message>
    <message>
        <source>Width, m</source>
        <translation>宽度，m</translation>
    </message>
    <message>
        <source>Step, m</source>
        <translation>步长，m</translation>
    </message>
    <message>
        <source>Surveyed points within half of it to either side of the line count, m</source>
        <translation>线两侧各一半宽度内测得的点计入，m</translation>
    </message>
    <message>
        <source>Along the line: what is drawn, and what areas are summed over, m</source>
        <translation>沿线绘制和对面积求和的步长，m</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>保存图片…</translation>
    </message>
    <message>
        <source>Of another run, survey or place: draw the section again.</source>
        <translation>属于另一次计算、测绘或位置：请重新绘制剖面。</translation>
    </message>
    <message>
        <source>Cutting…</source>
        <translation>正在剖切…</translation>
    </message>
    <message>
        <source>At %1 s; %2 m long, %3 m wide.</source>
        <translation>时刻 %1 s；长 %2 m，宽 %3 m。</translation>
    </message>
    <message>
        <source>An outline has no heights: only what was simulated is cut.</source>
        <translation>轮廓没有高程：只剖切模拟之物。</translation>
    </message>
    <message>
        <source>%1: %2 heights on it, %3 of them where the simulation has a surface.</source>
        <translation>%1：其上 %2 个高程，其中 %3 个处模拟有表面。</translation>
    </message>
    <message>
        <source>Simulated less surveyed: %1 m in the mean, %2 m RMS.</source>
        <translation>模拟减测绘：平均 %1 m，均方根 %2 m。</translation>
    </message>
    <message>
        <source>Area above the ground over %1 m with heights: %2 m² surveyed, %3 m² simulated.</source>
        <translation>有高程的 %1 m 上地面以上的面积：测绘 %2 m²，模拟 %3 m²。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::SelectForm</name>
    <message>
        <source>empty: no bound</source>
        <translation>留空：不限</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>所属构件</translation>
    </message>
    <message>
        <source>Elements of this component</source>
        <translation>此构件的单元</translation>
    </message>
    <message>
        <source>Born from</source>
        <translation>产生起于</translation>
    </message>
    <message>
        <source>Born to</source>
        <translation>产生止于</translation>
    </message>
    <message>
        <source>Cluster</source>
        <translation>所属聚类</translation>
    </message>
    <message>
        <source>Fragments of the cluster with this number; empty: any</source>
        <translation>此编号聚类的碎块；留空：任意</translation>
    </message>
    <message>
        <source>component</source>
        <translation>构件</translation>
    </message>
    <message>
        <source>born</source>
        <translation>产生时段</translation>
    </message>
    <message>
        <source>cluster</source>
        <translation>聚类</translation>
    </message>
    <message>
        <source>%1 from</source>
        <translation>%1 起于</translation>
    </message>
    <message>
        <source>%1 to</source>
        <translation>%1 止于</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>去除</translation>
    </message>
    <message>
        <source>Select what fits, and nothing else</source>
        <translation>仅选择符合条件的内容</translation>
    </message>
    <message>
        <source>Add what fits to the selection</source>
        <translation>将符合条件的内容加入选择</translation>
    </message>
    <message>
        <source>Take what fits out of the selection</source>
        <translation>将符合条件的内容移出选择</translation>
    </message>
    <message>
        <source>any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>Nothing fits.</source>
        <translation>没有符合条件的内容。</translation>
    </message>
    <message>
        <source>%1 elements fit.</source>
        <translation>%1 个单元符合条件。</translation>
    </message>
    <message>
        <source>%1: “%2” is no number.</source>
        <translation>%1：“%2”不是数值。</translation>
    </message>
    <message>
        <source>A cluster has a whole number from 0.</source>
        <translation>聚类编号为从 0 起的整数。</translation>
    </message>
    <message>
        <source>Give at least one of these.</source>
        <translation>至少给出其中一项。</translation>
    </message>
    <message>
        <source>Centres with %1 within these bounds at the time shown, counted as exported tables do; %2</source>
        <translation>所示时刻 %1 在此界限内的形心，计数方式与导出表相同；%2</translation>
    </message>
    <message>
        <source>Fragments born at or after this time; %1</source>
        <translation>在此时刻或之后产生的碎块；%1</translation>
    </message>
    <message>
        <source>Fragments born at or before this time; %1</source>
        <translation>在此时刻或之前产生的碎块；%1</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::SignerForm</name>
    <message>
        <source>Key</source>
        <translation>密钥</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>证书</translation>
    </message>
    <message>
        <source>Private key of whoever signs, PEM: Ed25519, RSA or elliptic curve</source>
        <translation>签名者的私钥，PEM 格式：Ed25519、RSA 或椭圆曲线</translation>
    </message>
    <message>
        <source>X.509 certificate of that key, which says a name. Without it the other side compares the SHA-256 of the key.</source>
        <translation>该密钥的 X.509 证书，其中写有姓名。没有证书时，对方比较密钥的 SHA-256。</translation>
    </message>
    <message>
        <source>Passphrase</source>
        <translation>口令</translation>
    </message>
    <message>
        <source>Passphrase of the key, if it has one; it is kept nowhere</source>
        <translation>密钥的口令（若有）；不会保存在任何地方</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::SiteDialog</name>
    <message>
        <source>Height shift</source>
        <translation>高程偏移</translation>
    </message>
    <message>
        <source>Debris falls on the surroundings too</source>
        <translation>堆积物也落在周围环境上</translation>
    </message>
    <message>
        <source>Add control point</source>
        <translation>添加控制点</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>场地</translation>
    </message>
    <message>
        <source>none: local coordinates</source>
        <translation>无：局部坐标</translation>
    </message>
    <message>
        <source>Coordinate system of the case, such as EPSG:25832: terrain, orthophoto and surveys in another one are projected to it, and maps are written in it. Needs eastings and northings, not degrees</source>
        <translation>案例的坐标系，如 EPSG:25832：其他坐标系中的地形、正射影像和测绘会投影到此坐标系，地图也以此写出。须为东北坐标，不能是度</translation>
    </message>
    <message>
        <source>Coordinate system</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>Added to the heights of terrain, surroundings and surveys, m (-10,000 to 10,000): the difference between their vertical datum and that of the case</source>
        <translation>加到地形、周围环境和测绘高程上的值，m（-10,000 至 10,000）：其高程基准与案例高程基准之差</translation>
    </message>
    <message>
        <source>Height shift, m</source>
        <translation>高程偏移，m</translation>
    </message>
    <message>
        <source>The highest surface of the meshes becomes part of the terrain: debris meets roofs, walls and banks, and gets below no overhang. Needs a terrain</source>
        <translation>网格的最高表面成为地形的一部分：堆积物会碰到屋顶、墙和堤岸，但不会进入悬挑之下。需要地形</translation>
    </message>
    <message>
        <source>used</source>
        <translation>采用</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>x, m</source>
        <translation>x，m</translation>
    </message>
    <message>
        <source>y, m</source>
        <translation>y，m</translation>
    </message>
    <message>
        <source>z, m</source>
        <translation>z，m</translation>
    </message>
    <message>
        <source>easting, m</source>
        <translation>东坐标，m</translation>
    </message>
    <message>
        <source>northing, m</source>
        <translation>北坐标，m</translation>
    </message>
    <message>
        <source>height, m</source>
        <translation>高程，m</translation>
    </message>
    <message>
        <source>off in plan, m</source>
        <translation>平面残差，m</translation>
    </message>
    <message>
        <source>off in height, m</source>
        <translation>高程残差，m</translation>
    </message>
    <message>
        <source>Control points</source>
        <translation>控制点</translation>
    </message>
    <message>
        <source>Points known in the frame of the case (x, y, z as the views show them) and in the world. Two or more that are used take the place of the frame&apos;s origin; three or more show a wrong one by its residual</source>
        <translation>在案例坐标系（视图所示 x、y、z）和真实世界中均已知的点。采用两个或更多时取代坐标系原点；三个或更多时，错误的点由其残差显出</translation>
    </message>
    <message>
        <source>Delete the chosen control point</source>
        <translation>删除所选控制点</translation>
    </message>
    <message>
        <source>Add a control point to be typed</source>
        <translation>添加一个待输入的控制点</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>点 %1</translation>
    </message>
    <message>
        <source>That is no coordinate in metres.</source>
        <translation>这不是以米计的坐标。</translation>
    </message>
    <message>
        <source>The point stays as it was.</source>
        <translation>该点保持不变。</translation>
    </message>
    <message>
        <source>The origin of the frame says where the site lies.</source>
        <translation>场地位置由坐标系原点确定。</translation>
    </message>
    <message>
        <source>One control point says nothing yet: use two or more.</source>
        <translation>一个控制点还不能说明问题：请采用两个或更多。</translation>
    </message>
    <message>
        <source>Least squares over %1 points: turned by %2°, scale %3, residuals %4 m in plan and %5 m in height (RMS).</source>
        <translation>%1 个点的最小二乘：转角 %2°，比例 %3，残差平面 %4 m、高程 %5 m（均方根）。</translation>
    </message>
    <message>
        <source>Two points always fit in plan: a third shows whether they are right.</source>
        <translation>两个点在平面上总能拟合：第三个点才能显示其是否正确。</translation>
    </message>
    <message>
        <source>mesh of the surroundings</source>
        <translation>周围环境网格</translation>
    </message>
    <message>
        <source>offset east, m</source>
        <translation>东向偏移，m</translation>
    </message>
    <message>
        <source>offset north, m</source>
        <translation>北向偏移，m</translation>
    </message>
    <message>
        <source>offset height, m</source>
        <translation>高程偏移量，m</translation>
    </message>
    <message>
        <source>Offsets of the surroundings</source>
        <translation>周围环境的偏移</translation>
    </message>
    <message>
        <source>Added to the coordinates of a mesh that was written about an origin near the site. Leave the three fields empty where a file beside the mesh names its offset, or where it has none</source>
        <translation>加到以场地附近原点写出的网格的坐标上。网格旁的文件写有偏移，或网格没有偏移时，三项均留空</translation>
    </message>
    <message>
        <source>That is no offset in metres.</source>
        <translation>这不是以米为单位的偏移。</translation>
    </message>
    <message>
        <source>The mesh stays as it was.</source>
        <translation>网格保持原样。</translation>
    </message>
    <message>
        <source>Ground classes</source>
        <translation>地面类别</translation>
    </message>
    <message>
        <source>2; without it all but vegetation and wires</source>
        <translation>2；没有时为植被和电线以外的全部</translation>
    </message>
    <message>
        <source>Classes of a point cloud whose points are the terrain, 0 to 255, parted by commas, such as 2,9. Left empty it is 2, ground; of a cloud without ground all points but vegetation and wires</source>
        <translation>点云中作为地形的点的类别，0 至 255，以逗号分隔，例如 2,9。留空时为 2（地面）；没有地面类别的点云取植被和电线以外的全部点</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::StageRail</name>
    <message>
        <source>not yet</source>
        <translation>尚未</translation>
    </message>
    <message>
        <source>running, %1</source>
        <translation>运行中，%1</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>最新</translation>
    </message>
    <message>
        <source>stale: settings have changed since</source>
        <translation>过期：此后设置已更改</translation>
    </message>
    <message>
        <source>findings: %1</source>
        <translation>发现项：%1</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::StartPage</name>
    <message>
        <source>RECENT</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>Where do the fragments go?</source>
        <translation>碎块去向何处？</translation>
    </message>
    <message>
        <source>Open the finished result of a collapse analysis: every deactivated element becomes a fragment that falls, hits and comes to rest, beside the conventional view in which it vanishes. A case or a result can be dropped anywhere in this window.</source>
        <translation>打开已完成的倒塌分析结果：每个失效单元都成为下落、碰撞直至静止的碎块，与其直接消失的常规视图并列。案例或结果可拖放到窗口任意位置。</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Open a case (*.rubble) or an FE result (Ctrl+O)</source>
        <translation>打开案例（*.rubble）或有限元结果（Ctrl+O）</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>开始导览</translation>
    </message>
    <message>
        <source>SAMPLES</source>
        <translation>示例</translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>定位…</translation>
    </message>
    <message>
        <source>Choose where %1 lies now</source>
        <translation>选择 %1 现在的位置</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Take %1 off this list; the file itself stays</source>
        <translation>从列表中移除 %1；文件本身保留</translation>
    </message>
    <message>
        <source>New case…</source>
        <translation>新建案例…</translation>
    </message>
    <message>
        <source>Make a case from an FE result step by step (Ctrl+N)</source>
        <translation>由有限元结果逐步建立案例 (Ctrl+N)</translation>
    </message>
    <message>
        <source>The stone arch collapses, and seven sentences say what is for what</source>
        <translation>石拱桥倒塌，七句话说明各部分的用途</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::StatusLine</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Stop what runs (Esc); what is computed is kept</source>
        <translation>停止正在运行的工作（Esc）；已计算的内容保留</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::StudyStart</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::SurveyBox</name>
    <message>
        <source>Add survey…</source>
        <translation>添加测绘…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Cells of the survey comparison</source>
        <translation>测绘比较的单元格</translation>
    </message>
    <message>
        <source>Least height of debris</source>
        <translation>堆积物最小高度</translation>
    </message>
    <message>
        <source>Fallen structure counts as debris</source>
        <translation>坠落结构计入堆积物</translation>
    </message>
    <message>
        <source>Compare with survey</source>
        <translation>与测绘比较</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Save difference map…</source>
        <translation>保存差异图…</translation>
    </message>
    <message>
        <source>Surveys</source>
        <translation>测绘列表</translation>
    </message>
    <message>
        <source>The survey that is compared</source>
        <translation>用于比较的测绘</translation>
    </message>
    <message>
        <source>Take this survey out of the case; its file stays</source>
        <translation>将此测绘移出案例；文件保留</translation>
    </message>
    <message>
        <source>Side of the cells that are compared, 0.05 to 10 m</source>
        <translation>比较单元格的边长，0.05 至 10 m</translation>
    </message>
    <message>
        <source>Cells, m</source>
        <translation>单元格，m</translation>
    </message>
    <message>
        <source>Height above the ground from which there is debris, 0 to 5 m; what lies lower is noise of the survey</source>
        <translation>高出地面达到此值即为堆积物，0 至 5 m；更低者为测绘噪声</translation>
    </message>
    <message>
        <source>Least height, m</source>
        <translation>最小高度，m</translation>
    </message>
    <message>
        <source>where it was surveyed</source>
        <translation>保持测绘位置</translation>
    </message>
    <message>
        <source>moved to the ground beside it</source>
        <translation>移至旁边的地面</translation>
    </message>
    <message>
        <source>moved to the debris</source>
        <translation>移至堆积物</translation>
    </message>
    <message>
        <source>Registration of the survey</source>
        <translation>测绘的配准</translation>
    </message>
    <message>
        <source>Where the survey is taken to lie: as it is, shifted by least squares to the ground beside the debris (errors of its place go), or to the simulated debris, at most 5 m (only the shape is compared then)</source>
        <translation>测绘的位置：保持原样；按最小二乘移至堆积物旁的地面（消除位置误差）；或移至模拟的堆积物，至多 5 m（此时只比较形状）</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>配准</translation>
    </message>
    <message>
        <source>Whether live structure that moved farther than 1 m belongs to the simulated debris, as it does to the surveyed; said on the result</source>
        <translation>移动超过 1 m 的未失效结构是否像在测绘中那样计入模拟堆积物；结果中会注明</translation>
    </message>
    <message>
        <source>Hold the debris at rest against the survey</source>
        <translation>将静止的堆积物与测绘对照</translation>
    </message>
    <message>
        <source>Stop comparing</source>
        <translation>停止比较</translation>
    </message>
    <message>
        <source>debris</source>
        <translation>堆积物</translation>
    </message>
    <message>
        <source>surveyed</source>
        <translation>测绘</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>Surveyed and simulated debris</source>
        <translation>测绘与模拟的堆积物</translation>
    </message>
    <message>
        <source>run-out, m</source>
        <translation>散落距离，m</translation>
    </message>
    <message>
        <source>Run-out by direction</source>
        <translation>各方向的散落距离</translation>
    </message>
    <message>
        <source>Distance from the middle of the structure&apos;s plan within which 95 % of the covered area in that direction lies, m</source>
        <translation>该方向覆盖面积的 95 % 所在的、距结构平面中心的距离，m</translation>
    </message>
    <message>
        <source>Save the difference map as GeoTIFF or as a picture</source>
        <translation>将差异图保存为 GeoTIFF 或图像</translation>
    </message>
    <message>
        <source>A height model or an outline of the real debris, measured after the collapse, is compared here.</source>
        <translation>倒塌后测得的实际堆积物高程模型或轮廓在此比较。</translation>
    </message>
    <message>
        <source>Of another run or other settings: compare again.</source>
        <translation>属于另一次计算或其他设置：请重新比较。</translation>
    </message>
    <message>
        <source>area, m²</source>
        <translation>面积，m²</translation>
    </message>
    <message>
        <source>volume, m³</source>
        <translation>体积，m³</translation>
    </message>
    <message>
        <source>centroid x, m</source>
        <translation>质心 x，m</translation>
    </message>
    <message>
        <source>centroid y, m</source>
        <translation>质心 y，m</translation>
    </message>
    <message>
        <source>Overlap of the footprints (IoU): %1.</source>
        <translation>覆盖范围重合度（IoU）：%1。</translation>
    </message>
    <message>
        <source>Heights differ by %1 m RMS, by %2 m in the mean.</source>
        <translation>高度差均方根 %1 m，平均 %2 m。</translation>
    </message>
    <message>
        <source>Volumes hold the voids.</source>
        <translation>体积含空隙。</translation>
    </message>
    <message>
        <source>Centroids lie %1 m apart.</source>
        <translation>质心相距 %1 m。</translation>
    </message>
    <message>
        <source>The survey lies where it was surveyed.</source>
        <translation>测绘位于其测得之处。</translation>
    </message>
    <message>
        <source>The survey was moved by %1, %2, %3 m; what was fitted went from %4 to %5 RMS.</source>
        <translation>测绘移动了 %1、%2、%3 m；拟合量的均方根由 %4 变为 %5。</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
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
        <source>Whether the survey shows fallen structure</source>
        <translation>测绘是否显示坠落的结构</translation>
    </message>
    <message>
        <source>Whether structure that fell whole lies in the survey: yes of a scan of all that was there, no where such pieces were taken out; kept in the case</source>
        <translation>整体坠落的结构是否在测绘中：扫描了现场全部物体为是，已除去这类部分为否；保存在案例中</translation>
    </message>
    <message>
        <source>Fallen structure in it</source>
        <translation>其中的坠落结构</translation>
    </message>
    <message>
        <source>Level of detection %1 m, by the noise that was stated.</source>
        <translation>检测限 %1 m，按给定的噪声。</translation>
    </message>
    <message>
        <source>Level of detection %1 m, estimated from %2 cells far from all debris.</source>
        <translation>检测限 %1 m，由远离所有堆积物的 %2 个单元估计。</translation>
    </message>
    <message>
        <source>The noise hangs together over %1 m.</source>
        <translation>噪声在 %1 m 内相互关联。</translation>
    </message>
    <message>
        <source>A map of another run has no noise.</source>
        <translation>另一次计算的堆积物图没有噪声。</translation>
    </message>
    <message>
        <source>The level of detection is not known: state the noise of survey and ground.</source>
        <translation>检测限未知：请给定测绘和地面的噪声。</translation>
    </message>
    <message>
        <source>Noise of the survey</source>
        <translation>测绘的噪声</translation>
    </message>
    <message>
        <source>Noise of the ground</source>
        <translation>地面的噪声</translation>
    </message>
    <message>
        <source>estimated</source>
        <translation>估计</translation>
    </message>
    <message>
        <source>Standard deviation of the surveyed heights, m. Without both, the noise is estimated where nothing fell; heights below the level of detection do not count. Kept in the case</source>
        <translation>测得高程的标准差，m。未同时给出两者时，在没有堆积物之处估计噪声；低于检测限的高度不计入。保存在案例中</translation>
    </message>
    <message>
        <source>Standard deviation of the heights of the terrain below, m; kept in the case</source>
        <translation>其下地形高程的标准差，m；保存在案例中</translation>
    </message>
    <message>
        <source>Noise, survey, m</source>
        <translation>测绘噪声，m</translation>
    </message>
    <message>
        <source>Noise, ground, m</source>
        <translation>地面噪声，m</translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation>比较的范围</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Add an area of interest, or what is left out, such as vehicles and trees</source>
        <translation>添加关注区域或略去的部分，例如车辆和树木</translation>
    </message>
    <message>
        <source>Draw an area of interest</source>
        <translation>绘制关注区域</translation>
    </message>
    <message>
        <source>Draw what is left out</source>
        <translation>绘制略去的部分</translation>
    </message>
    <message>
        <source>Area of interest from a file…</source>
        <translation>从文件添加关注区域…</translation>
    </message>
    <message>
        <source>What is left out from a file…</source>
        <translation>从文件添加略去的部分…</translation>
    </message>
    <message>
        <source>Remove the chosen polygon</source>
        <translation>移除所选的多边形</translation>
    </message>
    <message>
        <source>Polygons that say what is compared</source>
        <translation>说明比较范围的多边形</translation>
    </message>
    <message>
        <source>Cells that are compared lie within an area of interest, if there is one, and in nothing that is left out</source>
        <translation>参与比较的单元位于关注区域内（若有），且不在略去的部分中</translation>
    </message>
    <message>
        <source>area of interest, corners: %1</source>
        <translation>关注区域，角点：%1</translation>
    </message>
    <message>
        <source>left out, corners: %1</source>
        <translation>略去，角点：%1</translation>
    </message>
    <message>
        <source>area surveyed alike, m²</source>
        <translation>同样测绘的面积，m²</translation>
    </message>
    <message>
        <source>A perfect simulation reaches %1 on this grid; with both sides surveyed alike it is %2.</source>
        <translation>完美模拟在此网格上达到 %1；两侧以同样方式测绘时为 %2。</translation>
    </message>
    <message>
        <source>Surveyed fill %1, cut %2, net %3 m³.</source>
        <translation>测得填方 %1、挖方 %2、净值 %3 m³。</translation>
    </message>
    <message>
        <source>Not compared: %1 m² of surveyed and %2 m² of simulated debris.</source>
        <translation>未比较：测得堆积物 %1 m²，模拟堆积物 %2 m²。</translation>
    </message>
    <message>
        <source>Add a surveyed height model, a point cloud, or the outline of the real debris as polygons</source>
        <translation>添加测绘的高程模型、点云，或以多边形表示的实际堆积物轮廓</translation>
    </message>
    <message>
        <source>Offset error of the survey</source>
        <translation>测绘的偏移误差</translation>
    </message>
    <message>
        <source>Offset error, m</source>
        <translation>偏移误差，m</translation>
    </message>
    <message>
        <source>Standard deviation of an offset that all surveyed heights may have together, m. Without it the systematic error of volumes is not known. Kept in the case</source>
        <translation>所有测得高程可能共有的偏移的标准差，m。没有它时体积的系统误差未知。保存在案例中</translation>
    </message>
    <message>
        <source>Section…</source>
        <translation>剖面…</translation>
    </message>
    <message>
        <source>Draw a line on the difference map: run and survey are cut along it, drawn and measured together</source>
        <translation>在差异图上画一条线：沿线剖切计算和测绘，一起绘出并量取</translation>
    </message>
    <message>
        <source>Neither side has debris: there is no overlap, and heights are not compared.</source>
        <translation>两侧都没有堆积物：没有重合度，也不比较高度。</translation>
    </message>
    <message>
        <source>Below it also lie fill %1, cut %2, net %3 m³, which are not counted.</source>
        <translation>低于检测限的还有填方 %1、挖方 %2、净值 %3 m³，未计入。</translation>
    </message>
    <message>
        <source>How far centroids lie apart is not known: one side has no debris.</source>
        <translation>质心的距离未知：有一侧没有堆积物。</translation>
    </message>
    <message>
        <source>Register it to the ground and compare</source>
        <translation>配准到地面并比较</translation>
    </message>
    <message>
        <source>Say what it shows</source>
        <translation>说明其中有什么</translation>
    </message>
    <message>
        <source>Say when it was taken</source>
        <translation>说明拍摄时间</translation>
    </message>
    <message>
        <source>Pick pairs…</source>
        <translation>选取点对…</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::SurveyPlace</name>
    <message>
        <source>lies as its coordinates say</source>
        <translation>按自身坐标放置</translation>
    </message>
    <message>
        <source>moved by %1 m, turned by %2°</source>
        <translation>移动 %1 m，转动 %2°</translation>
    </message>
    <message>
        <source>pairs: %1, RMS %2 m</source>
        <translation>点对：%1，RMS %2 m</translation>
    </message>
    <message>
        <source>fitted, RMS %1 m before, %2 m after</source>
        <translation>已拟合，RMS 之前 %1 m，之后 %2 m</translation>
    </message>
    <message>
        <source>known to %1 m (standard deviation)</source>
        <translation>已知到 %1 m（标准差）</translation>
    </message>
    <message>
        <source>how well it is known is not known</source>
        <translation>准确程度未知</translation>
    </message>
    <message>
        <source>Taken before the collapse</source>
        <translation>拍摄于倒塌之前</translation>
    </message>
    <message>
        <source>Instant that the survey shows</source>
        <translation>测绘所示的时刻</translation>
    </message>
    <message>
        <source>Write date and time, such as 2021-06-25 16:30</source>
        <translation>请写日期和时间，如 2021-06-25 16:30</translation>
    </message>
    <message>
        <source>Unplace</source>
        <translation>取消放置</translation>
    </message>
    <message>
        <source>When the survey was taken</source>
        <translation>测绘的拍摄时间</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Date and time by the clock of the site, such as 2021-06-25 16:30. Places whose debris had been removed by then are left out. Kept in the case</source>
        <translation>按现场时钟的日期和时间，如 2021-06-25 16:30。此前堆积物已被运走之处不计入。保存在案例中</translation>
    </message>
    <message>
        <source>Taken</source>
        <translation>拍摄时间</translation>
    </message>
    <message>
        <source>It shows no debris and is not compared; take it as the terrain. Kept in the case</source>
        <translation>其中没有堆积物，不作比较；可将其用作地形。保存在案例中</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>Move the survey to where it belongs by three places or more, from a table with the columns survey_x, survey_y, survey_z, x_m, y_m, z_m</source>
        <translation>用三处或更多的地方把测绘移到应在之处，取自含 survey_x、survey_y、survey_z、x_m、y_m、z_m 各列的表</translation>
    </message>
    <message>
        <source>Let the survey lie as its coordinates say</source>
        <translation>使测绘按自身坐标放置</translation>
    </message>
    <message>
        <source>Pick pairs…</source>
        <translation>选取点对…</translation>
    </message>
    <message>
        <source>Pairs from a table…</source>
        <translation>取自表的点对…</translation>
    </message>
    <message>
        <source>Move the survey to where it belongs: click three places or more in it and in the model, and see at once how well they fit</source>
        <translation>把测绘移到其所在之处：在测绘和模型中单击三处或更多，并立即看到其相符程度</translation>
    </message>
    <message>
        <source>control points to %1 m</source>
        <translation>控制点精确到 %1 m</translation>
    </message>
    <message>
        <source>control points: accuracy not known</source>
        <translation>控制点：精度未知</translation>
    </message>
    <message>
        <source>Instant on the clock of the FE result that the survey shows; empty: all lay at rest. Kept in the case</source>
        <translation>测绘所示的时刻，按有限元结果的时间；留空：全部已静止。保存在案例中</translation>
    </message>
    <message>
        <source>Shows</source>
        <translation>显示时刻</translation>
    </message>
    <message>
        <source>Error of control points in a table</source>
        <translation>表中控制点的误差</translation>
    </message>
    <message>
        <source>Fit to what did not move…</source>
        <translation>拟合到未移动的部分…</translation>
    </message>
    <message>
        <source>Standard deviation of the places of a table along each axis, m, where it has no column deviation_m; it is part of the error of the registration</source>
        <translation>表中位置沿各轴的标准差，m，用于没有标准差列的表；计入配准误差</translation>
    </message>
    <message>
        <source>Control points to, m</source>
        <translation>控制点精度，m</translation>
    </message>
    <message>
        <source>Draw what did not move: the points there are fitted to the site by least squares, and what is left is told before you accept it</source>
        <translation>绘出未移动的部分：该处的点以最小二乘拟合到现场，接受之前列出剩余量</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::SurveyView</name>
    <message>
        <source>Difference map of the survey</source>
        <translation>测绘差异图</translation>
    </message>
    <message>
        <source>The difference map of a survey stands here: add a survey in the panel and compare.</source>
        <translation>测绘差异图在此显示：请在面板中添加测绘并比较。</translation>
    </message>
    <message>
        <source>Click around what is compared; double-click or Enter closes, Backspace takes one back, Esc ends.</source>
        <translation>沿比较的范围点击；双击或 Enter 闭合，Backspace 撤回一个，Esc 结束。</translation>
    </message>
    <message>
        <source>Click around what is left out; double-click or Enter closes, Backspace takes one back, Esc ends.</source>
        <translation>沿略去的部分点击；双击或 Enter 闭合，Backspace 撤回一个，Esc 结束。</translation>
    </message>
    <message>
        <source>Click around what was removed; double-click or Enter closes, Backspace takes one back, Esc ends.</source>
        <translation>沿被运走之物四周单击；双击或回车闭合，退格撤回一点，Esc 结束。</translation>
    </message>
    <message>
        <source>Click where the section begins, then where it ends; Backspace takes one back, Esc ends.</source>
        <translation>先单击剖面的起点，再单击终点；退格撤回一点，Esc 结束。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::Timeline</name>
    <message>
        <source>Timeline</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>已计算</translation>
    </message>
    <message>
        <source>Limits passed: %1</source>
        <translation>超过限值：%1</translation>
    </message>
    <message>
        <source>The timeline appears when a result is open.</source>
        <translation>打开结果后显示时间轴。</translation>
    </message>
    <message>
        <source>deaths</source>
        <translation>失效</translation>
    </message>
    <message>
        <source>health</source>
        <translation>健康</translation>
    </message>
    <message>
        <source>no element dies in this result</source>
        <translation>此结果中没有单元失效</translation>
    </message>
    <message>
        <source>%1 in one state</source>
        <translation>一个状态内 %1</translation>
    </message>
    <message>
        <source>FE ends</source>
        <translation>有限元结束</translation>
    </message>
    <message>
        <source>bookmarks</source>
        <translation>书签轨</translation>
    </message>
    <message>
        <source>Bookmark</source>
        <translation>书签</translation>
    </message>
    <message>
        <source>%1
%2; double-click to change</source>
        <translation>%1
%2；双击可更改</translation>
    </message>
    <message>
        <source>events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Deaths over time, those in islands that the engine carried, and what is computed. Drag to scrub; with Shift, drag the range that playback goes round.</source>
        <translation>随时间的失效、其中在引擎带动的孤立部分中的失效，以及已计算部分。拖动以浏览；按住 Shift 拖动设定循环播放的范围。</translation>
    </message>
    <message>
        <source>in islands</source>
        <translation>在孤立部分中</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1，从 %2 到 %3</translation>
    </message>
    <message>
        <source>Photograph %1
%2 ± %3</source>
        <translation>照片 %1
%2 ± %3</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::Tour</name>
    <message>
        <source>Back</source>
        <translation>后退</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Tour of the window</source>
        <translation>窗口导览</translation>
    </message>
    <message>
        <source>End the tour (Esc); the Help menu has it again</source>
        <translation>结束导览（Esc）；“帮助”菜单中可再次打开</translation>
    </message>
    <message>
        <source>The stop before (←)</source>
        <translation>上一站（←）</translation>
    </message>
    <message>
        <source>The next stop (→)</source>
        <translation>下一站（→）</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1，共 %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>跳过</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::Transport</name>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>First instant</source>
        <translation>起始时刻</translation>
    </message>
    <message>
        <source>To the first instant (Home)</source>
        <translation>到起始时刻（Home）</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后退</translation>
    </message>
    <message>
        <source>Back one state (←), ten with Shift</source>
        <translation>后退一个状态（←），加 Shift 十个</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>前进</translation>
    </message>
    <message>
        <source>Forward one state (→), ten with Shift</source>
        <translation>前进一个状态（→），加 Shift 十个</translation>
    </message>
    <message>
        <source>Last instant</source>
        <translation>最后时刻</translation>
    </message>
    <message>
        <source>To the last instant (End)</source>
        <translation>到最后时刻（End）</translation>
    </message>
    <message>
        <source>Playback rate: seconds of collapse per second</source>
        <translation>回放速率：每秒播放的倒塌秒数</translation>
    </message>
    <message>
        <source>Playback rate</source>
        <translation>回放速率</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>暂停（空格）</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>播放（空格）</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play backwards</source>
        <translation>倒放</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>循环</translation>
    </message>
    <message>
        <source>Playback goes round: the range dragged with Shift in the timeline, or all of it</source>
        <translation>循环回放：在时间轴上按住 Shift 拖出的区间，或整体</translation>
    </message>
    <message>
        <source>Bookmark</source>
        <translation>书签</translation>
    </message>
    <message>
        <source>Mark this instant with a note (B)</source>
        <translation>以备注标记此时刻（B）</translation>
    </message>
    <message>
        <source>Pause (Shift+Space)</source>
        <translation>暂停（Shift+空格）</translation>
    </message>
    <message>
        <source>Play backwards (Shift+Space)</source>
        <translation>倒放（Shift+空格）</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>共 %1</translation>
    </message>
    <message>
        <source>FE ends at %1</source>
        <translation>有限元在 %1 结束</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::ValidationView</name>
    <message>
        <source>set, variant</source>
        <translation>数据组，方式</translation>
    </message>
    <message>
        <source>figure</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>measured D</source>
        <translation>实测 D</translation>
    </message>
    <message>
        <source>simulated S</source>
        <translation>模拟 S</translation>
    </message>
    <message>
        <source>E = S − D (95 %)</source>
        <translation>E = S − D（95 %）</translation>
    </message>
    <message>
        <source>area (by chance)</source>
        <translation>面积（偶然）</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>asked</source>
        <translation>须满足</translation>
    </message>
    <message>
        <source>Measured and simulated falls</source>
        <translation>实测与模拟的下落</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>What was simulated with, and its source</source>
        <translation>以什么模拟，及其来源</translation>
    </message>
    <message>
        <source>Hold against measured falls</source>
        <translation>与实测的下落比较</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Validation: this program held against what really fell</source>
        <translation>验证：本程序与真实下落之物的比较</translation>
    </message>
    <message>
        <source>Agreement with the reference, in the panel Accuracy, is a verification and says nothing of the world; the self-test is one too.</source>
        <translation>“精度”面板中与基准的一致性属于核实，并不说明真实世界；自检也属于核实。</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Settings and sources</source>
        <translation>设置与来源</translation>
    </message>
    <message>
        <source>Progress of the validation</source>
        <translation>验证的进度</translation>
    </message>
    <message>
        <source>Simulates all sets that come with the program, as rubble-cli validate does; takes some minutes</source>
        <translation>模拟随程序提供的所有数据组，与 rubble-cli validate 相同；需要几分钟</translation>
    </message>
    <message>
        <source>Stop; sets that are done are kept</source>
        <translation>停止；已完成的数据组保留</translation>
    </message>
    <message>
        <source>This program was not held against measured falls on this machine yet.</source>
        <translation>本程序尚未在本机上与实测的下落比较。</translation>
    </message>
    <message>
        <source>Until then its rate of error is not in reports.</source>
        <translation>在此之前报告中没有其误差率。</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::VariedTable</name>
    <message>
        <source>Vary another parameter</source>
        <translation>变动另一个参数</translation>
    </message>
    <message>
        <source>Choose a parameter that every member gets a value of its own of</source>
        <translation>选择一个参数，使每个成员各有取值</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>方案</translation>
    </message>
    <message>
        <source>Nothing is varied: members differ by a micrometre at birth, as the repeats of a run do.</source>
        <translation>没有变动的量：成员在产生时相差一微米，与重复计算相同。</translation>
    </message>
    <message>
        <source>Vary another parameter…</source>
        <translation>变动另一个参数…</translation>
    </message>
    <message>
        <source>Which scenario of the case a member is of</source>
        <translation>成员属于案例的哪个方案</translation>
    </message>
    <message>
        <source>Do not vary %1</source>
        <translation>不变动%1</translation>
    </message>
    <message>
        <source>Do not vary %1: every member has the value of the scenario</source>
        <translation>不变动%1：每个成员取方案的值</translation>
    </message>
    <message>
        <source>%1 not varied</source>
        <translation>%1不再变动</translation>
    </message>
    <message>
        <source>uniform</source>
        <translation>均匀</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>正态</translation>
    </message>
    <message>
        <source>one of</source>
        <translation>取自</translation>
    </message>
    <message>
        <source>Distribution of %1</source>
        <translation>%1的分布类型</translation>
    </message>
    <message>
        <source>uniform: every value from the least to the greatest is as likely. normal: around a mean with a standard deviation, cut at the range of the parameter. one of: the values given, all as likely</source>
        <translation>均匀：从最小到最大的每个值可能性相同。正态：围绕平均值，具有标准差，截断于参数范围。取自：给定的值，可能性相同</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>平均值</translation>
    </message>
    <message>
        <source>least</source>
        <translation>最小值</translation>
    </message>
    <message>
        <source>Mean of the members.</source>
        <translation>成员的平均值。</translation>
    </message>
    <message>
        <source>Least value of a member.</source>
        <translation>成员的最小值。</translation>
    </message>
    <message>
        <source>to</source>
        <translation>至</translation>
    </message>
    <message>
        <source>standard deviation</source>
        <translation>标准差</translation>
    </message>
    <message>
        <source>greatest</source>
        <translation>最大值</translation>
    </message>
    <message>
        <source>Standard deviation of the members, above zero</source>
        <translation>成员的标准差，大于零</translation>
    </message>
    <message>
        <source>Greatest value of a member.</source>
        <translation>成员的最大值。</translation>
    </message>
    <message>
        <source>Values of %1</source>
        <translation>%1的取值</translation>
    </message>
    <message>
        <source>Values separated by commas, with a point as decimal sign; all as likely. From %1 to %2</source>
        <translation>用逗号分隔的值，小数点为点号；可能性相同。%1 至 %2</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Members may have this; all that are ticked are as likely</source>
        <translation>成员可取此值；所有勾选的可能性相同</translation>
    </message>
    <message>
        <source>%1 varied</source>
        <translation>%1变动</translation>
    </message>
    <message>
        <source>distribution of %1</source>
        <translation>%1的分布</translation>
    </message>
</context>
<context>
    <name>rubble::widgets::ViewWidget</name>
    <message>
        <source>Views of the collapse</source>
        <translation>视图：倒塌过程</translation>
    </message>
</context>
<context>
    <name>samples</name>
    <message>
        <source>An FE result as it comes from the analysis, without a case.</source>
        <translation>直接来自分析的有限元结果，没有案例。</translation>
    </message>
    <message>
        <source>Stone arch bridge, four spans</source>
        <translation>四跨石拱桥</translation>
    </message>
    <message>
        <source>Reinforced concrete arch above a river</source>
        <translation>跨河钢筋混凝土拱桥</translation>
    </message>
    <message>
        <source>All concrete is reinforced; the river flows north at 1 m/s with its surface half a metre below the valley floor.</source>
        <translation>所有混凝土均配筋；河水以 1 m/s 向北流动，水面低于谷底半米。</translation>
    </message>
    <message>
        <source>The strips whose loss of strength starts the collapse belong to their arch rings. All is natural stone of 2,400 kg/m3, as in the FE result; EN 1991-1-1:2002, table A.2, gives sandstone 21 to 27 kN/m3 (2,140 to 2,750 kg/m3).</source>
        <translation>因强度丧失而引发倒塌的条带归入各自的拱圈。全部为天然石材，密度 2,400 kg/m3，与有限元结果相同；EN 1991-1-1:2002 表 A.2 给出砂岩 21 至 27 kN/m3（2,140 至 2,750 kg/m3）。</translation>
    </message>
</context>
<context>
    <name>selftest</name>
    <message>
        <source>0.90 to 1.05 of e2 h at 60 steps per second, 1 +- 0.03 at 240</source>
        <translation>每秒 60 步时为 e2 h 的 0.90 至 1.05，240 步时为 1 +- 0.03</translation>
    </message>
    <message>
        <source>1 mm after 2 s</source>
        <translation>2 s 后偏差 1 mm 以内</translation>
    </message>
    <message>
        <source>99 % overlap below 5 % of a side, gain below 0.1 %, no faster than a fall, none below ground</source>
        <translation>99 % 的重叠小于边长的 5 %，能量增加低于 0.1 %，不快于下落，无一低于地面</translation>
    </message>
    <message>
        <source>Coulomb&apos;s law at every impact, way within 1 %</source>
        <translation>每次撞击符合库仑定律，路程偏差 1 % 以内</translation>
    </message>
    <message>
        <source>F L / (E A) within 1e-6 m; breaks at its elongation, when s = F t2 / m says</source>
        <translation>F L / (E A) 偏差 1e-6 m 以内；按 s = F t2 / m 的时刻在其伸长处断裂</translation>
    </message>
    <message>
        <source>acceleration within 0.5 %</source>
        <translation>加速度偏差 0.5 % 以内</translation>
    </message>
    <message>
        <source>all fall within 0.5 s, none below ground</source>
        <translation>0.5 s 内全部下落，无一低于地面</translation>
    </message>
    <message>
        <source>all finite, none below ground, gain below 0.1 %, no faster than a fall</source>
        <translation>数值均有限，无一低于地面，能量增加低于 0.1 %，不快于下落</translation>
    </message>
    <message>
        <source>angle of repose 30 to 45 degrees</source>
        <translation>休止角 30 至 45 度</translation>
    </message>
    <message>
        <source>angular momentum within 0.1 %, energy within 1 % over 5 s</source>
        <translation>5 s 内角动量偏差 0.1 % 以内，能量偏差 1 % 以内</translation>
    </message>
    <message>
        <source>angular momentum within 0.1 %, energy within 1 %, tumbles</source>
        <translation>角动量偏差 0.1 % 以内，能量偏差 1 % 以内，发生翻转</translation>
    </message>
    <message>
        <source>at least 95 % of the height after 5 s</source>
        <translation>5 s 后至少保持高度的 95 %</translation>
    </message>
    <message>
        <source>at most 5 cm deep, bodies below 1.3 v</source>
        <translation>嵌入至多 5 cm，刚体速度低于 1.3 v</translation>
    </message>
    <message>
        <source>below 1 mm in 1 s</source>
        <translation>1 s 内小于 1 mm</translation>
    </message>
    <message>
        <source>below 1 mm in 1 s at 60 degrees</source>
        <translation>60 度时 1 s 内小于 1 mm</translation>
    </message>
    <message>
        <source>below 2 v, centre above ground</source>
        <translation>速度低于 2 v，质心在地面以上</translation>
    </message>
    <message>
        <source>below one step of gravity, moves less than 1 cm, keeps 99 % of its height</source>
        <translation>速度低于重力一步之值，移动小于 1 cm，保持高度的 99 %</translation>
    </message>
    <message>
        <source>bit for bit the run at zero</source>
        <translation>与原点处的计算逐位相同</translation>
    </message>
    <message>
        <source>bit for bit the same</source>
        <translation>逐位相同</translation>
    </message>
    <message>
        <source>bit for bit the whole run</source>
        <translation>与完整计算逐位相同</translation>
    </message>
    <message>
        <source>distance within 1 %, heading 0.1 degrees</source>
        <translation>距离偏差 1 % 以内，方向偏差 0.1 度以内</translation>
    </message>
    <message>
        <source>draught as the densities within 0.1 mm, terminal speed within 1e-6</source>
        <translation>吃水按密度比，偏差 0.1 mm 以内，终速偏差 1e-6 以内</translation>
    </message>
    <message>
        <source>e2 h within 3 %</source>
        <translation>e2 h，偏差 3 % 以内</translation>
    </message>
    <message>
        <source>each refused at birth by name</source>
        <translation>每个在产生时即被点名拒绝</translation>
    </message>
    <message>
        <source>energy never rises by over 0.1 %</source>
        <translation>能量增加从不超过 0.1 %</translation>
    </message>
    <message>
        <source>g (sin a - mu cos a) within 0.5 %</source>
        <translation>g (sin a - mu cos a)，偏差 0.5 % 以内</translation>
    </message>
    <message>
        <source>gain below 0.1 %, 99 % overlap below 10 % of a side</source>
        <translation>能量增加低于 0.1 %，99 % 的重叠小于边长的 10 %</translation>
    </message>
    <message>
        <source>gain below 0.1 %, 99 % overlap below 10 % of a side, none below ground</source>
        <translation>能量增加低于 0.1 %，99 % 的重叠小于边长的 10 %，无一低于地面</translation>
    </message>
    <message>
        <source>gain below 0.1 %, no faster than a fall, none below ground</source>
        <translation>能量增加低于 0.1 %，不快于下落，无一低于地面</translation>
    </message>
    <message>
        <source>keeps its speed within 0.1 % for 3 s</source>
        <translation>3 s 内速度保持，偏差 0.1 % 以内</translation>
    </message>
    <message>
        <source>m g = rho C_d A v2 / 2, speed within 0.2 %</source>
        <translation>m g = rho C_d A v2 / 2，速度偏差 0.2 % 以内</translation>
    </message>
    <message>
        <source>mean height and spread within 5 % of the finest, the last halving within 2.5 %, beyond two standard errors of 8 seeds</source>
        <translation>平均高度与展布同最细步长相差 5 % 以内，最后一次减半 2.5 % 以内，均不计 8 个种子的两倍标准误差</translation>
    </message>
    <message>
        <source>mean height within 0.1 % (1 % without freezing), nobody above 0.5 m/s, in a middle heap</source>
        <translation>居中的堆：平均高度变化 0.1 % 以内（不冻结时 1 %），无一超过 0.5 m/s</translation>
    </message>
    <message>
        <source>momentum to 1e-9, speeds within 1 % of the approach</source>
        <translation>动量偏差 1e-9，速度与接近速度相差 1 % 以内</translation>
    </message>
    <message>
        <source>never faster than 1 cm/s, then apart</source>
        <translation>速度从不超过 1 cm/s，随后分开</translation>
    </message>
    <message>
        <source>no faster than a fall, gain below 0.1 %, none below ground</source>
        <translation>不快于下落，能量增加低于 0.1 %，无一低于地面</translation>
    </message>
    <message>
        <source>no faster than a fall, upwards below 1 m/s, gain below 0.1 %, no higher than poured by over 5 %, solid fraction below 0.70</source>
        <translation>不快于下落，向上低于 1 m/s，能量增加低于 0.1 %，高度不超过倾倒堆 5 %，密实度低于 0.70</translation>
    </message>
    <message>
        <source>no faster than press and fall, no rise above 0.1 m, gain below 0.1 %</source>
        <translation>不快于压下与下落，上升不超过 0.1 m，能量增加低于 0.1 %</translation>
    </message>
    <message>
        <source>none below ground, none above 1.1 sqrt(2 g h), end below 1 m/s, in each of several heaps</source>
        <translation>多个堆中：无一低于地面，无一超过 1.1 sqrt(2 g h)，结束时低于 1 m/s</translation>
    </message>
    <message>
        <source>none of 100 below</source>
        <translation>100 个中无一在下方</translation>
    </message>
    <message>
        <source>none of 100 through</source>
        <translation>100 个中无一穿过</translation>
    </message>
    <message>
        <source>none of 64 through, no faster than the fall</source>
        <translation>64 个中无一穿过，不快于下落</translation>
    </message>
    <message>
        <source>place within 1 mm</source>
        <translation>位置偏差 1 mm 以内</translation>
    </message>
    <message>
        <source>places and corners within 2 cm after 0.8 s</source>
        <translation>0.8 s 后位置与角点偏差 2 cm 以内</translation>
    </message>
    <message>
        <source>refused, with a remedy</source>
        <translation>被拒绝，并给出补救办法</translation>
    </message>
    <message>
        <source>run-out 1.6 a^0.5: exponent +- 0.12, factor 1.6; height within a factor of 1.6</source>
        <translation>散落距离 1.6 a^0.5：指数 +- 0.12，系数 1.6 倍以内；高度 1.6 倍以内</translation>
    </message>
    <message>
        <source>run-out 1.9 a^(2/3): exponent +- 0.12, factor 1.6; height within a factor of 1.6</source>
        <translation>散落距离 1.9 a^(2/3)：指数 +- 0.12，系数 1.6 倍以内；高度 1.6 倍以内</translation>
    </message>
    <message>
        <source>run-out scatters by 20 % or more, 95 % at rest after 40 s</source>
        <translation>散落距离离散 20 % 以上，40 s 后 95 % 静止</translation>
    </message>
    <message>
        <source>sinks less than a quarter of the small side, below 1 m/s</source>
        <translation>下陷小于较小边长的四分之一，低于 1 m/s</translation>
    </message>
    <message>
        <source>solid fraction at most 0.70, none below ground, 99 % overlap less than 5 cm</source>
        <translation>密实度至多 0.70，无一低于地面，99 % 的重叠小于 5 cm</translation>
    </message>
    <message>
        <source>stands, asleep, drifts less than 10 cm</source>
        <translation>直立、休眠、漂移小于 10 cm</translation>
    </message>
    <message>
        <source>stands, asleep, drifts less than 2 cm</source>
        <translation>直立、休眠、漂移小于 2 cm</translation>
    </message>
    <message>
        <source>stays a fragment, counted</source>
        <translation>仍为碎块，并计数</translation>
    </message>
    <message>
        <source>stays with its element, counted</source>
        <translation>留在其单元上，并计数</translation>
    </message>
    <message>
        <source>the body leaves at that state</source>
        <translation>刚体在该状态离开</translation>
    </message>
    <message>
        <source>the same, momentum handed over to 1e-9</source>
        <translation>同上，移交的动量偏差 1e-9</translation>
    </message>
    <message>
        <source>the same, no half extent below 2.5 % of the longest or 5 mm, counted</source>
        <translation>同上，半尺寸不小于最长者的 2.5 % 或 5 mm，并计数</translation>
    </message>
    <message>
        <source>travels within 1 % after the slip</source>
        <translation>滑动之后路程偏差 1 % 以内</translation>
    </message>
    <message>
        <source>v2 / (2 mu g) within 1 %</source>
        <translation>v2 / (2 mu g)，偏差 1 % 以内</translation>
    </message>
    <message>
        <source>way and speed within 1 %</source>
        <translation>路程与速度偏差 1 % 以内</translation>
    </message>
    <message>
        <source>within 0.3 degrees of 18.43</source>
        <translation>与 18.43 相差 0.3 度以内</translation>
    </message>
</context>
<context>
    <name>validation</name>
    <message>
        <source>Tosses of an acrylic cube on a wooden board</source>
        <translation>亚克力立方体抛到木板上</translation>
    </message>
    <message>
        <source>Rockfall runs at Tschamut</source>
        <translation>Tschamut 的落石试验</translation>
    </message>
    <message>
        <source>Dice poured into a vessel</source>
        <translation>倒入容器的骰子</translation>
    </message>
    <message>
        <source>Round columns of cubes, rods and plates collapse</source>
        <translation>立方体、杆和板的圆柱坍塌</translation>
    </message>
    <message>
        <source>Blocks and walls on a tilting table, and an arch</source>
        <translation>倾斜台上的石块和墙，以及一座拱</translation>
    </message>
    <message>
        <source>limit analysis of rigid blocks, closed form: a verification, no measurement</source>
        <translation>刚体的极限分析，闭式解：属于核实，不是测量</translation>
    </message>
    <message>
        <source>blind</source>
        <translation>盲算</translation>
    </message>
    <message>
        <source>published</source>
        <translation>按发表的数值</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>经拟合</translation>
    </message>
    <message>
        <source>blind, one value each</source>
        <translation>盲算，各取一个值</translation>
    </message>
    <message>
        <source>blind, obstacles of 0.03 m</source>
        <translation>盲算，障碍物 0.03 m</translation>
    </message>
    <message>
        <source>blind, obstacles of 0.05 m</source>
        <translation>盲算，障碍物 0.05 m</translation>
    </message>
    <message>
        <source>blind, obstacles of 0.1 m</source>
        <translation>盲算，障碍物 0.1 m</translation>
    </message>
    <message>
        <source>cubes, friction 0.3</source>
        <translation>立方体，摩擦 0.3</translation>
    </message>
    <message>
        <source>cubes, friction 0.5</source>
        <translation>立方体，摩擦 0.5</translation>
    </message>
    <message>
        <source>cubes, friction 0.8</source>
        <translation>立方体，摩擦 0.8</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>四面体</translation>
    </message>
    <message>
        <source>octahedra</source>
        <translation>八面体</translation>
    </message>
    <message>
        <source>dodecahedra</source>
        <translation>十二面体</translation>
    </message>
    <message>
        <source>icosahedra</source>
        <translation>二十面体</translation>
    </message>
    <message>
        <source>columns of cubes</source>
        <translation>立方体的柱</translation>
    </message>
    <message>
        <source>columns of rods</source>
        <translation>杆的柱</translation>
    </message>
    <message>
        <source>columns of plates</source>
        <translation>板的柱</translation>
    </message>
    <message>
        <source>cube slides</source>
        <translation>立方体滑动</translation>
    </message>
    <message>
        <source>cube topples</source>
        <translation>立方体倾覆</translation>
    </message>
    <message>
        <source>pillar topples</source>
        <translation>柱体倾覆</translation>
    </message>
    <message>
        <source>wall across</source>
        <translation>墙沿厚度方向</translation>
    </message>
    <message>
        <source>wall across, 120 steps</source>
        <translation>墙沿厚度方向，120 步</translation>
    </message>
    <message>
        <source>arch</source>
        <translation>拱</translation>
    </message>
    <message>
        <source>arch, 240 steps</source>
        <translation>拱，每秒 240 步</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>假定</translation>
    </message>
    <message>
        <source>assumed: the source measured none; varied for cubes</source>
        <translation>假定：来源未测量；对立方体取不同的值</translation>
    </message>
    <message>
        <source>assumed: the sources find that it matters little</source>
        <translation>假定：来源发现其影响很小</translation>
    </message>
    <message>
        <source>assumed: less than a block</source>
        <translation>假定：小于一个块体</translation>
    </message>
    <message>
        <source>given</source>
        <translation>给定</translation>
    </message>
    <message>
        <source>given: nothing slides</source>
        <translation>给定：不发生滑动</translation>
    </message>
    <message>
        <source>stands in for wood: the table of materials has none</source>
        <translation>代替木材：材料表中没有木材</translation>
    </message>
    <message>
        <source>a meadow: the table&apos;s stone on soil</source>
        <translation>草地：取表中石材对土的值</translation>
    </message>
    <message>
        <source>0.35 to 0.60, range of the table&apos;s stone on soil, as ensembles draw it</source>
        <translation>0.35 至 0.60，表中石材对土的范围，与系综的抽取相同</translation>
    </message>
    <message>
        <source>0.05 to 0.3, range of the table&apos;s stone on soil, as ensembles draw it</source>
        <translation>0.05 至 0.3，表中石材对土的范围，与系综的抽取相同</translation>
    </message>
    <message>
        <source>fitted on one half, judged on the other</source>
        <translation>用一半拟合，用另一半评判</translation>
    </message>
    <message>
        <source>fitted on the other half, judged on the one</source>
        <translation>用另一半拟合，用这一半评判</translation>
    </message>
    <message>
        <source>assumed: nobody measured it here; the low end of the mean obstacle heights that rockfall models ask for (Rockyfor3D, Dorren 2016)</source>
        <translation>假定：此处无人测量；落石模型所要求的平均障碍物高度的低端（Rockyfor3D，Dorren 2016）</translation>
    </message>
    <message>
        <source>assumed: nobody measured it here; of the mean obstacle heights that rockfall models ask for (Rockyfor3D, Dorren 2016)</source>
        <translation>假定：此处无人测量；取自落石模型所要求的平均障碍物高度（Rockyfor3D，Dorren 2016）</translation>
    </message>
</context>
</TS>
