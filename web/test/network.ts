import { createServer, type IncomingMessage, type Server, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';

/** A request meets one of these: it is lost on its way, stored with its answer lost, and so on. */
export type Fate = 'arrives' | 'lost' | 'answer lost' | 'fails' | 'slow' | 'answered by a portal' | 'twice';

/** Handles the body of a request that arrived, and returns status and body of the answer. */
export type Handle = (path: string, body: string) => Promise<{ status: number; body: string }>;

/** A network that loses, repeats and delays requests, with a server behind it. */
export class Network {
  private readonly server: Server;
  /** Decides on each request; all arrive at first. */
  fate: (body: string) => Fate = () => 'arrives';
  requests = 0;

  private constructor(private readonly handle: Handle) {
    this.server = createServer((request, response) => void this.answer(request, response));
  }

  static async open(handle: Handle): Promise<Network> {
    const network = new Network(handle);
    await new Promise<void>((resolve) => network.server.listen(0, '127.0.0.1', 2048, resolve));
    return network;
  }

  get url(): string {
    return `http://127.0.0.1:${(this.server.address() as AddressInfo).port}`;
  }

  async close(): Promise<void> {
    this.server.closeAllConnections();
    await new Promise((resolve) => this.server.close(resolve));
  }

  private async answer(request: IncomingMessage, response: ServerResponse): Promise<void> {
    this.requests++;
    const chunks: Buffer[] = [];
    for await (const chunk of request) {
      chunks.push(chunk as Buffer);
    }
    const body = Buffer.concat(chunks).toString();
    const path = request.url ?? '';
    switch (this.fate(body)) {
      case 'lost':
        request.socket.destroy();
        return;
      case 'answer lost':
        await this.handle(path, body);
        request.socket.destroy();
        return;
      case 'fails':
        response.writeHead(500).end('{"error": "no"}');
        return;
      case 'slow':
        await this.handle(path, body);
        return; // never answered
      case 'answered by a portal':
        response.writeHead(200, { 'Content-Type': 'application/json' }).end('{}');
        return;
      case 'twice':
        await this.handle(path, body);
        break;
      case 'arrives':
    }
    const answer = await this.handle(path, body);
    response.writeHead(answer.status, { 'Content-Type': 'application/json' }).end(answer.body);
  }
}
