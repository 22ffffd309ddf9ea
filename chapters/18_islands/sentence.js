// The choice of section 18.1, for the sentence that can be dragged: a tower of boxes, each on two points with friction.
'use strict';

(function () {
    const rows = boxes => 4 * boxes;
    const by_sweeps = (boxes, ratio) => 8 * rows(boxes) * boxes * boxes * ratio;  // (18.1), (18.2)
    const exactly = boxes => {                                                    // (18.3); all rows have bounds
        const m = rows(boxes), k = boxes;
        return 250 * m * m / k + 3 * m * m * m / (k * Math.sqrt(k) + 2 * k);
    };

    rigid_sentence('tower', {
        values: ({boxes, ratio}) => ({sweeps: by_sweeps(boxes, ratio), exact: exactly(boxes), says: exactly(boxes) < by_sweeps(boxes, ratio) ? 'exactly' : 'by sweeps'}),
        picture({boxes, ratio}) {
            const log = Math.log10, along = [...Array(50).keys()].map(k => k + 1);
            return {
                view: [-2, 0.7, 53, 9.4],
                marks: [{path: along.map(k => [k, log(by_sweeps(k, ratio))]), colour: 'red'}, {path: along.map(k => [k, log(exactly(k))]), colour: 'blue'},
                        {dot: [boxes, log(by_sweeps(boxes, ratio))], colour: 'red', size: 5}, {dot: [boxes, log(exactly(boxes))], colour: 'blue', size: 5},
                        {words: 'entries, 10³ to 10⁹: by sweeps', at: [0, 8.8], anchor: 'start', colour: 'red'}, {words: 'exactly', at: [44, 4.6], colour: 'blue'},
                        {words: '50 boxes', at: [51, 0.9], anchor: 'end'}]
            };
        }
    });
})();
