// The library in a Worker: the same methods, which return promises. Results are transferred, not copied.
import { BrindleError } from './error.js';

export { BrindleError };

const methods = {
  Brindle: ['shapes', 'tiles', 'tile', 'shape', 'surface', 'readSurface'],
  Surface: ['positions', 'normals', 'triangles', 'vertexOfRow', 'creaseVertices', 'smoothField', 'curvatureField',
            'projectedField', 'tangentField', 'array', 'arrayField', 'subdivided', 'rotatedField', 'measuredField', 'frequencies', 'stripes',
            'texture', 'crosses', 'textureAnimator', 'camera', 'animator', 'dispose'],
  Pattern: ['phases', 'directions', 'frequencies', 'triangleKinds', 'curves', 'curvesFile', 'samplesWith',
            'svg', 'dispose'],
  Texture: ['surface', 'waves', 'triangleKinds', 'brokenTiles', 'cornerUVs', 'mesh', 'glb', 'dispose'],
  Animator: ['frame', 'energy', 'restart', 'dispose'],
  TextureAnimator: ['frame', 'texture', 'follow', 'restart', 'dispose'],
};

/** `worker`: one that runs ./worker-host.js, or a port of one; default: a new one. */
export async function createBrindle({ worker } = {}) {
  const port = worker ?? new Worker(new URL('./worker-host.js', import.meta.url), { type: 'module' });
  const waiting = new Map();
  let last = 0;

  const call = (target, method, values) => new Promise((resolve, reject) => {
    waiting.set(++last, { resolve, reject });
    const sent = values.map((value) => (value?.remoteNumber ? { brindleObject: value.remoteNumber } : value));
    port.postMessage({ id: last, target, method, values: sent });
  });
  const remote = (kind, number, properties) => {
    const object = { ...properties };
    Object.defineProperty(object, 'remoteNumber', { value: number });
    for (const method of methods[kind]) object[method] = (...values) => call(number, method, values);
    return object;
  };
  port.onmessage = ({ data }) => {
    const { resolve, reject } = waiting.get(data.id);
    waiting.delete(data.id);
    if (data.error !== undefined) reject(data.isBrindle ? new BrindleError(data.error) : new Error(data.error));
    else resolve(data.object ? remote(data.kind, data.object, data.properties) : data.value);
  };
  port.onerror = (event) => {
    for (const { reject } of waiting.values()) reject(new Error(event.message ?? 'the worker failed'));
    waiting.clear();
  };
  const version = await call(0, 'version', []);
  return { ...remote('Brindle', 0, { version }), terminate: () => (port.terminate ?? port.close).call(port) };
}

export default createBrindle;
