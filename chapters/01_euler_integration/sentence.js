// The step of small.cpp, for the sentence that can be dragged: twelve steps of a mass on a spring, omega = 1 rad/s.
'use strict';

(function () {
    // (1.5), (1.10), (1.14)
    const steps = {
        explicit: ([x, u], h) => [x + h * u, u - h * x],
        symplectic: ([x, u], h) => { u -= h * x; return [x + h * u, u]; },
        implicit: ([x, u], h) => { u = (u - h * x) / (1 + h * h); return [x + h * u, u]; }
    };
    function path(step, h) {
        const states = [[1, 0]];
        for (let n = 0; n < 12; ++n) states.push(step(states[n], h));
        return states;
    }
    const energy = ([x, u]) => 0.5 * u * u + 0.5 * x * x;  // (1.7)

    rigid_sentence('spring', {
        values: ({h}) => Object.fromEntries(Object.entries(steps).map(([name, step]) => [name, energy(path(step, h)[12]) / 0.5])),
        picture: ({h}) => ({
            view: [-3.4, -2.1, 3.4, 2.1], equal: true,
            marks: [{circle: [0, 0, 1], colour: 'faint', dash: true, width: 1.5},
                    ...[['explicit', 'red'], ['implicit', 'green'], ['symplectic', 'blue']].flatMap(([name, colour]) => {
                        const states = path(steps[name], h);
                        return [{path: states, colour}, ...states.map(dot => ({dot, colour, size: 3}))];
                    }),
                    {words: 'position →', at: [2.6, -2]}, {words: 'velocity ↑', at: [-2.6, 1.8]}]
        })
    });
})();
