// Words of the page, English and Chinese.
const words = {
    skip: ['To the player', '跳到播放器'],
    language: ['Language', '语言'],
    contrast: ['High contrast', '高对比度'],
    loading: ['Opening…', '正在打开…'],
    viewsLabel: ['Both views of the collapse', '倒塌过程的两个视图'],
    viewsHelp: ['Arrow keys turn, with Shift they move; plus and minus come nearer and farther; Enter picks what is in the middle; ' +
        'space plays; comma and full stop step; 1 to 4 look from the side, the end, above and a corner; F shows everything.',
    '方向键旋转，按住 Shift 平移；加减号缩放；回车选取中心处的对象；空格播放；逗号和句号逐帧；1 到 4 为侧面、端部、上方和角部视角；F 显示全部。'],
    timeline: ['Timeline', '时间轴'],
    toStart: ['To the start', '回到开头'],
    stepBack: ['One recorded instant back', '后退一个记录时刻'],
    stepForward: ['One recorded instant on', '前进一个记录时刻'],
    play: ['Play', '播放'],
    pause: ['Pause', '暂停'],
    time: ['Time', '时刻'],
    pace: ['Pace', '速度'],
    lag: ['too slow a machine: plays at {0}', '机器较慢：实际速度 {0}'],
    stills: ['Pictures of the run', '计算的图片'],
    noScript: ['The views need scripts and WebGL 2. These pictures show the run without them.', '视图需要脚本和 WebGL 2。以下图片不依赖它们。'],
    noWebGl: ['This browser has no WebGL 2, so the views cannot be turned. These pictures were drawn by the program.',
        '此浏览器没有 WebGL 2，因此无法转动视图。以下图片由程序绘制。'],
    lost: ['The browser has lost its graphics; open the page again. These pictures were drawn by the program.',
        '浏览器失去了图形环境；请重新打开页面。以下图片由程序绘制。'],
    noPictures: ['The page was made without pictures.', '此页面没有附带图片。'],
    damaged: ['The views cannot be shown: the data of this page are damaged, or the browser cannot draw them ({0}). These pictures were ' +
        'drawn by the program.',
    '无法显示视图：此页面的数据已损坏，或浏览器无法绘制 ({0})。以下图片由程序绘制。'],
    stillAlt: ['FE result and fragments, t = {0} s', '有限元结果和碎块，t = {0} s'],
    outside: ['outside the time of the run', '不在计算的时间范围内'],
    side: ['Details', '详情'],
    story: ['Story', '过程'],
    pick: ['Pick', '选取'],
    look: ['Look', '外观'],
    evidence: ['Evidence', '证据'],
    health: ['Health', '健康'],
    about: ['Source', '来源'],
    fePane: ['Conventional FE result', '常规有限元结果'],
    bodiesPane: ['Bodies that are not let go yet', '尚未放开的物体'],
    given: ['given', '给定'],
    fragmentPane: ['Fragments', '碎块'],
    between: ['interpolated', '插值'],
    atState: ['state {0} of {1}', '状态 {0}/{1}'],
    simulated: ['simulated', '模拟'],
    computed: ['computed', '计算'],
    looking: ['looking {0} ({1}°)', '朝{0} ({1}°)'],
    lookingFrame: ['looking {0}° from x towards y', '视线从 x 向 y 转 {0}°'],
    winds: ['north,north-east,east,south-east,south,south-west,west,north-west', '北,东北,东,东南,南,西南,西,西北'],
    activeCount: ['{0} active', '{0} 个活动'],
    pieceCount: ['{0} fragments', '{0} 个碎块'],
    chapters: ['Chapters', '章节'],
    start: ['First state of the FE result', '有限元结果的首个状态'],
    first: ['First fragment', '首个碎块产生'],
    feEnd: ['End of the FE result', '有限元结果结束'],
    end: ['End of the simulation', '模拟结束'],
    outcome: ['What came out', '结果'],
    fragments: ['fragments', '碎块'],
    theirMass: ['their mass', '其质量'],
    liveFell: ['live structure that moved farther than {0} m', '移动超过 {0} m 的未失效结构'],
    bodies: ['rigid bodies of fragments', '碎块的刚体'],
    islands: ['loose parts of live structure', '松脱的未失效结构部分'],
    endsAt: ['simulated until', '模拟至'],
    atRest: ['at rest at the end', '结束时静止的份额'],
    stillMoving: ['still moving', '仍在运动'],
    fastest: ['fastest body', '最快刚体'],
    notComplete: ['This run was stopped before its end: it shows {0} recorded instants, until {1} s. What lay at rest is not known.',
        '此计算在结束前被停止：共 {0} 个记录时刻，至 {1} s。静止状态未知。'],
    tainted: ['This run is tainted: limits of health were passed ({0}) and nobody has acknowledged it. Its figures should not be ' +
        'relied on; see Health.',
        '此计算存疑：有 {0} 项健康限值被超过且无人确认。其数据不可依赖；见“健康”。'],
    vouched: ['Limits of health were passed ({0}). {1} vouches for the use of this run: {2}', '有 {0} 项健康限值被超过。{1} 确认可用此计算：{2}'],
    pickHelp: ['Click something in a view, or type the number of an element.', '在视图中单击对象，或输入单元编号。'],
    elementNumber: ['Element number', '单元编号'],
    find: ['Find', '查找'],
    noElement: ['There is no element {0}.', '没有单元 {0}。'],
    nothingThere: ['Nothing there.', '该处没有对象。'],
    element: ['element', '单元'],
    component: ['component', '构件'],
    shows: ['shown as', '显示为'],
    asFragment: ['fragment', '碎块'],
    asStructure: ['structure that stands', '未倒结构'],
    asIsland: ['loose structure on a rigid body', '刚体承载的松脱结构'],
    asGone: ['no longer there', '已不存在'],
    death: ['deactivated at', '失效时刻'],
    never: ['never', '从未'],
    mass: ['mass', '质量'],
    cluster: ['cluster', '聚类'],
    place: ['place now', '当前位置'],
    movedBy: ['moved from rest', '离开初始位置'],
    speed: ['speed now', '当前速度'],
    meanSpeed: ['speed now, mean over {0} s', '当前速度，{0} s 内的平均值'],
    lies: ['place at the end', '结束时位置'],
    pathLength: ['length of its path', '路径长度'],
    goBirth: ['To its death', '到失效时刻'],
    moreComponents: ['{0} more, listed under Look', '另有 {0} 个，列于“外观”'],
    clusterColours: ['a colour for each cluster; the {0} colours repeat', '每个聚类一种颜色；{0} 种颜色重复使用'],
    clear: ['Clear', '清除'],
    measure: ['Measure', '测量'],
    measureHelp: ['Pick two points on surfaces.', '在表面上选取两点。'],
    measured: ['{0} m apart: {1} m level, {2} m in height', '相距 {0} m：水平 {1} m，高差 {2} m'],
    style: ['Style', '样式'],
    presentation: ['Presentation: materials, sun and shadows', '展示：材料、日光和阴影'],
    analysis: ['Analysis: fragments in colour', '分析：碎块着色'],
    contrastStyle: ['High contrast shows the colours of analysis.', '高对比度使用分析的颜色。'],
    noShadows: ['This browser draws no shadows: it cannot keep depths in a texture.', '此浏览器不绘制阴影：它无法在纹理中保存深度。'],
    edges: ['edges of large elements; contours at rest', '较大单元的边线；静止时的轮廓线'],
    byMaterial: ['material', '材料'],
    materials: [['stone', 'concrete', 'steel', 'masonry', 'soil', 'water bed'], ['石材', '混凝土', '钢', '砌体', '土', '水底']],
    assumed: ['{0} (assumed)', '{0}（假定）'],
    asMaterial: ['as {0}, for no material has its density', '按{0}处理：没有材料具有此密度'],
    colours: ['Colours of fragments', '碎块颜色'],
    highlight: ['highlighted', '突出显示'],
    byComponent: ['component', '构件'],
    byBirth: ['time of death', '失效时刻'],
    bySpeed: ['speed', '速度'],
    byCluster: ['cluster', '聚类'],
    view: ['View', '视图'],
    lookSide: ['Side', '侧面'],
    lookEnd: ['End', '端部'],
    lookTop: ['Above', '上方'],
    lookCorner: ['Corner', '角部'],
    everything: ['Everything', '显示全部'],
    showStructure: ['standing structure among the fragments', '在碎块视图中显示未倒结构'],
    structure: ['structure', '结构'],
    released: ['loose structure', '松脱结构'],
    shortcuts: ['Keys', '按键'],
    map: ['Debris map at the end', '结束时的碎块图'],
    mapLine: ['{0} fragments of {1} t on {2} m², in cells of {3} m. Beside them {4} live elements of {5} t have moved farther than {6} m.',
        '{0} 个碎块共 {1} t，覆盖 {2} m²，网格 {3} m。另有 {4} 个存活单元共 {5} t 移动超过 {6} m。'],
    photographs: ['Photographs', '照片'],
    photoAlt: ['Photograph {0} with the outline drawn on it and that of the simulated debris', '照片 {0}，带有手绘轮廓和模拟碎块的轮廓'],
    mapAlt: ['Map of the mass of the debris by cells', '按网格的碎块质量图'],
    noCase: ['The page was made without a case, so no photographs belong to it.', '此页面不含案例，因此没有照片。'],
    noPhotographs: ['The case has no photographs.', '案例没有照片。'],
    unmatched: ['Nothing was drawn and no camera matched on {0} of the {1} photographs of the case: they are not shown.',
        '案例的 {1} 张照片中有 {0} 张未作标注，也未匹配相机，因此不显示。'],
    healthy: ['No limit of health was passed.', '没有健康限值被超过。'],
    passed: ['Limits that were passed', '被超过的限值'],
    when: ['when [s]', '时间 [s]'],
    grade: ['grade', '等级'],
    what: ['what', '内容'],
    watched: ['What was watched', '监测量'],
    energyGain: ['energy gained, of the work of gravity', '能量增量占重力功'],
    penetration: ['deepest overlap over 0.5 s', '超过 0.5 s 的最深重叠'],
    ofSide: ['the same, of a smallest side', '同上，占最短边'],
    speedShare: ['fastest, of what birth and fall allow', '最快速度与允许值之比'],
    farthest: ['farthest from the structure', '距结构最远'],
    ledger: ['Ledger of the hand-over', '交接的守恒账目'],
    massError: ['mass, fragments against FE result', '质量：碎块与有限元结果之差'],
    momentumError: ['momentum, the same', '动量：同上'],
    validation: ['Validation: measured falls', '验证：实测的下落'],
    notValidated: ['The build that simulated this run was not held against measured falls where this page was made. Its rate of error is ' +
        'not known here.', '在生成此页面的机器上，模拟所用的版本未与实测的下落比较过。此处不知其误差率。'],
    validated: ['The build that simulated this run was held against bodies that really fell. None of them is of this collapse. E is ' +
        'simulated less measured, of means, with the interval that holds it in 95 of 100 resamplings.',
    '模拟所用的版本与真实下落的物体比较过，其中没有一项属于此次倒塌。E 为模拟均值减实测均值，括号内为 100 次重采样中 95 次所在的区间。'],
    setVariant: ['{0}, {1}. ', '{0}，{1}。'],
    falls: ['{0} falls simulated, of which {1} are in no mean. ', '模拟了 {0} 次下落，其中 {1} 次不计入均值。'],
    asked: ['{0} of {1} figures are as asked.', '{1} 项指标中有 {0} 项符合要求。'],
    figure: ['figure', '指标'],
    measuredMean: ['measured', '实测'],
    simulatedMean: ['simulated', '模拟'],
    comparisonError: ['E (95 %)', 'E（95 %）'],
    range: ['{0} to {1}', '{0} 至 {1}'],
    findings: ['Findings', '发现项'],
    noFindings: ['There are none.', '没有。'],
    remedy: ['Remedy', '处理'],
    limits: ['Limits', '局限'],
    limitPlaces: ['Places of fragments on this page lie within {0} mm of those recorded, at every recorded instant. Between instants ' +
        'they are interpolated.', '本页碎块位置在每个记录时刻与记录值相差不超过 {0} mm；其间为插值。'],
    limitNodes: ['Nodes of the FE result lie within {0} mm at every state. Between states they are interpolated.',
        '有限元节点在每个状态相差不超过 {0} mm；其间为插值。'],
    limitNodesKept: ['Nodes of the FE result lie within {0} mm at {1} of {2} states; at those between them up to {3} mm from where they ' +
        'were computed.', '有限元节点在 {2} 个状态中的 {1} 个相差不超过 {0} mm；在其间的状态与计算位置最多相差 {3} mm。'],
    limitStates: ['{0} of {1} states of the FE result are left out to keep the page small; deaths keep their own times.',
        '为减小页面，省略了 {1} 个有限元状态中的 {0} 个；失效时刻保持不变。'],
    limitTerrain: ['Of the terrain every {0} m are drawn; fragments fell on cells of {1} m.', '地形按 {0} m 绘制；碎块实际落在 {1} m 的网格上。'],
    limitAround: ['The views do not draw what surrounds the structure: {0}.', '视图不绘制结构周围的内容：{0}。'],
    limitAroundLarge: [' It has more triangles than a page takes.', '其三角形数超过页面的上限。'],
    limitSite: ['What stands around the structure lies within {0} mm of its files, in {1} triangles.', '结构周围的物体与其文件相差不超过 {0} mm，共 {1} 个三角形。'],
    limitPhoto: ['The picture of the ground has pixels of {0} m, its file has pixels of {1} m.', '地面影像的像素为 {0} m，其文件的像素为 {1} m。'],
    limitFallenOn: [' Debris that seems to rest on nothing may lie on it.', '看似悬空的碎块可能落在其上。'],
    limitPoints: ['While it plays on a slow machine, fewer pixels are drawn, and small fragments as squares; of those that cover one ' +
        'another only the nearest. FE states are then not interpolated, fragments throw no shadows, and nothing has edges or contours. When it ' +
        'stops, everything is drawn in full.',
    '在较慢的机器上播放时，像素减少，小碎块画为方块，相互遮挡的只画最近的，有限元状态不作插值，碎块不投阴影，没有边线和轮廓线；停止时完整绘制。'],
    limitLook: ['Sun, shadows, grain of materials, earth and water are illustrative: the sun is not that of the day, and materials have the ' +
        'colour of their class.', '日光、阴影、材料纹理、地面和水面仅为示意：太阳不是当日的太阳，材料只有其类别的颜色。'],
    limitSize: ['The size of fragments is the size of the elements: a finer mesh gives smaller debris, and nothing breaks below it.',
        '碎块尺寸即单元尺寸：网格越细碎块越小，且不会再破碎。'],
    limitLoad: ['Fragments do not load the structure back: what still stands moves as the FE result says.',
        '碎块不会对结构反向加载：未倒部分按有限元结果运动。'],
    limitChaos: ['Rigid piles are chaotic: a change of a micrometre moves single fragments by metres. Single fragments are never evidence.',
        '刚体堆积是混沌的：一微米的改变会使单个碎块移动数米。单个碎块不能作为证据。'],
    limitCluster: ['A cluster is a device of computation and no piece of debris.', '聚类是计算手段，不是实际碎块。'],
    provenance: ['Provenance', '来源'],
    made: ['page made', '页面生成'],
    program: ['program', '程序'],
    runBuild: ['build that simulated', '模拟所用版本'],
    pageBuild: ['build that wrote the page', '生成页面的版本'],
    fingerprint: ['fingerprint of the run', '计算指纹'],
    trajectory: ['hash of the trajectory', '轨迹散列'],
    coordinates: ['coordinates', '坐标'],
    files: ['Files with their SHA-256', '文件及其 SHA-256'],
    role: ['role', '用途'],
    name: ['name', '名称'],
    settings: ['Settings that depart from those delivered', '与默认值不同的设置'],
    setting: ['setting', '设置'],
    delivered: ['delivered', '默认'],
    inRun: ['in this run', '本次计算'],
    noSettings: ['All settings are those delivered.', '全部设置为默认值。'],
    download: ['Provenance as JSON', '来源信息 (JSON)'],
    roles: [{ fe: 'FE result', terrain: 'terrain', surroundings: 'surroundings', photograph: 'photograph', survey: 'survey' },
        { fe: '有限元结果', terrain: '地形', surroundings: '周边', photograph: '照片', survey: '测绘' }],
    playing: ['Playing', '正在播放'],
    stopped: ['Stopped at {0} s', '停在 {0} s']
};

