'use strict';

// Bytes of base64. Browsers without a function of their own take it in parts, since a long text would fill their stack.
function bytesOfBase64(text) {
    if (Uint8Array.fromBase64) {
        return Uint8Array.fromBase64(text);
    }
    const part = 1 << 20;
    const bytes = new Uint8Array(Math.floor(text.length / 4) * 3);
    let length = 0;
    for (let at = 0; at < text.length; at += part) {
        const piece = atob(text.slice(at, at + part));
        for (let i = 0; i < piece.length; ++i) {
            bytes[length++] = piece.charCodeAt(i);
        }
    }
    return bytes.subarray(0, length);
}

async function inflated(bytes, size) {
    const whole = new Uint8Array(size);
    const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate')).getReader();
    let length = 0;
    for (let next = await reader.read(); !next.done; next = await reader.read()) {
        whole.set(next.value, length);
        length += next.value.length;
    }
    if (length !== size) {
        throw new Error(`${length} / ${size}`);
    }
    return whole;
}

// Takes integers off bytes: seven bits a byte, the least first, the lowest bit is the sign.
class IntegerReader {
    constructor(bytes) {
        this.bytes = bytes;
        this.at = 0;
    }

    next() {
        const bytes = this.bytes;
        let byte = bytes[this.at++];
        if (byte < 128) {
            return (byte >>> 1) ^ -(byte & 1);
        }
        let value = byte & 127;
        let scale = 128;
        do {
            byte = bytes[this.at++];
            value += (byte & 127) * scale;
            scale *= 128;
        } while (byte >= 128);
        return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
    }

    // Numbers of which zeros in a row are kept as the first and how many more follow; what they go into is all zero before.
    runs(out, first, count) {
        for (let i = first; i < first + count; ++i) {
            out[i] = this.next();
            if (out[i] === 0) {
                i += this.next();
            }
        }
    }
}

// The named arrays of the page.
class PageArrays {
    constructor(bytes, contents) {
        this.bytes = bytes;
        this.contents = contents;
    }

    numbers(name) {
        const entry = this.contents[name];
        const offset = this.bytes.byteOffset + entry.at;
        if (entry.type === 'f64') {
            return new Float64Array(this.bytes.buffer, offset, entry.count);
        }
        if (entry.type === 'f32') {
            return new Float32Array(this.bytes.buffer, offset, entry.count);
        }
        return new Uint8Array(this.bytes.buffer, offset, entry.count);
    }

    reader(name) {
        const entry = this.contents[name];
        return new IntegerReader(this.bytes.subarray(entry.at, entry.at + entry.bytes));
    }

    integers(name, Type) {
        const reader = this.reader(name);
        const out = new Type(this.contents[name].count);
        for (let i = 0; i < out.length; ++i) {
            out[i] = reader.next();
        }
        return out;
    }

    // Places of three numbers, each kept as its difference to the one before, in steps of so many metres.
    places(name, step) {
        const reader = this.reader(name);
        const out = new Float32Array(this.contents[name].count);
        for (let i = 0, x = 0, y = 0, z = 0; i < out.length; i += 3) {
            x += reader.next();
            y += reader.next();
            z += reader.next();
            out[i] = x * step;
            out[i + 1] = y * step;
            out[i + 2] = z * step;
        }
        return out;
    }

    // Numbers that were kept as differences to the one before.
    steps(name, Type) {
        const out = this.integers(name, Type);
        for (let i = 1; i < out.length; ++i) {
            out[i] += out[i - 1];
        }
        return out;
    }
}

// Index of the last number of an ascending array at or below a value; 0 if there is none.
function lastAtOrBelow(ascending, value) {
    let low = 0;
    let high = ascending.length - 1;
    while (low < high) {
        const middle = (low + high + 1) >> 1;
        if (ascending[middle] <= value) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    return low;
}

// The numbers that some lists have, each once, ascending. Lists name one number many times in a row.
function distinct(...lists) {
    const found = new Set();
    for (const list of lists) {
        let last = NaN;
        for (let i = 0; i < list.length; ++i) {
            if (list[i] !== last) {
                last = list[i];
                found.add(last);
            }
        }
    }
    return Float64Array.from(found).sort();
}
