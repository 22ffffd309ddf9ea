// The sweeps of small.cpp, for the sentence that can be dragged: two discs in a column, the upper one of another mass.
'use strict';

(function () {
    // (4.4), from zero, for (4.2) with the upper disc's mass: the corners of the path.
    function path(mass, sweeps) {
        const A = [[1, -1], [-1, 1 + 1 / mass]], q = [-1, 0], lambda = [0, 0], corners = [[0, 0]];
        for (let sweep = 0; sweep < sweeps; ++sweep)
            for (const i of [0, 1]) {
                const w = A[i][0] * lambda[0] + A[i][1] * lambda[1] + q[i];
                lambda[i] = Math.max(0, lambda[i] - w / A[i][i]);
                corners.push([...lambda]);
            }
        return corners;
    }

    rigid_sentence('column', {
        values({mass, sweeps}) {
            const corners = path(mass, sweeps), [first, second] = corners[corners.length - 1];
            return {first, second, missing: 100 * (1 - first / (1 + mass))};
        },
        picture({mass, sweeps}) {
            const to = 1 + mass;
            return {
                view: [-0.08 * to, -0.12 * mass, 1.15 * to, 1.2 * mass],
                marks: [{path: [[1, 0], [1 + 2 * mass, 2 * mass]], colour: 'blue'},
                        {path: [[0, 0], [2 * to, 2 * mass]], colour: 'blue'},
                        {path: path(mass, sweeps), colour: 'red'},
                        {dot: [to, mass], colour: 'blue', size: 5},
                        {words: 'λ₁ →', at: [1.05 * to, -0.08 * mass]}, {words: 'λ₂ ↑', at: [0.02 * to, 1.1 * mass]}]
            };
        }
    });
})();
