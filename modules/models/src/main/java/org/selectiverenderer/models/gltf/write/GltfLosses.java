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

  /**
   * Reports a node whose type glTF has nothing for: as information, if nothing of what is seen,
   * heard or done is lost with it.
   */
  void node(NodeView node) {
    String type = node.type().name();
    String message =
        "glTF has nothing for %s; this one and all others are left out".formatted(type);
    if (type.equals("NavigationInfo")) {
      note(type, node.location(), message);
    } else {
      tell(type, node.location(), message);
    }
  }

  /** Reports, as information, what almost every scene has and glTF has no word for. */
  void note(String kind, SourceLocation place, String message) {
    if (told.add(kind)) {
      problems.info(place, message);
    }
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
