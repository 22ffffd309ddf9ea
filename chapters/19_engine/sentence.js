// How long the generations of section 19.1 last, for the sentence that can be dragged: 2^bits − 1 of them, 0 names nothing.
'use strict';

(function () {
    const seconds = (rate, bits) => (Math.pow(2, bits) - 1) / rate;
    const units = [['seconds', 1, 120], ['minutes', 60, 120], ['hours', 3600, 48], ['days', 86400, 1000], ['years', 365.25 * 86400, Infinity]];
    const unit_of = time => units.find(([, size, most]) => time / size < most);

    rigid_sentence('generations', {
        values: ({rate, bits}) => {
            const time = seconds(rate, bits), [unit, size] = unit_of(time);
            return {time: time / size, unit};
        },
        picture({rate, bits}) {
            const log = Math.log10, along = [...Array(25).keys()].map(k => k + 8);
            return {
                view: [6, -1.5, 35, 10.5],
                marks: [{path: along.map(k => [k, log(seconds(rate, k))]), colour: 'blue'}, {dot: [bits, log(seconds(rate, bits))], colour: 'red', size: 5},
                        {words: 'a day', at: [7, log(86400) + 0.15], anchor: 'start'}, {path: [[7, log(86400)], [33, log(86400)]]},
                        {words: '32 bits', at: [33, -1.2], anchor: 'end'}, {words: '8 bits', at: [7, -1.2], anchor: 'start'}]
            };
        }
    });
})();
