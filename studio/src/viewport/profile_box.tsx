// Keeps the profile of a line on a view: drawn anew for other ground, gone without a line.
import { render } from "preact";
import type { Places } from "./drape";
import { profileAlong } from "./profile";
import { Profile } from "./profile_view";

export class ProfileBox {
  private line: Places | null = null;
  private readonly box = document.createElement("div");

  constructor(
    private readonly host: () => HTMLElement,
    private readonly heightAt: (x: number, y: number) => number | null,
    private readonly pointed: (place: readonly [number, number] | null) => void,
  ) {
    this.box.className = "view-profile-place";
    // What is done on the profile is not done on the ground under it.
    for (const type of ["pointerdown", "pointermove", "wheel", "dblclick"] as const) {
      this.box.addEventListener(type, (event) => event.stopPropagation());
    }
  }

  show(line: Places | null): void {
    this.line = line === null || line.length < 2 ? null : line;
    this.update();
  }

  update(): void {
    const data = this.line === null ? null : profileAlong(this.line, this.heightAt);
    if (data === null) {
      render(null, this.box);
      this.box.remove();
      this.pointed(null);
      return;
    }
    const host = this.host();
    if (this.box.parentElement !== host) host.append(this.box);
    const width = Math.max(260, Math.min(620, host.clientWidth - 24));
    const height = Math.max(120, Math.min(180, 0.35 * host.clientHeight));
    render(
      <Profile data={data} width={width} height={height} pointed={this.pointed} close={() => this.show(null)} />,
      this.box,
    );
  }

  dispose(): void {
    render(null, this.box);
    this.box.remove();
  }
}
