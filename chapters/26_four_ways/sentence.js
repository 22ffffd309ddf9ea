// One step of a bead on a wire, for the sentence that can be dragged: the ways of small.cpp with g = 10 m/s².
'use strict';

(function () {
    function steps(h) {
        const x = 0.6, y = -0.8, u = 0.8, v = 0.6 - 10 * h;  // u*
        const w = 0.6 * u - 0.8 * v, f = 9;                   // of the row, and of the wire [N]
        const length = Math.hypot(x + h * u, y + h * v), rate = 1 - 6 * h, angle = Math.atan2(0.6, 0.8) + h * rate;
        return {
            spring: [x + h * u, y + h * v],
            acceleration: [x + h * (0.8 - h * f * 0.6), y + h * (v + h * f * 0.8)],
            velocity: [x + h * (u - w * 0.6), y + h * (v + w * 0.8)],
            position: [(x + h * u) / length, (y + h * v) / length],
            angle: [Math.sin(angle), -Math.cos(angle)]
        };
    }
    const off = at => 1000 * (Math.hypot(at[0], at[1]) - 1);
    const colours = {spring: 'orange', acceleration: 'red', velocity: 'blue', position: 'green', angle: 'purple'};

    rigid_sentence('bead_ways', {
        values({h}) {
            const at = steps(h);
            return {spring: off(at.spring), inside: -off(at.acceleration), velocity: off(at.velocity)};
        },
        picture({h}) {
            const at = steps(h);
            return {
                view: [0.5, -0.98, 0.9, -0.66], equal: true,
                marks: [{circle: [0, 0, 1], colour: 'faint', width: 4}, {dot: [0.6, -0.8], colour: 'ink'},
                        ...Object.keys(colours).flatMap((way, n) => [
                            {path: [[0.6, -0.8], at[way]], colour: colours[way], width: 1.5}, {dot: at[way], colour: colours[way]},
                            {words: way, at: [0.89, -0.68 - 0.022 * n], anchor: 'end', colour: colours[way]}])]
            };
        }
    });
})();
