// The sentences whose numbers can be dragged: does a text say what its model computes, and does the model still compute what
// tests/small/sentences.csv has, which the test `sentences` holds to the small programs?
//
//     python3 docs/tools/sentences.py | node docs/web/test/sentences.mjs [--write]
//
// --write: the table once more.
import {readFileSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '../../..'), require = createRequire(import.meta.url);
require(join(root, 'docs/web/sentence.js'));
const {models, written, decimals} = globalThis.rigid_sentences;
const table = join(root, 'tests/small/sentences.csv');
const sentences = JSON.parse(readFileSync(0, 'utf8'));
const faults = [];
const rows = [];
const pairs = one => Object.entries(one).map(([name, value]) => `${name}=${value}`).join(' ');

for (const {where, chapter, model, sliders, slides, values} of sentences) {
    if (!models[model]) require(join(root, 'chapters', chapter, 'sentence.js'));
    const own = models[model], said = Object.fromEntries(sliders.map(one => [one.name, one.value]));
    for (const {name, value, by} of sliders) {
        const shown = written(value, '.' + decimals(by));
        if (shown !== slides[name]) faults.push(`${where}: ${name} is written ${slides[name]}; the page would write ${shown}.`);
    }
    const follows = own.values(said);
    for (const [what, words] of values) {
        const [name, how = ''] = what.split(' ');
        if (!(name in follows)) faults.push(`${where}: the model ${model} has no value ${name}; it has ${Object.keys(follows).join(', ')}.`);
        else if (written(follows[name], how) !== words) faults.push(`${where}: ${name} is ${written(follows[name], how)}; the text says ${words}.`);
    }
    // What is said, and each number at five places of its range; the figure has something to show at all of them.
    const places = [said];
    for (const {name, from, to, by} of sliders)
        for (const part of [0, 0.25, 0.5, 0.75, 1]) places.push({...said, [name]: Number((from + Math.round(part * (to - from) / by) * by).toFixed(9))});
    for (const place of places) {
        const out = own.values(place), {view, marks} = own.picture(place, out);
        if (!view.every(Number.isFinite) || !marks.length) faults.push(`${where}: ${model} has no figure at ${pairs(place)}.`);
        const numbers = Object.fromEntries(Object.entries(out).filter(([, value]) => typeof value === 'number'));
        rows.push(`${model};${pairs(place)};${pairs(numbers)}`);
    }
}

if (process.argv.includes('--write')) writeFileSync(table, rows.join('\n') + '\n');
const kept = readFileSync(table, 'utf8').trim().split('\n');
if (kept.length !== rows.length) faults.push(`the table has ${kept.length} rows, the models have ${rows.length}; 'docs/build.sh sentences' writes it.`);
for (const [k, row] of rows.entries()) {
    const [model, place, now] = row.split(';'), [was_model, was_place, was] = (kept[k] || ';;').split(';');
    // Another engine's exp and sin may differ in the last bits.
    const near = now.split(' ').every((one, i) => {
        const [name, value] = one.split('='), [old, number] = (was.split(' ')[i] || '').split('=');
        return name === old && Math.abs(value - number) <= 1e-9 * Math.max(1, Math.abs(number));
    });
    if (model !== was_model || place !== was_place || !near) faults.push(`${model} at ${place}: ${now}; the table has ${was_model} at ${was_place}: ${was}.`);
}
for (const fault of faults) console.error(fault);
console.log(`sentences: ${sentences.length}, with ${rows.length} rows of numbers`);
process.exit(faults.length ? 1 : 0);
