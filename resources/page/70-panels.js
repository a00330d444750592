// Builds an element: attributes beginning with "on" are listeners, children are elements or texts.
function make(tag, attributes = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (name.startsWith('on')) {
            element.addEventListener(name.slice(2), value);
        } else if (value === true) {
            element.setAttribute(name, '');
        } else if (value !== false && value !== null) {
            element.setAttribute(name, value);
        }
    }
    element.append(...children.flat().filter((child) => child !== null));
    return element;
}

function makeSign(colour) {
    const sign = make('i', { class: 'sign' });
    sign.style.background = `rgb(${colour.join(',')})`;
    return sign;
}

function makeTable(heads, rows, caption) {
    const head = heads ? make('thead', {}, make('tr', {}, heads.map((text) => make('th', { scope: 'col' }, text)))) : null;
    const body = make('tbody', {}, rows.map((row) => make('tr', {}, row.map((cell, i) => {
        const number = typeof cell === 'string' && /^[-–<\d., ]+( \S{1,4})?$/.test(cell) ? { class: 'number' } : {};
        return i === 0 ? make('th', { scope: 'row', ...number }, cell) : make('td', number, cell);
    }))));
    return make('table', {}, caption ? make('caption', {}, caption) : null, head, body);
}

const panelNames = ['story', 'pick', 'look', 'evidence', 'health', 'about'];
const panelsOfViews = ['pick', 'look'];

// Tabs beside the views; each is built anew in the language of now.
class Panels {
    constructor(facts, pictures) {
        this.facts = facts;
        this.pictures = pictures;
        this.player = null;
        this.open = 'story';
        this.measuring = false;
    }

    // Of those there are; two are of no use without the views.
    get names() {
        return this.player ? panelNames : panelNames.filter((name) => !panelsOfViews.includes(name));
    }

    build() {
        const tabs = document.getElementById('tabs');
        const panels = document.getElementById('panels');
        tabs.replaceChildren();
        panels.replaceChildren();
        for (const name of this.names) {
            tabs.append(make('button', {
                type: 'button', role: 'tab', id: `tab-${name}`, 'aria-controls': `panel-${name}`, onclick: () => this.show(name),
                onkeydown: (event) => this.walk(event, name)
            }, say(name)));
            panels.append(make('div', { role: 'tabpanel', id: `panel-${name}`, 'aria-labelledby': `tab-${name}`, tabindex: '0' },
                this[name]()));
        }
        this.show(this.names.includes(this.open) ? this.open : 'story');
        if (this.player) {
            this.tellMeasured();
        }
        this.refresh();
    }

    show(name) {
        this.open = name;
        for (const each of this.names) {
            const tab = document.getElementById(`tab-${each}`);
            tab.setAttribute('aria-selected', each === name ? 'true' : 'false');
            tab.tabIndex = each === name ? 0 : -1;
            document.getElementById(`panel-${each}`).hidden = each !== name;
        }
    }

    walk(event, name) {
        const way = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (way) {
            const { names } = this;
            const next = names[(names.indexOf(name) + way + names.length) % names.length];
            this.show(next);
            document.getElementById(`tab-${next}`).focus();
            event.preventDefault();
        }
    }

    story() {
        const { outcome, chapters } = this.facts;
        const items = chapters.map((chapter) => make('li', {}, this.chapter(chapter)));
        const rows = [[say('fragments'), sayCount(outcome.fragments)],
            [say('theirMass'), `${sayNumber(outcome.fragmentMass / 1000, 4)} t`], [say('bodies'), sayCount(outcome.bodies)],
            [say('endsAt'), `${outcome.end.toFixed(2)} s`]];
        if (this.facts.map && this.facts.map.liveElements > 0) {
            rows.push([say('liveFell', this.facts.map.liveThreshold), `${sayNumber(this.facts.map.liveMass / 1000, 4)} t`]);
        }
        if (outcome.atRest !== undefined) {
            rows.push([say('islands'), sayCount(outcome.islands)], [say('atRest'), `${sayNumber(100 * outcome.atRest)} %`],
                [say('stillMoving'), sayCount(outcome.stillMoving)], [say('fastest'), `${sayNumber(outcome.maxSpeed)} m/s`]);
        }
        return [make('h2', {}, say('chapters')), make('ol', { class: 'chapters' }, items), make('h3', {}, say('outcome')),
            makeTable(null, rows)];
    }

