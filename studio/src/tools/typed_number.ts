// A height that is typed while a place is selected: every key is seen at once, Enter ends, Escape takes it back.
import type { Desk, PenKey } from "./desk";
import type { Feature } from "./features";
import type { Gesture } from "./gesture";
import { token } from "./place";

const kMembers = ["height_m", "peak_m"];

export class TypedNumber {
  private text = "";
  private gesture: Gesture | null = null;
  private feature: Feature | undefined;

  constructor(private readonly desk: Desk, private readonly of: () => Feature | undefined) {}

  private memberOf(feature: Feature): string | undefined {
    return kMembers.find((name) => feature.slot.members.some((member) => member.name === name));
  }

  key({ key, ctrl }: PenKey): boolean {
    if (ctrl) return false;
    if (this.text !== "" && (key === "Enter" || key === "Escape")) {
      if (key === "Enter") this.finish();
      else this.cancel();
      return true;
    }
    const next = key === "Backspace" ? this.text.slice(0, -1) : /^[0-9.-]$/.test(key) ? this.text + key : null;
    if (next === null || (key === "Backspace" && this.text === "")) return false;
    if (this.text === "") this.feature = this.of();
    const member = this.feature && this.memberOf(this.feature);
    if (!this.feature || !member || !/^-?\d*\.?\d*$/.test(next)) return false;
    this.text = next;
    this.desk.say(`${next || "…"} m`);
    const value = Number(next);
    if (next === "" || !Number.isFinite(value) || next === "-") return true;
    this.gesture ??= this.desk.begin("height typed");
    const pointer = `${this.feature.item.pointer}/${token(member)}`;
    this.gesture.live(() => [{ do: "set", pointer, value }]);
    return true;
  }

  finish(): void {
    const { gesture } = this;
    this.text = "";
    this.gesture = null;
    if (!gesture) return;
    void gesture.finish();
    this.desk.say("");
    this.desk.end();
  }

  cancel(): void {
    const { gesture } = this;
    this.text = "";
    this.gesture = null;
    if (!gesture) return;
    void gesture.cancel();
    this.desk.say("");
    this.desk.end();
  }
}
