// The first screen and the gallery: four ways to begin, and examples with their pictures.
import { useSignal } from "@preact/signals";
import { FileUp, PenLine, Square } from "lucide-preact";
import { useEffect } from "preact/hooks";
import type { ExampleInfo } from "../../api/api";
import type { IconType } from "../../actions/registry";
import { beginCoast, beginStrokes } from "./beginnings";
import { Dialog } from "./dialog";
import { importFiles, openDocument, pickFiles, problemText, unlessUnsaved } from "./files";
import { galleryOf } from "./gallery";
import { Logo } from "./logo";
import { closeDialog, openDialog, useStudio } from "./shell";
import { MountainStroke } from "./terrain_icons";

export function FirstScreen() {
  const studio = useStudio();
  const examples = useSignal<readonly ExampleInfo[]>([]);
  const problem = useSignal("");
  useEffect(() => {
    studio.api.examples().then(
      (found) => (examples.value = found), (error: unknown) => (problem.value = problemText(error)),
    );
  }, []);
  const groups = galleryOf(examples.value);
  return (
    <Dialog title="Begin" bare class="first-screen" close={closeDialog}>
      <div class="first-columns">
        <div class="first-begin">
          <div class="first-brand">
            <Logo />
            <span>Seamount</span>
          </div>
          <p class="muted">
            Terrains by hand and by rule. What you draw stays a recipe that can be changed, and run again.
          </p>
          <Beginnings />
          <p class="first-drop muted">Or drop a file anywhere: elevation, a coast, contours, a recipe.</p>
        </div>
        <div class="first-gallery">
          {problem.value && (
            <p class="failure" role="alert">
              The examples could not be listed: {problem.value}
            </p>
          )}
          {groups.map(({ title, examples: own }) => (
            <section key={title} aria-label={title}>
              <h3>{title}</h3>
              <ul class="cards">
                {own.map((example) => (
                  <li key={example.name}>
                    <ExampleCard example={example} />
                  </li>
                ))}
              </ul>
            </section>
          ))}
        </div>
      </div>
    </Dialog>
  );
}

function Beginnings() {
  const studio = useStudio();
  const fromFile = async (): Promise<void> => {
    const files = await pickFiles(".tif,.tiff,.asc,.hgt,.png,.exr,.r16,.raw,.npy,.zip", false);
    if (files.length > 0) await importFiles(studio, files);
  };
  return (
    <ul class="beginnings">
      <Beginning
        icon={PenLine}
        title="Draw a coast"
        about="and an island grows inside it"
        run={() => unlessUnsaved(studio, () => void beginCoast(studio))}
      />
      <Beginning
        icon={MountainStroke}
        title="Mountains from strokes"
        about="ridges and rivers become a range"
        run={() => unlessUnsaved(studio, () => void beginStrokes(studio))}
      />
      <Beginning
        icon={FileUp}
        title="From my elevation file"
        about="GeoTIFF, ASC, HGT, PNG, RAW…"
        run={() => void fromFile()}
      />
      <Beginning
        icon={Square}
        title="Blank"
        about="a domain, and nothing in it"
        run={() => unlessUnsaved(studio, () => openDialog("blank"))}
      />
    </ul>
  );
}

function Beginning(
  { icon: Icon, title, about, run }: { icon: IconType; title: string; about: string; run: () => void },
) {
  return (
    <li>
      <button class="plain beginning" onClick={run}>
        <span class="beginning-icon"><Icon aria-hidden /></span>
        <span>
          <strong>{title}</strong>
          <span class="muted">{about}</span>
        </span>
      </button>
    </li>
  );
}

function ExampleCard({ example }: { example: ExampleInfo }) {
  const studio = useStudio();
  const picture = useSignal<string | null>(null);
  useEffect(() => {
    if (example.picture === false) return;
    let address = "";
    studio.api.examplePicture(example.name).then(
      (content) => {
        if (content && content.size > 0) picture.value = address = URL.createObjectURL(content);
      },
      () => undefined,
    );
    return () => URL.revokeObjectURL(address);
  }, [example.name]);
  const open = (): void => unlessUnsaved(studio, () => void openDocument(studio, { example: example.name }));
  return (
    <button class="plain card" onClick={open} title={example.about}>
      <span class="card-picture">
        {picture.value ? <img src={picture.value} alt="" /> : <MountainStroke aria-hidden />}
      </span>
      <span class="card-title">{example.title}</span>
      <span class="card-about muted">{example.about}</span>
    </button>
  );
}
