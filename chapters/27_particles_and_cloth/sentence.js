// Two masses of 1 kg under a pin, on springs, for the sentence that can be dragged: one step of 0.1 s row by row and all together.
'use strict';

(function () {
    const h = 0.1, y = 0.1;  // 10 m/s² for a tenth of a second, without springs
    function rows(k, sweeps) {  // (27.11)
        const gamma = 1 / (h * h * k), z = [y, y], sum = [0, 0], path = [[...z]];
        for (let n = 0; n < sweeps; ++n) {
            let change = -(z[0] + gamma * sum[0]) / (1 + gamma);
            sum[0] += change, z[0] += change;
            path.push([...z]);
            change = -(z[1] - z[0] + gamma * sum[1]) / (2 + gamma);
            sum[1] += change, z[1] += change, z[0] -= change;
            path.push([...z]);
        }
        return path;
    }
    function together(k) {  // (27.4)
        const q = h * h * k, det = (1 + 2 * q) * (1 + q) - q * q;
        return [(1 + 2 * q) * y / det, (1 + 3 * q) * y / det];
    }

    rigid_sentence('masses', {
        values: ({k, sweeps}) => {
            const path = rows(k, sweeps), [first, second] = path[path.length - 1], [one, two] = together(k);
            return {first: 1000 * first, second: 1000 * second, one: 1000 * one, two: 1000 * two};
        },
        picture: ({k, sweeps}) => {
            const path = rows(k, sweeps).map(([a, b]) => [1000 * a, 1000 * b]), end = together(k).map(z => 1000 * z);
            return {
                view: [-8, -8, 112, 112],
                marks: [{path: [[0, 0], [110, 0]], colour: 'faint', width: 1}, {path: [[0, 0], [0, 110]], colour: 'faint', width: 1},
                        {path, colour: 'red'}, ...path.map(dot => ({dot, colour: 'red', size: 3})),
                        {dot: end, colour: 'blue', size: 5},
                        {words: 'first mass [mm]', at: [108, 4], anchor: 'end'}, {words: 'second', at: [3, 104], anchor: 'start'},
                        {words: 'all together', at: [106, 18], anchor: 'end', colour: 'blue'}, {words: 'row by row', at: [106, 28], anchor: 'end', colour: 'red'}]
            };
        }
    });
})();
