import assert from "node:assert/strict";
import { test } from "node:test";
import type { Edit } from "../api/types";
import { Gesture } from "./gesture";

class Paper {
  readonly sent: { edits: Edit[]; label: string; gesture: string | undefined }[] = [];
  undone = 0;
  answer = true;
  frames: (() => void)[] = [];
  edit(edits: Edit[], label: string, gesture?: string): Promise<boolean> {
    this.sent.push({ edits, label, gesture });
    return Promise.resolve(this.answer);
  }
  undo(): Promise<boolean> {
    ++this.undone;
    return Promise.resolve(true);
  }
  frame = (run: () => void) => void this.frames.push(run);
  tick(): void {
    for (const run of this.frames.splice(0)) run();
  }
}

const set = (value: number) => (): Edit[] => [{ do: "set", pointer: "/seed", value }];

test("one batch a frame, the newest, and all under one name", async () => {
  const paper = new Paper();
  const gesture = new Gesture(paper, "isle: seed", paper.frame);
  gesture.live(set(1));
  gesture.live(set(2));
  paper.tick();
  gesture.live(set(3));
  assert.equal(await gesture.finish(set(4)), true);
  paper.tick();
  assert.deepEqual(paper.sent.map(({ edits }) => (edits[0] as { value: number }).value), [2, 4]);
  assert.equal(new Set(paper.sent.map((s) => s.gesture)).size, 1);
});

test("cancelled before anything was sent nothing is taken back; after that, once", async () => {
  const paper = new Paper();
  const early = new Gesture(paper, "a", paper.frame);
  early.live(set(1));
  await early.cancel();
  paper.tick();
  assert.deepEqual([paper.sent.length, paper.undone], [0, 0]);
  const late = new Gesture(paper, "b", paper.frame);
  late.live(set(1));
  paper.tick();
  await late.cancel();
  await late.cancel();
  assert.equal(paper.undone, 1);
});

test("what was refused is not taken back, and the end says so", async () => {
  const paper = new Paper();
  paper.answer = false;
  const gesture = new Gesture(paper, "a", paper.frame);
  gesture.live(set(1));
  paper.tick();
  assert.equal(await gesture.finish(), false);
  const again = new Gesture(paper, "a", paper.frame);
  again.live(set(1));
  paper.tick();
  await again.cancel();
  assert.equal(paper.undone, 0);
});
