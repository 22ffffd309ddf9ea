// Of how many distances can a step need, for the sentence that can be dragged: (10.1), and Euler's formula for plane graphs.
'use strict';

(function () {
    const pairs = K => K * (K - 1) / 2;       // (10.1)
    const most = K => Math.min(pairs(K), 3 * K - 6);  // of equal discs, that touch: the edges of a plane graph

    rigid_sentence('pairs', {
        values: ({K}) => ({distances: pairs(K), touching: most(K), part: 100 * most(K) / pairs(K)}),
        picture({K}) {
            const log = Math.log10, along = [...Array(40)].map((_, i) => 10 * Math.pow(300, i / 39));
            return {
                view: [0.7, 0.6, 3.8, 7.4],
                marks: [{path: along.map(k => [log(k), log(pairs(k))]), colour: 'red'}, {path: along.map(k => [log(k), log(most(k))]), colour: 'blue'},
                        {path: [[log(K), 0], [log(K), 9]], colour: 'faint', dash: true, width: 1},
                        {dot: [log(K), log(pairs(K))], colour: 'red', size: 5}, {dot: [log(K), log(most(K))], colour: 'blue', size: 5},
                        {words: 'pairs', at: [1.7, 4.6], colour: 'red'}, {words: 'pairs that can touch', at: [2.2, 1.8], colour: 'blue', anchor: 'start'},
                        {words: '10', at: [1, 0.75]}, {words: '100', at: [2, 0.75]}, {words: '1000 discs', at: [3, 0.75]}]
            };
        }
    });
})();
