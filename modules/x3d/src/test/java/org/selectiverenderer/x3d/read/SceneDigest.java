package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.selectiverenderer.x3d.catalogue.ContainerFieldRules;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.LegacyFieldNames;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/**
 * Writes what a scene says as lines of text that are equal for equal scenes of all encodings:
 * without places, without the spelling of numbers, and without the order of nodes in different
 * fields.
 */
final class SceneDigest {
  private static final String LANGUAGE = "(?si)^\\s*(ecmascript|javascript|vrmlscript):";

  private final NodeCatalogue catalogue;

  SceneDigest(NodeCatalogue catalogue) {
    this.catalogue = catalogue;
  }

  /** Returns the lines of a scene as the browser runs it, with its prototypes expanded. */
  List<String> scene(X3dFile file) {
    List<String> said = new ArrayList<>();
    said.add(file.profile() + file.components() + file.meta() + file.units());
    Map<ParsedNode, Integer> seen = new IdentityHashMap<>();
    file.allNodes().forEach(node -> say(node, "", seen, said));
    file.routes().stream()
        .map(r -> end(r.from(), r.fromField(), seen) + " to " + end(r.to(), r.toField(), seen))
        .sorted()
        .forEach(said::add);
    file.importedRoutes().stream()
        .map(route -> end(route.from(), seen) + " to " + end(route.to(), seen))
        .sorted()
        .forEach(said::add);
    file.imports().forEach(i -> said.add(i.inlineDef() + "." + i.importedDef() + " as " + i.as()));
    file.exports().forEach(e -> said.add(e.localDef() + " as " + e.as()));
    said.add(file.named().keySet().stream().sorted().toList().toString());
    return said;
  }

  private static String end(X3dFile.End end, Map<ParsedNode, Integer> seen) {
    return end instanceof X3dFile.End.Own own ? end(own.node(), own.field(), seen) : end.toString();
  }

  private static String end(ParsedNode node, int field, Map<ParsedNode, Integer> seen) {
    return seen.get(node) + "." + node.type().fields().get(field).name();
  }

  private static void say(
      ParsedNode node, String in, Map<ParsedNode, Integer> seen, List<String> said) {
    Integer before = seen.putIfAbsent(node, seen.size());
    said.add(in + node + (before == null ? "" : " again " + before));
    if (before != null) {
      return;
    }
    for (FieldDefinition field : node.type().fields()) {
      Object value = node.value(field.index());
      String name = in + "  " + field.name();
      if (value instanceof ParsedNode child) {
        say(child, name + " ", seen, said);
      } else if (value instanceof List<?> children) {
        children.forEach(child -> say((ParsedNode) child, name + " ", seen, said));
      } else if (field.name().equals("url") && node.type().field("sourceCode").isPresent()) {
        int source = node.type().indexOf("sourceCode");
        Object code = node.value(source);
        said.addAll(program(List.of((String[]) value), code == null ? "" : code.toString()));
      } else if (!field.name().equals("sourceCode")
          && !Objects.deepEquals(value, field.defaultValue())) {
        said.add(name + " " + Arrays.deepToString(new Object[] {value}));
      }
    }
  }

  /** Returns urls and the program, which VRML has as the last of the urls. */
  private static List<String> program(List<String> urls, String text) {
    String last = urls.isEmpty() ? "" : urls.get(urls.size() - 1);
    boolean inline = text.isBlank() && (last.matches(LANGUAGE + ".*") || shader(last));
    String code =
        inline ? last.startsWith("data:") ? last.substring(16).replace("%25", "%") : last : text;
    List<String> said = new ArrayList<>(urls.subList(0, urls.size() - (inline ? 1 : 0)));
    said.add("code " + code.replaceFirst(LANGUAGE, "").strip());
    return said;
  }

  private static boolean shader(String url) {
    return url.startsWith("data:text/plain,") && !url.replace("%25", "").contains("%");
  }

  /** Returns the lines of a document as its author wrote it, with its prototypes and comments. */
  List<String> document(XmlDocument document) {
    List<String> said = new ArrayList<>();
    document.root().ifPresent(root -> say(root, null, "", said));
    document.comments().stream()
        .flatMap(comment -> comment.text().lines())
        .map(line -> line.replaceAll("[-\\s]+", " ").strip())
        .filter(line -> !line.isEmpty())
        .sorted()
        .forEach(line -> said.add("# " + line));
    return said;
  }

