// A real browser without a window, for the tests that need one.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import puppeteer from 'puppeteer-core';

export async function openBrowser() {
  const profile = mkdtempSync(join(tmpdir(), 'brindle-browser-'));
  const browser = await puppeteer.launch({
    executablePath: process.env.BRINDLE_BROWSER ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-gl=angle', '--use-angle=swiftshader',
           '--enable-unsafe-swiftshader', '--force-prefers-reduced-motion'],
    userDataDir: profile,
    protocolTimeout: 120000,
  });
  return {
    browser,
    close: async () => {
      await browser.close();
      rmSync(profile, { recursive: true, force: true });
    },
  };
}
