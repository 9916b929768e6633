// Parts whose code is fetched when they are first shown.
import { useSignal } from "@preact/signals";
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";

export function lazy(load: () => Promise<ComponentType>): ComponentType {
  let loaded: ComponentType | null = null;
  return function Lazy() {
    const standing = useSignal<"loading" | "there" | "failed">(loaded ? "there" : "loading");
    useEffect(() => {
      if (loaded) return;
      load().then(
        (part) => {
          loaded = part;
          standing.value = "there";
        },
        () => (standing.value = "failed"),
      );
    }, []);
    if (standing.value === "failed")
      return <p class="empty">This panel could not be loaded. Is the studio still running?</p>;
    const Part = loaded;
    return Part && standing.value === "there" ? <Part /> : <p class="empty">Loading…</p>;
  };
}
