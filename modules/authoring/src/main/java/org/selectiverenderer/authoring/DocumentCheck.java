package org.selectiverenderer.authoring;

import java.util.List;
import org.selectiverenderer.base.problem.Problem;

/**
 * Checks a whole document, for example with the validator. As this may take a while, it runs on a
 * snapshot in the background.
 */
@FunctionalInterface
public interface DocumentCheck {
  /** Returns the problems, with their locations in the snapshot's text. */
  List<Problem> check(DocumentSnapshot snapshot);
}
