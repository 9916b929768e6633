import assert from "node:assert/strict";
import { test } from "node:test";
import {
  approach, axes, confined, direction, dot, fieldOfView, frame, orbit, pan, project, type Eye, type Vector,
} from "./world_camera";

const lens = { width: 900, height: 600, fov: fieldOfView };
const eye: Eye = { at: [100, -2000, 900], azimuth: 0.3, pitch: -0.4 };
const near = (a: number, b: number, by = 1e-6): void => assert.ok(Math.abs(a - b) <= by, `${a} is not ${b}`);

test("axes are right-handed, of unit length and square", () => {
  const { forward, right, up } = axes(eye);
  near(dot(forward, forward), 1);
  near(dot(forward, right), 0);
  near(dot(right, up), 0);
  near(dot(forward, up), 0);
  assert.ok(up[2] > 0);
});

test("a place is projected back to the pixel it was seen through", () => {
  const d = direction(eye, lens, 200, 450);
  const place: Vector = [eye.at[0] + 700 * d[0], eye.at[1] + 700 * d[1], eye.at[2] + 700 * d[2]];
  const [x, y, depth] = project(eye, lens, place)!;
  near(x, 200);
  near(y, 450);
  near(depth, 700);
  assert.equal(project(eye, lens, [eye.at[0] - d[0], eye.at[1] - d[1], eye.at[2] - d[2]]), null);
});

test("the pivot of an orbit stays where it is in the picture", () => {
  const d = direction(eye, lens, 700, 400);
  const pivot: Vector = [eye.at[0] + 1500 * d[0], eye.at[1] + 1500 * d[1], eye.at[2] + 1500 * d[2]];
  const [x, y, depth] = project(orbit(eye, pivot, 0.7, -0.3), lens, pivot)!;
  near(x, 700, 1e-6);
  near(y, 400, 1e-6);
  near(depth, 1500, 1e-6);
});

test("a panned place follows the pointer, an approached one stays under it", () => {
  const d = direction(eye, lens, 300, 300);
  const place: Vector = [eye.at[0] + 900 * d[0], eye.at[1] + 900 * d[1], eye.at[2] + 900 * d[2]];
  const moved = project(pan(eye, lens, 900, 40, -25), lens, place)!;
  near(moved[0], 340);
  near(moved[1], 275);
  const close = project(approach(eye, place, 0.5, 1), lens, place)!;
  near(close[0], 300);
  near(close[2], 450);
});

test("a framed box is in the picture and fills it", () => {
  const box = { low: [-5000, -4000, -300] as const, high: [5000, 4000, 1500] as const };
  const from = frame(box, lens, 0.4, -0.5);
  let edge = 0;
  for (let corner = 0; corner < 8; ++corner) {
    const [x, y] = project(from, lens, [
      (corner & 1 ? box.high : box.low)[0], (corner & 2 ? box.high : box.low)[1], (corner & 4 ? box.high : box.low)[2],
    ])!;
    assert.ok(x >= 0 && x <= 900 && y >= 0 && y <= 600);
    edge = Math.max(edge, Math.abs(x - 450) / 450, Math.abs(y - 300) / 300);
  }
  assert.ok(edge > 0.9);
});

test("an eye stays over the ground and near the terrain", () => {
  const box = { low: [0, 0, 0] as const, high: [1000, 1000, 100] as const };
  near(confined({ at: [500, 500, 10], azimuth: 0, pitch: 0 }, box, () => 80, 5).at[2], 85);
  const far = confined({ at: [1e6, 500, 10], azimuth: 0, pitch: 0 }, box, () => -10, 5);
  assert.ok(far.at[0] < 7000);
});
