// What small.cpp does by hand, for the sentence that can be dragged: two level rods of 1 m, pinned in line, the first to a wall.
'use strict';

(function () {
    // (15.1) with the second rod's mass, and (15.2), for g h = 1 m/s: impulses, and the spins after the step.
    function let_go(mass) {
        const first = 1 / (4 - mass / (1 + mass)), second = -first * mass / (2 * (1 + mass));
        return {first, second, omega1: -6 * (first + second), omega2: -6 * second / mass};
    }

    rigid_sentence('two_rods', {
        values({mass}) {
            const {first, second, omega1, omega2} = let_go(mass);
            return {first, second, turn1: 9.81 * omega1, turn2: 9.81 * omega2, end: -omega1};
        },
        picture({mass}) {
            const {omega1, omega2} = let_go(mass), t = 0.22, turned = omega => 9.81 * omega * t * t / 2;
            const [a, b] = [turned(omega1), turned(omega2)], pin = [Math.cos(a), Math.sin(a)];
            return {
                view: [-0.25, -0.65, 2.35, 0.55], equal: true,
                marks: [{path: [[-0.1, -0.4], [-0.1, 0.4]], colour: 'faint', width: 4}, {path: [[0, 0], [2, 0]], colour: 'faint', dash: true},
                        {path: [[0, 0], pin], colour: 'blue', width: 5}, {path: [pin, [pin[0] + Math.cos(b), pin[1] + Math.sin(b)]], colour: 'orange', width: 5},
                        {dot: [0, 0]}, {dot: pin}, {words: 'as they begin, for 0.22 s', at: [1.2, 0.36]}]
            };
        }
    });
})();
