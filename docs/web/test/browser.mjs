// Every demo of the site in a real browser, opened as files: in light and dark, on a wide page and on a phone.
//
//     node docs/web/test/browser.mjs HTML_FOLDER [--shots DIR] [--only WORD]
//
// Of each demo: nothing is loaded and nothing moves before it is started; it starts by a click within a second; it makes 100
// steps; it answers the pointer, a finger and the keys; a slider and a list change a setting; the switch that breaks the idea works; its
// controls have names; paused it takes no time; nothing is wider than the page; no word in the console; no request leaves.
import {mkdirSync, readFileSync, readdirSync, writeFileSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';
import {Browser} from './devtools.mjs';

const words = process.argv.slice(2);
const option = name => words.includes(name) ? words.splice(words.indexOf(name), 2)[1] : '';
const shots = option('--shots'), only = option('--only');
const folder = resolve(words[0]);
if (shots) mkdirSync(shots, {recursive: true});

const pages = readdirSync(folder).filter(one => one.endsWith('.html') && one.includes(only)).filter(one => readFileSync(join(folder, one), 'utf8').includes('class="demo"')).sort();
const settings = [{width: 1280, dark: false}, {width: 1280, dark: true}, {width: 390, dark: false}, {width: 390, dark: true}];
const wait = seconds => new Promise(done => setTimeout(done, 1000 * seconds));
let passed = 0, failed = 0;
const browser = new Browser();

function check(right, what) {
    if (!right) throw new Error(what);
}

// Where an element is on the screen.
const box_of = (page, element) => page.value(`(() => { const box = ${element}.getBoundingClientRect(); return {x: box.x, y: box.y, width: box.width, height: box.height}; })()`);
async function click(page, element) {
    await page.value(`${element}.scrollIntoView({block: 'center', behavior: 'instant'})`);
    const box = await box_of(page, element), x = box.x + box.width / 2, y = box.y + box.height / 2;
    await page.mouse('mouseMoved', x, y);
    await page.mouse('mousePressed', x, y, true);
    await page.mouse('mouseReleased', x, y);
}
// Time that the page itself had of a processor, in seconds: other programs of the machine don't count.
const busy = async page => (await page.send('Performance.getMetrics')).metrics.find(one => one.name === 'ThreadTime').value;

async function demo(page, i, {width, dark}, name) {
    const place = `document.querySelectorAll('.demo')[${i}]`;
    check(!await page.value(`'state' in ${place}.dataset`) || await page.value(`'opens' in ${place}.dataset`), 'it runs before it was started');
    const opens = await page.value(`'opens' in ${place}.dataset`), idle = opens ? 0 : await busy(page);
    if (opens) await page.value(`${place}.scrollIntoView({block: 'center', behavior: 'instant'})`);
    else await click(page, `${place}.querySelector('.demo-start')`);
    await page.until(`'state' in ${place}.dataset`, 20, 'it does not start');
    check(await page.value(`${place}.dataset.state`) === 'runs', await page.value(`${place}.innerText`));
    const first_frame = await page.value(`Number(${place}.dataset.firstFrame)`), own_time = Math.round(1000 * (await busy(page) - idle));

    // It moves by itself, then step by step to 100.
    await page.value(`${place}.scrollIntoView({block: 'center', behavior: 'instant'})`);
    await page.until(`Number(${place}.dataset.steps) > 0`, 10, 'it makes no step');
    if (shots) {
        await wait(0.8);
        const inner = await box_of(page, place);
        await page.send('Emulation.setDeviceMetricsOverride', {width, height: Math.ceil(inner.height + 60), deviceScaleFactor: 1, mobile: false});
        await page.value(`${place}.scrollIntoView({block: 'center', behavior: 'instant'})`);
        await wait(0.3);
        const seen = await page.value(`(() => { const box = ${place}.getBoundingClientRect(); return {x: Math.max(0, box.x - 12), y: Math.max(0, box.y - 12) + scrollY, width: Math.min(innerWidth, box.width + 24), height: box.height + 24}; })()`);
        const {data} = await page.send('Page.captureScreenshot', {format: 'png', clip: {...seen, scale: 1}});
        writeFileSync(join(shots, `${name}_${i}_${width}_${dark ? 'dark' : 'light'}.png`), Buffer.from(data, 'base64'));
        await page.send('Emulation.setDeviceMetricsOverride', {width, height: 900, deviceScaleFactor: 1, mobile: width < 500});
        await page.value(`${place}.scrollIntoView({block: 'center', behavior: 'instant'})`);
    }
    await click(page, `${place}.querySelector('.demo-run')`);
    check(await page.value(`${place}.querySelector('.demo-run').textContent`) === 'Run', 'the button Pause does not pause');
    const canvas = `${place}.querySelector('.demo-stage canvas')`;
    await page.value(`${canvas}.focus()`);
    const before = await page.value(`Number(${place}.dataset.steps)`);
    await page.key('s', 'KeyS');
    check(await page.value(`Number(${place}.dataset.steps)`) === before + 1, 'the key S makes no step');
    const steps = await page.value(`(() => { const demo = ${place}.demo; for (let k = 0; k < 100 && Number(${place}.dataset.steps) < 100; ++k) demo.step(); return Number(${place}.dataset.steps); })()`);
    check(steps >= 100, `it makes ${steps} steps, then no more: ${await page.value(`${place}.querySelector('.demo-sentence').textContent`)}`);

    // Paused it takes no time.
    check(await page.value(`${place}.demo.frame_asked`) === 0, 'paused it still asks for frames');

    // The pointer: a ring stands where a pull goes to. A finger on the phone.
    await page.value(`${canvas}.scrollIntoView({block: 'center', behavior: 'instant'})`);
    const picture = () => page.value(`${canvas}.toDataURL()`);
    const box = await box_of(page, canvas), x = box.x + box.width * 0.24, y = box.y + box.height * 0.4;
    if (width < 500) {
        await page.value(`${place}.demo.set_playing(true)`);
        await page.touch('touchStart', [x, y]);
        await page.touch('touchMove', [x + 20, y + 10]);
        check(await page.value(`${place}.demo.machine.api.web_pressed()`) === 1, 'it does not answer a finger');
        await page.touch('touchEnd');
        check(await page.value(`${place}.demo.machine.api.web_pressed()`) === 0, 'it holds on when the finger has left');
        await page.value(`${place}.demo.set_playing(false)`);
    } else {
        await page.mouse('mouseMoved', 2, 2);
        const untouched = await picture();
        await page.mouse('mouseMoved', x, y);
        await page.mouse('mousePressed', x, y, true);
        await page.mouse('mouseMoved', x + 15, y + 8, true);
        check(await page.value(`${place}.demo.machine.api.web_pressed()`) === 1, 'it does not answer the pointer');
        check(await picture() !== untouched, 'the picture does not show the pointer');
        await page.mouse('mouseReleased', x + 15, y + 8);
    }

    // A slider by its keys, and Reset.
    await page.value(`${place}.querySelectorAll('.demo-part').forEach(one => { one.open = true; })`);
    const slider = `${place}.querySelector('.demo-slider input')`;
    const shown = () => page.value(`${place}.querySelector('.demo-slider output').textContent`);
    await page.value(`${slider}.focus()`);
    const value = await shown();
    for (const key of ['ArrowRight', 'ArrowLeft', 'ArrowLeft']) {
        if (await shown() === value) await page.key(key);
    }
    check(await shown() !== value, `the slider ${await page.value(`${slider}.id`)} does not move`);
    await click(page, `${place}.querySelectorAll('.demo-bar button')[2]`);
    check(await page.value(`${place}.dataset.steps`) === '0', 'Reset does not restart');

    // A setting whose values have names takes the one that is chosen, and shows it.
    const chosen = await page.value(`(() => {
        const demo = ${place}.demo, i = demo.scene.sliders.findIndex(one => one.names.length);
        if (i < 0) return '';
        const row = demo.scene.sliders[i], control = demo.rows[i].all.querySelector('select, input'), before = demo.state.settings[i];
        const other = before > row.low ? row.low : row.low + 1;
        if (control.type === 'checkbox') control.checked = other > row.low;
        else control.selectedIndex = other - row.low;
        control.dispatchEvent(new Event('change'));
        const taken = demo.state.settings[i], names = control.type === 'checkbox' ? row.names.length : control.options.length;
        demo.change('web_slide', i, before);
        const shown = control.type === 'checkbox' ? Number(control.checked) : control.selectedIndex;
        return taken !== other ? row.label + ' stays ' + taken : shown !== before - row.low || names !== row.names.length ? row.label + ' shows another value' : '';
    })()`);
    check(chosen === '', `a setting with names: ${chosen}`);

    // The switch that turns the idea off, and on again.
    const off = `${place}.querySelector('.demo-break input')`;
    if (await page.value(`!!${off}`)) {
        const settings_now = () => page.value(`JSON.stringify([${place}.demo.state.settings, ${place}.demo.state.on])`);
        const whole = await settings_now();
        await click(page, off);
        check(await settings_now() !== whole, 'the switch that breaks the idea changes nothing');
        await wait(0.3);
        await click(page, off);
        check(await settings_now() === whole, 'the idea does not come back');
    }
    await page.value(`${place}.demo.set_playing(false)`);

    // Names for a screen reader; room for the eye.
    const nameless = await page.value(`[...${place}.querySelectorAll('button, select, input, canvas')].filter(one =>
        !(one.getAttribute('aria-label') || one.textContent.trim() && one.tagName === 'BUTTON' || (one.labels && one.labels.length && one.labels[0].textContent.trim()))).map(one => one.outerHTML.slice(0, 80))`);
    check(nameless.length === 0, `these have no names: ${nameless.join(', ')}`);
    const wide = await page.value(`[...${place}.querySelectorAll('*')].filter(one => one.getBoundingClientRect().right > ${place}.getBoundingClientRect().right + 1 && one.getBoundingClientRect().width > 0).map(one => one.outerHTML.slice(0, 60))`);
    check(wide.length === 0, `these stand out at the right: ${wide.slice(0, 3).join(', ')}`);
    // Last, so that all else was looked at. The time at work tells a slow page from a busy machine; it excuses neither.
    check(first_frame <= 1000, `its first frame took ${first_frame} ms, ${own_time} ms of them at work; 1000 are allowed`);
    return `${first_frame} ms, at work ${own_time} ms`;
}

try {
    for (const file of pages) for (const setting of settings) {
        const page = await browser.page();
        const where = `${file} ${setting.width} ${setting.dark ? 'dark' : 'light'}`;
        await page.open(pathToFileURL(join(folder, file)).href, {...setting, touch: setting.width < 500});
        const count = await page.value(`document.querySelectorAll('.demo').length`);
        check(await page.value(`document.documentElement.classList.contains('dark-mode')`) === setting.dark, `${where}: the theme is the other one`);
        for (let i = 0; i < count; ++i) {
            const what = `${where}: demo ${i + 1}, ${await page.value(`document.querySelectorAll('.demo')[${i}].dataset.scene`)}`;
            try {
                const first = await demo(page, i, setting, file.replace('.html', ''));
                ++passed;
                console.log(`ok     ${what} (first frame ${first})`);
            } catch (error) {
                ++failed;
                console.log(`FAULT  ${what}: ${error.message}`);
            }
        }
        // All are paused: what does the page take?
        const faults = [];
        if (count) {
            const before = await busy(page);
            await wait(1);
            const taken = await busy(page) - before;
            if (taken > 0.05) faults.push(`with all demos paused the page takes ${(100 * taken).toFixed(0)} % of a processor`);
        }
        const room = await page.value(`[document.documentElement.scrollWidth, innerWidth]`);
        if (room[0] > room[1] + 1) faults.push(`the page is ${room[0]} wide, the screen ${room[1]}`);
        faults.push(...page.complaints.map(one => `in the console: ${one}`));
        faults.push(...page.requests.filter(one => !/^(file|data|blob):/.test(one)).map(one => `a request to ${one}`));
        for (const fault of faults) console.log(`FAULT  ${where}: ${fault}`);
        faults.length ? failed += 1 : passed += 1;
        await page.close();
    }
    // Each chapter has a switch that turns its idea off.
    const switches = new Map();
    for (const file of pages.filter(one => one.startsWith('ch')))
        for (const [place, program] of readFileSync(join(folder, file), 'utf8').matchAll(/<div class="demo" data-program="([^"]+)"[^>]*>/g))
            switches.set(program, switches.get(program) || place.includes(' data-break="'));
    for (const [program, is_there] of switches) {
        is_there ? ++passed : ++failed;
        if (!is_there) console.log(`FAULT  ${program}: no demo of it has a switch that breaks its idea`);
    }
    // The search box: what the book is about is found in its text, by the keyboard alone.
    const reader = await browser.page();
    for (const [words, wanted] of [['baumgarte', /^ch07_baumgarte\.html/], ['warm start', /^ch08_warm_starting/], ['rattl', /^ch11/]]) {
        await reader.open(pathToFileURL(join(folder, 'index.html')).href, {width: 390, still: true});
        await reader.value(`(field => { field.focus(); field.value = ${JSON.stringify(words)}; field.dispatchEvent(new Event('input')); })(document.getElementById('search_field'))`);
        let fault = '';
        try {
            await reader.until(`!document.getElementById('search_hits').hidden`, 10, 'the search shows something');
            const first = await reader.value(`(row => row ? row.getAttribute('href') : '')(document.querySelector('#search_hits [aria-selected]'))`);
            if (!wanted.test(first)) fault = `the first hit is ${first || 'none'}`;
            if (!fault && reader.complaints.length) fault = reader.complaints[0];
        } catch (error) {
            fault = error.message;
        }
        console.log(`${fault ? 'FAULT ' : 'ok    '} index.html: search for "${words}"${fault ? ': ' + fault : ''}`);
        fault ? ++failed : ++passed;
    }
    await reader.close();
    // The cards of the chapters run under the pointer, and only there.
    const front = await browser.page();
    await front.open(pathToFileURL(join(folder, 'index.html')).href, {width: 1280});
    const count = await front.value(`document.querySelectorAll('.card[data-program]').length`);
    for (let i = 0; i < count; ++i) {
        const card = `document.querySelectorAll('.card[data-program]')[${i}]`;
        let fault = '';
        try {
            await front.value(`${card}.scrollIntoView({block: 'center', behavior: 'instant'})`);
            const box = await box_of(front, card);
            await front.mouse('mouseMoved', box.x + box.width / 2, box.y + 60);
            await front.until(`Number(${card}.dataset.steps) > 5`, 20, 'it does not move under the pointer');
            await front.mouse('mouseMoved', 2, 2);
            await front.until(`!document.querySelector('.card canvas')`, 5, 'it still moves when the pointer has left');
            if (front.complaints.length) fault = front.complaints[0];
        } catch (error) {
            fault = error.message;
        }
        console.log(`${fault ? 'FAULT ' : 'ok    '} index.html: card ${i + 1} of ${count}${fault ? ': ' + fault : ''}`);
        fault ? ++failed : ++passed;
    }
    await front.close();
    // With reduced motion nothing moves without a click.
    const page = await browser.page();
    await page.open(pathToFileURL(join(folder, 'index.html')).href, {width: 1280, still: true});
    await wait(1);
    const moves = await page.value(`[...document.querySelectorAll('.demo')].some(one => 'state' in one.dataset)`);
    console.log(`${moves ? 'FAULT ' : 'ok    '} index.html: nothing moves by itself where motion is not wanted`);
    moves ? ++failed : ++passed;
} catch (error) {
    ++failed;
    console.log(`FAULT  ${error.message}`);
}
await browser.close();
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed || !passed ? 1 : 0);
