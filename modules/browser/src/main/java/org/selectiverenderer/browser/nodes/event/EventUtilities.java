package org.selectiverenderer.browser.nodes.event;

import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.NodeConstructor;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/** The filters and triggers of X3D 4.0, 30.4, which answer an input event with an output event. */
public final class EventUtilities {
  private EventUtilities() {}

  public static final Map<String, NodeConstructor> MAKERS =
      Map.of(
          "BooleanFilter", answering("set_boolean", EventUtilities::filter),
          "BooleanToggle", answering("set_boolean", EventUtilities::toggle),
          "BooleanTrigger", answering("set_triggerTime", EventUtilities::triggerTrue),
          "IntegerTrigger", answering("set_boolean", EventUtilities::triggerInteger),
          "TimeTrigger", answering("set_boolean", EventUtilities::triggerTime));

  @FunctionalInterface
  private interface Answer {
    void to(Object value, Node node, EventCascade cascade);
  }

  private static NodeConstructor answering(String input, Answer answer) {
    return (type, name, location) -> new AnsweringNode(type, name, location, input, answer);
  }

  private static final class AnsweringNode extends Node {
    private final int input;
    private final Answer answer;

    AnsweringNode(
        NodeType type,
        @Nullable String name,
        SourceLocation location,
        String input,
        Answer answer) {
      super(type, name, location);
      this.input = type.indexOf(input);
      this.answer = answer;
    }

    @Override
    protected void receive(FieldDefinition field, @Nullable Object value, EventCascade cascade) {
      if (field.index() == input && value != null) {
        answer.to(value, this, cascade);
      } else {
        super.receive(field, value, cascade);
      }
    }
  }

  /**
   * BooleanFilter (30.4.1): forwards TRUE as inputTrue, FALSE as inputFalse, and the negated value
   * as inputNegate.
   */
  private static void filter(Object value, Node node, EventCascade cascade) {
    boolean is = (Boolean) value;
    send(node, is ? "inputTrue" : "inputFalse", is, cascade);
    send(node, "inputNegate", !is, cascade);
  }

  /** BooleanToggle (30.4.3): TRUE inverts the toggle, FALSE does nothing. */
  private static void toggle(Object value, Node node, EventCascade cascade) {
    if ((Boolean) value) {
      send(node, "toggle", !node.bool("toggle"), cascade);
    }
  }

  /** BooleanTrigger (30.4.4): a time sends TRUE. */
  private static void triggerTrue(Object value, Node node, EventCascade cascade) {
    send(node, "triggerTrue", true, cascade);
  }

  /**
   * IntegerTrigger (30.4.6): TRUE sends the key; FALSE, which the standard leaves undefined, does
   * nothing.
   */
  private static void triggerInteger(Object value, Node node, EventCascade cascade) {
    if ((Boolean) value) {
      send(node, "triggerValue", node.integer("integerKey"), cascade);
    }
  }

  /** TimeTrigger (30.4.7): any value sends its time stamp. */
  private static void triggerTime(Object value, Node node, EventCascade cascade) {
    send(node, "triggerTime", cascade.time(), cascade);
  }

  private static void send(Node node, String field, Object value, EventCascade cascade) {
    node.emit(node.type().indexOf(field), value, cascade);
  }
}
