// The steps of small.cpp, for the sentence that can be dragged: a link that is 10 mm too long.
'use strict';

(function () {
    // (7.4) and (7.5): the row makes J u = -beta C / h, and the step moves by h J u.
    function errors(beta) {
        const h = 1 / 60, found = [10];
        for (let n = 0; n < 20; ++n) found.push(found[n] + h * (-beta * found[n] / h));
        return found;
    }

    rigid_sentence('link', {
        values({beta}) {
            const found = errors(beta), says = beta < 1e-9 ? 'stays' : beta <= 1 ? 'shrinks evenly' : beta < 2 - 1e-9 ? 'swings about zero and dies out' : beta < 2 + 1e-9 ? 'swings forever' : 'grows';
            return {after4: found[4], after20: found[20], says};
        },
        picture: ({beta}) => ({
            view: [-0.6, -13, 21, 13],
            marks: [{path: [[-1, 0], [22, 0]], colour: 'faint', width: 1},
                    {path: errors(beta).map((C, n) => [n, C]), colour: beta < 2 ? 'blue' : 'red'},
                    ...errors(beta).map((C, n) => ({dot: [n, C], colour: beta < 2 ? 'blue' : 'red', size: 3})),
                    {words: '10 mm', at: [0.4, 11], anchor: 'start'}, {words: 'step 20', at: [20.6, -1.8], anchor: 'end'}]
        })
    });
})();
