package org.selectiverenderer.x3d.write;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.LegacyFieldNames;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.SceneEncoding;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.write.SceneItem.Value;

/**
 * Converts the attributes of elements to typed values. Invalid ones, and those that the encoding
 * cannot hold, are reported and left out. For one document.
 */
final class ValueBuilder {
  private static final Pattern BETWEEN = Pattern.compile("[\\s,]+");
  private static final Pattern CONTROLS = Pattern.compile("[\\x00-\\x08\\x0b\\x0c\\x0e-\\x1f]");
  private static final Pattern VERSION = Pattern.compile("\\d+\\.\\d+");

  private final NodeCatalogue catalogue;
  private final boolean json;
  private final boolean classic;
  private final CharacterRules characters;
  private final ProblemCollector problems;
  private final @Nullable VrmlNames names;
  private final InterfaceDefaults defaults;
  private final Set<String> toldOnce = new HashSet<>();

  ValueBuilder(
      XmlDocument document,
      NodeCatalogue catalogue,
      SceneFormat format,
      CharacterRules characters,
      ProblemCollector problems) {
    this.catalogue = catalogue;
    defaults = new InterfaceDefaults(catalogue);
    json = document.encoding() == SceneEncoding.JSON;
    classic = format == SceneFormat.CLASSIC;
    this.characters = characters;
    this.problems = problems;
    names = classic ? VrmlNames.of(document, catalogue, problems) : null;
  }

  /** Returns the name to write for the DEF or USE of an element. */
  String name(DocumentElement element, String attribute, String name) {
    DocumentAttribute written = element.attribute(attribute).orElse(null);
    if (written == null) {
      return name;
    }
    if (name.isEmpty()) {
      leftOut(written, attribute + " is an empty name; it is left out");
      return "";
    }
    return names == null ? string(written) : names.written(element, written);
  }

  /**
   * Returns the values of an element.
   *
   * @param notes receives comments with what the encoding has no other place for
   */
  List<Value> of(
      DocumentElement element,
      @Nullable NodeType type,
      PrototypeScope known,
      List<SceneItem> notes) {
    List<Value> values = new ArrayList<>();
    for (DocumentAttribute attribute : element.attributes()) {
      switch (attribute.name()) {
        case "DEF", "USE", "containerField", "" -> {
          // not values
        }
        default -> {
          Value value =
              // FontStyle and others have a field "style", which is not HTML's
              StatementGrammar.ofHtml(attribute.name())
                      && (type == null || type.field(attribute.name()).isEmpty())
                  ? ofHtml(attribute)
                  : type == null
                      ? ofStatement(element, attribute, known, notes)
                      : ofNode(type, attribute);
          if (value != null) {
            // a field given twice, which VRML's grammar allows, has its last value
            values.removeIf(earlier -> earlier.name().equals(value.name()));
            values.add(value);
          }
        }
      }
    }
    complete(element, values);
    return values;
  }

  private @Nullable Value ofHtml(DocumentAttribute attribute) {
    if (!classic) {
      return new Value(attribute.name(), FieldType.SFString, string(attribute));
    }
    if (toldOnce.add(attribute.name())) {
      problems.warning(
          attribute.location(),
          "ClassicVRML has no %s for elements; this one and all others are left out"
              .formatted(attribute.name()));
    }
    return null;
  }

  private @Nullable Value ofStatement(
      DocumentElement element,
      DocumentAttribute attribute,
      PrototypeScope known,
      List<SceneItem> notes) {
    String statement = element.name();
    String name = attribute.name();
    if (statement.equals("IMPORT") && name.equals("exportedDEF")) {
      name = "importedDEF"; // X3D 3.0 calls it so in its XML encoding.
    } else if (statement.equals("IMPORT")
        && name.equals("importedDEF")
        && element.text("exportedDEF").isPresent()) {
      leftOut(attribute, "exportedDEF is given, too; importedDEF is left out");
      return null;
    }
    if (!StatementGrammar.has(statement, name)) {
      leftOut(attribute, statement + " has no attribute " + name + "; it is left out");
      return null;
    }
    if (classic && !StatementGrammar.inClassicVrml(statement, name)) {
      String words = name + ": " + string(attribute);
      problems.warning(
          attribute.location(), "ClassicVRML has no " + name + "; it becomes a comment");
      notes.add(new SceneItem.Words(words));
      return null;
    }
    boolean valued = statement.equals("field") || statement.equals("fieldValue");
    if (valued && name.equals("value")) {
      return ofField(element, attribute, StatementGrammar.type(element, name, known));
    }
    FieldType type = StatementGrammar.type(element, name, known);
    if (names != null && type == FieldType.SFString) {
      String written = names.written(element, attribute);
      return new Value(name, type, written.equals(attribute.text()) ? string(attribute) : written);
    }
    return typed(name, attribute, type);
  }

