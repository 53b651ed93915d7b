/** Complete shaders in GLSL ES 3.00. */
export const stripesVertex: string;
export const stripesFragment: string;
export const marksVertex: string;
export const marksFragment: string;
/** For your own shaders, after `#version` and precisions: access to vertices and triangles. */
export const patternVertex: string;
/** The same, with the pattern at a pixel. */
export const patternFragment: string;
