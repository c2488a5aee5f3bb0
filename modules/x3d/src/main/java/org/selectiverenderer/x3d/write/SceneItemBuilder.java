package org.selectiverenderer.x3d.write;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.x3d.catalogue.ContainerFieldRules;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.LegacyFieldNames;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.SceneEncoding;
import org.selectiverenderer.x3d.source.StatementNames;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.write.SceneItem.Element;
import org.selectiverenderer.x3d.write.SceneItem.Place;
import org.selectiverenderer.x3d.write.SceneItem.Value;

/**
 * Converts the elements of a document to items for writing: determines the type of each value, the
 * field of each node, and the positions of comments. Invalid content is reported and left out. For
 * one document.
 */
final class SceneItemBuilder {
  private static final Pattern BETWEEN = Pattern.compile("[\\s,]+");

  private final NodeCatalogue catalogue;
  private final boolean json;
  private final ProblemCollector problems;
  private final List<XmlDocument.Comment> comments;
  private final Map<String, DocumentElement> instances = new HashMap<>();
  private int passed;

  private SceneItemBuilder(
      XmlDocument document, NodeCatalogue catalogue, ProblemCollector problems) {
    this.catalogue = catalogue;
    json = document.encoding() == SceneEncoding.JSON;
    this.problems = problems;
    comments = new ArrayList<>(document.comments());
    comments.sort(Comparator.comparingInt(XmlDocument.Comment::offset));
  }

  /** Returns the document's root element with the comments around it. */
  static List<SceneItem> of(
      XmlDocument document, NodeCatalogue catalogue, ProblemCollector problems) {
    SceneItemBuilder items = new SceneItemBuilder(document, catalogue, problems);
    List<SceneItem> all = new ArrayList<>();
    DocumentElement root = document.root().orElse(null);
    if (root != null) {
      items.comments(root.start(), all);
      items.element(root, null, new PrototypeScope(null)).ifPresent(all::add);
      items.comments(Integer.MAX_VALUE, all);
    }
    return all;
  }

  private void comments(int before, List<SceneItem> into) {
    while (passed < comments.size() && comments.get(passed).offset() < before) {
      into.add(new SceneItem.Words(comments.get(passed++).text().strip()));
    }
  }

  private Optional<Element> element(
      DocumentElement element, @Nullable NodeType parent, PrototypeScope known) {
    String name = element.name();
    NodeType type = catalogue.find(name).orElse(null);
    if (type == null && !StatementNames.is(name)) {
      leftOut(element.location(), "unknown element " + name + "; it and its children are left out");
      skip(element);
      return Optional.empty();
    }
    boolean instance = name.equals("ProtoInstance");
    if (instance) {
      element.def().ifPresent(def -> instances.put(def, element));
    }
    DocumentElement named = element.use().map(instances::get).orElse(element);
    String prototype = named.text("name").orElse("");
    NodeType stands = instance ? known.node(prototype, catalogue) : type;
    Place place = SceneItem.NOWHERE;
    if (parent != null && (instance || type != null)) {
      Place found = place(element, parent, stands, instance);
      if (found == null) {
        leftOut(
            element.location(),
            "%s is not allowed in %s; it is left out"
                .formatted(SpellingSuggester.one(name), SpellingSuggester.one(parent.name())));
        skip(element);
        return Optional.empty();
      }
      place = found;
    }
    if (name.equals("fieldValue")) {
      String instanceOf = element.parent().flatMap(around -> around.text("name")).orElse("");
      FieldType field = known.type(instanceOf, element.text("name").orElse(""));
      boolean several = field == null ? element.children().size() > 1 : field.multiple();
      place = new Place("", several, true);
    }
    boolean declares = name.equals("ProtoDeclare") || name.equals("ExternProtoDeclare");
    PrototypeScope inner = name.equals("ProtoDeclare") ? new PrototypeScope(known) : known;
    List<Value> values = new ArrayList<>();
    for (DocumentAttribute attribute : element.attributes()) {
      // a field given twice, which VRML's grammar allows, has its last value
      values.removeIf(value -> value.name().equals(attribute.name()));
      value(element, type, attribute, known).ifPresent(values::add);
    }
    List<SceneItem> items = new ArrayList<>();
    for (DocumentElement child : element.children()) {
      comments(child.start(), items);
      element(child, type, inner).ifPresent(items::add);
    }
    comments(element.end() < 0 ? Integer.MAX_VALUE : element.end(), items);
    if (declares) {
      known.declare(element);
    }
    boolean code = type != null && type.field("sourceCode").isPresent();
    String source = code ? InlineCodeConverter.of(type, values, element.text()) : "";
    String def = element.def().orElse("");
    String use = element.use().orElse("");
    return Optional.of(new Element(name, type, def, use, place, values, items, source));
  }

