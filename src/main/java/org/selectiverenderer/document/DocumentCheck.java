package org.selectiverenderer.document;

import java.util.List;
import org.selectiverenderer.x3d.NodeCatalogue;
import org.selectiverenderer.x3d.Problem;
import org.selectiverenderer.x3d.Problems;
import org.selectiverenderer.x3d.X3dReader;

/**
 * Looks through a whole document, which may take a while: to be run beside the author's work, on a
 * snapshot. A validator is one of these.
 */
@FunctionalInterface
public interface DocumentCheck {
  /** What is wrong, with places in the snapshot's text. */
  List<Problem> check(Snapshot snapshot);

  /** What the program's own reader says of the document when it is shown. */
  static DocumentCheck ofReader(NodeCatalogue catalogue) {
    X3dReader reader = new X3dReader(catalogue);
    return snapshot -> {
      Problems problems = new Problems();
      reader.read(snapshot.name(), snapshot.bytes(), problems);
      return problems.list();
    };
  }
}
