// Does a program give the same numbers in a page as without one, to the last bit?
//
//     node docs/web/test/same_bits.mjs DEMOS BIN
//
// Every scene with its default method, 300 steps: the rows of --csv from the programs in BIN, and those of the same run in
// WebAssembly. other_bits.txt lists the scenes that are known to differ, each with the reason; a scene that differs and is
// not there, or is there and does not differ, is a fault.
import {readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {hash_of, machine_of} from '../node.mjs';
import {native_rows, programs} from './programs.mjs';

const [, , demos, bin] = process.argv;
const steps = 300;
const known = {};
for (const line of readFileSync(join(dirname(fileURLToPath(import.meta.url)), 'other_bits.txt'), 'utf8').split('\n')) {
    const found = line.match(/^([\w-]+\/[\w-]+) +(\S.*)$/);
    if (found) known[found[1]] = found[2];
}

let failed = 0, passed = 0;
for (const program of programs(demos)) {
    const machine = await machine_of(join(demos, program + '.js'));
    for (const [place, scene] of machine.program.scenes.entries()) {
        const name = `${program}/${scene.name}`;
        const {columns, rows} = native_rows(bin, program, scene.name, steps);
        const page = machine.choose({scene: scene.name}).run(steps).map(x => x + 0); // the table never says -0
        const same = hash_of(rows) === hash_of(page);
        let first = -1;
        if (!same) {
            first = 0;
            while (first < rows.length && Object.is(rows[first], page[first])) ++first;
        }
        const width = columns.length;
        const where = same ? '' : first >= rows.length ? 'a page goes on longer' :
            `from step ${rows[first - first % width]} on, ${columns[first % width]} ${rows[first]} and ${page[first]}`;
        const right = same === !(name in known);
        right ? ++passed : ++failed;
        console.log(`${right ? 'ok    ' : 'FAULT '} ${name.padEnd(44)}${place === 0 ? 'default ' : '        '}${hash_of(rows)} ${hash_of(page)} ` +
                    (same ? (name in known ? 'the same, though other_bits.txt lists it' : 'the same')
                          : `other bits ${where}: ${known[name] || 'and no reason is known'}`));
        delete known[name];
    }
}
for (const name of Object.keys(known)) {
    ++failed;
    console.log(`FAULT  ${name}: other_bits.txt lists it, and there is no such scene`);
}
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed || !passed ? 1 : 0);
