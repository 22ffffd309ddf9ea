// Prints HTML_FOLDER/print.html (docs/tools/print_pages.py) by Chromium, with its equations set.
//
//     node docs/web/print.mjs HTML_FOLDER FILE.pdf
//
// What is wider than the page is made smaller. The table of contents gets its page numbers from a first print: each anchor
// that a link names is a destination in it.
import {closeSync, openSync, writeSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';
import {Browser} from './test/devtools.mjs';

const [, , folder, file] = process.argv;
const browser = new Browser();
browser.patience = 1800;  // seconds: a whole book in one call

async function printed(page) {
    const {stream} = await page.send('Page.printToPDF', {preferCSSPageSize: true, printBackground: true, generateDocumentOutline: true, transferMode: 'ReturnAsStream'});
    const parts = [];
    for (let end = false; !end;) {
        const {data, base64Encoded, eof} = await page.send('IO.read', {handle: stream});
        parts.push(Buffer.from(data, base64Encoded ? 'base64' : 'utf8'));
        end = eof;
    }
    await page.send('IO.close', {handle: stream});
    return Buffer.concat(parts);
}

// {anchor: page number, from 1} of a PDF of Chromium's, whose objects are plain text.
function places(pdf) {
    const text = pdf.toString('latin1'), objects = {}, order = [];
    for (const m of text.matchAll(/(?:^|\n)(\d+) 0 obj\s([^]*?)\nendobj/g)) objects[m[1]] = m[2];
    const visit = number => {
        const kids = /\/Kids\s*\[([^\]]*)\]/.exec(objects[number] || '');
        if (kids) for (const kid of kids[1].matchAll(/(\d+) 0 R/g)) visit(kid[1]);
        else order.push(number);
    };
    const catalog = Object.values(objects).find(one => /\/Type\s*\/Catalog/.test(one));
    visit(/\/Pages\s+(\d+) 0 R/.exec(catalog)[1]);
    const dests = /\/Dests\s+(\d+) 0 R/.exec(catalog), found = {};
    for (const m of dests ? objects[dests[1]].matchAll(/\/([^\s/[\]]+)\s*\[(\d+) 0 R/g) : [])
        found[m[1].replace(/#([0-9a-fA-F]{2})/g, (all, hex) => String.fromCharCode(parseInt(hex, 16)))] = order.indexOf(m[2]) + 1;
    return {count: order.length, found};
}

let code = 0;
try {
    const page = await browser.page(), width = Math.round(170 / 25.4 * 96);  // of the text on A4
    await page.open(pathToFileURL(resolve(join(folder, 'print.html'))).href, {width});
    await page.until(`document.documentElement.classList.contains('equations-set')`, 1800, 'the equations are not set');
    await page.send('Emulation.setEmulatedMedia', {media: 'print'});
    // What is too wide gets smaller; a listing that fits on half a page is not split; a tall figure may fill a page.
    const small = await page.value(`(() => {
        let count = 0;
        for (const one of document.querySelectorAll('.formulaDsp, table')) {
            const room = one.parentElement.clientWidth, wide = one.matches('table') ? one.offsetWidth : one.scrollWidth;
            if (wide <= room + 1) continue;
            (one.matches('table') ? one : one.firstElementChild).style.zoom = Math.max(0.4, room / wide * 0.995);
            ++count;
        }
        for (const one of document.querySelectorAll('.sheet img')) if (one.naturalHeight > 1.15 * one.naturalWidth) one.classList.add('tall');
        for (const one of document.querySelectorAll('.fragment')) if (one.offsetHeight < 480) one.classList.add('short');
        return count;
    })()`);
    let pdf = await printed(page), {count, found} = places(pdf);
    const lines = await page.value(`document.querySelectorAll('[data-page]').length`);
    if (lines) {
        const numbered = await page.value(`((found) => {
            let count = 0;
            for (const one of document.querySelectorAll('[data-page]')) if (found[one.dataset.page]) { one.textContent = found[one.dataset.page]; ++count; }
            return count;
        })(${JSON.stringify(found)})`);
        if (numbered < lines) throw new Error(`${lines - numbered} of ${lines} lines of the table of contents have no page`);
        pdf = await printed(page);
        if (places(pdf).count !== count) throw new Error('the table of contents has moved the pages');
    }
    if (page.complaints.length) throw new Error(page.complaints.join('; '));
    const out = openSync(file, 'w');
    writeSync(out, pdf);
    closeSync(out);
    console.log(`${file}: ${count} pages, ${(pdf.length / 1e6).toFixed(1)} MB; ${small} equations and tables made smaller to fit`);
} catch (error) {
    console.error(`print: ${error.message}`);
    code = 1;
}
await browser.close();
process.exit(code);
