// A triangle that is turned and not stretched, and what the linear law makes of it (30.11), for the sentence that can be dragged.
'use strict';

(function () {
    const corners = [[0, 0], [1, 0], [0, 1]];
    const closed = points => [...points, points[0]];

    rigid_sentence('turned', {
        // λ = μ = 1 Pa and half a square metre: A (μ ε:ε + ½ λ tr² ε) = 2 (cos θ − 1)²
        values: ({angle}) => {
            const strain = Math.cos(angle * Math.PI / 180) - 1;
            return {strain, energy: 2 * strain * strain};
        },
        picture: ({angle}) => {
            const c = Math.cos(angle * Math.PI / 180), s = Math.sin(angle * Math.PI / 180);
            const turned = corners.map(([x, y]) => [c * x - s * y, s * x + c * y]);
            return {
                view: [-1.3, -0.35, 1.5, 1.5],
                marks: [{path: closed(corners), colour: 'faint', width: 1},
                        {path: closed(turned), colour: 'blue'},
                        {path: closed(corners.map(([x, y]) => [c * x, c * y])), colour: 'red'},
                        {words: 'as it is turned', at: [1.45, 1.3], anchor: 'end', colour: 'blue'},
                        {words: 'as the linear law sees it: cos θ times as large', at: [1.45, 1.12], anchor: 'end', colour: 'red'}]
            };
        }
    });
})();
