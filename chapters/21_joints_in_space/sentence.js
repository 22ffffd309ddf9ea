// The hinge of section 21.1, for the sentence that can be dragged: its two rows turn about y and z turned back by half the twist.
'use strict';

rigid_sentence('hinge', {
    values: ({angle}) => ({lean: angle / 2}),
    picture: ({angle}) => {
        const turn = angle * Math.PI / 180, half = turn / 2, ray = a => [Math.cos(a), Math.sin(a)];
        const across = ray(half + Math.PI / 2);
        return {
            view: [-1.2, -0.5, 1.6, 1.3],
            marks: [{path: [[-1.1, 0], [0, 0]], colour: 'faint', width: 4}, {path: [[0, 0], ray(0)], colour: 'faint', dash: true},
                    {path: [[0, 0], ray(turn)], colour: 'blue', width: 4}, {path: [[0, 0], ray(half).map(x => 0.7 * x)], colour: 'red', width: 2},
                    {path: [[0, 0], across.map(x => 0.7 * x)], colour: 'red', width: 2},
                    {words: 'closed', at: [1, -0.12], anchor: 'end'}, {words: 'wall', at: [-1.1, -0.15]}]
        };
    }
});
