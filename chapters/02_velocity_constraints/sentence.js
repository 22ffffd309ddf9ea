// The step of small.cpp, for the sentence that can be dragged: a bead of 1 kg on a spring in place of its wire.
'use strict';

(function () {
    // (2.1) and (1.10): where the bead has been, 1000 steps of 0.01 s.
    function run(stiffness) {
        const h = 0.01, path = [[1, 0]];
        let x = 1, y = 0, u = 0, v = 1, farthest = 0;
        for (let n = 0; n < 1000; ++n) {
            const r = Math.sqrt(x * x + y * y), C = 0.5 * (x * x + y * y - 1), push = h * stiffness * C / r;
            u -= push * (x / r);
            v -= push * (y / r);
            x += h * u;
            y += h * v;
            farthest = Math.max(farthest, Math.abs(Math.sqrt(x * x + y * y) - 1));
            path.push([x, y]);
        }
        return {path, farthest};
    }

    rigid_sentence('stiff_spring', {
        values({k}) {
            const off = run(1000 * k).farthest;
            return {distance: off < 1 ? 1000 * off : off < 1000 ? off : off / 1000, unit: off < 1 ? 'mm' : off < 1000 ? 'm' : 'km'};
        },
        picture: ({k}) => ({
            view: [-2.2, -1.4, 2.2, 1.4], equal: true,
            marks: [{circle: [0, 0, 1], colour: 'faint', width: 4},
                    {path: run(1000 * k).path.slice(0, 640), colour: k < 40 ? 'blue' : 'red', width: 1.5}]
        })
    });
})();
