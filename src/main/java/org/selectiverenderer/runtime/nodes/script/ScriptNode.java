package org.selectiverenderer.runtime.nodes.script;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.InstanceFace;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.x3d.catalogue.FieldAccess;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.script.ScriptProgram;

/**
 * A Script (X3D 4.0, 29.4.1). It holds its program's text and the fields that its author declared;
 * until somebody runs the program it keeps and passes on events as any node does.
 */
public final class ScriptNode extends Node {
  private @Nullable ScriptProgram program;
  private @Nullable Scene context;
  private @Nullable ScriptCalls calls;
  private @Nullable InstanceFace within;

  public ScriptNode(NodeType type, @Nullable String name, Location location) {
    super(type, name, location);
  }

  /**
   * Gives the node its program, before it is part of a world.
   *
   * @param scene of the file in which it stands
   */
  public void load(ScriptProgram text, Scene scene) {
    program = text;
    context = scene;
  }

  /** The text of its program; null when there is none that can be used. */
  public @Nullable ScriptProgram program() {
    return program;
  }

  /** The scene in which it stands: its execution context. Null without a program. */
  public @Nullable Scene context() {
    return context;
  }

  /** The instance of a prototype in whose body it stands; null if it stands in none. */
  public @Nullable InstanceFace within() {
    return within;
  }

  public void within(@Nullable InstanceFace instance) {
    within = instance;
  }

  /** What it receives goes there from now on; to nobody with null. */
  public void calls(@Nullable ScriptCalls receiver) {
    calls = receiver;
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
    boolean taken = true;
    if (field.access() == FieldAccess.INPUT_OUTPUT) {
      taken = emit(field.index(), value, cascade);
    }
    ScriptCalls receiver = calls;
    if (receiver != null && taken && field.index() >= type().ownFrom()) {
      receiver.received(field, value, cascade);
    }
  }
}
