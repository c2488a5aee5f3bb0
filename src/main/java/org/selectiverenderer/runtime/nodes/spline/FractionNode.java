package org.selectiverenderer.runtime.nodes.spline;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.runtime.scene.Cascade;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/** A node that answers each {@code set_fraction} with a computed value. */
final class FractionNode extends Node {
  /** Computes and sends the value for a fraction. */
  @FunctionalInterface
  interface Answer {
    /**
     * @param fraction a Float or, for a surface, two floats; not NaN
     */
    void to(Object fraction, Node node, Cascade cascade);
  }

  private final int fraction;
  private final Answer answer;

  FractionNode(NodeType type, @Nullable String name, Location location, Answer answer) {
    super(type, name, location);
    this.answer = answer;
    fraction = type.indexOf("set_fraction");
  }

  @Override
  protected void receive(FieldDefinition field, @Nullable Object value, Cascade cascade) {
    if (field.index() != fraction || value == null) {
      super.receive(field, value, cascade);
    } else if (!(value instanceof Float number && Float.isNaN(number))) {
      answer.to(value, this, cascade);
    }
  }
}
