package org.selectiverenderer.x3d.vrml1;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.vrml1.Vrml1State.Property;

/** Tells what counts now, to those who translate a shape. */
@FunctionalInterface
interface StateReader {
  /** Returns the node that sets a property; null if the default counts. */
  @Nullable Vrml1Node read(Property property);
}
