package org.selectiverenderer.browser.nodes.script;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.PrototypeInstance;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.script.ScriptProgram;

/**
 * A Script (X3D 4.0, 29.4.1). It holds the program and the fields that its author declared; until a
 * script engine runs the program, it stores and forwards events like any node.
 */
public final class ScriptNode extends Node {
  private @Nullable ScriptProgram program;
  private @Nullable Scene context;
  private @Nullable ScriptEventReceiver calls;
  private @Nullable PrototypeInstance within;

  public ScriptNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
  }

  /**
   * Gives the node its program, before it is part of a world.
   *
   * @param scene the scene of the file that contains the node
   */
  public void load(ScriptProgram text, Scene scene) {
    program = text;
    context = scene;
  }

  /** Returns the program; null if there is no usable one. */
  public @Nullable ScriptProgram program() {
    return program;
  }

  /** Returns the scene that contains the node, its execution context; null without a program. */
  public @Nullable Scene context() {
    return context;
  }

  /** Returns the prototype instance whose body contains the node; null if there is none. */
  public @Nullable PrototypeInstance within() {
    return within;
  }

  public void within(@Nullable PrototypeInstance instance) {
    within = instance;
  }

  /** Sets the receiver of events; null for none. */
  public void calls(@Nullable ScriptEventReceiver receiver) {
    calls = receiver;
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    boolean taken = true;
    if (field.access() == AccessType.INPUT_OUTPUT) {
      taken = emit(field.index(), value, cascade);
    }
    ScriptEventReceiver receiver = calls;
    if (receiver != null && taken && field.index() >= type().ownFrom()) {
      receiver.received(field, value, cascade);
    }
  }
}
