// A demo in a page: a still picture until it is started, then the chapter's program with its panel. Everything that the
// panel has comes from the program's own description (common/program/web_description.hpp). Nothing moves and nothing is
// computed before it is started, while it is paused, and while it is out of sight.
'use strict';

(function () {
    const folder = new URL('.', document.currentScript.src).href;
    const colour_names = ['ink', 'faint', 'blue', 'orange', 'green', 'red', 'purple', 'yellow', 'ground', 'card', 'rim'];
    const pane_colours = ['blue', 'orange', 'green', 'purple'];
    let count = 0;

    function element(tag, attributes = {}, ...children) {
        const made = document.createElement(tag);
        for (const [name, value] of Object.entries(attributes)) {
            if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
            else if (value === true) made.setAttribute(name, '');
            else if (value !== false) made.setAttribute(name, value);
        }
        made.append(...children);
        return made;
    }

    // "%.2f" and "%.4g" and "%.2e" of printf; a zero has no power of ten.
    function written(value, format) {
        const [, digits, kind] = format.match(/%\.(\d)([fge])/);
        if (kind === 'f') return value.toFixed(digits);
        if (kind === 'e') return value === 0 ? '0' : value.toExponential(digits).replace('e+', 'e');
        return String(Number(value.toPrecision(digits)));
    }

    // "a=1 b=2"
    function settings_of(text) {
        return Object.fromEntries((text || '').split(/\s+/).filter(Boolean).map(one => {
            const [name, value] = one.split('=');
            return [name, Number(value)];
        }));
    }
    const words_of = text => (text || '').split(/\s+/).filter(Boolean);

    class Demo {
        constructor(place) {
            this.place = place;
            this.number = ++count;
            this.playing = false; // as the reader wants it
            this.seen = true;     // is it on the screen?
            this.frame_asked = 0;
            this.whole_run = false;
            this.broken = null;
            this.steps_taken = 0;
            this.still = [...place.childNodes];
            place.querySelector('.demo-start').addEventListener('click', () => this.start(true));
            place.querySelector('.figure').addEventListener('click', () => this.start(true));
        }

        // The still picture again.
        close() {
            this.set_playing(false);
            for (const watch of this.watches) watch.disconnect();
            this.started = false;
            this.machine = null;
            delete this.place.dataset.state;
            this.place.replaceChildren(...this.still);
            this.place.querySelector('.demo-start').focus({preventScroll: true});
        }

        async start(by_hand) {
            if (this.started) return;
            this.started = true;
            const button = this.place.querySelector('.demo-start');
            button.classList.add('demo-loading');
            button.disabled = true;
            try {
                const before = performance.now();
                this.machine = await RigidMachine.of(await rigid_module(this.place.dataset.program, folder + 'demos/'));
                this.machine.choose({scene: this.place.dataset.scene, methods: words_of(this.place.dataset.methods),
                                     settings: settings_of(this.place.dataset.settings)}).attempt('web_open');
                this.machine.api.web_script(1); // a hand comes later, or never
                button.classList.remove('demo-loading');
                button.disabled = false;
                this.build();
                this.build_panel();
                this.fit();
                this.set_playing(true);
                this.refresh();
                this.place.dataset.firstFrame = String(Math.round(performance.now() - before));
                this.place.dataset.state = 'runs';
                if (by_hand) this.canvas.focus({preventScroll: true});
            } catch (error) {
                this.place.dataset.state = 'failed';
                this.place.append(element('p', {class: 'demo-sentence', role: 'alert'}, error.message));
            }
        }

        get scene() { return this.machine.program.scenes[this.state.scene]; }

        // ---- what is there for all scenes

        build() {
            this.state = this.machine.state();
            const program = this.machine.program;
            this.canvas = element('canvas', {tabindex: 0, role: 'img'});
            this.g = this.canvas.getContext('2d');
            this.stage = element('div', {class: 'demo-stage'}, this.canvas);
            this.run = element('button', {type: 'button', class: 'demo-run', onclick: () => this.set_playing(!this.playing)});
            const step = element('button', {type: 'button', title: 'One time step: S or the right arrow',
                                            onclick: () => this.step()}, 'Step');
            const reset = element('button', {type: 'button', title: 'Restart the scene: R', onclick: () => this.reset()}, 'Reset');
            this.speed = element('select', {'aria-label': 'Seconds of the scene per second', title: 'Seconds of the scene per second',
                                            onchange: () => this.machine.api.web_speed(Number(this.speed.value))},
                                 ...program.speeds.map(one => element('option', {value: one.value, selected: one.value === 1},
                                                                      one.text.replace('x ', '× '))));
            this.status = element('span', {class: 'demo-status'});
            this.bar = element('div', {class: 'demo-bar', role: 'group', 'aria-label': 'Run'}, this.run, step, reset, this.speed);
            const idea = this.place.dataset.break;
            if (idea) {
                const box = element('input', {type: 'checkbox', onchange: () => this.set_broken(box.checked)});
                this.bar.append(element('label', {class: 'demo-break', title: 'Turns the idea of the chapter off, to see what it is for'},
                                        box, 'Break it: ' + idea.split('|')[0]));
            }
            this.bar.append(this.status, element('button', {type: 'button', class: 'demo-close', title: 'The still picture again',
                                                             onclick: () => this.close()}, 'Close'));
            this.choices = element('div', {class: 'demo-choices'});
            this.sliders = element('div', {class: 'demo-sliders'});
            this.plots = element('div', {class: 'demo-plots'});
            this.sentence = element('p', {class: 'demo-sentence', role: 'status', hidden: true});
            this.keys = element('details', {class: 'demo-keys'});
            this.summary = element('p', {class: 'demo-summary'});
            // On a phone settings and plots are a tap away: the picture and its buttons stay on one screen.
            const roomy = this.place.clientWidth > 600;
            const part = (title, inside) => element('details', {class: 'demo-part', open: roomy, ontoggle: () => this.machine && this.refresh()},
                                                    element('summary', {}, title), inside);
            this.place.replaceChildren(this.summary, this.stage, this.sentence, this.bar, this.choices,
                                       element('div', {class: 'demo-panel'}, part('Settings', this.sliders), part('Plots', this.plots)), this.keys);
            this.hand();
            this.canvas.addEventListener('keydown', event => this.key(event));
            const resized = new ResizeObserver(() => { if (this.stage.clientWidth !== this.width) { this.fit(); this.refresh(); } });
            resized.observe(this.stage);
            const seen = new IntersectionObserver(entries => {
                this.seen = entries[entries.length - 1].isIntersecting;
                this.go_on();
            });
            seen.observe(this.stage);
            const themed = new MutationObserver(() => { this.colours = null; this.refresh(); });
            themed.observe(document.documentElement, {attributes: true, attributeFilter: ['class']});
            this.watches = [resized, seen, themed];
        }

        // ---- what each scene has of its own

        build_panel() {
            const scene = this.scene, program = this.machine.program;
            this.built = this.state.scene;
            this.summary.textContent = scene.summary + (/[.?!]$/.test(scene.summary) ? '' : '.');
            this.canvas.setAttribute('aria-label', scene.summary + '. Space runs and pauses, S takes one step, R restarts.');
            const scenes = element('select', {'aria-label': 'Scene', onchange: () => this.change('web_scene', scenes.selectedIndex)},
                                   ...program.scenes.map((one, i) => element('option', {selected: i === this.built, title: one.summary},
                                                                             one.name.replaceAll('_', ' '))));
            this.choices.replaceChildren(element('label', {class: 'demo-scene'}, 'Scene ', scenes));
            this.boxes = scene.methods.length < 2 ? [] : scene.methods.map((method, i) =>
                element('input', {type: 'checkbox', onchange: event => this.change('web_method', i, event.target.checked ? 1 : 0)}));
            if (this.boxes.length)
                this.choices.append(element('div', {class: 'demo-methods', role: 'group', 'aria-label': 'Methods side by side'},
                                            ...this.boxes.map((box, i) => element('label', {}, box, scene.methods[i].replaceAll('_', ' ')))));
            if (scene.steered) {
                this.path = element('input', {type: 'checkbox', onchange: () => this.machine.api.web_script(this.path.checked ? 1 : 0)});
                this.choices.append(element('label', {class: 'demo-path', title: 'Along a path that is the same each time, until the pointer comes'}, this.path, 'steers itself'));
            } else this.path = null;

            this.rows = scene.sliders.map((row, i) => row.names.length ? this.choice(row, i) : this.slider(row, i));
            this.sliders.replaceChildren(...this.rows.map(row => row.all));
            this.curves = scene.plots.map(plot => {
                const canvas = element('canvas', {role: 'img', 'aria-label': ['Plot of ' + plot.title, plot.help, plot.grey].filter(Boolean).join(', ')});
                const values = element('span', {class: 'demo-values'});
                return {plot, canvas, values, all: element('div', {class: 'demo-plot', title: plot.help},
                                                           element('div', {class: 'demo-title'}, element('span', {}, plot.title),
                                                                   element('span', {class: 'demo-grey'}, plot.grey), values), canvas)};
            });
            this.plots.replaceChildren(...this.curves.map(curve => curve.all));
            if (this.curves.length) {
                const box = element('input', {type: 'checkbox', onchange: () => { this.whole_run = box.checked; this.refresh(); }});
                box.checked = this.whole_run;
                this.plots.append(element('label', {class: 'demo-whole'}, box, 'whole run'));
            }
            this.keys.replaceChildren(element('summary', {}, 'Keys and pointer'),
                                      element('dl', {}, ...scene.keys.flatMap(([key, what]) => [element('dt', {}, key), element('dd', {}, what)])));
        }

        slider(row, i) {
            const id = `demo-${this.number}-${this.built}-${i}`;
            const fine = row.whole ? row.high - row.low : 200;
            const input = element('input', {type: 'range', id, title: row.help, min: row.logarithmic ? 0 : row.low,
                                            max: row.logarithmic ? fine : row.high,
                                            step: row.logarithmic || row.whole ? 1 : 'any'});
            const to_value = text => row.logarithmic ? Math.min(row.high, row.low * Math.pow(row.high / row.low, Number(text) / fine)) : Number(text);
            const to_place = value => row.logarithmic ? fine * Math.log(value / row.low) / Math.log(row.high / row.low) : value;
            const output = element('output', {for: id});
            const short = value => String(Number(value.toPrecision(3)));
            input.addEventListener('input', () => this.change('web_slide', i, to_value(input.value)));
            input.addEventListener('dblclick', () => this.change('web_slide', i, row.first));
            if (row.logarithmic || !row.whole) // "any" has no step of its own, and a whole number moves by one at least
                input.addEventListener('keydown', event => {
                    const way = {ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10}[event.key];
                    if (!way) return;
                    event.preventDefault();
                    const now = this.state.settings[i];
                    let value = row.logarithmic ? now * Math.pow(row.high / row.low, way / 100) : now + way * (row.high - row.low) / 100;
                    if (row.whole && Math.abs(value - now) < 1) value = now + Math.sign(way);
                    this.change('web_slide', i, Math.min(row.high, Math.max(row.low, value)));
                });
            const show = value => {
                if (document.activeElement !== input || Math.abs(to_value(input.value) - value) > 1e-9 * Math.abs(value)) input.value = to_place(value);
                const text = written(value, row.format) + (row.unit ? ' ' + row.unit : '');
                if (output.textContent !== text) {
                    output.textContent = text;
                    input.setAttribute('aria-valuetext', text);
                }
            };
            return {show, all: element('div', {class: 'demo-slider'}, element('label', {for: id, title: row.help}, row.label),
                                       output, element('div', {class: 'demo-range'}, element('span', {}, short(row.low)), input,
                                                       element('span', {}, short(row.high))))};
        }

        // A setting whose values have names: a box where they are no and yes, else a list.
        choice(row, i) {
            const id = `demo-${this.number}-${this.built}-${i}`, whether = row.names.join() === 'no,yes';
            const place = () => whether ? Number(control.checked) : control.selectedIndex;
            const attributes = {id, title: row.help, onchange: () => this.change('web_slide', i, row.low + place())};
            const control = whether ? element('input', {type: 'checkbox', ...attributes}) :
                element('select', attributes, ...row.names.map(name => element('option', {}, name)));
            const show = value => {
                if (whether) control.checked = value > 0;
                else control.selectedIndex = Math.round(value - row.low);
            };
            return {show, all: element('div', {class: 'demo-choice'}, element('label', {for: id, title: row.help}, row.label), control)};
        }

        // ---- what the reader does

        set_playing(on) {
            this.playing = on;
            this.machine.api.web_pause(on ? 0 : 1);
            this.run.textContent = on ? 'Pause' : 'Run';
            this.run.title = 'Space';
            this.canvas.style.touchAction = on ? 'none' : ''; // a finger that pulls does not scroll the page
            this.go_on();
            if (!on) this.refresh();
        }

        step() {
            this.set_playing(false);
            this.attempt(() => this.machine.attempt('web_step'));
        }

        reset() { this.change('web_restart'); }

        change(name, ...numbers) {
            this.attempt(() => this.machine.attempt(name, ...numbers));
            this.go_on();
        }

        attempt(what) {
            try {
                what();
            } catch (error) {
                this.say([error.message]);
            }
            this.refresh();
        }

        // The idea of the chapter off, and on again: other methods, other settings.
        set_broken(on) {
            const [, methods, settings] = this.place.dataset.break.split('|');
            const name_of = i => this.scene.methods[i];
            const set = (wanted_methods, wanted) => {
                const index = name => this.scene.methods.indexOf(name);
                for (const name of wanted_methods) this.machine.attempt('web_method', index(name), 1);
                if (wanted_methods.length)
                    this.scene.methods.forEach((name, i) => { if (!wanted_methods.includes(name)) this.machine.attempt('web_method', i, 0); });
                for (const [name, value] of Object.entries(wanted)) {
                    const place = this.scene.sliders.findIndex(row => row.name === name);
                    if (place >= 0) this.machine.attempt('web_slide', place, value);
                }
                this.machine.attempt('web_restart');
            };
            this.attempt(() => {
                const home = this.machine.program.scenes.findIndex(one => one.name === this.place.dataset.scene);
                if (home >= 0 && home !== this.state.scene) {
                    this.machine.attempt('web_scene', home);
                    this.state = this.machine.state();
                }
                if (on) {
                    const before = Object.fromEntries(this.scene.sliders.map((row, i) => [row.name, this.state.settings[i]]));
                    this.whole = {methods: this.state.on.flatMap((one, i) => one ? [name_of(i)] : []), settings: before};
                    set(words_of(methods), settings_of(settings));
                } else if (this.whole) set(this.whole.methods, this.whole.settings);
            });
            if (!this.playing) this.set_playing(true);
            else this.go_on();
        }

        key(event) {
            if (event.ctrlKey || event.metaKey || event.altKey) return;
            const what = {' ': () => this.set_playing(!this.playing), s: () => this.step(), S: () => this.step(), ArrowRight: () => this.step(),
                          r: () => this.reset(), R: () => this.reset(), ArrowUp: () => this.change('web_arrow', 1),
                          ArrowDown: () => this.change('web_arrow', -1)}[event.key];
            if (!what) return;
            event.preventDefault();
            what();
        }

        hand() {
            const point = (event, present, down) => {
                const box = this.canvas.getBoundingClientRect();
                this.machine.api.web_point(event.clientX - box.left, event.clientY - box.top, present ? 1 : 0, down ? 1 : 0);
                if (!this.frame_asked) this.paint();
            };
            this.canvas.addEventListener('pointerdown', event => {
                if (event.button !== 0) return;
                if (this.playing) this.canvas.setPointerCapture(event.pointerId);
                point(event, true, true);
            });
            this.canvas.addEventListener('pointermove', event => point(event, true, event.buttons & 1));
            for (const end of ['pointerup', 'pointercancel'])
                this.canvas.addEventListener(end, event => point(event, event.pointerType === 'mouse', false));
            this.canvas.addEventListener('pointerleave', event => point(event, false, false));
        }

        // ---- frames

        go_on() {
            const wanted = this.playing && this.seen && !this.machine.is_over();
            if (wanted && !this.frame_asked) {
                this.before = performance.now();
                this.frame_asked = requestAnimationFrame(now => this.frame(now));
            }
            if (!wanted && this.frame_asked) {
                cancelAnimationFrame(this.frame_asked);
                this.frame_asked = 0;
            }
        }

        frame(now) {
            this.frame_asked = 0;
            const seconds = Math.max(0, now - this.before) / 1000;
            this.before = now;
            try {
                this.machine.attempt('web_advance', seconds);
            } catch (error) {
                this.playing = false;
                this.say([error.message]);
            }
            // The panel is read by eyes: ten times a second are enough.
            if (!(now - this.shown < 100)) {
                this.shown = now;
                this.refresh();
            } else this.paint();
            if (this.playing && this.seen && !this.machine.is_over())
                this.frame_asked = requestAnimationFrame(later => this.frame(later));
            else this.refresh();
        }

        fit() {
            this.width = this.stage.clientWidth;
            this.needs_fit = true;
        }

        sized(canvas, width, height) {
            const fine = Math.min(window.devicePixelRatio || 1, 3);
            if (canvas.width !== Math.round(width * fine) || canvas.height !== Math.round(height * fine)) {
                canvas.width = Math.round(width * fine);
                canvas.height = Math.round(height * fine);
                canvas.style.width = width + 'px';
                canvas.style.height = height + 'px';
            }
            const g = canvas.getContext('2d');
            g.setTransform(fine, 0, 0, fine, 0, 0);
            g.clearRect(0, 0, width, height);
            return g;
        }

        paint() {
            if (!this.colours) {
                const style = getComputedStyle(this.place);
                this.colours = colour_names.map(name => style.getPropertyValue('--demo-' + name).trim());
            }
            const most = Math.max(240, Math.min(560, 0.66 * window.innerHeight));
            const height = Math.round(this.machine.api.web_height(this.width, most));
            const g = this.sized(this.canvas, this.width, height);
            rigid_paint(g, this.machine.list('web_picture', this.width, height), this.colours);
        }

        // Everything: the picture, and the panel as the program has it.
        refresh() {
            this.state = this.machine.state();
            if (this.state.scene !== this.built) this.build_panel();
            this.paint();
            let pane = 0;
            this.boxes.forEach((box, i) => {
                box.checked = this.state.on[i];
                box.style.setProperty('--pane', this.state.on[i] ? `var(--demo-${pane_colours[pane++ % 4]})` : '');
            });
            if (this.path) this.path.checked = this.state.scripted;
            this.rows.forEach((row, i) => row.show(this.state.settings[i]));
            this.curves.forEach((curve, i) => {
                const width = curve.all.clientWidth;
                if (!width) return;
                rigid_paint(this.sized(curve.canvas, width, 62), this.machine.list('web_plot', curve.plot.column, width, 62, this.whole_run ? 1 : 0), this.colours);
                const values = this.state.values[i] || [];
                curve.values.replaceChildren(...values.map((value, k) => element('b', {style: `color: var(--demo-${pane_colours[k % 4]})`}, value)));
            });
            this.status.textContent = `step ${this.state.step}` + (this.state.slow ? ', slower than asked' : '');
            this.place.dataset.steps = this.state.step;
            this.say(this.state.sentences);
        }

        say(sentences) {
            const text = sentences.join(' · ');
            if (this.sentence.textContent !== text) this.sentence.textContent = text;
            this.sentence.hidden = !text;
        }
    }

    function begin() {
        const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
        for (const place of document.querySelectorAll('.demo')) {
            const demo = place.demo = new Demo(place);
            if (!('opens' in place.dataset) || still) continue;
            const watch = new IntersectionObserver(entries => {
                if (!entries.some(entry => entry.isIntersecting)) return;
                watch.disconnect();
                demo.start(false);
            });
            watch.observe(place);
        }
    }
    if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', begin);
    else begin();
})();
