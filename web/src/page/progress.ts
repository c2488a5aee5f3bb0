/** Shows how many bytes of a scene have arrived, as the web browser tells of each file when it is there. */
export class Progress {
  private readonly all: number;
  private readonly sizes: Map<string, number>;
  private here = 0;

  /**
   * @param files bytes by address
   * @param base the address that these are relative to
   * @param show called with the percentage, again and again
   */
  constructor(
    files: Readonly<Record<string, number>>,
    base: string,
    private readonly show: (percent: number) => void,
  ) {
    this.sizes = new Map(Object.entries(files).map(([file, bytes]) => [new URL(file, base).href, bytes]));
    this.all = [...this.sizes.values()].reduce((sum, bytes) => sum + bytes, 0);
    show(0);
  }

  /** Counts a file that has arrived; one that the scene does not name does not count. */
  arrived(address: string): void {
    const bytes = this.sizes.get(address);
    if (bytes !== undefined) {
      this.sizes.delete(address);
      this.here += bytes;
      this.show(Math.floor((100 * this.here) / Math.max(1, this.all)));
    }
  }

  /** Counts files as they arrive, until the signal is aborted. */
  follow(signal: AbortSignal): void {
    const observer = new PerformanceObserver((list) => {
      list.getEntries().forEach((entry) => { this.arrived(entry.name); });
    });
    observer.observe({ type: 'resource', buffered: true });
    signal.addEventListener('abort', () => { observer.disconnect(); });
  }
}

/** Returns what hands percentages on, but never one that is lower than before. */
export function rising(show: (percent: number) => void): (percent: number) => void {
  let most = -1;
  return (percent) => {
    if (percent > most) {
      most = percent;
      show(percent);
    }
  };
}