    // A chapter leads to its time in the views, or to the picture nearest to it; one of another time than the run's leads nowhere.
    chapter({ time, kind, note, outside }) {
        const words = [make('b', {}, `${time.toFixed(2)} s`), make('span', {}, kind === 'note' ? note : say(kind))];
        if (outside) {
            return make('p', { class: 'outside' }, words, make('em', {}, say('outside')));
        }
        if (!this.player && this.pictureAt(time) === null) {
            return make('p', { class: 'outside' }, words);
        }
        return make('button', { type: 'button', 'data-time': time, onclick: () => this.jump(time) }, words);
    }

    jump(time) {
        if (this.player) {
            this.player.stop();
            this.player.moveTo(time);
            return;
        }
        const picture = this.pictureAt(time);
        picture.scrollIntoView();
        picture.focus({ preventScroll: true });
    }

    // The picture of the views whose time is nearest; null: there are none.
    pictureAt(time) {
        const apart = (figure) => Math.abs(Number(figure.dataset.time) - time);
        return [...document.querySelectorAll('#stills figure')].reduce(
            (best, each) => (best === null || apart(each) < apart(best) ? each : best), null);
    }

    pick() {
        const find = make('input', { type: 'text', id: 'number', inputmode: 'numeric', autocomplete: 'off' });
        const go = (event) => {
            event.preventDefault();
            this.find(find.value.trim());
        };
        return [make('h2', {}, say('pick')), make('p', {}, say('pickHelp')),
            make('form', { class: 'row', onsubmit: go },
                make('label', { for: 'number' }, say('elementNumber')), find, make('button', { type: 'submit' }, say('find')),
                make('button', { type: 'button', onclick: () => this.clear() }, say('clear'))),
            make('div', { id: 'chosen' }),
            make('h3', {}, say('measure')),
            make('div', { class: 'row' }, make('button', {
                type: 'button', id: 'measure', 'aria-pressed': String(this.measuring), onclick: () => this.toggleMeasure()
            }, say('measure')), make('span', {}, say('measureHelp'))),
            make('p', { id: 'measured', 'aria-live': 'polite' })];
    }

    look() {
        const choices = [['highlight', this.player.fine ? 'byMaterial' : 'highlight'], ['component', 'byComponent'], ['birth', 'byBirth'], ['speed', 'bySpeed'],
            ['cluster', 'byCluster']];
        const views = [['side', 'lookSide'], ['end', 'lookEnd'], ['top', 'lookTop'], ['corner', 'lookCorner']];
        const checked = this.player.colourBy;
        const colour = (by) => {
            this.player.setColours(by);
            document.querySelector('.components').hidden = by !== 'component';
        };
        const structure = (event) => this.player.showStructure(event.target.checked);
        const button = (from, word) => make('button', { type: 'button', onclick: () => this.lookFrom(from) }, say(word));
        return [make('h2', {}, say('look')), this.styles(),
            make('fieldset', {}, make('legend', {}, say('colours')), choices.map(([by, word]) => make('label', {},
                make('input', { type: 'radio', name: 'colours', value: by, checked: by === checked, onchange: () => colour(by) }),
                ` ${say(word)}`))),
            make('ul', { class: 'components', hidden: checked !== 'component' },
                this.facts.scene.components.map((name, i) => make('li', {}, makeSign(categoryColour(i)), name))),
            make('label', {}, make('input', {
                type: 'checkbox', checked: this.player.showsStructure, onchange: structure
            }), ` ${say('showStructure')}`),
            make('label', {}, make('input', {
                type: 'checkbox', id: 'edges', checked: this.player.edges, disabled: !this.player.fine,
                onchange: (event) => this.player.setEdges(event.target.checked)
            }), ` ${say('edges')}`),
            make('h3', {}, say('view')),
            make('div', { class: 'row' }, views.map(([from, word]) => button(from, word)), button(null, 'everything')),
            make('h3', {}, say('shortcuts')), make('p', {}, say('viewsHelp'))];
    }

    // The choice of the style, and what of it cannot be had.
    styles() {
        const { player } = this;
        const choose = (style) => {
            player.setStyle(style);
            this.build();
            document.querySelector(`input[name="style"][value="${style}"]`).focus();
        };
        const lacks = [];
        if (!player.fine && player.style === 'presentation') {
            lacks.push(say('contrastStyle'));
        }
        if (!player.renderer.shadows.every((shadow) => shadow.works)) {
            lacks.push(say('noShadows'));
        }
        return make('fieldset', {}, make('legend', {}, say('style')), ['presentation', 'analysis'].map((style) => make('label', {},
            make('input', {
                type: 'radio', name: 'style', value: style, checked: style === player.style, onchange: () => choose(style)
            }), ` ${say(style)}`)), lacks.map((line) => make('p', {}, line)));
    }

