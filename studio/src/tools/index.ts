// What the page needs of the tools.
export { ToolRail } from "./rail";
export { ToolOptions } from "./options";
export { toolsOf, type PenViewport } from "./toolbox";
export { registerTools } from "./actions";
