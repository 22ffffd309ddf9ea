// Three masses on a string, for the sentence that can be dragged: the middle one is plucked by 1 m, forty steps of leapfrog.
'use strict';

(function () {
    // (29.4), velocities half a step before the places
    function run(h) {
        let y = [0, 1, 0], v = [0, 0, 0], farthest = 1;
        const middle = [1];
        const push = part => v = v.map((u, i) => u + part * (((y[i - 1] ?? 0) - y[i]) + ((y[i + 1] ?? 0) - y[i])));
        push(-h / 2);
        for (let n = 0; n < 40; ++n) {
            push(h);
            y = y.map((place, i) => place + h * v[i]);
            farthest = Math.max(farthest, ...y.map(Math.abs));
            middle.push(y[1]);
        }
        return {farthest, middle};
    }

    rigid_sentence('three_masses', {
        values: ({h}) => ({farthest: run(h).farthest}),
        picture: ({h}) => ({
            view: [-1, -2.2, 41, 2.2],
            marks: [{path: [[-1, 0], [41, 0]], colour: 'faint', width: 1},
                    {path: run(h).middle.map((y, n) => [n, y]), colour: 'blue'},
                    ...run(h).middle.map((y, n) => ({dot: [n, y], colour: 'blue', size: 3})),
                    {words: 'the middle mass', at: [40, 1.8], anchor: 'end', colour: 'blue'}, {words: 'step 40', at: [40, -2], anchor: 'end'}]
        })
    });
})();
