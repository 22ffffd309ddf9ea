// What small.cpp does by hand, for the sentence that can be dragged: a block of 1 kg on a slope, g h = 1 m/s.
'use strict';

(function () {
    function step(degrees, mu) {
        const angle = degrees * Math.PI / 180, normal = Math.cos(angle);
        const along = Math.min(Math.sin(angle), mu * normal);  // the tangent row and its bound
        return {speed: Math.sin(angle) - along, normal, along, limit: Math.atan(mu) * 180 / Math.PI};
    }

    rigid_sentence('slope', {
        values({angle, mu}) {
            const {speed, limit} = step(angle, mu);
            return {speed, limit, says: speed > 0 ? 'slides' : 'sticks'};
        },
        picture({angle, mu}) {
            const {normal, along} = step(angle, mu), a = angle * Math.PI / 180, c = Math.cos(a), s = Math.sin(a), size = 1.5;
            const on = (t, n) => [t * c + n * s - 0.2, -t * s + n * c - 0.2];  // along the slope, downwards to the right, and out of it
            const foot = on(0, 0), cone = 1.5 * size, wide = mu * cone;
            return {
                view: [-2.2, -1.5, 2.2, 2.1], equal: true,
                marks: [{path: [on(-6, 0), on(6, 0)], colour: 'faint', width: 3},
                        {path: [on(-0.5, 0), on(0.5, 0), on(0.5, 0.7), on(-0.5, 0.7)], fill: 0.15, colour: 'blue', close: true},
                        {path: [on(-wide, cone), foot, on(wide, cone)], colour: 'green', dash: true},
                        {arrow: [foot, on(-size * along, size * normal)], colour: 'red', width: 3},
                        {arrow: [on(0, 0.35), [on(0, 0.35)[0], on(0, 0.35)[1] - size]], colour: 'orange'},
                        {words: 'weight', at: [on(0, 0.35)[0] + 0.1, on(0, 0.35)[1] - size + 0.1], anchor: 'start', colour: 'orange'}]
            };
        }
    });
})();
