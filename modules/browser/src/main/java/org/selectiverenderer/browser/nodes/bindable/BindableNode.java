package org.selectiverenderer.browser.nodes.bindable;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A bindable node, of whose kind one is bound at a time (X3D 4.0, X3DBindableNode, 7.2.2):
 * Background, TextureBackground, Fog, NavigationInfo, and the base class of Viewpoint. It reacts to
 * {@code set_bind} once its scene's {@link BindingStacks} know it.
 */
public class BindableNode extends Node {
  private final int setBind;
  private final int isBound;
  private final int bindTime;
  private @Nullable BindingStacks stacks;

  public BindableNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    setBind = type.indexOf("set_bind");
    isBound = type.indexOf("isBound");
    bindTime = type.indexOf("bindTime");
  }

  final int setBind() {
    return setBind;
  }

  final void join(BindingStacks ofScene) {
    stacks = ofScene;
  }

  final void leave() {
    stacks = null;
  }

  /** Sends {@code isBound} and {@code bindTime}. */
  void sendBound(boolean bound, EventCascade cascade) {
    emit(isBound, bound, cascade);
    emit(bindTime, cascade.time(), cascade);
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    if (field.index() == setBind) {
      if (stacks != null) {
        stacks.setBind(this, (Boolean) value, cascade);
      }
    } else {
      super.receive(field, value, cascade);
    }
  }
}
