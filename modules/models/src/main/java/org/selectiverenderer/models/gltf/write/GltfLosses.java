package org.selectiverenderer.models.gltf.write;

import java.util.HashSet;
import java.util.Set;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** Reports what glTF cannot hold, once per kind, with the first place. */
final class GltfLosses {
  private final Set<String> told = new HashSet<>();
  private final ProblemCollector problems;

  GltfLosses(ProblemCollector problems) {
    this.problems = problems;
  }

  ProblemCollector problems() {
    return problems;
  }

  /** Reports a node whose type glTF has nothing for. */
  void node(NodeView node) {
    String type = node.type().name();
    tell(
        type,
        node.location(),
        "glTF has nothing for %s; this one and all others are left out".formatted(type));
  }

  /**
   * Reports a loss, unless one of that kind has been reported.
   *
   * @param kind a key that is equal for losses of the same kind
   */
  void tell(String kind, SourceLocation place, String message) {
    if (told.add(kind)) {
      problems.warning(place, message);
    }
  }
}
