// The search box: the words of the chapters and the names in the code, found by MiniSearch in search_texts.js, which
// docs/tools/search_texts.py writes. Both are fetched when the box is first used, by script tags, so that it works
// from a folder too.
(() => {
    'use strict';
    const shown = 12;
    let index = null, entries = [];

    function load(file) {
        return new Promise((done, failed) => {
            const script = document.createElement('script');
            script.src = file;
            script.onload = done;
            script.onerror = () => failed(new Error(file + ' was not found'));
            document.head.appendChild(script);
        });
    }

    // "Gauß" is found as "gauss", "Müller" as "muller", "λ_n" as it is.
    const plain = word => word.toLowerCase().replace('ß', 'ss').normalize('NFD').replace(/\p{M}/gu, '');

    async function make_index() {
        await load('minisearch.js');
        await load('search_texts.js');
        entries = window.book_search_texts;
        index = new MiniSearch({fields: ['title', 'text'], idField: 'place', processTerm: word => plain(word) || null});
        index.addAll(entries.map((entry, place) => ({...entry, place})));
    }

    // Words that begin so, in every entry all of them; a letter may be wrong where nothing is found without.
    // A section that has the word in its title comes first; chapters come before the other texts, names of the code last.
    function find(words) {
        const options = {
            boost: {title: 3}, combineWith: 'AND', prefix: true,
            boostDocument: place => !entries[place].text ? 1 : /^ch\d\d/.test(entries[place].address) ? 3 : 2
        };
        const found = index.search(words, options);
        return found.length ? found : index.search(words, {...options, fuzzy: 0.2});
    }

    // A piece of the text around the first word that was found, in parts: [words, were they asked for].
    function excerpt(text, terms) {
        const words = text.split(' ');
        const asked = words.map(word => terms.some(term => plain(word).includes(term)));
        const first = Math.max(0, asked.indexOf(true) - 8);
        const parts = words.slice(first, first + 28).map((word, k) => [word, asked[first + k]]);
        return {parts, before: first > 0, after: first + 28 < words.length};
    }

    function row_of(hit) {
        const entry = entries[hit.id], row = document.createElement('a'), title = document.createElement('b');
        row.href = entry.address;
        row.setAttribute('role', 'option');
        title.textContent = entry.title;
        row.append(title);
        const where = document.createElement('span');
        where.textContent = entry.page;
        row.append(where);
        if (entry.text) {
            const words = document.createElement('p'), {parts, before, after} = excerpt(entry.text, hit.terms);
            words.append(before ? '… ' : '');
            for (const [word, asked] of parts) {
                const piece = document.createElement(asked ? 'mark' : 'span');
                piece.textContent = word;
                words.append(piece, ' ');
            }
            words.append(after ? '…' : '');
            row.append(words);
        }
        return row;
    }

    document.addEventListener('DOMContentLoaded', () => {
        const field = document.getElementById('search_field'), list = document.getElementById('search_hits');
        if (!field) return;
        let chosen = -1;
        const close = () => { list.hidden = true; field.setAttribute('aria-expanded', 'false'); };
        const choose = k => {
            const rows = list.querySelectorAll('a');
            if (!rows.length) return;
            if (chosen >= 0) rows[chosen].removeAttribute('aria-selected');
            chosen = (k + rows.length) % rows.length;
            rows[chosen].setAttribute('aria-selected', 'true');
            rows[chosen].scrollIntoView({block: 'nearest'});
        };
        async function show() {
            const words = field.value.trim();
            if (!words) return close();
            try {
                if (!index) await make_index();
            } catch (fault) {
                list.textContent = 'The search does not work: ' + fault.message + '.';
                list.hidden = false;
                return;
            }
            if (words !== field.value.trim()) return;  // more was typed meanwhile
            const found = find(words).slice(0, shown);
            chosen = -1;
            list.replaceChildren(...found.map(row_of));
            if (!found.length) list.textContent = 'Nothing has "' + words + '".';
            list.hidden = false;
            field.setAttribute('aria-expanded', 'true');
            choose(0);
        }
        field.addEventListener('input', show);
        field.addEventListener('focus', () => { if (field.value) show(); });
        field.addEventListener('keydown', event => {
            if (event.key === 'ArrowDown') choose(chosen + 1);
            else if (event.key === 'ArrowUp') choose(chosen - 1);
            else if (event.key === 'Enter') { const row = list.querySelector('[aria-selected]'); if (row) row.click(); }
            else if (event.key === 'Escape') { close(); field.blur(); }
            else return;
            event.preventDefault();
        });
        list.addEventListener('click', close);
        document.addEventListener('click', event => { if (!event.target.closest('#search')) close(); });
        document.addEventListener('keydown', event => {
            const typing = event.target.closest && event.target.closest('input, textarea, select, [contenteditable]');
            if (event.key === '/' && !typing && !event.ctrlKey && !event.metaKey) { field.focus(); event.preventDefault(); }
        });
    });
})();
