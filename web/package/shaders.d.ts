/** GLSL ES 3.00, complete. */
export const stripesVertex: string;
export const stripesFragment: string;
export const marksVertex: string;
export const marksFragment: string;
/** Functions alone: `fragment_phase` and `covered_share`, for shaders of your own. */
export const phase: string;
