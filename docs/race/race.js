// The race in a page (docs/race.md): the same scene stepped by this book's steps and, where it is installed, by Box2D, side
// by side, with the time of a step and the error of both. One function measures the error of both sides. Nothing is computed
// before it is started, while it is paused, and while it is out of sight.
'use strict';

(function (space) {
    const h = 1 / 60;
    const colours = {ours: 'blue', theirs: 'orange'};
    const wait = () => new Promise(done => setTimeout(done, 0));
    const microseconds = x => x < 10 ? x.toFixed(1) : x.toFixed(0);
    // A length as the table has it: two digits.
    const length = x => !isFinite(x) ? 'falls apart' : x === 0 ? '0' : x < 1e-3 || x >= 1e4 ? x.toExponential(1) : String(Number(x.toPrecision(2)));

    // Both sides on one scene. `machine`: our side as wasm, `box`: a RigidBox2d or null.
    class Race {
        constructor(machine, box) {
            Object.assign(this, {machine, box});
            this.scenes = machine.program.scenes;
        }
        open(scene, method, substeps, their_substeps) {
            this.machine.attempt('race_open', scene, method, substeps);
            this.scene = JSON.parse(this.machine.text(this.machine.api.race_scene()));
            this.what = this.scenes[scene];
            if (this.box) this.box.open(this.scene, their_substeps);
        }
        numbers(place) { return new Float64Array(this.machine.api.memory.buffer, place, 3 * this.scene.bodies.length); }
        ours() { return this.numbers(this.machine.api.race_ours()); }
        theirs() {
            const numbers = this.numbers(this.machine.api.race_theirs());
            this.box.positions(numbers);
            return numbers;
        }
        error(theirs) {
            if (theirs) this.theirs();
            return this.machine.api.race_error(theirs ? 1 : 0);
        }
        step_ours() { this.machine.attempt('race_step', 1); }
        step_theirs() { this.box.step(h); }
    }

    // What the table has of one scene: [program, method, sub-steps] for each line.
    function lines_of(scene, with_box) {
        const ours = [1, 4].map(substeps => ({who: 'book', method: scene.methods[0], substeps}));
        return with_box ? [...ours, ...[4, 16].map(substeps => ({who: 'Box2D', method: 'its own', substeps}))] : ours;
    }

    // The fixed run: time and largest error of each line of each scene. A run for the error, then some for the time alone.
    async function fixed_run(race, say) {
        const table = [];
        for (const [place, scene] of race.scenes.entries())
            for (const line of lines_of(scene, race.box)) {
                say(`${scene.title}: ${line.who}, ${line.method}`);
                await wait();
                const theirs = line.who === 'Box2D', method = Math.max(0, scene.methods.indexOf(line.method));
                const begin = () => race.open(place, method, theirs ? 1 : line.substeps, theirs ? line.substeps : 1);
                const step = () => theirs ? race.step_theirs() : race.step_ours();
                let error = 0, time = Infinity, sentence = '';
                try {
                    begin();
                    for (let k = 0; k < scene.steps; ++k) {
                        step();
                        error = Math.max(error, race.error(theirs));
                    }
                    // The least of several: other programs run beside this, and a run of some milliseconds is short.
                    for (let turn = 0, spent = 0; turn < 2 || (spent < 200 && turn < 20); ++turn) {
                        await wait(); // the page stays awake
                        begin();
                        const before = performance.now();
                        for (let k = 0; k < scene.steps; ++k) step();
                        const took = performance.now() - before;
                        spent += took;
                        time = Math.min(time, 1000 * took / scene.steps);
                    }
                } catch (fault) {
                    sentence = fault.message;
                    error = Infinity;
                }
                table.push({scene: scene.name, title: scene.title, what: scene.error, ...line, error, time, sentence});
            }
        return table;
    }
    space.rigid_race = {Race, fixed_run, length};
    if (typeof document === 'undefined') return;

    const folder = new URL('.', document.currentScript.src).href;
    function element(tag, attributes = {}, ...children) {
        const made = document.createElement(tag);
        for (const [name, value] of Object.entries(attributes)) {
            if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
            else made.setAttribute(name, value);
        }
        made.append(...children);
        return made;
    }
    const script = name => new Promise((done, fail) => {
        document.head.append(element('script', {src: folder + name, onload: done, onerror: () => fail(new Error(`${name} is missing.`))}));
    });

    class RacePage {
        constructor(place) {
            this.place = place;
            this.seen = true;
            place.querySelector('.demo-start').addEventListener('click', () => this.start());
        }

        async start() {
            if (this.started) return;
            this.started = true;
            try {
                const code = await rigid_module('race', folder + 'demos/');
                if ('peer' in this.place.dataset) await script('demos/box2d3_wasm.js');
                this.race = new Race(await RigidMachine.of(code), space.rigid_box2d ? await RigidBox2d.of(space.rigid_box2d) : null);
                this.build();
                this.choose(0);
                this.set_playing(true);
                this.place.dataset.state = 'runs';
            } catch (error) {
                this.place.dataset.state = 'failed';
                this.place.append(element('p', {class: 'demo-sentence', role: 'alert'}, error.message));
            }
        }

        build() {
            const {race} = this, select = (name, options, chosen) => element('select', {'aria-label': name, onchange: () => this.open()},
                ...options.map(one => { const made = element('option', {value: one}, String(one)); made.selected = one === chosen; return made; }));
            this.run = element('button', {type: 'button', class: 'demo-run', onclick: () => this.set_playing(!this.playing)});
            this.step_button = element('button', {type: 'button', onclick: () => { this.set_playing(false); this.step(); this.show(); }}, 'Step');
            this.scene_list = element('select', {'aria-label': 'Scene', onchange: () => this.choose(this.scene_list.selectedIndex)},
                                      ...race.scenes.map(one => element('option', {}, one.title)));
            this.substeps = select('Sub-steps of this book', [1, 2, 4, 8, 16], 1);
            this.their_substeps = select('Sub-steps of Box2D', [1, 2, 4, 8, 16], 4);
            this.method_place = element('span');
            this.status = element('span', {class: 'demo-status'});
            this.sentence = element('p', {class: 'demo-sentence', role: 'status', hidden: ''});
            const side = (name, title) => {
                const canvas = element('canvas', {role: 'img'}), value = element('span', {class: 'demo-values'});
                return {canvas, value, all: element('div', {class: 'race-side'},
                    element('div', {class: 'demo-title'}, element('b', {style: `color: var(--demo-${colours[name]})`}, title), value), canvas)};
            };
            this.sides = {ours: side('ours', 'this book')};
            if (race.box) this.sides.theirs = side('theirs', 'Box2D v3');
            const plot = title => {
                const canvas = element('canvas', {role: 'img', 'aria-label': 'Plot of the ' + title});
                return {canvas, title: element('span', {}, title), all: null};
            };
            this.plots = [plot('time of a step [µs]'), plot('error [m]')];
            for (const one of this.plots) one.all = element('div', {class: 'demo-plot'}, element('div', {class: 'demo-title'}, one.title), one.canvas);
            this.table_button = element('button', {type: 'button', onclick: () => this.make_table()}, 'Run the table');
            this.table_place = element('div', {class: 'race-table', 'aria-live': 'polite'});
            const labelled = (text, control) => element('label', {}, text, ' ', control);
            this.stage = element('div', {class: 'race-stage'}, ...Object.values(this.sides).map(one => one.all));
            this.place.replaceChildren(
                element('div', {class: 'demo-choices'}, labelled('Scene', this.scene_list), labelled('Method', this.method_place),
                        labelled('sub-steps', this.substeps), ...(race.box ? [labelled('sub-steps of Box2D', this.their_substeps)] : [])),
                this.stage, this.sentence,
                element('div', {class: 'demo-bar', role: 'group', 'aria-label': 'Run'}, this.run, this.step_button,
                        element('button', {type: 'button', onclick: () => this.open()}, 'Reset'), this.status),
                element('div', {class: 'demo-panel'}, ...this.plots.map(one => one.all)),
                element('div', {class: 'demo-bar'}, this.table_button), this.table_place);
            if (!race.box)
                this.place.append(element('p', {}, 'Box2D is not installed where this site was built, so the book runs alone: ./book setup peers, then ./book web and ./book docs.'));
            new IntersectionObserver(entries => { this.seen = entries[entries.length - 1].isIntersecting; this.go_on(); }).observe(this.stage);
            new ResizeObserver(() => this.show()).observe(this.stage);
            new MutationObserver(() => { this.inks = null; this.show(); }).observe(document.documentElement, {attributes: true, attributeFilter: ['class']});
        }

        choose(index) {
            const scene = this.race.scenes[index];
            this.methods = element('select', {'aria-label': 'Method of this book', onchange: () => this.open()},
                                   ...scene.methods.map(one => element('option', {}, one)));
            this.method_place.replaceChildren(this.methods);
            this.open();
        }

        open() {
            this.over = false;
            this.say('');
            this.steps = 0;
            this.history = {ours: [], theirs: []};
            this.cost = {};
            try {
                this.race.open(this.scene_list.selectedIndex, this.methods.selectedIndex, Number(this.substeps.value), Number(this.their_substeps.value));
            } catch (error) {
                this.over = true;
                this.say(error.message);
            }
            const names = {moved: 'farthest from its place [m]', overlap: 'deepest overlap [m]', gap: 'largest gap of a pin [m]'};
            this.plots[1].title.textContent = 'error: ' + names[this.race.what.error];
            for (const [name, side] of Object.entries(this.sides))
                side.canvas.setAttribute('aria-label', this.race.what.summary + (name === 'ours' ? ', stepped by this book' : ', stepped by Box2D'));
            this.show();
            this.go_on();
        }

        step() {
            if (this.over) return;
            try {
                for (const name of Object.keys(this.sides)) {
                    const before = performance.now();
                    name === 'ours' ? this.race.step_ours() : this.race.step_theirs();
                    const took = 1000 * (performance.now() - before);
                    // The clock of a page is coarse: a running mean of fifty steps.
                    this.cost[name] = this.cost[name] === undefined ? took : this.cost[name] + (took - this.cost[name]) / Math.min(50, this.steps + 1);
                    this.history[name].push([this.cost[name], this.race.error(name === 'theirs')]);
                }
                ++this.steps;
            } catch (error) {
                this.over = true;
                this.say(error.message);
            }
            this.place.dataset.steps = String(this.steps);
        }

        async make_table() {
            this.set_playing(false);
            this.table_button.disabled = true;
            try {
                const table = await fixed_run(this.race, text => { this.status.textContent = text; });
                this.place.dataset.table = JSON.stringify(table.map(line => ({...line, error: isFinite(line.error) ? line.error : null})));
                const cell = text => element('td', {}, text);
                this.table_place.replaceChildren(element('table', {class: 'markdownTable'},
                    element('tr', {}, ...['scene', 'who', 'method', 'sub-steps', 'error [m]', 'µs a step'].map(text => element('th', {}, text))),
                    ...table.map((line, i) => element('tr', {}, cell(i && table[i - 1].scene === line.scene ? '' : line.title), cell(line.who), cell(line.method),
                                                      cell(String(line.substeps)), cell(length(line.error)), cell(isFinite(line.time) ? microseconds(line.time) : '')))));
                for (const line of table) if (line.sentence) this.say(line.sentence);
            } finally {
                this.table_button.disabled = false;
                this.open();
            }
        }

        set_playing(on) {
            this.playing = on;
            this.run.textContent = on ? 'Pause' : 'Run';
            this.go_on();
        }
        go_on() {
            const wanted = this.playing && this.seen && !this.over;
            if (wanted && !this.frame_asked) {
                this.before = performance.now();
                this.debt = 0;
                this.frame_asked = requestAnimationFrame(now => this.frame(now));
            }
            if (!wanted && this.frame_asked) {
                cancelAnimationFrame(this.frame_asked);
                this.frame_asked = 0;
            }
        }
        frame(now) {
            this.frame_asked = 0;
            this.debt = Math.min(this.debt + (now - this.before) / 1000, 3 * h);
            this.before = now;
            for (; this.debt >= h; this.debt -= h) this.step();
            this.show();
            if (this.playing && this.seen && !this.over) this.frame_asked = requestAnimationFrame(later => this.frame(later));
        }

        say(text) {
            this.sentence.textContent = text;
            this.sentence.hidden = !text;
        }

        // ---- what it shows

        ink(name) {
            const style = getComputedStyle(this.place);
            this.inks = this.inks || {};
            return this.inks[name] = this.inks[name] || style.getPropertyValue('--demo-' + name).trim();
        }
        context(canvas, width, height) {
            const fine = Math.min(window.devicePixelRatio || 1, 3), [w, t] = [width, height].map(one => Math.round(one * fine));
            if (canvas.width !== w || canvas.height !== t) {
                canvas.width = w;
                canvas.height = t;
                canvas.style.width = width + 'px';
                canvas.style.height = height + 'px';
            }
            const g = canvas.getContext('2d');
            g.setTransform(fine, 0, 0, fine, 0, 0);
            g.clearRect(0, 0, width, height);
            return g;
        }

        show() {
            if (!this.race || !this.race.scene) return;
            for (const [name, side] of Object.entries(this.sides)) {
                this.draw(side.canvas, name === 'ours' ? this.race.ours() : this.race.theirs(), this.ink(colours[name]));
                const last = this.history[name].at(-1);
                side.value.textContent = last ? `${microseconds(last[0])} µs a step, error ${length(last[1])} m` : '';
            }
            this.plots.forEach((one, i) => this.plot(one.canvas, i));
            this.status.textContent = `step ${this.steps}`;
        }

        draw(canvas, x, ink) {
            const [cx, cy, half_width, half_height] = this.race.what.view;
            const width = canvas.parentNode.clientWidth, height = Math.round(Math.min(width * half_height / half_width, 0.6 * innerHeight));
            if (!width) return;
            const g = this.context(canvas, width, height), k = Math.min(width / 2 / half_width, height / 2 / half_height);
            g.fillStyle = this.ink('card');
            g.fillRect(0, 0, width, height);
            g.save();
            g.translate(width / 2 - k * cx, height / 2 + k * cy);
            g.scale(k, -k);
            g.lineWidth = 1.3 / k;
            g.lineJoin = g.lineCap = 'round';
            g.strokeStyle = this.ink('ink');
            for (const [nx, ny, offset] of this.race.scene.walls) {
                g.beginPath();
                g.moveTo(nx * offset - 100 * ny, ny * offset + 100 * nx);
                g.lineTo(nx * offset + 100 * ny, ny * offset - 100 * nx);
                g.stroke();
            }
            g.fillStyle = g.strokeStyle = ink;
            this.race.scene.bodies.forEach((body, i) => {
                if (!isFinite(x[3 * i] + x[3 * i + 1] + x[3 * i + 2])) return;
                g.save();
                g.translate(x[3 * i], x[3 * i + 1]);
                g.rotate(x[3 * i + 2]);
                g.beginPath();
                if (body.vertices.length === 1) {
                    g.arc(...body.vertices[0], body.radius, 0, 7);
                    g.lineTo(...body.vertices[0]);
                } else body.vertices.forEach(([px, py], j) => j ? g.lineTo(px, py) : g.moveTo(px, py));
                if (body.vertices.length > 2) g.closePath();
                g.lineWidth = Math.max(1.3 / k, 2 * (body.vertices.length > 1 ? body.radius : 0));
                g.globalAlpha = 0.3;
                g.fill();
                g.globalAlpha = body.vertices.length === 2 && body.radius * k > 1 ? 0.55 : 1;
                g.stroke();
                g.restore();
            });
            g.restore();
        }

        // Logarithmic in both plots: a decade more or less is what counts.
        plot(canvas, which) {
            const width = canvas.parentNode.clientWidth, height = 90, seconds = 5, most = seconds / h;
            if (!width) return;
            const g = this.context(canvas, width, height), curves = Object.keys(this.sides).map(name => [name, this.history[name].slice(-most).map(one => one[which])]);
            const all = curves.flatMap(([, values]) => values).filter(one => one > 0 && isFinite(one)).map(Math.log10);
            if (!all.length) return;
            const low = Math.floor(Math.min(...all)), high = Math.max(low + 1, Math.ceil(Math.max(...all)));
            const y = value => height - 6 - (height - 12) * (Math.log10(value) - low) / (high - low);
            g.font = '11px "DejaVu Sans", Helvetica, Arial, sans-serif';
            g.fillStyle = g.strokeStyle = this.ink('ink');
            const every = Math.max(1, Math.ceil((high - low) / 4));
            for (let decade = low; decade <= high; decade += every) {
                g.globalAlpha = 0.25;
                g.beginPath();
                g.moveTo(34, y(10 ** decade));
                g.lineTo(width, y(10 ** decade));
                g.stroke();
                g.globalAlpha = 0.9;
                g.fillText(decade < 4 && decade >= -3 ? String(Number((10 ** decade).toPrecision(1))) : '1e' + decade, 0, y(10 ** decade) + 4);
            }
            g.globalAlpha = 1;
            g.lineWidth = 1.6;
            for (const [name, values] of curves) {
                g.strokeStyle = this.ink(colours[name]);
                g.beginPath();
                values.forEach((value, i) => { if (value > 0 && isFinite(value)) g.lineTo(36 + (width - 38) * i / most, y(value)); });
                g.stroke();
            }
        }
    }

    function begin() {
        for (const place of document.querySelectorAll('.race')) place.race = new RacePage(place);
    }
    if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', begin);
    else begin();
})(globalThis);
