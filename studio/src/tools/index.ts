// What the page needs of the tools.
export { ToolRail } from "./rail";
export { ToolOptions } from "./options";
export { toolsOf, type PenViewport } from "./toolbox";
export { offeredActions, toolActions, toolKey, type ToolAction } from "./actions";
