// The mesh of the ground: one grid of a patch with a skirt around it, drawn once for every chosen patch.
import {
  BufferAttribute, DynamicDrawUsage, InstancedBufferGeometry, InstancedInterleavedBuffer, InterleavedBufferAttribute,
} from "three";
import { patchCells, patchNumbers, type Patches } from "./patches";

const mostPatches = 1024;

function grid(): { positions: Float32Array; indices: Uint16Array; inner: number } {
  const side = patchCells + 1, positions: number[] = [], indices: number[] = [];
  for (let j = 0; j < side; ++j) for (let i = 0; i < side; ++i) positions.push(i, j, 0);
  for (let j = 0; j < patchCells; ++j) {
    for (let i = 0; i < patchCells; ++i) {
      const a = j * side + i, b = a + 1, c = a + side, d = c + 1;
      // Diagonals alternate, so that no direction is favoured.
      if ((i + j) % 2 === 0) indices.push(a, c, b, b, c, d);
      else indices.push(a, c, d, a, d, b);
    }
  }
  const inner = indices.length;
  // Once around the border, each vertex again one storey lower.
  const around: [number, number][] = [];
  for (let i = 0; i < patchCells; ++i) around.push([i, 0]);
  for (let j = 0; j < patchCells; ++j) around.push([patchCells, j]);
  for (let i = patchCells; i > 0; --i) around.push([i, patchCells]);
  for (let j = patchCells; j > 0; --j) around.push([0, j]);
  const first = side * side;
  for (const [i, j] of around) positions.push(i, j, 1);
  around.forEach(([i, j], k) => {
    const [ni, nj] = around[(k + 1) % around.length]!;
    const top = j * side + i, next = nj * side + ni, low = first + k, lowNext = first + ((k + 1) % around.length);
    indices.push(top, next, low, low, next, lowNext);
  });
  return { positions: new Float32Array(positions), indices: new Uint16Array(indices), inner };
}

export class PatchGeometry extends InstancedBufferGeometry {
  private readonly numbers = new Float32Array(mostPatches * patchNumbers);
  private readonly instances = new InstancedInterleavedBuffer(this.numbers, patchNumbers);
  /** Of one patch. */
  readonly triangles: number;

  constructor() {
    super();
    const { positions, indices, inner } = grid();
    this.triangles = indices.length / 3;
    this.setAttribute("position", new BufferAttribute(positions, 3));
    this.setIndex(new BufferAttribute(indices, 1));
    this.instances.setUsage(DynamicDrawUsage);
    this.setAttribute("patch_box", new InterleavedBufferAttribute(this.instances, 3, 0));
    this.setAttribute("patch_morph", new InterleavedBufferAttribute(this.instances, 2, 3));
    this.addGroup(0, inner, 0);
    this.addGroup(inner, indices.length - inner, 1);
    this.instanceCount = 0;
  }

  show(patches: Patches): void {
    this.instanceCount = Math.min(patches.count, mostPatches);
    if (this.instanceCount === 0) return;
    this.numbers.set(patches.numbers.subarray(0, this.instanceCount * patchNumbers));
    this.instances.clearUpdateRanges();
    this.instances.addUpdateRange(0, this.instanceCount * patchNumbers);
    this.instances.needsUpdate = true;
  }
}
