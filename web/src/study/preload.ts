/** So many files are loaded at the same time. */
const TOGETHER = 6;

/**
 * Loads files, so that the web browser has them when a scene needs them.
 *
 * @param files bytes by address
 * @param say is told the percentage of the bytes that are there
 * @throws Error with a sentence if a file is missing
 */
export async function preload(files: Readonly<Record<string, number>>, say: (percent: number) => void): Promise<void> {
  const waiting = Object.entries(files);
  const all = waiting.reduce((sum, [, bytes]) => sum + bytes, 0);
  let here = 0;
  say(0);
  const next = async (): Promise<void> => {
    for (let file = waiting.shift(); file; file = waiting.shift()) {
      const [address, bytes] = file;
      const answer = await fetch(address);
      if (!answer.ok) {
        throw new Error(`${address} cannot be read (${answer.status}); the page needs all files of its folder`);
      }
      await answer.arrayBuffer();
      here += bytes;
      say(Math.floor((100 * here) / Math.max(1, all)));
    }
  };
  await Promise.all(Array.from({ length: TOGETHER }, next));
}
