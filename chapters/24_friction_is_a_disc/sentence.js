// The hoop of section 24.1, for the sentence that can be dragged: one visit, with A = diag(2, 3), L = 3, μ λ_n = ½.
'use strict';

rigid_sentence('hoop', (() => {
    const w = across => [1.8, across], onto = p => {
        const length = Math.hypot(...p);
        return length > 0.5 ? p.map(x => x * 0.5 / length) : p;
    };
    const visit = across => {
        const stop = [-w(across)[0] / 2, -w(across)[1] / 3];
        const step = Math.hypot(...stop) > 0.5 ? w(across).map(x => -x / 3) : stop;
        return {step, end: onto(step)};
    };
    return {
        values: ({across}) => ({along: -visit(across).end[0], aside: -visit(across).end[1]}),
        picture: ({across}) => {
            const {step, end} = visit(across), rim = [...Array(49).keys()].map(i => [0.5 * Math.cos(i * Math.PI / 24), 0.5 * Math.sin(i * Math.PI / 24)]);
            return {
                view: [-1.4, -1.5, 0.9, 0.7],
                marks: [{path: rim, colour: 'faint', width: 2}, {path: [[0, 0], step], colour: 'blue', width: 2},
                        {path: [step, end], colour: 'red', width: 3}]
            };
        }
    };
})());
