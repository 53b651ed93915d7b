// What the form says, and the link that carries it.
export const defaults = { shape: 'trefoil', field: 'smooth', rotate: 0, stripes: 40, width: 50, slack: 0, branches: false };

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

  /** Names that are unknown or values that a control has not are passed over. */
  read(hash) {
    const given = new URLSearchParams(hash.replace(/^#/, ''));
    this.strokes = given.get('strokes') ?? '';
    for (const [name, text] of given) {
      const input = this.form.elements.namedItem(name);
      if (!input || !(name in defaults)) continue;
      if (input.type === 'checkbox') input.checked = text === 'true';
      else if (input.type !== 'range') {
        if ([...input.options].some((option) => option.value === text)) input.value = text;
      } else if (Number.isFinite(Number(text))) input.value = text;
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
