/** GLSL ES 3.00, complete. */
export const stripesVertex: string;
export const stripesFragment: string;
export const marksVertex: string;
export const marksFragment: string;
/** For shaders of your own, behind their `#version` and precisions: what reads vertices and triangles. */
export const patternVertex: string;
/** The same with all that finds the pattern at a pixel. */
export const patternFragment: string;
