// What small.cpp does by hand, for the sentence that can be dragged: a rod of 1 kg and 1 m that is struck at its end.
'use strict';

(function () {
    // (11.8): the end, half a metre from the middle, comes at 1 m/s and leaves at e.
    function struck(degrees, e) {
        const angle = degrees * Math.PI / 180, arm = -0.5 * Math.cos(angle), inverse_inertia = 12;
        const lambda = (1 + e) / (1 + arm * arm * inverse_inertia);
        return {lambda, v: -1 + lambda, omega: inverse_inertia * arm * lambda};
    }

    rigid_sentence('rod', {
        values: ({angle, e}) => struck(angle, e),
        picture({angle, e}) {
            const {v, omega} = struck(angle, e), c = Math.cos(angle * Math.PI / 180), s = Math.sin(angle * Math.PI / 180);
            const at = [...Array(9)].map((_, i) => [(i / 8 - 0.5) * c, (i / 8 - 0.5) * s + 0.5 * s]), size = 0.25;
            return {
                view: [-1, -0.55, 1, 1.1], equal: true,
                marks: [{path: [[-2, 0], [2, 0]], colour: 'faint', width: 3}, {path: [at[0], at[8]], width: 5},
                        ...at.map(([x, y]) => ({arrow: [[x, y], [x, y - size]], colour: 'faint', width: 1})),
                        ...at.map(([x, y]) => ({arrow: [[x, y], [x - size * omega * (y - 0.5 * s), y + size * (v + omega * x)]], colour: 'blue'})),
                        {words: 'before', at: [0.72, 0.95]}, {words: 'after', at: [0.72, 0.82], colour: 'blue'}]
            };
        }
    });
})();
