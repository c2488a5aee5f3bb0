package org.selectiverenderer.x3d.write;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.XmlDocument;

/**
 * The names of a document as ClassicVRML can write them (ISO/IEC 19776-2, 4.3.2): in others, the
 * characters that VRML forbids become underscores, and different names remain different. Each name
 * that changes is told once.
 */
final class VrmlNames {
  private static final String FORBIDDEN = "\"#',.[\\]{}\u007f";
  private static final String FORBIDDEN_FIRST = "0123456789+-";

  /** The words of the grammar. */
  private static final Set<String> WORDS =
      Set.of(
          "DEF",
          "USE",
          "NULL",
          "TRUE",
          "FALSE",
          "true",
          "false",
          "IS",
          "TO",
          "AS",
          "ROUTE",
          "PROTO",
          "EXTERNPROTO",
          "IMPORT",
          "EXPORT",
          "PROFILE",
          "COMPONENT",
          "META",
          "UNIT",
          "field",
          "eventIn",
          "eventOut",
          "exposedField",
          "initializeOnly",
          "inputOnly",
          "outputOnly",
          "inputOutput");

  /** The words that programs write, and readers take, for numbers, in any letter case. */
  private static final Set<String> NUMBERS = Set.of("nan", "inf", "infinity");

  private static final String SET = "set_";
  private static final String CHANGED = "_changed";

  private final ProblemCollector problems;
  private final Names nodes = new Names(name -> false);
  private final Names fields = new Names(name -> false);
  private final Names prototypes;

  /** The names of one kind. */
  private static final class Names {
    private final Predicate<String> reserved;
    private final Map<String, String> written = new HashMap<>();
    private final Set<String> taken = new HashSet<>();

    /** Counts how often a name that ClassicVRML can write has been made unique by a number. */
    private final Map<String, Integer> numbers = new HashMap<>();

    Names(Predicate<String> reserved) {
      this.reserved = reserved;
    }

    boolean valid(String name) {
      return !name.isEmpty()
          && FORBIDDEN_FIRST.indexOf(name.charAt(0)) < 0
          && !WORDS.contains(name)
          && !NUMBERS.contains(name.toLowerCase(Locale.ROOT))
          && !reserved.test(name)
          && name.chars().noneMatch(VrmlNames::ends);
    }

    private String make(String name) {
      StringBuilder text = new StringBuilder();
      boolean first = !name.isEmpty() && FORBIDDEN_FIRST.indexOf(name.charAt(0)) >= 0;
      text.append(first ? "_" : "");
      name.chars().forEach(c -> text.append(ends(c) ? '_' : (char) c));
      String plain = text.isEmpty() ? "_" : text.toString();
      String unique = valid(plain) ? plain : plain + "_";
      while (!taken.add(unique)) {
        unique = plain + "_" + (1 + numbers.merge(plain, 1, Integer::sum));
      }
      return unique;
    }
  }

  private VrmlNames(NodeCatalogue catalogue, ProblemCollector problems) {
    this.problems = problems;
    prototypes = new Names(name -> catalogue.find(name).isPresent());
  }

  /** Collects the names of a document. */
  static VrmlNames of(XmlDocument document, NodeCatalogue catalogue, ProblemCollector problems) {
    VrmlNames names = new VrmlNames(catalogue, problems);
    for (DocumentElement element : document.elements()) {
      element.attributes().stream()
          .filter(attribute -> names.kind(element, attribute).isPresent())
          .forEach(attribute -> names.add(element, attribute));
    }
    return names;
  }

  private void add(DocumentElement element, DocumentAttribute attribute) {
    Names names = kind(element, attribute).orElseThrow();
    String name = attribute.text();
    if (names.valid(name)) {
      names.taken.add(name); // Others must not become what this one is called.
    }
  }

  private Optional<Names> kind(DocumentElement element, DocumentAttribute attribute) {
    return switch (attribute.name()) {
      case "DEF", "USE", "fromNode", "toNode", "inlineDEF", "importedDEF", "exportedDEF" ->
          Optional.of(nodes);
      case "localDEF", "AS" -> Optional.of(nodes);
      case "fromField", "toField", "nodeField", "protoField" -> Optional.of(fields);
      case "name" ->
          switch (element.name()) {
            case "ProtoDeclare", "ExternProtoDeclare", "ProtoInstance" -> Optional.of(prototypes);
            case "field", "fieldValue" -> Optional.of(fields);
            default -> Optional.empty();
          };
      default -> Optional.empty();
    };
  }

  /** Returns the name to write for that in an attribute; other attributes are not changed. */
  String written(DocumentElement element, DocumentAttribute attribute) {
    String text = attribute.text();
    boolean word =
        switch (element.name() + " " + attribute.name()) {
          case "X3D profile", "component name", "unit category", "unit name" -> true;
          default -> false;
        };
    Optional<Names> names = word ? Optional.of(fields) : kind(element, attribute);
    if (names.isEmpty()) {
      return text;
    }
    if (attribute.name().endsWith("Field")) {
      Optional<String> event = eventOfRenamed(text);
      if (event.isPresent()) {
        return event.get();
      }
    }
    if (names.get().valid(text)) {
      return text;
    }
    String known = names.get().written.get(text);
    if (known != null) {
      return known;
    }
    String written = names.get().make(text);
    names.get().written.put(text, written);
    problems.warning(
        attribute.location(),
        "ClassicVRML cannot have the name "
            + FieldTokenizer.quote(text)
            + "; it becomes "
            + FieldTokenizer.quote(written));
    return written;
  }

  /** Returns the name of an event of a field that is called otherwise now. */
  private Optional<String> eventOfRenamed(String event) {
    if (event.startsWith(SET)) {
      String field = fields.written.get(event.substring(SET.length()));
      return Optional.ofNullable(field).map(name -> SET + name);
    }
    if (event.endsWith(CHANGED)) {
      String field = fields.written.get(event.substring(0, event.length() - CHANGED.length()));
      return Optional.ofNullable(field).map(name -> name + CHANGED);
    }
    return Optional.empty();
  }

  private static boolean ends(int c) {
    return c <= ' ' || FORBIDDEN.indexOf(c) >= 0;
  }
}
