// Draws the page's picture for its documentation: node web/picture.mjs --output FILE.png
import { writeFileSync } from 'node:fs';
import puppeteer from 'puppeteer-core';
import { serve } from './serve.mjs';

const { server, address } = await serve('build/web/page');
const browser = await puppeteer.launch({
  executablePath: process.env.BRINDLE_BROWSER ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-gl=angle', '--use-angle=swiftshader',
         '--enable-unsafe-swiftshader', '--force-prefers-reduced-motion'],
});
const page = await browser.newPage();
await page.setViewport({ width: 840, height: 600 });
await page.goto(address + (process.argv[4] ?? ''));
await page.waitForFunction(() => document.body.dataset.state === 'ready' &&
  document.getElementById('metrics').textContent !== '', { timeout: 60000 });
await new Promise((done) => setTimeout(done, 1500));
writeFileSync(process.argv[3], await page.screenshot());
await browser.close();
server.close();
