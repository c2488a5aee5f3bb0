/** The number of pictures that a measurement drops: the first ones still compile shaders and fill textures. */
const DROPPED = 5;

/** Measures how many pictures of a scene come in a second. */
export class FrameRate {
  private readonly times: number[] = [];

  /**
   * @param seconds that are enough, with so many pictures
   * @param pictures that are enough, in so many seconds
   * @param most seconds after which a slow device has shown what it can
   */
  constructor(
    private readonly seconds: number,
    private readonly pictures: number,
    private readonly most: number,
  ) {}

  /** Takes the time of a picture, in milliseconds; returns whether that was enough. */
  picture(time: number): boolean {
    this.times.push(time);
    const kept = this.kept();
    return (kept.length > this.pictures && time - (kept[0] ?? 0) >= this.seconds * 1000)
      || (this.times.length > 1 && time - (this.times[0] ?? 0) >= this.most * 1000);
  }

  /** Returns the median rate of the pictures, so that one hitch does not count; 0 before there are two. */
  perSecond(): number {
    const kept = this.kept();
    const lengths = kept.slice(1).map((time, i) => time - (kept[i] ?? 0)).sort((a, b) => a - b);
    const middle = lengths[Math.floor(lengths.length / 2)] ?? 0;
    return middle > 0 ? 1000 / middle : 0;
  }

  private kept(): readonly number[] {
    return this.times.slice(Math.max(0, Math.min(DROPPED, this.times.length - 2)));
  }
}
