// The guesses of small.cpp, for the sentence that can be dragged: a disc between two walls, (9.3).
'use strict';

(function () {
    const A = [[2, 1], [1, 2]];

    // (9.2): active rows have w = 0, the others lambda = 0.
    function impulses(q, active) {
        const det = A[0][0] * A[1][1] - A[0][1] * A[1][0];
        if (active[0] && active[1]) return [(A[0][1] * q[1] - A[1][1] * q[0]) / det, (A[1][0] * q[0] - A[0][0] * q[1]) / det];
        return [0, 1].map(i => active[i] ? -q[i] / A[i][i] : 0);
    }
    // (9.5): from "both are active", what is wrong is turned over.
    function guesses(q) {
        let active = [true, true];
        const tried = [];
        while (tried.length < 10) {
            const lambda = impulses(q, active), w = A.map((row, i) => row[0] * lambda[0] + row[1] * lambda[1] + q[i]);
            tried.push(lambda);
            const wrong = [0, 1].map(i => active[i] ? lambda[i] < -1e-12 : w[i] < -1e-12);
            if (!wrong[0] && !wrong[1]) break;
            active = active.map((one, i) => one !== wrong[i]);
        }
        return tried;
    }

    rigid_sentence('guess', {
        values({q2}) {
            const tried = guesses([-5, q2]), answer = tried[tried.length - 1];
            return {first1: tried[0][0], first2: tried[0][1], guesses: tried.length, answer1: answer[0], answer2: answer[1]};
        },
        picture: ({q2}) => ({
            view: [-2.2, -4, 8.2, 5], equal: true,
            marks: [{path: [[0, 9], [0, 0], [12, 0], [12, 9]], fill: 0.1, width: 0, colour: 'faint', close: true},
                    {path: [[-9, 0], [12, 0]], colour: 'faint', width: 1}, {path: [[0, -9], [0, 9]], colour: 'faint', width: 1},
                    {path: [[-4, 13], [7, -9]], colour: 'blue'}, {path: [[-20, (20 - q2) / 2], [20, (-20 - q2) / 2]], colour: 'blue'},
                    {path: guesses([-5, q2]), colour: 'red', width: 3}, ...guesses([-5, q2]).map(dot => ({dot, colour: 'red'})),
                    {words: 'λ₁ →', at: [7.4, -0.7]}, {words: 'λ₂ ↑', at: [-0.8, 4.3]}]
        })
    });
})();
