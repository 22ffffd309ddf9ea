// The chapters on the front page: where the pointer rests on a card, or the keys stand on it, the chapter's program runs in
// the place of its picture. Nothing is loaded before; nothing moves for whoever wants nothing to move.
'use strict';

(function () {
    const folder = new URL('.', document.currentScript.src).href;
    const colour_names = ['ink', 'faint', 'blue', 'orange', 'green', 'red', 'purple', 'yellow', 'ground', 'card', 'rim'];

    class Card {
        constructor(place) {
            this.place = place;
            this.frame = place.querySelector('.card-picture');
            this.still = this.frame.querySelector('img');
            place.addEventListener('pointerenter', event => { if (event.pointerType === 'mouse') this.start(); });
            place.addEventListener('pointerleave', () => this.stop());
            place.addEventListener('focusin', () => { if (place.querySelector('a:focus-visible')) this.start(); });
            place.addEventListener('focusout', () => this.stop());
        }

        async start() {
            const run = this.run = {};  // leaving meanwhile, or coming again, makes another
            const {program, scene, methods, settings} = this.place.dataset;
            try {
                await new Promise(done => setTimeout(done, 150));
                if (this.run !== run) return;
                const machine = await RigidMachine.of(await rigid_module(program, folder + 'demos/'));
                if (this.run !== run) return;
                machine.choose({scene, methods: methods.split(' ').filter(Boolean),
                                settings: Object.fromEntries(settings.split(' ').filter(Boolean).map(one => one.split('=')).map(([name, value]) => [name, Number(value)]))}).attempt('web_open');
                machine.api.web_script(1);
                const canvas = document.createElement('canvas'), fine = Math.min(window.devicePixelRatio || 1, 3);
                // As large as the still picture is, which is 800 wide.
                const wide = 800, high = Math.round(machine.api.web_height(wide, 460));
                const scale = Math.min(this.frame.clientWidth / wide, this.frame.clientHeight / high);
                canvas.width = Math.round(wide * scale * fine);
                canvas.height = Math.round(high * scale * fine);
                canvas.style.width = wide * scale + 'px';
                canvas.setAttribute('aria-hidden', 'true');
                const g = canvas.getContext('2d'), style = getComputedStyle(document.documentElement);
                const colours = colour_names.map(name => style.getPropertyValue('--demo-' + name).trim());
                const show = () => {
                    if (this.run !== run) return;
                    if (!machine.is_over()) machine.attempt('web_step');
                    g.setTransform(scale * fine, 0, 0, scale * fine, 0, 0);
                    g.clearRect(0, 0, wide, high);
                    rigid_paint(g, machine.list('web_picture', wide, high), colours);
                    this.place.dataset.steps = Number(this.place.dataset.steps || 0) + 1;
                    requestAnimationFrame(show);
                };
                show();
                this.still.hidden = true;
                this.frame.append(canvas);
            } catch (error) {
                this.stop();
                console.warn(error.message);
            }
        }

        stop() {
            this.run = null;
            this.still.hidden = false;
            for (const canvas of this.frame.querySelectorAll('canvas')) canvas.remove();
        }
    }

    document.addEventListener('DOMContentLoaded', () => {
        if (matchMedia('(prefers-reduced-motion: reduce)').matches) return;
        for (const place of document.querySelectorAll('.card[data-program]')) new Card(place);
    });
})();
