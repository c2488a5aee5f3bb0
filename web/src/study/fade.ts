/** The picture of an exposure comes and goes: this says how bright it is at a time. */
export class Fade {
  /**
   * @param fade seconds in which the picture comes and goes, in addition to the exposure
   * @param seconds of the exposure
   */
  constructor(
    private readonly fade: number,
    private readonly seconds: number,
  ) {}

  /** Returns the share of its brightness that the picture has, 0 to 1. */
  brightness(t: number): number {
    if (this.fade === 0) {
      return this.over(t) ? 0 : 1;
    }
    const left = 2 * this.fade + this.seconds - t;
    return Math.max(0, Math.min(1, t / this.fade, left / this.fade));
  }

  /** Returns whether the picture is gone. */
  over(t: number): boolean {
    return t >= 2 * this.fade + this.seconds;
  }
}
