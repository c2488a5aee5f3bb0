package org.selectiverenderer.browser.nodes.group;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeType;

/** Switch: shows one of its children, or none (X3D 4.0, 10.4.3; thesis 2.5.3). */
public final class SwitchNode extends GroupingNode {
  private final int whichChoice;

  public SwitchNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    whichChoice = type.indexOf("whichChoice");
  }

  /** Returns the index of the child shown; a value that is no index shows none. */
  public int whichChoice() {
    return (Integer) value(whichChoice);
  }

  @Override
  public boolean shows(int child) {
    return visible() && child == whichChoice();
  }

  @Override
  public Effect effectOf(int field) {
    return field == whichChoice ? Effect.CHOICE : super.effectOf(field);
  }
}
