// Euler's equations for the book of section 20.1, for the sentence that can be dragged: when does it turn over?
'use strict';

(function () {
    // 0.7 kg, 16 x 24 x 4 cm: about its axes one, two and three.
    const I = [[0.24, 0.04], [0.16, 0.04], [0.16, 0.24]].map(([b, c]) => 0.7 / 12 * (b * b + c * c));
    const rate = w => [0, 1, 2].map(i => (I[(i + 1) % 3] - I[(i + 2) % 3]) * w[(i + 1) % 3] * w[(i + 2) % 3] / I[i]);

    // By the classic Runge-Kutta method of chapter 1 in depth; the spin is 1 rad/s about one axis, the wobble about the two others.
    function run(axis, wobble) {
        const h = 0.01, path = [];
        let w = [wobble, wobble, wobble], over = 0;
        w[axis] = 1;
        for (let n = 0; n <= 2000; ++n) {
            path.push([n * h / (2 * Math.PI), w[axis]]);
            const plus = (a, s, k) => a.map((one, i) => one + s * k[i]);
            const k1 = rate(w), k2 = rate(plus(w, h / 2, k1)), k3 = rate(plus(w, h / 2, k2)), k4 = rate(plus(w, h, k3));
            const next = w.map((one, i) => one + h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]));
            if (!over && w[axis] > 0 && next[axis] <= 0) over = (n + w[axis] / (w[axis] - next[axis])) * h / (2 * Math.PI);
            w = next;
        }
        return {path, over};
    }

    rigid_sentence('book', {
        values: ({wobble}) => ({turns: run(0, wobble / 100).over}),
        picture: ({wobble}) => ({
            view: [-0.1, -1.35, 3.2, 1.5],
            marks: [{path: [[-1, 0], [4, 0]], colour: 'faint', width: 1},
                    {path: run(2, wobble / 100).path, colour: 'faint', dash: true}, {path: run(0, wobble / 100).path, colour: 'red'},
                    {dot: [run(0, wobble / 100).over, 0], colour: 'red', size: 5},
                    {words: 'spin about the third axis', at: [3.1, 1.2], anchor: 'end'}, {words: 'about the first, the middle one', at: [3.1, -1.25], anchor: 'end', colour: 'red'},
                    {words: 'three turns →', at: [3.1, 0.1], anchor: 'end'}]
        })
    });
})();
