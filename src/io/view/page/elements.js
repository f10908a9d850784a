// Elements of the page. Texts are set as texts: whatever a name contains is shown and never read as HTML.

const byId = (id) => document.getElementById(id);

// make("td.text", { title: "..." }, "text", anotherElement)
function make(what, properties = {}, ...children) {
    const [tag, ...classes] = what.split(".");
    const element = document.createElement(tag);
    element.classList.add(...classes);
    for (const [name, value] of Object.entries(properties))
        if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
        else if (name in element) element[name] = value;
        else element.setAttribute(name, value);
    element.append(...children);
    return element;
}

function makeSvg(tag, attributes = {}, ...children) {
    const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
}

// A part of the panel that opens and closes.
function addSection(title, open, ...children) {
    const body = make("div.body", {}, ...children);
    const more = make("span.more");
    const section = make("details", { open }, make("summary", {}, title, " ", more), body);
    byId("panel").append(section);
    return { section, body, more };
}

function tableOf(heads, rows) {
    const cell = (kind, [text, ...classes]) =>
        make([kind, ...classes].join("."), kind === "th" ? { scope: "col" } : {}, text);
    return make(
        "table",
        {},
        make("thead", {}, make("tr", {}, ...heads.map((head) => cell("th", head)))),
        make("tbody", {}, ...rows.map((row) => make("tr", {}, ...row.map((text) => cell("td", text))))),
    );
}

const scrolling = (...children) => make("div.scroll", { tabIndex: 0 }, ...children);

function factsOf(pairs) {
    return make("dl.facts", {}, ...pairs.flatMap(([name, value]) => [make("dt", {}, name), make("dd", {}, value)]));
}

const whole = (number) => Math.round(number).toLocaleString("en-US");
// Four digits, as far as a number has them.
function short(number) {
    if (number === null || !Number.isFinite(number)) return "–";
    if (number !== 0 && (Math.abs(number) >= 1e7 || Math.abs(number) < 1e-3)) return number.toExponential(2);
    return Math.abs(number) >= 1e4 ? whole(number) : number.toLocaleString("en-US", { maximumSignificantDigits: 4 });
}

// An angle as everywhere: with one decimal.
const degrees = (angle) => (Number.isFinite(angle) ? `${angle.toFixed(1)}°` : "–");
const anglesText = (least, greatest) => `${degrees(least)} to ${degrees(greatest)}`;

function notice(text) {
    byId("notices").append(make("p.notice", {}, text));
}

function pressed(button, is) {
    button.setAttribute("aria-pressed", String(is));
}
