package org.selectiverenderer.authoring.structure;

import org.joml.Vector3dc;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The way from a node to its duplicate. */
@FunctionalInterface
public interface DuplicateShift {
  /** Returns the way in metres, in the coordinates of the node's parent. */
  Vector3dc of(DocumentElement node);
}
