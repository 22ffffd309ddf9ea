// Follows a draw list (common/draw_list.hpp) on a 2D context. Colours: by their number.
'use strict';

globalThis.rigid_paint = function (g, {numbers, words}, colours) {
    let text = 0;
    g.lineCap = g.lineJoin = 'round';
    for (let i = 0; i < numbers.length;) {
        const kind = numbers[i], colour = colours[numbers[i + 1]], opacity = numbers[i + 2], edge = numbers[i + 3];
        const width = numbers[i + 4], dash = numbers[i + 5], count = numbers[i + 6], p = i + 7;
        i = p + count;
        if (kind === 4) {
            g.save();
            g.beginPath();
            g.rect(numbers[p], numbers[p + 1], numbers[p + 2], numbers[p + 3]);
            g.clip();
            continue;
        }
        if (kind === 5) {
            g.restore();
            continue;
        }
        g.fillStyle = g.strokeStyle = colour;
        if (kind === 3) {
            g.globalAlpha = opacity;
            g.font = (numbers[p + 4] ? '600 ' : '') + numbers[p + 2] + 'px "DejaVu Sans", Helvetica, Arial, sans-serif';
            g.textAlign = ['left', 'center', 'right'][numbers[p + 3]];
            g.fillText(words[text++], numbers[p], numbers[p + 1]);
            continue;
        }
        g.beginPath();
        if (kind === 0) g.arc(numbers[p], numbers[p + 1], numbers[p + 2], 0, 2 * Math.PI);
        else if (kind === 6) rounded(g, numbers[p], numbers[p + 1], numbers[p + 2], numbers[p + 3], numbers[p + 4]);
        else {
            g.moveTo(numbers[p], numbers[p + 1]);
            for (let k = 2; k < count; k += 2) g.lineTo(numbers[p + k], numbers[p + k + 1]);
            if (kind === 1) g.closePath();
        }
        if (opacity > 0 && kind !== 2) {
            g.globalAlpha = opacity;
            g.fill();
        }
        if (edge > 0) {
            g.globalAlpha = edge;
            g.lineWidth = width;
            g.setLineDash(dash > 0 ? [6 * dash, 5 * dash] : []);
            g.stroke();
        }
    }
    g.globalAlpha = 1;

    function rounded(g, x, y, w, h, r) {
        g.moveTo(x + r, y);
        g.arcTo(x + w, y, x + w, y + h, r);
        g.arcTo(x + w, y + h, x, y + h, r);
        g.arcTo(x, y + h, x, y, r);
        g.arcTo(x, y, x + w, y, r);
        g.closePath();
    }
};
