// The size of each program for a page, as a browser gets it from a host that compresses (gzip), and of what all demos
// share.
//
//     node docs/web/sizes.mjs DEMOS RACE
//
// Exit code 1 if one is larger than 200 kB or all together are larger than 5 MB.
import {readFileSync, readdirSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {gzipSync} from 'node:zlib';

const most = 200e3, most_of_all = 5e6;
const kilobytes = bytes => (bytes / 1000).toFixed(1).padStart(8) + ' kB';
const sizes = file => { const text = readFileSync(file); return [text.length, gzipSync(text, {level: 9}).length]; };
const own = dirname(fileURLToPath(import.meta.url));

let all = 0, faults = 0;
const row = (name, [raw, packed]) => console.log(name.padEnd(28) + kilobytes(raw) + kilobytes(packed));
console.log('program'.padEnd(28) + 'as it is'.padStart(11) + 'gzip'.padStart(11));
for (const folder of process.argv.slice(2)) for (const name of readdirSync(folder).filter(one => one.endsWith('.js')).sort()) {
    const found = sizes(join(folder, name));
    row(name.replace('.js', ''), found);
    all += found[1];
    if (found[1] <= most) continue;
    ++faults;
    console.error(`${name} has ${found[1]} bytes in gzip; a program for a page has ${most} at most`);
}
for (const name of ['unpack.js', 'join.js', 'machine.js', 'painter.js', 'demo.js', 'cards.js', 'sentence.js', 'demo.css', 'sentence.css', '../race/race.js', '../race/box2d.js', '../race/race.css']) {
    const found = sizes(join(own, name));
    row(name.split('/').pop(), found);
    all += found[1];
}
console.log('all'.padEnd(28) + ''.padStart(11) + kilobytes(all));
if (all > most_of_all) {
    ++faults;
    console.error(`all together have ${all} bytes in gzip; they may have ${most_of_all}`);
}
process.exit(faults ? 1 : 0);
