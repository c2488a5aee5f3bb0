package org.selectiverenderer.models.simplify;

/**
 * Presets of the error metric of a simplification. None is best for every model, so several are
 * tried.
 */
enum SimplificationPreset {
  BALANCED(0.05f, false),
  EVEN(0.05f, true),
  FORM(0.02f, false),
  SHADING(0.15f, false);

  /**
   * Weight of a change of the normal by its length, relative to a displacement by the model's
   * extent.
   */
  final float normalWeight;

  /** Whether long and thin triangles are avoided. */
  final boolean regular;

  SimplificationPreset(float normalWeight, boolean regular) {
    this.normalWeight = normalWeight;
    this.regular = regular;
  }
}
