import assert from "node:assert/strict";
import { test } from "node:test";
import { readRaster, takeToken } from "./client";
import { splitLines } from "./lines";

test("lines are whole wherever the bytes are cut, letters too", () => {
  const bytes = new TextEncoder().encode('{"a":"é"}\n\n{"b":2}\n{"c"');
  const lines: string[] = [];
  const take = splitLines((line) => lines.push(line));
  for (const byte of bytes) take(Uint8Array.of(byte));
  assert.deepEqual(lines, ['{"a":"é"}', '{"b":2}']);
});

test("rasters have the type that their header says", () => {
  const floats = readRaster("2 1 f32", new Float32Array([1.5, NaN]).buffer);
  assert.deepEqual([floats.columns, floats.rows, floats.values[0]], [2, 1, 1.5]);
  assert.ok(readRaster("1 1 u8", new Uint8Array([3]).buffer).values instanceof Uint8Array);
  assert.throws(() => readRaster(null, new ArrayBuffer(4)));
});

test("the token is taken out of the address and kept for the window", () => {
  const kept = new Map<string, string>();
  const storage = {
    getItem: (name: string) => kept.get(name) ?? null, setItem: (name: string, value: string) => kept.set(name, value),
  };
  const places: string[] = [];
  const history = { replaceState: (_data: unknown, _title: string, place: string) => places.push(place) };
  const take = (hash: string) => takeToken(
    { hash, pathname: "/", search: "" } as Location, history as unknown as History, storage as unknown as Storage,
  );
  assert.equal(take(""), null);
  assert.equal(take("#token=0123456789abcdefXYZ"), "0123456789abcdefXYZ");
  assert.deepEqual(places, ["/"]);
  assert.equal(take(""), "0123456789abcdefXYZ");
  assert.equal(take("#0123456789abcdef0"), "0123456789abcdef0");
});
