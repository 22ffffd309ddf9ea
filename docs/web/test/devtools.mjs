// A browser of the system's, without a window, over the pipes of its DevTools protocol: no package is needed.
import {spawn} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

export class Browser {
    constructor(program = process.env.CHROMIUM || 'chromium') {
        this.folder = mkdtempSync(join(tmpdir(), 'rigid-browser-'));
        this.process = spawn(program, ['--headless=new', '--remote-debugging-pipe', '--no-sandbox', '--no-first-run', '--disable-gpu',
                                       '--disable-dev-shm-usage', '--disable-background-networking', '--disable-component-update',
                                       '--disable-sync', '--disable-extensions', '--hide-scrollbars', '--mute-audio',
                                       '--user-data-dir=' + this.folder],
                             {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
        this.next = 0;
        this.patience = 60;  // seconds that an answer may take
        this.waiting = new Map();
        this.listeners = [];
        let rest = '';
        this.process.stdio[4].setEncoding('utf8').on('data', text => {
            const parts = (rest + text).split('\0');
            rest = parts.pop();
            for (const part of parts) this.take(JSON.parse(part));
        });
        this.process.on('exit', code => this.end(new Error(`the browser ended with ${code}`)));
        this.process.on('error', error => this.end(error));
        this.process.stdio[3].on('error', () => {});
    }
    end(error) {
        for (const {fail} of this.waiting.values()) fail(error);
        this.waiting.clear();
    }
    take(message) {
        const answer = this.waiting.get(message.id);
        if (!answer) return this.listeners.forEach(listener => listener(message));
        this.waiting.delete(message.id);
        if (message.error) answer.fail(new Error(message.error.message));
        else answer.done(message.result);
    }
    send(method, params = {}, sessionId) {
        const id = ++this.next;
        return new Promise((done, fail) => {
            const late = setTimeout(() => { this.waiting.delete(id); fail(new Error(`${method} took more than ${this.patience} s`)); }, 1000 * this.patience);
            this.waiting.set(id, {done: value => { clearTimeout(late); done(value); }, fail: error => { clearTimeout(late); fail(error); }});
            this.process.stdio[3].write(JSON.stringify({id, method, params, sessionId}) + '\0');
        });
    }
    async page() {
        const {targetId} = await this.send('Target.createTarget', {url: 'about:blank'});
        const {sessionId} = await this.send('Target.attachToTarget', {targetId, flatten: true});
        const page = new Page(this, targetId, sessionId);
        for (const domain of ['Page', 'Runtime', 'Log', 'Network', 'Performance']) await page.send(domain + '.enable');
        return page;
    }
    async close() {
        // It writes into its folder until it has ended.
        const ended = this.process.exitCode !== null || new Promise(done => this.process.once('exit', done));
        await this.send('Browser.close').catch(() => {});
        const late = setTimeout(() => this.process.kill('SIGKILL'), 10000);
        await ended;
        clearTimeout(late);
        rmSync(this.folder, {recursive: true, force: true, maxRetries: 20, retryDelay: 100});
    }
}

export class Page {
    constructor(browser, target, session) {
        Object.assign(this, {browser, target, session, complaints: [], requests: []});
        browser.listeners.push(this.listener = message => { if (message.sessionId === session) this.hear(message.method, message.params); });
    }
    hear(method, params) {
        if (method === 'Runtime.exceptionThrown')
            this.complaints.push(params.exceptionDetails.exception?.description || params.exceptionDetails.text);
        if (method === 'Runtime.consoleAPICalled' && ['error', 'warning', 'assert'].includes(params.type))
            this.complaints.push(params.args.map(one => one.value ?? one.description).join(' '));
        if (method === 'Log.entryAdded' && ['error', 'warning'].includes(params.entry.level)) this.complaints.push(params.entry.text + ' ' + (params.entry.url || ''));
        if (method === 'Network.requestWillBeSent') this.requests.push(params.request.url);
        if (method === 'Page.loadEventFired') this.loaded?.();
    }
    send(method, params) { return this.browser.send(method, params, this.session); }
    async open(url, {width, height = 900, dark = false, still = false, touch = false}) {
        await this.send('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: 1, mobile: touch});
        await this.send('Emulation.setTouchEmulationEnabled', {enabled: touch});
        await this.send('Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value: dark ? 'dark' : 'light'},
                                                                  {name: 'prefers-reduced-motion', value: still ? 'reduce' : 'no-preference'}]});
        const loaded = new Promise(done => { this.loaded = done; });
        await this.send('Page.navigate', {url});
        await loaded;
    }
    // The value of an expression, awaited.
    async value(expression) {
        const {result, exceptionDetails} = await this.send('Runtime.evaluate', {expression, awaitPromise: true, returnByValue: true});
        if (exceptionDetails) throw new Error(exceptionDetails.exception?.description || exceptionDetails.text);
        return result.value;
    }
    // Waits until an expression is true; a limit in seconds.
    async until(expression, seconds, what) {
        const end = Date.now() + 1000 * seconds;
        while (!await this.value(expression)) {
            if (Date.now() > end) throw new Error(`${what} (waited ${seconds} s)`);
            await new Promise(done => setTimeout(done, 50));
        }
    }
    mouse(type, x, y, held = false) {
        return this.send('Input.dispatchMouseEvent', {type, x, y, button: type === 'mouseMoved' && !held ? 'none' : 'left', buttons: held ? 1 : 0, clickCount: 1});
    }
    touch(type, ...points) { return this.send('Input.dispatchTouchEvent', {type, touchPoints: points.map(([x, y]) => ({x, y}))}); }
    async key(key, code = key) {
        await this.send('Input.dispatchKeyEvent', {type: 'keyDown', key, code, text: key.length === 1 ? key : undefined});
        await this.send('Input.dispatchKeyEvent', {type: 'keyUp', key, code});
    }
    async close() {
        this.browser.listeners.splice(this.browser.listeners.indexOf(this.listener), 1);
        await this.browser.send('Target.closeTarget', {targetId: this.target});
    }
}
