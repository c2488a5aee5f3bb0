package org.selectiverenderer.runtime.scene;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.FieldAccess;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * The interface of an instance as a node: it passes events on to the fields that its own stand for,
 * and theirs to whoever listens to it. A field that stands for none keeps its value, as any node's.
 */
final class FaceNode extends Node {
  /** Takes what the body sends; the interface itself takes what the body is to get. */
  private static final class Outlet extends Node {
    private final FaceNode face;

    Outlet(FaceNode face) {
      super(face.type(), null, face.location());
      this.face = face;
    }

    @Override
    protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
      face.emit(field.index(), value, cascade);
    }
  }

  private final InstanceFace face;
  private @Nullable Outlet outlet;

  FaceNode(InstanceFace face, NodeType type, Node body) {
    super(type, body.name(), body.location());
    this.face = face;
  }

  InstanceFace shown() {
    return face;
  }

  /** The value of a field as it is now: the body's, where that has one. */
  @Nullable Object current(int field) {
    for (InstanceFace.Link link : face.links()) {
      if (link.field() == field && link.holds()) {
        return link.node().value(link.nodeField());
      }
    }
    return value(field);
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
    boolean taken = false;
    boolean answered = false;
    for (InstanceFace.Link link : face.links()) {
      if (link.field() == field.index() && link.takes()) {
        cascade.deliver(link.node(), link.nodeField(), value);
        taken = true;
        answered |= link.sends();
      }
    }
    if (!taken) {
      super.receive(field, value, cascade);
    } else if (!answered && field.access() == FieldAccess.INPUT_OUTPUT) {
      emit(field.index(), value, cascade);
    }
  }

  /** Brings the events of the body here, from when somebody wants to hear them. */
  @Override
  void heardFrom(int field) {
    if (heard(field)) {
      return;
    }
    if (outlet == null) {
      outlet = new Outlet(this);
    }
    for (InstanceFace.Link link : face.links()) {
      if (link.field() == field && link.sends()) {
        link.node().connect(new Route(link.node(), link.nodeField(), outlet, field));
      }
    }
  }
}
