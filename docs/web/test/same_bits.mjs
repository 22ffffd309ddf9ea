// Does a program give the same numbers in a page as without one, to the last bit?
//
//     node docs/web/test/same_bits.mjs DEMOS BIN [--only WORD]
//
// Every scene with its default method 300 steps, and with each of its other methods 100: the rows of --csv from the programs
// in BIN, and those of the same run in WebAssembly. other_bits.txt lists those that are known to differ, each with the reason;
// a run that differs and is not there, or is there and does not differ, is a fault.
import {readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {hash_of, machine_of} from '../node.mjs';
import {native_rows, programs} from './programs.mjs';

const words = process.argv.slice(2);
const only = words.includes('--only') ? words.splice(words.indexOf('--only'), 2)[1] : '';
const [demos, bin] = words;
const known = {};
for (const line of readFileSync(join(dirname(fileURLToPath(import.meta.url)), 'other_bits.txt'), 'utf8').split('\n')) {
    const found = line.match(/^([\w-]+(?:\/[\w-]+){1,2}) +(\S.*)$/);
    if (found && found[1].includes(only)) known[found[1]] = {reason: found[2], met: false};
}

let failed = 0, passed = 0, scenes = 0;
for (const program of programs(demos)) {
    if (!program.includes(only)) continue;
    const machine = await machine_of(join(demos, program + '.js'));
    for (const scene of machine.program.scenes) {
        ++scenes;
        for (const [place, method] of (scene.methods.length ? scene.methods : ['']).entries()) {
            const name = `${program}/${scene.name}${method && '/' + method}`, steps = place === 0 ? 300 : 100;
            const {columns, rows} = native_rows(bin, program, scene.name, method, steps);
            const page = machine.choose({scene: scene.name, methods: method ? [method] : []}).run(steps).map(x => x + 0); // the table never says -0
            const same = hash_of(rows) === hash_of(page);
            let first = -1;
            if (!same) {
                first = 0;
                while (first < rows.length && Object.is(rows[first], page[first])) ++first;
            }
            const width = columns.length;
            const where = same ? '' : first >= rows.length ? 'a page goes on longer' :
                `from step ${rows[first - first % width]} on, ${columns[first % width]} ${rows[first]} and ${page[first]}`;
            const listed = known[name] || known[`${program}/${scene.name}`];
            if (listed && !same) listed.met = true;
            const right = same || !!listed;
            right ? ++passed : ++failed;
            console.log(`${right ? 'ok    ' : 'FAULT '} ${name.padEnd(52)}${hash_of(rows)} ${hash_of(page)} ` +
                        (same ? rows.length ? 'the same' : 'refused on both sides' : `other bits ${where}: ${listed ? listed.reason : 'and no reason is known'}`));
        }
    }
}
for (const [name, {met}] of Object.entries(known)) {
    if (met) continue;
    ++failed;
    console.log(`FAULT  ${name}: other_bits.txt lists it, and no such run differs`);
}
console.log(`${passed} runs of ${scenes} scenes passed, ${failed} failed`);
process.exit(failed || !passed ? 1 : 0);
