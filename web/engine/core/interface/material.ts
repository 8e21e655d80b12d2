/** The material that all elastic models share. */

/** A homogeneous isotropic material on a body. */
export interface ElasticMaterial {
  /** Young's modulus, Pa */
  young: number;
  /** Poisson's ratio */
  poisson: number;
  /** kg/m3 */
  density: number;
  /** of a shell, in units of the mesh */
  thickness: number;
  /** metres per unit of the mesh */
  unit: number;
}
