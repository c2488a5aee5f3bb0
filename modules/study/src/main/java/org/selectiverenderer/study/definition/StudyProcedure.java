package org.selectiverenderer.study.definition;

/**
 * The procedure of a session: the order of the areas, and what participant and operator may do and
 * see.
 *
 * @param order the order of the areas
 * @param stay the movement constraint in areas without their own
 * @param closed whether participants cannot leave the room in which an exposure begins
 * @param blind whether the operator's windows and messages hide the condition (double-blind)
 */
public record StudyProcedure(
    AreaOrder order, MovementConstraint stay, boolean closed, boolean blind) {
  /** The procedure of a study file without these keys. */
  public static final StudyProcedure USUAL =
      new StudyProcedure(AreaOrder.FIXED, MovementConstraint.FREE, false, true);
}
