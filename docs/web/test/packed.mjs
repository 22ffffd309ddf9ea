// Is the code of a program, as a page unpacks it, the file that pack.py packed, byte for byte?
//
//     node docs/web/test/packed.mjs DEMOS WASM
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {bytes_of} from '../node.mjs';
import {programs} from './programs.mjs';

const [demos, folder] = process.argv.slice(2);
let failed = 0, passed = 0;
for (const program of programs(demos)) {
    let what = '';
    try {
        const unpacked = Buffer.from(bytes_of(join(demos, program + '.js'))), packed = readFileSync(join(folder, program + '.wasm'));
        let same = 0;
        while (same < packed.length && unpacked[same] === packed[same]) ++same;
        if (same < packed.length || unpacked.length !== packed.length) what = `: ${unpacked.length} bytes for ${packed.length}, other ones from byte ${same} on`;
    } catch (error) {
        what = ': ' + error.message;
    }
    what ? ++failed : ++passed;
    if (what) console.log(`FAULT  ${program}${what}`);
}
console.log(`${passed} programs are unpacked as they were packed, ${failed} are not`);
process.exit(failed || !passed ? 1 : 0);
