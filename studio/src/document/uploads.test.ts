import assert from "node:assert/strict";
import { test } from "node:test";
import type { Api } from "../api/api";
import { UploadCancelled, uploadFile, uploading } from "./uploads";

const file = { name: "peak.tif", size: 1000 } as File;

test("how much is sent is told, and nothing afterwards", async () => {
  const shares: number[] = [];
  const stop = uploading.subscribe((now) => now && shares.push(now.share));
  const upload: Api["upload"] = async (_name, _content, how) => {
    how?.progress?.(0.5);
    return { file: "files/peak.tif", kind: "terrain", info: {} };
  };
  assert.equal((await uploadFile({ upload }, file)).kind, "terrain");
  assert.deepEqual(shares, [0, 0.5]);
  assert.equal(uploading.value, null);
  stop();
});

test("a file that is called back is no mistake of the server", async () => {
  const upload: Api["upload"] = (_name, _content, how) => new Promise((_done, fail) => {
    how!.signal!.addEventListener("abort", () => fail(new Error("gone")));
  });
  const sent = uploadFile({ upload }, file);
  uploading.value!.cancel();
  await assert.rejects(sent, UploadCancelled);
  assert.equal(uploading.value, null);
});
