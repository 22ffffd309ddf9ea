// One mass of 1 kg on a spring, for the sentence that can be dragged: the force where it is, and where it will be.
'use strict';

(function () {
    const h = 1 / 60;
    function path(hertz, zeta, implicit) {
        const omega = 2 * Math.PI * hertz, found = [0.01];
        let x = 0.01, v = 0;
        for (let n = 0; n < 10; ++n) {
            v = implicit ? (v - h * omega * omega * x) / (1 + 2 * zeta * h * omega + h * h * omega * omega)  // (16.4)
                         : v - h * (omega * omega * x + 2 * zeta * omega * v);                                 // (16.1)
            x += h * v;
            found.push(x);
        }
        return found;
    }

    rigid_sentence('oscillator', {
        values: ({hertz, zeta}) => ({explicit: 1000 * path(hertz, zeta, false)[1], implicit: 1000 * path(hertz, zeta, true)[1],
                                     explicit10: 1000 * path(hertz, zeta, false)[10], implicit10: 1000 * path(hertz, zeta, true)[10]}),
        picture: ({hertz, zeta}) => ({
            view: [-0.4, -32, 10.4, 32],
            marks: [{path: [[-1, 0], [12, 0]], colour: 'faint', width: 1},
                    ...[[false, 'red'], [true, 'blue']].flatMap(([implicit, colour]) => {
                        const points = path(hertz, zeta, implicit).map((x, n) => [n, 1000 * x]);
                        return [{path: points, colour}, ...points.map(dot => ({dot, colour, size: 3}))];
                    }),
                    {words: 'at the start of the step', at: [10.2, 27], anchor: 'end', colour: 'red'}, {words: 'at its end', at: [10.2, 21], anchor: 'end', colour: 'blue'},
                    {words: '10 mm', at: [0.3, 13], anchor: 'start'}, {words: 'step 10', at: [10.2, -30], anchor: 'end'}]
        })
    });
})();
