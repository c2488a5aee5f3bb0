package org.selectiverenderer.validation.language;

import java.util.List;
import org.selectiverenderer.validation.Rule;

/** Declares the rules SR140 to SR149, about routes. */
final class RouteRules {
  private static final String SENSOR = "<TimeSensor DEF='Clock'/>\n<Transform DEF='Door'/>\n";

  static final Rule INCOMPLETE =
      Rule.error("SR141", "a ROUTE needs {attribute}")
          .because("A ROUTE without both ends connects nothing.")
          .bad(SENSOR + "<ROUTE fromNode='Clock' fromField='time' toNode='Door'/>")
          .good(
              "<TimeSensor DEF='A'/>\n<TimeSensor DEF='B'/>\n"
                  + "<ROUTE fromNode='A' fromField='stopTime' toNode='B' toField='startTime'/>")
          .see("X3D 4.0, 4.4.8.2");

  static final Rule UNKNOWN_NODE =
      Rule.error("SR142", "no node has the name {name}{suggestion}")
          .because("A ROUTE can name only nodes of its own file or prototype, by their DEF.")
          .bad(
              "<TimeSensor DEF='A'/>\n<TimeSensor DEF='B'/>\n"
                  + "<ROUTE fromNode='C' fromField='stopTime' toNode='B' toField='startTime'/>")
          .good(
              "<TimeSensor DEF='A'/>\n<TimeSensor DEF='B'/>\n"
                  + "<ROUTE fromNode='A' fromField='stopTime' toNode='B' toField='startTime'/>")
          .see("X3D 4.0, 4.4.8.2");

  static final Rule UNKNOWN_FIELD =
      Rule.error("SR143", "{node} has no field {field}{suggestion}")
          .because("The ROUTE is left out.")
          .bad(
              "<TimeSensor DEF='A'/>\n<TimeSensor DEF='B'/>\n"
                  + "<ROUTE fromNode='A' fromField='stopTme' toNode='B' toField='startTime'/>")
          .good(
              "<TimeSensor DEF='A'/>\n<TimeSensor DEF='B'/>\n"
                  + "<ROUTE fromNode='A' fromField='stopTime' toNode='B' toField='startTime'/>")
          .see("X3D 4.0, 4.4.8.2");

  static final Rule DIRECTION =
      Rule.error("SR144", "{end} is {access} and {fault}")
          .because(
              "A ROUTE must lead from a field that sends events to a field that receives "
                  + "them.")
          .bad(
              "<TimeSensor DEF='A'/>\n<TimeSensor DEF='B'/>\n"
                  + "<ROUTE fromNode='A' fromField='stopTime' toNode='B' toField='cycleTime'/>")
          .good(
              "<TimeSensor DEF='A'/>\n<TimeSensor DEF='B'/>\n"
                  + "<ROUTE fromNode='A' fromField='cycleTime' toNode='B' toField='startTime'/>")
          .see("X3D 4.0, 4.4.8.2");

  static final Rule TYPES =
      Rule.error("SR145", "{from} is {fromType} and {to} is {toType}")
          .because("Events keep their type; a ROUTE between different types is left out.")
          .bad(
              SENSOR
                  + "<ROUTE fromNode='Clock' fromField='time' toNode='Door' toField='translation'/>")
          .good(
              SENSOR
                  + "<PositionInterpolator DEF='Way' key='0 1' keyValue='0 0 0, 1 0 0'/>\n"
                  + "<ROUTE fromNode='Clock' fromField='fraction_changed' toNode='Way'"
                  + " toField='set_fraction'/>\n"
                  + "<ROUTE fromNode='Way' fromField='value_changed' toNode='Door'"
                  + " toField='translation'/>")
          .see("X3D 4.0, 4.4.8.2");

  static final Rule REPEATED =
      Rule.warning("SR146", "the same ROUTE occurs above")
          .because(
              "A second ROUTE between the same fields has no effect; usually one of the "
                  + "two should be different.")
          .bad(
              "<TimeSensor DEF='A'/>\n<TimeSensor DEF='B'/>\n"
                  + "<ROUTE fromNode='A' fromField='stopTime' toNode='B' toField='startTime'/>\n"
                  + "<ROUTE fromNode='A' fromField='stopTime' toNode='B' toField='startTime'/>")
          .good(
              "<TimeSensor DEF='A'/>\n<TimeSensor DEF='B'/>\n"
                  + "<ROUTE fromNode='A' fromField='stopTime' toNode='B' toField='startTime'/>")
          .see("X3D 4.0, 4.4.8.2");

  static final List<Rule> ALL =
      List.of(INCOMPLETE, UNKNOWN_NODE, UNKNOWN_FIELD, DIRECTION, TYPES, REPEATED);

  private RouteRules() {}
}
