// The squares of section 23.1, for the sentence that can be dragged: the second is cut at the sides of the first.
'use strict';

rigid_sentence('squares', (() => {
    const square = right => [[0.5 + right, -0.75], [1.75 + right, 0.5], [0.5 + right, 1.75], [-0.75 + right, 0.5]];
    const sides = [[1, 0], [0, 1], [-1, 0], [0, -1]];  // outward, at the distance 1
    const cut = (polygon, m) => polygon.flatMap((c, i) => {
        const d = polygon[(i + 1) % polygon.length];
        const out_c = m[0] * c[0] + m[1] * c[1] - 1, out_d = m[0] * d[0] + m[1] * d[1] - 1;
        const kept = out_c <= 0 ? [c] : [];
        if ((out_c <= 0) === (out_d <= 0)) return kept;
        const part = out_c / (out_c - out_d);
        return [...kept, [c[0] + part * (d[0] - c[0]), c[1] + part * (d[1] - c[1])]];
    });
    const shared = right => sides.reduce(cut, square(right));
    return {
        values: ({right}) => {
            const p = shared(right);
            const twice = p.reduce((sum, c, i) => {
                const d = p[(i + 1) % p.length];
                return sum + c[0] * d[1] - c[1] * d[0];
            }, 0);
            return {area: twice / 2};
        },
        picture: ({right}) => {
            const closed = p => [...p, p[0]], p = shared(right);
            return {
                view: [-3, -1.5, 3.5, 2.2],
                marks: [{path: closed([[-1, -1], [1, -1], [1, 1], [-1, 1]]), colour: 'blue', width: 2},
                        {path: closed(square(right)), colour: 'orange', width: 2},
                        ...(p.length ? [{path: closed(p), colour: 'red', width: 4}] : [])]
            };
        }
    };
})());
