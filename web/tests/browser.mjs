// A real browser without a window, for the tests that need one.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import puppeteer from 'puppeteer-core';

/**
 * What a page complains of, from now on. What the driver says of its own speed is no complaint: whether it says
 * so hangs on how busy the machine is.
 */
export function complaintsOf(page) {
  const complaints = [];
  page.on('console', (message) => {
    if (['error', 'warn'].includes(message.type()) && !/GL Driver Message \(OpenGL, Performance/.test(message.text())) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(String(error)));
  return complaints;
}

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
