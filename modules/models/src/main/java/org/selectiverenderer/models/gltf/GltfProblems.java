package org.selectiverenderer.models.gltf;

import java.util.HashSet;
import java.util.Set;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;

/** Reports what of a model is left out, each kind of thing once, with the path of the first. */
final class GltfProblems {
  private final SourceLocation location;
  private final ProblemCollector problems;
  private final Set<String> told = new HashSet<>();

  GltfProblems(String name, ProblemCollector problems) {
    location = SourceLocation.of(name);
    this.problems = problems;
  }

  /**
   * Reports something, unless the same has been reported of another part.
   *
   * @param path the path in the model, such as {@code nodes[3].mesh}
   * @param message a sentence without a full stop
   */
  void tell(String path, String message) {
    if (told.add(message)) {
      problems.warning(location, path + ": " + message);
    }
  }
}