const speech = { chinese: /^zh/i.test(navigator.language || '') };

function say(key, ...values) {
    const text = words[key][speech.chinese ? 1 : 0];
    return values.length === 0 ? text : text.replace(/\{(\d)\}/g, (whole, i) => String(values[i]));
}

// Of a text that the program wrote in both languages.
function sayText(text) {
    return text ? text[speech.chinese ? 'zh' : 'en'] : '';
}

// What stands in a list elsewhere, as a sentence of its own.
function saySentence(text) {
    const words = sayText(text);
    return words.charAt(0).toUpperCase() + words.slice(1) + (speech.chinese ? '。' : '.');
}

// Every number of the page: thousands are grouped, in both languages alike.
function sayGrouped(text) {
    const [, sign, whole, rest] = /^(-?)(\d*)(.*)$/.exec(text);
    return rest.includes('e') ? text : sign + whole.replace(/\B(?=(\d{3})+$)/g, ',') + rest;
}

function sayCount(number) {
    return sayGrouped(Math.round(number).toString());
}

function sayFixed(number, decimals) {
    return sayGrouped(number.toFixed(decimals));
}

function sayNumber(number, digits = 3) {
    if (number === null || number === undefined || !isFinite(number)) {
        return '–';
    }
    return sayGrouped(Number(number.toPrecision(digits)).toString());
}
