// Chromium as tests and scripts start it: without a display and without a graphics card.
import puppeteer from 'puppeteer-core';

/** `flags` beside those that all want; `timeout` of a single question to it, milliseconds. */
export const launch = ({ flags = [], timeout = 240000 } = {}) => puppeteer.launch({
  executablePath: process.env.CHROMIUM || '/usr/bin/chromium', headless: true, protocolTimeout: timeout,
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist',
    '--disable-dev-shm-usage', '--disable-gpu-watchdog', ...flags],
});
