// A line between two areas that can be dragged, or moved with the arrow keys.
interface DividerProps {
  label: string;
  /** Of the line: areas lie left and right of an upright one. */
  upright: boolean;
  /** Position, and its bounds, in whatever unit `move` takes. */
  value: number;
  low: number;
  high: number;
  /** By an arrow key. */
  step: number;
  /** Told of the pointer in the window, or of a new value by keys. */
  dragged: (event: PointerEvent) => void;
  moved: (value: number) => void;
}

export function Divider(props: DividerProps) {
  const { value, low, high, step } = props;
  const back = props.upright ? "ArrowLeft" : "ArrowUp";
  const on = props.upright ? "ArrowRight" : "ArrowDown";
  return (
    <div
      class={`divider ${props.upright ? "upright" : "level"}`}
      role="separator"
      aria-label={props.label}
      aria-orientation={props.upright ? "vertical" : "horizontal"}
      aria-valuenow={Math.round(value * 100) / 100}
      aria-valuemin={low}
      aria-valuemax={high}
      tabIndex={0}
      onKeyDown={(event) => {
        const by = event.key === on ? step : event.key === back ? -step : 0;
        if (by === 0) return;
        event.preventDefault();
        props.moved(Math.min(high, Math.max(low, value + by)));
      }}
      onPointerDown={(event) => {
        event.preventDefault();
        event.currentTarget.setPointerCapture(event.pointerId);
      }}
      onPointerMove={(event) => {
        if (event.currentTarget.hasPointerCapture(event.pointerId)) props.dragged(event);
      }}
    />
  );
}
