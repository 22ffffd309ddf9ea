// What small.cpp does by hand, for the sentence that can be dragged: a door of 1 m on a pin, a motor, and a stop.
'use strict';

(function () {
    // (14.1) and (14.2) with another mass and another gap [mrad]: about its hinge the door has m/3.
    function turned(mass, gap) {
        const inertia = mass / 3, free = 0.1 / inertia, omega = Math.min(free, gap / 100);
        return {pin: mass * omega / 2, stop: inertia * (free - omega), motor: 0.1, omega};
    }

    rigid_sentence('door', {
        values: ({mass, gap}) => turned(mass, gap),
        picture({mass, gap}) {
            const at = (mrad, length) => [length * Math.cos(mrad / 20), length * Math.sin(mrad / 20)];  // fifty times as wide
            const {omega} = turned(mass, gap), end = at(100 * omega, 1);
            return {
                view: [-0.15, -0.25, 1.35, 1.1], equal: true,
                marks: [{path: [at(gap, 0.75), at(gap, 1.1)], colour: 'red', width: 3}, {path: [[0, 0], [1, 0]], colour: 'faint', width: 5},
                        {path: [[0, 0], end], colour: 'blue', width: 5}, {dot: [0, 0]},
                        {words: 'after 0.1 s, angles 50 times as wide', at: [0.72, -0.16]}]
            };
        }
    });
})();
