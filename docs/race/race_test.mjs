// The race in a real browser: it starts, runs, and its fixed run gives the table of docs/race.md.
//
//     node docs/race/race_test.mjs HTML_FOLDER [--write] [--shots DIR]
//
// Errors are compared as they are printed, with two digits; times are only shown. Where Box2D is not installed its lines are left
// out. --write puts what was found into docs/race/table.csv and docs/race.md.
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {Browser} from '../web/test/devtools.mjs';

const words = process.argv.slice(2), own = dirname(fileURLToPath(import.meta.url));
const option = name => words.includes(name) ? words.splice(words.indexOf(name), 2)[1] : '';
const shots = option('--shots');
const folder = resolve(words[0]), file = join(folder, 'race.html');
const place = `document.querySelector('.race')`;
let failed = 0;
const check = (right, what) => { console.log(`${right ? 'ok    ' : 'FAULT '} ${what}`); failed += right ? 0 : 1; };
const wait = seconds => new Promise(done => setTimeout(done, 1000 * seconds));
// Time that the page itself had of a processor, in seconds: other programs of the machine don't count.
const busy = async page => (await page.send('Performance.getMetrics')).metrics.find(one => one.name === 'ThreadTime').value;

const browser = new Browser();
try {
    for (const {width, dark} of [{width: 390, dark: false}, {width: 390, dark: true}, {width: 1280, dark: false}, {width: 1280, dark: true}]) {
        const page = await browser.page(), where = `${width} ${dark ? 'dark' : 'light'}`;
        await page.open(pathToFileURL(file).href, {width, dark, touch: width < 500});
        check(!await page.value(`'state' in ${place}.dataset`), `${where}: nothing runs before it is started`);
        await page.value(`${place}.querySelector('.demo-start').click()`);
        await page.until(`'state' in ${place}.dataset`, 20, 'it does not start');
        check(await page.value(`${place}.dataset.state`) === 'runs', `${where}: it starts`);
        await page.value(`${place}.scrollIntoView({block: 'start', behavior: 'instant'})`);
        const scenes = await page.value(`${place}.race.race.scenes.length`);
        for (let i = 0; i < scenes; ++i) {
            await page.value(`(() => { const race = ${place}.race; race.scene_list.selectedIndex = ${i}; race.choose(${i}); for (let k = 0; k < 100; ++k) race.step(); race.show(); })()`);
            const [name, steps, sentence] = await page.value(`[${place}.race.race.what.name, ${place}.race.steps, ${place}.race.sentence.textContent]`);
            check(steps >= 100 && !sentence, `${where}: ${name} makes 100 steps ${sentence}`);
            if (shots) {
                mkdirSync(shots, {recursive: true});
                const box = await page.value(`(() => { const box = ${place}.getBoundingClientRect(); return {x: Math.max(0, box.x), y: box.y + scrollY, width: Math.min(innerWidth, box.width), height: box.height}; })()`);
                const {data} = await page.send('Page.captureScreenshot', {format: 'png', captureBeyondViewport: true, clip: {...box, scale: 1}});
                writeFileSync(join(shots, `race_${name}_${width}_${dark ? 'dark' : 'light'}.png`), Buffer.from(data, 'base64'));
            }
        }
        await page.value(`${place}.race.set_playing(false)`);
        const before = await busy(page);
        await wait(1);
        const taken = await busy(page) - before;
        check(taken < 0.05, `${where}: paused it takes ${(100 * taken).toFixed(1)} % of a processor`);
        const nameless = await page.value(`[...${place}.querySelectorAll('button, select, canvas')].filter(one => !one.getAttribute('aria-label') && !(one.tagName === 'BUTTON' && one.textContent.trim())).length`);
        check(nameless === 0, `${where}: all controls have names`);
        const room = await page.value(`[document.documentElement.scrollWidth, innerWidth]`);
        check(room[0] <= room[1] + 1, `${where}: the page is no wider than the screen (${room})`);
        if (width > 500 && dark) await table(page);
        check(page.complaints.length === 0, `${where}: no word in the console ${page.complaints.join(' | ')}`);
        const outside = page.requests.filter(one => !/^(file|data|blob):/.test(one));
        check(outside.length === 0, `${where}: no request leaves ${outside.join(' ')}`);
        await page.close();
    }
} catch (error) {
    check(false, error.message);
}
await browser.close();
process.exit(failed ? 1 : 0);

async function table(page) {
    const asked = Date.now();
    // Not awaited by one call, which has a limit of its own.
    await page.value(`void ${place}.race.make_table()`);
    await page.until(`'table' in ${place}.dataset`, 240, 'the fixed run does not end');
    const found = JSON.parse(await page.value(`${place}.dataset.table`));
    console.log(`the fixed run took ${((Date.now() - asked) / 1000).toFixed(0)} s`);
    const printed = await page.value(`${place}.dataset.table && JSON.parse(${place}.dataset.table).map(line => rigid_race.length(line.error === null ? Infinity : line.error))`);
    const lines = found.map((line, i) => ({...line, error: printed[i]}));
    for (const line of lines)
        console.log(`       ${line.scene.padEnd(8)} ${line.who.padEnd(6)} ${line.method.padEnd(12)} ${String(line.substeps).padStart(2)}  error ${line.error.padStart(8)} m  ${line.time.toFixed(0).padStart(6)} µs a step`);
    const csv = join(own, 'table.csv');
    if (words.includes('--write')) {
        writeFileSync(csv, 'scene,who,method,substeps,error_m\n' +
                           lines.map(line => [line.scene, line.who, line.method, line.substeps, line.error].join(',') + '\n').join(''));
        const rows = lines.map((line, i) => `| ${i && lines[i - 1].scene === line.scene ? '' : line.title} | ${line.who} | ${line.method} | ${line.substeps} | ${line.error} |`);
        const text = join(own, '../race.md'), old = readFileSync(text, 'utf8');
        writeFileSync(text, old.replace(/(\| scene \|.*\n\|[-:| ]*\n)(\|.*\n)*/, (all, head) => head + rows.join('\n') + '\n'));
        return;
    }
    const known = new Map(readFileSync(csv, 'utf8').trim().split('\n').slice(1).map(row => row.split(',')).map(row => [row.slice(0, 4).join(' '), row[4]]));
    const with_box = lines.some(line => line.who === 'Box2D');
    if (!with_box) console.log('       Box2D is not installed (./book setup peers): its lines are left out');
    for (const line of lines) {
        const name = [line.scene, line.who, line.method, line.substeps].join(' ');
        check(known.get(name) === line.error, `${name}: the error is ${line.error} m, in docs/race/table.csv ${known.get(name)} m`);
        known.delete(name);
    }
    const left = [...known.keys()].filter(name => with_box || !name.includes(' Box2D '));
    check(left.length === 0, `each line of docs/race/table.csv was run ${left.join(', ')}`);
}
