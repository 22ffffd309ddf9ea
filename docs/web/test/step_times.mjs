// How long a step takes in WebAssembly (node), against the same program without it, for one scene of each: the default one,
// or where that solves one problem and then stands still, another.
//
//     node docs/web/test/step_times.mjs DEMOS BIN [--only WORD] [--turns N]
//
// Both sides call the same function (common/program/steps_alone.hpp) once for many steps: no row is measured, no picture drawn,
// and where a scene ends early it is started again. BIN has the programs of the target `steps_alone`. What is counted is the
// difference between long runs and short ones, so that neither the start of a module nor that of a scene counts. Both sides
// run by turns; the ratio is that of the least times, and beside it stand the lowest and the highest of one turn. Exit code 1
// if a step takes more than 1.5 times as long.
import {spawnSync} from 'node:child_process';
import {join} from 'node:path';
import v8 from 'node:v8';
import {machine_of} from '../node.mjs';
import {programs} from './programs.mjs';

// What a step takes once a page has run for a while: V8 compiles the whole module by its optimising compiler at once. With its
// first tier a function changes sides in the middle, and the same program had ratios from 1.1 to 1.7.
v8.setFlagsFromString('--no-liftoff');

const words = process.argv.slice(2);
const option = (name, other) => words.includes(name) ? words.splice(words.indexOf(name), 2)[1] : other;
const only = option('--only', ''), turns = Number(option('--turns', 7)), most = 1.5;
const [demos, bin] = words;

const moving = {'05_lemke': 'ten_discs', '09_active_sets': 'ten_discs'};
const awake = {'19_engine': {sleep: 0}}; // asleep a world makes no step

// Time of a processor, not of a clock: other programs may run beside this. {made, time}, in microseconds.
function native(program, scene, settings, steps, starts) {
    const done = spawnSync(join(bin, program + '_steps'), [scene, String(steps), String(starts), ...Object.entries(settings).map(one => one.join('='))],
                           {encoding: 'utf8'});
    if (done.error || done.status !== 0) throw done.error || new Error(done.stderr);
    const [made, time] = done.stdout.split(' ').map(Number);
    return {made, time};
}

function web(machine, scene, settings, steps, starts) {
    machine.choose({scene, settings});
    const before = process.cpuUsage();
    const made = machine.api.web_steps(steps, starts);
    const {user, system} = process.cpuUsage(before);
    return {made, time: user + system};
}

let slow = 0;
console.log('scene'.padEnd(40) + 'steps'.padStart(9) + 'native'.padStart(10) + 'page'.padStart(10) + 'ratio'.padStart(8) + '   of one turn   (µs a step)');
for (const program of programs(demos)) {
    if (!program.includes(only)) continue;
    const machine = await machine_of(join(demos, program + '.js'));
    const scene = moving[program] || machine.program.scenes[0].name, settings = awake[program] || {};
    const run = (steps, starts) => web(machine, scene, settings, steps, starts);
    // As many steps as take about a quarter of a second, at most 3000 from one start.
    const {made} = run(3000, 1);
    const short = Math.min(100, Math.floor(made / 4));
    for (let turn = 0; turn < 3; ++turn) run(made, 1);
    const guess = Math.max(0.001, (run(made, 3).time - run(short, 3).time) / (3 * (made - short)));
    const long = Math.max(2 * short, Math.min(made, Math.round(2.5e5 / guess))), starts = Math.max(1, Math.round(2.5e5 / (guess * long)));
    const steps = starts * (long - short);
    const least = {native: Infinity, web: Infinity}, ratios = [];
    for (let turn = 0; turn < turns; ++turn) {
        const here = native(program, scene, settings, long, starts).time - native(program, scene, settings, short, starts).time;
        const there = run(long, starts).time - run(short, starts).time;
        least.native = Math.min(least.native, here);
        least.web = Math.min(least.web, there);
        ratios.push(there / here);
    }
    const ratio = least.web / least.native;
    if (ratio > most) ++slow;
    console.log(`${program}/${scene}`.padEnd(40) + String(steps).padStart(9) + (least.native / steps).toFixed(3).padStart(10) + (least.web / steps).toFixed(3).padStart(10) +
                ratio.toFixed(2).padStart(8) + `   ${Math.min(...ratios).toFixed(2)} to ${Math.max(...ratios).toFixed(2)}` + (ratio > most ? `   more than ${most} times` : ''));
}
process.exit(slow ? 1 : 0);
