// The triangles of section 22.1, for the sentence that can be dragged: how far they are apart, by all corners and all sides.
'use strict';

rigid_sentence('triangles', (() => {
    const a = [[0, 0], [4, 4], [1, 3]], moved = up => [[5, 1 + up], [8, 2 + up], [5, 5 + up]];
    // the point of a side that is nearest to p
    const foot = (p, [q, r]) => {
        const way = [r[0] - q[0], r[1] - q[1]];
        const t = ((p[0] - q[0]) * way[0] + (p[1] - q[1]) * way[1]) / (way[0] ** 2 + way[1] ** 2);
        const part = Math.min(1, Math.max(0, t));
        return [q[0] + part * way[0], q[1] + part * way[1]];
    };
    const nearest = up => {
        const b = moved(up), side = (t, i) => [t[i], t[(i + 1) % 3]];
        let best = null;
        for (let i = 0; i < 3; ++i)
            for (let j = 0; j < 3; ++j)
                for (const [p, q] of [[a[i], foot(a[i], side(b, j))], [foot(b[j], side(a, i)), b[j]]]) {
                    const distance = Math.hypot(q[0] - p[0], q[1] - p[1]);
                    if (!best || distance < best.distance) best = {p, q, distance};
                }
        return best;
    };
    return {
        values: ({up}) => ({distance: nearest(up).distance}),
        picture: ({up}) => {
            const b = moved(up), {p, q} = nearest(up);
            return {
                view: [-1, -6, 9, 12],
                marks: [{path: [...a, a[0]], colour: 'blue', width: 2}, {path: [...b, b[0]], colour: 'orange', width: 2},
                        {path: [p, q], colour: 'red', width: 4}]
            };
        }
    };
})());
