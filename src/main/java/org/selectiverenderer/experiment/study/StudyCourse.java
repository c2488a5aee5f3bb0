package org.selectiverenderer.experiment.study;

/**
 * How a session goes on: what is shown in which order, and who may do and see what meanwhile.
 *
 * @param order of the areas
 * @param stay where participants may go, in areas that do not say otherwise
 * @param closed whether nobody leaves the room in which an exposure begins
 * @param blind whether the operator's windows and messages keep the condition to themselves
 */
public record StudyCourse(AreaOrder order, Stay stay, boolean closed, boolean blind) {
  /** As a study is run that says nothing of it. */
  public static final StudyCourse USUAL = new StudyCourse(AreaOrder.FIXED, Stay.FREE, false, true);
}
