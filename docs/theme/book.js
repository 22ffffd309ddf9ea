// The site's own script: how MathJax sets the equations, and the theme's switches.
// Nothing here or in what it starts asks for a file outside of this folder.

window.MathJax = {
    svg: {fontCache: 'global', mtextInheritFont: true, displayAlign: 'center', scale: 1},
    tex: {tags: 'none'},
    options: {
        enableMenu: false,  // its settings would load further files
        ignoreHtmlClass: 'fragment|tex2jax_ignore',
        processHtmlClass: 'tex2jax_process'
    },
    chtml: {},
    startup: {
        ready() {
            MathJax.startup.defaultReady();
            // An equation that a link names moves when the equations above it are set.
            MathJax.startup.promise.then(() => {
                const target = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
                if (target) target.scrollIntoView();
                document.documentElement.classList.add('equations-set');
            });
        }
    }
};

function book_start() {
    DoxygenAwesomeDarkModeToggle.init();
    DoxygenAwesomeFragmentCopyButton.init();
    DoxygenAwesomeParagraphLink.init();
    // The sidebar opens the sections of the chapter that is read.
    window.addEventListener('load', () => {
        let tries = 0;
        const open = () => {
            const row = document.querySelector('#nav-tree .item.selected');
            if (!row && tries++ < 40) return setTimeout(open, 50);
            const arrow = row && row.querySelector('span.arrow');
            const closed = row && row.parentNode && !row.parentNode.querySelector('ul.children_ul li');
            if (arrow && arrow.parentNode.href && closed && /\/ch\d\d_/.test(location.pathname)) arrow.parentNode.click();
        };
        open();
    });
    // Wide tables scroll in a box of their own.
    document.addEventListener('DOMContentLoaded', () => {
        for (const table of document.querySelectorAll('.contents table.markdownTable, .contents table.doxtable')) {
            const box = document.createElement('div');
            box.className = 'tablebox';
            table.parentNode.insertBefore(box, table);
            box.appendChild(table);
        }
    });
}
