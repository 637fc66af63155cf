// What the page says in words.

/**
 * An element of the page by its id; the page's HTML says of which kind it is.
 * @type {(id: string) => any}
 */
export const $ = (id) => document.getElementById(id);
/**
 * All elements that a selector of CSS names.
 * @param {string} selector
 * @param {ParentNode} root
 */
export const $$ =
  (selector, root = document) => [.../** @type {NodeListOf<HTMLElement>} */ (root.querySelectorAll(selector))];

/**
 * Beside the picture, and to screen readers.
 * @param {string} text
 */
export function say(text) {
  if ($('state').textContent !== text) $('state').textContent = text;
}

/**
 * Instead of the picture, which cannot be.
 * @param {string} text
 */
export function sorry(text) {
  const p = document.createElement('p');
  p.className = 'sorry';
  p.setAttribute('role', 'alert');
  p.textContent = text;
  document.body.append(p);
}
