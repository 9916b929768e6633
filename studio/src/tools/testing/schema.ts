// The operators that tests draw into, as the server describes them.
import type { OperatorInfo, Schema } from "../../api/types";
import json from "./schema.json";

export const schema = json as unknown as Schema;

export function operatorNamed(name: string): OperatorInfo {
  const found = schema.operators.find((operator) => operator.name === name);
  if (!found) throw new Error(`no operator ${name}`);
  return found;
}
