// The steps of small.cpp, for the sentence that can be dragged: two discs in a column, and gravity that changes.
'use strict';

(function () {
    // One step of two discs of 1 kg and 10 cm, upwards alone; rows: the pair, then the floor. 'from' are the impulses at the
    // start. (7.4), (3.30), (6.2) to (6.5); the residual of each sweep is kept.
    function step(column, g, from) {
        const h = 1 / 60, u = column.u.map(v => v - g * h), lambda = [...from], offs = [];
        const C = [column.x[1] - column.x[0] - 0.2, column.x[0] - 0.1];
        const bias = C.map(gap => (gap < 0 ? 0.2 : 1) * gap / h);
        const push = (i, P) => {
            if (i === 0) { u[0] -= P; u[1] += P; } else u[0] += P;
        };
        from.forEach((P, i) => push(i, P));
        for (let off = 1; off > 1e-6 && offs.length < 100000; offs.push(off)) {
            off = 0;
            for (const i of [0, 1]) {
                const w = bias[i] + (i === 0 ? u[1] - u[0] : u[0]), A = i === 0 ? 2 : 1;
                const change = Math.max(0, lambda[i] - w / A) - lambda[i];
                lambda[i] += change;
                push(i, change);
                off = Math.max(off, A * Math.abs(change));
            }
        }
        return {column: {x: column.x.map((x, k) => x + h * u[k]), u}, lambda, offs};
    }
    function sweeps(percent) {
        const rest = {x: [0.1, 0.3], u: [0, 0]}, g = 9.81 * (1 + percent / 100);
        const one = step(rest, 9.81, [0, 0]), two = step(one.column, 9.81, one.lambda);
        return {cold: step(two.column, g, [0, 0]).offs, warm: step(two.column, g, two.lambda).offs};
    }

    rigid_sentence('two_discs', {
        values({percent}) {
            const {cold, warm} = sweeps(percent);
            return {cold: cold.length, warm: warm.length};
        },
        picture({percent}) {
            const {cold, warm} = sweeps(percent), high = off => Math.log10(Math.max(off, 1e-9));
            const curve = (offs, colour) => [{path: offs.map((off, k) => [k + 1, high(off)]), colour},
                                             ...offs.map((off, k) => ({dot: [k + 1, high(off)], colour, size: 3}))];
            return {
                view: [-1, -7.6, 23, 0.5],
                marks: [{path: [[-2, -6], [24, -6]], colour: 'faint', dash: true, width: 1}, ...curve(cold, 'red'), ...curve(warm, 'blue'),
                        {words: 'good enough: 10⁻⁶ m/s', at: [-0.6, -5.8], anchor: 'start'}, {words: 'from zero', at: [13, -2.6], anchor: 'start', colour: 'red'},
                        {words: 'sweep 20', at: [20, -7.4]}]
            };
        }
    });
})();
