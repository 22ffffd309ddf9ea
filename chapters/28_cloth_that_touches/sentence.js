// A particle of 1 kg on a ball, for the sentence that can be dragged: one step of 0.1 s, normal and disc.
'use strict';

(function () {
    const inside = 90, slid = 30;  // [mm]: 10 mm above at 1 m/s; 0.3 m/s across
    function step({mass, mu}) {  // (28.1)
        const A = 1 + 1 / mass, push = inside / A, holds = slid / A, slide = Math.min(mu * push, holds);
        return {push, holds, slide, down: inside - push, back: slide, along: slide / mass};
    }

    rigid_sentence('particle_on_ball', {
        values: setting => {
            const {down, back, along} = step(setting);
            return {down, back, along};
        },
        picture: setting => {
            const {push, holds, slide} = step(setting), far = 100;
            return {
                view: [-55, -8, 55, 100],
                marks: [{path: [[-55, 0], [55, 0]], colour: 'faint', width: 1}, {path: [[0, 0], [0, 100]], colour: 'faint', width: 1},
                        {path: [[-setting.mu * far, far], [0, 0], [setting.mu * far, far]], colour: 'blue'},
                        {dot: [-holds, push], colour: 'green', size: 4}, {dot: [-slide, push], colour: 'red', size: 5},
                        {words: 'along the normal', at: [2, 94], anchor: 'start'}, {words: 'across', at: [53, 4], anchor: 'end'},
                        {words: 'would hold it', at: [-holds + 2, push - 7], anchor: 'start', colour: 'green'}]
            };
        }
    });
})();