    lookFrom(from) {
        const pane = this.player.panes()[0];
        if (from) {
            this.player.camera.look(from, pane.width / pane.height);
        } else {
            this.player.camera.fit(pane.width / pane.height);
        }
        this.player.draw();
        this.player.tell();
    }

    evidence() {
        const { map } = this.facts;
        const parts = [];
        const drawn = this.pictures.find((picture) => picture.kind === 'map');
        if (map || drawn) {
            parts.push(make('h2', {}, say('map')));
        }
        if (map) {
            parts.push(make('p', {}, say('mapLine', sayCount(map.fragments), sayNumber(map.mass / 1000, 4), sayNumber(map.area, 4),
                sayNumber(map.cell), sayCount(map.liveElements), sayNumber(map.liveMass / 1000, 4), sayNumber(map.liveThreshold))));
        }
        if (drawn) {
            parts.push(make('figure', {}, make('img', { src: drawn.source, alt: say('mapAlt') })));
        }
        parts.push(make('h2', {}, say('photographs')));
        const photographs = this.pictures.filter((picture) => picture.kind === 'photograph');
        const { photographs: ofCase } = this.facts;
        if (ofCase === null) {
            parts.push(make('p', {}, say('noCase')));
        } else if (ofCase === 0) {
            parts.push(make('p', {}, say('noPhotographs')));
        } else if (ofCase > photographs.length) {
            parts.push(make('p', {}, say('unmatched', ofCase - photographs.length, ofCase)));
        }
        for (const photo of photographs) {
            parts.push(make('figure', {}, make('img', { src: photo.source, alt: say('photoAlt', photo.name) }),
                make('figcaption', {}, `${photo.name}. ${sayText(photo.note)}`,
                    (photo.cautions || []).map((caution) => make('p', { class: 'caution' }, saySentence(caution))))));
        }
        return parts;
    }

    health() {
        const { health, outcome, findings } = this.facts;
        const parts = [make('h2', {}, say('health'))];
        if (health.limits.length === 0) {
            parts.push(make('p', { class: 'good' }, say('healthy')));
        } else {
            const told = (limit) => make('div', {}, make('b', {}, sayText(limit.check)), make('p', {}, sayText(limit.what)),
                make('p', {}, sayText(limit.why)));
            const span = ([from, to]) => (to > from ? `${from.toFixed(2)}–${to.toFixed(2)}` : from.toFixed(2));
            parts.push(makeTable([say('when'), say('grade'), say('what')],
                health.limits.map((limit) => [limit.times.map(span).join(', '), sayText(limit.gradeWord), told(limit)]),
                say('passed')));
        }
        const share = (number) => {
            if (number === null || number === undefined) {
                return '–';
            }
            return number !== 0 && Math.abs(number) < 1e-8 ? '< 0.000001 %' : `${sayNumber(100 * number)} %`;
        };
        if (outcome.massError !== undefined) {
            parts.push(make('h3', {}, say('watched')), makeTable(null, [[say('energyGain'), share(health.energyGain)],
                [say('penetration'), `${sayNumber(health.penetration)} m`], [say('ofSide'), share(health.penetrationShare)],
                [say('speedShare'), share(health.fastest)], [say('farthest'), `${sayNumber(health.farthest)} m`]]),
            make('h3', {}, say('ledger')),
            makeTable(null, [[say('massError'), share(outcome.massError)], [say('momentumError'), share(outcome.momentumError)]]));
        }
        parts.push(make('h3', {}, say('validation')), ...this.validation());
        parts.push(make('h3', {}, say('findings')));
        if (findings.length === 0) {
            parts.push(make('p', {}, say('noFindings')));
        } else {
            parts.push(make('ul', {}, findings.map((finding) => make('li', {},
                make('p', {}, `${sayText(finding.what)} (${sayCount(finding.count)})`),
                finding.remedy ? make('p', {}, `${say('remedy')}: ${sayText(finding.remedy)}`) : null))));
        }
        return parts;
    }