  /** Leaves out the comments in an element that is left out. */
  private void skip(DocumentElement element) {
    comments(element.end() < 0 ? Integer.MAX_VALUE : element.end(), new ArrayList<>());
  }

  private void leftOut(SourceLocation at, String why) {
    problems.warning(at, why);
  }

  private static @Nullable Place place(
      DocumentElement child, NodeType parent, @Nullable NodeType type, boolean instance) {
    String wanted = child.text("containerField").orElse(null);
    FieldDefinition field =
        type == null
            ? parent.field(wanted == null ? "children" : wanted).orElse(null)
            : ContainerFieldRules.wanted(parent, type, wanted)
                .or(() -> ContainerFieldRules.wanted(parent, type, null))
                .or(() -> ContainerFieldRules.fitting(parent, type).stream().findFirst())
                .orElse(null);
    if (field == null || !field.type().isNode()) {
      return null;
    }
    // readers differ in the default containerField of an instance, except for children
    boolean usual =
        instance || type == null
            ? field.name().equals("children")
            : ContainerFieldRules.isAlwaysDefault(type, field.name());
    return new Place(field.name(), field.type().multiple(), usual);
  }

  private Optional<Value> value(
      DocumentElement element,
      @Nullable NodeType type,
      DocumentAttribute attribute,
      PrototypeScope known) {
    String name = attribute.name();
    switch (name) {
      case "DEF", "USE", "containerField", "" -> {
        return Optional.empty();
      }
      default -> {
        // a value
      }
    }
    if (type == null) {
      if (element.name().equals("IMPORT") && name.equals("exportedDEF")) {
        name = "importedDEF"; // X3D 3.0 calls it so in its XML encoding.
      }
      return Optional.of(typed(name, attribute, StatementTypes.type(element, name, known)));
    }
    FieldDefinition field = type.field(LegacyFieldNames.now(type, name)).orElse(null);
    if (field == null) {
      if (name.equals("class") || name.equals("id") || name.equals("style")) {
        return Optional.of(new Value(name, null, attribute.text())); // XML's own
      }
      leftOut(attribute.location(), type + " has no field " + name + "; it is left out");
      return Optional.empty();
    }
    if (field.type().isNode() || !field.access().initialisable()) {
      leftOut(
          attribute.location(),
          name + " of " + type + " cannot have a value in a file; it is left out");
      return Optional.empty();
    }
    if (attribute.value(field.type()) == null) {
      tell(attribute, field.type());
      return Optional.empty();
    }
    return Optional.of(typed(field.name(), attribute, field.type()));
  }

  private void tell(DocumentAttribute attribute, FieldType type) {
    for (FieldParser.Flaw flaw : attribute.flaws(type)) {
      problems.add(
          new Problem(
              flaw.severity(),
              attribute.location(flaw.offset()),
              attribute.name() + ": " + flaw.message()));
    }
  }

  /** Returns the text as written if it is valid for the type, else the usable part of it. */
  private Value typed(String name, DocumentAttribute attribute, @Nullable FieldType type) {
    if (type == null || type.isNode() || type == FieldType.SFString) {
      return new Value(name, type, attribute.text());
    }
    Object value = attribute.value(type);
    tell(attribute, type);
    boolean asItIs = attribute.flaws(type).isEmpty() && type.kind() != FieldType.Kind.STRING;
    String text = value == null || asItIs ? plain(attribute.text()) : FieldValueFormatter.of(value);
    return new Value(name, type, value == null ? "" : text);
  }

  /** Removes the commas of JSON, which unlike those of an author do not separate tuples. */
  private String plain(String written) {
    String text = written.strip();
    return json ? BETWEEN.matcher(text).replaceAll(" ") : text;
  }

  /** Determines the types of the attributes of statements. */
  private static final class StatementTypes {
    private StatementTypes() {}

    /** Returns the type of an attribute; null if unknown. */
    static @Nullable FieldType type(
        DocumentElement element, String attribute, PrototypeScope known) {
      return switch (element.name() + " " + attribute) {
        case "component level" -> FieldType.SFInt32;
        case "unit conversionFactor" -> FieldType.SFDouble;
        case "ExternProtoDeclare url" -> FieldType.MFString;
        case "field value" -> PrototypeScope.type(element);
        case "fieldValue value" ->
            element
                .parent()
                .flatMap(instance -> instance.text("name"))
                .map(name -> known.type(name, element.text("name").orElse("")))
                .orElse(null);
        default -> FieldType.SFString;
      };
    }
  }
}
