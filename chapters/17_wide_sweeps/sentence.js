// The longest chain of visits, for the sentence that can be dragged: bodies in a line, by hand as in section 17.1.
'use strict';

(function () {
    // (17.1): row i joins bodies i and i + 1.
    function depths(bodies, order) {
        const written = Array(bodies).fill(0), found = [];
        for (const i of order) written[i] = written[i + 1] = found[i] = 1 + Math.max(written[i], written[i + 1]);
        return found;
    }
    const in_turn = bodies => [...Array(bodies - 1).keys()];
    const by_colour = bodies => [...in_turn(bodies).filter(i => i % 2 === 0), ...in_turn(bodies).filter(i => i % 2 === 1)];

    rigid_sentence('line', {
        values: ({bodies}) => ({rows: bodies - 1, chain: Math.max(...depths(bodies, in_turn(bodies))), coloured: Math.max(...depths(bodies, by_colour(bodies)))}),
        picture({bodies}) {
            const shade = ['blue', 'orange'], line = (order, y) => depths(bodies, order).flatMap((depth, i) =>
                [{path: [[i, y], [i + 1, y]], colour: order === by ? shade[i % 2] : 'faint', width: 4},
                 ...(bodies <= 14 ? [{words: String(depth), at: [i + 0.5, y + 0.25]}] : [])]);
            const by = by_colour(bodies), turn = in_turn(bodies);
            return {
                view: [-0.6, -0.4, bodies - 0.4, 3.2],
                marks: [...line(turn, 2), ...line(by, 0.4), ...turn.concat(bodies - 1).flatMap(i => [{dot: [i, 2], size: 5}, {dot: [i, 0.4], size: 5}]),
                        {words: 'one after the other', at: [(bodies - 1) / 2, 2.75]}, {words: 'colour after colour', at: [(bodies - 1) / 2, 1.15]}]
            };
        }
    });
})();
