// The sides of beside.mjs: our engine as wasm, and each peer as its npm package has it, all in this process.
import {copyFileSync, existsSync, mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {pathToFileURL} from 'node:url';
import '../web/unpack.js';
import '../web/join.js';
import '../web/machine.js';
import './box2d.js';
import './jolt.js';

export const frame = 1 / 60;

// A setting: {method, rounds, substeps, sleep}, rounds 0 or none: as they come. A method whose name begins with `small` makes
// so many steps in place of sub-steps: each looks for contacts.
const small = ({method}) => method.startsWith('small');

export class Ours {
    static async of(file) {
        const ours = new Ours();
        ours.machine = await RigidMachine.of(await WebAssembly.compile(readFileSync(file)));
        ours.scenes = ours.machine.program.scenes;
        ours.measures = ours.machine.program.measures;
        return ours;
    }
    open(scene, setting) {
        const {method, rounds = 0, substeps, sleep = false} = setting;
        this.steps = small(setting) ? substeps : 1;
        this.driven = this.scenes[scene].driven;
        this.machine.attempt('race_open', scene, ['engine', 'exact', 'sweeps'].indexOf(method.replace('small ', '')),
                             small(setting) ? 1 : substeps, rounds, sleep ? 1 : 0);
    }
    numbers(place, count) { return new Float64Array(this.machine.api.memory.buffer, place, count); }
    text() { return JSON.parse(this.machine.text(this.machine.api.race_scene())); }
    // The time of a frame's steps alone [ms].
    step() {
        let spent = 0;
        for (let i = 0; i < this.steps; ++i) {
            if (this.driven) this.machine.api.race_drive(0, frame / this.steps);
            const before = performance.now();
            const fault = this.machine.api.race_step(frame / this.steps);
            spent += performance.now() - before;
            if (fault) throw new Error(this.machine.text(this.machine.api.web_sentence()));
        }
        return spent;
    }
    errors() { return this.numbers(this.machine.api.race_errors(0), this.measures.length); }
    close() {}
}

// A peer. It gets the scene from ours, and where its bodies are goes to the judge of ours.
export class Theirs {
    constructor(ours, peer) { Object.assign(this, {ours, peer}); }
    open(scene, setting) {
        this.ours.open(scene, {method: 'engine', substeps: 1});
        this.scene = this.ours.text();
        this.driven = this.ours.driven;
        this.steps = small(setting) ? setting.substeps : 1;
        const stiffness = setting.method === 'stiff' ? setting.substeps / frame / 4 : 0; // Box2D's own bound
        this.peer.open(this.scene, small(setting) ? 1 : setting.substeps, setting.sleep, setting.rounds || stiffness);
    }
    positions() {
        const room = this.ours.numbers(this.ours.machine.api.race_theirs(), this.peer.coordinates * this.scene.bodies.length);
        this.peer.positions(room);
    }
    step() {
        const h = frame / this.steps;
        let spent = 0;
        for (let i = 0; i < this.steps; ++i) {
            if (this.driven) {
                this.positions();
                const drive = this.ours.numbers(this.ours.machine.api.race_drive(1, h), 3 * this.driven).slice();
                for (let k = 0; k < this.driven; ++k) this.peer.drive(k, drive.subarray(3 * k, 3 * k + 3));
            }
            const before = performance.now();
            this.peer.step(h);
            spent += performance.now() - before;
        }
        return spent;
    }
    errors() {
        this.positions();
        return this.ours.numbers(this.ours.machine.api.race_errors(1), this.ours.measures.length);
    }
    close() { this.peer.close(); }
}

// Each is null where its package is not installed. Both builds are those with vector instructions; they can use threads, and
// have none here.
export async function box2d_of(packages, build = 'deluxe') {
    const folder = join(packages, 'box2d3-wasm');
    if (!existsSync(folder)) return null;
    const file = join(folder, `build/dist/es/${build}/Box2D.${build}`);
    const {default: factory} = await import(pathToFileURL(file + '.mjs').href);
    const peer = await RigidBox2d.of({factory, code: readFileSync(file + '.wasm')});
    peer.coordinates = 3;
    return peer;
}

export async function jolt_of(packages, build = 'multithread.wasm') {
    const folder = join(packages, 'jolt-physics');
    if (!existsSync(folder)) return null;
    let file = join(folder, `dist/jolt-physics.${build}`);
    if (build === 'multithread.wasm') {
        // In node its threads end before they begin: `await import(…).workerData` lacks parentheses. A copy has them.
        const copy = join(packages, '../jolt_in_node/jolt-physics.multithread.wasm');
        mkdirSync(dirname(copy), {recursive: true});
        writeFileSync(join(dirname(copy), 'package.json'), '{"type": "module"}\n');
        writeFileSync(copy + '.js', readFileSync(file + '.js', 'utf8').replace('await import("node:worker_threads").workerData', '(await import("node:worker_threads")).workerData'));
        copyFileSync(file + '.wasm', copy + '.wasm');
        file = copy;
    }
    const {default: factory} = await import(pathToFileURL(file + '.js').href);
    const alive = setInterval(() => {}, 1000); // while its threads begin, nothing else waits
    const peer = await RigidJolt.of(factory, readFileSync(file + '.wasm'));
    clearInterval(alive);
    peer.coordinates = 7;
    return peer;
}
