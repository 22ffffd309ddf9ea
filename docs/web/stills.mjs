// Draws the still picture of each demo that the texts name, and writes what a page says of it.
//
//     node docs/web/stills.mjs DEMOS FOLDER <LIST      DEMOS: the packed programs, LIST: docs/tools/demos.py
//
// FOLDER gets a picture for each, and demos.json: {still: {summary, width, height}}. A demo whose scene, method or
// setting its program does not have is one sentence, and exit code 1.
import {existsSync, mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {SvgContext, code_of, still_colours} from './node.mjs';

const [, , demos, folder] = process.argv;
const list = JSON.parse(readFileSync(0, 'utf8'));
const width = 800, most = 460, steps = 40;
const codes = {}, told = {};
mkdirSync(folder, {recursive: true});
let faults = 0;
for (const demo of list) {
    try {
        const script = join(demos, demo.program + '.js');
        if (!existsSync(script)) throw new Error(`there is no program ${demo.program}`);
        codes[demo.program] = codes[demo.program] || await code_of(script);
        const machine = await RigidMachine.of(codes[demo.program]);
        const scene = machine.program.scenes.find(one => one.name === demo.scene);
        if (!scene) throw new Error(`there is no scene ${demo.scene}; there are: ${machine.program.scenes.map(one => one.name).join(', ')}`);
        const broken = demo.break || {methods: [], settings: {}};
        for (const method of [...demo.methods, ...broken.methods])
            if (!scene.methods.includes(method)) throw new Error(`scene ${demo.scene} has no method ${method}; it has: ${scene.methods.join(', ')}`);
        for (const [name, value] of Object.entries({...demo.settings, ...broken.settings})) {
            const row = scene.sliders.find(one => one.name === name);
            if (!row) throw new Error(`scene ${demo.scene} has no tunable ${name}`);
            if (!(value >= row.low && value <= row.high)) throw new Error(`${name} is ${value}; it must lie between ${row.low} and ${row.high}`);
        }
        machine.choose(demo).attempt('web_open');
        machine.api.web_script(1);
        for (let i = 0; i < steps && !machine.is_over(); ++i) machine.attempt('web_step');
        const height = Math.round(machine.api.web_height(width, most));
        const context = new SvgContext();
        rigid_paint(context, machine.list('web_picture', width, height), still_colours);
        writeFileSync(join(folder, demo.still), context.svg(width, height));
        told[demo.still] = {summary: scene.summary, width, height};
    } catch (error) {
        ++faults;
        console.error(`${demo.where}: the demo: ${error.message}.`);
    }
}
writeFileSync(join(folder, 'demos.json'), JSON.stringify(told, null, 1));
process.exit(faults ? 1 : 0);
