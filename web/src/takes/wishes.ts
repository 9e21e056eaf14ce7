/** Knows what was asked for last, while uploads and answers are on their way. */
export class Wishes {
  private _wishes: symbol[] = [];

  /** A wish that replaces all before it. */
  replace(): symbol {
    const wish = Symbol();
    this._wishes = [wish];
    return wish;
  }

  /** A wish that replaces those before it, unless it is withdrawn. */
  add(): symbol {
    const wish = Symbol();
    this._wishes.push(wish);
    return wish;
  }

  /** Forgets a wish, as if it had never been made. */
  withdraw(wish: symbol): void {
    this._wishes = this._wishes.filter(other => other !== wish);
  }

  /** Forgets a wish that came true, and those before it. */
  fulfil(wish: symbol): void {
    this._wishes = this._wishes.slice(this._wishes.indexOf(wish) + 1);
  }

  /** Whether a wish has been neither replaced nor forgotten. */
  has(wish: symbol): boolean {
    return this._wishes.includes(wish);
  }

  isLast(wish: symbol): boolean {
    return this._wishes[this._wishes.length - 1] === wish;
  }
}
