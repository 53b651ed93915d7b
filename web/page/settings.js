// What the form says, and the link that carries it.
export const defaults = { shape: 'trefoil', field: 'smooth', rotate: 0, detail: 0, tile: 'stripes', subdivide: 0, stripes: 40, width: 50, slack: 0, branches: false };

const units = { rotate: (v) => `${v}°`, detail: (v) => (Number(v) === 0 ? 'off' : v), width: (v) => `${v} %`, slack: (v) => `${v} %`, stripes: (v) => String(v),
                subdivide: (v) => (Number(v) === 0 ? 'off' : v) };

/** Fields from arrays of the mesh's file. */
export const isData = (field) => field.startsWith('array:');

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

  /** All settings; defaults replace missing values and values that a control does not have. */
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
    this.form.elements.namedItem('detail').disabled = !isData(this.values.field);
    const isTexture = this.values.tile !== 'stripes';
    this.form.elements.namedItem('width').disabled = isTexture;
    for (const what of ['svg', 'obj']) this.form.querySelector(`[data-save="${what}"]`).disabled = isTexture;
  }

  /** The mesh's vector arrays: choices of directions, and their smoothing. */
  offer(names) {
    const field = this.form.elements.namedItem('field');
    field.querySelector('optgroup')?.remove();
    this.form.querySelector('#detailed').hidden = names.length === 0;
    if (names.length > 0) {
      const group = Object.assign(document.createElement('optgroup'), { label: "The mesh's data" });
      group.append(...names.map((name) => new Option(name, `array:${name}`)));
      field.append(group);
    }
    const isThere = [...field.options].some(({ value }) => value === this.values.field);
    field.value = this.values.field = isThere ? this.values.field : defaults.field;
    this.show();
  }

  /** A warning of the library in the words of the controls, without what they cannot do. */
  inWords(warning) {
    const most = Number(this.form.elements.namedItem('subdivide').max);
    return `${warning}.`
      .replace(/take fewer stripes, or a lower frequency, which [^;.]*/, 'take a lower Number')
      .replace(/; or subdivide the mesh, times: (\d+)/, (_, times) => (times <= most ? `; or Subdivide ${times}` : ''))
      .replace(/^./, (letter) => letter.toUpperCase());
  }

  /** Puts back a value that could not be had. */
  put(name, value) {
    this.form.elements.namedItem(name).value = this.values[name] = value;
    this.show();
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
