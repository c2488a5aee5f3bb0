package org.selectiverenderer.validation.language;

import java.util.List;
import org.selectiverenderer.validation.Rule;

/**
 * Declares the rules SR110 to SR119, about containment, that is, which nodes and statements may
 * contain which.
 */
final class ContainmentRules {
  static final Rule MISPLACED_NODE =
      Rule.error("SR111", "a {child} is not allowed in a {parent}")
          .because("No field of the parent accepts such a node, so it is left out.")
          .bad("<Group><Box/></Group>")
          .good("<Group><Shape><Box/></Shape></Group>")
          .see("X3D 4.0 XML encoding, 4.3.6");

  static final Rule CONTAINER_FIELD =
      Rule.warning(
              "SR112", "a {child} does not fit into the field {field} of a {parent}{suggestion}")
          .because(
              """
              This program uses a field that accepts the node; other browsers may leave the \
              node out. Write a containerField that the parent has, or none.""")
          .bad("<Shape><Box containerField='children'/></Shape>")
          .good("<Shape><Box/></Shape>")
          .see("X3D 4.0 XML encoding, 4.3.6");

  static final Rule TWICE =
      Rule.error(
              "SR113", "the {field} of a {parent} can be only one node, and there is one already")
          .because("A second node for the same field is left out.")
          .bad("<Shape><Box/><Sphere/></Shape>")
          .good("<Shape><Box/></Shape>\n<Shape><Sphere/></Shape>")
          .see("X3D 4.0, 5.3.9 (SFNode)");

  static final Rule MISPLACED_STATEMENT =
      Rule.error("SR114", "{element} is not allowed in {parent}")
          .because("Each statement has its own place; elsewhere it is left out.")
          .bad("<meta name='title' content='x'/>")
          .good(
              "<?xml version='1.0' encoding='UTF-8'?>\n<X3D profile='Immersive' version='4.0'>\n"
                  + "  <head><meta name='title' content='x'/></head>\n  <Scene/>\n</X3D>")
          .see("X3D 4.0 XML encoding, 4.3");

  static final Rule TOP =
      Rule.warning("SR115", "a {node} at the top of a scene is not shown; put it into another node")
          .because("The top of a scene may contain only nodes that may be children of groups.")
          .bad("<Box/>")
          .good("<Shape><Box/></Shape>")
          .see("X3D 4.0, 4.3.2");

  static final Rule NO_SCENE =
      Rule.error("SR116", "an X3D file has one Scene; this one has {count}")
          .because("All nodes must be in one element Scene; not all browsers read further ones.")
          .bad("<?xml version='1.0' encoding='UTF-8'?>\n<X3D profile='Immersive' version='4.0'/>")
          .good(
              "<?xml version='1.0' encoding='UTF-8'?>\n<X3D profile='Immersive' version='4.0'>\n"
                  + "  <Scene/>\n</X3D>")
          .see("X3D 4.0 XML encoding, 4.3.5");

  static final List<Rule> ALL =
      List.of(MISPLACED_NODE, CONTAINER_FIELD, TWICE, MISPLACED_STATEMENT, TOP, NO_SCENE);

  private ContainmentRules() {}
}
