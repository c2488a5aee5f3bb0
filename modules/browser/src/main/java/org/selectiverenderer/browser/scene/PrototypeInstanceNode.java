package org.selectiverenderer.browser.scene;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * A prototype instance as a node: forwards events between the fields of its interface and the
 * fields of body nodes that they are connected to by IS. A field without a connection stores its
 * value like that of any node.
 */
final class PrototypeInstanceNode extends Node {
  /**
   * Receives the events that the body sends; the enclosing node receives those that go to the body.
   */
  private static final class Outlet extends Node {
    private final PrototypeInstanceNode face;

    Outlet(PrototypeInstanceNode face) {
      super(face.type(), null, face.location());
      this.face = face;
    }

    @Override
    protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
      face.emit(field.index(), value, cascade);
    }
  }

  private final PrototypeInstance face;
  private @Nullable Outlet outlet;

  PrototypeInstanceNode(PrototypeInstance face, NodeType type, Node body) {
    super(type, body.name(), body.location());
    this.face = face;
  }

  PrototypeInstance shown() {
    return face;
  }

  /** Returns the present value of a field: that of the connected body field, if there is one. */
  @Nullable Object current(int field) {
    for (PrototypeInstance.Link link : face.links()) {
      if (link.field() == field && link.holds()) {
        return link.node().value(link.nodeField());
      }
    }
    return value(field);
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
    boolean taken = false;
    boolean answered = false;
    for (PrototypeInstance.Link link : face.links()) {
      if (link.field() == field.index() && link.takes()) {
        cascade.deliver(link.node(), link.nodeField(), value);
        taken = true;
        answered |= link.sends();
      }
    }
    if (!taken) {
      super.receive(field, value, cascade);
    } else if (!answered && field.access() == AccessType.INPUT_OUTPUT) {
      emit(field.index(), value, cascade);
    }
  }

  /** Connects the events of the body when the first listener is added. */
  @Override
  void heardFrom(int field) {
    if (heard(field)) {
      return;
    }
    if (outlet == null) {
      outlet = new Outlet(this);
    }
    for (PrototypeInstance.Link link : face.links()) {
      if (link.field() == field && link.sends()) {
        link.node().connect(new Route(link.node(), link.nodeField(), outlet, field));
      }
    }
  }
}
