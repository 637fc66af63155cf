// What the page says in words.

export const $ = (id) => document.getElementById(id);

/** Beside the picture, and to screen readers. */
export function say(text) { if ($('state').textContent !== text) $('state').textContent = text; }

/** Instead of the picture, which cannot be. */
export function sorry(text) {
  const p = document.createElement('p');
  p.className = 'sorry';
  p.setAttribute('role', 'alert');
  p.textContent = text;
  document.body.append(p);
}
