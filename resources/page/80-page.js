const legendComponents = 4;  // that the legend in the views has room for

const readJson = (id) => JSON.parse(document.getElementById(id).textContent);

// The page as a whole: what stands around the views, the keys, the language.
class Page {
    constructor() {
        this.facts = readJson('facts');
        this.panels = new Panels(this.facts, readJson('pictures'));
        this.player = null;
        this.bind();
        this.speak();
    }

    bind() {
        const on = (id, kind, listener) => document.getElementById(id).addEventListener(kind, listener);
        on('english', 'click', () => this.setLanguage(false));
        on('chinese', 'click', () => this.setLanguage(true));
        on('contrast', 'click', () => {
            const high = document.documentElement.classList.toggle('contrast');
            document.getElementById('contrast').setAttribute('aria-pressed', String(high));
            if (this.player) {
                this.player.setTones(high);
                this.panels.build();
                this.legendKey = '';
                this.refresh();
            }
        });
        on('play', 'click', () => this.toggle());
        on('first', 'click', () => this.jump(this.player.start));
        on('back', 'click', () => this.player.step(-1));
        on('forward', 'click', () => this.player.step(1));
        on('pace', 'change', (event) => {
            this.player.pace = Number(event.target.value);
        });
        on('time', 'input', (event) => {
            this.player.stop();
            this.player.scrubTo(Number(event.target.value));
        });
        on('time', 'keydown', (event) => {
            const way = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
            if (way) {
                event.preventDefault();
                this.player.step(way);
            }
        });
        this.bindViews();
    }

    bindViews() {
        const views = document.getElementById('views');
        let drag = null;
        const held = new Map();
        views.addEventListener('pointerdown', (event) => {
            if (!this.player) {
                return;
            }
            held.set(event.pointerId, [event.clientX, event.clientY]);
            drag = { x: event.clientX, y: event.clientY, moved: false, pan: event.button === 2 || event.shiftKey };
            views.setPointerCapture(event.pointerId);
        });
        views.addEventListener('pointermove', (event) => {
            if (!this.player || !drag || !held.has(event.pointerId)) {
                return;
            }
            const before = held.get(event.pointerId);
            const [dx, dy] = [event.clientX - before[0], event.clientY - before[1]];
            drag.moved = drag.moved || Math.abs(event.clientX - drag.x) + Math.abs(event.clientY - drag.y) > 4;
            if (drag.moved) {
                const others = [...held.entries()].filter(([id]) => id !== event.pointerId);
                const height = views.clientHeight;
                if (others.length > 0) {
                    const [ox, oy] = others[0][1];
                    const apart = Math.hypot(event.clientX - ox, event.clientY - oy);
                    this.player.camera.zoom(Math.hypot(before[0] - ox, before[1] - oy) / Math.max(1, apart));
                } else if (drag.pan) {
                    this.player.camera.pan(dx, dy, height);
                } else {
                    this.player.camera.orbit(dx * 0.008, dy * 0.008);
                }
                this.redraw();
            }
            held.set(event.pointerId, [event.clientX, event.clientY]);
        });
        const release = (event) => {
            if (this.player && drag && !drag.moved && event.type === 'pointerup' && held.size === 1) {
                const box = views.getBoundingClientRect();
                this.panels.picked(this.player.pickAt(event.clientX - box.left, event.clientY - box.top));
            }
            held.delete(event.pointerId);
            drag = held.size > 0 ? drag : null;
        };
        views.addEventListener('pointerup', release);
        views.addEventListener('pointercancel', release);
        views.addEventListener('contextmenu', (event) => event.preventDefault());
        views.addEventListener('wheel', (event) => {
            event.preventDefault();
            if (this.player) {
                this.player.camera.zoom(Math.exp(0.0012 * event.deltaY));
                this.redraw();
            }
        }, { passive: false });
        views.addEventListener('keydown', (event) => this.key(event));
    }

