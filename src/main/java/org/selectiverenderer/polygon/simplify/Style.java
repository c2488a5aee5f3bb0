package org.selectiverenderer.polygon.simplify;

/** What a reduction minds most. No style is best for every model, so several are tried. */
enum Style {
  BALANCED(0.05f, false),
  EVEN(0.05f, true),
  FORM(0.02f, false),
  SHADING(0.15f, false);

  /** What a change of the normal by its length weighs against a shift by the model's extent. */
  final float normalWeight;

  /** Whether triangles are kept from becoming long and thin. */
  final boolean regular;

  Style(float normalWeight, boolean regular) {
    this.normalWeight = normalWeight;
    this.regular = regular;
  }
}
