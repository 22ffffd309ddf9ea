// A chapter's program as it was compiled for a page (common/program/web_program.cpp): how its code is unpacked, what it
// gets from its surroundings (a clock, and nothing else), and its functions with texts and errors as JavaScript has them.
// A plain script: it runs in a page opened as a file, and in node.
'use strict';

(function (space) {
    const waiting = {}; // program: what to do when its code comes

    // The code of a program is a script that calls this (pack.py): its sizes, and wasm in streams, LZMA, base64.
    space.rigid_code = (program, sizes, packed) => { if (waiting[program]) waiting[program](unpacked(sizes, packed)); };

    function unpacked(sizes, packed) {
        const text = atob(packed), bytes = new Uint8Array(text.length);
        for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
        return rigid_join(rigid_unpack(bytes, sizes.slice(1).reduce((a, b) => a + b)), sizes);
    }

    // The compiled code of each program, asked for once.
    const modules = {};
    function module_of(program, folder) {
        modules[program] = modules[program] || new Promise((done, fail) => {
            if (typeof WebAssembly !== 'object') return fail(new Error('This browser has no WebAssembly, and the demo needs it.'));
            waiting[program] = code => WebAssembly.compile(code).then(done, fail);
            const script = document.createElement('script');
            script.src = folder + program + '.js';
            script.onerror = () => fail(new Error('The demo could not be loaded: ' + script.src + ' is missing.'));
            document.head.appendChild(script);
        });
        return modules[program];
    }

    class Machine {
        // `code` is a compiled module.
        static async of(code) {
            const machine = new Machine();
            const imports = {};
            for (const {module, name} of WebAssembly.Module.imports(code)) {
                imports[module] = imports[module] || {};
                imports[module][name] = machine.surroundings()[name] || (() => 52); // "there is no such thing here"
            }
            machine.api = (await WebAssembly.instantiate(code, imports)).exports;
            machine.api._initialize();
            machine.attempt('web_start');
            machine.program = JSON.parse(machine.text(machine.api.web_description()));
            return machine;
        }

        surroundings() {
            const view = () => new DataView(this.api.memory.buffer);
            return {
                clock_time_get: (id, precision, place) => {
                    view().setBigUint64(place, BigInt(Math.round(performance.now() * 1e6)), true);
                    return 0;
                },
                fd_write: (file, list, count, written) => { // no program prints in a page; if one does, it shows
                    let all = 0, text = '';
                    for (let i = 0; i < count; ++i) {
                        const place = view().getUint32(list + 8 * i, true), size = view().getUint32(list + 8 * i + 4, true);
                        text += new TextDecoder().decode(new Uint8Array(this.api.memory.buffer, place, size).slice());
                        all += size;
                    }
                    view().setUint32(written, all, true);
                    console.warn(text);
                    return 0;
                },
                proc_exit: code => { throw new Error('the program ended with ' + code); },
                emscripten_notify_memory_growth: () => {}
            };
        }

        text(place) {
            const bytes = new Uint8Array(this.api.memory.buffer, place);
            return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
        }

        // The next function reads this text.
        send(text) {
            const bytes = new TextEncoder().encode(text);
            const place = this.api.web_text(bytes.length); // first: it may move the memory
            new Uint8Array(this.api.memory.buffer, place, bytes.length).set(bytes);
            return this;
        }

        attempt(name, ...numbers) {
            if (this.api[name](...numbers) !== 0) throw new Error(this.text(this.api.web_sentence()));
            return this;
        }

        // What the next show, or the next run, begins with.
        choose({scene = '', methods = [], settings = {}}) {
            this.send(scene).attempt('web_choose');
            for (const method of methods) this.send(method).attempt('web_with_method');
            for (const [name, value] of Object.entries(settings)) this.send(name).attempt('web_with_setting', value);
            return this;
        }

        is_over() { return this.api.web_over() !== 0; }
        state() { return JSON.parse(this.text(this.api.web_state())); }

        // {numbers, words} of a draw list (common/draw_list.hpp); good until the next call.
        list(name, ...numbers) {
            const count = this.api[name](...numbers);
            return {numbers: new Float32Array(this.api.memory.buffer, this.api.web_numbers(), count),
                    words: this.text(this.api.web_words()).split('\n')};
        }

        // The rows of a run without a window, as numbers.
        run(steps) {
            const count = this.api.web_run(steps);
            return new Float64Array(this.api.memory.buffer, this.api.web_rows(), count).slice();
        }
    }

    space.RigidMachine = Machine;
    space.rigid_module = module_of;
    space.rigid_unpacked = unpacked;
})(globalThis);
