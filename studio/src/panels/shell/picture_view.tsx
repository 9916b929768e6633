// The picture that a step makes, in place of the ground while the step is selected; a button goes to the ground and back.
import { Image, Mountain } from "lucide-preact";
import { useEffect, useState } from "preact/hooks";
import { useStudio } from "./shell";

interface Shown {
  key: string;
  address: string;
  coarse: boolean;
}

/** The newest picture of a source as an address; the one before stays until there is another. */
function usePicture(source: string | null): Shown | null {
  const studio = useStudio();
  const value = source === null ? undefined : studio.values.value.get(source);
  const key = value?.kind === "image" ? value.key : "";
  const [shown, setShown] = useState<Shown | null>(null);
  useEffect(() => {
    if (key === "") return undefined;
    let current = true;
    studio.api.picture(key).then((blob) => {
      if (current) setShown({ key, address: URL.createObjectURL(blob), coarse: value?.coarse ?? false });
    }, () => undefined);
    return () => (current = false);
  }, [key]);
  useEffect(() => () => {
    if (shown) URL.revokeObjectURL(shown.address);
  }, [shown?.address]);
  useEffect(() => setShown(null), [source]);
  return shown;
}

/** Of the shown overlay, where that is a picture. */
function pictureSource(studio: ReturnType<typeof useStudio>): string | null {
  const source = studio.shown.value.overlay, [id = "", port] = (source ?? "").split(".");
  const step = studio.step(id);
  const out = step && studio.operator(step.op)?.out.find((one) => one.name === port);
  return out?.kind === "image" ? source : null;
}

export function PictureView() {
  const studio = useStudio();
  const source = pictureSource(studio);
  const [away, setAway] = useState(false);
  const picture = usePicture(source);
  useEffect(() => setAway(false), [source]);
  if (source === null) return null;
  const step = source.split(".")[0]!;
  return (
    <div class={`picture-view ${away ? "away" : ""}`} data-picture={picture?.key}>
      {!away && (picture
        ? <img src={picture.address} alt={`Picture of ${step}`} class={picture.coarse ? "coarse" : ""} />
        : <p class="muted">The picture of {step} is being made</p>)}
      <button type="button" class="picture-switch" onClick={() => setAway(!away)}>
        {away ? <Image aria-hidden /> : <Mountain aria-hidden />}{away ? "Show the picture" : "Show the ground"}
      </button>
    </div>
  );
}
