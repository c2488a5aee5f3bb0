package org.selectiverenderer.x3d.read;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;

/**
 * A ROUTE as it is written. Its ends are the nodes that have the names where the ROUTE stands, or,
 * if there are none yet, those that have them at the end of the scope.
 */
record PendingRoute(End from, End to, Location location) {
  /** One end of a ROUTE. */
  record End(String node, String field, NameScope.@Nullable Named found) {
    @Override
    public String toString() {
      return node + "." + field;
    }
  }
}
