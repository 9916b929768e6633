// Which ground is dry though it lies below the sea, on the graphics side: 1 there, 0 where water covers what is low.
import {
  ClampToEdgeWrapping, DataTexture, LinearFilter, LinearMipmapNearestFilter, RedFormat, UnsignedByteType,
} from "three";

export function dryTexture(dry: Uint8Array, columns: number, rows: number): DataTexture {
  const texture = new DataTexture(dry as Uint8Array<ArrayBuffer>, columns, rows, RedFormat, UnsignedByteType);
  texture.unpackAlignment = 1;
  texture.wrapS = texture.wrapT = ClampToEdgeWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapNearestFilter;
  texture.generateMipmaps = true;
  texture.needsUpdate = true;
  return texture;
}

/** All water is sea. */
export const nowhere = dryTexture(new Uint8Array(1), 1, 1);
