// Arrays packed as base64: little-endian, as the program and every machine with a browser hold them.

export function bytes(text: string): Uint8Array {
  const raw = atob(text);
  const out = new Uint8Array(raw.length);
  for (let k = 0; k < raw.length; ++k) out[k] = raw.charCodeAt(k);
  return out;
}

export function words(text: string): Uint16Array {
  return new Uint16Array(bytes(text).buffer);
}

export function longs(text: string): Uint32Array {
  return new Uint32Array(bytes(text).buffer);
}
