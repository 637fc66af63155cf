// Makes and fills elements of HTML and SVG.

export const element = (tag, properties = {}, ...children) => {
  const made =
    Object.assign(document.createElement(tag), tag === 'button' ? {type: 'button', ...properties} : properties);
  made.append(...children);
  return made;
};

export const svgElement = (tag, attributes = {}) => {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return element;
};
