// Arrays out of the page: base64, inflated by the browser, four planes of bytes, differences (see packed_numbers.cpp).

async function inflate(text) {
    const letters = atob(text);
    const bytes = new Uint8Array(letters.length);
    for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
    const inflated = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(inflated).arrayBuffer());
}

// `inRow`: columns after the first are differences to the first of their row, else to the row before.
function undoDifferences(planes, columns, inRow) {
    const count = planes.length / 4;
    const numbers = new Int32Array(count);
    for (let i = 0; i < count; ++i) {
        const code =
            planes[i] | (planes[count + i] << 8) | (planes[2 * count + i] << 16) | (planes[3 * count + i] << 24);
        const column = i % columns;
        const before = inRow && column > 0 ? numbers[i - column] : i < columns ? 0 : numbers[i - columns];
        numbers[i] = before + ((code >>> 1) ^ -(code & 1));
    }
    return numbers;
}

// The element goes, as its text takes more memory than the array.
async function unpack(id, columns, inRow) {
    const element = document.getElementById(id);
    const text = element.textContent;
    element.remove();
    return text ? undoDifferences(await inflate(text), columns, inRow) : null;
}

function textOf(id) {
    const element = document.getElementById(id);
    const text = element.textContent;
    element.remove();
    return text;
}