    // How the build that simulated fares against measured falls.
    validation() {
        const { validation } = this.facts;
        if (validation === null) {
            return [make('p', {}, say('notValidated'))];
        }
        const error = ({ error: value, low, high }) => sayNumber(value) +
            (low === null || high === null ? '' : ` (${say('range', sayNumber(low), sayNumber(high))})`);
        const tables = validation.map((each) => {
            const rows = each.quantities.map((quantity) => [sayText(quantity.name) + (quantity.unit ? ` [${sayText(quantity.unit)}]` : ''),
                sayNumber(quantity.measured), sayNumber(quantity.simulated), error(quantity)]);
            const asked = each.asked > 0 ? say('asked', each.holds, each.asked) : '';
            const falls = each.falls > 0 ? say('falls', sayCount(each.falls), sayCount(each.lost)) : '';
            const words = say('setVariant', sayText(each.set), sayText(each.variant)) + falls + asked;
            return rows.length > 0 ? makeTable([say('figure'), say('measuredMean'), say('simulatedMean'), say('comparisonError')], rows,
                words) : make('p', {}, words);
        });
        return [make('p', {}, say('validated')), ...tables];
    }

    limitLines() {
        const { precision, ground } = this.facts;
        const up = (metres) => sayNumber(Math.ceil(metres * 10000) / 10);
        const { statesKept, statesThere } = precision;
        const lines = [say('limitPlaces', up(precision.place))];
        if (statesThere > statesKept) {
            lines.push(say('limitNodesKept', up(precision.node), statesKept, statesThere, up(precision.nodeBetween)),
                say('limitStates', statesThere - statesKept, statesThere));
        } else {
            lines.push(say('limitNodes', up(precision.node)));
        }
        if (ground.terrain && ground.terrain.cell > ground.terrain.ownCell) {
            lines.push(say('limitTerrain', sayNumber(ground.terrain.cell), sayNumber(ground.terrain.ownCell)));
        }
        const { names, fallenOn, large } = this.facts.around;
        if (names.length > 0) {
            lines.push(say('limitAround', names.join(', ')) + (large ? say('limitAroundLarge') : '') +
                (fallenOn ? say('limitFallenOn') : ''));
        }
        if (precision.siteTriangles > 0) {
            lines.push(say('limitSite', up(precision.site), sayCount(precision.siteTriangles)));
        }
        if (ground.picture !== null && ground.picture.pixel > ground.picture.ownPixel) {
            lines.push(say('limitPhoto', sayNumber(ground.picture.pixel), sayNumber(ground.picture.ownPixel)));
        }
        return [...lines, say('limitPoints'), say('limitLook'), say('limitSize'), say('limitLoad'), say('limitChaos'), say('limitCluster')];
    }

    about() {
        const { provenance, program } = this.facts;
        const digest = (text) => make('span', { class: 'digest' }, text);
        const roles = words.roles[speech.chinese ? 1 : 0];
        const rows = [[say('program'), program], [say('made'), provenance.made], [say('runBuild'), provenance.runBuild],
            [say('pageBuild'), provenance.pageBuild], [say('fingerprint'), digest(provenance.fingerprint)]];
        if (provenance.trajectory) {
            rows.push([say('trajectory'), digest(provenance.trajectory)]);
        }
        rows.push([say('coordinates'), sayText(provenance.coordinates)]);
        const key = (row) => make('div', {}, sayText(row.label), make('div', { class: 'digest' }, row.key));
        const settings = provenance.settings.map((row) => [key(row), sayText(row.delivered),
            `${sayText(row.run)} ${sayText(row.unit)}`.trim()]);
        const text = document.getElementById('provenance').textContent;
        return [make('h2', {}, say('limits')), make('ul', {}, this.limitLines().map((line) => make('li', {}, line))),
            make('h2', {}, say('provenance')), makeTable(null, rows),
            makeTable([say('role'), say('name'), 'SHA-256'],
                provenance.files.map((file) => [roles[file.role] || file.role, file.name, digest(file.sha256)]), say('files')),
            settings.length > 0 ? makeTable([say('setting'), say('delivered'), say('inRun')], settings, say('settings'))
                : make('p', {}, say('noSettings')),
            make('details', {}, make('summary', {}, say('download')), make('pre', { class: 'digest', tabindex: '0' }, text))];
    }

    // How far the two marks are apart; nothing where there are not two.
    tellMeasured() {
        const { marks } = this.player;
        let text = '';
        if (marks.length === 2) {
            const [dx, dy, dz] = add3(marks[1], marks[0], -1);
            const lengths = [Math.hypot(dx, dy, dz), Math.hypot(dx, dy), dz].map((x) => sayFixed(Math.abs(x) < 0.005 ? 0 : x, 2));
            text = say('measured', ...lengths);
        }
        document.getElementById('measured').textContent = text;
    }

