package org.selectiverenderer.authoring;

import java.util.List;
import org.selectiverenderer.base.problem.Problem;

/**
 * Checks a whole document, for example with the validator. As this may take a while, it runs on a
 * snapshot in the background.
 */
@FunctionalInterface
public interface DocumentCheck {
  /**
   * Returns the problems, with their locations in the snapshot's text.
   *
   * @throws java.util.concurrent.CancellationException if its thread is interrupted, as the
   *     document has changed meanwhile; a check may also go on to its end
   */
  List<Problem> check(DocumentSnapshot snapshot);
}
