// A studio over the page's own server, with the operators that tools draw into and a recipe of the test's.
import { FakeServer } from "../../document/fake";
import type { Recipe, Schema } from "../../api/types";
import { schema } from "./schema";

export class DrawingServer extends FakeServer {
  constructor(recipe: Recipe, delay_ms = 0) {
    super(delay_ms);
    this.recipe = recipe;
    // Its own operators are fewer than ours.
    Object.assign(this, { refuseUnknown: () => undefined });
  }

  override schema(): Promise<Schema> {
    return Promise.resolve(schema);
  }
}
