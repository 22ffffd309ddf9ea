// The tables of beside.mjs: rows of its CSV, and what a text says of them.
export const columns = ['scene', 'who', 'method', 'rounds', 'substeps', 'sleep', 'moved_m', 'gap_m', 'overlap_m', 'us_step'];
const kinds = {moved: 'moved by', gap: 'joints open by', overlap: 'overlap'};

// Two digits.
export const digits = x => !isFinite(x) ? 'lost' : x === 0 ? '0' : x < 1e-3 || x >= 1e4 ? x.toExponential(1) : String(Number(x.toPrecision(2)));
const time = x => !isFinite(x) ? '' : x < 10 ? String(Number(x.toPrecision(2))) : x.toFixed(0);

export function row_of(line, scene) {
    const error = what => scene.errors.includes(what) ? digits(line.errors[scene.errors.indexOf(what)]) : '';
    return {scene: line.scene, who: line.who, method: line.method, rounds: String(line.rounds || ''), substeps: String(line.substeps),
            sleep: line.sleep ? 'yes' : 'no', moved_m: error('moved'), gap_m: error('gap'), overlap_m: error('overlap'), us_step: time(line.time)};
}

const value = cell => cell === '' ? NaN : cell === 'lost' ? Infinity : Number(cell);
const in_text = cell => cell.includes('e') ? cell.replace(/^(.*)e([-+]\d+)$/, (all, a, b) => `$${a} \\cdot 10^{${Number(b)}}$`) : cell;
const table = (head, rows) => [head, head.map((name, i) => i < 2 ? '---' : '---:'), ...rows].map(row => `| ${row.join(' | ')} |`).join('\n');
const ratio = x => x < 0.995 ? x.toPrecision(2) : x < 9.95 ? x.toPrecision(2) : x.toFixed(0);
// The name of a scene is written where it begins.
const named = rows => rows.map((row, i) => i && rows[i - 1][0] === row[0] ? ['', ...row.slice(1)] : row);
const length = x => ({0.1: '10 cm', 0.01: '1 cm', 0.001: '1 mm', 1e-4: '0.1 mm', 1e-6: '1 µm', 1e-8: '10 nm'})[x];
const setting = row => [row.method.replace('its own', '') + (row.rounds && ' ' + row.rounds), row.substeps].map(one => one.trim()).filter(Boolean).join(', ');

// All that a text says of the rows. \param titles  of the scenes, by their names
export function tables_of(rows, titles, {peer, equal, spoken}) {
    const scenes = [...new Set(rows.map(row => row.scene))], title = name => titles.get(name) || name;
    const errors_of = name => Object.keys(kinds).filter(what => rows.find(row => row.scene === name)[what + '_m'] !== '');
    const find = (scene, who, more) => rows.find(row => row.scene === scene && row.who === who && Object.entries(more).every(([key, one]) => row[key] === one));
    const ratio_of = (a, b) => a && b && a.us_step && b.us_step ? ratio(Number(a.us_step) / Number(b.us_step)) : '';
    const pair = (a, b, what) => [a ? in_text(a[what]) : '', b ? in_text(b[what]) : '', a ? a.us_step : '', b ? b.us_step : '', ratio_of(a, b)];
    const head = ['book [m]', `${peer} [m]`, 'book [µs]', `${peer} [µs]`, 'ratio'];

    const by_default = [], at_equal = [], at_error = [], behind = [], ahead = [], alone = [];
    for (const scene of scenes) for (const what of errors_of(scene)) {
        const kind = kinds[what];
        by_default.push([title(scene), kind, ...pair(find(scene, 'book', {sleep: 'yes'}), find(scene, peer, {sleep: 'yes'}), what + '_m')]);
        for (const [i, [, ours, theirs]] of equal.entries()) for (const substeps of ['1', '4', '16']) {
            const a = find(scene, 'book', {sleep: 'no', substeps, ...ours}), b = find(scene, peer, {sleep: 'no', substeps, ...theirs});
            if (a) (at_equal[i] ||= []).push([title(scene), `${kind}, ${substeps}`, ...pair(a, b, what + '_m')]);
        }
        // Of settings whose times differ by less than 5 %, which is by chance, that with the least error.
        const cheapest = (who, level) => {
            const good = rows.filter(row => row.scene === scene && row.who === who && row.sleep === 'no' && value(row[what + '_m']) <= level && row.us_step !== '');
            const least = Math.min(...good.map(row => Number(row.us_step)));
            return good.filter(row => Number(row.us_step) <= 1.05 * least).sort((a, b) => value(a[what + '_m']) - value(b[what + '_m']))[0];
        };
        let last, lonely = false;
        for (const level of [0.1, 0.01, 1e-3, 1e-4, 1e-6, 1e-8]) {
            const a = cheapest('book', level), b = cheapest(peer, level);
            if (!a && !b) break;
            const row = [title(scene), `${kind} at most ${length(level)}`, a ? setting(a) : 'never', b ? setting(b) : 'never', a ? a.us_step : '', b ? b.us_step : '', ratio_of(a, b)];
            // The same settings reach the tighter bound too: its line says it all.
            if (last && last.a === a && last.b === b) at_error.pop(), last.list.pop();
            const list = !b ? [] : !a || Number(a.us_step) > Number(b.us_step) ? behind : ahead;
            list.push(`${title(scene)}, ${row[1]} (${row[6] || 'never'})`);
            if (!b && !lonely) alone.push(`${title(scene)}, ${row[1]}`);
            lonely = lonely || !b;
            at_error.push(row);
            last = {a, b, list};
        }
    }
    const sentence = list => list.length ? list.join('; ') : 'nowhere';
    return [
        `**At equal error the book takes longer** than ${peer} (in brackets: how many times as long): ${sentence(behind)}.`,
        `**It takes less time**: ${sentence(ahead)}.`,
        `**${peer} gets there with none of its settings**, the book does: ${sentence(alone)}.`,
        `**At equal error, without sleep.** The fastest setting of each whose error is at most that; times in microseconds a step. ${spoken} Ratio: our time to theirs.`,
        table(['scene', 'error', 'book', peer, 'book [µs]', `${peer} [µs]`, 'ratio'], named(at_error)),
        '**As they come, sleep on:**',
        table(['scene', 'error', ...head], named(by_default)),
        ...equal.flatMap(([caption], i) => [`**At equal sub-steps, sleep off**, ${caption}:`, table(['scene', 'error, sub-steps', ...head], named(at_equal[i] || []))]),
    ].join('\n\n') + '\n';
}
