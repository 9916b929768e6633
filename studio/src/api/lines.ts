// Lines of text out of a stream of bytes that may be cut anywhere.

/** Takes pieces; calls `line` for each whole line that is not empty. */
export function splitLines(line: (text: string) => void): (piece: Uint8Array) => void {
  const decoder = new TextDecoder();
  let rest = "";
  return (piece) => {
    const parts = (rest + decoder.decode(piece, { stream: true })).split("\n");
    rest = parts.pop() ?? "";
    for (const part of parts) if (part.trim() !== "") line(part);
  };
}
