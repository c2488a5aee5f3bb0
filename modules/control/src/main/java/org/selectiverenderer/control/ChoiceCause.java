package org.selectiverenderer.control;

/**
 * A cause says why a version was chosen.
 *
 * @param schema the schema that was activated; empty if none was
 * @param budget whether the budget of triangles or milliseconds chose
 */
public record ChoiceCause(String schema, boolean budget) {
  /** The budget chose. */
  public static final ChoiceCause BUDGET = new ChoiceCause("", true);

  /** The scene itself chose. */
  static final ChoiceCause SCENE = new ChoiceCause("", false);

  /** Returns the activation of a schema as the cause. */
  static ChoiceCause of(String schema) {
    return new ChoiceCause(schema, false);
  }
}
