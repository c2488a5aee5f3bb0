package org.selectiverenderer.validation.language;

import java.util.List;
import org.selectiverenderer.validation.Rule;

/** SR11x: what stands in what. */
final class ContainmentRules {
  static final Rule MISPLACED_NODE =
      Rule.error("SR111", "a {child} cannot stand in a {parent}")
          .because("No field of the parent takes such a node, so it is left out.")
          .bad("<Group><Box/></Group>")
          .good("<Group><Shape><Box/></Shape></Group>")
          .see("X3D 4.0 XML encoding, 4.3.6");

  static final Rule CONTAINER_FIELD =
      Rule.warning("SR112", "a {child} does not go into {field} of a {parent}{suggestion}")
          .because(
              """
              This program puts the node where it fits; other browsers may leave it out. Give the \
              containerField that the parent has, or none.""")
          .bad("<Shape><Box containerField='children'/></Shape>")
          .good("<Shape><Box/></Shape>")
          .see("X3D 4.0 XML encoding, 4.3.6");

  static final Rule TWICE =
      Rule.error("SR113", "the {field} of a {parent} is one node and there already")
          .because("A second node for the same field is left out.")
          .bad("<Shape><Box/><Sphere/></Shape>")
          .good("<Shape><Box/></Shape>\n<Shape><Sphere/></Shape>")
          .see("X3D 4.0, 5.3.9 (SFNode)");

  static final Rule MISPLACED_STATEMENT =
      Rule.error("SR114", "{element} does not belong into {parent}")
          .because("Statements have places of their own; elsewhere they are left out.")
          .bad("<meta name='title' content='x'/>")
          .good(
              "<?xml version='1.0' encoding='UTF-8'?>\n<X3D profile='Immersive' version='4.0'>\n"
                  + "  <head><meta name='title' content='x'/></head>\n  <Scene/>\n</X3D>")
          .see("X3D 4.0 XML encoding, 4.3");

  static final Rule TOP =
      Rule.warning(
              "SR115", "a {node} at the top of a scene is not shown; it stands in another node")
          .because("The top of a scene, like a group, holds nodes that are children of groups.")
          .bad("<Box/>")
          .good("<Shape><Box/></Shape>")
          .see("X3D 4.0, 4.3.2");

  static final Rule NO_SCENE =
      Rule.error("SR116", "an X3D file has one Scene; this one has {count}")
          .because(
              "All nodes stand in the element Scene; further ones are not read by all browsers.")
          .bad("<?xml version='1.0' encoding='UTF-8'?>\n<X3D profile='Immersive' version='4.0'/>")
          .good(
              "<?xml version='1.0' encoding='UTF-8'?>\n<X3D profile='Immersive' version='4.0'>\n"
                  + "  <Scene/>\n</X3D>")
          .see("X3D 4.0 XML encoding, 4.3.5");

  static final List<Rule> ALL =
      List.of(MISPLACED_NODE, CONTAINER_FIELD, TWICE, MISPLACED_STATEMENT, TOP, NO_SCENE);

  private ContainmentRules() {}
}
