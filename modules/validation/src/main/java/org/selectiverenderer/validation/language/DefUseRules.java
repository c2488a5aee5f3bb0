package org.selectiverenderer.validation.language;

import java.util.List;
import org.selectiverenderer.validation.Rule;

/** Declares the rules SR130 to SR139, about DEF, USE, IMPORT and EXPORT. */
final class DefUseRules {
  static final Rule UNKNOWN =
      Rule.error("SR131", "no node above has the name {name}{suggestion}")
          .because(
              """
              A USE refers to a node that got its name by DEF further up in the same file or \
              prototype. Without such a node the USE shows nothing.""")
          .bad("<Shape DEF='Chair'><Box/></Shape>\n<Shape USE='Chiar'/>")
          .good("<Shape DEF='Chair'><Box/></Shape>\n<Shape USE='Chair'/>")
          .see("X3D 4.0, 4.4.3");

  static final Rule CIRCLE =
      Rule.error("SR132", "{name} would contain itself here")
          .because("A node cannot contain itself, directly or through others; the USE is left out.")
          .bad("<Group DEF='All'><Group USE='All'/></Group>")
          .good("<Group DEF='All'/>\n<Group USE='All'/>")
          .see("X3D 4.0, 4.3.2");

  static final Rule OTHER_TYPE =
      Rule.warning("SR133", "{name} is a {actual}, not a {written}")
          .because("A USE must have the type of its node; this program uses the named node.")
          .bad("<Shape DEF='Chair'><Box/></Shape>\n<Group USE='Chair'/>")
          .good("<Shape DEF='Chair'><Box/></Shape>\n<Shape USE='Chair'/>")
          .see("X3D 4.0 XML encoding, 4.3.7");

  static final Rule TWICE =
      Rule.warning("SR134", "the name {name} is used already by a {type} above")
          .because(
              """
              Names must be unique in a file. From here on the name means this node; in some \
              browsers also for ROUTEs above it.""")
          .bad("<Group DEF='Desk'/>\n<Group DEF='Desk'/>")
          .good("<Group DEF='Desk'/>\n<Group DEF='Desk2'/>")
          .see("X3D 4.0, 4.4.3");

  static final Rule BAD_NAME =
      Rule.warning("SR135", "'{name}' is not a valid name: {why}")
          .because("Programs that convert the scene, or check it as XML, refuse such names.")
          .bad("<Group DEF='my desk'/>")
          .good("<Group DEF='my_desk'/>")
          .see(
              "X3D 4.0 XML encoding, 4.3.7; XML 1.0, 2.3 (Nmtoken); Classic VRML encoding, 5.2 (Id)");

  static final Rule MORE_THAN_USE =
      Rule.warning("SR136", "an element with USE has {what}, which {means}")
          .because(
              "USE repeats a node without changes; something different needs a node of "
                  + "its own.")
          .bad("<Transform DEF='T'/>\n<Transform USE='T' translation='1 0 0'/>")
          .good(
              "<Transform DEF='T'/>\n<Transform translation='1 0 0'><Transform USE='T'/></Transform>")
          .see("X3D 4.0 XML encoding, 4.3.7");

  static final Rule LINK =
      Rule.error("SR137", "{fault}")
          .about("an IMPORT or EXPORT that names nothing")
          .because(
              "IMPORT and EXPORT connect names of a file and of an inlined file; "
                  + "both names must exist.")
          .bad("<EXPORT localDEF='Dor'/>\n<Group DEF='Door'/>")
          .good("<EXPORT localDEF='Door'/>\n<Group DEF='Door'/>")
          .see("X3D 4.0, 4.4.6");

  static final List<Rule> ALL =
      List.of(UNKNOWN, CIRCLE, OTHER_TYPE, TWICE, BAD_NAME, MORE_THAN_USE, LINK);

  private DefUseRules() {}
}
