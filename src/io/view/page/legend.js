// What the colours of a measure mean.

const tickText = (tick) => (tick === "" ? "" : short(tick));

function makeLegend() {
    const root = make("div.legend", { hidden: true });
    return {
        root,
        show(scale) {
            root.hidden = !scale;
            if (!scale) return;
            const ramp = make("div.ramp");
            ramp.style.background = `linear-gradient(90deg, ${scale.ramp.map(cssColour).join(", ")})`;
            root.replaceChildren(
                make("div", {}, scale.title),
                ramp,
                make("div.ticks", {}, ...scale.ticks.map((tick) => make("span", {}, tickText(tick)))),
            );
        },
    };
}

// The same in a picture that is saved: at the left below, `unit` pixels for each of the page.
function drawLegend(scale, context, unit) {
    const [left, width, text] = [16 * unit, 250 * unit, 12 * unit];
    const low = context.canvas.height - 16 * unit;
    const bar = { top: low - text - 16 * unit, height: 10 * unit };
    const gradient = context.createLinearGradient(left, 0, left + width, 0);
    scale.ramp.forEach((colour, i) => gradient.addColorStop(i / (scale.ramp.length - 1), cssColour(colour)));
    context.fillStyle = gradient;
    context.fillRect(left, bar.top, width, bar.height);
    context.fillStyle = getComputedStyle(document.body).color;
    context.font = `${text}px ${getComputedStyle(document.body).fontFamily}`;
    context.fillText(scale.title, left, bar.top - 6 * unit);
    scale.ticks.forEach((tick, i) => {
        const share = i / (scale.ticks.length - 1);
        context.textAlign = share === 0 ? "left" : share === 1 ? "right" : "center";
        context.fillText(tickText(tick), left + share * width, low);
    });
}
