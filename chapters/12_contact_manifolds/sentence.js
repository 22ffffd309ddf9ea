// What small.cpp does by hand, for the sentence that can be dragged: a box of 3 kg over the end of a fixed one.
'use strict';

(function () {
    // Both points of the contact: the ends of what the two faces share. g h = 1 m/s, no turning and no falling; where the
    // left point would have to pull, the right one is alone and the box tips.
    function bears(x) {
        const left = x - 1, right = Math.min(x + 1, 2), weight = 3;
        if (x > 2) return {left: 0, right: 1 / (1 / 3 + 0.8 * (x - 2) * (x - 2)), at: [left, right]};
        return {left: weight * (right - x) / (right - left), right: weight * (x - left) / (right - left), at: [left, right]};
    }

    rigid_sentence('across', {
        values({x}) {
            const {left, right} = bears(x);
            return {left, right, says: x < 2 ? 'rests' : x > 2 ? 'tips over the end' : 'rests on the edge alone'};
        },
        picture({x}) {
            const {left, right, at} = bears(x), size = 0.45;
            return {
                view: [-1.6, -0.6, 4.4, 3.1], equal: true,
                marks: [{path: [[-9, 1], [2, 1], [2, -9], [-9, -9]], fill: 0.15, colour: 'faint', close: true},
                        {path: [[x - 1, 1], [x + 1, 1], [x + 1, 2], [x - 1, 2]], fill: 0.15, colour: 'blue', close: true},
                        {dot: [x, 1.5]}, {arrow: [[at[0], 1], [at[0], 1 + size * left]], colour: 'red', width: 3},
                        {arrow: [[at[1], 1], [at[1], 1 + size * right]], colour: 'red', width: 3},
                        ...at.map(one => ({dot: [one, 1], colour: 'red', size: 5}))]
            };
        }
    });
})();
