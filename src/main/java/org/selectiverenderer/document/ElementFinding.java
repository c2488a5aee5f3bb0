package org.selectiverenderer.document;

import java.util.Optional;
import java.util.function.Supplier;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Something about an element that its author should know.
 *
 * @param message one sentence: what is wrong and what is done about it
 * @param fix an edit that mends it, where one is obvious
 */
public record ElementFinding(
    DocumentElement element, Problem.Severity severity, String message, Optional<Fix> fix) {
  /**
   * A way to mend something.
   *
   * @param name as a button shows it
   * @param edit makes the edit for the document as it is when it is asked
   */
  public record Fix(String name, Supplier<Edit> edit) {}

  /** The same with its place as of now. */
  public Problem located(SceneDocument document) {
    return new Problem(severity, document.location(element.start()), message);
  }
}