    key(event) {
        if (!this.player || event.ctrlKey || event.altKey || event.metaKey) {
            return;
        }
        const { camera } = this.player;
        const height = document.getElementById('views').clientHeight;
        const turns = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
        const looks = { 1: 'side', 2: 'end', 3: 'top', 4: 'corner' };
        if (turns[event.key]) {
            const [x, y] = turns[event.key];
            if (event.shiftKey) {
                camera.pan(24 * x, 24 * y, height);
            } else {
                camera.orbit(0.06 * x, 0.06 * y);
            }
            this.redraw();
        } else if (event.key === '+' || event.key === '=' || event.key === '-') {
            camera.zoom(event.key === '-' ? 1.12 : 1 / 1.12);
            this.redraw();
        } else if (looks[event.key]) {
            this.panels.lookFrom(looks[event.key]);
        } else if (event.key === 'f' || event.key === 'F') {
            this.panels.lookFrom(null);
        } else if (event.key === ' ') {
            this.toggle();
        } else if (event.key === ',' || event.key === '.') {
            this.player.step(event.key === ',' ? -1 : 1);
        } else if (event.key === 'Enter') {
            const { x, y } = this.crosshair();
            this.panels.picked(this.player.pickAt(x, y));
        } else {
            return;
        }
        event.preventDefault();
    }

    // Middle of the pane of the fragments, where Enter picks.
    crosshair() {
        const pane = this.player.panes()[1];
        const scale = this.player.canvas.width / this.player.canvas.clientWidth;
        return { x: (pane.x + pane.width / 2) / scale, y: (this.player.canvas.height - pane.y - pane.height / 2) / scale };
    }

    redraw() {
        this.player.glance();
        this.player.tell();
    }

    jump(time) {
        this.player.stop();
        this.player.moveTo(time);
    }

    toggle() {
        if (this.player.playing) {
            this.player.stop();
            announce(say('stopped', this.player.time.toFixed(2)));
        } else {
            this.player.play();
            announce(say('playing'));
        }
    }

    setLanguage(chinese) {
        speech.chinese = chinese;
        this.speak();
    }

    speak() {
        document.documentElement.lang = speech.chinese ? 'zh-CN' : 'en';
        const values = (element) => JSON.parse(element.dataset.values || '[]');
        for (const element of document.querySelectorAll('[data-word]')) {
            element.textContent = say(element.dataset.word, ...values(element));
        }
        for (const element of document.querySelectorAll('[data-alt]')) {
            element.alt = say(element.dataset.alt, ...values(element));
        }
        for (const element of document.querySelectorAll('[data-label]')) {
            element.setAttribute('aria-label', say(element.dataset.label));
            if (element.tagName === 'BUTTON') {
                element.title = say(element.dataset.label);
            }
        }
        document.getElementById('english').setAttribute('aria-pressed', String(!speech.chinese));
        document.getElementById('chinese').setAttribute('aria-pressed', String(speech.chinese));
        document.getElementById('scenario').textContent = this.facts.scenario;
        this.warn();
        this.panels.build();
        this.refresh();
    }

    warn() {
        const { health, outcome, cautions } = this.facts;
        const lines = [];
        if (!outcome.complete) {
            lines.push(say('notComplete', sayCount(outcome.frames), outcome.end.toFixed(2)));
        }
        if (health.tainted) {
            lines.push(say('tainted', health.limits.length));
        } else if (health.acknowledged) {
            lines.push(say('vouched', health.limits.length, health.acknowledged.by, health.acknowledged.note));
        }
        // What the page says at more length stands above.
        const said = (key) => ['tainted', 'not_complete'].includes(key) || (key === 'limits_passed' && health.acknowledged);
        lines.push(...cautions.filter((caution) => !said(caution.key)).map((caution) => saySentence(caution.what)));
        document.getElementById('warnings').replaceChildren(...lines.map((line) => make('p', { role: 'note' }, line)));
    }