    toggleMeasure() {
        this.measuring = !this.measuring;
        this.player.marks = [];
        document.getElementById('measure').setAttribute('aria-pressed', String(this.measuring));
        this.tellMeasured();
        document.getElementById('views').classList.toggle('picking', this.measuring);
        this.player.draw();
    }

    // What was picked: a point of a measure, or something to be told about.
    picked(hit) {
        if (this.measuring) {
            if (!hit || !hit.point) {
                announce(say('nothingThere'));
                return;
            }
            this.player.marks = [...(this.player.marks.length === 2 ? [] : this.player.marks), hit.point];
            this.tellMeasured();
            this.player.draw();
            return;
        }
        if (!hit || hit.element < 0) {
            this.clear();
            announce(say('nothingThere'));
            return;
        }
        this.player.choose(hit.element);
        this.show('pick');
        announce(this.summary());
    }

    clear() {
        this.player.marks = [];
        this.tellMeasured();
        this.player.choose(-1);
    }

    find(text) {
        const element = text === '' ? -1 : this.player.structure.ids.indexOf(Number(text));
        if (element < 0) {
            announce(say('noElement', text));
            document.getElementById('chosen').textContent = say('noElement', text);
            return;
        }
        this.player.choose(element);
        announce(this.summary());
    }

    summary() {
        const { structure, chosen } = this.player;
        return `${say('element')} ${structure.ids[chosen]}, ${this.facts.scene.components[structure.components[chosen]]}`;
    }

    // Rows about the element that is chosen.
    chosenRows() {
        const { player } = this;
        const { structure, pieces, motion, chosen, time } = player;
        const own = pieces.of(chosen);
        const withFragment = own.find((p) => pieces.fragments[p] >= 0);
        const f = withFragment === undefined ? -1 : pieces.fragments[withFragment];
        const now = pieces.at(chosen, time);
        const standing = structure.active(structure.stateAt(time), chosen);
        let shows = standing ? say('asStructure') : say('asGone');
        if (now >= 0) {
            shows = pieces.fragments[now] >= 0 ? say('asFragment') : say('asIsland');
        }
        const point = (p) => (p ? `${p.map((x) => x.toFixed(3)).join(', ')} m` : '–');
        const [rest, here, last] = [player.start, time, player.end].map((when) => player.middleAt(chosen, when));
        motion.moveTo(time);
        let length = 0;
        (player.pathPoints || []).forEach((p, i, all) => {
            length += i > 0 ? length3(add3(p, all[i - 1], -1)) : 0;
        });
        const rows = [[say('element'), String(structure.ids[chosen])],
            [say('component'), this.facts.scene.components[structure.components[chosen]]], [say('shows'), shows],
            [say('death'), f >= 0 ? `${sayNumber(pieces.births[f], 5)} s` : say('never')]];
        if (f >= 0) {
            rows.push([say('mass'), `${sayNumber(pieces.masses[f], 4)} kg`],
                [say('cluster'), pieces.clusters[f] >= 0 ? String(pieces.clusters[f]) : '–']);
        }
        rows.push([say('place'), point(here)]);
        if (rest && here) {
            rows.push([say('movedBy'), `${sayNumber(length3(add3(here, rest, -1)), 4)} m`]);
        }
        if (now >= 0) {
            const leg = motion.leg(pieces.bodies[now], time);
            rows.push([leg < 0 ? say('speed') : say('meanSpeed', sayNumber(motion.span(leg))),
                `${sayNumber(motion.speed(pieces.bodies[now], time))} m/s`]);
        }
        rows.push([say('lies'), point(last)], [say('pathLength'), `${sayNumber(length, 4)} m`]);
        return { rows, birth: f >= 0 ? pieces.births[f] : null };
    }

    // What changes with the time and the choice.
    refresh() {
        const { player } = this;
        const box = document.getElementById('chosen');
        if (!player || !box) {
            return;
        }
        for (const button of document.querySelectorAll('.chapters button')) {
            button.setAttribute('aria-current', String(Math.abs(Number(button.dataset.time) - player.time) < 1e-6));
        }
        if (player.chosen < 0) {
            box.replaceChildren();
            return;
        }
        if (player.playing && this.open !== 'pick') {
            return;
        }
        const { rows, birth } = this.chosenRows();
        box.replaceChildren(makeTable(null, rows),
            birth === null ? '' : make('button', { type: 'button', onclick: () => this.jump(birth) }, say('goBirth')));
    }
}

function announce(text) {
    document.getElementById('said').textContent = text;
}
