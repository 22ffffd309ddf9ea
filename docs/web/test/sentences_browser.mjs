// Every sentence of the site whose numbers can be dragged, in a real browser, opened as files: on a wide page and on a phone, in
// light and dark.
//
//     node docs/web/test/sentences_browser.mjs HTML_FOLDER [--shots DIR] [--only WORD]
//
// Of each: the sentence stands as in the text; a number follows the pointer, a finger, and the keys of its slider, which has
// a name; what follows changes with it, and so does the figure; a double click gives the text's number back; nothing is
// wider than the page; on paper the sentence is plain text; no word in the console.
import {mkdirSync, readFileSync, readdirSync, writeFileSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';
import {Browser} from './devtools.mjs';

const words = process.argv.slice(2);
const option = name => words.includes(name) ? words.splice(words.indexOf(name), 2)[1] : '';
const shots = option('--shots'), only = option('--only');
const folder = resolve(words[0]);
if (shots) mkdirSync(shots, {recursive: true});
const pages = readdirSync(folder).filter(one => one.endsWith('.html') && one.includes(only)).filter(one => readFileSync(join(folder, one), 'utf8').includes('class="sentence"')).sort();
const browser = new Browser();
let passed = 0, failed = 0;

function check(right, what) {
    if (!right) throw new Error(what);
}

async function sentence(page, i, touch) {
    const place = `document.querySelectorAll('.sentence')[${i}]`, text = `${place}.querySelector('p').textContent`;
    const said = await page.value(text), drawn = await page.value(`${place}.querySelector('.sentence-figure').innerHTML`);
    const count = await page.value(`${place}.querySelectorAll('.sentence-number').length`);
    check(count > 0 && drawn.length > 200, 'it has no number to drag, or no figure');
    check(await page.value(`${place}.querySelector('.sentence-figure').getAttribute('aria-label').length > 20`), 'its figure has no name');
    for (let k = 0; k < count; ++k) {
        const number = `${place}.querySelectorAll('.sentence-number')[${k}]`, range = `${place}.querySelectorAll('input[type="range"]')[${k}]`;
        check(await page.value(`${range}.labels[0].textContent.trim().length > 0 && ${range}.getAttribute('aria-valuetext').length > 0`), 'a slider has no name or no value in words');
        await page.value(`${number}.scrollIntoView({block: 'center', behavior: 'instant'})`);
        const box = await page.value(`(() => { const b = ${number}.getBoundingClientRect(); return {x: b.x + b.width / 2, y: b.y + b.height / 2}; })()`);
        const at = await page.value(`${range}.value`);
        const way = await page.value(`Number(${range}.value) < (Number(${range}.min) + Number(${range}.max)) / 2 ? 1 : -1`);
        if (touch) {
            await page.touch('touchStart', [box.x, box.y]);
            for (const dx of [20, 40, 60]) await page.touch('touchMove', [box.x + way * dx, box.y]);
            await page.touch('touchEnd');
        } else {
            await page.mouse('mousePressed', box.x, box.y, true);
            for (const dx of [20, 40, 60]) await page.mouse('mouseMoved', box.x + way * dx, box.y, true);
            await page.mouse('mouseReleased', box.x + way * 60, box.y);
        }
        const dragged = await page.value(`${range}.value`);
        check(dragged !== at && (dragged - at) * way > 0, `number ${k + 1} does not follow the ${touch ? 'finger' : 'pointer'}: ${at} to ${dragged}`);
        check(await page.value(text) !== said, `nothing follows number ${k + 1}`);
        check(await page.value(`${place}.querySelector('.sentence-figure').innerHTML`) !== drawn, `the figure does not follow number ${k + 1}`);
        if (!touch) {
            check(await page.value(`document.activeElement === ${range}`), 'the keys do not go on where the pointer let go');
            await page.send('Input.dispatchKeyEvent', {type: 'keyDown', key: 'ArrowRight', code: 'ArrowRight', windowsVirtualKeyCode: 39});
            await page.send('Input.dispatchKeyEvent', {type: 'keyUp', key: 'ArrowRight', code: 'ArrowRight', windowsVirtualKeyCode: 39});
            check(await page.value(`${range}.value`) !== dragged, `number ${k + 1} does not follow the keys`);
        }
        for (const end of ['min', 'max']) {
            await page.value(`${range}.value = ${range}.${end}; ${range}.dispatchEvent(new Event('input'))`);
            const all = await page.value(`${place}.textContent + ${place}.querySelector('.sentence-figure').innerHTML`);
            check(!/NaN|undefined|Infinity/.test(all), `at its ${end} number ${k + 1} gives a number that is none`);
        }
        await page.value(`${number}.dispatchEvent(new Event('dblclick'))`);
    }
    check(await page.value(text) === said, 'a double click does not give the text back');
}

for (const name of pages) for (const {width, dark} of [{width: 1400, dark: false}, {width: 1400, dark: true}, {width: 390, dark: false}, {width: 390, dark: true}]) {
    const page = await browser.page(), what = `${name} at ${width}, ${dark ? 'dark' : 'light'}`;
    try {
        await page.open(pathToFileURL(join(folder, name)).href, {width, dark, touch: width < 500});
        await page.until(`document.documentElement.classList.contains('equations-set')`, 60, 'the equations are not set');
        const count = await page.value(`document.querySelectorAll('.sentence').length`);
        for (let i = 0; i < count; ++i) await sentence(page, i, width < 500);
        check(await page.value(`document.documentElement.scrollWidth <= innerWidth`), 'the page is wider than the screen');
        if (shots) {
            await page.value(`document.activeElement.blur(); document.querySelector('.sentence').scrollIntoView({block: 'center', behavior: 'instant'})`);
            await new Promise(done => setTimeout(done, 300));
            const {data} = await page.send('Page.captureScreenshot', {format: 'png'});
            writeFileSync(join(shots, `${name.replace('.html', '')}_${width}_${dark ? 'dark' : 'light'}.png`), Buffer.from(data, 'base64'));
        }
        await page.send('Emulation.setEmulatedMedia', {media: 'print'});
        check(await page.value(`getComputedStyle(document.querySelector('.sentence-below')).display`) === 'none', 'the sliders are printed');
        check(!page.complaints.length, page.complaints.join('; '));
        ++passed;
    } catch (error) {
        ++failed;
        console.error(`${what}: ${[error.message, ...page.complaints].join('; ')}`);
    }
    await page.close();
}
await browser.close();
console.log(`sentences in a browser: ${passed} pages in order${failed ? `, ${failed} not` : ''}`);
process.exit(failed || !passed ? 1 : 0);
