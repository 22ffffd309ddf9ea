// Sentences whose numbers can be dragged (docs/tools/sentences.py says how a text has one). A chapter's sentence.js gives
// the models:
//
//     rigid_sentence('spring', {
//         values({h}) { … return {energy}; },           // what follows from the numbers
//         picture({h}) { … return {view, marks}; }      // the small figure: a box of the plane, and what is in it
//     });
//
// Marks: path: [[x, y], …] (close, fill, dash), arrow: [from, to], circle: [x, y, radius] (fill), dot: [x, y],
// words: '…' with at: [x, y]; each with its colour, one of those of book.css. Node reads this file too, for the tests.
'use strict';

(function () {
    const models = {};
    globalThis.rigid_sentence = (name, model) => { models[name] = model; };

    // A number as a text has it: 'how' is '3' for three digits, '.2' for two decimals, nothing for a word.
    function written(value, how) {
        if (typeof value === 'string') return value;
        let words;
        if (how.startsWith('.')) words = Math.abs(value) < 1e9 ? value.toFixed(Number(how.slice(1))) : value.toExponential(1);
        else if (value !== 0 && (Math.abs(value) >= 1e6 || Math.abs(value) < 1e-4)) words = value.toExponential(Number(how) - 1);
        else words = value.toPrecision(Number(how)).includes('e') ? String(Number(value.toPrecision(Number(how)))) : value.toPrecision(Number(how));
        if (!Number.isFinite(value)) return '∞';
        if (Number(words) === 0) words = words.replace('-', '');
        const [digits, power] = words.split('e');
        const [whole, part] = digits.split('.');
        const grouped = whole.replace(/(\d)(?=(\d{3})+$)/g, (all, digit) => whole.replace('-', '').length > 4 ? digit + ',' : digit);
        const raised = power && [...power.replace('+', '')].map(one => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(one)]).join('');
        return (grouped + (part ? '.' + part : '')).replace('-', '−') + (power ? ' · 10' + raised : '');
    }
    const decimals = by => (String(by).split('.')[1] || '').length;

    globalThis.rigid_sentences = {models, written, decimals};
    if (typeof document === 'undefined') return;

    // ---- the small figure

    const width = 400, height = 250;
    const svg = 'http://www.w3.org/2000/svg';

    function drawn(tag, attributes, words) {
        const made = document.createElementNS(svg, tag);
        for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
        if (words) made.textContent = words;
        return made;
    }

    function paint(place, {view: [left, low, right, high], equal, marks}) {
        let sx = width / (right - left), sy = height / (high - low);
        if (equal) sx = sy = Math.min(sx, sy);
        const ox = width / 2 - sx * (left + right) / 2, oy = height / 2 + sy * (low + high) / 2;
        // What has exploded ends far outside of the figure, not nowhere.
        const far = v => Math.max(-1e4, Math.min(1e4, v));
        const point = ([x, y]) => [far(ox + sx * x).toFixed(2), far(oy - sy * y).toFixed(2)];
        place.replaceChildren(...marks.map(mark => {
            const colour = `var(--demo-${mark.colour || 'ink'})`;
            const line = `stroke: ${colour}; fill: ${mark.fill ? colour : 'none'}; fill-opacity: ${mark.fill || 0}`;
            const common = {style: line, 'stroke-width': mark.width || 2, ...(mark.dash ? {'stroke-dasharray': '5 4'} : {})};
            if (mark.path) return drawn(mark.close ? 'polygon' : 'polyline', {...common, points: mark.path.map(point).join(' ')});
            if (mark.circle) {
                const [cx, cy] = point(mark.circle);
                return drawn('circle', {...common, cx, cy, r: (sx * mark.circle[2]).toFixed(2)});
            }
            if (mark.dot) {
                const [cx, cy] = point(mark.dot);
                return drawn('circle', {style: `fill: ${colour}`, cx, cy, r: mark.size || 4});
            }
            if (mark.arrow) {
                const [[x, y], [X, Y]] = mark.arrow.map(one => point(one).map(Number)), length = Math.hypot(X - x, Y - y);
                if (length < 1) return drawn('g', {});
                const tip = Math.min(9, length), [cx, cy] = [(X - x) / length, (Y - y) / length];
                const wing = side => [X - tip * cx + side * tip * 0.45 * cy, Y - tip * cy - side * tip * 0.45 * cx].map(v => v.toFixed(2));
                return drawn('path', {...common, 'stroke-linejoin': 'round', d: `M${x} ${y}L${X} ${Y}M${wing(1)}L${X} ${Y}L${wing(-1)}`});
            }
            const [x, y] = point(mark.at);
            return drawn('text', {style: `fill: ${colour}`, x, y, 'text-anchor': mark.anchor || 'middle'}, mark.words);
        }));
    }

    // ---- a sentence

    class Sentence {
        constructor(place) {
            const {model, sliders, shows} = JSON.parse(place.dataset.sentence);
            this.model = models[model];
            this.numbers = {};
            this.outs = [...place.querySelectorAll('span[data-value]')].map(span => {
                const [name, how = ''] = span.dataset.value.split(' '), out = document.createElement('output');
                out.textContent = span.textContent;
                span.replaceChildren(out);
                return {name, how, out};
            });
            this.rows = sliders.map(slider => this.row(slider, place.querySelector(`span[data-slide="${slider.name}"]`)));
            this.figure = drawn('svg', {viewBox: `0 0 ${width} ${height}`, role: 'img', class: 'sentence-figure'});
            const below = document.createElement('div');
            below.className = 'sentence-below';
            const hands = document.createElement('div');
            hands.className = 'sentence-hands';
            const caption = document.createElement('p');
            caption.className = 'sentence-caption';
            caption.textContent = shows[0].toUpperCase() + shows.slice(1) + '.';
            this.figure.setAttribute('aria-label', caption.textContent);
            hands.append(...this.rows.map(row => row.all), caption);
            below.append(hands, this.figure);
            place.append(below);
            this.show();
        }

        // A number: dragged in the sentence, or by its slider below, which keys and screen readers reach.
        row({name, says, from, to, by, unit}, span) {
            const range = document.createElement('input'), label = document.createElement('label'), words = document.createElement('span'), now = document.createElement('b');
            const start = Number(span.textContent.replace('−', '-').replaceAll(',', ''));
            Object.assign(range, {type: 'range', min: from, max: to, step: by, value: start});
            words.textContent = says;
            now.setAttribute('aria-hidden', 'true');
            label.append(words, now, range);
            span.className = 'sentence-number';
            span.title = `Drag: ${says}, from ${from} to ${to}${unit && ' ' + unit}`;
            const row = {name, all: label, show: () => {
                const shown = written(Number(range.value), '.' + decimals(by));
                this.numbers[name] = Number(range.value);
                span.textContent = shown;
                now.textContent = shown + (unit && ' ' + unit);
                range.setAttribute('aria-valuetext', shown + (unit && ' ' + unit));
            }};
            const set = value => { range.value = value; this.show(); };
            range.addEventListener('input', () => this.show());
            let held = null;
            span.addEventListener('pointerdown', event => {
                held = {x: event.clientX, value: Number(range.value)};
                span.setPointerCapture(event.pointerId);
                event.preventDefault();
                range.focus({preventScroll: true});
            });
            span.addEventListener('pointermove', event => { if (held) set(held.value + (event.clientX - held.x) / 260 * (to - from)); });
            for (const end of ['pointerup', 'pointercancel']) span.addEventListener(end, () => { held = null; });
            span.addEventListener('dblclick', () => set(start));
            return row;
        }

        show() {
            for (const row of this.rows) row.show();
            const values = this.model.values(this.numbers);
            for (const {name, how, out} of this.outs) {
                const words = written(values[name], how);
                if (out.textContent !== words) out.textContent = words;
            }
            paint(this.figure, this.model.picture(this.numbers, values));
        }
    }

    document.addEventListener('DOMContentLoaded', () => {
        for (const place of document.querySelectorAll('.sentence')) new Sentence(place);
    });
})();
