// The texts of the page.

/**
 * An element of the page by its id; the page's HTML has its kind.
 * @type {(id: string) => any}
 */
export const $ = (id) => document.getElementById(id);
/**
 * All elements that match a CSS selector.
 * @param {string} selector
 * @param {ParentNode} root
 */
export const $$ =
  (selector, root = document) => [.../** @type {NodeListOf<HTMLElement>} */ (root.querySelectorAll(selector))];

/**
 * Shows a text beside the picture, and tells screen readers.
 * @param {string} text
 */
export function say(text) {
  if ($('state').textContent !== text) $('state').textContent = text;
}

/**
 * Shows a text instead of the picture.
 * @param {string} text
 */
export function sorry(text) {
  const p = document.createElement('p');
  p.className = 'sorry';
  p.setAttribute('role', 'alert');
  p.textContent = text;
  document.body.append(p);
}
