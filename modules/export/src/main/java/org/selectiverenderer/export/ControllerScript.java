package org.selectiverenderer.export;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.export.ControlledNodes.Area;
import org.selectiverenderer.export.ControlledNodes.Lot;
import org.selectiverenderer.export.ControlledNodes.VersionedObject;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/**
 * The selective rendering controller as an X3D Script (X3D 4.0, 29.4.1): rules that are the same
 * for every scene, fields with what the metadata of this scene say, and ROUTEs.
 */
final class ControllerScript {
  private static final String RULES = "schema-controller.js";

  private final ControlledNodes nodes;
  private final String def;

  /**
   * @param def DEF name of the Script
   */
  ControllerScript(ControlledNodes nodes, String def) {
    this.nodes = nodes;
    this.def = def;
  }

  /**
   * Returns the Script and its ROUTEs as lines of X3D XML.
   *
   * @param condition the value of the field {@code condition}
   * @param seed the value of the field {@code seed}
   */
  List<String> lines(Condition condition, int seed) {
    List<String> lines = new ArrayList<>();
    lines.add("<Script DEF=\"" + MarkupEscaper.attribute(def) + "\">");
    fields(condition, seed).forEach(field -> lines.add("  " + field));
    lines.add("  <![CDATA[ecmascript:");
    lines.addAll(rules());
    lines.addAll(adapters());
    lines.add("  ]]>");
    lines.add("</Script>");
    lines.addAll(routes());
    return lines;
  }

  private List<String> fields(Condition condition, int seed) {
    List<SensorSchemas> areas = nodes.areas().stream().map(Area::schemas).toList();
    List<VersionedObject> objects = nodes.objects();
    List<String> fields = new ArrayList<>();
    fields.add(value("condition", "SFString", condition.spelling()));
    fields.add(value("seed", "SFInt32", Integer.toString(seed)));
    fields.add(event("setCondition", "SFString", "inputOnly"));
    fields.add(event("setSeed", "SFInt32", "inputOnly"));
    fields.add(strings("areaNames", nodes.areas().stream().map(Area::def).toList()));
    lists("enter", areas.stream().map(SensorSchemas::enter).toList(), fields);
    lists("exit", areas.stream().map(SensorSchemas::exit).toList(), fields);
    fields.add(strings("objectNames", objects.stream().map(VersionedObject::def).toList()));
    List<SwitchSchemas> schemas = nodes.schemas();
    fields.add(
        strings("fieldNames", nodes.fields().stream().map(f -> f.target().toString()).toList()));
    var choices = schemas.stream().map(SwitchSchemas::choiceBySchema).toList();
    lists("choice", choices.stream().map(choice -> choice.keySet()).toList(), fields);
    fields.add(integers("choices", choices.stream().flatMap(c -> c.values().stream()).toList()));
    List<Integer> shown = new ArrayList<>();
    objects.forEach(object -> shown.add(object.whichChoice()));
    nodes.fields().forEach(field -> shown.add(field.shown()));
    fields.add(integers("shown", shown));
    fields.add(integers("most", nodes.choices(Condition.HIGH, 0)));
    fields.add(integers("least", schemas.stream().map(SwitchSchemas::leastDetailed).toList()));
    fields.add(integers("highLow", nodes.choices(Condition.HIGH_LOW, 0)));
    List<Lot> lots = nodes.lots();
    fields.add(integers("lotLengths", lots.stream().map(lot -> lot.members().size()).toList()));
    fields.add(
        integers("lotMembers", lots.stream().flatMap(lot -> lot.members().stream()).toList()));
    fields.add(integers("lotSeeds", lots.stream().map(Lot::seed).toList()));
    for (int i = 0; i < areas.size(); i++) {
      fields.add(event("enter" + i, "SFTime", "inputOnly"));
      fields.add(event("exit" + i, "SFTime", "inputOnly"));
    }
    for (int i = 0; i < objects.size(); i++) {
      fields.add(event("choice" + i, "SFInt32", "outputOnly"));
      if (objects.get(i).routed()) {
        fields.add(event("changed" + i, "SFInt32", "inputOnly"));
      }
    }
    for (int i = 0; i < nodes.fields().size(); i++) {
      values(i, nodes.fields().get(i), fields);
    }
    return fields;
  }

  /** Adds the values of a field, the output that sets it, and the input that tells of others. */
  private static void values(int i, ControlledField field, List<String> fields) {
    String type = field.type().name();
    for (int level = 0; level < field.levels().size(); level++) {
      fields.add(value(level(i, level, field), type, field.levels().get(level)));
    }
    field.begin().ifPresent(text -> fields.add(value(begin(i, field), type, text)));
    fields.add(event("value" + i, type, "outputOnly"));
    if (field.routed()) {
      fields.add(event("valueChanged" + i, type, "inputOnly"));
    }
  }

  /** Returns the name of a level's value; one that ends with url is known to hold urls. */
  private static String level(int field, int level, ControlledField of) {
    return "level%d_%d_%s".formatted(field, level, identifier(of));
  }

