// What the tests of this folder share: the programs of both sides.
import {spawnSync} from 'node:child_process';
import {readdirSync} from 'node:fs';
import {join} from 'node:path';

export const programs = demos => readdirSync(demos).filter(one => one.endsWith('.js')).map(one => one.replace('.js', '')).sort();

// The table of a run without a window: rows of numbers, as long as the columns, and the names of the columns.
export function native_rows(bin, program, scene, method, steps) {
    const done = spawnSync(join(bin, program), ['--scene', scene, ...(method ? ['--method', method] : []), '--headless', '--steps', String(steps), '--csv', '-'],
                           {encoding: 'utf8', maxBuffer: 1 << 28});
    if (done.error) throw done.error;
    const [head, ...lines] = done.stdout.trim().split('\n');
    return {columns: head.split(','), rows: Float64Array.from(lines.flatMap(line => line.split(',').map(Number)))};
}
