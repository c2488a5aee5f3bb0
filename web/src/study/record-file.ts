import type { DataSink } from '../data/sink.js';

/** Keeps the records for a file that the participant saves: for trying a study out without a receiver. */
export class RecordFile implements DataSink {
  private readonly lines: string[] = [];

  send(record: unknown): void {
    this.lines.push(JSON.stringify(record));
  }

  finish(): Promise<void> {
    return Promise.resolve();
  }

  /** Returns a link that saves the records as JSON Lines. */
  link(label: string, name: string): HTMLAnchorElement {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([this.lines.map((line) => `${line}\n`).join('')], { type: 'application/jsonl' }));
    link.download = name;
    link.className = 'jspsych-btn';
    link.textContent = label;
    return link;
  }
}
