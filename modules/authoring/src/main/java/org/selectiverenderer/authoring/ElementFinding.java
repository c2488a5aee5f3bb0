package org.selectiverenderer.authoring;

import java.util.Optional;
import java.util.function.Supplier;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * A finding about an element of a document.
 *
 * @param message one sentence: what is wrong and how the program treats it
 * @param fix a quick fix, if there is an obvious one
 */
public record ElementFinding(
    DocumentElement element, Problem.Severity severity, String message, Optional<Fix> fix) {
  /**
   * A quick fix.
   *
   * @param name the label of the button
   * @param edit creates the edit for the document's present state
   */
  public record Fix(String name, Supplier<Edit> edit) {}

  /** Returns the finding as a problem at the element's present location. */
  public Problem located(SceneDocument document) {
    return new Problem(severity, document.location(element.start()), message);
  }
}