  private void say(DocumentElement element, NodeType parent, String in, List<String> said) {
    NodeType type = catalogue.find(element.name()).orElse(null);
    String name = element.name();
    if (element.use().isPresent()) {
      said.add(in + name + " USE " + element.use().get());
      return;
    }
    said.add(in + name + element.def().map(def -> " DEF " + def).orElse(""));
    String inner = in + "  ";
    Map<String, String> values = new TreeMap<>();
    for (DocumentAttribute attribute : element.attributes()) {
      switch (attribute.name()) {
        case "", "DEF", "USE", "containerField" -> {}
        default -> values.put(spelling(type, attribute.name()), value(element, type, attribute));
      }
    }
    if (type != null && type.field("sourceCode").isPresent()) {
      String urls = element.attribute("url").map(DocumentAttribute::lines).orElse("");
      Object parsed = new FieldParser().parse(FieldType.MFString, urls).value();
      values.remove("url");
      List<String> all =
          program(List.of((String[]) Objects.requireNonNull(parsed)), element.text());
      values.put("program", all.toString());
    }
    if (name.equals("X3D")) {
      values.remove("version");
    }
    if (name.equals("meta")) {
      values.putIfAbsent("name", "");
      values.putIfAbsent("content", "");
    }
    values.computeIfPresent("value", (key, text) -> text.equalsIgnoreCase("NULL") ? null : text);
    if (name.equals("ExternProtoDeclare")) {
      values.putIfAbsent("url", value(""));
    }
    if (name.equals("field")) {
      values.computeIfAbsent("value", key -> zero(element));
    }
    values.forEach((key, value) -> said.add(inner + key + " " + value));
    Map<String, List<DocumentElement>> groups = new TreeMap<>();
    for (DocumentElement child : element.children()) {
      boolean empty = child.name().matches("ProtoInterface|IS") && child.children().isEmpty();
      List<DocumentElement> group =
          groups.computeIfAbsent(empty ? "" : place(child, type), key -> new ArrayList<>());
      boolean repeated =
          child.name().equals("field")
              && group.stream().anyMatch(other -> other.text("name").equals(child.text("name")));
      if (!repeated) {
        group.add(child);
      }
    }
    groups.remove("");
    for (Map.Entry<String, List<DocumentElement>> group : groups.entrySet()) {
      said.add(in + " " + group.getKey());
      if (group.getKey().equals("IS")) {
        group.getValue().stream()
            .map(DocumentElement::children)
            .flatMap(Collection::stream)
            .map(c -> inner + c.text("nodeField") + " IS " + c.text("protoField"))
            .sorted()
            .forEach(said::add);
      } else {
        group.getValue().forEach(child -> say(child, type, inner, said));
      }
    }
  }

  /** Returns the value of a field that has none, which VRML writes. */
  private static String zero(DocumentElement field) {
    boolean valued =
        field.text("accessType").filter(access -> access.matches("init.*|inputOutput")).isPresent()
            && field.parent().filter(p -> p.name().startsWith("Extern")).isEmpty()
            && field.text("type").filter(type -> !type.endsWith("Node")).isPresent();
    if (!valued) {
      return null;
    }
    FieldType type = FieldType.valueOf(field.text("type").orElseThrow());
    String text = type == FieldType.SFString ? "" : FieldValueFormatter.of(type.zero());
    return value(text);
  }

  private static String spelling(NodeType type, String attribute) {
    return attribute.equals("exportedDEF") ? "importedDEF" : LegacyFieldNames.now(type, attribute);
  }

  /** Returns the field that contains a child, or what kind of statement it is. */
  private String place(DocumentElement child, NodeType parent) {
    NodeType type = catalogue.find(child.name()).orElse(null);
    boolean instance = child.name().equals("ProtoInstance");
    if (type == null && !instance) {
      return child.name().equals("head") ? " head" : child.name();
    }
    if (parent == null) {
      return "nodes";
    }
    String wanted = child.text("containerField").orElse(null);
    if (type == null) {
      return "-" + (wanted == null ? "children" : wanted);
    }
    return "-"
        + Stream.of(
                ContainerFieldRules.wanted(parent, type, wanted),
                ContainerFieldRules.wanted(parent, type, null),
                ContainerFieldRules.fitting(parent, type).stream().findFirst())
            .flatMap(Optional::stream)
            .findFirst()
            .map(FieldDefinition::name)
            .orElse("nowhere");
  }

  private static String value(DocumentElement element, NodeType type, DocumentAttribute attribute) {
    FieldDefinition field =
        type == null ? null : type.field(LegacyFieldNames.now(type, attribute.name())).orElse(null);
    if (field != null && !field.type().isNode()) {
      return Arrays.deepToString(new Object[] {attribute.value(field.type())});
    }
    boolean typed =
        switch (element.name() + " " + attribute.name()) {
          case "field value",
              "fieldValue value",
              "unit conversionFactor",
              "component level",
              "ExternProtoDeclare url" ->
              true;
          default -> false;
        };
    return typed ? value(attribute.text()) : attribute.text();
  }

  private static String value(String text) {
    FieldParser parser = new FieldParser();
    FieldParser.Parsed whole = parser.parse(FieldType.MFInt32, text);
    if (whole.flaws().isEmpty()) {
      return Arrays.toString(Arrays.stream((int[]) whole.value()).asDoubleStream().toArray());
    }
    FieldParser.Parsed numbers = parser.parse(FieldType.MFDouble, text);
    if (numbers.flaws().isEmpty()) {
      // "-0" of a list that another encoding writes in whole numbers is 0
      return Arrays.toString(Arrays.stream((double[]) numbers.value()).map(x -> x + 0.0).toArray());
    }
    FieldParser.Parsed flags = parser.parse(FieldType.MFBool, text);
    if (flags.flaws().isEmpty()) {
      return Arrays.deepToString(new Object[] {flags.value()});
    }
    return text.stripLeading().startsWith("\"")
        ? Arrays.deepToString(new Object[] {parser.parse(FieldType.MFString, text).value()})
        : text.strip();
  }
}
