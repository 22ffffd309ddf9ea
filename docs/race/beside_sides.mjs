// The sides of beside.mjs: our engine as wasm, and each peer as its npm package has it, all in this process.
import {existsSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import '../web/unpack.js';
import '../web/join.js';
import '../web/machine.js';
import './box2d.js';

export const frame = 1 / 60;

// Ours. A setting: {method, substeps, sweeps, sleep, steps}; a frame is `steps` steps, each of which looks for contacts.
export class Ours {
    static async of(file) {
        const ours = new Ours();
        ours.machine = await RigidMachine.of(await WebAssembly.compile(readFileSync(file)));
        ours.scenes = ours.machine.program.scenes;
        ours.measures = ours.machine.program.measures;
        return ours;
    }
    open(scene, {method, substeps, sweeps = 0, sleep = false, steps = 1}) {
        const {machine} = this;
        this.steps = steps;
        this.driven = this.scenes[scene].driven;
        machine.attempt('race_open', scene, ['engine', 'exact', 'sweeps'].indexOf(method), substeps, sweeps, sleep ? 1 : 0);
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
        this.peer.open(this.scene, setting.substeps, setting.sleep, setting.rounds);
    }
    positions() {
        const room = this.ours.numbers(this.ours.machine.api.race_theirs(), this.peer.coordinates * this.scene.bodies.length);
        this.peer.positions(room);
    }
    step() {
        if (this.driven) {
            this.positions();
            const drive = this.ours.numbers(this.ours.machine.api.race_drive(1, frame), 3 * this.driven).slice();
            for (let k = 0; k < this.driven; ++k) this.peer.drive(k, drive.subarray(3 * k, 3 * k + 3));
        }
        const before = performance.now();
        this.peer.step(frame);
        return performance.now() - before;
    }
    errors() {
        this.positions();
        return this.ours.numbers(this.ours.machine.api.race_errors(1), this.ours.measures.length);
    }
    close() { this.peer.close(); }
}

// Each is null where its package is not installed.
export async function box2d_of(packages, build = 'deluxe') {
    const folder = join(packages, 'box2d3-wasm');
    if (!existsSync(folder)) return null;
    const file = join(folder, `build/dist/es/${build}/Box2D.${build}`);
    const {default: factory} = await import(pathToFileURL(file + '.mjs').href);
    const peer = await RigidBox2d.of({factory, code: readFileSync(file + '.wasm')});
    peer.coordinates = 3;
    return peer;
}
