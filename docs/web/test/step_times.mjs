// How long a step takes in WebAssembly (node), against the same program without it, for the default scene of each.
//
//     node docs/web/test/step_times.mjs DEMOS BIN
//
// The time between a short and a long run, so that neither the start of a process nor of a module counts; both sides by
// turns, the least of several. Exit code 1 if a step takes more than 1.5 times as long and is one that can be measured.
import {spawnSync} from 'node:child_process';
import {join} from 'node:path';
import {machine_of} from '../node.mjs';
import {programs} from './programs.mjs';

const [, , demos, bin] = process.argv;
const short_run = 100, turns = 5, most = 1.5;

// Time of a processor, not of a clock: other programs may run beside this. In microseconds.
function native(program, scene, steps) {
    const done = spawnSync('bash', ['-c', 'TIMEFORMAT=%3U; time "$0" "$@" >/dev/null', join(bin, program),
                                    '--scene', scene, '--headless', '--steps', String(steps)], {encoding: 'utf8'});
    if (done.error || done.status !== 0) throw done.error || new Error(done.stderr);
    return 1e6 * Number(done.stderr.trim().split('\n').pop());
}

// As many of these steps as the scene can make: an explicit method that explodes says at which step it ended.
function possible(program, scene, steps) {
    const done = spawnSync(join(bin, program), ['--scene', scene, '--headless', '--steps', String(steps)], {encoding: 'utf8'});
    const ended = /^step (\d+):/m.exec(done.stderr);
    return ended ? Number(ended[1]) - 1 : steps;
}

function web(machine, scene, steps) {
    machine.choose({scene});
    const before = process.cpuUsage();
    machine.api.web_run(steps, 1);
    return process.cpuUsage(before).user;
}

let slow = 0;
console.log('scene'.padEnd(40) + 'steps'.padStart(8) + 'native'.padStart(10) + 'page'.padStart(10) + 'ratio'.padStart(8) + '   µs a step');
for (const program of programs(demos)) {
    const machine = await machine_of(join(demos, program + '.js'));
    const scene = machine.program.scenes[0].name;
    web(machine, scene, 3000); // the compiler of the browser has seen it
    // As many steps as take about a third of a second.
    const guess = Math.max(0.1, (web(machine, scene, 500) - web(machine, scene, short_run)) / 400);
    const wanted = short_run + Math.min(1000000, Math.max(200, Math.round(3e5 / guess)));
    const steps = possible(program, scene, wanted);
    const best = {native: Infinity, web: Infinity};
    for (let turn = 0; turn < turns; ++turn) {
        best.native = Math.min(best.native, native(program, scene, steps) - native(program, scene, short_run));
        best.web = Math.min(best.web, web(machine, scene, steps) - web(machine, scene, short_run));
    }
    const each = {native: best.native / (steps - short_run), web: best.web / (steps - short_run)};
    const ratio = each.web / each.native;
    if (ratio > most) ++slow;
    console.log(`${program}/${scene}`.padEnd(40) + String(steps).padStart(8) + each.native.toFixed(2).padStart(10) + each.web.toFixed(2).padStart(10) +
                ratio.toFixed(2).padStart(8) + (ratio > most ? `   more than ${most} times` : ''));
}
process.exit(slow ? 1 : 0);
