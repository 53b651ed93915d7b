// What the form says, and the link that carries it.
export const defaults = { shape: 'trefoil', field: 'smooth', rotate: 0, tile: 'stripes', stripes: 40, width: 50, slack: 0, branches: false };

const units = { rotate: (v) => `${v}°`, width: (v) => `${v} %`, slack: (v) => `${v} %`, stripes: (v) => String(v) };

export class Settings {
  constructor(form, changed) {
    this.form = form;
    this.values = { ...defaults };
    this.strokes = '';  // as they are written in links
    for (const input of form.querySelectorAll('[name]')) {
      input.addEventListener('input', () => {
        this.values[input.name] = valueOf(input);
        if (input.name === 'shape') this.strokes = '';
        this.show();
        changed(input.name);
      });
    }
  }

  /** All settings: those that a link does not name are as they are by default, and so are values that a control has not. */
  read(hash) {
    const given = new URLSearchParams(hash.replace(/^#/, ''));
    this.strokes = given.get('strokes') ?? '';
    for (const [name, usual] of Object.entries(defaults)) {
      const input = this.form.elements.namedItem(name), text = given.get(name) ?? String(usual);
      if (input.type === 'checkbox') input.checked = text === 'true';
      else if (input.type === 'range') input.value = Number.isFinite(Number(text)) ? text : usual;
      else input.value = [...input.options].some((option) => option.value === text) ? text : usual;
      this.values[name] = valueOf(input);
    }
    this.show();
  }

  show() {
    for (const input of this.form.querySelectorAll('input[type="range"]')) {
      const text = units[input.name](input.value);
      input.nextElementSibling.textContent = text;
      input.setAttribute('aria-valuetext', text);
    }
    const isTexture = this.values.tile !== 'stripes';
    this.form.elements.namedItem('width').disabled = isTexture;
    for (const what of ['svg', 'obj']) this.form.querySelector(`[data-save="${what}"]`).disabled = isTexture;
  }

  hash() {
    const changed = Object.entries(this.values).filter(([name, value]) => value !== defaults[name] && value !== '');
    if (this.strokes) changed.push(['strokes', this.strokes]);
    return changed.length ? `#${new URLSearchParams(changed)}` : '';
  }
}

function valueOf(input) {
  if (input.type === 'checkbox') return input.checked;
  return input.type === 'range' ? Number(input.value) : input.value;
}
