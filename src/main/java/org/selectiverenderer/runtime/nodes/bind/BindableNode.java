package org.selectiverenderer.runtime.nodes.bind;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A node of which one at a time is in force (X3D 4.0, 7.2.2): Background, TextureBackground, Fog,
 * NavigationInfo, and the base of Viewpoint. It answers {@code set_bind} once its scene's {@link
 * BindStacks} know it.
 */
public class BindableNode extends Node {
  private final int setBind;
  private final int isBound;
  private final int bindTime;
  private @Nullable BindStacks stacks;

  public BindableNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
    setBind = type.indexOf("set_bind");
    isBound = type.indexOf("isBound");
    bindTime = type.indexOf("bindTime");
  }

  final int setBind() {
    return setBind;
  }

  final void join(BindStacks ofScene) {
    stacks = ofScene;
  }

  final void leave() {
    stacks = null;
  }

  /** Sends that it comes into force or no longer is, and when. */
  void sendBound(boolean bound, Cascade cascade) {
    emit(isBound, bound, cascade);
    emit(bindTime, cascade.time(), cascade);
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
    if (field.index() == setBind) {
      if (stacks != null) {
        stacks.setBind(this, (Boolean) value, cascade);
      }
    } else {
      super.receive(field, value, cascade);
    }
  }
}
