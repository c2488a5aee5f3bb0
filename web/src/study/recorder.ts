import type { DataSink } from '../data/sink.js';

/** All records of a session have the same of these. */
export interface Identity {
  readonly study: string;
  readonly checksum: string;
  /** A random id, made by the page. */
  readonly session: string;
  /** The place in the plan, from 1. */
  readonly slot: number;
  readonly participant: string;
  readonly group: string;
  readonly condition: string;
  readonly language: string;
}

/** Something that happened to the page: it lost or got the focus, left or came to the full screen. */
interface Interruption {
  /** Seconds since the step began. */
  readonly t: number;
  readonly event: string;
}

/** Makes one record of each step as it ends. */
export class Recorder {
  private step = '';
  private started = new Date();
  private began = 0;
  private interruptions: Interruption[] = [];

  constructor(
    private readonly identity: Identity,
    private readonly sink: DataSink,
  ) {}

  /** Begins a step; what has been noted of one that never ended is dropped. */
  begin(step: string): void {
    this.step = step;
    this.started = new Date();
    this.began = performance.now();
    this.interruptions = [];
  }

  /** Notes that the page was left or came back. */
  interrupted(event: string): void {
    this.interruptions.push({ t: (performance.now() - this.began) / 1000, event });
  }

  /** Ends the step and hands its record on. */
  end(content: Readonly<Record<string, unknown>>): void {
    this.sink.send({
      ...this.identity,
      step: this.step,
      started: this.started.toISOString(),
      ended: new Date().toISOString(),
      // The clock of head logs, whose origin is another one each time the page is opened.
      origin: Math.round(performance.timeOrigin),
      mono: Math.round(this.began * 1000) / 1e6,
      interruptions: this.interruptions,
      ...content,
    });
  }
}
