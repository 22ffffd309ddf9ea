// Our engine, as wasm, and a peer of npm in the same process of node, on the same scenes: errors and times.
//
//     node docs/race/beside.mjs plane|space [--write | --check | --text] [--scenes NAME,…] [--builds FOLDER]
//
// plane: the engine of chapter 19 beside Box2D v3 (docs/race.md). space: the methods of chapter 25 beside Jolt
// (chapters/25_world_in_space/in_depth.md). A run gives build/race/NAME.csv (of some scenes alone: NAME_SCENE_….csv) and prints its tables. --write puts both into the book:
// docs/race/beside_NAME.csv, and the text between <!-- beside: NAME --> and <!-- /beside -->. --text fills only the text, from
// the table that the book has. --check measures no time: each error must be that of the book's table, as printed.
// A peer that is not installed is left out; --write and --text then refuse.
import {cpus, loadavg} from 'node:os';
import {existsSync, mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {Ours, Theirs, box2d_of, jolt_of} from './beside_sides.mjs';
import {columns, row_of, tables_of} from './beside_tables.mjs';

const own = dirname(fileURLToPath(import.meta.url)), root = join(own, '../..'), packages = join(root, 'build/peers/node_modules');

const every = (list, make) => list.flatMap(make), overlaps = scene => scene.errors.includes('overlap');
// What takes minutes in one step by an exact solver, or in few, has fewer settings.
const large = scene => ['pyramid', 'rubble', 'pour', 'dolls', 'tumbler', 'wall', 'pour_60', 'pour_300'].includes(scene.name);
const parts = {
    plane: {
        wasm: 'race_plane.wasm', text: 'docs/race.md', peer: 'Box2D', package: 'box2d3-wasm', build: 'deluxe', peer_of: () => box2d_of(packages), judged_from: 0,
        ours: scene => [
            {method: 'engine', substeps: 1, sleep: true},
            ...(overlaps(scene) ? every([2, 4], substeps => ({method: 'small engine', substeps})) : []),
            ...every(large(scene) ? [1, 4, 16] : [1, 2, 4, 8, 16], substeps => [
                {method: 'engine', substeps},
                ...(large(scene) ? [] : [{method: 'exact', substeps}]),
                ...every(large(scene) ? [15, 60] : [15, 60, 240], rounds => ({method: 'sweeps', rounds, substeps})),
                ...(overlaps(scene) && substeps > 1 ? [{method: 'small sweeps', rounds: 60, substeps}] : [])])],
        theirs: scene => [
            {method: 'its own', substeps: 4, sleep: true},
            ...every([1, 2, 4, 8, 16, 32, 64], substeps => ({method: 'its own', substeps})),
            ...(scene.name === 'chain' ? [] : every([8, 16, 32, 64], substeps => ({method: 'stiff', substeps}))), // at 4 it is its own
            ...every([2, 4, 8, 16], substeps => ({method: 'small steps', substeps}))],
        equal: [['our side by its own choice of method', {method: 'engine'}, {method: 'its own'}]],
        spoken: "Ours: method, sub-steps; after `sweeps`, how many at most. Box2D's: sub-steps; `stiff`: contacts as stiff as it lets them be with so many; its package can't set joints. `small`: so many steps of a part of the time in place of sub-steps, each of which looks for contacts.",
    },
    space: {
        wasm: 'race_space.wasm', text: 'chapters/25_world_in_space/in_depth.md', peer: 'Jolt', package: 'jolt-physics', build: 'multithread', peer_of: () => jolt_of(packages), judged_from: 60,
        ours: scene => [
            {method: 'exact', substeps: 1, sleep: true},
            ...every(large(scene) ? [1, 4, 16] : [1, 2, 4, 8, 16], substeps => [
                ...(['wall', 'pour_300'].includes(scene.name) || (large(scene) && substeps > 4) ? [] : [{method: 'exact', substeps}]),
                ...every(large(scene) ? [10, 50] : [10, 50, 200], rounds => ({method: 'sweeps', rounds, substeps})),
                ...(overlaps(scene) && substeps > 1 ? [{method: 'small sweeps', rounds: 50, substeps}] : [])])],
        theirs: scene => [
            {method: 'its own', substeps: 1, sleep: true},
            ...every([1, 2, 4, 8, 16, 32, 64], substeps => ({method: 'its own', substeps})),
            ...every(large(scene) ? [1, 2, 4, 8, 16] : [1, 2, 4, 8, 16, 32, 64], substeps => ({method: 'its own', rounds: 50, substeps}))],
        equal: [['50 sweeps and 50 iterations', {method: 'sweeps', rounds: '50'}, {method: 'its own', rounds: '50'}],
                ['the exact solver and Jolt as it comes', {method: 'exact', rounds: ''}, {method: 'its own', rounds: ''}]],
        spoken: "Ours: method, sub-steps; after `sweeps`, how many at most. Jolt's: iterations if not its own 10, sub-steps. `small`: so many steps of a part of the time in place of sub-steps, each of which looks for contacts, as Jolt's sub-steps do.",
    },
};

const words = process.argv.slice(2);
const flag = name => words.includes(name) && words.splice(words.indexOf(name), 1).length > 0;
const option = name => words.includes(name) ? words.splice(words.indexOf(name), 2)[1] : '';
const [write, check, text] = ['--write', '--check', '--text'].map(flag);
const only = option('--scenes').split(',').filter(Boolean), builds = option('--builds') || join(root, 'build/web/bin');
const name = words[0], part = parts[name];
const fail = sentence => { console.error(sentence); process.exit(2); };
if (!part || words.length > 1 || write + check + text > 1 || (only.length && (write || text)))
    fail('usage: node docs/race/beside.mjs plane|space [--write | --check | --text] [--scenes NAME,…] [--builds FOLDER]; --scenes goes with --check alone');
const load = loadavg()[0], peer_is_here = () => existsSync(join(packages, part.package));
const kept = join(own, `beside_${name}.csv`);

// One setting on one scene: the largest error of each kind in a run of its own, then the time in several more.
function measure(side, scene, place, setting, timed) {
    const line = {scene: scene.name, ...setting, errors: scene.errors.map(() => 0), time: Infinity, sentence: ''};
    try {
        side.open(place, setting);
        for (let k = 0; k < scene.steps; ++k) {
            side.step();
            const found = side.errors();
            line.errors = scene.errors.map((what, i) => what === 'overlap' && k < part.judged_from ? 0 : Math.max(line.errors[i], found[side.kinds.indexOf(what)]));
            if (line.errors.includes(Infinity)) break;
        }
        side.close();
        if (!timed || line.errors.includes(Infinity)) return line;
        // A run makes the same steps each time: of each the least time, whatever else the machine did in some of the runs. And
        // of a whole run no more than the processor's time, which says more of long steps on a machine that is busy.
        const least = new Float64Array(scene.steps).fill(Infinity);
        let processor = Infinity;
        for (let turn = 0, spent = 0; turn < 1 || (turn < 3 && spent < 3000) || (spent < 300 && turn < 20); ++turn) {
            side.open(place, setting);
            const before = process.cpuUsage();
            for (let k = 0; k < scene.steps; ++k) {
                const took = side.step();
                spent += took;
                least[k] = Math.min(least[k], took);
            }
            const {user, system} = process.cpuUsage(before);
            processor = Math.min(processor, user + system);
            side.close();
        }
        line.time = Math.min(1000 * least.reduce((sum, one) => sum + one, 0), processor) / scene.steps;
    } catch (fault) {
        line.sentence = fault.message;
        line.errors.fill(Infinity);
    }
    return line;
}

async function run() {
    const wasm = join(builds, part.wasm);
    if (!existsSync(wasm)) fail(`${wasm} is not there; build it by ./book race`);
    const ours = await Ours.of(wasm), peer = await part.peer_of();
    ours.kinds = ours.measures;
    if (!peer) {
        const sentence = `${part.package} is not installed (./book setup peers): our side runs alone`;
        if (write) fail(`${sentence}, which is no table for the book`);
        console.log(sentence);
    }
    const theirs = peer && new Theirs(ours, peer);
    if (peer) theirs.kinds = ours.kinds;
    for (const one of only) if (!ours.scenes.some(scene => scene.name === one)) fail(`there is no scene '${one}'; there are: ${ours.scenes.map(scene => scene.name).join(', ')}`);
    const rows = [];
    for (const [place, scene] of ours.scenes.entries()) {
        if (only.length && !only.includes(scene.name)) continue;
        const settings = [...part.ours(scene).map(one => [ours, {who: 'book', ...one}]),
                          ...(peer ? part.theirs(scene).map(one => [theirs, {who: part.peer, method: 'its own', ...one}]) : [])];
        for (const [side, setting] of settings) {
            const line = measure(side, scene, place, setting, !check), row = row_of(line, scene);
            rows.push(row);
            console.log(columns.map((column, i) => row[column].padEnd([9, 6, 13, 4, 5, 5, 8, 8, 8, 8][i])).join(' ') + line.sentence);
        }
    }
    return rows;
}

// The first line of a table: what it was measured with. A load above 1.5 when it began is said in the text too.
const circumstances = () => {
    const {version} = JSON.parse(readFileSync(join(packages, part.package, 'package.json'), 'utf8'));
    return `# node ${process.version}, ${part.package} ${version} (${part.build}), ${cpus()[0].model.trim()}, load ${load.toFixed(1)}`;
};
const as_csv = rows => (peer_is_here() ? circumstances() + '\n' : '') + [columns, ...rows.map(row => columns.map(column => row[column]))].map(row => row.join(',') + '\n').join('');
const from_csv = file => readFileSync(file, 'utf8').trim().split('\n').filter(row => !row.startsWith('#')).slice(1).map(row => row.split(','))
    .map(row => Object.fromEntries(columns.map((column, i) => [column, row[i]])));

async function fill(rows) {
    const titles = new Map((await Ours.of(join(builds, part.wasm))).scenes.map(scene => [scene.name, scene.title]));
    const file = join(root, part.text), old = readFileSync(file, 'utf8');
    const place = new RegExp(`(<!-- beside: ${name} -->\\n)[^]*?(<!-- /beside -->)`);
    if (!place.test(old)) fail(`${part.text} has no place for the tables: <!-- beside: ${name} --> and <!-- /beside -->`);
    const with_what = readFileSync(kept, 'utf8').match(/^# (.*), load ([\d.]+)$/m);
    const made = (with_what ? `Measured with ${with_what[1]}${Number(with_what[2]) > 1.5 ? `. **The machine was busy with other things** (load ${with_what[2]}): errors stand, times will be taken again` : ', on an idle machine'}.\n\n` : '') + tables_of(rows, titles, part);
    const left = [...titles].filter(([scene]) => !rows.some(row => row.scene === scene)).map(([, title]) => title);
    const unmeasured = left.length ? `Not in this table yet: ${left.join('; ')}.\n\n` : '';
    writeFileSync(file, old.replace(place, (all, begin, end) => `${begin}\n${unmeasured}${made}\n${end}`));
}

if ((text || check) && !existsSync(kept)) fail(`${kept} is not there; ./book race --write makes it`);
if (text) {
    await fill(from_csv(kept));
    process.exit(0);
}
const rows = await run();
if (check) {
    const key = row => columns.slice(0, 6).map(column => row[column]).join(' '), errors = row => columns.slice(6, 9).map(column => row[column]).join(' ');
    const known = new Map(from_csv(kept).map(row => [key(row), errors(row)]));
    const faults = rows.filter(row => known.get(key(row)) !== errors(row));
    for (const row of faults) console.log(`FAULT  ${key(row)}: the errors are ${errors(row)}, in docs/race/beside_${name}.csv ${known.get(key(row))}`);
    const ran = new Set(rows.map(key)), with_peer = rows.some(row => row.who === part.peer);
    const left = only.length ? [] : from_csv(kept).filter(row => !ran.has(key(row)) && (with_peer || row.who === 'book'));
    for (const row of left) console.log(`FAULT  ${key(row)} is in docs/race/beside_${name}.csv and was not run`);
    console.log(`${faults.length ? 'FAULT ' : 'ok    '} ${rows.length - faults.length} of ${rows.length} lines are those of docs/race/beside_${name}.csv`);
    process.exit(faults.length + left.length ? 1 : 0);
}
mkdirSync(join(root, 'build/race'), {recursive: true});
writeFileSync(join(root, `build/race/${[name, ...only].join('_')}.csv`), as_csv(rows));
if (write) {
    writeFileSync(kept, as_csv(rows));
    await fill(rows);
} else if (rows.some(row => row.who === part.peer)) console.log('\n' + tables_of(rows, new Map(), part));
process.exit(0); // a peer may have left threads that wait
