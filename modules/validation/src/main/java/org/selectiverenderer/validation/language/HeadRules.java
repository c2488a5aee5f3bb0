package org.selectiverenderer.validation.language;

import java.util.List;
import org.selectiverenderer.validation.Rule;

/** Declares the rules SR120 to SR129, about version, profile, components and the head. */
final class HeadRules {
  private static final String HEAD = "<?xml version='1.0' encoding='UTF-8'?>\n";

  static final Rule VERSION =
      Rule.warning("SR121", "{fault}")
          .about("the version is missing or not a version of X3D")
          .because(
              """
              The version states which nodes a browser must know. This program reads every \
              file as 4.0; others refuse a file without a version.""")
          .bad(HEAD + "<X3D profile='Immersive'><Scene/></X3D>")
          .good(HEAD + "<X3D profile='Immersive' version='4.0'><Scene/></X3D>")
          .see("X3D 4.0 XML encoding, 4.3.3");

  static final Rule PROFILE =
      Rule.warning("SR122", "{fault}")
          .about("the profile is missing or not a profile of X3D")
          .because(
              "A browser loads what the profile names. Without a profile it may refuse "
                  + "the file.")
          .bad(HEAD + "<X3D profile='Imersive' version='4.0'><Scene/></X3D>")
          .good(HEAD + "<X3D profile='Immersive' version='4.0'><Scene/></X3D>")
          .see("X3D 4.0, 7.2.5.3");

  static final Rule COMPONENT =
      Rule.warning("SR123", "{fault}")
          .about("there is no such component or level")
          .because("A browser that does not have the component at that level refuses the file.")
          .bad(
              HEAD
                  + "<X3D profile='Core' version='4.0'>\n"
                  + "  <head><component name='Groping' level='1'/></head>\n  <Scene/>\n</X3D>")
          .good(
              HEAD
                  + "<X3D profile='Core' version='4.0'>\n"
                  + "  <head><component name='Grouping' level='1'/></head>\n  <Scene/>\n</X3D>")
          .see("X3D 4.0, 7.2.5.4");

  static final Rule NEEDS_COMPONENT =
      Rule.warning(
              "SR124",
              "{node} needs component {component} level {level}, which profile {profile} does not have")
          .because(
              """
              A browser need not support nodes beyond the profile. Add the component to the \
              head, or name a larger profile. Reported once per component and file.""")
          .bad(
              HEAD
                  + "<X3D profile='Interchange' version='4.0'>\n"
                  + "  <Scene><ProximitySensor size='1 1 1'/></Scene>\n</X3D>")
          .good(
              HEAD
                  + "<X3D profile='Interchange' version='4.0'>\n"
                  + "  <head><component name='EnvironmentalSensor' level='1'/></head>\n"
                  + "  <Scene><ProximitySensor size='1 1 1'/></Scene>\n</X3D>")
          .see("X3D 4.0, annexes A to H");

  static final Rule NEWER =
      Rule.warning("SR125", "{what} came with X3D {since}, but the file says version {version}")
          .because(
              """
              A browser of the stated version does not know it. State the later version. \
              Reported once per node type or field and file.""")
          .bad(
              HEAD
                  + "<X3D profile='Immersive' version='3.3'>\n"
                  + "  <Scene><Shape><Appearance><PhysicalMaterial/></Appearance><Box/></Shape></Scene>\n"
                  + "</X3D>")
          .good(
              HEAD
                  + "<X3D profile='Full' version='4.0'>\n"
                  + "  <Scene><Shape><Appearance><PhysicalMaterial/></Appearance><Box/></Shape></Scene>\n"
                  + "</X3D>")
          .see("ISO/IEC 19775-1, editions of 2004 to 2023");

  static final Rule ORDER =
      Rule.warning("SR126", "{element} must not come {place}")
          .because(
              """
              The standard demands head before Scene, and in the head first components, then \
              units, then meta. This program reads any order.""")
          .bad(HEAD + "<X3D profile='Immersive' version='4.0'>\n  <Scene/>\n  <head/>\n</X3D>")
          .good(HEAD + "<X3D profile='Immersive' version='4.0'>\n  <head/>\n  <Scene/>\n</X3D>")
          .see("X3D 4.0 XML encoding, 4.3.3 and 4.3.4");

  static final Rule INCOMPLETE =
      Rule.warning("SR127", "{element} needs {attribute}")
          .because("Without it the statement has no effect.")
          .bad(
              HEAD
                  + "<X3D profile='Immersive' version='4.0'>\n"
                  + "  <head><meta name='title'/></head>\n  <Scene/>\n</X3D>")
          .good(
              HEAD
                  + "<X3D profile='Immersive' version='4.0'>\n"
                  + "  <head><meta name='title' content='Office'/></head>\n  <Scene/>\n</X3D>")
          .see("X3D 4.0, 7.2.5");

  static final Rule YOUNGER =
      Rule.warning("SR128", "{node} is a node of X3D 4.1; this program leaves it out")
          .because(
              """
              X3D 4.0 is the last edition that is a standard. Of the draft of 4.1 this program knows \
              EnvironmentLight, Tangent, and X_ITE's InstancedShape.""")
          .bad("<RenderedTexture/>")
          .good("<ImageTexture url='\"picture.png\"'/>")
          .see("draft of X3D 4.1");

  static final List<Rule> ALL =
      List.of(VERSION, PROFILE, COMPONENT, NEEDS_COMPONENT, NEWER, ORDER, INCOMPLETE, YOUNGER);

  private HeadRules() {}
}
