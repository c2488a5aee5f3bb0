package org.selectiverenderer.validation.language;

import java.util.List;
import org.selectiverenderer.validation.Rule;

/** Declares the rules SR100 to SR109, about elements, attributes and their values. */
final class FieldRules {
  static final Rule UNKNOWN_ELEMENT =
      Rule.error("SR101", "X3D 4.0 has no element {element}{suggestion}")
          .because(
              "A browser leaves out an element that it does not know, with everything "
                  + "inside it.")
          .bad("<Shpe><Box/></Shpe>")
          .good("<Shape><Box/></Shape>")
          .see("X3D 4.0 XML encoding, clause 6");

  static final Rule UNKNOWN_ATTRIBUTE =
      Rule.error("SR102", "{element} has no {attribute}{suggestion}")
          .because(
              """
              A browser ignores an attribute that it does not know, so the field keeps its \
              default, which is rarely intended.""")
          .bad("<Switch whichChoise='0'><Group/></Switch>")
          .good("<Switch whichChoice='0'><Group/></Switch>")
          .see("X3D 4.0, the node's own clause");

  static final Rule VALUE =
      Rule.error("SR103", "{field}: {fault}")
          .about("a value does not have its field's type")
          .because("A value that does not have its field's type is read in part or not at all.")
          .bad("<Transform translation='1 2'/>")
          .good("<Transform translation='1 2 0'/>")
          .see("X3D 4.0, 5.3; X3D XML encoding, clause 5");

  static final Rule LOOSE_VALUE =
      Rule.warning("SR104", "{field}: {fault}")
          .about("a value is not spelled as the standard demands")
          .because("This program understands the value; stricter programs do not.")
          .bad("<Switch whichChoice='0' visible='TRUE'><Group/></Switch>")
          .good("<Switch whichChoice='0' visible='true'><Group/></Switch>")
          .see("X3D 4.0 XML encoding, clause 5");

  static final Rule RANGE =
      Rule.warning("SR105", "{field} is {value}, but {bound}")
          .because(
              """
              Browsers use the nearest allowed value or some other one, so the scene looks \
              different in each of them.""")
          .bad("<Shape><Appearance><Material transparency='1.5'/></Appearance><Box/></Shape>")
          .good("<Shape><Appearance><Material transparency='1'/></Appearance><Box/></Shape>")
          .see("X3D 4.0, the node's own clause");

  static final Rule CHOICE =
      Rule.warning("SR106", "{field} has no value '{value}'{suggestion}")
          .because("The field accepts only certain words; for any other the default is used.")
          .bad("<Fog fogType='LINEER' visibilityRange='10'/>")
          .good("<Fog fogType='LINEAR' visibilityRange='10'/>")
          .see("X3D 4.0, the node's own clause");

  static final Rule ACCESS =
      Rule.error(
              "SR107",
              "{field} of {node} is {access}: it is for events and cannot have a "
                  + "value in a file")
          .because("Give the value by a ROUTE or a script, or set the field that belongs to it.")
          .bad("<Viewpoint set_bind='true'/>")
          .good("<Viewpoint/>")
          .see("X3D 4.0, 4.4.2.2");

  static final Rule NODE_AS_ATTRIBUTE =
      Rule.error("SR108", "{field} of {node} contains nodes; write them as child elements")
          .because("In the XML encoding only simple values can be attributes.")
          .bad("<Shape geometry='Box'/>")
          .good("<Shape><Box/></Shape>")
          .see("X3D 4.0 XML encoding, 4.3.5");

  static final Rule OLD_SPELLING =
      Rule.warning("SR109", "{old} is a spelling of VRML or X3D 3; X3D 4.0 calls it {now}")
          .because("Some browsers still read it, others do not.")
          .bad("<Switch whichChoice='0'><Group containerField='choice'/></Switch>")
          .good("<Switch whichChoice='0'><Group/></Switch>")
          .see("X3D 4.0, 10.4.4 (Switch), 23.4.3 (LOD)");

  static final List<Rule> ALL =
      List.of(
          UNKNOWN_ELEMENT,
          UNKNOWN_ATTRIBUTE,
          VALUE,
          LOOSE_VALUE,
          RANGE,
          CHOICE,
          ACCESS,
          NODE_AS_ATTRIBUTE,
          OLD_SPELLING);

  private FieldRules() {}
}
