// What the tools of this folder share: a chapter's machine in node, and the commands of a draw list as SVG.
import {readFileSync} from 'node:fs';
import './unpack.js';
import './join.js';
import './machine.js';
import './painter.js';

export function bytes_of(script) {
    const packed = readFileSync(script, 'utf8').match(/, \[([\d, ]+)\], "([A-Za-z0-9+/=]+)"\);\s*$/);
    if (!packed) throw new Error(`${script} has no code`);
    return rigid_unpacked(packed[1].split(', ').map(Number), packed[2]);
}
export const code_of = async script => WebAssembly.compile(bytes_of(script));
export const machine_of = async script => RigidMachine.of(await code_of(script));

// As in common/svg_canvas.cpp: they read on white and on dark. The cards behind the panes are the page's.
export const still_colours = ['#808080', '#808080', '#4477AA', '#EE7733', '#228833', '#CC3311', '#AA3377', '#CCBB44', 'none', 'none', '#808080'];

const number = x => String(Math.round(x * 100) / 100);
const escaped = text => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');

// As much of a 2D context as painter.js asks for.
export class SvgContext {
    constructor() {
        Object.assign(this, {out: [], clips: 0, path: null, globalAlpha: 1, lineWidth: 1, dash: [], fillStyle: '', strokeStyle: '', font: '', textAlign: 'left'});
    }
    flush() {
        const path = this.path;
        this.path = null;
        if (!path || !(path.fill || path.stroke)) return;
        this.out.push(`${path.shape || `<path d="${path.d}"`}${path.fill || ' fill="none"'}${path.stroke || ''}/>`);
    }
    alpha(name) { return this.globalAlpha < 1 ? ` ${name}-opacity="${number(this.globalAlpha)}"` : ''; }
    beginPath() { this.flush(); this.path = {d: '', fill: '', stroke: ''}; }
    moveTo(x, y) { this.path.d += `M${number(x)} ${number(y)}`; }
    lineTo(x, y) { this.path.d += `L${number(x)} ${number(y)}`; }
    closePath() { this.path.d += 'Z'; }
    arc(x, y, r) { this.path.shape = `<circle cx="${number(x)}" cy="${number(y)}" r="${number(r)}"`; }
    rect(x, y, w, h) { this.path.shape = `<rect x="${number(x)}" y="${number(y)}" width="${number(w)}" height="${number(h)}"`; }
    arcTo(x, y) { this.lineTo(x, y); } // a small square's corners
    fill() { if (this.fillStyle !== 'none') this.path.fill = ` fill="${this.fillStyle}"${this.alpha('fill')}`; }
    stroke() {
        const dash = this.dash.length ? ` stroke-dasharray="${this.dash.map(number).join(' ')}"` : '';
        this.path.stroke = ` stroke="${this.strokeStyle}" stroke-width="${number(this.lineWidth)}"${this.alpha('stroke')}${dash}`;
    }
    setLineDash(dash) { this.dash = dash; }
    clip() {
        const id = `c${++this.clips}`;
        this.out.push(`<clipPath id="${id}">${this.path.shape}/></clipPath><g clip-path="url(#${id})">`);
        this.path = null;
    }
    save() { this.flush(); }
    restore() { this.flush(); this.out.push('</g>'); }
    fillText(words, x, y) {
        this.flush();
        const [, bold, size] = this.font.match(/(600 )?([\d.]+)px/);
        const anchor = {left: '', center: ' text-anchor="middle"', right: ' text-anchor="end"'}[this.textAlign];
        this.out.push(`<text x="${number(x)}" y="${number(y)}" font-size="${number(+size)}"${bold ? ' font-weight="600"' : ''}${anchor} fill="${this.fillStyle}"${this.alpha('fill')}>${escaped(words)}</text>`);
    }
    svg(width, height) {
        this.flush();
        return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" ` +
            'font-family="DejaVu Sans, Helvetica, Arial, sans-serif" stroke-linecap="round" stroke-linejoin="round">\n' + this.out.join('\n') + '\n</svg>\n';
    }
}

// FNV-1a over the bits of the numbers, in hexadecimal.
export function hash_of(numbers) {
    let hash = 0xcbf29ce484222325n;
    const words = new BigUint64Array(numbers.buffer, numbers.byteOffset, numbers.length);
    for (const word of words) hash = BigInt.asUintN(64, (hash ^ word) * 0x100000001b3n);
    return hash.toString(16).padStart(16, '0');
}