  private static String begin(int field, ControlledField of) {
    return "begin%d_%s".formatted(field, identifier(of));
  }

  /** Returns the name of a field with characters of ECMAScript only, as X3D allows more. */
  private static String identifier(ControlledField of) {
    return of.target().field().replaceAll("[^A-Za-z0-9_]", "_");
  }

  private static void lists(
      String name, List<? extends Collection<String>> lists, List<String> fields) {
    fields.add(integers(name + "Lengths", lists.stream().map(Collection::size).toList()));
    fields.add(strings(name + "Schemas", lists.stream().flatMap(Collection::stream).toList()));
  }

  private static String strings(String name, List<String> values) {
    return value(name, "MFString", FieldValueFormatter.strings(values));
  }

  private static String integers(String name, List<Integer> values) {
    return value(
        name, "MFInt32", values.stream().map(String::valueOf).collect(Collectors.joining(" ")));
  }

  private static String value(String name, String type, String value) {
    return "<field accessType=\"initializeOnly\" name=\"%s\" type=\"%s\" value=\"%s\"/>"
        .formatted(name, type, MarkupEscaper.attribute(value));
  }

  private static String event(String name, String type, String access) {
    return "<field accessType=\"%s\" name=\"%s\" type=\"%s\"/>".formatted(access, name, type);
  }

  /** Returns the functions of the single areas, and the one that writes the outputs. */
  private List<String> adapters() {
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < nodes.areas().size(); i++) {
      for (String way : List.of("enter", "exit")) {
        lines.add(
            "function %s%d(time) { arrived.push({ area: %d, enters: %s }); }"
                .formatted(way, i, i, way.equals("enter")));
      }
    }
    for (int i = 0; i < nodes.objects().size(); i++) {
      if (nodes.objects().get(i).routed()) {
        lines.add("function changed%d(choice) { now[%d] = choice; }".formatted(i, i));
      }
    }
    for (int i = 0; i < nodes.fields().size(); i++) {
      ControlledField field = nodes.fields().get(i);
      if (field.routed()) {
        List<String> levels = new ArrayList<>();
        for (int level = 0; level < field.levels().size(); level++) {
          levels.add(level(i, level, field));
        }
        lines.add(
            "function valueChanged%d(value) { now[%d] = levelOf(value, [%s]); }"
                .formatted(i, nodes.objects().size() + i, String.join(", ", levels)));
      }
    }
    lines.add("");
    lines.add("function send(object, choice) {");
    lines.add("  switch (object) {");
    for (int i = 0; i < nodes.objects().size(); i++) {
      lines.add("    case %d: choice%d = choice; break;".formatted(i, i));
    }
    for (int i = 0; i < nodes.fields().size(); i++) {
      ControlledField field = nodes.fields().get(i);
      lines.add("    case %d:".formatted(nodes.objects().size() + i));
      for (int level = 0; level < field.levels().size(); level++) {
        lines.add(
            "      if (choice == %d) { value%d = %s; }"
                .formatted(level, i, level(i, level, field)));
      }
      if (field.begin().isPresent()) {
        lines.add("      if (choice < 0) { value%d = %s; }".formatted(i, begin(i, field)));
      }
      lines.add("      break;");
    }
    lines.add("  }");
    lines.add("}");
    return lines;
  }

  private List<String> routes() {
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < nodes.areas().size(); i++) {
      String area = nodes.areas().get(i).def();
      lines.add(route(area, "enterTime", def, "enter" + i));
      lines.add(route(area, "exitTime", def, "exit" + i));
    }
    for (int i = 0; i < nodes.objects().size(); i++) {
      VersionedObject object = nodes.objects().get(i);
      lines.add(route(def, "choice" + i, object.def(), "whichChoice"));
      if (object.routed()) {
        // What another ROUTE shows is what the next step compares with.
        lines.add(route(object.def(), "whichChoice", def, "changed" + i));
      }
    }
    for (int i = 0; i < nodes.fields().size(); i++) {
      ControlledField field = nodes.fields().get(i);
      lines.add(route(def, "value" + i, field.target().node(), field.target().field()));
      if (field.routed()) {
        lines.add(route(field.target().node(), field.target().field(), def, "valueChanged" + i));
      }
    }
    return lines;
  }

  /** Returns a ROUTE in X3D XML. */
  static String route(String from, String output, String to, String input) {
    return "<ROUTE fromField=\"%s\" fromNode=\"%s\" toField=\"%s\" toNode=\"%s\"/>"
        .formatted(output, MarkupEscaper.attribute(from), input, MarkupEscaper.attribute(to));
  }

  private static List<String> rules() {
    try (InputStream in = ControllerScript.class.getResourceAsStream(RULES)) {
      String text =
          new String(Objects.requireNonNull(in).readAllBytes(), StandardCharsets.US_ASCII);
      return text.lines().toList();
    } catch (IOException e) {
      throw new IllegalStateException(RULES + " of the jar cannot be read", e);
    }
  }
}