    // Opens the views; without WebGL 2 the pictures stay.
    async open() {
        document.documentElement.classList.add('ran');
        const stage = document.getElementById('stage');
        const stills = document.getElementById('stills');
        try {
            const probe = document.createElement('canvas').getContext('webgl2');
            if (!probe || typeof DecompressionStream === 'undefined') {
                this.fallBack('noWebGl');
                return;
            }
            stage.hidden = false;
            stills.hidden = true;
            document.documentElement.classList.remove('opening');
            await new Promise((resolve) => setTimeout(resolve, 0));
            const canvas = document.getElementById('canvas');
            const started = startedPrograms(canvas);
            const data = document.getElementById('data');
            const packed = bytesOfBase64(data.textContent);
            data.remove();
            const bytes = await inflated(packed, this.facts.scene.dataBytes);
            const pictured = this.panels.pictures.find((picture) => picture.kind === 'ground');
            this.player = new Player(canvas, started, this.facts, bytes, pictured ? pictured.source : null);
        } catch (error) {
            this.fallBack('damaged', error.message);
            return;
        }
        this.panels.player = this.player;
        this.player.onChange(() => this.refresh());
        document.getElementById('loading').hidden = true;
        document.getElementById('timeline').inert = false;
        const slider = document.getElementById('time');
        slider.min = this.player.start;
        slider.max = this.player.end;
        this.markChapters();
        document.getElementById('canvas').addEventListener('webglcontextlost', () => {
            this.fallBack('lost');
        });
        this.player.resize();
        this.player.follow();
        this.panels.lookFrom('side');
        this.panels.build();
        new ResizeObserver(() => {
            if (this.player) {
                this.player.follow();
                this.redraw();
            }
        }).observe(document.getElementById('views'));
        document.documentElement.dataset.ready = String(Math.round(performance.now()));
        this.player.structure.unpackRest();
    }

    // Pictures in place of the views, and why; what works by the views alone goes with them.
    fallBack(word, ...values) {
        if (this.player) {
            this.player.close();
            this.player = null;
            this.panels.player = null;
        }
        document.documentElement.classList.remove('opening');
        document.getElementById('stage').hidden = true;
        document.getElementById('stills').hidden = false;
        document.getElementById('skip').hidden = true;
        document.getElementById('noStills').hidden = document.querySelector('#stills figure') !== null;
        const reason = document.getElementById('reason');
        reason.dataset.word = word;
        reason.dataset.values = JSON.stringify(values);
        this.speak();
        announce(reason.textContent);
        document.documentElement.dataset.ready = word;
    }

    markChapters() {
        const { start, end } = this.player;
        document.getElementById('marks').replaceChildren(...this.facts.chapters.filter((each) => !each.outside).map((chapter) => {
            const mark = make('i');
            mark.style.left = `${100 * (chapter.time - start) / (end - start)}%`;
            return mark;
        }));
    }

    refresh() {
        const { player } = this;
        if (!player) {
            return;
        }
        const clock = `${player.time.toFixed(2)} s / ${player.end.toFixed(2)} s`;
        const slider = document.getElementById('time');
        slider.value = player.time;
        slider.setAttribute('aria-valuetext', clock);
        document.getElementById('clock').textContent = clock;
        const { paceKept } = player;
        document.getElementById('lag').textContent = paceKept < 1 ? say('lag', sayNumber(player.pace * paceKept, 2)) : '';
        const play = document.getElementById('play');
        play.textContent = player.playing ? '❚❚' : '▶';
        play.setAttribute('aria-label', say(player.playing ? 'pause' : 'play'));
        this.caption();
        this.legend();
        this.panels.refresh();
    }

    caption() {
        const { player } = this;
        const table = this.facts.scene.looseBodies;
        const { structure } = player;
        const state = structure.stateAt(player.time);
        const between = structure.shareAt(player.time) > 0 && !(player.playing && player.slow) ? `, ${say('between')}` : '';
        const captions = [
            `${say(table ? 'bodiesPane' : 'fePane')} (${say(table ? 'given' : 'computed')}): ${say('atState', state + 1, structure.times.length)}${between}; ` +
                say('activeCount', sayCount(player.activeCount)),
            `${say('fragmentPane')} (${say('simulated')}${player.betweenFrames() ? `, ${say('between')}` : ''}): ` +
                say('pieceCount', sayCount(player.pieceCount))];
        const scale = player.canvas.clientWidth / player.canvas.width;
        const panes = player.panes();
        document.getElementById('views').classList.toggle('stacked', panes[0].x === panes[1].x);
        panes.forEach((pane, i) => {
            const box = document.getElementById(['feCaption', 'fragmentCaption'][i]);
            box.textContent = captions[i];
            box.style.left = `${pane.x * scale + 8}px`;
            box.style.top = `${(player.canvas.height - pane.y - pane.height) * scale + 8}px`;
            box.style.maxWidth = `${pane.width * scale - 16}px`;
        });
        const cross = this.crosshair();
        const ring = document.getElementById('crosshair');
        ring.style.left = `${cross.x}px`;
        ring.style.top = `${cross.y}px`;
        this.scaleBar(panes[0].height * scale);
    }

