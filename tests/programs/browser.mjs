// Chromium as tests and scripts start it: without a display and without a graphics card.
import puppeteer from 'puppeteer-core';

// A browser without a card puts pages together on the processor. Left out, `--disable-gpu-compositing` has it do so by
// a card's commands in software: a page's first frame then comes a second later, and a frame may take both cores for
// half of one.
/** `flags` beside those that all want; `timeout` of a single question to it, milliseconds. */
export const launch = ({flags = [], timeout = 240000} = {}) => puppeteer.launch({
  executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
  headless: true,
  protocolTimeout: timeout,
  args: [
    '--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
    '--ignore-gpu-blocklist', '--disable-gpu-compositing', '--disable-dev-shm-usage', '--disable-gpu-watchdog', ...flags
  ],
});
