package org.selectiverenderer.document;

import java.util.List;
import org.selectiverenderer.base.problem.Problem;

/**
 * Looks through a whole document, which may take a while: to be run beside the author's work, on a
 * snapshot. A validator is one of these.
 */
@FunctionalInterface
public interface DocumentCheck {
  /** What is wrong, with places in the snapshot's text. */
  List<Problem> check(Snapshot snapshot);
}
