// The walk of small.cpp, for the sentence that can be dragged: Lemke's algorithm on two contacts.
'use strict';

(function () {
    const A = [[2, 1], [1, 2]];

    // Algorithm 5.1 on the tableau of q = w - A z - d z0; column 0 is q, then come w, z and z0.
    function walk(q) {
        const T = [[q[0], 1, 0, -A[0][0], -A[0][1], -1], [q[1], 0, 1, -A[1][0], -A[1][1], -1]];
        const basic = [1, 2], steps = [];
        for (let c = 5; c > 0 && steps.length < 10;) {
            let row = -1;
            for (const i of [0, 1]) {
                if (c === 5 ? T[i][0] >= 0 : T[i][c] < 1e-10) continue;
                const less = (a, b) => {  // (5.10), and (5.13) where two are equal
                    for (let k = 0; k < 3; ++k) {
                        const d = T[a][k] / Math.abs(T[a][c]) - T[b][k] / Math.abs(T[b][c]);
                        if (d !== 0) return d < 0;
                    }
                    return false;
                };
                if (row < 0 || less(i, row)) row = i;
            }
            if (row < 0) break;
            const leaves = basic[row], other = 1 - row, pivot = T[row][c], factor = T[other][c];
            T[row] = T[row].map(t => t / pivot);  // (5.8)
            T[other] = T[other].map((t, k) => t - factor * T[row][k]);
            basic[row] = c;
            c = leaves === 5 ? 0 : leaves + (leaves <= 2 ? 2 : -2);  // (5.9)
            const z = [0, 0, 0];
            basic.forEach((one, i) => { if (one > 2) z[one - 3] = T[i][0]; });
            steps.push(z);
        }
        return steps;
    }

    rigid_sentence('cones', {
        values({q1, q2}) {
            const steps = walk([q1, q2]), [z1, z2] = steps.length ? steps[steps.length - 1] : [0, 0];
            return {pivots: steps.length, z1, z2, cone: (z1 > 0 ? 'z₁' : 'w₁') + ' ' + (z2 > 0 ? 'z₂' : 'w₂')};
        },
        picture({q1, q2}) {
            const out = 40, steps = walk([q1, q2]);
            const borders = [[1, 0], [0, 1], [-2, -1], [-1, -2]].map(([x, y]) => ({path: [[0, 0], [out * x, out * y]], colour: 'faint', width: 1.5}));
            const lift = steps.length ? Math.max(-q1, -q2, 0) : 0;
            return {
                view: [-13, -9, 13, 9], equal: true,
                marks: [...borders, {path: [[q1 + lift + 20, q2 + lift + 20], [q1, q2]], colour: 'red', dash: true},
                        ...steps.map(z => ({dot: [q1 + z[2], q2 + z[2]], colour: 'red', size: 4})), {dot: [q1, q2], colour: 'orange', size: 6},
                        {words: 'w₁ w₂', at: [7, 5]}, {words: 'z₁ w₂', at: [-8, 3]}, {words: 'w₁ z₂', at: [4, -7]}, {words: 'z₁ z₂', at: [-9, -8]},
                        {words: 'q', at: [q1 + 0.9, q2 - 1], colour: 'orange'}]
            };
        }
    });
})();