    // A round length at the distance of the middle.
    scaleBar(height) {
        const perPixel = this.player.camera.metresPerPixel(height);
        const length = roundBelow(110 * perPixel);
        const box = document.getElementById('scale');
        box.querySelector('span').style.width = `${length / perPixel}px`;
        box.querySelector('b').textContent = `${sayNumber(length)} m`;
        box.querySelector('em').textContent = this.looking();
    }

    // Where the views look, clockwise from north where that is known.
    looking() {
        const { yaw } = this.player.camera;
        const whole = (radians) => (Math.round(radians * 180 / Math.PI) % 360 + 360) % 360;
        const { north } = this.facts;
        if (north === null) {
            return say('lookingFrame', whole(yaw + Math.PI));
        }
        const heading = whole(Math.PI / 2 - (yaw + Math.PI) - north);
        return say('looking', say('winds').split(',')[Math.floor((heading + 22) / 45) % 8], heading);
    }

    legend() {
        const { player } = this;
        const key = `${player.colourBy} ${speech.chinese} ${player.fine}`;
        if (key === this.legendKey) {
            return;
        }
        this.legendKey = key;
        const entry = (colour, text) => make('span', {}, makeSign(colour), text);
        const entries = player.fine ? this.materialEntries(entry) : [entry(tones.structure, say('structure'))];
        const { components } = this.facts.scene;
        if (player.colourBy === 'highlight' && !player.fine) {
            entries.push(entry(tones.fragment, say('fragments')));
        } else if (player.colourBy === 'component') {
            // All of them stand beside the choice of the colours.
            const named = components.length > legendComponents ? legendComponents - 1 : components.length;
            components.slice(0, named).forEach((name, i) => entries.push(entry(categoryColour(i), name)));
            if (named < components.length) {
                entries.push(make('span', {}, say('moreComponents', components.length - named)));
            }
        } else if (player.colourBy === 'cluster') {
            const sign = make('i', { class: 'bar' });
            const share = 100 / categories.length;
            const bands = categories.map((colour, i) => `rgb(${colour.join(',')}) ${share * i}% ${share * (i + 1)}%`);
            sign.style.background = `linear-gradient(90deg, ${bands.join(', ')})`;
            entries.push(make('span', {}, sign, say('clusterColours', categories.length)));
        } else if (player.colourBy === 'birth' || player.colourBy === 'speed') {
            const sign = make('i', { class: 'bar' });
            sign.style.background = `linear-gradient(90deg, ${[0, 0.25, 0.5, 0.75, 1].map((s) => `rgb(${heat(s).join(',')})`).join(', ')})`;
            const ends = player.colourBy === 'birth' ? player.spanOfBirths().map((t) => `${t.toFixed(2)} s`)
                : ['0', `${sayNumber(player.fastest)} m/s`];
            entries.push(make('span', {}, `${ends[0]} `, sign, ends[1]));
        }
        // Loose structure has no birth and no cluster.
        if (['highlight', 'birth', 'cluster'].includes(player.colourBy) && player.pieces.loose() && !player.fine) {
            entries.push(entry(tones.released, say('released')));
        }
        document.getElementById('legend').replaceChildren(...entries);
    }

    // Each material that is there; a guess by density is said to be one.
    materialEntries(entry) {
        const { materials } = this.facts.scene;
        const names = words.materials[speech.chinese ? 1 : 0];
        return names.flatMap((name, kind) => {
            const own = materials.filter((material) => material.kind === kind);
            const guessed = own.filter((material) => material.assumed);
            const fits = own.length > guessed.length || guessed.some((material) => material.fits);
            const text = guessed.length === 0 ? name : say(fits ? 'assumed' : 'asMaterial', name);
            return own.length > 0 ? [entry(materialTones[kind], text)] : [];
        });
    }
}

const page = new Page();
page.open();
