// The visits of small.cpp, for the sentence that can be dragged: two discs in a column, each visit on their velocities.
'use strict';

(function () {
    // (6.2) to (6.5), row 1 the floor, row 2 the contact of the discs, of 1 kg and of 'mass' kg.
    function path(mass, visits) {
        const u = [-1, -1], lambda = [0, 0], corners = [[-1, -1]];
        for (let k = 0; k < visits; ++k) {
            const i = k % 2, w = i === 0 ? u[0] : u[1] - u[0], A = i === 0 ? 1 : 1 + 1 / mass;
            const change = Math.max(0, lambda[i] - w / A) - lambda[i];
            lambda[i] += change;
            if (i === 0) u[0] += change;
            else {
                u[0] -= change;
                u[1] += change / mass;
            }
            corners.push([...u]);
        }
        return corners;
    }

    rigid_sentence('visits', {
        values({mass, visits}) {
            const corners = path(mass, visits), [lower, upper] = corners[visits];
            return {lower, upper};
        },
        picture: ({mass, visits}) => ({
            view: [-1.75, -1.12, 0.75, 0.16], equal: true,
            marks: [{path: [[-3, -3], [1, 1]], colour: 'blue'}, {path: [[0, -3], [0, 1]], colour: 'blue'},
                    {path: path(mass, visits), colour: 'red'}, {dot: path(mass, visits)[visits], colour: 'red'},
                    {words: 'u₁ = 0', at: [0.06, -1.0], anchor: 'start', colour: 'blue'},
                    {words: 'u₁ = u₂', at: [-0.72, -0.6], anchor: 'end', colour: 'blue'},
                    {words: 'u₁ →, u₂ ↑', at: [-1.4, 0]}]
        })
    });
})();
