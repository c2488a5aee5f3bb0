package org.selectiverenderer.browser.scene;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeType;

/** Makes a node of a type, with all fields at their defaults. */
@FunctionalInterface
public interface NodeConstructor {
  Node make(NodeType type, @Nullable String name, SourceLocation location);
}
