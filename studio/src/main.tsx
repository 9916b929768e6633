// The studio's page: waits for the document, then shows it.
import { render } from "preact";

render(<p>Seamount</p>, document.getElementById("app")!);
