// A bar that says when the server is gone, and what that means for what one is doing.
import { useSignal } from "@preact/signals";
import { Unplug } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { useStudio } from "./shell";

const kPatience_ms = 1200;

export function ConnectionBar() {
  const studio = useStudio();
  const connected = studio.connected.value;
  const patient = useSignal(true);
  useEffect(() => {
    patient.value = true;
    if (connected) return;
    const timer = setTimeout(() => (patient.value = false), kPatience_ms);
    return () => clearTimeout(timer);
  }, [connected]);
  if (studio.refused.value) {
    return (
      <div class="connection" role="alert">
        <Unplug aria-hidden />
        <p>The studio was started anew. Open the address that it has printed; every change that was kept is there.</p>
      </div>
    );
  }
  if (connected || patient.value) return null;
  return (
    <div class="connection" role="alert">
      <Unplug aria-hidden />
      <p>
        The studio does not answer.{" "}
        {studio.busy.value ? "Your latest changes wait in this window" : "Everything up to now is kept"}; this window
        connects again by itself.
      </p>
      <button onClick={() => studio.retry()}>Try now</button>
    </div>
  );
}
