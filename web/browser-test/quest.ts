import { readFileSync } from 'node:fs';
import path from 'node:path';
import type { Page } from 'puppeteer-core';
import type { XRDevice } from 'iwer';

declare global {
  interface Window {
    /** The emulated headset. */
    quest?: XRDevice;
    IWER?: typeof import('iwer');
  }
}

const IWER = path.resolve(import.meta.dirname, '..', 'node_modules', 'iwer', 'build', 'iwer.min.js');

/** Puts an emulated Quest 3 beside a page that is not open yet: worn by somebody whose eyes are 1.6 m above the floor. */
export async function wear(page: Page): Promise<void> {
  await page.evaluateOnNewDocument(readFileSync(IWER, 'utf8'));
  await page.evaluateOnNewDocument(() => {
    if (!window.IWER) {
      throw new Error('IWER is not there');
    }
    const quest = new window.IWER.XRDevice(window.IWER.metaQuest3);
    // Chromium has a navigator.xr of its own, which knows no headset.
    quest.installRuntime({ forceInstall: true });
    quest.position.set(0, 1.6, 0);
    quest.stereoEnabled = true;
    window.quest = quest;
  });
}

/** Waits until frames of the headset have been drawn. */
export async function frames(page: Page, count = 3): Promise<void> {
  await page.evaluate(async (wanted) => {
    for (let i = 0; i < wanted; i++) {
      await window.selectiveRenderer?.world.nextFrame();
    }
  }, count);
}