  private @Nullable Value ofField(
      DocumentElement field, DocumentAttribute attribute, @Nullable FieldType type) {
    boolean declares = field.name().equals("field");
    AccessType access = declares ? StatementGrammar.access(field) : AccessType.INPUT_OUTPUT;
    boolean extern = field.parent().filter(p -> p.name().equals("ExternProtoDeclare")).isPresent();
    String text = attribute.text().strip();
    if (extern || access == null || !access.initialisable()) {
      if (!text.isEmpty()) {
        leftOut(attribute, "this field cannot have a value in a file; it is left out");
      }
      return null;
    }
    if (type != null && type.isNode()) {
      if (!text.isEmpty() && !text.equalsIgnoreCase("NULL")) {
        leftOut(attribute, "the value of this field must be a child element; it is left out");
      }
      return null;
    }
    return typed(attribute.name(), attribute, type);
  }

  private @Nullable Value ofNode(NodeType type, DocumentAttribute attribute) {
    String name = attribute.name();
    FieldDefinition field = type.field(LegacyFieldNames.now(type, name)).orElse(null);
    if (field == null) {
      leftOut(attribute, type + " has no field " + name + "; it is left out");
      return null;
    }
    if (field.type().isNode() || !field.access().initialisable()) {
      leftOut(attribute, name + " of " + type + " cannot have a value in a file; it is left out");
      return null;
    }
    if (name.equals("url") && type.is("X3DScriptNode")) {
      return program(attribute);
    }
    return typed(field.name(), attribute, field.type());
  }

  /** Returns the urls of a Script, of which a program has its line ends. */
  private Value program(DocumentAttribute attribute) {
    tell(attribute, FieldType.MFString);
    String text = attribute.lines();
    String urls = FieldValueFormatter.strings(InlineCodeConverter.strings(text));
    return new Value(
        attribute.name(), FieldType.MFString, characters.written(urls, attribute::location, false));
  }

  /** Reports what is wrong in the document. */
  private void leftOut(DocumentAttribute attribute, String why) {
    problems.error(attribute.location(), why);
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

  private String string(DocumentAttribute attribute) {
    return characters.written(attribute.text(), attribute::location, false);
  }

  /**
   * Returns the text as written if it is valid for the type, else the usable part of it; null,
   * after a message, if there is none.
   */
  private @Nullable Value typed(
      String name, DocumentAttribute attribute, @Nullable FieldType type) {
    if (type == null || type == FieldType.SFString) {
      return new Value(name, type, string(attribute));
    }
    tell(attribute, type);
    Object value = attribute.value(type);
    if (value == null) {
      return null;
    }
    if (type.kind() == FieldType.Kind.STRING) {
      String strings = FieldValueFormatter.of(value);
      return new Value(name, type, characters.written(strings, attribute::location, false));
    }
    boolean asItIs = attribute.flaws(type).isEmpty();
    return new Value(
        name, type, asItIs ? numbers(attribute.text()) : FieldValueFormatter.of(value));
  }

  /** Removes the commas of JSON, which unlike those of an author do not separate tuples. */
  private String numbers(String written) {
    String text = CONTROLS.matcher(written).replaceAll(" ").strip();
    return json
        ? BETWEEN.matcher(text).replaceAll(b -> b.group().indexOf('\n') < 0 ? " " : "\n")
        : text;
  }

  /** Adds what the encoding needs and the document does not say. */
  private void complete(DocumentElement element, List<Value> values) {
    if (!classic) {
      return;
    }
    switch (element.name()) {
      case "X3D" -> version(element, values);
      case "field" ->
          initial(element)
              .ifPresent(
                  value -> {
                    if (values.stream().noneMatch(given -> given.name().equals("value"))) {
                      values.add(value);
                    }
                  });
      default -> {
        // nothing is needed
      }
    }
  }

  private void version(DocumentElement root, List<Value> values) {
    Optional<String> given = root.text("version").map(String::strip);
    if (given.filter(text -> VERSION.matcher(text).matches()).isEmpty()) {
      values.removeIf(value -> value.name().equals("version"));
      problems.warning(
          root.location(),
          "ClassicVRML needs a version such as 4.0, which the X3D element does not have; 4.0 is"
              + " written");
    }
  }

  /** Returns the value of a declared field without one, which VRML needs. */
  private Optional<Value> initial(DocumentElement field) {
    FieldType type = PrototypeScope.declaredType(field);
    AccessType access = StatementGrammar.access(field);
    boolean extern = field.parent().filter(p -> p.name().equals("ExternProtoDeclare")).isPresent();
    if (type == null || type.isNode() || extern || access == null || !access.initialisable()) {
      return Optional.empty();
    }
    String text =
        defaults
            .of(field, type)
            .orElse(
                type == FieldType.SFString
                    ? ""
                    : FieldValueFormatter.of(Objects.requireNonNull(type.zero())));
    return Optional.of(new Value("value", type, text));
  }
}
