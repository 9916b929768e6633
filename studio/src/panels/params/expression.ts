// What is typed into a number field: "450", "2*450", "1.2 km", "(3 + 4) m / 2", read as an amount of the field's unit.
import { NO_UNIT, type Unit, multiplied, readUnit, sameDimension, unitText } from "./units";

export type Typed = { value: number } | { error: string };

/** A plain number (`unit` null) is meant in the field's unit where it stands alone or is added. */
interface Amount {
  value: number;
  unit: Unit | null;
}

class Reader {
  private at = 0;
  constructor(private readonly text: string, private readonly field: Unit, private readonly fieldText: string) {}

  all(): Amount {
    const amount = this.sum();
    this.skip();
    if (this.at < this.text.length) throw new Error(`"${this.text.slice(this.at)}" is not understood`);
    return amount;
  }

  private skip(): void {
    while (/\s/.test(this.text[this.at] ?? "")) ++this.at;
  }

  private take(symbols: string): string | null {
    this.skip();
    const next = this.text[this.at];
    if (next === undefined || !symbols.includes(next)) return null;
    ++this.at;
    return next;
  }

  private match(pattern: RegExp): string | null {
    this.skip();
    pattern.lastIndex = this.at;
    const found = pattern.exec(this.text);
    if (!found) return null;
    this.at += found[0].length;
    return found[0];
  }

  private sum(): Amount {
    let left = this.product();
    for (let sign = this.take("+-−"); sign !== null; sign = this.take("+-−")) {
      const right = this.product();
      const factor = sign === "+" ? 1 : -1;
      left = this.added(left, right, factor);
    }
    return left;
  }

  private added(left: Amount, right: Amount, factor: 1 | -1): Amount {
    if (left.unit === null && right.unit === null) return { value: left.value + factor * right.value, unit: null };
    const united = (amount: Amount): Amount => amount.unit ? amount
      : { value: amount.value * this.field.factor, unit: { ...this.field, factor: 1 } };
    const a = united(left);
    const b = united(right);
    if (!sameDimension(a.unit!, b.unit!)) throw new Error("amounts of different kinds cannot be added");
    return { value: a.value + factor * b.value, unit: a.unit };
  }

  private product(): Amount {
    let left = this.power();
    for (let sign = this.take("*/×·"); sign !== null; sign = this.take("*/×·")) {
      const right = this.power();
      const direction = sign === "/" ? -1 : 1;
      if (direction === -1 && right.value === 0) throw new Error("division by zero");
      const unit = left.unit === null && right.unit === null ? null
        : multiplied(left.unit ?? NO_UNIT, right.unit ?? NO_UNIT, direction);
      left = { value: direction === 1 ? left.value * right.value : left.value / right.value, unit };
    }
    return left;
  }

  private power(): Amount {
    if (this.take("-−") !== null) {
      const amount = this.power();
      return { ...amount, value: -amount.value };
    }
    if (this.take("+") !== null) return this.power();
    const base = this.primary();
    if (this.take("^") === null) return base;
    const exponent = this.power();
    if (base.unit !== null || exponent.unit !== null) throw new Error("powers are of plain numbers");
    return { value: base.value ** exponent.value, unit: null };
  }

  private primary(): Amount {
    if (this.take("(") !== null) {
      const inner = this.sum();
      if (this.take(")") === null) throw new Error("a ) is missing");
      return inner.unit === null ? this.withUnit(inner.value) : inner;
    }
    if (this.match(/pi\b|π/iy) !== null) return this.withUnit(Math.PI);
    const number = this.match(/(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?/iy);
    if (number === null) {
      const rest = this.text.slice(this.at).trim();
      throw new Error(rest === "" ? "a number is missing" : `"${rest}" is no number`);
    }
    return this.withUnit(Number(number.replace(",", ".")));
  }

  /** A unit behind a number: letters, digits of exponents, and what follows a stroke if that is a unit too. */
  private withUnit(value: number): Amount {
    const name = /[a-zA-Z°%]+[23²³]?(\s*\/\s*[a-zA-Z]+[23²³]?)*/y;
    const text = this.match(name);
    if (text === null) return { value, unit: null };
    const unit = readUnit(text.replace(/\s/g, ""));
    const here = this.fieldText ? `; here ${unitText(this.fieldText)}` : "";
    if (unit === null) throw new Error(`"${text}" is no unit${here}`);
    return { value: value * unit.factor, unit: { ...unit, factor: 1 } };
  }
}

/** Reads what was typed as an amount of `unit`. A field whose unit is not known takes plain numbers. */
export function readTyped(text: string, unit: string): Typed {
  const field = readUnit(unit);
  try {
    const amount = new Reader(text.trim(), field ?? NO_UNIT, unit).all();
    if (amount.unit === null) return finite(amount.value);
    if (field === null) return { error: `a plain number in ${unit}` };
    if (!sameDimension(amount.unit, field))
      return { error: unit === "" ? "a plain number without unit" : `an amount in ${unitText(unit)}` };
    return finite(amount.value / field.factor);
  } catch (problem) {
    return { error: problem instanceof Error ? problem.message : String(problem) };
  }
}

function finite(value: number): Typed {
  if (!Number.isFinite(value)) return { error: "no finite number" };
  return { value: Number(value.toPrecision(12)) };
}
