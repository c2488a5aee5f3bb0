package org.selectiverenderer.x3d.read;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;

/**
 * A ROUTE statement before resolution. Its names refer to the nodes that have them at the position
 * of the ROUTE, or, if there are none yet, at the end of the scope.
 */
record UnresolvedRoute(End from, End to, SourceLocation location) {
  /** One end of a ROUTE. */
  record End(String node, String field, NameScope.@Nullable Named found) {
    @Override
    public String toString() {
      return node + "." + field;
    }
  }
}
