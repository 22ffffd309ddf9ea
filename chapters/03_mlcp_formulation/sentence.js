// What small.cpp does by hand, for the sentence that can be dragged: a disc of 1 kg in a corner, by all four sets of cases.
'use strict';

(function () {
    const J = [[0, 1], [0.6, 0.8]];
    const A = J.map(a => J.map(b => a[0] * b[0] + a[1] * b[1]));

    // (3.14b) for each set of rows at work; the one whose residual (3.15) is zero fits.
    function answer(x, y) {
        const q = J.map(row => row[0] * x + row[1] * y), tried = [];
        for (const at_work of [[0, 0], [1, 0], [0, 1], [1, 1]]) {
            const [a, b] = at_work[0] ? A[0] : [1, 0], [c, d] = at_work[1] ? A[1] : [0, 1];
            const [r, s] = q.map((one, i) => at_work[i] ? -one : 0), det = a * d - b * c;
            const lambda = [(d * r - b * s) / det, (a * s - c * r) / det];
            const w = A.map((row, i) => row[0] * lambda[0] + row[1] * lambda[1] + q[i]);
            const residual = Math.max(...w.map((one, i) => Math.abs(Math.min(one, A[i][i] * lambda[i]))));
            const u = [x + 0.6 * lambda[1], y + lambda[0] + 0.8 * lambda[1]];
            tried.push({lambda, u, fits: residual <= 1e-9});
        }
        return tried;
    }

    rigid_sentence('corner', {
        values({x, y}) {
            const {lambda, u} = answer(x, y).find(one => one.fits);
            return {floor: lambda[0], ramp: lambda[1], x: u[0], y: u[1]};
        },
        picture: ({x, y}) => ({
            view: [-4.2, -3.2, 4.2, 2.2], equal: true,
            marks: [{path: [[9, 0], [0, 0], [-8, 6], [9, 6]], fill: 0.12, width: 0, colour: 'blue', close: true},
                    {path: [[9, 0], [0, 0], [-8, 6]], colour: 'blue'},
                    ...answer(x, y).map(one => ({path: [[x, y], one.u], colour: one.fits ? 'red' : 'faint', width: one.fits ? 3 : 1, dash: !one.fits})),
                    {arrow: [[0, 0], [x, y]], colour: 'orange'},
                    {dot: answer(x, y).find(one => one.fits).u, colour: 'red'},
                    {words: 'allowed', at: [2.6, 1.2], colour: 'blue'}, {words: 'u*', at: [x * 0.5 + 0.35, y * 0.5 - 0.1], colour: 'orange'}]
        })
    });
})();
